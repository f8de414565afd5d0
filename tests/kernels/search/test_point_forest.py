"""A forest over one cloud is the same from the cloud's tree as from its points."""

import numpy as np
import pytest

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.search.point_forest import PointForest
from pointloom.kernels.search.point_tree import BUCKET, FAN, PointTree


@pytest.mark.parametrize("count", [1, 5, BUCKET, BUCKET + 1, BUCKET * FAN + 3, 20_011])
def test_a_tree_that_is_known_gives_the_same_forest(device, rng, count):
    values = np.float32(rng.normal(size=(count, 3)))
    values[3::11] = np.nan
    points = upload(values, vec3, device)
    rebuilt, from_tree = PointForest([points]), PointForest([points], PointTree(points))
    for name in ("points", "order", "owners", "starts", "first_positions", "finite_counts", "codes"):
        arrays = [download(getattr(forest.clouds, name)) for forest in (rebuilt, from_tree)]
        np.testing.assert_array_equal(*arrays)
    for name in ("bucket_counts", "levels", "roots"):
        np.testing.assert_array_equal(download(getattr(rebuilt, name)), download(getattr(from_tree, name)))
    boxes = download(rebuilt.boxes)
    np.testing.assert_array_equal(boxes, download(from_tree.boxes)[: boxes.size])
    curves = [(list(f.clouds.curve.low), f.clouds.curve.scale, f.clouds.curve.levels) for f in (rebuilt, from_tree)]
    assert curves[0] == curves[1]


def test_clouds_without_finite_points_have_empty_trees(device):
    invalid = upload(np.full((3, 3), np.nan, np.float32), vec3, device)
    forest = PointForest([invalid], PointTree(invalid))
    assert forest.clouds.counts.tolist() == [0] and (download(forest.clouds.order) == -1).all()
