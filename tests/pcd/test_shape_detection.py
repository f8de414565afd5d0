"""Shape detection in a synthetic hall, without false shapes, and fits of shapes with their covariance."""

import numpy as np
import pytest
from scipy.optimize import least_squares

import pointloom as loom

from ..products import few_quick
from .made_shapes import factory, made_shape, two_spheres

UTM = np.array([500_000.0, 5_400_000.0, 0.0])
SIZES = ("radius", "minor_radius", "half_angle")


def detect(points, device, noise, **options):
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    return loom.detect_shapes(cloud, max(0.004, 2.5 * noise), 25, min_support=500, **options)


@few_quick(1, ("noise", "clutter"), [(0.0, 0.2), (0.005, 0.5)])
def test_each_part_of_a_hall_is_detected_once_with_its_points_and_sizes(device, noise, clutter):
    points, labels, parts = factory(np.random.default_rng(1), noise, clutter)
    result = detect(points + UTM, device, noise)
    detected = []
    for k, shape in enumerate(result.shapes):
        in_shape = result.labels == k
        part = int(np.bincount(labels[in_shape] + 1).argmax()) - 1
        detected.append(part)
        assert shape.kind == parts[part][0] and shape.reliable, shape
        hits = (labels[in_shape] == part).sum()
        assert hits / in_shape.sum() > 0.93 and hits / (labels == part).sum() > 0.92, (shape, hits)
        sizes = [getattr(shape, name) for name in SIZES if np.isfinite(getattr(shape, name))]
        # noise across the axis enlarges a radius r by noise^2 / 2r, most at a cone's narrow end
        np.testing.assert_allclose(sizes, parts[part][1], atol=0.0005 + 0.3 * noise)
        assert shape.support == in_shape.sum()
        gaps = np.abs(shape.compute_distances(points[in_shape] + UTM))
        np.testing.assert_allclose(np.abs(result.distances[in_shape]), gaps, atol=1e-6)
    assert sorted(detected) == list(range(len(parts)))
    assert np.isnan(result.distances[result.labels < 0]).all()


@pytest.mark.slow
def test_same_seed_gives_the_same_shapes_and_progress_is_reported(device):
    points, _, parts = factory(np.random.default_rng(2), 0.005)
    events = []
    first = detect(points, device, 0.005, seed=3, progress=lambda *event: events.append(event))
    second = detect(points, device, 0.005, seed=3)
    np.testing.assert_array_equal(first.labels, second.labels)
    np.testing.assert_array_equal(first.distances, second.distances)
    assert str(first) == str(second) and first.to_dict() == second.to_dict()
    assert events[0] == ("shapes", 0, len(points)) and events[-1][1] == (first.labels >= 0).sum()
    assert len(events) == len(parts) + 1


def test_a_hall_of_planes_has_no_round_shape_that_is_sure(device, rng):
    floor, wall = (made_shape("plane", 3000, rng, 0.004, motion=False)[0] for _ in range(2))
    cloud = loom.PointCloud(np.vstack([floor, wall[:, [2, 0, 1]]]), device=device).estimate_normals()
    planes = loom.detect_shapes(cloud, 0.01)
    assert [shape.kind for shape in planes.shapes] == ["plane", "plane"] and planes.reliable and not planes.undecided
    round_ones = loom.detect_shapes(cloud, 0.01, kinds=("sphere", "cylinder"), num_iterations=500, max_radius=3.0)
    assert not any(shape.reliable for shape in round_ones.shapes), round_ones
    assert not round_ones.reliable and round_ones.to_dict()["warnings"] == list(round_ones.warnings)
    assert all(
        f"shape {k} ({one.kind}): {one.warnings[0]}" in round_ones.warnings for k, one in enumerate(round_ones.shapes)
    )


def test_too_few_samples_are_reported(device, rng):
    floor = made_shape("plane", 3000, rng, 0.004, motion=False)[0]
    cloud = loom.PointCloud(np.vstack([floor, floor.max() * rng.random((3000, 3))]), device=device).estimate_normals()
    result = loom.detect_shapes(cloud, 0.01, kinds=("plane", "sphere"), num_iterations=20)
    assert result.undecided == ("plane", "sphere") and not result.reliable
    assert "shapes may be missed (plane, sphere): use more num_iterations" in result.warnings[0]
    assert "shapes may be missed" in str(result)
    assert not loom.detect_shapes(cloud, 0.01, kinds=("plane", "sphere")).undecided


@pytest.mark.parametrize(
    ("options", "radii"), [({}, [0.3, 0.8]), ({"min_radius": 0.5}, [0.8]), ({"max_radius": 0.5}, [0.3])]
)
def test_all_spheres_within_the_radii_are_detected(device, options, radii):
    result = loom.detect_shapes(two_spheres().to(device), 0.01, kinds="sphere", cluster_epsilon=0.3, **options)
    assert [shape.radius for shape in result.shapes] == pytest.approx(radii, abs=1e-3)


@pytest.mark.parametrize("probability", [0.01, 0.999999])
def test_kinds_are_undecided_below_the_required_probability(device, rng, probability):
    cloud = loom.PointCloud(rng.random((3000, 3)), normals=rng.normal(size=(3000, 3)), device=device)
    limits = {"kinds": "sphere", "min_support": 1000, "num_iterations": 20}
    result = loom.detect_shapes(cloud, 0.01, probability=probability, **limits)
    assert not result.shapes and result.undecided == (("sphere",) if probability > 0.5 else ())


