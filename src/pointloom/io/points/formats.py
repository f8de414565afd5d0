"""Formats of clouds by extension: reader, writer and limits of each, as NumPy tables."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from ...core.devices import DeviceLike
from ...core.errors import FilePath
from ...core.escaped_text import escaped
from ...core.units import warn_of_units
from ..attribute_names import NameRules, rename
from ..columns import has_type, narrow_integers
from ..source import netted
from ..table import PointTable
from . import las_writer, npy, npz, pcd, ply, vtk_points
from .copc_writer import write_copc
from .e57 import ScanFrame, read_e57
from .e57_writer import unstorable_in_e57, write_e57
from .header_units import PCD, PLY, reference_comments, warn_of_lost_reference, with_header_reference
from .kitti_bin import read_kitti_bin
from .las import read_las
from .las_header import LasHeader
from .obj_points import read_obj_points
from .ptx import read_ptx
from .text import read_text, write_text
from .text_table import SUFFIXES, check_columns, read_text_table, write_text_table
from .text_table import name_rules as text_rules

COPC = ".copc.laz"
OF_8_BITS = (".ply", ".pcd", ".pts", ".e57")  # colors
COLOR_SAMPLES = 4096  # whose bits are examined
COLOR_ROUNDING = 1.2e-7  # of float32 colors, two roundings

Storable = tuple[PointTable, list[str]]  # a table, and the names of what was removed from it


@dataclass(frozen=True)
class WriteOptions:
    """How a cloud is written. `ascii` is for .ply and .pcd; `scale`, `offset` and `like` for LAS, see `write_las`;
    `frames` for .e57, see `write_e57`. `drop_unsupported` drops what the format cannot store. The octree of
    .copc.laz is computed on the device."""

    ascii: bool = False
    overwrite: bool = True
    drop_unsupported: bool = False
    scale: ArrayLike | None = None
    offset: ArrayLike | None = None
    like: LasHeader | None = None
    frames: Sequence[ScanFrame] = ()
    device: DeviceLike = None


@dataclass(frozen=True)
class Format:
    """A format of clouds.

    Attributes:
        read: Raises only `FileError` for invalid content.
        write: None if clouds are not written in this format.
        name_rules: The allowed attribute names of a table. None: all, or those of `storable`.
        storable: Removes what the format cannot store. None: it stores everything.
        read_columns: Reads a file whose columns are named. None if they cannot be.
        stores_viewpoint: True if the format has a field for the viewpoint.
    """

    name: str
    read: Callable[..., PointTable]
    write: Callable[[FilePath, PointTable, WriteOptions], None] | None = None
    name_rules: Callable[[FilePath, PointTable], NameRules] | None = None
    storable: Callable[[FilePath, PointTable], Storable] | None = None
    read_columns: Callable[..., PointTable] | None = field(default=None, kw_only=True)
    stores_viewpoint: bool = field(default=False, kw_only=True)


def _write_ply(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    ply.write_ply(path, table, ascii=options.ascii, overwrite=options.overwrite, comments=reference_comments(table))


def _ply_names(_path: FilePath, table: PointTable) -> NameRules:
    return ply.name_rules(table.normals, table.colors)


def _storable_in_ply(path: FilePath, table: PointTable) -> Storable:
    """The table with 64-bit integers in types that PLY supports."""
    narrowed = {name: (narrow_integers(values), values) for name, values in table.attributes.items()}
    attributes = {name: values if narrow is None else narrow for name, (narrow, values) in narrowed.items()}
    return _of_types(ply.TYPES, path, replace(table, attributes=attributes))


def _of_types(types: str, _path: FilePath, table: PointTable) -> Storable:
    return _without(table, [name for name, values in table.attributes.items() if not has_type(values, types)])


def _write_pcd(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    pcd.write_pcd(path, table, encoding="ascii" if options.ascii else "binary", overwrite=options.overwrite)


def _write_npz(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    npz.write_npz(path, table, overwrite=options.overwrite)


def _write_npy(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    warn_of_lost_reference(path, table)
    npy.write_npy_points(path, table, overwrite=options.overwrite)


def _write_vtk(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    vtk_points.write_vtk_points(path, table, ascii=options.ascii, overwrite=options.overwrite)


def _write_text(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    warn_of_lost_reference(path, table)
    write_text(path, table, overwrite=options.overwrite)


def _write_text_table(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    warn_of_lost_reference(path, table)
    write_text_table(path, table, overwrite=options.overwrite)


def _storable_in_text(columns: tuple[str, ...], _path: FilePath, table: PointTable) -> Storable:
    attributes = {name: values for name, values in table.attributes.items() if name in columns and values.ndim == 1}
    colors, normals = (getattr(table, name) if name in columns else None for name in ("colors", "normals"))
    removed = [name for name in ("normals", "colors") if name not in columns and getattr(table, name) is not None]
    removed += [name for name in table.attributes if name not in attributes]
    return PointTable(table.points, normals, colors, attributes, unit=table.unit, crs=table.crs), removed


def _write_las(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    given = {"scale": options.scale, "offset": options.offset, "like": options.like, "overwrite": options.overwrite}
    if Path(path).name.lower().endswith(COPC):
        write_copc(path, table, **given, device=options.device)
    else:
        las_writer.write_las(path, table, **given)


def _storable_in_las(path: FilePath, table: PointTable) -> Storable:
    table = with_fitting_names(path, table, stacklevel=4)
    return _without(table, [*las_writer.unstorable_in_las(path, table)])


def _write_e57(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    write_e57(path, table, overwrite=options.overwrite, frames=options.frames)


def _storable_in_e57(_path: FilePath, table: PointTable) -> Storable:
    return _without(table, unstorable_in_e57(table))


def _without(table: PointTable, names: list[str]) -> Storable:
    return replace(table, attributes={name: v for name, v in table.attributes.items() if name not in names}), names


def _text(name: str, columns: tuple[str, ...] = ()) -> Format:
    return Format(name, netted(read_text), _write_text, storable=partial(_storable_in_text, columns))


_LAS = Format("LAS", netted(read_las), _write_las, las_writer.name_rules, _storable_in_las)

_VTK = Format("VTK", netted(vtk_points.read_vtk_points), _write_vtk, vtk_points.name_rules)

_TABLE = Format("text", netted(read_text_table), _write_text_table, text_rules, read_columns=netted(read_text_table))
_read_bin, _read_npy = netted(read_kitti_bin), netted(npy.read_npy_points)

FORMATS = {
    ".ply": Format("PLY", netted(with_header_reference(PLY)(ply.read_ply)), _write_ply, _ply_names, _storable_in_ply),
    ".pcd": Format(
        "PCD",
        netted(with_header_reference(PCD)(pcd.read_pcd)),
        _write_pcd,
        pcd.name_rules,
        partial(_of_types, pcd.TYPES),
        stores_viewpoint=True,
    ),
    ".npz": Format("NPZ", netted(npz.read_npz), _write_npz, npz.name_rules),
    ".npy": Format("NPY", _read_npy, _write_npy, npy.name_rules, read_columns=_read_npy),
    ".xyz": replace(_text("XYZ"), read_columns=_TABLE.read),
    ".xyzn": _text("XYZN", ("normals",)),
    ".xyzrgb": _text("XYZRGB", ("colors",)),
    ".pts": _text("PTS", ("colors", "intensity")),
    ".csv": _TABLE,
    ".txt": _TABLE,
    ".asc": _TABLE,
    ".bin": Format("KITTI", _read_bin, read_columns=_read_bin),
    ".las": _LAS,
    ".laz": _LAS,
    ".e57": Format("E57", netted(read_e57), _write_e57, storable=_storable_in_e57),
    ".ptx": Format("PTX", netted(read_ptx)),
    ".vtk": _VTK,
    ".vtp": _VTK,
    ".obj": Format("OBJ", netted(read_obj_points)),
}

#: The readers by extension. They raise only FileError for invalid content.
READERS = {extension: format.read for extension, format in FORMATS.items()}

#: The extensions that clouds are written to.
WRITTEN = tuple(extension for extension, format in FORMATS.items() if format.write is not None)

_NAMED_COLUMNS = (*SUFFIXES, ".bin", ".npy")


def columns_of(paths: Sequence[FilePath], columns: Sequence[str] | None) -> list[Sequence[str] | None]:
    """The column names for each file: `columns` if its format supports them, else None. Raises if none does."""
    takes = [Path(path).suffix.lower() in _NAMED_COLUMNS for path in paths]
    if columns is not None and not any(takes):
        raise _columns_error(", ".join(dict.fromkeys(Path(path).suffix for path in paths)))
    return [columns if is_taken else None for is_taken in takes]


def read_points(path: FilePath, columns: Sequence[str] | None = None) -> PointTable:
    format = FORMATS.get(Path(path).suffix.lower())
    if format is not None and columns is None:
        return format.read(path)
    if format is None or format.read_columns is None or columns is None:
        raise _columns_error(Path(path).suffix)
    return format.read_columns(path, check_columns(columns))


def _columns_error(suffixes: str) -> ValueError:
    return ValueError(f"columns: only {', '.join(_NAMED_COLUMNS)} take them, got {escaped(suffixes)}")


def write_table(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    """Write a table by extension (one of WRITTEN), renaming attributes with a warning (attribute_names.py)."""
    format = FORMATS[Path(path).suffix.lower()]
    if options.drop_unsupported and format.storable is not None:
        table, _ = format.storable(path, table)
    table = with_fitting_names(path, table, stacklevel=4)
    _warn_of_rounded_colors(path, table)
    write = format.write or _write_text  # which raises for other extensions
    write(path, table, options)


def _warn_of_rounded_colors(path: FilePath, table: PointTable) -> None:
    """Warn if colors of 16 bits, as of LAS and E57, are written with 8. Others, such as means, are rounded anyway."""
    suffix = Path(path).suffix.lower()
    if table.colors is None or suffix not in OF_8_BITS:
        return
    colors = table.colors[:: max(1, len(table.colors) // COLOR_SAMPLES)].astype(np.float64)
    off8, off16 = (np.abs(colors * most - np.rint(colors * most)) / most for most in (2**8 - 1, 2**16 - 1))
    if off8.max(initial=0) > COLOR_ROUNDING and off16.max(initial=0) <= COLOR_ROUNDING:
        reason = f"colors of 16 bits a channel are rounded to the 8 bits of {suffix}; .laz and .npz keep 16"
        warn_of_units(f"{path}: {reason}", UserWarning)


def with_fitting_names(path: FilePath, table: PointTable, *, stacklevel: int = 3) -> PointTable:
    """The table with attribute names that the format supports. Warns of changes."""
    format = FORMATS[Path(path).suffix.lower()]
    if format.name_rules is None:
        return table
    rules = format.name_rules(path, table)
    return replace(table, attributes=rename(path, format.name, table.attributes, rules, stacklevel=stacklevel))
