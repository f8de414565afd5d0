"""Costs of planes by eight CUDA lanes per pixel, bitwise those of patch_costs.py.

A lane has a plane. To compare a plane with a source, it has a sample of each block of the patch, so that no vector has
a computed index. The tried planes of eight lanes are compared one after another, which takes no time for others.
"""

from ..lang import bit_count, cuda_func, float32, lane, shuffle, shuffle_xor, sqrt, uint64, vec3, vec4i, vector
from ..search.lane_boxes import flags_of_eight
from ..search.tree_walk import lowest_bit
from .brightness import MAX_PACKED_LEVEL, PACKED_LEVEL_MASK, brightness_in
from .patch_costs import (
    COLOR_SCALE,
    LANE_COUNT,
    MAX_BLOCKS,
    MAX_PATCH_COST,
    MIN_SOURCE_DEPTH,
    MIN_VARIANCE,
    Reference,
    Sources,
)

own_samples = vector(MAX_BLOCKS, float32)  # of a lane: one per block


@cuda_func
def of_eight(x: float, k: int) -> float:
    """Value of lane k of the own eight."""
    return shuffle(x, (lane() & ~(LANE_COUNT - 1)) | k)


@cuda_func
def index_of_eight(x: int, k: int) -> int:
    return shuffle(x, (lane() & ~(LANE_COUNT - 1)) | k)


@cuda_func
def vector_of_eight(v: vec3, k: int) -> vec3:
    return vec3(of_eight(v[0], k), of_eight(v[1], k), of_eight(v[2], k))


@cuda_func
def sum_of_eight(x: float) -> float:
    """Sum over the own eight lanes in the order of `sum_of`."""
    pairs = x + shuffle_xor(x, 4)
    fours = pairs + shuffle_xor(pairs, 1)
    return fours + shuffle_xor(fours, 2)


@cuda_func
def window_of_lanes(
    x: int, y: int, k: int, reference: Reference, sources: Sources
) -> tuple[own_samples, own_samples, float, float]:
    """`window_of` for the samples k of the blocks: the lane's weights, times centered brightness, the variance, and the
    pixel's brightness."""
    count = LANE_COUNT * reference.blocks
    weights = own_samples(0.0)
    rises = own_samples(0.0)
    center = brightness_in(sources.images[reference.first + y * reference.width + x])
    total = 0.0
    moment = 0.0
    squares = 0.0
    for block in range(reference.blocks):
        at = block * LANE_COUNT + k
        dx = x + int(reference.patch[at])
        dy = y + int(reference.patch[count + at])
        column = min(max(dx, 0), reference.width - 1)
        row = min(max(dy, 0), reference.height - 1)
        near = reference.patch[2 * count + at] if column == dx else 0.0
        near = near if row == dy else 0.0
        rise = brightness_in(sources.images[reference.first + row * reference.width + column]) - center
        d = rise * (1.0 / COLOR_SCALE)
        w = near / (1.0 + d * d)
        for j in range(MAX_BLOCKS):
            weights[j] = w if j == block else weights[j]
            rises[j] = rise if j == block else rises[j]
        total = total + w
        moment = moment + w * rise
        squares = squares + w * rise * rise
    fraction = 1.0 / sum_of_eight(total)
    mean = sum_of_eight(moment) * fraction
    for block in range(MAX_BLOCKS):
        weights[block] = weights[block] * fraction
        rises[block] = weights[block] * (rises[block] - mean)
    return weights, rises, sum_of_eight(squares) * fraction - mean * mean, center


@cuda_func
def sample_of(samples: own_samples, block: int) -> float:
    """A component by conditions: a computed index would put the vector into local memory."""
    x = samples[0]
    for k in range(1, MAX_BLOCKS):
        x = samples[k] if block == k else x
    return x


