"""Down-sampling: Open3D's voxels, means and traces, thinning, every k-th point, random and farthest points."""

import math
from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels import memory
from pointloom.kernels.lang import float32, uint8
from pointloom.kernels.scenes.color_noise import measure_colors
from pointloom.kernels.scenes.depth_noise import measure_depth

from .any_cloud import INTEGERS, NOT_FINITE, clouds, examples, parts, real
from .full_clouds import full_cloud
from .open3d_clouds import cloud_of


def numbered(rng, device):
    """A cloud with every kind of attribute, far from zero, and its row indices."""
    cloud = full_cloud(rng, device, shift=np.array([5e5, 5.4e6, 100]))
    cloud["row"] = np.arange(len(cloud))
    return cloud


def assert_contains_rows(result, cloud, rows):
    assert (result.origin == cloud.origin).all() and len(result) == len(rows)
    for name in ("points", "normals", "colors", *cloud.attributes):
        assert result[name].dtype == cloud[name].dtype
        np.testing.assert_array_equal(result[name], cloud[name][rows])


def open3d_trace(o3d, points, normals, colors, *arguments):
    cloud, cubes, rows = cloud_of(o3d, points, normals, colors).voxel_down_sample_and_trace(*arguments)
    names = ("points", "normals", "colors")
    means = {name: np.asarray(getattr(cloud, name)) for name in names}
    return means, np.asarray(cubes), [list(indices) for indices in rows]


def test_traces_of_a_made_cloud_are_open3ds(device, rng, oracle, tolerances):
    points, colors = (rng.random((300, 3)).astype(np.float32).astype(float) for _ in range(2))
    normals = rng.normal(size=(300, 3)).astype(np.float32).astype(float)
    cloud = loom.PointCloud(points, normals=normals, colors=colors, device=device)
    box = 0.3, np.array([0.1, -0.2, 0.3]), np.array([0.9, 1, 1])
    expected, cubes, lists = oracle("pcd/sampling/trace", open3d_trace, points, normals, colors, *box)
    trace = cloud.voxel_down_sample_and_trace(*box)
    result, cubic_id, original_indices = trace
    rows = {int(indices[0]): row for row, indices in enumerate(original_indices)}
    assert len(original_indices) == len(lists) == len(result)
    order = [rows[indices[0]] for indices in lists]
    for row, indices in zip(order, lists, strict=True):
        assert original_indices[row].tolist() == list(indices)
        assert (trace.voxel_of_point[original_indices[row]] == row).all()
    assert cubic_id.dtype == np.int32
    np.testing.assert_array_equal(cubic_id[order], cubes)
    actual = result.points[order] - result.origin
    np.testing.assert_allclose(actual, expected["points"], rtol=0, atol=tolerances.voxel_mean)
    for name in ("normals", "colors"):
        np.testing.assert_allclose(result[name][order], expected[name], rtol=0, atol=tolerances.voxel_attribute)


def brute_trace(points, size, corner):
    """Voxels in ascending order as lists of rows, and the last row in each octant, by a dictionary."""
    voxels: dict[tuple, list[int]] = {}
    for row in np.flatnonzero(np.isfinite(points).all(axis=1)):
        voxels.setdefault(tuple(np.floor((points[row] - corner) / size).tolist()), []).append(int(row))
    cubes = np.full((len(voxels), 8), -1)
    lists = [voxels[cell] for cell in sorted(voxels)]
    for voxel, rows in enumerate(lists):
        for row in rows:
            position = (points[row] - corner) / size
            cubes[voxel, int((position - np.floor(position) >= 0.5) @ [1, 2, 4])] = row
    return lists, cubes


SMALL = clouds(INTEGERS, parts(4, 8), real(5), NOT_FINITE, st.just(900.0), max_size=30)


@examples(25)
@given(points=SMALL, size=st.sampled_from([0.25, 1.0, 100.0]), corner=st.tuples(*[st.sampled_from([-1e6, 0, 0.3])] * 3))
def test_any_small_cloud_is_traced_as_a_dictionary_traces_it(device, points, size, corner):
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


