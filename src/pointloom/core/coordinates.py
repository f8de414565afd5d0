"""Coordinates as float32 relative to a float64 origin, so that kernels are accurate far from zero.

float32 has 24 bits: 0.5 m at UTM coordinates (5e5, 5.4e6), 0.5 mm at 9 km. Points that are far from zero relative to
their spread get an origin near their median.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kernels.linear_algebra import matmul
from .checks import LARGEST_NUMBER
from .units import warn_of_units

ORIGIN_LIMIT = 1.0e4  # larger coordinates always move the origin: below it float32 resolves 1 mm
MEDIAN_SAMPLE = 4096  # sample size of the median for the origin
SPREAD_SAMPLE = 128  # of these, for the decision whether zero is far
FAR_FROM_ZERO = 32.0  # times the spread: about 8 times the extent of a uniform cloud, which costs 3 of 24 bits
_MAX_DECIMALS = 12  # maximum decimals of an origin: more would be float64 rounding
NEAR_ZERO = 128.0  # [m] sensor positions within this keep the origin at zero: float32 resolves 8 um there
FLOAT32_MAX = float(np.finfo(np.float32).max)
MIN_STEPS = 2.0**14  # float32 steps per spread (about a quarter of the extent) of points that need no warning


def quiet() -> np.errstate:
    """Suppress NumPy warnings of NaN (also signaling) and infinity."""
    return np.errstate(invalid="ignore", over="ignore")


@quiet()
def split_origin(
    points: NDArray[Any], origin: NDArray[np.float64] | None = None
) -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """Split points (n, 3) into float32 offsets and an origin (3,), by default that of `choose_origin`.
    Points too far apart raise `ValueError`, or become infinite with a given origin."""
    if origin is None:
        origin = _choose_origin(points, None)
    if not origin.any():
        return np.ascontiguousarray(points, dtype=np.float32), origin
    return (points.astype(np.float64, copy=False) - origin).astype(np.float32), origin


@quiet()
def choose_origin(points: NDArray[Any], steps: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
    """The origin of points (n, 3), float64 (3,): zero, or near the median, which is robust to outliers.
    `steps` (3,) is the coordinate step of a file. An axis whose steps float32 cannot resolve, such as degrees in steps
    of 1e-7, is moved to the median in whole thousands of steps if most points are closer to it. Raises `ValueError`
    beyond float32."""
    return _choose_origin(points, steps)


def _choose_origin(points: NDArray[Any], steps: NDArray[np.float64] | None) -> NDArray[np.float64]:
    if not points.size:
        return np.zeros(3)
    low = high = np.zeros(3)
    is_near = points.min() >= -ORIGIN_LIMIT and points.max() <= ORIGIN_LIMIT  # false for NaN
    if is_near and steps is None and is_plainly_around_zero(points):
        return low
    if not is_near:
        low, high = finite_box(points)
        max_coordinate = max(np.abs(low).max(), np.abs(high).max())
        if max_coordinate > LARGEST_NUMBER:
            given = f"{low.tolist()}..{high.tolist()}"
            raise ValueError(
                f"points: {given} are beyond the float32 range about their center, and beyond {LARGEST_NUMBER:g} m"
            )
        is_near = max_coordinate <= ORIGIN_LIMIT
    origin = np.zeros(3)
    if not is_near or is_far_from_zero(sample_points(points, SPREAD_SAMPLE)):
        origin = origin_of_sample(sample_points(points))
    if not is_near:
        if max((high - origin).max(), (origin - low).max()) > FLOAT32_MAX:
            origin = np.round(low / 2 + high / 2)
        if max((high - origin).max(), (origin - low).max()) > FLOAT32_MAX:
            raise ValueError(f"points: {low.tolist()}..{high.tolist()} are beyond the float32 range about their center")
    return origin if steps is None else _refine(origin, sample_points(points), steps)


def warn_if_coarse(name: str, points: NDArray[Any], origin: NDArray[np.float64]) -> None:
    """Warn if points (n, 3) are float32 and so far from zero that digits have been lost."""
    if points.dtype == np.float32 and origin.any():
        with quiet():
            sample = sample_points(points, SPREAD_SAMPLE)
        warn_of_steps(name, sample)


@quiet()
def warn_of_steps(name: str, sample: NDArray[np.float64]) -> None:
    """`warn_if_coarse` for a finite sample (n, 3) of float32 coordinates."""
    middle, spread = _spread_of(sample)
    farthest = np.abs(middle).max()
    step = float(np.spacing(np.float32(farthest)))
    if 0 < spread.max() < MIN_STEPS * step:
        warn_of_units(
            f"{name}: float32 coordinates near {farthest:.0f} are multiples of {step:g}, and the points spread over "
            f"only {spread.max():g} about their median. Pass them as float64, or subtract an offset in float64 before "
            "the conversion to float32",
            UserWarning,
        )


@quiet()
def origin_of_sample(sample: NDArray[np.float64]) -> NDArray[np.float64]:
    """Origin from a finite sample (n, 3): the median in meters, or finer (power of two) on axes of small extent."""
    return _rounded(*_spread_of(sample))


def _spread_of(sample: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The median and the median deviation per axis. The extent if most points coincide."""
    middle = _median(sample)
    spread = _median(np.abs(sample - middle))
    return middle, spread if spread.any() else np.ptp(sample, axis=0)


