"""What work costs: seconds by stage, and the most memory that was held."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from .progress import ReportProgress, say_nothing


class Clock:
    """Seconds by stage, in the order in which the stages came; a stage that comes again adds to its own.

    Args:
        progress: Told of each `stage` when it begins; None tells nobody.

    Attributes:
        seconds: Of each stage [s].
        cpu_seconds: The same of all cores together, and of the processes that were waited for [s].

    Example:
        >>> from pointloom.core.timing import Clock
        >>> clock = Clock(print)
        >>> with clock.stage("read"):
        ...     pass
        read 0 0
        >>> list(clock.seconds)
        ['read']
    """

    def __init__(self, progress: ReportProgress | None = None):
        self.seconds: dict[str, float] = {}
        self.cpu_seconds: dict[str, float] = {}
        self._tell = progress or say_nothing
        self.restart()

    def restart(self) -> None:
        """Count from now on."""
        self._since, self._cpu_since = time.perf_counter(), _cpu_now()

    def stop(self, stage: str) -> None:
        """Count the time since the last call, or since the beginning, to a stage."""
        wall, cpu = self._since, self._cpu_since
        self.restart()
        self.seconds[stage] = self.seconds.get(stage, 0.0) + self._since - wall
        self.cpu_seconds[stage] = self.cpu_seconds.get(stage, 0.0) + self._cpu_since - cpu

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Tell of a stage, and count the time of the block below to it; what is raised there ends it uncounted."""
        self._tell(name, 0, 0)
        self.restart()
        yield
        self.stop(name)


def peak_bytes() -> int:
    """The most memory [B] that this process has held so far."""
    import resource

    return _most_held(resource.RUSAGE_SELF)


def peak_bytes_of_all() -> int:
    """The most memory [B] that this process, or one that it started and waited for, has held so far."""
    import resource

    return max(peak_bytes(), _most_held(resource.RUSAGE_CHILDREN))


def _most_held(who: int) -> int:
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(who).ru_maxrss * unit


def _cpu_now() -> float:
    """Of this process and of the children that it waited for."""
    return sum(os.times()[:4])


def check_clock(clock: Any) -> Clock:
    """The clock that counts an algorithm's stages; one that nobody reads where none is given.

    Raises:
        TypeError: No clock.
    """
    if clock is not None and not isinstance(clock, Clock):
        raise TypeError(f"clock: expected a Clock or None, got {type(clock).__name__}")
    return clock or Clock()
