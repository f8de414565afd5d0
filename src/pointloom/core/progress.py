"""The type of progress callbacks, and a silent one."""

from __future__ import annotations

from collections.abc import Callable

# A stage, completed steps, and total steps (0 if unknown).
ReportProgress = Callable[[str, int, int], None]


def ignore_progress(stage: str, done: int, total: int) -> None:
    """A `ReportProgress` that does nothing."""
