"""What a camera would see of a volume, by ray casting: the depth of its surface, from which the other pictures follow.

One thread a pixel, tile by tile. A ray begins where the first block of its tile does (camera_rays.py), jumps over
blocks that are not there or in front of every surface, and walks the others by the nearest voxel's distance, no more
than a voxel at a time: distances along z overstate the way to a surface seen at a grazing angle, and a wall is as thin
as one voxel in its truncation. Near the surface the trilinear field decides, and at its change of sign up to three
steps of regula falsi find the zero. Positions count from the camera's own voxel, so that float32 is exact far from the
volume's origin. Newcombe et al., "KinectFusion", ISMAR 2011, section 3.4.
"""

from ..algebra.camera import pixel_ray
from ..algebra.transform import narrow
from ..arrays.block_keys import block_key
from ..arrays.hash_table import find_position
from ..lang import (
    array,
    atomic_max,
    bits_float,
    float32,
    float64,
    func,
    int32,
    kernel,
    launch,
    sqrt,
    tid,
    vec3,
    vec3i,
    vec4,
)
from ..memory import zeros
from .block_rows import AROUND, SeenBlocks
from .camera_rays import TILE, CameraRays
from .ray_images import shade_hits
from .tsdf_blocks import ROWS, SIDE
from .voxel_samples import UNSEEN, floor_cell, nearest_voxel, sample_distance, seen_distance, to_float

MAX_STEPS = 8192  # of a ray: 80 m through unbroken free space at 1 cm a voxel
STEP = 0.7  # of the distance: a mean of projective distances may overstate the true one
LONGEST = 1.0  # [voxels] longest step through seen space; 2 passed a wall fused at 75 degrees with 2 voxels' truncation
SHORTEST = 0.5  # [voxels] and through seen space next to the surface
SEARCH = 0.5  # [voxels] step through unseen voxels of a block
NEAR = 1.5  # [voxels] where the trilinear distance takes over from the nearest voxel's
CLOSE = 0.002  # of the truncation: from a distance so small a line meets the zero
NOWHERE = 1 << 30  # beyond every voxel
NUDGE = 1.0e-2  # [voxels] past the face of an absent block: more than float32 loses 80 000 voxels from the camera


@func
def distance_near(p: vec3, block: int, corner: vec3i, seen: SeenBlocks, near: float) -> float:
    """The distance at a point: the nearest voxel's, and below `near` the trilinear one where all 8 voxels are seen."""
    d = seen_distance(nearest_voxel(p, block, corner, seen), seen)
    if abs(d) < near:
        fine = sample_distance(p, block, corner, seen)
        if fine < UNSEEN:
            d = fine
    return d


@func
def zero_between(before: float, before_d: float, here: float, here_d: float) -> float:
    """Where the line through two distances of different sign is zero."""
    return before + (here - before) * before_d / (before_d - here_d)


@func
def exit_parameter(p: vec3, ray: vec3, low: vec3, high: vec3) -> float:
    """How far along a ray, from p, a box ends; all in voxels."""
    t = float(1.0e30)
    for axis in range(3):
        if ray[axis] > 1.0e-12:
            t = min(t, (high[axis] - p[axis]) / ray[axis])
        if ray[axis] < -1.0e-12:
            t = min(t, (low[axis] - p[axis]) / ray[axis])
    return t


@func
def block_corner(p: vec3, base: vec3i) -> vec3i:
    """The low voxel of the block around a point, counted like the point from the voxel `base`."""
    cell = floor_cell(p) + base
    return vec3i(cell[0] & -SIDE, cell[1] & -SIDE, cell[2] & -SIDE) - base


@func
def zero_on_ray(
    ends: vec4, ray: vec3, block: int, corner: vec3i, rays: CameraRays, seen: SeenBlocks, near: float
) -> float:
    """The parameter at which the distance along a ray is zero, by up to three steps of regula falsi.

    `ends` holds a parameter before it and the positive distance there, then one behind it and the distance there.
    """
    a = ends[0]
    a_d = ends[1]
    b = ends[2]
    b_d = ends[3]
    steps = int(0)
    m_d = float(UNSEEN)
    while steps < 3 and abs(m_d) > CLOSE:
        steps += 1
        middle = zero_between(a, a_d, b, b_d)
        q = rays.start + ray * middle
        m_d = distance_near(q, block, corner, seen, near)
        if m_d > 0.0 and m_d < UNSEEN:
            a = middle
            a_d = m_d
        if m_d <= 0.0:
            b = middle
            b_d = m_d
    return zero_between(a, a_d, b, b_d)


