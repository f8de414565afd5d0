"""From the sums over its correspondences to the next pose of each job: test of convergence, solve, update.

One thread a job, everything in float64. Directions of motion that the pairs do not determine are found by the
eigenvalues of the normal matrix about the middle of the pairs, with rotations scaled by the size of the cloud so that
both are lengths, and left out of the step (Zhang, Kaess and Singh 2016, "solution remapping").
"""

from ..algebra.rigid_solve import (
    UNKNOWNS,
    diagonalize,
    euler_motion,
    fit_pose,
    full_matrix,
    move,
    pair_sums,
    place_of,
    rotation_about,
    solve_system,
    square,
    triangle,
    vec6d,
)
from ..lang import (
    array,
    atan2,
    atomic_add,
    cross,
    float32,
    float64,
    func,
    int32,
    kernel,
    mat44d,
    sqrt,
    tid,
    vec3d,
    vector,
)
from .rows import COUNT_AT, DISTANCE_AT, SOURCE_AT, SPREAD_AT, TARGET_AT, row_sums

RUNNING = 0  # what became of a job
CONVERGED = 1
OUT_OF_ITERATIONS = 2
NO_PAIRS = 3
NOT_FINITE = 4

GAUSS_NEWTON = 0  # how a pose comes from the sums
PAIRS = 1  # the best fit of pairs
SYMMETRIC = 2

free_directions = vector(36, float64)  # up to six unit vectors, one a row
step_result = vector(43, float64)  # the step x, how many directions are free, and those
LOOK_AHEAD = 4.0  # steps that a match should outlast: each takes up to twice its length from the gap
WIDEST_LOOK = 2.0  # of the rmse: beyond this a wider search costs more than it saves


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
        x = solve_system(h, -g)
        for i in range(n):
            result[i] = x[i]
    else:
        system = diagonalize(a, UNKNOWNS)
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
                    result[7 + free * UNKNOWNS + i] = system[i * UNKNOWNS + k]
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
        result[6] = float64(free)
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
                result[7 + free * UNKNOWNS + i] = system[i * 3 + k]
            free += 1
    result[6] = float64(free)
    return result


@func
def center_symmetric(sums: row_sums) -> row_sums:
    """The symmetric system about the means of its points: C H0 C^T and C (g0 - H0 (0, gap)), C = (I, -[s]x; 0, I)."""
    n = int(UNKNOWNS)
    count = sums[COUNT_AT]
    p = vec3d(sums[SOURCE_AT] / count, sums[SOURCE_AT + 1] / count, sums[SOURCE_AT + 2] / count)
    q = vec3d(sums[TARGET_AT] / count, sums[TARGET_AT + 1] / count, sums[TARGET_AT + 2] / count)
    s = p + q
    gap = p - q
    h = triangle(float64(0.0))
    for j in range(21):
        h[j] = sums[j]
    a = full_matrix(h)
    g = vec6d(float64(0.0))
    for i in range(n):
        g[i] = sums[21 + i] - a[i * UNKNOWNS + 3] * gap[0] - a[i * UNKNOWNS + 4] * gap[1] - a[i * UNKNOWNS + 5] * gap[2]
    c = square(float64(0.0))
    for j in range(n):  # C A: rotation rows lose s x (translation rows)
        v = vec3d(a[3 * UNKNOWNS + j], a[4 * UNKNOWNS + j], a[5 * UNKNOWNS + j])
        w = cross(s, v)
        for i in range(3):
            c[i * UNKNOWNS + j] = a[i * UNKNOWNS + j] - w[i]
            c[(3 + i) * UNKNOWNS + j] = v[i]
    out = square(float64(0.0))
    for i in range(n):  # (C A) C^T
        v = vec3d(c[i * UNKNOWNS + 3], c[i * UNKNOWNS + 4], c[i * UNKNOWNS + 5])
        w = cross(s, v)
        for j in range(3):
            out[i * UNKNOWNS + j] = c[i * UNKNOWNS + j] - w[j]
            out[i * UNKNOWNS + 3 + j] = v[j]
    centered = sums + row_sums(float64(0.0))
    for i in range(n):
        for j in range(i, n):
            centered[place_of(i, j)] = out[i * UNKNOWNS + j]
    v = vec3d(g[3], g[4], g[5])
    w = cross(s, v)
    for i in range(3):
        centered[21 + i] = g[i] - w[i]
        centered[24 + i] = g[3 + i]
    return centered


@func
def hold_free(x: vec6d, step: step_result, gap: vec3d, size: float64) -> vec6d:
    """The symmetric step with what takes back, along free directions, that it brings the means together."""
    held = x + vec6d(float64(0.0))
    for k in range(int(step[6])):
        at = 7 + k * UNKNOWNS
        along = step[at + 3] * gap[0] + step[at + 4] * gap[1] + step[at + 5] * gap[2]
        for i in range(3):
            held[i] = held[i] - along * step[at + i] / size
            held[3 + i] = held[3 + i] - along * step[at + 3 + i]
    return held


@func
def symmetric_motion(x: vec6d, p: vec3d, q: vec3d) -> mat44d:
    """The motion of a symmetric step: half of it turns the source, half turns back the target (eq. 11 there)."""
    size = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
    # a rotation by 2 theta about g: the quaternion (g / |g| sin theta, cos theta), along (g, 1) as tan theta = |g|
    whole = rotation_about(x[0], x[1], x[2], float64(1.0))
    # a rotation by theta: the quaternion of half the angle, along (g / |g| (1 - cos theta) / sin theta, 1)
    share = float64(0.5)
    if size > float64(1.0e-9):
        root = sqrt(float64(1.0) + size * size)
        share = (root - float64(1.0)) / (size * size)
    half = rotation_about(share * x[0], share * x[1], share * x[2], float64(1.0))
    cosine = float64(1.0) / sqrt(float64(1.0) + size * size)
    shift = move(half, vec3d(x[3] * cosine, x[4] * cosine, x[5] * cosine))
    turned = move(whole, p)
    for i in range(3):
        whole[i, 3] = q[i] + shift[i] - turned[i]
    return whole


