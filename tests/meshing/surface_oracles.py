"""Distances, insides and meetings of triangles by brute force: every triangle, float64 or whole numbers."""

from __future__ import annotations

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
    """[n, t]: the distance of each point from each triangle, corners [t, 3, 3]."""
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
    """Van Oosterom and Strackee's solid angles of all triangles."""
    a, b, c = (np.asarray(corners, np.float64)[None, :, k] - np.asarray(points)[:, None] for k in range(3))
    x, y, z = (np.linalg.norm(e, axis=-1) for e in (a, b, c))
    volume = (a * np.cross(b, c)).sum(-1)
    rest = x * y * z + (a * b).sum(-1) * z + (b * c).sum(-1) * x + (c * a).sum(-1) * y
    return (2 * np.arctan2(volume, rest)).sum(1) / (4 * np.pi)


def triangles_meet(s: NDArray[Any], t: NDArray[Any]) -> bool:
    """Whether two triangles of small whole coordinates meet: no direction of all that can part them does."""
    edges = [s[1] - s[0], s[2] - s[1], s[0] - s[2], t[1] - t[0], t[2] - t[1], t[0] - t[2]]
    across = [np.cross(a, b) for a, b in itertools.combinations(edges, 2)]
    axes = [*edges, *across, *(np.cross(a, e) for a in across for e in edges)]
    # what joins them, and its parts across what spans them: for points and edges in one line or plane
    joint = t[0] - s[0]
    axes += [joint, *(np.cross(joint, e) for e in edges), *(np.cross(np.cross(joint, e), e) for e in edges)]
    low, high = np.array(axes) @ s.T, np.array(axes) @ t.T
    return not ((low.max(1) < high.min(1)) | (high.max(1) < low.min(1))).any()


def meeting_pairs(vertices: NDArray[Any], triangles: NDArray[Any]) -> list[list[int]]:
    whole = np.asarray(vertices)
    whole = whole.astype(np.int64 if np.abs(whole).max() < 2**14 else object)  # six factors fit, or Python's numbers
    return [
        [i, j]
        for i, j in itertools.combinations(range(len(triangles)), 2)
        if not set(triangles[i]) & set(triangles[j]) and triangles_meet(whole[triangles[i]], whole[triangles[j]])
    ]
