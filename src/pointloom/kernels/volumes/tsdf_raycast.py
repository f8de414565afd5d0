"""Ray casting of a volume: depth images of its surface.

One thread per pixel, tile by tile. Rays start at the tile's depth bound (camera_rays.py) and skip blocks, 4^3 parts and
cells without a corner behind a surface (block_signs.py). Elsewhere, the zero of the trilinear distance is found by
regula falsi. Next to unobserved corners the nearest voxels are used. Amanatides and Woo, Eurographics 1987. Newcombe et
al., "KinectFusion", ISMAR 2011, section 3.4. Parker et al., IEEE Visualization 1998. Positions are relative to the
camera's voxel for float32.
"""

import numpy as np

from ..algebra.camera import CameraLike
from ..algebra.plain_min_max import larger, smaller
from ..arrays.block_keys import block_key
from ..arrays.hash_table import find_position
from ..lang import array, bits_float, float32, floor, func, int32, int64, kernel, launch, tid, vec2, vec3, vec3i, vec4
from .block_rows import BLOCKS_AROUND, SeenBlocks
from .block_signs import PART_CELLS, BlockSigns, signs_of
from .camera_rays import TILE_PIXELS, CameraRays, ray_of
from .ray_images import RayImages, shade_hits
from .tsdf_blocks import BLOCK_SIDE
from .voxel_samples import (
    MIDDLE_BLOCK,
    UNSEEN_DISTANCE,
    cell_distances,
    floor_cell,
    greatest,
    interpolate,
    nearest_voxel,
    octet,
    seen_distance,
    to_float,
)

MAX_STEPS = 8192  # of a ray
PARALLEL_INVERSE = 1.0e30  # inverse of a direction parallel to an axis plane
MIN_COMPONENT = 1.0e-12  # [voxels per meter] below it a component counts as zero
RAY_START_FRACTION = 0.999999  # of a tile's depth: rays begin before rounding can skip a surface


@func
def inverse_of(direction: float) -> float:
    """Inverse of a direction component with its sign; positive for zero."""
    inverse = float(PARALLEL_INVERSE)
    if abs(direction) > MIN_COMPONENT:
        inverse = 1.0 / direction
    return inverse


@func
def value_in_cell(t: float, cell: vec3, corners: octet, ray: vec3, rays: CameraRays) -> float:
    return interpolate(
        corners,
        rays.start[0] + ray[0] * t - cell[0],
        rays.start[1] + ray[1] * t - cell[1],
        rays.start[2] + ray[2] * t - cell[2],
    )


@func
def nearest_value(t: float, block: int, corner: vec3i, ray: vec3, rays: CameraRays, seen: SeenBlocks) -> float:
    """Distance at the voxel nearest to a ray position, or UNSEEN."""
    return seen_distance(nearest_voxel(rays.start + ray * t, block, corner, seen), seen)


@func
def zero_between(before: float, before_d: float, here: float, here_d: float) -> float:
    return before + (here - before) * before_d / (before_d - here_d)


@func
def zero_in_cell(ends: vec4, cell: vec3, corners: octet, ray: vec3, rays: CameraRays) -> float:
    """Zero of the trilinear distance by regula falsi and a line. `ends`: parameter and distance before, then behind."""
    a = ends[0]
    a_d = ends[1]
    b = ends[2]
    b_d = ends[3]
    n = int(1)
    for _ in range(n):
        middle = zero_between(a, a_d, b, b_d)
        m_d = value_in_cell(middle, cell, corners, ray, rays)
        if m_d > 0.0:
            a = middle
            a_d = m_d
        else:
            b = middle
            b_d = m_d
    return zero_between(a, a_d, b, b_d)


