"""Angle-weighted pseudonormals for the side of a point relative to a closed mesh.

Baerentzen and Aanaes, "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 2005, theorem 1:
the sign of (p - c) . N at the nearest point c. Requires a consistently oriented manifold without degenerate triangles
or self-intersections. 40 B per half-edge to build.
"""

from ..algebra.angles import angle_between
from ..algebra.transform import widen
from ..array_types import Points, Triangles
from ..arrays.side_by_side import read_together
from ..lang import (
    array,
    dot,
    float64,
    func,
    int32,
    kernel,
    launch,
    length,
    reduce,
    reduction,
    struct,
    tid,
    vec2d,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import download, empty, zeros
from .mesh_components import label_parts
from .mesh_measures import measure_triangle, triangle_cross
from .mesh_topology import CornersByVertex, find_topology, pair_edges_kernel, sorted_edges, topology_of

MIN_SINE_SQUARED = 1e-16  # sine squared of the angle at the first corner: below it float32 corners define no direction


@func
def unit_normal(vertices: array(dtype=vec3), t: vec3i) -> vec3d:
    """Unit normal of a triangle. Zero if it has no area."""
    n = triangle_cross(vertices, t)
    size = length(n)
    if size > 0.0:
        n = n / size
    return n


@reduction
def count_narrow(vertices: array(dtype=vec3), triangles: array(dtype=vec3i)) -> vec2d:
    """Number of triangles without area in float32 or with a non-finite corner."""
    i = tid()
    t = triangles[i]
    n = triangle_cross(vertices, t)
    a = widen(vertices[t[0]])
    b = widen(vertices[t[1]]) - a
    c = widen(vertices[t[2]]) - a
    narrow = float64(1.0)
    if dot(n, n) > float64(MIN_SINE_SQUARED) * dot(b, b) * dot(c, c):
        narrow = 0.0
    return vec2d(narrow, 0.0)


@kernel
def sum_vertex_pseudonormals_kernel(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), around: CornersByVertex, normals: array(dtype=vec3d)
):
    """Angle-weighted sum of triangle normals at each vertex, by ascending corner."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    p = widen(vertices[i])
    for j in range(around.starts[i], around.starts[i + 1]):
        corner = around.corners[j]
        t = triangles[corner // 3]
        u = widen(vertices[t[(corner + 1) % 3]]) - p
        v = widen(vertices[t[(corner + 2) % 3]]) - p
        total = total + unit_normal(vertices, t) * angle_between(u, v)
    normals[i] = total


@struct
class Pseudonormals:
    """Pseudonormals of a closed mesh: opposite half-edges, vertex normals, and `sign` (-1 for a negative volume)."""

    vertices: array(dtype=vec3)
    triangles: array(dtype=vec3i)
    twins: array(dtype=int32)
    normals: array(dtype=vec3d)
    sign: float64

    def __init__(self, vertices: Points, triangles: Triangles, volume: float) -> None:
        device, count = vertices.device, 3 * triangles.size
        self.vertices, self.triangles, self.sign = vertices, triangles, 1.0 if volume >= 0 else -1.0
        self.twins, (keys, order) = empty(count, int32, device), sorted_edges(triangles, vertices.size)
        launch(pair_edges_kernel, count, [triangles, keys, order, self.twins, zeros(4, int32, device)])
        self.normals = empty(vertices.size, vec3d, device)
        around = CornersByVertex(triangles, vertices.size)
        launch(sum_vertex_pseudonormals_kernel, vertices.size, [vertices, triangles, around, self.normals])


@func
def side_of_part(gap: vec3d, triangle: int, part: int, sides: Pseudonormals) -> float64:
    """Side of a point (negative inside), given the vector `gap` from the nearest point, and the part of the nearest
    triangle: 0 for the interior, 1 to 3 for edges from corner 0, 1, 2, and 4 to 6 for corners."""
    t = sides.triangles[triangle]
    normal = unit_normal(sides.vertices, t)
    if part > 3:
        normal = sides.normals[t[part - 4]]
    elif part > 0:
        twin = sides.twins[3 * triangle + part - 1]
        if twin >= 0:
            normal = normal + unit_normal(sides.vertices, sides.triangles[twin // 3])
    return dot(gap, normal) * sides.sign


def volume_of_shell(vertices: Points, triangles: Triangles) -> float | None:
    """Signed volume of a one-component mesh as required (self-intersections unchecked), else None. One sync."""
    if not triangles.size:
        return None
    edges = sorted_edges(triangles, vertices.size)
    findings = find_topology(triangles, vertices.size, edges)
    if not findings.device.is_cuda and any(topology_of(download(findings))):
        return None  # the rest would not be used
    mesh = [vertices, triangles]
    sums = [reduce(reduction, triangles.size, mesh) for reduction in (count_narrow, measure_triangle)]
    values = read_together([findings, label_parts(edges, triangles.size)[1], *sums])  # sync
    topology, parts, narrow, measured = topology_of(values[0]), values[1][0], values[2][0][0], values[3][0]
    return float(measured[1]) / 6 if parts == 1 and narrow == 0 and not any(topology) else None
