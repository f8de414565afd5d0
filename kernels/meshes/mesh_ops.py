"""Normals, area, volume, motion and clean-up of indexed triangles.

Everything is summed in double precision and in a fixed order: at a vertex by ascending corner, over the mesh by
reductions. Where a triangle or vertex has no area its normal is (0, 0, 1), as Open3D has it; triangles with a corner
that is not finite add nothing. Vertices are float32, 12 B; triangles three int32.
"""

from ..arrays.prefix_sum import exclusive_scan
from ..arrays.sort import argsort_keys
from ..lang import (
    array,
    cross,
    dot,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    length,
    mat33d,
    reduce,
    reduction,
    tid,
    vec2d,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import download, empty, zeros


@func
def widen(p: vec3) -> vec3d:
    """A vector in double precision."""
    return vec3d(float64(p[0]), float64(p[1]), float64(p[2]))


@func
def triangle_cross(vertices: array(dtype=vec3), t: vec3i) -> vec3d:
    """Twice the area of a triangle along its normal; zero where a corner is not finite."""
    a = widen(vertices[t[0]])
    n = cross(widen(vertices[t[1]]) - a, widen(vertices[t[2]]) - a)
    if not isfinite(n):
        n = vec3d(float64(0.0), float64(0.0), float64(0.0))
    return n


@func
def unit_or_up(n: vec3d) -> vec3:
    """The direction of n in single precision, (0, 0, 1) where there is none."""
    size = length(n)
    unit = vec3(0.0, 0.0, 1.0)
    if size > float64(0.0):
        unit = vec3(float(n[0] / size), float(n[1] / size), float(n[2] / size))
    return unit


@kernel
def compute_triangle_normals_kernel(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), normals: array(dtype=vec3)
):
    """Unit normals of triangles by the right-hand rule."""
    i = tid()
    normals[i] = unit_or_up(triangle_cross(vertices, triangles[i]))


@kernel
def cross_triangles_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), crosses: array(dtype=vec3d)):
    """The area-weighted normals of triangles."""
    i = tid()
    crosses[i] = triangle_cross(vertices, triangles[i])


@kernel
def list_corner_keys_kernel(triangles: array(dtype=vec3i), keys: array(dtype=int64)):
    """The vertex of each corner, three corners a triangle."""
    i = tid()
    t = triangles[i]
    keys[3 * i] = int64(t[0])
    keys[3 * i + 1] = int64(t[1])
    keys[3 * i + 2] = int64(t[2])


@kernel
def find_starts_kernel(keys: array(dtype=int64), count: int, starts: array(dtype=int32)):
    """starts[v] is the first place of v or more in the sorted keys; one thread a key writes all up to its own."""
    i = tid()
    first = int(0)
    if i > 0:
        first = int(keys[i - 1]) + 1
    for v in range(first, int(keys[i]) + 1):
        starts[v] = i
    if i + 1 == keys.shape[0]:
        for v in range(int(keys[i]) + 1, count + 1):
            starts[v] = i + 1


@kernel
def sum_vertex_normals_kernel(
    vertices: array(dtype=vec3),
    starts: array(dtype=int32),
    corners: array(dtype=int32),
    crosses: array(dtype=vec3d),
    normals: array(dtype=vec3),
):
    """Unit normals of vertices; NaN where the vertex is not finite."""
    i = tid()
    total = vec3d(float64(0.0), float64(0.0), float64(0.0))
    for j in range(starts[i], starts[i + 1]):
        total = total + crosses[corners[j] // 3]
    p = vertices[i]
    normal = unit_or_up(total)
    gap = (p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2])  # zero, or NaN
    normals[i] = vec3(normal[0] + gap, normal[1] + gap, normal[2] + gap)


@reduction
def measure_triangle(vertices: array(dtype=vec3), triangles: array(dtype=vec3i)) -> vec2d:
    """(twice the area, six times the signed volume of the tetrahedron with vertex 0 as its tip)."""
    i = tid()
    t = triangles[i]
    n = triangle_cross(vertices, t)
    volume = dot(n, widen(vertices[t[0]]) - widen(vertices[0]))
    if not isfinite(volume):
        volume = float64(0.0)
    return vec2d(length(n), volume)


@kernel
def move_vertices_kernel(vertices: array(dtype=vec3), A: mat33d, b: vec3d, moved: array(dtype=vec3)):
    """moved = A p + b."""
    i = tid()
    p = A @ widen(vertices[i]) + b
    moved[i] = vec3(float(p[0]), float(p[1]), float(p[2]))


@kernel
def turn_normals_kernel(normals: array(dtype=vec3), A: mat33d, turned: array(dtype=vec3)):
    """turned = A n, of unit length; a zero or NaN normal stays what it is."""
    i = tid()
    n = A @ widen(normals[i])
    size = length(n)
    if size > float64(0.0):
        n = n / size
    turned[i] = vec3(float(n[0]), float(n[1]), float(n[2]))


