"""Manifold sheets of a mesh: non-manifold edges are cut, and half-edges are stitched again in pairs.

After Guéziec, Taubin, Lazarus and Horn, "Cutting and stitching: converting sets of polygons to manifold surfaces", IEEE
TVCG 7(2), 2001. Two half-edges alone on an edge are a pair. All others are matched by the positions of their ends. If
more than two meet, they are sorted by angle around the edge and matched like brackets around solids, so that touching
solids stay separate. Otherwise the flattest pairs match first, complete sheets before others. A triangle matches its
own opposite copy last. Same-direction pairs at crowded edges are kept only if their component stays two-sided. About
100 B per half-edge.
"""

from ..algebra.angles import PI, arctangent
from ..algebra.transform import widen
from ..array_types import Indices, Integers, Mask, Points, Triangles
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    compute,
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
from .mesh_edges import corner_at, edge_key, find_edges, key_bits
from .mesh_measures import measure
from .mesh_topology import corner_vertex, next_corner
from .part_votes import follow_majority

SAME_ANGLE = 1.0e-5  # [rad]: float32 resolution of the angle between coincident walls
MAX_TRIED = 64  # half-edges at one edge for which all pairs are tried
MATCHED_PAIR, TENTATIVE_PAIR = 1, 2  # how a half-edge was matched, 0 if it was not


@func
def tip_of(triangles: array(dtype=vec3i), h: int) -> int:
    return corner_vertex(triangles, next_corner(next_corner(h)))


@kernel
def list_open_keys_kernel(
    welded: array(dtype=vec3i), rows: array(dtype=int32), bits: int, none: int64, keys: array(dtype=int64)
):
    i = tid()
    h = rows[i]
    a = corner_vertex(welded, h)
    b = corner_vertex(welded, next_corner(h))
    keys[i] = edge_key(a, b, bits)
    if a == b:
        keys[i] = none


@struct
class OpenEdges:
    """Open half-edges by the positions of their ends. `ends` is 1 if the solid behind a triangle ends at it,
    counter-clockwise around the edge from its lower vertex. `order` sorts each edge by angle; `partners` are -1 if
    unmatched; `states` are MATCHED, TENTATIVE or 0."""

    starts: array(dtype=int32)
    half_edges: array(dtype=int32)
    angles: array(dtype=float64)
    ends: array(dtype=uint8)
    order: array(dtype=int32)
    partners: array(dtype=int32)
    states: array(dtype=uint8)

    def __init__(self, welded: Triangles, vertex_count: int, is_open: Mask) -> None:
        rows, bits, device = positions_of(is_open), key_bits(vertex_count), welded.device  # sync
        none = (1 << (2 * bits)) - 1
        keys = compute(list_open_keys_kernel, rows.size, [welded, rows, bits, none], int64, device)
        groups = UniqueKeys(keys, 2 * bits)  # sync
        groups.drop_last(none)  # sync
        self.count, n = groups.count, rows.size
        self.starts, self.half_edges = groups.starts, gather_rows(rows, groups.order)
        self.angles, self.order = zeros(n, float64, device), positions(n, device)
        self.ends = zeros(n, uint8, device)
        self.partners, self.states = full(n, -1, int32, device), zeros(n, uint8, device)


