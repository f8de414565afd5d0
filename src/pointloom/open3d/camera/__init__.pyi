"""The names of `open3d.camera`."""

from ...cameras.camera import PinholeCameraIntrinsicParameters as PinholeCameraIntrinsicParameters
from .intrinsic import PinholeCameraIntrinsic as PinholeCameraIntrinsic
from .parameters import PinholeCameraParameters as PinholeCameraParameters
from .parameters import PinholeCameraTrajectory as PinholeCameraTrajectory
