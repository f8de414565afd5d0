"""Detection of motions along which points match equally well."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..kernels.linear_algebra import eigh, matmul
from ..kernels.poses.pair_probes import compare_pair, find_pose_constraint
from ..kernels.surface.hollow_side import Surface
from .rigid import make_pose, nearest_rotation, rotation_of, symmetric_matrices
from .surfaces import COSINE, ENOUGH, NEAR, VOXELS

Matrix = NDArray[np.float64]

# Squared components of plane normals (rotations: of their scaled levers). Bare corridors and tunnels have 0.0001 to
# 0.03 along them (more with few points per plane); streets, halls and woods 0.02 to 0.3.
SUSPECT_SHARE = 0.03
STEP_VOXELS = 0.75  # voxels: test displacement both ways. Rotations at the mean lever
JUDGING_POINTS = 1024  # sampled points: detect a mean cost rise of 0.01
# Minimum mean cost rise (0..1) per step, and in standard deviations. Undetermined: -0.012 to 0.011 and at most 2.4
# (three synthetic corridors, a tunnel, a field); weakly determined (doors of 6 cm, far boxes): 0.03 and 5.
MIN_RISE, MIN_DEVIATIONS = 0.02, 3.0
RADIUS_VOXELS = 2.0  # search radius of planes


class JudgedMotions(NamedTuple):
    """Motions about `middle` [m] (rotation times `lever` [m], translation), float64 [d, 6] rows, with their constraint
    0..1, the smallest first, and whether they are "full", "partial" or "none". d of the six are free."""

    middle: Matrix
    lever: float
    motions: Matrix
    shares: Matrix
    kinds: tuple[str, ...]


def judge_motions(
    source: Surface, target: Surface, pose: Matrix, distance: float, free: Sequence[int] = range(6)
) -> JudgedMotions | None:
    """The motions that two surfaces in voxels of `distance` / VOXELS determine. None if they hardly match.

    `pose`: T_target_source about the origins. `free`: the motions that are not fixed. Weakly constrained motions
    are verified: undetermined if the source matches as well when moved both ways.
    """
    if not (len(source) and len(target)):
        return None
    constraint = find_pose_constraint(source, target, pose, distance, NEAR * distance, COSINE)
    if constraint.matches < ENOUGH:
        return None
    size = distance / VOXELS
    (matrix,) = symmetric_matrices(constraint.triangle[None])
    axes = list(free)
    shares, free_vectors = eigh(matrix[np.ix_(axes, axes)] / constraint.matches)
    vectors = np.zeros((6, len(axes)))
    vectors[axes] = free_vectors
    scale = np.array([constraint.lever] * 3 + [1.0] * 3)
    suspects = vectors.T[shares < SUSPECT_SHARE]
    kinds = ["full"] * len(axes)
    if len(suspects):
        steps = [sign * STEP_VOXELS * size * motion / scale for motion in suspects for sign in (-1, 1)]
        poses = np.array([pose, *(moved(pose, step, about=constraint.middle) for step in steps)])
        rises = compare_pair(source, target, JUDGING_POINTS, poses, RADIUS_VOXELS * size, COSINE, size)
        is_constrained: NDArray[np.bool_] = np.logical_and(*rises_clearly(rises[1:]).reshape(-1, 2).T)
        kinds[: len(suspects)] = ["partial" if constrained else "none" for constrained in is_constrained.tolist()]
    return JudgedMotions(constraint.middle, constraint.lever, vectors.T.copy(), np.maximum(shares, 0.0), tuple(kinds))


def rises_clearly(rises: Matrix) -> NDArray[np.bool_]:
    """True where points match clearly worse at other poses, [k], by `compare_costs`."""
    total, square, pairs, _ = rises.T
    is_much = total >= MIN_RISE * np.maximum(pairs, 1)
    return is_much & (total >= MIN_DEVIATIONS * np.sqrt(np.maximum(square, 1)))


def moved(pose: Matrix, motion: Matrix, about: Matrix | None = None) -> Matrix:
    """A pose rotated about a point (default: the sensor), then translated: (rotation [rad], translation [m])."""
    rotation, position = rotation_of(motion[:3]), pose[:3, 3]
    middle = position if about is None else about
    return make_pose(
        nearest_rotation(matmul(rotation, pose[:3, :3])), matmul(rotation, position - middle) + middle + motion[3:]
    )


def spanned(rows: Matrix) -> tuple[tuple[float, float, float], ...]:
    """Significant directions of the column span of a matrix [3, k], the largest component positive."""
    squares, vectors = eigh(matmul(rows, rows.T))
    directions = vectors.T[::-1][squares[::-1] > 0.5]
    signs = [math.copysign(1.0, row[np.abs(row).argmax()]) for row in directions]
    return tuple(tuple(float(v) for v in row * sign) for row, sign in zip(directions, signs, strict=True))  # type: ignore[misc]


def describe_motions(motions: Matrix) -> str:
    """Motions (rotation times a length, translation) [k, 6] in words: "slide along x and rotate about z"."""
    slides, turns = spanned(motions[:, 3:].T), spanned(motions[:, :3].T)
    ways = [f"slide {_directions(slides, 'along')}"] if slides else []
    ways += [f"rotate {_directions(turns, 'about')}"] if turns else []
    return " and ".join(ways) or "slide and rotate together"


def _directions(directions: Sequence[tuple[float, float, float]], preposition: str) -> str:
    """The span of one to three orthonormal directions in words. Two are any in their plane, so its normal is named."""
    if len(directions) == 1:
        return f"{preposition} {_format_direction(directions[0])}"
    if len(directions) == 2:
        first, second = directions
        (upward,) = spanned(np.cross(first, second)[:, None])
        return f"{preposition} any direction perpendicular to {_format_direction(upward)}"
    return f"{preposition} any direction"


def _format_direction(direction: tuple[float, float, float]) -> str:
    largest = int(np.abs(direction).argmax())
    if abs(direction[largest]) > 0.998:
        return "xyz"[largest]
    return f"({', '.join(f'{v:.2f}' for v in direction)})"
