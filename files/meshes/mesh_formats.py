"""Which reader and which writer of meshes an extension names: tables in NumPy, no device."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from ..points.ply import read_ply_mesh, write_ply_mesh
from ..table import MeshTable
from .glb import read_glb
from .glb_writer import write_glb
from .obj import held_by_obj, read_obj, write_obj
from .off import held_by_off, read_off, write_off
from .stl import held_by_stl, read_stl, write_stl

MESH_READERS: dict[str, Callable[..., MeshTable]] = {
    ".ply": read_ply_mesh, ".obj": read_obj, ".stl": read_stl, ".off": read_off, ".glb": read_glb,
}  # fmt: skip

#: The part of a mesh that each format holds, and the names of the rest.
UNHELD: dict[str, Callable[[MeshTable], tuple[MeshTable, list[str]]]] = {
    ".obj": held_by_obj, ".stl": held_by_stl, ".off": held_by_off,
}  # fmt: skip

_WRITERS: dict[str, Callable[..., None]] = {
    ".obj": write_obj, ".stl": write_stl, ".off": write_off, ".glb": write_glb,
}  # fmt: skip


def write_mesh(path: str | os.PathLike[str], mesh: MeshTable, *, ascii: bool, overwrite: bool) -> None:
    """Write a mesh in the format of the path's extension, which is one of MESH_READERS; `ascii` is for .ply.

    Raises:
        FileError: The file cannot be made, or the format cannot hold what the mesh has.
    """
    suffix = Path(path).suffix.lower()
    if suffix == ".ply":
        write_ply_mesh(path, mesh, ascii=ascii, overwrite=overwrite)
    else:
        _WRITERS[suffix](path, mesh, overwrite=overwrite)
