"""The area of a polygon of points in space, and how areas and volumes are written."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_finite, check_rows
from ....core.units import LengthUnit

MOST_CORNERS = 200  # up to which triangles between them are looked for: a second's work
FLAT = 1e-6  # of the polygon's extent: corners that lie nearer to the plane lie in it
_UNKNOWN = {1: "units", 2: "square units", 3: "cubic units"}
_POWERS = {1: "", 2: "²", 3: "³"}


@dataclasses.dataclass(frozen=True)
class PolygonArea:
    """How large a polygon is.

    Attributes:
        area: Seen across the plane that fits its corners best.
        surface: The least area of triangles between the corners, in space: above `area` where these lie in no plane.
            NaN of more than 200 corners.
        from_above: Seen along z, as in a map.
        perimeter: The length of its sides, the closing one too.
        off_plane: How far the farthest corner lies from that plane.
        slope: Of the plane against the horizontal [degrees], 0 to 90.
        crosses: Whether sides cross each other; what is then circled the other way round is taken off `area` and
            `from_above`, and `surface` is NaN.
    """

    area: float
    surface: float
    from_above: float
    perimeter: float
    off_plane: float
    slope: float
    crosses: bool


def measure_polygon(points: Any) -> PolygonArea:
    """The area of the polygon with these corners, in their order.

    Args:
        points: Shape [n, 3], at least three.

    Raises:
        ValueError: Fewer, or all on one line, or not finite.

    Example:
        >>> found = measure_polygon([[0, 0, 0], [4, 0, 3], [4, 2, 3], [0, 2, 0]])
        >>> round(found.area, 9), round(found.from_above, 9), round(found.perimeter, 9), round(found.slope, 2)
        (10.0, 8.0, 14.0, 36.87)
    """
    corners = check_finite("points", check_rows("points", points, 3, dtype=np.float64))
    if len(corners) < 3:
        raise ValueError(f"points: expected at least three corners, got {len(corners)}; click on more")
    local = corners - corners.mean(axis=0)  # far origins cancel here
    right, up, normal = _plane(local)
    flat = np.column_stack([local @ right, local @ up])
    area_vector = np.cross(local, np.roll(local, -1, axis=0)).sum(axis=0) / 2
    crosses = _sides_cross(flat)
    return PolygonArea(
        area=abs(float(area_vector @ normal)),
        surface=math.nan if crosses or len(corners) > MOST_CORNERS else _least_surface(local),
        from_above=abs(float(area_vector[2])),
        perimeter=float(np.linalg.norm(local - np.roll(local, -1, axis=0), axis=1).sum()),
        off_plane=float(np.abs(local @ normal).max()),
        slope=math.degrees(math.acos(min(1.0, abs(float(normal[2]))))),
        crosses=crosses,
    )


def area_rows(found: PolygonArea, unit: LengthUnit | None) -> list[tuple[str, str]]:
    """What is known of a polygon's area, as labels and values; what is not known is said.

    Raises:
        ValueError: In degrees of longitude and latitude, between which nothing is an area.
    """
    check_length(unit)
    rows = [("area", quantity_text(found.area, unit, 2))]
    extent = math.sqrt(found.area) + found.perimeter
    if found.off_plane > FLAT * extent and not found.crosses:
        told = "not known of so many corners" if math.isnan(found.surface) else quantity_text(found.surface, unit, 2)
        rows += [("over its triangles", told)]
        rows += [("off the plane", f"up to {quantity_text(found.off_plane, unit)}")]
    rows += [("from above", quantity_text(found.from_above, unit, 2))]
    rows += [("perimeter", quantity_text(found.perimeter, unit)), ("slope", f"{found.slope:.2f}°")]
    if found.crosses:
        rows.append(("its sides cross", "what is circled the other way round is taken off"))
    return rows


def quantity_text(value: float, unit: LengthUnit | None, power: int = 1) -> str:
    """A length, area or volume with its unit; of an unknown one "units", "square units", "cubic units"."""
    if power > 1 and 1e-3 <= abs(value) < 1e12:  # five digits: squares and cubes are known no better
        number = f"{value:,.{max(0, 4 - math.floor(math.log10(abs(value))))}f}"
    else:
        number = f"{value:.4f}" if value == 0 or 1e-2 <= abs(value) < 1e6 else f"{value:.6g}"
    return f"{number} {_UNKNOWN[power] if unit is None else unit.symbol + _POWERS[power]}"


def check_length(unit: LengthUnit | None) -> None:
    """Refuse degrees.

    Raises:
        ValueError: The unit is no length.
    """
    if unit is not None and unit.metres is None:
        raise ValueError(f"coordinates in {unit}s have no lengths or areas; project_to_utm(cloud) makes metres of them")


def _plane(local: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Two directions along the plane of least squares through the mean, and its normal."""
    _, spread, axes = np.linalg.svd(local, full_matrices=True)
    if not spread[1] > 1e-9 * max(float(spread[0]), 1e-300):
        raise ValueError("points: they lie on one line, which has no area; click on a place beside it")
    return axes[0], axes[1], axes[2]


def _turn(a: Any, b: Any, c: Any) -> Any:
    """Twice the area of triangles in the plane, above zero where they run to the left."""
    return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])


def _sides_cross(flat: NDArray[np.float64]) -> bool:
    """Whether two sides that are no neighbours have an inner point in common."""
    count, ends = len(flat), np.roll(flat, -1, axis=0)
    for i in range(count - 2):
        others = np.arange(i + 2, count - (i == 0))
        a, b, c, d = flat[i], ends[i], flat[others], ends[others]
        if (((_turn(a, b, c) * _turn(a, b, d)) < 0) & ((_turn(c, d, a) * _turn(c, d, b)) < 0)).any():
            return True
    return False


def _least_surface(local: NDArray[np.float64]) -> float:
    """The least area in space that triangles between the corners can have (Klincsek 1980); of a flat polygon, its own.

    `least[i, j]` is that of the part from corner i to corner j; it is put together of parts with fewer corners.
    """
    count = len(local)
    least = np.zeros((count, count))
    for span in range(2, count):
        first = np.arange(count - span)[:, None]
        last, between = first + span, first + np.arange(1, span)
        a, b, c = local[first], local[between], local[last]
        areas = np.linalg.norm(np.cross(b - a, c - a), axis=-1) / 2
        least[first[:, 0], last[:, 0]] = (least[first, between] + least[between, last] + areas).min(axis=1)
    return float(least[0, -1])
