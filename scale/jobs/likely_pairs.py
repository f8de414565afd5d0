"""Which of many scans are likely to overlap: by boxes at known places, and by what their surfaces look like."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, norm
from ...registration.pose_graphs.connected_parts import connected_parts

Box = tuple[NDArray[np.float64], NDArray[np.float64]]


def look_of(features: NDArray[np.float32]) -> NDArray[np.float64]:
    """A scan's surface as one row: the means and deviations of its points' features; zeros of none."""
    finite = features[np.isfinite(features).all(axis=1)].astype(np.float64)
    if not len(finite):
        return np.zeros(2 * features.shape[1])
    return np.concatenate([finite.mean(axis=0), finite.std(axis=0)])


def most_alike(looks: NDArray[np.float64], scan: int, others: NDArray[np.int64], count: int) -> list[int]:
    """The scans among others that look most like one, the most alike first; each column counts by its spread."""
    spread = looks.std(axis=0)
    scaled = looks / np.where(spread > 0, spread, 1.0)
    distances = np.linalg.norm(scaled[others] - scaled[scan], axis=1)
    return others[np.argsort(distances, kind="stable")[:count]].tolist()


def place_box(low: NDArray[Any], high: NDArray[Any], place: NDArray[np.float64], error: float) -> Box:
    """Where a scan reaches at most: its box from low to high in its own frame, at a pose [4, 4] or, turned anyhow, at a
    position [3], which err by so much."""
    if place.shape == (3,):
        radius = float(norm(np.maximum(np.abs(low), np.abs(high)))) + error
        return place - radius, place + radius
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    moved = matmul(np.where(corners, high, low), place[:3, :3].T) + place[:3, 3]
    return moved.min(axis=0) - error, moved.max(axis=0) + error


def meeting_boxes(boxes: Sequence[Box | None]) -> list[tuple[int, int]]:
    """Pairs of boxes that meet, (earlier, later), ascending."""
    there = [k for k, box in enumerate(boxes) if box is not None]
    low = np.array([box[0] for box in boxes if box is not None]).reshape(-1, 3)
    high = np.array([box[1] for box in boxes if box is not None]).reshape(-1, 3)
    found = []
    for i, k in enumerate(there):
        meets = ((low[i + 1 :] <= high[i]) & (high[i + 1 :] >= low[i])).all(axis=1)
        found += [(k, there[i + 1 + j]) for j in np.flatnonzero(meets).tolist()]
    return found


def nearest_of(pairs: Sequence[tuple[int, int]], boxes: Sequence[Box | None], count: int) -> list[tuple[int, int]]:
    """Those pairs, ascending, that are among the nearest of either of their boxes, by the boxes' middles."""
    middles = {k: (box[0] + box[1]) / 2 for k, box in enumerate(boxes) if box is not None}
    beside: dict[int, list[tuple[float, tuple[int, int]]]] = {k: [] for k in middles}
    for i, j in pairs:
        distance = float(norm(middles[i] - middles[j]))
        for k in (i, j):
            beside[k].append((distance, (i, j)))
    return sorted({ends for found in beside.values() for _, ends in sorted(found)[:count]})


def groups_of(count: int, pairs: Iterable[tuple[int, int]]) -> NDArray[np.int32]:
    """Which scans hang together by pairs: the group of each, numbered in the order of the groups' first scans."""
    ends = np.array([*pairs], np.int64).reshape(-1, 2)
    return connected_parts(ends[:, 0], ends[:, 1], count)
