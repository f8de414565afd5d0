"""Axis-aligned and oriented bounding boxes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.checks import LARGEST_NUMBER, check_finite, check_positive, check_rigid, check_rows, check_shape
from ..core.coordinates import finite_box
from ..core.dropped_results import returns_new
from ..core.exchange import on_host
from ..core.wording import rounded
from ..kernels.extent.masks import mask_aligned_box, mask_oriented_box
from ..kernels.linear_algebra import matmul
from .bounding_box import BoundingBox
from .convex_hull import find_extremes
from .minimal_box import fit_principal_box, fit_smallest_box
from .stored_arrays import read_only

CORNER_SIGNS = np.array(  # Open3D's order, in halves of the extent
    [[-1, -1, -1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1], [1, 1, 1], [-1, 1, 1], [1, -1, 1], [1, 1, -1]], np.float64
)


class AxisAlignedBoundingBox(BoundingBox):
    """All points with min_bound <= p <= max_bound on each axis.

    Boxes are equal if their bounds are. The color is ignored. Methods return new boxes.

    Args:
        min_bound: Lowest corner [m], shape (3,); -inf leaves a side open.
        max_bound: Highest corner [m], shape (3,).

    Raises:
        ValueError: If a bound is NaN, a minimum exceeds its maximum, or both are at the same infinity.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> ground = loom.AxisAlignedBoundingBox([-np.inf, -np.inf, 0.0], [np.inf, np.inf, 0.2])
        >>> len(loom.PointCloud([[5, 5, 0.1], [5, 5, 1]]).crop(ground))
        1
        >>> box = loom.PointCloud([[0, 0, 0], [1, 2, 3]]).get_axis_aligned_bounding_box()
        >>> box.volume(), box.get_center().tolist()
        (6.0, [0.5, 1.0, 1.5])
    """

    def __init__(self, min_bound: ArrayLike = (0, 0, 0), max_bound: ArrayLike = (0, 0, 0)):
        low, high = check_shape("min_bound", min_bound, (3,)), check_shape("max_bound", max_bound, (3,))
        if not ((low <= high) & (low < np.inf) & (high > -np.inf)).all():
            raise ValueError(f"min_bound, max_bound: expected min <= max, got {low.tolist()} and {high.tolist()}")
        super().__init__((1, 1, 1))
        self._min_bound, self._max_bound = low.copy(), high.copy()

    @classmethod
    def create_from_points(cls, points: ArrayLike) -> AxisAlignedBoundingBox:
        """Box of the finite points of an array (n, 3). At zero if there are none."""
        return cls(*finite_box(check_rows("points", on_host("points", points), 3, dtype=np.float64)))

    @property
    def min_bound(self) -> NDArray[np.float64]:
        """Lowest corner [m], shape (3,)."""
        return read_only(self._min_bound.copy())

    @property
    def max_bound(self) -> NDArray[np.float64]:
        """Highest corner [m], shape (3,)."""
        return read_only(self._max_bound.copy())

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        """Unpack as `low, high = box`."""
        return iter((self.min_bound, self.max_bound))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        """Both bounds, shape (2, 3)."""
        return np.array([self._min_bound, self._max_bound], dtype)

    def __repr__(self) -> str:
        return f"{type(self).__name__}{rounded((self._min_bound, self._max_bound), self.get_max_extent())}"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, AxisAlignedBoundingBox):
            return NotImplemented
        return np.array_equal(np.array(self), np.array(other))

    __hash__ = None  # type: ignore[assignment]  # boxes compare by value

    def __add__(self, other: AxisAlignedBoundingBox) -> AxisAlignedBoundingBox:
        """Smallest box around both, in this one's color. A box without volume adds nothing, as in Open3D."""
        if not isinstance(other, AxisAlignedBoundingBox):
            return NotImplemented
        low, high = self
        if self.is_empty():
            low, high = other
        elif not other.is_empty():
            low, high = np.minimum(low, other.min_bound), np.maximum(high, other.max_bound)
        return self._like(low, high)

    def get_min_bound(self) -> NDArray[np.float64]:
        """Lowest corner [m], shape (3,)."""
        return self.min_bound

    def get_max_bound(self) -> NDArray[np.float64]:
        """Highest corner [m], shape (3,)."""
        return self.max_bound

    def get_center(self) -> NDArray[np.float64]:
        """Center [m], shape (3,)."""
        return (self._min_bound + self._max_bound) * 0.5

    def get_extent(self) -> NDArray[np.float64]:
        """Lengths along x, y and z [m], shape (3,)."""
        return self._max_bound - self._min_bound

    def get_half_extent(self) -> NDArray[np.float64]:
        """Half the lengths along x, y and z [m], shape (3,)."""
        return self.get_extent() * 0.5

    def get_max_extent(self) -> float:
        """Longest length [m]."""
        return float(self.get_extent().max())

    def volume(self) -> float:
        """Volume [m^3]."""
        return float(self.get_extent().prod())

    def is_empty(self) -> bool:
        """True if the volume is zero."""
        return self.volume() <= 0

    def get_box_points(self) -> NDArray[np.float64]:
        """Corners in Open3D's order, shape (8, 3)."""
        return np.where(CORNER_SIGNS < 0, self._min_bound, self._max_bound)

    def get_print_info(self) -> str:
        """Bounds as Open3D prints them."""
        low, high = (", ".join(f"{value:.4f}" for value in bound) for bound in (self._min_bound, self._max_bound))
        return f"[({low}) - ({high})]"

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Return this box."""
        return self

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Convert to an oriented box."""
        return OrientedBoundingBox.create_from_axis_aligned_bounding_box(self)

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Convert to an oriented box."""
        return OrientedBoundingBox.create_from_axis_aligned_bounding_box(self)

    @returns_new
    def translate(self, translation: ArrayLike, relative: bool = True) -> AxisAlignedBoundingBox:
        """Translate by a vector [m]. With `relative=False`, move the center there."""
        step = check_finite("translation", check_shape("translation", translation, (3,)))
        if relative:
            return self._like(self._min_bound + step, self._max_bound + step)
        half = self.get_half_extent()
        return self._like(step - half, step + half)

    @returns_new
    def scale(self, scale: float, center: ArrayLike | None = None) -> AxisAlignedBoundingBox:
        """Scale by a positive factor about a point [m], default the center."""
        factor = check_positive("scale", scale)
        about = self.get_center() if center is None else check_finite("center", check_shape("center", center, (3,)))
        with np.errstate(over="ignore"):  # sides beyond float64 are open
            return self._like(about + factor * (self._min_bound - about), about + factor * (self._max_bound - about))

    @returns_new
    def rotate(self, R: ArrayLike, center: ArrayLike | None = None) -> OrientedBoundingBox:
        """Rotate about a point, default the center. Returns an oriented box."""
        return OrientedBoundingBox.create_from_axis_aligned_bounding_box(self).rotate(R, center)

    def _like(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> AxisAlignedBoundingBox:
        box = AxisAlignedBoundingBox(low, high)
        box.color = self.color
        return box

    def mask_points(self, points: wp.array, origin: NDArray[np.float64]) -> wp.array:
        """Uint8 device mask of the vec3 points (relative to an origin) inside."""
        return mask_aligned_box(points, origin, self._min_bound, self._max_bound)

    def _contains(self, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        return np.logical_and.reduce((points >= self._min_bound) & (points <= self._max_bound), axis=1)


class OrientedBoundingBox(BoundingBox):
    """An oriented box, faces included.

    Boxes are equal if center, axes and extent are. The color is ignored. Methods return new boxes.

    Args:
        center: Center [m], shape (3,).
        R: Rotation, shape (3, 3). Its columns are the box's axes.
        extent: Lengths along the axes [m], shape (3,).

    Raises:
        ValueError: If R is not a rotation, or an extent is negative or not finite.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> R = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
        >>> beam = loom.OrientedBoundingBox([0, 0, 0], R, [10, 0.2, 0.2])
        >>> len(loom.PointCloud([[2.4, 3.2, 0], [3.2, 2.4, 0]]).crop(beam))
        1
        >>> beam.color = (1, 0, 0)
        >>> round(beam.volume(), 6), beam.get_box_points().shape
        (0.4, (8, 3))
    """

    def __init__(self, center: ArrayLike, R: ArrayLike, extent: ArrayLike):
        T = np.eye(4)
        T[:3, :3] = check_shape("R", R, (3, 3))
        check_rigid("R", T, tolerance=1e-4)
        middle, lengths = check_shape("center", center, (3,)), check_shape("extent", extent, (3,))
        if not np.isfinite(middle).all() or not np.isfinite(lengths).all() or (lengths < 0).any():
            raise ValueError(f"center, extent: expected finite numbers, extent >= 0, got {middle} and {lengths}")
        check_finite("center", middle)
        check_finite("extent", lengths)
        super().__init__((0, 0, 0))
        self._center, self._R, self._extent = middle.copy(), T[:3, :3].copy(), lengths.copy()

    @classmethod
    def create_from_axis_aligned_bounding_box(cls, aabox: AxisAlignedBoundingBox) -> OrientedBoundingBox:
        """Same box and color with the axes x, y and z."""
        if not isinstance(aabox, AxisAlignedBoundingBox):
            raise TypeError(f"aabox: expected an AxisAlignedBoundingBox, got {type(aabox).__name__}")
        box = cls(aabox.get_center(), np.eye(3), aabox.get_extent())
        box.color = aabox.color
        return box

    @classmethod
    def create_from_points(cls, points: ArrayLike, robust: bool = False) -> OrientedBoundingBox:
        """As `PointCloud.get_oriented_bounding_box`, for an array (n, 3)."""
        positions, origin = _centered(points)
        extremes = find_extremes(positions, robust)
        return cls(*fit_principal_box(positions, origin, extremes))

    @classmethod
    def create_from_points_minimal(cls, points: ArrayLike, robust: bool = False) -> OrientedBoundingBox:
        """As `PointCloud.get_minimal_oriented_bounding_box`, for an array (n, 3). On the CPU."""
        positions, origin = _centered(points)
        extremes = find_extremes(positions, robust)
        return cls(*fit_smallest_box(positions, origin, extremes, "cpu"))

    @property
    def center(self) -> NDArray[np.float64]:
        """Center [m], shape (3,)."""
        return read_only(self._center.copy())

    @property
    def R(self) -> NDArray[np.float64]:
        """Rotation, shape (3, 3). Its columns are the axes."""
        return read_only(self._R.copy())

    @property
    def extent(self) -> NDArray[np.float64]:
        """Lengths along the axes [m], shape (3,)."""
        return read_only(self._extent.copy())

    def __repr__(self) -> str:
        center, extent = rounded((self._center, self._extent), float(self._extent.max()))
        return f"{type(self).__name__}({center}, {rounded(self._R, 1.0)}, {extent})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, OrientedBoundingBox):
            return NotImplemented
        return all(np.array_equal(getattr(self, name), getattr(other, name)) for name in ("center", "R", "extent"))

    __hash__ = None  # type: ignore[assignment]  # boxes compare by value

    def get_center(self) -> NDArray[np.float64]:
        """Center [m], shape (3,)."""
        return self.center

    def get_extent(self) -> NDArray[np.float64]:
        """Lengths along the axes [m], shape (3,)."""
        return self.extent

    def get_half_extent(self) -> NDArray[np.float64]:
        """Half the lengths along the axes [m], shape (3,)."""
        return self._extent * 0.5

    def get_max_extent(self) -> float:
        """Longest length [m]."""
        return float(self._extent.max())

    def get_min_bound(self) -> NDArray[np.float64]:
        """Minimum coordinates of the corners [m], shape (3,)."""
        return self.get_box_points().min(axis=0)

    def get_max_bound(self) -> NDArray[np.float64]:
        """Maximum coordinates of the corners [m], shape (3,)."""
        return self.get_box_points().max(axis=0)

    def volume(self) -> float:
        """Volume [m^3]."""
        return float(self._extent.prod())

    def is_empty(self) -> bool:
        """True if the volume is zero."""
        return self.volume() <= 0

    def get_box_points(self) -> NDArray[np.float64]:
        """Corners in Open3D's order, shape (8, 3)."""
        return self._center + matmul(CORNER_SIGNS * (self._extent / 2), self._R.T)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Smallest axis-aligned box around it."""
        return AxisAlignedBoundingBox(self.get_min_bound(), self.get_max_bound())

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Return this box."""
        return self

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Return this box."""
        return self

    @returns_new
    def translate(self, translation: ArrayLike, relative: bool = True) -> OrientedBoundingBox:
        """Translate by a vector [m]. With `relative=False`, move the center there."""
        step = check_finite("translation", check_shape("translation", translation, (3,)))
        return self._like(self._center + step if relative else step, self._R, self._extent)

    @returns_new
    def scale(self, scale: float, center: ArrayLike | None = None) -> OrientedBoundingBox:
        """Scale by a positive factor about a point [m], default the center."""
        factor = check_positive("scale", scale)
        about = self.center if center is None else check_finite("center", check_shape("center", center, (3,)))
        if factor * max(np.abs(self._center - about).max(), self._extent.max()) > LARGEST_NUMBER:
            raise ValueError(f"scale: expected a factor that keeps the box within {LARGEST_NUMBER:g} m, got {factor:g}")
        return self._like(factor * (self._center - about) + about, self._R, factor * self._extent)

    @returns_new
    def rotate(self, R: ArrayLike, center: ArrayLike | None = None) -> OrientedBoundingBox:
        """Rotate about a point, default the center."""
        rotation = check_shape("R", R, (3, 3))
        about = self._center if center is None else check_finite("center", check_shape("center", center, (3,)))
        return self._like(matmul(rotation, self._center - about) + about, matmul(rotation, self._R), self._extent)

    def _like(self, *parts: NDArray[np.float64]) -> OrientedBoundingBox:
        box = OrientedBoundingBox(*parts)
        box.color = self.color
        return box

    def mask_points(self, points: wp.array, origin: NDArray[np.float64]) -> wp.array:
        """Uint8 device mask of the vec3 points (relative to an origin) inside."""
        return mask_oriented_box(points, origin - self._center, self._R.T, self._extent / 2)

    def _contains(self, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        with np.errstate(invalid="ignore", over="ignore"):  # infinite or huge points are outside
            return np.logical_and.reduce(np.abs(matmul(points - self._center, self._R)) <= self._extent / 2, axis=1)


def _centered(points: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Finite points about the center of their box, and that center."""
    positions = check_rows("points", on_host("points", points), 3, dtype=np.float64)
    positions = positions[np.isfinite(positions).all(axis=1)]
    if not len(positions):
        raise ValueError("points: expected at least one finite point, got none")
    check_finite("points", positions)
    origin = (positions.min(axis=0) + positions.max(axis=0)) / 2
    return positions - origin, origin
