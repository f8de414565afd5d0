"""Registration steps of jobs with constrained motions or a prior pose.

The system about the center of the pairs, with rotations as lengths, is reduced to an orthonormal basis Q of the free
motions. Undetermined directions are removed (Zhang, Kaess and Singh 2016), then the prior is added: the objective is
sum w r^2 + noise^2 xi^T Lambda xi, xi = (log(R R_p^T), displacement of the pivot's image). A scale is eliminated
beforehand. One float64 thread per job. Loops run over a variable so that Warp does not unroll them.
"""

from ..algebra.matrices import multiply33
from ..algebra.rigid_solve import (
    UNKNOWN_COUNT,
    diagonalize,
    rotation_about,
    solve_system,
    square,
    triangle,
    triangle_index,
    vec6d,
)
from ..lang import array, cross, dot, float64, func, int32, kernel, mat33d, mat44d, sqrt, tid, vec3d, vector
from .centered_systems import about, vector_about
from .determined_steps import trace_of_inverse, triangle_of
from .freedom import (
    SCALE_AT,
    SHIFT_AT,
    Freedom,
    change_of_logarithm,
    columns_of,
    logarithm,
    motion_state,
    pose_of_state,
    rotation_axes,
    shift_of_state,
    target_rotation_of_state,
)
from .job_states import JOB_RUNNING, NOT_FINITE, free_directions
from .matches import Matches
from .rows import COUNT_AT, RESIDUAL_AT, SPREAD_AT, mean_source, row_sums, row_system
from .step import FIT_PAIRS, Progress, StepRules, end_job, judge_job, length_of, note_step

MIN_NOISE = 1.0e-6  # of the source's spread: minimum residual, so that a prior counts beside exact pairs


@func
def free_basis(
    axes: mat33d, frame: mat33d, arm: vec3d, size: float64, free: array(dtype=int32)
) -> tuple[square, square]:
    """Basis Q of the free motions (arc length at `size`, translation at `arm` from the pivot) and R with Q R = them."""
    q = square(0.0)
    r = square(0.0)
    n = int(UNKNOWN_COUNT)
    for k in range(n):
        if free[k] != 0:
            u = vec6d(0.0)
            if k < 3:
                axis = columns_of(axes, k)
                velocity = cross(axis, arm)
                u = vec6d(axis[0] * size, axis[1] * size, axis[2] * size, velocity[0], velocity[1], velocity[2])
            else:
                axis = columns_of(frame, k - 3)
                u = vec6d(0.0, 0.0, 0.0, axis[0], axis[1], axis[2])
            for _ in range(2):  # twice is enough (Giraud et al. 2005)
                for j in range(k):
                    fraction = float64(0.0)
                    for i in range(n):
                        fraction += q[i * UNKNOWN_COUNT + j] * u[i]
                    for i in range(n):
                        u[i] = u[i] - fraction * q[i * UNKNOWN_COUNT + j]
                    r[j * UNKNOWN_COUNT + k] = r[j * UNKNOWN_COUNT + k] + fraction
            length = sqrt(dot(u, u))
            r[k * UNKNOWN_COUNT + k] = length
            for i in range(n):
                q[i * UNKNOWN_COUNT + k] = u[i] / length
    return q, r


@func
def between(left: square, matrix: square, right: square) -> square:
    half = square(0.0)
    out = square(0.0)
    n = int(UNKNOWN_COUNT)
    for i in range(n):
        for j in range(n):
            total = float64(0.0)
            for k in range(n):
                total += matrix[i * UNKNOWN_COUNT + k] * right[k * UNKNOWN_COUNT + j]
            half[i * UNKNOWN_COUNT + j] = total
    for i in range(n):
        for j in range(n):
            total = float64(0.0)
            for k in range(n):
                total += left[k * UNKNOWN_COUNT + i] * half[k * UNKNOWN_COUNT + j]
            out[i * UNKNOWN_COUNT + j] = total
    return out


@func
def along_columns(q: square, v: vec6d) -> vec6d:
    out = vec6d(0.0)
    n = int(UNKNOWN_COUNT)
    for j in range(n):
        total = float64(0.0)
        for i in range(n):
            total += q[i * UNKNOWN_COUNT + j] * v[i]
        out[j] = total
    return out


