"""Normals and covariances: compared with Open3D on real scans, exact far from the origin, degenerate neighborhoods."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom

from ..scan_cases import ON_SCANS
from .any_cloud import examples
from .open3d_clouds import cloud_of, covariances_of, normals_of

SEARCHES = {"hybrid": {"radius": 0.1, "max_nn": 30}, "count": {"max_nn": 30}}
SEARCHES["radius"] = {"radius": 0.03, "max_nn": None}


def assert_agree(actual, expected, tolerances):
    fraction = ((actual * expected).sum(axis=1) > tolerances.normal_dot).mean()
    assert fraction >= tolerances.normal_fraction, f"{fraction:.5f} of the normals agree"
    np.testing.assert_allclose(np.linalg.norm(actual, axis=1), 1, atol=tolerances.unit_length)


@pytest.fixture(scope="module")
def fragment_normals(fragment, o3d):
    return {name: normals_of(o3d, fragment.points, search) for name, search in SEARCHES.items()}


@pytest.mark.parametrize("search", SEARCHES)
def test_normals_of_the_fragment_are_open3ds(device, search, fragment, fragment_normals, tolerances):
    result = loom.PointCloud(fragment.points, device=device).estimate_normals(**SEARCHES[search]).normals
    assert_agree(result, fragment_normals[search], tolerances)


@pytest.mark.parametrize("search", [{"max_nn": 20}, {"radius": 0.1, "max_nn": 30}, {"radius": 0.1, "max_nn": None}])
def test_normals_of_a_depth_frame_have_open3ds_side(device, search, rng, oracle, tolerances):
    """Noise as of a camera: no two neighbors are equally distant, so Open3D's choice is unique."""
    v, u = np.mgrid[:24, :32]
    depth = np.minimum(2.0 + 0.04 * u, 1.4 + 0.08 * v) + 0.3 * np.sin(u / 3) * np.cos(v / 2)  # two walls, a relief
    depth = (depth + rng.normal(0, 2e-3, depth.shape)).astype(np.float32)
    points = np.stack([(u - 15.5) / 28 * depth, (v - 11.5) / 28 * depth, depth], -1).reshape(-1, 3).astype(np.float32)
    name = "pcd/normals/" + "-".join(search) + ("" if search["max_nn"] else "-all")
    result = loom.PointCloud(points, device=device).estimate_normals(**search).normals
    assert_agree(result, oracle(name, normals_of, points.astype(float), search), tolerances)


lattice = st.lists(st.tuples(*[st.integers(-3, 3)] * 3), min_size=1, max_size=40, unique=True)


@settings(max_examples=20, deadline=None)
@given(points=lattice, k=st.integers(1, 45), scale=st.sampled_from([1.0, 1e-3, 1e3]))
def test_no_direction_is_thinner_than_the_normal(points, k, scale):
    """The spread along the normal is minimal over all directions, for neighbors without copies."""
    cloud = loom.PointCloud(np.array(points, float) * scale)
    result = cloud.estimate_normals(max_nn=k).normals.astype(float)
    positions = cloud.points
    indices, sqdists, counts = loom.NearestNeighborSearch(cloud).knn_search(cloud, k + 1)
    for row in range(len(points)):
        if counts[row] > k and sqdists[row, k - 1] == sqdists[row, k]:
            continue  # the choice between tied neighbors is not specified
        near = positions[indices[row, : min(k, counts[row])]]
        if len(near) < 3:
            assert result[row].tolist() == [0, 0, 1]
            continue
        covariance = np.cov(near.T, bias=True)
        min_spread, size = np.linalg.eigvalsh(covariance)[[0, 2]]
        assert result[row] @ covariance @ result[row] <= min_spread + 1e-6 * size


def wavy(rng, count=1500):
    xy = rng.random((count, 2)) * 2
    return np.column_stack([xy, 0.1 * np.sin(5 * xy[:, 0]) + 0.01 * rng.normal(size=count)])


