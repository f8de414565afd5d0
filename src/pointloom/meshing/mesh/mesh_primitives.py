"""Primitives and sweeps: boxes, spheres, cylinders and other shapes, extrusions, polygons, solids of revolution."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import (
    check_count,
    check_direction,
    check_finite,
    check_number,
    check_positive,
    check_rows,
    check_shape,
    shown,
)
from ...core.coordinates import split_origin
from ...core.devices import DeviceLike, resolve_device
from ...core.dropped_results import returns_new
from ...kernels.lang import int32, vec2, vec3, vec3i
from ...kernels.linear_algebra import matmul
from ...kernels.memory import upload
from . import shape_arrays as shapes
from .flat_polygons import fill_loops, loops_to_reverse
from .mesh_measures import MeshMeasures
from .mesh_rows import TEXTURE
from .shape_arrays import Shape
from .sweep_arrays import (
    check_area,
    check_length,
    check_ring,
    flatten_outline,
    number_ring_vertices,
    signed_volume,
    used_vertices,
    wall_triangles,
)

MAX_LENGTH = 1e30  # [m] limit of lengths: float32 with margin for sums
MAX_VERTICES = 2**22  # more than an image can resolve


class MeshPrimitives(MeshMeasures):
    """Methods of TriangleMesh that create primitives and swept shapes.

    Vertices, triangles and texture coordinates of primitives equal Open3D's. Sweeps run in NumPy.
    """

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
        x, y, z = positive_lengths(width=width, height=height, depth=depth)
        return cls._of(shapes.box(x, y, z, bool(map_texture_to_each_face)), device, with_uvs=create_uv_map)

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
        return cls._of(shapes.plane(*positive_lengths(width=width, height=height)), device, with_uvs=create_uv_map)

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
        return cls._of(shapes.tetrahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)

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
        return cls._of(shapes.octahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)

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
        return cls._of(shapes.icosahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)

    @classmethod
    def _of(cls, shape: Shape, device: DeviceLike, *, with_uvs: bool = False) -> Self:
        target = resolve_device(device)
        local, origin = split_origin(shape.vertices)
        made = {
            "vertices": upload(local, vec3, target),
            "triangles": upload(shape.triangles.astype(np.int32), vec3i, target),
            "triangle_uvs": upload(shape.uvs.astype(np.float32), vec2, target) if with_uvs else None,
        }
        return cls.from_device_arrays(made, origin)

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
        (r,) = positive_lengths(radius=radius)
        return cls.create_ellipsoid(r, r, r, resolution, create_uv_map, device=device)

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
        radii = positive_lengths(radius_x=radius_x, radius_y=radius_y, radius_z=radius_z)
        steps = check_count("resolution", resolution, minimum=2)
        check_vertex_count("resolution", 2 * steps * (steps - 1) + 2)
        ball = shapes.sphere(1.0, steps)
        return cls._of(ball._replace(vertices=ball.vertices * radii), device, with_uvs=create_uv_map)

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
        sizes = positive_lengths(radius=radius, height=height)
        counts = checked_counts(resolution=(resolution, 3), split=(split, 1))
        check_vertex_count("resolution, split", counts[0] * (counts[1] + 1) + 2)
        return cls._of(shapes.cylinder(*sizes, *counts), device, with_uvs=create_uv_map)

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
        sizes = positive_lengths(radius=radius, height=height)
        counts = checked_counts(resolution=(resolution, 3), split=(split, 1))
        check_vertex_count("resolution, split", counts[0] * counts[1] + 2)
        return cls._of(shapes.cone(*sizes, *counts), device, with_uvs=create_uv_map)

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
        radii = positive_lengths(torus_radius=torus_radius, tube_radius=tube_radius)
        counts = checked_counts(radial_resolution=(radial_resolution, 3), tubular_resolution=(tubular_resolution, 3))
        check_vertex_count("radial_resolution, tubular_resolution", counts[0] * counts[1])
        return cls._of(shapes.torus(*radii, *counts), device)

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
        sizes = positive_lengths(
            cylinder_radius=cylinder_radius,
            cone_radius=cone_radius,
            cylinder_height=cylinder_height,
            cone_height=cone_height,
        )
        counts = checked_counts(
            resolution=(resolution, 3), cylinder_split=(cylinder_split, 1), cone_split=(cone_split, 1)
        )
        check_vertex_count("resolution, cylinder_split, cone_split", counts[0] * (counts[1] + counts[2] + 1) + 4)
        return cls._of(_arrow(*sizes, *counts), device)

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
        (length,) = positive_lengths(size=size)
        center = check_finite("origin", check_shape("origin", origin, (3,)))
        if np.abs(center).max() > MAX_LENGTH:
            raise ValueError(f"origin: expected coordinates up to {MAX_LENGTH:g} m, got {center.tolist()}")
        along_z = _arrow(0.035 * length, 0.06 * length, 0.8 * length, 0.2 * length, 20, 4, 1)
        x, y, z = along_z.vertices.T
        arrows = [along_z._replace(vertices=np.stack(axes, axis=1)) for axes in ((z, x, y), (y, z, x), (x, y, z))]
        parts = [shapes.sphere(0.06 * length, 20), *arrows]
        colors = [[0.5, 0.5, 0.5], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        mesh = cls._of(shapes.joined(parts), device).compute_vertex_normals()
        mesh.vertex_colors = np.repeat(colors, [len(part.vertices) for part in parts], axis=0)
        local, anchor = split_origin(mesh.vertices + center)
        return mesh.with_arrays(vertices=upload(local, vec3, mesh.device), origin=anchor)

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
        columns, rows, half_twists = checked_counts(
            length_split=(length_split, 3), width_split=(width_split, 2), twists=(twists, 0)
        )
        around, breadth, factor = positive_lengths(radius=radius, width=width, scale=scale)
        flat = check_number("flatness", flatness)
        if flat == 0 or abs(flat) > MAX_LENGTH:
            raise ValueError(f"flatness: expected a number other than 0 up to {MAX_LENGTH:g}, got {flat:g}")
        check_vertex_count("length_split, width_split", columns * rows)
        return cls._of(shapes.mobius(columns, rows, half_twists, around, flat, breadth, factor), device)

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
        shift = check_finite("vector", check_shape("vector", vector, (3,))) * check_length("scale", scale)
        if not shift.any():
            raise ValueError("vector: expected a vector of nonzero length, got zero")
        corners = self.vertices
        return self._swept(np.stack([corners, corners + shift]), False, bool(capping))

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
        direction = check_direction("axis", axis)
        full_angle, rise = np.radians(check_length("angle", angle)), check_length("translation", translation)
        if not full_angle:
            raise ValueError("angle: expected a nonzero angle, got 0")
        steps = check_count("resolution", resolution, minimum=1)
        corners = self.vertices
        check_vertex_count("resolution", (steps + 1) * len(corners))
        fractions = np.linspace(0, 1, steps + 1)[:, None, None]
        along = matmul(corners, direction)[:, None] * direction
        across, side = corners - along, np.cross(direction, corners)
        rings = (
            along
            + np.cos(full_angle * fractions) * across
            + np.sin(full_angle * fractions) * side
            + rise * fractions * direction
        )
        is_closed = not rise and abs(abs(float(angle)) - 360) < 1e-9 and steps > 2
        if not rise:
            radii = np.linalg.norm(across, axis=1)
            rings[:, radii <= 1e-7 * np.abs(corners).max(initial=0)] = corners[
                radii <= 1e-7 * np.abs(corners).max(initial=0)
            ]
        return self._swept(rings, is_closed, bool(capping) and not is_closed)

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
        if (
            not isinstance(holes, Sequence | np.ndarray)
            or isinstance(holes, str | bytes)
            or getattr(holes, "ndim", 1) == 0
        ):
            raise TypeError(f"holes: expected a list of outlines, got {shown(holes)}")
        loops = [check_ring("outline", outline), *(check_ring("holes", hole) for hole in holes)]
        if len({loop.shape[1] for loop in loops}) > 1:
            raise ValueError("holes: expected the same number of coordinates per corner as the outline")
        vertices = np.concatenate(loops)
        flat = flatten_outline(vertices, len(loops[0]))
        parts = np.split(flat, np.cumsum([len(loop) for loop in loops])[:-1])
        is_reversed = loops_to_reverse(parts)
        order = np.split(np.arange(len(flat)), np.cumsum([len(loop) for loop in loops])[:-1])
        order = [rows[::-1] if reverse else rows for rows, reverse in zip(order, is_reversed, strict=True)]
        triangles = np.concatenate(order)[fill_loops("from_polygon", [flat[rows] for rows in order])]
        check_area(flat, order, triangles)
        if vertices.shape[1] == 2:
            vertices = np.c_[vertices, np.zeros(len(vertices))]
        return cls._of(Shape(vertices, triangles, np.zeros((0, 2))), device)

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
        line = check_finite("profile", check_rows("profile", profile, 2, dtype=np.float64))
        if len(line) < 2 or (line[:, 0] < 0).any():
            raise ValueError(f"profile: expected at least two points (radius >= 0, height), got {line.tolist()[:4]}")
        degrees, steps = check_number("angle", angle), check_count("resolution", resolution, minimum=3)
        if not 0 < abs(degrees) <= 360:
            raise ValueError(f"angle: expected a nonzero angle from -360 to 360 degrees, got {degrees}")
        is_ring = len(line) > 2 and bool((line[0] == line[-1]).all())
        line = line[:-1] if is_ring else line
        check_vertex_count("profile, resolution", (steps + 1) * len(line))
        angles = np.radians(degrees) * np.linspace(0, 1, steps + 1)
        radius, height = line.T
        rings = np.stack(
            [np.outer(np.cos(angles), radius), np.outer(np.sin(angles), radius), np.tile(height, (steps + 1, 1))], -1
        )
        first = np.arange(len(line) - (not is_ring))
        pairs = np.c_[first, (first + 1) % len(line)]
        if degrees < 0:
            pairs = pairs[:, ::-1]
        numbers = number_ring_vertices(rings, abs(degrees) == 360)
        used, triangles = used_vertices(wall_triangles(numbers, pairs))
        return cls._of(Shape(rings.reshape(-1, 3)[used], triangles, np.zeros((0, 2))), device)

    def _swept(self, rings: NDArray[np.float64], is_closed: bool, capping: bool) -> Self:
        """Join copies of the vertices at k positions, shape (k, m, 3), by walls along the border."""
        source_triangles = self.triangles.astype(np.int64)
        sides = source_triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        low, high = np.sort(sides, axis=1).T
        _, group, counts = np.unique(low * (len(self.vertices) + 1) + high, return_inverse=True, return_counts=True)
        on_border = np.flatnonzero(counts[group.reshape(-1)] == 1)
        numbers = number_ring_vertices(rings, is_closed)
        vertices = rings.reshape(-1, 3)
        ends = np.concatenate([numbers[0][source_triangles[:, ::-1]], numbers[-1][source_triangles]])
        walls = wall_triangles(numbers, sides[on_border])
        surface = walls if is_closed else np.concatenate([ends, walls])
        sources = np.concatenate(
            [
                np.arange(len(source_triangles)),
                np.arange(len(source_triangles)),
                np.tile(on_border // 3, 2 * (len(rings) - 1)),
            ]
        )
        keep = (
            np.ones(len(surface), bool)
            if capping or is_closed
            else np.arange(len(surface)) >= 2 * len(source_triangles)
        )
        sources = sources[2 * len(source_triangles) :] if is_closed else sources
        keep &= (surface != np.roll(surface, 1, axis=1)).all(axis=1)
        if signed_volume(vertices, surface) < 0:
            surface = surface[:, ::-1]
        used, triangles = used_vertices(surface[keep])
        return self._with_copies(vertices[used], used % max(rings.shape[1], 1), triangles, sources[keep])

    def _with_copies(
        self, vertices: Any, of_vertices: NDArray[np.int64], triangles: Any, of_triangles: NDArray[np.int64]
    ) -> Self:
        """New vertices and triangles with attributes copied from this mesh, without normals and textures."""
        local, origin = split_origin(vertices)
        bare = self.with_arrays(vertex_normals=None, **dict.fromkeys(TEXTURE))
        arrays = bare.arrays.vertices_at(upload(of_vertices.astype(np.int32), int32, self.device))
        arrays |= bare.arrays.triangles_at(upload(of_triangles.astype(np.int32), int32, self.device))
        arrays["vertices"] = upload(local, vec3, self.device)
        arrays["triangles"] = upload(triangles.astype(np.int32), vec3i, self.device)
        swept = bare.with_arrays(**arrays, origin=origin)
        return swept.compute_vertex_normals() if "vertex_normals" in self.arrays else swept


def positive_lengths(**lengths: float) -> Any:
    return tuple(check_positive(name, value, maximum=MAX_LENGTH) for name, value in lengths.items())


def checked_counts(**counts: tuple[int, int]) -> Any:
    """Validate integers, each given with its minimum. Returns a tuple."""
    return tuple(check_count(name, value, minimum=minimum) for name, (value, minimum) in counts.items())


def check_vertex_count(names: str, vertex_count: int) -> None:
    """Raise ValueError if a shape has too many vertices; `names` are the arguments to report."""
    if vertex_count > MAX_VERTICES:
        raise ValueError(f"{names}: expected at most 2^22 vertices, got {vertex_count:,}. Use fewer steps")


def _arrow(
    shaft_radius: float, head_radius: float, shaft: float, head: float, resolution: int, below: int, above: int
) -> Shape:
    stem = shapes.moved(shapes.cylinder(shaft_radius, shaft, resolution, below), (0, 0, shaft * 0.5))
    tip = shapes.moved(shapes.cone(head_radius, head, resolution, above), (0, 0, shaft))
    return shapes.joined([stem, tip])
