"""Read Cloud Optimized Point Clouds: LAZ files whose chunks are octree nodes, validated before decompression.

Hobu Inc., "COPC: Cloud Optimized Point Cloud specification 1.0" (2021).
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ..optional_imports import foreign_errors, import_for
from ..source import SourceFile
from ..table import PointTable
from .las import COLORS, LasFile, open_las, scale_by, table_of
from .las_extra import warn_of_wide_integers
from .laszip import LASZIP_RECORD as LASZIP
from .laszip import chunks_at

COPC_INFO, COPC_HIERARCHY = ("copc", 1), ("copc", 1000)
INFO_FIELDS = struct.Struct("<5d2Q2d11Q")
COPC_ENTRY = np.dtype([("level", "<i4"), ("cell", "<i4", 3), ("begin", "<u8"), ("size", "<i4"), ("count", "<i4")])
POINT_FORMATS = (6, 7, 8)
IN_PAGE = -1  # point count of an entry that refers to another page
_MAX_LEVELS = 31  # cells have 32-bit indices


@dataclass(frozen=True, eq=False)
class CopcFile:
    """A file with a validated octree: lower `corner` (3,) and `side` of its cube, `spacing` of the coarsest level.
    `nodes` are those with points, coarse to fine, with the fields of COPC_ENTRY; `times` is the GPS time range."""

    file: LasFile
    corner: NDArray[np.float64]
    side: float
    spacing: float
    times: tuple[float, float]
    nodes: NDArray[Any]

    @property
    def path(self) -> Path:
        return self.file.path

    @cached_property
    def full(self) -> int:
        """Maximum color value: 255 if the coarsest level does not exceed it, else 65535."""
        row = self.file.layout.dtype()
        if COLORS[0] not in row.names:
            return 65535
        coarsest = np.flatnonzero(self.nodes["level"] == self.nodes["level"][:1])
        rows: Any = np.frombuffer(self.unpack(coarsest), row)
        brightest = max(int(rows[name].max(initial=0)) for name in COLORS)
        return 255 if 0 < brightest <= 255 else 65535

    def nodes_within(self, low: Any = None, high: Any = None, spacing: float = 0.0) -> NDArray[np.int64]:
        """Indices of nodes that may intersect a box (None: unbounded), down to the first level as fine as `spacing`."""
        widths = self.side / 2.0 ** self.nodes["level"]
        lows = self.corner + self.nodes["cell"] * widths[:, None]
        keep = self.spacing / 2.0 ** (self.nodes["level"] - 1.0) > spacing
        keep[self.nodes["level"] == 0] = True
        slack = 1e-9 * self.side  # cell corners are rounded
        if low is not None:
            keep &= (lows + widths[:, None] + slack >= low).all(axis=1)
        if high is not None:
            keep &= (lows - slack <= high).all(axis=1)
        return np.flatnonzero(keep)

    def read(self, low: Any = None, high: Any = None, spacing: float = 0.0) -> PointTable:
        """The points of a box, down to a spacing. See `nodes_within`.
        Needs memory for the intersecting nodes, raw and as columns, and the result."""
        file = self.file
        warn_of_wide_integers(self.path, file.layout)
        columns = file.decode(np.frombuffer(self.unpack(self.nodes_within(low, high, spacing)), file.layout.dtype()))
        keep = np.ones(len(columns["points"]), bool)
        if low is not None:
            keep &= (columns["points"] >= low).all(axis=1)
        if high is not None:
            keep &= (columns["points"] <= high).all(axis=1)
        if not keep.all():
            columns = {name: values[keep] for name, values in columns.items()}
        if "colors" in columns:
            scale_by(self.full, columns["colors"], self.path, "Read the complete file")
        return table_of(file, columns)

    def unpack(self, which: NDArray[np.int64]) -> bytes:
        nodes, header = self.nodes[which], self.file.header
        rows = np.empty(int(nodes["count"].sum()) * header.record_length, np.uint8)
        if not len(nodes):
            return rows.tobytes()
        lazrs = import_for(self.path, "lazrs", "las")
        source, record = self.file.source, header.find(*LASZIP) or b""
        begins, sizes, counts = (nodes[name].tolist() for name in ("begin", "size", "count"))
        chunks = [source[begin : begin + size] for begin, size in zip(begins, sizes, strict=True)]
        chunk_table = list(zip(counts, sizes, strict=True))
        with foreign_errors(self.path, "the compressed points are damaged"):
            lazrs.decompress_points_with_chunk_table(b"".join(chunks), record, rows, chunk_table)
        return rows.tobytes()


def is_copc(file: LasFile) -> bool:
    return file.header.is_compressed and file.header.find(*COPC_INFO) is not None


def open_copc(path: FilePath) -> CopcFile:
    """Open a file and check its octree against its chunks, without decompressing points."""
    return octree_of(open_las(path))


def octree_of(file: LasFile, *, strict: bool = True) -> CopcFile:
    """The octree of an opened file. Not `strict` skips nodes that match no chunk."""
    if not is_copc(file):
        raise FileError(file.path, "is not a COPC file: it has no octree record", remedy="Read the complete file")
    header, source = file.header, file.source
    if header.point_format not in POINT_FORMATS:
        raise FileError(
            file.path, f"COPC has point formats 6, 7 and 8, this is {header.point_format}", where="byte 104"
        )
    record = header.find(*COPC_INFO) or b""
    if len(record) != INFO_FIELDS.size:
        raise FileError(file.path, f"the record of its octree has {len(record)} bytes, not {INFO_FIELDS.size}")
    values = INFO_FIELDS.unpack(record)
    middle, half, spacing = np.array(values[:3]), values[3], values[4]
    if not (np.isfinite(middle).all() and 0 < half < np.inf and 0 < spacing < np.inf):
        reason = f"its octree has the middle {middle.tolist()}, half width {half} and spacing {spacing}"
        raise FileError(file.path, reason, remedy="Write it again from its points")
    nodes = _read_pages(file.path, source, values[5], values[6])
    nodes = _check_nodes(file, nodes, strict)
    return CopcFile(file, middle - half, 2 * half, spacing, (values[7], values[8]), nodes)


def _read_pages(path: Path, source: SourceFile, begin: int, size: int) -> NDArray[Any]:
    """Entries with points of all pages, coarse to fine, sorted by cell within a level."""
    pages, wanted, read = [], [(begin, size)], set()
    while wanted:
        begin, size = wanted.pop()
        if begin in read:
            raise FileError(path, "pages of the octree form a cycle", where=f"byte {begin}")
        read.add(begin)
        if size < 0 or size % COPC_ENTRY.itemsize or begin + size > len(source):
            reason = f"a page of the octree should have {size} bytes, a multiple of {COPC_ENTRY.itemsize}"
            raise FileError(path, f"{reason}; the file ends at byte {len(source)}", where=f"byte {begin}")
        page = source.array(COPC_ENTRY, size // COPC_ENTRY.itemsize, begin)
        further = page["count"] == IN_PAGE
        wanted += zip(page["begin"][further].tolist(), page["size"][further].tolist(), strict=True)
        pages.append(page[~further])
    nodes = np.concatenate(pages)
    levels, cells = nodes["level"].astype(np.int64), nodes["cell"].astype(np.int64)
    if (nodes["count"] < 0).any() or (levels < 0).any() or (levels >= _MAX_LEVELS).any():
        raise FileError(path, "a node of the octree has an invalid level or count", where=f"byte {begin}")
    if (cells < 0).any() or (cells >= (np.int64(1) << levels)[:, None]).any():
        raise FileError(path, "a node of the octree is outside its cube", where=f"byte {begin}")
    order = np.lexsort((*cells.T[::-1], levels))
    keys = np.column_stack([levels, cells])[order]
    if (keys[1:] == keys[:-1]).all(axis=1).any():
        raise FileError(path, "a node of the octree is duplicated", where=f"byte {begin}")
    nodes = nodes[order]
    return nodes[nodes["count"] > 0]


def _check_nodes(file: LasFile, nodes: NDArray[Any], strict: bool) -> NDArray[Any]:
    """Check that each chunk is exactly one node. Returns the valid nodes."""
    chunks, header = np.empty((0, 3), np.int64), file.header
    if header.point_count:
        with file.path.open("rb") as stream:
            chunks = chunks_at(file.path, stream, header.begin, header.find(*LASZIP) or b"")
    listed = np.column_stack([nodes["begin"].astype(np.int64), nodes["count"], nodes["size"]])
    if np.array_equal(listed[np.argsort(listed[:, 0])], chunks):
        return nodes
    if strict:
        reason = f"its octree has {len(listed)} nodes with points, which are not the {len(chunks)} chunks of the file"
        raise FileError(file.path, reason, remedy="Read the complete file, or write it again")
    known = set(map(tuple, chunks.tolist()))
    return nodes[np.array([tuple(row) in known for row in listed.tolist()], bool)]
