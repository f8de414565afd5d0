"""Meshes as VTK files: legacy (.vtk) and XML (.vtp)."""

from __future__ import annotations

from dataclasses import replace

from ...core.atomic import check_writable
from ...core.errors import FilePath
from ...core.to_other_libraries import UVS
from ..columns import warn_left_out
from ..table import MeshTable
from ..vtk_data import data_of, mesh_of
from ..vtk_files import read_vtk, write_vtk
from .glb_writer import split_seams


def read_vtk_mesh(path: FilePath) -> MeshTable:
    """Read the polygons of a .vtk or .vtp file as triangles."""
    return mesh_of(path, read_vtk(path))


def storable_in_vtk(mesh: MeshTable) -> tuple[MeshTable, list[str]]:
    names = ["textures"] if mesh.textures else []
    return replace(mesh, textures=(), triangle_material_ids=None), names


def write_vtk_mesh(path: FilePath, mesh: MeshTable, *, ascii: bool = False, overwrite: bool = True) -> None:
    """Write a mesh atomically, with colors in 8 bits. Vertices at texture seams are duplicated. `ascii` is for .vtk."""
    path = check_writable(path, overwrite=overwrite)
    mesh, lost = storable_in_vtk(mesh.checked())
    warn_left_out(path, "VTK", lost)
    rows, triangles, uvs = split_seams(mesh)
    colors, normals = mesh.vertex_colors, mesh.vertex_normals
    moved = replace(
        mesh,
        vertices=mesh.vertices[rows],
        triangles=triangles,
        vertex_normals=None if normals is None else normals[rows],
        vertex_colors=None if colors is None else colors[rows],
        attributes={name: values[rows] for name, values in mesh.attributes.items()},
    )
    data = data_of(moved)
    if uvs is not None:
        data.point_data[UVS] = uvs
    write_vtk(path, data, ascii=ascii, overwrite=overwrite)
