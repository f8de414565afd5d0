"""Times of points are converted to seconds if the message determines their unit."""

import warnings
from pathlib import Path

import numpy as np
import pytest

from pointloom.io.bags.clouds import UNITS, with_seconds
from pointloom.io.bags.message_chunks import RecordingWarning

PATH, COUNT = Path("run.mcap"), 50
SINCE_1970, SINCE_START = 1.7e9, 512.25  # [s]
SWEEPS = np.linspace(0, 0.1, COUNT)


def read(name, times, stamp=SINCE_1970, valid=None):
    valid = np.ones(len(times), bool) if valid is None else valid
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        attributes = with_seconds(PATH, {name: times, "ring": np.arange(len(times))}, valid, stamp)
    assert {w.category for w in caught} <= {RecordingWarning}
    return attributes, [str(w.message) for w in caught]


def assert_sweep(attributes, tolerance=1e-6, messages=()):
    assert "time" in attributes and not messages
    np.testing.assert_allclose(attributes["time"], SWEEPS, atol=tolerance)


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("start", [SINCE_1970, SINCE_START], ids=["1970", "boot"])
def test_header_clock_determines_the_unit(unit, start):
    attributes, messages = read("timestamp", (start + SWEEPS) / UNITS[unit], stamp=start + 0.1)
    assert_sweep(attributes, 1e-6, messages)


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("start", [SINCE_1970, SINCE_START, 86_000.0], ids=["1970", "boot", "a day"])
@pytest.mark.parametrize("stamp", [0.0, 1.6e9])
def test_unit_of_a_separate_clock_follows_from_the_sweep_duration(unit, start, stamp):
    """Nanoseconds since power-on are small numbers: by their size they would be 10^8 s."""
    attributes, messages = read("timestamp", (start + SWEEPS) / UNITS[unit], stamp=stamp)
    assert_sweep(attributes, 1e-6, messages)


def test_times_of_known_drivers_are_read_by_name():
    nanoseconds = np.uint32(SWEEPS * 1e9)
    known = [("time", np.float32(SWEEPS)), ("time", np.float32(SWEEPS - 0.1)), ("t", nanoseconds)]
    for name, times in (*known, ("offset_time", nanoseconds)):
        attributes, messages = read(name, times)
        assert_sweep(attributes, 1e-6, messages)


@pytest.mark.parametrize(("name", "kind", "unit"), [("time", "f4", "us"), ("t", "u4", "us"), ("time", "f8", "ms")])
def test_unit_other_than_the_drivers_is_reported(name, kind, unit):
    attributes, messages = read(name, (SWEEPS / UNITS[unit]).astype(kind))
    assert_sweep(attributes, 1e-6)
    assert len(messages) == 1 and f"read as {unit}" in messages[0] and repr(name) in messages[0]


def test_numbers_without_a_unit_are_preserved_and_reported():
    for name, times, expected_name in (
        ("timestamp", np.float64(SWEEPS * 1e-3), "timestamp"),  # 0.1 ms, or 100 s of thousandths
        ("time", np.float32([0.0, 1900.0]), "timestamps"),
        ("time_stamp", np.uint32([0, 10]), "time_stamp"),
        ("timestamp", np.float32(1.7e9 + SWEEPS), "timestamp"),  # steps of 128 s
        ("timestamp", np.float32(1.7e9 + 1000 * SWEEPS), "timestamp"),
    ):
        attributes, messages = read(name, times, stamp=5.0)
        assert "time" not in attributes and len(messages) == 1 and "in any unit" in messages[0]
        np.testing.assert_array_equal(attributes[expected_name], times)


@pytest.mark.parametrize("name", ["time", "t", "timestamp"])
def test_flash_has_zero_duration(name):
    attributes, messages = read(name, np.full(COUNT, 7, "u4" if name == "t" else "f8"))
    assert not messages and attributes["time"].tolist() == [0] * COUNT


def test_unmeasured_points_are_ignored():
    times, seen = SINCE_1970 + SWEEPS, np.ones(COUNT, bool)
    times[[3, 9]], seen[3] = 0, False  # one not finite, and one with an unset time
    attributes, messages = read("timestamp", times, stamp=0.0, valid=seen)
    others = np.delete(np.arange(COUNT), [3, 9])
    assert not messages
    np.testing.assert_allclose(attributes["time"][others], SWEEPS[others], atol=1e-6)


def test_a_cloud_without_points_or_times_is_read():
    assert read("time", np.zeros(0, np.float32))[0]["time"].size == 0 and set(read("gps", SWEEPS)[0]) == {"gps", "ring"}
    assert set(read("time", np.full(4, np.nan))[0]) == {"time", "ring"}
