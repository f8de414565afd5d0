"""Simple shapes with corners as meshes: boxes, planes, regular solids; and what all shapes share."""

from __future__ import annotations

from typing import Any, Self

import numpy as np

from ...core.checks import check_count, check_positive
from ...core.coordinates import split_origin
from ...core.devices import resolve_device
from ...kernels.lang import vec2, vec3, vec3i
from ...kernels.memory import upload
from . import shape_arrays as shapes
from .mesh_measures import MeshMeasures
from .shape_arrays import Shape

LONGEST = 1e30  # [m] of a length: what float32 holds, with room for its sums
MOST_VERTICES = 2**22  # of a shape: far beyond what a picture of one shows


class MeshShapes(MeshMeasures):
    """The part of TriangleMesh that makes simple shapes with corners.

    Vertices and triangles come in Open3D's order. Texture coordinates, where asked for, are Open3D's as well.
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
