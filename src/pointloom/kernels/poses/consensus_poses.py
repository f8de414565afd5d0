"""Poses supported by many correspondences, from a compatibility graph, without random sampling.

An edge joins correspondences that preserve the distance between their ends within twice the noise (TEASER: Yang, Shi
and Carlone 2021, section IV). Common neighbors separate inliers at 1 % (SC2-PCR: Chen et al., CVPR 2022, section 3.2).
Each seed and its best neighbors give a pose. The best are refined by graduated non-convexity (Yang et al., RA-L 2020,
eqs. 13 and 14), starting at twice the noise bound. Bit rows of m^2 / 8 bytes. Fixed-order sums. On the CPU a thread
computes a row of the graph, on CUDA a warp computes a row or a word of it.
"""

import numpy as np

from ..algebra.plain_min_max import smaller
from ..algebra.rigid_solve import fit_pose, move, pair_sums, sums_of_pair
from ..array_types import Doubles, Indices, Integers, LongIntegers, Poses
from ..arrays.lanes import min_int_of_lanes, sum_int_of_lanes
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import argsort_keys
from ..lang import (
    WARP,
    array,
    atomic_add,
    ballot,
    bit_count,
    compute,
    cuda_func,
    dot,
    float64,
    func,
    int32,
    int64,
    kernel,
    lane,
    launch,
    mat44d,
    segment_reduction,
    shuffle,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
)
from ..memory import cast, download, empty, upload, zeros
from ..search.tree_walk import lowest_bit
from .pair_fits import (
    MIN_PAIRS,
    MOMENT_COUNT,
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

BITS_PER_WORD = 32  # bits a word
WORDS_READ = 2**29  # words read when counting common neighbors: half a second on one core
SUM_BITS = 45  # of a sum of common neighbors: below m^2, with m^2 / 8 bytes in memory


@struct
class CompatibilityGraph:
    """Graph of correspondences: edges join two with distances that differ by at most `bound` [m] and exceed
    `min_length` [m]. `bits`: bit j % 32 of word j // 32 of row i is the edge (i, j).
    """

    pairs: PairCoordinates
    words: int
    bits: array(dtype=int32)
    degrees: array(dtype=int32)

    def __init__(self, pairs: PairCoordinates, bound: float, min_length: float) -> None:
        self.pairs, self.device, self.count = pairs, pairs.device, pairs.count
        self.words = -(-self.count // BITS_PER_WORD)
        self.bits = empty(self.count * self.words, int32, self.device)
        self.degrees = empty(self.count, int32, self.device)
        self.warp = WARP if self.device.is_cuda else 1  # threads of a row
        self.warps = self.words * WARP if self.device.is_cuda else 1
        launch(connect_pairs_kernel, self.count * self.warp, [self, bound, min_length])

    def support(self, work: int = WORDS_READ) -> LongIntegers:
        """Twice the triangles of each vertex, int64 (m). 0 for low degrees beyond `work` words."""
        sums = zeros(self.count, int64, self.device)
        order = order_descending(cast(self.degrees, int64))
        ranked = download(gather_rows(self.degrees, order)).cumsum(dtype="int64")  # sync
        counted = max(1, int((ranked * self.words <= work).sum()))
        launch(sum_common_kernel, counted * self.warps, [self, order[:counted], sums])
        return sums

    def peaks(self, sums: LongIntegers, distance: float, max_count: int) -> Integers:
        """Vertices with the largest sums, none near a larger one at both ends; int32, descending."""
        mask = empty(self.count, uint8, self.device)
        launch(mark_peaks_kernel, self.count * self.warp, [self.pairs, distance * distance, sums, mask])
        rows = positions_of(mask)  # sync
        if rows.size == 0:
            return rows
        order = order_descending(gather_rows(sums, rows))
        return gather_rows(rows, order[: min(max_count, rows.size)])

    def common(self, rows: Indices) -> Integers:
        """Common neighbors of some rows with all vertices, int32 (rows * m). 0 without an edge."""
        common = empty(rows.size * self.count, int32, self.device)
        launch(list_common_kernel, rows.size * self.warps, [self, rows, common])
        return common


@func
def source_of(i: int, pairs: PairCoordinates) -> vec3:
    return vec3(pairs.coordinates[i], pairs.coordinates[pairs.count + i], pairs.coordinates[2 * pairs.count + i])


@func
def target_of(i: int, pairs: PairCoordinates) -> vec3:
    at = 3 * pairs.count + i
    return vec3(pairs.coordinates[at], pairs.coordinates[pairs.count + at], pairs.coordinates[2 * pairs.count + at])


@func
def is_edge(p: vec3, q: vec3, j: int, graph: CompatibilityGraph, bound: float, min_length: float) -> int:
    """1 if correspondence j is compatible with the ends p and q. 0 for a correspondence with itself."""
    x = source_of(j, graph.pairs) - p
    u = target_of(j, graph.pairs) - q
    a = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
    b = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2])
    return (1 if abs(a - b) <= bound else 0) & (1 if smaller(a, b) > min_length else 0)


