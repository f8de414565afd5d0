"""Common structure of recording containers: pieces of bytes and the position of each message.

A piece is a chunk or the whole file. The index (20 B a message) stays in memory. Only the last used chunks do.
"""

from __future__ import annotations

import bz2
import struct
from collections.abc import Callable, Container
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from ...core.errors import FileError
from ..optional_imports import foreign_errors, import_for

MAX_CHUNK = 1 << 31  # [B] unpacked. Writers start a new chunk at about 1 MB
_MAX_SMALL, _MAX_RATIO = 1 << 28, 1000  # [B] larger chunks are compressed by at most this ratio


class RecordingWarning(UserWarning):
    """A recording is truncated or damaged, or the times of its points have an unknown or unexpected unit.

    Example:
        >>> import warnings, pointloom as loom
        >>> from pointloom.io.bags.message_chunks import RecordingWarning
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", RecordingWarning)  # make it an error
    """


Row = tuple[int, int, int]  # of a message in a chunk: time [ns], channel, offset


@dataclass
class Chunk:
    """A chunk and its index: `begin` offset, `piece` index, content `size` [B], message `rows` and `channels`."""

    begin: int
    piece: int
    size: int
    rows: list[Row] = field(default_factory=list)
    channels: set[int] = field(default_factory=set)
    is_consistent: bool = True

    def is_plausible(self, channels: Container[int]) -> bool:
        """True if the index has entries that do not contradict each other, the size or the known channels."""
        offsets = {offset for _, _, offset in self.rows}
        is_complete = self.is_consistent and all(channel in channels for channel in self.channels)
        return is_complete and bool(offsets) and len(offsets) == len(self.rows) and max(offsets) < self.size

    def differs_from(self, rows: list[Row]) -> bool:
        """True if the index contradicts the messages of the chunk. A chunk without an index does not."""
        return not self.is_consistent or (bool(self.channels) and sorted(rows) != sorted(self.rows))


class Channel(NamedTuple):
    """Messages of one topic and type. Only the encodings "ros1" and "cdr" are decoded."""

    topic: str
    type: str
    encoding: str


@dataclass
class Contents:
    """The contents of one file: `channels` by id, and `entries` (time [ns], channel, piece, offset) of messages.
    `pieces` return bytes; `payload` is the message at an offset in a piece, checked against channel and time [ns]."""

    path: Path
    payload: Callable[[bytes, int, int, int], bytes]
    channels: dict[int, Channel] = field(default_factory=dict)
    entries: list[tuple[int, int, int, int]] = field(default_factory=list)
    pieces: list[Callable[[], bytes]] = field(default_factory=list)
    damage: str | None = None

    def note(self, damage: str) -> None:
        """Record damage. Only the first is reported."""
        self.damage = self.damage or damage

    def add_channel(self, key: int, channel: Channel) -> None:
        """Add a topic. A definition may be repeated but not changed."""
        if self.channels.setdefault(key, channel) != channel:
            self.note(f"defines topic number {key} twice: as {self.channels[key].topic!r} and {channel.topic!r}")


def unpack(path: Path, data: bytes, compression: str, size: int) -> bytes:
    """Decompress a chunk. Memory is bounded by its declared size, which is bounded by the compressed size."""
    if size > min(MAX_CHUNK, max(_MAX_SMALL, _MAX_RATIO * len(data))):
        reason = f"the header of a chunk of {len(data)} bytes claims {size} unpacked bytes"
        raise FileError(path, reason, remedy="The file is damaged there")
    if compression in ("", "none"):
        unpacked = bytes(data)
    elif compression in _DECOMPRESSORS:
        new = _DECOMPRESSORS[compression](path)
        with foreign_errors(path, f"a chunk compressed with {compression} is damaged"):
            unpacked = _unpack_bounded(new, bytes(data), size + 1)
    else:
        reason = f"has chunks compressed with {compression!r}"
        raise FileError(path, reason, remedy="Supported are none, lz4, zstd and bz2; compress it again")
    if len(unpacked) != size:
        size_text = f"more than {size}" if len(unpacked) > size else str(len(unpacked))
        raise FileError(path, f"a chunk is damaged: expected {size} unpacked bytes, got {size_text}")
    return unpacked


def _unpack_bounded(new: Callable[[], Any], data: bytes, limit: int) -> bytes:
    parts: list[bytes] = []
    while data and limit:
        stream, is_first = new(), True
        while limit and not stream.eof and (is_first or not stream.needs_input):
            parts.append(stream.decompress(data if is_first else b"", limit))
            limit, is_first = limit - len(parts[-1]), False
        if limit and not stream.eof:
            raise EOFError("the stream has no end")
        data = stream.unused_data or b""
    return b"".join(parts)


def _zstd(path: Path) -> Callable[[], Any]:
    try:
        return import_for(path, "compression.zstd", "ros").ZstdDecompressor  # Python 3.14
    except FileError:
        return import_for(path, "backports.zstd", "ros").ZstdDecompressor


_DECOMPRESSORS: dict[str, Callable[[Path], Callable[[], Any]]] = {
    "lz4": lambda path: import_for(path, "lz4.frame", "ros").LZ4FrameDecompressor,
    "bz2": lambda _: bz2.BZ2Decompressor,
    "zstd": _zstd,
}


def slice_of(path: Path, data: bytes, begin: int, length: int) -> bytes:
    if begin < 0 or length < 0 or begin + length > len(data):
        raise FileError(path, "a message reaches beyond its chunk", where=f"byte {begin}")
    return bytes(data[begin : begin + length])


def byte_order(data: bytes, encoding: str) -> str:
    """Byte order of a message: in the second byte for CDR, little-endian for ROS 1."""
    return ">" if encoding == "cdr" and data[1:2] == b"\0" else "<"


def number(form: str, data: bytes, begin: int) -> int:
    """Unpack a number; struct.error if the data end before it."""
    form = "<" + form
    return struct.unpack(form, data[begin : begin + struct.calcsize(form)])[0]
