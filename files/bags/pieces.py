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
from typing import NamedTuple

from ...core.errors import FileError
from ..foreign import foreign_errors, import_for

MOST_CHUNK = 1 << 31  # [B] a chunk that says more when unpacked is damaged: writers part at 1 MB or so


class RecordingWarning(UserWarning):
    """A recording that is cut off or damaged, and read up to there; or one whose clouds have times of points in no
    unit, or in another than their driver's.

    Example:
        >>> import warnings, pointloom as loom
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", loom.RecordingWarning)  # make it an error
    """


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
        payload: The message at a place in a piece.
        damage: What ends the file before its time, or None.
    """

    path: Path
    payload: Callable[[bytes, int], bytes]
    channels: dict[int, Channel] = field(default_factory=dict)
    entries: list[tuple[int, int, int, int]] = field(default_factory=list)
    pieces: list[Callable[[], bytes]] = field(default_factory=list)
    damage: str | None = None


def unpack(path: Path, data: bytes, compression: str, size: int) -> bytes:
    """The bytes of a chunk.

    Raises:
        FileError: An unknown compression, a missing package, bytes that are no such stream or of another length.
    """
    if size > MOST_CHUNK:
        raise FileError(path, f"a chunk says that it holds {size} bytes", remedy="The file is damaged there")
    with foreign_errors(path, f"a chunk that is packed by {compression or 'nothing'} is damaged"):
        if compression in ("", "none"):
            unpacked = bytes(data)
        elif compression == "lz4":
            unpacked = import_for(path, "lz4.frame", "ros").decompress(data)
        elif compression == "bz2":
            unpacked = bz2.decompress(data)
        elif compression == "zstd":
            unpacked = _unzstd(path, data, size)
        else:
            reason = f"has chunks packed by {compression!r}"
            raise FileError(path, reason, remedy="Known are none, lz4, zstd and bz2; pack it again")
    if len(unpacked) != size:
        raise FileError(path, f"a chunk is cut off: {len(unpacked)} bytes of {size}")
    return unpacked


def _unzstd(path: Path, data: bytes, size: int) -> bytes:
    try:
        return import_for(path, "compression.zstd", "ros").decompress(data)  # Python 3.14
    except FileError:
        pass
    return import_for(path, "backports.zstd", "ros").decompress(data)


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
