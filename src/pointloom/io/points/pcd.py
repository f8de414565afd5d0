"""PCD files (v0.7; .5 and .6 are read): text, binary and LZF-compressed binary.

Colors are rgb or rgba (4 bytes 0xAARRGGBB) or r g b. Alpha is the uint8 attribute `alpha`. Other fields are attributes
of shape (n, COUNT). VIEWPOINT is stored but not applied, as in PCL. PCL's format description; pcl/io/src/pcd_io.cpp.
"""

from __future__ import annotations

import warnings
from collections.abc import Container, Mapping, Sequence
from pathlib import Path
from typing import IO, Any, Literal

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ..ascii_rows import CHUNK_ROWS, AsciiRows, write_rows
from ..attribute_names import NameRules, is_word
from ..columns import check_name, check_types, colors_to_bytes, own, stack_colors, stack_normals, stack_points
from ..fixed_rows import NO_TABLE, Column, FixedRows
from ..source import SourceFile, check_end, open_source
from ..table import PointTable
from . import lzf
from .header_units import reference_comments
from .pcd_header import ENCODINGS, IDENTITY_VIEWPOINT, Field, PcdHeader, read_header

PACKED = ("rgb", "rgba")  # fields of colors 0xAARRGGBB
UNREADABLE = "the text of field {!r} is nan, as PCL wrote colors with red from 128 on; write the file as binary"


def read_payload(path: FilePath, source: SourceFile, header: PcdHeader) -> dict[str, NDArray[Any]]:
    """Decode all fields except padding to arrays (n,) or (n, c), which may be views. Raises `FileError` if damaged."""
    if header.encoding == "ascii":
        return _read_ascii(path, source, header)
    if header.encoding == "binary":
        return point_rows(path, source, header).columns()
    return _read_compressed(path, source, header)


def point_rows(path: FilePath, source: SourceFile, header: PcdHeader) -> FixedRows:
    """The points of the binary encoding, after checking the file against its header."""
    _check_positions(path, {field.name: (field.dtype, field.count) for field in header.fields})
    needed = header.point_count * header.point_bytes
    _check_size(path, source, header.size, needed)
    columns, offset = {}, 0
    for field in header.fields:
        if field.name != "_":
            columns[field.name] = Column(field.dtype, offset, field.count)
        offset += field.byte_count
    return FixedRows(source, header.size, header.point_count, offset, columns)


def _strided(source: bytes, offset: int, field: Field, count: int, step: int) -> NDArray[Any]:
    if not count:
        return np.empty(_shape(0, field), field.dtype)
    return np.ndarray(
        _shape(count, field), field.dtype, source, offset, (step, field.dtype.itemsize)[: 1 + (field.count > 1)]
    )


def _shape(count: int, field: Field) -> tuple[int, ...]:
    return (count, field.count) if field.count > 1 else (count,)


def _check_size(path: FilePath, source: SourceFile, offset: int, needed: int) -> None:
    available = len(source) - offset
    if needed > available:
        raise FileError(
            path,
            f"truncated: the payload needs {needed} bytes, {available} are left ({needed - available} missing)",
            where=f"byte {len(source)}",
        )
    check_end(path, source, offset + needed)


def _read_compressed(path: FilePath, source: SourceFile, header: PcdHeader) -> dict[str, NDArray[Any]]:
    begin = header.size + 8
    if len(source) < begin:
        raise FileError(path, "truncated: the two sizes before the payload are missing", where=f"byte {len(source)}")
    packed, size = (int(k) for k in np.frombuffer(source[header.size : begin], "<u4"))
    needed = header.point_count * header.point_bytes
    if size != needed:
        reason = f"the payload unpacks to {size} bytes, but {header.point_count} points need {needed}"
        raise FileError(path, reason, where=f"byte {header.size + 4}")
    _check_size(path, source, begin, packed)
    try:
        body = lzf.decompress(bytes(source[begin : begin + packed]), size)
    except lzf.LzfError as error:
        raise FileError(path, f"damaged LZF payload: {error}", where=f"byte {begin + error.position}") from error
    fields: dict[str, NDArray[Any]] = {}
    offset = 0
    for field in header.fields:  # structure of arrays: all values of one field, then the next field's
        if field.name != "_":
            fields[field.name] = _strided(body, offset, field, header.point_count, field.byte_count)
        offset += field.byte_count * header.point_count
    return fields


