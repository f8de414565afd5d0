"""Readers and writers of meshes by extension, as NumPy tables."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import shown
from ..attribute_names import rename
from ..points.header_units import PLY, in_metres, is_metric, unit_comment, warn_of_lost_unit, with_header_unit
from ..points.ply import name_rules, read_ply_mesh, write_ply_mesh
from ..points.ply_faces import face_name_rules
from ..source import netted
from ..table import MeshTable
from .glb import read_glb
from .glb_writer import storable_in_gltf, write_glb, write_gltf
from .obj import read_obj, storable_in_obj, write_obj
from .off import read_off, storable_in_off, write_off
from .stl import read_stl, storable_in_stl, write_stl

_READERS: dict[str, Callable[..., MeshTable]] = {
    ".ply": with_header_unit(PLY)(read_ply_mesh), ".obj": read_obj, ".stl": read_stl, ".off": read_off,
    ".glb": is_metric(read_glb), ".gltf": is_metric(read_glb),
}  # fmt: skip

#: The readers by extension. They raise only FileError for invalid content.
MESH_READERS = {extension: netted(reader) for extension, reader in _READERS.items()}

#: Functions that return the storable part of a mesh and the names of the rest, by extension.
STORABLE_PARTS: dict[str, Callable[[MeshTable], tuple[MeshTable, list[str]]]] = {
    ".obj": storable_in_obj, ".stl": storable_in_stl, ".off": storable_in_off, ".glb": storable_in_gltf,
    ".gltf": storable_in_gltf,
}  # fmt: skip

_WRITERS: dict[str, Callable[..., None]] = {
    ".obj": write_obj, ".stl": write_stl, ".off": write_off, ".glb": write_glb, ".gltf": write_gltf,
}  # fmt: skip

#: Formats that reference other files, and formats with a defined up axis.
NAMING, UPRIGHT = (".ply", ".obj", ".glb", ".gltf"), (".glb", ".gltf")
UPS = ("y", "z")


def read_mesh(path: str | os.PathLike[str], *, up: str = "y", outside_files: bool = False) -> MeshTable:
    """Read a mesh by extension (one of MESH_READERS); `up` is the up axis of the result for .glb and .gltf."""
    suffix = Path(path).suffix.lower()
    check_up(path, up)
    mesh = MESH_READERS[suffix](path, **({"outside_files": True} if outside_files and suffix in NAMING else {}))
    return rotated_to_z_up(mesh) if up == "z" else mesh


def write_mesh(path: str | os.PathLike[str], mesh: MeshTable, *, ascii: bool, overwrite: bool, up: str = "y") -> None:
    """Write a mesh by extension (one of MESH_READERS).
    `ascii` is for .ply; `up` is the up axis of the mesh, converted to y in .glb and .gltf."""
    suffix = Path(path).suffix.lower()
    check_up(path, up)
    mesh = rotated_to_z_up(mesh, back=True) if up == "z" else mesh
    if suffix == ".ply":
        mesh = _with_fitting_names(path, mesh)
        write_ply_mesh(path, mesh, ascii=ascii, overwrite=overwrite, comments=unit_comment(mesh))
    else:
        if suffix in UPRIGHT:
            mesh = in_metres(path, mesh, "glTF")
        else:
            warn_of_lost_unit(path, mesh)
        _WRITERS[suffix](path, mesh, overwrite=overwrite)


def _with_fitting_names(path: str | os.PathLike[str], mesh: MeshTable) -> MeshTable:
    rules = name_rules(mesh.vertex_normals, mesh.vertex_colors)
    of_vertices = rename(path, "PLY", mesh.attributes, rules, stacklevel=5)
    colors = mesh.triangle_attributes.get("colors")
    others = {name: values for name, values in mesh.triangle_attributes.items() if name != "colors"}
    of_triangles = rename(path, "PLY", others, face_name_rules(colors), stacklevel=5)
    if colors is not None:
        of_triangles = {"colors": colors} | of_triangles
    return replace(mesh, attributes=of_vertices, triangle_attributes=of_triangles)


def check_up(path: str | os.PathLike[str], up: Any) -> None:
    """Raise `ValueError` for an axis other than y, or z if the format defines the up axis."""
    if not isinstance(up, str) or up not in UPS:
        raise ValueError(f"up: expected one of {', '.join(UPS)}, got {shown(up)}")
    suffix = Path(path).suffix.lower()
    if up == "z" and suffix not in UPRIGHT:
        raise ValueError(f"up: only {' and '.join(UPRIGHT)} define an up axis, got {suffix or shown(path)}")


def rotated_to_z_up(mesh: MeshTable, *, back: bool = False) -> MeshTable:
    """Rotate a mesh with y up to z up, or `back`, exactly."""
    normals = None if mesh.vertex_normals is None else _rotated(mesh.vertex_normals, back)
    return replace(mesh, vertices=_rotated(mesh.vertices, back), vertex_normals=normals)


def _rotated(vectors: NDArray[Any], back: bool) -> NDArray[Any]:
    x, y, z = np.asarray(vectors).T
    return np.stack([x, z, 0 - y] if back else [x, 0 - z, y], axis=1)
