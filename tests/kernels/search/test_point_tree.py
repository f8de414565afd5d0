"""The search tree: a curve that visits every cell once and next to the last, and boxes that hold their points."""

import itertools

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.bounds import bound_points
from pointloom.kernels.lang import array, int32, int64, kernel, launch, tid, vec3
from pointloom.kernels.memory import download, empty, upload, zeros
from pointloom.kernels.search.bucket_walk import next_bucket, start_traversal
from pointloom.kernels.search.hilbert_order import (
    HilbertCurve,
    HilbertOrder,
    argsort_along,
    hilbert_codes,
    lanes,
    order_in_box,
    spread_bits,
)
from pointloom.kernels.search.neighbor_keys import keep_nearest, sort_keys, thin_keys
from pointloom.kernels.search.point_tree import BUCKET, FAN, LEAF, PointTree
from pointloom.kernels.search.tree_search import squared_radius


@kernel
def encode_cells_kernel(cells: array(dtype=int32), levels: int, codes: array(dtype=int64)):
    i = tid()
    found = hilbert_codes(lanes(cells[3 * i]), lanes(cells[3 * i + 1]), lanes(cells[3 * i + 2]), levels)
    codes[i] = found[i % 8]


@kernel
def spread_kernel(values: array(dtype=int32), spread: array(dtype=int64)):
    i = tid()
    spread[i] = spread_bits(values[i])


@kernel
def keep_kernel(keys: array(dtype=int64), held: int, k: int, room: int, kept: array(dtype=int32)):
    i = tid()
    kept[i] = keep_nearest(keys, i * (room + k), 1, held, k, room)


@kernel
def thin_kernel(keys: array(dtype=int64), held: int, k: int, reach: float, kept: array(dtype=int32)):
    i = tid()
    kept[i] = thin_keys(keys, 0, 1, held, k, reach) + i


@kernel
def sort_rows_kernel(keys: array(dtype=int64), size: int):
    i = tid()
    sort_keys(keys, i * size, 1, size)


def codes_of(device, cells, levels):
    codes = empty(len(cells), int64, resolve_device(device))
    launch(encode_cells_kernel, len(cells), [upload(cells.reshape(-1), int32, resolve_device(device)), levels, codes])
    return codes.numpy()


def levels_of(tree):
    """(first, last) node of each level from the leaves up."""
    firsts = tree.levels.numpy()
    return list(itertools.pairwise(firsts.tolist()))


@pytest.mark.parametrize("levels", [1, 2, 4])
def test_the_curve_visits_every_cell_once_and_steps_to_a_neighbor(device, levels):
    side = 2**levels
    cells = np.stack(np.meshgrid(*[np.arange(side)] * 3, indexing="ij"), -1).reshape(-1, 3).astype(np.int32)
    codes = codes_of(device, cells, levels)
    np.testing.assert_array_equal(np.sort(codes), np.arange(side**3))
    steps = np.abs(np.diff(cells[np.argsort(codes)], axis=0)).sum(axis=1)
    assert (steps == 1).all(), "neighbors on the curve are neighbors in space"


def test_codes_at_16_levels_are_distinct_and_fit_48_bits(device, rng):
    cells = np.unique(rng.integers(0, 2**16, (5000, 3)).astype(np.int32), axis=0)
    codes = codes_of(device, cells, 16)
    assert len(np.unique(codes)) == len(cells) and codes.min() >= 0 and codes.max() < 2**48


def test_bits_are_spread_by_two_zeros(device, rng):
    values = np.concatenate([[0, 1, 2**16 - 1], rng.integers(0, 2**16, 200)]).astype(np.int32)
    spread = empty(len(values), int64, resolve_device(device))
    launch(spread_kernel, len(values), [upload(values, int32, resolve_device(device)), spread])
    expected = [sum(((int(v) >> b) & 1) << (3 * b) for b in range(16)) for v in values]
    np.testing.assert_array_equal(spread.numpy(), expected)


