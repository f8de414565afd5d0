"""Half-edges that have no partner yet, matched by the places of their ends: two at one place, more by angle.

Two at one place are a pair. Where more meet, they are put in order by angle about the edge, and the matching is that of
brackets: a triangle behind which there is solid, seen counter-clockwise, goes with the next that ends it, so that
solids which touch there stay two. Where as many begin as end, all are matched so; else those first that lie flattest to
each other, sheets that end nowhere else before the others. A triangle goes with its own opposite copy only where
nothing else is left.

One thread an edge. About 60 B a half-edge beside the sort.
"""

from ..algebra.angles import HALF_TURN, arctangent
from ..algebra.transform import widen
from ..array_types import Indices, Mask, Points, Triangles
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import positions
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    cross,
    dot,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    length,
    struct,
    tid,
    uint8,
    vec3,
    vec3i,
)
from ..memory import empty, full, zeros
from .mesh_edges import edge_key, key_bits
from .mesh_topology import corner_vertex, next_corner

SAME_ANGLE = 1.0e-5  # [rad]: what float32 leaves of the angle between two walls that lie on each other
MOST_TRIED = 64  # half-edges at one edge for which all pairs are tried
MATCHED, TENTATIVE = 1, 2  # how a half-edge got its partner, 0 where it has none


@func
def tip_of(triangles: array(dtype=vec3i), h: int) -> int:
    """The vertex of a half-edge's triangle that is not on it."""
    return corner_vertex(triangles, next_corner(next_corner(h)))


@kernel
def list_open_keys_kernel(
    placed: array(dtype=vec3i), rows: array(dtype=int32), bits: int, none: int64, keys: array(dtype=int64)
):
    """The places of the ends of open half-edges; `none` for those without length."""
    i = tid()
    h = rows[i]
    a = corner_vertex(placed, h)
    b = corner_vertex(placed, next_corner(h))
    keys[i] = edge_key(a, b, bits)
    if a == b:
        keys[i] = none


@struct
class OpenEdges:
    """Open half-edges by the places of their ends.

    Attributes:
        count: Edges e.
        starts: int32 [e + 1], where each edge's half-edges begin in `halves`.
        halves: int32 [n].
        angles: float64 [n], about the edge.
        ends: uint8 [n], 1 where the solid behind a triangle ends at it, counter-clockwise about the edge from its lower
            vertex.
        order: int32 [n], places of half-edges in the order of their angles, edge by edge.
        partners: int32 [n], the place of the one that each goes with, else -1.
        states: uint8 [n], MATCHED or TENTATIVE, 0 where there is none.
    """

    starts: array(dtype=int32)
    halves: array(dtype=int32)
    angles: array(dtype=float64)
    ends: array(dtype=uint8)
    order: array(dtype=int32)
    partners: array(dtype=int32)
    states: array(dtype=uint8)

    def __init__(self, placed: Triangles, vertex_count: int, is_open: Mask) -> None:
        rows, bits, device = positions_of(is_open), key_bits(vertex_count), placed.device  # sync
        none = (1 << (2 * bits)) - 1
        keys = empty(rows.size, int64, device)
        launch(list_open_keys_kernel, rows.size, [placed, rows, bits, none, keys])
        groups = UniqueKeys(keys, 2 * bits)  # sync
        groups.drop_last(none)  # sync
        self.count, n = groups.count, rows.size
        self.starts, self.halves = groups.starts, gather_rows(rows, groups.order)
        self.angles, self.order = zeros(n, float64, device), positions(n, device)
        self.ends = zeros(n, uint8, device)
        self.partners, self.states = full(n, -1, int32, device), zeros(n, uint8, device)


