"""What the commands say: progress on stderr; a summary or one JSON object on stdout.

Nothing heavy is imported here, so that `--help` stays quick; rich comes in with the first progress bar.
"""

from __future__ import annotations

import json
import logging
import math
import sys
import time
from collections.abc import Callable, Iterable
from types import TracebackType
from typing import Any

import click

# A stage, how many steps of it are done, and how many there are (0 where nobody knows).
ReportProgress = Callable[[str, int, int], None]

# Seconds between lines of progress where stderr is a file: a log of a long run grows by 12 lines a minute.
LINE_INTERVAL = 5.0


def say_nothing(stage: str, done: int, total: int) -> None:
    """A `ReportProgress` for where nobody wants to know."""


class OutputLostError(OSError):
    """Standard output cannot be written any more: its disk is full, or nobody reads it."""


class Progress:
    """Progress on stderr: a bar in a terminal, a line now and then elsewhere. Call it as `ReportProgress`.

    Args:
        rates: Tell how many steps are done in a second too.
    """

    def __init__(self, *, rates: bool = False):
        self._rates, self._began = rates, time.monotonic()
        self._bar: Any = None
        self._tasks: dict[str, Any] = {}
        self._last_line = time.monotonic()

    def __enter__(self) -> Progress:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn, TimeRemainingColumn
            from rich.progress import Progress as Bar

            columns = (TextColumn("{task.description:<10}"), BarColumn(), MofNCompleteColumn())
            times = (TimeElapsedColumn(), TextColumn("left"), TimeRemainingColumn())
            rates = (TextColumn("{task.fields[rate]}"),) if self._rates else ()
            self._bar = Bar(*columns, *times, *rates, console=Console(stderr=True), transient=True)
            self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()

    def __call__(self, stage: str, done: int, total: int) -> None:
        """Show that `done` of `total` steps of a stage are done; total 0 where nobody knows."""
        if self._bar is None:
            self._tell(stage, done, total)
            return
        if stage not in self._tasks:
            self._tasks[stage] = self._bar.add_task(stage, total=total or None, rate="")
        self._bar.update(self._tasks[stage], completed=done, rate=self._rate(stage, done))

    def _tell(self, stage: str, done: int, total: int) -> None:
        now = time.monotonic()
        if now - self._last_line >= LINE_INTERVAL:
            self._last_line = now
            text = f"{stage}: {done} of {total}" if total else stage
            click.echo(f"{text} {self._rate(stage, done)}".rstrip(), err=True)

    def _rate(self, stage: str, done: int) -> str:
        """The mean rate so far, where it is told."""
        return f"{done / max(time.monotonic() - self._began, 1e-3):.1f} {stage}/s" if self._rates and done else ""


class CompileNotice(logging.Handler):
    """Says on stderr, once, that kernels are compiled: a record of the library's logger."""

    def __init__(self):
        super().__init__(logging.INFO)
        self._logger = logging.getLogger("pointloom")
        self._said = False

    def __enter__(self) -> None:
        self._level = self._logger.level
        self._logger.setLevel(logging.INFO)
        self._logger.addHandler(self)

    def __exit__(self, *_: object) -> None:
        self._logger.removeHandler(self)
        self._logger.setLevel(self._level)

    def emit(self, record: logging.LogRecord) -> None:
        """Say it."""
        if not self._said:
            self._said = True
            click.echo("compiling kernels for their first use on this machine; later runs start at once", err=True)


class Clock:
    """Seconds by stage, in the order in which the stages came."""

    def __init__(self):
        self.seconds: dict[str, float] = {}
        self.restart()

    def restart(self) -> None:
        """Count from now on."""
        self._since = time.perf_counter()

    def stop(self, stage: str) -> None:
        """Count the time since the last call, or since the beginning, to a stage."""
        now = time.perf_counter()
        self.seconds[stage] = self.seconds.get(stage, 0.0) + now - self._since
        self._since = now


def print_json(report: dict[str, Any]) -> None:
    """Print one JSON object; what is not a finite number becomes null."""
    _say(to_json(report))


def to_json(report: dict[str, Any]) -> str:
    """A report as JSON text, indented; what is not a finite number becomes null."""
    return json.dumps(_plain(report), indent=2, allow_nan=False, ensure_ascii=False)


def print_fields(fields: Iterable[tuple[str, str]], *, title: str = "", err: bool = False) -> None:
    """Print labels and values in two columns, below a title; a value of several lines keeps its column."""
    rows = list(fields)
    width = max((len(label) for label, _ in rows), default=0)
    if title:
        _say(title, err)
    for label, value in rows:
        first, *others = value.split("\n")
        _say(f"  {label:<{width}}  {first}".rstrip(), err)
        for line in others:
            _say(f"  {'':<{width}}  {line}", err)


def _say(line: str, err: bool = False) -> None:
    try:
        click.echo(line, err=err)
    except OSError as error:
        raise OutputLostError(error.errno, error.strerror, "standard error" if err else "standard output") from error


def format_share(share: float) -> str:
    """A share as a percentage, with digits enough that only nothing is 0.0% and only all is 100.0%."""
    rest = min(share, 1 - share)
    digits = max(1, math.ceil(-math.log10(100 * rest))) if rest > 0 else 1
    return f"{share:.{digits}%}"


def format_bytes(count: float) -> str:
    """A number of bytes as people read it: "1.5 MiB"."""
    for unit in ("B", "KiB", "MiB"):
        if count < 1024:
            return f"{count:.0f} B" if unit == "B" else f"{count:.1f} {unit}"
        count /= 1024
    return f"{count:.1f} GiB"


def format_seconds(seconds: dict[str, float]) -> str:
    """Seconds of each stage and of all: "open 0.02, integrate 1.21, all 1.23"."""
    parts = [f"{stage} {value:.2f}" for stage, value in seconds.items()]
    return ", ".join([*parts, f"all {sum(seconds.values()):.2f}"])


def format_triple(values: Iterable[float]) -> str:
    """Three coordinates, to a tenth of a millimetre."""
    return "[" + ", ".join(f"{value:.4f}" for value in values) + "]"


def format_bounds(bounds: dict[str, Any] | None) -> str:
    """The lowest and highest corner of a box, or that there is none."""
    if bounds is None:
        return "none: no finite point"
    return f"{format_triple(bounds['min'])} to {format_triple(bounds['max'])}"


def peak_bytes() -> int:
    """The most memory [B] that this process has held so far."""
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit


def _plain(value: Any) -> Any:
    """A value in JSON's own types."""
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if hasattr(value, "tolist"):  # NumPy's arrays and numbers
        return _plain(value.tolist())
    if isinstance(value, float):
        return value if value - value == 0 else None
    if value is None or isinstance(value, bool | int | str):
        return value
    return str(value)
