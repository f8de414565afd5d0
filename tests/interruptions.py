"""Interrupts an operation before each of its lines in turn: what Ctrl-C does, at every place where it can."""

import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

PACKAGE = Path(__file__).resolve().parent.parent / "src" / "pointloom"


class _Lines:
    """Counts the lines of some files that this thread runs, and raises before one of them."""

    def __init__(self, files: tuple[str, ...], stop: int | None):
        self.files, self.stop, self.count = {str(PACKAGE / name) for name in files}, stop, 0

    def __call__(self, frame: FrameType, event: str, argument: Any) -> Any:
        return self.line if frame.f_code.co_filename in self.files else None

    def line(self, frame: FrameType, event: str, argument: Any) -> Any:
        if event == "line":
            self.count += 1
            if self.count == self.stop:
                sys.settrace(None)
                raise KeyboardInterrupt
        return self.line


def run_lines(act: Callable[[], Any], files: tuple[str, ...], stop: int | None = None) -> int:
    """Run an operation, interrupted before the `stop`-th of the lines that it runs in these files of the package.

    Returns:
        The lines that ran; `stop`, where it was interrupted.
    """
    lines, before = _Lines(files, stop), sys.gettrace()
    sys.settrace(lines)
    try:
        act()
    except KeyboardInterrupt:
        assert lines.count == stop
    finally:
        sys.settrace(before)
    return lines.count
