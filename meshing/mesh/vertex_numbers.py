"""The one place that checks numbers of vertices."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_numeric
from ...kernels.memory import download


def check_vertices(name: str, values: Any, count: int) -> NDArray[np.int32]:
    """Numbers of vertices as int32 [n], n at least 1, each in 0..count-1.

    Raises:
        TypeError: No whole numbers.
        ValueError: Another shape, none, or a vertex that does not exist.
    """
    numbers = check_numeric(name, values)
    if numbers.ndim != 1:
        raise ValueError(f"{name}: expected shape [n], got {list(numbers.shape)}")
    if not numbers.size:
        raise ValueError(f"{name}: expected at least one vertex, got none")
    if numbers.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected whole numbers, got {numbers.dtype}")
    wrong = (numbers < 0) | (numbers >= count)
    if wrong.any():
        raise ValueError(f"{name}: vertex {numbers[wrong][0]} does not exist; the mesh has {count}, from 0 on")
    return numbers.astype(np.int32)


def check_finite_vertices(name: str, numbers: NDArray[np.int32], places: Any) -> None:
    """Refuse vertices that are not finite, by their positions, vec3 device array [n].

    Raises:
        ValueError: One is not.
    """
    lost = ~np.isfinite(download(places).reshape(-1, 3)).all(axis=1)
    if lost.any():
        raise ValueError(f"{name}: vertex {numbers[lost][0]} is not finite, so nothing is near it; leave it out")
