"""The public names of pointloom.odometry: the one list of them, for type checkers and for `public_names`."""

from .alignment import align_frames as align_frames
from .frames import OdometryFrame as OdometryFrame
from .options import Method as Method
from .options import OdometryOption as OdometryOption
from .options import RGBDOdometryJacobianFromColorTerm as RGBDOdometryJacobianFromColorTerm
from .options import RGBDOdometryJacobianFromHybridTerm as RGBDOdometryJacobianFromHybridTerm
from .rgbd_odometry import compute_rgbd_odometry as compute_rgbd_odometry
