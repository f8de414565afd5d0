"""The step of a Gauss-Newton system without the motions that the pairs do not determine.

These are found by the eigenvalues of the normal matrix about the middle of the pairs, with rotations scaled by the size
of the cloud so that both are lengths, and left out of the step (Zhang, Kaess and Singh 2016, "solution remapping").
All in float64, in one thread.
"""

from ..algebra.rigid_solve import (
    UNKNOWNS,
    diagonalize,
    full_matrix,
    place_of,
    solve_system,
    square,
    triangle,
    vec6d,
)
from ..lang import bits_float, cross, float64, float_bits, func, vec3d, vector
from .rows import SPREAD_AT, row_sums

step_result = vector(43, float64)  # the step x, how many directions are free, and those: up to six unit vectors
FREE_COUNT_AT = 6
FREE_AT = 7
EXPONENT = 0x7F80_0000  # the bits of a float32 that are its power of two


@func
def about(h: triangle, center: vec3d, size: float64) -> square:
    """The 6x6 matrix about a place, rotations in units of length: B^T H B with B = (I/s, 0; [c]x/s, I)."""
    n = int(UNKNOWNS)
    a = full_matrix(h)
    c = square(float64(0.0))
    for i in range(n):  # C = A B
        for j in range(3):
            c[i * UNKNOWNS + 3 + j] = a[i * UNKNOWNS + 3 + j]
        v = vec3d(a[i * UNKNOWNS + 3], a[i * UNKNOWNS + 4], a[i * UNKNOWNS + 5])
        w = cross(v, center)  # v^T [c]x
        for j in range(3):
            c[i * UNKNOWNS + j] = (a[i * UNKNOWNS + j] + w[j]) / size
    out = square(float64(0.0))
    for j in range(n):  # B^T C
        v = vec3d(c[3 * UNKNOWNS + j], c[4 * UNKNOWNS + j], c[5 * UNKNOWNS + j])
        w = cross(v, center)
        for i in range(3):
            out[i * UNKNOWNS + j] = (c[i * UNKNOWNS + j] + w[i]) / size
            out[(3 + i) * UNKNOWNS + j] = v[i]
    return out


@func
def triangle_of(matrix: square) -> triangle:
    """The upper triangle of a 6x6 matrix."""
    h = triangle(float64(0.0))
    n = int(UNKNOWNS)
    for i in range(n):
        for j in range(i, n):
            h[place_of(i, j)] = matrix[i * UNKNOWNS + j]
    return h


@func
def trace_of_inverse(matrix: square) -> float64:
    """The trace of the inverse of a 6x6 matrix by columns of its LDL^T solve; huge where it has none."""
    n = int(UNKNOWNS)
    h = triangle_of(matrix)
    trace = float64(0.0)
    for k in range(n):
        e = vec6d(float64(0.0))
        e[k] = float64(1.0)
        x = solve_system(h, e)
        if x[k] > float64(0.0):
            trace += x[k]
        else:
            trace += float64(1.0e300)
    return trace


@func
def determined_step(
    h: triangle, g: vec6d, geometry: square, center: vec3d, size: float64, least: float64
) -> step_result:
    """The step along the eigenvectors of the geometry about a place that it determines; the others are free."""
    result = step_result(float64(0.0))
    n = int(UNKNOWNS)
    system = diagonalize(geometry, UNKNOWNS)
    largest = float64(0.0)
    for k in range(n):
        largest = max(largest, system[36 + k])
    v = vec3d(g[3], g[4], g[5])
    w = cross(v, center)
    b = vec6d((g[0] + w[0]) / size, (g[1] + w[1]) / size, (g[2] + w[2]) / size, g[3], g[4], g[5])
    # the system along the eigenvectors; a free one keeps an empty row, which the solve passes over
    a = about(h, center, size)
    along = square(float64(0.0))
    right = vec6d(float64(0.0))
    free = int(0)
    for k in range(n):
        if system[36 + k] > least * largest:
            product = vec6d(float64(0.0))
            for i in range(n):
                right[k] = right[k] - b[i] * system[i * UNKNOWNS + k]
                for j in range(n):
                    product[i] = product[i] + a[i * UNKNOWNS + j] * system[j * UNKNOWNS + k]
            for other in range(n):
                if system[36 + other] > least * largest:
                    for i in range(n):
                        at = other * UNKNOWNS + k
                        along[at] = along[at] + product[i] * system[i * UNKNOWNS + other]
        else:
            for i in range(n):
                result[FREE_AT + free * UNKNOWNS + i] = system[i * UNKNOWNS + k]
            free += 1
    x = solve_system(triangle_of(along), right)
    y = vec6d(float64(0.0))
    for k in range(n):
        for i in range(n):
            y[i] = y[i] + x[k] * system[i * UNKNOWNS + k]
    turning = vec3d(y[0] / size, y[1] / size, y[2] / size)
    shift = cross(center, turning)  # back about the origin: v = v' + c x w
    for i in range(3):
        result[i] = turning[i]
        result[3 + i] = y[3 + i] + shift[i]
    result[FREE_COUNT_AT] = float64(free)
    return result


