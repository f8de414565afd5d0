"""Pose hypotheses from random samples of correspondences, drawn, checked and scored in batches.

Fischler and Bolles, "Random sample consensus", CACM 1981. Samples depend only on (seed, hypothesis number). A length
check rejects most samples before fitting. A thread scores eight poses on a run of blocks with integer counts.
"""

import math
from collections.abc import Sequence
from functools import cached_property

from ..algebra.rigid_solve import fit_pose, move, pair_sums, rotate, sums_of_pair
from ..algebra.transform import widen
from ..array_types import Indices, Integers, Poses, Vectors
from ..arrays.random import random_below, random_bits
from ..arrays.select import positions_of
from ..lang import (
    WARP,
    array,
    asin,
    atan2,
    atomic_add,
    ballot,
    bit_count,
    dot,
    float32,
    float64,
    func,
    int32,
    kernel,
    lane,
    launch,
    mat44d,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vector,
)
from ..memory import empty
from .pair_fits import PAIRS_PER_BLOCK, PairCoordinates, source_point, target_point

POSES_PER_THREAD = 8  # poses per thread
CPU_RUN = 16  # blocks per thread: few atomics
CUDA_BLOCK = 1024  # correspondences per warp
REJECTED_SCORE = -1  # score of a rejected hypothesis
MIN_SAMPLE_EXTENT = 1.0e-6  # of the target's extent: samples shrunk below by scaling are rejected
eight_counts = vector(POSES_PER_THREAD, int32)
pose_numbers = vector(12, float32)


@struct
class Checks:
    """Checks of samples and poses: minimum length ratio `similarity` 0..1, maximum `distance` [m], minimum `cosine` of
    normals, maximum `rotation` angles [rad] of Rz Ry Rx.
    """

    similarity: float64
    distance: float64
    cosine: float64
    rotation: vec3d

    def __init__(
        self,
        similarity: float = 0.0,
        distance: float = math.inf,
        cosine: float = -math.inf,
        rotation: tuple[float, ...] = (math.inf,) * 3,
    ) -> None:
        self.similarity, self.distance, self.cosine, self.rotation = similarity, distance, cosine, rotation


@struct
class Samples:
    """Samples of a round, from number `first`: `rows` (count * size); `is_valid`: 1 if the length checks pass."""

    pairs: PairCoordinates
    size: int
    rows: array(dtype=int32)
    is_valid: array(dtype=uint8)

    def __init__(
        self, pairs: PairCoordinates, size: int, count: int, checks: Checks, seed: int, first: int = 0
    ) -> None:
        device = pairs.device
        self.pairs, self.size, self.rows = pairs, size, empty(count * size, int32, device)
        self.is_valid = empty(count, uint8, device)
        launch(draw_samples_kernel, count, [self, checks, seed, first])

    @cached_property
    def similar(self) -> Integers:
        """Samples whose lengths agree, int32 device array. One sync."""
        return positions_of(self.is_valid)

    def fit(
        self, checks: Checks, normals: Sequence[Vectors], with_scaling: bool, chosen: Indices | None = None
    ) -> tuple[Poses, Integers]:
        """Poses of `chosen` samples (None: of similar lengths), and scores: REJECTED_SCORE without a pose, else 0."""
        chosen, device = self.similar if chosen is None else chosen, self.pairs.device
        poses, scores = empty(chosen.size, mat44d, device), empty(chosen.size, int32, device)
        launch(fit_samples_kernel, chosen.size, [self, chosen, checks, *normals, int(with_scaling), poses, scores])
        return poses, scores


@func
def agree_in_length(p: vec3d, q: vec3d, other_p: vec3d, other_q: vec3d, similarity: float64) -> int:
    """1 if the source and target lengths are similar and nonzero."""
    u = p - other_p
    v = q - other_q
    a = dot(u, u)
    b = dot(v, v)
    min_sqratio = similarity * similarity
    return 0 if a < min_sqratio * b or b < min_sqratio * a or a == 0.0 or b == 0.0 else 1


