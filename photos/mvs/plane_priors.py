"""Planes for plain places: fitted to the sure depth in and around each of them.

Sums and products of NumPy alone, no BLAS: that rounds differently from machine to machine and by its threads.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
Window = tuple[slice, slice]
Plane = tuple[Any, Any, Any]  # inverse depth at pixel 0, 0, and its slopes across and down
LEAST_AREA = 64  # [px] of a place that is worth a plane
AROUND = 3  # [px] beyond a plain place whose sure depth counts: farther off other things begin
LEAST_SUPPORT = 20  # sure pixels that lie on a plane
LEAST_SHARE = 0.35  # of all that are sure there: less, and scattered errors make planes of their own
LEAST_SPREAD = 3.0  # [px] of them across their longest direction: a line has many planes
MOST_PLANES = 3  # of a place: walls and ceilings of one colour
TOLERANCE = 0.5  # [px in the sources] beside a plane
TRIALS = 100
REFITS = 2
LEAST_TRIANGLE = 50.0  # [px^2] twice the area of three pixels that say how a plane leans
MOST_TRIED = 600  # sure pixels that trials are counted on


def fit_priors(plain: Array, sure: Array, planes: Array, pixels_per: float, seed: int) -> Array:
    """The plane of each plain pixel and how much it weighs, or 0.

    Args:
        plain: How plain pixels are, 0 to 1, shape [h, w].
        sure: Where the depth is, bool [h, w].
        planes: Hypotheses, [h, w, 4].
        pixels_per: How far pixels move in the sources for an inverse depth of one [px].
        seed: Chooses the pixels that planes are tried through.

    Returns:
        Inverse depth, its two slopes, the weight: float32 [h, w, 4].
    """
    from scipy import ndimage  # loads for longer than the planes of a picture without plain places take

    out = np.zeros(planes.shape, np.float32)
    found: Any = ndimage.label(plain > 0)
    places: Array = found[0]
    rng = np.random.default_rng(seed)
    areas = np.bincount(places.ravel(), minlength=1)
    for number, box in enumerate(ndimage.find_objects(places), 1):
        if areas[number] < LEAST_AREA:
            continue
        window = _widened(box)
        inside = places[window] == number
        near = ndimage.binary_dilation(inside, iterations=AROUND) & sure[window]
        fitted = _planes_through(near, planes[window][..., 0], TOLERANCE / pixels_per, rng)
        if fitted:
            _fill(out[window], inside, fitted, plain[window])
    return out


def _widened(box: Window) -> Window:
    rows, columns = (slice(max(each.start - AROUND, 0), each.stop + AROUND) for each in box)
    return rows, columns


def _planes_through(near: Array, depth: Array, tolerance: float, rng: Any) -> list[tuple[Plane, Array]]:
    """Planes over the picture and the pixels on each."""
    left, out = near.copy(), []
    least = max(LEAST_SUPPORT, LEAST_SHARE * near.sum())
    while len(out) < MOST_PLANES and left.sum() >= least:
        v, u = np.nonzero(left)
        plane = _best_plane(u, v, depth[left].astype(np.float64), tolerance, least, rng)
        if plane is None:
            break
        support = left & (np.abs(_heights(plane, *np.indices(left.shape)[::-1]) - depth) < tolerance)
        out.append((plane, support))
        left &= ~support
    return out


def _heights(plane: Plane, u: Array, v: Array) -> Array:
    return plane[0] + plane[1] * u + plane[2] * v


def _best_plane(u: Array, v: Array, w: Array, tolerance: float, least: float, rng: Any) -> Plane | None:
    """The plane through three pixels that most pixels lie on, fitted to them; None where it is none for sure."""
    triples = rng.integers(0, len(w), (TRIALS, 3))
    a, b, c = triples.T
    bu, bv, cu, cv = u[b] - u[a], v[b] - v[a], u[c] - u[a], v[c] - v[a]
    area = (bu * cv - cu * bv).astype(np.float64)  # [px^2] twice the triangle
    stands = np.abs(area) > LEAST_TRIANGLE
    area[~stands] = np.inf
    du = ((w[b] - w[a]) * cv - (w[c] - w[a]) * bv) / area
    dv = ((w[c] - w[a]) * bu - (w[b] - w[a]) * cu) / area
    first = w[a] - du * u[a] - dv * v[a]
    some = slice(None, None, -(-len(w) // MOST_TRIED))
    tried = _heights((first, du, dv), u[some, None], v[some, None])
    best = np.argmax(np.where(stands, (np.abs(tried - w[some, None]) < tolerance).sum(axis=0), -1))
    plane = (first[best], du[best], dv[best])
    for _ in range(REFITS):
        on = np.abs(_heights(plane, u, v) - w) < tolerance
        fitted = _fitted(u[on], v[on], w[on]) if on.sum() >= least else None
        if fitted is None:
            return None
        plane = fitted
    return plane


def _fitted(u: Array, v: Array, w: Array) -> Plane | None:
    """The plane of least squares; None of pixels that lie about a line."""
    mu, mv, mw = u.mean(), v.mean(), w.mean()
    x, y, z = u - mu, v - mv, w - mw
    xx, xy, yy, xz, yz = ((s * t).mean() for s, t in ((x, x), (x, y), (y, y), (x, z), (y, z)))
    narrow = (xx + yy - math.sqrt((xx - yy) ** 2 + 4 * xy * xy)) / 2  # the square of their spread across
    if narrow < LEAST_SPREAD**2:
        return None
    whole = xx * yy - xy * xy
    du, dv = (xz * yy - yz * xy) / whole, (yz * xx - xz * xy) / whole
    return mw - du * mu - dv * mv, du, dv


def _fill(out: Array, inside: Array, fitted: list[tuple[Plane, Array]], plain: Array) -> None:
    """Give each pixel of a place the plane of the nearest pixel that lies on one."""
    which = np.zeros(inside.shape, int)
    if len(fitted) > 1:
        from scipy import ndimage

        for k, (_, support) in enumerate(fitted):
            which[support] = k + 1
        nearest: Any = ndimage.distance_transform_edt(which == 0, return_distances=False, return_indices=True)
        which = which[tuple(nearest)] - 1
    v, u = np.nonzero(inside)
    first, du, dv = np.array([plane for plane, _ in fitted])[which[inside]].T
    out[inside] = np.column_stack([_heights((first, du, dv), u, v), du, dv, plain[inside]])
