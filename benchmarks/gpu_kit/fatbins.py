"""GPU code in shared libraries: zero all but one architecture's code, so that the library compresses well.

A fatbin is a header (magic, version, size) and entries, each with a kind (1: PTX, 2: machine code), an architecture and
a payload. The headers are unchanged, so the driver still finds the code of its own architecture.
"""

from __future__ import annotations

import mmap
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

MAGIC = struct.pack("<I", 0xBA55ED50)
MACHINE_CODE, KINDS = 2, (1, 2, 4, 8, 16, 32)
HEADER, MIN_ENTRY, MAX_ENTRY = 16, 32, 4096  # bytes


class Entry(NamedTuple):
    """The code of one architecture."""

    offset: int
    size: int
    kind: int
    architecture: int


def entries(data: bytes | bytearray | mmap.mmap) -> Iterator[Entry]:
    """The code of all fatbins in a file."""
    at = data.find(MAGIC)
    while at >= 0:
        _, _, header, size = struct.unpack_from("<IHHQ", data, at)
        if header != HEADER or at + header + size > len(data):
            at = data.find(MAGIC, at + 4)
            continue
        entry, end = at + header, at + header + size
        while entry < end:
            kind, _, own_header, payload = struct.unpack_from("<HHIQ", data, entry)
            if kind not in KINDS or not MIN_ENTRY <= own_header <= MAX_ENTRY:
                break
            yield Entry(entry + own_header, payload, kind, struct.unpack_from("<I", data, entry + 28)[0])
            entry += own_header + payload
        at = data.find(MAGIC, end)


def keep_architecture(library: Path, architecture: int) -> int:
    """Zero all code in a library except one architecture's; returns the number of zeroed bytes."""
    zeroed = 0
    with library.open("r+b") as file, mmap.mmap(file.fileno(), 0) as data:
        for entry in list(entries(data)):
            if (entry.kind, entry.architecture) != (MACHINE_CODE, architecture):
                data[entry.offset : entry.offset + entry.size] = bytes(entry.size)
                zeroed += entry.size
    return zeroed
