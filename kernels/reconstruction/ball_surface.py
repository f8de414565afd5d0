"""Ball pivoting without an order: radius by radius, the triangles of all empty balls, and their conflicts settled.

The triangles on which an empty ball of one radius rests are faces of the Delaunay tetrahedra, so no two of them cut
through each other; ball_faces.py finds them, ball_conflicts.py settles who takes an edge. A larger radius is for what
the smaller ones left: points without a triangle, and those of edges with one triangle.

20 B a point for a second tree where some points take no part; 100 B a point for each radius, and 60 B a half-edge.
"""

from collections.abc import Callable, Iterable

from ..algebra.transform import widen
from ..array_types import Indices, Mask, Points, Triangles, Vectors
from ..arrays.concatenation import concatenate_rows
from ..arrays.select import gather_rows, positions_of_each
from ..arrays.sort import argsort_keys, positions
from ..lang import array, dot, func, int32, int64, isfinite, kernel, launch, tid, uint8, vec3, vec3i
from ..memory import download, empty, full, zeros
from ..meshes.mesh_edits import gather_triangles
from ..sampling.duplicates import first_occurrences, same_point
from ..search.point_tree import PointTree
from ..search.tree_search import count_within_kernel, reach_of
from .ball_conflicts import BallMesh, close_radius, settle_conflicts
from .ball_faces import BallPoints, list_faces

SAMPLE = 64  # points by which the number of neighbours is guessed


@kernel
def mark_facing_kernel(points: array(dtype=vec3), normals: array(dtype=vec3), facing: array(dtype=uint8)):
    """1 at points that are finite and have a normal."""
    i = tid()
    n = widen(normals[i])
    valid = 0
    if isfinite(points[i]) and isfinite(normals[i]):
        if dot(n, n) > 0.0:
            valid = 1
    facing[i] = uint8(valid)


@kernel
def mark_repeated_kernel(points: array(dtype=vec3), marks: array(dtype=uint8)):
    """1 where a point in the tree's order equals the one before."""
    i = tid()
    repeated = 0
    if i > 0:
        repeated = same_point(points[i - 1], points[i])
    marks[i] = uint8(repeated)


@func
def turned_first(t: vec3i) -> vec3i:
    """The triangle from its lowest vertex on."""
    first = t + vec3i(0, 0, 0)
    if t[1] < t[0] and t[1] < t[2]:
        first = vec3i(t[1], t[2], t[0])
    if t[2] < t[0] and t[2] < t[1]:
        first = vec3i(t[2], t[0], t[1])
    return first


@kernel
def name_corners_kernel(rows: array(dtype=int32), bits: int, triangles: array(dtype=vec3i), keys: array(dtype=int64)):
    """Name corners by rows, not places, the lowest first; the key is the first edge, which no other has."""
    i = tid()
    t = triangles[i]
    named = turned_first(vec3i(rows[t[0]], rows[t[1]], rows[t[2]]))
    triangles[i] = named
    keys[i] = (int64(named[0]) << int64(bits)) | int64(named[1])


@kernel
def sample_points_kernel(points: array(dtype=vec3), places: array(dtype=int32), step: int, sample: array(dtype=vec3)):
    """The points at every so-many-th place."""
    i = tid()
    sample[i] = points[places[i * step]]


def count_around(tree: PointTree, places: Indices, radius: float) -> float:
    """The mean number of points within a radius [m] of points at some places in a tree, of at most SAMPLE of these."""
    step = -(-places.size // SAMPLE)
    size = -(-places.size // step)
    sample, counts = empty(size, vec3, tree.device), empty(size, int32, tree.device)
    launch(sample_points_kernel, size, [tree.points, places, step, sample])
    launch(count_within_kernel, size, [sample, positions(size, tree.device), tree, reach_of(radius), counts])
    return float(download(counts).mean())  # sync


class RollingBall:
    """The points of a cloud that balls roll over: finite, with a normal, the first of those at one place.

    Args:
        points, normals: Device arrays of vec3 [n].
        grown: A function that gives the tree over the points.

    Attributes:
        tree: A PointTree over those that take part.
        rows: int32, their rows by place in the tree.
        normals: By place.
    """

    def __init__(self, points: Points, normals: Vectors, grown: Callable[[], PointTree]) -> None:
        device = points.device
        facing = empty(points.size, uint8, device)
        launch(mark_facing_kernel, points.size, [points, normals, facing])
        self.tree = grown() if points.size else PointTree(empty(0, vec3, device))
        rows, repeated = positions_of_each(facing, self._mark_repeated())  # sync
        if rows.size < self.tree.count or repeated.size:
            if rows.size:
                rows = gather_rows(rows, first_occurrences(gather_rows(points, rows)))
            self.tree = PointTree(gather_rows(points, rows))
            self.rows = gather_rows(rows, self.tree.order)
        else:
            self.rows = self.tree.order
        self.normals = gather_rows(normals, self.rows[: self.tree.count]) if self.tree.count else empty(0, vec3, device)

    def _mark_repeated(self) -> Mask:
        """1 where points that follow each other in the tree are equal; others that are do no harm but to time."""
        marks = empty(self.tree.count, uint8, self.tree.device)
        launch(mark_repeated_kernel, self.tree.count, [self.tree.points, marks])
        return marks

    def roll(
        self, radii: Iterable[float], row_count: int, check: Callable[[PointTree, float, Indices], None]
    ) -> Triangles:
        """The triangles of balls of these radii [m], one after the other.

        Args:
            radii: Positive numbers.
            row_count: Rows of the cloud.
            check: Called with each radius and the places it is for, before it is searched; refuses what takes too long.

        Returns:
            vec3i [t], rows of the cloud, by ascending first and second corner; the first is the lowest of the three.
        """
        device, count = self.tree.device, self.tree.count
        asked, seen = full(count, 1, uint8, device), zeros(count, uint8, device)
        open, parts = empty(0, vec3i, device), []
        places = positions(count, device)
        for radius in radii:
            if not places.size:
                break
            check(self.tree, radius, places)
            found, widths = list_faces(BallPoints(self.tree, self.normals, asked, radius), places)
            mesh = BallMesh(open, found, widths, seen, self.rows)
            settle_conflicts(mesh, open.size)
            open, closed, places = close_radius(mesh, asked)  # sync
            parts.append(closed)
        triangles = concatenate_rows([*parts, open])
        bits = max(1, row_count.bit_length())
        keys = empty(triangles.size, int64, device)
        launch(name_corners_kernel, triangles.size, [self.rows, bits, triangles, keys])
        return gather_triangles(triangles, argsort_keys(keys, 2 * bits)[1])
