"""Meshes with fewer triangles: edges that collapse where that changes least, or one vertex a voxel."""

from __future__ import annotations

import warnings
from typing import Any, Self

import numpy as np

from ...core.checks import check_count, check_name, check_positive
from ...core.dropped_results import returns_new
from ...kernels.remeshing.decimation import Decimation
from ...kernels.remeshing.vertex_clustering import cluster_vertices
from .mesh_edits import MeshEdits
from .mesh_rows import TEXTURE
from .surface_values import with_attributes_of

CONTRACTIONS = ("average", "quadric")


class MeshSimplification(MeshEdits):
    """The part of TriangleMesh that thins it."""

    @returns_new
    def simplify_vertex_clustering(self, voxel_size: float, contraction: Any = "average") -> Self:
        """Merge the vertices of each voxel into one, and keep the triangles between three voxels.

        Fast and blunt: sheets closer than a voxel are joined, and edges may get three triangles or more. Where that
        matters take `simplify_quadric_decimation`.

        Args:
            voxel_size: Edge of a voxel [m]; the grid starts half of one below the lowest corner of the vertices.
            contraction: "average" puts the vertex to the mean of those in its voxel, "quadric" to the point nearest to
                the planes of their triangles (to the mean where that is further than a voxel from it), which keeps
                edges sharp. Open3D's `SimplificationContraction` is taken too.

        Returns:
            The mesh, with voxels in the order of their first vertices, and triangles in the order in which they first
            appear, lowest vertex first, each once; two of opposite winding are two, as in Open3D. Normals (unit
            length) and colours are means. Textures and material numbers are left behind: a voxel may hold corners from
            all over a texture. Further attributes are those of the nearest place of the mesh as it was. Vertices that
            are not finite go with their triangles.

        Raises:
            ValueError: Not a positive size, so small that the grid has more than 2^62 voxels, or no such contraction.
            TypeError: No number, or no name.

        Notes:
            O(t) memory, some 150 B a triangle. Same bits from run to run and on every device. Rossignac and Borrel
            1993; with planes Lindstrom 2000. Unlike Open3D's the result does not depend on the unit of length: there
            "quadric" is "average" for a mesh of some decimetres that is given in metres.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [0.1, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 3], [1, 2, 3], [3, 2, 4]])
            >>> mesh.simplify_vertex_clustering(1.0).triangles.tolist()
            [[0, 1, 2], [1, 3, 2]]
        """
        size, way = check_positive("voxel_size", voxel_size), _check_contraction(contraction)
        rows = self._per_vertex()
        unit = [name == "vertex_normals" for name in rows][1:]
        triangles, arrays = cluster_vertices(self._arrays["triangles"], [*rows.values()], unit, size, way == "quadric")
        without: dict[str, Any] = dict.fromkeys(TEXTURE)
        left: dict[str, Any] = without | dict(zip(rows, arrays, strict=True))
        return with_attributes_of(self._bare()._with_arrays(triangles=triangles, **left), self)

    @returns_new
    def simplify_quadric_decimation(
        self, target_number_of_triangles: int, maximum_error: float = np.inf, boundary_weight: float = 1.0
    ) -> Self:
        """Collapse edges, those first whose collapse changes the surface least, until few triangles are left.

        Args:
            target_number_of_triangles: Triangles to be left, 0 and up.
            maximum_error: Edges whose error is larger stay: the sum over the planes that their ends have come to stand
                for of a triangle's area times the squared distance, in the mesh' unit to the fourth, as in Open3D.
            boundary_weight: What the planes that hold borders in place count, beside those of triangles.

        Returns:
            The mesh with as many triangles as asked for, or one less, since an edge goes with all its triangles, mostly
            two; as it is where it has no more. What is left keeps its order; vertices without triangles go. The surface
            keeps its pieces, holes and handles, no edge gets a third triangle, and a watertight mesh stays so. Normals
            (unit length), colours and texture coordinates are those of the place where a vertex comes to lie; borders,
            seams of textures and borders of materials move along themselves alone. Further attributes are those of the
            nearest place of the mesh as it was. Triangles that repeat another or
            have a vertex twice go first.

        Raises:
            ValueError: A negative target or weight, or an error below 0.
            TypeError: No whole number, or no number.

        Warns:
            UserWarning: More triangles are left than asked for, because no edge can go without tearing the mesh.

        Notes:
            Where no edge may collapse any more, and `maximum_error` is infinite, what is asked for comes first: seams
            are let go, then triangles may turn over, then triangles go that share no edge with another. A closed
            piece keeps four triangles.

            Vertices that are not finite stay, with their triangles. Two vertices at one place, as of meshes that are
            cut along their seams, are two, and the cut is a border on either side, along which gaps may open: keep the
            vertices as one and the cut in `triangle_uvs`.

            Some 400 B of memory a triangle. Same bits from run to run and on every device, and for a mesh that is
            scaled by a power of two. Garland and Heckbert 1997, with edges collapsing many at a time; no constant has
            a unit, where Open3D's result depends on that of the mesh.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.meshgrid(np.arange(9.0), np.arange(9.0))
            >>> corners = np.c_[x.ravel(), y.ravel(), np.zeros(81)]
            >>> first = (np.arange(8)[:, None] * 9 + np.arange(8)).ravel()
            >>> lower, upper = np.c_[first, first + 1, first + 9], np.c_[first + 1, first + 10, first + 9]
            >>> mesh = loom.TriangleMesh(corners, np.r_[lower, upper])
            >>> flat = mesh.simplify_quadric_decimation(10)
            >>> len(flat) in (9, 10), round(flat.get_surface_area(), 3)
            (True, 64.0)
        """
        target = check_count("target_number_of_triangles", target_number_of_triangles, minimum=0)
        error = check_positive("maximum_error", maximum_error, allow_zero=True, allow_infinite=True)
        weight = check_positive("boundary_weight", boundary_weight, allow_zero=True)
        if len(self) <= target:
            return self.copy()
        rows = self._per_vertex()
        unit = [name == "vertex_normals" for name in rows][1:]
        uvs, materials = (self._arrays.get(name) for name in TEXTURE)
        job = Decimation(self._arrays["triangles"], [*rows.values()], unit, uvs, materials, target, error, weight)
        job.run()
        triangles, arrays, *texture = job.result()
        kept: dict[str, Any] = dict(zip((*TEXTURE, *rows), (*texture, *arrays), strict=True))
        left = self._bare()._with_arrays(triangles=triangles, **kept)
        if len(left) > target and np.isinf(error):
            warnings.warn(
                f"{len(left)} triangles are left and not {target}: no edge can go without tearing the mesh",
                stacklevel=3,
            )
        return with_attributes_of(left.remove_unreferenced_vertices(), self)


def _check_contraction(contraction: Any) -> str:
    """One of CONTRACTIONS, by its name or as a member of Open3D's enumeration."""
    given = contraction if isinstance(contraction, str) else getattr(contraction, "name", contraction)
    way = check_name("contraction", given).lower()
    if way not in CONTRACTIONS:
        raise ValueError(f"contraction: expected one of {', '.join(CONTRACTIONS)}, got {given!r}")
    return way
