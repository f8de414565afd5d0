"""What the tests of registration share: pairs of real scans with their true poses, and made-up pairs without noise."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from .hilly_clouds import hills
from .poses import as_pose, moved


def bumpy_surface(rng: np.random.Generator, count: int) -> np.ndarray:
    """Points on a 2 x 2 m surface whose bumps fix all six directions of motion."""
    xy = rng.uniform(-1, 1, (count, 2))
    z = 0.2 * np.sin(3 * xy[:, 0]) * np.cos(4 * xy[:, 1]) + 0.1 * np.sin(7 * xy[:, 1] + xy[:, 0])
    return np.column_stack([xy, z])


@pytest.fixture(scope="session")
def angle_between():
    """A function: the angle [degrees] between two poses' rotations, by the logarithm."""
    from scipy.spatial.transform import Rotation

    return lambda A, B: float(np.degrees(Rotation.from_matrix(A[:3, :3] @ B[:3, :3].T).magnitude()))


@pytest.fixture(scope="session")
def surface_pair():
    """A surface sampled twice, 4,000 points each, `T` from source to target: 4 degrees and 5 cm."""
    rng = np.random.default_rng(5)
    T = as_pose([0.03, -0.05, 0.04], [0.03, -0.03, 0.02])
    target, source = bumpy_surface(rng, 4000), bumpy_surface(rng, 4000)
    return SimpleNamespace(source=(source - T[:3, 3]) @ T[:3, :3], target=target, T=T)


@pytest.fixture(scope="session")
def kitti_pair(data):
    """Two LiDAR scans of 69,000 points and `T`, which takes the source's coordinates to the target's."""
    import pointloom as loom

    folder = data / "reg-small-gicp"
    read = loom.read_point_cloud
    return SimpleNamespace(
        source=read(folder / "source.ply").points,
        target=read(folder / "target.ply").points,
        T=np.loadtxt(folder / "T_target_source.txt"),
    )


@pytest.fixture(scope="session")
def kitchen_pair(data):
    """Fragments 4 (source) and 0 (target) of a kitchen, 55 % overlap, and `T`: 12.7 degrees and 0.69 m."""
    import pointloom as loom

    folder = data / "reg-teaser-3dmatch" / "data"
    read = loom.read_point_cloud
    return SimpleNamespace(
        source=read(folder / "cloud_bin_4.ply").points,
        target=read(folder / "cloud_bin_0.ply").points,
        T=np.loadtxt(folder / "T_0_from_4.txt"),
    )


@pytest.fixture(scope="session")
def full_pair(surface_pair):
    """The clouds of `surface_pair` with all that any estimator asks for, and T."""
    import pointloom as loom

    def whole(points, paint):
        colors = 0.5 + 0.4 * np.sin(paint @ np.array([[5, 1, 2], [3, 6, 2], [2, 2, 7]]))
        cloud = loom.PointCloud(points[::2], colors=colors[::2], dopplers=np.zeros(len(points[::2]), np.float32))
        return cloud.estimate_normals(max_nn=20)

    T = surface_pair.T
    moved = surface_pair.source @ T[:3, :3].T + T[:3, 3]
    return whole(surface_pair.source, moved), whole(surface_pair.target, surface_pair.target), T


@pytest.fixture(scope="session")
def hilly_pair():
    """Two samplings of a hilly surface that share 60 %, and the pose between them: 75 degrees."""
    rng = np.random.default_rng(4)
    target, source = hills(rng, 25000), hills(rng, 25000)
    T = as_pose(np.radians(75) * np.array([0.3, 0.2, 0.93]), [1, 2, 3])
    target, source = target[target[:, 0] < 0.5], source[source[:, 0] > -0.5]
    return moved(source, np.linalg.inv(T)), target, T


@pytest.fixture(scope="session")
def street():
    """The module benchmarks/street.py: drives of a scanner through a made-up street."""
    spec = importlib.util.spec_from_file_location(
        "odometry_street", Path(__file__).parents[2] / "benchmarks" / "street.py"
    )
    module = importlib.util.module_from_spec(spec)
    sys.modules["odometry_street"] = module
    spec.loader.exec_module(module)
    yield module
    sys.modules.pop("odometry_street")


@pytest.fixture(scope="session")
def fast_drive(street):
    """12 scans at 20 m/s from the first on."""
    return street.drive(12, speed=20.0, beams=40, azimuths=360)
