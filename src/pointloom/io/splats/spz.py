"""Read SPZ splats: versions 2 and 3 (one gzip stream) and 4 (a Zstandard stream per column). Axes right, up, back.

Centers are 24-bit multiples of 2^-fractionalBits, other columns 8-bit. A rotation has 3 bytes in version 2, else 4:
index of the largest of x, y, z, w, and 10 bits for each other. nianticlabs/spz, README.
"""

from __future__ import annotations

import struct
import zlib
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ...pcd.harmonics import MAX_DEGREE, signs_of_flip
from ...pcd.splats import logits_of
from ..optional_imports import foreign_errors, import_for
from ..source import Source, open_source
from ..table import PointTable

SPZ_MAGIC = 0x5053474E
HEADER = struct.Struct("<IIIBBBB")
COLOR_SCALE = 0.15  # fraction of the byte range per unit of f_dc
AXIS_SIGNS = (1, -1, -1)  # from right, up, back to right, down, forward, and back
HAS_EXTENSIONS = 2  # a flag
_FREE_BYTES, _MAX_RATIO = 1 << 28, 1000  # limit of unpacked columns, whose number is in the header
_ENTRY = struct.Struct("<QQ")


class SpzHeader(NamedTuple):
    """The first 16 bytes."""

    magic: int
    version: int
    splats: int
    degree: int
    fractional_bits: int
    flags: int
    streams: int  # of version 4

    @property
    def columns(self) -> dict[str, int]:
        rotation_bytes = 3 if self.version == 2 else 4
        rest = 3 * ((self.degree + 1) ** 2 - 1)
        sizes = {"points": 9, "opacity": 1, "f_dc": 3, "scale": 3, "rot": rotation_bytes, "f_rest": rest}
        return {name: size for name, size in sizes.items() if size}


def read_spz(path: FilePath) -> PointTable:
    """Read splats as columns `f_dc`, `f_rest`, `opacity`, `scale`, `rot`, in PLY axes."""
    path = Path(path)
    source = open_source(path)
    header, data = _of_gzip(path, source) if source[:2] == b"\x1f\x8b" else _of_streams(path, source)
    return PointTable(_points(header, data["points"]), attributes=_attributes(header, data))


def _check(path: Path, header: SpzHeader, versions: tuple[int, ...]) -> None:
    if header.magic != SPZ_MAGIC:
        raise FileError(path, "does not begin with the magic number of SPZ", where="byte 0")
    if header.version not in versions:
        raise FileError(
            path, f"is SPZ of version {header.version}", where="byte 4", remedy="Supported are versions 2 to 4"
        )
    if header.degree > MAX_DEGREE:
        raise FileError(path, f"harmonics of degree {header.degree}, expected 0 to {MAX_DEGREE}", where="byte 12")
    if header.fractional_bits > 23:
        raise FileError(path, f"{header.fractional_bits} fractional bits of 24", where="byte 13")


def _of_gzip(path: Path, source: Source) -> tuple[SpzHeader, dict[str, NDArray[np.uint8]]]:
    stream = zlib.decompressobj(wbits=31)
    with foreign_errors(path, "gzip"):
        head = stream.decompress(source[:], HEADER.size)
    if len(head) < HEADER.size:
        raise FileError(path, f"ends after {len(head)} bytes of a header of {HEADER.size}")
    header = SpzHeader(*HEADER.unpack(head))
    _check(path, header, (2, 3))
    size = header.splats * sum(header.columns.values())
    # gzip's ratio is at most 1032, which bounds the memory of a false count
    if size > 1032 * len(source):
        raise FileError(path, f"{header.splats:,} splats cannot fit into {len(source):,} bytes", where="byte 8")
    with foreign_errors(path, "gzip"):
        body = stream.decompress(stream.unconsumed_tail, size + 1)
    if len(body) < size:
        raise FileError(path, f"ends after {len(body):,} of {size:,} bytes of splats", remedy="The file is cut off")
    if not header.flags & HAS_EXTENSIONS:
        if len(body) > size:
            raise FileError(path, f"continues after its {header.splats:,} splats", where=f"byte {HEADER.size + size}")
        if not stream.eof and (stream.decompress(stream.unconsumed_tail, 1) or not stream.eof):
            raise FileError(path, "ends before gzip's checksum", remedy="The file is cut off")
    data, start = {}, 0
    for name, width in header.columns.items():
        data[name] = np.frombuffer(body, np.uint8, header.splats * width, start)
        start += header.splats * width
    return header, data


