"""Hash maps and sets of tensors: Python's dictionaries, with rows of buffers."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom.open3d.core as o3c

KEYS = st.lists(st.tuples(st.integers(-3, 3), st.integers(0, 2)), min_size=1, max_size=12)
STEPS = st.lists(st.tuples(st.sampled_from(["insert", "activate", "erase", "find"]), KEYS), max_size=8)


@settings(max_examples=60, deadline=None)
@given(steps=STEPS)
def test_a_map_holds_what_a_dictionary_holds(steps):
    table = o3c.HashMap(2, o3c.int32, (2,), (o3c.int64, o3c.float32), ((), (3,)))
    expected: dict[tuple[int, int], int] = {}
    for number, (step, keys) in enumerate(steps):
        tensor = o3c.Tensor(keys, o3c.int32)
        known = [key in expected for key in keys]
        is_first = [keys.index(key) == i for i, key in enumerate(keys)]
        if step in ("insert", "activate"):
            numbers = o3c.Tensor(np.arange(len(keys)) + 100 * number)
            values = [numbers, numbers.to(o3c.float32).reshape((-1, 1)) + o3c.Tensor.zeros((1, 3))]
            rows, masks = table.insert(tensor, values) if step == "insert" else table.activate(tensor)
            added = masks.numpy()
            assert added.tolist() == [first and not old for first, old in zip(is_first, known, strict=True)]
            if step == "activate":
                table.value_tensor()[rows[masks]] = numbers[masks]
                table.value_tensor(1)[rows[masks]] = values[1][masks]
            expected |= {keys[i]: 100 * number + int(i) for i in np.flatnonzero(added)}
        elif step == "erase":
            masks = table.erase(tensor).numpy()
            assert masks.tolist() == [first and old for first, old in zip(is_first, known, strict=True)]
            for key in keys:
                expected.pop(key, None)
        rows, masks = table.find(tensor)
        assert masks.numpy().tolist() == [key in expected for key in keys]
        found = [expected[key] for key in keys if key in expected]
        assert table.value_tensor()[rows[masks]].numpy().tolist() == found
        assert table.value_tensor(1)[rows[masks]].numpy().tolist() == [[value] * 3 for value in found]
        assert table.size() == len(expected) <= table.capacity()
        active = table.active_buf_indices()
        assert {tuple(key) for key in table.key_tensor()[active].numpy().tolist()} == set(expected)


def test_rows_stay_when_the_buffers_grow_and_copies_are_independent(device, tmp_path):
    table = o3c.HashMap(2, o3c.int64, (1,), o3c.float64, (2,), device=o3c.Device(device))
    keys = o3c.Tensor([5, -7], device=device)
    rows, _ = table.insert(keys, o3c.Tensor([[1.0, 2], [3, 4]], device=device))
    table.reserve(1000)
    copied, moved = table.clone(), table.cpu()
    assert (table.capacity(), table.key_tensor().shape, table.device.name) == (1000, [1000, 1], device)
    assert table.erase(keys[:1]).numpy().tolist() == [True]
    for other in (copied, moved) if device != "cpu" else (copied,):
        assert other.find(keys.to(other.device))[1].numpy().all()
        assert other.value_tensor()[rows.to(other.device)].numpy().tolist() == [[1, 2], [3, 4]]
    table.save(tmp_path / "table.npz")
    stored = o3c.HashMap.load(tmp_path / "table.npz")
    assert (stored.size(), stored.capacity(), len(stored.value_tensors())) == (1, 1, 1)
    assert stored.value_tensor()[stored.find(o3c.Tensor([-7]))[0]].numpy().tolist() == [[3, 4]]


def test_a_set_has_keys_only():
    keys = o3c.Tensor([[1, 2, 3], [2, 3, 4], [1, 2, 3]], o3c.int16)
    table = o3c.HashSet(1, o3c.int16, (3,))
    rows, masks = table.insert(keys)
    assert (rows.dtype, rows.numpy().tolist(), masks.numpy().tolist()) == (o3c.int32, [0, 1, 0], [True, True, False])
    assert table.find(keys + 1)[1].numpy().tolist() == [True, False, True]
    assert table.insert(o3c.Tensor.zeros((0, 3), o3c.int16))[0].shape == (0,)


@pytest.mark.parametrize(
    ("call", "argument"),
    [
        (lambda: o3c.HashSet(1, o3c.float32, (1,)), "key_dtype"),
        (lambda: o3c.HashSet(0, o3c.int32, (1,)), "init_capacity"),
        (lambda: o3c.HashMap(1, o3c.int32, (1,), [o3c.int32], []), "value_element_shapes"),
        (lambda: o3c.HashSet(1, o3c.int32, (3,)).find(o3c.Tensor([[1, 2]], o3c.int32)), "keys"),
        (lambda: o3c.HashSet(1, o3c.int32, (2,)).find(o3c.Tensor([[1, 2]], o3c.int64)), "keys"),
        (
            lambda: o3c.HashMap(1, o3c.int64, (1,), o3c.int64, (1,)).insert(o3c.Tensor([1]), o3c.Tensor([1, 2])),
            "values",
        ),
        (lambda: o3c.HashMap(1, o3c.int64, (1,), o3c.int64, (1,)).insert(o3c.Tensor([1]), []), "values"),
    ],
)
def test_errors_name_the_argument(call, argument):
    with pytest.raises(ValueError, match=argument):
        call()
