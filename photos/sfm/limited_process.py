"""Programs that are run beside ours: with a limit of time and of memory, and never left behind.

A program leads a process group of its own, and the whole group is killed (SIGKILL) where a limit is passed, where
whoever waits for it is interrupted, and where it is left for any other reason. So Ctrl-C ends what runs at once, and a
library that hangs or eats the memory takes nothing with it.
"""

from __future__ import annotations

import contextlib
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from pathlib import Path
from typing import IO, Any

from ...core.checks import check_count, check_positive
from ...core.wording import format_bytes

_WATCH_INTERVAL = 0.1  # [s]
_LAST_LINES = 6  # of what a program says that errors quote
_LAST_BYTES = 16384
_LINE_LENGTH = 300
_ADDRESS = re.compile(r"\s*(@ .*|\*\*\* .*|PC: .*)?$")  # a line of a stack, or an empty one
_MEMORY_SHARE = 0.9  # of what is free when a program starts
_KIBIBYTE = 1024


def check_limits(max_seconds: Any, max_memory: Any) -> dict[str, Any]:
    """The limits of time [s] and memory [B] of a program, as users give them and as `LimitedProcess` takes them."""
    seconds = float("inf") if max_seconds is None else check_positive("max_seconds", max_seconds, allow_infinite=True)
    if max_memory is not None:
        check_count("max_memory", max_memory, minimum=2**20, maximum=2**60, because="no machine has more")
    return {"max_seconds": seconds, "max_memory": max_memory}


class LimitedProcess:
    """A program that runs, in a `with` block that ends it.

    Args:
        command: The program and its arguments.
        max_seconds: It is killed after this time [s].
        max_memory: It is killed when it holds more than this [B]; None for nine tenths of what is free now. Linux
            alone tells how much that is; elsewhere there is no limit.
        stdin: What it reads.

    Attributes:
        stdout: What it writes, to be read; None before and after the block.
        peak_bytes: The most memory that it was seen to hold [B].
        killed_for: "time" or "memory" where it passed a limit, else "".
    """

    def __init__(
        self,
        command: Sequence[str],
        *,
        max_seconds: float = float("inf"),
        max_memory: int | None = None,
        stdin: str = "",
    ):
        self._command, self._stdin = list(command), stdin
        self.max_seconds = max_seconds
        self.max_memory = max_memory or free_memory()
        self.peak_bytes, self.killed_for = 0, ""
        self.stdout: IO[bytes] | None = None
        self._process: subprocess.Popen[bytes] | None = None
        self._over = threading.Event()

    def __enter__(self) -> LimitedProcess:
        self._files = contextlib.ExitStack()
        try:
            given = self._files.enter_context(tempfile.TemporaryFile())
            given.write(self._stdin.encode())
            given.seek(0)
            self._said = self._files.enter_context(tempfile.TemporaryFile())
            self._process = subprocess.Popen(
                self._command, stdin=given, stdout=subprocess.PIPE, stderr=self._said, start_new_session=True
            )
            self.stdout = self._process.stdout
            self._watcher = threading.Thread(target=self._watch, daemon=True)
            self._watcher.start()
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._end()

    def wait(self) -> int:
        """Wait for its end; gives its exit status, below zero for the number of a signal."""
        assert self._process is not None
        return self._process.wait()

    def last_words(self) -> str:
        """The end of what it said on standard error, in one line, without the addresses of a crash."""
        size = os.fstat(self._said.fileno()).st_size
        text = os.pread(self._said.fileno(), _LAST_BYTES, max(size - _LAST_BYTES, 0)).decode(errors="replace")
        lines = [line.strip()[:_LINE_LENGTH] for line in text.splitlines() if not _ADDRESS.match(line)]
        return " / ".join(lines[-_LAST_LINES:])

    def why_ended(self) -> str:
        """How it ended, in words: by a limit, by a signal, by itself."""
        if self.killed_for == "time":
            return f"was stopped after {self.max_seconds:g} s, its limit (max_seconds)"
        if self.killed_for == "memory":
            return (
                f"was stopped at {format_bytes(self.peak_bytes)} of memory; its limit (max_memory) is "
                + format_bytes(self.max_memory)
            )
        status = self.wait()
        if status >= 0:
            return f"ended with exit code {status}"
        with contextlib.suppress(ValueError):
            return f"was ended by {signal.Signals(-status).name}"
        return f"was ended by signal {-status}"

    def _watch(self) -> None:
        """Kill it where it passes a limit; the thread that uses it then sees the end of what it writes."""
        assert self._process is not None
        end = time.monotonic() + min(self.max_seconds, threading.TIMEOUT_MAX)
        while not self._over.wait(_WATCH_INTERVAL) and self._process.poll() is None:
            held = _memory_of(self._process.pid)
            self.peak_bytes = max(self.peak_bytes, held)
            reason = "time" if time.monotonic() > end else "memory" if held > self.max_memory else ""
            if reason:
                self.killed_for = reason
                self._kill()
                return

    def _kill(self) -> None:
        if self._process is not None and self._process.returncode is None:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(self._process.pid, signal.SIGKILL)

    def _end(self) -> None:
        self._kill()
        self._over.set()
        if self._process is not None:
            if self._process.stdout is not None:
                self._process.stdout.close()
            self._process.wait()
            self._watcher.join()
        self.stdout = None
        self._files.close()


def _memory_of(pid: int) -> int:
    """The memory that a process has held at most [B]; 0 where nobody tells."""
    with contextlib.suppress(OSError, ValueError, IndexError):
        for line in Path(f"/proc/{pid}/status").read_text().splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * _KIBIBYTE
    return 0


def free_memory() -> float:
    """What a program may take of the memory that is free [B]; infinite where nobody tells."""
    if sys.platform == "linux":
        with contextlib.suppress(OSError, ValueError, IndexError):
            for line in Path("/proc/meminfo").read_text().splitlines():
                if line.startswith("MemAvailable:"):
                    return _MEMORY_SHARE * int(line.split()[1]) * _KIBIBYTE
    return float("inf")
