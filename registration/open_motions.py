"""Motions along which points lie as well as where they are: what makes one, and how it is told."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ..kernels.linear_algebra import eigh, matmul
from .rigid import make_pose, nearest_rotation, rotation_of

Matrix = NDArray[np.float64]

# Of the squared components of the planes' normals (turns: of their levers, by the mean lever). Bare corridors and
# tunnels have 0.0001 to 0.03 along them, the latter right after the start, where planes rest on few points; streets,
# halls and woods 0.02 to 0.3.
SUSPECT_SHARE = 0.03
STEP_VOXELS = 0.75  # edges of a voxel that points are moved by, along and against a suspect; turns at the mean lever
JUDGING_POINTS = 1024  # of a scan, about: they show a rise of 0.01 in the mean cost
# Mean rise of the costs (0..1) a step along, and in standard deviations. Where nothing tells, -0.012 to 0.011 and 2.4
# at most on three made corridors, a tunnel and a field; where little does (doors of 6 cm, boxes far off), 0.03 and 5.
LEAST_RISE, LEAST_DEVIATIONS = 0.02, 3.0


def rises_clearly(rises: Matrix) -> NDArray[np.bool_]:
    """Whether points lie worse at other poses, [k], by what `compare_costs` gives of them."""
    total, square, pairs, _ = rises.T
    is_much = total >= LEAST_RISE * np.maximum(pairs, 1)
    return is_much & (total >= LEAST_DEVIATIONS * np.sqrt(np.maximum(square, 1)))


def moved(pose: Matrix, motion: Matrix, about: Matrix | None = None) -> Matrix:
    """A pose turned about a place, that of the sensor if none, and then shifted: (turn [rad], translation [m])."""
    turn, place = rotation_of(motion[:3]), pose[:3, 3]
    middle = place if about is None else about
    return make_pose(nearest_rotation(matmul(turn, pose[:3, :3])), matmul(turn, place - middle) + middle + motion[3:])


def spanned(rows: Matrix) -> tuple[tuple[float, float, float], ...]:
    """The directions that the columns of a matrix [3, k] span, those of little weight left out.

    The largest part of each is positive.
    """
    squares, vectors = eigh(matmul(rows, rows.T))
    kept = vectors.T[::-1][squares[::-1] > 0.5]
    signs = [math.copysign(1.0, row[np.abs(row).argmax()]) for row in kept]
    return tuple(tuple(float(v) for v in row * sign) for row, sign in zip(kept, signs, strict=True))  # type: ignore[misc]
