"""A clock measures and reports its stages, and memory has one unit."""

import ctypes
import subprocess
import sys
import time
from types import SimpleNamespace

import pytest

from pointloom.core import timing
from pointloom.core.timing import Clock, peak_bytes, peak_bytes_of_all


@pytest.fixture
def now(monkeypatch):
    hands = [10.0]
    monkeypatch.setattr(timing.time, "perf_counter", lambda: hands[0])
    return hands


def test_a_repeated_stage_adds_to_its_seconds(now):
    clock = Clock()
    for stage, seconds in (("read", 2.0), ("fuse", 1.0), ("read", 0.5)):
        now[0] += seconds
        clock.stop(stage)
    assert clock.seconds == {"read": 2.5, "fuse": 1.0}
    assert list(clock.cpu_seconds) == ["read", "fuse"]


def test_time_between_stages_is_not_counted(now):
    clock = Clock()
    now[0] += 5.0
    with clock.stage("read"):
        now[0] += 1.0
    now[0] += 5.0
    clock.restart()
    now[0] += 0.25
    clock.stop("write")
    assert clock.seconds == {"read": 1.0, "write": 0.25}


def test_stages_are_reported_when_they_begin(now):
    steps = []
    clock = Clock(lambda *step: steps.append(step))
    with clock.stage("read"):
        assert steps == [("read", 0, 0)]
    clock.stop("write")
    assert steps == [("read", 0, 0)]


def test_a_stage_that_fails_is_not_counted(now):
    clock = Clock()
    with pytest.raises(KeyError), clock.stage("read"):
        raise KeyError
    assert clock.seconds == {}


@pytest.mark.slow
def test_seconds_of_the_cpu_are_those_of_processes_too():
    clock, start = Clock(), time.process_time()
    subprocess.run([sys.executable, "-c", "sum(range(3_000_000))"], check=True)
    clock.stop("count")
    assert clock.cpu_seconds["count"] > time.process_time() - start


def test_memory_is_counted_in_bytes():
    peak = peak_bytes()
    assert 1 << 20 < peak <= peak_bytes_of_all() < 1 << 45


@pytest.mark.parametrize(("system", "unit"), [("linux", 1024), ("darwin", 1)])
def test_the_unit_of_peak_memory_follows_the_system(system, unit, monkeypatch):
    peaks = {"of this process": 7, "of children": 9}
    usage = SimpleNamespace(RUSAGE_SELF="of this process", RUSAGE_CHILDREN="of children")
    usage.getrusage = lambda who: SimpleNamespace(ru_maxrss=peaks[who])
    monkeypatch.setitem(sys.modules, "resource", usage)
    monkeypatch.setattr(sys, "platform", system)
    assert (peak_bytes(), peak_bytes_of_all()) == (7 * unit, 9 * unit)


def test_windows_reports_peak_memory(monkeypatch):
    """PROCESS_MEMORY_COUNTERS has 72 bytes: its size and a count of 4 bytes each, then the peak."""

    def fill(process, counters, size):
        assert (process.value, size) == (2**64 - 1, 72)
        ctypes.memmove(ctypes.byref(counters._obj, 8), (123 << 20).to_bytes(8, "little"), 8)

    libraries = {"kernel32": SimpleNamespace(K32GetProcessMemoryInfo=fill)}
    monkeypatch.setattr(ctypes, "WinDLL", libraries.__getitem__, raising=False)
    monkeypatch.setitem(sys.modules, "resource", None)
    monkeypatch.setattr(sys, "platform", "win32")
    assert peak_bytes() == peak_bytes_of_all() == 123 << 20
