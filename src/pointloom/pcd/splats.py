"""3D Gaussian splats: storage, selection, cleaning and similarity transforms."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import hand_out_host, library_for
from ..core.checks import (
    check_fraction,
    check_list,
    check_numeric,
    check_positive,
    check_rows,
    check_shape,
    check_transformation,
)
from ..core.devices import DeviceLike, check_same_device
from ..core.dropped_results import returns_new
from ..core.exchange import on_host
from ..core.gpu_arrays import device_for
from ..core.quaternions import nearest_rotations
from ..kernels.arrays.select import positions_of
from ..kernels.linear_algebra import cube_root, det, matmul
from ..kernels.splats.motion import mask_splats, rotate_harmonics, rotate_quaternions
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .cloud import PointCloud
from .harmonics import DEGREE_0_HARMONIC, MAX_DEGREE, degree_of, rotation_of_harmonics
from .motion import Movable
from .point_arrays import check_cloud
from .polygon_volume import SelectionPolygonVolume
from .splat_images import RasterizationMixin
from .stored_arrays import read_only

#: The attributes of the cloud that keeps splats, by the names of PLY files: `f_rest` where the degree is above 0.
NAMES = ("f_dc", "f_rest", "opacity", "scale", "rot")

_SIMILARITY_TOLERANCE = 1e-5  # relative deviation of a transformation from a similarity


class GaussianSplats(Movable, RasterizationMixin):
    """Splats of 3D Gaussian Splatting (Kerbl et al., SIGGRAPH 2023).

    Stored as in files (logarithms of scales, logits of opacities, unnormalized quaternions), so reading and writing is
    bitwise lossless. 56 B per splat of degree 0, 236 B of degree 3. Bitwise identical on every device.

    Args:
        centers: Centers [m], shape (n, 3).
        scales: Standard deviations along the axes [m], positive, shape (n, 3).
        rotations: Quaternions (w, x, y, z) from axes to world, nonzero, shape (n, 4).
        opacities: 0 to 1, shape (n,).
        harmonics: Color coefficients, shape (n, K, 3) with K = 1, 4, 9, 16 or 25, or (n, 3) for degree 0. The color is
            0.5 plus their sum over the basis (pcd/harmonics.py).
        device: "cpu", "cuda:0" or "auto". If None: the GPU of the centers, or the CPU.
        arrays: Library of returned arrays, as of `PointCloud`. If None: that of the centers. All arrays are checked and
            converted on the host.

    Raises:
        ValueError, TypeError: If a shape or value is invalid or not finite, or if an array is not numeric.
        DeviceError: If the device does not exist.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> one = loom.GaussianSplats([[0, 0, 1]], [[0.1, 0.1, 0.01]], [[1, 0, 0, 0]], [0.9], [[1, 0, 0]])
        >>> one.degree, one.translate([0, 0, 1]).centers.tolist()
        (0, [[0.0, 0.0, 2.0]])
    """

    def __init__(
        self,
        centers: ArrayLike,
        scales: ArrayLike,
        rotations: ArrayLike,
        opacities: ArrayLike,
        harmonics: ArrayLike,
        *,
        device: Any = None,
        arrays: str | None = None,
    ):
        library, where = library_for(arrays, centers), device_for(centers, device)
        given = {"centers": centers, "scales": scales, "rotations": rotations, "opacities": opacities}
        centers, scales, rotations, opacities = (on_host(name, values) for name, values in given.items())
        middles = check_rows("centers", centers, 3, dtype=np.float64)
        _check_all("centers", np.isfinite(middles).all(axis=1), "three finite numbers")
        try:
            cloud = PointCloud(middles, device=where, arrays=library)
        except ValueError as error:  # extent beyond float32
            raise ValueError(str(error).replace("points:", "centers:", 1)) from None
        count = len(cloud)
        sizes = check_rows("scales", scales, 3, rows=count, dtype=np.float64)
        quaternions = check_rows("rotations", rotations, 4, rows=count, dtype=np.float64)
        fractions = check_shape("opacities", opacities, (count,))
        colors = _coefficients(on_host("harmonics", harmonics), count)
        _check_all("scales", (sizes > 0).all(axis=1) & np.isfinite(sizes).all(axis=1), "three finite numbers above 0")
        lengths = np.square(quaternions).sum(axis=1)
        _check_all("rotations", np.isfinite(lengths) & (lengths > 0), "a finite quaternion of a length above 0")
        _check_all("opacities", (fractions >= 0) & (fractions <= 1), "a number from 0 to 1")
        _check_all("harmonics", np.isfinite(colors).all(axis=(1, 2)), "finite coefficients")
        cloud["opacity"] = logits_of(fractions)
        cloud["scale"] = np.log(sizes).astype(np.float32)
        cloud["rot"] = quaternions.astype(np.float32)
        cloud["f_dc"] = colors[:, 0].astype(np.float32)
        if colors.shape[1] > 1:
            rest = colors[:, 1:].transpose(0, 2, 1).reshape(count, -1)
            cloud["f_rest"] = np.ascontiguousarray(rest, np.float32)
        self._cloud = cloud

    @classmethod
    def from_cloud(cls, cloud: PointCloud) -> Self:
        """Create splats from a cloud with the attributes of PLY files.

        Args:
            cloud: With float32 `f_dc` (n, 3), `opacity` (n,) (logits), `scale` (n, 3) (natural logarithms), `rot` (n,
                4) (w, x, y, z), and above degree 0 `f_rest` (n, 3 (K - 1)): red, green, blue. Others are kept.

        Raises:
            ValueError: If an attribute is missing or has another shape.
        """
        check_cloud("cloud", cloud)
        for name, width in (("f_dc", 3), ("opacity", 0), ("scale", 3), ("rot", 4)):
            shape = cloud.arrays.required(name, f"splats require {', '.join(NAMES)}").shape
            if shape[1:] != ((width,) if width else ()):
                raise ValueError(f"cloud: expected {name} of shape {['n', width] if width else ['n']}, got {shape}")
        if "f_rest" in cloud:
            shape = cloud.arrays["f_rest"].shape
            if len(shape) != 2 or shape[1] % 3 or degree_of(shape[1] // 3 + 1) is None:
                raise ValueError(f"cloud: expected f_rest of 9, 24, 45 or 72 columns, got {list(shape)}")
        return cls._over(cloud)

    def __len__(self) -> int:
        return len(self._cloud)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self):,} splats of degree {self.degree}, {self.device})"

    @property
    def device(self) -> Any:
        """Device of the arrays."""
        return self._cloud.device

    @property
    def cloud(self) -> PointCloud:
        """Centers with the splats' columns as attributes (`NAMES`), without a copy."""
        return self._cloud

    @property
    def degree(self) -> int:
        """Degree of the harmonics, 0 to 4."""
        count = self._cloud.arrays["f_rest"].shape[1] // 3 + 1 if "f_rest" in self._cloud else 1
        return math.isqrt(count) - 1

    @property
    def centers(self) -> NDArray[np.float64]:
        """Centers [m], float64 (n, 3)."""
        return self._cloud.points

    @property
    def scales(self) -> NDArray[np.float32]:
        """Standard deviations along the axes [m], float32 (n, 3)."""
        return read_only(np.exp(self._cloud["scale"]))

    @property
    def rotations(self) -> NDArray[np.float32]:
        """Unit quaternions (w, x, y, z), float32 (n, 4)."""
        return read_only(unit_quaternions(self._cloud["rot"]).astype(np.float32))

    @property
    def opacities(self) -> NDArray[np.float32]:
        """Opacity at the center, 0 to 1, float32 (n,)."""
        return read_only(fractions_of(self._cloud["opacity"]).astype(np.float32))

    @property
    def harmonics(self) -> NDArray[np.float32]:
        """Color coefficients, float32 (n, K, 3)."""
        first = self._cloud["f_dc"][:, None]
        if not self.degree:
            return read_only(first)
        rest = self._cloud["f_rest"].reshape(len(self), 3, -1).transpose(0, 2, 1)
        return read_only(np.concatenate([first, rest], axis=1))

    def covariances(self) -> NDArray[np.float64]:
        """Covariances R S^2 R^T [m^2], float64 (n, 3, 3), computed on the host."""
        axes = self._axes()
        axes = axes * np.exp(self._cloud["scale"].astype(np.float64))[:, None]
        covariances = matmul(axes, axes.transpose(0, 2, 1))
        return hand_out_host(covariances, self._cloud.array_library, self.device)

    def to_point_cloud(self) -> PointCloud:
        """Centers as a cloud with degree 0 colors, `opacity` (0 to 1), and the shortest axes as unsigned normals."""
        cloud = PointCloud(self.centers, device=self.device, arrays=self._cloud.array_library)
        if not len(self):
            return cloud
        cloud.colors = np.clip(0.5 + DEGREE_0_HARMONIC * self._cloud["f_dc"].astype(np.float64), 0, 1)
        cloud["opacity"] = self.opacities
        shortest = self._cloud["scale"].argmin(axis=1)
        cloud.normals = np.take_along_axis(self._axes(), shortest[:, None, None], axis=2)[:, :, 0]
        return cloud

    @returns_new
    def select_by_index(self, indices: ArrayLike, invert: bool = False) -> Self:
        """As `PointCloud.select_by_index`."""
        return self._over(self._cloud.select_by_index(indices, invert))

    @returns_new
    def select_by_mask(self, mask: ArrayLike, invert: bool = False) -> Self:
        """As `PointCloud.select_by_mask`."""
        return self._over(self._cloud.select_by_mask(mask, invert))

    @returns_new
    def crop(
        self, bounding_box: AxisAlignedBoundingBox | OrientedBoundingBox | SelectionPolygonVolume, invert: bool = False
    ) -> Self:
        """Select splats by center in a box or polygon volume, as `PointCloud.crop`."""
        return self._over(self._cloud.crop(bounding_box, invert))

    @returns_new
    def clean(self, *, min_opacity: float = 0.0, min_scale: float = 0.0, max_scale: float | None = None) -> Self:
        """Remove splats that are invalid, nearly transparent, too small or too large.

        Args:
            min_opacity: Minimum opacity, 0 to 1.
            min_scale: Minimum standard deviation of the longest axis [m].
            max_scale: Its maximum [m]. None for no limit. Floating fog is mostly a few huge splats.

        Returns:
            The others, in order. Splats that are not finite or have a zero quaternion are always removed.

        Raises:
            ValueError: If the opacity is outside 0..1, or a scale is negative or not a number.

        Example:
            >>> import pointloom as loom
            >>> import numpy as np
            >>> turns, sizes = [[1, 0, 0, 0]] * 2, [[1] * 3, [9] * 3]
            >>> two = loom.GaussianSplats(np.zeros((2, 3)), sizes, turns, [0.9, 0.9], np.zeros((2, 3)))
            >>> len(two.clean(max_scale=5))
            1
        """
        fraction = check_fraction("min_opacity", min_opacity)
        smallest = check_positive("min_scale", min_scale, allow_zero=True)
        log_largest = (
            math.log(check_positive("max_scale", max_scale)) if max_scale is not None else float(np.finfo("f4").max)
        )
        points, opacity = self._cloud.arrays["points"], self._cloud.arrays["opacity"]
        scale, rot = self._cloud.arrays["scale"], self._cloud.arrays["rot"]
        mask = mask_splats(
            points,
            opacity,
            scale,
            rot,
            float(logits_of(np.array(fraction))),
            math.log(smallest) if smallest else -math.inf,
            log_largest,
        )
        return self._over(self._cloud.select_rows(positions_of(mask)))

    @classmethod
    def concatenate(cls, splats: Iterable[GaussianSplats]) -> Self:
        """Concatenate sets. Lower degrees are padded with zeros.

        Raises:
            ValueError: If there is no set.
            TypeError: If an item is not GaussianSplats, or an attribute's types differ.
            DeviceError: If the sets are on different devices.
        """
        given = check_list("splats", splats, "GaussianSplats")
        if not given:
            raise ValueError("splats: expected at least one set, got none")
        for one in given:
            if not isinstance(one, GaussianSplats):
                raise TypeError(f"splats: expected GaussianSplats, got {type(one).__name__}")
            check_same_device("splats", one.device, given[0].device)
        degree = max(one.degree for one in given)
        return cls.from_cloud(PointCloud.concatenate([_cloud_of_degree(one, degree) for one in given]))

    @returns_new
    def copy(self) -> Self:
        """Copy that shares arrays."""
        return self._over(self._cloud.copy())

    @returns_new
    def to(self, device: DeviceLike, *, arrays: str | None = None) -> Self:
        """Copy to another device, and choose the library of returned arrays, as `PointCloud.to`.

        Raises:
            DeviceError: If the device does not exist.
            ValueError, ImportError: If the library is unknown or not installed.
        """
        return self._over(self._cloud.to(device, arrays=arrays))

    def get_center(self) -> NDArray[np.float64]:
        """Mean of the centers [m], shape (3,)."""
        return self._cloud.get_center()

    @returns_new
    def transform(self, transformation: ArrayLike) -> Self:
        """Apply a similarity in float64: centers, axes, scales and harmonics (a rotation matrix per band).

        Args:
            transformation: 4x4 matrix: a rotation, one scale, a translation.

        Raises:
            ValueError: If the matrix is not a similarity. Harmonics cannot be sheared, reflected or stretched.
        """
        return self._mapped("transformation", check_transformation("transformation", transformation))

    def _mapped(self, name: str, T: NDArray[np.float64]) -> Self:
        from scipy.spatial.transform import Rotation  # lazy: loads scipy.sparse

        R, factor = similarity_of(name, T)
        moved = self._cloud.transform(T)
        arrays = dict(moved.arrays)
        q = np.roll(Rotation.from_matrix(R).as_quat(), 1)
        if not np.array_equal(R, np.eye(3)):
            arrays["rot"] = rotate_quaternions(arrays["rot"], q)
            if self.degree:
                arrays["f_rest"] = rotate_harmonics(
                    arrays["f_rest"], rotation_of_harmonics(R, self.degree), self.degree
                )
        cloud = moved.with_arrays(arrays)
        if factor != 1:
            cloud["scale"] = (cloud["scale"].astype(np.float64) + math.log(factor)).astype(np.float32)
        return self._over(cloud)

    def _axes(self) -> NDArray[np.float64]:
        from scipy.spatial.transform import Rotation  # lazy: loads scipy.sparse

        return Rotation.from_quat(np.roll(self._cloud["rot"].astype(np.float64), -1, axis=1)).as_matrix()

    @classmethod
    def _over(cls, cloud: PointCloud) -> Self:
        splats = object.__new__(cls)
        vars(splats)["_cloud"] = cloud
        return splats


