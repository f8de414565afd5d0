"""Buckets: rows of a file without windows, sorted into tiles on disk in one pass, compressed.

A file's folder appears when complete. Each tile's file has blocks of uncompressed LAS rows, packed by LASzip if the
format and count allow, row numbers, and the covered area, so that halos read few blocks.
"""

from __future__ import annotations

import io
import json
import shutil
import struct
import zlib
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import part_folder
from ..core.errors import FileError
from ..io.optional_imports import foreign_errors, import_for
from ..io.points.las import COLORS, LasFile, open_las
from ..io.points.npz import MAX_DEFLATE_RATIO
from .manifest import DAMAGE, is_dead
from .plan_check import TilePlan

FOLDER, INDEX = "buckets", "index.json"
MAX_ROWS = 1 << 22  # rows in memory before a flush
MAX_BYTES = 1 << 28
_ROWS_PER_READ = 1 << 18  # rows unpacked at a time
_CELL_ROWS = 16384  # rows from which a block is divided into cells
_MAX_CELLS = 4  # along a side
_BLOCK = struct.Struct("<4sIIII4dI")  # magic, rows, bytes of rows, bytes of numbers, packing, box, checksum
_MARK = b"LOOM"
_ZLIB_CODEC, _LASZIP_CODEC = 0, 1
Window = tuple[float, float, float, float]  # low x, low y, high x, high y. Low ends inclusive

_ANEW = "Remove {} and call retry_tiles(folder)"
REMOTE = "remote-"  # prefix of workers without a local lock. Their leftovers are removed at the end
_LASZIP_FORMATS = (0, 1, 2, 3, 6, 7, 8)
_LASZIP_ROWS = 500  # from which LASzip compresses better than zlib. Its start takes 0.5 ms


class Filled(NamedTuple):
    """Result of a pass: rows, full color value, bytes on disk, rows by tile."""

    points: int
    full: int
    size: int
    tiles: dict[int, int]


def folder_of(folder: Path, number: int) -> Path:
    return folder / FOLDER / f"{number:06d}"


def fill_buckets(plan: TilePlan, folder: Path, number: int, owner: str) -> Filled:
    """Sort the rows of a file into tiles. Removes unfinished data of dead workers. An existing folder is complete and
    kept, since a worker may still read it. Raises FileError if the file is damaged, has points outside its header's
    bounds, or the disk is full."""
    source, done = plan.files[number], folder_of(folder, number)
    if (done / INDEX).is_file():
        return _filled(done)
    file = open_las(source["path"])
    part = done.with_name(f"{done.name}.{owner}.part")
    for old in done.parent.glob(f"{done.name}.*.part"):
        other = old.name.split(".")[1]
        if not other.startswith(REMOTE) and is_dead(folder, other):
            shutil.rmtree(old, ignore_errors=True)
    with part_folder(part):
        filled = _fill(plan, file, part)
        index = filled._asdict() | {"tiles": {str(tile): rows for tile, rows in sorted(filled.tiles.items())}}
        (part / INDEX).write_text(json.dumps(index), encoding="utf-8")
        try:
            part.rename(done)
        except OSError:
            if not (done / INDEX).is_file():  # else another worker finished the same rows
                raise
    return filled


def _filled(done: Path) -> Filled:
    try:
        index = json.loads((done / INDEX).read_text(encoding="utf-8"))
        return Filled(**index | {"tiles": {int(tile): rows for tile, rows in index["tiles"].items()}})
    except (OSError, *DAMAGE) as error:
        raise FileError(done / INDEX, f"cannot be read: {error}", remedy=_ANEW.format(done)) from error


