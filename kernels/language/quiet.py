"""What native code writes to the standard error stream, kept from it."""

from __future__ import annotations

import contextlib
import os
import sys
import tempfile
from collections.abc import Iterator


@contextlib.contextmanager
def kept_from_stderr() -> Iterator[list[str]]:
    """Keep what is written to file descriptor 2 inside the block; its lines stand in the list afterwards."""
    lines: list[str] = []
    sys.stderr.flush()
    with tempfile.TemporaryFile() as kept:
        stderr = os.dup(2)
        try:
            os.dup2(kept.fileno(), 2)
            yield lines
        finally:
            os.dup2(stderr, 2)
            os.close(stderr)
        kept.seek(0)
        lines += kept.read().decode(errors="replace").splitlines()
