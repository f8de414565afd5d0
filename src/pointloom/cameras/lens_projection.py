"""One lens model that contains all camera models, forward and inverse, on the host in float64.

A ray (x, y, 1) of radius r is first mapped by lens type: unchanged, atan r (fisheye), atan(2 r tan(w / 2)) / w (FOV),
division or unified. Then p' = p N(r^2) / D(r^2) + tangential + prism terms, u = fx x' + skew y' + cx, v = fy y' + cy.
NaN beyond `max_radius`. Brown 1966. Devernay and Faugeras 2001. Fitzgibbon 2001 (division). Khomutenko et al. 2016
(unified); terms as in COLMAP.
"""

from __future__ import annotations

import dataclasses
import math
from functools import cached_property

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import NDArray

from ..kernels.images.undistortion import DIVISION, EQUIDISTANT, FIELD_OF_VIEW, PERSPECTIVE, UNIFIED

Array = NDArray[np.float64]

MAX_ITERATIONS = 100  # Newton iterations: a few suffice. Bisection of the rest takes about fifty
MIN_RESIDUAL = 4e-15  # relative residual of a solved equation, from rounding
NEGLIGIBLE_TERM = 1e-15  # fraction of a polynomial's largest term over the image
SEARCH_DIRECTIONS = 64  # of the search for `max_radius` of an asymmetric lens
SEARCH_STEPS = 128  # along a direction
MAX_RAY_SLOPE = 1e8  # x / z of a ray
MIN_SQUARED_OMEGA = 1e-4  # omega^2 below which a FOV lens is a series, as its formula is 0 / 0


@dataclasses.dataclass(frozen=True)
class Lens:
    """Lens parameters.

    Args:
        kind: PERSPECTIVE, EQUIDISTANT, FIELD_OF_VIEW, DIVISION or UNIFIED.
        focal: fx, fy [px].
        center: Principal point [px]. Pixel centers are integers.
        extent: Maximum radius x' / z of the image.
        skew: Factor of y' in the column [px].
        radial: Factors of r^2, r^4, r^6, r^8 in the numerator.
        rational: Factors of r^2, r^4, r^6 in the denominator.
        tangential: p1, p2 as in OpenCV.
        prism: Factors of r^2 in x and y.
        shape: omega of FIELD_OF_VIEW, k of DIVISION, alpha and beta of UNIFIED.
    """

    kind: int
    focal: tuple[float, float]
    center: tuple[float, float]
    extent: float
    skew: float = 0.0
    radial: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    rational: tuple[float, float, float] = (0.0, 0.0, 0.0)
    tangential: tuple[float, float] = (0.0, 0.0)
    prism: tuple[float, float] = (0.0, 0.0)
    shape: tuple[float, float] = (0.0, 0.0)

    @property
    def is_symmetric(self) -> bool:
        """True if the distortion is radial."""
        return not any((*self.tangential, *self.prism))

    @property
    def is_pinhole(self) -> bool:
        """True if there is no distortion."""
        return self.kind == PERSPECTIVE and self.is_plain

    @cached_property
    def chord(self) -> float:
        """2 tan(omega / 2) of a FOV lens. 0 if omega is so small that the lens is computed as a series."""
        omega = self.shape[0]
        return 2.0 * math.tan(omega / 2.0) if self.kind == FIELD_OF_VIEW and omega * omega >= MIN_SQUARED_OMEGA else 0.0

    @cached_property
    def max_radius(self) -> float:
        """Maximum radius after the first step where the polynomial is monotonic; may be infinite."""
        radius = _turning_radius(self)
        return radius if self.is_symmetric or radius == 0 else _narrowed(self, radius)

    def project(self, rays: Array) -> Array:
        """Pixels (n, 2) of rays (x, y, 1) given as (n, 2). NaN outside the lens."""
        with np.errstate(all="ignore"):
            points = rays * _shortening(self, np.hypot(rays[:, 0], rays[:, 1]))[:, None]
            radii = np.hypot(points[:, 0], points[:, 1])
            bent = bend(self, points)
            pixels = bent * self.focal + self.center
            pixels[:, 0] += self.skew * bent[:, 1]
            has_pixel = (radii <= self.max_radius) & np.isfinite(pixels).all(axis=1)
            if not self.is_symmetric:  # between the sampled directions it may fold earlier
                has_pixel &= _orientation(self, points) > 0
            pixels[~has_pixel] = np.nan
        return pixels

    def unproject(self, pixels: Array) -> Array:
        """Rays (n, 2) with z = 1 of pixels (n, 2). NaN without an inverse."""
        with np.errstate(all="ignore"):
            bent = np.empty(pixels.shape)
            bent[:, 1] = (pixels[:, 1] - self.center[1]) / self.focal[1]
            bent[:, 0] = (pixels[:, 0] - self.center[0] - self.skew * bent[:, 1]) / self.focal[0]
            points = bent if self.is_plain else _straighten(self, bent)
            rays = points * _lengthening(self, np.hypot(points[:, 0], points[:, 1]))[:, None]
            rays[~np.isfinite(rays).all(axis=1)] = np.nan
        return rays

    @property
    def is_plain(self) -> bool:
        return self.is_symmetric and not any((*self.radial, *self.rational))


