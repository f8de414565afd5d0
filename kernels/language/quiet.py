"""Removal of lines that native code writes to the standard error stream."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Iterator
from typing import IO

STDERR = 2


@contextlib.contextmanager
def lines_removed_from_stderr(phrase: str) -> Iterator[None]:
    """Drop the lines with a phrase that the block writes to file descriptor 2; all others are written after it.

    The descriptor belongs to the whole process, so the block has to be short. Python's own stream, which may be None,
    closed or of any class, is not used. If the descriptor is closed or no temporary file can be made, nothing is
    dropped.
    """
    captured = _redirected()
    if captured is None:
        yield
        return
    file, stderr = captured
    try:
        yield
    finally:
        os.dup2(stderr, STDERR)
        os.close(stderr)
        with file:
            file.seek(0)
            kept = b"".join(line for line in file if phrase.encode() not in line)
        with contextlib.suppress(OSError):
            os.write(STDERR, kept)


def _redirected() -> tuple[IO[bytes], int] | None:
    """A temporary file in place of descriptor 2, and a copy of the descriptor; None if that is impossible."""
    try:
        os.fstat(STDERR)
        file = tempfile.TemporaryFile()
    except OSError:
        return None
    try:
        stderr = os.dup(STDERR)
    except OSError:
        file.close()
        return None
    os.dup2(file.fileno(), STDERR)
    return file, stderr
