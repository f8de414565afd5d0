"""One-sided Hausdorff distance between surfaces by converging bounds, as in Tang, Lee and Kim, "Interactive Hausdorff
distance computation for general polygonal models", SIGGRAPH 2009. The distance to one triangle is convex, so a piece is
bounded by the corner distances to the triangle nearest to its center. Pieces that may exceed the known maximum are
split into four in rounds on the device: along an edge of that triangle, so that pieces of flat parts end where the
other surface has edges, else at the midpoints of their edges.
"""

import math
from collections.abc import Sequence

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Array1, Doubles, Points, Triangles
from ..arrays.side_by_side import read_together
from ..arrays.sort import positions
from ..arrays.tile_scan import TileScan
from ..lang import (
    INFINITY,
    NAN,
    array,
    atomic_max,
    compute,
    dot,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    length,
    loop_while,
    reduce,
    reduction,
    sqrt,
    struct,
    tid,
    vec2d,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, fill, zeros
from ..meshes.mesh_edits import mark_referenced_kernel
from .nearest_triangle import NO_TRIANGLE, NearestTriangles
from .point_triangle import measure_triangle
from .triangle_tree import TriangleTree

MAX_PIECES = 2**22  # per round: about 500 MB
MIN_ROOM = 1024  # pieces per round
MAX_ROUNDS = 24  # mantissa bits of float32
# To cut a piece along an edge: minimum extent on both sides, relative to its size, and maximum size, relative to the
# nearest triangle. Other cuts make narrow pieces, or one piece for each of many triangles in sequence.
MIN_SIDE, MAX_CUT_SIZE = 0.05, 2.0
SMALLEST_DIVISOR = 1e-300  # avoids 0 / 0
# Lower bound, upper bound, largest bound of the round and of all pieces that were not split, pieces of the next round,
# rounds so far, and whether another round is needed.
LOWER_BOUND, UPPER_BOUND, PIECE_BOUND, KEPT_BOUND, PIECE_COUNT, ROUND_NUMBER, ROUND_WANTED, KNOWN_NUMBERS = range(8)


@kernel
def take_roots_kernel(sqdists: array(dtype=float64), points: array(dtype=vec3), distances: array(dtype=float64)):
    """Distances from squared ones. NaN for non-finite points."""
    i = tid()
    p = points[i]
    distances[i] = sqrt(sqdists[i]) + float64((p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2]))  # zero, or NaN


@reduction
def square_distance(distances: array(dtype=float64)) -> vec2d:
    i = tid()
    return vec2d(distances[i] * distances[i], 0.0)


@kernel
def find_farthest_vertex_kernel(distances: array(dtype=float64), used: array(dtype=int32), known: array(dtype=float64)):
    """Largest finite distance of a used vertex (atomic maximum)."""
    i = tid()
    if used[i] == 1 and isfinite(distances[i]):
        atomic_max(known, 0, distances[i])


@kernel
def start_known_kernel(largest: array(dtype=float64), known: array(dtype=float64)):
    """Maximum of known distances (atomic)."""
    i = tid()
    atomic_max(known, LOWER_BOUND, largest[i])


@kernel
def list_pieces_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), pieces: array(dtype=vec3)):
    i = tid()
    t = triangles[i]
    for k in range(3):
        pieces[3 * i + k] = vertices[t[k]]


