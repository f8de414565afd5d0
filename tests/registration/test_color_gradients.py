"""Color gradients are the least squares over the neighbors, and the other preparations of clouds for ICP."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.kernels.icp.plane_covariances import plane_covariances, plane_covariances_from_normals
from pointloom.kernels.lang import float32
from pointloom.registration.icp.preparation import doppler_measurements, generalized_covariances

from .color_surfaces import gradients_of, paint, wavy


def lists_within(points, radius, max_nn):
    """The hybrid search in float64: each point's nearest neighbors within the radius, itself included."""
    sqdists, rows = cKDTree(points).query(points, min(max_nn, len(points)))
    sqdists, rows = sqdists.reshape(len(points), -1), rows.reshape(len(points), -1)
    return [near[squared_distances < radius] for near, squared_distances in zip(rows, sqdists, strict=True)]


def reference_gradients(points, normals, intensities, radius, max_nn):
    """The minimum-norm least squares in float64 over the neighbors, projected onto the tangent plane."""
    points, normals = np.asarray(points, np.float64), np.asarray(normals, np.float64)
    gradients = np.zeros((len(points), 3))
    for row, near in enumerate(lists_within(points, radius, max_nn)):
        if len(near) >= 4 and normals[row].any():
            n = normals[row] / np.linalg.norm(normals[row])
            ways = points[near] - points[row]
            ways = ways - np.outer(ways @ n, n)
            gradients[row] = np.linalg.lstsq(ways, intensities[near] - intensities[row], rcond=1e-3)[0]
    return gradients


def test_gradients_in_the_fragment_match_least_squares(device, scan_set, fragment, tolerances):
    part = {"shipped": np.s_[:4000], "real": np.s_[40000:44000]}[scan_set]
    points, normals, colors = (a[part].astype(np.float32) for a in (fragment.points, fragment.normals, fragment.colors))
    intensities, gradients = gradients_of(points, normals, colors, 0.06, 30, device)
    expected = reference_gradients(points, normals, intensities.astype(np.float64), 0.06, 30)
    size = np.abs(expected).max(axis=1)
    error = np.abs(gradients - expected).max(axis=1) / np.maximum(size, size.max() / 100)
    assert size.max() > 1 and (error < tolerances.gradient).mean() >= tolerances.gradient_fraction
    np.testing.assert_allclose(intensities, colors.mean(axis=1), atol=2e-7)
    lengths = np.linalg.norm(gradients, axis=1) * np.linalg.norm(normals, axis=1)
    assert (np.abs((gradients * normals).sum(axis=1)) <= 1e-6 * lengths).all(), "a gradient lies in the plane"


def test_gradients_do_not_depend_on_the_unit_of_length(device, rng):
    """Open3D's do, as its neighbors are not projected onto the plane."""
    points = wavy(rng, 800)
    normals = loom.PointCloud(points).estimate_normals(max_nn=12).normals
    one, other = (
        gradients_of(points * np.float32(unit), normals, paint(points), 0.3 * unit, 30, device)[1] * unit
        for unit in (1.0, 128.0)
    )
    np.testing.assert_allclose(one, other, atol=1e-6 * np.abs(one).max())


def test_non_finite_points_contribute_nothing(device, rng):
    points, normals = wavy(rng, 900), np.tile([0, 0, 1.0], (900, 1))
    colors, bad = paint(points), rng.permutation(900)[:90]
    spoiled, dark = points.copy(), colors.copy()
    spoiled[bad[:30]], spoiled[bad[30:40]], dark[bad[40:]] = np.nan, [np.inf, 0, 0], np.nan
    intensities, gradients = gradients_of(spoiled, normals, dark, 0.3, 900, device)
    good = np.setdiff1d(np.arange(900), bad)
    _, expected = gradients_of(points[good], normals[good], colors[good], 0.3, 900, device)
    np.testing.assert_allclose(gradients[good], expected, atol=1e-6)
    assert not gradients[bad].any() and np.isnan(intensities[bad[40:]]).all()
    normals[good[:7]] = [np.nan, 0, 1]
    _, lopsided = gradients_of(spoiled, normals, dark, 0.3, 900, device)
    assert not lopsided[good[:7]].any()
    np.testing.assert_array_equal(lopsided[good[7:]], gradients[good[7:]], "a neighbor's normal has no say")


lattice = st.lists(st.tuples(*[st.integers(-2, 2)] * 3, st.integers(0, 9)), min_size=1, max_size=40)


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(rows=lattice, radius=st.sampled_from([0.9, 1.2, 2.1, 50.0]), normal=st.sampled_from([(0, 0, 1), (1, 2, -1)]))
def test_gradients_of_lattices_match_least_squares(device, rows, radius, normal):
    """Few points, duplicates, lines and planes; no distance equals the radius and no count cuts a tie."""
    table = np.array(rows, np.float64)
    points, colors = table[:, :3], table[:, 3:].repeat(3, axis=1) / 9
    normals = np.tile(np.array(normal, float), (len(points), 1))
    intensities, gradients = gradients_of(points, normals, colors, radius, 64, device)
    expected = reference_gradients(points, normals, intensities.astype(np.float64), radius, 64)
    np.testing.assert_allclose(gradients, expected, atol=1e-5)


def test_covariances_come_from_the_cloud_its_normals_or_its_neighbors(device, rng, tolerances):
    cloud = loom.PointCloud(wavy(rng, 400), device=device)
    near = generalized_covariances(cloud, 1e-3).numpy()
    np.testing.assert_array_equal(near, plane_covariances(cloud.search_tree(), 20, 1e-3).numpy())
    tilted = cloud.estimate_normals(max_nn=5)
    by_normals = generalized_covariances(tilted, 0.01).numpy()
    np.testing.assert_array_equal(by_normals, plane_covariances_from_normals(tilted.arrays["normals"], 0.01).numpy())
    measured = tilted.estimate_covariances(max_nn=9)
    assert generalized_covariances(measured, 0.5, flatten=False) is measured.arrays["covariances"]
    planes = plane_covariances_from_normals(cloud.estimate_normals(max_nn=9).arrays["normals"], 0.5).numpy()
    np.testing.assert_allclose(generalized_covariances(measured, 0.5).numpy(), planes, atol=1e-4)
    wide = cloud.copy()
    wide["covariances"] = measured["covariances"].astype(np.float64)
    result = generalized_covariances(wide, 0.5, flatten=False)
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
    dopplers = speeds.reshape(shape).astype(dtype)
    cloud = loom.PointCloud(points, dopplers=dopplers, device=device, origin=[5.0, -9.0, 1.0])
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
