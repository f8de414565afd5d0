"""Plane cut of a mesh: heights of vertices, sides of pieces, half-edges in the plane.

Vertices closer to the plane than the float32 rounding of the largest coordinate are in it. 20 B per half-edge.
"""

from typing import NamedTuple

import numpy as np

from ..algebra.transform import widen
from ..array_types import Doubles, Indices, Integers, Mask, Points, Triangles
from ..arrays.side_by_side import read_together
from ..lang import array, compute, dot, float64, int32, isfinite, kernel, launch, tid, uint8, vec3, vec3d, vec3i
from ..memory import empty
from .level_cut import LevelCut
from .mesh_measures import triangle_cross
from .mesh_topology import corner_vertex, next_corner

FLOAT32_ROUNDING = 2.0**-24  # of a coordinate in float32
FLOAT64_ROUNDING = 2.0**-50  # of a coordinate in float64, with margin for short sums

SIDE_ABOVE = 1
SIDE_BELOW = -1
IN_PLANE_UP = 2  # all corners in the plane, oriented along its normal
IN_PLANE_DOWN = 3


@kernel
def measure_heights_kernel(
    vertices: array(dtype=vec3), normal: vec3d, offset: float64, slack: float64, heights: array(dtype=float64)
):
    """Heights above the plane. 0 within the slack and for non-finite vertices."""
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
    piece_sides: array(dtype=int32),
):
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
    piece_sides[i] = side


@kernel
def mark_half_edges_kernel(pieces: array(dtype=vec3i), sides: array(dtype=int32), mask: array(dtype=uint8)):
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
def clear_half_edges_kernel(selected: array(dtype=uint8), mask: array(dtype=uint8)):
    i = tid()
    if selected[i // 3] == 0:
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
    """Tail, head, side of the piece, and number of half-edges, and the positions of their ends."""
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
    vertex_indices: array(dtype=int32), piece_indices: array(dtype=int32), listed: array(dtype=int32, ndim=2)
):
    i = tid()
    listed[i, 0] = vertex_indices[listed[i, 0]]
    listed[i, 1] = vertex_indices[listed[i, 1]]
    listed[i, 3] = 3 * piece_indices[listed[i, 3] // 3] + listed[i, 3] % 3


@kernel
def mask_side_kernel(side_of: array(dtype=int32), with_up: int, mask: array(dtype=uint8)):
    i = tid()
    side = side_of[i]
    selected = 0
    if side == SIDE_ABOVE or side == IN_PLANE_DOWN or (side == IN_PLANE_UP and with_up == 1):
        selected = 1
    mask[i] = uint8(selected)


def measure_heights(vertices: Points, normal: np.ndarray, offset: float, slack: float) -> Doubles:
    """Signed heights above a plane (unit normal, offset), float64 [m]. 0 within `slack`."""
    heights = empty(vertices.size, float64, vertices.device)
    launch(measure_heights_kernel, vertices.size, [vertices, vec3d(*normal.tolist()), offset, slack, heights])
    return heights


def find_sides(vertices: Points, pieces: Triangles, sides: Integers, normal: np.ndarray) -> Integers:
    """Side of each piece: ABOVE, BELOW, IN_PLANE_UP or IN_PLANE_DOWN. Vertices beyond `sides` are in the plane."""
    piece_sides = empty(pieces.size, int32, pieces.device)
    launch(find_sides_kernel, pieces.size, [vertices, pieces, sides, vec3d(*normal.tolist()), piece_sides])
    return piece_sides


def mask_above(side_of: Integers, *, with_up: bool) -> Mask:
    """uint8 [p]: 1 for pieces above or in the plane; those that face up only with `with_up`."""
    return compute(mask_side_kernel, side_of.size, [side_of, int(with_up)], uint8, side_of.device)


class HalfEdges(NamedTuple):
    """Half-edges in a plane, on the host: `rows` int32 [n, 4] of tail, head, side, number; `ends` float32 [n, 2, 3]."""

    rows: np.ndarray
    ends: np.ndarray

    def positions(self, vertices: np.ndarray) -> np.ndarray:
        numbers, first = np.unique(self.rows[:, :2], return_index=True)
        return self.ends.reshape(-1, 3)[first[np.searchsorted(numbers, vertices)]].astype(np.float64)


def mark_in_plane(cut: LevelCut, selected: Mask | None = None) -> Mask:
    """uint8 [3 p]: 1 for half-edges of (selected) pieces in the plane of a cut."""
    mask = compute(mark_half_edges_kernel, 3 * cut.pieces.size, [cut.pieces, cut.sides], uint8, cut.pieces.device)
    if selected is not None:
        launch(clear_half_edges_kernel, mask.size, [selected, mask])
    return mask


def read_half_edges(
    vertices: Points,
    pieces: Triangles,
    side_of: Integers,
    rows: Indices,
    indices: tuple[Indices, Indices] | None = None,
) -> HalfEdges:
    """Read half-edges `rows` of pieces. One sync. `indices` are the new ones of vertices and pieces."""
    listed, ends = empty((rows.size, 4), int32, pieces.device), empty(2 * rows.size, vec3, pieces.device)
    launch(list_half_edges_kernel, rows.size, [vertices, pieces, side_of, rows, listed, ends])
    if indices is not None:
        launch(renumber_half_edges_kernel, rows.size, [*indices, listed])
    listed_rows, at = read_together([listed, ends])  # sync
    return HalfEdges(listed_rows, at.reshape(-1, 2, 3))
