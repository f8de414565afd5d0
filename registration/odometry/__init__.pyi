"""The public names of pointloom.odometry: the one list of them, for type checkers and for `public_names`."""

from .alignment import Method as Method
from .alignment import align_frames as align_frames
from .frames import OdometryFrame as OdometryFrame
from .results import OdometryResult as OdometryResult
