"""Meshes welded at seams for topological operations, and transfer of the results."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar

from ...kernels.array_types import Array, Indices
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import vec3
from ...kernels.meshes import merge_vertices
from ...kernels.meshes.mesh_edges import SortedEdges, sorted_edges
from ...kernels.meshes.seams import find_seams
from .mesh_arrays import MeshArrays

MeshType = TypeVar("MeshType", bound=MeshArrays)


@dataclass(frozen=True)
class Sewn(Generic[MeshType]):
    """A mesh with coincident seam vertices merged, and the vertex map `sewn_indices` (int32 (m,), None without seams).
    Normals and colors of merged vertices are means, attributes those of the first. Texture stays at the corners.
    `in_order` are the `sorted_edges` of the mesh if they are known."""

    mesh: MeshType
    sewn_indices: Indices | None
    in_order: SortedEdges | None = None

    def spread(self, values: Array) -> Array:
        """Values of the welded mesh's vertices at those of the original mesh."""
        return values if self.sewn_indices is None else gather_rows(values, self.sewn_indices)


def sew(mesh: MeshType) -> Sewn[MeshType]:
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
