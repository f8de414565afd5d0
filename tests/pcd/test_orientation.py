"""Consistent orientation: Hoppe's graph of neighbours, whole; against Kruskal's algorithm and against Open3D."""

from __future__ import annotations

from functools import cache
from itertools import combinations

import numpy as np
import pytest
import scipy.sparse as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.sparse.csgraph import breadth_first_order, minimum_spanning_tree
from scipy.spatial import Delaunay, cKDTree

import pointloom as loom
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.search.point_tree import PointTree

SETTINGS = settings(
    max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture], derandomize=True
)


def orient(points, normals, k, device, **options):
    cloud = loom.PointCloud(points, normals=normals, device=device)
    return cloud.orient_normals_consistent_tangent_plane(k, **options).normals


def random_signs(rng, normals):
    return (normals * rng.choice([-1, 1], (len(normals), 1))).astype(np.float32)


def agreement(found, expected):
    return float(((found * expected).sum(axis=1) > 0).mean())


# ------------------------------------------------------------------------------------------------ small clouds


def row_sums(a):
    return a[..., 0] + a[..., 1] + a[..., 2]  # in this order, as the kernels sum


def listed_neighbors(points, units, k, cos_alpha_tol, outliers):
    """[n, k] by distance, ties by index; those left out are the point itself."""
    d = points[None] - points[:, None]
    sqdists = row_sums(d * d)
    lists = np.argsort(sqdists, axis=1, kind="stable")[:, :k]
    d = np.take_along_axis(d, lists[..., None], axis=1)
    heights = np.abs(row_sums(d * units[:, None]))
    drop = heights > np.float32(cos_alpha_tol) * np.sqrt(row_sums(d * d)) if cos_alpha_tol < 1 else heights < 0
    if outliers:
        ranked = np.sort(heights, axis=1)
        low, high = ranked[:, k // 4], ranked[:, 3 * k // 4]
        drop |= heights > (high + np.float32(1.5) * (high - low))[:, None]
    return np.where(drop, np.arange(len(points))[:, None], lists)


def orient_by_kruskal(points, normals, k, cos_alpha_tol=1.0, outliers=False):
    """The rule in NumPy, quadratic; vertices are ranks on the tree's curve, since ties are broken by them."""
    usable = np.flatnonzero(np.isfinite(points).all(axis=1) & np.isfinite(normals).all(axis=1))
    oriented = normals.copy()
    if not len(usable):
        return oriented
    rows = usable[download(PointTree(upload(points[usable], vec3, "cpu")).order)]
    held, exact = points[rows], normals[rows].astype(float)
    sizes = np.sqrt(row_sums(exact * exact))
    units = (exact / np.where(sizes > 0, sizes, 1)[:, None]).astype(np.float32)
    cosines = row_sums(units[:, None].astype(float) * units[None].astype(float))
    labels, signs = np.arange(len(rows)), np.ones(len(rows))

    def join(u, v):
        if labels[u] != labels[v]:
            part = labels == labels[v]
            signs[part] *= (-1.0 if cosines[u, v] < 0 else 1.0) * signs[u] * signs[v]
            labels[part] = labels[u]

    lists = listed_neighbors(held, units, min(k, len(rows)), cos_alpha_tol, outliers)
    starts = np.repeat(np.arange(len(rows)), lists.shape[1])
    weights = (1 - np.abs(cosines[starts, lists.ravel()])).astype(np.float32).clip(0)
    for entry in np.argsort(weights, kind="stable"):
        join(starts[entry], lists.flat[entry])
    u, v = np.triu_indices(len(rows), 1)
    d = held[v] - held[u]
    for pair in np.argsort(row_sums(d * d), kind="stable"):
        join(u[pair], v[pair])
    low = np.flatnonzero(held[:, 2] == held[:, 2].min())
    low = low[rows[low].argmin()]
    signs *= signs[low] * (-1 if normals[rows[low], 2] > 0 else 1)
    oriented[rows] *= signs[:, None].astype(np.float32)
    return oriented


@st.composite
def small_clouds(draw):
    rng = np.random.default_rng(draw(st.integers(0, 10_000)))
    count = draw(st.integers(1, 80))
    points = rng.integers(0, 4, (count, 3)) if draw(st.booleans()) else rng.normal(size=(count, 3)) ** 3
    normals = rng.normal(size=(count, 3)) * rng.uniform(0.5, 2, (count, 1))
    points, normals = points.astype(np.float32), normals.astype(np.float32)
    if draw(st.booleans()):
        normals = np.eye(3, dtype=np.float32)[rng.integers(0, 3, count)] * rng.choice([-1, 0, 1, 1], (count, 1))
    if draw(st.booleans()):
        points[rng.random(count) < 0.1, rng.integers(0, 3)] = rng.choice([np.nan, np.inf, -np.inf])
        normals[rng.random(count) < 0.1, rng.integers(0, 3)] = np.nan
    return points, normals.astype(np.float32)


@given(cloud=small_clouds(), k=st.sampled_from([1, 2, 5, 12, 100]))
@SETTINGS
def test_signs_are_those_along_the_least_spanning_tree(device, cloud, k):
    """With duplicates, ties of every kind, zero normals, and points and normals that are not finite."""
    points, normals = cloud
    found = orient(points, normals, k, device)
    np.testing.assert_array_equal(found, orient_by_kruskal(points, normals, k))


@pytest.mark.parametrize("options", [(0.5, 1.0), (0.0, 0.6), (0.5, 0.8)], ids=str)
def test_steep_and_outlying_neighbours_are_left_out(device, rng, options):
    penalty, steepest = options
    changed = penalty > 0  # what an outlier changes shows on a thin wall, below
    for k in (3, 8, 20):
        points, normals = rng.normal(size=(2, 120, 3)).astype(np.float32) ** 3
        found = orient(points, normals, k, device, lambda_penalty=penalty, cos_alpha_tol=steepest)
        np.testing.assert_array_equal(found, orient_by_kruskal(points, normals, k, steepest, penalty > 0))
        changed |= not np.array_equal(found, orient(points, normals, k, device))
    assert changed, "the options matter on such clouds"


# ------------------------------------------------------------------------------------------------ Open3D


def pairs(edges):
    return np.unique(np.sort(edges, axis=1), axis=0)


def spanning_tree(count, edges, weights):
    tree = minimum_spanning_tree(sp.csr_matrix((weights + 1e-12, (edges[:, 0], edges[:, 1])), shape=(count, count)))
    return tree + tree.T


def without(edges, others):
    keys, forbidden = (e[:, 0].astype(np.int64) * 2**32 + e[:, 1] for e in (edges, others))
    return edges[~np.isin(keys, forbidden)]


def orient_along(points, normals, edges):
    """Open3D's rule on a graph that is given."""
    weights = 1 - np.abs((normals[edges[:, 0]] * normals[edges[:, 1]]).sum(axis=1))
    low = int(points[:, 2].argmin())
    order, before = breadth_first_order(spanning_tree(len(points), edges, weights.clip(0)), low, directed=False)
    signs = np.zeros(len(points))
    signs[low] = -1 if normals[low, 2] > 0 else 1
    for v in order[1:]:
        signs[v] = signs[before[v]] * (1 if normals[v] @ normals[before[v]] >= 0 else -1)
    return normals * signs[:, None]


@pytest.fixture(scope="module")
def scans(fragment, lidar, data, to_open3d):
    """Points and float32 normals of an indoor scan, a LiDAR frame and a terrain tile about its middle, all thinned."""
    import open3d as o3d

    tile = o3d.io.read_point_cloud(str(data / "lidar-pcl-terrain" / "samp21-utm.pcd"))
    tile = np.asarray(tile.points)
    found = {}
    for name, points, voxel in (
        ("fragment", fragment.points, 0.03),
        ("lidar", lidar[:, :3], 0.3),
        ("terrain", tile - np.round(tile.mean(axis=0)), 3.0),
    ):
        cloud = to_open3d(points).voxel_down_sample(voxel)
        cloud.points = o3d.utility.Vector3dVector(np.asarray(cloud.points).astype(np.float32))
        cloud.estimate_normals(o3d.geometry.KDTreeSearchParamKNN(20))
        found[name] = (np.asarray(cloud.points), np.asarray(cloud.normals).astype(np.float32).astype(float))
    return found


@pytest.fixture(scope="module")
def oracle(scans, to_open3d):
    """A function (scan, k) -> Open3D's normals, computed once."""

    @cache
    def orient_scan(scan, k):
        cloud = to_open3d(*scans[scan])
        cloud.orient_normals_consistent_tangent_plane(k)
        return np.asarray(cloud.normals)

    return orient_scan


@pytest.fixture(scope="module")
def graphs(scans):
    """A function (scan, k) -> the edges of the graphs: all of it, what Open3D takes of it, and the k nearest alone."""

    @cache
    def euclidean_tree(scan):
        points = scans[scan][0]
        delaunay = pairs(np.concatenate([Delaunay(points).simplices[:, pair] for pair in combinations(range(4), 2)]))
        lengths = ((points[delaunay[:, 0]] - points[delaunay[:, 1]]) ** 2).sum(axis=1)
        return delaunay, pairs(np.stack(spanning_tree(len(points), delaunay, lengths).nonzero(), axis=1))

    @cache
    def make_graphs(scan, k):
        points, (delaunay, tree) = scans[scan][0], euclidean_tree(scan)
        nearest = cKDTree(points).query(points, k)[1]
        nearest = np.stack([np.repeat(np.arange(len(points)), k), nearest.ravel()], axis=1)
        nearest = pairs(nearest[nearest[:, 0] != nearest[:, 1]])
        whole, reduced = (pairs(np.concatenate([tree, e])) for e in (nearest, without(nearest, delaunay)))
        return whole, reduced, nearest

    return make_graphs


@pytest.mark.parametrize("k", [6, 15, 30, 100])
def test_orientation_of_the_fragment_is_open3ds(device, k, scans, oracle, tolerances):
    assert agreement(orient(*scans["fragment"], k, device), oracle("fragment", k)) >= tolerances.orientation_share


@pytest.mark.parametrize("scan", ["fragment", "lidar", "terrain"])
@pytest.mark.parametrize("k", [15, 30])
def test_orientation_is_open3ds_rule_on_the_whole_graph(device, scan, k, scans, oracle, graphs, tolerances):
    """Open3D leaves out neighbours that are edges of its Delaunay tetrahedra but not of its Euclidean tree.

    Where normals are noise, as in trees and on a LiDAR's far rings, that turns whole patches. Its rule on its graph
    gives its result; the same rule on all neighbours gives ours.
    """
    whole, reduced, nearest = graphs(scan, k)
    assert len(whole) - len(reduced) > 0.1 * len(nearest)
    theirs = orient_along(*scans[scan], reduced)
    assert agreement(theirs, oracle(scan, k)) >= tolerances.orientation_share
    found = orient(*scans[scan], k, device)
    assert agreement(found, orient_along(*scans[scan], whole)) >= tolerances.orientation_share


# ------------------------------------------------------------------------------------------------ surfaces


def sphere(rng, count, radius=1.0):
    outward = rng.normal(size=(count, 3))
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    return radius * outward, outward


def torus(rng, count):
    u, v = rng.uniform(0, 2 * np.pi, (2, count))
    outward = np.stack([np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)], axis=1)
    return np.stack([np.cos(u), np.sin(u), 0 * u], axis=1) * 2 + 0.7 * outward, outward