@func
def hit_unseen(ends: vec4, block: int, corner: vec3i, ray: vec3, rays: CameraRays, seen: SeenBlocks) -> float:
    """Hit in a cell with an unobserved corner, or 0. `ends` are the entry, its distance, the exit, and its distance."""
    middle = 0.5 * (ends[0] + ends[2])
    m_d = nearest_value(middle, block, corner, ray, rays, seen)
    a = ends[0]
    a_d = ends[1]
    hit = 0.0
    if m_d <= 0.0 and a_d > 0.0 and a_d < UNSEEN_DISTANCE:
        hit = zero_between(a, a_d, middle, m_d)
    if m_d < UNSEEN_DISTANCE:
        a = middle
        a_d = m_d
    if hit == 0.0 and ends[3] <= 0.0 and a_d > 0.0 and a_d < UNSEEN_DISTANCE:
        hit = zero_between(a, a_d, ends[2], ends[3])
    return hit


@func
def block_at(cell: vec3i, base: vec3i, seen: SeenBlocks) -> int:
    """Block of a cell relative to voxel `base`, or -1."""
    return find_position(
        block_key((cell[0] + base[0]) >> 3, (cell[1] + base[1]) >> 3, (cell[2] + base[2]) >> 3), seen.blocks.table
    )


@func
def clamped(t: float, start: float, direction: float, low: int, size: int) -> int:
    return min(max(int(floor(start + direction * t)), low), low + size - 1)


@func
def hit_in_cell(
    ends: vec3, cell: vec3i, block: int, corner: vec3i, ray: vec3, rays: CameraRays, seen: SeenBlocks
) -> vec2:
    """Hit in a cell, or 0, and the distance at its exit. `ends` are the entry, its distance (or UNSEEN), the exit."""
    hit = 0.0
    before = ends[1]
    after = float(UNSEEN_DISTANCE)
    corners = cell_distances(block, cell[0] - corner[0], cell[1] - corner[1], cell[2] - corner[2], seen)
    if greatest(corners) < UNSEEN_DISTANCE:
        cell_position = to_float(cell)
        entry_d = value_in_cell(ends[0], cell_position, corners, ray, rays)
        after = value_in_cell(ends[2], cell_position, corners, ray, rays)
        if entry_d > 0.0 and after <= 0.0:
            hit = zero_in_cell(vec4(ends[0], entry_d, ends[2], after), cell_position, corners, ray, rays)
        if entry_d <= 0.0 and before > 0.0 and before < UNSEEN_DISTANCE:
            hit = ends[0]
    else:
        if before == UNSEEN_DISTANCE:
            before = nearest_value(ends[0], block, corner, ray, rays, seen)
        after = nearest_value(ends[2], block, corner, ray, rays, seen)
        hit = hit_unseen(vec4(ends[0], before, ends[2], after), block, corner, ray, rays, seen)
    return vec2(hit, after)


@func
def cell_beyond(t: float, exits: vec3, low: vec3i, size: int, ahead: vec3i, ray: vec3, rays: CameraRays) -> vec3i:
    """Cell that a ray enters when it leaves a box. Predicted branches, so that the next cell can start early."""
    x = low[0]
    y = low[1]
    z = low[2]
    if size > 1:
        x = clamped(t, rays.start[0], ray[0], low[0], size)
        y = clamped(t, rays.start[1], ray[1], low[1], size)
        z = clamped(t, rays.start[2], ray[2], low[2], size)
    if exits[0] <= exits[1] and exits[0] <= exits[2]:
        x = low[0] - 1 - (ahead[0] & -(size + 1))
    else:
        if exits[1] <= exits[2]:
            y = low[1] - 1 - (ahead[1] & -(size + 1))
        else:
            z = low[2] - 1 - (ahead[2] & -(size + 1))
    return vec3i(x, y, z)


