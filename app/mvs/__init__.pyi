"""The public names of pointloom.mvs: the one list of them, for type checkers and for `public_names`."""

from .depth_maps import DepthMap as DepthMap
from .depth_maps import DepthMaps as DepthMaps
from .posed_pictures import PosedCamera as PosedCamera
from .posed_pictures import SparsePoints as SparsePoints