def _read_ascii(path: FilePath, source: SourceFile, header: PcdHeader) -> dict[str, NDArray[Any]]:
    rows = AsciiRows(path, bytes(source[header.size :]), header.line_count + 1)
    count, width = header.point_count, sum(field.count for field in header.fields)
    if rows.row_count < count:
        raise FileError(path, f"truncated: {rows.row_count} of {count} points", where=rows.where(rows.row_count))
    if rows.row_count > count:
        raise FileError(
            path, f"{rows.row_count - count} lines follow the declared {count} points", where=rows.where(count)
        )
    rows.check_width(0, count, width)
    table = rows.numbers().reshape(count, width)
    unmeasured = _unmeasured(header, table)
    words: list[bytes] | None = None
    fields: dict[str, NDArray[Any]] = {}
    column = 0
    for field in header.fields:
        if field.name != "_":
            parts = []
            for k in range(column, column + field.count):
                if field.name in PACKED and field.dtype == np.float32:
                    parts.append(_packed_floats(table[:, k], unmeasured))
                elif field.dtype.kind in "iu" and field.dtype.itemsize == 8:  # float64 stores 53 bits of these
                    words = rows.words() if words is None else words
                    parts.append(_exact_integers(path, rows, words[k::width], field))
                else:
                    parts.append(rows.cast(table[:, k], field.dtype, field.name, 0))
            if any(part is None for part in parts):
                message = f"{path}: colors are left out: {UNREADABLE.format(field.name)}"
                warnings.warn(escaped(message), UserWarning, stacklevel=7)
            else:
                fields[field.name] = parts[0] if field.count == 1 else np.stack(parts, axis=1)
        column += field.count
    return fields


