"""Readers and writers of clouds by extension, as NumPy tables."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from numpy.typing import ArrayLike

from ...core.devices import DeviceLike
from ...core.escaped_text import escaped
from ..attribute_names import rename
from ..source import netted
from ..table import PointTable
from . import las_writer, npz, pcd, ply
from .copc_writer import write_copc
from .e57 import ScanFrame, read_e57
from .e57_writer import write_e57
from .header_units import PCD, PLY, unit_comment, warn_of_lost_unit, with_header_unit
from .kitti_bin import read_kitti_bin
from .las import read_las
from .las_header import LasHeader
from .ptx import read_ptx
from .text import read_text, write_text
from .text_table import SUFFIXES, check_columns, read_text_table

_READERS: dict[str, Callable[..., PointTable]] = {
    ".ply": with_header_unit(PLY)(ply.read_ply), ".pcd": with_header_unit(PCD)(pcd.read_pcd), ".npz": npz.read_npz,
    ".xyz": read_text, ".xyzn": read_text, ".xyzrgb": read_text, ".pts": read_text,
    ".csv": read_text_table, ".txt": read_text_table, ".asc": read_text_table, ".bin": read_kitti_bin,
    ".las": read_las, ".laz": read_las, ".e57": read_e57, ".ptx": read_ptx,
}  # fmt: skip

#: The readers by extension. They raise only FileError for invalid content.
READERS = {extension: netted(reader) for extension, reader in _READERS.items()}

COPC = ".copc.laz"

_NAMED_COLUMNS: dict[str, Callable[..., PointTable]] = {
    **dict.fromkeys(SUFFIXES, netted(read_text_table)), ".bin": READERS[".bin"],
}  # fmt: skip


def columns_of(paths: Sequence[str | os.PathLike[str]], columns: Sequence[str] | None) -> list[Sequence[str] | None]:
    """The column names for each file: `columns` if its format supports them, else None. Raises if none does."""
    takes = [Path(path).suffix.lower() in _NAMED_COLUMNS for path in paths]
    if columns is not None and not any(takes):
        suffixes = escaped(", ".join(dict.fromkeys(Path(path).suffix for path in paths)))
        raise ValueError(f"columns: only {', '.join(_NAMED_COLUMNS)} take them, got {suffixes}")
    return [columns if is_taken else None for is_taken in takes]


def read_points(path: str | os.PathLike[str], columns: Sequence[str] | None = None) -> PointTable:
    extension = Path(path).suffix.lower()
    if columns is None:
        return READERS[extension](path)
    if extension not in _NAMED_COLUMNS:
        raise ValueError(f"columns: only {', '.join(_NAMED_COLUMNS)} take them, got {escaped(Path(path).suffix)}")
    return _NAMED_COLUMNS[extension](path, check_columns(columns))


#: The extensions that clouds are written to.
WRITTEN = tuple(extension for extension in READERS if extension not in (".csv", ".txt", ".asc", ".bin", ".ptx"))


def write_table(
    path: str | os.PathLike[str],
    table: PointTable,
    *,
    ascii: bool,
    overwrite: bool,
    scale: ArrayLike | None = None,
    offset: ArrayLike | None = None,
    like: LasHeader | None = None,
    frames: Sequence[ScanFrame] = (),
    device: DeviceLike = None,
) -> None:
    """Write a table by extension (one of WRITTEN), renaming attributes with a warning if needed (attribute_names.py).
    `ascii` is for .ply and .pcd; `scale`, `offset`, `like` for LAS, see `write_las`; `frames` for .e57, see
    `write_e57`. The octree of .copc.laz is computed on the device."""
    given = Path(path)
    extension = given.suffix.lower()
    table = with_fitting_names(path, table, stacklevel=4)
    if given.name.lower().endswith(COPC):
        write_copc(path, table, scale=scale, offset=offset, like=like, overwrite=overwrite, device=device)
    elif extension == ".ply":
        ply.write_ply(path, table, ascii=ascii, overwrite=overwrite, comments=unit_comment(table))
    elif extension == ".pcd":
        pcd.write_pcd(path, table, encoding="ascii" if ascii else "binary", overwrite=overwrite)
    elif extension == ".npz":
        npz.write_npz(path, table, overwrite=overwrite)
    elif extension in (".las", ".laz"):
        las_writer.write_las(path, table, scale=scale, offset=offset, like=like, overwrite=overwrite)
    elif extension == ".e57":
        write_e57(path, table, overwrite=overwrite, frames=frames)
    else:
        warn_of_lost_unit(path, table)
        write_text(path, table, overwrite=overwrite)


def with_fitting_names(path: str | os.PathLike[str], table: PointTable, *, stacklevel: int = 3) -> PointTable:
    """The table with attribute names that the format supports. Warns of changes."""
    extension = Path(path).suffix.lower()
    if extension == ".ply":
        format, rules = "PLY", ply.name_rules(table.normals, table.colors)
    elif extension == ".pcd":
        format, rules = "PCD", pcd.name_rules(table)
    elif extension == ".npz":
        format, rules = "NPZ", npz.name_rules(table)
    elif extension in (".las", ".laz"):
        format, rules = "LAS", las_writer.name_rules(path, table)
    else:
        return table
    return replace(table, attributes=rename(path, format, table.attributes, rules, stacklevel=stacklevel))
