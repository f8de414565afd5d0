"""Removal of flying pixels between two surfaces. Inverse depth of a plane is linear along a row, so a surface pixel is
on the line through two others on one side. A flying pixel is on neither line and between both.
"""

from ..array_types import Scalars
from ..lang import array, compute, float32, func, kernel, tid


@func
def is_between(w: float, before: float, after: float, jump: float) -> int:
    """True if inverse depth w is between two others, off both by more than `jump` relatively."""
    limit = jump * w
    between = 0
    if (w - before > limit and after - w > limit) or (before - w > limit and w - after > limit):
        between = 1
    return between


@func
def inverse_depth(depth: array(dtype=float32), at: int) -> float:
    """1 / z of a pixel. 0 without depth."""
    z = depth[at]
    w = 0.0
    if z > 0.0:
        w = 1.0 / z
    return w


@kernel
def drop_flying_kernel(
    depth: array(dtype=float32), width: int, height: int, radius: int, jump: float, filtered: array(dtype=float32)
):
    """Drop flying pixels along the row or column, over 1 .. radius pixels on each side."""
    i = tid()
    u = i % width
    v = i // width
    z = depth[i]
    drop = 0
    if z > 0.0:
        w = 1.0 / z
        axes = int(2)
        for axis in range(axes):
            step = 1
            room = min(u, width - 1 - u)
            if axis == 1:
                step = width
                room = min(v, height - 1 - v)
            r = 1
            while r <= radius and 2 * r <= room and drop == 0:
                near_before = inverse_depth(depth, i - r * step)
                far_before = inverse_depth(depth, i - 2 * r * step)
                near_after = inverse_depth(depth, i + r * step)
                far_after = inverse_depth(depth, i + 2 * r * step)
                if near_before > 0.0 and far_before > 0.0 and near_after > 0.0 and far_after > 0.0:
                    line_before = near_before + near_before - far_before
                    line_after = near_after + near_after - far_after
                    # also the pixels themselves: a line through two surfaces before or behind a thin post is no surface
                    drop = is_between(w, line_before, line_after, jump) * is_between(w, near_before, near_after, jump)
                r = r + 1
    if drop == 1:
        z = 0.0
    filtered[i] = z


def drop_flying(depth: Scalars, width: int, height: int, radius: int, jump: float) -> Scalars:
    return compute(drop_flying_kernel, depth.size, [depth, width, height, radius, float(jump)], float32, depth.device)
