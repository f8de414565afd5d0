"""Covariance of a pose from the distances of points to surface patches, on one thread of the host.

A robust step of the pose to the patches (iteratively reweighted least squares, weights of Geman and McClure) shows how
far the pose is from the one that they determine.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..algebra.rigid_solve import UNKNOWN_COUNT, factor_system, solve_factored, triangle, triangle_index, vec6d
from ..lang import array, float64, func, kernel, struct, tid
from ..launches import bind
from ..memory import empty, host_view

MIN_ROWS = 6  # fewer give no step
ROW_SIZE = 7  # derivatives by rotation and translation, and the distance
MIN_ROOM = 512  # rows
Matrix = NDArray[np.float64]


@struct
class PatchEquations:
    """`rows` (room, 7), `count` of them, and scratch for their `residuals`. `planes`: normal matrix of a plane with
    rotations times the lever (6, 6). `numbers`: as of `PatchNumbers`. Results: `covariance` and the `normal` matrix of
    a row (6, 6), likewise scaled, and `result`: the variance of a row [m^2], and 1 if an eigenvalue of the normal
    matrix may be below the limit.
    """

    rows: array(dtype=float64, ndim=2)
    residuals: array(dtype=float64)
    numbers: array(dtype=float64)
    planes: array(dtype=float64, ndim=2)
    covariance: array(dtype=float64, ndim=2)
    normal: array(dtype=float64, ndim=2)
    result: array(dtype=float64)

    def __init__(self, room: int) -> None:
        self.rows, self.residuals = empty((room, ROW_SIZE), float64, "cpu"), empty(room, float64, "cpu")
        self.numbers, self.result = empty(len(PatchNumbers._fields), float64, "cpu"), empty(2, float64, "cpu")
        self.planes, self.covariance, self.normal = (
            empty((UNKNOWN_COUNT, UNKNOWN_COUNT), float64, "cpu") for _ in range(3)
        )


class PatchNumbers(NamedTuple):
    """Numbers of a fit of patches, in the order in which the kernel reads them."""

    row_count: int  # patches
    lever: float  # [m] of rotations
    prior: float  # weight of the planes, in rows
    ridge: float  # relative to the normal matrix of a row
    width: float  # of the weights, relative to the median residual
    min_width: float  # [m]
    rounds: int  # of reweighting
    variance: float  # [m^2] of errors common to all rows
    step_factor: float  # of the mean squared step
    shift_factor: float  # of the outer product of the step
    limit: float  # of eigenvalues


@func
def scaled_entry(row: int, column: int, p: PatchEquations) -> float64:
    """Derivative of a row, with rotations times the lever."""
    return p.rows[row, column] / p.numbers[1] if column < 3 else p.rows[row, column]


@func
def median_residual(count: int, p: PatchEquations) -> float64:
    """Median of the absolute residuals, which it sorts (Shell 1959)."""
    gap = count // 2
    while gap > 0:
        for i in range(gap, count):
            value = p.residuals[i]
            j = i + 0
            searching = 1
            while searching == 1:
                searching = 0
                if j >= gap:
                    if p.residuals[j - gap] > value:
                        p.residuals[j] = p.residuals[j - gap]
                        j -= gap
                        searching = 1
            p.residuals[j] = value
        gap = gap // 2 if gap != 2 else 1
    return 0.5 * (p.residuals[(count - 1) // 2] + p.residuals[count // 2])


@func
def residual_after(row: int, step: vec6d, p: PatchEquations) -> float64:
    left = p.rows[row, ROW_SIZE - 1]
    for a in range(UNKNOWN_COUNT):
        left += scaled_entry(row, a, p) * step[a]
    return left


@func
def with_prior(sums: triangle, total: float64, p: PatchEquations) -> triangle:
    """The normal matrix of a row: a sum of `total` rows, with the prior of planes and the ridge."""
    h = sums
    for a in range(UNKNOWN_COUNT):
        for b in range(a, UNKNOWN_COUNT):
            k = triangle_index(a, b)
            h[k] = (sums[k] + p.numbers[2] * p.planes[a, b]) / (total + p.numbers[2])
            if a == b:
                h[k] = h[k] + p.numbers[3]
    return h


@func
def outer_sum(width: float64, step: vec6d, count: int, p: PatchEquations) -> triangle:
    """Weighted sum of the outer products of the rows. Width 0: without weights."""
    sums = triangle(0.0)
    for row in range(count):
        w = weight_of(residual_after(row, step, p), width)
        for a in range(UNKNOWN_COUNT):
            x = scaled_entry(row, a, p) * w
            for b in range(a, UNKNOWN_COUNT):
                sums[triangle_index(a, b)] = sums[triangle_index(a, b)] + x * scaled_entry(row, b, p)
    return sums


@func
def weight_of(residual: float64, width: float64) -> float64:
    w = float64(1.0)
    if width > 0.0:
        ratio = residual / width
        root = 1.0 / (1.0 + ratio * ratio)
        w = root * root
    return w


@kernel(for_cpu=True)
def fit_patches_kernel(p: PatchEquations):
    """The robust step, and the covariance of the pose. One thread."""
    thread = tid()
    count = int(p.numbers[0]) + thread
    step = vec6d(0.0)
    square = float64(0.0)
    normal = with_prior(outer_sum(0.0, step, count, p), float64(count), p)
    for _ in range(int(p.numbers[6]) if count >= MIN_ROWS else 0):
        for row in range(count):
            p.residuals[row] = abs(residual_after(row, step, p))
        width = p.numbers[4] * max(median_residual(count, p), p.numbers[5])
        total = float64(0.0)
        right = vec6d(0.0)
        for row in range(count):
            w = weight_of(residual_after(row, step, p), width)
            total += w
            for a in range(UNKNOWN_COUNT):
                right[a] = right[a] - w * scaled_entry(row, a, p) * p.rows[row, ROW_SIZE - 1]
        h = with_prior(outer_sum(width, step, count, p), total, p)
        step = solve_factored(factor_system(h), right / (total + p.numbers[2]))
        square = 0.0
        for a in range(UNKNOWN_COUNT):
            for b in range(UNKNOWN_COUNT):
                square += step[a] * h[triangle_index(min(a, b), max(a, b))] * step[b]
    variance = p.numbers[7] + p.numbers[8] * square / 6.0  # mean square of a component
    factors = factor_system(normal)
    lowered = normal
    for a in range(UNKNOWN_COUNT):
        lowered[triangle_index(a, a)] = lowered[triangle_index(a, a)] - p.numbers[10]
        unit = vec6d(0.0)
        unit[a] = 1.0
        column = solve_factored(factors, unit)
        for b in range(UNKNOWN_COUNT):
            p.covariance[a, b] = variance * column[b] + p.numbers[9] * step[a] * step[b]
            p.normal[a, b] = normal[triangle_index(min(a, b), max(a, b))]
    pivots = factor_system(lowered)
    p.result[0] = variance
    p.result[1] = 0.0
    for a in range(UNKNOWN_COUNT):
        if pivots[a * UNKNOWN_COUNT + a] <= 0.0:
            p.result[1] = 1.0


class _Fit:
    """Arrays of a fit with room for some rows, and its launch."""

    def __init__(self, room: int) -> None:
        p = PatchEquations(room)
        self.room, self.run = room, bind(fit_patches_kernel, [p])
        self.rows, self.numbers, self.planes = host_view(p.rows), host_view(p.numbers), host_view(p.planes)
        self.covariance, self.normal, self.result = host_view(p.covariance), host_view(p.normal), host_view(p.result)


_idle: list[_Fit] = []  # kept for the next call. A second thread gets another


def fit_patches(rows: Matrix, planes: Matrix, numbers: PatchNumbers) -> tuple[Matrix, Matrix, float, bool]:
    """Covariance and normal matrix of a row (6, 6), variance of a row, and True if an eigenvalue of the normal matrix
    may be below the limit. Arguments as of PatchEquations.
    """
    try:
        fit = _idle.pop()
    except IndexError:
        fit = _Fit(MIN_ROOM)
    if len(rows) > fit.room:
        fit = _Fit(2 * len(rows))
    fit.rows[: len(rows)], fit.planes[:], fit.numbers[:] = rows, planes, numbers
    fit.run()
    variance, is_weak = fit.result.tolist()
    results = fit.covariance.copy(), fit.normal.copy(), variance, bool(is_weak)
    _idle.append(fit)
    return results
