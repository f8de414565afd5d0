"""Signed distances from open surfaces, positive on the side that triangles face.

The sign is that of the angle-weighted pseudonormal at the nearest point (pseudonormals.py), remeasured in float64.
Points whose nearest point is on the boundary are flagged.
"""

from ..algebra.transform import widen
from ..array_types import Doubles, Mask, Points, Triangles
from ..lang import NAN, array, float64, isfinite, kernel, launch, sqrt, tid, uint8, vec3
from ..memory import empty, zeros
from ..meshes.pseudonormals import Pseudonormals, side_of_part
from .closest_points import measure_row
from .nearest_triangle import NearestTriangles
from .point_triangle import point_at
from .triangle_tree import TriangleTree


@kernel
def mark_rim_kernel(sides: Pseudonormals, rim: array(dtype=uint8)):
    """Flag the vertices of edges with one or more than two triangles. All writers write 1."""
    i = tid()
    if sides.twins[i] < 0:
        t = sides.triangles[i // 3]
        rim[t[i % 3]] = uint8(1)
        rim[t[(i + 1) % 3]] = uint8(1)


@kernel
def face_distances_kernel(
    queries: array(dtype=vec3),
    nearest: NearestTriangles,
    sides: Pseudonormals,
    rim: array(dtype=uint8),
    distances: array(dtype=float64),
    beside: array(dtype=uint8),
):
    """Signed distance of each query, and a flag if the nearest point is on the boundary."""
    i = tid()
    triangle = nearest.triangles[i]
    q = queries[i]
    distance = float64(NAN)
    is_beside = 0
    if triangle >= 0 and isfinite(q):
        measured = measure_row(q, sides.vertices, sides.triangles, triangle)
        t = sides.triangles[triangle]
        part = int(measured[2])
        point = point_at(sides.vertices[t[0]], sides.vertices[t[1]], sides.vertices[t[2]], measured[0], measured[1])
        if part == 0:
            point = widen(sides.vertices[t[0]])  # on the same plane, exact
        distance = sqrt(nearest.sqdists[i])
        if part > 3:
            is_beside = int(rim[t[part - 4]])
        elif part > 0:
            if sides.twins[3 * triangle + part - 1] < 0:
                is_beside = 1
        if side_of_part(widen(q) - point, triangle, part, sides) < 0.0:
            distance = -distance
    distances[i] = distance
    beside[i] = uint8(is_beside)


def face_distances(tree: TriangleTree, vertices: Points, triangles: Triangles, queries: Points) -> tuple[Doubles, Mask]:
    """Signed distances [m], float64 (n), and boundary flags, uint8 (n). NaN for non-finite queries."""
    nearest = NearestTriangles(queries)
    nearest.search(tree, queries, 0)
    sides, rim = Pseudonormals(vertices, triangles, 1.0), zeros(vertices.size, uint8, queries.device)
    launch(mark_rim_kernel, sides.twins.size, [sides, rim])
    distances, beside = empty(queries.size, float64, queries.device), empty(queries.size, uint8, queries.device)
    launch(face_distances_kernel, queries.size, [queries, nearest, sides, rim, distances, beside])
    return distances, beside
