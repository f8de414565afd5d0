"""Points as NPZ, lossless: `points`, `normals`, `colors` (n, 3), `grid` (height, width), `unit` (text), attributes.

Pickles are never loaded. Sizes are validated against the stored bytes before allocation. NumPy Enhancement Proposal 1
(.npy). PKWARE APPNOTE (ZIP).
"""

from __future__ import annotations

import math
import zipfile
from collections.abc import Collection
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.checks import shown
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.paths import input_path, path_of
from ...core.units import KNOWN, LengthUnit, text_of, unit_of_text
from ..attribute_names import NameRules
from ..columns import stack_colors, stack_normals
from ..npy_header import read_npy_header
from ..optional_imports import foreign_errors
from ..source import open_source
from ..table import PointTable
from .header_units import crs_of_text

# Deflate needs at least one bit for 129 bytes, so its output is below 1032 times its input.
MAX_DEFLATE_RATIO = 1032

MAX_AXES = 32  # maximum number of array axes, as in NumPy 1

# The end record of an archive without a comment, as NumPy writes it.
_END_BYTES = 22

# A fixed timestamp (the first of ZIP), so that equal tables give equal files.
_TIME_STAMP = (1980, 1, 1, 0, 0, 0)

_TABLE_KEYS = ("points", "normals", "colors", "grid")
_UNIT, _CRS = "unit", "crs"
_MAX_LETTERS = {_UNIT: 200, _CRS: 1 << 16}  # letters
_NOT_NUMERIC = "expected real numbers or booleans"


def read_npz(path: FilePath) -> PointTable:
    """Read points from an NPZ file, float32 if stored so, else float64."""
    path = Path(path)
    return _table(path, read_arrays(path))


def read_arrays(path: Path, wanted: Collection[str] | None = None) -> dict[str, NDArray[Any]]:
    """The arrays of an archive by name. Only the wanted ones are read."""
    source = open_source(path)
    if source[-_END_BYTES:][:4] != b"PK\5\6":
        where = f"byte {len(source)}"
        raise FileError(path, "is not an NPZ archive, or is truncated, or bytes follow its end", where=where)
    try:
        with (
            foreign_errors(path, "is not an intact NPZ archive"),
            source.reopen() as file,
            zipfile.ZipFile(file) as archive,
        ):
            arrays = {}
            for info in archive.infolist():
                name = info.filename.removesuffix(".npy")
                if name == info.filename or name in arrays:
                    what = "is duplicated" if name in arrays else "is not a .npy array"
                    raise FileError(path, f"member {info.filename!r} {what}")
                if wanted is None or name in wanted:
                    arrays[name] = read_member(path, archive, info, name)
            begin = min((info.header_offset for info in archive.infolist()), default=0)
            if begin:
                raise FileError(path, f"{begin} bytes precede the archive", where="byte 0")
    except MemoryError as error:
        raise MemoryError(
            escaped(f"{path}: not enough memory for its arrays; read it on a machine with more")
        ) from error
    return arrays


def write_npz(path: FilePath, table: PointTable, *, overwrite: bool = True) -> None:
    """Write points as uncompressed NPZ, lossless and atomically."""
    path = check_writable(path, overwrite=overwrite)
    table = table.checked()
    arrays: dict[str, NDArray[Any]] = {"points": table.points}
    if table.normals is not None:
        arrays["normals"] = table.normals
    if table.colors is not None:
        arrays["colors"] = table.colors
    if table.grid is not None:
        arrays["grid"] = np.array(table.grid, np.int64)
    if table.unit is not None:
        arrays[_UNIT] = np.array(text_of(table.unit))
    if table.crs is not None:
        arrays[_CRS] = np.array(table.crs.text)
    for name, values in table.attributes.items():
        if name in _TABLE_KEYS or name in arrays:
            raise FileError(path, f"attribute {name!r}: the format uses this name itself", remedy="Rename it")
        if not name or not name.isprintable() or "/" in name or "\\" in name:
            reason = f"attribute {name!r} cannot name a member of the archive"
            raise FileError(path, reason, remedy="Use printable characters without slashes")
        arrays[name] = values
    with atomic_write(path, overwrite=overwrite) as file, zipfile.ZipFile(file, "w", zipfile.ZIP_STORED) as archive:
        for name, values in arrays.items():
            member = zipfile.ZipInfo(f"{name}.npy", _TIME_STAMP)
            with archive.open(member, "w", force_zip64=True) as stream:
                np.lib.format.write_array(stream, np.asarray(values, order="C"), allow_pickle=False)


def name_rules(_path: FilePath, table: PointTable) -> NameRules:
    texts = [name for name, value in ((_UNIT, table.unit), (_CRS, table.crs)) if value is not None]
    used = (*_TABLE_KEYS, *texts)
    return NameRules(lambda letter: letter.isprintable() and letter not in "/\\", used, in_parts=False)


def read_member(path: FilePath, archive: zipfile.ZipFile, info: zipfile.ZipInfo, name: str) -> NDArray[Any]:
    """Read one array after checking its header, directory entry and stored bytes."""
    possible = info.compress_size * (1 if info.compress_type == zipfile.ZIP_STORED else MAX_DEFLATE_RATIO)
    if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise FileError(path, f"member {name!r} is compressed in an unknown way", where=f"byte {info.header_offset}")
    if info.compress_size > path_of(path).stat().st_size or info.file_size > possible:
        reason = f"member {name!r} claims {info.file_size} bytes from {info.compress_size} stored ones"
        raise FileError(path, reason, where=f"byte {info.header_offset}")
    with archive.open(info) as stream:
        return _read_array(path, stream, name, info.file_size, f"byte {info.header_offset}")


