"""Searches in batches of clouds give the neighbors of brute force, in as many launches as for one cloud."""

import itertools

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels import launches
from pointloom.kernels.arrays.scattered_sums import sum_by_index
from pointloom.kernels.lang import float32, float64, int32, int64, vec3, vec3d
from pointloom.kernels.memory import upload
from pointloom.kernels.sampling.farthest_in_batch import choose_in_batch
from pointloom.kernels.search import batch_neighbors, cloud_batch
from pointloom.kernels.search.batch_neighbors import search_batch
from pointloom.kernels.search.cloud_batch import CloudRows
from pointloom.pcd.cloud import PointCloud

SIZES = [130, 0, 1, 64, 7, 65, 0, 600, 12, 0]  # buckets, leaves and levels are full, exceeded by one, or empty


class Clouds:
    """Clouds of the given sizes in one array, with rows of padding behind each."""

    def __init__(self, rng, sizes, dtype, device, *, padding=0, scale=1.0, shift=0.0):
        rooms = np.array(sizes) + padding
        self.sizes, self.starts = np.array(sizes), np.concatenate([[0], np.cumsum(rooms)[:-1]])
        self.rows = (rng.random((rooms.sum(), 3)) * scale + shift).astype(dtype)
        self.device = resolve_device(device)

    def upload(self):
        points = upload(self.rows, vec3 if self.rows.dtype == np.float32 else vec3d, self.device)
        tables = (upload(table, int32, self.device) for table in (self.starts, self.sizes))
        return points, CloudRows(*tables, int(self.sizes.max(initial=0)))

    def parts(self):
        return [self.rows[first : first + size] for first, size in zip(self.starts, self.sizes, strict=True)]


def expected_neighbors(queries, points, k, radius):
    """Neighbors in the arithmetic of the type, ties by index: rows of the points, -1 at infinite distance."""
    indices = np.full((len(queries.rows), k), -1)
    sqdists = np.full((len(queries.rows), k), np.inf, queries.rows.dtype)
    for q, p, first, start in zip(queries.parts(), points.parts(), queries.starts, points.starts, strict=True):
        d = p[None] - q[:, None]
        squares = d[..., 0] * d[..., 0] + d[..., 1] * d[..., 1] + d[..., 2] * d[..., 2]
        squares[~(squares.astype(np.float64) < radius**2)] = np.inf
        order = np.argsort(squares, axis=1, kind="stable")[:, :k]
        found = np.take_along_axis(squares, order, 1)
        rows = slice(first, first + len(q)), slice(0, order.shape[1])
        indices[rows] = np.where(np.isfinite(found), order + start, -1)
        sqdists[rows] = found
    return indices, sqdists


def assert_neighbors(queries, points, k, radius=np.inf):
    near, clouds = points.upload()
    given = (near, clouds) if queries is points else queries.upload()
    indices, sqdists = search_batch(*given, near, clouds, k, radius, False)
    expected = expected_neighbors(queries, points, k, radius)
    np.testing.assert_array_equal(indices.numpy(), expected[0])
    np.testing.assert_array_equal(sqdists.numpy(), expected[1])


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize(("k", "radius"), [(1, np.inf), (5, np.inf), (40, np.inf), (6, 0.15)])
def test_neighbors_in_clouds_of_all_sizes_are_those_of_brute_force(device, dtype, k, radius, rng):
    points = Clouds(rng, SIZES, dtype, device)
    assert_neighbors(points, points, k, radius)
    assert_neighbors(Clouds(rng, np.roll(SIZES, 3), dtype, device, scale=1.3), points, k, radius)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_padding_is_neither_searched_nor_found(device, dtype, rng):
    points = Clouds(rng, [70, 0, 3, 9], dtype, device, padding=5)
    assert_neighbors(points, points, 4)
    assert_neighbors(Clouds(rng, [9, 2, 0, 20], dtype, device, padding=1), points, 4)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_ties_and_copies_are_ordered_by_index(device, dtype, rng):
    points = Clouds(rng, [200, 90, 300], dtype, device)
    points.rows[:] = np.round(points.rows * 4) / 4
    points.rows[200:290] = 0.5
    assert_neighbors(points, points, 7)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_points_and_queries_that_are_not_finite_have_no_neighbors(device, dtype, rng):
    points = Clouds(rng, [100, 3, 80], dtype, device)
    points.rows[rng.integers(0, 183, 30), rng.integers(0, 3, 30)] = rng.choice([np.nan, np.inf, -np.inf], 30)
    points.rows[100:103] = np.nan
    with np.errstate(invalid="ignore"):
        assert_neighbors(points, points, 6)