@func
def times(q: square, v: vec6d) -> vec6d:
    out = vec6d(0.0)
    n = int(UNKNOWN_COUNT)
    for i in range(n):
        total = float64(0.0)
        for j in range(n):
            total += q[i * UNKNOWN_COUNT + j] * v[j]
        out[i] = total
    return out


@func
def parameters_of(r: square, y: vec6d) -> vec6d:
    x = vec6d(0.0)
    n = int(UNKNOWN_COUNT)
    for step in range(n):
        k = n - 1 - step
        if r[k * UNKNOWN_COUNT + k] > 0.0:
            rest = y[k]
            for j in range(k + 1, n):
                rest -= r[k * UNKNOWN_COUNT + j] * x[j]
            x[k] = rest / r[k * UNKNOWN_COUNT + k]
    return x


@func
def solve_scaled(matrix: square, b: vec6d) -> vec6d:
    """Solve M x = b with M scaled to a unit diagonal. Unknowns with an empty row stay 0."""
    scales = vec6d(0.0)
    scaled = square(0.0)
    n = int(UNKNOWN_COUNT)
    for i in range(n):
        if matrix[i * UNKNOWN_COUNT + i] > 0.0:
            scales[i] = 1.0 / sqrt(matrix[i * UNKNOWN_COUNT + i])
    for i in range(n):
        for j in range(n):
            scaled[i * UNKNOWN_COUNT + j] = matrix[i * UNKNOWN_COUNT + j] * scales[i] * scales[j]
    right = vec6d(0.0)
    for i in range(n):
        right[i] = b[i] * scales[i]
    x = solve_system(triangle_of(scaled), right)
    for i in range(n):
        x[i] = x[i] * scales[i]
    return x


@func
def pair_system(sums: row_sums) -> tuple[triangle, vec6d]:
    """Point-to-point system J^T J and J^T r of r = a - b, J = (-[a]x, I), from sums."""
    h = triangle(0.0)
    x = sums[SPREAD_AT]
    y = sums[SPREAD_AT + 3]
    z = sums[SPREAD_AT + 5]
    h[0] = y + z
    h[1] = -sums[SPREAD_AT + 1]
    h[2] = -sums[SPREAD_AT + 2]
    h[triangle_index(1, 1)] = x + z
    h[triangle_index(1, 2)] = -sums[SPREAD_AT + 4]
    h[triangle_index(2, 2)] = x + y
    h[triangle_index(0, 4)] = -sums[3]
    h[triangle_index(0, 5)] = sums[2]
    h[triangle_index(1, 3)] = sums[3]
    h[triangle_index(1, 5)] = -sums[1]
    h[triangle_index(2, 3)] = -sums[2]
    h[triangle_index(2, 4)] = sums[1]
    h[triangle_index(3, 3)] = sums[0]
    h[triangle_index(4, 4)] = sums[0]
    h[triangle_index(5, 5)] = sums[0]
    g = vec6d(
        sums[14] - sums[12], sums[9] - sums[13], sums[10] - sums[8],
        sums[1] - sums[4], sums[2] - sums[5], sums[3] - sums[6],
    )  # fmt: skip
    return h, g


@func
def variance_of(sums: row_sums, method: int, rows: int, size: float64) -> float64:
    """Mean square of the residuals, at least the float32 rounding of a perfect fit."""
    total = sums[RESIDUAL_AT]
    if method == FIT_PAIRS:
        total = sums[16] + sums[17] - 2.0 * (sums[7] + sums[11] + sums[15])
    min_noise = float64(MIN_NOISE) * size
    return max(total / (float64(rows) * sums[COUNT_AT]), min_noise * min_noise)


MIN_PRIOR_FRACTION = 1.0e-12  # of the trace of the prior's information: less counts as none
SMALLEST_FACTOR = 0.5  # of the scale per step
PAIRED_MOTION = 1  # motion kinds: 0 fixed, 1 determined by pairs, 2 by the prior only, 3 undetermined
BY_PRIOR = 2
LOOSE_MOTION = 3
scale_row = vector(8, float64)  # products of a scale with the six motions and itself, and its right side


@func
def scale_system(sums: row_sums, arm: vec3d, center: vec3d, size: float64) -> scale_row:
    """Row of a scale about the pivot's image `arm`. It and `center` are relative to the origin of the sums."""
    a = vec3d(sums[1], sums[2], sums[3])
    b = vec3d(sums[4], sums[5], sums[6])
    rotation = cross(arm, a)
    shift = a - arm * sums[0]
    h = vector_about(vec6d(rotation[0], rotation[1], rotation[2], shift[0], shift[1], shift[2]), center, size)
    own = sums[16] - 2.0 * dot(arm, a) + sums[0] * dot(arm, arm)
    right = sums[16] - (sums[7] + sums[11] + sums[15]) - dot(arm, a - b)
    return scale_row(h[0], h[1], h[2], h[3], h[4], h[5], own, right)


