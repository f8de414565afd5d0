"""Region growing: equal to a plain loop over the same neighbors, independent of order, and PCL's where unambiguous."""

import numpy as np
import pytest

import pointloom as loom


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
