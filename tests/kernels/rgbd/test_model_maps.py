"""Brightness and 8-bit colors of a rendered model against NumPy."""

import numpy as np

from pointloom.kernels.lang import float32, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.rgbd.model_maps import colors_of, hide_unseen
from pointloom.kernels.rgbd.pyramid import NO_COLOR


def test_brightness_is_none_where_there_is_no_depth(device):
    depth, bright = np.float32([0, 1, -1, 2]), np.float32([0.1, 0.2, 0.3, 0.4])
    brightness = upload(bright, float32, device)
    hide_unseen(upload(depth, float32, device), brightness)
    np.testing.assert_array_equal(download(brightness), np.where(depth > 0, bright, np.float32(NO_COLOR)))


def test_colors_are_rounded_to_nearest_even_bytes(device, rng):
    depth = np.float32([0, *np.ones(99)])
    colors = rng.random((100, 3)).astype(np.float32)
    colors[1:3] = [[0.5, 0.5, 0.5], [0.5 / 255, 1.5 / 255, 2.5 / 255]]
    pixels = colors_of(upload(depth, float32, device), upload(colors, vec3, device))
    scaled = 255 * colors.astype(np.float32)
    expected = np.rint(np.where(depth[:, None] > 0, scaled, np.float32(127.5)))
    np.testing.assert_array_equal(download(pixels), expected.astype(np.uint8))
    assert (scaled % 1 == 0.5).any()
