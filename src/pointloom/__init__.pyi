"""The public names of pointloom: the one list of them, for type checkers and for `public_names`."""

from . import registration as registration
from .meshing.isosurface import marching_cubes as marching_cubes
from .meshing.mesh import TriangleMesh as TriangleMesh
from .meshing.mesh import read_triangle_mesh as read_triangle_mesh
from .meshing.mesh import write_triangle_mesh as write_triangle_mesh
from .meshing.tsdf import TSDFVolume as TSDFVolume
from .pcd.boxes import AxisAlignedBoundingBox as AxisAlignedBoundingBox
from .pcd.boxes import OrientedBoundingBox as OrientedBoundingBox
from .pcd.camera import PinholeCameraIntrinsic as PinholeCameraIntrinsic
from .pcd.camera import read_pinhole_camera_intrinsic as read_pinhole_camera_intrinsic
from .pcd.camera import write_pinhole_camera_intrinsic as write_pinhole_camera_intrinsic
from .pcd.cloud import PointCloud as PointCloud
from .pcd.convex_hull import ConvexHull as ConvexHull
from .pcd.depth_filters import create_depth_pyramid as create_depth_pyramid
from .pcd.depth_filters import create_normal_map as create_normal_map
from .pcd.depth_filters import erode_depth_edges as erode_depth_edges
from .pcd.depth_filters import filter_depth_bilateral as filter_depth_bilateral
from .pcd.depth_filters import pyrdown_color as pyrdown_color
from .pcd.depth_filters import pyrdown_depth as pyrdown_depth
from .pcd.dropped_results import DroppedResultWarning as DroppedResultWarning
from .pcd.errors import DatasetError as DatasetError
from .pcd.errors import DeviceError as DeviceError
from .pcd.errors import FileError as FileError
from .pcd.errors import PointloomError as PointloomError
from .pcd.features import compute_eigen_features as compute_eigen_features
from .pcd.features import compute_fpfh_feature as compute_fpfh_feature
from .pcd.features import estimate_curvature as estimate_curvature
from .pcd.ground import classify_ground as classify_ground
from .pcd.hulls import VisibleSurface as VisibleSurface
from .pcd.images import RGBDImage as RGBDImage
from .pcd.io.datasets import open_dataset as open_dataset
from .pcd.io.image_files import read_color as read_color
from .pcd.io.image_files import read_depth as read_depth
from .pcd.io.point_cloud import read_las_chunks as read_las_chunks
from .pcd.io.point_cloud import read_point_cloud as read_point_cloud
from .pcd.io.point_cloud import write_point_cloud as write_point_cloud
from .pcd.io.trajectory import Trajectory as Trajectory
from .pcd.io.trajectory import read_trajectory as read_trajectory
from .pcd.io.trajectory import write_trajectory as write_trajectory
from .pcd.keypoints import compute_iss_keypoints as compute_iss_keypoints
from .pcd.metrics import compute_metrics as compute_metrics
from .pcd.polygon_volume import SelectionPolygonVolume as SelectionPolygonVolume
from .pcd.search import NearestNeighborSearch as NearestNeighborSearch

__version__: str
