"""The public names of pointloom.odometry: the one list of them, for type checkers and for `public_names`."""

from .alignment import align_frames as align_frames
from .frames import OdometryFrame as OdometryFrame
from .options import Method as Method
from .options import OdometryConvergenceCriteria as OdometryConvergenceCriteria
from .options import OdometryLossParams as OdometryLossParams
from .options import OdometryOption as OdometryOption
from .options import RGBDOdometryJacobianFromColorTerm as RGBDOdometryJacobianFromColorTerm
from .options import RGBDOdometryJacobianFromHybridTerm as RGBDOdometryJacobianFromHybridTerm
from .rgbd_odometry import compute_odometry_information_matrix as compute_odometry_information_matrix
from .rgbd_odometry import compute_rgbd_odometry as compute_rgbd_odometry
from .rgbd_odometry import rgbd_odometry_multi_scale as rgbd_odometry_multi_scale
