"""Undoing the motion of a scanner during one turn: every point as the sensor would have seen it at one moment.

The motion is a screw of constant velocity (a twist). One thread a point; reads 16 B, writes 12 B, some 60 operations
and two sine/cosine pairs in float32: 1e-5 m at 100 m.

Source: Vizzo et al. 2023, "KISS-ICP", eqs. 2 to 4, with the translation on the screw too, so that a vehicle in a
curve is followed exactly; referred to the end of the scan, not its start.
"""

import math

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Doubles, Points
from ..arrays.runs import Runs, elements_of, row_of
from ..lang import (
    INFINITY,
    NAN,
    array,
    atomic_max,
    cross,
    float64,
    func,
    isfinite,
    kernel,
    launch,
    sin,
    struct,
    tid,
    vec3,
    vec3d,
)
from ..linear_algebra import matmul
from ..memory import empty, full

RUN = 4096  # times a thread on the CPU: its two atomics cost less than 1 % of its reads
TINY_ANGLE = 1.0e-12  # [rad] below it a rotation is none in float32


@struct
class ScrewMotion:
    """The motion of a scanner during one turn: a screw of constant velocity.

    Attributes:
        span: float64 [2], times of its beginning and end.
        axis, angle: Of its rotation, a unit vector and [rad].
        velocity: Its translation [m] along the screw.
    """

    span: array(dtype=float64)
    axis: vec3
    angle: float
    velocity: vec3

    def __init__(self, span: Doubles, twist: np.ndarray) -> None:
        """The motion whose logarithm is `twist`, (rotation, translation), float64 [6]."""
        self.span, self.angle = span, math.sqrt(float(matmul(twist[:3], twist[:3])))
        axis = twist[:3] / self.angle if self.angle > 0 else twist[:3]
        self.axis, self.velocity = vec3(*map(float, axis)), vec3(*map(float, twist[3:]))


@func
def move_along_screw(p: vec3, share: float, motion: ScrewMotion) -> vec3:
    """The point p under a share of the motion exp(angle * axis, velocity).

    1 - cos(a) is 2 sin^2(a / 2), which keeps its digits where a is small.
    """
    a = share * motion.angle
    sine = sin(a)
    half = sin(0.5 * a)
    versine = 2.0 * half * half
    first = 0.0  # (1 - cos a) / a
    second = 0.0  # (a - sin a) / a
    if abs(a) > TINY_ANGLE:
        first = versine / a
        second = 1.0 - sine / a
    kp = cross(motion.axis, p)
    kv = cross(motion.axis, motion.velocity)
    turned = p + kp * sine + cross(motion.axis, kp) * versine
    moved = (motion.velocity + kv * first + cross(motion.axis, kv) * second) * share
    return turned + moved


@kernel
def bound_times_kernel(points: array(dtype=vec3), times: array(dtype=float64), runs: Runs, ends: array(dtype=float64)):
    """The last finite times, first negative, of points that are finite and not at zero, which means no return."""
    i = tid()
    low = float64(INFINITY)
    high = -float64(INFINITY)
    for j in elements_of(i, runs):
        p = points[j]
        t = times[j]
        if isfinite(p) and isfinite(t):
            if abs(p[0]) + abs(p[1]) + abs(p[2]) > 0.0:
                low = min(low, t)
                high = max(high, t)
    if low <= high:
        at = 2 * row_of(i, runs)
        atomic_max(ends, at, -low)  # the outcome of both does not depend on the order
        atomic_max(ends, at + 1, high)


@kernel
def fold_times_kernel(ends: array(dtype=float64), span: array(dtype=float64)):
    """The first and the last of all times, from those of each row of ends."""
    i = tid()
    low = float64(INFINITY)
    high = -float64(INFINITY)
    for k in range(ends.shape[0] // 2):
        low = min(low, -ends[2 * k])
        high = max(high, ends[2 * k + 1])
    span[i] = low
    span[i + 1] = high


@kernel
def deskew_points_kernel(
    points: array(dtype=vec3), times: array(dtype=float64), origin: vec3d, motion: ScrewMotion, out: array(dtype=vec3)
):
    """Each point as seen at the last time; NaN where its time is none, unless no point has one."""
    i = tid()
    first = motion.span[0]
    last = motion.span[1]
    share = 0.0
    if last > first:
        share = float((times[i] - last) / (last - first))
    elif last == first and not isfinite(times[i]):
        share = float(NAN)
    p = narrow(widen(points[i]) + origin)
    out[i] = move_along_screw(p, share, motion)


def bound_times(points: Points, times: Doubles) -> Doubles:
    """The first and the last time of measured points, float64 [2] on the device; inf and -inf where there are none."""
    runs = Runs(points.size, points.device, RUN)
    ends, span = full(2 * runs.rows, -INFINITY, float64, points.device), empty(2, float64, points.device)
    launch(bound_times_kernel, runs.threads, [points, times, runs, ends])
    launch(fold_times_kernel, 1, [ends, span])
    return span


def deskew_points(points: Points, times: Doubles, origin: np.ndarray, span: Doubles, twist: np.ndarray) -> Points:
    """Points as seen at the last time.

    Args:
        points: Device array of vec3 relative to `origin` [3], in the sensor's frame at each point's own time.
        times: float64 device array; a time outside the span counts by the same motion.
        span: Beginning and end of the turn, as `bound_times` gives them; nothing moves where they are not apart.
        twist: (rotation, translation), float64 [6]: the logarithm of the sensor's motion from first to last.

    Returns:
        Device array of vec3 about zero.
    """
    out = empty(points.size, vec3, points.device)
    motion = ScrewMotion(span, twist)
    launch(deskew_points_kernel, points.size, [points, times, vec3d(*origin), motion, out])
    return out
