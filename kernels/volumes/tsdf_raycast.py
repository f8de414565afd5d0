"""What a camera would see of a volume: depth, points, normals and colours by ray casting.

One thread a pixel. A ray jumps over blocks that are not there and walks the others by the nearest voxel's distance, no
more than a voxel at a time: distances along z overstate the way to a surface seen at a grazing angle, and a wall is as
thin as one voxel in its truncation. Near the surface the trilinear field decides, and at its change of sign three
steps of regula falsi find the zero. Positions count from the camera's own voxel, so that float32 is exact far from the
volume's origin. Newcombe et al., "KinectFusion", ISMAR 2011, section 3.4.
"""

import numpy as np

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
    int32,
    int64,
    kernel,
    launch,
    mat33d,
    sqrt,
    tid,
    uint16,
    vec3,
    vec3d,
    vec3i,
    vec4d,
)
from ..memory import empty
from .block_rows import voxel_near
from .integrate import COLOR_SCALE
from .tsdf_blocks import SIDE, block_box

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
def seen_distance(distances: array(dtype=float32), weights: array(dtype=uint16), threshold: float, voxel: int) -> float:
    """The truncated distance at a voxel, UNSEEN where there is none."""
    d = float(UNSEEN)
    if voxel >= 0:
        if float(weights[voxel]) > threshold:
            d = distances[voxel]
    return d


@func
def sample_distance(
    p: vec3,
    block: int,
    corner: vec3i,
    neighbors: array(dtype=int32),
    distances: array(dtype=float32),
    weights: array(dtype=uint16),
    threshold: float,
) -> float:
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
        d = seen_distance(distances, weights, threshold, voxel_near(neighbors, block, x + dx, y + dy, z + dz))
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
def nearest_voxel(p: vec3, block: int, corner: vec3i, neighbors: array(dtype=int32)) -> int:
    """The voxel nearest to a point in voxels, or -1."""
    cell = floor_cell(p + vec3(0.5, 0.5, 0.5))
    return voxel_near(neighbors, block, cell[0] - corner[0], cell[1] - corner[1], cell[2] - corner[2])


@func
def distance_near(
    p: vec3,
    block: int,
    corner: vec3i,
    neighbors: array(dtype=int32),
    distances: array(dtype=float32),
    weights: array(dtype=uint16),
    threshold: float,
    near: float,
) -> float:
    """The distance at a point: the nearest voxel's, and below `near` the trilinear one where all 8 voxels are seen."""
    d = seen_distance(distances, weights, threshold, nearest_voxel(p, block, corner, neighbors))
    if abs(d) < near:
        fine = sample_distance(p, block, corner, neighbors, distances, weights, threshold)
        if fine < UNSEEN:
            d = fine
    return d


@func
def zero_between(before: float, before_d: float, here: float, here_d: float) -> float:
    """Where the line through two distances of different sign is zero."""
    return before + (here - before) * before_d / (before_d - here_d)


@func
def slope_across(
    p: vec3,
    axis: int,
    middle: float,
    block: int,
    corner: vec3i,
    neighbors: array(dtype=int32),
    distances: array(dtype=float32),
    weights: array(dtype=uint16),
    threshold: float,
) -> float:
    """The trilinear distance's slope along an axis, one-sided beside unseen voxels; UNSEEN between them."""
    e = vec3(0.0, 0.0, 0.0)
    e[axis] = 0.5
    a = sample_distance(p - e, block, corner, neighbors, distances, weights, threshold)
    b = sample_distance(p + e, block, corner, neighbors, distances, weights, threshold)
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


