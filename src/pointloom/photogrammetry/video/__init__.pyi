"""The public names of pointloom.video: the one list of them, for type checkers and for `public_names`."""

from .ground_control import ControlMark as ControlMark
from .ground_control import GroundControl as GroundControl
from .ground_control import ScaleBar as ScaleBar
from .job import reconstruct as reconstruct
from .outputs import Outputs as Outputs
from .settings import Settings as Settings
from .units import Units as Units
