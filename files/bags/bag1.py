"""Bags of ROS 1, format 2.0: records walked by their heads, so that a bag without an index reads as well.

Source: the rosbag format 2.0 of the ROS wiki.
"""

from __future__ import annotations

import functools
import struct
from pathlib import Path
from typing import Any

from ...core.errors import FileError
from ..source import open_source
from .pieces import Channel, Contents, number, slice_of, unpack

MAGIC = b"#ROSBAG V2.0\n"
_MESSAGE, _INDEX, _CHUNK, _CONNECTION = 2, 4, 5, 7


def read_bag1(path: Path) -> Contents:
    """Find all messages of a bag.

    Raises:
        FileError: No such bag.
    """
    source: Any = open_source(path)
    if source[: len(MAGIC)] != MAGIC:
        raise FileError(path, "is no bag of ROS 1, version 2.0", where="byte 0")
    found = Contents(path, functools.partial(_payload, path))
    chunk: int | None = None  # whose index has not been seen yet
    place = len(MAGIC)
    try:
        while place < len(source):
            op, fields, begin, length = _record(path, source, place)
            if op == _CHUNK:
                _scan_if_open(path, found, chunk)
                chunk = _add_chunk(path, source, found, fields, begin, length)
            elif op == _INDEX and found.pieces:
                _take_index(found, fields, source, begin)
                chunk = None
            elif op == _CONNECTION:
                _take_connection(found, fields, slice_of(path, source, begin, length))
            place = begin + length
    except (FileError, struct.error, KeyError, ValueError) as error:
        found.damage = f"is cut off or damaged at byte {place} of {len(source)}: {error}"
    for look in (lambda: _scan_if_open(path, found, chunk), lambda: _find_connections(path, found)):
        try:  # each by itself: a last chunk that is damaged leaves those before it with their topics
            look()
        except (FileError, struct.error, KeyError, ValueError) as error:
            found.damage = found.damage or f"has a damaged chunk: {error}"
    return found


def _record(path: Path, data: Any, place: int) -> tuple[int, dict[bytes, bytes], int, int]:
    """Operation, fields, and where the data of a record begin and how long they are."""
    head = number("I", data, place)
    header, fields, at = slice_of(path, data, place + 4, head), {}, 0
    while at < len(header):
        size = number("I", header, at)
        name, _, value = slice_of(path, header, at + 4, size).partition(b"=")
        fields[name] = value
        at += 4 + size
    begin = place + 8 + head
    length = number("I", data, place + 4 + head)
    if begin + length > len(data):
        raise FileError(path, f"a record of {length} bytes is cut off", where=f"byte {place}")
    return number("B", fields[b"op"], 0), fields, begin, length


def _add_chunk(path: Path, source: Any, found: Contents, fields: dict[bytes, bytes], begin: int, length: int) -> int:
    form, size = fields[b"compression"].decode("ascii", "replace"), number("I", fields[b"size"], 0)
    found.pieces.append(lambda: unpack(path, source[begin : begin + length], form, size))
    return len(found.pieces) - 1


def _take_connection(found: Contents, fields: dict[bytes, bytes], data: bytes) -> None:
    told, at = {}, 0
    while at < len(data):
        size = number("I", data, at)
        name, _, value = data[at + 4 : at + 4 + size].partition(b"=")
        told[name] = value
        at += 4 + size
    topic = fields[b"topic"].decode("utf-8", "replace")
    kind = told[b"type"].decode("ascii", "replace").replace("/", "/msg/", 1)
    found.channels[number("I", fields[b"conn"], 0)] = Channel(topic, kind, "ros1")


def _take_index(found: Contents, fields: dict[bytes, bytes], source: Any, begin: int) -> None:
    connection, count = number("I", fields[b"conn"], 0), number("I", fields[b"count"], 0)
    for seconds, nanoseconds, offset in struct.iter_unpack("<III", source[begin : begin + 12 * count]):
        found.entries.append((seconds * 10**9 + nanoseconds, connection, len(found.pieces) - 1, offset))


def _find_connections(path: Path, found: Contents) -> None:
    """Look for connections in chunks where the list of all at the end of the file is missing."""
    looked: set[int] = set()
    for _, channel, piece, _ in found.entries:
        if channel not in found.channels and piece not in looked:
            looked.add(piece)
            _scan(path, found, piece, messages=False)


def _scan_if_open(path: Path, found: Contents, chunk: int | None) -> None:
    """Look through a chunk that no index follows, as the last one of a recording that broke off."""
    if chunk is not None:
        _scan(path, found, chunk, messages=True)


def _scan(path: Path, found: Contents, chunk: int, *, messages: bool) -> None:
    """Take over the connections of a chunk, and its messages where they are not known."""
    data, place = found.pieces[chunk](), 0
    while place < len(data):
        op, fields, begin, length = _record(path, data, place)
        if op == _CONNECTION:
            _take_connection(found, fields, data[begin : begin + length])
        elif op == _MESSAGE and messages:
            seconds, nanoseconds = struct.unpack("<II", fields[b"time"])
            connection = number("I", fields[b"conn"], 0)
            found.entries.append((seconds * 10**9 + nanoseconds, connection, chunk, place))
        place = begin + length


def _payload(path: Path, data: bytes, place: int) -> bytes:
    _, _, begin, length = _record(path, data, place)
    return slice_of(path, data, begin, length)