@pytest.mark.parametrize("count", [0, 1, LEAF, LEAF + 1, 2 * LEAF, 3 * LEAF, 1003])
def test_the_order_holds_every_point_once_and_the_rest_last(device, count, rng):
    points = rng.normal(size=(count, 3)).astype(np.float32)
    points[::5, 0] = np.nan
    curve = HilbertOrder(upload(points, vec3, resolve_device(device)))
    order, codes = curve.order.numpy(), curve.codes.numpy()
    finite = np.isfinite(points).all(axis=1)
    assert curve.finite_count == finite.sum()
    np.testing.assert_array_equal(np.sort(order), np.arange(count))
    assert finite[order[: curve.finite_count]].all() and not finite[order[curve.finite_count :]].any()
    assert (np.diff(codes) >= 0).all()


def box(points):
    """The lowest and highest corner; an empty box where there is no point."""
    return points.min(axis=0, initial=np.inf), points.max(axis=0, initial=-np.inf)


@pytest.mark.parametrize("count", [0, 1, LEAF - 1, LEAF, LEAF + 1, BUCKET, BUCKET + 1, FAN * BUCKET + 1, 40_003])
def test_each_box_of_a_node_is_the_box_of_its_points_and_a_missing_child_is_empty(device, count, rng):
    points = rng.normal(size=(count, 3)).astype(np.float32)
    points[3::50] = np.nan
    tree = PointTree(upload(points, vec3, resolve_device(device)))
    held = tree.points.numpy()[: tree.count]
    assert tree.count == np.isfinite(points).all(axis=1).sum() == len(held)
    np.testing.assert_array_equal(held, points[tree.order.numpy()[: tree.count]])
    boxes = tree.boxes.numpy().reshape(-1, 2, 3, FAN).transpose(0, 3, 1, 2)
    size = LEAF
    for first, last in levels_of(tree):
        children = boxes[first:last].reshape(-1, 2, 3)
        assert len(children) * size >= tree.count
        for child, sides in enumerate(children):
            np.testing.assert_array_equal(sides, box(held[child * size : (child + 1) * size]))
        size *= FAN
    assert levels_of(tree)[-1][1] - levels_of(tree)[-1][0] == 1 and size >= tree.count


@pytest.mark.parametrize(("held", "k"), [(0, 3), (1, 3), (3, 3), (4, 3), (40, 7), (40, 40)])
def test_the_nearest_keys_are_kept_in_order(device, held, k, rng):
    room, rows = 48, 5
    keys = np.zeros((rows, room + k), np.int64)
    for row in keys:
        row[:held] = rng.permutation(2**40 + np.arange(held) * 2**33)
    array_, kept = upload(keys.reshape(-1), int64, resolve_device(device)), empty(rows, int32, resolve_device(device))
    launch(keep_kernel, rows, [array_, held, k, room, kept])
    left = min(held, k)
    assert (kept.numpy() == left).all()
    np.testing.assert_array_equal(array_.numpy().reshape(rows, -1)[:, :left], np.sort(keys[:, :held])[:, :left])


@pytest.mark.parametrize("spread", ["surface", "all at the reach", "all at zero"])
def test_thinning_never_loses_one_of_the_nearest(device, spread, rng):
    held, k, reach = 200, 20, 2.0
    squares = {"surface": rng.random(held) * reach, "all at the reach": np.full(held, reach)}.get(
        spread, np.zeros(held)
    )
    bits = squares.astype(np.float32).view(np.int32).astype(np.int64)
    keys = (bits << 32) | rng.permutation(held)
    array_, kept = upload(keys, int64, resolve_device(device)), empty(1, int32, resolve_device(device))
    launch(thin_kernel, 1, [array_, held, k, reach, kept])
    left = int(kept.numpy()[0])
    assert k <= left <= held
    np.testing.assert_array_equal(np.sort(array_.numpy()[:left])[:k], np.sort(keys)[:k])
    if spread == "surface":
        assert left < held / 2, "it does thin"


