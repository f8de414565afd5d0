"""PLY files of elements with scalar properties."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.checks import LARGEST_NUMBER
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.paths import path_of
from ...io.ascii_rows import write_rows
from ...io.points.ply_header import TYPE_NAMES, read_header
from ...io.points.ply_rows import read_rows
from ...io.source import open_source

Elements = dict[str, dict[str, Any]]
CHANNELS = ("red", "green", "blue")


def check_ply(filename: FilePath, format: str = "auto") -> Path:
    path = path_of(filename, "filename")
    if path.suffix.lower() != ".ply" or format not in ("auto", "ply"):
        raise ValueError(f"filename: expected a name that ends in .ply, got {escaped(path.name)}")
    return path


def read_elements(path: Path, *required: str) -> Elements:
    """Columns of each element, without lists. Raises FileError if a required element is missing."""
    source = open_source(path)
    header = read_header(path, source)
    for name in required:
        header.element(path, name)
    return read_rows(path, source, header, lambda element, prop: prop.count_type is None)


def numbers_of(path: Path, elements: Elements, element: str, *names: str) -> NDArray[np.float64]:
    """Columns of an element side by side. Raises FileError if one is missing, or a number is not finite."""
    columns = _columns_of(path, elements, element, *names).astype(np.float64)
    _check(path, element, names, columns, np.abs(columns) <= LARGEST_NUMBER, f"finite numbers up to {LARGEST_NUMBER:g}")
    return columns


def integers_of(path: Path, elements: Elements, element: str, *names: str, low: int, high: int) -> NDArray[np.int32]:
    """Integers from `low` to `high`, 32 bits at most, side by side. Raises FileError for other numbers."""
    columns = _columns_of(path, elements, element, *names)
    is_valid = (columns >= low) & (columns <= high) & (columns == np.floor(columns))
    _check(path, element, names, columns, is_valid, f"integers from {low} to {high}")
    return columns.astype(np.int32)


def colors_of(path: Path, elements: Elements, element: str) -> NDArray[np.float64] | None:
    """8-bit colors of an element as numbers in 0..1. None without colors."""
    if not any(name in elements[element] for name in CHANNELS):
        return None
    columns = _columns_of(path, elements, element, *CHANNELS)
    _check(path, element, CHANNELS, columns, (columns >= 0) & (columns <= 255), "colors from 0 to 255")
    return columns / 255


def _columns_of(path: Path, elements: Elements, element: str, *names: str) -> NDArray[Any]:
    missing = [name for name in names if name not in elements[element]]
    if missing:
        raise FileError(path, f"the element {element!r} has no property {missing[0]!r}")
    return np.column_stack([elements[element][name] for name in names])


def _check(
    path: Path, element: str, names: Sequence[str], columns: NDArray[Any], is_valid: NDArray[Any], expected: str
) -> None:
    """Raise FileError for the first number that is not valid."""
    if not is_valid.all():
        row, column = np.argwhere(~is_valid)[0].tolist()
        where = f"element {element}, row {row}, property {names[column]}"
        raise FileError(path, f"expected {expected}, got {columns[row, column]}", where=where)


def color_columns(colors: NDArray[Any]) -> dict[str, NDArray[Any]]:
    return dict(zip(CHANNELS, np.rint(np.clip(colors, 0, 1) * 255).astype(np.uint8).T, strict=True))


def write_elements(path: Path, elements: Elements, *, ascii: bool) -> None:
    lines = ["ply", f"format {'ascii' if ascii else 'binary_little_endian'} 1.0"]
    for name, columns in elements.items():
        lines.append(f"element {name} {len(next(iter(columns.values())))}")
        lines += [f"property {TYPE_NAMES[column.dtype.str[1:]]} {key}" for key, column in columns.items()]
    with atomic_write(path) as file:
        file.write("\n".join([*lines, "end_header", ""]).encode("ascii"))
        for columns in elements.values():
            _write(file, list(columns.values()), ascii=ascii)


def _write(file: IO[bytes], columns: list[NDArray[Any]], *, ascii: bool) -> None:
    if ascii:
        write_rows(file, columns)
    else:
        rows = np.rec.fromarrays(columns, dtype=[(f"f{k}", f"<{c.dtype.str[1:]}") for k, c in enumerate(columns)])
        file.write(rows.tobytes())
