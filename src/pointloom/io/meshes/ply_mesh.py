"""Meshes as PLY, with unit and coordinate system in the header and attribute names that the format supports."""

from __future__ import annotations

from dataclasses import replace

from ...core.errors import FilePath
from ..attribute_names import rename
from ..points.header_units import PLY, reference_comments, with_header_reference
from ..points.ply import name_rules, read_ply_mesh, write_ply_mesh
from ..points.ply_faces import face_name_rules
from ..table import MeshTable

read_ply = with_header_reference(PLY)(read_ply_mesh)


def write_ply(path: FilePath, mesh: MeshTable, *, ascii: bool, overwrite: bool) -> None:
    """Write a mesh. Warns of attributes that are renamed."""
    rules = name_rules(mesh.vertex_normals, mesh.vertex_colors)
    of_vertices = rename(path, "PLY", mesh.attributes, rules, stacklevel=5)
    colors = mesh.triangle_attributes.get("colors")
    others = {name: values for name, values in mesh.triangle_attributes.items() if name != "colors"}
    of_triangles = rename(path, "PLY", others, face_name_rules(colors), stacklevel=5)
    if colors is not None:
        of_triangles = {"colors": colors} | of_triangles
    mesh = replace(mesh, attributes=of_vertices, triangle_attributes=of_triangles)
    write_ply_mesh(path, mesh, ascii=ascii, overwrite=overwrite, comments=reference_comments(mesh))
