"""Smooth motion fields as sums of Gaussians, by a pivoted incomplete Cholesky factor L (k, m) of G_ij = exp(-|y_i -
y_j|^2 / 2 b^2). O(k m) memory, O(k^2 m) time (Fine and Scheinberg 2001; Myronenko and Song 2010, section 5).
"""

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Array2, Doubles, Points, Positions
from ..arrays.packed_keys import key_index, pack_key
from ..arrays.select import gather_rows
from ..arrays.sparse_factor import solve_symmetric
from ..lang import (
    array,
    atomic_max,
    compute,
    dot,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    sqrt,
    tid,
    vec3,
    vec3d,
    vec4d,
)
from ..linear_algebra import solve
from ..memory import download, empty, upload, zeros
from .coherent_drift import falloff, pulls

PRODUCTS_PER_THREAD = 4  # products of a row summed together by a thread
CHECK_INTERVAL = 32  # rows between two checks of the remainder


@func
def gaussian(p: vec3d, q: vec3d, scale: float64) -> float64:
    d = p - q
    return falloff(scale * dot(d, d))


@kernel
def factor_row_kernel(
    positions: array(dtype=vec3d),
    scale: float64,
    row: int,
    rows: array(dtype=float64, ndim=2),
    left: array(dtype=float64),
    pivots: array(dtype=int64),
):
    """One factor row, the remaining diagonal, and the next pivot. Ties go to the larger index."""
    i = tid()
    p = key_index(pivots[row])
    own = float64(1.0)
    total = gaussian(positions[i], positions[p], scale)
    for k in range(row):
        own = own - rows[k, p] * rows[k, p]
        total = total - rows[k, i] * rows[k, p]
    value = float64(0.0)
    if own > 0.0:
        value = total / sqrt(own)
    rows[row, i] = value
    rest = max(left[i] - value * value, float64(0.0))
    left[i] = rest
    atomic_max(pivots, row + 1, pack_key(float(rest), i))


@kernel
def square_rows_kernel(
    rows: array(dtype=float64, ndim=2),
    count: int,
    sums: array(dtype=pulls),
    points: int,
    out: array(dtype=float64, ndim=2),
):
    """Lower triangle of L diag(sum of p) L^T, PRODUCTS_PER_THREAD numbers per thread."""
    i = tid()
    across = (count + PRODUCTS_PER_THREAD - 1) // PRODUCTS_PER_THREAD
    row = i // across
    first = (i % across) * PRODUCTS_PER_THREAD
    if first <= row:
        a = min(first + 1, count - 1)
        b = min(first + 2, count - 1)
        c = min(first + 3, count - 1)
        total = vec4d(0.0)
        for m in range(points):
            w = rows[row, m] * sums[m][0]
            total += vec4d(w * rows[first, m], w * rows[a, m], w * rows[b, m], w * rows[c, m])
        out[row, first] = total[0]
        out[row, a] = total[1]
        out[row, b] = total[2]
        out[row, c] = total[3]


@kernel
def pull_rows_kernel(
    rows: array(dtype=float64, ndim=2),
    positions: array(dtype=vec3d),
    sums: array(dtype=pulls),
    points: int,
    out: array(dtype=vec3d),
):
    """L (P x - diag(sum of p) y), one row per thread."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    for m in range(points):
        s = sums[m]
        total += rows[i, m] * (vec3d(s[1], s[2], s[3]) - s[0] * positions[m])
    out[i] = total


@kernel
def pick_corner_kernel(
    rows: array(dtype=float64, ndim=2), chosen: array(dtype=int32), count: int, out: array(dtype=float64, ndim=2)
):
    i = tid()
    out[i // count, i % count] = rows[i // count, chosen[i % count]]


@kernel
def move_positions_kernel(
    rows: array(dtype=float64, ndim=2),
    count: int,
    positions: array(dtype=vec3d),
    values: array(dtype=vec3d),
    moved: array(dtype=vec3d),
):
    """y + L^T v."""
    i = tid()
    total = positions[i]
    for k in range(count):
        total += rows[k, i] * values[k]
    moved[i] = total


@kernel
def move_points_kernel(
    points: array(dtype=vec3),
    shift: vec3d,
    unit: float64,
    centers: array(dtype=vec3d),
    weights: array(dtype=vec3d),
    count: int,
    scale: float64,
    moved: array(dtype=vec3),
):
    """Displace points. The field's coordinates are unit (p + shift). Non-finite points stay."""
    i = tid()
    p = widen(points[i])
    moved[i] = points[i]
    if isfinite(p):
        position = (p + shift) * unit
        total = vec3d(0.0, 0.0, 0.0)
        for k in range(count):
            total += gaussian(position, centers[k], scale) * weights[k]
        moved[i] = narrow(p + total / unit)


