"""Plane priors of textureless regions.

RANSAC (Fischler and Bolles 1981) for all regions in parallel, over reliable pixels in and around each. The best plane
is refitted twice, its pixels are removed, and so on. Each region pixel takes the plane of the nearest assigned pixel,
unless the images clearly contradict it, by a cost difference that grows with the lack of texture (idea: Xu and Tao
2020, "Planar prior assisted PatchMatch multi-view stereo", whose likelihoods are not bitwise reproducible). Fixed-order
float64 sums. Random numbers depend on seed, region and trial.
"""

from ..array_types import Array1, Scalars
from ..arrays.prefix_sum import inclusive_scan
from ..arrays.random import random_below, random_bits
from ..lang import (
    array,
    compute,
    float32,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    vec2,
    vec3d,
    vec4,
    vector,
)
from ..memory import empty, full, zeros
from .brightness import brightness_in
from .patch_costs import Reference, Sources, round_trip, window_of
from .patch_match import mean_of_best, source_cost
from .plane_results import AGREED_FRACTION, AGREED_PIXELS
from .textureless_regions import TexturelessRegions, pixel_of, region_of

TEXTURE_RADIUS = 2  # [px] radius of the texture window
NOISE_DEVIATION = 0.011  # brightness deviation of pure noise: 2 to 3 of 255
TEXTURE_DEVIATION = 0.016  # brightness deviation of texture
SURE_COST = 0.35  # maximum cost of a reliable plane
SURE_SOURCES = 2  # that agree with its depth, or all existing ones
PLAIN_COST = 0.75  # maximum cost of a prior without texture
MIN_COST_ADVANTAGE = 0.8  # cost advantage required against the prior of an untextured pixel: noise reaches half


@kernel
def judge_pixels_kernel(reference: Reference, sources: Sources, planes: array(dtype=vec4), judged: array(dtype=vec2)):
    """Lack of texture of each pixel, 0 to 1, and 1 if its depth is reliable."""
    i = tid()
    x = i % reference.width
    y = i // reference.width
    center = brightness_in(sources.images[reference.first + i])
    count = 0.0
    total = 0.0
    squares = 0.0
    side = int(2 * TEXTURE_RADIUS + 1)
    for j in range(side):
        row = y + j - TEXTURE_RADIUS
        if row >= 0 and row < reference.height:
            for k in range(side):
                column = x + k - TEXTURE_RADIUS
                if column >= 0 and column < reference.width:
                    shown = sources.images[reference.first + row * reference.width + column]
                    d = brightness_in(shown) - center
                    count += 1.0
                    total += d
                    squares += d * d
    mean = total / count
    spread = sqrt(max(squares / count - mean * mean, 0.0))
    plain = min(max((TEXTURE_DEVIATION - spread) / (TEXTURE_DEVIATION - NOISE_DEVIATION), 0.0), 1.0)
    plane = planes[i]
    agreed = 0
    for s in range(sources.count):
        back = round_trip(x, y, plane[0], s, sources)
        if back[0] < AGREED_PIXELS and abs(back[1] - plane[0]) < AGREED_FRACTION * plane[0]:
            agreed += 1
    sure = 0.0
    if plane[3] < SURE_COST and agreed >= min(SURE_SOURCES, sources.count):
        sure = 1.0
    judged[i] = vec2(plain, sure)


@kernel
def take_priors_kernel(
    chosen: int,
    geometric: float,
    reference: Reference,
    sources: Sources,
    priors: array(dtype=vec4),
    planes: array(dtype=vec4),
    costs: array(dtype=float32),
):
    """Replace planes by priors (last number: weight, not cost) unless the plane is clearly better."""
    i = tid()
    x = i % reference.width
    y = i // reference.width
    prior = priors[i]
    if prior[3] <= 0.0 or prior[0] < reference.farthest or prior[0] > reference.nearest:
        return
    own = mean_of_best(i, chosen, sources.count, costs)
    weights, rises, variance = window_of(x, y, reference, sources)
    for s in range(sources.count):
        costs[i * sources.count + s] = source_cost(
            x, y, prior, s, geometric, weights, rises, variance, reference, sources
        )
    theirs = mean_of_best(i, chosen, sources.count, costs)
    if theirs < own + prior[3] * MIN_COST_ADVANTAGE:
        planes[i] = vec4(prior[0], prior[1], prior[2], min(min(own, theirs), PLAIN_COST))


