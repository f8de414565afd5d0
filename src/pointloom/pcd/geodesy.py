"""Geodetic, geocentric, local (east, north, up) and UTM coordinates in float64 on the host, WGS 84.

No datum shift (ETRS89, NAD83 and GDA2020 differ by up to 2 m). Heights are passed through. Source: Bowring 1985.
Karney, "Transverse Mercator with an accuracy of a few nanometers", 2011, equations 7 to 21 and 35.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_count, check_finite, check_number, check_rows
from ..kernels.linear_algebra import matmul
from .geographic import NORTHERN_EPSG_BASE, SOUTHERN_EPSG_BASE, krueger_series, utm_zone

Array = NDArray[np.float64]

EQUATORIAL_RADIUS, EARTH_FLATTENING = 6378137.0, 1 / 298.257223563  # [m] WGS 84
MAX_ELLIPSOID_HEIGHT = 1e5  # [m] from the ellipsoid: above aerial images, far below the formulas' limit

_ECCENTRICITY_SQUARED = EARTH_FLATTENING * (2 - EARTH_FLATTENING)  # eccentricity squared
_UTM_SCALE, _FALSE_EASTING, _SOUTHERN_NORTHING = 0.9996, 5.0e5, 1.0e7  # UTM [m]
_N = EARTH_FLATTENING / (2 - EARTH_FLATTENING)  # third flattening
_RECTIFYING_RADIUS = EQUATORIAL_RADIUS / (1 + _N) * (1 + _N**2 / 4 + _N**4 / 64 + _N**6 / 256)
_MAX_ITERATIONS = 8  # each iteration gains three or more digits


@dataclass(frozen=True)
class WorldFrame:
    """Local frame: meters east, north and up from a position on the Earth.

    Args:
        latitude, longitude: Of the origin [degrees].
        altitude: Of the origin [m], in any vertical datum.

    Raises:
        TypeError, ValueError: If an argument is not a number or out of range.

    Example:
        >>> import pointloom as loom
        >>> frame = loom.WorldFrame(47.5, 8.25, 430.0)
        >>> frame.epsg, frame.to_enu([[47.501, 8.25, 430.0]])[0, 1].round(2).item()
        (32632, 111.19)
    """

    latitude: float
    longitude: float
    altitude: float = 0.0

    def __post_init__(self):
        for name, limit in (("latitude", 90.0), ("longitude", 180.0), ("altitude", MAX_ELLIPSOID_HEIGHT)):
            value = check_number(name, getattr(self, name))
            if abs(value) > limit:
                raise ValueError(f"{name}: expected {-limit:g}..{limit:g}, got {value:g}")
            object.__setattr__(self, name, value)

    @property
    def epsg(self) -> int:
        """EPSG code of the origin's UTM zone."""
        return utm_zone(self.latitude, self.longitude)

    @cached_property
    def _rotation(self) -> Array:
        """East, north and up as rows."""
        a, b = math.radians(self.latitude), math.radians(self.longitude)
        sa, ca, sb, cb = math.sin(a), math.cos(a), math.sin(b), math.cos(b)
        return np.array([[-sb, cb, 0.0], [-sa * cb, -sa * sb, ca], [ca * cb, ca * sb, sa]])

    @cached_property
    def _middle(self) -> Array:
        return geocentric(np.array([[self.latitude, self.longitude, self.altitude]]))[0]

    def to_enu(self, points: ArrayLike) -> Array:
        """Convert to meters east, north and up.

        Args:
            points: Latitude, longitude [degrees] and altitude [m], shape (n, 3).

        Raises:
            ValueError: If the shape is wrong or a position is out of range.
        """
        return matmul(geocentric(points) - self._middle, self._rotation.T)

    def to_geodetic(self, points: ArrayLike) -> Array:
        """Convert to latitude, longitude [degrees] and altitude [m].

        Args:
            points: Meters east, north and up, shape (n, 3).

        Raises:
            ValueError: If the shape is wrong or a point is not finite.
        """
        meters = check_finite("points", check_rows("points", points, 3).astype(np.float64))
        return geodetic(matmul(meters, self._rotation) + self._middle)

    def to_utm(self, points: ArrayLike, epsg: int | None = None) -> Array:
        """Convert to easting, northing and altitude [m].

        Args:
            points: Meters east, north and up, shape (n, 3).
            epsg: UTM zone, 32601..32660 or 32701..32760. If None: that of the origin.

        Raises:
            ValueError: If the shape or code is wrong, or a point is not finite.
        """
        return utm(self.to_geodetic(points), self.epsg if epsg is None else epsg)

    def __str__(self) -> str:
        ns, ew = "NS"[self.latitude < 0], "EW"[self.longitude < 0]
        position = f"{abs(self.latitude):.7f} {ns} {abs(self.longitude):.7f} {ew}"
        return f"meters east, north and up of {position} at {self.altitude:.2f} m; EPSG:{self.epsg}"


def geocentric(points: ArrayLike) -> Array:
    """Geocentric coordinates [m], (n, 3), of latitude, longitude [degrees] and altitude [m]."""
    rows = check_finite("points", check_rows("points", points, 3).astype(np.float64))
    if (np.abs(rows) > (90.0, 360.0, MAX_ELLIPSOID_HEIGHT)).any():
        wrong = rows[np.flatnonzero((np.abs(rows) > (90.0, 360.0, MAX_ELLIPSOID_HEIGHT)).any(axis=1))[0]]
        raise ValueError(f"points: expected latitude, longitude [degrees] and altitude [m], got {wrong.tolist()}")
    a, b, height = np.radians(rows[:, 0]), np.radians(rows[:, 1]), rows[:, 2]
    across = EQUATORIAL_RADIUS / np.sqrt(1 - _ECCENTRICITY_SQUARED * np.sin(a) ** 2)
    level = (across + height) * np.cos(a)
    return np.stack(
        [level * np.cos(b), level * np.sin(b), ((1 - _ECCENTRICITY_SQUARED) * across + height) * np.sin(a)], axis=1
    )


