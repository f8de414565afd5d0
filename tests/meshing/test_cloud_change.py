"""Signed distances of clouds to open and closed meshes, and their significance."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import pointloom as loom

from .surface_oracles import distances_to_triangles

UTM = np.array([5e5, 5.4e6, 100.0])


def ground(count=30):
    """A hilly sheet of upward-facing triangles."""
    x, y = np.meshgrid(np.arange(count + 1.0), np.arange(count + 1.0))
    corners = np.column_stack([x.ravel(), y.ravel(), np.sin(x.ravel()) + np.cos(y.ravel() / 2)])
    rows = (np.arange(count)[:, None] * (count + 1) + np.arange(count)).ravel()
    up, far = rows + 1, rows + count + 1
    return corners, np.concatenate([np.column_stack([rows, up, far + 1]), np.column_stack([rows, far + 1, far])])


@pytest.mark.parametrize("at", [np.zeros(3), UTM], ids=["here", "in UTM"])
def test_distances_match_brute_force_and_signs_mark_above_and_below(device, rng, at):
    corners, triangles = ground()
    positions = rng.random((100, 2)) * 24 + 3
    height = np.sin(positions[:, 0]) + np.cos(positions[:, 1] / 2)
    lift = rng.choice([-1, 1], 100) * (0.4 + rng.random(100))
    points = np.column_stack([positions, height + lift])
    mesh = loom.TriangleMesh(corners + at, triangles, device=device)
    result = loom.change.cloud_to_mesh(loom.PointCloud(points + at, device=device), mesh)
    expected = distances_to_triangles(points, corners[triangles]).min(axis=1)
    np.testing.assert_allclose(np.abs(result.distances), expected, rtol=0, atol=2e-6)
    np.testing.assert_array_equal(result.distances > 0, lift > 0)
    assert not result.beside.any() and result.is_significant.all() and (result.counts == 1).all()


def test_a_point_over_a_sharp_edge_is_above_although_one_triangle_faces_away(device):
    roof = [[0, 0, 0], [4, 0, 0], [4, 1, 3], [0, 1, 3], [4, 1.5, 0], [0, 1.5, 0]]
    mesh = loom.TriangleMesh(roof, [[0, 1, 2], [0, 2, 3], [3, 2, 4], [3, 4, 5]], device=device)
    over, under = [2, 1.0, 3.5], [2, 0.9, 2]
    result = loom.change.cloud_to_mesh(loom.PointCloud([over, under], device=device), mesh)
    assert result.distances[0] == pytest.approx(0.5) and result.distances[1] < 0


def test_points_beside_an_open_mesh_are_flagged(device):
    mesh = loom.TriangleMesh(*ground(), device=device)
    points = [[-2, 5, 1], [-1, -1, 0], [31, 31, 1], [15.2, 15.3, 3]]
    result = loom.change.cloud_to_mesh(loom.PointCloud(points, device=device), mesh)
    assert result.beside.tolist() == [True, True, True, False]
    assert result.is_significant.tolist() == [False, False, False, True]


def test_neighbors_determine_the_noise(device, rng):
    corners, triangles = ground()
    mesh = loom.TriangleMesh(corners * (1, 1, 0), triangles, device=device)
    points = np.column_stack([rng.random((8000, 2)) * 30, 0.05 * rng.normal(size=8000)])
    raised = points[:, 0] > 20
    points[raised, 2] += 0.05
    cloud = loom.PointCloud(points, device=device)
    result = loom.change.cloud_to_mesh(cloud, mesh, radius=1.0, registration_error=0.001)
    tree, heights = cKDTree(points), points[:, 2]
    for row in range(0, 8000, 97):
        near = heights[tree.query_ball_point(points[row], 1.0 - 1e-6)]
        assert result.counts[row] == len(near)
        assert result.distances[row] == pytest.approx(near.mean(), abs=1e-7)
        assert result.spreads[row] == pytest.approx(near.std(ddof=1), abs=1e-7)
        limit = 1.96 * (near.std(ddof=1) / np.sqrt(len(near)) + 0.001)
        assert result.level_of_detection[row] == pytest.approx(limit, abs=1e-7)
    inner = np.abs(points[:, 0] - 20) > 1.2
    significant = result.is_significant & inner
    assert significant[raised & inner].mean() > 0.95 and significant[~raised & inner].mean() < 0.12


def test_undefined_distances_are_nan(device):
    mesh = loom.TriangleMesh(*ground(), device=device)
    points = [[15, 15, 50], [np.nan, 0, 0], [15, 15, 1.2]]
    result = loom.change.cloud_to_mesh(loom.PointCloud(points, device=device), mesh, max_distance=10)
    assert np.isnan(result.distances).tolist() == [True, True, False]
    assert result.is_significant.tolist()[:2] == [False, False]
    empty = loom.TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32), device=device)
    assert np.isnan(loom.change.cloud_to_mesh(loom.PointCloud(points, device=device), empty).distances).all()
    none = loom.change.cloud_to_mesh(loom.PointCloud(np.zeros((0, 3)), device=device), mesh, radius=1.0)
    assert repr(none) == "CloudToMeshResult(0 points, 0 with a distance, 0 significant)"
