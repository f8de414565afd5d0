"""What filters leave to be seen, alone and with clip planes, and how values are counted."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.drawing.viewer.tools.clip_planes import Clip, hidden_points
from pointloom.drawing.viewer.tools.filters import Filter, column_in_world, filters_of, take_census


def cloud_of(rng, count=500, **more):
    points = rng.uniform(-1, 1, (count, 3)) + np.array([412_345.0, 5_412_345.0, 300.0])
    values = rng.normal(size=count)
    values[::7] = np.nan
    labels = rng.integers(0, 5, count).astype(np.uint8)
    return loom.PointCloud(points, intensity=values, classification=labels, **more)


def test_values_in_a_range_are_seen_and_those_without_one_as_told():
    values = [np.nan, -1.0, 0.5, 1.0, np.inf, 2.0]
    assert Filter("v", 0.5, 1.0).keep(values).tolist() == [True, False, True, True, True, False]
    assert Filter("v", 0.5, 1.0, missing=False).keep(values).tolist() == [False, False, True, True, False, False]
    assert Filter("v", missing=False).cuts and not Filter("v").cuts and Filter("v").keep(values).all()


def test_ticked_classes_are_seen():
    labels = np.array([0, 2, 2, 6, -1], np.int16)
    assert Filter("class", classes=frozenset({2, -1})).keep(labels).tolist() == [False, True, True, False, True]
    assert not Filter("class", classes=frozenset()).keep(labels).any() and Filter("class", classes=frozenset()).cuts
    assert Filter("classification", classes=frozenset({2, 6})).in_words() == "ground, building"


def test_filters_and_planes_hide_together(rng, device):
    cloud = cloud_of(rng).to(device)
    rules = Filter("intensity", -0.5, 0.7), Filter("classification", classes=frozenset({1, 4})), Filter("none", 9.0)
    clip = Clip(low=[412_345.0, -np.inf, -np.inf], high=[np.inf] * 3, filters=rules)
    points, values, labels = cloud.points, cloud["intensity"], cloud["classification"]
    with np.errstate(invalid="ignore"):
        in_range = np.isnan(values) | ((values >= -0.5) & (values <= 0.7))
    expected = (points[:, 0] >= 412_345) & in_range & np.isin(labels, [1, 4])
    np.testing.assert_array_equal(hidden_points(cloud, clip).numpy() == 0, expected)
    some = rng.permutation(500)[:60]
    np.testing.assert_array_equal(clip.keeper(None, cloud)(points[some], some), expected[some])
    assert 20 < expected.sum() < 120 and clip.cuts and clip.planes_cut and not Clip(filters=rules).planes_cut


def test_heights_are_those_of_the_world(rng):
    cloud = cloud_of(rng)
    pose = np.eye(4)
    pose[:3, :3], pose[2, 3] = [[0, 0, 1], [0, 1, 0], [-1, 0, 0]], 7.0
    heights = column_in_world(cloud, "height", pose)
    np.testing.assert_allclose(heights, 7 - cloud.points[:, 0])
    middle = float(np.median(heights))
    clip = Clip(filters=(Filter("height", middle),))
    np.testing.assert_array_equal(hidden_points(cloud, clip, pose=pose).numpy() == 1, heights < middle)


def test_a_census_counts_all_points(rng):
    cloud = cloud_of(rng)
    found = take_census("intensity", [cloud["intensity"], cloud["intensity"][:10]])
    assert found.total == 510 and found.missing == np.isnan(cloud["intensity"]).sum() + 2
    assert found.counts.sum() + found.missing == 510 and found.kind == "values" and len(found.counts) == 64
    classes = take_census("classification", [cloud["classification"]])
    assert classes.kind == "classes" and sum(classes.classes.values()) == 500 and classes.names()[2] == "ground"
    assert take_census("gps_time", [np.arange(200.0)]).kind == "times"
    assert take_census("ring", [np.arange(200)]).kind == "values"
    assert filters_of(cloud) == ["intensity", "classification", "height", "y", "x"]


@pytest.mark.parametrize("values", [[], [np.nan], [3.0, 3.0], [0.0], [1e300, -1e300], [5_412_345.25] * 3])
def test_a_census_has_ends_whatever_the_values(values):
    found = take_census("v", [np.array(values, np.float64)])
    assert found.low < found.high and found.counts.sum() + found.missing == len(values)


def test_few_values_far_away_leave_the_bars_to_the_others(rng):
    values = np.append(rng.normal(size=20_000), [1e6, -1e6])
    found = take_census("v", [values])
    assert -6 < found.low < -2 and 2 < found.high < 6 and found.counts.sum() == 20_002


@pytest.mark.parametrize("given", [{"low": 2.0, "high": 1.0}, {"low": np.nan}, {"high": -np.inf, "low": 0}])
def test_rules_that_make_no_sense_are_refused(given):
    with pytest.raises(ValueError, match="low"):
        Filter(**{"by": "v", **given})


def test_nodes_of_a_large_cloud_are_filtered_by_the_numbers_of_their_points(rng):
    cloud = loom.PointCloud(rng.random((20_000, 3)), intensity=rng.random(20_000))
    tree = loom.DetailTree.from_cloud(cloud)
    keep = Clip(high=[0.7, np.inf, np.inf], filters=(Filter("intensity", 0.25),)).keeper(None, cloud)
    kept = np.zeros(20_000, bool)
    for number in range(len(tree)):
        rows = tree.node(number).indices
        kept[rows] = keep(tree.points_of(number), rows)
    np.testing.assert_array_equal(kept, (cloud["intensity"] >= 0.25) & (cloud.points[:, 0] <= 0.7))