def test_a_trace_without_bounds_has_the_voxels_of_voxel_down_sample(device, rng):
    cloud = numbered(rng, device)
    trace, plain = cloud.voxel_down_sample_and_trace(3.0), cloud.voxel_down_sample(3.0)
    assert_contains_rows(trace.cloud, plain, np.arange(len(plain)))
    assert len(trace) == 3 and repr(trace) == f"VoxelTrace(200 points in {len(plain)} voxels)"


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
        rank_of = {tuple(color): rank for rank, color in enumerate(ranked.tolist())}
        assert tuple(trace.cloud.colors[voxel].tolist()) == min(counts, key=lambda c: (-counts[c], rank_of[c]))
    np.testing.assert_array_equal(trace.cloud["wide"], plain["wide"])
    np.testing.assert_array_equal(trace.cloud["time"], plain["time"])


def test_the_most_frequent_label_and_color_represent_a_voxel(device, rng):
    points = (rng.random((500, 3)) * 3).astype(np.float32)
    palette = rng.permutation(np.array([[0, 0, 0], [0, 0.5, 0], [0, 0.5, 1], [1, 0, 0]]))
    color, label, height = palette[rng.integers(0, 4, 500)], rng.integers(-2, 3, 500), rng.random(500)
    cloud = loom.PointCloud(points, colors=color, label=label, height=height, device=device)
    small = cloud.voxel_down_sample(1.0, reduction="most_frequent")
    cells = np.floor((points.astype(np.float64) - points.min(axis=0).astype(np.float64) + 0.5) / 1.0)
    keys, voxels = np.unique(cells, axis=0, return_inverse=True)
    assert len(small) == len(keys) and max(np.bincount(voxels.ravel())) > 10
    ties = 0
    for k in range(len(keys)):
        rows = voxels.ravel() == k
        counts = Counter(label[rows].tolist())
        ties += sum(count == max(counts.values()) for count in counts.values()) > 1
        assert small["label"][k] == min(counts, key=lambda value: (-counts[value], value))
        colors = Counter(map(tuple, color[rows].tolist()))
        assert tuple(small.colors[k].tolist()) == min(colors, key=lambda value: (-colors[value], value))
        np.testing.assert_allclose(small.points[k], points[rows].astype(np.float64).mean(axis=0), atol=1e-6)
        assert small["height"][k] == pytest.approx(height[rows].mean(), abs=1e-12)
    assert ties > 2
    order = rng.permutation(500)
    again = cloud.select_by_index(order).voxel_down_sample(1.0, reduction="most_frequent")
    np.testing.assert_array_equal(again["label"], small["label"])
    np.testing.assert_array_equal(again.colors, small.colors)
    assert len(loom.PointCloud(device=device).voxel_down_sample(1.0, "most_frequent")) == 0


def test_nearest_point_represents_its_voxel_with_all_attributes(device, rng):
    cloud = numbered(rng, device)
    local = cloud.points - cloud.origin
    lists, _ = brute_trace(local, 3.0, local.min(axis=0) - 1.5)
    rows = [group[((local[group] - local[group].mean(axis=0)) ** 2).sum(axis=1).argmin()] for group in lists]
    assert max(map(len, lists)) > 5
    assert_contains_rows(cloud.voxel_down_sample(3.0, reduction="nearest"), cloud, rows)


def test_first_of_equally_near_points_represents_its_voxel(device):
    points = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0.0], [1, 0, 0]])
    points = np.vstack([points, [[np.nan, 0, 0]], points + 100])[:-1]
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    assert cloud.voxel_down_sample(10.0, "nearest")["row"].tolist() == [0, 6]
    assert len(loom.PointCloud(device=device).voxel_down_sample(1.0, "nearest")) == 0


