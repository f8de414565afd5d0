"""Round shapes: detected among clutter, exact far from the origin, sizes with standard deviations, and warnings."""

import numpy as np
import pytest

import pointloom as loom

from ..products import few_quick
from .made_shapes import SIZES, made_shape, two_spheres

ROUND = ["sphere", "cylinder", "cone", "torus"]


def sizes_of(shape):
    of = {"cone": ("half_angle",), "torus": ("radius", "minor_radius")}.get(shape.kind, ("radius",))
    return np.array([getattr(shape, name) for name in of])


def sigma_of(shape):
    return np.array([shape.sigma[n] for n in ("radius", "minor_radius", "half_angle") if n in shape.sigma])


def scene(kind, rng, count=3000, clutter=1500, noise=0.0, **options):
    """Points of a shape, then clutter in a box of two meters around it."""
    points, center, axis = made_shape(kind, count, rng, noise, **options)
    return np.vstack([points, center + 2 * rng.random((clutter, 3)) - 1]), center, axis


SCENES = [("sphere", 0.02), ("cylinder", 0.005), ("cylinder", 0.0), ("cone", 0.02), ("torus", 0.005), ("torus", 0.0)]


@pytest.mark.parametrize(("kind", "noise"), SCENES)
def test_shape_among_clutter_is_detected_with_its_sizes(device, rng, kind, noise):
    points, _, axis = scene(kind, rng, noise=noise)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    shape, inliers = cloud.segment_shape(kind, max(0.004, 2.5 * noise), 25)
    assert shape.reliable, shape.warnings
    assert (inliers < 3000).mean() > 0.95
    assert (inliers < 3000).sum() > (0.97 if noise < 0.02 else 0.7) * 3000
    np.testing.assert_allclose(sizes_of(shape), SIZES[kind], atol=0.002 + 0.3 * noise)
    if kind != "sphere":
        assert abs(shape.axis @ axis) > 1 - 1e-4 - noise * noise
    assert shape.support == len(inliers) and (np.diff(inliers) > 0).all()
    assert shape.coverage > 0.9


def cube(rng, count, size=(1.0, 1.0, 1.0)):
    points, axes = rng.uniform(-1, 1, (count, 3)), rng.integers(0, 3, count)
    points[np.arange(count), axes] = rng.choice([-1.0, 1.0], count)
    return points * size


@pytest.mark.parametrize("count", [4, 6, 8, 12, 30, 100])
def test_a_plane_of_points_in_space_is_not_reliable(device, rng, count):
    corners = np.stack(np.meshgrid(*3 * [[-1.0, 1.0]]), -1).reshape(-1, 3)
    for points in (corners, cube(rng, count), rng.random((count, 3)), rng.normal(size=(count, 3))):
        for repeats in (1, 5):
            assert not loom.fit_shape(loom.PointCloud(np.repeat(points, repeats, 0), device=device), "plane").reliable


@pytest.mark.parametrize("count", [5, 8, 30])
def test_a_plane_of_few_accurate_points_is_reliable(device, rng, count):
    for thickness in (0.0, 0.002):
        points = np.c_[rng.uniform(-1, 1, (count, 2)), thickness * rng.normal(size=count)]
        assert loom.fit_shape(loom.PointCloud(points, device=device), "plane").warnings == ()


@few_quick(1, "count", [200, 2000])
def test_a_round_shape_of_another_body_is_not_reliable(device, rng, count):
    for points in (
        cube(rng, count),
        cube(rng, count, (2, 1, 0.5)),
        rng.random((count, 3)),
        rng.normal(size=(count, 3)),
    ):
        for kind in ROUND:
            try:
                shape = loom.fit_shape(loom.PointCloud(points, device=device), kind)
            except ValueError:
                continue
            assert not shape.reliable, shape


@pytest.mark.parametrize("kind", ROUND)
def test_noise_and_low_weights_are_no_common_deviation(device, rng, kind):
    points, _, _ = made_shape(kind, 800, rng, 0.01)
    weights = np.where(np.arange(800) % 8 == 0, 1e-8, 1.0)
    points[::8] += 0.3 * rng.normal(size=(100, 3))
    cloud = loom.PointCloud(points, device=device).estimate_normals()
    start = loom.fit_shape(cloud.select_by_index(np.flatnonzero(weights == 1)), kind)
    assert start.warnings == ()
    assert loom.fit_shape(cloud, kind, start=start, weights=weights).warnings == ()


