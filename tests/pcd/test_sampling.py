"""Thinning a cloud: Open3D's voxels with their traces, every k-th, a random choice, the farthest from each other."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom


@pytest.fixture(scope="module")
def terrain(shipped_file):
    """A terrain tile at UTM coordinates: the cloud, and its float32 points about the origin, which the cloud holds."""
    cloud = loom.read_point_cloud(shipped_file("lidar-pcl-terrain/samp21-utm.pcd"))
    assert cloud.points.max() > 5e6
    return cloud, cloud.points - cloud.origin


def full_cloud(rng, device, count=200):
    """A cloud with every kind of attribute, far from zero."""
    return loom.PointCloud(
        rng.random((count, 3)) * 10 + [5e5, 5.4e6, 100], normals=rng.normal(size=(count, 3)),
        colors=rng.random((count, 3)), device=device, row=np.arange(count), time=rng.random(count) + 1.7e9,
        pair=rng.integers(0, 9, (count, 2)).astype(np.int16), flag=rng.random(count) < 0.5,
    )  # fmt: skip


def assert_holds_rows(result, cloud, rows):
    """The result is exactly these points of a cloud, with all their attributes."""
    assert (result.origin == cloud.origin).all() and len(result) == len(rows)
    for name in ("points", "normals", "colors", *cloud.attributes):
        assert result[name].dtype == cloud[name].dtype
        np.testing.assert_array_equal(result[name], cloud[name][rows])


# ------------------------------------------------------------------------------------------------ voxels with traces


def check_trace(trace, oracle, tolerances, limit):
    """The voxels, octants and means of Open3D's trace, whose order of voxels is open."""
    cloud, cubic_id, original_indices = trace
    expected, expected_cubes, expected_indices = oracle
    rows = {int(indices[0]): row for row, indices in enumerate(original_indices)}
    assert len(original_indices) == len(expected_indices) == len(cloud)
    order = [rows[indices[0]] for indices in expected_indices]
    for row, indices in zip(order, expected_indices, strict=True):
        assert original_indices[row].tolist() == list(indices)
        assert (trace.voxel_of_point[original_indices[row]] == row).all()
    assert cubic_id.dtype == np.int32
    np.testing.assert_array_equal(cubic_id[order], expected_cubes)
    found = cloud.points[order] - cloud.origin
    np.testing.assert_allclose(found, np.asarray(expected.points), rtol=0, atol=limit)
    for name in ("normals", "colors"):
        if name in cloud:
            values = np.asarray(getattr(expected, name))
            np.testing.assert_allclose(cloud[name][order], values, rtol=0, atol=tolerances.voxel_attribute)


@pytest.mark.parametrize("size", [0.05, 0.5])
def test_traces_of_the_fragment_are_open3ds(device, size, fragment, to_open3d, tolerances):
    every = slice(None, None, 3)
    points, normals, colors = fragment.points[every], fragment.normals[every], fragment.colors[every]
    cloud = loom.PointCloud(points, normals=normals, colors=colors, device=device)
    low, high = np.array([0.3, -0.2, 1.0]), points.max(axis=0)
    oracle = to_open3d(points, cloud.normals, cloud.colors).voxel_down_sample_and_trace(size, low, high)
    trace = cloud.voxel_down_sample_and_trace(size, low, high)
    assert (points < low).any(), "the bounds do not cut off points"
    check_trace(trace, oracle, tolerances, tolerances.voxel_mean)


def test_traces_of_a_lidar_scan_are_open3ds(device, lidar, to_open3d, tolerances):
    low = np.array([-100.0, -80, -20])
    oracle = to_open3d(lidar[:, :3]).voxel_down_sample_and_trace(0.4, low, -low)
    trace = loom.PointCloud(lidar[:, :3], device=device).voxel_down_sample_and_trace(0.4, low, -low)
    check_trace(trace, oracle, tolerances, tolerances.float32_relative * np.abs(lidar[:, :3]).max())


def test_traces_at_utm_coordinates_are_open3ds_at_the_origin(device, terrain, to_open3d, tolerances):
    cloud, centred = terrain
    low = np.array([-300.0, -300, -100])
    trace = cloud.to(device).voxel_down_sample_and_trace(2.5, cloud.origin + low)
    oracle = to_open3d(centred).voxel_down_sample_and_trace(2.5, low, -low)
    check_trace(trace, oracle, tolerances, tolerances.float32_relative * np.abs(centred).max())


