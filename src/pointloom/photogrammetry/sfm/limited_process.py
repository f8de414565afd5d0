"""Child processes with time and memory limits that never outlive this process.

Each leads its own process group, which is killed (SIGKILL) at a limit, on interruption (Ctrl-C), or on any exit.
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
from ...core.timing import peak_of_process
from ...core.wording import format_bytes

_WATCH_INTERVAL = 0.1  # [s]
_LAST_LINES = 6  # quoted lines of program output
_LAST_BYTES = 16384
_LINE_LENGTH = 300
_ADDRESS = re.compile(r"\s*(@ .*|\*\*\* .*|PC: .*)?$")  # a stack line, or an empty one
_MEMORY_FRACTION = 0.9  # fraction of the free memory at start
_BYTES_PER_KIBIBYTE = 1024


def check_limits(max_seconds: Any, max_memory: Any) -> dict[str, Any]:
    seconds = float("inf") if max_seconds is None else check_positive("max_seconds", max_seconds, allow_infinite=True)
    if max_memory is not None:
        check_count("max_memory", max_memory, minimum=2**20, maximum=2**60, because="no machine has more memory")
    return {"max_seconds": seconds, "max_memory": max_memory}


def python_command(script: Path) -> list[str]:
    """Command that runs a script of the package with this Python.

    Raises:
        RuntimeError: In a packed application, whose executable would start the application again.
    """
    if getattr(sys, "frozen", False):
        raise RuntimeError(
            f"{script.name} needs a Python interpreter, which an application packed by PyInstaller does not have. Run "
            "structure from motion, or read the video, in a plain Python process"
        )
    return [sys.executable, "-P", os.fspath(script)]


class LimitedProcess:
    """A child process in a `with` block that ends it; `max_memory` [B] is only enforced on Linux."""

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
            self._stderr = self._files.enter_context(tempfile.TemporaryFile())
            self._process = subprocess.Popen(
                self._command, stdin=given, stdout=subprocess.PIPE, stderr=self._stderr, start_new_session=True
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
        assert self._process is not None
        return self._process.wait()

    def last_words(self) -> str:
        text = _end_of(self._stderr).decode(errors="replace")
        lines = [line.strip()[:_LINE_LENGTH] for line in text.splitlines() if not _ADDRESS.match(line)]
        return " / ".join(lines[-_LAST_LINES:])

    def why_ended(self) -> str:
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
        """Kill the process at a limit, which closes its output."""
        assert self._process is not None
        end = time.monotonic() + min(self.max_seconds, threading.TIMEOUT_MAX)
        while not self._over.wait(_WATCH_INTERVAL) and self._process.poll() is None:
            memory = peak_of_process(self._process.pid)
            self.peak_bytes = max(self.peak_bytes, memory)
            reason = "time" if time.monotonic() > end else "memory" if memory > self.max_memory else ""
            if reason:
                self.killed_for = reason
                self._kill()
                return

    def _kill(self) -> None:
        if self._process is not None and self._process.returncode is None:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                if sys.platform == "win32":  # without process groups
                    self._process.kill()
                else:
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


def _end_of(file: IO[bytes]) -> bytes:
    first = max(os.fstat(file.fileno()).st_size - _LAST_BYTES, 0)
    if sys.platform != "win32":
        return os.pread(file.fileno(), _LAST_BYTES, first)  # leaves the position, which the process shares
    file.seek(first)
    return file.read(_LAST_BYTES)


def free_memory() -> float:
    """Memory that a child may use [B], infinite if unknown."""
    if sys.platform == "linux":
        with contextlib.suppress(OSError, ValueError, IndexError):
            for line in Path("/proc/meminfo").read_text(encoding="utf-8").splitlines():
                if line.startswith("MemAvailable:"):
                    return _MEMORY_FRACTION * int(line.split()[1]) * _BYTES_PER_KIBIBYTE
    return float("inf")
