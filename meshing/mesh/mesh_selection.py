"""Parts of a mesh: removal of triangles and vertices, selection, connected components, cuts by planes and levels."""

from __future__ import annotations

import warnings
from typing import Any, NamedTuple, Self, overload

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import hand_out_host
from ...core.checks import (
    check_count,
    check_direction,
    check_finite,
    check_indices,
    check_number,
    check_numeric,
    check_positive,
    check_shape,
    check_share,
    is_on_gpu,
    shown,
)
from ...core.dropped_results import returns_new
from ...core.gpu_arrays import take_indices, take_mask
from ...kernels.array_types import Mask
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.select import gather_rows, invert_mask, positions_of, positions_of_each
from ...kernels.arrays.sort import positions
from ...kernels.arrays.subsets import other_rows
from ...kernels.extent.masks import mask_finite
from ...kernels.lang import float64, int32, uint8, vec3i
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import cast, download, upload
from ...kernels.meshes import clean_triangles, crowded_edges, merge_vertices, mesh_edits, plane_cut
from ...kernels.meshes.clean_triangles import mask_not_finite
from ...kernels.meshes.close_vertices import find_close_vertices
from ...kernels.meshes.holes import spread_corners
from ...kernels.meshes.level_cut import LevelCut
from ...kernels.meshes.mesh_components import Parts
from ...kernels.meshes.mesh_edits import mark_places, renumber_triangles
from ...kernels.meshes.trim import mask_trimmed
from ...pcd.bounding_box import BoundingBox
from ...pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from ...pcd.line_set import LineSet
from ...pcd.polygon_volume import SelectionPolygonVolume, mask_volume
from .flat_polygons import fill_loops, load_manifold, turn_by_depth
from .mesh_arrays import MeshArrays
from .mesh_attributes import each
from .section_paths import join_lines, lines_in_plane, outline, run_alike

FINEST = 2.0**-45  # of the largest coordinate: cells of a smaller size cannot be told apart in float64


class _Plane(NamedTuple):
    """A plane about a mesh's origin."""

    normal: NDArray[np.float64]  # of unit length
    offset: float  # [m], the height of the origin
    slack: float  # [m], what rounding moves vertices by

    def axes(self) -> NDArray[np.float64]:
        """Two axes in the plane, [2, 3], to the left of each other seen against the normal."""
        u = np.cross(np.eye(3)[np.abs(self.normal).argmin()], self.normal)
        u /= norm(u)
        return np.array([u, np.cross(self.normal, u)])


