"""Closest surface point of each query, and the side of a closed mesh, in float64 after nearest_triangle.py."""

import numpy as np

from ..algebra.transform import Transform, narrow, transform_point, widen
from ..array_types import Doubles, Points, Scalars
from ..lang import (
    NAN,
    array,
    compute,
    float32,
    float64,
    func,
    isfinite,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    vec2,
    vec3,
    vec3i,
    vec4d,
)
from ..memory import full, zeros
from ..meshes.mesh_measures import triangle_cross, unit_or_up
from ..meshes.pseudonormals import Pseudonormals, side_of_part
from .nearest_triangle import NearestTriangles
from .point_triangle import measure_triangle, point_at
from .triangle_tree import TriangleTree

INSIDE_OUT = 0.5  # winding number halfway between outside and inside


@struct
class ClosestPoints:
    """Closest points (NaN if none), `uvs` of the second and third corner, `normals` ((0, 0, 1) if degenerate)."""

    points: array(dtype=vec3)
    uvs: array(dtype=vec2)
    normals: array(dtype=vec3)

    def __init__(self, queries: Points) -> None:
        device, n = queries.device, queries.size
        self.points, self.uvs = full(n, vec3(NAN, NAN, NAN), vec3, device), zeros(n, vec2, device)
        self.normals = zeros(n, vec3, device)


@func
def measure_row(q: vec3, vertices: array(dtype=vec3), triangles: array(dtype=vec3i), triangle: int) -> vec4d:
    t = triangles[triangle]
    return measure_triangle(widen(q), widen(vertices[t[0]]), widen(vertices[t[1]]), widen(vertices[t[2]]))


@kernel
def describe_closest_kernel(
    queries: array(dtype=vec3),
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    nearest: NearestTriangles,
    mesh: int,
    pose: Transform,
    closest: ClosestPoints,
):
    i = tid()
    if nearest.meshes[i] != mesh:
        return
    measured = measure_row(queries[i], vertices, triangles, nearest.triangles[i])
    t = triangles[nearest.triangles[i]]
    point = point_at(vertices[t[0]], vertices[t[1]], vertices[t[2]], measured[0], measured[1])
    closest.points[i] = narrow(transform_point(point, pose))
    closest.uvs[i] = vec2(float(measured[0]), float(measured[1]))
    n = widen(unit_or_up(triangle_cross(vertices, t)))
    closest.normals[i] = narrow(pose.R @ n)


@kernel
def find_sides_kernel(
    queries: array(dtype=vec3), nearest: NearestTriangles, sides: Pseudonormals, numbers: array(dtype=float64)
):
    i = tid()
    triangle = nearest.triangles[i]
    if triangle < 0:
        return
    q = queries[i]
    measured = measure_row(q, sides.vertices, sides.triangles, triangle)
    t = sides.triangles[triangle]
    point = point_at(sides.vertices[t[0]], sides.vertices[t[1]], sides.vertices[t[2]], measured[0], measured[1])
    if measured[2] == 0.0:
        point = widen(sides.vertices[t[0]])  # on the same plane, exact
    if side_of_part(widen(q) - point, triangle, int(measured[2]), sides) < 0.0:
        numbers[i] = 1.0


@kernel
def sign_distances_kernel(
    queries: array(dtype=vec3),
    sqdists: array(dtype=float64),
    numbers: array(dtype=float64),
    distances: array(dtype=float32),
):
    """Distances, negative where the winding number indicates inside. NaN for non-finite queries."""
    i = tid()
    distance = float(sqrt(sqdists[i]))
    number = numbers[i]
    if number > float64(INSIDE_OUT) or number < -float64(INSIDE_OUT):
        distance = -distance
    if not isfinite(queries[i]):
        distance = float(NAN)
    distances[i] = distance


def describe(
    queries: Points, tree: TriangleTree, nearest: NearestTriangles, mesh: int, pose: np.ndarray, closest: ClosestPoints
) -> None:
    """Store the closest points of queries (about the mesh's origin) nearest to mesh number `mesh`, posed by `pose`."""
    mesh_arrays = [tree.vertices, tree.triangles]
    launch(describe_closest_kernel, queries.size, [queries, *mesh_arrays, nearest, mesh, Transform(pose), closest])


def find_sides(queries: Points, nearest: NearestTriangles, sides: Pseudonormals) -> Doubles:
    """float64 (n), 1 for queries inside a closed mesh, given its Pseudonormals, else 0."""
    numbers = zeros(queries.size, float64, queries.device)
    launch(find_sides_kernel, queries.size, [queries, nearest, sides, numbers])
    return numbers


@kernel
def mark_inside_kernel(distances: array(dtype=float32), inside: array(dtype=float32)):
    i = tid()
    mark = distances[i]
    if mark == mark:
        mark = float(1.0 if mark <= 0.0 else 0.0)
    inside[i] = mark


def mark_inside(distances: Scalars) -> Scalars:
    """float32 (n), 1 where signed distances are <= 0, else 0. NaN stays."""
    return compute(mark_inside_kernel, distances.size, [distances], float32, distances.device)


def sign_distances(queries: Points, sqdists: Doubles, numbers: Doubles) -> Scalars:
    """float32 (n), roots of squared distances, negative where the winding number exceeds a half."""
    return compute(sign_distances_kernel, queries.size, [queries, sqdists, numbers], float32, queries.device)
