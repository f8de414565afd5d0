"""Random numbers: the published vectors of Philox, the same words in both compilers, and their distribution."""

import math

import numpy as np
import pytest

from pointloom.kernels import memory
from pointloom.kernels.arrays.random import gaussian_pair, philox, random_bits, random_uniform
from pointloom.kernels.lang import array, int64, kernel, launch, tid, uint64, vec2, vec4


@kernel
def philox_kernel(inputs: array(dtype=int64), words: array(dtype=int64)):
    i = tid()
    j = i * 6
    w = philox(
        uint64(inputs[j]), uint64(inputs[j + 1]), uint64(inputs[j + 2]),
        uint64(inputs[j + 3]), uint64(inputs[j + 4]), uint64(inputs[j + 5]),
    )  # fmt: skip
    for k in range(4):
        words[i * 4 + k] = int64(w[k])


@kernel
def draw_kernel(seed: int, part: int, words: array(dtype=int64), uniform: array(dtype=vec4), normal: array(dtype=vec4)):
    i = tid()
    w = random_bits(seed, i, part)
    for k in range(4):
        words[i * 4 + k] = int64(w[k])
    u = random_uniform(seed, i, part)
    first = gaussian_pair(u[0], u[1])
    second = gaussian_pair(u[2], u[3])
    uniform[i] = u
    normal[i] = vec4(first[0], first[1], second[0], second[1])


@kernel
def pair_kernel(uniform: array(dtype=vec2), normal: array(dtype=vec2)):
    i = tid()
    normal[i] = gaussian_pair(uniform[i][0], uniform[i][1])


def draw(device, count, seed=0, stream=0):
    """Words [n, 4], uniform and normal numbers [n, 4] of the counters 0..n-1."""
    words = memory.empty(4 * count, int64, device)
    uniform, normal = memory.empty(count, vec4, device), memory.empty(count, vec4, device)
    launch(draw_kernel, count, [seed, stream, words, uniform, normal])
    return words.numpy().reshape(-1, 4).copy(), uniform.numpy().copy(), normal.numpy().copy()


def reference_words(counters, seed, stream):
    rows = []
    for counter in counters:
        c, k = [counter, 0, stream & 0xFFFFFFFF, 0], [seed & 0xFFFFFFFF, 0]
        for _ in range(10):
            p, q = 0xD2511F53 * c[0], 0xCD9E8D57 * c[2]
            c = [(q >> 32) ^ c[1] ^ k[0], q & 0xFFFFFFFF, (p >> 32) ^ c[3] ^ k[1], p & 0xFFFFFFFF]
            k = [(k[0] + 0x9E3779B9) & 0xFFFFFFFF, (k[1] + 0xBB67AE85) & 0xFFFFFFFF]
        rows.append(c)
    return np.array(rows, np.int64)


def test_the_published_vectors_come_out(device):
    """kat_vectors of Random123: zeros, ones, and the digits of pi."""
    ones = 0xFFFFFFFF
    inputs = [[0] * 6, [ones] * 6, [0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344, 0xA4093822, 0x299F31D0]]
    expected = [
        [0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8],
        [0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD],
        [0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1],
    ]
    words = memory.zeros(12, int64, device)
    launch(philox_kernel, 3, [memory.upload(np.array(inputs).ravel(), int64, device), words])
    assert words.numpy().reshape(3, 4).tolist() == expected


@pytest.mark.parametrize("seed", [0, 7, -1, 2**31 - 1, -(2**31)])
def test_words_are_those_of_plain_integers(device, seed):
    words, _, _ = draw(device, 200, seed=seed, stream=3)
    assert np.array_equal(words, reference_words(range(200), seed, 3))


def test_uniform_numbers_fill_the_unit_interval_evenly(device):
    _, uniform, _ = draw(device, 50_000)
    assert uniform.min() >= 0 and uniform.max() < 1
    counts = np.histogram(uniform, bins=100, range=(0, 1))[0]
    expected = uniform.size / 100
    chi_square = ((counts - expected) ** 2 / expected).sum()
    assert chi_square < 99 + 5 * math.sqrt(2 * 99)


def test_normal_numbers_have_the_moments_of_a_gaussian(device):
    _, _, normal = draw(device, 50_000, seed=5)
    samples = normal.astype(np.float64)
    bound = 5 / math.sqrt(samples.size)
    assert abs(samples.mean()) < bound
    assert abs(samples.var() - 1) < bound * math.sqrt(2) and abs((samples**3).mean()) < bound * math.sqrt(15)
    assert abs((samples**4).mean() - 3) < bound * math.sqrt(96) and np.isfinite(samples).all()


def test_seeds_streams_and_words_are_independent(device):
    columns = [draw(device, 20_000, seed, stream)[2] for seed, stream in ((0, 0), (1, 0), (0, 1))]
    correlation = np.corrcoef(np.hstack(columns), rowvar=False)
    assert np.abs(correlation - np.eye(12)).max() < 5 / math.sqrt(20_000)


def test_both_ends_of_the_uniform_numbers_give_finite_normal_ones(device):
    """The least is 0, the largest 1 - 2^-24: five and a half million draws meet neither for sure."""
    u, v = np.meshgrid([0, 2.0**-24, 0.5, 1 - 2.0**-24], [0, 0.25, 0.6, 1 - 2.0**-24])
    uniform = np.column_stack([u.ravel(), v.ravel()])
    normal = memory.empty(len(uniform), vec2, device)
    launch(pair_kernel, len(uniform), [memory.upload(uniform, vec2, device), normal])
    radius, angle = np.sqrt(-2 * np.log(1 - uniform[:, 0])), 2 * np.pi * uniform[:, 1]
    expected = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
    np.testing.assert_allclose(normal.numpy(), expected, atol=1e-5)
    assert np.abs(expected).max() < 5.8
