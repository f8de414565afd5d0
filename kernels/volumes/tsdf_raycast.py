"""What a camera would see of a volume: depth, points, normals and colours by ray casting.

One thread a pixel. A ray jumps over blocks that are not there and walks the others by the nearest voxel's distance, no
more than a voxel at a time: distances along z overstate the way to a surface seen at a grazing angle, and a wall is as
thin as one voxel in its truncation. Near the surface the trilinear field decides, and at its change of sign three
steps of regula falsi find the zero. Positions count from the camera's own voxel, so that float32 is exact far from the
volume's origin. Newcombe et al., "KinectFusion", ISMAR 2011, section 3.4.
"""

import numpy as np

from ..algebra.camera import Camera, pixel_ray
from ..algebra.transform import narrow
from ..arrays.block_keys import BIAS, block_key
from ..arrays.hash_table import find_position
from ..lang import (
    NAN,
    array,
    float32,
    float64,
    floor,
    func,
    kernel,
    launch,
    mat33d,
    sqrt,
    struct,
    tid,
    vec3,
    vec3i,
    vec4,
)
from ..memory import download, empty
from .block_rows import SeenBlocks, voxel_near
from .tsdf_blocks import SIDE, block_box
from .voxel_blocks import COLOR_SCALE, voxel_color

MAX_STEPS = 8192  # of a ray: 80 m through unbroken free space at 1 cm a voxel
STEP = 0.7  # of the distance: a mean of projective distances may overstate the true one
LONGEST = 1.0  # [voxels] longest step through seen space; 2 passed a wall fused at 75 degrees with 2 voxels' truncation
SHORTEST = 0.25  # [voxels] and through seen space next to the surface
SEARCH = 0.5  # [voxels] step through unseen voxels of a block
NEAR = 1.5  # [voxels] where the trilinear distance takes over from the nearest voxel's
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
def sample_distance(p: vec3, block: int, corner: vec3i, seen: SeenBlocks) -> float:
    """The trilinear truncated distance at a point in voxels; UNSEEN where one of the 8 voxels is."""
    cell = floor_cell(p)
    fx = p[0] - float(cell[0])
    fy = p[1] - float(cell[1])
    fz = p[2] - float(cell[2])
    x = cell[0] - corner[0]
    y = cell[1] - corner[1]
    z = cell[2] - corner[2]
    total = float(0.0)
    for c in range(8):
        dx = c & 1
        dy = (c >> 1) & 1
        dz = (c >> 2) & 1
        d = seen_distance(voxel_near(block, x + dx, y + dy, z + dz, seen), seen)
        wx = fx
        if dx == 0:
            wx = 1.0 - fx
        wy = fy
        if dy == 0:
            wy = 1.0 - fy
        wz = fz
        if dz == 0:
            wz = 1.0 - fz
        if d == UNSEEN:
            total = UNSEEN * 8.0
        total += d * wx * wy * wz
    if total > 1.5:
        total = UNSEEN
    return total


@func
def nearest_voxel(p: vec3, block: int, corner: vec3i, seen: SeenBlocks) -> int:
    """The voxel nearest to a point in voxels, or -1."""
    cell = floor_cell(p + vec3(0.5, 0.5, 0.5))
    return voxel_near(block, cell[0] - corner[0], cell[1] - corner[1], cell[2] - corner[2], seen)


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
def slope_across(p: vec3, axis: int, middle: float, block: int, corner: vec3i, seen: SeenBlocks) -> float:
    """The trilinear distance's slope along an axis, one-sided beside unseen voxels; UNSEEN between them."""
    e = vec3(0.0, 0.0, 0.0)
    e[axis] = 0.5
    a = sample_distance(p - e, block, corner, seen)
    b = sample_distance(p + e, block, corner, seen)
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
def entry_parameter(p: vec3, ray: vec3, low: vec3, high: vec3) -> float:
    """How far along a ray, from p, a box begins; beyond its end where the ray passes it by."""
    t = float(-1.0e30)
    for axis in range(3):
        if ray[axis] > 1.0e-12:
            t = max(t, (low[axis] - p[axis]) / ray[axis])
        if ray[axis] < -1.0e-12:
            t = max(t, (high[axis] - p[axis]) / ray[axis])
        if abs(ray[axis]) <= 1.0e-12 and (p[axis] < low[axis] or p[axis] > high[axis]):
            t = float(1.0e30)
    return t


