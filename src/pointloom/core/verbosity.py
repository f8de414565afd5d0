"""Logging: the logger "pointloom" and its verbosity level.

First compilations and the progress of long calls are logged at INFO: on stderr, unless the program has configured
logging. POINTLOOM_VERBOSITY=warning silences a process.
"""

from __future__ import annotations

import contextlib
import enum
import logging
import time
from collections.abc import Iterator
from types import TracebackType
from typing import Self

from ..kernels.language.environment import setting
from .escaped_text import escaped
from .standard_streams import write_to_stderr

LOGGER = logging.getLogger("pointloom")
LOG_INTERVAL = 3.0  # [s] before a call reports progress, and between reports


def _escape_record(record: logging.LogRecord) -> bool:
    """Escape control characters in a record, for handlers of the program."""
    try:
        text = record.getMessage()
    except (TypeError, ValueError):  # reported by the handler
        return True
    if (safe := escaped(text, lines=True)) != text:
        record.msg, record.args = safe, ()
    return True


for _name in ("pointloom", "pointloom.viewer"):  # filters do not apply to the loggers below
    logging.getLogger(_name).addFilter(_escape_record)


class VerbosityLevel(enum.Enum):
    """Verbosity levels, as in Open3D. Each includes the previous ones."""

    Error = 0
    Warning = 1
    Info = 2
    Debug = 3


LEVELS = {
    VerbosityLevel.Error: logging.ERROR,
    VerbosityLevel.Warning: logging.WARNING,
    VerbosityLevel.Info: logging.INFO,
    VerbosityLevel.Debug: logging.DEBUG,
}


VARIABLE = "POINTLOOM_VERBOSITY"  # error, warning, info or debug: the default level of a process
_BY_NAME = {level.name.lower(): number for level, number in LEVELS.items()}


class Lines(logging.Handler):
    """Handler for stderr, used if there is no other handler."""

    def emit(self, record: logging.LogRecord) -> None:
        """Write to the current stderr, which notebooks and tests replace."""
        if record.name != LOGGER.name:  # the viewer's log of visitor actions: only on request
            return
        if logging.root.handlers or any(handler is not self for handler in LOGGER.handlers):
            return
        _print(self.format(record))


def _print(text: str) -> None:
    write_to_stderr(f"pointloom: {escaped(text, lines=True)}")


_lines = Lines()


def start() -> None:
    """Log to stderr, unless the program has configured logging. ValueError for a wrong value of the variable."""
    level = _BY_NAME[setting(VARIABLE) or "info"]
    if _lines not in LOGGER.handlers:
        LOGGER.addHandler(_lines)
        if LOGGER.level == logging.NOTSET and not logging.root.handlers:
            LOGGER.setLevel(level)


def set_verbosity_level(verbosity_level: VerbosityLevel) -> None:
    """Set the level of the logger "pointloom" for the process.

    Args:
        verbosity_level: Error, Warning, Info (default) or Debug, which also logs the start of each stage.

    Raises:
        TypeError: Not a VerbosityLevel.
    """
    if not isinstance(verbosity_level, VerbosityLevel):
        names = ", ".join(f"VerbosityLevel.{level.name}" for level in VerbosityLevel)
        raise TypeError(f"verbosity_level: expected one of {names}, got {type(verbosity_level).__name__}")
    start()
    LOGGER.setLevel(LEVELS[verbosity_level])


def get_verbosity_level() -> VerbosityLevel:
    """The current verbosity level."""
    level = LOGGER.getEffectiveLevel()
    names = [name for name, value in LEVELS.items() if value >= level]
    return names[-1] if names else VerbosityLevel.Error


class VerbosityContextManager:
    """Set the verbosity level inside a `with` block and restore it afterward.

    Args:
        level: A VerbosityLevel.

    Raises:
        TypeError: Not a VerbosityLevel.
    """

    def __init__(self, level: VerbosityLevel):
        if not isinstance(level, VerbosityLevel):
            raise TypeError(f"level: expected a VerbosityLevel, got {type(level).__name__}")
        self._level, self._before = level, logging.NOTSET

    def __enter__(self) -> Self:
        self._before = LOGGER.level
        set_verbosity_level(self._level)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        LOGGER.setLevel(self._before)


@contextlib.contextmanager
def printed_duration(what: str, wanted: bool) -> Iterator[None]:
    """Print a step and its duration if requested, for steps without a count."""
    if not wanted:
        yield
        return
    began = time.monotonic()
    _print(f"{what} ...")
    yield
    _print(f"{what}: {time.monotonic() - began:.1f} s")


class LoggedProgress:
    """The default `ReportProgress`: logs slow calls at INFO, at most every `LOG_INTERVAL`, and each stage at DEBUG."""

    def __init__(self) -> None:
        self._began = self._last_logged = time.monotonic()
        self._stage = ""

    def __call__(self, stage: str, done: int, total: int) -> None:
        now = time.monotonic()
        text = f"{stage} {done:,} of {total:,}" if total else f"{stage} {done:,}" if done else stage
        if now - self._last_logged >= LOG_INTERVAL:
            self._last_logged = now
            LOGGER.info("%s, after %s", text, f"{now - self._began:.0f} s")
        elif stage != self._stage:
            LOGGER.debug("%s", text)
        self._stage = stage


start()
