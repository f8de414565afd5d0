"""LAS and LAZ files, versions 1.0 to 1.5, point formats 0 to 10, with laspy and lazrs.

Positions are float64 in the file's unit and coordinate system. Other dimensions are attributes with laspy's names.
Colors are divided by 255 if no value exceeds it (many writers store 8 bits), else by 65535. NormalX.. or "normal x"..
are normals. Waveforms are not read. ASPRS, LAS Specification 1.4-R15.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.errors import FileError, FilePath
from ...core.reports import failed
from ..columns import stack_normals
from ..growing_columns import GrowingColumns
from ..optional_imports import foreign_errors, import_for
from ..source import SourceFile, open_source
from ..table import PointTable
from .las_crs import crs_of, is_geographic
from .las_extra import EXTRA_BYTES, decode_extra, parameters_of, warn_of_wide_integers
from .las_header import LasHeader, parse_las_header
from .las_units import units_of
from .laszip import check_laszip, unpack_beginnings, unpack_blocks

# Points decoded at a time: blocks of about 10 MB, so that LAZ chunks (usually 50,000 points) use all cores.
# Fewer for long records, since compressed bytes do not bound them. Uncompressed blocks that remain in the cache are
# decoded faster: 250 MB in 0.37 s of CPU instead of 0.51 s (2026-11-27).
_POINTS_PER_BLOCK, _PLAIN_BLOCK, _BLOCK_BYTES = 1 << 18, 1 << 15, 1 << 24

_PACKED = ("bit_fields", "raw_classification", "classification_flags")  # bytes that contain several dimensions
_COORDINATES = ("X", "Y", "Z")
COLORS: tuple[str, ...] = ("red", "green", "blue")
NORMALS: tuple[str, ...] = ("NormalX", "NormalY", "NormalZ")
_NAMES_OF_NORMALS = (NORMALS, ("normal x", "normal y", "normal z"))  # the latter are Metashape's


@dataclass(frozen=True)
class LasFile:
    """A file with a validated header; `layout` is laspy's PointFormat."""

    path: Path
    source: SourceFile
    header: LasHeader
    layout: Any

    def rows(self, size: int) -> Iterator[NDArray[Any]]:
        """Raw point records of an uncompressed file, at most `size` at a time."""
        row = self.layout.dtype()
        if self.header.is_compressed:
            for block in unpack_blocks(self.source, self.header, size):
                yield np.frombuffer(block, row)
            return
        count, begin = self.header.point_count, self.header.begin
        for first in range(0, count, size):
            yield self.source.array(row, min(size, count - first), begin + first * row.itemsize)

    def blocks(self, size: int) -> Iterator[dict[str, NDArray[Any]]]:
        """Points as columns, at most `size` at a time. The first block is empty and defines the types."""
        yield self.decode(np.empty(0, self.layout.dtype()))
        for rows in self.rows(size):
            yield self.decode(rows)

    def sample(self, count: int) -> PointTable:
        """At most `count` points: evenly spaced, or the first of each chunk if compressed."""
        row = self.layout.dtype()
        if self.header.is_compressed:
            rows = np.frombuffer(unpack_beginnings(self.source, self.header, count), row)
        else:
            step = -(-self.header.point_count // count) or 1
            rows = self.source.every(step, row, self.header.point_count, self.header.begin)
        arrays = self.decode(rows)
        if "colors" in arrays:
            _scale_colors(arrays["colors"])
        return table_of(self, arrays)

    @quiet()
    def decode(self, rows: Any) -> dict[str, NDArray[Any]]:
        """Positions as "points", raw colors as "colors", other dimensions as "." plus name."""
        from laspy import PackedPointRecord

        record, names = PackedPointRecord(rows, self.layout), [*self.layout.dimension_names]
        points = np.empty((len(rows), 3))
        for axis, name in enumerate(_COORDINATES):
            np.multiply(rows[name], self.header.scales[axis], out=points[:, axis])
            points[:, axis] += self.header.offsets[axis]
        columns: dict[str, NDArray[Any]] = {"points": points}
        if COLORS[0] in names:
            columns["colors"] = np.stack([rows[name] for name in COLORS], axis=1).astype(np.float32)
        for dimension in self.layout.dimensions:
            name = dimension.name
            if name in _COORDINATES or name in COLORS:
                continue
            is_standard = dimension.is_standard
            values = np.asarray(record[name]) if is_standard else decode_extra(dimension, rows[name])
            is_shifted = name == "gps_time" and self.header.time_shift
            columns["." + name] = values + self.header.time_shift if is_shifted else values
        return columns


def open_las(path: FilePath, *, layers_too: bool = True) -> LasFile:
    """Open a file and check its header and chunk table without reading points.
    `layers_too` also checks the layers of compressed chunks, see `check_laszip`."""
    path = Path(path)
    source = open_source(path)
    header = parse_las_header(path, source)
    layout = layout_of(path, header)
    if header.is_compressed:
        check_laszip(path, source, header, layers_too=layers_too)
    return LasFile(path, source, header, layout)


def read_las(path: FilePath) -> PointTable:
    """Read a LAS or LAZ file. Needs memory for the result and about 20 MB. Up to 1.5 times the result for LAZ."""
    file = open_las(path)
    warn_of_wide_integers(path, file.layout)
    columns = GrowingColumns(file.header.point_count, is_proven=not file.header.is_compressed)
    block_points = _POINTS_PER_BLOCK if file.header.is_compressed else _PLAIN_BLOCK
    for block in file.blocks(min(block_points, _BLOCK_BYTES // file.header.record_length)):
        columns.append(block)
    arrays = columns.finish()
    if "colors" in arrays:
        _scale_colors(arrays["colors"])
    return table_of(file, arrays)


def _scale_colors(colors: NDArray[np.float32]) -> None:
    colors /= np.float32(255 if colors.max(initial=0) <= 255 else 65535)


def iterate_las(file: LasFile, chunk_size: int) -> Iterator[PointTable]:
    """Read an opened file in chunks of `chunk_size` points.
    The first color that is not black decides between 255 and 65535; later contradictions raise `FileError`."""
    warn_of_wide_integers(file.path, file.layout)
    full = 0
    for number, block in enumerate(file.blocks(chunk_size)):
        if not number:
            continue
        if "colors" in block:
            brightest = block["colors"].max(initial=0)
            if not full and brightest:
                full = 255 if brightest <= 255 else 65535
            if brightest > (full or brightest):
                reason = "colors look like 8 bits in one part and like 16 in a later one"
                remedy = "Read the complete file, or larger parts"
                raise FileError(file.path, reason, where=f"points from {(number - 1) * chunk_size} on", remedy=remedy)
            block["colors"] /= np.float32(full or 65535)
        yield table_of(file, block)


def attribute_types(file: LasFile) -> dict[str, str]:
    table = table_of(file, next(file.blocks(1)))
    named = {"normals": table.normals, "colors": table.colors, **table.attributes}
    present = {name: values for name, values in named.items() if values is not None}
    return {name: f"{v.dtype}" + (f" x {v.shape[1]}" if v.ndim == 2 else "") for name, v in present.items()}


def scale_by(full: int, colors: NDArray[np.float32], path: Path, remedy: str) -> None:
    """Scale colors to 0..1 in place with a known maximum. Raises `FileError` if they exceed it."""
    if colors.max(initial=0) > full:
        reason = "colors look like 8 bits in its coarsest level and like 16 elsewhere"
        raise FileError(path, reason, remedy=remedy)
    colors /= np.float32(full)


def table_of(file: LasFile, arrays: dict[str, NDArray[Any]]) -> PointTable:
    attributes = {name[1:]: values for name, values in arrays.items() if name.startswith(".")}
    normals = None
    for names in _NAMES_OF_NORMALS:
        if normals is None and all(name in attributes and attributes[name].dtype.kind == "f" for name in names):
            normals = stack_normals(file.path, [attributes.pop(name) for name in names])
    steps = np.array(file.header.scales, np.float64)
    colors, is_lonlat, units = arrays.get("colors"), is_geographic(file.header), units_of(file.header)
    how = {
        "steps": steps,
        "is_geographic": is_lonlat,
        "unit": units.plane,
        "crs": crs_of(file.header),
        "warnings": failed(units.warning),
    }
    return PointTable(arrays["points"], normals, colors, attributes, **how)


def layout_of(path: FilePath, header: LasHeader) -> Any:
    """The dimensions of a point: standard, extra, and remaining bytes. Raises `FileError` if the record is damaged."""
    laspy = import_for(path, "laspy", "las")
    layout = laspy.PointFormat(header.point_format)
    described = header.find(*EXTRA_BYTES)
    with foreign_errors(path, "the record of extra dimensions is damaged"):
        if described is not None and header.record_length > layout.size:
            for dimension in parameters_of(import_for(path, "laspy.vlrs.known", "las"), described):
                layout.add_extra_dimension(dimension)
        spare = header.record_length - layout.size
        if spare < 0:
            reason = f"its extra dimensions need {-spare} bytes more than its points have"
            raise FileError(path, reason, where="byte 105")
        if spare:
            layout.add_extra_dimension(laspy.ExtraBytesParams("ExtraBytes", f"{spare}u1"))
        names = [*layout.dimension_names, *_PACKED]
        if len({*names}) < len(names) or "" in names:
            reason = f"two dimensions of its points have one name, or one has none: {', '.join(names)}"
            raise FileError(path, reason)
        layout.dtype()
    return layout
