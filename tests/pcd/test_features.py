"""FPFH, eigenvalue features and ISS keypoints compared with Open3D and with their definitions, and their limits."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom

from ..scan_cases import ON_REAL_SCANS, on_sets
from .any_cloud import examples
from .made_shapes import bumpy
from .open3d_clouds import cloud_of, features_of


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


def uncertain_points(cloud, radius, max_nn, tolerances):
    """Points whose neighbors are ambiguous, and all points with one of these among their neighbors."""
    p = cloud.arrays["points"].numpy().astype(float)
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
    """Except for rows whose neighbors depend on float32 rounding or ties."""
    cloud = scenes[scene].to(device)
    result = loom.compute_fpfh_feature(cloud, **search)
    limits = {"radius": None, "max_nn": 100} | search
    assert result.dtype == np.float32 and result.shape == (len(cloud), 33)
    expected = features_of(o3d, cloud.arrays["points"].numpy(), cloud.normals, **limits)
    different = np.flatnonzero(np.abs(result - expected).max(axis=1) > tolerances.fpfh_block)
    assert len(different) < tolerances.fpfh_ties * len(cloud), f"{len(different)} of {len(cloud)} rows differ"
    uncertain = uncertain_points(scenes[scene], **limits, tolerances=tolerances) if len(different) else set()
    assert set(different) <= uncertain, f"{len(set(different) - uncertain)} rows differ without a reason"


def pair_of_points():
    return np.array([[0, 0, 0], [1, 2, 3.0]]), np.array([[0, 0.6, 0.8], [1, 0, 0]])


def duplicates(rng):
    """More duplicates than neighbors, which are copies without angles in Open3D. Copies count once here."""
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
    if scene == "duplicates":
        assert set(np.unique(expected[:40])) == {0, 100}
        rows = [0, 40, 41, 42]
        alone = loom.PointCloud(points[rows], normals=normals[rows], device=device, origin=np.zeros(3))
        expected, result = loom.compute_fpfh_feature(alone, radius=radius, max_nn=max_nn), result[rows]
    np.testing.assert_allclose(result, expected, atol=tolerances.fpfh_block)
    if scene == "flat":
        assert result[:, [5, 16, 27]].min() > 199.99


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


LIMITS = [(0.35, None), (0.8, None), (5.0, None), (None, 1), (None, 7), (None, 35), (0.8, 5), (5.0, 12)]


@examples(12)
@given(seed=st.integers(0, 2**32 - 1), count=st.integers(0, 30), limits=st.sampled_from(LIMITS))
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


def plain_shapes(near):
    """The features of one neighborhood in float64."""
    values, vectors = np.linalg.eigh(np.cov(near.T, bias=True))
    low, middle, high = np.maximum(values, 0)
    e = np.array([high, middle, low]) / (low + middle + high)
    return {
        "eigenvalues": [high, middle, low],
        "linearity": (high - middle) / high,
        "planarity": (middle - low) / high,
        "sphericity": low / high,
        "omnivariance": np.cbrt(e.prod()),
        "anisotropy": (high - low) / high,
        "eigenentropy": -(e[e > 0] * np.log(e[e > 0])).sum(),
        "curvature": e[2],
        "verticality": 1 - abs(vectors[2, 0]),
    }


def lists_of(cloud, radius=None, max_nn=30):
    """The neighbors of each point by pointloom's own search, so that both use the same ones."""
    finder = loom.NearestNeighborSearch(cloud)
    if max_nn is None:
        neighbors = finder.radius_search(cloud, radius)
        return np.split(neighbors.indices, np.cumsum(neighbors.counts)[:-1])
    neighbors = finder.knn_search(cloud, max_nn) if radius is None else finder.hybrid_search(cloud, radius, max_nn)
    return [row[row >= 0] for row in neighbors.indices]


