"""LAS and LAZ files of points, versions 1.0 to 1.4, point formats 0 to 10; the packages laspy and lazrs read them.

Reading: positions are X * scale + offset in float64, in the file's own unit (metres or feet, which las_units.py tells:
nothing is converted) and coordinate system (las_crs.py tells its name). Every other dimension is an attribute by
laspy's name and in the file's type: intensity, return_number, number_of_returns, classification, synthetic, key_point,
withheld, scan_angle_rank (whole degrees, formats 0 to 5) or scan_angle (steps of 0.006 degrees, formats 6 to 10),
user_data, point_source_id, gps_time, nir, and so on, and each extra dimension by its own name, scaled where it says so,
and NaN where it has the no_data value that the file declares (las_extra.py).
Red, green and blue are colours in 0..1: of 65535, or of 255 where no value in the file exceeds that, as many writers
store 8 bits in the 16-bit fields (a file of 16-bit colours darker than 1/257 throughout would come out too bright).
Extra dimensions NormalX, NormalY and NormalZ, or "normal x", "normal y" and "normal z" (Metashape), are normals.
Waveforms are not read.

The file is held to its header by las_header.py and laszip.py before memory is taken.

Source: ASPRS, LAS Specification 1.4-R15.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.errors import FileError
from ..columns import stack_normals
from ..foreign import foreign_errors, import_for
from ..growing import GrowingColumns
from ..source import Source, open_source
from ..table import PointTable
from .las_crs import is_geographic
from .las_extra import EXTRA_BYTES, decode_extra, parameters_of, warn_of_wide_integers
from .las_header import LasHeader, parse_las_header
from .las_units import units_of
from .laszip import check_laszip, unpack_beginnings, unpack_blocks

# Points decoded at a time: blocks of some 10 MB, in which LAZ's chunks (50,000 points as a rule) keep all cores busy;
# fewer of points that claim to be long, of which compressed bytes tell nothing.
_BLOCK, _BLOCK_BYTES = 1 << 18, 1 << 24

_PACKED = ("bit_fields", "raw_classification", "classification_flags")  # bytes that hold several dimensions
_COORDINATES = ("X", "Y", "Z")
COLORS: tuple[str, ...] = ("red", "green", "blue")
NORMALS: tuple[str, ...] = ("NormalX", "NormalY", "NormalZ")
_NAMES_OF_NORMALS = (NORMALS, ("normal x", "normal y", "normal z"))  # the latter are Metashape's


@dataclass(frozen=True)
class LasFile:
    """A file whose header and layout are known to be right.

    Attributes:
        path: The file.
        source: Its bytes.
        header: What its header says.
        layout: laspy's PointFormat: the dimensions of a point.
    """

    path: Path
    source: Source
    header: LasHeader
    layout: Any

    def rows(self, size: int) -> Iterator[NDArray[Any]]:
        """The points as they lie in an uncompressed file, at most `size` of them at a time."""
        row = self.layout.dtype()
        if self.header.is_compressed:
            for block in unpack_blocks(self.path, self.header, size):
                yield np.frombuffer(block, row)
            return
        rows = np.frombuffer(self.source, row, self.header.point_count, self.header.begin)
        for begin in range(0, len(rows), size):
            yield rows[begin : begin + size]

    def blocks(self, size: int) -> Iterator[dict[str, NDArray[Any]]]:
        """The points as columns, at most `size` of them at a time; first a block of none, which tells the types."""
        yield self.decode(np.empty(0, self.layout.dtype()))
        for rows in self.rows(size):
            yield self.decode(rows)

    def sample(self, count: int) -> PointTable:
        """At most so many points, evenly over the file, or of a compressed one the first of each chunk.

        Colours are of 255 where all of these look so.
        """
        row = self.layout.dtype()
        if self.header.is_compressed:
            rows = np.frombuffer(unpack_beginnings(self.path, self.header, count), row)
        else:
            rows = np.frombuffer(self.source, row, self.header.point_count, self.header.begin)
            rows = np.ascontiguousarray(rows[:: -(-len(rows) // count) or 1])
        arrays = self.decode(rows)
        if "colors" in arrays:
            _scale_colors(arrays["colors"])
        return table_of(self, arrays)

    @quiet()
    def decode(self, rows: Any) -> dict[str, NDArray[Any]]:
        """Positions as "points", colours as stored as "colors", any other dimension by its name behind a dot."""
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
            columns["." + name] = np.asarray(record[name]) if is_standard else decode_extra(dimension, rows[name])
        return columns


def open_las(path: str | os.PathLike[str], *, layers_too: bool = True) -> LasFile:
    """Open a file and hold it to its header and, if compressed, its table of chunks; no point is read.

    Without `layers_too` the chunks themselves are not looked into: see `check_laszip`.

    Raises:
        FileError: It cannot be read, is no LAS or LAZ file, or does not go with its header; or laspy is missing.
    """
    path = Path(path)
    source = open_source(path)
    header = parse_las_header(path, source)
    layout = layout_of(path, header)
    if header.is_compressed:
        check_laszip(path, source, header, layers_too=layers_too)
    return LasFile(path, source, header, layout)


def read_las(path: str | os.PathLike[str]) -> PointTable:
    """Read a LAS or LAZ file.

    Returns:
        The points, float64, with colours, normals and attributes.

    Raises:
        FileError: Missing, no LAS or LAZ file, truncated, or other than its header says; or laspy is missing.

    Notes:
        Memory: the result, and some 20 MB; for a LAZ file up to half as much again while it grows.
    """
    file = open_las(path)
    warn_of_wide_integers(path, file.layout)
    columns = GrowingColumns(file.header.point_count, is_proven=not file.header.is_compressed)
    for block in file.blocks(min(_BLOCK, _BLOCK_BYTES // file.header.record_length)):
        columns.append(block)
    arrays = columns.finish()
    if "colors" in arrays:
        _scale_colors(arrays["colors"])
    return table_of(file, arrays)


def _scale_colors(colors: NDArray[np.float32]) -> None:
    colors /= np.float32(255 if colors.max(initial=0) <= 255 else 65535)


def iterate_las(file: LasFile, chunk_size: int) -> Iterator[PointTable]:
    """Read an opened file in parts of `chunk_size` points, the last one shorter.

    Whether colours are of 255 or 65535 is settled by the first part that has any other than black.

    Raises:
        FileError: As `read_las`; also colours that turn out to be of 65535 after a part that looked like 255.
    """
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
                reason = "colours look like 8 bits in one part and like 16 in a later one"
                remedy = "Read it whole, or in larger parts"
                raise FileError(file.path, reason, where=f"points from {(number - 1) * chunk_size} on", remedy=remedy)
            block["colors"] /= np.float32(full or 65535)
        yield table_of(file, block)


def attribute_types(file: LasFile) -> dict[str, str]:
    """What a file holds beside positions: NumPy's types by the names that they have in a cloud."""
    table = table_of(file, next(file.blocks(1)))
    named = {"normals": table.normals, "colors": table.colors, **table.attributes}
    present = {name: values for name, values in named.items() if values is not None}
    return {name: f"{v.dtype}" + (f" x {v.shape[1]}" if v.ndim == 2 else "") for name, v in present.items()}


