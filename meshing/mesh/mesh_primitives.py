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
from ...core.devices import resolve_device
from ...core.dropped_results import returns_new
from ...kernels.lang import int32, vec2, vec3, vec3i
from ...kernels.linear_algebra import matmul
from ...kernels.memory import upload
from . import shape_arrays as shapes
from .flat_polygons import fill_loops, turn_by_depth
from .mesh_measures import MeshMeasures
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

LONGEST = 1e30  # [m] of a length: what float32 holds, with room for its sums
MOST_VERTICES = 2**22  # of a shape: far beyond what a picture of one shows


class MeshPrimitives(MeshMeasures):
    """The part of TriangleMesh that creates primitives and swept shapes.

    Vertices, triangles and texture coordinates of primitives are Open3D's, in its order. Sweeps run in NumPy: they are
    small, and made once.
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
        device: Any = None,
    ) -> Self:
        """A box with one corner at zero.

        Args:
            width: Along x [m].
            height: Along y [m].
            depth: Along z [m].
            create_uv_map: Also texture coordinates: the box unfolded on the picture.
            map_texture_to_each_face: The whole picture on each face instead.
            device: "cpu" (default), "cuda:N" or "auto".

        Returns:
            8 vertices, 12 triangles.

        Raises:
            ValueError: A length that is not above zero.
            TypeError: No numbers.
            DeviceError: No such device.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box(2, 3, 4).get_volume()
            24.0
        """
        x, y, z = positive_lengths(width=width, height=height, depth=depth)
        return cls._of(shapes.box(x, y, z, bool(map_texture_to_each_face)), device, with_uvs=create_uv_map)

    @classmethod
    def create_plane(
        cls, width: float = 1.0, height: float = 1.0, create_uv_map: bool = False, *, device: Any = None
    ) -> Self:
        """A rectangle in the plane z = 0 with one corner at zero, seen from above; Open3D has none.

        Args:
            width: Along x [m].
            height: Along y [m].
            create_uv_map: Also texture coordinates: the whole picture.
            device: As of `create_box`.

        Returns:
            4 vertices, 2 triangles.

        Raises:
            ValueError, TypeError, DeviceError: As `create_box`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_plane(2, 3).get_surface_area()
            6.0
        """
        return cls._of(shapes.plane(*positive_lengths(width=width, height=height)), device, with_uvs=create_uv_map)

    @classmethod
    def create_tetrahedron(cls, radius: float = 1.0, create_uv_map: bool = False, *, device: Any = None) -> Self:
        """A tetrahedron about zero.

        Args:
            radius: From zero to the corners [m].
            create_uv_map: Also texture coordinates.
            device: As of `create_box`.

        Returns:
            4 vertices, 4 triangles.

        Raises:
            ValueError, TypeError, DeviceError: As `create_box`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_tetrahedron()
            TriangleMesh(4 vertices, 4 triangles, cpu)
        """
        return cls._of(shapes.tetrahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)

    @classmethod
    def create_octahedron(cls, radius: float = 1.0, create_uv_map: bool = False, *, device: Any = None) -> Self:
        """An octahedron about zero.

        Args:
            radius: From zero to the corners [m].
            create_uv_map: Also texture coordinates.
            device: As of `create_box`.

        Returns:
            6 vertices, 8 triangles.

        Raises:
            ValueError, TypeError, DeviceError: As `create_box`.

        Example:
            >>> import pointloom as loom
            >>> round(loom.TriangleMesh.create_octahedron(3).get_volume(), 3)
            36.0
        """
        return cls._of(shapes.octahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)

    @classmethod
    def create_icosahedron(cls, radius: float = 1.0, create_uv_map: bool = False, *, device: Any = None) -> Self:
        """An icosahedron about zero.

        Args:
            radius: Half an edge [m], as Open3D has it; the corners lie 1.902 times as far from zero.
            create_uv_map: Also texture coordinates.
            device: As of `create_box`.

        Returns:
            12 vertices, 20 triangles.

        Raises:
            ValueError, TypeError, DeviceError: As `create_box`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_icosahedron()
            TriangleMesh(12 vertices, 20 triangles, cpu)
        """
        return cls._of(shapes.icosahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)

    @classmethod
    def _of(cls, shape: Shape, device: Any, *, with_uvs: bool = False) -> Self:
        """A mesh of a shape."""
        place = resolve_device(device)
        local, origin = split_origin(shape.vertices)
        return cls._from_device_arrays(
            upload(local, vec3, place),
            upload(shape.triangles.astype(np.int32), vec3i, place),
            triangle_uvs=upload(shape.uvs.astype(np.float32), vec2, place) if with_uvs else None,
            origin=origin,
        )

    @classmethod
    def create_sphere(
        cls, radius: float = 1.0, resolution: int = 20, create_uv_map: bool = False, *, device: Any = None
    ) -> Self:
        """A ball about zero, of rings between two poles.

        Args:
            radius: [m].
            resolution: Steps from pole to pole, at least 2; twice as many around. (Open3D takes 1 and makes triangles
                of vertices that are not there.)
            create_uv_map: Also texture coordinates: u from pole to pole, v around.
            device: As of `create_box`.

        Raises:
            ValueError, TypeError, DeviceError: As `create_box`; or more than 2^22 vertices.

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
        device: Any = None,
    ) -> Self:
        """A ball about zero as `create_sphere` makes it, with another radius along each axis.

        Args:
            radius_x: Along x [m].
            radius_y: Along y [m].
            radius_z: Along z [m].
            resolution: Steps from pole to pole, at least 2.
            create_uv_map: Also texture coordinates.
            device: As of `create_box`.

        Raises:
            ValueError, TypeError, DeviceError: As `create_sphere`.

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
        device: Any = None,
    ) -> Self:
        """A closed cylinder about zero, along z.

        Args:
            radius: [m].
            height: [m].
            resolution: Corners of a ring, at least 3.
            split: Parts along z.
            create_uv_map: Also texture coordinates.
            device: As of `create_box`.

        Raises:
            ValueError, TypeError, DeviceError: As `create_sphere`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_cylinder(split=1).is_watertight()
            True
        """
        sizes = positive_lengths(radius=radius, height=height)
        counts = whole_counts(resolution=(resolution, 3), split=(split, 1))
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
        device: Any = None,
    ) -> Self:
        """A closed cone along z, its base about zero.

        Args:
            radius: Of the base [m].
            height: [m].
            resolution: Corners of a ring, at least 3.
            split: Parts along z.
            create_uv_map: Also texture coordinates.
            device: As of `create_box`.

        Raises:
            ValueError, TypeError, DeviceError: As `create_sphere`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_cone(resolution=8)
            TriangleMesh(10 vertices, 16 triangles, cpu)
        """
        sizes = positive_lengths(radius=radius, height=height)
        counts = whole_counts(resolution=(resolution, 3), split=(split, 1))
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
        device: Any = None,
    ) -> Self:
        """A ring about the z axis.

        Args:
            torus_radius: From zero to the middle of the tube [m].
            tube_radius: Of the tube [m].
            radial_resolution: Rings around the hole, at least 3.
            tubular_resolution: Corners of a ring, at least 3.
            device: As of `create_box`.

        Raises:
            ValueError, TypeError, DeviceError: As `create_sphere`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_torus()
            TriangleMesh(600 vertices, 1200 triangles, cpu)
        """
        radii = positive_lengths(torus_radius=torus_radius, tube_radius=tube_radius)
        counts = whole_counts(radial_resolution=(radial_resolution, 3), tubular_resolution=(tubular_resolution, 3))
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
        device: Any = None,
    ) -> Self:
        """An arrow from zero along z: a cylinder with a cone on it.

        Args:
            cylinder_radius: Of the shaft [m].
            cone_radius: Of the head [m].
            cylinder_height: Of the shaft [m].
            cone_height: Of the head [m].
            resolution: Corners of a ring, at least 3.
            cylinder_split: Parts of the shaft along z.
            cone_split: Parts of the head along z.
            device: As of `create_box`.

        Raises:
            ValueError, TypeError, DeviceError: As `create_sphere`.

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
        counts = whole_counts(
            resolution=(resolution, 3), cylinder_split=(cylinder_split, 1), cone_split=(cone_split, 1)
        )
        check_vertex_count("resolution, cylinder_split, cone_split", counts[0] * (counts[1] + counts[2] + 1) + 4)
        return cls._of(_arrow(*sizes, *counts), device)

    @classmethod
    def create_coordinate_frame(
        cls, size: float = 1.0, origin: ArrayLike = (0.0, 0.0, 0.0), *, device: Any = None
    ) -> Self:
        """Arrows along x (red), y (green) and z (blue) from a grey ball, with vertex normals.

        Args:
            size: Length of the arrows [m].
            origin: Where they begin [m], shape [3].
            device: As of `create_box`.

        Raises:
            ValueError, TypeError, DeviceError: As `create_box`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_coordinate_frame(0.5, [1, 2, 3])
            TriangleMesh(1134 vertices, 2240 triangles, vertex_normals, vertex_colors, cpu)
        """
        (length,) = positive_lengths(size=size)
        place = check_finite("origin", check_shape("origin", origin, (3,)))
        if np.abs(place).max() > LONGEST:
            raise ValueError(f"origin: expected coordinates up to {LONGEST:g} m, got {place.tolist()}")
        along_z = _arrow(0.035 * length, 0.06 * length, 0.8 * length, 0.2 * length, 20, 4, 1)
        x, y, z = along_z.vertices.T
        turned = [along_z._replace(vertices=np.stack(axes, axis=1)) for axes in ((z, x, y), (y, z, x), (x, y, z))]
        parts = [shapes.sphere(0.06 * length, 20), *turned]
        colors = [[0.5, 0.5, 0.5], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        mesh = cls._of(shapes.joined(parts), device).compute_vertex_normals()
        mesh.vertex_colors = np.repeat(colors, [len(part.vertices) for part in parts], axis=0)
        local, anchor = split_origin(mesh.vertices + place)
        return mesh._with_arrays(vertices=upload(local, vec3, mesh.device), origin=anchor)

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
        device: Any = None,
    ) -> Self:
        """A band about the z axis with half twists: one has one side only.

        Args:
            length_split: Pieces around, at least 3.
            width_split: Vertices across, at least 2.
            twists: Half twists, 0 and up.
            radius: From zero to the middle of the band.
            flatness: Stretches the band along z; not zero.
            width: Of the band.
            scale: Times everything.
            device: As of `create_box`.

        Raises:
            ValueError, TypeError, DeviceError: As `create_sphere`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_mobius()
            TriangleMesh(1050 vertices, 1960 triangles, cpu)
        """
        long, wide, turns = whole_counts(
            length_split=(length_split, 3), width_split=(width_split, 2), twists=(twists, 0)
        )
        around, breadth, factor = positive_lengths(radius=radius, width=width, scale=scale)
        flat = check_number("flatness", flatness)
        if flat == 0 or abs(flat) > LONGEST:
            raise ValueError(f"flatness: expected a number other than 0 up to {LONGEST:g}, got {flat:g}")
        check_vertex_count("length_split, width_split", long * wide)
        return cls._of(shapes.mobius(long, wide, turns, around, flat, breadth, factor), device)

    @classmethod
    def create_moebius(cls, *args: Any, **kwargs: Any) -> Self:
        """The same as `create_mobius`.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_moebius(twists=2).is_edge_manifold()
            True
        """
        return cls.create_mobius(*args, **kwargs)

    @returns_new
    def extrude_linear(self, vector: ArrayLike, scale: float = 1.0, capping: bool = True) -> Self:
        """What the mesh sweeps when it moves along a vector.

        Args:
            vector: The way [m], shape [3].
            scale: What the vector is multiplied with.
            capping: Keep the mesh at the beginning and at the end; else only the walls that its border sweeps.

        Returns:
            Its vertices where they begin, then where they end; triangles at the beginning, at the end, and of the
            walls, all facing outwards. A mesh in one piece whose triangles turn one way and face the vector all over,
            or turn away from it, makes a watertight one. Colours and attributes stay, normals are made anew where there
            were any, textures are left behind.

        Raises:
            ValueError: Not three finite numbers, or a way without a length.
            TypeError: No numbers.

        Example:
            >>> import pointloom as loom
            >>> wedge = loom.TriangleMesh([[1, 1, 0], [0, 1, 0], [1, 0, 0]], [[0, 1, 2]]).extrude_linear([0, 0, 1])
            >>> wedge.is_watertight(), wedge.get_volume(), len(wedge)
            (True, 0.5, 8)
        """
        way = check_finite("vector", check_shape("vector", vector, (3,))) * check_length("scale", scale)
        if not way.any():
            raise ValueError("vector: expected a way of some length, got none")
        corners = self.vertices
        return self._swept(np.stack([corners, corners + way]), False, bool(capping))

    @returns_new
    def extrude_rotation(
        self, angle: float, axis: ArrayLike, resolution: int = 16, translation: float = 0.0, capping: bool = True
    ) -> Self:
        """What the mesh sweeps when it turns about an axis through zero, and moves along it on the way.

        Args:
            angle: [degrees], of any size.
            axis: A direction, shape [3]; the mesh turns to the left seen against it.
            resolution: Steps.
            translation: The way along the axis [m].
            capping: As of `extrude_linear`.

        Returns:
            Its vertices after each step, those on the axis once where nothing moves along it; triangles at the
            beginning, at the end, and of the walls, step by step. A whole turn without a translation closes: the last
            vertices are the first ones (Open3D keeps both), and no ends are kept. Else as `extrude_linear`.

        Raises:
            ValueError: No direction, an angle of zero, no step, or more than 2^22 vertices.
            TypeError: No numbers.

        Example:
            >>> import pointloom as loom
            >>> square = loom.TriangleMesh([[2, 0, 0], [3, 0, 0], [3, 0, 1], [2, 0, 1]], [[0, 1, 2], [0, 2, 3]])
            >>> ring = square.extrude_rotation(360, [0, 0, 1], resolution=32)
            >>> ring.is_watertight(), ring.euler_poincare_characteristic()
            (True, 0)
        """
        way = check_direction("axis", axis)
        whole, rise = np.radians(check_length("angle", angle)), check_length("translation", translation)
        if not whole:
            raise ValueError("angle: expected one other than zero")
        steps = check_count("resolution", resolution, minimum=1)
        corners = self.vertices
        check_vertex_count("resolution", (steps + 1) * len(corners))
        shares = np.linspace(0, 1, steps + 1)[:, None, None]
        along = matmul(corners, way)[:, None] * way
        across, side = corners - along, np.cross(way, corners)
        rings = along + np.cos(whole * shares) * across + np.sin(whole * shares) * side + rise * shares * way
        is_closed = not rise and abs(abs(float(angle)) - 360) < 1e-9 and steps > 2
        if not rise:
            reach = np.linalg.norm(across, axis=1)
            rings[:, reach <= 1e-7 * np.abs(corners).max(initial=0)] = corners[
                reach <= 1e-7 * np.abs(corners).max(initial=0)
            ]
        return self._swept(rings, is_closed, bool(capping) and not is_closed)

    @classmethod
    def from_polygon(cls, outline: ArrayLike, holes: Sequence[ArrayLike] = (), *, device: Any = None) -> Self:
        """A flat polygon with holes, in triangles.

        Args:
            outline: Its corners in order [m], shape [k, 2] in the plane z = 0 or [k, 3]; the first one may stand at the
                end again.
            holes: Outlines of holes, likewise.
            device: "cpu" (default), "cuda:N" or "auto".

        Returns:
            All corners in their order, and triangles between them alone, those along straight lines too. In two
            dimensions it faces up, in three the side from which the outline runs to the left.

        Raises:
            ValueError: Fewer than three corners, numbers that are not finite, corners off one plane, or outlines that
                cross themselves or each other.
            TypeError: No numbers.
            ImportError: manifold3d is not installed.
            DeviceError: No such device.

        Notes:
            A point is off the plane beyond 1e-6 of the outline's length. Same bits from run to run.

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
            raise ValueError("holes: expected as many coordinates as those of the outline")
        places = np.concatenate(loops)
        flat = flatten_outline(places, len(loops[0]))
        parts = np.split(flat, np.cumsum([len(loop) for loop in loops])[:-1])
        turned = turn_by_depth(parts)
        order = np.split(np.arange(len(flat)), np.cumsum([len(loop) for loop in loops])[:-1])
        order = [rows[::-1] if turn else rows for rows, turn in zip(order, turned, strict=True)]
        triangles = np.concatenate(order)[fill_loops("from_polygon", [flat[rows] for rows in order])]
        check_area(flat, order, triangles)
        if places.shape[1] == 2:
            places = np.c_[places, np.zeros(len(places))]
        return cls._of(Shape(places, triangles, np.zeros((0, 2))), device)

    @classmethod
    def revolve(cls, profile: ArrayLike, angle: float = 360.0, resolution: int = 64, *, device: Any = None) -> Self:
        """The surface that a line sweeps when it turns about the z axis.

        Args:
            profile: Its points as distance from the axis and height [m], shape [k, 2]; a line that goes up faces
                outwards. Where the last point is the first one again, it closes.
            angle: [degrees], up to 360 either way; with less the surface is open.
            resolution: Steps.
            device: As of `from_polygon`.

        Returns:
            The points of the line after each step, those on the axis once.

        Raises:
            ValueError: Fewer than two points, a distance below zero, no step, or more than 2^22 vertices.
            TypeError: No numbers.

        Example:
            >>> import pointloom as loom
            >>> vase = loom.TriangleMesh.revolve([[0, 0], [1, 0], [0.5, 2], [0, 2]])
            >>> vase.is_watertight(), round(vase.get_volume(), 2)
            (True, 3.66)
        """
        line = check_finite("profile", check_rows("profile", profile, 2, dtype=np.float64))
        if len(line) < 2 or (line[:, 0] < 0).any():
            raise ValueError(f"profile: expected two points or more, none closer than zero, got {line.tolist()[:4]}")
        turn, steps = check_number("angle", angle), check_count("resolution", resolution, minimum=3)
        if not 0 < abs(turn) <= 360:
            raise ValueError(f"angle: expected up to 360 degrees either way, got {turn}")
        is_ring = len(line) > 2 and bool((line[0] == line[-1]).all())
        line = line[:-1] if is_ring else line
        check_vertex_count("profile, resolution", (steps + 1) * len(line))
        angles = np.radians(turn) * np.linspace(0, 1, steps + 1)
        radius, height = line.T
        rings = np.stack(
            [np.outer(np.cos(angles), radius), np.outer(np.sin(angles), radius), np.tile(height, (steps + 1, 1))], -1
        )
        first = np.arange(len(line) - (not is_ring))
        pairs = np.c_[first, (first + 1) % len(line)]
        if turn < 0:
            pairs = pairs[:, ::-1]
        numbers = number_ring_vertices(rings, abs(turn) == 360)
        used, triangles = used_vertices(wall_triangles(numbers, pairs))
        return cls._of(Shape(rings.reshape(-1, 3)[used], triangles, np.zeros((0, 2))), device)

    def _swept(self, rings: NDArray[np.float64], is_closed: bool, capping: bool) -> Self:
        """The mesh with its vertices at each of some places, [k, m, 3], joined by walls along its border."""
        own = self.triangles.astype(np.int64)
        sides = own[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        low, high = np.sort(sides, axis=1).T
        _, group, counts = np.unique(low * (len(self.vertices) + 1) + high, return_inverse=True, return_counts=True)
        on_border = np.flatnonzero(counts[group.reshape(-1)] == 1)
        numbers = number_ring_vertices(rings, is_closed)
        places = rings.reshape(-1, 3)
        ends = np.concatenate([numbers[0][own[:, ::-1]], numbers[-1][own]])
        walls = wall_triangles(numbers, sides[on_border])
        whole = walls if is_closed else np.concatenate([ends, walls])
        sources = np.concatenate(
            [np.arange(len(own)), np.arange(len(own)), np.tile(on_border // 3, 2 * (len(rings) - 1))]
        )
        keep = np.ones(len(whole), bool) if capping or is_closed else np.arange(len(whole)) >= 2 * len(own)
        sources = sources[2 * len(own) :] if is_closed else sources
        keep &= (whole != np.roll(whole, 1, axis=1)).all(axis=1)
        if signed_volume(places, whole) < 0:
            whole = whole[:, ::-1]
        used, triangles = used_vertices(whole[keep])
        return self._with_copies(places[used], used % max(rings.shape[1], 1), triangles, sources[keep])

    def _with_copies(self, places: Any, of_vertices: Any, triangles: Any, of_triangles: Any) -> Self:
        """Vertices and triangles that have what belongs to some of this mesh, but for normals and textures."""
        local, origin = split_origin(places)
        bare = self._with_arrays(triangle_uvs=None, vertex_normals=None)
        arrays = bare._vertices_at(upload(of_vertices.astype(np.int32), int32, self._device))
        arrays |= bare._triangles_at(upload(of_triangles.astype(np.int32), int32, self._device))
        arrays["vertices"] = upload(local, vec3, self._device)
        arrays["triangles"] = upload(triangles.astype(np.int32), vec3i, self._device)
        swept = bare._with_arrays(**arrays, origin=origin)
        return swept.compute_vertex_normals() if "vertex_normals" in self._arrays else swept


def positive_lengths(**lengths: float) -> Any:
    """Lengths above zero, as a tuple."""
    return tuple(check_positive(name, value, maximum=LONGEST) for name, value in lengths.items())


def whole_counts(**counts: tuple[int, int]) -> Any:
    """Whole numbers, each given with the least that it may be, as a tuple."""
    return tuple(check_count(name, value, minimum=least) for name, (value, least) in counts.items())


def check_vertex_count(names: str, vertex_count: int) -> None:
    """Hold that a shape has no more vertices than anybody can see.

    Raises:
        ValueError: It has; `names` are the arguments that say so.
    """
    if vertex_count > MOST_VERTICES:
        raise ValueError(f"{names}: {vertex_count:,} vertices are more than 2^22; take fewer steps")


def _arrow(
    shaft_radius: float, head_radius: float, shaft: float, head: float, resolution: int, below: int, above: int
) -> Shape:
    stem = shapes.moved(shapes.cylinder(shaft_radius, shaft, resolution, below), (0, 0, shaft * 0.5))
    tip = shapes.moved(shapes.cone(head_radius, head, resolution, above), (0, 0, shaft))
    return shapes.joined([stem, tip])
