"""Nonrigid registration and coherent point drift of a body to a deformed scan; different objects are reported."""

from functools import cache

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.kernels.search import nearest_point
from pointloom.registration.deformable import coherent_drift as module

from .bent_bodies import armed, lumpy, swayed, torus, tube, twisted

bend = loom.registration.register_nonrigid
COUNT = 1500
LONG = pytest.mark.slow_on_emulated_cuda("hundreds of turns of conjugate gradients; a few steps stand for them")
SHIFT = np.array([0.01, 0.02, 0.0])
ALONG = np.array([1.0, 0.0, 0.0])
ABOVE = np.array([0.0, 0.0, 40.0])


def errors_of(result, truth):
    return np.linalg.norm(result.warped.points - truth, axis=1)


@pytest.fixture(scope="module")
def swaying():
    """The body, a deformed scan of it, and the true deformed positions."""
    body = lumpy(COUNT, 0)
    return body, swayed(lumpy(2 * COUNT, 1)), swayed(body)


@cache
def swaying_cloud(device):
    """The body with normals and labels, and its registration to the scan."""
    cloud = loom.PointCloud(lumpy(COUNT, 0), device=device, label=np.arange(COUNT)).estimate_normals(max_nn=20)
    return cloud, bend(cloud, loom.PointCloud(swayed(lumpy(2 * COUNT, 1)), device=device))


@pytest.mark.slow
@LONG
def test_the_surface_of_a_body_is_deformed_onto_the_scan(device):
    _, result = swaying_cloud(device)
    away = cKDTree(swayed(lumpy(40_000, 2))).query(result.warped.points)[0]
    assert np.median(away) < 0.02 and result.rmse < 0.2 * result.rigid_rmse
    assert result.reliable and not result.is_rigid and result.covered > 0.95


@LONG
def test_landmarks_prevent_sliding_along_the_surface(device, swaying):
    body, scan, truth = swaying
    clouds = loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device)
    chosen = np.arange(0, COUNT, 50)
    slid = np.median(errors_of(swaying_cloud(device)[1], truth))
    constrained = np.median(errors_of(bend(*clouds, landmarks=(body[chosen], truth[chosen])), truth))
    assert constrained < 0.25 * slid and constrained < 0.02


@LONG
@pytest.mark.slow
def test_twists_and_expansions_are_recovered(device):
    for body, scan, truth in (
        (tube(COUNT, 0), twisted(tube(COUNT, 1)), twisted(tube(COUNT, 0))),
        (lumpy(COUNT, 0), 1.15 * lumpy(COUNT, 1), 1.15 * lumpy(COUNT, 0)),
    ):
        result = bend(loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device))
        assert np.median(errors_of(result, truth)) < 0.07 and result.rmse < 0.006 and result.reliable


@pytest.mark.slow
@LONG
def test_a_partial_scan_deforms_the_visible_part(device, swaying):
    body, scan, truth = swaying
    part = loom.PointCloud(scan[scan[:, 0] > -0.2], device=device)
    result = bend(loom.PointCloud(body, device=device), part)
    seen = truth[:, 0] > 0
    away = cKDTree(swayed(lumpy(40_000, 2))).query(result.warped.points)[0]
    assert np.median(away[seen]) < 0.02 and result.reliable
    assert 0.4 < result.matched < 0.75 and (result.correspondences[truth[:, 0] < -0.5] < 0).mean() > 0.9


@LONG
@pytest.mark.nightly
def test_a_different_object_is_reported(device, swaying):
    body, _, _ = swaying
    for one, other in ((torus(COUNT, 0), tube(COUNT, 1)), (body, torus(COUNT, 1))):
        assert not bend(loom.PointCloud(one, device=device), loom.PointCloud(other, device=device)).reliable


@LONG
@pytest.mark.slow
def test_a_body_rotated_by_180_degrees_is_registered():
    body, scan = armed(COUNT, 0), loom.PointCloud(swayed(armed(2 * COUNT, 1)))
    flipped = loom.PointCloud(body * [1, -1, -1])
    result = bend(flipped, scan)
    assert np.median(errors_of(result, swayed(body))) < 0.15 and result.reliable
    from_init = bend(flipped, scan, init=np.eye(4))
    assert np.median(errors_of(from_init, swayed(body))) > 0.4
    assert "rotated by 180 degrees (better_start)" in str(from_init.warnings)
    again = bend(flipped, scan, init=from_init.better_start)
    assert again.reliable and again.strain < 0.75 * from_init.strain


