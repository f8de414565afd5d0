"""The public names of pointloom.video: the one list of them, for type checkers and for `public_names`."""

from ...pcd.geodesy import WorldFrame as WorldFrame
from .control_files import read_ground_control as read_ground_control
from .control_report import BarResidual as BarResidual
from .control_report import ControlFit as ControlFit
from .control_report import ControlResidual as ControlResidual
from .control_report import GpsGaps as GpsGaps
from .georeference import PlacesFit as PlacesFit
from .ground_control import ControlMark as ControlMark
from .ground_control import GroundControl as GroundControl
from .ground_control import ScaleBar as ScaleBar
from .job import reconstruct as reconstruct
from .outputs import Outputs as Outputs
from .result import StageReport as StageReport
from .result import VideoFigures as VideoFigures
from .result import VideoResult as VideoResult
from .settings import Settings as Settings
from .units import Fit as Fit
from .units import KnownPlaces as KnownPlaces
from .units import Units as Units
