"""TriangleMesh: shared vertices and triangles on one device, and how meshes are made.

Its other methods are inherited: those that return values from mesh_queries.py, parts from mesh_parts.py, changed meshes
from mesh_changes.py. Its arrays are in mesh_arrays.py. Each method is a signature, a docstring and a call of a function
in the module of its topic, which contains the code. One class would have 2,300 lines, most of them docstrings.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Literal, Self, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import NUMPY, library_for, library_of
from ...core.checks import check_rows, check_shape, is_on_gpu, shown
from ...core.coordinate_systems import is_in_degrees
from ...core.coordinates import choose_origin, split_origin, warn_if_coarse
from ...core.devices import DeviceLike, resolve_device
from ...core.gpu_arrays import take_corners, take_points
from ...io.table import MeshTable
from ...kernels.lang import vec3, vec3i
from ...kernels.memory import upload
from ...pcd.cloud import PointCloud
from ...pcd.extent_text import reference_text
from . import conversion, primitives, reconstruction, sweeps
from .conversion import mesh_arguments
from .mesh_changes import MeshChanges
from .mesh_parts import MeshParts
from .mesh_queries import MeshQueries
from .mesh_store import MeshStore, assign_all, listed


class TriangleMesh(MeshQueries, MeshParts, MeshChanges):
    """A triangle mesh with optional vertex normals and colors, texture coordinates, textures and other attributes.

    float32 (int32 triangles) on one device, relative to a float64 `origin`. Operations return new meshes that share
    unchanged arrays, and arrays of the vertices' library (docs/arrays.md). `len(mesh)` counts triangles.

    Args:
        vertices: Positions [m], shape (m, 3). Or a mesh of trimesh, Open3D, PyVista, VTK or meshio, see `from_any`.
        triangles: Vertex indices, shape (t, 3), counterclockwise from outside.
        vertex_normals, vertex_colors: Shape (m, 3). Colors in 0..1.
        triangle_uvs: Texture coordinates of corners, shape (3 t, 2).
        triangle_material_ids: Texture index of each triangle, shape (t,).
        textures: Images, uint8 (height, width, 3 or 4).
        vertex_attributes, triangle_attributes: Other values by name, any number type, one row per vertex or triangle.
        device: "cpu", "cuda:N" or "auto". If None: the vertices' GPU, or the CPU.
        origin: Stored origin (3,). If None: zero, or near the median of vertices that are far from zero.
        arrays: Library of returned arrays: "numpy", "warp", "torch", "cupy" or "jax". If None: that of the vertices.

    Raises:
        TypeError: If an array is not numeric, or triangles are not integers.
        ValueError, DeviceError: If a shape or index is invalid, or if the device does not exist.
        ImportError: If the library of `arrays` is not installed.

    Example:
        >>> mesh = TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> mesh.get_surface_area()
        1.0
        >>> mesh.compute_vertex_normals().vertex_normals[0].tolist()
        [0.0, 0.0, 1.0]
    """

    @explain_argument_errors
    def __init__(
        self,
        vertices: ArrayLike = (),
        triangles: Any = (),
        *,
        vertex_normals: ArrayLike | None = None,
        vertex_colors: ArrayLike | None = None,
        triangle_uvs: ArrayLike | None = None,
        triangle_material_ids: ArrayLike | None = None,
        textures: Any = (),
        vertex_attributes: Mapping[str, Any] | None = None,
        triangle_attributes: Mapping[str, Any] | None = None,
        device: DeviceLike = None,
        origin: ArrayLike | None = None,
        arrays: str | None = None,
    ):
        _refuse_path(vertices)
        if given := mesh_arguments("vertices", vertices):
            own = {"vertex_normals": vertex_normals, "vertex_colors": vertex_colors, "triangle_uvs": triangle_uvs}
            own |= {"triangle_material_ids": triangle_material_ids, "vertex_attributes": vertex_attributes}
            own |= {"triangle_attributes": triangle_attributes, "device": device}
            unit, crs = given.pop("reference")
            given |= {name: values for name, values in own.items() if values is not None}
            if origin is None and is_in_degrees(unit, crs):
                origin = choose_origin(check_rows("vertices", given["vertices"], 3), in_degrees=True)
            vars(self).update(vars(TriangleMesh(**given, origin=origin, arrays=arrays)))
            self.unit, self.crs = unit, crs
            return
        library = library_for(arrays, vertices)
        anchor = None if origin is None else check_shape("origin", origin, (3,))
        if is_on_gpu(vertices):
            local, start = take_points("vertices", vertices, anchor)
            corners = take_corners(triangles, local.device, local.size)
        else:
            positions = check_rows("vertices", vertices, 3)
            if len(positions) >= 2**31:
                raise ValueError(f"vertices: {len(positions)} vertices exceed the range of 32-bit triangle indices")
            table = MeshTable(positions, triangles).checked()
            rows, start = split_origin(table.vertices, anchor)
            if anchor is None:
                warn_if_coarse("vertices", positions, start)
            where, is_copied = resolve_device(device), library_of(vertices) == NUMPY
            local = upload(rows, vec3, where, copied=is_copied)
            corners = upload(table.triangles, vec3i, where, copied=is_copied)
        vars(self)["arrays"] = MeshStore({"vertices": local, "triangles": corners}, start, library)
        for name, values in (("vertex_normals", vertex_normals), ("vertex_colors", vertex_colors)):
            if values is not None:
                self._assign(name, values)
        assign_all(self.vertex_attributes, vertex_attributes)
        assign_all(self.triangle_attributes, triangle_attributes)
        if triangle_uvs is not None:
            self.triangle_uvs = triangle_uvs
        if triangle_material_ids is not None:
            self.triangle_material_ids = triangle_material_ids
        self.textures = textures
        if device is not None and resolve_device(device) != self.device:  # arrays were on a GPU
            vars(self)["arrays"] = self.to(resolve_device(device)).arrays

    def __repr__(self) -> str:
        parts = [f"{self.arrays['vertices'].size} vertices", f"{len(self)} triangles"]
        parts += [name for name in self.arrays if name not in ("vertices", "triangles")]
        parts += [f"{kind}[{listed(columns)}]" for kind, columns in self.arrays.attributes.items() if columns]
        if self.unit is not None or self.crs is not None:  # bounds wait for the device
            parts.append(reference_text(self, self.get_min_bound(), self.get_max_bound()))
        return f"{type(self).__name__}({', '.join([*parts, str(self.device)])})"

    @classmethod
    @explain_argument_errors
    def create_from_point_cloud_poisson(
        cls,
        cloud: PointCloud,
        depth: int = 8,
        width: float = 0,
        scale: float = 1.1,
        linear_fit: bool = False,
        *,
        point_weight: float = 2.0,
        samples_per_node: float = 1.5,
        confidence: bool = False,
        envelope: TriangleMesh | None = None,
    ) -> tuple[Self, NDArray[np.float32]]:
        """Reconstruct a closed surface from points with consistently oriented normals (screened Poisson).

        The surface also closes over regions without points: cut them by density,
        `mesh.remove_vertices_by_mask(densities < np.quantile(densities, 0.01))`. It is open only at the cube around the
        cloud. A NormalsWarning is issued if more than 10% of neighboring normals disagree
        (`cloud.normal_disagreement()`). Orient them with `cloud.orient_normals_consistent_tangent_plane(30)`. Bitwise
        reproducible for any number of threads. About 0.8 kB per block of eight cells. Kazhdan and Hoppe, "Screened
        Poisson surface reconstruction", ACM TOG 2013.

        Args:
            cloud: With normals. Points that are not finite and normals that are zero or NaN are ignored.
            depth: Maximum octree level, 2..20 (2^depth cells along the cube). Lower where points are sparse.
            width: Width of the finest cells [m]. If positive, it replaces `depth`.
            scale: Edge of the cube relative to the longest edge of the cloud's box, 1 to 2^(depth - 1).
            linear_fit: Interpolate vertices linearly. Otherwise by a parabola, which halves the error.
            point_weight: Weight of the points, up to 1000. 0 uses only normals, larger values fit noise.
            samples_per_node: Points in the finest cells, at least 0.001: 1.5 for clean points, up to 20 for noise.
            confidence: Weight points by the lengths of their normals relative to the mean.
            envelope: Closed mesh on the cloud's device that bounds the surface, with some cells of clearance to the
                points. Up to 10,000 triangles.

        Returns:
            (mesh, densities). The mesh is edge-manifold, closed except at the cube, with unit normals and colors of the
            nearest points. `densities`, float32 (m,), are the depths of cells with `samples_per_node` points.

        Raises:
            TypeError, ValueError: If `cloud` is not a PointCloud, or if the cloud has no normals or fewer than two
                positions with one, an argument is out of range, or `samples_per_node` exceeds the number of points.
            MemoryError: If the tree does not fit. Checked before allocation.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.random.default_rng(0).normal(size=(2000, 3))
            >>> points /= np.linalg.norm(points, axis=1, keepdims=True)
            >>> cloud = loom.PointCloud(points, normals=points)
            >>> ball, densities = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5)
            >>> ball.is_watertight(), bool(abs(np.linalg.norm(ball.vertices, axis=1) - 1).max() < 0.02)
            (True, True)
        """
        return reconstruction.create_from_point_cloud_poisson(
            cls,
            cloud,
            depth,
            width,
            scale,
            linear_fit,
            point_weight=point_weight,
            samples_per_node=samples_per_node,
            confidence=confidence,
            envelope=envelope,
        )

    @classmethod
    @explain_argument_errors
    def create_from_point_cloud_ball_pivoting(cls, cloud: PointCloud, radii: ArrayLike | None = None) -> Self:
        """Reconstruct a mesh by ball pivoting: triangles on which an empty ball can rest.

        All empty-ball triangles that agree with the normals are found at once. Of those that compete for an edge, the
        one with the smallest circumcircle is kept. Later radii may be smaller and extend edges with one triangle and
        unused points. Points without a finite position and normal are ignored. Bitwise identical on every device. About
        1 kB per point. Bernardini et al., "The ball-pivoting algorithm for surface reconstruction", TVCG 1999.

        Args:
            cloud: A PointCloud with outward normals.
            radii: Radii in order of use [m]. If None: 1.5 times the median nearest neighbor distance, doubled until
                there are three radii and 98% of the points have a neighbor within the last one, up to six.

        Returns:
            The mesh with all points, normals and colors, and consistently oriented triangles, counterclockwise from the
            normals' side. Edges have at most two triangles. Holes remain where no ball fits.

        Raises:
            TypeError: If `cloud` is not a PointCloud, or a radius is not a number.
            ValueError: If the cloud has no normals, a radius is missing, not positive or 10,000 times the cloud's box,
                or the search would take hours. The message contains the estimate.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> rng = np.random.default_rng(0)
            >>> ball = rng.normal(size=(2000, 3))
            >>> ball /= np.linalg.norm(ball, axis=1, keepdims=True)
            >>> cloud = loom.PointCloud(ball, normals=ball)
            >>> mesh = loom.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, [0.1, 0.2])
            >>> mesh.is_edge_manifold(), len(mesh) > 3900
            (True, True)
        """
        return reconstruction.create_from_point_cloud_ball_pivoting(cls, cloud, radii)

    @overload
    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: float | str = ..., *, return_tetrahedra: Literal[False] = ...
    ) -> Self: ...

    @overload
    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: float | str = ..., *, return_tetrahedra: Literal[True]
    ) -> tuple[Self, NDArray[np.int32], NDArray[np.int32]]: ...

    @overload
    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: Sequence[float] | NDArray[Any], *, return_tetrahedra: Literal[False] = ...
    ) -> list[Self]: ...

    @overload
    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: Sequence[float] | NDArray[Any], *, return_tetrahedra: Literal[True]
    ) -> list[tuple[Self, NDArray[np.int32], NDArray[np.int32]]]: ...

    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, cloud: PointCloud, alpha: float | ArrayLike | None = "auto", *, return_tetrahedra: bool = False
    ) -> Any:
        """Alpha shape: boundary of the Delaunay tetrahedra with circumradius at most alpha.

        Dense regions are solid. Hollows wider than 2 alpha stay open. The surface is closed, with an even number of
        triangles per edge. It is empty if no tetrahedron is kept. Exact for the stored float32 coordinates. Cospherical
        points are resolved by index order. Bitwise identical on every device. About 300 B per point and up to 500 MB of
        scratch memory. An alpha of the cloud's size is slow if many points are on its hull. Edelsbrunner and Mücke,
        "Three-dimensional alpha shapes", TOG 1994, regularized.

        Args:
            cloud: The points; duplicates and points that are not finite are ignored.
            alpha: Maximum circumradius [m]; infinity gives the convex hull. "auto" takes 10 times the median nearest
                neighbor distance. A list gives one shape each, at little more than the cost of the largest.
            return_tetrahedra: Also return the kept tetrahedra and the point map.

        Returns:
            The mesh or a list of meshes. Vertices are the used points in order, with normals and colors. Triangles are
            counterclockwise seen from outside. With `return_tetrahedra`: (mesh, tetrahedra, point_map), int32 (k, 4)
            rows of the cloud with det(b - a, c - a, d - a) > 0, and int32 (m,) the row of each vertex.

        Raises:
            TypeError: If `cloud` is not a PointCloud, or an alpha is not a number.
            ValueError: If an alpha is not positive, there is none, or there are more than 1,000.

        Warns:
            UserWarning: If the mesh is empty for any alpha: fewer than four points, or all collinear or coplanar.
            UnitWarning: If the mesh is empty because alpha is far below the point spacing.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> grid = np.stack(np.meshgrid(*[np.arange(8.0)] * 3), -1).reshape(-1, 3)
            >>> mesh = loom.TriangleMesh.create_from_point_cloud_alpha_shape(loom.PointCloud(grid), 0.9)
            >>> len(mesh), mesh.is_watertight(), round(mesh.get_volume(), 3)
            (588, True, 343.0)
        """
        return reconstruction.create_from_point_cloud_alpha_shape(
            cls, cloud, alpha, return_tetrahedra=return_tetrahedra
        )

    @classmethod
    def create_isosurfaces(
        cls, volume: ArrayLike, contour_values: ArrayLike = (0.0,), device: Any = None, *, arrays: str | None = None
    ) -> Self:
        """Extract isosurfaces of a sampled field for one or more values.

        `marching_cubes` does the same for one value, with a sample spacing and another axis order.

        Args:
            volume: Values at grid points (x, y, z), shape (nz, ny, nx), at least 2 along each axis.
            contour_values: Values on the surfaces, as float32.
            device: "cpu" (default), "cuda:N" or "auto". A device array stays on its device.
            arrays: Library of returned arrays, as of `TriangleMesh`. If None: that of the volume.

        Returns:
            The mesh in units of samples. Triangles are counterclockwise seen from lower values.

        Raises:
            ValueError, TypeError, DeviceError: As `marching_cubes`.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> z, y, x = np.mgrid[:9, :9, :9] - 4.0
            >>> ball = loom.TriangleMesh.create_isosurfaces(3 - np.sqrt(x**2 + y**2 + z**2))
            >>> ball.is_watertight(), ball.get_center().round(3).tolist()
            (True, [4.0, 4.0, 4.0])
        """
        return reconstruction.create_isosurfaces(cls, volume, contour_values, device, arrays=arrays)

    @classmethod
    def create_box(
        cls,
        width: float = 1.0,
        height: float = 1.0,
        depth: float = 1.0,
        create_uv_map: bool = False,
        map_texture_to_each_face: bool = False,
        *,
        device: DeviceLike = None,
    ) -> Self:
        """Create a box with one corner at the origin: 8 vertices, 12 triangles.

        Args:
            width, height, depth: Size along x, y and z [m].
            create_uv_map: Add texture coordinates: the box unfolded in the image.
            map_texture_to_each_face: Map the complete image to each face instead.
            device: "cpu" (default), "cuda:N" or "auto".

        Raises:
            ValueError, TypeError: If a length is not positive, or if a length is not a number.
            DeviceError: If the device does not exist.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box(2, 3, 4).get_volume()
            24.0
        """
        return primitives.create_box(cls, width, height, depth, create_uv_map, map_texture_to_each_face, device=device)

    @classmethod
    def create_plane(
        cls, width: float = 1.0, height: float = 1.0, create_uv_map: bool = False, *, device: DeviceLike = None
    ) -> Self:
        """Create a rectangle in the plane z = 0, facing up, with one corner at the origin: 4 vertices, 2 triangles.

        Args:
            width, height: Size along x and y [m].
            create_uv_map: Add texture coordinates: the complete image.
            device: As of `create_box`, including errors.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_plane(2, 3).get_surface_area()
            6.0
        """
        return primitives.create_plane(cls, width, height, create_uv_map, device=device)

    @classmethod
    def create_tetrahedron(cls, radius: float = 1.0, create_uv_map: bool = False, *, device: DeviceLike = None) -> Self:
        """Create a tetrahedron about the origin: 4 vertices, 4 triangles.

        Args:
            radius: Distance of the corners from the origin [m].
            create_uv_map, device: As of `create_box`, including errors.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_tetrahedron()
            TriangleMesh(4 vertices, 4 triangles, cpu)
        """
        return primitives.create_tetrahedron(cls, radius, create_uv_map, device=device)

    @classmethod
    def create_octahedron(cls, radius: float = 1.0, create_uv_map: bool = False, *, device: DeviceLike = None) -> Self:
        """Create an octahedron about the origin: 6 vertices, 8 triangles.

        Args:
            radius: Distance of the corners from the origin [m].
            create_uv_map, device: As of `create_box`, including errors.

        Example:
            >>> import pointloom as loom
            >>> round(loom.TriangleMesh.create_octahedron(3).get_volume(), 3)
            36.0
        """
        return primitives.create_octahedron(cls, radius, create_uv_map, device=device)

    @classmethod
    def create_icosahedron(cls, radius: float = 1.0, create_uv_map: bool = False, *, device: DeviceLike = None) -> Self:
        """Create an icosahedron about the origin: 12 vertices, 20 triangles.

        Args:
            radius: Half an edge [m], as in Open3D. The corners are 1.902 times as far from the origin.
            create_uv_map, device: As of `create_box`, including errors.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_icosahedron()
            TriangleMesh(12 vertices, 20 triangles, cpu)
        """
        return primitives.create_icosahedron(cls, radius, create_uv_map, device=device)

    @classmethod
    def create_sphere(
        cls, radius: float = 1.0, resolution: int = 20, create_uv_map: bool = False, *, device: DeviceLike = None
    ) -> Self:
        """Create a UV sphere about the origin.

        Args:
            radius: [m].
            resolution: Steps from pole to pole, at least 2. Twice as many around.
            create_uv_map: Add texture coordinates: u from pole to pole, v around.
            device: As of `create_box`.

        Raises:
            ValueError, TypeError, DeviceError: As `create_box`. ValueError also for more than 2^22 vertices.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_sphere(resolution=10)
            TriangleMesh(182 vertices, 360 triangles, cpu)
        """
        return primitives.create_sphere(cls, radius, resolution, create_uv_map, device=device)

    @classmethod
    def create_ellipsoid(
        cls,
        radius_x: float = 1.0,
        radius_y: float = 1.0,
        radius_z: float = 1.0,
        resolution: int = 20,
        create_uv_map: bool = False,
        *,
        device: DeviceLike = None,
    ) -> Self:
        """Create an ellipsoid about the origin from `create_sphere`.

        Args:
            radius_x, radius_y, radius_z: Radii along the axes [m].
            resolution: Steps from pole to pole, at least 2.
            create_uv_map, device: As of `create_sphere`, including errors.

        Example:
            >>> import pointloom as loom
            >>> low, high = loom.TriangleMesh.create_ellipsoid(1, 2, 3).get_axis_aligned_bounding_box()
            >>> high.tolist()
            [1.0, 2.0, 3.0]
        """
        return primitives.create_ellipsoid(cls, radius_x, radius_y, radius_z, resolution, create_uv_map, device=device)

    @classmethod
    def create_cylinder(
        cls,
        radius: float = 1.0,
        height: float = 2.0,
        resolution: int = 20,
        split: int = 4,
        create_uv_map: bool = False,
        *,
        device: DeviceLike = None,
    ) -> Self:
        """Create a closed cylinder along z, centered at the origin.

        Args:
            radius, height: [m].
            resolution: Corners of a ring, at least 3.
            split: Segments along z.
            create_uv_map, device: As of `create_box`. Errors as `create_sphere`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_cylinder(split=1).is_watertight()
            True
        """
        return primitives.create_cylinder(cls, radius, height, resolution, split, create_uv_map, device=device)

    @classmethod
    def create_cone(
        cls,
        radius: float = 1.0,
        height: float = 2.0,
        resolution: int = 20,
        split: int = 1,
        create_uv_map: bool = False,
        *,
        device: DeviceLike = None,
    ) -> Self:
        """Create a closed cone along z, with its base centered at the origin.

        Args:
            radius, height: Radius of the base and height [m].
            resolution: Corners of a ring, at least 3.
            split: Segments along z.
            create_uv_map, device: As of `create_box`. Errors as `create_sphere`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_cone(resolution=8)
            TriangleMesh(10 vertices, 16 triangles, cpu)
        """
        return primitives.create_cone(cls, radius, height, resolution, split, create_uv_map, device=device)

    @classmethod
    def create_torus(
        cls,
        torus_radius: float = 1.0,
        tube_radius: float = 0.5,
        radial_resolution: int = 30,
        tubular_resolution: int = 20,
        *,
        device: DeviceLike = None,
    ) -> Self:
        """Create a torus about the z axis.

        Args:
            torus_radius: Distance of the tube's center from the origin [m].
            tube_radius: Radius of the tube [m].
            radial_resolution, tubular_resolution: Rings around the hole and corners of a ring, at least 3.
            device: As of `create_box`. Errors as `create_sphere`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_torus()
            TriangleMesh(600 vertices, 1200 triangles, cpu)
        """
        return primitives.create_torus(
            cls, torus_radius, tube_radius, radial_resolution, tubular_resolution, device=device
        )

    @classmethod
    def create_arrow(
        cls,
        cylinder_radius: float = 1.0,
        cone_radius: float = 1.5,
        cylinder_height: float = 5.0,
        cone_height: float = 4.0,
        resolution: int = 20,
        cylinder_split: int = 4,
        cone_split: int = 1,
        *,
        device: DeviceLike = None,
    ) -> Self:
        """Create an arrow from the origin along z: a cylinder with a cone.

        Args:
            cylinder_radius, cone_radius, cylinder_height, cone_height: Dimensions of shaft and head [m].
            resolution: Corners of a ring, at least 3.
            cylinder_split, cone_split: Segments of shaft and head along z.
            device: As of `create_box`. Errors as `create_sphere`.

        Example:
            >>> import pointloom as loom
            >>> low, high = loom.TriangleMesh.create_arrow().get_axis_aligned_bounding_box()
            >>> float(low[2]), float(high[2])
            (0.0, 9.0)
        """
        return primitives.create_arrow(
            cls,
            cylinder_radius,
            cone_radius,
            cylinder_height,
            cone_height,
            resolution,
            cylinder_split,
            cone_split,
            device=device,
        )

    @classmethod
    def create_coordinate_frame(
        cls, size: float = 1.0, origin: ArrayLike = (0.0, 0.0, 0.0), *, device: DeviceLike = None
    ) -> Self:
        """Create arrows along x (red), y (green) and z (blue) with a gray ball at their base.

        Args:
            size: Length of the arrows [m].
            origin: Position of the ball [m], shape (3,).
            device: As of `create_box`, including errors.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_coordinate_frame(0.5, [1, 2, 3])
            TriangleMesh(1134 vertices, 2240 triangles, vertex_normals, vertex_colors, cpu)
        """
        return primitives.create_coordinate_frame(cls, size, origin, device=device)

    @classmethod
    def create_mobius(
        cls,
        length_split: int = 70,
        width_split: int = 15,
        twists: int = 1,
        radius: float = 1,
        flatness: float = 1,
        width: float = 1,
        scale: float = 1,
        *,
        device: DeviceLike = None,
    ) -> Self:
        """Create a Möbius strip about the z axis.

        Args:
            length_split, width_split: Pieces around, at least 3. Vertices across, at least 2.
            twists: Number of half twists, at least 0.
            radius, width: Distance of the center line from the origin, and width [m].
            flatness: Scale along z, not zero.
            scale: Scale of all coordinates.
            device: As of `create_box`. Errors as `create_sphere`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_mobius()
            TriangleMesh(1050 vertices, 1960 triangles, cpu)
        """
        return primitives.create_mobius(
            cls, length_split, width_split, twists, radius, flatness, width, scale, device=device
        )

    @classmethod
    def from_polygon(cls, outline: ArrayLike, holes: Sequence[ArrayLike] = (), *, device: DeviceLike = None) -> Self:
        """Triangulate a flat polygon with holes.

        Args:
            outline: Corners in order [m], shape (k, 2) in the plane z = 0 or (k, 3); optionally closed.
            holes: Outlines of holes.
            device: "cpu" (default), "cuda:N" or "auto".

        Returns:
            All corners in order, with triangles between them only. 2D polygons face up. 3D outlines are
            counterclockwise.

        Raises:
            ValueError: If there are fewer than three corners, numbers that are not finite, corners farther off the
                plane than 1e-6 of the outline's length, or intersecting outlines.
            TypeError, ImportError: If an argument is not numeric, or if manifold3d is not installed.
            DeviceError: If the device does not exist.

        Example:
            >>> import pointloom as loom
            >>> hole = [[1, 1], [2, 1], [2, 2], [1, 2]]
            >>> frame = loom.TriangleMesh.from_polygon([[0, 0], [3, 0], [3, 3], [0, 3]], [hole])
            >>> frame.get_surface_area(), frame.extrude_linear([0, 0, 2]).get_volume()
            (8.0, 16.0)
        """
        return sweeps.from_polygon(cls, outline, holes, device=device)

    @classmethod
    def revolve(
        cls, profile: ArrayLike, angle: float = 360.0, resolution: int = 64, *, device: DeviceLike = None
    ) -> Self:
        """Create a surface of revolution about the z axis.

        Args:
            profile: Points (distance from the axis, height) [m], shape (k, 2). An upward line faces outward.
            angle: [degrees], at most 360 in either direction. The surface is open below 360.
            resolution: Number of steps.
            device: As of `from_polygon`.

        Returns:
            The profile's points step by step, those on the axis once.

        Raises:
            ValueError: If there are fewer than two points, a negative distance, no step, or more than 2^22 vertices.
            TypeError: If an argument is not numeric.

        Example:
            >>> import pointloom as loom
            >>> vase = loom.TriangleMesh.revolve([[0, 0], [1, 0], [0.5, 2], [0, 2]])
            >>> vase.is_watertight(), round(vase.get_volume(), 2)
            (True, 3.66)
        """
        return sweeps.revolve(cls, profile, angle, resolution, device=device)

    @classmethod
    def from_open3d(cls, mesh: object, *, device: DeviceLike = None, arrays: str | None = None) -> Self:
        """Copy an Open3D mesh, legacy (`open3d.geometry`) or tensor (`open3d.t.geometry`), as `TriangleMesh(mesh)`.

        Textures are top row first here. Legacy meshes of Open3D have the lowest row first.

        Args:
            mesh: The Open3D mesh.
            device: Target device. If None: the tensor mesh's GPU, or the CPU.
            arrays: Library of returned arrays, as of `TriangleMesh`. If None: "numpy".

        Raises:
            TypeError: If `mesh` is not an Open3D mesh.
            DeviceError: If the device does not exist.
        """
        return conversion.from_open3d(cls, mesh, device=device, arrays=arrays)


def _refuse_path(vertices: ArrayLike) -> None:
    if isinstance(vertices, str | os.PathLike):
        remedy = "loom.read_triangle_mesh(path) reads a file"
        raise TypeError(f"vertices: expected real numbers, got {shown(vertices)}; {remedy}")
