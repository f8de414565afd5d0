"""Warn of depth images that probably have another unit than their scale."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..core.units import called_by_user, warn_of_units

MIN_SCALE_OF_INTEGERS = 100.0  # units per meter: floats with a larger scale are probably integers in other units
MIN_FARTHEST_DEPTH = 0.05  # [m] no depth camera measures all pixels closer


def warn_of_scale(
    depth: ArrayLike, depth_scale: float, depth_trunc: float, limit: str = "depth_trunc", times: float = 1.0
) -> None:
    """Warn if scale and limit [m] leave no depth of a host image, or float depth is implausibly small.
    `limit` is the argument's name in the message; `times` is a factor of all depths."""
    if not isinstance(depth, np.ndarray) or not called_by_user():
        return
    is_scaled_float = depth.dtype.kind == "f" and depth_scale >= MIN_SCALE_OF_INTEGERS
    min_depth = MIN_FARTHEST_DEPTH if is_scaled_float else 0.0
    for part in (depth[::8, ::8], depth):
        with np.errstate(invalid="ignore"):
            measured = part[(part > 0) & np.isfinite(part)]
        if not measured.size:
            continue
        low, high = float(measured.min()) / depth_scale, float(measured.max()) / depth_scale
        if low <= depth_trunc * times and high >= min_depth:
            return
    if not measured.size:
        return
    given = f"{measured.size:,} of {measured.dtype} {measured.min()}..{measured.max()}"
    if high < min_depth:
        warn_of_units(
            f"depth_scale: all depths are within {MIN_FARTHEST_DEPTH:g} m: {given}, divided by {depth_scale:g}. Leave "
            "depth_scale out if the floats are meters"
        )
        return
    unit_text = "meters" if depth.dtype.kind == "f" and depth_scale == 1 else f"{depth_scale:g} units per meter"
    if depth.dtype.kind == "f":
        remedy = "for floats in millimeters, pass depth_scale=1000"
    elif depth_scale < 1000:
        remedy = "for integers in millimeters, pass depth_scale=1000"
    else:
        remedy = "for TUM images, pass depth_scale=5000" if depth_scale < 5000 else "pass a larger depth_scale"
    warn_of_units(
        f"depth_scale, {limit}: no depth remains: {given}, read as {unit_text}, are beyond {depth_trunc:g} m; "
        f"{remedy}. If the scene is that far away, pass a larger {limit}"
    )
