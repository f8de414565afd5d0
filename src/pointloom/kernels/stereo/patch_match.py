"""PatchMatch stereo with checkerboard propagation.

Pixels of one color test the planes of the best of eight regions of the other color, then random perturbations (Galliani
et al. 2015, "Massively parallel multiview stereopsis by surface normal diffusion"; regions and joint view selection of
Xu and Tao 2019, "Multi-scale geometric consistency guided multi-view stereo", section 3.1, without random sampling).
Costs are means over the chosen sources plus round-trip errors where maps are known. Random numbers depend on seed,
pixel and iteration only: bitwise reproducible. The planes of the regions, then the perturbed ones, are evaluated
together as eight lanes, since the divisions and roots of one plane after another would wait for each other.
"""

from dataclasses import dataclass

from ..array_types import Array1, Scalars
from ..arrays.lanes import min_of_eight
from ..arrays.random import half_uniform, random_bits, random_uniform
from ..lang import (
    INFINITY,
    WARP,
    array,
    cuda_func,
    float32,
    func,
    kernel,
    launch,
    struct,
    sync_lanes,
    tid,
    vec3,
    vec3i,
    vec4,
    vector,
)
from ..memory import empty
from ..search.lane_boxes import flags_of_eight
from ..search.tree_walk import lowest_bit
from .inverse_planes import limited_tilt, normal_of, random_direction, ray_of, slopes_of
from .lane_costs import index_of_eight, of_eight, own_samples, patch_cost_of_lanes, vector_of_eight, window_of_lanes
from .patch_costs import (
    LANE_COUNT,
    Reference,
    Sources,
    eight,
    eight_indices,
    patch_cost,
    patch_costs,
    round_trip,
    round_trips,
    samples,
    window_of,
)

NEIGHBOR_COUNT = 8
MAX_SOURCES = 8
BAD_COST = 1.2  # counts against a source
MAX_BAD = 2  # of the nine costs
MIN_GOOD = 2
HALF_WEIGHT_SQCOST = 0.09  # squared cost that halves the weight of a good one
NO_EVIDENCE_WEIGHT = 0.02  # weight of a source without evidence

source_costs = vector(MAX_SOURCES * LANE_COUNT, float32)  # of eight planes


@func
def rate_source(i: int, s: int, count: int, near: eight_indices, good: float, costs: array(dtype=float32)) -> float:
    """Value of a source for pixel i, 0 to 1; `near` are neighbors or -1."""
    fine = 0
    bad = 0
    total = 0.0
    neighbors = int(NEIGHBOR_COUNT)
    for k in range(neighbors + 1):
        neighbor = int(i)
        if k < NEIGHBOR_COUNT:
            neighbor = near[k]
        if neighbor >= 0:
            c = costs[neighbor * count + s]
            if c < good:
                fine += 1
                total += HALF_WEIGHT_SQCOST / (HALF_WEIGHT_SQCOST + c * c)
            if c > BAD_COST:
                bad += 1
    rating = 0.0
    if bad <= MAX_BAD:
        rating = NO_EVIDENCE_WEIGHT
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
TRIALS_PER_STEP = 4  # perturbed planes per half iteration: depth, normal, both, random
SAME_PLANE = 0.02  # [px] difference over a patch below which planes are equal
PATCH_RADIUS = 5.0  # [px] patch radius
NORMAL_CHANGE_PER_PIXEL = 0.08  # change of a unit normal per pixel of spread