@kernel
def measure_velocities_kernel(poses: array(dtype=mat44d), period: float64, velocities: array(dtype=vec6d)):
    """The motion of a pose over a period: minus its Euler angles (of Rz Ry Rx) and its translation, a second."""
    i = tid()
    T = poses[i]
    x = atan2(T[2, 1], T[2, 2])
    y = atan2(-T[2, 0], sqrt(T[0, 0] * T[0, 0] + T[1, 0] * T[1, 0]))
    z = atan2(T[1, 0], T[0, 0])
    velocities[i] = vec6d(-x, -y, -z, -T[0, 3], -T[1, 3], -T[2, 3]) / period


@kernel
def step_jobs_kernel(
    method: int,
    scaling: int,
    most_iterations: int,
    least_fitness: float64,
    least_rmse: float64,
    least_eigenvalue: float64,
    totals: array(dtype=row_sums),
    plain_totals: array(dtype=row_sums),
    pivots: array(dtype=vec3d),
    sizes: array(dtype=float64),
    source_counts: array(dtype=float64),
    poses: array(dtype=mat44d),
    earlier: array(dtype=mat44d),
    margins: array(dtype=float32),
    fitness: array(dtype=float64),
    rmse: array(dtype=float64),
    iterations: array(dtype=int32),
    live: array(dtype=int32),
    outcomes: array(dtype=int32),
    free_counts: array(dtype=int32),
    free: array(dtype=free_directions),
    running: array(dtype=int32),
):
    """Judge the pose of a live job by its sums, and take the next step or stop."""
    i = tid()
    if live[i] != 0:
        sums = totals[i]
        count = sums[COUNT_AT]
        share = float64(0.0)
        error = float64(0.0)
        if count > float64(0.0):
            share = count / source_counts[i]
            error = sqrt(sums[DISTANCE_AT] / count)
        outcome = int(RUNNING)
        if count == float64(0.0):
            outcome = NO_PAIRS
        if outcome == RUNNING and iterations[i] > 0:
            if abs(share - fitness[i]) < least_fitness and abs(error - rmse[i]) < least_rmse:
                outcome = CONVERGED
        if outcome == RUNNING and iterations[i] >= most_iterations:
            outcome = OUT_OF_ITERATIONS
        fitness[i] = share
        rmse[i] = error
        pose = poses[i]
        earlier[i] = pose
        if outcome == RUNNING:
            p = vec3d(sums[SOURCE_AT] / count, sums[SOURCE_AT + 1] / count, sums[SOURCE_AT + 2] / count)
            q = vec3d(sums[TARGET_AT] / count, sums[TARGET_AT + 1] / count, sums[TARGET_AT + 2] / count)
            motion = euler_motion(vec6d(float64(0.0)))
            step = step_result(float64(0.0))
            if method == PAIRS:
                pairs = pair_sums(float64(0.0))
                for j in range(18):
                    pairs[j] = sums[j]
                motion = fit_pose(pairs, scaling)
                step = free_rotations(sums, sizes[i], least_eigenvalue)
                turned = move(motion, -pivots[i])  # the pairs were taken about the pivot
                for axis in range(3):
                    motion[axis, 3] = turned[axis] + pivots[i][axis]
            else:
                center = p + vec3d(float64(0.0), float64(0.0), float64(0.0))
                plain = plain_totals[i]
                size = sizes[i]
                if method == SYMMETRIC:
                    sums = center_symmetric(sums)
                    plain = center_symmetric(plain)
                    center = vec3d(float64(0.0), float64(0.0), float64(0.0))
                    size = float64(2.0) * size  # its rows hold p + q, its rotation half the angle
                h = triangle(float64(0.0))
                geometry = triangle(float64(0.0))
                for j in range(21):
                    h[j] = sums[j]
                    geometry[j] = plain[j]
                g = vec6d(sums[21], sums[22], sums[23], sums[24], sums[25], sums[26])
                step = constrained_step(h, g, geometry, center, size, least_eigenvalue)
                x = vec6d(step[0], step[1], step[2], step[3], step[4], step[5])
                if method == SYMMETRIC:
                    x = hold_free(x, step, q - p, size)
                    motion = symmetric_motion(x, p, q)
                else:
                    motion = euler_motion(x)
            free_counts[i] = int(step[6])
            directions = free_directions(float64(0.0))
            for j in range(36):
                directions[j] = step[7 + j]
            free[i] = directions
            moved = move(motion, p) - p
            turned_by = float64(0.0)
            for row in range(3):
                for column in range(3):
                    entry = motion[row, column]
                    if row == column:
                        entry = entry - float64(1.0)
                    turned_by += entry * entry
            length = sqrt(moved[0] * moved[0] + moved[1] * moved[1] + moved[2] * moved[2])
            length += sqrt(turned_by) * sizes[i]
            if length - length == float64(0.0):
                poses[i] = motion @ pose
                iterations[i] = iterations[i] + 1
                look = float64(0.0)
                if length * float64(LOOK_AHEAD) < float64(WIDEST_LOOK) * error:
                    look = length * float64(LOOK_AHEAD)
                margins[i] = float(look)
            else:
                outcome = NOT_FINITE
        if outcome != RUNNING:
            outcomes[i] = outcome
            live[i] = 0
            atomic_add(running, 0, -1)  # a count: the order does not matter
