"""Format integers as runs."""

from __future__ import annotations

from collections.abc import Sequence

_MAX_SHOWN_RUNS = 5  # runs, by number


def some_frames(numbers: Sequence[int]) -> str:
    """Frame numbers from 0 as runs, truncated if many: "frame 3, 7-9"."""
    return "frame " + some_runs(numbers)


def some_runs(numbers: Sequence[int]) -> str:
    """Ascending integers as runs, truncated if many.

    Example:
        >>> some_runs([3, 7, 8, 9])
        '3, 7-9'
    """
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    listed = ", ".join(f"{first}" if first == last else f"{first}-{last}" for first, last in runs[:_MAX_SHOWN_RUNS])
    return listed + (" and more" if len(runs) > _MAX_SHOWN_RUNS else "")
