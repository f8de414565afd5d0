"""As-rigid-as-possible deformation of a mesh with fixed vertices.

Sorkine and Alexa, "As-rigid-as-possible surface modeling", SGP 2007, equations 5 to 9. Smooth rotations by Levi and
Gotsman, IEEE TVCG 21(2), 2014. Cotangent weights as in Open3D (mean over triangles, at least 0). The global step uses
conjugate gradients with the preconditioner of graph_levels.py, for small meshes in one launch (block_solver.py). A path
of positive weights must connect each free vertex to a fixed one. Float64 in fixed orders. 250 B per vertex.
"""

from ..algebra.rotations import best_rotation
from ..algebra.transform import narrow, widen, widen_rows
from ..array_types import Array1, Doubles, Indices, Integers, Points, Positions, Triangles, Vectors
from ..arrays.conjugate_gradients import ConjugateGradients, Gradients
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..lang import (
    array,
    cross,
    dot,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    length,
    mat33d,
    outer,
    record,
    reduce,
    reduction,
    replay,
    struct,
    tid,
    transpose,
    vec2d,
    vec3,
    vec3d,
    vec3i,
)
from ..language.device_lock import Recording
from ..memory import clone, copy, download, empty, zeros
from ..meshes.mesh_edges import MeshEdges, opposite_vertex
from .block_solver import BlockSolver, max_rows
from .graph_levels import Level, Preconditioner, row_product

MAX_ITERATIONS = 5000  # of one solve: hundreds suffice if weights differ by less than 1e6


class UnsolvedError(ArithmeticError): ...


@kernel
def begin_residual_kernel(level: Level, right: array(dtype=vec3d), state: Gradients):
    i = tid()
    rest = vec3d(0.0, 0.0, 0.0)
    if level.free[i] == 1:
        rest = right[i] - row_product(level, state.solution, i)
    state.residual[i] = rest


@kernel
def map_search_kernel(level: Level, state: Gradients):
    i = tid()
    image = vec3d(0.0, 0.0, 0.0)
    if level.free[i] == 1:
        image = row_product(level, state.search, i)
    state.image[i] = image


class LaplacianSolver:
    """Laplacian solver that starts from the last solution. It has converged when the square of the preconditioned
    residual is at most `limit` (in units of `unit`, vec2d [1], or 1). `in_one_launch`: a solve is one launch
    (block_solver.py); None decides by the number of vertices."""

    def __init__(
        self,
        level: Level,
        solution: Positions,
        limit: float,
        max_iterations: int = MAX_ITERATIONS,
        unit: Array1[vec2d] | None = None,
        in_one_launch: bool | None = None,
    ) -> None:
        self.level, self.state = level, Gradients(solution, limit, max_iterations, unit)
        self.preconditioner = Preconditioner(level)
        is_small = level.count <= max_rows(solution.device) if in_one_launch is None else in_one_launch
        self._alone = BlockSolver(self.preconditioner, self.state) if is_small else None
        if self._alone is None:
            self._descent = ConjugateGradients(self.state, self._map, self._precondition)

    def solve(self, right: Positions) -> None:
        """Solve for right-hand sides vec3d [m] in `state.solution`."""
        self.begin(right)
        self.descend()

    def begin(self, right: Positions) -> None:
        """Initialize for right-hand sides vec3d [m], or solve if one launch does. Launches on existing arrays only."""
        if self._alone is not None:
            self._alone.solve(right)
            return
        launch(begin_residual_kernel, self.state.solution.size, [self.level, right, self.state])
        self._descent.begin()

    def descend(self) -> None:
        """Iterate until converged, after `begin`."""
        if self._alone is None:
            self._descent.run()

    def check(self) -> None:
        if download(self.state.stuck)[0]:  # sync
            raise UnsolvedError(
                f"positions did not settle in {self.state.max_iterations:,} turns of conjugate gradients: the mesh has "
                "triangles so thin that numbers of 64 bits do not tell their corners apart; remove them first"
            )

    def _map(self) -> None:
        launch(map_search_kernel, self.state.solution.size, [self.level, self.state])

    def _precondition(self) -> None:
        self.preconditioner.apply(self.state.residual, self.state.forces)


# of a solve: residuals relative to the stretch of the mesh at rest, in the norm of the weights
RESIDUAL_TOLERANCE = 1.0e-8


@func
def cotangent(a: vec3d, b: vec3d, tip: vec3d) -> float64:
    """Cotangent of the angle at `tip`; inf or NaN for a triangle without area."""
    u = a - tip
    v = b - tip
    return dot(u, v) / length(cross(u, v))


