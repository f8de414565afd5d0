"""Bounding box and count of the finite points of a cloud. Atomics on integers, order-independent."""

from collections.abc import Sequence

import numpy as np

from ..array_types import Array1, Integers, Points
from ..lang import (
    INFINITY,
    WARP,
    array,
    atomic_add,
    atomic_max,
    bits_float,
    compute,
    float32,
    float_bits,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    tid,
    vec3,
)
from ..memory import download, empty, full, host_view, zeros
from .lanes import high_of_lanes, low_of_lanes, sum_int_of_lanes
from .runs import Runs, elements_of, row_of

RUN_POINTS = 4096  # points per thread on the CPU: atomics cost less than 1 % of the reads
MAGNITUDE_BITS = 0x7FFF_FFFF  # bits of a float32 without the sign
EMPTY_EXTREME = -0x8000_0000  # below all float keys, and the initial count
COLUMN_COUNT = 7  # columns of a result: the largest -x, -y, -z, x, y, z, and the count


@func
def ordered_bits(x: float) -> int:
    """Integer with the order of the float."""
    bits = float_bits(x)
    return bits ^ ((bits >> 31) & MAGNITUDE_BITS)


def numbers_of_bits(ordered: np.ndarray) -> np.ndarray:
    """The float32 numbers of int32 `ordered_bits`."""
    return (ordered ^ ((ordered >> 31) & np.int32(MAGNITUDE_BITS))).view(np.float32)


@func
def number_of_bits(ordered: int) -> float:
    """The float of `ordered_bits`."""
    return bits_float(ordered ^ ((ordered >> 31) & MAGNITUDE_BITS))


@func
def merge_box(i: int, low: vec3, high: vec3, count: int, runs: Runs, extremes: array(dtype=int32)):
    """Widen a row's box by a thread's box with `count` points."""
    if count > 0:
        at = row_of(i, runs) * COLUMN_COUNT
        for axis in range(3):
            atomic_max(extremes, at + axis, ordered_bits(-low[axis]))
            atomic_max(extremes, at + 3 + axis, ordered_bits(high[axis]))
        atomic_add(extremes, at + 6, count)


@merge_box.on_cuda
def merge_box_of_lanes(i: int, low: vec3, high: vec3, count: int, runs: Runs, extremes: array(dtype=int32)):
    """CUDA variant: one atomic per warp."""
    at = row_of(i, runs) * COLUMN_COUNT
    total = sum_int_of_lanes(count)
    a = low_of_lanes(low)
    b = high_of_lanes(high)
    if i % WARP == 0:
        for axis in range(3):
            atomic_max(extremes, at + axis, ordered_bits(-a[axis]))
            atomic_max(extremes, at + 3 + axis, ordered_bits(b[axis]))
        atomic_add(extremes, at + 6, total)


@kernel
def bound_points_kernel(points: array(dtype=vec3), runs: Runs, extremes: array(dtype=int32)):
    i = tid()
    x0 = float(INFINITY)
    y0 = float(INFINITY)
    z0 = float(INFINITY)
    x1 = -float(INFINITY)
    y1 = -float(INFINITY)
    z1 = -float(INFINITY)
    count = 0
    for j in elements_of(i, runs):
        p = points[j]
        if isfinite(p):
            x0 = min(x0, p[0])
            y0 = min(y0, p[1])
            z0 = min(z0, p[2])
            x1 = max(x1, p[0])
            y1 = max(y1, p[1])
            z1 = max(z1, p[2])
            count += 1
    merge_box(i, vec3(x0, y0, z0), vec3(x1, y1, z1), count, runs, extremes)


@kernel
def fold_box_kernel(extremes: array(dtype=int32), box: array(dtype=float32)):
    """Box coordinate over all rows, low corner first. 0 if no point is finite."""
    i = tid()
    largest = int(EMPTY_EXTREME)
    count = int(EMPTY_EXTREME)
    for row in range(extremes.shape[0] // COLUMN_COUNT):
        largest = max(largest, extremes[row * COLUMN_COUNT + i])
        count = max(count, extremes[row * COLUMN_COUNT + 6])
    end = number_of_bits(largest)
    if i < 3:
        end = -end
    if count == EMPTY_EXTREME or end == 0.0:  # atomics keep either zero or minus zero; `+ 0` would be optimized away
        end = 0.0
    box[i] = end


def find_extremes(points: Points) -> Integers:
    """Partial boxes, int32, COLUMN_COUNT numbers per row, for `box_of` on the host. No sync."""
    runs = Runs(points.size, points.device, RUN_POINTS)
    extremes = full(runs.rows * COLUMN_COUNT, EMPTY_EXTREME, int32, points.device)
    launch(bound_points_kernel, runs.threads, [points, runs, extremes])
    return extremes


def find_box(points: Points) -> Array1[float32]:
    """Box of the finite points on their device: low and high corner, float32 (6). No sync."""
    return compute(fold_box_kernel, 6, [find_extremes(points)], float32, points.device)


Box = tuple[np.ndarray, np.ndarray, int]  # low and high corner, float32 (3), and the count of finite points


def bound_points(points: Points) -> Box:
    """Box of the finite points: (low, high, count) on the host, infinite if none is finite. One sync."""
    if points.device.is_cuda:
        return bound_each([points])[0]
    runs, extremes = Runs(points.size, points.device, RUN_POINTS), empty(COLUMN_COUNT, int32, points.device)
    host = host_view(extremes)
    host[:] = EMPTY_EXTREME
    launch(bound_points_kernel, runs.threads, [points, runs, extremes])
    return box_of(host)


def bound_each(clouds: Sequence[Points]) -> list[Box]:
    """As `bound_points` for several arrays on one device. One sync."""
    device = clouds[0].device
    runs = [Runs(points.size, device, RUN_POINTS) for points in clouds]
    ends = np.cumsum([run.rows * COLUMN_COUNT for run in runs]).tolist()
    extremes = full(ends[-1], EMPTY_EXTREME, int32, device)
    for points, run, end in zip(clouds, runs, ends, strict=True):
        launch(bound_points_kernel, run.threads, [points, run, extremes[end - run.rows * COLUMN_COUNT : end]])
    extremes_of_all = download(extremes)  # sync
    return [box_of(extremes_of_all[end - run.rows * COLUMN_COUNT : end]) for run, end in zip(runs, ends, strict=True)]


def box_of(extremes: np.ndarray) -> Box:
    rows = extremes.reshape(-1, COLUMN_COUNT)
    count = sum(rows[:, 6].tolist()) - EMPTY_EXTREME * len(rows)
    if not count:
        return np.full(3, np.inf, np.float32), np.full(3, -np.inf, np.float32), 0
    bits = rows[0, :6] if len(rows) == 1 else rows[:, :6].max(axis=0)
    ends = numbers_of_bits(bits)
    # + 0: normalizes minus zero
    return np.float32(0) - ends[:3], ends[3:] + np.float32(0), count


@kernel
def find_maximum_kernel(values: array(dtype=int32), maximum: array(dtype=int32)):
    """Maximum, which does not depend on the order."""
    i = tid()
    if values[i] > maximum[0]:  # a stale value only adds an atomic
        atomic_max(maximum, 0, values[i])


def maximum_of(values: Integers) -> Integers:
    """Maximum of int32 values and zero, int32 (1) on the device."""
    maximum = zeros(1, int32, values.device)
    launch(find_maximum_kernel, values.size, [values, maximum])
    return maximum
