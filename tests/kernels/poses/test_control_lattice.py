"""A lattice of anchors, and steps of bent fragments, against NumPy in float64 and a dense solver."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.block_keys import AXIS_BITS, CELL_BIAS
from pointloom.kernels.lang import int32, launch, vec3
from pointloom.kernels.memory import download, empty, upload, write
from pointloom.kernels.poses import control_lattice
from pointloom.kernels.poses.control_lattice import bend_normals, bend_points, make_lattice, motion_of
from pointloom.kernels.poses.fragment_rows import Fragments, Pairs
from pointloom.kernels.poses.fragment_steps import DIAGONAL_DAMPING, FragmentStep, StepSystem

SIZE = 0.375


def corners_of(lattice):
    """The cells of the anchors, [anchors, 3]."""
    keys, low = download(lattice.anchor_keys), (1 << AXIS_BITS) - 1
    return np.stack([(keys >> shift) & low for shift in (2 * AXIS_BITS, AXIS_BITS, 0)], axis=1) - CELL_BIAS


def bend_in_numpy(points, lattice, shifts):
    """Each point by its own eight anchors, one after the other."""
    known = {tuple(c): s for c, s in zip(corners_of(lattice).tolist(), shifts, strict=True)}
    moved = points.astype(np.float64)
    for i, p in enumerate(points.astype(np.float64)):
        cell = np.floor(p / SIZE).astype(int)
        fraction, total, weights = p / SIZE - cell, np.zeros(3), 0.0
        for step in np.ndindex(2, 2, 2):
            w = np.prod(np.where(step, fraction, 1 - fraction))
            if tuple(cell + step) in known:
                total, weights = total + w * known[tuple(cell + step)], weights + w
        moved[i] += total / weights if weights else 0
    return moved


class Bent:
    def __init__(self, device, rng, count=300):
        self.device = resolve_device(device)
        self.points = (rng.random((count, 3)) * 2 - 1).astype(np.float32)
        self.lattice = make_lattice(SIZE, self.upload(self.points))
        positions = corners_of(self.lattice) * SIZE
        self.shifts = 0.02 * np.sin(2 * positions @ rng.normal(size=(3, 3)))
        write(self.lattice.shifts, self.shifts)

    def upload(self, rows, kind=vec3):
        return upload(np.asarray(rows), kind, self.device)


def test_anchors_are_the_corners_of_occupied_cells(device, rng):
    bent = Bent(device, rng, count=20)
    cells = np.floor(bent.points.astype(np.float64) / SIZE).astype(int)
    expected = np.unique((cells[:, None] + np.array(list(np.ndindex(2, 2, 2)))).reshape(-1, 3), axis=0)
    assert (corners_of(bent.lattice) == expected).all()


def test_a_lattice_does_not_depend_on_the_order_of_the_points(device, rng):
    bent = Bent(device, rng)
    other = make_lattice(SIZE, bent.upload(rng.permutation(bent.points)))
    for name in ("anchor_keys", "cell_keys", "corners", "sharers", "around"):
        assert (download(getattr(other, name)) == download(getattr(bent.lattice, name))).all(), name


def test_a_lattice_that_is_not_shifted_leaves_every_bit(device, rng):
    points = (rng.random((1000, 3)) * 7 - 3).astype(np.float32)
    given = upload(points, vec3, device)
    assert (download(bend_points(given, make_lattice(SIZE, given))) == points).all()


def test_points_move_by_the_anchors_about_them(device, rng, tolerances):
    bent = Bent(device, rng)
    around = (rng.random((300, 3)) * 4 - 2).astype(np.float32)  # in cells without all of their anchors, too
    for points in (bent.points, around):
        result = download(bend_points(bent.upload(points), bent.lattice))
        expected = bend_in_numpy(points, bent.lattice, bent.shifts)
        assert np.abs(result - expected).max() <= tolerances.float32_relative * 2


def test_non_finite_points_and_their_normals_and_normals_without_length_stay(device, rng):
    bent = Bent(device, rng)
    points = np.array([[50, 0, 0], [np.nan, 0, 0], [0, np.inf, 0], [3e38, 0, 0]], np.float32)
    result = download(bend_points(bent.upload(points), bent.lattice))
    assert np.array_equal(result, points, equal_nan=True)
    points[0], normals = bent.points[0], np.array([[0, 0, 0], [0, 0, 1], [0, 1, 0], [1, 0, 0]], np.float32)
    assert (download(bend_normals(bent.upload(points), bent.upload(normals), bent.lattice)) == normals).all()


def test_non_finite_points_add_no_cells_and_do_not_affect_the_motion(device, rng):
    bent, nowhere = Bent(device, rng), np.array([[np.nan, 0, 0], [0, np.inf, 0], [3e38, 0, 0]], np.float32)
    lattice = make_lattice(SIZE, bent.upload(np.vstack([nowhere, bent.points])))
    assert (download(lattice.anchor_keys) == download(bent.lattice.anchor_keys)).all()
    moved, lost = np.float32(bent.points + np.array([0.1, -0.2, 0.3])), nowhere[:2]
    motion = motion_of(bent.upload(np.vstack([lost, bent.points])), bent.upload(np.vstack([lost, moved])))
    np.testing.assert_allclose(motion, motion_of(bent.upload(bent.points), bent.upload(moved)), rtol=0, atol=1e-12)


def test_points_are_located_in_the_cells_of_the_lattice_or_in_none(device, rng):
    bent = Bent(device, rng, count=40)
    points = np.vstack([bent.points, [[50, 0, 0], [np.nan, 0, 0], [0, np.inf, 0], [3e38, 0, 0]]])
    cells = empty(len(points), int32, bent.device)
    launch(control_lattice.locate_points_kernel, len(points), [bent.upload(points), bent.lattice, cells])
    result, grid_cells = download(cells), np.floor(bent.points.astype(float) / SIZE).astype(int)
    known = np.unique(grid_cells, axis=0)
    assert (known[result[:40]] == grid_cells).all() and (result[40:] == -1).all()


def test_normals_stay_perpendicular_to_the_bent_surface(device, rng):
    bent = Bent(device, rng)
    normals = rng.normal(size=bent.points.shape)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    first = np.cross(normals, rng.normal(size=normals.shape))
    second, step = np.cross(normals, first), 1e-5
    result = download(bend_normals(bent.upload(bent.points), bent.upload(normals), bent.lattice)).astype(np.float64)
    assert np.abs(np.linalg.norm(result, axis=1) - 1).max() < 1e-6
    points = bent.points.astype(np.float64)
    inside = (np.abs(points / SIZE - np.round(points / SIZE)) > 1e-3).all(axis=1)  # slopes differ from cell to cell
    for tangent in (first, second):
        a, b = (bend_in_numpy(points + s * step * tangent, bent.lattice, bent.shifts) for s in (-1, 1))
        along = (b - a) / np.linalg.norm(b - a, axis=1)[:, None]
        assert np.abs((result * along).sum(axis=1))[inside].max() < 1e-6


def test_added_cells_keep_the_existing_shifts(device, rng):
    bent = Bent(device, rng, count=50)
    more = make_lattice(SIZE, bent.upload(rng.random((50, 3)) * 3), bent.lattice)
    known = {tuple(c): s for c, s in zip(corners_of(bent.lattice).tolist(), bent.shifts, strict=True)}
    expected = [known.get(tuple(c), np.zeros(3)) for c in corners_of(more).tolist()]
    assert more.anchor_count > len(known) and (download(more.shifts) == expected).all()


@pytest.mark.parametrize("count", [0, 1, 2])
def test_few_points_make_a_lattice_too(device, count):
    points = upload(np.full((count, 3), 0.1, np.float32), vec3, device)
    lattice = make_lattice(SIZE, points)
    assert (lattice.cell_count, lattice.anchor_count) == ((1, 8) if count else (0, 0))
    assert download(bend_points(points, lattice)).shape == (count, 3)


def test_the_motion_of_a_bend_is_the_rigid_one_nearest_to_it(device, rng, tolerances):
    bent = Bent(device, rng)
    axis, angle = np.array([0.6, 0.0, 0.8]), 0.1
    K = np.cross(np.eye(3), axis)
    R = np.eye(3) - np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
    moved = bend_in_numpy(bent.points, bent.lattice, 0 * bent.shifts) @ R.T + [0.1, -0.2, 0.3]
    motion = motion_of(bent.upload(bent.points), bent.upload(moved))
    assert np.abs(motion[:3, :3] - R).max() < 1e-7 and np.abs(motion[:3, 3] - [0.1, -0.2, 0.3]).max() < 1e-7


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
        self.lattice = make_lattice(SIZE, points if bends else upload(np.empty((0, 3)), vec3, self.device))
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
            fraction = point / np.float64(SIZE) - cell
            for step in np.ndindex(2, 2, 2) if self.anchors else ():
                at = 6 * len(scene.parts) + 3 * self.anchors[tuple(cell + step)]
                w = np.prod(np.where(step, fraction, 1 - fraction))
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
        H += DIAGONAL_DAMPING * np.diag(np.diag(H))
        free = np.repeat(~self.scene.is_fixed, 6).tolist() + [True] * (self.size - 6 * len(self.scene.parts))
        x = np.zeros(self.size)
        x[free] = np.linalg.solve(H[np.ix_(free, free)], -(J.T @ r)[free])
        return x


def solve_closely(task):
    """The solution as far as float64 goes: the rows' slopes are float32."""
    return download(task.solve(1e-10)[0]).reshape(-1)


@pytest.mark.parametrize("bends", [True, False], ids=["bent", "rigid"])
def test_a_step_is_that_of_a_dense_solver(device, bends):
    scene = Scene(device, bends)
    task, oracle = scene.task(), Oracle(scene)
    assert task.rows.count == len(oracle.residuals) > 100
    squares, count, stretch = task.errors()
    assert squares == pytest.approx(np.sum(np.square(oracle.residuals)), rel=1e-5) and count == task.rows.count
    assert stretch == pytest.approx(np.sum(np.square(oracle.ties()[1])), rel=1e-9)
    solution, expected = solve_closely(task), oracle.step()
    assert np.abs(solution - expected).max() < 2e-4 * np.abs(expected).max()


def test_fixed_and_isolated_fragments_stay(device):
    scene = Scene(device)
    scene.is_fixed = np.array([True, False, True])
    solution = solve_closely(scene.task())
    assert not solution[:6].any() and solution[6:12].any() and not solution[12:18].any()


def test_no_pairs_are_no_rows(device):
    scene = Scene(device)
    scene.poses[:, :3, 3] += 10 * np.arange(3)[:, None]
    assert scene.task().rows.count == 0
