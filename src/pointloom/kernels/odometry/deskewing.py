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
    dot,
    float32,
    float64,
    func,
    isfinite,
    kernel,
    launch,
    sin,
    sqrt,
    struct,
    tid,
    vec3,
    vec3d,
    vector,
)
from ..linear_algebra import matmul
from ..memory import empty, full, upload

TIMES_PER_THREAD = 4096  # times per thread on the CPU: two atomics cost less than 1 % of the reads
SMALL_ANGLE = 1.0e-3  # [rad] below, series to second order are exact in float32
POINTS_PER_THREAD = 256  # points per thread on the CPU
SERIES_ANGLE = 0.5  # [rad] below, the series of half of it are exact in float32

screw = vector(5, float32)  # sine and versine of the rotation, translation [m]


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
def fraction_of(time: float64, motion: ScrewMotion) -> float:
    """Fraction of the motion since the end, -1..0. NaN without a time, unless no point has one."""
    first = motion.span[0]
    last = motion.span[1]
    fraction = 0.0
    if last > first:
        fraction = float((time - last) / (last - first))
    elif last == first and not isfinite(time):
        fraction = float(NAN)
    return fraction


@func
def screw_at(fraction: float, motion: ScrewMotion) -> screw:
    """A fraction of exp(angle * axis, velocity). Half angles are accurate for small ones."""
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
    second = 1.0 - ratio * cosine  # (a - sin a) / a
    t = motion.velocity * fraction + motion.turned * (first * fraction) + motion.turned_twice * (second * fraction)
    return screw(a * ratio * cosine, a * first, t[0], t[1], t[2])


@func
def move_by_screw(p: vec3, by: screw, motion: ScrewMotion) -> vec3:
    kp = cross(motion.axis, p)
    return p + kp * by[0] + cross(motion.axis, kp) * by[1] + vec3(by[2], by[3], by[4])


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
    """Each point as seen at the last time."""
    i = tid()
    p = narrow(widen(points[i]) + origin)
    out[i] = move_by_screw(p, screw_at(fraction_of(times[i], motion), motion), motion)


@kernel(for_cpu=True)
def deskew_runs_kernel(
    points: array(dtype=vec3), times: array(dtype=float64), origin: vec3d, motion: ScrewMotion, out: array(dtype=vec3)
):
    """Runs of points as seen at the last time. Beams of a column often share their time, and so their motion."""
    i = tid()
    time = float64(NAN)
    by = screw(0.0)
    for j in range(i * POINTS_PER_THREAD, min((i + 1) * POINTS_PER_THREAD, points.shape[0])):
        if times[j] != time:
            time = times[j]
            by = screw_at(fraction_of(time, motion), motion)
        out[j] = move_by_screw(narrow(widen(points[j]) + origin), by, motion)


@func
def move_by_twist(p: vec3, rotation: vec3, velocity: vec3) -> vec3:
    """Move p by exp(rotation vector, velocity)."""
    a = sqrt(dot(rotation, rotation))
    first = 1.0  # sin(a) / a
    second = 0.5  # (1 - cos a) / a^2
    third = 0.16666667  # (a - sin a) / a^3
    if a > SMALL_ANGLE:
        half = sin(0.5 * a)
        first = sin(a) / a
        second = 2.0 * half * half / (a * a)
        third = (1.0 - first) / (a * a)
    kp = cross(rotation, p)
    kv = cross(rotation, velocity)
    rotated = p + kp * first + cross(rotation, kp) * second
    return rotated + velocity + kv * second + cross(rotation, kv) * third


@kernel
def deskew_along_path_kernel(
    points: array(dtype=vec3),
    times: array(dtype=float64),
    origin: vec3d,
    span: array(dtype=float64),
    rotations: array(dtype=vec3),
    velocity: vec3,
    out: array(dtype=vec3),
):
    """Each point as seen at the last time, by rotation vectors at equal steps of time. NaN without a time."""
    i = tid()
    first = span[0]
    last = span[1]
    moved = vec3(float(NAN), float(NAN), float(NAN))
    if isfinite(times[i]):
        fraction = 0.0
        if last > first:
            fraction = float((times[i] - last) / (last - first))
        steps = int(rotations.shape[0]) - 1
        place = (fraction + 1.0) * float(steps)
        k = min(max(int(place), 0), steps - 1)
        rotation = rotations[k] + (rotations[k + 1] - rotations[k]) * (place - float(k))
        p = narrow(widen(points[i]) + origin)
        moved = move_by_twist(p, rotation, velocity * fraction)
    out[i] = moved


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
    arguments = [points, times, vec3d(*origin), motion, out]
    if points.device.is_cuda:
        launch(deskew_points_kernel, points.size, arguments)
    else:
        launch(deskew_runs_kernel, -(-points.size // POINTS_PER_THREAD), arguments)
    return out


def deskew_along_path(
    points: Points, times: Doubles, origin: np.ndarray, span: Doubles, rotations: np.ndarray, velocity: np.ndarray
) -> Points:
    """As `deskew_points` for a rotation that is not constant: rotation vectors [n, 3] to the last time, equally spaced.

    12 B per point read and written, 8 B of time. About 80 operations per point."""
    out = empty(points.size, vec3, points.device)
    table = upload(rotations.astype(np.float32), vec3, points.device)
    arguments = [points, times, vec3d(*origin), span, table, vec3(*map(float, velocity)), out]
    launch(deskew_along_path_kernel, points.size, arguments)
    return out
