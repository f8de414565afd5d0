"""What a plane does to a mesh that was cut along it: heights of vertices, sides of pieces, half-edges in the plane.

A vertex that is nearer to the plane than float32 rounds the mesh's largest coordinate lies in it. O(t) time, 20 B a
half-edge.
"""

from typing import NamedTuple

import numpy as np

from ..algebra.transform import widen
from ..array_types import Doubles, Indices, Integers, Mask, Points, Triangles
from ..arrays.side_by_side import read_together
from ..lang import array, dot, float64, int32, isfinite, kernel, launch, tid, uint8, vec3, vec3d, vec3i
from ..memory import empty
from .level_cut import LevelCut
from .mesh_measures import triangle_cross
from .mesh_topology import corner_vertex, next_corner

ROUNDING = 2.0**-24  # of a coordinate in float32
COARSE = 2.0**-50  # of a coordinate in float64, with room for sums of some

ABOVE = 1
BELOW = -1
IN_PLANE_UP = 2  # all corners in the plane, wound along its normal
IN_PLANE_DOWN = 3


@kernel
def measure_heights_kernel(
    vertices: array(dtype=vec3), normal: vec3d, offset: float64, slack: float64, heights: array(dtype=float64)
):
    """Heights above the plane; 0 where they are not above the slack, and for vertices that are not finite."""
    i = tid()
    height = float64(0.0)
    if isfinite(vertices[i]):
        v = widen(vertices[i])
        height = dot(normal, v) + offset
        if abs(height) <= slack:
            height = float64(0.0)
    heights[i] = height


@kernel
def find_sides_kernel(
    vertices: array(dtype=vec3),
    pieces: array(dtype=vec3i),
    sides: array(dtype=int32),
    normal: vec3d,
    found: array(dtype=int32),
):
    """On which side a piece lies; its new vertices lie in the plane."""
    i = tid()
    t = pieces[i]
    side = 0
    for k in range(3):
        if t[k] < sides.shape[0]:
            if sides[t[k]] != 0:
                side = sides[t[k]]
    if side == 0:
        side = IN_PLANE_DOWN
        if dot(normal, triangle_cross(vertices, t)) > 0.0:
            side = IN_PLANE_UP
    found[i] = side


@kernel
def mark_half_edges_kernel(pieces: array(dtype=vec3i), sides: array(dtype=int32), mask: array(dtype=uint8)):
    """1 for half-edges of pieces whose two ends lie in the plane."""
    i = tid()
    a = corner_vertex(pieces, i)
    b = corner_vertex(pieces, next_corner(i))
    flat = 1
    if a < sides.shape[0]:
        if sides[a] != 0:
            flat = 0
    if b < sides.shape[0]:
        if sides[b] != 0:
            flat = 0
    if a == b:
        flat = 0
    mask[i] = uint8(flat)


