"""What a camera would see of a volume: depth, points, normals and colours by ray casting.

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
    NAN,
    array,
    atomic_max,
    bits_float,
    float32,
    float64,
    floor,
    func,
    int32,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    vec3,
    vec3i,
    vec4,
    vector,
)
from ..memory import empty, zeros
from .block_rows import AROUND, SeenBlocks, voxel_near
from .camera_rays import TILE, CameraRays
from .tsdf_blocks import ROWS, SIDE
from .voxel_blocks import COLOR_SCALE, voxel_color

MAX_STEPS = 8192  # of a ray: 80 m through unbroken free space at 1 cm a voxel
STEP = 0.7  # of the distance: a mean of projective distances may overstate the true one
LONGEST = 1.0  # [voxels] longest step through seen space; 2 passed a wall fused at 75 degrees with 2 voxels' truncation
SHORTEST = 0.5  # [voxels] and through seen space next to the surface
SEARCH = 0.5  # [voxels] step through unseen voxels of a block
NEAR = 1.5  # [voxels] where the trilinear distance takes over from the nearest voxel's
CLOSE = 0.002  # of the truncation: from a distance so small a line meets the zero
octet = vector(8, float32)
MOST_FRAMES = 65535  # a voxel's weight stops there
UNSEEN = 2.0  # no truncated distance is beyond 1
NOWHERE = 1 << 30  # beyond every voxel
NUDGE = 1.0e-2  # [voxels] past the face of an absent block: more than float32 loses 80 000 voxels from the camera


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
def slope_between(a: float, middle: float, b: float) -> float:
    """The slope of three distances half a voxel apart, one-sided beside unseen voxels; UNSEEN between them."""
    slope = float(UNSEEN)
    if a < UNSEEN and b < UNSEEN:
        slope = b - a
    else:
        if a < UNSEEN and middle < UNSEEN:
            slope = 2.0 * (middle - a)
        if b < UNSEEN and middle < UNSEEN:
            slope = 2.0 * (b - middle)
    return slope


@func
def slopes_at(p: vec3, block: int, corner: vec3i, seen: SeenBlocks) -> vec3:
    """The slopes of the trilinear distance along the axes; the loop has one copy of what it calls, not seven."""
    slopes = vec3(UNSEEN, UNSEEN, UNSEEN)
    middle = float(UNSEEN)
    before = float(UNSEEN)
    n = int(7)
    for k in range(n):  # the middle, then one before and one behind it along each axis
        axis = (k + 1) // 2 - 1
        way = 0.5 * float(1 - 2 * (k % 2))
        e = vec3(0.0, 0.0, 0.0)
        if k > 0:
            e = vec3(way * float(axis == 0), way * float(axis == 1), way * float(axis == 2))
        d = sample_distance(p + e, block, corner, seen)
        if k == 0:
            middle = d + 0.0
        if k % 2 == 1:
            before = d + 0.0
        if k > 0 and k % 2 == 0:
            slope = slope_between(before, middle, d)
            if axis == 0:
                slopes = vec3(slope, UNSEEN, UNSEEN)
            if axis == 1:
                slopes = vec3(slopes[0], slope, UNSEEN)
            if axis == 2:
                slopes = vec3(slopes[0], slopes[1], slope)
    return slopes


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
def to_float(v: vec3i) -> vec3:
    """The same vector in float32."""
    return vec3(float(v[0]), float(v[1]), float(v[2]))


@struct
class RayImages:
    """What a camera sees, by pixel.

    Attributes:
        depth: float32 [h * w] along z [m]; 0 where nothing is hit.
        points, normals: vec3 [h * w] in the volume's frame; NaN where nothing is hit.
        colors: vec3 [h * w], 0 to 1; 0 where nothing is hit.
    """

    depth: array(dtype=float32)
    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    colors: array(dtype=vec3)

    def __init__(self, count, device):
        self.depth = empty(count, float32, device)
        self.points, self.normals, self.colors = (empty(count, vec3, device) for _ in range(3))


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
def write_hit(
    i: int,
    hit: float,
    p: vec3,
    block: int,
    corner: vec3i,
    rays: CameraRays,
    seen: SeenBlocks,
    has_color: int,
    images: RayImages,
):
    """Write what is seen where a ray meets the surface, at a point p in voxels."""
    images.depth[i] = hit
    images.points[i] = (p + to_float(rays.base)) * float(seen.blocks.voxel_size)
    slopes = slopes_at(p, block, corner, seen)
    gx = slopes[0]
    gy = slopes[1]
    gz = slopes[2]
    size = sqrt(gx * gx + gy * gy + gz * gz)
    if max(gx, max(gy, gz)) < UNSEEN and size > 0.0:
        images.normals[i] = vec3(gx, gy, gz) / size
    voxel = nearest_voxel(p, block, corner, seen)
    if has_color == 1 and voxel >= 0:
        images.colors[i] = voxel_color(voxel, seen.blocks) / (255.0 * COLOR_SCALE)


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
def cast_rays_kernel(rays: CameraRays, seen: SeenBlocks, backs: array(dtype=int32), has_color: int, images: RayImages):
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
    images.depth[pixel] = 0.0
    images.points[pixel] = vec3(NAN, NAN, NAN)
    images.normals[pixel] = vec3(NAN, NAN, NAN)
    images.colors[pixel] = vec3(0.0, 0.0, 0.0)
    if hit > 0.0:
        p = rays.start + ray * hit
        write_hit(pixel, hit, p, block, corner, rays, seen, has_color, images)


def cast_rays(seen, camera, T_volume_camera, nearest, farthest, has_color):
    """What a camera sees of a volume.

    Args:
        seen: The SeenBlocks.
        camera: A Camera, or what has its attributes.
        T_volume_camera: float64 [4, 4].
        nearest, farthest: Depths [m] where rays begin and end.
        has_color: Whether colours are looked up.

    Returns:
        RayImages.

    Raises:
        ValueError: The camera stands beyond 2^20 blocks from the volume's origin.
    """
    rays = CameraRays(camera, T_volume_camera, nearest, farthest, seen.blocks)
    images = RayImages(camera.width * camera.height, seen.neighbors.device)
    launch(cast_rays_kernel, rays.nears.size * TILE * TILE, [rays, seen, mark_backs(seen), int(has_color), images])
    return images
