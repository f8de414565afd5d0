"""Pairs of real scans with their true poses, and synthetic pairs without noise."""

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom

from .hilly_clouds import hills
from .icp_clouds import back, wavy
from .poses import as_pose, moved


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
    target, source = wavy(rng, 4000), wavy(rng, 4000)
    return SimpleNamespace(source=back(source, T), target=target, T=T)


@pytest.fixture(scope="session")
def street_pair(scan_set, real_file, made_street):
    """Two LiDAR scans and `T` from source to target coordinates.

    KITTI's of 69,000 points each (real), or every other ray of the synthetic street with 2 cm noise (shipped).
    """
    if scan_set == "real":
        folder = real_file("reg-small-gicp")
        source, target = (loom.read_point_cloud(folder / f"{name}.ply").points for name in ("source", "target"))
        return SimpleNamespace(source=source, target=target, T=np.loadtxt(folder / "T_target_source.txt"))
    rng, points = np.random.default_rng(3), made_street.drive(1, speed=0.0, beams=64, azimuths=2000, noise=0.0).scans[0]
    T = as_pose(np.radians(0.71) * np.array([0.0, 0.0, 1.0]), [0.5, 0.05, 0.0])
    target, source = (half + rng.normal(0, 0.02, half.shape) for half in (points[::2], points[1::2]))
    return SimpleNamespace(source=moved(source, np.linalg.inv(T)), target=target, T=T)


@pytest.fixture(scope="session")
def room_pair(scan_set, real_file, shipped_file):
    """Two scans of a room and `T`, 12.7 degrees from the identity.

    Fragments 4 (source) and 0 (target) of 3DMatch's kitchen with 55 % overlap (real), or two frames of a living room,
    the source rotated by the same angle (shipped).
    """
    if scan_set == "real":
        folder = real_file("reg-teaser-3dmatch/data")
        source, target = (loom.read_point_cloud(folder / f"cloud_bin_{k}.ply").points for k in (4, 0))
        return SimpleNamespace(source=source, target=target, T=np.loadtxt(folder / "T_0_from_4.txt"))
    folder = shipped_file("rgbd-cupoch-redwood5")
    camera = loom.PinholeCameraIntrinsic(640, 480, 525.0, 525.0, 319.5, 239.5)
    poses = loom.read_trajectory(folder / "trajectory.log").poses
    depths = [loom.read_depth(folder / "depth" / f"{k:05d}.png") for k in (0, 4)]
    target, source = (loom.PointCloud.create_from_depth_image(depth, camera, stride=2).points for depth in depths)
    motion = as_pose(np.radians(12.7) * np.array([0.36, 0.48, 0.8]), [0.4, -0.4, 0.4])
    T = np.linalg.inv(poses[0]) @ poses[-1] @ np.linalg.inv(motion)
    return SimpleNamespace(source=moved(source, motion), target=target, T=T)


@pytest.fixture(scope="session")
def featured(room_pair):
    """`room_pair` in voxels of 5 cm: points, normals and features of `source` and `target`, and `T`."""
    pair = SimpleNamespace(T=room_pair.T)
    for name in ("source", "target"):
        cloud = loom.PointCloud(getattr(room_pair, name)).voxel_down_sample(0.05)
        cloud = cloud.estimate_normals(radius=0.1, max_nn=30)
        cloud = cloud.orient_normals_towards_camera_location(cloud.get_center())  # a side that rotates with the cloud
        feature = loom.compute_fpfh_feature(cloud, radius=0.25, max_nn=100)
        setattr(pair, name, SimpleNamespace(points=cloud.points, normals=cloud.normals, feature=feature.copy()))
    return pair


@pytest.fixture(scope="session")
def full_pair(surface_pair):
    """The clouds of `surface_pair` with all attributes of all estimators, and T."""

    def build_cloud(points, paint):
        colors = 0.5 + 0.4 * np.sin(paint @ np.array([[5, 1, 2], [3, 6, 2], [2, 2, 7]]))
        cloud = loom.PointCloud(points[::2], colors=colors[::2], dopplers=np.zeros(len(points[::2]), np.float32))
        return cloud.estimate_normals(max_nn=20)

    T = surface_pair.T
    moved = surface_pair.source @ T[:3, :3].T + T[:3, 3]
    return build_cloud(surface_pair.source, moved), build_cloud(surface_pair.target, surface_pair.target), T


@pytest.fixture(scope="session")
def hilly_pair():
    """Two samplings of a hilly surface that overlap by 60 %, and the pose between them: 75 degrees."""
    rng = np.random.default_rng(4)
    target, source = hills(rng, 25000), hills(rng, 25000)
    T = as_pose(np.radians(75) * np.array([0.3, 0.2, 0.93]), [1, 2, 3])
    target, source = target[target[:, 0] < 0.5], source[source[:, 0] > -0.5]
    return moved(source, np.linalg.inv(T)), target, T


@pytest.fixture(scope="session")
def street(made_street):
    """The module benchmarks/street.py: drives of a scanner through a synthetic street."""
    return made_street


@pytest.fixture(scope="session")
def fast_drive(street):
    """12 scans, at 20 m/s from the start."""
    return street.drive(12, speed=20.0, beams=40, azimuths=360)


@pytest.fixture(scope="session")
def around():
    """A drive around a block that ends where it began."""
    from .test_lidar_slam import AROUND, make_drive

    return make_drive(AROUND)