@kernel
def pair_two_kernel(open_edges: OpenEdges, twins: array(dtype=int32), natural: array(dtype=uint8)):
    """Pair two half-edges at one place; mark the triangles of those that are alone there."""
    i = tid()
    first = open_edges.starts[i]
    count = open_edges.starts[i + 1] - first
    h = open_edges.halves[first]
    if count == 1:
        natural[h // 3] = uint8(1)
    if count == 2:
        g = open_edges.halves[first + 1]
        twins[h] = g
        twins[g] = h


@func
def measure_angles(
    vertices: array(dtype=vec3),
    placed: array(dtype=vec3i),
    flips: array(dtype=uint8),
    open_edges: OpenEdges,
    first: int,
    last: int,
):
    """The angle of each triangle about its edge, from the first one there, the same bits at one place; its side."""
    g = open_edges.halves[first]
    c = corner_vertex(placed, g)
    d = corner_vertex(placed, next_corner(g))
    low = widen(vertices[min(c, d)])
    axis = widen(vertices[max(c, d)]) - low
    along = axis / length(axis)
    u = widen(vertices[tip_of(placed, g)]) - low
    u = u - along * dot(u, along)
    for i in range(first, last):
        h = open_edges.halves[i]
        v = widen(vertices[tip_of(placed, h)]) - low
        v = v - along * dot(v, along)
        angle = arctangent(dot(cross(u, v), along), dot(u, v))
        if angle < -float64(SAME_ANGLE):
            angle = angle + 2.0 * float64(HALF_TURN)
        open_edges.angles[i] = angle
        forward = 1 if corner_vertex(placed, h) < corner_vertex(placed, next_corner(h)) else 0
        open_edges.ends[i] = uint8(1 if forward != int(flips[h // 3]) else 0)


@func
def sort_by_angle(open_edges: OpenEdges, first: int, last: int):
    """Put the half-edges of one edge in order: by angle, and where angles are the same, those that end solid first."""
    for p in range(first + 1, last):
        q = p
        while q > first and open_edges.angles[open_edges.order[max(q - 1, 0)]] > open_edges.angles[p]:
            open_edges.order[q] = open_edges.order[q - 1]
            q -= 1
        open_edges.order[q] = p
    head = open_edges.angles[open_edges.order[first]]
    for p in range(first, last):
        slot = open_edges.order[p]
        if open_edges.angles[slot] - head <= float64(SAME_ANGLE):
            open_edges.angles[slot] = head
        head = open_edges.angles[slot]
    for p in range(first + 1, last):
        slot = open_edges.order[p]
        angle = open_edges.angles[slot]
        q = p
        going = int(open_edges.ends[slot])
        while q > first and going == 1:
            before = open_edges.order[q - 1]
            going = 0
            if open_edges.angles[before] == angle and open_edges.ends[before] == 0:
                open_edges.order[q] = before
                q -= 1
                going = 1
        open_edges.order[q] = slot


@func
def is_free(open_edges: OpenEdges, naturals: array(dtype=uint8), slot: int, tier: int) -> int:
    """1 where a half-edge has no partner yet and is of the tier: 0 for sheets that end nowhere else, 1 for all."""
    free = 0
    if open_edges.partners[slot] < 0:
        if tier == 1 or naturals[open_edges.halves[slot] // 3] == 0:
            free = 1
    return free


@func
def join_slots(open_edges: OpenEdges, s: int, e: int, state: int):
    """Make partners of two."""
    open_edges.partners[s] = e
    open_edges.partners[e] = s
    open_edges.states[s] = uint8(state)
    open_edges.states[e] = uint8(state)


@func
def match_brackets(
    placed: array(dtype=vec3i), open_edges: OpenEdges, naturals: array(dtype=uint8), first: int, last: int, tier: int
):
    """Match each beginning of solid with the next free one about the edge, where that ends it; until none is left."""
    n = last - first
    changed = 1
    while changed == 1:
        changed = 0
        for p in range(first, last):
            s = open_edges.order[p]
            h = open_edges.halves[s]
            if is_free(open_edges, naturals, s, tier) == 1 and open_edges.ends[s] == 0:
                tip = tip_of(placed, h)
                found = -1
                step = 1
                while step < n and found < 0:
                    e = open_edges.order[first + (p - first + step) % n]
                    if is_free(open_edges, naturals, e, tier) == 1:
                        found = e
                    step += 1
                if found >= 0:
                    g = open_edges.halves[found]
                    if tip_of(placed, g) != tip and open_edges.ends[found] != 0:
                        join_slots(open_edges, s, found, MATCHED)
                        changed = 1


@func
def match_flattest(
    placed: array(dtype=vec3i),
    open_edges: OpenEdges,
    naturals: array(dtype=uint8),
    first: int,
    last: int,
    tier: int,
    against: int,
):
    """Match the two free ones that lie flattest to each other, again and again.

    With `against` 1 those of opposite directions, with 0 those of one direction, tentatively, with 2 opposite copies.
    """
    found = 1
    while found == 1:
        found = 0
        s = -1
        e = -1
        least = 2.0 * float64(HALF_TURN)
        for p in range(first, last):
            x = open_edges.order[p]
            if is_free(open_edges, naturals, x, tier) == 1:
                for q in range(p + 1, last):
                    y = open_edges.order[q]
                    if is_free(open_edges, naturals, y, tier) == 1:
                        h = open_edges.halves[x]
                        g = open_edges.halves[y]
                        opposite = 0
                        if open_edges.ends[x] != open_edges.ends[y]:
                            opposite = 1
                        copies = 0
                        if tip_of(placed, h) == tip_of(placed, g):
                            copies = 1
                        bend = abs(abs(open_edges.angles[x] - open_edges.angles[y]) - float64(HALF_TURN))
                        fits = opposite == against and copies == 0
                        if against == 2:
                            fits = opposite == 1 and copies == 1
                        if fits and bend < least:
                            least = bend
                            s = x
                            e = y
                            found = 1
        if found == 1:
            join_slots(open_edges, s, e, TENTATIVE if against == 0 else MATCHED)


@kernel
def match_sheets_kernel(
    vertices: array(dtype=vec3),
    placed: array(dtype=vec3i),
    naturals: array(dtype=uint8),
    flips: array(dtype=uint8),
    rows: array(dtype=int32),
    open_edges: OpenEdges,
):
    """Find partners at an edge of three half-edges or more."""
    i = tid()
    first = open_edges.starts[rows[i]]
    last = open_edges.starts[rows[i] + 1]
    measure_angles(vertices, placed, flips, open_edges, first, last)
    sort_by_angle(open_edges, first, last)
    tiers = int(2)
    for tier in range(tiers):
        balance = 0
        for p in range(first, last):
            if is_free(open_edges, naturals, p, tier) == 1:
                balance += 2 * int(open_edges.ends[p]) - 1
        if balance == 0 or last - first > MOST_TRIED:
            match_brackets(placed, open_edges, naturals, first, last, tier)
        if last - first <= MOST_TRIED:
            match_flattest(placed, open_edges, naturals, first, last, tier, 1)
    if last - first <= MOST_TRIED:
        match_flattest(placed, open_edges, naturals, first, last, 1, 0)
        match_flattest(placed, open_edges, naturals, first, last, 1, 2)


@kernel
def write_twins_kernel(
    open_edges: OpenEdges, twins: array(dtype=int32), tentative: array(dtype=uint8), crowding: array(dtype=uint8)
):
    """The twin of each half-edge that found a partner; marks those found tentatively, and those that found none."""
    i = tid()
    first = open_edges.starts[i]
    last = open_edges.starts[i + 1]
    if last - first > 2:
        for p in range(first, last):
            h = open_edges.halves[p]
            if open_edges.partners[p] >= 0:
                twins[h] = open_edges.halves[open_edges.partners[p]]
                if int(open_edges.states[p]) == TENTATIVE:
                    tentative[h] = uint8(1)
            else:
                crowding[h // 3] = uint8(1)


@kernel
def mask_crowded_runs_kernel(starts: array(dtype=int32), mask: array(dtype=uint8)):
    """1 for the edges of more than two."""
    i = tid()
    mask[i] = uint8(1 if starts[i + 1] - starts[i] > 2 else 0)


def match_by_angle(
    open_edges: OpenEdges, vertices: Points, placed: Triangles, rows: Indices, naturals: Mask, flips: Mask
) -> None:
    """Find partners at the edges of three half-edges or more.

    Args:
        open_edges: All open half-edges.
        vertices, placed: The mesh, by the first vertex at each position.
        rows: Those edges.
        naturals: uint8 [t], 1 for triangles of sheets that end somewhere else.
        flips: uint8 [t], 1 for triangles that count as wound the other way.
    """
    launch(match_sheets_kernel, rows.size, [vertices, placed, naturals, flips, rows, open_edges])


def crowded_rows(open_edges: OpenEdges) -> Indices:
    """The edges of three half-edges or more; one sync."""
    crowded = empty(open_edges.count, uint8, open_edges.starts.device)
    launch(mask_crowded_runs_kernel, open_edges.count, [open_edges.starts, crowded])
    return positions_of(crowded)  # sync
