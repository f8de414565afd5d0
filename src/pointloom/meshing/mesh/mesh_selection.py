"""Parts of a mesh: removal of triangles and vertices, selection, connected components, cuts by planes and levels."""

from __future__ import annotations

import warnings
from typing import Any, NamedTuple, Self, TypeVar, overload

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import hand_out_host
from ...core.checks import (
    check_count,
    check_direction,
    check_finite,
    check_fraction,
    check_indices,
    check_number,
    check_numeric,
    check_positive,
    check_shape,
    is_on_gpu,
    shown,
)
from ...core.dropped_results import returns_new
from ...core.exchange import on_host
from ...core.gpu_arrays import take_indices, take_mask
from ...kernels.array_types import Mask
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.duplicates import find_equal_points
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
from ...kernels.meshes.trim import mask_trimmed
from ...pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from ...pcd.line_set import LineSet
from ...pcd.polygon_volume import SelectionPolygonVolume, mask_cropped
from .flat_polygons import fill_loops, load_manifold, loops_to_reverse
from .mesh_arrays import MeshArrays
from .mesh_attributes import each
from .section_paths import join_lines, lines_in_plane, outline, run_alike

Mesh = TypeVar("Mesh", bound="MeshSelection")

MIN_CELL_RATIO = 2.0**-45  # of the largest coordinate: float64 cannot resolve smaller cells


class _Plane(NamedTuple):
    normal: NDArray[np.float64]  # unit length
    offset: float  # [m] height of the origin
    slack: float  # [m] rounding of vertices

    def axes(self) -> NDArray[np.float64]:
        """Two axes in the plane, shape (2, 3), counterclockwise seen against the normal."""
        u = np.cross(np.eye(3)[np.abs(self.normal).argmin()], self.normal)
        u /= norm(u)
        return np.array([u, np.cross(self.normal, u)])


