"""Score and fit many poses to given correspondences.

Float32 coordinates about local centers, one array per axis for vectorization; float64 sums in a fixed order. Closed
form: Horn, "Closed-form solution of absolute orientation using unit quaternions", JOSA A 1987. Weights: 1 within a
distance (Lebeda et al., BMVC 2012), or scaled Geman-McClure (Zhou et al., ECCV 2016, eq. 6).
"""

from collections.abc import Sequence

import numpy as np

from ..algebra.rigid_solve import fit_pose, move, pair_sums, sums_of_pair
from ..array_types import Array2, Doubles, Indices, Points, Poses
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.select import positions_of
from ..arrays.side_by_side import part_of
from ..lang import (
    Kernel,
    Reduction,
    array,
    compute,
    dot,
    float32,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    loop,
    loop_while,
    mat44d,
    reduce_segments,
    segment_reduction,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vector,
)
from ..memory import empty, fill, full, zeros

PAIRS_PER_BLOCK = 512  # correspondences whose coordinates (12 KB) stay in the L1 cache
MOMENT_COUNT = 18  # numbers of a fit
SUM_COLUMNS = MOMENT_COUNT + 1  # plus the weighted sum of squared distances
MIN_PAIRS = 3  # correspondences that fix a pose
WITHIN_LIMIT = 0  # weighting: 1 below a squared distance
GEMAN_MCCLURE = 1  # weighting: (mu / (mu + d^2))^2
all_sums = vector(19, float64)


