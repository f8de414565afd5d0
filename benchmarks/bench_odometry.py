"""LiDAR odometry over a made-up street, per scan: scans in memory, thinning, matching and the map included.

small_gicp's scan-to-model odometry (VGICP) has no deskewing, so the scans
come from a drive without sway, where it needs none.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from contest import OURS, Contestant, Operation, thread_count, timed, waiting
from street import TURN, Drive, drive, pose_at

VOXEL_SIZE = 1.0  # [m] of the maps, KISS-ICP's default for a range of 100 m
GICP_VOXEL_SIZE = 0.25  # [m] small_gicp's example for outdoor scans
SPEED = 10.0  # [m/s]


def street_drive(count: int, beams: int, azimuths: int) -> Callable[[], Drive]:
    return lambda: drive(count, speed=SPEED, beams=beams, azimuths=azimuths)


def prepare_pointloom(scene: Drive, device: str) -> Any:
    import pointloom as loom

    clouds = [loom.PointCloud(p, time=t, device=device) for p, t in zip(scene.scans, scene.times, strict=True)]

    def run() -> Any:
        odometry = loom.registration.LidarOdometry(voxel_size=VOXEL_SIZE)
        for cloud in clouds:
            odometry.register(cloud)
        return odometry.poses

    return waiting(run, device, "warp")


def prepare_kiss_icp(scene: Drive, device: str) -> Any:
    from kiss_icp.config import KISSConfig
    from kiss_icp.kiss_icp import KissICP

    config = KISSConfig()
    config.data.max_range, config.data.min_range, config.mapping.voxel_size = 100.0, 5.0, VOXEL_SIZE
    config.registration.max_num_threads = thread_count()
    scans = [points.astype(np.float64) for points in scene.scans]

    def run() -> Any:
        odometry, poses = KissICP(config), []
        for points, times in zip(scans, scene.times, strict=True):
            odometry.register_frame(points, times)
            poses.append(odometry.last_pose)
        return np.array(poses)

    return run


def prepare_small_gicp(scene: Drive, device: str) -> Any:
    import small_gicp

    scans = [points.astype(np.float64) for points in scene.scans]

    def run() -> Any:
        target, poses = small_gicp.GaussianVoxelMap(VOXEL_SIZE), []
        for points in scans:
            cloud, _ = small_gicp.preprocess_points(points, GICP_VOXEL_SIZE, num_threads=thread_count())
            guess = poses[-1] @ np.linalg.inv(poses[-2]) @ poses[-1] if len(poses) > 1 else np.eye(4)
            if poses:
                guess = small_gicp.align(target, cloud, guess, num_threads=thread_count()).T_target_source
            target.insert(cloud, guess)
            poses.append(guess)
        return np.array(poses)

    return run


def check(ours: np.ndarray, theirs: np.ndarray, peer: str) -> None:
    """Both have gone the whole way; where theirs is off, as of rings that move along, it is so by some per cent."""
    ends, _ = pose_at(np.array([0.0, SPEED * TURN * (len(ours) - 1)]), 0.0)
    way = float(np.linalg.norm(ends[1] - ends[0]))
    gap = np.linalg.norm(ours[-1, :3, 3] - ours[0, :3, 3]) / way - 1
    assert abs(gap) < 0.01, f"ours has gone {1 + gap:.1%} of the way"
    apart = np.linalg.norm(ours[-1, :3, 3] - theirs[-1, :3, 3]) / way
    assert apart < 0.2, f"{peer} ends {apart:.1%} of the way from ours"


ODOMETRY = Operation(
    name="odometry",
    scenes={"64 beams, 115k": street_drive(30, 64, 1800), "16 beams, 14k": street_drive(30, 16, 900)},
    quick={"16 beams": street_drive(5, 16, 900)},
    contestants=(
        Contestant(OURS, prepare_pointloom, lambda poses: poses, ("cpu", "cuda")),
        Contestant("kiss-icp", prepare_kiss_icp, lambda poses: poses),
        Contestant("small_gicp", prepare_small_gicp, lambda poses: poses),
    ),
    check=check,
    unit_count=lambda scene: len(scene.scans),
)
OPERATIONS = (ODOMETRY,)


@timed(ODOMETRY)
def test_odometry(turn) -> None:
    turn()