@struct
class Pieces:
    """Pieces of a round. `pieces`: corners of this and the next round; `middles`, NaN padding; `bounds`, -1 if unused;
    `ranks`: inclusive counts of pieces to split; `known` (KNOWN_NUMBERS).
    """

    pieces: array(dtype=vec3)
    middles: array(dtype=vec3)
    nearest: NearestTriangles
    bounds: array(dtype=float64)
    ranks: array(dtype=int32)
    room: int
    known: array(dtype=float64)
    running: array(dtype=int32)

    def __init__(self, room: int, known: Doubles, corners: Points | None = None) -> None:
        """Allocate room for pieces; given corners fill it."""
        device, self.room, self.known = known.device, room, known
        self.pieces = empty(6 * room, vec3, device) if corners is None else corners
        self.middles, self.bounds = empty(room, vec3, device), empty(room, float64, device)
        self.ranks, self.running = empty(room, int32, device), zeros(1, int32, device)
        self._scan = TileScan(room, device)

    def bound_round(self, tree: TriangleTree, tolerance: float, *, is_ordered: bool) -> None:
        """Bound the pieces of a round and decide on the next; `is_ordered`: consecutive pieces are close."""
        if not is_ordered:
            launch(find_piece_middles_kernel, self.room, [self])
            self.nearest = NearestTriangles(self.middles)
        else:
            launch(start_round_kernel, self.room, [self])
        self.nearest.search(tree, self.middles, 0)
        launch(bound_pieces_kernel, self.room, [self, tree.vertices, tree.triangles])
        launch(mark_far_pieces_kernel, self.room, [self, tolerance])
        self._scan.run(self.ranks, self.ranks, self.room)
        launch(end_round_kernel, 1, [self, tolerance])

    def cut(self, tree: TriangleTree, before: "Pieces") -> None:
        """Split the selected pieces of `before` into the pieces of the next round."""
        arguments = [before, tree.vertices, tree.triangles, self.pieces, 3 * self.room]
        launch(cut_pieces_kernel, before.room, arguments)

    def run_rounds(self, tree: TriangleTree, tolerance: float, before: "Pieces") -> None:
        """Split the remaining pieces, and continue until the bounds meet or the room is exhausted. No sync."""
        self.nearest = NearestTriangles(self.middles, positions(self.room, self.known.device))
        self.cut(tree, before)
        fill(self.running, 1)

        def run_round() -> None:
            self.bound_round(tree, tolerance, is_ordered=True)
            self.cut(tree, self)

        loop_while(self.running, run_round)


@func
def half_of(given: Pieces, round_number: int) -> int:
    """Start of the corners of a round's pieces. The first round has only one half."""
    first = 0
    if given.pieces.shape[0] > 3 * given.room and round_number % 2 == 1:
        first = 3 * given.room
    return first


@func
def middle_of_piece(i: int, first: int, given: Pieces) -> vec3:
    at = first + 3 * i
    total = widen(given.pieces[at]) + widen(given.pieces[at + 1]) + widen(given.pieces[at + 2])
    return narrow(total / 3.0)


@kernel
def find_piece_middles_kernel(given: Pieces):
    i = tid()
    given.middles[i] = middle_of_piece(i, 0, given)


@kernel
def start_round_kernel(given: Pieces):
    """Centers of a round's pieces, with nothing near them yet."""
    i = tid()
    middle = vec3(NAN, NAN, NAN)
    if i < int(given.known[PIECE_COUNT]):
        middle = middle_of_piece(i, half_of(given, int(given.known[ROUND_NUMBER])), given)
    given.middles[i] = middle
    given.nearest.sqdists[i] = float64(INFINITY)
    given.nearest.triangles[i] = NO_TRIANGLE


@func
def measure_row(p: vec3, vertices: array(dtype=vec3), t: vec3i) -> float64:
    nearest = measure_triangle(widen(p), widen(vertices[t[0]]), widen(vertices[t[1]]), widen(vertices[t[2]]))
    return nearest[3]


@kernel(max_registers=128)  # for two blocks per SM
def bound_pieces_kernel(given: Pieces, vertices: array(dtype=vec3), triangles: array(dtype=vec3i)):
    """Upper bound of a piece. Its center is a sample (atomic maxima)."""
    i = tid()
    bound = float64(-1.0)
    row = given.nearest.triangles[i]
    if row >= 0:
        t = triangles[row]
        first = half_of(given, int(given.known[ROUND_NUMBER])) + 3 * i
        max_sqdist = float64(0.0)
        corners = int(3)
        for k in range(corners):
            max_sqdist = max(max_sqdist, measure_row(given.pieces[first + k], vertices, t))
        bound = sqrt(max_sqdist)
        distance = sqrt(given.nearest.sqdists[i])
        if distance > given.known[LOWER_BOUND]:  # saves needless atomics
            atomic_max(given.known, LOWER_BOUND, distance)
        if isfinite(bound) and bound > given.known[PIECE_BOUND]:
            atomic_max(given.known, PIECE_BOUND, bound)
    given.bounds[i] = bound


