"""Results of long computations that are kept in a folder."""

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.core.kept_arrays import INPUTS, kept_arrays, remove_kept_arrays


def run(folder, inputs="a", *, stop=None):
    """Three steps, each of the one before, with an interruption before one of them: the result and the steps made."""
    made = []

    def step(name, value):
        def make():
            if name == stop:
                raise KeyboardInterrupt
            made.append(name)
            return {"value": value, "count": np.array(len(value))}

        return make

    with kept_arrays(folder, lambda: inputs) as kept:
        value = kept.get("one", step("one", np.arange(3.0)))["value"]
        value = kept.get("two", step("two", value * 2))["value"]
        return kept.get("three", step("three", value + 1))["value"].tolist(), made


@pytest.mark.parametrize(("stop", "left"), [("two", ["two", "three"]), ("three", ["three"])])
def test_an_interrupted_computation_continues(tmp_path, stop, left):
    with pytest.raises(KeyboardInterrupt):
        run(tmp_path / "work", stop=stop)
    assert run(tmp_path / "work") == ([1.0, 3.0, 5.0], left)
    assert run(tmp_path / "work") == ([1.0, 3.0, 5.0], [])
    assert run(None) == ([1.0, 3.0, 5.0], ["one", "two", "three"])


def test_other_inputs_start_again(tmp_path):
    run(tmp_path / "work")
    assert run(tmp_path / "work", "b")[1] == ["one", "two", "three"]
    (tmp_path / "work" / INPUTS).write_text("{")
    assert run(tmp_path / "work", "b")[1] == ["one", "two", "three"]


@pytest.mark.parametrize("damage", [b"", b"PK", None])
def test_a_damaged_step_is_made_again(tmp_path, damage):
    run(tmp_path / "work")
    path = tmp_path / "work" / "two.npz"
    content = path.read_bytes()
    path.write_bytes(content[:-40] if damage is None else damage)
    assert run(tmp_path / "work") == ([1.0, 3.0, 5.0], ["two"])
    assert path.read_bytes() == content


def test_foreign_folders_are_neither_used_nor_removed(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(FileError, match="do not belong to a run"):
        run(tmp_path)
    remove_kept_arrays(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]


def test_nothing_is_left_without_a_finished_step_or_after_removal(tmp_path):
    with pytest.raises(KeyboardInterrupt):
        run(tmp_path / "work", stop="one")
    assert list(tmp_path.iterdir()) == []
    run(tmp_path / "work")
    with kept_arrays(tmp_path / "work", lambda: "a"), pytest.raises(FileError, match="another run is using it"):
        run(tmp_path / "work")
    remove_kept_arrays(tmp_path / "work")
    assert list(tmp_path.iterdir()) == []
