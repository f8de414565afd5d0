"""Open3D's one seed of all that is random: each operation takes the next number that follows from it."""

from __future__ import annotations

import random

from ..core.checks import check_count

_numbers = random.Random(0)


def set_seed(seed: int) -> None:
    """Begin again: the same calls in the same order give the same bits from here on."""
    _numbers.seed(check_count("seed", seed, minimum=0))


def next_seed() -> int:
    """The `seed=` of the next operation."""
    return _numbers.getrandbits(31)
