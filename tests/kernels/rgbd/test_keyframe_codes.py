"""Codes of frames recognize the same view despite holes and exposure."""

import numpy as np
import pytest

from pointloom.kernels.lang import float32, uint8
from pointloom.kernels.memory import download, upload, zeros
from pointloom.kernels.rgbd.keyframe_codes import FERNS, compare_codes, encode_frame

WIDTH, HEIGHT = 40, 30


def picture(rng):
    v, u = np.mgrid[:HEIGHT, :WIDTH] / 10
    a, b, c, d = rng.uniform(0.5, 2.0, 4)
    depth = 2 + 1.2 * np.sin(a * u + c) * np.cos(b * v + d)
    return depth.astype(np.float32), (0.5 + 0.4 * np.sin(c * u + a) * np.cos(d * v + b)).astype(np.float32)


def code_of(device, depth, brightness, seed=0, **options):
    arrays = [upload(np.ascontiguousarray(x.reshape(-1)), float32, device) for x in (depth, brightness)]
    return encode_frame(*arrays, options.pop("first", 0), WIDTH, HEIGHT, seed=seed, **options)


def difference(code, other):
    common, different = download(compare_codes(code, other, 1))[0]
    return int(common), different / max(common, 1)


def test_an_image_equals_itself_and_differs_from_another(device, rng):
    one, other = picture(rng), picture(rng)
    code = code_of(device, *one)
    assert difference(code, code) == (4 * FERNS, 0.0)
    common, share = difference(code, code_of(device, *other))
    assert common == 4 * FERNS and share > 0.15


def test_noise_and_exposure_change_few_bits(device, rng):
    depth, brightness = picture(rng)
    noisy = depth + rng.normal(0, 0.01, depth.shape).astype(np.float32)
    assert difference(code_of(device, depth, brightness), code_of(device, noisy, 0.6 * brightness))[1] < 0.03


def test_holes_give_no_bits(device, rng):
    depth, brightness = picture(rng)
    torn = depth.copy()
    torn[:, ::2] = 0
    common, share = difference(code_of(device, depth, brightness), code_of(device, torn, brightness))
    assert share == 0.0
    assert 2 * FERNS < common < 4 * FERNS
    nothing = code_of(device, np.zeros_like(depth), np.full_like(depth, -1))
    assert difference(nothing, nothing) == (0, 0.0)


def test_without_color_depth_decides(device, rng):
    depth, brightness = picture(rng)
    gray = code_of(device, depth, np.full_like(depth, -1))
    assert difference(gray, code_of(device, depth, brightness)) == (2 * FERNS, 0.0)


def test_codes_are_stored_in_rows_and_each_is_compared(device, rng):
    codes = zeros(3 * FERNS, uint8, device)
    pictures = [picture(rng) for _ in range(3)]
    for row, (depth, brightness) in enumerate(pictures):
        code_of(device, depth, brightness, codes=codes, row=row)
    counts = download(compare_codes(code_of(device, *pictures[1]), codes, 3))
    assert counts[1, 1] == 0 and counts[0, 1] > 0 and counts[2, 1] > 0


def test_an_image_may_start_anywhere_in_its_array(device, rng):
    depth, brightness = picture(rng)
    shifted = [np.concatenate([np.full(7, 9, np.float32), x.reshape(-1)]) for x in (depth, brightness)]
    assert difference(code_of(device, depth, brightness), code_of(device, *shifted, first=7)) == (4 * FERNS, 0.0)


@pytest.mark.parametrize("seed", [1, 2**31 - 1])
def test_another_seed_gives_other_comparisons(device, rng, seed):
    depth, brightness = picture(rng)
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