@kernel
def flip_triangles_kernel(triangles: array(dtype=vec3i), flipped: array(dtype=vec3i)):
    """The other winding."""
    i = tid()
    t = triangles[i]
    flipped[i] = vec3i(t[0], t[2], t[1])


@kernel
def mark_referenced_kernel(triangles: array(dtype=vec3i), used: array(dtype=int32)):
    """used[v] = 1 for the vertices of triangles; whichever thread writes last writes the same."""
    i = tid()
    t = triangles[i]
    used[t[0]] = 1
    used[t[1]] = 1
    used[t[2]] = 1


@kernel
def keep_rows_kernel(
    rows: array(dtype=vec3), used: array(dtype=int32), places: array(dtype=int32), kept: array(dtype=vec3)
):
    """The used rows, in their order."""
    i = tid()
    if used[i] == 1:
        kept[places[i]] = rows[i]


@kernel
def renumber_triangles_kernel(
    triangles: array(dtype=vec3i), places: array(dtype=int32), renumbered: array(dtype=vec3i)
):
    """Triangles by the new numbers of their vertices."""
    i = tid()
    t = triangles[i]
    renumbered[i] = vec3i(places[t[0]], places[t[1]], places[t[2]])


class CornersByVertex:
    """Corners sorted by vertex: those of v are corners[starts[v] : starts[v + 1]]; corner // 3 is the triangle."""

    def __init__(self, triangles, vertex_count):
        device = triangles.device
        keys = empty(3 * triangles.size, int64, device)
        launch(list_corner_keys_kernel, triangles.size, [triangles, keys])
        keys, self.corners = argsort_keys(keys, max(1, vertex_count.bit_length()))
        self.starts = zeros(vertex_count + 1, int32, device)
        launch(find_starts_kernel, keys.size, [keys, vertex_count, self.starts])


def triangle_normals(vertices, triangles):
    """Unit normals of triangles, vec3 [t]."""
    normals = empty(triangles.size, vec3, vertices.device)
    launch(compute_triangle_normals_kernel, triangles.size, [vertices, triangles, normals])
    return normals


def vertex_normals(vertices, triangles):
    """Unit normals of vertices, vec3 [m]: the mean of the triangles around each, weighted by area."""
    device = vertices.device
    crosses, normals = empty(triangles.size, vec3d, device), empty(vertices.size, vec3, device)
    launch(cross_triangles_kernel, triangles.size, [vertices, triangles, crosses])
    around = CornersByVertex(triangles, vertices.size)
    launch(sum_vertex_normals_kernel, vertices.size, [vertices, around.starts, around.corners, crosses, normals])
    return normals


def measure(vertices, triangles):
    """(area, signed volume), Python numbers."""
    twice, six = download(reduce(measure_triangle, triangles.size, [vertices, triangles]))[0]  # sync
    return float(twice) / 2, float(six) / 6


def move_vertices(vertices, A, b):
    """A p + b for a float64 matrix [3, 3] and vector [3]."""
    moved = empty(vertices.size, vec3, vertices.device)
    launch(move_vertices_kernel, vertices.size, [vertices, mat33d(*A.ravel()), vec3d(*b), moved])
    return moved


def turn_normals(normals, A):
    """A n at unit length for a float64 matrix [3, 3]."""
    turned = empty(normals.size, vec3, normals.device)
    launch(turn_normals_kernel, normals.size, [normals, mat33d(*A.ravel()), turned])
    return turned


def flip_triangles(triangles):
    """The same triangles wound the other way."""
    flipped = empty(triangles.size, vec3i, triangles.device)
    launch(flip_triangles_kernel, triangles.size, [triangles, flipped])
    return flipped


def drop_unreferenced(triangles, vertex_count, per_vertex):
    """Renumber triangles by the vertices that they use.

    Args:
        triangles: vec3i [t].
        vertex_count: Vertices there are.
        per_vertex: vec3 [m] arrays, or None, to be cut in the same way.

    Returns:
        (triangles, arrays): the order of the vertices is kept.
    """
    device = triangles.device
    used = zeros(vertex_count, int32, device)
    launch(mark_referenced_kernel, triangles.size, [triangles, used])
    places, count = exclusive_scan(used)  # sync
    renumbered = empty(triangles.size, vec3i, device)
    launch(renumber_triangles_kernel, triangles.size, [triangles, places, renumbered])
    kept = []
    for rows in per_vertex:
        if rows is not None:
            target = empty(count, vec3, device)
            launch(keep_rows_kernel, vertex_count, [rows, used, places, target])
            rows = target
        kept.append(rows)
    return renumbered, kept