@cuda_func
def sums_of_samples(
    k: int,
    middle: vec3,
    across: vec3,
    down: vec3,
    there: vec4i,
    center: float,
    weights: own_samples,
    rises: own_samples,
    reference: Reference,
    sources: Sources,
) -> vec3:
    """The lane's part of `correlation_sums`: of the samples k of the blocks. The patch is at `middle` in the source."""
    count = LANE_COUNT * reference.blocks
    right = float(there[0] - 1)
    bottom = float(there[1] - 1)
    means = 0.0
    squares = 0.0
    products = 0.0
    for block in range(reference.blocks):
        dx = reference.patch[block * LANE_COUNT + k]
        dy = reference.patch[count + block * LANE_COUNT + k]
        inverse = 1.0 / max(middle[2] + across[2] * dx + down[2] * dy, MIN_SOURCE_DEPTH)
        u = min(max((middle[0] + across[0] * dx + down[0] * dy) * inverse, 0.0), right)
        v = min(max((middle[1] + across[1] * dx + down[1] * dy) * inverse, 0.0), bottom)
        column = min(int(u), there[0] - 2)
        row = min(int(v), there[1] - 2)
        along = u - float(column)
        below = v - float(row)
        shown = sources.images[there[2] + row * there[0] + column]
        here = float(int(shown & uint64(PACKED_LEVEL_MASK)))
        beside = float(int((shown >> uint64(16)) & uint64(PACKED_LEVEL_MASK)))
        under = float(int((shown >> uint64(32)) & uint64(PACKED_LEVEL_MASK)))
        opposite = float(int(shown >> uint64(48)))
        top = here + (beside - here) * along
        value = top + ((under + (opposite - under) * along) - top) * below
        q = value * (1.0 / MAX_PACKED_LEVEL) - center
        wq = sample_of(weights, block) * q
        means = means + wq
        squares = squares + wq * q
        products = products + sample_of(rises, block) * q
    return vec3(means, squares, products)


@cuda_func
def is_visible(middle: vec3, there: vec4i) -> int:
    """1 if the middle of a patch is in a source's image."""
    inverse = 1.0 / max(middle[2], MIN_SOURCE_DEPTH)
    u = middle[0] * inverse
    v = middle[1] * inverse
    beyond = max(max(-u, u - float(there[0] - 1)), max(-v, v - float(there[1] - 1)))
    return 1 if middle[2] > MIN_SOURCE_DEPTH and beyond <= 0.0 else 0


@cuda_func
def patch_cost_of_lanes(
    x: int,
    y: int,
    k: int,
    plane: vec3,
    is_tried: int,
    s: int,
    center: float,
    weights: own_samples,
    rises: own_samples,
    variance: float,
    reference: Reference,
    sources: Sources,
) -> float:
    """`patch_costs` for the lane's plane, of the eight planes of a pixel. The source may differ between pixels."""
    A = sources.there[s]
    b = sources.shift[s]
    there = sources.layout[s]
    base = A @ vec3(float(x), float(y), 1.0)
    middle = base + b * plane[0]
    across = vec3(A[0, 0], A[1, 0], A[2, 0]) + b * plane[1]
    down = vec3(A[0, 1], A[1, 1], A[2, 1]) + b * plane[2]
    tried = 0
    if is_tried == 1 and variance > MIN_VARIANCE:
        tried = is_visible(middle, there)
    left = flags_of_eight(tried)
    rounds = bit_count(left)
    rounds = max(rounds, shuffle_xor(rounds, LANE_COUNT))
    rounds = max(rounds, shuffle_xor(rounds, 2 * LANE_COUNT))
    sums = vec3(0.0, 0.0, 0.0)
    for _ in range(rounds):
        number = lowest_bit(left) if left != 0 else 0
        its_middle = vector_of_eight(middle, number)
        its_across = vector_of_eight(across, number)
        its_down = vector_of_eight(down, number)
        part = vec3(0.0, 0.0, 0.0)
        if left != 0:
            part = sums_of_samples(
                k, its_middle, its_across, its_down, there, center, weights, rises, reference, sources
            )
        means = sum_of_eight(part[0])
        squares = sum_of_eight(part[1])
        products = sum_of_eight(part[2])
        if left != 0 and k == number:
            sums = vec3(means, squares, products)
        left = left & (left - 1)
    spread = sums[1] - sums[0] * sums[0]
    cost = float(MAX_PATCH_COST)
    if spread > MIN_VARIANCE:
        cost = min(max(1.0 - sums[2] / sqrt(variance * max(spread, MIN_VARIANCE)), 0.0), MAX_PATCH_COST)
    return cost
