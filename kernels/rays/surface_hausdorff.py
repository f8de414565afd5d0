"""The largest distance from a surface to another one, between two bounds that close in on each other.

The distance to one triangle is convex, so over a piece of the surface it is largest at a corner; and the distance to
the other surface is at most that to any one of its triangles. So a piece lies within the largest distance of its
corners from the triangle nearest to its middle. What may still lie farther than the farthest point that is known is cut
into four, in rounds, all pieces of a round at once; after a few rounds only those about the farthest points are left.
(Tang, Lee and Kim, "Interactive Hausdorff distance computation for general polygonal models", SIGGRAPH 2009, bounds
alike.) 120 B a piece.

The first round looks at all triangles, and says how many pieces there are to be. From there on rounds follow each other
on the device, in room for four times as many; where more are left, the host makes room for four times those.
"""

import math
from collections.abc import Sequence

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Array1, Doubles, Points, Triangles
from ..arrays.loop_scan import LoopScan
from ..arrays.side_by_side import read_together
from ..arrays.sort import positions
from ..lang import (
    INFINITY,
    NAN,
    array,
    atomic_max,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    loop_while,
    reduce,
    reduction,
    sqrt,
    struct,
    tid,
    vec2d,
    vec3,
    vec3i,
)
from ..memory import empty, fill, zeros
from ..meshes.mesh_edits import mark_referenced_kernel
from .nearest_triangle import NOBODY, NearestTriangles
from .point_triangle import measure_triangle
from .triangle_tree import TriangleTree

MOST_PIECES = 2**22  # of a round: about 500 MB
LEAST_ROOM = 1024  # pieces of a round
ROUNDS = 24  # a float32 has as many bits to halve
# What is known: a distance that some point has, one that none exceeds, the largest bound of the round, the pieces of
# the next round, how many rounds there were, and whether there is to be another one.
LEAST, MOST, BOUND, COUNT, TURN, WANTED, NUMBERS = range(7)


@kernel
def take_roots_kernel(sqdists: array(dtype=float64), points: array(dtype=vec3), distances: array(dtype=float64)):
    """Distances from squared ones; NaN for points that are not finite."""
    i = tid()
    p = points[i]
    distances[i] = sqrt(sqdists[i]) + float64((p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2]))  # zero, or NaN


@reduction
def square_distance(distances: array(dtype=float64)) -> vec2d:
    """The square of each distance."""
    i = tid()
    return vec2d(distances[i] * distances[i], 0.0)


@kernel
def find_farthest_vertex_kernel(distances: array(dtype=float64), used: array(dtype=int32), known: array(dtype=float64)):
    """The largest finite distance of a vertex that triangles use; the atomic settles which."""
    i = tid()
    if used[i] == 1 and isfinite(distances[i]):
        atomic_max(known, 0, distances[i])


@kernel
def start_known_kernel(largest: array(dtype=float64), known: array(dtype=float64)):
    """The largest of some distances that points have; the atomic settles which."""
    i = tid()
    atomic_max(known, LEAST, largest[i])


@kernel
def list_pieces_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), pieces: array(dtype=vec3)):
    """The corners of triangles."""
    i = tid()
    t = triangles[i]
    for k in range(3):
        pieces[3 * i + k] = vertices[t[k]]


