"""Poses that many correspondences agree with, found from the graph of those that are compatible, without drawing lots.

A pose is fitted to each seed and the correspondences that share most neighbours with it, all poses are scored by how
many correspondences they bring within the noise, and the best are fitted again by graduated non-convexity: weights of
truncated least squares whose surrogate starts nearly convex and ends as the truncated cost itself (Yang et al.,
"Graduated non-convexity for robust spatial perception", RA-L 2020, eqs. 13 and 14). Since the poses begin near a
consensus, the surrogate starts at twice the noise bound rather than at the largest residual.

Sums are float64 in a fixed order: by blocks of correspondences in a thread each, then the blocks of a pose in one
thread. A step of all poses is two launches.
"""

import numpy as np

from ..algebra.rigid_solve import fit_pose, move, pair_sums, sums_of_pair
from ..array_types import Doubles, Indices, Integers, Poses
from ..lang import array, dot, float64, func, int32, kernel, launch, mat44d, segment_reduction, sqrt, tid
from ..memory import cast, download, empty, upload
from .compatibility_graph import CompatibilityGraph
from .pair_fits import (
    FEWEST,
    SUMS,
    PairCoordinates,
    PoseSums,
    all_sums,
    fit_of,
    fold_blocks,
    joined_sums,
    residuals_of_block,
    source_point,
    store_sums,
    target_point,
)
from .pose_hypotheses import score_poses

SEEDS = 256  # poses that are scored
NEIGHBORS = 20  # correspondences of a seed that a pose is fitted to: SC2-PCR takes 20 to 30
FITTED = 32  # poses that are fitted again, no two of them alike
SAME = 3.0  # distances of a right correspondence: poses nearer to each other are one
STEPS = 14  # of graduated non-convexity: the surrogate's share grows from 1/3 by STEP to 40
FIRST_SHARE, STEP = 1.0 / 3.0, 1.4  # mu of the paper: weights vanish at sqrt((mu + 1) / mu) = 2 noise bounds first


@func
def truncated_weight(sqdist: float64, limit: float64, share: float64) -> float64:
    """The weight of a residual under the surrogate `share` of least squares truncated at `limit` [m^2]."""
    w = float64(1.0)
    if sqdist >= limit * (share + 1.0) / share:
        w = 0.0
    elif sqdist > limit * share / (share + 1.0):
        w = sqrt(limit / sqdist * share * (share + 1.0)) - share
    return w


@func
def least_common(common: array(dtype=int32), row: int, count: int, wanted: int) -> int:
    """The number that at least `wanted` entries of a row reach, the largest such number, but at least 1."""
    low = 1
    high = 1
    for j in range(row, row + count):
        high = max(high, common[j])
    while high > low:
        middle = (low + high + 1) // 2
        found = 0
        for j in range(row, row + count):
            found += 1 if common[j] >= middle else 0
        if found >= wanted:
            low = middle
        else:
            high = middle - 1
    return low


@kernel
def fit_seeds_kernel(
    pairs: PairCoordinates,
    seeds: array(dtype=int32),
    common: array(dtype=int32),
    wanted: int,
    poses: array(dtype=mat44d),
    scores: array(dtype=int32),
):
    """The pose of each seed and those that share most neighbours with it, weighted by how many they share."""
    i = tid()
    row = i * pairs.count
    least = least_common(common, row, pairs.count, wanted)
    s = pair_sums(0.0)
    most = 0
    for j in range(pairs.count):
        shared = common[row + j]
        if shared >= least:
            most = max(most, shared)
            s += sums_of_pair(source_point(pairs, j), target_point(pairs, j), float64(shared))
    seed = seeds[i]
    s += sums_of_pair(source_point(pairs, seed), target_point(pairs, seed), float64(max(most, 1)))
    poses[i] = fit_pose(s, 0)
    scores[i] = 0