@func
def prior_columns(q: square, moved: vec3d, arm: vec3d, size: float64) -> square:
    """Derivative of xi along a basis; `moved` is the rotation so far, `arm` leads from the pivot to the center."""
    out = square(0.0)
    n = int(UNKNOWN_COUNT)
    for k in range(n):
        w = vec3d(q[k], q[UNKNOWN_COUNT + k], q[2 * UNKNOWN_COUNT + k]) / size
        shift = cross(w, arm)
        change = change_of_logarithm(moved, w)
        for i in range(3):
            out[i * UNKNOWN_COUNT + k] = change[i]
            out[(3 + i) * UNKNOWN_COUNT + k] = q[(3 + i) * UNKNOWN_COUNT + k] - shift[i]
    return out


@func
def undetermined(
    geometry: square, reduced: square, min_eigenvalue: float64, free: array(dtype=int32)
) -> tuple[square, vec6d]:
    """Eigenvectors of a reduced system (columns) and kinds of motions. Relative to the largest of all six."""
    n = int(UNKNOWN_COUNT)
    system = diagonalize(geometry, UNKNOWN_COUNT)
    own = diagonalize(reduced, UNKNOWN_COUNT)
    largest = float64(0.0)
    for k in range(n):
        largest = max(largest, system[36 + k])
    basis = square(0.0)
    kinds = vec6d(0.0)
    for i in range(n * n):
        basis[i] = own[i]
    for k in range(n):
        if free[k] != 0:  # a fixed one has an empty row, so eigenvector k is its axis
            kinds[k] = float64(PAIRED_MOTION)
            if not (own[36 + k] > min_eigenvalue * largest):
                kinds[k] = float64(LOOSE_MOTION)
    return basis, kinds


@func
def align_with_prior(basis: square, kinds: vec6d, information: square) -> tuple[square, vec6d]:
    """Align the loose directions with the prior's information. Those it determines become BY_PRIOR."""
    n = int(UNKNOWN_COUNT)
    loose = square(0.0)
    trace = float64(0.0)
    for k in range(n):
        trace += information[k * UNKNOWN_COUNT + k]
        if kinds[k] == float64(LOOSE_MOTION):
            for i in range(n):
                loose[i * UNKNOWN_COUNT + k] = basis[i * UNKNOWN_COUNT + k]
    system = diagonalize(between(loose, information, loose), UNKNOWN_COUNT)
    aligned = basis
    aligned_kinds = kinds
    for k in range(n):
        if kinds[k] == float64(LOOSE_MOTION):
            if system[36 + k] > float64(MIN_PRIOR_FRACTION) * trace:
                aligned_kinds[k] = float64(BY_PRIOR)
            for i in range(n):
                total = float64(0.0)
                for j in range(n):
                    total += loose[i * UNKNOWN_COUNT + j] * system[j * UNKNOWN_COUNT + k]
                aligned[i * UNKNOWN_COUNT + k] = total
    return aligned, aligned_kinds


@func
def note_directions(q: square, basis: square, kinds: vec6d, job: int, freedom: Freedom, progress: Progress):
    """Store the motions that the pairs do not determine, prior-determined ones first."""
    n = int(UNKNOWN_COUNT)
    directions = free_directions(0.0)
    count = 0
    steps = int(2)
    for step in range(steps):
        wanted = float64(BY_PRIOR)
        if step == 1:
            wanted = float64(LOOSE_MOTION)
            freedom.prior_counts[job] = count
        for k in range(n):
            if kinds[k] == wanted:
                v = vec6d(0.0)
                for i in range(n):
                    v[i] = basis[i * UNKNOWN_COUNT + k]
                u = times(q, v)
                for i in range(n):
                    directions[count * UNKNOWN_COUNT + i] = u[i]
                count += 1
    progress.free_counts[job] = count
    progress.free[job] = directions


