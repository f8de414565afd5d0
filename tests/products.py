"""Parameters of slow tests: all combinations in `make test-all`, pairwise combinations in `make test`."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from typing import Any

import pytest


def each_pair(**values: list[Any]) -> dict[str, Any]:
    """Arguments of `pytest.mark.parametrize`: all combinations, `slow` but for few in which every two values meet.

    A fault that one value shows, or two together, so shows in the few; what takes three waits for the rest.

    Args:
        values: By the name of each parameter, what it may be.
    """
    combinations = list(itertools.product(*(range(len(those)) for those in values.values())))
    few = set(_few(combinations))
    return {
        "argnames": tuple(values),
        "argvalues": [
            pytest.param(
                *(those[k] for those, k in zip(values.values(), indices, strict=True)),
                marks=() if indices in few else pytest.mark.slow,
            )
            for indices in combinations
        ],
    }


def _few(combinations: list[tuple[int, ...]]) -> list[tuple[int, ...]]:
    """Combinations one by one, each the first that has most pairs which those before it have not."""
    left = set().union(*map(_pairs, combinations))
    few = []
    while left:
        few.append(max(combinations, key=lambda indices: len(_pairs(indices) & left)))
        left -= _pairs(few[-1])
    return few


def _pairs(indices: tuple[int, ...]) -> set[tuple[tuple[int, int], ...]]:
    return set(itertools.combinations(enumerate(indices), min(2, len(indices))))


def few_quick(count: int, names: str | tuple[str, ...], values: Iterable[Any], **more: Any) -> pytest.MarkDecorator:
    """`pytest.mark.parametrize` with all values but the first `count` marked `slow`: any of them shows the claim."""
    cases = [(value,) if isinstance(names, str) else value for value in values]
    marks = [() if k < count else pytest.mark.slow for k in range(len(cases))]
    return pytest.mark.parametrize(
        names, [pytest.param(*case, marks=mark) for case, mark in zip(cases, marks, strict=True)], **more
    )
