"""ISS keypoints: Open3D's on real scans, and defined where Open3D's are rounding."""

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
    """Real coordinates about an origin of their own, as float32 holds them."""
    utm = loom.read_point_cloud(scan_file("lidar-pcl-terrain/samp11-utm.pcd")).points
    found = {"fragment": fragment.points[::3], "lidar": lidar[:, :3], "terrain": utm - np.round(np.median(utm, axis=0))}
    return {name: np.float32(points).astype(float) for name, points in found.items()}


@pytest.fixture(scope="module")
def keypoints_of(scans, o3d):
    """A function: Open3D's keypoints of a scan, as indices."""

    def compute(name, **arguments):
        found = o3d.geometry.keypoint.compute_iss_keypoints(cloud_of(o3d, scans[name]), **arguments)
        places = {tuple(p): i for i, p in enumerate(scans[name])}
        return sorted(places[tuple(p)] for p in np.asarray(found.points))

    return compute


def saliencies(points, rows, radius, gamma_21=0.975, gamma_32=0.975, min_neighbors=5):
    """The smallest eigenvalue of each neighborhood in float64, 0 where the three do not differ enough."""
    from scipy.spatial import cKDTree

    tree, found = cKDTree(points), np.zeros(len(rows))
    for at, row in enumerate(rows):
        near = np.array(tree.query_ball_point(points[row], radius))
        near = near[((points[near] - points[row]) ** 2).sum(axis=1) < radius**2]
        if len(near) >= min_neighbors:
            low, middle, high = np.linalg.eigvalsh(np.cov(points[near].T, bias=True))
            if low > 1e-12 * radius**2 and middle < gamma_21 * high and low < gamma_32 * middle:
                found[at] = low
    return found


def assert_same_but_for_ties(points, found, expected, radii, **limits):
    """All of Open3D's, and a few as salient as the most salient near them, between which its rounding decided.

    Some of Open3D's lie in a plane with all that is near, a few points of one ring of a LiDAR, where the smallest
    eigenvalue is its rounding: they are none.
    """
    from scipy.spatial import cKDTree

    missed = sorted(set(expected) - set(found))
    assert not saliencies(points, missed, radii[0], **limits).any()
    assert len(missed) <= 0.05 * len(expected)
    extra = sorted(set(found) - set(expected))
    assert len(extra) <= 0.01 * len(expected)
    tree = cKDTree(points)
    for row in extra:
        near = tree.query_ball_point(points[row], radii[1])
        values = saliencies(points, [row, *near], radii[0], **limits)
        assert 0 < values[0] >= values.max() - 1e-14 * radii[0] ** 2


def mean_spacing(points):
    from scipy.spatial import cKDTree

    return cKDTree(points).query(points, 2)[0][:, 1].mean()


@on_sets("scan", shipped=["lidar"], real=RADII)
@pytest.mark.parametrize("given", ["defaults", "radii"])
def test_keypoints_of_real_scans_are_open3ds(device, scan, given, scans, keypoints_of):
    """Where points have the same neighbors, rounding decides in Open3D which of them stays; here all stay."""
    points, radii = scans[scan], RADII[scan]
    arguments = dict(zip(("salient_radius", "non_max_radius"), radii, strict=True)) if given == "radii" else {}
    keypoints, indices = loom.compute_iss_keypoints(
        loom.PointCloud(points, device=device), return_indices=True, **arguments
    )
    expected = keypoints_of(scan, **arguments)
    np.testing.assert_array_equal(keypoints.points, points[indices])
    assert (np.diff(indices) > 0).all() and len(expected) > 100
    if given == "defaults":
        spacing = mean_spacing(points)
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
    found = loom.compute_iss_keypoints(cloud, *radii, return_indices=True)[1]
    assert found.tolist() == loom.compute_iss_keypoints(cloud, return_indices=True)[1].tolist()


