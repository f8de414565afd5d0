"""Concatenation of arrays, with positions shifted to a common origin."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Array, Points
from ..lang import array, kernel, launch, tid, vec3, vec3d
from ..memory import copy, download, empty, host_view


@kernel
def shift_points_kernel(points: array(dtype=vec3), shift: vec3d, start: int, out: array(dtype=vec3)):
    """out[start + i] = points[i] + shift, in float64."""
    i = tid()
    out[start + i] = narrow(widen(points[i]) + shift)


def concatenate_points(arrays: Sequence[Points], shifts: Sequence[np.ndarray]) -> Points:
    """Concatenate arrays of vec3, each with a float64 (3) shift. Unshifted ones stay bitwise identical."""
    out = empty(sum(a.size for a in arrays), vec3, arrays[0].device)
    start = 0
    for points, shift in zip(arrays, shifts, strict=True):
        if shift.any():
            launch(shift_points_kernel, points.size, [points, vec3d(*shift), start, out])
        else:
            copy(out, points, count=points.size, offset=start)
        start += points.size
    return out


def joined_rows(arrays: Sequence[Array]) -> Array:
    """As `concatenate_rows`, without a copy of a single array."""
    return arrays[0] if len(arrays) == 1 else concatenate_rows(arrays)


def concatenate_rows(arrays: Sequence[Array]) -> Array:
    first = arrays[0]
    out: Any = empty((sum(a.shape[0] for a in arrays), *first.shape[1:]), first.dtype, first.device)
    if not first.device.is_cuda:  # one by one, a thousand small copies take longer
        np.concatenate([download(values) for values in arrays], out=host_view(out))
        return out
    flat, start = out.flatten(), 0
    for values in arrays:
        copy(flat, values.flatten(), count=values.size, offset=start)
        start += values.size
    return out
