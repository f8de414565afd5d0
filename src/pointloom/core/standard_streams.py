"""Access to standard streams. In services and programs without a console they may be None, closed or of any class."""

from __future__ import annotations

import contextlib
import sys
from typing import Any


def write_to_stderr(text: str) -> None:
    stream = sys.stderr
    if stream is None:
        return
    with contextlib.suppress(OSError, ValueError):
        stream.write(f"{text}\n")
        if hasattr(stream, "flush"):  # the consoles of some programs have only write()
            stream.flush()


def is_terminal(stream: Any) -> bool:
    try:
        return bool(stream.isatty())
    except (AttributeError, ValueError):  # the stream is None, has no isatty(), or is closed
        return False
