"""Errors of poses of RGB-D frames beside their covariances: rows of calibration.py."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
import places
import sensors
from numpy.typing import NDArray
from real_data import DataMissingError, real_data
from rgbd_recordings import Frames, opened

Array = NDArray[np.float64]

FRAMES = 45  # of a path
EVERY = 4  # poses of a path that count
VOXEL = 0.02  # [m]
SCALE = 0.5  # of the synthetic images: 160 x 120
DEPTH_MAX = 6.0  # [m]
STEPS = range(2, 7)  # frames between those of a real pair
LENGTH = 30  # frames of a path forward and backward


class PoseError(NamedTuple):
    """The motion 4x4 from an estimated to the true pose, with the covariance of rotation and translation of `center`"""

    scenes: str
    method: str
    error: Array
    matrix: Array
    center: Array


def path_errors(seeds: range) -> Iterator[PoseError]:
    """Poses of tracked walks through each kind of site, relative to their first pose."""
    import pointloom as loom

    for seed in seeds:
        for kind, make in places.KINDS.items():
            camera = sensors.DepthCamera(make(seed), seed, scale=SCALE)
            way = {"table": sensors.around, "staircase": sensors.climb}.get(kind, sensors.walking_path)
            frames = camera.film(way(FRAMES, seed))
            stream = loom.frames_from([(f.color, f.depth, f.timestamp) for f in frames], camera.intrinsic)
            path = loom.rgbd.track(stream, voxel_size=VOXEL)
            numbers, poses = np.asarray(path.trajectory.ids)[:, 0].tolist(), path.trajectory.poses
            print(f"{kind} {seed}: {len(numbers)} poses", file=sys.stderr, flush=True)
            start = poses[0] @ np.linalg.inv(frames[numbers[0]].pose)
            for k in range(EVERY, len(numbers), EVERY):
                covariance, true = path.pose_covariances[k], start @ frames[numbers[k]].pose
                error = true @ np.linalg.inv(poses[k])
                yield PoseError("sites, RGB-D paths", "track", error, covariance.matrix, covariance.center)


def errors_there_and_back(is_fitted: bool, count: int) -> Iterator[PoseError]:
    """The same real frames tracked forward and backward: the product of both end poses is the identity but for errors.

    No published pose is used. Errors that both directions share cancel. Successive paths share no frame.
    """
    for frames in opened(is_fitted):
        for first in range(frames.numbers.start, frames.numbers.stop - LENGTH + 1, LENGTH)[:count]:
            print(f"{frames.recording.camera} {first}", file=sys.stderr, flush=True)
            error = error_there_and_back(frames, range(first, first + LENGTH))
            if error is not None:
                yield error


def error_there_and_back(frames: Frames, numbers: range) -> PoseError | None:
    """The error of one path, or None if a frame at its ends was not tracked."""
    import pointloom as loom

    ends = []
    for way in (numbers, numbers[::-1]):
        images = [frames.read(k) for k in way]
        stream = loom.frames_from([(image.color, image.depth) for image in images], frames.data.intrinsic)
        path = loom.rgbd.track(stream, voxel_size=frames.recording.voxel, depth_max=frames.recording.max_depth)
        tracked = np.asarray(path.trajectory.ids)[:, 0]
        if tracked[0] != 0 or tracked[-1] != len(numbers) - 1:
            return None
        ends.append((np.linalg.inv(path.trajectory.poses[0]) @ path.trajectory.poses[-1], path.pose_covariances[-1]))
    (T, there), (back, of_back) = ends
    axes = np.kron(np.eye(2), T[:3, :3])  # those of the last frame, which is the world of the way back
    matrix = there.matrix + axes @ of_back.about(np.zeros(3)).matrix @ axes.T
    name = f"RGB-D recording, {frames.recording.camera}"
    return PoseError(name, "track, there and back", np.linalg.inv(T @ back), matrix, T[:3, 3].copy())


def half_errors(count: int, held_out: bool) -> Iterator[PoseError]:
    """Two poses of a real frame relative to another, one of each half of its pixels.

    The difference of their poses has the sum of both covariances, and includes errors of the sensor that differ between
    the halves. The first 150 frames of the kitchen were used to choose constants, the others are held out.
    """
    import pointloom as loom

    try:
        data = loom.open_dataset(real_data("rgbd-7scenes-redkitchen"))
    except DataMissingError as error:
        print(f"left out kitchen: {error}", file=sys.stderr)
        return
    rng, middle = np.random.default_rng([int(held_out), 82]), len(data) // 2
    low, high = (middle, len(data)) if held_out else (0, middle)
    for _ in range(count):
        step = int(rng.integers(STEPS.start, STEPS.stop))
        i = int(rng.integers(low, high - step))
        source, target = data.read(i), data.read(i + step)
        fixed = _frame(target.depth, target.color, data)
        v, u = np.indices(source.depth.shape)
        for along in (u >= source.depth.shape[1] // 2, v >= source.depth.shape[0] // 2):
            halves = [_frame(np.where(side, source.depth, 0), source.color, data) for side in (along, ~along)]
            for method in ("point-to-plane", "hybrid"):
                first, second = (loom.rgbd.align_frames(half, fixed, method=method) for half in halves)
                if first.reliable and second.reliable:
                    error = first.transformation @ np.linalg.inv(second.transformation)
                    matrix = first.covariance + second.covariance
                    yield PoseError("halves of real RGB-D frames", method.name, error, matrix, np.zeros(3))


def _frame(depth: Any, color: Any, data: Any) -> Any:
    import pointloom as loom

    options: dict[str, Any] = {"depth_scale": data.depth_scale, "depth_max": DEPTH_MAX}
    return loom.rgbd.OdometryFrame(depth.astype(np.uint16), data.intrinsic, color, **options)