def _unmeasured(header: PcdHeader, table: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Mask of text points with NaN x, y and z, whose color is irrelevant."""
    ends = np.cumsum([field.count for field in header.fields])
    columns = [end - 1 for field, end in zip(header.fields, ends, strict=True) if field.name in ("x", "y", "z")]
    return np.asarray(np.isnan(table[:, columns]).all(axis=1))


def _packed_floats(column: NDArray[np.float64], unmeasured: NDArray[np.bool_]) -> NDArray[np.float32] | None:
    """Packed text colors as floats, bitwise identical. None if some are "nan". Integers are the packed value itself."""
    if (np.isnan(column) & ~unmeasured).any():
        return None
    known = np.where(np.isnan(column), 0.0, column)
    if (np.abs(known) >= 1).any() and ((known >= -(2**31)) & (known < 2**32) & (known == np.floor(known))).all():
        return known.astype("<i8").astype("<u4").view("<f4")
    with np.errstate(over="ignore"):
        return known.astype("<f4")


def _exact_integers(path: FilePath, rows: AsciiRows, words: list[bytes], field: Field) -> NDArray[Any]:
    limits = np.iinfo(field.dtype)
    column = np.empty(len(words), field.dtype)
    for row, word in enumerate(words):
        digits = word[1:] if word[:1] in b"+-" and len(word) > 1 else word
        value = int(word) if digits.isdigit() and len(digits) < 40 else None
        if value is None or not limits.min <= value <= limits.max:
            shown = word[:40].decode("ascii", "backslashreplace")
            reason = f"{field.name}: {shown} does not fit the declared type {field.dtype.name}"
            raise FileError(path, reason, where=rows.where(row))
        column[row] = value
    return column


_POINTS: tuple[str, ...] = ("x", "y", "z")
_NORMALS: tuple[str, ...] = ("normal_x", "normal_y", "normal_z")
_CHANNELS = ("r", "g", "b")
TYPES = "i1 u1 i2 u2 i4 u4 i8 u8 f4 f8"
_TYPE_REMEDY = "Convert it to an integer, float32 or float64, or write NPZ, or pass drop_unsupported=True"


def read_pcd(path: FilePath, *, source: SourceFile | None = None) -> PointTable:
    """Read a PCD file in any encoding, with the stored number type and the grid of an organized cloud.

    `source` is the open file. Warns if WIDTH x HEIGHT is 0 and POINTS is not. Compressed files are unpacked in Python
    at about 10 to 20 MB/s.
    """
    path = Path(path)
    source = source or open_source(path)
    header = read_header(path, source)
    table = _table(path, source, header)
    table.grid = (header.height, header.width) if header.height > 1 and header.point_count else None
    table.viewpoint = header.viewpoint
    return table


def _table(path: Path, source: SourceFile, header: PcdHeader) -> PointTable:
    _check_positions(path, {field.name: (field.dtype, field.count) for field in header.fields})
    if header.encoding != "binary":
        return table_of(path, read_payload(path, source, header))
    rows = point_rows(path, source, header)
    try:
        return rows.table(lambda fields, out: table_of(path, fields, out))
    except FileError:  # of a row whose number is known for all rows only
        return table_of(path, rows.columns())


def table_of(path: Path, fields: Mapping[str, NDArray[Any]], out: PointTable | None = None) -> PointTable:
    """Copy fields, or some rows, into a point table, or into `out`."""
    fields, given = dict(fields), NO_TABLE if out is None else out
    roles = _role_names(fields, {name: values.ndim for name, values in fields.items()})
    points, normals, colors = stack_points([fields.pop(name) for name in _POINTS], given.points), None, None
    if "normals" in roles:
        normals = stack_normals(path, [fields.pop(name) for name in _NORMALS], given.normals)
    if "packed" in roles:
        name = roles["packed"][0]
        colors, alpha = _unpack_colors(path, name, fields.pop(name), given.colors)
        if name == "rgba":
            if "alpha" in fields:
                raise FileError(path, "the fields 'alpha' and 'rgba' conflict")
            fields["alpha"] = alpha
    elif "channels" in roles:
        colors = stack_colors(path, [fields.pop(name) for name in _CHANNELS], given.colors)
    attributes = {name: own(values, given.attributes.get(name)) for name, values in fields.items()}
    return PointTable(points, normals, colors, attributes)


def warn_of_viewpoint(path: FilePath, viewpoint: tuple[float, ...] | None, stacklevel: int = 3) -> None:
    if viewpoint is not None:
        numbers = " ".join(f"{value:g}" for value in viewpoint)
        message = (
            f"{path}: VIEWPOINT {numbers} (position, quaternion w x y z) is not applied: if the points are in the "
            "sensor's frame, cloud.transform with this pose places them"
        )
        warnings.warn(escaped(message), UserWarning, stacklevel=stacklevel + 1)


def write_pcd(
    path: FilePath,
    table: PointTable,
    *,
    encoding: Literal["binary", "ascii", "binary_compressed"] = "binary",
    overwrite: bool = True,
) -> None:
    """Write points as PCD v0.7 atomically. A grid becomes WIDTH and HEIGHT.
    All encodings read back bitwise, with 8-bit colors. Compression runs in Python at about 5 MB/s, up to 4 GiB."""
    if encoding not in ENCODINGS:
        raise ValueError(f"encoding: expected one of {', '.join(ENCODINGS)}, got {encoding!r}")
    path = check_writable(path, overwrite=overwrite)
    table = table.checked()
    fields = _fields(path, table)
    if encoding == "binary_compressed" and sum(values.nbytes for values in fields.values()) >= 2**32:
        raise FileError(path, "a compressed PCD is limited to 4 GiB", remedy="Write encoding='binary'")
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(_header(table, fields, encoding))
        if encoding == "ascii":
            write_rows(file, [column for values in fields.values() for column in np.atleast_2d(values.T)])
        elif encoding == "binary":
            _write_binary(file, fields)
        else:
            body = b"".join(values.astype(values.dtype.newbyteorder("<")).tobytes() for values in fields.values())
            packed = lzf.compress(body)
            file.write(np.array([len(packed), len(body)], "<u4").tobytes() + packed)


def _check_positions(path: FilePath, fields: dict[str, tuple[np.dtype[Any], int]]) -> None:
    missing = [name for name in _POINTS if name not in fields]
    if missing:
        names = ", ".join(list(fields)[:20])
        raise FileError(path, f"there is no field {', '.join(missing)} (the fields are {names})")
    for name in _POINTS:
        dtype, count = fields[name]
        if dtype.kind != "f" or count != 1:
            raise FileError(
                path, f"field {name!r} is {count} x {dtype.name}; positions are one float32 or float64 each"
            )


def _role_names(names: Container[str], dims: dict[str, int]) -> dict[str, tuple[str, ...]]:
    """The fields of normals ("normals") and colors ("packed" in one field, or "channels")."""
    single = [name for name, dim in dims.items() if dim == 1]
    roles: dict[str, tuple[str, ...]] = {}
    if all(name in single for name in _NORMALS):
        roles["normals"] = _NORMALS
    packed = next((name for name in PACKED if name in names), None)
    if packed is not None:
        roles["packed"] = (packed,)
    elif all(name in single for name in _CHANNELS):
        roles["channels"] = _CHANNELS
    return roles


def _unpack_colors(
    path: FilePath, name: str, packed: NDArray[Any], out: NDArray[Any] | None
) -> tuple[NDArray[np.float32], NDArray[np.uint8]]:
    """Colors (n, 3) and alpha (n,) from packed bytes 0xAARRGGBB."""
    if packed.dtype.itemsize != 4 or packed.ndim != 1:
        raise FileError(path, f"field {name!r}: expected one value of 4 bytes, got {packed.dtype.name}")
    channels = np.ascontiguousarray(packed).astype(packed.dtype.newbyteorder("<"), copy=False).view(np.uint8)
    channels = channels.reshape(-1, 4)
    return stack_colors(path, [channels[:, 2], channels[:, 1], channels[:, 0]], out), channels[:, 3]


def name_rules(_path: FilePath, table: PointTable) -> NameRules:
    used = {*_POINTS, *PACKED, "_", *(_NORMALS if table.normals is not None else ())}
    roles = [*([_NORMALS] if table.normals is None else []), *([_CHANNELS] if table.colors is None else [])]
    return NameRules(is_word, used, roles, in_parts=False)


def _fields(path: FilePath, table: PointTable) -> dict[str, NDArray[Any]]:
    """Fields by name in file order. Raises if one would not read back."""
    attributes = dict(table.attributes)
    fields: dict[str, NDArray[Any]] = dict(zip(_POINTS, table.points.T, strict=True))
    expected: dict[str, tuple[str, ...]] = {}
    if table.normals is not None:
        fields |= dict(zip(_NORMALS, table.normals.T, strict=True))
        expected["normals"] = _NORMALS
    if table.colors is not None:
        alpha = attributes.get("alpha")
        with_alpha = alpha is not None and alpha.dtype == np.uint8 and alpha.ndim == 1
        channels = np.zeros((len(table.points), 4), np.uint8)
        channels[:, :3] = colors_to_bytes(path, table.colors)[:, ::-1]
        if with_alpha:
            channels[:, 3] = attributes.pop("alpha")
        name = "rgba" if with_alpha else "rgb"
        fields[name] = channels.view("<u4")[:, 0]
        expected["packed"] = (name,)
    check_types(path, attributes, TYPES, _TYPE_REMEDY)
    for name, values in attributes.items():
        check_name(path, name)
        if name in fields or name == "_":
            raise FileError(path, f"attribute {name!r}: the format uses this name itself", remedy="Rename it")
        fields[name] = values[:, 0] if values.ndim == 2 and values.shape[1] == 1 else values
    roles = _role_names(fields, {name: values.ndim for name, values in fields.items()})
    if roles != expected:
        names: Sequence[str] = [name for key, names in roles.items() if expected.get(key) != names for name in names]
        reason = f"the attributes {', '.join(names)} would be read as normals or colors"
        raise FileError(path, reason, remedy="Rename one of them")
    return fields


def _header(table: PointTable, fields: dict[str, NDArray[Any]], encoding: str) -> bytes:
    height, width = table.grid or (1, len(table.points))
    viewpoint = " ".join(np.format_float_positional(value, trim="-") for value in table.viewpoint or IDENTITY_VIEWPOINT)
    counts = [1 if values.ndim == 1 else values.shape[1] for values in fields.values()]
    return "\n".join(
        [
            "# .PCD v0.7 - Point Cloud Data file format",
            *(f"# {comment}" for comment in reference_comments(table)),
            "VERSION 0.7",
            "FIELDS " + " ".join(fields),
            "SIZE " + " ".join(str(values.dtype.itemsize) for values in fields.values()),
            "TYPE " + " ".join(values.dtype.kind.upper() for values in fields.values()),
            "COUNT " + " ".join(str(count) for count in counts),
            f"WIDTH {width}",
            f"HEIGHT {height}",
            f"VIEWPOINT {viewpoint}",
            f"POINTS {len(table.points)}",
            f"DATA {encoding}",
            "",
        ]
    ).encode("ascii")


def _write_binary(file: IO[bytes], fields: dict[str, NDArray[Any]]) -> None:
    row = np.dtype([(name, values.dtype.newbyteorder("<"), values.shape[1:]) for name, values in fields.items()])
    count = len(next(iter(fields.values())))
    for begin in range(0, count, CHUNK_ROWS):
        packed = np.empty(min(CHUNK_ROWS, count - begin), row)
        for name, values in fields.items():
            packed[name] = values[begin : begin + CHUNK_ROWS]
        file.write(packed.tobytes())
