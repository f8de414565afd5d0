"""Coherent point drift follows the steps of the paper and reports failed alignments."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.registration.deformable import coherent_drift as module

from .bent_bodies import lumpy, swayed, torus, tube

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
        monkeypatch.setattr(module, "NEAR", near)
        results.append(drift(*clouds, max_iterations=25, tolerance=1e-12))
    assert results[0].deviation < 0.15
    np.testing.assert_allclose(results[0].transformation, results[1].transformation, atol=1e-9)


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