@pytest.mark.parametrize("search", [{"radius": 0.5}, {"radius": 0.5, "max_nn": None}, {"max_nn": 2}], ids=str)
def test_fewer_than_three_neighbors_or_equal_points_give_the_z_axis(device, search):
    points = np.array([[0, 0, 0], [0.1, 0, 0], [9, 9, 9], [100, 0, 0], [100, 0.1, 0]])
    result = loom.PointCloud(points, device=device).estimate_normals(**search).normals
    assert result.tolist() == [[0, 0, 1]] * 5
    equal = loom.PointCloud(np.full((50, 3), 0.3), device=device).estimate_normals(**search | {"radius": 0.1}).normals
    assert equal.tolist() == [[0, 0, 1]] * 50


@pytest.mark.parametrize(
    "direction", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 2, 3), (1, 1e-4, 0), (0, 1e-6, 1)], ids=str
)
def test_normals_of_points_on_a_line_are_orthogonal_to_it(device, direction, tolerances):
    """Open3D's normals of a vertical line are parallel to it."""
    d = np.array(direction) / np.linalg.norm(direction)
    points = np.outer(np.linspace(-1, 1, 101), d)
    for search in ({"max_nn": 10}, {"radius": 0.1, "max_nn": None}):
        result = loom.PointCloud(points, device=device).estimate_normals(**search).normals
        np.testing.assert_allclose(np.linalg.norm(result, axis=1), 1, atol=tolerances.unit_length)
        assert np.abs(result @ d).max() < 1e-5, "the float32 points lie 6e-8 off the line, 0.02 apart"


@pytest.mark.parametrize("width", [1e-2, 1e-3, 1e-4, 1e-5])
def test_normals_of_a_thin_ribbon_are_orthogonal_to_its_width(device, width, rng):
    """Two eigenvalues are up to 1e-10 of the third: no root of the cubic resolves them."""
    points = np.column_stack([rng.random(400), np.zeros(400), width * rng.choice([-1, 1], 400)])
    R = np.array([[0.8, 0.0, 0.6], [0.36, 0.8, -0.48], [-0.48, 0.6, 0.64]])
    rotated = loom.PointCloud(points @ R.T, device=device, origin=np.zeros(3))
    result = rotated.estimate_normals(radius=3.0, max_nn=400).normals
    noise = 6e-8 / width  # rounding of the coordinates to float32, relative to the ribbon's width
    assert np.abs(result @ R[:, 1]).min() > 1 - max(1e-6, 4 * noise**2)


def test_normals_take_the_sign_of_earlier_ones(device, rng):
    cloud = loom.PointCloud(wavy(rng), device=device)
    plain = cloud.estimate_normals(max_nn=12)
    signs = rng.choice([-1.0, 1.0], len(cloud))[:, None]
    cloud.normals = plain.normals * signs
    np.testing.assert_array_equal(cloud.estimate_normals(max_nn=12).normals, plain.normals * signs)
    cloud.normals = np.full((len(cloud), 3), np.nan)
    np.testing.assert_array_equal(cloud.estimate_normals(max_nn=12).normals, plain.normals)


def open3d_orientations(o3d, points, normals):
    clouds = [cloud_of(o3d, points, normals) for _ in range(2)]
    clouds[0].orient_normals_to_align_with_direction([0, 0.6, -0.8])
    clouds[1].orient_normals_towards_camera_location([3, -2, 0.5])
    return [np.asarray(cloud.normals) for cloud in clouds]


