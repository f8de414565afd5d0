"""Model: frame-to-model tracking with a voxel block grid."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from .....core.attribute_hints import KnownNames
from .....core.serialized import Serialized
from .....registration.rigid import invert_pose
from .....rgbd.odometry.options import OdometryMethod as Method
from ....argument_types import DeviceLike, TensorLike
from ....core.device import Device
from ....core.dtype import float32, uint16
from ....core.tensor import Tensor
from ... import geometry
from ..odometry.images import frame_of
from ..odometry.rgbd_odometry import (
    IDENTITY_POSE,
    OdometryConvergenceCriteria,
    OdometryLossParams,
    OdometryResult,
    align,
)
from ..tensors import as_matrix, on_host
from .frame import Frame

LEVEL_ITERATIONS = (6, 3, 1)  # the coarsest level first
SEEN_OFTEN = 3.0  # weight above which voxels are rendered


class Model(Serialized, KnownNames):
    """A grid, and the pose T_world_camera of the last frame: integrate, render from that pose, track the next frame.

    Odometry has Open3D's weights. `loom.rgbd.DenseSLAM` also detects failures and closes loops.
    """

    voxel_grid: Any
    frame_id: int
    _pose: Tensor

    def __init__(
        self,
        voxel_size: Any,
        block_resolution: int = 16,
        block_count: int = 10000,
        transformation: TensorLike = IDENTITY_POSE,
        device: DeviceLike = "CUDA:0",
    ):
        if isinstance(voxel_size, Model):
            vars(self).update(vars(voxel_size))
            return
        types, channels = (float32, uint16, uint16), ((1,), (1,), (3,))
        self.voxel_grid = geometry.VoxelBlockGrid(
            ("tsdf", "weight", "color"), types, channels, voxel_size, block_resolution, block_count, Device(device)
        )
        self.transformation_frame_to_world, self.frame_id = transformation, -1

    @property
    def transformation_frame_to_world(self) -> Tensor:
        """T_world_camera (4, 4), float64 on the CPU; assignable."""
        return self._pose

    @transformation_frame_to_world.setter
    def transformation_frame_to_world(self, pose: TensorLike) -> None:
        self._pose = as_matrix(pose)

    def get_current_frame_pose(self) -> Tensor:
        return self._pose

    def update_frame_pose(self, frame_id: int, T_frame_to_world: TensorLike) -> None:
        self.frame_id, self.transformation_frame_to_world = int(frame_id), T_frame_to_world

    def integrate(
        self,
        input_frame: Frame,
        depth_scale: float = 1000.0,
        depth_max: float = 3.0,
        trunc_voxel_multiplier: float = 8.0,
    ) -> None:
        """Integrate the maps "depth" and "color" of a frame at the current pose."""
        depth, color = input_frame.get_data_as_image("depth"), input_frame.get_data_as_image("color")
        camera = input_frame.intrinsics
        limits = depth_scale, depth_max, trunc_voxel_multiplier
        self.voxel_grid.integrate(None, depth, color, camera, self._extrinsic(), *limits)

    def synthesize_model_frame(
        self,
        model_frame: Frame,
        depth_scale: float = 1000.0,
        depth_min: float = 0.1,
        depth_max: float = 3.0,
        trunc_voxel_multiplier: float = 8.0,
        enable_color: bool = False,
        weight_threshold: float = -1.0,
    ) -> None:
        """Set the maps "depth" and, if enabled, "color" (otherwise zeros) as seen from the current pose.

        A negative threshold is 3, or the number of earlier frames if that is less.
        """
        threshold = min(float(self.frame_id), SEEN_OFTEN) if weight_threshold < 0 else weight_threshold
        height, width = model_frame.height(), model_frame.width()
        limits = depth_scale, depth_min, depth_max, max(threshold, 0.0), trunc_voxel_multiplier
        maps = self.voxel_grid.ray_cast(
            None, model_frame.intrinsics, self._extrinsic(), width, height, ("depth", "color"), *limits
        )
        model_frame.set_data("depth", maps["depth"])
        if enable_color:
            model_frame.set_data("color", maps["color"])
        elif not model_frame.has_data("color"):
            model_frame.set_data("color", Tensor(np.zeros((height, width, 3), np.float32)))

    def track_frame_to_model(
        self,
        input_frame: Frame,
        model_frame: Frame,
        depth_scale: float = 1000.0,
        depth_max: float = 3.0,
        depth_diff: float = 0.07,
        method: Method = Method.PointToPlane,
        criteria: Sequence[OdometryConvergenceCriteria] | None = None,
    ) -> OdometryResult:
        """The motion T_model_input of a frame relative to the rendered one. RuntimeError if it is not determined."""
        source, target = (
            frame_of(frame.get_data("color"), frame.get_data("depth"), depth_scale)
            for frame in (input_frame, model_frame)
        )
        levels = [OdometryConvergenceCriteria(steps) for steps in LEVEL_ITERATIONS] if criteria is None else criteria
        limits = OdometryLossParams(depth_diff)
        return align(source, target, model_frame.intrinsics, IDENTITY_POSE, depth_max, levels, method, limits)

    def extract_pointcloud(self, weight_threshold: float = 3.0, estimated_number: int = -1) -> Any:
        return self.voxel_grid.extract_point_cloud(weight_threshold, estimated_number)

    def extract_trianglemesh(self, weight_threshold: float = 3.0, estimated_number: int = -1) -> Any:
        return self.voxel_grid.extract_triangle_mesh(weight_threshold, estimated_number)

    def _extrinsic(self) -> Tensor:
        return as_matrix(invert_pose(on_host(self._pose)))
