"""LAZ decompression with lazrs, block by block, after validating the tables.

lazrs allocates the sizes in the tables and aborts the process if that fails, so they are checked first. Chunks that
claim very many points are unpacked point by point. Isenburg, "LASzip: lossless compression of LiDAR data" (2013).
LASzip 3.
"""

from __future__ import annotations

import itertools
import struct
from collections.abc import Iterator
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ..optional_imports import foreign_errors, import_for
from ..source import Source, SourceFile
from .las_header import LasHeader

LASZIP_RECORD = ("laszip encoded", 22204)
_FIELDS = struct.Struct("<HHBBHIIqqH")
_CHUNK_SIZE_AT = 12
_ITEM = struct.Struct("<HHH")
_VARIABLE_CHUNKS = 0xFFFFFFFF  # chunk size meaning that the table has the size of each chunk
_POINTWISE_COMPRESSOR, _LAYERED_COMPRESSOR = 2, 3  # the compressors that lazrs supports

# Unpacked bytes up to which several chunks are unpacked at a time: 40 times those of the usual 50,000 points.
_PARALLEL_CHUNK_BYTES = 1 << 26

# Bytes and layers of an item in a layered chunk. None for variable length (extra bytes).
_LAYERED_ITEMS = {
    0: (None, 0), 6: (20, 0), 7: (8, 0), 8: (6, 0), 9: (29, 0),
    10: (30, 9), 11: (6, 1), 12: (8, 2), 13: (29, 1), 14: (None, None),
}  # fmt: skip


def unpack_blocks(source: SourceFile, header: LasHeader, size: int) -> Iterator[bytearray]:
    """Decompress at most `size` points at a time, after `check_laszip`."""
    if not header.point_count:
        return
    path, lazrs = source.path, import_for(source.path, "lazrs", "las")
    with source.reopen() as file, source.errors(), foreign_errors(path, "the compressed points are damaged"):
        file.seek(header.begin)
        record = _lower_chunk_size(header)
        chunks = lazrs.read_chunk_table(file, lazrs.LazVlr(record))
        is_small = max(points for points, _ in chunks) * header.record_length <= _PARALLEL_CHUNK_BYTES
        file.seek(header.begin)
        decompressor = (lazrs.ParLasZipDecompressor if is_small else lazrs.LasZipDecompressor)(file, record)
        for begin in range(0, header.point_count, size):
            block = bytearray(min(size, header.point_count - begin) * header.record_length)
            decompressor.decompress_many(block)
            source.check_unchanged()
            yield block


