"""Standard streams, which may be None, closed or of any class in services and in programs without a console."""

from __future__ import annotations

import contextlib
import sys
from typing import Any


def write_to_stderr(text: str) -> None:
    """Write text and a line end to sys.stderr; do nothing if it is None, closed or cannot be written."""
    stream = sys.stderr
    if stream is None:
        return
    with contextlib.suppress(OSError, ValueError):
        stream.write(f"{text}\n")
        if hasattr(stream, "flush"):  # consoles in other programs have write() alone
            stream.flush()


def is_terminal(stream: Any) -> bool:
    """True if a stream is an open terminal."""
    try:
        return bool(stream.isatty())
    except (AttributeError, ValueError):  # None or of a class without it; closed
        return False