@LONG
@pytest.mark.parametrize(("last", "warns"), [(1, True), (30, False)])
def test_a_last_stiffness_that_does_not_converge_is_reported(device, swaying, last, warns):
    """Earlier stiffnesses need not converge: they only give the start of the next one."""
    cloud, scan = (loom.PointCloud(points, device=device) for points in swaying[:2])
    first = bend(cloud, scan, stiffness=[10.0, 0.1], max_iterations=last, tolerance=0.02)
    assert first.last_converged is not warns and first.reliable is not warns
    assert ("not converged after 2 steps: use more max_iterations" in first.warnings) is warns
    assert first.to_dict()["reliable"] is not warns


@LONG
def test_a_rigid_motion_is_reported(device, swaying):
    body, _, _ = swaying
    cloud = loom.PointCloud(body, device=device)
    result = bend(cloud, cloud.translate(SHIFT))
    assert result.is_rigid and result.reliable
    assert errors_of(result, body + SHIFT).max() < 1e-3


@LONG
def test_the_deformation_transforms_points_normals_and_attributes(device):
    cloud, result = swaying_cloud(device)
    body = cloud.points
    T, warped = result.deformation, result.warped
    assert np.abs(T.transform(body) - warped.points).max() < 1e-5
    assert np.array_equal(warped["label"], np.arange(COUNT))
    step = 1e-3  # the Jacobian by differences
    slopes = np.stack([(T.transform(body + e) - T.transform(body - e)) / (2 * step) for e in step * np.eye(3)], axis=2)
    normals = np.linalg.solve(slopes.transpose(0, 2, 1), cloud.normals[:, :, None].astype(np.float64))[:, :, 0]
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    away = np.abs(normals - warped.normals).max(axis=1)
    assert np.quantile(away, 0.98) < 5e-3
    assert np.quantile(np.abs(np.linalg.det(slopes) / T.volumes(body) - 1), 0.98) < 5e-3


def test_attributes_of_the_target_are_transferred(device):
    body = lumpy(300, 0)
    cloud = loom.PointCloud(body, device=device)
    result = bend(cloud, cloud, node_spacing=0.9, stiffness=[10.0], max_iterations=2)
    has = result.correspondences >= 0
    assert np.array_equal(result.transfer(body)[has], body[result.correspondences[has]]) and has.mean() > 0.9
    labels = result.transfer(np.arange(300, dtype=np.int16), missing=-1)
    assert labels.dtype == np.int16 and np.array_equal(labels, np.where(has, result.correspondences, -1))
    with pytest.raises(ValueError, match="values: expected 300 rows"):
        result.transfer(np.zeros(299), 0)
    with pytest.raises(ValueError, match="missing"):
        result.transfer(np.arange(300), np.nan)


def energy_of(unknowns, rest, edges, degrees, positions, near, weights, targets, weight, stiffness):
    """The residuals of landmarks and regularization in NumPy."""
    rotations, centers = Rotation.from_rotvec(unknowns[:, :3]).as_matrix(), unknowns[:, 3:]
    arms = positions[:, None] - rest[near]
    bent = (weights[:, :, None] * (np.einsum("nkij,nkj->nki", rotations[near], arms) + centers[near])).sum(axis=1)
    a, b = edges.T
    ties = np.einsum("eij,ej->ei", rotations[a], rest[b] - rest[a]) + centers[a] - centers[b]
    return np.concatenate([np.sqrt(weight) * (bent - targets), np.sqrt(stiffness / degrees[a])[:, None] * ties]).ravel()


