"""Distances along a mesh from some of its vertices, relaxed over triangles in rounds until none becomes shorter.

Across a triangle a front comes from a point: the one in the triangle's plane that is as far from two of its corners as
their distances say (Novotni and Klein, "Computing geodesic distances on triangular meshes", WSCG 2002). So distances on
a flat mesh are exact, where the straight fronts of Kimmel and Sethian ("Computing geodesic paths on manifolds", PNAS
95(15), 1998) are not; obtuse triangles need nothing of their own, since all corners are tried in all rounds rather
than once in the order of arrival. A round reads the distances of the round before, so its outcome does not depend on
the order of threads. Rounds are about as many as there are edges on the longest way; a vertex works only in a round
after one in which a corner of its triangles came nearer. 16 B a vertex beside its list of corners.
"""

from ..algebra.transform import widen
from ..array_types import Doubles, Integers, Points, Triangles
from ..lang import (
    INFINITY,
    array,
    atomic_max,
    cross,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    length,
    loop_while,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, full, zeros
from .mesh_topology import CornersByVertex, corner_vertex

# A distance shorter by less than this share is the same one: around slivers of float32 vertices distances creep down
# by up to 7e-11 a round for ever, on the meshes where that was seen.
GAIN = 2.0e-10


@func
def distance_through(a: vec3d, b: vec3d, c: vec3d, to_a: float64, to_b: float64) -> float64:
    """The distance of c over the triangle (a, b, c) from a point that is `to_a` and `to_b` away from a and b."""
    u = b - a
    v = c - a
    side = length(u)
    shortest = min(to_a + length(v), to_b + length(c - b))
    if side > 0.0:
        height = length(cross(u, v)) / side
        along = (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / side
        source = 0.5 * ((to_a - to_b) * ((to_a + to_b) / side) + side)
        depth_squared = (to_a - source) * (to_a + source)
        if depth_squared >= 0.0 and height > 0.0:
            depth = sqrt(depth_squared)
            crossing = source + (along - source) * (depth / (depth + height))
            if crossing >= 0.0 and crossing <= side:
                x = along - source
                y = height + depth
                shortest = min(shortest, sqrt(x * x + y * y))
    return shortest


@struct
class Wave:
    """A mesh over which distances spread.

    Attributes:
        vertices, triangles, around: The mesh.
        found: int32 [1], whether a distance became shorter.
    """

    vertices: array(dtype=vec3)
    triangles: array(dtype=vec3i)
    around: CornersByVertex
    found: array(dtype=int32)

    def __init__(self, vertices: Points, triangles: Triangles) -> None:
        self.vertices, self.triangles = vertices, triangles
        self.around, self.found = CornersByVertex(triangles, vertices.size), zeros(1, int32, vertices.device)


@kernel
def start_at_sources_kernel(
    sources: array(dtype=int32), wave: Wave, before: array(dtype=float64), awake: array(dtype=uint8)
):
    """Distance 0 at the sources; whichever thread wakes a vertex writes the same."""
    i = tid()
    source = sources[i]
    before[source] = 0.0
    for j in range(wave.around.starts[source], wave.around.starts[source + 1]):
        t = wave.triangles[wave.around.corners[j] // 3]
        for k in range(3):
            awake[t[k]] = 1


@kernel
def spread_distances_kernel(
    wave: Wave,
    before: array(dtype=float64),
    awake: array(dtype=uint8),
    after: array(dtype=float64),
    woken: array(dtype=uint8),
):
    """The shortest distance over the triangles of a vertex; wakes those around where it is shorter than before.

    Whichever thread wakes a vertex writes the same; the atomic says whether there are any.
    """
    i = tid()
    own = before[i]
    if awake[i] == 1:
        awake[i] = 0
        shortest = own
        c = widen(wave.vertices[i])
        for j in range(wave.around.starts[i], wave.around.starts[i + 1]):
            corner = wave.around.corners[j]
            k = corner % 3
            first = corner - k
            va = corner_vertex(wave.triangles, first + (k + 1) % 3)
            vb = corner_vertex(wave.triangles, first + (k + 2) % 3)
            a = widen(wave.vertices[va])
            b = widen(wave.vertices[vb])
            if isfinite(a) and isfinite(b) and isfinite(c):
                if isfinite(before[va]) and isfinite(before[vb]):
                    shortest = min(shortest, distance_through(a, b, c, before[va], before[vb]))
                elif isfinite(before[va]):
                    shortest = min(shortest, before[va] + length(c - a))
                elif isfinite(before[vb]):
                    shortest = min(shortest, before[vb] + length(c - b))
        nearer = 0
        if isfinite(shortest):
            if not isfinite(own):
                nearer = 1
            elif shortest < own - float64(GAIN) * own:
                nearer = 1
        if nearer == 1:
            own = shortest
            if wave.found[0] == 0:  # spares most of the atomics; an old value only lets one more through
                atomic_max(wave.found, 0, 1)
            for j in range(wave.around.starts[i], wave.around.starts[i + 1]):
                t = wave.triangles[wave.around.corners[j] // 3]
                for k in range(3):
                    woken[t[k]] = 1
    after[i] = own


@kernel
def settle_rounds_kernel(wave: Wave, running: array(dtype=int32)):
    """Whether there is another round."""
    i = tid()
    running[i] = wave.found[i]
    wave.found[i] = 0


def geodesic_distances(vertices: Points, triangles: Triangles, sources: Integers) -> Doubles:
    """The distance of each vertex from the nearest of int32 sources along the mesh, float64 [m]; infinite where none.

    One look at a flag every second round on the CPU, none on CUDA.
    """
    device, count = vertices.device, vertices.size
    wave, running = Wave(vertices, triangles), full(1, 1, int32, device)
    before, after = full(count, INFINITY, float64, device), empty(count, float64, device)
    awake, woken = zeros(count, uint8, device), zeros(count, uint8, device)
    launch(start_at_sources_kernel, sources.size, [sources, wave, before, awake])

    def two_rounds() -> None:
        launch(spread_distances_kernel, count, [wave, before, awake, after, woken])
        launch(spread_distances_kernel, count, [wave, after, woken, before, awake])
        launch(settle_rounds_kernel, 1, [wave, running])

    loop_while(running, two_rounds)
    return before