@func
def solve_partly(h: square, g: vec6d, information: square, pull: vec6d, basis: square, kinds: vec6d) -> vec6d:
    """Step from the pairs where determined, from the prior where available, else none."""
    n = int(UNKNOWN_COUNT)
    determined = square(0.0)
    paired = square(0.0)
    for k in range(n):
        for i in range(n):
            if kinds[k] == float64(PAIRED_MOTION) or kinds[k] == float64(BY_PRIOR):
                determined[i * UNKNOWN_COUNT + k] = basis[i * UNKNOWN_COUNT + k]
            if kinds[k] == float64(PAIRED_MOTION):
                paired[i * UNKNOWN_COUNT + k] = basis[i * UNKNOWN_COUNT + k]
    system = between(paired, h, paired) + between(determined, information, determined)
    right = -(along_columns(paired, g) + along_columns(determined, pull))
    return times(determined, solve_scaled(system, right))


@func
def reduced_step(
    h: square,
    g: vec6d,
    geometry: square,
    q: square,
    information: square,
    pull: vec6d,
    min_eigenvalue: float64,
    job: int,
    freedom: Freedom,
    progress: Progress,
) -> vec6d:
    """Step in a basis of the free motions from the reduced system and the prior. Stores undetermined motions."""
    n = int(UNKNOWN_COUNT)
    own = between(q, geometry, q)
    padded = own
    trace = float64(0.0)
    for k in range(n):
        trace += geometry[k * UNKNOWN_COUNT + k]
    for k in range(n):
        if freedom.free[k] == 0:
            padded[k * UNKNOWN_COUNT + k] = trace
    basis = square(0.0)
    kinds = vec6d(0.0)
    for k in range(n):
        basis[k * UNKNOWN_COUNT + k] = 1.0
        if freedom.free[k] != 0:
            kinds[k] = float64(PAIRED_MOTION)
    # the smallest eigenvalue is at least 1 / trace(A^-1), the largest at most trace(A): most jobs need no more
    if not (trace_of_inverse(padded) * trace * min_eigenvalue < 1.0):
        eigenvectors, loose = undetermined(geometry, own, min_eigenvalue, freedom.free)
        basis, kinds = align_with_prior(eigenvectors, loose, information)
    note_directions(q, basis, kinds, job, freedom, progress)
    return solve_partly(h, g, information, pull, basis, kinds)


@func
def variance_for_prior(sums: row_sums, method: int, size: float64, freedom: Freedom) -> float64:
    variance = freedom.noise * freedom.noise
    if variance == 0.0:
        variance = variance_of(sums, method, freedom.residual_count, size)
    return variance


@func
def prior_system(
    i: int, state: motion_state, q: square, arm: vec3d, size: float64, variance: float64, freedom: Freedom
) -> tuple[square, vec6d]:
    """Gauss-Newton system of the prior along a basis of free motions, times the residual variance."""
    frame = freedom.frames[0]
    moved = logarithm(
        multiply33(target_rotation_of_state(state, frame, freedom.free_rotation), freedom.prior_rotations[i])
    )
    away = freedom.shifted[i] + shift_of_state(state, frame)
    columns = prior_columns(q, moved, arm, size)
    scaled_information = freedom.information[i] * variance
    xi = vec6d(moved[0], moved[1], moved[2], away[0], away[1], away[2])
    return between(columns, scaled_information, columns), along_columns(columns, times(scaled_information, xi))


@func
def without_scale(system: square, right: vec6d, fractions: vec6d, scale: scale_row) -> tuple[square, vec6d]:
    """Eliminate the scale from a reduced system; `fractions` couples it with the basis."""
    matrix = system
    b = right
    n = int(UNKNOWN_COUNT)
    if scale[6] > 0.0:
        for k in range(n):
            b[k] = b[k] - fractions[k] * scale[7] / scale[6]
            for j in range(n):
                at = j * UNKNOWN_COUNT + k
                matrix[at] = matrix[at] - fractions[j] * fractions[k] / scale[6]
    return matrix, b


