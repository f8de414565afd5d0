"""Intersection tests of meshes, and boolean operations of solids.

The tests include the edges and corners of triangles and are exact for the stored float32 coordinates. Triangles without
area count as edges. Lists of triangles omit those with a corner that is not finite; `is_self_intersecting` and
`is_intersecting` raise ValueError for them.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.devices import check_same_device
from ...kernels.arrays.concatenation import concatenate_points
from ...kernels.arrays.row_numbers import pair_up
from ...kernels.meshes.mesh_edits import shift_triangles
from ...kernels.rays.cutting_triangles import find_meeting_pairs
from ...kernels.rays.triangle_tree import TriangleTree
from ...pcd.units import common_reference
from .measures import compute_vertex_normals, signed_volume
from .mesh_arrays import Mesh, MeshArrays, check_mesh
from .mesh_checks import REMEDY, check_finite_corners, find_wrong_corner
from .mesh_store import TEXTURE
from .outlines import LIBRARY, load_manifold
from .topology import edge_topology
from .value_transfer import with_attributes_of


def is_self_intersecting(mesh: MeshArrays) -> bool:
    """As `TriangleMesh.is_self_intersecting`."""
    check_finite_corners("is_self_intersecting", mesh)
    return len(get_self_intersecting_triangles(mesh)) > 0


def get_self_intersecting_triangles(mesh: MeshArrays) -> NDArray[np.int32]:
    """As `TriangleMesh.get_self_intersecting_triangles`."""
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    tree = TriangleTree(vertices, triangles)
    first, second = find_meeting_pairs(tree, vertices, triangles, triangles, within=True)
    return mesh.arrays.hand_out(pair_up(first, second))


def is_intersecting(mesh: MeshArrays, other: MeshArrays) -> bool:
    """As `TriangleMesh.is_intersecting`."""
    check_mesh("other", other)
    check_same_device("other", mesh.device, other.device)
    check_finite_corners("is_intersecting", mesh)
    check_finite_corners("is_intersecting: other", other)
    if not len(mesh) or not len(other):
        return False
    own = mesh.arrays["vertices"]
    shifts = [np.zeros(3), other.origin - mesh.arrays.origin]
    vertices = concatenate_points([own, other.arrays["vertices"]], shifts)
    theirs = shift_triangles(other.arrays["triangles"], own.size)
    tree = TriangleTree(vertices, theirs)
    return find_meeting_pairs(tree, vertices, mesh.arrays["triangles"], theirs, within=False)[0].size > 0


def combine(mesh: Mesh, other: Mesh, name: str, operation: Any) -> Mesh:
    """Boolean operation of the method `name`, as a function of two solids of manifold3d."""
    check_mesh("mesh", other)
    library = load_manifold(name)
    with_colors = "vertex_colors" in mesh.arrays and "vertex_colors" in other.arrays
    solids = [
        _solid(library, part, mesh.arrays.origin, with_colors, f"{name}: {what}")
        for what, part in (("the mesh", mesh), ("mesh: it", other))
    ]
    result = operation(*solids)
    _check_status(result, name)
    vertices, triangles, colors = _arrays_of(result)
    make: Any = type(mesh)  # TriangleMesh
    made = make(
        vertices + mesh.arrays.origin,
        triangles,
        vertex_colors=np.clip(colors, 0, 1) if with_colors else None,
        device=mesh.device,
        origin=mesh.arrays.origin,
    )
    made.unit, made.crs = common_reference(f"{name}: the meshes", (mesh, other))
    both = mesh.concatenate([part.with_arrays(**dict.fromkeys(TEXTURE)) for part in (mesh, other)])
    made.arrays.up = both.arrays.up
    if any(both.arrays.attributes.values()):
        source = make(both.vertices, both.triangles, device=mesh.device, origin=mesh.arrays.origin)
        source.arrays.attributes = both.arrays.attributes
        made = with_attributes_of(made, source)
    both_have_normals = "vertex_normals" in mesh.arrays and "vertex_normals" in other.arrays
    return compute_vertex_normals(made) if both_have_normals else made


def _solid(library: Any, mesh: Any, origin: NDArray[np.float64], with_colors: bool, what: str) -> Any:
    """Convert a mesh to a manifold relative to `origin`. Raise ValueError if it is not a solid."""
    if len(mesh):
        if (wrong := find_wrong_corner(mesh)) is not None:
            raise ValueError(f"{what} has NaN or infinite corners: {wrong}; {REMEDY}")
        topology = edge_topology(mesh)
        if topology.has_boundary or topology.has_crowded_edge:
            raise ValueError(f"{what} is not closed. Close holes with repair(hole_size=...) first")
        if topology.has_twisted_edge:
            raise ValueError(f"{what} has inconsistently oriented triangles. Call orient_triangles() first")
        if signed_volume(mesh) < 0:
            raise ValueError(f"{what} faces inward. Call orient_triangles(outward=True) first")
    columns = [mesh.vertices - origin]
    if with_colors:
        columns.append(mesh.vertex_colors)
    properties = np.ascontiguousarray(np.column_stack(columns), np.float64)
    solid = library.Manifold(library.Mesh64(properties, np.ascontiguousarray(mesh.triangles, np.uint64)))
    _check_status(solid, what)
    return solid


def _check_status(solid: Any, what: str) -> None:
    status = solid.status()
    if status.name != "NoError":
        raise ValueError(f"{what} is rejected by {LIBRARY}: {status.name}")


def _arrays_of(solid: Any) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]:
    """(positions (m, 3), triangles (t, 3), other columns); merges vertices that differ only in the latter."""
    mesh = solid.to_mesh64()
    properties = np.asarray(mesh.vert_properties)
    target = np.arange(len(properties))
    target[np.asarray(mesh.merge_from_vert, np.int64)] = np.asarray(mesh.merge_to_vert, np.int64)
    rows, triangles = np.unique(target[np.asarray(mesh.tri_verts, np.int64)], return_inverse=True)
    return properties[rows, :3], triangles.reshape(-1, 3), properties[rows, 3:]
