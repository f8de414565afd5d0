"""Convex hulls of positions: Qhull on those that the kernels could not rule out, and hulls that are flat."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..core.known_names import ToldNames
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.select import gather_rows, positions_of
from ..kernels.extent.hull_filter import farthest_rows, gather_positions, mask_outer, scale_points
from ..kernels.lang import int32
from ..kernels.linear_algebra import matmul
from ..kernels.memory import download, upload

if TYPE_CHECKING:
    from scipy.spatial import ConvexHull as Qhull

FEW = 5000  # points that Qhull takes about as long for as one round of the filter
ROUNDS = ((8, 32), (32, 96))  # cells, and nodes of the table, along an edge of the cube's faces: coarse, then fine
FLAT = 1e-6  # of the size: where Qhull finds no body, points this near to a plane or a line are taken to lie on it
ROUNDING = 5e-7  # of the largest coordinate: float32 moves points by up to 1e-7, the plane through three of them more


@dataclass(frozen=True, eq=False)
class ConvexHull(ToldNames):
    """The smallest convex body around points: a closed surface of triangles, counter-clockwise seen from outside.

    `loom.TriangleMesh(hull.vertices, hull.triangles)` makes a mesh of it.

    Attributes:
        vertices: Shape [m, 3], world coordinates [m].
        triangles: int32 [t, 3], rows of `vertices`; a flat hull has each of its triangles twice, once a side.
        volume: [m^3]; 0 for a flat hull.
        area: Of the surface [m^2]; a flat hull counts both sides.

    Example:
        >>> import pointloom as loom
        >>> cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        >>> hull, indices = loom.PointCloud([*cube, [0.5, 0.5, 0.5]]).compute_convex_hull()
        >>> hull
        ConvexHull(8 vertices, 12 triangles, volume 1, area 6)
        >>> indices.tolist()
        [0, 1, 2, 3, 4, 5, 6, 7]
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
    """The points that a camera sees, joined by triangles that face it.

    `loom.TriangleMesh(surface.vertices, surface.triangles)` makes a mesh of it.

    Attributes:
        vertices: Shape [m, 3], the visible points' world coordinates [m].
        triangles: int32 [t, 3], rows of `vertices`, counter-clockwise seen from the camera.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.1, 0.1, -5]])
        >>> surface, indices = cloud.hidden_point_removal([0.2, 0.2, 3], 100)
        >>> surface, indices.tolist()
        (VisibleSurface(3 vertices, 1 triangles), [0, 1, 2])
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int32]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self.vertices):,} vertices, {len(self.triangles):,} triangles)"


@dataclass(frozen=True, eq=False)
class Extremes:
    """What the hull of some positions consists of, whatever its dimension.

    Attributes:
        rows: int64 [m], the vertices among the positions, ascending.
        triangles: int32 [t, 3], rows of `rows`; none where the positions lie on a line.
        dimension: 3 a body, 2 a polygon, 1 a segment, 0 a point.
        normals: Shape [t, 3], unit and outward, of a body's triangles; those of one facet are equal.
        volume: Of the body.
        area: Of its surface.
    """

    rows: NDArray[np.int64]
    triangles: NDArray[np.int32]
    dimension: int
    normals: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 3)))
    volume: float = 0.0
    area: float = 0.0


def find_extremes(positions: NDArray[np.float64], joggle: bool = False, rounding: float = 0.0) -> Extremes:
    """The hull of finite positions of shape [n, 3], n > 0, by Qhull (Barber et al. 1996) with triangulated facets.

    Where Qhull finds no body the hull is that of the points in their plane, then on their line.

    Args:
        positions: Shape [n, 3].
        joggle: Move them a little instead of merging facets.
        rounding: Points that lie this near to a plane or a line are taken to lie on it.
    """
    flat = _find_flat_extremes(positions, rounding) if rounding > 0 else None
    if flat is not None:
        return flat
    hull = _run_qhull(positions, "QJ" if joggle else "Qt")
    if hull is None:
        flat = _find_flat_extremes(positions, FLAT * float(np.ptp(positions, axis=0).max()))
        if flat is not None:
            return flat
        hull = _run_qhull(positions, "QJ")  # a body that Qhull has given up on for its rounding
        if hull is None:
            raise ValueError("points: Qhull finds no hull, not even of joggled points; scale them to about 1")
    used = np.zeros(len(positions), bool)
    used[hull.simplices] = True
    places = np.cumsum(used, dtype=np.int32) - np.int32(1)
    triangles = places[orient(hull.simplices, positions, hull.equations)]
    normals = np.ascontiguousarray(hull.equations[:, :3])
    return Extremes(np.flatnonzero(used), triangles, 3, normals, float(hull.volume), float(hull.area))


def _run_qhull(positions: NDArray[np.float64], options: str) -> Qhull | None:
    """Qhull's answer; None where it finds its input flat, too small or too imprecise."""
    from scipy.spatial import ConvexHull, QhullError  # loads for longer than all that a first cloud needs

    try:
        return ConvexHull(positions, qhull_options=options)
    except QhullError:
        return None


