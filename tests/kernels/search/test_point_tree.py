"""The search tree: a curve through every cell between neighbors, and boxes that contain their points."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.bounds import bound_points
from pointloom.kernels.lang import array, int32, int64, kernel, launch, tid, vec3
from pointloom.kernels.memory import download, empty, upload, zeros
from pointloom.kernels.search import hilbert_order as hilbert
from pointloom.kernels.search.bucket_walk import next_bucket, start_traversal
from pointloom.kernels.search.hilbert_order import hilbert_codes, lanes
from pointloom.kernels.search.neighbor_keys import thin_keys
from pointloom.kernels.search.point_tree import BUCKET, FAN, LEAF, PointTree
from pointloom.kernels.search.tree_search import squared_radius


@kernel
def encode_cells_kernel(cells: array(dtype=int32), levels: int, codes: array(dtype=int64)):
    i = tid()
    lane_codes = hilbert_codes(lanes(cells[3 * i]), lanes(cells[3 * i + 1]), lanes(cells[3 * i + 2]), levels)
    codes[i] = lane_codes[i % 8]


@kernel
def thin_kernel(keys: array(dtype=int64), count: int, k: int, max_sqdist: float, counts: array(dtype=int32)):
    i = tid()
    counts[i] = thin_keys(keys, 0, 1, count, k, max_sqdist) + i


def codes_of(device, cells, levels):
    codes = empty(len(cells), int64, device)
    launch(encode_cells_kernel, len(cells), [upload(cells.reshape(-1), int32, device), levels, codes])
    return codes.numpy()


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


@pytest.mark.parametrize("count", [0, 1, LEAF, LEAF + 1, 2 * LEAF, 3 * LEAF, 1003])
def test_the_order_contains_every_point_once_and_the_rest_at_the_end(device, count, rng):
    points = rng.normal(size=(count, 3)).astype(np.float32)
    points[::5, 0] = np.nan
    curve = hilbert.HilbertOrder(upload(points, vec3, device))
    order, codes = curve.order.numpy(), curve.codes.numpy()
    finite = np.isfinite(points).all(axis=1)
    assert curve.finite_count == finite.sum()
    np.testing.assert_array_equal(np.sort(order), np.arange(count))
    assert finite[order[: curve.finite_count]].all() and not finite[order[curve.finite_count :]].any()
    assert (np.diff(codes) >= 0).all()


@pytest.mark.parametrize("spread", ["surface", "all at the reach", "all at zero"])
def test_thinning_never_loses_one_of_the_nearest(device, spread, rng):
    count, k, max_sqdist = 200, 20, 2.0
    squares = {"surface": rng.random(count), "all at the reach": np.ones(count), "all at zero": np.zeros(count)}[spread]
    bits = (max_sqdist * squares).astype(np.float32).view(np.int32).astype(np.int64)
    keys = (bits << 32) | rng.permutation(count)
    array_, counts = upload(keys, int64, device), empty(1, int32, device)
    launch(thin_kernel, 1, [array_, count, k, max_sqdist, counts])
    left = int(counts.numpy()[0])
    assert k <= left <= count
    np.testing.assert_array_equal(np.sort(array_.numpy()[:left])[:k], np.sort(keys)[:k])
    if spread == "surface":
        assert left < count / 2, "it does thin"


@pytest.mark.parametrize("radius", [1e-18, 0.1, 0.25, 1 / 3, 1.0, 2.0, 7e5, 1e18])
def test_squared_radius_is_the_largest_float32_below_the_square(radius):
    squared = np.float32(squared_radius(radius))
    assert float(squared) < radius * radius <= float(np.nextafter(squared, np.float32(np.inf)))


def test_squared_radius_of_extreme_radii_is_zero_or_the_largest_number():
    assert squared_radius(1e-200) == 0.0
    assert squared_radius(1e200) == squared_radius(1.7e308) == squared_radius(np.inf) == float(np.finfo(np.float32).max)


@kernel
def visit_buckets_kernel(start: int, max_sqdist: float, tree: PointTree, visits: array(dtype=int32)):
    i = tid()
    step = start_traversal(start + i)
    p = tree.points[start * BUCKET]
    while int(step[0]) <= tree.root:
        bucket = min(int(step[2]), visits.shape[0] - 1)
        visits[bucket] = visits[bucket] + 1
        step = next_bucket(step, p, p, max_sqdist, tree)


@pytest.mark.parametrize("count", [1, BUCKET + 1, 3 * BUCKET, FAN * BUCKET + 1, 10 * FAN * BUCKET + 1])
def test_a_traversal_without_a_radius_visits_each_bucket_once(device, count, rng):
    tree = PointTree(upload(rng.normal(size=(count, 3)).astype(np.float32), vec3, device))
    buckets = -(-count // BUCKET)
    for start in {0, buckets // 2, buckets - 1}:
        visits = zeros(buckets + 1, int32, device)
        launch(visit_buckets_kernel, 1, [start, squared_radius(np.inf), tree, visits])
        np.testing.assert_array_equal(visits.numpy(), [1] * buckets + [0])


@pytest.mark.parametrize("spread", [0.0, 1e-36, 1.0, 1e30])
def test_the_order_along_the_curve_does_not_depend_on_where_the_box_is_known(device, spread, rng):
    points = 3.0 * (spread < 1) + spread * rng.normal(size=(1_003, 3))
    points[::50] = np.nan
    given = upload(points, vec3, device)
    low, high, count = bound_points(given)
    expected = hilbert.argsort_along(given, hilbert.HilbertCurve(low, high, 10, is_empty=not count))[1]
    np.testing.assert_array_equal(download(hilbert.order_in_box(given, 10)), download(expected))


def test_a_part_on_the_full_curve_has_the_full_order(device):
    points = np.round(np.random.default_rng(4).random((3000, 3)), 1).astype(np.float32)  # many at one place
    device = resolve_device(device)
    full = hilbert.HilbertOrder(upload(points, vec3, device))
    rows = np.flatnonzero((abs(points - 0.6) < 0.25).all(axis=1))
    part = download(PointTree(upload(points[rows], vec3, device), full.curve).order)
    full_order = download(full.order)
    np.testing.assert_array_equal(rows[part], full_order[np.isin(full_order, rows)])
    part_order = download(PointTree(upload(points[rows], vec3, device)).order)
    assert not np.array_equal(part_order, part)
