"""What the tests of point clouds share: tolerances, Open3D's form of a cloud, and the indoor fragment."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest


@pytest.fixture(scope="session")
def tolerances():
    """The values of tests/tolerances.py by name."""
    spec = importlib.util.spec_from_file_location("tolerances", Path(__file__).parents[1] / "tolerances.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.Tolerances()


@pytest.fixture(scope="session")
def to_open3d():
    """A function that makes a legacy Open3D cloud of arrays."""
    import open3d as o3d

    def convert(points, normals=None, colors=None):
        cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.asarray(points, np.float64)))
        if normals is not None:
            cloud.normals = o3d.utility.Vector3dVector(np.asarray(normals, np.float64))
        if colors is not None:
            cloud.colors = o3d.utility.Vector3dVector(np.asarray(colors, np.float64))
        return cloud

    return convert


@pytest.fixture(scope="session")
def fragment(data):
    """The indoor fragment as Open3D reads it: `legacy`, and its points, normals and colours as arrays."""
    import open3d as o3d

    legacy = o3d.io.read_point_cloud(str(data / "cloud-cupoch" / "fragment.pcd"))
    points, normals, colors = (np.asarray(a) for a in (legacy.points, legacy.normals, legacy.colors))
    assert points.shape == normals.shape == colors.shape == (113662, 3)
    return SimpleNamespace(legacy=legacy, points=points, normals=normals, colors=colors)


@pytest.fixture(scope="session")
def lidar(data):
    """One KITTI scan, [17238, 4]: x, y, z [m] and intensity; its density varies a thousandfold."""
    return np.fromfile(data / "lidar-kitti-frame" / "kitti" / "000008.bin", np.float32).reshape(-1, 4)


@pytest.fixture(scope="session")
def terrain(data):
    """An airborne tile at UTM coordinates, [n, 3] float64; its file holds y in steps of 0.5 m."""
    import pointloom as loom

    return loom.read_point_cloud(data / "lidar-pcl-terrain" / "samp21-utm.pcd").points