def nested(rng, count):
    parts = [sphere(rng, count // 2), sphere(rng, count // 2, 2.0)]
    return np.concatenate([p for p, _ in parts]), np.concatenate([n for _, n in parts])


@pytest.mark.parametrize("surface", [sphere, torus, nested])
def test_closed_surfaces_come_out_with_all_normals_outward(device, surface, rng):
    points, outward = surface(rng, 4000)
    found = orient(points, random_signs(rng, outward), 12, device)
    np.testing.assert_array_equal(found, outward.astype(np.float32))
    fitted = loom.PointCloud(points, device=device).estimate_normals(max_nn=12)
    assert agreement(fitted.orient_normals_consistent_tangent_plane(12).normals, outward) == 1.0


def thin_wall(half, spacing):
    """Points and outward normals of a round plate of radius 1 with a round rim."""
    steps = np.arange(-1, 1, spacing)
    xy = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    xy = xy[(xy**2).sum(axis=1) < 1]
    faces = [np.column_stack([xy, np.full(len(xy), side)]) for side in (-half, half)]
    turn, tilt = np.meshgrid(np.arange(0, 2 * np.pi, spacing), np.linspace(-np.pi / 2, np.pi / 2, 7))
    turn, tilt = turn.ravel(), tilt.ravel()
    rim = np.stack([np.cos(turn) * np.cos(tilt), np.sin(turn) * np.cos(tilt), np.sin(tilt)], axis=1)
    points = np.concatenate([*faces, np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1) + half * rim])
    return points, np.concatenate([np.tile([0, 0, side], (len(xy), 1)) for side in (-1.0, 1.0)] + [rim])


@pytest.mark.parametrize("options", [{"cos_alpha_tol": 0.5}, {"lambda_penalty": 1.0}], ids=str)
def test_the_faces_of_a_thin_wall_look_apart_where_neighbours_across_are_left_out(device, options, rng):
    """The faces lie 4 cm apart and their points 3 cm: among ten neighbours is one on the other face."""
    points, outward = thin_wall(0.02, 0.03)
    normals = random_signs(rng, outward)
    assert agreement(orient(points, normals, 10, device), outward) < 0.9
    assert agreement(orient(points, normals, 10, device, **options), outward) == 1.0


# ------------------------------------------------------------------------------------------------ edge cases


def test_coplanar_and_collinear_points_are_oriented(device, rng):
    """Open3D's Delaunay tetrahedra do not exist there."""
    plane = np.column_stack([rng.random((500, 2)), np.zeros(500)])
    down = np.tile([0.0, 0, -1], (500, 1))
    assert agreement(orient(plane, random_signs(rng, down), 8, device), down) == 1.0
    line = np.column_stack([np.linspace(0, 1, 500), np.zeros((500, 2))])
    assert agreement(orient(line, random_signs(rng, down), 8, device), down) == 1.0
    lattice = np.stack(np.meshgrid(*[np.arange(8.0)] * 3), axis=-1).reshape(-1, 3)
    down = np.tile([0.0, 0.6, -0.8], (512, 1))
    assert agreement(orient(lattice, random_signs(rng, down), 8, device), down) == 1.0


@pytest.mark.parametrize("k", [1, 3, 40])
def test_duplicates_end(device, rng, k):
    """More copies of a point than k: its neighbours are its copies alone."""
    points = np.repeat(rng.normal(size=(7, 3)), 60, axis=0)[rng.permutation(420)]
    down = np.tile([0.6, 0.0, -0.8], (420, 1))
    assert agreement(orient(points, random_signs(rng, down), k, device), down) == 1.0
    equal = np.full((420, 3), 0.3)
    assert agreement(orient(equal, random_signs(rng, down), k, device), down) == 1.0


@pytest.mark.parametrize("k", [1, 2, 10_000_000])
def test_clouds_of_a_few_points_are_oriented(device, k):
    points = np.array([[0, 0, 1], [0, 0, 0], [1, 0, 0.0]])
    normals = np.array([[0, 0.6, 0.8], [0, 0, 1], [0, 0.6, -0.8]], np.float32)
    for count, expected in ((0, []), (1, [-1]), (2, [-1, -1]), (3, [-1, -1, 1])):
        found = orient(points[:count].reshape(-1, 3), normals[:count].reshape(-1, 3), k, device)
        np.testing.assert_array_equal(found, normals[:count] * np.array(expected, np.float32).reshape(-1, 1))


def test_what_is_not_finite_stays_and_passes_no_sign_on(device, rng):
    points, outward = sphere(rng, 2000)
    normals = random_signs(rng, outward)
    bad = rng.permutation(2000)[:60]
    points[bad[:20], 1], points[bad[20:40]], normals[bad[40:]] = np.nan, np.inf, np.nan
    normals[bad[50:], 0] = 1.0
    found = orient(points, normals, 12, device)
    np.testing.assert_array_equal(found[bad], normals[bad])
    good = np.setdiff1d(np.arange(2000), bad)
    np.testing.assert_array_equal(found[good], outward[good].astype(np.float32))
    nothing = np.full((5, 3), np.nan, np.float32)
    np.testing.assert_array_equal(orient(nothing, normals[:5], 3, device), normals[:5])


def test_zero_normals_stay_zero_and_lengths_stay(device, rng):
    points, outward = sphere(rng, 1500)
    lengths = rng.uniform(0.1, 10, (1500, 1))
    lengths[rng.permutation(1500)[:30]] = 0
    found = orient(points, random_signs(rng, outward * lengths), 12, device)
    np.testing.assert_array_equal(found, (outward * lengths).astype(np.float32))


def test_orientation_at_utm_coordinates_is_as_at_the_origin(device, rng):
    points, outward = sphere(rng, 2000, 50.0)
    found = orient(points + np.array([5e5, 5.4e6, 100]), random_signs(rng, outward), 12, device)
    assert agreement(found, outward) == 1.0


def test_orientation_keeps_all_but_the_normals(device, rng):
    points, outward = sphere(rng, 60)
    cloud = loom.PointCloud(
        points + 1e5, normals=outward, colors=rng.random((60, 3)), device=device, ring=np.arange(60)
    )
    cloud.grid = (6, 10)
    before = cloud.normals
    operations = (
        lambda c: c.orient_normals_consistent_tangent_plane(8),
        lambda c: c.normalize_normals(),
        lambda c: c.flip_normals(),
        lambda c: c.estimate_covariances(max_nn=5),
    )
    for operation in operations:
        after = operation(cloud)
        assert after is not cloud and after.grid == (6, 10) and (after.origin == cloud.origin).all()
        for name in ("points", "colors", "ring"):
            assert after.array(name) is cloud.array(name)
    np.testing.assert_array_equal(cloud.normals, before)


def test_two_runs_give_the_same_bits(device, scans):
    points, normals = scans["lidar"]
    first, second = (orient(points, normals, 10, device) for _ in range(2))
    np.testing.assert_array_equal(first.view(np.int32), second.view(np.int32))


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"k": 0}, ValueError, "k: expected a whole number >= 1"),
        ({"k": 2.5}, TypeError, "k: expected a whole number"),
        ({"k": 5, "lambda_penalty": -1}, ValueError, "lambda_penalty: expected a finite number >= 0"),
        ({"k": 5, "cos_alpha_tol": 1.5}, ValueError, "cos_alpha_tol: expected a cosine in 0..1"),
        ({"k": 5, "cos_alpha_tol": -0.5}, ValueError, "cos_alpha_tol: expected a finite number >= 0"),
    ],
)
def test_wrong_arguments_are_refused(arguments, error, message):
    with pytest.raises(error, match=message):
        loom.PointCloud(np.zeros((3, 3)), normals=np.ones((3, 3))).orient_normals_consistent_tangent_plane(**arguments)


def test_a_cloud_without_normals_is_refused():
    cloud = loom.PointCloud(np.zeros((3, 3)))
    for operation in (
        lambda: cloud.orient_normals_consistent_tangent_plane(5),
        cloud.normalize_normals,
        cloud.flip_normals,
    ):
        with pytest.raises(ValueError, match=r"no normals: call estimate_normals\(\) first"):
            operation()


# ------------------------------------------------------------------------------------------------ lengths and sides


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
