"""Formatted fractions: only 0 is printed as 0.0%, and only 1 as 100.0%."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.core.wording import format_share


@pytest.mark.parametrize(
    ("share", "text"),
    [
        (0, "0.0%"), (1, "100.0%"), (0.5, "50.0%"), (51 / 113662, "0.04%"), (0.0004, "0.04%"), (0.001, "0.1%"),
        (0.9996, "99.96%"), (1 - 1e-6, "99.9999%"), (0.905, "90.5%"), (math.nan, "nan%"), (1e-7, "0.00001%"),
    ],
)  # fmt: skip
def test_fractions_have_enough_digits(share, text):
    assert format_share(share) == text


@settings(max_examples=25)
@given(st.integers(1, 10**9).flatmap(lambda total: st.tuples(st.integers(0, total), st.just(total))))
def test_only_0_and_1_are_printed_as_0_and_100_percent(counts):
    count, total = counts
    printed = float(format_share(count / total).rstrip("%"))
    assert (printed == 0) == (count == 0) and (printed == 100) == (count == total)
