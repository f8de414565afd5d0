"""Ray queries of a scene, and the rays of a pinhole camera."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import Form, form_of
from ...core.checks import check_number, check_numeric
from ...core.coordinates import quiet
from ...core.gpu_arrays import take_rays
from ...kernels.lang import float32
from ...kernels.memory import upload
from ...kernels.rays import ray_casting
from .pinhole_rays import pinhole_rays
from .scene_geometries import SceneGeometries

INVALID_ID = 0xFFFFFFFF
IDS: dict[str, Any] = dict.fromkeys(("geometry_ids", "primitive_ids"), np.uint32)


class SceneRays(SceneGeometries):
    """Methods of RaycastingScene that cast rays.

    A ray is (ox, oy, oz, dx, dy, dz): origin and direction. Parameter t is in units of the direction. Invalid rays hit
    nothing. Intersections are watertight (Woop, Benthin and Wald, JCGT 2013).
    """

    INVALID_ID = INVALID_ID

    def cast_rays(self, rays: ArrayLike) -> dict[str, NDArray[Any]]:
        """Find the first triangle that each ray hits.

        Ties in float32 t go to the lowest geometry, then triangle. Bitwise identical on every device.

        Args:
            rays: Shape (..., 6), float32 or float64.

        Returns:
            Arrays in the leading shape of the rays:
            t_hit: float32 (...), parameter >= 0, infinite without a hit.
            geometry_ids: uint32 (...), as returned by `add_triangles`. INVALID_ID without a hit.
            primitive_ids: uint32 (...), triangle index in its mesh. INVALID_ID without a hit.
            primitive_uvs: float32 (..., 2), weights of the second and third corner.
            primitive_normals: float32 (..., 3), unit normal by the right-hand rule; (0, 0, 0) without a hit.

        Raises:
            TypeError, ValueError: If the rays are not numeric or have another shape.

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            0
            >>> scene.cast_rays([0.2, 0.2, 4, 0, 0, -2])["t_hit"].item()
            2.0
        """
        flat, shape, form = self._device_rays(rays)
        if not len(self):
            return self._given_out(_missed(shape), form)
        hits, normals = ray_casting.cast_rays(self._scene_trees(), flat)
        return form.hand_out_all(_named(hits) | {"primitive_normals": normals}, IDS, shape=shape)

    def test_occlusions(self, rays: ArrayLike, tnear: float = 0.0, tfar: float = math.inf) -> NDArray[np.bool_]:
        """Test whether rays hit anything. Returns bool (...).

        Args:
            rays: Shape (..., 6), float32 or float64.
            tnear, tfar: Range of the parameter.

        Raises:
            TypeError, ValueError: If the rays are not numeric or have another shape, or a limit is negative.

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            0
            >>> scene.test_occlusions([[0.2, 0.2, 4, 0, 0, -1]], tfar=3).tolist()
            [False]
        """
        flat, shape, form = self._device_rays(rays)
        nearest = check_number("tnear", tnear, allow_infinite=True)
        farthest = check_number("tfar", tfar, allow_infinite=True)
        for name, limit in (("tnear", nearest), ("tfar", farthest)):
            if limit < 0:
                raise ValueError(f"{name}: expected 0 or more, got {limit}")
        if not len(self) or farthest < nearest:
            return form.hand_out_host(np.zeros(shape, np.bool_), self._device)
        with quiet():
            limits = float(np.float32(nearest)), float(np.float32(farthest))
        occluded = ray_casting.test_occlusions(self._scene_trees(), flat, *limits)
        return form.hand_out(occluded, dtype=np.bool_, shape=shape)

    def count_intersections(self, rays: ArrayLike) -> NDArray[np.int32]:
        """Count the intersections of each ray, int32 (...); those of one geometry at the same float32 t count once.

        Args:
            rays: Shape (..., 6), float32 or float64.

        Raises:
            TypeError, ValueError: If the rays are not numeric or have another shape.

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 3, 2]])
            0
            >>> scene.count_intersections([[0.5, 0.5, 1, 0, 0, -1]]).tolist()
            [1]
        """
        flat, shape, form = self._device_rays(rays)
        if not len(self):
            return form.hand_out_host(np.zeros(shape, np.int32), self._device)
        return form.hand_out(ray_casting.count_hits(self._scene_trees(), flat), shape=shape)

    def list_intersections(self, rays: ArrayLike) -> dict[str, NDArray[Any]]:
        """List all intersections of each ray, merged as in `count_intersections` (lowest triangle kept).

        Args:
            rays: Shape (..., 6), float32 or float64.

        Returns:
            Arrays with one row per intersection, sorted by ray, t and geometry:
            ray_splits: uint32 (rays + 1,), start of each ray's intersections.
            ray_ids: uint32 (k,), index of the ray, leading axes flattened.
            t_hit, geometry_ids, primitive_ids, primitive_uvs: As of `cast_rays`.

        Raises:
            TypeError, ValueError: If the rays are not numeric or have another shape.

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            0
            >>> found = scene.list_intersections([[0.2, 0.2, 1, 0, 0, 1], [0.2, 0.2, 1, 0, 0, -1]])
            >>> found["ray_splits"].tolist(), found["ray_ids"].tolist()
            ([0, 0, 1], [1])
        """
        flat, _, form = self._device_rays(rays)
        if not len(self):
            return self._given_out(_no_intersections(flat.size // 6), form)
        hits, ray_ids, splits = ray_casting.list_hits(self._scene_trees(), flat)
        numbers = {"ray_splits": splits, "ray_ids": ray_ids}
        return form.hand_out_all(numbers | _named(hits), IDS | dict.fromkeys(numbers, np.uint32))

    @staticmethod
    def create_rays_pinhole(*args: Any, **kwargs: Any) -> NDArray[Any]:
        """Create the rays of a pinhole camera through its pixel centers, from two matrices or from a view.

        Args:
            intrinsic_matrix: Shape (3, 3), upper triangular.
            extrinsic_matrix: Shape (4, 4), scene to camera.
            width_px, height_px: Image size.
            fov_deg: Horizontal field of view [degrees], between 0 and 180.
            center, eye: Target point and camera position, (3,).
            up: Direction of increasing rows, (3,): as in Open3D the first row is the lowest.

        Returns:
            Rays for `cast_rays`, shape (height_px, width_px, 6); float32, or float64 if the camera is more than 128 m
            from zero. Directions are scaled so that t is the depth along the camera axis.

        Raises:
            TypeError: If neither both matrices nor `fov_deg`, `center`, `eye` and `up` are given, with a size.
            ValueError: If a matrix is singular, the field of view is out of range, or the view direction is undefined.

        Example:
            >>> import pointloom as loom
            >>> rays = loom.RaycastingScene.create_rays_pinhole(
            ...     fov_deg=90, center=[0, 0, 0], eye=[0, 0, 2], up=[0, 1, 0], width_px=2, height_px=2
            ... )
            >>> rays[0, 0].tolist()
            [0.0, 0.0, 2.0, 0.5, -0.5, -1.0]
        """
        return pinhole_rays(*args, **kwargs)

    def _given_out(self, values: dict[str, NDArray[Any]], form: Form) -> dict[str, Any]:
        return {name: form.hand_out_host(array, self._device) for name, array in values.items()}

    def _device_rays(self, rays: ArrayLike) -> tuple[wp.array, tuple[int, ...], Form]:
        """(rays about the scene's origin as float32 (6 n,), leading shape, input form)."""
        form = form_of(rays)
        if not form.on_host:
            return *take_rays(rays, self._origin, self._device), form
        given = check_numeric("rays", rays)
        if given.ndim == 0 or given.shape[-1] != 6:
            raise ValueError(f"rays: expected shape [..., 6], got {list(given.shape)}")
        flat, origin = given.reshape(-1, 6), self._origin
        if origin.any():
            flat = np.hstack([flat[:, :3].astype(np.float64) - origin, flat[:, 3:]])
        with quiet():  # float32 overflow is infinite and hits nothing
            flat = np.ascontiguousarray(flat, np.float32)
        return upload(flat.ravel(), float32, self._device, copied=False), given.shape[:-1], form


def _named(hits: ray_casting.RayHits) -> dict[str, Any]:
    return {"t_hit": hits.t_hit} | {name: getattr(hits, name) for name in (*IDS, "primitive_uvs")}


def _missed(shape: tuple[int, ...]) -> dict[str, NDArray[Any]]:
    return {
        "t_hit": np.full(shape, np.inf, np.float32),
        "geometry_ids": np.full(shape, INVALID_ID, np.uint32),
        "primitive_ids": np.full(shape, INVALID_ID, np.uint32),
        "primitive_uvs": np.zeros((*shape, 2), np.float32),
        "primitive_normals": np.zeros((*shape, 3), np.float32),
    }


def _no_intersections(count: int) -> dict[str, NDArray[Any]]:
    nothing = {name: values for name, values in _missed((0,)).items() if name != "primitive_normals"}
    return {"ray_splits": np.zeros(count + 1, np.uint32), "ray_ids": np.zeros(0, np.uint32)} | nothing
