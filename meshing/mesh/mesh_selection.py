"""Parts of meshes by number and by place: vertices and triangles at indices, what lies in a box or a polygon volume."""

from __future__ import annotations

from typing import Self

import warp as wp
from numpy.typing import ArrayLike

from ...core.checks import check_indices, is_on_gpu
from ...core.dropped_results import returns_new
from ...core.gpu_arrays import take_indices
from ...kernels.arrays.select import positions_of
from ...kernels.arrays.subsets import other_rows
from ...kernels.lang import int32
from ...kernels.memory import upload
from ...kernels.meshes import clean_triangles, mesh_edits
from ...pcd.bounding_box import BoundingBox
from ...pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from ...pcd.polygon_volume import SelectionPolygonVolume, mask_volume
from .mesh_cleaning import MeshCleaning


class MeshSelection(MeshCleaning):
    """The part of TriangleMesh that chooses parts of it."""

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

    # ------------------------------------------------------------------------------------------------ internals

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