def test_separate_regions_are_two_shapes(device, rng):
    half = np.column_stack([rng.random((2000, 2)), 0.001 * rng.normal(size=2000)])
    cloud = loom.PointCloud(np.vstack([half, half + np.array([3, 0, 0])]), device=device).estimate_normals()
    result = loom.detect_shapes(cloud, 0.01, kinds="plane")
    assert [shape.support for shape in result.shapes] == [2000, 2000]
    assert set(result.labels[:2000]) != set(result.labels[2000:])
    joined = loom.detect_shapes(cloud, 0.01, kinds="plane", cluster_epsilon=3.0)
    assert len(joined.shapes) == 1
    assert len(loom.detect_shapes(cloud, 0.01, kinds="plane", max_shapes=1).shapes) == 1


def box_on_a_sparse_floor(rng, device):
    """A box without a bottom on a floor with a thirtieth of the points per area, and the number on the floor."""
    box = loom.TriangleMesh.create_box(0.4, 0.3, 0.2).sample_points_uniformly(16_000, seed=1).points
    floor = np.column_stack([rng.uniform(-1, 1, (4000, 2)), np.zeros(4000)])
    points = np.vstack([box[box[:, 2] > 1e-6], floor])
    return loom.PointCloud(points, device=device).estimate_normals(), len(floor)


def test_a_sparse_plane_beside_dense_ones_is_detected(device, rng):
    cloud, count = box_on_a_sparse_floor(rng, device)
    found = loom.detect_shapes(cloud, 0.005, kinds="plane")
    assert len(found.shapes) == 6 and max(shape.support for shape in found.shapes) > 0.95 * count
    twice = loom.detect_shapes(loom.PointCloud.concatenate([cloud, cloud]), 0.005, kinds="plane")
    assert len(twice.shapes) == 6 and max(shape.support for shape in twice.shapes) > 1.9 * count


def test_a_plane_of_points_beyond_the_given_step_hides_no_others_and_is_reported(device, rng):
    cloud, count = box_on_a_sparse_floor(rng, device)
    double = loom.PointCloud.concatenate([cloud, cloud])
    twice = loom.detect_shapes(double, 0.005, kinds="plane", cluster_epsilon=0.02)
    found = loom.detect_shapes(cloud, 0.005, kinds="plane", cluster_epsilon=0.02)
    assert len(found.shapes) == 5 and not found.reliable and found.labels.min() == -1
    (floor,) = found.sparse
    assert len(twice.shapes) == 5 and [row[:2] for row in twice.sparse] == [("plane", 2 * floor.points)]
    assert floor.kind == "plane" and floor.points > 0.95 * count and found.to_dict()["sparse"] == [list(floor)]
    assert f"{floor.points:,} points on a plane are no shape" in str(found.warnings)
    wider = loom.detect_shapes(cloud, 0.005, kinds="plane", cluster_epsilon=floor.step)
    assert len(wider.shapes) == 6 and not wider.sparse


def test_all_faces_of_a_box_are_detected(device):
    box = loom.TriangleMesh.create_box(0.4, 0.3, 0.2, device=device).sample_points_uniformly(6000, seed=1)
    result = loom.detect_shapes(box.estimate_normals(), 0.005, kinds="plane")
    assert len(result.shapes) == 6 and min(shape.support for shape in result.shapes) > 500


def test_clutter_alone_has_no_shape(device, rng):
    cloud = loom.PointCloud(rng.random((4000, 3)), device=device).estimate_normals()
    result = loom.detect_shapes(cloud, 0.01, num_iterations=5000)
    assert result.shapes == [] and (result.labels == -1).all()


def test_clouds_without_enough_points_have_no_shape(device):
    for points in (np.zeros((0, 3)), np.full((500, 3), np.nan), np.ones((500, 3)), np.eye(3)):
        normals = np.tile([0.0, 0.0, 1.0], (len(points), 1))
        result = loom.detect_shapes(loom.PointCloud(points, normals=normals, device=device), 0.01)
        assert result.shapes == [] and result.labels.tolist() == [-1] * len(points)


FAR = np.array([500_000.0, 5_400_000.0, 300.0])
EXTENTS = {"plane": (), "sphere": ("radius",), "cylinder": ("radius",), "cone": ("half_angle",)}
EXTENTS["torus"] = ("radius", "minor_radius")


def distances_of(kind, shape, points, x):
    """Distances of points from a shape that is moved, tilted and resized by x: an independent reference."""
    frame = shape.frame
    sizes = [getattr(shape, name) + change for name, change in zip(EXTENTS[kind], x[5:], strict=True)]
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


@pytest.mark.parametrize("kind", EXTENTS)
def test_a_fit_is_scipy_s_and_so_is_its_covariance(device, kind):
    rng = np.random.default_rng(3)
    made, _, _ = made_shape(kind, 1500, rng, 0.004, arc=0.6)
    weights = 0.2 + rng.random(len(made))
    cloud = loom.PointCloud(made + FAR, device=device)
    shape = loom.fit_shape(cloud, kind, weights=weights)
    names = ["shift_u", "shift_v", "shift_axis", "tilt_u", "tilt_v", *EXTENTS[kind]]
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
    cloud = loom.PointCloud(made + FAR, device=device)
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
