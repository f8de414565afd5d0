"""Conjugate gradients over vectors of vec3d (Hestenes and Stiefel 1952; Golub and Van Loan, section 11.5).

The caller provides the matrix product (`search` to `image`) and the preconditioner (`residual` to `forces`). Float64
sums in fixed order. The loop ends on the device.
"""

from collections.abc import Callable
from typing import Any

from ..array_types import Array1, Positions
from ..lang import (
    DeviceLoop,
    array,
    dot,
    float64,
    int32,
    kernel,
    launch,
    reduce_segments,
    segment_reduction,
    struct,
    tid,
    vec2d,
    vec3d,
)
from ..memory import copy, empty, full, zeros
from .segment_blocks import SegmentBlocks


@struct
class Gradients:
    """State of a solve, reused between solves. `slopes`: (search . image, residual . forces); `remains`: (residual .
    forces, 0); `limit` of residual . forces in units of `unit`; at most `max_iterations`.
    """

    solution: array(dtype=vec3d)
    residual: array(dtype=vec3d)
    search: array(dtype=vec3d)
    image: array(dtype=vec3d)
    forces: array(dtype=vec3d)
    slopes: array(dtype=vec2d)
    remains: array(dtype=vec2d)
    running: array(dtype=int32)
    iterations: array(dtype=int32)
    stuck: array(dtype=int32)
    unit: array(dtype=vec2d)
    limit: float64
    max_iterations: int

    def __init__(
        self, solution: Positions, limit: float, max_iterations: int, unit: Array1[vec2d] | None = None
    ) -> None:
        count, device = solution.size, solution.device
        self.solution, self.limit, self.max_iterations = solution, float(limit), max_iterations
        self.residual, self.search = empty(count, vec3d, device), empty(count, vec3d, device)
        self.image, self.forces = empty(count, vec3d, device), empty(count, vec3d, device)
        self.slopes, self.remains = zeros(1, vec2d, device), zeros(1, vec2d, device)
        self.running, self.iterations, self.stuck = (zeros(1, int32, device) for _ in range(3))
        self.unit = full(1, vec2d(1.0, 0.0), vec2d, device) if unit is None else unit


@kernel
def begin_search_kernel(state: Gradients):
    """Search along the forces. The first thread sets `running`."""
    i = tid()
    state.search[i] = state.forces[i]
    if i == 0:
        state.iterations[0] = 0
        running = 0
        if state.remains[0][0] > state.limit * state.unit[0][0]:
            running = 1
        state.running[0] = running


@segment_reduction
def sum_slopes(state: Gradients) -> vec2d:
    i = tid()
    return vec2d(dot(state.search[i], state.image[i]), dot(state.residual[i], state.forces[i]))


@kernel
def advance_kernel(state: Gradients):
    i = tid()
    step = float64(0.0)
    if state.slopes[0][0] > 0.0:
        step = state.slopes[0][1] / state.slopes[0][0]
    state.solution[i] = state.solution[i] + step * state.search[i]
    state.residual[i] = state.residual[i] - step * state.image[i]


@segment_reduction
def sum_remains(state: Gradients) -> vec2d:
    i = tid()
    return vec2d(dot(state.residual[i], state.forces[i]), 0.0)


@kernel
def update_search_kernel(state: Gradients):
    """Next search direction. The first thread sets `running`."""
    i = tid()
    fraction = float64(0.0)
    if state.slopes[0][1] > 0.0:
        fraction = state.remains[0][0] / state.slopes[0][1]
    state.search[i] = state.forces[i] + fraction * state.search[i]
    if i == 0:
        state.iterations[0] = state.iterations[0] + 1
        running = 0
        if state.remains[0][0] > state.limit * state.unit[0][0]:
            running = 1
        if running == 1 and state.iterations[0] >= state.max_iterations:
            running = 0
            state.stuck[0] = 1
        state.running[0] = running


@kernel
def weigh_by_diagonal_kernel(diagonal: array(dtype=float64), state: Gradients):
    """Jacobi preconditioner."""
    i = tid()
    state.forces[i] = state.residual[i] / diagonal[i]


class ConjugateGradients:
    """Warm-started solver: `map_search` launches the matrix product, `weigh_residual` the preconditioner."""

    def __init__(self, state: Gradients, map_search: Callable[..., Any], weigh_residual: Callable[..., Any]) -> None:
        device = state.solution.device
        self.state, self._map, self._precondition = state, map_search, weigh_residual
        self.blocks = SegmentBlocks([0], [state.solution.size], device)
        self.partials, self.live = self.blocks.partials(vec2d), full(1, 1, int32, device)
        self._loop = DeviceLoop(state.running, self._iterate)  # recorded once for all solves

    def weigh(self) -> None:
        """Compute the forces and what remains."""
        self._precondition()
        reduce_segments(sum_remains, self.blocks, self.live, [self.state], self.partials, self.state.remains)

    def begin(self) -> None:
        """Precondition and set the first search direction. Only launches."""
        self.weigh()
        launch(begin_search_kernel, self.state.solution.size, [self.state])

    def solve(self) -> None:
        """Precondition, and iterate until `limit` times the initial value."""
        self.weigh()
        copy(self.state.unit, self.state.remains, count=1)
        launch(begin_search_kernel, self.state.solution.size, [self.state])
        self._loop.run()

    def run(self) -> None:
        """As `solve`, if `begin` came before."""
        self._loop.run()

    def _iterate(self) -> None:
        count = self.state.solution.size
        self._map()
        reduce_segments(sum_slopes, self.blocks, self.live, [self.state], self.partials, self.state.slopes)
        launch(advance_kernel, count, [self.state])
        self.weigh()
        launch(update_search_kernel, count, [self.state])