def _find_flat_extremes(positions: NDArray[np.float64], tolerance: float) -> Extremes | None:
    """The hull of positions in a plane, on a line or in one place; None for a body."""
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
        places = matmul(arms, along)
        return Extremes(np.array(sorted({int(places.argmin()), int(places.argmax())})), none, 1)
    aside = across[widths.argmax()] / widths.max()
    if len(positions) > 3 and np.abs(matmul(arms, np.cross(along, aside))).max() > tolerance:
        return None
    hull = _run_qhull(np.column_stack([matmul(arms, along), matmul(arms, aside)]), "Qt")
    assert hull is not None  # not all are on a line
    rows = np.sort(hull.vertices).astype(np.int64)
    ring = np.searchsorted(rows, hull.vertices).astype(np.int32)
    fan = np.column_stack([np.full(len(ring) - 2, ring[0]), ring[1:-1], ring[2:]])
    return Extremes(rows, np.concatenate([fan, fan[:, ::-1]]), 2, area=2 * float(hull.volume))


def orient(
    triangles: NDArray[np.int32], positions: NDArray[np.float64], planes: NDArray[np.float64]
) -> NDArray[np.int32]:
    """Qhull's triangles with their corners counter-clockwise seen from where their planes' normals point."""
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    backward = np.einsum("ij,ij->i", np.cross(b - a, c - a), planes[:, :3]) < 0
    turned = triangles.copy()
    turned[backward, 1:] = triangles[backward, 2:0:-1]
    return turned


def hull_of_cloud(points: wp.array, joggle: bool = False) -> tuple[Extremes, NDArray[np.int64], NDArray[np.float64]]:
    """The hull of a device array of vec3.

    Returns:
        What it consists of, as rows of the points that could not be ruled out; their indices; and their positions,
        float64 [m, 3]. A convex body that holds these holds all points.

    Raises:
        ValueError: No point is finite.
    """
    low, high, finite = bound_points(points)
    if not finite:
        raise ValueError("points: expected at least one finite point, got none")
    low, high = low.astype(np.float64), high.astype(np.float64)
    half = (high - low) / 2
    rows = np.arange(points.size)
    if points.size >= FEW and (half > 0).all():
        scaled = scale_points(points, (low + high) / 2, 1 / half)
        rows = outer_rows(scaled)
    near = download(gather_rows(points, upload(rows, int32, points.device))).astype(np.float64)
    kept = np.isfinite(near).all(axis=1)
    rows, near = rows[kept], near[kept]
    return find_extremes(near, joggle, ROUNDING * float(np.abs(near).max())), rows, near


def outer_rows(points: wp.array) -> NDArray[np.int64]:
    """The rows that can be vertices of the hull of a device array of vec3d, ascending; a few inner ones among them.

    Points that are not finite are left out once there are enough points for a round.
    """
    rows: wp.array | None = None
    centre = np.zeros(3)
    for cells, width in ROUNDS:
        if points.size < FEW:
            break
        chosen = farthest_rows(points, centre, cells)
        corners = download(gather_positions(points, upload(chosen, int32, points.device)))  # sync
        hull = _run_qhull(corners, "Qt")
        if hull is None:  # flat, or nearly: all points may be needed
            break
        centre = corners[hull.vertices].mean(axis=0)
        facets = corners[orient(hull.simplices, corners, hull.equations)]
        left = positions_of(mask_outer(points, centre, facets, hull.equations, width))  # sync
        rows = left if rows is None else gather_rows(rows, left)
        points = gather_positions(points, left)
    return np.arange(points.size) if rows is None else download(rows).astype(np.int64)
