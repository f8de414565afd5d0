"""How many points of a whole cloud have another cloud's point near them, under many poses at once.

Eight points that follow each other on the source's curve stay close together under any pose: they are one box to the
target's tree and eight lanes to a leaf's points, and their walk ends as soon as each has met a point. Nothing is
written but a count a pose, so a pose costs no memory. 12 B read a point and pose beside the tree.

Distances are those of find_nearest, bit for bit: a count equals the number of points whose nearest is within reach.
"""

from typing import Any

import numpy as np

from ..algebra.rigid_solve import fit_pose, move, pair_sums, sums_of_pair
from ..algebra.transform import narrow, widen
from ..array_types import Array1, Integers, Points, Poses
from ..arrays.packed_keys import key_index, key_number
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.select import gather_rows
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
from ..memory import copy, download, empty, full, zeros
from ..search.bucket_walk import next_bucket, start_walk, walk
from ..search.hilbert_order import HilbertOrder
from ..search.nearest_point import NO_POINT, find_nearest, lane_numbers
from ..search.point_tree import BUCKET, FAN, LEAF, PointTree, find_bucket, measure_boxes
from ..search.tree_search import reach_of
from .pair_fits import FEWEST, SUMS

CPU_RUN, CUDA_RUN = 16, 1  # groups of LEAF points a thread: few atomics on the CPU, many threads on CUDA
STILL = 1.0e-6  # of the sum: less is no progress
lane_flags = vector(8, int32)
match_sums = vector(19, float64)


