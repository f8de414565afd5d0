"""Meshes of tensors as pointloom's meshes and back."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from ....kernels.arrays.origins import add_origin
from ....meshing.mesh import mesh
from ....pcd.cloud import PointCloud as NativeCloud
from ...argument_types import DeviceLike
from ...core.device import Device
from ...core.dtype import Dtype
from ...core.tensor import Tensor
from .. import geometry
from .geometry import CPU, Geometry, device_of
from .material import Material
from .tensor_map import TensorMap, count_of, listed
from .tensors import host_of, new_tensor, values_of

NativeMesh = mesh.TriangleMesh
VERTEX = {"positions": "vertices", "normals": "vertex_normals", "colors": "vertex_colors"}
TRIANGLE = {"indices": "triangles", "texture_uvs": "triangle_uvs"}


class MeshTensors(Geometry):
    """Vertices and triangles as maps of tensors; `vertex.positions` and `triangle.indices` are primary.

    The names "normals" and "colors" of vertices and "texture_uvs" of triangles have a meaning. Others are attributes.
    """

    _internal = ("surface", "texture", "set_texture", "textured", "set_native")

    _parts: ClassVar = ("vertex", "triangle")
    _fixed = ("vertex", "triangle")
    vertex: TensorMap
    triangle: TensorMap
    material: Material

    def __init__(self, vertex_positions: object = None, triangle_indices: object = None, *, device: DeviceLike = CPU):
        given = vertex_positions
        if isinstance(given, MeshTensors):
            vars(self).update(vars(given.__copy__()))
            return
        if isinstance(given, Device | str):
            given, device = None, given
        self._home = device_of(device)
        self.material = Material()
        self.vertex, self.triangle = TensorMap("positions"), TensorMap("indices")
        for part, values in ((self.vertex, given), (self.triangle, triangle_indices)):
            if values is not None:
                tensor = values if isinstance(values, Tensor) else Tensor(values)
                if len(tensor.shape) != 2 or tensor.shape[1] != 3:
                    raise ValueError(f"{part.primary_key}: expected shape [n, 3], got {list(tensor.shape)}")
                part[part.primary_key] = tensor

    @property
    def surface(self) -> Any:
        """The mesh without attributes."""
        vertices, triangles = (
            values_of(part[part.primary_key]) if part.primary_key in part else np.zeros((0, 3), np.int32)
            for part in (self.vertex, self.triangle)
        )
        return NativeMesh(vertices, triangles, device=self.device.name)

    @property
    def native(self) -> Any:
        """The mesh with all attributes."""
        made = self.surface
        for name, tensor in self.vertex.items():
            if name == "normals" or (name == "colors" and tensor.dtype.numpy.kind == "f"):
                setattr(made, VERTEX[name], values_of(tensor))
            elif name != "positions":
                made.vertex_attributes[name] = _columns(tensor)
        for name, tensor in self.triangle.items():
            if name == "texture_uvs":
                made.triangle_uvs = host_of(tensor).reshape(-1, 2)
            elif name != "indices":
                made.triangle_attributes[name] = _columns(tensor)
        return made

    def has_valid_material(self) -> bool:
        return self.material.is_valid()

    @property
    def texture(self) -> NDArray[Any] | None:
        """Pixels of the material's texture map "albedo", (h, w, c)."""
        image = self.material.texture_maps.get("albedo")
        return None if image is None else host_of(image.as_tensor())

    def set_texture(self, pixels: NDArray[Any] | None) -> None:
        if pixels is not None:
            self.material.set_default_properties()
            self.material.texture_maps["albedo"] = geometry.Image(Tensor(pixels))

    def textured(self) -> Any:
        """The mesh with all attributes, colors in 0..1, and its texture if there are texture coordinates."""
        made, texture = self.native, self.texture
        if made.vertex_attributes.pop("colors", None) is not None:  # 8 bits
            made.vertex_colors = values_of(self.vertex["colors"])
        if texture is not None and "texture_uvs" in self.triangle:
            made.textures = [texture]
        return made

    def map_tensors(self, function: Callable[[Tensor], Tensor]) -> Self:
        made = super().map_tensors(function)
        made.material = Material(self.material)
        return made

    @classmethod
    def from_native(cls, native: NativeMesh, float_dtype: Dtype, int_dtype: Dtype) -> Self:
        """Copy a mesh of pointloom."""
        device, nothing = Device(str(native.device)), np.zeros((0, 3))
        return cls(Tensor(nothing, float_dtype, device), Tensor(nothing, int_dtype, device)).set_native(native)

    def _new(self, native: NativeMesh) -> Self:
        """The result of an operation on this mesh, with its data types."""
        return self.__copy__().set_native(native)

    def set_native(self, native: NativeMesh) -> Self:
        """Replace all tensors by copies of a result's arrays. Names that exist keep their data types."""
        positions = self.vertex["positions"].dtype.numpy if "positions" in self.vertex else np.dtype(np.float32)
        floats = positions if positions.kind == "f" else np.dtype(np.float32)
        vars(self)["vertex"] = self._replaced(self.vertex, VERTEX, native, native.vertex_attributes.arrays, floats)
        vars(self)["triangle"] = self._replaced(
            self.triangle, TRIANGLE, native, native.triangle_attributes.arrays, floats
        )
        return self

    def _replaced(
        self,
        old: TensorMap,
        names: dict[str, str],
        native: NativeMesh,
        attributes: dict[str, Any],
        floats: np.dtype[Any],
    ) -> TensorMap:
        types = {name: tensor.dtype.numpy for name, tensor in old.items()}
        types["positions"], types["indices"] = floats, types.get("indices", np.dtype(np.int64))
        made = TensorMap(old.primary_key)
        for name, own in names.items():
            if own in native.arrays:
                array = positions_of(native) if name == "positions" else native.arrays[own]
                shape = (len(native), 3, 2) if name == "texture_uvs" else (array.shape[0], 3)
                made[name] = new_tensor(array, types.get(name, floats), shape)
        for name, array in attributes.items():
            tail = tuple(old[name].shape[1:]) if name in old else tuple(array.shape[1:])
            made[name] = new_tensor(array, None, (array.shape[0], *tail))
        return made

    def __repr__(self) -> str:
        counts = [
            f"{count_of(part)} {of}{f' ({part[part.primary_key].dtype})' if count_of(part) else ''}"
            for part, of in ((self.vertex, "vertices"), (self.triangle, "triangles"))
        ]
        lines = [f"TriangleMesh on {self.device} [{' and '.join(counts)}]."]
        for part, of in ((self.vertex, "Vertex"), (self.triangle, "Triangle")):
            lines.append(f"{of} Attributes:{listed(part, ordered=True)}")
        return "\n".join(lines)


def positions_of(native: NativeMesh | NativeCloud, name: str = "vertices") -> Any:
    """Vertices or points as a device array with the origin added."""
    array = native.arrays[name]
    return add_origin(array, native.origin) if native.origin.any() else array


def _columns(tensor: Tensor) -> Any:
    """An attribute as at most two axes."""
    shape = tuple(tensor.shape)
    return values_of(tensor) if len(shape) < 3 else values_of(tensor).reshape((shape[0], int(np.prod(shape[1:]))))


def cloud_of(native: NativeCloud, dtype: Dtype) -> Any:
    """Copy a cloud of pointloom into a PointCloud of tensors."""
    shape = (len(native), 3)
    cloud = geometry.PointCloud(new_tensor(positions_of(native, "points"), dtype.numpy, shape))
    for name in ("normals", "colors"):
        if name in native.arrays:
            cloud.point[name] = new_tensor(native.arrays[name], dtype.numpy, shape)
    return cloud
