"""Consistent orientation: Kruskal's algorithm, Open3D's rule, known surfaces, and the disagreement of normals."""

import warnings
from contextlib import nullcontext
from functools import cache
from itertools import combinations

import numpy as np
import pytest
import scipy.sparse as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse.csgraph import breadth_first_order, minimum_spanning_tree
from scipy.spatial import Delaunay, cKDTree

import pointloom as loom
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.search.point_tree import PointTree

from ..scan_cases import on_sets
from .any_cloud import examples
from .orientation import agreement, orient, random_signs, sphere


def row_sums(a):
    return a[..., 0] + a[..., 1] + a[..., 2]  # in this order, as the kernels sum


def listed_neighbors(points, units, k, cos_alpha_tol, outliers):
    """[n, k] by distance, ties by index; excluded neighbors are replaced by the point itself."""
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
    """The rule in NumPy, quadratic; vertices are ranks on the tree's curve, which breaks ties."""
    usable = np.flatnonzero(np.isfinite(points).all(axis=1) & np.isfinite(normals).all(axis=1))
    oriented = normals.copy()
    if not len(usable):
        return oriented
    rows = usable[download(PointTree(upload(points[usable], vec3, "cpu")).order)]
    positions, exact = points[rows], normals[rows].astype(float)
    sizes = np.sqrt(row_sums(exact * exact))
    units = (exact / np.where(sizes > 0, sizes, 1)[:, None]).astype(np.float32)
    cosines = row_sums(units[:, None].astype(float) * units[None].astype(float))
    labels, signs = np.arange(len(rows)), np.ones(len(rows))

    def join(u, v):
        if labels[u] != labels[v]:
            part = labels == labels[v]
            signs[part] *= (-1.0 if cosines[u, v] < 0 else 1.0) * signs[u] * signs[v]
            labels[part] = labels[u]

    lists = listed_neighbors(positions, units, min(k, len(rows)), cos_alpha_tol, outliers)
    starts = np.repeat(np.arange(len(rows)), lists.shape[1])
    weights = (1 - np.abs(cosines[starts, lists.ravel()])).astype(np.float32).clip(0)
    for entry in np.argsort(weights, kind="stable"):
        join(starts[entry], lists.flat[entry])
    u, v = np.triu_indices(len(rows), 1)
    d = positions[v] - positions[u]
    for pair in np.argsort(row_sums(d * d), kind="stable"):
        join(u[pair], v[pair])
    low = np.flatnonzero(positions[:, 2] == positions[:, 2].min())
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
@examples(15)
def test_signs_follow_the_minimum_spanning_tree(device, cloud, k):
    """With duplicates, all kinds of ties, zero normals, and non-finite points and normals."""
    points, normals = cloud
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "k: .* join each of the", UserWarning)
        result = orient(points, normals, k, device)
    np.testing.assert_array_equal(result, orient_by_kruskal(points, normals, k))


@pytest.mark.parametrize(("k", "warns"), [(58, False), (59, True), (60, True), (500, True)])
def test_neighbors_that_join_all_points_warn(device, rng, k, warns):
    outward = ball(60)
    cloud = loom.PointCloud(outward, normals=random_signs(rng, outward), device=device)
    expected = (
        pytest.warns(UserWarning, match=f"^k: {k} neighbors join each of the 60 points") if warns else nullcontext()
    )
    with expected:
        _ = cloud.orient_normals_consistent_tangent_plane(k)


def test_a_direction_of_length_zero_is_none(device):
    cloud = loom.PointCloud(np.zeros((2, 3)), normals=np.eye(3)[:2], device=device)
    with pytest.raises(ValueError, match=r"^orientation_reference: expected a direction, got \[0\.0, 0\.0, 0\.0\]"):
        cloud.orient_normals_to_align_with_direction([0, 0, 0])


@pytest.mark.parametrize("options", [(0.5, 1.0), (0.0, 0.6), (0.5, 0.8)], ids=str)
def test_steep_and_outlying_neighbors_are_left_out(device, rng, options):
    penalty, steepest = options
    changed = penalty > 0  # the effect of outliers is tested on a thin wall below
    for k in (3, 8, 20):
        points, normals = rng.normal(size=(2, 120, 3)).astype(np.float32) ** 3
        result = orient(points, normals, k, device, lambda_penalty=penalty, cos_alpha_tol=steepest)
        np.testing.assert_array_equal(result, orient_by_kruskal(points, normals, k, steepest, penalty > 0))
        changed |= not np.array_equal(result, orient(points, normals, k, device))
    assert changed, "the options matter on such clouds"


def torus(rng, count):
    u, v = rng.uniform(0, 2 * np.pi, (2, count))
    outward = np.stack([np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)], axis=1)
    return np.stack([np.cos(u), np.sin(u), 0 * u], axis=1) * 2 + 0.7 * outward, outward


