"""Standard streams, which may be None, closed or of any class in services and programs without a console."""

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
        if hasattr(stream, "flush"):  # consoles of some programs only have write()
            stream.flush()


def is_terminal(stream: Any) -> bool:
    try:
        return bool(stream.isatty())
    except (AttributeError, ValueError):  # None, of a class without it, or closed
        return False
