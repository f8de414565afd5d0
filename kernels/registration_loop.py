"""Iterative registration of many jobs at once: each job is a source, a target and a pose, all in the same launches.

An iteration is four launches, whatever the number of jobs: match, sums over the pairs, their fold, the step. Nothing is
read back in between: on CUDA the loop is one graph, on the CPU the only thing looked at is one flag. Memory a source
point and job: 12 B; jobs that share clouds share their trees.
"""

import numpy as np

from .correspondences import match_groups_kernel
from .lang import array, float32, float64, int32, kernel, launch, loop_while, mat44d, reduce_segments, tid, vec3d
from .memory import empty, full, upload, zeros
from .point_tree import LEAF
from .registration_rows import row_sums, sum_information
from .registration_step import RUNNING, free_directions, step_jobs_kernel
from .segment_blocks import SegmentBlocks
from .spread import mean_and_covariance  # noqa: F401
from .tree_search import reach_of

LARGEST_REACH = 3.0e38  # [m^2] below infinity, whose bits have no successor


class Jobs:
    """The tables of jobs over sources and targets.

    Args:
        sources: CurveSegments. targets: a PointForest.
        source_of, target_of: The clouds of each job, int [jobs].

    Attributes:
        tables: Device arrays that rows and matches take: group_jobs, job_groups, job_sources, source_bases.
    """

    def __init__(self, sources, targets, source_of, target_of):
        device = sources.device
        self.sources, self.targets, self.device = sources, targets, device
        self.source_of, self.target_of = np.asarray(source_of, np.int64), np.asarray(target_of, np.int64)
        self.count = len(self.source_of)
        counts = sources.counts[self.source_of]
        groups = -(-counts // LEAF)
        firsts = np.concatenate([[0], np.cumsum(groups)])
        self.group_count = int(firsts[-1])
        if self.group_count * LEAF >= 2**31:
            raise ValueError(f"{counts.sum():,} source points in {self.count:,} jobs; register them in parts below 2^31")
        self.firsts, self.counts = firsts[:-1] * LEAF, counts
        self.group_jobs = upload(np.repeat(np.arange(self.count), groups), int32, device)
        self.job_groups = upload(firsts[:-1], int32, device)
        self.job_sources = upload(self.source_of, int32, device)
        self.job_targets = upload(self.target_of, int32, device)
        self.tables = [self.group_jobs, self.job_groups, self.job_sources, sources.device_bases]
        self.blocks = SegmentBlocks(self.firsts, counts, device)


class RegistrationLoop:
    """The state of all jobs and the launches of an iteration.

    Args:
        jobs: The jobs.
        poses: T_target_source between coordinates about the clouds' origins, float64 [jobs, 4, 4].
        max_distance: Pairs farther apart do not count [m].
        centers, sizes: Middle of each job's source under its pose, and its spread [m]: float64 [jobs, 3], [jobs].
    """

    def __init__(self, jobs, poses, max_distance, centers, sizes):
        device, count, elements = jobs.device, jobs.count, jobs.group_count * LEAF
        self.jobs, self.reach = jobs, min(reach_of(max_distance), LARGEST_REACH)
        self.poses, self.earlier = upload(poses, mat44d, device), upload(poses, mat44d, device)
        self.pivots, self.sizes = upload(centers, vec3d, device), upload(np.maximum(sizes, 1e-12), float64, device)
        self.source_counts = upload(np.maximum(jobs.counts, 1), float64, device)
        self.margins, self.iterations = zeros(count, float32, device), zeros(count, int32, device)
        self.fitness, self.rmse = zeros(count, float64, device), zeros(count, float64, device)
        self.live, self.outcomes = full(count, 1, int32, device), full(count, RUNNING, int32, device)
        self.free_counts, self.free = zeros(count, int32, device), zeros(count, free_directions, device)
        self.running = upload(np.array([count]), int32, device)
        self.nearest, self.lowers = full(elements, -1, int32, device), full(elements, -1.0, float32, device)
        self.pairs = full(elements, -1, int32, device)
        self.partials, self.totals = empty(jobs.blocks.count, row_sums, device), zeros(count, row_sums, device)

    def match(self):
        """Find the pairs of all live jobs."""
        jobs = self.jobs
        search = [jobs.group_jobs, jobs.job_groups, jobs.job_sources, jobs.job_targets, self.live]
        search += [jobs.sources.device_bases, jobs.sources.points, self.poses, self.earlier, self.margins, self.reach]
        search += [*jobs.targets.search_arguments, self.nearest, self.lowers, self.pairs]
        launch(match_groups_kernel, jobs.group_count, search)

    def sum_rows(self, rows, arguments):
        """Sum a reduction's rows over the pairs of all live jobs into `totals`."""
        jobs = self.jobs
        common = [*jobs.tables, self.poses, self.pairs, jobs.sources.points, jobs.targets.curve.points]
        reduce_segments(rows, jobs.blocks, self.live, [*common, *arguments], self.partials, self.totals)

    def step(self, method, scaling, criteria, least_eigenvalue):
        """Judge all live jobs and move them on."""
        state = [self.totals, self.pivots, self.sizes, self.source_counts, self.poses, self.earlier, self.margins]
        state += [self.fitness, self.rmse, self.iterations, self.live, self.outcomes, self.free_counts, self.free]
        launch(
            step_jobs_kernel, self.jobs.count, [method, int(scaling), *criteria, least_eigenvalue, *state, self.running]
        )
