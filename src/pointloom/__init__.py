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
    "RGBDImage": "pcd.images",
    "PinholeCameraIntrinsic": "pcd.camera",
    "NearestNeighborSearch": "pcd.search",
    "read_point_cloud": "pcd.io.point_cloud",
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
    from .meshing.isosurface import marching_cubes
    from .meshing.mesh import TriangleMesh, read_triangle_mesh, write_triangle_mesh
    from .meshing.tsdf import TSDFVolume
    from .pcd.boxes import AxisAlignedBoundingBox, OrientedBoundingBox
    from .pcd.camera import PinholeCameraIntrinsic
    from .pcd.cloud import PointCloud
    from .pcd.errors import DatasetError, DeviceError, FileError, PointloomError
    from .pcd.images import RGBDImage
    from .pcd.io.point_cloud import read_point_cloud, write_point_cloud
    from .pcd.search import NearestNeighborSearch

__all__ = [
    "AxisAlignedBoundingBox",
    "DatasetError",
    "DeviceError",
    "FileError",
    "NearestNeighborSearch",
    "OrientedBoundingBox",
    "PinholeCameraIntrinsic",
    "PointCloud",
    "PointloomError",
    "RGBDImage",
    "TSDFVolume",
    "TriangleMesh",
    "marching_cubes",
    "read_point_cloud",
    "read_triangle_mesh",
    "write_point_cloud",
    "write_triangle_mesh",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'pointloom' has no attribute {name!r}")
    value = getattr(importlib.import_module(f".{_HOMES[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOMES])
