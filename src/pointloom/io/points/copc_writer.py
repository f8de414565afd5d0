"""Write Cloud Optimized Point Clouds: LAZ (formats 6 to 8) whose chunks are octree nodes.

The cube starts at the lower corner with the longest extent, as some readers use the header's bounds. Each voxel of
1/128 of a node's side is represented by one point in the coarsest possible node (pcd/detail_nodes.py). Hobu Inc., "COPC
specification 1.0" (2021).
"""

from __future__ import annotations

import io
import math
import os
from collections.abc import Iterator
from functools import partial
from typing import IO, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.coordinates import quiet
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FilePath
from ...kernels.array_types import Device
from ...kernels.lang import vec3d
from ...kernels.memory import upload
from ...kernels.sampling.detail_levels import NODE_BITS, find_levels
from ...pcd.detail_nodes import NodeTable, make_nodes
from ..optional_imports import foreign_errors, import_for
from ..table import PointTable
from .copc import COPC_ENTRY, COPC_HIERARCHY, COPC_INFO, IN_PAGE, INFO_FIELDS
from .las_header import LasHeader
from .las_writer import LasLayout, lay_out, with_scan_angle
from .laszip import LASZIP_RECORD as LASZIP
from .laszip import chunks_at

# Nodes with fewer points join their parent: smaller nodes compress worse, larger ones are slower to query.
_MIN_NODE_POINTS = 8192
_POINTS_PER_BATCH = 1 << 20  # points compressed at a time, one node per core
_EXTENDED_HEADER = 60  # bytes
_PAGE_DEPTH = 5  # from this level on, branches of a large octree have their own pages
_ENTRIES_PER_PAGE = 1 << 12  # maximum entries of the first page


def write_copc(
    path: FilePath,
    table: PointTable,
    *,
    scale: ArrayLike | None = None,
    offset: ArrayLike | None = None,
    like: LasHeader | None = None,
    overwrite: bool = True,
    device: DeviceLike = None,
) -> None:
    """Write points as a COPC file atomically, with options as in `write_las`. The file does not depend on `device`.
    Needs 100 B per point in addition to the table."""
    path, where = check_writable(path, overwrite=overwrite), resolve_device(device)
    layout = lay_out(path, with_scan_angle(table), scale, offset, like)
    corner, side, nodes = _octree(layout, where)
    with atomic_write(path, overwrite=overwrite) as file, foreign_errors(path, "cannot be written"), quiet():
        writer = CopcWriter(path, file, layout, corner, side)
        ends = np.cumsum(nodes.counts)
        begin = 0
        while begin < len(ends):
            end = max(int(np.searchsorted(ends, nodes.firsts[begin] + _POINTS_PER_BATCH)), begin + 1)
            rows = [np.sort(nodes.order[ends[k] - nodes.counts[k] : ends[k]]) for k in range(begin, end)]
            writer.add(nodes.depths[begin:end], nodes.cells[begin:end], [layout.pack(part) for part in rows])
            begin = end
        writer.finish(layout.extended)


