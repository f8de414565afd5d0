"""Pairs of triangles that have a point in common, of one mesh or of two.

One thread a triangle walks the tree for the boxes that touch its own, and tests those triangles in float64; pairs that
this leaves open are tested again by exact arithmetic (triangle_sides.py). The pairs are counted first and then listed
by triangle. Within one mesh pairs that share a vertex are not tested, as in Open3D, whatever else they do.

Some 20 boxes of triangles touch each triangle's of a mesh, of which one or two need more than the first signs; 8 B
written a pair.
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
from ..lang import array, float32, func, int32, isfinite, kernel, launch, partial, tid, uint8, vec3, vec3i
from ..memory import empty
from ..search.bucket_walk import children_in_reach, next_step, start_walk, walk
from ..search.point_tree import FAN, measure_boxes
from .triangle_meeting import APART, MEETING, are_parted, plane_sides, triangles_meet
from .triangle_sides import UNSURE, ExactSides, exact_side_of_line, exact_side_of_plane, side_of_line, side_of_plane
from .triangle_tree import LEAF, LEAF_NUMBERS, TriangleTree

PART = 2**16  # pairs a launch that are tested exactly: each thread has scratch memory


@func
def lanes_touching(corners: array(dtype=float32), leaf: int, a: vec3, b: vec3) -> int:
    """A byte: bit j is set where the box of a leaf's triangle j touches the box (a, b)."""
    found = 0
    at = leaf * LEAF_NUMBERS
    for j in range(LEAF):
        apart = 0.0
        for axis in range(3):
            x = corners[at + axis * LEAF + j]
            y = corners[at + (3 + axis) * LEAF + j]
            z = corners[at + (6 + axis) * LEAF + j]
            apart = larger(apart, smaller(smaller(x, y), z) - b[axis])
            apart = larger(apart, a[axis] - larger(larger(x, y), z))
        found = found | ((1 << j) if apart <= 0.0 else 0)
    return found


@func
def next_bucket_touching(step: walk, a: vec3, b: vec3, tree: TriangleTree) -> walk:
    """Go on to the next node of level 0 whose box touches the box (a, b)."""
    return next_step(step, tree.root, partial(children_in_reach, tree.levels, 0, tree.boxes, a, b, 0.0))


@func
def share_vertex(s: vec3i, t: vec3i) -> int:
    """1 where two triangles have a vertex in common."""
    shared = 0
    for k in range(3):
        if s[k] == t[0] or s[k] == t[1] or s[k] == t[2]:
            shared = 1
    return shared


@func
def same_place(p: vec3, q: vec3) -> int:
    """1 where two points have the same coordinates."""
    return 1 if p[0] == q[0] and p[1] == q[1] and p[2] == q[2] else 0


@func
def look_at_pair(vertices: array(dtype=vec3), s: vec3i, t: vec3i) -> int:
    """APART where a triangle lies on one side of the other, MEETING where two corners lie at one place, else UNSURE."""
    same = 0
    pairs = int(9)
    for k in range(pairs):
        same += same_place(vertices[s[k // 3]], vertices[t[k % 3]])
    verdict = int(MEETING)
    if same == 0:
        verdict = UNSURE
        if are_parted(plane_sides(s, t, partial(side_of_plane, vertices))) == 1:
            verdict = APART
    return verdict


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
    verdicts: array(dtype=uint8),
) -> int:
    """How many triangles of a tree meet triangle i or may do so, listed from place `first` on, if that is >= 0.

    Where `within` is 1 the tree is that of the triangle's own mesh, and those of higher number count.
    """
    count = 0
    s = triangles[i]
    p = vertices[s[0]]
    q = vertices[s[1]]
    r = vertices[s[2]]
    if tree.count > 0 and isfinite(p) and isfinite(q) and isfinite(r):
        a = vec3(min(p[0], min(q[0], r[0])), min(p[1], min(q[1], r[1])), min(p[2], min(q[2], r[2])))
        b = vec3(max(p[0], max(q[0], r[0])), max(p[1], max(q[1], r[1])), max(p[2], max(q[2], r[2])))
        step = start_walk(0)
        leaves = int(FAN)
        lanes = int(LEAF)
        while int(step[0]) <= tree.root:
            bucket = int(step[2])
            distances = measure_boxes(tree.boxes, bucket, a, b)
            for j in range(leaves):
                if distances[j] <= 0.0:
                    leaf = bucket * FAN + j
                    touching = lanes_touching(tree.corners, leaf, a, b)
                    for lane in range(lanes):
                        place = leaf * LEAF + lane
                        if ((touching >> lane) & 1) == 1 and place < tree.count:
                            other = tree.order[place]
                            t = others[other]
                            wanted = 1
                            if within == 1:
                                wanted = 1 if other > i and share_vertex(s, t) == 0 else 0
                            if wanted == 1:
                                verdict = look_at_pair(vertices, s, t)
                                if verdict != APART:
                                    if first >= 0:
                                        partners[first + count] = other
                                        verdicts[first + count] = uint8(verdict)
                                    count += 1
            step = next_bucket_touching(step, a, b, tree)
    return count


@kernel(most_registers=128)  # two blocks of an SM, not one
def count_partners_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    within: int,
    tree: TriangleTree,
    others: array(dtype=vec3i),
    no_partners: array(dtype=int32),
    no_verdicts: array(dtype=uint8),
    counts: array(dtype=int32),
):
    """How many triangles each meets or may meet."""
    i = tid()
    counts[i] = find_partners(i, vertices, triangles, within, tree, others, -1, no_partners, no_verdicts)


@kernel(most_registers=128)  # two blocks of an SM, not one
def list_partners_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    within: int,
    tree: TriangleTree,
    others: array(dtype=vec3i),
    offsets: array(dtype=int32),
    owners: array(dtype=int32),
    partners: array(dtype=int32),
    verdicts: array(dtype=uint8),
):
    """The triangles that each meets or may meet, by number."""
    i = tid()
    first = offsets[i]
    last = offsets[i + 1]
    if last > first:
        found = find_partners(i, vertices, triangles, within, tree, others, first, partners, verdicts)
        for j in range(first, first + found):
            owners[j] = i
            # insertion: the tree's order is not that of the numbers
            partner = partners[j]
            verdict = verdicts[j]
            k = j - 1
            while k >= first and partners[max(k, 0)] > partner:
                partners[k + 1] = partners[k]
                verdicts[k + 1] = verdicts[k]
                k -= 1
            partners[k + 1] = partner
            verdicts[k + 1] = verdict


