"""FPFH compared with Open3D on real scans and with its formula, and the limits of every feature."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom

from ..scan_cases import on_sets
from .any_cloud import examples
from .made_shapes import bumpy
from .open3d_clouds import features_of


@pytest.fixture(scope="module")
def terrain(shipped_file):
    return loom.read_point_cloud(shipped_file("lidar-pcl-terrain/samp41-utm.pcd")).points


@pytest.fixture(scope="module")
def scenes(fragment, lidar, terrain):
    full = loom.PointCloud(fragment.points)
    near = lidar[np.linalg.norm(lidar[:, :3], axis=1) < 12, :3]
    # Normals point up, as usual: which of two equally distant neighbors is chosen matters most if normals
    # are on both sides (45 rows, instead of 12 now).
    slope = loom.PointCloud(terrain).estimate_normals(radius=8.0, max_nn=30).orient_normals_to_align_with_direction()
    return {
        "fragment 0.05": full.voxel_down_sample(0.05).estimate_normals(radius=0.1, max_nn=30),
        "lidar": loom.PointCloud(near).estimate_normals(radius=0.5, max_nn=30),
        "terrain": slope,
    }


CASES = [
    ("fragment 0.05", {"radius": 0.25, "max_nn": 100}),
    ("fragment 0.05", {"max_nn": 30}),
    ("fragment 0.05", {"radius": 0.2, "max_nn": None}),
    ("lidar", {"radius": 1.0, "max_nn": 50}),
    ("terrain", {"radius": 12.0, "max_nn": 100}),
]


def assert_same_features(cloud, actual, expected, radius, max_nn, tolerances):
    """Check that rows equal Open3D's, except for rows whose neighbors depend on float32 rounding or ties."""
    different = np.flatnonzero(np.abs(actual - expected).max(axis=1) > tolerances.fpfh_block)
    assert len(different) < tolerances.fpfh_ties * len(cloud), f"{len(different)} of {len(cloud)} rows differ"
    uncertain = uncertain_points(cloud, radius, max_nn, tolerances) if len(different) else set()
    assert set(different) <= uncertain, f"{len(set(different) - uncertain)} rows differ without a reason"


def uncertain_points(cloud, radius, max_nn, tolerances):
    """Points whose neighbors are ambiguous, and all points with one of these among their neighbors."""
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
    max_distance = radius or tree.query(p, max_nn)[0].max()
    rows = tree.query_ball_point(p[uncertain], max_distance)
    return set(np.flatnonzero(uncertain)).union(*rows)


@on_sets("scene search", shipped=CASES, real=[case for case in CASES if case[0] != "terrain"])
def test_fpfh_of_real_scans_is_open3ds(device, scene, search, scenes, o3d, tolerances):
    cloud = scenes[scene].to(device)
    result = loom.compute_fpfh_feature(cloud, **search)
    limits = {"radius": None, "max_nn": 100} | search
    assert result.dtype == np.float32 and result.shape == (len(cloud), 33)
    expected = features_of(o3d, cloud.array("points").numpy(), cloud.normals, **limits)
    assert_same_features(scenes[scene], result, expected, **limits, tolerances=tolerances)


def pair_of_points():
    return np.array([[0, 0, 0], [1, 2, 3.0]]), np.array([[0, 0.6, 0.8], [1, 0, 0]])


def duplicates(rng):
    """More duplicates than neighbors: the point itself may be missing from its neighbors, replaced by a duplicate."""
    normals = rng.normal(size=(43, 3))
    return np.concatenate([np.zeros((40, 3)), np.eye(3)]), normals / np.linalg.norm(normals, axis=1, keepdims=True)


def bumpy_with_normals(rng, length):
    points = np.float32(bumpy(rng, 150)).astype(float)
    x, y = 9 * points[:, 0], 7 * points[:, 1]
    slope = np.column_stack([-0.9 * np.cos(x) * np.cos(y), 0.7 * np.sin(x) * np.sin(y), np.ones(150)])
    return points, np.float32(length * slope / np.linalg.norm(slope, axis=1, keepdims=True)).astype(float)


def flat(rng):
    """The order of normals ties for every pair, and angles are exactly zero."""
    return np.float32(np.column_stack([rng.random((200, 2)), np.zeros(200)])).astype(float), [[0, 0, 1.0]] * 200