def read_npy(path: FilePath) -> NDArray[Any]:
    """Read an array of numbers from a .npy file. Raises `FileError`."""
    file = input_path(path)
    try:
        with foreign_errors(path, "cannot be read as a .npy array"), file.open("rb") as stream:
            return _read_array(path, stream, "array", file.stat().st_size, "byte 0")
    except MemoryError as error:
        raise MemoryError(escaped(f"{path}: not enough memory for its array")) from error


def _read_array(path: FilePath, stream: IO[bytes], name: str, size: int, where: str) -> NDArray[Any]:
    """Read an array from a stream of `size` bytes after checking its header."""
    shape, fortran, dtype = _read_array_header(path, stream, name)
    is_text = dtype.kind == "U" and shape == () and dtype.itemsize <= 4 * _MAX_LETTERS.get(name, 0)
    if not is_text and (dtype.kind not in "biuf" or dtype.itemsize > 8):
        raise FileError(path, f"{name}: {_NOT_NUMERIC}, got {dtype}")
    if any(isinstance(extent, bool) for extent in shape):
        raise FileError(path, f"{name}: the array's header is damaged: its shape is {shape}")
    needed, left = math.prod(shape) * dtype.itemsize, size - stream.tell()
    if needed != left or len(shape) > MAX_AXES:
        reason = f"{name}: the header's shape {list(shape)} of {dtype} needs {needed} bytes, but has {left}"
        raise FileError(path, reason, where=where)
    body = stream.read()
    if len(body) != needed:
        raise FileError(path, f"{name}: {needed - len(body)} bytes are missing", where=where)
    if is_text:
        try:
            body.decode("utf-32-be" if dtype.str[0] == ">" else "utf-32-le")
        except UnicodeDecodeError as error:
            raise FileError(path, f"{name}: the text is damaged: {error.reason}", where=where) from error
    array = np.frombuffer(body, dtype).reshape(shape, order="F" if fortran else "C")
    return array.astype(dtype.newbyteorder("="), order="C", copy=True)


def _read_array_header(path: FilePath, stream: IO[bytes], name: str) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    with foreign_errors(path, f"{name}: the array's header is damaged"):
        return read_npy_header(stream)


def _table(path: FilePath, arrays: dict[str, NDArray[Any]]) -> PointTable:
    if "points" not in arrays:
        names = ", ".join(sorted(arrays)[:10]) or "nothing"
        raise FileError(path, f"there is no array 'points' (the archive contains: {names})")
    points = arrays.pop("points")
    _check_shape(path, "points", points, None)
    count = len(points)
    points = points.astype(np.float32 if points.dtype in (np.float32, np.float16) else np.float64, copy=False)
    normals, colors = arrays.pop("normals", None), arrays.pop("colors", None)
    for name, values in (("normals", normals), ("colors", colors)):
        if values is not None:
            _check_shape(path, name, values, count)
    grid = _grid(path, arrays.pop("grid"), count) if "grid" in arrays else None
    texts = {name: arrays.pop(name) for name in _MAX_LETTERS if name in arrays and arrays[name].dtype.kind == "U"}
    unit = _unit(path, texts[_UNIT]) if _UNIT in texts else None
    crs = crs_of_text(str(texts[_CRS])) if _CRS in texts else None
    for name, values in arrays.items():
        if values.ndim not in (1, 2) or len(values) != count:
            raise FileError(path, f"{name}: expected shape [{count}] or [{count}, c], got {list(values.shape)}")
    return PointTable(
        points,
        None if normals is None else stack_normals(path, [*normals.T]),
        None if colors is None else stack_colors(path, [*colors.T]),
        arrays,
        grid,
        unit=unit,
        crs=crs,
    )


def _check_shape(path: FilePath, name: str, values: NDArray[Any], count: int | None) -> None:
    if (
        values.ndim != 2
        or values.shape[1] != 3
        or (count is not None and len(values) != count)
        or values.dtype.kind == "b"
    ):
        expected = "n" if count is None else count
        raise FileError(
            path, f"{name}: expected numbers of shape [{expected}, 3], got {values.dtype} {list(values.shape)}"
        )


def _unit(path: FilePath, value: NDArray[Any]) -> LengthUnit:
    unit = unit_of_text(str(value))
    if unit is None:
        remedy = f"Use one of {', '.join(unit.name for unit in KNOWN)}, or 'name = 0.3048 m' for another one"
        raise FileError(path, f"unit: expected the name of a unit, got {shown(str(value))}", remedy=remedy)
    return unit


def _grid(path: FilePath, values: NDArray[Any], count: int) -> tuple[int, int]:
    if values.shape == (2,) and values.dtype.kind in "iu":
        height, width = (int(extent) for extent in values)
        if height > 0 and width > 0 and height * width == count:
            return height, width
    raise FileError(path, f"grid: expected height and width with a product of {count}, got {values.tolist()}")
