"""Faces of any number of corners as triangles."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError


def fan_corners(path: Any, lengths: NDArray[np.int64]) -> NDArray[np.int64]:
    """The triangles around the first corner of each face, as places in the list of all corners, shape [t, 3].

    Args:
        path: The file, for errors.
        lengths: Corners of each face, shape [f].

    Raises:
        FileError: A face of fewer than three corners, with its number.
    """
    small = np.flatnonzero(lengths < 3)
    if len(small):
        row = int(small[0])
        raise FileError(path, f"a face has {lengths[row]} corners; at least 3 are needed", where=f"face {row}")
    if (lengths == 3).all():
        return np.arange(3 * len(lengths)).reshape(-1, 3)
    fans = lengths - 2
    firsts = np.repeat(np.cumsum(lengths) - lengths, fans)
    within = np.arange(len(firsts)) - np.repeat(np.cumsum(fans) - fans, fans)
    return np.stack([firsts, firsts + within + 1, firsts + within + 2], axis=1)
