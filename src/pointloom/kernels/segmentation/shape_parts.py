"""Connected parts of a shape's points, unlabeled points, and distances from shapes.

Instead of the bitmap of Schnabel, Wahl and Klein 2007, section 4.5, points are connected by distance in space with the
disjoint sets of DBSCAN. 20 B per point beside a tree.
"""

import numpy as np
from numpy.typing import NDArray

from ..array_types import Indices, Integers, Points, Scalars
from ..arrays.bounds import bound_points
from ..arrays.quantiles import quantiles_of
from ..arrays.select import gather_rows, positions_of
from ..lang import (
    array,
    atomic_max,
    atomic_min,
    compute,
    dot,
    float32,
    float64,
    int32,
    kernel,
    launch,
    tid,
    uint8,
    vec3,
    vec3d,
)
from ..memory import download, empty, full, upload
from ..search.point_tree import PointTree
from .cluster_labels import rank_by_size
from .dbscan import cluster_points
from .plane_samples import sampled_point
from .shape_models import measure
from .shape_search import DetectedShape, ShapeSearch, rotate_points_kernel

TAIL_FRACTION = 0.01  # of a face's points at either end that may belong to adjacent surfaces
MAX_STEPS = 2_000_000_000  # of a height, an integer for the atomics


@kernel
def mask_label_kernel(labels: array(dtype=int32), rows: array(dtype=int32), label: int, mask: array(dtype=uint8)):
    i = tid()
    mask[i] = uint8(1 if labels[rows[i]] == label else 0)


@kernel
def mask_first_part_kernel(labels: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    mask[i] = uint8(1 if labels[i] == 0 else 0)


@kernel
def write_distances_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    kind: int,
    p: vec3d,
    a: vec3d,
    sizes: vec3d,
    distances: array(dtype=float32),
):
    i = tid()
    m = measure(kind, p, a, sizes[0], sizes[1], sampled_point(points, rows[i], center))
    distances[rows[i]] = float32(m[0])


@kernel
def extend_heights_kernel(
    points: array(dtype=vec3),
    labels: array(dtype=int32),
    positions: array(dtype=vec3d),
    normals: array(dtype=vec3d),
    step: float64,
    low: array(dtype=int32, ndim=2),
    high: array(dtype=int32, ndim=2),
):
    """Extend the height range of each plane's points above each other plane, in steps."""
    i = tid()
    k = labels[i]
    if k >= 0:
        for j in range(positions.shape[0]):
            height = dot(sampled_point(points, i, positions[j]), normals[j]) / step
            height = max(float64(-2.0e9), min(float64(2.0e9), height))  # MAX_STEPS
            atomic_min(low, k, j, int(height))  # the minimum does not depend on the order
            atomic_max(high, k, j, int(height))  # the maximum does not depend on the order


def heights_across(
    points: Points, labels: NDArray[np.int32], positions: NDArray[np.float64], normals: NDArray[np.float64], step: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Minimum and maximum height [m] of each plane's points (row; label -1: none) above each plane. One sync."""
    count, device = len(positions), points.device
    low, high = full((count, count), MAX_STEPS, int32, device), full((count, count), -MAX_STEPS, int32, device)
    there = [upload(labels, int32, device), upload(positions, vec3d, device), upload(normals, vec3d, device)]
    launch(extend_heights_kernel, points.size, [points, *there, step, low, high])
    return download(low) * step, download(high) * step  # sync


@kernel
def lift_heights_kernel(rotated: array(dtype=vec3), low: vec3d, heights: array(dtype=float64, ndim=2)):
    i = tid()
    for k in range(3):
        heights[k, i] = float64(rotated[i][k]) - low[k]


def bounds_in_frame(
    points: Points, rows: Indices, position: NDArray[np.float64], frame: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Robust bounds of uniform points in a frame: extrapolated quantiles at the tails, clamped. 4 syncs."""
    rotated = empty(rows.size, vec3, rows.device)
    axes = [vec3d(*axis) for axis in frame]
    launch(rotate_points_kernel, rows.size, [points, rows, vec3d(0.0, 0.0, 0.0), vec3d(*position), *axes, rotated])
    low, high = (bound.astype(np.float64) for bound in bound_points(rotated)[:2])  # sync
    heights = empty((3, rows.size), float64, rows.device)
    launch(lift_heights_kernel, rows.size, [rotated, vec3d(*low), heights])
    tails = np.array([quantiles_of(heights[k], [TAIL_FRACTION, 1 - TAIL_FRACTION]) for k in range(3)])  # sync, three
    more = TAIL_FRACTION / (1 - 2 * TAIL_FRACTION) * (tails[:, 1] - tails[:, 0])
    return low + np.maximum(tails[:, 0] - more, 0), np.minimum(low + tails[:, 1] + more, high)


def largest_part(points: Points, rows: Indices, radius: float) -> Indices:
    """Rows of the largest group of points connected by steps shorter than a radius, in order."""
    if rows.size == 0:
        return rows
    chosen = gather_rows(points, rows)
    labels, count = cluster_points(PointTree(chosen), rows.size, radius, 1)
    rank_by_size(labels, count, 1, rows.size)
    mask = compute(mask_first_part_kernel, rows.size, [labels], uint8, rows.device)
    return gather_rows(rows, positions_of(mask))


def rows_labeled(labels: Integers, rows: Indices, label: int) -> Indices:
    """Rows with a label, in order. One sync."""
    mask = compute(mask_label_kernel, rows.size, [labels, rows, label], uint8, rows.device)
    return gather_rows(rows, positions_of(mask))


def write_distances(search: ShapeSearch, detected: DetectedShape, distances: Scalars) -> None:
    shape = detected.fit.shape
    position, axis, sizes = vec3d(*shape[:3]), vec3d(*shape[3:6]), vec3d(shape[6], shape[7], 0.0)
    arguments = [search.points, detected.rows, vec3d(*search.center), detected.kind, position, axis, sizes, distances]
    launch(write_distances_kernel, detected.rows.size, arguments)