def nested(rng, count):
    parts = [sphere(rng, count // 2), sphere(rng, count // 2, 2.0)]
    return np.concatenate([p for p, _ in parts]), np.concatenate([n for _, n in parts])


@pytest.mark.parametrize("surface", [sphere, torus, nested])
def test_normals_of_closed_surfaces_point_outward(device, surface, rng):
    points, outward = surface(rng, 4000)
    result = orient(points, random_signs(rng, outward), 12, device)
    np.testing.assert_array_equal(result, outward.astype(np.float32))
    fitted = loom.PointCloud(points, device=device).estimate_normals(max_nn=12)
    assert agreement(fitted.orient_normals_consistent_tangent_plane(12).normals, outward) == 1.0


def thin_wall(half, spacing):
    """Points and outward normals of a round plate of radius 1 with a round rim."""
    steps = np.arange(-1, 1, spacing)
    xy = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    xy = xy[(xy**2).sum(axis=1) < 1]
    faces = [np.column_stack([xy, np.full(len(xy), side)]) for side in (-half, half)]
    angle, tilt = np.meshgrid(np.arange(0, 2 * np.pi, spacing), np.linspace(-np.pi / 2, np.pi / 2, 7))
    angle, tilt = angle.ravel(), tilt.ravel()
    rim = np.stack([np.cos(angle) * np.cos(tilt), np.sin(angle) * np.cos(tilt), np.sin(tilt)], axis=1)
    points = np.concatenate([*faces, np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1) + half * rim])
    return points, np.concatenate([np.tile([0, 0, side], (len(xy), 1)) for side in (-1.0, 1.0)] + [rim])


@pytest.mark.parametrize("options", [{"cos_alpha_tol": 0.5}, {"lambda_penalty": 1.0}], ids=str)
def test_faces_of_a_thin_wall_are_separated_by_excluding_neighbors_across(device, options, rng):
    """The faces are 4 cm apart and their points 3 cm: one of ten neighbors is on the other face."""
    points, outward = thin_wall(0.02, 0.03)
    normals = random_signs(rng, outward)
    assert agreement(orient(points, normals, 10, device), outward) < 0.9
    assert agreement(orient(points, normals, 10, device, **options), outward) == 1.0


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
def test_duplicates_terminate(device, rng, k):
    """More copies of a point than k: all its neighbors are copies."""
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
        result = orient(points[:count].reshape(-1, 3), normals[:count].reshape(-1, 3), k, device)
        np.testing.assert_array_equal(result, normals[:count] * np.array(expected, np.float32).reshape(-1, 1))


def pairs(edges):
    return np.unique(np.sort(edges, axis=1), axis=0)


def spanning_tree(count, edges, weights):
    tree = minimum_spanning_tree(sp.csr_matrix((weights + 1e-12, (edges[:, 0], edges[:, 1])), shape=(count, count)))
    return tree + tree.T


def without(edges, others):
    keys, forbidden = (e[:, 0].astype(np.int64) * 2**32 + e[:, 1] for e in (edges, others))
    return edges[~np.isin(keys, forbidden)]


def orient_along(points, normals, edges):
    """Open3D's rule on a given graph."""
    weights = 1 - np.abs((normals[edges[:, 0]] * normals[edges[:, 1]]).sum(axis=1))
    low = int(points[:, 2].argmin())
    order, before = breadth_first_order(spanning_tree(len(points), edges, weights.clip(0)), low, directed=False)
    signs = np.zeros(len(points))
    signs[low] = -1 if normals[low, 2] > 0 else 1
    for v in order[1:]:
        signs[v] = signs[before[v]] * (1 if normals[v] @ normals[before[v]] >= 0 else -1)
    return normals * signs[:, None]


FRAGMENT = pytest.param("fragment", marks=pytest.mark.slow)


@pytest.fixture(scope="module")
def scans(fragment, lidar, terrain, o3d, to_open3d):
    """Points and float32 normals of an indoor scan, a LiDAR frame and a centered terrain tile, all thinned."""
    arrays = {}
    for name, points, voxel in (
        ("fragment", fragment.points, 0.03),
        ("lidar", lidar[:, :3], 0.3),
        ("terrain", terrain - np.round(terrain.mean(axis=0)), 3.0),
    ):
        cloud = to_open3d(points).voxel_down_sample(voxel)
        cloud.points = o3d.utility.Vector3dVector(np.asarray(cloud.points).astype(np.float32))
        cloud.estimate_normals(o3d.geometry.KDTreeSearchParamKNN(20))
        arrays[name] = (np.asarray(cloud.points), np.asarray(cloud.normals).astype(np.float32).astype(float))
    return arrays


@pytest.fixture(scope="module")
def oracle(scans, to_open3d):
    """A function (scan, k) -> Open3D's normals, computed once."""

    @cache
    def orient_scan(scan, k):
        cloud = to_open3d(*scans[scan])
        _ = cloud.orient_normals_consistent_tangent_plane(k)
        return np.asarray(cloud.normals)

    return orient_scan


@pytest.fixture(scope="module")
def graphs(scans):
    """A function (scan, k) -> edges of the complete graph, of Open3D's graph, and of the k nearest neighbors."""

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
        complete, reduced = (pairs(np.concatenate([tree, e])) for e in (nearest, without(nearest, delaunay)))
        return complete, reduced, nearest

    return make_graphs


@pytest.mark.parametrize("k", [6, 15, 30, 100])
def test_orientation_of_the_fragment_is_open3ds(device, k, scans, oracle, tolerances):
    assert agreement(orient(*scans["fragment"], k, device), oracle("fragment", k)) >= tolerances.orientation_fraction


@on_sets("scan", shipped=("terrain", FRAGMENT), real=("lidar", FRAGMENT))
@pytest.mark.parametrize("k", [15, pytest.param(30, marks=pytest.mark.slow)])
def test_orientation_follows_open3ds_rule_on_the_complete_graph(device, scan, k, scans, oracle, graphs, tolerances):
    """Open3D omits neighbors that are edges of its Delaunay tetrahedra but not of its Euclidean tree.

    Where normals are noisy, as in trees and on distant LiDAR rings, this flips whole patches. Its rule on its graph
    gives its result; the same rule on all neighbors gives pointloom's.
    """
    complete, reduced, nearest = graphs(scan, k)
    assert len(complete) - len(reduced) > 0.1 * len(nearest)
    expected = orient_along(*scans[scan], reduced)
    assert agreement(expected, oracle(scan, k)) >= tolerances.orientation_fraction
    result = orient(*scans[scan], k, device)
    assert agreement(result, orient_along(*scans[scan], complete)) >= tolerances.orientation_fraction


def ball(count: int, seed: int = 0) -> np.ndarray:
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return points / np.linalg.norm(points, axis=1, keepdims=True)


def by_hand(points: np.ndarray, normals: np.ndarray, k: int) -> float:
    """The rule in float64, pair by pair."""
    neighbors = cKDTree(points).query(points, k=k + 1)[1][:, 1:]
    counted = opposed = 0
    for i, near in enumerate(neighbors):
        for j in near:
            n, m, way = normals[i], normals[j], points[j] - points[i]
            if abs(n @ m) < 0.5 * np.linalg.norm(n) * np.linalg.norm(m):
                continue
            if abs(way @ n) > np.sqrt(0.5) * np.linalg.norm(way) * np.linalg.norm(n):
                continue
            counted += n @ m != 0
            opposed += n @ m < 0
    return opposed / counted


@pytest.mark.parametrize("k", [1, 6, 15])
def test_fraction_follows_the_rule(device, rng, k):
    points = rng.random((400, 3)).astype(np.float32)
    normals = (rng.normal(size=(400, 3)) * rng.uniform(0.1, 3, (400, 1))).astype(np.float32)
    cloud = loom.PointCloud(points, normals=normals, device=device)
    assert cloud.normal_disagreement(k) == pytest.approx(by_hand(points.astype(float), normals.astype(float), k))


def test_agreement_is_zero_and_random_signs_are_a_half(device, rng):
    points = ball(2000)
    cloud = loom.PointCloud(points, normals=points, device=device)
    assert cloud.normal_disagreement() == 0
    assert loom.PointCloud(points, normals=-points, device=device).normal_disagreement() == 0
    signs = rng.choice([-1, 1], (2000, 1))
    assert 0.45 < loom.PointCloud(points, normals=points * signs, device=device).normal_disagreement() < 0.55


def test_seam_between_two_patches_is_detected_and_orienting_removes_it(device):
    points = ball(2000)
    cloud = loom.PointCloud(points, normals=points * np.sign(points[:, :1]), device=device)
    assert 0.02 < cloud.normal_disagreement() < 0.1
    assert cloud.orient_normals_consistent_tangent_plane(10).normal_disagreement() == 0


def test_edges_of_a_box_and_the_two_sides_of_a_wall_do_not_count(device, rng):
    side = np.stack(np.meshgrid(np.linspace(0, 1, 12), np.linspace(0, 1, 12), [0]), -1).reshape(-1, 3)
    wall = np.concatenate([side, np.add(side, [0, 0, 0.01])])
    outward = np.repeat([[0, 0, -1.0], [0, 0, 1.0]], len(side), axis=0)
    assert loom.PointCloud(wall, normals=outward, device=device).normal_disagreement(1) == 0
    corner = np.concatenate([side, side[:, [2, 0, 1]]])
    normals = np.repeat([[0, 0, 1.0], [-1.0, 0, 0]], len(side), axis=0)
    assert loom.PointCloud(corner, normals=normals, device=device).normal_disagreement() == 0


@pytest.mark.parametrize("count", [0, 1, 2])
def test_tiny_clouds_have_no_disagreement(device, count):
    points = ball(3)[:count]
    assert loom.PointCloud(points, normals=points, device=device).normal_disagreement(30) == 0
