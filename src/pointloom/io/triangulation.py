"""Triangulate polygonal faces.

A face becomes a fan around its first corner if all triangles have its orientation. Otherwise a quad is split along its
other diagonal (nonplanar quads: the shorter one), a larger face by ear clipping, in lockstep for many polygons and
deterministic. Self-intersecting faces stay fans, with a warning. Meisters, "Polygons have ears" (1975). M. Held,
"FIST" (2001).
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.errors import CLOUD_REMEDY, FileError, FilePath
from ..core.escaped_text import escaped

# Maximum corners of a polygon: the cost is quadratic, and 10,000 take about 5 s.
MAX_CORNERS = 10_000

# Polygons with more corners skip the pairwise edge test. Their triangles reveal most intersections.
_MAX_CROSSED = 2_048

_PAIRS_AT_A_TIME = 1 << 21
_NUMBERS_AT_A_TIME = 1 << 18

# Turns below this fraction of the products that they are differences of count as zero (rounding).
_MAX_ROUNDING_TURN = 1e-12

# Relaxation levels of an ear: 0 no corner in or on its triangle, 1 none inside, 2 zero area accepted, 3 no condition.
_FLAT_MODE, _ANY_MODE = 2, 3

# Steps per corner until a polygon is abandoned, so that self-intersecting ones terminate. Most take two.
_MAX_STEPS = 12
_MAX_STEPS_OF_LARGE = 4

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


def clip_ears(x: Floats, y: Floats) -> tuple[Indices, NDArray[np.bool_]]:
    """Triangulate counterclockwise polygons, coordinates (p, n).
    Returns corner indices (p, n - 2, 3) and a mask. Triangles of self-intersecting polygons are invalid."""
    count, n = x.shape
    triangles, good = np.zeros((count, n - 2, 3), np.int64), np.zeros(count, bool)
    if n > MAX_CORNERS:
        return triangles, good
    at_a_time = max(1, _NUMBERS_AT_A_TIME // n)
    for begin in range(0, count, at_a_time):
        part = slice(begin, begin + at_a_time)
        todo = np.arange(begin, min(begin + at_a_time, count))
        todo = todo[~_cross_themselves(x[part], y[part]) & ~_wind_twice(x[part], y[part])]
        for start in (
            (0,) if n > _MAX_CROSSED else {0: 0, n // 3: 0, 2 * n // 3: 0}
        ):  # another clipping order may succeed
            if not len(todo):
                break
            triangles[todo], good[todo] = _Clipping(x[todo], y[todo], start).run()
            done = todo[good[todo]]
            good[done] = ~_overlap(x[done], y[done], triangles[done])
            todo = todo[~good[todo]]
    return triangles, good


def _doubled_area(ax: Floats, ay: Floats, bx: Floats, by: Floats, cx: Floats, cy: Floats) -> Floats:
    """Twice the signed area of a, b, c, > 0 for a left turn; exactly 0 within rounding."""
    left, right = (bx - ax) * (cy - ay), (by - ay) * (cx - ax)
    area = left - right
    return np.where(np.abs(area) <= _MAX_ROUNDING_TURN * (np.abs(left) + np.abs(right)), 0.0, area)


def _cross_themselves(x: Floats, y: Floats) -> NDArray[np.bool_]:
    """Mask (p,) of polygons with two edges that cross in their interiors."""
    count, n = x.shape
    crossed = np.zeros(count, bool)
    if n > _MAX_CROSSED:
        return crossed
    ends_x, ends_y = np.roll(x, -1, 1), np.roll(y, -1, 1)
    at_a_time = max(1, _PAIRS_AT_A_TIME // (n * n))
    for begin in range(0, count, at_a_time):
        part = slice(begin, begin + at_a_time)
        ax, ay, bx, by = (values[part, :, None] for values in (x, y, ends_x, ends_y))
        cx, cy, dx, dy = (values[part, None, :] for values in (x, y, ends_x, ends_y))
        apart = _doubled_area(ax, ay, bx, by, cx, cy) * _doubled_area(ax, ay, bx, by, dx, dy) < 0
        crossed[part] = (apart & apart.transpose(0, 2, 1)).any(axis=(1, 2))
    return crossed


def _wind_twice(x: Floats, y: Floats) -> NDArray[np.bool_]:
    """Mask (p,) of polygons without duplicate corners whose turning number is not 1. They intersect themselves."""
    along_x, along_y = np.roll(x, -1, 1) - x, np.roll(y, -1, 1) - y
    next_x, next_y = np.roll(along_x, -1, 1), np.roll(along_y, -1, 1)
    zero = np.zeros_like(x)
    angles = np.arctan2(
        _doubled_area(zero, zero, along_x, along_y, next_x, next_y), along_x * next_x + along_y * next_y
    )
    is_tip = np.abs(angles) == np.pi
    total = np.where(is_tip, 0.0, angles).sum(axis=1) / np.pi
    repeated = ((along_x == 0) & (along_y == 0)).any(axis=1)
    return ~repeated & (np.abs(total - 2) > is_tip.sum(axis=1) + 0.5)


def _overlap(x: Floats, y: Floats, triangles: Indices) -> NDArray[np.bool_]:
    """Mask (p,) of polygons with a triangle whose centroid is inside another one."""
    count, n = x.shape
    overlaps = np.zeros(count, bool)
    if n > _MAX_CROSSED:
        return overlaps
    at_a_time = max(1, _PAIRS_AT_A_TIME // (n * n))
    for begin in range(0, count, at_a_time):
        part = slice(begin, begin + at_a_time)
        rows = np.arange(count)[part, None, None]
        cx, cy = x[rows, triangles[part]], y[rows, triangles[part]]  # [p, t, 3]
        px, py = cx.mean(axis=2)[:, None, :], cy.mean(axis=2)[:, None, :]
        inside = np.ones((len(cx), n - 2, n - 2), bool)
        for j, k in ((0, 1), (1, 2), (2, 0)):
            inside &= (
                _doubled_area(cx[:, :, j, None], cy[:, :, j, None], cx[:, :, k, None], cy[:, :, k, None], px, py) > 0
            )
        inside[:, np.arange(n - 2), np.arange(n - 2)] = False
        overlaps[part] = inside.any(axis=(1, 2))
    return overlaps


class _Clipping:
    """Ear clipping of polygons (p, n) in lockstep. The search begins at corner `start`."""

    def __init__(self, x: Floats, y: Floats, start: int):
        count, n = x.shape
        self.x, self.y = x, y
        self.after = np.tile(np.roll(np.arange(n), -1), (count, 1))
        self.before = np.tile(np.roll(np.arange(n), 1), (count, 1))
        here = np.full(count, start)
        self.at, self.left, self.failed = here, np.full(count, n), np.zeros(count, np.int64)
        self.way = np.zeros(count, np.int64)
        self.inward = _doubled_area(np.roll(x, 1, 1), np.roll(y, 1, 1), x, y, np.roll(x, -1, 1), np.roll(y, -1, 1)) <= 0
        self.triangles = np.zeros((count, n - 2, 3), np.int64)
        self.good = np.ones(count, bool)

    def run(self) -> tuple[Indices, NDArray[np.bool_]]:
        n = self.x.shape[1]
        rows, steps = np.arange(len(self.x)), 0
        while len(rows):
            steps += 1
            if steps > n * (_MAX_STEPS if n <= _MAX_CROSSED else _MAX_STEPS_OF_LARGE):
                self.good[rows] = False
                break
            rows = self._step(rows)
        return self.triangles, self.good

    def _step(self, rows: Indices) -> Indices:
        """Test the next corner of each polygon. Returns the unfinished polygons."""
        b = self.at[rows]
        a, c = self.before[rows, b], self.after[rows, b]
        area = self._area_at(rows, a, b, c)
        mode, left = self.way[rows], self.left[rows]
        ear = (area > 0) | ((area == 0) & ((mode >= _FLAT_MODE) | self._is_degenerate(rows, a, b, c)))
        candidates = np.flatnonzero(ear & (area > 0) & (mode < _ANY_MODE) & (left > 3))
        ear[candidates] &= ~self._is_filled(
            rows[candidates], a[candidates], b[candidates], c[candidates], mode[candidates]
        )
        last = left == 3
        ear |= last
        self._clip(rows[ear], a[ear], b[ear], c[ear])
        self.good[rows[last & (area < 0)]] = False
        missed = rows[~ear]
        self.at[missed] = c[~ear]
        self.failed[missed] += 1
        stuck = missed[self.failed[missed] > self.left[missed]]
        self.failed[stuck] = 0
        self.way[stuck] += 1
        self.good[stuck[self.way[stuck] > _ANY_MODE]] = False
        return rows[~last & self.good[rows]]

    def _area_at(self, rows: Indices, a: Indices, b: Indices, c: Indices) -> Floats:
        x, y = self.x, self.y
        return _doubled_area(x[rows, a], y[rows, a], x[rows, b], y[rows, b], x[rows, c], y[rows, c])

    def _is_degenerate(self, rows: Indices, a: Indices, b: Indices, c: Indices) -> NDArray[np.bool_]:
        """True for zero-area corners that are duplicates or tips of spikes, which have no area in any triangulation."""
        x, y = self.x, self.y
        at_x, at_y = x[rows, b], y[rows, b]
        return (x[rows, a] - at_x) * (x[rows, c] - at_x) + (y[rows, a] - at_y) * (y[rows, c] - at_y) >= 0

    def _is_filled(self, rows: Indices, a: Indices, b: Indices, c: Indices, mode: Indices) -> NDArray[np.bool_]:
        """True if a reflex corner is inside the triangle, or on its boundary if `mode` includes it."""
        x, y, inward = self.x[rows], self.y[rows], self.inward[rows]
        if len(rows) == 1:  # one large polygon: only those corners
            reflex = np.flatnonzero(inward[0])
            x, y, inward = x[:, reflex], y[:, reflex], inward[:, reflex]
        ax, bx, cx = (self.x[rows, k][:, None] for k in (a, b, c))
        ay, by, cy = (self.y[rows, k][:, None] for k in (a, b, c))
        sides = [
            _doubled_area(ax, ay, bx, by, x, y),
            _doubled_area(bx, by, cx, cy, x, y),
            _doubled_area(cx, cy, ax, ay, x, y),
        ]
        min_side = np.minimum(np.minimum(sides[0], sides[1]), sides[2])
        same = ((x == ax) & (y == ay)) | ((x == bx) & (y == by)) | ((x == cx) & (y == cy))
        is_inside = (min_side > 0) | ((min_side == 0) & (mode == 0)[:, None] & ~same)
        return (is_inside & inward).any(axis=1)

    def _clip(self, rows: Indices, a: Indices, b: Indices, c: Indices) -> None:
        number = self.x.shape[1] - self.left[rows]
        self.triangles[rows, number] = np.stack([a, b, c], axis=1)
        self.after[rows, a], self.before[rows, c] = c, a
        self.inward[rows, b] = False
        self.left[rows] -= 1
        self.failed[rows] = self.way[rows] = 0
        self.at[rows] = self.after[rows, c]  # not the neighbor: its triangle would be a sliver beside this one
        for k in (a, c):
            areas = self._area_at(rows, self.before[rows, k], k, self.after[rows, k])
            self.inward[rows, k] &= areas <= 0


# A quad is nonplanar if its diagonals miss each other by more than this fraction of the longer one: above the
# rounding of seven digits, below what is visible.
_MIN_NONPLANARITY = 1e-3

# Triangles below this fraction of their face's area count as degenerate.
_NO_AREA = 1e-12

_CORNERS_AT_A_TIME = 1 << 15

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]


def split_faces(path: FilePath, lengths: Indices, corners: NDArray[Any], vertices: NDArray[Any]) -> Indices:
    """Triangles as indices into all corners, shape (t, 3). Warns of self-intersecting faces, and of those with fewer
    than 3 corners, which are skipped. Raises `FileError` if no face has 3."""
    warn_of_small(path, lengths, stacklevel=4)
    largest = int(lengths.max(initial=3))
    if largest == 3 and (lengths == 3).all():
        return np.arange(3 * len(lengths)).reshape(-1, 3)
    fans = _fans(lengths)
    counts = triangle_counts(lengths)
    firsts, begins = np.cumsum(lengths) - lengths, np.cumsum(counts) - counts
    points, crossed = _scaled(vertices), [np.empty(0, np.int64)]
    for length, rows in _by_length(lengths, largest):
        at_a_time = max(1, _CORNERS_AT_A_TIME // length)
        for begin in range(0, len(rows), at_a_time):
            some = rows[begin : begin + at_a_time]
            if len(rows) == len(lengths):  # equal lengths
                of_corners = corners[begin * length : (begin + len(some)) * length].reshape(-1, length)
            else:
                of_corners = corners[firsts[some][:, None] + np.arange(length)]
            p = points[of_corners].astype(np.float64, copy=False)
            changed, triangles, odd = _split_quads(p) if length == 4 else _split_polygons(p)
            crossed.append(some[odd])
            if not len(changed):
                continue
            some = some[changed]
            corner_indices = firsts[some][:, None, None] + triangles
            fans[begins[some][:, None] + np.arange(length - 2)] = corner_indices
    _warn_of_crossed(path, np.sort(np.concatenate(crossed)), lengths)
    return fans


def triangle_counts(lengths: Indices) -> Indices:
    """Number of triangles of each face: none below 3 corners."""
    return np.maximum(lengths - 2, 0)


def warn_of_small(path: FilePath, lengths: Indices, *, stacklevel: int = 3) -> None:
    """Warn of faces with fewer than 3 corners, which are skipped. Raises `FileError` if all have fewer."""
    small = np.flatnonzero(lengths < 3)
    if not len(small):
        return
    if len(small) == len(lengths):
        reason = f"contains no faces: all {len(small)} have fewer than 3 corners"
        raise FileError(path, reason, remedy=CLOUD_REMEDY)
    message = f"{path}: {len(small)} of {len(lengths)} faces are skipped, as they have fewer than 3 corners, the first"
    warnings.warn(escaped(f"{message} face {small[0]}"), UserWarning, stacklevel=stacklevel + 1)


def _fans(lengths: Indices) -> Indices:
    if (lengths == lengths[0]).all():
        length = int(lengths[0])
        begins, fans = np.arange(0, len(lengths) * length, length), np.empty((len(lengths), length - 2, 3), np.int64)
        for k in range(length - 2):
            fans[:, k, 0], fans[:, k, 1], fans[:, k, 2] = begins, begins + (k + 1), begins + (k + 2)
        return fans.reshape(-1, 3)
    fans = triangle_counts(lengths)
    firsts = np.repeat(np.cumsum(lengths) - lengths, fans)
    within = np.arange(len(firsts)) - np.repeat(np.cumsum(fans) - fans, fans)
    return np.stack([firsts, firsts + within + 1, firsts + within + 2], axis=1)


def _by_length(lengths: Indices, largest: int) -> list[tuple[int, Indices]]:
    if (lengths == largest).all():
        return [(largest, np.arange(len(lengths)))]
    order = np.argsort(lengths, kind="stable")
    ordered = lengths[order]
    cuts = np.flatnonzero(np.diff(ordered)) + 1
    return [(int(lengths[rows[0]]), rows) for rows in np.split(order, cuts) if lengths[rows[0]] > 3]


def _scaled(vertices: NDArray[Any]) -> NDArray[Any]:
    """Vertices scaled by a power of 2 so that products of four stay within float64."""
    if vertices.dtype == np.float32:
        return vertices
    with np.errstate(invalid="ignore"):
        largest = np.abs(vertices).max(initial=0.0, where=np.isfinite(vertices))
    return vertices if 1e-30 < largest < 1e60 or largest == 0 else np.ldexp(vertices, -int(np.frexp(largest)[1]))


def _cross(a: list[Floats], b: list[Floats]) -> list[Floats]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _dot(a: list[Floats], b: list[Floats]) -> Floats:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@np.errstate(all="ignore")
def _split_quads(p: Floats) -> tuple[Indices, Indices, Mask]:
    """Quads (q, 4, 3) to split from corner 1 to 3, their triangles, and a mask of self-intersecting ones.
    With diagonals d, e, normal n = d x e and s = p1 - p0, the areas along n are (s x d) n and n n - (s x d) n for the
    fan, and (s x e) n and n n - (s x e) n for the other split."""
    xyz = np.ascontiguousarray(p.transpose(1, 2, 0))
    d, e, s = (list(xyz[k] - xyz[j]) for k, j in ((2, 0), (3, 1), (1, 0)))
    n = _cross(d, e)
    nn = _dot(n, n)
    fan, other = _dot(_cross(s, d), n), _dot(_cross(s, e), n)
    dd, ee, none = _dot(d, d), _dot(e, e), _NO_AREA * nn
    is_fan, is_other = ((part > none) & (nn - part > none) for part in (fan, other))
    is_bent = _dot(s, n) ** 2 > _MIN_NONPLANARITY**2 * nn * np.maximum(dd, ee)
    swapped = is_other & (~is_fan | (is_bent & (ee < dd)))
    crossed = np.zeros(len(p), bool)
    rest = np.flatnonzero(~is_fan & ~is_other)
    if len(rest):
        rest = rest[np.isfinite(p[rest]).all(axis=(1, 2))]
        weak = [(part[rest] >= -none[rest]) & (nn - part >= -none)[rest] for part in (fan, other)]
        flat = nn[rest] <= (_NO_AREA * dd * ee)[rest]  # no normal: collinear, or two triangles that cancel
        wide = _dot(*[[side[rest] for side in _cross(s, d)]] * 2) > (_NO_AREA * _dot(s, s) * dd)[rest]
        swapped[rest] = weak[1] & ~weak[0] & ~flat
        crossed[rest] = np.where(flat, wide, ~weak[0] & ~weak[1])
    rows = np.flatnonzero(swapped)
    return rows, np.broadcast_to([[0, 1, 3], [1, 2, 3]], (len(rows), 2, 3)), crossed


@np.errstate(all="ignore")
def _split_polygons(p: Floats) -> tuple[Indices, Indices, Mask]:
    """Polygons (q, n, 3) that need ear clipping, their triangles, and a mask of self-intersecting ones."""
    arms = np.ascontiguousarray((p[:, 1:] - p[:, :1]).transpose(2, 0, 1))
    sides = _cross([*arms[:, :, :-1]], [*arms[:, :, 1:]])
    n = [side.sum(axis=1) for side in sides]
    nn = _dot(n, n)
    is_convex = _dot(sides, [side[:, None] for side in n]) > _NO_AREA * nn[:, None]
    rest = np.flatnonzero(~is_convex.all(axis=1) | _goes_round(arms, n))
    rest = rest[np.isfinite(p[rest]).all(axis=(1, 2))]
    crossed = np.zeros(len(p), bool)
    if not len(rest):
        return rest, np.empty((0, p.shape[1] - 2, 3), np.int64), crossed
    x, y, area = _flattened(p[rest], np.stack(n)[:, rest])
    widest = np.sqrt(_dot(sides, sides)[rest].max(axis=1))
    is_thin = area <= _NO_AREA * widest  # no normal: collinear, or parts that cancel
    triangles, good = clip_ears(x[~is_thin], y[~is_thin])
    extent = (p[rest].max(axis=1) - p[rest].min(axis=1)).max(axis=1)
    crossed[rest] = is_thin & (widest > _NO_AREA * extent**2)
    crossed[rest[~is_thin][~good]] = True
    return rest[~is_thin][good], triangles[good], crossed


def _goes_round(arms: Floats, n: list[Floats]) -> Mask:
    """True if the arms (3, q, n - 1) from the first corner turn more than once around it."""
    first = [arm[:, :1] for arm in arms]
    side = _dot(_cross(first, [*arms]), [part[:, None] for part in n])
    return np.asarray(((side[:, 1:-1] < 0) & (side[:, 2:] >= 0)).any(axis=1))


def _flattened(p: Floats, n: Floats) -> tuple[Floats, Floats, Floats]:
    """Project polygons along the axis nearest to their normal (3, q), counterclockwise, with that normal component."""
    axis = np.abs(n).argmax(axis=0)
    rows = np.arange(len(p))
    part = n[axis, rows]
    u, v = (axis + 1) % 3, (axis + 2) % 3
    u, v = np.where(part > 0, u, v), np.where(part > 0, v, u)
    return p[rows, :, u], p[rows, :, v], np.abs(part)


def _warn_of_crossed(path: FilePath, crossed: Indices, lengths: Indices) -> None:
    if not len(crossed):
        return
    many = f"{len(crossed)} faces cross themselves, the first" if len(crossed) > 1 else "a face crosses itself:"
    large = f" (or have more than {MAX_CORNERS} corners)" if lengths[crossed].max() > MAX_CORNERS else ""
    message = f"{path}: {many} face {crossed[0]}{large}; they are triangulated as fans with overlapping triangles"
    warnings.warn(escaped(message), UserWarning, stacklevel=5)
