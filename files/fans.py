"""Faces of any number of corners as triangles.

A face becomes the fan around its first corner where all triangles of that fan turn as the face does. A quad that does
not is parted along its other diagonal, a larger face by clipping ears (ears.py), so that n corners give n - 2 triangles
that do not overlap. A quad that is not flat is parted along its shorter diagonal. A face that crosses itself has no
triangles of its own; it stays a fan, with a warning.

Cost: meshes of triangles pay nothing, quads and larger faces some 70 operations a triangle, in pieces that fit into the
cache; only faces that are no fans pay more.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError
from ..core.escaped_text import escaped
from .ears import MOST_CORNERS, clip_ears

# A quad is bent where its diagonals pass each other at more than this part of the longer one: well above what seven
# digits do to flat quads, well below what one sees.
_BENT = 1e-3

# The same for areas: a triangle of less than this part of its face has none.
_NO_AREA = 1e-12

_CORNERS_AT_A_TIME = 1 << 15

Floats = NDArray[np.float64]
Places = NDArray[np.int64]
Mask = NDArray[np.bool_]


def split_faces(path: Any, lengths: Places, corners: NDArray[Any], vertices: NDArray[Any]) -> Places:
    """The triangles of faces, as places in the list of all corners, shape [t, 3]; a face of n corners has n - 2.

    Args:
        path: The file, for errors.
        lengths: Corners of each face, shape [f].
        corners: The vertex of each corner, one face after another.
        vertices: Positions, shape [m, 3].

    Raises:
        FileError: A face of fewer than three corners, with its number.

    Warns:
        UserWarning: Faces that cross themselves.
    """
    small = np.flatnonzero(lengths < 3)
    if len(small):
        row = int(small[0])
        raise FileError(path, f"a face has {lengths[row]} corners; at least 3 are needed", where=f"face {row}")
    largest = int(lengths.max(initial=3))
    if largest == 3:
        return np.arange(3 * len(lengths)).reshape(-1, 3)
    fans = _fans(lengths)
    firsts, begins = np.cumsum(lengths) - lengths, np.cumsum(lengths - 2) - (lengths - 2)
    points, crossed = _scaled(vertices), []
    for length, rows in _by_length(lengths, largest):
        at_a_time = max(1, _CORNERS_AT_A_TIME // length)
        for begin in range(0, len(rows), at_a_time):
            some = rows[begin : begin + at_a_time]
            if len(rows) == len(lengths):  # all of one length
                of_corners = corners[begin * length : (begin + len(some)) * length].reshape(-1, length)
            else:
                of_corners = corners[firsts[some][:, None] + np.arange(length)]
            p = points[of_corners].astype(np.float64, copy=False)
            changed, triangles, odd = _split_quads(p) if length == 4 else _split_polygons(p)
            crossed.append(some[odd])
            if not len(changed):
                continue
            some = some[changed]
            places = firsts[some][:, None, None] + triangles
            fans[begins[some][:, None] + np.arange(length - 2)] = places
    _tell(path, np.sort(np.concatenate(crossed)), lengths)
    return fans


def _fans(lengths: Places) -> Places:
    """The fan of each face around its first corner."""
    if (lengths == lengths[0]).all():
        length = int(lengths[0])
        begins, fans = np.arange(0, len(lengths) * length, length), np.empty((len(lengths), length - 2, 3), np.int64)
        for k in range(length - 2):
            fans[:, k, 0], fans[:, k, 1], fans[:, k, 2] = begins, begins + (k + 1), begins + (k + 2)
        return fans.reshape(-1, 3)
    fans = lengths - 2
    firsts = np.repeat(np.cumsum(lengths) - lengths, fans)
    within = np.arange(len(firsts)) - np.repeat(np.cumsum(fans) - fans, fans)
    return np.stack([firsts, firsts + within + 1, firsts + within + 2], axis=1)


def _by_length(lengths: Places, largest: int) -> list[tuple[int, Places]]:
    if (lengths == largest).all():
        return [(largest, np.arange(len(lengths)))]
    order = np.argsort(lengths, kind="stable")
    ordered = lengths[order]
    cuts = np.flatnonzero(np.diff(ordered)) + 1
    return [(int(lengths[rows[0]]), rows) for rows in np.split(order, cuts) if lengths[rows[0]] > 3]


def _scaled(vertices: NDArray[Any]) -> NDArray[Any]:
    """The vertices, by a power of 2 where they are so far out or so close that products of four would leave float64."""
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
def _split_quads(p: Floats) -> tuple[Places, Places, Mask]:
    """Which of the quads [q, 4, 3] are parted from corner 1 to 3, the triangles for those, and which cross themselves.

    With the diagonals d and e, the normal n = d x e and s = p1 - p0, the fan's triangles have along n the parts
    (s x d) n and n n less that, those along the other diagonal (s x e) n and n n less that.
    """
    xyz = np.ascontiguousarray(p.transpose(1, 2, 0))
    d, e, s = (list(xyz[k] - xyz[j]) for k, j in ((2, 0), (3, 1), (1, 0)))
    n = _cross(d, e)
    nn = _dot(n, n)
    fan, other = _dot(_cross(s, d), n), _dot(_cross(s, e), n)
    dd, ee, none = _dot(d, d), _dot(e, e), _NO_AREA * nn
    is_fan, is_other = ((part > none) & (nn - part > none) for part in (fan, other))
    bent = _dot(s, n) ** 2 > _BENT**2 * nn * np.maximum(dd, ee)
    swapped = is_other & (~is_fan | (bent & (ee < dd)))
    crossed = np.zeros(len(p), bool)
    rest = np.flatnonzero(~is_fan & ~is_other)
    if len(rest):
        rest = rest[np.isfinite(p[rest]).all(axis=(1, 2))]
        weak = [(part[rest] >= -none[rest]) & (nn - part >= -none)[rest] for part in (fan, other)]
        flat = nn[rest] <= (_NO_AREA * dd * ee)[rest]  # no normal: on one line, or two triangles that cancel out
        wide = _dot(*[[side[rest] for side in _cross(s, d)]] * 2) > (_NO_AREA * _dot(s, s) * dd)[rest]
        swapped[rest] = weak[1] & ~weak[0] & ~flat
        crossed[rest] = np.where(flat, wide, ~weak[0] & ~weak[1])
    rows = np.flatnonzero(swapped)
    return rows, np.broadcast_to([[0, 1, 3], [1, 2, 3]], (len(rows), 2, 3)), crossed


@np.errstate(all="ignore")
def _split_polygons(p: Floats) -> tuple[Places, Places, Mask]:
    """Which of the polygons [q, n, 3] are no fans but have triangles, those, and which cross themselves."""
    arms = np.ascontiguousarray((p[:, 1:] - p[:, :1]).transpose(2, 0, 1))
    sides = _cross([*arms[:, :, :-1]], [*arms[:, :, 1:]])
    n = [side.sum(axis=1) for side in sides]
    nn = _dot(n, n)
    turned = _dot(sides, [side[:, None] for side in n]) > _NO_AREA * nn[:, None]
    rest = np.flatnonzero(~turned.all(axis=1) | _goes_round(arms, n))
    rest = rest[np.isfinite(p[rest]).all(axis=(1, 2))]
    crossed = np.zeros(len(p), bool)
    if not len(rest):
        return rest, np.empty((0, p.shape[1] - 2, 3), np.int64), crossed
    x, y, area = _flattened(p[rest], np.stack(n)[:, rest])
    widest = np.sqrt(_dot(sides, sides)[rest].max(axis=1))
    is_thin = area <= _NO_AREA * widest  # no normal: on one line, or parts that cancel out
    triangles, good = clip_ears(x[~is_thin], y[~is_thin])
    reach = (p[rest].max(axis=1) - p[rest].min(axis=1)).max(axis=1)
    crossed[rest] = is_thin & (widest > _NO_AREA * reach**2)
    crossed[rest[~is_thin][~good]] = True
    return rest[~is_thin][good], triangles[good], crossed


def _goes_round(arms: Floats, n: list[Floats]) -> Mask:
    """Whether the arms [3, q, n - 1] from the first corner to the others turn by more than once about it."""
    first = [arm[:, :1] for arm in arms]
    side = _dot(_cross(first, [*arms]), [part[:, None] for part in n])
    return np.asarray(((side[:, 1:-1] < 0) & (side[:, 2:] >= 0)).any(axis=1))


def _flattened(p: Floats, n: Floats) -> tuple[Floats, Floats, Floats]:
    """The polygons along the axis that their normal [3, q] is nearest to, counterclockwise, and that part of it."""
    axis = np.abs(n).argmax(axis=0)
    rows = np.arange(len(p))
    part = n[axis, rows]
    u, v = (axis + 1) % 3, (axis + 2) % 3
    u, v = np.where(part > 0, u, v), np.where(part > 0, v, u)
    return p[rows, :, u], p[rows, :, v], np.abs(part)


def _tell(path: Any, crossed: Places, lengths: Places) -> None:
    if not len(crossed):
        return
    many = f"{len(crossed)} faces cross themselves, the first" if len(crossed) > 1 else "a face crosses itself:"
    large = f" (or have more than {MOST_CORNERS} corners)" if lengths[crossed].max() > MOST_CORNERS else ""
    message = f"{path}: {many} face {crossed[0]}{large}; such are fans, whose triangles overlap"
    warnings.warn(escaped(message), UserWarning, stacklevel=5)
