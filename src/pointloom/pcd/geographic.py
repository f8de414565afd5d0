"""Project longitude and latitude to UTM in float64.

Radii and voxels need equal units along all axes. Accurate to a micrometer within 3,900 km of the central meridian. No
datum shift (WGS 84, ETRS89 and NAD83 share the ellipsoid to 0.1 mm). Source: Karney, "Transverse Mercator with an
accuracy of a few nanometers", 2011, equations 7 to 12 and 35.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..core.checks import check_count
from ..core.coordinate_systems import check_crs
from ..core.gpu_arrays import take_points
from ..core.units import METRE
from ..kernels.algebra.transverse_mercator import Mercator, project_degrees, relative_degrees, split_degrees
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.origins import add_origin
from ..kernels.arrays.ranked_numbers import numbers_of_ranks
from ..kernels.lang import int32
from ..kernels.memory import download, upload
from .point_arrays import check_cloud

if TYPE_CHECKING:
    from .cloud import PointCloud

_EQUATORIAL_RADIUS, _EARTH_FLATTENING = 6378137.0, 1 / 298.257223563  # [m] WGS 84
_UTM_SCALE, _FALSE_EASTING, _SOUTHERN_NORTHING = 0.9996, 5.0e5, 1.0e7  # UTM scale and false coordinates [m]
_UTM_LATITUDES = (-80.0, 84.0)  # [degrees] range of UTM
_MAX_LONGITUDE = 360.0  # [degrees] limit of longitudes
_MAX_MERIDIAN_DISTANCE = 30.0  # [degrees] from the central meridian: beyond zones, within the series
NORTHERN_EPSG_BASE, SOUTHERN_EPSG_BASE = 32600, 32700  # EPSG codes of zones are these plus 1 to 60


def utm_epsg(cloud: PointCloud) -> int:
    """EPSG code (WGS 84) of the UTM zone with most points of a cloud in degrees (x longitude, y latitude).

    Example:
        >>> import pointloom as loom
        >>> from pointloom.pcd.geographic import utm_epsg
        >>> utm_epsg(loom.PointCloud([[-123.07, 44.05, 120.0]]))
        32610
    """
    check_cloud("cloud", cloud)
    degrees = relative_degrees(add_origin(cloud.arrays["points"], cloud.origin), 0.0)
    _, _, count = _box_of(degrees)
    if not count:
        raise ValueError("cloud: expected a finite point to determine the UTM zone, got none. Pass epsg")
    starts, ranks = (upload(np.array(n), int32, cloud.device) for n in ([0, degrees.size], [count // 2]))
    medians = (numbers_of_ranks(coordinates, starts, ranks) for coordinates in split_degrees(degrees))
    longitude, latitude = (float(download(median)[0]) for median in medians)  # sync
    return utm_zone(latitude, longitude)


def utm_zone(latitude: float, longitude: float) -> int:
    """EPSG code of the zone of 6 degrees, with the exceptions of Norway and Svalbard (32V, 31X to 37X)."""
    zone = min(int((longitude + 180) // 6) + 1, 60)
    if 56 <= latitude < 64 and 3 <= longitude < 12:
        zone = 32
    elif 72 <= latitude <= 84 and 0 <= longitude < 42:
        zone = 31 + 2 * int((longitude + 3) // 12)
    return (NORTHERN_EPSG_BASE if latitude >= 0 else SOUTHERN_EPSG_BASE) + zone


def project_to_utm(cloud: PointCloud, *, epsg: int | PointCloud | None = None) -> PointCloud:
    """Project a cloud in degrees to UTM meters. Heights and attributes stay, covariances are dropped.

    Args:
        cloud: x is the longitude, y the latitude [degrees]; z is kept.
        epsg: UTM zone, or a cloud in degrees whose zone is used. If None: the zone (WGS 84) with most points of the
            cloud. Use one zone for clouds of one site.

    Returns:
        Eastings and northings [m]. Bitwise identical on every device. 108 B per point temporarily.

    Raises:
        TypeError: If `cloud` is not a PointCloud.
        ValueError: If there is neither a finite point nor a zone, points are beyond UTM or 30 degrees from the zone's
            center, the code is invalid, or the cloud has normals, which were estimated in degrees.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.project_to_utm(loom.PointCloud([[-79.3871, 43.6426, 553.0]]))
        >>> cloud.points.round().tolist()
        [[630087.0, 4833442.0, 553.0]]
    """
    check_cloud("cloud", cloud)
    if "normals" in cloud.arrays:
        raise ValueError(
            'cloud: normals in degrees cannot be projected. Project cloud.without("normals"), then estimate them'
        )
    reference: Any = cloud if epsg is None else epsg
    code = utm_epsg(reference) if hasattr(reference, "points") else check_count("epsg", reference)
    zone = code % 100
    if code - zone not in (NORTHERN_EPSG_BASE, SOUTHERN_EPSG_BASE) or not 1 <= zone <= 60:
        raise ValueError(f"epsg: expected 32601..32660 or 32701..32760, got {epsg}")
    degrees = add_origin(cloud.arrays["points"], cloud.origin)
    low, high, count = _box_of(relative_degrees(degrees, 6.0 * zone - 183.0))
    widest = max(-float(low[0]), float(high[0])) if count else 0.0
    if widest > _MAX_MERIDIAN_DISTANCE:
        raise ValueError(
            f"cloud: expected points within {_MAX_MERIDIAN_DISTANCE:g} degrees of the middle of zone {zone}, got one "
            f"at {widest:.4g}"
        )
    start = (_FALSE_EASTING, _SOUTHERN_NORTHING if code > SOUTHERN_EPSG_BASE else 0.0)
    projection = mercator(6.0 * zone - 183.0, _EQUATORIAL_RADIUS, _EARTH_FLATTENING, scale=_UTM_SCALE, start=start)
    points, origin = take_points("cloud", project_degrees(degrees, projection), None)
    projected = cloud.with_points(points, grid=cloud.grid)
    projected.arrays.origin, projected.unit, projected.crs = origin, METRE, check_crs("crs", code)
    return projected


def mercator(
    meridian: float, radius: float, flattening: float, *, scale: float = 1.0, start: tuple[float, float] = (0.0, 0.0)
) -> Mercator:
    """Transverse Mercator projection of an ellipsoid of this radius [m] about a meridian [degrees]."""
    n = flattening / (2 - flattening)
    rectifying = radius / (1 + n) * (1 + n**2 / 4 + n**4 / 64 + n**6 / 256)
    return Mercator(meridian, math.sqrt(flattening * (2 - flattening)), scale * rectifying, krueger_series(n), start)


def krueger_series(n: float) -> tuple[float, ...]:
    """Krüger's coefficients (Karney 2011, equation 35)."""
    return (
        n / 2 - n**2 * 2 / 3 + n**3 * 5 / 16 + n**4 * 41 / 180 - n**5 * 127 / 288 + n**6 * 7891 / 37800,
        n**2 * 13 / 48 - n**3 * 3 / 5 + n**4 * 557 / 1440 + n**5 * 281 / 630 - n**6 * 1983433 / 1935360,
        n**3 * 61 / 240 - n**4 * 103 / 140 + n**5 * 15061 / 26880 + n**6 * 167603 / 181440,
        n**4 * 49561 / 161280 - n**5 * 179 / 168 + n**6 * 6601661 / 7257600,
        n**5 * 34729 / 80640 - n**6 * 3418889 / 1995840,
        n**6 * 212378941 / 319334400,
    )


def _box_of(degrees: wp.array) -> tuple[NDArray[np.float32], NDArray[np.float32], int]:
    """Box and number of the finite points as longitudes and latitudes."""
    low, high, count = bound_points(degrees)  # sync
    if count and (low[1] < _UTM_LATITUDES[0] or high[1] > _UTM_LATITUDES[1] or high[2] > _MAX_LONGITUDE):
        given = f"longitudes to {high[2]:g} and latitudes {low[1]:g}..{high[1]:g}"
        raise ValueError(f"cloud: expected longitudes to 360 and latitudes -80..84 in x and y [degrees], got {given}")
    return low, high, count
