"""Read the uncompressed points of a LAZ file by chunk. The file is open only while reading."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ..optional_imports import foreign_errors, import_for
from .las import open_las
from .las_header import LasHeader
from .laszip import LASZIP_RECORD as LASZIP
from .laszip import chunks_at


class LazChunks:
    """A file with a validated chunk table: `header`, `row` type and `counts`, points per chunk, int64 (m,)."""

    def __init__(self, path: Path):
        file = open_las(path)
        if not file.header.is_compressed or not file.header.point_count:
            raise FileError(path, "is not a LAZ file with points")
        self.path, self.header = path, file.header
        self.row: np.dtype[Any] = file.layout.dtype()
        self._record = file.header.find(*LASZIP) or b""
        with path.open("rb") as stream:
            chunks = chunks_at(path, stream, file.header.begin, self._record)
        self._begins, self._sizes = chunks[:, 0], chunks[:, 2]
        ends = np.minimum(np.cumsum(chunks[:, 1]), file.header.point_count)  # the last may be declared as full
        self.counts = np.diff(ends, prepend=0)

    def rows(self, which: NDArray[np.int64]) -> NDArray[Any]:
        lazrs = import_for(self.path, "lazrs", "las")
        out = np.empty(int(self.counts[which].sum()), self.row)
        chunk_table = list(zip(self.counts[which].tolist(), self._sizes[which].tolist(), strict=True))
        with foreign_errors(self.path, "the compressed points cannot be read"):
            with self.path.open("rb") as stream:
                packed = b"".join(_bytes_at(stream, int(self._begins[k]), int(self._sizes[k])) for k in which.tolist())
            lazrs.decompress_points_with_chunk_table(packed, self._record, out.view(np.uint8), chunk_table)
        return out


def _bytes_at(stream: Any, begin: int, size: int) -> bytes:
    stream.seek(begin)
    return stream.read(size)


def is_alike(header: LasHeader, other: LasHeader) -> bool:
    """True if rows of two files are compatible: format, length, scales and offsets."""
    names = ("point_format", "record_length", "scales", "offsets")
    return all(getattr(header, name) == getattr(other, name) for name in names)
