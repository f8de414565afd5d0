"""Plane segmentation: as good as Open3D on real scans, exact far from the origin, and reproducible."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

from .open3d_clouds import cloud_of

LIMITS = {"ransac_n": 3, "num_iterations": 1000, "probability": 1.0}


def degrees_between(a, b):
    return np.degrees(np.arccos(min(1.0, abs(a @ b) / np.linalg.norm(a) / np.linalg.norm(b))))


def open3d_plane(o3d, points, threshold, **limits):
    o3d.utility.random.seed(0)
    model, inliers = cloud_of(o3d, points).segment_plane(threshold, **limits)
    return np.asarray(model), np.asarray(inliers)


def cluttered(rng, count=4000, plane_fraction=0.5, noise=0.003, normal=(0.3, -0.2, 1.0), offset=0.4):
    """A noisy plane in a unit cube with uniform clutter; the model and the mask of its points."""
    normal = np.array(normal) / np.linalg.norm(normal)
    points = rng.random((count, 3)) - 0.5
    member = rng.random(count) < plane_fraction
    height = points @ normal - offset
    flat = points - height[:, None] * normal + noise * rng.normal(size=(count, 1)) * normal
    return np.where(member[:, None], flat, points), np.append(normal, -offset), member


@pytest.fixture(scope="module")
def terrain(scan_file):
    return loom.read_point_cloud(scan_file("lidar-pcl-terrain/samp31-utm.pcd")).points


@pytest.fixture(scope="module")
def scans(fragment, lidar, terrain):
    """Points by name, the tile centered, and a threshold for each."""
    return {
        "fragment": (fragment.points[::4], 0.02),
        "lidar": (lidar[:, :3].astype(float), 0.1),
        "terrain": (terrain - np.round(np.median(terrain, axis=0)), 0.5),
    }


@pytest.mark.parametrize("scan", ["fragment", "lidar", "terrain"])
def test_plane_of_a_real_scan_is_as_good_as_open3ds(device, scan, scans, o3d, tolerances):
    points, threshold = scans[scan]
    model, inliers = loom.PointCloud(points, device=device).segment_plane(threshold, **LIMITS)
    expected, their_inliers = open3d_plane(o3d, points, threshold, **LIMITS)
    assert len(inliers) > tolerances.plane_inliers * len(their_inliers)
    assert degrees_between(model[:3], expected[:3]) < tolerances.plane_degrees
    shared = np.intersect1d(inliers, their_inliers).size / np.union1d(inliers, their_inliers).size
    assert shared > tolerances.plane_overlap


def open3d_fit(o3d, points):
    return open3d_plane(o3d, points, 1e6, ransac_n=3, num_iterations=1)[0]


def test_final_plane_of_made_inliers_is_open3ds_fit(device, rng, oracle, tolerances):
    points, _, member = cluttered(rng, 1000)
    points = points[member].astype(np.float32).astype(float)
    expected = oracle("pcd/planes/fit", open3d_fit, points)
    model, inliers = loom.PointCloud(points, device=device).segment_plane(1.0)
    assert len(inliers) == len(points)
    assert degrees_between(model[:3], expected[:3]) < tolerances.plane_fit_degrees


@pytest.mark.parametrize(("normal", "ransac_n"), [((0, 0, 1), 5), ((1, 0, 0), 3), ((0.3, -0.2, 1), 3), ((-2, 1, 1), 5)])
def test_known_plane_is_detected_among_noise_and_clutter(device, rng, normal, ransac_n):
    points, true, member = cluttered(rng, normal=normal, offset=0.1)
    model, inliers = loom.PointCloud(points, device=device).segment_plane(0.01, ransac_n, 1000)
    assert degrees_between(model[:3], true[:3]) < 0.1
    assert np.isin(np.flatnonzero(member), inliers).mean() > 0.99
    assert (np.abs(points[inliers] @ model[:3] + model[3]) < 0.012).all(), (
        "of the plane before the fit, so a little beyond"
    )


def test_inliers_ascend_and_the_normal_is_unit_with_its_largest_component_positive(device, rng, tolerances):
    for normal in rng.normal(size=(6, 3)):
        points, _, _ = cluttered(rng, 600, normal=normal, offset=0.0)
        model, inliers = loom.PointCloud(points, device=device).segment_plane(0.02)
        assert model.dtype == np.float64 and inliers.dtype == np.int32
        assert (np.diff(inliers) > 0).all()
        assert abs(np.linalg.norm(model[:3]) - 1) < tolerances.plane_unit
        assert model[np.argmax(np.abs(model[:3]))] > 0


def test_all_points_of_an_exact_plane_are_inliers(device, rng):
    points = np.column_stack([rng.random((1037, 2)), np.full(1037, 2.5)])
    model, inliers = loom.PointCloud(points, device=device).segment_plane(1e-6)
    assert inliers.tolist() == list(range(1037))
    np.testing.assert_allclose(model, [0, 0, 1, -2.5], atol=1e-12)


def test_three_points_have_their_plane(device):
    model, inliers = loom.PointCloud([[1, 0, 0], [0, 1, 0], [0, 0, 1]], device=device).segment_plane(0.01)
    np.testing.assert_allclose(model, [3**-0.5] * 3 + [-(3**-0.5)], atol=1e-7)
    assert inliers.tolist() == [0, 1, 2]


def test_the_seed_chooses_the_samples(device, rng):
    cloud = loom.PointCloud(rng.random((500, 3)), device=device)
    models = [cloud.segment_plane(0.05, num_iterations=5, seed=seed)[0].tolist() for seed in (0, 0, 1, 2**31 - 1)]
    assert models[0] == models[1] and len({tuple(m) for m in models}) == 3


def test_a_probability_ends_the_search_after_a_batch_and_one_never(device, rng):
    """Half of the points are in the plane: 11 samples contain an all-inlier sample with a probability of 0.9."""
    points, _, _ = cluttered(rng, 3000, plane_fraction=0.6, noise=0.006)
    cloud = loom.PointCloud(points, device=device)
    limits = ((3000, 0.9), (32, 1.0), (3000, 1.0))
    early, batch, all_samples = (len(cloud.segment_plane(0.01, 3, *each)[1]) for each in limits)
    assert early == batch < all_samples


def faces(rng, sizes=(900, 600, 300)):
    """Faces of a box at x, y or z = 0 with a little noise, the face of each point."""
    parts = []
    for axis, size in enumerate(sizes):
        part = rng.uniform(0.1, 1, (size, 3))
        part[:, axis] = 0.002 * rng.normal(size=size)
        parts.append(part)
    return np.vstack(parts), np.repeat(np.arange(len(sizes)), sizes)


def test_planes_are_segmented_successively_from_the_remaining_points(device, rng):
    points, face = faces(rng)
    order = rng.permutation(len(points))
    labels, models = loom.PointCloud(points[order], device=device).segment_planes(0.01, min_points=100)
    assert labels.dtype == np.int32 and models.shape == (3, 4)
    assert (labels == face[order]).mean() > 0.995
    for axis, model in enumerate(models):
        np.testing.assert_allclose(model, np.append(np.eye(3)[axis], 0), atol=2e-3)


def test_first_of_several_planes_is_the_single_plane(device, rng):
    points, _, _ = cluttered(rng, 2000)
    cloud = loom.PointCloud(points, device=device)
    model, inliers = cloud.segment_plane(0.01)
    labels, models = cloud.segment_planes(0.01, max_planes=1)
    np.testing.assert_array_equal(models[0], model)
    np.testing.assert_array_equal(np.flatnonzero(labels == 0), inliers)
    assert set(labels.tolist()) == {-1, 0}


def test_limits_end_the_search_for_planes(device, rng):
    points, _ = faces(rng)
    points[5] = np.nan
    cloud = loom.PointCloud(points, device=device)
    assert len(cloud.segment_planes(0.01, min_points=500)[1]) == 2
    assert len(cloud.segment_planes(0.01, max_planes=1)[1]) == 1
    labels, models = cloud.segment_planes(0.01, min_points=5000)
    assert models.shape == (0, 4) and (labels == -1).all()
    assert cloud.segment_planes(0.01)[0][5] == -1


@pytest.mark.parametrize("count", [0, 1, 2])
def test_clouds_of_fewer_than_three_points_have_no_planes(device, count):
    cloud = loom.PointCloud(np.arange(3.0 * count).reshape(count, 3), device=device)
    labels, models = cloud.segment_planes(0.1, min_points=1)
    assert labels.tolist() == [-1] * count and models.shape == (0, 4)
    with pytest.raises(ValueError, match=f"ransac_n: expected at most the {count} finite points of the cloud, got 3"):
        cloud.segment_plane(0.1)


@pytest.mark.parametrize("points", [np.ones((50, 3)), np.outer(np.arange(50), [1, 2, -1])], ids=["equal", "line"])
def test_points_on_a_line_have_no_plane(device, points):
    """Open3D returns a plane of zeros with all points as inliers."""
    cloud = loom.PointCloud(points, device=device)
    for ransac_n in (3, 6):
        with pytest.raises(ValueError, match="no plane found"):
            cloud.segment_plane(0.01, ransac_n)
        assert cloud.segment_planes(0.01, ransac_n, min_points=1)[1].shape == (0, 4)


coordinates = st.one_of(st.integers(-3, 3).map(float), st.floats(-3, 3, width=32), st.just(np.nan))


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(rows=st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=3, max_size=40), seed=st.integers(0, 9))
def test_no_better_plane_exists_through_three_points_of_a_small_cloud(rows, seed):
    """Some thousand samples include nearly all triples of ten points: none has more inliers by brute force."""
    points = np.array(rows[:10])
    finite = points[np.isfinite(points).all(axis=1)]
    triples = [finite[list(t)] for t in np.ndindex(*[len(finite)] * 3) if t[0] < t[1] < t[2]]
    best = 0
    for p, q, r in triples:
        normal = np.cross(q - p, r - p)
        size = np.linalg.norm(normal)
        if size > 1e-3 * np.linalg.norm(q - p) * np.linalg.norm(r - p):  # thinner ones depend on rounding
            best = max(best, (np.abs((finite - p) @ normal) / size < 0.0999).sum())
    if best == 0:
        return
    model, inliers = loom.PointCloud(points).segment_plane(0.1, 3, 2000, 1.0, seed=seed)
    assert len(inliers) >= best
    assert abs(np.linalg.norm(model[:3]) - 1) < 1e-12 and np.isfinite(points[inliers]).all()
