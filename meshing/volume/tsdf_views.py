"""Pictures of a TSDFVolume as a camera would see them: for users on the host, for tracking on the device."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.array_libraries import hand_out
from ...core.checks import check_positive
from ...kernels.arrays.origins import add_origin
from ...kernels.images.depth import BLUE, GREEN, RED
from ...kernels.volumes.block_rows import SeenBlocks
from ...kernels.volumes.ray_images import RayImages
from ...kernels.volumes.tsdf_raycast import cast_rays


@dataclass(frozen=True)
class RayCast:
    """Pictures of a surface as a camera sees it, arrays of the library that the volume's frames came in.

    Attributes:
        depth: float32 [h, w] along z [m]; 0 where no surface is seen.
        points: float64 [h, w, 3], world coordinates [m]; NaN where no surface is seen.
        normals: float32 [h, w, 3], towards the side that the cameras saw; NaN likewise, and at the rim of the surface.
        colors: float32 [h, w, 3] in 0..1, or None where the frames had none.
    """

    depth: NDArray[np.float32]
    points: NDArray[np.float64]
    normals: NDArray[np.float32]
    colors: NDArray[np.float32] | None


@dataclass(frozen=True)
class RenderedMaps:
    """What a camera sees of a volume, by pixel, on the device: nothing of it was on the host.

    Attributes:
        depth: float32 [h * w] along z [m]; 0 where no surface is seen.
        normals: vec3 [h * w], unit, in the camera's frame, towards the camera's side of the surface; NaN where no
            surface is seen, and at its rim. None where they were not asked for.
        intensity: float32 [h * w], brightness 0..1 of the mean colour, trilinear among the voxels around; 0 where no
            surface is seen. None where the frames had no colour.
        intrinsic: The camera.
    """

    depth: wp.array
    normals: wp.array | None
    intensity: wp.array | None
    intrinsic: PinholeCameraIntrinsic


def check_view(intrinsic: Any, depth_min: float, depth_max: float, weight_threshold: float) -> tuple[float, ...]:
    """The checked limits (near, far, threshold) of a view.

    Raises:
        ValueError: Limits that are not 0 < depth_min < depth_max, or a negative threshold.
        TypeError: An intrinsic of another type.
    """
    near, far = check_positive("depth_min", depth_min), check_positive("depth_max", depth_max)
    if near >= far:
        raise ValueError(f"depth_min: expected less than depth_max, got {depth_min} and {depth_max}")
    threshold = check_positive("weight_threshold", weight_threshold, allow_zero=True)
    if not isinstance(intrinsic, PinholeCameraIntrinsic):
        raise TypeError(f"intrinsic: expected a PinholeCameraIntrinsic, got {type(intrinsic).__name__}")
    return near, far, threshold


def cast_view(
    seen: SeenBlocks,
    camera: PinholeCameraIntrinsic,
    T: Any,
    limits: tuple[float, float],
    origin: Any,
    colored: bool,
    library: str,
) -> RayCast:
    """What a camera sees, in arrays of a library."""
    images = RayImages(camera.width * camera.height, seen.neighbors.device, points=True, colors=colored)
    cast_rays(seen, camera, T, limits[0], limits[1], images)
    shape = (camera.height, camera.width)
    return RayCast(
        hand_out(images.depth, library, shape=shape),
        hand_out(add_origin(images.points, origin), library, shape=shape),
        hand_out(images.normals, library, shape=shape),
        hand_out(images.colors, library, shape=shape) if colored else None,
    )


def render_colors(
    seen: SeenBlocks, camera: PinholeCameraIntrinsic, T: Any, limits: tuple[float, float]
) -> tuple[wp.array, wp.array]:
    """Depth, float32 [h * w], and colours, vec3 [h * w], as a camera sees them, on the device."""
    images = RayImages(camera.width * camera.height, seen.neighbors.device, normals=False, colors=True)
    cast_rays(seen, camera, T, limits[0], limits[1], images)
    return images.depth, images.colors


def render_maps(
    seen: SeenBlocks, camera: PinholeCameraIntrinsic, T: Any, limits: tuple[float, float], colored: bool, normals: bool
) -> RenderedMaps:
    """What a camera sees, for tracking."""
    shares = (RED, GREEN, BLUE) if colored else None
    count = camera.width * camera.height
    images = RayImages(count, seen.neighbors.device, normals=normals, shares=shares, in_camera=True)
    cast_rays(seen, camera, T, limits[0], limits[1], images)
    made = images.normals if normals else None
    return RenderedMaps(images.depth, made, images.intensities if colored else None, camera)
