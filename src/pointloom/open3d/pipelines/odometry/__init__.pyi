"""The names of `open3d.pipelines.odometry`."""

from .rgbd_odometry import OdometryOption as OdometryOption
from .rgbd_odometry import RGBDOdometryJacobian as RGBDOdometryJacobian
from .rgbd_odometry import RGBDOdometryJacobianFromColorTerm as RGBDOdometryJacobianFromColorTerm
from .rgbd_odometry import RGBDOdometryJacobianFromHybridTerm as RGBDOdometryJacobianFromHybridTerm
from .rgbd_odometry import compute_rgbd_odometry as compute_rgbd_odometry