@pytest.mark.parametrize("step", [1, 2, 7, 200, 10**6])
def test_every_kth_point_is_selected(device, step, rng):
    cloud = numbered(rng, device)
    result = cloud.uniform_down_sample(step)
    assert_contains_rows(result, cloud, np.arange(0, 200, step))
    assert len(loom.PointCloud(device=device).uniform_down_sample(step)) == 0


@pytest.mark.parametrize(("ratio", "count"), [(0, 0), (0.001, 0), (0.29, 57), (0.5, 100), (0.999999, 199), (1, 200)])
def test_a_random_choice_has_open3ds_size_and_keeps_the_order(device, ratio, count, rng):
    cloud = numbered(rng, device)
    result = cloud.random_down_sample(ratio, seed=5)
    rows = result["row"]
    assert (np.diff(rows) > 0).all()
    assert_contains_rows(result, cloud, rows)
    assert len(result) == count
    np.testing.assert_array_equal(cloud.random_down_sample(ratio, seed=5)["row"], rows)
    choices = {tuple(cloud.random_down_sample(ratio, seed=seed)["row"]) for seed in (0, 1, 2, 2**31 - 1)}
    assert len(choices) == 4 or count in (0, 199, 200), "another seed is another choice"
    assert len(loom.PointCloud(device=device).random_down_sample(ratio)) == 0


def surface_samples(device, seed, count):
    return loom.TriangleMesh.create_plane(1.0, 1.0, device=device).sample_points_uniformly(count, seed=seed).points


