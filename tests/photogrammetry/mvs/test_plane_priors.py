"""Plane priors of untextured regions: fits, separate walls of one color, exclusion of objects in front."""

import numpy as np
import pytest
import warp as wp

from pointloom.kernels.lang import vec2, vec4
from pointloom.kernels.memory import download, upload
from pointloom.kernels.stereo.region_planes import INLIER_DISTANCE, plane_priors
from pointloom.kernels.stereo.textureless_regions import find_regions

WIDTH, HEIGHT = 80, 60
v, u = np.mgrid[:HEIGHT, :WIDTH].astype(np.float64)
PIXELS_PER = 50.0


def given(device: str, w: np.ndarray, sure: np.ndarray, plain: np.ndarray, seed: int = 0) -> np.ndarray:
    """The priors, or 0 where there are none, [h, w, 4]."""
    on_device = wp.get_device(device)
    judged = upload(np.stack([plain, sure], axis=-1).astype(np.float32).reshape(-1, 2), vec2, on_device)
    planes = upload(np.stack([w, w * 0, w * 0, w * 0], axis=-1).astype(np.float32).reshape(-1, 4), vec4, on_device)
    regions = find_regions(judged, w.shape[1])
    if regions is None:
        return np.zeros((*w.shape, 4), np.float32)
    return download(plane_priors(regions, judged, planes, INLIER_DISTANCE / PIXELS_PER, seed)).reshape(*w.shape, 4)


def frame(width: int) -> np.ndarray:
    return (u < width) | (v < width) | (u >= WIDTH - width) | (v >= HEIGHT - width)


@pytest.mark.parametrize("every", [1, 23])  # 23: fewer sure pixels than threads that sum them
def test_a_plain_region_takes_the_plane_of_certain_pixels_around_it(device, every):
    w, textured = 0.5 + 0.002 * u - 0.001 * v, frame(10)
    noisy = w + np.random.default_rng(0).normal(0, 0.1 / PIXELS_PER, w.shape)
    priors = given(device, noisy, textured & ((7 * u + 13 * v) % every == 0), ~textured)
    np.testing.assert_allclose(priors[~textured][:, 0], w[~textured], atol=0.1 / PIXELS_PER)
    np.testing.assert_allclose(priors[~textured][:, 1:3], np.tile([0.002, -0.001], ((~textured).sum(), 1)), atol=1e-4)
    assert (priors[~textured][:, 3] == 1).all()
    assert not priors[textured].any()


def test_an_object_in_front_of_a_wall_does_not_bend_its_plane(device):
    w, textured = 0.5 + 0.002 * u - 0.001 * v, frame(10)
    before = np.where(textured & (u < 40) & (v < 20), 0.9, w)
    priors = given(device, before, textured, ~textured)
    np.testing.assert_allclose(priors[~textured][:, 0], w[~textured], atol=1e-3)


def test_a_small_plain_region_beside_a_large_one_takes_the_plane_around_it(device):
    w = np.where(u < 54, 0.5 + 0.002 * u, 0.9 - 0.003 * v)
    textured = frame(10) | ((u >= 49) & ((np.abs(u - 62) > 4) | (np.abs(v - 35) > 4)))
    priors = given(device, w, textured, ~textured)
    np.testing.assert_allclose(priors[~textured][:, 0], w[~textured], atol=1e-5)


def test_two_walls_of_one_color_have_a_plane_each(device):
    w, textured = 0.5 + 0.004 * np.minimum(u, WIDTH - u), frame(10)
    priors = given(device, w, textured, ~textured)
    off = np.abs(priors[..., 0] - w)[~textured]
    assert (off < 0.01).mean() > 0.9  # all but about the corner, which nothing marks


@pytest.mark.parametrize("kind", ["nothing sure", "a line", "a band", "a mess", "a speck"])
def test_there_is_no_prior_without_a_certain_plane(device, kind):
    w, textured = 0.5 + 0.002 * u, frame(10)
    sure, plain = textured, ~textured
    if kind == "nothing sure":
        sure = textured & False
    elif kind == "a line":
        sure = textured & (v == 9)
    elif kind == "a band":
        sure = textured & (v > 6) & (v < 10)
    elif kind == "a mess":
        w = np.random.default_rng(1).uniform(0.2, 1.0, w.shape)
    else:
        plain = (np.abs(u - 40) < 3) & (np.abs(v - 30) < 3)
        sure = ~plain
    assert not given(device, w, sure, plain).any()


def test_pixels_take_the_plane_of_near_pixels(device):
    w, textured = np.where(u < WIDTH // 2, 0.5, 0.7), frame(10)
    priors = given(device, np.where((u + v) % 9 == 0, 0.9, w), textured, ~textured)  # and some pixels on no plane
    inner = ~textured & (np.abs(u - WIDTH // 2) > 4)
    np.testing.assert_allclose(priors[inner][:, 0], w[inner], atol=1e-6)
