"""The nearest rows of a query in a FeatureTree, by one thread, without a stack.

A query goes down to one group that lies close, compares its rows, and then visits every box within the limit of what it
has found: 16 children are measured side by side and those within are the bits of a number, so what is left to visit are
16 bits a level. Of a group, rows are told apart by their 6 leading coordinates, then by all 16, and in full only where
these are near enough: of 8,500 FPFH rows of an indoor scan, 60 groups and 30 rows.

A result is kept as a 64-bit key, the bits of its squared distance above its number: ties go to the lower number.
"""

from ..algebra.plain_min_max import larger, smaller
from ..arrays.packed_keys import key_number, pack_key
from ..lang import INFINITY, array, bit_count, float32, func, int64, sqrt, vector
from .feature_tree import AXES, BOXED, FAN, GROUP, SIDES, STEP, FeatureTree, axes

NO_ROW_KEY = 0x7F80_0000_FFFF_FFFF  # a key beyond all others: an infinite distance, and no row
BITS = 0xFFFF  # one level's part of what is left to visit
ABOVE = 0xFFFF_FFFF_0000  # the parts of the levels above the lowest
EQUAL = 1  # a group of equal rows ...
FIRST_TWO = 3  # ... of which these lanes are enough
REPEATED = 2  # a group of the same equal rows as the group before, which has the lower numbers
WIDEST_LIMIT = 3.0e38  # where nothing is found yet: below infinity, where stands what is not there
TINY = 1.0e-30  # covers products below the normal numbers, whose rounding is not relative

lanes = vector(16, float32)
eight = vector(8, float32)
closest = vector(2, int64)  # the keys of the nearest row and of the next one


@func
def square_distance(a: int, some: array(dtype=float32), b: int, others: array(dtype=float32), width: int) -> float:
    """|a - b|^2 of the packed rows that begin at a and b: eight sums side by side, then theirs; either way the same."""
    sums = eight(0.0)
    for c in range(width // STEP):
        for j in range(STEP):
            gap = some[a + c * STEP + j] - others[b + c * STEP + j]
            sums[j] += gap * gap
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]))


@func
def limit_of(key: int64, slack: float, margin: float) -> float:
    """The squared distance of coordinates beyond which no row is as near as a key's.

    With R the length of the longest row, u = 2^-24 and d columns: coordinates are rounded to float32, u R, and the
    length of what is left is the root of a difference of float64 sums, 7e-8 d^(1/2) R. `margin` is more than both
    for two rows. `slack` covers the rounding of the row's distance, (d / 8 + 6) u, and of the coordinates', 20 u.
    """
    reach = sqrt(key_number(key)) * slack + margin
    return smaller(reach * reach * slack + TINY, WIDEST_LIMIT)


@func
def lanes_within(sqdists: lanes, limit: float) -> int:
    """Bit j is set where lane j is not beyond the limit."""
    found = 0
    for j in range(FAN):
        found = found | ((1 if sqdists[j] <= limit else 0) << j)
    return found


@func
def smallest_lane(sqdists: lanes) -> int:
    """The lane of the smallest number."""
    found = 0
    least = sqdists[0]
    for j in range(1, FAN):
        if sqdists[j] < least:
            least = sqdists[j]
            found = j
    return found


@func
def measure_children(node: int, boxes: array(dtype=float32), y: axes) -> lanes:
    """Squared distances from coordinates to the boxes of a node's children; infinite where there is no child."""
    at = node * SIDES
    sqdists = lanes(0.0)
    for k in range(BOXED):
        x = y[k]
        for j in range(FAN):
            gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)
            sqdists[j] += gap * gap
    return sqdists


@func
def rows_within(group: int, grouped: array(dtype=float32), y: axes, limit: float) -> int:
    """Bit j is set where the coordinates of a group's row j are not beyond the limit."""
    at = group * AXES * GROUP
    sqdists = lanes(0.0)
    for k in range(BOXED):
        x = y[k]
        for j in range(GROUP):
            gap = grouped[at + k * GROUP + j] - x
            sqdists[j] += gap * gap
    found = lanes_within(sqdists, limit)
    if found != 0:
        for k in range(BOXED, AXES):
            x = y[k]
            for j in range(GROUP):
                gap = grouped[at + k * GROUP + j] - x
                sqdists[j] += gap * gap
        found = lanes_within(sqdists, limit)
    return found


