"""The boxes of a tree: of each node's children those of the points below, and empty where there is no child."""

import numpy as np
import pytest

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.search.point_forest import HEIGHTS, PointForest
from pointloom.kernels.search.point_tree import BUCKET, FAN, LEAF, SIDES, PointTree

COUNTS = [0, 1, LEAF, LEAF + 1, BUCKET, BUCKET + 1, FAN * BUCKET, FAN * BUCKET + 1, 64 * BUCKET + 9, 70_001]


def boxes_of_runs(points, run, slots):
    """(low, high) of consecutive runs of points, empty beyond the last, [slots, 3] each."""
    low, high = np.full((slots, 3), np.inf, np.float32), np.full((slots, 3), -np.inf, np.float32)
    for k in range(-(-len(points) // run)):
        part = points[k * run : (k + 1) * run]
        low[k], high[k] = part.min(axis=0), part.max(axis=0)
    return low, high


def check_levels(points, levels, root, boxes):
    run = LEAF
    for level in range(root + 1):
        records = max(1, -(-len(points) // (run * FAN)))
        sides = boxes[levels[level] * SIDES : (levels[level] + records) * SIDES].reshape(records, 2, 3, FAN)
        low, high = boxes_of_runs(points, run, records * FAN)
        np.testing.assert_array_equal(sides[:, 0].transpose(0, 2, 1).reshape(-1, 3), low)
        np.testing.assert_array_equal(sides[:, 1].transpose(0, 2, 1).reshape(-1, 3), high)
        run *= FAN
    assert run >= len(points)


@pytest.mark.parametrize("count", COUNTS)
def test_boxes_bound_their_points_and_contain_their_positions(device, count, rng):
    points = rng.normal(size=(count, 3)).astype(np.float32)
    points[rng.integers(0, max(count, 1), count // 20)] = np.nan
    tree = PointTree(upload(points, vec3, device))
    order = download(tree.order)[: tree.count]
    assert tree.count == np.isfinite(points).all(axis=1).sum()
    tree_points, behind = np.split(download(tree.points).reshape(-1, 3), [tree.count])
    assert len(behind) == -tree.count % 8 and np.isinf(behind).all()
    np.testing.assert_array_equal(tree_points, points[order].reshape(-1, 3))
    check_levels(tree_points, download(tree.levels), tree.root, download(tree.boxes))


def test_boxes_of_a_forest_are_those_of_each_tree(device, rng):
    clouds = [rng.normal(size=(count, 3)).astype(np.float32) for count in (5, 70, FAN * BUCKET + 1, 1)]
    forest = PointForest([upload(cloud, vec3, device) for cloud in clouds])
    levels, roots = download(forest.levels).reshape(-1, HEIGHTS), download(forest.roots)
    forest_points, first = download(forest.clouds.points).reshape(-1, 3), forest.clouds.bases
    for k, cloud in enumerate(clouds):
        check_levels(forest_points[first[k] : first[k] + len(cloud)], levels[k], roots[k], download(forest.boxes))
