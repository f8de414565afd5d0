"""pointloom: point clouds, scans and RGB-D frames to clouds and meshes, on one kernel source for CUDA and CPU cores.

`import pointloom as loom` starts no runtime: each public name is loaded when it is first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

_HOMES = {
    "AxisAlignedBoundingBox": "pcd.boxes",
    "OrientedBoundingBox": "pcd.boxes",
    "PointCloud": "pcd.cloud",
    "ConvexHull": "pcd.convex_hull",
    "VisibleSurface": "pcd.hulls",
    "classify_ground": "pcd.ground",
    "RGBDImage": "pcd.images",
    "PinholeCameraIntrinsic": "pcd.camera",
    "create_depth_pyramid": "pcd.depth_filters",
    "create_normal_map": "pcd.depth_filters",
    "erode_depth_edges": "pcd.depth_filters",
    "filter_depth_bilateral": "pcd.depth_filters",
    "pyrdown_color": "pcd.depth_filters",
    "pyrdown_depth": "pcd.depth_filters",
    "NearestNeighborSearch": "pcd.search",
    "compute_eigen_features": "pcd.features",
    "compute_fpfh_feature": "pcd.features",
    "compute_metrics": "pcd.metrics",
    "compute_iss_keypoints": "pcd.keypoints",
    "estimate_curvature": "pcd.features",
    "SelectionPolygonVolume": "pcd.polygon_volume",
    "read_point_cloud": "pcd.io.point_cloud",
    "read_las_chunks": "pcd.io.point_cloud",
    "write_point_cloud": "pcd.io.point_cloud",
    "FileError": "pcd.errors",
    "DatasetError": "pcd.errors",
    "DeviceError": "pcd.errors",
    "PointloomError": "pcd.errors",
    "TriangleMesh": "meshing.mesh",
    "read_triangle_mesh": "meshing.mesh",
    "write_triangle_mesh": "meshing.mesh",
    "TSDFVolume": "meshing.tsdf",
    "marching_cubes": "meshing.isosurface",
}

if TYPE_CHECKING:
    from . import registration
    from .meshing.isosurface import marching_cubes
    from .meshing.mesh import TriangleMesh, read_triangle_mesh, write_triangle_mesh
    from .meshing.tsdf import TSDFVolume
    from .pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
    from .pcd.camera import PinholeCameraIntrinsic
    from .pcd.cloud import PointCloud
    from .pcd.convex_hull import ConvexHull
    from .pcd.depth_filters import (
        create_depth_pyramid,
        create_normal_map,
        erode_depth_edges,
        filter_depth_bilateral,
        pyrdown_color,
        pyrdown_depth,
    )
    from .pcd.errors import DatasetError, DeviceError, FileError, PointloomError
    from .pcd.features import compute_eigen_features, compute_fpfh_feature, estimate_curvature
    from .pcd.ground import classify_ground
    from .pcd.hulls import VisibleSurface
    from .pcd.images import RGBDImage
    from .pcd.io.point_cloud import read_las_chunks, read_point_cloud, write_point_cloud
    from .pcd.keypoints import compute_iss_keypoints
    from .pcd.metrics import compute_metrics
    from .pcd.polygon_volume import SelectionPolygonVolume
    from .pcd.search import NearestNeighborSearch

__all__ = [
    "AxisAlignedBoundingBox",
    "ConvexHull",
    "DatasetError",
    "DeviceError",
    "FileError",
    "NearestNeighborSearch",
    "OrientedBoundingBox",
    "PinholeCameraIntrinsic",
    "PointCloud",
    "PointloomError",
    "RGBDImage",
    "SelectionPolygonVolume",
    "TSDFVolume",
    "TriangleMesh",
    "VisibleSurface",
    "classify_ground",
    "compute_eigen_features",
    "compute_fpfh_feature",
    "compute_iss_keypoints",
    "compute_metrics",
    "create_depth_pyramid",
    "create_normal_map",
    "erode_depth_edges",
    "estimate_curvature",
    "filter_depth_bilateral",
    "marching_cubes",
    "pyrdown_color",
    "pyrdown_depth",
    "read_las_chunks",
    "read_point_cloud",
    "read_triangle_mesh",
    "registration",
    "write_point_cloud",
    "write_triangle_mesh",
]


def __getattr__(name: str) -> Any:
    if name == "registration":
        return importlib.import_module(".registration", __name__)
    if name not in _HOMES:
        raise AttributeError(f"module 'pointloom' has no attribute {name!r}")
    value = getattr(importlib.import_module(f".{_HOMES[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOMES, "registration"])
