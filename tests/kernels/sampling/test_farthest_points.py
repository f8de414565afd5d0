"""Farthest points: both shapes of the kernel choose what the plain algorithm chooses, bit for bit."""

import numpy as np
import pytest

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.sampling import farthest_points
from pointloom.kernels.sampling.farthest_points import choose_farthest
from pointloom.kernels.search.point_tree import PointTree

SHAPES = {"in turn": False, "at once": True}


def plain(points, count, start):
    """The O(n m) algorithm in float32, in the order of the kernel's own arithmetic; ties to the lowest index."""
    points = points.astype(np.float32)
    distances = np.where(np.isfinite(points).all(axis=1), np.float32(np.inf), np.float32(-1))
    chosen = []
    while len(chosen) < count:
        chosen.append(start)
        with np.errstate(over="ignore", invalid="ignore"):
            d = points - points[start]
            d *= d
            sqdist = (d[:, 0] + d[:, 1]) + d[:, 2]
        distances = np.where(sqdist < distances, sqdist, distances)
        start = int(np.argmax(distances))
        if distances[start] <= 0:
            break
    return chosen


def choose(device, points, count, start, at_once):
    tree = PointTree(upload(points, vec3, device))
    return choose_farthest(tree, count, start, at_once).tolist()


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("count", [1, 2, 7, 8, 9, 63, 64, 65, 511, 513, 4097])
def test_choices_are_those_of_the_plain_algorithm(device, count, shape, rng):
    points = rng.normal(size=(count, 3)).astype(np.float32)
    samples, start = min(count, 300), count // 2
    assert choose(device, points, samples, start, SHAPES[shape]) == plain(points, samples, start)


@pytest.mark.parametrize("shape", SHAPES)
def test_points_equally_far_are_chosen_by_index(device, shape, rng):
    lattice = np.stack(np.meshgrid(*[np.arange(7)] * 3), -1).reshape(-1, 3)
    points = np.repeat(lattice, 2, axis=0)[rng.permutation(686)].astype(np.float32)
    result = choose(device, points, 400, 5, SHAPES[shape])
    assert result == plain(points, 400, 5)
    assert len(result) == 343, "each position once"


@pytest.mark.parametrize("shape", SHAPES)
def test_points_that_are_not_finite_are_never_chosen(device, shape, rng):
    points = rng.random((300, 3)).astype(np.float32)
    points[::3, 1], points[1] = np.nan, [np.inf, 0, 0]
    result = choose(device, points, 300, 2, SHAPES[shape])
    assert result == plain(points, 300, 2)
    assert sorted(result) == np.flatnonzero(np.isfinite(points).all(axis=1)).tolist()


@pytest.mark.parametrize("shape", SHAPES)
def test_distances_beyond_float32_are_chosen_first(device, shape, rng):
    points = (rng.normal(size=(200, 3)) * 3e19).astype(np.float32)
    points[:5] *= np.float32(1e-19)
    assert choose(device, points, 150, 3, SHAPES[shape]) == plain(points, 150, 3)


def test_choices_continue_across_launches(device, rng, monkeypatch):
    points = rng.random((700, 3)).astype(np.float32)
    expected = plain(points, 200, 9)
    for choices in (1, 2, 199, 200):
        monkeypatch.setattr(farthest_points, "CHOICES", choices)
        assert choose(device, points, 200, 9, False) == expected


def test_choices_continue_across_loops(device, rng, monkeypatch):
    points = rng.random((700, 3)).astype(np.float32)
    expected = plain(points, 200, 9)
    for choices in (farthest_points.STEPS, 2 * farthest_points.STEPS, 10 * farthest_points.STEPS):
        monkeypatch.setattr(farthest_points, "LOOPED", choices)
        assert choose(device, points, 200, 9, True) == expected