@kernel
def mark_far_pieces_kernel(given: Pieces, tolerance: float64):
    """Pieces to split. The bounds of others remain (atomic maximum)."""
    i = tid()
    bound = given.bounds[i]
    is_far = int(0)
    if bound > given.known[LOWER_BOUND] + tolerance:
        is_far = 1
    elif bound > given.known[KEPT_BOUND]:
        atomic_max(given.known, KEPT_BOUND, bound)
    given.ranks[i] = is_far


@kernel
def end_round_kernel(given: Pieces, tolerance: float64):
    """Store the bounds, the count of pieces to split and whether another round is needed."""
    i = tid()
    left = int64(given.ranks[given.room - 1])
    upper = max(given.known[PIECE_BOUND], given.known[LOWER_BOUND])
    round_number = given.known[ROUND_NUMBER + i] + 1.0
    given.known[UPPER_BOUND] = max(upper, given.known[KEPT_BOUND])
    given.known[PIECE_BOUND] = float64(0.0)
    given.known[PIECE_COUNT] = float64(4 * left)
    given.known[ROUND_NUMBER] = round_number
    wanted = 0
    above = given.known[LOWER_BOUND] + tolerance
    if upper > above and 4 * left <= int64(MAX_PIECES) and round_number < float64(MAX_ROUNDS):
        wanted = 1
    given.known[ROUND_WANTED] = float64(wanted)
    given.running[0] = wanted if 4 * left <= int64(given.room) else 0


@func
def size_of(a: vec3, b: vec3, c: vec3) -> float:
    """Longest edge of a triangle."""
    return max(length(b - a), max(length(c - b), length(a - c)))


@func
def beyond_edge(p: vec3, a: vec3, b: vec3, c: vec3) -> float64:
    """Distance of p beyond the edge a b of a triangle, in its plane, below 0 on the side of c. 0 if it has no area."""
    along = widen(b) - widen(a)
    inward = widen(c) - widen(a)
    inward = inward - along * (dot(inward, along) / max(dot(along, along), float64(SMALLEST_DIVISOR)))
    return -dot(widen(p) - widen(a), inward) / max(length(inward), float64(SMALLEST_DIVISOR))


@func
def point_between(a: vec3, b: vec3, fraction: float64) -> vec3:
    return narrow(widen(a) + (widen(b) - widen(a)) * fraction)


@kernel
def cut_pieces_kernel(
    given: Pieces, vertices: array(dtype=vec3), triangles: array(dtype=vec3i), cut: array(dtype=vec3), half: int
):
    """Split each selected piece of the previous round into four: along an edge of its nearest triangle, else at the
    midpoints of its edges.
    """
    i = tid()
    before = 0
    if i > 0:
        before = given.ranks[i - 1]
    round_number = int(given.known[ROUND_NUMBER])
    if given.ranks[i] > before and given.known[ROUND_WANTED] == 1.0 and given.known[PIECE_COUNT] * 3.0 <= float64(half):
        first = half_of(given, round_number - 1) + 3 * i
        target = 0
        if round_number % 2 == 1:
            target = half
        at = target + 12 * before
        corners = int(3)
        size = size_of(given.pieces[first], given.pieces[first + 1], given.pieces[first + 2])
        t = triangles[given.nearest.triangles[i]]
        near_size = size_of(vertices[t[0]], vertices[t[1]], vertices[t[2]])
        narrowest = float64(MIN_SIDE * size)
        alone = -1  # the corner that is alone on its side of the edge
        sides = vec3d(0.0, 0.0, 0.0)
        if size <= MAX_CUT_SIZE * near_size:
            for k in range(corners):
                p = vertices[t[k]]
                q = vertices[t[(k + 1) % 3]]
                r = vertices[t[(k + 2) % 3]]
                d = vec3d(
                    beyond_edge(given.pieces[first], p, q, r),
                    beyond_edge(given.pieces[first + 1], p, q, r),
                    beyond_edge(given.pieces[first + 2], p, q, r),
                )
                side = min(max(d[0], max(d[1], d[2])), -min(d[0], min(d[1], d[2])))
                if side > narrowest:
                    narrowest = side
                    sides = d + vec3d(0.0, 0.0, 0.0)
                    alone = 0
                    if (d[0] > 0.0) == (d[2] > 0.0):
                        alone = 1
                    if (d[0] > 0.0) == (d[1] > 0.0):
                        alone = 2
        if alone < 0:
            alone = 0
            sides = vec3d(1.0, -1.0, -1.0)
        second = (alone + 1) % 3
        third = (alone + 2) % 3
        a = given.pieces[first + alone]
        b = given.pieces[first + second]
        c = given.pieces[first + third]
        ab = point_between(a, b, sides[alone] / (sides[alone] - sides[second]))
        bc = point_between(b, c, float64(0.5))
        ca = point_between(a, c, sides[alone] / (sides[alone] - sides[third]))
        for k in range(4):
            p = ab + vec3(0.0, 0.0, 0.0)
            q = bc + vec3(0.0, 0.0, 0.0)
            r = ca + vec3(0.0, 0.0, 0.0)
            if k == 1:
                p = a + vec3(0.0, 0.0, 0.0)
                q = ab + vec3(0.0, 0.0, 0.0)
            if k == 2:
                p = b + vec3(0.0, 0.0, 0.0)
                r = ab + vec3(0.0, 0.0, 0.0)
            if k == 3:
                p = c + vec3(0.0, 0.0, 0.0)
                q = ca + vec3(0.0, 0.0, 0.0)
                r = bc + vec3(0.0, 0.0, 0.0)
            cut[at + 3 * k] = p
            cut[at + 3 * k + 1] = q
            cut[at + 3 * k + 2] = r