def depth_of_noise(device, seed, count):
    away, facing = (memory.upload(np.full(count, value, np.float32), float32, device) for value in (2.0, 1.0))
    return measure_depth(away, facing, 100, count // 100, seed=seed, frame=0).numpy()[:, None]


def color_of_noise(device, seed, count):
    gray = memory.upload(np.full(count, 128, np.uint8), uint8, device)
    return measure_colors(gray, sigma=8.0, seed=seed, frame=0).numpy()[:, None].astype(float)


def first_choice(device, seed, count):
    rows = loom.PointCloud(np.zeros((4 * count, 3)), row=np.arange(4 * count), device=device)
    return rows.random_down_sample(0.25, seed=seed)["row"][:, None]


@pytest.mark.parametrize("make", [surface_samples, depth_of_noise, color_of_noise, first_choice])
@pytest.mark.parametrize("seed", [0, 7])
def test_a_random_choice_is_independent_of_random_numbers_of_its_seed(device, make, seed):
    """Mean and variance of the chosen values are within 5 standard deviations of those of all."""
    values = np.asarray(make(resolve_device(device), seed, 20_000), float)
    cloud = loom.PointCloud(np.zeros((len(values), 3)), row=np.arange(len(values)), device=device)
    chosen = values[cloud.random_down_sample(0.04, seed=seed)["row"]]
    deviation = values.std(axis=0)
    moves = deviation > 1e-9  # a plane has one coordinate in common
    scores = ((values - values.mean(axis=0)) / np.where(moves, deviation, 1.0))[:, moves]
    picked = ((chosen - values.mean(axis=0)) / np.where(moves, deviation, 1.0))[:, moves]
    bound = 5 / math.sqrt(len(picked))
    assert (np.abs(picked.mean(axis=0)) < bound).all()
    assert (np.abs((picked**2).mean(axis=0) - 1) < bound * (scores**2).std(axis=0)).all()


def plain_choice(points, count, start):
    """The algorithm in float32 on the stored coordinates."""
    distances = np.where(np.isfinite(points).all(axis=1), np.float32(np.inf), np.float32(-1))
    chosen = []
    while len(chosen) < count:
        chosen.append(start)
        with np.errstate(invalid="ignore"):
            distances = np.fmin(distances, ((points - points[start]) ** 2).sum(axis=1))
        start = int(np.argmax(distances))
        if distances[start] <= 0:
            break
    return chosen


@examples(30)
@given(points=SMALL.filter(lambda p: np.isfinite(p).all(axis=1).any()), fraction=st.floats(0, 1))
def test_farthest_points_of_small_clouds_agree_with_the_plain_algorithm(device, points, fraction):
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    start = int(np.flatnonzero(np.isfinite(points).all(axis=1))[-1])
    samples = int(fraction * (len(points) - 1))
    expected = plain_choice(points.astype(np.float32), samples, start)
    assert cloud.farthest_point_indices(samples, start).tolist() == expected
    assert cloud.farthest_point_down_sample(samples, start)["row"].tolist() == sorted(expected)


def open3d_choices(o3d, points, counts):
    cloud = cloud_of(o3d, points)
    return [np.asarray(cloud.farthest_point_down_sample(count).points) for count in counts]


@pytest.mark.filterwarnings("ignore:num_samples. expected . points, got")  # of repeated positions
def test_farthest_points_of_made_clouds_are_open3ds(device, rng, oracle):
    """Repeated positions count once; there are no near-ties, for which float32 and float64 differ."""
    repeated = np.array([[0, 0, 0], [0, 0, 0], [1, 0, 0], [1, 0, 0], [2, 0, 0.0]])
    random = rng.random((500, 3)).astype(np.float32).astype(float)
    for name, points, counts in (("repeated", repeated, range(6)), ("random", random, (1, 50, 120))):
        cloud = loom.PointCloud(points, device=device)
        expected = oracle(f"pcd/sampling/farthest-{name}", open3d_choices, points, counts)
        for count, chosen in zip(counts, expected, strict=True):
            np.testing.assert_array_equal(cloud.farthest_point_down_sample(count).points, chosen)
    assert loom.PointCloud(repeated, device=device).farthest_point_indices(5).tolist() == [0, 4, 2]
    assert loom.PointCloud(np.ones((9, 3)), device=device).farthest_point_indices(8, 4).tolist() == [4]


def test_requesting_all_points_returns_the_finite_ones(device):
    cloud = loom.PointCloud([[0, 0, 0], [np.nan, 0, 0], [1, 1, 1], [1, 1, 1]], device=device, row=np.arange(4))
    with pytest.warns(UserWarning, match="num_samples: expected 4 points, got 3, because"):
        assert cloud.farthest_point_down_sample(4)["row"].tolist() == [0, 2, 3]
    with pytest.warns(UserWarning, match="num_samples: expected 3 points, got 2, because"):
        assert cloud.farthest_point_indices(3).tolist() == [0, 2]
    assert len(loom.PointCloud(device=device).farthest_point_down_sample(0)) == 0
    assert len(cloud.farthest_point_down_sample(0, 99)) == 0


UTM = np.array([5e5, 5.4e6, 100.0])


def brute(cloud, spacing, corner):
    positions = (cloud.points - cloud.origin).astype(np.float32).astype(np.float64) - (np.array(corner) - cloud.origin)
    best = {}
    for row, position in enumerate(positions):
        if not np.isfinite(position).all():
            continue
        cell = np.floor(position / spacing)
        off = (((position / spacing - cell) - 0.5) ** 2).sum()
        if off < best.get(tuple(cell), (np.inf, 0))[0]:
            best[tuple(cell)] = (off, row)
    return sorted(row for _, row in best.values())


@pytest.mark.parametrize(("at", "corner"), [(np.zeros(3), (0.3, -7.1, 2e3)), (UTM, (0, 0, 0))], ids=["here", "in UTM"])
def test_each_cell_keeps_one_point_unchanged(device, rng, at, corner):
    points = np.round(rng.random((3000, 3)) * (10, 10, 2), 1) + at
    points[::100] = np.nan
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    thinned = cloud.thin(0.7, corner)
    assert thinned["row"].tolist() == brute(cloud, 0.7, corner)
    np.testing.assert_array_equal(thinned.points, cloud.points[thinned["row"]])
    assert thinned.thin(0.7, corner)["row"].tolist() == thinned["row"].tolist()


def test_parts_cut_between_cells_thin_like_the_full_cloud(device, rng):
    points = rng.random((4000, 3)) * (8, 8, 1) + UTM
    full = loom.PointCloud(points, origin=UTM, device=device, row=np.arange(len(points)))
    left = full.points[:, 0] < UTM[0] + 4.0
    parts = [full.select_by_mask(mask).thin(0.5) for mask in (left, ~left)]
    rows = np.sort(np.concatenate([np.asarray(part["row"]) for part in parts]))
    assert rows.tolist() == full.thin(0.5)["row"].tolist()


@settings(max_examples=30, deadline=None)
@given(st.lists(st.tuples(*[st.integers(-6, 6)] * 3), max_size=30), st.sampled_from([0.5, 1.0, 3.0]))
def test_any_small_cloud_is_thinned_as_a_dictionary_thins_it(positions, spacing):
    cloud = loom.PointCloud(np.array(positions, np.float64).reshape(-1, 3) / 2, row=np.arange(len(positions)))
    assert cloud.thin(spacing)["row"].tolist() == brute(cloud, spacing, (0, 0, 0))


def matched(actual, expected, limit):
    """Rows of `actual` in the order of `expected`; each must be within `limit` [m] of its counterpart."""
    assert len(actual) == len(expected)
    distances, rows = cKDTree(actual).query(expected)
    assert distances.max() <= limit, distances.max()
    assert len(np.unique(rows)) == len(rows)
    return rows


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # a warning is correct for such a length
@pytest.mark.parametrize("size", [0.02, 0.05, 0.1, 0.5, 10.0])
def test_the_fragments_voxels_and_means_are_open3ds(device, size, fragment, to_open3d, tolerances):
    cloud = loom.PointCloud(fragment.points, normals=fragment.normals, colors=fragment.colors, device=device)
    result = cloud.voxel_down_sample(size)
    expected = to_open3d(fragment.points, cloud.normals, cloud.colors).voxel_down_sample(size)
    rows = matched(result.points, np.asarray(expected.points), np.sqrt(3) * tolerances.voxel_mean)
    limit = tolerances.voxel_attribute
    np.testing.assert_allclose(result.colors[rows], np.asarray(expected.colors), rtol=0, atol=limit)
    np.testing.assert_allclose(result.normals[rows], np.asarray(expected.normals), rtol=0, atol=limit)
    if size >= 0.1:
        assert np.linalg.norm(result.normals, axis=1).min() < 0.9, "means of normals are not made unit again"


def brute_force(points, size):
    """Voxels in ascending order and the rows of each, by float64 arithmetic on the stored coordinates."""
    finite = points[np.isfinite(points).all(axis=1)]
    return brute_trace(points, size, finite.min(axis=0) - size / 2)[0] if len(finite) else []


def test_floating_attributes_are_averaged_and_others_taken_from_the_first_point(device, rng):
    points = (rng.random((400, 3)) * 4 - 2).astype(np.float32)
    attributes = {
        "time": rng.random(400) + 1.7e9, "pair": rng.random((400, 2)).astype(np.float32),
        "half": rng.random(400).astype(np.float16), "label": rng.integers(-9, 9, 400), "flag": rng.random(400) < 0.5,
        "code": rng.integers(0, 255, (400, 2)).astype(np.uint8),
    }  # fmt: skip
    result = loom.PointCloud(points, device=device, **attributes).voxel_down_sample(1.0)
    groups = brute_force(points.astype(float), 1.0)
    assert len(result) == len(groups) < 200
    for name, values in attributes.items():
        assert result[name].dtype == values.dtype
        if values.dtype.kind == "f":
            rows = [np.atleast_2d(values[g].astype(float).T) for g in groups]
            means = np.array([[math.fsum(column) / len(column) for column in part] for part in rows])
            expected = means.reshape(len(groups), *values.shape[1:]).astype(values.dtype)
            actual, wanted = result[name].astype(float), expected.astype(float)
            np.testing.assert_allclose(actual, wanted, rtol=np.finfo(values.dtype).eps)
        else:
            np.testing.assert_array_equal(result[name], [values[g[0]] for g in groups])


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # a warning is correct for such a length
def test_means_are_summed_in_double_precision(device, rng):
    """30,000 points near 9,999 m: a float32 sum would be off by meters, a mean by centimeters."""
    points = (9999 + rng.random((30_000, 3)) * 0.5).astype(np.float32).astype(np.float64)
    result = loom.PointCloud(points, device=device).voxel_down_sample(10.0)
    np.testing.assert_allclose(result.points, points.mean(axis=0)[None], rtol=6.1e-8)


@pytest.mark.parametrize("axis", range(3))
def test_an_axis_may_have_more_than_2_to_the_20_cells(device, axis, rng):
    points = rng.random((600, 3)).astype(np.float32)
    points[:, axis] = (rng.integers(0, 2**23, 600) - 2**22) / np.float32(512)
    points[1::2] = points[::2]
    cloud = loom.PointCloud(points, device=device)
    assert np.ptp(points[:, axis]) / 0.001 > 2**22
    result = cloud.voxel_down_sample(0.001)
    groups = brute_force(cloud.points, 0.001)
    assert len(result) == len(groups) <= 300
    np.testing.assert_array_equal(result.points, [cloud.points[g].mean(axis=0).astype(np.float32) for g in groups])


def open3d_voxels(o3d, points, size, *vectors):
    cloud = cloud_of(o3d, points, *vectors).voxel_down_sample(size)
    return [np.asarray(getattr(cloud, name)) for name in ("points", "normals", "colors")]


def test_voxels_of_a_made_cloud_are_open3ds_also_at_utm_coordinates(device, rng, oracle, tolerances):
    utm = np.array([501234.0, 5412345.0, 212.0])
    points = rng.random((600, 3)) * [50, 50, 5]
    vectors = {"normals": rng.normal(size=(600, 3)), "colors": rng.random((600, 3))}
    cloud = loom.PointCloud(points + utm, device=device, **vectors)
    result, centered = cloud.voxel_down_sample(10.0), cloud.points - utm  # as stored: float32 about the origin
    expected = oracle("pcd/voxel_down_sample/uniform", open3d_voxels, centered, 10.0, cloud.normals, cloud.colors)
    rows = matched(result.points - utm, expected[0], tolerances.position / 100)
    for name, values in zip(("normals", "colors"), expected[1:], strict=True):
        np.testing.assert_allclose(result[name][rows], values, rtol=0, atol=tolerances.voxel_attribute)


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # a warning is correct for such a length
def test_a_voxel_larger_than_the_cloud_gives_its_mean(device, rng):
    points = rng.random((100, 3)).astype(np.float32)
    for size in (10.0, 1e30, 1e300):
        result = loom.PointCloud(points, device=device).voxel_down_sample(size).points
        np.testing.assert_allclose(result, points.astype(float).mean(axis=0)[None], rtol=6.1e-8)


@examples(30)
@given(
    points=clouds(INTEGERS, real(5), NOT_FINITE, st.sampled_from([900.0, 1e-20])),
    size=st.sampled_from([0.01, 0.5, 1.0, 100.0]),
)
def test_any_small_cloud_is_averaged_as_numpy_averages(device, points, size):
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)), time=np.arange(len(points)) * 1.5)
    result, groups = cloud.voxel_down_sample(size), brute_force(cloud.points, size)
    assert result["row"].tolist() == [g[0] for g in groups]
    np.testing.assert_allclose(result["time"], [np.mean(g) * 1.5 for g in groups], rtol=1e-15)
    means = np.array([cloud.points[g].sum(axis=0) / len(g) for g in groups]).reshape(-1, 3)
    np.testing.assert_array_equal(result.points, means.astype(np.float32))
