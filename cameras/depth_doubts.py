"""Warnings of depth images that are most likely in another unit than their scale says."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..core.units import asked_by_user, warn_of_units

SCALED = 100.0  # units a metre, from which floats are taken for millimetres or finer
NEAREST = 0.05  # [m] no depth camera measures an image that is nearer everywhere


def warn_of_scale(
    depth: Any, depth_scale: float, depth_trunc: float, limit: str = "depth_trunc", times: float = 1.0
) -> None:
    """Warn a user of a scale or limit that leaves no depth of an image on the host, or of floats only very small ones.

    Args:
        depth: The image as it was given.
        depth_scale: What it is divided by.
        depth_trunc: The farthest depth that is kept [m].
        limit: The name of that argument.
        times: How many times farther all depths have to be.
    """
    if not isinstance(depth, np.ndarray) or not asked_by_user():
        return
    is_scaled_float = depth.dtype.kind == "f" and depth_scale >= SCALED
    least = NEAREST if is_scaled_float else 0.0
    for part in (depth[::8, ::8], depth):
        with np.errstate(invalid="ignore"):
            measured = part[(part > 0) & np.isfinite(part)]
        if not measured.size:
            continue
        low, high = float(measured.min()) / depth_scale, float(measured.max()) / depth_scale
        if low <= depth_trunc * times and high >= least:
            return
    if not measured.size:
        return
    given = f"{measured.size:,} of {measured.dtype} {measured.min()}..{measured.max()}"
    if high < least:
        warn_of_units(
            f"depth_scale: all depth lies within {NEAREST:g} m: {given}, divided by {depth_scale:g}; leave depth_scale "
            "out where floats are metres"
        )
        return
    taken = "metres" if depth.dtype.kind == "f" and depth_scale == 1 else f"{depth_scale:g} units a metre"
    if depth.dtype.kind == "f":
        remedy = "floats in millimetres want depth_scale=1000"
    elif depth_scale < 1000:
        remedy = "integers in millimetres want depth_scale=1000"
    else:
        remedy = "TUM's numbers want depth_scale=5000" if depth_scale < 5000 else "a larger depth_scale brings it near"
    warn_of_units(
        f"depth_scale, {limit}: no depth is left: {given}, taken for {taken}, lie beyond {depth_trunc:g} m; "
        f"{remedy}; what is truly that far wants a larger {limit}"
    )
