"""The number of false alarms of a fit to points: how often unrelated points would fit as well by chance.

Moisan and Stival, "A probabilistic criterion to detect rigid point matches between two images and estimate the
fundamental matrix", IJCV 2004. For a model that s of n points determine, of which k are within a distance that an
unrelated point has with probability p, at most (n - s) C(n, k) C(k, s) p^(k - s) such models are expected.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# Expected number of unrelated point sets that fit as well, below which a fit is accepted: chosen, not fitted.
MAX_FALSE_ALARMS = 0.01


def is_chance(chances: NDArray[np.float64], sample: int, models: float = 1.0, *, least: int = 0) -> bool:
    """True if unrelated points fit as well by chance, by the most significant number k of points, at least `least`.

    `chances`: of each point, the probability that an unrelated point is as close. `sample`: number of points that
    determine a model. `models`: number of models of one sample, such as assignments of partners.
    """
    n = len(chances)
    if n <= sample:
        return True
    k = np.arange(max(sample + 1, least), n + 1)
    factorials = np.concatenate([[0.0], np.cumsum(np.log(np.arange(1, n + 1)))])  # logarithms
    choices = factorials[n] - factorials[n - k] - factorials[k - sample] - factorials[sample]  # C(n, k) C(k, s)
    powers = (k - sample) * np.log(np.maximum(np.sort(chances)[k - 1], np.finfo(np.float64).tiny))
    alarms = np.log(n - sample) + choices + np.log(models) + powers
    return bool(alarms.min() > np.log(MAX_FALSE_ALARMS))