@func
def coordinates_of(place: int, tree: FeatureTree) -> axes:
    """The coordinates of one row of a tree."""
    y = axes(0.0)
    at = (place // GROUP) * AXES * GROUP + place % GROUP
    for k in range(AXES):
        y[k] = tree.grouped[at + k * GROUP]
    return y


@func
def offer_group(
    group: int, y: axes, limit: float, place: int, queries: FeatureTree, tree: FeatureTree, held: closest
) -> closest:
    """The two smallest of the keys held and those of a group's rows; the query is the row at a place of its own tree.

    Of equal rows only the first two matter, which have the lowest numbers: without this, n rows would be compared with
    n equal ones each.
    """
    best = held[0]
    next_best = held[1]
    left = 0
    if tree.alike[group] != REPEATED:
        left = rows_within(group, tree.grouped, y, limit)
        if tree.alike[group] == EQUAL:
            left = left & FIRST_TWO
    while left != 0:
        lowest = left & (-left)
        left = left ^ lowest
        row = group * GROUP + bit_count(lowest - 1)
        sqdist = square_distance(place * tree.width, queries.packed, row * tree.width, tree.packed, tree.width)
        key = pack_key(sqdist, tree.labels[row])
        if key < best:
            next_best = best
            best = key
        elif key < next_best:
            next_best = key
    return closest(best, next_best)


@func
def closest_group(y: axes, tree: FeatureTree) -> int:
    """A group that lies close: down the tree, each time into the nearest child."""
    node = 0
    least = float(INFINITY)
    for root in range(tree.roots):
        sqdists = measure_children(tree.third + root, tree.boxes, y)
        lane = smallest_lane(sqdists)
        if sqdists[lane] < least:
            least = sqdists[lane]
            node = root * FAN + lane
    node = node * FAN + smallest_lane(measure_children(tree.second + node, tree.boxes, y))
    return node * FAN + smallest_lane(measure_children(node, tree.boxes, y))


@func
def search_rows(
    y: axes,
    place: int,
    queries: FeatureTree,
    tree: FeatureTree,
    held: closest,
    seen: int,
    counted: int,
    stop: int,
    slack: float,
    margin: float,
) -> closest:
    """The two smallest of the keys held and those of all rows, but for the group `seen`.

    Only rows that may be nearer than held[counted] are sure to be found. With `stop` the search ends at the first key
    that is smaller than one of those held.
    """
    found = held
    limit = limit_of(found[counted], slack, margin)
    searching = 1
    for root in range(tree.roots):
        node = root
        level = 3  # of the node; those of level 1 have groups for children
        left = int64(lanes_within(measure_children(tree.third + root, tree.boxes, y), limit)) << 32
        while left != 0 and searching == 1:
            shift = int64(FAN * (level - 1))
            bits = int(left >> shift) & BITS
            if bits == 0:
                node = node // FAN
                level += 1
            else:
                lowest = bits & (-bits)
                left = left ^ (int64(lowest) << shift)
                child = node * FAN + bit_count(lowest - 1)
                if level > 1:
                    node = child
                    level -= 1
                    first = 0 if level == 1 else tree.second
                    inside = lanes_within(measure_children(first + node, tree.boxes, y), limit)
                    left = left | (int64(inside) << int64(FAN * (level - 1)))
                elif child != seen:
                    now = offer_group(child, y, limit, place, queries, tree, found)
                    if now[counted] < found[counted]:
                        limit = limit_of(now[counted], slack, margin)
                        inside = lanes_within(measure_children(node, tree.boxes, y), limit)
                        left = left & (int64(inside) | int64(ABOVE))
                        searching = 1 - stop
                    found = now
    return found
