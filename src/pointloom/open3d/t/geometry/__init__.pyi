"""The names of `open3d.t.geometry`."""

from .geometry import Geometry as Geometry
from .tensor_map import TensorMap as TensorMap
