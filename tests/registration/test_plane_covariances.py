"""Plane covariances are flat along the normal, as in Open3D and small_gicp."""

import numpy as np
import pytest

from pointloom.kernels.icp.plane_covariances import plane_covariances, plane_covariances_from_normals
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.search.point_tree import PointTree


def covariances_from(normals, epsilon, device="cpu"):
    covariances = plane_covariances_from_normals(upload(np.asarray(normals, np.float32), vec3, device), epsilon)
    return covariances.numpy().reshape(-1, 3, 3)


@pytest.mark.parametrize("epsilon", [1e-3, 1.0])
def test_covariances_from_normals_are_flat_along_them(device, epsilon, rng, tolerances):
    """Also for normals near -x, where Open3D uses those of x; and for normals of any length."""
    normals = rng.normal(size=(500, 3)) * 3
    normals[:50] = [-5, 0, 0] + rng.normal(size=(50, 3)) * 0.3
    normals[0], normals[1] = [-1, 0, 0], [1, 0, 0]
    normals = normals.astype(np.float32)
    units = normals.astype(float) / np.linalg.norm(normals.astype(float), axis=1, keepdims=True)
    expected = np.eye(3) + (epsilon - 1) * units[:, :, None] * units[:, None, :]
    result = covariances_from(normals, epsilon, device)
    np.testing.assert_allclose(result, expected, atol=tolerances.float32_relative)
    np.testing.assert_array_equal(covariances_from(-normals, epsilon, device), result, "a plane has no side")
    for row in range(0, 500, 20):  # the paper's form: a rotation from the first axis to the normal
        R = np.linalg.qr(units[row][:, None], mode="complete")[0]
        np.testing.assert_allclose(R @ np.diag([epsilon, 1, 1]) @ R.T, expected[row], atol=1e-7)


def test_unknown_planes_have_isotropic_covariances(device):
    result = covariances_from([[0, 0, 0], [np.nan, 0, 1], [0, np.inf, 0], [0, 0, 1e-30]], 0.1, device)
    np.testing.assert_array_equal(result[0], np.eye(3))
    assert np.isnan(result[1:3]).all()
    np.testing.assert_allclose(result[3], np.diag([1, 1, 0.1]), atol=1e-7)
    assert covariances_from(np.empty((0, 3)), 0.1, device).shape == (0, 3, 3)


@pytest.mark.slow  # small_gicp is installed with the benchmarks
@pytest.mark.parametrize("scene", ["lidar", "fragment"])
def test_covariances_of_twenty_neighbors_match_small_gicp(device, scene, lidar, fragment, tolerances):
    gicp = pytest.importorskip("small_gicp")
    points = (lidar[:, :3] if scene == "lidar" else fragment.points[::20]).astype(np.float32)
    theirs = gicp.PointCloud(points.astype(np.float64))
    gicp.estimate_covariances(theirs)
    expected = np.array([theirs.cov(row)[:3, :3] for row in range(len(points))])
    result = plane_covariances(PointTree(upload(points, vec3, device))).numpy().reshape(-1, 3, 3)
    clear = np.abs(result - expected).max(axis=(1, 2)) < tolerances.plane_covariance
    assert clear.mean() > tolerances.normal_share
    np.testing.assert_allclose(np.linalg.eigvalsh(result), np.tile([1e-3, 1, 1], (len(points), 1)), atol=1e-6)


@pytest.mark.parametrize("count", [0, 1, 4, 5])
def test_fewer_than_five_points_have_isotropic_covariances(device, count):
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0.0]])[:count]
    with_nan = np.vstack([points, [[np.nan, 0, 0]]])
    result = plane_covariances(PointTree(upload(with_nan, vec3, device))).numpy().reshape(-1, 3, 3)
    np.testing.assert_allclose(
        result[:-1], np.tile(np.diag([1, 1, 1e-3 if count == 5 else 1]), (count, 1, 1)), atol=1e-7
    )
    assert np.isnan(result[-1]).all()