@LONG
def test_landmarks_alone_minimize_the_energy(device):
    grid = np.stack(np.meshgrid(np.arange(8.0), np.arange(4.0), [0.0]), axis=-1).reshape(-1, 3)
    grid[:, 2] = 0.05 * np.sin(grid[:, 0] * 3 + grid[:, 1])
    positions = grid[[0, 3, 12, 17, 28, 31]] + 0.1
    targets = positions + np.random.default_rng(0).normal(0, 0.3, positions.shape)
    clouds = [loom.PointCloud(points, device=device) for points in (grid, grid + ABOVE)]  # no pairs: only landmarks
    options = {"node_spacing": 1.5, "max_correspondence_distance": 0.5, "max_iterations": 200, "tolerance": 1e-9}
    result = bend(*clouds, landmarks=(positions, targets), landmark_weight=3.0, stiffness=[2.0], **options)
    T = result.deformation
    rest, n = T.nodes, len(T)
    assert result.converged and n > 6
    fractions = [_fractions(p, rest) for p in np.concatenate([grid, positions])]
    pairs = {(int(a), int(b)) for near, w in fractions[: len(grid)] for a in near[w > 0] for b in near[w > 0] if a != b}
    edges = np.array(sorted(pairs))
    near, weights = (np.array(part) for part in zip(*fractions[len(grid) :], strict=True))
    data = (rest, edges, np.bincount(edges[:, 0], minlength=n), positions, near, weights, targets, 3.0, 2.0)
    start = np.hstack([Rotation.from_matrix(T.rotations).as_rotvec(), rest + T.translations])
    best = least_squares(lambda x: energy_of(x.reshape(n, 6), *data), start.ravel(), xtol=1e-15, ftol=1e-15, gtol=1e-15)
    energy = 0.5 * (energy_of(start, *data) ** 2).sum()
    assert energy <= best.cost * (1 + 1e-6) and np.abs(best.x.reshape(n, 6)[:, 3:] - start[:, 3:]).max() < 1e-3


def _fractions(p, rest):
    d = np.linalg.norm(rest - p, axis=1)
    near = np.argsort(d, kind="stable")[:5]
    w = (1 - d[near[:4]] / d[near[4]]) ** 2
    return near[:4], w / w.sum()


def test_a_few_steps_match_on_every_device(device, monkeypatch):
    monkeypatch.setattr(nearest_point, "order_along_curve", None)  # searches are in the order of the clouds' trees
    body = lumpy(200, 0)
    scan, options = swayed(lumpy(300, 1)), {"node_spacing": 0.9, "stiffness": [10.0, 1.0], "max_iterations": 2}
    pins = body[:3], swayed(body[:3])
    pairs = ([loom.PointCloud(points, device=where) for points in (body, scan)] for where in (device, device, "cpu"))
    result, again, expected = (bend(*pair, landmarks=pins, **options) for pair in pairs)
    assert np.array_equal(result.warped.points, again.warped.points)
    assert np.abs(result.warped.points - expected.warped.points).max() < 1e-5
    assert result.iterations == 4 and result.rmse < result.rigid_rmse


def test_contradictory_landmarks_are_named(device, swaying):
    body, scan, _ = swaying
    clouds = loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device)
    positions, belong = body[[5, 80, 5]], np.array([[0.5, 0, 0], [0, 0.5, 0], [-0.5, 0, 0]])
    with pytest.raises(ValueError, match="landmarks:"):
        bend(*clouds, landmarks=(positions, belong))


def test_fewer_nodes_than_parts_are_reported(device):
    ball = lumpy(300, 0)
    body = np.vstack([ball, lumpy(300, 1) + 4 * ALONG])
    apart = np.vstack([ball, lumpy(300, 1) + 6 * ALONG])  # one part moved elsewhere; both share one node
    clouds = loom.PointCloud(body, device=device), loom.PointCloud(apart, device=device)
    options = {"node_spacing": 20.0, "max_correspondence_distance": 0.5, "stiffness": [1.0], "max_iterations": 3}
    result = bend(*clouds, init=np.eye(4), **options)
    assert len(result.deformation) == 1 and "matches the other" in str(result.warnings)


def test_a_stretched_body_is_reported(device):
    body = tube(400, 0)
    scan = body * [1, 1, 1.6]
    pins = body[::8], scan[::8]
    clouds = loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device)
    result = bend(*clouds, node_spacing=0.4, landmarks=pins, stiffness=[0.1], max_iterations=5)
    assert "the deformation stretches the source by" in str(result.warnings)


def test_one_step_applies_a_full_rotation(device):
    body = lumpy(200, 0)
    c, s = np.cos(0.2), np.sin(0.2)
    rotated = body @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]]).T
    options = {"node_spacing": 0.9, "max_correspondence_distance": 0.1, "stiffness": [1.0], "max_iterations": 1}
    clouds = [loom.PointCloud(points, device=device) for points in (body, rotated + ABOVE)]  # no pairs: only landmarks
    result = bend(*clouds, init=np.eye(4), landmarks=(body[::4], rotated[::4]), **options)
    angles = np.arccos((np.trace(result.deformation.rotations, axis1=1, axis2=2) - 1) / 2)
    assert np.abs(angles - 0.2).max() < 0.2**2  # the error after a Gauss-Newton step is of second order


