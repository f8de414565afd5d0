"""Which sources a pixel is compared with: those that its neighbours' planes fit, and few that they do not.

Each pixel keeps the cost of its plane in every source. A source is worth what it shows of the neighbours that the
pixel might take its plane from: good costs speak for it, bad ones (it is hidden there, or the plane is wrong) against.
That is the joint view selection of Xu and Tao 2019, "Multi-scale geometric consistency guided multi-view stereo"
(section 3.1), from costs that are there already, and without drawing lots.

It reads up to 9 costs a source, and takes some 100 operations a source.
"""

from ..lang import array, float32, func, int32, vector

NEIGHBORS = 8
MOST_SOURCES = 8
BAD_COST = 1.2  # speaks against a source
MOST_BAD = 2  # of the nine costs
LEAST_GOOD = 2
FALLOFF = 0.09  # square of the cost that halves what a good one says
UNSURE = 0.02  # the weight of a source that nothing speaks for or against

eight = vector(8, float32)
eight_places = vector(8, int32)


@func
def worth_of(i: int, s: int, count: int, near: eight_places, good: float, costs: array(dtype=float32)) -> float:
    """What a source is worth to pixel i, 0 to 1; `near` are the neighbours, -1 where there is none."""
    fine = 0
    bad = 0
    total = 0.0
    neighbors = int(NEIGHBORS)
    for k in range(neighbors + 1):
        place = int(i)
        if k < NEIGHBORS:
            place = near[k]
        if place >= 0:
            c = costs[place * count + s]
            if c < good:
                fine += 1
                total += FALLOFF / (FALLOFF + c * c)
            if c > BAD_COST:
                bad += 1
    worth = 0.0
    if bad <= MOST_BAD:
        worth = UNSURE
        if fine >= LEAST_GOOD:
            worth = total / float(fine)
    return worth


@func
def worths_of(i: int, count: int, near: eight_places, good: float, costs: array(dtype=float32)) -> eight:
    """What each source is worth to pixel i; 0 beyond their count."""
    worths = eight(0.0)
    for s in range(count):
        worths[s] = worth_of(i, s, count, near, good, costs)
    return worths


@func
def order_of(worths: eight, count: int) -> eight_places:
    """The sources, the one of most worth first; of equals the first."""
    order = eight_places(0)
    for s in range(count):
        rank = int(s)
        while rank > 0 and worths[order[max(rank - 1, 0)]] < worths[s]:
            order[rank] = order[rank - 1]
            rank = rank - 1
        order[rank] = s
    return order
