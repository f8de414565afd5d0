"""A drive as clouds, its true trajectory, and the estimated trajectory."""

from pathlib import Path

import numpy as np

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory
from pointloom.registration import LidarOdometry

ROOT = Path(__file__).parents[2]


def clouds(drive, device, count=None):
    scans = zip(drive.scans[:count], drive.times[:count], strict=True)
    return [loom.PointCloud(points, time=times, device=device) for points, times in scans]


def truth_of(drive, count=None) -> Trajectory:
    poses = drive.poses[:count]
    return Trajectory(np.linalg.inv(poses[0]) @ poses)


def follow(drive, device, count=None, **options) -> LidarOdometry:
    odometry = LidarOdometry(**options)
    for cloud in clouds(drive, device, count):
        odometry.register(cloud)
    return odometry
