"""Next pose of each job from the sums over its correspondences: convergence test, solve, update.

Float64, one thread per job (a warp on CUDA, one lane writes). Undetermined motions are left out (determined_steps.py).
Symmetric ICP (Rusinkiewicz 2019, eqs. 10 and 11): the system is moved to the means of the pairs, and half of the motion
rotates the source, half inversely the target.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..algebra.matrices import multiply44
from ..algebra.rigid_solve import (
    UNKNOWN_COUNT,
    euler_motion,
    fit_pose,
    full_matrix,
    move,
    pair_sums,
    pose_from_cosines_and_sines,
    rotation_about,
    square,
    triangle_index,
    vec6d,
)
from ..array_types import Array1
from ..lang import (
    WARP,
    array,
    atan2,
    atomic_add,
    cos,
    cross,
    dot,
    float64,
    func,
    int32,
    kernel,
    lane,
    launch,
    mat44d,
    shuffle,
    sin,
    sqrt,
    struct,
    sync_lanes,
    tid,
    vec3d,
)
from ..memory import host_view, zeros
from .determined_steps import constrained_step, note_free_rotations
from .job_states import JOB_CONVERGED, JOB_RUNNING, NO_PAIRS, NOT_FINITE, OUT_OF_ITERATIONS, free_directions
from .jobs import Jobs, first_moments
from .matches import Matches
from .rows import COUNT_AT, DISTANCE_AT, mean_source, mean_target, row_sums, row_system

if TYPE_CHECKING:
    from ..arrays.side_by_side import SideBySide


@func
def center_symmetric(sums: row_sums) -> row_sums:
    """Symmetric system about the means: C H0 C^T and C (g0 - H0 (0, gap)), C = (I, -[s]x; 0, I)."""
    p = mean_source(sums)
    q = mean_target(sums)
    s = p + q
    gap = p - q
    h, _ = row_system(sums)
    a = full_matrix(h)
    g = vec6d(0.0)
    for i in range(6):
        g[i] = (
            sums[21 + i]
            - a[i * UNKNOWN_COUNT + 3] * gap[0]
            - a[i * UNKNOWN_COUNT + 4] * gap[1]
            - a[i * UNKNOWN_COUNT + 5] * gap[2]
        )
    c = square(0.0)
    for j in range(6):  # C A: rotation rows lose s x (translation rows)
        v = vec3d(a[3 * UNKNOWN_COUNT + j], a[4 * UNKNOWN_COUNT + j], a[5 * UNKNOWN_COUNT + j])
        w = cross(s, v)
        for i in range(3):
            c[i * UNKNOWN_COUNT + j] = a[i * UNKNOWN_COUNT + j] - w[i]
            c[(3 + i) * UNKNOWN_COUNT + j] = v[i]
    out = square(0.0)
    for i in range(6):  # (C A) C^T
        v = vec3d(c[i * UNKNOWN_COUNT + 3], c[i * UNKNOWN_COUNT + 4], c[i * UNKNOWN_COUNT + 5])
        w = cross(s, v)
        for j in range(3):
            out[i * UNKNOWN_COUNT + j] = c[i * UNKNOWN_COUNT + j] - w[j]
            out[i * UNKNOWN_COUNT + 3 + j] = v[j]
    centered = sums
    for i in range(6):
        for j in range(6):
            if j >= i:
                centered[triangle_index(i, j)] = out[i * UNKNOWN_COUNT + j]
    v = vec3d(g[3], g[4], g[5])
    w = cross(s, v)
    for i in range(3):
        centered[21 + i] = g[i] - w[i]
        centered[24 + i] = g[3 + i]
    return centered


@func
def remove_free_motion(x: vec6d, count: int, free: free_directions, gap: vec3d, size: float64) -> vec6d:
    """Symmetric step without the alignment of the means along free directions."""
    step = x
    for k in range(6):
        if k < count:
            at = k * UNKNOWN_COUNT
            along = free[at + 3] * gap[0] + free[at + 4] * gap[1] + free[at + 5] * gap[2]
            for i in range(3):
                step[i] = step[i] - along * free[at + i] / size
                step[3 + i] = step[3 + i] - along * free[at + 3 + i]
    return step


@func
def symmetric_motion(x: vec6d, p: vec3d, q: vec3d) -> mat44d:
    """Motion of a symmetric step: half rotates the source, half inversely the target (eq. 11)."""
    size = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
    # rotation by 2 theta about g: quaternion (g / |g| sin theta, cos theta), parallel to (g, 1) as tan theta = |g|
    result = rotation_about(x[0], x[1], x[2], 1.0)
    # rotation by theta: the quaternion of half the angle, parallel to (g / |g| (1 - cos theta) / sin theta, 1)
    fraction = float64(0.5)
    if size > 1.0e-9:
        root = sqrt(1.0 + size * size)
        fraction = (root - 1.0) / (size * size)
    half = rotation_about(fraction * x[0], fraction * x[1], fraction * x[2], 1.0)
    cosine = 1.0 / sqrt(1.0 + size * size)
    shift = move(half, vec3d(x[3] * cosine, x[4] * cosine, x[5] * cosine))
    rotated = move(result, p)
    for i in range(3):
        result[i, 3] = q[i] + shift[i] - rotated[i]
    return result


GAUSS_NEWTON = 0  # step methods
FIT_PAIRS = 1  # best fit of pairs
FIT_SYMMETRIC = 2

LOOK_AHEAD = 4.0  # steps that a match should remain valid for: each takes up to twice its length from the gap
WIDEST_LOOK = 2.0  # of the rmse: a wider search costs more than it saves
SMALLEST_SIZE = 1.0e-12  # for a single-point source: of its distance from the origin, or [m] if that is zero


@struct
class StepRules:
    """Convergence limits `fitness_tolerance`, `rmse_tolerance` [m] plus `size_tolerance` of the source's spread;
    motions with less than `min_eigenvalue` of the largest are free.
    """

    method: int
    scaling: int
    max_iterations: int
    fitness_tolerance: float64
    rmse_tolerance: float64
    size_tolerance: float64
    min_eigenvalue: float64

    def __init__(
        self, method: int, with_scaling: bool, criteria: tuple[int, float, float, float], min_eigenvalue: float
    ) -> None:
        """`criteria` is (max iterations, fitness, rmse and size tolerance)."""
        self.method, self.scaling, self.min_eigenvalue = method, int(with_scaling), min_eigenvalue
        self.max_iterations, self.fitness_tolerance, self.rmse_tolerance, self.size_tolerance = criteria


@struct
class Progress:
    """Sums over the pairs of each job and its status. `separate_geometry`: degeneracy uses `plain_totals`,
    without robust kernels; `pivots` [m]: centers of the sources under the first pose, origins of pair sums;
    `sizes` [m].
    """

    totals: array(dtype=row_sums)
    plain_totals: array(dtype=row_sums)
    pivots: array(dtype=vec3d)
    sizes: array(dtype=float64)
    source_counts: array(dtype=float64)
    iterations: array(dtype=int32)
    fitness: array(dtype=float64)
    rmse: array(dtype=float64)
    outcomes: array(dtype=int32)
    free_counts: array(dtype=int32)
    free: array(dtype=free_directions)
    running: array(dtype=int32)

    def __init__(
        self,
        jobs: Jobs,
        states: "SideBySide",
        poses: np.ndarray,
        totals: Array1[Any],
        *,
        separate_geometry: bool = False,
    ) -> None:
        device, count = jobs.device, jobs.count
        names = ("pivots", "sizes", "source_counts", "iterations", "outcomes", "fitness", "rmse", "free_counts", "free")
        for name in (*names, "running"):
            setattr(self, name, states.arrays[name])
        self.totals = totals
        self.plain_totals = zeros(count, row_sums, device) if separate_geometry else totals
        moments = jobs.sum_moments()
        if device.is_cuda:  # avoids a sync
            launch(measure_sources_kernel, count, [jobs, moments, states.arrays["poses"], self])
            return
        means, spreads = jobs.measure_sources(moments)
        centers = np.einsum("jrc,jc->jr", poses[:, :3, :3], means) + poses[:, :3, 3]
        host_view(self.pivots)[:] = centers
        sizes = np.maximum(spreads, SMALLEST_SIZE * np.linalg.norm(means, axis=1))
        host_view(self.sizes)[:] = np.where(sizes > 0, sizes, SMALLEST_SIZE)


@kernel
def measure_sources_kernel(
    jobs: Jobs, moments: array(dtype=first_moments), poses: array(dtype=mat44d), progress: Progress
):
    """Pivot and size of each job from the sums over its source."""
    i = tid()
    sums = moments[jobs.job_sources[i]] / progress.source_counts[i]
    mean = vec3d(sums[0], sums[1], sums[2])
    square = dot(mean, mean)
    size = max(sqrt(max(sums[3] - square, 0.0)), float64(SMALLEST_SIZE) * sqrt(square))
    progress.pivots[i] = move(poses[i], mean)
    progress.sizes[i] = size if size > 0.0 else float64(SMALLEST_SIZE)


@kernel
def measure_velocities_kernel(poses: array(dtype=mat44d), period: float64, velocities: array(dtype=vec6d)):
    """Velocity of a pose over a period: negative Euler angles (Rz Ry Rx) and translation per second."""
    i = tid()
    T = poses[i]
    x = atan2(T[2, 1], T[2, 2])
    y = atan2(-T[2, 0], sqrt(T[0, 0] * T[0, 0] + T[1, 0] * T[1, 0]))
    z = atan2(T[1, 0], T[0, 0])
    velocities[i] = vec6d(-x, -y, -z, -T[0, 3], -T[1, 3], -T[2, 3]) / period


@func
def job_of(thread: int) -> int:
    return thread


@job_of.on_cuda
def job_of_lane(thread: int) -> int:
    """CUDA variant: a job per warp."""
    return thread // WARP


@func
def leads() -> int:
    """1 in the one thread of a job that writes."""
    return 1


@leads.on_cuda
def first_lane_leads() -> int:
    return 1 if lane() == 0 else 0


@func
def broadcast_from_leader(x: int) -> int:
    """Value of the writing thread; afterward its writes are visible to the job's other threads."""
    return x


