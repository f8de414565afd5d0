"""The payload of a PCD file as one array a field, held to the header in every byte or line."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ...core.escaped_text import escaped
from ..ascii_rows import AsciiRows
from ..source import Source
from . import lzf
from .pcd_header import Field, PcdHeader

PACKED = ("rgb", "rgba")  # fields of colours 0xAARRGGBB
UNREADABLE = "the text of field {!r} is nan, as PCL wrote colours with red from 128 on; write the file as binary"

# PCL up to 1.7 sizes a compressed file as if the payload began on the second memory page, and so leaves this many zero
# bytes less the length of the header behind it.
_PAGE_BYTES = 4096


def read_payload(path: Any, source: Source, header: PcdHeader) -> dict[str, NDArray[Any]]:
    """Decode every field but the padding.

    Returns:
        Arrays of shape [n], or [n, c] for a field of c > 1 values; they may be views into `source`.

    Raises:
        FileError: Truncated, longer than declared, or (compressed) damaged.
    """
    if header.encoding == "ascii":
        return _read_ascii(path, source, header)
    if header.encoding == "binary":
        _check_size(path, source, header.size, header.point_count * header.point_bytes)
        return _rows(source, header.size, header)
    return _read_compressed(path, source, header)


def _rows(source: Source, offset: int, header: PcdHeader) -> dict[str, NDArray[Any]]:
    """Fields of points that lie one after another."""
    fields: dict[str, NDArray[Any]] = {}
    for field in header.fields:
        if field.name != "_":
            fields[field.name] = _strided(source, offset, field, header.point_count, header.point_bytes)
        offset += field.byte_count
    return fields


def _strided(source: Source, offset: int, field: Field, count: int, step: int) -> NDArray[Any]:
    if not count:
        return np.empty(_shape(0, field), field.dtype)
    return np.ndarray(
        _shape(count, field), field.dtype, source, offset, (step, field.dtype.itemsize)[: 1 + (field.count > 1)]
    )


def _shape(count: int, field: Field) -> tuple[int, ...]:
    return (count, field.count) if field.count > 1 else (count,)


def _check_size(path: Any, source: Source, offset: int, needed: int) -> None:
    available = len(source) - offset
    if needed > available:
        raise FileError(
            path,
            f"truncated: the payload needs {needed} bytes, {available} are left ({needed - available} missing)",
            where=f"byte {len(source)}",
        )
    if needed < available:
        raise FileError(
            path,
            f"{available - needed} bytes follow the declared payload",
            where=f"byte {offset + needed}",
            remedy="The counts in the header are too small, or the file was damaged",
        )


def _read_compressed(path: Any, source: Source, header: PcdHeader) -> dict[str, NDArray[Any]]:
    begin = header.size + 8
    if len(source) < begin:
        raise FileError(path, "truncated: the two sizes before the payload are missing", where=f"byte {len(source)}")
    packed, size = (int(k) for k in np.frombuffer(source[header.size : begin], "<u4"))
    needed = header.point_count * header.point_bytes
    if size != needed:
        reason = f"the payload unpacks to {size} bytes, but {header.point_count} points need {needed}"
        raise FileError(path, reason, where=f"byte {header.size + 4}")
    slack = bytes(source[begin + packed : begin + packed + _PAGE_BYTES])
    if len(slack) == _PAGE_BYTES or any(slack):
        slack = b""
    _check_size(path, source, begin, packed + len(slack))
    try:
        body = lzf.decompress(bytes(source[begin : begin + packed]), size)
    except lzf.LzfError as error:
        raise FileError(path, f"damaged LZF payload: {error}", where=f"byte {begin + error.position}") from error
    fields: dict[str, NDArray[Any]] = {}
    offset = 0
    for field in header.fields:  # one field's values of all points, then the next field's
        if field.name != "_":
            fields[field.name] = _strided(body, offset, field, header.point_count, field.byte_count)
        offset += field.byte_count * header.point_count
    return fields


def _read_ascii(path: Any, source: Source, header: PcdHeader) -> dict[str, NDArray[Any]]:
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
                    parts.append(_packed_floats(path, table[:, k], unmeasured))
                elif field.dtype.kind in "iu" and field.dtype.itemsize == 8:  # float64 holds 53 bits of these
                    words = rows.words() if words is None else words
                    parts.append(_exact_integers(path, rows, words[k::width], field))
                else:
                    parts.append(rows.cast(table[:, k], field.dtype, field.name, 0))
            if any(part is None for part in parts):
                message = f"{path}: colours are left out: {UNREADABLE.format(field.name)}"
                warnings.warn(escaped(message), UserWarning, stacklevel=7)
            else:
                fields[field.name] = parts[0] if field.count == 1 else np.stack(parts, axis=1)
        column += field.count
    return fields


def _unmeasured(header: PcdHeader, table: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which points of a text have NaN for all of x, y and z, so that their colour does not matter."""
    ends = np.cumsum([field.count for field in header.fields])
    places = [end - 1 for field, end in zip(header.fields, ends, strict=True) if field.name in ("x", "y", "z")]
    return np.asarray(np.isnan(table[:, places]).all(axis=1))


def _packed_floats(path: Any, column: NDArray[np.float64], unmeasured: NDArray[np.bool_]) -> NDArray[np.float32] | None:
    """Packed colours of a text as the floats that have their bits; None if "nan" stands for some of them.

    Whole numbers are the packed number itself, as some programs write it: the float of a colour is none.
    """
    if (np.isnan(column) & ~unmeasured).any():
        return None
    known = np.where(np.isnan(column), 0.0, column)
    if (np.abs(known) >= 1).any() and ((known >= -(2**31)) & (known < 2**32) & (known == np.floor(known))).all():
        return known.astype("<i8").astype("<u4").view("<f4")
    with np.errstate(over="ignore"):
        return known.astype("<f4")


def _exact_integers(path: Any, rows: AsciiRows, words: list[bytes], field: Field) -> NDArray[Any]:
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
