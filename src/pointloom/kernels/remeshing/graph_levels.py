"""Multigrid preconditioner of graph Laplacians: aggregation of vertices to coarser levels.

Notay, "An aggregation-based algebraic multigrid method", ETNA 37, 2010. Each level selects an independent set of free
vertices by hash. Others join the neighbor with the largest weight. Galerkin matrices in a fixed order. The coarsest is
inverted. A damped Jacobi sweep per level down and up, symmetric for conjugate gradients. About 60 B per neighbor.
"""

from ..array_types import Array2, Doubles, Indices, Integers, Positions
from ..arrays.blocks import block_threads, wait_for_block
from ..arrays.hash_table import mix_bits
from ..arrays.key_starts import find_key_starts
from ..arrays.prefix_sum import offsets_of
from ..arrays.run_sums import sum_columns
from ..arrays.sort import argsort_keys
from ..arrays.unique import UniqueKeys
from ..lang import array, float64, func, int32, int64, kernel, launch, struct, tid, vec3d
from ..memory import cast, download, empty, full, zeros
from ..meshes.mesh_edges import MeshEdges, split_edge_keys_kernel
from ..meshes.vertex_neighbors import VertexNeighbors

SELECTION_ROUNDS = 8  # of selection. Vertices still undecided are then selected
JACOBI_DAMPING = 0.85  # of Jacobi sweeps, which are stable below 1. 0.7 takes a tenth more iterations
# of corrections, since the coarse system is stiffer than the error. 2 takes twice the iterations
CORRECTION_FACTOR = 1.2
MAX_INVERTED_VERTICES = 100  # vertices of the inverted matrix, 80 kB: one block inverts it
PIVOT_ROUNDING = 1.0e-14  # of its diagonal: rounding of a pivot that should be zero
UNDECIDED_VERTEX, CHOSEN_VERTEX, JOINED_VERTEX = 0, 1, 2


@struct
class Level:
    """A graph with nonnegative edge weights `pulls` [2 e], the matrix `diagonal` (weights plus excess), `free` (0 for
    fixed vertices), and Jacobi factors `steps` (0 if fixed)."""

    around: VertexNeighbors
    pulls: array(dtype=float64)
    diagonal: array(dtype=float64)
    free: array(dtype=int32)
    steps: array(dtype=float64)

    def __init__(
        self, edges: "MeshEdges | CoarseEdges", weights: Doubles, excess: Array2[float64], free: Integers
    ) -> None:
        """`edges` are sorted `lows`, `highs` (int32 [e]) and `count`; `excess` [m, 1] is added to the diagonal."""
        device, self.count = free.device, free.size
        self.edges, self.weights, self.free = edges, weights, free
        self.around = VertexNeighbors(edges, self.count)
        self.pulls, self.diagonal = empty(2 * edges.count, float64, device), empty(self.count, float64, device)
        self.steps = empty(self.count, float64, device)
        launch(
            spread_weights_kernel,
            self.count,
            [self.around, weights, excess, free, self.pulls, self.diagonal, self.steps],
        )


@kernel
def spread_weights_kernel(
    around: VertexNeighbors,
    weights: array(dtype=float64),
    excess: array(dtype=float64, ndim=2),
    free: array(dtype=int32),
    pulls: array(dtype=float64),
    diagonal: array(dtype=float64),
    steps: array(dtype=float64),
):
    """Weight of each neighbor, their sum with the excess, and the Jacobi factor."""
    i = tid()
    total = excess[i, 0]
    for j in range(around.starts[i], around.starts[i + 1]):
        weight = weights[around.edges[j]]
        pulls[j] = weight
        total += weight
    diagonal[i] = total
    step = float64(0.0)
    if free[i] == 1 and total > 0.0:
        step = float64(JACOBI_DAMPING) / total
    steps[i] = step


@func
def row_product(level: Level, values: array(dtype=vec3d), i: int) -> vec3d:
    total = level.diagonal[i] * values[i]
    for j in range(level.around.starts[i], level.around.starts[i + 1]):
        weight = level.pulls[j]
        if weight > 0.0:  # values of vertices without weight may be NaN
            total = total - weight * values[level.around.vertices[j]]
    return total


@func
def precedes(i: int, j: int) -> int:
    a = mix_bits(int64(i))
    b = mix_bits(int64(j))
    before = 0
    if a > b or (a == b and i > j):
        before = 1
    return before


