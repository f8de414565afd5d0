"""How well the pictures of a model fix the depth of its points: angles between rays, and what turning alone explains.

The angle under which a point is seen from two places says how well its depth is known, if the model is right. A camera
that only turned may well give a model that is not: with a focal length that is wrong by a third and some distortion,
motion is made up that explains the pictures to a tenth of a pixel, with angles of many degrees. So it is asked
whether turning alone explains them as well, by a focal length and a distortion of its choice: then nothing is known
of depth.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...files.models.sfm_model import SfmModel

Array = NDArray[np.float64]

_MOST_RAYS = 1 << 20  # that are compared at once: 24 MB, and the products of those of a point
_MOST_PAIRS = 40  # of pictures that are tried for turning
_MOST_SHARED = 120  # points of a pair
_FEW_SHARED = 20
_LOG_FACTORS = (-np.log(2.0), np.log(2.0))  # of the focal length that turning may choose
_MOST_DISTORTION = 0.5
_STEPS, _ROUNDS = 9, 5  # values of both a round, and rounds, each in a third of the range of the one before
_NARROWING = 3.0


def triangulation_angles(model: SfmModel) -> Array:
    """The widest angle between two rays to each point, shape [m] [degrees]; 0 of points that are seen once.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> poses = np.tile(np.eye(4), (2, 1, 1))
        >>> poses[1, 0, 3] = -1.0
        >>> seen = {"observations": [[0, 0], [1, 0]], "pixels": [[319.5, 239.5], [-180.5, 239.5]]}
        >>> model = loom.SfmModel(["a", "b"], [camera] * 2, poses, points=[[0, 0, 1.0]], **seen)
        >>> triangulation_angles(model).round(3).tolist()
        [45.0]
    """
    angles = np.zeros(len(model.points))
    order = np.argsort(model.observations[:, 1], kind="stable")
    pictures, points = model.observations[order].T
    rays = model.centers[pictures] - model.points[points]
    rays /= np.maximum(np.linalg.norm(rays, axis=1, keepdims=True), np.finfo(np.float64).tiny)
    counts = np.bincount(points, minlength=len(angles))
    starts = np.cumsum(counts) - counts
    for count in np.unique(counts[counts > 1]):
        chosen = np.flatnonzero(counts == count)
        for part in np.array_split(chosen, -(-len(chosen) * int(count) ** 2 // _MOST_RAYS)):
            these = rays[starts[part][:, None] + np.arange(count)]
            cosines = np.einsum("kid,kjd->kij", these, these).min(axis=(1, 2))
            angles[part] = np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0)))
    return angles


def parallax(model: SfmModel, *, fixed: bool = False) -> float:
    """How far from where they are points would be seen by a camera that only turns [px].

    Each picture is compared with a far one that sees the same points. One turn for each pair, and for all of
    them one focal length (up to twice that of the model, or half of it) and one radial distortion are fitted.

    Args:
        model: With what was seen where.
        fixed: The cameras are known: nothing but turns is fitted.

    Returns:
        The median over pairs of the root mean square distance; NaN where no two pictures share 20 points.
    """
    pairs = _far_pairs(model)
    if not pairs:
        return float("nan")
    first, second, weights = _rays_of(model, pairs)
    focal = float(np.median([camera.params[0] for camera in model.cameras]))
    if fixed:
        return float(focal * _turning_error(first, second, weights, 1.0, 0.0))
    center, reach = [0.0, 0.0], (_LOG_FACTORS[1], _MOST_DISTORTION)
    best = float("inf")
    for _ in range(_ROUNDS):
        logs = np.clip(np.linspace(center[0] - reach[0], center[0] + reach[0], _STEPS), *_LOG_FACTORS)
        bends = np.linspace(center[1] - reach[1], center[1] + reach[1], _STEPS)
        tried = [(_turning_error(first, second, weights, np.exp(a), b), a, b) for a in logs for b in bends]
        error, *center = min(tried)
        best = min(best, error)
        reach = (reach[0] / _NARROWING, reach[1] / _NARROWING)
    return float(focal * best)


def _far_pairs(model: SfmModel) -> list[tuple[int, int]]:
    """For some pictures, spread over all, another one that is far away and sees many of the same points."""
    count = max(len(model.points), 1)
    at = np.sort(model.observations @ (count, 1))
    pictures, points = np.divmod(at[np.diff(at, prepend=-1) > 0], count)  # a point may stand twice in a picture
    pairs = set()
    for picture in np.unique(np.linspace(0, len(model) - 1, _MOST_PAIRS).round().astype(int)) if len(model) else ():
        seen = np.zeros(len(model.points), bool)
        seen[points[pictures == picture]] = True
        shared = np.bincount(pictures[seen[points]], minlength=len(model))
        distances = np.linalg.norm(model.centers - model.centers[picture], axis=1)
        # The farthest one of all shares a corner, in which all points may be equally far.
        worth = np.where(shared < _FEW_SHARED, -1.0, distances * np.sqrt(shared))
        worth[picture] = -1.0
        other = int(np.argmax(worth))
        if worth[other] >= 0:
            pairs.add((min(int(picture), other), max(int(picture), other)))
    return sorted(pairs)


def _rays_of(model: SfmModel, pairs: list[tuple[int, int]]) -> tuple[Array, Array, Array]:
    """Where both pictures of each pair see shared points, at z = 1: shapes [p, s, 2] twice, and weights [p, s]."""
    first = np.zeros((len(pairs), _MOST_SHARED, 2))
    second, weights = first.copy(), np.zeros(first.shape[:2])
    for k, pair in enumerate(pairs):
        rows = [np.flatnonzero(model.observations[:, 0] == picture) for picture in pair]
        seen, seen_beside = (model.observations[r, 1] for r in rows)
        _, at, beside = np.intersect1d(seen, seen_beside, return_indices=True)
        some = np.unique(np.linspace(0, len(at) - 1, _MOST_SHARED).round().astype(int))
        for rays, picture, chosen in ((first, pair[0], rows[0][at[some]]), (second, pair[1], rows[1][beside[some]])):
            rays[k, : len(some)] = model.cameras[picture].unproject(model.pixels[chosen])[:, :2]
        weights[k, : len(some)] = 1.0
    weights[~np.isfinite(first + second).all(axis=2)] = 0.0  # beyond the reach of the lens
    return np.nan_to_num(first), np.nan_to_num(second), weights


def _turning_error(first: Array, second: Array, weights: Array, factor: float, distortion: float) -> float:
    """The median over pairs of how far turns fail, at z = 1 of the model's own cameras."""
    a, b = (_bent(rays, factor, distortion) for rays in (first, second))
    products = np.einsum("ps,psi,psj->pij", weights, b / _length(b), a / _length(a))
    u, _, vt = np.linalg.svd(products)
    flip = np.ones((len(u), 3))
    flip[:, 2] = np.sign(np.linalg.det(u @ vt))
    turned = np.einsum("pij,psj->psi", (u * flip[:, None]) @ vt, a)
    off = turned[..., :2] / np.maximum(turned[..., 2:], 1e-3) - b[..., :2]
    count = np.maximum(weights.sum(axis=1), 1)
    return float(np.median(np.sqrt((weights * (off**2).sum(axis=2)).sum(axis=1) / count))) / factor


def _bent(rays: Array, factor: float, distortion: float) -> Array:
    radius = (rays**2).sum(axis=2, keepdims=True)
    bent = rays * factor * (1.0 + distortion * radius)
    return np.concatenate([bent, np.ones_like(radius)], axis=2)


def _length(rays: Array) -> Array:
    return np.linalg.norm(rays, axis=2, keepdims=True)
