"""The names of `open3d.t.pipelines.slam`."""

from .frame import Frame as Frame
from .model import Model as Model
