"""Fits of several shapes at once against least squares of SciPy, and parts of shapes."""

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.sparse.csgraph import connected_components

from pointloom.kernels.lang import int32, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.segmentation.shape_fit import EXACT_GAIN, Selection, ShapeFitter
from pointloom.kernels.segmentation.shape_models import CONE, CYLINDER, PLANE, SPHERE, TORUS
from pointloom.kernels.segmentation.shape_parts import heights_across, largest_part, rows_labeled
from pointloom.kernels.segmentation.shape_search import ShapeLimits, ShapeSearch

NAMES = {PLANE: "plane", SPHERE: "sphere", CYLINDER: "cylinder", CONE: "cone", TORUS: "torus"}
AXIS = np.array([0.36, 0.48, 0.8])
TRUE = {
    PLANE: [0.1, 0.0, 0.05, *AXIS, 1.0, 1.0],
    SPHERE: [0.1, 0.0, 0.05, *AXIS, 0.7, 1.0],
    CYLINDER: [0.1, 0.0, 0.05, *AXIS, 0.4, 1.0],
    CONE: [0.1, 0.0, 0.05, *AXIS, np.cos(0.5), np.sin(0.5)],
    TORUS: [0.1, 0.0, 0.05, *AXIS, 0.6, 0.2],
}


def made(kind, rng, count=700, noise=0.004):
    """Points of a shape with noise, float32, and their true normals."""
    p, r, s = np.array(TRUE[kind][:3]), *TRUE[kind][6:]
    u = np.cross(AXIS, [1.0, 0, 0]) / np.linalg.norm(np.cross(AXIS, [1.0, 0, 0]))
    angle, fraction = rng.random((2, count)) * [[2 * np.pi], [1]]
    e = np.cos(angle)[:, None] * u + np.sin(angle)[:, None] * np.cross(AXIS, u)
    h = fraction[:, None]
    normals, points = e, r * e + (h - 0.3) * AXIS
    if kind == PLANE:
        normals, points = np.tile(AXIS, (count, 1)), np.sqrt(h) * e
    elif kind == SPHERE:
        normals = np.sqrt(1 - (2 * h - 1) ** 2) * e + (2 * h - 1) * AXIS
        points = r * normals
    elif kind == CONE:
        normals, points = r * e - s * AXIS, (0.2 + h) * (s * e + r * AXIS)
    elif kind == TORUS:
        normals = np.cos(2 * np.pi * h) * e + np.sin(2 * np.pi * h) * AXIS
        points = r * e + s * normals
    points = points + p + noise * rng.normal(size=(count, 1)) * normals
    return points.astype(np.float32), normals.astype(np.float32)


@pytest.mark.parametrize("kind", NAMES, ids=NAMES.get)
def test_points_count_for_a_shape_if_they_and_their_normals_are_near(device, rng, kind):
    points, normals = made(kind, rng, noise=0.0)
    normals[:200] = np.cross(normals[:200], rng.normal(size=(200, 3)))  # tangents
    points[200:300] += 0.03 * normals[200:300]
    of_device = [upload(values, vec3, device) for values in (points, normals)]
    search = ShapeSearch(*of_device, upload(np.arange(700), int32, device))
    shape = np.array(TRUE[kind])
    shape[:3] -= search.center
    limits = ShapeLimits(distance=0.02, cosine=0.9, smallest=0.0, largest=10.0)
    assert search.score(shape[None], np.array([kind]), limits).tolist() == [400]


def distances(kind, shape, x):
    y, a = x - shape[:3], shape[3:6] / np.linalg.norm(shape[3:6])
    h = y @ a
    q = np.linalg.norm(y - h[:, None] * a, axis=1)
    r, s = shape[6:]
    found = {PLANE: h, SPHERE: np.linalg.norm(y, axis=1) - r, CYLINDER: q - r, TORUS: np.hypot(q - r, h) - s}
    return found[kind] if kind in found else (q * r - h * s) / np.hypot(r, s)


