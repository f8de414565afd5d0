"""Boxes that crop clouds: aligned with the axes, or turned."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .checks import check_rigid, check_shape


@dataclass(frozen=True, init=False)
class AxisAlignedBoundingBox:
    """All points with min_bound <= p <= max_bound on each axis, both included.

    Args:
        min_bound: Lowest corner [m], shape [3]; -inf leaves a side open.
        max_bound: Highest corner [m], shape [3].

    Raises:
        ValueError: A bound is NaN, or the lowest corner is above the highest.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> ground = loom.AxisAlignedBoundingBox([-np.inf, -np.inf, 0.0], [np.inf, np.inf, 0.2])
        >>> len(loom.PointCloud([[5, 5, 0.1], [5, 5, 1]]).crop(ground))
        1
    """

    min_bound: NDArray[np.float64]
    max_bound: NDArray[np.float64]

    def __init__(self, min_bound: ArrayLike, max_bound: ArrayLike):
        low, high = check_shape("min_bound", min_bound, (3,)), check_shape("max_bound", max_bound, (3,))
        if np.isnan(low).any() or np.isnan(high).any() or (low > high).any():
            raise ValueError(f"min_bound, max_bound: expected min <= max, got {low.tolist()} and {high.tolist()}")
        object.__setattr__(self, "min_bound", low)
        object.__setattr__(self, "max_bound", high)


@dataclass(frozen=True, init=False)
class OrientedBoundingBox:
    """A turned box.

    Args:
        center: Its middle [m], shape [3].
        R: Rotation, shape [3, 3]; its columns are the box's axes.
        extent: Full lengths along the axes [m], shape [3].

    Raises:
        ValueError: R is no rotation, or an extent is negative or not finite.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> R = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
        >>> beam = loom.OrientedBoundingBox([0, 0, 0], R, [10, 0.2, 0.2])
        >>> len(loom.PointCloud([[2.4, 3.2, 0], [3.2, 2.4, 0]]).crop(beam))
        1
    """

    center: NDArray[np.float64]
    R: NDArray[np.float64]
    extent: NDArray[np.float64]

    def __init__(self, center: ArrayLike, R: ArrayLike, extent: Any):
        T = np.eye(4)
        T[:3, :3] = check_shape("R", R, (3, 3))
        check_rigid("R", T, tolerance=1e-4)
        middle, lengths = check_shape("center", center, (3,)), check_shape("extent", extent, (3,))
        if not np.isfinite(middle).all() or not np.isfinite(lengths).all() or (lengths < 0).any():
            raise ValueError(f"center, extent: expected finite numbers, extent >= 0, got {middle} and {lengths}")
        object.__setattr__(self, "center", middle)
        object.__setattr__(self, "R", T[:3, :3])
        object.__setattr__(self, "extent", lengths)
