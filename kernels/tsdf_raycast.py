"""What a camera would see of a volume: depth, points, normals and colours by ray casting.

One thread a pixel. A ray jumps over blocks that are not there, walks by the nearest voxel's distance where it is, and at
the change of sign finds the zero of the trilinear field by two secant steps. Newcombe et al., "KinectFusion", ISMAR 2011,
section 3.4.
"""

import math

from .block_rows import voxel_near
from .hash_table import find_position
from .lang import (
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
from .memory import empty
from .transform import narrow
from .tsdf import COLOR_SCALE
from .tsdf_blocks import SIDE, block_key

NAN = math.nan
MAX_STEPS = 4096  # of a ray: 80 m through unbroken free space at 2 cm a voxel
STEP = 0.7  # of the distance: a mean of projective distances may overstate the true one
UNSEEN = 2.0  # no truncated distance is beyond 1
NUDGE = 1.0e-3  # voxels past the face of an absent block


@func
def floor_div(a: int, b: int) -> int:
    """a / b rounded down, for positive b and any a."""
    q = a // b
    if a < 0:
        q = -((-a + b - 1) // b)
    return q


@func
def block_at(cell: vec3i, mask: int64, keys: array(dtype=int64), positions: array(dtype=int32)) -> int:
    """The block of a voxel, or -1."""
    key = block_key(floor_div(cell[0], SIDE), floor_div(cell[1], SIDE), floor_div(cell[2], SIDE))
    return find_position(keys, positions, mask, key)


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
def zero_between(before: float, before_d: float, here: float, here_d: float) -> float:
    """Where the line through two distances of different sign is zero."""
    return before + (here - before) * before_d / (before_d - here_d)


@func
def exit_parameter(p: vec3, ray: vec3, corner: vec3i) -> float:
    """How far along a ray, from p, the block with this low corner ends; all in voxels."""
    t = float(1.0e30)
    for axis in range(3):
        if ray[axis] > 1.0e-12:
            t = min(t, (float(corner[axis] + SIDE) - p[axis]) / ray[axis])
        if ray[axis] < -1.0e-12:
            t = min(t, (float(corner[axis]) - p[axis]) / ray[axis])
    return max(t, 0.0) + NUDGE


@kernel
def cast_rays_kernel(
    width: int,
    camera: vec4d,
    R: mat33d,
    t: vec3d,
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
    """One ray; the parameter is depth along z [m]. R, t: camera to volume."""
    i = tid()
    u = float64(i % width)
    v = float64(i // width)
    ray_d = R @ vec3d((u - camera[2]) / camera[0], (v - camera[3]) / camera[1], float64(1.0)) / voxel_size
    ray = narrow(ray_d)
    start = narrow(t / voxel_size)
    slope = sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2])  # voxels a metre of depth
    here = nearest + 0.0
    before = float(0.0)
    before_d = float(UNSEEN)
    hit = float(0.0)
    steps = int(0)
    block = int(-1)
    corner = vec3i(0, 0, 0)
    while here <= farthest and steps < MAX_STEPS and hit == 0.0:
        steps += 1
        p = start + ray * here
        cell = floor_cell(p)
        block = block_at(cell, mask, keys, positions)
        if block < 0:
            corner = vec3i(floor_div(cell[0], SIDE), floor_div(cell[1], SIDE), floor_div(cell[2], SIDE)) * SIDE
            here += exit_parameter(p, ray, corner)
            before_d = float(UNSEEN)
        else:
            corner = vec3i(floor_div(cell[0], SIDE), floor_div(cell[1], SIDE), floor_div(cell[2], SIDE)) * SIDE
            d = seen_distance(distances, weights, threshold, nearest_voxel(p, block, corner, neighbors))
            if d <= 0.0 and before_d > 0.0 and before_d < UNSEEN:
                hit = zero_between(before, before_d, here, d)
                fine = sample_distance(start + ray * hit, block, corner, neighbors, distances, weights, threshold)
                if fine > 0.0 and fine < UNSEEN:
                    behind = sample_distance(p, block, corner, neighbors, distances, weights, threshold)
                    if behind <= 0.0:
                        hit = zero_between(hit, fine, here, behind)
                if fine <= 0.0:
                    q = start + ray * before
                    front = sample_distance(q, block, corner, neighbors, distances, weights, threshold)
                    if front > 0.0 and front < UNSEEN:
                        hit = zero_between(before, front, hit, fine)
            before = here
            before_d = d
            if d < UNSEEN:
                here += max(abs(d) * truncation * STEP, 0.25 / slope)
            else:
                here += 0.5 / slope
    depth[i] = 0.0
    points[i] = vec3(NAN, NAN, NAN)
    normals[i] = vec3(NAN, NAN, NAN)
    shades[i] = vec3(0.0, 0.0, 0.0)
    if hit > 0.0:
        p = start + ray * hit
        cell = floor_cell(p)
        block = block_at(cell, mask, keys, positions)
        if block >= 0:
            corner = vec3i(floor_div(cell[0], SIDE), floor_div(cell[1], SIDE), floor_div(cell[2], SIDE)) * SIDE
            n = vec3(0.0, 0.0, 0.0)
            for axis in range(3):
                e = vec3(0.0, 0.0, 0.0)
                e[axis] = 0.5
                a = sample_distance(p - e, block, corner, neighbors, distances, weights, threshold)
                b = sample_distance(p + e, block, corner, neighbors, distances, weights, threshold)
                if a < UNSEEN and b < UNSEEN:
                    n[axis] = b - a
            size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])
            if size > 0.0:
                n = n / size
            depth[i] = hit
            points[i] = p * float(voxel_size)
            normals[i] = n
            voxel = nearest_voxel(p, block, corner, neighbors)
            if has_color == 1 and voxel >= 0:
                shade = vec3(float(colors[voxel, 0]), float(colors[voxel, 1]), float(colors[voxel, 2]))
                shades[i] = shade / (255.0 * COLOR_SCALE)


def cast_rays(view, limits, sizes, table, neighbors, voxels, has_color):
    """Depth, points, normals and colours of each pixel.

    Args:
        view: (width, height, (fx, fy, cx, cy), T_volume_camera float64 [4, 4]).
        limits: (nearest, farthest, weight_threshold).
        sizes: (voxel_size, truncation) [m].
        table: The HashTable of the blocks.
        neighbors: From block_rows.find_neighbors.
        voxels: (distances, weights, colors).

    Returns:
        (depth float32, points, normals, colors vec3), each [height * width]; 0 and NaN where nothing is hit.
    """
    width, height, camera, T = view
    device = neighbors.device
    depth = empty(width * height, float32, device)
    points, normals, shades = (empty(width * height, vec3, device) for _ in range(3))
    R, t = mat33d(*T[:3, :3].ravel()), vec3d(*T[:3, 3])
    arguments = [width, vec4d(*camera), R, t, *sizes, *limits, *table.arguments, neighbors, *voxels, int(has_color)]
    launch(cast_rays_kernel, width * height, [*arguments, depth, points, normals, shades])
    return depth, points, normals, shades