def _shortening(lens: Lens, r: Array) -> Array:
    """Factor of the first step at radius r. NaN without such a ray."""
    if lens.kind == PERSPECTIVE:
        return np.ones_like(r)
    first, second = lens.shape
    if lens.kind == DIVISION:
        return 2.0 / (1.0 + np.sqrt(1.0 - 4.0 * first * r * r))
    if lens.kind == UNIFIED:
        below = first * np.sqrt(second * r * r + 1.0) + (1.0 - first)
        return np.where(below > 0, 1.0 / below, np.nan)
    if lens.kind == EQUIDISTANT:
        return np.where(r > 0, np.arctan(r) / r, 1.0)
    if not lens.chord:
        return first * first * (r * r / 3.0 - 1.0 / 12.0) + 1.0
    return np.where(r > 0, np.arctan(r * lens.chord) / (r * first), lens.chord / first)


def _lengthening(lens: Lens, r: Array) -> Array:
    """Inverse factor at the mapped radius. NaN if no ray in front of the camera maps to it."""
    if lens.kind == PERSPECTIVE:
        return np.ones_like(r)
    first, second = lens.shape
    if lens.kind == DIVISION:
        scale = 1.0 / (1.0 + first * r * r)
        return np.where((scale > 0) & (first * r * r < 1.0), scale, np.nan)
    if lens.kind == UNIFIED:
        square = second * r * r
        z = (1.0 - first * first * square) / (first * np.sqrt(1.0 - (2.0 * first - 1.0) * square) + (1.0 - first))
        return np.where(z > 0, 1.0 / z, np.nan)
    if lens.kind == EQUIDISTANT:
        return np.where(r < math.pi / 2, np.where(r > 0, np.tan(r) / r, 1.0), np.nan)
    if not lens.chord:
        return _thin_lengthening(first * first, r)
    angle = r * first
    solution = np.where(r > 0, np.tan(angle) / (r * lens.chord), first / lens.chord)
    return np.where(angle < math.pi / 2, solution, np.nan)


def _thin_lengthening(square: float, r: Array) -> Array:
    """Inverse of a FOV lens's series: r' (w^2 (r'^2 / 3 - 1 / 12) + 1) = r, by Newton's method."""
    far = r.copy()
    for _ in range(MAX_ITERATIONS):
        value = far * (square * (far * far / 3.0 - 1.0 / 12.0) + 1.0) - r
        step = value / (square * (far * far - 1.0 / 12.0) + 1.0)
        far = far - step
        if not (np.abs(step) > MIN_RESIDUAL * np.abs(far)).any():
            break
    return np.where(r > 0, far / r, 1.0 / (1.0 - square / 12.0))


