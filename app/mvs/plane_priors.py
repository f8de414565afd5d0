"""Planes for plain places: fitted to the sure depth in and around each of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

Array = NDArray[Any]
Window = tuple[slice, slice]
LEAST_AREA = 64  # [px] of a place that is worth a plane
AROUND = 3  # [px] beyond a plain place whose sure depth counts: farther off other things begin
LEAST_SUPPORT = 20  # sure pixels that lie on a plane
LEAST_SHARE = 0.35  # of all that are sure there: less, and scattered errors make planes of their own
LEAST_SPREAD = 3.0  # [px] of them across their longest direction: a line has many planes
MOST_PLANES = 3  # of a place: walls and ceilings of one colour
TOLERANCE = 0.5  # [px in the sources] beside a plane
TRIALS = 100
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
    out = np.zeros(planes.shape, np.float32)
    places, count = ndimage.label(plain > 0)
    rng = np.random.default_rng(seed)
    areas = np.bincount(places.ravel(), minlength=count + 1)
    for number, box in enumerate(ndimage.find_objects(places), 1):
        if areas[number] < LEAST_AREA:
            continue
        window = _widened(box)
        inside = places[window] == number
        near = ndimage.binary_dilation(inside, iterations=AROUND) & sure[window]
        found = _planes_through(near, planes[window][..., 0], TOLERANCE / pixels_per, rng)
        if found:
            _fill(out[window], inside, found, plain[window])
    return out


def _widened(box: Window) -> Window:
    rows, columns = (slice(max(each.start - AROUND, 0), each.stop + AROUND) for each in box)
    return rows, columns


def _planes_through(near: Array, depth: Array, tolerance: float, rng: Any) -> list[tuple[Array, Array]]:
    """Coefficients of planes and the pixels on each, the one with most pixels first."""
    left, out = near.copy(), []
    while len(out) < MOST_PLANES:
        v, u = np.nonzero(left)
        if len(v) < LEAST_SUPPORT:
            break
        rows, w = np.column_stack([np.ones(len(u)), u, v]), depth[left].astype(np.float64)
        on = _best_plane(rows, w, tolerance, rng)
        for _ in range(2):
            if on.sum() < LEAST_SUPPORT:
                break
            plane = np.linalg.lstsq(rows[on], w[on], rcond=None)[0]
            on = np.abs(rows @ plane - w) < tolerance
        if on.sum() < max(LEAST_SUPPORT, LEAST_SHARE * near.sum()) or _breadth(rows[on, 1:]) < LEAST_SPREAD:
            break
        support = np.zeros_like(left)
        support[v[on], u[on]] = True
        out.append((plane, support))
        left &= ~support
    return out


def _best_plane(rows: Array, w: Array, tolerance: float, rng: Any) -> Array:
    """Which pixels lie on the plane through three of them that most lie on."""
    some = slice(None, None, -(-len(w) // MOST_TRIED))
    triples = rng.integers(0, len(w), (TRIALS, 3))
    corners = rows[triples]
    stands = np.abs(np.linalg.det(corners)) > 1.0  # [px^2] twice the triangle
    if not stands.any():
        return np.zeros(len(w), bool)
    planes = np.linalg.solve(corners[stands], w[triples[stands]][..., None])[..., 0]
    counts = (np.abs(rows[some] @ planes.T - w[some, None]) < tolerance).sum(axis=0)
    return np.abs(rows @ planes[np.argmax(counts)] - w) < tolerance


def _breadth(places: Array) -> float:
    return float(np.sqrt(max(np.linalg.eigvalsh(np.cov(places.T))[0], 0.0)))


def _fill(out: Array, inside: Array, found: list[tuple[Array, Array]], plain: Array) -> None:
    """Give each pixel of a place the plane of the nearest pixel that lies on one."""
    which = np.zeros(inside.shape, int)
    for k, (_, support) in enumerate(found):
        which[support] = k + 1
    if len(found) > 1:
        nearest = ndimage.distance_transform_edt(which == 0, return_distances=False, return_indices=True)
        which = which[tuple(nearest)]
    else:
        which[:] = 1
    v, u = np.nonzero(inside)
    a, b, c = np.array([plane for plane, _ in found])[which[inside] - 1].T
    out[inside] = np.column_stack([a + b * u + c * v, b, c, plain[inside]])
