"""Rendering of a TSDFVolume, on the host for users and on the device for tracking."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...core.array_libraries import hand_out
from ...core.checks import check_positive
from ...kernels.arrays.origins import add_origin
from ...kernels.images.depth import BLUE_WEIGHT, GREEN_WEIGHT, RED_WEIGHT
from ...kernels.volumes.block_rows import SeenBlocks
from ...kernels.volumes.ray_images import RayImages
from ...kernels.volumes.tsdf_raycast import cast_rays

Matrix = NDArray[np.float64]

ARRAYS = ("depth", "points", "normals", "colors")  # of a RayCast


class RayCast:
    """Rendered surface, in arrays of the frames' library. An array is copied from a GPU when it is first read.

    Attributes:
        depth: float32 (h, w) along z [m]. 0 without surface.
        points: float64 (h, w, 3), world coordinates [m]. NaN without surface.
        normals: float32 (h, w, 3), toward the observed side. NaN without surface and at its border.
        colors: float32 (h, w, 3) in 0..1, or None.
    """

    depth: NDArray[np.float32]
    points: NDArray[np.float64]
    normals: NDArray[np.float32]
    colors: NDArray[np.float32] | None

    def __init__(self, images: RayImages, camera: PinholeCameraIntrinsic, origin: Matrix, library: str) -> None:
        self._images, self._origin, self._library = images, origin, library
        self._shape = camera.height, camera.width

    def __getattr__(self, name: str) -> Any:
        """An array that has not been read before."""
        if name not in ARRAYS:
            raise AttributeError(f"RayCast has no attribute {name!r}, only {', '.join(ARRAYS)}")
        values: Any = None if name == "colors" and not self._images.has_colors else getattr(self._images, name)
        if name == "points":
            values = add_origin(values, self._origin)
        self.__dict__[name] = None if values is None else hand_out(values, self._library, shape=self._shape)
        return self.__dict__[name]

    def __repr__(self) -> str:
        height, width = self._shape
        return f"RayCast of {width} x {height} pixels"

    def __getstate__(self) -> dict[str, Any]:
        return {"_shape": self._shape} | {name: getattr(self, name) for name in ARRAYS}


@dataclass(frozen=True)
class RenderedMaps:
    """Rendered surface on the device. `depth` float32 (h * w,) along z [m], 0 without surface; `normals` vec3 (h * w,),
    unit, camera frame, toward the camera, NaN without surface and at its border, or None; `intensity` float32 (h * w,)
    0..1, trilinear, or None."""

    depth: wp.array
    normals: wp.array | None
    intensity: wp.array | None
    intrinsic: PinholeCameraIntrinsic


def check_view(intrinsic: object, depth_min: float, depth_max: float, weight_threshold: float) -> tuple[float, ...]:
    near, far = check_positive("depth_min", depth_min), check_positive("depth_max", depth_max)
    if near >= far:
        raise ValueError(f"depth_min: expected less than depth_max, got {depth_min} and {depth_max}")
    threshold = check_positive("weight_threshold", weight_threshold, allow_zero=True)
    check_camera("intrinsic", intrinsic)
    return near, far, threshold


def cast_view(
    seen: SeenBlocks,
    camera: PinholeCameraIntrinsic,
    T: Matrix,
    limits: tuple[float, float],
    origin: Matrix,
    colored: bool,
    library: str,
) -> RayCast:
    images = RayImages(camera.width * camera.height, seen.neighbors.device, points=True, colors=colored)
    cast_rays(seen, camera, T, limits[0], limits[1], images)
    return RayCast(images, camera, origin, library)


def render_colors(
    seen: SeenBlocks, camera: PinholeCameraIntrinsic, T: NDArray[np.float64], limits: tuple[float, float]
) -> tuple[wp.array, wp.array]:
    """Depth, float32 (h * w,), and colors, vec3 (h * w,), on the device."""
    images = RayImages(camera.width * camera.height, seen.neighbors.device, normals=False, colors=True)
    cast_rays(seen, camera, T, limits[0], limits[1], images)
    return images.depth, images.colors


def render_maps(
    seen: SeenBlocks,
    camera: PinholeCameraIntrinsic,
    T: Matrix,
    limits: tuple[float, float],
    colored: bool,
    normals: bool,
) -> RenderedMaps:
    fractions = (RED_WEIGHT, GREEN_WEIGHT, BLUE_WEIGHT) if colored else None
    count = camera.width * camera.height
    images = RayImages(count, seen.neighbors.device, normals=normals, fractions=fractions, in_camera=True)
    cast_rays(seen, camera, T, limits[0], limits[1], images)
    made = images.normals if normals else None
    return RenderedMaps(images.depth, made, images.intensities if colored else None, camera)