def test_orientation_to_a_direction_and_to_a_camera_is_open3ds(device, rng, oracle):
    points, normals = rng.normal(size=(300, 3)), rng.normal(size=(300, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    normals[5] = 0
    cloud = loom.PointCloud(points, normals=normals, device=device)
    arrays = cloud.points.copy(), cloud.normals.copy()
    along, toward = oracle("pcd/normals/oriented", open3d_orientations, *arrays)
    np.testing.assert_allclose(cloud.orient_normals_to_align_with_direction([0, 0.6, -0.8]).normals, along, atol=1e-7)
    result = cloud.orient_normals_towards_camera_location([3, -2, 0.5]).normals
    np.testing.assert_allclose(result, toward, atol=2e-7)


@pytest.mark.parametrize(
    "search", [{"max_nn": 15}, {"radius": 0.7, "max_nn": None}, {"radius": 0.6, "max_nn": 12}], ids=str
)
def test_normals_of_walls_and_lines_depend_on_no_order(device, search, rng):
    """Rounding decides the direction of a vertical line's normal, and the side of a wall's normal."""
    along = rng.random((300, 12, 1)) * [1.1, 0.3, 0.7] + np.arange(300.0)[:, None, None] * [0, 2, 0]
    wide = rng.random((4000, 1)) * 9
    wall = np.column_stack([wide * 0.8 - 30, wide * 0.6 - 30, rng.random(4000) * 3])
    points = np.concatenate([along.reshape(-1, 3), wall])
    elsewhere = rng.random((7_001, 3)) * [9, 600, 1] + [40, 0, 0]
    results = []
    for cloud in (points, np.concatenate([elsewhere, points])):
        fitted = loom.PointCloud(cloud, device=device, origin=np.zeros(3)).estimate_normals(**search)
        fitted = fitted.orient_normals_to_align_with_direction([0, 0, 1])
        results.append(fitted.normals[-len(points) :])
        covariances = loom.PointCloud(cloud, device=device, origin=np.zeros(3)).estimate_covariances(**search)
        results.append(covariances.covariances[-len(points) :])
    np.testing.assert_array_equal(results[0], results[2])
    np.testing.assert_array_equal(results[1], results[3])


def test_normalized_normals_have_unit_length(device, rng, tolerances):
    """As in Open3D, normals of length zero are unchanged."""
    normals = (rng.normal(size=(500, 3)) * 10 ** rng.uniform(-18, 18, (500, 1))).astype(np.float32)
    normals[3], normals[4, 1] = 0, np.nan
    result = loom.PointCloud(rng.random((500, 3)), normals=normals, device=device).normalize_normals().normals
    np.testing.assert_array_equal(result[3], 0)
    good, exact = ~np.isin(np.arange(500), (3, 4)), normals.astype(float)
    expected = exact[good] / np.linalg.norm(exact[good], axis=1, keepdims=True)
    np.testing.assert_allclose(result[good], expected, rtol=tolerances.float32_relative)
    assert np.isnan(result[4, 1])


def test_flipped_normals_are_the_opposite_ones(device, rng):
    cloud = loom.PointCloud(rng.random((50, 3)), normals=rng.normal(size=(50, 3)), device=device)
    np.testing.assert_array_equal(cloud.flip_normals().normals, -cloud.normals)
    np.testing.assert_array_equal(cloud.flip_normals().flip_normals().normals, cloud.normals)


LISTS = {"hybrid": {"radius": 0.1, "max_nn": 30}, "count": {"max_nn": 20}, "radius": {"radius": 0.05, "max_nn": None}}


def untied(points, search):
    """True where the last neighbor within the count is nearer than the next one; otherwise the choice is free."""
    k = search["max_nn"]
    if k is None:
        return np.ones(len(points), bool)
    distances = cKDTree(points).query(points, k + 1)[0]
    return distances[:, k] > distances[:, k - 1] * (1 + 1e-6)


def assert_covariances(actual, expected, tolerances):
    """Compare relative to the largest entry of each matrix, except for neighbors at exactly the radius."""
    sizes = np.abs(expected).max(axis=(1, 2))
    errors = np.abs(actual - expected).max(axis=(1, 2))
    fraction = (errors <= tolerances.covariance_relative * sizes).mean()
    assert fraction >= tolerances.normal_fraction, f"{fraction:.5f} of the covariances agree"


@pytest.fixture(scope="module")
def scans(fragment, lidar, terrain):
    """Points by name, rounded to float32, and a length [m] that scales the searches; the tile is centered."""
    tile = (terrain - np.round(terrain.mean(axis=0))).astype(np.float32).astype(float)
    near, wide = (fragment.points[::10], 1.0), (lidar[:, :3].astype(float), 10.0)
    return {"fragment": near, "lidar": wide, "terrain": (tile, 40.0)}


@ON_SCANS
@pytest.mark.parametrize("search", LISTS)
def test_covariances_of_scans_are_open3ds(device, scan, search, scans, o3d, tolerances):
    points, scale = scans[scan]
    limits = dict(LISTS[search])
    if "radius" in limits:
        limits["radius"] *= scale
    result = loom.PointCloud(points, device=device).estimate_covariances(**limits).covariances
    sure = untied(points, limits)
    assert sure.mean() > 0.5
    assert_covariances(result[sure], covariances_of(o3d, points, limits)[sure], tolerances)


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # the radius is short
@pytest.mark.parametrize("search", LISTS)
def test_covariances_of_a_bumpy_surface_are_open3ds(device, search, rng, oracle, tolerances):
    xy = rng.random((200, 2))
    points = np.column_stack([xy, 0.1 * np.sin(9 * xy[:, 0])]).astype(np.float32).astype(float)
    result = loom.PointCloud(points, device=device).estimate_covariances(**LISTS[search]).covariances
    expected = oracle(f"pcd/covariances/{search}", covariances_of, points, LISTS[search])
    assert_covariances(result, expected, tolerances)


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # if the radius is short
@given(
    seed=st.integers(0, 10_000),
    count=st.integers(1, 60),
    lattice=st.booleans(),
    spoiled=st.booleans(),
    search=st.sampled_from([{"max_nn": 1}, {"max_nn": 7}, {"radius": 1.5}, {"radius": 1.5, "max_nn": None}]),
)
@examples(15)
def test_covariances_agree_with_numpy_for_the_same_neighbors(device, seed, count, lattice, spoiled, search, tolerances):
    rng = np.random.default_rng(seed)
    points = (rng.integers(0, 4, (count, 3)) if lattice else rng.normal(size=(count, 3))).astype(np.float32)
    if spoiled:
        points[rng.random(count) < 0.2, rng.integers(0, 3)] = rng.choice([np.nan, np.inf])
    cloud = loom.PointCloud(points, device=device)
    result = cloud.estimate_covariances(**search).covariances
    finite = np.isfinite(points).all(axis=1)
    copies = (points[:, None] == points[None]).all(axis=2).sum(axis=1)
    with np.errstate(invalid="ignore"):
        sqdists = ((points[:, None].astype(float) - points[None]) ** 2).sum(axis=2)
    for row in range(count):
        if not finite[row]:
            assert np.isnan(result[row]).all()
            continue
        near = np.flatnonzero(sqdists[row] < search.get("radius", np.inf) ** 2)
        near = near[np.argsort(sqdists[row, near])]
        k = search.get("max_nn", 30) or count
        if max(copies[near[:k]]) > max(1, k // 5) and k < count:
            continue  # copies of a position fill the neighborhood, see the next test
        if len(near) > k and sqdists[row, near[k - 1]] == sqdists[row, near[k]]:
            continue  # a tie: either is valid
        near = near[:k]
        expected = np.cov(points[near].astype(float).T, bias=True) if len(near) >= 3 else np.eye(3)
        size = np.abs(expected).max()
        assert np.abs(result[row] - expected).max() <= tolerances.covariance_relative * size


def test_equal_and_collinear_points_have_their_plain_covariance(device):
    equal = loom.PointCloud(np.full((40, 3), 0.3), device=device).estimate_covariances(max_nn=10).covariances
    np.testing.assert_array_equal(equal, np.tile(np.eye(3), (40, 1, 1)), err_msg="one distinct neighbor")
    line = np.outer([-1.0, 0, 1], [0, 0, 3.0])
    result = loom.PointCloud(line, device=device).estimate_covariances(radius=100.0).covariances
    np.testing.assert_array_equal(result, np.tile(np.diag([0, 0, 6]), (3, 1, 1)))


def test_covariances_are_matrices_that_travel_with_their_points(device, rng):
    bare = loom.PointCloud(np.zeros((2, 3)), device=device)
    with pytest.raises(ValueError, match=r"no covariances: call estimate_covariances\(\)"):
        _ = bare.covariances
    with pytest.raises(ValueError, match="covariances:"):
        bare.covariances = np.zeros((2, 9))
    bare.covariances = np.arange(18.0).reshape(2, 3, 3)
    assert bare.has_covariances and bare.covariances.dtype == np.float32
    np.testing.assert_array_equal(bare.covariances, np.arange(18.0).reshape(2, 3, 3))
    cloud = loom.PointCloud(rng.random((100, 3)), device=device).estimate_covariances(max_nn=8)
    rows = [5, 3, 99]
    np.testing.assert_array_equal(cloud.select_by_index(rows).covariances, cloud.covariances[rows])
    assert cloud.attributes["covariances"].shape == (100, 9)
    np.testing.assert_array_equal(cloud.covariances, cloud.covariances.transpose(0, 2, 1))


def test_stored_covariances_do_not_change_the_normals_fitted(device, rng):
    """Open3D uses them instead of the requested neighbors."""
    cloud = loom.PointCloud(rng.random((50, 3)), device=device)
    expected = cloud.estimate_normals(max_nn=8).normals
    cloud.covariances = np.tile(np.diag([1.0, 2, 3]), (50, 1, 1))
    np.testing.assert_array_equal(cloud.estimate_normals(max_nn=8).normals, expected)


def test_lists_made_in_parts_give_the_same(device, rng, monkeypatch):
    cloud = loom.PointCloud(rng.random((1003, 3)), device=device)
    full = cloud.estimate_covariances(max_nn=9).covariances
    monkeypatch.setattr("pointloom.kernels.surface.covariances.LIST_ENTRIES", 1000)
    np.testing.assert_array_equal(cloud.estimate_covariances(max_nn=9).covariances, full)


def test_covariances_rotate_with_the_cloud(device, rng, tolerances):
    cloud = loom.PointCloud(rng.random((500, 3)) * [3, 2, 1], device=device).estimate_covariances(max_nn=12)
    T, cosine, sine = np.eye(4), np.cos(0.7), np.sin(0.7)
    T[:3] = [[cosine, -sine, 0, 5], [sine, cosine, 0, -1], [0, 0, 1, 2]]
    expected = T[:3, :3] @ cloud.covariances.astype(float) @ T[:3, :3].T
    rotated = cloud.transform(T).covariances
    np.testing.assert_allclose(rotated, expected, atol=tolerances.float32_relative * np.abs(expected).max())
    assert np.abs(rotated - cloud.covariances).max() > 0.01


def test_a_radius_with_too_few_neighbors_is_reported_with_one_that_fits(device, rng):
    cloud = loom.PointCloud(rng.random((500, 3)), device=device)
    calls = {
        "radius": lambda length: cloud.estimate_normals(radius=length),
        "nb_points": lambda length: cloud.remove_radius_outlier(2, length),
        "eps": lambda length: cloud.cluster_dbscan(length, 3),
    }
    for call in calls.values():
        with pytest.warns(loom.UnitWarning, match="most points have fewer than 3 points within 0.03 m") as caught:
            call(0.03)
        call(float(str(caught[0].message).split("that many within ")[1].split(" m")[0]))  # does not warn