@func
def block_corner(p: vec3, base: vec3i) -> vec3i:
    """The low voxel of the block around a point, counted like the point from the voxel `base`."""
    cell = floor_cell(p) + base
    return vec3i(cell[0] // SIDE, cell[1] // SIDE, cell[2] // SIDE) * SIDE - base


@func
def to_float(v: vec3i) -> vec3:
    """The same vector in float32."""
    return vec3(float(v[0]), float(v[1]), float(v[2]))


@struct
class Rays:
    """The rays of a camera into a volume; places count in voxels from the camera's own voxel.

    Attributes:
        camera: A Camera, or what has its attributes.
        R: Camera to volume.
        base: The camera's own voxel.
        start: The camera.
        low, high: The box of all blocks.
        nearest, farthest: Depths [m] where rays begin and end.
    """

    camera: Camera
    R: mat33d
    base: vec3i
    start: vec3
    low: vec3
    high: vec3
    nearest: float
    farthest: float

    def __init__(self, camera, T_volume_camera, nearest, farthest, blocks):
        self.camera, self.nearest, self.farthest = camera, nearest, farthest
        place = T_volume_camera[:3, 3] / blocks.voxel_size
        if np.abs(place).max() >= BIAS * SIDE:
            raise ValueError(
                f"extrinsic: the camera is {np.abs(T_volume_camera[:3, 3]).max():.0f} m from the volume's origin; "
                f"at {blocks.voxel_size} m a voxel the limit is {BIAS * SIDE * blocks.voxel_size:.0f} m"
            )
        base = np.floor(place)
        boxes = block_box(download(blocks.keys[: blocks.count])) if blocks.count else np.zeros((1, 3), np.int64)  # sync
        self.R, self.base, self.start = mat33d(*T_volume_camera[:3, :3].ravel()), vec3i(*base.astype(int)), place - base
        self.low, self.high = boxes.min(axis=0) * SIDE - base - 1, (boxes.max(axis=0) + 1) * SIDE - base + 1


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
def zero_on_ray(ends: vec4, ray: vec3, block: int, corner: vec3i, rays: Rays, seen: SeenBlocks, near: float) -> float:
    """The parameter at which the distance along a ray is zero, by three steps of regula falsi.

    `ends` holds a parameter before it and the positive distance there, then one behind it and the distance there.
    """
    a = ends[0]
    a_d = ends[1]
    b = ends[2]
    b_d = ends[3]
    for k in range(3):
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
    rays: Rays,
    seen: SeenBlocks,
    has_color: int,
    images: RayImages,
):
    """Write what is seen where a ray meets the surface, at a point p in voxels."""
    images.depth[i] = hit
    images.points[i] = (p + to_float(rays.base)) * float(seen.blocks.voxel_size)
    middle = sample_distance(p, block, corner, seen)
    gx = slope_across(p, 0, middle, block, corner, seen)
    gy = slope_across(p, 1, middle, block, corner, seen)
    gz = slope_across(p, 2, middle, block, corner, seen)
    size = sqrt(gx * gx + gy * gy + gz * gz)
    if max(gx, max(gy, gz)) < UNSEEN and size > 0.0:
        images.normals[i] = vec3(gx, gy, gz) / size
    voxel = nearest_voxel(p, block, corner, seen)
    if has_color == 1 and voxel >= 0:
        images.colors[i] = voxel_color(voxel, seen.blocks) / (255.0 * COLOR_SCALE)


@kernel
def cast_rays_kernel(rays: Rays, seen: SeenBlocks, has_color: int, images: RayImages):
    """One ray; the parameter is depth along z [m]."""
    i = tid()
    u = float64(i % rays.camera.width)
    v = float64(i // rays.camera.width)
    voxel_size = seen.blocks.voxel_size
    ray = narrow(rays.R @ pixel_ray(u, v, rays.camera) / voxel_size)
    voxel_depth = 1.0 / sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2])  # [m] of depth a voxel
    reach = float(seen.blocks.truncation) / float(voxel_size)  # voxels
    near = NEAR / reach
    here = max(rays.nearest, entry_parameter(rays.start, ray, rays.low, rays.high))
    last = min(rays.farthest, exit_parameter(rays.start, ray, rays.low, rays.high))
    before = float(0.0)
    before_d = float(UNSEEN)
    hit = float(0.0)
    steps = int(0)
    block = int(-1)
    corner = vec3i(NOWHERE, NOWHERE, NOWHERE)
    while here <= last and steps < MAX_STEPS and hit == 0.0:
        steps += 1
        p = rays.start + ray * here
        now = block_corner(p, rays.base)
        if now[0] != corner[0] or now[1] != corner[1] or now[2] != corner[2]:
            corner = now
            low = now + rays.base
            key = block_key(low[0] // SIDE, low[1] // SIDE, low[2] // SIDE)
            block = find_position(key, seen.blocks.table)
        d = float(UNSEEN)
        if block >= 0:
            d = distance_near(p, block, corner, seen, near)
        step = SEARCH * voxel_depth
        if d == UNSEEN:
            before_d = float(UNSEEN)
            if block < 0:
                high = to_float(corner + vec3i(SIDE, SIDE, SIDE))
                step = max(exit_parameter(p, ray, to_float(corner), high), 0.0) + NUDGE * voxel_depth
        else:
            if d <= 0.0 and before_d < UNSEEN:
                ends = vec4(before, before_d, here, d)
                hit = zero_on_ray(ends, ray, block, corner, rays, seen, near)
            step = min(max(abs(d) * reach * STEP, SHORTEST), LONGEST) * voxel_depth
            before = here + 0.0
            before_d = d + 0.0
            if d <= 0.0:
                before_d = float(UNSEEN)  # behind a surface: only its front is looked for
        here += step
    images.depth[i] = 0.0
    images.points[i] = vec3(NAN, NAN, NAN)
    images.normals[i] = vec3(NAN, NAN, NAN)
    images.colors[i] = vec3(0.0, 0.0, 0.0)
    if hit > 0.0:
        p = rays.start + ray * hit
        write_hit(i, hit, p, block, corner, rays, seen, has_color, images)


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
    rays = Rays(camera, T_volume_camera, nearest, farthest, seen.blocks)
    images = RayImages(camera.width * camera.height, seen.neighbors.device)
    launch(cast_rays_kernel, images.depth.size, [rays, seen, int(has_color), images])
    return images
