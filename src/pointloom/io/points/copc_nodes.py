"""Read a COPC file node by node for viewers. A damaged node does not affect others."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count
from ...core.errors import FileError, FilePath
from ...core.serialized import keep_through_forks
from ...core.units import LengthUnit
from ...kernels.lru_cache import LruCache
from ..optional_imports import foreign_errors, import_for
from ..source import netted, open_source
from ..table import PointTable
from .copc import COPC_INFO, CopcFile, octree_of
from .las import COLORS, open_las, table_of
from .las_header import parse_las_header
from .las_units import units_of
from .laszip import LASZIP_RECORD, check_chunk

CACHE_BYTES = 1 << 28  # [B] cache of unpacked points
MAX_POINTS = 1 << 22  # maximum points of a node: writers use about 100,000, and a few bytes may claim any number


class CopcNodes:
    """A COPC file that is open only while a node is read. Thread-safe.
    `memory` is the size of the LRU cache of unpacked nodes [B]. A larger node is cached alone. `nodes_read` and
    `bytes_read` count unpacked nodes and compressed bytes."""

    def __init__(self, path: FilePath, *, memory: int = CACHE_BYTES):
        self._rows: LruCache[NDArray[Any]] = LruCache(check_count("memory", memory, minimum=0))
        self.octree = _open(Path(path))
        self.path, self._header = self.octree.path, self.octree.file.header
        self.unit: LengthUnit | None = units_of(self._header).plane
        self.row: np.dtype[Any] = self.octree.file.layout.dtype()
        self.nodes_read = self.bytes_read = 0
        self._lock = threading.Lock()
        keep_through_forks(self)
        self._stamp = _stamp_of(self.path)

    @property
    def memory_used(self) -> int:
        return self._rows.size

    def table(self, k: int, full: int) -> PointTable:
        """The points of node `k` of `octree.nodes`; `full` is the maximum color value, brighter colors are clipped."""
        columns = self.octree.file.decode(self.rows(k))
        if "colors" in columns:
            columns["colors"] = np.minimum(columns["colors"] / np.float32(full), np.float32(1))
        return table_of(self.octree.file, columns)

    def rows(self, k: int) -> NDArray[Any]:
        """The uncompressed points of a node. See `table`."""
        with self._lock:
            rows = self._rows.find(k)
        if rows is None:
            rows = self._read(k)
            with self._lock:
                self._rows.put(k, rows, rows.nbytes)
        return rows

    def name_of(self, k: int) -> str:
        node = self.octree.nodes[k]
        cell = "-".join(map(str, node["cell"].tolist()))
        return f"node {int(node['level'])}-{cell} of the octree, at byte {int(node['begin'])}"

    def full_of(self, which: NDArray[np.int64]) -> int:
        """Maximum color value: 255 if no given node exceeds it, else 65535."""
        if COLORS[0] not in (self.row.names or ()):
            return 65535
        brightest = max((int(self.rows(k)[name].max(initial=0)) for k in which.tolist() for name in COLORS), default=0)
        return 255 if 0 < brightest <= 255 else 65535

    def _read(self, k: int) -> NDArray[Any]:
        node, what = self.octree.nodes[k], self.name_of(k)
        begin, size, count = int(node["begin"]), int(node["size"]), int(node["count"])
        if count > MAX_POINTS:
            raise FileError(self.path, f"{what}, claims {count} points; at most {MAX_POINTS} are shown")
        lazrs = import_for(self.path, "lazrs", "las")
        rows = np.empty(count, self.row)
        with foreign_errors(self.path, f"{what}, cannot be read"):
            if _stamp_of(self.path) != self._stamp:
                raise FileError(self.path, "has changed since it was opened", remedy="Open it again")
            with self.path.open("rb") as stream:
                stream.seek(begin)
                chunk = stream.read(size)
            if len(chunk) < size:
                raise FileError(self.path, f"{what}, has {len(chunk)} of {size} bytes")
            check_chunk(self.path, self._header, chunk, what)
            record = self._header.find(*LASZIP_RECORD) or b""
            lazrs.decompress_points_with_chunk_table(chunk, record, rows.view(np.uint8), [(count, size)])
        with self._lock:
            self.nodes_read, self.bytes_read = self.nodes_read + 1, self.bytes_read + size
        rows.flags.writeable = False
        return rows


@netted
def _open(path: Path) -> CopcFile:
    return octree_of(open_las(path, layers_too=False), strict=False)


def declares_copc(path: FilePath, *, more_than: int = 0) -> bool:
    """True if the header of a LAZ file declares COPC and more than `more_than` points."""
    path = Path(path)
    header = parse_las_header(path, open_source(path))
    return header.is_compressed and header.find(*COPC_INFO) is not None and header.point_count > more_than


def _stamp_of(path: Path) -> tuple[int, int]:
    status = path.stat()
    return status.st_size, status.st_mtime_ns
