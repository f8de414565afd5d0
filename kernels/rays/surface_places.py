"""Where points stand on a surface: the nearest triangle of each, and the point there as weights of its corners.

What carries values from one mesh to another of the same shape, and draws points back onto a surface. Measured once more
in float64 against the triangle that nearest_triangle.py found; a point on a corner or an edge has weights of exactly 0
and 1 there. 60 B a point beside the search.
"""

from ..algebra.transform import narrow
from ..array_types import Points, Triangles
from ..lang import array, int32, kernel, launch, tid, vec3, vec3d, vec3i
from ..memory import empty
from ..meshes.mixed_rows import MixedRows
from .closest_points import measure_row
from .nearest_triangle import NearestTriangles
from .point_triangle import point_at
from .triangle_tree import TriangleTree, find_middles_kernel


@kernel
def place_on_surface_kernel(
    queries: array(dtype=vec3),
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    nearest: NearestTriangles,
    chosen: array(dtype=int32),
    places: MixedRows,
    points: array(dtype=vec3),
):
    """The triangle, its corners, their weights and the point; a query that is not finite stays, at triangle 0."""
    i = tid()
    triangle = max(nearest.triangles[i], 0)
    chosen[i] = triangle
    t = triangles[triangle]
    places.rows[i] = t
    places.weights[i] = vec3d(1.0, 0.0, 0.0)
    points[i] = queries[i]
    if nearest.triangles[i] >= 0:
        found = measure_row(queries[i], vertices, triangles, triangle)
        places.weights[i] = vec3d(1.0 - found[0] - found[1], found[0], found[1])
        points[i] = narrow(point_at(vertices[t[0]], vertices[t[1]], vertices[t[2]], found[0], found[1]))


class SurfacePlaces:
    """Where vec3 points about a tree's origin stand on its triangles, of which there is at least one.

    Attributes:
        triangles: int32 [n], the nearest triangle of each.
        mixed: MixedRows of the old vertices.
        points: vec3 [n], the nearest points.
    """

    def __init__(self, queries: Points, tree: TriangleTree) -> None:
        """No sync."""
        device, count = queries.device, queries.size
        nearest = NearestTriangles(queries)
        nearest.look_into(tree, queries, 0)
        self.triangles, self.points = empty(count, int32, device), empty(count, vec3, device)
        self.mixed = MixedRows(empty(count, vec3i, device), empty(count, vec3d, device))
        mesh = (tree.vertices, tree.triangles)
        launch(place_on_surface_kernel, count, [queries, *mesh, nearest, self.triangles, self.mixed, self.points])


def middles_of(vertices: Points, triangles: Triangles) -> Points:
    """The middle of each triangle, vec3; NaN where a corner is not finite."""
    middles = empty(triangles.size, vec3, vertices.device)
    launch(find_middles_kernel, triangles.size, [vertices, triangles, middles])
    return middles
