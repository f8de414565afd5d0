"""Intersecting triangle pairs of one mesh or of two.

One thread per triangle traverses the tree and tests candidates by signs in float64. Undecided pairs are tested exactly
(triangle_sides.py). Within a mesh, pairs that share a vertex are skipped, as in Open3D. Triangles meet if an edge of
one meets the other (signs as in Guigue and Devillers, "Fast and robust triangle-triangle overlap test using orientation
predicates", 2003). Coplanar ones are tested in all three axis projections. Degenerate triangles count as edges.
Predicates are called in loops because compilers inline every call.
"""

import math
from fractions import Fraction

import numpy as np

from ..algebra.plain_min_max import larger, smaller
from ..array_types import Cells, Indices, Integers, Points, Triangles
from ..arrays.bounds import box_of, find_extremes
from ..arrays.lowest_bit import bit_of, find_lowest_bits
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import gather_rows, positions_beside, positions_of
from ..arrays.side_by_side import read_together
from ..lang import (
    array,
    callback,
    float32,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    partial,
    tid,
    uint8,
    vec3,
    vec3i,
    vector,
)
from ..memory import empty
from ..search.bucket_walk import level_children_within, next_step, start_traversal, traversal
from ..search.point_tree import FAN, measure_boxes
from .triangle_sides import (
    NOT_DECIDED,
    ExactSides,
    exact_side_of_line,
    exact_side_of_plane,
    side_of_line,
    side_of_plane,
)
from .triangle_tree import LEAF_NUMBERS, LEAF_SIZE, TriangleTree

NO_CONTACT, IN_CONTACT = 0, 1  # and NOT_DECIDED
six_signs = vector(6, int32)


@func
def plane_sides(s: vec3i, t: vec3i, side3: callback) -> six_signs:
    """Sides of s's corners of the plane of t, and vice versa."""
    sides = six_signs(0)
    corners = int(6)
    for k in range(corners):
        if k < 3:
            sides[k] = side3(s[0], s[1], s[2], t[k])
        else:
            sides[k] = side3(t[0], t[1], t[2], s[k - 3])
    return sides


@func
def are_parted(sides: six_signs) -> int:
    """1 if one triangle is entirely on one side of the other's plane."""
    parted = 0
    for half in range(2):
        first = 3 * half
        a = sides[first]
        if a != 0 and a != NOT_DECIDED and sides[first + 1] == a and sides[first + 2] == a:
            parted = 1
    return parted


@func
def edge_through(p: int, q: int, t: vec3i, side3: callback) -> int:
    """True if the line through p and q passes through t."""
    low = 1
    high = -1
    unsure = 0
    edges = int(3)
    for k in range(edges):
        sign = side3(p, q, t[k], t[(k + 1) % 3])
        if sign == NOT_DECIDED:
            unsure = 1
        low = min(low, sign)
        high = max(high, sign)
    result = int(NO_CONTACT)
    if unsure == 1:
        result = NOT_DECIDED
    elif low >= 0 or high <= 0:
        result = IN_CONTACT
    return result


@func
def edges_through(s: vec3i, t: vec3i, sides: six_signs, side3: callback) -> int:
    """True if an edge of one triangle that crosses or touches the other's plane meets the other triangle."""
    result = int(NO_CONTACT)
    edges = int(6)
    for k in range(edges):
        n = k // 3 * 3 + (k + 1) % 3
        if result != IN_CONTACT and sides[k] * sides[n] <= 0 and (sides[k] != 0 or sides[n] != 0):
            owner = t + vec3i(0, 0, 0)
            other = s + vec3i(0, 0, 0)
            if k >= 3:
                owner = s + vec3i(0, 0, 0)
                other = t + vec3i(0, 0, 0)
            edge_result = edge_through(owner[k % 3], owner[n % 3], other, side3)
            if edge_result != NO_CONTACT:
                result = edge_result
    return result


@func
def boxes_meet(vertices: array(dtype=vec3), p: int, q: int, a: int, b: int) -> int:
    meet = 1
    axes = int(3)
    for axis in range(axes):
        low = min(vertices[p][axis], vertices[q][axis])
        high = max(vertices[p][axis], vertices[q][axis])
        if low > max(vertices[a][axis], vertices[b][axis]) or high < min(vertices[a][axis], vertices[b][axis]):
            meet = 0
    return meet


