"""The public names of pointloom.slam: the one list of them, for type checkers and for `public_names`."""

from .dense_slam import DenseSLAM as DenseSLAM
from .loops import close_loops as close_loops
from .loops import corrected_trajectory as corrected_trajectory
from .loops import fuse_submaps as fuse_submaps
from .model import Model as Model
from .submaps import SubmapRecorder as SubmapRecorder
