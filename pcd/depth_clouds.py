"""Clouds from depth images."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from ..kernels.depth import color_pixels, unproject_depth
from .camera import PinholeCameraIntrinsic
from .checks import check_count, check_rigid
from .coordinates import split_origin
from .devices import resolve_device
from .images import RGBDImage, check_intrinsic, upload_depth
from .selection import Selection


class DepthClouds(Selection):
    """The part of PointCloud that deals with depth images."""

    @classmethod
    def from_depth_image(
        cls,
        depth: ArrayLike,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        depth_scale: float = 1000.0,
        depth_trunc: float = 1000.0,
        stride: int = 1,
        project_valid_depth_only: bool = True,
        *,
        device: Any = None,
    ) -> Self:
        """The points of a depth image, row by row.

        Args:
            depth: Shape [h, w]; integers are divided by `depth_scale`, floats are metres.
            intrinsic: The camera, of the image's size.
            extrinsic: T_camera_world, shape [4, 4]; None for the identity.
            depth_scale: Integer units a metre.
            depth_trunc: Farthest depth kept [m] (Open3D drops it itself), also for float depth (Open3D ignores it
                there).
            stride: Takes every stride-th pixel of every stride-th row.
            project_valid_depth_only: False keeps the grid: NaN points where there is no depth, `cloud.grid` set.
            device: Where the cloud goes.

        Raises:
            ValueError: Wrong shapes, sizes that disagree, an extrinsic that is no rigid motion.
        """
        where = resolve_device(device)
        metric, _, height, width = upload_depth(depth, depth_scale, depth_trunc, where, limit="depth_trunc")
        return cls._unproject(metric, None, height, width, intrinsic, extrinsic, stride, project_valid_depth_only)

    @classmethod
    def from_rgbd_image(
        cls,
        image: RGBDImage,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        project_valid_depth_only: bool = True,
        *,
        stride: int = 1,
    ) -> Self:
        """The coloured points of an RGB-D image; arguments as in `from_depth_image`."""
        size = (image.height, image.width)
        return cls._unproject(image._depth, image._color, *size, intrinsic, extrinsic, stride, project_valid_depth_only)

    # ------------------------------------------------------------------------------------------ internals

    @classmethod
    def _unproject(cls, depth, color, height, width, intrinsic, extrinsic, stride, valid_only) -> Self:
        camera = check_intrinsic(intrinsic, width, height)
        step = check_count("stride", stride)
        T_world_camera = np.eye(4)
        if extrinsic is not None:
            T_world_camera = np.linalg.inv(check_rigid("extrinsic", extrinsic))
        _, origin = split_origin(T_world_camera[None, :3, 3])
        local = T_world_camera.copy()
        local[:3, 3] -= origin
        focal = (camera.fx, camera.fy, camera.cx, camera.cy)
        points, valid, rows, columns = unproject_depth(depth, width, height, step, focal, local)
        arrays = {"points": points}
        if color is not None:
            arrays["colors"] = color_pixels(color, width, rows, columns, step)
        cloud = cls._from_arrays(arrays, origin)
        if valid_only:
            return cloud._select_mask(valid)
        cloud.grid = (rows, columns)
        return cloud
