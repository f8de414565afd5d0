"""Meshes without what should not be there: repeated and empty triangles, repeated and close vertices, crowded edges."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp

from ...core.checks import check_positive
from ...core.dropped_results import returns_new
from ...kernels.array_types import Mask
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.select import invert_mask, positions_of, positions_of_each
from ...kernels.arrays.sort import positions
from ...kernels.extent.masks import mask_finite
from ...kernels.meshes import clean_triangles, crowded_edges, merge_vertices
from ...kernels.meshes.close_vertices import find_close_vertices
from ...kernels.meshes.mesh_edits import mark_places, renumber_triangles
from .mesh_edits import MeshEdits

FINEST = 2.0**-45  # of the largest coordinate: cells of a smaller size cannot be told apart in float64


class MeshCleaning(MeshEdits):
    """The part of TriangleMesh that cleans it."""

    @returns_new
    def remove_degenerate_triangles(self, *, zero_area: bool = False) -> Self:
        """Drop the triangles that name a vertex twice; all vertices stay.

        Args:
            zero_area: Drop those without area as well, whose corners lie on one line. Open3D keeps them here, and drops
                them in `remove_non_manifold_edges`.

        Notes:
            Triangles with a corner that is not finite have no area that could be zero, and stay. An area is zero where
            its cross product in float64 is. Same bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 3], [0, 0, 1], [0, 1, 2]])
            >>> mesh.remove_degenerate_triangles().triangles.tolist()
            [[0, 1, 3], [0, 1, 2]]
            >>> mesh.remove_degenerate_triangles(zero_area=True).triangles.tolist()
            [[0, 1, 3]]
        """
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        return self._without(clean_triangles.mask_degenerate(vertices, triangles, zero_area=zero_area))

    @returns_new
    def remove_duplicated_triangles(self) -> Self:
        """Keep the first of triangles that have the same vertices in the same order, from whichever they begin.

        Two triangles that turn opposite ways are two. Open3D misses turned copies of triangles that name a vertex
        twice.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [1, 2, 0], [0, 2, 1]])
            >>> mesh.remove_duplicated_triangles().triangles.tolist()
            [[0, 1, 2], [0, 2, 1]]
        """
        return self._without(clean_triangles.mask_repeats(self._arrays["triangles"], self._vertex_count))

    @returns_new
    def remove_duplicated_vertices(self) -> Self:
        """Make one of the vertices at the same position: the first there, with all that belongs to it.

        Triangles keep their places and name the first vertex; some may then name it twice, see
        `remove_degenerate_triangles`. Positions are equal where all three float32 coordinates are, zero and minus zero
        among them. Vertices with a NaN equal none. Texture stays at its corners.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).remove_duplicated_vertices()
            >>> mesh.triangles.tolist(), len(mesh.vertices)
            ([[0, 1, 2], [1, 3, 2]], 4)
        """
        owners = merge_vertices.find_equal_vertices(self._arrays["vertices"])
        places, count = merge_vertices.number_owners(owners)  # sync
        kept = positions_of(merge_vertices.mask_owners(owners), count)
        triangles = merge_vertices.rename_corners(self._arrays["triangles"], owners, places)
        return self._with_arrays(triangles=triangles, **self._vertices_at(kept))

    @returns_new
    def merge_close_vertices(self, eps: float) -> Self:
        """Make one of the vertices that are closer than a distance, in the order of their numbers.

        A vertex stays unless an earlier one that stays is closer than `eps`; else it joins the first of those. Each
        group becomes one vertex at its mean position, with its mean colour, the direction of its mean normal and the
        further attributes of its first member, at the place of that one. Open3D makes the same groups; it does not
        bring the normals back to unit length.

        Args:
            eps: [m]; vertices exactly so far apart are not close.

        Returns:
            All triangles, of which some may name a vertex twice or be duplicates now: see
            `remove_degenerate_triangles` and `remove_duplicated_triangles`. Texture stays at its corners.

        Raises:
            ValueError: No finite number above 0, or one too small to tell vertices of this mesh apart.

        Notes:
            Distances are compared in float64. Vertices that are not finite stay as they are. O(m) time whatever `eps`
            is, about 130 B of memory a vertex. Same bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [0.5, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 2, 3], [1, 2, 3]])
            >>> merged = mesh.merge_close_vertices(1)
            >>> merged.vertices[0].tolist(), merged.triangles.tolist()
            ([0.25, 0.0, 0.0], [[0, 1, 2], [0, 1, 2]])
        """
        return self._merge_close("eps", eps)

    @returns_new
    def remove_non_manifold_edges(self) -> Self:
        """Drop the smallest triangles at edges that have more than two, until none has; all vertices stay.

        Triangles at such edges are taken in the order of their areas, equal ones by their numbers. One goes if, when
        its turn comes, one of its edges has more than two that are still there. Those that name a vertex twice go
        first.

        Returns:
            A mesh with `is_edge_manifold()`. A mesh that has it already comes back as it is; Open3D drops triangles
            without area from it. Open3D takes edges in the order of a hash table, so it may drop others.

        Notes:
            Areas are compared in float32. About 50 B of memory a half-edge. Same bits from run to run and on every
            device.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [-2, 0, 0], [0, 3, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
            >>> mesh.remove_non_manifold_edges().triangles.tolist()
            [[0, 1, 3], [0, 1, 4]]
        """
        crowded, plain = crowded_edges.find_at_crowded_edges(self._arrays["triangles"], self._vertex_count)
        if not crowded.size:
            return self._with_arrays()
        mesh = self if plain.size == len(self) else self._with_arrays(**self._triangles_at(plain))
        return mesh._without(
            crowded_edges.mask_crowding(mesh._device_arrays["vertices"], mesh._device_arrays["triangles"])
        )

    # ------------------------------------------------------------------------------------------------ internals

    def _merge_close(self, name: str, distance: Any) -> Self:
        """`merge_close_vertices` by a distance that the caller's argument of some name gives."""
        reach, vertices = check_positive(name, distance), self._arrays["vertices"]
        low, high, count = bound_points(vertices)
        extent = float(np.abs([low, high]).max()) if count else 0.0
        if reach < FINEST * extent or reach * reach == 0:
            raise ValueError(
                f"{name}: {reach:g} m is too small for coordinates up to {extent:g} m; remove_duplicated_vertices "
                "merges those at one position"
            )
        owners = positions(vertices.size, self._device)
        find_close_vertices(vertices, positions_of(mask_finite(vertices, True, True), count), reach, owners)
        places, count = merge_vertices.number_owners(owners)  # sync
        rows = self._per_vertex()
        unit = [name == "vertex_normals" for name in rows]
        means = merge_vertices.average_members(rows.values(), unit, owners, places, count)
        triangles = merge_vertices.rename_corners(self._arrays["triangles"], owners, places)
        arrays: dict[str, Any] = dict(zip(rows, means, strict=True))
        if self._attributes["vertex_attributes"]:
            kept = positions_of(merge_vertices.mask_owners(owners), count)
            arrays |= self._attributes_at("vertex_attributes", kept)
        return self._with_arrays(triangles=triangles, **arrays)

    def _without_waste(self) -> Self:
        """Without triangles that are not finite, name a vertex twice or repeat another, and vertices that none has."""
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        gone = clean_triangles.join_masks(
            clean_triangles.mask_repeats(triangles, vertices.size),
            clean_triangles.mask_degenerate(vertices, triangles, zero_area=False),
            clean_triangles.mask_not_finite(vertices, triangles),
        )
        return self._left(gone, clean_triangles.mask_used(triangles, gone, vertices.size))

    def _left(self, gone: Mask, used: Mask) -> Self:
        """The triangles that a mask leaves, and the vertices that another one has, theirs among them; one sync."""
        rows, vertices = positions_of_each(invert_mask(gone), used)  # sync
        taken = self._triangles_at(rows) | self._vertices_at(vertices)
        places = mark_places(vertices, used.size)[1]
        taken["triangles"] = renumber_triangles(taken["triangles"], places)
        return self._with_arrays(**taken)

    @property
    def _vertex_count(self) -> int:
        return self._arrays["vertices"].size

    def _without(self, mask: wp.array) -> Self:
        """The mesh without the triangles where a uint8 device mask is set."""
        return self._with_arrays(**self._triangles_at(positions_of(invert_mask(mask))))  # sync