@kernel
def connect_pairs_kernel(graph: CompatibilityGraph, bound: float, min_length: float):
    """One row of the graph and its degree."""
    i = tid()
    p = source_of(i, graph.pairs)
    q = target_of(i, graph.pairs)
    degree = 0
    for w in range(graph.words):
        first = w * BITS_PER_WORD
        word = 0
        for j in range(first, min(first + BITS_PER_WORD, graph.pairs.count)):
            word = word | (is_edge(p, q, j, graph, bound, min_length) << (j - first))
        graph.bits[i * graph.words + w] = word
        degree += bit_count(word)
    graph.degrees[i] = degree


@connect_pairs_kernel.on_cuda
def connect_in_lanes_kernel(graph: CompatibilityGraph, bound: float, min_length: float):
    """CUDA variant: a warp per row, a lane per bit of a word."""
    i = tid()
    row = i // WARP
    p = source_of(row, graph.pairs)
    q = target_of(row, graph.pairs)
    degree = 0
    for w in range(graph.words):
        j = w * BITS_PER_WORD + lane()
        edge = 0
        if j < graph.pairs.count:
            edge = is_edge(p, q, j, graph, bound, min_length)
        word = ballot(edge)
        if lane() == 0:
            graph.bits[row * graph.words + w] = word
        degree += bit_count(word)
    if lane() == 0:
        graph.degrees[row] = degree


@kernel
def descending_keys_kernel(values: array(dtype=int64), top: int64, keys: array(dtype=int64)):
    """Keys whose ascending order is the descending order of the values."""
    i = tid()
    keys[i] = top - values[i]


@func
def count_shared(row: int, other: int, graph: CompatibilityGraph) -> int:
    a = row * graph.words
    b = other * graph.words
    shared = 0
    for k in range(graph.words):
        shared += bit_count(graph.bits[a + k] & graph.bits[b + k])
    return shared


