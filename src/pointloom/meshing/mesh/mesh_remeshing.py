"""Simplification, remeshing, subdivision, smoothing and deformation of a mesh."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from typing import Any, Self, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

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
from ...core.exchange import on_host
from ...core.units import warn_of_units
from ...kernels.algebra.transform import narrow_rows, widen_rows
from ...kernels.array_types import Integers
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import int32, vec3d
from ...kernels.memory import check_room, download, fill, upload, zeros
from ...kernels.meshes import clean_triangles
from ...kernels.meshes.mesh_edges import SortedEdges
from ...kernels.meshes.mesh_measures import measure
from ...kernels.rays.surface_positions import SurfacePositions
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.remeshing import subdivision
from ...kernels.remeshing.creased_mesh import CreasedMesh, crease_segments, find_features
from ...kernels.remeshing.decimation import Decimation
from ...kernels.remeshing.flipped_edges import flip_edges
from ...kernels.remeshing.long_edges import count_lengths, split_long_edges
from ...kernels.remeshing.mesh_filters import approach_mean_kernel, average_kernel, filter_values, sharpen_kernel
from ...kernels.remeshing.relaxed_vertices import choose_positions, move_without_flips, relaxed
from ...kernels.remeshing.rigid_deformation import deform_rigidly, rotate_directions
from ...kernels.remeshing.short_edges import collapse_short_edges
from ...kernels.remeshing.vertex_clustering import cluster_vertices
from ...kernels.remeshing.vertex_values import narrow_directions
from .mesh_attributes import each
from .mesh_measures import MeshMeasures
from .mesh_rows import PER_VERTEX, TEXTURE
from .mesh_seams import Sewn, sew
from .surface_values import with_attributes_of, with_vectors_of
from .vertex_numbers import check_finite_vertices, check_vertices

Mesh = TypeVar("Mesh", bound="MeshRemeshing")

CONTRACTIONS = ("average", "quadric")
MAX_TRIANGLES = 2**29  # 32-bit half-edge indices, also of the result
# Limits of splits and collapses, of the target length (Botsch and Kobbelt 2004).
SPLIT_LENGTH, COLLAPSE_LENGTH = 4 / 3, 4 / 5
RELAXATION_STEPS = 2  # relaxation steps per iteration
ROUNDS_PER_ITERATION = 3  # of collapses and flips per iteration. Each uses independent edges
MIN_CREASE = 3.0  # of the target length: shorter creases are roughness
MAX_ITERATIONS = 1000
TRIANGLE_BYTES = 400  # temporary memory
MIN_WITHIN = 0.8  # fraction of the edges: of fewer within the limits, the length is not reached
# Of the target length: collapses of a lattice of right triangles with legs of 2/3 to 4/5 pass 4/3.
COARSE_LENGTH = 3 / 2
MAX_COARSENING = 100  # more iterations: each removes a fifth of the edges, so a mesh a million times finer ends
MIN_CHANGED_FRACTION = 0.002  # of all edges: a round that changes fewer is the last
MAX_CORNERS = 2**31 - 1  # 32-bit half-edge indices
MAX_PASSES = 10_000
SCOPES = {"all": tuple(PER_VERTEX), "vertex": ("vertices",), "normal": ("vertex_normals",), "color": ("vertex_colors",)}
MAX_DEFORM_ITERATIONS = 10_000
ENERGIES = ("spokes", "smoothed")


class MeshRemeshing(MeshMeasures):
    """Methods of TriangleMesh that simplify, remesh, subdivide, smooth and deform it."""

    _internal = ("drop_degenerate_triangles",)

    @returns_new
    def simplify_vertex_clustering(self, voxel_size: float, contraction: object = "average") -> Self:
        """Merge the vertices of each voxel, and keep the triangles between three voxels.

        Fast, but joins sheets closer than a voxel and may create non-manifold edges. See `simplify_quadric_decimation`.
        About 150 B per triangle. Bitwise identical on every device, independent of the unit of length. Rossignac and
        Borrel 1993. Lindstrom, "Out-of-core simplification of large polygonal models", SIGGRAPH 2000.

        Args:
            voxel_size: Edge of a voxel [m]. The grid starts half a voxel below the lowest corner.
            contraction: "average" for the mean of the vertices, or "quadric" for the point nearest to the planes of
                their triangles (the mean if farther than a voxel), which preserves edges; or Open3D's member.

        Returns:
            Vertices by first occurrence, unique triangles by first occurrence. Normals (unit length) and colors are
            means. Attributes are those of the nearest surface point. Textures and non-finite vertices are dropped.

        Raises:
            ValueError: If the size is not positive, gives more than 2^62 voxels, or the contraction is unknown.
            TypeError: If an argument has the wrong type.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [0.1, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 3], [1, 2, 3], [3, 2, 4]])
            >>> mesh.simplify_vertex_clustering(1.0).triangles.tolist()
            [[0, 1, 2], [1, 3, 2]]
        """
        size, contraction_name = check_positive("voxel_size", voxel_size), _check_contraction(contraction)
        rows = self.arrays.per_vertex()
        unit = [name == "vertex_normals" for name in rows][1:]
        triangles, arrays = cluster_vertices(
            self.arrays["triangles"], [*rows.values()], unit, size, contraction_name == "quadric"
        )
        without: dict[str, Any] = dict.fromkeys(TEXTURE)
        left: dict[str, Any] = without | dict(zip(rows, arrays, strict=True))
        return with_attributes_of(self.without_attributes().with_arrays(triangles=triangles, **left), self)

    @returns_new
    def simplify_quadric_decimation(
        self, target_number_of_triangles: int, maximum_error: float = np.inf, boundary_weight: float = 1.0
    ) -> Self:
        """Collapse edges in order of their quadric error until few triangles remain.

        If no edge may collapse and `maximum_error` is infinite, seams are released, then triangles may flip, then
        isolated triangles are removed. A closed part keeps four triangles. Vertices that are not finite stay. Meshes
        cut along seams may open there: use `triangle_uvs` instead. About 400 B per triangle. Bitwise identical on every
        device. Garland and Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997.

        Args:
            target_number_of_triangles: Number of remaining triangles, at least 0.
            maximum_error: Maximum error of a collapse: sum of triangle area times squared plane distance [m^4].
            boundary_weight: Weight of planes that preserve borders, relative to those of triangles.

        Returns:
            The mesh with the target count or one less, in order, without unused vertices. Preserves topology and
            watertightness and creates no non-manifold edges. Normals, colors and texture coordinates are interpolated.
            Other attributes come from the nearest surface point. Borders, texture seams and material borders move only
            along themselves. Degenerate and duplicate triangles are removed first.

        Raises:
            ValueError, TypeError: If the target, weight or error is negative, or if an argument has the wrong type.

        Warns:
            UserWarning: If more triangles remain because no edge can collapse without tearing the mesh.

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
        rows = self.arrays.per_vertex()
        unit = [name == "vertex_normals" for name in rows][1:]
        uvs, materials = (self.arrays.get(name) for name in TEXTURE)
        job = Decimation(self.arrays["triangles"], [*rows.values()], unit, uvs, materials, target, error, weight)
        job.run()
        triangles, arrays, *texture = job.result()
        remaining: dict[str, Any] = dict(zip((*TEXTURE, *rows), (*texture, *arrays), strict=True))
        left = self.without_attributes().with_arrays(triangles=triangles, **remaining)
        if len(left) > target and np.isinf(error):
            warnings.warn(
                f"{len(left)} triangles remain instead of {target}: no other edge can collapse without tearing it",
                stacklevel=3,
            )
        return with_attributes_of(left.remove_unreferenced_vertices(), self)

    @returns_new
    def remesh_isotropic(self, edge_length: float, iterations: int = 10, *, feature_angle: float = 30.0) -> Self:
        """Remesh the surface with nearly equilateral triangles of about one edge length.

        Splits long edges, collapses short ones, flips edges toward valence six, relaxes vertices tangentially and
        projects them to the input surface. About 400 B per triangle. Bitwise identical on every device. Botsch and
        Kobbelt, "A remeshing approach to multiresolution modeling", SGP 2004, with area weights.

        Args:
            edge_length: Target [m]. Edges become 4/5 to 4/3 of it where creases allow.
            iterations: Number of iterations. More follow while most edges outside that range are too short, as those of
                a mesh that is several times finer.
            feature_angle: Edges with a larger angle between triangles [degrees] are creases and stay, as do borders and
                non-manifold edges. Crease paths shorter than three edges count as roughness. 180 keeps only borders.

        Returns:
            The remeshed surface with the same topology. No triangle rotates by more than 60 degrees in one step.
            Attributes are those of the nearest input surface point. Textures are dropped (see `bake_vertex_colors`).
            Degenerate, duplicate and non-finite triangles are removed first.

        Raises:
            ValueError, MemoryError: If the length is not positive or gives more than 2^29 triangles, the count is
                outside 0..1000, or the angle outside 0..180, or if the triangles do not fit into memory.
            TypeError: If an argument is not a number.

        Warns:
            UserWarning: If fewer than 80% of the edges have a length in that range.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> box = loom.TriangleMesh.create_box().remesh_isotropic(0.1)
            >>> box.is_watertight(), round(box.get_volume(), 6), round(box.get_surface_area(), 6)
            (True, 1.0, 6.0)
        """
        target = check_positive("edge_length", edge_length, maximum=LARGEST_NUMBER)
        count = check_count(
            "iterations",
            iterations,
            minimum=0,
            maximum=MAX_ITERATIONS,
            because="10 iterations achieve most of the effect",
        )
        angle = check_number("feature_angle", feature_angle)
        if not 0 <= angle <= 180:
            raise ValueError(f"feature_angle: expected 0 to 180 degrees, got {angle:g}")
        source = self._drop_invalid_triangles()  # sync
        if not count or not len(source):
            return source.with_arrays(**dict.fromkeys(TEXTURE))
        vertices, triangles = source.arrays["vertices"], source.arrays["triangles"]
        low, high, _ = bound_points(vertices)  # sync
        span, area = float(np.abs([low, high]).max()), measure(vertices, triangles)[0]  # sync
        if target < 2.0**-20 * span or area > MAX_TRIANGLES * 0.25 * target**2:
            raise ValueError(
                f"edge_length: {target:g} m is too small for a mesh of {area:g} m2 with an extent of {span:g} m"
            )
        expected = area / (0.43 * target**2)  # for equilateral triangles
        check_room(self.device, int(TRIANGLE_BYTES * expected), f"about {expected:,.0f} triangles")
        surface = TriangleTree(vertices, triangles, all_finite=True)
        mesh = _remesh(surface, target, count, math.radians(angle))
        dropped = dict.fromkeys(("vertex_normals", "vertex_colors", *TEXTURE))
        bare = source.without_attributes().with_arrays(**dropped)
        made = bare.with_arrays(vertices=mesh.vertices, triangles=mesh.triangles).drop_degenerate_triangles()
        return with_attributes_of(with_vectors_of(made, source, surface), source, surface)

    def drop_degenerate_triangles(self) -> Self:
        """Remove fully degenerate triangles and unused vertices. One sync."""
        triangles, count = self.arrays["triangles"], self.arrays.vertex_count
        removed = clean_triangles.mask_degenerate(self.arrays["vertices"], triangles, zero_area=False)
        return self.drop_triangles_and_vertices(removed, clean_triangles.mask_used(triangles, removed, count))

    @returns_new
    def subdivide_midpoint(self, number_of_iterations: int = 1) -> Self:
        """Split each triangle into four at the edge midpoints. The surface does not move.

        About 150 B per triangle of the second to last round. Bitwise identical on every device.

        Args:
            number_of_iterations: Rounds. Each multiplies the triangles by four.

        Returns:
            The finer mesh in Open3D's order. Colors, unit normals and texture coordinates are means of the edge ends;
            floating attributes too, other attributes are those of the end with the lower index. Textures stay.

        Raises:
            ValueError: If the count is negative, or there are more than 715,827,882 triangles.
            TypeError: If the count is not an integer.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> mesh.subdivide_midpoint().triangles.tolist()
            [[0, 3, 5], [3, 1, 4], [4, 2, 5], [3, 4, 5]]
        """
        return _subdivided(self, number_of_iterations, subdivision.halve, self.arrays["vertices"].size)

    @returns_new
    def subdivide_loop(self, number_of_iterations: int = 1) -> Self:
        """Subdivide by Loop's scheme: split each triangle into four and smooth.

        Memory and determinism as `subdivide_midpoint`. NaN spreads. Loop, "Smooth subdivision surfaces", 1987.

        Args:
            number_of_iterations: Rounds. Each multiplies the triangles by four.

        Returns:
            The finer mesh in the order of `subdivide_midpoint`. Unit normals and colors use the masks of positions.
            Texture coordinates and attributes are means. Borders are smoothed as curves. Coincident seam vertices
            become one. Vertices without triangles stay.

        Raises:
            ValueError: If the count is negative, or there are more than 715,827,882 triangles.
            TypeError: If the count is not an integer.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [8, 0, 0], [0, 8, 0]], [[0, 1, 2]]).subdivide_loop()
            >>> mesh.vertices[:, 0].tolist()
            [1.0, 6.0, 1.0, 4.0, 4.0, 0.0]
        """
        count = check_count("number_of_iterations", number_of_iterations, minimum=0)
        sewn = sew(self) if count and len(self) else Sewn(self, None)
        return _subdivided(sewn.mesh, count, subdivision.mask, 0, sewn.in_order)

    @returns_new
    def filter_smooth_simple(self, number_of_iterations: int = 1, filter_scope: object = "all") -> Self:
        """Move each vertex to the mean of itself and its neighbors.

        O(m + t) memory. Float64 sums in fixed order: bitwise reproducible.

        Args:
            number_of_iterations: Number of passes.
            filter_scope: "all", "vertex", "normal" or "color", or a member of Open3D's FilterScope.

        Returns:
            The mesh with smoothed arrays. Normals have unit length. Vertices that are not finite stay and are ignored.
            Coincident seam vertices move together and get the mean normal and color.

        Raises:
            ValueError: If the count is outside 0..10,000, or the scope is unknown or absent in the mesh.
            TypeError: If the count is not an integer.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 3]], [[0, 1, 2]])
            >>> roof.filter_smooth_simple().vertices[0].tolist()
            [1.0, 1.0, 1.0]
        """
        return self._filtered([(average_kernel, 0.0)], number_of_iterations, filter_scope)

    @returns_new
    def filter_smooth_laplacian(
        self, number_of_iterations: int = 1, lambda_filter: float = 0.5, filter_scope: object = "all"
    ) -> Self:
        """Move each vertex toward the mean of its neighbors, weighted by inverse distance.

        Shrinks curved and open surfaces. See `filter_smooth_taubin`. Taubin, "A signal processing approach to fair
        surface design", SIGGRAPH 1995, equation 2.

        Args:
            number_of_iterations: Number of passes.
            lambda_filter: Fraction of the displacement applied per pass.
            filter_scope: As of `filter_smooth_simple`.

        Returns:
            As `filter_smooth_simple`. Vertices without neighbors stay.

        Raises:
            ValueError, TypeError: As `filter_smooth_simple`. Also if the factor is not finite.

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
        self, number_of_iterations: int = 1, lambda_filter: float = 0.5, mu: float = -0.53, filter_scope: object = "all"
    ) -> Self:
        """Smooth without shrinking: each iteration is a pass with `lambda_filter` and one with `mu`.

        Args:
            number_of_iterations: Number of pass pairs.
            lambda_filter: Fraction of the displacement to the weighted mean, > 0.
            mu: Factor of the second pass, below -lambda_filter.
            filter_scope: As of `filter_smooth_simple`.

        Returns:
            As `filter_smooth_laplacian`. Taubin, SIGGRAPH 1995, section 3.

        Raises:
            ValueError, TypeError: As `filter_smooth_laplacian`.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 0]], [[0, 1, 2]])
            >>> roof.filter_smooth_taubin(5)
            TriangleMesh(3 vertices, 1 triangles, cpu)
        """
        factors = (check_number("lambda_filter", lambda_filter), check_number("mu", mu))
        return self._filtered([(approach_mean_kernel, f) for f in factors], number_of_iterations, filter_scope)

    @returns_new
    def filter_sharpen(self, number_of_iterations: int = 1, strength: float = 1, filter_scope: object = "all") -> Self:
        """Move each vertex away from its neighbors, which emphasizes edges and noise.

        Args:
            number_of_iterations: Number of passes.
            strength: Factor of the summed differences between a vertex and its neighbors.
            filter_scope: As of `filter_smooth_simple`.

        Returns:
            As `filter_smooth_simple`. Colors are not clipped to 0..1, as in Open3D.

        Raises:
            ValueError, TypeError: As `filter_smooth_simple`. Also if the strength is not finite.

        Example:
            >>> import pointloom as loom
            >>> roof = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 3, 3]], [[0, 1, 2]])
            >>> roof.filter_sharpen(strength=0.5).vertices[0].tolist()
            [-1.5, -1.5, -1.5]
        """
        factor = check_number("strength", strength)
        return self._filtered([(sharpen_kernel, factor)], number_of_iterations, filter_scope)

    def _filtered(self, passes: list[tuple[Any, float]], iterations: int, scope: object) -> Self:
        reason = "more iterations shrink the mesh to the mean of its vertices"
        count = check_count("number_of_iterations", iterations, minimum=0, maximum=MAX_PASSES, because=reason)
        names = [name for name in _names_of(scope) if name in self.arrays]
        if not names:
            raise ValueError(f"filter_scope: the mesh has no {_names_of(scope)[0]} to filter")
        if count == 0 or not len(self):
            return self.with_arrays()
        sewn = sew(self)
        arrays = sewn.mesh.arrays
        wide = {name: widen_rows(arrays[name]) for name in {"vertices", *names}}
        values = filter_values(arrays["triangles"], wide["vertices"], names, wide, passes, count, sewn.in_order)
        narrow: dict[str, Any] = {}
        for name, rows in values.items():
            if name == "vertex_normals":
                narrow[name] = sewn.spread(narrow_directions(rows, arrays[name]))
            else:
                narrow[name] = sewn.spread(narrow_rows(rows))
        return self.with_arrays(**narrow)

    @returns_new
    def deform_as_rigid_as_possible(
        self,
        constraint_vertex_indices: ArrayLike,
        constraint_vertex_positions: ArrayLike,
        max_iter: int,
        energy: object = "spokes",
        smoothed_alpha: float = 0.01,
    ) -> Self:
        """Move some vertices to given positions and deform the rest as rigidly as possible.

        Solved to 1e-9 of the mesh's extent, cotangent weights clamped to 0. 1 kB per vertex. Bitwise reproducible.

        Args:
            constraint_vertex_indices: Constrained vertices, each once: moved and fixed ones.
            constraint_vertex_positions: Their positions [m], shape (k, 3).
            max_iter: Alternations of rotation and position solves. 0 moves nothing.
            energy: "spokes" (Sorkine and Alexa, SGP 2007) or "smoothed" with smooth rotations (Levi and Gotsman 2014),
                or a member of Open3D's DeformAsRigidAsPossibleEnergy.
            smoothed_alpha: Weight of rotation smoothness, in areas of the mesh.

        Returns:
            The deformed mesh with rotated normals and all other attributes. Parts without constrained vertices and
            vertices that are not finite stay. Coincident seam vertices move together; constrain one of them.

        Raises:
            ValueError: If a constraint is missing, duplicated, contradictory, out of range or not finite, `max_iter` is
                outside 0..10,000, the energy is unknown, or `smoothed_alpha` is negative.
            TypeError: If an argument is not numeric.
            ArithmeticError: If the solver does not converge because of very thin triangles.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 2, 0], [1, 2, 0]]
            >>> strip = loom.TriangleMesh(corners, [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])
            >>> moved = strip.deform_as_rigid_as_possible([0, 1], [[0, 0, 5], [1, 0, 5]], max_iter=30)
            >>> moved.vertices[4].round(3).tolist()
            [0.0, 2.0, 5.0]
        """
        count = self.arrays["vertices"].size
        fixed = check_vertices("constraint_vertex_indices", constraint_vertex_indices, count)
        positions = on_host("constraint_vertex_positions", constraint_vertex_positions)
        targets = check_rows("constraint_vertex_positions", positions, 3, dtype=np.float64)
        if len(targets) != len(fixed):
            raise ValueError(
                f"constraint_vertex_positions: expected shape [{len(fixed)}, 3], one row per constrained vertex, got "
                f"{list(targets.shape)}"
            )
        check_finite("constraint_vertex_positions", targets)
        numbers, repeats = np.unique(fixed, return_counts=True)
        if len(numbers) < len(fixed):
            raise ValueError(
                f"constraint_vertex_indices: vertex {numbers[repeats > 1][0]} is duplicated. Pass each vertex once"
            )
        reason = "vertices no longer move after that"
        iterations = check_count("max_iter", max_iter, minimum=0, maximum=MAX_DEFORM_ITERATIONS, because=reason)
        alpha = check_positive("smoothed_alpha", smoothed_alpha, allow_zero=True)
        likeness = alpha * self.finite_area() if _energy_of(energy) == "smoothed" else 0.0
        if iterations == 0:
            return self.with_arrays()
        rows = upload(fixed, int32, self.device)
        check_finite_vertices("constraint_vertex_indices", fixed, gather_rows(self.arrays["vertices"], rows))
        sewn = sew(self)
        if sewn.sewn_indices is not None:
            fixed, targets = _once(fixed, download(gather_rows(sewn.sewn_indices, rows)), targets)  # sync
            rows = upload(fixed, int32, self.device)
        positions, arrays = upload(targets - self.arrays.origin, vec3d, self.device), sewn.mesh.arrays
        moved, rotations = deform_rigidly(
            arrays["vertices"], arrays["triangles"], rows, positions, iterations, likeness
        )
        deformed: dict[str, Any] = {"vertices": sewn.spread(narrow_rows(moved))}
        if "vertex_normals" in self.arrays:
            deformed["vertex_normals"] = rotate_directions(rotations, self.arrays["vertex_normals"], sewn.sewn_indices)
        return self.with_arrays(**deformed)


def _subdivided(
    mesh: Mesh, iterations: int, rule: Callable[..., list[Any]], first_new: int, in_order: SortedEdges | None = None
) -> Mesh:
    """Apply a subdivision rule. Normals before `first_new` stay unchanged. `in_order`: known `sorted_edges`."""
    count = check_count("number_of_iterations", iterations, minimum=0)
    if count == 0 or not len(mesh):
        return mesh.with_arrays()
    if count > 16 or 3 * len(mesh) * 4**count > MAX_CORNERS:
        raise ValueError(
            f"number_of_iterations: {count} iterations produce {len(mesh)} * 4^{count} triangles, more than the "
            f"{MAX_CORNERS // 3:,} that 32 bits can index. Use fewer iterations"
        )
    arrays: dict[str, Any] = mesh.arrays | {kind: dict(columns) for kind, columns in mesh.arrays.attributes.items()}
    names = list(mesh.arrays.per_vertex())
    values = [widen_rows(arrays[name]) for name in names]
    for _ in range(count):
        triangles = arrays["triangles"]
        split, in_order = subdivision.EdgeSplit(triangles, values[0].size, in_order), None
        values = rule(triangles, split, values)
        arrays["triangles"] = subdivision.split_triangles(triangles, split)
        if arrays["vertex_attributes"]:
            arrays["vertex_attributes"] = each(arrays["vertex_attributes"], subdivision.mixed_ends(split).of)
        if "triangle_uvs" in arrays:
            arrays["triangle_uvs"] = subdivision.split_corners(arrays["triangle_uvs"])
        if "triangle_material_ids" in arrays:
            arrays["triangle_material_ids"] = subdivision.repeat_four_times(arrays["triangle_material_ids"])
    if arrays["triangle_attributes"]:
        quarters = upload(np.repeat(np.arange(len(mesh), dtype=np.int32), 4**count), int32, mesh.device)
        arrays |= mesh.arrays.attributes_at("triangle_attributes", quarters)
    for name, rows in zip(names, values, strict=True):
        if name == "vertex_normals":
            arrays[name] = narrow_directions(rows, mesh.arrays[name], first_new)
        else:
            arrays[name] = narrow_rows(rows)
    return mesh.with_arrays(**arrays)


def _check_contraction(contraction: object) -> str:
    given = contraction if isinstance(contraction, str) else getattr(contraction, "name", contraction)
    name = check_name("contraction", given).lower()
    if name not in CONTRACTIONS:
        raise ValueError(f"contraction: expected one of {', '.join(CONTRACTIONS)}, got {given!r}")
    return name


def _remesh(surface: TriangleTree, target: float, iterations: int, angle: float) -> CreasedMesh:
    vertices, triangles = surface.vertices, surface.triangles
    creases, fixed = find_features(vertices, triangles, angle, MIN_CREASE * target)
    mesh = CreasedMesh(vertices, triangles, creases, fixed)
    segments = crease_segments(mesh)  # sync
    lines = TriangleTree(vertices, segments, all_finite=True) if segments.size else surface
    course = Course(mesh, (surface, lines), target)
    for _ in range(iterations):
        course.iterate()
    return course.coarsen()


class Course:
    """State and steps of isotropic remeshing. On CUDA the device counts the rounds of a step. The host launches ROUNDS
    of them, and rounds after the last do nothing. Their counts are read with the number of split edges in the next
    iteration, which saves syncs."""

    def __init__(self, mesh: CreasedMesh, trees: tuple[TriangleTree, TriangleTree], target: float) -> None:
        self.mesh, self.trees = mesh, trees
        self.longest, self.shortest = SPLIT_LENGTH * target, COLLAPSE_LENGTH * target
        self.steps: tuple[Callable[..., tuple[CreasedMesh, int | None]], ...] = (self._collapse, flip_edges)
        self.all_rounds = [mesh.vertices.device.is_cuda for _ in self.steps]
        self.state: Integers | None = None  # two numbers of `end_rounds` per step, then `reverted` for each relaxation
        self.before = mesh.vertices
        self.collapse_limit, self.target = self.longest, target
        self.is_fast = False  # collapse more edges per round

    def iterate(self) -> None:
        split, device = 1, self.before.device
        while split:
            made, split, counts = split_long_edges(self.mesh, self.longest, self.state)  # sync
            if self._is_converged(counts):
                self.mesh = made
            else:
                split = 1
        state = zeros(2 * len(self.steps) + RELAXATION_STEPS, int32, device)
        for k, step in enumerate(self.steps):
            self._make_rounds(k, step, state[2 * k : 2 * k + 2])
        if not device.is_cuda:
            self._relax()
            return
        self.state, self.before = state, self.mesh.vertices
        self._relax(state[2 * len(self.steps) :])

    def end(self) -> CreasedMesh:
        if self.state is not None:
            self._is_converged(download(self.state).tolist())  # sync
        return self.mesh

    def coarsen(self) -> CreasedMesh:
        """End, iterate on while many edges are too short, and warn if the length is not reached."""
        counts = self._count_lengths()
        self.is_fast = _is_far(*counts) and counts[0] > counts[2]
        for _ in range(MAX_COARSENING if self.is_fast else 0):
            short, within, _ = counts
            self.collapse_limit = (COARSE_LENGTH if short > within else SPLIT_LENGTH) * self.target
            self.iterate()
            counts = self._count_lengths()
            if counts[1] <= within and counts[0] >= short:
                break
        if _is_far(*counts):
            short, within, long = (f"{count / sum(counts):.0%}" for count in counts)
            smaller = "a smaller edge_length, or a larger feature_angle if creases prevent longer edges"
            warn_of_units(
                f"edge_length: expected most edges at 4/5 to 4/3 of {self.target:g} m, got {within} of them, {short} "
                f"shorter and {long} longer. Pass {smaller if counts[0] > counts[2] else 'more iterations'}",
                UserWarning,
            )
        return self.mesh

    def _count_lengths(self) -> list[int]:
        self.end()
        return count_lengths(self.mesh, self.shortest, self.longest)  # sync

    def _is_converged(self, counts: list[int]) -> bool:
        """Read counts of the last iteration. False if vertices moved again, so that the mesh changed."""
        if self.state is None:
            return True
        self.state = None
        self.all_rounds = [counts[2 * k + 1] == ROUNDS_PER_ITERATION for k in range(len(self.steps))]
        if not any(counts[2 * len(self.steps) :]):
            return True
        self.mesh.vertices = self.before
        self._relax()  # sync
        return False

    def _collapse(
        self, mesh: CreasedMesh, few: float, rounds: Integers | None = None
    ) -> tuple[CreasedMesh, int | None]:
        return collapse_short_edges(mesh, self.shortest, self.collapse_limit, few, rounds, is_fast=self.is_fast)

    def _make_rounds(self, k: int, step: Callable[..., tuple[CreasedMesh, int | None]], rounds: Integers) -> None:
        """Run the rounds of a step, without a host check or with one after each (sync)."""
        for round_number in range(1, ROUNDS_PER_ITERATION + 1):
            self.mesh, changed = step(self.mesh, MIN_CHANGED_FRACTION, rounds if self.all_rounds[k] else None)
            if changed is not None and (
                changed <= MIN_CHANGED_FRACTION * self.mesh.edges.count or round_number == ROUNDS_PER_ITERATION
            ):
                fill(rounds[1:], round_number)
                break

    def _relax(self, reverted: Integers | None = None) -> None:
        """Relax vertices RELAXED times along the surface and creases. One sync each if `reverted` is None."""
        for k in range(RELAXATION_STEPS):
            moved = relaxed(self.mesh)
            on_surface, on_lines = (SurfacePositions(moved, tree).points for tree in self.trees)
            targets = choose_positions(self.mesh, on_surface, on_lines)
            move_without_flips(self.mesh, targets, None if reverted is None else reverted[k : k + 1])


def _is_far(short: int, within: int, long: int) -> bool:
    """True if the edges do not have the target length, from the numbers of those below, within and above its limits."""
    return within < MIN_WITHIN * (short + within + long)


def _names_of(scope: object) -> tuple[str, ...]:
    name = scope if isinstance(scope, str) else getattr(scope, "name", None)
    if not isinstance(name, str):
        raise TypeError(f"filter_scope: expected one of {', '.join(SCOPES)}, got {shown(scope)}")
    if name.lower() not in SCOPES:
        raise ValueError(f"filter_scope: expected one of {', '.join(SCOPES)}, got {shown(name)}")
    return SCOPES[name.lower()]


def _once(
    vertices: NDArray[np.int32], sewn_indices: NDArray[np.int32], targets: NDArray[np.float64]
) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Unique constrained vertices of a seam-welded mesh and their targets. ValueError if targets contradict."""
    distinct, firsts, members = np.unique(sewn_indices, return_index=True, return_inverse=True)
    unlike = np.flatnonzero((targets != targets[firsts][members]).any(axis=1))
    if len(unlike):
        pair = f"{vertices[firsts[members[unlike[0]]]]} and {vertices[unlike[0]]}"
        raise ValueError(f"constraint_vertex_positions: vertices {pair} coincide at a seam. Give them the same target")
    return distinct.astype(np.int32), targets[firsts]


def _energy_of(energy: object) -> str:
    name = energy if isinstance(energy, str) else getattr(energy, "name", None)
    if not isinstance(name, str):
        raise TypeError(f"energy: expected one of {', '.join(ENERGIES)}, got {shown(energy)}")
    if name.lower() not in ENERGIES:
        raise ValueError(f"energy: expected one of {', '.join(ENERGIES)}, got {shown(name)}")
    return name.lower()
