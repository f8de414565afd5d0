"""The public names of pointloom.mvs: the one list of them, for type checkers and for `public_names`."""

from .depth_bundles import read_depth_bundle as read_depth_bundle
from .depth_maps import DepthMap as DepthMap
from .depth_maps import DepthMaps as DepthMaps
from .estimation import estimate_depth_maps as estimate_depth_maps
from .filtering import filter_depth_maps as filter_depth_maps
from .fusion import fuse as fuse
from .posed_pictures import PosedCamera as PosedCamera
from .sources import choose_sources as choose_sources
