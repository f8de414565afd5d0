"""Transverse Mercator projection of the ellipsoid in float64, bitwise identical everywhere, with a few nanometers of
rounding.

Karney 2011, "Transverse Mercator with an accuracy of a few nanometers", equations 7 to 12 and 35 (Krueger's series to
the sixth order). Series and recurrences only, no library sines.
"""

from ..array_types import Points, Positions, Scalars
from ..lang import (
    INFINITY,
    NAN,
    array,
    compute,
    float32,
    float64,
    func,
    isfinite,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    vec2d,
    vec3,
    vec3d,
)
from ..memory import empty
from .angles import arctangent

RADIANS_PER_DEGREE = 0.017453292519943295  # per degree
SERIES_ORDER = 6  # of Krueger's series


@struct
class Mercator:
    """Projection: `meridian` [degrees]; rectifying `radius` times scale [m]. Krueger coefficients; `start` [m]."""

    meridian: float64
    eccentricity: float64
    radius: float64
    low: vec3d
    high: vec3d
    start: vec3d

    def __init__(
        self, meridian: float, eccentricity: float, radius: float, series: tuple[float, ...], start: tuple[float, float]
    ) -> None:
        self.meridian, self.eccentricity, self.radius = meridian, eccentricity, radius
        self.low, self.high = vec3d(*series[:3]), vec3d(*series[3:SERIES_ORDER])
        self.start = vec3d(*start, 0.0)


@func
def sine_and_cosine(angle: float64) -> vec2d:
    """Sine and cosine of an angle [rad] within a quarter turn: Taylor series of an eighth (1e-19), then doubling."""
    y = angle * 0.125
    square = y * y
    s = square * -2.505210838544172e-08 + 2.7557319223985893e-06
    s = s * square - 0.0001984126984126984
    s = s * square + 0.008333333333333333
    s = s * square - 0.16666666666666666
    sine = y + y * square * s
    c = square * 2.08767569878681e-09 - 2.755731922398589e-07
    c = c * square + 2.48015873015873e-05
    c = c * square - 0.001388888888888889
    c = c * square + 0.041666666666666664
    c = c * square - 0.5
    cosine = 1.0 + square * c
    for _ in range(3):
        doubled = 2.0 * sine * cosine
        cosine = 1.0 - 2.0 * sine * sine
        sine = doubled
    return vec2d(sine, cosine)


@func
def inverse_tanh(x: float64) -> float64:
    """artanh x for |x| <= 0.6: series of a quarter of the value."""
    t = x / (1.0 + sqrt(1.0 - x * x))
    t = t / (1.0 + sqrt(1.0 - t * t))
    square = t * t
    total = float64(0.0)
    terms = int(12)
    for k in range(terms):
        total = 1.0 / float64(23 - 2 * k) + square * total
    return 4.0 * t * total


@func
def small_sinh(x: float64) -> float64:
    """sinh x for |x| <= 0.01, by its series to the fourth power."""
    square = x * x
    return x + x * square * (0.16666666666666666 + square * (0.008333333333333333 + square * 0.0001984126984126984))


@func
def wrapped(degrees: float64) -> float64:
    """Longitude in -180 .. 180, from one within 720."""
    longitude = degrees
    for _ in range(2):
        if longitude >= 180.0:
            longitude = longitude - 360.0
        if longitude < -180.0:
            longitude = longitude + 360.0
    return longitude


@func
def project(longitude: float64, latitude: float64, to: Mercator) -> vec2d:
    """Easting and northing [m] of degrees, longitude relative to the meridian."""
    along = sine_and_cosine(latitude * float64(RADIANS_PER_DEGREE))
    across = sine_and_cosine(longitude * float64(RADIANS_PER_DEGREE))
    tangent = along[0] / along[1]
    sigma = small_sinh(to.eccentricity * inverse_tanh(to.eccentricity * along[0]))
    t = tangent * sqrt(1.0 + sigma * sigma) - sigma * sqrt(1.0 + tangent * tangent)
    # north and east angles of the sphere's transverse graticule, and their sines
    side = sqrt(t * t + across[1] * across[1])
    sine = t / side
    cosine = across[1] / side
    east_sinh = across[0] / side
    east_cosh = sqrt(1.0 + east_sinh * east_sinh)
    north = arctangent(t, across[1])
    east = inverse_tanh(east_sinh / east_cosh)
    # sin 2k north cosh 2k east + i cos 2k north sinh 2k east is the sine of 2k (north + i east): add 2 (north + i east)
    a = 2.0 * sine * cosine
    b = 1.0 - 2.0 * sine * sine
    c = 2.0 * east_sinh * east_cosh
    d = 1.0 + 2.0 * east_sinh * east_sinh
    s = a
    q = b
    h = c
    g = d
    for k in range(6):
        alpha = to.low[k % 3]
        if k >= 3:
            alpha = to.high[k % 3]
        north = north + alpha * s * g
        east = east + alpha * q * h
        s_next = s * b + q * a
        q = q * b - s * a
        s = s_next
        h_next = h * d + g * c
        g = g * d + h * c
        h = h_next
    return vec2d(to.start[0] + to.radius * east, to.start[1] + to.radius * north)


@kernel
def project_degrees_kernel(degrees: array(dtype=vec3d), to: Mercator, out: array(dtype=vec3d)):
    """Easting, northing and unchanged height. Non-finite points stay so."""
    i = tid()
    p = degrees[i]
    if isfinite(p):
        projected = project(wrapped(p[0] - to.meridian), p[1], to)
        p = vec3d(projected[0], projected[1], p[2])
    out[i] = p


@kernel
def relative_degrees_kernel(degrees: array(dtype=vec3d), meridian: float64, out: array(dtype=vec3)):
    """Relative longitude, latitude, and magnitude of the original longitude. NaN if not finite."""
    i = tid()
    p = degrees[i]
    relative = vec3(NAN, NAN, NAN)
    if isfinite(p):
        relative = vec3(float(wrapped(p[0] - meridian)), float(p[1]), float(abs(p[0])))
    out[i] = relative


@kernel
def split_degrees_kernel(degrees: array(dtype=vec3), longitudes: array(dtype=float32), latitudes: array(dtype=float32)):
    i = tid()
    p = degrees[i]
    if not isfinite(p):
        p = vec3(INFINITY, INFINITY, INFINITY)
    longitudes[i] = p[0]
    latitudes[i] = p[1]


def project_degrees(degrees: Positions, to: Mercator) -> Positions:
    """Easting and northing [m] of longitude (within 720 of the meridian) and latitude in degrees."""
    return compute(project_degrees_kernel, degrees.size, [degrees, to], vec3d, degrees.device)


def relative_degrees(degrees: Positions, meridian: float) -> Points:
    """(relative longitude in -180..180, latitude, magnitude of the longitude) of each point. NaN if not finite."""
    return compute(relative_degrees_kernel, degrees.size, [degrees, float(meridian)], vec3, degrees.device)


def split_degrees(degrees: Points) -> tuple[Scalars, Scalars]:
    """(longitudes, latitudes) of `relative_degrees`, infinite for points that are not finite."""
    longitudes, latitudes = (empty(degrees.size, float32, degrees.device) for _ in range(2))
    launch(split_degrees_kernel, degrees.size, [degrees, longitudes, latitudes])
    return longitudes, latitudes
