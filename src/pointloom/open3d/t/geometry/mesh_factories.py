"""Primitive meshes of tensors."""

from __future__ import annotations

from typing import Any, Self

from numpy.typing import ArrayLike

from ... import geometry as legacy
from ...core.dtype import Dtype, float32, int64
from ...wrapper import unwrap
from .ellipsoids import OrientedBoundingEllipsoid
from .geometry import device_of
from .mesh_tensors import CPU, MeshTensors, NativeMesh
from .tensor_map import matrix_of
from .tensors import host_of


class MeshFactories(MeshTensors):
    """Primitives. `float_dtype` and `int_dtype` are the types of positions and indices."""

    @classmethod
    def _create(cls, method: str, arguments: tuple[Any, ...], types: tuple[Dtype, Dtype], device: Any) -> Self:
        return cls._of(getattr(NativeMesh, method)(*arguments, device=device_of(device).name), *types)

    @classmethod
    def create_box(
        cls,
        width: float = 1.0,
        height: float = 1.0,
        depth: float = 1.0,
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        return cls._create("create_box", (width, height, depth), (float_dtype, int_dtype), device)

    @classmethod
    def create_sphere(
        cls,
        radius: float = 1.0,
        resolution: int = 20,
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        return cls._create("create_sphere", (radius, resolution), (float_dtype, int_dtype), device)

    @classmethod
    def create_tetrahedron(
        cls, radius: float = 1.0, float_dtype: Dtype = float32, int_dtype: Dtype = int64, device: Any = CPU
    ) -> Self:
        return cls._create("create_tetrahedron", (radius,), (float_dtype, int_dtype), device)

    @classmethod
    def create_octahedron(
        cls, radius: float = 1.0, float_dtype: Dtype = float32, int_dtype: Dtype = int64, device: Any = CPU
    ) -> Self:
        return cls._create("create_octahedron", (radius,), (float_dtype, int_dtype), device)

    @classmethod
    def create_icosahedron(
        cls, radius: float = 1.0, float_dtype: Dtype = float32, int_dtype: Dtype = int64, device: Any = CPU
    ) -> Self:
        return cls._create("create_icosahedron", (radius,), (float_dtype, int_dtype), device)

    @classmethod
    def create_cylinder(
        cls,
        radius: float = 1.0,
        height: float = 2.0,
        resolution: int = 20,
        split: int = 4,
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        return cls._create("create_cylinder", (radius, height, resolution, split), (float_dtype, int_dtype), device)

    @classmethod
    def create_cone(
        cls,
        radius: float = 1.0,
        height: float = 2.0,
        resolution: int = 20,
        split: int = 1,
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        return cls._create("create_cone", (radius, height, resolution, split), (float_dtype, int_dtype), device)

    @classmethod
    def create_ellipsoid(
        cls,
        radius_x: float = 1.0,
        radius_y: float = 1.0,
        radius_z: float = 1.0,
        resolution: int = 20,
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        sizes = radius_x, radius_y, radius_z, resolution
        return cls._create("create_ellipsoid", sizes, (float_dtype, int_dtype), device)

    @classmethod
    def create_from_oriented_bounding_ellipsoid(
        cls,
        ellipsoid: OrientedBoundingEllipsoid,
        scale: Any = (1.0, 1.0, 1.0),
        resolution: int = 20,
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        """A mesh of an ellipsoid, scaled per axis."""
        factors = matrix_of("scale", scale, (3,))
        made = legacy.TriangleMesh.create_from_oriented_bounding_ellipsoid(ellipsoid._native, factors, resolution)
        return cls._of(unwrap(made).to(device_of(device).name), float_dtype, int_dtype)

    @classmethod
    def create_torus(
        cls,
        torus_radius: float = 1.0,
        tube_radius: float = 0.5,
        radial_resolution: int = 30,
        tubular_resolution: int = 20,
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        sizes = torus_radius, tube_radius, radial_resolution, tubular_resolution
        return cls._create("create_torus", sizes, (float_dtype, int_dtype), device)

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
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        sizes = cylinder_radius, cone_radius, cylinder_height, cone_height, resolution, cylinder_split, cone_split
        return cls._create("create_arrow", sizes, (float_dtype, int_dtype), device)

    @classmethod
    def create_coordinate_frame(
        cls,
        size: float = 1.0,
        origin: Any = (0.0, 0.0, 0.0),
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        return cls._create("create_coordinate_frame", (size, host_of(origin)), (float_dtype, int_dtype), device)

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
        float_dtype: Dtype = float32,
        int_dtype: Dtype = int64,
        device: Any = CPU,
    ) -> Self:
        sizes = length_split, width_split, twists, radius, flatness, width, scale
        return cls._create("create_mobius", sizes, (float_dtype, int_dtype), device)

    @classmethod
    def create_isosurfaces(cls, volume: Any, contour_values: ArrayLike = (0.0,), device: Any = CPU) -> Self:
        """Isosurfaces of values at grid points, shape (z, y, x), in units of samples, with normals."""
        made = NativeMesh.create_isosurfaces(host_of(volume), contour_values, device_of(device).name)
        return cls._of(made.compute_vertex_normals(), float32, int64)
