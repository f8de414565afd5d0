"""RaycastingScene with tensors."""

from __future__ import annotations

import math
from typing import Any

from ....meshing.scene import raycasting_scene
from ...argument_types import DeviceLike, TensorLike
from ...core import Device, Tensor
from ...wrapper import Wrapper
from .mesh_tensors import CPU, NativeMesh
from .tensor_map import wrap
from .tensors import host_of, values_of
from .triangle_mesh import TriangleMesh


class RaycastingScene(Wrapper):
    """Triangles for ray casting and distances, also on a GPU. Arguments can be NumPy arrays, on any leading shape.

    `nthreads` and `nsamples` have no effect.
    """

    _kind = raycasting_scene.RaycastingScene

    INVALID_ID = raycasting_scene.RaycastingScene.INVALID_ID

    def __init__(self, nthreads: int = 0, device: DeviceLike = CPU):
        self._wrapped, self._shared = self._kind(Device(device).name), {}

    def add_triangles(
        self,
        vertex_positions: TriangleMesh | TensorLike | None = None,
        triangle_indices: TensorLike | None = None,
        *,
        mesh: TriangleMesh | TensorLike | None = None,
    ) -> int:
        """Add a TriangleMesh, or vertices (n, 3) and triangles (m, 3). Returns the geometry id."""
        added = values_of(vertex_positions if mesh is None else mesh)
        if isinstance(added, TriangleMesh):
            added = added.surface
        elif triangle_indices is not None:
            added = NativeMesh(added, values_of(triangle_indices), device=self._wrapped.device)
        return self._wrapped.add_triangles(added)

    def cast_rays(self, rays: TensorLike, nthreads: int = 0) -> dict[str, Tensor]:
        return _tensors(self._wrapped.cast_rays(values_of(rays)))

    def test_occlusions(
        self, rays: TensorLike, tnear: float = 0.0, tfar: float = math.inf, nthreads: int = 0
    ) -> Tensor:
        return wrap(self._wrapped.test_occlusions(values_of(rays), tnear, tfar))

    def count_intersections(self, rays: TensorLike, nthreads: int = 0) -> Tensor:
        return wrap(self._wrapped.count_intersections(values_of(rays)))

    def list_intersections(self, rays: TensorLike, nthreads: int = 0) -> dict[str, Tensor]:
        return _tensors(self._wrapped.list_intersections(values_of(rays)))

    def compute_closest_points(self, query_points: TensorLike, nthreads: int = 0) -> dict[str, Tensor]:
        return _tensors(self._wrapped.compute_closest_points(values_of(query_points)))

    def compute_distance(self, query_points: TensorLike, nthreads: int = 0) -> Tensor:
        return wrap(self._wrapped.compute_distance(values_of(query_points)))

    def compute_signed_distance(self, query_points: TensorLike, nthreads: int = 0, nsamples: int = 1) -> Tensor:
        """Distances, negative inside."""
        return wrap(self._wrapped.compute_signed_distance(values_of(query_points), nsamples=nsamples))

    def compute_occupancy(self, query_points: TensorLike, nthreads: int = 0, nsamples: int = 1) -> Tensor:
        """1 inside, 0 outside."""
        return wrap(self._wrapped.compute_occupancy(values_of(query_points), nsamples=nsamples))

    @staticmethod
    def create_rays_pinhole(*args: Any, **kwargs: Any) -> Tensor:
        """Rays of a camera given by two matrices, or by fov_deg, center, eye and up; on the CPU."""
        named = {name: host_of(value) for name, value in kwargs.items()}
        return wrap(raycasting_scene.RaycastingScene.create_rays_pinhole(*map(host_of, args), **named))


def _tensors(arrays: dict[str, Any]) -> dict[str, Tensor]:
    return {name: wrap(array) for name, array in arrays.items()}
