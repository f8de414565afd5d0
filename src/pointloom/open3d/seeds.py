"""Open3D's global seed: each operation takes the next number of its sequence."""

from __future__ import annotations

import random

from ..core.checks import check_count

_numbers = random.Random(0)


def set_seed(seed: int) -> None:
    """Restart the sequence: the same calls in the same order are bitwise reproducible."""
    _numbers.seed(check_count("seed", seed, minimum=0))


def next_seed() -> int:
    """Seed of the next operation."""
    return _numbers.getrandbits(31)
