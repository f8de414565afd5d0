"""Alpha shapes: the faces between Delaunay tetrahedra whose sphere has a radius up to alpha and those beyond.

Each point builds its own star (alpha_stars.py), so it knows both sides of each of its faces: no triangulation of the
whole, no list of tetrahedra, nothing to match or to orient afterwards. The point of the lowest row hands a face out,
turned so that its outside is the side that is not kept. For several alphas the stars are built once, for the largest:
a tetrahedron has the class of the first alpha that keeps it, and a face belongs to the alphas between its two classes.

Faces are the boundary of the union of the kept tetrahedra, as CGAL's regularised alpha shape and Open3D's (Edelsbrunner
and Muecke 1994): an even number of them meets at each edge. Exact, and unique for points on one sphere (see
alpha_predicates.py).

Cost: about 20 triangles a star, each asked about each point near a sphere of the star; 8 kB of scratch a thread, on the
CPU used again for RUN points; a star that outgrows it is built again with four times the room.
"""

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from ..algebra.residues import Residues
from ..array_types import Array1, Cells, Indices, Integers
from ..arrays.concatenation import concatenate_rows
from ..arrays.lowest_bit import lowest_bit
from ..arrays.prefix_sum import scan_together
from ..arrays.select import positions_of_each
from ..lang import array, atomic_add, float64, func, int32, kernel, launch, tid, vec3i, vec4i
from ..memory import empty, upload, zeros
from ..search.neighbor_lists import list_neighbors
from ..search.point_tree import LARGEST_SQDIST, PointTree
from .alpha_predicates import EXACT_BITS, Predicates, ball, is_within_radius
from .alpha_stars import NUMBERS, Stars, grow_star, has_edge
from .alpha_tables import (
    COLUMNS,
    Found,
    mark_faces_kernel,
    mark_rows,
    mark_tetrahedra_kernel,
    read_faces_kernel,
    read_rows,
    read_tetrahedra_kernel,
)

NEAREST = 16  # points that come into a star before the walk
RUN = 64  # points a thread on the CPU, which share its scratch memory
ROOM = 96  # triangles a star, at first
SCRATCH = 2**25  # numbers of scratch memory a launch
FACES_A_POINT = 6  # there is room for at first: a surface has 4, both its sides counted
TETRAHEDRA_A_POINT = 8  # a Delaunay triangulation of random points has 6.8
WIDER = 2.001  # times alpha: what is looked at is a little more than what counts
TOGETHER = 16  # alphas whose faces are counted in one wait; each takes a byte a face for that
GUARD_BITS = 5  # of the guards' distance, so that it is a float64 and a whole number of units


@func
def class_of(b: int, c: int, d: int, a: int, at: int, thread: int, stars: Stars, given: Predicates) -> int:
    """The first radius that is no less than that of a tetrahedron's sphere; their number where there is none."""
    found = ball(0.0)
    for j in range(6):
        found[j] = stars.spheres[NUMBERS * at + j]
    kind = 0
    searching = 1
    while searching == 1 and kind < given.radii.shape[0]:
        searching = 1 - is_within_radius(b, c, d, found, a, kind, thread, given)
        kind += searching
    return kind


@func
def classify_star(a: int, thread: int, size: int, stars: Stars, given: Predicates):
    """The class of each triangle's tetrahedron; beyond all for those with a guard."""
    for j in range(size):
        at = thread * stars.room + j
        b = stars.corners[3 * at]
        c = stars.corners[3 * at + 1]
        d = stars.corners[3 * at + 2]
        kind = given.radii.shape[0]
        if max(b, max(c, d)) < given.count:
            kind = class_of(b, c, d, a, at, thread, stars, given)
        stars.edges[3 * thread * stars.room + j] = kind


@func
def list_faces(a: int, thread: int, size: int, stars: Stars, given: Predicates) -> int:
    """List the faces that a hands out, as triangle and side, behind the classes; how many: below 1.5 a triangle."""
    first = thread * stars.room
    row = given.rows[a]
    count = 0
    for j in range(size):
        kind = stars.edges[3 * first + j]
        if kind < given.radii.shape[0]:
            for side in range(3):
                b = stars.corners[3 * (first + j) + side]
                c = stars.corners[3 * (first + j) + (side + 1) % 3]
                if given.rows[b] > row and given.rows[c] > row:
                    other = has_edge(c, b, first, first + size, stars) - first
                    if kind < stars.edges[3 * first + other]:
                        stars.edges[3 * first + stars.room + count] = 3 * j + side
                        count += 1
    return count