@kernel
def weigh_edges_kernel(
    triangles: array(dtype=vec3i), edges: MeshEdges, rest: array(dtype=vec3d), weights: array(dtype=float64)
):
    """Mean cotangent across each edge, at least 0. Degenerate triangles are ignored."""
    i = tid()
    a = edges.lows[i]
    b = edges.highs[i]
    total = float64(0.0)
    count = float64(0.0)
    last = -1
    for j in range(edges.starts[i], edges.starts[i + 1]):
        triangle = edges.half_edges[j] // 3
        if triangle != last and a != b:
            value = cotangent(rest[a], rest[b], rest[opposite_vertex(triangles[triangle], a, b)])
            if isfinite(value):
                total += value
                count += 1.0
        last = triangle
    weight = float64(0.0)
    if count > 0.0:
        weight = max(total / count, 0.0)
    weights[i] = weight


@kernel
def unite_along_edges_kernel(edges: MeshEdges, weights: array(dtype=float64), parents: array(dtype=int32)):
    i = tid()
    if weights[i] > 0.0:
        unite(parents, edges.lows[i], edges.highs[i])


@kernel
def fix_vertices_kernel(
    fixed: array(dtype=int32),
    targets: array(dtype=vec3d),
    parents: array(dtype=int32),
    positions: array(dtype=vec3d),
    reached: array(dtype=int32),
    marks: array(dtype=int32),
):
    """Place each fixed vertex and mark its set. All threads write the same mark."""
    i = tid()
    v = fixed[i]
    positions[v] = targets[i]
    marks[v] = 1
    reached[parents[v]] = 1


@kernel
def free_vertices_kernel(
    parents: array(dtype=int32), reached: array(dtype=int32), marks: array(dtype=int32), free: array(dtype=int32)
):
    i = tid()
    free[i] = reached[parents[i]] * (1 - marks[i])


@reduction
def measure_stretch(edges: MeshEdges, weights: array(dtype=float64), rest: array(dtype=vec3d)) -> vec2d:
    """(weight times squared length, 0) of an edge."""
    i = tid()
    total = float64(0.0)
    if weights[i] > 0.0:
        d = rest[edges.lows[i]] - rest[edges.highs[i]]
        total = weights[i] * dot(d, d)
    return vec2d(total, 0.0)


@struct
class Bending:
    """Iteration state: positions at rest and now, `rotations` now and `earlier` (mat33d [m]), right-hand sides."""

    rest: array(dtype=vec3d)
    positions: array(dtype=vec3d)
    rotations: array(dtype=mat33d)
    earlier: array(dtype=mat33d)
    right: array(dtype=vec3d)

    def __init__(self, rest: Positions) -> None:
        count, device = rest.size, rest.device
        self.rest, self.positions, self.right = rest, clone(rest), empty(count, vec3d, device)
        self.rotations, self.earlier = empty(count, mat33d, device), empty(count, mat33d, device)


@kernel
def rotate_vertices_kernel(level: Level, bending: Bending, likeness: float64):
    """Best rotation of each vertex; `likeness` weights the neighbors' rotations, 0 if unknown."""
    i = tid()
    zero = float64(0.0)
    S = mat33d(zero, zero, zero, zero, zero, zero, zero, zero, zero)
    others = mat33d(zero, zero, zero, zero, zero, zero, zero, zero, zero)
    count = float64(0.0)
    for j in range(level.around.starts[i], level.around.starts[i + 1]):
        neighbor = level.around.vertices[j]
        weight = level.pulls[j]
        if weight > zero:
            before = bending.rest[i] - bending.rest[neighbor]
            now = bending.positions[i] - bending.positions[neighbor]
            S = S + weight * outer(before, now)
        if likeness > zero:
            others = others + bending.earlier[neighbor]
        count += 1.0
    if likeness > zero and count > zero:
        S = 2.0 * S + (4.0 * likeness / count) * transpose(others)
    bending.rotations[i] = best_rotation(S)


@kernel
def pull_vertices_kernel(level: Level, bending: Bending):
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    if level.free[i] == 1:
        for j in range(level.around.starts[i], level.around.starts[i + 1]):
            neighbor = level.around.vertices[j]
            weight = level.pulls[j]
            if weight > 0.0:
                edge = bending.rest[i] - bending.rest[neighbor]
                rotated = (bending.rotations[i] + bending.rotations[neighbor]) @ edge
                total = total + (0.5 * weight) * rotated
    bending.right[i] = total


