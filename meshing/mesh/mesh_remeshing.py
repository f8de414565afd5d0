"""Simplification, remeshing, subdivision, smoothing and deformation of a mesh."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...core.checks import (
    LARGEST_NUMBER,
    check_count,
    check_finite,
    check_name,
    check_number,
    check_positive,
    check_rows,
    shown,
)
from ...core.dropped_results import returns_new
from ...kernels.array_types import Integers
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import int32, vec3d
from ...kernels.memory import check_room, download, fill, upload, zeros
from ...kernels.meshes import clean_triangles
from ...kernels.meshes.mesh_measures import measure
from ...kernels.rays.surface_places import SurfacePlaces
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.remeshing import subdivision
from ...kernels.remeshing.creased_mesh import CreasedMesh, crease_segments, find_features
from ...kernels.remeshing.decimation import Decimation
from ...kernels.remeshing.flipped_edges import flip_edges
from ...kernels.remeshing.long_edges import split_long_edges
from ...kernels.remeshing.mesh_filters import approach_mean_kernel, average_kernel, filter_values, sharpen_kernel
from ...kernels.remeshing.relaxed_vertices import choose_places, move_where_nothing_turns, relaxed
from ...kernels.remeshing.rigid_deformation import deform_rigidly, turn_directions
from ...kernels.remeshing.short_edges import collapse_short_edges
from ...kernels.remeshing.vertex_clustering import cluster_vertices
from ...kernels.remeshing.vertex_values import narrow_directions, narrow_rows, widen_rows
from .mesh_attributes import each
from .mesh_measures import MeshMeasures
from .mesh_rows import PER_VERTEX, TEXTURE
from .mesh_seams import sew
from .surface_values import with_attributes_of, with_vectors_of
from .vertex_numbers import check_finite_vertices, check_vertices

CONTRACTIONS = ("average", "quadric")
MOST_TRIANGLES = 2**29  # half-edges and what they become are counted in 32 bits
LONG, SHORT = 4 / 3, 4 / 5  # of the length asked for: edges beyond are split or collapse (Botsch and Kobbelt 2004)
RELAXED = 2  # times that vertices move in an iteration
ROUNDS = 3  # of collapses and of flips in an iteration; each is a set of edges of which none is next to another
LEAST_CREASE = 3.0  # of the length asked for: what hangs together over less is roughness
MOST_ITERATIONS = 1000
TRIANGLE_BYTES = 400  # while it works
FEW = 0.002  # of all edges: where a round changes fewer, it is the last
MOST_CORNERS = 2**31 - 1  # half-edges are counted in 32 bits
MOST_PASSES = 10_000
SCOPES = {"all": tuple(PER_VERTEX), "vertex": ("vertices",), "normal": ("vertex_normals",), "color": ("vertex_colors",)}
MOST_TURNS = 10_000
ENERGIES = ("spokes", "smoothed")


class MeshRemeshing(MeshMeasures):
    """The part of TriangleMesh that simplifies, remeshes, subdivides, smooths and deforms it."""

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

    @returns_new
    def remesh_isotropic(self, edge_length: float, iterations: int = 10, *, feature_angle: float = 30.0) -> Self:
        """The same surface in triangles that are nearly equilateral, with edges of about one length.

        Long edges split, short ones collapse, others flip where vertices have more or fewer than six triangles;
        vertices move along the surface to where triangles become alike, and are put back onto the surface as it was.

        Args:
            edge_length: [m]; edges come to lie between 4/5 and 4/3 of it, where creases leave room.
            iterations: How often all that is done.
            feature_angle: Edges at which triangles meet at more than this [degrees] are creases: they stay where they
                are, in other parts; so do borders, and edges that are not manifold. Where creases bend by more, or
                meet, vertices stay. Creases that hang together over less than three edges are roughness, and none. 180
                keeps borders alone.

        Returns:
            The remeshed surface. It keeps its pieces, holes and handles; a watertight mesh stays so, and no triangle
            turns by more than 60 degrees in one step. Colours, normals (of unit length) and attributes are those of
            the nearest place of the mesh as it was. Textures are left behind: `bake_vertex_colors` keeps colours.
            Triangles that repeat another, name a vertex twice or are not finite go first.

        Raises:
            ValueError: No length above 0, one so small that there would be more than 2^29 triangles, a count below 0
                or above 1000, or no angle from 0 to 180.
            MemoryError: There is no room for so many triangles.
            TypeError: No numbers.

        Notes:
            Some 400 B of memory a triangle. Same bits from run to run and on every device. Botsch and Kobbelt, "A
            remeshing approach to multiresolution modeling", 2004, with edges taken many at a time, and triangles' areas
            for weights.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> box = loom.TriangleMesh.create_box().remesh_isotropic(0.1)
            >>> box.is_watertight(), round(box.get_volume(), 6), round(box.get_surface_area(), 6)
            (True, 1.0, 6.0)
        """
        target = check_positive("edge_length", edge_length, maximum=LARGEST_NUMBER)
        count = check_count(
            "iterations", iterations, minimum=0, maximum=MOST_ITERATIONS, because="ten bring most of it"
        )
        angle = check_number("feature_angle", feature_angle)
        if not 0 <= angle <= 180:
            raise ValueError(f"feature_angle: expected 0 to 180 degrees, got {angle:g}")
        source = self._without_waste()  # sync
        if not count or not len(source):
            return source._with_arrays(**dict.fromkeys(TEXTURE))
        vertices, triangles = source._arrays["vertices"], source._arrays["triangles"]
        low, high, _ = bound_points(vertices)  # sync
        span, area = float(np.abs([low, high]).max()), measure(vertices, triangles)[0]  # sync
        if target < 2.0**-20 * span or area > MOST_TRIANGLES * 0.25 * target**2:
            raise ValueError(
                f"edge_length: {target:g} m is too small for a mesh of {area:g} m2 that reaches {span:g} m"
            )
        expected = area / (0.43 * target**2)  # of equilateral triangles
        check_room(self._device, int(TRIANGLE_BYTES * expected), f"some {expected:,.0f} triangles")
        surface = TriangleTree(vertices, triangles, all_finite=True)
        mesh = _remesh(surface, target, count, math.radians(angle))
        bare = source._bare()._with_arrays(vertex_normals=None, vertex_colors=None, **dict.fromkeys(TEXTURE))
        made = bare._with_arrays(vertices=mesh.vertices, triangles=mesh.triangles)._without_gone()
        return with_attributes_of(with_vectors_of(made, source, surface), source, surface)

    def _without_gone(self) -> Self:
        """Without triangles that name a vertex three times, and vertices that none has; one sync."""
        triangles, count = self._arrays["triangles"], self._vertex_count
        gone = clean_triangles.mask_degenerate(self._arrays["vertices"], triangles, zero_area=False)
        return self._left(gone, clean_triangles.mask_used(triangles, gone, count))

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

    @returns_new
    def filter_smooth_simple(self, number_of_iterations: int = 1, filter_scope: Any = "all") -> Self:
        """Move each vertex to the mean of itself and its neighbours.

        Args:
            number_of_iterations: Passes.
            filter_scope: What is smoothed: "all", "vertex", "normal" or "color", or a member of Open3D's FilterScope.

        Returns:
            The mesh with what was smoothed in place of what it was, and all else as it was. Normals are of unit length
            (Open3D leaves them shorter). A vertex that is not finite stays and counts for no neighbour. Vertices at one
            place of a seam, where borders lie on each other as texture leaves them, count as one: they move together
            (in Open3D the surface tears there) and get the mean of their normals and colours.

        Raises:
            ValueError: Iterations outside 0..10,000; an unknown scope, or one that the mesh has nothing of.
            TypeError: No whole number.

        Notes:
            O(m + t) memory. Sums run in float64 over ascending neighbours, and positions are rounded once, at the end:
            the same bits from run to run. With the scopes Normal and Color Open3D's vertices hold what was in memory.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 3]], [[0, 1, 2]])
            >>> roof.filter_smooth_simple().vertices[0].tolist()
            [1.0, 1.0, 1.0]
        """
        return self._filtered([(average_kernel, 0.0)], number_of_iterations, filter_scope)

    @returns_new
    def filter_smooth_laplacian(
        self, number_of_iterations: int = 1, lambda_filter: float = 0.5, filter_scope: Any = "all"
    ) -> Self:
        """Move each vertex towards the mean of its neighbours, weighted by one over their distances.

        Smooths everything and shrinks what is curved or open; see `filter_smooth_taubin`.

        Args:
            number_of_iterations: Passes.
            lambda_filter: Share of the way a pass.
            filter_scope: As of `filter_smooth_simple`.

        Returns:
            As `filter_smooth_simple`. A vertex without neighbours stays, where Open3D makes it NaN.

        Raises:
            ValueError: As `filter_smooth_simple`; a factor that is not finite.
            TypeError: No numbers.

        Notes:
            As `filter_smooth_simple`. Distances are those of the positions before the pass. Taubin, "A signal
            processing approach to fair surface design", SIGGRAPH 1995, equation 2.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 0]], [[0, 1, 2]])
            >>> roof.filter_smooth_laplacian(1, lambda_filter=1.0).vertices[0].tolist()
            [1.5, 1.5, 0.0]
        """
        factor = check_number("lambda_filter", lambda_filter)
        return self._filtered([(approach_mean_kernel, factor)], number_of_iterations, filter_scope)

    @returns_new
    def filter_smooth_taubin(
        self, number_of_iterations: int = 1, lambda_filter: float = 0.5, mu: float = -0.53, filter_scope: Any = "all"
    ) -> Self:
        """Smooth without shrinking: each iteration is a pass with `lambda_filter` and one back with `mu`.

        Args:
            number_of_iterations: Pairs of passes.
            lambda_filter: Share of the way to the weighted mean of the neighbours, > 0.
            mu: The same of the second pass; below -lambda_filter, which lets low frequencies through.
            filter_scope: As of `filter_smooth_simple`.

        Returns:
            As `filter_smooth_laplacian`.

        Raises:
            ValueError: As `filter_smooth_simple`; a factor that is not finite.
            TypeError: No numbers.

        Notes:
            As `filter_smooth_laplacian`, with twice the passes. Taubin 1995, section 3.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 0]], [[0, 1, 2]])
            >>> roof.filter_smooth_taubin(5)
            TriangleMesh(3 vertices, 1 triangles, cpu)
        """
        factors = (check_number("lambda_filter", lambda_filter), check_number("mu", mu))
        return self._filtered([(approach_mean_kernel, f) for f in factors], number_of_iterations, filter_scope)

    @returns_new
    def filter_sharpen(self, number_of_iterations: int = 1, strength: float = 1, filter_scope: Any = "all") -> Self:
        """Move each vertex away from its neighbours, which makes edges and noise stand out.

        Args:
            number_of_iterations: Passes.
            strength: How far: in sums of the differences between a vertex and its neighbours.
            filter_scope: As of `filter_smooth_simple`.

        Returns:
            As `filter_smooth_simple`. Colours are not cut to 0..1, as in Open3D.

        Raises:
            ValueError: As `filter_smooth_simple`; a strength that is not finite.
            TypeError: No numbers.

        Notes:
            As `filter_smooth_simple`.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 3]], [[0, 1, 2]])
            >>> roof.filter_sharpen(strength=0.5).vertices[0].tolist()
            [-1.5, -1.5, -1.5]
        """
        factor = check_number("strength", strength)
        return self._filtered([(sharpen_kernel, factor)], number_of_iterations, filter_scope)

    def _filtered(self, passes: list[tuple[Any, float]], iterations: int, scope: Any) -> Self:
        reason = "by then hardly anything is left but the mean of all vertices; take fewer"
        count = check_count("number_of_iterations", iterations, minimum=0, maximum=MOST_PASSES, because=reason)
        names = [name for name in _names_of(scope) if name in self._arrays]
        if not names:
            raise ValueError(f"filter_scope: the mesh has no {_names_of(scope)[0]} to filter")
        if count == 0 or not len(self):
            return self._with_arrays()
        sewn = sew(self)
        arrays = sewn.mesh._device_arrays
        wide = {name: widen_rows(arrays[name]) for name in {"vertices", *names}}
        values = filter_values(arrays["triangles"], wide["vertices"], names, wide, passes * count)
        narrow: dict[str, Any] = {}
        for name, rows in values.items():
            if name == "vertex_normals":
                narrow[name] = sewn.spread(narrow_directions(rows, arrays[name]))
            else:
                narrow[name] = sewn.spread(narrow_rows(rows))
        return self._with_arrays(**narrow)

    @returns_new
    def deform_as_rigid_as_possible(
        self,
        constraint_vertex_indices: Any,
        constraint_vertex_positions: Any,
        max_iter: int,
        energy: Any = "spokes",
        smoothed_alpha: float = 0.01,
    ) -> Self:
        """Put some vertices somewhere, and let the others follow so that the surface around each stays as it was.

        Args:
            constraint_vertex_indices: Vertices that are put, each once: those that move and those that are to stay.
            constraint_vertex_positions: Where [m], shape [k, 3].
            max_iter: Turns, of rotations and then positions.
            energy: "spokes" (Sorkine and Alexa 2007) or "smoothed", which keeps neighbouring rotations alike (Levi and
                Gotsman 2014); or a member of Open3D's DeformAsRigidAsPossibleEnergy.
            smoothed_alpha: How much, in areas of the mesh.

        Returns:
            The bent mesh. Normals turn with their vertices, all else stays; Open3D drops it. Parts of the mesh that
            hang together with none of the given vertices stay where they are, where Open3D finds no solution; so do
            vertices that are not finite. A triangle without area weighs nothing. Vertices at one place of a seam, where
            borders lie on each other as texture leaves them, move together; it is enough to give one of them.

        Raises:
            ValueError: No vertex, one that does not exist, is given twice or is not finite; another number of
                positions, one that is not finite, or two for vertices at one place of a seam; max_iter outside
                0..10,000; an unknown energy; a smoothed_alpha below 0.
            TypeError: No numbers.
            ArithmeticError: Triangles so thin that positions do not settle; not seen so far.

        Notes:
            Each turn solves for the positions to a billionth of the mesh's stretch, so it agrees with Open3D's direct
            solver to rounding to float32. O(m + t) memory, about 1 kB a vertex. Sums in float64 in fixed orders: the
            same bits from run to run. Cotangent weights as in Open3D, not below 0. With max_iter=0 nothing moves.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 2, 0], [1, 2, 0]]
            >>> strip = loom.TriangleMesh(corners, [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])
            >>> moved = strip.deform_as_rigid_as_possible([0, 1], [[0, 0, 5], [1, 0, 5]], max_iter=30)
            >>> moved.vertices[4].round(3).tolist()
            [0.0, 2.0, 5.0]
        """
        count = self._arrays["vertices"].size
        held = check_vertices("constraint_vertex_indices", constraint_vertex_indices, count)
        targets = check_rows("constraint_vertex_positions", constraint_vertex_positions, 3, dtype=np.float64)
        if len(targets) != len(held):
            raise ValueError(
                f"constraint_vertex_positions: expected shape [{len(held)}, 3], one row for each of the vertices, got "
                f"{list(targets.shape)}"
            )
        check_finite("constraint_vertex_positions", targets)
        numbers, repeats = np.unique(held, return_counts=True)
        if len(numbers) < len(held):
            raise ValueError(
                f"constraint_vertex_indices: vertex {numbers[repeats > 1][0]} is given twice; give it once"
            )
        reason = "by then nothing moves any more; take fewer"
        turns = check_count("max_iter", max_iter, minimum=0, maximum=MOST_TURNS, because=reason)
        alpha = check_positive("smoothed_alpha", smoothed_alpha, allow_zero=True)
        likeness = alpha * self._finite_area() if _energy_of(energy) == "smoothed" else 0.0
        if turns == 0:
            return self._with_arrays()
        rows = upload(held, int32, self._device)
        check_finite_vertices("constraint_vertex_indices", held, gather_rows(self._arrays["vertices"], rows))
        sewn = sew(self)
        if sewn.places is not None:
            held, targets = _once(held, download(gather_rows(sewn.places, rows)), targets)  # sync
            rows = upload(held, int32, self._device)
        places, arrays = upload(targets - self._origin, vec3d, self._device), sewn.mesh._device_arrays
        moved, rotations = deform_rigidly(arrays["vertices"], arrays["triangles"], rows, places, turns, likeness)
        bent: dict[str, Any] = {"vertices": sewn.spread(narrow_rows(moved))}
        if "vertex_normals" in self._arrays:
            bent["vertex_normals"] = turn_directions(rotations, self._arrays["vertex_normals"], sewn.places)
        return self._with_arrays(**bent)


def _check_contraction(contraction: Any) -> str:
    """One of CONTRACTIONS, by its name or as a member of Open3D's enumeration."""
    given = contraction if isinstance(contraction, str) else getattr(contraction, "name", contraction)
    way = check_name("contraction", given).lower()
    if way not in CONTRACTIONS:
        raise ValueError(f"contraction: expected one of {', '.join(CONTRACTIONS)}, got {given!r}")
    return way