def brute_trace(points, size, corner):
    """Voxels in ascending order, as lists of rows, and the last row in each octant, by a dictionary."""
    voxels: dict[tuple, list[int]] = {}
    for row in np.flatnonzero(np.isfinite(points).all(axis=1)):
        voxels.setdefault(tuple(np.floor((points[row] - corner) / size).tolist()), []).append(int(row))
    cubes = np.full((len(voxels), 8), -1)
    lists = [voxels[cell] for cell in sorted(voxels)]
    for voxel, rows in enumerate(lists):
        for row in rows:
            place = (points[row] - corner) / size
            cubes[voxel, int((place - np.floor(place) >= 0.5) @ [1, 2, 4])] = row
    return lists, cubes


number = st.one_of(
    st.integers(-3, 3).map(float),
    st.integers(-8, 8).map(lambda i: i / 4),
    st.floats(-5, 5, width=32, allow_subnormal=False),
    st.sampled_from([np.nan, np.inf, -np.inf, 900.0]),
)
clouds = st.lists(st.tuples(number, number, number), max_size=30).map(lambda p: np.array(p, float).reshape(-1, 3))


@settings(derandomize=True, deadline=None, max_examples=60)
@given(
    points=clouds, size=st.sampled_from([0.25, 1.0, 100.0]), corner=st.tuples(*[st.sampled_from([-1e6, 0, 0.3])] * 3)
)
def check_any_trace(device, points, size, corner):
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    trace = cloud.voxel_down_sample_and_trace(size, corner)
    lists, cubes = brute_trace(cloud.points, size, np.array(corner))
    assert [rows.tolist() for rows in trace.original_indices] == lists
    np.testing.assert_array_equal(trace.cubic_id.reshape(-1, 8), cubes)
    assert trace.cloud["row"].tolist() == [rows[0] for rows in lists]
    voxel_of_point = np.full(len(points), -1)
    for voxel, rows in enumerate(lists):
        voxel_of_point[rows] = voxel
    assert trace.voxel_of_point.tolist() == voxel_of_point.tolist()
    assert trace.offsets.tolist() == np.cumsum([0, *map(len, lists)]).tolist()


def test_any_small_cloud_is_traced_as_a_dictionary_traces_it(device):
    check_any_trace(device)


def test_a_trace_without_bounds_has_the_voxels_of_voxel_down_sample(device, rng):
    cloud = full_cloud(rng, device)
    trace, plain = cloud.voxel_down_sample_and_trace(3.0), cloud.voxel_down_sample(3.0)
    assert_holds_rows(trace.cloud, plain, np.arange(len(plain)))
    assert len(trace) == 3 and repr(trace) == f"VoxelTrace(200 points in {len(plain)} voxels)"


def test_a_trace_of_nothing_is_empty(device):
    for points in (np.zeros((0, 3)), np.full((4, 3), np.nan)):
        cloud, cubic_id, original_indices = loom.PointCloud(points, device=device).voxel_down_sample_and_trace(1.0)
        assert len(cloud) == 0 and cubic_id.shape == (0, 8) and original_indices == []


def test_classes_are_the_commonest_of_their_voxel(device, rng):
    points = (rng.random((600, 3)) * 3).astype(np.float32)
    palette = rng.random((5, 3))
    classes = rng.integers(0, 5, 600)
    attributes = {
        "wide": rng.integers(0, 3, (600, 2)), "label": rng.integers(-2, 2, 600).astype(np.int8),
        "flag": rng.random(600) < 0.5, "big": rng.integers(0, 3, 600) * 2**61, "time": rng.random(600),
    }  # fmt: skip
    cloud = loom.PointCloud(points, colors=palette[classes], device=device, **attributes)
    trace = cloud.voxel_down_sample_and_trace(1.0, [0, 0, 0], approximate_class=True)
    plain = cloud.voxel_down_sample_and_trace(1.0, [0, 0, 0]).cloud
    ranked = palette[np.lexsort(palette.T[::-1])].astype(np.float32)
    for voxel, rows in enumerate(trace.original_indices):
        for name in ("label", "flag", "big"):
            counts = Counter(attributes[name][rows].tolist())
            assert trace.cloud[name][voxel] == min(counts, key=lambda value: (-counts[value], value)), name
        counts = Counter(map(tuple, cloud.colors[rows].tolist()))
        places = {tuple(color): place for place, color in enumerate(ranked.tolist())}
        assert tuple(trace.cloud.colors[voxel].tolist()) == min(counts, key=lambda c: (-counts[c], places[c]))
    np.testing.assert_array_equal(trace.cloud["wide"], plain["wide"])
    np.testing.assert_array_equal(trace.cloud["time"], plain["time"])


