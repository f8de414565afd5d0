"""What all containers of recorded messages come down to: pieces of bytes, and where each message stands in them.

A piece is a chunk of a file, compressed or not, or the file itself. The index (20 B a message) is held in memory, the
messages are not: of compressed chunks the last few that were used.
"""

from __future__ import annotations

import bz2
import struct
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from ...core.errors import FileError
from ..foreign import foreign_errors, import_for

MAX_CHUNK = 1 << 31  # [B] unpacked; writers start a new chunk at about 1 MB
_MAX_SMALL, _MAX_RATIO = 1 << 28, 1000  # larger chunks than that [B] are not packed more tightly than that


class RecordingWarning(UserWarning):
    """A recording that is cut off or damaged, and read up to there; or one whose clouds have times of points in no
    unit, or in another than their driver's.

    Example:
        >>> import warnings, pointloom as loom
        >>> from pointloom.files.bags.pieces import RecordingWarning
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", RecordingWarning)  # make it an error
    """


Row = tuple[int, int, int]  # of a message in a chunk: time [ns], channel, place


@dataclass
class Chunk:
    """A chunk, and the index behind it.

    Attributes:
        begin: Its first byte in the file.
        piece: Its number among the pieces.
        size: Of its content [B].
        rows, channels: The messages of the index, and their channels.
        is_consistent: True if the index does not contradict itself.
    """

    begin: int
    piece: int
    size: int
    rows: list[Row] = field(default_factory=list)
    channels: set[int] = field(default_factory=set)
    is_consistent: bool = True


class Channel(NamedTuple):
    """Messages of one topic and one type.

    Attributes:
        topic: Its name.
        type: Of the messages, such as "sensor_msgs/msg/PointCloud2".
        encoding: "ros1" or "cdr"; others are listed and not read.
    """

    topic: str
    type: str
    encoding: str


@dataclass
class Contents:
    """What was found in one file.

    Attributes:
        path: The file.
        channels: By the file's own numbers.
        entries: Of each message its time [ns], channel, piece and place in that.
        pieces: Each gives its bytes.
        payload: The message at a place in a piece, whose channel and time [ns] must be those of its entry.
        damage: What is missing or contradictory in the file, or None.
    """

    path: Path
    payload: Callable[[bytes, int, int, int], bytes]
    channels: dict[int, Channel] = field(default_factory=dict)
    entries: list[tuple[int, int, int, int]] = field(default_factory=list)
    pieces: list[Callable[[], bytes]] = field(default_factory=list)
    damage: str | None = None

    def note(self, damage: str) -> None:
        """Record damage; of several kinds the first is reported."""
        self.damage = self.damage or damage

    def add_channel(self, key: int, channel: Channel) -> None:
        """Add a topic. A file may repeat a definition, but not change it."""
        if self.channels.setdefault(key, channel) != channel:
            self.note(f"defines topic number {key} twice: as {self.channels[key].topic!r} and {channel.topic!r}")


def unpack(path: Path, data: bytes, compression: str, size: int) -> bytes:
    """The bytes of a chunk. Memory is bounded by the size in its header, and that by the size of the packed bytes.

    Raises:
        FileError: An unknown compression, a missing package, bytes that are no such stream or of another length.
    """
    if size > min(MAX_CHUNK, max(_MAX_SMALL, _MAX_RATIO * len(data))):
        reason = f"the header of a chunk of {len(data)} bytes claims {size} unpacked bytes"
        raise FileError(path, reason, remedy="The file is damaged there")
    if compression in ("", "none"):
        unpacked = bytes(data)
    elif compression in _DECOMPRESSORS:
        new = _DECOMPRESSORS[compression](path)
        with foreign_errors(path, f"a chunk that is packed by {compression} is damaged"):
            unpacked = _unpack_bounded(new, bytes(data), size + 1)
    else:
        reason = f"has chunks packed by {compression!r}"
        raise FileError(path, reason, remedy="Known are none, lz4, zstd and bz2; pack it again")
    if len(unpacked) != size:
        found = f"more than {size}" if len(unpacked) > size else str(len(unpacked))
        raise FileError(path, f"a chunk is damaged: expected {size} unpacked bytes, got {found}")
    return unpacked


def _unpack_bounded(new: Callable[[], Any], data: bytes, limit: int) -> bytes:
    """Up to `limit` unpacked bytes of one or more streams."""
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
    """Some bytes, all of which are there.

    Raises:
        FileError: They reach beyond the end.
    """
    if begin < 0 or length < 0 or begin + length > len(data):
        raise FileError(path, "a message reaches beyond its chunk", where=f"byte {begin}")
    return bytes(data[begin : begin + length])


def byte_order(data: bytes, encoding: str) -> str:
    """Of the numbers of a message: CDR tells it in its second byte, ROS 1 has the least first."""
    return ">" if encoding == "cdr" and data[1:2] == b"\0" else "<"


def number(form: str, data: bytes, begin: int) -> int:
    """A number at a place; struct.error where the bytes end before."""
    return struct.unpack_from("<" + form, data, begin)[0]
