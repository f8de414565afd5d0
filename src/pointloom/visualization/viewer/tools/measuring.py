"""Distances and angles between points, and their formatting."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.checks import check_finite, check_rows, check_shape
from ....core.units import LengthUnit, symbol_of


@dataclasses.dataclass(frozen=True)
class Distance:
    """Distance `length` between two points with its components [m].

    `slope` is the angle above the xy plane [degrees], -90 to 90. NaN for equal points.
    """

    length: float
    dx: float
    dy: float
    dz: float
    slope: float


def distance_between(a: ArrayLike, b: ArrayLike) -> Distance:
    """Distance from one point to another.

    Example:
        >>> distance_between([0, 0, 0], [3, 0, 4])
        Distance(length=5.0, dx=3.0, dy=0.0, dz=4.0, slope=53.13010235415598)
    """
    d = _point("b", b) - _point("a", a)
    length = math.hypot(*d)
    slope = math.degrees(math.atan2(d[2], math.hypot(d[0], d[1]))) if length > 0 else math.nan
    return Distance(length, float(d[0]), float(d[1]), float(d[2]), slope)


def path_length(points: ArrayLike) -> float:
    """Length of a path through points (n, 3) [m]. 0 for fewer than 2.

    Example:
        >>> path_length([[0, 0, 0], [1, 0, 0], [1, 2, 0]])
        3.0
    """
    positions = check_finite("points", check_rows("points", points, 3, dtype=np.float64))
    return float(np.linalg.norm(np.diff(positions, axis=0), axis=1).sum())


def angle_at(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> float:
    """Angle at b between the directions to a and c [degrees], 0 to 180. NaN if one has no length.

    Example:
        >>> angle_at([1, 0, 0], [0, 0, 0], [0, 2, 0])
        90.0
    """
    u, v = _point("a", a) - _point("b", b), _point("c", c) - _point("b", b)
    if not u.any() or not v.any():
        return math.nan
    u, v = u / np.abs(u).max(), v / np.abs(v).max()  # avoids underflow and overflow of squares
    return math.degrees(math.atan2(float(np.linalg.norm(np.cross(u, v))), float(u @ v)))


def measurements(points: NDArray[np.float64], unit: LengthUnit | None = None) -> list[tuple[str, str]]:
    """Labels and values for clicked points (n, 3): distance, components and slope of the last two.

    For 3 or more points also the path length and the angle at the last corner. For degrees only the components. An
    unknown unit counts as meters.
    """
    rows: list[tuple[str, str]] = []
    is_length = unit is None or unit.meters is not None
    if len(points) >= 2:
        last = distance_between(points[-2], points[-1])
        rows += [("distance", length_text(last.length, unit))] if is_length else []
        rows += [("dx", length_text(last.dx, unit)), ("dy", length_text(last.dy, unit))]
        rows += [("dz", length_text(last.dz, unit) if is_length else f"{last.dz:.4f}")]
        rows += [("slope", angle_text(last.slope))] if is_length else []
    if len(points) >= 3 and is_length:
        rows += [("path", f"{length_text(path_length(points), unit)} over {len(points) - 1} parts")]
        rows += [("angle", angle_text(angle_at(*points[-3:])))]
    return rows


def length_text(value: float, unit: LengthUnit | None = None) -> str:
    """Format a length with 4 decimals if it is of ordinary size, else 6 digits. With its unit."""
    number = f"{value:.4f}" if value == 0 or 1e-2 <= abs(value) < 1e6 else f"{value:.6g}"
    return f"{number} {symbol_of(unit)}"


def angle_text(value: float) -> str:
    return "none" if math.isnan(value) else f"{value:.2f}°"


def _point(name: str, value: ArrayLike) -> NDArray[np.float64]:
    return check_finite(name, check_shape(name, value, (3,)))
