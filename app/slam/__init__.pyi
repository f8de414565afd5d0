"""The public names of pointloom.slam: the one list of them, for type checkers and for `public_names`."""

from .dense_slam import DenseSLAM as DenseSLAM
from .model import Model as Model
from .results import TrackingResult as TrackingResult
