"""ROS 1 bags, format 2.0, parsed by record headers, so that an index is not required.

A chunk index is used only if it matches the list of chunks at the end. Otherwise the chunk is unpacked and searched.
rosbag format 2.0, ROS wiki.
"""

from __future__ import annotations

import struct
from collections import Counter
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from ...core.errors import FileError
from ..source import open_source
from .message_chunks import Channel, Chunk, Contents, Row, number, slice_of, unpack

MAGIC = b"#ROSBAG V2.0\n"
_MESSAGE_OP, _HEADER_OP, _INDEX_OP, _CHUNK_OP, _CHUNK_INFO_OP, _CONNECTION_OP = 2, 3, 4, 5, 6, 7
_DAMAGED = (FileError, struct.error, ValueError)


class _Fields(dict[bytes, bytes]):
    """Values of a header by name."""

    def __missing__(self, name: bytes) -> NoReturn:
        raise ValueError(f"a record has no field {name.decode()!r}")


class _Info(NamedTuple):
    """A chunk's entry in the list at the end: first and last time [ns], messages by connection."""

    start: int
    end: int
    counts: dict[int, int]


class _Bag:
    def __init__(self, path: Path, source: Any):
        self.path, self.source = path, source
        self.contents = Contents(path, self.payload)
        self.chunks: list[Chunk] = []
        self.infos: dict[int, _Info] = {}
        self.announced = 0  # number of chunks in the header of a closed bag

    def parse(self) -> None:
        offset = len(MAGIC)
        try:
            while offset < len(self.source):
                op, fields, begin, length = _record(self.path, self.source, offset)
                if op == _CHUNK_OP:
                    self.take_chunk(offset, fields, begin, length)
                elif op == _INDEX_OP:
                    self.take_index(fields, slice_of(self.path, self.source, begin, length))
                elif op == _CONNECTION_OP:
                    self.take_connection(fields, slice_of(self.path, self.source, begin, length))
                elif op == _CHUNK_INFO_OP:
                    self.take_info(fields, slice_of(self.path, self.source, begin, length))
                elif op == _HEADER_OP and any(fields.get(b"index_pos", b"")):  # otherwise the bag was not closed
                    self.announced = number("I", fields[b"chunk_count"], 0)
                elif op == _MESSAGE_OP:
                    self.contents.note(f"has a message outside of its chunks at byte {offset}")
                offset = begin + length
        except _DAMAGED as error:
            self.contents.note(f"is cut off or damaged at byte {offset} of {len(self.source)}: {error}")

    def take_chunk(self, offset: int, fields: dict[bytes, bytes], begin: int, length: int) -> None:
        form, size = fields[b"compression"].decode("ascii", "replace"), number("I", fields[b"size"], 0)
        path, source = self.path, self.source
        self.contents.pieces.append(lambda: unpack(path, source[begin : begin + length], form, size))
        self.chunks.append(Chunk(offset, len(self.contents.pieces) - 1, size))

    def take_index(self, fields: dict[bytes, bytes], data: bytes) -> None:
        if not self.chunks:
            raise ValueError("an index record has no chunk")
        chunk, connection = self.chunks[-1], number("I", fields[b"conn"], 0)
        if len(data) != 12 * number("I", fields[b"count"], 0) or connection in chunk.channels:
            chunk.is_consistent = False
            return
        chunk.channels.add(connection)
        chunk.rows += [(sec * 10**9 + nsec, connection, at) for sec, nsec, at in struct.iter_unpack("<III", data)]

    def take_info(self, fields: dict[bytes, bytes], data: bytes) -> None:
        counts = dict(struct.iter_unpack("<II", data))
        if len(counts) != number("I", fields[b"count"], 0) or len(data) != 8 * len(counts):
            raise ValueError("the list of chunks is contradictory")
        counts = {connection: count for connection, count in counts.items() if count}
        info = _Info(_time(fields[b"start_time"]), _time(fields[b"end_time"]), counts)
        self.infos[number("Q", fields[b"chunk_pos"], 0)] = info

    def take_connection(self, fields: dict[bytes, bytes], data: bytes) -> None:
        values, at = _Fields(), 0
        while at < len(data):
            size = number("I", data, at)
            name, _, value = slice_of(self.path, data, at + 4, size).partition(b"=")
            values[name] = value
            at += 4 + size
        topic = fields[b"topic"].decode("utf-8", "replace")
        kind = values[b"type"].decode("ascii", "replace").replace("/", "/msg/", 1)
        self.contents.add_channel(number("I", fields[b"conn"], 0), Channel(topic, kind, "ros1"))

    def resolve_messages(self) -> None:
        """Choose the messages of each chunk: from its index, or from the chunk itself."""
        if self.announced and (self.announced != len(self.chunks) or {*self.infos} - {c.begin for c in self.chunks}):
            self.contents.note(f"lists {max(self.announced, len(self.infos))} chunks, but contains {len(self.chunks)}")
        is_cut_off = self.contents.damage is not None
        for chunk in self.chunks:
            info = self.infos.get(chunk.begin)
            if not self.is_trusted(chunk, info, is_cut_off):
                self.search(chunk, info)
            self.contents.entries += [
                (time, connection, chunk.piece, offset) for time, connection, offset in chunk.rows
            ]

    def is_trusted(self, chunk: Chunk, info: _Info | None, is_cut_off: bool) -> bool:
        """True if a chunk's index is complete, without reading its messages.
        A complete bag without a list of chunks was not closed by its recorder, so nothing confirms its indexes."""
        if not chunk.is_plausible(self.contents.channels):
            return False
        if info is None:
            return is_cut_off
        is_in_time = all(info.start <= time <= info.end for time, _, _ in chunk.rows)
        return is_in_time and Counter(connection for _, connection, _ in chunk.rows) == info.counts

    def search(self, chunk: Chunk, info: _Info | None) -> None:
        """Read connections and messages from the records of a chunk."""
        rows: list[Row] = []
        try:
            data, offset = self.contents.pieces[chunk.piece](), 0
            while offset < len(data):
                op, fields, begin, length = _record(self.path, data, offset)
                if op == _CONNECTION_OP:
                    self.take_connection(fields, data[begin : begin + length])
                elif op == _MESSAGE_OP:
                    rows.append((_time(fields[b"time"]), number("I", fields[b"conn"], 0), offset))
                else:
                    raise FileError(self.path, f"a chunk contains a record of kind {op}", where=f"byte {chunk.begin}")
                offset = begin + length
        except _DAMAGED as error:
            self.contents.note(f"has a damaged chunk: {error}")
        else:
            counts = Counter(connection for _, connection, _ in rows)
            if chunk.differs_from(rows) or (info is not None and counts != info.counts):
                self.contents.note(
                    f"has an index that contradicts its messages, which were used, at byte {chunk.begin}"
                )
        chunk.rows = rows

    def payload(self, data: bytes, offset: int, connection: int, time: int) -> bytes:
        op, fields, begin, length = _record(self.path, data, offset)
        if op != _MESSAGE_OP or (_time(fields[b"time"]), number("I", fields[b"conn"], 0)) != (time, connection):
            raise FileError(self.path, "the index refers to another message", where=f"byte {offset} of a chunk")
        return slice_of(self.path, data, begin, length)


def read_bag1(path: Path) -> Contents:
    source: Any = open_source(path)
    if source[: len(MAGIC)] != MAGIC:
        raise FileError(path, "is not a ROS 1 bag of version 2.0", where="byte 0")
    bag = _Bag(path, source)
    bag.parse()
    bag.resolve_messages()
    return bag.contents


def _record(path: Path, data: Any, offset: int) -> tuple[int, dict[bytes, bytes], int, int]:
    """Operation code, fields, and data offset and length of a record."""
    head = number("I", data, offset)
    header, fields, at = slice_of(path, data, offset + 4, head), _Fields(), 0
    while at < len(header):
        size = number("I", header, at)
        name, _, value = slice_of(path, header, at + 4, size).partition(b"=")
        fields[name] = value
        at += 4 + size
    begin = offset + 8 + head
    length = number("I", data, offset + 4 + head)
    if begin + length > len(data):
        raise FileError(path, f"a record of {length} bytes is cut off", where=f"byte {offset}")
    return number("B", fields[b"op"], 0), fields, begin, length


def _time(value: bytes) -> int:
    seconds, nanoseconds = struct.unpack("<II", value)
    return seconds * 10**9 + nanoseconds
