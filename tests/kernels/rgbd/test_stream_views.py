"""Codes of frames that recognize a view, and views in few cells: means, shifts, and bitwise comparison."""

import numpy as np
import pytest

from pointloom.kernels.lang import float32, uint8
from pointloom.kernels.memory import download, upload, zeros
from pointloom.kernels.rgbd import stream_views as at
from pointloom.kernels.rgbd.keyframe_codes import FERN_COUNT, compare_codes, encode_frame
from pointloom.kernels.rgbd.stream_views import compare_views, hide_cells, hide_near, view_stream
from pointloom.rgbd.slam.stream_check import shift_of

WIDTH, HEIGHT = 330, 250  # 82 x 62 cells of 4 x 4, and a border outside all cells


def images(shift=(0.0, 0.0)):
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
    return compare_views(now, before)


def test_a_cell_is_the_mean_of_its_pixels(device):
    depth, color = images()
    stream_view = view(device, depth, color)
    columns, rows = WIDTH // 4, HEIGHT // 4
    assert (stream_view.columns, stream_view.rows) == (columns, rows)

    def means(image):
        return image[: rows * 4, : columns * 4].reshape(rows, 4, columns, 4).mean(axis=(1, 3)).reshape(-1)

    assert np.allclose(download(stream_view.nearness), means(1 / depth.astype(np.float64)), atol=1e-6)
    assert np.allclose(download(stream_view.brightness), means(color[..., 0] / 255), atol=1e-6)


def test_the_cells_on_the_host_are_those_of_the_device(device):
    now, before = (view(device, *images(shift)) for shift in ((0.0, 0.0), (0.5, 0.0)))
    first = sums(now, before)  # reads the cells of the first view, too
    assert "host_cells" in vars(now) and "host_cells" not in vars(before)
    for each in (now, before):
        assert each.host_nearness.shape == (each.rows, each.columns)
        np.testing.assert_array_equal(each.host_nearness.reshape(-1), download(each.nearness))
        np.testing.assert_array_equal(each.host_brightness.reshape(-1), download(each.brightness))
    np.testing.assert_array_equal(sums(now, before), first)


def test_a_cell_that_is_measured_in_part_has_no_nearness_and_without_color_there_is_no_brightness(device):
    depth, _ = images()
    depth[:4, :4].flat[:5] = 0.0
    depth[4:8, :4].flat[:4] = 0.0
    stream_view = view(device, depth)
    nearness = download(stream_view.nearness).reshape(stream_view.rows, stream_view.columns)
    assert nearness[0, 0] == 0.0 and nearness[1, 0] > 0.0 and (download(stream_view.brightness) < 0).all()


@pytest.mark.parametrize("shift", [(0.4, 0.0), (0.0, -0.7), (-0.5, 0.3)])
def test_colors_give_the_shift(device, shift):
    result = sums(view(device, *images(shift)), view(device, *images()))
    assert np.allclose(shift_of(result), shift, atol=0.03)


def test_depth_images_are_compared_bitwise(device):
    depth, color = images()
    before = view(device, depth, color)
    assert sums(view(device, depth, color), before)[at.CHANGED_AT] == 0
    depth[100, 100] += 0.001
    assert sums(view(device, depth, color), before)[at.CHANGED_AT] == 1
    assert sums(before, before)[at.MEASURED_AT] == before.columns * before.rows


def test_a_blank_wall_has_no_shift(device):
    flat = view(device, np.full((HEIGHT, WIDTH), 2.0, np.float32), np.full((HEIGHT, WIDTH, 3), 90, np.uint8))
    result = sums(flat, flat)
    assert np.isnan(shift_of(result)).all()


def test_what_is_near_is_hidden(device):
    depth = np.array([0.0, 0.5, 1.0, 1.0001, 3.0], np.float32)
    far = download(hide_near(upload(depth, float32, device), 1.0))
    assert far.tolist() == [0.0, 0.0, 0.0, depth[3], 3.0]


def test_cells_are_hidden(device):
    depth, _ = images()
    stream_view = view(device, depth)
    hidden = np.zeros((stream_view.rows, stream_view.columns), np.uint8)
    hidden[3, 5] = 1
    given = upload(depth.reshape(-1), float32, device)
    shown = hide_cells(given, upload(hidden.reshape(-1), uint8, device), stream_view, WIDTH)
    expected = depth.copy()
    expected[12:16, 20:24] = 0.0
    assert np.array_equal(download(shown).reshape(HEIGHT, WIDTH), expected)