@kernel
def draw_samples_kernel(samples: Samples, checks: Checks, seed: int, first: int):
    """Draw distinct sample `first + i` (Bentley and Floyd, CACM 1987). 1 if all its lengths agree."""
    i = tid()
    base = i * samples.size
    similar = 1
    for j in range(samples.size):
        if similar == 1:
            last = samples.pairs.count - samples.size + j
            drawn = random_below(random_bits(seed, first + i, j), last + 1)
            for earlier in range(base, base + j):
                if samples.rows[earlier] == drawn:
                    drawn = last
            samples.rows[base + j] = drawn
            p = source_point(samples.pairs, drawn)
            q = target_point(samples.pairs, drawn)
            for earlier in range(base, base + j):
                row = samples.rows[earlier]
                other_p = source_point(samples.pairs, row)
                other_q = target_point(samples.pairs, row)
                if agree_in_length(p, q, other_p, other_q, checks.similarity) == 0:
                    similar = 0
    samples.is_valid[i] = uint8(similar)


@func
def is_rotation_within(pose: mat44d, scale: float64, limits: vec3d) -> int:
    """1 if no angle [rad] of a rotation Rz Ry Rx exceeds its limit."""
    x = abs(atan2(pose[2, 1], pose[2, 2]))
    y = abs(asin(max(min(pose[2, 0] / scale, 1.0), -1.0)))
    z = abs(atan2(pose[1, 0], pose[0, 0]))
    return 1 if x <= limits[0] and y <= limits[1] and z <= limits[2] else 0


@func
def scale_of(pose: mat44d) -> float64:
    return sqrt(pose[0, 0] * pose[0, 0] + pose[1, 0] * pose[1, 0] + pose[2, 0] * pose[2, 0])


@kernel(max_registers=128)  # for two blocks per SM
def fit_samples_kernel(
    samples: Samples,
    chosen: array(dtype=int32),
    checks: Checks,
    source_normals: array(dtype=vec3),
    target_normals: array(dtype=vec3),
    with_scaling: int,
    poses: array(dtype=mat44d),
    scores: array(dtype=int32),
):
    """Pose of each chosen sample. Score 0, or REJECTED_SCORE if a check fails."""
    i = tid()
    if samples.is_valid[chosen[i]] == 0:
        scores[i] = REJECTED_SCORE
        return
    base = chosen[i] * samples.size
    middle_p = source_point(samples.pairs, samples.rows[base])
    middle_q = target_point(samples.pairs, samples.rows[base])
    s = pair_sums(0.0)
    for j in range(base, base + samples.size):  # relative to the first point, to keep precision
        p = source_point(samples.pairs, samples.rows[j]) - middle_p
        q = target_point(samples.pairs, samples.rows[j]) - middle_q
        s += sums_of_pair(p, q, 1.0)
    pose = fit_pose(s, with_scaling)
    scale = scale_of(pose)
    score = 0
    if scale * scale * s[16] < float64(MIN_SAMPLE_EXTENT * MIN_SAMPLE_EXTENT) * s[17]:
        score = REJECTED_SCORE
    shift = middle_q - rotate(pose, middle_p)
    for axis in range(3):
        pose[axis, 3] = pose[axis, 3] + shift[axis]
    for j in range(base, base + samples.size):
        row = samples.rows[j]
        r = move(pose, source_point(samples.pairs, row)) - target_point(samples.pairs, row)
        if dot(r, r) > checks.distance * checks.distance:
            score = REJECTED_SCORE
        if source_normals.shape[0] > 0:
            n = rotate(pose, widen(source_normals[samples.pairs.rows[row, 0]]))
            if dot(n, widen(target_normals[samples.pairs.rows[row, 1]])) < checks.cosine * scale:
                score = REJECTED_SCORE
    if is_rotation_within(pose, scale, checks.rotation) == 0:
        score = REJECTED_SCORE
    poses[i] = pose
    scores[i] = score


