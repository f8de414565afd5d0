"""Smoothing and sharpening filters of vertex values along edges.

Taubin, "A signal processing approach to fair surface design", SIGGRAPH 1995. Weights as in Open3D. Each pass reads the
previous one and sums over ascending neighbors in float64. Only the result is rounded. Non-finite neighbors are ignored.
Non-finite or isolated vertices are unchanged.
"""

from collections.abc import Iterable, Sequence

from ..array_types import Integers, Positions, Triangles
from ..lang import (
    Kernel,
    array,
    dot,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    loop_while,
    sqrt,
    struct,
    tid,
    vec3d,
)
from ..memory import empty, full
from ..meshes.mesh_edges import MeshEdges, SortedEdges
from ..meshes.vertex_neighbors import VertexNeighbors

MIN_REPEATED = 3  # periods of passes that are worth a loop on the CPU (an estimate)
ADDED_DISTANCE = 1.0e-12  # added to distances [m] in weights, so that coincident vertices have finite ones


@struct
class FilterPass:
    """Neighbors of each vertex, and positions vec3d [m] for the weights."""

    around: VertexNeighbors
    positions: array(dtype=vec3d)

    def __init__(self, around: VertexNeighbors, positions: Positions) -> None:
        self.around, self.positions = around, positions


@kernel
def average_kernel(rule: FilterPass, values: array(dtype=vec3d), factor: float64, out: array(dtype=vec3d)):
    i = tid()
    own = values[i]
    total = own + vec3d(0.0, 0.0, 0.0)
    count = float64(1.0)
    for j in range(rule.around.starts[i], rule.around.starts[i + 1]):
        value = values[rule.around.vertices[j]]
        if isfinite(value):
            total = total + value
            count += 1.0
    if isfinite(own):
        own = total / count
    out[i] = own


@kernel
def sharpen_kernel(rule: FilterPass, values: array(dtype=vec3d), factor: float64, out: array(dtype=vec3d)):
    """Subtract from a vertex `factor` times the sum of its differences to neighbors."""
    i = tid()
    own = values[i]
    away = vec3d(0.0, 0.0, 0.0)
    for j in range(rule.around.starts[i], rule.around.starts[i + 1]):
        value = values[rule.around.vertices[j]]
        if isfinite(value):
            away = away + (own - value)
    if isfinite(own):
        own = own + factor * away
    out[i] = own


@func
def inverse_distance(p: vec3d, q: vec3d) -> float64:
    d = q - p
    sqdist = dot(d, d)
    weight = float64(0.0)
    if isfinite(sqdist):
        weight = 1.0 / (sqrt(sqdist) + float64(ADDED_DISTANCE))
    return weight


@kernel
def approach_mean_kernel(rule: FilterPass, values: array(dtype=vec3d), factor: float64, out: array(dtype=vec3d)):
    """Move a vertex by `factor` toward the weighted mean of its neighbors, closer ones with larger weights. The sums
    are scalars: LLVM keeps a vector that changes under a condition in memory."""
    i = tid()
    own = values[i]
    p = rule.positions[i]
    x = float64(0.0)
    y = float64(0.0)
    z = float64(0.0)
    weights = float64(0.0)
    for j in range(rule.around.starts[i], rule.around.starts[i + 1]):
        neighbor = rule.around.vertices[j]
        weight = inverse_distance(p, rule.positions[neighbor])
        value = values[neighbor]
        if weight > 0.0 and isfinite(value):
            x += weight * (value[0] - own[0])
            y += weight * (value[1] - own[1])
            z += weight * (value[2] - own[2])
            weights += weight
    if isfinite(own) and weights > 0.0:
        own = own + factor * (vec3d(x, y, z) / weights)
    out[i] = own


@kernel
def approach_mean_position_kernel(rule: FilterPass, factor: float64, out: array(dtype=vec3d)):
    """`approach_mean_kernel` of the positions themselves: each neighbor is read once."""
    i = tid()
    p = rule.positions[i]
    x = float64(0.0)
    y = float64(0.0)
    z = float64(0.0)
    weights = float64(0.0)
    for j in range(rule.around.starts[i], rule.around.starts[i + 1]):
        q = rule.positions[rule.around.vertices[j]]
        weight = inverse_distance(p, q)
        if weight > 0.0:
            x += weight * (q[0] - p[0])
            y += weight * (q[1] - p[1])
            z += weight * (q[2] - p[2])
            weights += weight
    if weights > 0.0:
        p = p + factor * (vec3d(x, y, z) / weights)
    out[i] = p


@kernel
def count_down_kernel(remaining: array(dtype=int32)):
    i = tid()
    remaining[i] = remaining[i] - 1


class _Filter:
    """Values by name with a second buffer each, which a pass writes before the two are exchanged."""

    def __init__(self, around: VertexNeighbors, positions: Positions, values: dict[str, Positions]) -> None:
        self.around, self.positions, self.values = around, positions, values
        self._others = {name: empty(rows.size, vec3d, rows.device) for name, rows in values.items()}

    def run(self, kernel_of_pass: Kernel, factor: float) -> None:
        rule = FilterPass(self.around, self.values.get("vertices", self.positions))
        for name, before in self.values.items():
            after = self._others[name]
            if kernel_of_pass is approach_mean_kernel and before is rule.positions:
                launch(approach_mean_position_kernel, before.size, [rule, factor, after])
            else:
                launch(kernel_of_pass, before.size, [rule, before, factor, after])
        self.values, self._others = self._others, self.values

    def run_all(self, passes: Sequence[tuple[Kernel, float]]) -> None:
        for kernel_of_pass, factor in passes:
            self.run(kernel_of_pass, factor)


def filter_values(
    triangles: Triangles,
    positions: Positions,
    names: Iterable[str],
    wide: dict[str, Positions],
    passes: Sequence[tuple[Kernel, float]],
    iterations: int,
    in_order: SortedEdges | None = None,
) -> dict[str, Positions]:
    """Apply passes (kernel, factor) to vec3d [m] arrays, and overwrite these; "vertices" are the positions of the next
    pass. One sync. `in_order`: known result of `sorted_edges`."""
    around = VertexNeighbors(MeshEdges(triangles, positions.size, in_order=in_order), positions.size)
    smoothed = _Filter(around, positions, {name: wide[name] for name in names})
    period = list(passes) if len(passes) % 2 == 0 else [*passes, *passes]  # ends with the buffers that it began with
    periods, rest = divmod(iterations * len(passes), len(period))
    if positions.device.is_cuda or periods < MIN_REPEATED:
        smoothed.run_all(period * periods)
    else:
        remaining: Integers = full(1, periods, int32, positions.device)

        def run_period() -> None:
            smoothed.run_all(period)
            launch(count_down_kernel, 1, [remaining])

        loop_while(remaining, run_period)  # repeats the launches of the first period
    smoothed.run_all(period[:rest])
    return smoothed.values
