"""The public names of pointloom.video: the one list of them, for type checkers and for `public_names`."""

from ...pcd.geodesy import WorldFrame as WorldFrame
from .georeference import PlacesFit as PlacesFit
from .job import reconstruct as reconstruct
from .outputs import Outputs as Outputs
from .result import StageReport as StageReport
from .result import VideoFigures as VideoFigures
from .result import VideoResult as VideoResult
from .settings import Settings as Settings
from .units import Fit as Fit
from .units import KnownPlaces as KnownPlaces
from .units import Units as Units
