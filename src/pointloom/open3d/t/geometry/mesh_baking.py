"""Textures of mesh attributes: each texel takes the values of the nearest triangle in texture space."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_count, check_positive
from ....meshing.scene.raycasting_scene import RaycastingScene
from ...core.tensor import Tensor
from .. import geometry
from .mesh_tensors import MeshTensors
from .tensor_map import TensorMap


class BakedTextures(MeshTensors):
    def bake_vertex_attr_textures(
        self,
        size: int,
        vertex_attr: Iterable[str],
        margin: float = 2.0,
        fill: float = 0.0,
        update_material: bool = True,
    ) -> dict[str, Tensor]:
        """Textures (size, size, ...) of vertex attributes, interpolated, top row first.

        Texels farther than `margin` texels from all triangles get `fill`.
        """
        near, triangles, weights = self._texels(size, margin)
        corners = self.triangle["indices"].numpy()[triangles]

        def interpolate(values: NDArray[Any]) -> NDArray[Any]:
            return np.einsum("ijk,ijk...->ij...", weights, values[corners])

        return self._baked(self.vertex, vertex_attr, interpolate, near, fill, update_material)

    def bake_triangle_attr_textures(
        self,
        size: int,
        triangle_attr: Iterable[str],
        margin: float = 2.0,
        fill: float = 0.0,
        update_material: bool = True,
    ) -> dict[str, Tensor]:
        """Textures (size, size, ...) of triangle attributes, top row first. Margin as for vertex attributes."""
        near, triangles, _ = self._texels(size, margin)
        return self._baked(self.triangle, triangle_attr, lambda values: values[triangles], near, fill, update_material)

    def _texels(self, size: int, margin: float) -> tuple[NDArray[np.bool_], NDArray[Any], NDArray[Any]]:
        """Whether a triangle is near, the nearest triangle, and the weights of its corners, for each texel."""
        width = check_count("size", size)
        limit = check_positive("margin", margin, allow_zero=True) / width
        if "texture_uvs" not in self.triangle:
            raise ValueError("texture_uvs: expected texture coordinates of triangles; call compute_uvatlas() first")
        uvs = self.triangle["texture_uvs"].numpy().reshape(-1, 2)
        scene = RaycastingScene(self.device.name)
        scene.add_triangles(np.pad(uvs, ((0, 0), (0, 1))), np.arange(len(uvs)).reshape(-1, 3))
        centers = (np.arange(width) + 0.5) / width
        texels = np.stack([*np.meshgrid(centers, 1 - centers), np.zeros((width, width))], axis=-1)
        found = scene.compute_closest_points(texels)
        u, v = np.moveaxis(found["primitive_uvs"], -1, 0)
        near = np.linalg.norm(found["points"] - texels, axis=-1) <= limit
        return near, found["primitive_ids"], np.stack([np.maximum(1 - u - v, 0), u, v], axis=-1)

    def _baked(
        self,
        part: TensorMap,
        names: Iterable[str],
        values_of: Callable[[NDArray[Any]], NDArray[Any]],
        near: NDArray[np.bool_],
        fill: float,
        update: bool,
    ) -> dict[str, Tensor]:
        made = {}
        for name in names:
            tensor = part[name]
            texels = np.full((*near.shape, *tensor.shape[1:]), fill, tensor.dtype.numpy)
            texels[near] = values_of(tensor.numpy())[near]
            made[name] = Tensor(texels, device=self.device)
            if update:
                pixels = Tensor(texels.reshape(*near.shape, -1), device=self.device)
                self.material.texture_maps[name] = geometry.Image(pixels)
        return made
