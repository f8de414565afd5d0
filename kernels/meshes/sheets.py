"""Which half-edges of a mesh are two sides of one sheet: cut where more than two meet, and stitched again in pairs.

After Guéziec, Taubin, Lazarus and Horn, "Cutting and stitching: converting sets of polygons to manifold surfaces", IEEE
TVCG 7(2), 2001. Two half-edges are a pair where they alone have an edge between two vertices. All others are open, and
matched by the positions of their ends (open_edges.py). Pairs of two that run the same way at an edge of more are kept
only where they leave their part two sides. About 40 B a half-edge beside the sorts.
"""

from ..array_types import Indices, Integers, Mask, Points, Triangles
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..arrays.unique import UniqueKeys
from ..lang import array, int32, kernel, launch, tid, uint8, vec3i
from ..memory import empty, full, zeros
from .mesh_edges import corner_at, find_edges
from .mesh_measures import measure
from .mesh_topology import corner_vertex, next_corner
from .open_edges import OpenEdges, crowded_rows, match_by_angle, pair_two_kernel, tip_of, write_twins_kernel
from .part_votes import follow_most

FLAT = 1.0e-6  # of its area to the power of 1.5: with less volume a mesh looks neither way


@kernel
def mark_unsound_kernel(triangles: array(dtype=vec3i), edges: UniqueKeys, unsound: array(dtype=uint8)):
    """1 for triangles at an edge that is not one of two which turn alike, and for a triangle and its other side alone.

    All threads write the same.
    """
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
    """Make one set of the triangles at each edge."""
    i = tid()
    first = edges.starts[i]
    for j in range(first + 1, edges.starts[i + 1]):
        unite(parents, edges.order[first] // 3, edges.order[j] // 3)


@kernel
def mark_roots_kernel(parents: array(dtype=int32), marks: array(dtype=uint8), of_part: array(dtype=uint8)):
    """1 at the first triangle of a part with a marked one; all threads write the same."""
    i = tid()
    if marks[i] != 0:
        of_part[parents[i]] = uint8(1)


@kernel
def spread_marks_kernel(parents: array(dtype=int32), of_part: array(dtype=uint8), marks: array(dtype=uint8)):
    """The mark of each triangle's part."""
    i = tid()
    marks[i] = of_part[parents[i]]


@kernel
def pair_given_kernel(
    placed: array(dtype=vec3i),
    edges: UniqueKeys,
    loose: array(dtype=uint8),
    twins: array(dtype=int32),
    is_open: array(dtype=uint8),
):
    """Pair the two half-edges that an edge has alone; mark the others, and those of a loose triangle and its copy."""
    i = tid()
    first = edges.starts[i]
    last = edges.starts[i + 1]
    paired = 0
    if last - first == 2:
        h = edges.order[first]
        g = edges.order[first + 1]
        if h // 3 != g // 3:
            paired = 1
            other = tip_of(placed, g)
            if tip_of(placed, h) == other and loose[h // 3] != 0:
                paired = 0
            if paired == 1:
                twins[h] = g
                twins[g] = h
    if paired == 0:
        for j in range(first, last):
            is_open[edges.order[j]] = uint8(1)


@kernel
def unite_twins_kernel(twins: array(dtype=int32), parents: array(dtype=int32)):
    """Make one set of the triangles that hang together by pairs."""
    i = tid()
    if twins[i] > i:
        unite(parents, i // 3, twins[i] // 3)


@kernel
def unite_forms_of_twins_kernel(placed: array(dtype=vec3i), twins: array(dtype=int32), parents: array(dtype=int32)):
    """Make sets of the forms of triangles, as they are and flipped, that pairs make turn alike."""
    i = tid()
    g = twins[i]
    if g > i:
        against = 0
        if corner_vertex(placed, i) == corner_vertex(placed, g):
            against = 1
        unite(parents, 2 * (i // 3), 2 * (g // 3) + against)
        unite(parents, 2 * (i // 3) + 1, 2 * (g // 3) + 1 - against)


@kernel
def part_tentative_kernel(parents: array(dtype=int32), tentative: array(dtype=uint8), twins: array(dtype=int32)):
    """Part tentative pairs of parts that have one side only."""
    i = tid()
    t = i // 3
    if tentative[i] != 0 and parents[2 * t] == parents[2 * t + 1]:
        twins[i] = -1


@kernel
def part_copies_kernel(
    placed: array(dtype=vec3i), chosen: array(dtype=uint8), twins: array(dtype=int32), parted: array(dtype=int32)
):
    """The pairs without those of a chosen triangle and its own copy."""
    i = tid()
    g = twins[i]
    if g >= 0:
        other = tip_of(placed, g)
        if tip_of(placed, i) == other and chosen[i // 3] != 0:
            g = -1
    parted[i] = g


def mask_loose(triangles: Triangles, vertex_count: int) -> Mask:
    """uint8 [t]: 0 for triangles of closed parts that turn alike, 1 for all others."""
    device, count = triangles.device, triangles.size
    edges = find_edges(triangles, vertex_count, padded=True)
    unsound, of_part, parents = zeros(count, uint8, device), zeros(count, uint8, device), positions(count, device)
    launch(mark_unsound_kernel, edges.count, [triangles, edges, unsound])
    launch(unite_runs_kernel, edges.count, [edges, parents])
    launch(flatten_sets_kernel, count, [parents])
    launch(mark_roots_kernel, count, [parents, unsound, of_part])
    loose = empty(count, uint8, device)
    launch(spread_marks_kernel, count, [parents, of_part, loose])
    return loose


@kernel
def read_flips_kernel(forms: array(dtype=int32), flips: array(dtype=uint8)):
    """1 for triangles in the set of their part's flipped form."""
    i = tid()
    flips[i] = uint8(forms[2 * i] % 2)


def _winding(forms: Indices, parents: Indices, inwards: bool) -> Mask:
    """uint8 [t]: 1 for triangles that are wound against most of their part, 0 where all look `inwards`."""
    flips = empty(parents.size, uint8, parents.device)
    launch(read_flips_kernel, flips.size, [forms, flips])
    follow_most(parents, flips, inwards)
    return flips


class Sheets:
    """The pairs of half-edges that make sheets of a mesh.

    Args:
        vertices: vec3 [m].
        triangles: vec3i [t], finite; none names a vertex twice.
        placed: vec3i [t], the same by the first vertex at each one's position; none that is loose names one twice.
        loose: uint8 [t], 0 for those of parts that are closed and turn alike.

    Attributes:
        twins: int32 [3 t], the other half-edge of the pair; -1 where there is none.
        crowding: uint8 [t], 1 for triangles with a half-edge that found no partner where more than two meet.
    """

    def __init__(self, vertices: Points, triangles: Triangles, placed: Triangles, loose: Mask) -> None:
        device, count, vertex_count = triangles.device, triangles.size, vertices.size
        self._placed, half_edges = placed, 3 * count
        self.twins, self.crowding = full(half_edges, -1, int32, device), zeros(count, uint8, device)
        is_open, edges = zeros(half_edges, uint8, device), find_edges(triangles, vertex_count, padded=True)
        launch(pair_given_kernel, edges.count, [placed, edges, loose, self.twins, is_open])
        found = OpenEdges(placed, vertex_count, is_open)
        natural = zeros(count, uint8, device)
        launch(pair_two_kernel, found.count, [found, self.twins, natural])
        rows = crowded_rows(found)  # sync
        if rows.size:
            self._match(vertices, found, rows, natural)

    def _match(self, vertices: Points, found: OpenEdges, rows: Indices, natural: Mask) -> None:
        placed, count, device = self._placed, self._placed.size, self._placed.device
        parents = self.parts()
        ends, naturals = zeros(count, uint8, device), empty(count, uint8, device)
        launch(mark_roots_kernel, count, [parents, natural, ends])
        launch(spread_marks_kernel, count, [parents, ends, naturals])
        area, volume = measure(vertices, placed)  # sync
        flips = _winding(self._forms(), parents, volume < -FLAT * area**1.5)
        match_by_angle(found, vertices, placed, rows, naturals, flips)
        tentative = zeros(3 * count, uint8, device)
        launch(write_twins_kernel, found.count, [found, self.twins, tentative, self.crowding])
        launch(part_tentative_kernel, 3 * count, [self._forms(), tentative, self.twins])

    def _forms(self) -> Indices:
        """The sets of triangles as they are, 2 t, and flipped, 2 t + 1, that pairs make turn alike."""
        forms = positions(2 * self._placed.size, self._placed.device)
        launch(unite_forms_of_twins_kernel, self.twins.size, [self._placed, self.twins, forms])
        launch(flatten_sets_kernel, forms.size, [forms])
        return forms

    def parts(self) -> Indices:
        """The first triangle of each one's part, int32 [t]: parts hang together by pairs."""
        parents = positions(self._placed.size, self._placed.device)
        launch(unite_twins_kernel, self.twins.size, [self.twins, parents])
        launch(flatten_sets_kernel, parents.size, [parents])
        return parents

    def part_copies(self, chosen: Mask) -> None:
        """Part the pairs of a triangle and its own opposite copy where the triangle is chosen, uint8 [t]."""
        parted = empty(self.twins.size, int32, self.twins.device)
        launch(part_copies_kernel, self.twins.size, [self._placed, chosen, self.twins, parted])
        self.twins = parted

    def corner_sets(self) -> Integers:
        """The lowest corner of those that are one vertex, int32 [3 t]: pairs join them, nothing else."""
        parents = positions(self.twins.size, self.twins.device)
        launch(unite_corners_of_twins_kernel, self.twins.size, [self._placed, self.twins, parents])
        launch(flatten_sets_kernel, parents.size, [parents])
        return parents


@kernel
def unite_corners_of_twins_kernel(placed: array(dtype=vec3i), twins: array(dtype=int32), parents: array(dtype=int32)):
    """Make one set of the corners at either end of a pair."""
    i = tid()
    g = twins[i]
    if g > i:
        a = corner_vertex(placed, i)
        b = corner_vertex(placed, next_corner(i))
        unite(parents, corner_at(placed, i, a), corner_at(placed, g, a))
        unite(parents, corner_at(placed, i, b), corner_at(placed, g, b))