@kernel
def choose_peaks_kernel(level: Level, states: array(dtype=int32), last: int, peaks: array(dtype=int32)):
    """1 for undecided vertices with priority over their undecided neighbors. On the last pass for all undecided."""
    i = tid()
    rivals = 0
    for j in range(level.around.starts[i], level.around.starts[i + 1]):
        other = level.around.vertices[j]
        if level.pulls[j] > 0.0 and level.free[other] == 1:
            if states[other] == UNDECIDED_VERTEX and last == 0:
                rivals += precedes(other, i)
    peak = 0
    if rivals == 0 and level.free[i] == 1 and states[i] == UNDECIDED_VERTEX:
        peak = 1
    peaks[i] = peak


@kernel
def join_peaks_kernel(level: Level, peaks: array(dtype=int32), states: array(dtype=int32)):
    """Select the peaks, and mark their undecided neighbors to join one."""
    i = tid()
    if peaks[i] == 1:
        states[i] = CHOSEN_VERTEX
    elif level.free[i] == 1 and states[i] == UNDECIDED_VERTEX:
        for j in range(level.around.starts[i], level.around.starts[i + 1]):
            if level.pulls[j] > 0.0:
                if peaks[level.around.vertices[j]] == 1:
                    states[i] = JOINED_VERTEX


@kernel
def mark_chosen_kernel(states: array(dtype=int32), marks: array(dtype=int32)):
    i = tid()
    mark = 0
    if states[i] == CHOSEN_VERTEX:
        mark = 1
    marks[i] = mark


@kernel
def find_parents_kernel(
    level: Level, states: array(dtype=int32), coarse_indices: array(dtype=int32), parents: array(dtype=int32)
):
    """Coarse vertex of each vertex: that of the selected neighbor with the largest weight. The last index if fixed."""
    i = tid()
    parent = coarse_indices[coarse_indices.shape[0] - 1]
    if states[i] == CHOSEN_VERTEX:
        parent = coarse_indices[i]
    elif states[i] == JOINED_VERTEX:
        heaviest = float64(0.0)
        for j in range(level.around.starts[i], level.around.starts[i + 1]):
            other = level.around.vertices[j]
            weight = level.pulls[j]
            if states[other] == CHOSEN_VERTEX and weight > heaviest:
                heaviest = weight
                parent = coarse_indices[other]
    parents[i] = parent


@kernel
def key_coarse_edges_kernel(
    lows: array(dtype=int32),
    highs: array(dtype=int32),
    parents: array(dtype=int32),
    weights: array(dtype=float64),
    coarse_indices: array(dtype=int32),
    bits: int,
    keys: array(dtype=int64),
):
    """Coarse vertices at each edge, the lower first. A key above all unless they are two."""
    i = tid()
    a = parents[lows[i]]
    b = parents[highs[i]]
    none = coarse_indices[coarse_indices.shape[0] - 1]
    key = (int64(1) << int64(2 * bits)) - 1
    if a != b and a != none and b != none and weights[i] > 0.0:
        key = (int64(min(a, b)) << int64(bits)) | int64(max(a, b))
    keys[i] = key


@kernel
def measure_excess_kernel(level: Level, excess: array(dtype=float64, ndim=2)):
    """Diagonal of a free vertex without its weights to free neighbors."""
    i = tid()
    rest = float64(0.0)
    if level.free[i] == 1:
        rest = level.diagonal[i]
        for j in range(level.around.starts[i], level.around.starts[i + 1]):
            if level.free[level.around.vertices[j]] == 1:
                rest -= level.pulls[j]
    excess[i, 0] = max(rest, 0.0)


class CoarseEdges:
    """Sorted edges between `vertex_count` coarse vertices, with weights. Both counts need one sync per level."""

    def __init__(self, level: Level, parents: Indices, coarse_indices: Integers) -> None:
        device, coarse = parents.device, coarse_indices[level.count :]
        max_count = level.count if device.is_cuda else int(download(coarse)[0])  # fewer bits sort faster
        bits = max(1, (max_count + 1).bit_length())
        keys = empty(level.edges.count, int64, device)
        arguments = [level.edges.lows, level.edges.highs, parents, level.weights, coarse_indices, bits, keys]
        launch(key_coarse_edges_kernel, level.edges.count, arguments)
        unique = UniqueKeys(keys, 2 * bits, beside=coarse)  # sync
        self.vertex_count = unique.beside[0]
        unique.drop_last((1 << (2 * bits)) - 1)
        self.count = unique.count
        self.lows, self.highs = empty(self.count, int32, device), empty(self.count, int32, device)
        launch(split_edge_keys_kernel, self.count, [unique.keys, bits, self.lows, self.highs])
        rows = level.weights.reshape((level.weights.size, 1))
        self.weights = sum_columns(rows, unique.order, unique.starts).reshape(self.count)


