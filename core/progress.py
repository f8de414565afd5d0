"""How far a job is: the one shape of what is called to tell it, and the silence where nobody wants to know."""

from __future__ import annotations

from collections.abc import Callable

# A stage, how many steps of it are done, and how many there are (0 where nobody knows).
ReportProgress = Callable[[str, int, int], None]


def say_nothing(stage: str, done: int, total: int) -> None:
    """A `ReportProgress` for where nobody wants to know."""
