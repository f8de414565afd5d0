"""Where else a frame would lie on the model as well as at the place that was found for it.

A corridor has like doors and a staircase like steps: a frame that was lost fits at several of them. Like parts of a
building are shifted, seldom turned, so the frame's points are shifted over the model, first by blocks of voxels, then
finely where many of them meet some; the best of these, apart from the place found, are its rivals.
"""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, matmul, norm
from ...meshing.volume.shift_scores import score_shifts
from ..odometry.frames import OdometryFrame
from .frames import coarsest_level
from .model import Model

Pose = NDArray[np.float64]

FARTHEST = 4.0  # [m] a rival lies off: what a depth camera sees at once, and so what may repeat in its picture
APART = 0.15  # [m] two rivals are apart at least; nearer ones are within the reach of one alignment
MOST = 6  # rivals that are looked at
POINTS = 300  # of a frame that are shifted
BLOCK = 8  # voxels of the coarse steps
FINE = 2  # voxels of the fine ones: half the truncation of 4 voxels
COARSE_SHARE = 0.45  # of the points that meet the model at the place found, in the coarse steps, and of the
ALIKE = 0.4  # score there, in the fine ones: a place at the model's rim shows half of it and may be the right one
MOST_COARSE = 1000  # coarse shifts that are looked at finely, the best first


def find_rivals(model: Model, frame: OdometryFrame, pose: Pose, farthest: float = FARTHEST) -> list[Pose]:
    """Poses T_world_camera that a frame may have beside the one found, by its surface alone; the likest first.

    Args:
        model: The Model.
        frame: The frame's pyramid.
        pose: Where it was found.
        farthest: How far off they may be [m].
    """
    points, axes = _points_of(frame, pose)
    if len(points) < POINTS // 4:
        return []
    volume, threshold = model.volume, model.threshold
    side = BLOCK * volume.voxel_size
    coarse = matmul(_ball(int(min(farthest, FARTHEST) / side)) * side, axes.T)
    here = np.zeros((1, 3))
    limits: dict[str, Any] = {"weight_threshold": threshold, "least": 0.0}
    least = COARSE_SHARE * float(score_shifts(volume, points, here, **limits, is_coarse=True)[0])
    met = score_shifts(volume, points, coarse, weight_threshold=threshold, least=least, is_coarse=True)
    order = np.argsort(-met, kind="stable")[:MOST_COARSE]
    order = order[met[order] >= least]
    if not len(order):
        return []
    fine = (coarse[order][:, None] + matmul(_steps() * FINE * volume.voxel_size, axes.T)).reshape(-1, 3)
    fine = fine[np.linalg.norm(fine, axis=1) > APART]
    least = ALIKE * float(score_shifts(volume, points, here, **limits)[0])
    scores = score_shifts(volume, points, fine, weight_threshold=threshold, least=0.8 * least)
    return [_moved(pose, shift) for shift in _best_apart(fine, scores, least)]


def _points_of(frame: OdometryFrame, pose: Pose) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Points [m] of the coarsest level in the world, in an order that is spread over it, and their main directions."""
    picture, (fx, fy, cx, cy), facets = coarsest_level(frame)
    width, depth, planes = picture.shape[1], picture.ravel(), facets.reshape(-1, 4)
    at = np.flatnonzero((depth > 0) & (planes[:, 3] < 0))
    rays = np.stack([(at % width - cx) / fx, (at // width - cy) / fy, np.ones(len(at))], 1)
    normals = planes[at, :3]
    _, axes = eigh(matmul(normals.T, normals))
    kept = np.random.default_rng(0).permutation(len(at))[:POINTS]
    points = rays[kept] * depth[at[kept], None]
    return matmul(points, pose[:3, :3].T) + pose[:3, 3], matmul(pose[:3, :3], axes)


def _best_apart(shifts: NDArray[np.float64], scores: NDArray[np.float32], least: float) -> list[NDArray[np.float64]]:
    found: list[NDArray[np.float64]] = []
    for index in np.argsort(-scores, kind="stable").tolist():
        if scores[index] < least or len(found) == MOST:
            break
        if all(norm(shifts[index] - other) > APART for other in found):
            found.append(shifts[index])
    return found


@functools.cache
def _ball(radius: int) -> NDArray[np.float64]:
    """Whole steps within a radius, but none."""
    axis = np.arange(-radius, radius + 1)
    steps = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)
    squares = (steps**2).sum(1)
    return steps[(squares <= radius * radius)].astype(np.float64)


@functools.cache
def _steps() -> NDArray[np.float64]:
    """The fine steps within a coarse one."""
    half = BLOCK // FINE / 2
    axis = np.arange(-half + 0.5, half)
    return np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)


def _moved(pose: Pose, shift: NDArray[np.float64]) -> Pose:
    moved = pose.copy()
    moved[:3, 3] += shift
    return moved
