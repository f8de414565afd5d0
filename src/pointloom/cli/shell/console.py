"""Console output of commands: progress on stderr, a summary or one JSON object on stdout.

The options -q and -v set the level of the logger "pointloom": ERROR without progress and notices, DEBUG with stages.
rich is imported with the first progress bar only, so that `--help` is fast.
"""

from __future__ import annotations

import logging
import sys
import time
from collections.abc import Iterable
from pathlib import Path
from types import TracebackType
from typing import Any

import click

from ...core.escaped_text import escaped
from ...core.reports import rows_of
from ...core.standard_streams import is_terminal
from ...core.verbosity import LOGGER
from ...core.wording import format_duration, json_text

# [s] between lines of progress if stderr is a file: 12 lines per minute.
LINE_INTERVAL = 5.0
# [s] of a stage before its remaining time is estimated: the first steps may compile kernels or read files.
MIN_ESTIMATED_FROM = 5.0
MIN_REPORTED_LOSS = 60.0  # [s] of interrupted work whose loss is reported


class OutputLostError(OSError):
    """Raised if standard output cannot be written: disk full or closed pipe."""


class Progress:
    """Progress on stderr: a bar in a terminal, lines elsewhere. A `ReportProgress`. `rates` adds steps per second.

    `kept` is a folder of intermediate files: the first line names it, and the last one after Ctrl-C. `resume` are the
    additional options that continue from it. Without a folder, Ctrl-C after a minute reports that nothing is kept.
    """

    def __init__(self, *, rates: bool = False, kept: Path | None = None, resume: str = ""):
        self._rates, self._began = rates, time.monotonic()
        self._kept, self._resume = kept, resume and f" with {resume}"
        self._bar: Any = None
        self._tasks: dict[str, Any] = {}
        self._last_line = time.monotonic()
        self._last_reported: dict[str, int] = {}  # finished steps by stage
        self._started: dict[str, tuple[float, int]] = {}  # time and finished steps when a stage was first reported

    def __enter__(self) -> Progress:
        if is_terminal(sys.stderr) and not is_quiet():
            from rich.console import Console
            from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn, TimeRemainingColumn
            from rich.progress import Progress as Bar

            columns = (TextColumn("{task.description:<10}", markup=False), BarColumn(), MofNCompleteColumn())
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
        if isinstance(error, KeyboardInterrupt) and self._started:
            if self._kept is not None:
                message = f"finished work is kept in {self._kept}; the same command{self._resume} continues from it"
                click.echo(escaped(message), err=True)
            elif time.monotonic() - self._began > MIN_REPORTED_LOSS:
                click.echo("nothing is kept; the same command starts again", err=True)

    def __call__(self, stage: str, done: int, total: int) -> None:
        """Show that `done` of `total` steps of a stage are done; `total` 0 if unknown."""
        if self._kept is not None and not self._started:
            again = f"the same command{self._resume} continues from it after an interruption"
            self._print(f"intermediate files: {self._kept}; {again}")
        if _is_verbose() and stage not in self._started:
            self._print(f"{stage}, after {time.monotonic() - self._began:.1f} s")
        self._started.setdefault(stage, (time.monotonic(), done))
        if self._bar is None:
            self._print_line(stage, done, total)
            return
        if stage not in self._tasks:
            self._tasks[stage] = self._bar.add_task(escaped(stage), total=total or None, rate="")
        self._bar.update(self._tasks[stage], completed=done, rate=self._rate(stage, done))

    def _print(self, line: str) -> None:
        if is_quiet():
            return
        if self._bar is None:
            click.echo(escaped(line), err=True)
        else:
            self._bar.console.print(escaped(line), markup=False, highlight=False)

    def _print_line(self, stage: str, done: int, total: int) -> None:
        now = time.monotonic()
        if now - self._last_line >= LINE_INTERVAL and self._last_reported.get(stage) != done:
            self._last_line, self._last_reported[stage] = now, done
            text = f"{stage}: {done} of {total}" if total else stage
            line = f"{text} {self._rate(stage, done)}".rstrip() + self._remaining(stage, done, total)
            self._print(line)

    def _remaining(self, stage: str, done: int, total: int) -> str:
        """Estimated remaining time of a stage at its mean rate in this run. Steps of an earlier run do not count."""
        start, first = self._started[stage]
        elapsed = time.monotonic() - start
        if elapsed < MIN_ESTIMATED_FROM or not first < done < total:
            return ""
        return f", about {format_duration(elapsed / (done - first) * (total - done))} left in this stage"

    def _rate(self, stage: str, done: int) -> str:
        return f"{done / max(time.monotonic() - self._began, 1e-3):.1f} {stage}/s" if self._rates and done else ""


def is_quiet() -> bool:
    """True after -q."""
    return LOGGER.level >= logging.ERROR


class Notices(logging.Handler):
    """Log handler that reports once on stderr that kernels are being compiled. After -v all records and the time."""

    def __init__(self):
        super().__init__(logging.DEBUG)
        self._began = time.monotonic()
        self._was_printed = False

    def __enter__(self) -> None:
        self._level = LOGGER.level
        LOGGER.setLevel(logging.INFO)
        LOGGER.addHandler(self)

    def __exit__(self, *_: object) -> None:
        if _is_verbose():
            click.echo(f"finished after {time.monotonic() - self._began:.1f} s", err=True)
        LOGGER.removeHandler(self)
        LOGGER.setLevel(self._level)

    def emit(self, record: logging.LogRecord) -> None:
        """Print the notice, without the progress of the library's record."""
        if _is_verbose() and record.name == LOGGER.name:
            elapsed = f", after {time.monotonic() - self._began:.1f} s" if record.levelno == logging.DEBUG else ""
            click.echo(escaped(record.getMessage(), lines=True) + elapsed, err=True)
        elif getattr(record, "compiles", False) and not self._was_printed:
            self._was_printed = True
            click.echo("compiling kernels for their first use on this machine; later runs start at once", err=True)


def _is_verbose() -> bool:
    return LOGGER.level == logging.DEBUG


def print_json(report: dict[str, Any]) -> None:
    """Print one JSON object. Non-finite numbers become null."""
    _echo(json_text(report))


def print_fields(fields: Iterable[tuple[str, str]], *, title: str = "", err: bool = False) -> None:
    """Print labels and values in two columns below a title. Multi-line values stay in their column."""
    if title:
        _echo(escaped(title), err)
    for row in rows_of(fields):
        _echo(row, err)


def _echo(line: str, err: bool = False) -> None:
    try:
        click.echo(line, err=err)
    except OSError as error:
        raise OutputLostError(error.errno, error.strerror, "standard error" if err else "standard output") from error