@struct
class PoseFitness:
    """Scores of poses by a whole source cloud against a target's tree.

    Attributes:
        source: The finite source points along their curve, device array of vec3.
        target: The target's points as they were given.
        tree: Their PointTree.
        source_middle, target_middle: `middles` for kernels.
        middles: The middles of the clouds' boxes as float32 [3] each: poses are about these.
        size: Half the diagonal [m] of the source's box.
    """

    source: array(dtype=vec3)
    target: array(dtype=vec3)
    tree: PointTree
    source_middle: vec3
    target_middle: vec3

    def __init__(self, source: Points, tree: PointTree) -> None:
        """Prepare scores of a device array of vec3 against a PointTree."""
        found = HilbertOrder(source)
        rows = found.order[: found.finite_count] if found.finite_count else empty(0, int32, source.device)
        self.source = gather_rows(source, rows)
        self.tree, self.target, self.device = tree, tree.source, source.device
        self.middles = [middle_of(c.low, c.high) for c in (found, tree)]
        self.size = half_diagonal(found.low, found.high)
        self.source_middle, self.target_middle = (vec3(*middle) for middle in self.middles)

    def count(self, poses: Poses, distance: float) -> np.ndarray:
        """How many source points have a target point closer than a distance [m] under each pose: int32 [k], one sync.

        Args:
            poses: Device array of mat44d [k], some hundred at most.
        """
        counts, wanted = zeros(poses.size, int32, self.device), full(poses.size, 1, int32, self.device)
        self.add_counts(poses, wanted, distance, counts)
        return download(counts)  # sync

    def add_counts(self, poses: Poses, wanted: Integers, distance: float, counts: Integers) -> None:
        """Add to counts, int32 [k], what `count` returns, for the poses of which wanted, int32 [k], is not 0."""
        if self.tree.count == 0 or self.source.size == 0:
            return
        run = CUDA_RUN if self.device.is_cuda else CPU_RUN
        runs = -(-self.source.size // (LEAF * run))
        launch(count_met_kernel, poses.size * runs, [self, run, poses, wanted, reach_of(distance), counts])

    def match(self, pose: Poses, distance: float) -> Array1[Any]:
        """The sums over all points and their nearest target points under one pose (mat44d [1]): match_sums [1].

        Those of `fit_pose`, about the middles, the first being how many; then that of squared distances.
        """
        matching = Matching(self)
        matching.run(pose, distance)
        return matching.sums

    def refine(self, pose: Poses, distance: float, steps: int, with_scaling: bool) -> tuple[np.ndarray, int, float]:
        """Fit a pose to the nearest points of the whole clouds, several times.

        Each fit lowers the sum over all points of their squared distances, of which none counts more than that of a
        match at the limit: the sum that decides, since the number of matches alone goes up and down by a few.

        Args:
            pose: Device array of one mat44d; left as it is.

        Returns:
            (pose, count, sum): the best pose as float64 [4, 4], its number of points that have a match, and the sum of
            their squared distances [m^2]. One sync.
        """
        course, matching = Course(pose, steps), Matching(self)

        def step() -> None:
            matching.run(course.poses, distance)
            launch(judge_matches_kernel, 1, [matching.sums, distance * distance, int(with_scaling), course])

        if self.device.is_cuda:
            loop_while(course.running, step)
        else:
            while download(course.running)[0]:  # the search for the nearest points sorts them on the host
                step()
        found = course.states.download()  # sync
        return found["best"][0].copy(), int(found["counts"][0]), float(found["squares"][0])


class Matching:
    """What finds the nearest target point of each source point under a pose and sums over them; made once for many.

    Attributes:
        sums: match_sums [1], of the last run.
    """

    def __init__(self, fitness: PoseFitness) -> None:
        device, count = fitness.device, fitness.source.size
        self.fitness, self.sums = fitness, zeros(1, match_sums, device)
        self._moved, self._nearest = empty(count, vec3, device), empty(count, int64, device)
        self._order = positions(count, device) if device.is_cuda else None  # source points stand along their curve
        self._blocks, self._live = SegmentBlocks([0], [count], device), full(1, 1, int32, device)
        self._partials = empty(self._blocks.count, match_sums, device)

    def run(self, pose: Poses, distance: float) -> None:
        """Sum over the points and their nearest ones closer than a distance [m] under a pose, mat44d [1]."""
        fitness, count = self.fitness, self._moved.size
        launch(move_points_kernel, count, [fitness, pose, self._moved])
        find_nearest(fitness.tree, self._moved, radius=distance, order=self._order, nearest=self._nearest)
        reduce_segments(sum_matches, self._blocks, self._live, [fitness, self._nearest], self._partials, self.sums)


@struct
class Course:
    """A pose that is fitted to its matches again and again, and the best so far.

    Args:
        pose: Device array of one mat44d.
        steps: Fits at most.

    Attributes:
        poses: mat44d [1], the one in question.
        best: mat44d [1], that of the least cost.
        counts, squares: Of the best, int32 and float64 [1]: points that have a match, their squared distances [m^2].
        costs: float64 [1], the least one.
        left: int32 [1], poses that may still be looked at.
        running: int32 [1], whether there is one.
        states: The SideBySide of all of these.
    """

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
    """A source point in the target's coordinates; the pose is one about the two middles."""
    p = widen(fitness.source[row])
    return narrow(move(pose, p - widen(fitness.source_middle)) + widen(fitness.target_middle))


@func
def meet_leaf(
    first: int, tree: PointTree, xs: lane_numbers, ys: lane_numbers, zs: lane_numbers, reach: float, met: lane_flags
) -> lane_flags:
    """The lanes' flags, set where a point of the leaf that begins at a place lies within reach."""
    flags = met
    for i in range(first, min(first + LEAF, tree.count)):
        p = tree.points[i]
        for j in range(LEAF):
            x = p[0] - xs[j]
            y = p[1] - ys[j]
            z = p[2] - zs[j]
            flags[j] = flags[j] | (1 if x * x + y * y + z * z <= reach else 0)
    return flags


@func
def count_flags(flags: lane_flags) -> int:
    """How many lanes are set."""
    total = 0
    for j in range(LEAF):
        total += flags[j]
    return total


@kernel(most_registers=128)  # two blocks of an SM, not one
def count_met_kernel(
    fitness: PoseFitness,
    run: int,
    poses: array(dtype=mat44d),
    wanted: array(dtype=int32),
    reach: float,
    counts: array(dtype=int32),
):
    """How many points of a run of groups meet a target point under one wanted pose; whole sums, in any order."""
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
        met = lane_flags(0)
        if isfinite(a) and isfinite(b):
            for j in range(size, LEAF):
                met[j] = 1
            step = start_walk(find_bucket(vec3(xs[0], ys[0], zs[0]), fitness.tree))
            while int(step[0]) <= fitness.tree.root:
                bucket = int(step[2])
                distances = measure_boxes(fitness.tree.boxes, bucket, a, b)
                missing = LEAF - count_flags(met)
                for leaf in range(FAN):
                    if missing > 0 and distances[leaf] <= reach:
                        first = bucket * BUCKET + leaf * LEAF
                        met = meet_leaf(first, fitness.tree, xs, ys, zs, reach, met)
                        missing = LEAF - count_flags(met)
                if missing > 0:
                    step = next_bucket(step, a, b, reach, fitness.tree)
                else:
                    step = walk(int64(fitness.tree.root + 1), 0, 0, 0)
            total += count_flags(met) - (LEAF - size)
    if total > 0:
        atomic_add(counts, i // runs, total)


@kernel
def move_points_kernel(fitness: PoseFitness, poses: array(dtype=mat44d), moved: array(dtype=vec3)):
    """The source under the first pose."""
    i = tid()
    moved[i] = moved_point(poses[0], i, fitness)


@segment_reduction
def sum_matches(fitness: PoseFitness, nearest: array(dtype=int64)) -> match_sums:
    """The sums that fit_pose takes over the points and their nearest, then that of their squared distances [m^2]."""
    i = tid()
    out = match_sums(0.0)
    key = nearest[i]
    if key != int64(NO_POINT):
        p = widen(fitness.source[i]) - widen(fitness.source_middle)
        q = widen(fitness.target[key_index(key)]) - widen(fitness.target_middle)
        s = sums_of_pair(p, q, 1.0)
        for k in range(SUMS):
            out[k] = s[k]
        out[SUMS] = float64(key_number(key))
    return out


@kernel(most_registers=128)  # two blocks of an SM, not one
def judge_matches_kernel(sums: array(dtype=match_sums), limit: float64, with_scaling: int, course: Course):
    """Keep a pose whose matches cost less than those of the best so far, and fit it to them; else end the course."""
    i = tid()
    total = sums[i]
    cost = total[SUMS] - total[0] * limit  # less that of all points beyond
    course.running[i] = 0
    if not (cost >= course.costs[i] - float64(STILL) * abs(cost)):
        course.best[i] = course.poses[i]
        course.counts[i] = int(total[0])
        course.squares[i] = total[SUMS]
        course.costs[i] = cost
        course.left[i] = course.left[i] - 1
        if course.left[i] > 0 and total[0] >= float64(FEWEST):
            s = pair_sums(0.0)
            for k in range(SUMS):
                s[k] = total[k]
            course.poses[i] = fit_pose(s, with_scaling)
            course.running[i] = 1


def middle_of(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """The middle of a box, float32 [3]; zero where it is empty."""
    if not np.isfinite(low).all():
        return np.zeros(3, np.float32)
    return (0.5 * (low.astype(np.float64) + high)).astype(np.float32)


def half_diagonal(low: np.ndarray, high: np.ndarray) -> float:
    """Half the diagonal of a box; zero where it is empty."""
    return 0.5 * float(norm(high.astype(np.float64) - low)) if np.isfinite(low).all() else 0.0
