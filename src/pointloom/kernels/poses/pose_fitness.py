"""Number of points of a cloud with a near point of another cloud, under many poses.

Eight consecutive points on the curve form one box for the tree and eight lanes for a leaf. Their traversal ends when
each has a match. Distances are bitwise those of find_nearest.
"""

from typing import Any

import numpy as np

from ..algebra.rigid_solve import fit_pose, move, pair_sums, sums_of_pair
from ..algebra.transform import narrow, widen
from ..array_types import Array1, Device, Integers, Poses
from ..arrays.packed_keys import key_index, key_number
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import SideBySide
from ..arrays.sort import positions
from ..lang import (
    array,
    atomic_add,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    loop_while,
    mat44d,
    reduce_segments,
    segment_reduction,
    struct,
    tid,
    vec3,
    vector,
)
from ..linear_algebra import norm
from ..memory import copy, download, empty, full, rows_of, zeros
from ..search.bucket_walk import next_bucket, start_traversal, traversal
from ..search.many_clouds import ManyClouds
from ..search.nearest_point import NO_POINT, find_nearest, lane_numbers
from ..search.point_tree import BUCKET, FAN, LEAF, PointTree, find_bucket, measure_boxes
from ..search.tree_search import squared_radius
from .pair_fits import MIN_PAIRS, MOMENT_COUNT

CPU_RUN, CUDA_RUN = 16, 1  # groups of LEAF points per thread: few atomics on the CPU, many threads on CUDA
MIN_COST_DECREASE = 1.0e-6  # relative decrease of the sum that counts as progress
lane_flags = vector(8, int32)
match_sums = vector(19, float64)


