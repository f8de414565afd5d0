"""FPFH against Open3D on real scans and against its formula, with the limits of every feature."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import pointloom as loom

from ..scan_cases import on_sets


def oracle_features(to_open3d, cloud, radius=None, max_nn=None):
    """Open3D's features, [n, 33], of the very float32 numbers that the cloud holds."""
    import open3d as o3d

    if radius is None:
        search = o3d.geometry.KDTreeSearchParamKNN(max_nn)
    elif max_nn is None:
        search = o3d.geometry.KDTreeSearchParamRadius(radius)
    else:
        search = o3d.geometry.KDTreeSearchParamHybrid(radius, max_nn)
    held = np.asarray(cloud.array("points").numpy())
    return o3d.pipelines.registration.compute_fpfh_feature(to_open3d(held, cloud.normals), search).data.T


@pytest.fixture(scope="module")
def terrain(shipped_file):
    """Airborne points in UTM metres."""
    return loom.read_point_cloud(shipped_file("lidar-pcl-terrain/samp41-utm.pcd")).points


@pytest.fixture(scope="module")
def scenes(fragment, lidar, terrain):
    """Clouds with normals on the CPU, by name."""
    whole = loom.PointCloud(fragment.points)
    near = lidar[np.linalg.norm(lidar[:, :3], axis=1) < 12, :3]
    # Its normals look up, as for any use: which of two equally far neighbours is taken tells most where normals
    # lie on both sides (45 rows, where 12 differ now).
    slope = loom.PointCloud(terrain).estimate_normals(radius=8.0, max_nn=30).orient_normals_to_align_with_direction()
    return {
        "fragment 0.05": whole.voxel_down_sample(0.05).estimate_normals(radius=0.1, max_nn=30),
        "fragment 0.025": whole.voxel_down_sample(0.025).estimate_normals(radius=0.05, max_nn=30),
        "lidar": loom.PointCloud(near).estimate_normals(radius=0.5, max_nn=30),
        "terrain": slope,
    }


CASES = [
    ("fragment 0.05", {"radius": 0.25, "max_nn": 100}),
    ("fragment 0.05", {"max_nn": 30}),
    ("fragment 0.05", {"radius": 0.2, "max_nn": None}),
    ("fragment 0.025", {"radius": 0.25, "max_nn": 100}),
    ("lidar", {"radius": 1.0, "max_nn": 50}),
    ("terrain", {"radius": 12.0, "max_nn": 100}),
]


def assert_same_features(cloud, found, expected, radius, max_nn, tolerances):
    """Rows equal Open3D's, but for a few with neighbours whose choice float32 or a tie decides, or theirs."""
    different = np.flatnonzero(np.abs(found - expected).max(axis=1) > tolerances.fpfh_block)
    assert len(different) < tolerances.fpfh_ties * len(cloud), f"{len(different)} of {len(cloud)} rows differ"
    doubtful = doubtful_points(cloud, radius, max_nn, tolerances) if len(different) else set()
    assert set(different) <= doubtful, f"{len(set(different) - doubtful)} rows differ without a reason"


def doubtful_points(cloud, radius, max_nn, tolerances):
    """The points whose neighbours are not certain, and all that have one of these among their neighbours."""
    from scipy.spatial import cKDTree

    p = cloud.array("points").numpy().astype(float)
    tree = cKDTree(p)
    uncertain = np.zeros(len(p), bool)
    if max_nn is not None:
        near = tree.query(p, min(max_nn + 1, len(p)))[0] ** 2
        if near.shape[1] > max_nn:
            tied = near[:, max_nn] - near[:, max_nn - 1] <= tolerances.sqdist_relative * near[:, max_nn]
            uncertain |= tied & (near[:, max_nn - 1] < (radius or np.inf) ** 2)
    if radius is not None:
        slack = radius * tolerances.sqdist_relative
        outer, inner = (tree.query_ball_point(p, r, return_length=True) for r in (radius + slack, radius - slack))
        uncertain |= (outer != inner) & (inner <= (max_nn or len(p)))
    reach = radius or tree.query(p, max_nn)[0].max()
    rows = tree.query_ball_point(p[uncertain], reach)
    return set(np.flatnonzero(uncertain)).union(*rows)