def scale_by(full: int, colors: NDArray[np.float32], path: Path, remedy: str) -> None:
    """Bring colours of some points to 0..1, in place, by the value of a full one that others have told.

    Raises:
        FileError: They exceed it.
    """
    if colors.max(initial=0) > full:
        reason = "colours look like 8 bits in its coarsest level and like 16 elsewhere"
        raise FileError(path, reason, remedy=remedy)
    colors /= np.float32(full)


def table_of(file: LasFile, arrays: dict[str, NDArray[Any]]) -> PointTable:
    """The table of columns as `decode` makes them, colours in 0..1."""
    attributes = {name[1:]: values for name, values in arrays.items() if name.startswith(".")}
    normals = None
    for names in _NAMES_OF_NORMALS:
        if normals is None and all(name in attributes and attributes[name].dtype.kind == "f" for name in names):
            normals = stack_normals(file.path, [attributes.pop(name) for name in names])
    steps = np.array(file.header.scales, np.float64)
    told, is_lonlat, units = arrays.get("colors"), is_geographic(file.header), units_of(file.header)
    how = {"steps": steps, "is_geographic": is_lonlat, "unit": units.plane, "unit_doubt": units.doubt}
    return PointTable(arrays["points"], normals, told, attributes, **how)


def layout_of(path: Any, header: LasHeader) -> Any:
    """The dimensions of a point: those of the format, those that the file describes, and what is left of its bytes.

    Raises:
        FileError: The record of extra dimensions is damaged or does not go with the points; or laspy is missing.
    """
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
