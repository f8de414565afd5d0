"""A lattice of anchors against NumPy in float64: cells, corners, bent points and normals."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.block_keys import AXIS_BITS, BIAS
from pointloom.kernels.lang import int32, launch, vec3, vec3d
from pointloom.kernels.memory import download, empty, upload, write
from pointloom.kernels.poses import control_lattice
from pointloom.kernels.poses.control_lattice import bend_normals, bend_points, make_lattice, motion_of

SIZE = 0.375


def corners_of(lattice):
    """The cells of the anchors, [anchors, 3]."""
    keys, low = download(lattice.anchor_keys), (1 << AXIS_BITS) - 1
    return np.stack([(keys >> shift) & low for shift in (2 * AXIS_BITS, AXIS_BITS, 0)], axis=1) - BIAS


def bend_in_numpy(points, lattice, shifts):
    """Each point by its own eight anchors, one after the other."""
    known = {tuple(c): s for c, s in zip(corners_of(lattice).tolist(), shifts, strict=True)}
    moved = points.astype(np.float64)
    for i, p in enumerate(points.astype(np.float64)):
        cell = np.floor(p / SIZE).astype(int)
        share, total, weights = p / SIZE - cell, np.zeros(3), 0.0
        for step in np.ndindex(2, 2, 2):
            w = np.prod(np.where(step, share, 1 - share))
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


def test_non_finite_points_stay(device, rng):
    bent = Bent(device, rng)
    points = np.array([[50, 0, 0], [np.nan, 0, 0], [0, np.inf, 0], [3e38, 0, 0]], np.float32)
    result = download(bend_points(bent.upload(points), bent.lattice))
    assert np.array_equal(result, points, equal_nan=True)


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


def test_normals_without_length_or_a_finite_point_stay(device, rng):
    bent = Bent(device, rng)
    points = np.vstack([bent.points[:1], [[np.nan, 0, 0], [0, np.inf, 0], [3e38, 0, 0]]])
    normals = np.array([[0, 0, 0], [0, 0, 1], [0, 1, 0], [1, 0, 0]], np.float32)
    assert (download(bend_normals(bent.upload(points), bent.upload(normals), bent.lattice)) == normals).all()


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


def test_an_affine_bend_is_met_exactly(device, rng, tolerances):
    bent = Bent(device, rng)
    A, t = np.eye(3) + 0.02 * rng.normal(size=(3, 3)), rng.normal(size=3) * 0.1
    positions = corners_of(bent.lattice) * SIZE
    write(bent.lattice.shifts, positions @ A.T + t - positions)
    result = download(bend_points(bent.upload(bent.points), bent.lattice))
    assert np.abs(result - (bent.points @ A.T + t)).max() <= 4 * tolerances.float32_relative


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


def test_shifts_are_stored_in_64_bits(device, rng):
    bent = Bent(device, rng)
    assert bent.lattice.shifts.dtype == vec3d and (download(bent.lattice.shifts) == bent.shifts).all()
