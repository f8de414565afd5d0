"""PatchMatch stereo with checkerboard propagation.

Pixels of one color test the planes of the best of eight regions of the other color, then random perturbations (Galliani
et al. 2015, "Massively parallel multiview stereopsis by surface normal diffusion"; regions and joint view selection of
Xu and Tao 2019, "Multi-scale geometric consistency guided multi-view stereo", section 3.1, without random sampling).
Costs are means over the chosen sources plus round-trip errors where maps are known. Random numbers depend on seed,
pixel and iteration only: bitwise reproducible.
"""

from ..array_types import Array1, Scalars
from ..arrays.random import random_uniform
from ..lang import array, float32, func, int32, kernel, launch, struct, tid, vec3, vec4, vector
from ..memory import empty
from .inverse_planes import faced_away, inverse_depth_at, normal_of, random_direction, slopes_of
from .patch_costs import Reference, Sources, patch_cost, round_trip, samples, window_of

NEIGHBORS = 8
MAX_SOURCES = 8
BAD_COST = 1.2  # counts against a source
MAX_BAD = 2  # of the nine costs
MIN_GOOD = 2
FALLOFF = 0.09  # squared cost that halves the weight of a good one
UNSURE = 0.02  # weight of a source without evidence

eight = vector(8, float32)
eight_indices = vector(8, int32)


@func
def rate_source(i: int, s: int, count: int, near: eight_indices, good: float, costs: array(dtype=float32)) -> float:
    """Value of a source for pixel i, 0 to 1; `near` are neighbors or -1."""
    fine = 0
    bad = 0
    total = 0.0
    neighbors = int(NEIGHBORS)
    for k in range(neighbors + 1):
        neighbor = int(i)
        if k < NEIGHBORS:
            neighbor = near[k]
        if neighbor >= 0:
            c = costs[neighbor * count + s]
            if c < good:
                fine += 1
                total += FALLOFF / (FALLOFF + c * c)
            if c > BAD_COST:
                bad += 1
    rating = 0.0
    if bad <= MAX_BAD:
        rating = UNSURE
        if fine >= MIN_GOOD:
            rating = total / float(fine)
    return rating


@func
def rate_sources(i: int, count: int, near: eight_indices, good: float, costs: array(dtype=float32)) -> eight:
    """Value of each source for pixel i. 0 beyond the count."""
    ratings = eight(0.0)
    for s in range(count):
        ratings[s] = rate_source(i, s, count, near, good, costs)
    return ratings


@func
def order_of(ratings: eight, count: int) -> eight_indices:
    """Sources by descending value. The first of equal ones."""
    order = eight_indices(0)
    for s in range(count):
        rank = int(s)
        while rank > 0 and ratings[order[max(rank - 1, 0)]] < ratings[s]:
            order[rank] = order[rank - 1]
            rank = rank - 1
        order[rank] = s
    return order


NEAR_COUNT, FAR_COUNT = 7, 11  # pixels of a near and a far region
FAR_BEGIN = 3  # [px] start of the far regions, every second pixel
NO_COST = 1.0e9
TRIALS = 4  # perturbed planes per half iteration: depth, normal, both, random
SAME_PLANE = 0.02  # [px] difference over a patch below which planes are equal
PATCH_RADIUS = 5.0  # [px] patch radius
TILT = 0.08  # change of a unit normal per pixel of spread


@struct
class HalfIteration:
    """Options of a half iteration: checkerboard `color`; `regions` tested; `trials` perturbations up to `spread` [px in
    the sources]; `chosen` sources; `geometric` round-trip weight [1 / px]; `good`: cost of a fitting source.
    """

    seed: int
    number: int
    color: int
    regions: int
    trials: int
    chosen: int
    spread: float
    geometric: float
    good: float

    def __init__(
        self,
        seed: int,
        number: int,
        color: int,
        regions: int,
        trials: int,
        chosen: int,
        spread: float,
        geometric: float,
        good: float,
    ) -> None:
        self.seed, self.number, self.color, self.regions, self.trials = seed, number, color, regions, trials
        self.chosen, self.spread, self.geometric, self.good = chosen, spread, geometric, good


@func
def source_cost(
    x: int,
    y: int,
    plane: vec4,
    s: int,
    geometric: float,
    weights: samples,
    rises: samples,
    variance: float,
    reference: Reference,
    sources: Sources,
) -> float:
    c = patch_cost(x, y, plane, s, weights, rises, variance, reference, sources)
    if geometric > 0.0:
        back = round_trip(x, y, plane[0], s, sources)
        c += geometric * back[0]
    return c