@ON_REAL_SCANS
@pytest.mark.parametrize("search", [{"radius": 0.1}, {"max_nn": 20}, {"radius": 0.06, "max_nn": None}], ids=str)
def test_features_of_the_fragment_agree_with_float64(device, search, fragment, tolerances):
    cloud = loom.PointCloud(fragment.points[::17], device=device)
    shapes = loom.compute_eigen_features(cloud, **search)
    lists, points = lists_of(cloud, **search), cloud.points
    check_shapes(shapes, lists, points, range(0, len(cloud), 40), tolerances)
    for row in range(0, len(points), 40):  # the density is the number of neighbors over the volume of the search ball
        if len(lists[row]) >= 3:
            is_full = len(lists[row]) == search.get("max_nn", 30)
            farthest = np.linalg.norm(points[lists[row]] - points[row], axis=1).max()
            volume = 4 / 3 * np.pi * (farthest if is_full else search["radius"]) ** 3
            assert shapes["density"][row] == pytest.approx(len(lists[row]) / volume, rel=1e-5)
    np.testing.assert_array_equal(loom.estimate_curvature(cloud, **search)["curvature"], shapes["curvature"])


@on_sets("scan", shipped=("lidar", "terrain"), real=["lidar"])
def test_features_of_scans_agree_with_float64(device, scan, lidar, terrain, tolerances):
    """The tile at UTM coordinates by radius: on its grid of 0.5 m many neighbors tie for the last slot of a count."""
    points, search = (lidar[:, :3], {"max_nn": 20}) if scan == "lidar" else (terrain, {"radius": 4.3, "max_nn": None})
    cloud = loom.PointCloud(points, device=device)
    shapes = loom.compute_eigen_features(cloud, **search)
    check_shapes(shapes, lists_of(cloud, **search), cloud.points - cloud.origin, range(0, len(cloud), 70), tolerances)


def check_shapes(shapes, lists, points, rows, tolerances):
    checked = 0
    for row in rows:
        if len(lists[row]) < 3:
            assert np.isnan(shapes["linearity"][row])
            continue
        expected = plain_shapes(points[lists[row]])
        scale = expected["eigenvalues"][0]
        assert np.abs(shapes["eigenvalues"][row] - expected.pop("eigenvalues")).max() < tolerances.eigen_feature * scale
        for name, value in expected.items():
            power = 3 if name == "omnivariance" else 1  # the cube root of a rounding error is not small
            assert shapes[name][row] ** power == pytest.approx(value**power, abs=tolerances.eigen_feature), name
        checked += 1
    assert checked > 100


def test_degenerate_neighborhoods_have_no_features(device):
    for points in (np.zeros((0, 3)), np.zeros((1, 3)), np.eye(3)[:2], np.ones((20, 3)), np.full((5, 3), np.nan)):
        shapes = loom.compute_eigen_features(loom.PointCloud(points, device=device), max_nn=10)
        assert shapes["eigenvalues"].shape == (len(points), 3)
        assert all(np.isnan(values).all() for values in shapes.attributes.values())


def test_shapes_travel_with_attributes_origin_and_grid(device, rng):
    utm = np.array([5e5, 5.4e6, 100])
    points = bumpy(rng)
    cloud = loom.PointCloud(points + utm, device=device, label=np.arange(len(points)))
    shapes = loom.compute_eigen_features(cloud, radius=0.2)
    assert "linearity" not in cloud and (shapes.origin == cloud.origin).all()
    assert shapes["label"].tolist() == cloud["label"].tolist()
    part = shapes.select_by_index([5, 3])
    np.testing.assert_array_equal(part["planarity"], shapes["planarity"][[5, 3]])
    local = loom.compute_eigen_features(loom.PointCloud(points, device=device), radius=0.2)
    agree = np.abs(local["linearity"] - shapes["linearity"]) < 1e-3
    assert agree.mean() > 0.98, "rounded to 1e-8 m about the origin"
    image = loom.PointCloud(points, device=device)
    image.grid = (20, 30)
    assert loom.estimate_curvature(image).grid == (20, 30)


RADII = {"fragment": (0.06, 0.04), "lidar": (1.0, 0.7), "terrain": (6.0, 4.0)}


@pytest.fixture(scope="module")
def scans(fragment, lidar, scan_file):
    """Real coordinates about their own origin, rounded to float32."""
    utm = loom.read_point_cloud(scan_file("lidar-pcl-terrain/samp11-utm.pcd")).points
    tile = utm - np.round(np.median(utm, axis=0))
    clouds = {"fragment": fragment.points[::3], "lidar": lidar[:, :3], "terrain": tile}
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