def bend(lens: Lens, points: Array) -> Array:
    """The second step, positions (n, 2)."""
    x, y = points.T
    t = x * x + y * y
    factor = _factor(lens, t)
    (p1, p2), (s1, s2) = lens.tangential, lens.prism
    return np.stack(
        [
            x * factor + 2.0 * p1 * x * y + p2 * (t + 2.0 * x * x) + s1 * t,
            y * factor + 2.0 * p2 * x * y + p1 * (t + 2.0 * y * y) + s2 * t,
        ],
        axis=1,
    )


def _factor(lens: Lens, t: Array) -> Array:
    a, b = lens.radial, lens.rational
    return (1.0 + t * (a[0] + t * (a[1] + t * (a[2] + t * a[3])))) / (1.0 + t * (b[0] + t * (b[1] + t * b[2])))


def _factor_slope(lens: Lens, t: Array, factor: Array) -> Array:
    a, b = lens.radial, lens.rational
    above = a[0] + t * (2.0 * a[1] + t * (3.0 * a[2] + t * 4.0 * a[3]))
    below = b[0] + t * (2.0 * b[1] + t * 3.0 * b[2])
    return (above - factor * below) / (1.0 + t * (b[0] + t * (b[1] + t * b[2])))


def _slopes(lens: Lens, points: Array) -> tuple[Array, Array, Array, Array]:
    """Jacobian of `bend`: dx'/dx, dx'/dy, dy'/dx, dy'/dy."""
    x, y = points.T
    t = x * x + y * y
    factor = _factor(lens, t)
    slope = 2.0 * _factor_slope(lens, t, factor)
    (p1, p2), (s1, s2) = lens.tangential, lens.prism
    return (
        factor + slope * x * x + 2.0 * p1 * y + 6.0 * p2 * x + 2.0 * s1 * x,
        slope * x * y + 2.0 * p1 * x + 2.0 * p2 * y + 2.0 * s1 * y,
        slope * x * y + 2.0 * p2 * y + 2.0 * p1 * x + 2.0 * s2 * x,
        factor + slope * y * y + 2.0 * p2 * x + 6.0 * p1 * y + 2.0 * s2 * y,
    )


def _turning_radius(lens: Lens) -> float:
    """The smallest radius where r N / D stops growing or D is zero.
    The derivative has the sign of N D + 2 t (N' D - N D'), a polynomial in t = r^2, scaled so that the image spans
    0..1."""
    if lens.is_plain:
        return math.inf
    scale = max(lens.extent, 1e-6) ** 2
    with np.errstate(all="ignore"):
        above = np.array([1.0, *lens.radial]) * scale ** np.arange(5.0)
        below = np.array([1.0, *lens.rational]) * scale ** np.arange(4.0)
        slope = polynomial.polysub(
            polynomial.polymul(polynomial.polyder(above), below), polynomial.polymul(above, polynomial.polyder(below))
        )
        turning = polynomial.polyadd(polynomial.polymul(above, below), polynomial.polymulx(2.0 * slope))
    min_root = min(_smallest_root(turning), _smallest_root(below))
    return math.sqrt(min_root * scale)


def _smallest_root(coefficients: NDArray[np.floating]) -> float:
    """Smallest positive root of a polynomial (constant first), infinite if none, 0 for infinite coefficients."""
    if not np.isfinite(coefficients).all():
        return 0.0
    significant = np.flatnonzero(np.abs(coefficients) > NEGLIGIBLE_TERM * np.abs(coefficients).max())
    roots = polynomial.polyroots(coefficients[: significant[-1] + 1])
    real = roots.real[(np.abs(roots.imag) <= 1e-9 * np.abs(roots)) & (roots.real > 0)]
    return float(real.min()) if len(real) else math.inf