@kernel
def cast_rays_kernel(
    width: int,
    camera: vec4d,
    R: mat33d,
    start: vec3,
    base: vec3i,
    box_low: vec3,
    box_high: vec3,
    voxel_size: float64,
    truncation: float,
    nearest: float,
    farthest: float,
    threshold: float,
    mask: int64,
    keys: array(dtype=int64),
    positions: array(dtype=int32),
    neighbors: array(dtype=int32),
    distances: array(dtype=float32),
    weights: array(dtype=uint16),
    colors: array(dtype=uint16, ndim=2),
    has_color: int,
    depth: array(dtype=float32),
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    shades: array(dtype=vec3),
):
    """One ray; the parameter is depth along z [m]. R: camera to volume; start: camera, in voxels from voxel `base`."""
    i = tid()
    u = float64(i % width)
    v = float64(i // width)
    ray = narrow(R @ vec3d((u - camera[2]) / camera[0], (v - camera[3]) / camera[1], float64(1.0)) / voxel_size)
    voxel_depth = 1.0 / sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2])  # [m] of depth a voxel
    reach = truncation / float(voxel_size)  # voxels
    near = NEAR / reach
    here = max(nearest, entry_parameter(start, ray, box_low, box_high))
    last = min(farthest, exit_parameter(start, ray, box_low, box_high))
    before = float(0.0)
    before_d = float(UNSEEN)
    hit = float(0.0)
    steps = int(0)
    block = int(-1)
    corner = vec3i(NOWHERE, NOWHERE, NOWHERE)
    while here <= last and steps < MAX_STEPS and hit == 0.0:
        steps += 1
        p = start + ray * here
        now = block_corner(p, base)
        if now[0] != corner[0] or now[1] != corner[1] or now[2] != corner[2]:
            corner = now
            key = block_key((now[0] + base[0]) // SIDE, (now[1] + base[1]) // SIDE, (now[2] + base[2]) // SIDE)
            block = find_position(keys, positions, mask, key)
        d = float(UNSEEN)
        if block >= 0:
            d = distance_near(p, block, corner, neighbors, distances, weights, threshold, near)
        step = SEARCH * voxel_depth
        if d == UNSEEN:
            before_d = float(UNSEEN)
            if block < 0:
                high = to_float(corner + vec3i(SIDE, SIDE, SIDE))
                step = max(exit_parameter(p, ray, to_float(corner), high), 0.0) + NUDGE * voxel_depth
        else:
            if d <= 0.0 and before_d < UNSEEN:
                a = before + 0.0
                b = here + 0.0
                a_d = before_d + 0.0
                b_d = d + 0.0
                for k in range(3):
                    middle = zero_between(a, a_d, b, b_d)
                    q = start + ray * middle
                    m_d = distance_near(q, block, corner, neighbors, distances, weights, threshold, near)
                    if m_d > 0.0 and m_d < UNSEEN:
                        a = middle
                        a_d = m_d
                    if m_d <= 0.0:
                        b = middle
                        b_d = m_d
                hit = zero_between(a, a_d, b, b_d)
            step = min(max(abs(d) * reach * STEP, SHORTEST), LONGEST) * voxel_depth
            before = here + 0.0
            before_d = d + 0.0
            if d <= 0.0:
                before_d = float(UNSEEN)  # behind a surface: only its front is looked for
        here += step
    depth[i] = 0.0
    points[i] = vec3(NAN, NAN, NAN)
    normals[i] = vec3(NAN, NAN, NAN)
    shades[i] = vec3(0.0, 0.0, 0.0)
    if hit > 0.0:
        p = start + ray * hit
        depth[i] = hit
        points[i] = (p + to_float(base)) * float(voxel_size)
        middle = sample_distance(p, block, corner, neighbors, distances, weights, threshold)
        gx = slope_across(p, 0, middle, block, corner, neighbors, distances, weights, threshold)
        gy = slope_across(p, 1, middle, block, corner, neighbors, distances, weights, threshold)
        gz = slope_across(p, 2, middle, block, corner, neighbors, distances, weights, threshold)
        size = sqrt(gx * gx + gy * gy + gz * gz)
        if max(gx, max(gy, gz)) < UNSEEN and size > 0.0:
            normals[i] = vec3(gx, gy, gz) / size
        voxel = nearest_voxel(p, block, corner, neighbors)
        if has_color == 1 and voxel >= 0:
            shade = vec3(float(colors[voxel, 0]), float(colors[voxel, 1]), float(colors[voxel, 2]))
            shades[i] = shade / (255.0 * COLOR_SCALE)


def cast_rays(view, limits, sizes, block_keys, table, neighbors, voxels, has_color):
    """Depth, points, normals and colours of each pixel.

    Args:
        view: (width, height, (fx, fy, cx, cy), T_volume_camera float64 [4, 4]).
        limits: (nearest, farthest, weight_threshold).
        sizes: (voxel_size, truncation) [m].
        block_keys: int64 keys of all blocks.
        table: The HashTable of the keys.
        neighbors: From block_rows.find_neighbors.
        voxels: (distances, weights, colors).

    Returns:
        (depth float32, points, normals, colors vec3), each [height * width]; 0 and NaN where nothing is hit.

    Raises:
        ValueError: The camera stands beyond 2^20 blocks from the volume's origin.
    """
    width, height, camera, T = view
    device = neighbors.device
    place = T[:3, 3] / sizes[0]
    if np.abs(place).max() >= BIAS * SIDE:
        raise ValueError(
            f"extrinsic: the camera is {np.abs(T[:3, 3]).max():.0f} m from the volume's origin; "
            f"at {sizes[0]} m a voxel the limit is {BIAS * SIDE * sizes[0]:.0f} m"
        )
    base = np.floor(place)
    blocks = block_box(block_keys.numpy()) if block_keys.size else np.zeros((1, 3), np.int64)  # sync
    low, high = blocks.min(axis=0) * SIDE - base - 1, (blocks.max(axis=0) + 1) * SIDE - base + 1
    depth = empty(width * height, float32, device)
    points, normals, shades = (empty(width * height, vec3, device) for _ in range(3))
    R, start = mat33d(*T[:3, :3].ravel()), vec3(*(place - base))
    box = [vec3i(*base.astype(int)), vec3(*low), vec3(*high)]
    arguments = [width, vec4d(*camera), R, start, *box, *sizes, *limits, *table.arguments, neighbors, *voxels]
    launch(cast_rays_kernel, width * height, [*arguments, int(has_color), depth, points, normals, shades])
    return depth, points, normals, shades
