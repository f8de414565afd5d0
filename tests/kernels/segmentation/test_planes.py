"""Samples and scores of planes against NumPy, and the opening and filling of grids of heights."""

from itertools import pairwise

import numpy as np
import pytest

from pointloom.kernels.arrays.ranked_numbers import numbers_of_ranks
from pointloom.kernels.lang import float32, int32, uint8, vec3, vec4d
from pointloom.kernels.memory import download, upload, write, zeros
from pointloom.kernels.segmentation.ground import DIAGONAL_FRACTION, DILATION_SIGN, EROSION_SIGN, HeightGrid
from pointloom.kernels.segmentation.plane_fit import POINTS_PER_BLOCK, PlaneSearch, samples_needed


def search_over(points, device, rows=None):
    rows = np.arange(len(points)) if rows is None else rows
    return PlaneSearch(upload(points, vec3, device), upload(rows, int32, device))


def drawn_planes(search, sample_size, count, seed, first=0):
    return download(search.draw_planes(sample_size, count, seed, first)).copy()


def brute_counts(search, points, planes, threshold):
    """Inliers of each plane in float64, and whether some point is too close to the threshold for float32."""
    local = points - search.center
    heights = np.abs(local @ planes[:, :3].T + planes[:, 3])
    unclear = (np.abs(heights - threshold) < 1e-6 * (1 + search.size)).any(axis=0)
    return (heights < threshold).sum(axis=0), unclear


@pytest.mark.parametrize("count", [3, 4, *(POINTS_PER_BLOCK + k for k in (-1, 0, 1)), 5 * POINTS_PER_BLOCK + 77])
@pytest.mark.parametrize("plane_count", [1, 8, 29])
def test_counts_of_inliers_match_numpy(device, rng, count, plane_count):
    """Sorted along x, so that blocks are thin slabs and most are passed over."""
    points = rng.normal(size=(count, 3)).astype(np.float32)
    points = points[np.argsort(points[:, 0])]
    search = search_over(points, device)
    planes = search.draw_planes(3, plane_count, 1, 0)
    expected, unclear = brute_counts(search, points.astype(float), download(planes), 0.05)
    counts = download(search.score(planes, plane_count, 0.05))
    assert (counts == expected)[~unclear].all() and (np.abs(counts - expected) <= 2).all()
    assert (~unclear).any() or count > POINTS_PER_BLOCK


def test_a_point_at_the_threshold_is_no_inlier_as_in_open3d(device):
    heights = np.repeat([-0.5, -0.25, -0.125, 0, 0.125, 0.25, 0.5], 5)
    points = np.column_stack([np.tile(np.arange(-2.0, 3), 7), np.zeros(35), heights]).astype(np.float32)
    search = search_over(points, device)
    level = upload(np.array([[0.0, 0, 1, 0]]), vec4d, search.points.device)
    assert download(search.score(level, 1, 0.25)).tolist() == [15]


@pytest.mark.parametrize("scale", [1.0, 3000.0], ids=["room", "city"])
def test_skipped_blocks_contain_no_inlier(device, rng, scale):
    """Blocks that are small cubes, so that planes pass many of them by and cut the corners of others.

    Over kilometers float32 is off by a tenth of a millimetre: the slack must cover it.
    """
    corners = np.repeat(rng.random((40, 3)), POINTS_PER_BLOCK, axis=0)
    points = (scale * (corners + 0.2 * rng.random((40 * POINTS_PER_BLOCK, 3)))).astype(np.float32)
    search = search_over(points, device)
    planes = search.draw_planes(3, 200, 0, 0)
    threshold = 0.001 * scale
    expected, _ = brute_counts(search, points.astype(float), download(planes), threshold)
    counts = download(search.score(planes, 200, threshold))
    assert np.abs(counts - expected).max() <= 2, "points within rounding of the threshold"
    assert expected.max() > 50


