"""The names of `open3d.t.pipelines.odometry`."""

from .rgbd_odometry import Hybrid as Hybrid
from .rgbd_odometry import Intensity as Intensity
from .rgbd_odometry import Method as Method
from .rgbd_odometry import OdometryConvergenceCriteria as OdometryConvergenceCriteria
from .rgbd_odometry import OdometryLossParams as OdometryLossParams
from .rgbd_odometry import OdometryResult as OdometryResult
from .rgbd_odometry import PointToPlane as PointToPlane
from .rgbd_odometry import compute_odometry_information_matrix as compute_odometry_information_matrix
from .rgbd_odometry import rgbd_odometry_multi_scale as rgbd_odometry_multi_scale
