"""Warn of depth images that probably have another unit than their scale."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..core.units import asked_by_user, warn_of_units

SCALED = 100.0  # units per meter above which floats are probably millimeters or finer
NEAREST = 0.05  # [m] closer than any depth camera measures everywhere


def warn_of_scale(
    depth: Any, depth_scale: float, depth_trunc: float, limit: str = "depth_trunc", times: float = 1.0
) -> None:
    """Warn if scale and limit [m] leave no depth of a host image, or float depth is implausibly small.
    `limit` is the argument's name in the message; `times` is a factor of all depths."""
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
            "out where floats are meters"
        )
        return
    taken = "meters" if depth.dtype.kind == "f" and depth_scale == 1 else f"{depth_scale:g} units a metre"
    if depth.dtype.kind == "f":
        remedy = "floats in millimeters want depth_scale=1000"
    elif depth_scale < 1000:
        remedy = "integers in millimeters want depth_scale=1000"
    else:
        remedy = "TUM's numbers want depth_scale=5000" if depth_scale < 5000 else "a larger depth_scale brings it near"
    warn_of_units(
        f"depth_scale, {limit}: no depth is left: {given}, taken for {taken}, lie beyond {depth_trunc:g} m; "
        f"{remedy}; what is truly that far wants a larger {limit}"
    )