def _cloud_of_degree(splats: GaussianSplats, degree: int) -> PointCloud:
    """The cloud with the harmonics of a higher degree, which are zero."""
    if degree == splats.degree:
        return splats.cloud
    cloud = splats.cloud.copy()
    rest = np.zeros((len(cloud), 3, (degree + 1) ** 2 - 1), np.float32)
    if splats.degree:
        coefficients = cloud["f_rest"].reshape(len(cloud), 3, -1)
        rest[:, :, : coefficients.shape[2]] = coefficients
    cloud["f_rest"] = rest.reshape(len(cloud), -1)
    return cloud


def logits_of(fractions: NDArray[np.float64]) -> NDArray[np.float32]:
    """Logits of opacities, infinite for 0 and 1."""
    with np.errstate(divide="ignore"):
        return (np.log(fractions) - np.log1p(-fractions)).astype(np.float32)


def fractions_of(logits: NDArray[Any]) -> NDArray[np.float64]:
    with np.errstate(over="ignore"):
        return 1 / (1 + np.exp(-logits.astype(np.float64)))


def unit_quaternions(rot: NDArray[Any]) -> NDArray[np.float64]:
    quaternions = rot.astype(np.float64)
    return quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)


def _coefficients(harmonics: ArrayLike, count: int) -> NDArray[np.float64]:
    values = check_numeric("harmonics", harmonics).astype(np.float64)
    values = values[:, None] if values.ndim == 2 else values
    if values.ndim != 3 or values.shape[0] != count or values.shape[2] != 3 or degree_of(values.shape[1]) is None:
        counts = [(degree + 1) ** 2 for degree in range(MAX_DEGREE + 1)]
        raise ValueError(f"harmonics: expected shape [{count}, K, 3] with K of {counts}, got {list(values.shape)}")
    return values


def _check_all(name: str, is_valid: Any, what: str) -> None:
    if not is_valid.all():
        raise ValueError(f"{name}: expected {what} in each row, but row {int(np.argmin(is_valid))} differs")


def similarity_of(name: str, T: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    A = T[:3, :3]
    factor = cube_root(float(det(A)))
    if not factor > 0 or np.abs(matmul(A, A.T) / factor**2 - np.eye(3)).max() > _SIMILARITY_TOLERANCE:
        raise ValueError(f"{name}: expected a rotation with one scale and a translation, got {T.tolist()}")
    return (A / factor if np.array_equal(A, factor * np.eye(3)) else nearest_rotations(A[None])[0]), factor