def test_classes_are_open3ds_where_colours_are_0_or_1_and_keep_their_colour_elsewhere(device, to_open3d):
    points = np.array([[0, 0, 0], [0.1, 0, 0], [0.2, 0, 0], [5, 5, 5]])
    for grey, expected in ((1.0, 1.0), (0.5, 0.0)):
        colors = np.array([[0, 0, 0], [grey] * 3, [grey] * 3, [grey] * 3])
        found = loom.PointCloud(points, colors=colors, device=device).voxel_down_sample_and_trace(
            1.0, [0, 0, 0], [9, 9, 9], True
        )
        assert found.cloud.colors.tolist() == [[grey] * 3] * 2
        oracle, _, _ = to_open3d(points, colors=colors).voxel_down_sample_and_trace(
            1.0, np.zeros(3), np.full(3, 9.0), True
        )
        assert np.asarray(oracle.colors).tolist() == [[expected] * 3] * 2, "Open3D keeps the whole part of red"


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ((0,), ValueError, "voxel_size: expected a finite number > 0"),
        ((1, [0, 0]), ValueError, r"min_bound: expected shape \[3\], got \[2\]"),
        ((1, [0, 0, np.nan]), ValueError, "min_bound: expected finite numbers"),
        ((1, [0, 0, 0], [1, 2, np.inf]), ValueError, "max_bound: expected finite numbers"),
        (
            (1e-9, [0, 0, 0], [9, 9, 9]),
            ValueError,
            r"voxel_size: 1e-09 makes more than 2\^31 voxels between the bounds",
        ),
        ((1e-9, [1e9, 0, 0]), ValueError, r"voxel_size: 1e-09 puts more than 2\^53 voxels between min_bound and"),
        ((1e-8, [0, 0, 0]), ValueError, r"voxel_size: 1e-08 makes a grid of .* cells, more than 2\^62"),
    ],
)
def test_a_grid_that_is_none_is_refused(arguments, error, message):
    cloud = loom.PointCloud(np.array([[0, 0, 0], [1, 1, 1]]))
    with pytest.raises(error, match=message):
        cloud.voxel_down_sample_and_trace(*arguments)


# ------------------------------------------------------------------------------------------------ nearest


def nearest_rows(points, lists):
    rows = []
    for group in lists:
        sqdists = ((points[group] - points[group].mean(axis=0)) ** 2).sum(axis=1)
        rows.append(group[int(np.argmin(sqdists))])
    return rows


def test_the_nearest_point_stands_for_its_voxel_with_all_attributes(device, rng):
    cloud = full_cloud(rng, device)
    local = cloud.points - cloud.origin
    lists, _ = brute_trace(local, 3.0, local.min(axis=0) - 1.5)
    rows = nearest_rows(local, lists)
    assert max(map(len, lists)) > 5
    assert_holds_rows(cloud.voxel_down_sample(3.0, reduction="nearest"), cloud, rows)


def test_the_nearest_points_of_the_fragment_are_nearest_to_open3ds_means(device, fragment, to_open3d, tolerances):
    from scipy.spatial import cKDTree

    points = fragment.points[::4]
    found = loom.PointCloud(points, device=device).voxel_down_sample(0.1, "nearest").points
    means = np.asarray(to_open3d(points).voxel_down_sample(0.1).points)
    own = cKDTree(points)
    assert own.query(found)[0].max() == 0, "each is a point of the cloud"
    corner = points.min(axis=0) - 0.05
    cells = {
        tuple(cell): point for cell, point in zip(np.floor((found - corner) / 0.1).astype(int), found, strict=True)
    }
    assert len(cells) == len(found) == len(means)
    members: dict[tuple, list] = {}
    for cell, point in zip(np.floor((points - corner) / 0.1).astype(int), points, strict=True):
        members.setdefault(tuple(cell), []).append(point)
    by_mean = cKDTree([np.mean(group, axis=0) for group in members.values()])
    distances, which = by_mean.query(means)
    assert distances.max() < tolerances.voxel_mean, "the means are Open3D's"
    groups = list(members.items())
    for mean, place in zip(means, which, strict=True):
        cell, group = groups[place]
        least = np.linalg.norm(np.array(group) - mean, axis=1).min()
        assert np.linalg.norm(cells[cell] - mean) <= least + tolerances.voxel_mean


