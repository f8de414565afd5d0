"""Primitive meshes of tensors."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import Any, Self, TypeVar

from numpy.typing import ArrayLike

from ...argument_types import DeviceLike, TensorLike
from ...core.dtype import Dtype, float32, int64
from .geometry import device_of
from .mesh_tensors import CPU, MeshTensors, NativeMesh
from .tensors import host_of

M = TypeVar("M", bound=MeshTensors)
ONLY_LEGACY = ("create_uv_map", "map_texture_to_each_face")  # parameters that primitives of tensors do not have


def _last_parameters(float_dtype: Dtype = float32, int_dtype: Dtype = int64, device: DeviceLike = CPU) -> None:
    """The last parameters of each primitive: the types of positions and indices, and their device."""


class Primitive:
    """A primitive of pointloom. Its signature shows Open3D's parameters: the sizes, two types and a device."""

    def __init__(self, factory: Callable[..., Any]):
        self.factory = factory
        sizes = [
            parameter
            for parameter in inspect.signature(factory).parameters.values()
            if parameter.kind is not parameter.KEYWORD_ONLY and parameter.name not in ONLY_LEGACY
        ]
        self.signature = inspect.Signature([*sizes, *inspect.signature(_last_parameters).parameters.values()])

    def __get__(self, instance: object, owner: type[M]) -> Callable[..., M]:
        @functools.wraps(self.factory)
        def make(*args: Any, **keywords: Any) -> M:
            given = self.signature.bind(*args, **keywords)
            given.apply_defaults()
            *sizes, float_dtype, int_dtype, device = given.args
            made = self.factory(*map(host_of, sizes), device=device_of(device).name)
            return owner.from_native(made, float_dtype, int_dtype)

        make.__signature__ = self.signature  # type: ignore[attr-defined]
        return make


class MeshFactories(MeshTensors):
    """Primitives. `float_dtype` and `int_dtype` are the types of positions and indices."""

    create_box = Primitive(NativeMesh.create_box)
    create_sphere = Primitive(NativeMesh.create_sphere)
    create_tetrahedron = Primitive(NativeMesh.create_tetrahedron)
    create_octahedron = Primitive(NativeMesh.create_octahedron)
    create_icosahedron = Primitive(NativeMesh.create_icosahedron)
    create_cylinder = Primitive(NativeMesh.create_cylinder)
    create_cone = Primitive(NativeMesh.create_cone)
    create_ellipsoid = Primitive(NativeMesh.create_ellipsoid)
    create_torus = Primitive(NativeMesh.create_torus)
    create_arrow = Primitive(NativeMesh.create_arrow)
    create_coordinate_frame = Primitive(NativeMesh.create_coordinate_frame)
    create_mobius = Primitive(NativeMesh.create_mobius)

    @classmethod
    def create_isosurfaces(
        cls, volume: TensorLike, contour_values: ArrayLike = (0.0,), device: DeviceLike = CPU
    ) -> Self:
        """Isosurfaces of values at grid points, shape (z, y, x), in units of samples, with normals."""
        made = NativeMesh.create_isosurfaces(host_of(volume), contour_values, device_of(device).name)
        return cls.from_native(made.compute_vertex_normals(), float32, int64)
