"""Shape fitting agrees with SciPy on the same distances, with covariance; weights, initial shapes and invalid input."""

import numpy as np
import pytest
from scipy.optimize import least_squares

import pointloom as loom

from .made_shapes import made_shape

UTM = np.array([500_000.0, 5_400_000.0, 300.0])
SIZES = {"plane": (), "sphere": ("radius",), "cylinder": ("radius",), "cone": ("half_angle",)}
SIZES["torus"] = ("radius", "minor_radius")


def distances_of(kind, shape, points, x):
    """Distances of points from a shape that is moved, tilted and resized by x: an independent reference."""
    frame = shape.frame
    sizes = [getattr(shape, name) + change for name, change in zip(SIZES[kind], x[5:], strict=True)]
    axis = frame[2] + x[3] * frame[0] + x[4] * frame[1]
    axis = axis / np.sqrt(axis @ axis)
    y = (points - shape.center) - x[:3] @ frame
    along = y @ axis
    far = np.sqrt(np.maximum((y * y).sum(axis=1), 0))
    across = np.sqrt(np.maximum(far**2 - along**2, 0))
    if kind == "plane":
        return along
    if kind == "sphere":
        return far - sizes[0]
    if kind == "cylinder":
        return across - sizes[0]
    if kind == "cone":
        return across * np.cos(sizes[0]) - along * np.sin(sizes[0])
    return np.hypot(across - sizes[0], along) - sizes[1]


@pytest.mark.parametrize("kind", SIZES)
def test_a_fit_is_scipy_s_and_so_is_its_covariance(device, kind):
    rng = np.random.default_rng(3)
    made, _, _ = made_shape(kind, 1500, rng, 0.004, arc=0.6)
    weights = 0.2 + rng.random(len(made))
    cloud = loom.PointCloud(made + UTM, device=device)
    shape = loom.fit_shape(cloud, kind, weights=weights)
    names = ["shift_u", "shift_v", "shift_axis", "tilt_u", "tilt_v", *SIZES[kind]]
    free = [names.index(name) for name in shape.unknowns]

    def rows(x):
        full = np.zeros(len(names))
        full[free] = x
        return np.sqrt(weights) * distances_of(kind, shape, cloud.points, full)

    best = least_squares(rows, np.zeros(len(free)), method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15, x_scale=0.01)
    sigma = np.sqrt(np.diag(shape.covariance))
    assert (np.abs(best.x) < 0.002 * sigma).all(), best.x / sigma
    variance = 2 * best.cost / (len(made) - len(free))
    expected = np.linalg.inv(best.jac.T @ best.jac) * variance
    np.testing.assert_allclose(shape.covariance, expected, atol=1e-3 * np.abs(expected).max(), rtol=1e-3)
    assert shape.rms == pytest.approx(np.sqrt(2 * best.cost / weights.sum()), rel=1e-6)
    assert shape.support == len(made) and shape.reliable, shape


def test_points_of_no_weight_and_those_that_are_not_finite_are_left_out(device, rng):
    made, center, _ = made_shape("sphere", 800, rng, 0.002)
    wild = np.vstack([made, rng.random((400, 3)) * 3, [[np.nan] * 3]])
    weights = np.where(np.arange(len(wild)) < 800, 7.0, 0.0)
    weighted = loom.fit_shape(loom.PointCloud(wild, device=device), "sphere", weights=weights)
    unweighted = loom.fit_shape(loom.PointCloud(made, device=device), "sphere")
    assert weighted.support == 800 and weighted.radius == pytest.approx(unweighted.radius, abs=1e-7)
    np.testing.assert_allclose(weighted.covariance, unweighted.covariance, rtol=1e-4, atol=1e-12)
    np.testing.assert_allclose(weighted.center, center, atol=5 * 0.002 / 20)


def test_initial_shape_gives_the_same_reproducible_result(device, rng):
    made, _, _ = made_shape("torus", 1500, rng, 0.004)
    cloud = loom.PointCloud(made + UTM, device=device)
    first, second = loom.fit_shape(cloud, "torus"), loom.fit_shape(cloud, "torus")
    assert str(first) == str(second) and first.to_dict() == second.to_dict()
    again = loom.fit_shape(cloud, "torus", start=first)
    np.testing.assert_allclose([again.radius, again.minor_radius], [first.radius, first.minor_radius], atol=1e-8)


def test_points_of_another_kind_are_reported(device):
    rng = np.random.default_rng(5)
    made, _, _ = made_shape("cone", 1500, rng, 0.002)
    shape = loom.fit_shape(loom.PointCloud(made, device=device), "cylinder")
    assert any(reason.startswith("other kind: a cone fits better") for reason in shape.warnings), shape


def test_points_on_a_line_have_no_plane_and_many_spheres(device, rng):
    line = loom.PointCloud(np.outer(rng.random(40), [1, 2, 3]), device=device)
    with pytest.raises(ValueError, match=r"^cloud:"):
        loom.fit_shape(line, "plane")
    assert "is not unique" in loom.fit_shape(line, "sphere").warnings[0]