@kernel
def clear_half_edges_kernel(kept: array(dtype=uint8), mask: array(dtype=uint8)):
    """0 for half-edges of pieces that go."""
    i = tid()
    if kept[i // 3] == 0:
        mask[i] = uint8(0)


@kernel
def list_half_edges_kernel(
    vertices: array(dtype=vec3),
    pieces: array(dtype=vec3i),
    side_of: array(dtype=int32),
    rows: array(dtype=int32),
    listed: array(dtype=int32, ndim=2),
    ends: array(dtype=vec3),
):
    """Tail, head, the piece's side and the number of half-edges; and where their tails and heads are."""
    i = tid()
    h = rows[i]
    tail = corner_vertex(pieces, h)
    head = corner_vertex(pieces, next_corner(h))
    listed[i, 0] = tail
    listed[i, 1] = head
    listed[i, 2] = side_of[h // 3]
    listed[i, 3] = h
    ends[2 * i] = vertices[tail]
    ends[2 * i + 1] = vertices[head]


@kernel
def renumber_half_edges_kernel(
    vertex_places: array(dtype=int32), piece_places: array(dtype=int32), listed: array(dtype=int32, ndim=2)
):
    """Half-edges by the new numbers of vertices and pieces."""
    i = tid()
    listed[i, 0] = vertex_places[listed[i, 0]]
    listed[i, 1] = vertex_places[listed[i, 1]]
    listed[i, 3] = 3 * piece_places[listed[i, 3] // 3] + listed[i, 3] % 3


@kernel
def mask_side_kernel(side_of: array(dtype=int32), with_up: int, mask: array(dtype=uint8)):
    """1 for the pieces above, and those in the plane: that face down, or all."""
    i = tid()
    side = side_of[i]
    kept = 0
    if side == ABOVE or side == IN_PLANE_DOWN or (side == IN_PLANE_UP and with_up == 1):
        kept = 1
    mask[i] = uint8(kept)


def measure_heights(vertices: Points, normal: np.ndarray, offset: float, slack: float) -> Doubles:
    """float64 [m]: how far vertices lie above a plane.

    Args:
        vertices: vec3 [m].
        normal: float64 [3], of unit length.
        offset: Of the plane: the height of zero.
        slack: Vertices no higher and no lower than this lie in the plane.
    """
    heights = empty(vertices.size, float64, vertices.device)
    launch(measure_heights_kernel, vertices.size, [vertices, vec3d(*normal.tolist()), offset, slack, heights])
    return heights


def find_sides(vertices: Points, pieces: Triangles, sides: Integers, normal: np.ndarray) -> Integers:
    """On which side of a plane the pieces of a cut lie.

    Args:
        vertices: vec3, those of the pieces.
        pieces: vec3i [p].
        sides: int32 [m], of the vertices before the cut; later ones lie in the plane.
        normal: float64 [3].

    Returns:
        int32 [p]: ABOVE, BELOW, IN_PLANE_UP or IN_PLANE_DOWN.
    """
    found = empty(pieces.size, int32, pieces.device)
    launch(find_sides_kernel, pieces.size, [vertices, pieces, sides, vec3d(*normal.tolist()), found])
    return found


def mask_above(side_of: Integers, *, with_up: bool) -> Mask:
    """uint8 [p]: 1 for pieces above the plane and in it, those that face up only where asked for."""
    mask = empty(side_of.size, uint8, side_of.device)
    launch(mask_side_kernel, side_of.size, [side_of, int(with_up), mask])
    return mask


class HalfEdges(NamedTuple):
    """Half-edges that lie in a plane, on the host.

    Attributes:
        rows: int32 [n, 4] of tail, head, the piece's side, its number.
        ends: float32 [n, 2, 3], where tails and heads are.
    """

    rows: np.ndarray
    ends: np.ndarray

    def places(self, vertices: np.ndarray) -> np.ndarray:
        """Where some of their vertices are, float64 [k, 3]."""
        numbers, first = np.unique(self.rows[:, :2], return_index=True)
        return self.ends.reshape(-1, 3)[first[np.searchsorted(numbers, vertices)]].astype(np.float64)


def mark_in_plane(cut: LevelCut, kept: Mask | None = None) -> Mask:
    """uint8 [3 p]: 1 for the half-edges of pieces, of those that are kept, that lie in the plane of a cut."""
    mask = empty(3 * cut.pieces.size, uint8, cut.pieces.device)
    launch(mark_half_edges_kernel, mask.size, [cut.pieces, cut.sides, mask])
    if kept is not None:
        launch(clear_half_edges_kernel, mask.size, [kept, mask])
    return mask


def read_half_edges(
    vertices: Points, pieces: Triangles, side_of: Integers, rows: Indices, places: tuple[Indices, Indices] | None = None
) -> HalfEdges:
    """Half-edges of pieces; one sync.

    Args:
        vertices: vec3, those of the pieces.
        pieces: vec3i [p].
        side_of: int32 [p], of `find_sides`.
        rows: int32 [n], the half-edges.
        places: The new numbers of vertices and of pieces, int32, where they have some.
    """
    listed, ends = empty((rows.size, 4), int32, pieces.device), empty(2 * rows.size, vec3, pieces.device)
    launch(list_half_edges_kernel, rows.size, [vertices, pieces, side_of, rows, listed, ends])
    if places is not None:
        launch(renumber_half_edges_kernel, rows.size, [*places, listed])
    found, at = read_together([listed, ends])  # sync
    return HalfEdges(found, at.reshape(-1, 2, 3))
