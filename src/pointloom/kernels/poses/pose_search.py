"""RANSAC search for the pose that aligns most of a source cloud, from correspondences with few inliers.

Rounds of hypotheses (pose_hypotheses.py): the best distinct ones are refitted (pair_fits.py) and scored by the whole
cloud (pose_fitness.py). About 25 launches and one sync per round, two more for ties.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..array_types import AnyArray, Array2, Integers, Points, Poses
from ..arrays.side_by_side import SideBySide
from ..arrays.sort import argsort_keys, descending_keys, positions
from ..lang import array, ballot, float64, func, int32, kernel, launch, mat44d, sync_lanes, tid, vector
from ..memory import download, empty, upload, zeros
from ..search.tree_walk import lowest_bit
from ..segmentation.plane_fit import samples_needed
from .pair_fits import PairCoordinates
from .pose_hypotheses import REJECTED_SCORE, Checks, Samples, score_poses

if TYPE_CHECKING:
    from .pose_fitness import PoseFitness

FIRST_ROUND, MIN_ROUND, MAX_ROUND = 4096, 1024, 16384  # hypotheses per round
# Correspondences that rank the hypotheses of a round. At 1 % inliers 40 of them support a correct one
RANKING_PAIRS = 4096
MAX_RANKED = 2048  # hypotheses of a round considered for refitting
MAX_DISTINCT = 16  # distinct ones scored by the whole cloud
MIN_SEPARATION = 2.0  # match distances: minimum displacement of some source box point between distinct poses
MIN_CONTENDER_SUPPORT = 0.25  # of the best inlier count: minimum for scoring by the whole cloud
REFIT_COUNT = 4  # refits to the inliers of each of these
PROBE_NUMBERS = 12  # numbers of the four points that distinguish two poses
probe = vector(12, float64)
LAST_FITS = 8  # refits of the winner to the clouds themselves, while it improves


@func
def probe_of(pose: mat44d, size: float64) -> probe:
    """Images of the source's center and of points along the axes at distance `size`."""
    p = probe(0.0)
    for row in range(3):
        p[row] = pose[row, 3]
        for axis in range(3):
            p[3 * axis + 3 + row] = pose[row, axis] * size + pose[row, 3]
    return p


@func
def is_apart(p: probe, k: int, probes: array(dtype=float64), limit: float64) -> int:
    """1 if some point of a probe is farther than sqrt(limit) from that of the stored probe k."""
    farthest = float64(0.0)
    total = float64(0.0)
    for point in range(4):
        x = p[3 * point] - probes[k * PROBE_NUMBERS + 3 * point]
        y = p[3 * point + 1] - probes[k * PROBE_NUMBERS + 3 * point + 1]
        z = p[3 * point + 2] - probes[k * PROBE_NUMBERS + 3 * point + 2]
        square = x * x + y * y + z * z
        farthest = max(farthest, square)
        total += square
    return 1 if farthest > limit and total >= 0.0 else 0  # a NaN total comes from an invalid pose


@kernel
def select_distinct_kernel(
    poses: array(dtype=mat44d),
    scores: array(dtype=int32),
    order: array(dtype=int32),
    size: float64,
    limit: float64,
    probes: array(dtype=float64),
    distinct: array(dtype=mat44d),
    distinct_count: array(dtype=int32),
):
    """The first MAX_DISTINCT distinct poses in order, up to the REFUSED, in one thread. The rest repeats the first."""
    i = tid()
    count = 0
    ranked = min(order.shape[0], MAX_RANKED)
    k = 0
    while k < ranked and count < MAX_DISTINCT:
        row = order[k]
        k += 1
        if scores[row] == REJECTED_SCORE:
            k = ranked
        else:
            p = probe_of(poses[row], size)
            is_distinct = 1
            for j in range(count):
                if is_distinct == 1:
                    is_distinct = is_apart(p, j, probes, limit)
            if is_distinct == 1:
                for j in range(PROBE_NUMBERS):
                    probes[count * PROBE_NUMBERS + j] = p[j]
                distinct[count] = poses[row]
                count += 1
    if count > 0:
        for j in range(count, MAX_DISTINCT):
            distinct[j] = distinct[0]
    distinct_count[i] = count