def _fill(plan: TilePlan, file: LasFile, part: Path) -> Filled:
    pending: dict[int, list[tuple[Any, NDArray[np.uint64]]]] = {}
    sizes: dict[int, int] = {}
    tiles: dict[int, int] = {}
    writer = _Writer(plan, file, part)
    max_rows = min(MAX_ROWS, MAX_BYTES // (file.header.record_length + 8))
    begin = brightest = 0
    for rows in file.rows(_ROWS_PER_READ):
        positions = _checked_positions(plan, file, rows, begin)
        owners = plan.tile_of(positions)
        order = np.argsort(owners, kind="stable")
        cuts = np.flatnonzero(np.diff(owners[order], prepend=-1))
        for chosen in np.split(order, cuts[1:]) if len(order) else []:
            tile = int(owners[chosen[0]])
            pending.setdefault(tile, []).append((rows[chosen], (chosen + begin).astype(np.uint64)))
            sizes[tile] = sizes.get(tile, 0) + len(chosen)
            tiles[tile] = tiles.get(tile, 0) + len(chosen)
        if COLORS[0] in (rows.dtype.names or ()):
            brightest = max(brightest, *(int(rows[name].max(initial=0)) for name in COLORS))
        begin += len(rows)
        if sum(sizes.values()) > max_rows:
            for tile in sorted(sizes, key=lambda tile: -sizes[tile]):
                if sum(sizes.values()) <= max_rows // 2:
                    break
                writer.write(tile, pending.pop(tile))
                del sizes[tile]
    for tile in sorted(pending):
        writer.write(tile, pending[tile])
    if begin != file.header.point_count:
        raise FileError(file.path, f"the header counts {file.header.point_count} points, the file contains {begin}")
    return Filled(begin, 255 if brightest <= 255 else 65535, writer.size, tiles)


def _checked_positions(plan: TilePlan, file: LasFile, rows: Any, begin: int) -> NDArray[np.float64]:
    """x and y of rows, checked to be in the header's box up to rounding."""
    low, high = file.header.bounds
    positions = positions_of(file, rows, "XYZ")
    slack = plan.slack + np.array(file.header.scales)
    beyond = ((positions < low - slack) | (positions > high + slack)).any(axis=1)
    if beyond.any():
        row = int(np.flatnonzero(beyond)[0])
        reason = f"the point at {positions[row].tolist()} is outside the bounds of the header, {[*low]}..{[*high]}"
        raise FileError(
            file.path, reason, where=f"point {begin + row}", remedy="Write the file again with correct bounds"
        )
    return positions[:, :2]


class _Writer:
    """Appends blocks to the files of tiles."""

    def __init__(self, plan: TilePlan, file: LasFile, part: Path):
        self._plan, self._file, self._part, self.size = plan, file, part, 0

    def write(self, tile: int, pieces: list[tuple[Any, NDArray[np.uint64]]]) -> None:
        rows = np.concatenate([rows for rows, _ in pieces])
        numbers = np.concatenate([numbers for _, numbers in pieces])
        positions = positions_of(self._file, rows)
        cells = min(_MAX_CELLS, int((len(rows) / _CELL_ROWS) ** 0.5)) or 1
        low, extent = positions.min(axis=0), np.ptp(positions, axis=0)
        cell = np.floor((positions - low) / np.where(extent > 0, extent, 1.0) * cells).clip(0, cells - 1)
        which = (cell[:, 0] * cells + cell[:, 1]).astype(np.int64)
        with (self._part / f"{tile}.blocks").open("ab") as stream:
            for k in np.unique(which).tolist():
                mine = np.flatnonzero(which == k)
                self.size += stream.write(_packed(self._file, rows[mine], numbers[mine], positions[mine]))


def positions_of(file: LasFile, rows: NDArray[Any], axes: str = "XY") -> NDArray[np.float64]:
    """Coordinates of rows, bitwise as decoding gives them."""
    scales, offsets = file.header.scales, file.header.offsets
    return np.column_stack([rows[name] * scales[k] + offsets[k] for k, name in enumerate(axes)])


def check_size(plan: TilePlan, count: int) -> None:
    """Raise ValueError if a tile with halo has more points than the plan allows."""
    if count > plan.max_points:
        reason = f"expected at most {plan.max_points:,} points in a tile and its halo, got at least {count:,}"
        raise ValueError(f"size: {reason}. Plan smaller tiles, or remove outlying points first")


def inside(positions: NDArray[np.float64], window: Window) -> NDArray[np.bool_]:
    x, y = positions[:, 0], positions[:, 1]
    return (x >= window[0]) & (y >= window[1]) & (x < window[2]) & (y < window[3])


def _lazrs_record(file: LasFile) -> Any:
    """lazrs's description of the row format. None if unsupported."""
    if file.header.point_format not in _LASZIP_FORMATS:
        return None
    lazrs = import_for("buckets.laz", "lazrs", "las")
    return lazrs.LazVlr.new_for_compression(
        file.header.point_format, file.layout.num_extra_bytes, use_variable_size_chunks=True
    )


def _packed(file: LasFile, rows: Any, numbers: NDArray[np.uint64], positions: NDArray[np.float64]) -> bytes:
    record = _lazrs_record(file) if len(rows) >= _LASZIP_ROWS else None
    if record is None:
        how, body = _ZLIB_CODEC, zlib.compress(rows.tobytes(), 1)
    else:
        lazrs = import_for("buckets.laz", "lazrs", "las")
        stream = io.BytesIO()
        with foreign_errors(file.path, "its points cannot be compressed"):
            compressor = lazrs.LasZipCompressor(stream, record)
            compressor.compress_many(rows.tobytes())
            compressor.done()
        how, body = _LASZIP_CODEC, stream.getvalue()
    steps = np.diff(numbers, prepend=np.uint64(0))  # ascending
    packed_numbers = zlib.compress(np.ascontiguousarray(steps.view(np.uint8).reshape(-1, 8).T).tobytes(), 1)
    box = (*positions.min(axis=0), *positions.max(axis=0))
    head = _BLOCK.pack(
        _MARK, len(rows), len(body), len(packed_numbers), how, *box, zlib.crc32(packed_numbers, zlib.crc32(body))
    )
    return head + body + packed_numbers


def read_buckets(
    plan: TilePlan, folder: Path, number: int, file: LasFile, window: Any
) -> tuple[NDArray[Any], NDArray[np.int64]]:
    """Rows of a file in a window in file order, and their numbers. FileError if a bucket is damaged."""
    bucket = folder_of(folder, number)
    counts = _index_of(bucket, _time_of(bucket))
    rows, numbers = [], []
    for tile in plan.tiles_in(window):
        if tile not in counts:
            continue
        path = bucket / f"{tile}.blocks"
        blocks, size = _read_blocks(path, file, window)
        if size != counts[tile]:
            raise FileError(
                path, f"expected {counts[tile]} points as in the index, got {size}", remedy=_ANEW.format(bucket)
            )
        for block, which in blocks:
            rows.append(block)
            numbers.append(which)
        check_size(plan, sum(map(len, rows)))
    if not rows:
        return np.empty(0, file.layout.dtype()), np.empty(0, np.int64)
    joined, row_numbers = np.concatenate(rows), np.concatenate(numbers).astype(np.int64)
    order = np.argsort(row_numbers, kind="stable")
    return joined[order], row_numbers[order]


def _time_of(bucket: Path) -> int:
    try:
        return (bucket / INDEX).stat().st_mtime_ns
    except OSError as error:
        reason = f"cannot be read: {error.strerror or error}"
        raise FileError(bucket / INDEX, reason, remedy=_ANEW.format(bucket)) from error


@lru_cache(maxsize=64)
def _index_of(bucket: Path, time: int) -> dict[int, int]:
    try:
        return {
            int(tile): rows for tile, rows in json.loads((bucket / INDEX).read_text(encoding="utf-8"))["tiles"].items()
        }
    except (OSError, *DAMAGE) as error:
        raise FileError(bucket / INDEX, f"cannot be read: {error}", remedy=_ANEW.format(bucket)) from error


def _read_blocks(path: Path, file: LasFile, window: Any) -> tuple[list[tuple[Any, NDArray[np.uint64]]], int]:
    """Rows of a tile's blocks in a window, and the row count of all blocks."""
    blocks, size = [], 0
    with path.open("rb") as stream:
        while head := stream.read(_BLOCK.size):
            if len(head) < _BLOCK.size or head[:4] != _MARK:
                raise FileError(path, "is damaged", where=f"byte {stream.tell() - len(head)}")
            _, count, body_size, numbers_size, how, x0, y0, x1, y1, checksum = _BLOCK.unpack(head)
            left = path.stat().st_size - stream.tell()
            if body_size + numbers_size > left or 8 * count > MAX_DEFLATE_RATIO * numbers_size:
                reason = f"is damaged: a block of {count} rows in {body_size} and {numbers_size} bytes, {left} are left"
                raise FileError(path, reason, where=f"byte {stream.tell()}")
            size += count
            if x1 < window[0] or y1 < window[1] or x0 >= window[2] or y0 >= window[3]:
                stream.seek(body_size + numbers_size, 1)
                continue
            body, packed_numbers = stream.read(body_size), stream.read(numbers_size)
            if zlib.crc32(packed_numbers, zlib.crc32(body)) != checksum:
                raise FileError(path, "is damaged: a block does not match its checksum", where=f"at {stream.tell()}")
            steps = np.frombuffer(_inflated(path, packed_numbers, 8 * count), np.uint8).reshape(8, -1).T
            block = np.frombuffer(_unpacked(path, file, body, count, how), file.layout.dtype())  # as many rows
            numbers = np.cumsum(np.ascontiguousarray(steps).view(np.uint64).ravel(), dtype=np.uint64)
            keep = inside(positions_of(file, block), window)
            blocks.append((block[keep], numbers[keep]))
    return blocks, size


def _inflated(path: Path, packed: bytes, size: int) -> bytes:
    """Decompress a zlib stream of exactly `size` bytes."""
    with foreign_errors(path, "a block is damaged"):
        unpacked = zlib.decompressobj().decompress(packed, size + 1)
    if len(unpacked) != size:
        raise FileError(path, f"is damaged: a block of {len(unpacked)} bytes, expected {size}")
    return unpacked


def _unpacked(path: Path, file: LasFile, body: bytes, count: int, how: int) -> Any:
    if how == _ZLIB_CODEC:
        return _inflated(path, body, count * file.header.record_length)
    lazrs = import_for("buckets.laz", "lazrs", "las")
    rows = np.empty(count * file.header.record_length, np.uint8)
    with foreign_errors(path, "the packed points are damaged"):
        decompressor = lazrs.LasZipDecompressor(io.BytesIO(body), _lazrs_record(file).record_data())
        decompressor.decompress_many(rows)
    return rows.tobytes()
