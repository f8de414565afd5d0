"""Laplacian systems against a dense solver, moves that flip no triangle, and the masks of Loop."""

import numpy as np
import pytest

from pointloom import TriangleMesh
from pointloom.kernels.lang import float64, int32, uint8, vec3, vec3d, vec3i
from pointloom.kernels.memory import download, upload, zeros
from pointloom.kernels.meshes.mesh_edges import MeshEdges
from pointloom.kernels.remeshing.creased_mesh import CreasedMesh
from pointloom.kernels.remeshing.graph_levels import Level
from pointloom.kernels.remeshing.relaxed_vertices import move_without_flips
from pointloom.kernels.remeshing.rigid_deformation import LaplacianSolver, UnsolvedError
from pointloom.kernels.remeshing.subdivision import EdgeSplit, mask

from ...meshing.shape_scenes import icosphere


class System:
    """A sphere whose edges have weights over six decades, a fifth of them none; every ninth vertex is held."""

    def __init__(self, device, rounds=2):
        rng = np.random.default_rng(0)
        vertices, triangles = icosphere(rounds)
        self.count, mesh = len(vertices), TriangleMesh(vertices, triangles, device=device)
        self.edges, where = MeshEdges(mesh.arrays["triangles"], self.count), mesh.device
        self.weights = 10.0 ** rng.uniform(-3, 3, self.edges.count) * (rng.random(self.edges.count) > 0.2)
        self.fixed = np.arange(self.count) % 9 == 0
        self.start, self.right = rng.normal(size=(2, self.count, 3))
        self.right[self.fixed] = 0
        reached = self.connected_to_fixed()
        self.free = ~self.fixed & reached
        excess, free = zeros((self.count, 1), float64, where), upload(self.free, int32, where)
        self.level = Level(self.edges, upload(self.weights, float64, where), excess, free)
        self.solution, self.sides = upload(self.start, vec3d, where), upload(self.right, vec3d, where)

    def connected_to_fixed(self):
        lows, highs = self.edges.lows.numpy(), self.edges.highs.numpy()
        reached = self.fixed.copy()
        for _ in range(self.count):
            for a, b in ((lows, highs), (highs, lows)):
                reached[b[(self.weights > 0) & reached[a]]] = True
        return reached

    def matrix(self):
        A = np.zeros((self.count, self.count))
        A[self.edges.lows.numpy(), self.edges.highs.numpy()] = -self.weights
        A += A.T
        return A - np.diag(A.sum(axis=1))


@pytest.mark.parametrize("in_one_launch", [True, False])
def test_solutions_are_those_of_a_dense_solver(device, in_one_launch):
    system = System(device)
    solver = LaplacianSolver(system.level, system.solution, 1e-24, in_one_launch=in_one_launch)
    A, free = system.matrix(), system.free
    for scale in (1.0, 2.0):  # the second solve begins where the first one ended
        right = scale * system.right
        solver.solve(upload(right, vec3d, system.solution.device))
        expected = system.start.copy()
        expected[free] = np.linalg.solve(A[np.ix_(free, free)], (right - A[:, ~free] @ system.start[~free])[free])
        result = system.solution.numpy()
        np.testing.assert_array_equal(result[~free], system.start[~free])
        # weights over six decades, of which 1e-3 bring errors of 1e-12 in forces to some 1e-9 in positions of 1e3
        np.testing.assert_allclose(result[free], expected[free], rtol=1e-9, atol=1e-8)
    solver.check()


def test_one_launch_gives_what_many_launches_give(device):
    """Bitwise on the CPU, where both have the same order of sums."""
    results = []
    for in_one_launch in (True, False):
        system = System(device)
        solver = LaplacianSolver(system.level, system.solution, 1e-24, in_one_launch=in_one_launch)
        solver.solve(system.sides)
        results.append((system.solution.numpy(), int(solver.state.iterations.numpy()[0])))
    assert results[0][1] == results[1][1]
    if system.solution.device.is_cpu:
        np.testing.assert_array_equal(results[0][0], results[1][0])
    np.testing.assert_allclose(results[0][0], results[1][0], rtol=1e-9, atol=1e-8)


