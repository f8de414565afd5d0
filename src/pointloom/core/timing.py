"""Time per stage and peak memory."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .progress import ReportProgress, ignore_progress


class Clock:
    """Seconds per stage in order; repeated stages accumulate.

    Args:
        progress: Called when a `stage` begins, or None.

    Attributes:
        seconds: Wall time of each stage [s].
        cpu_seconds: CPU time of this process and its waited-for children [s].

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
        self._progress = progress or ignore_progress
        self.restart()

    def restart(self) -> None:
        self._since, self._cpu_since = time.perf_counter(), _cpu_now()

    def stop(self, stage: str) -> None:
        """Add the time since the last call or start to a stage."""
        wall, cpu = self._since, self._cpu_since
        self.restart()
        self.seconds[stage] = self.seconds.get(stage, 0.0) + self._since - wall
        self.cpu_seconds[stage] = self.cpu_seconds.get(stage, 0.0) + self._cpu_since - cpu

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Report a stage and measure the block. Nothing is added if it raises."""
        self._progress(name, 0, 0)
        self.restart()
        yield
        self.stop(name)


def peak_bytes() -> int:
    """Peak memory of this process [B]. On Linux its usage would count that of the program that started it, too."""
    if sys.platform == "win32":
        return _peak_on_windows()
    import resource

    return peak_of_process() or _peak_of(resource.RUSAGE_SELF)


def peak_of_process(process: int | str = "self") -> int:
    """Peak memory of a process by its number [B]. 0 if it is unknown: it has ended, or the system is not Linux."""
    with contextlib.suppress(OSError, ValueError, IndexError):
        for line in Path(f"/proc/{process}/status").read_text(encoding="utf-8").splitlines():
            if line.startswith("VmHWM:"):
                return 1024 * int(line.split()[1])
    return 0


def peak_bytes_of_all() -> int:
    """Peak memory of this process or a waited-for child [B]. On Windows: of this process."""
    if sys.platform == "win32":
        return _peak_on_windows()
    import resource

    return max(peak_bytes(), _peak_of(resource.RUSAGE_CHILDREN))


def _peak_of(who: int) -> int:
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(who).ru_maxrss * unit


def _peak_on_windows() -> int:
    import ctypes

    counters = (ctypes.c_size_t * 9)()  # PROCESS_MEMORY_COUNTERS: two 32-bit fields, the peak, seven other sizes
    process = ctypes.c_void_p(-1)  # this process
    system = ctypes.WinDLL("kernel32")  # type: ignore[attr-defined]
    system.K32GetProcessMemoryInfo(process, ctypes.byref(counters), ctypes.sizeof(counters))
    return counters[1]


def _cpu_now() -> float:
    return sum(os.times()[:4])


def check_clock(clock: object) -> Clock:
    if clock is not None and not isinstance(clock, Clock):
        raise TypeError(f"clock: expected a Clock or None, got {type(clock).__name__}")
    return clock or Clock()
