"""A clock counts what happens in its stages, tells of them, and has one unit for memory."""

import subprocess
import sys
import time

import pytest

from pointloom.core import timing
from pointloom.core.timing import Clock, peak_bytes, peak_bytes_of_all


@pytest.fixture
def now(monkeypatch):
    """A clock on the wall that goes when it is told to."""
    hands = [10.0]
    monkeypatch.setattr(timing.time, "perf_counter", lambda: hands[0])
    return hands


def test_a_stage_that_comes_again_adds_to_its_seconds(now):
    clock = Clock()
    for stage, seconds in (("read", 2.0), ("fuse", 1.0), ("read", 0.5)):
        now[0] += seconds
        clock.stop(stage)
    assert clock.seconds == {"read": 2.5, "fuse": 1.0}
    assert list(clock.cpu_seconds) == ["read", "fuse"]


def test_what_passes_between_stages_counts_to_none(now):
    clock = Clock()
    now[0] += 5.0
    with clock.stage("read"):
        now[0] += 1.0
    now[0] += 5.0
    clock.restart()
    now[0] += 0.25
    clock.stop("write")
    assert clock.seconds == {"read": 1.0, "write": 0.25}


def test_stages_are_told_when_they_begin(now):
    told = []
    clock = Clock(lambda *step: told.append(step))
    with clock.stage("read"):
        assert told == [("read", 0, 0)]
    clock.stop("write")
    assert told == [("read", 0, 0)]


def test_a_stage_that_fails_is_not_counted(now):
    clock = Clock()
    with pytest.raises(KeyError), clock.stage("read"):
        raise KeyError
    assert clock.seconds == {}


@pytest.mark.slow
def test_seconds_of_the_cpu_are_those_of_processes_too():
    clock, begun = Clock(), time.process_time()
    subprocess.run([sys.executable, "-c", "sum(range(3_000_000))"], check=True)
    clock.stop("count")
    assert clock.cpu_seconds["count"] > time.process_time() - begun


def test_memory_is_counted_in_bytes():
    held = peak_bytes()
    assert 1 << 20 < held <= peak_bytes_of_all() < 1 << 45