@select_distinct_kernel.on_cuda
def select_distinct_in_lanes_kernel(
    poses: array(dtype=mat44d),
    scores: array(dtype=int32),
    order: array(dtype=int32),
    size: float64,
    limit: float64,
    probes: array(dtype=float64),
    distinct: array(dtype=mat44d),
    distinct_count: array(dtype=int32),
):
    """CUDA variant: a warp tests 32 poses at a time."""
    i = tid()
    count = 0
    ranked = min(order.shape[0], MAX_RANKED)
    head = 0
    while head < ranked and count < MAX_DISTINCT:
        row = -1
        p = probe(0.0)
        if head + i < ranked:
            row = order[head + i]
            if scores[row] == REJECTED_SCORE:
                row = -1
            else:
                p = probe_of(poses[row], size)
        for j in range(count):
            if row >= 0:
                if is_apart(p, j, probes, limit) == 0:
                    row = -1
        waiting = ballot(1 if row >= 0 else 0)
        while waiting != 0 and count < MAX_DISTINCT:
            if i == lowest_bit(waiting):
                for j in range(PROBE_NUMBERS):
                    probes[count * PROBE_NUMBERS + j] = p[j]
                distinct[count] = poses[row]
                row = -1
            sync_lanes()
            if row >= 0:
                if is_apart(p, count, probes, limit) == 0:
                    row = -1
            count += 1
            waiting = ballot(1 if row >= 0 else 0)
        head += 32
    if i >= count and i < MAX_DISTINCT and count > 0:
        distinct[i] = distinct[0]
    if i == 0:
        distinct_count[0] = count


@kernel
def mark_contenders_kernel(
    poses: array(dtype=mat44d),
    scores: array(dtype=float64, ndim=2),
    distinct_count: array(dtype=int32),
    best_inliers: int,
    contends: array(dtype=int32),
    counts: array(dtype=int32),
):
    """1 for distinct refitted poses with nearly the best inlier count."""
    i = tid()
    best = float64(best_inliers)
    for k in range(distinct_count[0]):
        best = max(best, scores[k, 0])
    contender = 1 if i < distinct_count[0] and scores[i, 0] >= float64(MIN_CONTENDER_SUPPORT) * best else 0
    for k in range(i):
        alike = 1
        for row in range(4):
            for column in range(4):
                if poses[k][row, column] != poses[i][row, column]:
                    alike = 0
        if alike == 1:
            contender = 0
    contends[i] = contender
    counts[i] = 0


class PoseSearchResult:
    """Best `pose` about the cloud centers or None; matched points `count` and their `squares` [m^2]; `inliers`; `drawn`
    hypotheses; `confident`: ended because a better pose was unlikely.
    """

    def __init__(self) -> None:
        self.pose: Any = None
        self.squares: Any = None
        self.count, self.inliers, self.drawn, self.confident = -1, 0, 0, False


