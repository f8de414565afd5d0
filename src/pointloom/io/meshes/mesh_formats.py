"""Readers and writers of meshes by extension, as NumPy tables."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import shown
from ...core.errors import FilePath
from ..attribute_names import rename
from ..points.header_units import (
    PLY,
    in_metres,
    is_metric,
    reference_comments,
    warn_of_lost_crs,
    warn_of_lost_reference,
    with_header_reference,
)
from ..points.ply import name_rules, read_ply_mesh, write_ply_mesh
from ..points.ply_faces import face_name_rules
from ..source import netted
from ..table import MeshTable
from ..vtk_files import VTK
from .glb import read_glb
from .glb_writer import storable_in_gltf, write_glb, write_gltf
from .obj import read_obj, storable_in_obj, write_obj
from .off import read_off, storable_in_off, write_off
from .stl import read_stl, storable_in_stl, write_stl
from .vtk_mesh import read_vtk_mesh, storable_in_vtk, write_vtk_mesh


def _all_parts(mesh: MeshTable) -> tuple[MeshTable, list[str]]:
    return mesh, []


@dataclass(frozen=True)
class MeshFormat:
    """A format of meshes.

    Attributes:
        read: Raises only `FileError` for invalid content.
        storable: Removes what the format cannot store. Returns a mesh and the names of the removed parts.
        names_files: True if files of this format name textures or other files.
        is_upright: True if the format defines the up axis, y.
    """

    read: Callable[..., MeshTable]
    write: Callable[..., None]
    storable: Callable[[MeshTable], tuple[MeshTable, list[str]]] = _all_parts
    names_files: bool = False
    is_upright: bool = False


_read_gltf = netted(is_metric(read_glb))

MESH_FORMATS = {
    ".ply": MeshFormat(netted(with_header_reference(PLY)(read_ply_mesh)), write_ply_mesh, names_files=True),
    ".obj": MeshFormat(netted(read_obj), write_obj, storable_in_obj, names_files=True),
    ".stl": MeshFormat(netted(read_stl), write_stl, storable_in_stl),
    ".off": MeshFormat(netted(read_off), write_off, storable_in_off),
    ".vtk": MeshFormat(netted(read_vtk_mesh), write_vtk_mesh, storable_in_vtk),
    ".vtp": MeshFormat(netted(read_vtk_mesh), write_vtk_mesh, storable_in_vtk),
    ".glb": MeshFormat(_read_gltf, write_glb, storable_in_gltf, names_files=True, is_upright=True),
    ".gltf": MeshFormat(_read_gltf, write_gltf, storable_in_gltf, names_files=True, is_upright=True),
}

#: The readers by extension.
MESH_READERS = {extension: format.read for extension, format in MESH_FORMATS.items()}

#: Formats with a defined up axis.
UPRIGHT = tuple(extension for extension, format in MESH_FORMATS.items() if format.is_upright)
UPS = ("y", "z")


def read_mesh(path: FilePath, *, up: str = "y", outside_files: bool = False) -> MeshTable:
    """Read a mesh by extension (one of MESH_READERS); `up` is the up axis of the result for .glb and .gltf."""
    format = MESH_FORMATS[Path(path).suffix.lower()]
    check_up(path, up)
    mesh = format.read(path, **({"outside_files": True} if outside_files and format.names_files else {}))
    return rotated_to_z_up(mesh) if up == "z" else mesh


def write_mesh(path: FilePath, mesh: MeshTable, *, ascii: bool, overwrite: bool, up: str = "y") -> None:
    """Write a mesh by extension (one of MESH_READERS).
    `ascii` is for .ply; `up` is the up axis of the mesh, converted to y in .glb and .gltf."""
    suffix = Path(path).suffix.lower()
    check_up(path, up)
    mesh, format = rotated_to_z_up(mesh, back=True) if up == "z" else mesh, MESH_FORMATS[suffix]
    if suffix == ".ply":
        mesh = _with_fitting_names(path, mesh)
        format.write(path, mesh, ascii=ascii, overwrite=overwrite, comments=reference_comments(mesh))
    elif suffix in VTK:
        write_vtk_mesh(path, mesh, ascii=ascii, overwrite=overwrite)
    elif format.is_upright:
        warn_of_lost_crs(path, mesh)
        format.write(path, in_metres(path, mesh, "glTF"), overwrite=overwrite)
    else:
        warn_of_lost_reference(path, mesh)
        format.write(path, mesh, overwrite=overwrite)


def _with_fitting_names(path: FilePath, mesh: MeshTable) -> MeshTable:
    rules = name_rules(mesh.vertex_normals, mesh.vertex_colors)
    of_vertices = rename(path, "PLY", mesh.attributes, rules, stacklevel=5)
    colors = mesh.triangle_attributes.get("colors")
    others = {name: values for name, values in mesh.triangle_attributes.items() if name != "colors"}
    of_triangles = rename(path, "PLY", others, face_name_rules(colors), stacklevel=5)
    if colors is not None:
        of_triangles = {"colors": colors} | of_triangles
    return replace(mesh, attributes=of_vertices, triangle_attributes=of_triangles)


def check_up(path: FilePath, up: Any) -> None:
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
