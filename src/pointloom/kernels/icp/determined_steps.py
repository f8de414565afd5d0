"""Gauss-Newton step without undetermined motions.

Undetermined directions are eigenvectors of the normal matrix about the center of the pairs, with rotations scaled to
lengths (Zhang, Kaess and Singh 2016, "solution remapping"). Float64. On CUDA lanes share the slow parts.
"""

from ..algebra.rigid_solve import (
    UNKNOWN_COUNT,
    diagonalize,
    diagonalize_three,
    factor_system,
    full_matrix,
    solve_system,
    square,
    triangle,
    triangle_index,
    vec6d,
)
from ..lang import (
    array,
    bits_float,
    cross,
    cuda_func,
    float64,
    float_bits,
    func,
    int32,
    lane,
    mat33d,
    shuffle,
    vec3d,
    vector,
)
from .centered_systems import about, vector_about
from .job_states import free_directions
from .rows import SPREAD_AT, row_sums

EXPONENT_BITS = 0x7F80_0000  # exponent bits of a float32
eighteen = vector(18, float64)


@func
def triangle_of(matrix: square) -> triangle:
    h = triangle(0.0)
    for i in range(6):
        for j in range(6):
            if j >= i:
                h[triangle_index(i, j)] = matrix[i * UNKNOWN_COUNT + j]
    return h


@func
def trace_of_inverse(matrix: square) -> float64:
    """Trace of the inverse of a 6x6 matrix by LDL^T, huge if singular."""
    a = factor_system(triangle_of(matrix))
    trace = float64(0.0)
    for k in range(6):
        x = vec6d(0.0)
        x[k] = 1.0
        for j in range(6):
            if j > k:
                v = float64(0.0)
                for m in range(j):
                    if m >= k:
                        v -= a[j * UNKNOWN_COUNT + m] * x[m]
                x[j] = v
        for j in range(6):
            if j >= k:
                if a[j * UNKNOWN_COUNT + j] > 0.0:
                    x[j] = x[j] / a[j * UNKNOWN_COUNT + j]
                else:
                    x[j] = 0.0
        for step in range(6):
            j = UNKNOWN_COUNT - 1 - step
            if j >= k:
                v = x[j]
                for m in range(6):
                    if m > j:
                        v -= a[m * UNKNOWN_COUNT + j] * x[m]
                x[j] = v
        if x[k] > 0.0:
            trace += x[k]
        else:
            trace += 1.0e300
    return trace


@func
def determined_step(
    h: triangle,
    g: vec6d,
    geometry: square,
    center: vec3d,
    size: float64,
    min_eigenvalue: float64,
    job: int,
    free_counts: array(dtype=int32),
    free_ones: array(dtype=free_directions),
) -> vec6d:
    """Step along the determined eigenvectors of the geometry about a center. The others are stored as free."""
    directions = free_directions(0.0)
    n = int(UNKNOWN_COUNT)  # loops over a variable are not unrolled: few jobs use this
    system = diagonalize(geometry, UNKNOWN_COUNT)
    largest = float64(0.0)
    for k in range(n):
        largest = max(largest, system[36 + k])
    b = vector_about(g, center, size)
    # the system along the eigenvectors. A free one keeps an empty row, which the solve skips
    a = about(h, center, size)
    along = square(0.0)
    right = vec6d(0.0)
    free = 0
    for k in range(n):
        if system[36 + k] > min_eigenvalue * largest:
            product = vec6d(0.0)
            for i in range(n):
                right[k] = right[k] - b[i] * system[i * UNKNOWN_COUNT + k]
                for j in range(n):
                    product[i] = product[i] + a[i * UNKNOWN_COUNT + j] * system[j * UNKNOWN_COUNT + k]
            for other in range(n):
                if system[36 + other] > min_eigenvalue * largest:
                    for i in range(n):
                        at = other * UNKNOWN_COUNT + k
                        along[at] = along[at] + product[i] * system[i * UNKNOWN_COUNT + other]
        else:
            for i in range(n):
                directions[free * UNKNOWN_COUNT + i] = system[i * UNKNOWN_COUNT + k]
            free += 1
    free_counts[job] = free
    free_ones[job] = directions
    x = solve_system(triangle_of(along), right)
    y = vec6d(0.0)
    for k in range(n):
        for i in range(n):
            y[i] = y[i] + x[k] * system[i * UNKNOWN_COUNT + k]
    turning = vec3d(y[0] / size, y[1] / size, y[2] / size)
    shift = cross(center, turning)  # back to the origin: v = v' + c x w
    return vec6d(turning[0], turning[1], turning[2], y[3] + shift[0], y[4] + shift[1], y[5] + shift[2])


