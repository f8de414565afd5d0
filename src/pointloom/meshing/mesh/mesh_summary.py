"""Size and surface statistics of a mesh for reports."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from .mesh import TriangleMesh
from .topology import count_edges

MAX_ISLAND_AREA = 0.01  # of the area: a part below it is an island, a larger one may be an object
Corner = tuple[float, float, float]


@dataclass(frozen=True)
class MeshSummary:
    """Number of vertices and triangles, and bounds of the finite vertices [m], None without any."""

    vertices: int
    triangles: int
    bounds: tuple[Corner, Corner] | None

    def to_dict(self) -> dict[str, Any]:
        return {"vertices": self.vertices, "triangles": self.triangles, "bounds": _bounds_to_json(self.bounds)}


@dataclass(frozen=True)
class SurfaceSummary:
    """Statistics of a surface.

    Attributes:
        vertices, triangles, parts: Counts. Parts are connected by edges.
        area, largest_fraction: [m^2], and fraction of the largest part.
        islands_fraction: Fraction of the area in parts of less than 1% of it.
        edges, boundary_edges, crowded_edges: All edges, those of one triangle, those of three or more.
        boundary_length: Total length of the boundary edges [m].
        watertight: True if closed.
        bounds: Lowest and highest corner of the finite vertices [m]. None without vertices.
    """

    vertices: int
    triangles: int
    area: float
    parts: int
    largest_fraction: float
    islands_fraction: float
    edges: int
    boundary_edges: int
    crowded_edges: int
    boundary_length: float
    watertight: bool
    bounds: tuple[Corner, Corner] | None

    def to_dict(self) -> dict[str, Any]:
        return {**vars(self), "bounds": _bounds_to_json(self.bounds)}


def describe_mesh(mesh: TriangleMesh) -> MeshSummary:
    return MeshSummary(_vertex_count(mesh), len(mesh), _bounds_of(mesh))


def describe_surface(mesh: TriangleMesh) -> SurfaceSummary:
    _, _, areas = mesh.to(mesh.device, arrays="numpy").cluster_connected_triangles()
    area, edges = float(areas.sum()), count_edges(mesh)
    return SurfaceSummary(
        vertices=_vertex_count(mesh),
        triangles=len(mesh),
        area=area,
        parts=len(areas),
        largest_fraction=float(areas.max() / area) if area else 0.0,
        islands_fraction=float(areas[areas < MAX_ISLAND_AREA * area].sum() / area) if area else 0.0,
        edges=edges.all,
        boundary_edges=edges.boundary,
        crowded_edges=edges.crowded,
        boundary_length=_boundary_length(mesh) if edges.boundary else 0.0,
        watertight=mesh.is_watertight(),
        bounds=_bounds_of(mesh),
    )


def _boundary_length(mesh: TriangleMesh) -> float:
    host = mesh.to(mesh.device, arrays="numpy")
    ends = host.vertices[host.get_boundary_edges()]
    return float(np.sqrt(np.sum((ends[:, 1] - ends[:, 0]) ** 2, axis=1)).sum())


def _vertex_count(mesh: TriangleMesh) -> int:
    return mesh.arrays["vertices"].size


def _bounds_of(mesh: TriangleMesh) -> tuple[Corner, Corner] | None:
    if not _vertex_count(mesh):
        return None
    low, high = (corner.tolist() for corner in mesh.get_axis_aligned_bounding_box())
    return (low[0], low[1], low[2]), (high[0], high[1], high[2])


def _bounds_to_json(bounds: tuple[Corner, Corner] | None) -> dict[str, Any] | None:
    return None if bounds is None else {"min": list(bounds[0]), "max": list(bounds[1])}
