"""ISS keypoints: Open3D's on real scans, and defined where Open3D's depend on rounding."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom

from ..scan_cases import on_sets
from .any_cloud import examples
from .open3d_clouds import cloud_of

RADII = {"fragment": (0.06, 0.04), "lidar": (1.0, 0.7), "terrain": (6.0, 4.0)}


@pytest.fixture(scope="module")
def scans(fragment, lidar, scan_file):
    """Real coordinates about their own origin, rounded to float32."""
    utm = loom.read_point_cloud(scan_file("lidar-pcl-terrain/samp11-utm.pcd")).points
    clouds = {
        "fragment": fragment.points[::3],
        "lidar": lidar[:, :3],
        "terrain": utm - np.round(np.median(utm, axis=0)),
    }
    return {name: np.float32(points).astype(float) for name, points in clouds.items()}


@pytest.fixture(scope="module")
def keypoints_of(scans, o3d):
    """A function that returns Open3D's keypoints of a scan as indices."""

    def compute(name, **arguments):
        keypoints = o3d.geometry.keypoint.compute_iss_keypoints(cloud_of(o3d, scans[name]), **arguments)
        row_of = {tuple(p): i for i, p in enumerate(scans[name])}
        return sorted(row_of[tuple(p)] for p in np.asarray(keypoints.points))

    return compute


def saliencies(points, rows, radius, gamma_21=0.975, gamma_32=0.975, min_neighbors=5):
    """The smallest eigenvalue of each neighborhood in float64; 0 if the three are not different enough."""
    from scipy.spatial import cKDTree

    tree, result = cKDTree(points), np.zeros(len(rows))
    for at, row in enumerate(rows):
        near = np.array(tree.query_ball_point(points[row], radius))
        near = near[((points[near] - points[row]) ** 2).sum(axis=1) < radius**2]
        if len(near) >= min_neighbors:
            low, middle, high = np.linalg.eigvalsh(np.cov(points[near].T, bias=True))
            if low > 1e-12 * radius**2 and middle < gamma_21 * high and low < gamma_32 * middle:
                result[at] = low
    return result


def assert_same_but_for_ties(points, actual, expected, radii, **limits):
    """Check for all keypoints of Open3D and a few equally salient ones, between which its rounding decides.

    Some keypoints of Open3D have a planar neighborhood, a few points of one LiDAR ring, whose smallest eigenvalue
    is a rounding error: they are not keypoints.
    """
    from scipy.spatial import cKDTree

    missed = sorted(set(expected) - set(actual))
    assert not saliencies(points, missed, radii[0], **limits).any()
    assert len(missed) <= 0.05 * len(expected)
    extra = sorted(set(actual) - set(expected))
    assert len(extra) <= 0.01 * len(expected)
    tree = cKDTree(points)
    for row in extra:
        near = tree.query_ball_point(points[row], radii[1])
        values = saliencies(points, [row, *near], radii[0], **limits)
        assert 0 < values[0] >= values.max() - 1e-14 * radii[0] ** 2


@on_sets("scan", shipped=["lidar"], real=RADII)
@pytest.mark.parametrize("given", ["defaults", "radii"])
def test_keypoints_of_real_scans_are_open3ds(device, scan, given, scans, keypoints_of):
    """If points have the same neighbors, rounding in Open3D selects one; here all are selected."""
    points, radii = scans[scan], RADII[scan]
    arguments = dict(zip(("salient_radius", "non_max_radius"), radii, strict=True)) if given == "radii" else {}
    cloud = loom.PointCloud(points, device=device)
    keypoints, indices = loom.compute_iss_keypoints(cloud, return_indices=True, **arguments)
    expected = keypoints_of(scan, **arguments)
    np.testing.assert_array_equal(keypoints.points, points[indices])
    assert (np.diff(indices) > 0).all() and len(expected) > 100
    if given == "defaults":
        spacing = cloud.compute_nearest_neighbor_distance().mean()
        radii = (6 * spacing, 4 * spacing)
    assert_same_but_for_ties(points, indices, expected, radii)


def test_gammas_and_counts_are_open3ds(device, scans, keypoints_of):
    limits = {"gamma_21": 0.6, "gamma_32": 0.3, "min_neighbors": 12}
    cloud = loom.PointCloud(scans["terrain"], device=device)
    indices = loom.compute_iss_keypoints(cloud, 6.0, 3.0, **limits, return_indices=True)[1]
    expected = keypoints_of("terrain", salient_radius=6.0, non_max_radius=3.0, **limits)
    assert_same_but_for_ties(scans["terrain"], indices, expected, (6.0, 3.0), **limits)
    assert 0 < len(indices) < len(loom.compute_iss_keypoints(cloud, 6.0, 3.0))