def _remesh(surface: TriangleTree, target: float, iterations: int, angle: float) -> CreasedMesh:
    vertices, triangles = surface.vertices, surface.triangles
    creases, fixed = find_features(vertices, triangles, angle, LEAST_CREASE * target)
    mesh = CreasedMesh(vertices, triangles, creases, fixed)
    segments = crease_segments(mesh)  # sync
    lines = TriangleTree(vertices, segments, all_finite=True) if segments.size else surface
    course = Course(mesh, (surface, lines), target)
    for _ in range(iterations):
        course.iterate()
    return course.end()


class Course:
    """The iterations of a mesh.

    On CUDA the device counts the rounds of a step where all of them were made in the iteration before: the host makes
    ROUNDS then, and those after the last do nothing. What it has to know of an iteration it reads with the number of
    edges that split in the next.
    """

    def __init__(self, mesh: CreasedMesh, trees: tuple[TriangleTree, TriangleTree], target: float) -> None:
        self.mesh, self.trees = mesh, trees
        self.longest, self.shortest = LONG * target, SHORT * target
        self.steps: tuple[Callable[..., tuple[CreasedMesh, int | None]], ...] = (self._collapse, flip_edges)
        self.all_rounds = [mesh.vertices.device.is_cuda for _ in self.steps]
        self.state: Integers | None = None  # two numbers of `end_rounds` a step, then `taken` for each relaxation
        self.before = mesh.vertices

    def iterate(self) -> None:
        """Split, collapse, flip, move."""
        split, device = 1, self.before.device
        while split:
            made, split, found = split_long_edges(self.mesh, self.longest, self.state)  # sync
            if self._is_settled(found):
                self.mesh = made
            else:
                split = 1
        state = zeros(2 * len(self.steps) + RELAXED, int32, device)
        for k, step in enumerate(self.steps):
            self._make_rounds(k, step, state[2 * k : 2 * k + 2])
        if not device.is_cuda:
            self._relax()
            return
        self.state, self.before = state, self.mesh.vertices
        self._relax(state[2 * len(self.steps) :])

    def end(self) -> CreasedMesh:
        """The mesh."""
        if self.state is not None:
            self._is_settled(download(self.state).tolist())  # sync
        return self.mesh

    def _is_settled(self, found: list[int]) -> bool:
        """Read what the last iteration says; False where its vertices had to move anew, so that the mesh is another."""
        if self.state is None:
            return True
        self.state = None
        self.all_rounds = [found[2 * k + 1] == ROUNDS for k in range(len(self.steps))]
        if not any(found[2 * len(self.steps) :]):
            return True
        self.mesh.vertices = self.before
        self._relax()  # sync
        return False

    def _collapse(
        self, mesh: CreasedMesh, few: float, rounds: Integers | None = None
    ) -> tuple[CreasedMesh, int | None]:
        return collapse_short_edges(mesh, self.shortest, self.longest, few, rounds)

    def _make_rounds(self, k: int, step: Callable[..., tuple[CreasedMesh, int | None]], rounds: Integers) -> None:
        """The rounds of a step: without a look at them, or with one after each (sync)."""
        for turn in range(1, ROUNDS + 1):
            self.mesh, changed = step(self.mesh, FEW, rounds if self.all_rounds[k] else None)
            if changed is not None and (changed <= FEW * self.mesh.edges.count or turn == ROUNDS):
                fill(rounds[1:], turn)
                break

    def _relax(self, taken: Integers | None = None) -> None:
        """Move vertices along the surface and their lines, RELAXED times; one sync each where `taken` is not given."""
        for k in range(RELAXED):
            moved = relaxed(self.mesh)
            on_surface, on_lines = (SurfacePlaces(moved, tree).points for tree in self.trees)
            places = choose_places(self.mesh, on_surface, on_lines)
            move_where_nothing_turns(self.mesh, places, None if taken is None else taken[k : k + 1])


