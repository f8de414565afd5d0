"""Edges, boundaries and manifold tests of a mesh."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.array_libraries import view_as
from ...kernels.array_types import Mask
from ...kernels.arrays.select import gather_rows, positions_of
from ...kernels.lang import int32
from ...kernels.memory import download
from ...kernels.meshes import mesh_edges
from ...kernels.meshes.boundary_loops import Border, find_loops
from ...kernels.meshes.mesh_edits import count_referenced
from ...kernels.meshes.mesh_topology import Topology, find_topology, topology_of
from ...kernels.meshes.orientation import Orientation
from ...kernels.meshes.vertex_neighbors import VertexNeighbors
from .mesh_arrays import MeshArrays
from .mesh_checks import check_finite_corners

MAX_INT32 = 2**31 - 1
TRIANGLES_PER_EDGE = 2  # triangles per edge of a closed surface


class EdgeCounts(NamedTuple):
    """Number of edges: all, of one triangle, of more than two triangles."""

    all: int
    boundary: int
    crowded: int


def edge_topology(mesh: MeshArrays) -> Topology:
    """Count triangles per edge on the device; basis of `is_watertight` and related checks."""
    return topology_of(download(find_topology(mesh.arrays["triangles"], mesh.arrays["vertices"].size)))  # sync


def is_watertight(mesh: MeshArrays) -> bool:
    """As `TriangleMesh.is_watertight`."""
    check_finite_corners("is_watertight", mesh)
    return is_closed(mesh)


def is_closed(mesh: MeshArrays) -> bool:
    """True if there are triangles and each edge has two of them. Corners need not be finite."""
    return len(mesh) > 0 and _has_two_per_edge(edge_topology(mesh))


def check_solid(mesh: MeshArrays, name: str) -> None:
    """Check that the mesh encloses a volume, for the method `name`. Accepts a mesh without triangles."""
    check_finite_corners(name, mesh)
    topology = edge_topology(mesh)
    if not _has_two_per_edge(topology):
        raise ValueError(f"{name}: expected a watertight mesh. Repair it with repair(hole_size=...) first")
    if topology.has_twisted_edge:
        raise ValueError(f"{name}: expected consistently oriented triangles. Call orient_triangles() first")


def is_edge_manifold(mesh: MeshArrays, allow_boundary_edges: bool) -> bool:
    """As `TriangleMesh.is_edge_manifold`."""
    check_finite_corners("is_edge_manifold", mesh)
    topology = edge_topology(mesh)
    return not topology.has_crowded_edge and (allow_boundary_edges or not topology.has_boundary)


def is_vertex_manifold(mesh: MeshArrays) -> bool:
    """As `TriangleMesh.is_vertex_manifold`."""
    check_finite_corners("is_vertex_manifold", mesh)
    return len(get_non_manifold_vertices(mesh)) == 0


def is_orientable(mesh: MeshArrays) -> bool:
    """As `TriangleMesh.is_orientable`."""
    check_finite_corners("is_orientable", mesh)
    return Orientation(mesh.arrays["triangles"], mesh.arrays["vertices"].size).orientable


def get_boundary_edges(mesh: MeshArrays) -> NDArray[np.int32]:
    """As `TriangleMesh.get_boundary_edges`."""
    edges = unique_edges(mesh, padded=True)
    return _ends(mesh, edges, mesh_edges.mask_counts(edges, 1, 1))


def get_boundaries(mesh: MeshArrays) -> list[NDArray[np.int32]]:
    """As `TriangleMesh.get_boundaries`."""
    border = Border(mesh.arrays["triangles"], mesh.arrays["vertices"].size)
    rows, loops, starts = find_loops(border)  # sync
    if not loops.count:
        return []
    vertices, ends = mesh.arrays.hand_out(gather_rows(border.vertices, rows)), starts.tolist()
    return [vertices[first:end] for first, end in pairwise(ends)]


def get_non_manifold_edges(mesh: MeshArrays, allow_boundary_edges: bool) -> NDArray[np.int32]:
    """As `TriangleMesh.get_non_manifold_edges`."""
    edges = unique_edges(mesh)
    mask = mesh_edges.mask_counts(edges, TRIANGLES_PER_EDGE + 1, MAX_INT32)
    if not allow_boundary_edges:
        mask = mesh_edges.mask_other_counts(edges, TRIANGLES_PER_EDGE)
    return _ends(mesh, edges, mask)


def get_non_manifold_vertices(mesh: MeshArrays) -> NDArray[np.int32]:
    """As `TriangleMesh.get_non_manifold_vertices`."""
    mask = mesh_edges.find_split_vertices(mesh.arrays["triangles"], mesh.arrays["vertices"].size)
    return mesh.arrays.hand_out(positions_of(mask))


def compute_adjacency_list(mesh: MeshArrays) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    """As `TriangleMesh.compute_adjacency_list`."""
    count = mesh.arrays["vertices"].size
    neighbors = VertexNeighbors(mesh_edges.MeshEdges(mesh.arrays["triangles"], count), count)
    used = int(download(neighbors.starts[count:])[0])  # sync
    return mesh.arrays.hand_out(neighbors.starts), mesh.arrays.hand_out(view_as(neighbors.vertices, int32, (used,)))


def euler_poincare_characteristic(mesh: MeshArrays) -> int:
    """As `TriangleMesh.euler_poincare_characteristic`."""
    check_finite_corners("euler_poincare_characteristic", mesh)
    used = count_referenced(mesh.arrays["triangles"], mesh.arrays["vertices"].size)
    return used - unique_edges(mesh).count + len(mesh)


def unique_edges(mesh: MeshArrays, padded: bool = False) -> mesh_edges.UniqueKeys:
    return mesh_edges.find_edges(mesh.arrays["triangles"], mesh.arrays["vertices"].size, padded)


def count_edges(mesh: MeshArrays) -> EdgeCounts:
    edges = unique_edges(mesh)
    boundary, crowded = (
        positions_of(mesh_edges.mask_counts(edges, *limits)).size
        for limits in ((1, 1), (TRIANGLES_PER_EDGE + 1, MAX_INT32))
    )
    return EdgeCounts(edges.count, boundary, crowded)


def _has_two_per_edge(topology: Topology) -> bool:
    return not (topology.has_boundary or topology.has_crowded_edge)


def _ends(mesh: MeshArrays, edges: mesh_edges.UniqueKeys, mask: Mask) -> NDArray[np.int32]:
    ends = mesh_edges.edge_ends(edges, positions_of(mask), mesh.arrays["vertices"].size)
    return mesh.arrays.hand_out(ends)
