"""A mesh cut where values at its vertices fall below a level."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from ...core.checks import check_finite, check_number, check_numeric, check_share
from ...core.dropped_results import returns_new
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import float64
from ...kernels.memory import upload
from ...kernels.meshes.level_cut import LevelCut
from ...kernels.meshes.trim import mask_trimmed
from .mesh_attributes import each
from .mesh_edits import MeshEdits


class MeshTrim(MeshEdits):
    """The part of TriangleMesh that cuts it by values."""

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