@func
def solve_constrained(i: int, rules: StepRules, progress: Progress, freedom: Freedom) -> scale_row:
    """Step of a job: changes of roll, pitch, yaw, x, y, z, 0, and log scale."""
    sums = progress.totals[i]
    size = progress.sizes[i]
    state = freedom.states[i]
    frame = freedom.frames[0]
    image = freedom.pivots[i] + shift_of_state(state, frame)
    h, g = row_system(sums)
    geometry, _ = row_system(progress.plain_totals[i])
    origin = vec3d(0.0)  # origin of the sums
    if rules.method == FIT_PAIRS:
        origin = progress.pivots[i]
        h, g = pair_system(sums)
        geometry, _ = pair_system(sums)
    middle = mean_source(sums)
    center = middle - origin
    q, r = free_basis(rotation_axes(state, frame, freedom.free_rotation), frame, middle - image, size, freedom.free)
    system = between(q, about(h, center, size), q)
    right = along_columns(q, vector_about(g, center, size))
    scale = scale_row(0.0)
    fractions = vec6d(0.0)
    if rules.scaling == 1:
        scale = scale_system(sums, image - origin, center, size)
        fractions = along_columns(q, vec6d(scale[0], scale[1], scale[2], scale[3], scale[4], scale[5]))
        system, right = without_scale(system, right, fractions, scale)
    information = square(0.0)
    pull = vec6d(0.0)
    if freedom.informed == 1:
        variance = variance_for_prior(sums, rules.method, size, freedom)
        information, pull = prior_system(i, state, q, middle - image, size, variance, freedom)
    centered_geometry = about(geometry, center, size)
    y = reduced_step(system, right, centered_geometry, q, information, pull, rules.min_eigenvalue, i, freedom, progress)
    x = parameters_of(r, y)
    grown = float64(0.0)
    if scale[6] > 0.0:
        grown = -(scale[7] + dot(fractions, y)) / scale[6]
    return scale_row(x[0], x[1], x[2], x[3], x[4], x[5], 0.0, grown)


@func
def state_after(state: motion_state, x: scale_row, free_rotation: int) -> motion_state:
    after = state
    if free_rotation == 1:
        # quaternion of the small rotation (third order) times that of the rotation
        a = vec3d(x[0], x[1], x[2]) * 0.5
        b = vec3d(state[0], state[1], state[2])
        v = b + a * state[3] + cross(a, b)
        w = state[3] - dot(a, b)
        length = sqrt(dot(v, v) + w * w)
        after[3] = w / length
        for axis in range(3):
            after[axis] = v[axis] / length
    else:
        for axis in range(3):
            after[axis] = state[axis] + x[axis]
    for axis in range(3):
        after[SHIFT_AT + axis] = state[SHIFT_AT + axis] + x[3 + axis]
    after[SCALE_AT] = state[SCALE_AT] * max(1.0 + x[7], float64(SMALLEST_FACTOR))
    return after


@func
def motion_between(before: mat44d, after: mat44d) -> mat44d:
    """Motion after before^-1 of poses that may scale."""
    square_scale = before[0, 0] * before[0, 0] + before[1, 0] * before[1, 0] + before[2, 0] * before[2, 0]
    motion = rotation_about(0.0, 0.0, 0.0, 1.0)
    for i in range(3):
        rest = after[i, 3]
        for j in range(3):
            entry = after[i, 0] * before[j, 0] + after[i, 1] * before[j, 1] + after[i, 2] * before[j, 2]
            motion[i, j] = entry / square_scale
            rest -= motion[i, j] * before[j, 3]
        motion[i, 3] = rest
    return motion


@func
def move_constrained(i: int, x: scale_row, matches: Matches, progress: Progress, freedom: Freedom) -> int:
    """Update a job's pose and search margin. Returns whether the motion is finite."""
    outcome = int(JOB_RUNNING)
    state = state_after(freedom.states[i], x, freedom.free_rotation)
    pose = pose_of_state(freedom.firsts[i], freedom.pivots[i], freedom.frames[0], state, freedom.free_rotation)
    length = length_of(motion_between(matches.poses[i], pose), mean_source(progress.totals[i]), progress.sizes[i])
    if length - length == 0.0:
        freedom.states[i] = state
        matches.poses[i] = pose
        note_step(i, length, matches, progress)
    else:
        outcome = NOT_FINITE
    return outcome


@kernel
def step_constrained_kernel(rules: StepRules, matches: Matches, progress: Progress, freedom: Freedom):
    """Evaluate a live job by its sums, and take the next constrained step or stop."""
    i = tid()
    if matches.live[i] != 0:
        outcome = judge_job(i, rules, matches, progress)
        matches.earlier[i] = matches.poses[i]
        if outcome == JOB_RUNNING:
            x = solve_constrained(i, rules, progress, freedom)
            outcome = move_constrained(i, x, matches, progress, freedom)
        if outcome != JOB_RUNNING:
            end_job(i, outcome, matches, progress)
