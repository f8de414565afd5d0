"""Steps of bent fragments against a dense solver in NumPy, which writes the whole matrix down."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload, write
from pointloom.kernels.poses.control_lattice import make_lattice
from pointloom.kernels.poses.fragment_rows import Fragments, Pairs
from pointloom.kernels.poses.fragment_steps import DAMPING, FragmentStep, StepSystem

from .test_control_lattice import SIZE, bend_in_numpy, corners_of

DISTANCE = 0.1
TIE = 2.5
ENDS = [(0, 1), (1, 2), (2, 0)]


def rotation(rng, angle):
    Q = np.linalg.qr(np.eye(3) + np.cross(np.eye(3), rng.normal(size=3) * angle))[0]
    return Q * np.sign(np.linalg.det(Q))


class Scene:
    """Three views of a wavy corner, each in its own frame, about where they belong; the lattice is a little bent."""

    def __init__(self, device, bends=True, seed=0):
        rng = np.random.default_rng(seed)
        self.device, self.parts, self.normals, self.poses = resolve_device(device), [], [], []
        for _ in range(3):
            world, normals = self.surface(rng)
            T = np.eye(4)
            T[:3, :3], T[:3, 3] = rotation(rng, 0.2), rng.normal(size=3) * 0.3
            self.parts.append(((world - T[:3, 3]) @ T[:3, :3]).astype(np.float32))
            self.normals.append((normals @ T[:3, :3]).astype(np.float32))
            T[:3, 3] += rng.normal(size=3) * 0.01
            self.poses.append(T)
        self.poses = np.array(self.poses)
        points, normals = (upload(np.concatenate(a), vec3, self.device) for a in (self.parts, self.normals))
        self.lattice = make_lattice(SIZE, points if bends else points[:1])
        if not bends:
            self.lattice = make_lattice(SIZE, upload(np.empty((0, 3), np.float32), vec3, self.device))
        self.shifts = 0.01 * np.sin(corners_of(self.lattice) @ rng.normal(size=(3, 3)))
        write(self.lattice.shifts, self.shifts)
        self.fragments = Fragments(points, normals, [len(part) for part in self.parts], self.lattice)
        self.is_fixed = np.array([True, False, False])

    @staticmethod
    def surface(rng, count=120):
        u, v = rng.random((2, count)) * 0.9
        height = 0.05 * np.sin(6 * u) + 0.04 * np.cos(5 * v)
        normals = np.stack([-0.3 * np.cos(6 * u), 0.2 * np.sin(5 * v), np.ones(count)], axis=1)
        return np.stack([u, v, height], axis=1), normals / np.linalg.norm(normals, axis=1)[:, None]

    def task(self):
        pairs = Pairs(ENDS, self.fragments, DISTANCE, 0.5, sided=True)
        rows = pairs.match(self.poses)
        return FragmentStep(rows, self.lattice, StepSystem(self.lattice, self.is_fixed, ENDS, TIE))


class Oracle:
    """The same problem as one dense matrix, from the scene's own arrays."""

    def __init__(self, scene):
        bent = download(scene.fragments.bent).astype(np.float64)
        firsts = scene.fragments.firsts
        self.anchors = {tuple(c): k for k, c in enumerate(corners_of(scene.lattice).tolist())}
        self.scene, self.size = scene, 6 * len(scene.parts) + 3 * len(self.anchors)
        moved = [bend_in_numpy(part, scene.lattice, scene.shifts) for part in scene.parts]
        self.rows, self.residuals = [], []
        for s, t in ENDS:
            T, U = scene.poses[s], scene.poses[t]
            p, q = moved[s] @ T[:3, :3].T + T[:3, 3], moved[t] @ U[:3, :3].T + U[:3, 3]
            apart, nearest = cKDTree(q).query(p)
            normals = bent[firsts[s] : firsts[s + 1]] @ T[:3, :3].T
            across = bent[firsts[t] : firsts[t + 1]] @ U[:3, :3].T
            for i in np.flatnonzero(apart < DISTANCE):
                n, j = normals[i], nearest[i]
                if n @ across[j] >= 0.5:
                    self.add(s, t, i, j, n, q[j], (p[i] - q[j]) @ n)

    def add(self, s, t, i, j, n, q, residual):
        row, scene = np.zeros(self.size), self.scene
        row[6 * s : 6 * s + 6] = [*np.cross(q, n), *n]
        row[6 * t : 6 * t + 6] = -row[6 * s : 6 * s + 6]
        for sign, fragment, point in ((1, s, scene.parts[s][i]), (-1, t, scene.parts[t][j])):
            cell = np.floor(point.astype(np.float64) / SIZE).astype(int)
            share = point / np.float64(SIZE) - cell
            for step in np.ndindex(2, 2, 2) if self.anchors else ():
                at = 6 * len(scene.parts) + 3 * self.anchors[tuple(cell + step)]
                w = np.prod(np.where(step, share, 1 - share))
                row[at : at + 3] += sign * w * (scene.poses[fragment][:3, :3].T @ n)
        self.rows.append(row)
        self.residuals.append(residual)

    def ties(self):
        """(rows, residuals) of the ties, each anchor's rotation as it is."""
        rows, residuals, base = [], [], 6 * len(self.scene.parts)
        for cell, k in self.anchors.items():
            others = [self.anchors.get(tuple(np.add(cell, d))) for d in (*np.eye(3, dtype=int), *-np.eye(3, dtype=int))]
            others = [o for o in others if o is not None]
            positions = np.array(list(self.anchors)) * SIZE
            rest = positions[k] - positions[others]
            now = rest + self.scene.shifts[k] - self.scene.shifts[others]
            U, _, Vt = np.linalg.svd(now.T @ rest)
            R = U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt
            for other, d in zip(others, now - rest @ R.T, strict=True):
                for axis in range(3):
                    row = np.zeros(self.size)
                    row[base + 3 * k + axis], row[base + 3 * other + axis] = np.sqrt(TIE), -np.sqrt(TIE)
                    rows.append(row)
                    residuals.append(np.sqrt(TIE) * d[axis])
        return np.array(rows).reshape(-1, self.size), np.array(residuals)

    def step(self):
        tie_rows, tie_residuals = self.ties()
        J = np.concatenate([np.array(self.rows), tie_rows])
        r = np.concatenate([self.residuals, tie_residuals])
        H = J.T @ J
        H += DAMPING * np.diag(np.diag(H))
        free = np.repeat(~self.scene.is_fixed, 6).tolist() + [True] * (self.size - 6 * len(self.scene.parts))
        x = np.zeros(self.size)
        x[free] = np.linalg.solve(H[np.ix_(free, free)], -(J.T @ r)[free])
        return x