@struct
class PoseFitness:
    """Scores of poses by a whole source cloud (finite points in curve order) against a target's tree. `middles`: box
    centers, the origins of poses; `size`: half the diagonal [m] of the source's box.
    """

    source: array(dtype=vec3)
    target: array(dtype=vec3)
    tree: PointTree
    source_middle: vec3
    target_middle: vec3

    def __init__(self, source: ManyClouds, tree: PointTree) -> None:
        """Prepare scores of one ordered cloud against a PointTree."""
        count = int(source.counts[0])
        self.source = rows_of(source.points, 0, count) if count else empty(0, vec3, source.device)
        self.tree, self.target, self.device = tree, tree.source, source.device
        self.middles = [middle_of(c.low, c.high) for c in (source, tree)]
        self.size = half_diagonal(source.low, source.high)
        self._matching: Matching | None = None
        self.source_middle, self.target_middle = (vec3(*middle) for middle in self.middles)

    def count(self, poses: Poses, distance: float) -> np.ndarray:
        """Matches closer than a distance [m] under each pose (mat44d (k), up to some hundred): int32 (k), one sync."""
        counts, wanted = zeros(poses.size, int32, self.device), full(poses.size, 1, int32, self.device)
        self.add_counts(poses, wanted, distance, counts)
        return download(counts)  # sync

    def add_counts(self, poses: Poses, wanted: Integers, distance: float, counts: Integers) -> None:
        """Add the counts of poses with nonzero `wanted`, int32 (k), to `counts`."""
        if self.tree.count == 0 or self.source.size == 0:
            return
        run = CUDA_RUN if self.device.is_cuda else CPU_RUN
        runs = -(-self.source.size // (LEAF * run))
        launch(count_matched_kernel, poses.size * runs, [self, run, poses, wanted, squared_radius(distance), counts])

    def match(self, pose: Poses, distance: float) -> Array1[Any]:
        """Sums of `fit_pose` over all matches under one pose, about the centers, then of squared distances [m^2].
        Valid until the next call."""
        matching = self._prepared_matching()
        matching.run(self, pose, distance)
        return matching.sums

    def _prepared_matching(self) -> "Matching":
        if self._matching is None:
            self._matching = Matching(self.source.size, self.device)
        return self._matching

    def refine(self, pose: Poses, distance: float, steps: int, with_scaling: bool) -> tuple[np.ndarray, int, float]:
        """Fit a pose repeatedly to the nearest points of the whole clouds: (pose, count, squared distances [m^2]).
        Minimizes the truncated sum of squares, which is steadier than the match count. One sync.
        """
        course, matching = Course(pose, steps), self._prepared_matching()

        def step() -> None:
            matching.run(self, course.poses, distance)
            launch(judge_matches_kernel, 1, [matching.sums, distance * distance, int(with_scaling), course])

        if self.device.is_cuda:
            loop_while(course.running, step)
        else:
            while download(course.running)[0]:  # the nearest-point search of few points sorts on the host
                step()
        states = course.states.download()  # sync
        return states["best"][0].copy(), int(states["counts"][0]), float(states["squares"][0])


class Matching:
    """Reusable search and sums for one pose; `sums` of the last run, match_sums (1)."""

    def __init__(self, count: int, device: Device) -> None:
        """For `count` source points."""
        self.sums = zeros(1, match_sums, device)
        self._moved, self._nearest = empty(count, vec3, device), empty(count, int64, device)
        self._order = positions(count, device)  # source points are in curve order
        self._blocks, self._live = SegmentBlocks([0], [count], device), full(1, 1, int32, device)
        self._partials = self._blocks.partials(match_sums)

    def run(self, fitness: PoseFitness, pose: Poses, distance: float) -> None:
        """Sum over the matches closer than a distance [m] under a pose, mat44d (1)."""
        launch(move_points_kernel, self._moved.size, [fitness, pose, self._moved])
        find_nearest(fitness.tree, self._moved, radius=distance, order=self._order, nearest=self._nearest)
        reduce_segments(sum_matches, self._blocks, self._live, [fitness, self._nearest], self._partials, self.sums)


@struct
class Course:
    """A pose refined repeatedly, and the best so far with `counts`, `squares` [m^2] and `costs`; `left` iterations."""

    poses: array(dtype=mat44d)
    best: array(dtype=mat44d)
    counts: array(dtype=int32)
    squares: array(dtype=float64)
    costs: array(dtype=float64)
    left: array(dtype=int32)
    running: array(dtype=int32)

    def __init__(self, pose: Poses, steps: int) -> None:
        values = {
            "poses": (np.eye(4)[None], mat44d),
            "best": (np.eye(4)[None], mat44d),
            "counts": ([-1], int32),
            "squares": ([np.inf], float64),
            "costs": ([np.inf], float64),
            "left": ([steps + 1], int32),
            "running": ([1], int32),
        }
        self.states = SideBySide(values, pose.device)
        vars(self).update(self.states.arrays)
        for first in (self.poses, self.best):
            copy(first, pose, count=1)


@func
def moved_point(pose: mat44d, row: int, fitness: PoseFitness) -> vec3:
    """Source point in target coordinates. The pose is about the two centers."""
    p = widen(fitness.source[row])
    return narrow(move(pose, p - widen(fitness.source_middle)) + widen(fitness.target_middle))


@func
def match_leaf(
    first: int,
    tree: PointTree,
    xs: lane_numbers,
    ys: lane_numbers,
    zs: lane_numbers,
    sqradius: float,
    matched: lane_flags,
) -> lane_flags:
    """Set the flags of lanes with a leaf point within the radius."""
    flags = matched
    for i in range(first, min(first + LEAF, tree.count)):
        p = tree.points[i]
        for j in range(LEAF):
            x = p[0] - xs[j]
            y = p[1] - ys[j]
            z = p[2] - zs[j]
            flags[j] = flags[j] | (1 if x * x + y * y + z * z <= sqradius else 0)
    return flags


@func
def count_flags(flags: lane_flags) -> int:
    total = 0
    for j in range(LEAF):
        total += flags[j]
    return total


@kernel(max_registers=128)  # for two blocks per SM
def count_matched_kernel(
    fitness: PoseFitness,
    run: int,
    poses: array(dtype=mat44d),
    wanted: array(dtype=int32),
    sqradius: float,
    counts: array(dtype=int32),
):
    """Count the matches of a run of groups under one wanted pose. Integer sums."""
    i = tid()
    source_count = fitness.source.shape[0]
    groups = (source_count + LEAF - 1) // LEAF
    runs = (groups + run - 1) // run
    if wanted[i // runs] == 0:
        return
    pose = poses[i // runs]
    total = 0
    for group in range((i % runs) * run, min((i % runs + 1) * run, groups)):
        head = group * LEAF
        size = min(LEAF, source_count - head)
        a = moved_point(pose, head, fitness)
        b = a + vec3(0.0, 0.0, 0.0)
        xs = lane_numbers(a[0])
        ys = lane_numbers(a[1])
        zs = lane_numbers(a[2])
        for j in range(1, size):
            p = moved_point(pose, head + j, fitness)
            xs[j] = p[0]
            ys[j] = p[1]
            zs[j] = p[2]
            a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
            b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
        matched = lane_flags(0)
        if isfinite(a) and isfinite(b):
            for j in range(size, LEAF):
                matched[j] = 1
            step = start_traversal(find_bucket(vec3(xs[0], ys[0], zs[0]), fitness.tree))
            while int(step[0]) <= fitness.tree.root:
                bucket = int(step[2])
                distances = measure_boxes(fitness.tree.boxes, bucket, a, b)
                missing = LEAF - count_flags(matched)
                for leaf in range(FAN):
                    if missing > 0 and distances[leaf] <= sqradius:
                        first = bucket * BUCKET + leaf * LEAF
                        matched = match_leaf(first, fitness.tree, xs, ys, zs, sqradius, matched)
                        missing = LEAF - count_flags(matched)
                if missing > 0:
                    step = next_bucket(step, a, b, sqradius, fitness.tree)
                else:
                    step = traversal(int64(fitness.tree.root + 1), 0, 0, 0)
            total += count_flags(matched) - (LEAF - size)
    if total > 0:
        atomic_add(counts, i // runs, total)


@kernel
def move_points_kernel(fitness: PoseFitness, poses: array(dtype=mat44d), moved: array(dtype=vec3)):
    i = tid()
    moved[i] = moved_point(poses[0], i, fitness)


@segment_reduction
def sum_matches(fitness: PoseFitness, nearest: array(dtype=int64)) -> match_sums:
    """Sums for fit_pose over the matches, then squared distances [m^2]."""
    i = tid()
    out = match_sums(0.0)
    key = nearest[i]
    if key != int64(NO_POINT):
        p = widen(fitness.source[i]) - widen(fitness.source_middle)
        q = widen(fitness.target[key_index(key)]) - widen(fitness.target_middle)
        s = sums_of_pair(p, q, 1.0)
        for k in range(MOMENT_COUNT):
            out[k] = s[k]
        out[MOMENT_COUNT] = float64(key_number(key))
    return out


@kernel(max_registers=128)  # for two blocks per SM
def judge_matches_kernel(sums: array(dtype=match_sums), limit: float64, with_scaling: int, course: Course):
    """Keep and refit a pose whose cost is below the best. Else stop."""
    i = tid()
    total = sums[i]
    cost = total[MOMENT_COUNT] - total[0] * limit  # minus that of all unmatched points
    course.running[i] = 0
    if not (cost >= course.costs[i] - float64(MIN_COST_DECREASE) * abs(cost)):
        course.best[i] = course.poses[i]
        course.counts[i] = int(total[0])
        course.squares[i] = total[MOMENT_COUNT]
        course.costs[i] = cost
        course.left[i] = course.left[i] - 1
        if course.left[i] > 0 and total[0] >= float64(MIN_PAIRS):
            s = pair_sums(0.0)
            for k in range(MOMENT_COUNT):
                s[k] = total[k]
            course.poses[i] = fit_pose(s, with_scaling)
            course.running[i] = 1


def middle_of(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Center of a box, float32 (3). Zero if empty."""
    if not np.isfinite(low).all():
        return np.zeros(3, np.float32)
    return (0.5 * (low.astype(np.float64) + high)).astype(np.float32)


def half_diagonal(low: np.ndarray, high: np.ndarray) -> float:
    """Half the diagonal of a box. Zero if empty."""
    return 0.5 * float(norm(high.astype(np.float64) - low)) if np.isfinite(low).all() else 0.0
