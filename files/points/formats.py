"""Which reader and which writer of clouds an extension names: tables in NumPy."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from numpy.typing import ArrayLike

from ..source import netted
from ..table import PointTable
from .copc_writer import write_copc
from .e57 import read_e57
from .e57_writer import write_e57
from .header_units import PCD, PLY, tells_unit, unit_comment, warn_of_lost_unit
from .kitti_bin import read_kitti_bin
from .las import read_las
from .las_header import LasHeader
from .las_writer import write_las
from .npz import read_npz, write_npz
from .pcd import read_pcd, write_pcd
from .ply import read_ply, write_ply
from .text import read_text, write_text
from .text_table import SUFFIXES, check_columns, read_text_table

_READERS: dict[str, Callable[..., PointTable]] = {
    ".ply": tells_unit(PLY)(read_ply), ".pcd": tells_unit(PCD)(read_pcd), ".npz": read_npz,
    ".xyz": read_text, ".xyzn": read_text, ".xyzrgb": read_text, ".pts": read_text,
    ".csv": read_text_table, ".txt": read_text_table, ".bin": read_kitti_bin,
    ".las": read_las, ".laz": read_las, ".e57": read_e57,
}  # fmt: skip

#: The readers by extension; whatever a file's content makes them raise is a FileError.
READERS = {extension: netted(reader) for extension, reader in _READERS.items()}

COPC = ".copc.laz"

_NAMED_COLUMNS: dict[str, Callable[..., PointTable]] = {
    **dict.fromkeys(SUFFIXES, netted(read_text_table)), ".bin": READERS[".bin"],
}  # fmt: skip


def read_points(path: str | os.PathLike[str], columns: Sequence[str] | None = None) -> PointTable:
    """Read a cloud by the reader of its extension, which is one of READERS, with the names of its columns if given.

    Raises:
        FileError: The file cannot be read.
        TypeError: `columns` are no names.
        ValueError: `columns` of a format that names its columns itself, without x, y and z, or with a name twice.
    """
    extension = Path(path).suffix.lower()
    if columns is None:
        return READERS[extension](path)
    if extension not in _NAMED_COLUMNS:
        raise ValueError(f"columns: only {', '.join(_NAMED_COLUMNS)} take them, got {Path(path).suffix}")
    return _NAMED_COLUMNS[extension](path, check_columns(columns))


#: The extensions that clouds are written to.
WRITTEN = tuple(extension for extension in READERS if extension not in (".csv", ".txt", ".bin"))


def write_table(
    path: str | os.PathLike[str],
    table: PointTable,
    *,
    ascii: bool,
    overwrite: bool,
    scale: ArrayLike | None = None,
    offset: ArrayLike | None = None,
    like: LasHeader | None = None,
    device: Any = None,
) -> None:
    """Write a table in the format of the path's extension, which is one of WRITTEN.

    `ascii` is for .ply and .pcd; `scale`, `offset` and `like` are for .las and .laz, see write_las; a name that ends in
    .copc.laz is a COPC file, whose octree is made on the device.

    Raises:
        FileError: The file cannot be made, or the format cannot hold an attribute.
    """
    extension = Path(path).suffix.lower()
    if Path(path).name.lower().endswith(COPC):
        write_copc(path, table, scale=scale, offset=offset, like=like, overwrite=overwrite, device=device)
    elif extension == ".ply":
        write_ply(path, table, ascii=ascii, overwrite=overwrite, comments=unit_comment(table))
    elif extension == ".pcd":
        write_pcd(path, table, encoding="ascii" if ascii else "binary", overwrite=overwrite)
    elif extension == ".npz":
        write_npz(path, table, overwrite=overwrite)
    elif extension in (".las", ".laz"):
        write_las(path, table, scale=scale, offset=offset, like=like, overwrite=overwrite)
    elif extension == ".e57":
        write_e57(path, table, overwrite=overwrite)
    else:
        warn_of_lost_unit(path, table)
        write_text(path, table, overwrite=overwrite)
