"""3D Gaussian splats: soft ellipsoids with opacity and colour by direction, cleaned, cut and moved."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import (
    check_list,
    check_numeric,
    check_positive,
    check_rows,
    check_shape,
    check_share,
    check_transformation,
)
from ..core.devices import check_same_device
from ..core.dropped_results import returns_new
from ..core.quaternions import nearest_rotations
from ..kernels.arrays.select import positions_of
from ..kernels.linear_algebra import cube_root, det, matmul
from ..kernels.splats.masks import mask_splats
from ..kernels.splats.motion import turn_harmonics, turn_quaternions
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .cloud import PointCloud
from .harmonics import FIRST, MOST_DEGREE, degree_of, turns_of_harmonics
from .motion import Movable
from .point_arrays import check_cloud, read_only
from .polygon_volume import SelectionPolygonVolume
from .splat_pictures import Pictured

#: The attributes of the cloud that keeps splats, by the names of PLY files: `f_rest` where the degree is above 0.
NAMES = ("f_dc", "f_rest", "opacity", "scale", "rot")

_TURN_TOLERANCE = 1e-5  # how far a transformation may be from a similarity, as a share of its scale


class GaussianSplats(Movable, Pictured):
    """Splats of 3D Gaussian Splatting (Kerbl et al. 2023), on one device.

    A splat is a Gaussian of centre, three axes' standard deviations and a rotation, with an opacity at its middle and a
    colour that depends on the direction from which it is seen, as spherical harmonics. They are kept as files have
    them (logarithms of scales, logits of opacities, quaternions of any length), so that what is read and written again
    is the same to the last bit. Operations return new splats.

    Args:
        centers: Middles [m], shape [n, 3].
        scales: Standard deviations along the axes [m], above zero, shape [n, 3].
        rotations: Quaternions (w, x, y, z) that take the axes to the world, of any length above zero, shape [n, 4].
        opacities: 0 to 1, shape [n].
        harmonics: Coefficients of the colour, shape [n, K, 3] with K = 1, 4, 9, 16 or 25; the colour is 0.5 plus their
            sum over the basis (pcd/harmonics.py). Shape [n, 3]: of degree 0.
        device: "cpu", "cuda:0", "auto"; None for the CPU.

    Raises:
        ValueError: Wrong shapes or lengths, scales not above zero, opacities out of range, quaternions of no length, or
            numbers that are not finite.
        TypeError: Not numeric.
        DeviceError: No such device.

    Notes:
        Memory: 56 B a splat of degree 0, 236 B of degree 3. Same bits from run to run and on every device.

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
    ):
        middles = check_rows("centers", centers, 3, dtype=np.float64)
        _check_all("centers", np.isfinite(middles).all(axis=1), "three finite numbers")
        try:
            cloud = PointCloud(middles, device=device)
        except ValueError as error:  # farther apart than float32 holds
            raise ValueError(str(error).replace("points:", "centers:", 1)) from None
        count = len(cloud)
        sizes = check_rows("scales", scales, 3, rows=count, dtype=np.float64)
        turns = check_rows("rotations", rotations, 4, rows=count, dtype=np.float64)
        shares = check_shape("opacities", opacities, (count,))
        colors = _coefficients(harmonics, count)
        _check_all("scales", (sizes > 0).all(axis=1) & np.isfinite(sizes).all(axis=1), "three finite numbers above 0")
        lengths = np.square(turns).sum(axis=1)
        _check_all("rotations", np.isfinite(lengths) & (lengths > 0), "a finite quaternion of a length above 0")
        _check_all("opacities", (shares >= 0) & (shares <= 1), "a number from 0 to 1")
        _check_all("harmonics", np.isfinite(colors).all(axis=(1, 2)), "finite coefficients")
        cloud["opacity"] = logits_of(shares)
        cloud["scale"] = np.log(sizes).astype(np.float32)
        cloud["rot"] = turns.astype(np.float32)
        cloud["f_dc"] = colors[:, 0].astype(np.float32)
        if colors.shape[1] > 1:
            rest = colors[:, 1:].transpose(0, 2, 1).reshape(count, -1)
            cloud["f_rest"] = np.ascontiguousarray(rest, np.float32)
        self._cloud = cloud

    @classmethod
    def from_cloud(cls, cloud: PointCloud) -> Self:
        """The splats whose columns a cloud has as attributes, by the names and in the units of PLY files.

        Args:
            cloud: With `f_dc` [n, 3], `opacity` [n] (logits), `scale` [n, 3] (natural logarithms), `rot` [n, 4] (w, x,
                y, z), float32, and `f_rest` [n, 3 (K - 1)] where the degree is above 0: red, then green, then blue.
                Further attributes stay with the splats.

        Raises:
            ValueError: One is missing or has another shape.
        """
        check_cloud("cloud", cloud)
        for name, width in (("f_dc", 3), ("opacity", 0), ("scale", 3), ("rot", 4)):
            shape = cloud._required_array(name, f"splats need {', '.join(NAMES)}").shape
            if shape[1:] != ((width,) if width else ()):
                raise ValueError(f"cloud: expected {name} of shape {['n', width] if width else ['n']}, got {shape}")
        splats = object.__new__(cls)
        splats._cloud = cloud
        if "f_rest" in cloud:
            shape = cloud._device_array("f_rest").shape
            if len(shape) != 2 or shape[1] % 3 or degree_of(shape[1] // 3 + 1) is None:
                raise ValueError(f"cloud: expected f_rest of 9, 24, 45 or 72 columns, got {list(shape)}")
        return splats

    def __len__(self) -> int:
        return len(self._cloud)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self):,} splats of degree {self.degree}, {self.device})"

    @property
    def device(self) -> Any:
        """The device that holds the arrays."""
        return self._cloud.device

    @property
    def cloud(self) -> PointCloud:
        """The centres with the splats' columns as attributes (`NAMES`), without a copy."""
        return self._cloud

    @property
    def degree(self) -> int:
        """Of the harmonics, 0 to 4."""
        count = self._cloud._device_array("f_rest").shape[1] // 3 + 1 if "f_rest" in self._cloud else 1
        return math.isqrt(count) - 1

    @property
    def centers(self) -> NDArray[np.float64]:
        """Middles [m], float64 [n, 3]."""
        return self._cloud.points

    @property
    def scales(self) -> NDArray[np.float32]:
        """Standard deviations along the axes [m], float32 [n, 3]."""
        return read_only(np.exp(self._cloud["scale"]))

    @property
    def rotations(self) -> NDArray[np.float32]:
        """Unit quaternions (w, x, y, z), float32 [n, 4]."""
        return read_only(unit_quaternions(self._cloud["rot"]).astype(np.float32))

    @property
    def opacities(self) -> NDArray[np.float32]:
        """Opacity at the middle, 0 to 1, float32 [n]."""
        return read_only(shares_of(self._cloud["opacity"]).astype(np.float32))

    @property
    def harmonics(self) -> NDArray[np.float32]:
        """Coefficients of the colour, float32 [n, K, 3]."""
        first = self._cloud["f_dc"][:, None]
        if not self.degree:
            return read_only(first)
        rest = self._cloud["f_rest"].reshape(len(self), 3, -1).transpose(0, 2, 1)
        return read_only(np.concatenate([first, rest], axis=1))

    def covariances(self) -> NDArray[np.float64]:
        """Covariances R S^2 R^T [m^2], float64 [n, 3, 3]."""
        axes = self._axes()
        axes = axes * np.exp(self._cloud["scale"].astype(np.float64))[:, None]
        return matmul(axes, axes.transpose(0, 2, 1))

    def to_point_cloud(self) -> PointCloud:
        """The centres as a cloud: colours as seen from nowhere (degree 0), and `opacity`, 0 to 1.

        Normals are the shortest axes, of either sign.
        """
        cloud = PointCloud(self.centers, device=self.device)
        if not len(self):
            return cloud
        cloud.colors = np.clip(0.5 + FIRST * self._cloud["f_dc"].astype(np.float64), 0, 1)
        cloud["opacity"] = self.opacities
        shortest = self._cloud["scale"].argmin(axis=1)
        cloud.normals = np.take_along_axis(self._axes(), shortest[:, None, None], axis=2)[:, :, 0]
        return cloud

    # ----------------------------------------------------------------------------------------------- choosing

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
        """The splats whose centres lie inside a box or a polygon volume; as `PointCloud.crop`."""
        return self._over(self._cloud.crop(bounding_box, invert))

    @returns_new
    def clean(self, *, min_opacity: float = 0.0, min_scale: float = 0.0, max_scale: float | None = None) -> Self:
        """Without splats that cannot be drawn, are hardly seen, or are too small or too large.

        Args:
            min_opacity: Least opacity, 0 to 1.
            min_scale: Least standard deviation of a splat's longest axis [m].
            max_scale: Largest of it [m]; None for any finite one. Floating fog is mostly a few huge splats.

        Returns:
            The others, in their order. What is not finite, or has a quaternion of no length, goes in any case.

        Raises:
            ValueError: An opacity outside 0 to 1, or a scale that is negative or not a number.

        Example:
            >>> import pointloom as loom
            >>> import numpy as np
            >>> turns, sizes = [[1, 0, 0, 0]] * 2, [[1] * 3, [9] * 3]
            >>> two = loom.GaussianSplats(np.zeros((2, 3)), sizes, turns, [0.9, 0.9], np.zeros((2, 3)))
            >>> len(two.clean(max_scale=5))
            1
        """
        share = check_share("min_opacity", min_opacity)
        least = check_positive("min_scale", min_scale, allow_zero=True)
        most = math.log(check_positive("max_scale", max_scale)) if max_scale is not None else float(np.finfo("f4").max)
        points, opacity = self._cloud._device_array("points"), self._cloud._device_array("opacity")
        scale, rot = self._cloud._device_array("scale"), self._cloud._device_array("rot")
        mask = mask_splats(
            points,
            opacity,
            scale,
            rot,
            float(logits_of(np.array(share))),
            math.log(least) if least else -math.inf,
            most,
        )
        return self._over(self._cloud._select_rows(positions_of(mask)))

    @classmethod
    def concatenate(cls, splats: Iterable[GaussianSplats]) -> Self:
        """Several sets as one; degrees below the highest get harmonics of zero.

        Raises:
            ValueError: None is given.
            TypeError: One is no GaussianSplats, or an attribute's types differ.
            DeviceError: They are on different devices.
        """
        given = check_list("splats", splats, "GaussianSplats")
        if not given:
            raise ValueError("splats: expected at least one set, got none")
        for one in given:
            if not isinstance(one, GaussianSplats):
                raise TypeError(f"splats: expected GaussianSplats, got {type(one).__name__}")
            check_same_device("splats", one.device, given[0].device)
        degree = max(one.degree for one in given)
        return cls.from_cloud(PointCloud.concatenate([one._of_degree(degree)._cloud for one in given]))

    @returns_new
    def copy(self) -> Self:
        """Another set over the same arrays."""
        return self._over(self._cloud.copy())

    @returns_new
    def to(self, device: Any) -> Self:
        """The splats on another device.

        Raises:
            DeviceError: No such device.
        """
        return self._over(self._cloud.to(device))

    # ------------------------------------------------------------------------------------------------- moving

    def get_center(self) -> NDArray[np.float64]:
        """The mean of the centres [m], shape [3]."""
        return self._cloud.get_center()

    @returns_new
    def transform(self, transformation: ArrayLike) -> Self:
        """The splats under a similarity: centres, axes and scales, and the harmonics turned, computed in float64.

        Args:
            transformation: 4x4: a rotation, one scale for all axes, a translation.

        Raises:
            ValueError: Not such a matrix. Shear, reflections and scales that differ by axis would make other colours
                of other directions, which harmonics cannot follow.

        Notes:
            Each band of the harmonics is multiplied by the matrix of its rotation, exact to float32's rounding.
        """
        return self._mapped("transformation", check_transformation("transformation", transformation))

    # ---------------------------------------------------------------------------------------------- internals

    def _mapped(self, name: str, T: NDArray[np.float64]) -> Self:
        from scipy.spatial.transform import Rotation  # with scipy.sparse, which `draw` is not to wait for

        R, factor = similarity_of(name, T)
        moved = self._cloud.transform(T)
        arrays = moved._device_arrays
        q = np.roll(Rotation.from_matrix(R).as_quat(), 1)
        if not np.array_equal(R, np.eye(3)):
            arrays["rot"] = turn_quaternions(arrays["rot"], q)
            if self.degree:
                arrays["f_rest"] = turn_harmonics(arrays["f_rest"], turns_of_harmonics(R, self.degree), self.degree)
        cloud = moved._with_arrays(arrays)
        if factor != 1:
            cloud["scale"] = (cloud["scale"].astype(np.float64) + math.log(factor)).astype(np.float32)
        return self._over(cloud)

    def _axes(self) -> NDArray[np.float64]:
        """Directions of the axes, the columns of [n, 3, 3]."""
        from scipy.spatial.transform import Rotation  # with scipy.sparse, which `draw` is not to wait for

        return Rotation.from_quat(np.roll(self._cloud["rot"].astype(np.float64), -1, axis=1)).as_matrix()

    def _of_degree(self, degree: int) -> GaussianSplats:
        if degree == self.degree:
            return self
        cloud = self._cloud.copy()
        rest = np.zeros((len(self), 3, (degree + 1) ** 2 - 1), np.float32)
        if self.degree:
            own = self._cloud["f_rest"].reshape(len(self), 3, -1)
            rest[:, :, : own.shape[2]] = own
        cloud["f_rest"] = rest.reshape(len(self), -1)
        return GaussianSplats.from_cloud(cloud)

    def _over(self, cloud: PointCloud) -> Self:
        splats = object.__new__(type(self))
        splats._cloud = cloud
        return splats


