"""Iterative registration of many jobs at once: each job is a source, a target and a pose, all in the same launches.

An iteration is four launches, whatever the number of jobs: match, sums over the pairs, their fold, the step. Nothing is
read back in between: on CUDA the loop is one graph, on the CPU the only thing looked at is one flag. Memory a source
point and job: 12 B; jobs that share clouds share their trees.
"""

import numpy as np

from ..algebra.rigid_solve import TRIANGLE, move, vec6d
from ..algebra.transform import narrow, widen
from ..arrays.hash_table import HashTable
from ..arrays.segment_blocks import SegmentBlocks
from ..lang import (
    array,
    float32,
    float64,
    int32,
    isfinite,
    kernel,
    launch,
    loop_while,
    mat44d,
    reduce_segments,
    segment_reduction,
    tid,
    vec3,
    vec3d,
    vec3i,
    vector,
)
from ..memory import download, empty, full, upload, zeros
from ..search.point_tree import LEAF, square_distance
from ..search.tree_search import reach_of
from .correspondences import match_groups_kernel, match_points_kernel
from .rows import NO_PAIR, JobTables, row_sums, source_place, sum_information
from .step import RUNNING, free_directions, measure_velocities_kernel, step_jobs_kernel
from .voxel_gaussians import find_nearest_gaussian, gaussian_covariance, gaussian_mean

LARGEST_REACH = 3.0e38  # [m^2] below infinity, whose bits have no successor
SMALLEST_SIZE = 1.0e-12  # [m] of a source that is one point
VOXEL_STEPS = 1  # voxelised targets: a point's own voxel and the six beside it
first_moments = vector(4, float64)


@segment_reduction
def sum_moments(points: array(dtype=vec3)) -> first_moments:
    """The sum of positions and of their squares."""
    i = tid()
    p = widen(points[i])
    return first_moments(p[0], p[1], p[2], p[0] * p[0] + p[1] * p[1] + p[2] * p[2])


