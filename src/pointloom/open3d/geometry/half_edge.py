"""HalfEdgeTriangleMesh: a triangle mesh with its directed edges, as in Open3D."""

from __future__ import annotations

from typing import Any, Self

import numpy as np

from ...core.attribute_hints import KnownNames
from ..wrapper import unwrap
from .triangle_mesh import TriangleMesh


class HalfEdge(KnownNames):
    """An edge of a triangle. `next` follows in the triangle, `twin` is the opposite one or -1."""

    next: int
    twin: int
    triangle_index: int
    vertex_indices: Any

    def __init__(self) -> None:
        self.next = self.twin = self.triangle_index = -1
        self.vertex_indices = np.full(2, -1, np.int32)

    def is_boundary(self) -> bool:
        return self.twin == -1

    def __repr__(self) -> str:
        start, end = self.vertex_indices
        return (
            f"HalfEdge(vertex_indices {{{start}, {end}}}, triangle_index {self.triangle_index}, next {self.next}, "
            f"twin {self.twin})"
        )


class HalfEdgeTriangleMesh(TriangleMesh):
    """A manifold mesh with `half_edges`, three per triangle, and their indices by start vertex."""

    half_edges: list[HalfEdge]
    ordered_half_edge_from_vertex: list[list[int]]

    def __init__(self, mesh: Any = (), triangles: Any = ()):
        super().__init__(mesh, triangles)
        if not isinstance(mesh, HalfEdgeTriangleMesh):
            self.half_edges, self.ordered_half_edge_from_vertex = [], []

    @classmethod
    def create_from_triangle_mesh(cls, mesh: Any) -> Self:
        """Half-edges of a mesh with vertex normals, without duplicate vertices, duplicate or degenerate triangles, and
        vertices without a triangle.

        Raises ValueError if an edge has two triangles with the same orientation, or a vertex several boundaries or fans
        of triangles. Open3D lists only one fan of such a vertex.
        """
        given = unwrap(mesh, TriangleMesh, "mesh").remove_duplicated_vertices().remove_duplicated_triangles()
        made = cls._of(given.remove_degenerate_triangles().remove_unreferenced_vertices())
        made.compute_vertex_normals()
        triangles = np.array(made.triangles)
        starts = triangles.reshape(-1)
        ends = triangles[:, [1, 2, 0]].reshape(-1)
        count = len(made.vertices)
        keys, opposite = starts.astype(np.int64) * count + ends, ends.astype(np.int64) * count + starts
        order = np.argsort(keys, kind="stable")
        if (np.diff(keys[order]) == 0).any():
            raise ValueError("mesh: expected consistently oriented triangles with at most two per edge")
        places = np.minimum(np.searchsorted(keys[order], opposite), max(len(keys) - 1, 0))
        twins = np.where(keys[order[places]] == opposite, order[places], -1)
        made._store(starts, ends, twins)
        made._order_by_vertex(starts, twins, count)
        return made

    def _store(self, starts: Any, ends: Any, twins: Any) -> None:
        self.half_edges = []
        for index, (start, end, twin) in enumerate(zip(starts, ends, twins.tolist(), strict=True)):
            edge = HalfEdge()
            edge.vertex_indices, edge.triangle_index = np.array([start, end], np.int32), index // 3
            edge.next, edge.twin = _next(index), twin
            self.half_edges.append(edge)

    def _order_by_vertex(self, starts: Any, twins: Any, count: int) -> None:
        """Half-edges of each vertex counterclockwise, from the boundary if there is one."""
        leaving: list[list[int]] = [[] for _ in range(count)]
        for index, start in enumerate(starts.tolist()):
            leaving[start].append(index)
        self.ordered_half_edge_from_vertex = []
        for vertex, edges in enumerate(leaving):
            open_edges = [edge for edge in edges if twins[edge] == -1]
            if len(open_edges) > 1:
                raise ValueError(f"mesh: expected at most one boundary per vertex, got {len(open_edges)} at {vertex}")
            first = (open_edges or edges)[0]
            fan, edge = [first], int(twins[_next(_next(first))])
            while edge not in (-1, first):
                fan.append(edge)
                edge = int(twins[_next(_next(edge))])
            if len(fan) < len(edges):
                reason = f"got {len(edges) - len(fan)} of {len(edges)} triangles apart from the others at {vertex}"
                raise ValueError(f"mesh: expected one fan of triangles at each vertex, {reason}")
            self.ordered_half_edge_from_vertex.append(fan)

    def has_half_edges(self) -> bool:
        return len(self.half_edges) > 0 and len(self.vertices) == len(self.ordered_half_edge_from_vertex)

    def boundary_half_edges_from_vertex(self, vertex_index: int) -> list[int]:
        """Half-edges along the boundary that a vertex is on. Raises ValueError if it is on none."""
        count = len(self.ordered_half_edge_from_vertex)
        if not 0 <= vertex_index < count:
            raise IndexError(f"vertex_index: expected 0 to {count - 1}, a vertex of a triangle, got {vertex_index}")
        first = self.ordered_half_edge_from_vertex[vertex_index][0]
        if not self.half_edges[first].is_boundary():
            raise ValueError(f"vertex_index: expected a vertex on a boundary, got {vertex_index}")
        loop, edge = [first], self._next_on_boundary(first)
        while edge != first:
            loop.append(edge)
            edge = self._next_on_boundary(edge)
        return loop

    def _next_on_boundary(self, edge: int) -> int:
        return self.ordered_half_edge_from_vertex[int(self.half_edges[edge].vertex_indices[1])][0]

    def boundary_vertices_from_vertex(self, vertex_index: int) -> list[int]:
        """Vertices along the boundary that a vertex is on, from this vertex."""
        edges = self.boundary_half_edges_from_vertex(vertex_index)
        return [int(self.half_edges[edge].vertex_indices[0]) for edge in edges]

    def get_boundaries(self) -> list[list[int]]:
        """Vertices along each boundary."""
        boundaries: list[list[int]] = []
        visited: set[int] = set()
        for vertex, edges in enumerate(self.ordered_half_edge_from_vertex):
            if vertex not in visited and self.half_edges[edges[0]].is_boundary():
                boundaries.append(self.boundary_vertices_from_vertex(vertex))
                visited.update(boundaries[-1])
        return boundaries

    def clear(self) -> Self:
        self.half_edges, self.ordered_half_edge_from_vertex = [], []
        return super().clear()

    def __copy__(self) -> Self:
        made = super().__copy__()
        made.half_edges = list(self.half_edges)
        made.ordered_half_edge_from_vertex = [list(edges) for edges in self.ordered_half_edge_from_vertex]
        return made

    def __getstate__(self) -> dict[str, Any]:
        edges = {name: getattr(self, name) for name in ("half_edges", "ordered_half_edge_from_vertex")}
        return super().__getstate__() | {"edges": edges}

    def __setstate__(self, state: dict[str, Any]) -> None:
        super().__setstate__(state)
        vars(self).update(state["edges"])

    def __repr__(self) -> str:
        return f"HalfEdgeTriangleMesh with {len(self.vertices)} points and {len(self.half_edges)} half edges."


def _next(edge: int) -> int:
    return edge // 3 * 3 + (edge + 1) % 3
