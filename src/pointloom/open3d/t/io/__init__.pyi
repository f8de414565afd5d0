"""The names of `open3d.t.io`."""

from .clouds import read_point_cloud as read_point_cloud
from .clouds import write_point_cloud as write_point_cloud
from .images import read_image as read_image
from .images import write_image as write_image
from .meshes import read_triangle_mesh as read_triangle_mesh
from .meshes import write_triangle_mesh as write_triangle_mesh
