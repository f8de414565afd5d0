"""The modules of `pointloom.open3d`: the one list of them, for type checkers and for `public_names`."""

from . import camera as camera
from . import geometry as geometry
from . import io as io
from . import utility as utility

__version__: str
