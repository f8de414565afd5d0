"""What lies near a place in a voxel map: the nearest point, and how the points around a place are spread.

Device functions. Differences are taken inside voxels in float32, so they are as exact far from the start as near it.
The nearest point is searched in the query's voxel first and of the other 26 only in those that reach nearer than what
was found; it is exact among the 27.
"""

from ..arrays.block_keys import block_key
from ..arrays.hash_table import find_position
from ..lang import array, float32, float64, floor, func, int32, int64, vec3, vec3d, vec4, vector

nearest_place = vector(5, float64)  # vector, its square, where the point stands
map_moments = vector(10, float32)  # count, sums of x y z, of xx xy xz yy yz zz


@func
def cell_below(x: float64, size: float64) -> int:
    """The voxel of a coordinate [m]."""
    return int(floor(x / size))


@func
def place_in_cell(x: float64, cell: int, size: float64) -> float:
    """A coordinate [m] from its voxel's low side."""
    return float(x - float64(cell) * size)


@func
def gap_to(offset: float, side: int, size: float) -> float:
    """How far [m] the neighbouring voxel on a side (-1, 0, 1) is from a place inside a voxel, along one axis."""
    gap = float(0.0)
    if side < 0:
        gap = offset
    if side > 0:
        gap = size - offset
    return gap


@func
def side_of(digit: int, near: int) -> int:
    """0 for the voxel itself, then its neighbour on the nearer side, then the other."""
    side = int(0)
    if digit == 1:
        side = near
    if digit == 2:
        side = -near
    return side


@func
def find_nearest_in_map(
    x: vec3d,
    limit: float,
    size: float64,
    room: int,
    mask: int64,
    keys: array(dtype=int64),
    positions: array(dtype=int32),
    counts: array(dtype=int32),
    places: array(dtype=vec3),
) -> nearest_place:
    """The vector [m] from the nearest point of the 27 voxels around x to x, its square, and where the point stands in
    `places`; a square of at least `limit`, and -1, where none is nearer than that."""
    cx = cell_below(x[0], size)
    cy = cell_below(x[1], size)
    cz = cell_below(x[2], size)
    edge = float(size)
    ox = place_in_cell(x[0], cx, size)
    oy = place_in_cell(x[1], cy, size)
    oz = place_in_cell(x[2], cz, size)
    nx = 1 if ox > 0.5 * edge else -1
    ny = 1 if oy > 0.5 * edge else -1
    nz = 1 if oz > 0.5 * edge else -1
    best = vec4(0.0, 0.0, 0.0, limit)
    nearest = int(-1)
    for turn in range(27):
        sx = side_of(turn % 3, nx)
        sy = side_of((turn // 3) % 3, ny)
        sz = side_of(turn // 9, nz)
        gx = gap_to(ox, sx, edge)
        gy = gap_to(oy, sy, edge)
        gz = gap_to(oz, sz, edge)
        if gx * gx + gy * gy + gz * gz < best[3]:
            voxel = find_position(keys, positions, mask, block_key(cx + sx, cy + sy, cz + sz))
            if voxel >= 0:
                qx = ox - float(sx) * edge
                qy = oy - float(sy) * edge
                qz = oz - float(sz) * edge
                for slot in range(voxel * room, voxel * room + counts[voxel]):
                    p = places[slot]
                    dx = qx - p[0]
                    dy = qy - p[1]
                    dz = qz - p[2]
                    sqdist = dx * dx + dy * dy + dz * dz
                    if sqdist < best[3]:
                        best = vec4(dx, dy, dz, sqdist)
                        nearest = slot
    return nearest_place(float64(best[0]), float64(best[1]), float64(best[2]), float64(best[3]), float64(nearest))


@func
def moments_in_map(
    center: vec3d,
    reach: float,
    size: float64,
    room: int,
    mask: int64,
    keys: array(dtype=int64),
    positions: array(dtype=int32),
    counts: array(dtype=int32),
    places: array(dtype=vec3),
) -> map_moments:
    """How many points of the 27 voxels around a place lie nearer to it than a reach [m], and the sums of their
    differences from it and of the products of those (xx, xy, xz, yy, yz, zz)."""
    cx = cell_below(center[0], size)
    cy = cell_below(center[1], size)
    cz = cell_below(center[2], size)
    edge = float(size)
    ox = place_in_cell(center[0], cx, size)
    oy = place_in_cell(center[1], cy, size)
    oz = place_in_cell(center[2], cz, size)
    total = map_moments(0.0)
    for turn in range(27):
        sx = turn % 3 - 1
        sy = (turn // 3) % 3 - 1
        sz = turn // 9 - 1
        gx = gap_to(ox, sx, edge)
        gy = gap_to(oy, sy, edge)
        gz = gap_to(oz, sz, edge)
        if gx * gx + gy * gy + gz * gz < reach * reach:
            voxel = find_position(keys, positions, mask, block_key(cx + sx, cy + sy, cz + sz))
            if voxel >= 0:
                for slot in range(voxel * room, voxel * room + counts[voxel]):
                    p = places[slot]
                    x = p[0] + float(sx) * edge - ox
                    y = p[1] + float(sy) * edge - oy
                    z = p[2] + float(sz) * edge - oz
                    if x * x + y * y + z * z < reach * reach:
                        total += map_moments(1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)
    return total
