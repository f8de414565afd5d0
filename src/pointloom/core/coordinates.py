"""Coordinates as float32 relative to a float64 origin, so that kernels are accurate far from zero.

float32 has 24 bits: 0.5 m at UTM coordinates (5e5, 5.4e6), 0.5 mm at 9 km. Points that are far from zero relative to
their spread get an origin near their median. Axes may differ in unit (degrees with heights in meters), so single axes
get one, too, if float32 would lose digits there. Points in degrees always get one.
"""

from __future__ import annotations

import math
from collections.abc import Callable
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
IN_DEGREES = np.array([True, True, False])  # axes in degrees
MIN_AXIS_STEPS = 2.0**6  # float32 steps per spread of an axis that needs no origin: less than noise of scanners at zero
_MAX_AXIS_RATIO = 2.0**23 / MIN_AXIS_STEPS / 2  # coordinate per spread, never more than MIN_AXIS_STEPS allow
FINEST_AXIS_ORIGIN = 2.0**-10  # for axes with an origin of their own and no spread: 1e-10 degrees remain
_MAX_DECIMALS = 12  # maximum decimals of an origin: more would be float64 rounding
NEAR_ZERO = 128.0  # [m] sensor positions within this keep the origin at zero: float32 resolves 8 um there
FLOAT32_MAX = float(np.finfo(np.float32).max)
FINEST_STEP = 1e-4  # [m] coarsest rounding that is never reported: below the noise of scanners
FINEST_DECIMALS = 1e-3  # [m] the same for files without steps, whose last decimals may only be those of a format
METERS_PER_DEGREE = 1e5  # of latitude, rounded down
MIN_STEPS = 2.0**14  # float32 steps per spread (about a quarter of the extent) of points that need no warning


def quiet() -> np.errstate:
    """Suppress NumPy warnings of NaN (also signaling) and infinity."""
    return np.errstate(invalid="ignore", over="ignore")


@quiet()
def split_origin(
    points: NDArray[Any], origin: NDArray[np.float64] | None = None, *, in_degrees: bool = False
) -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """Split points (n, 3) into float32 offsets and an origin (3,), by default that of `choose_origin`.
    Points too far apart raise `ValueError`, or become infinite with a given origin."""
    if origin is None:
        origin = choose_origin(points, in_degrees=in_degrees)
    if not origin.any():
        return np.ascontiguousarray(points, dtype=np.float32), origin
    return (points.astype(np.float64, copy=False) - origin).astype(np.float32), origin


@quiet()
def choose_origin(
    points: NDArray[Any],
    steps: NDArray[np.float64] | None = None,
    *,
    in_degrees: bool = False,
    in_one_unit: bool = False,
) -> NDArray[np.float64]:
    """The origin of points (n, 3), float64 (3,): zero, or near the median, which is robust to outliers.
    `steps` (3,) is the coordinate step of a file. An axis whose steps float32 cannot resolve, such as degrees in steps
    of 1e-7, is moved to the median in whole thousands of steps if most points are closer to it. Without `steps`, the
    axes of `axes_far_from_zero` are moved. `in_degrees` moves x and y. Positions of sensors and grids, `in_one_unit`,
    have one origin for all axes. Raises `ValueError` beyond float32."""
    if not points.size:
        return np.zeros(3)
    low = high = np.zeros(3)
    is_near = points.min() >= -ORIGIN_LIMIT and points.max() <= ORIGIN_LIMIT  # false for NaN
    if is_near and steps is None and not in_degrees and is_plainly_around_zero(points):
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
    few = sample_points(points, SPREAD_SAMPLE)
    in_one_unit |= steps is not None
    axes = axes_far_from_zero(few, is_near=bool(is_near), in_one_unit=in_one_unit, in_degrees=in_degrees)
    origin = origin_of_sample(sample_points(points), axes) if axes.any() else np.zeros(3)
    if not is_near:
        if max((high - origin).max(), (origin - low).max()) > FLOAT32_MAX:
            origin = np.round(low / 2 + high / 2)
        if max((high - origin).max(), (origin - low).max()) > FLOAT32_MAX:
            raise ValueError(f"points: {low.tolist()}..{high.tolist()} are beyond the float32 range about their center")
    if steps is None:
        return origin
    sample = sample_points(points)
    refined = _refine(origin, sample, steps)
    return np.where(refined == 0, origin_of_sample(sample, IN_DEGREES), refined) if in_degrees else refined


