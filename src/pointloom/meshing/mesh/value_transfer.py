"""Transfer of values between meshes: over welded seams, from the nearest surface points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Generic

from ...core.array_libraries import view_as
from ...kernels.array_types import Array, Indices
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import float32, vec3
from ...kernels.meshes import merge_vertices
from ...kernels.meshes.mesh_edges import SortedEdges, sorted_edges
from ...kernels.meshes.seams import find_seams
from ...kernels.rays.surface_positions import SurfacePositions, middles_of
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.surface.orientation import normalize_vectors
from .mesh_arrays import Mesh
from .mesh_store import each, rows_of


@dataclass(frozen=True)
class Sewn(Generic[Mesh]):
    """A mesh with coincident seam vertices merged, and the vertex map `sewn_indices` (int32 (m,), None without seams).
    Normals and colors of merged vertices are means, attributes those of the first. Texture stays at the corners.
    `in_order` are the `sorted_edges` of the mesh if they are known."""

    mesh: Mesh
    sewn_indices: Indices | None
    in_order: SortedEdges | None = None

    def spread(self, values: Array) -> Array:
        """Values of the welded mesh's vertices at those of the original mesh."""
        return values if self.sewn_indices is None else gather_rows(values, self.sewn_indices)


def sew(mesh: Mesh) -> Sewn[Mesh]:
    """Weld coincident borders. Closed parts that touch stay separate."""
    arrays = mesh.arrays
    in_order = sorted_edges(arrays["triangles"], arrays["vertices"].size)
    owners = find_seams(arrays["vertices"], arrays["triangles"], in_order)
    if owners is None:
        return Sewn(mesh, None, in_order)
    numbers, count = merge_vertices.number_owners(owners)  # sync
    if count == owners.size:
        return Sewn(mesh, None, in_order)
    owner_rows = merge_vertices.list_owners(owners, numbers, count)
    rows = mesh.arrays.vertices_at(owner_rows)
    means = {name: values for name, values in mesh.arrays.per_vertex().items() if values.dtype == vec3}
    unit = [name == "vertex_normals" for name in means]
    rows |= dict(zip(means, merge_vertices.average_members(means.values(), unit, owners, numbers, count), strict=True))
    triangles = merge_vertices.rename_corners(arrays["triangles"], owners, numbers)
    return Sewn(mesh.with_arrays(triangles=triangles, **rows), gather_rows(numbers, owners))


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
