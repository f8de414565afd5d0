"""Normals: against Open3D on real scans, exact far from the origin, and defined in every degenerate neighbourhood."""

from __future__ import annotations

import struct

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

SEARCHES = {
    "hybrid": {"radius": 0.1, "max_nn": 30},
    "count": {"max_nn": 30},
    "radius": {"radius": 0.03, "max_nn": None},
}


def oracle_normals(cloud, search):
    import open3d as o3d

    radius, max_nn = search.get("radius"), search.get("max_nn")
    if radius is None:
        parameter = o3d.geometry.KDTreeSearchParamKNN(max_nn)
    elif max_nn is None:
        parameter = o3d.geometry.KDTreeSearchParamRadius(radius)
    else:
        parameter = o3d.geometry.KDTreeSearchParamHybrid(radius, max_nn)
    cloud.normals = o3d.utility.Vector3dVector()
    cloud.estimate_normals(parameter)
    return np.asarray(cloud.normals)


def assert_agree(found, expected, tolerances):
    """In direction and side."""
    share = ((found * expected).sum(axis=1) > tolerances.normal_dot).mean()
    assert share >= tolerances.normal_share, f"{share:.5f} of the normals agree"
    np.testing.assert_allclose(np.linalg.norm(found, axis=1), 1, atol=tolerances.unit_length)


@pytest.fixture(scope="module")
def fragment_normals(fragment, to_open3d):
    """Open3D's normals of the fragment, by search."""
    return {name: oracle_normals(to_open3d(fragment.points), search) for name, search in SEARCHES.items()}


@pytest.mark.parametrize("search", SEARCHES)
def test_normals_of_the_fragment_are_open3ds(device, search, fragment, fragment_normals, tolerances):
    found = loom.PointCloud(fragment.points, device=device).estimate_normals(**SEARCHES[search]).normals
    assert_agree(found, fragment_normals[search], tolerances)


@pytest.mark.parametrize("search", [{"max_nn": 20}, {"radius": 1.0, "max_nn": 30}], ids=str)
def test_normals_of_a_lidar_frame_are_open3ds(device, search, lidar, to_open3d, tolerances):
    """But for neighbourhoods along one beam or of too few points, where no plane is better than another."""
    cloud = loom.PointCloud(lidar[:, :3], device=device)
    found = cloud.estimate_normals(**search).normals
    expected = oracle_normals(to_open3d(cloud.points), search)
    shapes = loom.compute_eigen_features(cloud, radius=search.get("radius"), max_nn=search["max_nn"])
    middle, low = shapes["eigenvalues"][:, 1], shapes["eigenvalues"][:, 2]
    plain = (middle > 1e-5) & (low < 0.9 * middle)
    assert plain.mean() > 0.75
    assert_agree(found[plain], expected[plain], tolerances)


def test_normals_of_a_depth_frame_lie_on_open3ds_side(device, rng, to_open3d, tolerances):
    """Noise as of a camera, so that no two neighbours are equally far, of which Open3D takes some."""
    v, u = np.mgrid[:90, :120]
    depth = np.minimum(2.0 + 0.01 * u, 1.4 + 0.02 * v) + 0.3 * np.sin(u / 9) * np.cos(v / 7)  # two walls, a relief
    depth = (depth + rng.normal(0, 2e-3, depth.shape)).astype(np.float32)
    camera = loom.PinholeCameraIntrinsic(120, 90, 105.0, 105.0, 59.5, 44.5)
    cloud = loom.PointCloud.from_depth_image(depth, camera, device=device)
    found = cloud.estimate_normals(max_nn=30).normals
    assert_agree(found, oracle_normals(to_open3d(cloud.points), {"max_nn": 30}), tolerances)


lattice = st.lists(st.tuples(*[st.integers(-3, 3)] * 3), min_size=1, max_size=40)


@settings(max_examples=40, deadline=None)
@given(points=lattice, k=st.integers(1, 45), scale=st.sampled_from([1.0, 1e-3, 1e3]))
def test_no_direction_is_thinner_than_the_normal(points, k, scale):
    """The spread along the normal is the least of all directions, whatever the neighbours are."""
    cloud = loom.PointCloud(np.array(points, float) * scale)
    found = cloud.estimate_normals(max_nn=k).normals.astype(float)
    held = cloud.points
    indices, sqdists, counts = loom.NearestNeighborSearch(cloud).knn_search(cloud, k + 1)
    for row in range(len(points)):
        if counts[row] > k and sqdists[row, k - 1] == sqdists[row, k]:
            continue  # which of the tied neighbours counts is not promised
        near = held[indices[row, : min(k, counts[row])]]
        if len(near) < 3:
            assert found[row].tolist() == [0, 0, 1]
            continue
        covariance = np.cov(near.T, bias=True)
        least, size = np.linalg.eigvalsh(covariance)[[0, 2]]
        assert found[row] @ covariance @ found[row] <= least + 1e-6 * size