def warn_if_coarse(name: str, points: NDArray[Any], origin: NDArray[np.float64], *, in_degrees: bool = False) -> None:
    """Warn if points (n, 3) are float32 and so far from zero that digits have been lost."""
    if points.dtype == np.float32 and origin.any():
        with quiet():
            sample = sample_points(points, SPREAD_SAMPLE)
        warn_of_steps(name, sample[:, :2] if in_degrees else sample)  # heights are meters


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
def origin_of_sample(sample: NDArray[np.float64], axes: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Origin from a finite sample (n, 3): the median in meters, or finer (power of two) on axes of small extent.
    If not all `axes` are set, zero on the others, and fine also on axes of no extent. Fine for one point, too."""
    middle, spread = _spread_of(sample)
    if axes.all() and (spread.any() or np.abs(middle).max() > ORIGIN_LIMIT):
        return _rounded(middle, spread)
    return np.where(axes, _rounded(middle, np.where(spread > 0, spread, FINEST_AXIS_ORIGIN / 16)), 0.0)


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


@quiet()
def axes_far_from_zero(
    sample: NDArray[np.float64], *, is_near: bool = True, in_one_unit: bool = False, in_degrees: bool = False
) -> NDArray[np.bool_]:
    """The axes (3,) that need an origin, from a finite sample (n, 3).

    All if the median is more than 32 times the largest spread from zero, or if not `is_near`. Else, unless
    `in_one_unit`, x and y if `in_degrees`, or the axes on which float32 would lose digits, because the axes have
    different units or there is one point.
    """
    middle, spread = _spread_of(sample)
    distance, second = np.abs(middle), np.sort(spread)[1]
    if not is_near or (spread.any() and distance.max() > FAR_FROM_ZERO * spread.max()):
        return np.full(3, True)
    if in_one_unit:
        return np.full(3, False)
    if in_degrees:
        return IN_DEGREES
    # Two axes of small spread: degrees beside meters, or one position. One axis alone may be flat, as a floor is.
    is_small = spread <= second
    is_far = is_small & (distance[is_small].max() > FAR_FROM_ZERO * second)
    is_far |= (spread > 0) & (spread < MIN_AXIS_STEPS * np.spacing(distance.astype(np.float32)))
    is_far &= (sample.astype(np.float32) != sample).any(axis=0)
    return is_far if (distance[is_far] >= 1).any() else np.full(3, False)  # below it float32 resolves 1e-7


def is_plainly_around_zero(points: NDArray[Any]) -> bool:
    """True only if no axis is in `axes_far_from_zero` for the sample of finite points.
    Half of the points are beyond the quartiles, so the spread is at least the distance from the median to the nearer
    one."""
    if points.dtype.itemsize > 8:  # float64 would round small numbers to zero
        return False
    columns = np.array(points[:: len(points) // SPREAD_SAMPLE | 1].T, dtype=np.float64, order="C")
    is_used = columns.any(axis=0)
    if not is_used.all():
        columns = columns[:, is_used]
    count, is_single = columns.shape[1], points.dtype.itemsize <= 4  # of float32: no digits are lost
    if count < 2:  # a single point has no spread
        return count == 1 and is_single
    columns.sort(axis=1)
    below, first = (count - 1) // 2, count // 4
    last = min(first + below + 1, count - 1)
    return _are_medians_near(columns[:, (first, below, count // 2, last)].tolist(), is_single=is_single)


def _are_medians_near(quartiles: list[list[float]], *, is_single: bool = False) -> bool:
    """Per axis: first quartile, both medians, third quartile."""
    largest, spreads = 0.0, []
    for a, left, right, b in quartiles:
        median, spread = (left + right) / 2, min((left + right) / 2 - a, b - (left + right) / 2)
        if not is_single and abs(median) > _MAX_AXIS_RATIO * spread:
            return False
        spreads.append(spread)
        largest = max(largest, abs(median))
    return largest <= FAR_FROM_ZERO * (max(spreads) if is_single else sorted(spreads)[1])


def _is_box_around_zero(low: list[float], high: list[float]) -> bool:
    """True only if the origin of the two corners is zero: `is_plainly_around_zero` without NumPy."""
    if not all(-ORIGIN_LIMIT <= value <= ORIGIN_LIMIT for value in (*low, *high)):
        return False
    return _are_medians_near([[a, a / 2 + b / 2, a / 2 + b / 2, b] for a, b in zip(low, high, strict=True)])


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
    *,
    in_degrees: bool = False,
    sample: Callable[[], NDArray[np.float64]] | None = None,
) -> NDArray[np.float64]:
    """Origin after an affine map x -> A x + t of the box `low` to `high`; `moved` is the mapped origin, shape (3,).
    If their old origin is not zero, a `sample` of the points, before the map, also decides: strays enlarge the box."""
    low, high = low.astype(np.float64), high.astype(np.float64)
    middle, half = matmul(A, (low + high) / 2) + t, matmul(np.abs(A), (high - low) / 2)
    corners = np.stack([middle - half, middle + half])
    if not in_degrees and sample is None and _is_box_around_zero(*corners.tolist()):
        return np.zeros(3)
    if not np.abs(corners).max() <= LARGEST_NUMBER or np.ptp(corners, axis=0).max() > 2 * FLOAT32_MAX:
        bounds = f"{corners[0].tolist()}..{corners[1].tolist()}"
        raise ValueError(f"{name}: moves the points to {bounds}, beyond the float32 range about their center")
    is_near = bool(np.abs(corners).max() <= ORIGIN_LIMIT)
    axes = axes_far_from_zero(corners, is_near=is_near, in_degrees=in_degrees)
    if sample is not None and not axes.any():
        points = matmul(usable_points(sample()), A.T) + t
        axes = axes_far_from_zero(points) if len(points) else axes
        if axes.any():
            return origin_of_sample(points, axes)
    if not axes.any():
        return np.zeros(3)
    origin, extent = choose_origin(corners, in_degrees=in_degrees), np.ptp(corners, axis=0)
    # The old origin is near most points, whatever outliers do to their bounding box.
    if axes.all() and (extent.any() or not is_near):
        carried = _rounded(moved, extent / 4)
        return carried if np.abs(corners - carried).max() < FLOAT32_MAX else origin
    is_inside = (corners[0] - extent <= moved) & (moved <= corners[1] + extent)
    return np.where(axes & is_inside, _rounded(moved, np.where(extent > 0, extent / 4, FINEST_AXIS_ORIGIN)), origin)


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


@quiet()
def warn_if_rounded(
    path: object,
    points: NDArray[Any],
    origin: NDArray[np.float64],
    steps: NDArray[np.float64] | None,
    unit_lengths: NDArray[np.float64],
) -> bool:
    """Warn if float32 about the origin is coarser than the `steps` of a file for some of the points (n, 3).

    `steps` of None are the decimals of float64 points, but not below a millimeter. `unit_lengths` (3,) is the unit of
    each axis [m]. Points at (0, 0, 0) mean no return. Returns True if it warned.
    """
    if not len(points) or (steps is None and points.dtype != np.float64):
        return False
    limits = np.maximum(
        0 if steps is None else steps, (FINEST_DECIMALS if steps is None else FINEST_STEP) / unit_lengths
    )
    if not (float32_steps(np.stack(finite_box(points)) - origin) > limits).any():
        return False
    used = usable_points(points)
    if steps is None and len(used):
        limits = np.maximum(limits, [10.0 ** -_decimals(column) for column in sample_points(used).T])
    rounding = float32_steps(used - origin)
    count = int((rounding > limits).any(axis=1).sum())
    if not count:
        return False
    axis = int((rounding / limits).max(axis=0).argmax())
    which = f"{count:,} of {len(points):,} points" if len(points) > 2 else "points"  # two corners of a box
    warn_of_units(
        f"{path}: {which} far from the middle of the cloud are rounded to float32, in steps of up to "
        f"{rounding[:, axis].max():.3g}. The steps of the file are {limits[axis]:.3g}. Remove stray points, or split "
        "wide clouds by pointloom split --cell, which keeps the coordinates of the file"
    )
    return True


def float32_steps(offsets: NDArray[np.float64]) -> NDArray[np.float32]:
    return np.spacing(np.abs(offsets).astype(np.float32))


def lengths_of_axes(meters: float | None, *, in_degrees: bool) -> NDArray[np.float64]:
    """The unit of each axis [m], shape (3,), for `warn_if_rounded`. An unknown unit is a meter."""
    return np.array([METERS_PER_DEGREE, METERS_PER_DEGREE, 1.0]) if in_degrees else np.full(3, meters or 1.0)


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
