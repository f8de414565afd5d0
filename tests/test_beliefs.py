"""The pairs of benchmarks/beliefs.py are what they are said to be, and its table counts them."""

from __future__ import annotations

import itertools
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

FOLDER = Path(__file__).resolve().parent.parent / "benchmarks"
NAMES = ("beliefs", "belief_scenes", "made_rooms", "real_scans", "real_data")


@pytest.fixture
def beliefs() -> Iterator[ModuleType]:
    """The module, with the benchmarks' folder on the path as when it runs."""
    for name in NAMES:
        sys.modules.pop(name, None)
    sys.path.insert(0, str(FOLDER))
    import beliefs

    yield beliefs
    sys.path.remove(str(FOLDER))
    for name in NAMES:
        sys.modules.pop(name, None)


def scan(beliefs, name, scene, shift=0.0, kind="room"):
    """A part of a bumpy floor, from a shift on, in a frame of its own that is turned."""
    x, y = np.random.default_rng(len(name)).uniform(0, 2, (2, 6000))
    points = np.column_stack([x + shift, y, 0.2 * np.sin(3 * (x + shift)) * np.cos(2 * y)])
    pose = np.array([[0, -1.0, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])
    return beliefs.Scan(name, scene, kind, (points - pose[:3, 3]) @ pose[:3, :3], pose)


def test_pairs_of_different_scenes_share_nothing_and_are_of_one_kind(beliefs):
    scenes = ("kitchen", "kitchen teaser", "cartons", "x")
    scans = [scan(beliefs, str(k), scene) for k, scene in enumerate(scenes)]
    scans.append(scan(beliefs, "e", "street", kind="street"))
    pairs = {frozenset((a.scene, b.scene)) for a, b in beliefs.different(scans, 1)}
    all_pairs = {frozenset(pair) for pair in itertools.combinations(scenes, 2)}
    assert pairs == all_pairs - {frozenset(("kitchen", "kitchen teaser"))}  # those may show the same place


def test_overlapping_pairs_come_with_their_share_and_pose(beliefs):
    scans = [scan(beliefs, f"part {k}", "floor", shift) for k, shift in enumerate((0.0, 1.0, 1.9))]
    found = {(a.name, b.name): (T, share) for a, b, T, share in beliefs.overlapping(scans, 0.05)}
    assert set(found) == {("part 0", "part 1"), ("part 1", "part 2")}  # the third shares 5 % with the first
    T, share = found["part 0", "part 1"]
    np.testing.assert_allclose(T, np.eye(4), atol=1e-12)
    assert share == pytest.approx(0.5, abs=0.1)


def test_scenes_of_fresh_rooms_are_never_fitted_to(beliefs):
    names = [f"{kind} room {k}" for kind in ("made", "fresh") for k in range(40)]
    fitted = [beliefs.is_for_fitting(name) for name in names]
    assert 10 < sum(fitted[:40]) < 30 and not any(fitted[40:])


def test_the_table_counts_beliefs(beliefs):
    def belief(overlap, believed, right):
        return beliefs.Belief("a", "b", ("made room 0", "x"), "room", 0.05, None, overlap, 0.0, believed, right, [], "")

    rows = [(0.0, True, False), (0.0, False, False), (0.5, True, True), (0.5, True, False), (0.5, False, True)]
    lines = beliefs.table([belief(*row) for row in rows])
    assert lines[-1] == "| all | 1 of 2 | 1 of 3 | 1 |"


def test_a_made_room_is_seen_in_parts_that_lie_on_each_other(beliefs):
    import made_rooms

    (a, pose_a), (b, pose_b) = made_rooms.fragments(3, (0.0, 40.0), frames=2, sweep=30.0)
    there = (a @ pose_a[:3, :3].T + pose_a[:3, 3], b @ pose_b[:3, :3].T + pose_b[:3, 3])
    size = made_rooms.furnish(3)[1]
    for points in there:
        assert len(points) > 1000 and (points > -0.1).all() and (points < size + 0.1).all()
