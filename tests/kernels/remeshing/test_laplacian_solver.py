"""Laplacian systems against a dense solver: any weights, held vertices, and an end where none is reached."""

from itertools import pairwise

import numpy as np
import pytest

from pointloom import TriangleMesh
from pointloom.kernels.lang import float64, int32, vec3d
from pointloom.kernels.memory import upload, zeros
from pointloom.kernels.meshes.mesh_edges import MeshEdges
from pointloom.kernels.remeshing.graph_levels import Level
from pointloom.kernels.remeshing.rigid_deformation import LaplacianSolver, UnsolvedError

from ...meshing.shape_scenes import icosphere


class System:
    """A sphere whose edges have weights over six decades, a fifth of them none; every ninth vertex is held."""

    def __init__(self, device, rounds=2):
        rng = np.random.default_rng(0)
        vertices, triangles = icosphere(rounds)
        self.count, mesh = len(vertices), TriangleMesh(vertices, triangles, device=device)
        self.edges, where = MeshEdges(mesh.array("triangles"), self.count), mesh.device
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


def test_solutions_are_those_of_a_dense_solver(device):
    system = System(device)
    solver = LaplacianSolver(system.level, system.solution, 1e-24)
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


def test_coarser_levels_are_smaller_and_keep_the_springs_to_fixed_vertices(device):
    solver = LaplacianSolver(System(device, rounds=3).level, System(device, rounds=3).solution, 1e-20)
    counts = [level.count for level in solver.preconditioner.levels]
    assert len(counts) >= 3 and all(b < 0.5 * a for a, b in pairwise(counts))
    fine, *coarse = solver.preconditioner.levels
    fixed = np.flatnonzero(fine.free.numpy() == 0)
    lows, highs, weights = fine.edges.lows.numpy(), fine.edges.highs.numpy(), fine.weights.numpy()
    across = weights[np.isin(lows, fixed) != np.isin(highs, fixed)].sum()
    for level in coarse:  # a vector of ones measures only the springs to fixed vertices
        starts, pulls = level.around.starts.numpy(), level.pulls.numpy()
        rows = level.diagonal.numpy() - np.add.reduceat(np.append(pulls, 0), starts[:-1]) * (np.diff(starts) > 0)
        assert rows.sum() == pytest.approx(across, rel=1e-9)


def test_vertices_without_springs_move_by_their_own_weights(device, rng):
    """More vertices than a matrix is inverted for, and none to make a coarser level of."""
    system = System(device)
    warp_device, weights = system.solution.device, rng.uniform(1, 2, (system.count, 1))
    free = upload(np.ones(system.count, np.int32), int32, warp_device)
    springs = zeros(system.edges.count, float64, warp_device)
    level = Level(system.edges, springs, upload(weights, float64, warp_device), free)
    solver = LaplacianSolver(level, system.solution, 1e-24)
    assert solver.preconditioner.inverse is None
    solver.solve(system.sides)
    np.testing.assert_allclose(system.solution.numpy(), system.right / weights, rtol=0, atol=1e-12)
    solver.check()


def test_a_limit_that_is_never_reached_is_an_error(device):
    system = System(device)
    solver = LaplacianSolver(system.level, system.solution, -1.0, max_iterations=7)
    solver.solve(system.sides)
    assert solver.state.iterations.numpy()[0] == 7
    with pytest.raises(UnsolvedError, match="7 turns"):
        solver.check()
