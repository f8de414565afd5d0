"""Attributes that estimators require: errors name the method that provides them, existing ones are used."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.icp.plane_covariances import plane_covariances, plane_covariances_from_normals
from pointloom.kernels.lang import float32
from pointloom.registration.icp.preparation import doppler_measurements, generalized_covariances

from .color_surfaces import wavy


def test_covariances_come_from_the_cloud_its_normals_or_its_neighbors(device, rng, tolerances):
    cloud = loom.PointCloud(wavy(rng, 400), device=device)
    near = generalized_covariances(cloud, 1e-3).numpy()
    np.testing.assert_array_equal(near, plane_covariances(cloud.search_tree(), 20, 1e-3).numpy())
    tilted = cloud.estimate_normals(max_nn=5)
    by_normals = generalized_covariances(tilted, 0.01).numpy()
    np.testing.assert_array_equal(by_normals, plane_covariances_from_normals(tilted.array("normals"), 0.01).numpy())
    measured = tilted.estimate_covariances(max_nn=9)
    assert generalized_covariances(measured, 0.5) is measured.array("covariances")
    wide = cloud.copy()
    wide["covariances"] = measured["covariances"].astype(np.float64)
    result = generalized_covariances(wide, 0.5)
    assert result.dtype == float32
    np.testing.assert_array_equal(result.numpy(), measured["covariances"])
    wide["covariances"] = np.zeros((400, 6))
    with pytest.raises(ValueError, match="target:"):
        generalized_covariances(wide, 0.5, "target")


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("shape", [(300,), (300, 1)], ids=str)
def test_directions_point_from_the_sensor_to_the_points(device, shape, dtype, rng):
    points, speeds = rng.normal(size=(300, 3)) * 30, rng.normal(size=300)
    points[7] = 0
    cloud = loom.PointCloud(
        points, dopplers=speeds.reshape(shape).astype(dtype), device=device, origin=[5.0, -9.0, 1.0]
    )
    result = doppler_measurements(cloud)
    expected = points / np.maximum(np.linalg.norm(points, axis=1, keepdims=True), 1e-9)
    np.testing.assert_allclose(np.delete(result.directions.numpy(), 7, 0), np.delete(expected, 7, 0), atol=1e-5)
    np.testing.assert_array_equal(result.dopplers.numpy(), speeds.astype(np.float32))
    assert result.dopplers.dtype == float32 and result.dopplers.shape == (300,)


def test_given_directions_are_used(device, rng):
    cloud = loom.PointCloud(rng.normal(size=(40, 3)), dopplers=np.zeros(40), device=device)
    for dtype in (np.float32, np.float64):
        cloud["directions"] = np.tile([0, 3, 4.0], (40, 1)).astype(dtype)
        directions = doppler_measurements(cloud).directions.numpy()
        np.testing.assert_allclose(directions, np.tile([0, 0.6, 0.8], (40, 1)), atol=1e-7)
    cloud["directions"] = np.zeros((40, 2))
    with pytest.raises(ValueError, match="source:"):
        doppler_measurements(cloud)
    cloud["dopplers"] = np.zeros((40, 2))
    with pytest.raises(ValueError, match="frame:"):
        doppler_measurements(cloud, "frame")
