"""Changes of a mesh: repair, booleans, remeshing, smoothing, sweeps, textures."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from ...core.dropped_results import returns_new
from . import measures, remeshing, repair, smoothing, solids, sweeps, texture
from .mesh_arrays import MeshArrays
from .repair import MeshRepairReport


class MeshChanges(MeshArrays):
    """Methods of TriangleMesh that return it changed."""

    @returns_new
    def compute_vertex_normals(self) -> Self:
        """Set vertex normals to the area-weighted mean of the adjacent triangle normals.

        Returns unit normals of shape (m, 3): (0, 0, 1) at vertices without adjacent area (Open3D: zero), NaN at
        vertices that are not finite. Float64 sums in triangle order: bitwise reproducible.
        """
        return measures.compute_vertex_normals(self)

    @returns_new
    def normalize_normals(self) -> Self:
        """Scale vertex normals to unit length. Zero normals stay zero.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]], vertex_normals=2 * np.eye(3))
            >>> mesh.normalize_normals().vertex_normals.tolist() == np.eye(3).tolist()
            True
        """
        return measures.normalize_normals(self)

    @returns_new
    def orient_triangles(self, *, outward: bool = False) -> tuple[Self, bool]:
        """Orient neighboring triangles consistently.

        About 50 B of memory per half-edge. Bitwise identical on every device.

        Args:
            outward: Orient closed parts outward. Each part is oriented alone, also if it is inside another part.

        Returns:
            (mesh, orientable). Each part keeps the orientation of its first triangle. Parts that cannot be oriented
            stay unchanged, and `orientable` is False. Edges of more than two triangles do not connect parts. Vertex
            normals of flipped triangles are flipped to the side of the new triangles.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
            >>> oriented, orientable = mesh.orient_triangles()
            >>> oriented.triangles.tolist(), orientable
            ([[0, 1, 2], [1, 3, 2]], True)
        """
        return repair.orient_triangles(self, outward=outward)

    @returns_new
    def fill_holes(self, hole_size: float = 1e6) -> Self:
        """Close holes with triangles between their boundary vertices.

        Each loop of `get_boundaries` counts as a hole, the outer rim of an open surface too: choose `hole_size` below
        it. The triangulation has the smallest dihedral angles, then the shortest sides. It suits holes that are small
        relative to the shape. New triangles may intersect others. O(n^3) time and 44 n^2 B for a hole of n vertices,
        about 130 B per triangle. Bitwise identical on every device. Barequet and Sharir, "Filling gaps in the boundary
        of a polyhedron", CAGD 1995. Liepa, "Filling holes in meshes", SGP 2003, section 3.

        Args:
            hole_size: Maximum distance of boundary vertices from the center of their bounding box [m].

        Returns:
            The mesh, old triangles first. Not filled: holes of more than 1,000 vertices or with a vertex that is not
            finite, holes that need an edge of three triangles, and single triangles. `repair` reports counts.

        Raises:
            ValueError: If `hole_size` is not finite and positive.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2]])
            >>> mesh.fill_holes().triangles[3].tolist(), mesh.fill_holes().is_watertight()
            ([2, 3, 1], True)
        """
        return repair.fill_holes(self, hole_size)

    @returns_new
    def repair(
        self, *, merge_distance: float | None = None, hole_size: float | None = None
    ) -> tuple[Self, MeshRepairReport]:
        """Repair common mesh defects and report the changes.

        Steps: remove triangles that are not finite or degenerate, and unused vertices; stitch coincident borders. Split
        edges of more than two triangles into sheets by angle and non-manifold vertices into fans. Remove duplicate
        triangles and those without a partner at a crowded edge. Orient each part as most of its triangles. Fill holes.
        Orient closed parts by nesting. Consistently oriented closed parts are not joined to others. Nested parts keep
        their orientation; outermost parts face outward. Intersecting triangles are neither repaired nor reported.
        Memory as `fill_holes`. Bitwise identical on every device. Guéziec et al., "Cutting and stitching: converting
        sets of polygons to manifold surfaces", IEEE TVCG 2001.

        Args:
            merge_distance: Merge vertices closer than this [m], as `merge_close_vertices`. If None: equal ones.
            hole_size: Fill holes of up to this radius [m], as `fill_holes`. If None: none.

        Returns:
            (mesh, report): an edge- and vertex-manifold mesh, and a MeshRepairReport. Texture, colors and attributes
            stay. Vertex normals of flipped triangles are flipped to their side.

        Raises:
            ValueError: If a number is not finite and positive.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 4, 3], [0, 3, 2]])
            >>> mended, report = mesh.repair(hole_size=1)
            >>> report.merged_vertices, report.filled_holes, report.is_watertight, round(mended.get_volume(), 6)
            (1, 1, True, 0.166667)
        """
        return repair.repair(self, merge_distance=merge_distance, hole_size=hole_size)

    @returns_new
    def split_non_manifold_vertices(self) -> Self:
        """Duplicate vertices so that each fan of triangles has its own vertex.

        About 80 B of memory per triangle. Bitwise identical on every device.

        Returns:
            A vertex-manifold mesh, unless a triangle repeats a vertex. New vertices follow the old ones and copy
            position, normal and color. Edges of more than two triangles stay: see `repair`.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 3, 4]]).split_non_manifold_vertices()
            >>> mesh.triangles.tolist(), mesh.vertices[5].tolist()
            ([[0, 1, 2], [5, 3, 4]], [0.0, 0.0, 0.0])
        """
        return repair.split_non_manifold_vertices(self)

    @returns_new
    def boolean_union(self, mesh: Self) -> Self:
        """Union of two closed meshes as solids, computed on the CPU by manifold3d (`pip install "pointloom[mesh]"`).

        Computed in float64, rounded once to float32. Reproducibility depends on manifold3d.

        Args:
            mesh: A closed, outward-oriented mesh on any device. This mesh must be so too.

        Returns:
            The surface on this mesh's device, relative to its origin. Empty if nothing remains. Vertex colors are
            interpolated if both meshes have them. Normals are recomputed. Texture is dropped. Attributes of both meshes
            are those of the nearest surface point.

        Raises:
            ValueError, TypeError: If a mesh is not closed or not oriented outward, or if `mesh` is not a mesh.
            ImportError: If manifold3d is not installed.

        Example:
            >>> import pointloom as loom
            >>> import numpy as np
            >>> corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
            >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
            >>> solid, other = loom.TriangleMesh(corners, sides), loom.TriangleMesh(corners + [0.2, 0, 0], sides)
            >>> both = solid.boolean_union(other)
            >>> both.is_watertight(), 1 / 6 < both.get_volume() < 1 / 3
            (True, True)
        """
        return solids.combine(self, mesh, "boolean_union", lambda a, b: a + b)

    @returns_new
    def boolean_difference(self, mesh: Self) -> Self:
        """Difference of two closed meshes: this solid without the other one. Arguments and errors as `boolean_union`.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> corners = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]])
            >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
            >>> solid, corner = loom.TriangleMesh(corners, sides), loom.TriangleMesh(corners / 2 - 0.1, sides)
            >>> solid.boolean_difference(corner).get_volume() < solid.get_volume()
            True
        """
        return solids.combine(self, mesh, "boolean_difference", lambda a, b: a - b)

    @returns_new
    def boolean_intersection(self, mesh: Self) -> Self:
        """Intersection of two closed meshes as solids. Arguments and errors as `boolean_union`.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> corners = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]])
            >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
            >>> solid, other = loom.TriangleMesh(corners, sides), loom.TriangleMesh(corners + 5, sides)
            >>> len(solid.boolean_intersection(other))
            0
        """
        return solids.combine(self, mesh, "boolean_intersection", lambda a, b: a ^ b)

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
        return remeshing.simplify_vertex_clustering(self, voxel_size, contraction)

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
        return remeshing.simplify_quadric_decimation(self, target_number_of_triangles, maximum_error, boundary_weight)

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
        return remeshing.remesh_isotropic(self, edge_length, iterations, feature_angle=feature_angle)

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
        return remeshing.subdivide_midpoint(self, number_of_iterations)

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
        return remeshing.subdivide_loop(self, number_of_iterations)

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
        return smoothing.filter_smooth_simple(self, number_of_iterations, filter_scope)

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
        return smoothing.filter_smooth_laplacian(self, number_of_iterations, lambda_filter, filter_scope)

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
        return smoothing.filter_smooth_taubin(self, number_of_iterations, lambda_filter, mu, filter_scope)

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
        return smoothing.filter_sharpen(self, number_of_iterations, strength, filter_scope)

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
        return smoothing.deform_as_rigid_as_possible(
            self, constraint_vertex_indices, constraint_vertex_positions, max_iter, energy, smoothed_alpha
        )

    @returns_new
    def extrude_linear(self, vector: ArrayLike, scale: float = 1.0, capping: bool = True) -> Self:
        """Sweep the mesh along a vector.

        Args:
            vector: Translation [m], shape (3,).
            scale: Factor of the vector.
            capping: Keep the mesh at both ends. If False, only the swept border remains.

        Returns:
            Vertices at the start, then at the end; outward triangles of the start, the end and the walls. A connected,
            consistently oriented mesh that faces the vector everywhere gives a watertight result. Colors and attributes
            stay, normals are recomputed if present, textures are dropped.

        Raises:
            ValueError: If there are not three finite numbers, or the vector has no length.
            TypeError: If an argument is not numeric.

        Example:
            >>> import pointloom as loom
            >>> wedge = loom.TriangleMesh([[1, 1, 0], [0, 1, 0], [1, 0, 0]], [[0, 1, 2]]).extrude_linear([0, 0, 1])
            >>> wedge.is_watertight(), wedge.get_volume(), len(wedge)
            (True, 0.5, 8)
        """
        return sweeps.extrude_linear(self, vector, scale, capping)

    @returns_new
    def extrude_rotation(
        self, angle: float, axis: ArrayLike, resolution: int = 16, translation: float = 0.0, capping: bool = True
    ) -> Self:
        """Sweep the mesh by a rotation about an axis through the origin, optionally with a translation along it.

        Args:
            angle: Rotation [degrees], any size.
            axis: Direction, shape (3,). Rotation is counterclockwise seen against it.
            resolution: Number of steps.
            translation: Total translation along the axis [m].
            capping: As of `extrude_linear`.

        Returns:
            Vertices step by step (on the axis once if there is no translation). Triangles of both ends and the walls. A
            full rotation without translation is closed and has no ends. Otherwise as `extrude_linear`.

        Raises:
            ValueError: If the axis, the angle or the steps are zero, or there are more than 2^22 vertices.
            TypeError: If an argument is not numeric.

        Example:
            >>> import pointloom as loom
            >>> square = loom.TriangleMesh([[2, 0, 0], [3, 0, 0], [3, 0, 1], [2, 0, 1]], [[0, 1, 2], [0, 2, 3]])
            >>> ring = square.extrude_rotation(360, [0, 0, 1], resolution=32)
            >>> ring.is_watertight(), ring.euler_poincare_characteristic()
            (True, 0)
        """
        return sweeps.extrude_rotation(self, angle, axis, resolution, translation, capping)

    @returns_new
    def compute_uvatlas(self, size: int = 512, gutter: float = 1.0) -> Self:
        """Compute texture coordinates: cut the surface into charts and pack them, with xatlas on the CPU.

        Needs `pip install "pointloom[mesh]"`. Open3D's function uses Microsoft's UVAtlas and other parameters.

        Args:
            size: Width and height of the texture [texels], 1 to 2^14.
            gutter: Space between charts [texels].

        Returns:
            The mesh with non-overlapping texture coordinates in 0..1, (0, 0) for triangles without area. Earlier
            coordinates, material ids and textures are dropped. Reproducible and independent of the unit.

        Raises:
            ImportError, ValueError, TypeError: If xatlas is not installed, if there are no triangles, a vertex is not
                finite, `size` or `gutter` is out of range, or the charts do not fit, or if an argument is not a number.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh.create_box().compute_uvatlas(256, gutter=2)
            >>> mesh.triangle_uvs.shape, bool((mesh.triangle_uvs >= 0).all() and (mesh.triangle_uvs <= 1).all())
            ((36, 2), True)
        """
        return texture.compute_uvatlas(self, size, gutter)

    @returns_new
    def bake_vertex_colors(self, size: int = 1024, *, gutter: int = 4) -> Self:
        """Bake vertex colors into a texture, for programs without vertex colors.

        Args:
            size: Width and height of the texture [texels], 1 to 2^14.
            gutter: Colored texels around triangles, which hide the background at seams.

        Returns:
            The mesh with this texture instead of vertex colors and other textures. Bitwise identical on every device.

        Raises:
            ValueError, TypeError: If the mesh has no vertex colors, no texture coordinates or some outside 0..1, or an
                argument is out of range, or if an argument is not an integer.
            MemoryError: If the texture does not fit into device memory.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh.create_plane(create_uv_map=True)
            >>> mesh.vertex_colors = [[1, 0, 0], [1, 0, 0], [0, 0, 1], [0, 0, 1]]
            >>> baked = mesh.bake_vertex_colors(4)
            >>> baked.textures[0][:, 0].tolist()
            [[32, 0, 223], [96, 0, 159], [159, 0, 96], [223, 0, 32]]
        """
        return texture.bake_vertex_colors(self, size, gutter=gutter)

    def project_images_to_albedo(
        self, images: Any, intrinsic_matrices: Any, extrinsic_matrices: Any, tex_size: int = 1024
    ) -> Any:
        """Fill the texture from posed images.

        A texel is the mean, weighted by (cos / depth)^4, of the images that see it from the front, unoccluded (one ray
        per texel and image) and more than 2 pixels from a mesh edge. Unseen texels take the vertex colors, or black.
        Unlike Open3D's, a new mesh is returned.

        Args:
            images: uint8 images (h, w, 3), or RGBDImages with colors, whose depth is ignored.
            intrinsic_matrices: Matrices (3, 3), one per image, or one PinholeCameraIntrinsic or a list of them.
            extrinsic_matrices: T_camera_world (4, 4), one per image.
            tex_size: Texels per side.

        Returns:
            The mesh with one texture, uint8 (tex_size, tex_size, 3), padded by 8 texels around triangles. Bitwise
            reproducible on one device. About 110 B per texel, 7 B per pixel.

        Raises:
            ValueError, TypeError: If there are no triangles or texture coordinates in 0..1, images, cameras and poses
                disagree, or a pose is not rigid, or if images or cameras have another type.
            DeviceError: If images are on another device than the mesh.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh([[-1, -1, 2], [1, -1, 2], [-1, 1, 2]], [[0, 2, 1]])
            >>> mesh.triangle_uvs = [[0, 0], [0, 1], [1, 0]]
            >>> camera = loom.PinholeCameraIntrinsic(64, 48, 30.0, 30.0, 31.5, 23.5)
            >>> red = np.full((48, 64, 3), (200, 0, 0), np.uint8)
            >>> textured = mesh.project_images_to_albedo([red], camera, [np.eye(4)], tex_size=32)
            >>> textured.textures[0][20, 5].tolist()
            [200, 0, 0]
        """
        return texture.with_albedo(self, images, intrinsic_matrices, extrinsic_matrices, tex_size)[0]
