"""MCAP files, parsed by record headers, so that a summary is not required.

A chunk index is used only if it is consistent and the file statistics agree. Otherwise chunks are unpacked and
searched. MCAP format specification, version 0.
"""

from __future__ import annotations

import struct
import zlib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...core.errors import FileError
from ..source import open_source
from .message_chunks import Channel, Chunk, Contents, Row, number, slice_of, unpack

MAGIC = b"\x89MCAP0\r\n"
_FOOTER_OP, _SCHEMA_OP, _CHANNEL_OP, _MESSAGE_OP, _CHUNK_OP, _INDEX_OP = range(2, 8)
_STATISTICS_OP, _DATA_END_OP = 11, 15
_PRIVATE_OPS = 128  # records of this kind and above are for applications
_MESSAGE_HEAD = 22  # [B] channel, sequence and two times
_DAMAGED = (FileError, struct.error, ValueError)


@dataclass(kw_only=True)
class _Chunk(Chunk):
    """A chunk with its first and last time [ns]."""

    start: int
    end: int
    was_searched: bool = False


class _File:
    def __init__(self, path: Path, source: Any):
        self.path, self.source = path, source
        self.schemas: dict[int, str] = {0: ""}
        self.contents = Contents(path, self.payload, pieces=[lambda: source])
        self.chunks: list[_Chunk] = []
        self.loose: list[Row] = []  # messages outside of chunks
        self.has_end = False
        self.statistics: tuple[int, dict[int, int]] | None = None  # messages, also by channel

    def records(self, data: Any, offset: int) -> Iterator[tuple[int, int, int]]:
        """Yield operation code, offset and length of each record's content."""
        while offset < len(data):
            op, length = number("B", data, offset), number("Q", data, offset + 1)
            begin = offset + 9
            if begin + length > len(data):
                raise FileError(self.path, f"a record of {length} bytes is cut off", where=f"byte {offset}")
            yield op, begin, length
            offset = begin + length

    def parse(self) -> None:
        try:
            for op, begin, length in self.records(self.source, len(MAGIC)):
                if op == _FOOTER_OP:
                    break
                if op == _DATA_END_OP:
                    self.has_end = True
                elif op == _STATISTICS_OP and self.has_end:
                    self.take_statistics(slice_of(self.path, self.source, begin, length))
                elif not self.has_end:
                    self.take(op, begin, length)
        except _DAMAGED as error:
            what = "has a damaged summary" if self.has_end else "is cut off or damaged"
            self.contents.note(f"{what}: {error}")
        if not self.has_end:
            self.contents.note("is cut off: the record that ends its data is missing")

    def take(self, op: int, begin: int, length: int) -> None:
        if op == _CHUNK_OP:
            self.take_chunk(begin, length)
        elif op == _INDEX_OP:
            self.take_index(slice_of(self.path, self.source, begin, length))
        elif op == _MESSAGE_OP:
            self.loose.append(self.row_of(self.source, begin, length))
        elif op:
            self.take_definition(op, self.source, begin, length)
        else:
            raise FileError(self.path, "a record has no kind", where=f"byte {begin - 9}")

    def take_definition(self, op: int, data: Any, begin: int, length: int) -> None:
        if op == _SCHEMA_OP:
            content = slice_of(self.path, data, begin, length)
            self.schemas[number("H", content, 0)] = _text(self.path, content, 2)[0]
        elif op == _CHANNEL_OP:
            content = slice_of(self.path, data, begin, length)
            topic, at = _text(self.path, content, 4)
            kind, encoding = self.schemas.get(number("H", content, 2), ""), _text(self.path, content, at)[0]
            kind = kind if "/msg/" in kind else kind.replace("/", "/msg/", 1)
            self.contents.add_channel(number("H", content, 0), Channel(topic, kind, encoding))

    def row_of(self, data: Any, begin: int, length: int) -> Row:
        """The index entry of a message from its header."""
        if length < _MESSAGE_HEAD:
            raise FileError(self.path, f"a message of {length} bytes has no head", where=f"byte {begin}")
        return number("Q", data, begin + 6), number("H", data, begin), begin - 9

    def take_chunk(self, begin: int, length: int) -> None:
        form, at = _text(self.path, self.source, begin + 28)
        start, end, size = struct.unpack("<QQQ", self.source[begin : begin + 24])
        check, stored = number("I", self.source, begin + 24), number("Q", self.source, at)
        if at + 8 + stored > begin + length:
            raise FileError(self.path, "a chunk is longer than its record", where=f"byte {begin}")

        def read() -> bytes:
            data = unpack(self.path, self.source[at + 8 : at + 8 + stored], form, size)
            if check and zlib.crc32(data) != check:
                raise FileError(self.path, "a chunk is damaged: its checksum differs", where=f"byte {begin}")
            return data

        self.contents.pieces.append(read)
        self.chunks.append(_Chunk(begin, len(self.contents.pieces) - 1, size, start=start, end=end))

    def take_index(self, data: bytes) -> None:
        if not self.chunks:
            raise ValueError("an index record has no chunk")
        chunk, channel, size = self.chunks[-1], number("H", data, 0), number("I", data, 2)
        if len(data) != 6 + size or size % 16 or channel in chunk.channels:
            chunk.is_consistent = False
            return
        chunk.channels.add(channel)
        chunk.rows += [(time, channel, offset) for time, offset in struct.iter_unpack("<QQ", data[6:])]

    def take_statistics(self, data: bytes) -> None:
        size = number("I", data, 42)
        if len(data) < 46 + size or size % 10:
            raise ValueError("the statistics are cut off")
        self.statistics = number("Q", data, 0), dict(struct.iter_unpack("<HQ", data[46 : 46 + size]))

    def resolve_messages(self) -> None:
        """Choose the messages of each chunk: from its index, or from the chunk itself.
        The statistics confirm the indexes. A truncated file has none and is reported as damaged."""
        for chunk in self.chunks:
            if not self.is_trusted(chunk):
                self.search(chunk)
        is_cut_off = self.contents.damage is not None and self.statistics is None
        if not self.is_confirmed() and not is_cut_off:
            for chunk in self.chunks:
                self.search(chunk)
            if self.statistics is not None and not self.is_confirmed():
                count = len(self.loose) + sum(len(chunk.rows) for chunk in self.chunks)
                self.contents.note(f"lists {self.statistics[0]} messages in its summary, but contains {count}")
        self.contents.entries += [(time, channel, 0, offset) for time, channel, offset in self.loose]
        for chunk in self.chunks:
            self.contents.entries += [(time, channel, chunk.piece, offset) for time, channel, offset in chunk.rows]

    def is_trusted(self, chunk: _Chunk) -> bool:
        """True if a chunk's index is consistent, without reading its messages."""
        times = [time for time, _, _ in chunk.rows]
        return chunk.is_plausible(self.contents.channels) and (min(times), max(times)) == (chunk.start, chunk.end)

    def is_confirmed(self) -> bool:
        """True if the message counts per channel match the statistics."""
        if self.statistics is None:
            return False
        counts = Counter(channel for _, channel, _ in self.loose)
        for chunk in self.chunks:
            counts.update(channel for _, channel, _ in chunk.rows)
        total, by_channel = self.statistics
        by_channel = {channel: count for channel, count in by_channel.items() if count}
        return total == counts.total() and by_channel in ({}, counts)

    def search(self, chunk: _Chunk) -> None:
        if chunk.was_searched:
            return
        chunk.was_searched, rows = True, []
        try:
            data = self.contents.pieces[chunk.piece]()
            for op, begin, length in self.records(data, 0):
                if op == _MESSAGE_OP:
                    rows.append(self.row_of(data, begin, length))
                elif op in (_SCHEMA_OP, _CHANNEL_OP):
                    self.take_definition(op, data, begin, length)
                elif op < _PRIVATE_OPS:
                    raise FileError(self.path, f"a chunk contains a record of kind {op}", where=f"byte {chunk.begin}")
        except _DAMAGED as error:
            self.contents.note(f"has a damaged chunk: {error}")
        else:
            if chunk.differs_from(rows):
                self.contents.note(
                    f"has an index that contradicts its messages, which were used, at byte {chunk.begin}"
                )
        chunk.rows = rows

    def payload(self, data: bytes, offset: int, channel: int, time: int) -> bytes:
        length = number("Q", data, offset + 1)
        if number("B", data, offset) != _MESSAGE_OP or self.row_of(data, offset + 9, length)[:2] != (time, channel):
            raise FileError(self.path, "the index refers to another message", where=f"byte {offset} of a chunk")
        return slice_of(self.path, data, offset + 9 + _MESSAGE_HEAD, length - _MESSAGE_HEAD)


def read_mcap(path: Path) -> Contents:
    source: Any = open_source(path)
    if source[: len(MAGIC)] != MAGIC:
        raise FileError(path, "is not an MCAP file", where="byte 0")
    file = _File(path, source)
    file.parse()
    file.resolve_messages()
    return file.contents


def _text(path: Path, data: Any, begin: int) -> tuple[str, int]:
    size = number("I", data, begin)
    return slice_of(path, data, begin + 4, size).decode("utf-8", "replace"), begin + 4 + size
