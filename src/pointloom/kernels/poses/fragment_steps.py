"""Gauss-Newton steps of fragment poses and lattice shifts.

Unknowns: a twist per fragment and a shift per anchor. Rows (fragment_rows.py) plus as-rigid-as-possible terms (Sorkine
and Alexa 2007, eqs. 5 to 9). Matrix-free conjugate gradients with block-Jacobi preconditioner. Damping fixes the common
shift of all anchors and fragments without rows.
"""

from typing import Any

import numpy as np

from ..algebra.rigid_solve import factor_system, solve_factored, square, triangle, triangle_index, vec6d
from ..algebra.transform import widen
from ..array_types import Doubles, Positions
from ..arrays.concatenation import concatenate_rows
from ..arrays.conjugate_gradients import ConjugateGradients, Gradients
from ..lang import (
    array,
    cross,
    float64,
    func,
    int32,
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
    vec3d,
    vector,
)
from ..memory import download, empty, full, upload, zeros
from .anchor_ties import fit_anchor_rotations_kernel, pull_anchors_kernel, sum_stretch
from .control_lattice import ANCHOR_NEIGHBORS, CELL_CORNERS, ControlLattice, corner_weight
from .fragment_rows import FragmentRows, corner_sums, map_rows_kernel, slope_sums

DIAGONAL_DAMPING = 1.0e-6  # of the diagonal: fixes undetermined unknowns, negligible elsewhere
# Of a solve: remaining fraction of the right side (preconditioned). 1e-6 changes no point by 10 um
SOLVE_TOLERANCE = 1.0e-4
MAX_ITERATIONS = 1000
pose_block = vector(21, float64)
anchor_block = vector(6, float64)  # xx, xy, xz, yy, yz, zz


@struct
class StepSystem:
    """The normal equations except the rows. `fixed` fragments; `tie`: weight of squared shift differences;
    `fragment_ends`: 2 pair + 1 as target. Vectors have two rows per fragment, then one per anchor.
    """

    fragment_count: int
    free: array(dtype=int32)
    fragment_starts: array(dtype=int32)
    fragment_ends: array(dtype=int32)
    pair_sums: array(dtype=slope_sums)
    cell_sums: array(dtype=corner_sums)
    pair_blocks: array(dtype=pose_block)
    cell_blocks: array(dtype=anchor_block)
    factors: array(dtype=square)
    blocks: array(dtype=mat33d)
    inverses: array(dtype=mat33d)
    lifts: array(dtype=vec3d)
    rotations: array(dtype=mat33d)
    tie: float64

    def __init__(self, lattice: ControlLattice, fixed: np.ndarray, ends: Any, tie: float) -> None:
        device = lattice.shifts.device
        count, anchors, cells, pairs = len(fixed), lattice.anchor_count, lattice.cell_count, len(ends)
        self.fragment_count, self.size, self.tie = count, 2 * count + anchors, float(tie)
        self.free = upload((~np.asarray(fixed)).astype(np.int32), int32, device)
        flat = np.asarray(ends, np.int64).ravel()
        order = np.argsort(flat, kind="stable")
        starts = np.searchsorted(flat[order], np.arange(count + 1))
        self.fragment_starts = upload(starts.astype(np.int32), int32, device)
        self.fragment_ends = upload(order.astype(np.int32), int32, device)
        self.pair_sums, self.pair_blocks = zeros(pairs, slope_sums, device), zeros(pairs, pose_block, device)
        self.cell_sums, self.cell_blocks = zeros(cells, corner_sums, device), zeros(cells, anchor_block, device)
        self.factors = empty(count, square, device)
        self.blocks, self.inverses = zeros(anchors, mat33d, device), empty(anchors, mat33d, device)
        self.lifts, self.rotations = zeros(self.size, vec3d, device), empty(anchors, mat33d, device)


@segment_reduction
def sum_pair_slopes(rows: FragmentRows, values: array(dtype=float64)) -> slope_sums:
    """Derivatives of a row by its source's pose, times the row's value."""
    i = tid()
    n = widen(rows.normals[i])
    m = cross(widen(rows.positions[i]), n)
    v = values[i]
    return slope_sums(m[0] * v, m[1] * v, m[2] * v, n[0] * v, n[1] * v, n[2] * v)


