"""The modules of `open3d.pipelines`."""

from . import color_map as color_map
from . import integration as integration
from . import odometry as odometry
from . import registration as registration
