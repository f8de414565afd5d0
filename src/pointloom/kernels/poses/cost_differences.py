"""Differences of Geman-McClure point-to-plane costs between poses and the first pose, over points with a plane at both.
The scale comes from the residuals at the first pose (three reweighting rounds).
"""

import numpy as np

from ..array_types import Array2
from ..lang import array, float32, float64, kernel, launch, tid
from ..memory import download, empty, full

CPU_RUN = 64  # points per thread
CUDA_RUN = 4
SCALE_ITERATIONS = 3
HALF_COST_SQUARED = 9.0  # squared: costs reach one half at three standard deviations
FIRST_SCALE = 0.1  # squared voxel edges: scale of the last ICP of LiDAR odometry
MIN_SCALE = 2.0e-4  # likewise: a synthetic noise-free scan has no spread
RISE_COLUMNS = 4


@kernel
def weigh_squares_kernel(
    squares: array(dtype=float32, ndim=2), run: int, scales: array(dtype=float64), rows: array(dtype=float64, ndim=2)
):
    """Weighted squares of one run at the first pose, and their weights."""
    i = tid()
    count = squares.shape[1]
    scale = scales[0]
    total = float64(0.0)
    weight = float64(0.0)
    for j in range(i * run, i * run + min(run, count - i * run)):
        square = float64(squares[0, j])
        if square >= 0.0:
            root = scale / (scale + square)
            total += root * root * square
            weight += root * root
    rows[i, 0] = total
    rows[i, 1] = weight


@kernel
def scale_costs_kernel(rows: array(dtype=float64, ndim=2), min_scale: float64, scales: array(dtype=float64)):
    i = tid()
    total = float64(0.0)
    weight = float64(0.0)
    for j in range(rows.shape[0]):
        total += rows[j, 0]
        weight += rows[j, 1]
    if weight > 0.0:
        scales[i] = max(min_scale, min(scales[i], float64(HALF_COST_SQUARED) * total / weight))


@kernel
def compare_squares_kernel(
    squares: array(dtype=float32, ndim=2), run: int, scales: array(dtype=float64), rows: array(dtype=float64, ndim=3)
):
    """Of one run at one pose: cost differences, their squares, pair count and improvement."""
    i = tid()
    count = squares.shape[1]
    runs = (count + run - 1) // run
    k = i // runs
    r = i % runs
    scale = scales[0]
    total = float64(0.0)
    square = float64(0.0)
    pairs = float64(0.0)
    gained = float64(0.0)
    for j in range(r * run, r * run + min(run, count - r * run)):
        a = float64(squares[0, j])
        b = float64(squares[k, j])
        if a >= 0.0 and b >= 0.0:
            d = b / (scale + b) - a / (scale + a)
            total += d
            square += d * d
            pairs += 1.0
            gained += max(-d, 0.0)
    rows[k, r, 0] = total
    rows[k, r, 1] = square
    rows[k, r, 2] = pairs
    rows[k, r, 3] = gained


@kernel
def add_runs_kernel(rows: array(dtype=float64, ndim=3), sums: array(dtype=float64, ndim=2)):
    i = tid()
    k = i // RISE_COLUMNS
    column = i % RISE_COLUMNS
    total = float64(0.0)
    for r in range(rows.shape[1]):
        total += rows[k, r, column]
    sums[k, column] = total


def run_length(squares: Array2[float32]) -> int:
    return CUDA_RUN if squares.device.is_cuda else CPU_RUN


def compare_costs(squares: Array2[float32], voxel_size: float) -> np.ndarray:
    """Compare costs of poses with the first, float64 (k, 4), from squared plane distances [m^2] (-1: none). One sync.
    Columns: sum of cost differences (costs 0..1), of their squares, points with a plane at both, sum of improvements.
    """
    device, (k, count), run = squares.device, squares.shape, run_length(squares)
    runs = -(-count // run)
    first, min_scale = (scale * voxel_size * voxel_size for scale in (FIRST_SCALE, MIN_SCALE))
    scales, weights = full(1, first, float64, device), empty((runs, 2), float64, device)
    for _ in range(SCALE_ITERATIONS):
        launch(weigh_squares_kernel, runs, [squares, run, scales, weights])
        launch(scale_costs_kernel, 1, [weights, min_scale, scales])
    rows, sums = empty((k, runs, RISE_COLUMNS), float64, device), empty((k, RISE_COLUMNS), float64, device)
    launch(compare_squares_kernel, k * runs, [squares, run, scales, rows])
    launch(add_runs_kernel, k * RISE_COLUMNS, [rows, sums])
    return download(sums)  # sync
