"""Laplacian solver in one launch: all iterations of conjugate gradients and all levels of the preconditioner.

The levels are stacked: one graph whose parts are the levels, finest first. One block of a GPU runs the phases of
conjugate_gradients.py and graph_levels.py with a wait between them, instead of about 30 dependent launches per
iteration. On the CPU one thread does. About 180 B per neighbor.
"""

from types import SimpleNamespace
from typing import Any

import numpy as np

from ..array_types import Device, Positions
from ..arrays.blocks import WARPS, block_threads, sum_of_block, wait_for_block
from ..arrays.conjugate_gradients import Gradients
from ..lang import ELEMENTS_PER_BLOCK, array, dot, float64, func, int32, kernel, launch, struct, tid, vec2d, vec3d
from ..memory import empty, rows_of, upload, zeros
from .graph_levels import Coarsening, Level, Preconditioner, corrected, left_residual, row_product, swept

MAX_CUDA_ROWS = 8192  # vertices: 32 per thread, about 50 us an iteration. Larger graphs need more multiprocessors


def max_rows(device: Device) -> int:
    """Maximum number of vertices. On the CPU one block of a sum, so that the order of sums is that of the launches."""
    return MAX_CUDA_ROWS if device.is_cuda else ELEMENTS_PER_BLOCK


@struct
class Stack:
    """Stacked levels: `level` is their graph, `first_rows` [levels + 1] their first rows. Coarse row c sums the rows
    `members[firsts[c]]` to `members[lasts[c] - 1]`. `inverse` is that of the coarsest matrix (0, 0: none)."""

    level: Level
    parents: array(dtype=int32)
    members: array(dtype=int32)
    firsts: array(dtype=int32)
    lasts: array(dtype=int32)
    first_rows: array(dtype=int32)
    inverse: array(dtype=float64, ndim=2)
    residual: array(dtype=vec3d)
    guess: array(dtype=vec3d)
    forces: array(dtype=vec3d)
    partials: array(dtype=vec2d)

    def __init__(self, preconditioner: Preconditioner, state: Gradients) -> None:
        """`state` gets the finest rows of residual and forces."""
        levels, device = preconditioner.levels, state.solution.device
        firsts = np.cumsum([0, *(level.count for level in levels)])
        pairs = np.cumsum([0, *(level.pulls.size for level in levels)])
        rows, pair_count = int(firsts[-1]), int(pairs[-1])
        around: Any = SimpleNamespace(starts=zeros(rows + 1, int32, device), vertices=empty(pair_count, int32, device))
        around.edges = around.vertices  # not read
        graph: Any = SimpleNamespace(around=around, pulls=empty(pair_count, float64, device))
        graph.diagonal, graph.steps = empty(rows, float64, device), empty(rows, float64, device)
        graph.free = empty(rows, int32, device)
        self.level = graph
        self.parents, self.members, self.firsts, self.lasts = (zeros(rows, int32, device) for _ in range(4))
        self.first_rows = upload(firsts, int32, device)
        inverse = preconditioner.inverse
        self.inverse = empty((0, 0), float64, device) if inverse is None else inverse
        self.residual, self.guess, self.forces = (empty(rows, vec3d, device) for _ in range(3))
        self.partials = empty(WARPS, vec2d, device)
        for level, row, pair in zip(levels, firsts.tolist(), pairs.tolist(), strict=False):
            launch(stack_level_kernel, max(level.count, level.pulls.size), [level, row, pair, self])
        for level, coarsening, row in zip(levels, preconditioner.coarsenings, firsts.tolist(), strict=False):
            launch(stack_members_kernel, level.count, [coarsening, row, row + level.count, coarsening.count, self])
        state.residual, state.forces = (rows_of(v, 0, levels[0].count) for v in (self.residual, self.forces))


@kernel
def stack_level_kernel(level: Level, row: int, pair: int, stack: Stack):
    i = tid()
    if i < level.free.shape[0]:
        stack.level.around.starts[row + i + 1] = pair + level.around.starts[i + 1]
        stack.level.diagonal[row + i] = level.diagonal[i]
        stack.level.steps[row + i] = level.steps[i]
        stack.level.free[row + i] = level.free[i]
    if i < level.pulls.shape[0]:
        stack.level.around.vertices[pair + i] = row + level.around.vertices[i]
        stack.level.pulls[pair + i] = level.pulls[i]


@kernel
def stack_members_kernel(coarsening: Coarsening, row: int, coarse_row: int, coarse_count: int, stack: Stack):
    i = tid()
    stack.parents[row + i] = coarse_row + coarsening.parents[i]
    stack.members[row + i] = row + coarsening.members[i]
    if i < coarse_count:
        stack.firsts[coarse_row + i] = row + coarsening.starts[i]
        stack.lasts[coarse_row + i] = row + coarsening.starts[i + 1]