@pytest.mark.slow
@pytest.mark.parametrize("kind", ROUND)
def test_estimated_standard_deviations_match_the_errors(device, kind):
    """Thirty synthetic shapes: errors of the sizes divided by their standard deviations are about one."""
    ratios = []
    for seed in range(30):
        rng = np.random.default_rng(seed)
        points, _, _ = made_shape(kind, 400, rng, 0.004)
        cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=20)
        shape, _ = cloud.segment_shape(kind, 0.05, 60, probability=0.99)
        ratios.extend((sizes_of(shape) - SIZES[kind]) / sigma_of(shape))
    assert 0.6 < np.sqrt(np.mean(np.square(ratios))) < 1.5


@pytest.mark.parametrize("kind", ROUND)
def test_same_seed_is_reproducible_and_inliers_fit_the_shape(device, rng, kind):
    points = scene(kind, rng, 1500, 1037, 0.01)[0]
    cloud = loom.PointCloud(points, device=device).estimate_normals()
    (a, first), (b, second) = (cloud.segment_shape(kind, 0.02, 30, seed=7) for _ in range(2))
    np.testing.assert_array_equal(first, second)
    np.testing.assert_array_equal(a.covariance, b.covariance)
    near = np.abs(a.compute_distances(cloud.points)) < 0.02
    assert near[first].mean() > 0.999
    with_any = cloud.segment_shape(kind, 0.02, 90, seed=7)
    np.testing.assert_allclose(np.abs(with_any[0].compute_distances(cloud.points[with_any[1]])).max(), 0.02, atol=1e-3)


@pytest.mark.parametrize("kind", ROUND)
def test_of_many_points_a_part_is_fitted_first_and_all_of_them_last(device, rng, kind):
    points, _, _ = scene(kind, rng, 6400, 2600, 0.003)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    shape, inliers = cloud.segment_shape(kind, 0.01, 25)
    assert ((inliers < 6400).sum() > 0.97 * 6400) and shape.reliable and shape.support > 6200
    assert (np.abs(sizes_of(shape) - SIZES[kind]) < 4 * sigma_of(shape) + 2e-4).all()


def test_fit_respects_the_requested_radii(device, rng):
    points, _, _ = made_shape("plane", 2000, rng, 0.003)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=15)
    try:
        shape, _ = cloud.segment_shape("cylinder", 0.01, 30, num_iterations=3000, max_radius=0.8)
    except ValueError as error:
        assert "no cylinder found" in str(error)
    else:
        assert shape.radius <= 0.8


@pytest.mark.parametrize(("options", "radius"), [({}, 0.3), ({"min_radius": 0.5}, 0.8), ({"max_radius": 0.5}, 0.3)])
def test_the_largest_sphere_within_the_radii_is_detected(device, options, radius):
    cloud = two_spheres().to(device)
    shape, _ = cloud.segment_shape("sphere", 0.01, 25, **options)
    assert shape.radius == pytest.approx(radius, abs=1e-3)


def test_normals_deviate_by_at_most_the_requested_angle(device):
    """Each normal is 30 degrees off the radius of a sphere."""
    z = np.random.default_rng(0).uniform(-0.9, 0.9, (2, 2000))
    angle, height = np.pi * z[0] / 0.9, z[1]
    radial = np.stack([np.sqrt(1 - height**2) * np.cos(angle), np.sqrt(1 - height**2) * np.sin(angle), height], 1)
    around = np.stack([-np.sin(angle), np.cos(angle), 0 * angle], 1)
    normals = np.cos(np.pi / 6) * radial + np.sin(np.pi / 6) * around
    cloud = loom.PointCloud(radial, normals=normals, device=device)
    assert len(cloud.segment_shape("sphere", 0.01, 31)[1]) == 2000
    try:
        assert len(cloud.segment_shape("sphere", 0.01, 29)[1]) < 200
    except ValueError as error:
        assert "no sphere found" in str(error)


@pytest.mark.parametrize(("kind", "noise"), [("sphere", 0.0), ("cylinder", 0.005), ("cone", 0.005), ("torus", 0.0)])
def test_plane_is_no_round_shape_and_is_reported_as_flat(device, rng, kind, noise):
    points, _, _ = made_shape("plane", 3000, rng, noise)
    cloud = loom.PointCloud(points, device=device).estimate_normals()
    try:
        shape, _ = cloud.segment_shape(kind, 0.015, 25, num_iterations=2000)
    except ValueError as error:
        assert f"no {kind} found" in str(error)
    else:
        assert not shape.reliable


