"""Times of points are seconds where the message itself says in which unit they are."""

import warnings
from pathlib import Path

import numpy as np
import pytest

from pointloom.io.bags.clouds import UNITS, with_seconds
from pointloom.io.bags.message_chunks import RecordingWarning

PATH, COUNT = Path("run.mcap"), 50
SINCE_1970, SINCE_START = 1.7e9, 512.25  # [s]
SWEEPS = np.linspace(0, 0.1, COUNT)


def read(name, times, stamp=SINCE_1970, seen=None):
    seen = np.ones(len(times), bool) if seen is None else seen
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        found = with_seconds(PATH, {name: times, "ring": np.arange(len(times))}, seen, stamp)
    assert {w.category for w in told} <= {RecordingWarning}
    return found, [str(w.message) for w in told]


def assert_sweep(found, tolerance=1e-6, told=()):
    assert "time" in found and not told
    np.testing.assert_allclose(found["time"], SWEEPS, atol=tolerance)


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("start", [SINCE_1970, SINCE_START], ids=["1970", "boot"])
def test_a_clock_of_the_header_tells_the_unit(unit, start):
    found, told = read("timestamp", (start + SWEEPS) / UNITS[unit], stamp=start + 0.1)
    assert_sweep(found, 1e-6, told)


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("start", [SINCE_1970, SINCE_START, 86_000.0], ids=["1970", "boot", "a day"])
@pytest.mark.parametrize("stamp", [0.0, 1.6e9])
def test_a_clock_of_its_own_is_read_by_the_length_of_a_sweep(unit, start, stamp):
    """Nanoseconds since the sensor was switched on are small numbers: by their size they would be 10^8 s."""
    found, told = read("timestamp", (start + SWEEPS) / UNITS[unit], stamp=stamp)
    assert_sweep(found, 1e-6, told)


@pytest.mark.parametrize(
    ("name", "times"),
    [
        ("time", np.float32(SWEEPS)),
        ("time", np.float32(SWEEPS - 0.1)),
        ("t", np.uint32(SWEEPS * 1e9)),
        ("offset_time", np.uint32(SWEEPS * 1e9)),
    ],
)
def test_what_one_driver_writes_is_read_by_its_name(name, times):
    found, told = read(name, times)
    assert_sweep(found, 1e-6, told)


@pytest.mark.parametrize(
    ("name", "times", "unit"),
    [
        ("time", np.float32(SWEEPS * 1e6), "us"),
        ("t", np.uint32(SWEEPS * 1e6), "us"),
        ("time", np.float64(1e3 * SWEEPS), "ms"),
    ],
)
def test_another_unit_than_the_drivers_is_said(name, times, unit):
    found, told = read(name, times)
    assert_sweep(found, 1e-6)
    assert len(told) == 1 and f"read as {unit}" in told[0] and repr(name) in told[0]


@pytest.mark.parametrize(
    ("name", "times", "kept"),
    [
        ("timestamp", np.float64(SWEEPS * 1e-3), "timestamp"),  # 0.1 ms, or 100 s of thousandths
        ("time", np.float32([0.0, 1900.0]), "timestamps"),
        ("time_stamp", np.uint32([0, 10]), "time_stamp"),
        ("timestamp", np.float32(1.7e9 + SWEEPS), "timestamp"),  # steps of 128 s
        ("timestamp", np.float32(1.7e9 + 1000 * SWEEPS), "timestamp"),
    ],
)
def test_numbers_in_no_unit_stay_as_they_are_and_are_told(name, times, kept):
    found, told = read(name, times, stamp=5.0)
    assert "time" not in found and len(told) == 1 and "in any unit" in told[0]
    np.testing.assert_array_equal(found[kept], times)


@pytest.mark.parametrize("name", ["time", "t", "timestamp"])
def test_a_flash_takes_no_time(name):
    found, told = read(name, np.full(COUNT, 7, "u4" if name == "t" else "f8"))
    assert not told and found["time"].tolist() == [0] * COUNT


def test_points_that_were_not_measured_have_no_say():
    times, seen = SINCE_1970 + SWEEPS, np.ones(COUNT, bool)
    times[[3, 9]], seen[3] = 0, False  # one that is not finite, and one whose time was never set
    found, told = read("timestamp", times, stamp=0.0, seen=seen)
    others = np.delete(np.arange(COUNT), [3, 9])
    assert not told
    np.testing.assert_allclose(found["time"][others], SWEEPS[others], atol=1e-6)


def test_a_cloud_without_points_or_times_is_read():
    assert read("time", np.zeros(0, np.float32))[0]["time"].size == 0
    assert set(read("gps", SWEEPS)[0]) == {"gps", "ring"}
    assert set(read("time", np.full(4, np.nan))[0]) == {"time", "ring"}