def unpack_beginnings(source: SourceFile, header: LasHeader, count: int) -> bytearray:
    """The first points of evenly spaced chunks (no random access), at most `count`, after `check_laszip`."""
    rows = bytearray()
    if not header.point_count:
        return rows
    path, lazrs = source.path, import_for(source.path, "lazrs", "las")
    with source.reopen() as file, source.errors(), foreign_errors(path, "the compressed points are damaged"):
        file.seek(header.begin)
        record = _lower_chunk_size(header)
        sizes = [points for points, _ in lazrs.read_chunk_table(file, lazrs.LazVlr(record))]
        ends = [min(end, header.point_count) for end in itertools.accumulate(sizes)]
        begins = [0, *ends[:-1]]
        step = -(-len(sizes) // count)
        fraction = count // len(begins[::step])
        file.seek(header.begin)
        decompressor = lazrs.LasZipDecompressor(file, record)
        for begin, end in zip(begins[::step], ends[::step], strict=True):
            decompressor.seek(begin)
            block = bytearray(min(fraction, end - begin) * header.record_length)
            decompressor.decompress_many(block)
            rows += block
        source.check_unchanged()
    return rows


def chunks_at(path: FilePath, file: IO[bytes], begin: int, record: bytes) -> NDArray[np.int64]:
    """First byte, points and bytes of each chunk, (m, 3), of a validated file with compressed points at `begin`."""
    lazrs = import_for(path, "lazrs", "las")
    with foreign_errors(path, "the table of chunks is damaged"):
        file.seek(begin)
        chunks = np.array(lazrs.read_chunk_table(file, lazrs.LazVlr(record)), np.int64)
    points, sizes = chunks.reshape(-1, 2).T
    ends = np.cumsum(sizes) + begin + 8  # after the offset of the table
    return np.column_stack([ends - sizes, points, sizes])


def _lower_chunk_size(header: LasHeader) -> bytes:
    """The LASzip record. For one chunk, its size is limited to the point count, since lazrs allocates it."""
    record = bytearray(header.find(*LASZIP_RECORD) or b"")
    (chunk_size,) = struct.unpack_from("<I", record, _CHUNK_SIZE_AT)
    if chunk_size != _VARIABLE_CHUNKS:
        struct.pack_into("<I", record, _CHUNK_SIZE_AT, min(chunk_size, header.point_count))
    return bytes(record)


def check_laszip(path: FilePath, source: SourceFile, header: LasHeader, *, layers_too: bool = True) -> None:
    """Check the LASzip record, chunk table and, if `layers_too`, chunk layers (else use `check_chunk` later)."""
    lazrs = import_for(path, "lazrs", "las")
    record = header.find(*LASZIP_RECORD)
    if record is None:
        raise FileError(path, "its points are compressed, but there is no LASzip record", where="byte 100")
    compressor, chunk_size, layers = _check_record(path, record, header)
    if header.point_count:
        with foreign_errors(path, "the table of chunks is damaged"):
            chunks = _read_chunk_table(path, source, header, record, chunk_size, lazrs)
            if compressor == _LAYERED_COMPRESSOR and layers_too:
                _check_layers(path, source, header, chunks, layers)


def check_chunk(path: FilePath, header: LasHeader, chunk: bytes, what: str) -> None:
    """Raise `FileError` if the layers of one chunk exceed its bytes."""
    compressor, _, layers = _check_record(path, header.find(*LASZIP_RECORD) or b"", header)
    if compressor == _LAYERED_COMPRESSOR and not _fits(chunk, 0, len(chunk), header.record_length + 4, layers):
        raise FileError(path, f"{what}, is damaged: its layers do not fit into its {len(chunk)} bytes")


def _check_record(path: FilePath, record: bytes, header: LasHeader) -> tuple[int, int, int]:
    if len(record) < _FIELDS.size:
        raise FileError(path, f"the LASzip record has {len(record)} bytes, at least {_FIELDS.size} are needed")
    fields = _FIELDS.unpack_from(record)
    compressor, chunk_size, item_count = fields[0], fields[6], fields[9]
    if compressor not in (_POINTWISE_COMPRESSOR, _LAYERED_COMPRESSOR):
        remedy = "Unpack it with the program that wrote it"
        raise FileError(path, f"LASzip's compressor {compressor} is not supported", remedy=remedy)
    if len(record) < _FIELDS.size + item_count * _ITEM.size or not chunk_size:
        raise FileError(path, f"the LASzip record is damaged: {item_count} items, chunks of {chunk_size} points")
    items = [_ITEM.unpack_from(record, _FIELDS.size + k * _ITEM.size)[:2] for k in range(item_count)]
    if any(kind not in _LAYERED_ITEMS or _LAYERED_ITEMS[kind][0] not in (None, size) for kind, size in items):
        raise FileError(path, f"the LASzip record is damaged: items (type, bytes) {items}")
    if sum(size for _, size in items) != header.record_length:
        reason = f"LASzip's points have {sum(size for _, size in items)} bytes, the header's {header.record_length}"
        raise FileError(path, reason)
    layers = [_LAYERED_ITEMS[kind][1] for kind, _ in items]
    return compressor, chunk_size, sum(size if n is None else n for n, (_, size) in zip(layers, items, strict=True))


def _read_chunk_table(
    path: FilePath, source: SourceFile, header: LasHeader, record: bytes, chunk_size: int, lazrs: Any
) -> list[tuple[int, int]]:
    """(Points, bytes) of each chunk. Points are the chunk size if it is constant."""
    first = header.begin + 8
    if len(source) < first + 8:
        raise FileError(path, "truncated: no compressed points follow the header", where=f"byte {len(source)}")
    (table,) = struct.unpack("<q", source[header.begin : first])
    if table == -1:  # written by streaming writers. The last bytes of the file are the offset
        (table,) = struct.unpack("<q", source[-8:])
    if not first <= table <= len(source) - 8:
        reason = f"truncated or damaged: the table of chunks should be at byte {table} of {len(source)}"
        raise FileError(path, reason, where=f"byte {header.begin}")
    version, count = struct.unpack("<II", source[table : table + 8])
    if version or count > (table - first) // header.record_length:  # each chunk starts with an uncompressed point
        reason = f"the table of chunks is damaged: version {version}, {count} chunks in {table - first} bytes"
        raise FileError(path, reason, where=f"byte {table}")
    if chunk_size != _VARIABLE_CHUNKS and not (count - 1) * chunk_size <= header.point_count <= count * chunk_size:
        reason = f"the header counts {header.point_count} points, the table {count} chunks of {chunk_size}"
        raise FileError(path, reason, where=f"byte {table}")
    with source.reopen() as file:
        file.seek(header.begin)
        chunks = lazrs.read_chunk_table(file, lazrs.LazVlr(record))
    if not chunks:
        raise FileError(path, "the table of chunks is empty, but there are points", where=f"byte {table}")
    if min(size for _, size in chunks) < header.record_length or sum(size for _, size in chunks) > table - first:
        raise FileError(path, f"the chunks do not fit into the {table - first} bytes before", where=f"byte {table}")
    if chunk_size == _VARIABLE_CHUNKS and sum(points for points, _ in chunks) != header.point_count:
        chunk_points = sum(points for points, _ in chunks)
        raise FileError(
            path, f"the header counts {header.point_count} points, its chunks {chunk_points}", where="byte 107"
        )
    return chunks


def _check_layers(
    path: FilePath, source: SourceFile, header: LasHeader, chunks: list[tuple[int, int]], layers: int
) -> None:
    """Check the layer sizes of each chunk, which follow its first point and count."""
    at, prefix = header.begin + 8, header.record_length + 4
    for number, (_, length) in enumerate(chunks):
        if not _fits(source, at, length, prefix, layers):
            raise FileError(
                path, f"the layers of chunk {number} do not fit into its {length} bytes", where=f"byte {at}"
            )
        at += length


def _fits(source: Source, at: int, length: int, prefix: int, layers: int) -> bool:
    sizes = struct.Struct(f"<{layers}I")
    if length < prefix + sizes.size:
        return False
    return prefix + sizes.size + sum(sizes.unpack(source[at + prefix : at + prefix + sizes.size])) <= length
