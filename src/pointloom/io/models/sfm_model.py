"""Structure-from-motion models: posed images, cameras and sparse points."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera_models import CameraModel
from ...cameras.trajectory import Trajectory
from ...core.attribute_hints import nearest_name
from ...core.checks import (
    check_list,
    check_name,
    check_numeric,
    check_positive,
    check_rigid,
    check_rows,
    check_shape,
    shown,
)
from ...core.devices import DeviceLike
from ...core.dropped_results import returns_new
from ...kernels.linear_algebra import cube_root, det, matmul
from ...pcd.cloud import PointCloud

_NO_POINTS: NDArray[np.float64] = np.zeros((0, 3))


@dataclasses.dataclass(frozen=True, eq=False)
class SfmModel:
    """Posed images and sparse points, read-only.

    Args:
        names: Image names, unique. Sorted, with all per-image data.
        cameras: One per image. Images may share a camera.
        T_camera_world: Poses, world to camera, shape (n, 4, 4). Rigid [unit of the model].
        points: Shape (m, 3) [unit of the model].
        colors: 8-bit, shape (m, 3). None for black.
        errors: Mean reprojection error, shape (m,) [px]. NaN or None if unknown.
        observations: Shape (k, 2), sorted: (index of the image, index of the point).
        pixels: Position of each observation in the distorted image, shape (k, 2) [px]. Pixel centers are integers.
        left_out: Images without a pose, with the reason.

    Attributes:
        names, cameras, T_camera_world, points, colors, errors, observations, pixels, left_out: As above. Arrays of
            float64, int64 and uint8.

    Raises:
        TypeError: Wrong types.
        ValueError: Shapes that do not match, duplicate names, poses that are not rigid, non-finite numbers, or an
            observation of a missing image or point.

    Notes:
        Structure from motion has an arbitrary scale. See `scaled`, `transform` and `registration.similarity`.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> poses = np.tile(np.eye(4), (2, 1, 1))
        >>> poses[1, 0, 3] = -1.0
        >>> loom.SfmModel(["b.png", "a.png"], [camera] * 2, poses)
        SfmModel(2 images, 1 camera, 0 points, 0 observations)
    """

    names: tuple[str, ...]
    cameras: tuple[CameraModel, ...]
    T_camera_world: NDArray[np.float64]
    points: NDArray[np.float64] = dataclasses.field(default_factory=lambda: _NO_POINTS)
    colors: NDArray[np.uint8] = None  # pyright: ignore[reportAssignmentType]
    errors: NDArray[np.float64] = None  # pyright: ignore[reportAssignmentType]
    observations: NDArray[np.int64] = None  # pyright: ignore[reportAssignmentType]
    pixels: NDArray[np.float64] = None  # pyright: ignore[reportAssignmentType]
    left_out: tuple[str, ...] = ()

    def __post_init__(self):
        names = [check_name("names", name) for name in check_list("names", self.names, "names")]
        order = sorted(range(len(names)), key=names.__getitem__)
        _check_names([names[i] for i in order])
        cameras = check_list("cameras", self.cameras, "CameraModels")
        if len(cameras) != len(names):
            raise ValueError(f"cameras: expected {len(names)}, one per image, got {len(cameras)}")
        for camera in cameras:
            if not isinstance(camera, CameraModel):
                raise TypeError(f"cameras: expected CameraModels, got {type(camera).__name__}")
        poses = check_shape("T_camera_world", _stacked(self.T_camera_world), (len(names), 4, 4))
        points = _check_points(self.points)
        observations, pixels = _check_observations(self.observations, self.pixels, len(names), len(points))
        ranks = np.empty(len(names), np.int64)
        ranks[order] = np.arange(len(names))
        observations[:, 0] = ranks[observations[:, 0]]
        observations, pixels = _sorted(observations, pixels, len(points))
        fields: dict[str, Any] = {
            "names": tuple(names[i] for i in order),
            "cameras": tuple(cameras[i] for i in order),
            "T_camera_world": _rigid(poses)[order] if names else np.zeros((0, 4, 4)),
            "points": points,
            "colors": _check_colors(self.colors, len(points)),
            "errors": _check_errors(self.errors, len(points)),
            "observations": observations,
            "pixels": pixels,
            "left_out": tuple(check_name("left_out", line) for line in check_list("left_out", self.left_out, "lines")),
        }
        for name, value in fields.items():
            if isinstance(value, np.ndarray):
                value.flags.writeable = False
            object.__setattr__(self, name, value)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        cameras = len(set(self.cameras))
        return (
            f"SfmModel({len(self)} image{'s' * (len(self) != 1)}, {cameras} camera{'s' * (cameras != 1)}, "
            f"{len(self.points)} points, {len(self.observations)} observations)"
        )

    @property
    def centers(self) -> NDArray[np.float64]:
        """Camera positions in the world, shape (n, 3) [unit of the model]. Read-only."""
        return self._centers

    @cached_property
    def _centers(self) -> NDArray[np.float64]:
        T = self.T_camera_world
        centers = -np.einsum("nji,nj->ni", T[:, :3, :3], T[:, :3, 3]) + 0.0  # no minus zero
        centers.flags.writeable = False
        return centers

    @property
    def T_world_camera(self) -> NDArray[np.float64]:
        """Poses, camera to world, shape (n, 4, 4)."""
        inverse = np.tile(np.eye(4), (len(self), 1, 1))
        inverse[:, :3, :3] = self.T_camera_world[:, :3, :3].transpose(0, 2, 1)
        inverse[:, :3, 3] = self.centers
        return inverse

    @property
    def view_counts(self) -> NDArray[np.int64]:
        """Number of observations of each point, shape (m,). Read-only."""
        return self._view_counts

    @cached_property
    def _view_counts(self) -> NDArray[np.int64]:
        counts = np.bincount(self.observations[:, 1], minlength=len(self.points))
        counts.flags.writeable = False
        return counts

    def index_of(self, name: str) -> int:
        """The index of an image.

        Raises:
            TypeError: No string.
            KeyError: No image of this name.
        """
        index = self._index_by_name.get(check_name("name", name))
        if index is None:
            raise KeyError(f"name: no image {shown(name)}{nearest_name(name, self.names)}")
        return index

    @cached_property
    def _index_by_name(self) -> dict[str, int]:
        return {name: i for i, name in enumerate(self.names)}

    @returns_new
    def transform(self, transformation: ArrayLike) -> SfmModel:
        """Apply a similarity transformation to the model.

        Args:
            transformation: T_new_old, shape (4, 4): a positive scale times a rotation, and a translation.

        Returns:
            The transformed model. Poses stay rigid: the scale is applied to their translations.

        Raises:
            TypeError: Not numbers.
            ValueError: Not a similarity: shear, mirror, NaN or a scale of zero.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
            >>> model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None], points=[[0, 0, 2.0]])
            >>> T = np.diag([3.0, 3.0, 3.0, 1.0])
            >>> T[:3, 3] = 1, 0, 0
            >>> moved = model.transform(T)
            >>> moved.centers.tolist(), moved.points.tolist()
            ([[1.0, 0.0, 0.0]], [[1.0, 0.0, 6.0]])
        """
        R, t, scale = _check_similarity(transformation)
        poses = self.T_camera_world.copy()
        poses[:, :3, :3] = matmul(poses[:, :3, :3], R.T)
        poses[:, :3, 3] = -np.einsum("nij,nj->ni", poses[:, :3, :3], matmul(scale * self.centers, R.T) + t)
        return dataclasses.replace(self, T_camera_world=poses, points=matmul(scale * self.points, R.T) + t)

    @returns_new
    def scaled(self, factor: float) -> SfmModel:
        """Scale all lengths by a factor about the world origin.

        Args:
            factor: New units per old unit, > 0.

        Raises:
            TypeError: No number.
            ValueError: Not positive, or lengths leave the range of float64.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
            >>> loom.SfmModel(["a.png"], [camera], np.eye(4)[None], points=[[0, 0, 2.0]]).scaled(2).points.tolist()
            [[0.0, 0.0, 4.0]]
        """
        factor = check_positive("factor", factor, maximum=1e30)
        poses = self.T_camera_world.copy()
        poses[:, :3, 3] *= factor
        return dataclasses.replace(self, T_camera_world=poses, points=self.points * factor)

    @returns_new
    def select(self, names: Iterable[str]) -> SfmModel:
        """The model of some images, without points that none of them observe.

        Args:
            names: Images to keep.

        Raises:
            TypeError: Not strings.
            KeyError: An image that is not in the model.
        """
        wanted = [check_name("names", name) for name in check_list("names", names, "names")]
        rows = np.array(sorted({self.index_of(name) for name in wanted}), np.int64)
        new_index = np.full(len(self), -1)
        new_index[rows] = np.arange(len(rows))
        is_selected = new_index[self.observations[:, 0]] >= 0
        observations = self.observations[is_selected]
        seen, columns = np.unique(observations[:, 1], return_inverse=True)
        return SfmModel(
            tuple(self.names[i] for i in rows), tuple(self.cameras[i] for i in rows), self.T_camera_world[rows],
            self.points[seen], self.colors[seen], self.errors[seen],
            np.stack([new_index[observations[:, 0]], columns.reshape(-1)], axis=1), self.pixels[is_selected],
        )  # fmt: skip

    def trajectory(self, timestamps: ArrayLike | None = None) -> Trajectory:
        """The poses in the order of the names, for `write_trajectory`, `fuse` and others. Ids are image indices.

        Args:
            timestamps: Time of each image, shape (n,) [s], or None.

        Raises:
            TypeError: Not numbers.
            ValueError: Another count.
        """
        order = np.arange(len(self), dtype=np.int64)
        times = None if timestamps is None else check_shape("timestamps", timestamps, (len(self),))
        return Trajectory(self.T_world_camera, times, np.stack([order, order, order + 1], axis=1))

    def point_cloud(self, device: DeviceLike = None, *, arrays: str | None = None) -> PointCloud:
        """The sparse points with colors, `error` [px] and `views` (observations), on `device` (None: CPU).

        `arrays` is the library of returned arrays, as of `PointCloud`.
        """
        return PointCloud(
            self.points, colors=self.colors, device=device, arrays=arrays,
            error=self.errors.astype(np.float32), views=self.view_counts.astype(np.int32),
        )  # fmt: skip


def _check_names(names: Sequence[str]) -> None:
    for name, following in itertools.pairwise(names):
        if name == following:
            raise ValueError(f"names: {shown(name)} is duplicated")
    if names and not names[0]:
        raise ValueError("names: expected a name for every image, got an empty one")


def _stacked(poses: Any) -> NDArray[Any]:
    array = check_numeric("T_camera_world", poses)
    return array.reshape(0, 4, 4) if array.size == 0 and array.ndim and len(array) == 0 else array


def _rigid(poses: NDArray[np.float64]) -> NDArray[np.float64]:
    R = poses[:, :3, :3]
    with np.errstate(all="ignore"):
        skewed = np.abs(R @ R.transpose(0, 2, 1) - np.eye(3)).max(axis=(1, 2))
        good = (skewed <= 0.02) & (np.linalg.det(R) > 0) & (np.abs(poses[:, 3] - (0, 0, 0, 1)).max(axis=1) <= 1e-6)
        good &= (np.abs(poses) <= 1e100).all(axis=(1, 2))
    for i in np.flatnonzero(~good):
        check_rigid(f"T_camera_world[{i}]", poses[i])
    return poses.copy()


def _check_points(points: Any) -> NDArray[np.float64]:
    array = check_rows("points", points, 3).astype(np.float64)
    wrong = np.flatnonzero(~(np.abs(array) <= 1e100).all(axis=1))
    if len(wrong):
        raise ValueError(f"points: expected finite numbers, got {array[wrong[0]].tolist()} in row {wrong[0]}")
    return array


def _check_colors(colors: Any, count: int) -> NDArray[np.uint8]:
    if colors is None:
        return np.zeros((count, 3), np.uint8)
    array = check_rows("colors", colors, 3)
    if len(array) != count:
        raise ValueError(f"colors: expected shape [{count}, 3] as there are {count} points, got {list(array.shape)}")
    if count and array.dtype != np.uint8:
        raise TypeError(f"colors: expected uint8, got {array.dtype}; scale floats by 255 and round")
    return array.astype(np.uint8)


def _check_errors(errors: Any, count: int) -> NDArray[np.float64]:
    if errors is None:
        return np.full(count, np.nan)
    array = check_shape("errors", errors, (count,)).astype(np.float64)
    if (array < 0).any() or np.isinf(array).any():
        raise ValueError("errors: expected distances >= 0 [px], or NaN where unknown")
    return array


def _check_observations(
    observations: Any, pixels: Any, images: int, points: int
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    if observations is None:
        if pixels is not None and len(check_numeric("pixels", pixels)):
            raise ValueError("pixels: given without observations")
        return np.zeros((0, 2), np.int64), np.zeros((0, 2))
    pairs = check_rows("observations", observations, 2)
    if len(pairs) and pairs.dtype.kind not in "iu":
        raise TypeError(f"observations: expected whole numbers, got {pairs.dtype}")
    if pixels is None:
        raise ValueError("pixels: expected one per row of observations, got None")
    positions = check_rows("pixels", pixels, 2).astype(np.float64)
    if len(positions) != len(pairs):
        raise ValueError(
            f"pixels: expected shape [{len(pairs)}, 2], one per row of observations, got {len(positions)} rows"
        )
    wrong = np.flatnonzero(~((pairs >= 0) & (pairs < (images, points))).all(axis=1))
    if len(wrong):
        raise ValueError(
            f"observations: row {wrong[0]} is {pairs[wrong[0]].tolist()}, but there are {images} images and "
            f"{points} points"
        )
    if not (np.abs(positions) <= 1e100).all():
        raise ValueError("pixels: expected finite numbers, got NaN or infinite ones")
    return pairs.astype(np.int64), positions


def _sorted(
    observations: NDArray[np.int64], pixels: NDArray[np.float64], points: int
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    keys = observations[:, 0] * max(points, 1) + observations[:, 1]
    if not (keys[1:] < keys[:-1]).any():
        return observations, pixels
    order = np.argsort(keys, kind="stable")
    return observations[order], pixels[order]


def _check_similarity(transformation: Any) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
    T = check_shape("transformation", transformation, (4, 4))
    scale = cube_root(float(det(T[:3, :3]))) if np.isfinite(T).all() and np.abs(T).max() < 1e30 else np.nan
    if not scale > 1e-30:
        raise ValueError(
            f"transformation: expected a positive scale times a rotation, and a translation, got {shown(T.tolist())}"
        )
    rigid = T.copy()
    rigid[:3, :3] /= scale
    check_rigid("transformation", rigid, tolerance=1e-6)
    return rigid[:3, :3], rigid[:3, 3], scale
