"""Convex hulls by Qhull after a prefilter on the device, including flat ones."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..core.attribute_hints import HintedNames
from ..core.coordinates import finite_rows
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.select import gather_rows, positions_of
from ..kernels.extent.central_hull import find_central_hull
from ..kernels.extent.hull_filter import farthest_rows, mask_outer, scale_points
from ..kernels.lang import int32
from ..kernels.linear_algebra import matmul
from ..kernels.memory import download, upload

if TYPE_CHECKING:
    from scipy.spatial import ConvexHull as Qhull

MAX_UNFILTERED_POINTS = 5000  # points for which Qhull takes about as long as one filter round
FILTER_ROUNDS = ((8, 32), (32, 96))  # cells, and table nodes, along an edge of the cube's faces: coarse, then fine
FLATNESS_TOLERANCE = 1e-6  # of the size: tolerance of coplanar and collinear points if Qhull finds no body
COORDINATE_ROUNDING = 5e-7  # of the largest coordinate: float32 moves points by 1e-7, planes through three of them more


@dataclass(frozen=True, eq=False)
class ConvexHull(HintedNames):
    """Convex hull: a closed surface, counterclockwise from outside; `loom.TriangleMesh(hull.vertices, hull.triangles)`.

    Attributes:
        vertices: World coordinates [m], shape (m, 3).
        triangles: int32 (t, 3). A flat hull has each triangle twice, once per side.
        volume, area: [m^3], 0 for a flat hull; [m^2], both sides for a flat hull.
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int32]
    volume: float
    area: float

    def __repr__(self) -> str:
        counts = f"{len(self.vertices):,} vertices, {len(self.triangles):,} triangles"
        return f"{type(self).__name__}({counts}, volume {self.volume:.6g}, area {self.area:.6g})"


@dataclass(frozen=True, eq=False)
class VisibleSurface:
    """Points visible from a camera, with triangles facing it: `loom.TriangleMesh(surface.vertices, surface.triangles)`.

    Attributes:
        vertices: World coordinates of the visible points [m], shape (m, 3).
        triangles: int32 (t, 3), counterclockwise from the camera.
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int32]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self.vertices):,} vertices, {len(self.triangles):,} triangles)"


@dataclass(frozen=True, eq=False)
class Extremes:
    """Vertices (`rows`, ascending) and triangles (rows of `rows`) of a hull of dimension 0 to 3. `normals` (t, 3) are
    unit and outward, equal within a facet."""

    rows: NDArray[np.int64]
    triangles: NDArray[np.int32]
    dimension: int
    normals: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 3)))
    volume: float = 0.0
    area: float = 0.0


def find_extremes(positions: NDArray[np.float64], joggle: bool = False, rounding: float = 0.0) -> Extremes:
    """Hull of finite positions (n, 3), n > 0, also if flat. Points within `rounding` of a plane or line count as on it.
    By a kernel, or by Qhull (Barber et al. 1996) if points are coplanar with a facet up to rounding;
    `joggle` perturbs them then instead of merging facets."""
    body = None if joggle else _find_simplicial_body(positions, rounding)
    if body is not None:
        return body
    flat = _find_flat_extremes(positions, rounding) if rounding > 0 else None
    if flat is not None:
        return flat
    hull = _run_qhull(positions, "QJ" if joggle else "Qt")
    if hull is None:
        flat = _find_flat_extremes(positions, FLATNESS_TOLERANCE * float(np.ptp(positions, axis=0).max()))
        if flat is not None:
            return flat
        hull = _run_qhull(positions, "QJ")  # for bodies that Qhull rejects for rounding
        if hull is None:
            raise ValueError("points: Qhull finds no hull, even of joggled points. Scale the coordinates to about 1")
    used = np.zeros(len(positions), bool)
    used[hull.simplices] = True
    new_indices = np.cumsum(used, dtype=np.int32) - np.int32(1)
    triangles = new_indices[orient(hull.simplices, positions, hull.equations)]
    normals = np.ascontiguousarray(hull.equations[:, :3])
    return Extremes(np.flatnonzero(used), triangles, 3, normals, float(hull.volume), float(hull.area))


def _find_simplicial_body(positions: NDArray[np.float64], rounding: float) -> Extremes | None:
    """Hull of a body if all facets are certain triangles, and no plane is within `rounding` of all points."""
    on_sides = max((column == end).sum() for column in positions.T for end in (column.min(), column.max()))
    if len(positions) < 4 or on_sides > 3:  # more than a triangle on a side of the box is not certain
        return None
    center = positions.mean(axis=0).astype(np.float32).astype(np.float64)  # differences of float32 numbers are exact
    arms = positions - center
    triangles = find_central_hull(arms)
    if triangles is None or not len(triangles) or triangles.min() < 0:
        return None
    a, b, c = arms[triangles[:, 0]], arms[triangles[:, 1]], arms[triangles[:, 2]]
    normals = _cross_rows(b - a, c - a)
    lengths = np.sqrt(np.einsum("ij,ij->i", normals, normals))
    area, volume = float(lengths.sum()) / 2, float(np.einsum("ij,ij->", a, normals)) / 6
    if not volume > rounding * area:  # a convex body between planes at distance w has at most w / 2 of its area
        return None
    used = np.zeros(len(positions), bool)
    used[triangles] = True
    new_indices = np.cumsum(used, dtype=np.int32) - np.int32(1)
    return Extremes(np.flatnonzero(used), new_indices[triangles], 3, normals / lengths[:, None], volume, area)


def find_outer_facets(positions: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    """Ascending vertices of the hull of the origin and finite positions, and its triangles without the origin (rows of
    the vertices). By Qhull if points are coplanar, up to rounding, with a facet."""
    count = len(positions)
    triangles = find_central_hull(positions)
    if triangles is not None:
        used = np.zeros(count, bool)
        used[triangles[triangles >= 0]] = True
        vertices, triangles = np.flatnonzero(used), triangles[(triangles >= 0).all(axis=1)]
        if len(triangles):
            new_indices = np.cumsum(used, dtype=np.int32) - np.int32(1)
            return vertices, new_indices[triangles]
    extremes = find_extremes(np.concatenate([positions, np.zeros((1, 3))]))
    vertices = extremes.rows[extremes.rows < count]
    return vertices, extremes.triangles[(extremes.triangles < len(vertices)).all(axis=1)]


def _run_qhull(positions: NDArray[np.float64], options: str) -> Qhull | None:
    """Qhull's result. None if the input is flat, too small or too imprecise."""
    from scipy.spatial import ConvexHull, QhullError  # slow import

    try:
        return ConvexHull(positions, qhull_options=options)
    except QhullError:
        return None