SMALL = {  # scenes with stored features of Open3D, and limits; normals need not have unit length
    "unit": (lambda rng: bumpy_with_normals(rng, 1.0), 0.2, 40),
    "short": (lambda rng: bumpy_with_normals(rng, 0.9), 0.2, None),
    "long": (lambda rng: bumpy_with_normals(rng, 1.5), 0.2, 40),
    "zero": (lambda rng: bumpy_with_normals(rng, 0.0), 0.2, 40),
    "flat": (flat, 0.2, 100),
    "duplicates": (duplicates, None, 10),
    "two points": (lambda rng: pair_of_points(), 9.0, 100),
    "two points in a huge radius": (lambda rng: pair_of_points(), 3e18, None),
}


@pytest.mark.parametrize("scene", SMALL)
def test_fpfh_of_a_small_scene_is_open3ds(device, scene, rng, oracle, tolerances):
    make, radius, max_nn = SMALL[scene]
    points, normals = make(rng)
    expected = oracle(f"pcd/features/{scene.replace(' ', '-')}", features_of, points, normals, radius, max_nn)
    cloud = loom.PointCloud(points, normals=normals, device=device, origin=np.zeros(3))
    result = loom.compute_fpfh_feature(cloud, radius=radius, max_nn=max_nn)
    rows = slice(40) if scene == "duplicates" else slice(None)  # the neighbors of the others are tied
    np.testing.assert_allclose(result[rows], expected[rows], atol=tolerances.fpfh_block)
    if scene == "flat":
        assert result[:, [5, 16, 27]].min() > 199.99
    if scene == "duplicates":
        np.testing.assert_array_equal(np.unique(result[rows]), [0, 100])


def pair_bins(p, n, q, m):
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
    """FPFH in float64 without a search structure; neighbors by float32 distance, as documented."""
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


LIMITS = st.sampled_from(
    [(0.35, None), (0.8, None), (5.0, None), (None, 1), (None, 7), (None, 35), (0.8, 5), (5.0, 12)]
)


@examples(12)
@given(seed=st.integers(0, 2**32 - 1), count=st.integers(0, 30), limits=LIMITS)
def test_fpfh_is_its_formula(device, tolerances, seed, count, limits):
    """Duplicates, equal normals, non-finite points and normals; lattice points if no count is limited."""
    rng = np.random.default_rng(seed)
    points = rng.random((count, 3))
    if limits[1] is None:
        points = np.where(rng.random((count, 1)) < 0.5, points, rng.integers(0, 3, (count, 3)) / 4)
    normals = rng.normal(size=(count, 3))
    normals[rng.random(count) < 0.2] = [0, 0, 1]
    normals = np.float32(normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(float)
    points[rng.random(count) < 0.1] = np.nan
    normals[rng.random(count) < 0.1, 1] = np.inf
    cloud = loom.PointCloud(points, normals=normals, device=device)
    result = loom.compute_fpfh_feature(cloud, radius=limits[0], max_nn=limits[1])
    np.testing.assert_allclose(result, plain_features(points, normals, *limits), rtol=0, atol=tolerances.fpfh_block)


@pytest.mark.parametrize("search", [{"radius": 0.2}, {"max_nn": 9}, {"radius": 0.2, "max_nn": None}], ids=str)
def test_features_of_some_points_are_rows_of_all(device, search, rng, tolerances):
    points = bumpy(rng, 900)
    points[:400] = np.round(points[:400] * 16) / 16  # ties
    points[7] = np.nan
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=12)
    every = loom.compute_fpfh_feature(cloud, **search)
    for indices in ([3], [880, 7, 12, 12, -1, 0], [], rng.permutation(900)[:300], np.arange(900)):
        result = loom.compute_fpfh_feature(cloud, indices=indices, **search)
        assert result.shape == (len(indices), 33)
        chosen = every[np.asarray(indices, int)]
        np.testing.assert_allclose(result, chosen, rtol=0, atol=tolerances.fpfh_block)


def test_extremely_close_points_have_finite_features(device, rng):
    """A weight is one over the squared distance: at 2e-19 m its product with a histogram overflows float32."""
    points = np.concatenate([np.arange(3)[:, None] * [2e-19, 0, 0], rng.uniform(-1, 1, (40, 3))])
    normals = rng.normal(size=points.shape)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    cloud = loom.PointCloud(points, normals=normals, device=device)
    for limits in ({"radius": None, "max_nn": 10}, {"radius": 0.8, "max_nn": None}):
        features = loom.compute_fpfh_feature(cloud, **limits)
        assert np.isfinite(features).all()
        np.testing.assert_allclose(features[:3].reshape(3, 3, 11).sum(axis=2), 200, rtol=1e-4)
