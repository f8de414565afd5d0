"""Open3D's RGB-D odometry with its weights."""

from __future__ import annotations

from dataclasses import field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....rgbd.odometry import options, rgbd_odometry
from ...argument_types import CameraLike, FrameLike
from ...camera import PinholeCameraIntrinsic
from ...geometry import RGBDImage
from ...settings import Settings
from ...vectors import IntVector
from ...wrapper import IDENTITY_POSE, unwrap


class OdometryOption(Settings, of=options):
    iteration_number_per_pyramid_level: Any = field(default_factory=lambda: IntVector([20, 10, 5]))
    depth_diff_max: float = 0.03
    depth_min: float = 0.0
    depth_max: float = 4.0

    def __setattr__(self, name: str, value: Any) -> None:
        if name == "iteration_number_per_pyramid_level" and not isinstance(value, OdometryOption):
            value = IntVector(value)
        super().__setattr__(name, value)

    def native_keywords(self) -> dict[str, Any]:
        steps = list(self.iteration_number_per_pyramid_level)
        return super().native_keywords() | {"iteration_number_per_pyramid_level": steps}

    def __repr__(self) -> str:
        values = self.native_keywords()
        steps = "".join(f"{step}, " for step in values.pop("iteration_number_per_pyramid_level"))
        limits = "".join(f"{name}={value:g},\n" for name, value in values.items())
        return f"OdometryOption(\niteration_number_per_pyramid_level=[ {steps}] ,\n{limits})"


class RGBDOdometryJacobian(Settings):
    """Base class of the two terms."""


class RGBDOdometryJacobianFromColorTerm(RGBDOdometryJacobian, of=options):
    """Intensity only."""


class RGBDOdometryJacobianFromHybridTerm(RGBDOdometryJacobian, of=options):
    """Intensity and depth."""


def compute_rgbd_odometry(
    rgbd_source: FrameLike,
    rgbd_target: FrameLike,
    pinhole_camera_intrinsic: CameraLike | None = None,
    odo_init: ArrayLike = IDENTITY_POSE,
    jacobian: RGBDOdometryJacobian | None = None,
    option: OdometryOption | None = None,
) -> tuple[bool, NDArray[np.float64], NDArray[np.float64]]:
    """Motion between two images: (success, T_target_source, information).

    Uses Open3D's weights without reliability checks; `loom.rgbd.compute_rgbd_odometry` weights by noise and reports
    failures.
    """
    camera = PinholeCameraIntrinsic() if pinhole_camera_intrinsic is None else pinhole_camera_intrinsic
    term = RGBDOdometryJacobianFromHybridTerm() if jacobian is None else jacobian
    chosen = OdometryOption() if option is None else option
    return tuple(
        rgbd_odometry.open3d_odometry(
            unwrap(rgbd_source, RGBDImage, "rgbd_source"),
            unwrap(rgbd_target, RGBDImage, "rgbd_target"),
            unwrap(camera, PinholeCameraIntrinsic, "pinhole_camera_intrinsic"),
            odo_init,
            unwrap(term, RGBDOdometryJacobian, "jacobian"),
            unwrap(chosen, OdometryOption, "option"),
        )
    )