@kernel
def match_voxels_kernel(
    jobs: JobTables,
    job_targets: array(dtype=int32),
    live: array(dtype=int32),
    sources: array(dtype=vec3),
    poses: array(dtype=mat44d),
    reach: float,
    corner: vec3d,
    scale: float64,
    first: vec3d,
    cells: vec3d,
    bits: vec3i,
    table: HashTable,
    gaussians: array(dtype=float32, ndim=2),
    pairs: array(dtype=int32),
):
    """The voxel with the nearest mean of each source point, among its own and those beside it."""
    i = tid()
    job = jobs.group_jobs[i // LEAF]
    if live[job] != 0:
        p = sources[source_place(i, jobs)]
        pair = int(NO_PAIR)
        if isfinite(p):
            q = narrow(move(poses[job], widen(p)))
            row = find_nearest_gaussian(
                q, job_targets[job], VOXEL_STEPS, corner, scale, first, cells, bits, table, gaussians
            )
            if row >= 0:
                if square_distance(q, gaussian_mean(row, gaussians)) <= reach:
                    pair = row
        pairs[i] = pair


@kernel
def unpack_gaussians_kernel(
    gaussians: array(dtype=float32, ndim=2), means: array(dtype=vec3), covariances: array(dtype=float32, ndim=2)
):
    """Means, and covariances as full matrices."""
    i = tid()
    means[i] = gaussian_mean(i, gaussians)
    C = gaussian_covariance(i, gaussians)
    for row in range(3):
        for column in range(3):
            covariances[i, 3 * row + column] = C[row, column]


class Jobs:
    """The tables of jobs over sources and targets.

    Args:
        sources: ManyClouds.
        targets: A PointForest; None where the targets are voxels.
        source_of, target_of: The clouds of each job, int [jobs].

    Attributes:
        tables: Device arrays that rows and matches take: group_jobs, job_groups, job_sources, source_bases.
        firsts, counts: The first element of each job and its elements, int64 [jobs] on the host.

    Raises:
        ValueError: 2^31 elements or more.
    """

    def __init__(self, sources, targets, source_of, target_of):
        device = sources.device
        self.sources, self.targets, self.device = sources, targets, device
        self.source_of, self.target_of = np.asarray(source_of, np.int64), np.asarray(target_of, np.int64)
        self.count = len(self.source_of)
        self.counts = sources.counts[self.source_of]
        groups = -(-self.counts // LEAF)
        firsts = np.concatenate([[0], np.cumsum(groups)])
        self.group_count = int(firsts[-1])
        if self.group_count * LEAF >= 2**31:
            total = self.counts.sum()
            raise ValueError(f"{total:,} source points in {self.count:,} jobs; register them in parts below 2^31")
        self.firsts = firsts[:-1] * LEAF
        group_jobs = upload(np.repeat(np.arange(self.count), groups), int32, device)
        job_groups = upload(firsts[:-1], int32, device)
        self.job_targets = upload(self.target_of, int32, device)
        self.group_jobs, self.job_groups = group_jobs, job_groups
        self.job_sources, self.source_bases = upload(self.source_of, int32, device), sources.device_bases
        self.blocks = SegmentBlocks(self.firsts, self.counts, device)

    def measure_sources(self):
        """The mean [m], float64 [clouds, 3], and the spread about it [m], [clouds], of the sources."""
        curve = self.sources
        blocks = SegmentBlocks(curve.bases, curve.counts, self.device)
        count = len(curve.counts)
        partials, out = empty(blocks.count, first_moments, self.device), zeros(count, first_moments, self.device)
        reduce_segments(sum_moments, blocks, full(count, 1, int32, self.device), [curve.points], partials, out)
        sums = download(out) / np.maximum(curve.counts, 1)[:, None]  # sync
        return sums[:, :3], np.sqrt(np.maximum(sums[:, 3] - (sums[:, :3] ** 2).sum(axis=1), 0))


class RegistrationLoop:
    """The state of all jobs and the launches of an iteration.

    Args:
        jobs: The jobs.
        poses: T_target_source between coordinates about the clouds' origins, float64 [jobs, 4, 4].
        max_distance: Pairs this far apart or farther do not count [m].
        gaussians: VoxelGaussians to match with in place of the targets' points.
        judged_apart: Whether what is degenerate is judged by other rows than those that are solved.
        alone: Whether each point searches alone; None: on CUDA.
    """

    def __init__(self, jobs, poses, max_distance, gaussians=None, judged_apart=False, alone=None):
        device, count, elements = jobs.device, jobs.count, jobs.group_count * LEAF
        self.alone = device.is_cuda if alone is None else alone
        self.sources = jobs.sources.points
        self.jobs, self.reach, self.gaussians = jobs, min(reach_of(max_distance), LARGEST_REACH), gaussians
        self.poses, self.earlier = upload(poses, mat44d, device), upload(poses, mat44d, device)
        means, spreads = jobs.measure_sources()
        means, spreads = means[jobs.source_of], spreads[jobs.source_of]
        centers = np.einsum("jrc,jc->jr", poses[:, :3, :3], means) + poses[:, :3, 3]
        self.pivots = upload(centers, vec3d, device)
        self.sizes = upload(np.maximum(spreads, SMALLEST_SIZE), float64, device)
        self.source_counts = upload(np.maximum(jobs.counts, 1), float64, device)
        self.margins, self.iterations = zeros(count, float32, device), zeros(count, int32, device)
        self.fitness, self.rmse = zeros(count, float64, device), zeros(count, float64, device)
        self.live, self.outcomes = full(count, 1, int32, device), full(count, RUNNING, int32, device)
        self.free_counts, self.free = zeros(count, int32, device), zeros(count, free_directions, device)
        self.running = upload(np.array([count]), int32, device)
        self.nearest, self.lowers = full(elements, -1, int32, device), full(elements, -1.0, float32, device)
        self.pairs = full(elements, -1, int32, device)
        self.velocities = zeros(count, vec6d, device)
        self.partials, self.totals = empty(jobs.blocks.count, row_sums, device), zeros(count, row_sums, device)
        self.plain_totals = zeros(count, row_sums, device) if judged_apart else None
        if gaussians is None:
            self.targets, self.target_covariances = jobs.targets.clouds.points, None
        else:
            self.targets = empty(gaussians.count, vec3, device)
            self.target_covariances = empty((gaussians.count, 9), float32, device)
            unpacked = [gaussians.gaussians, self.targets, self.target_covariances]
            launch(unpack_gaussians_kernel, gaussians.count, unpacked)

    def match(self):
        """Find the pairs of all live jobs."""
        jobs = self.jobs
        if self.gaussians is not None:
            search = [jobs, jobs.job_targets, self.live, jobs.sources.points, self.poses, self.reach]
            launch(match_voxels_kernel, self.pairs.size, [*search, *self.gaussians.arguments, self.pairs])
            return
        search = [jobs.group_jobs, jobs.job_groups, jobs.job_sources, jobs.job_targets, self.live]
        search += [jobs.source_bases, jobs.sources.points]
        search += [self.poses, self.earlier, self.margins, self.reach, jobs.targets]
        search += [self.nearest, self.lowers, self.pairs]
        if self.alone:
            launch(match_points_kernel, self.pairs.size, search)
        else:
            launch(match_groups_kernel, jobs.group_count, search)

    def sum_rows(self, rows, arguments, plain_arguments=None):
        """Sum a reduction's rows over the pairs of all live jobs into `totals`.

        `plain_arguments` are those without robust kernels, which tell what is degenerate; None where they are the same.
        """
        jobs = self.jobs
        reduce_segments(rows, jobs.blocks, self.live, [self, *arguments], self.partials, self.totals)
        if plain_arguments is not None:
            sums = self.plain_totals
            reduce_segments(rows, jobs.blocks, self.live, [self, *plain_arguments], self.partials, sums)

    def measure_velocities(self, period):
        """The velocity of each job's pose, for Doppler rows."""
        launch(measure_velocities_kernel, self.jobs.count, [self.poses, period, self.velocities])

    def step(self, method, with_scaling, criteria, least_eigenvalue):
        """Judge all live jobs and move them on.

        Args:
            method: How the sums become a step, see registration_step.
            with_scaling: Whether the best fit of pairs may scale.
            criteria: (iterations at most, change of fitness, change of rmse below which a job has converged).
            least_eigenvalue: Directions with less than this share of the largest eigenvalue are free.
        """
        plain = self.totals if self.plain_totals is None else self.plain_totals
        state = [
            self.totals,
            plain,
            self.pivots,
            self.sizes,
            self.source_counts,
            self.poses,
            self.earlier,
            self.margins,
        ]
        state += [self.fitness, self.rmse, self.iterations, self.live, self.outcomes, self.free_counts, self.free]
        rules = [method, int(with_scaling), *criteria, least_eigenvalue]
        launch(step_jobs_kernel, self.jobs.count, [*rules, *state, self.running])

    def run(self, iterate, watch=None):
        """Run `iterate` until no job is live; `watch` is called after each turn and costs a sync there."""
        if watch is None:
            loop_while(self.running, iterate)
            return
        while self.running.numpy()[0]:  # sync
            iterate()
            watch()

    def measure_information(self):
        """The information of the pairs of each job about its target's origin: upper triangles, float64 [jobs, 21]."""
        jobs = self.jobs
        live = full(jobs.count, 1, int32, jobs.device)
        reduce_segments(
            sum_information, jobs.blocks, live, [jobs.group_jobs, self.pairs, self.targets], self.partials, self.totals
        )
        return download(self.totals)[:, :TRIANGLE]  # sync
