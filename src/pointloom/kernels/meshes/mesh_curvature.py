"""Mean and Gaussian curvature by cotangents and angles over mixed Voronoi areas.

Meyer, Desbrun, Schroeder, Barr, "Discrete differential-geometry operators for triangulated 2-manifolds", VisMath 2003,
equations 8 to 11 and figure 4. Float64 sums by ascending corner without compiler trigonometry: bitwise reproducible.
Vertices without a closed, consistently oriented ring get NaN.
"""

from ..algebra.angles import PI, angle_of
from ..algebra.transform import widen
from ..array_types import Array1, Points, Triangles
from ..lang import (
    NAN,
    array,
    cross,
    dot,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    length,
    sqrt,
    tid,
    vec3,
    vec3d,
    vec3i,
    vec4d,
    vector,
)
from ..memory import empty
from .mesh_edges import MeshEdges
from .mesh_topology import CornersByVertex, corner_vertex, other_edge

ring_sums = vector(8, float64)  # Laplacian (3), normal (3), area, angle


@kernel
def pair_half_edges_kernel(triangles: array(dtype=vec3i), edges: MeshEdges, twins: array(dtype=int32)):
    """Opposite half-edge if exactly two triangles use an edge in opposite directions, else -1."""
    i = tid()
    start = edges.starts[i]
    count = edges.starts[i + 1] - start
    for j in range(count):
        h = edges.half_edges[start + j]
        twin = -1
        if count == 2:
            other = edges.half_edges[start + 1 - j]
            if corner_vertex(triangles, other) != corner_vertex(triangles, h):
                twin = other
        twins[h] = twin


@func
def is_ringed(triangles: array(dtype=vec3i), around: CornersByVertex, twins: array(dtype=int32), v: int) -> int:
    count = around.starts[v + 1] - around.starts[v]
    closed = 0
    visited = 1
    if count > 0:
        start = around.corners[around.starts[v]]
        h = start
        while visited <= count and closed == 0 and twins[h] >= 0:
            h = other_edge(triangles, twins[h], v)
            if h // 3 == start // 3:
                closed = 1
            else:
                visited += 1
    if visited != count:
        closed = 0
    return closed


@func
def sums_of_corner(p: vec3d, q: vec3d, r: vec3d) -> ring_sums:
    """Contribution of triangle (p, q, r) at p. Not finite if it has no area."""
    u = q - p
    v = r - p
    w = r - q
    n = cross(u, v)
    twice = length(n)
    cot_q = -dot(u, w) / twice
    cot_r = dot(v, w) / twice
    bend = -cot_r * u - cot_q * v
    area = (dot(u, u) * cot_r + dot(v, v) * cot_q) / 8.0
    if dot(u, v) < 0.0:
        area = twice / 4.0
    elif cot_q < 0.0 or cot_r < 0.0:
        area = twice / 8.0
    return ring_sums(bend[0], bend[1], bend[2], n[0], n[1], n[2], area, angle_of(twice, dot(u, v)))


@kernel
def measure_curvatures_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    around: CornersByVertex,
    twins: array(dtype=int32),
    curvatures: array(dtype=vec4d),
):
    """(mean, Gaussian, minimum, maximum) curvature of a vertex, or NaN."""
    i = tid()
    result = vec4d(float64(NAN), float64(NAN), float64(NAN), float64(NAN))
    if is_ringed(triangles, around, twins, i) == 1:
        total = ring_sums(0.0)
        p = widen(vertices[i])
        for j in range(around.starts[i], around.starts[i + 1]):
            corner = around.corners[j]
            k = corner % 3
            first = corner - k
            q = widen(vertices[corner_vertex(triangles, first + (k + 1) % 3)])
            r = widen(vertices[corner_vertex(triangles, first + (k + 2) % 3)])
            total = total + sums_of_corner(p, q, r)
        bend = vec3d(total[0], total[1], total[2])
        normal = vec3d(total[3], total[4], total[5])
        mean = length(bend) / (4.0 * total[6])
        if dot(bend, normal) < 0.0:
            mean = -mean
        gaussian = (2.0 * float64(PI) - total[7]) / total[6]
        half = sqrt(max(mean * mean - gaussian, 0.0))
        if isfinite(mean) and isfinite(gaussian):
            result = vec4d(mean, gaussian, mean - half, mean + half)
    curvatures[i] = result


def measure_curvatures(vertices: Points, triangles: Triangles) -> Array1[vec4d]:
    """(mean, Gaussian, minimum, maximum) curvature of each vertex, vec4d [m]. One sync."""
    device = vertices.device
    edges, around = MeshEdges(triangles, vertices.size), CornersByVertex(triangles, vertices.size)
    twins, curvatures = empty(3 * triangles.size, int32, device), empty(vertices.size, vec4d, device)
    launch(pair_half_edges_kernel, edges.count, [triangles, edges, twins])
    launch(measure_curvatures_kernel, vertices.size, [vertices, triangles, around, twins, curvatures])
    return curvatures
