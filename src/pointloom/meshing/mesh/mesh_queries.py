"""Values of a mesh: normals, areas, bounds, topology, samples, comparisons, copies for other libraries."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.dropped_results import returns_new
from ...core.exchange import asnumpy
from ...core.to_other_libraries import to_meshio, to_pyvista, to_trimesh
from ...kernels.meshes.mesh_topology import Topology
from ...pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from ...pcd.cloud import PointCloud
from ...pcd.stored_arrays import read_only
from . import conversion, measures, metrics, sampling, solids, topology, voxel_grid
from .measures import MeshCurvature
from .mesh_arrays import MeshArrays
from .metrics import SurfaceMetrics
from .voxel_grid import VoxelGrid


class MeshQueries(MeshArrays):
    """Methods of TriangleMesh that measure, test and sample it."""

    def compute_triangle_normals(self) -> NDArray[np.float32]:
        """Unit normals of triangles, right-hand rule, (t, 3); (0, 0, 1) without area, NaN if a corner is not finite."""
        return measures.compute_triangle_normals(self)

    @property
    def triangle_normals(self) -> NDArray[np.float32]:
        """Unit normals as `compute_triangle_normals`, always NumPy. Assignment accepts only these values, for
        compatibility.
        """
        return read_only(asnumpy(measures.compute_triangle_normals(self)))

    @triangle_normals.setter
    def triangle_normals(self, values: ArrayLike) -> None:
        measures.check_triangle_normals(self, values)

    def compute_triangle_areas(self) -> NDArray[np.float64]:
        """Area of each triangle [m^2], shape (t,). NaN if a corner is not finite.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]]).compute_triangle_areas().tolist()
            [1.0]
        """
        return measures.compute_triangle_areas(self)

    def get_surface_area(self) -> float:
        """Total area of the triangles [m^2].

        Raises:
            ValueError: If a triangle has a corner that is not finite.
        """
        return measures.get_surface_area(self)

    def get_volume(self) -> float:
        """Volume of a closed mesh [m^3]. 0 without triangles.

        Volumes of parts are added, those of inward-facing parts subtracted: orient separate parts outward first
        (`orient_triangles(outward=True)`).

        Raises:
            ValueError: If a corner is not finite, the mesh is not watertight, or its orientation is inconsistent.
        """
        return measures.get_volume(self)

    @property
    def center_of_mass(self) -> NDArray[np.float64]:
        """Center of mass of a closed mesh of uniform density [m], shape (3,), float64.

        Volumes of inward-facing parts, such as cavities, are subtracted, as in `get_volume`. trimesh: `center_mass`.

        Raises:
            ValueError: If a corner is not finite, the mesh is not watertight, its orientation is inconsistent, or it
                encloses no volume.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box(4, 2, 1).center_of_mass.tolist()
            [2.0, 1.0, 0.5]
        """
        return measures.mass(self, "center_of_mass")[1] + self.arrays.origin

    @property
    def moment_of_inertia(self) -> NDArray[np.float64]:
        """Inertia tensor of a closed mesh of density 1 about its center of mass, shape (3, 3), float64 [m^5].

        Multiply by the density [kg/m^3] for kg m^2. The axes are those of the coordinates. `numpy.linalg.eigh` returns
        the principal moments and axes. trimesh: `moment_inertia`.

        Raises:
            ValueError: As `center_of_mass`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box(4, 2, 1).moment_of_inertia.diagonal().round(4).tolist()
            [3.3333, 11.3333, 13.3333]
        """
        return measures.moment_of_inertia(self)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Smallest axis-aligned box of the finite vertices. At zero if there are none. Unpacks as `low, high = box`."""
        return measures.get_axis_aligned_bounding_box(self)

    def get_min_bound(self) -> NDArray[np.float64]:
        """Minimum coordinates of the finite vertices [m], shape (3,); zeros if there are none."""
        return measures.get_axis_aligned_bounding_box(self).min_bound

    def get_max_bound(self) -> NDArray[np.float64]:
        """Maximum coordinates of the finite vertices [m], shape (3,); zeros if there are none."""
        return measures.get_axis_aligned_bounding_box(self).max_bound

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box along the principal axes of the convex hull's vertices, as `PointCloud.get_oriented_bounding_box`.

        Raises:
            ValueError: If no vertex is finite.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box(4, 2, 1).get_oriented_bounding_box().extent.round(6).tolist()
            [4.0, 2.0, 1.0]
        """
        return measures.corner_cloud(self).get_oriented_bounding_box(robust)

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box of minimal volume around the vertices, as `PointCloud.get_minimal_oriented_bounding_box`.

        Raises:
            ValueError: If no vertex is finite.

        Example:
            >>> import pointloom as loom
            >>> turned = loom.TriangleMesh.create_box(4, 2, 1).rotate([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
            >>> round(turned.get_minimal_oriented_bounding_box().volume(), 5)
            8.0
        """
        return measures.corner_cloud(self).get_minimal_oriented_bounding_box(robust)

    @returns_new
    def compute_convex_hull(self, joggle_inputs: bool = False) -> tuple[Self, NDArray[np.int64]]:
        """Convex hull of the finite vertices, as `PointCloud.compute_convex_hull`.

        Args:
            joggle_inputs: Let Qhull perturb its input by about 1e-11 of its size instead of merging facets.

        Returns:
            (hull mesh, ascending indices of its vertices in this mesh, int64 (m,)).

        Raises:
            ValueError: If no vertex is finite, or all are collinear.

        Example:
            >>> import pointloom as loom
            >>> hull, indices = loom.TriangleMesh.create_torus(2, 1).compute_convex_hull()
            >>> hull.is_watertight(), len(indices) == len(hull.vertices)
            (True, True)
        """
        return measures.compute_convex_hull(self, joggle_inputs)

    def compute_vertex_curvature(self) -> MeshCurvature:
        """Estimate mean, Gaussian and principal curvatures at each vertex.

        Noise is amplified by the inverse square of the edge length: smooth first. Bitwise identical on every device.
        Meyer et al., "Discrete differential-geometry operators for triangulated 2-manifolds", VisMath 2003, eq. 8-11.

        Returns:
            A `MeshCurvature`. NaN at vertices without a closed ring of consistently oriented triangles, and next to a
            triangle without area or a vertex that is not finite. Texture seams do not count as borders.

        Example:
            >>> import pointloom as loom
            >>> corners = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
            >>> faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
            >>> curvature = loom.TriangleMesh(corners, faces).compute_vertex_curvature()
            >>> curvature.gaussian.round(3).tolist()
            [1.814, 1.814, 1.814, 1.814, 1.814, 1.814]
        """
        return measures.compute_vertex_curvature(self)

    def compute_geodesic_distances(self, sources: ArrayLike) -> NDArray[np.float64]:
        """Distance of each vertex along the surface to the nearest source vertex.

        Exact on flat parts visible from the source. Error below 0.7% on a sphere of 10,242 vertices, up to half an edge
        where fronts meet. Bitwise identical on every device. Novotni and Klein, "Computing geodesic distances on
        triangular meshes", WSCG 2002.

        Args:
            sources: Vertex indices, at least one.

        Returns:
            Distances [m], float64 (m,): 0 at the sources, infinite if unreachable. Paths cross texture seams.

        Raises:
            ValueError: If there is no source, or one does not exist or is not finite.
            TypeError: If the indices are not integers.

        Example:
            >>> import pointloom as loom
            >>> square = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 4, 0], [3, 4, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> square.compute_geodesic_distances([0]).tolist()
            [0.0, 3.0, 4.0, 5.0]
        """
        return measures.compute_geodesic_distances(self, sources)

    def edge_topology(self) -> Topology:
        """Count triangles per edge on the device; basis of `is_watertight` and related checks."""
        return topology.edge_topology(self)

    def is_watertight(self) -> bool:
        """True if there are triangles and each edge has exactly two of them.

        Open3D also requires `is_vertex_manifold` and no self-intersection, and returns True for an empty mesh.

        Raises:
            ValueError: If a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box()
            >>> box.is_watertight(), loom.TriangleMesh(box.vertices, box.triangles[1:]).is_watertight()
            (True, False)
        """
        return topology.is_watertight(self)

    def is_edge_manifold(self, allow_boundary_edges: bool = True) -> bool:
        """True if no edge has more than two triangles.

        Args:
            allow_boundary_edges: Allow edges of one triangle.

        Raises:
            ValueError: If a triangle has a corner that is not finite.
        """
        return topology.is_edge_manifold(self, allow_boundary_edges)

    def is_vertex_manifold(self) -> bool:
        """True if the triangles at each vertex are connected by edges. See `get_non_manifold_vertices`.

        Raises:
            ValueError: If a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [0, 3, 4]]).is_vertex_manifold()
            False
        """
        return topology.is_vertex_manifold(self)

    def is_orientable(self) -> bool:
        """True if all triangles can be oriented consistently. False for a Möbius strip or a Klein bottle.

        Edges of three or more triangles impose no constraint. `orient_triangles` applies the orientation.

        Raises:
            ValueError: If a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
            >>> mesh.is_orientable()
            True
        """
        return topology.is_orientable(self)

    def get_boundary_edges(self) -> NDArray[np.int32]:
        """Edges of exactly one triangle: vertex indices of shape (k, 2), the lower one first, in ascending order.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.get_boundary_edges().tolist()
            [[0, 1], [0, 2], [1, 3], [2, 3]]
        """
        return topology.get_boundary_edges(self)

    def get_boundaries(self) -> list[NDArray[np.int32]]:
        """Trace the boundary loops of the mesh.

        About 130 B of memory per triangle. Bitwise identical on every device.

        Returns:
            One int32 array of vertices per loop, in triangle orientation (clockwise around a hole seen from outside). A
            loop starts with its lowest vertex and visits no vertex twice. Boundaries at edges of three or more
            triangles or at inconsistent orientations are omitted: see `remove_non_manifold_edges`, `orient_triangles`.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> [loop.tolist() for loop in mesh.get_boundaries()]
            [[0, 1, 3, 2]]
        """
        return topology.get_boundaries(self)

    def get_non_manifold_edges(self, allow_boundary_edges: bool = True) -> NDArray[np.int32]:
        """List the edges of more than two triangles.

        Args:
            allow_boundary_edges: If False, edges of one triangle are listed too.

        Returns:
            Vertex indices of shape (k, 2), the lower one first, in ascending order.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [-1, 0, 0], [0, 1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
            >>> mesh.get_non_manifold_edges().tolist(), len(mesh.get_non_manifold_edges(False))
            ([[0, 1]], 7)
        """
        return topology.get_non_manifold_edges(self, allow_boundary_edges)

    def get_non_manifold_vertices(self) -> NDArray[np.int32]:
        """List the vertices whose triangles are not connected by edges at the vertex, in ascending order.

        Vertices without triangles and triangles with a repeated vertex do not count.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [0, 3, 4]]).get_non_manifold_vertices().tolist()
            [0]
        """
        return topology.get_non_manifold_vertices(self)

    def compute_adjacency_list(self) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """List the neighbors of each vertex along edges.

        About 50 B of memory per half-edge. Bitwise identical on every device.

        Returns:
            (starts, neighbors), int32 of shape (m + 1,) and (k,): `neighbors[starts[v] : starts[v + 1]]` belong to
            vertex v, ascending.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> starts, neighbors = mesh.compute_adjacency_list()
            >>> neighbors[starts[0] : starts[1]].tolist(), neighbors[starts[1] : starts[2]].tolist()
            ([1, 2], [0, 2, 3])
        """
        return topology.compute_adjacency_list(self)

    def euler_poincare_characteristic(self) -> int:
        """Euler characteristic V - E + F: 2 for a closed surface without handles, 0 for a torus.

        Unreferenced vertices do not count (in Open3D they do).

        Raises:
            ValueError: If a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5]], [[0, 1, 2]])
            >>> mesh.euler_poincare_characteristic()
            1
        """
        return topology.euler_poincare_characteristic(self)

    def is_self_intersecting(self) -> bool:
        """True if two triangles without a common vertex intersect. See `get_self_intersecting_triangles`.

        Raises:
            ValueError: If a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).is_self_intersecting()
            True
        """
        return solids.is_self_intersecting(self)

    def get_self_intersecting_triangles(self) -> NDArray[np.int32]:
        """List pairs of intersecting triangles without a common vertex.

        O(n log n) time, O(n + k) memory. Bitwise identical on every device. Guigue and Devillers, "Fast and robust
        triangle-triangle overlap test", JGT 2003. Shewchuk, "Adaptive precision floating-point arithmetic", DCG 1997.

        Returns:
            int32 of shape (k, 2), the lower index first, ascending. Coincident vertices with two indices count as two,
            so in a triangle soup all neighbors intersect.

        Raises:
            ValueError: If there are 2^31 pairs or more.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).get_self_intersecting_triangles().tolist()
            [[0, 1]]
        """
        return solids.get_self_intersecting_triangles(self)

    def is_intersecting(self, other: MeshArrays) -> bool:
        """True if a triangle of this mesh intersects one of another mesh.

        Meshes inside each other do not intersect: see `RaycastingScene.compute_occupancy`.

        Args:
            other: A mesh on the same device. Its vertices are rounded to float32 about this mesh's `origin`.

        Raises:
            TypeError, DeviceError: If `other` is not a mesh, or if the meshes are on different devices.
            ValueError: If there are 2^31 pairs or more, or a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]])
            >>> wall = loom.TriangleMesh([[0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]], [[0, 1, 2]])
            >>> floor.is_intersecting(wall)
            True
        """
        return solids.is_intersecting(self, other)

    @explain_argument_errors
    def sample_points_uniformly(
        self, number_of_points: int = 100, use_triangle_normal: bool = False, seed: int = 0
    ) -> PointCloud:
        """Sample points uniformly at random from the surface.

        Args:
            number_of_points: Number of points.
            use_triangle_normal: Give the points the normals of their triangles.
            seed: Random seed, 0..2^31 - 1.

        Returns:
            Points about the mesh's origin, with interpolated colors and unit normals if the mesh has them. The same
            points on every device. The first k of n equal a sample of k.

        Raises:
            ValueError: If the count is below 1, no triangle has an area, or a corner is not finite.
            TypeError, MemoryError: If an argument is not an integer, or if the points do not fit into device memory.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> cloud = mesh.sample_points_uniformly(500, use_triangle_normal=True)
            >>> len(cloud), cloud.normals[0].tolist(), bool((cloud.points @ [1, 2, 0] <= 2).all())
            (500, [0.0, 0.0, 1.0], True)
        """
        return sampling.sample_points_uniformly(self, number_of_points, use_triangle_normal, seed)

    @explain_argument_errors
    def sample_points_poisson_disk(
        self,
        number_of_points: int,
        init_factor: int = 5,
        pcl: PointCloud | None = None,
        use_triangle_normal: bool = False,
        seed: int = 0,
    ) -> PointCloud:
        """Sample evenly spaced points by eliminating those with the most and nearest neighbors from a random sample.

        About 350 B per initial point if `init_factor` is 5, 260 B of them for neighbors. Yuksel, "Sample elimination
        for generating Poisson disk sample sets", Eurographics 2015 (alpha 8, beta 0.65, gamma 1.5).

        Args:
            number_of_points: Exact number of points.
            init_factor: Ratio of random points to result points. 1 removes none.
            pcl: Points to choose from instead. They keep their attributes.
            use_triangle_normal: Give random points the normals of their triangles.
            seed: Random seed, 0..2^31 - 1.

        Returns:
            Points in drawing order (or that of `pcl`), as `sample_points_uniformly`. The same points on every device.

        Raises:
            ValueError: As `sample_points_uniformly`; or if `pcl` has too few finite points, there are more than 2^24
                initial points, or more than 2^30 neighbor pairs.
            TypeError: If an argument is not an integer, or `pcl` is not a PointCloud.
            MemoryError: If the points or their neighbors do not fit into device memory.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
            >>> cloud = mesh.sample_points_poisson_disk(200)
            >>> gaps = cloud.compute_nearest_neighbor_distance()
            >>> len(cloud), bool(gaps.min() > 0.7 * gaps.mean())
            (200, True)
        """
        return sampling.sample_points_poisson_disk(self, number_of_points, init_factor, pcl, use_triangle_normal, seed)

    def voxelize(
        self,
        voxel_size: float,
        min_bound: ArrayLike | None = None,
        max_bound: ArrayLike | None = None,
        *,
        solid: bool = False,
    ) -> VoxelGrid:
        """Find the voxels that the surface touches, and optionally those inside.

        The grid starts half a voxel below the lowest coordinates, or at `min_bound`. Its size is rounded, as in
        Open3D's `VoxelGrid`. Memory: about 50 B per voxel of each triangle and per inside voxel. Bitwise reproducible.
        Akenine-Möller, "Fast 3D triangle-box overlap testing", JGT 2001.

        Args:
            voxel_size: Edge of a voxel [m].
            min_bound, max_bound: Corners of the grid [m], shape (3,).
            solid: Include voxels with centers inside the surface by the even-odd rule. The mesh must be closed.

        Returns:
            The grid of occupied voxels within the bounds. A voxel touched from outside, to 1e-9 of a voxel, is
            occupied. Triangles with a corner that is not finite are ignored.

        Raises:
            ValueError: If the size or bounds are invalid, there are 2^30 voxels along an axis or more than 2^31 - 1 to
                test, or with `solid` the mesh is not closed or a vertex is not finite.
            TypeError: If an argument is not numeric.
            MemoryError: If the voxels do not fit into device memory. Checked before allocation.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box(4, 4, 4)
            >>> len(box.voxelize(1)), len(box.voxelize(1, solid=True))
            (98, 125)
        """
        return voxel_grid.voxelize(self, voxel_size, min_bound, max_bound, solid=solid)

    def compute_metrics(
        self,
        mesh2: MeshArrays,
        fscore_radius: Sequence[float] = (0.01,),
        n_sampled_points: int = 100_000,
        *,
        seed: int = 0,
    ) -> SurfaceMetrics:
        """Compare two surfaces: Chamfer and Hausdorff distances, F-scores, mean and RMS, in both directions.

        Point-to-triangle distances are exact. Means and F-scores use sampled points. The Hausdorff distance is bounded
        over the complete surface (Open3D takes the maximum of the samples). 24 B per sample, 60 B per triangle. Bitwise
        reproducible. Tang, Lee and Kim, "Interactive Hausdorff distance computation", SIGGRAPH 2009. F-score: Knapitsch
        et al., "Tanks and Temples", SIGGRAPH 2017.

        Args:
            mesh2: The other mesh, on the same device.
            fscore_radius: Exclusive radii of the F-scores [m].
            n_sampled_points: Points sampled from each surface.
            seed: Random seed, 0..2^31 - 1.

        Returns:
            SurfaceMetrics. `hausdorff` and `hausdorff_bound` differ by at most 1e-5 of the meshes' size, unless that
            needs more than four million pieces of the surface.

        Raises:
            TypeError, ValueError: If `mesh2` is not a mesh or an argument is not a number, or if a mesh has no area or
                a corner that is not finite, the meshes are 1.8e19 m apart, or a radius or count is not positive.
            DeviceError: If the meshes are on different devices.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> above = loom.TriangleMesh([[0, 0, 2], [1, 0, 2], [0, 1, 2]], [[0, 1, 2]])
            >>> found = floor.compute_metrics(above, fscore_radius=[1, 3], n_sampled_points=1000)
            >>> found.chamfer, found.hausdorff, found.fscore.tolist()
            (4.0, 2.0, [0.0, 100.0])
        """
        return metrics.compute_metrics(self, mesh2, fscore_radius, n_sampled_points, seed=seed)

    @returns_new
    def compute_error_map(
        self, mesh2: MeshArrays, max_distance: float | None = None
    ) -> tuple[Self, NDArray[np.float32]]:
        """Color vertices by their exact distances from another mesh.

        Args:
            mesh2: The other mesh, on the same device.
            max_distance: Distance of the last color [m]. If None: the largest distance.

        Returns:
            (mesh, distances): `vertex_colors` from dark blue at 0 over green to yellow, gray if undefined; float32 (m,)
            [m], NaN or infinite there. Bitwise reproducible.

        Raises:
            TypeError: If `mesh2` is not a mesh, or `max_distance` is not a number.
            ValueError: If the distance is not positive, or `mesh2` has a corner that is not finite.
            DeviceError: If the meshes are on different devices.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> slope = loom.TriangleMesh([[0, 0, 0], [1, 0, 1], [0, 1, 3]], [[0, 1, 2]])
            >>> colored, distances = slope.compute_error_map(floor)
            >>> distances.tolist(), colored.vertex_colors[2].round(2).tolist()
            ([0.0, 1.0, 3.0], [0.9900000095367432, 0.9100000262260437, 0.14000000059604645])
        """
        return metrics.compute_error_map(self, mesh2, max_distance)

    def to_open3d(self) -> Any:
        """Copy to a legacy `open3d.geometry.TriangleMesh`, with normals, colors and textures.

        Raises:
            ImportError: If Open3D is not installed.

        Warns:
            UserWarning: If the mesh has attributes, which `to_open3d_tensor` keeps.
        """
        return conversion.to_open3d(self)

    def to_open3d_tensor(self) -> Any:
        """Copy to an `open3d.t.geometry.TriangleMesh` on the CPU with all attributes, those of one axis as columns.

        Raises:
            ImportError: If Open3D is not installed.

        Warns:
            UserWarning: If there are several textures, or attributes in float16, which Open3D does not have.
        """
        return conversion.to_open3d_tensor(self)

    def to_trimesh(self) -> Any:
        """Copy to a `trimesh.Trimesh`, with colors in 8 bits. Vertices at texture seams are duplicated.

        The unit and the coordinate system are in its metadata.

        Raises:
            ImportError: If trimesh is not installed.

        Warns:
            UserWarning: If there are several textures.
        """
        return to_trimesh(conversion.other_geometry(self, "trimesh.Trimesh"))

    def to_pyvista(self) -> Any:
        """Copy to a `pyvista.PolyData`, with colors in 8 bits as "RGB". Vertices at texture seams are duplicated.

        The unit and the coordinate system are in its field data.

        Raises:
            ImportError: If PyVista is not installed.

        Warns:
            UserWarning: If there are textures, which PyVista takes when it draws.
        """
        return to_pyvista(conversion.other_geometry(self, "pyvista.PolyData"))

    def to_meshio(self) -> Any:
        """Copy to a `meshio.Mesh`, with colors in 8 bits as "RGB". Vertices at texture seams are duplicated.

        The unit and the coordinate system are in its `info`.

        Raises:
            ImportError: If meshio is not installed.

        Warns:
            UserWarning: If there are textures.
        """
        return to_meshio(conversion.other_geometry(self, "meshio.Mesh"))
