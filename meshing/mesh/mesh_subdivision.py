"""Meshes with four triangles in the place of each."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Self

import numpy as np

from ...core.checks import check_count
from ...core.dropped_results import returns_new
from ...kernels.lang import int32
from ...kernels.memory import upload
from ...kernels.remeshing import subdivision
from ...kernels.remeshing.vertex_values import narrow_directions, narrow_rows, widen_rows
from .mesh_arrays import MeshArrays
from .mesh_attributes import each
from .mesh_seams import sew

MOST_CORNERS = 2**31 - 1  # half-edges are counted in 32 bits


class MeshSubdivision(MeshArrays):
    """The part of TriangleMesh that makes it finer."""

    @returns_new
    def subdivide_midpoint(self, number_of_iterations: int = 1) -> Self:
        """Split each triangle into four by a new vertex in the middle of each edge; the surface stays where it is.

        Args:
            number_of_iterations: Rounds, each of which makes four triangles of one.

        Returns:
            The finer mesh, its vertices and triangles in Open3D's order: new vertices behind the old ones as the
            triangles name them. Colours of new vertices are the means of their ends; so are normals, at unit length
            ((0, 0, 1) where the two point against each other), and texture coordinates, corner by corner. Material
            numbers and textures stay, and so do attributes of triangles; those of vertices are means of their ends
            too, or where they are no floating numbers those of the end with the lower number.

        Raises:
            ValueError: A negative count, or more than 715,827,882 triangles.
            TypeError: No whole number.

        Notes:
            About 150 B of memory a triangle of the last round but one. Positions are rounded once, at the end: the
            same bits from run to run and on every device. A NaN vertex makes the new ones on its edges NaN.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> mesh.subdivide_midpoint().triangles.tolist()
            [[0, 3, 5], [3, 1, 4], [4, 2, 5], [3, 4, 5]]
        """
        return self._subdivided(number_of_iterations, subdivision.halve, self._arrays["vertices"].size)

    @returns_new
    def subdivide_loop(self, number_of_iterations: int = 1) -> Self:
        """Split each triangle into four and smooth: in the limit a surface with continuous curvature (Loop 1987).

        Args:
            number_of_iterations: Rounds, each of which makes four triangles of one.

        Returns:
            The finer mesh in the order of `subdivide_midpoint`. Normals (at unit length) and colours follow the masks
            of the positions; texture coordinates are means along the edges of each triangle, and so are further
            attributes, as there. Edges of one triangle are smoothed as curves of their own; at edges of three or more
            all vertices across count alike, as in Open3D. Vertices without triangles stay, where Open3D makes them NaN,
            and a vertex is no neighbour of itself. Vertices at one place of a seam, where borders lie on each other as
            texture leaves them, become one, with the mean of their normals, colours and attributes; in Open3D the
            surface tears there.

        Raises:
            ValueError: A negative count, or more than 715,827,882 triangles.
            TypeError: No whole number.

        Notes:
            As `subdivide_midpoint`. Sums run in float64 over ascending neighbours. A NaN vertex makes its neighbours
            NaN, round by round.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [8, 0, 0], [0, 8, 0]], [[0, 1, 2]]).subdivide_loop()
            >>> mesh.vertices[:, 0].tolist()
            [1.0, 6.0, 1.0, 4.0, 4.0, 0.0]
        """
        count = check_count("number_of_iterations", number_of_iterations, minimum=0)
        return (sew(self).mesh if count and len(self) else self)._subdivided(count, subdivision.mask, 0)

    def _subdivided(self, iterations: int, rule: Callable[..., list[Any]], first_new: int) -> Self:
        """Rounds of a rule for values; normals before `first_new` are as they were."""
        count = check_count("number_of_iterations", iterations, minimum=0)
        if count == 0 or not len(self):
            return self._with_arrays()
        if count > 16 or 3 * len(self) * 4**count > MOST_CORNERS:
            raise ValueError(
                f"number_of_iterations: {count} rounds make {len(self)} * 4^{count} triangles, more than the "
                f"{MOST_CORNERS // 3:,} that 32 bits can count; take fewer"
            )
        arrays: dict[str, Any] = self._arrays | {kind: dict(held) for kind, held in self._attributes.items()}
        names = list(self._per_vertex())
        wide = [widen_rows(arrays[name]) for name in names]
        for _ in range(count):
            triangles = arrays["triangles"]
            split = subdivision.EdgeSplit(triangles, wide[0].size)
            wide = rule(triangles, split, wide)
            arrays["triangles"] = subdivision.split_triangles(triangles, split)
            if arrays["vertex_attributes"]:
                arrays["vertex_attributes"] = each(arrays["vertex_attributes"], subdivision.mixed_ends(split).of)
            if "triangle_uvs" in arrays:
                arrays["triangle_uvs"] = subdivision.split_corners(arrays["triangle_uvs"])
            if "triangle_material_ids" in arrays:
                arrays["triangle_material_ids"] = subdivision.repeat_four_times(arrays["triangle_material_ids"])
        if arrays["triangle_attributes"]:
            quarters = upload(np.repeat(np.arange(len(self), dtype=np.int32), 4**count), int32, self._device)
            arrays |= self._attributes_at("triangle_attributes", quarters)
        for name, rows in zip(names, wide, strict=True):
            if name == "vertex_normals":
                arrays[name] = narrow_directions(rows, self._arrays[name], first_new)
            else:
                arrays[name] = narrow_rows(rows)
        return self._with_arrays(**arrays)
