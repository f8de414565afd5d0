"""The Extra Bytes record of LAS: types, scales, no_data values, ranges and descriptions.

laspy ignores no_data values when reading and computes ranges from single points when writing. ASPRS, LAS Specification
1.4-R15 (table 24, Extra Bytes).
"""

from __future__ import annotations

import struct
import warnings
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.errors import FilePath
from ...core.escaped_text import escaped
from .las_header import SPEC

EXTRA_BYTES = (SPEC, 4)
TITLE = "Extra Bytes Record"
TYPES = ("u1", "i1", "u2", "i2", "u4", "i4", "u8", "i8", "f4", "f8")  # the data types 1 to 10 of the record

_ENTRY = struct.Struct("<2sBB32s4s24s24s24s3d3d32s")
_NO_DATA_BYTES, _TEXT_BYTES = slice(40, 64), (slice(4, 36), slice(160, 192))
_NO_DATA_BIT, _MIN_BIT, _MAX_BIT, _SCALE_BIT, _OFFSET_BIT = 1, 2, 4, 8, 16
_WIDE = {"u": "<u8", "i": "<i8", "f": "<f8"}  # the types of no_data values and ranges
_WITH_NAN: dict[int, str] = {1: "f4", 2: "f4", 4: "f8"}  # float types by the size of the integers that they represent


def parameters_of(known: Any, data: bytes) -> list[Any]:
    """Parse the record to laspy's ExtraBytesParams with no_data values; `known` is the module `laspy.vlrs.known`."""
    record = known.ExtraBytesVlr()
    record.parse_record_data(b"".join(_with_utf8(data[k : k + _ENTRY.size]) for k in range(0, len(data), _ENTRY.size)))
    parameters = record.type_of_extra_dims()
    for described, dimension in zip(record.extra_bytes_structs, parameters, strict=True):
        if not described.data_type:  # untyped bytes: the options are their count
            dimension.scales = dimension.offsets = None
        elif described.options & _NO_DATA_BIT:
            kind = dimension.type.base
            no_data = np.frombuffer(bytes(described)[_NO_DATA_BYTES], _WIDE[kind.kind])[: described.num_elements()]
            dimension.no_data = no_data.astype(kind) if kind.kind == "f" else no_data
    return parameters


def _with_utf8(entry: bytes) -> bytes:
    """An entry with name and description in UTF-8. Other encodings are read as Latin-1."""
    for field in _TEXT_BYTES:
        text = entry[field].split(b"\0")[0]
        try:
            text.decode()
        except UnicodeDecodeError:
            entry = entry[: field.start] + _fitting(text.decode("latin-1")).ljust(32, b"\0") + entry[field.stop :]
    return entry


def _fitting(text: str) -> bytes:
    """UTF-8 of at most 32 bytes, cut at a character."""
    return text.encode()[:32].decode(errors="ignore").encode()


@quiet()
def decode_extra(dimension: Any, raw: NDArray[Any]) -> NDArray[Any]:
    """Scaled values of an extra dimension, NaN for no_data.
    Integers with no_data become float32 (8 and 16 bits) or float64 (32 bits). 64-bit integers are unchanged."""
    values = raw * dimension.scales + dimension.offsets if dimension.is_scaled else raw
    kind = _type_with_nan(dimension)
    if kind is None:
        return values
    values = values.astype(kind, copy=not dimension.is_scaled)
    values[raw == dimension.no_data] = np.nan
    return values


def _type_with_nan(dimension: Any) -> np.dtype[Any] | None:
    """The type of values with NaN. None without no_data or if no type fits."""
    if dimension.no_data is None:
        return None
    if dimension.is_scaled:
        return np.dtype("f8")
    kind = dimension.dtype.base
    code = kind.str[1:] if kind.kind == "f" else _WITH_NAN.get(kind.itemsize)
    return None if code is None else np.dtype(code)


def warn_of_wide_integers(path: FilePath, layout: Any) -> None:
    for dimension in layout.extra_dimensions:
        if dimension.no_data is not None and _type_with_nan(dimension) is None:
            message = (
                f"{path}: attribute {dimension.name!r}: missing values are {dimension.no_data.tolist()[0]}, since "
                "integers of 64 bits have no NaN. Replace them before computing with the attribute."
            )
            warnings.warn(escaped(message), UserWarning, stacklevel=4)


class ExtraColumn(NamedTuple):
    """An extra dimension as stored: value = stored * `scale` + `offset` (None: unscaled); `no_data` or None."""

    values: NDArray[Any]
    description: str = ""
    scale: float | None = None
    offset: float | None = None
    no_data: Any = None


