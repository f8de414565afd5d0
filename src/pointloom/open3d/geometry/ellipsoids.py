"""OrientedBoundingEllipsoid, changed in place as in Open3D, and the ellipsoid of smallest volume around points."""

from __future__ import annotations

import math
from itertools import permutations, product
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import ConvexHull, QhullError

from ...core.checks import check_number, check_rigid, check_shape
from ...kernels.linear_algebra import det, eigh, inv, matmul
from ..wrapper import as_array, column
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox, Row, Value, _row
from .geometry import Geometry3D

ITERATIONS = 1000  # those of Open3D, which mostly end the search
TOLERANCE = 1e-6  # of the change of the weights in an iteration
FEWEST = 4  # points


class OrientedBoundingEllipsoid(Geometry3D):
    """An ellipsoid with assignable `center`, `R` (axes as columns), `radii` and `color`."""

    center = Value(3)
    R = Value(3, 3)
    radii = Value(3)
    color = Value(3)

    def __init__(self, center: Any = (0, 0, 0), R: ArrayLike | None = None, radii: ArrayLike = (0, 0, 0)):
        self._shared = {}
        if isinstance(center, OrientedBoundingEllipsoid):
            self._wrapped = center.__copy__()._wrapped
            return
        axes = np.eye(3) if R is None else _rotation(R)
        middle, lengths = (column(name, values).astype(np.float64) for name, values in
                           (("center", center), ("radii", radii)))  # fmt: skip
        self._wrapped = {"center": middle, "R": axes, "radii": lengths, "color": np.ones(3)}

    def _parts(self) -> dict[str, Row]:
        return self._wrapped

    def _set(self, **parts: Row) -> Self:
        """Replace some of center, R and radii."""
        self._wrapped = self._wrapped | parts
        return self

    @classmethod
    def create_from_points(cls, points: Any, robust: bool = False) -> Self:
        """Ellipsoid of smallest volume around points. See `fit_ellipsoid`."""
        return cls(*fit_ellipsoid(as_array(points), robust))

    def volume(self) -> float:
        return float(4 / 3 * math.pi * np.prod(self.radii))

    def is_empty(self) -> bool:
        return self.volume() <= 0

    def clear(self) -> Self:
        """Reset to an empty ellipsoid at zero."""
        return self._set(center=np.zeros(3), R=np.eye(3), radii=np.zeros(3), color=np.ones(3))

    def get_center(self) -> Row:
        return np.array(self.center)

    def _ends(self) -> NDArray[np.float64]:
        """The six ends of the axes, which determine the boxes, as in Open3D."""
        arms = (self.R * self.radii).T
        return np.concatenate([self.center + arms, self.center - arms])

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Box of the six ends of the axes, as in Open3D: smaller than that of a rotated ellipsoid."""
        return AxisAlignedBoundingBox.create_from_points(self._ends())

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box along the axes, the longest first."""
        order = np.argsort(-np.abs(self.radii), kind="stable")
        axes = self.R[:, order]
        axes[:, 2] *= np.sign(det(axes))
        return OrientedBoundingBox(self.center, axes, 2 * np.abs(self.radii)[order])

    get_minimal_oriented_bounding_box = get_oriented_bounding_box

    def get_min_bound(self) -> Row:
        return np.array(self.get_axis_aligned_bounding_box().min_bound)

    def get_max_bound(self) -> Row:
        return np.array(self.get_axis_aligned_bounding_box().max_bound)

    def transform(self, arg0: ArrayLike) -> Self:
        """Always raises RuntimeError, as in Open3D."""
        raise RuntimeError(
            "transform: an ellipsoid cannot be transformed by a 4x4 matrix. Use ellipsoid.rotate(R, center) and "
            "ellipsoid.translate(t)"
        )

    def translate(self, translation: ArrayLike, relative: bool = True) -> Self:
        """Translate by a vector. With `relative=False`, move the center there."""
        step = column("translation", translation).astype(np.float64)
        return self._set(center=self.center + step if relative else step)

    def scale(self, scale: float, center: ArrayLike) -> Self:
        """Scale about a point."""
        factor, about = check_number("scale", scale), column("center", center)
        return self._set(center=about + factor * (self.center - about), radii=factor * self.radii)

    def rotate(self, R: ArrayLike, center: Any = None) -> Self:
        """Rotate about a point, by default the center."""
        turn = _rotation(R)
        about = self.center if center is None else column("center", center)
        return self._set(center=about + matmul(turn, self.center - about), R=matmul(turn, self.R))

    def __copy__(self) -> Self:
        return self._of({name: values.copy() for name, values in self._wrapped.items()})

    def __repr__(self) -> str:
        return f"OrientedBoundingEllipsoid: center: {_row(self.center)}, radii: {_row(self.radii)[1:]}"