def _names_of(scope: Any) -> tuple[str, ...]:
    """The arrays of a scope: one of ours by name, or a member of Open3D's enum."""
    name = scope if isinstance(scope, str) else getattr(scope, "name", None)
    if not isinstance(name, str):
        raise TypeError(f"filter_scope: expected one of {', '.join(SCOPES)}, got {shown(scope)}")
    if name.lower() not in SCOPES:
        raise ValueError(f"filter_scope: expected one of {', '.join(SCOPES)}, got {shown(name)}")
    return SCOPES[name.lower()]


def _once(
    held: NDArray[np.int32], places: NDArray[np.int32], targets: NDArray[np.float64]
) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Places of a sewn mesh once each, and where they are put.

    Raises:
        ValueError: Two of them lie at one place and are put elsewhere each.
    """
    found, firsts, members = np.unique(places, return_index=True, return_inverse=True)
    unlike = np.flatnonzero((targets != targets[firsts][members]).any(axis=1))
    if len(unlike):
        pair = f"{held[firsts[members[unlike[0]]]]} and {held[unlike[0]]}"
        raise ValueError(
            f"constraint_vertex_positions: vertices {pair} lie at one place of a seam; put them at one place"
        )
    return found.astype(np.int32), targets[firsts]


def _energy_of(energy: Any) -> str:
    """One of ours by name, or a member of Open3D's enum."""
    name = energy if isinstance(energy, str) else getattr(energy, "name", None)
    if not isinstance(name, str):
        raise TypeError(f"energy: expected one of {', '.join(ENERGIES)}, got {shown(energy)}")
    if name.lower() not in ENERGIES:
        raise ValueError(f"energy: expected one of {', '.join(ENERGIES)}, got {shown(name)}")
    return name.lower()
