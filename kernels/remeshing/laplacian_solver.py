"""Linear systems of a weighted graph Laplacian over a mesh, some of whose vertices are held: conjugate gradients.

Row i says: sum over neighbours j of w_ij (x_i - x_j) = b_i. Weights are not negative, and whoever sets up a system sees
to it that a path of positive weights leads from each free vertex to a held one; so it has one solution. The three
coordinates are solved at once, as one system. A turn costs one product (40 B a neighbour), two reductions and one cycle
of the preconditioner (graph_levels.py). All is float64, sums run in fixed orders, and the device sees the loop's end.
"""

from ..arrays.segment_blocks import SegmentBlocks
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
from ..memory import download, empty, full, zeros
from .graph_levels import Level, Preconditioner, row_product

MOST_TURNS = 5000  # of one solve: hundreds suffice where weights differ by less than 1e6


class UnsolvedError(ArithmeticError):
    """A linear system whose solution was not reached."""


@struct
class Gradients:
    """What a solve works on; the arrays stay from solve to solve.

    Attributes:
        solution, residual, search, image: vec3d [m]; image is the product with the search direction.
        forces: The preconditioned residual, vec3d [m].
        slopes: (search . image, residual . forces) of this turn, vec2d [1].
        remains: (residual . forces, 0) after it.
        running, turns: int32 [1].
        stuck: Whether a solve ended before its limit, int32 [1].
        limit: Of residual . forces.
        most: Turns of a solve.
    """

    solution: array(dtype=vec3d)
    residual: array(dtype=vec3d)
    search: array(dtype=vec3d)
    image: array(dtype=vec3d)
    forces: array(dtype=vec3d)
    slopes: array(dtype=vec2d)
    remains: array(dtype=vec2d)
    running: array(dtype=int32)
    turns: array(dtype=int32)
    stuck: array(dtype=int32)
    limit: float64
    most: int

    def __init__(self, solution, limit, most):
        count, device = solution.size, solution.device
        self.solution, self.limit, self.most = solution, float(limit), most
        self.residual, self.search = empty(count, vec3d, device), empty(count, vec3d, device)
        self.image, self.forces = empty(count, vec3d, device), empty(count, vec3d, device)
        self.slopes, self.remains = zeros(1, vec2d, device), zeros(1, vec2d, device)
        self.running, self.turns, self.stuck = (zeros(1, int32, device) for _ in range(3))


@kernel
def begin_residual_kernel(level: Level, right: array(dtype=vec3d), state: Gradients):
    """The residual of what the solution is so far."""
    i = tid()
    rest = vec3d(float64(0.0), float64(0.0), float64(0.0))
    if level.free[i] == 1:
        rest = right[i] - row_product(level, state.solution, i)
    state.residual[i] = rest


@kernel
def begin_search_kernel(state: Gradients):
    """Search along the forces; the first thread says whether there is anything to do."""
    i = tid()
    state.search[i] = state.forces[i]
    if i == 0:
        state.turns[0] = 0
        running = int(0)
        if state.remains[0][0] > state.limit:
            running = 1
        state.running[0] = running


@kernel
def map_search_kernel(level: Level, state: Gradients):
    """The product of the matrix and the search direction."""
    i = tid()
    image = vec3d(float64(0.0), float64(0.0), float64(0.0))
    if level.free[i] == 1:
        image = row_product(level, state.search, i)
    state.image[i] = image


@segment_reduction
def sum_slopes(state: Gradients) -> vec2d:
    """(search . image, residual . forces)."""
    i = tid()
    return vec2d(dot(state.search[i], state.image[i]), dot(state.residual[i], state.forces[i]))


@kernel
def advance_kernel(state: Gradients):
    """To the lowest place along the search direction."""
    i = tid()
    step = float64(0.0)
    if state.slopes[0][0] > float64(0.0):
        step = state.slopes[0][1] / state.slopes[0][0]
    state.solution[i] = state.solution[i] + step * state.search[i]
    state.residual[i] = state.residual[i] - step * state.image[i]


@segment_reduction
def sum_remains(state: Gradients) -> vec2d:
    """(residual . forces, 0)."""
    i = tid()
    return vec2d(dot(state.residual[i], state.forces[i]), float64(0.0))


@kernel
def turn_search_kernel(state: Gradients):
    """The next search direction; the first thread says whether there is a next turn."""
    i = tid()
    share = float64(0.0)
    if state.slopes[0][1] > float64(0.0):
        share = state.remains[0][0] / state.slopes[0][1]
    state.search[i] = state.forces[i] + share * state.search[i]
    if i == 0:
        state.turns[0] = state.turns[0] + 1
        running = int(0)
        if state.remains[0][0] > state.limit:
            running = 1
        if running == 1 and state.turns[0] >= state.most:
            running = 0
            state.stuck[0] = 1
        state.running[0] = running


class LaplacianSolver:
    """Solves systems over one mesh, each from where the last one ended.

    Args:
        level: The finest Level.
        solution: vec3d [m], what it begins with; held vertices keep theirs.
        limit: Solved where the residual, weighted by the preconditioner, has at most this square.
        most: Turns of one solve.
    """

    def __init__(self, level, solution, limit, most=MOST_TURNS):
        device = solution.device
        self.level, self.state = level, Gradients(solution, limit, most)
        self.preconditioner = Preconditioner(level)
        self.blocks = SegmentBlocks([0], [solution.size], device)
        self.partials, self.live = empty(self.blocks.count, vec2d, device), full(1, 1, int32, device)
        self._loop = DeviceLoop(self.state.running, self._turn)  # recorded once for all solves

    def solve(self, right):
        """Make `state.solution` the solution of vec3d [m] right sides."""
        count = self.state.solution.size
        launch(begin_residual_kernel, count, [self.level, right, self.state])
        self._weigh()
        launch(begin_search_kernel, count, [self.state])
        self._loop.run()

    def check(self):
        """Refuse solutions that are none.

        Raises:
            UnsolvedError: A solve ended before its limit.
        """
        if download(self.state.stuck)[0]:  # sync
            raise UnsolvedError(
                f"positions did not settle in {self.state.most:,} turns of conjugate gradients: the mesh has triangles "
                "so thin that numbers of 64 bits do not tell their corners apart; remove them first"
            )

    def _turn(self):
        count = self.state.solution.size
        launch(map_search_kernel, count, [self.level, self.state])
        reduce_segments(sum_slopes, self.blocks, self.live, [self.state], self.partials, self.state.slopes)
        launch(advance_kernel, count, [self.state])
        self._weigh()
        launch(turn_search_kernel, count, [self.state])

    def _weigh(self):
        self.preconditioner.apply(self.state.residual, self.state.forces)
        reduce_segments(sum_remains, self.blocks, self.live, [self.state], self.partials, self.state.remains)
