"""Disjoint sets united by many threads are the connected components, each with its lowest number as the root."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from pointloom.kernels.arrays.union_find import flatten_sets_kernel
from pointloom.kernels.lang import int32, launch
from pointloom.kernels.memory import download, upload

SOURCE = """
from pointloom.kernels.arrays.union_find import hook_roots, read_root, unite

@kernel
def unite_pairs_kernel(
    first: array(dtype=int32), second: array(dtype=int32), parents: array(dtype=int32), seen: array(dtype=int32)
):
    i = tid()
    seen[i] = unite(parents, first[i], second[i])

@kernel
def hook_pairs_kernel(
    first: array(dtype=int32), second: array(dtype=int32), parents: array(dtype=int32), seen: array(dtype=int32)
):
    i = tid()
    seen[i] = hook_roots(parents, first[i], second[i])

@kernel
def read_roots_kernel(parents: array(dtype=int32), roots: array(dtype=int32)):
    i = tid()
    roots[i] = read_root(parents, i)
"""


@pytest.fixture(scope="module")
def pairs_kernels(write_kernels):
    return write_kernels("union_find_kernels", SOURCE)


def graph(kind, rng):
    """(numbers, pairs [m, 2])."""
    n = 3001
    chain = np.stack([np.arange(n - 1), np.arange(1, n)], axis=1)
    kinds = {
        "none": lambda: np.zeros((0, 2), int),
        "loops": lambda: np.stack([np.arange(n)] * 2, axis=1),
        "chain": lambda: chain,
        "chain backwards": lambda: chain[::-1, ::-1],
        "chain shuffled": lambda: rng.permutation(chain),
        "star about the last": lambda: np.stack([np.full(n, n - 1), rng.permutation(n)], axis=1),
        "stars": lambda: np.stack([rng.permutation(n), np.arange(n) // 7 * 7], axis=1),
        "few": lambda: rng.integers(0, n, (n // 2, 2)),
        "many": lambda: rng.integers(0, n, (20 * n, 2)),
        "one pair often": lambda: np.tile([[2000, 5]], (5000, 1)),
    }
    return n, kinds[kind]()


KINDS = ("none", "loops", "chain", "chain backwards", "chain shuffled", "star about the last", "stars", "few", "many",
         "one pair often")  # fmt: skip


@pytest.mark.parametrize("start", ["unite_pairs_kernel", "hook_pairs_kernel"])
@pytest.mark.parametrize("kind", KINDS)
def test_sets_are_the_connected_components_with_their_lowest_number_as_root(device, kind, start, rng, pairs_kernels):
    """`hook_roots` gets numbers that are no roots any more, as a thread does where others were faster."""
    n, pairs = graph(kind, rng)
    first, second = (upload(side, int32, device) for side in (pairs[:, 0], pairs[:, 1]))
    parents, labels = upload(np.arange(n), int32, device), upload(np.zeros(len(pairs)), int32, device)
    launch(getattr(pairs_kernels, start), len(pairs), [first, second, parents, labels])
    assert (download(parents) <= np.arange(n)).all(), "links go to lower numbers"
    roots = upload(np.zeros(n), int32, device)
    launch(pairs_kernels.read_roots_kernel, n, [parents, roots])
    launch(flatten_sets_kernel, n, [parents])

    joined = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(n, n))
    count, component = connected_components(joined, directed=False)
    lowest = np.full(count, n)
    np.minimum.at(lowest, component, np.arange(n))
    np.testing.assert_array_equal(download(parents), lowest[component])
    np.testing.assert_array_equal(download(roots), lowest[component])
    if len(pairs):
        np.testing.assert_array_equal(component[download(labels)], component[pairs[:, 0]])


def test_numbers_with_a_negative_parent_stay_outside(device, pairs_kernels):
    parents = upload(np.array([-1, 1, 2, -1, 4, 5]), int32, device)
    pairs = np.array([[5, 2], [4, 5]])
    first, second = (upload(side, int32, device) for side in (pairs[:, 0], pairs[:, 1]))
    launch(pairs_kernels.unite_pairs_kernel, 2, [first, second, parents, upload(np.zeros(2), int32, device)])
    launch(flatten_sets_kernel, 6, [parents])
    assert download(parents).tolist() == [-1, 1, 2, -1, 2, 2]
