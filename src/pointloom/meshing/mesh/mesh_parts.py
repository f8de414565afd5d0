"""Parts of a mesh: removal, selection, connected components, cuts."""

from __future__ import annotations

from typing import Any, Self, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.dropped_results import returns_new
from ...pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from ...pcd.line_set import LineSet
from ...pcd.polygon_volume import SelectionPolygonVolume
from . import cuts, selection
from .mesh_arrays import MeshArrays


class MeshParts(MeshArrays):
    """Methods of TriangleMesh that select, remove and cut parts."""

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
        return selection.select_by_index(self, indices, cleanup)

    @returns_new
    def select_faces_by_mask(self, mask: ArrayLike) -> Self:
        """Select triangles by mask, with their vertices.

        Args:
            mask: Booleans of shape (t,).

        Raises:
            ValueError: If the mask is not boolean or has another shape.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box()
            >>> box.select_faces_by_mask(box.compute_triangle_normals()[:, 2] > 0.5)
            TriangleMesh(4 vertices, 2 triangles, cpu)
        """
        return selection.select_faces_by_mask(self, mask)

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
        return selection.crop(self, bounding_box, invert)

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
        return selection.cluster_connected_triangles(self)

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
        return selection.remove_small_components(self, min_triangles, min_area)

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
        return selection.remove_vertices_by_mask(self, mask)

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
        return selection.remove_vertices_by_index(self, vertex_indices)

    @returns_new
    def remove_unreferenced_vertices(self) -> Self:
        """Remove vertices that no triangle uses. The others keep their order."""
        return selection.remove_unreferenced_vertices(self)

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
        return selection.remove_duplicated_vertices(self)

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
        return selection.merge_close(self, "eps", eps)

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
        return selection.remove_triangles_by_mask(self, mask)

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
        return selection.remove_triangles_by_index(self, triangle_indices)

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
        return selection.remove_degenerate_triangles(self, zero_area=zero_area)

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
        return selection.remove_duplicated_triangles(self)

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
        return selection.remove_non_manifold_edges(self)

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
        return cuts.trim(self, vertex_values, level, island_ratio=island_ratio)

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
        return cuts.clip_plane(self, point, normal, cap=cap)

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
        return cuts.slice_plane(self, point, normal, contour_values, cap=cap)

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
        return cuts.section_loops(self, point, normal)