@kernel(for_cpu=True)
def sum_truncated_kernel(
    pairs: PairCoordinates,
    poses: array(dtype=mat44d),
    limit: float64,
    share: float64,
    partials: array(dtype=float64, ndim=2),
):
    """The weighted sums of one block of correspondences under one pose; last, what they save of the truncated cost."""
    i = tid()
    pose = poses[i // pairs.blocks]
    s = pair_sums(0.0)
    saved = float64(0.0)
    for p, q, sqdist in residuals_of_block(i % pairs.blocks, pose, pairs):
        w = truncated_weight(sqdist, limit, share)
        if w > 0.0:
            s += sums_of_pair(p, q, w)
        if sqdist < limit:
            saved += 1.0 - sqdist / limit
    store_sums(i, s, saved, partials)


@segment_reduction
def sum_truncated(pairs: PairCoordinates, poses: array(dtype=mat44d), limit: float64, share: float64) -> all_sums:
    """The weighted sums of one correspondence under one pose; last, what it saves of the truncated cost."""
    i = tid()
    p = source_point(pairs, i % pairs.count)
    q = target_point(pairs, i % pairs.count)
    r = move(poses[i // pairs.count], p) - q
    sqdist = dot(r, r)
    saved = float64(0.0)
    if sqdist < limit:
        saved = 1.0 - sqdist / limit
    return joined_sums(sums_of_pair(p, q, truncated_weight(sqdist, limit, share)), saved)


@kernel
def step_poses_kernel(
    partials: array(dtype=float64, ndim=2),
    blocks: int,
    last: int,
    poses: array(dtype=mat44d),
    saved: array(dtype=float64),
):
    """What each pose saves; then, unless it is the last, fit it to its weighted correspondences where these fix one."""
    i = tid()
    total = fold_blocks(partials, i * blocks, blocks)
    saved[i] = total[SUMS]
    if last == 0 and total[0] >= float64(FEWEST):
        poses[i] = fit_of(total, poses[i], 0)


def seed_poses(graph: CompatibilityGraph, seeds: Integers) -> tuple[Poses, Indices]:
    """Poses of seeds and their best neighbours: (mat44d [s], int32 [s] of zeros)."""
    poses, scores = empty(seeds.size, mat44d, graph.device), empty(seeds.size, int32, graph.device)
    wanted = min(NEIGHBORS, graph.count)
    launch(fit_seeds_kernel, seeds.size, [graph.pairs, seeds, graph.common(seeds), wanted, poses, scores])
    return poses, scores


def refit_truncated(pairs: PairCoordinates, poses: Poses, distance: float, steps: int = STEPS) -> Doubles:
    """Fit poses (device array of mat44d, overwritten) by graduated non-convexity.

    Returns:
        float64 device array: what each pose saves of the truncated cost, the sum of 1 - (residual / distance)^2 over
        the correspondences closer than `distance` [m].
    """
    saved = empty(poses.size, float64, pairs.device)
    sums, limit, share = PoseSums(pairs, poses.size), distance * distance, FIRST_SHARE
    for step in range(steps + 1):
        sums.add_up(sum_truncated_kernel, sum_truncated, [poses, limit, share])
        launch(step_poses_kernel, poses.size, [sums.rows, sums.blocks, int(step == steps), poses, saved])
        share *= STEP
    return saved


def distinct_poses(poses: np.ndarray, spread: np.ndarray, apart: float) -> np.ndarray:
    """Which of some poses to keep so that none moves the source to within `apart` [m] of where an earlier one does.

    Args:
        poses: float64 [k, 4, 4], the best first.
        spread: Points [p, 3] that stand for the source.
        apart: Root mean square distance [m] of these points under two poses that counts as two.

    Returns:
        int [kept], ascending.
    """
    moved = np.einsum("kij,pj->kpi", poses[:, :3, :3], spread) + poses[:, None, :3, 3]
    flat = moved.reshape(len(poses), 3 * len(spread)) / np.sqrt(max(len(spread), 1))
    kept, left = [], np.ones(len(poses), bool)
    while left.any():
        kept.append(int(np.argmax(left)))
        gaps = flat - flat[kept[-1]]
        left &= ~((gaps * gaps).sum(axis=1) <= apart * apart)
        left[kept[-1]] = False
    return np.array(kept, np.int64)


@kernel
def stack_poses_kernel(poses: array(dtype=mat44d), values: array(dtype=float64), rows: array(dtype=float64, ndim=2)):
    """A value and the pose beside it."""
    i = tid()
    rows[i, 0] = values[i]
    pose = poses[i]
    for j in range(4):
        for k in range(4):
            rows[i, 1 + 4 * j + k] = pose[j, k]


def read_poses(poses: Poses, values: Doubles) -> tuple[np.ndarray, np.ndarray]:
    """A number of each pose and the poses, float64 [k] and [k, 4, 4] on the host. One sync."""
    rows = empty((poses.size, 17), float64, poses.device)
    launch(stack_poses_kernel, poses.size, [poses, values, rows])
    found = download(rows).copy()  # sync
    return found[:, 0], found[:, 1:].reshape(-1, 4, 4)


def find_consensus(
    pairs: PairCoordinates, bound: float, distance: float, spread: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The poses that most correspondences agree with, the best first, no two of them alike.

    Args:
        pairs: A PairCoordinates.
        bound: Most difference [m] of two distances between compatible correspondences.
        distance: Of a right correspondence under its pose [m].
        spread: Points [p, 3] about the source's middle that stand for it: poses that move them alike are one.

    Returns:
        (poses float64 [k, 4, 4] about the middles of the pairs, savings float64 [k]) on the host; k is 0 where no
        three correspondences are compatible.
    """
    nothing = np.empty((0, 4, 4)), np.empty(0)
    if pairs.count < FEWEST:
        return nothing
    graph = CompatibilityGraph(pairs, bound, bound)
    seeds = graph.peaks(graph.support(), 2 * distance, SEEDS)
    if seeds.size == 0:
        return nothing
    poses, scores = seed_poses(graph, seeds)
    score_poses(pairs, poses, distance, scores)
    ranked, placed = read_poses(poses, cast(scores, float64))  # sync
    order = np.argsort(-ranked, kind="stable")
    order = order[distinct_poses(placed[order], spread, SAME * distance)][:FITTED]
    chosen = upload(placed[order], mat44d, pairs.device)
    saved, refitted = read_poses(chosen, refit_truncated(pairs, chosen, distance))  # sync
    best = np.argsort(-saved, kind="stable")
    fitted = refitted[best]
    kept = distinct_poses(fitted, spread, SAME * distance)
    return fitted[kept], saved[best][kept]