def test_of_equally_near_points_the_first_stands_for_its_voxel(device):
    points = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0.0], [1, 0, 0]])
    points = np.vstack([points, [[np.nan, 0, 0]], points + 100])[:-1]
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    assert cloud.voxel_down_sample(10.0, "nearest")["row"].tolist() == [0, 6]
    assert len(loom.PointCloud(device=device).voxel_down_sample(1.0, "nearest")) == 0
    with pytest.raises(ValueError, match="reduction: expected 'mean' or 'nearest', got 'median'"):
        cloud.voxel_down_sample(1.0, "median")


# ------------------------------------------------------------------------------------------------ uniform and random


@pytest.mark.parametrize("step", [1, 2, 7, 200, 10**6])
def test_every_kth_point_is_open3ds(device, step, rng, to_open3d):
    cloud = full_cloud(rng, device)
    found = cloud.uniform_down_sample(step)
    assert_holds_rows(found, cloud, np.arange(0, 200, step))
    np.testing.assert_array_equal(found.points, to_open3d(cloud.points).uniform_down_sample(step).points)
    assert len(loom.PointCloud(device=device).uniform_down_sample(step)) == 0


@pytest.mark.parametrize("ratio", [0, 0.001, 0.29, 0.5, 0.999999, 1, 1 / 3])
def test_a_random_choice_has_open3ds_size_and_keeps_the_order(device, ratio, rng, to_open3d):
    cloud = full_cloud(rng, device)
    found = cloud.random_down_sample(ratio, seed=5)
    rows = found["row"]
    assert (np.diff(rows) > 0).all()
    assert_holds_rows(found, cloud, rows)
    assert len(found) == len(to_open3d(cloud.points).random_down_sample(float(ratio)).points)
    np.testing.assert_array_equal(cloud.random_down_sample(ratio, seed=5)["row"], rows)
    assert len(loom.PointCloud(device=device).random_down_sample(ratio)) == 0


def test_another_seed_is_another_choice(device, rng):
    cloud = full_cloud(rng, device)
    choices = {tuple(cloud.random_down_sample(0.5, seed=seed)["row"]) for seed in (0, 1, 2, 2**31 - 1)}
    assert len(choices) == 4


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda c: c.uniform_down_sample(0), ValueError, "every_k_points: expected a whole number >= 1, got 0"),
        (lambda c: c.uniform_down_sample(2.5), TypeError, "every_k_points: expected a whole number, got 2.5"),
        (lambda c: c.random_down_sample(1.5), ValueError, "sampling_ratio: expected a share 0..1, got 1.5"),
        (lambda c: c.random_down_sample(-0.1), ValueError, "sampling_ratio: expected a finite number >= 0, got -0.1"),
        (lambda c: c.random_down_sample(np.nan), ValueError, "sampling_ratio: expected a finite number"),
        (lambda c: c.random_down_sample(0.5, seed=-1), ValueError, "seed: expected a whole number >= 0, got -1"),
        (lambda c: c.random_down_sample(0.5, seed=2**31), ValueError, r"seed: expected a whole number below 2\^31"),
        (lambda c: c.farthest_point_down_sample(4), ValueError, "num_samples: expected at most the cloud's 3 points"),
        (lambda c: c.farthest_point_down_sample(-1), ValueError, "num_samples: expected a whole number >= 0"),
        (lambda c: c.farthest_point_down_sample(2.0), TypeError, "num_samples: expected a whole number, got 2.0"),
        (lambda c: c.farthest_point_down_sample(2, 3), IndexError, "start_index: 3 reaches beyond a cloud of 3 points"),
        (lambda c: c.farthest_point_down_sample(2, -1), ValueError, "start_index: expected a whole number >= 0"),
        (lambda c: c.farthest_point_down_sample(2, 1), ValueError, r"got \[nan.* remove_non_finite_points\(\)"),
    ],
)
def test_a_choice_that_is_none_is_refused(call, error, message):
    with pytest.raises(error, match=message):
        call(loom.PointCloud([[0, 0, 0], [np.nan, 0, 0], [1, 1, 1]]))


