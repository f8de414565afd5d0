"""Clouds from depth images, and depth images of clouds."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..cameras.camera import PinholeCameraIntrinsic, check_pixels
from ..cameras.depth_doubts import warn_of_scale
from ..cameras.images import RGBDImage, check_intrinsic, upload_depth
from ..core.array_libraries import hand_out, library_of
from ..core.checks import check_count, check_positive, check_rigid
from ..core.coordinates import origin_of_sensor
from ..core.gpu_arrays import device_for
from ..core.told_arguments import told_arguments
from ..kernels.images.depth import PixelGrid, color_pixels, pixel_normals, unproject_depth
from ..kernels.images.depth_projection import project_points, read_colors, read_depth
from ..kernels.linear_algebra import inv, matmul
from .selection import Selection

NOBODY_MEASURES = 1000.0  # [m] and more, by a depth camera
OTHER_UNIT = 30.0  # times the farthest depth kept: a limit cuts off less


class DepthClouds(Selection):
    """The part of PointCloud that deals with depth images."""

    @classmethod
    @told_arguments
    def create_from_depth_image(
        cls,
        depth: ArrayLike,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        depth_scale: float | None = None,
        depth_trunc: float = 1000.0,
        stride: int = 1,
        project_valid_depth_only: bool = True,
        *,
        with_normals: bool = False,
        device: Any = None,
    ) -> Self:
        """The points of a depth image, row by row.

        Args:
            depth: Shape [h, w]; integers of 16 bits and more, or floats.
            intrinsic: The camera, of the image's size.
            extrinsic: T_camera_world, shape [4, 4]; None for the identity.
            depth_scale: Units of depth a metre; None for 1000 of integers and 1 of floats.
            depth_trunc: Farthest depth kept [m] (Open3D drops it itself), also for float depth (Open3D ignores it
                there).
            stride: Takes every stride-th pixel of every stride-th row.
            project_valid_depth_only: False keeps the grid: NaN points where there is no depth, `cloud.grid` set.
            with_normals: Adds unit normals towards the camera, from the differences to the next points of the grid
                to the right and below; see `create_normal_map`. Points without one (beside holes, and the last row
                and column) are dropped, or get NaN where the grid is kept. Open3D's tensor form blurs the depth
                first, across edges too; do that with `filter_depth_bilateral`, which does not, or `pyrdown_depth`.
            device: Where the cloud goes; None for the GPU that the depth lies on, else the CPU.

        Raises:
            ValueError: Wrong shapes, sizes that disagree, an extrinsic that is no rigid motion.
        """
        where = device_for(depth, device)
        metric, scale, height, width = upload_depth(depth, depth_scale, depth_trunc, where, limit="depth_trunc")
        camera = check_intrinsic(intrinsic, width, height)
        times = 1.0 if depth_trunc >= NOBODY_MEASURES else OTHER_UNIT
        warn_of_scale(depth, scale, depth_trunc, times=times)
        cloud = cls._from_device_depth(metric, None, camera, extrinsic, stride, project_valid_depth_only, with_normals)
        cloud._library = library_of(depth)
        return cloud

    @classmethod
    @told_arguments
    def create_from_rgbd_image(
        cls,
        image: RGBDImage,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        project_valid_depth_only: bool = True,
        *,
        stride: int = 1,
        with_normals: bool = False,
    ) -> Self:
        """The coloured points of an RGB-D image, grey where it holds brightness.

        Arguments as in `create_from_depth_image`.
        """
        if not isinstance(image, RGBDImage):
            raise TypeError(f"image: expected an RGBDImage, got {type(image).__name__}")
        camera = check_intrinsic(intrinsic, image.width, image.height)
        cloud = cls._from_device_depth(
            image.depth_array, image.color_array, camera, extrinsic, stride, project_valid_depth_only, with_normals
        )
        cloud._library = image.array_library
        return cloud

    def project_to_depth_image(
        self,
        width: int,
        height: int,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        depth_scale: float = 1.0,
        depth_max: float = 3.0,
    ) -> NDArray[np.float32]:
        """What a depth camera would measure of the cloud: the depth of the nearest point in each pixel.

        Args:
            width: Columns of the image [px].
            height: Rows of the image [px].
            intrinsic: The camera, of that size.
            extrinsic: T_camera_world, shape [4, 4]; None for the identity.
            depth_scale: Units of the result a metre; 1000 for millimetres. `create_from_depth_image` with the same one
                gives the points back.
            depth_max: Farthest depth that is seen [m].

        Returns:
            Depth times `depth_scale`, float32 [height, width]; 0 where no point is seen. Rounded to whole numbers
            it is what a 16-bit depth map holds.

        Raises:
            ValueError: Wrong sizes, numbers out of range, an extrinsic that is no rigid motion.

        Notes:
            Open3D's tensor form, whose depth_scale is 1000 by default. A point is seen in the pixel whose centre is
            nearest; there are no surfaces between points. A depth image comes back whole from its own cloud. 8 B of
            memory a pixel; same bits from run to run.

        Example:
            >>> import pointloom as loom
            >>> camera = loom.PinholeCameraIntrinsic(3, 2, 1.0, 1.0, 1.0, 0.0)
            >>> loom.PointCloud([[0, 0, 2], [2, 2, 2], [0, 0, 1]]).project_to_depth_image(3, 2, camera)
            array([[0., 1., 0.],
                   [0., 0., 2.]], dtype=float32)
        """
        scale = check_positive("depth_scale", depth_scale)
        words, rows, columns = self._project(width, height, intrinsic, extrinsic, depth_max)
        return hand_out(read_depth(words, scale), self._library, shape=(rows, columns))

    def project_to_rgbd_image(
        self,
        width: int,
        height: int,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None = None,
        *,
        depth_max: float = 3.0,
    ) -> RGBDImage:
        """What an RGB-D camera would measure of the cloud: depth and 8-bit colour of the nearest point in each pixel.

        Arguments as in `project_to_depth_image`, without a depth_scale (which Open3D's tensor form has): an RGBDImage
        holds metres.

        Raises:
            ValueError: As there, or the cloud has no colours.
        """
        colors = self._required_array("colors", "assign cloud.colors, or use project_to_depth_image")
        words, rows, columns = self._project(width, height, intrinsic, extrinsic, depth_max)
        return RGBDImage._from_device_arrays(
            read_colors(words, colors), read_depth(words), rows, columns, self._library
        )

    # ------------------------------------------------------------------------------------------ internals

    @classmethod
    def _from_device_depth(
        cls,
        depth: wp.array,
        color: wp.array | None,
        camera: PinholeCameraIntrinsic,
        extrinsic: ArrayLike | None,
        stride: int,
        valid_only: bool,
        with_normals: bool,
    ) -> Self:
        """Points of depth in metres that is on the device, float32 [h * w], and of colours [h * w, 3]."""
        step = check_count("stride", stride)
        T_world_camera = np.eye(4) if extrinsic is None else inv(check_rigid("extrinsic", extrinsic))
        origin = origin_of_sensor(T_world_camera[:3, 3])
        local = T_world_camera.copy()
        local[:3, 3] -= origin
        grid = PixelGrid(camera.width, camera.height, step)
        points, valid = unproject_depth(depth, grid, camera, local)
        arrays = {"points": points}
        if with_normals:
            normals, valid = pixel_normals(depth, grid, camera, local[:3, :3])
            arrays["normals"] = normals
        if color is not None:
            arrays["colors"] = color_pixels(color, grid)
        cloud = cls._from_device_arrays(arrays, origin)
        if valid_only:
            return cloud._select_mask(valid)
        cloud.grid = (grid.rows, grid.columns)
        return cloud

    def _project(
        self, width: int, height: int, intrinsic: Any, extrinsic: ArrayLike | None, depth_max: float
    ) -> tuple[wp.array, int, int]:
        """What each pixel sees (see project_points), rows and columns."""
        columns, rows = check_pixels("width", width), check_pixels("height", height)
        camera = check_intrinsic(intrinsic, columns, rows)
        farthest = check_positive("depth_max", depth_max, allow_infinite=True)
        T_camera_world = np.eye(4) if extrinsic is None else check_rigid("extrinsic", extrinsic)
        T_camera_points = T_camera_world.copy()
        T_camera_points[:3, 3] += matmul(T_camera_world[:3, :3], self._origin)
        return project_points(self._arrays["points"], T_camera_points, camera, farthest), rows, columns
