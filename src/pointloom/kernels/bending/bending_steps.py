"""Gauss-Newton steps of non-rigid registration by a deformation graph.

A row costs a ((p' - q) n)^2 + b |p' - q|^2. Nodes are regularized by s / degree |R_j (g_k - g_j) + c_j - c_k|^2
(Sumner, Schmid and Pauly 2007, section 4; Li, Sumner and Pauly, "Global correspondence optimization for non-rigid
registration of depth scans", SGP 2008). Matrix-free conjugate gradients, block-Jacobi preconditioner.
"""

import numpy as np

from ..algebra.matrices import multiply33
from ..algebra.rigid_solve import factor_system, rotation_about, solve_factored, square, triangle, triangle_index, vec6d
from ..algebra.transform import widen
from ..arrays.conjugate_gradients import ConjugateGradients, Gradients
from ..arrays.key_starts import find_key_starts
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import read_together
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
    mat33d,
    reduce,
    reduce_segments,
    reduction,
    segment_reduction,
    struct,
    tid,
    vec2d,
    vec3,
    vec3d,
    vector,
)
from ..memory import download, empty, full, zeros
from ..meshes.vertex_neighbors import VertexNeighbors
from .deformation_graph import NODES_PER_POINT, DeformationGraph, Influence, deformed_position

DIAGONAL_DAMPING = 1.0e-9  # of the diagonal: fixes parts of a body without rows, negligible elsewhere
SOLVE_TOLERANCE = 1.0e-6  # of a solve: remaining fraction of the right side in the preconditioner's norm
MAX_ITERATIONS = 2000
pull_sums = vector(6, float64)
pull_block = vector(21, float64)


@struct
class BendingRows:
    """Data terms: weights 0 without a pair; `arms`: rotated node offsets; `forces`: gradients; `order` by node."""

    targets: array(dtype=vec3d)
    normals: array(dtype=vec3)
    plane_weights: array(dtype=float64)
    point_weights: array(dtype=float64)
    arms: array(dtype=vec3d)
    forces: array(dtype=vec3d)
    order: array(dtype=int32)

    def __init__(self, influence: Influence, graph: DeformationGraph) -> None:
        self.count, device = influence.count, influence.points.device
        self.targets, self.normals = zeros(self.count, vec3d, device), zeros(self.count, vec3, device)
        self.plane_weights, self.point_weights = zeros(self.count, float64, device), zeros(self.count, float64, device)
        self.arms, self.forces = zeros(NODES_PER_POINT * self.count, vec3d, device), zeros(self.count, vec3d, device)
        keys, starts = empty(NODES_PER_POINT * self.count, int64, device), empty(graph.count + 1, int32, device)
        launch(key_ends_kernel, keys.size, [influence, graph.count, keys])
        keys, self.order = argsort_keys(keys, max(1, graph.count.bit_length()))
        find_key_starts(keys, starts)
        first = download(starts)  # sync
        self.blocks = SegmentBlocks(first[:-1], np.diff(first), device)


@kernel
def key_ends_kernel(influence: Influence, node_count: int, keys: array(dtype=int64)):
    """Node of each row end; behind all nodes if its weight is zero."""
    i = tid()
    key = int64(node_count)
    if influence.fractions[i] > 0.0:
        key = int64(influence.members[i])
    keys[i] = key


@func
def pull_of(i: int, d: vec3d, rows: BendingRows) -> vec3d:
    """Half the gradient of a row with residual d."""
    n = widen(rows.normals[i])
    return (rows.plane_weights[i] * dot(n, d)) * n + rows.point_weights[i] * d


@kernel
def begin_rows_kernel(graph: DeformationGraph, influence: Influence, rows: BendingRows):
    """Arms and gradients of each row for the current graph."""
    i = tid()
    force = vec3d(0.0, 0.0, 0.0)
    if isfinite(influence.points[i]):
        p = widen(influence.points[i])
        n = int(NODES_PER_POINT)
        for k in range(n):
            node = influence.members[NODES_PER_POINT * i + k]
            rows.arms[NODES_PER_POINT * i + k] = graph.rotations[node] @ (p - widen(graph.nodes[node]))
        force = pull_of(i, deformed_position(i, graph, influence) - rows.targets[i], rows)
    rows.forces[i] = force


@kernel
def map_rows_kernel(steps: array(dtype=vec3d), influence: Influence, rows: BendingRows):
    """Change of the rows' gradients under a step: two vectors per node (rotation, shift)."""
    i = tid()
    d = vec3d(0.0, 0.0, 0.0)
    n = int(NODES_PER_POINT)
    for k in range(n):
        fraction = influence.fractions[NODES_PER_POINT * i + k]
        if fraction > 0.0:
            node = influence.members[NODES_PER_POINT * i + k]
            d += fraction * (cross(steps[2 * node], rows.arms[NODES_PER_POINT * i + k]) + steps[2 * node + 1])
    rows.forces[i] = pull_of(i, d, rows)