@func
def write_faces(a: int, thread: int, size: int, count: int, start: int, stars: Stars, given: Predicates, faces: Found):
    """Write the listed faces from `start` on, where there is room."""
    first = thread * stars.room
    for place in range(min(count, faces.capacity - start)):
        listed = stars.edges[3 * first + stars.room + place]
        j = listed // 3
        b = stars.corners[3 * first + listed]
        c = stars.corners[3 * (first + j) + (listed + 1) % 3]
        at = (start + place) * COLUMNS
        faces.table[at] = given.rows[a]
        faces.table[at + 1] = given.rows[c]
        faces.table[at + 2] = given.rows[b]
        faces.table[at + 3] = stars.edges[3 * first + j]
        faces.table[at + 4] = stars.edges[3 * first + has_edge(c, b, first, first + size, stars) - first]


@func
def write_tetrahedra(
    a: int, thread: int, size: int, start: int, room: int, stars: Stars, given: Predicates, tetrahedra: Found
) -> int:
    """The tetrahedra that a hands out, their least other row next, written where there is room; how many."""
    first = thread * stars.room
    row = given.rows[a]
    count = 0
    for j in range(first, first + size):
        kind = stars.edges[3 * first + j - first]
        if kind < given.radii.shape[0]:
            b = given.rows[stars.corners[3 * j]]
            c = given.rows[stars.corners[3 * j + 1]]
            d = given.rows[stars.corners[3 * j + 2]]
            least = min(b, min(c, d))
            if least > row:
                if count < room:
                    at = (start + count) * COLUMNS
                    tetrahedra.table[at] = row
                    tetrahedra.table[at + 1] = least
                    tetrahedra.table[at + 2] = c if least == b else d if least == c else b
                    tetrahedra.table[at + 3] = d if least == b else b if least == c else c
                    tetrahedra.table[at + 4] = kind
                count += 1
    return count


@kernel
def find_faces_kernel(
    ranks: array(dtype=int32),
    run: int,
    begin: int,
    lists: array(dtype=int32),
    near: int,
    reach: float,
    tree: PointTree,
    stars: Stars,
    given: Predicates,
    with_tetrahedra: int,
    faces: Found,
    tetrahedra: Found,
    crowded: array(dtype=int32),
):
    """Hand out the faces of a run of points, and their tetrahedra where asked; crowded: the stars without room.

    The atomics give out room in the table. Where a point's rows come to lie is a race, and not seen in the result:
    the rows are put in order afterwards.
    """
    i = tid()
    for place in range(i * run, min((i + 1) * run, ranks.shape[0])):
        a = ranks[place]
        size = grow_star(a, i, lists, (a - begin) * near, near, reach, tree, stars, given)
        if size < 0:
            crowded[place] = 1
        else:
            crowded[place] = 0
            classify_star(a, i, size, stars, given)
            row = given.rows[a]
            count = list_faces(a, i, size, stars, given)
            start = atomic_add(faces.total, 0, count)
            write_faces(a, i, size, count, start, stars, given, faces)
            faces.starts[row] = start
            faces.counts[row] = count
            if with_tetrahedra == 1:
                turns = int(2)
                for turn in range(turns):  # count them, take room, write them
                    room = (tetrahedra.capacity - start) * turn
                    count = write_tetrahedra(a, i, size, start, room, stars, given, tetrahedra)
                    if turn == 0:
                        start = atomic_add(tetrahedra.total, 0, count)
                tetrahedra.starts[row] = start
                tetrahedra.counts[row] = count


def find_alpha_shapes(
    tree: PointTree, rows: Indices, owners: int, alphas: Sequence[float], with_tetrahedra: bool = False
) -> list[tuple[Cells, Array1[vec4i] | None]]:
    """The boundary of each alpha shape of the points of a tree.

    Args:
        tree: A PointTree over at least one point, no two of them equal.
        rows: int32 device array, each point's row in the cloud by its place in the tree.
        owners: Rows of the cloud.
        alphas: Positive floats, ascending; infinity keeps all tetrahedra.
        with_tetrahedra: Whether the tetrahedra are wanted.

    Returns:
        For each alpha (triangles, tetrahedra): vec3i [t] rows of the cloud, counter-clockwise from outside, by their
        least corners; vec4i [k], or None where they are not wanted, det(b - a, c - a, d - a) > 0.
    """
    given, reach, radius = prepare_predicates(tree, rows, alphas)
    room = [FACES_A_POINT * tree.count, TETRAHEDRA_A_POINT * tree.count if with_tetrahedra else 0]
    while True:
        totals, needed = zeros(2, int32, tree.device), [0, 0]
        faces, tetrahedra = (Found(tree.device, owners, size, totals[k : k + 1]) for k, size in enumerate(room))
        for begin, lists in list_neighbors(tree, NEAREST, radius):
            needed = hand_out(tree, begin, lists, reach, given, int(with_tetrahedra), faces, tetrahedra, totals)
        if all(size <= there for size, there in zip(needed, room, strict=True)):
            break
        room = [max(sizes) for sizes in zip(needed, room, strict=True)]
    face_table = faces.sorted_table(needed[0])
    table = tetrahedra.sorted_table(needed[1]) if with_tetrahedra else None
    shapes: list[tuple[Cells, Array1[vec4i] | None]] = []
    for first in range(0, len(alphas), TOGETHER):
        kinds = range(first, min(first + TOGETHER, len(alphas)))
        marks = [mark_rows(mark_faces_kernel, face_table, kind) for kind in kinds]
        marks += [mark_rows(mark_tetrahedra_kernel, table, kind) for kind in kinds if table is not None]
        listed = positions_of_each(*marks)  # sync
        for k in range(len(kinds)):
            corners = None if table is None else read_rows(read_tetrahedra_kernel, vec4i, table, listed[len(kinds) + k])
            shapes.append((read_rows(read_faces_kernel, vec3i, face_table, listed[k]), corners))
    return shapes