def _median(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """`np.median(rows, axis=0)` of finite rows, without importing numpy.ma, which is slow."""
    low, high = (len(rows) - 1) // 2, len(rows) // 2
    parts = np.partition(rows, (low, high), axis=0)
    return (parts[low] + parts[high]) / 2


def is_far_from_zero(sample: NDArray[np.float64]) -> bool:
    """True if the median of a finite sample is more than 32 times its spread (largest median deviation) from zero."""
    middle, spread = _spread_of(sample)
    return bool(spread.any() and np.abs(middle).max() > FAR_FROM_ZERO * spread.max())


def is_plainly_around_zero(points: NDArray[Any]) -> bool:
    """True only if `is_far_from_zero` is false for the sample of finite points.
    Half of the points are beyond the quartiles, so the spread is at least the distance from the median to the nearer
    one."""
    if points.dtype.itemsize > 8:  # float64 would round small numbers to zero
        return False
    columns = np.array(points[:: len(points) // SPREAD_SAMPLE | 1].T, dtype=np.float64, order="C")
    is_used = columns.any(axis=0)
    if not is_used.all():
        columns = columns[:, is_used]
    count = columns.shape[1]
    if count < 2:  # a single point has no spread
        return count == 1
    columns.sort(axis=1)
    below, first = (count - 1) // 2, count // 4
    last = min(first + below + 1, count - 1)
    largest = spread = 0.0  # of the three axes
    for a, left, right, b in columns[:, (first, below, count // 2, last)].tolist():
        median = (left + right) / 2
        largest, spread = max(largest, abs(median)), max(spread, min(median - a, b - median))
    return largest <= FAR_FROM_ZERO * spread


def _is_box_around_zero(low: list[float], high: list[float]) -> bool:
    """True only if the origin of the two corners is zero: `is_plainly_around_zero` without NumPy."""
    largest = spread = 0.0
    for a, b in zip(low, high, strict=True):
        if not (-ORIGIN_LIMIT <= a <= ORIGIN_LIMIT and -ORIGIN_LIMIT <= b <= ORIGIN_LIMIT):
            return False
        median = (a + b) / 2
        largest, spread = max(largest, abs(median)), max(spread, min(median - a, b - median))
    return largest <= FAR_FROM_ZERO * spread


def _rounded(position: NDArray[np.float64], spread: NDArray[np.float64]) -> NDArray[np.float64]:
    finest = np.spacing(np.abs(position).max())  # of float64
    steps = np.array([2.0 ** min(0, math.floor(math.log2(max(16 * s, finest)))) if s > 0 else 1.0 for s in spread])
    return np.round(position / steps) * steps


def origin_of_sensor(position: NDArray[np.float64]) -> NDArray[np.float64]:
    """Origin for measurements of a sensor at a position [m], shape (3,): zero within 128 m, else whole meters."""
    return np.round(position) if np.abs(position).max() > NEAR_ZERO else np.zeros(3)


def origin_under(
    name: str,
    A: NDArray[np.float64],
    t: NDArray[np.float64],
    low: NDArray[np.float64],
    high: NDArray[np.float64],
    moved: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Origin after an affine map x -> A x + t of the box `low` to `high`; `moved` is the mapped origin, shape (3,)."""
    middle, half = matmul(A, (low + high) / 2) + t, matmul(np.abs(A), (high - low) / 2)
    corners = np.stack([middle - half, middle + half])
    if _is_box_around_zero(*corners.tolist()):
        return np.zeros(3)
    if not np.abs(corners).max() <= LARGEST_NUMBER or np.ptp(corners, axis=0).max() > 2 * FLOAT32_MAX:
        bounds = f"{corners[0].tolist()}..{corners[1].tolist()}"
        raise ValueError(f"{name}: moves the points to {bounds}, beyond the float32 range about their center")
    origin = choose_origin(corners)
    if not origin.any():
        return origin
    carried = _rounded(moved, np.ptp(corners, axis=0) / 4)
    # The old origin is near most points, whatever outliers do to their bounding box.
    return carried if np.abs(corners - carried).max() < FLOAT32_MAX else origin


@quiet()
def written_steps(points: NDArray[Any]) -> NDArray[np.float64] | None:
    """Decimal steps of coordinates from formats that do not store them, for `choose_origin`. None if not needed."""
    if points.dtype != np.float64 or not len(points):
        return None
    sample = sample_points(points)
    middle = _median(sample)
    spread = _median(np.abs(sample - middle))
    if not (np.abs(middle) > FAR_FROM_ZERO * spread)[:2].any():
        return None
    return np.array([10.0 ** -_decimals(column) for column in sample.T])


def _decimals(values: NDArray[np.float64]) -> int:
    for decimals in range(_MAX_DECIMALS):
        if (np.round(values, decimals) == values).all():
            return decimals
    return _MAX_DECIMALS


def _refine(
    origin: NDArray[np.float64], sample: NDArray[np.float64], steps: NDArray[np.float64]
) -> NDArray[np.float64]:
    refined, middle = origin.copy(), np.median(sample, axis=0)
    for axis, step in enumerate(steps):
        decimals = min(max(-math.ceil(math.log10(1000 * step)), -30), _MAX_DECIMALS)
        nearer = np.round(middle[axis], decimals)
        before, after = (float(np.median(np.abs(sample[:, axis] - value))) for value in (origin[axis], nearer))
        if np.spacing(np.float32(2 * before)) > step and after < before / 2:  # twice: half the points are farther out
            refined[axis] = nearer
    return refined


def sample_points(points: NDArray[Any], size: int = MEDIAN_SAMPLE) -> NDArray[np.float64]:
    """The finite nonzero points (scanners may write zero for no return), subsampled if many. One zero point if none."""
    for step in (len(points) // size | 1, 1):  # odd, so that it is not synchronous with image rows
        part = usable_points(points[::step])
        if len(part):
            return part
    return np.zeros((1, 3))


def usable_points(points: NDArray[Any]) -> NDArray[np.float64]:
    finite = np.isfinite(points)
    if finite.all() and points.all():
        return points.astype(np.float64)
    used = points != 0
    return points[finite[:, 0] & finite[:, 1] & finite[:, 2] & (used[:, 0] | used[:, 1] | used[:, 2])].astype(
        np.float64
    )


def finite_rows(rows: NDArray[Any]) -> NDArray[np.bool_]:
    """Mask (n,) of finite rows (n, 3). By columns, as NumPy is six times slower along short rows."""
    finite = np.isfinite(rows)
    return finite[:, 0] & finite[:, 1] & finite[:, 2]


@quiet()
def finite_box(points: NDArray[Any]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Bounds of the finite points, float64 (3,) each; zeros if there are none."""
    return box_of_finite(points) or (np.zeros(3), np.zeros(3))


@quiet()
def box_of_finite(points: NDArray[Any]) -> tuple[NDArray[np.float64], NDArray[np.float64]] | None:
    """Bounds of the finite points, float64 (3,) each. None if there are none."""
    if not len(points):
        return None
    if points.dtype.kind != "f":
        points = points.astype(np.float64)
    # By columns: NumPy's reduction along the first of two axes is five times slower for rows of three.
    low = np.array([column.min(initial=np.inf) for column in points.T])
    high = np.array([column.max(initial=-np.inf) for column in points.T])
    if not (np.isfinite(low).all() and np.isfinite(high).all()):
        finite = points[finite_rows(points)]
        if not len(finite):
            return None
        low, high = finite.min(axis=0), finite.max(axis=0)
    return low.astype(np.float64), high.astype(np.float64)


def describe_bounds(points: NDArray[Any]) -> dict[str, list[float]] | None:
    """Bounds of the finite points as JSON types, for `format_bounds`. None if there are none."""
    box = box_of_finite(points)
    return None if box is None else {"min": box[0].tolist(), "max": box[1].tolist()}