@pytest.mark.parametrize("kind", ROUND)
def test_clutter_alone_is_chance(device, rng, kind):
    cloud = loom.PointCloud(rng.random((3000, 3)), device=device).estimate_normals()
    shape, _ = cloud.segment_shape(kind, 0.01, 20, num_iterations=2000)
    assert any("chance" in reason or "do not say" in reason for reason in shape.warnings), shape


def test_a_small_arc_of_a_cylinder_leaves_its_radius_open(device, rng):
    points, _, _ = made_shape("cylinder", 400, rng, 0.004, arc=0.07)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=40)
    shape, _ = cloud.segment_shape("cylinder", 0.02, 40, max_radius=1.5)
    assert any("radius open" in reason or "flat" in reason for reason in shape.warnings), shape
    assert shape.coverage < 0.2


def test_cylinder_fitted_as_a_cone_leaves_its_half_angle_open(device, rng):
    points, _, _ = made_shape("cylinder", 2000, rng, 0.01)
    cloud = loom.PointCloud(points, device=device).estimate_normals()
    try:
        shape, _ = cloud.segment_shape("cone", 0.03, 40, num_iterations=3000)
    except ValueError as error:
        assert "no cone found" in str(error)
    else:
        assert any("half_angle open" in reason for reason in shape.warnings), shape


@pytest.mark.parametrize("kind", ROUND)
def test_bad_clouds_are_refused_by_name(device, kind):
    ones = np.ones((20, 3))
    bad = [(np.zeros((0, 3)), "0 finite points"), (np.full((20, 3), np.nan), "0 finite points")]
    for points, message in [*bad, (ones[:3], "3 finite points"), (ones, "are equal")]:
        normals = np.tile([0.0, 0.0, 1.0], (len(points), 1))
        with pytest.raises(ValueError, match=message):
            loom.PointCloud(points, normals=normals, device=device).segment_shape(kind)
    normals = np.tile([2.0, -1.0, 0.0], (50, 1))  # all equal: an estimate from points on a line depends on rounding
    line = loom.PointCloud(np.linspace(0, 1, 50)[:, None] * [1, 2, 3], normals=normals, device=device)
    with pytest.raises(ValueError, match=f"no {kind} found"):
        line.segment_shape(kind, 0.01, num_iterations=500)
    with pytest.raises(ValueError, match="no normals"):
        loom.PointCloud(ones, device=device).segment_shape(kind)


@pytest.mark.parametrize("kind", ROUND)
def test_mesh_of_a_shape_is_on_its_surface_and_faces_outward(device, rng, kind):
    points, _, _ = made_shape(kind, 1500, rng)
    shape, _ = loom.PointCloud(points, device=device).estimate_normals().segment_shape(kind, 0.005)
    vertices, triangles = shape.to_mesh(32)
    assert np.abs(shape.compute_distances(vertices)).max() < 1e-9
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    middles, sizes = corners.mean(axis=1), np.linalg.norm(normals, axis=1)
    full = sizes > 1e-9
    outward = shape.compute_distances(middles + 0.001 * normals / np.maximum(sizes, 1e-30)[:, None])
    assert (outward[full] > shape.compute_distances(middles)[full]).all()
    tree = loom.NearestNeighborSearch(loom.PointCloud(points))
    assert np.sqrt(tree.knn_search(vertices, 1)[1]).max() < 0.15


def test_a_bent_patch_is_too_small_a_part_of_a_round_shape_but_few_points_all_over_are_not(device):
    rng = np.random.default_rng(10)
    x, y = rng.random((2, 3000)) - 0.5
    saddle = np.column_stack([x, y, 0.4 * (x * x - y * y)]) + 0.003 * rng.normal(size=(3000, 3))
    cloud = loom.PointCloud(saddle, device=device).estimate_normals(max_nn=30)
    for kind in ("sphere", "cylinder"):
        shape, _ = cloud.segment_shape(kind, 0.012, 25, num_iterations=4000)
        assert shape.sigma["radius"] < 0.02 * shape.radius
        assert "small part" in [reason.split(":")[0] for reason in shape.warnings], shape
    few, center, _ = made_shape("sphere", 60, rng)
    ball = loom.PointCloud(few, normals=(few - center) / 0.5, device=device)
    shape, _ = ball.segment_shape("sphere", 0.012)
    assert shape.coverage < 0.15 and shape.reliable, shape
