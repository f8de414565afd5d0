"""Formatted fractions: only 0 is printed as 0.0%, and only 1 as 100.0%."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.cli.jobs.cluster import ClusterReport, ClusterSize
from pointloom.cli.jobs.job import Done
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


def test_a_small_fraction_of_noise_is_not_printed_as_0():
    largest = (ClusterSize(0, 113_611),)
    done = Done("cluster", "a.ply", {}, (), (), None)
    report = ClusterReport(done, "cpu", 113_662, 113_662, 0.05, 10, clusters=1, largest=largest, noise=51)
    assert ("noise", "51 of 113,662 points, 0.04%") in report.fields()


@settings(max_examples=25)
@given(st.integers(1, 10**9).flatmap(lambda total: st.tuples(st.integers(0, total), st.just(total))))
def test_only_0_and_1_are_printed_as_0_and_100_percent(counts):
    count, total = counts
    printed = float(format_share(count / total).rstrip("%"))
    assert (printed == 0) == (count == 0)
    assert (printed == 100) == (count == total)
