"""Results of long computations that are kept in a folder."""

import json

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.core.kept_arrays import INPUTS, kept_arrays, remove_kept_arrays
from pointloom.io.points.npz import read_arrays

NAMES = ("one", "two", "three")


def read_step(path):
    """The arrays of a step of `run`, as its caller validates them."""
    arrays = read_arrays(path)
    if arrays.keys() != {"value", "count"} or arrays["value"].shape != (3,) or arrays["value"].dtype != float:
        raise FileError(path, "expected three numbers")
    return arrays


def run(folder, inputs="a", *, stop=None):
    """Three steps, each of the one before, with an interruption before one of them: the result and the steps made."""
    made = []

    def step(name, value):
        def make():
            if name == stop:
                raise KeyboardInterrupt
            made.append(name)
            return {"value": value, "count": np.array(len(value))}

        return name, make, read_step

    with kept_arrays(folder, lambda: inputs) as kept:
        value = kept.get(*step("one", np.arange(3.0)))["value"]
        value = kept.get(*step("two", value * 2))["value"]
        return kept.get(*step("three", value + 1))["value"].tolist(), made


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize(("stop", "left"), [("two", ["two", "three"]), ("three", ["three"])])
def test_an_interrupted_computation_continues(tmp_path, stop, left):
    with pytest.raises(KeyboardInterrupt):
        run(tmp_path / "work", stop=stop)
    assert run(tmp_path / "work") == ([1.0, 3.0, 5.0], left)
    assert run(tmp_path / "work") == ([1.0, 3.0, 5.0], [])
    assert run(None) == ([1.0, 3.0, 5.0], list(NAMES))


def test_other_inputs_start_again_and_keep_other_files(tmp_path):
    run(tmp_path / "work")
    (tmp_path / "work" / "scan.npz").write_bytes(b"mine")
    (tmp_path / "work" / ".one.npz.0123456789abcdef.part").write_bytes(b"of a killed process")
    assert run(tmp_path / "work", "b")[1] == list(NAMES)
    assert (tmp_path / "work" / "scan.npz").read_bytes() == b"mine"
    remove_kept_arrays(tmp_path / "work")
    assert contents(tmp_path / "work") == {"scan.npz": b"mine"}


@pytest.mark.parametrize("damage", [b"", b"PK", None])
def test_a_damaged_step_is_made_again(tmp_path, damage):
    run(tmp_path / "work")
    path = tmp_path / "work" / "two.npz"
    content = path.read_bytes()
    path.write_bytes(content[:-40] if damage is None else damage)
    assert run(tmp_path / "work") == ([1.0, 3.0, 5.0], ["two"])
    assert path.read_bytes() == content


def test_a_step_of_other_content_is_made_again_though_its_digest_matches(tmp_path):
    run(tmp_path / "work")
    (tmp_path / "work" / "other.npz").write_bytes(b"")
    with kept_arrays(tmp_path / "work", lambda: "a") as kept, pytest.raises(FileError, match="another program"):
        kept.get("other", dict, read_step)
    (tmp_path / "work" / "two.npz").unlink()
    with kept_arrays(tmp_path / "work", lambda: "a") as kept:
        kept.get("two", lambda: {"value": np.array(["x"])}, read_step)
    assert run(tmp_path / "work") == ([1.0, 3.0, 5.0], ["two"])


@pytest.mark.parametrize("marker", ["{", '{"mesh": "scan.ply"}', '{"inputs": "a"}', None])
def test_foreign_folders_are_neither_used_nor_removed(tmp_path, marker):
    (tmp_path / "notes.txt").write_text("mine")
    (tmp_path / "one.npz").write_text("mine")
    if marker is not None:
        (tmp_path / INPUTS).write_text(marker)
    before = contents(tmp_path)
    with pytest.raises(FileError, match="do not belong to a run"):
        run(tmp_path)
    remove_kept_arrays(tmp_path)
    assert contents(tmp_path) == before


@pytest.mark.parametrize("name", ["../mine.npz", "/mine.npz", "mine.txt", "..", "*.npz", 3])
def test_a_manifest_names_only_steps_in_its_folder(tmp_path, name):
    run(tmp_path / "work")
    (tmp_path / "mine.npz").write_text("mine")
    manifest = tmp_path / "work" / INPUTS
    content = json.loads(manifest.read_text())
    manifest.write_text(json.dumps(content | {"files": {name: "0"} if isinstance(name, str) else name}))
    with pytest.raises(FileError, match="do not belong to a run"):
        run(tmp_path / "work", "b")
    remove_kept_arrays(tmp_path / "work")
    assert (tmp_path / "mine.npz").read_text() == "mine" and manifest.exists()


@pytest.mark.parametrize("name", [INPUTS, "two.npz", "three.npz"])
@pytest.mark.parametrize("inputs", ["a", "b"])
def test_a_link_is_neither_followed_nor_removed(tmp_path, name, inputs):
    run(tmp_path / "work")
    target, link = tmp_path / "mine", tmp_path / "work" / name
    link.rename(target)
    link.symlink_to(target)
    before = target.read_bytes()
    with pytest.raises(FileError, match="is a symbolic link"):
        run(tmp_path / "work", inputs)
    remove_kept_arrays(tmp_path / "work")
    assert target.read_bytes() == before and link.is_symlink()


def test_nothing_is_left_without_a_finished_step_or_after_removal(tmp_path):
    with pytest.raises(KeyboardInterrupt):
        run(tmp_path / "work", stop="one")
    assert list(tmp_path.iterdir()) == []
    run(tmp_path / "work")
    with kept_arrays(tmp_path / "work", lambda: "a"):
        with pytest.raises(FileError, match="another run is using it"):
            run(tmp_path / "work")
        remove_kept_arrays(tmp_path / "work")
        assert len(contents(tmp_path / "work")) == 4
    remove_kept_arrays(tmp_path / "work")
    assert list(tmp_path.iterdir()) == []
