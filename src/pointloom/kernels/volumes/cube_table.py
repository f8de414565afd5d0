"""The 256 cases of marching cubes (Lorensen and Cline, SIGGRAPH 1987), derived at import time.

Corner c of a cell is at (c & 1, (c >> 1) & 1, (c >> 2) & 1) = (x, y, z). Bit c of a case is set if its value is below
the level (inside). Edge e = axis * 4 + k starts at its lower corner `EDGE_CORNER[e]`. Ambiguous faces separate inside
corners (Montani, Scateni and Scopigno, The Visual Computer 10, 1994). No diagonal of a triangulation is in a face,
since the neighbor could have the same one. Triangles are counter-clockwise seen from outside.
"""

from functools import cache
from itertools import combinations

import numpy as np

from ..array_types import Device
from ..lang import array, int32, struct
from ..memory import upload

MAX_TRIANGLES = 5  # of a case; asserted below

_CUBE_EDGES = [(corner, axis) for axis in range(3) for corner in range(8) if not corner >> axis & 1]
_EDGE_OF = {frozenset((corner, corner | 1 << axis)): edge for edge, (corner, axis) in enumerate(_CUBE_EDGES)}


def _face_corners(axis: int, side: int) -> list[int]:
    u, v = 1 << (axis + 1) % 3, 1 << (axis + 2) % 3
    cycle = [0, u, u | v, v] if side else [0, v, u | v, u]
    return [corner | side << axis for corner in cycle]


FACE_CORNERS = [_face_corners(axis, side) for axis in range(3) for side in range(2)]
FACE_EDGES = [{_EDGE_OF[frozenset((f[k], f[k - 1]))] for k in range(4)} for f in FACE_CORNERS]


def face_segments(case: int, face: list[int]) -> list[tuple[int, int]]:
    """Directed (edge, edge) contours of a face, one per run of inside corners, inside on the left seen from inside."""
    inside = [case >> corner & 1 for corner in face]
    segments = []
    for k in range(4):
        if inside[k] and not inside[k - 1]:
            last = k
            while inside[(last + 1) % 4]:
                last += 1
            entry = _EDGE_OF[frozenset((face[k - 1], face[k]))]
            leave = _EDGE_OF[frozenset((face[last % 4], face[(last + 1) % 4]))]
            segments.append((entry, leave))
    return segments


def _loops(case: int) -> list[list[int]]:
    following = dict(segment for face in FACE_CORNERS for segment in face_segments(case, face))
    loops = []
    while following:
        loop = [min(following)]
        while (edge := following.pop(loop[-1])) != loop[0]:
            loop.append(edge)
        loops.append(loop)
    return loops


def _triangulations(first: int, last: int) -> list[list[tuple[int, int, int]]]:
    if last - first < 2:
        return [[]]
    return [
        [(first, middle, last), *left, *right]
        for middle in range(first + 1, last)
        for left in _triangulations(first, middle)
        for right in _triangulations(middle, last)
    ]


def _midpoint(edge: int) -> np.ndarray:
    corner, axis = _CUBE_EDGES[edge]
    point = np.array([corner & 1, corner >> 1 & 1, corner >> 2 & 1], float)
    point[axis] = 0.5
    return point


def _triangulate(loop: list[int]) -> list[tuple[int, int, int]]:
    """Triangulation with no diagonal in a face, with the shortest diagonals, then the first."""
    size = len(loop)

    def cost(triangles: list[tuple[int, int, int]]) -> tuple[int, float]:
        sides = {pair for triangle in triangles for pair in combinations(triangle, 2)}
        diagonals = [(loop[a], loop[b]) for a, b in sorted(sides) if b - a not in (1, size - 1)]
        in_faces = sum(a in edges and b in edges for a, b in diagonals for edges in FACE_EDGES)
        return in_faces, sum(float(((_midpoint(a) - _midpoint(b)) ** 2).sum()) for a, b in diagonals)

    best = min(_triangulations(0, size - 1), key=cost)
    assert cost(best)[0] == 0
    return [(loop[a], loop[b], loop[c]) for a, b, c in best]


def case_triangles(case: int) -> list[tuple[int, int, int]]:
    return [triangle for loop in _loops(case) for triangle in _triangulate(loop)]


def _build() -> tuple[np.ndarray, np.ndarray]:
    counts = np.zeros(256, np.int32)
    edges = np.full((256, 3 * MAX_TRIANGLES), -1, np.int32)
    for case in range(256):
        flat = [edge for triangle in case_triangles(case) for edge in triangle]
        counts[case] = len(flat) // 3
        assert counts[case] <= MAX_TRIANGLES
        edges[case, : len(flat)] = flat
    return counts, edges.ravel()


EDGE_CORNER = np.array([corner for corner, _ in _CUBE_EDGES], np.int32)  # [12] the owner of each edge
EDGE_AXIS = np.array([axis for _, axis in _CUBE_EDGES], np.int32)  # [12]
TRIANGLE_COUNT, TRIANGLE_EDGES = _build()  # [256], [256 * 15] padded with -1


@struct
class CubeTables:
    triangle_count: array(dtype=int32)
    triangle_edges: array(dtype=int32)
    edge_corner: array(dtype=int32)
    edge_axis: array(dtype=int32)

    def __init__(self, device: Device | str) -> None:
        tables = (TRIANGLE_COUNT, TRIANGLE_EDGES, EDGE_CORNER, EDGE_AXIS)
        self.triangle_count, self.triangle_edges, self.edge_corner, self.edge_axis = (
            upload(table, int32, device) for table in tables
        )


def device_tables(device: Device) -> CubeTables:
    return _tables_on(str(device))


@cache
def _tables_on(device: str) -> CubeTables:
    return CubeTables(device)