def _find_flat_extremes(positions: NDArray[np.float64], tolerance: float) -> Extremes | None:
    """Hull in a plane, on a line or at a point. None for a body."""
    none = np.zeros((0, 3), np.int32)
    first = positions[0]
    arms = positions - first
    lengths = np.linalg.norm(arms, axis=1)
    size = lengths.max()
    if size == 0:
        return Extremes(np.zeros(1, np.int64), none, 0)
    along = arms[lengths.argmax()] / size
    across = arms - np.outer(matmul(arms, along), along)
    widths = np.linalg.norm(across, axis=1)
    if widths.max() <= tolerance:
        coordinates = matmul(arms, along)
        return Extremes(np.array(sorted({int(coordinates.argmin()), int(coordinates.argmax())})), none, 1)
    perpendicular = across[widths.argmax()] / widths.max()
    if len(positions) > 3 and np.abs(matmul(arms, _cross_rows(along[None], perpendicular[None])[0])).max() > tolerance:
        return None
    hull = _run_qhull(np.column_stack([matmul(arms, along), matmul(arms, perpendicular)]), "Qt")
    assert hull is not None  # not collinear
    rows = np.sort(hull.vertices).astype(np.int64)
    ring = np.searchsorted(rows, hull.vertices).astype(np.int32)
    fan = np.column_stack([np.full(len(ring) - 2, ring[0]), ring[1:-1], ring[2:]])
    return Extremes(rows, np.concatenate([fan, fan[:, ::-1]]), 2, area=2 * float(hull.volume))


def orient(
    triangles: NDArray[np.int32], positions: NDArray[np.float64], planes: NDArray[np.float64]
) -> NDArray[np.int32]:
    """Orient Qhull's triangles counterclockwise seen from their normals' side."""
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    backward = np.einsum("ij,ij->i", _cross_rows(b - a, c - a), planes[:, :3]) < 0
    oriented = triangles.copy()
    oriented[backward, 1:] = triangles[backward, 2:0:-1]
    return oriented


def _cross_rows(u: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """`np.cross` of rows (n, 3), bitwise identical, in half the time for few rows."""
    crosses = np.empty_like(u)
    for k, (i, j) in enumerate(((1, 2), (2, 0), (0, 1))):
        crosses[:, k] = u[:, i] * v[:, j] - u[:, j] * v[:, i]
    return crosses


def hull_of_cloud(points: wp.array, joggle: bool = False) -> tuple[Extremes, NDArray[np.int64], NDArray[np.float64]]:
    """Hull of vec3 points: extremes, indices and positions of the candidate points. ValueError if none is finite."""
    rows, near = _candidates(points)
    is_finite = finite_rows(near)
    rows, near = rows[is_finite], near[is_finite]
    if not len(rows):
        raise ValueError("points: expected at least one finite point, got none")
    return find_extremes(near, joggle, COORDINATE_ROUNDING * float(np.abs(near).max())), rows, near


def _candidates(points: wp.array) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Ascending indices and positions of vec3 points among which are all finite hull vertices: all if there are few."""
    chosen, rows = points, np.arange(points.size)
    if points.size >= MAX_UNFILTERED_POINTS:
        low, high, count = bound_points(points)  # sync
        low, high = low.astype(np.float64), high.astype(np.float64)
        half = (high - low) / 2
        if count and (half > 0).all():
            rows = outer_rows(scale_points(points, (low + high) / 2, 1 / half))
            chosen = gather_rows(points, upload(rows, int32, points.device))
    return rows, download(chosen).astype(np.float64).reshape(-1, 3)  # sync


def outer_rows(points: wp.array) -> NDArray[np.int64]:
    """Ascending rows of vec3d points that may be hull vertices, including a few inner ones."""
    rows: wp.array | None = None
    center = np.zeros(3)
    for cells, width in FILTER_ROUNDS:
        if points.size < MAX_UNFILTERED_POINTS:
            break
        chosen = farthest_rows(points, center, cells)
        corners = download(gather_rows(points, upload(chosen, int32, points.device)))  # sync
        hull = _run_qhull(corners, "Qt")
        if hull is None:  # nearly flat: all points may be needed
            break
        center = corners[hull.vertices].mean(axis=0)
        facets = corners[orient(hull.simplices, corners, hull.equations)]
        outer = positions_of(mask_outer(points, center, facets, hull.equations, width))  # sync
        rows = outer if rows is None else gather_rows(rows, outer)
        points = gather_rows(points, outer)
    return np.arange(points.size) if rows is None else download(rows).astype(np.int64)
