"""What the device has found: faults, notes and counts, and the report of them."""

import contextlib
import json
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

from .settings import settings

# Faults and notes by their numbers in runtime/emulator.h
FAULTS = (
    *("none", "address outside the device's memory", "address outside any live array (bounds, or released)"),
    *("misaligned address", "address outside shared memory", "trap", "assertion"),
    *("threads wait for each other for ever", "threads of a warp meet in different instructions"),
)
UNWRITTEN = "read of bytes that nobody wrote"
NOTES = (
    *(UNWRITTEN, "race: two writes", "race: read and write", "atomic beside plain access", "division by zero"),
    *("float out of the integer's range", "meeting without all lanes"),
)
COUNTED = (
    *("launches", "launches asked for", "threads", "graphs", "graphs made", "copies to host", "copies to device"),
    *("bytes to host", "bytes to device", "waits", "allocations", "modules compiled"),
)
_HERE = str(Path(__file__).parent)
_NOT_CALLERS = ("/warp/", "contextlib.py", "/_pytest/", "/pluggy/", _HERE + "/")


class CudaFault(RuntimeError):  # noqa: N818  CUDA's own word
    """What a CUDA device would refuse, or get wrong without a word."""


def caller() -> str:
    """The calls outside Warp that led here, innermost first."""
    frame, calls = sys._getframe(2), []
    while frame is not None and len(calls) < 4:
        code = frame.f_code
        is_test = code.co_name.startswith("test_")
        if is_test or not any(part in code.co_filename for part in _NOT_CALLERS):
            calls.append(f"{'/'.join(code.co_filename.rsplit('/', 2)[-2:])}:{frame.f_lineno} {code.co_name}")
        frame = frame.f_back
    return " < ".join(calls)


@dataclass
class Note:
    """A suspicious operation that CUDA allows or cannot detect."""

    count: int
    launches: int
    first: str


@dataclass(frozen=True)
class Launch:
    """A launch with its memory accesses, and those of its longest thread."""

    kernel: str
    threads: int
    accesses: int
    longest: int


class Findings:
    def __init__(self) -> None:
        self.error = ""
        self.faults: list[str] = []
        self.notes: dict[tuple[str, str], Note] = {}  # by kernel and kind
        self.launches: dict[str, list] = {}  # kernel -> launches, threads, seconds
        self.atomics: Counter[str] = Counter()  # of each kernel, on global memory
        self.recorded: list[Launch] | None = None  # launches with their work, while something records them
        self.kernels: dict[str, list[str]] = {}  # findings in the PTX of each kernel
        self.counts = dict.fromkeys(COUNTED, 0)
        self.seconds = {"translate": 0.0, "compile": 0.0, "run": 0.0}

    def fault(self, text: str) -> None:
        self.faults.append(text)
        self.error = text
        raise CudaFault(text)

    def refuse(self, text: str) -> bool:
        """Record a fault that Warp raises when it sees the status; False, to be returned."""
        self.faults.append(text)
        self.error = f"Emulated CUDA error: {text}"
        return False

    def note(self, kernel: str, kind: str, first: str, count: int = 1) -> None:
        note = self.notes.setdefault((kernel, kind), Note(0, 0, first))
        note.count += count
        note.launches += 1

    @contextlib.contextmanager
    def recording(self) -> Iterator[list[Launch]]:
        """The launches that run inside."""
        self.recorded = []
        try:
            yield self.recorded
        finally:
            self.recorded = None

    @contextlib.contextmanager
    def expected(self) -> Iterator[None]:
        """Faults in here are the point of a test."""
        known = len(self.faults)
        try:
            yield
        finally:
            del self.faults[known:]

    def wp_get_error_string(self) -> bytes:
        return self.error.encode()

    def write_report(self, path: str, memory: dict[str, int]) -> None:
        listed = {
            "settings": asdict(settings),
            "faults": self.faults,
            "notes": [{"kernel": k, "kind": kind, **asdict(n)} for (k, kind), n in sorted(self.notes.items())],
            "counts": self.counts,
            "seconds": self.seconds,
            "memory": memory,
            "kernels": {
                name: {
                    "launches": count,
                    "threads": threads,
                    "atomics": self.atomics[name],
                    "seconds": round(seconds, 3),
                }
                for name, (count, threads, seconds) in sorted(self.launches.items())
            },
            "compiled": {name: entries for name, entries in sorted(self.kernels.items()) if entries},
        }
        Path(path).write_text(json.dumps(listed, indent=1))
