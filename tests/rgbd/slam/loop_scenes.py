"""Runs through the furnished room with a drifting tracker, split into submaps."""

import dataclasses
from functools import cache

import numpy as np

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory
from pointloom.datasets.scenes.room import room_sequence, surface_errors
from pointloom.registration.rigid import invert_pose, pose_of
from pointloom.rgbd.slam.submaps import SubmapRecorder

FRAMES = 144
VOXEL = 0.03
DRIFT = np.array([0.015, -0.01, 0.02, 0.06, -0.04, 0.05])  # [rad, m] total drift, evenly over the run


@cache
def room_run(drift=1.75, frames=18):
    """(submaps, tracked poses, true poses) of a run."""
    sequence = room_sequence(FRAMES, width=96, height=72)
    recorder = SubmapRecorder(sequence.intrinsic, voxel_size=VOXEL, frames=frames)
    drift_steps = np.random.default_rng(1).normal(size=(FRAMES, 6)) * np.repeat([0.008, 0.012], 3) / FRAMES**0.5
    true, tracked = [], []
    for i, frame in enumerate(sequence):
        true.append(frame.T_world_camera)
        if i == 0:
            tracked.append(frame.T_world_camera)
        else:
            step = invert_pose(true[-2]) @ true[-1]
            tracked.append(tracked[-1] @ step @ pose_of(drift * (drift_steps[i] + DRIFT / FRAMES)))
        recorder.add(frame.depth, tracked[-1], frame.color)
    return recorder.finish(), np.array(tracked), np.array(true)


def trajectory_error(poses, true):
    """Root mean square error of the aligned positions [m]."""
    return loom.registration.evaluate_trajectory(Trajectory(poses), Trajectory(true)).absolute_translation.rmse


def surface_error(volume, poses, true):
    """Median distance [m] of a surface from the true room, aligned by its trajectory."""
    T = loom.registration.evaluate_trajectory(Trajectory(poses), Trajectory(true)).transformation
    points = volume.extract_triangle_mesh(3).vertices @ T[:3, :3].T + T[:3, 3]
    return float(np.median(surface_errors(points)))


def moved(submap, T, **changes):
    return dataclasses.replace(submap, T_world_submap=T @ submap.T_world_submap, **changes)


CAMERA = loom.PinholeCameraIntrinsic(64, 48, 50.0, 50.0, 31.5, 23.5)


def hall_depth(T, size=(4.0, 4.0, 2.4)):
    """Depth from within an empty hall about the origin, which is symmetric under rotation by 180 degrees."""
    v, u = np.mgrid[: CAMERA.height, : CAMERA.width]
    rays = np.stack([(u - CAMERA.cx) / CAMERA.fx, (v - CAMERA.cy) / CAMERA.fy, np.ones(u.shape)], axis=-1) @ T[:3, :3].T
    with np.errstate(divide="ignore"):
        ways = (np.sign(rays) * np.array(size) / 2 - T[:3, 3]) / rays
    return ways.min(axis=-1)


def hall_run(device, frames, angles, first=0):
    """A submap of the hall, seen from its middle at these angles [rad]."""
    recorder = SubmapRecorder(CAMERA, voxel_size=0.05, frames=frames, color=False, device=device)
    for i, angle in enumerate(np.linspace(*angles, frames)):
        T = np.eye(4)
        T[:3, 0], T[:3, 1] = (-np.sin(angle), np.cos(angle), 0), (0, 0, -1)
        T[:3, 2] = (np.cos(angle), np.sin(angle), 0)
        T[:3, 0] *= -1  # right-handed: right, down, forward
        T[:3, 3] = (0.3 * np.cos(angle), 0.3 * np.sin(angle), 0.1)
        recorder.add(hall_depth(T), T, number=first + i)
    return recorder.finish()[0]


def record(poses, device="cpu", **options):
    """A recorder with frames of a flat wall 1.5 m before each camera."""
    recorder = SubmapRecorder(CAMERA, **{"voxel_size": 0.1, "color": False, "device": device} | options)
    for pose in poses:
        recorder.add(np.full((CAMERA.height, CAMERA.width), 1.5), pose)
    return recorder
