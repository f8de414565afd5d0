"""Processes that share the making of an octree: the same bytes, also where some of them die."""

from __future__ import annotations

import os
import signal
from functools import partial

import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.scale import tile_tree
from pointloom.scale.crew import MOST_DEATHS, Crew

from .scenes import survey

pytestmark = pytest.mark.slow  # processes are started


def add(more, value):
    return os.getpid(), more + value


def die(folder, deaths, value):
    """Kill this process at a value, so often."""
    if value == 2 and len([*folder.iterdir()]) < deaths:
        (folder / str(os.getpid())).touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return value


def refuse(value):
    raise FileError("made.laz", f"holds {value}", remedy="Take another")


def test_results_come_in_the_order_of_their_tasks_from_several_processes(tmp_path):
    with Crew(2, tmp_path) as crew:
        for more in (10, 20):
            found = [*crew.map(partial(add, more), ((k,) for k in range(9)))]
            assert [value for _, value in found] == [more + k for k in range(9)]
            assert os.getpid() not in {process for process, _ in found}
        with pytest.raises(FileError, match=r"holds 3\. Take another"):
            [*crew.map(refuse, [(3,)])]
    with Crew(0, tmp_path) as crew:
        assert [*crew.map(partial(add, 1), [(1,)])] == [(os.getpid(), 2)]


def test_what_a_dead_process_had_is_done_by_another(tmp_path):
    with Crew(2, tmp_path) as crew:
        assert [*crew.map(partial(die, tmp_path, MOST_DEATHS - 1), ((k,) for k in range(5)))] == [*range(5)]
    (tmp_path / "again").mkdir()
    with Crew(2, tmp_path / "made.laz") as crew, pytest.raises(FileError, match=r"made\.laz: 3 processes died at one"):
        [*crew.map(partial(die, tmp_path / "again", 99), ((k,) for k in range(5)))]


def test_any_number_of_workers_writes_the_same_bytes(tmp_path, monkeypatch):
    monkeypatch.setattr(tile_tree, "MOST", 900)
    monkeypatch.setattr(tile_tree, "LEAST", 30)
    keep = {"step": "remove_radius_outlier", "nb_points": 1, "radius": 50.0}
    loom.scale.plan_tiles(survey(tmp_path, count=4000), [keep], tmp_path / "job", size=15.0)
    assert loom.scale.run_tiles(tmp_path / "job").is_finished
    made = []
    for workers in (0, 2):
        (tmp_path / str(workers)).mkdir()
        told: list[tuple[str, int, int]] = []
        path = loom.scale.finish_tiles(
            tmp_path / "job", tmp_path / str(workers) / "made.copc.laz", workers=workers,
            progress=lambda *step, told=told: told.append(step),
        )  # fmt: skip
        made.append(path.read_bytes())
        assert told[-1][1] == told[-1][2] and len({step[1] for step in told}) > 4
    assert made[0] == made[1]