@struct
class Coarsening:
    """Aggregates of a level, and buffers of a cycle: `parents` int32 [m] (coarse vertex, or their number for none),
    sorted `members` by coarse vertex, correction `guess` on the way up."""

    parents: array(dtype=int32)
    members: array(dtype=int32)
    starts: array(dtype=int32)
    guess: array(dtype=vec3d)

    def __init__(self, level: Level) -> None:
        device, count = level.free.device, level.count
        states, peaks, marks = zeros(count, int32, device), empty(count, int32, device), empty(count, int32, device)
        for iteration in range(SELECTION_ROUNDS):
            launch(choose_peaks_kernel, count, [level, states, int(iteration == SELECTION_ROUNDS - 1), peaks])
            launch(join_peaks_kernel, count, [level, peaks, states])
        launch(mark_chosen_kernel, count, [states, marks])
        coarse_indices = offsets_of(marks)
        self.parents = empty(count, int32, device)
        launch(find_parents_kernel, count, [level, states, coarse_indices, self.parents])
        self._edges = CoarseEdges(level, self.parents, coarse_indices)  # sync
        self.count = self._edges.vertex_count
        keys, self.members = argsort_keys(cast(self.parents, int64), max(1, self.count.bit_length()))
        self.starts = empty(self.count + 1, int32, device)
        find_key_starts(keys, self.starts)
        self.guess = empty(count, vec3d, device)

    def coarser(self, level: Level) -> Level:
        device, edges = level.free.device, self._edges
        excess = empty((level.count, 1), float64, device)
        launch(measure_excess_kernel, level.count, [level, excess])
        coarse_excess = sum_columns(excess, self.members, self.starts)
        return Level(edges, edges.weights, coarse_excess, full(self.count, 1, int32, device))


@func
def left_residual(level: Level, residual: array(dtype=vec3d), i: int) -> vec3d:
    """Residual after a damped Jacobi sweep from zero."""
    rest = vec3d(0.0, 0.0, 0.0)
    if level.free[i] == 1:
        rest = residual[i] - (level.diagonal[i] * level.steps[i]) * residual[i]
        for j in range(level.around.starts[i], level.around.starts[i + 1]):
            other = level.around.vertices[j]
            rest = rest + (level.pulls[j] * level.steps[other]) * residual[other]
    return rest


