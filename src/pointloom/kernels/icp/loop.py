"""Batched iterative registration: three launches per iteration for all jobs, without sync on CUDA."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ..algebra.rigid_solve import TRIANGLE_NUMBERS, vec6d
from ..array_types import AnyArray, Array1, Integers
from ..lang import WARP, Reduction, int32, launch, loop_while, reduce_segments, vec3d
from ..memory import download, full, zeros
from .constrained_steps import step_constrained_kernel
from .correspondences import match_groups_kernel, match_points_kernel
from .freedom import Freedom
from .job_states import job_states, match_states
from .jobs import Jobs
from .matches import Matches, PointColumns
from .robust_weights import L2_LOSS, Loss
from .rows import COUNT_AT, DISTANCE_AT, DopplerRule, row_sums, sum_information, sum_point_rows
from .step import Progress, StepRules, measure_velocities_kernel, step_jobs_kernel
from .voxel_gaussians import VoxelGaussians, match_voxels_kernel


class Matching:
    """Pairs of all jobs under their poses. `poses`: T_target_source about the clouds' origins. Pairs closer than
    `max_distance` [m] count; `per_point`: each point searches on its own.
    """

    first_states = staticmethod(match_states)

    def __init__(
        self,
        jobs: Jobs,
        poses: np.ndarray,
        max_distance: float,
        gaussians: VoxelGaussians | None = None,
        per_point: bool | None = None,
    ) -> None:
        self.per_point = jobs.device.is_cuda if per_point is None else per_point
        self.jobs, self.gaussians = jobs, gaussians
        if gaussians is None:
            assert jobs.targets is not None
            targets, self.target_covariances = jobs.targets.clouds.points, None
        else:
            targets, self.target_covariances = gaussians.unpack()
        self.states = self.first_states(jobs, poses)
        self.matches = Matches(jobs, self.states, max_distance, targets)
        self.totals = zeros(jobs.count, row_sums, jobs.device)
        self.partials = jobs.blocks.partials(row_sums)

    def match(self) -> None:
        jobs, matches = self.jobs, self.matches
        if self.gaussians is not None:
            launch(match_voxels_kernel, matches.pairs.size, [matches, self.gaussians])
        elif self.per_point:
            threads = matches.pairs.size
            if matches.pairs.device.is_cuda:
                threads = -(-threads // WARP) * WARP  # whole warps
            launch(match_points_kernel, threads, [matches, jobs.targets])
        else:
            launch(match_groups_kernel, jobs.group_count, [matches, jobs.targets])

    def measure_pairs(self) -> tuple[np.ndarray, np.ndarray]:
        """Fitness and rmse [m] of the pairs of each job, float64 (jobs)."""
        jobs, matches = self.jobs, self.matches
        arguments = [matches, Loss(L2_LOSS, 1.0, 0.0), zeros(jobs.count, vec3d, jobs.device)]
        reduce_segments(sum_point_rows, jobs.blocks, matches.live, arguments, self.partials, self.totals)
        sums = download(self.totals)  # sync
        counts = sums[:, COUNT_AT]
        return counts / np.maximum(jobs.counts, 1), np.sqrt(sums[:, DISTANCE_AT] / np.maximum(counts, 1))

    def measure_information(self) -> np.ndarray:
        """Information of the pairs of each job about its target's origin: upper triangles, float64 (jobs, 21)."""
        jobs = self.jobs
        live = full(jobs.count, 1, int32, jobs.device)
        reduce_segments(sum_information, jobs.blocks, live, [self.matches], self.partials, self.totals)
        return download(self.totals)[:, :TRIANGLE_NUMBERS]  # sync


class RegistrationLoop(Matching):
    """Launches of an iteration over all jobs. `separate_geometry`: degeneracy by other rows than the solve."""

    first_states = staticmethod(job_states)

    def __init__(
        self,
        jobs: Jobs,
        poses: np.ndarray,
        max_distance: float,
        gaussians: VoxelGaussians | None = None,
        separate_geometry: bool = False,
        per_point: bool | None = None,
    ) -> None:
        super().__init__(jobs, poses, max_distance, gaussians, per_point)
        self.progress = Progress(jobs, self.states, poses, self.totals, separate_geometry=separate_geometry)
        self.velocities = zeros(jobs.count, vec6d, jobs.device)

    def sum_rows(
        self,
        rows: Reduction,
        arguments: Sequence[AnyArray | PointColumns | Loss | DopplerRule | float],
        plain_arguments: Sequence[Integers | Array1[Any] | PointColumns | Loss | DopplerRule | float] | None = None,
    ) -> None:
        """Sum a reduction over all pairs into `totals`; `plain_arguments` without kernels, for degeneracy."""
        blocks, matches, progress = self.jobs.blocks, self.matches, self.progress
        reduce_segments(rows, blocks, matches.live, [matches, *arguments], self.partials, progress.totals)
        if plain_arguments is not None:
            sums = progress.plain_totals
            reduce_segments(rows, blocks, matches.live, [matches, *plain_arguments], self.partials, sums)

    def measure_velocities(self, period: float) -> None:
        launch(measure_velocities_kernel, self.jobs.count, [self.matches.poses, period, self.velocities])

    def step(self, rules: StepRules, freedom: Freedom | None = None) -> None:
        """Evaluate all live jobs by StepRules and update their poses, within their Freedom if any."""
        threads = self.jobs.count
        if freedom is not None:
            launch(step_constrained_kernel, threads, [rules, self.matches, self.progress, freedom])
            return
        if self.jobs.device.is_cuda:
            threads *= WARP
        launch(step_jobs_kernel, threads, [rules, self.matches, self.progress])

    def run(self, iterate: Callable[[], None], watch: Callable[[], bool] | None = None) -> None:
        """Run `iterate` until no job is live; `watch` is called after each iteration and returns whether one is."""
        if watch is None:
            loop_while(self.progress.running, iterate)
            return
        is_live = self.jobs.count > 0
        while is_live:
            iterate()
            is_live = watch()  # sync