class CoherentField:
    """Factor of a Gaussian matrix: `rows` float64 (k, m), `count` k, `pivots` int (k)."""

    def __init__(self, positions: Positions, width: float, limit: float, max_rows: int) -> None:
        """Factor it, with a sync every CHECK_INTERVAL rows. Raises ValueError if it needs more than `max_rows` rows."""
        device, size = positions.device, positions.size
        max_rows = min(max_rows, size)
        self.positions, self.scale = positions, 0.5 / (width * width)
        self.rows: Array2[float64] = empty((max_rows, size), float64, device)
        left = upload(np.ones(size), float64, device)
        pivots = zeros(max_rows + 1, int64, device)
        self.count = 0
        keys = np.zeros(0, np.int64)
        while self.count < max_rows:
            done = min(self.count + CHECK_INTERVAL, max_rows)
            for row in range(self.count, done):
                launch(factor_row_kernel, size, [positions, self.scale, row, self.rows, left, pivots])
            self.count = done
            keys = np.array(download(pivots), np.int64)  # sync
            rest = (keys >> 32).astype(np.int32).view(np.float32)[1 : done + 1]
            if (below := np.flatnonzero(rest <= limit)).size:
                self.count = int(below[0]) + 1
                break
        else:
            if size > max_rows:
                raise ValueError(f"more than {max_rows} rows")
        self.pivots = (keys & 0xFFFFFFFF)[: self.count]

    def step(self, sums: Doubles, damping: float, moved: Positions) -> np.ndarray:
        """Move the positions to equilibrium. Returns the row coefficients (k, 3). Float64 on the host, one sync."""
        device, count, size = self.positions.device, self.count, self.positions.size
        square = zeros((count, count), float64, device)
        across = -(-count // PRODUCTS_PER_THREAD)
        launch(square_rows_kernel, count * across, [self.rows, count, sums, size, square])
        right = compute(pull_rows_kernel, count, [self.rows, self.positions, sums, size], vec3d, device)
        lower = np.tril(np.asarray(download(square)).reshape(count, count))  # sync
        self.matrix = lower + np.tril(lower, -1).T
        values = solve_symmetric(self.matrix + damping * np.eye(count), np.asarray(download(right)).reshape(count, 3))
        given = upload(values, vec3d, device)
        launch(move_positions_kernel, size, [self.rows, count, self.positions, given, moved])
        return values

    def count_parameters(self, damping: float) -> float:
        """Effective number of Gaussians of the last step: the trace of its smoother (Hastie and Tibshirani 1990)."""
        return float(np.trace(solve(self.matrix + damping * np.eye(self.count), self.matrix)))

    def weights_of(self, values: np.ndarray) -> np.ndarray:
        """Gaussian weights of the pivots for row coefficients: float64 (k, 3)."""
        corner = empty((self.count, self.count), float64, self.positions.device)
        chosen = upload(self.pivots.astype(np.int32), int32, self.positions.device)
        launch(pick_corner_kernel, self.count * self.count, [self.rows, chosen, self.count, corner])
        return solve(np.asarray(download(corner)).reshape(self.count, self.count), values)  # sync

    def centers(self) -> np.ndarray:
        """Positions of the pivots, float64 (k, 3). One sync."""
        chosen = upload(self.pivots.astype(np.int32), int32, self.positions.device)
        return np.array(download(gather_rows(self.positions, chosen)), np.float64).reshape(-1, 3)


def move_points(
    points: Points, shift: np.ndarray, unit: float, centers: np.ndarray, weights: np.ndarray, scale: float
) -> Points:
    device = points.device
    moved = empty(points.size, vec3, device)
    pivots, coefficients = upload(centers, vec3d, device), upload(weights, vec3d, device)
    arguments = [points, vec3d(*shift), unit, pivots, coefficients, len(centers), scale, moved]
    launch(move_points_kernel, points.size, arguments)
    return moved
