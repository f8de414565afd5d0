"""Simultaneous fits of several shapes, each over its own rows: state, and sums for a step.

Lukacs, Martin and Marshall 1998: products of the derivatives of true distances. 9 B per row and fit.
"""

from ..lang import (
    array,
    dot,
    float64,
    func,
    int32,
    kernel,
    reduction,
    segment_reduction,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vector,
)
from .plane_samples import sampled_point
from .shape_models import CONE, CYLINDER, PLANE, TORUS, eight, measure

SQUARES_AT, COUNT_AT, POSITIONS_AT = 35, 36, 37  # sums: squared distances, rows, positions along u, v and the axis
SELECTION_PHASE, FIRST_SUMS_PHASE, STEP_PHASE, ENDED_PHASE = range(4)  # purpose of the current sums
fit_sums = vector(40, float64)
moment_sums = vector(9, float64)


@struct
class ShapeFits:
    """State of fits. Elements: `rows` of points, `jobs` (fits), `mask` (1 if used). Fits: accepted `shapes` and trial
    `offers` float64 [k, 8], trial `frames` (u, v, axis), `sums` of accepted shapes, `dampings`, longest step component
    [m], `phases` (from SELECTION_PHASE), counters, best round (-1 if none). `live` and `running` are 1 until done."""

    rows: array(dtype=int32)
    jobs: array(dtype=int32)
    mask: array(dtype=uint8)
    kinds: array(dtype=int32)
    shapes: array(dtype=float64, ndim=2)
    offers: array(dtype=float64, ndim=2)
    frames: array(dtype=vec3d, ndim=2)
    sums: array(dtype=fit_sums)
    dampings: array(dtype=float64)
    longest: array(dtype=float64)
    phases: array(dtype=int32)
    steps: array(dtype=int32)
    rounds: array(dtype=int32)
    max_rounds: array(dtype=int32)
    bests: array(dtype=float64, ndim=2)
    best_sums: array(dtype=fit_sums)
    best_counts: array(dtype=int32)
    live: array(dtype=int32)
    running: array(dtype=int32)


@struct
class FitRules:
    """Convergence and inlier limits: `size` [m] of the points, minimum relative `gain`, mean squared distance [m^2] to
    give up (0: none), distance [m], minimum cosine, and radii [m]."""

    size: float64
    gain: float64
    hopeless: float64
    threshold: float64
    cosine: float64
    smallest: float64
    largest: float64


@func
def position_in(shapes: array(dtype=float64, ndim=2), k: int) -> vec3d:
    return vec3d(shapes[k, 0], shapes[k, 1], shapes[k, 2])


@func
def axis_in(shapes: array(dtype=float64, ndim=2), k: int) -> vec3d:
    return vec3d(shapes[k, 3], shapes[k, 4], shapes[k, 5])


@func
def slopes(kind: int, p: vec3d, a: vec3d, u: vec3d, v: vec3d, r: float64, s: float64, x: vec3d) -> eight:
    """Derivatives of the distance of x by each unknown, then the distance."""
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
def sums_at(fits: ShapeFits, k: int, x: vec3d, weight: float64) -> fit_sums:
    """Weighted products (upper triangle) of a row, its count, and its position in the frame."""
    p = position_in(fits.offers, k)
    u = fits.frames[k, 0]
    v = fits.frames[k, 1]
    a = fits.frames[k, 2]
    j = slopes(fits.kinds[k], p, a, u, v, fits.offers[k, 6], fits.offers[k, 7], x)
    total = fit_sums(0.0)
    at = 0
    for row in range(8):
        for column in range(row, 8):
            total[at] = j[row] * j[column] * weight
            at += 1
    total[COUNT_AT] = 1.0
    total[POSITIONS_AT] = dot(x - p, u)
    total[POSITIONS_AT + 1] = dot(x - p, v)
    total[POSITIONS_AT + 2] = dot(x - p, a)
    return total


@segment_reduction
def add_fit_rows(points: array(dtype=vec3), center: vec3d, fits: ShapeFits) -> fit_sums:
    """Contribution of a row to the sums of its fit at the trial shape."""
    t = tid()
    total = fit_sums(0.0)
    if fits.mask[t] != 0:
        k = fits.jobs[t]
        x = sampled_point(points, fits.rows[t], center)
        total = sums_at(fits, k, x, float64(1.0))
    return total


@segment_reduction
def add_weighted_fit_rows(
    points: array(dtype=vec3), weights: array(dtype=float64), center: vec3d, fits: ShapeFits
) -> fit_sums:
    """`add_fit_rows` with point weights."""
    t = tid()
    total = fit_sums(0.0)
    if fits.mask[t] != 0:
        k = fits.jobs[t]
        x = sampled_point(points, fits.rows[t], center)
        total = sums_at(fits, k, x, weights[fits.rows[t]])
    return total


@reduction
def sum_moments(points: array(dtype=vec3), rows: array(dtype=int32), center: vec3d) -> moment_sums:
    i = tid()
    x = sampled_point(points, rows[i], center)
    return moment_sums(
        x[0], x[1], x[2], x[0] * x[0], x[0] * x[1], x[0] * x[2], x[1] * x[1], x[1] * x[2], x[2] * x[2]
    )  # fmt: skip


@kernel
def list_fit_rows_kernel(rows: array(dtype=int32), fits: ShapeFits):
    """The same rows for several fits, all used."""
    i = tid()
    fits.rows[i] = rows[i % rows.shape[0]]
    fits.jobs[i] = i // rows.shape[0]
    fits.mask[i] = uint8(1)


@func
def is_on(
    kind: int, p: vec3d, a: vec3d, r: float64, s: float64, x: vec3d, n: vec3, threshold: float64, cosine: float64
) -> int:
    m = measure(kind, p, a, r, s, x)
    size = sqrt(float64(dot(n, n)))
    facing = abs(m[1] * float64(n[0]) + m[2] * float64(n[1]) + m[3] * float64(n[2]))
    inside = 0
    if abs(m[0]) < threshold and facing >= cosine * size:
        inside = 1
    return inside


@kernel
def select_fit_rows_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), center: vec3d, rules: FitRules, fits: ShapeFits
):
    t = tid()
    k = fits.jobs[t]
    if fits.phases[k] == SELECTION_PHASE:
        row = fits.rows[t]
        x = sampled_point(points, row, center)
        p = position_in(fits.offers, k)
        a = axis_in(fits.offers, k)
        r = fits.offers[k, 6]
        s = fits.offers[k, 7]
        fits.mask[t] = uint8(is_on(fits.kinds[k], p, a, r, s, x, normals[row], rules.threshold, rules.cosine))
