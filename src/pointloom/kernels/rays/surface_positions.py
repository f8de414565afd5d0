"""Barycentric positions of points on a surface, to transfer values between meshes. Exact on corners and edges."""

from ..algebra.transform import narrow
from ..array_types import Points, Triangles
from ..lang import array, compute, int32, kernel, launch, tid, vec3, vec3d, vec3i
from ..memory import empty
from ..meshes.mixed_rows import MixedRows
from .closest_points import measure_row
from .nearest_triangle import NearestTriangles
from .point_triangle import point_at
from .triangle_tree import TriangleTree, find_middles_kernel


@kernel
def project_to_surface_kernel(
    queries: array(dtype=vec3),
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    nearest: NearestTriangles,
    chosen: array(dtype=int32),
    mixed: MixedRows,
    points: array(dtype=vec3),
):
    """Triangle, corners, weights and nearest point. A non-finite query is kept, at triangle 0."""
    i = tid()
    triangle = max(nearest.triangles[i], 0)
    chosen[i] = triangle
    t = triangles[triangle]
    mixed.rows[i] = t
    mixed.weights[i] = vec3d(1.0, 0.0, 0.0)
    points[i] = queries[i]
    if nearest.triangles[i] >= 0:
        measured = measure_row(queries[i], vertices, triangles, triangle)
        mixed.weights[i] = vec3d(1.0 - measured[0] - measured[1], measured[0], measured[1])
        points[i] = narrow(point_at(vertices[t[0]], vertices[t[1]], vertices[t[2]], measured[0], measured[1]))


class SurfacePositions:
    """Positions on a tree's triangles: nearest `triangles` int32 (n), `mixed` MixedRows, nearest `points` (n)."""

    def __init__(self, queries: Points, tree: TriangleTree) -> None:
        device, count = queries.device, queries.size
        nearest = NearestTriangles(queries)
        nearest.search(tree, queries, 0)
        self.triangles, self.points = empty(count, int32, device), empty(count, vec3, device)
        self.mixed = MixedRows(empty(count, vec3i, device), empty(count, vec3d, device))
        mesh = (tree.vertices, tree.triangles)
        launch(project_to_surface_kernel, count, [queries, *mesh, nearest, self.triangles, self.mixed, self.points])


def middles_of(vertices: Points, triangles: Triangles) -> Points:
    """Center of each triangle, vec3. NaN for non-finite corners."""
    return compute(find_middles_kernel, triangles.size, [vertices, triangles], vec3, vertices.device)