def judge_pixels(reference: Reference, sources: Sources, planes: Array1[vec4]) -> Array1[vec2]:
    """Lack of texture and reliability of pixels, (pixels, 2)."""
    count = reference.width * reference.height
    return compute(judge_pixels_kernel, count, [reference, sources, planes], vec2, planes.device)


def take_priors(
    chosen: int,
    geometric: float,
    reference: Reference,
    sources: Sources,
    priors: Array1[vec4],
    planes: Array1[vec4],
    costs: Scalars,
) -> None:
    """Apply priors to the planes. Overwrites the `costs` of each source."""
    count = reference.width * reference.height
    launch(take_priors_kernel, count, [chosen, geometric, reference, sources, priors, planes, costs])


TRIALS_PER_REGION = 100
MAX_TRIED = 600  # reliable pixels counted per trial
PLANES_PER_REGION = 2  # planes per region: more cannot each have MIN_FRACTION
REFIT_COUNT = 2
THREADS_PER_REGION = 32  # threads per region that sum moments
TESTED_PIXELS = 256  # pixels per region tested for the nearest plane
MIN_SUPPORT = 20  # minimum inliers of a plane
MIN_FRACTION = 0.35  # of all reliable pixels: with less, scattered errors form planes
MIN_SPREAD = 3.0  # [px] inlier extent across the longest direction: a line does not determine a plane
MIN_TRIANGLE = 50.0  # [px^2] twice the area of three sampled pixels
INLIER_DISTANCE = 0.5  # [px in the sources] inlier distance

vec9d = vector(9, float64)


@struct
class Consensus:
    """RANSAC state. `left`: 1 without plane, `listed` per region; `plane_rounds`: round of the plane from 1, or 0;
    `scores`: inliers or -1; `tried`: inverse depth at pixel 0 and slopes; `fits`, `accepted`: planes; `tolerance` of
    inverse depth.
    """

    left: array(dtype=int32)
    listed: array(dtype=int32)
    remaining: array(dtype=int32)
    plane_rounds: array(dtype=int32)
    scores: array(dtype=int32)
    tried: array(dtype=vec3d)
    fits: array(dtype=vec3d)
    alive: array(dtype=int32)
    accepted: array(dtype=vec3d)
    count: array(dtype=int32)
    moments: array(dtype=vec9d)
    tolerance: float64

    def __init__(self, regions: TexturelessRegions, tolerance: float) -> None:
        device, pairs, count = regions.device, regions.pairs.size, regions.count
        self.left, self.listed = full(pairs, 1, int32, device), empty(pairs, int32, device)
        self.plane_rounds, self.remaining = zeros(pairs, int32, device), empty(count, int32, device)
        self.scores, self.tried = (
            empty(count * TRIALS_PER_REGION, int32, device),
            empty(count * TRIALS_PER_REGION, vec3d, device),
        )
        self.fits, self.alive = empty(count, vec3d, device), full(count, 1, int32, device)
        self.accepted, self.count = empty(count * PLANES_PER_REGION, vec3d, device), zeros(count, int32, device)
        self.moments, self.tolerance = empty(count * THREADS_PER_REGION, vec9d, device), tolerance


