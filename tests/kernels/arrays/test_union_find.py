"""Disjoint sets united by many threads are the connected components, each with its lowest number as the root."""

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from pointloom.kernels.arrays.union_find import flatten_sets_kernel
from pointloom.kernels.lang import int32, launch
from pointloom.kernels.memory import download, upload

PAIRS = """
@kernel
def {name}_pairs_kernel(
    first: array(dtype=int32), second: array(dtype=int32), parents: array(dtype=int32), seen: array(dtype=int32)
):
    i = tid()
    seen[i] = {name}(parents, first[i], second[i])
"""
SOURCE = f"""
from pointloom.kernels.arrays.union_find import hook_roots, read_root, unite
{PAIRS.format(name="unite")}
{PAIRS.format(name="hook_roots")}
@kernel
def read_roots_kernel(parents: array(dtype=int32), roots: array(dtype=int32)):
    i = tid()
    roots[i] = read_root(parents, i)
"""


@pytest.fixture(scope="module")
def pairs_kernels(write_kernels):
    return write_kernels("union_find_kernels", SOURCE)


COUNT = 3001
CHAIN = np.stack([np.arange(COUNT - 1), np.arange(1, COUNT)], axis=1)
KINDS = {  # pairs of numbers
    "none": lambda rng: np.zeros((0, 2), int),
    "loops": lambda rng: np.stack([np.arange(COUNT)] * 2, axis=1),
    "chain": lambda rng: CHAIN,
    "chain backwards": lambda rng: CHAIN[::-1, ::-1],
    "chain shuffled": lambda rng: rng.permutation(CHAIN),
    "star about the last": lambda rng: np.stack([np.full(COUNT, COUNT - 1), rng.permutation(COUNT)], axis=1),
    "stars": lambda rng: np.stack([rng.permutation(COUNT), np.arange(COUNT) // 7 * 7], axis=1),
    "few": lambda rng: rng.integers(0, COUNT, (COUNT // 2, 2)),
    "many": lambda rng: rng.integers(0, COUNT, (20 * COUNT, 2)),
    "one pair often": lambda rng: np.tile([[2000, 5]], (5000, 1)),
}


@pytest.mark.parametrize("start", ["unite_pairs_kernel", "hook_roots_pairs_kernel"])
@pytest.mark.parametrize("kind", KINDS)
def test_sets_are_the_connected_components_with_their_lowest_number_as_root(device, kind, start, rng, pairs_kernels):
    """`hook_roots` gets numbers that are no roots any more, as a thread does where others were faster."""
    pairs = KINDS[kind](rng)
    first, second = (upload(side, int32, device) for side in (pairs[:, 0], pairs[:, 1]))
    parents, labels = upload(np.arange(COUNT), int32, device), upload(np.zeros(len(pairs)), int32, device)
    launch(getattr(pairs_kernels, start), len(pairs), [first, second, parents, labels])
    assert (download(parents) <= np.arange(COUNT)).all(), "links go to lower numbers"
    roots = upload(np.zeros(COUNT), int32, device)
    launch(pairs_kernels.read_roots_kernel, COUNT, [parents, roots])
    launch(flatten_sets_kernel, COUNT, [parents])

    joined = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(COUNT, COUNT))
    count, component = connected_components(joined, directed=False)
    lowest = np.full(count, COUNT)
    np.minimum.at(lowest, component, np.arange(COUNT))
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
