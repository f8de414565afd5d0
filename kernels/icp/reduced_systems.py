"""Systems of six unknowns reduced to the motions that are free: an orthonormal basis of them, and what takes its place.

Motions are (rotation as the length of its arc at a cloud's size, translation), about the middle of the pairs. Loops are
over a variable, so that Warp does not unroll them: few jobs come here. In one thread a job, in float64.
"""

from ..algebra.rigid_solve import UNKNOWNS, place_of, solve_system, square, triangle, vec6d
from ..lang import array, cross, dot, float64, func, int32, mat33d, sqrt, vec3d
from .determined_steps import triangle_of
from .freedom import columns_of
from .rows import COUNT_AT, RESIDUAL_AT, SPREAD_AT, row_sums
from .step import PAIRS

LEAST_NOISE = 1.0e-6  # of the source's spread: residuals are no smaller, so that a prior counts beside perfect pairs


@func
def free_basis(
    axes: mat33d, frame: mat33d, arm: vec3d, size: float64, free: array(dtype=int32)
) -> tuple[square, square]:
    """An orthonormal basis Q of the free motions (columns; zero where fixed), and R with Q R = the motions themselves.

    A motion is (rotation as the length of its arc at `size`, translation of the place at `arm` from the pivot).
    """
    q = square(0.0)
    r = square(0.0)
    n = int(UNKNOWNS)
    for k in range(n):
        if free[k] != 0:
            u = vec6d(0.0)
            if k < 3:
                axis = columns_of(axes, k)
                way = cross(axis, arm)
                u = vec6d(axis[0] * size, axis[1] * size, axis[2] * size, way[0], way[1], way[2])
            else:
                axis = columns_of(frame, k - 3)
                u = vec6d(0.0, 0.0, 0.0, axis[0], axis[1], axis[2])
            for _ in range(2):  # twice is enough (Giraud et al. 2005)
                for j in range(k):
                    share = float64(0.0)
                    for i in range(n):
                        share += q[i * UNKNOWNS + j] * u[i]
                    for i in range(n):
                        u[i] = u[i] - share * q[i * UNKNOWNS + j]
                    r[j * UNKNOWNS + k] = r[j * UNKNOWNS + k] + share
            length = sqrt(dot(u, u))
            r[k * UNKNOWNS + k] = length
            for i in range(n):
                q[i * UNKNOWNS + k] = u[i] / length
    return q, r


@func
def between(left: square, matrix: square, right: square) -> square:
    """L^T M R."""
    half = square(0.0)
    out = square(0.0)
    n = int(UNKNOWNS)
    for i in range(n):
        for j in range(n):
            total = float64(0.0)
            for k in range(n):
                total += matrix[i * UNKNOWNS + k] * right[k * UNKNOWNS + j]
            half[i * UNKNOWNS + j] = total
    for i in range(n):
        for j in range(n):
            total = float64(0.0)
            for k in range(n):
                total += left[k * UNKNOWNS + i] * half[k * UNKNOWNS + j]
            out[i * UNKNOWNS + j] = total
    return out


@func
def along_columns(q: square, v: vec6d) -> vec6d:
    """Q^T v."""
    out = vec6d(0.0)
    n = int(UNKNOWNS)
    for j in range(n):
        total = float64(0.0)
        for i in range(n):
            total += q[i * UNKNOWNS + j] * v[i]
        out[j] = total
    return out


@func
def times(q: square, v: vec6d) -> vec6d:
    """Q v."""
    out = vec6d(0.0)
    n = int(UNKNOWNS)
    for i in range(n):
        total = float64(0.0)
        for j in range(n):
            total += q[i * UNKNOWNS + j] * v[j]
        out[i] = total
    return out


@func
def parameters_of(r: square, y: vec6d) -> vec6d:
    """The changes of the parameters x with R x = y."""
    x = vec6d(0.0)
    n = int(UNKNOWNS)
    for step in range(n):
        k = n - 1 - step
        if r[k * UNKNOWNS + k] > 0.0:
            rest = y[k]
            for j in range(k + 1, n):
                rest -= r[k * UNKNOWNS + j] * x[j]
            x[k] = rest / r[k * UNKNOWNS + k]
    return x


@func
def solve_scaled(matrix: square, b: vec6d) -> vec6d:
    """The x with M x = b, by M with a diagonal of ones; unknowns with an empty row stay 0."""
    scales = vec6d(0.0)
    scaled = square(0.0)
    n = int(UNKNOWNS)
    for i in range(n):
        if matrix[i * UNKNOWNS + i] > 0.0:
            scales[i] = 1.0 / sqrt(matrix[i * UNKNOWNS + i])
    for i in range(n):
        for j in range(n):
            scaled[i * UNKNOWNS + j] = matrix[i * UNKNOWNS + j] * scales[i] * scales[j]
    right = vec6d(0.0)
    for i in range(n):
        right[i] = b[i] * scales[i]
    x = solve_system(triangle_of(scaled), right)
    for i in range(n):
        x[i] = x[i] * scales[i]
    return x


@func
def pair_system(sums: row_sums) -> tuple[triangle, vec6d]:
    """The Gauss-Newton system of pairs of points, J^T J and J^T r of r = a - b, J = (-[a]x, I), from their sums."""
    h = triangle(0.0)
    x = sums[SPREAD_AT]
    y = sums[SPREAD_AT + 3]
    z = sums[SPREAD_AT + 5]
    h[0] = y + z
    h[1] = -sums[SPREAD_AT + 1]
    h[2] = -sums[SPREAD_AT + 2]
    h[place_of(1, 1)] = x + z
    h[place_of(1, 2)] = -sums[SPREAD_AT + 4]
    h[place_of(2, 2)] = x + y
    h[place_of(0, 4)] = -sums[3]
    h[place_of(0, 5)] = sums[2]
    h[place_of(1, 3)] = sums[3]
    h[place_of(1, 5)] = -sums[1]
    h[place_of(2, 3)] = -sums[2]
    h[place_of(2, 4)] = sums[1]
    h[place_of(3, 3)] = sums[0]
    h[place_of(4, 4)] = sums[0]
    h[place_of(5, 5)] = sums[0]
    g = vec6d(
        sums[14] - sums[12], sums[9] - sums[13], sums[10] - sums[8],
        sums[1] - sums[4], sums[2] - sums[5], sums[3] - sums[6],
    )  # fmt: skip
    return h, g


@func
def variance_of(sums: row_sums, method: int, rows: int, size: float64) -> float64:
    """The mean square of the residuals, no less than what float32 leaves of a perfect fit."""
    total = sums[RESIDUAL_AT]
    if method == PAIRS:
        total = sums[16] + sums[17] - 2.0 * (sums[7] + sums[11] + sums[15])
    least = float64(LEAST_NOISE) * size
    return max(total / (float64(rows) * sums[COUNT_AT]), least * least)
