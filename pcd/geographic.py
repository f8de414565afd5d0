"""Longitude and latitude to metres: the Universal Transverse Mercator projection (UTM), in float64 on the host.

Every length that an operation takes, a radius or a voxel, means the same along x, y and z; degrees do not. The series
is good to a micrometre within 3,900 km of the central meridian. Nothing is shifted from one datum to another: WGS 84,
ETRS89 and NAD83 differ by metres at most and share this ellipsoid to 0.1 mm.

Source: Karney 2011, "Transverse Mercator with an accuracy of a few nanometers", equations 7 to 12 and 35 (Krueger's
series to the sixth order).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count
from ..core.coordinates import quiet
from ..core.units import METRE
from .point_arrays import check_cloud

if TYPE_CHECKING:
    from .cloud import PointCloud

_RADIUS, _FLATTENING = 6378137.0, 1 / 298.257223563  # [m] of WGS 84
_SCALE, _EASTING, _SOUTHERN_NORTHING = 0.9996, 5.0e5, 1.0e7  # UTM's factor and false coordinates [m]
_LATITUDES = (-80.0, 84.0)  # [degrees] which UTM covers
_WIDEST = 30.0  # [degrees] from the central meridian: far beyond any zone's use, well within the series
_NORTHERN, _SOUTHERN = 32600, 32700  # EPSG's codes of the zones, which count from 1 to 60


def utm_epsg(cloud: PointCloud) -> int:
    """The UTM zone in which most points of a cloud in degrees lie, as its EPSG code for WGS 84.

    Args:
        cloud: x is the longitude, y the latitude [degrees].

    Returns:
        32601..32660 in the north, 32701..32760 in the south; zones are 6 degrees wide everywhere, at Norway too.

    Raises:
        TypeError: No cloud.
        ValueError: No finite point, or one beyond 360 degrees of longitude or UTM's -80..84 of latitude.

    Example:
        >>> import pointloom as loom
        >>> loom.utm_epsg(loom.PointCloud([[-123.07, 44.05, 120.0]]))
        32610
    """
    check_cloud("cloud", cloud)
    longitudes, latitudes = _degrees(cloud)
    if not len(longitudes):
        raise ValueError("cloud: no finite point tells its zone; give epsg")
    longitude, latitude = np.median(longitudes), np.median(latitudes)
    zone = min(int((longitude + 180) // 6) + 1, 60)
    return (_NORTHERN if latitude >= 0 else _SOUTHERN) + zone


def project_to_utm(cloud: PointCloud, *, epsg: int | None = None) -> PointCloud:
    """A cloud in degrees of longitude and latitude as one in metres; heights and attributes stay as they are.

    Args:
        cloud: x is the longitude, y the latitude [degrees]; z, in whatever unit, is kept.
        epsg: The zone; None takes that of `utm_epsg(cloud)`. Clouds of one place want the same.

    Returns:
        Eastings and northings [m]. Points that are not finite stay so.

    Raises:
        TypeError: No cloud.
        ValueError: No finite point and no zone, points beyond UTM or 30 degrees from the zone's middle, another code
            than 32601..32660 and 32701..32760, or normals, which had been fitted to degrees.

    Notes:
        The same bits on every device. O(n) memory on the host.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.project_to_utm(loom.PointCloud([[-79.3871, 43.6426, 553.0]]))
        >>> cloud.points.round().tolist()
        [[630087.0, 4833442.0, 553.0]]
    """
    check_cloud("cloud", cloud)
    if cloud.has_normals:
        raise ValueError('cloud: its normals belong to degrees; project cloud.without("normals"), then estimate them')
    _degrees(cloud)
    code = utm_epsg(cloud) if epsg is None else check_count("epsg", epsg)
    zone = code % 100
    if code - zone not in (_NORTHERN, _SOUTHERN) or not 1 <= zone <= 60:
        raise ValueError(f"epsg: expected 32601..32660 or 32701..32760, got {epsg}")
    points = cloud.points.copy()
    with quiet():
        away = np.mod(points[:, 0] - (6 * zone - 183) + 180, 360) - 180
    widest = np.abs(away[np.isfinite(away)]).max(initial=0)
    if widest > _WIDEST:
        raise ValueError(
            f"cloud: a point lies {widest:.4g} degrees from the middle of zone {zone}, at most {_WIDEST:g}"
        )
    easting, northing = transverse_mercator(away, points[:, 1], _RADIUS, _FLATTENING)
    points[:, 0] = _EASTING + _SCALE * easting
    points[:, 1] = _SCALE * northing + (_SOUTHERN_NORTHING if code > _SOUTHERN else 0)
    projected = cloud.copy()
    projected.points, projected.unit = points, METRE
    return projected


@quiet()
def transverse_mercator(
    longitudes: NDArray[np.float64], latitudes: NDArray[np.float64], radius: float, flattening: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Easting and northing [m] of degrees, longitudes from the central meridian, on which the scale is 1."""
    n = flattening / (2 - flattening)
    eccentricity = math.sqrt(flattening * (2 - flattening))
    tangent, meridian = np.tan(np.radians(latitudes)), np.radians(longitudes)
    sigma = np.sinh(eccentricity * np.arctanh(eccentricity * tangent / np.hypot(1, tangent)))
    conformal = tangent * np.hypot(1, sigma) - sigma * np.hypot(1, tangent)
    north = np.arctan2(conformal, np.cos(meridian))
    east = np.arcsinh(np.sin(meridian) / np.hypot(conformal, np.cos(meridian)))
    northing, easting = north.copy(), east.copy()
    for k, alpha in enumerate(_series(n), start=1):
        northing += alpha * np.sin(2 * k * north) * np.cosh(2 * k * east)
        easting += alpha * np.cos(2 * k * north) * np.sinh(2 * k * east)
    rectifying = radius / (1 + n) * (1 + n**2 / 4 + n**4 / 64 + n**6 / 256)
    return rectifying * easting, rectifying * northing


def _series(n: float) -> tuple[float, ...]:
    """Krueger's coefficients (Karney 2011, equation 35)."""
    return (
        n / 2 - n**2 * 2 / 3 + n**3 * 5 / 16 + n**4 * 41 / 180 - n**5 * 127 / 288 + n**6 * 7891 / 37800,
        n**2 * 13 / 48 - n**3 * 3 / 5 + n**4 * 557 / 1440 + n**5 * 281 / 630 - n**6 * 1983433 / 1935360,
        n**3 * 61 / 240 - n**4 * 103 / 140 + n**5 * 15061 / 26880 + n**6 * 167603 / 181440,
        n**4 * 49561 / 161280 - n**5 * 179 / 168 + n**6 * 6601661 / 7257600,
        n**5 * 34729 / 80640 - n**6 * 3418889 / 1995840,
        n**6 * 212378941 / 319334400,
    )


def _degrees(cloud: PointCloud) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Longitudes and latitudes of the finite points, once they are such."""
    points = cloud.points
    rows = points[np.isfinite(points).all(axis=1)]
    bad = (np.abs(rows[:, 0]) > 360) | (rows[:, 1] < _LATITUDES[0]) | (rows[:, 1] > _LATITUDES[1])
    if bad.any():
        found = rows[bad][0, :2].tolist()
        raise ValueError(f"cloud: expected longitudes to 360 and latitudes -80..84 in x and y [degrees], got {found}")
    return np.mod(rows[:, 0] + 180, 360) - 180, rows[:, 1]