@on_sets("scene search", shipped=CASES, real=[case for case in CASES if case[0] != "terrain"])
def test_fpfh_of_real_scans_is_open3ds(device, scene, search, scenes, oracles, tolerances):
    cloud = scenes[scene].to(device)
    found = loom.compute_fpfh_feature(cloud, **search)
    limits = {"radius": None, "max_nn": 100} | search
    assert found.dtype == np.float32 and found.shape == (len(cloud), 33)
    assert_same_features(scenes[scene], found, oracles(scene, **limits), **limits, tolerances=tolerances)


@pytest.fixture(scope="module")
def oracles(scenes, to_open3d):
    """Open3D's features of a scene, computed once."""
    known = {}

    def compute(scene, radius, max_nn):
        key = (scene, radius, max_nn)
        if key not in known:
            known[key] = oracle_features(to_open3d, scenes[scene], radius, max_nn)
        return known[key]

    return compute


def bumpy(rng, count=600):
    xy = rng.random((count, 2))
    return np.column_stack([xy, 0.1 * np.sin(9 * xy[:, 0]) * np.cos(7 * xy[:, 1])])


def test_fpfh_far_from_the_origin_is_that_at_the_origin(device, rng):
    """Open3D at 5.4e6 m loses half of the digits of the coordinates' squares."""
    points = np.float32(bumpy(rng)).astype(float)
    near = loom.PointCloud(points, device=device, origin=np.zeros(3)).estimate_normals(max_nn=12)
    utm = np.array([5e5, 5.4e6, 100])
    far = loom.PointCloud(points + utm, device=device, origin=utm)
    far.normals = near.normals
    moved = loom.compute_fpfh_feature(far, radius=0.2)
    kept = np.abs(moved - loom.compute_fpfh_feature(near, radius=0.2)).max(axis=1) < 0.02
    assert kept.mean() > 0.99, "coordinates of 5.4e6 are rounded to 1e-9 m as float64"


@pytest.mark.parametrize("length", [0.0, 0.9, 1.5])
def test_normals_need_not_be_of_unit_length(device, length, rng, to_open3d, tolerances):
    """Averages over voxels are shorter than 1, and some scanners write zeros."""
    cloud = loom.PointCloud(bumpy(rng), device=device).estimate_normals(max_nn=12)
    cloud.normals = cloud.normals * np.float32(length)
    found = loom.compute_fpfh_feature(cloud, radius=0.2, max_nn=40)
    np.testing.assert_allclose(found, oracle_features(to_open3d, cloud, 0.2, 40), atol=tolerances.fpfh_block)


def test_fpfh_on_flat_ground_is_open3ds(device, rng, to_open3d, tolerances):
    """Every pair ties for which normal comes first, and angles are exactly zero."""
    xy = rng.random((500, 2))
    cloud = loom.PointCloud(np.column_stack([xy, np.zeros(500)]), normals=[[0, 0, 1]] * 500, device=device)
    found = loom.compute_fpfh_feature(cloud, radius=0.2)
    np.testing.assert_allclose(found, oracle_features(to_open3d, cloud, 0.2, 100), atol=tolerances.fpfh_block)
    assert found[:, [5, 16, 27]].min() > 199.99


def test_more_duplicates_than_neighbours_give_open3ds_feature(device, to_open3d, tolerances):
    """The point itself may then not be among its neighbours; one of these goes in its stead."""
    points = np.concatenate([np.zeros((40, 3)), np.eye(3)])
    normals = np.random.default_rng(1).normal(size=(43, 3))
    cloud = loom.PointCloud(points, normals=normals / np.linalg.norm(normals, axis=1, keepdims=True), device=device)
    found = loom.compute_fpfh_feature(cloud, max_nn=10)[:40]
    np.testing.assert_allclose(found, oracle_features(to_open3d, cloud, None, 10)[:40], atol=tolerances.fpfh_block)
    np.testing.assert_array_equal(np.unique(found), [0, 100])


