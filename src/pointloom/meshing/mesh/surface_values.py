"""Transfer of values from the surface of one mesh to another."""

from __future__ import annotations

from typing import Any, TypeVar

from ...core.array_libraries import view_as
from ...kernels.lang import float32, vec3
from ...kernels.rays.surface_positions import SurfacePositions, middles_of
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.surface.orientation import normalize_vectors
from .mesh_attributes import each, rows_of

Mesh = TypeVar("Mesh", bound=Any)


def with_attributes_of(mesh: Mesh, source: Any, tree: TriangleTree | None = None) -> Mesh:
    """Copy attributes from another mesh about the same origin. Vertices take the values at the nearest surface point
    (floating ones interpolated, others of the nearest corner), triangles those of the triangle nearest to their
    center."""
    columns = {kind: getattr(source, kind).arrays for kind in ("vertex_attributes", "triangle_attributes")}
    if not any(columns.values()) or not len(source) or not mesh.arrays["vertices"].size:
        return mesh
    tree = tree or TriangleTree(source.arrays["vertices"], source.arrays["triangles"])
    arrays: dict[str, Any] = {}
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    if columns["vertex_attributes"]:
        arrays["vertex_attributes"] = each(columns["vertex_attributes"], SurfacePositions(vertices, tree).mixed.of)
    if columns["triangle_attributes"]:
        nearest = SurfacePositions(middles_of(vertices, triangles), tree).triangles
        arrays["triangle_attributes"] = rows_of(columns["triangle_attributes"], nearest)
    return mesh.with_arrays(**arrays)


def with_vectors_of(mesh: Mesh, source: Any, tree: TriangleTree | None = None) -> Mesh:
    """Copy unit normals and colors from the nearest surface points of another mesh."""
    names = [name for name in ("vertex_normals", "vertex_colors") if name in source.arrays]
    if not names or not len(source) or not mesh.arrays["vertices"].size:
        return mesh
    tree = tree or TriangleTree(source.arrays["vertices"], source.arrays["triangles"])
    mixed, arrays = SurfacePositions(mesh.arrays["vertices"], tree).mixed, {}
    for name in names:
        rows = source.arrays[name]
        table = mixed.of(view_as(rows, float32, (rows.size, 3)))
        arrays[name] = view_as(table, vec3, (mixed.count,))
    if "vertex_normals" in arrays:
        arrays["vertex_normals"] = normalize_vectors(arrays["vertex_normals"])
    return mesh.with_arrays(**arrays)
