"""How far a convex hull reaches in a direction: by climbing along its edges from a table of directions.

On a convex hull every vertex but the farthest has a neighbour that is farther, so climbing finds the farthest one. A
table on a cube map begins the climb near its end: some ten neighbours are looked at, 24 B each, whatever the hull's
size. In float64.
"""

import numpy as np

from ..array_types import Device
from ..lang import array, cross, dot, float64, func, int32, kernel, launch, struct, tid, vec3d
from ..linear_algebra import matmul
from ..memory import download, empty, upload
from .hull_filter import aim_direction, grid_place, locate_direction

TABLE_WIDTH = 16  # cells along an edge of each face of the table: fewer steps to climb than neighbours to look at
TABLE_CHUNK = 1 << 22  # products of directions and vertices held at a time: 32 MB


@kernel
def aim_table_kernel(width: int, directions: array(dtype=vec3d)):
    """The direction of the middle of each cell of a cube map."""
    i = tid()
    u = (float64(i // width % width) + 0.5) / float64(width) * 2.0 - 1.0
    v = (float64(i % width) + 0.5) / float64(width) * 2.0 - 1.0
    directions[i] = aim_direction(i // (width * width), u, v)


@struct
class ClimbedHull:
    """A convex hull to climb on.

    Attributes:
        vertices: float64.
        starts: Where the neighbours of each vertex begin; [m + 1].
        neighbors: Vertices that share an edge with one, vertex after vertex.
        table: The vertex that is farthest in the direction of each cell of a cube map.
    """

    vertices: array(dtype=vec3d)
    starts: array(dtype=int32)
    neighbors: array(dtype=int32)
    table: array(dtype=int32)

    def __init__(self, vertices: np.ndarray, edges: np.ndarray, device: Device) -> None:
        """Prepare the climbs.

        Args:
            vertices: float64 [m, 3].
            edges: Rows of two vertices that an edge joins, integers [e, 2].
            device: Where they go.
        """
        directions = empty(6 * TABLE_WIDTH**2, vec3d, device)
        launch(aim_table_kernel, directions.size, [TABLE_WIDTH, directions])
        aims = download(directions)  # sync
        rows = max(1, TABLE_CHUNK // len(vertices))
        table = np.concatenate(
            [matmul(aims[k : k + rows], vertices.T).argmax(axis=1) for k in range(0, len(aims), rows)]
        )
        ends = np.concatenate([edges, edges[:, ::-1]])
        ends = ends[np.lexsort((ends[:, 1], ends[:, 0]))]
        starts = np.searchsorted(ends[:, 0], np.arange(len(vertices) + 1))
        self.starts, self.neighbors, self.table = (upload(v, int32, device) for v in (starts, ends[:, 1], table))
        self.vertices = upload(vertices, vec3d, device)


@func
def reach(n: vec3d, hull: ClimbedHull) -> float64:
    """How far the hull reaches in a direction: the largest n . vertex."""
    place = locate_direction(n)
    row = int(place[0]) * TABLE_WIDTH + grid_place(place[1], TABLE_WIDTH)
    best = hull.table[row * TABLE_WIDTH + grid_place(place[2], TABLE_WIDTH)]
    value = dot(n, hull.vertices[best])
    here = -1
    while here != best:
        here = best
        for j in range(hull.starts[here], hull.starts[here + 1]):
            other = dot(n, hull.vertices[hull.neighbors[j]])
            if other > value:
                value = other
                best = hull.neighbors[j]
    return value


@func
def box_volume(n: vec3d, m: vec3d, hull: ClimbedHull) -> float64:
    """The volume of the box with axes n, m and n x m."""
    k = cross(n, m)
    volume = float64(1.0)
    width = float64(0.0)
    for side in range(6):  # a loop, so that the compilers, which copy functions in, hold `reach` once
        direction = n + 0.0 * n
        if side // 2 == 1:
            direction = m
        if side // 2 == 2:
            direction = k
        if side % 2 == 1:
            direction = -direction
        width += reach(direction, hull)
        if side % 2 == 1:
            volume = volume * width
            width = 0.0
    return volume
