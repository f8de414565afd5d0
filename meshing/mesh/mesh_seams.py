"""Meshes sewn up at their seams for what asks how a surface goes on, and what is found there brought back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar

from ...kernels.array_types import Array, Indices
from ...kernels.arrays.select import gather_rows, positions_of
from ...kernels.lang import vec3
from ...kernels.meshes import merge_vertices
from ...kernels.meshes.seams import find_seams
from .mesh_arrays import MeshArrays

MeshType = TypeVar("MeshType", bound=MeshArrays)


@dataclass(frozen=True)
class Sewn(Generic[MeshType]):
    """A mesh with one vertex a place of its surface, and which of its vertices each one of another mesh has become.

    Files keep two vertices at one place where a texture or a shade has a seam; what moves them on their own tears the
    surface. Normals and colours of such vertices are their means here, attributes those of the first; texture stays at
    its corners.

    Attributes:
        mesh: The sewn mesh; the one that was given where it has no seam.
        places: int32 device array [m]; None where it has none.
    """

    mesh: MeshType
    places: Indices | None

    def spread(self, values: Array) -> Array:
        """Values at the vertices of the sewn mesh at those of the other one."""
        return values if self.places is None else gather_rows(values, self.places)


def sew(mesh: MeshType) -> Sewn[MeshType]:
    """Sew up the borders of a mesh that lie on each other; closed parts that touch stay apart."""
    arrays = mesh._device_arrays
    owners = find_seams(arrays["vertices"], arrays["triangles"])
    if owners is None:
        return Sewn(mesh, None)
    numbers, count = merge_vertices.number_owners(owners)  # sync
    if count == owners.size:
        return Sewn(mesh, None)
    kept = positions_of(merge_vertices.mask_owners(owners), count)
    rows = mesh._vertices_at(kept)
    means = {name: values for name, values in mesh._per_vertex().items() if values.dtype == vec3}
    unit = [name == "vertex_normals" for name in means]
    rows |= dict(zip(means, merge_vertices.average_members(means.values(), unit, owners, numbers, count), strict=True))
    triangles = merge_vertices.rename_corners(arrays["triangles"], owners, numbers)
    return Sewn(mesh._with_arrays(triangles=triangles, **rows), gather_rows(numbers, owners))