@pytest.fixture(scope="module")
def utm_scan(shipped_file):
    """The coordinates of an airborne scan, about 4.9e5 and 4.9e6, as numbers."""
    las = shipped_file("lidar-pdal/autzen/autzen-utm.las").read_bytes()
    start, length = struct.unpack_from("<I", las, 96)[0], struct.unpack_from("<H", las, 105)[0]
    count, scale, offset = (struct.unpack_from("<I", las, 107)[0], *np.frombuffer(las, "<f8", 6, 131).reshape(2, 3))
    rows = np.frombuffer(las, np.dtype({"names": ["xyz"], "formats": ["<3i4"], "itemsize": length}), count, start)
    return rows["xyz"] * scale + offset


@pytest.mark.parametrize("search", [{"radius": 85.0, "max_nn": 30}, {"radius": 85.0, "max_nn": None}], ids=str)
def test_normals_at_utm_coordinates_are_as_exact_as_at_the_origin(device, search, utm_scan, to_open3d, tolerances):
    assert np.abs(utm_scan).max() > 4e6
    found = loom.PointCloud(utm_scan, device=device).estimate_normals(**search).normals
    moved = utm_scan - utm_scan.mean(axis=0)
    expected = oracle_normals(to_open3d(moved), search)
    assert_agree(found, expected, tolerances)
    at_origin = loom.PointCloud(moved, device=device).estimate_normals(**search).normals
    assert_agree(at_origin, found, tolerances)


def wavy(rng, count=1500):
    xy = rng.random((count, 2)) * 2
    return np.column_stack([xy, 0.1 * np.sin(5 * xy[:, 0]) + 0.01 * rng.normal(size=count)])


@pytest.mark.parametrize("search", [{"max_nn": 12}, {"radius": 0.2}, {"radius": 0.2, "max_nn": None}], ids=str)
def test_normals_are_the_smallest_axis_of_the_neighbours_covariance(device, search, rng, tolerances):
    """Against float64 NumPy with the neighbours of our own search, so nothing is hidden in a choice of neighbours."""
    points = wavy(rng, 701)
    cloud = loom.PointCloud(points, device=device)
    found = cloud.estimate_normals(**search).normals.astype(float)
    finder = loom.NearestNeighborSearch(cloud)
    radius, k = search.get("radius", np.inf), search.get("max_nn", 30)
    if k is None:
        lists = np.split(*(lambda n: (n.indices, np.cumsum(n.counts)[:-1]))(finder.radius_search(cloud, radius)))
    elif np.isinf(radius):
        lists = finder.knn_search(cloud, k).indices
    else:
        lists = finder.hybrid_search(cloud, radius, k).indices
    held = cloud.points
    for row in range(0, 701, 3):
        near = held[[i for i in lists[row] if i >= 0]]
        values, vectors = np.linalg.eigh(np.cov(near.T, bias=True))
        gap = (values[1] - values[0]) / values[2]
        assert 1 - abs(found[row] @ vectors[:, 0]) < 4 * tolerances.unit_length + (1e-12 / max(gap, 1e-9)) ** 2


@pytest.mark.parametrize("search", [{"max_nn": 9}, {"radius": 0.2}, {"radius": 0.2, "max_nn": None}], ids=str)
def test_a_nan_spoils_no_other_points_normal(device, search, rng):
    points = wavy(rng)
    bad = rng.permutation(len(points))[:100]
    spoiled = points.copy()
    spoiled[bad, rng.integers(0, 3, 100)] = np.nan
    spoiled[bad[:20]] = [np.inf, 0, -np.inf]
    found = loom.PointCloud(spoiled, device=device).estimate_normals(**search).normals
    good = np.setdiff1d(np.arange(len(points)), bad)
    expected = loom.PointCloud(points[good], device=device).estimate_normals(**search).normals
    assert np.isnan(found[bad]).all() and np.isfinite(found[good]).all()
    dots = np.abs((found[good] * expected).sum(axis=1))
    assert dots.min() > 1 - 1e-6, "the same neighbours, summed in another order"


