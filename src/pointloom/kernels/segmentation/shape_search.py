"""RANSAC search for the shape of a kind with the most points.

Schnabel, Wahl and Klein, "Efficient RANSAC for point-cloud shape detection", CGF 2007, section 4.1; tori by Marshall,
Lukacs and Martin, PAMI 2001. Samples are drawn from runs of random length along a Hilbert curve, instead of octree
cells. Each batch is scored on every n-th point, the best on all points, and the best of these are refitted while their
inliers increase. Points must be in tree order. 24 B per point, 68 B per sample.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..array_types import AnyArray, Array1, Array2, Indices, Integers, Mask, Points, Vectors
from ..arrays.bounds import bound_points, box_of, find_extremes, fold_box_kernel
from ..arrays.random import random_below, random_bits
from ..arrays.select import gather_rows, positions_of
from ..arrays.side_by_side import read_together
from ..arrays.sort import argsort_keys, descending_keys
from ..lang import (
    array,
    atomic_add,
    atomic_max,
    compute,
    cross,
    dot,
    float32,
    float64,
    func,
    int32,
    kernel,
    launch,
    loop,
    sqrt,
    tid,
    uint8,
    vec3,
    vec3d,
)
from ..memory import download, empty, upload, zeros
from .plane_samples import sampled_point
from .shape_fit import EXACT_GAIN, ROUGH_GAIN, Selection, ShapeFit, ShapeFitter, Shapes, frame_of
from .shape_fit_rows import is_on
from .shape_models import (
    CONE,
    CYLINDER,
    NO_SHAPE,
    PLANE,
    SHAPE_NUMBERS,
    SPHERE,
    TORUS,
    ShapePoints,
    eight,
    measure,
    normal_at,
    position_at,
    split_points_kernel,
)
from .shape_rows import every_of

MIN_SINE = 0.05  # between normals: below it, noise determines their intersection
MIN_WINDOW = 16  # points of the shortest run
MAX_CONE_COSINE, MIN_CONE_COSINE = 0.9995, 0.06  # half angle: 1.8 and 86.6 degrees, else it is a line or a plane


@func
def no_shape() -> eight:
    """A shape without a size, dropped by `draw_shapes_kernel`."""
    return eight(0.0, 0.0, 0.0, 0.0, 0.0, 1.0, -1.0, -1.0)


@func
def shape_of(p: vec3d, a: vec3d, r: float64, s: float64) -> eight:
    return eight(p[0], p[1], p[2], a[0], a[1], a[2], r, s)


@func
def plane_through(p: vec3d, q: vec3d, o: vec3d) -> eight:
    u = q - p
    v = o - p
    n = cross(u, v)
    size = sqrt(dot(n, n))
    shape = no_shape()
    if size > float64(MIN_SINE) * sqrt(dot(u, u) * dot(v, v)) and size > 0.0:
        shape = shape_of(p, n / size, 1.0, 1.0)
    return shape


@func
def round_through(p: vec3d, m: vec3d, q: vec3d, n: vec3d, kind: int) -> eight:
    """Sphere or cylinder with the given normals at two points."""
    a = cross(m, n)
    size = sqrt(dot(a, a))
    shape = no_shape()
    if size > float64(MIN_SINE):
        w = p - q
        b = dot(m, n)
        t = (b * dot(n, w) - dot(m, w)) / (size * size)
        u = (dot(n, w) - b * dot(m, w)) / (size * size)
        middle = (p + m * t + q + n * u) * 0.5
        radius = (abs(t) + abs(u)) * 0.5
        if kind == SPHERE:
            v = p - middle
            o = q - middle
            radius = (sqrt(dot(v, v)) + sqrt(dot(o, o))) * 0.5
        shape = shape_of(middle, a / size, radius, 1.0)
    return shape


@func
def unit(v: vec3d) -> vec3d:
    size = sqrt(dot(v, v))
    u = vec3d(0.0, 0.0, 0.0)
    if size > 0.0:
        u = v / size
    return u


@func
def cone_through(p: vec3d, l: vec3d, q: vec3d, m: vec3d, o: vec3d, n: vec3d) -> eight:  # noqa: E741  the first normal
    """Cone with its apex on the tangent planes of three points."""
    volume = dot(l, cross(m, n))
    shape = no_shape()
    if abs(volume) > 0.001:
        apex = p + (cross(n, l) * dot(m, q - p) + cross(l, m) * dot(n, o - p)) / volume
        x = unit(p - apex)
        y = unit(q - apex)
        z = unit(o - apex)
        a = unit(cross(y - x, z - x))
        if dot(a, x) < 0.0:
            a = -a
        c = (dot(a, x) + dot(a, y) + dot(a, z)) / 3.0
        if c < float64(MAX_CONE_COSINE) and c > float64(MIN_CONE_COSINE):
            shape = shape_of(apex, a, c, sqrt(1.0 - c * c))
    return shape


@func
def meeting_terms(d: vec3d, m: vec3d, n: vec3d, e: vec3d, o: vec3d) -> eight:
    """Coefficients of 1, t, u, tu of the condition that the line from t m to d + u n meets that from e along o."""
    zero = float64(0.0)
    return eight(
        dot(cross(d, e), o), -dot(cross(d, m) + cross(m, e), o), dot(cross(n, e), o), dot(cross(m, n), o),
        zero, zero, zero, zero,
    )  # fmt: skip


@func
def ring_about(c: vec3d, a: vec3d, xs: eight, ys: eight) -> eight:
    """Torus around an axis whose tube center is nearest to four normal lines rotated into one plane; `xs`, `ys` are
    position and normal across and along the axis, relative to c."""
    aa = float64(0.0)
    ab = float64(0.0)
    bb = float64(0.0)
    fa = float64(0.0)
    fb = float64(0.0)
    for k in range(4):
        tx = -ys[2 * k + 1]
        ty = xs[2 * k + 1]
        rest = tx * xs[2 * k] + ty * ys[2 * k]
        aa += tx * tx
        ab += tx * ty
        bb += ty * ty
        fa += tx * rest
        fb += ty * rest
    det = aa * bb - ab * ab
    shape = no_shape()
    if det > 0.001:
        r = (fa * bb - fb * ab) / det
        h = (aa * fb - ab * fa) / det
        s = float64(0.0)
        for k in range(4):
            dx = xs[2 * k] - r
            dy = ys[2 * k] - h
            s += 0.25 * sqrt(dx * dx + dy * dy)
        if r > s:
            shape = shape_of(c + a * h, a, r, s)
    return shape


@func
def worst_of(shape: eight, p: vec3d, q: vec3d, o: vec3d, z: vec3d) -> float64:
    c = vec3d(shape[0], shape[1], shape[2])
    a = vec3d(shape[3], shape[4], shape[5])
    far = abs(measure(TORUS, c, a, shape[6], shape[7], p)[0])
    far = max(far, abs(measure(TORUS, c, a, shape[6], shape[7], q)[0]))
    far = max(far, abs(measure(TORUS, c, a, shape[6], shape[7], o)[0]))
    return max(far, abs(measure(TORUS, c, a, shape[6], shape[7], z)[0]))


@func
def torus_about(
    c: vec3d, a: vec3d, p: vec3d, k: vec3d, q: vec3d, j: vec3d, o: vec3d, m: vec3d, z: vec3d, n: vec3d
) -> eight:
    """Torus around an axis through c through four points with normals k, j, m, n."""
    hp = dot(p - c, a)
    hq = dot(q - c, a)
    ho = dot(o - c, a)
    hz = dot(z - c, a)
    ep = p - c - a * hp
    eq = q - c - a * hq
    eo = o - c - a * ho
    ez = z - c - a * hz
    xs = eight(
        sqrt(dot(ep, ep)), dot(unit(ep), k), sqrt(dot(eq, eq)), dot(unit(eq), j),
        sqrt(dot(eo, eo)), dot(unit(eo), m), sqrt(dot(ez, ez)), dot(unit(ez), n),
    )  # fmt: skip
    ys = eight(hp, dot(a, k), hq, dot(a, j), ho, dot(a, m), hz, dot(a, n))
    return ring_about(c, a, xs, ys)


@func
def torus_through(p: vec3d, k: vec3d, q: vec3d, j: vec3d, o: vec3d, m: vec3d, z: vec3d, n: vec3d) -> eight:
    """Torus through four points whose axis meets their normals. The better of the two axes."""
    f = meeting_terms(q - p, k, j, o - p, m)
    g = meeting_terms(q - p, k, j, z - p, n)
    a2 = g[1] * f[3] - f[1] * g[3]
    a1 = g[0] * f[3] + g[1] * f[2] - f[0] * g[3] - f[1] * g[2]
    a0 = g[0] * f[2] - f[0] * g[2]
    inside = a1 * a1 - 4.0 * a2 * a0
    best = no_shape()
    if inside >= 0.0 and abs(a2) > 0.0:
        best_error = float64(1.0e300)
        sides = int(2)
        for side in range(sides):
            root = sqrt(inside)
            if side == 1:
                root = -root
            t = (root - a1) / (2.0 * a2)
            below = f[2] + f[3] * t
            if abs(below) > 0.0:
                u = -(f[0] + f[1] * t) / below
                c = p + k * t
                a = unit(q + j * u - c)
                if dot(a, a) > 0.5:
                    shape = torus_about(c, a, p, k, q, j, o, m, z, n)
                    if shape[6] > 0.0:
                        worst = worst_of(shape, p, q, o, z)
                        if worst < best_error:
                            best_error = worst
                            best = shape * 1.0
    return best


@func
def row_near(rows: int, seed: int, number: int, stream: int, levels: int, anchor: int) -> int:
    """Random index in the run of the anchor with the sample's length."""
    level = random_below(random_bits(seed, number, 0), levels)
    width = max(rows >> level, min(rows, MIN_WINDOW))
    start = min((anchor // width) * width, rows - width)
    return start + random_below(random_bits(seed, number, stream), width)


@func
def contradicts(kind: int, shape: eight, p: vec3d, n: vec3d, threshold: float64, min_cosine: float64) -> int:
    c = vec3d(shape[0], shape[1], shape[2])
    a = vec3d(shape[3], shape[4], shape[5])
    m = measure(kind, c, a, shape[6], shape[7], p)
    wrong = 0
    if abs(m[0]) > threshold or abs(m[1] * n[0] + m[2] * n[1] + m[3] * n[2]) < min_cosine:
        wrong = 1
    return wrong


@kernel
def draw_shapes_kernel(
    cloud: ShapePoints,
    kind: int,
    seed: int,
    first: int,
    levels: int,
    threshold: float64,
    min_cosine: float64,
    smallest: float64,
    largest: float64,
    shapes: array(dtype=float64, ndim=2),
    kinds: array(dtype=int32),
):
    """Shape of each sample, or none. Independent of the batch."""
    i = tid()
    number = first + i
    at = random_below(random_bits(seed, number, 1), cloud.count)
    bt = row_near(cloud.count, seed, number, 2, levels, at)
    ct = row_near(cloud.count, seed, number, 3, levels, at)
    dt = row_near(cloud.count, seed, number, 4, levels, at)
    p = position_at(cloud, at)
    q = position_at(cloud, bt)
    o = position_at(cloud, ct)
    z = position_at(cloud, dt)
    k = normal_at(cloud, at)
    m = normal_at(cloud, bt)
    n = normal_at(cloud, ct)
    e = normal_at(cloud, dt)
    shape = no_shape()
    wrong = 0
    if kind == PLANE:
        shape = plane_through(p, q, o)
    if kind == SPHERE or kind == CYLINDER:
        shape = round_through(p, k, q, m, kind)
    if kind == CONE:
        shape = cone_through(p, k, q, m, o, n)
    if kind == TORUS:
        shape = torus_through(p, k, q, m, o, n, z, e)
        wrong = contradicts(kind, shape, z, e, threshold, min_cosine)
    if kind == PLANE or kind == CONE or kind == TORUS:
        wrong += contradicts(kind, shape, o, n, threshold, min_cosine)
    wrong += contradicts(kind, shape, p, k, threshold, min_cosine)
    wrong += contradicts(kind, shape, q, m, threshold, min_cosine)
    size = shape[6]
    if kind == TORUS:
        size = shape[7]
    if shape[6] <= 0.0 or wrong > 0:
        kinds[i] = NO_SHAPE
    elif kind == SPHERE or kind == CYLINDER or kind == TORUS:
        kinds[i] = kind if size >= smallest and shape[6] <= largest else NO_SHAPE
    else:
        kinds[i] = kind
    for entry in range(8):
        shapes[i, entry] = shape[entry]


CPU_RUN, CUDA_RUN = 2048, 128  # points per thread


@func
def count_plane(cloud: ShapePoints, first: int, last: int, c: vec3, a: vec3, near: float, cosine: float) -> int:
    count = 0
    for j in range(first, last):
        d = a[0] * (cloud.xs[j] - c[0]) + a[1] * (cloud.ys[j] - c[1]) + a[2] * (cloud.zs[j] - c[2])
        if abs(d) < near and abs(a[0] * cloud.us[j] + a[1] * cloud.vs[j] + a[2] * cloud.ws[j]) >= cosine:
            count += 1
    return count


@loop
def points_about(
    cloud: ShapePoints, first: int, last: int, c: vec3, a: vec3
) -> tuple[int, float, float, float, float, float]:
    """Points of a run by index, with x, y, z of their offset from an axis, height along it and distance from it."""
    for j in range(first, last):
        x = cloud.xs[j] - c[0]
        y = cloud.ys[j] - c[1]
        z = cloud.zs[j] - c[2]
        h = a[0] * x + a[1] * y + a[2] * z
        x = x - h * a[0]
        y = y - h * a[1]
        z = z - h * a[2]
        q = sqrt(x * x + y * y + z * z)
        yield j, x, y, z, h, q


@func
def count_round(
    cloud: ShapePoints, first: int, last: int, c: vec3, a: vec3, r: float, near: float, cosine: float
) -> int:
    """Points of a run on a cylinder, or on a sphere if the direction is zero."""
    count = 0
    for j, x, y, z, h, q in points_about(cloud, first, last, c, a):
        if abs(q - r) < near and abs(x * cloud.us[j] + y * cloud.vs[j] + z * cloud.ws[j]) >= cosine * q:
            count += 1
    return count


@func
def count_cone(
    cloud: ShapePoints, first: int, last: int, c: vec3, a: vec3, r: float, s: float, near: float, cosine: float
) -> int:
    count = 0
    for j, x, y, z, h, q in points_about(cloud, first, last, c, a):
        n = a[0] * cloud.us[j] + a[1] * cloud.vs[j] + a[2] * cloud.ws[j]
        facing = r * (x * cloud.us[j] + y * cloud.vs[j] + z * cloud.ws[j]) - s * n * q
        if abs(q * r - h * s) < near and q * s + h * r >= 0.0 and abs(facing) >= cosine * q:
            count += 1
    return count


@func
def count_torus(
    cloud: ShapePoints, first: int, last: int, c: vec3, a: vec3, r: float, s: float, near: float, cosine: float
) -> int:
    count = 0
    for j, x, y, z, h, q in points_about(cloud, first, last, c, a):
        m = q - r
        rho = sqrt(m * m + h * h)
        n = a[0] * cloud.us[j] + a[1] * cloud.vs[j] + a[2] * cloud.ws[j]
        facing = m * (x * cloud.us[j] + y * cloud.vs[j] + z * cloud.ws[j]) + h * n * q
        if abs(rho - s) < near and abs(facing) >= cosine * q * rho:
            count += 1
    return count


@kernel
def score_shapes_kernel(
    cloud: ShapePoints,
    run: int,
    shapes: array(dtype=float64, ndim=2),
    kinds: array(dtype=int32),
    near: float,
    cosine: float,
    counts: array(dtype=int32),
):
    i = tid()
    k = i % kinds.shape[0]
    first = (i // kinds.shape[0]) * run
    last = min(first + run, cloud.count)
    kind = kinds[k]
    c = vec3(float(shapes[k, 0]), float(shapes[k, 1]), float(shapes[k, 2]))
    a = vec3(float(shapes[k, 3]), float(shapes[k, 4]), float(shapes[k, 5]))
    r = float(shapes[k, 6])
    s = float(shapes[k, 7])
    count = 0
    if kind == PLANE:
        count = count_plane(cloud, first, last, c, a, near, cosine)
    if kind == SPHERE:
        count = count_round(cloud, first, last, c, vec3(0.0, 0.0, 0.0), r, near, cosine)
    if kind == CYLINDER:
        count = count_round(cloud, first, last, c, a, r, near, cosine)
    if kind == CONE:
        count = count_cone(cloud, first, last, c, a, r, s, near, cosine)
    if kind == TORUS:
        count = count_torus(cloud, first, last, c, a, r, s, near, cosine)
    if count > 0:
        atomic_add(counts, k, count)  # an integer sum does not depend on the order


def score_shapes(
    cloud: ShapePoints, shapes: Array2[float64], kinds: Integers, threshold: float, min_cosine: float
) -> Integers:
    counts = zeros(kinds.size, int32, kinds.device)
    run = CUDA_RUN if kinds.device.is_cuda else CPU_RUN
    arguments = [cloud, run, shapes, kinds, threshold, min_cosine, counts]
    launch(score_shapes_kernel, kinds.size * -(-cloud.count // run), arguments)
    return counts


SAMPLE_POINTS = {PLANE: 3, SPHERE: 2, CYLINDER: 2, CONE: 3, TORUS: 4}
SCORING_POINTS = 2048  # points used to score all samples
FIRST_BATCH, BATCH_GROWTH, MAX_BATCH = 256, 4, 8192
MAX_PROMISING = 16  # samples of a batch scored on all points
MAX_REFINED = 6  # samples fitted to their points
FITTED_PART = 4096  # maximum number of points for the first fit of the best samples
MAX_FITS = 6  # of one sample, each to the inliers of the previous one
SECTOR_COUNT, BAND_COUNT = 36, 18  # cells around a shape and along it: the fraction with points is its coverage
KIND_SEED_STEP = 7919  # offset between the seeds of kinds


@dataclass(frozen=True)
class ShapeLimits:
    """Inlier limits (`distance` [m], exclusive; `cosine` between unsigned normals), and radii [m]."""

    distance: float
    cosine: float
    smallest: float
    largest: float

    def allow(self, kind: int, shape: NDArray[np.float64]) -> bool:
        if kind in (PLANE, CONE):
            return True
        return bool(shape[7 if kind == TORUS else 6] >= self.smallest and shape[6] <= self.largest)


Drawn = tuple[NDArray[np.float64], NDArray[np.int64]]  # shapes and their inlier counts


@dataclass(frozen=True)
class DetectedShape:
    """A shape with its fit relative to the search center, and its inlier rows in search order."""

    kind: int
    fit: ShapeFit
    rows: Indices


@kernel
def mask_on_shape_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    kind: int,
    p: vec3d,
    a: vec3d,
    sizes: vec3d,
    threshold: float64,
    min_cosine: float64,
    mask: array(dtype=uint8),
):
    i = tid()
    x = sampled_point(points, rows[i], center)
    mask[i] = uint8(is_on(kind, p, a, sizes[0], sizes[1], x, normals[rows[i]], threshold, min_cosine))


@kernel
def rotate_points_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    p: vec3d,
    u: vec3d,
    v: vec3d,
    a: vec3d,
    rotated: array(dtype=vec3),
):
    i = tid()
    y = sampled_point(points, rows[i], center) - p
    rotated[i] = vec3(float32(dot(y, u)), float32(dot(y, v)), float32(dot(y, a)))


@kernel
def mark_cells_kernel(
    rotated: array(dtype=vec3), kind: int, r: float, directions: array(dtype=float32), cells: array(dtype=int32)
):
    """Mark the cell of each point: sector around the axis, and band along a sphere or around a torus tube."""
    i = tid()
    p = rotated[i]
    sector = 0
    best = -float(1.0e30)
    for k in range(SECTOR_COUNT):
        along = directions[2 * k] * p[0] + directions[2 * k + 1] * p[1]
        if along > best:
            best = along
            sector = k
    band = 0
    if kind == TORUS:
        q = sqrt(p[0] * p[0] + p[1] * p[1]) - r
        best = -float(1.0e30)
        for k in range(BAND_COUNT):  # every other direction
            along = directions[4 * k] * q + directions[4 * k + 1] * p[2]
            if along > best:
                best = along
                band = k
    if kind == SPHERE and r > 0.0:
        band = int(float(BAND_COUNT) * (p[2] + r) / (2.0 * r))
        band = max(0, min(BAND_COUNT - 1, band))
    atomic_max(cells, sector * BAND_COUNT + band, 1)  # all threads write the same value


@kernel
def take_shapes_kernel(
    order: array(dtype=int32),
    shapes: array(dtype=float64, ndim=2),
    kinds: array(dtype=int32),
    scores: array(dtype=int32),
    best: array(dtype=float64, ndim=2),
    of: array(dtype=int32),
    near: array(dtype=int32),
):
    i = tid()
    k = order[i]
    for entry in range(SHAPE_NUMBERS):
        best[i, entry] = shapes[k, entry]
    of[i] = kinds[k]
    near[i] = scores[k]


def drawn_of(arrays: Sequence[NDArray[Any]]) -> list[Drawn]:
    """Sort the results of `draw_unread` (three arrays per draw) by decreasing score: (shapes, counts)."""
    drawn = []
    for shapes, near, counts in zip(arrays[::3], arrays[1::3], arrays[2::3], strict=True):
        chosen = near > 0
        best, on = shapes[chosen].copy(), counts[chosen].astype(np.int64)
        order = np.argsort(-on, kind="stable")
        drawn.append((best[order], on[order]))
    return drawn


class ShapeSearch:
    """Search among oriented points. Shapes are relative to the box center; `size` is half its longest side [m]."""

    def __init__(self, points: Points, normals: Vectors, rows: Indices, of: "ShapeSearch | None" = None) -> None:
        """Search among finite `points[rows]` in tree order. `of`: a larger search with center, size. Else one sync."""
        self.points, self.normals, self.rows, self.device = points, normals, rows, points.device
        if of is None:
            low, high = bound_points(gather_rows(points, rows))[:2] if rows.size else (np.zeros(3), np.zeros(3))  # sync
            low, high = low.astype(np.float64), high.astype(np.float64)
            self.center = (0.5 * (low + high)).astype(np.float32).astype(np.float64)
            self.size = float(max((high - self.center).max(), (self.center - low).max()))
        else:
            self.center, self.size = of.center, of.size
        middle = self.center.astype(np.float32)
        step = max(1, rows.size // SCORING_POINTS)
        self.fraction = step
        self.cloud = self._split(vec3(*middle), 1, 0, rows.size)
        self.part = self._split(vec3(*middle), step, step // 2, min(rows.size, max(1, rows.size // step)))
        self.levels = max(1, int(math.log2(max(1, rows.size / MIN_WINDOW))))
        self.fitter = ShapeFitter(points, self.center, max(self.size, 1e-30))

    def draw(self, kind: int, count: int, seed: int, first: int, limits: ShapeLimits) -> Drawn:
        """Best shapes of samples `first` .. `first + count`, and their inlier counts."""
        return self.draw_each([(kind, count, first)], seed, limits)[0]

    def draw_each(self, samples: Sequence[tuple[int, int, int]], seed: int, limits: ShapeLimits) -> list[Drawn]:
        """`draw` for several (kind, count, first). One sync: sorted (float64 [m, 8], int64 [m]), m <= MAX_PROMISING."""
        there = [self.draw_unread(*one, seed, limits) for one in samples]
        return drawn_of(read_together([values for one in there for values in one]))  # sync

    def draw_unread(self, kind: int, count: int, first: int, seed: int, limits: ShapeLimits) -> list[AnyArray]:
        """Device arrays for `drawn_of`: shapes, and inliers in the part and in all points."""
        shapes, kinds = empty((count, SHAPE_NUMBERS), float64, self.device), empty(count, int32, self.device)
        kind_seed = (seed + KIND_SEED_STEP * kind) % 2**31
        drawn = [self.cloud, kind, kind_seed, first, self.levels, limits.distance, limits.cosine]
        launch(draw_shapes_kernel, count, [*drawn, limits.smallest, limits.largest, shapes, kinds])
        scores = score_shapes(self.part, shapes, kinds, limits.distance, limits.cosine)
        keys = descending_keys(scores, self.part.count)
        order = argsort_keys(keys, max(1, self.part.count.bit_length()))[1]
        m = min(count, MAX_PROMISING)
        best, of = empty((m, SHAPE_NUMBERS), float64, self.device), empty(m, int32, self.device)
        near = compute(take_shapes_kernel, m, [order, shapes, kinds, scores, best, of], int32, self.device)
        return [best, near, score_shapes(self.cloud, best, of, limits.distance, limits.cosine)]

    def score(self, shapes: NDArray[np.float64], kinds: NDArray, limits: ShapeLimits) -> NDArray[np.int64]:
        """Inlier counts of shapes. One sync."""
        if not len(shapes):
            return np.zeros(0, np.int64)
        there, of = upload(shapes, float64, self.device), upload(kinds.astype(np.int32), int32, self.device)
        return download(score_shapes(self.cloud, there, of, limits.distance, limits.cosine)).astype(np.int64)

    def find(
        self, kind: int, limits: ShapeLimits, max_samples: int, probability: float, seed: int
    ) -> DetectedShape | None:
        """Shape with the most inliers, or None."""
        pool, counts = np.zeros((0, SHAPE_NUMBERS)), np.zeros(0, np.int64)
        done, batch, needed = 0, FIRST_BATCH, float(max_samples)
        while done < min(max_samples, needed):
            size = int(min(batch, max_samples - done))
            drawn, scores = self.draw(kind, size, seed, done, limits)
            pool, counts = np.concatenate([pool, drawn]), np.concatenate([counts, scores])
            best = np.argsort(-counts, kind="stable")[:MAX_REFINED]
            pool, counts = pool[best], counts[best]
            done += size
            fraction = counts[0] / self.rows.size if len(counts) else 0.0
            needed = samples_needed(fraction, kind, self.levels, probability, max_samples)
            batch = min(BATCH_GROWTH * batch, MAX_BATCH)
        part = self._part_search()
        if part is not None and len(pool):
            refined = [one for one in part.refine_all([kind] * len(pool), pool, limits) if one is not None]
            best = max(refined, key=lambda one: (one[1], -one[0].rms), default=None)
            pool = pool[:1] if best is None else best[0].shape[None]
        refits = [one for one in self.each_refined([kind] * len(pool), pool, limits) if one is not None]
        return max(refits, key=lambda one: (one.rows.size, -one.fit.rms), default=None)

    def _part_search(self) -> "ShapeSearch | None":
        """Search among every n-th point. None if there are few."""
        if self.rows.size <= FITTED_PART:
            return None
        step = -(-self.rows.size // FITTED_PART)
        return ShapeSearch(self.points, self.normals, every_of(self.rows, step), self)

    def refine_all(
        self, kinds: Sequence[int], shapes: Shapes, limits: ShapeLimits, gain: float = ROUGH_GAIN
    ) -> list[tuple[ShapeFit, int] | None]:
        """Shapes refitted while their inliers increase, with counts. None without inliers. One sync."""
        chosen = Selection(
            self.normals, limits.distance, limits.cosine, limits.smallest, limits.largest, MAX_FITS
        )  # fmt: skip
        return self.fitter.refine_all(kinds, shapes, self.rows, chosen, gain)

    def each_refined(self, kinds: Sequence[int], shapes: Shapes, limits: ShapeLimits) -> list[DetectedShape | None]:
        """`refine_all` to full accuracy."""
        each = zip(kinds, self.refine_all(kinds, shapes, limits, EXACT_GAIN), strict=True)
        return [
            None if one is None else DetectedShape(kind, one[0], self.on(kind, one[0].shape, limits, one[1]))
            for kind, one in each
        ]

    def on(self, kind: int, shape: NDArray[np.float64], limits: ShapeLimits, count: int | None = None) -> Indices:
        """Inlier rows of a shape. One sync if their number is unknown."""
        return gather_rows(self.rows, positions_of(self.mask(kind, shape, limits), count))

    def mask(self, kind: int, shape: NDArray[np.float64], limits: ShapeLimits) -> Mask:
        mask = empty(self.rows.size, uint8, self.device)
        arguments = [self.points, self.normals, self.rows, vec3d(*self.center), kind, *_taken_apart(shape)]
        launch(mask_on_shape_kernel, mask.size, [*arguments, limits.distance, limits.cosine, mask])
        return mask

    def in_frame(self, shape: NDArray[np.float64], rows: Indices) -> Points:
        frame, out = frame_of(shape[3:6]), empty(rows.size, vec3, self.device)
        arguments = [self.points, rows, vec3d(*self.center), vec3d(*shape[:3]), *(vec3d(*axis) for axis in frame), out]
        launch(rotate_points_kernel, rows.size, arguments)
        return out

    def spread_unread(self, detected: DetectedShape) -> tuple[Integers, Array1[float32], Integers]:
        """Device input of `spread_of` for a shape's points, and their box in its frame. No sync."""
        shape, rotated = detected.fit.shape, self.in_frame(detected.fit.shape, detected.rows)
        extremes, box = find_extremes(rotated), empty(6, float32, self.device)
        launch(fold_box_kernel, 6, [extremes, box])
        angles = 2 * np.pi * np.arange(SECTOR_COUNT) / SECTOR_COUNT
        around = np.stack([np.cos(angles), np.sin(angles)], 1).astype(np.float32).ravel()
        directions, cells = upload(around, float32, self.device), zeros(SECTOR_COUNT * BAND_COUNT, int32, self.device)
        launch(mark_cells_kernel, rotated.size, [rotated, detected.kind, float(shape[6]), directions, cells])
        return extremes, box, cells

    def _split(self, middle: vec3, step: int, first: int, count: int) -> ShapePoints:
        cloud = ShapePoints()
        cloud.count = count
        for name in ("xs", "ys", "zs", "us", "vs", "ws"):
            setattr(cloud, name, empty(count, float32, self.device))
        arguments = [self.points, self.normals, self.rows, middle, step, first, cloud]
        launch(split_points_kernel, count, arguments)
        return cloud


def spread_of(kind: int, extremes: NDArray[np.int32], cells: NDArray[np.int32]) -> tuple[NDArray[np.float64], float]:
    """Box of a shape's points in its frame (low, high), and the fraction of its surface cells that contain some."""
    bounds = np.array([bound.astype(np.float64) for bound in box_of(extremes)[:2]])
    marks = cells.reshape(SECTOR_COUNT, BAND_COUNT)
    if kind == PLANE:
        return bounds, 1.0
    return bounds, float(marks.any(axis=1).mean() if kind in (CYLINDER, CONE) else marks.mean())


def _taken_apart(shape: NDArray[np.float64]) -> list:
    return [vec3d(*shape[:3]), vec3d(*shape[3:6]), vec3d(shape[6], shape[7], 0.0)]


def chance_of(fraction: float, kind: int, levels: int) -> float:
    """Probability that a sample is of one shape only (Schnabel, Wahl and Klein 2007, section 4.4): from all points, or
    from the best run length, of which half is the shape's."""
    points = SAMPLE_POINTS[kind]
    return max(fraction**points, fraction / 2 ** (points - 1)) / levels


def samples_needed(fraction: float, kind: int, levels: int, probability: float, max_samples: int) -> float:
    """Samples until one of the shape alone is drawn with the given probability."""
    hit = chance_of(fraction, kind, levels)
    if hit <= 0.0 or probability >= 1.0:
        return float(max_samples)
    return min(float(max_samples), math.log1p(-probability) / math.log1p(-min(hit, 1 - 1e-12)))