@pytest.mark.parametrize("size", [0, 1, 2, 3, 10, 257])
def test_rows_of_keys_are_sorted_in_place(device, size, rng):
    rows = 6
    keys = rng.integers(0, 2**62, (rows, max(size, 1)), dtype=np.int64)
    keys[1] = np.sort(keys[1])
    keys[2] = np.sort(keys[2])[::-1]
    keys[3] = 7
    array_ = upload(keys.reshape(-1), int64, resolve_device(device))
    launch(sort_rows_kernel, rows, [array_, size])
    expected = keys if size == 0 else np.sort(keys, axis=1)
    np.testing.assert_array_equal(array_.numpy().reshape(rows, -1), expected)


@pytest.mark.parametrize("radius", [1e-18, 0.1, 0.25, 1 / 3, 1.0, 2.0, 7e5, 1e18])
def test_the_reach_is_the_largest_float32_below_the_square(radius):
    reach = np.float32(squared_radius(radius))
    assert float(reach) < radius * radius <= float(np.nextafter(reach, np.float32(np.inf)))


def test_the_reach_of_extreme_radii_is_zero_or_the_largest_number():
    assert squared_radius(1e-200) == 0.0
    assert squared_radius(1e200) == squared_radius(1.7e308) == squared_radius(np.inf) == float(np.finfo(np.float32).max)


@kernel
def walk_kernel(start: int, reach: float, tree: PointTree, visits: array(dtype=int32)):
    i = tid()
    step = start_traversal(start + i)
    p = tree.points[start * BUCKET]
    while int(step[0]) <= tree.root:
        bucket = min(int(step[2]), visits.shape[0] - 1)
        visits[bucket] = visits[bucket] + 1
        step = next_bucket(step, p, p, reach, tree)


@pytest.mark.parametrize("count", [1, BUCKET + 1, 3 * BUCKET, FAN * BUCKET + 1, 10 * FAN * BUCKET + 1])
def test_a_walk_without_a_radius_comes_to_each_bucket_once_and_to_none_that_is_not_there(device, count, rng):
    tree = PointTree(upload(rng.normal(size=(count, 3)).astype(np.float32), vec3, resolve_device(device)))
    buckets = -(-count // BUCKET)
    for start in {0, buckets // 2, buckets - 1}:
        visits = zeros(buckets + 1, int32, resolve_device(device))
        launch(walk_kernel, 1, [start, squared_radius(np.inf), tree, visits])
        np.testing.assert_array_equal(visits.numpy(), [1] * buckets + [0])


@pytest.mark.parametrize("spread", [0.0, 1e-36, 1.0, 1e30])
def test_the_order_along_the_curve_does_not_depend_on_where_the_box_is_known(device, spread, rng):
    points = 3.0 * (spread < 1) + spread * rng.normal(size=(1_003, 3))
    points[::50] = np.nan
    given = upload(points, vec3, resolve_device(device))
    low, high, count = bound_points(given)
    expected = argsort_along(given, HilbertCurve(low, high, 10, is_empty=not count))[1]
    np.testing.assert_array_equal(download(order_in_box(given, 10)), download(expected))


def test_a_part_on_the_curve_of_the_whole_has_the_order_of_the_whole(device):
    points = np.round(np.random.default_rng(4).random((3000, 3)), 1).astype(np.float32)  # many at one place
    device = resolve_device(device)
    whole = HilbertOrder(upload(points, vec3, device))
    rows = np.flatnonzero((abs(points - 0.6) < 0.25).all(axis=1))
    part = download(PointTree(upload(points[rows], vec3, device), whole.curve).order)
    in_whole = download(whole.order)
    np.testing.assert_array_equal(rows[part], in_whole[np.isin(in_whole, rows)])
    own = download(PointTree(upload(points[rows], vec3, device)).order)
    assert not np.array_equal(own, part)