@pytest.mark.parametrize("search", [{"radius": 0.5}, {"radius": 0.5, "max_nn": None}, {"max_nn": 2}], ids=str)
def test_fewer_than_three_neighbours_give_the_z_axis(device, search):
    points = np.array([[0, 0, 0], [0.1, 0, 0], [9, 9, 9], [100, 0, 0], [100, 0.1, 0]])
    found = loom.PointCloud(points, device=device).estimate_normals(**search).normals
    assert found.tolist() == [[0, 0, 1]] * 5


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_clouds_of_a_few_points_have_normals(device, count):
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 0, 1], [1, 0, 1.0]])[:count]
    for search in ({"max_nn": 30}, {"radius": 5.0}, {"radius": 5.0, "max_nn": None}):
        found = loom.PointCloud(points, device=device).estimate_normals(**search).normals
        expected = [0, 0, 1] if count < 3 else [0, 1, 0]
        np.testing.assert_allclose(np.abs(found), [expected] * count, atol=1e-7)


@pytest.mark.parametrize(
    "direction", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 2, 3), (1, 1e-4, 0), (0, 1e-6, 1)], ids=str
)
def test_normals_of_points_on_a_line_are_orthogonal_to_it(device, direction, tolerances):
    """Open3D's of a vertical line lie along it."""
    d = np.array(direction) / np.linalg.norm(direction)
    points = np.outer(np.linspace(-1, 1, 101), d)
    for search in ({"max_nn": 10}, {"radius": 0.1, "max_nn": None}):
        found = loom.PointCloud(points, device=device).estimate_normals(**search).normals
        np.testing.assert_allclose(np.linalg.norm(found, axis=1), 1, atol=tolerances.unit_length)
        assert np.abs(found @ d).max() < 1e-5, "the float32 points lie 6e-8 off the line, 0.02 apart"


@pytest.mark.parametrize("width", [1e-2, 1e-3, 1e-4, 1e-5])
def test_normals_of_a_thin_ribbon_are_orthogonal_to_its_width(device, width, rng):
    """Two eigenvalues are up to 1e-10 of the third: no root of the cubic resolves them."""
    points = np.column_stack([rng.random(400), np.zeros(400), width * rng.choice([-1, 1], 400)])
    R = np.array([[0.8, 0.0, 0.6], [0.36, 0.8, -0.48], [-0.48, 0.6, 0.64]])
    turned = loom.PointCloud(points @ R.T, device=device, origin=np.zeros(3))
    found = turned.estimate_normals(radius=3.0, max_nn=400).normals
    noise = 6e-8 / width  # rounding of the coordinates to float32, relative to the ribbon's width
    assert np.abs(found @ R[:, 1]).min() > 1 - max(1e-6, 4 * noise**2)


def test_equal_points_have_the_z_axis(device):
    for search in ({"max_nn": 10}, {"radius": 0.1}, {"radius": 0.1, "max_nn": None}):
        found = loom.PointCloud(np.full((50, 3), 0.3), device=device).estimate_normals(**search).normals
        assert found.tolist() == [[0, 0, 1]] * 50


@pytest.mark.parametrize("scale", [1e-12, 1e-6, 1e6, 1e12])
def test_normals_do_not_depend_on_scale(device, scale, rng):
    points = wavy(rng, 500)
    found = loom.PointCloud(points * scale, device=device, origin=np.zeros(3)).estimate_normals(max_nn=10).normals
    expected = loom.PointCloud(points, device=device).estimate_normals(max_nn=10).normals
    assert (np.abs((found * expected).sum(axis=1)) > 0.9999).mean() > 0.99


def test_normals_take_the_sign_of_earlier_ones(device, rng):
    cloud = loom.PointCloud(wavy(rng), device=device)
    plain = cloud.estimate_normals(max_nn=12)
    signs = rng.choice([-1.0, 1.0], len(cloud))[:, None]
    cloud.normals = plain.normals * signs
    np.testing.assert_array_equal(cloud.estimate_normals(max_nn=12).normals, plain.normals * signs)
    cloud.normals = np.full((len(cloud), 3), np.nan)
    np.testing.assert_array_equal(cloud.estimate_normals(max_nn=12).normals, plain.normals)


