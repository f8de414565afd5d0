"""Views in few cells: means, the shift of each picture, and whether a depth picture is the same to the last bit."""

import numpy as np
import pytest

from pointloom.kernels.lang import float32, uint8
from pointloom.kernels.memory import download, upload
from pointloom.kernels.rgbd import stream_views as at
from pointloom.kernels.rgbd.stream_views import compare_views, hide_cells, hide_near, view_stream
from pointloom.rgbd.slam.stream_check import shift_of

WIDTH, HEIGHT = 330, 250  # 82 x 62 cells of 4 x 4, and a border outside all cells


def pictures(shift=(0.0, 0.0)):
    """Depth [m] and gray colors of a wavy wall, shifted by so many cells."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    x, y = u / 4 - shift[0], v / 4 - shift[1]
    depth = 1.5 + 0.3 * np.sin(x / 7) * np.cos(y / 5)
    shade = 120 + 60 * np.sin(x / 4 + 1) * np.sin(y / 6)
    return depth.astype(np.float32), np.repeat(np.rint(shade).astype(np.uint8)[..., None], 3, axis=2)


def view(device, depth, color=None):
    pixels = None if color is None else upload(color.reshape(-1, 3), uint8, device)
    return view_stream(upload(depth.reshape(-1), float32, device), pixels, WIDTH, HEIGHT)


def sums(now, before):
    return np.asarray(download(compare_views(now, before)), np.float64).reshape(-1)


def test_a_cell_is_the_mean_of_its_pixels(device):
    depth, color = pictures()
    stream_view = view(device, depth, color)
    columns, rows = WIDTH // 4, HEIGHT // 4
    assert (stream_view.columns, stream_view.rows) == (columns, rows)

    def means(picture):
        return picture[: rows * 4, : columns * 4].reshape(rows, 4, columns, 4).mean(axis=(1, 3)).reshape(-1)

    assert np.allclose(download(stream_view.nearness), means(1 / depth.astype(np.float64)), atol=1e-6)
    assert np.allclose(download(stream_view.brightness), means(color[..., 0] / 255), atol=1e-6)


def test_a_cell_that_is_measured_in_part_has_no_nearness_and_without_color_there_is_no_brightness(device):
    depth, _ = pictures()
    depth[:4, :4].flat[:5] = 0.0
    depth[4:8, :4].flat[:4] = 0.0
    stream_view = view(device, depth)
    nearness = download(stream_view.nearness).reshape(stream_view.rows, stream_view.columns)
    assert nearness[0, 0] == 0.0 and nearness[1, 0] > 0.0
    assert (download(stream_view.brightness) < 0).all()


@pytest.mark.parametrize("shift", [(0.4, 0.0), (0.0, -0.7), (-0.5, 0.3)])
def test_colors_give_the_shift(device, shift):
    result = sums(view(device, *pictures(shift)), view(device, *pictures()))
    assert np.allclose(shift_of(result), shift, atol=0.03)


def test_depth_images_are_compared_bitwise(device):
    depth, color = pictures()
    before = view(device, depth, color)
    assert sums(view(device, depth, color), before)[at.OTHER] == 0
    depth[100, 100] += 0.001
    assert sums(view(device, depth, color), before)[at.OTHER] == 1
    assert sums(before, before)[at.MEASURED] == before.columns * before.rows


def test_a_blank_wall_has_no_shift(device):
    flat = view(device, np.full((HEIGHT, WIDTH), 2.0, np.float32), np.full((HEIGHT, WIDTH, 3), 90, np.uint8))
    result = sums(flat, flat)
    assert np.isnan(shift_of(result)).all()


def test_what_is_near_is_hidden(device):
    depth = np.array([0.0, 0.5, 1.0, 1.0001, 3.0], np.float32)
    far = download(hide_near(upload(depth, float32, device), 1.0))
    assert far.tolist() == [0.0, 0.0, 0.0, depth[3], 3.0]


def test_cells_are_hidden(device):
    depth, _ = pictures()
    stream_view = view(device, depth)
    hidden = np.zeros((stream_view.rows, stream_view.columns), np.uint8)
    hidden[3, 5] = 1
    given = upload(depth.reshape(-1), float32, device)
    shown = hide_cells(given, upload(hidden.reshape(-1), uint8, device), stream_view, WIDTH)
    expected = depth.copy()
    expected[12:16, 20:24] = 0.0
    assert np.array_equal(download(shown).reshape(HEIGHT, WIDTH), expected)