@func
def precondition(i: int, threads: int, stack: Stack):
    """One cycle from the finest `residual` to the finest `forces`, as Preconditioner.apply."""
    depths = stack.first_rows.shape[0] - 2
    for depth in range(depths):
        row = stack.first_rows[depth + 1] + i
        while row < stack.first_rows[depth + 2]:
            total = vec3d(0.0, 0.0, 0.0)
            for j in range(stack.firsts[row], stack.lasts[row]):
                total = total + left_residual(stack.level, stack.residual, stack.members[j])
            stack.residual[row] = total
            row += threads
        wait_for_block()
    first = stack.first_rows[depths]
    row = first + i
    while row < stack.first_rows[depths + 1]:
        force = stack.level.steps[row] * stack.residual[row]
        if stack.inverse.shape[0] > 0:
            force = vec3d(0.0, 0.0, 0.0)
            for j in range(stack.inverse.shape[0]):
                force = force + stack.inverse[row - first, j] * stack.residual[first + j]
        stack.forces[row] = force
        row += threads
    wait_for_block()
    for step in range(depths):
        depth = depths - 1 - step
        row = stack.first_rows[depth] + i
        while row < stack.first_rows[depth + 1]:
            stack.guess[row] = corrected(stack.level, stack.residual, stack.forces, stack.parents, row)
            row += threads
        wait_for_block()
        row = stack.first_rows[depth] + i
        while row < stack.first_rows[depth + 1]:
            stack.forces[row] = swept(stack.level, stack.residual, stack.guess, row)
            row += threads
        wait_for_block()


@func
def sum_remaining(i: int, threads: int, stack: Stack) -> float64:
    """residual . forces of the finest rows."""
    total = vec2d(0.0, 0.0)
    row = i + 0
    while row < stack.first_rows[1]:
        total = total + vec2d(dot(stack.residual[row], stack.forces[row]), 0.0)
        row += threads
    total = sum_of_block(i, total, stack.partials)
    return total[0]


@kernel
def solve_kernel(threads: int, right: array(dtype=vec3d), stack: Stack, state: Gradients):
    """A complete solve that starts from the last solution. All threads decide alike when it ends."""
    i = tid()
    count = stack.first_rows[1]
    row = i + 0
    while row < count:
        rest = vec3d(0.0, 0.0, 0.0)
        if stack.level.free[row] == 1:
            rest = right[row] - row_product(stack.level, state.solution, row)
        stack.residual[row] = rest
        row += threads
    wait_for_block()
    precondition(i, threads, stack)
    remains = sum_remaining(i, threads, stack)
    row = i + 0
    while row < count:
        state.search[row] = stack.forces[row]
        row += threads
    wait_for_block()
    limit = state.limit * state.unit[0][0]
    iterations = 0
    while remains > limit and iterations < state.max_iterations:
        slopes = vec2d(0.0, 0.0)
        row = i + 0
        while row < count:
            image = vec3d(0.0, 0.0, 0.0)
            if stack.level.free[row] == 1:
                image = row_product(stack.level, state.search, row)
            state.image[row] = image
            forces = stack.forces[row]
            slopes = slopes + vec2d(dot(state.search[row], image), dot(stack.residual[row], forces))
            row += threads
        slopes = sum_of_block(i, slopes, stack.partials)
        step = float64(0.0)
        if slopes[0] > 0.0:
            step = slopes[1] / slopes[0]
        row = i + 0
        while row < count:
            state.solution[row] = state.solution[row] + step * state.search[row]
            stack.residual[row] = stack.residual[row] - step * state.image[row]
            row += threads
        wait_for_block()
        precondition(i, threads, stack)
        remains = sum_remaining(i, threads, stack)
        fraction = float64(0.0)
        if slopes[1] > 0.0:
            fraction = remains / slopes[1]
        row = i + 0
        while row < count:
            state.search[row] = stack.forces[row] + fraction * state.search[row]
            row += threads
        wait_for_block()
        iterations += 1
    if i == 0:
        state.iterations[0] = iterations
        if remains > limit:
            state.stuck[0] = 1


class BlockSolver:
    """Solver for one set of levels with up to `max_rows` vertices."""

    def __init__(self, preconditioner: Preconditioner, state: Gradients) -> None:
        self.state, self._stack = state, Stack(preconditioner, state)
        self._threads = block_threads(state.solution.device)

    def solve(self, right: Positions) -> None:
        """Solve for right-hand sides vec3d [m] in `state.solution`: one launch."""
        launch(solve_kernel, self._threads, [self._threads, right, self._stack, self.state])