@struct
@dataclass(frozen=True)
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
def best_of_region(
    planes: array(dtype=vec4), x: int, y: int, region: int, width: int, height: int
) -> tuple[int, int, int]:
    """Pixel of least cost in a region of the other color, or -1 outside, and its offset along and across."""
    best_step = 0
    best_shift = 0
    low = float(NO_COST)
    side = region % 4
    beyond = height - 1 - y  # pixels in the direction of the region, and to both sides
    along = int(width)
    if side == 1:
        beyond = y
        along = -width
    left = int(x)
    right = width - 1 - x
    across = 1
    if side >= 2:
        left = y
        right = height - 1 - y
        across = width
        beyond = width - 1 - x
        along = 1
        if side == 3:
            beyond = x
            along = -1
    pixel = y * width + x
    if region >= 4:
        count = min(max((beyond - FAR_BEGIN) // 2 + 1, 0), FAR_COUNT)
        for k in range(count):
            step = FAR_BEGIN + 2 * k
            c = planes[pixel + step * along][3]
            if c < low:
                low = c
                best_step = step
    else:
        count = int(NEAR_COUNT)
        for k in range(count):
            step = (k + 1) // 2
            shift = int(step)
            if k % 2 == 1:
                shift = -step
            if step < beyond and -shift <= left and shift <= right:
                c = planes[pixel + (step + 1) * along + shift * across][3]
                if c < low:
                    low = c
                    best_step = step + 1
                    best_shift = shift
    best = -1
    if best_step > 0:
        best = pixel + best_step * along + best_shift * across
    if side % 2 == 1:
        best_step = -best_step
    return best, best_step, best_shift


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
        ray = ray_of(x, y, reference.lens)
        slopes = slopes_of(limited_tilt(random_direction(u), ray), ray, w, reference.lens)
        plane = vec4(w, slopes[0], slopes[1], 0.0)
    weights, rises, variance = window_of(x, y, reference, sources)
    for s in range(sources.count):
        costs[i * sources.count + s] = source_cost(
            x, y, plane, s, geometric, weights, rises, variance, reference, sources
        )
    cost = mean_of_best(i, chosen, sources.count, costs)
    planes[i] = vec4(plane[0], plane[1], plane[2], cost)


@func
def region_planes(
    x: int, y: int, plane: vec4, planes: array(dtype=vec4), options: HalfIteration, reference: Reference
) -> tuple[eight_indices, eight, eight, eight, eight_indices]:
    """The best pixels of the regions, -1 if outside, their planes as w, gx, gy, and 1 for those that may be better."""
    near = eight_indices(-1)
    dx = eight(0.0)
    dy = eight(0.0)
    for k in range(options.regions):
        best, step, shift = best_of_region(planes, x, y, k, reference.width, reference.height)
        near[k] = best
        across = int(step)
        down = int(shift)
        if k % 4 < 2:
            across = shift
            down = step
        dx[k] = float(across)
        dy[k] = float(down)
    w = eight(0.0)
    gx = eight(0.0)
    gy = eight(0.0)
    for k in range(LANE_COUNT):
        other = planes[max(near[k], 0)]
        w[k] = other[0]
        gx[k] = other[1]
        gy[k] = other[2]
    is_tried = eight_indices(0)
    for k in range(LANE_COUNT):
        w[k] = w[k] - gx[k] * dx[k] - gy[k] * dy[k]
        slopes = abs(gx[k] - plane[1]) + abs(gy[k] - plane[2])
        difference = (abs(w[k] - plane[0]) + PATCH_RADIUS * slopes) * reference.pixels_per
        tried = 1 if near[k] >= 0 else 0
        is_tried[k] = tried if difference > SAME_PLANE else 0
    return near, w, gx, gy, is_tried


@func
def changed_planes(
    x: int, y: int, pixel: int, plane: vec4, options: HalfIteration, reference: Reference
) -> tuple[eight, eight, eight, eight_indices]:
    """Perturbed depth, normal, both, and a random plane, as w, gx, gy, and 1 for each."""
    stream = 1 + options.number * (TRIALS_PER_STEP // 2)
    a = random_bits(options.seed, pixel, stream)
    b = random_bits(options.seed, pixel, stream + 1)
    lens = reference.lens
    ray = ray_of(x, y, lens)
    normal = normal_of(plane, x, y, lens)
    w = eight(0.0)
    gx = eight(0.0)
    gy = eight(0.0)
    is_tried = eight_indices(0)
    for k in range(TRIALS_PER_STEP):
        words = a
        if k >= 2:
            words = b
        u = half_uniform(words, k % 2)
        w[k] = plane[0]
        if k % 2 == 0:
            w[k] = plane[0] + options.spread / reference.pixels_per * (u[0] * 2.0 - 1.0)
        if k == 3:
            w[k] = reference.farthest + (reference.nearest - reference.farthest) * u[0]
        direction = random_direction(u)
        if k == 0:
            direction = normal
        elif k < 3:
            direction = normal + direction * (options.spread * NORMAL_CHANGE_PER_PIXEL)
        slopes = slopes_of(limited_tilt(direction, ray), ray, w[k], lens)
        gx[k] = slopes[0]
        gy[k] = slopes[1]
        if k < options.trials:
            is_tried[k] = 1
    return w, gx, gy, is_tried


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
    plane = planes[pixel]
    near, w, gx, gy, is_tried = region_planes(x, y, plane, planes, options, reference)
    ratings = rate_sources(pixel, count, near, options.good, costs)
    order = order_of(ratings, count)  # sources behind the chosen ones are evaluated once, at the end
    weight, chosen, sum_of_weights = weights_of(ratings, order, count, options.chosen)
    bound = 0.0  # weighted cost sum that a better plane must not exceed
    for k in range(chosen):
        bound += weight[k] * costs[pixel * count + order[k]]
    is_new = 0
    weights, rises, variance = window_of(x, y, reference, sources)
    for part in range(3):  # planes of the regions, perturbed ones, the resulting one in the remaining sources
        first = 0
        last = int(chosen)
        limit = float(bound)
        if part == 1:
            w, gx, gy, is_tried = changed_planes(x, y, pixel, plane, options, reference)
        if part == 2:
            w = eight(plane[0])
            gx = eight(plane[1])
            gy = eight(plane[2])
            is_tried = eight_indices(0)
            is_tried[0] = is_new
            first = chosen
            last = count
            limit = NO_COST
        for k in range(LANE_COUNT):
            is_tried[k] = is_tried[k] if w[k] <= reference.nearest else 0
            is_tried[k] = is_tried[k] if w[k] >= reference.farthest else 0
        table = source_costs(0.0)
        totals = eight(0.0)
        if options.geometric > 0.0:  # fast to compute: if they reject a plane, no patch is compared
            for rank in range(first, last):
                errors = round_trips(x, y, w, order[rank], sources)
                for k in range(LANE_COUNT):
                    table[rank * LANE_COUNT + k] = options.geometric * errors[k]
                    totals[k] = totals[k] + weight[rank] * table[rank * LANE_COUNT + k]
        for rank in range(first, last):
            for k in range(LANE_COUNT):
                is_tried[k] = is_tried[k] if totals[k] < limit else 0
            c = patch_costs(x, y, w, gx, gy, is_tried, order[rank], weights, rises, variance, reference, sources)
            for k in range(LANE_COUNT):
                table[rank * LANE_COUNT + k] = table[rank * LANE_COUNT + k] + c[k]
                totals[k] = totals[k] + weight[rank] * c[k]
        best = -1
        for k in range(LANE_COUNT):
            if is_tried[k] == 1 and totals[k] < limit:
                limit = totals[k]
                best = k
        if best >= 0:
            for rank in range(first, last):
                costs[pixel * count + order[rank]] = table[rank * LANE_COUNT + best]
            if part < 2:
                bound = limit
                plane = vec4(w[best], gx[best], gy[best], 0.0)
                is_new = 1
    planes[pixel] = vec4(plane[0], plane[1], plane[2], bound / sum_of_weights)


@cuda_func
def region_plane(
    x: int, y: int, k: int, plane: vec4, planes: array(dtype=vec4), options: HalfIteration, reference: Reference
) -> tuple[int, vec3, int]:
    """`region_planes` for region k: the best pixel, its plane, and 1 if it may be better."""
    near = -1
    offered = vec3(0.0, 0.0, 0.0)
    tried = 0
    if k < options.regions:
        best, step, shift = best_of_region(planes, x, y, k, reference.width, reference.height)
        near = best
        if best >= 0:
            across = float(step)
            down = float(shift)
            if k % 4 < 2:
                across = float(shift)
                down = float(step)
            other = planes[best]
            w = other[0] - other[1] * across - other[2] * down
            offered = vec3(w, other[1], other[2])
            slopes = abs(other[1] - plane[1]) + abs(other[2] - plane[2])
            difference = (abs(w - plane[0]) + PATCH_RADIUS * slopes) * reference.pixels_per
            tried = 1 if difference > SAME_PLANE else 0
    return near, offered, tried


@cuda_func
def changed_plane(
    x: int, y: int, k: int, pixel: int, plane: vec4, options: HalfIteration, reference: Reference
) -> vec3:
    """Plane k of `changed_planes`."""
    words = random_bits(options.seed, pixel, 1 + options.number * (TRIALS_PER_STEP // 2) + k // 2)
    u = half_uniform(words, k % 2)
    ray = ray_of(x, y, reference.lens)
    w = plane[0]
    if k % 2 == 0:
        w = plane[0] + options.spread / reference.pixels_per * (u[0] * 2.0 - 1.0)
    if k == 3:
        w = reference.farthest + (reference.nearest - reference.farthest) * u[0]
    direction = random_direction(u)
    normal = normal_of(plane, x, y, reference.lens)
    if k == 0:
        direction = normal
    elif k < 3:
        direction = normal + direction * (options.spread * NORMAL_CHANGE_PER_PIXEL)
    slopes = slopes_of(limited_tilt(direction, ray), ray, w, reference.lens)
    return vec3(w, slopes[0], slopes[1])


@cuda_func
def rate_source_of_lane(i: int, s: int, count: int, near: int, good: float, costs: array(dtype=float32)) -> float:
    """`rate_source` for the lane's source s, 0 beyond the count. Each of the eight lanes has a neighbor."""
    fine = 0
    bad = 0
    total = 0.0
    neighbors = int(NEIGHBOR_COUNT)
    for k in range(neighbors + 1):
        neighbor = index_of_eight(near, k % NEIGHBOR_COUNT)
        if k == NEIGHBOR_COUNT:
            neighbor = i
        if neighbor >= 0 and s < count:
            c = costs[neighbor * count + s]
            if c < good:
                fine += 1
                total += HALF_WEIGHT_SQCOST / (HALF_WEIGHT_SQCOST + c * c)
            if c > BAD_COST:
                bad += 1
    rating = 0.0
    if bad <= MAX_BAD and s < count:
        rating = NO_EVIDENCE_WEIGHT if fine < MIN_GOOD else total / float(fine)
    return rating


@cuda_func
def source_at_rank(rating: float, k: int, count: int) -> int:
    """`order_of` for rank k: its source, by the ratings of the eight lanes."""
    rank = int(k)
    if k < count:
        rank = 0
    sources = int(LANE_COUNT)
    for s in range(sources):
        other = of_eight(rating, s)
        if k < count and s < count and (other > rating or (other == rating and s < k)):
            rank += 1
    source = 0
    for s in range(sources):
        taken = index_of_eight(rank, s)
        if taken == k and k < count:
            source = s
    return source


@cuda_func
def weights_of_lanes(weight: float, k: int, max_sources: int) -> tuple[float, int, float]:
    """`weights_of` for rank k, with the count and sum of all."""
    chosen = 0
    total = 0.0
    for rank in range(max_sources):
        w = of_eight(weight, rank)
        if w > 0.0:
            chosen += 1
            total += w
    used = weight
    if chosen == 0:
        chosen = max_sources
        used = 1.0
        total = float(chosen)
    return used, chosen, total


@cuda_func
def with_added(table: eight, rank: int, x: float) -> eight:
    added = table
    for k in range(LANE_COUNT):
        added[k] = table[k] + x if k == rank else table[k]
    return added


@cuda_func
def cost_at_rank(table: eight, k: int, best: int) -> float:
    """The cost of rank k in the table of lane `best` of the own eight."""
    cost = 0.0
    for rank in range(LANE_COUNT):
        other = of_eight(table[rank], best)
        cost = other if rank == k else cost
    return cost


@cuda_func
def compare_planes(
    x: int,
    y: int,
    k: int,
    offered: vec3,
    is_tried: int,
    ranks: vec3i,
    source: int,
    weight: float,
    limit: float,
    center: float,
    weights: own_samples,
    rises: own_samples,
    variance: float,
    options: HalfIteration,
    reference: Reference,
    sources: Sources,
) -> tuple[int, float, eight]:
    """Compare each lane's plane with the sources of the ranks from ranks[0] to ranks[1] - 1, of ranks[2] in the warp,
    until the weighted sum of the costs is `limit`. Returns 1 if it is lower, the sum, and the costs by rank."""
    tried = is_tried + 0
    table = eight(0.0)
    total = 0.0
    if options.geometric > 0.0:
        for rank in range(ranks[2]):
            s = index_of_eight(source, rank)
            w = of_eight(weight, rank)
            if tried == 1 and rank >= ranks[0] and rank < ranks[1]:
                errors = round_trips(x, y, eight(offered[0]), s, sources)
                error = options.geometric * errors[0]
                table = with_added(table, rank, error)
                total = total + w * error
    for rank in range(ranks[2]):
        s = index_of_eight(source, rank)
        w = of_eight(weight, rank)
        compared = 0
        if rank >= ranks[0] and rank < ranks[1]:
            tried = tried if total < limit else 0
            compared = tried
        c = patch_cost_of_lanes(x, y, k, offered, compared, s, center, weights, rises, variance, reference, sources)
        if rank >= ranks[0] and rank < ranks[1]:
            table = with_added(table, rank, c)
            total = total + w * c
    return tried, total, table


@spread_planes_kernel.on_cuda
def spread_planes_of_lanes_kernel(
    options: HalfIteration,
    reference: Reference,
    sources: Sources,
    planes: array(dtype=vec4),
    costs: array(dtype=float32),
):
    """CUDA variant, eight lanes per pixel: a lane has a region, a plane, a source by its number and one by its rank."""
    i = tid()
    k = i % LANE_COUNT
    half = (reference.width + 1) // 2
    y = i // LANE_COUNT // half
    x = 2 * (i // LANE_COUNT % half) + (y + options.color) % 2
    is_pixel = 1 if x < reference.width and y < reference.height else 0
    pixel = y * reference.width + x
    count = sources.count
    plane = vec4(0.0, 0.0, 0.0, 0.0)
    near = -1
    offered = vec3(0.0, 0.0, 0.0)
    tried = 0
    if is_pixel == 1:
        plane = planes[pixel]
        near, offered, tried = region_plane(x, y, k, plane, planes, options, reference)
    else:
        x = 0
        y = 0
    rating = rate_source_of_lane(pixel, k, count if is_pixel == 1 else 0, near, options.good, costs)
    source = source_at_rank(rating, k, count)
    weight, chosen, sum_of_weights = weights_of_lanes(of_eight(rating, source), k, options.chosen)
    term = 0.0
    if is_pixel == 1 and k < count:
        term = weight * costs[pixel * count + source]
    bound = 0.0
    for rank in range(options.chosen):
        product = of_eight(term, rank)
        bound += product if rank < chosen else 0.0
    is_new = 0
    weights, rises, variance, center = window_of_lanes(x, y, k, reference, sources)
    parts = int(3)
    for part in range(parts):
        first = 0
        last = int(chosen)
        ranks = int(options.chosen)
        limit = float(bound)
        if part == 1:
            offered = changed_plane(x, y, k, pixel, plane, options, reference)
            tried = 1 if k < options.trials else 0
        if part == 2:
            offered = vec3(plane[0], plane[1], plane[2])
            tried = is_new if k == 0 else 0
            first = chosen
            last = count
            ranks = count
            limit = NO_COST
        if is_pixel == 0 or offered[0] > reference.nearest or offered[0] < reference.farthest:
            tried = 0
        span = vec3i(first, last, ranks)
        tried, total, table = compare_planes(
            x, y, k, offered, tried, span, source, weight, limit, center, weights, rises, variance, options, reference,
            sources,
        )  # fmt: skip
        offer = total if tried == 1 and total < limit else float(INFINITY)
        low = min_of_eight(offer)
        winners = flags_of_eight(1 if offer == low and low < limit else 0)
        best = lowest_bit(winners) if winners != 0 else 0
        cost = cost_at_rank(table, k, best)
        won = vector_of_eight(offered, best)
        if winners != 0:
            if k >= first and k < last:
                costs[pixel * count + source] = cost
            if part < 2:
                bound = low
                plane = vec4(won[0], won[1], won[2], 0.0)
                is_new = 1
    sync_lanes()  # all lanes have read the plane
    if is_pixel == 1 and k == 0:
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
    if planes.device.is_cuda:
        threads = -(-threads * LANE_COUNT // WARP) * WARP  # eight lanes per pixel, whole warps
    launch(spread_planes_kernel, threads, [options, reference, sources, planes, costs])
