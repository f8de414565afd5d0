"""Simple polygons as triangles by clipping ears, many polygons of one size at a time.

An ear is a corner whose triangle with its two neighbours holds no other corner. Clipping one leaves a polygon of one
corner less, so that n corners give n - 2 triangles. As the triangles add up to the polygon, none overlap where all turn
as it does: that is held at the end, not assumed. Corners on an edge, repeated ones and edges that are walked both ways
(to a hole and back) are taken; a corner without area is clipped only where nothing else is left.

Each step tests one corner of each polygon against its corners that turn inwards: n corners take some 2 n steps of n
tests. Deterministic.

Source: Meisters, "Polygons Have Ears" (1975); Held, "FIST" (2001), for what to do where no ear is left.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# Corners that a polygon may have: the work grows with the square of them, and 10,000 take some five seconds.
MOST_CORNERS = 10_000

# Polygons of more corners are not looked through for crossings one edge against each; their triangles tell most.
_MOST_CROSSED = 2_048

_PAIRS_AT_A_TIME = 1 << 21
_NUMBERS_AT_A_TIME = 1 << 18

# What turns by less than this part of the products that it is the difference of does not turn.
_STRAIGHT = 1e-12

# How the search for an ear gives way: no corner in or on its triangle, none in it, no area needed, nothing asked.
_OPEN, _FLAT, _ANY = 1, 2, 3

# Steps a corner until a polygon is given up, and a large one, so that one that crosses itself ends too; most take two.
_MOST_STEPS = 12
_MOST_STEPS_OF_LARGE = 4

Floats = NDArray[np.float64]
Places = NDArray[np.int64]


def clip_ears(x: Floats, y: Floats) -> tuple[Places, NDArray[np.bool_]]:
    """Triangles of polygons with n corners each, given counterclockwise.

    Args:
        x: Coordinates of the corners, shape [p, n].
        y: The same.

    Returns:
        The triangles as places in the polygon, shape [p, n - 2, 3], each turned as the polygon, and which polygons have
        such; those of the others, which cross themselves, mean nothing.
    """
    count, n = x.shape
    triangles, good = np.zeros((count, n - 2, 3), np.int64), np.zeros(count, bool)
    if n > MOST_CORNERS:
        return triangles, good
    at_a_time = max(1, _NUMBERS_AT_A_TIME // n)
    for begin in range(0, count, at_a_time):
        part = slice(begin, begin + at_a_time)
        todo = np.arange(begin, min(begin + at_a_time, count))
        todo = todo[~_cross_themselves(x[part], y[part]) & ~_wind_twice(x[part], y[part])]
        for start in (
            (0,) if n > _MOST_CROSSED else {0: 0, n // 3: 0, 2 * n // 3: 0}
        ):  # where one order of clipping is stuck, another may go on
            if not len(todo):
                break
            triangles[todo], good[todo] = _Clipping(x[todo], y[todo], start).run()
            done = todo[good[todo]]
            good[done] = ~_overlap(x[done], y[done], triangles[done])
            todo = todo[~good[todo]]
    return triangles, good


def _turn(ax: Floats, ay: Floats, bx: Floats, by: Floats, cx: Floats, cy: Floats) -> Floats:
    """Twice the area of a, b, c, above 0 where they turn to the left; exactly 0 where rounding may decide."""
    left, right = (bx - ax) * (cy - ay), (by - ay) * (cx - ax)
    area = left - right
    return np.where(np.abs(area) <= _STRAIGHT * (np.abs(left) + np.abs(right)), 0.0, area)


def _cross_themselves(x: Floats, y: Floats) -> NDArray[np.bool_]:
    """Which polygons have two edges that cross at a point inside both, shape [p]."""
    count, n = x.shape
    crossed = np.zeros(count, bool)
    if n > _MOST_CROSSED:
        return crossed
    ends_x, ends_y = np.roll(x, -1, 1), np.roll(y, -1, 1)
    at_a_time = max(1, _PAIRS_AT_A_TIME // (n * n))
    for begin in range(0, count, at_a_time):
        part = slice(begin, begin + at_a_time)
        ax, ay, bx, by = (values[part, :, None] for values in (x, y, ends_x, ends_y))
        cx, cy, dx, dy = (values[part, None, :] for values in (x, y, ends_x, ends_y))
        apart = _turn(ax, ay, bx, by, cx, cy) * _turn(ax, ay, bx, by, dx, dy) < 0
        crossed[part] = (apart & apart.transpose(0, 2, 1)).any(axis=(1, 2))
    return crossed


def _wind_twice(x: Floats, y: Floats) -> NDArray[np.bool_]:
    """Which polygons turn by more or less than once about themselves, shape [p]; those with repeated corners pass.

    Such cross themselves, at corners if not at edges. The tip of a spike may turn either way.
    """
    along_x, along_y = np.roll(x, -1, 1) - x, np.roll(y, -1, 1) - y
    next_x, next_y = np.roll(along_x, -1, 1), np.roll(along_y, -1, 1)
    zero = np.zeros_like(x)
    turns = np.arctan2(_turn(zero, zero, along_x, along_y, next_x, next_y), along_x * next_x + along_y * next_y)
    is_tip = np.abs(turns) == np.pi
    total = np.where(is_tip, 0.0, turns).sum(axis=1) / np.pi
    repeated = ((along_x == 0) & (along_y == 0)).any(axis=1)
    return ~repeated & (np.abs(total - 2) > is_tip.sum(axis=1) + 0.5)


def _overlap(x: Floats, y: Floats, triangles: Places) -> NDArray[np.bool_]:
    """Which polygons have a triangle whose middle lies in another one, shape [p]: they cross themselves at corners."""
    count, n = x.shape
    found = np.zeros(count, bool)
    if n > _MOST_CROSSED:
        return found
    at_a_time = max(1, _PAIRS_AT_A_TIME // (n * n))
    for begin in range(0, count, at_a_time):
        part = slice(begin, begin + at_a_time)
        rows = np.arange(count)[part, None, None]
        cx, cy = x[rows, triangles[part]], y[rows, triangles[part]]  # [p, t, 3]
        px, py = cx.mean(axis=2)[:, None, :], cy.mean(axis=2)[:, None, :]
        inside = np.ones((len(cx), n - 2, n - 2), bool)
        for j, k in ((0, 1), (1, 2), (2, 0)):
            inside &= _turn(cx[:, :, j, None], cy[:, :, j, None], cx[:, :, k, None], cy[:, :, k, None], px, py) > 0
        inside[:, np.arange(n - 2), np.arange(n - 2)] = False
        found[part] = inside.any(axis=(1, 2))
    return found


class _Clipping:
    """Polygons that are clipped in step, each until it is a triangle or given up.

    Args:
        x: Coordinates, shape [p, n].
        y: The same.
        start: The corner at which the search begins.
    """

    def __init__(self, x: Floats, y: Floats, start: int):
        count, n = x.shape
        self.x, self.y = x, y
        self.after = np.tile(np.roll(np.arange(n), -1), (count, 1))
        self.before = np.tile(np.roll(np.arange(n), 1), (count, 1))
        here = np.full(count, start)
        self.at, self.left, self.failed = here, np.full(count, n), np.zeros(count, np.int64)
        self.way = np.zeros(count, np.int64)
        self.inward = _turn(np.roll(x, 1, 1), np.roll(y, 1, 1), x, y, np.roll(x, -1, 1), np.roll(y, -1, 1)) <= 0
        self.triangles = np.zeros((count, n - 2, 3), np.int64)
        self.good = np.ones(count, bool)

    def run(self) -> tuple[Places, NDArray[np.bool_]]:
        n = self.x.shape[1]
        rows, steps = np.arange(len(self.x)), 0
        while len(rows):
            steps += 1
            if steps > n * (_MOST_STEPS if n <= _MOST_CROSSED else _MOST_STEPS_OF_LARGE):
                self.good[rows] = False
                break
            rows = self._step(rows)
        return self.triangles, self.good

    def _step(self, rows: Places) -> Places:
        """Try the corner of each polygon that is next; the polygons that are not done."""
        b = self.at[rows]
        a, c = self.before[rows, b], self.after[rows, b]
        area = self._turn_at(rows, a, b, c)
        way, left = self.way[rows], self.left[rows]
        ear = (area > 0) | ((area == 0) & ((way >= _FLAT) | self._turns_back(rows, a, b, c)))
        asked = np.flatnonzero(ear & (area > 0) & (way < _ANY) & (left > 3))
        ear[asked] &= ~self._is_filled(rows[asked], a[asked], b[asked], c[asked], way[asked])
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
        self.good[stuck[self.way[stuck] > _ANY]] = False
        return rows[~last & self.good[rows]]

    def _turn_at(self, rows: Places, a: Places, b: Places, c: Places) -> Floats:
        x, y = self.x, self.y
        return _turn(x[rows, a], y[rows, a], x[rows, b], y[rows, b], x[rows, c], y[rows, c])

    def _turns_back(self, rows: Places, a: Places, b: Places, c: Places) -> NDArray[np.bool_]:
        """Whether corners without area are repeated, or tips of spikes: their triangles have none whatever is done."""
        x, y = self.x, self.y
        at_x, at_y = x[rows, b], y[rows, b]
        return (x[rows, a] - at_x) * (x[rows, c] - at_x) + (y[rows, a] - at_y) * (y[rows, c] - at_y) >= 0

    def _is_filled(self, rows: Places, a: Places, b: Places, c: Places, way: Places) -> NDArray[np.bool_]:
        """Whether a corner that turns inwards lies in the triangle, or on it where `way` asks for that too."""
        x, y, inward = self.x[rows], self.y[rows], self.inward[rows]
        if len(rows) == 1:  # one large polygon: those corners alone
            kept = np.flatnonzero(inward[0])
            x, y, inward = x[:, kept], y[:, kept], inward[:, kept]
        ax, bx, cx = (self.x[rows, k][:, None] for k in (a, b, c))
        ay, by, cy = (self.y[rows, k][:, None] for k in (a, b, c))
        sides = [_turn(ax, ay, bx, by, x, y), _turn(bx, by, cx, cy, x, y), _turn(cx, cy, ax, ay, x, y)]
        least = np.minimum(np.minimum(sides[0], sides[1]), sides[2])
        same = ((x == ax) & (y == ay)) | ((x == bx) & (y == by)) | ((x == cx) & (y == cy))
        held = (least > 0) | ((least == 0) & (way == 0)[:, None] & ~same)
        return (held & inward).any(axis=1)

    def _clip(self, rows: Places, a: Places, b: Places, c: Places) -> None:
        number = self.x.shape[1] - self.left[rows]
        self.triangles[rows, number] = np.stack([a, b, c], axis=1)
        self.after[rows, a], self.before[rows, c] = c, a
        self.inward[rows, b] = False
        self.left[rows] -= 1
        self.failed[rows] = self.way[rows] = 0
        self.at[rows] = self.after[rows, c]  # not the neighbour: its triangle would be a sliver beside this one
        for k in (a, c):
            turns = self._turn_at(rows, self.before[rows, k], k, self.after[rows, k])
            self.inward[rows, k] &= turns <= 0
