"""Meshes changed: without what they do not need, and in part."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_numeric, is_on_gpu
from ...core.dropped_results import returns_new
from ...core.gpu_arrays import take_mask
from ...kernels.arrays.select import invert_mask, positions_of, positions_of_each
from ...kernels.lang import int32, uint8
from ...kernels.memory import cast, upload
from ...kernels.meshes import mesh_edits
from .mesh_motion import MeshMotion


class MeshEdits(MeshMotion):
    """The part of TriangleMesh that changes it."""

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


def _check_mask(mask: ArrayLike, count: int, of: str) -> NDArray[np.bool_]:
    chosen = check_numeric("mask", mask)
    if chosen.dtype != np.bool_ and not (chosen.size == 0 and isinstance(mask, list | tuple)):  # [] is float64
        raise ValueError(f"mask: expected booleans, one for each of the mesh's {of}, got {chosen.dtype}")
    if chosen.shape != (count,):
        raise ValueError(f"mask: expected shape [{count}], one for each of the mesh's {of}, got {list(chosen.shape)}")
    return chosen.astype(np.bool_)
