"""PinholeCameraParameters and PinholeCameraTrajectory. Extrinsics are world to camera, inverse to pointloom's poses."""

from __future__ import annotations

import copy
from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.trajectory import Trajectory
from ...core.attribute_hints import KnownNames
from ...core.checks import check_shape
from ..argument_types import CameraLike
from .intrinsic import PinholeCameraIntrinsic


class PinholeCameraParameters(KnownNames):
    """Assignable `intrinsic` and `extrinsic` (4x4, world to camera).

    The initial extrinsic is the identity (in Open3D uninitialized memory).
    """

    def __init__(self, other: PinholeCameraParameters | None = None):
        self._intrinsic = PinholeCameraIntrinsic() if other is None else copy.copy(other.intrinsic)
        self._extrinsic = np.eye(4) if other is None else other.extrinsic

    @property
    def intrinsic(self) -> PinholeCameraIntrinsic:
        return self._intrinsic

    @intrinsic.setter
    def intrinsic(self, value: CameraLike) -> None:
        self._intrinsic = PinholeCameraIntrinsic(value)

    @property
    def extrinsic(self) -> NDArray[np.float64]:
        """World to camera, shape (4, 4), read-only array; assignable."""
        matrix = self._extrinsic.copy()
        matrix.flags.writeable = False
        return matrix

    @extrinsic.setter
    def extrinsic(self, values: ArrayLike) -> None:
        self._extrinsic = check_shape("extrinsic", values, (4, 4)).astype(np.float64)

    def __repr__(self) -> str:
        return "PinholeCameraParameters class.\nAccess its data via intrinsic and extrinsic."


class PinholeCameraTrajectory(KnownNames):
    """`parameters`: an assignable list of cameras. Appended ones are kept (Open3D drops them)."""

    def __init__(self, other: PinholeCameraTrajectory | None = None):
        self._parameters = [] if other is None else [PinholeCameraParameters(one) for one in other.parameters]

    @property
    def parameters(self) -> list[PinholeCameraParameters]:
        return self._parameters

    @parameters.setter
    def parameters(self, values: Iterable[PinholeCameraParameters]) -> None:
        self._parameters = [PinholeCameraParameters(value) for value in values]

    @classmethod
    def from_native(cls, trajectory: Trajectory, intrinsic: CameraLike) -> PinholeCameraTrajectory:
        """Cameras from poses (camera to world)."""
        made = cls()
        for pose in trajectory.poses:
            one = PinholeCameraParameters()
            one.intrinsic, one.extrinsic = intrinsic, np.linalg.inv(pose)
            made.parameters.append(one)
        return made

    @property
    def native(self) -> Trajectory:
        """Poses, camera to world."""
        extrinsics = np.array([one.extrinsic for one in self._parameters], np.float64)
        poses: NDArray[np.float64] = np.linalg.inv(extrinsics.reshape(-1, 4, 4)).astype(np.float64)
        return Trajectory(poses)

    def __repr__(self) -> str:
        return "PinholeCameraTrajectory class.\nAccess its data via camera.parameters."
