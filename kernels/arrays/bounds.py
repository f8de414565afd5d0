"""The box and the number of the finite points of a cloud.

12 B read a point; then a thread, on CUDA a warp, settles its points' box with six atomics and one sum, all of whole
numbers, whose outcome does not depend on their order.
"""

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
    float32,
    float_bits,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    shuffle_xor,
    tid,
    vec3,
)
from ..memory import download, empty, full
from .lanes import LANE_BITS, least_of_each, most_of_each
from .runs import Runs, elements_of, row_of

RUN = 4096  # points a thread on the CPU: the atomics of one run cost less than 1 % of its reads
MAGNITUDE = 0x7FFF_FFFF  # the bits of a float32 but its sign
NOTHING = -0x8000_0000  # below the number of every float; and what the count begins with
WIDTH = 7  # numbers of a result: the largest -x, -y, -z, x, y, z, and the count


@func
def ordered_bits(x: float) -> int:
    """The bits of a float as a whole number that is ordered as the float is."""
    bits = float_bits(x)
    return bits ^ ((bits >> 31) & MAGNITUDE)


@func
def settle_box(i: int, low: vec3, high: vec3, count: int, runs: Runs, extremes: array(dtype=int32)):
    """Widen a row's box to a thread's, in which so many points lie."""
    if count > 0:
        at = row_of(i, runs) * WIDTH
        for axis in range(3):
            atomic_max(extremes, at + axis, ordered_bits(-low[axis]))
            atomic_max(extremes, at + 3 + axis, ordered_bits(high[axis]))
        atomic_add(extremes, at + 6, count)


@settle_box.on_cuda
def settle_box_of_lanes(i: int, low: vec3, high: vec3, count: int, runs: Runs, extremes: array(dtype=int32)):
    """One atomic a warp, where there would be 32."""
    at = row_of(i, runs) * WIDTH
    total = count
    for bit in range(LANE_BITS):
        total += shuffle_xor(total, 1 << bit)
    a = least_of_each(low)
    b = most_of_each(high)
    if i % WARP == 0:
        for axis in range(3):
            atomic_max(extremes, at + axis, ordered_bits(-a[axis]))
            atomic_max(extremes, at + 3 + axis, ordered_bits(b[axis]))
        atomic_add(extremes, at + 6, total)


@kernel
def bound_points_kernel(points: array(dtype=vec3), runs: Runs, extremes: array(dtype=int32)):
    """Widen a row's box to a thread's points; NaN and infinite points do not count."""
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
    settle_box(i, vec3(x0, y0, z0), vec3(x1, y1, z1), count, runs, extremes)


@kernel
def fold_box_kernel(extremes: array(dtype=int32), box: array(dtype=float32)):
    """A corner's coordinate of the box of all rows, low ones first; 0 where no point is finite."""
    i = tid()
    most = int(NOTHING)
    count = int(NOTHING)
    for row in range(extremes.shape[0] // WIDTH):
        most = max(most, extremes[row * WIDTH + i])
        count = max(count, extremes[row * WIDTH + 6])
    end = bits_float(most ^ ((most >> 31) & MAGNITUDE))
    if i < 3:
        end = -end
    if count == NOTHING or end == 0.0:  # of zero and minus zero the atomics keep either; `+ 0` is folded away
        end = 0.0
    box[i] = end


def find_extremes(points: Points) -> Integers:
    """What a box is made of, WIDTH numbers a row, int32: for `box_of`, when it is on the host; no sync."""
    runs = Runs(points.size, points.device, RUN)
    extremes = full(runs.rows * WIDTH, NOTHING, int32, points.device)
    launch(bound_points_kernel, runs.threads, [points, runs, extremes])
    return extremes


def find_box(points: Points) -> Array1[float32]:
    """The box of the finite points where they are: the low corner, behind it the high one, float32 [6]; no sync."""
    box = empty(6, float32, points.device)
    launch(fold_box_kernel, 6, [find_extremes(points), box])
    return box


def bound_points(points: Points) -> tuple[np.ndarray, np.ndarray, int]:
    """The box of the finite points.

    Returns:
        (low, high, count): float32 arrays of shape [3] on the host, infinite where no point is finite. One sync.
    """
    return bound_each([points])[0]


def bound_each(clouds: Sequence[Points]) -> list[tuple[np.ndarray, np.ndarray, int]]:
    """As `bound_points`, of each of several arrays on one device. One sync."""
    device = clouds[0].device
    runs = [Runs(points.size, device, RUN) for points in clouds]
    ends = np.cumsum([run.rows * WIDTH for run in runs]).tolist()
    extremes = full(ends[-1], NOTHING, int32, device)
    for points, run, end in zip(clouds, runs, ends, strict=True):
        launch(bound_points_kernel, run.threads, [points, run, extremes[end - run.rows * WIDTH : end]])
    found = download(extremes)  # sync
    return [box_of(found[end - run.rows * WIDTH : end]) for run, end in zip(runs, ends, strict=True)]


def box_of(extremes: np.ndarray) -> tuple[np.ndarray, np.ndarray, int]:
    """(low, high, count), as of `bound_points`."""
    rows = extremes.reshape(-1, WIDTH)
    count = int((rows[:, 6].astype(np.int64) - NOTHING).sum())
    if not count:
        return np.full(3, np.inf, np.float32), np.full(3, -np.inf, np.float32), 0
    bits = rows[:, :6].max(axis=0)
    ends = (bits ^ ((bits >> 31) & np.int32(MAGNITUDE))).view(np.float32)
    # + 0: of zero and minus zero the sums keep either
    return np.float32(0) - ends[:3], ends[3:] + np.float32(0), count
