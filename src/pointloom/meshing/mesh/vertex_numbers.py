"""Validation of vertex indices."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_numeric
from ...core.exchange import on_host
from ...kernels.memory import download


def check_vertices(name: str, values: object, count: int) -> NDArray[np.int32]:
    """Vertex indices as int32 (n,), n >= 1, each in 0..count-1."""
    numbers = check_numeric(name, on_host(name, values))
    if numbers.ndim != 1:
        raise ValueError(f"{name}: expected shape [n], got {list(numbers.shape)}")
    if not numbers.size:
        raise ValueError(f"{name}: expected at least one vertex, got none")
    if numbers.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected whole numbers, got {numbers.dtype}")
    wrong = (numbers < 0) | (numbers >= count)
    if wrong.any():
        raise ValueError(f"{name}: expected vertex indices from 0 to {count - 1}, got {numbers[wrong][0]}")
    return numbers.astype(np.int32)


def check_finite_vertices(name: str, numbers: NDArray[np.int32], positions: object) -> None:
    """Raise ValueError if a vertex (vec3 device array) is not finite."""
    lost = ~np.isfinite(download(positions).reshape(-1, 3)).all(axis=1)
    if lost.any():
        raise ValueError(f"{name}: vertex {numbers[lost][0]} is NaN or infinite. Leave it out")
