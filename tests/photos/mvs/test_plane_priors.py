"""Planes of plain places: fitted to what is sure, walls of one colour parted, what lies before them left out."""

from __future__ import annotations

import numpy as np
import pytest

from pointloom.photos.mvs.plane_priors import fit_priors

WIDTH, HEIGHT = 80, 60
v, u = np.mgrid[:HEIGHT, :WIDTH].astype(np.float64)
PIXELS_PER = 50.0


def given(w: np.ndarray, sure: np.ndarray, plain: np.ndarray, seed: int = 0) -> np.ndarray:
    planes = np.stack([w, w * 0, w * 0, w * 0], axis=-1).astype(np.float32)
    return fit_priors(plain.astype(np.float32), sure, planes, PIXELS_PER, seed)


def frame(width: int) -> np.ndarray:
    return (u < width) | (v < width) | (u >= WIDTH - width) | (v >= HEIGHT - width)


def test_a_plain_place_takes_the_plane_of_what_is_sure_around_it():
    w, textured = 0.5 + 0.002 * u - 0.001 * v, frame(10)
    noisy = w + np.random.default_rng(0).normal(0, 0.1 / PIXELS_PER, w.shape)
    priors = given(noisy, textured, ~textured)
    np.testing.assert_allclose(priors[~textured][:, 0], w[~textured], atol=0.1 / PIXELS_PER)
    np.testing.assert_allclose(priors[~textured][:, 1:3], np.tile([0.002, -0.001], ((~textured).sum(), 1)), atol=1e-4)
    assert (priors[~textured][:, 3] == 1).all()
    assert not priors[textured].any()


def test_what_lies_before_a_wall_does_not_bend_its_plane():
    w, textured = 0.5 + 0.002 * u - 0.001 * v, frame(10)
    before = np.where(textured & (u < 40) & (v < 20), 0.9, w)
    priors = given(before, textured, ~textured)
    np.testing.assert_allclose(priors[~textured][:, 0], w[~textured], atol=1e-3)


def test_two_walls_of_one_colour_have_a_plane_each():
    w, textured = 0.5 + 0.004 * np.minimum(u, WIDTH - u), frame(10)
    priors = given(w, textured, ~textured)
    off = np.abs(priors[..., 0] - w)[~textured]
    assert (off < 0.01).mean() > 0.9  # all but about the corner, which nothing marks


@pytest.mark.parametrize("kind", ["nothing sure", "a line", "a mess", "a speck"])
def test_where_no_plane_is_certain_there_is_no_prior(kind):
    w, textured = 0.5 + 0.002 * u, frame(10)
    sure, plain = textured, ~textured
    if kind == "nothing sure":
        sure = textured & False
    elif kind == "a line":
        sure = textured & (v == 9)
    elif kind == "a mess":
        w = np.random.default_rng(1).uniform(0.2, 1.0, w.shape)
    else:
        plain = (np.abs(u - 40) < 3) & (np.abs(v - 30) < 3)
        sure = ~plain
    assert not given(w, sure, plain).any()


def test_the_same_planes_come_twice():
    w, textured = 0.5 + 0.002 * u, frame(10)
    noisy = w + np.random.default_rng(0).normal(0, 0.3 / PIXELS_PER, w.shape)
    assert given(noisy, textured, ~textured).tobytes() == given(noisy, textured, ~textured).tobytes()
