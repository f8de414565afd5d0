"""Linear systems of a weighted graph Laplacian over a mesh, some of whose vertices are held: conjugate gradients.

Row i says: sum over neighbours j of w_ij (x_i - x_j) = b_i. Weights are not negative, and whoever sets up a system sees
to it that a path of positive weights leads from each free vertex to a held one; so it has one solution. The three
coordinates are solved at once, as one system. A turn costs one product (40 B a neighbour), two reductions and one cycle
of the preconditioner (graph_levels.py). All is float64, sums run in fixed orders, and the device sees the loop's end.
"""

from ..array_types import Array1, Positions
from ..arrays.conjugate_gradients import ConjugateGradients, Gradients
from ..lang import array, kernel, launch, tid, vec2d, vec3d
from ..memory import download
from .graph_levels import Level, Preconditioner, row_product

MOST_TURNS = 5000  # of one solve: hundreds suffice where weights differ by less than 1e6


class UnsolvedError(ArithmeticError):
    """A linear system whose solution was not reached."""


@kernel
def begin_residual_kernel(level: Level, right: array(dtype=vec3d), state: Gradients):
    """The residual of what the solution is so far."""
    i = tid()
    rest = vec3d(0.0, 0.0, 0.0)
    if level.free[i] == 1:
        rest = right[i] - row_product(level, state.solution, i)
    state.residual[i] = rest


@kernel
def map_search_kernel(level: Level, state: Gradients):
    """The product of the matrix and the search direction."""
    i = tid()
    image = vec3d(0.0, 0.0, 0.0)
    if level.free[i] == 1:
        image = row_product(level, state.search, i)
    state.image[i] = image


class LaplacianSolver:
    """Solves systems over one mesh, each from where the last one ended.

    Args:
        level: The finest Level.
        solution: vec3d [m], what it begins with; held vertices keep theirs.
        limit: Solved where the residual, weighted by the preconditioner, has at most this square.
        most: Turns of one solve.
        unit: What the limit is measured in, the first number of vec2d [1]; 1 if None.
    """

    def __init__(
        self, level: Level, solution: Positions, limit: float, most: int = MOST_TURNS, unit: Array1[vec2d] | None = None
    ) -> None:
        self.level, self.state = level, Gradients(solution, limit, most, unit)
        self.preconditioner = Preconditioner(level)
        self._descent = ConjugateGradients(self.state, self._map, self._precondition)

    def solve(self, right: Positions) -> None:
        """Make `state.solution` the solution of vec3d [m] right sides."""
        self.begin(right)
        self.descend()

    def begin(self, right: Positions) -> None:
        """Set out for the solution of vec3d [m] right sides; launches over arrays that exist already."""
        launch(begin_residual_kernel, self.state.solution.size, [self.level, right, self.state])
        self._descent.begin()

    def descend(self) -> None:
        """Go there; `begin` comes before."""
        self._descent.run()

    def check(self) -> None:
        """Refuse solutions that are none.

        Raises:
            UnsolvedError: A solve ended before its limit.
        """
        if download(self.state.stuck)[0]:  # sync
            raise UnsolvedError(
                f"positions did not settle in {self.state.most:,} turns of conjugate gradients: the mesh has triangles "
                "so thin that numbers of 64 bits do not tell their corners apart; remove them first"
            )

    def _map(self) -> None:
        launch(map_search_kernel, self.state.solution.size, [self.level, self.state])

    def _precondition(self) -> None:
        self.preconditioner.apply(self.state.residual, self.state.forces)