@func
def best_of_region(planes: array(dtype=vec4), x: int, y: int, region: int, width: int, height: int) -> int:
    """Pixel of least cost in a region of the other color, or -1 outside."""
    best = -1
    low = float(NO_COST)
    side = region % 4
    count = int(NEAR_COUNT)
    if region >= 4:
        count = FAR_COUNT
    for k in range(count):
        across = 0
        along = 0
        if region >= 4:
            along = FAR_BEGIN + 2 * k
        else:
            step = (k + 1) // 2
            along = step + 1
            across = step
            if k % 2 == 1:
                across = -step
        dx = int(across)
        dy = int(along)
        if side == 1:
            dy = -along
        if side == 2:
            dx = along
            dy = across
        if side == 3:
            dx = -along
            dy = across
        u = x + dx
        v = y + dy
        if u >= 0 and v >= 0 and u < width and v < height:
            c = planes[v * width + u][3]
            if c < low:
                low = c
                best = v * width + u
    return best


@func
def mean_of_best(i: int, chosen: int, count: int, costs: array(dtype=float32)) -> float:
    total = 0.0
    last = -1.0
    for k in range(chosen):  # next greater cost each time. Equal ones count once
        low = float(NO_COST)
        for s in range(count):
            c = costs[i * count + s]
            if c > last and c < low:
                low = c
        if low < NO_COST:
            last = low
        total += last
    return total / float(chosen)


@kernel
def start_planes_kernel(
    seed: int,
    is_given: int,
    geometric: float,
    chosen: int,
    reference: Reference,
    sources: Sources,
    planes: array(dtype=vec4),
    costs: array(dtype=float32),
):
    """Initialize each plane randomly or as given, its cost in every source, and the mean of the best."""
    i = tid()
    x = i % reference.width
    y = i // reference.width
    plane = planes[i]
    if is_given == 0:
        u = random_uniform(seed, i, 0)
        w = reference.farthest + (reference.nearest - reference.farthest) * u[0]
        slopes = slopes_of(random_direction(u, x, y, reference.lens), x, y, w, reference.lens)
        plane = vec4(w, slopes[0], slopes[1], 0.0)
    weights, rises, variance = window_of(x, y, reference, sources)
    for s in range(sources.count):
        costs[i * sources.count + s] = source_cost(
            x, y, plane, s, geometric, weights, rises, variance, reference, sources
        )
    cost = mean_of_best(i, chosen, sources.count, costs)
    planes[i] = vec4(plane[0], plane[1], plane[2], cost)


@func
def changed_plane(
    plane: vec4, x: int, y: int, pixel: int, trial: int, options: HalfIteration, reference: Reference
) -> vec4:
    """A perturbed or random plane. The cost is not set."""
    u = random_uniform(options.seed, pixel, 1 + options.number * TRIALS + trial)
    n = normal_of(plane, x, y, reference.lens)
    w = plane[0]
    if trial % 2 == 0:
        w = plane[0] + options.spread / reference.pixels_per * (u[0] * 2.0 - 1.0)
    if trial == 1 or trial == 2:
        tilt = options.spread * TILT
        n = faced_away(n + vec3(u[1] * 2.0 - 1.0, u[2] * 2.0 - 1.0, u[3] * 2.0 - 1.0) * tilt, x, y, reference.lens)
    if trial == 3:
        w = reference.farthest + (reference.nearest - reference.farthest) * u[0]
        n = random_direction(u, x, y, reference.lens)
    slopes = slopes_of(n, x, y, w, reference.lens)
    return vec4(w, slopes[0], slopes[1], 0.0)


@func
def is_other(a: vec4, b: vec4, pixels_per: float) -> int:
    """1 if two planes differ significantly over a patch."""
    difference = abs(a[0] - b[0]) + PATCH_RADIUS * (abs(a[1] - b[1]) + abs(a[2] - b[2]))
    other = 0
    if difference * pixels_per > SAME_PLANE:
        other = 1
    return other