class MeshSelection(MeshArrays):
    """The part of TriangleMesh that selects, removes and cuts parts of it."""

    @returns_new
    def remove_unreferenced_vertices(self) -> Self:
        """Drop the vertices that no triangle uses; the others keep their order."""
        triangles = self._arrays["triangles"]
        return self._with_used(triangles, mesh_edits.mark_referenced(triangles, self._arrays["vertices"].size))

    @returns_new
    def remove_vertices_by_mask(self, mask: ArrayLike) -> Self:
        """Drop the vertices where a mask is set, and the triangles that have any of them.

        Args:
            mask: Booleans of shape [m].

        Returns:
            What is left, in its order. Vertices that lost all their triangles stay: see `remove_unreferenced_vertices`.

        Raises:
            ValueError: Not booleans, or another shape.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.remove_vertices_by_mask(mesh.vertices[:, 0] + mesh.vertices[:, 1] < 0.5).triangles.tolist()
            [[1, 0, 2]]
        """
        used = cast(self._left_by(mask, self._arrays["vertices"].size, "vertices"), int32)
        whole = self._triangles_at(mesh_edits.whole_triangles(self._arrays["triangles"], used))
        return self._with_used(whole.pop("triangles"), used, **whole)

    @returns_new
    def remove_triangles_by_mask(self, mask: ArrayLike) -> Self:
        """Drop the triangles where a mask is set; all vertices stay.

        Args:
            mask: Booleans of shape [t].

        Raises:
            ValueError: Not booleans, or another shape.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.remove_triangles_by_mask([True, False])
            TriangleMesh(4 vertices, 1 triangles, cpu)
        """
        kept = positions_of(self._left_by(mask, len(self), "triangles"))  # sync
        return self._with_arrays(**self._triangles_at(kept))

    def _with_used(self, triangles: wp.array, used: wp.array, **per_triangle: Any) -> Self:
        """The vertices that are marked, int32 [m] of 1 or 0, and triangles that have no other."""
        rows = self._per_vertex()
        triangles, kept = mesh_edits.keep_vertices(triangles, used, rows.values())
        arrays: dict[str, Any] = dict(zip(rows, kept, strict=True))
        if self._attributes["vertex_attributes"]:
            arrays |= self._attributes_at("vertex_attributes", positions_of(cast(used, uint8)))  # sync
        return self._with_arrays(triangles=triangles, **arrays, **per_triangle)

    def _with_triangles(self, mask: wp.array) -> Self:
        """The triangles where a uint8 device mask is set, and the vertices that they use; one sync."""
        return self._chosen(mask)[0]  # sync

    def _chosen(self, mask: wp.array, *others: wp.array) -> tuple[Any, ...]:
        """As `_with_triangles`: (mesh, rows of the triangles, of the vertices, positions of other masks); one sync."""
        count = self._arrays["vertices"].size
        used = mesh_edits.mark_chosen(self._arrays["triangles"], mask, count)
        rows, vertices, *positions = positions_of_each(mask, used, *others)  # sync
        arrays = self._triangles_at(rows) | self._vertices_at(vertices)
        places = mesh_edits.mark_places(vertices, count)[1]
        arrays["triangles"] = mesh_edits.renumber_triangles(arrays["triangles"], places)
        return self._with_arrays(**arrays), rows, vertices, *positions

    def _left_by(self, mask: ArrayLike, count: int, of: str) -> wp.array:
        """What a mask of removals leaves, uint8 on the mesh's device."""
        if is_on_gpu(mask):
            return invert_mask(take_mask("mask", mask, self._device, count))
        return upload(~_check_mask(mask, count, of), uint8, self._device)

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

    @returns_new
    def remove_triangles_by_index(self, triangle_indices: ArrayLike) -> Self:
        """Drop the triangles at some indices; all vertices stay.

        Args:
            triangle_indices: In -t..t-1, in any order; repeats count once.

        Raises:
            IndexError: An index beyond the mesh; Open3D warns and goes on.
            TypeError: Not whole numbers.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.remove_triangles_by_index([0]).triangles.tolist()
            [[2, 1, 3]]
        """
        rows = self._rows_of("triangle_indices", triangle_indices, len(self), "triangles")
        return self._with_arrays(**self._triangles_at(other_rows(rows, len(self))))

    @returns_new
    def remove_vertices_by_index(self, vertex_indices: ArrayLike) -> Self:
        """Drop the vertices at some indices, and the triangles that have any of them.

        Args:
            vertex_indices: In -m..m-1, in any order; repeats count once.

        Returns:
            What is left, in its order. Vertices that lost all their triangles stay: see `remove_unreferenced_vertices`.

        Raises:
            IndexError: An index beyond the mesh; Open3D warns and goes on.
            TypeError: Not whole numbers.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.remove_vertices_by_index([0]).triangles.tolist()
            [[1, 0, 2]]
        """
        rows = self._rows_of("vertex_indices", vertex_indices, self._vertex_count, "vertices")
        return self._at_vertices(other_rows(rows, self._vertex_count))

    @returns_new
    def select_by_index(self, indices: ArrayLike, cleanup: bool = True) -> Self:
        """The vertices at some indices, in the order given, and the triangles between them.

        Args:
            indices: In -m..m-1; a vertex listed twice counts where it comes first.
            cleanup: Call `remove_duplicated_vertices`, `remove_duplicated_triangles`, `remove_unreferenced_vertices`
                and `remove_degenerate_triangles` on the result, as Open3D does.

        Returns:
            What is left, triangles in their order. Texture stays with its triangles; Open3D leaves it behind.

        Raises:
            IndexError: An index beyond the mesh; Open3D warns and goes on.
            TypeError: Not whole numbers.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.select_by_index([3, 2, 1]).triangles.tolist()
            [[1, 2, 0]]
        """
        rows = self._rows_of("indices", indices, self._vertex_count, "vertices")
        return self._select_vertices(mesh_edits.first_listed(rows, self._vertex_count), cleanup)

    @returns_new
    def crop(
        self, bounding_box: AxisAlignedBoundingBox | OrientedBoundingBox | SelectionPolygonVolume, invert: bool = False
    ) -> Self:
        """The vertices inside a box, its faces included, or inside a polygon volume, and the triangles between them.

        It is `select_by_index` of these vertices, with its clean-up: triangles that reach across the box are left out.

        Args:
            bounding_box: A box, or a polygon volume.
            invert: Take the vertices outside.

        Raises:
            TypeError: No bounding box and no polygon volume.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [3, 3, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.crop(loom.AxisAlignedBoundingBox([0, 0, 0], [2, 2, 0])).triangles.tolist()
            [[0, 1, 2]]
        """
        vertices = self._arrays["vertices"]
        if isinstance(bounding_box, BoundingBox):
            mask = bounding_box.mask_points(vertices, self._origin)
        elif isinstance(bounding_box, SelectionPolygonVolume):
            mask = mask_volume(bounding_box, vertices, self._origin)
        else:
            remedy = "loom.AxisAlignedBoundingBox(min_bound, max_bound) is one"
            raise TypeError(f"bounding_box: expected a bounding box, got {type(bounding_box).__name__}; {remedy}")
        inside = positions_of(mask)  # sync
        return self._select_vertices(other_rows(inside, vertices.size) if invert else inside, True)

    def _rows_of(self, name: str, indices: ArrayLike, count: int, of: str) -> wp.array:
        if is_on_gpu(indices):
            return take_indices(name, indices, self._device, count, of=f"mesh of {count} {of}")
        rows = check_indices(name, indices, count, of=f"mesh of {count} {of}")
        return upload(rows, int32, self._device)

    def _select_vertices(self, rows: wp.array, cleanup: bool) -> Self:
        chosen = self._at_vertices(rows)
        if not cleanup:
            return chosen
        chosen = chosen.remove_duplicated_vertices()
        vertices, triangles = chosen._arrays["vertices"], chosen._arrays["triangles"]
        repeats = clean_triangles.mask_repeats(triangles, vertices.size)
        used = clean_triangles.mask_used(triangles, repeats, vertices.size)  # those of degenerate triangles stay
        degenerate = clean_triangles.mask_degenerate(vertices, triangles, zero_area=False)
        return chosen._left(clean_triangles.join_masks(repeats, degenerate), used)

    def _at_vertices(self, rows: wp.array) -> Self:
        """The vertices at some rows, each once, and the triangles between them."""
        used, places = mesh_edits.mark_places(rows, self._vertex_count)
        whole = self._triangles_at(mesh_edits.whole_triangles(self._arrays["triangles"], used))  # sync
        whole |= {"triangles": mesh_edits.renumber_triangles(whole["triangles"], places)} | self._vertices_at(rows)
        return self._with_arrays(**whole)

    def cluster_connected_triangles(self) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.float64]]:
        """Find the parts of the mesh whose triangles hang together by shared edges.

        Triangles that share but a vertex are of two parts. Vertices at one place with two numbers are two vertices.

        Returns:
            (labels, counts, areas): the part of each triangle, int32 [t]; how many triangles each part has, int32 [c];
            its area [m^2], float64 [c], NaN if a triangle of it has a corner that is not finite. Parts are numbered by
            their first triangles, as Open3D numbers them.

        Notes:
            O(t) memory. Same bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [5, 0, 0], [6, 0, 0], [5, 3, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [4, 5, 6], [2, 1, 3]])
            >>> labels, counts, areas = mesh.cluster_connected_triangles()
            >>> labels.tolist(), counts.tolist(), areas.tolist()
            ([0, 1, 0], [2, 1], [1.0, 1.5])
        """
        parts = self._parts()
        counts, areas = parts.read()
        broken = positions_of(mask_not_finite(self._arrays["vertices"], self._arrays["triangles"]))
        if broken.size:
            areas[download(parts.labels)[download(broken)]] = np.nan
        found = (hand_out_host(values, self._library, self._device) for values in (counts, areas))
        return self._handed_out(parts.labels, dtype=np.int32), *found

    @returns_new
    def remove_small_components(self, min_triangles: int = 1, min_area: float = 0.0) -> Self:
        """Drop the parts of the mesh, as of `cluster_connected_triangles`, that are too small.

        To keep the largest part alone: `mesh.remove_small_components(min_area=areas.max())`.

        Args:
            min_triangles: A part with fewer triangles goes.
            min_area: A part with a smaller area [m^2] goes.

        Returns:
            The other triangles, in their order, and the vertices that they use.

        Raises:
            ValueError: A count below 1, or an area that is negative or not finite.
            TypeError: No numbers.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [5, 0, 0], [6, 0, 0], [5, 3, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [4, 5, 6], [2, 1, 3]])
            >>> mesh.remove_small_components(min_triangles=2)
            TriangleMesh(4 vertices, 2 triangles, cpu)
        """
        count, area = check_count("min_triangles", min_triangles), check_positive("min_area", min_area, allow_zero=True)
        return self._with_triangles(self._parts().mask_large(count, area))  # sync

    def _parts(self) -> Parts:
        return Parts(self._arrays["vertices"], self._arrays["triangles"])

    @returns_new
    def trim(self, vertex_values: ArrayLike, level: float, *, island_ratio: float = 0.001) -> Self:
        """Cut away the surface where values at its vertices, linear in between, are below a level.

        To cut what Poisson's surface makes up where there are no points: `mesh.trim(densities, densities.max() - 2)`.
        Unlike `remove_vertices_by_mask` it cuts through triangles, so the border is a line and not teeth.

        Args:
            vertex_values: One number a vertex, shape [m].
            level: Where to cut; what lies on it stays.
            island_ratio: What is left in parts of less than this share of the mesh's area goes too; then what is gone
                in smaller parts stays where the rest encloses it: a hole, and not a piece at the mesh's own border.
                0 for neither.

        Returns:
            What is left, and the vertices that it uses: in their order, then those on the cut, with normals of unit
            length, colours, texture coordinates and further attributes between those of their edges. Pieces are wound
            as their triangles are.

        Raises:
            ValueError: Another shape, numbers that are not finite, or a ratio that is no share.
            TypeError: No numbers.

        Notes:
            Same bits from run to run and on every device. As SurfaceTrimmer of PoissonRecon does it (`--trim`,
            `--aRatio`).

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]])
            >>> left = mesh.trim([0, 4, 0], 1)
            >>> left.vertices.tolist()
            [[4.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 3.0, 0.0]]
        """
        values = check_numeric("vertex_values", vertex_values)
        count = self._arrays["vertices"].size
        if values.shape != (count,):
            raise ValueError(f"vertex_values: expected shape [{count}], one number a vertex, got {list(values.shape)}")
        values = check_finite("vertex_values", values.astype(np.float64))
        where, ratio = check_number("level", level), check_share("island_ratio", island_ratio)
        cut = LevelCut(self._arrays["triangles"], upload(values, float64, self._device), where)
        whole = self._cut_up(cut)
        mask = mask_trimmed(whole._device_arrays["vertices"], cut, self._arrays["triangles"], ratio)
        return whole._with_triangles(mask)  # sync

    def _cut_up(self, cut: LevelCut) -> Self:
        """All pieces of a cut as a mesh, with all that belongs to vertices and triangles."""
        rows = self._per_vertex()
        arrays: dict[str, Any] = {name: cut.rows_of(rows[name], name == "vertex_normals") for name in rows}
        held = self._attributes["vertex_attributes"]
        if held:
            arrays["vertex_attributes"] = each(held, cut.mixed().of)
        arrays |= self._attributes_at("triangle_attributes", cut.sources)
        if "triangle_uvs" in self._arrays:
            arrays["triangle_uvs"] = cut.corners_of(self._arrays["triangle_uvs"])
        if "triangle_material_ids" in self._arrays:
            arrays["triangle_material_ids"] = gather_rows(self._arrays["triangle_material_ids"], cut.sources)
        return self._with_arrays(triangles=cut.pieces, **arrays)

    @returns_new
    def clip_plane(self, point: ArrayLike, normal: ArrayLike, *, cap: bool = False) -> Self:
        """What lies on the side of a plane to which its normal points.

        Args:
            point: A point of the plane [m], shape [3].
            normal: Where to keep the mesh, shape [3], of any length.
            cap: Close the mesh where the plane opens it. Outlines are filled as the triangles at them turn, so a cavity
                stays one; where these turn different ways, what lies within an odd number of outlines is filled.

        Returns:
            Triangles in their order, cut ones as two or one; vertices in their order, then one for each edge that the
            plane cuts, shared by the triangles there, with normals (of unit length), colours, texture coordinates and
            attributes between those of its ends. Vertices in the plane stay what they are. Without a lid triangles in
            the plane stay; with one those that face up go. The lid's triangles come last and have the vertices of the
            border alone, so a watertight mesh stays watertight; the texture coordinates, materials and attributes of
            its triangles are those of a triangle beside it. Triangles with a corner that is not finite go.

        Raises:
            ValueError: Not three finite numbers, or a normal without a length.
            TypeError: No numbers.
            ImportError: A lid was asked for, and manifold3d is not installed.

        Warns:
            UserWarning: Some outlines are not closed, because the mesh is not: there is no lid.

        Notes:
            A vertex lies in the plane where it is nearer than float32 rounds the largest coordinate about `origin`.
            Some 150 B of memory a triangle. Same bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> half = loom.TriangleMesh.create_box().clip_plane([0.5, 0, 0], [1, 0, 0], cap=True)
            >>> half.is_watertight(), half.get_volume()
            (True, 0.5)
        """
        plane, mesh = self._plane(point, normal)
        if cap:
            load_manifold("cap")
        cut, sides, whole = mesh._cut_by(plane)
        kept = plane_cut.mask_above(sides, with_up=not cap)
        if not cap:
            return whole._with_triangles(kept)  # sync
        above, half_edges = whole._above(cut, sides, kept)  # sync
        return above._with_lid(half_edges, plane)

    @overload
    def slice_plane(self, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike = (0.0,)) -> LineSet: ...
    @overload
    def slice_plane(
        self, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike = (0.0,), *, cap: bool
    ) -> Self: ...
    def slice_plane(
        self, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike = (0.0,), *, cap: bool | None = None
    ) -> Any:
        """The lines in which one or more parallel planes meet the mesh.

        Args:
            point: A point of the plane [m], shape [3].
            normal: Across the plane, shape [3], of any length.
            contour_values: How far above the point the planes lie along the normal [m].
            cap: The mesh above the one plane instead, as trimesh calls it: `clip_plane(point, normal, cap=cap)`.

        Returns:
            A LineSet: the lines of each plane in turn, with one point for each edge that it cuts, shared by the lines
            there. Lines of a mesh that is wound alike run so that it lies to their left, seen against the normal. A
            mesh that only touches a plane from above has no line there; one that stands on it has its outline.

        Raises:
            ValueError: Not three finite numbers, a normal without a length, or contours that are no finite numbers.
            TypeError: No numbers.

        Notes:
            As `clip_plane`, plane by plane.

        Example:
            >>> import pointloom as loom
            >>> ball = loom.TriangleMesh.create_sphere()
            >>> ball.slice_plane([0, 0, 0], [0, 0, 1], contour_values=[-0.5, 0, 0.5])
            LineSet(200 points, 200 lines)
        """
        if cap is not None:
            if not isinstance(cap, bool | np.bool_):
                raise TypeError(f"cap: expected True, False or None, got {shown(cap)}")
            return self.clip_plane(point, normal, cap=bool(cap))
        heights = check_finite("contour_values", np.atleast_1d(check_numeric("contour_values", contour_values)))
        if heights.ndim != 1:
            raise ValueError(f"contour_values: expected shape [k], got {list(heights.shape)}")
        (plane, mesh), points, lines = self._plane(point, normal), [np.zeros((0, 3))], []
        for height in heights.tolist():
            places, ends = mesh._section(plane._replace(offset=plane.offset - height))
            lines.append(ends + sum(map(len, points)))
            points.append(places)
        return LineSet(np.concatenate(points), np.concatenate([np.zeros((0, 2), np.int64), *lines]).astype(np.int32))

    def section_loops(self, point: ArrayLike, normal: ArrayLike) -> list[NDArray[np.float64]]:
        """The lines in which a plane meets the mesh, joined: closed loops first, then paths that end at borders.

        Args:
            point: A point of the plane [m], shape [3].
            normal: Across the plane, shape [3], of any length.

        Returns:
            Points [m] of shape [k, 3] each; the last one of a loop is its first one again. Loops of a mesh that is
            wound alike and outwards run to the left seen against the normal, those of cavities to the right. Where
            loops touch they are parted there.

        Raises:
            ValueError, TypeError: As `slice_plane`.

        Example:
            >>> import pointloom as loom
            >>> [loop] = loom.TriangleMesh.create_box().section_loops([0, 0, 0.25], [0, 0, 1])
            >>> len(loop), loop[0].tolist() == loop[-1].tolist(), loop[:, 2].tolist()[:2]
            (9, True, [0.25, 0.25])
        """
        plane, mesh = self._plane(point, normal)
        points, ends = mesh._section(plane)
        flat = matmul(points - self._origin, plane.axes().T)
        loops, paths = join_lines(ends, dict(enumerate(flat)))
        return [points[[*loop, loop[0]]] for loop in loops] + [points[path] for path in paths]

    def _plane(self, point: ArrayLike, normal: ArrayLike) -> tuple[_Plane, Self]:
        """The plane, and the mesh without triangles that have a corner which is not finite; one sync, two with such."""
        place = check_finite("point", check_shape("point", point, (3,)))
        way, vertices = check_direction("normal", normal), self._arrays["vertices"]
        low, high, count = bound_points(vertices)  # sync
        largest = np.abs([low, high]).max(axis=0).astype(np.float64) if count else np.zeros(3)
        slack = float(
            matmul(
                np.abs(way), plane_cut.ROUNDING * largest + plane_cut.COARSE * (np.abs(self._origin) + np.abs(place))
            )
        )
        mesh = self
        if count < vertices.size:
            mesh = self._without(clean_triangles.mask_not_finite(vertices, self._arrays["triangles"]))  # sync
        return _Plane(way, float(matmul(way, self._origin - place)), slack), mesh

    def _cut_by(self, plane: _Plane) -> tuple[LevelCut, wp.array, Self]:
        """(the cut, the side of each piece, all pieces as a mesh)."""
        heights = plane_cut.measure_heights(self._arrays["vertices"], *plane)
        cut = LevelCut(self._arrays["triangles"], heights, 0.0)
        whole = self._cut_up(cut)
        return cut, plane_cut.find_sides(whole._arrays["vertices"], cut.pieces, cut.sides, plane.normal), whole

    def _section(self, plane: _Plane) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """(points [m] [n, 3], lines between them [k, 2])."""
        cut, sides, whole = self._cut_by(plane)
        rows = positions_of(plane_cut.mark_in_plane(cut))  # sync
        found = plane_cut.read_half_edges(whole._arrays["vertices"], cut.pieces, sides, rows)  # sync
        ends = lines_in_plane(found.rows, self._arrays["vertices"].size)
        used, numbers = np.unique(ends, return_inverse=True)
        return found.places(used) + self._origin, numbers.reshape(-1, 2)

    def _above(self, cut: LevelCut, sides: wp.array, kept: wp.array) -> tuple[Self, plane_cut.HalfEdges]:
        """The pieces that are kept with the vertices that they use, and their half-edges in the plane; two syncs."""
        mesh, rows, chosen, found = self._chosen(kept, plane_cut.mark_in_plane(cut, kept))  # sync
        vertices, pieces = self._arrays["vertices"], cut.pieces
        places = [mesh_edits.mark_places(*listed)[1] for listed in ((chosen, vertices.size), (rows, pieces.size))]
        return mesh, plane_cut.read_half_edges(vertices, pieces, sides, found, (places[0], places[1]))  # sync

    def _with_lid(self, found: plane_cut.HalfEdges, plane: _Plane) -> Self:
        """The pieces above a plane, closed along it."""
        ends = outline(found.rows)[:, ::-1]  # as the lid's triangles run
        used = np.unique(ends)
        flat = matmul(found.places(used), plane.axes()[::-1].T)  # seen from below
        loops, paths = join_lines(ends, dict(zip(used.tolist(), flat, strict=True)))
        if paths:
            warnings.warn(f"cap: {len(paths)} outlines are not closed, as the mesh is not; no lid there", stacklevel=4)
        loops = [loop for loop in loops if len(loop) > 2]
        places = [flat[np.searchsorted(used, loop)] for loop in loops]
        if not run_alike(loops, ends):
            turned = turn_by_depth(places)
            loops = [loop[::-1] if turn else loop for loop, turn in zip(loops, turned, strict=True)]
            places = [place[::-1] if turn else place for place, turn in zip(places, turned, strict=True)]
        numbers = np.array([v for loop in loops for v in loop], np.int32)
        return self._with_more(numbers[fill_loops("cap", places)], found.rows)

    def _with_more(self, lid: NDArray[np.int32], half_edges: NDArray[np.int32]) -> Self:
        """The mesh with more triangles, whose corners take what belongs to the first of some half-edges there."""
        numbers = half_edges[:, 3]
        ends = np.concatenate([half_edges[:, 0], half_edges[:, 1]])
        held = np.concatenate([numbers, numbers - numbers % 3 + (numbers + 1) % 3])
        vertices, first = np.unique(ends, return_index=True)
        corners = held[first][np.searchsorted(vertices, lid.reshape(-1))].astype(np.int32)
        own = self._arrays["triangles"]
        rows = np.concatenate([np.arange(own.size, dtype=np.int32), corners[::3] // 3])
        arrays = self._triangles_at(upload(rows, int32, self._device))
        arrays["triangles"] = concatenate_rows([own, upload(lid, vec3i, self._device)])
        if "triangle_uvs" in self._arrays:
            more = upload(corners, int32, self._device)
            arrays["triangle_uvs"] = spread_corners(self._arrays["triangle_uvs"], more)
        return self._with_arrays(**arrays)


def _check_mask(mask: ArrayLike, count: int, of: str) -> NDArray[np.bool_]:
    chosen = check_numeric("mask", mask)
    if chosen.dtype != np.bool_ and not (chosen.size == 0 and isinstance(mask, list | tuple)):  # [] is float64
        raise ValueError(f"mask: expected booleans, one for each of the mesh's {of}, got {chosen.dtype}")
    if chosen.shape != (count,):
        raise ValueError(f"mask: expected shape [{count}], one for each of the mesh's {of}, got {list(chosen.shape)}")
    return chosen.astype(np.bool_)
