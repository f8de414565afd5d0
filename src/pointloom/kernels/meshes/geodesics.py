"""Geodesic distances from source vertices, relaxed over triangles until none decreases.

Fronts cross a triangle as from a virtual point source (Novotni and Klein, "Computing geodesic distances on triangular
meshes", WSCG 2002), which is exact on flat meshes. A round reads the distances of the previous round, so the result
does not depend on the thread order. Only vertices near changes are active. 16 B per vertex.
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

# Smaller relative decreases are ignored: around slivers, distances kept decreasing by up to 7e-11 per round on some
# meshes.
MIN_RELATIVE_GAIN = 2.0e-10


@func
def distance_through(a: vec3d, b: vec3d, c: vec3d, to_a: float64, to_b: float64) -> float64:
    """Distance of c across triangle (a, b, c) from a point at distances `to_a` and `to_b`."""
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
    vertices: array(dtype=vec3)
    triangles: array(dtype=vec3i)
    around: CornersByVertex
    decreased: array(dtype=int32)

    def __init__(self, vertices: Points, triangles: Triangles) -> None:
        self.vertices, self.triangles = vertices, triangles
        self.around, self.decreased = CornersByVertex(triangles, vertices.size), zeros(1, int32, vertices.device)


@kernel
def start_at_sources_kernel(
    sources: array(dtype=int32), wave: Wave, before: array(dtype=float64), active: array(dtype=uint8)
):
    """Distance 0 at the sources. All threads that activate a vertex write the same value."""
    i = tid()
    source = sources[i]
    before[source] = 0.0
    for j in range(wave.around.starts[source], wave.around.starts[source + 1]):
        t = wave.triangles[wave.around.corners[j] // 3]
        for k in range(3):
            active[t[k]] = 1


@kernel
def spread_distances_kernel(
    wave: Wave,
    before: array(dtype=float64),
    active: array(dtype=uint8),
    after: array(dtype=float64),
    next_active: array(dtype=uint8),
):
    """Shortest distance over a vertex's triangles. Activates neighbors if it decreased (all write the same value)."""
    i = tid()
    distance = before[i]
    if active[i] == 1:
        active[i] = 0
        shortest = distance
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
            if not isfinite(distance):
                nearer = 1
            elif shortest < distance - float64(MIN_RELATIVE_GAIN) * distance:
                nearer = 1
        if nearer == 1:
            distance = shortest
            if wave.decreased[0] == 0:  # avoids most atomics. An old value only causes an extra one
                atomic_max(wave.decreased, 0, 1)
            for j in range(wave.around.starts[i], wave.around.starts[i + 1]):
                t = wave.triangles[wave.around.corners[j] // 3]
                for k in range(3):
                    next_active[t[k]] = 1
    after[i] = distance


@kernel
def finish_rounds_kernel(wave: Wave, running: array(dtype=int32)):
    i = tid()
    running[i] = wave.decreased[i]
    wave.decreased[i] = 0


def geodesic_distances(vertices: Points, triangles: Triangles, sources: Integers) -> Doubles:
    """Geodesic distance of each vertex from the nearest source, float64 [m], or inf if unreachable."""
    device, count = vertices.device, vertices.size
    wave, running = Wave(vertices, triangles), full(1, 1, int32, device)
    before, after = full(count, INFINITY, float64, device), empty(count, float64, device)
    active, next_active = zeros(count, uint8, device), zeros(count, uint8, device)
    launch(start_at_sources_kernel, sources.size, [sources, wave, before, active])

    def two_rounds() -> None:
        launch(spread_distances_kernel, count, [wave, before, active, after, next_active])
        launch(spread_distances_kernel, count, [wave, after, next_active, before, active])
        launch(finish_rounds_kernel, 1, [wave, running])

    loop_while(running, two_rounds)
    return before