# ------------------------------------------------------------------------------------------------ farthest points


@pytest.mark.parametrize("samples", [1, 50, 700])
def test_farthest_points_of_the_fragment_are_open3ds(device, samples, fragment, to_open3d):
    """Near-ties, where float32 and float64 choose differently, do not come up in this data."""
    points = fragment.points[::2]
    expected = to_open3d(points).farthest_point_down_sample(samples, 1234)
    found = loom.PointCloud(points, device=device).farthest_point_down_sample(samples, 1234)
    np.testing.assert_array_equal(found.points, np.asarray(expected.points))


def test_farthest_points_of_a_lidar_scan_are_open3ds(device, lidar, to_open3d):
    points = lidar[:, :3]
    expected = to_open3d(points).farthest_point_down_sample(2000)
    found = loom.PointCloud(points, device=device).farthest_point_down_sample(2000)
    np.testing.assert_array_equal(found.points, np.asarray(expected.points))


def test_farthest_points_at_utm_coordinates_are_open3ds_at_the_origin(device, terrain, to_open3d):
    cloud, centred = terrain
    expected = np.asarray(to_open3d(centred).farthest_point_down_sample(1000, 7).points)
    found = cloud.to(device).farthest_point_down_sample(1000, 7)
    np.testing.assert_array_equal(found.points - found.origin, expected)


def plain_choice(points, count, start):
    """The plain algorithm in float32 on what the cloud holds."""
    distances = np.where(np.isfinite(points).all(axis=1), np.float32(np.inf), np.float32(-1))
    chosen = []
    while len(chosen) < count:
        chosen.append(start)
        with np.errstate(invalid="ignore"):
            d = (points - points[start]) ** 2
        sqdists = (d[:, 0] + d[:, 1]) + d[:, 2]
        distances = np.where(sqdists < distances, sqdists, distances)
        start = int(np.argmax(distances))
        if distances[start] <= 0:
            break
    return chosen


@settings(derandomize=True, deadline=None, max_examples=80)
@given(points=clouds.filter(lambda p: np.isfinite(p).all(axis=1).any()), share=st.floats(0, 1))
def check_any_choice(device, points, share):
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    start = int(np.flatnonzero(np.isfinite(points).all(axis=1))[-1])
    samples = int(share * (len(points) - 1))
    expected = plain_choice(points.astype(np.float32), samples, start)
    assert cloud.farthest_point_indices(samples, start).tolist() == expected
    assert cloud.farthest_point_down_sample(samples, start)["row"].tolist() == sorted(expected)


def test_farthest_points_of_any_small_cloud_are_those_of_the_plain_algorithm(device):
    check_any_choice(device)


def test_a_longer_choice_begins_with_the_shorter(device, rng):
    cloud = full_cloud(rng, device)
    order = cloud.farthest_point_indices(150, 3)
    assert order[0] == 3 and len(set(order.tolist())) == 150
    np.testing.assert_array_equal(cloud.farthest_point_indices(40, 3), order[:40])
    assert_holds_rows(cloud.farthest_point_down_sample(40, 3), cloud, np.sort(order[:40]))


def test_repeated_positions_count_once_as_in_open3d(device, to_open3d):
    points = np.array([[0, 0, 0], [0, 0, 0], [1, 0, 0], [1, 0, 0], [2, 0, 0.0]])
    cloud, oracle = loom.PointCloud(points, device=device), to_open3d(points)
    for samples in range(6):
        expected = np.asarray(oracle.farthest_point_down_sample(samples).points)
        np.testing.assert_array_equal(cloud.farthest_point_down_sample(samples).points, expected)
    assert cloud.farthest_point_indices(5).tolist() == [0, 4, 2]
    assert loom.PointCloud(np.ones((9, 3)), device=device).farthest_point_indices(8, 4).tolist() == [4]


def test_asking_for_all_points_gives_the_finite_ones(device):
    cloud = loom.PointCloud([[0, 0, 0], [np.nan, 0, 0], [1, 1, 1], [1, 1, 1]], device=device, row=np.arange(4))
    assert cloud.farthest_point_down_sample(4)["row"].tolist() == [0, 2, 3]
    assert len(loom.PointCloud(device=device).farthest_point_down_sample(0)) == 0
    assert len(cloud.farthest_point_down_sample(0, 99)) == 0
