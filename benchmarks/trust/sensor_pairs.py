"""Pairs of real clouds that share no measurement, with published poses: kinds of `calibration.py`.

Unlike halves of one cloud, they include the errors of a sensor that differ between two poses. The published poses have
errors of some millimeters, too.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import recordings
from numpy.typing import NDArray
from real_data import DataMissingError, real_data
from rgbd_recordings import Frames, nearest_rigid, opened

Array = NDArray[np.float64]
FRAME_STEPS = range(5, 11)  # frames between the images of a pair
FRAGMENT_FRAMES, EVERY = 30, 3  # frames of a fragment, and the step of those that are fused
REGISTRATION_VOXELS = 2.5  # voxels of a model
SCAN_STEPS = range(1, 3)  # scans between those of a pair
SCAN_VOXEL = 0.3  # [m]


class SensorPair(NamedTuple):
    """Two scans in their own frames [m], the published T_target_source, and the voxel size of the registration [m]."""

    kind: str
    source: Array
    target: Array
    T: Array
    voxel: float


def sensor_pairs(is_fitted: bool, count: int) -> Iterator[SensorPair]:
    """Pairs of each kind and sensor, at most `count` each."""
    for frames in opened(is_fitted):
        yield from _depth_pairs(frames, count)
    for frames in opened(is_fitted):
        yield from _fragment_pairs(frames, count)
    yield from _scan_pairs(is_fitted, count)


def _depth_pairs(frames: Frames, count: int) -> Iterator[SensorPair]:
    """Single depth images, as points."""
    rng, camera, numbers = np.random.default_rng(85), frames.data.intrinsic, frames.numbers
    for i in np.linspace(numbers.start, numbers.stop - FRAME_STEPS.stop, count).astype(int).tolist():
        ends, points = [frames.read(k) for k in (i, i + int(rng.integers(FRAME_STEPS.start, FRAME_STEPS.stop)))], []
        for end in ends:
            v, u = np.nonzero(end.depth)
            z = end.depth[v, u].astype(float)
            points.append(np.column_stack([(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z]))
        T = np.linalg.inv(ends[1].pose) @ ends[0].pose
        kind = f"depth frames, {frames.recording.camera}"
        yield SensorPair(kind, points[0], points[1], T, REGISTRATION_VOXELS * frames.recording.voxel)


def _fragment_pairs(frames: Frames, count: int) -> Iterator[SensorPair]:
    """Successive fragments, each fused from images at their published poses."""
    import pointloom as loom

    last, voxel, numbers = None, frames.recording.voxel, frames.numbers
    for first in range(numbers.start, numbers.stop - FRAGMENT_FRAMES + 1, FRAGMENT_FRAMES)[: count + 1]:
        volume, start = loom.TSDFVolume(voxel_size=voxel, color=False), frames.read(first).pose
        for k in range(first, first + FRAGMENT_FRAMES, EVERY):
            frame = frames.read(k)
            to_camera = np.linalg.inv(frame.pose)
            volume.integrate(frame.depth, frames.data.intrinsic, to_camera, depth_max=frames.recording.max_depth)
        points = np.asarray(volume.extract_point_cloud(weight_threshold=1.0).points)
        points = (points - start[:3, 3]) @ start[:3, :3]
        if last is not None:
            T = np.linalg.inv(last[1]) @ start
            yield SensorPair(f"fragments, {frames.recording.camera}", points, last[0], T, REGISTRATION_VOXELS * voxel)
        last = points, start


def _scan_pairs(is_fitted: bool, count: int) -> Iterator[SensorPair]:
    """Scans of a handheld LiDAR, at poses of a bundle adjustment."""
    recording, rng = recordings.RECORDINGS[0], np.random.default_rng(86)
    try:
        folder = real_data(recording.folder)
    except DataMissingError as error:
        print(f"left out {recording.folder}: {error}", file=sys.stderr)
        return
    poses = np.loadtxt(folder / "alidarPose.csv", delimiter=",", usecols=range(4)).reshape(-1, 4, 4)
    low, high = (0, recording.fitted_count) if is_fitted else (recording.fitted_count, len(poses))
    for i in np.linspace(low, high - SCAN_STEPS.stop, count).astype(int).tolist():
        j = i + int(rng.integers(SCAN_STEPS.start, SCAN_STEPS.stop))
        source, target = (recordings.read_scan(folder / f"full{k}.pcd").astype(float) for k in (i, j))
        T = np.linalg.inv(nearest_rigid(poses[j])) @ nearest_rigid(poses[i])
        yield SensorPair("LiDAR scans, handheld", source, target, T, SCAN_VOXEL)