@broadcast_from_leader.on_cuda
def broadcast_from_first_lane(x: int) -> int:
    sync_lanes()
    return shuffle(x, 0)


@func
def moved_size(i: int, matches: Matches, progress: Progress) -> float64:
    """Spread of a job's source [m] under its pose, which may scale."""
    pose = matches.poses[i]
    return sqrt(pose[0, 0] * pose[0, 0] + pose[1, 0] * pose[1, 0] + pose[2, 0] * pose[2, 0]) * progress.sizes[i]


@func
def judge_job(i: int, rules: StepRules, matches: Matches, progress: Progress) -> int:
    """Store fitness and rmse of a job. Returns whether it continues or how it ends."""
    sums = progress.totals[i]
    count = sums[COUNT_AT]
    fraction = float64(0.0)
    error = float64(0.0)
    if count > 0.0:
        fraction = count / progress.source_counts[i]
        error = sqrt(sums[DISTANCE_AT] / count)
    outcome = int(JOB_RUNNING)
    if count == 0.0:
        outcome = NO_PAIRS
    total = float64(0.0)
    for j in range(36):
        total += sums[j]
    if total - total != 0.0:
        outcome = NOT_FINITE  # a zero step would be mistaken for convergence
    if outcome == JOB_RUNNING and progress.iterations[i] > 0:
        tolerance = rules.rmse_tolerance + rules.size_tolerance * moved_size(i, matches, progress)
        if abs(fraction - progress.fitness[i]) < rules.fitness_tolerance and abs(error - progress.rmse[i]) < tolerance:
            outcome = JOB_CONVERGED
    if outcome == JOB_RUNNING and progress.iterations[i] >= rules.max_iterations:
        outcome = OUT_OF_ITERATIONS
    progress.fitness[i] = fraction
    progress.rmse[i] = error
    return outcome


