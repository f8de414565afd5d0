"""Modules of `pointloom.open3d`, for type checkers and for `public_names`."""

from . import camera as camera
from . import core as core
from . import data as data
from . import geometry as geometry
from . import io as io
from . import pipelines as pipelines
from . import t as t
from . import utility as utility
from . import visualization as visualization

__version__: str
_build_config: dict[str, bool | str]
