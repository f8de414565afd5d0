"""Motion compensation (deskewing) of a scan: each point as seen at the end of the scan.

Constant-velocity screw motion (Vizzo et al. 2023, "KISS-ICP", eqs. 2 to 4, with the translation on the screw, referred
to the end). Float32 sine and cosine: 1e-5 m at 100 m.
"""

import math

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Doubles, Points
from ..arrays.row_atomics import raise_double
from ..arrays.runs import Runs, elements_of, row_of
from ..lang import (
    INFINITY,
    NAN,
    array,
    cos,
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

TIMES_PER_THREAD = 4096  # times per thread on the CPU: two atomics cost less than 1 % of the reads
SERIES_ANGLE = 0.5  # [rad] below, the series of half of it are exact in float32


@struct
class ScrewMotion:
    """Constant-velocity screw: `span`, start and end times. Rotation `axis`, `angle` [rad]; `velocity` [m], its cross
    product with the axis, `turned`, and that of the axis with this one, `turned_twice`.
    """

    span: array(dtype=float64)
    axis: vec3
    angle: float
    velocity: vec3
    turned: vec3
    turned_twice: vec3

    def __init__(self, span: Doubles, twist: np.ndarray) -> None:
        """Motion exp(`twist`), (rotation, translation), float64 (6)."""
        self.span, self.angle = span, math.sqrt(float(matmul(twist[:3], twist[:3])))
        axis = twist[:3] / self.angle if self.angle > 0 else twist[:3]
        (x, y, z), (u, v, w) = axis.tolist(), twist[3:].tolist()
        a, b, c = y * w - z * v, z * u - x * w, x * v - y * u
        self.axis, self.velocity, self.turned = vec3(x, y, z), vec3(u, v, w), vec3(a, b, c)
        self.turned_twice = vec3(y * c - z * b, z * a - x * c, x * b - y * a)


@func
def move_along_screw(p: vec3, fraction: float, motion: ScrewMotion) -> vec3:
    """Move p by a fraction of exp(angle * axis, velocity). Half angles are accurate for small ones."""
    a = fraction * motion.angle
    h = 0.5 * a
    cosine = 1.0  # of h
    ratio = 1.0  # sin h / h
    if abs(a) < SERIES_ANGLE:  # in a third of the time of sin and cos
        q = h * h
        cosine = 1.0 - q * (0.5 - q * (1.0 / 24.0 - q * (1.0 / 720.0)))
        ratio = 1.0 - q * (1.0 / 6.0 - q * (1.0 / 120.0 - q * (1.0 / 5040.0)))
    else:
        cosine = cos(h)
        ratio = sin(h) / h
    first = ratio * ratio * h  # (1 - cos a) / a
    sine = a * ratio * cosine
    versine = a * first
    second = 1.0 - ratio * cosine  # (a - sin a) / a
    kp = cross(motion.axis, p)
    rotated = p + kp * sine + cross(motion.axis, kp) * versine
    moved = motion.velocity * fraction + motion.turned * (first * fraction) + motion.turned_twice * (second * fraction)
    return rotated + moved


@kernel
def bound_times_kernel(points: array(dtype=vec3), times: array(dtype=float64), runs: Runs, ends: array(dtype=float64)):
    """Time range of finite nonzero points (zero means no return), the first negated."""
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
    at = 2 * row_of(i, runs)
    raise_double(ends, at, -low)
    raise_double(ends, at + 1, high)


@kernel
def fold_times_kernel(ends: array(dtype=float64), span: array(dtype=float64)):
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
    """Each point as seen at the last time. NaN without a time, unless no point has one."""
    i = tid()
    first = motion.span[0]
    last = motion.span[1]
    fraction = 0.0
    if last > first:
        fraction = float((times[i] - last) / (last - first))
    elif last == first and not isfinite(times[i]):
        fraction = float(NAN)
    p = narrow(widen(points[i]) + origin)
    out[i] = move_along_screw(p, fraction, motion)


def bound_times(points: Points, times: Doubles) -> Doubles:
    """First and last time of measured points, float64 (2) on the device; inf and -inf without any."""
    runs = Runs(points.size, points.device, TIMES_PER_THREAD)
    ends, span = full(2 * runs.rows, -INFINITY, float64, points.device), empty(2, float64, points.device)
    launch(bound_times_kernel, runs.threads, [points, times, runs, ends])
    launch(fold_times_kernel, 1, [ends, span])
    return span


def deskew_points(points: Points, times: Doubles, origin: np.ndarray, span: Doubles, twist: np.ndarray) -> Points:
    """Points, in the sensor frame at their times, as seen at the last time; `twist`: log of the motion in `span`."""
    out = empty(points.size, vec3, points.device)
    motion = ScrewMotion(span, twist)
    launch(deskew_points_kernel, points.size, [points, times, vec3d(*origin), motion, out])
    return out
