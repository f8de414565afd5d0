"""Per-voxel selections: octants, points nearest to the mean or center, most common value. No atomics."""

from typing import TYPE_CHECKING

import numpy as np

from ..algebra.transform import widen
from ..array_types import AnyArray, Indices, Points
from ..lang import INFINITY, array, compute, float64, floor, func, int32, int64, kernel, launch, tid, vec3, vec3d
from ..memory import cast, empty, full
from ..search.neighbor_keys import sort_keys

if TYPE_CHECKING:
    from ..arrays.unique import UniqueKeys

CHANNEL_STEPS = 2097151.0  # 2^21 - 1: three channels of 21 bits per key, resolution 5e-7


@func
def octant_of(p: vec3, corner: vec3d, size: float64) -> int:
    """Octant of a point in its voxel: 1 for the upper half along x, 2 along y, 4 along z."""
    octant = 0
    for axis in range(3):
        coordinate = (float64(p[axis]) - corner[axis]) / size
        if coordinate - floor(coordinate) >= 0.5:
            octant = octant | (1 << axis)
    return octant


@kernel
def trace_voxels_kernel(
    points: array(dtype=vec3),
    order: array(dtype=int32),
    starts: array(dtype=int32),
    corner: vec3d,
    size: float64,
    octants: array(dtype=int32),
    voxels: array(dtype=int32),
):
    """Last point in each octant of each voxel, and the voxel of each point. Others stay -1."""
    i = tid()
    for j in range(starts[i], starts[i + 1]):
        row = order[j]
        octants[8 * i + octant_of(points[row], corner, size)] = row
        voxels[row] = i


@kernel
def nearest_to_mean_kernel(
    points: array(dtype=vec3), order: array(dtype=int32), starts: array(dtype=int32), rows: array(dtype=int32)
):
    """Point of each run nearest to its mean, ties to the first."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    for j in range(starts[i], starts[i + 1]):
        total += widen(points[order[j]])
    mean = total / float64(starts[i + 1] - starts[i])
    best = float64(INFINITY)
    row = order[starts[i]]
    for j in range(starts[i], starts[i + 1]):
        d = widen(points[order[j]]) - mean
        sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
        if sqdist < best:
            best = sqdist
            row = order[j]
    rows[i] = row


@func
def square_off_middle(p: vec3, corner: vec3d, size: float64) -> float64:
    total = float64(0.0)
    for axis in range(3):
        coordinate = (float64(p[axis]) - corner[axis]) / size
        off = coordinate - floor(coordinate) - 0.5
        total += off * off
    return total


@kernel
def nearest_to_middle_kernel(
    points: array(dtype=vec3),
    order: array(dtype=int32),
    starts: array(dtype=int32),
    corner: vec3d,
    size: float64,
    rows: array(dtype=int32),
):
    """Point of each run nearest to its voxel center, ties to the first."""
    i = tid()
    best = float64(INFINITY)
    row = order[starts[i]]
    for j in range(starts[i], starts[i + 1]):
        sqdist = square_off_middle(points[order[j]], corner, size)
        if sqdist < best:
            best = sqdist
            row = order[j]
    rows[i] = row


@kernel
def encode_colors_kernel(colors: array(dtype=vec3), keys: array(dtype=int64)):
    """Color as a key, with channels clamped to 0..1."""
    i = tid()
    c = colors[i]
    key = int64(0)
    for channel in range(3):
        value = int(min(max(c[channel], 0.0), 1.0) * CHANNEL_STEPS + 0.5)
        key = (key << 21) | int64(value)
    keys[i] = key


@kernel
def commonest_rows_kernel(
    keys: array(dtype=int64),
    order: array(dtype=int32),
    starts: array(dtype=int32),
    scratch: array(dtype=int64),
    rows: array(dtype=int32),
):
    """First row of each run with its most common key. Ties to the lowest key."""
    i = tid()
    begin = starts[i]
    end = starts[i + 1]
    for j in range(begin, end):
        scratch[j] = keys[order[j]]
    sort_keys(scratch, begin, 1, end - begin)
    best = scratch[begin]
    max_length = 0
    length = 0
    for j in range(begin, end):
        length += 1
        if j + 1 == end or scratch[j + 1] != scratch[j]:
            if length > max_length:
                max_length = length
                best = scratch[j]
            length = 0
    row = -1
    for j in range(begin, end):
        if row < 0 and keys[order[j]] == best:
            row = order[j]
    rows[i] = row


def trace_voxels(points: Points, groups: "UniqueKeys", corner: np.ndarray, size: float) -> tuple[Indices, Indices]:
    """(octants int32 (8 m), last point per octant; voxels int32 (n) of the points); -1 for none."""
    octants = full(8 * groups.count, -1, int32, points.device)
    voxels = full(points.size, -1, int32, points.device)
    arguments = [points, groups.order, groups.starts, vec3d(*corner), size, octants, voxels]
    launch(trace_voxels_kernel, groups.count, arguments)
    return octants, voxels


def nearest_to_means(points: Points, groups: "UniqueKeys") -> Indices:
    """Row of the point nearest to the mean of each voxel, int32 (m)."""
    return compute(nearest_to_mean_kernel, groups.count, [points, groups.order, groups.starts], int32, points.device)


def nearest_to_middles(points: Points, groups: "UniqueKeys", corner: np.ndarray, size: float) -> Indices:
    """Row of the point nearest to the center of each voxel, int32 (m)."""
    rows = empty(groups.count, int32, points.device)
    launch(nearest_to_middle_kernel, groups.count, [points, groups.order, groups.starts, vec3d(*corner), size, rows])
    return rows


def commonest_rows(values: AnyArray, groups: "UniqueKeys") -> Indices:
    """A row of each voxel with its most common value, int32 (m); `values` are integers (n) or vec3 colors."""
    if values.dtype == vec3:
        keys = compute(encode_colors_kernel, values.size, [values], int64, values.device)
    else:
        keys = cast(values, int64)
    rows = empty(groups.count, int32, values.device)
    scratch = empty(values.size, int64, values.device)
    launch(commonest_rows_kernel, groups.count, [keys, groups.order, groups.starts, scratch, rows])
    return rows