@segment_reduction
def sum_node_pulls(influence: Influence, rows: BendingRows) -> pull_sums:
    i = tid()
    end = rows.order[i]
    f = influence.fractions[end] * rows.forces[end // NODES_PER_POINT]
    m = cross(rows.arms[end], f)
    return pull_sums(m[0], m[1], m[2], f[0], f[1], f[2])


@func
def add_square(block: pull_block, arm: vec3d, n: vec3d, weight: float64) -> pull_block:
    """Add the products of the derivatives of n (p' - q) to the upper triangle of a block."""
    m = cross(arm, n)
    g = vec6d(m[0], m[1], m[2], n[0], n[1], n[2])
    total = block
    at = 0
    count = int(6)
    for a in range(count):
        for b in range(a, count):
            total[at] = total[at] + weight * g[a] * g[b]
            at += 1
    return total


@func
def add_squares(block: pull_block, arm: vec3d, weight: float64) -> pull_block:
    total = add_square(block, arm, vec3d(1.0, 0.0, 0.0), weight)
    total = add_square(total, arm, vec3d(0.0, 1.0, 0.0), weight)
    return add_square(total, arm, vec3d(0.0, 0.0, 1.0), weight)


@segment_reduction
def sum_node_squares(influence: Influence, rows: BendingRows) -> pull_block:
    i = tid()
    end = rows.order[i]
    row = end // NODES_PER_POINT
    w = influence.fractions[end] * influence.fractions[end]
    total = add_square(pull_block(0.0), rows.arms[end], widen(rows.normals[row]), w * rows.plane_weights[row])
    return add_squares(total, rows.arms[end], w * rows.point_weights[row])


@struct
class NodeSystem:
    """Node data of a step: neighbors `around`; `sums`, `squares` by node. Block `factors`; damping `lifts` (2 m)."""

    around: VertexNeighbors
    sums: array(dtype=pull_sums)
    squares: array(dtype=pull_block)
    factors: array(dtype=square)
    lifts: array(dtype=vec3d)

    def __init__(self, around: VertexNeighbors, count: int) -> None:
        device = around.starts.device
        self.around, self.lifts = around, zeros(2 * count, vec3d, device)
        self.sums, self.squares = zeros(count, pull_sums, device), zeros(count, pull_block, device)
        self.factors = empty(count, square, device)


@func
def tie_at(i: int, stiffness: float64, around: VertexNeighbors) -> float64:
    return stiffness / float64(max(around.starts[i + 1] - around.starts[i], 1))


@func
def arm_between(i: int, k: int, graph: DeformationGraph) -> vec3d:
    """Offset from node i to k rotated by i."""
    return graph.rotations[i] @ (widen(graph.nodes[k]) - widen(graph.nodes[i]))


@kernel
def pull_nodes_kernel(graph: DeformationGraph, stiffness: float64, system: NodeSystem, residual: array(dtype=vec3d)):
    """Right side of each node: minus half the gradient."""
    i = tid()
    s = system.sums[i]
    torque = vec3d(s[0], s[1], s[2])
    shift = vec3d(s[3], s[4], s[5])
    own = tie_at(i, stiffness, system.around)
    for j in range(system.around.starts[i], system.around.starts[i + 1]):
        k = system.around.vertices[j]
        arm = arm_between(i, k, graph)
        stretch = own * (arm + graph.centers[i] - graph.centers[k])
        across = tie_at(k, stiffness, system.around) * (arm_between(k, i, graph) + graph.centers[k] - graph.centers[i])
        torque += cross(arm, stretch)
        shift += stretch - across
    residual[2 * i] = -torque
    residual[2 * i + 1] = -shift


@kernel
def gather_nodes_kernel(
    steps: array(dtype=vec3d),
    graph: DeformationGraph,
    stiffness: float64,
    system: NodeSystem,
    images: array(dtype=vec3d),
):
    i = tid()
    s = system.sums[i]
    a = system.lifts[2 * i]
    b = system.lifts[2 * i + 1]
    x = steps[2 * i]
    y = steps[2 * i + 1]
    torque = vec3d(s[0] + a[0] * x[0], s[1] + a[1] * x[1], s[2] + a[2] * x[2])
    shift = vec3d(s[3] + b[0] * y[0], s[4] + b[1] * y[1], s[5] + b[2] * y[2])
    own = tie_at(i, stiffness, system.around)
    for j in range(system.around.starts[i], system.around.starts[i + 1]):
        k = system.around.vertices[j]
        arm = arm_between(i, k, graph)
        stretch = own * (cross(x, arm) + y - steps[2 * k + 1])
        across = tie_at(k, stiffness, system.around) * (
            cross(steps[2 * k], arm_between(k, i, graph)) + steps[2 * k + 1] - y
        )
        torque += cross(arm, stretch)
        shift += stretch - across
    images[2 * i] = torque
    images[2 * i + 1] = shift


@kernel
def factor_nodes_kernel(graph: DeformationGraph, stiffness: float64, system: NodeSystem):
    i = tid()
    total = system.squares[i] * float64(1.0)
    own = tie_at(i, stiffness, system.around)
    others = float64(0.0)
    for j in range(system.around.starts[i], system.around.starts[i + 1]):
        k = system.around.vertices[j]
        total = add_squares(total, arm_between(i, k, graph), own)
        others += tie_at(k, stiffness, system.around)
    lifts = vec6d(0.0)
    for k in range(6):
        at = triangle_index(k, k)
        if k >= 3:
            total[at] = total[at] + others
        lifts[k] = float64(DIAGONAL_DAMPING) * total[at]
        total[at] = total[at] + lifts[k]
    system.lifts[2 * i] = vec3d(lifts[0], lifts[1], lifts[2])
    system.lifts[2 * i + 1] = vec3d(lifts[3], lifts[4], lifts[5])
    upper = triangle(0.0)
    for k in range(21):
        upper[k] = total[k]
    system.factors[i] = factor_system(upper)


@kernel
def weigh_nodes_kernel(system: NodeSystem, residual: array(dtype=vec3d), forces: array(dtype=vec3d)):
    i = tid()
    a = residual[2 * i]
    b = residual[2 * i + 1]
    x = solve_factored(system.factors[i], vec6d(a[0], a[1], a[2], b[0], b[1], b[2]))
    forces[2 * i] = vec3d(x[0], x[1], x[2])
    forces[2 * i + 1] = vec3d(x[3], x[4], x[5])


@kernel
def take_step_kernel(steps: array(dtype=vec3d), graph: DeformationGraph):
    i = tid()
    half = 0.5 * steps[2 * i]
    pose = rotation_about(half[0], half[1], half[2], 1.0)
    rotation = mat33d(
        pose[0, 0], pose[0, 1], pose[0, 2],
        pose[1, 0], pose[1, 1], pose[1, 2],
        pose[2, 0], pose[2, 1], pose[2, 2],
    )  # fmt: skip
    graph.rotations[i] = multiply33(rotation, graph.rotations[i])
    graph.centers[i] = graph.centers[i] + steps[2 * i + 1]


@reduction
def sum_shifts(steps: array(dtype=vec3d)) -> vec2d:
    i = tid()
    s = steps[2 * i + 1]
    return vec2d(dot(s, s), 1.0)


class BendingSteps:
    """Steps of a graph whose rows and stiffness may change between them."""

    def __init__(self, graph: DeformationGraph, influence: Influence, around: VertexNeighbors) -> None:
        device, self.graph, self.influence = graph.nodes.device, graph, influence
        self.rows, self.system = BendingRows(influence, graph), NodeSystem(around, graph.count)
        self.live = full(graph.count, 1, int32, device)
        self.partials = self.rows.blocks.partials(pull_sums)
        self.square_partials = self.rows.blocks.partials(pull_block)
        self.iterations = 0

    def take(self, stiffness: float) -> float:
        """One step. Returns the RMS shift of the nodes [m]. One sync."""
        graph, rows, system, count = self.graph, self.rows, self.system, self.graph.count
        launch(begin_rows_kernel, rows.count, [graph, self.influence, rows])
        self._gather()
        blocks = [self.influence, rows]
        reduce_segments(sum_node_squares, rows.blocks, self.live, blocks, self.square_partials, system.squares)
        launch(factor_nodes_kernel, count, [graph, stiffness, system])
        start, unit = zeros(2 * count, vec3d, graph.nodes.device), zeros(1, vec2d, graph.nodes.device)
        state = Gradients(start, SOLVE_TOLERANCE * SOLVE_TOLERANCE, MAX_ITERATIONS, unit)
        launch(pull_nodes_kernel, count, [graph, stiffness, system, state.residual])

        def map_search() -> None:
            launch(map_rows_kernel, rows.count, [state.search, self.influence, rows])
            self._gather()
            launch(gather_nodes_kernel, count, [state.search, graph, stiffness, system, state.image])

        def weigh() -> None:
            launch(weigh_nodes_kernel, count, [system, state.residual, state.forces])

        ConjugateGradients(state, map_search, weigh).solve()
        launch(take_step_kernel, count, [state.solution, graph])
        iterations, sums = read_together([state.iterations, reduce(sum_shifts, count, [state.solution])])  # sync
        self.iterations += int(iterations[0])
        squares, number = sums[0].tolist()
        return float(np.sqrt(squares / max(number, 1)))

    def _gather(self) -> None:
        given = [self.influence, self.rows]
        reduce_segments(sum_node_pulls, self.rows.blocks, self.live, given, self.partials, self.system.sums)