def logits_of(shares: NDArray[np.float64]) -> NDArray[np.float32]:
    """The logits of opacities, infinite of 0 and 1."""
    with np.errstate(divide="ignore"):
        return (np.log(shares) - np.log1p(-shares)).astype(np.float32)


def shares_of(logits: NDArray[Any]) -> NDArray[np.float64]:
    """Opacities, 0 to 1."""
    with np.errstate(over="ignore"):
        return 1 / (1 + np.exp(-logits.astype(np.float64)))


def unit_quaternions(rot: NDArray[Any]) -> NDArray[np.float64]:
    """Quaternions of length 1."""
    turns = rot.astype(np.float64)
    return turns / np.linalg.norm(turns, axis=1, keepdims=True)


def _coefficients(harmonics: ArrayLike, count: int) -> NDArray[np.float64]:
    values = check_numeric("harmonics", harmonics).astype(np.float64)
    values = values[:, None] if values.ndim == 2 else values
    if values.ndim != 3 or values.shape[0] != count or values.shape[2] != 3 or degree_of(values.shape[1]) is None:
        counts = [(degree + 1) ** 2 for degree in range(MOST_DEGREE + 1)]
        raise ValueError(f"harmonics: expected shape [{count}, K, 3] with K of {counts}, got {list(values.shape)}")
    return values


def _check_all(name: str, sound: Any, what: str) -> None:
    if not sound.all():
        raise ValueError(f"{name}: expected {what} in each row; row {int(np.argmin(sound))} has not")


def similarity_of(name: str, T: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """The rotation and the scale of a similarity."""
    A = T[:3, :3]
    factor = cube_root(float(det(A)))
    if not factor > 0 or np.abs(matmul(A, A.T) / factor**2 - np.eye(3)).max() > _TURN_TOLERANCE:
        raise ValueError(f"{name}: expected a rotation with one scale and a translation, got {T.tolist()}")
    return (A / factor if np.array_equal(A, factor * np.eye(3)) else nearest_rotations(A[None])[0]), factor