@cuda_func
def shared_by_lane(row: int, other: int, graph: CompatibilityGraph) -> int:
    """A lane's part of `count_shared`."""
    shared = 0
    for step in range((graph.words + WARP - 1) // WARP):
        k = step * WARP + lane()
        if k < graph.words:
            shared += bit_count(graph.bits[row * graph.words + k] & graph.bits[other * graph.words + k])
    return shared


@kernel
def sum_common_kernel(graph: CompatibilityGraph, rows: array(dtype=int32), sums: array(dtype=int64)):
    """Twice the number of triangles of a row."""
    i = tid()
    row = rows[i] * graph.words
    total = int64(0)
    for w in range(graph.words):
        left = graph.bits[row + w]
        while left != 0:
            lowest = left & (-left)
            left = left ^ lowest
            total += int64(count_shared(rows[i], w * BITS_PER_WORD + bit_count(lowest - 1), graph))
    sums[rows[i]] = total


@sum_common_kernel.on_cuda
def sum_common_in_lanes_kernel(graph: CompatibilityGraph, rows: array(dtype=int32), sums: array(dtype=int64)):
    """CUDA variant: a warp per word of a row. The sums must be 0 before."""
    i = tid()
    row = rows[i // WARP // graph.words]
    w = i // WARP % graph.words
    left = graph.bits[row * graph.words + w]
    shared = 0
    while left != 0:
        shared += shared_by_lane(row, w * BITS_PER_WORD + lowest_bit(left), graph)
        left = left & (left - 1)
    total = sum_int_of_lanes(shared)
    if lane() == 0 and total > 0:
        atomic_add(sums, row, int64(total))  # integer sum: order-independent


@kernel
def list_common_kernel(graph: CompatibilityGraph, rows: array(dtype=int32), common: array(dtype=int32)):
    """Common neighbors of a row with each adjacent correspondence. 0 for others."""
    i = tid()
    row = rows[i] * graph.words
    for j in range(graph.pairs.count):
        common[i * graph.pairs.count + j] = 0
    for w in range(graph.words):
        left = graph.bits[row + w]
        while left != 0:
            lowest = left & (-left)
            left = left ^ lowest
            column = w * BITS_PER_WORD + bit_count(lowest - 1)
            common[i * graph.pairs.count + column] = count_shared(rows[i], column, graph)


@list_common_kernel.on_cuda
def list_common_in_lanes_kernel(graph: CompatibilityGraph, rows: array(dtype=int32), common: array(dtype=int32)):
    """CUDA variant: a warp per word of a row, whose lanes write the numbers of its columns."""
    i = tid()
    row = i // WARP // graph.words
    w = i // WARP % graph.words
    column = w * BITS_PER_WORD + lane()
    left = graph.bits[rows[row] * graph.words + w]
    own = 0
    while left != 0:
        other = w * BITS_PER_WORD + lowest_bit(left)
        shared = sum_int_of_lanes(shared_by_lane(rows[row], other, graph))
        if column == other:
            own = shared
        left = left & (left - 1)
    if column < graph.pairs.count:
        common[row * graph.pairs.count + column] = own


@func
def is_exceeded_by(
    i: int, p: vec3, q: vec3, j: int, pairs: PairCoordinates, sqradius: float, sums: array(dtype=int64)
) -> int:
    """1 if correspondence j is near i at both ends, p and q, and has more support (ties: lower index)."""
    x = source_of(j, pairs) - p
    u = target_of(j, pairs) - q
    near = 1 if x[0] * x[0] + x[1] * x[1] + x[2] * x[2] < sqradius else 0
    near = near & (1 if u[0] * u[0] + u[1] * u[1] + u[2] * u[2] < sqradius else 0)
    more = (1 if sums[j] > sums[i] else 0) | ((1 if sums[j] == sums[i] else 0) & (1 if j < i else 0))
    return near & more


@kernel
def mark_peaks_kernel(pairs: PairCoordinates, sqradius: float, sums: array(dtype=int64), peaks: array(dtype=uint8)):
    """1 if no correspondence near this one at both ends has more support."""
    i = tid()
    p = source_of(i, pairs)
    q = target_of(i, pairs)
    is_exceeded = 0
    for j in range(pairs.count):
        is_exceeded = is_exceeded | is_exceeded_by(i, p, q, j, pairs, sqradius, sums)
    peaks[i] = uint8(1 if is_exceeded == 0 and sums[i] > 0 else 0)


@mark_peaks_kernel.on_cuda
def mark_peaks_in_lanes_kernel(
    pairs: PairCoordinates, sqradius: float, sums: array(dtype=int64), peaks: array(dtype=uint8)
):
    """CUDA variant: a warp per correspondence, whose lanes test 32 others until one exceeds it."""
    i = tid()
    row = i // WARP
    p = source_of(row, pairs)
    q = target_of(row, pairs)
    is_peak = 1 if sums[row] > 0 else 0
    first = 0
    while is_peak == 1 and first < pairs.count:
        j = first + lane()
        is_exceeded = 0
        if j < pairs.count:
            is_exceeded = is_exceeded_by(row, p, q, j, pairs, sqradius, sums)
        if ballot(is_exceeded) != 0:
            is_peak = 0
        first += WARP
    if lane() == 0:
        peaks[row] = uint8(is_peak)


def order_descending(values: LongIntegers) -> Indices:
    """Descending order of non-negative int64 values, ties by index; int32."""
    keys = compute(descending_keys_kernel, values.size, [values, (1 << SUM_BITS) - 1], int64, values.device)
    return argsort_keys(keys, SUM_BITS)[1]


MAX_SEEDS = 256  # poses scored
MAX_SEED_PAIRS = 20  # correspondences per seed fit: SC2-PCR uses 20 to 30; at most the lanes of a warp
MAX_INT = 0x7FFF_FFFF  # above all numbers of common neighbors
MAX_REFITTED = 32  # distinct poses refitted
MIN_POSE_DISTANCE = 3.0  # inlier distances: closer poses are equal
ANNEALING_STEPS = 14  # of graduated non-convexity: mu grows from 1/3 by MU_GROWTH to 40
# Mu of the paper: weights initially vanish at sqrt((mu + 1) / mu) = 2 noise bounds
FIRST_FRACTION, MU_GROWTH = 1.0 / 3.0, 1.4


@func
def truncated_weight(sqdist: float64, limit: float64, fraction: float64) -> float64:
    """Weight of a residual under the surrogate `fraction` of least squares truncated at `limit` [m^2]."""
    w = float64(1.0)
    if sqdist >= limit * (fraction + 1.0) / fraction:
        w = 0.0
    elif sqdist > limit * fraction / (fraction + 1.0):
        w = sqrt(limit / sqdist * fraction * (fraction + 1.0)) - fraction
    return w


@func
def common_threshold(common: array(dtype=int32), row: int, count: int, wanted: int) -> int:
    """Largest number >= 1 that at least `wanted` entries of a row reach."""
    low = 1
    high = 1
    for j in range(row, row + count):
        high = max(high, common[j])
    while high > low:
        middle = (low + high + 1) // 2
        reaching = 0
        for j in range(row, row + count):
            reaching += 1 if common[j] >= middle else 0
        if reaching >= wanted:
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
    """Pose of each seed and its best neighbors, weighted by common neighbors."""
    i = tid()
    row = i * pairs.count
    threshold = common_threshold(common, row, pairs.count, wanted)
    s = pair_sums(0.0)
    max_shared = 0
    for j in range(pairs.count):
        shared = common[row + j]
        if shared >= threshold:
            max_shared = max(max_shared, shared)
            s += sums_of_pair(source_point(pairs, j), target_point(pairs, j), float64(shared))
    seed = seeds[i]
    s += sums_of_pair(source_point(pairs, seed), target_point(pairs, seed), float64(max(max_shared, 1)))
    poses[i] = fit_pose(s, 0)
    scores[i] = 0


@cuda_func
def threshold_of_lanes(common: array(dtype=int32), row: int, count: int, wanted: int) -> int:
    """`common_threshold` in one pass: each of the first `wanted` lanes keeps one of the largest numbers."""
    kept = 0 if lane() < wanted else int(MAX_INT)
    lowest = 0
    for step in range((count + WARP - 1) // WARP):
        j = step * WARP + lane()
        shared = 0
        if j < count:
            shared = common[row + j]
        above = ballot(1 if shared > lowest else 0)
        while above != 0:
            larger = shuffle(shared, lowest_bit(above))
            if larger > lowest:
                if lane() == lowest_bit(ballot(1 if kept == lowest else 0)):
                    kept = larger
                lowest = min_int_of_lanes(kept)
            above = above & (above - 1)
    return max(lowest, 1)


@fit_seeds_kernel.on_cuda
def fit_seeds_in_lanes_kernel(
    pairs: PairCoordinates,
    seeds: array(dtype=int32),
    common: array(dtype=int32),
    wanted: int,
    poses: array(dtype=mat44d),
    scores: array(dtype=int32),
):
    """CUDA variant: a warp per seed, whose lanes select neighbors. All lanes add them up in the same order."""
    i = tid()
    at = i // WARP
    row = at * pairs.count
    threshold = threshold_of_lanes(common, row, pairs.count, wanted)
    s = pair_sums(0.0)
    max_shared = 1
    for step in range((pairs.count + WARP - 1) // WARP):
        j = step * WARP + lane()
        own = 0
        if j < pairs.count:
            own = common[row + j]
        selected = ballot(1 if own >= threshold else 0)
        while selected != 0:
            k = step * WARP + lowest_bit(selected)
            shared = shuffle(own, lowest_bit(selected))
            max_shared = max(max_shared, shared)
            s += sums_of_pair(source_point(pairs, k), target_point(pairs, k), float64(shared))
            selected = selected & (selected - 1)
    seed = seeds[at]
    s += sums_of_pair(source_point(pairs, seed), target_point(pairs, seed), float64(max_shared))
    if lane() == 0:
        poses[at] = fit_pose(s, 0)
        scores[at] = 0


@kernel(for_cpu=True)
def sum_truncated_kernel(
    pairs: PairCoordinates,
    poses: array(dtype=mat44d),
    limit: float64,
    fraction: float64,
    partials: array(dtype=float64, ndim=2),
):
    """Weighted sums of a block of correspondences under one pose. Last, the reduction of the truncated cost."""
    i = tid()
    pose = poses[i // pairs.blocks]
    s = pair_sums(0.0)
    saved = float64(0.0)
    for p, q, sqdist in residuals_of_block(i % pairs.blocks, pose, pairs):
        w = truncated_weight(sqdist, limit, fraction)
        if w > 0.0:
            s += sums_of_pair(p, q, w)
        if sqdist < limit:
            saved += 1.0 - sqdist / limit
    store_sums(i, s, saved, partials)


@segment_reduction
def sum_truncated(pairs: PairCoordinates, poses: array(dtype=mat44d), limit: float64, fraction: float64) -> all_sums:
    """Weighted sums of a correspondence under one pose. Last, the reduction of the truncated cost."""
    i = tid()
    p = source_point(pairs, i % pairs.count)
    q = target_point(pairs, i % pairs.count)
    r = move(poses[i // pairs.count], p) - q
    sqdist = dot(r, r)
    saved = float64(0.0)
    if sqdist < limit:
        saved = 1.0 - sqdist / limit
    return joined_sums(sums_of_pair(p, q, truncated_weight(sqdist, limit, fraction)), saved)


@kernel
def step_poses_kernel(
    partials: array(dtype=float64, ndim=2),
    blocks: int,
    last: int,
    poses: array(dtype=mat44d),
    saved: array(dtype=float64),
):
    """Cost reduction of each pose. Then refit it, except in the last step."""
    i = tid()
    total = fold_blocks(partials, i * blocks, blocks)
    saved[i] = total[MOMENT_COUNT]
    if last == 0 and total[0] >= float64(MIN_PAIRS):
        poses[i] = fit_of(total, poses[i], 0)


def seed_poses(graph: CompatibilityGraph, seeds: Integers) -> tuple[Poses, Indices]:
    """Poses of seeds and their best neighbors: (mat44d (s), int32 (s) of zeros)."""
    poses, scores = empty(seeds.size, mat44d, graph.device), empty(seeds.size, int32, graph.device)
    wanted = min(MAX_SEED_PAIRS, graph.count)
    launch(fit_seeds_kernel, seeds.size * graph.warp, [graph.pairs, seeds, graph.common(seeds), wanted, poses, scores])
    return poses, scores


def refit_truncated(pairs: PairCoordinates, poses: Poses, distance: float) -> Doubles:
    """Fit poses (in place) by graduated non-convexity. Returns inlier sums of 1 - (residual / distance)^2."""
    saved = empty(poses.size, float64, pairs.device)
    sums, limit, fraction = PoseSums(pairs, poses.size), distance * distance, FIRST_FRACTION
    for step in range(ANNEALING_STEPS + 1):
        sums.add_up(sum_truncated_kernel, sum_truncated, [poses, limit, fraction])
        launch(step_poses_kernel, poses.size, [sums.rows, sums.blocks, int(step == ANNEALING_STEPS), poses, saved])
        fraction *= MU_GROWTH
    return saved


def distinct_poses(poses: np.ndarray, spread: np.ndarray, min_rms: float) -> np.ndarray:
    """Ascending indices of poses that differ from all earlier ones by RMS >= `min_rms` [m] of the points `spread`."""
    moved = np.einsum("kij,pj->kpi", poses[:, :3, :3], spread) + poses[:, None, :3, 3]
    flat = moved.reshape(len(poses), 3 * len(spread)) / np.sqrt(max(len(spread), 1))
    selected, left = [], np.ones(len(poses), bool)
    while left.any():
        selected.append(int(np.argmax(left)))
        gaps = flat - flat[selected[-1]]
        left &= ~((gaps * gaps).sum(axis=1) <= min_rms * min_rms)
        left[selected[-1]] = False
    return np.array(selected, np.int64)


@kernel
def stack_poses_kernel(poses: array(dtype=mat44d), values: array(dtype=float64), rows: array(dtype=float64, ndim=2)):
    i = tid()
    rows[i, 0] = values[i]
    pose = poses[i]
    for j in range(4):
        for k in range(4):
            rows[i, 1 + 4 * j + k] = pose[j, k]


def read_poses(poses: Poses, values: Doubles) -> tuple[np.ndarray, np.ndarray]:
    """A value per pose, float64 (k), and the poses (k, 4, 4) on the host. One sync."""
    rows = empty((poses.size, 17), float64, poses.device)
    launch(stack_poses_kernel, poses.size, [poses, values, rows])
    host = download(rows).copy()  # sync
    return host[:, 0], host[:, 1:].reshape(-1, 4, 4)


def find_consensus(
    pairs: PairCoordinates, bound: float, distance: float, spread: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Distinct poses with the most consensus, best first, and cost reductions, on the host. `bound`: maximum distance
    difference [m] of compatible pairs; `distance`: inlier distance [m].
    """
    nothing = np.empty((0, 4, 4)), np.empty(0)
    if pairs.count < MIN_PAIRS:
        return nothing
    graph = CompatibilityGraph(pairs, bound, bound)
    seeds = graph.peaks(graph.support(), 2 * distance, MAX_SEEDS)
    if seeds.size == 0:
        return nothing
    poses, scores = seed_poses(graph, seeds)
    score_poses(pairs, poses, distance, scores)
    ranked, host_poses = read_poses(poses, cast(scores, float64))  # sync
    order = np.argsort(-ranked, kind="stable")
    order = order[distinct_poses(host_poses[order], spread, MIN_POSE_DISTANCE * distance)][:MAX_REFITTED]
    chosen = upload(host_poses[order], mat44d, pairs.device)
    saved, refitted = read_poses(chosen, refit_truncated(pairs, chosen, distance))  # sync
    best = np.argsort(-saved, kind="stable")
    fitted = refitted[best]
    distinct = distinct_poses(fitted, spread, MIN_POSE_DISTANCE * distance)
    return fitted[distinct], saved[best][distinct]