@func
def hypothesis(
    k: int,
    x: int,
    y: int,
    plane: vec4,
    near: eight_indices,
    planes: array(dtype=vec4),
    options: HalfIteration,
    reference: Reference,
) -> vec4:
    """Candidate plane: of a region, or perturbed. The fourth number is 1 if it may be better."""
    candidate = vec4(0.0, 0.0, 0.0, 0.0)
    if k >= options.regions:
        candidate = changed_plane(plane, x, y, y * reference.width + x, k - options.regions, options, reference)
        candidate[3] = 1.0
    elif near[k] >= 0:
        o = planes[near[k]]
        w = inverse_depth_at(o, float(x - near[k] % reference.width), float(y - near[k] // reference.width))
        candidate = vec4(w, o[1], o[2], 0.0)
        candidate[3] = float(is_other(candidate, plane, reference.pixels_per))
    if candidate[0] > reference.nearest or candidate[0] < reference.farthest:
        candidate[3] = 0.0
    return candidate


@func
def weights_of(ratings: eight, order: eight_indices, count: int, max_sources: int) -> tuple[eight, int, float]:
    """Weights of the best sources by rank. Their count and sum."""
    weight = eight(0.0)
    for k in range(count):
        weight[k] = ratings[order[k]]
    chosen = 0
    total = 0.0
    for k in range(max_sources):
        if weight[k] > 0.0:
            chosen += 1
            total += weight[k]
    if chosen == 0:  # no source fits: all are equal
        chosen = max_sources
        for k in range(chosen):
            weight[k] = 1.0
        total = float(chosen)
    return weight, chosen, total


@func
def round_trip_costs(
    x: int,
    y: int,
    w: float,
    first: int,
    last: int,
    bound: float,
    geometric: float,
    order: eight_indices,
    weight: eight,
    sources: Sources,
) -> tuple[eight, float]:
    """Round-trip costs in the sources of some ranks, and their weighted sum, up to the bound."""
    errors = eight(0.0)
    total = 0.0
    if geometric > 0.0:
        for rank in range(first, last):
            if total < bound:
                back = round_trip(x, y, w, order[rank], sources)
                errors[rank] = geometric * back[0]
                total += weight[rank] * errors[rank]
    return errors, total


@kernel
def spread_planes_kernel(
    options: HalfIteration,
    reference: Reference,
    sources: Sources,
    planes: array(dtype=vec4),
    costs: array(dtype=float32),
):
    """Pixels of one color test candidates. They read only the other color."""
    i = tid()
    half = (reference.width + 1) // 2
    y = i // half
    x = 2 * (i % half) + (y + options.color) % 2
    if x >= reference.width:
        return
    pixel = y * reference.width + x
    count = sources.count
    near = eight_indices(-1)
    for k in range(options.regions):
        near[k] = best_of_region(planes, x, y, k, reference.width, reference.height)
    ratings = rate_sources(pixel, count, near, options.good, costs)
    order = order_of(ratings, count)  # sources behind the chosen ones are evaluated once, at the end
    weight, chosen, sum_of_weights = weights_of(ratings, order, count, options.chosen)
    plane = planes[pixel]
    bound = 0.0  # weighted cost sum that a better plane must not exceed
    for k in range(chosen):
        bound += weight[k] * costs[pixel * count + order[k]]
    is_new = 0
    weights, rises, variance = window_of(x, y, reference, sources)
    hypotheses = options.regions + options.trials
    for k in range(hypotheses + 1):
        is_last = 1 if k == hypotheses else 0  # evaluate the resulting plane in the remaining sources
        candidate = plane
        is_tried = is_new
        first = chosen
        last = count
        if is_last == 0:
            candidate = hypothesis(k, x, y, plane, near, planes, options, reference)
            is_tried = int(candidate[3])
            first = 0
            last = chosen
        if is_tried == 1:
            new_costs = eight(0.0)
            limit = bound
            if is_last == 1:
                limit = NO_COST
            # Round trips are fast to compute: if they reject a plane, no patch is compared.
            errors, total = round_trip_costs(
                x, y, candidate[0], first, last, limit, options.geometric, order, weight, sources
            )
            rank = first
            while rank < last and total < limit:
                c = patch_cost(x, y, candidate, order[rank], weights, rises, variance, reference, sources)
                new_costs[rank] = c + errors[rank]
                total += weight[rank] * c
                rank = rank + 1
            if is_last == 1 or total < bound:
                for r in range(first, last):
                    costs[pixel * count + order[r]] = new_costs[r]
            if is_last == 0 and total < bound:
                bound = total
                plane = candidate
                is_new = 1
    planes[pixel] = vec4(plane[0], plane[1], plane[2], bound / sum_of_weights)


def start_planes(
    reference: Reference,
    sources: Sources,
    planes: Array1[vec4],
    *,
    seed: int,
    is_given: bool,
    geometric: float,
    chosen: int,
) -> Scalars:
    """Initialize `planes` unless given, and their costs. Returns the costs per source, (pixels * sources)."""
    count = reference.width * reference.height
    costs = empty(count * sources.count, float32, planes.device)
    launch(start_planes_kernel, count, [seed, int(is_given), geometric, chosen, reference, sources, planes, costs])
    return costs


def spread_planes(
    options: HalfIteration, reference: Reference, sources: Sources, planes: Array1[vec4], costs: Scalars
) -> None:
    """One half iteration: pixels of one color find better planes."""
    threads = (reference.width + 1) // 2 * reference.height
    launch(spread_planes_kernel, threads, [options, reference, sources, planes, costs])
