"""Nearest and trilinear distances between voxels.

Positions are in voxels from any reference voxel; `corner` is the lowest voxel of the surrounding block, `block` its
index. A cell is named by its lowest voxel, local to the block.
"""

from ..lang import float32, floor, func, int32, vec3, vec3i, vector
from .block_rows import BLOCKS_AROUND, SeenBlocks, voxel_near
from .tsdf_blocks import BLOCK_SIDE, BLOCK_VOXELS

MIDDLE_BLOCK = 13  # index of a block among its neighbors
UNSEEN_DISTANCE = 2.0  # above all truncated distances
octet = vector(8, float32)
cube = vector(8, int32)


@func
def floor_cell(p: vec3) -> vec3i:
    return vec3i(int(floor(p[0])), int(floor(p[1])), int(floor(p[2])))


@func
def to_float(v: vec3i) -> vec3:
    return vec3(float(v[0]), float(v[1]), float(v[2]))


@func
def seen_distance(voxel: int, seen: SeenBlocks) -> float:
    """Truncated distance at a voxel, or UNSEEN."""
    d = float(UNSEEN_DISTANCE)
    if voxel >= 0:
        if float(seen.blocks.weights[voxel]) > seen.threshold:
            d = seen.blocks.distances[voxel]
    return d


@func
def nearest_voxel(p: vec3, block: int, corner: vec3i, seen: SeenBlocks) -> int:
    """Voxel nearest to a position in voxels, or -1."""
    cell = floor_cell(p + vec3(0.5, 0.5, 0.5)) - corner
    return voxel_near(block, cell[0], cell[1], cell[2], seen)


@func
def voxel_around(block: int, x: int, y: int, z: int, seen: SeenBlocks) -> int:
    """`voxel_near` with only one branch, at the end."""
    other = seen.neighbors[block * BLOCKS_AROUND + MIDDLE_BLOCK + 9 * (x >> 3) + 3 * (y >> 3) + (z >> 3)]
    voxel = -1
    if other >= 0:
        voxel = other * BLOCK_VOXELS + ((x & 7) * BLOCK_SIDE + (y & 7)) * BLOCK_SIDE + (z & 7)
    return voxel


@func
def cell_voxels(block: int, x: int, y: int, z: int, seen: SeenBlocks) -> cube:
    """Eight voxels of a cell, x slowest, coordinates in -8..14, or -1 without a block."""
    voxels = cube(-1)
    if min(x, min(y, z)) >= 0 and max(x, max(y, z)) < BLOCK_SIDE - 1:  # all eight in one block
        first = block * BLOCK_VOXELS + (x * BLOCK_SIDE + y) * BLOCK_SIDE + z
        for c in range(8):
            voxels[c] = first + ((c >> 2) * BLOCK_SIDE + ((c >> 1) & 1)) * BLOCK_SIDE + (c & 1)
    else:
        for c in range(8):
            voxels[c] = voxel_around(block, x + (c >> 2), y + ((c >> 1) & 1), z + (c & 1), seen)
    return voxels


@func
def corner_distances(voxels: cube, seen: SeenBlocks) -> octet:
    values = octet(UNSEEN_DISTANCE)
    for c in range(8):
        values[c] = seen_distance(voxels[c], seen)
    return values


@func
def cell_distances(block: int, x: int, y: int, z: int, seen: SeenBlocks) -> octet:
    """Distances at the corners of a cell, UNSEEN if not observed often enough."""
    return corner_distances(cell_voxels(block, x, y, z, seen), seen)


@func
def greatest(corners: octet) -> float:
    low = max(max(corners[0], corners[1]), max(corners[2], corners[3]))
    return max(low, max(max(corners[4], corners[5]), max(corners[6], corners[7])))


@func
def between(a: float, b: float, fraction: float) -> float:
    return a + fraction * (b - a)


@func
def interpolate(corners: octet, fx: float, fy: float, fz: float) -> float:
    low = between(between(corners[0], corners[1], fz), between(corners[2], corners[3], fz), fy)
    high = between(between(corners[4], corners[5], fz), between(corners[6], corners[7], fz), fy)
    return between(low, high, fx)