@kernel(max_registers=128)
def cast_rays_kernel(
    rays: CameraRays, seen: SeenBlocks, signs: BlockSigns, depth: array(dtype=float32), met: array(dtype=int32)
):
    """One ray. The parameter is depth along z [m]. Threads go tile by tile to read the same voxels."""
    i = tid()
    tile = i // (TILE_PIXELS * TILE_PIXELS)
    column = tile % rays.columns * TILE_PIXELS + i % TILE_PIXELS
    row = tile // rays.columns * TILE_PIXELS + i // TILE_PIXELS % TILE_PIXELS
    if column >= rays.camera.width or row >= rays.camera.height:
        return
    pixel = row * rays.camera.width + column
    ray = ray_of(column, row, rays)
    inverse = vec3(inverse_of(ray[0]), inverse_of(ray[1]), inverse_of(ray[2]))
    ahead = vec3i(-int(inverse[0] > 0.0), -int(inverse[1] > 0.0), -int(inverse[2] > 0.0))  # all bits set if it goes up
    t = max(rays.nearest, bits_float(rays.nears[tile]) * RAY_START_FRACTION)
    last = min(rays.farthest, bits_float(rays.fars[tile]))
    hit = 0.0
    steps = 0
    if t <= last:
        cell = floor_cell(rays.start + ray * t)
        before = float(UNSEEN_DISTANCE)  # distance at the entry, if known from the previous cell
        block = block_at(cell, rays.base, seen)
        corner = vec3i(
            ((cell[0] + rays.base[0]) & -BLOCK_SIDE) - rays.base[0],
            ((cell[1] + rays.base[1]) & -BLOCK_SIDE) - rays.base[1],
            ((cell[2] + rays.base[2]) & -BLOCK_SIDE) - rays.base[2],
        )
        parts = 0
        if block >= 0:
            parts = signs.parts[block]
        while t <= last and hit == 0.0 and steps < MAX_STEPS:
            steps += 1
            x = cell[0] - corner[0]
            y = cell[1] - corner[1]
            z = cell[2] - corner[2]
            size = int(BLOCK_SIDE)
            is_candidate = 0
            if parts != 0:
                size = int(PART_CELLS)
                if ((parts >> ((x >> 2) * 4 + (y >> 2) * 2 + (z >> 2))) & 1) == 1:
                    size = 1
                    is_candidate = int(signs.cells[block * BLOCK_SIDE + x] >> int64(y * BLOCK_SIDE + z)) & 1
            low = vec3i(corner[0] + (x & -size), corner[1] + (y & -size), corner[2] + (z & -size))
            tx = (float(low[0] + (ahead[0] & size)) - rays.start[0]) * inverse[0]
            ty = (float(low[1] + (ahead[1] & size)) - rays.start[1]) * inverse[1]
            tz = (float(low[2] + (ahead[2] & size)) - rays.start[2]) * inverse[2]
            leave = larger(smaller(tx, smaller(ty, tz)), t)
            after = float(UNSEEN_DISTANCE)
            if is_candidate == 1:
                cell_hit = hit_in_cell(vec3(t, before, leave), cell, block, corner, ray, rays, seen)
                hit = cell_hit[0]
                after = cell_hit[1]
            if hit == 0.0:
                before = after
                t = leave
                cell = cell_beyond(t, vec3(tx, ty, tz), low, size, ahead, ray, rays)
                dx = (cell[0] - corner[0]) >> 3
                dy = (cell[1] - corner[1]) >> 3
                dz = (cell[2] - corner[2]) >> 3
                if (dx | dy | dz) != 0:
                    if block >= 0:
                        block = seen.neighbors[block * BLOCKS_AROUND + MIDDLE_BLOCK + 9 * dx + 3 * dy + dz]
                    else:
                        block = block_at(cell, rays.base, seen)
                    corner = vec3i(
                        corner[0] + dx * BLOCK_SIDE, corner[1] + dy * BLOCK_SIDE, corner[2] + dz * BLOCK_SIDE
                    )
                    parts = 0
                    if block >= 0:
                        parts = signs.parts[block]
        met[pixel] = block
    if hit > rays.farthest:
        hit = 0.0
    depth[pixel] = hit


def cast_rays(
    seen: SeenBlocks,
    camera: CameraLike,
    T_volume_camera: np.ndarray,
    nearest: float,
    farthest: float,
    images: RayImages,
) -> None:
    """Render a volume with depths `nearest` to `farthest` [m]. Raises ValueError for a camera beyond 2^20 blocks."""
    signs = signs_of(seen.blocks)
    rays = CameraRays(camera, T_volume_camera, nearest, farthest, seen.blocks, signs)
    outputs = [images.depth, images.met]
    launch(cast_rays_kernel, rays.nears.size * TILE_PIXELS * TILE_PIXELS, [rays, seen, signs, *outputs])
    shade_hits(rays, seen, images)