@func
def power_of_two_below(size: float64) -> float64:
    """Largest power of two up to a size. 1 if float32 has none."""
    power = float64(bits_float(float_bits(float(size)) & EXPONENT_BITS))
    if not (power > 0.0 and power - power == 0.0):
        power = 1.0
    return power


@func
def in_lengths(h: triangle, inverse: float64) -> triangle:
    """Normal matrix with rotations in another unit, whose inverse is given."""
    scaled = triangle(0.0)
    for i in range(6):
        for j in range(6):
            if j >= i:
                entry = h[triangle_index(i, j)]
                if i < 3:
                    entry = entry * inverse
                if j < 3:
                    entry = entry * inverse
                scaled[triangle_index(i, j)] = entry
    return scaled


@func
def turning_in_lengths(x: vec6d, inverse: float64) -> vec6d:
    """Convert a step or right side likewise; applying it again converts back."""
    return vec6d(x[0] * inverse, x[1] * inverse, x[2] * inverse, x[3], x[4], x[5])


@func
def solve_in_lengths(h: triangle, g: vec6d, size: float64) -> vec6d:
    """Solve H x = -g with rotations in units of the cloud's size (a power of two), so that pivots are unit-free."""
    inverse = 1.0 / power_of_two_below(size)
    return turning_in_lengths(solve_system(in_lengths(h, inverse), turning_in_lengths(-g, inverse)), inverse)


@func
def constrained_step(
    h: triangle,
    g: vec6d,
    geometry: triangle,
    center: vec3d,
    size: float64,
    min_eigenvalue: float64,
    job: int,
    free_counts: array(dtype=int32),
    free_ones: array(dtype=free_directions),
) -> vec6d:
    """Solve H x = -g without the undetermined directions of the geometry, which are stored. Their eigenvalues are below
    `min_eigenvalue` of the largest. Robust weights are excluded: they depend on the distance of the clouds.
    """
    x = vec6d(0.0)
    a = about(geometry, center, size)
    trace = float64(0.0)
    for i in range(6):
        trace += a[i * UNKNOWN_COUNT + i]
    # smallest eigenvalue >= 1 / trace(A^-1), largest <= trace(A): sufficient for most jobs
    if trace_of_inverse(a) * trace * min_eigenvalue < 1.0:
        x = solve_in_lengths(h, g, size)
        free_counts[job] = 0
    else:
        x = determined_step(h, g, a, center, size, min_eigenvalue, job, free_counts, free_ones)
    return x


@cuda_func
def quotients(x: eighteen, divisor: float64) -> eighteen:
    """Divide numbers by a uniform divisor, one per lane."""
    row = lane() // 3
    column = lane() % 3
    own = x[0]
    for i in range(6):
        among = x[i * 3]
        for j in range(1, 3):
            among = x[i * 3 + j] if column == j else among
        own = among if row == i else own
    quotient = own / divisor
    divided = eighteen(0.0)
    for i in range(6):
        for j in range(3):
            divided[i * 3 + j] = shuffle(quotient, i * 3 + j)
    return divided


@cuda_func
def about_of_lanes(h: triangle, center: vec3d, size: float64) -> square:
    a = full_matrix(h)
    rows = eighteen(0.0)
    for i in range(6):
        w = cross(vec3d(a[i * UNKNOWN_COUNT + 3], a[i * UNKNOWN_COUNT + 4], a[i * UNKNOWN_COUNT + 5]), center)
        for j in range(3):
            rows[i * 3 + j] = a[i * UNKNOWN_COUNT + j] + w[j]
    rows = quotients(rows, size)
    c = a
    for i in range(6):
        for j in range(3):
            c[i * UNKNOWN_COUNT + j] = rows[i * 3 + j]
    columns = eighteen(0.0)
    for j in range(6):
        w = cross(vec3d(c[3 * UNKNOWN_COUNT + j], c[4 * UNKNOWN_COUNT + j], c[5 * UNKNOWN_COUNT + j]), center)
        for i in range(3):
            columns[i * 6 + j] = c[i * UNKNOWN_COUNT + j] + w[i]
    columns = quotients(columns, size)
    out = c
    for i in range(3):
        for j in range(6):
            out[i * UNKNOWN_COUNT + j] = columns[i * 6 + j]
    return out


