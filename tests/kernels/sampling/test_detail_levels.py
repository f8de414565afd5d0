"""Levels of detail and farthest points are those of the plain algorithms, bitwise."""

import numpy as np
import pytest

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.sampling import farthest_points
from pointloom.kernels.sampling.detail_levels import LAST_CELL, LEVEL_COUNT, MAX_DEPTH, NODE_BITS, find_levels
from pointloom.kernels.sampling.farthest_points import choose_farthest
from pointloom.kernels.search.point_tree import PointTree


def plain_priority(index):
    """The bijection in plain whole numbers, as a signed number of 32 bits."""
    x = index & 0xFFFFFFFF
    x ^= x >> 16
    x = x * 0x7FEB352D & 0xFFFFFFFF
    x ^= x >> 15
    x = x * 0x846CA68B & 0xFFFFFFFF
    x ^= x >> 16
    return x - (1 << 32) if x >= 1 << 31 else x


def cells_of(points, corner, side):
    cells = np.floor((points.astype(np.float64) - corner) * (2.0**MAX_DEPTH / side)).astype(np.int64)
    return np.minimum(cells, LAST_CELL)


def plain_levels(points, corner, side):
    """Voxel by voxel on every level, the points by index."""
    cells, ranks = cells_of(points, corner, side), np.array([plain_priority(i) for i in range(len(points))])
    levels = np.full(len(points), LEVEL_COUNT - 1)
    for level in reversed(range(LEVEL_COUNT - 1)):
        voxels = cells >> (MAX_DEPTH - NODE_BITS - level)
        best = {}
        for i, voxel in enumerate(map(tuple, voxels.tolist())):
            if voxel not in best or ranks[i] < ranks[best[voxel]]:
                best[voxel] = i
        levels[list(best.values())] = level
    return levels


def levels_by_index(points, corner, side, device):
    _, order, levels = find_levels(upload(points, vec3, device), corner, side)
    assert np.array_equal(np.sort(order), np.flatnonzero(np.isfinite(points).all(axis=1)))
    result = np.empty(len(points), np.int64)
    result[order] = levels
    return result


def clouds(rng):
    ball = rng.normal(size=(700, 3)) * 0.02 + 0.5
    scales = 0.5 + rng.normal(size=(700, 3)) * 10.0 ** rng.uniform(-7, -1.2, (700, 1))
    few_positions = rng.integers(0, 4, (500, 3)) / 4
    return {
        "plane": rng.random((900, 3)) * [1, 1, 0],
        "ball": ball,
        "many scales": scales,
        "equal points": few_positions,
        "two": rng.random((2, 3)),
        "one": np.full((1, 3), 0.999999999),
        "a line that ends in the last cell": np.linspace(0, 1, 333)[:, None] * [1, 1, 1],
    }


@pytest.mark.parametrize("name", clouds(np.random.default_rng(0)))
def test_levels_are_those_of_the_definition(device, name, rng):
    points = np.clip(clouds(rng)[name], 0, 1).astype(np.float32)
    assert np.array_equal(levels_by_index(points, np.zeros(3), 1.0, device), plain_levels(points, np.zeros(3), 1.0))


def test_a_level_has_one_point_per_voxel(device, rng):
    """140,000 points, half of them in one place, so that walks pass blocks of blocks."""
    points = (rng.random((140_000, 3)) * [40, 40, 2] - 7).astype(np.float32)
    points[::2] = points[5]
    corner, side = np.full(3, -7.0), 64.0
    levels = levels_by_index(points, corner, side, device)
    cells = cells_of(points, corner, side)
    for level in range(LEVEL_COUNT - 1):
        x, y, z = (cells >> (MAX_DEPTH - NODE_BITS - level)).T
        voxels = (x << (2 * MAX_DEPTH)) | (y << MAX_DEPTH) | z
        standing = np.unique(voxels[levels <= level])
        assert len(standing) == (levels <= level).sum(), "none twice"
        assert len(standing) == len(np.unique(voxels)), "none missing"


def test_keys_ascend_and_equal_ones_by_index(device, rng):
    points = rng.integers(0, 3, (3000, 3)).astype(np.float32)
    points[::7, 1] = np.nan
    points[3] = [np.inf, 0, 0]
    keys, order, _ = find_levels(upload(points, vec3, device), np.zeros(3), 4.0)
    assert len(order) == np.isfinite(points).all(axis=1).sum()
    steps, index_steps = np.diff(keys), np.diff(order)
    assert (steps >= 0).all() and (index_steps[steps == 0] > 0).all()


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.full((4, 3), np.nan)], ids=["no point", "none finite"])
def test_of_no_points_there_are_no_levels(device, points):
    result = find_levels(upload(points.astype(np.float32), vec3, device), np.zeros(3), 1.0)
    assert [part.size for part in result] == [0, 0, 0]


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


def test_choices_continue_across_launches_and_loops(device, rng, monkeypatch):
    points = rng.random((700, 3)).astype(np.float32)
    expected = plain(points, 200, 9)
    cases = [("LAUNCH_CHOICES", count, False) for count in (1, 2, 199, 200)]
    cases += [("LOOP_CHOICES", k * farthest_points.STEP_CHOICES, True) for k in (1, 2, 10)]
    for name, choices, at_once in cases:
        monkeypatch.setattr(farthest_points, name, choices)
        assert choose(device, points, 200, 9, at_once) == expected