@func
def height_at(plane: vec3d, pixel: int, width: int) -> float64:
    return plane[0] + plane[1] * float64(pixel % width) + plane[2] * float64(pixel // width)


@func
def min_inliers(region: int, regions: TexturelessRegions) -> float64:
    """Minimum pixels of a plane."""
    return max(float64(MIN_SUPPORT), float64(MIN_FRACTION) * float64(regions.lasts[region] - regions.firsts[region]))


@kernel
def list_left_kernel(regions: TexturelessRegions, sums: array(dtype=int32), state: Consensus):
    """Compact the list of a region by prefix sums."""
    j = tid()
    region = region_of(regions.pairs[j])
    first = regions.firsts[region]
    before = sums[first] - state.left[first]
    if state.left[j] != 0:
        state.listed[first + sums[j] - before - 1] = j
    if j == regions.lasts[region] - 1:
        state.remaining[region] = sums[j] - before


@kernel
def begin_round_kernel(regions: TexturelessRegions, state: Consensus):
    k = tid()
    min_count = min_inliers(k, regions)
    if regions.lasts[k] == regions.firsts[k] or float64(state.remaining[k]) < min_count:
        state.alive[k] = 0


@kernel
def try_planes_kernel(seed: int, round: int, regions: TexturelessRegions, planes: array(dtype=vec4), state: Consensus):
    """Plane through three random pixels, and its inlier count."""
    i = tid()
    k = i // TRIALS_PER_REGION
    score = -1
    plane = vec3d(float64(0.0))
    if state.alive[k] != 0:
        first = regions.firsts[k]
        count = state.remaining[k]
        a = pixel_of(regions.pairs[state.listed[first + random_below(random_bits(seed, i, 3 * round), count)]])
        b = pixel_of(regions.pairs[state.listed[first + random_below(random_bits(seed, i, 3 * round + 1), count)]])
        c = pixel_of(regions.pairs[state.listed[first + random_below(random_bits(seed, i, 3 * round + 2), count)]])
        bu = float64(b % regions.width - a % regions.width)
        bv = float64(b // regions.width - a // regions.width)
        cu = float64(c % regions.width - a % regions.width)
        cv = float64(c // regions.width - a // regions.width)
        area = bu * cv - cu * bv
        if abs(area) > float64(MIN_TRIANGLE):
            w = float64(planes[a][0])
            wb = float64(planes[b][0]) - w
            wc = float64(planes[c][0]) - w
            du = (wb * cv - wc * bv) / area
            dv = (wc * bu - wb * cu) / area
            plane = vec3d(w - du * float64(a % regions.width) - dv * float64(a // regions.width), du, dv)
            score = 0
            step = (count + MAX_TRIED - 1) // MAX_TRIED
            sample_count = (count + step - 1) // step
            for j in range(sample_count):
                pixel = pixel_of(regions.pairs[state.listed[first + j * step]])
                if abs(height_at(plane, pixel, regions.width) - float64(planes[pixel][0])) < state.tolerance:
                    score += 1
    state.scores[i] = score
    state.tried[i] = plane


@kernel
def choose_planes_kernel(state: Consensus):
    k = tid()
    best = int(-1)
    max_score = int(-1)
    trials = int(TRIALS_PER_REGION)
    for t in range(trials):
        if state.scores[k * TRIALS_PER_REGION + t] > max_score:
            max_score = state.scores[k * TRIALS_PER_REGION + t]
            best = t
    if best < 0:
        state.alive[k] = 0
    else:
        state.fits[k] = state.tried[k * TRIALS_PER_REGION + best]


@kernel
def sum_moments_kernel(regions: TexturelessRegions, planes: array(dtype=vec4), state: Consensus):
    """Moments of the inliers about the region's first pixel: x, y, z, xx, xy, yy, xz, yz, count."""
    i = tid()
    k = i // THREADS_PER_REGION
    total = vec9d(float64(0.0))
    if state.alive[k] != 0:
        first = regions.firsts[k]
        start = pixel_of(regions.pairs[first])
        w = float64(planes[start][0])
        plane = state.fits[k]
        steps = (state.remaining[k] - i % THREADS_PER_REGION + THREADS_PER_REGION - 1) // THREADS_PER_REGION
        for step in range(steps):
            pixel = pixel_of(regions.pairs[state.listed[first + i % THREADS_PER_REGION + step * THREADS_PER_REGION]])
            depth = float64(planes[pixel][0])
            if abs(height_at(plane, pixel, regions.width) - depth) < state.tolerance:
                x = float64(pixel % regions.width - start % regions.width)
                y = float64(pixel // regions.width - start // regions.width)
                z = depth - w
                total += vec9d(x, y, z, x * x, x * y, y * y, x * z, y * z, float64(1.0))
    state.moments[i] = total


@kernel
def fit_planes_kernel(regions: TexturelessRegions, planes: array(dtype=vec4), state: Consensus):
    """Least-squares plane. None for collinear or too few pixels."""
    k = tid()
    if state.alive[k] == 0:
        return
    total = vec9d(float64(0.0))
    parts = int(THREADS_PER_REGION)
    for p in range(parts):
        total += state.moments[k * THREADS_PER_REGION + p]
    n = total[8]
    state.alive[k] = 0
    if n >= min_inliers(k, regions):
        mx = total[0] / n
        my = total[1] / n
        mz = total[2] / n
        xx = total[3] / n - mx * mx
        xy = total[4] / n - mx * my
        yy = total[5] / n - my * my
        xz = total[6] / n - mx * mz
        yz = total[7] / n - my * mz
        narrow = (xx + yy - sqrt((xx - yy) * (xx - yy) + 4.0 * xy * xy)) * 0.5  # their squared extent across
        if narrow >= float64(MIN_SPREAD * MIN_SPREAD):
            determinant = xx * yy - xy * xy
            du = (xz * yy - yz * xy) / determinant
            dv = (yz * xx - xz * xy) / determinant
            start = pixel_of(regions.pairs[regions.firsts[k]])
            middle = float64(planes[start][0]) + mz - du * (mx + float64(start % regions.width))
            state.fits[k] = vec3d(middle - dv * (my + float64(start // regions.width)), du, dv)
            state.alive[k] = 1


@kernel
def keep_planes_kernel(round: int, state: Consensus):
    k = tid()
    if state.alive[k] != 0:
        state.accepted[k * PLANES_PER_REGION + round] = state.fits[k]
        state.count[k] = round + 1


@kernel
def take_support_kernel(round: int, regions: TexturelessRegions, planes: array(dtype=vec4), state: Consensus):
    j = tid()
    k = region_of(regions.pairs[j])
    if state.alive[k] != 0 and state.left[j] != 0:
        pixel = pixel_of(regions.pairs[j])
        if abs(height_at(state.fits[k], pixel, regions.width) - float64(planes[pixel][0])) < state.tolerance:
            state.plane_rounds[j] = round + 1
            state.left[j] = 0


@func
def nearest_round(i: int, k: int, regions: TexturelessRegions, state: Consensus) -> int:
    """Round of the plane of the nearest sampled pixel. The first of equal ones."""
    nearest = int(0)
    min_sqdist = int64(0x7FFFFFFFFFFFFFFF)
    first = regions.firsts[k]
    count = regions.lasts[k] - first
    step = (count + TESTED_PIXELS - 1) // TESTED_PIXELS
    sample_count = (count + step - 1) // step
    for number in range(sample_count):
        j = number * step
        plane_round = state.plane_rounds[first + j]
        if plane_round != 0:
            pixel = pixel_of(regions.pairs[first + j])
            x = int64(pixel % regions.width - i % regions.width)
            y = int64(pixel // regions.width - i // regions.width)
            if x * x + y * y < min_sqdist:
                min_sqdist = x * x + y * y
                nearest = plane_round
    return max(nearest, 1) - 1


@kernel
def write_priors_kernel(
    judged: array(dtype=vec2), regions: TexturelessRegions, state: Consensus, priors: array(dtype=vec4)
):
    i = tid()
    prior = vec4(0.0)
    if regions.labels[i] >= 0:
        k = regions.numbers[regions.labels[i]]
        if k >= 0 and state.count[k] > 0:
            round = 0
            if state.count[k] > 1:
                round = nearest_round(i, k, regions, state)
            plane = state.accepted[k * PLANES_PER_REGION + round]
            w = float32(height_at(plane, i, regions.width))
            prior = vec4(w, float32(plane[1]), float32(plane[2]), judged[i][0])
    priors[i] = prior


def plane_priors(
    regions: TexturelessRegions, judged: Array1[vec2], planes: Array1[vec4], tolerance: float, seed: int
) -> Array1[vec4]:
    """Plane priors: inverse depth, two slopes, weight, or 0 (pixels), no sync; `judged` as of `judge_pixels`."""
    state, pairs, count = Consensus(regions, tolerance), regions.pairs.size, regions.count
    sums = empty(pairs, int32, regions.device)
    for k in range(PLANES_PER_REGION):
        inclusive_scan(state.left, sums)
        launch(list_left_kernel, pairs, [regions, sums, state])
        launch(begin_round_kernel, count, [regions, state])
        launch(try_planes_kernel, count * TRIALS_PER_REGION, [seed, k, regions, planes, state])
        launch(choose_planes_kernel, count, [state])
        for _ in range(REFIT_COUNT):
            launch(sum_moments_kernel, count * THREADS_PER_REGION, [regions, planes, state])
            launch(fit_planes_kernel, count, [regions, planes, state])
        launch(keep_planes_kernel, count, [k, state])
        launch(take_support_kernel, pairs, [k, regions, planes, state])
    return compute(write_priors_kernel, planes.size, [judged, regions, state], vec4, regions.device)
