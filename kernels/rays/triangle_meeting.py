"""Whether two triangles have a point in common, corners and edges included, by signs alone.

Two triangles meet where an edge of one meets the other one (Guigue and Devillers, "Fast and robust triangle-triangle
overlap test using orientation predicates", 2003, has the same signs). In one plane they meet where two edges do, or
where one holds a corner of the other; that is asked in the projections along all three axes, since one of them at
least tells the plane's points apart. Triangles without area count as the edges that they are.

The signs come from `side3(i, j, k, p)` and `side2(axis, i, j, p)` of vertex numbers (triangle_sides.py); where one of
them is unsure, so is the answer. Each is called in one loop for all that is asked: compilers write every call out.
"""

from ..lang import array, callback, func, int32, vec3, vec3i, vector
from .triangle_sides import UNSURE

APART, MEETING = 0, 1  # and UNSURE
six_signs = vector(6, int32)


@func
def plane_sides(s: vec3i, t: vec3i, side3: callback) -> six_signs:
    """The sides of the corners of t of the plane of s, and those of the corners of s of the plane of t."""
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
    """1 where one triangle lies on one side of the other's plane."""
    parted = 0
    for half in range(2):
        first = 3 * half
        a = sides[first]
        if a != 0 and a != UNSURE and sides[first + 1] == a and sides[first + 2] == a:
            parted = 1
    return parted


@func
def edge_through(p: int, q: int, t: vec3i, side3: callback) -> int:
    """Whether the line through p and q passes through t."""
    low = 1
    high = -1
    unsure = 0
    edges = int(3)
    for k in range(edges):
        sign = side3(p, q, t[k], t[(k + 1) % 3])
        if sign == UNSURE:
            unsure = 1
        low = min(low, sign)
        high = max(high, sign)
    verdict = int(APART)
    if unsure == 1:
        verdict = UNSURE
    elif low >= 0 or high <= 0:
        verdict = MEETING
    return verdict


@func
def edges_through(s: vec3i, t: vec3i, sides: six_signs, side3: callback) -> int:
    """Whether an edge of one triangle with its ends on two sides of the other's plane, or one end in it, meets that."""
    verdict = int(APART)
    edges = int(6)
    for k in range(edges):
        n = k // 3 * 3 + (k + 1) % 3
        if verdict != MEETING and sides[k] * sides[n] <= 0 and (sides[k] != 0 or sides[n] != 0):
            owner = t + vec3i(0, 0, 0)
            other = s + vec3i(0, 0, 0)
            if k >= 3:
                owner = s + vec3i(0, 0, 0)
                other = t + vec3i(0, 0, 0)
            found = edge_through(owner[k % 3], owner[n % 3], other, side3)
            if found != APART:
                verdict = found
    return verdict


@func
def boxes_meet(vertices: array(dtype=vec3), p: int, q: int, a: int, b: int) -> int:
    """1 where the boxes of two edges touch."""
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
    """Whether the edges p q and a b have a point in common."""
    verdict = int(APART)
    if boxes_meet(vertices, p, q, a, b) == 1:
        verdict = MEETING
        before = 0
        questions = int(12)  # along each axis, the ends of the one on the sides of the other, and the other way round
        for n in range(questions):
            if verdict != APART:
                k = n % 4
                sign = 0
                if k < 2:
                    sign = side2(n // 4, p, q, a if k == 0 else b)
                else:
                    sign = side2(n // 4, a, b, p if k == 2 else q)
                if sign == UNSURE:
                    verdict = UNSURE
                elif k % 2 == 1 and sign != 0 and sign == before:
                    verdict = APART
                before = sign
        if verdict != APART:
            twist = side3(p, q, a, b)
            if twist == UNSURE:
                verdict = UNSURE
            elif twist != 0:
                verdict = APART
    return verdict


@func
def holds(t: vec3i, p: int, side2: callback) -> int:
    """Whether a triangle holds a point of its plane; APART where it has no area, for its edges are asked too."""
    verdict = int(MEETING)
    has_area = 0
    low = 0
    high = 0
    questions = int(12)  # along each axis, the point's sides of the three edges, and the triangle's own
    for n in range(questions):
        k = n % 4
        sign = side2(n // 4, t[k % 3], t[(k + 1) % 3], p if k < 3 else t[2])
        if k == 0:
            low = 0
            high = 0
        if sign == UNSURE:
            if verdict == MEETING:
                verdict = UNSURE
            sign = 0
            has_area = has_area | (1 if k == 3 else 0)
        if k < 3:
            low = min(low, sign)
            high = max(high, sign)
        elif sign != 0:
            has_area = 1
        if low < 0 and high > 0:
            verdict = APART
    if has_area == 0:
        verdict = APART
    return verdict


@func
def meet_in_plane(vertices: array(dtype=vec3), s: vec3i, t: vec3i, side3: callback, side2: callback) -> int:
    """Whether two triangles of one plane meet."""
    verdict = int(APART)
    questions = int(11)
    for n in range(questions):
        if verdict != MEETING:
            found = int(APART)
            if n < 2:
                holder = s + vec3i(0, 0, 0)
                corner = t[0]
                if n == 1:
                    holder = t + vec3i(0, 0, 0)
                    corner = s[0]
                found = holds(holder, corner, side2)
            else:
                i = (n - 2) // 3
                j = (n - 2) % 3
                found = edges_meet(vertices, s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3], side3, side2)
            if found != APART:
                verdict = found
    return verdict


@func
def triangles_meet(vertices: array(dtype=vec3), s: vec3i, t: vec3i, side3: callback, side2: callback) -> int:
    """Whether two triangles have a point in common: APART, MEETING, or UNSURE."""
    verdict = int(APART)
    sides = plane_sides(s, t, side3)
    if are_parted(sides) == 0:
        flat = 0
        unsure = 0
        for k in range(6):
            flat += 1 if sides[k] == 0 else 0
            unsure += 1 if sides[k] == UNSURE else 0
        if unsure > 0:
            verdict = UNSURE
        elif flat == 6:
            verdict = meet_in_plane(vertices, s, t, side3, side2)
        else:
            verdict = edges_through(s, t, sides, side3)
    return verdict
