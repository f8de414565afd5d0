"""Readers and writers of the formats of clouds, as NumPy tables, with what each format cannot store."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from numpy.typing import ArrayLike

from ...core.devices import DeviceLike
from ...core.errors import FilePath
from ..attribute_names import NameRules, rename
from ..columns import has_type, narrow_attributes
from ..file_formats import CloudCodec
from ..source import netted
from ..table import PointTable
from . import header_units, las_writer, npy, npz, pcd, ply, vtk_points
from .copc_writer import write_copc
from .e57 import ScanFrame, read_e57
from .e57_writer import unstorable_in_e57, write_e57
from .header_units import reference_comments, warn_of_lost_reference, with_header_reference
from .kitti_bin import read_kitti_bin
from .las import read_las
from .las_header import LasHeader
from .obj_points import read_obj_points
from .ptx import read_ptx
from .text import read_text, write_text
from .text_table import name_rules as text_rules
from .text_table import read_text_table, write_text_table

COPC = ".copc.laz"

Storable = tuple[PointTable, list[str]]  # a table, and the names of what was removed from it


@dataclass(frozen=True)
class WriteOptions:
    """How a cloud is written. `ascii` is for formats of either encoding, `scale`, `offset` and `like` for LAS (see
    `write_las`), `frames` for .e57 (see `write_e57`). `drop_unsupported` drops what the format cannot store. The octree
    of .copc.laz is computed on the device."""

    ascii: bool = False
    overwrite: bool = True
    drop_unsupported: bool = False
    scale: ArrayLike | None = None
    offset: ArrayLike | None = None
    like: LasHeader | None = None
    frames: Sequence[ScanFrame] = ()
    device: DeviceLike = None


def _write_ply(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    ply.write_ply(path, table, ascii=options.ascii, overwrite=options.overwrite, comments=reference_comments(table))


def _ply_names(_path: FilePath, table: PointTable) -> NameRules:
    return ply.name_rules(table.normals, table.colors)


def _storable_in_ply(path: FilePath, table: PointTable) -> Storable:
    """The table with 64-bit integers in types that PLY supports."""
    return _of_types(ply.TYPES, path, replace(table, attributes=narrow_attributes(table.attributes)))


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
    names = rename(path, "LAS", table.attributes, las_writer.name_rules(path, table), stacklevel=4)
    table = replace(table, attributes=names)
    return _without(table, [*las_writer.unstorable_in_las(path, table)])


def _write_e57(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    write_e57(path, table, overwrite=options.overwrite, frames=options.frames)


def _storable_in_e57(_path: FilePath, table: PointTable) -> Storable:
    return _without(table, unstorable_in_e57(table))


def _without(table: PointTable, names: list[str]) -> Storable:
    return replace(table, attributes={name: v for name, v in table.attributes.items() if name not in names}), names


def _text(columns: tuple[str, ...] = ()) -> CloudCodec:
    return CloudCodec(netted(read_text), _write_text, storable=partial(_storable_in_text, columns))


PLY = CloudCodec(
    netted(with_header_reference(header_units.PLY)(ply.read_ply)), _write_ply, _ply_names, _storable_in_ply
)
PCD = CloudCodec(
    netted(with_header_reference(header_units.PCD)(pcd.read_pcd)),
    _write_pcd,
    pcd.name_rules,
    partial(_of_types, pcd.TYPES),
)
NPZ = CloudCodec(netted(npz.read_npz), _write_npz, npz.name_rules)
NPY = CloudCodec(netted(npy.read_npy_points), _write_npy, npy.name_rules)
TABLE = CloudCodec(netted(read_text_table), _write_text_table, text_rules)
XYZ = _text()._replace(read_columns=TABLE.read)
XYZN, XYZRGB, PTS = _text(("normals",)), _text(("colors",)), _text(("colors", "intensity"))
KITTI = CloudCodec(netted(read_kitti_bin))
LAS = CloudCodec(netted(read_las), _write_las, las_writer.name_rules, _storable_in_las)
E57 = CloudCodec(netted(read_e57), _write_e57, storable=_storable_in_e57)
PTX = CloudCodec(netted(read_ptx))
VTK = CloudCodec(netted(vtk_points.read_vtk_points), _write_vtk, vtk_points.name_rules)
OBJ = CloudCodec(netted(read_obj_points))