def geodetic(points: Array) -> Array:
    """Latitude, longitude [degrees] and altitude [m], (n, 3), of geocentric coordinates [m]."""
    x, y, z = points.T
    level = np.hypot(x, y)
    minor = EQUATORIAL_RADIUS * (1 - EARTH_FLATTENING)
    reduced = np.arctan2(z * EQUATORIAL_RADIUS, level * minor)  # initial reduced latitude
    second = _ECCENTRICITY_SQUARED / (1 - _ECCENTRICITY_SQUARED)
    latitude = reduced
    for _ in range(_MAX_ITERATIONS):
        latitude = np.arctan2(
            z + second * minor * np.sin(reduced) ** 3,
            level - _ECCENTRICITY_SQUARED * EQUATORIAL_RADIUS * np.cos(reduced) ** 3,
        )
        reduced = np.arctan2((1 - EARTH_FLATTENING) * np.sin(latitude), np.cos(latitude))
    sine = np.sin(latitude)
    height = level * np.cos(latitude) + z * sine - EQUATORIAL_RADIUS * np.sqrt(1 - _ECCENTRICITY_SQUARED * sine**2)
    return np.stack([np.degrees(latitude), np.degrees(np.arctan2(y, x)), height], axis=1)


def utm(coordinates: Array, epsg: int) -> Array:
    """Easting, northing and altitude [m] of latitude, longitude [degrees] and altitude [m], (n, 3)."""
    meridian, south = _zone_of(epsg)
    e = math.sqrt(_ECCENTRICITY_SQUARED)
    longitudes = np.radians((coordinates[:, 1] - meridian + 180) % 360 - 180)
    tau = np.tan(np.radians(coordinates[:, 0]))
    sigma = np.sinh(e * np.arctanh(e * tau / np.hypot(1, tau)))
    conformal = tau * np.hypot(1, sigma) - sigma * np.hypot(1, tau)
    xi, eta = (
        np.arctan2(conformal, np.cos(longitudes)),
        np.arcsinh(np.sin(longitudes) / np.hypot(conformal, np.cos(longitudes))),
    )
    dx, dy = _bent(xi, eta)
    factor = _UTM_SCALE * _RECTIFYING_RADIUS
    return np.stack([_FALSE_EASTING + factor * (eta + dy), south + factor * (xi + dx), coordinates[:, 2]], axis=1)


def from_utm(points: Array, epsg: int) -> Array:
    """Latitude, longitude [degrees] and altitude [m] of easting, northing and altitude [m], (n, 3)."""
    meridian, south = _zone_of(epsg)
    if (
        (np.abs(points[:, 0] - _FALSE_EASTING) > 1e6).any()
        or (points[:, 1] < -1e4).any()
        or (points[:, 1] > 1.001e7).any()
    ):
        raise ValueError(f"points: expected easting and northing of EPSG:{epsg} [m], got {points[0, :2].tolist()}")
    factor, e = _UTM_SCALE * _RECTIFYING_RADIUS, math.sqrt(_ECCENTRICITY_SQUARED)
    eta0, xi0 = (points[:, 0] - _FALSE_EASTING) / factor, (points[:, 1] - south) / factor
    xi, eta = xi0, eta0
    for _ in range(_MAX_ITERATIONS):
        dx, dy = _bent(xi, eta)
        xi, eta = xi0 - dx, eta0 - dy
    conformal = np.sin(xi) / np.hypot(np.sinh(eta), np.cos(xi))
    longitude = meridian + np.degrees(np.arctan2(np.sinh(eta), np.cos(xi)))
    tau = conformal / (1 - _ECCENTRICITY_SQUARED)
    for _ in range(_MAX_ITERATIONS):  # Newton, Karney's equations 19 to 21
        sigma = np.sinh(e * np.arctanh(e * tau / np.hypot(1, tau)))
        conformal_of_tau = tau * np.hypot(1, sigma) - sigma * np.hypot(1, tau)
        step = (1 + (1 - _ECCENTRICITY_SQUARED) * tau**2) / (
            (1 - _ECCENTRICITY_SQUARED) * np.hypot(1, tau) * np.hypot(1, conformal_of_tau)
        )
        tau = tau + (conformal - conformal_of_tau) * step
    return np.stack([np.degrees(np.arctan(tau)), (longitude + 180) % 360 - 180, points[:, 2]], axis=1)


def _bent(xi: Array, eta: Array) -> tuple[Array, Array]:
    """Terms of Krüger's series."""
    dx, dy = np.zeros_like(xi), np.zeros_like(eta)
    for j, alpha in enumerate(krueger_series(_N), start=1):
        dx = dx + alpha * np.sin(2 * j * xi) * np.cosh(2 * j * eta)
        dy = dy + alpha * np.cos(2 * j * xi) * np.sinh(2 * j * eta)
    return dx, dy


def _zone_of(epsg: int) -> tuple[float, float]:
    """Central meridian [degrees] and false northing [m] of a zone."""
    code = check_count("epsg", epsg)
    zone = code % 100
    if code - zone not in (NORTHERN_EPSG_BASE, SOUTHERN_EPSG_BASE) or not 1 <= zone <= 60:
        raise ValueError(f"epsg: expected 32601..32660 or 32701..32760, got {epsg}")
    return 6.0 * zone - 183.0, _SOUTHERN_NORTHING if code > SOUTHERN_EPSG_BASE else 0.0