class PoseSearch:
    def __init__(self, fitness: "PoseFitness", source: Points, target: Points, pairs: Array2[int32]) -> None:
        """Prepare a search with a PoseFitness, the clouds (vec3) and correspondences, int32 (m, 2)."""
        self.fitness, self.device = fitness, source.device
        self.pairs = PairCoordinates(source, target, pairs, *fitness.middles)
        self.ranking = self.pairs
        if self.pairs.count > RANKING_PAIRS:
            rows = np.arange(RANKING_PAIRS, dtype=np.int64) * self.pairs.count // RANKING_PAIRS
            self.ranking = self.pairs.select(upload(rows, int32, self.device))
        values = {
            "best": (np.tile(np.eye(4), (MAX_DISTINCT, 1, 1)), mat44d),
            "inliers": (np.zeros((MAX_DISTINCT, 2)), float64),
            "contends": (np.zeros(MAX_DISTINCT), int32),
            "counts": (np.zeros(MAX_DISTINCT), int32),
        }
        self._round_states = SideBySide(values, self.device)
        self._distinct, self._distinct_count = (
            upload(values["best"][0], mat44d, self.device),
            zeros(1, int32, self.device),
        )
        self._probes = empty(MAX_DISTINCT * PROBE_NUMBERS, float64, self.device)

    def find(
        self,
        distance: float,
        sample_size: int,
        checks: Checks,
        normals: Sequence[AnyArray],
        max_hypotheses: int,
        confidence: float,
        with_scaling: bool,
        seed: int,
    ) -> PoseSearchResult:
        """Best of `max_hypotheses` at most (ties by distance); ends early at `confidence` of an all-inlier sample."""
        result = PoseSearchResult()
        needed, size = float(max_hypotheses), FIRST_ROUND
        while result.drawn < min(max_hypotheses, needed):
            size = min(size, max_hypotheses - result.drawn, max(math.ceil(needed) - result.drawn, MIN_ROUND))
            self._round(result, size, distance, sample_size, checks, normals, with_scaling, seed)
            result.drawn += size
            if confidence < 1.0:
                needed = samples_needed(result.inliers / self.pairs.count, sample_size, confidence, max_hypotheses)
            size = min(2 * size, MAX_ROUND)
        result.confident = result.pose is not None and confidence < 1.0 and needed <= result.drawn
        if result.pose is not None:
            pose = upload(result.pose[None], mat44d, self.device)
            result.pose, result.count, result.squares = self.fitness.refine(pose, distance, LAST_FITS, with_scaling)
        return result

    def _round(
        self,
        result: PoseSearchResult,
        size: int,
        distance: float,
        sample_size: int,
        checks: Checks,
        normals: Sequence[AnyArray],
        with_scaling: bool,
        seed: int,
    ) -> None:
        samples = Samples(self.pairs, sample_size, size, checks, seed, result.drawn)
        # on CUDA the others are evaluated too, which avoids a sync
        chosen = positions(size, self.device) if self.device.is_cuda else samples.similar
        if chosen.size == 0:
            return
        poses, scores = samples.fit(checks, normals, with_scaling, chosen)
        score_poses(self.ranking, poses, distance, scores)
        count = self._select_distinct(poses, scores, MIN_SEPARATION * distance)
        if count == 0:
            return
        best, inliers, contends, counts = (
            self._round_states.arrays[name][:count] for name in ("best", "inliers", "contends", "counts")
        )
        self.pairs.refine(self._distinct[:count], distance, REFIT_COUNT, with_scaling, (best, inliers))
        launch(mark_contenders_kernel, count, [best, inliers, self._distinct_count, result.inliers, contends, counts])
        self.fitness.add_counts(best, contends, distance, counts)
        states = self._round_states.download()  # sync
        rows = np.flatnonzero(states["contends"][:count])
        poses, inliers = states["best"][rows].copy(), states["inliers"][rows, 0].astype(int)
        self._contest(result, poses, inliers, states["counts"][rows].copy(), distance)

    def _select_distinct(self, poses: Poses, scores: Integers, distance: float) -> int:
        """Keep the best distinct poses. Return how many to evaluate, all on CUDA."""
        max_score = self.ranking.count
        order = argsort_keys(descending_keys(scores, max_score), (max_score + 1).bit_length())[1]
        threads = 32 if self.device.is_cuda else 1
        limits = [self.fitness.size, distance * distance, self._probes, self._distinct, self._distinct_count]
        launch(select_distinct_kernel, threads, [poses, scores, order, *limits])
        return MAX_DISTINCT if self.device.is_cuda else int(download(self._distinct_count)[0])

    def _contest(
        self, result: PoseSearchResult, poses: np.ndarray, inliers: np.ndarray, counts: np.ndarray, distance: float
    ) -> None:
        """Replace the best so far if one of some poses is better."""
        if len(poses) == 0:
            return
        top = int(counts.max())
        if top < result.count:
            return
        for row in np.flatnonzero(counts == top):
            squares = None
            if top == result.count:
                if (poses[row] == result.pose).all():  # the same pose was found again
                    continue
                if result.squares is None:
                    result.squares = self._squares(result.pose, distance)
                squares = self._squares(poses[row], distance)
                if squares >= result.squares:
                    continue
            result.pose, result.count, result.squares, result.inliers = poses[row], top, squares, int(inliers[row])

    def _squares(self, pose: np.ndarray, distance: float) -> float:
        sums = self.fitness.match(upload(pose[None], mat44d, self.device), distance)
        return float(download(sums)[0][-1])  # sync: only for ties of the match count
