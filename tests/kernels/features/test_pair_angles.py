"""Bins of pair features: float32 equals float64 or is flagged as uncertain, and float64 equals the formula."""

import numpy as np
import pytest

from pointloom.kernels.features.pair_angles import UNSURE_BINS, exact_bins, quick_bins
from pointloom.kernels.lang import array, int32, kernel, launch, tid, vec3
from pointloom.kernels.memory import empty, upload


@kernel
def bin_pairs_kernel(
    p: array(dtype=vec3), n: array(dtype=vec3), q: array(dtype=vec3), m: array(dtype=vec3),
    quick: array(dtype=int32), exact: array(dtype=int32),
):  # fmt: skip
    i = tid()
    quick[i] = quick_bins(q[i] - p[i], n[i], m[i])
    exact[i] = exact_bins(p[i], n[i], q[i], m[i])


def both_bins(device, *pairs):
    count = len(pairs[0])
    quick, exact = empty(count, int32, device), empty(count, int32, device)
    launch(bin_pairs_kernel, count, [*(upload(np.float32(a), vec3, device) for a in pairs), quick, exact])
    return quick.numpy(), exact.numpy()


def formula(p, n, q, m):
    """The three angles in float64, in bins, not yet rounded down: [count, 3]."""
    p, n, q, m = (np.float32(a).astype(float) for a in (p, n, q, m))
    d = q - p
    with np.errstate(all="ignore"):
        size = np.linalg.norm(d, axis=1)
        first, second = ((x * d).sum(axis=1) / size for x in (n, m))
        swap = np.arccos(np.abs(first)) > np.arccos(np.abs(second))
        a, b = np.where(swap[:, None], m, n), np.where(swap[:, None], n, m)
        d = np.where(swap[:, None], -d, d)
        v = np.cross(d, a)
        across = np.linalg.norm(v, axis=1)
        v = v / across[:, None]
        turn = (np.arctan2((np.cross(a, v) * b).sum(axis=1), (a * b).sum(axis=1)) + np.pi) / (2 * np.pi)
        cosines = (v * b).sum(axis=1), np.where(swap, -second, first)
        angles = np.stack([turn, *((cosine + 1) / 2 for cosine in cosines)], axis=1)
    return 11 * np.where((size == 0)[:, None] | (across == 0)[:, None], 0.5, angles)


def split(bins):
    return np.stack([bins & 15, bins >> 4 & 15, bins >> 8], axis=1)


def unit(v):
    return v / np.linalg.norm(v, axis=1, keepdims=True)


def random_pairs(rng, count, spread):
    """Pairs on a surface whose normals differ by about `spread` from one direction a pair."""
    p, d, common = rng.normal(size=(3, count, 3))
    n, m = (unit(unit(common) + spread * rng.normal(size=(count, 3))) for _ in range(2))
    return p, n, p + 0.1 * d, m


def assert_agree(device, pairs):
    """Exact bins are the formula's but for its own rounding; quick ones are the exact ones or unsure."""
    quick, exact = both_bins(device, *pairs)
    levels = formula(*pairs)
    expected = np.clip(np.floor(levels), 0, 10).astype(int)
    near = np.abs(levels - np.round(levels)) < 1e-9
    assert ((split(exact) == expected) | near).all()
    sure = quick != UNSURE_BINS
    np.testing.assert_array_equal(quick[sure], exact[sure])
    return sure


@pytest.mark.parametrize("spread", [2.0, 0.3, 0.02, 1e-4, 1e-7])
def test_quick_bins_are_the_exact_ones_or_unsure(device, spread, rng):
    sure = assert_agree(device, random_pairs(rng, 20_000, spread))
    # Normals that are nearly parallel are a tie of which comes first, unless both are across the line.
    assert sure.mean() > (0.999 if spread > 0.01 else 0.9 if spread > 1e-5 else 0.02)


def test_bins_at_their_edges_are_float64s(device, rng):
    """Pairs moved by bisection to where an angle crosses an edge, to the last bits of float32."""
    p, n, q, m = (np.float32(a) for a in random_pairs(rng, 4000, 1.0))
    other = np.float32(unit(rng.normal(size=m.shape)))
    low, high = np.zeros(len(p)), np.ones(len(p))
    at = lambda fraction: np.float32(unit(m + fraction[:, None] * (other - m)))  # noqa: E731
    start = np.floor(formula(p, n, q, at(low)))
    changed = (np.floor(formula(p, n, q, at(high))) != start).any(axis=1)
    for _ in range(40):
        middle = (low + high) / 2
        same = (np.floor(formula(p, n, q, at(middle))) == start).all(axis=1)
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    assert changed.mean() > 0.5
    for fraction in (low, high):
        sure = assert_agree(device, [a[changed] for a in (p, n, q, at(fraction))])
        assert sure.mean() < 0.2, "the edge is too near for float32"


def test_flat_ground_is_quick(device, rng):
    """Equal normals on a plane tie for the first place at every pair; either order gives the middle bins."""
    p, q = rng.normal(size=(2, 1000, 3)) * [1, 1, 0]
    up = np.tile([0.0, 0, 1], (1000, 1))
    quick, exact = both_bins(device, p, up, q, up)
    assert (split(quick) == 5).all() and (split(exact) == 5).all()


@pytest.mark.parametrize("length", [1e-3, 0.5, 0.98, 1.02, 3.0])
def test_normals_need_not_be_of_unit_length(device, length, rng):
    """Averages of normals are shorter; arc cosines of slopes beyond 1 are NaN in Open3D, and nothing is swapped."""
    p, n, q, m = random_pairs(rng, 4000, 0.5)
    for lengths in ((length, length), (1, length), (length, 1)):
        assert_agree(device, (p, lengths[0] * n, q, lengths[1] * m))


@pytest.mark.parametrize("scale", [0.0, 1e-25, 1e-15, 1e-6, 1e6, 1e15, 1e25])
def test_bins_do_not_depend_on_scale(device, scale, rng):
    p, n, q, m = random_pairs(rng, 4000, 0.5)
    assert_agree(device, (scale * p, n, scale * q, m))


def test_points_along_the_normal_have_no_angles(device):
    up, side = [0.0, 0, 1], [1.0, 0, 0]
    none = [0.0, 0, 0]
    pairs = [(up, up, up), (up, [0, 0, -2], side), (up, none, side), (side, up, up), (none, [1, 2, 3], none)]
    n, q, m = (np.array(column, float) for column in zip(*pairs, strict=True))
    quick, exact = both_bins(device, np.zeros((5, 3)), n, q, m)
    assert (quick == UNSURE_BINS).all() and (split(exact) == 5).all()
