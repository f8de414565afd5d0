"""MCAP files, walked by the heads of their records, so that one without a summary reads as well.

Source: the MCAP format specification, version 0.
"""

from __future__ import annotations

import functools
import struct
import zlib
from pathlib import Path
from typing import Any

from ...core.errors import FileError
from ..source import open_source
from .pieces import Channel, Contents, number, slice_of, unpack

MAGIC = b"\x89MCAP0\r\n"
_SCHEMA, _CHANNEL, _MESSAGE, _CHUNK, _INDEX, _DATA_END = 3, 4, 5, 6, 7, 15


class _Walk:
    """What is known on the way through a file."""

    def __init__(self, path: Path, source: Any):
        self.path, self.source, self.schemas = path, source, {0: ""}
        self.found = Contents(path, functools.partial(_payload, path))
        self.waiting: dict[int, list[tuple[int, int, int]]] = {}  # by piece: channel, time, place

    def walk(self, data: Any, piece: int, place: int) -> bool:
        """Take all records; of a chunk its messages too. Whether the end of the data was told."""
        while place < len(data):
            op, length = number("B", data, place), number("Q", data, place + 1)
            begin = place + 9
            if begin + length > len(data):
                raise FileError(self.path, f"a record of {length} bytes is cut off", where=f"byte {place}")
            if op == _DATA_END:
                return True
            if op == _CHUNK:
                self.close_chunk()
                self.open_chunk(begin, length)
            elif op == _INDEX and self.waiting:
                self.take_index(slice_of(self.path, data, begin, length))
            elif op == _SCHEMA:
                self.take_schema(slice_of(self.path, data, begin, length))
            elif op == _CHANNEL:
                self.take_channel(slice_of(self.path, data, begin, length))
            elif op == _MESSAGE:
                channel, time = number("H", data, begin), number("Q", data, begin + 6)
                self.found.entries.append((time, channel, piece, place))
            place = begin + length
        return False

    def open_chunk(self, begin: int, length: int) -> None:
        """A chunk whose index may follow."""
        form, at = _text(self.path, self.source, begin + 28)
        size, check = number("Q", self.source, begin + 16), number("I", self.source, begin + 24)
        stored = number("Q", self.source, at)
        if at + 8 + stored > begin + length:
            raise FileError(self.path, "a chunk is longer than its record", where=f"byte {begin}")

        def read() -> bytes:
            data = unpack(self.path, self.source[at + 8 : at + 8 + stored], form, size)
            if check and zlib.crc32(data) != check:
                raise FileError(self.path, "a chunk is damaged: its checksum is another", where=f"byte {begin}")
            return data

        self.found.pieces.append(read)
        self.waiting = {len(self.found.pieces) - 1: []}

    def close_chunk(self) -> None:
        """Take over the index of a chunk, or look through it where there is none or it names unknown channels."""
        for piece, rows in self.waiting.items():
            self.waiting = {}
            if rows and all(channel in self.found.channels for channel, _, _ in rows):
                self.found.entries += [(time, channel, piece, place) for channel, time, place in rows]
            else:
                self.walk(self.found.pieces[piece](), piece, 0)

    def take_index(self, data: bytes) -> None:
        """The messages of one channel in the last chunk."""
        (rows,) = self.waiting.values()
        channel, size = number("H", data, 0), number("I", data, 2)
        rows += [(channel, time, place) for time, place in struct.iter_unpack("<QQ", data[6 : 6 + size])]

    def take_schema(self, data: bytes) -> None:
        """The name of a type."""
        self.schemas[number("H", data, 0)] = _text(self.path, data, 2)[0]

    def take_channel(self, data: bytes) -> None:
        """A topic."""
        topic, at = _text(self.path, data, 4)
        kind, encoding = self.schemas.get(number("H", data, 2), ""), _text(self.path, data, at)[0]
        kind = kind if "/msg/" in kind else kind.replace("/", "/msg/", 1)
        self.found.channels[number("H", data, 0)] = Channel(topic, kind, encoding)


def read_mcap(path: Path) -> Contents:
    """Find all messages of a file.

    Raises:
        FileError: No such file.
    """
    source: Any = open_source(path)
    if source[: len(MAGIC)] != MAGIC:
        raise FileError(path, "is no MCAP file", where="byte 0")
    walk = _Walk(path, source)
    walk.found.pieces.append(lambda: source)
    ended = False
    try:
        ended = walk.walk(source, 0, len(MAGIC))
    except (FileError, struct.error, ValueError) as error:
        walk.found.damage = f"is cut off or damaged: {error}"
    try:
        walk.close_chunk()
    except (FileError, struct.error, ValueError) as error:
        walk.found.damage = walk.found.damage or f"has a damaged chunk: {error}"
    if not ended and walk.found.damage is None:
        walk.found.damage = "is cut off: nothing tells the end of its data"
    return walk.found


def _text(path: Path, data: Any, begin: int) -> tuple[str, int]:
    """A text, and where it ends."""
    size = number("I", data, begin)
    return slice_of(path, data, begin + 4, size).decode("utf-8", "replace"), begin + 4 + size


def _payload(path: Path, data: bytes, place: int) -> bytes:
    return slice_of(path, data, place + 31, number("Q", data, place + 1) - 22)