def test_the_far_side_of_a_thin_body_is_not_matched(device):
    x, y = np.random.default_rng(0).uniform(-1, 1, (2, 500))
    up, down = np.tile([[0, 0, 1.0]], (500, 1)), np.tile([[0, 0, -1.0]], (500, 1))
    sheet = np.column_stack([x, y, 0.05 * np.sin(3 * x)])
    front = loom.PointCloud(sheet, normals=up, device=device)
    back = loom.PointCloud(sheet - [0, 0, 0.05], normals=down, device=device)
    result = bend(front, back, init=np.eye(4), node_spacing=0.9, stiffness=[10.0], max_iterations=1)
    assert (result.correspondences == -1).all()


drift = loom.registration.coherent_point_drift
ROTATION = Rotation.from_rotvec([0.3, 0.4, -0.2]).as_matrix()
FLAT = [1.0, 0.8, 0.5]  # no rotational symmetry


def transformed(points):
    return 1.2 * points @ ROTATION.T + [0.2, 0.1, 0.0]


def steps_in_numpy(Y, X, kind, count, w=0.1, width=2.0, stiffness=3.0):
    """The paper's steps over all pairs: the moved points and the deviation."""
    center, radius = Y.mean(axis=0), np.sqrt(((Y - Y.mean(axis=0)) ** 2).sum(axis=1).mean())
    Y, X = (Y - center) / radius, (X - center) / radius
    moved, variance = Y, ((X[None] - Y[:, None]) ** 2).sum() / (3 * len(X) * len(Y))
    G = np.exp(-((Y[None] - Y[:, None]) ** 2).sum(axis=2) / (2 * width**2))
    for _ in range(count):
        e = np.exp(-((X[None] - moved[:, None]) ** 2).sum(axis=2) / (2 * variance))
        P = e / (e.sum(axis=0) + (2 * np.pi * variance) ** 1.5 * w / (1 - w) * len(Y) / len(X))
        p, total, PX = P.sum(axis=1), P.sum(), P @ X
        if kind == "deformable":
            W = np.linalg.solve(p[:, None] * G + stiffness * variance * np.eye(len(Y)), PX - p[:, None] * Y)
            moved = Y + G @ W
        else:
            x, y = PX.sum(axis=0) / total, p @ Y / total
            cross, spread = PX.T @ Y / total - np.outer(x, y), (Y - y).T @ (p[:, None] * (Y - y)) / total
            if kind == "affine":
                A = cross @ np.linalg.inv(spread)
            else:
                U, D, Vt = np.linalg.svd(cross)
                signs = [1, 1, np.linalg.det(U @ Vt)]
                A = (D * signs).sum() / np.trace(spread) * (U * signs) @ Vt
            moved = Y @ A.T + x - A @ y
        variance = (P * ((X[None] - moved[:, None]) ** 2).sum(axis=2)).sum() / (3 * total)
    return moved * radius + center, np.sqrt(variance) * radius


@pytest.mark.parametrize("kind", ["rigid", "affine", "deformable"])
def test_steps_match_the_paper(device, kind):
    body, scan = lumpy(120, 0) * FLAT, lumpy(150, 1) * FLAT
    scan = swayed(scan) if kind == "deformable" else transformed(scan)
    clouds = loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device)
    result = drift(*clouds, kind=kind, max_iterations=12, tolerance=1e-12)
    moved, deviation = steps_in_numpy(body, scan, kind, 12)
    np.testing.assert_allclose(result.warped.points, moved, atol=2e-6)
    np.testing.assert_allclose(result.deviation, deviation, rtol=1e-6)
    again = drift(loom.PointCloud(body), loom.PointCloud(scan), kind=kind, max_iterations=12, tolerance=1e-12)
    np.testing.assert_array_equal(result.warped.points, again.warped.points)


@pytest.mark.parametrize("count", [4, 7, 8, 9, 17])
def test_all_points_are_weighted_for_any_count(device, count):
    body, scan = lumpy(count, 0), swayed(lumpy(count + 1, 1))
    result = drift(loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device), max_iterations=2)
    np.testing.assert_allclose(result.warped.points, steps_in_numpy(body, scan, "rigid", 2)[0], atol=2e-6)


def test_tree_search_matches_all_pairs(device, monkeypatch):
    body, scan = lumpy(400, 0) * FLAT, transformed(lumpy(500, 1) * FLAT)
    clouds = loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device)
    results = []
    for near in (0.0, 100.0):
        monkeypatch.setattr(module, "MAX_TREE_DEVIATION", near)
        results.append(drift(*clouds, max_iterations=25, tolerance=1e-12))
    assert results[0].deviation < 0.15
    np.testing.assert_allclose(results[0].transformation, results[1].transformation, atol=1e-9)


