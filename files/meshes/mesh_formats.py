"""Which reader and which writer of meshes an extension names: tables in NumPy, no device."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from ..points.header_units import PLY, in_metres, is_metric, tells_unit, unit_comment, warn_of_lost_unit
from ..points.ply import read_ply_mesh, write_ply_mesh
from ..table import MeshTable
from .glb import read_glb
from .glb_writer import write_glb
from .obj import read_obj, write_obj
from .off import read_off, write_off
from .stl import read_stl, write_stl

MESH_READERS: dict[str, Callable[..., MeshTable]] = {
    ".ply": tells_unit(PLY)(read_ply_mesh), ".obj": read_obj, ".stl": read_stl, ".off": read_off,
    ".glb": is_metric(read_glb),
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
        write_ply_mesh(path, mesh, ascii=ascii, overwrite=overwrite, comments=unit_comment(mesh))
    else:
        if suffix == ".glb":
            mesh = in_metres(path, mesh, "glTF")
        else:
            warn_of_lost_unit(path, mesh)
        _WRITERS[suffix](path, mesh, overwrite=overwrite)