def hand_out(
    tree: PointTree,
    begin: int,
    lists: Integers,
    reach: float,
    given: Predicates,
    with_tetrahedra: int,
    faces: Found,
    tetrahedra: Found,
    totals: Integers,
) -> list[int]:
    """Launch the search over the points of some lists, again with more room for those that had too little.

    `totals` are those of faces and tetrahedra; given back as they are then. One sync a launch.
    """
    device, room, needed = tree.device, ROOM, [0, 0]
    run = 1 if device.is_cuda else RUN
    todo = empty(lists.size // NEAREST, int32, device)
    launch(number_places_kernel, todo.size, [begin, todo])
    while todo.size:
        step = max(1, SCRATCH // (room * NUMBERS)) * run
        left = []
        for first in range(0, todo.size, step):
            ranks = todo[first : min(first + step, todo.size)]
            threads = -(-ranks.size // run)
            given.reserve(threads)
            crowded = empty(ranks.size, int32, device)
            search = [ranks, run, begin, lists, NEAREST, reach, tree, Stars(device, threads, room), given]
            launch(find_faces_kernel, threads, [*search, with_tetrahedra, faces, tetrahedra, crowded])
            (offsets, (count,)), (_, needed) = scan_together([(crowded, [ranks.size])], totals)  # sync
            again = empty(count, int32, device)
            launch(list_crowded_kernel, ranks.size if count else 0, [ranks, offsets, again])
            left.append(again)
        todo = concatenate_rows(left)
        room, run = 4 * room, 1
    return needed


@kernel
def number_places_kernel(begin: int, places: array(dtype=int32)):
    """The places from one on."""
    i = tid()
    places[i] = begin + i


@kernel
def list_crowded_kernel(ranks: array(dtype=int32), offsets: array(dtype=int32), crowded: array(dtype=int32)):
    """The points whose stars had too little room."""
    i = tid()
    if offsets[i + 1] > offsets[i]:
        crowded[offsets[i]] = ranks[i]


def prepare_predicates(tree: PointTree, rows: Indices, alphas: Sequence[float]) -> tuple[Predicates, float, float]:
    """What exact answers need, how far a point looks (squared, for walks), and that distance [m]."""
    device = tree.device
    unit = lowest_bit(tree.points)  # sync
    one = Fraction(2) ** unit
    sides = [(Fraction(float(b)) - Fraction(float(a))) / one for a, b in zip(tree.low, tree.high, strict=True)]
    extent = max(1, math.ceil(max(sides)))
    # D is a whole number and |N| < 32 extent^4, so no sphere's radius |N| / (2 D) passes this one
    largest = 16 * extent**4
    radii = [Fraction(largest) if math.isinf(alpha) else min(Fraction(alpha) / one, largest) for alpha in alphas]
    guard = math.ceil(Fraction(WIDER) * radii[-1])
    spare = max(0, guard.bit_length() - GUARD_BITS)
    guard = -(-guard >> spare) << spare
    size = extent + guard
    squares = [4 * radius * radius for radius in radii]
    most = max(972 * extent**8 * square.denominator + 36 * extent**6 * square.numerator for square in squares)
    bounds = [6 * size**3, 72 * size**5, most]
    exact = Residues(device, unit, [0 if bound >> EXACT_BITS == 0 else bound for bound in bounds[:2]] + bounds[2:])
    given = Predicates(
        tree.points,
        rows,
        exact,
        float(guard * one),
        exact.table([guard]),
        upload(np.array([float(radius * one) for radius in radii]), float64, device),
        exact.table([square.numerator for square in squares]),
        exact.table([square.denominator for square in squares]),
    )
    radius = WIDER * float(radii[-1] * one)
    reach = min(radius * radius * (1 + 1e-6) + 1e-37, LARGEST_SQDIST)  # below that squares are no float32
    return given, reach, radius