@func
def power_of_two_below(size: float64) -> float64:
    """The largest power of two up to a size; 1 where float32 holds none."""
    power = float64(bits_float(float_bits(float(size)) & EXPONENT))
    if not (power > float64(0.0) and power - power == float64(0.0)):
        power = float64(1.0)
    return power


@func
def solve_in_lengths(h: triangle, g: vec6d, size: float64) -> vec6d:
    """The x with H x = -g, rotations in units of about the cloud's size, so that no unit of length decides on a pivot.

    The unit is a power of two: no number is rounded otherwise than in metres.
    """
    n = int(UNKNOWNS)
    unit = power_of_two_below(size)
    scaled = triangle(float64(0.0))
    b = -g
    for i in range(n):
        for j in range(i, n):
            entry = h[place_of(i, j)]
            if i < 3:
                entry = entry / unit
            if j < 3:
                entry = entry / unit
            scaled[place_of(i, j)] = entry
    for i in range(3):
        b[i] = b[i] / unit
    x = solve_system(scaled, b)
    for i in range(3):
        x[i] = x[i] / unit
    return x


@func
def constrained_step(
    h: triangle, g: vec6d, geometry: triangle, center: vec3d, size: float64, least: float64
) -> step_result:
    """The step x with H x = -g, without the directions that the geometry does not determine.

    Those are the eigenvectors of the matrix without robust weights, whose eigenvalue is below `least` of the largest:
    how firmly clouds hold each other does not depend on how far they still are apart.
    """
    result = step_result(float64(0.0))
    n = int(UNKNOWNS)
    a = about(geometry, center, size)
    trace = float64(0.0)
    for i in range(n):
        trace += a[i * UNKNOWNS + i]
    # the smallest eigenvalue is at least 1 / trace(A^-1), the largest at most trace(A): most jobs need no more
    if trace_of_inverse(a) * trace * least < float64(1.0):
        x = solve_in_lengths(h, g, size)
        for i in range(n):
            result[i] = x[i]
    else:
        result = determined_step(h, g, a, center, size, least)
    return result


@func
def free_rotations(sums: row_sums, size: float64, least: float64) -> step_result:
    """How many rotations pairs of points leave open, and their axes, where `constrained_step` has them.

    The information of a rotation is the inertia of the points about their mean: none about the line that all lie on.
    """
    result = step_result(float64(0.0))
    w = sums[0]
    mean = vec3d(sums[1] / w, sums[2] / w, sums[3] / w)
    a = square(float64(0.0))
    trace = float64(0.0)
    at = int(SPREAD_AT)
    for i in range(3):
        for j in range(i, 3):
            spread = (sums[at] / w - mean[i] * mean[j]) / (size * size)
            a[i * 3 + j] = -spread
            a[j * 3 + i] = -spread
            if i == j:
                trace += spread
            at += 1
    for i in range(3):
        a[i * 4] = a[i * 4] + trace
    system = diagonalize(a, 3)
    free = int(0)
    for k in range(3):
        if system[36 + k] <= least:  # translations have 1
            for i in range(3):
                result[FREE_AT + free * UNKNOWNS + i] = system[i * 3 + k]
            free += 1
    result[FREE_COUNT_AT] = float64(free)
    return result
