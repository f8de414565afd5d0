"""Brute-force distances, inside tests and intersections of triangles in float64 or integers."""

import itertools
from typing import Any

import numpy as np
from numpy.typing import NDArray


def segment_distances(p: NDArray[Any], a: NDArray[Any], b: NDArray[Any]) -> NDArray[Any]:
    e = b - a
    length = (e * e).sum(-1)
    t = np.clip(((p - a) * e).sum(-1) / np.where(length > 0, length, 1), 0, 1)
    return np.linalg.norm(p - a - t[..., None] * e, axis=-1)


def distances_to_triangles(points: NDArray[Any], corners: NDArray[Any]) -> NDArray[np.float64]:
    p = np.asarray(points, np.float64)[:, None]
    a, b, c = (np.asarray(corners, np.float64)[None, :, k] for k in range(3))
    n = np.cross(b - a, c - a)
    size = (n * n).sum(-1)
    safe = np.where(size > 0, size, 1)
    v, w = ((np.cross(p - a, c - a) * n).sum(-1) / safe, (np.cross(b - a, p - a) * n).sum(-1) / safe)
    inside = (v > 0) & (w > 0) & (v + w < 1) & (size > 0)
    edges = np.minimum.reduce([segment_distances(p, a, b), segment_distances(p, b, c), segment_distances(p, c, a)])
    return np.where(inside, np.abs((n * (p - a)).sum(-1)) / np.sqrt(safe), edges)


def winding_numbers(points: NDArray[Any], corners: NDArray[Any]) -> NDArray[np.float64]:
    """Generalized winding numbers by van Oosterom and Strackee's solid angles of all triangles."""
    a, b, c = (np.asarray(corners, np.float64)[None, :, k] - np.asarray(points)[:, None] for k in range(3))
    x, y, z = (np.linalg.norm(e, axis=-1) for e in (a, b, c))
    volume = (a * np.cross(b, c)).sum(-1)
    rest = x * y * z + (a * b).sum(-1) * z + (b * c).sum(-1) * x + (c * a).sum(-1) * y
    return (2 * np.arctan2(volume, rest)).sum(1) / (4 * np.pi)


def cross(a: NDArray[Any], b: NDArray[Any]) -> NDArray[Any]:
    """Cross product of two vectors. NumPy 1 has none of Python's integers."""
    return a[[1, 2, 0]] * b[[2, 0, 1]] - a[[2, 0, 1]] * b[[1, 2, 0]]


def triangles_meet(s: NDArray[Any], t: NDArray[Any]) -> bool:
    """True if two triangles with small integer coordinates intersect: no candidate axis separates them."""
    edges = [s[1] - s[0], s[2] - s[1], s[0] - s[2], t[1] - t[0], t[2] - t[1], t[0] - t[2]]
    across = [cross(a, b) for a, b in itertools.combinations(edges, 2)]
    axes = [*edges, *across, *(cross(a, e) for a in across for e in edges)]
    # directions between the edges, and for coplanar or collinear cases their components across the span
    joint = t[0] - s[0]
    axes += [joint, *(cross(joint, e) for e in edges), *(cross(cross(joint, e), e) for e in edges)]
    low, high = np.array(axes) @ s.T, np.array(axes) @ t.T
    return not ((low.max(1) < high.min(1)) | (high.max(1) < low.min(1))).any()


def meeting_pairs(vertices: NDArray[Any], triangles: NDArray[Any]) -> list[list[int]]:
    integers = np.asarray(vertices)
    # int64 where a product of six factors fits, otherwise Python's integers
    integers = integers.astype(np.int64 if np.abs(integers).max() < 2**14 else object)
    return [
        [i, j]
        for i, j in itertools.combinations(range(len(triangles)), 2)
        if not set(triangles[i]) & set(triangles[j]) and triangles_meet(integers[triangles[i]], integers[triangles[j]])
    ]
