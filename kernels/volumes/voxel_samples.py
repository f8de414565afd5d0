"""Distances between the voxels of a volume: at the nearest voxel, and trilinear among eight.

Places count in voxels from any voxel; `corner` is the low voxel of the block around a place, counted likewise, and
`block` its position among the blocks.
"""

from ..lang import float32, floor, func, vec3, vec3i, vector
from .block_rows import SeenBlocks, voxel_near
from .tsdf_blocks import SIDE

octet = vector(8, float32)
MOST_FRAMES = 65535  # a voxel's weight stops there
UNSEEN = 2.0  # no truncated distance is beyond 1


@func
def floor_cell(p: vec3) -> vec3i:
    """The voxel at or below a point, in voxels."""
    return vec3i(int(floor(p[0])), int(floor(p[1])), int(floor(p[2])))


@func
def seen_distance(voxel: int, seen: SeenBlocks) -> float:
    """The truncated distance at a voxel, UNSEEN where there is none."""
    d = float(UNSEEN)
    if voxel >= 0:
        if float(seen.blocks.weights[voxel]) > seen.threshold:
            d = seen.blocks.distances[voxel]
    return d


@func
def between(a: float, b: float, share: float) -> float:
    """From a to b by a share."""
    return a + share * (b - a)


@func
def interpolate(corners: octet, fx: float, fy: float, fz: float) -> float:
    """The trilinear value inside a cube of corner values, x slowest."""
    low = between(between(corners[0], corners[1], fz), between(corners[2], corners[3], fz), fy)
    high = between(between(corners[4], corners[5], fz), between(corners[6], corners[7], fz), fy)
    return between(low, high, fx)


@func
def sample_distance(p: vec3, block: int, corner: vec3i, seen: SeenBlocks) -> float:
    """The trilinear truncated distance at a point in voxels; UNSEEN where one of the 8 voxels is."""
    cell = floor_cell(p)
    x = cell[0] - corner[0]
    y = cell[1] - corner[1]
    z = cell[2] - corner[2]
    corners = octet(0.0)
    least = int(MOST_FRAMES)
    n = int(2)
    if min(x, min(y, z)) >= 0 and max(x, max(y, z)) < SIDE - 1:  # all eight in one block
        first = ((block * SIDE + x) * SIDE + y) * SIDE + z
        for c in range(8):
            voxel = first + ((c >> 2) * SIDE + ((c >> 1) & 1)) * SIDE + (c & 1)
            corners[c] = seen.blocks.distances[voxel]
            least = min(least, int(seen.blocks.weights[voxel]))
    else:
        for dx in range(n):
            for dy in range(n):
                for dz in range(n):
                    voxel = voxel_near(block, x + dx, y + dy, z + dz, seen)
                    weight = int(-1)
                    if voxel >= 0:
                        corners[4 * dx + 2 * dy + dz] = seen.blocks.distances[voxel]
                        weight = int(seen.blocks.weights[voxel])
                    least = min(least, weight)
    d = float(UNSEEN)
    if float(least) > seen.threshold:
        d = interpolate(corners, p[0] - float(cell[0]), p[1] - float(cell[1]), p[2] - float(cell[2]))
    return d


@func
def nearest_voxel(p: vec3, block: int, corner: vec3i, seen: SeenBlocks) -> int:
    """The voxel nearest to a point in voxels, or -1."""
    cell = floor_cell(p + vec3(0.5, 0.5, 0.5)) - corner
    voxel = ((block * SIDE + cell[0]) * SIDE + cell[1]) * SIDE + cell[2]
    if ((cell[0] | cell[1] | cell[2]) & -SIDE) != 0:  # beside the block
        voxel = voxel_near(block, cell[0], cell[1], cell[2], seen)
    return voxel


@func
def to_float(v: vec3i) -> vec3:
    """The same vector in float32."""
    return vec3(float(v[0]), float(v[1]), float(v[2]))