@struct
class Pieces:
    """The pieces of a round, in room for some.

    Attributes:
        pieces: vec3 [6 room], the corners of this round's pieces in one half, those of the next in the other.
        middles: vec3 [room], those of this round's pieces; NaN behind them.
        nearest: What is nearest to the middles.
        bounds: float64 [room], how far each piece reaches at most, -1 where there is none.
        ranks: int32 [room], how many pieces up to each are to be cut, itself included.
        room: Pieces.
        known: float64 [NUMBERS], what is known so far.
        running: int32 [1], 1 while there is another round, and room for it.
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
        """Room for pieces; those with the given corners fill it."""
        device, self.room, self.known = known.device, room, known
        self.pieces = empty(6 * room, vec3, device) if corners is None else corners
        self.middles, self.bounds = empty(room, vec3, device), empty(room, float64, device)
        self.ranks, self.running = empty(room, int32, device), zeros(1, int32, device)
        self._scan = LoopScan(room, device)

    def look(self, tree: TriangleTree, tolerance: float, *, in_turn: bool) -> None:
        """Bound the pieces of a round, and decide about the next; `in_turn` where one is near the one before it."""
        if not in_turn:
            launch(find_piece_middles_kernel, self.room, [self])
            self.nearest = NearestTriangles(self.middles)
        else:
            launch(start_round_kernel, self.room, [self])
        self.nearest.look_into(tree, self.middles, 0)
        launch(bound_pieces_kernel, self.room, [self, tree.vertices, tree.triangles])
        launch(mark_far_pieces_kernel, self.room, [self, tolerance])
        self._scan.run(self.ranks, self.ranks, self.room)
        launch(end_round_kernel, 1, [self, tolerance])

    def go_on(self, tree: TriangleTree, tolerance: float, before: "Pieces") -> None:
        """Cut what is left of earlier pieces, and go on until the bounds have met or there is no room; no sync."""
        self.nearest = NearestTriangles(self.middles, positions(self.room, self.known.device))
        launch(cut_pieces_kernel, before.room, [before, self.pieces, 3 * self.room])
        fill(self.running, 1)

        def turn() -> None:
            self.look(tree, tolerance, in_turn=True)
            launch(cut_pieces_kernel, self.room, [self, self.pieces, 3 * self.room])

        loop_while(self.running, turn)


@func
def half_of(given: Pieces, turn: int) -> int:
    """Where the corners of a round's pieces begin: of the first ones there is but one half."""
    first = 0
    if given.pieces.shape[0] > 3 * given.room and turn % 2 == 1:
        first = 3 * given.room
    return first


@func
def middle_of_piece(i: int, first: int, given: Pieces) -> vec3:
    """The middle of a piece."""
    at = first + 3 * i
    total = widen(given.pieces[at]) + widen(given.pieces[at + 1]) + widen(given.pieces[at + 2])
    return narrow(total / 3.0)


@kernel
def find_piece_middles_kernel(given: Pieces):
    """The middles of the first pieces, which fill their room."""
    i = tid()
    given.middles[i] = middle_of_piece(i, 0, given)


@kernel
def start_round_kernel(given: Pieces):
    """The middles of a round's pieces; nothing is near them yet."""
    i = tid()
    middle = vec3(NAN, NAN, NAN)
    if i < int(given.known[COUNT]):
        middle = middle_of_piece(i, half_of(given, int(given.known[TURN])), given)
    given.middles[i] = middle
    given.nearest.sqdists[i] = float64(INFINITY)
    given.nearest.triangles[i] = NOBODY


@func
def measure_row(p: vec3, vertices: array(dtype=vec3), t: vec3i) -> float64:
    """The squared distance of a point from a triangle."""
    found = measure_triangle(widen(p), widen(vertices[t[0]]), widen(vertices[t[1]]), widen(vertices[t[2]]))
    return found[3]


@kernel(most_registers=128)  # two blocks of an SM, not one
def bound_pieces_kernel(given: Pieces, vertices: array(dtype=vec3), triangles: array(dtype=vec3i)):
    """How far a piece reaches at most; its middle is a point that is known. The atomics settle the largest."""
    i = tid()
    bound = float64(-1.0)
    row = given.nearest.triangles[i]
    if row >= 0:
        t = triangles[row]
        first = half_of(given, int(given.known[TURN])) + 3 * i
        most = float64(0.0)
        corners = int(3)
        for k in range(corners):
            most = max(most, measure_row(given.pieces[first + k], vertices, t))
        bound = sqrt(most)
        distance = sqrt(given.nearest.sqdists[i])
        if distance > given.known[LEAST]:  # spares the atomic where it would change nothing
            atomic_max(given.known, LEAST, distance)
        if isfinite(bound) and bound > given.known[BOUND]:
            atomic_max(given.known, BOUND, bound)
    given.bounds[i] = bound


@kernel
def mark_far_pieces_kernel(given: Pieces, tolerance: float64):
    """1 where a piece may reach farther than what is known."""
    i = tid()
    given.ranks[i] = 1 if given.bounds[i] > given.known[LEAST] + tolerance else 0


@kernel
def end_round_kernel(given: Pieces, tolerance: float64):
    """What the round has found: the bounds, how many pieces are to be cut, and whether there is another round."""
    i = tid()
    left = int64(given.ranks[given.room - 1])
    most = max(given.known[BOUND], given.known[LEAST])
    turn = given.known[TURN + i] + 1.0
    given.known[MOST] = most
    given.known[BOUND] = float64(0.0)
    given.known[COUNT] = float64(4 * left)
    given.known[TURN] = turn
    wanted = 0
    if most > given.known[LEAST] + tolerance and 4 * left <= int64(MOST_PIECES) and turn < float64(ROUNDS):
        wanted = 1
    given.known[WANTED] = float64(wanted)
    given.running[0] = wanted if 4 * left <= int64(given.room) else 0