def fit_ellipsoid(points: NDArray[np.floating], robust: bool) -> tuple[Row, Row, Row]:
    """Center, axes as columns, and radii of the ellipsoid of smallest volume around the finite points.

    The axes are in the order, and have the signs, that are nearest to the axes of coordinates. As in Open3D, the search
    ends after 1000 iterations, with points up to about 1% outside.

    Args:
        points: Coordinates (n, 3).
        robust: Let Qhull joggle its input for the convex hull. The points themselves are unchanged.

    Raises:
        ValueError: There are fewer than 4 finite points, or they are on one plane.

    References:
        Khachiyan, "Rounding of polytopes in the real number model of computation", Mathematics of Operations Research,
        1996.
    """
    rows = np.asarray(points, np.float64).reshape(-1, 3)
    rows = rows[np.isfinite(rows).all(axis=1)]
    if len(rows) < FEWEST:
        raise ValueError(f"points: expected at least {FEWEST} finite points, got {len(rows)}")
    origin = rows[0]
    try:
        corners = rows[ConvexHull(rows - origin, qhull_options="QJ" if robust else "Qt").vertices] - origin
        weights = _weights(corners)
    except (QhullError, np.linalg.LinAlgError) as error:
        raise ValueError("points: expected points that are not on one plane") from error
    center = (corners * weights[:, None]).sum(axis=0)
    offsets = corners - center
    values, vectors = eigh(matmul((offsets * weights[:, None]).T, offsets))
    axes, radii = _nearest_order(vectors, np.sqrt(3 * np.maximum(values, 0.0)))
    return origin + center, axes, radii


def _weights(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Weights of points, of sum 1, whose weighted covariance is that of the smallest ellipsoid up to a factor."""
    count, dimension = corners.shape
    lifted = np.column_stack([corners, np.ones(count)])
    weights = np.full(count, 1 / count)
    for _ in range(ITERATIONS):
        moments = matmul((lifted * weights[:, None]).T, lifted)
        distances = (matmul(lifted, inv(moments)) * lifted).sum(axis=1)
        farthest = int(distances.argmax())
        largest = float(distances[farthest])
        step = (largest - dimension - 1) / ((dimension + 1) * (largest - 1))
        change = -step * weights
        change[farthest] += step
        weights = weights + change
        if math.sqrt(float((change * change).sum())) < TOLERANCE:
            break
    return weights


def _nearest_order(axes: NDArray[np.float64], radii: Row) -> tuple[Row, Row]:
    """The axes in the order and with the signs of the right-handed matrix with the largest trace, and the radii."""
    candidates = [
        (axes[:, order] * signs, radii[list(order)])
        for order in map(list, permutations(range(3)))
        for signs in product((1.0, -1.0), repeat=3)
    ]
    return max((c for c in candidates if det(c[0]) > 0), key=lambda candidate: float(np.trace(candidate[0])))


def _rotation(R: ArrayLike) -> NDArray[np.float64]:
    """A checked rotation matrix (3, 3)."""
    T = np.eye(4)
    T[:3, :3] = check_shape("R", R, (3, 3))
    return check_rigid("R", T)[:3, :3]