@segment_reduction
def sum_pair_squares(rows: FragmentRows) -> pose_block:
    """Products of a row's derivatives by its source's pose; equal to those by the target's."""
    i = tid()
    n = widen(rows.normals[i])
    m = cross(widen(rows.positions[i]), n)
    g = vec6d(m[0], m[1], m[2], n[0], n[1], n[2])
    total = pose_block(0.0)
    at = 0
    count = int(6)
    for a in range(count):
        for b in range(a, count):
            total[at] = g[a] * g[b]
            at += 1
    return total


@func
def end_normal(end: int, rows: FragmentRows) -> vec3d:
    n = widen(rows.source_normals[end // 2])
    if end % 2 == 1:
        n = -widen(rows.target_normals[end // 2])
    return n


@func
def end_fraction(end: int, rows: FragmentRows) -> vec3d:
    """Position in its cell of a row end."""
    fraction = widen(rows.source_fractions[end // 2])
    if end % 2 == 1:
        fraction = widen(rows.target_fractions[end // 2])
    return fraction


@segment_reduction
def sum_cell_slopes(rows: FragmentRows, values: array(dtype=float64)) -> corner_sums:
    """Derivatives of a row by the corner shifts at one end, times the row's value."""
    i = tid()
    end = rows.order[i]
    n = end_normal(end, rows) * values[end // 2]
    fraction = end_fraction(end, rows)
    total = corner_sums(0.0)
    for k in range(CELL_CORNERS):
        w = corner_weight(k, fraction)
        total[3 * k] = w * n[0]
        total[3 * k + 1] = w * n[1]
        total[3 * k + 2] = w * n[2]
    return total


@segment_reduction
def sum_cell_squares(rows: FragmentRows, corner: int) -> anchor_block:
    """Products of a row's derivatives by the shift of one corner."""
    i = tid()
    end = rows.order[i]
    n = end_normal(end, rows) * corner_weight(corner, end_fraction(end, rows))
    return anchor_block(n[0] * n[0], n[0] * n[1], n[0] * n[2], n[1] * n[1], n[1] * n[2], n[2] * n[2])


@reduction
def sum_residuals(rows: FragmentRows) -> vec2d:
    i = tid()
    return vec2d(rows.residuals[i] * rows.residuals[i], 1.0)


@kernel
def gather_fragments_kernel(steps: array(dtype=vec3d), system: StepSystem, images: array(dtype=vec3d)):
    i = tid()
    torque = vec3d(0.0, 0.0, 0.0)
    moved = vec3d(0.0, 0.0, 0.0)
    if system.free[i] == 1:
        for k in range(system.fragment_starts[i], system.fragment_starts[i + 1]):
            end = system.fragment_ends[k]
            sums = system.pair_sums[end // 2]
            sign = float64(1 - 2 * (end % 2))
            torque += sign * vec3d(sums[0], sums[1], sums[2])
            moved += sign * vec3d(sums[3], sums[4], sums[5])
        a = system.lifts[2 * i]
        b = system.lifts[2 * i + 1]
        x = steps[2 * i]
        y = steps[2 * i + 1]
        torque += vec3d(a[0] * x[0], a[1] * x[1], a[2] * x[2])
        moved += vec3d(b[0] * y[0], b[1] * y[1], b[2] * y[2])
    images[2 * i] = torque
    images[2 * i + 1] = moved


@kernel
def gather_anchors_kernel(
    steps: array(dtype=vec3d), lattice: ControlLattice, system: StepSystem, images: array(dtype=vec3d)
):
    """Sum the row products at each anchor, with ties and damping."""
    i = tid()
    first = 2 * system.fragment_count
    total = vec3d(0.0, 0.0, 0.0)
    n = int(CELL_CORNERS)
    for k in range(n):
        cell = lattice.sharers[CELL_CORNERS * i + k]
        if cell >= 0:
            total += vec3d(
                system.cell_sums[cell][3 * k], system.cell_sums[cell][3 * k + 1], system.cell_sums[cell][3 * k + 2]
            )
    x = steps[first + i]
    m = int(ANCHOR_NEIGHBORS)
    for k in range(m):
        other = lattice.around[ANCHOR_NEIGHBORS * i + k]
        if other >= 0:
            total += 2.0 * system.tie * (x - steps[first + other])
    lift = system.lifts[first + i]
    images[first + i] = total + vec3d(lift[0] * x[0], lift[1] * x[1], lift[2] * x[2])


@kernel
def factor_fragments_kernel(damping: float64, system: StepSystem):
    """Damping and block factors of each fragment. Zero without rows."""
    i = tid()
    total = triangle(0.0)
    for k in range(system.fragment_starts[i], system.fragment_starts[i + 1]):
        total += system.pair_blocks[system.fragment_ends[k] // 2]
    lifts = vec6d(0.0)
    for k in range(6):
        at = triangle_index(k, k)
        lifts[k] = damping * total[at]
        total[at] = total[at] + lifts[k]
    system.lifts[2 * i] = vec3d(lifts[0], lifts[1], lifts[2])
    system.lifts[2 * i + 1] = vec3d(lifts[3], lifts[4], lifts[5])
    system.factors[i] = factor_system(total)


@kernel
def add_anchor_blocks_kernel(corner: int, lattice: ControlLattice, system: StepSystem):
    i = tid()
    cell = lattice.sharers[CELL_CORNERS * i + corner]
    if cell >= 0:
        b = system.cell_blocks[cell]
        system.blocks[i] = system.blocks[i] + mat33d(b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5])


@func
def invert_symmetric(a: mat33d) -> mat33d:
    """Inverse of a positive definite matrix by cofactors. Zero if singular."""
    xx = a[1, 1] * a[2, 2] - a[1, 2] * a[1, 2]
    xy = a[0, 2] * a[1, 2] - a[0, 1] * a[2, 2]
    xz = a[0, 1] * a[1, 2] - a[0, 2] * a[1, 1]
    yy = a[0, 0] * a[2, 2] - a[0, 2] * a[0, 2]
    yz = a[0, 1] * a[0, 2] - a[0, 0] * a[1, 2]
    zz = a[0, 0] * a[1, 1] - a[0, 1] * a[0, 1]
    size = a[0, 0] * xx + a[0, 1] * xy + a[0, 2] * xz
    fraction = float64(0.0)
    if size > 0.0:
        fraction = 1.0 / size
    return mat33d(xx, xy, xz, xy, yy, yz, xz, yz, zz) * fraction


@kernel
def invert_anchors_kernel(damping: float64, lattice: ControlLattice, system: StepSystem):
    """Damping of each anchor, and the inverse of its block with ties."""
    i = tid()
    block = system.blocks[i]
    ties = float64(0.0)
    n = int(ANCHOR_NEIGHBORS)
    for k in range(n):
        if lattice.around[ANCHOR_NEIGHBORS * i + k] >= 0:
            ties += 2.0 * system.tie
    lift = vec3d(damping * (block[0, 0] + ties), damping * (block[1, 1] + ties), damping * (block[2, 2] + ties))
    for k in range(3):
        block[k, k] = block[k, k] + ties + lift[k]
    system.lifts[2 * system.fragment_count + i] = lift
    system.inverses[i] = invert_symmetric(block)


@kernel
def weigh_fragments_kernel(system: StepSystem, residual: array(dtype=vec3d), forces: array(dtype=vec3d)):
    i = tid()
    a = residual[2 * i]
    b = residual[2 * i + 1]
    x = solve_factored(system.factors[i], vec6d(a[0], a[1], a[2], b[0], b[1], b[2]))
    fraction = float64(system.free[i])
    forces[2 * i] = vec3d(x[0], x[1], x[2]) * fraction
    forces[2 * i + 1] = vec3d(x[3], x[4], x[5]) * fraction


@kernel
def weigh_anchors_kernel(system: StepSystem, residual: array(dtype=vec3d), forces: array(dtype=vec3d)):
    i = tid()
    row = 2 * system.fragment_count + i
    forces[row] = system.inverses[i] @ residual[row]


@kernel
def negate_kernel(images: array(dtype=vec3d), residual: array(dtype=vec3d)):
    """Right side: minus half the gradient."""
    i = tid()
    residual[i] = -images[i]


class FragmentStep:
    """One step: the errors before it, and the solution. Without cells the fragments are rigid."""

    def __init__(self, rows: FragmentRows, lattice: ControlLattice, system: StepSystem) -> None:
        device = lattice.shifts.device
        self.rows, self.lattice, self.system = rows, lattice, system
        self.live_pairs = full(max(system.pair_sums.size, 1), 1, int32, device)
        self.live_cells = full(max(lattice.cell_count, 1), 1, int32, device)
        self.pair_partials = rows.sums.partials(slope_sums)
        self.cell_partials = rows.cells.partials(corner_sums)
        launch(fit_anchor_rotations_kernel, lattice.anchor_count, [lattice, system.rotations])

    def errors(self) -> tuple[float, int, float]:
        """(sum of squared residuals, rows, regularization error); syncs."""
        ties = [self.lattice, self.system.tie, self.system.rotations]
        residuals = reduce(sum_residuals, self.rows.count, [self.rows])
        stretches = reduce(sum_stretch, self.lattice.anchor_count, ties)
        (squares, count), (stretch, _) = download(concatenate_rows([residuals, stretches])).tolist()  # sync
        return squares, int(count), stretch

    def solve(self, tolerance: float = SOLVE_TOLERANCE) -> tuple[Positions, int]:
        """The step, vec3d (2 fragments + anchors), and the iteration count."""
        system, device = self.system, self.lattice.shifts.device
        self._make_blocks()
        start, unit = zeros(system.size, vec3d, device), zeros(1, vec2d, device)
        state = Gradients(start, tolerance * tolerance, MAX_ITERATIONS, unit)
        self._gather(self.rows.residuals, state.solution, state.image)
        ties = [self.lattice, system.tie, system.rotations, 2 * system.fragment_count, state.image]
        launch(pull_anchors_kernel, self.lattice.anchor_count, ties)
        launch(negate_kernel, system.size, [state.image, state.residual])
        ConjugateGradients(state, lambda: self._map(state), lambda: self._weigh(state)).solve()
        return state.solution, int(download(state.iterations)[0])  # sync

    def _map(self, state: Gradients) -> None:
        launch(
            map_rows_kernel, self.rows.count, [2 * self.system.fragment_count, state.search, self.lattice, self.rows]
        )
        self._gather(self.rows.images, state.search, state.image)

    def _gather(self, values: Doubles, steps: Positions, images: Positions) -> None:
        """Apply the transposed rows to `values`, and ties and damping to `steps`."""
        system, lattice, rows = self.system, self.lattice, self.rows
        reduce_segments(
            sum_pair_slopes, rows.sums, self.live_pairs, [rows, values], self.pair_partials, system.pair_sums
        )
        launch(gather_fragments_kernel, system.fragment_count, [steps, system, images])
        if lattice.cell_count:
            reduce_segments(
                sum_cell_slopes, rows.cells, self.live_cells, [rows, values], self.cell_partials, system.cell_sums
            )
            launch(gather_anchors_kernel, lattice.anchor_count, [steps, lattice, system, images])

    def _weigh(self, state: Gradients) -> None:
        launch(weigh_fragments_kernel, self.system.fragment_count, [self.system, state.residual, state.forces])
        launch(weigh_anchors_kernel, self.lattice.anchor_count, [self.system, state.residual, state.forces])

    def _make_blocks(self) -> None:
        system, lattice, rows = self.system, self.lattice, self.rows
        partials = rows.sums.partials(pose_block)
        reduce_segments(sum_pair_squares, rows.sums, self.live_pairs, [rows], partials, system.pair_blocks)
        launch(factor_fragments_kernel, system.fragment_count, [DIAGONAL_DAMPING, system])
        if lattice.cell_count:
            partials = rows.cells.partials(anchor_block)
            launch(clear_blocks_kernel, lattice.anchor_count, [system.blocks])
            for corner in range(CELL_CORNERS):
                reduce_segments(
                    sum_cell_squares, rows.cells, self.live_cells, [rows, corner], partials, system.cell_blocks
                )
                launch(add_anchor_blocks_kernel, lattice.anchor_count, [corner, lattice, system])
            launch(invert_anchors_kernel, lattice.anchor_count, [DIAGONAL_DAMPING, lattice, system])


@kernel
def clear_blocks_kernel(blocks: array(dtype=mat33d)):
    i = tid()
    blocks[i] = mat33d(0.0)
