"""Color map optimization of a mesh from posed RGB-D images."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ....cameras.trajectory import Trajectory
from ....meshing.color_map import optimizers, options
from ...argument_types import FrameLike, MeshLike
from ...camera import PinholeCameraParameters, PinholeCameraTrajectory
from ...geometry import RGBDImage, TriangleMesh
from ...settings import Settings
from ...wrapper import unwrap


class RigidOptimizerOption(Settings):
    """Options of `run_rigid_optimizer`. Nothing is written to `debug_output_dir`."""

    _kind = options.ColorMapOption
    maximum_iteration: Any = 0
    maximum_allowable_depth: float = 2.5
    depth_threshold_for_visibility_check: float = 0.03
    depth_threshold_for_discontinuity_check: float = 0.1
    half_dilation_kernel_size_for_discontinuity_map: int = 3
    image_boundary_margin: int = 10
    invisible_vertex_color_knn: int = 3
    debug_output_dir: str = ""

    def native_keywords(self) -> dict[str, Any]:
        values = super().native_keywords()
        if values.pop("debug_output_dir"):
            raise ValueError("debug_output_dir: intermediate results are not written; leave it empty")
        return values


class NonRigidOptimizerOption(RigidOptimizerOption):
    number_of_vertical_anchors: int = 16
    non_rigid_anchor_point_weight: float = 0.316

    def __init__(
        self,
        number_of_vertical_anchors: int = 16,
        non_rigid_anchor_point_weight: float = 0.316,
        maximum_iteration: int = 0,
        *others: Any,
        **named: Any,
    ):
        self.number_of_vertical_anchors = number_of_vertical_anchors
        self.non_rigid_anchor_point_weight = non_rigid_anchor_point_weight
        super().__init__(maximum_iteration, *others, **named)


def run_rigid_optimizer(
    mesh: MeshLike,
    images_rgbd: Iterable[FrameLike],
    camera_trajectory: PinholeCameraTrajectory,
    option: RigidOptimizerOption,
) -> tuple[TriangleMesh, PinholeCameraTrajectory]:
    """Color a mesh with optimized poses. Returns the mesh and the cameras."""
    chosen = unwrap(option, RigidOptimizerOption, "option")
    return _run("rigid", mesh, images_rgbd, camera_trajectory, chosen)


def run_non_rigid_optimizer(
    mesh: MeshLike,
    images_rgbd: Iterable[FrameLike],
    camera_trajectory: PinholeCameraTrajectory,
    option: NonRigidOptimizerOption,
) -> tuple[TriangleMesh, PinholeCameraTrajectory]:
    """Like `run_rigid_optimizer`, with image deformation."""
    chosen = unwrap(option, NonRigidOptimizerOption, "option")
    return _run("non-rigid", mesh, images_rgbd, camera_trajectory, chosen)


def _run(
    method: str, mesh: MeshLike, images: Iterable[FrameLike], cameras: PinholeCameraTrajectory, option: Any
) -> tuple[TriangleMesh, PinholeCameraTrajectory]:
    parameters = list(cameras.parameters)
    poses = Trajectory(np.array([np.linalg.inv(one.extrinsic) for one in parameters], np.float64).reshape(-1, 4, 4))
    unwrapped = [unwrap(image, RGBDImage, f"images_rgbd[{i}]") for i, image in enumerate(images)]
    intrinsics = [unwrap(one.intrinsic) for one in parameters]
    given = unwrap(mesh, TriangleMesh, "mesh"), unwrapped, poses, option
    colored, moved = optimizers.optimize_color_map(*given, intrinsic=intrinsics, method=method)
    optimized = PinholeCameraTrajectory()
    optimized.parameters = [
        _parameters(one, np.linalg.inv(pose)) for one, pose in zip(parameters, moved.poses, strict=True)
    ]
    return TriangleMesh.from_native(colored), optimized


def _parameters(given: PinholeCameraParameters, extrinsic: ArrayLike) -> PinholeCameraParameters:
    made = PinholeCameraParameters()
    made.intrinsic, made.extrinsic = given.intrinsic, extrinsic
    return made