def distances_to(points: Points, tree: TriangleTree) -> Doubles:
    """Distances [m] of points (about a tree's origin) to its triangles, float64; infinite beyond 1.8e19 m."""
    nearest = NearestTriangles(points)
    nearest.search(tree, points, 0)
    return compute(take_roots_kernel, points.size, [nearest.sqdists, points], float64, points.device)


def sum_squares(distances: Doubles) -> Array1[vec2d]:
    """(sum of squares of finite float64 distances, 0) on the device. No sync."""
    return reduce(square_distance, distances.size, [distances])


def root_mean_square(values: np.ndarray, count: int) -> float:
    """RMS of `count` distances from the host value of `sum_squares`."""
    return math.sqrt(float(values[0][0]) / count)


class FarthestSearch:
    """Bounds of the largest distance [m] from a mesh (about the other mesh's origin) to another one, closer than
    `tolerance`, from known `distances` of its points. Read `known` with `read_bounds`.
    """

    def __init__(
        self, vertices: Points, triangles: Triangles, tree: TriangleTree, distances: Doubles, tolerance: float
    ) -> None:
        """Process all triangles once. No sync."""
        device = vertices.device
        self._tree, self._tolerance, self.known = tree, tolerance, zeros(KNOWN_NUMBERS, float64, device)
        used = zeros(vertices.size, int32, device)
        launch(start_known_kernel, distances.size, [distances, self.known])
        launch(mark_referenced_kernel, triangles.size, [triangles, used])
        launch(find_farthest_vertex_kernel, vertices.size, [distances_to(vertices, tree), used, self.known])
        corners = empty(3 * triangles.size, vec3, device)
        launch(list_pieces_kernel, triangles.size, [vertices, triangles, corners])
        self._pieces = Pieces(triangles.size, self.known, corners)
        self._pieces.bound_round(tree, tolerance, is_ordered=False)

    def is_done(self, values: np.ndarray) -> bool:
        """True if the host values are final. Else continue and read again (no sync)."""
        if not values[ROUND_WANTED]:
            return True
        before, room = self._pieces, max(MIN_ROOM, min(4 * int(values[PIECE_COUNT]), MAX_PIECES))
        self._pieces = Pieces(room, self.known)
        self._pieces.run_rounds(self._tree, self._tolerance, before)
        return False

    @staticmethod
    def read_bounds(values: np.ndarray) -> tuple[float, float]:
        """(lower, upper) bound; farther apart than the tolerance only if MAX_PIECES was exceeded."""
        return float(values[LOWER_BOUND]), float(values[UPPER_BOUND])


def search_farthest(searches: Sequence[FarthestSearch], host_values: Sequence[np.ndarray]) -> list[tuple[float, float]]:
    """Results of searches from host values. One sync if some continue, rarely more."""
    numbers = list(host_values)
    while left := [k for k, search in enumerate(searches) if not search.is_done(numbers[k])]:
        for k, values in zip(left, read_together([searches[k].known for k in left]), strict=True):  # sync
            numbers[k] = values
    return [search.read_bounds(values) for search, values in zip(searches, numbers, strict=True)]
