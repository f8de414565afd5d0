"""The shape of least squared distances to some points, in float64, with the covariance of its numbers.

Gauss and Newton's steps damped after Levenberg and Marquardt, on true distances (Lukacs, Martin and Marshall, ECCV
1998; for the sphere Gander, Golub and Strebel 1994). Unknowns are a shift of the place along (u, v, a), tilts of the
direction towards u and v, and changes of the two numbers; which of them a kind has stands in FREE. The products of all
rows leave through one reduction a step, in a fixed order: 150 operations and 16 B a point; the host solves 3 to 7
unknowns. One wait a step, some 5 to 15 steps.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..array_types import Doubles, Indices, Points
from ..lang import array, dot, float64, func, int32, reduce, reduction, sqrt, tid, vec3, vec3d, vector
from ..memory import download
from .plane_samples import sampled_point
from .shape_models import CONE, CYLINDER, PLANE, SPHERE, TORUS, eight, measure

SUMS = 36  # on and above the diagonal of a row's seven unknowns and its distance
MOST_STEPS = 60
SETTLED = 1.0e-12  # of the size of the points: a step as short changes nothing
OPEN = 1.0e-11  # ratio of eigenvalues of the scaled system below which the points leave something open
NAMES = ("shift_u", "shift_v", "shift_axis", "tilt_u", "tilt_v", "first", "second")
FREE = {PLANE: [2, 3, 4], SPHERE: [0, 1, 2, 5], CYLINDER: [0, 1, 3, 4, 5], CONE: [0, 1, 2, 3, 4, 5]}
FREE[TORUS] = [0, 1, 2, 3, 4, 5, 6]
row_sums = vector(36, float64)


@func
def slopes(kind: int, p: vec3d, a: vec3d, u: vec3d, v: vec3d, r: float64, s: float64, x: vec3d) -> eight:
    """How the distance of x changes with each unknown, and the distance last."""
    y = x - p
    h = dot(y, a)
    across = y - a * h
    q = sqrt(dot(across, across))
    e = vec3d(0.0, 0.0, 0.0)
    if q > 0.0:
        e = across / q
    m = measure(kind, p, a, r, s, x)
    g = vec3d(m[1], m[2], m[3])
    lever = float64(0.0)
    first = float64(-1.0)
    second = float64(0.0)
    if kind == PLANE:
        lever = q * 1.0
    if kind == CYLINDER:
        lever = -h
    if kind == CONE:
        lever = -(r * h + s * q)
        first = -(q * s + h * r)
    if kind == TORUS:
        middle = q - r
        rho = sqrt(middle * middle + h * h)
        if rho > 0.0:
            lever = h * r / rho
            first = -middle / rho
        second = float64(-1.0)
    return eight(-dot(g, u), -dot(g, v), -dot(g, a), lever * dot(e, u), lever * dot(e, v), first, second, m[0])


@func
def row_products(j: eight, weight: float64) -> row_sums:
    """The products of a row's entries on and above the diagonal, times its weight."""
    sums = row_sums(0.0)
    at = 0
    for k in range(8):
        for m in range(k, 8):
            sums[at] = j[k] * j[m] * weight
            at += 1
    return sums


@reduction
def add_rows(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    kind: int,
    p: vec3d,
    a: vec3d,
    u: vec3d,
    v: vec3d,
    r: float64,
    s: float64,
) -> row_sums:
    """The products of a row's entries on and above the diagonal."""
    i = tid()
    j = slopes(kind, p, a, u, v, r, s, sampled_point(points, rows[i], center))
    return row_products(j, float64(1.0))


@reduction
def add_weighted_rows(
    points: array(dtype=vec3),
    weights: array(dtype=float64),
    rows: array(dtype=int32),
    center: vec3d,
    kind: int,
    p: vec3d,
    a: vec3d,
    u: vec3d,
    v: vec3d,
    r: float64,
    s: float64,
) -> row_sums:
    """The same, each row's products times the weight of its point."""
    i = tid()
    j = slopes(kind, p, a, u, v, r, s, sampled_point(points, rows[i], center))
    return row_products(j, weights[rows[i]])


@dataclass(frozen=True)
class ShapeFit:
    """What a fit found.

    Attributes:
        shape: float64 [8], relative to the middle.
        covariance: Of the unknowns in the order of FREE, about `frame` [unknowns, unknowns].
        frame: Rows u, v, a: what shifts and tilts are along.
        rms: Root of the mean squared distance [m].
        count: Points.
        reason: Why the numbers are not determined; empty where they are.
    """

    shape: NDArray[np.float64]
    covariance: NDArray[np.float64]
    frame: NDArray[np.float64]
    rms: float
    count: int
    reason: str