def _narrowed(lens: Lens, radius: float) -> float:
    """Largest radius up to `radius` within which the Jacobian determinant is positive."""
    angles = np.arange(SEARCH_DIRECTIONS) * (2.0 * math.pi / SEARCH_DIRECTIONS)
    across = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    limit = min(radius, max(8.0 * lens.extent, 8.0))
    radii = np.linspace(0.0, limit, SEARCH_STEPS + 1)
    grid = _orientation(lens, (across[:, None] * radii[None, :, None]).reshape(-1, 2)).reshape(SEARCH_DIRECTIONS, -1)
    is_folded = ~(grid[:, :-1] > 0)  # the last is the fold of the radial part itself
    if not is_folded.any():
        return radius
    first = np.where(is_folded.any(axis=1), np.argmax(is_folded, axis=1), SEARCH_STEPS)
    nearest = first == first.min()
    low, high = radii[np.maximum(first[nearest] - 1, 0)], radii[first[nearest]]
    for _ in range(60):
        middle = (low + high) / 2.0
        is_positive = _orientation(lens, across[nearest] * middle[:, None]) > 0
        low, high = np.where(is_positive, middle, low), np.where(is_positive, high, middle)
    return float(low.min())


def _orientation(lens: Lens, points: Array) -> Array:
    with np.errstate(all="ignore"):
        a, b, c, d = _slopes(lens, points)
        return a * d - b * c


def _straighten(lens: Lens, bent: Array) -> Array:
    """Inverse of `bend` within reach. NaN without a solution."""
    points = _straighten_radially(lens, bent)
    if lens.is_symmetric:
        return points
    points = np.where(np.isfinite(points), points, bent)  # a tangential term may compensate the radial ones
    for _ in range(MAX_ITERATIONS):
        error = bend(lens, points) - bent
        a, b, c, d = _slopes(lens, points)
        step = np.stack([d * error[:, 0] - b * error[:, 1], a * error[:, 1] - c * error[:, 0]], axis=1)
        step /= (a * d - b * c)[:, None]
        points = points - step
        if not (np.abs(step) > MIN_RESIDUAL * (1.0 + np.abs(points))).any():
            break
    size = 1e-12 * (1.0 + np.hypot(bent[:, 0], bent[:, 1]))
    is_solved = (np.abs(bend(lens, points) - bent).max(axis=1) <= size) & (_orientation(lens, points) > 0)
    points[~(is_solved & (np.hypot(points[:, 0], points[:, 1]) <= lens.max_radius))] = np.nan
    return points


def _straighten_radially(lens: Lens, bent: Array) -> Array:
    """The radial inverse: r N / D = r', monotonic up to `max_radius`, by safeguarded Newton."""
    wanted = np.hypot(bent[:, 0], bent[:, 1])
    low = np.zeros_like(wanted)
    max_radius = _turning_radius(lens)
    high = np.full_like(wanted, max_radius if max_radius < MAX_RAY_SLOPE else MAX_RAY_SLOPE)
    r = np.minimum(wanted, high)
    solution = np.where(wanted == 0, 0.0, np.nan)
    active = np.flatnonzero((wanted > 0) & (high * _factor(lens, high * high) >= wanted))
    for _ in range(MAX_ITERATIONS):
        if not len(active):
            break
        at = r[active]
        t = at * at
        factor = _factor(lens, t)
        value = at * factor - wanted[active]
        step = at - value / (factor + 2.0 * t * _factor_slope(lens, t, factor))
        is_above = ~(value < 0)
        high[active] = np.where(is_above, at, high[active])
        low[active] = np.where(is_above, low[active], at)
        middle = (low[active] + high[active]) / 2.0
        r[active] = np.where((step > low[active]) & (step < high[active]), step, middle)
        done = (np.abs(value) <= MIN_RESIDUAL * wanted[active]) | (np.abs(r[active] - at) <= MIN_RESIDUAL * at)
        solution[active[done]] = at[done]
        active = active[~done]
    return bent * np.where(wanted > 0, solution / wanted, 1.0)[:, None]
