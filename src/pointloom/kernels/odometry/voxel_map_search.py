"""Voxel map queries: nearest point and local moments, within the surrounding voxels. Float32 differences inside voxels,
equally exact at any distance. The query's voxel comes first, then the others that may be nearer.
"""

from ..arrays.block_keys import block_key
from ..arrays.hash_table import find_position
from ..lang import callback, float32, float64, func, loop, mat33d, outer, vec3, vec3d, vec3i, vector
from .local_cells import cell_holding, offset_in_cell
from .voxel_map import VoxelMap

nearest_point = vector(5, float64)  # vector, its square, index of the point
map_moments = vector(10, float32)  # count, sums of x y z, of xx xy xz yy yz zz


@func
def gap_to(offset: float, side: int, size: float) -> float:
    """Distance [m] from a position in a voxel to the one `side` voxels further (0: itself), along one axis."""
    gap = 0.0
    if side < 0:
        gap = offset - float(side + 1) * size
    if side > 0:
        gap = float(side) * size - offset
    return gap


@func
def side_of(digit: int, near: int) -> int:
    """0 for the voxel itself, then the nearer neighbor, then the other."""
    side = 0
    if digit == 1:
        side = near
    if digit == 2:
        side = -near
    return side


@func
def side_in_order(digit: int, reach: int) -> int:
    """-reach to reach."""
    return digit - reach


@func
def nearer_side(offset: float, size: float) -> int:
    """Side (-1 or 1) of the nearer neighbor along one axis."""
    return 1 if offset > 0.5 * size else -1


@loop
def voxels_around(
    cell: vec3i, position: vec3, sqradius: float, side: callback, near: vec3i, n: int, voxel_map: VoxelMap
) -> tuple[int, vec3]:
    """Occupied voxels of the n^3 within sqrt(`sqradius`), and offsets [m]; `side` gives the order along an axis."""
    edge = float(voxel_map.voxel_size)
    for z in range(n):
        sz = side(z, near[2])
        gz = gap_to(position[2], sz, edge)
        if gz * gz < sqradius:
            for y in range(n):
                sy = side(y, near[1])
                gy = gap_to(position[1], sy, edge)
                if gy * gy + gz * gz < sqradius:
                    for x in range(n):
                        sx = side(x, near[0])
                        gx = gap_to(position[0], sx, edge)
                        if gx * gx + gy * gy + gz * gz < sqradius:
                            voxel = find_position(block_key(cell[0] + sx, cell[1] + sy, cell[2] + sz), voxel_map.table)
                            if voxel >= 0:
                                shift = vec3(float(sx) * edge, float(sy) * edge, float(sz) * edge)
                                yield voxel, shift


@func
def find_nearest_in_map(x: vec3d, limit: float, voxel_map: VoxelMap) -> nearest_point:
    """Vector [m] from the nearest of the 27 voxels' points to x, its square, and index; (>= limit, -1) if none."""
    cell = cell_holding(x, voxel_map.voxel_size)
    position = offset_in_cell(x, cell, voxel_map.voxel_size)
    edge = float(voxel_map.voxel_size)
    near = vec3i(nearer_side(position[0], edge), nearer_side(position[1], edge), nearer_side(position[2], edge))
    best = vec3(0.0, 0.0, 0.0)
    min_sqdist = limit
    nearest = -1
    for voxel, shift in voxels_around(cell, position, min_sqdist, side_of, near, 3, voxel_map):
        q = position - shift
        first = voxel * voxel_map.room
        for slot in range(first, first + voxel_map.counts[voxel]):
            d = q - voxel_map.offsets[slot]
            sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
            if sqdist < min_sqdist:
                best = d
                min_sqdist = sqdist
                nearest = slot
    return nearest_point(float64(best[0]), float64(best[1]), float64(best[2]), float64(min_sqdist), float64(nearest))


@func
def moments_in_map(center: vec3d, radius: float, reach: int, voxel_map: VoxelMap) -> map_moments:
    """Count of points within `radius` [m], at most `reach` voxels, sums of differences and of products (xx, xy, ..)."""
    cell = cell_holding(center, voxel_map.voxel_size)
    position = offset_in_cell(center, cell, voxel_map.voxel_size)
    order = vec3i(reach, reach, reach)
    sqradius = radius * radius
    total = map_moments(0.0)
    for voxel, shift in voxels_around(cell, position, sqradius, side_in_order, order, 2 * reach + 1, voxel_map):
        first = voxel * voxel_map.room
        for slot in range(first, first + voxel_map.counts[voxel]):
            d = voxel_map.offsets[slot] + shift - position
            inside = 1.0 if d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < sqradius else 0.0
            x = d[0] * inside  # a branch takes four times as long, since half of the points are inside
            y = d[1] * inside
            z = d[2] * inside
            total += map_moments(inside, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)
    return total


@func
def mean_of(m: map_moments) -> vec3d:
    """Mean of the differences of at least one point."""
    n = float64(m[0])
    return vec3d(float64(m[1]) / n, float64(m[2]) / n, float64(m[3]) / n)


@func
def covariance_of(m: map_moments, mean: vec3d) -> mat33d:
    """Covariance of the differences about their mean."""
    n = float64(m[0])
    xx = float64(m[4]) / n
    xy = float64(m[5]) / n
    xz = float64(m[6]) / n
    yy = float64(m[7]) / n
    yz = float64(m[8]) / n
    zz = float64(m[9]) / n
    return mat33d(xx, xy, xz, xy, yy, yz, xz, yz, zz) - outer(mean, mean)