def begun(kind, rng):
    start = np.array(TRUE[kind])
    start[:3] += 0.03 * rng.normal(size=3)
    start[3:6] += 0.05 * rng.normal(size=3)
    start[3:6] /= np.linalg.norm(start[3:6])
    if kind == CONE:
        start[6:] = np.cos(0.45), np.sin(0.45)
    elif kind != PLANE:
        start[6:] *= 1.05
    return start


@pytest.mark.parametrize("kind", NAMES, ids=NAMES.get)
def test_fits_from_several_starts_match_scipy_least_squares(device, rng, kind):
    points = made(kind, rng)[0]
    starts = [begun(kind, rng) for _ in range(3)]
    fitter = ShapeFitter(upload(points, vec3, device), np.zeros(3), 1.0)
    rows = upload(np.arange(700), int32, device)
    fits = fitter.fit_all([kind] * 3, starts, rows, EXACT_GAIN)
    best = least_squares(lambda x: distances(kind, x, points.astype(float)), starts[0], xtol=1e-14, ftol=1e-14).fun
    for fit in fits:
        assert not fit.reason and fit.rms == pytest.approx(np.sqrt((best**2).mean()), rel=1e-7)
        assert fit.rms == pytest.approx(np.sqrt((distances(kind, fit.shape, points) ** 2).mean()), rel=1e-6)


def test_fits_of_several_kinds_are_each_that_of_its_own(device, rng):
    """Together and alone, to the bit: no fit sees another's rows or ends with it."""
    points = np.vstack([made(kind, rng, 300)[0] for kind in NAMES])
    fitter = ShapeFitter(upload(points, vec3, device), np.zeros(3), 1.0)
    rows = upload(np.arange(0, 1500, 2), int32, device)
    starts = [begun(kind, rng) for kind in NAMES]
    together = fitter.fit_all(list(NAMES), starts, rows, EXACT_GAIN)
    alone = [fitter.fit(kind, start, rows) for kind, start in zip(NAMES, starts, strict=True)]
    for one, other in zip(together, alone, strict=True):
        np.testing.assert_array_equal(one.shape, other.shape)
        assert one.rms == other.rms


def test_a_cylinder_and_a_plane_are_at_the_mean_of_their_rows(device, rng):
    for kind in (PLANE, CYLINDER):
        points = made(kind, rng)[0]
        start = np.array(TRUE[kind])
        start[:3] += 3 * (AXIS if kind == CYLINDER else np.cross(AXIS, [0, 0, 1.0]))
        fitter = ShapeFitter(upload(points, vec3, device), np.zeros(3), 1.0)
        fit = fitter.fit(kind, start, upload(np.arange(700), int32, device))
        y = points.mean(axis=0) - fit.shape[:3]
        along = fit.frame[2] @ y if kind == CYLINDER else fit.frame[:2] @ y
        assert np.abs(along).max() < 0.02


def test_rows_on_a_shape_are_chosen_again_while_they_grow(device, rng):
    """From a radius that is too small by the threshold; then the rows on the shape found are those that are counted."""
    points, normals = made(SPHERE, rng)
    wild = rng.uniform(-1, 1, (300, 3)).astype(np.float32)
    points, normals = np.vstack([points, wild]), np.vstack([normals, wild])
    fitter = ShapeFitter(upload(points, vec3, device), np.zeros(3), 1.0)
    rows = upload(np.arange(1000), int32, device)
    start = np.add(TRUE[SPHERE], [0.01, 0, 0, 0, 0, 0, -0.012, 0])
    near = Selection(upload(normals, vec3, device), 0.012, 0.9, 0.0, 10.0, 6)
    starts = [start, [9.0, 0, 0, *AXIS, 0.1, 1.0], start]
    (fit, count), none, large = fitter.refine_all([SPHERE] * 3, starts, rows, near, EXACT_GAIN)
    inside = np.abs(distances(SPHERE, fit.shape, points)) < 0.012
    unit = normals / np.linalg.norm(normals, axis=1)[:, None]
    outwards = points - fit.shape[:3]
    facing = np.abs((outwards / np.linalg.norm(outwards, axis=1)[:, None] * unit).sum(axis=1)) >= 0.9
    assert count == (inside & facing).sum() > 680
    assert none is None and large[1] == count
    small = Selection(near.normals, 0.012, 0.9, 0.0, 0.5, 6)
    assert fitter.refine_all([SPHERE], [start], rows, small, EXACT_GAIN) == [None]  # beyond the largest radius
    once = Selection(near.normals, 0.012, 0.9, 0.0, 10.0, 1)
    assert fitter.refine_all([SPHERE], [start], rows, once, EXACT_GAIN)[0][1] <= count


