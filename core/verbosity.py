"""What the library says while it works: one logger, "pointloom", and how much of it is shown.

What is compiled for the first time on a machine, and how far a call is that takes long, are records at level INFO.
Where nobody has configured Python's logging they are shown on stderr, which a notebook shows below its cell; where
somebody has, they are his, and nothing is printed besides. POINTLOOM_VERBOSITY=warning silences a process from outside.
"""

from __future__ import annotations

import contextlib
import enum
import logging
import os
import time
from collections.abc import Iterator
from types import TracebackType
from typing import Self

from .escaped_text import escaped
from .standard_streams import write_to_stderr

LOGGER = logging.getLogger("pointloom")
PATIENCE = 3.0  # [s] before a call says how far it is, and between two times


class VerbosityLevel(enum.Enum):
    """How much is said, as in Open3D: each level what those before it say, and more.

    Example:
        >>> import pointloom as loom
        >>> loom.set_verbosity_level(loom.VerbosityLevel.Info)
    """

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


VARIABLE = "POINTLOOM_VERBOSITY"  # error, warning, info or debug: for a process whose script says nothing of it
_BY_NAME = {level.name.lower(): number for level, number in LEVELS.items()}


class Lines(logging.Handler):
    """Lines on stderr, where no other handler would show them."""

    def emit(self, record: logging.LogRecord) -> None:
        """Write one line to what stderr is now: notebooks and tests put their own in its place."""
        if record.name != LOGGER.name:  # the viewer's, of what visitors do: for who asks for them
            return
        if logging.root.handlers or any(handler is not self for handler in LOGGER.handlers):
            return
        _print(self.format(record))


def _print(text: str) -> None:
    write_to_stderr(f"pointloom: {escaped(text, lines=True)}")


_lines = Lines()


def start() -> None:
    """Show what the library says on stderr, unless the program has its own logging already."""
    if _lines not in LOGGER.handlers:
        LOGGER.addHandler(_lines)
        if LOGGER.level == logging.NOTSET and not logging.root.handlers:
            LOGGER.setLevel(_BY_NAME.get(os.environ.get(VARIABLE, "").lower(), logging.INFO))


def set_verbosity_level(verbosity_level: VerbosityLevel) -> None:
    """Say more or less, for the whole process: the level of the logger "pointloom".

    Args:
        verbosity_level: Error, Warning, Info (unless set) or Debug, which also says each stage as it begins.

    Raises:
        TypeError: Not a VerbosityLevel.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.core.verbosity import get_verbosity_level
        >>> loom.set_verbosity_level(loom.VerbosityLevel.Error)
        >>> get_verbosity_level()
        <VerbosityLevel.Error: 0>
        >>> loom.set_verbosity_level(loom.VerbosityLevel.Info)
    """
    if not isinstance(verbosity_level, VerbosityLevel):
        names = ", ".join(f"VerbosityLevel.{level.name}" for level in VerbosityLevel)
        raise TypeError(f"verbosity_level: expected one of {names}, got {type(verbosity_level).__name__}")
    start()
    LOGGER.setLevel(LEVELS[verbosity_level])


def get_verbosity_level() -> VerbosityLevel:
    """How much is said; see `set_verbosity_level`.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.core.verbosity import get_verbosity_level
        >>> with loom.VerbosityContextManager(loom.VerbosityLevel.Warning):
        ...     get_verbosity_level()
        <VerbosityLevel.Warning: 1>
    """
    level = LOGGER.getEffectiveLevel()
    said = [name for name, value in LEVELS.items() if value >= level]
    return said[-1] if said else VerbosityLevel.Error


class VerbosityContextManager:
    """Say more or less inside a `with` block, and what was said before after it.

    Args:
        level: A VerbosityLevel.

    Raises:
        TypeError: Not a VerbosityLevel.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.core.verbosity import get_verbosity_level
        >>> with loom.VerbosityContextManager(loom.VerbosityLevel.Debug):
        ...     print(get_verbosity_level().name)
        Debug
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
def told_time(what: str, wanted: bool) -> Iterator[None]:
    """Print what is done and how long it took, where a caller wants to see progress and there are no steps to count."""
    if not wanted:
        yield
        return
    began = time.monotonic()
    _print(f"{what} ...")
    yield
    _print(f"{what}: {time.monotonic() - began:.1f} s")


class LoggedProgress:
    """A `ReportProgress` for calls that were given none: says how far they are where they take long.

    Level INFO: not before `PATIENCE`, and not more often. Level DEBUG: each stage as it begins.
    """

    def __init__(self) -> None:
        self._began = self._said = time.monotonic()
        self._stage = ""

    def __call__(self, stage: str, done: int, total: int) -> None:
        """Say it, if it is time."""
        now = time.monotonic()
        text = f"{stage} {done:,} of {total:,}" if total else f"{stage} {done:,}" if done else stage
        if now - self._said >= PATIENCE:
            self._said = now
            LOGGER.info("%s, after %s", text, f"{now - self._began:.0f} s")
        elif stage != self._stage:
            LOGGER.debug("%s", text)
        self._stage = stage


start()