@kernel
def rotate_directions_kernel(
    rotations: array(dtype=mat33d), rows: array(dtype=vec3), indices: array(dtype=int32), rotated: array(dtype=vec3)
):
    i = tid()
    index = i
    if indices.shape[0] > 0:
        index = indices[i]
    rotated[i] = narrow(rotations[index] @ widen(rows[i]))


def rotate_directions(rotations: Array1[mat33d], rows: Vectors, indices: Indices | None = None) -> Vectors:
    """Rotate vec3 directions with their vertices, or with the vertices `indices` (int32)."""
    rotated = empty(rows.size, vec3, rows.device)
    of = empty(0, int32, rows.device) if indices is None else indices
    launch(rotate_directions_kernel, rows.size, [rotations, rows, of, rotated])
    return rotated


def _fix_vertices(edges: MeshEdges, weights: Doubles, bending: Bending, fixed: Indices, targets: Positions) -> Integers:
    """Place the fixed vertices. Return int32 [m], 1 for those that move."""
    device, count = bending.rest.device, bending.rest.size
    parents = positions(count, device)
    launch(unite_along_edges_kernel, edges.count, [edges, weights, parents])
    launch(flatten_sets_kernel, count, [parents])
    reached, marks, free = zeros(count, int32, device), zeros(count, int32, device), empty(count, int32, device)
    launch(fix_vertices_kernel, fixed.size, [fixed, targets, parents, bending.positions, reached, marks])
    launch(free_vertices_kernel, count, [parents, reached, marks, free])
    return free


def deform_rigidly(
    vertices: Points, triangles: Triangles, fixed: Indices, targets: Positions, iterations: int, likeness: float
) -> tuple[Positions, Array1[mat33d]]:
    """Deform a mesh so that distinct vertices `fixed` (int32 [h]) are at `targets` (vec3d [h]), in `iterations` >= 1
    iterations. `likeness` [m^2] weights similar rotations. Returns (positions vec3d [m], rotations mat33d [m]).
    Vertices not connected to a fixed one stay. Raises UnsolvedError without convergence."""
    device, count = vertices.device, vertices.size
    edges = MeshEdges(triangles, count)  # sync
    bending, weights = Bending(widen_rows(vertices)), empty(edges.count, float64, device)
    launch(weigh_edges_kernel, edges.count, [triangles, edges, bending.rest, weights])
    free = _fix_vertices(edges, weights, bending, fixed, targets)
    level = Level(edges, weights, zeros((count, 1), float64, device), free)
    stretch = reduce(measure_stretch, edges.count, [edges, weights, bending.rest])
    solver = LaplacianSolver(level, bending.positions, RESIDUAL_TOLERANCE * RESIDUAL_TOLERANCE, unit=stretch)
    launch(rest_rotations_kernel, count, [bending.rotations])
    _solve(level, bending, solver)
    iteration = _Iteration(level, bending, solver, likeness)
    for _ in range(iterations - 1):
        iteration.run()
    solver.check()  # sync
    return bending.positions, bending.rotations


def _solve(level: Level, bending: Bending, solver: LaplacianSolver) -> None:
    launch(pull_vertices_kernel, level.count, [level, bending])
    solver.solve(bending.right)


class _Iteration:
    """Local and global step. On CUDA, the part before the solver loop is recorded once."""

    def __init__(self, level: Level, bending: Bending, solver: LaplacianSolver, likeness: float) -> None:
        self.level, self.bending, self.solver, self.likeness = level, bending, solver, likeness
        self._recorded: Recording | None = None

    def run(self) -> None:
        device = self.bending.rest.device
        if not device.is_cuda:
            self._prepare()
        else:
            if self._recorded is None:
                self._recorded = record(device, self._prepare)
            replay(self._recorded)
        self.solver.descend()

    def _prepare(self) -> None:
        bending = self.bending
        if bending.rest.device.is_cuda:  # arrays of a recording keep their address
            copy(bending.earlier, bending.rotations, count=bending.rotations.size)
        else:
            bending.rotations, bending.earlier = bending.earlier, bending.rotations
        launch(rotate_vertices_kernel, self.level.count, [self.level, bending, self.likeness])
        launch(pull_vertices_kernel, self.level.count, [self.level, bending])
        self.solver.begin(bending.right)


@kernel
def rest_rotations_kernel(rotations: array(dtype=mat33d)):
    """Identity rotations: the first iteration fits the mesh at rest to itself."""
    i = tid()
    one = float64(1.0)
    zero = float64(0.0)
    rotations[i] = mat33d(one, zero, zero, zero, one, zero, zero, zero, one)
