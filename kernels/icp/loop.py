"""Batched iterative registration: four launches per iteration for all jobs, without sync on CUDA."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..algebra.rigid_solve import TRIANGLE, vec6d
from ..array_types import AnyArray, Array1, Integers
from ..lang import WARP, Reduction, int32, launch, loop_while, reduce_segments
from ..memory import download, empty, full, zeros
from .constrained_steps import step_constrained_kernel
from .correspondences import match_groups_kernel, match_points_kernel
from .freedom import Freedom
from .job_states import job_states
from .jobs import Jobs
from .matches import Matches, PointColumns
from .rows import DopplerRule, row_sums, sum_information
from .step import Progress, StepRules, measure_velocities_kernel, step_jobs_kernel
from .voxel_gaussians import VoxelGaussians, match_voxels_kernel

if TYPE_CHECKING:
    from .robust_weights import Loss


class RegistrationLoop:
    """Launches of an iteration over all jobs. `poses`: T_target_source about the clouds' origins. Pairs closer than
    `max_distance` [m] count; `separate_geometry`: degeneracy by other rows than the solve; `per_point`: each
    point searches on its own.
    """

    def __init__(
        self,
        jobs: Jobs,
        poses: np.ndarray,
        max_distance: float,
        gaussians: VoxelGaussians | None = None,
        separate_geometry: bool = False,
        per_point: bool | None = None,
    ) -> None:
        device = jobs.device
        self.per_point = device.is_cuda if per_point is None else per_point
        self.jobs, self.gaussians = jobs, gaussians
        if gaussians is None:
            assert jobs.targets is not None
            targets, self.target_covariances = jobs.targets.clouds.points, None
        else:
            targets, self.target_covariances = gaussians.unpack()
        self.states = job_states(jobs, poses)
        self.matches = Matches(jobs, self.states, max_distance, targets)
        self.progress = Progress(jobs, self.states, poses, separate_geometry=separate_geometry)
        self.velocities = zeros(jobs.count, vec6d, device)
        self.partials = empty(jobs.blocks.count, row_sums, device)

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

    def sum_rows(
        self,
        rows: Reduction,
        arguments: "Sequence[AnyArray | PointColumns | Loss | DopplerRule | float]",
        plain_arguments: "Sequence[Integers | Array1[Any] | PointColumns | Loss | DopplerRule | float] | None" = None,
    ) -> None:
        """Sum a reduction over all pairs into `progress.totals`; `plain_arguments` without kernels, for degeneracy."""
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

    def measure_information(self) -> np.ndarray:
        """Information of the pairs of each job about its target's origin: upper triangles, float64 (jobs, 21)."""
        jobs, totals = self.jobs, self.progress.totals
        live = full(jobs.count, 1, int32, jobs.device)
        reduce_segments(sum_information, jobs.blocks, live, [self.matches], self.partials, totals)
        return download(totals)[:, :TRIANGLE]  # sync