@func
def solve_job(i: int, rules: StepRules, progress: Progress) -> vec6d:
    """Step of a job by its sums. Stores free motions."""
    step = vec6d(0.0)
    sums = progress.totals[i]
    size = progress.sizes[i]
    if rules.method == FIT_PAIRS:
        if leads() == 1:
            note_free_rotations(sums, size, rules.min_eigenvalue, i, progress.free_counts, progress.free)
    else:
        center = mean_source(sums)
        plain = progress.plain_totals[i]
        if rules.method == FIT_SYMMETRIC:
            sums = center_symmetric(sums)
            plain = center_symmetric(plain)
            center = vec3d(0.0, 0.0, 0.0)
            size = 2.0 * size  # its rows have p + q, its rotation half the angle
        h, g = row_system(sums)
        geometry, _ = row_system(plain)
        step = constrained_step(
            h, g, geometry, center, size, rules.min_eigenvalue, i, progress.free_counts, progress.free
        )
    return step


@func
def about_pivot(motion: mat44d, pivot: vec3d) -> mat44d:
    """Convert a motion of coordinates about a pivot to one about the origin."""
    moved = move(motion, -pivot)
    result = motion
    for axis in range(3):
        result[axis, 3] = moved[axis] + pivot[axis]
    return result


@func
def best_fit(sums: row_sums, pivot: vec3d, scaling: int) -> mat44d:
    pairs = pair_sums(0.0)
    for j in range(18):
        pairs[j] = sums[j]
    return about_pivot(fit_pose(pairs, scaling), pivot)