def frame_of(direction: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rows u, v, a of a right-handed frame about a unit direction."""
    u = np.cross(np.eye(3)[np.argmin(np.abs(direction))], direction)
    u /= np.linalg.norm(u)
    return np.stack([u, np.cross(direction, u), direction])


def stepped(
    kind: int, shape: NDArray[np.float64], frame: NDArray[np.float64], x: NDArray[np.float64]
) -> NDArray[np.float64]:
    """A shape changed by seven numbers."""
    place = shape[:3] + x[:3] @ frame
    direction = shape[3:6] + x[3:5] @ frame[:2]
    direction /= np.linalg.norm(direction)
    r, s = shape[6:]
    if kind == CONE:
        r, s = r * np.cos(x[5]) - s * np.sin(x[5]), s * np.cos(x[5]) + r * np.sin(x[5])
    elif kind in (SPHERE, CYLINDER, TORUS):
        r, s = r + x[5], s + x[6]
    return np.concatenate([place, direction, [r, s]])


def is_proper(kind: int, shape: NDArray[np.float64]) -> bool:
    """Whether sizes are above zero, and a half angle between 0 and 90 degrees."""
    return bool(np.isfinite(shape).all()) and (
        kind == PLANE or (shape[6] > 0 and (kind in (SPHERE, CYLINDER) or shape[7] > 0))
    )


class ShapeFitter:
    """Fits of one kind to some of the points of a cloud."""

    def __init__(
        self, points: Points, center: NDArray[np.float64], size: float, weights: Doubles | None = None
    ) -> None:
        """Of points whose middle is `center`; `size` [m] is how far they reach; weights have a mean of one."""
        self.points, self.center, self.size, self.weights = points, center, size, weights

    def fit(self, kind: int, shape: NDArray[np.float64], rows: Indices) -> ShapeFit:
        """The shape of least squared distances to `points[rows]` that is reached from another; a wait a step."""
        free = np.array(FREE[kind])
        scales = np.array([1.0, 1, 1, self.size, self.size, self.size if kind == CONE else 1, 1])[free]
        damping, shape = 1e-4, np.asarray(shape, np.float64)
        sums, frame = self._sums(kind, shape, rows)
        for _ in range(MOST_STEPS):
            if rows.size < len(free) or not is_proper(kind, shape):
                break
            h, b = sums[np.ix_(free, free)] / np.outer(scales, scales), sums[free, 7] / scales
            lifted = h + damping * np.diag(np.diag(h) + 1e-12 * max(np.trace(h), 1e-300))
            x = np.zeros(7)
            x[free] = np.linalg.lstsq(lifted, -b, rcond=None)[0] / scales
            offer = stepped(kind, shape, frame, x)
            longest = float(np.abs(x[free] * scales).max())
            if is_proper(kind, offer):
                next_sums, next_frame = self._sums(kind, offer, rows)
                if next_sums[7, 7] <= sums[7, 7]:
                    gain = sums[7, 7] - next_sums[7, 7]
                    shape, sums, frame, damping = offer, next_sums, next_frame, max(damping * 0.1, 1e-12)
                    if longest <= SETTLED * self.size or gain <= 1e-13 * sums[7, 7]:
                        break
                    continue
            if longest <= SETTLED * self.size or damping > 1e12:
                break
            damping *= 10
        return self._fit_of(kind, shape, sums, frame, free, scales, rows.size)

    def _fit_of(self, kind, shape, sums, frame, free, scales, count) -> ShapeFit:
        h = sums[np.ix_(free, free)] / np.outer(scales, scales)
        reason, covariance = "", np.full((len(free), len(free)), np.inf)
        rms = float(np.sqrt(max(sums[7, 7], 0.0) / max(count, 1)))
        if count <= len(free):
            reason = f"{count} points do not say how well {len(free)} unknowns are known"
        elif not (np.isfinite(h).all() and is_proper(kind, shape)):
            reason = "the fit has left what is a shape"
        else:
            d = 1 / np.sqrt(np.maximum(np.diag(h), 1e-300))
            values, vectors = np.linalg.eigh(h * np.outer(d, d))
            if values[0] <= OPEN * values[-1]:
                weak = NAMES[free[int(np.argmax(np.abs(vectors[:, 0])))]]
                reason = f"the points leave {weak} open"
            else:
                inverse = (vectors / values) @ vectors.T * np.outer(d, d)
                covariance = inverse / np.outer(scales, scales) * sums[7, 7] / (count - len(free))
        return ShapeFit(shape, covariance, frame, rms, count, reason)

    def _sums(self, kind, shape, rows) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The products of the rows as an 8x8 matrix, and the frame that they are about."""
        frame = np.eye(3) if kind == SPHERE else frame_of(shape[3:6])
        p, a, u, v = (vec3d(*vector) for vector in (shape[:3], frame[2], frame[0], frame[1]))
        arguments = [rows, vec3d(*self.center), kind, p, a, u, v, float(shape[6]), float(shape[7])]
        if self.weights is None:
            totals = reduce(add_rows, rows.size, [self.points, *arguments])
        else:
            totals = reduce(add_weighted_rows, rows.size, [self.points, self.weights, *arguments])
        upper = download(totals)[0]  # sync
        full = np.zeros((8, 8))
        full[np.triu_indices(8)] = upper
        return full + np.triu(full, 1).T, frame
