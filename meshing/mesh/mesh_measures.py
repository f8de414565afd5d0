"""Measures of a mesh: normals, area, volume, bounds, curvature, geodesics, samples, voxels, comparison."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import view_as
from ...core.checks import check_count, check_finite, check_numeric, check_positive, check_rows, check_seed, check_shape
from ...core.devices import check_same_device
from ...core.dropped_results import returns_new
from ...core.told_arguments import told_arguments
from ...core.units import common_unit
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
from ...kernels.meshes.mesh_topology import Topology, examine, find_topology, topology_of
from ...kernels.meshes.poisson_disk import CrowdedError, eliminate_samples
from ...kernels.meshes.surface_samples import SurfaceSamples
from ...kernels.rays.distance_colors import color_distances
from ...kernels.rays.solid_voxels import crossed_columns, inner_voxels
from ...kernels.rays.surface_hausdorff import distances_to
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.rays.triangle_voxels import VoxelFrame, settle, touched_columns, touched_voxels, voxels_of
from ...kernels.surface.orientation import normalize_vectors
from ...pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud, read_only
from .finite_corners import check_finite_corners
from .mesh_arrays import check_mesh
from .mesh_metrics import SurfaceMetrics, measure_both_ways, points_about
from .mesh_seams import sew
from .mesh_selection import MeshSelection
from .vertex_numbers import check_finite_vertices, check_vertices
from .voxel_grid import VoxelGrid

if TYPE_CHECKING:
    from .mesh import TriangleMesh

SAME_NORMAL = 1e-3  # what rounding makes of float32 normals
SAMPLE_BYTES = 64  # of a point that is drawn, with its triangle, weights, normal and colour
MOST_SAMPLES = 2**24  # that an even choice begins with: about 4 GB with their neighbours
LONGEST = 1e30  # [m] of a coordinate
MOST_KEYS = 2**62
MOST_CELLS = 2**30  # along an axis


class MeshCurvature(NamedTuple):
    """Curvature at the vertices of a mesh, float64 [m] each; NaN where there is none.

    Attributes:
        mean: Half the sum of the principal curvatures [1/m]; above 0 where the surface bulges towards its outside.
        gaussian: Their product [1/m^2].
        least, largest: The principal curvatures [1/m].
    """

    mean: NDArray[np.float64]
    gaussian: NDArray[np.float64]
    least: NDArray[np.float64]
    largest: NDArray[np.float64]


class MeshMeasures(MeshSelection):
    """The part of TriangleMesh that measures and samples it."""

    @returns_new
    def compute_vertex_normals(self) -> Self:
        """Set the normal of each vertex to the mean of the triangles around it, weighted by their areas.

        Returns:
            The mesh with unit normals [m, 3]; (0, 0, 1) at vertices without area around them (Open3D: zero), and NaN at
            vertices that are not finite, whose triangles count nowhere.

        Notes:
            O(m + t) memory. Sums run in float64 by ascending triangle: the same bits from run to run.
        """
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        return self._with_arrays(vertex_normals=mesh_measures.vertex_normals(vertices, triangles))

    def compute_triangle_normals(self) -> NDArray[np.float32]:
        """The unit normals of the triangles by the right-hand rule, shape [t, 3].

        They are (0, 0, 1) for triangles without area, and NaN for those with a corner that is not finite.

        Open3D stores them in its mesh; here they are returned.
        """
        normals = mesh_measures.triangle_normals(self._arrays["vertices"], self._arrays["triangles"])
        return download(normals).reshape(-1, 3)

    @property
    def triangle_normals(self) -> NDArray[np.float32]:
        """The unit normals of the triangles, as `compute_triangle_normals` gives them: those of the triangles always.

        Assigning takes what they are, for code that copies them from mesh to mesh, and nothing else.
        """
        return read_only(self.compute_triangle_normals().copy())

    @triangle_normals.setter
    def triangle_normals(self, values: ArrayLike) -> None:
        given = check_rows("triangle_normals", values, 3, rows=len(self), dtype=np.float64)
        if not np.allclose(given, self.compute_triangle_normals(), rtol=0, atol=SAME_NORMAL, equal_nan=True):
            raise ValueError(
                "triangle_normals: these are not the triangles' own, which no mesh keeps apart from its triangles; "
                "orient_triangles() turns triangles, vertex_normals shade"
            )

    def get_surface_area(self) -> float:
        """The area [m^2] of all triangles.

        Raises:
            ValueError: A triangle has a corner that is not finite.
        """
        check_finite_corners("get_surface_area", self)
        return self._finite_area()

    def get_volume(self) -> float:
        """The volume [m^3] that a closed mesh encloses; 0 where there are no triangles.

        It is closed where each edge belongs to exactly two triangles; parts may touch at vertices.

        Of several parts the volumes are added, of those that look inwards subtracted: a hollow counts as one where its
        wall looks into it, and parts beside each other should all look outwards (`orient_triangles(outward=True)`).

        Raises:
            ValueError: A triangle has a corner that is not finite, the mesh is not watertight, or neighboring triangles
                do not turn the same way. Open3D answers for the latter, too: 0.667 for a unit box with one triangle
                flipped.
        """
        check_finite_corners("get_volume", self)
        topology = self.edge_topology()
        if not is_closed(topology):
            raise ValueError("get_volume: the mesh is not watertight, so it encloses no volume")
        if topology.has_twisted_edge:
            raise ValueError("get_volume: neighbouring triangles turn different ways; orient them alike")
        return abs(self._signed_volume())

    def is_edge_manifold(self, allow_boundary_edges: bool = True) -> bool:
        """Whether no edge belongs to more than two triangles.

        Args:
            allow_boundary_edges: Whether edges of one triangle only are allowed.

        Raises:
            ValueError: A triangle has a corner that is not finite.
        """
        check_finite_corners("is_edge_manifold", self)
        topology = self.edge_topology()
        return not topology.has_crowded_edge and (allow_boundary_edges or not topology.has_boundary)

    def is_watertight(self) -> bool:
        """Whether each edge belongs to exactly two triangles: then the mesh has a volume.

        A mesh without triangles is not, since it encloses nothing; Open3D says that it is. Open3D's test also asks that
        the triangles at each vertex are one fan and that none cut through each other, neither of which lets water out:
        `is_vertex_manifold` and `is_self_intersecting` tell.

        Raises:
            ValueError: A triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box()
            >>> box.is_watertight(), loom.TriangleMesh(box.vertices, box.triangles[1:]).is_watertight()
            (True, False)
        """
        check_finite_corners("is_watertight", self)
        return self._is_closed()

    def _is_closed(self) -> bool:
        """True if there are triangles and each edge has two of them; corners need not be finite."""
        return len(self) > 0 and is_closed(self.edge_topology())

    def _finite_area(self) -> float:
        """The area [m^2] of the triangles whose corners are finite."""
        return mesh_measures.measure(self._arrays["vertices"], self._arrays["triangles"])[0]

    def _signed_volume(self) -> float:
        return mesh_measures.measure(self._arrays["vertices"], self._arrays["triangles"])[1]

    def edge_topology(self) -> Topology:
        """How triangles meet at edges, counted on the device: what `is_watertight` and its kin are told from."""
        return examine(self._arrays["triangles"], self._arrays["vertices"].size)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """The smallest aligned box around the finite vertices; at zero if none are. `low, high = box` unpacks it."""
        low, high, count = bound_points(self._arrays["vertices"])
        if not count:
            return AxisAlignedBoundingBox()
        return AxisAlignedBoundingBox(low.astype(np.float64) + self._origin, high.astype(np.float64) + self._origin)

    def get_min_bound(self) -> NDArray[np.float64]:
        """The lowest coordinates of the finite vertices [m], shape [3]; zeros where there is none."""
        return self.get_axis_aligned_bounding_box().min_bound

    def get_max_bound(self) -> NDArray[np.float64]:
        """The highest coordinates of the finite vertices [m], shape [3]; zeros where there is none."""
        return self.get_axis_aligned_bounding_box().max_bound

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box along the principal axes of the convex hull's vertices, as `PointCloud.get_oriented_bounding_box`.

        Raises:
            ValueError: No vertex is finite.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box(4, 2, 1).get_oriented_bounding_box().extent.round(6).tolist()
            [4.0, 2.0, 1.0]
        """
        return self._corner_cloud().get_oriented_bounding_box(robust)

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box of least volume around the vertices, as `PointCloud.get_minimal_oriented_bounding_box`.

        Raises:
            ValueError: No vertex is finite.

        Example:
            >>> import pointloom as loom
            >>> turned = loom.TriangleMesh.create_box(4, 2, 1).rotate([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
            >>> round(turned.get_minimal_oriented_bounding_box().volume(), 5)
            8.0
        """
        return self._corner_cloud().get_minimal_oriented_bounding_box(robust)

    @returns_new
    def compute_convex_hull(self, joggle_inputs: bool = False) -> tuple[Self, NDArray[np.int64]]:
        """The convex hull of the finite vertices, as `PointCloud.compute_convex_hull`.

        Args:
            joggle_inputs: Let Qhull move its input by some 1e-11 of its size instead of merging facets.

        Returns:
            The hull as a mesh, and the index of the mesh's vertex at each of its vertices, ascending, int64 [m].

        Raises:
            ValueError: No vertex is finite, or all lie on one line.

        Example:
            >>> import pointloom as loom
            >>> hull, indices = loom.TriangleMesh.create_torus(2, 1).compute_convex_hull()
            >>> hull.is_watertight(), len(indices) == len(hull.vertices)
            (True, True)
        """
        hull, indices = self._corner_cloud().compute_convex_hull(joggle_inputs)
        make: Any = type(self)  # TriangleMesh
        mesh = make(hull.vertices, hull.triangles, device=self._device, origin=self._origin)
        mesh._library = self._library
        return mesh, indices

    @returns_new
    def normalize_normals(self) -> Self:
        """The mesh with vertex normals of unit length; zero ones stay zero.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]], vertex_normals=2 * np.eye(3))
            >>> mesh.normalize_normals().vertex_normals.tolist() == np.eye(3).tolist()
            True
        """
        if "vertex_normals" not in self._arrays:
            return self.copy()
        return self._with_arrays(vertex_normals=normalize_vectors(self._arrays["vertex_normals"]))

    @returns_new
    def select_faces_by_mask(self, mask: ArrayLike) -> Self:
        """The triangles where a mask is set, with the vertices that they use.

        Args:
            mask: Booleans of shape [t].

        Raises:
            ValueError: Not booleans, or another shape.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box()
            >>> box.select_faces_by_mask(box.compute_triangle_normals()[:, 2] > 0.5)
            TriangleMesh(4 vertices, 2 triangles, cpu)
        """
        rows = self._left_by(mask, len(self), "triangles")
        return self._without(rows).remove_unreferenced_vertices()

    def _corner_cloud(self) -> PointCloud:
        """The vertices as a cloud over the same memory."""
        return PointCloud._from_device_arrays({"points": self._arrays["vertices"]}, self._origin, self._library)

    @told_arguments
    def sample_points_uniformly(
        self, number_of_points: int = 100, use_triangle_normal: bool = False, seed: int = 0
    ) -> PointCloud:
        """Points drawn from the surface at random, each place as likely as any other.

        Args:
            number_of_points: How many.
            use_triangle_normal: Give the points the normals of their triangles.
            seed: Chooses the points, 0..2^31 - 1.

        Returns:
            The points, about the mesh's origin. Where the mesh has vertex normals or colours, with those between the
            corners of their triangles; normals of unit length (Open3D leaves them shorter). Triangles without area get
            no points.

        Raises:
            ValueError: A count below 1, no triangles, none with an area, or one with a corner that is not finite.
            TypeError: No whole numbers.
            MemoryError: The device has no room for so many points.

        Notes:
            8 B of memory a triangle, 28 B a point beside the result. The same points on every device: the first k of
            n are those of k.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> cloud = mesh.sample_points_uniformly(500, use_triangle_normal=True)
            >>> len(cloud), cloud.normals[0].tolist(), bool((cloud.points @ [1, 2, 0] <= 2).all())
            (500, [0.0, 0.0, 1.0], True)
        """
        count, seed = check_count("number_of_points", number_of_points), check_seed(seed)
        return self._draw(self._surface("sample_points_uniformly"), count, use_triangle_normal, seed)

    @told_arguments
    def sample_points_poisson_disk(
        self,
        number_of_points: int,
        init_factor: int = 5,
        pcl: PointCloud | None = None,
        use_triangle_normal: bool = False,
        seed: int = 0,
    ) -> PointCloud:
        """Points spread evenly over the surface: none is much closer to the next than the others are.

        Of `init_factor` times as many random points, those are removed one after the other that have the most and the
        nearest others about them. Open3D does the same; which points come back differs with the random ones.

        Args:
            number_of_points: How many come back, exactly.
            init_factor: Random points to begin with, for each one that comes back; 1 removes none.
            pcl: Points to choose from instead; they come back with all their attributes.
            use_triangle_normal: Give random points the normals of their triangles.
            seed: Chooses the random points, 0..2^31 - 1.

        Returns:
            The points, in the order in which they were drawn (or stand in `pcl`), as of `sample_points_uniformly`.

        Raises:
            ValueError: A count below 1, no triangles, none with an area, one with a corner that is not finite, fewer
                finite points in `pcl` than wanted, more than 2^24 to begin with, or more than 2^30 pairs of neighbors
                among them.
            TypeError: No whole numbers, or a `pcl` that is no PointCloud.
            MemoryError: The device has no room for the points or their neighbours.

        Notes:
            About 350 B of memory for each point to begin with where init_factor is 5, 260 of them for its neighbours,
            whose number grows in proportion to it. The same points on every device. Yuksel 2015, with its alpha 8, beta
            0.65 and gamma 1.5.

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
            name, advice = "number_of_points, init_factor", "take fewer"
            if count * factor > MOST_SAMPLES:
                raise ValueError(
                    f"{name}: expected up to {MOST_SAMPLES:,} points to begin with, got {count * factor:,}; {advice}"
                )
            start = self._draw(surface, count * factor, use_triangle_normal, seed)
        else:
            check_cloud("pcl", pcl)
            name, advice = "pcl", "thin it first, as by pcl.random_down_sample"
            start = pcl.to(self.device)
            if len(start) > MOST_SAMPLES:
                raise ValueError(f"{name}: expected up to {MOST_SAMPLES:,} points, got {len(start):,}; {advice}")
        return _spread(start, count, surface.area, name, advice)

    def _surface(self, operation: str) -> SurfaceSamples:
        """The surface to draw from."""
        surface = SurfaceSamples(self._arrays["vertices"], self._arrays["triangles"])
        self._check_surface(surface, operation)
        return surface

    def _check_surface(self, surface: SurfaceSamples, operation: str) -> None:
        """Refuse a surface that there is nothing to draw from."""
        if not len(self):
            raise ValueError(f"{operation}: the mesh has no triangles, so it has no surface to draw points from")
        check_finite_corners(operation, self)
        if not surface.area > 0:
            raise ValueError(
                f"{operation}: none of the mesh's {len(self)} triangles has an area; each has two corners at one "
                "place, or all three on a line"
            )

    def _draw(self, surface: SurfaceSamples, count: int, use_triangle_normal: bool, seed: int) -> PointCloud:
        check_room(self._device, count * SAMPLE_BYTES, f"number_of_points: {count:,} points with what they are made of")
        surface.draw(count, seed)
        arrays: dict[str, Any] = {"points": surface.mix(self._arrays["vertices"])}
        if use_triangle_normal:
            arrays["normals"] = surface.triangle_normals()
        elif "vertex_normals" in self._arrays:
            arrays["normals"] = surface.mix(self._arrays["vertex_normals"], unit=True)
        if "vertex_colors" in self._arrays:
            arrays["colors"] = surface.mix(self._arrays["vertex_colors"])
        cloud = PointCloud._from_device_arrays(arrays, self._origin.copy(), self._library)
        cloud.unit = self._unit
        return cloud

    def compute_metrics(
        self,
        mesh2: TriangleMesh,
        fscore_radius: Sequence[float] = (0.01,),
        n_sampled_points: int = 100_000,
        *,
        seed: int = 0,
    ) -> SurfaceMetrics:
        """Compare two surfaces: Chamfer distance, Hausdorff distance, F-scores, mean and RMS, in both directions.

        Distances are those of points to triangles, exact. Means and F-scores are taken over points drawn from either
        surface; the Hausdorff distance over all of it, by bounds that close in on each other, where Open3D takes the
        largest of the samples' distances.

        Args:
            mesh2: The other mesh, on the same device.
            fscore_radius: Radii of the F-scores [m], the boundary excluded.
            n_sampled_points: Points drawn from each surface.
            seed: Chooses them, 0..2^31 - 1.

        Returns:
            The SurfaceMetrics. `hausdorff` and `hausdorff_bound` are at most 1e-5 of the meshes' size apart; more only
            where that would take over four million pieces of the surface.

        Raises:
            TypeError: No mesh, or no numbers.
            ValueError: A mesh without area or with a triangle that has a corner which is not finite, meshes 1.8e19 m
                apart, a radius that is not positive, a count below 1.
            DeviceError: The meshes are on different devices.

        Notes:
            24 B of memory a sample, 60 B a triangle, and as much for the pieces of triangles that are looked at again.
            Same bits from run to run. Tang, Lee and Kim, SIGGRAPH 2009; F-score: Knapitsch et al., SIGGRAPH 2017.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> above = loom.TriangleMesh([[0, 0, 2], [1, 0, 2], [0, 1, 2]], [[0, 1, 2]])
            >>> found = floor.compute_metrics(above, fscore_radius=[1, 3], n_sampled_points=1000)
            >>> found.chamfer, found.hausdorff, found.fscore.tolist()
            (4.0, 2.0, [0.0, 100.0])
        """
        check_mesh("mesh2", mesh2)
        check_same_device("mesh2", self._device, mesh2.device)
        common_unit("mesh, mesh2", (self.unit, mesh2.unit))
        given = check_numeric("fscore_radius", fscore_radius).reshape(-1).tolist()
        radii = [check_positive("fscore_radius", radius) for radius in given]
        count, seed = check_count("n_sampled_points", n_sampled_points), check_seed(seed)
        there, back = measure_both_ways(self, mesh2, radii, count, seed)
        both = there.within + back.within
        fscore = np.divide(2 * there.within * back.within, both, out=np.zeros_like(both), where=both > 0)
        return SurfaceMetrics(
            there.mean + back.mean,
            max(there.least, back.least),
            fscore,
            max(there.most, back.most),
            (there.mean, back.mean),
            (there.rms, back.rms),
            (there.least, back.least),
        )

    @returns_new
    def compute_error_map(
        self, mesh2: TriangleMesh, max_distance: float | None = None
    ) -> tuple[Self, NDArray[np.float32]]:
        """Colour the vertices by their distances from another mesh.

        Args:
            mesh2: The other mesh, on the same device.
            max_distance: The distance [m] of the last colour, and beyond; None takes the largest.

        Returns:
            (mesh, distances): the mesh with `vertex_colors` from dark blue at 0 over green to yellow, grey where a
            vertex is not finite or there is nothing to measure to; and the distances [m], float32 [m], NaN or infinite
            there.

        Raises:
            TypeError: No mesh, or no number.
            ValueError: A distance that is not positive, or a triangle of `mesh2` has a corner that is not finite.
            DeviceError: The meshes are on different devices.

        Notes:
            Exact distances of points to triangles; 40 B of memory a vertex. Same bits from run to run.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> slope = loom.TriangleMesh([[0, 0, 0], [1, 0, 1], [0, 1, 3]], [[0, 1, 2]])
            >>> colored, distances = slope.compute_error_map(floor)
            >>> distances.tolist(), colored.vertex_colors[2].round(2).tolist()
            ([0.0, 1.0, 3.0], [0.9900000095367432, 0.9100000262260437, 0.14000000059604645])
        """
        check_mesh("mesh2", mesh2)
        check_same_device("mesh2", self._device, mesh2.device)
        common_unit("mesh, mesh2", (self.unit, mesh2.unit))
        check_finite_corners("compute_error_map: mesh2", mesh2)
        largest = None if max_distance is None else check_positive("max_distance", max_distance)
        points = points_about(self._arrays["vertices"], self._origin, mesh2.origin)
        tree = TriangleTree(mesh2._device_arrays["vertices"], mesh2._device_arrays["triangles"])
        distances = distances_to(points, tree)
        if largest is None:
            largest = float(np.float32(summarize_distances(distances, [])[2]))  # sync
        colored = self._with_arrays(vertex_colors=color_distances(distances, largest))
        return colored, self._handed_out(distances, dtype=np.float32)

    def compute_vertex_curvature(self) -> MeshCurvature:
        """The mean, Gaussian and principal curvatures of the surface at each vertex.

        Returns:
            A `MeshCurvature`. All four are NaN at vertices that the triangles do not close a ring around (at the rim,
            at edges of three triangles or more, without triangles), where two neighbouring triangles there turn
            different ways, and next to a triangle without area or a vertex that is not finite. Seams, where borders lie
            on each other as texture leaves them, are no rim.

        Notes:
            O(m + t) memory. Sums run in float64 by ascending triangle: the same bits from run to run and on every
            device. Noise of the positions is blown up by one over the square of the edges: smooth first. Meyer et al.,
            "Discrete differential-geometry operators for triangulated 2-manifolds", VisMath 2003, equations 8 to 11.

        Example:
            >>> import pointloom as loom
            >>> corners = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
            >>> faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
            >>> curvature = loom.TriangleMesh(corners, faces).compute_vertex_curvature()
            >>> curvature.gaussian.round(3).tolist()
            [1.814, 1.814, 1.814, 1.814, 1.814, 1.814]
        """
        sewn = sew(self)
        found = measure_curvatures(sewn.mesh._device_arrays["vertices"], sewn.mesh._device_arrays["triangles"])
        columns: Any = view_as(found, float64, (found.size, 4))
        columns = [contiguous(columns[:, k]) if found.size else empty(0, float64, self.device) for k in range(4)]
        parts = [sewn.spread(column) for column in columns]
        return MeshCurvature(*map(self._handed_out, parts))

    def compute_geodesic_distances(self, sources: Any) -> NDArray[np.float64]:
        """How far each vertex is from the nearest of some vertices, along the surface.

        Args:
            sources: Numbers of vertices, at least one; repeats do no harm.

        Returns:
            Distances [m], float64 [m]; 0 at the sources, infinite where no triangles lead there, so at vertices that
            are not finite. The way leads across seams, where borders lie on each other as texture leaves them.

        Raises:
            ValueError: No source, one that does not exist or is not finite.
            TypeError: No whole numbers.

        Notes:
            Exact on flat parts that are seen from the source. On a curved surface the error falls with the length
            of the edges: on a sphere of 10,242 vertices it is below 0.7 % of the distance, and where fronts from two
            sides meet it may reach half the length of an edge. O(m + t) memory; some rounds more than there are edges
            on the longest way, each over the vertices that the front passes. Same bits from run to run and on
            every device. Novotni and Klein, "Computing geodesic distances on triangular meshes", WSCG 2002.

        Example:
            >>> import pointloom as loom
            >>> square = loom.TriangleMesh([[0, 0, 0], [3, 0, 0], [0, 4, 0], [3, 4, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> square.compute_geodesic_distances([0]).tolist()
            [0.0, 3.0, 4.0, 5.0]
        """
        vertices = self._arrays["vertices"]
        numbers = check_vertices("sources", sources, vertices.size)
        rows = upload(numbers, int32, self._device)
        check_finite_vertices("sources", numbers, gather_rows(vertices, rows))
        sewn = sew(self)
        arrays, own = sewn.mesh._device_arrays, rows if sewn.places is None else gather_rows(sewn.places, rows)
        return self._handed_out(sewn.spread(geodesic_distances(arrays["vertices"], arrays["triangles"], own)))

    def voxelize(
        self,
        voxel_size: float,
        min_bound: ArrayLike | None = None,
        max_bound: ArrayLike | None = None,
        *,
        solid: bool = False,
    ) -> VoxelGrid:
        """The voxels of a regular grid that the surface touches, and on demand those that it encloses.

        As Open3D's `VoxelGrid.create_from_triangle_mesh` and `..._within_bounds`: the grid begins half a voxel below
        the lowest coordinates, or at `min_bound`, and has as many voxels as `max_bound` (half a voxel above the highest
        coordinates) is away in voxels, rounded.

        Args:
            voxel_size: Edge of a voxel [m].
            min_bound: The lowest corner of the grid [m], shape [3].
            max_bound: Its highest corner [m].
            solid: Also the voxels whose centres the surface encloses, by parity: of two surfaces, one in the other,
                what lies between. The mesh has to be closed; which way its triangles turn does not matter.

        Returns:
            The grid with its occupied voxels, all of them within the bounds (Open3D's may lie outside). A voxel that a
            triangle but touches from outside, to a billionth of a voxel, is occupied (in Open3D sometimes). Triangles
            with a corner that is not finite touch none.

        Raises:
            ValueError: A size or bounds that are no finite numbers or enclose nothing, 2^30 voxels along an axis, more
                than 2^31 - 1 of them to look at; for `solid` also an edge that does not belong to exactly two triangles
                or a vertex that is not finite.
            TypeError: No numbers.
            MemoryError: The device has no room for the voxels; refused before they are allocated.

        Notes:
            8 B of memory a column of voxels over each triangle, about 50 B a voxel of each triangle, 50 B a voxel
            inside. Same voxels from run to run and on every device. Akenine-Moller 2001.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box(4, 4, 4)
            >>> len(box.voxelize(1)), len(box.voxelize(1, solid=True))
            (98, 125)
        """
        size = check_positive("voxel_size", voxel_size, maximum=LONGEST)
        extremes, findings = self._examined(solid)  # sync
        low, high = self._bounds_of_voxels(box_of(extremes), size, min_bound, max_bound)
        with np.errstate(over="ignore"):
            reach = np.floor((high - low) / size + 0.5)
        if not (reach < MOST_CELLS).all():
            raise ValueError(
                "voxel_size, min_bound, max_bound: expected less than 2^30 voxels along an axis, got "
                f"{reach.max():g}; take larger voxels"
            )
        counts = (int(reach[0]), int(reach[1]), int(reach[2]))
        if math.prod(counts) >= MOST_KEYS:
            raise ValueError(
                f"voxel_size: a grid of {' x '.join(map(str, counts))} has more than 2^62 voxels; take larger voxels"
            )
        if solid:
            self._check_closed(topology_of(findings), box_of(extremes)[2])
        cells = np.empty((0, 3), np.int32)
        if min(counts) > 0 and len(self):
            vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
            frame = VoxelFrame(low, size, counts)
            columns = [touched_columns(vertices, triangles, frame)]
            if solid:
                columns.append(crossed_columns(vertices, triangles, frame))
            settle(columns)  # sync
            keys = touched_voxels(columns[0])
            if solid:
                keys = concatenate_rows([keys, inner_voxels(columns[1], frame)])  # sync
            cells = download(voxels_of(keys, frame)).reshape(-1, 3).astype(np.int32)
        return VoxelGrid(low + self._origin, size, counts, cells)

    def _examined(self, solid: bool) -> list[NDArray[Any]]:
        """What the box of the vertices is told from, and the topology, which only solids ask for; one sync."""
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
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
        """The corners of the grid, relative to the mesh's origin."""
        low, high, count = box
        at_low = low.astype(np.float64) - size * 0.5 if count else -np.full(3, size * 0.5)
        at_high = high.astype(np.float64) + size * 0.5 if count else np.full(3, size * 0.5)
        if min_bound is not None:
            at_low = _check_corner("min_bound", min_bound) - self._origin
        if max_bound is not None:
            at_high = _check_corner("max_bound", max_bound) - self._origin
        if not (at_low <= at_high).all():
            shown = f"{(at_low + self._origin).tolist()} and {(at_high + self._origin).tolist()}"
            raise ValueError(f"min_bound, max_bound: expected the lower corner first, got {shown}")
        return at_low, at_high

    def _check_closed(self, topology: Topology, finite_count: int) -> None:
        if not len(self) or topology.has_boundary or topology.has_crowded_edge:
            raise ValueError(
                "voxelize: solid wants a closed mesh, with two triangles at every edge; merge vertices at one place, "
                "or fill its holes first"
            )
        if finite_count < self._arrays["vertices"].size:
            raise ValueError("voxelize: solid wants finite vertices, and some are not")


