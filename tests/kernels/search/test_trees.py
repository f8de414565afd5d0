"""Search trees: a curve through neighboring cells, boxes that bound their points, and forests of several clouds."""

import numpy as np
import pytest

from pointloom.kernels.arrays.bounds import bound_points
from pointloom.kernels.lang import array, int32, int64, kernel, launch, tid, vec3
from pointloom.kernels.memory import download, empty, upload
from pointloom.kernels.search import hilbert_order as hilbert
from pointloom.kernels.search import point_tree
from pointloom.kernels.search.distinct_points import copies_of
from pointloom.kernels.search.hilbert_order import hilbert_codes, lanes
from pointloom.kernels.search.neighbor_keys import BY_INSERTION, sort_keys, thin_keys
from pointloom.kernels.search.point_forest import HEIGHTS, PointForest
from pointloom.kernels.search.point_tree import BUCKET, FAN, LEAF, SIDES, PointTree
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


@kernel
def sort_kernel(keys: array(dtype=int64), count: int):
    i = tid()
    sort_keys(keys, i + 1, 1, count)


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


@pytest.mark.parametrize("spread", [0.0, 1e-36, 1.0, 1e30])
def test_the_order_along_the_curve_does_not_depend_on_where_the_box_is_known(device, spread, rng):
    points = 3.0 * (spread < 1) + spread * rng.normal(size=(1_003, 3))
    points[::50] = np.nan
    given = upload(points, vec3, device)
    low, high, count = bound_points(given)
    expected = hilbert.argsort_along(given, hilbert.HilbertCurve(low, high, 10, is_empty=not count))[1]
    np.testing.assert_array_equal(download(hilbert.order_in_box(given, 10)), download(expected))


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


SPREADS = {
    "uniform": lambda rng, count: rng.random((count, 3)),
    "lattice": lambda rng, count: rng.integers(0, 4, (count, 3)),
    "copies": lambda rng, count: np.repeat(rng.random((count, 3)), 3, axis=0)[:count],
    "one position": lambda rng, count: np.full((count, 3), -0.0),
    "close to each other in a large box": lambda rng, count: np.append(rng.random((count - 1, 3)), [[1e3, 0, 0]], 0),
    "an extent below the scale's range": lambda rng, count: 1e-34 * (1 + rng.random((count, 3))),
    "not all finite": lambda rng, count: np.where(rng.random((count, 3)) < 0.1, np.inf, rng.random((count, 3))),
}


@pytest.mark.parametrize("spread", SPREADS)
@pytest.mark.parametrize("count", [1, LEAF + 1, BUCKET, FAN * BUCKET + 1, hilbert.MAX_FEW_POINTS])
def test_the_tree_of_few_points_is_that_of_parallel_launches(device, count, spread, rng, monkeypatch):
    points = upload(SPREADS[spread](rng, count).astype(np.float32), vec3, device)
    curve = hilbert.HilbertCurve(np.zeros(3, np.float32), np.ones(3, np.float32), 9)
    few = [(tree, copies_of(tree)) for tree in (PointTree(points), PointTree(points, curve))]
    monkeypatch.setattr(point_tree, "is_few", lambda _: False)
    many = [(tree, copies_of(tree)) for tree in (PointTree(points), PointTree(points, curve))]
    for (a, some), (b, others) in zip(few, many, strict=True):
        assert (a.count, a.root, a.curve.scale, a.curve.levels) == (b.count, b.root, b.curve.scale, b.curve.levels)
        assert a.low.tobytes() == b.low.tobytes() and a.high.tobytes() == b.high.tobytes()
        for name in ("levels", "boxes", "points", "order", "codes"):
            np.testing.assert_array_equal(download(getattr(a, name)), download(getattr(b, name)))
        assert (some and some.most) == (others and others.most)


@pytest.mark.parametrize("count", [1, 2, 1_000, hilbert.MAX_FEW_POINTS, hilbert.MAX_FEW_POINTS + 1])
def test_the_order_of_queries_has_each_once_and_the_rest_at_the_end(device, count, rng):
    queries = rng.normal(size=(count, 3)).astype(np.float32)
    queries[::7, 1] = np.nan
    curve = hilbert.HilbertCurve(np.zeros(3, np.float32), np.ones(3, np.float32), 16)
    order = download(hilbert.order_queries(upload(queries, vec3, device), curve))
    np.testing.assert_array_equal(np.sort(order), np.arange(count))
    assert (np.diff(np.isfinite(queries[order, 1]).astype(int)) <= 0).all()


@pytest.mark.parametrize("count", [0, 1, 2, BY_INSERTION, BY_INSERTION + 1, 300])
def test_keys_are_sorted_in_place(device, count, rng):
    keys = rng.permutation(np.arange(count + 2, dtype=np.int64) << 30)
    sorted_keys = upload(keys, int64, device)
    launch(sort_kernel, 1, [sorted_keys, count])
    np.testing.assert_array_equal(download(sorted_keys), np.concatenate([keys[:1], np.sort(keys[1:-1]), keys[-1:]]))


def test_boxes_of_a_forest_are_those_of_each_tree(device, rng):
    clouds = [rng.normal(size=(count, 3)).astype(np.float32) for count in (5, 70, FAN * BUCKET + 1, 1)]
    forest = PointForest([upload(cloud, vec3, device) for cloud in clouds])
    levels, roots = download(forest.levels).reshape(-1, HEIGHTS), download(forest.roots)
    forest_points, first = download(forest.clouds.points).reshape(-1, 3), forest.clouds.bases
    for k, cloud in enumerate(clouds):
        check_levels(forest_points[first[k] : first[k] + len(cloud)], levels[k], roots[k], download(forest.boxes))


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