@func
def edges_meet(vertices: array(dtype=vec3), p: int, q: int, a: int, b: int, side3: callback, side2: callback) -> int:
    result = int(NO_CONTACT)
    if boxes_meet(vertices, p, q, a, b) == 1:
        result = IN_CONTACT
        before = 0
        questions = int(12)  # along each axis, both ends' sides of the other edge, and vice versa
        for n in range(questions):
            if result != NO_CONTACT:
                k = n % 4
                sign = 0
                if k < 2:
                    sign = side2(n // 4, p, q, a if k == 0 else b)
                else:
                    sign = side2(n // 4, a, b, p if k == 2 else q)
                if sign == NOT_DECIDED:
                    result = NOT_DECIDED
                elif k % 2 == 1 and sign != 0 and sign == before:
                    result = NO_CONTACT
                before = sign
        if result != NO_CONTACT:
            twist = side3(p, q, a, b)
            if twist == NOT_DECIDED:
                result = NOT_DECIDED
            elif twist != 0:
                result = NO_CONTACT
    return result


@func
def contains(t: vec3i, p: int, side2: callback) -> int:
    """True if a triangle contains a point of its plane. NO_CONTACT if it is degenerate: its edges are tested too."""
    result = int(IN_CONTACT)
    has_area = 0
    low = 0
    high = 0
    questions = int(12)  # along each axis, the point's sides of the three edges, and the triangle's orientation
    for n in range(questions):
        k = n % 4
        sign = side2(n // 4, t[k % 3], t[(k + 1) % 3], p if k < 3 else t[2])
        if k == 0:
            low = 0
            high = 0
        if sign == NOT_DECIDED:
            if result == IN_CONTACT:
                result = NOT_DECIDED
            sign = 0
            has_area = has_area | (1 if k == 3 else 0)
        if k < 3:
            low = min(low, sign)
            high = max(high, sign)
        elif sign != 0:
            has_area = 1
        if low < 0 and high > 0:
            result = NO_CONTACT
    if has_area == 0:
        result = NO_CONTACT
    return result


@func
def meet_in_plane(vertices: array(dtype=vec3), s: vec3i, t: vec3i, side3: callback, side2: callback) -> int:
    result = int(NO_CONTACT)
    questions = int(11)
    for n in range(questions):
        if result != IN_CONTACT:
            part_result = int(NO_CONTACT)
            if n < 2:
                holder = s + vec3i(0, 0, 0)
                corner = t[0]
                if n == 1:
                    holder = t + vec3i(0, 0, 0)
                    corner = s[0]
                part_result = contains(holder, corner, side2)
            else:
                i = (n - 2) // 3
                j = (n - 2) % 3
                part_result = edges_meet(vertices, s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3], side3, side2)
            if part_result != NO_CONTACT:
                result = part_result
    return result


@func
def triangles_meet(vertices: array(dtype=vec3), s: vec3i, t: vec3i, side3: callback, side2: callback) -> int:
    """NO_CONTACT, IN_CONTACT or NOT_DECIDED."""
    result = int(NO_CONTACT)
    sides = plane_sides(s, t, side3)
    if are_parted(sides) == 0:
        flat = 0
        unsure = 0
        for k in range(6):
            flat += 1 if sides[k] == 0 else 0
            unsure += 1 if sides[k] == NOT_DECIDED else 0
        if unsure > 0:
            result = NOT_DECIDED
        elif flat == 6:
            result = meet_in_plane(vertices, s, t, side3, side2)
        else:
            result = edges_through(s, t, sides, side3)
    return result


PAIRS_PER_LAUNCH = 2**16  # pairs per exact-test launch: each thread needs scratch memory


@func
def lanes_touching(corners: array(dtype=float32), leaf: int, a: vec3, b: vec3) -> int:
    """Bit mask of a leaf's triangles whose boxes touch the box (a, b)."""
    mask = 0
    at = leaf * LEAF_NUMBERS
    for j in range(LEAF_SIZE):
        apart = 0.0
        for axis in range(3):
            x = corners[at + axis * LEAF_SIZE + j]
            y = corners[at + (3 + axis) * LEAF_SIZE + j]
            z = corners[at + (6 + axis) * LEAF_SIZE + j]
            apart = larger(apart, smaller(smaller(x, y), z) - b[axis])
            apart = larger(apart, a[axis] - larger(larger(x, y), z))
        mask = mask | ((1 << j) if apart <= 0.0 else 0)
    return mask


@func
def next_bucket_touching(step: traversal, a: vec3, b: vec3, tree: TriangleTree) -> traversal:
    """Advance to the next node of level 0 whose box touches the box (a, b)."""
    return next_step(step, tree.root, partial(level_children_within, tree.levels, 0, tree.boxes, a, b, 0.0))


@func
def share_vertex(s: vec3i, t: vec3i) -> int:
    shared = 0
    for k in range(3):
        if s[k] == t[0] or s[k] == t[1] or s[k] == t[2]:
            shared = 1
    return shared


@func
def same_position(p: vec3, q: vec3) -> int:
    return 1 if p[0] == q[0] and p[1] == q[1] and p[2] == q[2] else 0


@func
def classify_pair(vertices: array(dtype=vec3), s: vec3i, t: vec3i) -> int:
    """NO_CONTACT if a triangle is on one side of the other, IN_CONTACT if two corners coincide, else NOT_DECIDED."""
    same = 0
    pairs = int(9)
    for k in range(pairs):
        same += same_position(vertices[s[k // 3]], vertices[t[k % 3]])
    result = int(IN_CONTACT)
    if same == 0:
        result = NOT_DECIDED
        if are_parted(plane_sides(s, t, partial(side_of_plane, vertices))) == 1:
            result = NO_CONTACT
    return result


@func
def find_partners(
    i: int,
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    within: int,
    tree: TriangleTree,
    others: array(dtype=vec3i),
    first: int,
    partners: array(dtype=int32),
    results: array(dtype=uint8),
) -> int:
    """Count the triangles that meet triangle i or may, `within` one mesh higher ones. List them if `first` >= 0."""
    count = 0
    s = triangles[i]
    p = vertices[s[0]]
    q = vertices[s[1]]
    r = vertices[s[2]]
    if tree.count > 0 and isfinite(p) and isfinite(q) and isfinite(r):
        a = vec3(min(p[0], min(q[0], r[0])), min(p[1], min(q[1], r[1])), min(p[2], min(q[2], r[2])))
        b = vec3(max(p[0], max(q[0], r[0])), max(p[1], max(q[1], r[1])), max(p[2], max(q[2], r[2])))
        step = start_traversal(0)
        leaves = int(FAN)
        lanes = int(LEAF_SIZE)
        while int(step[0]) <= tree.root:
            bucket = int(step[2])
            distances = measure_boxes(tree.boxes, bucket, a, b)
            for j in range(leaves):
                if distances[j] <= 0.0:
                    leaf = bucket * FAN + j
                    touching = lanes_touching(tree.corners, leaf, a, b)
                    for lane in range(lanes):
                        index = leaf * LEAF_SIZE + lane
                        if ((touching >> lane) & 1) == 1 and index < tree.count:
                            other = tree.order[index]
                            t = others[other]
                            wanted = 1
                            if within == 1:
                                wanted = 1 if other > i and share_vertex(s, t) == 0 else 0
                            if wanted == 1:
                                result = classify_pair(vertices, s, t)
                                if result != NO_CONTACT:
                                    if first >= 0:
                                        partners[first + count] = other
                                        results[first + count] = uint8(result)
                                    count += 1
            step = next_bucket_touching(step, a, b, tree)
    return count


@kernel(max_registers=128)  # for two blocks per SM
def count_partners_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    within: int,
    tree: TriangleTree,
    others: array(dtype=vec3i),
    no_partners: array(dtype=int32),
    no_results: array(dtype=uint8),
    counts: array(dtype=int32),
):
    i = tid()
    counts[i] = find_partners(i, vertices, triangles, within, tree, others, -1, no_partners, no_results)


@kernel(max_registers=128)  # for two blocks per SM
def list_partners_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    within: int,
    tree: TriangleTree,
    others: array(dtype=vec3i),
    offsets: array(dtype=int32),
    owners: array(dtype=int32),
    partners: array(dtype=int32),
    results: array(dtype=uint8),
):
    i = tid()
    first = offsets[i]
    last = offsets[i + 1]
    if last > first:
        count = find_partners(i, vertices, triangles, within, tree, others, first, partners, results)
        for j in range(first, first + count):
            owners[j] = i
            # insertion sort: the tree's order differs
            partner = partners[j]
            result = results[j]
            k = j - 1
            while k >= first and partners[max(k, 0)] > partner:
                partners[k + 1] = partners[k]
                results[k + 1] = results[k]
                k -= 1
            partners[k + 1] = partner
            results[k + 1] = result


@kernel
def test_pairs_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    others: array(dtype=vec3i),
    owners: array(dtype=int32),
    partners: array(dtype=int32),
    results: array(dtype=uint8),
    is_meeting: array(dtype=uint8),
    is_open: array(dtype=uint8),
):
    """Test pairs in float64; flags for meeting and for undecided pairs."""
    i = tid()
    result = int(results[i])
    if result == NOT_DECIDED:
        s = triangles[owners[i]]
        t = others[partners[i]]
        result = triangles_meet(vertices, s, t, partial(side_of_plane, vertices), partial(side_of_line, vertices))
    is_meeting[i] = uint8(1 if result == IN_CONTACT else 0)
    is_open[i] = uint8(1 if result == NOT_DECIDED else 0)


@kernel
def resolve_pairs_kernel(
    rows: array(dtype=int32),
    triangles: array(dtype=vec3i),
    others: array(dtype=vec3i),
    owners: array(dtype=int32),
    partners: array(dtype=int32),
    given: ExactSides,
    is_meeting: array(dtype=uint8),
):
    i = tid()
    row = rows[i]
    s = triangles[owners[row]]
    t = others[partners[row]]
    result = triangles_meet(
        given.vertices, s, t, partial(exact_side_of_plane, i, given), partial(exact_side_of_line, i, given)
    )
    is_meeting[row] = uint8(1 if result == IN_CONTACT else 0)


def exact_sides(vertices: Points, lowest: np.ndarray, extremes: np.ndarray, threads: int) -> ExactSides:
    """ExactSides of the finite vertices, from the host values of `_about`."""
    unit, (low, high, _) = bit_of(lowest), box_of(extremes)
    sides = [Fraction(float(b)) - Fraction(float(a)) for a, b in zip(low, high, strict=True)]
    return ExactSides(vertices, unit, max(1, math.ceil(max(sides) / Fraction(2) ** unit)), threads)


def _about(vertices: Points) -> list[Integers]:
    return [find_lowest_bits(vertices), find_extremes(vertices)]


def find_meeting_pairs(
    tree: TriangleTree, vertices: Points, triangles: Triangles, others: Cells, *, within: bool
) -> tuple[Indices, Indices]:
    """Intersecting pairs (first, second), ascending. Two syncs, three if exact tests are needed. `within` one mesh
    without common vertices, lower number first. Raises ValueError for 2^31 pairs or more.
    """
    device, count = vertices.device, triangles.size
    search, counts = [vertices, triangles, int(within), tree, others], empty(count, int32, device)
    nowhere = [empty(1, int32, device), empty(1, uint8, device)]
    launch(count_partners_kernel, count, [*search, *nowhere, counts])
    offsets, total = exclusive_scan(counts, largest=tree.count)  # sync, of its triangles
    owners, partners = empty(total, int32, device), empty(total, int32, device)
    results = empty(total, uint8, device)
    if not total:
        return partners, owners
    launch(list_partners_kernel, count, [*search, offsets, owners, partners, results])
    is_meeting, is_open = empty(total, uint8, device), empty(total, uint8, device)
    pairs = [triangles, others, owners, partners]
    launch(test_pairs_kernel, total, [vertices, *pairs, results, is_meeting, is_open])
    beside = _about(vertices) if device.is_cuda else ()
    (rows, open_rows), about = positions_beside((is_meeting, is_open), beside)  # sync
    if open_rows.size:
        lowest, extremes = about or read_together(_about(vertices))
        given = exact_sides(vertices, lowest, extremes, min(open_rows.size, PAIRS_PER_LAUNCH))
        for first in range(0, open_rows.size, PAIRS_PER_LAUNCH):
            part = open_rows[first : min(first + PAIRS_PER_LAUNCH, open_rows.size)]
            launch(resolve_pairs_kernel, part.size, [part, *pairs, given, is_meeting])
        rows = positions_of(is_meeting)  # sync
    return gather_rows(owners, rows), gather_rows(partners, rows)


def meet_anywhere(tree: TriangleTree, vertices: Points, triangles: Triangles) -> bool:
    """True if two triangles of a mesh without a common vertex meet."""
    return find_meeting_pairs(tree, vertices, triangles, triangles, within=True)[0].size > 0