def is_closed(topology: Topology) -> bool:
    """Whether each edge has two triangles."""
    return not (topology.has_boundary or topology.has_crowded_edge)


def _spread(start: PointCloud, count: int, area: float, name: str, advice: str) -> PointCloud:
    """`count` of the points that spread evenly over an area; `name` is the argument that says where they come from."""
    tree = start.search_tree()
    if tree.count < count:
        raise ValueError(f"{name}: expected at least number_of_points = {count} finite points, got {tree.count}")
    if tree.count == count:
        return start.remove_non_finite_points()
    widest = 2 * math.sqrt(area / count / (2 * math.sqrt(3)))  # where discs of half of it fill the plane
    try:
        return start._select_rows(eliminate_samples(tree, count, widest))
    except CrowdedError as error:
        raise ValueError(
            f"{name}: {error.pair_count:,} pairs of points lie closer than {widest:.3g} m, expected up to 2^30; "
            f"{advice}"
        ) from error


def _check_corner(name: str, values: ArrayLike) -> NDArray[np.float64]:
    corner = check_finite(name, check_shape(name, values, (3,)))
    if np.abs(corner).max() > LONGEST:
        raise ValueError(f"{name}: expected coordinates up to {LONGEST:g} m, got {corner.tolist()}")
    return corner