@pytest.mark.parametrize("sample_size", [3, 4, 7])
def test_samples_are_distinct_and_all_points_alike(device, rng, sample_size):
    """Of points in convex position only the sample is on its plane, so planes of three identify their samples."""
    points = rng.normal(size=(9, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    points = points.astype(np.float32)
    search = search_over(points, device)
    planes = drawn_planes(search, sample_size, 4000, 3)
    local = points.astype(float) - search.center
    assert np.isfinite(planes).all()
    if sample_size > 3:
        for subset_plane in planes[:50]:
            heights = np.abs(local @ subset_plane[:3] + subset_plane[3])
            assert np.sort(heights)[sample_size - 1] < np.sort(heights)[-1]
        return
    on_plane = np.abs(local @ planes[:, :3].T + planes[:, 3]) < 1e-12
    assert (on_plane.sum(axis=0) == 3).all()
    fraction = on_plane.mean(axis=1)
    assert np.abs(fraction - 3 / 9).max() < 4 * np.sqrt(3 / 9 * 6 / 9 / 4000), "within 4 standard deviations"


def test_plane_of_a_larger_sample_is_its_least_squares_plane(device, rng):
    points = rng.normal(size=(5, 3)).astype(np.float32)
    search = search_over(points, device)
    plane = drawn_planes(search, 5, 1, 0)[0]
    local = points.astype(float) - search.center
    normal = np.linalg.svd(local - local.mean(axis=0))[2][2]
    assert abs(abs(normal @ plane[:3]) - 1) < 1e-9 and abs(plane[:3] @ local.mean(axis=0) + plane[3]) < 1e-12


def test_a_sample_does_not_depend_on_its_batch(device, rng):
    search = search_over(rng.random((100, 3)), device)
    together = drawn_planes(search, 3, 50, 7)
    np.testing.assert_array_equal(together[20:], drawn_planes(search, 3, 30, 7, first=20))


@pytest.mark.parametrize("seed", range(4))
def test_best_plane_has_maximal_inliers_then_minimal_distances(device, rng, seed):
    """Few points on a lattice: many planes have as many inliers as the best."""
    points = rng.integers(0, 4, (60, 3)).astype(np.float32) + 0.01 * rng.normal(size=(60, 3)).astype(np.float32)
    search = search_over(points, device)
    best = search.find(0.1, 3, 500, 1.0, seed)
    planes = drawn_planes(search, 3, 500, seed)
    heights = np.abs((points.astype(float) - search.center) @ planes[:, :3].T + planes[:, 3])
    counts = (heights < 0.1).sum(axis=0)
    sums = np.where(heights < 0.1, heights, 0).sum(axis=0)
    expected = np.lexsort((np.arange(500), sums, -counts))[0]
    np.testing.assert_array_equal(best, planes[expected])


def test_samples_needed_are_those_of_fischler_and_bolles():
    assert samples_needed(0.5, 3, 0.99, 1000) == pytest.approx(34.49, abs=0.01)
    assert samples_needed(1.0, 3, 0.99, 1000) == 0
    assert samples_needed(0.0, 3, 0.99, 1000) == samples_needed(0.5, 3, 1.0, 1000) == 1000
    assert samples_needed(1e-7, 3, 0.99, 1000) == 1000


@pytest.mark.parametrize("scale", [1, 40, 300, 5000])
def test_numbers_of_ranks_are_those_of_the_sorted_runs(device, rng, scale):
    sizes = rng.integers(1, scale + 1, 9)
    values = rng.normal(size=sizes.sum()) * 10.0 ** rng.integers(-30, 30, sizes.sum())
    values[::5] = rng.choice([0.0, -0.0, 1.0, -1.0, np.inf, -np.inf], len(values[::5]))
    values = values.astype(np.float32)
    starts = np.concatenate([[0], np.cumsum(sizes)])
    for ranks in (np.zeros(9, int), sizes // 2, sizes - 1, rng.integers(0, sizes)):
        expected = [np.sort(values[a:b])[rank] for (a, b), rank in zip(pairwise(starts), ranks, strict=True)]
        arrays = upload(values, float32, device), upload(starts, int32, device), upload(ranks, int32, device)
        np.testing.assert_array_equal(download(numbers_of_ranks(*arrays)), expected)


def grid_of(heights, device):
    """A grid with these heights, NaN or infinite where there is none."""
    columns, rows = heights.shape
    grid = HeightGrid(upload(np.zeros((0, 3)), vec3, device), np.zeros(3), 1.0, columns, rows)
    grid.heights = upload(heights.astype(np.float32).ravel(), float32, device)
    return grid


def swept(heights, dx, dy, half, choose):
    """The extreme along a segment about each cell, beyond the edge nothing, by its definition."""
    out = np.empty_like(heights)
    columns, rows = heights.shape
    for x in range(columns):
        for y in range(rows):
            cells = [(x + k * dx, y + k * dy) for k in range(-half, half + 1)]
            out[x, y] = choose([heights[a, b] for a, b in cells if 0 <= a < columns and 0 <= b < rows])
    return out


@pytest.mark.parametrize(("first", "then"), [(EROSION_SIGN, DILATION_SIGN), (DILATION_SIGN, EROSION_SIGN)])
@pytest.mark.parametrize("radius", [1, 2, 5, 18])
@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (13, 7), (20, 31)])
def test_a_window_opens_as_its_segments_do_one_by_one(device, rng, first, then, radius, shape):
    heights = rng.normal(size=shape).astype(np.float32)
    expected = heights
    diagonal = int(DIAGONAL_FRACTION * radius + 0.5)
    straight = radius - 2 * diagonal
    segments = [(1, 0, straight), (0, 1, straight), (1, 1, diagonal), (1, -1, diagonal)]
    for side, (dx, dy, half) in [(first, s) for s in segments] + [(then, s) for s in reversed(segments)]:
        expected = swept(expected, dx, dy, half, min if side == EROSION_SIGN else max)
    grid = grid_of(heights, device)
    np.testing.assert_array_equal(download(grid.open_by(grid.heights, radius, first)).reshape(shape), expected)


def filled_once(grid, unwanted):
    fill, filled = grid.prepare_filling(unwanted)
    fill()
    return download(filled)


def test_a_grid_is_filled_again_with_other_flags(device, rng):
    """Prepared once; each call uses the current flags."""
    grid = grid_of(rng.normal(size=(9, 14)), device)
    flags = (rng.random(grid.size) < 0.4).astype(np.uint8)
    unwanted = zeros(grid.size, uint8, grid.device)
    fill, filled = grid.prepare_filling(unwanted)
    fill()
    write(unwanted, flags)
    fill()
    expected = filled_once(grid, upload(flags, uint8, grid.device))
    np.testing.assert_array_equal(download(filled), expected)
    assert (expected != filled_once(grid, zeros(grid.size, uint8, grid.device))).any()


@pytest.mark.parametrize("slope", [0.0, 0.5, 1.0])
def test_a_gap_in_a_slope_is_filled_along_the_slope(device, slope):
    """A hole of 36 cells, the diameter of the default's largest window, to within 0.6 of a cell's rise."""
    x, y = np.mgrid[:100, :90].astype(np.float64)
    hole = np.hypot(x - 50, y - 45) < 18
    heights = np.where(hole, np.inf, slope * x)
    grid = grid_of(heights, device)
    filled = filled_once(grid, zeros(grid.size, uint8, grid.device)).reshape(x.shape)
    np.testing.assert_array_equal(filled[~hole], (slope * x[~hole]).astype(np.float32))
    assert np.abs(filled - slope * x)[hole].max() <= 0.6 * slope + 1e-5


def test_unwanted_cells_are_filled_like_gaps_and_known_ones_stay(device, rng):
    heights = rng.normal(size=(9, 14))
    unwanted = rng.random((9, 14)) < 0.4
    grid = grid_of(heights, device)
    filled = filled_once(grid, upload(unwanted.astype(np.uint8).ravel(), uint8, grid.device)).reshape(9, 14)
    np.testing.assert_array_equal(filled[~unwanted], heights[~unwanted].astype(np.float32))
    assert (filled >= heights[~unwanted].min() - 1e-5).all() and (filled <= heights[~unwanted].max() + 1e-5).all()
    assert np.abs(filled - heights)[unwanted].max() > 0.1