@func
def motion_of_angles(x: vec6d) -> mat44d:
    return euler_motion(x)


@motion_of_angles.on_cuda
def motion_of_lanes(x: vec6d) -> mat44d:
    """CUDA variant: lane k computes the cosine and sine of angle k."""
    own = lane()
    angle = x[0] if own == 0 else (x[1] if own == 1 else x[2])
    cosine = cos(angle)
    sine = sin(angle)
    cosines = vec3d(shuffle(cosine, 0), shuffle(cosine, 1), shuffle(cosine, 2))
    return pose_from_cosines_and_sines(x, cosines, vec3d(shuffle(sine, 0), shuffle(sine, 1), shuffle(sine, 2)))


@func
def motion_of(i: int, x: vec6d, rules: StepRules, progress: Progress) -> mat44d:
    # The linearized rotation w has an error of |w|^2 / 2 of the distance from its pivot, so that is among the pairs.
    pivot = mean_source(progress.totals[i])
    shift = cross(vec3d(x[0], x[1], x[2]), pivot)
    about = vec6d(x[0], x[1], x[2], x[3] + shift[0], x[4] + shift[1], x[5] + shift[2])
    motion = about_pivot(motion_of_angles(about), pivot)
    if rules.method == FIT_PAIRS:
        motion = best_fit(progress.totals[i], progress.pivots[i], rules.scaling)
    if rules.method == FIT_SYMMETRIC:
        p = mean_source(progress.totals[i])
        q = mean_target(progress.totals[i])
        size = 2.0 * progress.sizes[i]
        motion = symmetric_motion(remove_free_motion(x, progress.free_counts[i], progress.free[i], q - p, size), p, q)
    return motion


@func
def length_of(motion: mat44d, p: vec3d, size: float64) -> float64:
    """Displacement [m] by a motion of a cloud of some size about p. Not finite if the motion is not."""
    moved = move(motion, p) - p
    rotation_sqnorm = float64(0.0)
    for row in range(3):
        for column in range(3):
            entry = motion[row, column]
            if row == column:
                entry = entry - 1.0
            rotation_sqnorm += entry * entry
    length = sqrt(moved[0] * moved[0] + moved[1] * moved[1] + moved[2] * moved[2])
    return length + sqrt(rotation_sqnorm) * size


@func
def note_step(i: int, length: float64, matches: Matches, progress: Progress):
    """Count a step, and set the search margin for a step of this length [m]."""
    progress.iterations[i] = progress.iterations[i] + 1
    look = float64(0.0)
    if length * float64(LOOK_AHEAD) < float64(WIDEST_LOOK) * progress.rmse[i]:
        look = length * float64(LOOK_AHEAD)
    matches.margins[i] = float(look)


@func
def end_job(i: int, outcome: int, matches: Matches, progress: Progress):
    progress.outcomes[i] = outcome
    matches.live[i] = 0
    atomic_add(progress.running, 0, -1)  # integer sum: order-independent


@func
def move_job(i: int, motion: mat44d, matches: Matches, progress: Progress) -> int:
    """Update a job's pose and search margin. Returns whether the motion is finite."""
    outcome = int(JOB_RUNNING)
    length = length_of(motion, mean_source(progress.totals[i]), progress.sizes[i])
    if length - length == 0.0:
        matches.poses[i] = multiply44(motion, matches.poses[i])
        note_step(i, length, matches, progress)
    else:
        outcome = NOT_FINITE
    return outcome


@kernel
def step_jobs_kernel(rules: StepRules, matches: Matches, progress: Progress):
    """Evaluate a live job by its sums, and take the next step or stop."""
    i = tid()
    job = job_of(i)
    if matches.live[job] != 0:
        outcome = int(JOB_RUNNING)
        if leads() == 1:
            outcome = judge_job(job, rules, matches, progress)
            matches.earlier[job] = matches.poses[job]
        outcome = broadcast_from_leader(outcome)
        if outcome == JOB_RUNNING:
            step = solve_job(job, rules, progress)
            outcome = broadcast_from_leader(outcome)
            motion = motion_of(job, step, rules, progress)
            if leads() == 1:
                outcome = move_job(job, motion, matches, progress)
        if leads() == 1 and outcome != JOB_RUNNING:
            end_job(job, outcome, matches, progress)
