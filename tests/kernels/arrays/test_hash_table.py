"""Hash tables with one layout for any order of insertion, and disjoint sets that are connected components."""

import itertools

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from pointloom.kernels.arrays import hash_table
from pointloom.kernels.arrays.block_keys import CELL_BIAS, block_key, key_block
from pointloom.kernels.arrays.hash_table import EMPTY_KEY, HashTable
from pointloom.kernels.arrays.union_find import flatten_sets_kernel
from pointloom.kernels.lang import array, int32, int64, kernel, launch, tid, vec3i
from pointloom.kernels.memory import download, empty, upload
from pointloom.kernels.volumes.tsdf_blocks import block_box


@kernel
def encode_blocks_kernel(blocks: array(dtype=vec3i), keys: array(dtype=int64)):
    i = tid()
    keys[i] = block_key(blocks[i][0], blocks[i][1], blocks[i][2])


@kernel
def decode_blocks_kernel(keys: array(dtype=int64), blocks: array(dtype=vec3i)):
    i = tid()
    blocks[i] = key_block(keys[i])


def random_keys(rng, count):
    near = rng.integers(0, 1 << 20, count) | (1 << 62)
    far = rng.integers(0, (1 << 63) - 2, count)
    keys = np.unique(np.concatenate([near, far]).astype(np.int64))
    return rng.permutation(keys)[:count]


def fill(keys, device, parts=1):
    table, on_device = HashTable(device), upload(keys, int64, device)
    bounds = np.linspace(0, len(keys), parts + 1).astype(int)
    for a, b in itertools.pairwise(bounds):
        table.append(on_device, int(b), int(b - a))
    return table


def find(table, keys, device):
    indices, missing = table.find(upload(np.asarray(keys, np.int64), int64, device))
    assert ((indices.numpy() < 0) == missing.numpy().astype(bool)).all()
    return indices.numpy()


@pytest.mark.parametrize("parts", [1, 2, 7, 60])
def test_the_table_depends_neither_on_the_parts_in_which_keys_are_appended_nor_on_their_number(
    device, rng, monkeypatch, parts
):
    keys = random_keys(rng, 500)
    expected = fill(keys, device)
    for max_sequential in (0, 10_000):
        monkeypatch.setattr(hash_table, "MAX_SEQUENTIAL", max_sequential)
        table = fill(keys, device, parts)
        assert table.capacity == expected.capacity == 1024
        assert table.keys.numpy().tobytes() == expected.keys.numpy().tobytes()
        np.testing.assert_array_equal(find(table, keys, device), np.arange(500))


@pytest.mark.parametrize("count", [2, 37, 400, 512])
def test_keys_ascend_along_each_probe_sequence_for_any_order_of_insertion(device, rng, count):
    """The invariant that lets a search stop at the first larger key; 512 keys fill half of the slots."""
    keys = random_keys(rng, count)
    slots, *others = (fill(order, device).keys.numpy() for order in (keys, keys[::-1], np.sort(keys)))
    assert all(other.tobytes() == slots.tobytes() for other in others)
    taken = np.flatnonzero(slots != EMPTY_KEY)
    assert len(taken) == count
    for at in taken:
        key = int(slots[at])
        h = key ^ ((key >> 33) & 0x7FFFFFFF)
        h = h * -49064778989728563 & (1 << 64) - 1
        at_home = (h ^ (h >> 29)) & (len(slots) - 1)
        probe = np.arange(at_home, at_home + (at - at_home) % len(slots)) % len(slots)
        assert (slots[probe] < key).all()


def test_a_table_grows_and_keeps_its_contents(device, rng):
    keys = random_keys(rng, 6000)
    table, on_device, capacities = HashTable(device), upload(keys, int64, device), set()
    for before, count in itertools.pairwise((0, 1, 511, 512, 513, 2000, 2001, 6000)):
        table.append(on_device, count, count - before)
        capacities.add(table.capacity)
        assert 2 * count <= table.capacity
        np.testing.assert_array_equal(find(table, keys, device), np.where(np.arange(6000) < count, np.arange(6000), -1))
    assert len(capacities) > 2
    assert (table.keys.numpy() != EMPTY_KEY).sum() == 6000


@pytest.mark.parametrize("key", [0, 1, (1 << 63) - 2])
def test_a_table_of_one_key_finds_only_that_key(device, key):
    table = fill(np.array([key]), device)
    assert find(table, [key, 5, 1 << 40], device).tolist() == [0, -1, -1]


def test_an_empty_table_finds_nothing_and_takes_empty_questions(device):
    table = HashTable(device)
    assert find(table, [0, 1, 17], device).tolist() == [-1, -1, -1]
    assert find(table, [], device).tolist() == []
    table.append(empty(0, int64, device), 0, 0)
    assert (table.keys.numpy() == EMPTY_KEY).all()


def test_asking_again_for_keys_that_are_there_changes_nothing(device, rng):
    keys = random_keys(rng, 300)
    table = fill(keys, device)
    before = table.keys.numpy().tobytes()
    table.append(upload(keys, int64, device), 300, 300)
    assert table.keys.numpy().tobytes() == before
    np.testing.assert_array_equal(find(table, keys, device), np.arange(300))


def test_blocks_survive_their_keys_and_keys_ascend_with_x_then_y_then_z(device, rng):
    corners = [[-CELL_BIAS] * 3, [CELL_BIAS - 1, CELL_BIAS - 1, -CELL_BIAS]]
    blocks = np.concatenate([rng.integers(-CELL_BIAS, CELL_BIAS, (1000, 3)), rng.integers(-3, 3, (1000, 3)), corners])
    encoded, out = empty(len(blocks), int64, device), empty(len(blocks), vec3i, device)
    launch(encode_blocks_kernel, len(blocks), [upload(blocks, vec3i, device), encoded])
    launch(decode_blocks_kernel, len(blocks), [encoded, out])
    np.testing.assert_array_equal(out.numpy(), blocks)
    keys = encoded.numpy()
    np.testing.assert_array_equal(keys, (blocks + CELL_BIAS) @ [1 << 42, 1 << 21, 1])
    np.testing.assert_array_equal(block_box(keys), blocks)


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
    first, second = (upload(np.array(side), int32, device) for side in ([5, 4], [2, 5]))
    launch(pairs_kernels.unite_pairs_kernel, 2, [first, second, parents, upload(np.zeros(2), int32, device)])
    launch(flatten_sets_kernel, 6, [parents])
    assert download(parents).tolist() == [-1, 1, 2, -1, 2, 2]
