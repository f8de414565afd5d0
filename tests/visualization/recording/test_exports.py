"""Recordings for other viewers, whose packages are not among those of the tests (tests/other_tools has them)."""

import importlib.util
import sys

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.recording import exports
from pointloom.visualization.recording.timeline import Frame, Placement, Shape, Timeline


@pytest.mark.parametrize(
    ("suffix", "module", "package"), [(".rrd", "rerun", "rerun-sdk"), (".mcap", "foxglove", "foxglove-sdk")]
)
def test_a_missing_package_is_an_error_before_any_work(tmp_path, monkeypatch, suffix, module, package):
    monkeypatch.setitem(sys.modules, module, None)
    find = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None if name == module else find(name))
    with pytest.raises(loom.FileError, match=f"pip install {package}"):
        loom.record(tmp_path / f"a{suffix}")
    assert list(tmp_path.iterdir()) == []


def test_only_frames_in_which_a_name_changes_are_written():
    shape = Shape("points", np.zeros((1, 3), np.float32))
    moved = np.diag([1.0, -1.0, -1.0, 1.0])
    shown = [{"a": Placement((0,))}, {"a": Placement((0,), np.eye(4))}, {"a": Placement((0,), moved)}, {}, {}]
    timeline = Timeline(np.zeros(3), [shape], [Frame(placements) for placements in shown])
    changes = {
        number: [(change.name, len(change.shapes), change.has_new_shapes) for change in changes]
        for number, _, changes in exports._changes(timeline)
    }
    assert changes == {0: [("a", 1, True)], 1: [], 2: [("a", 1, False)], 3: [("a", 0, True)], 4: []}


def test_mirrored_and_scaled_poses_are_not_rigid():
    turn = np.eye(4)
    turn[:2, :2] = [[0.6, -0.8], [0.8, 0.6]]
    assert exports._is_rigid(turn)
    assert not exports._is_rigid(np.diag([1.0, 1.0, -1.0, 1.0]))
    assert not exports._is_rigid(2 * turn)