def test_float64_keeps_what_float32_rounds_away(device, rng):
    """Steps of 1e-9 at 5e6, as of coordinates in millimeters of a national grid."""
    points = Clouds(rng, [90, 40], np.float64, device, scale=1e-9, shift=5e6)
    points.rows[90:] = 5e6 + rng.random((40, 3))
    assert_neighbors(points, points, 5)
    assert_neighbors(Clouds(rng, [20, 30], np.float64, device, scale=2.0, shift=5e6 - 1), points, 5)


def test_clouds_far_from_each_other_are_searched_on_curves_of_their_own(device, rng):
    points = Clouds(rng, [300, 300], np.float32, device)
    points.rows[300:] = points.rows[300:] * 1e-4 + 1e4
    assert_neighbors(points, points, 3)


def test_local_indices_count_from_the_start_of_a_cloud(device, rng):
    points = Clouds(rng, [20, 30], np.float32, device)
    given = points.upload()
    local, whole = (search_batch(*given, *given, 4, np.inf, is_local)[0].numpy() for is_local in (True, False))
    np.testing.assert_array_equal(local, whole - np.repeat([0, 20], [20, 30])[:, None])


def counted_launches(monkeypatch, run):
    counts = []

    def count(kernel, *arguments):
        counts.append(kernel.name)
        return launches.launch(kernel, *arguments)

    with monkeypatch.context() as patch:
        for module in (cloud_batch, batch_neighbors):
            patch.setattr(module, "launch", count)
        run()
    return counts


def test_launches_do_not_grow_with_the_number_of_clouds(device, rng, monkeypatch):
    def search(count):
        given = Clouds(rng, [512 // count] * count, np.float32, device).upload()
        given[1].largest = 512  # the bound of a ragged batch
        return counted_launches(monkeypatch, lambda: search_batch(*given, *given, 4, np.inf, False))

    assert search(1) == search(8) == search(256)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize(("count", "rows"), [(900, 40), (20_000, 3), (50, 200), (9_000, 1)])
def test_sums_by_index_are_those_of_numpy_and_bitwise_repeatable(device, dtype, count, rows, rng):
    values, index = rng.normal(size=(count, 2)).astype(dtype), rng.integers(-1, rows + 1, count)
    home = resolve_device(device)
    given = upload(values, float32 if dtype == np.float32 else float64, home), upload(index, int64, home), rows
    expected = np.zeros((rows, 2))
    is_row = (index >= 0) & (index < rows)
    np.add.at(expected, index[is_row], values[is_row].astype(np.float64))
    sums = sum_by_index(*given).numpy()
    assert sums.dtype == dtype
    np.testing.assert_allclose(sums, expected, rtol=1e-6 if dtype == np.float32 else 1e-12, atol=1e-12 * count)
    np.testing.assert_array_equal(sums, sum_by_index(*given).numpy())


def test_sums_of_no_rows_are_zero(device):
    home = resolve_device(device)
    sums = sum_by_index(upload(np.empty((0, 3)), float64, home), upload(np.empty(0), int64, home), 4)
    np.testing.assert_array_equal(sums.numpy(), np.zeros((4, 3)))


def test_farthest_points_of_each_cloud_are_those_of_the_cloud_alone(device, rng):
    points = Clouds(rng, [500, 3, 0, 90], np.float32, device, padding=2)
    chosen = choose_in_batch(*points.upload(), 12).numpy()
    for row, part in zip(chosen, points.parts(), strict=True):
        if len(part) > 12:
            np.testing.assert_array_equal(row, PointCloud(part).farthest_point_indices(12))
        else:
            assert sorted(row[: len(part)]) == list(range(len(part))) and (row[len(part) :] == -1).all()


def test_farthest_points_skip_points_that_are_not_finite_and_take_copies_last(device, rng):
    points = Clouds(rng, [6], np.float32, device)
    points.rows[0], points.rows[3] = np.nan, points.rows[1]
    chosen = choose_in_batch(*points.upload(), 7).numpy()[0].tolist()
    assert chosen[0] == 1 and chosen[4] == 3 and chosen[5:] == [-1, -1]
    assert {*chosen[:5]} == {1, 2, 3, 4, 5}


def test_records_of_nodes_of_a_batch_do_not_overlap(device):
    """Nodes of each cloud start behind those of the one before, for sizes about those of full levels."""
    for sizes in itertools.product([0, 1, 64, 65, 511, 513, 4097], repeat=2):
        given = Clouds(np.random.default_rng(0), sizes, np.float32, device).upload()
        if given[0].size:
            batch = cloud_batch.CloudBatch(*given)
            levels = batch.levels.numpy().reshape(2, batch.height)
            for cloud, size in enumerate(sizes):
                nodes, end = -(-size // 64), levels[cloud][0]
                for level in range(batch.roots.numpy()[cloud] + 1):
                    assert levels[cloud][level] == end
                    end, nodes = end + nodes, -(-nodes // 8)
                assert end <= (levels[1][0] if cloud == 0 else batch.boxes.size // 48)
