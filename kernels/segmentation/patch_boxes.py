"""The boxes about flat patches: one side along the normal, the other two turned so that the face is smallest.

DIRECTIONS angles over a quarter turn, then as many over the two steps about the best. A thread a slice of a patch's
points and angle; 16 B read a point and angle, six atomics a thread.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..array_types import Points
from ..lang import INFINITY, array, atomic_max, atomic_min, dot, float32, int32, kernel, launch, tid, vec3
from ..memory import download, fill, full, upload

if TYPE_CHECKING:
    from .planar_patches import Runs

DIRECTIONS = 45  # of a box's first side over a quarter turn; a second pass divides a step again
SLICES = 32  # threads a patch and direction


@kernel
def measure_boxes_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    starts: array(dtype=int32),
    centers: array(dtype=vec3),
    axes: array(dtype=vec3),
    directions: int,
    lows: array(dtype=float32),
    highs: array(dtype=float32),
):
    """How far a slice of a patch's points reaches along each axis of a box; minimum and maximum in any order."""
    i = tid()
    box = i // SLICES
    part = i % SLICES
    patch = box // directions
    first = starts[patch]
    size = starts[patch + 1] - first
    per_slice = (size + SLICES - 1) // SLICES
    for axis in range(3):
        side = axes[3 * box + axis]
        low = float(INFINITY)
        high = -float(INFINITY)
        for j in range(first + min(part * per_slice, size), first + min((part + 1) * per_slice, size)):
            along = dot(side, points[rows[j]] - centers[patch])
            low = min(low, along)
            high = max(high, along)
        atomic_min(lows, 3 * box + axis, low)
        atomic_max(highs, 3 * box + axis, high)


def tightest_boxes(
    points: Points, runs: "Runs", centers: np.ndarray, directions: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of boxes with one side along the normal those whose face has the least area, to a tenth of a degree.

    Args:
        points: Positions of all points.
        runs: Runs of the points of each patch.
        centers, directions: A point and the normal of each, float32 [b, 3].

    Returns:
        (centers, rotations, extents): float64 [b, 3], [b, 3, 3] with the axes as columns and the normal last, and
        [b, 3].
    """
    normals = directions.astype(np.float64)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    base = _basis(normals)
    step = 0.5 * np.pi / DIRECTIONS
    best: np.ndarray = np.zeros(len(normals))
    k = axes = lows = highs = best  # set in the loop
    for _ in range(2):
        angles = best[:, None] + step * (np.arange(DIRECTIONS) - DIRECTIONS // 2)
        axes = _turned(base, normals, angles)
        lows, highs = _measure(points, runs, centers, axes)
        sizes = highs - lows
        k = np.argmin(sizes[..., 0] * sizes[..., 1], axis=1)
        best, step = angles[np.arange(len(k)), k], step * 2 / DIRECTIONS
    chosen = np.arange(len(k)), k
    sides, low, high = axes[chosen], lows[chosen], highs[chosen]
    middle = centers + np.einsum("bi,bij->bj", 0.5 * (low + high), sides)
    return middle, np.transpose(sides, (0, 2, 1)), high - low


def _measure(points: Points, runs: "Runs", centers: np.ndarray, axes: np.ndarray) -> Iterator[Any]:
    """How far the points reach along the axes [b, d, 3, 3] of boxes: two arrays [b, d, 3]."""
    boxes = axes.shape[0] * axes.shape[1]
    reaches = full(6 * boxes, INFINITY, float32, points.device)
    lows, highs = reaches[: 3 * boxes], reaches[3 * boxes :]
    fill(highs, -INFINITY)
    places = upload(centers, vec3, points.device), upload(axes.reshape(-1, 3), vec3, points.device)
    arguments = [points, runs.rows, runs.starts, *places, axes.shape[1], lows, highs]
    launch(measure_boxes_kernel, boxes * SLICES, arguments)
    found = download(reaches)  # sync
    return (part.reshape(axes.shape[:3]).astype(np.float64) for part in found.reshape(2, -1))


def _basis(normals: np.ndarray) -> np.ndarray:
    """A unit vector orthogonal to each of the unit vectors [b, 3]."""
    smallest = np.eye(3)[np.argmin(np.abs(normals), axis=1)]
    across = np.cross(normals, smallest)
    return across / np.linalg.norm(across, axis=1, keepdims=True)


def _turned(base: np.ndarray, normals: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Right-handed axes [b, d, 3, 3] by rows: the base turned about the normal, its partner, the normal."""
    partner = np.cross(normals, base)
    cos, sin = np.cos(angles)[..., None], np.sin(angles)[..., None]
    first = cos * base[:, None] + sin * partner[:, None]
    second = cos * partner[:, None] - sin * base[:, None]
    return np.stack([first, second, np.broadcast_to(normals[:, None], first.shape)], axis=2)