@kernel
def restrict_kernel(level: Level, residual: array(dtype=vec3d), coarsening: Coarsening, coarse: array(dtype=vec3d)):
    """Sum of the members' residuals after the sweep, one thread per coarse vertex."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    for j in range(coarsening.starts[i], coarsening.starts[i + 1]):
        total = total + left_residual(level, residual, coarsening.members[j])
    coarse[i] = total


@func
def corrected(
    level: Level, residual: array(dtype=vec3d), coarse: array(dtype=vec3d), parents: array(dtype=int32), i: int
) -> vec3d:
    """Damped Jacobi sweep from zero plus the correction of the coarser level."""
    guess = level.steps[i] * residual[i]
    if level.free[i] == 1:
        guess = guess + float64(CORRECTION_FACTOR) * coarse[parents[i]]
    return guess


@kernel
def correct_kernel(level: Level, residual: array(dtype=vec3d), coarse: array(dtype=vec3d), coarsening: Coarsening):
    i = tid()
    coarsening.guess[i] = corrected(level, residual, coarse, coarsening.parents, i)


@func
def swept(level: Level, residual: array(dtype=vec3d), guess: array(dtype=vec3d), i: int) -> vec3d:
    value = guess[i]
    if level.steps[i] > 0.0:
        value = value + level.steps[i] * (residual[i] - row_product(level, guess, i))
    return value


@kernel
def sweep_kernel(level: Level, residual: array(dtype=vec3d), guess: array(dtype=vec3d), out: array(dtype=vec3d)):
    i = tid()
    out[i] = swept(level, residual, guess, i)


@kernel
def sweep_alone_kernel(level: Level, residual: array(dtype=vec3d), out: array(dtype=vec3d)):
    i = tid()
    out[i] = level.steps[i] * residual[i]


@kernel
def fill_matrix_kernel(level: Level, matrix: array(dtype=float64, ndim=2)):
    i = tid()
    matrix[i, i] = 1.0
    if level.free[i] == 1:
        matrix[i, i] = level.diagonal[i]
        for j in range(level.around.starts[i], level.around.starts[i + 1]):
            other = level.around.vertices[j]
            if level.free[other] == 1:
                matrix[i, other] = -level.pulls[j]


@func
def eliminate_row(
    level: Level, matrix: array(dtype=float64, ndim=2), k: int, row: int, out: array(dtype=float64, ndim=2)
):
    """Gauss-Jordan step of unknown k for a row. Zeros for a zero pivot."""
    scale = max(level.diagonal[k], matrix[k, k])
    inverse = float64(0.0)
    if matrix[k, k] > float64(PIVOT_ROUNDING) * scale:
        inverse = 1.0 / matrix[k, k]
    factor = matrix[row, k] * inverse
    for column in range(matrix.shape[0]):
        out[row, column] = matrix[row, column] - factor * matrix[k, column]
    if row == k:
        for column in range(matrix.shape[0]):
            out[row, column] = inverse * matrix[k, column]
    out[row, k] = -inverse * matrix[row, k]
    if row == k:
        out[row, k] = inverse


@kernel
def invert_kernel(
    level: Level, threads: int, matrix: array(dtype=float64, ndim=2), other: array(dtype=float64, ndim=2)
):
    """Two steps per iteration, from `matrix` to `other` and back. One block on CUDA, one thread on the CPU."""
    i = tid()
    count = matrix.shape[0]
    for half in range((count + 1) // 2):
        row = i + 0
        while row < count:
            eliminate_row(level, matrix, 2 * half, row, other)
            row += threads
        wait_for_block()
        row = i + 0
        while row < count:
            if 2 * half + 1 < count:
                eliminate_row(level, other, 2 * half + 1, row, matrix)
            else:
                for column in range(count):
                    matrix[row, column] = other[row, column]
            row += threads
        wait_for_block()


@kernel
def multiply_kernel(matrix: array(dtype=float64, ndim=2), values: array(dtype=vec3d), out: array(dtype=vec3d)):
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    for j in range(matrix.shape[0]):
        total = total + matrix[i, j] * values[j]
    out[i] = total


def invert(level: Level) -> Array2[float64]:
    """Inverse of a level's symmetric positive definite matrix, float64 [m, m], without pivoting."""
    device, count = level.free.device, level.count
    matrix, other = zeros((count, count), float64, device), empty((count, count), float64, device)
    launch(fill_matrix_kernel, count, [level, matrix])
    threads = block_threads(device)
    launch(invert_kernel, threads, [level, threads, matrix, other])
    return matrix


class Preconditioner:
    """Multigrid cycle from the given finest level."""

    def __init__(self, level: Level) -> None:
        device, self.levels, self.coarsenings = level.free.device, [level], []
        while self.levels[-1].count > MAX_INVERTED_VERTICES:
            coarsening = Coarsening(self.levels[-1])
            if not 0 < coarsening.count < self.levels[-1].count:
                break
            self.coarsenings.append(coarsening)
            self.levels.append(coarsening.coarser(self.levels[-1]))
        self.residuals = [None, *(empty(coarse.count, vec3d, device) for coarse in self.levels[1:])]
        self.forces = [None, *(empty(coarse.count, vec3d, device) for coarse in self.levels[1:])]
        last = self.levels[-1]
        self.inverse = (
            invert(last) if last.count <= MAX_INVERTED_VERTICES else None
        )  # else no vertex has a neighbor there

    def apply(self, residual: Positions, forces: Positions) -> None:
        """Write the result of a cycle on a residual to `forces` (vec3d [m]); allocates nothing."""
        self.residuals[0], self.forces[0] = residual, forces
        for depth, coarsening in enumerate(self.coarsenings):
            level = self.levels[depth]
            rows = [level, self.residuals[depth], coarsening, self.residuals[depth + 1]]
            launch(restrict_kernel, coarsening.count, rows)
        self._solve_coarsest()
        for depth in reversed(range(len(self.coarsenings))):
            level, coarsening, rest = self.levels[depth], self.coarsenings[depth], self.residuals[depth]
            launch(correct_kernel, level.count, [level, rest, self.forces[depth + 1], coarsening])
            launch(sweep_kernel, level.count, [level, rest, coarsening.guess, self.forces[depth]])

    def _solve_coarsest(self) -> None:
        level, rest, out = self.levels[-1], self.residuals[-1], self.forces[-1]
        if self.inverse is None:
            launch(sweep_alone_kernel, level.count, [level, rest, out])
        else:
            launch(multiply_kernel, level.count, [self.inverse, rest, out])
