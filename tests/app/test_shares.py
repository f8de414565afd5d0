"""Shares as people read them: nothing is 0.0% but nothing."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointloom.app.cluster import cluster_fields
from pointloom.app.console import format_share


@pytest.mark.parametrize(
    ("share", "text"),
    [
        (0, "0.0%"), (1, "100.0%"), (0.5, "50.0%"), (51 / 113662, "0.04%"), (0.0004, "0.04%"), (0.001, "0.1%"),
        (0.9996, "99.96%"), (1 - 1e-6, "99.9999%"), (0.905, "90.5%"), (math.nan, "nan%"), (1e-7, "0.00001%"),
    ],
)  # fmt: skip
def test_a_share_has_digits_enough(share, text):
    assert format_share(share) == text


def test_a_little_noise_is_not_none():
    largest = [{"label": 0, "points": 113_611}]
    report = {"points_in": 113_662, "points": 113_662, "clusters": 1, "largest": largest, "noise": 51, "eps": 0.05}
    report |= {"min_points": 10, "seconds": {}, "left_out": [], "files": []}
    assert ("noise", "51 of 113,662 points, 0.04%") in cluster_fields(report)


@given(st.integers(1, 10**9).flatmap(lambda total: st.tuples(st.integers(0, total), st.just(total))))
def test_only_none_and_all_look_like_none_and_all(counts):
    count, total = counts
    shown = float(format_share(count / total).rstrip("%"))
    assert (shown == 0) == (count == 0)
    assert (shown == 100) == (count == total)
