"""Preparation of positions for rendering: extents along directions, normals as lines, changes of origin."""

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Indices, Integers, Points, Vectors
from ..arrays.bounds import EMPTY_EXTREME, RUN_POINTS, numbers_of_bits, ordered_bits
from ..arrays.row_atomics import raise_int
from ..arrays.runs import Runs, elements_of, row_of
from ..lang import INFINITY, array, dot, int32, isfinite, kernel, launch, length, mat33d, tid, vec3, vec3d
from ..memory import download, empty, full

NUM_DIRECTIONS = 5  # of `find_extremes`


@kernel
def find_extremes_kernel(
    points: array(dtype=vec3), directions: array(dtype=vec3), runs: Runs, extremes: array(dtype=int32)
):
    i = tid()
    d0 = directions[0]
    d1 = directions[1]
    d2 = directions[2]
    d3 = directions[3]
    d4 = directions[4]
    max0 = -float(INFINITY)
    max1 = -float(INFINITY)
    max2 = -float(INFINITY)
    max3 = -float(INFINITY)
    max4 = -float(INFINITY)
    for j in elements_of(i, runs):
        p = points[j]
        if isfinite(p):
            max0 = max(max0, dot(p, d0))
            max1 = max(max1, dot(p, d1))
            max2 = max(max2, dot(p, d2))
            max3 = max(max3, dot(p, d3))
            max4 = max(max4, dot(p, d4))
    is_any = 1 if max0 > -float(INFINITY) else 0
    first = row_of(i, runs) * NUM_DIRECTIONS
    raise_int(extremes, first, ordered_bits(max0) if is_any == 1 else EMPTY_EXTREME)
    raise_int(extremes, first + 1, ordered_bits(max1) if is_any == 1 else EMPTY_EXTREME)
    raise_int(extremes, first + 2, ordered_bits(max2) if is_any == 1 else EMPTY_EXTREME)
    raise_int(extremes, first + 3, ordered_bits(max3) if is_any == 1 else EMPTY_EXTREME)
    raise_int(extremes, first + 4, ordered_bits(max4) if is_any == 1 else EMPTY_EXTREME)


@kernel
def make_normal_lines_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    size: float,
    ends: array(dtype=vec3),
    lines: array(dtype=int32),
):
    i = tid()
    p = points[i]
    n = normals[i]
    norm = length(n)
    ends[2 * i] = p
    ends[2 * i + 1] = p
    if norm > 0.0:
        ends[2 * i + 1] = p + n * (size / norm)
    lines[2 * i] = 2 * i
    lines[2 * i + 1] = 2 * i + 1


@kernel
def transform_points_kernel(points: array(dtype=vec3), A: mat33d, t: vec3d, start: int, out: array(dtype=vec3)):
    """out[start + i] = A p + t, in float64."""
    i = tid()
    out[start + i] = narrow(A @ widen(points[i]) + t)


@kernel
def shift_indices_kernel(indices: array(dtype=int32), step: int, start: int, out: array(dtype=int32)):
    i = tid()
    out[start + i] = indices[i] + step


def find_extremes(points: Points, directions: Vectors) -> np.ndarray:
    """Largest products of the finite points (at least one) with directions vec3 (5): float64 (5) on the host."""
    runs = Runs(points.size, points.device, RUN_POINTS)
    extremes = full(runs.rows * NUM_DIRECTIONS, EMPTY_EXTREME, int32, points.device)
    launch(find_extremes_kernel, runs.threads, [points, directions, runs, extremes])
    bits = download(extremes).reshape(runs.rows, NUM_DIRECTIONS).max(axis=0)  # sync
    return numbers_of_bits(bits).astype(np.float64)


def make_normal_lines(points: Points, normals: Vectors, size: float) -> tuple[Points, Indices]:
    """Lines from points along their normals: (vec3 (2 n), int32 (2 n))."""
    ends, lines = empty(2 * points.size, vec3, points.device), empty(2 * points.size, int32, points.device)
    launch(make_normal_lines_kernel, points.size, [points, normals, float(size), ends, lines])
    return ends, lines


def transform_points(points: Points, A: np.ndarray, t: np.ndarray, out: Vectors, start: int) -> None:
    """Write A p + t for all points from `start` on. A (3, 3) and t (3) in float64."""
    launch(transform_points_kernel, points.size, [points, mat33d(*A.ravel().tolist()), vec3d(*t.tolist()), start, out])


def shift_indices(indices: Indices, step: int, out: Integers, start: int) -> None:
    """Write indices plus a step to an array from `start` on."""
    launch(shift_indices_kernel, indices.size, [indices, step, start, out])