@cuda_func
def solve_from(a: square, b: vec6d, first: int) -> vec6d:
    """`solve_factored` for a right side that is zero before `first`."""
    x = b * 1.0
    for j in range(6):
        v = b[j]
        for k in range(j):
            v = v - a[j * UNKNOWN_COUNT + k] * x[k] if k >= first else v
        x[j] = v
    for j in range(6):
        x[j] = x[j] / a[j * UNKNOWN_COUNT + j] if a[j * UNKNOWN_COUNT + j] > 0.0 else 0.0
    for step in range(6):
        j = UNKNOWN_COUNT - 1 - step
        v = x[j]
        for k in range(6):
            if k > j:
                v -= a[k * UNKNOWN_COUNT + j] * x[k]
        x[j] = v
    return x


@constrained_step.on_cuda
def constrained_step_of_lanes(
    h: triangle,
    g: vec6d,
    geometry: triangle,
    center: vec3d,
    size: float64,
    min_eigenvalue: float64,
    job: int,
    free_counts: array(dtype=int32),
    free_ones: array(dtype=free_directions),
) -> vec6d:
    """CUDA variant: lanes 0 to 5 solve a column of the inverse each, lane 6 the step."""
    own = lane()
    a = about_of_lanes(geometry, center, size)
    system = triangle_of(a)
    b = vec6d(0.0)
    trace = float64(0.0)
    for i in range(6):
        trace += a[i * UNKNOWN_COUNT + i]
        b[i] = float64(1.0) if own == i else 0.0
    inverse = 1.0 / power_of_two_below(size)
    first = own
    if own == UNKNOWN_COUNT:
        system = in_lengths(h, inverse)
        b = turning_in_lengths(-g, inverse)
        first = 0
    x = solve_from(factor_system(system), b, first)
    entry = x[0]
    for k in range(1, 6):
        entry = x[k] if own == k else entry
    inverse_trace = float64(0.0)
    for k in range(6):
        of_column = shuffle(entry, k)
        inverse_trace += of_column if of_column > 0.0 else 1.0e300
    solver = int(UNKNOWN_COUNT)
    if inverse_trace * trace * min_eigenvalue < 1.0:
        x = turning_in_lengths(x, inverse)
        if own == 0:
            free_counts[job] = 0
    else:
        solver = 0
        if own == 0:
            again = about(geometry, center, size)  # recomputed, so that no array has a variable index
            x = determined_step(h, g, again, center, size, min_eigenvalue, job, free_counts, free_ones)
    for i in range(6):
        x[i] = shuffle(x[i], solver)
    return x


@func
def note_free_rotations(
    sums: row_sums,
    size: float64,
    min_eigenvalue: float64,
    job: int,
    free_counts: array(dtype=int32),
    free_ones: array(dtype=free_directions),
):
    """Store the rotations that point pairs leave free, and their axes, from the inertia about the mean."""
    w = sums[0]
    mean = vec3d(sums[1] / w, sums[2] / w, sums[3] / w)
    a = mat33d(0.0)
    trace = float64(0.0)
    for i in range(3):
        for j in range(3):
            if j >= i:
                spread = (sums[SPREAD_AT + i * 3 - (i * (i - 1)) // 2 + j - i] / w - mean[i] * mean[j]) / (size * size)
                a[i, j] = -spread
                a[j, i] = -spread
                if i == j:
                    trace += spread
    for i in range(3):
        a[i, i] = a[i, i] + trace
    system = diagonalize_three(a)
    free = 0
    for k in range(3):
        free += 1 if system[9 + k] <= min_eigenvalue else 0  # translations have eigenvalue 1
    if free > 0:
        directions = free_directions(0.0)
        at = 0
        for k in range(3):
            if system[9 + k] <= min_eigenvalue:
                for i in range(3):
                    directions[at + i] = system[i * 3 + k]
                at += UNKNOWN_COUNT
        free_ones[job] = directions
    free_counts[job] = free
