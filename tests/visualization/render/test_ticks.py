"""Ticks are round numbers inside the axis, within the maximum count, with distinct texts."""

import math

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pointloom.visualization.render.ticks import choose_ticks, widen

ENDS = st.floats(-1e12, 1e12)


@pytest.mark.parametrize(
    ("ends", "texts", "title"),
    [
        ((0, 1), ("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"), "d [m]"),
        ((-0.5, 0.5), ("−0.4", "−0.2", "0.0", "0.2", "0.4"), "d [m]"),
        ((99, 101), ("99.0", "99.5", "100.0", "100.5", "101.0"), "d [m]"),
        ((0, 3e-9), ("0", "1", "2", "3"), "d [1e-9 m]"),
        ((-1e9, 2e9), ("−1", "0", "1", "2"), "d [1e9 m]"),
        ((400_000, 400_100), ("400000", "400020", "400040", "400060", "400080", "400100"), "d [m]"),
        ((400_000.01, 400_000.05), ("0.01", "0.02", "0.03", "0.04", "0.05"), "d [m] − 400000"),
        ((-400_000.05, -400_000.01), ("0.05", "0.06", "0.07", "0.08", "0.09"), "d [m] + 400000.1"),
        ((5, 5), ("4.8", "4.9", "5.0", "5.1", "5.2"), "d [m]"),
        ((math.nan, 1), ("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"), "d [m]"),
    ],
)
def test_ticks_are_round_numbers(ends, texts, title):
    ticks = choose_ticks(*ends, 6)
    assert (ticks.texts, ticks.title("d [m]")) == (texts, title)


def test_a_title_without_a_unit_gets_the_power_of_ten():
    assert choose_ticks(0, 3e-9, 4).title("rmse") == "rmse [1e-9]"


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(ENDS, ENDS, st.integers(2, 20))
def test_ticks_are_inside_the_range_and_distinct(a, b, max_ticks):
    ticks = choose_ticks(min(a, b), max(a, b), max_ticks)
    slack = 1e-6 * (ticks.high - ticks.low)
    assert ticks.low < ticks.high and len(ticks.values) <= max_ticks
    assert all(ticks.low - slack <= value <= ticks.high + slack for value in ticks.values)
    assert len(set(ticks.texts)) == len(ticks.texts)
    assert all(len(text) <= 10 for text in ticks.texts)


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(ENDS, ENDS, st.integers(4, 20))
def test_texts_give_the_tick_positions(a, b, max_ticks):
    ticks = choose_ticks(min(a, b), max(a, b), max_ticks)
    assert len(ticks.values) >= 1
    step = ticks.high - ticks.low
    for value, text in zip(ticks.values, ticks.texts, strict=True):
        number = float(text.replace("−", "-")) * 10.0**ticks.exponent + ticks.offset
        assert number == pytest.approx(value, abs=step / 50)


@pytest.mark.parametrize(
    "ends", [(0, 0), (7, 7), (-1e-300, 1e-300), (1e15, 1e15 + 0.125), (-math.inf, 3), (3, math.nan)]
)
def test_an_axis_without_extent_is_widened(ends):
    low, high = widen(*ends)
    assert low < high and math.isfinite(high - low)
