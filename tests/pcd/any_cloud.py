"""Hypothesis strategies for tests of clouds: coordinates, small clouds, shared settings."""

import numpy as np
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st

INTEGERS = st.integers(-3, 3).map(float)
NOT_FINITE = st.sampled_from([np.nan, np.inf, -np.inf])


def real(limit):
    return st.floats(-limit, limit, width=32, allow_subnormal=False)


def parts(denominator, limit):
    """Integer multiples of a unit fraction."""
    return st.integers(-limit, limit).map(lambda n: n / denominator)


def clouds(*coordinates, min_size=0, max_size=40):
    triples = st.tuples(*[st.one_of(*coordinates)] * 3)
    rows = st.lists(triples, min_size=min_size, max_size=max_size)
    return rows.map(lambda rows: np.array(rows, float).reshape(-1, 3))


def examples(count):
    """Settings with the same examples in every run and on every device."""
    checks = [HealthCheck.function_scoped_fixture]
    return settings(max_examples=count, derandomize=True, deadline=None, suppress_health_check=checks)