# ------------------------------------------------------------------------------------------------ FPFH and its formula


def pair_bins(p, n, q, m):
    """The bins of one pair, by the formula."""
    d = q - p
    size = np.linalg.norm(d)
    if size == 0:
        return [5, 16, 27]
    first, second = n @ d / size, m @ d / size
    swap = abs(second) <= 1 and np.arccos(min(abs(first), 1)) > np.arccos(abs(second))
    a, b, d, slope = (m, n, -d, -second) if swap else (n, m, d, first)
    v = np.cross(d, a)
    if not v.any():
        return [5, 16, 27]
    v /= np.linalg.norm(v)
    levels = [(np.arctan2(np.cross(a, v) @ b, a @ b) + np.pi) / (2 * np.pi), (v @ b + 1) / 2, (slope + 1) / 2]
    return [11 * k + min(max(int(np.floor(11 * f)), 0), 10) for k, f in enumerate(levels)]


def plain_features(points, normals, radius, max_nn):
    """FPFH in float64 without any search structure; neighbours by float32 distance, as documented."""
    n = len(points)
    single = np.float32(points)
    good = np.isfinite(single).all(axis=1) & np.isfinite(normals).all(axis=1)
    with np.errstate(invalid="ignore"):
        d = single[:, None] - single[None]
        sqdists = d[..., 0] * d[..., 0] + d[..., 1] * d[..., 1] + d[..., 2] * d[..., 2]
    lists, spfh = [], np.zeros((n, 33))
    for i in range(n):
        within = [j for j in range(n) if good[i] and good[j] and sqdists[i, j] < (radius or np.inf) ** 2]
        others = sorted(within, key=lambda j: (sqdists[i, j], j != i))[:max_nn]
        lists.append([j for j in others if j != i])
        for j in lists[i]:
            spfh[i, pair_bins(single[i].astype(float), normals[i], single[j].astype(float), normals[j])] += 1
        spfh[i] *= 100 / max(1, len(lists[i]))
    out = np.full((n, 33), np.nan)
    for i in np.flatnonzero(good):
        total = sum((spfh[j] / sqdists[i, j] for j in lists[i] if sqdists[i, j] > 0), np.zeros(33))
        sums = total.reshape(3, 11).sum(axis=1, keepdims=True)
        scale = np.divide(100, sums, out=np.zeros_like(sums), where=sums > 0)
        out[i] = (total.reshape(3, 11) * scale).ravel() + spfh[i]
    return out


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(seed=st.integers(0, 2**32 - 1), count=st.integers(0, 30), radius=st.sampled_from([0.35, 0.8, 5.0]))
def test_fpfh_is_its_formula(device, tolerances, seed, count, radius):
    """Lattice points, duplicates, equal normals, points and normals that are not finite; all within the radius."""
    rng = np.random.default_rng(seed)
    points = np.where(rng.random((count, 1)) < 0.5, rng.random((count, 3)), rng.integers(0, 3, (count, 3)) / 4)
    normals = rng.normal(size=(count, 3))
    normals[rng.random(count) < 0.2] = [0, 0, 1]
    normals = np.float32(normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(float)
    points[rng.random(count) < 0.1] = np.nan
    normals[rng.random(count) < 0.1, 1] = np.inf
    cloud = loom.PointCloud(points, normals=normals, device=device)
    found = loom.compute_fpfh_feature(cloud, radius=radius, max_nn=None)
    expected = plain_features(points, normals, radius, None)
    np.testing.assert_allclose(found, expected, rtol=0, atol=tolerances.fpfh_block)


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(seed=st.integers(0, 2**32 - 1), count=st.integers(1, 30), max_nn=st.integers(1, 35), near=st.booleans())
def test_fpfh_of_the_nearest_is_its_formula(device, tolerances, seed, count, max_nn, near):
    rng = np.random.default_rng(seed)
    points, normals = rng.normal(size=(2, count, 3))
    normals = np.float32(normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(float)
    points[rng.random(count) < 0.1] = np.nan
    radius = 1.5 if near else None
    cloud = loom.PointCloud(points, normals=normals, device=device)
    found = loom.compute_fpfh_feature(cloud, radius=radius, max_nn=max_nn)
    expected = plain_features(points, normals, radius, max_nn)
    np.testing.assert_allclose(found, expected, rtol=0, atol=tolerances.fpfh_block)


@pytest.mark.parametrize("search", [{"radius": 0.2}, {"max_nn": 9}, {"radius": 0.2, "max_nn": None}], ids=str)
def test_features_of_some_points_are_rows_of_all(device, search, rng, tolerances):
    points = bumpy(rng, 900)
    points[:400] = np.round(points[:400] * 16) / 16  # ties
    points[7] = np.nan
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=12)
    every = loom.compute_fpfh_feature(cloud, **search)
    for indices in ([3], [880, 7, 12, 12, -1, 0], [], rng.permutation(900)[:300], np.arange(900)):
        found = loom.compute_fpfh_feature(cloud, indices=indices, **search)
        assert found.shape == (len(indices), 33)
        chosen = every[np.asarray(indices, int)]
        np.testing.assert_allclose(found, chosen, rtol=0, atol=tolerances.fpfh_block)


def test_a_point_without_normal_or_position_spoils_no_other_feature(device, rng, tolerances):
    cloud = loom.PointCloud(bumpy(rng), device=device).estimate_normals(max_nn=12)
    points, normals = cloud.points.copy(), cloud.normals.copy()
    bad = rng.permutation(len(points))[:60]
    points[bad[:20], 1], points[bad[20:40], 2], normals[bad[40:], 0] = np.nan, -np.inf, np.nan
    spoiled = loom.PointCloud(points, normals=normals, device=device)
    good = np.setdiff1d(np.arange(len(points)), bad)
    found = loom.compute_fpfh_feature(spoiled, radius=0.2)
    expected = loom.compute_fpfh_feature(spoiled.select_by_index(good), radius=0.2)
    assert np.isnan(found[bad]).all()
    np.testing.assert_allclose(found[good], expected, rtol=0, atol=tolerances.fpfh_block)


@pytest.mark.parametrize("search", [{"radius": 0.5}, {"max_nn": 30}, {"radius": 0.5, "max_nn": None}], ids=str)
def test_points_without_neighbours_have_zero_features(device, search):
    for count in (0, 1):
        cloud = loom.PointCloud(np.zeros((count, 3)), normals=np.ones((count, 3)), device=device)
        assert loom.compute_fpfh_feature(cloud, **search).tolist() == [[0.0] * 33] * count
    if "radius" in search:
        apart = loom.PointCloud(np.eye(3), normals=np.eye(3), device=device)
        assert loom.compute_fpfh_feature(apart, **search).tolist() == [[0.0] * 33] * 3
    alone = loom.PointCloud(np.eye(3), normals=np.eye(3), device=device)
    assert not loom.compute_fpfh_feature(alone, max_nn=1).any()


def test_two_points_and_equal_points_have_features(device, to_open3d, tolerances):
    pair = loom.PointCloud([[0, 0, 0], [1, 2, 3]], normals=[[0, 0.6, 0.8], [1, 0, 0]], device=device)
    for search in ((9.0, 100), (None, 100), (9.0, None), (3e18, None)):
        found = loom.compute_fpfh_feature(pair, radius=search[0], max_nn=search[1])
        np.testing.assert_allclose(found, oracle_features(to_open3d, pair, *search), atol=tolerances.fpfh_block)
    equal = loom.PointCloud(np.ones((50, 3)), normals=np.tile([0, 0, 1], (50, 1)), device=device)
    for search in ({"radius": 1.0}, {"max_nn": 100}, {"radius": 1.0, "max_nn": None}):
        found = loom.compute_fpfh_feature(equal, **search)
        assert np.unique(found[:, [5, 16, 27]]).tolist() == [100] and found.sum() == 50 * 300


@pytest.mark.parametrize("scale", [1e-12, 1e-6, 1e6, 1e12])
def test_fpfh_does_not_depend_on_scale(device, scale, rng):
    points = bumpy(rng)
    plain = loom.PointCloud(points, device=device).estimate_normals(max_nn=12)
    scaled = loom.PointCloud(points * scale, normals=plain.normals, device=device, origin=np.zeros(3))
    found = loom.compute_fpfh_feature(scaled, radius=0.2 * scale)
    agree = np.abs(found - loom.compute_fpfh_feature(plain, radius=0.2)).max(axis=1) < 0.02
    assert agree.mean() > 0.98, "coordinates are rounded anew"


@pytest.mark.parametrize("search", [{"radius": 0.2}, {"max_nn": 20}, {"radius": 0.2, "max_nn": None}], ids=str)
def test_two_runs_give_the_same_bits(device, search, rng):
    cloud = loom.PointCloud(bumpy(rng), device=device).estimate_normals(max_nn=12)
    runs = [loom.compute_fpfh_feature(cloud, **search) for _ in range(2)]
    runs += [loom.compute_eigen_features(cloud, **search)["eigenvalues"] for _ in range(2)]
    for first, second in (runs[:2], runs[2:]):
        np.testing.assert_array_equal(first.view(np.int32), second.view(np.int32))


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"radius": None, "max_nn": None}, ValueError, "radius, max_nn: give at least one"),
        ({"radius": 0.0}, ValueError, "radius: expected a finite number > 0"),
        ({"max_nn": 0}, ValueError, "max_nn: expected a whole number >= 1"),
        ({"max_nn": 2.5}, TypeError, "max_nn: expected a whole number"),
    ],
)
def test_wrong_limits_are_refused(arguments, error, message):
    cloud = loom.PointCloud(np.zeros((3, 3)), normals=np.ones((3, 3)))
    for operation in (loom.compute_fpfh_feature, loom.compute_eigen_features, loom.estimate_curvature):
        with pytest.raises(error, match=message):
            operation(cloud, **arguments)


