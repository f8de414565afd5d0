"""What hypothesis draws for tests of clouds: coordinates, small clouds, and the settings that such tests share."""

import numpy as np
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st

WHOLE = st.integers(-3, 3).map(float)
NOT_FINITE = st.sampled_from([np.nan, np.inf, -np.inf])


def real(reach):
    """Any float32 up to a reach."""
    return st.floats(-reach, reach, width=32, allow_subnormal=False)


def parts(denominator, reach):
    """Whole multiples of a part of one."""
    return st.integers(-reach, reach).map(lambda n: n / denominator)


def clouds(*coordinates, least=0, most=40):
    """Points [n, 3] whose coordinates are drawn from any of the strategies."""
    triples = st.tuples(*[st.one_of(*coordinates)] * 3)
    return st.lists(triples, min_size=least, max_size=most).map(lambda rows: np.array(rows, float).reshape(-1, 3))


def examples(count):
    """The same examples in every run; a device is the same for all of them."""
    checks = [HealthCheck.function_scoped_fixture]
    return settings(max_examples=count, derandomize=True, deadline=None, suppress_health_check=checks)
