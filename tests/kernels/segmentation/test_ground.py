"""Morphological opening of a grid of heights, and springs that fill its gaps."""

import numpy as np
import pytest

from pointloom.kernels.lang import float32, uint8, vec3
from pointloom.kernels.memory import download, upload, write, zeros
from pointloom.kernels.segmentation.ground import DIAGONAL, DILATION, EROSION, HeightGrid


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


@pytest.mark.parametrize(("first", "then"), [(EROSION, DILATION), (DILATION, EROSION)])
@pytest.mark.parametrize("radius", [1, 2, 5, 18])
@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (13, 7), (20, 31)])
def test_a_window_opens_as_its_segments_do_one_by_one(device, rng, first, then, radius, shape):
    heights = rng.normal(size=shape).astype(np.float32)
    expected = heights
    diagonal = int(DIAGONAL * radius + 0.5)
    straight = radius - 2 * diagonal
    segments = [(1, 0, straight), (0, 1, straight), (1, 1, diagonal), (1, -1, diagonal)]
    for side, (dx, dy, half) in [(first, s) for s in segments] + [(then, s) for s in reversed(segments)]:
        expected = swept(expected, dx, dy, half, min if side == EROSION else max)
    grid = grid_of(heights, device)
    np.testing.assert_array_equal(download(grid._opened(grid.heights, radius, first)).reshape(shape), expected)


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