class MeshSelection(MeshArrays):
    """Methods of TriangleMesh that select, remove and cut parts."""

    _internal = ("drop_triangles", "drop_triangles_and_vertices", "merge_close")

    @returns_new
    def remove_unreferenced_vertices(self) -> Self:
        """Remove vertices that no triangle uses. The others keep their order."""
        triangles = self.arrays["triangles"]
        return self._keep_vertices(triangles, mesh_edits.mark_referenced(triangles, self.arrays["vertices"].size))

    @returns_new
    def remove_vertices_by_mask(self, mask: ArrayLike) -> Self:
        """Remove masked vertices and the triangles that use them.

        Args:
            mask: Booleans of shape (m,).

        Returns:
            The remaining mesh in order. Vertices without triangles stay: see `remove_unreferenced_vertices`.

        Raises:
            ValueError: If the mask is not boolean or has another shape.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.remove_vertices_by_mask(mesh.vertices[:, 0] + mesh.vertices[:, 1] < 0.5).triangles.tolist()
            [[1, 0, 2]]
        """
        used = cast(self._inverse_mask(mask, self.arrays["vertices"].size, "vertices"), int32)
        arrays = self.arrays.triangles_at(mesh_edits.complete_triangles(self.arrays["triangles"], used))
        return self._keep_vertices(arrays.pop("triangles"), used, **arrays)

    @returns_new
    def remove_triangles_by_mask(self, mask: ArrayLike) -> Self:
        """Remove masked triangles. All vertices stay.

        Args:
            mask: Booleans of shape (t,).

        Raises:
            ValueError: If the mask is not boolean or has another shape.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.remove_triangles_by_mask([True, False])
            TriangleMesh(4 vertices, 1 triangles, cpu)
        """
        rows = positions_of(self._inverse_mask(mask, len(self), "triangles"))  # sync
        return self.with_arrays(**self.arrays.triangles_at(rows))

    def _keep_vertices(self, triangles: wp.array, used: wp.array, **per_triangle: Any) -> Self:
        """Select by a vertex mask, int32 of 1 or 0, and drop triangles with other vertices."""
        rows = self.arrays.per_vertex()
        triangles, selected = mesh_edits.keep_vertices(triangles, used, rows.values())
        arrays: dict[str, Any] = dict(zip(rows, selected, strict=True))
        if self.arrays.attributes["vertex_attributes"]:
            arrays |= self.arrays.attributes_at("vertex_attributes", positions_of(cast(used, uint8)))  # sync
        return self.with_arrays(triangles=triangles, **arrays, **per_triangle)

    def _inverse_mask(self, mask: ArrayLike, count: int, of: str) -> wp.array:
        """Inverse of a removal mask, uint8 on the mesh's device."""
        if is_on_gpu(mask):
            return invert_mask(take_mask("mask", mask, self.device, count))
        return upload(~_check_mask(mask, count, of), uint8, self.device)

    @returns_new
    def remove_degenerate_triangles(self, *, zero_area: bool = False) -> Self:
        """Remove triangles with a repeated vertex. All vertices stay.

        Triangles with a corner that is not finite stay. Bitwise identical on every device.

        Args:
            zero_area: Also remove triangles with collinear corners (float64 cross product of zero).

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 3], [0, 0, 1], [0, 1, 2]])
            >>> mesh.remove_degenerate_triangles().triangles.tolist()
            [[0, 1, 3], [0, 1, 2]]
            >>> mesh.remove_degenerate_triangles(zero_area=True).triangles.tolist()
            [[0, 1, 3]]
        """
        vertices, triangles = self.arrays["vertices"], self.arrays["triangles"]
        return self.drop_triangles(clean_triangles.mask_degenerate(vertices, triangles, zero_area=zero_area))

    @returns_new
    def remove_duplicated_triangles(self) -> Self:
        """Remove triangles with the same vertices in the same cyclic order as an earlier one.

        Triangles of opposite orientation are not duplicates.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [1, 2, 0], [0, 2, 1]])
            >>> mesh.remove_duplicated_triangles().triangles.tolist()
            [[0, 1, 2], [0, 2, 1]]
        """
        return self.drop_triangles(clean_triangles.mask_repeats(self.arrays["triangles"]))

    @returns_new
    def remove_duplicated_vertices(self) -> Self:
        """Merge vertices at equal positions into the first one, which keeps its attributes.

        Compares the three float32 coordinates. Zero equals minus zero, NaN equals nothing. Triangles are renumbered and
        may become degenerate: see `remove_degenerate_triangles`. Texture stays at the corners.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).remove_duplicated_vertices()
            >>> mesh.triangles.tolist(), len(mesh.vertices)
            ([[0, 1, 2], [1, 3, 2]], 4)
        """
        owners = find_equal_points(self.arrays["vertices"])
        new_indices, count = merge_vertices.number_owners(owners)  # sync
        owner_rows = merge_vertices.list_owners(owners, new_indices, count)
        triangles = merge_vertices.rename_corners(self.arrays["triangles"], owners, new_indices)
        return self.with_arrays(triangles=triangles, **self.arrays.vertices_at(owner_rows))

    @returns_new
    def merge_close_vertices(self, eps: float) -> Self:
        """Merge vertices that are closer than a distance, in index order.

        A vertex joins the first earlier kept vertex closer than `eps`. Else it is kept itself. Each group becomes one
        vertex with the mean position and color, the normalized mean normal, and the other attributes of its first
        member. Open3D makes the same groups. O(m) time, about 130 B per vertex. Bitwise identical on every device.

        Args:
            eps: Exclusive maximum distance [m].

        Returns:
            All triangles. Some may be degenerate or duplicated now: see `remove_degenerate_triangles` and
            `remove_duplicated_triangles`.

        Raises:
            ValueError: If `eps` is not finite and positive, or below the resolution of the coordinates.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [0.5, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 2, 3], [1, 2, 3]])
            >>> merged = mesh.merge_close_vertices(1)
            >>> merged.vertices[0].tolist(), merged.triangles.tolist()
            ([0.25, 0.0, 0.0], [[0, 1, 2], [0, 1, 2]])
        """
        return self.merge_close("eps", eps)

    @returns_new
    def remove_non_manifold_edges(self) -> Self:
        """Remove the smallest triangles at edges of more than two triangles. All vertices stay.

        Triangles with a repeated vertex are removed first. The others are visited by area, then index, and removed if
        one of their edges still has more than two triangles. Areas are compared in float32. About 50 B of memory per
        half-edge. Bitwise identical on every device.

        Returns:
            A mesh with `is_edge_manifold()`. Open3D visits edges in hash order and may remove others.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [-2, 0, 0], [0, 3, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
            >>> mesh.remove_non_manifold_edges().triangles.tolist()
            [[0, 1, 3], [0, 1, 4]]
        """
        crowded = crowded_edges.CrowdedTriangles(self.arrays["triangles"], self.arrays.vertex_count)
        if not crowded.rows.size:
            return self.with_arrays()
        mesh = self
        if crowded.plain.size < len(self):
            mesh = self.with_arrays(**self.arrays.triangles_at(crowded.plain))
            crowded = crowded_edges.CrowdedTriangles(mesh.arrays["triangles"], self.arrays.vertex_count)
        vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
        return mesh.drop_triangles(crowded_edges.mask_crowding(vertices, triangles, crowded))

    def merge_close(self, name: str, distance: float) -> Self:
        """`merge_close_vertices`; `name` is the argument named in errors."""
        radius, vertices = check_positive(name, distance), self.arrays["vertices"]
        low, high, count = bound_points(vertices)
        extent = float(np.abs([low, high]).max()) if count else 0.0
        if radius < MIN_CELL_RATIO * extent or radius * radius == 0:
            raise ValueError(
                f"{name}: {radius:g} m is too small for coordinates up to {extent:g} m. Use remove_duplicated_vertices "
                "to merge vertices at one position"
            )
        owners = positions(vertices.size, self.device)
        find_close_vertices(vertices, positions_of(mask_finite(vertices, True, True), count), radius, owners)
        new_indices, count = merge_vertices.number_owners(owners)  # sync
        rows = self.arrays.per_vertex()
        unit = [name == "vertex_normals" for name in rows]
        means = merge_vertices.average_members(rows.values(), unit, owners, new_indices, count)
        triangles = merge_vertices.rename_corners(self.arrays["triangles"], owners, new_indices)
        arrays: dict[str, Any] = dict(zip(rows, means, strict=True))
        if self.arrays.attributes["vertex_attributes"]:
            owner_rows = merge_vertices.list_owners(owners, new_indices, count)
            arrays |= self.arrays.attributes_at("vertex_attributes", owner_rows)
        return self.with_arrays(triangles=triangles, **arrays)

    def _drop_invalid_triangles(self) -> Self:
        """Remove non-finite, degenerate and duplicate triangles and unused vertices."""
        vertices, triangles = self.arrays["vertices"], self.arrays["triangles"]
        removed = clean_triangles.join_masks(
            clean_triangles.mask_repeats(triangles),
            clean_triangles.mask_degenerate(vertices, triangles, zero_area=False),
            clean_triangles.mask_not_finite(vertices, triangles),
        )
        return self.drop_triangles_and_vertices(removed, clean_triangles.mask_used(triangles, removed, vertices.size))

    def drop_triangles_and_vertices(self, removed: Mask, used: Mask) -> Self:
        """Remove masked triangles, and vertices outside the mask `used`. One sync."""
        rows, vertices = positions_of_each(invert_mask(removed), used)  # sync
        arrays = self.arrays.triangles_at(rows) | self.arrays.vertices_at(vertices)
        new_indices = mesh_edits.mask_and_index(vertices, used.size)[1]
        arrays["triangles"] = mesh_edits.renumber_triangles(arrays["triangles"], new_indices)
        return self.with_arrays(**arrays)

    def drop_triangles(self, mask: wp.array) -> Self:
        """Remove masked triangles. All vertices stay."""
        rows = mesh_edits.unmarked_rows(mask)  # sync
        return self.with_arrays(**({} if rows.size == mask.size else self.arrays.triangles_at(rows)))

    @returns_new
    def remove_triangles_by_index(self, triangle_indices: ArrayLike) -> Self:
        """Remove triangles by index. All vertices stay.

        Args:
            triangle_indices: In -t..t-1, in any order. Repeats count once.

        Raises:
            IndexError, TypeError: If an index is out of range (Open3D warns), or if the indices are not integers.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.remove_triangles_by_index([0]).triangles.tolist()
            [[2, 1, 3]]
        """
        rows = self._rows_of("triangle_indices", triangle_indices, len(self), "triangles")
        return self.with_arrays(**self.arrays.triangles_at(other_rows(rows, len(self))))

    @returns_new
    def remove_vertices_by_index(self, vertex_indices: ArrayLike) -> Self:
        """Remove vertices by index, and the triangles that use them.

        Args:
            vertex_indices: In -m..m-1, in any order. Repeats count once.

        Returns:
            The remaining mesh in order. Vertices without triangles stay: see `remove_unreferenced_vertices`.

        Raises:
            IndexError, TypeError: If an index is out of range (Open3D warns), or if the indices are not integers.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.remove_vertices_by_index([0]).triangles.tolist()
            [[1, 0, 2]]
        """
        rows = self._rows_of("vertex_indices", vertex_indices, self.arrays.vertex_count, "vertices")
        return self._at_vertices(other_rows(rows, self.arrays.vertex_count))

    @returns_new
    def select_by_index(self, indices: ArrayLike, cleanup: bool = True) -> Self:
        """Select vertices by index, in the given order, and the triangles between them.

        Args:
            indices: In -m..m-1. Repeats count once.
            cleanup: Remove duplicated, unreferenced and degenerate vertices and triangles, as Open3D.

        Returns:
            The selection, triangles in order, with their texture (Open3D drops it).

        Raises:
            IndexError, TypeError: If an index is out of range (Open3D warns), or if the indices are not integers.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.select_by_index([3, 2, 1]).triangles.tolist()
            [[1, 2, 0]]
        """
        rows = self._rows_of("indices", indices, self.arrays.vertex_count, "vertices")
        return self._select_vertices(mesh_edits.first_listed(rows, self.arrays.vertex_count), cleanup)

    @returns_new
    def crop(
        self, bounding_box: AxisAlignedBoundingBox | OrientedBoundingBox | SelectionPolygonVolume, invert: bool = False
    ) -> Self:
        """Select the vertices in a box (faces included) or polygon volume and the triangles between them.

        Same as `select_by_index` with cleanup: triangles that cross the boundary are removed.

        Args:
            bounding_box: A box or a polygon volume.
            invert: Select the vertices outside.

        Raises:
            TypeError: If `bounding_box` is of another type.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [3, 3, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.crop(loom.AxisAlignedBoundingBox([0, 0, 0], [2, 2, 0])).triangles.tolist()
            [[0, 1, 2]]
        """
        vertices = self.arrays["vertices"]
        inside = positions_of(mask_cropped(bounding_box, vertices, self.arrays.origin))  # sync
        return self._select_vertices(other_rows(inside, vertices.size) if invert else inside, True)

    def _rows_of(self, name: str, indices: ArrayLike, count: int, of: str) -> wp.array:
        if is_on_gpu(indices):
            return take_indices(name, indices, self.device, count, of=f"mesh of {count} {of}")
        rows = check_indices(name, indices, count, of=f"mesh of {count} {of}")
        return upload(rows, int32, self.device)

    def _select_vertices(self, rows: wp.array, cleanup: bool) -> Self:
        chosen = self._at_vertices(rows)
        if not cleanup:
            return chosen
        chosen = chosen.remove_duplicated_vertices()
        vertices, triangles = chosen.arrays["vertices"], chosen.arrays["triangles"]
        repeats = clean_triangles.mask_repeats(triangles)
        used = clean_triangles.mask_used(triangles, repeats, vertices.size)  # keep those of degenerate triangles
        degenerate = clean_triangles.mask_degenerate(vertices, triangles, zero_area=False)
        return chosen.drop_triangles_and_vertices(clean_triangles.join_masks(repeats, degenerate), used)

    def _at_vertices(self, rows: wp.array) -> Self:
        """Select vertices by row, each once, and the triangles between them."""
        used, new_indices = mesh_edits.mask_and_index(rows, self.arrays.vertex_count)
        arrays = self.arrays.triangles_at(mesh_edits.complete_triangles(self.arrays["triangles"], used))  # sync
        arrays["triangles"] = mesh_edits.renumber_triangles(arrays["triangles"], new_indices)
        arrays |= self.arrays.vertices_at(rows)
        return self.with_arrays(**arrays)

    def cluster_connected_triangles(self) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.float64]]:
        """Find parts of the mesh that are connected by shared edges.

        Triangles that share only a vertex, or coincident vertices with two indices, are not connected. O(t) memory.
        Bitwise identical on every device.

        Returns:
            (labels, counts, areas): part of each triangle, int32 (t,). Triangles of each part, int32 (c,). Area of each
            part [m^2], float64 (c,), NaN if a corner is not finite. Parts are numbered by their first triangle.

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
        broken = positions_of(mask_not_finite(self.arrays["vertices"], self.arrays["triangles"]))
        if broken.size:
            areas[download(parts.labels)[download(broken)]] = np.nan
        results = (hand_out_host(values, self.arrays.library, self.device) for values in (counts, areas))
        return self.arrays.hand_out(parts.labels, dtype=np.int32), *results

    @returns_new
    def remove_small_components(self, min_triangles: int = 1, min_area: float = 0.0) -> Self:
        """Remove small parts, as found by `cluster_connected_triangles`.

        Args:
            min_triangles: Minimum number of triangles of a kept part.
            min_area: Minimum area of a kept part [m^2]; `areas.max()` keeps only the largest part.

        Returns:
            The other triangles, in order, and their vertices.

        Raises:
            ValueError: If a count is below 1, or an area is negative or not finite.
            TypeError: If an argument is not a number.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [5, 0, 0], [6, 0, 0], [5, 3, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [4, 5, 6], [2, 1, 3]])
            >>> mesh.remove_small_components(min_triangles=2)
            TriangleMesh(4 vertices, 2 triangles, cpu)
        """
        count, area = check_count("min_triangles", min_triangles), check_positive("min_area", min_area, allow_zero=True)
        return _keep_triangles(self, self._parts().mask_large(count, area))[0]  # sync

    def _parts(self) -> Parts:
        return Parts(self.arrays["vertices"], self.arrays["triangles"])

    @returns_new
    def trim(self, vertex_values: ArrayLike, level: float, *, island_ratio: float = 0.001) -> Self:
        """Cut away the surface where linearly interpolated vertex values are below a level.

        Removes the surface that Poisson reconstruction extrapolates: `mesh.trim(densities, densities.max() - 2)`. Cuts
        through triangles, unlike `remove_vertices_by_mask`. Bitwise identical on every device. As SurfaceTrimmer of
        PoissonRecon (`--trim`, `--aRatio`).

        Args:
            vertex_values: Values of shape (m,).
            level: Threshold. Values equal to it stay.
            island_ratio: Remaining parts below this fraction of the total area are removed too, and smaller enclosed
                holes are kept filled. 0 disables both.

        Returns:
            The remaining mesh: used vertices in order, then those on the cut, with interpolated attributes.

        Raises:
            ValueError: If the shape is wrong, a number is not finite, or the ratio is out of range.
            TypeError: If an argument is not numeric.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]])
            >>> left = mesh.trim([0, 4, 0], 1)
            >>> left.vertices.tolist()
            [[4.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 3.0, 0.0]]
        """
        values = check_numeric("vertex_values", on_host("vertex_values", vertex_values))
        count = self.arrays["vertices"].size
        if values.shape != (count,):
            raise ValueError(
                f"vertex_values: expected shape [{count}], one number per vertex, got {list(values.shape)}"
            )
        values = check_finite("vertex_values", values.astype(np.float64))
        where, ratio = check_number("level", level), check_fraction("island_ratio", island_ratio)
        cut = LevelCut(self.arrays["triangles"], upload(values, float64, self.device), where)
        cut_mesh = _cut_up(self, cut)
        mask = mask_trimmed(cut_mesh.arrays["vertices"], cut, self.arrays["triangles"], ratio)
        return _keep_triangles(cut_mesh, mask)[0]  # sync

    @returns_new
    def clip_plane(self, point: ArrayLike, normal: ArrayLike, *, cap: bool = False) -> Self:
        """Keep the part of the mesh on the side of a plane that the normal points to.

        Vertices within the float32 rounding of the largest coordinate count as on the plane. About 150 B of memory per
        triangle. Bitwise identical on every device.

        Args:
            point: A point on the plane [m], shape (3,).
            normal: Direction of the kept side, shape (3,), any length.
            cap: Close the cut. Outlines are filled by triangle orientation, else by the even-odd rule.

        Returns:
            Triangles in order, cut ones as one or two. Vertices in order, then one per cut edge with interpolated
            attributes. Triangles in the plane stay without a cap. With one, those facing up are removed. Cap triangles
            come last, share the border vertices, and take texture, material and attributes from a triangle beside them.
            Triangles with a corner that is not finite are removed.

        Raises:
            ValueError: If there are not three finite numbers, or the normal has no length.
            TypeError, ImportError: If an argument is not numeric, or if `cap` is True and manifold3d is not installed.

        Warns:
            UserWarning: If some outlines are not closed because the mesh is open. These get no cap.

        Example:
            >>> import pointloom as loom
            >>> half = loom.TriangleMesh.create_box().clip_plane([0.5, 0, 0], [1, 0, 0], cap=True)
            >>> half.is_watertight(), half.get_volume()
            (True, 0.5)
        """
        plane, mesh = self._plane(point, normal)
        if cap:
            load_manifold("cap")
        cut, sides, cut_mesh = _cut_by(mesh, plane)
        mask = plane_cut.mask_above(sides, with_up=not cap)
        if not cap:
            return _keep_triangles(cut_mesh, mask)[0]  # sync
        above, half_edges = _part_above(cut_mesh, cut, sides, mask)  # sync
        return _with_lid(above, half_edges, plane)

    @overload
    def slice_plane(self, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike = (0.0,)) -> LineSet: ...
    @overload
    def slice_plane(
        self, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike = (0.0,), *, cap: bool
    ) -> Self: ...
    def slice_plane(
        self, point: ArrayLike, normal: ArrayLike, contour_values: ArrayLike = (0.0,), *, cap: bool | None = None
    ) -> Any:
        """Intersect the mesh with one or more parallel planes.

        Args:
            point: A point on the plane [m], shape (3,).
            normal: Normal of the planes, shape (3,), any length.
            contour_values: Offsets of the planes along the normal [m].
            cap: If given, return `clip_plane(point, normal, cap=cap)` instead, as trimesh does.

        Returns:
            A LineSet: the lines plane by plane, one shared point per cut edge. For a consistently oriented mesh, the
            solid is to the left of each line seen against the normal. A mesh that touches a plane from above has none.

        Raises:
            ValueError: If a number is not finite, a shape is wrong, or the normal has no length.
            TypeError: If an argument is not numeric.

        Example:
            >>> import pointloom as loom
            >>> ball = loom.TriangleMesh.create_sphere()
            >>> ball.slice_plane([0, 0, 0], [0, 0, 1], contour_values=[-0.5, 0, 0.5])
            LineSet(200 points, 200 lines)
        """
        heights = check_finite("contour_values", np.atleast_1d(check_numeric("contour_values", contour_values)))
        if heights.ndim != 1:
            raise ValueError(f"contour_values: expected shape [k], got {list(heights.shape)}")
        if cap is not None:
            if not isinstance(cap, bool | np.bool_):
                raise TypeError(f"cap: expected True, False or None, got {shown(cap)}")
            return self.clip_plane(point, normal, cap=bool(cap))
        (plane, mesh), points, lines = self._plane(point, normal), [np.zeros((0, 3))], []
        for height in heights.tolist():
            positions, ends = _section_at(mesh, plane._replace(offset=plane.offset - height))
            lines.append(ends + sum(map(len, points)))
            points.append(positions)
        return LineSet(np.concatenate(points), np.concatenate([np.zeros((0, 2), np.int64), *lines]).astype(np.int32))

    def section_loops(self, point: ArrayLike, normal: ArrayLike) -> list[NDArray[np.float64]]:
        """Intersect the mesh with a plane and join the lines: closed loops first, then open paths.

        Args:
            point: A point on the plane [m], shape (3,).
            normal: Normal of the plane, shape (3,), any length.

        Returns:
            Points [m] of shape (k, 3) per path. A loop repeats its first point at the end. Loops of an outward-oriented
            mesh run counterclockwise seen against the normal, those of cavities clockwise.

        Raises:
            ValueError, TypeError: As `slice_plane`.

        Example:
            >>> import pointloom as loom
            >>> [loop] = loom.TriangleMesh.create_box().section_loops([0, 0, 0.25], [0, 0, 1])
            >>> len(loop), loop[0].tolist() == loop[-1].tolist(), loop[:, 2].tolist()[:2]
            (9, True, [0.25, 0.25])
        """
        plane, mesh = self._plane(point, normal)
        points, ends = _section_at(mesh, plane)
        flat = matmul(points - self.arrays.origin, plane.axes().T)
        loops, paths = join_lines(ends, dict(enumerate(flat)))
        return [points[[*loop, loop[0]]] for loop in loops] + [points[path] for path in paths]

    def _plane(self, point: ArrayLike, normal: ArrayLike) -> tuple[_Plane, Self]:
        """(plane, mesh without non-finite triangles). One sync, two if there are such triangles."""
        center = check_finite("point", check_shape("point", point, (3,)))
        direction, vertices = check_direction("normal", normal), self.arrays["vertices"]
        low, high, count = bound_points(vertices)  # sync
        largest = np.abs([low, high]).max(axis=0).astype(np.float64) if count else np.zeros(3)
        slack = float(
            matmul(
                np.abs(direction),
                plane_cut.FLOAT32_ROUNDING * largest
                + plane_cut.FLOAT64_ROUNDING * (np.abs(self.arrays.origin) + np.abs(center)),
            )
        )
        mesh = self
        if count < vertices.size:
            mesh = self.drop_triangles(clean_triangles.mask_not_finite(vertices, self.arrays["triangles"]))  # sync
        return _Plane(direction, float(matmul(direction, self.arrays.origin - center)), slack), mesh


def _with_more(mesh: Mesh, lid: NDArray[np.int32], half_edges: NDArray[np.int32]) -> Mesh:
    """Add cap triangles whose corners take the attributes of the first of the given half-edges there."""
    numbers = half_edges[:, 3]
    ends = np.concatenate([half_edges[:, 0], half_edges[:, 1]])
    end_corners = np.concatenate([numbers, numbers - numbers % 3 + (numbers + 1) % 3])
    vertices, first = np.unique(ends, return_index=True)
    corners = end_corners[first][np.searchsorted(vertices, lid.reshape(-1))].astype(np.int32)
    current = mesh.arrays["triangles"]
    rows = np.concatenate([np.arange(current.size, dtype=np.int32), corners[::3] // 3])
    arrays = mesh.arrays.triangles_at(upload(rows, int32, mesh.device))
    arrays["triangles"] = concatenate_rows([current, upload(lid, vec3i, mesh.device)])
    if "triangle_uvs" in mesh.arrays:
        more = upload(corners, int32, mesh.device)
        arrays["triangle_uvs"] = spread_corners(mesh.arrays["triangle_uvs"], more)
    return mesh.with_arrays(**arrays)


def _cut_up(mesh: Mesh, cut: LevelCut) -> Mesh:
    """All pieces of a cut as a mesh, with interpolated attributes."""
    rows = mesh.arrays.per_vertex()
    arrays: dict[str, Any] = {name: cut.rows_of(rows[name], name == "vertex_normals") for name in rows}
    columns = mesh.arrays.attributes["vertex_attributes"]
    if columns:
        arrays["vertex_attributes"] = each(columns, cut.mixed().of)
    arrays |= mesh.arrays.attributes_at("triangle_attributes", cut.sources)
    if "triangle_uvs" in mesh.arrays:
        arrays["triangle_uvs"] = cut.corners_of(mesh.arrays["triangle_uvs"])
    if "triangle_material_ids" in mesh.arrays:
        arrays["triangle_material_ids"] = gather_rows(mesh.arrays["triangle_material_ids"], cut.sources)
    return mesh.with_arrays(triangles=cut.pieces, **arrays)


def _keep_triangles(mesh: Mesh, mask: wp.array, *others: wp.array) -> tuple[Any, ...]:
    """Select by a uint8 mask: (mesh, triangle rows, rows of used vertices, positions of other masks). One sync."""
    count = mesh.arrays["vertices"].size
    used = mesh_edits.mark_chosen(mesh.arrays["triangles"], mask, count)
    rows, vertices, *positions = positions_of_each(mask, used, *others)  # sync
    arrays = mesh.arrays.triangles_at(rows) | mesh.arrays.vertices_at(vertices)
    new_indices = mesh_edits.mask_and_index(vertices, count)[1]
    arrays["triangles"] = mesh_edits.renumber_triangles(arrays["triangles"], new_indices)
    return mesh.with_arrays(**arrays), rows, vertices, *positions


def _cut_by(mesh: Mesh, plane: _Plane) -> tuple[LevelCut, wp.array, Mesh]:
    """(cut, side of each piece, mesh of all pieces)."""
    heights = plane_cut.measure_heights(mesh.arrays["vertices"], *plane)
    cut = LevelCut(mesh.arrays["triangles"], heights, 0.0)
    cut_mesh = _cut_up(mesh, cut)
    return cut, plane_cut.find_sides(cut_mesh.arrays["vertices"], cut.pieces, cut.sides, plane.normal), cut_mesh


def _section_at(mesh: Mesh, plane: _Plane) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """(points (n, 3) [m], lines (k, 2))."""
    cut, sides, cut_mesh = _cut_by(mesh, plane)
    rows = positions_of(plane_cut.mark_in_plane(cut))  # sync
    half_edges = plane_cut.read_half_edges(cut_mesh.arrays["vertices"], cut.pieces, sides, rows)  # sync
    ends = lines_in_plane(half_edges.rows, mesh.arrays["vertices"].size)
    used, numbers = np.unique(ends, return_inverse=True)
    return half_edges.positions(used) + mesh.arrays.origin, numbers.reshape(-1, 2)


def _part_above(cut_mesh: Mesh, cut: LevelCut, sides: wp.array, mask: wp.array) -> tuple[Mesh, plane_cut.HalfEdges]:
    """(kept pieces with their vertices, their half-edges in the plane). Two syncs."""
    mesh, rows, chosen, half_edges = _keep_triangles(cut_mesh, mask, plane_cut.mark_in_plane(cut, mask))  # sync
    vertices, pieces = cut_mesh.arrays["vertices"], cut.pieces
    new_indices = [mesh_edits.mask_and_index(*listed)[1] for listed in ((chosen, vertices.size), (rows, pieces.size))]
    return mesh, plane_cut.read_half_edges(
        vertices, pieces, sides, half_edges, (new_indices[0], new_indices[1])
    )  # sync


def _with_lid(mesh: Mesh, half_edges: plane_cut.HalfEdges, plane: _Plane) -> Mesh:
    ends = outline(half_edges.rows)[:, ::-1]  # in the direction of the cap's triangles
    used = np.unique(ends)
    flat = matmul(half_edges.positions(used), plane.axes()[::-1].T)  # seen from below
    loops, paths = join_lines(ends, dict(zip(used.tolist(), flat, strict=True)))
    if paths:
        warnings.warn(
            f"cap: {len(paths)} outlines are not closed, because the mesh is not, and are not capped", stacklevel=4
        )
    loops = [loop for loop in loops if len(loop) > 2]
    polygons = [flat[np.searchsorted(used, loop)] for loop in loops]
    if not run_alike(loops, ends):
        is_reversed = loops_to_reverse(polygons)
        loops = [loop[::-1] if reverse else loop for loop, reverse in zip(loops, is_reversed, strict=True)]
        polygons = [
            polygon[::-1] if reverse else polygon for polygon, reverse in zip(polygons, is_reversed, strict=True)
        ]
    numbers = np.array([v for loop in loops for v in loop], np.int32)
    return _with_more(mesh, numbers[fill_loops("cap", polygons)], half_edges.rows)


def _check_mask(mask: ArrayLike, count: int, of: str) -> NDArray[np.bool_]:
    chosen = check_numeric("mask", mask)
    if chosen.dtype != np.bool_ and not (chosen.size == 0 and isinstance(mask, list | tuple)):  # [] is float64
        raise ValueError(f"mask: expected booleans, one for each of the mesh's {of}, got {chosen.dtype}")
    if chosen.shape != (count,):
        raise ValueError(f"mask: expected shape [{count}], one for each of the mesh's {of}, got {list(chosen.shape)}")
    return chosen.astype(np.bool_)
