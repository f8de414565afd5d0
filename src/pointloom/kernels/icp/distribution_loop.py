"""Gauss-Newton loop of the normal distributions transform of one pair of clouds, without sync on CUDA.

An iteration is a reduction over the source and a step. The loop ends after a short step, after a small change of the
mean residual, or after a number of steps. Its last iteration only evaluates the pose.
"""

from typing import NamedTuple

import numpy as np

from ..algebra.matrices import multiply44
from ..algebra.rigid_solve import UNKNOWN_COUNT, vec6d
from ..array_types import Points
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import SideBySide
from ..lang import (
    WARP,
    array,
    cross,
    float64,
    func,
    int32,
    kernel,
    launch,
    loop_while,
    mat44d,
    reduce_segments,
    sqrt,
    struct,
    tid,
    vec3d,
)
from ..memory import full, zeros
from .determined_steps import constrained_step
from .job_states import FEW_PAIRS, JOB_CONVERGED, JOB_RUNNING, NO_PAIRS, NOT_FINITE, OUT_OF_ITERATIONS, free_directions
from .normal_distributions import RESIDUALS_AT, NormalDistributions, sum_distribution_rows
from .rows import COUNT_AT, DISTANCE_AT, RESIDUAL_AT, mean_source, row_sums, row_system
from .step import about_pivot, broadcast_from_leader, job_of, leads, motion_of_angles

MIN_MEAN_RESIDUAL = 2.0**-52  # smallest mean residual that a change is compared with


class StopCriteria(NamedTuple):
    """Limits of a step (rad, m), of the relative change of the mean residual, and of the iterations."""

    min_step: float
    min_change: float
    max_iterations: int


@struct
class DistributionLoop:
    """State of the loop. It stops if a step is shorter than `min_step` (rad, m) or the mean residual changes by less
    than the fraction `min_change`. Motions whose eigenvalue by the shapes is less than `min_eigenvalue` of the largest
    are free, with rotations in units of the source's `size` [m].
    """

    totals: array(dtype=row_sums)
    shape_totals: array(dtype=row_sums)
    poses: array(dtype=mat44d)
    iterations: array(dtype=int32)
    outcomes: array(dtype=int32)
    is_last: array(dtype=int32)
    residuals: array(dtype=float64)
    fitness: array(dtype=float64)
    rmse: array(dtype=float64)
    free_counts: array(dtype=int32)
    free: array(dtype=free_directions)
    running: array(dtype=int32)
    source_count: float64
    size: float64
    min_eigenvalue: float64
    min_step: float64
    min_change: float64
    max_iterations: int

    def __init__(
        self,
        source: Points,
        target: NormalDistributions,
        pose: np.ndarray,
        *,
        finite_count: int,
        size: float,
        min_eigenvalue: float,
        criteria: StopCriteria,
    ) -> None:
        self.device, self.source, self.target = source.device, source, target
        self.source_count, self.size, self.min_eigenvalue = float(max(finite_count, 1)), size, min_eigenvalue
        self.min_step, self.min_change, self.max_iterations = criteria
        values = {
            "poses": (pose[None], mat44d),
            "iterations": (np.zeros(1), int32),
            "outcomes": (np.full(1, JOB_RUNNING), int32),
            "is_last": (np.zeros(1), int32),
            "residuals": (np.zeros(1), float64),
            "fitness": (np.zeros(1), float64),
            "rmse": (np.zeros(1), float64),
            "free_counts": (np.zeros(1), int32),
            "free": (np.zeros((1, 36)), free_directions),
            "running": (np.ones(1), int32),
        }
        self.states = SideBySide(values, self.device)
        vars(self).update(self.states.arrays)
        self.totals = zeros(1, row_sums, self.device)
        self.shape_totals = zeros(1, row_sums, self.device) if min_eigenvalue > 0 else self.totals

    def run(self) -> None:
        target = self.target
        blocks = SegmentBlocks([0], [self.source.size], self.device)
        partials, live = blocks.partials(row_sums), full(1, 1, int32, self.device)
        threads = WARP if self.device.is_cuda else 1

        def iterate() -> None:
            arguments = [self.source, self.poses, target]
            weighted = [*arguments, target.information]
            reduce_segments(sum_distribution_rows, blocks, live, weighted, partials, self.totals)
            if self.shape_totals is not self.totals:
                weighted = [*arguments, target.shapes]
                reduce_segments(sum_distribution_rows, blocks, live, weighted, partials, self.shape_totals)
            launch(step_distributions_kernel, threads, [self])

        loop_while(self.running, iterate)


@func
def judge_sums(job: int, state: DistributionLoop) -> int:
    """Store fitness, rmse and the mean residual of the pose. Returns whether the loop continues or how it ends."""
    sums = state.totals[job]
    count = sums[COUNT_AT]
    outcome = int(JOB_RUNNING)
    if state.is_last[job] == 1:
        outcome = JOB_CONVERGED
    total = float64(0.0)
    for j in range(36):
        total += sums[j]
    if count == 0.0:
        outcome = NO_PAIRS
    elif total - total != 0.0:
        outcome = NOT_FINITE
    elif outcome == JOB_RUNNING and sums[RESIDUALS_AT] < float64(UNKNOWN_COUNT):
        outcome = FEW_PAIRS
    residual = sums[RESIDUAL_AT] / max(sums[RESIDUALS_AT], 1.0)
    if outcome == JOB_RUNNING and state.iterations[job] > 0:
        before = state.residuals[job]
        if abs(before - residual) < state.min_change * max(before, float64(MIN_MEAN_RESIDUAL)):
            outcome = JOB_CONVERGED
    if outcome == JOB_RUNNING and state.iterations[job] >= state.max_iterations:
        outcome = OUT_OF_ITERATIONS
    state.residuals[job] = residual
    state.fitness[job] = count / state.source_count
    state.rmse[job] = sqrt(sums[DISTANCE_AT] / max(count, 1.0))
    return outcome


@func
def solve_sums(job: int, state: DistributionLoop) -> vec6d:
    """Step about the mean of the paired points: rotation [rad], translation [m]. Stores free motions."""
    sums = state.totals[job]
    center = mean_source(sums)
    h, g = row_system(sums)
    shape, _ = row_system(state.shape_totals[job])
    x = constrained_step(h, g, shape, center, state.size, state.min_eigenvalue, job, state.free_counts, state.free)
    shift = cross(vec3d(x[0], x[1], x[2]), center)
    return vec6d(x[0], x[1], x[2], x[3] + shift[0], x[4] + shift[1], x[5] + shift[2])


@kernel
def step_distributions_kernel(state: DistributionLoop):
    """Evaluate the pose by its sums, and take the next step or stop."""
    i = tid()
    job = job_of(i)
    outcome = int(JOB_RUNNING)
    if leads() == 1:
        outcome = judge_sums(job, state)
    outcome = broadcast_from_leader(outcome)
    if outcome == JOB_RUNNING:
        x = solve_sums(job, state)
        outcome = broadcast_from_leader(outcome)
        motion = about_pivot(motion_of_angles(x), mean_source(state.totals[job]))
        if leads() == 1:
            square = float64(0.0)
            for j in range(6):
                square += x[j] * x[j]
            if square - square == 0.0:
                state.poses[job] = multiply44(motion, state.poses[job])
                state.iterations[job] = state.iterations[job] + 1
                if sqrt(square) < state.min_step:
                    state.is_last[job] = 1
            else:
                outcome = NOT_FINITE
    if leads() == 1 and outcome != JOB_RUNNING:
        state.outcomes[job] = outcome
        state.running[job] = 0