def _of_streams(path: Path, source: Source) -> tuple[SpzHeader, dict[str, NDArray[np.uint8]]]:
    if len(source) < 32:
        raise FileError(path, f"has {len(source)} bytes, fewer than the header of SPZ", where="byte 0")
    header = SpzHeader(*HEADER.unpack(source[: HEADER.size]))
    _check(path, header, (4,))
    (table_offset,) = struct.unpack("<I", source[16:20])
    if header.streams != len(header.columns):
        raise FileError(path, f"{header.streams} streams, expected {len(header.columns)}", where="byte 15")
    start = table_offset + header.streams * _ENTRY.size
    if table_offset < 32 or start > len(source):
        raise FileError(path, f"a table at byte {table_offset} of {len(source)}", where="byte 16")
    total = header.splats * sum(header.columns.values())
    if total > max(_FREE_BYTES, _MAX_RATIO * len(source)):  # positions alone do not compress that well
        raise FileError(path, f"{header.splats:,} splats cannot fit into {len(source):,} bytes", where="byte 8")
    data = {}
    for number, (name, width) in enumerate(header.columns.items()):
        entry = table_offset + number * _ENTRY.size
        packed, size = _ENTRY.unpack(source[entry : entry + _ENTRY.size])
        where = f"byte {start}"
        if size != header.splats * width:
            reason = f"the stream of {name} has {size:,} bytes, expected {header.splats * width:,}"
            raise FileError(path, reason, where=where)
        if start + packed > len(source):
            raise FileError(path, f"the stream of {name} reaches beyond the file", where=where)
        data[name] = _unzstd(path, source[start : start + packed], size, where)
        start += packed
    if start != len(source):
        raise FileError(
            path, f"continues after its last stream, by {len(source) - start:,} bytes", where=f"byte {start}"
        )
    return header, data


def _unzstd(path: Path, packed: bytes, size: int, where: str) -> NDArray[np.uint8]:
    if not size:
        return np.empty(0, np.uint8)
    zstandard = import_for(path, "zstandard", "splats")
    with foreign_errors(path, f"the stream at {where}"):
        declared_size = zstandard.frame_content_size(packed)
        if declared_size not in (-1, size):
            raise FileError(path, f"a stream of {declared_size:,} bytes, expected {size:,}", where=where)
        body = zstandard.ZstdDecompressor().decompress(packed, max_output_size=size, allow_extra_data=False)
    if len(body) != size:
        raise FileError(path, f"a stream of {len(body):,} bytes, expected {size:,}", where=where)
    return np.frombuffer(body, np.uint8)


def _points(header: SpzHeader, data: NDArray[np.uint8]) -> NDArray[np.float32]:
    parts = data.reshape(-1, 3).astype(np.int32)
    integers = parts[:, 0] | parts[:, 1] << 8 | parts[:, 2] << 16
    integers -= (integers >> 23) << 24  # sign bit
    return (integers.reshape(-1, 3) / 2.0**header.fractional_bits * AXIS_SIGNS).astype(np.float32)


def _attributes(header: SpzHeader, data: dict[str, NDArray[np.uint8]]) -> dict[str, NDArray[Any]]:
    decode_rotations = _three_bytes if header.version == 2 else _smallest_three
    flips = np.array([1.0, *AXIS_SIGNS])  # a rotation by half a circle about x on both sides
    attributes: dict[str, NDArray[Any]] = {
        "f_dc": ((data["f_dc"].reshape(-1, 3) / 255 - 0.5) / COLOR_SCALE).astype(np.float32),
        "opacity": logits_of(data["opacity"] / 255),
        "scale": (data["scale"].reshape(-1, 3) / 16.0 - 10).astype(np.float32),
        "rot": (decode_rotations(data["rot"]) * flips).astype(np.float32),
    }
    if header.degree:
        rest = (data["f_rest"].reshape(header.splats, -1, 3).astype(np.float32) - 128) / 128
        rest *= signs_of_flip(AXIS_SIGNS, header.degree).astype(np.float32)[:, None]
        attributes["f_rest"] = np.ascontiguousarray(rest.transpose(0, 2, 1)).reshape(header.splats, -1)
    return attributes


def _three_bytes(data: NDArray[np.uint8]) -> NDArray[np.float64]:
    """Quaternions (w, x, y, z) of version 2, which stores x, y, z."""
    xyz = data.reshape(-1, 3) / 127.5 - 1
    return np.column_stack([np.sqrt(np.maximum(0, 1 - np.square(xyz).sum(axis=1))), xyz])


def _smallest_three(data: NDArray[np.uint8]) -> NDArray[np.float64]:
    """Quaternions (w, x, y, z) from the three components other than the largest."""
    packed = data.view("<u4").astype(np.int64)
    largest = packed >> 30
    parts = np.zeros((len(packed), 4))
    for part in (3, 2, 1, 0):
        given = np.flatnonzero(largest != part)
        bits = packed[given]
        size = (bits & 511) / 511 * np.sqrt(0.5)
        parts[given, part] = np.where(bits >> 9 & 1, -size, size)
        packed[given] = bits >> 10
    rest = np.sqrt(np.maximum(0, 1 - np.square(parts).sum(axis=1)))
    parts[np.arange(len(parts)), largest] = rest
    return np.roll(parts, 1, axis=1)
