"""The names of `open3d.io`."""

from .cameras import read_pinhole_camera_intrinsic as read_pinhole_camera_intrinsic
from .cameras import read_pinhole_camera_parameters as read_pinhole_camera_parameters
from .cameras import read_pinhole_camera_trajectory as read_pinhole_camera_trajectory
from .cameras import write_pinhole_camera_intrinsic as write_pinhole_camera_intrinsic
from .cameras import write_pinhole_camera_parameters as write_pinhole_camera_parameters
from .cameras import write_pinhole_camera_trajectory as write_pinhole_camera_trajectory
from .images import read_image as read_image
from .images import write_image as write_image
from .line_sets import read_line_set as read_line_set
from .line_sets import write_line_set as write_line_set
from .registration import read_feature as read_feature
from .registration import read_pose_graph as read_pose_graph
from .registration import write_feature as write_feature
from .registration import write_pose_graph as write_pose_graph
from .shapes import read_point_cloud as read_point_cloud
from .shapes import read_triangle_mesh as read_triangle_mesh
from .shapes import write_point_cloud as write_point_cloud
from .shapes import write_triangle_mesh as write_triangle_mesh
from .voxel_grids import read_voxel_grid as read_voxel_grid
from .voxel_grids import write_voxel_grid as write_voxel_grid