def solve_closely(task):
    """The solution as far as float64 goes: the rows' slopes are float32."""
    solution, iterations = task.solve(1e-10)
    return download(solution).reshape(-1), iterations


@pytest.mark.parametrize("bends", [True, False], ids=["bent", "rigid"])
def test_a_step_is_that_of_a_dense_solver(device, bends):
    scene = Scene(device, bends)
    task, oracle = scene.task(), Oracle(scene)
    assert task.rows.count == len(oracle.residuals) > 100
    squares, count, stretch = task.errors()
    assert squares == pytest.approx(np.sum(np.square(oracle.residuals)), rel=1e-5) and count == task.rows.count
    assert stretch == pytest.approx(np.sum(np.square(oracle.ties()[1])), rel=1e-9)
    solution, expected = solve_closely(task)[0], oracle.step()
    assert np.abs(solution - expected).max() < 2e-4 * np.abs(expected).max()


def test_the_step_taken_is_close_to_the_one_solved_for(device):
    scene = Scene(device)
    exact, more = solve_closely(scene.task())
    solution, iterations = scene.task().solve()
    assert iterations < more
    max_shift = np.abs(exact[6 * len(scene.parts) :]).max()
    assert np.abs(download(solution).reshape(-1) - exact)[6 * len(scene.parts) :].max() < 0.02 * max_shift


def test_fixed_and_isolated_fragments_stay(device):
    scene = Scene(device)
    scene.is_fixed = np.array([True, False, True])
    solution = solve_closely(scene.task())[0]
    assert not solution[:6].any() and solution[6:12].any() and not solution[12:18].any()


def test_a_step_lowers_the_error(device):
    scene = Scene(device)
    task = scene.task()
    squares, count, _ = task.errors()
    solution = download(task.solve()[0])
    motions = solution[:6].reshape(3, 6)
    for k, (w, v) in enumerate(zip(motions[:, :3], motions[:, 3:], strict=True)):
        K = np.cross(np.eye(3), -w)
        scene.poses[k][:3] = (np.eye(3) + K + K @ K / 2) @ scene.poses[k][:3]
        scene.poses[k][:3, 3] += v
    write(scene.lattice.shifts, scene.shifts + solution[6:])
    scene.fragments.bend()
    after, number, _ = scene.task().errors()
    assert after / number < 0.2 * squares / count


def test_no_pairs_are_no_rows(device):
    scene = Scene(device)
    scene.poses[:, :3, 3] += 10 * np.arange(3)[:, None]
    assert scene.task().rows.count == 0