def test_only_a_fit_far_from_its_points_is_stopped_early(device, rng):
    points = made(TORUS, rng)[0]
    fitter = ShapeFitter(upload(points, vec3, device), np.zeros(3), 1.0)
    rows = upload(np.arange(700), int32, device)
    slow = np.array([*TRUE[TORUS][:3], *AXIS, 5.0, 4.0])
    complete, given_up = (fitter.fit_all([TORUS], [slow], rows, EXACT_GAIN, hopeless)[0] for hopeless in (0.0, 1e-6))
    assert given_up.rms > 1.01 * complete.rms
    near, same = (fitter.fit_all([TORUS], [slow], rows, EXACT_GAIN, hopeless)[0] for hopeless in (0.0, 10.0))
    np.testing.assert_array_equal(near.shape, same.shape)


@pytest.mark.parametrize("kind", [CONE, TORUS], ids=NAMES.get)
def test_a_fit_ends_no_farther_from_its_points_than_it_began(device, rng, kind):
    """From anywhere: a step that makes it worse is not taken, and one that leaves what is a shape neither."""
    points = made(kind, rng)[0]
    fitter = ShapeFitter(upload(points, vec3, device), np.zeros(3), 1.0)
    starts = []
    for _ in range(20):
        axis = rng.normal(size=3)
        sizes = (0.8, 0.6) if kind == CONE else (1.0, 0.05)
        starts.append([*rng.uniform(-1, 1, 3), *axis / np.linalg.norm(axis), *sizes])
    fits = fitter.fit_all([kind] * 20, starts, upload(np.arange(700), int32, device), EXACT_GAIN)
    for fit, start in zip(fits, np.array(starts), strict=True):
        assert fit.rms <= 1.000001 * np.sqrt((distances(kind, start, points) ** 2).mean())
        assert (fit.shape[6:] > 0).all()
    assert sum(fit.rms < 0.006 for fit in fits) >= 3  # some find it from there


def test_the_heights_of_planes_points_above_each_plane_are_bounds_to_a_step(device, rng):
    points, labels = rng.normal(size=(200, 3)).astype(np.float32), rng.integers(-1, 3, 200).astype(np.int32)
    positions, normals = rng.normal(size=(3, 3)), rng.normal(size=(3, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    low, high = heights_across(upload(points, vec3, device), labels, positions, normals, 1e-4)
    heights = np.einsum("njk,jk->nj", points[:, None] - positions, normals)
    for k in range(3):
        np.testing.assert_allclose(low[k], heights[labels == k].min(axis=0), rtol=0, atol=1.01e-4)
        np.testing.assert_allclose(high[k], heights[labels == k].max(axis=0), rtol=0, atol=1.01e-4)


def test_the_largest_part_is_that_of_scipy_and_rows_are_chosen_by_their_labels(device, rng):
    radius = 0.13
    points, rows = rng.random((300, 3)).astype(np.float32), np.flatnonzero(rng.random(300) < 0.7).astype(np.int32)
    chosen = points[rows].astype(float)
    near = np.linalg.norm(chosen[:, None] - chosen[None], axis=2) < radius
    numbers = connected_components(near)[1]
    sizes = np.bincount(numbers)
    assert (sizes == sizes.max()).sum() == 1 and len(sizes) > 1
    result = largest_part(upload(points, vec3, device), upload(rows, int32, device), radius)
    np.testing.assert_array_equal(download(result), rows[numbers == sizes.argmax()])
    labels = rng.integers(-1, 3, 300).astype(np.int32)
    result = rows_labeled(upload(labels, int32, device), upload(rows, int32, device), 1)
    np.testing.assert_array_equal(download(result), rows[labels[rows] == 1])