@func
def block_beyond(block: int, corner: vec3i, now: vec3i, base: vec3i, seen: SeenBlocks) -> int:
    """The block with its low voxel at `now`, come to from the one with its at `corner`; -1 where there is none."""
    found = int(-1)
    dx = now[0] - corner[0]
    dy = now[1] - corner[1]
    dz = now[2] - corner[2]
    if block >= 0 and max(abs(dx), max(abs(dy), abs(dz))) <= SIDE:
        found = seen.neighbors[block * AROUND + 13 + (9 * dx + 3 * dy + dz) // SIDE]
    else:
        low = now + base
        found = find_position(block_key(low[0] // SIDE, low[1] // SIDE, low[2] // SIDE), seen.blocks.table)
    return found


@kernel
def mark_backs_kernel(seen: SeenBlocks, backs: array(dtype=int32)):
    """1 for the blocks in whose cubes of eight voxels one is behind a surface; one thread a row, all write the same.

    A block's last cubes have the first voxels of the blocks above, so these mark the blocks below, too.
    """
    i = tid()
    block = i // ROWS
    lows = vec3i(0, 0, 0)  # how many blocks below along each axis share the voxel
    if i // SIDE % SIDE == 0:
        lows[0] = 1
    if i % SIDE == 0:
        lows[1] = 1
    for j in range(SIDE):
        voxel = i * SIDE + j
        if seen.blocks.distances[voxel] <= 0.0 and float(seen.blocks.weights[voxel]) > seen.threshold:
            above = int(0)
            if j == 0:
                above = 1
            for x in range(lows[0] + 1):
                for y in range(lows[1] + 1):
                    for z in range(above + 1):
                        below = seen.neighbors[block * AROUND + 13 - 9 * x - 3 * y - z]
                        if below >= 0:
                            atomic_max(backs, below, 1)


def mark_backs(seen):
    """The blocks that rays can hit something in, int32 [blocks] of 1 or 0."""
    backs = zeros(seen.blocks.count, int32, seen.neighbors.device)
    launch(mark_backs_kernel, seen.row_count, [seen, backs])
    return backs


@kernel
def cast_rays_kernel(
    rays: CameraRays, seen: SeenBlocks, backs: array(dtype=int32), depth: array(dtype=float32), met: array(dtype=int32)
):
    """One ray; the parameter is depth along z [m]. Threads go tile by tile: neighbours meet the same voxels."""
    i = tid()
    tile = i // (TILE * TILE)
    column = tile % rays.columns * TILE + i % TILE
    row = tile // rays.columns * TILE + i // TILE % TILE
    if column >= rays.camera.width or row >= rays.camera.height:
        return
    pixel = row * rays.camera.width + column
    voxel_size = seen.blocks.voxel_size
    ray = narrow(rays.R @ pixel_ray(float64(column), float64(row), rays.camera) / voxel_size)
    voxel_depth = 1.0 / sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2])  # [m] of depth a voxel
    reach = float(seen.blocks.truncation) / float(voxel_size)  # voxels
    near = NEAR / reach
    here = bits_float(rays.nears[tile])
    last = min(rays.farthest, bits_float(rays.fars[tile]))
    before = float(0.0)
    before_d = float(UNSEEN)
    hit = float(0.0)
    steps = int(0)
    block = int(-1)
    has_back = int(0)
    corner = vec3i(NOWHERE, NOWHERE, NOWHERE)
    while here <= last and steps < MAX_STEPS and hit == 0.0:
        steps += 1
        p = rays.start + ray * here
        now = block_corner(p, rays.base)
        if now[0] != corner[0] or now[1] != corner[1] or now[2] != corner[2]:
            block = block_beyond(block, corner, now, rays.base, seen)
            corner = now
            has_back = int(0)
            if block >= 0:
                has_back = backs[block]
        d = float(UNSEEN)
        step = SEARCH * voxel_depth
        if has_back == 0:  # nothing to hit on the way through
            high = to_float(corner + vec3i(SIDE, SIDE, SIDE))
            way = max(exit_parameter(p, ray, to_float(corner), high), 0.0)
            step = way + NUDGE * voxel_depth
            before = here + way
            before_d = float(UNSEEN)
            if block >= 0:
                before_d = seen_distance(nearest_voxel(p + ray * way, block, corner, seen), seen)
        else:
            d = distance_near(p, block, corner, seen, near)
            if d == UNSEEN:
                before_d = float(UNSEEN)
        if d < UNSEEN:
            if d <= 0.0 and before_d < UNSEEN:
                ends = vec4(before, before_d, here, d)
                hit = zero_on_ray(ends, ray, block, corner, rays, seen, near)
            step = min(max(abs(d) * reach * STEP, SHORTEST), LONGEST) * voxel_depth
            before = here + 0.0
            before_d = d + 0.0
            if d <= 0.0:
                before_d = float(UNSEEN)  # behind a surface: only its front is looked for
        here += step
    depth[pixel] = hit
    met[pixel] = block


def cast_rays(seen, camera, T_volume_camera, nearest, farthest, images):
    """What a camera sees of a volume.

    Args:
        seen: The SeenBlocks.
        camera: A Camera, or what has its attributes.
        T_volume_camera: float64 [4, 4].
        nearest, farthest: Depths [m] where rays begin and end.
        images: RayImages that are made.

    Raises:
        ValueError: The camera stands beyond 2^20 blocks from the volume's origin.
    """
    rays = CameraRays(camera, T_volume_camera, nearest, farthest, seen.blocks)
    places = [images.depth, images.met]
    launch(cast_rays_kernel, rays.nears.size * TILE * TILE, [rays, seen, mark_backs(seen), *places])
    shade_hits(rays, seen, images)