@struct
class PairCoordinates:
    """Correspondences with finite ends: `coordinates` (6 m) about the centers: source x, y, z, target x, y, z."""

    rows: array(dtype=int32, ndim=2)
    coordinates: array(dtype=float32)
    count: int
    blocks: int

    def __init__(
        self,
        source: Points,
        target: Points,
        pairs: Array2[int32],
        source_middle: np.ndarray,
        target_middle: np.ndarray,
        *,
        are_finite: bool = False,
    ) -> None:
        """Select the finite correspondences `pairs` (int32 (m, 2)) of two arrays of vec3. Centers as float32 (3).

        No sync if all points `are_finite`.
        """
        device = source.device
        self.device, self.count, self.rows = device, pairs.shape[0], pairs
        if not are_finite:
            mask = compute(mask_finite_pairs_kernel, pairs.shape[0], [source, target, pairs], uint8, device)
            rows = positions_of(mask)  # sync
            if rows.size < pairs.shape[0]:
                self.count, self.rows = rows.size, empty((rows.size, 2), int32, device)
                launch(gather_pairs_kernel, rows.size, [pairs, rows, self.rows])
        self.coordinates = empty(6 * self.count, float32, device)
        middles = [vec3(*source_middle), vec3(*target_middle)]
        launch(split_pairs_kernel, self.count, [source, target, *middles, self])
        self.blocks = -(-self.count // PAIRS_PER_BLOCK)

    def select(self, rows: Indices) -> "PairCoordinates":
        """Correspondences at some rows (int32 device array), which may repeat."""
        chosen = PairCoordinates.__new__(PairCoordinates)
        chosen.device, chosen.count, chosen.blocks = self.device, rows.size, -(-rows.size // PAIRS_PER_BLOCK)
        chosen.rows = empty((rows.size, 2), int32, self.device)
        launch(gather_pairs_kernel, rows.size, [self.rows, rows, chosen.rows])
        chosen.coordinates = empty(6 * rows.size, float32, self.device)
        launch(select_coordinates_kernel, rows.size, [self, rows, chosen.coordinates])
        return chosen

    def refine(
        self,
        poses: Poses,
        distance: float,
        steps: int,
        with_scaling: bool,
        out: tuple[Poses, Array2[float64]] | None = None,
    ) -> tuple[Poses, Array2[float64]]:
        """Fit poses (in place) repeatedly to pairs within `distance` [m]: best poses, (inliers, squares [m^2])."""
        k = poses.size
        best, scores = (empty(k, mat44d, self.device), empty((k, 2), float64, self.device)) if out is None else out
        fill(scores, -1.0)
        limits, sums = full(k, distance * distance, float64, self.device), PoseSums(self, k)
        for _ in range(steps + 1):
            sums.add_up(sum_pairs_kernel, sum_weighted, [poses, limits, WITHIN_LIMIT])
            launch(refit_poses_kernel, k, [sums.rows, sums.blocks, int(with_scaling), poses, best, scores])
        return best, scores

    def anneal(self, pose: Poses, mu: float, min_scale: float, divisor: float, every: int, steps: int) -> Poses:
        """Minimize the Geman-McClure cost with decreasing scale mu [m^2]. Returns the pose before the last step."""
        previous, limits = empty(1, mat44d, self.device), full(1, mu, float64, self.device)
        sums, left = PoseSums(self, 1), full(1, steps, int32, self.device)
        step = [divisor, min_scale, every, steps, left, pose, previous, limits]

        def iterate() -> None:
            sums.add_up(sum_pairs_kernel, sum_weighted, [pose, limits, GEMAN_MCCLURE])
            launch(anneal_poses_kernel, 1, [sums.rows, sums.blocks, *step])

        loop_while(left, iterate)
        return previous


class PoseSums:
    """Reusable sums under `count` poses: `rows` float64 (count * blocks, SUM_COLUMNS), on CUDA one block."""

    def __init__(self, pairs: PairCoordinates, count: int) -> None:
        device = self.device = pairs.device
        self.pairs, self.count, self.blocks = pairs, count, pairs.blocks
        if not device.is_cuda:
            self.rows = empty((count * pairs.blocks, SUM_COLUMNS), float64, device)
            return
        self.blocks = 1
        self._segments = SegmentBlocks(np.arange(count) * pairs.count, np.full(count, pairs.count), device)
        self.rows = zeros((count, SUM_COLUMNS), float64, device)
        self._live, self._totals = full(count, 1, int32, device), part_of(self.rows, 0, all_sums, count)
        self._partials = self._segments.partials(all_sums)

    def add_up(self, by_block: Kernel, by_pair: Reduction, arguments: Sequence[Doubles | Poses | float]) -> None:
        """Sum with `by_block` (kernel over blocks, CPU) or `by_pair` (reduction, CUDA)."""
        if self.device.is_cuda:
            reduce_segments(by_pair, self._segments, self._live, [self.pairs, *arguments], self._partials, self._totals)
        else:
            launch(by_block, self.count * self.blocks, [self.pairs, *arguments, self.rows])


@kernel
def mask_finite_pairs_kernel(
    source: array(dtype=vec3), target: array(dtype=vec3), pairs: array(dtype=int32, ndim=2), mask: array(dtype=uint8)
):
    i = tid()
    both = 0
    if isfinite(source[pairs[i, 0]]) and isfinite(target[pairs[i, 1]]):
        both = 1
    mask[i] = uint8(both)


@kernel
def gather_pairs_kernel(pairs: array(dtype=int32, ndim=2), rows: array(dtype=int32), out: array(dtype=int32, ndim=2)):
    i = tid()
    out[i, 0] = pairs[rows[i], 0]
    out[i, 1] = pairs[rows[i], 1]


@kernel
def split_pairs_kernel(
    source: array(dtype=vec3),
    target: array(dtype=vec3),
    source_middle: vec3,
    target_middle: vec3,
    pairs: PairCoordinates,
):
    """Coordinates of each pair about the centers, one section of the array per coordinate."""
    i = tid()
    p = source[pairs.rows[i, 0]] - source_middle
    q = target[pairs.rows[i, 1]] - target_middle
    for axis in range(3):
        pairs.coordinates[axis * pairs.count + i] = p[axis]
        pairs.coordinates[(3 + axis) * pairs.count + i] = q[axis]


@func
def source_point(pairs: PairCoordinates, row: int) -> vec3d:
    x = float64(pairs.coordinates[row])
    y = float64(pairs.coordinates[pairs.count + row])
    z = float64(pairs.coordinates[2 * pairs.count + row])
    return vec3d(x, y, z)


@func
def target_point(pairs: PairCoordinates, row: int) -> vec3d:
    x = float64(pairs.coordinates[3 * pairs.count + row])
    y = float64(pairs.coordinates[4 * pairs.count + row])
    z = float64(pairs.coordinates[5 * pairs.count + row])
    return vec3d(x, y, z)


@loop
def residuals_of_block(block: int, pose: mat44d, pairs: PairCoordinates) -> tuple[vec3d, vec3d, float64]:
    """End points of a block's correspondences and their squared distances [m^2] under a pose."""
    for j in range(block * PAIRS_PER_BLOCK, min((block + 1) * PAIRS_PER_BLOCK, pairs.count)):
        p = source_point(pairs, j)
        q = target_point(pairs, j)
        r = move(pose, p) - q
        sqdist = r[0] * r[0] + r[1] * r[1] + r[2] * r[2]
        yield p, q, sqdist


@func
def store_sums(i: int, s: pair_sums, last: float64, partials: array(dtype=float64, ndim=2)):
    for k in range(MOMENT_COUNT):
        partials[i, k] = s[k]
    partials[i, MOMENT_COUNT] = last


@func
def weight_of(sqdist: float64, limit: float64, weighting: int) -> float64:
    w = float64(0.0)
    if weighting == GEMAN_MCCLURE:
        w = limit / (limit + sqdist)
        w = w * w
    else:
        if sqdist < limit:
            w = 1.0
    return w


@func
def joined_sums(s: pair_sums, last: float64) -> all_sums:
    total = all_sums(0.0)
    for k in range(18):
        total[k] = s[k]
    total[MOMENT_COUNT] = last
    return total


@segment_reduction
def sum_weighted(
    pairs: PairCoordinates, poses: array(dtype=mat44d), limits: array(dtype=float64), weighting: int
) -> all_sums:
    i = tid()
    p = source_point(pairs, i % pairs.count)
    q = target_point(pairs, i % pairs.count)
    r = move(poses[i // pairs.count], p) - q
    sqdist = dot(r, r)
    w = weight_of(sqdist, limits[i // pairs.count], weighting)
    return joined_sums(sums_of_pair(p, q, w), w * sqdist)


@kernel(for_cpu=True)
def sum_pairs_kernel(
    pairs: PairCoordinates,
    poses: array(dtype=mat44d),
    limits: array(dtype=float64),
    weighting: int,
    partials: array(dtype=float64, ndim=2),
):
    i = tid()
    pose = poses[i // pairs.blocks]
    limit = limits[i // pairs.blocks]
    s = pair_sums(0.0)
    squares = float64(0.0)
    for p, q, sqdist in residuals_of_block(i % pairs.blocks, pose, pairs):
        w = weight_of(sqdist, limit, weighting)
        if w > 0.0:
            s += sums_of_pair(p, q, w)
            squares += w * sqdist
    store_sums(i, s, squares, partials)


@func
def fold_blocks(partials: array(dtype=float64, ndim=2), first: int, blocks: int) -> all_sums:
    total = all_sums(0.0)
    for block in range(first, first + blocks):
        for k in range(SUM_COLUMNS):
            total[k] = total[k] + partials[block, k]
    return total


@func
def fit_of(total: all_sums, pose: mat44d, with_scaling: int) -> mat44d:
    """Weighted best fit. The old pose if the weights are zero."""
    s = pair_sums(0.0)
    for k in range(MOMENT_COUNT):
        s[k] = total[k]
    fitted = pose * 1.0
    if total[0] > 0.0:
        fitted = fit_pose(s, with_scaling)
    return fitted


@kernel
def refit_poses_kernel(
    partials: array(dtype=float64, ndim=2),
    blocks: int,
    with_scaling: int,
    poses: array(dtype=mat44d),
    best_poses: array(dtype=mat44d),
    scores: array(dtype=float64, ndim=2),
):
    """Keep a pose with more inliers (ties: closer) than the best so far, then refit it."""
    i = tid()
    total = fold_blocks(partials, i * blocks, blocks)
    better = 0
    if total[0] > scores[i, 0]:
        better = 1
    if total[0] == scores[i, 0] and total[MOMENT_COUNT] < scores[i, 1]:
        better = 1
    if better == 1:
        best_poses[i] = poses[i]
        scores[i, 0] = total[0]
        scores[i, 1] = total[MOMENT_COUNT]
    if total[0] >= float64(MIN_PAIRS):
        poses[i] = fit_of(total, poses[i], with_scaling)


@kernel
def anneal_poses_kernel(
    partials: array(dtype=float64, ndim=2),
    blocks: int,
    divisor: float64,
    min_scale: float64,
    every: int,
    steps: int,
    left: array(dtype=int32),
    poses: array(dtype=mat44d),
    previous: array(dtype=mat44d),
    limits: array(dtype=float64),
):
    """Refit a pose, and every `every` steps divide its scale while it is above `min_scale`."""
    i = tid()
    previous[i] = poses[i]
    poses[i] = fit_of(fold_blocks(partials, i * blocks, blocks), poses[i], 0)
    if limits[i] > min_scale and (steps - left[i]) % every == 0:
        limits[i] = limits[i] / divisor
    left[i] = left[i] - 1


@kernel
def select_coordinates_kernel(pairs: PairCoordinates, rows: array(dtype=int32), out: array(dtype=float32)):
    i = tid()
    for axis in range(6):
        out[axis * rows.shape[0] + i] = pairs.coordinates[axis * pairs.count + rows[i]]