@kernel
def pair_two_kernel(open_edges: OpenEdges, twins: array(dtype=int32), natural: array(dtype=uint8)):
    """Pair two half-edges at one position. Mark triangles of single ones."""
    i = tid()
    first = open_edges.starts[i]
    count = open_edges.starts[i + 1] - first
    h = open_edges.half_edges[first]
    if count == 1:
        natural[h // 3] = uint8(1)
    if count == 2:
        g = open_edges.half_edges[first + 1]
        twins[h] = g
        twins[g] = h


@func
def measure_angles(
    vertices: array(dtype=vec3),
    welded: array(dtype=vec3i),
    flips: array(dtype=uint8),
    open_edges: OpenEdges,
    first: int,
    last: int,
):
    """Angle of each triangle around its edge relative to the first, equal at equal positions, and its side."""
    g = open_edges.half_edges[first]
    c = corner_vertex(welded, g)
    d = corner_vertex(welded, next_corner(g))
    low = widen(vertices[min(c, d)])
    axis = widen(vertices[max(c, d)]) - low
    along = axis / length(axis)
    u = widen(vertices[tip_of(welded, g)]) - low
    u = u - along * dot(u, along)
    for i in range(first, last):
        h = open_edges.half_edges[i]
        v = widen(vertices[tip_of(welded, h)]) - low
        v = v - along * dot(v, along)
        angle = arctangent(dot(cross(u, v), along), dot(u, v))
        if angle < -float64(SAME_ANGLE):
            angle = angle + 2.0 * float64(PI)
        open_edges.angles[i] = angle
        forward = 1 if corner_vertex(welded, h) < corner_vertex(welded, next_corner(h)) else 0
        open_edges.ends[i] = uint8(1 if forward != int(flips[h // 3]) else 0)


@func
def sort_by_angle(open_edges: OpenEdges, first: int, last: int):
    """Sort the half-edges of an edge by angle. On ties, those that end a solid come first."""
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
    """1 for an unmatched half-edge of the tier: 0 for sheets without other open ends, 1 for all."""
    free = 0
    if open_edges.partners[slot] < 0:
        if tier == 1 or naturals[open_edges.half_edges[slot] // 3] == 0:
            free = 1
    return free


@func
def join_slots(open_edges: OpenEdges, s: int, e: int, state: int):
    open_edges.partners[s] = e
    open_edges.partners[e] = s
    open_edges.states[s] = uint8(state)
    open_edges.states[e] = uint8(state)


@func
def match_brackets(
    welded: array(dtype=vec3i), open_edges: OpenEdges, naturals: array(dtype=uint8), first: int, last: int, tier: int
):
    """Match each start of a solid with the next free half-edge if that ends it, repeatedly."""
    n = last - first
    changed = 1
    while changed == 1:
        changed = 0
        for p in range(first, last):
            s = open_edges.order[p]
            h = open_edges.half_edges[s]
            if is_free(open_edges, naturals, s, tier) == 1 and open_edges.ends[s] == 0:
                tip = tip_of(welded, h)
                partner = -1
                step = 1
                while step < n and partner < 0:
                    e = open_edges.order[first + (p - first + step) % n]
                    if is_free(open_edges, naturals, e, tier) == 1:
                        partner = e
                    step += 1
                if partner >= 0:
                    g = open_edges.half_edges[partner]
                    if tip_of(welded, g) != tip and open_edges.ends[partner] != 0:
                        join_slots(open_edges, s, partner, MATCHED_PAIR)
                        changed = 1


@func
def match_flattest(
    welded: array(dtype=vec3i),
    open_edges: OpenEdges,
    naturals: array(dtype=uint8),
    first: int,
    last: int,
    tier: int,
    against: int,
):
    """Match the two free half-edges that are flattest to each other, repeatedly. `against`: 1 for opposite directions,
    0 for one direction (tentative), 2 for opposite copies."""
    matched = 1
    while matched == 1:
        matched = 0
        s = -1
        e = -1
        min_bend = 2.0 * float64(PI)
        for p in range(first, last):
            x = open_edges.order[p]
            if is_free(open_edges, naturals, x, tier) == 1:
                for q in range(p + 1, last):
                    y = open_edges.order[q]
                    if is_free(open_edges, naturals, y, tier) == 1:
                        h = open_edges.half_edges[x]
                        g = open_edges.half_edges[y]
                        opposite = 0
                        if open_edges.ends[x] != open_edges.ends[y]:
                            opposite = 1
                        copies = 0
                        if tip_of(welded, h) == tip_of(welded, g):
                            copies = 1
                        bend = abs(abs(open_edges.angles[x] - open_edges.angles[y]) - float64(PI))
                        fits = opposite == against and copies == 0
                        if against == 2:
                            fits = opposite == 1 and copies == 1
                        if fits and bend < min_bend:
                            min_bend = bend
                            s = x
                            e = y
                            matched = 1
        if matched == 1:
            join_slots(open_edges, s, e, TENTATIVE_PAIR if against == 0 else MATCHED_PAIR)


@kernel
def match_sheets_kernel(
    vertices: array(dtype=vec3),
    welded: array(dtype=vec3i),
    naturals: array(dtype=uint8),
    flips: array(dtype=uint8),
    rows: array(dtype=int32),
    open_edges: OpenEdges,
):
    i = tid()
    first = open_edges.starts[rows[i]]
    last = open_edges.starts[rows[i] + 1]
    measure_angles(vertices, welded, flips, open_edges, first, last)
    sort_by_angle(open_edges, first, last)
    tiers = int(2)
    for tier in range(tiers):
        balance = 0
        for p in range(first, last):
            if is_free(open_edges, naturals, p, tier) == 1:
                balance += 2 * int(open_edges.ends[p]) - 1
        if balance == 0 or last - first > MAX_TRIED:
            match_brackets(welded, open_edges, naturals, first, last, tier)
        if last - first <= MAX_TRIED:
            match_flattest(welded, open_edges, naturals, first, last, tier, 1)
    if last - first <= MAX_TRIED:
        match_flattest(welded, open_edges, naturals, first, last, 1, 0)
        match_flattest(welded, open_edges, naturals, first, last, 1, 2)


@kernel
def write_twins_kernel(
    open_edges: OpenEdges, twins: array(dtype=int32), tentative: array(dtype=uint8), crowding: array(dtype=uint8)
):
    i = tid()
    first = open_edges.starts[i]
    last = open_edges.starts[i + 1]
    if last - first > 2:
        for p in range(first, last):
            h = open_edges.half_edges[p]
            if open_edges.partners[p] >= 0:
                twins[h] = open_edges.half_edges[open_edges.partners[p]]
                if int(open_edges.states[p]) == TENTATIVE_PAIR:
                    tentative[h] = uint8(1)
            else:
                crowding[h // 3] = uint8(1)


@kernel
def mask_crowded_runs_kernel(starts: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    mask[i] = uint8(1 if starts[i + 1] - starts[i] > 2 else 0)


def match_by_angle(
    open_edges: OpenEdges, vertices: Points, welded: Triangles, rows: Indices, naturals: Mask, flips: Mask
) -> None:
    """Find partners at edges `rows`. `naturals` marks triangles of sheets that end elsewhere, `flips` flipped ones."""
    launch(match_sheets_kernel, rows.size, [vertices, welded, naturals, flips, rows, open_edges])


def crowded_rows(open_edges: OpenEdges) -> Indices:
    crowded = compute(mask_crowded_runs_kernel, open_edges.count, [open_edges.starts], uint8, open_edges.starts.device)
    return positions_of(crowded)  # sync


MIN_VOLUME_RATIO = 1.0e-6  # of its area to the power of 1.5: with less volume the orientation is undefined


@kernel
def mark_unsound_kernel(triangles: array(dtype=vec3i), edges: UniqueKeys, unsound: array(dtype=uint8)):
    """1 for triangles at edges without two consistent ones, and alone with their copy. Same value by all threads."""
    i = tid()
    first = edges.starts[i]
    last = edges.starts[i + 1]
    sound = 0
    if last - first == 2:
        h = edges.order[first]
        g = edges.order[first + 1]
        other = corner_vertex(triangles, g)
        tip = tip_of(triangles, g)
        if corner_vertex(triangles, h) != other and h // 3 != g // 3:
            if tip_of(triangles, h) != tip:
                sound = 1
    if sound == 0:
        for j in range(first, last):
            unsound[edges.order[j] // 3] = uint8(1)


@kernel
def unite_runs_kernel(edges: UniqueKeys, parents: array(dtype=int32)):
    i = tid()
    first = edges.starts[i]
    for j in range(first + 1, edges.starts[i + 1]):
        unite(parents, edges.order[first] // 3, edges.order[j] // 3)


@kernel
def mark_roots_kernel(parents: array(dtype=int32), marks: array(dtype=uint8), of_part: array(dtype=uint8)):
    """1 at the first triangle of a component with a marked one. All threads write the same value."""
    i = tid()
    if marks[i] != 0:
        of_part[parents[i]] = uint8(1)


@kernel
def spread_marks_kernel(parents: array(dtype=int32), of_part: array(dtype=uint8), marks: array(dtype=uint8)):
    i = tid()
    marks[i] = of_part[parents[i]]


@kernel
def pair_given_kernel(
    welded: array(dtype=vec3i),
    edges: UniqueKeys,
    loose: array(dtype=uint8),
    twins: array(dtype=int32),
    is_open: array(dtype=uint8),
):
    """Pair the half-edges alone on an edge. Mark the others, and those of a loose triangle and its copy."""
    i = tid()
    first = edges.starts[i]
    last = edges.starts[i + 1]
    paired = 0
    if last - first == 2:
        h = edges.order[first]
        g = edges.order[first + 1]
        if h // 3 != g // 3:
            paired = 1
            other = tip_of(welded, g)
            if tip_of(welded, h) == other and loose[h // 3] != 0:
                paired = 0
            if paired == 1:
                twins[h] = g
                twins[g] = h
    if paired == 0:
        for j in range(first, last):
            is_open[edges.order[j]] = uint8(1)


@kernel
def unite_twins_kernel(twins: array(dtype=int32), parents: array(dtype=int32)):
    i = tid()
    if twins[i] > i:
        unite(parents, i // 3, twins[i] // 3)


@kernel
def unite_forms_of_twins_kernel(welded: array(dtype=vec3i), twins: array(dtype=int32), parents: array(dtype=int32)):
    """Unite original and flipped forms of triangles that pairs orient consistently."""
    i = tid()
    g = twins[i]
    if g > i:
        against = 0
        if corner_vertex(welded, i) == corner_vertex(welded, g):
            against = 1
        unite(parents, 2 * (i // 3), 2 * (g // 3) + against)
        unite(parents, 2 * (i // 3) + 1, 2 * (g // 3) + 1 - against)


@kernel
def part_tentative_kernel(parents: array(dtype=int32), tentative: array(dtype=uint8), twins: array(dtype=int32)):
    i = tid()
    t = i // 3
    if tentative[i] != 0 and parents[2 * t] == parents[2 * t + 1]:
        twins[i] = -1


@kernel
def part_copies_kernel(
    welded: array(dtype=vec3i), chosen: array(dtype=uint8), twins: array(dtype=int32), parted: array(dtype=int32)
):
    """Remove pairs of a selected triangle and its own copy."""
    i = tid()
    g = twins[i]
    if g >= 0:
        other = tip_of(welded, g)
        if tip_of(welded, i) == other and chosen[i // 3] != 0:
            g = -1
    parted[i] = g


def mask_loose(triangles: Triangles, vertex_count: int) -> Mask:
    """uint8 [t]: 0 for triangles of closed, consistently oriented components, else 1."""
    device, count = triangles.device, triangles.size
    edges = find_edges(triangles, vertex_count, padded=True)
    unsound, of_part, parents = zeros(count, uint8, device), zeros(count, uint8, device), positions(count, device)
    launch(mark_unsound_kernel, edges.count, [triangles, edges, unsound])
    launch(unite_runs_kernel, edges.count, [edges, parents])
    launch(flatten_sets_kernel, count, [parents])
    launch(mark_roots_kernel, count, [parents, unsound, of_part])
    return compute(spread_marks_kernel, count, [parents, of_part], uint8, device)


@kernel
def read_flips_kernel(forms: array(dtype=int32), flips: array(dtype=uint8)):
    i = tid()
    flips[i] = uint8(forms[2 * i] % 2)


def _winding(forms: Indices, parents: Indices, inwards: bool) -> Mask:
    """uint8 [t]: 1 for triangles oriented against most of their component; inverted with `inwards`."""
    flips = compute(read_flips_kernel, parents.size, [forms], uint8, parents.device)
    follow_majority(parents, flips, inwards)
    return flips


class Sheets:
    """Pairs of half-edges that form the sheets of a mesh. `welded` are the triangles by the first vertex at each
    position; `loose` is 0 for closed, consistently oriented components. `twins` int32 [3 t] (-1 if unpaired);
    `crowding` marks triangles unpaired at a crowded edge. `had_choice`: True if there is one."""

    def __init__(self, vertices: Points, triangles: Triangles, welded: Triangles, loose: Mask) -> None:
        device, count, vertex_count = triangles.device, triangles.size, vertices.size
        self._welded, half_edges = welded, 3 * count
        self.twins, self.crowding = full(half_edges, -1, int32, device), zeros(count, uint8, device)
        is_open, edges = zeros(half_edges, uint8, device), find_edges(triangles, vertex_count, padded=True)
        launch(pair_given_kernel, edges.count, [welded, edges, loose, self.twins, is_open])
        open_edges = OpenEdges(welded, vertex_count, is_open)
        natural = zeros(count, uint8, device)
        launch(pair_two_kernel, open_edges.count, [open_edges, self.twins, natural])
        rows = crowded_rows(open_edges)  # sync
        self.had_choice = rows.size > 0
        if self.had_choice:
            self._match(vertices, open_edges, rows, natural)

    def _match(self, vertices: Points, open_edges: OpenEdges, rows: Indices, natural: Mask) -> None:
        welded, count, device = self._welded, self._welded.size, self._welded.device
        parents = self.parts()
        ends, naturals = zeros(count, uint8, device), empty(count, uint8, device)
        launch(mark_roots_kernel, count, [parents, natural, ends])
        launch(spread_marks_kernel, count, [parents, ends, naturals])
        area, volume = measure(vertices, welded)  # sync
        flips = _winding(self._forms(), parents, volume < -MIN_VOLUME_RATIO * area**1.5)
        match_by_angle(open_edges, vertices, welded, rows, naturals, flips)
        tentative = zeros(3 * count, uint8, device)
        launch(write_twins_kernel, open_edges.count, [open_edges, self.twins, tentative, self.crowding])
        launch(part_tentative_kernel, 3 * count, [self._forms(), tentative, self.twins])

    def _forms(self) -> Indices:
        """Sets of original (2 t) and flipped (2 t + 1) triangles that pairs make consistent."""
        forms = positions(2 * self._welded.size, self._welded.device)
        launch(unite_forms_of_twins_kernel, self.twins.size, [self._welded, self.twins, forms])
        launch(flatten_sets_kernel, forms.size, [forms])
        return forms

    def parts(self) -> Indices:
        """First triangle of each one's pair-connected component, int32 [t]."""
        parents = positions(self._welded.size, self._welded.device)
        launch(unite_twins_kernel, self.twins.size, [self.twins, parents])
        launch(flatten_sets_kernel, parents.size, [parents])
        return parents

    def part_copies(self, chosen: Mask) -> None:
        """Separate pairs of selected triangles (uint8 [t]) and their opposite copies."""
        parted = empty(self.twins.size, int32, self.twins.device)
        launch(part_copies_kernel, self.twins.size, [self._welded, chosen, self.twins, parted])
        self.twins = parted

    def corner_sets(self) -> Integers:
        """Lowest corner of each vertex formed by pairs, int32 [3 t]."""
        parents = positions(self.twins.size, self.twins.device)
        launch(unite_corners_of_twins_kernel, self.twins.size, [self._welded, self.twins, parents])
        launch(flatten_sets_kernel, parents.size, [parents])
        return parents


@kernel
def unite_corners_of_twins_kernel(welded: array(dtype=vec3i), twins: array(dtype=int32), parents: array(dtype=int32)):
    i = tid()
    g = twins[i]
    if g > i:
        a = corner_vertex(welded, i)
        b = corner_vertex(welded, next_corner(i))
        unite(parents, corner_at(welded, i, a), corner_at(welded, g, a))
        unite(parents, corner_at(welded, i, b), corner_at(welded, g, b))
