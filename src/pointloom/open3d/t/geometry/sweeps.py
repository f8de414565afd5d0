"""Copies of points along a path, for extrusions."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ....kernels.linear_algebra import matmul
from ...core.dtype import float32
from ...core.tensor import Tensor
from .tensor_map import matrix_of


def sweep_along(positions: Tensor, vector: Any, scale: float) -> tuple[Tensor, int]:
    """The points and their copies at the end of a vector, float32 (2 n, 3), and the number of steps, 1."""
    points, step = positions.numpy().astype(np.float64), scale * matrix_of("vector", vector, (3,))
    return Tensor(np.concatenate([points, points + step]), float32, positions.device), 1


def sweep_around(positions: Tensor, angle: float, axis: Any, resolution: int, translation: float) -> tuple[Tensor, int]:
    """The points and their copies after each step of a screw motion, float32, and the number of steps."""
    direction = matrix_of("axis", axis, (3,))
    length = float(np.linalg.norm(direction))
    if not length > 0:
        raise ValueError(f"axis: expected a vector that is not zero, got {direction.tolist()}")
    points, direction = positions.numpy().astype(np.float64), direction / length
    part = np.linspace(0, 1, resolution + 1)[:, None]
    turns = Rotation.from_rotvec(np.radians(angle) * part * direction).as_matrix()
    shifts = (translation * part * direction)[:, None]
    moved = np.concatenate([matmul(points, R.T) + t for R, t in zip(turns, shifts, strict=True)])
    return Tensor(moved, float32, positions.device), resolution