@pytest.mark.parametrize("in_one_launch", [True, False])
def test_vertices_without_springs_move_by_their_own_weights(device, rng, in_one_launch):
    """More vertices than a matrix is inverted for, and none to make a coarser level of."""
    system = System(device)
    warp_device, weights = system.solution.device, rng.uniform(1, 2, (system.count, 1))
    free = upload(np.ones(system.count, np.int32), int32, warp_device)
    springs = zeros(system.edges.count, float64, warp_device)
    level = Level(system.edges, springs, upload(weights, float64, warp_device), free)
    solver = LaplacianSolver(level, system.solution, 1e-24, in_one_launch=in_one_launch)
    assert solver.preconditioner.inverse is None
    solver.solve(system.sides)
    np.testing.assert_allclose(system.solution.numpy(), system.right / weights, rtol=0, atol=1e-12)
    solver.check()


@pytest.mark.parametrize("in_one_launch", [True, False])
def test_a_limit_that_is_never_reached_is_an_error(device, in_one_launch):
    system = System(device)
    solver = LaplacianSolver(system.level, system.solution, -1.0, max_iterations=7, in_one_launch=in_one_launch)
    solver.solve(system.sides)
    assert solver.state.iterations.numpy()[0] == 7
    with pytest.raises(UnsolvedError, match="7 turns"):
        solver.check()


SQUARE = np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 0], [5, 5, 0], [6, 5, 0], [7, 5, 0]], float)
FANS = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [5, 6, 7]])


def test_vertices_of_triangles_that_would_flip_stay(device):
    """The last triangle has no area, so nothing can turn there."""
    for step, stays in ((0.5, False), (1.5, True)):
        faces, count = upload(FANS, vec3i, device), len(SQUARE)
        creases, corners = zeros(3 * len(FANS), uint8, device), zeros(count, uint8, device)
        mesh = CreasedMesh(upload(SQUARE, vec3, device), faces, creases, corners)
        moved = SQUARE.copy()
        moved[4:6, 0] += step
        move_without_flips(mesh, upload(moved, vec3, device))
        expected = moved.copy()
        if stays:
            expected[4] = SQUARE[4]
        np.testing.assert_array_equal(download(mesh.vertices), expected.astype(np.float32))


TETRAHEDRON = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def masked(device, points, triangles) -> tuple[np.ndarray, EdgeSplit]:
    faces = upload(triangles, vec3i, device)
    split = EdgeSplit(faces, len(points))
    return download(mask(faces, split, [upload(points, vec3d, device)])[0]), split


def test_a_tetrahedron_is_masked_by_the_weights_of_three_neighbors(device, rng):
    points = rng.normal(size=(4, 3))
    result, split = masked(device, points, TETRAHEDRON)
    total = points.sum(axis=0)
    np.testing.assert_allclose(result[:4], 7 / 16 * points + 3 / 16 * (total - points), rtol=0, atol=1e-14)
    ends = points[download(split.edges.lows)] + points[download(split.edges.highs)]
    np.testing.assert_allclose(result[download(split.numbers)], 3 / 8 * ends + (total - ends) / 8, rtol=0, atol=1e-14)


def test_a_triangle_that_runs_an_edge_twice_counts_once(device, rng):
    """Edge (0, 1) has two triangles, of which the first runs it twice and has vertex 0 for its third one."""
    points = rng.normal(size=(3, 3))
    result, split = masked(device, points, np.array([[0, 1, 0], [0, 1, 2]]))
    edge = np.flatnonzero((download(split.edges.lows) == 0) & (download(split.edges.highs) == 1))[0]
    expected = 3 / 8 * (points[0] + points[1]) + (points[0] + points[2]) / 8
    np.testing.assert_allclose(result[download(split.numbers)[edge]], expected, rtol=0, atol=1e-14)