@kernel
def test_pairs_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    others: array(dtype=vec3i),
    owners: array(dtype=int32),
    partners: array(dtype=int32),
    verdicts: array(dtype=uint8),
    is_meeting: array(dtype=uint8),
    is_open: array(dtype=uint8),
):
    """Test pairs in float64; 1 where they meet, and where that does not tell."""
    i = tid()
    verdict = int(verdicts[i])
    if verdict == UNSURE:
        s = triangles[owners[i]]
        t = others[partners[i]]
        verdict = triangles_meet(vertices, s, t, partial(side_of_plane, vertices), partial(side_of_line, vertices))
    is_meeting[i] = uint8(1 if verdict == MEETING else 0)
    is_open[i] = uint8(1 if verdict == UNSURE else 0)


@kernel
def settle_pairs_kernel(
    rows: array(dtype=int32),
    triangles: array(dtype=vec3i),
    others: array(dtype=vec3i),
    owners: array(dtype=int32),
    partners: array(dtype=int32),
    given: ExactSides,
    is_meeting: array(dtype=uint8),
):
    """Test pairs exactly; 1 where they meet."""
    i = tid()
    row = rows[i]
    s = triangles[owners[row]]
    t = others[partners[row]]
    verdict = triangles_meet(
        given.vertices, s, t, partial(exact_side_of_plane, i, given), partial(exact_side_of_line, i, given)
    )
    is_meeting[row] = uint8(1 if verdict == MEETING else 0)


def exact_sides(vertices: Points, lowest: np.ndarray, extremes: np.ndarray, threads: int) -> ExactSides:
    """ExactSides of vertices, those that are not finite aside, of what the host has read about them: see `_about`."""
    unit, (low, high, _) = bit_of(lowest), box_of(extremes)
    sides = [Fraction(float(b)) - Fraction(float(a)) for a, b in zip(low, high, strict=True)]
    return ExactSides(vertices, unit, max(1, math.ceil(max(sides) / Fraction(2) ** unit)), threads)


def _about(vertices: Points) -> list[Integers]:
    """What exact sides begin with, on the device."""
    return [find_lowest_bits(vertices), find_extremes(vertices)]


def find_meeting_pairs(
    tree: TriangleTree, vertices: Points, triangles: Triangles, others: Cells, *, within: bool
) -> tuple[Indices, Indices]:
    """The pairs of triangles that have a point in common.

    Args:
        tree: A TriangleTree over `others`.
        vertices: Device array of vec3, of both meshes.
        triangles: Device array of vec3i.
        others: Device array of vec3i; the same array where `within` is set.
        within: One mesh: each pair once, lower number first, and none of triangles that share a vertex.

    Returns:
        (first, second): int32 device arrays, ascending.

    Raises:
        ValueError: 2^31 pairs or more.

    Two syncs; one more where float64 does not tell of all.
    """
    device, count = vertices.device, triangles.size
    search, counts = [vertices, triangles, int(within), tree, others], empty(count, int32, device)
    nowhere = [empty(1, int32, device), empty(1, uint8, device)]
    launch(count_partners_kernel, count, [*search, *nowhere, counts])
    offsets, total = exclusive_scan(counts)  # sync
    owners, partners = empty(total, int32, device), empty(total, int32, device)
    verdicts = empty(total, uint8, device)
    if not total:
        return partners, owners
    launch(list_partners_kernel, count, [*search, offsets, owners, partners, verdicts])
    is_meeting, is_open = empty(total, uint8, device), empty(total, uint8, device)
    pairs = [triangles, others, owners, partners]
    launch(test_pairs_kernel, total, [vertices, *pairs, verdicts, is_meeting, is_open])
    beside = _about(vertices) if device.is_cuda else ()
    (rows, open_rows), about = positions_beside((is_meeting, is_open), beside)  # sync
    if open_rows.size:
        lowest, extremes = about or read_together(_about(vertices))
        given = exact_sides(vertices, lowest, extremes, min(open_rows.size, PART))
        for first in range(0, open_rows.size, PART):
            part = open_rows[first : min(first + PART, open_rows.size)]
            launch(settle_pairs_kernel, part.size, [part, *pairs, given, is_meeting])
        rows = positions_of(is_meeting)  # sync
    return gather_rows(owners, rows), gather_rows(partners, rows)


def meet_anywhere(tree: TriangleTree, vertices: Points, triangles: Triangles) -> bool:
    """Whether two triangles of a mesh without a common vertex meet."""
    return find_meeting_pairs(tree, vertices, triangles, triangles, within=True)[0].size > 0