def store_extra(columns: dict[str, NDArray[Any]], layout: Any) -> dict[str, ExtraColumn]:
    """Choose the storage of columns (n,): as in another file's `layout` if lossless."""
    known = {} if layout is None else _known(layout)
    stored = {}
    for name, values in columns.items():
        stored[name] = _stored_like(values, *known[name]) if name in known else ExtraColumn(values)
    return stored


def _known(layout: Any) -> dict[str, tuple[Any, int]]:
    """The extra dimensions of a file and their components, by written name."""
    known = {}
    for dimension in layout.extra_dimensions:
        for k in range(dimension.num_elements):
            known[dimension.name if dimension.num_elements == 1 else f"{dimension.name}_{k}"] = (dimension, k)
    return known


@quiet()
def _stored_like(values: NDArray[Any], dimension: Any, k: int) -> ExtraColumn:
    """A column stored like component `k` of a dimension, or in its own type if that would change a value."""
    kind, description = dimension.dtype.base, dimension.description
    if f"{kind.kind}{kind.itemsize}" not in TYPES:
        return ExtraColumn(values, description)
    scale = offset = None
    if dimension.is_scaled:
        scale, offset = float(dimension.scales[k]), float(dimension.offsets[k])
    no_data = None if dimension.no_data is None else dimension.no_data[k]
    raw = values if scale is None or offset is None else np.rint((values - offset) / scale)
    if no_data is not None and raw.dtype.kind == "f":
        raw = np.where(np.isnan(raw), no_data, raw)
    if kind.kind != "f" and raw.dtype.kind == "f":
        limits = np.iinfo(kind)
        if not ((raw >= limits.min) & (raw < limits.max + 1.0)).all():
            return ExtraColumn(values, description)
    stored = ExtraColumn(raw.astype(kind, copy=False), description, scale, offset, no_data)
    back = stored.values if scale is None or offset is None else stored.values * scale + offset
    if _type_with_nan(dimension) is not None:
        back = np.where(stored.values == no_data, np.nan, back)
    same = (back == values) | (back != back) & (values != values)
    return stored if same.all() else ExtraColumn(values, description)


def record_of(columns: dict[str, ExtraColumn], *, with_ranges: bool) -> bytes:
    """The content of the record; `with_ranges` writes minima and maxima and requires the columns of all points."""
    entries = []
    for name, column in columns.items():
        kind, options = column.values.dtype, 0
        ends = _range_of(column) if with_ranges else None
        scaled = _SCALE_BIT | _OFFSET_BIT
        for bit, value in ((_NO_DATA_BIT, column.no_data), (_MIN_BIT | _MAX_BIT, ends), (scaled, column.scale)):
            options |= bit if value is not None else 0
        low, high = (0, 0) if ends is None else ends
        no_data = 0 if column.no_data is None else column.no_data
        numbers = [np.array([value]).astype(_WIDE[kind.kind]).tobytes() for value in (no_data, low, high)]
        scaling = (column.scale or 0.0, 0.0, 0.0, column.offset or 0.0, 0.0, 0.0)
        number = TYPES.index(f"{kind.kind}{kind.itemsize}") + 1
        description = _fitting(column.description)
        entries.append(_ENTRY.pack(b"", number, options, name.encode(), b"", *numbers, *scaling, description))
    return b"".join(entries)


def value_record(layout: Any) -> tuple[bytes, int]:
    """The record of the extra dimensions in their value types, and its size per point, for possibly modified points."""
    columns = {}
    for name, (dimension, _) in _known(layout).items():
        empty = decode_extra(dimension, np.empty((0, *dimension.dtype.shape), dimension.dtype.base))
        columns[name] = ExtraColumn(empty.ravel(), dimension.description)
    size = sum(column.values.dtype.itemsize for column in columns.values())
    return record_of(columns, with_ranges=False), size


def join_ranges(records: Sequence[bytes]) -> bytes:
    """The record of several files with equal extra dimensions, with the common range."""
    joined = []
    for entries in zip(*([*_ENTRY.iter_unpack(record)] for record in records), strict=True):
        fields = [*entries[0]]
        dtype = np.dtype("<f8" if fields[1] > 8 else "<i8" if fields[1] % 2 == 0 else "<u8")
        fields[2] &= ~(_MIN_BIT | _MAX_BIT)
        for index, bit, end in ((6, _MIN_BIT, min), (7, _MAX_BIT, max)):
            ends = [np.frombuffer(entry[index], dtype)[0] for entry in entries if entry[2] & bit]
            if ends:
                fields[2] |= bit
                fields[index] = np.array([end(ends)]).tobytes()
        joined.append(_ENTRY.pack(*fields))
    return b"".join(joined)


def _range_of(column: ExtraColumn) -> tuple[Any, Any] | None:
    values = column.values
    if column.no_data is not None:
        values = values[values != column.no_data]
    if values.dtype.kind == "f":
        values = values[~np.isnan(values)]
    return (values.min(), values.max()) if len(values) else None
