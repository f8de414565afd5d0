"""Simple round shapes as meshes: balls, cylinders, cones, rings, and the arrows and axes that they make up."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from ...core.checks import check_count, check_finite, check_number, check_shape
from ...core.coordinates import split_origin
from ...kernels.lang import vec3
from ...kernels.memory import upload
from . import shape_arrays as shapes
from .mesh_shapes import LONGEST, MeshShapes, check_vertex_count, positive_lengths, whole_counts
from .shape_arrays import Shape


class MeshRoundShapes(MeshShapes):
    """The part of TriangleMesh that makes simple round shapes, in Open3D's order as well."""

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


def _arrow(
    shaft_radius: float, head_radius: float, shaft: float, head: float, resolution: int, below: int, above: int
) -> Shape:
    stem = shapes.moved(shapes.cylinder(shaft_radius, shaft, resolution, below), (0, 0, shaft * 0.5))
    tip = shapes.moved(shapes.cone(head_radius, head, resolution, above), (0, 0, shaft))
    return shapes.joined([stem, tip])