class CopcWriter:
    """Write octree nodes to an empty readable file, in any order; `corner` and `side` define the cube."""

    def __init__(self, path: FilePath, file: IO[bytes], layout: LasLayout, corner: NDArray[np.float64], side: float):
        lazrs = import_for(path, "lazrs", "las")
        self._path, self._file = path, file
        self._laspy, self._header = layout.laspy, layout.header
        self._middle, self._side = np.asarray(corner, np.float64) + side / 2, side
        self._laszip = lazrs.LazVlr.new_for_compression(
            self._header.point_format.id, self._header.point_format.num_extra_bytes, use_variable_size_chunks=True
        )
        self._levels: list[int] = []
        self._cells: list[tuple[int, int, int]] = []
        self._counts: list[int] = []
        self._sizes: list[int] = []
        self._times = (math.inf, -math.inf)
        self._header.partial_reset()
        self._header.set_compressed(True)
        self._header.global_encoding.wkt = True  # as all files of these formats
        self._header.vlrs.insert(0, self._info(0, 0))
        self._header.vlrs.append(self._laspy.VLR(*LASZIP, "", self._laszip.record_data()))
        self._header.write_to(file)
        self._begin = file.tell()
        file.write(bytes(8))  # offset of the chunk table
        self.pack = partial(pack_chunks, str(path), self._laszip.record_data())

    def add(self, levels: Any, cells: Any, records: list[Any], chunks: list[bytes] | None = None) -> None:
        """Add nodes with their points; `chunks` are the results of `pack_chunks`, or None to compress here."""
        if chunks is None:
            chunks = self.pack([record.array for record in records])
        for record in records:
            self._header.grow(record)
            times = record["gps_time"]
            self._times = min(self._times[0], float(times.min())), max(self._times[1], float(times.max()))
        for chunk in chunks:
            self._file.write(chunk)
        self._sizes += [len(chunk) for chunk in chunks]
        self._levels += np.asarray(levels).tolist()
        self._cells += np.asarray(cells).tolist()
        self._counts += [len(record) for record in records]

    def finish(self, extended: Any) -> None:
        file, header = self._file, self._header
        table = file.tell()
        lazrs = import_for(self._path, "lazrs", "las")
        lazrs.write_chunk_table(file, list(zip(self._counts, self._sizes, strict=True)), self._laszip)
        file.seek(self._begin)
        file.write(table.to_bytes(8, "little"))
        file.seek(0, os.SEEK_END)
        at = file.tell()
        begin = at + _EXTENDED_HEADER
        pages, root_size = _pages(self._entries(), begin)
        file.seek(at)
        records = self._laspy.vlrs.vlrlist.VLRList([self._laspy.VLR(*COPC_HIERARCHY, "", pages), *extended])
        header.start_of_first_evlr, header.number_of_evlrs = at, len(records)
        records.write_to(file, as_extended=True)
        header.vlrs[0] = self._info(begin, root_size)
        if not header.point_count:
            header.mins, header.maxs = np.zeros(3), np.zeros(3)
        file.seek(0)
        header.write_to(file, ensure_same_size=True)

    def _entries(self) -> NDArray[Any]:
        """Entries of the nodes, including empty parents of nodes."""
        entries = np.zeros(len(self._counts), COPC_ENTRY)
        if len(entries):
            entries["level"], entries["cell"], entries["count"] = self._levels, self._cells, self._counts
            entries["begin"] = self._begin + 8 + np.cumsum(self._sizes) - self._sizes
            entries["size"] = self._sizes
        stored = set(zip(entries["level"].tolist(), *entries["cell"].T.tolist(), strict=True))
        bare = {above for key in stored for above in _ancestors(*key)} - stored
        without = np.zeros(len(bare) if stored else 1, COPC_ENTRY)
        if bare:
            keys = np.array(sorted(bare))
            without["level"], without["cell"] = keys[:, 0], keys[:, 1:]
        return np.concatenate([entries, without])

    def _info(self, begin: int, size: int) -> Any:
        times = self._times if self._counts else (0.0, 0.0)
        spacing = self._side / 2**NODE_BITS
        record = INFO_FIELDS.pack(*self._middle.tolist(), self._side / 2, spacing, begin, size, *times, *[0] * 11)
        return self._laspy.VLR(*COPC_INFO, "", record)


def pack_chunks(path: str, record: bytes, rows: list[NDArray[Any]]) -> list[bytes]:
    """Compress the rows of each node; `record` is LASzip's record."""
    lazrs, stream = import_for(path, "lazrs", "las"), io.BytesIO()
    with foreign_errors(path, "its points cannot be packed"):
        compressor = lazrs.ParLasZipCompressor(stream, lazrs.LazVlr(record))
        compressor.compress_chunks([np.frombuffer(part, np.uint8) for part in rows])
        compressor.done()
    packed = stream.getbuffer()
    return [bytes(packed[begin : begin + size]) for begin, _, size in chunks_at(path, stream, 0, record).tolist()]


def _octree(layout: LasLayout, device: Device) -> tuple[NDArray[np.float64], float, NodeTable]:
    """Corner and side of the cube around the stored points, and the octree nodes."""
    points, header = layout.table.points, layout.header
    stored = np.empty((len(points), 3))
    for axis in range(3):
        offset, scale = header.offsets[axis], header.scales[axis]
        stored[:, axis] = np.rint((points[:, axis].astype(np.float64) - offset) / scale) * scale + offset
    corner = stored.min(axis=0) if len(points) else np.zeros(3)
    extent = float((stored.max(axis=0) - corner).max()) if len(points) else 0.0
    side = max(extent, float(header.scales.max()))
    levels = find_levels(upload(stored, vec3d, device), corner, side)
    return corner, side, make_nodes(*levels, max_points=len(points), min_points=_MIN_NODE_POINTS)


def _pages(entries: NDArray[Any], begin: int) -> tuple[bytes, int]:
    entries = entries[np.lexsort((*entries["cell"].T[::-1], entries["level"]))]
    if len(entries) <= _ENTRIES_PER_PAGE:
        return entries.tobytes(), entries.nbytes
    deep = entries["level"] >= _PAGE_DEPTH
    below = entries[deep]
    roots, branch = np.unique(below["cell"] >> (below["level"] - _PAGE_DEPTH)[:, None], axis=0, return_inverse=True)
    order = np.argsort(branch.ravel(), kind="stable")
    sizes = np.bincount(branch.ravel(), minlength=len(roots)) * COPC_ENTRY.itemsize
    links = np.zeros(len(roots), COPC_ENTRY)
    links["level"], links["cell"], links["count"], links["size"] = _PAGE_DEPTH, roots, IN_PAGE, sizes
    root_size = (len(entries) - len(below) + len(links)) * COPC_ENTRY.itemsize
    links["begin"] = begin + root_size + np.cumsum(sizes) - sizes
    return np.concatenate([entries[~deep], links, below[order]]).tobytes(), root_size


def _ancestors(level: int, x: int, y: int, z: int) -> Iterator[tuple[int, int, int, int]]:
    for up in range(1, level + 1):
        yield level - up, x >> up, y >> up, z >> up
