"""Plane costs of a scan at several poses: the same with known planes of the map, and of points with planes alone."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import launch, vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.odometry.map_aligner import Reached
from pointloom.kernels.odometry.map_course import LEG_CONVERGED, LEG_LOST
from pointloom.kernels.odometry.pose_probes import ScanProbes, compare_poses, find_map_planes, find_squares_kernel
from pointloom.kernels.odometry.voxel_map import VoxelMap
from pointloom.registration.lidar.scan_matching import _best_poses
from pointloom.registration.rigid import make_pose, rotation_of


@pytest.fixture
def corner(device, rng):
    """A map of three walls, and a scan of them that also has points without a plane."""
    walls = rng.uniform(0, 6, (4000, 3))
    walls[np.arange(4000), np.arange(4000) % 3] = 0.0
    voxel_map = VoxelMap(1.0, 20, resolve_device(device))
    voxel_map.add(upload(walls, vec3, voxel_map.device), np.eye(4), 60.0)
    scan = np.concatenate([walls[::10] + rng.normal(0, 0.01, (400, 3)), rng.uniform(1.2, 8, (200, 3))])
    return voxel_map, upload(scan, vec3, voxel_map.device)


def moved_poses(*shifts):
    return np.array([make_pose(np.eye(3), np.array(shift)) for shift in [(0.0, 0.0, 0.0), *shifts]])


def test_known_planes_of_the_map_give_the_same_cost_changes(corner):
    voxel_map, scan = corner
    poses = moved_poses((0.7, 0, 0), (0, 0, -0.7))
    changes = compare_poses(scan, 300, voxel_map, poses, 1.0)
    known = compare_poses(scan, 300, voxel_map, poses, 1.0, find_map_planes(voxel_map, 1.0))
    np.testing.assert_allclose(known, changes, rtol=1e-4, atol=1e-4)
    assert (changes[1:, 0] > 0.1 * changes[1:, 2]).all()


def test_points_without_a_plane_at_the_first_pose_do_not_count(corner):
    voxel_map, scan = corner
    poses = moved_poses((-2.0, -2.0, -2.0), (0.5, 0, 0))

    def has_plane(pose):
        probes = ScanProbes(scan, scan.size, voxel_map, pose[None], 1.0)
        launch(find_squares_kernel, probes.runs, [0, probes])
        return probes.squares.numpy()[0] >= 0

    alone = np.array([has_plane(pose) for pose in poses])
    pairs = compare_poses(scan, scan.size, voxel_map, poses, 1.0)[:, 2]
    np.testing.assert_array_equal(pairs, (alone & alone[0]).sum(axis=1))
    assert (alone[1] & ~alone[0]).any()


def test_the_best_third_of_many_starts_is_continued():
    def reached(x, cost, angle=0.0, state=LEG_CONVERGED):
        pose = make_pose(rotation_of(np.array([0.0, 0.0, angle])), np.array([x, 0.0, 0.0]))
        return Reached(pose, state, 2, 100, 1.0, cost, cost)

    results = [
        *(reached(x, cost) for x, cost in [(3.0, 0.4), (1.0, 0.1), (1.3, 0.2), (2.0, 0.3), (4.0, 0.5), (5.0, 0.6)]),
        *(reached(1.0, 0.25, angle=0.5), reached(9.0, 0.0, state=LEG_LOST)),
    ]
    poses = _best_poses(results, 1.0)
    assert [float(T[0, 3]) for T in poses] == [1.0, 1.0, 2.0]  # 1.3 is near 1.0, and the second one is rotated
