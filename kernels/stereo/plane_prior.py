"""Plain places: where patches say nothing, and whether a plane fitted to what surrounds them may stand there.

A patch of one brightness fits every plane alike, so that PatchMatch follows the noise. Such a pixel takes the plane of
its surroundings unless the pictures speak clearly against it (the idea is Xu and Tao's, 2020, "Planar prior assisted
PatchMatch multi-view stereo"; their likelihoods are exponentials, which round differently on each device: here it is a
difference of costs that may be the greater the plainer the pixel is). What has texture is not touched.

One thread a pixel. The first reads 49 brightnesses and 16 B a source; the second the patches of plain pixels alone.
"""

from ..array_types import Array1, Scalars
from ..lang import array, float32, kernel, launch, sqrt, tid, vec2, vec4
from ..memory import empty
from .patch_costs import Reference, Sources, way_back, window_of
from .patch_match import mean_of_best, source_cost
from .plane_results import AGREED_PIXELS, AGREED_SHARE

REACH = 2  # [px] from the middle of the window that texture is measured in to its border
PLAIN = 0.011  # standard deviation of brightness that is noise alone: 2 to 3 of 255
TEXTURED = 0.016  # and that is texture
SURE_COST = 0.35  # below which a plane is one to hold others against
SURE_SOURCES = 2  # whose own depth agrees with it, or all that there are
PLAIN_COST = 0.75  # of a prior at most, where no patch has a say
CLEARLY = 0.8  # by which another plane has to fit better than the prior of a wholly plain pixel: noise does by half


@kernel
def judge_places_kernel(reference: Reference, sources: Sources, planes: array(dtype=vec4), judged: array(dtype=vec2)):
    """How plain each pixel is, 0 to 1, and 1 where its depth is sure."""
    i = tid()
    x = i % reference.width
    y = i // reference.width
    center = sources.pictures[reference.first + i]
    count = 0.0
    total = 0.0
    squares = 0.0
    side = int(2 * REACH + 1)
    for j in range(side):
        row = y + j - REACH
        if row >= 0 and row < reference.height:
            for k in range(side):
                column = x + k - REACH
                if column >= 0 and column < reference.width:
                    d = sources.pictures[reference.first + row * reference.width + column] - center
                    count += 1.0
                    total += d
                    squares += d * d
    mean = total / count
    spread = sqrt(max(squares / count - mean * mean, 0.0))
    plain = min(max((TEXTURED - spread) / (TEXTURED - PLAIN), 0.0), 1.0)
    plane = planes[i]
    agreed = 0
    for s in range(sources.count):
        back = way_back(x, y, plane[0], s, sources)
        if back[0] < AGREED_PIXELS and abs(back[1] - plane[0]) < AGREED_SHARE * plane[0]:
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
    """Pixels take their prior, whose last number is its weight and not a cost, unless their plane is clearly better."""
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
    if theirs < own + prior[3] * CLEARLY:
        planes[i] = vec4(prior[0], prior[1], prior[2], min(min(own, theirs), PLAIN_COST))


def judge_places(reference: Reference, sources: Sources, planes: Array1[vec4]) -> Array1[vec2]:
    """How plain pixels are and how sure their depth, [pixels, 2]."""
    count = reference.width * reference.height
    judged = empty(count, vec2, planes.device)
    launch(judge_places_kernel, count, [reference, sources, planes, judged])
    return judged


def take_priors(
    chosen: int,
    geometric: float,
    reference: Reference,
    sources: Sources,
    priors: Array1[vec4],
    planes: Array1[vec4],
    costs: Scalars,
) -> None:
    """Put priors where they stand against the planes; `costs` of each source are spent."""
    count = reference.width * reference.height
    launch(take_priors_kernel, count, [chosen, geometric, reference, sources, priors, planes, costs])
