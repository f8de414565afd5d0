"""Clusters equal to Open3D's and to brute force for every eps and threshold, and regions of smooth surfaces."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse.csgraph import connected_components
from scipy.spatial.distance import cdist

import pointloom as loom
from pointloom.kernels import lang
from pointloom.kernels.search import tree_walk
from pointloom.kernels.segmentation import cluster_labels, dbscan

from ..scan_cases import on_sets
from .any_cloud import INTEGERS, NOT_FINITE, clouds, examples, parts
from .nearest_oracle import sphere
from .open3d_clouds import cloud_of


def brute_dbscan(points, eps, min_points):
    """Labels by the definition, from all distances in float64."""
    labels = np.full(len(points), -1)
    finite = np.flatnonzero(np.isfinite(points).all(axis=1))
    if not len(finite):
        return labels
    near = cdist(points[finite], points[finite], "sqeuclidean") < float(eps) * float(eps)
    core = near.sum(axis=1) >= min_points
    if not core.any():
        return labels
    _, component = connected_components(near[np.ix_(core, core)], directed=False)
    _, first = np.unique(component, return_index=True)
    number = np.argsort(np.argsort(first))
    result = np.full(len(finite), -1)
    result[core] = number[component]
    reached = np.where(near[:, core], result[core], len(points)).min(axis=1)
    result[~core] = np.where(reached < len(points), reached, -1)[~core]
    labels[finite] = result
    return labels


def by_size(labels, min_size=1, max_size=10**9):
    """Labels renumbered by decreasing cluster size, ties in their order; -1 for other sizes."""
    sizes = np.bincount(labels[labels >= 0])
    selected = [k for k in np.argsort(-sizes, kind="stable") if min_size <= sizes[k] <= max_size]
    renamed = np.full(len(sizes) + 1, -1)
    renamed[selected] = np.arange(len(selected))
    return renamed[labels]


def float32_exact(points):
    return np.asarray(points, np.float32).astype(np.float64)


def dbscan_of(o3d, points, eps, min_points):
    return np.asarray(cloud_of(o3d, points).cluster_dbscan(eps, min_points))


FRAGMENT_CASES = [(0.02, 10), (0.01, 5), (0.006, 4)]


@on_sets("eps min_points", shipped=FRAGMENT_CASES, real=[*FRAGMENT_CASES, (0.05, 200)])
def test_labels_of_the_fragment_are_open3ds(device, eps, min_points, fragment, o3d):
    points = fragment.points if (eps, min_points) == (0.02, 10) else fragment.points[::2]
    labels = loom.PointCloud(points, device=device).cluster_dbscan(eps, min_points)
    expected = dbscan_of(o3d, points, eps, min_points)
    assert labels.dtype == np.int32 and expected.max() >= 0
    np.testing.assert_array_equal(labels, expected)


@pytest.mark.parametrize(("eps", "min_points"), [(0.05, 2), (0.5, 10), (3.0, 100), (20.0, 600)])
def test_labels_of_a_lidar_scan_are_open3ds(device, eps, min_points, lidar, o3d):
    points = lidar[:: 1 if eps < 3 else 5, :3].astype(np.float64)  # Open3D's lists take a minute at 20 m
    labels = loom.PointCloud(points, device=device).cluster_dbscan(eps, min_points)
    expected = dbscan_of(o3d, points, eps, min_points)
    assert (expected < 0).any() and expected.max() >= 0
    np.testing.assert_array_equal(labels, expected)


MADE = {
    "uniform": lambda rng: rng.random((3003, 3)),
    "surface": lambda rng: sphere(rng, 3003),
    "density": lambda rng: sphere(rng, 2001) * np.exp(rng.uniform(0, np.log(1000), (2001, 1))) / 100,
    "blobs": lambda rng: np.repeat(rng.random((41, 3)), 75, axis=0) + rng.normal(size=(3075, 3)) * 0.015,
    "duplicates": lambda rng: rng.permutation(np.repeat(rng.random((600, 3)), 5, axis=0)),
}
LIMITS = [(0.05, 4), (0.12, 20), (0.4, 100), (0.4, 1)]


def open3d_labels(o3d, points):
    return [dbscan_of(o3d, points, *limits).astype(np.int16) for limits in LIMITS]


@pytest.mark.parametrize("shape", MADE)
def test_labels_of_made_clouds_are_open3ds(device, shape, rng, oracle):
    points = float32_exact(MADE[shape](rng))
    cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
    for limits, expected in zip(LIMITS, oracle(f"pcd/clusters/{shape}", open3d_labels, points), strict=True):
        np.testing.assert_array_equal(cloud.cluster_dbscan(*limits), expected)


@examples(40)
@given(
    points=clouds(INTEGERS, parts(4, 40), NOT_FINITE, max_size=50),
    copies=st.integers(1, 4),
    eps=st.sampled_from([0.25, 1.0, np.nextafter(1.0, 2), 1.25, 2.0, 5.0, 30.0]),
    min_points=st.sampled_from([1, 2, 3, 5, 10, 60, 201]),
    min_size=st.integers(1, 3),
)
@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # if all points are noise
def test_any_small_cloud_has_the_labels_of_the_definition(device, points, copies, eps, min_points, min_size):
    """On a lattice of quarters squared distances are exact in float32, including ties with eps."""
    points = np.tile(points, (copies, 1))
    cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
    expected = brute_dbscan(points, eps, min_points)
    np.testing.assert_array_equal(cloud.cluster_dbscan(eps, min_points), expected)
    chained = by_size(brute_dbscan(points, eps, 1), min_size, 20)
    labels = cloud.cluster_euclidean(eps, min_size, 20)
    np.testing.assert_array_equal(labels, chained)
    assert labels.dtype == cloud.cluster_dbscan(eps, min_points).dtype == np.int32


@pytest.mark.parametrize(
    ("eps", "min_points"), [(0.07, 1), (0.07, 2), (0.2, 30), (0.5, 2), (0.5, 700), (0.9, 30), (0.9, 1203), (0.9, 1204)]
)
@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # if all points are noise
def test_labels_match_the_definition_for_every_radius_and_threshold(device, eps, min_points, rng):
    points = float32_exact(np.concatenate([rng.random((700, 3)), rng.random((503, 3)) * 0.2 + [1.3, 0, 0]]))
    labels = loom.PointCloud(points, device=device).cluster_dbscan(eps, min_points)
    np.testing.assert_array_equal(labels, brute_dbscan(points, eps, min_points))


def test_a_border_point_takes_the_lowest_label_and_joins_no_clusters(device):
    row = np.array([10, 11, 12, 13, -3, -2, -1, 0, 5], float)  # 5 is between the ends of two rows
    points = np.column_stack([row, row * 0, row * 0])
    labels = loom.PointCloud(points, device=device).cluster_dbscan(5.5, 4)
    assert labels.tolist() == [0, 0, 0, 0, 1, 1, 1, 1, 0]
    reversed_labels = loom.PointCloud(points[::-1], device=device).cluster_dbscan(5.5, 4)
    assert reversed_labels.tolist() == [0, 0, 0, 0, 0, 1, 1, 1, 1]


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # if all points are noise
def test_a_hundred_thousand_equal_points_are_one_cluster_or_noise(device):
    cloud = loom.PointCloud(np.full((100_000, 3), 0.3), device=device)
    for eps, min_points, label in ((1e-300, 1, 0), (1.0, 100_000, 0), (1e200, 100_000, 0), (1e-9, 100_001, -1)):
        assert (cloud.cluster_dbscan(eps, min_points) == label).all()


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # a warning is correct for such a length
@pytest.mark.parametrize("eps", [0.6, 1e200])
def test_an_eps_of_the_size_of_the_cloud_takes_no_time(device, eps, rng):
    """30,000 points with thousands of neighbors each: neighbor lists would need gigabytes."""
    cloud = loom.PointCloud(rng.random((30_000, 3)), device=device)
    assert (cloud.cluster_dbscan(eps, 2500) == 0).all()
    assert (cloud.cluster_dbscan(eps, 30_001) == -1).all()


def test_duplicate_blobs_farther_than_eps_do_not_join(device, rng):
    """Five balls of 4,000 points, each smaller than eps, in a row 1.01 eps apart, and one that touches the fifth."""
    balls = [np.repeat(sphere(rng, 40) * 0.01, 100, axis=0) + np.array([1.03 * k, 0, 0]) for k in range(5)]
    balls.append(balls[4] + [0.5, 0.5, 0])
    points = float32_exact(np.concatenate(balls))
    shuffle = rng.permutation(len(points))
    labels = loom.PointCloud(points[shuffle], device=device).cluster_dbscan(1.0, 4000)
    kinds = np.minimum(np.repeat(np.arange(6), 4000)[shuffle], 4)
    _, first = np.unique(kinds, return_index=True)
    np.testing.assert_array_equal(labels, np.argsort(np.argsort(first))[kinds])


def test_a_long_chain_is_one_cluster_until_a_link_is_missing(device, rng):
    angles = np.linspace(0, 40 * np.pi, 30_000)
    points = np.column_stack([angles * np.cos(angles), angles * np.sin(angles), 0 * angles])
    step = np.linalg.norm(np.diff(points, axis=0), axis=1).max() * 1.001
    order = rng.permutation(len(points))
    cloud = loom.PointCloud(points[order], device=device)
    assert (cloud.cluster_dbscan(step, 2) == 0).all() and (cloud.cluster_euclidean(step) == 0).all()
    remaining = np.arange(len(points)) != 29_000
    broken = loom.PointCloud(points[order][remaining[order]], device=device)
    labels = broken.cluster_euclidean(step)
    np.testing.assert_array_equal(labels, (order[remaining[order]] > 29_000).astype(int))


def test_memory_is_linear_and_small(device, rng, monkeypatch):
    """14 B per point beside the tree, even if each point has ten thousand neighbors."""
    cloud = loom.PointCloud(rng.random((40_000, 3)), device=device)
    made = []

    def counting(make):
        def counted(*arguments):
            made.append(make(*arguments))
            return made[-1]

        return counted

    for module in (cluster_labels, dbscan, tree_walk):
        for name in ("empty", "full", "zeros"):
            if hasattr(module, name):
                monkeypatch.setattr(module, name, counting(getattr(module, name)))
    cloud.cluster_dbscan(0.4, 10)
    assert 0 < sum(a.size * lang.wp.types.type_size_in_bytes(a.dtype) for a in made) < 15 * len(cloud)


def grown_plainly(cloud, degrees, limit, min_size, max_nn):
    """Regions by a queue over lists, as documented; labels in the order of size."""
    points, normals = cloud.points, cloud.normals.astype(np.float32)
    near = loom.NearestNeighborSearch(cloud).knn_search(cloud, max_nn)[0].reshape(len(points), -1)
    curvature = loom.estimate_curvature(cloud, max_nn=max_nn)["curvature"]
    small, cosine = curvature < limit, np.cos(np.radians(degrees))
    links = [set() for _ in points]
    for i, row in enumerate(near):
        for j in row:
            if small[i] and small[j] and abs(normals[i] @ normals[j]) >= cosine:
                links[i].add(j)
                links[j].add(i)
    labels = np.full(len(points), -1)
    for first in np.flatnonzero(small):
        queue = [first] if labels[first] < 0 else []
        while queue:
            i = queue.pop()
            if labels[i] < 0:
                labels[i] = first
                queue.extend(links[i])
    grown = labels.copy()
    for i in np.flatnonzero(~small):
        facing = [(abs(normals[i] @ normals[j]), -k, j) for k, j in enumerate(near[i]) if small[j]]
        facing = [one for one in facing if one[0] >= cosine]
        if facing:
            grown[i] = labels[max(facing)[2]]
    heads, counts = np.unique(grown[grown >= 0], return_counts=True)
    ranked = sorted(zip(-counts, heads, strict=True))
    order = [head for count, head in ranked if -count >= min_size]
    return np.array([order.index(label) if label in order else -1 for label in grown])


def room(rng, noise=0.003):
    x, y = rng.random((2, 1500))
    floor = np.column_stack([x, y, 0 * x])
    wall = np.column_stack([0 * x, x, y])[:750]
    d = rng.normal(size=(500, 3))
    ball = 0.2 * d / np.linalg.norm(d, axis=1)[:, None] + [0.6, 0.5, 0.5]
    points = np.vstack([floor, wall, ball])
    return points + noise * rng.normal(size=points.shape)


@pytest.mark.parametrize(("degrees", "limit", "max_nn"), [(5.0, 0.02, 20), (12.0, 0.005, 12), (30.0, 0.3, 10)])
def test_regions_agree_with_a_plain_loop(device, rng, degrees, limit, max_nn):
    cloud = loom.PointCloud(room(rng), device=device).estimate_normals(max_nn=20)
    labels = cloud.region_growing(degrees, limit, 20, max_nn=max_nn)
    np.testing.assert_array_equal(labels, grown_plainly(cloud, degrees, limit, 20, max_nn))


def test_a_floor_a_wall_and_a_ball_are_three_regions_the_largest_first(device, rng):
    cloud = loom.PointCloud(room(rng, 0.0) + np.array([5e5, 5.4e6, 0]), device=device).estimate_normals(max_nn=15)
    labels = cloud.region_growing(12.0, 0.02, 150, max_nn=15)
    assert labels.dtype == np.int32 and labels.max() == 2
    for label, part in enumerate((slice(0, 1500), slice(1500, 2250), slice(2250, 2750))):
        assert (labels[part] == label).mean() > 0.9
    assert (np.diff(np.bincount(labels[labels >= 0])) <= 0).all()


def test_labels_go_with_the_points_in_any_order(device, rng):
    """The result does not depend on a first seed: a shuffled cloud without ties has the same regions."""
    cloud = loom.PointCloud(room(rng), device=device).estimate_normals(max_nn=20)
    order = rng.permutation(len(cloud))
    labels = cloud.region_growing(8.0, 0.02, 30, max_nn=12)
    shuffled = cloud.select_by_index(order).region_growing(8.0, 0.02, 30, max_nn=12)
    np.testing.assert_array_equal(labels[order], shuffled)


def test_sizes_choose_regions_and_do_not_split_them(device, rng):
    cloud = loom.PointCloud(room(rng, 0.0), device=device).estimate_normals(max_nn=15)
    sizes = np.bincount(1 + cloud.region_growing(12.0, 0.02, 150, max_nn=15))[1:]
    left = cloud.region_growing(12.0, 0.02, 150, int(sizes[0]) - 1, max_nn=15)
    assert np.bincount(1 + left)[1:].tolist() == sizes[1:].tolist()


def test_bad_clouds_have_no_region(device):
    for points in (np.zeros((0, 3)), np.full((60, 3), np.nan), np.ones((60, 3)), np.eye(3)):
        normals = np.tile([0.0, 0.0, 1.0], (len(points), 1))
        labels = loom.PointCloud(points, normals=normals, device=device).region_growing()
        assert labels.tolist() == [-1] * len(points)