CODE_WIDTH, CODE_HEIGHT = 40, 30


def image(rng):
    v, u = np.mgrid[:CODE_HEIGHT, :CODE_WIDTH] / 10
    a, b, c, d = rng.uniform(0.5, 2.0, 4)
    depth = 2 + 1.2 * np.sin(a * u + c) * np.cos(b * v + d)
    return depth.astype(np.float32), (0.5 + 0.4 * np.sin(c * u + a) * np.cos(d * v + b)).astype(np.float32)


def code_of(device, depth, brightness, seed=0, **options):
    arrays = [upload(np.ascontiguousarray(x.reshape(-1)), float32, device) for x in (depth, brightness)]
    return encode_frame(*arrays, options.pop("first", 0), CODE_WIDTH, CODE_HEIGHT, seed=seed, **options)


def difference(code, other):
    common, different = download(compare_codes(code, other, 1))[0]
    return int(common), different / max(common, 1)


def test_an_image_equals_itself_and_differs_from_another(device, rng):
    one, other = image(rng), image(rng)
    code = code_of(device, *one)
    assert difference(code, code) == (4 * FERN_COUNT, 0.0)
    common, fraction = difference(code, code_of(device, *other))
    assert common == 4 * FERN_COUNT and fraction > 0.15


def test_noise_and_exposure_change_few_bits_and_the_start_of_an_image_in_its_array_none(device, rng):
    depth, brightness = image(rng)
    code, noisy = code_of(device, depth, brightness), depth + rng.normal(0, 0.01, depth.shape).astype(np.float32)
    assert difference(code, code_of(device, noisy, 0.6 * brightness))[1] < 0.03
    shifted = [np.concatenate([np.full(7, 9, np.float32), x.reshape(-1)]) for x in (depth, brightness)]
    assert difference(code, code_of(device, *shifted, first=7)) == (4 * FERN_COUNT, 0.0)


def test_holes_give_no_bits(device, rng):
    depth, brightness = image(rng)
    torn = depth.copy()
    torn[:, ::2] = 0
    common, fraction = difference(code_of(device, depth, brightness), code_of(device, torn, brightness))
    assert fraction == 0.0 and 2 * FERN_COUNT < common < 4 * FERN_COUNT
    nothing = code_of(device, np.zeros_like(depth), np.full_like(depth, -1))
    assert difference(nothing, nothing) == (0, 0.0)


def test_without_color_depth_decides(device, rng):
    depth, brightness = image(rng)
    gray = code_of(device, depth, np.full_like(depth, -1))
    assert difference(gray, code_of(device, depth, brightness)) == (2 * FERN_COUNT, 0.0)


def test_codes_are_stored_in_rows_and_each_is_compared(device, rng):
    codes = zeros(3 * FERN_COUNT, uint8, device)
    images = [image(rng) for _ in range(3)]
    for row, (depth, brightness) in enumerate(images):
        code_of(device, depth, brightness, codes=codes, row=row)
    counts = download(compare_codes(code_of(device, *images[1]), codes, 3))
    assert counts[1, 1] == 0 and counts[0, 1] > 0 and counts[2, 1] > 0


@pytest.mark.parametrize("seed", [1, 2**31 - 1])
def test_another_seed_gives_other_comparisons(device, rng, seed):
    depth, brightness = image(rng)
    codes = [download(code_of(device, depth, brightness, s)).copy() for s in (0, seed)]
    assert (codes[0] != codes[1]).any()


def test_the_code_of_a_pixel_matches_numpy(device):
    """An image of one pixel: every test compares that pixel, and depth exceeds a threshold at the expected rate."""
    depth, brightness = np.array([2.4], np.float32), np.array([0.5], np.float32)
    arrays = [upload(x, float32, device) for x in (depth, brightness)]
    code = download(encode_frame(*arrays, 0, 1, 1, seed=0)).astype(int)
    assert (code >> 4 == 15).all()
    assert abs((code & 1).mean() - 0.5) < 0.1, "thresholds lie between 0.4 and 4.4 m"
    for bit in (1, 2, 3):
        assert abs((code >> bit & 1).mean() - 4 / 9) < 0.1, "ratios lie between 0.6 and 1.5"