@pytest.mark.parametrize("kind", ["rigid", "affine", "deformable"])
@pytest.mark.parametrize("count", [6, 12, 40, 120])
def test_a_drift_of_unrelated_points_is_not_reliable(device, kind, count):
    rng = np.random.default_rng(count)
    for flat in (1, 0.05):
        clouds = [loom.PointCloud(rng.uniform(0, 3, (count, 3)) * [1, 1, flat], device=device) for _ in range(2)]
        assert not drift(*clouds, kind=kind).reliable
    ring, block = lumpy(count, 1), rng.uniform(-1, 1, (count, 3))
    block[np.arange(count), np.arange(count) % 3] = 1
    assert not drift(loom.PointCloud(ring, device=device), loom.PointCloud(block, device=device), kind=kind).reliable


@pytest.mark.parametrize(("kind", "count"), [("rigid", 5), ("rigid", 20), ("affine", 10), ("deformable", 100)])
def test_a_drift_of_few_points_that_match_accurately_is_reliable(device, kind, count):
    rng = np.random.default_rng(count)
    body = rng.uniform(0, 3, (count, 3))
    scan = (swayed(body / 3) * 3 if kind == "deformable" else body) + 0.003 * rng.normal(size=(count, 3))
    assert drift(loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device), kind=kind).warnings == ()


def test_a_rotated_and_scaled_body_is_registered():
    body, scan = lumpy(400, 0) * FLAT, transformed(lumpy(400, 0) * FLAT)
    result = drift(loom.PointCloud(body), loom.PointCloud(scan), outliers=0.01, max_iterations=300)
    np.testing.assert_allclose(result.transformation[:3, :3], 1.2 * ROTATION, atol=1e-3)
    assert result.reliable and result.matched > 0.99
    stiff = drift(loom.PointCloud(body), loom.PointCloud(scan), with_scaling=False, max_iterations=300)
    np.testing.assert_allclose(np.linalg.det(stiff.transformation[:3, :3]), 1, atol=1e-12)


def test_a_field_transforms_other_points():
    body = lumpy(500, 0)
    cloud = loom.PointCloud(body, label=np.arange(500))
    result = drift(cloud, loom.PointCloud(swayed(body)), kind="deformable", outliers=0.01)
    assert np.abs(result.warped.points - swayed(body)).max() < 0.02 and result.reliable
    np.testing.assert_allclose(result.transform(body), result.warped.points, atol=1e-6)
    assert np.array_equal(result.warped["label"], np.arange(500))
    between = lumpy(300, 5)
    assert np.abs(result.transform(between) - swayed(between)).max() < 0.05


def test_a_third_of_outliers_is_excluded():
    rng = np.random.default_rng(0)
    body = lumpy(400, 0) * FLAT
    scan = np.vstack([transformed(body), rng.uniform(-2, 2, (200, 3))])
    result = drift(loom.PointCloud(body), loom.PointCloud(scan), outliers=0.35, max_iterations=300)
    assert np.abs(result.transform(body) - transformed(body)).max() < 0.02
    assert 0.6 < result.matched < 0.75 and result.reliable


def test_a_different_body_is_reported_unreliable():
    for one, other in ((torus, tube), (lumpy, torus), (tube, lumpy)):
        result = drift(loom.PointCloud(one(400, 0)), loom.PointCloud(other(400, 1)), max_iterations=300)
        assert not result.reliable


def test_a_wider_field_bends_less(rng):
    """A half of a strip is raised: a field of half its size follows the step, a far wider one does not."""
    body = rng.uniform(-1, 1, (150, 3)) * [1, 0.2, 0.02]
    scan = body + np.where(body[:, :1] > 0, [0, 0, 0.1], 0)
    clouds, errors, events = (loom.PointCloud(body), loom.PointCloud(scan)), [], []
    for width in (0.5, 20.0):
        options = {"kind": "deformable", "width": width, "max_iterations": 30}
        result = drift(*clouds, **options, progress=lambda *event: events.append(event))
        errors.append(np.abs(result.warped.points - scan).mean())
    assert errors[0] < 0.3 * errors[1]
    assert events[:2] == [("drift", 0, 30), ("drift", 1, 30)] and events[-1][0] == "drift"
