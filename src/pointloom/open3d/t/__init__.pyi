"""The names of `open3d.t`."""

from . import geometry as geometry
from . import io as io
from . import pipelines as pipelines
