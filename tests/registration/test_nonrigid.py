"""A body is bent onto another scan of it as it was bent, and what is not it is told."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import pointloom as loom

from .bent_bodies import armed, lumpy, swayed, torus, tube, twisted

bend = loom.registration.register_nonrigid
COUNT = 1500
LONG = pytest.mark.slow_on_emulated_cuda("hundreds of turns of conjugate gradients; a few steps stand for them")
SHIFT = np.array([0.01, 0.02, 0.0])
ALONG = np.array([1.0, 0.0, 0.0])
ABOVE = np.array([0.0, 0.0, 40.0])


def errors_of(found, truth):
    return np.linalg.norm(found.warped.points - truth, axis=1)


@pytest.fixture(scope="module")
def swaying():
    """The body, a scan of it bent, and where its points then are."""
    body = lumpy(COUNT, 0)
    return body, swayed(lumpy(2 * COUNT, 1)), swayed(body)


@cache
def swaying_cloud(device):
    """The body with normals and labels, and the result of bending it onto the scan."""
    cloud = loom.PointCloud(lumpy(COUNT, 0), device=device, label=np.arange(COUNT)).estimate_normals(max_nn=20)
    return cloud, bend(cloud, loom.PointCloud(swayed(lumpy(2 * COUNT, 1)), device=device))


@LONG
def test_the_surface_of_a_body_comes_to_where_it_was_bent(device):
    _, found = swaying_cloud(device)
    away = cKDTree(swayed(lumpy(40_000, 2))).query(found.warped.points)[0]
    assert np.median(away) < 0.02 and found.rmse < 0.2 * found.rigid_rmse
    assert found.reliable and not found.is_rigid and found.covered > 0.95


@LONG
def test_landmarks_keep_points_from_sliding_along_the_surface(device, swaying):
    body, scan, truth = swaying
    clouds = loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device)
    chosen = np.arange(0, COUNT, 50)
    slid = np.median(errors_of(swaying_cloud(device)[1], truth))
    held = np.median(errors_of(bend(*clouds, landmarks=(body[chosen], truth[chosen])), truth))
    assert held < 0.25 * slid and held < 0.02


@LONG
@pytest.mark.slow
def test_a_tube_is_twisted_and_a_ball_breathes(device):
    for body, scan, truth in (
        (tube(COUNT, 0), twisted(tube(COUNT, 1)), twisted(tube(COUNT, 0))),
        (lumpy(COUNT, 0), 1.15 * lumpy(COUNT, 1), 1.15 * lumpy(COUNT, 0)),
    ):
        found = bend(loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device))
        assert np.median(errors_of(found, truth)) < 0.07 and found.rmse < 0.006 and found.reliable


@LONG
def test_a_scan_of_a_part_bends_the_part_that_it_shows(device, swaying):
    body, scan, truth = swaying
    part = loom.PointCloud(scan[scan[:, 0] > -0.2], device=device)
    found = bend(loom.PointCloud(body, device=device), part)
    seen = truth[:, 0] > 0
    away = cKDTree(swayed(lumpy(40_000, 2))).query(found.warped.points)[0]
    assert np.median(away[seen]) < 0.02 and found.reliable
    assert 0.4 < found.matched < 0.75 and (found.correspondences[truth[:, 0] < -0.5] < 0).mean() > 0.9


@LONG
@pytest.mark.nightly
def test_another_object_is_told(device, swaying):
    body, _, _ = swaying
    found = bend(loom.PointCloud(torus(COUNT, 0), device=device), loom.PointCloud(tube(COUNT, 1), device=device))
    assert not found.reliable
    found = bend(loom.PointCloud(body, device=device), loom.PointCloud(torus(COUNT, 1), device=device))
    assert not found.reliable


@LONG
@pytest.mark.slow
def test_a_body_that_begins_turned_round_is_turned():
    body, scan = armed(COUNT, 0), loom.PointCloud(swayed(armed(2 * COUNT, 1)))
    turned = loom.PointCloud(body * [1, -1, -1])
    found = bend(turned, scan)
    assert np.median(errors_of(found, swayed(body))) < 0.15 and found.reliable
    told = bend(turned, scan, init=np.eye(4))
    assert np.median(errors_of(told, swayed(body))) > 0.4 and "rotated by 180 degrees (better_start)" in str(
        told.warnings
    )
    again = bend(turned, scan, init=told.better_start)
    assert again.reliable and again.strain < 0.75 * told.strain


@LONG
def test_what_did_not_bend_is_told(device, swaying):
    body, _, _ = swaying
    cloud = loom.PointCloud(body, device=device)
    found = bend(cloud, cloud.translate(SHIFT))
    assert found.is_rigid and found.reliable
    assert errors_of(found, body + SHIFT).max() < 1e-3


@LONG
def test_the_bend_takes_points_normals_and_attributes_along(device):
    cloud, found = swaying_cloud(device)
    body = cloud.points
    T, warped = found.deformation, found.warped
    assert np.abs(T.transform(body) - warped.points).max() < 1e-5
    assert np.array_equal(warped["label"], np.arange(COUNT))
    step = 1e-3  # the Jacobian by differences
    slopes = np.stack([(T.transform(body + e) - T.transform(body - e)) / (2 * step) for e in step * np.eye(3)], axis=2)
    normals = np.linalg.solve(slopes.transpose(0, 2, 1), cloud.normals[:, :, None].astype(np.float64))[:, :, 0]
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    away = np.abs(normals - warped.normals).max(axis=1)
    assert np.quantile(away, 0.98) < 5e-3
    assert np.quantile(np.abs(np.linalg.det(slopes) / T.volumes(body) - 1), 0.98) < 5e-3


def test_what_the_target_has_is_transferred(device):
    body = lumpy(300, 0)
    cloud = loom.PointCloud(body, device=device)
    found = bend(cloud, cloud, node_spacing=0.9, stiffness=[10.0], max_iterations=2)
    has = found.correspondences >= 0
    assert np.array_equal(found.transfer(body)[has], body[found.correspondences[has]]) and has.mean() > 0.9
    labels = found.transfer(np.arange(300, dtype=np.int16), missing=-1)
    assert labels.dtype == np.int16 and np.array_equal(labels, np.where(has, found.correspondences, -1))
    for values, missing, words in (
        (np.zeros(299), 0, "values: expected 300 rows"),
        (np.arange(300), np.nan, "missing"),
    ):
        with pytest.raises(ValueError, match=words):
            found.transfer(values, missing)


def energy_of(unknowns, rest, edges, degrees, places, near, weights, targets, weight, stiffness):
    """The residuals of landmarks and ties, in NumPy."""
    turns, centers = Rotation.from_rotvec(unknowns[:, :3]).as_matrix(), unknowns[:, 3:]
    arms = places[:, None] - rest[near]
    bent = (weights[:, :, None] * (np.einsum("nkij,nkj->nki", turns[near], arms) + centers[near])).sum(axis=1)
    a, b = edges.T
    ties = np.einsum("eij,ej->ei", turns[a], rest[b] - rest[a]) + centers[a] - centers[b]
    return np.concatenate([np.sqrt(weight) * (bent - targets), np.sqrt(stiffness / degrees[a])[:, None] * ties]).ravel()


@LONG
def test_landmarks_alone_reach_the_least_of_the_energy(device):
    grid = np.stack(np.meshgrid(np.arange(8.0), np.arange(4.0), [0.0]), axis=-1).reshape(-1, 3)
    grid[:, 2] = 0.05 * np.sin(grid[:, 0] * 3 + grid[:, 1])
    places = grid[[0, 3, 12, 17, 28, 31]] + 0.1
    targets = places + np.random.default_rng(0).normal(0, 0.3, places.shape)
    cloud = loom.PointCloud(grid, device=device)
    far = loom.PointCloud(grid + ABOVE, device=device)  # no pairs: landmarks are all there is
    found = bend(
        cloud,
        far,
        node_spacing=1.5,
        max_correspondence_distance=0.5,
        landmarks=(places, targets),
        landmark_weight=3.0,
        stiffness=[2.0],
        max_iterations=200,
        tolerance=1e-9,
    )
    T = found.deformation
    rest, n = T.nodes, len(T)
    assert found.converged and n > 6
    shares = [_shares(p, rest) for p in np.concatenate([grid, places])]
    pairs = {(int(a), int(b)) for near, w in shares[: len(grid)] for a in near[w > 0] for b in near[w > 0] if a != b}
    edges = np.array(sorted(pairs))
    near, weights = (np.array(part) for part in zip(*shares[len(grid) :], strict=True))
    data = (rest, edges, np.bincount(edges[:, 0], minlength=n), places, near, weights, targets, 3.0, 2.0)
    start = np.hstack([Rotation.from_matrix(T.rotations).as_rotvec(), rest + T.translations])
    best = least_squares(lambda x: energy_of(x.reshape(n, 6), *data), start.ravel(), xtol=1e-15, ftol=1e-15, gtol=1e-15)
    ours = 0.5 * (energy_of(start, *data) ** 2).sum()
    assert ours <= best.cost * (1 + 1e-6) and np.abs(best.x.reshape(n, 6)[:, 3:] - start[:, 3:]).max() < 1e-3


def _shares(p, rest):
    d = np.linalg.norm(rest - p, axis=1)
    near = np.argsort(d, kind="stable")[:5]
    w = (1 - d[near[:4]] / d[near[4]]) ** 2
    return near[:4], w / w.sum()


def test_a_few_steps_are_the_same_everywhere(device):
    body = lumpy(200, 0)
    scan, options = swayed(lumpy(300, 1)), {"node_spacing": 0.9, "stiffness": [10.0, 1.0], "max_iterations": 2}
    pins = body[:3], swayed(body[:3])
    found, again, expected = (
        bend(loom.PointCloud(body, device=where), loom.PointCloud(scan, device=where), landmarks=pins, **options)
        for where in (device, device, "cpu")
    )
    assert np.array_equal(found.warped.points, again.warped.points)
    assert np.abs(found.warped.points - expected.warped.points).max() < 1e-5
    assert found.iterations == 4 and found.rmse < found.rigid_rmse


def test_landmarks_that_contradict_each_other_are_named(device, swaying):
    body, scan, _ = swaying
    clouds = loom.PointCloud(body, device=device), loom.PointCloud(scan, device=device)
    places, belong = body[[5, 80, 5]], np.array([[0.5, 0, 0], [0, 0.5, 0], [-0.5, 0, 0]])
    with pytest.raises(ValueError, match="landmarks:"):
        bend(*clouds, landmarks=(places, belong))


def test_fewer_nodes_than_parts_are_told(device):
    ball = lumpy(300, 0)
    body = np.vstack([ball, lumpy(300, 1) + 4 * ALONG])
    apart = np.vstack([ball, lumpy(300, 1) + 6 * ALONG])  # one part went elsewhere; there is one node for both
    clouds = loom.PointCloud(body, device=device), loom.PointCloud(apart, device=device)
    found = bend(
        *clouds, node_spacing=20.0, max_correspondence_distance=0.5, init=np.eye(4), stiffness=[1.0], max_iterations=3
    )
    assert len(found.deformation) == 1
    assert "matches the other" in str(found.warnings)


def test_a_body_that_would_be_stretched_is_told(device):
    body = tube(400, 0)
    scan = body * [1, 1, 1.6]
    pins = body[::8], scan[::8]
    found = bend(
        loom.PointCloud(body, device=device),
        loom.PointCloud(scan, device=device),
        node_spacing=0.4,
        landmarks=pins,
        stiffness=[0.1],
        max_iterations=5,
    )
    assert "the deformation stretches the source by" in str(found.warnings)


def test_a_step_takes_a_turn_at_once(device):
    body = lumpy(200, 0)
    c, s = np.cos(0.2), np.sin(0.2)
    turned = body @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]]).T
    found = bend(
        loom.PointCloud(body, device=device),
        loom.PointCloud(turned + ABOVE, device=device),  # no pairs: landmarks are all there is
        init=np.eye(4),
        node_spacing=0.9,
        max_correspondence_distance=0.1,
        landmarks=(body[::4], turned[::4]),
        stiffness=[1.0],
        max_iterations=1,
    )
    angles = np.arccos((np.trace(found.deformation.rotations, axis1=1, axis2=2) - 1) / 2)
    assert np.abs(angles - 0.2).max() < 0.2**2  # what a step of Gauss and Newton leaves is of the second order


def test_the_far_side_of_a_thin_body_is_no_partner(device):
    x, y = np.random.default_rng(0).uniform(-1, 1, (2, 500))
    up, down = np.tile([[0, 0, 1.0]], (500, 1)), np.tile([[0, 0, -1.0]], (500, 1))
    sheet = np.column_stack([x, y, 0.05 * np.sin(3 * x)])
    front = loom.PointCloud(sheet, normals=up, device=device)
    back = loom.PointCloud(sheet - [0, 0, 0.05], normals=down, device=device)
    found = bend(front, back, init=np.eye(4), node_spacing=0.9, stiffness=[10.0], max_iterations=1)
    assert (found.correspondences == -1).all()
