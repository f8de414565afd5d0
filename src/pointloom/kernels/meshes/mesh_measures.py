"""Normals, area and volume of a triangle mesh, in float64 and a fixed order.

Zero-area triangles and vertices get the normal (0, 0, 1), as in Open3D. Triangles with a non-finite corner are ignored.
"""

from ..algebra.transform import widen
from ..array_types import Points, Triangles, Vectors
from ..lang import (
    NAN,
    array,
    compute,
    cross,
    dot,
    func,
    isfinite,
    kernel,
    launch,
    length,
    reduce,
    reduction,
    tid,
    vec2d,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import download, empty
from .mesh_topology import CornersByVertex


@func
def triangle_cross(vertices: array(dtype=vec3), t: vec3i) -> vec3d:
    """Twice the area along the normal. Zero if a corner is not finite."""
    a = widen(vertices[t[0]])
    n = cross(widen(vertices[t[1]]) - a, widen(vertices[t[2]]) - a)
    if not isfinite(n):
        n = vec3d(0.0, 0.0, 0.0)
    return n


@func
def unit_or_up(n: vec3d) -> vec3:
    """Unit vector in float32, (0, 0, 1) for zero."""
    size = length(n)
    unit = vec3(0.0, 0.0, 1.0)
    if size > 0.0:
        unit = vec3(float(n[0] / size), float(n[1] / size), float(n[2] / size))
    return unit


@kernel
def compute_triangle_normals_kernel(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), normals: array(dtype=vec3)
):
    """Unit normals of triangles. NaN if a corner is not finite."""
    i = tid()
    t = triangles[i]
    normal = unit_or_up(triangle_cross(vertices, t))
    if not (isfinite(vertices[t[0]]) and isfinite(vertices[t[1]]) and isfinite(vertices[t[2]])):
        normal = vec3(NAN, NAN, NAN)
    normals[i] = normal


@kernel
def cross_triangles_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), crosses: array(dtype=vec3d)):
    i = tid()
    crosses[i] = triangle_cross(vertices, triangles[i])


@kernel
def sum_vertex_normals_kernel(
    vertices: array(dtype=vec3), around: CornersByVertex, crosses: array(dtype=vec3d), normals: array(dtype=vec3)
):
    """Unit normals of vertices. NaN if the vertex is not finite."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    for j in range(around.starts[i], around.starts[i + 1]):
        total = total + crosses[around.corners[j] // 3]
    p = vertices[i]
    normal = unit_or_up(total)
    gap = (p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2])  # zero, or NaN
    normals[i] = vec3(normal[0] + gap, normal[1] + gap, normal[2] + gap)


@reduction
def measure_triangle(vertices: array(dtype=vec3), triangles: array(dtype=vec3i)) -> vec2d:
    """(twice the area, six times the signed volume of the tetrahedron with vertex 0)."""
    i = tid()
    t = triangles[i]
    n = triangle_cross(vertices, t)
    volume = dot(n, widen(vertices[t[0]]) - widen(vertices[0]))
    if not isfinite(volume):
        volume = 0.0
    return vec2d(length(n), volume)


def triangle_normals(vertices: Points, triangles: Triangles) -> Vectors:
    return compute(compute_triangle_normals_kernel, triangles.size, [vertices, triangles], vec3, vertices.device)


def vertex_normals(vertices: Points, triangles: Triangles) -> Vectors:
    """Area-weighted unit normals of vertices, vec3 [m]."""
    device = vertices.device
    crosses, normals = empty(triangles.size, vec3d, device), empty(vertices.size, vec3, device)
    launch(cross_triangles_kernel, triangles.size, [vertices, triangles, crosses])
    around = CornersByVertex(triangles, vertices.size)
    launch(sum_vertex_normals_kernel, vertices.size, [vertices, around, crosses, normals])
    return normals


def measure(vertices: Points, triangles: Triangles) -> tuple[float, float]:
    """(area, signed volume), Python numbers."""
    twice, six = download(reduce(measure_triangle, triangles.size, [vertices, triangles]))[0]  # sync
    return float(twice) / 2, float(six) / 6
