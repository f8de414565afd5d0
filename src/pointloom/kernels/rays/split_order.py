"""Point order by recursive splits along the longest side of the box, for trees over aligned runs. One sort per level
(14 at 70,000 points, a Hilbert curve takes one), but ray casting takes two thirds of the time.
"""

from ..array_types import Indices, Points
from ..arrays.lanes import high_of_lanes, low_of_lanes
from ..arrays.select import gather_rows
from ..arrays.sort import SortKeys, put_key
from ..lang import (
    INFINITY,
    WARP,
    array,
    atomic_max,
    atomic_min,
    float32,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    tid,
    vec3,
)
from ..memory import empty, fill

POINTS_PER_THREAD = 512  # to bound, on CUDA per warp: few atomics
STEP_BITS = 16  # of a coordinate in its run's box
MAX_GRID_STEP = 65535.0


@func
def widen_run(run: int, a: vec3, b: vec3, part: int, size: int, low: array(dtype=float32), high: array(dtype=float32)):
    """Include the box of a part in that of its run. The only part of a run sets it."""
    for axis in range(3):
        if part == size:
            low[3 * run + axis] = a[axis]
            high[3 * run + axis] = b[axis]
        else:
            atomic_min(low, 3 * run + axis, a[axis])
            atomic_max(high, 3 * run + axis, b[axis])


@kernel
def bound_runs_kernel(
    points: array(dtype=vec3),
    order: array(dtype=int32),
    part: int,
    size: int,
    low: array(dtype=float32),
    high: array(dtype=float32),
):
    """Box of each run; if a run has several parts, it is shrunk to each of them (atomics, in any order)."""
    i = tid()
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(i * part, min((i + 1) * part, order.shape[0])):
        p = points[order[j]]
        a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
        b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
    widen_run(i * part // size, a, b, part, size, low, high)


@bound_runs_kernel.on_cuda
def bound_runs_by_lanes_kernel(
    points: array(dtype=vec3),
    order: array(dtype=int32),
    part: int,
    size: int,
    low: array(dtype=float32),
    high: array(dtype=float32),
):
    i = tid()
    head = i // WARP * part
    last = min(head + part, order.shape[0])
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    j = head + i % WARP
    while j < last:
        p = points[order[j]]
        a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
        b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
        j += WARP
    a = low_of_lanes(a)
    b = high_of_lanes(b)
    if i % WARP == 0:
        widen_run(head // size, a, b, part, size, low, high)


@func
def longest_side(low: array(dtype=float32), high: array(dtype=float32), run: int) -> int:
    axis = 0
    for k in range(1, 3):
        if high[3 * run + k] - low[3 * run + k] > high[3 * run + axis] - low[3 * run + axis]:
            axis = k
    return axis


@kernel
def key_positions_kernel(
    points: array(dtype=vec3),
    order: array(dtype=int32),
    size: int,
    low: array(dtype=float32),
    high: array(dtype=float32),
    keys: SortKeys,
):
    """Run of each position above the coordinate along the run's longest side."""
    i = tid()
    run = i // size
    axis = longest_side(low, high, run)
    lowest = low[3 * run + axis]
    extent = high[3 * run + axis] - lowest
    p = points[order[i]]
    step = 0
    if extent > 0.0 and isfinite(extent):
        step = int((p[axis] - lowest) / extent * MAX_GRID_STEP)
    put_key(i, (int64(run) << int64(STEP_BITS)) | int64(step), keys)


def order_by_splits(points: Points, rows: Indices, unit: int) -> Indices:
    """Finite `rows` (ascending) of points in split order, int32; `unit` points in the smallest runs. No sync."""
    device, count, order = points.device, rows.size, rows
    half = unit
    while 2 * half < count:
        half *= 2
    room = 3 * -(-count // (2 * unit))  # for the boxes of the smallest runs
    low, high, keys = empty(room, float32, device), empty(room, float32, device), SortKeys(count, device)
    while half >= unit and count > unit:
        size = 2 * half
        runs, part = -(-count // size), min(POINTS_PER_THREAD, size)
        if part < size:
            fill(low, float("inf"))
            fill(high, float("-inf"))
        threads = -(-count // part) * (WARP if device.is_cuda else 1)
        launch(bound_runs_kernel, threads, [points, order, part, size, low, high])
        launch(key_positions_kernel, count, [points, order, size, low, high, keys])
        _, permutation = keys.sort(STEP_BITS + max(1, (runs - 1).bit_length()))
        order = gather_rows(order, permutation)
        half //= 2
    return order
