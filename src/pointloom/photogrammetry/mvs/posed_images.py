"""Input of multi-view stereo: posed cameras and sparse points."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...core.checks import check_count, check_finite, check_list, check_numeric, check_rigid, check_rows
from ...kernels.linear_algebra import inv, matmul


@dataclasses.dataclass(frozen=True, eq=False)
class PosedCamera:
    """A camera without distortion and its pose.

    Args:
        intrinsic: Image size and projection.
        T_camera_world: World to camera, shape [4, 4] [pose units].

    Raises:
        TypeError, ValueError: An intrinsic of another type, or a pose that is not numeric, finite and rigid.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> intrinsic = loom.PinholeCameraIntrinsic(8, 6, 10.0, 10.0, 3.5, 2.5)
        >>> pose = np.eye(4)
        >>> pose[0, 3] = -2.0
        >>> loom.photogrammetry.PosedCamera(intrinsic, pose).center.tolist()
        [2.0, 0.0, 0.0]
    """

    intrinsic: PinholeCameraIntrinsic
    T_camera_world: NDArray[np.float64]

    def __init__(self, intrinsic: PinholeCameraIntrinsic, T_camera_world: ArrayLike):
        check_camera("intrinsic", intrinsic)
        pose = check_rigid("T_camera_world", T_camera_world).copy()
        pose.flags.writeable = False
        object.__setattr__(self, "intrinsic", intrinsic)
        object.__setattr__(self, "T_camera_world", pose)

    @property
    def center(self) -> NDArray[np.float64]:
        """Camera position in the world, shape [3] [pose units]."""
        return matmul(-inv(self.T_camera_world[:3, :3]), self.T_camera_world[:3, 3]) + 0.0


@dataclasses.dataclass(frozen=True, eq=False)
class SparsePoints:
    """Scene points and the images that see them.

    Args:
        points: Shape [m, 3] [pose units].
        observations: Unique pairs (image, point), integers from 0, shape [k, 2]. Sorted here.

    Raises:
        TypeError, ValueError: Not numeric, a wrong shape, non-finite values, or an observation of a missing point.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.mvs.posed_images import SparsePoints
        >>> sparse = SparsePoints([[0.0, 0.0, 2.0], [1.0, 0.0, 3.0]], [[0, 1], [0, 0], [1, 1]])
        >>> sparse.seen_by(0).tolist(), sparse.seen_by(1).tolist()
        ([0, 1], [1])
    """

    points: NDArray[np.float64]
    observations: NDArray[np.int64]

    def __init__(self, points: ArrayLike, observations: ArrayLike):
        checked = check_finite("points", check_rows("points", points, 3, dtype=np.float64)).copy()
        pairs = check_numeric("observations", observations)
        if pairs.size and pairs.dtype.kind not in "iu":
            raise TypeError(f"observations: expected integers, got {pairs.dtype}")
        pairs = check_rows("observations", pairs, 2)
        if pairs.size and (pairs.min() < 0 or pairs[:, 1].max() >= len(checked)):
            raise ValueError(
                f"observations: expected pairs (image, point) with points 0 to {len(checked) - 1}, "
                f"got numbers {pairs.min()} to {pairs.max()}"
            )
        pairs = np.unique(pairs.astype(np.int64), axis=0).reshape(-1, 2)
        for array in (checked, pairs):
            array.flags.writeable = False
        object.__setattr__(self, "points", checked)
        object.__setattr__(self, "observations", pairs)

    def seen_by(self, image: int) -> NDArray[np.int64]:
        """The points that an image sees, ascending."""
        first, last = np.searchsorted(self.observations[:, 0], [image, image + 1])
        return self.observations[first:last, 1]


def check_sparse(name: str, value: Any) -> SparsePoints:
    if isinstance(value, SparsePoints):
        return value
    if not (hasattr(value, "points") and hasattr(value, "observations")):
        raise TypeError(f"{name}: expected an object with points and observations, got {type(value).__name__}")
    try:
        return SparsePoints(value.points, value.observations)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{name}.{error}") from error


def check_cameras(name: str, values: Any) -> tuple[PosedCamera, ...]:
    cameras = check_list(name, values, "PosedCamera")
    for i, camera in enumerate(cameras):
        if not isinstance(camera, PosedCamera):
            raise TypeError(f"{name}[{i}]: expected a PosedCamera, got {type(camera).__name__}")
    return tuple(cameras)


def check_sources(name: str, values: Any, count: int) -> tuple[tuple[int, ...], ...]:
    """Check the source numbers of `count` images: existing, unique, not the image itself."""
    lists = check_list(name, values, "lists of image numbers")
    if len(lists) != count:
        raise ValueError(f"{name}: expected a list for each of the {count} images, got {len(lists)}")
    out = []
    for i, numbers in enumerate(lists):
        where = f"{name}[{i}]"
        sources = [check_count(where, n, minimum=0) for n in check_list(where, numbers, "image numbers")]
        if len(set(sources)) < len(sources) or any(n >= count or n == i for n in sources):
            raise ValueError(f"{where}: expected other images, 0 to {count - 1}, each once, got {sources}")
        out.append(tuple(sources))
    return tuple(out)
