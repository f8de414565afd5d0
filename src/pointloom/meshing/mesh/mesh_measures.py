"""Measures of a mesh: normals, area, volume, bounds, curvature, geodesics, samples, voxels, comparison."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import view_as
from ...core.checks import check_count, check_finite, check_numeric, check_positive, check_rows, check_seed, check_shape
from ...core.devices import check_same_device
from ...core.dropped_results import returns_new
from ...core.exchange import asnumpy, on_host
from ...kernels.arrays.bounds import bound_points, box_of, find_extremes
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.select import gather_rows
from ...kernels.arrays.side_by_side import read_together
from ...kernels.extent.distance_sums import summarize_distances
from ...kernels.lang import float64, int32
from ...kernels.memory import check_room, contiguous, download, empty, upload
from ...kernels.meshes import mesh_measures
from ...kernels.meshes.geodesics import geodesic_distances
from ...kernels.meshes.mesh_curvature import measure_curvatures
from ...kernels.meshes.mesh_topology import Topology, find_topology, topology_of
from ...kernels.meshes.poisson_disk import CrowdedError, eliminate_samples
from ...kernels.meshes.surface_samples import SurfaceSamples
from ...kernels.rays.distance_colors import color_distances
from ...kernels.rays.solid_voxels import crossed_columns, inner_voxels
from ...kernels.rays.surface_hausdorff import distances_to
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.rays.triangle_voxels import VoxelFrame, read_counts, touched_columns, touched_voxels, voxels_of
from ...kernels.surface.orientation import normalize_vectors
from ...pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ...pcd.stored_arrays import read_only
from ...pcd.units import common_reference
from .finite_corners import check_finite_corners
from .mesh_arrays import MeshArrays, check_mesh
from .mesh_metrics import SurfaceMetrics, measure_both_ways, points_about
from .mesh_seams import sew
from .mesh_selection import MeshSelection
from .vertex_numbers import check_finite_vertices, check_vertices
from .voxel_grid import VoxelGrid

SAME_NORMAL = 1e-3  # rounding of float32 normals
SAMPLE_BYTES = 64  # per sampled point, with triangle, weights, normal and color
MAX_SAMPLES = 2**24  # initial points of Poisson disk sampling: about 4 GB with neighbors
MAX_COORDINATE = 1e30  # [m] limit of coordinates
MAX_KEYS = 2**62
MAX_CELLS = 2**30  # along an axis


class MeshCurvature(NamedTuple):
    """`mean`, `gaussian` and principal (`least`, `largest`) curvatures of vertices [1/m, 1/m^2]. NaN if undefined."""

    mean: NDArray[np.float64]
    gaussian: NDArray[np.float64]
    least: NDArray[np.float64]
    largest: NDArray[np.float64]


class MeshMeasures(MeshSelection):
    """Methods of TriangleMesh that measure and sample it."""

    _internal = ("check_solid", "check_surface", "draw_samples", "finite_area", "is_closed", "signed_volume")

    @returns_new
    def compute_vertex_normals(self) -> Self:
        """Set vertex normals to the area-weighted mean of the adjacent triangle normals.

        Returns unit normals of shape (m, 3): (0, 0, 1) at vertices without adjacent area (Open3D: zero), NaN at
        vertices that are not finite. Float64 sums in triangle order: bitwise reproducible.
        """
        vertices, triangles = self.arrays["vertices"], self.arrays["triangles"]
        return self.with_arrays(vertex_normals=mesh_measures.vertex_normals(vertices, triangles))

    def compute_triangle_normals(self) -> NDArray[np.float32]:
        """Unit normals of triangles, right-hand rule, (t, 3); (0, 0, 1) without area, NaN if a corner is not finite."""
        return self.arrays.hand_out(mesh_measures.triangle_normals(self.arrays["vertices"], self.arrays["triangles"]))

    @property
    def triangle_normals(self) -> NDArray[np.float32]:
        """Unit normals as `compute_triangle_normals`, always NumPy. Assignment accepts only these values, for
        compatibility.
        """
        return read_only(asnumpy(self.compute_triangle_normals()))

    @triangle_normals.setter
    def triangle_normals(self, values: ArrayLike) -> None:
        given = check_rows("triangle_normals", on_host("triangle_normals", values), 3, rows=len(self), dtype=np.float64)
        if not np.allclose(given, self.triangle_normals, rtol=0, atol=SAME_NORMAL, equal_nan=True):
            raise ValueError(
                "triangle_normals: expected the normals computed from the triangles, got others. "
                "Call orient_triangles() to flip triangles, or set vertex_normals for shading"
            )

    def get_surface_area(self) -> float:
        """Total area of the triangles [m^2].

        Raises:
            ValueError: If a triangle has a corner that is not finite.
        """
        check_finite_corners("get_surface_area", self)
        return self.finite_area()

    def get_volume(self) -> float:
        """Volume of a closed mesh [m^3]. 0 without triangles.

        Volumes of parts are added, those of inward-facing parts subtracted: orient separate parts outward first
        (`orient_triangles(outward=True)`).

        Raises:
            ValueError: If a corner is not finite, the mesh is not watertight, or its orientation is inconsistent.
        """
        self.check_solid("get_volume")
        return abs(self.signed_volume())

    def check_solid(self, name: str) -> None:
        """Check that the mesh encloses a volume, for the method `name`. Accepts a mesh without triangles."""
        check_finite_corners(name, self)
        topology = self.edge_topology()
        if not is_closed(topology):
            raise ValueError(f"{name}: expected a watertight mesh. Repair it with repair(hole_size=...) first")
        if topology.has_twisted_edge:
            raise ValueError(f"{name}: expected consistently oriented triangles. Call orient_triangles() first")

    def is_edge_manifold(self, allow_boundary_edges: bool = True) -> bool:
        """True if no edge has more than two triangles.

        Args:
            allow_boundary_edges: Allow edges of one triangle.

        Raises:
            ValueError: If a triangle has a corner that is not finite.
        """
        check_finite_corners("is_edge_manifold", self)
        topology = self.edge_topology()
        return not topology.has_crowded_edge and (allow_boundary_edges or not topology.has_boundary)

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
        check_finite_corners("is_watertight", self)
        return self.is_closed()

    def is_closed(self) -> bool:
        """True if there are triangles and each edge has two of them. Corners need not be finite."""
        return len(self) > 0 and is_closed(self.edge_topology())

    def finite_area(self) -> float:
        """Area of the triangles with finite corners [m^2]."""
        return mesh_measures.measure(self.arrays["vertices"], self.arrays["triangles"])[0]

    def signed_volume(self) -> float:
        return mesh_measures.measure(self.arrays["vertices"], self.arrays["triangles"])[1]

    def edge_topology(self) -> Topology:
        """Count triangles per edge on the device; basis of `is_watertight` and related checks."""
        return topology_of(download(find_topology(self.arrays["triangles"], self.arrays["vertices"].size)))  # sync

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Smallest axis-aligned box of the finite vertices. At zero if there are none. Unpacks as `low, high = box`."""
        low, high, count = bound_points(self.arrays["vertices"])
        if not count:
            return AxisAlignedBoundingBox()
        origin = self.arrays.origin
        return AxisAlignedBoundingBox(low.astype(np.float64) + origin, high.astype(np.float64) + origin)

    def get_min_bound(self) -> NDArray[np.float64]:
        """Minimum coordinates of the finite vertices [m], shape (3,); zeros if there are none."""
        return self.get_axis_aligned_bounding_box().min_bound

    def get_max_bound(self) -> NDArray[np.float64]:
        """Maximum coordinates of the finite vertices [m], shape (3,); zeros if there are none."""
        return self.get_axis_aligned_bounding_box().max_bound

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box along the principal axes of the convex hull's vertices, as `PointCloud.get_oriented_bounding_box`.

        Raises:
            ValueError: If no vertex is finite.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box(4, 2, 1).get_oriented_bounding_box().extent.round(6).tolist()
            [4.0, 2.0, 1.0]
        """
        return self._corner_cloud().get_oriented_bounding_box(robust)

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
        return self._corner_cloud().get_minimal_oriented_bounding_box(robust)

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
        hull, indices = self._corner_cloud().compute_convex_hull(joggle_inputs)
        make: Any = type(self)  # TriangleMesh
        mesh = make(hull.vertices, hull.triangles, device=self.device, origin=self.arrays.origin)
        mesh.arrays.library, mesh.unit, mesh.crs = self.arrays.library, self.unit, self.crs
        return mesh, indices

    @returns_new
    def normalize_normals(self) -> Self:
        """Scale vertex normals to unit length. Zero normals stay zero.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]], vertex_normals=2 * np.eye(3))
            >>> mesh.normalize_normals().vertex_normals.tolist() == np.eye(3).tolist()
            True
        """
        if "vertex_normals" not in self.arrays:
            return self.copy()
        return self.with_arrays(vertex_normals=normalize_vectors(self.arrays["vertex_normals"]))

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
        rows = self._inverse_mask(mask, len(self), "triangles")
        return self.drop_triangles(rows).remove_unreferenced_vertices()

    def _corner_cloud(self) -> PointCloud:
        """Vertices as a cloud that shares memory."""
        own = self.arrays
        return PointCloud.from_device_arrays({"points": own["vertices"]}, own.origin, own.library)

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
        count, seed = check_count("number_of_points", number_of_points), check_seed(seed)
        return self.draw_samples(self._surface("sample_points_uniformly"), count, use_triangle_normal, seed)

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
        count, factor, seed = (
            check_count("number_of_points", number_of_points),
            check_count("init_factor", init_factor),
            check_seed(seed),
        )
        surface = self._surface("sample_points_poisson_disk")
        if pcl is None:
            name, advice = "number_of_points, init_factor", "use fewer"
            if count * factor > MAX_SAMPLES:
                raise ValueError(
                    f"{name}: expected up to {MAX_SAMPLES:,} initial points, got {count * factor:,}; {advice}"
                )
            start = self.draw_samples(surface, count * factor, use_triangle_normal, seed)
        else:
            check_cloud("pcl", pcl)
            name, advice = "pcl", "downsample it first, for example with pcl.random_down_sample"
            start = pcl.to(self.device)
            if len(start) > MAX_SAMPLES:
                raise ValueError(f"{name}: expected up to {MAX_SAMPLES:,} points, got {len(start):,}; {advice}")
        return _spread(start, count, surface.area, name, advice)

    def _surface(self, operation: str) -> SurfaceSamples:
        surface = SurfaceSamples(self.arrays["vertices"], self.arrays["triangles"])
        self.check_surface(surface, operation)
        return surface

    def check_surface(self, surface: SurfaceSamples, operation: str) -> None:
        if not len(self):
            raise ValueError(f"{operation}: expected a mesh with triangles to sample, got none")
        check_finite_corners(operation, self)
        if not surface.area > 0:
            raise ValueError(
                f"{operation}: expected triangles with an area, but all {len(self)} triangles have "
                "coincident or collinear corners"
            )

    def draw_samples(self, surface: SurfaceSamples, count: int, use_triangle_normal: bool, seed: int) -> PointCloud:
        check_room(
            self.device, count * SAMPLE_BYTES, f"number_of_points: {count:,} points and their intermediate arrays"
        )
        surface.draw(count, seed)
        arrays: dict[str, Any] = {"points": surface.mix(self.arrays["vertices"])}
        if use_triangle_normal:
            arrays["normals"] = surface.triangle_normals()
        elif "vertex_normals" in self.arrays:
            arrays["normals"] = surface.mix(self.arrays["vertex_normals"], unit=True)
        if "vertex_colors" in self.arrays:
            arrays["colors"] = surface.mix(self.arrays["vertex_colors"])
        cloud = PointCloud.from_device_arrays(arrays, self.arrays.origin.copy(), self.arrays.library)
        cloud.unit, cloud.crs = self._unit, self._crs
        return cloud

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
        check_mesh("mesh2", mesh2)
        check_same_device("mesh2", self.device, mesh2.device)
        common_reference("mesh, mesh2", (self, mesh2))
        given = check_numeric("fscore_radius", fscore_radius).reshape(-1).tolist()
        radii = [check_positive("fscore_radius", radius) for radius in given]
        count, seed = check_count("n_sampled_points", n_sampled_points), check_seed(seed)
        there, back = measure_both_ways(self, mesh2, radii, count, seed)
        both = there.within + back.within
        fscore = np.divide(2 * there.within * back.within, both, out=np.zeros_like(both), where=both > 0)
        return SurfaceMetrics(
            there.mean + back.mean,
            max(there.lower, back.lower),
            fscore,
            max(there.upper, back.upper),
            (there.mean, back.mean),
            (there.rms, back.rms),
            (there.lower, back.lower),
        )

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
        check_mesh("mesh2", mesh2)
        check_same_device("mesh2", self.device, mesh2.device)
        common_reference("mesh, mesh2", (self, mesh2))
        check_finite_corners("compute_error_map: mesh2", mesh2)
        largest = None if max_distance is None else check_positive("max_distance", max_distance)
        points = points_about(self.arrays["vertices"], self.arrays.origin, mesh2.origin)
        tree = TriangleTree(mesh2.arrays["vertices"], mesh2.arrays["triangles"])
        distances = distances_to(points, tree)
        if largest is None:
            largest = float(np.float32(summarize_distances(distances, [])[2]))  # sync
        colored = self.with_arrays(vertex_colors=color_distances(distances, largest))
        return colored, self.arrays.hand_out(distances, dtype=np.float32)

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
        sewn = sew(self)
        curvatures = measure_curvatures(sewn.mesh.arrays["vertices"], sewn.mesh.arrays["triangles"])
        columns: Any = view_as(curvatures, float64, (curvatures.size, 4))
        columns = [contiguous(columns[:, k]) if curvatures.size else empty(0, float64, self.device) for k in range(4)]
        parts = [sewn.spread(column) for column in columns]
        return MeshCurvature(*map(self.arrays.hand_out, parts))

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
        vertices = self.arrays["vertices"]
        numbers = check_vertices("sources", sources, vertices.size)
        rows = upload(numbers, int32, self.device)
        check_finite_vertices("sources", numbers, gather_rows(vertices, rows))
        sewn = sew(self)
        arrays, sources_in_sewn = (
            sewn.mesh.arrays,
            rows if sewn.sewn_indices is None else gather_rows(sewn.sewn_indices, rows),
        )
        return self.arrays.hand_out(
            sewn.spread(geodesic_distances(arrays["vertices"], arrays["triangles"], sources_in_sewn))
        )

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
        size = check_positive("voxel_size", voxel_size, maximum=MAX_COORDINATE)
        extremes, findings = self._examined(solid)  # sync
        low, high = self._bounds_of_voxels(box_of(extremes), size, min_bound, max_bound)
        with np.errstate(over="ignore"):
            size_in_voxels = np.floor((high - low) / size + 0.5)
        if not (size_in_voxels < MAX_CELLS).all():
            raise ValueError(
                "voxel_size, min_bound, max_bound: expected fewer than 2^30 voxels along an axis, got "
                f"{size_in_voxels.max():g}. Use larger voxels"
            )
        counts = (int(size_in_voxels[0]), int(size_in_voxels[1]), int(size_in_voxels[2]))
        if math.prod(counts) >= MAX_KEYS:
            raise ValueError(
                f"voxel_size: a grid of {' x '.join(map(str, counts))} has more than 2^62 voxels. Use larger voxels"
            )
        if solid:
            self._check_closed(topology_of(findings), box_of(extremes)[2])
        cells = np.empty((0, 3), np.int32)
        if min(counts) > 0 and len(self):
            vertices, triangles = self.arrays["vertices"], self.arrays["triangles"]
            frame = VoxelFrame(low, size, counts)
            columns = [touched_columns(vertices, triangles, frame)]
            if solid:
                columns.append(crossed_columns(vertices, triangles, frame))
            read_counts(columns)  # sync
            keys = touched_voxels(columns[0])
            if solid:
                keys = concatenate_rows([keys, inner_voxels(columns[1], frame)])  # sync
            cells = download(voxels_of(keys, frame)).reshape(-1, 3).astype(np.int32)
        return VoxelGrid(low + self.arrays.origin, size, counts, cells)

    def _examined(self, solid: bool) -> list[NDArray[Any]]:
        """Download the bounds of the vertices and, for solids, the topology. One sync."""
        vertices, triangles = self.arrays["vertices"], self.arrays["triangles"]
        arrays: list[Any] = [find_extremes(vertices)]
        if solid:
            arrays.append(find_topology(triangles, vertices.size))
        return [*read_together(arrays), np.ones(4)][:2]  # sync

    def _bounds_of_voxels(
        self,
        box: tuple[NDArray[Any], NDArray[Any], int],
        size: float,
        min_bound: ArrayLike | None,
        max_bound: ArrayLike | None,
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Corners of the grid relative to the mesh's origin."""
        low, high, count = box
        at_low = low.astype(np.float64) - size * 0.5 if count else -np.full(3, size * 0.5)
        at_high = high.astype(np.float64) + size * 0.5 if count else np.full(3, size * 0.5)
        if min_bound is not None:
            at_low = _check_corner("min_bound", min_bound) - self.arrays.origin
        if max_bound is not None:
            at_high = _check_corner("max_bound", max_bound) - self.arrays.origin
        if not (at_low <= at_high).all():
            shown = f"{(at_low + self.arrays.origin).tolist()} and {(at_high + self.arrays.origin).tolist()}"
            raise ValueError(f"min_bound, max_bound: expected the lower corner first, got {shown}")
        return at_low, at_high

    def _check_closed(self, topology: Topology, finite_count: int) -> None:
        if not len(self) or topology.has_boundary or topology.has_crowded_edge:
            raise ValueError(
                "voxelize: solid=True requires a closed mesh, with two triangles at every edge. Merge vertices "
                "or fill holes first"
            )
        if finite_count < self.arrays["vertices"].size:
            raise ValueError("voxelize: solid=True requires finite vertices, got NaN or infinite ones")


def is_closed(topology: Topology) -> bool:
    return not (topology.has_boundary or topology.has_crowded_edge)


def _spread(start: PointCloud, count: int, area: float, name: str, advice: str) -> PointCloud:
    """Select `count` evenly spaced points; `name` is the argument reported in errors."""
    tree = start.search_tree()
    if tree.count < count:
        raise ValueError(f"{name}: expected at least number_of_points = {count} finite points, got {tree.count}")
    if tree.count == count:
        return start.remove_non_finite_points()
    widest = 2 * math.sqrt(area / count / (2 * math.sqrt(3)))  # hexagonal packing of discs with half this radius
    try:
        return start.select_rows(eliminate_samples(tree, count, widest))
    except CrowdedError as error:
        raise ValueError(
            f"{name}: expected up to 2^30 pairs of points closer than {widest:.3g} m, got {error.pair_count:,}; "
            f"{advice}"
        ) from error


def _check_corner(name: str, values: ArrayLike) -> NDArray[np.float64]:
    corner = check_finite(name, check_shape(name, values, (3,)))
    if np.abs(corner).max() > MAX_COORDINATE:
        raise ValueError(f"{name}: expected coordinates up to {MAX_COORDINATE:g} m, got {corner.tolist()}")
    return corner
