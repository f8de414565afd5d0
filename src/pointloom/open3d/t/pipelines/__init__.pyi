"""The names of `open3d.t.pipelines`."""

from . import odometry as odometry
from . import registration as registration
from . import slam as slam
