"""Which way is up in a view that is fitted: `check_up`, `direction_under`."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...core.checks import check_direction, shown
from .parts import Triple

DIRECTION: Triple = (-0.65, 0.7, -0.75)  # down from the front right, as onto a doll's house
UP: Triple = (0.0, 0.0, 1.0)
AXES: dict[str, Triple] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": UP}


def check_up(up: Any) -> Triple:
    """The direction that is up.

    Raises:
        TypeError: No text and no numbers.
        ValueError: Another text, another shape, or no length.
    """
    if isinstance(up, str):
        if up not in AXES:
            raise ValueError(f"up: expected x, y, z or a direction, got {shown(up)}")
        return AXES[up]
    x, y, z = check_direction("up", up).tolist()
    return x, y, z


def direction_under(up: Triple) -> Triple:
    """The way that a fitted view looks where `up` is up: turned from what it is under z by the least turn.

    Under y that is what files of glTF take for the front, z, seen from its right.

    Example:
        >>> direction_under((0.0, 0.0, 1.0)), direction_under((0.0, 1.0, 0.0))
        ((-0.65, 0.7, -0.75), (-0.65, -0.75, -0.7))
    """
    towards = np.array(up) / np.linalg.norm(up)
    cosine = float(towards[2])
    if cosine < -1 + 1e-9:  # upside down: half a turn about x
        return DIRECTION[0], -DIRECTION[1], -DIRECTION[2]
    axis, way = np.cross(UP, towards), np.array(DIRECTION)
    turned = way + np.cross(axis, way) + np.cross(axis, np.cross(axis, way)) / (1 + cosine)  # Rodrigues
    x, y, z = turned.tolist()
    return x, y, z
