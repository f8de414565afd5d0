"""Points as NPY: an array of shape (n, 3), or a structured array with the fields x, y and z.

Other fields are normals (nx, ny, nz), colors (red, green, blue, or r, g, b) and attributes. `xyz`, `points`, `normals`,
`rgb` and `colors` can be fields of three numbers. Pickles are never loaded. NumPy Enhancement Proposal 1 (.npy).
"""

from __future__ import annotations

import io
import math
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError, FilePath
from ..attribute_names import NameRules
from ..columns import roles_in_lower_case, stack_colors, stack_normals, stack_points
from ..npy_header import MAX_HEADER_BYTES, read_npy_header, read_structured_header
from ..optional_imports import foreign_errors
from ..source import SourceFile, check_end, open_source
from ..table import PointTable
from .text_table import check_columns

_POINTS, _NORMALS, _COLORS = ("x", "y", "z"), ("nx", "ny", "nz"), ("red", "green", "blue")
_OTHER_NAMES = {"r": "red", "g": "green", "b": "blue"}
_VECTORS = {"xyz": _POINTS, "points": _POINTS, "normals": _NORMALS, "rgb": _COLORS, "colors": _COLORS}


def read_npy_points(path: FilePath, columns: Sequence[str] | None = None) -> PointTable:
    """Read points from a .npy file. `columns` are the names of the columns of an array that is not structured."""
    path = Path(path)
    source = open_source(path)
    header = read_structured_header(path, source)
    if header is None:
        rows = _plain_rows(path, source)
        names = [*_POINTS] if columns is None else check_columns(columns)
        if rows.ndim != 2 or rows.shape[1] != len(names):
            reason = f"expected shape [n, {len(names)}] for {', '.join(names)}, got {list(rows.shape)}"
            remedy = "Give columns= with the names of all columns" if rows.ndim == 2 else ""
            raise FileError(path, reason, remedy=remedy)
        return _table_of(path, dict(zip(names, rows.T, strict=True)))
    if columns is not None:
        raise FileError(path, "its array is structured: the columns have names", remedy="Leave out columns=")
    begin, count, dtype = header
    rows = source.array(dtype, count, begin)
    names = [name for name in dtype.names or () if dtype[name].kind != "V" or dtype[name].subdtype]
    return _table_of(path, {name: rows[name] for name in names})


def _plain_rows(path: Path, source: SourceFile) -> NDArray[Any]:
    """The array of a file whose array is not structured."""
    stream = io.BytesIO(source[0:MAX_HEADER_BYTES])
    with foreign_errors(path, "the array's header is damaged"):
        shape, is_by_columns, dtype = read_npy_header(stream)
    if dtype.kind not in "biuf" or dtype.itemsize > 8:
        raise FileError(path, f"expected real numbers, got {dtype}")
    begin, needed = stream.tell(), math.prod(shape) * dtype.itemsize
    if needed > len(source) - begin:
        reason = f"an array of {dtype} {list(shape)} needs {needed} bytes, but has {len(source) - begin}"
        raise FileError(path, reason, where=f"byte {begin}")
    check_end(path, source, begin + needed)
    rows = source.array(dtype, math.prod(shape), begin).reshape(shape, order="F" if is_by_columns else "C")
    return rows.astype(dtype.newbyteorder("="), copy=False)


def _table_of(path: Path, columns: dict[str, NDArray[Any]]) -> PointTable:
    for name, parts in _VECTORS.items():
        if name in columns and columns[name].ndim == 2 and columns[name].shape[1] == 3 and parts[0] not in columns:
            columns = dict(zip(parts, columns[name].T, strict=True)) | columns
            del columns[name]
    spelled = roles_in_lower_case(list(columns), (_POINTS, _NORMALS, _COLORS, tuple(_OTHER_NAMES)))
    columns = {spelled.get(name, name): values for name, values in columns.items()}
    if all(name in columns for name in _OTHER_NAMES):
        columns = {_OTHER_NAMES.get(name, name): values for name, values in columns.items()}

    def taken(names: tuple[str, ...]) -> list[NDArray[Any]]:
        found = all(name in columns and columns[name].ndim == 1 for name in names)
        return [columns.pop(name) for name in names] if found else []

    position, normals, colors = taken(_POINTS), taken(_NORMALS), taken(_COLORS)
    if not position:
        names = ", ".join(list(columns)[:10]) or "no fields"
        raise FileError(path, f"there are no fields x, y and z (the array has {names})")
    return PointTable(
        stack_points(position),
        stack_normals(path, normals) if normals else None,
        stack_colors(path, colors) if colors else None,
        {name: values.astype(values.dtype.newbyteorder("="), copy=True) for name, values in columns.items()},
    )


def name_rules(_path: FilePath, table: PointTable) -> NameRules:
    used = (*_POINTS, *_NORMALS, *_COLORS, *_OTHER_NAMES, *_VECTORS)
    return NameRules(lambda letter: bool(re.fullmatch(r"[ -&(-\[\]-~]", letter)), used, in_parts=False)


def write_npy_points(path: FilePath, table: PointTable, *, overwrite: bool = True) -> None:
    """Write points atomically: as an array (n, 3), or as a structured array if there is more than positions."""
    path = check_writable(path, overwrite=overwrite)
    table = table.checked()
    columns: dict[str, NDArray[Any]] = {}
    for names, values in ((_POINTS, table.points), (_NORMALS, table.normals), (_COLORS, table.colors)):
        columns |= {} if values is None else dict(zip(names, values.T, strict=True))
    columns |= table.attributes
    array = np.ascontiguousarray(table.points)
    if len(columns) > len(_POINTS):
        layout = np.dtype([(name, values.dtype, values.shape[1:]) for name, values in columns.items()])
        array = np.empty(len(table.points), layout)
        for name, values in columns.items():
            array[name] = values
    with atomic_write(path, overwrite=overwrite) as file:
        np.lib.format.write_array(file, array, allow_pickle=False)