@pytest.mark.parametrize("radii", [(0.0, 1.0), (1.0, 0.0)], ids=str)
def test_one_radius_alone_is_replaced_too_as_in_open3d(device, radii, scans):
    cloud = loom.PointCloud(scans["lidar"], device=device)
    result = loom.compute_iss_keypoints(cloud, *radii, return_indices=True)[1]
    assert result.tolist() == loom.compute_iss_keypoints(cloud, return_indices=True)[1].tolist()


@examples(15)
@given(seed=st.integers(0, 2**32 - 1), count=st.integers(0, 80), min_neighbors=st.integers(1, 8))
def test_keypoints_follow_their_definition(device, seed, count, min_neighbors):
    """Random points, lattice points, duplicates and NaN against float64 NumPy; lattices tie."""
    rng = np.random.default_rng(seed)
    points = np.where(rng.random((count, 1)) < 0.6, rng.random((count, 3)), rng.integers(0, 4, (count, 3)) / 4)
    points = np.float32(points).astype(float)
    points[rng.random(count) < 0.1, 0] = np.nan
    cloud = loom.PointCloud(points, device=device)
    options = {"gamma_21": 0.9, "gamma_32": 0.9, "min_neighbors": min_neighbors, "return_indices": True}
    result = loom.compute_iss_keypoints(cloud, 0.33, 0.23, **options)[1]
    good = np.flatnonzero(np.isfinite(points).all(axis=1))
    finite_points = points[good]
    limits = (0.33, 0.9, 0.9, min_neighbors)
    values = saliencies(finite_points, range(len(good)), *limits) if len(good) else np.zeros(0)
    expected = []
    for at, p in enumerate(finite_points):
        near = ((finite_points - p) ** 2).sum(axis=1) < 0.23**2
        if values[at] > 0 and near.sum() >= min_neighbors and values[at] >= values[near].max() - 1e-15:
            expected.append(good[at])
    assert result.tolist() == expected


def test_clouds_that_do_not_vary_have_no_keypoints(device, rng):
    """Open3D detects some on exact planes and lines, where the smallest eigenvalue is a rounding error."""
    plane = np.column_stack([rng.random((500, 2)), np.zeros(500)])
    line = np.outer(rng.random(100), [1.0, 2, 3])
    roof = np.column_stack([plane[:, :2], 0.3 * plane[:, 0] - 0.7 * plane[:, 1]])  # rounded to float32, as stored
    few = [np.zeros((0, 3)), np.zeros((1, 3)), np.eye(3)[:2], np.ones((50, 3)), np.full((9, 3), np.nan)]
    for points in (*few, plane, roof, np.outer(np.arange(64), [1.0, 2, 4]), line * [1, 0, 0]):
        for radii in ((), (0.3, 0.2), (1e30, 1e30), (1e-30, 1e-30)):
            cloud = loom.PointCloud(points, device=device)
            keypoints, indices = loom.compute_iss_keypoints(cloud, *radii, return_indices=True)
            assert len(keypoints) == len(indices) == 0


def open3d_keypoints(o3d, points):
    cloud = cloud_of(o3d, points)
    return np.asarray(o3d.geometry.keypoint.compute_iss_keypoints(cloud, 0.15, 0.1).points)


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e9])
def test_keypoints_are_open3ds_and_do_not_depend_on_scale(device, scale, rng, oracle):
    """Open3D detects none in a small cloud: it treats covariances below 1e-12 m^2 as zero."""
    points = np.float32(rng.random((2000, 3)) * [1, 1, 0.2]).astype(float)
    factor = 2.0 ** np.round(np.log2(scale))  # exact in float32
    cloud = loom.PointCloud(points * factor, device=device, origin=np.zeros(3))
    result = loom.compute_iss_keypoints(cloud, 0.15 * factor, 0.1 * factor, return_indices=True)[1]
    expected = oracle("pcd/keypoints/slab", open3d_keypoints, points)
    assert sorted(map(tuple, points[result])) == sorted(map(tuple, expected))


def test_attributes_stay_with_their_keypoints(device, rng):
    points = rng.random((1000, 3))
    cloud = loom.PointCloud(points, normals=points, colors=points, label=np.arange(1000), device=device)
    keypoints, indices = loom.compute_iss_keypoints(cloud, 0.2, 0.2, return_indices=True)
    assert 0 < len(indices) < 100 and keypoints["label"].tolist() == indices.tolist()
    np.testing.assert_array_equal(keypoints.normals, cloud.normals[indices])
    np.testing.assert_array_equal(keypoints.colors, cloud.colors[indices])
    assert len(cloud) == 1000 and len(loom.compute_iss_keypoints(cloud, 0.2, 0.2)) == len(indices)
