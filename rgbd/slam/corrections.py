"""Submaps of a run beside its model, and what closing loops changes: poses, keyframes, the model itself."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.progress import ReportProgress
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download
from ...registration.rigid import invert_pose
from .frames import SensorFrame
from .loops import LoopClosure, close_loops, corrected_trajectory, fuse_submaps
from .maps import SlamMap
from .movers import Movers
from .results import TrackingResult
from .submaps import SubmapRecorder
from .tracker import clean_pose

Pose = NDArray[np.float64]


def record_frame(recorder: SubmapRecorder, frame: SensorFrame, depth: Any, pixels: Any, result: TrackingResult) -> None:
    """A fused frame goes into the submap being recorded, with the depth and colour that the model took."""
    height, width = frame.intrinsic.height, frame.intrinsic.width
    color = None if pixels is None else pixels.reshape((height, width, 3))
    picture = depth.reshape((height, width))
    if not frame.device.is_cuda:
        picture, color = download(picture), None if color is None else download(color)
    recorder.add(picture, result.pose, color, result.index)


def close_and_correct(known: SlamMap, results: list[TrackingResult], progress: ReportProgress) -> LoopClosure:
    """Close loops among the submaps of a map so far, and move everything that stands on their poses."""
    recorder, model, keyframes, motion = known.recorder, known.model, known.keyframes, known.tracker.motion
    assert recorder is not None
    submaps, seed = recorder.finish(), keyframes.seed
    closure = close_loops(submaps, seed=seed, progress=progress)
    numbers, poses = corrected_trajectory(submaps, closure.T_world_submap)
    own = [result for result in results if result.map == known.number]
    before = {result.index: result.pose for result in own if result.pose is not None}
    corrections = {n: matmul(pose, invert_pose(before[n])) for n, pose in zip(numbers.tolist(), poses, strict=True)}

    def corrected(pose: Pose, number: int) -> Pose:
        place = max(int(np.searchsorted(numbers, number, side="right")) - 1, 0)
        return clean_pose(matmul(corrections[int(numbers[place])], pose))

    for i, result in enumerate(results):
        if result.pose is not None and result.map == known.number:
            results[i] = dataclasses.replace(result, pose=corrected(result.pose, result.index))
    keyframes.poses = [corrected(T, n) for T, n in zip(keyframes.poses, keyframes.numbers, strict=True)]
    if motion.pose is not None:
        motion.pose = corrected(motion.pose, len(results))
    recorder.submaps = [
        dataclasses.replace(submap, T_world_submap=T) for submap, T in zip(submaps, closure.T_world_submap, strict=True)
    ]
    model.volume, model.movers = fuse_submaps(recorder.submaps), Movers()
    model.current_frame_pose = corrected(model.current_frame_pose, len(results))
    return closure