@kernel
def cut_pieces_kernel(given: Pieces, cut: array(dtype=vec3), half: int):
    """Each piece that is to be cut in four, at the middles of its edges, where there is room; of the round before."""
    i = tid()
    before = 0
    if i > 0:
        before = given.ranks[i - 1]
    turn = int(given.known[TURN])
    if given.ranks[i] > before and given.known[WANTED] == 1.0 and given.known[COUNT] * 3.0 <= float64(half):
        first = half_of(given, turn - 1) + 3 * i
        target = 0
        if turn % 2 == 1:
            target = half
        a = given.pieces[first]
        b = given.pieces[first + 1]
        c = given.pieces[first + 2]
        ab = narrow((widen(a) + widen(b)) * 0.5)
        bc = narrow((widen(b) + widen(c)) * 0.5)
        ca = narrow((widen(c) + widen(a)) * 0.5)
        at = target + 12 * before
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
    """The distances [m] of vec3 points about a tree's origin from its triangles, float64.

    Infinite where there are none or they lie 1.8e19 m away, NaN for points that are not finite.
    """
    nearest = NearestTriangles(points)
    nearest.look_into(tree, points, 0)
    distances = empty(points.size, float64, points.device)
    launch(take_roots_kernel, points.size, [nearest.sqdists, points, distances])
    return distances


def sum_squares(distances: Doubles) -> Array1[vec2d]:
    """The sum of the squares of float64 distances, all finite, and 0: on the device; no sync."""
    return reduce(square_distance, distances.size, [distances])


def root_mean_square(found: np.ndarray, count: int) -> float:
    """The root of the mean square of so many distances, of what the host has read of `sum_squares`."""
    return math.sqrt(float(found[0][0]) / count)


class FarthestSearch:
    """Bounds of the largest distance [m] of the points of a mesh from another one.

    Args:
        vertices: Device array of vec3, about the other mesh's origin.
        triangles: Device array of vec3i.
        tree: The other mesh's TriangleTree.
        distances: float64 device array of distances that points of the mesh have, none negative.
        tolerance: How far the bounds may be apart.

    Attributes:
        known: float64 [NUMBERS] on the device, for `told`.
    """

    def __init__(
        self, vertices: Points, triangles: Triangles, tree: TriangleTree, distances: Doubles, tolerance: float
    ) -> None:
        """Look at all triangles; no sync."""
        device = vertices.device
        self._tree, self._tolerance, self.known = tree, tolerance, zeros(NUMBERS, float64, device)
        used = zeros(vertices.size, int32, device)
        launch(start_known_kernel, distances.size, [distances, self.known])
        launch(mark_referenced_kernel, triangles.size, [triangles, used])
        launch(find_farthest_vertex_kernel, vertices.size, [distances_to(vertices, tree), used, self.known])
        corners = empty(3 * triangles.size, vec3, device)
        launch(list_pieces_kernel, triangles.size, [vertices, triangles, corners])
        self._pieces = Pieces(triangles.size, self.known, corners)
        self._pieces.look(tree, tolerance, in_turn=False)

    def is_done(self, found: np.ndarray) -> bool:
        """Whether what the host has read are the bounds; else they are read again: it goes on (no sync)."""
        if not found[WANTED]:
            return True
        before, room = self._pieces, max(LEAST_ROOM, min(4 * int(found[COUNT]), MOST_PIECES))
        self._pieces = Pieces(room, self.known)
        self._pieces.go_on(self._tree, self._tolerance, before)
        return False

    @staticmethod
    def told(found: np.ndarray) -> tuple[float, float]:
        """(least, most): a distance that some point has, and one that none exceeds. They are farther apart than the
        tolerance only where MOST_PIECES would not do."""
        return float(found[LEAST]), float(found[MOST])


def search_farthest(searches: Sequence[FarthestSearch], found: Sequence[np.ndarray]) -> list[tuple[float, float]]:
    """What searches find, of the numbers of each that the host has read; one sync where some go on, rarely more."""
    numbers = list(found)
    while left := [k for k, search in enumerate(searches) if not search.is_done(numbers[k])]:
        for k, values in zip(left, read_together([searches[k].known for k in left]), strict=True):  # sync
            numbers[k] = values
    return [search.told(values) for search, values in zip(searches, numbers, strict=True)]