@func
def narrow_pose(pose: mat44d) -> pose_numbers:
    d = pose_numbers(0.0)
    for row in range(3):
        for column in range(3):
            d[3 * row + column] = float(pose[row, column])
        d[9 + row] = float(pose[row, 3])
    return d


@func
def paired_sqdist(j: int, pose: pose_numbers, pairs: PairCoordinates) -> float:
    px = pairs.coordinates[j]
    py = pairs.coordinates[pairs.count + j]
    pz = pairs.coordinates[2 * pairs.count + j]
    x = pose[0] * px + pose[1] * py + pose[2] * pz + pose[9] - pairs.coordinates[3 * pairs.count + j]
    y = pose[3] * px + pose[4] * py + pose[5] * pz + pose[10] - pairs.coordinates[4 * pairs.count + j]
    z = pose[6] * px + pose[7] * py + pose[8] * pz + pose[11] - pairs.coordinates[5 * pairs.count + j]
    return x * x + y * y + z * z


@kernel
def score_poses_kernel(
    pairs: PairCoordinates,
    run: int,
    size_of_block: int,
    poses: array(dtype=mat44d),
    limit: float,
    scores: array(dtype=int32),
):
    """Count correspondences within a squared distance under each pose. Integer sums."""
    i = tid()
    groups = (poses.shape[0] + POSES_PER_THREAD - 1) // POSES_PER_THREAD
    head = (i // groups) * run
    start = (i % groups) * POSES_PER_THREAD
    size = min(POSES_PER_THREAD, poses.shape[0] - start)
    totals = eight_counts(0)
    for block in range(head, min(head + run, (pairs.count + size_of_block - 1) // size_of_block)):
        first = block * size_of_block
        last = min(first + size_of_block, pairs.count)
        for k in range(size):
            if scores[start + k] != REJECTED_SCORE:
                pose = narrow_pose(poses[start + k])
                count = 0
                for j in range(first, last):
                    if paired_sqdist(j, pose, pairs) < limit:
                        count += 1
                totals[k] = totals[k] + count
    for k in range(size):
        if totals[k] > 0:
            atomic_add(scores, start + k, totals[k])


@score_poses_kernel.on_cuda
def score_in_lanes_kernel(
    pairs: PairCoordinates,
    run: int,
    size_of_block: int,
    poses: array(dtype=mat44d),
    limit: float,
    scores: array(dtype=int32),
):
    """CUDA variant, one correspondence per lane. A warp skips refused poses together."""
    i = tid()
    groups = (poses.shape[0] + POSES_PER_THREAD - 1) // POSES_PER_THREAD
    first = (i // WARP // groups) * size_of_block
    last = min(first + size_of_block, pairs.count)
    start = (i // WARP % groups) * POSES_PER_THREAD
    for k in range(start, min(start + POSES_PER_THREAD, poses.shape[0])):
        if scores[k] != REJECTED_SCORE:
            pose = narrow_pose(poses[k])
            count = 0
            for step in range((last - first + WARP - 1) // WARP):
                j = first + step * WARP + lane()
                is_near = 0
                if j < last:
                    if paired_sqdist(j, pose, pairs) < limit:
                        is_near = 1
                count += bit_count(ballot(is_near))
            if lane() == 0 and count > 0:
                atomic_add(scores, k, count)  # integer sum: order-independent


def score_poses(pairs: PairCoordinates, poses: Poses, distance: float, scores: Integers) -> None:
    """Add the correspondences closer than `distance` [m] under each pose to `scores` int32 (k), unless rejected."""
    run, block, lanes = (1, CUDA_BLOCK, WARP) if pairs.device.is_cuda else (CPU_RUN, PAIRS_PER_BLOCK, 1)
    threads = -(-pairs.count // (block * run)) * -(-poses.size // POSES_PER_THREAD) * lanes
    launch(score_poses_kernel, threads, [pairs, run, block, poses, distance * distance, scores])