def test_orientation_to_a_direction_and_to_a_camera_is_open3ds(device, rng, to_open3d):
    points, normals = rng.normal(size=(800, 3)), rng.normal(size=(800, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    normals[5] = 0
    cloud = loom.PointCloud(points, normals=normals, device=device)
    oracle = to_open3d(cloud.points, cloud.normals)
    oracle.orient_normals_to_align_with_direction([0, 0.6, -0.8])
    found = cloud.orient_normals_to_align_with_direction([0, 0.6, -0.8]).normals
    np.testing.assert_allclose(found, np.asarray(oracle.normals), atol=1e-7)
    oracle = to_open3d(cloud.points, cloud.normals)
    oracle.orient_normals_towards_camera_location([3, -2, 0.5])
    found = cloud.orient_normals_towards_camera_location([3, -2, 0.5]).normals
    np.testing.assert_allclose(found, np.asarray(oracle.normals), atol=2e-7)


def test_a_camera_is_a_place_in_the_world_also_at_utm(device, rng):
    utm = np.array([5e5, 5.4e6, 100])
    points = wavy(rng) + utm
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=12)
    for height in (50.0, -50.0):
        camera = utm + np.array([1, 1, height])
        found = cloud.orient_normals_towards_camera_location(camera).normals
        assert ((camera - points) * found).sum(axis=1).min() > 0


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"radius": None, "max_nn": None}, ValueError, "radius, max_nn: give at least one"),
        ({"radius": 0.0}, ValueError, "radius: expected a finite number > 0"),
        ({"radius": np.inf}, ValueError, "radius: expected a finite number > 0"),
        ({"max_nn": 0}, ValueError, "max_nn: expected a whole number >= 1"),
        ({"max_nn": 2.5}, TypeError, "max_nn: expected a whole number"),
    ],
)
def test_wrong_limits_are_refused(arguments, error, message):
    with pytest.raises(error, match=message):
        loom.PointCloud(np.zeros((3, 3))).estimate_normals(**arguments)


@pytest.mark.parametrize("reference", [(np.nan, 0, 0), (0, np.inf, 0)])
def test_an_orientation_that_is_not_finite_is_refused(reference):
    cloud = loom.PointCloud(np.zeros((3, 3)), normals=np.ones((3, 3)))
    for orient in (cloud.orient_normals_to_align_with_direction, cloud.orient_normals_towards_camera_location):
        with pytest.raises(ValueError, match="expected finite numbers"):
            orient(reference)
        with pytest.raises(ValueError, match=r"expected shape \[3\]"):
            orient([1, 0])


@pytest.mark.parametrize("search", [{"max_nn": 20}, {"radius": 0.2}, {"radius": 0.2, "max_nn": None}], ids=str)
def test_two_runs_give_the_same_bits(device, search, rng):
    cloud = loom.PointCloud(wavy(rng), device=device)
    first, second = (cloud.estimate_normals(**search).normals for _ in range(2))
    np.testing.assert_array_equal(first.view(np.int32), second.view(np.int32))


@pytest.mark.parametrize(
    "search", [{"max_nn": 15}, {"radius": 0.7, "max_nn": None}, {"radius": 0.6, "max_nn": 12}], ids=str
)
def test_normals_of_walls_and_lines_depend_on_no_order(device, search, rng):
    """Rounding decides how the normal of a vertical line lies, and on which side of the level that of a wall."""
    along = rng.random((300, 12, 1)) * [1.1, 0.3, 0.7] + np.arange(300.0)[:, None, None] * [0, 2, 0]
    wide = rng.random((4000, 1)) * 9
    wall = np.column_stack([wide * 0.8 - 30, wide * 0.6 - 30, rng.random(4000) * 3])
    points = np.concatenate([along.reshape(-1, 3), wall])
    elsewhere = rng.random((7_001, 3)) * [9, 600, 1] + [40, 0, 0]
    found = []
    for cloud in (points, np.concatenate([elsewhere, points])):
        fitted = loom.PointCloud(cloud, device=device, origin=np.zeros(3)).estimate_normals(**search)
        fitted = fitted.orient_normals_to_align_with_direction([0, 0, 1])
        found.append(fitted.normals[-len(points) :])
        covariances = loom.PointCloud(cloud, device=device, origin=np.zeros(3)).estimate_covariances(**search)
        found.append(covariances.covariances[-len(points) :])
    np.testing.assert_array_equal(found[0], found[2])
    np.testing.assert_array_equal(found[1], found[3])


def test_normalized_normals_are_open3ds(device, rng, to_open3d, tolerances):
    normals = rng.normal(size=(500, 3)) * 10 ** rng.uniform(-18, 18, (500, 1))
    normals[3], normals[4, 1] = 0, np.nan
    cloud = loom.PointCloud(rng.random((500, 3)), normals=normals, device=device)
    oracle = to_open3d(cloud.points, cloud.normals)
    oracle.normalize_normals()
    found, expected = cloud.normalize_normals().normals, np.asarray(oracle.normals)
    np.testing.assert_array_equal(found[3], 0)
    good = np.arange(500) != 4
    np.testing.assert_allclose(found[good], expected[good], rtol=tolerances.float32_relative)
    assert np.isnan(found[4, 1])


def test_flipped_normals_are_the_opposite_ones(device, rng):
    cloud = loom.PointCloud(rng.random((50, 3)), normals=rng.normal(size=(50, 3)), device=device)
    np.testing.assert_array_equal(cloud.flip_normals().normals, -cloud.normals)
    np.testing.assert_array_equal(cloud.flip_normals().flip_normals().normals, cloud.normals)