@examples(15)
@given(seed=st.integers(0, 2**32 - 1), count=st.integers(0, 80), min_neighbors=st.integers(1, 8))
def test_keypoints_are_those_of_their_definition(device, seed, count, min_neighbors):
    """Random points, lattice points, duplicates and NaN against float64 NumPy; lattices tie."""
    rng = np.random.default_rng(seed)
    points = np.where(rng.random((count, 1)) < 0.6, rng.random((count, 3)), rng.integers(0, 4, (count, 3)) / 4)
    points = np.float32(points).astype(float)
    points[rng.random(count) < 0.1, 0] = np.nan
    cloud = loom.PointCloud(points, device=device)
    found = loom.compute_iss_keypoints(
        cloud, 0.33, 0.23, gamma_21=0.9, gamma_32=0.9, min_neighbors=min_neighbors, return_indices=True
    )[1]
    good = np.flatnonzero(np.isfinite(points).all(axis=1))
    held = points[good]
    values = saliencies(held, range(len(held)), 0.33, 0.9, 0.9, min_neighbors) if len(held) else np.zeros(0)
    expected = []
    for at, p in enumerate(held):
        near = ((held - p) ** 2).sum(axis=1) < 0.23**2
        if values[at] > 0 and near.sum() >= min_neighbors and values[at] >= values[near].max() - 1e-15:
            expected.append(good[at])
    assert found.tolist() == expected


def test_clouds_that_do_not_vary_have_no_keypoints(device, rng):
    """Open3D finds some on exact planes and lines, where the smallest eigenvalue is nothing but rounding."""
    plane = np.column_stack([rng.random((500, 2)), np.zeros(500)])
    line = np.outer(rng.random(100), [1.0, 2, 3])
    roof = np.column_stack([plane[:, :2], 0.3 * plane[:, 0] - 0.7 * plane[:, 1]])  # rounded to float32, as it is held
    few = [np.zeros((0, 3)), np.zeros((1, 3)), np.eye(3)[:2], np.ones((50, 3)), np.full((9, 3), np.nan)]
    for points in (*few, plane, roof, np.outer(np.arange(64), [1.0, 2, 4]), line * [1, 0, 0]):
        for radii in ((), (0.3, 0.2), (1e30, 1e30), (1e-30, 1e-30)):
            keypoints, indices = loom.compute_iss_keypoints(
                loom.PointCloud(points, device=device), *radii, return_indices=True
            )
            assert len(keypoints) == len(indices) == 0


def open3d_keypoints(o3d, points):
    cloud = cloud_of(o3d, points)
    return np.asarray(o3d.geometry.keypoint.compute_iss_keypoints(cloud, 0.15, 0.1).points)


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e9])
def test_keypoints_are_open3ds_and_do_not_depend_on_scale(device, scale, rng, oracle):
    """Open3D finds none in a small cloud: it takes covariances below 1e-12 m^2 for zero."""
    points = np.float32(rng.random((2000, 3)) * [1, 1, 0.2]).astype(float)
    factor = 2.0 ** np.round(np.log2(scale))  # exact in float32
    cloud = loom.PointCloud(points * factor, device=device, origin=np.zeros(3))
    found = loom.compute_iss_keypoints(cloud, 0.15 * factor, 0.1 * factor, return_indices=True)[1]
    expected = oracle("pcd/keypoints/slab", open3d_keypoints, points)
    assert sorted(map(tuple, points[found])) == sorted(map(tuple, expected))


def test_attributes_stay_with_their_keypoints(device, rng):
    points = rng.random((1000, 3))
    cloud = loom.PointCloud(points, normals=points, colors=points, label=np.arange(1000), device=device)
    keypoints, indices = loom.compute_iss_keypoints(cloud, 0.2, 0.2, return_indices=True)
    assert 0 < len(indices) < 100 and keypoints["label"].tolist() == indices.tolist()
    np.testing.assert_array_equal(keypoints.normals, cloud.normals[indices])
    np.testing.assert_array_equal(keypoints.colors, cloud.colors[indices])
    assert len(cloud) == 1000 and len(loom.compute_iss_keypoints(cloud, 0.2, 0.2)) == len(indices)
