"""The ordered hash table: one layout for any order of insertion, and block keys that survive the way there and back."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.kernels.arrays import hash_table
from pointloom.kernels.arrays.block_keys import BIAS, block_key, key_block
from pointloom.kernels.arrays.hash_table import EMPTY, HashTable
from pointloom.kernels.lang import array, int64, kernel, launch, tid, vec3i
from pointloom.kernels.memory import empty, upload
from pointloom.kernels.volumes.tsdf_blocks import block_box


@kernel
def encode_blocks_kernel(blocks: array(dtype=vec3i), keys: array(dtype=int64)):
    i = tid()
    keys[i] = block_key(blocks[i][0], blocks[i][1], blocks[i][2])


@kernel
def decode_blocks_kernel(keys: array(dtype=int64), blocks: array(dtype=vec3i)):
    i = tid()
    blocks[i] = key_block(keys[i])


def encode(blocks, device):
    keys = empty(len(blocks), int64, device)
    launch(encode_blocks_kernel, len(blocks), [upload(np.asarray(blocks), vec3i, device), keys])
    return keys.numpy()


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


def test_sequential_insertion_equals_batch_insertion(device, rng, monkeypatch):
    keys, tables = random_keys(rng, 1500), []
    for max_sequential in (0, 10_000):
        monkeypatch.setattr(hash_table, "MAX_SEQUENTIAL", max_sequential)
        tables.append(fill(keys, device, parts=7))
    at_once, sequential = tables
    assert at_once.keys.numpy().tobytes() == sequential.keys.numpy().tobytes()
    for table in tables:
        np.testing.assert_array_equal(find(table, keys, device), np.arange(len(keys)))


@pytest.mark.parametrize("count", [2, 37, 400, 512])
def test_the_layout_does_not_depend_on_the_order_of_insertion(device, rng, count):
    keys = random_keys(rng, count)
    layouts = {fill(order, device).keys.numpy().tobytes() for order in (keys, keys[::-1], np.sort(keys))}
    assert len(layouts) == 1


@pytest.mark.parametrize("count", [2, 37, 400, 512])
def test_keys_ascend_along_each_probe_sequence(device, rng, count):
    """The invariant that lets a search stop at the first larger key; 512 keys fill half of the slots."""
    slots = fill(random_keys(rng, count), device).keys.numpy()
    taken = np.flatnonzero(slots != EMPTY)
    assert len(taken) == count
    for at in taken:
        key = int(slots[at])
        h = key ^ ((key >> 33) & 0x7FFFFFFF)
        h = h * -49064778989728563 & (1 << 64) - 1
        at_home = (h ^ (h >> 29)) & (len(slots) - 1)
        probe = np.arange(at_home, at_home + (at - at_home) % len(slots)) % len(slots)
        assert (slots[probe] < key).all()


def test_each_key_has_its_list_index_and_others_are_missing(device, rng):
    keys = random_keys(rng, 4000)
    shuffled = rng.permutation(4000)
    found = find(fill(keys[:3000], device), keys[shuffled], device)
    np.testing.assert_array_equal(found, np.where(shuffled < 3000, shuffled, -1))


@pytest.mark.parametrize("parts", [2, 7, 60])
def test_keys_appended_in_parts_give_the_table_of_keys_appended_at_once(device, rng, parts):
    keys = random_keys(rng, 500)
    at_once, pieces = fill(keys, device), fill(keys, device, parts)
    assert pieces.capacity == at_once.capacity == 1024
    assert pieces.keys.numpy().tobytes() == at_once.keys.numpy().tobytes()
    np.testing.assert_array_equal(find(pieces, keys, device), np.arange(500))


def test_a_table_grows_and_keeps_its_contents(device, rng):
    keys = random_keys(rng, 6000)
    table, on_device, capacities = HashTable(device), upload(keys, int64, device), set()
    for before, count in itertools.pairwise((0, 1, 511, 512, 513, 2000, 2001, 6000)):
        table.append(on_device, count, count - before)
        capacities.add(table.capacity)
        assert 2 * count <= table.capacity
        np.testing.assert_array_equal(find(table, keys, device), np.where(np.arange(6000) < count, np.arange(6000), -1))
    assert len(capacities) > 2
    assert (table.keys.numpy() != EMPTY).sum() == 6000


def test_a_hundred_thousand_keys_get_their_slots(device, rng):
    keys = random_keys(rng, 100_000)
    np.testing.assert_array_equal(find(fill(keys, device, 3), keys, device), np.arange(100_000))


@pytest.mark.parametrize("key", [0, 1, (1 << 63) - 2])
def test_a_table_of_one_key_finds_only_that_key(device, key):
    table = fill(np.array([key]), device)
    assert find(table, [key, 5, 1 << 40], device).tolist() == [0, -1, -1]


def test_an_empty_table_finds_nothing_and_takes_empty_questions(device):
    table = HashTable(device)
    assert find(table, [0, 1, 17], device).tolist() == [-1, -1, -1]
    assert find(table, [], device).tolist() == []
    table.append(empty(0, int64, device), 0, 0)
    assert (table.keys.numpy() == EMPTY).all()


def test_asking_again_for_keys_that_are_there_changes_nothing(device, rng):
    keys = random_keys(rng, 300)
    table = fill(keys, device)
    before = table.keys.numpy().tobytes()
    table.append(upload(keys, int64, device), 300, 300)
    assert table.keys.numpy().tobytes() == before
    np.testing.assert_array_equal(find(table, keys, device), np.arange(300))


coordinates = st.integers(-BIAS, BIAS - 1)


@settings(deadline=None, derandomize=True, max_examples=25)
@given(st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=1, max_size=20))
def test_blocks_survive_their_keys_and_keys_ascend_with_x_then_y_then_z(blocks):
    array_ = np.array([*blocks, (-BIAS, -BIAS, -BIAS), (-1, 0, -1), (BIAS - 1, -BIAS, 0)])
    keys = encode(array_, "cpu")
    expected = ((array_[:, 0] + BIAS) << 42) | ((array_[:, 1] + BIAS) << 21) | (array_[:, 2] + BIAS)
    np.testing.assert_array_equal(keys, expected)
    assert (keys >= 0).all()
    np.testing.assert_array_equal(np.argsort(keys, kind="stable"), np.lexsort(array_.T[::-1]))
    np.testing.assert_array_equal(block_box(keys), array_)


def test_negative_blocks_survive_their_keys(device, rng):
    corners = [[-BIAS] * 3, [BIAS - 1, BIAS - 1, -BIAS]]
    blocks = np.concatenate([rng.integers(-BIAS, BIAS, (1000, 3)), rng.integers(-3, 3, (1000, 3)), corners])
    keys = encode(blocks, device)
    out = empty(len(blocks), vec3i, device)
    launch(decode_blocks_kernel, len(blocks), [upload(keys, int64, device), out])
    np.testing.assert_array_equal(out.numpy(), blocks)
    np.testing.assert_array_equal(block_box(keys), blocks)