def test_wrong_indices_and_missing_normals_are_refused():
    cloud = loom.PointCloud(np.zeros((3, 3)))
    with pytest.raises(ValueError, match=r"cloud: FPFH needs normals.*estimate_normals\(\)"):
        loom.compute_fpfh_feature(cloud)
    cloud.normals = np.ones((3, 3))
    with pytest.raises(IndexError, match="reach beyond a cloud of 3 points"):
        loom.compute_fpfh_feature(cloud, indices=[3])
    with pytest.raises(TypeError, match="indices: expected whole numbers"):
        loom.compute_fpfh_feature(cloud, indices=[True, False, True])
    with pytest.raises(TypeError, match="indices: expected whole numbers"):
        loom.compute_fpfh_feature(cloud, indices=[0.5])


def test_points_nearer_than_any_scanner_can_tell_have_finite_features(device, rng):
    """A weight is one over the squared distance: at 2e-19 m that times a histogram is beyond float32."""
    points = np.concatenate([np.arange(3)[:, None] * [2e-19, 0, 0], rng.uniform(-1, 1, (40, 3))])
    normals = rng.normal(size=points.shape)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    cloud = loom.PointCloud(points, normals=normals, device=device)
    for limits in ({"radius": None, "max_nn": 10}, {"radius": 0.8, "max_nn": None}):
        features = loom.compute_fpfh_feature(cloud, **limits)
        assert np.isfinite(features).all()
        np.testing.assert_allclose(features[:3].reshape(3, 3, 11).sum(axis=2), 200, rtol=1e-4)
