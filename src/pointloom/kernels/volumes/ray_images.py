"""Points, normals, colors and intensity at the ray hits of a volume.

Normals are gradients of the trilinear distance over one voxel, colors those of the nearest voxel, intensities trilinear
means of observed voxels, which are differentiable.
"""

from collections.abc import Sequence
from typing import Any

from ..array_types import Device, Scalars, Vectors
from ..arrays.block_keys import key_block
from ..lang import NAN, array, float32, func, int32, kernel, launch, mat33d, sqrt, struct, tid, vec3
from ..memory import empty
from .block_rows import SeenBlocks
from .camera_rays import CameraRays, ray_of
from .tsdf_blocks import BLOCK_SIDE
from .voxel_blocks import COLOR_SCALE, voxel_color
from .voxel_samples import (
    UNSEEN_DISTANCE,
    between,
    cell_voxels,
    corner_distances,
    cube,
    floor_cell,
    greatest,
    nearest_voxel,
    octet,
    seen_distance,
    to_float,
    voxel_around,
)


@struct
class RayImages:
    """Rendered images [h * w]. Images not requested have one element. `depth` is along z [m], 0 without a hit, `met`
    the block of the hit. `points` and `normals` are NaN, `colors` and `intensities` (0..1) 0 without a hit. `fractions`
    are the weights of red, green and blue in intensity; `in_camera` selects the frame of normals."""

    depth: array(dtype=float32)
    met: array(dtype=int32)
    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    colors: array(dtype=vec3)
    intensities: array(dtype=float32)
    fractions: vec3
    has_points: int
    has_normals: int
    has_colors: int
    has_intensities: int
    in_camera: int

    def __init__(
        self,
        count: int,
        device: Device,
        *,
        points: bool = False,
        normals: bool = True,
        colors: bool = False,
        fractions: Sequence[float] | None = None,
        in_camera: bool = False,
    ) -> None:
        """Intensity is rendered if its `fractions` are given."""

        def room(dtype: Any, is_wanted: bool) -> Scalars | Vectors:
            return empty(count if is_wanted else 1, dtype, device)

        self.has_points, self.has_colors, self.has_intensities = int(points), int(colors), int(fractions is not None)
        self.has_normals = int(normals)
        self.in_camera, self.fractions = int(in_camera), vec3(*(fractions or (0.0, 0.0, 0.0)))
        self.depth, self.met = empty(count, float32, device), empty(count, int32, device)
        self.points, self.normals, self.colors = room(vec3, points), room(vec3, normals), room(vec3, colors)
        self.intensities = room(float32, fractions is not None)


@func
def side_distance(block: int, x: int, y: int, z: int, seen: SeenBlocks) -> float:
    """Distance at a voxel next to a cell, coordinates in -8..15. UNSEEN if not observed often enough."""
    return seen_distance(voxel_around(block, x, y, z, seen), seen)


@func
def slope_along(low: float, high: float, beyond: float, middle: float, fraction: float, is_up: int) -> float:
    """Slope over one voxel, centered at `fraction` between two planes with distances `low` and `high`. `beyond` is
    the third plane's distance (above if `is_up`). If UNSEEN, the slope over the other half voxel is used."""
    slope = float(UNSEEN_DISTANCE)
    if is_up == 1:
        before = between(low, high, fraction - 0.5)
        slope = 2.0 * (middle - before)
        if beyond < UNSEEN_DISTANCE:
            slope = between(high, beyond, fraction - 0.5) - before
    else:
        behind = between(low, high, fraction + 0.5)
        slope = 2.0 * (behind - middle)
        if beyond < UNSEEN_DISTANCE:
            slope = behind - between(beyond, low, fraction + 0.5)
    return slope


@func
def mean_of_four(a: float, b: float, c: float, d: float, fu: float, fv: float) -> float:
    """Bilinear interpolation, v fastest. UNSEEN if one value is."""
    mean = between(between(a, b, fv), between(c, d, fv), fu)
    if max(max(a, b), max(c, d)) >= UNSEEN_DISTANCE:
        mean = float(UNSEEN_DISTANCE)
    return mean


@func
def slopes_at(block: int, x: int, y: int, z: int, f: vec3, c: octet, seen: SeenBlocks) -> vec3:
    """Slopes of the trilinear distance over one voxel at a position f (0..1) in an observed cell with corner distances
    c; reads four more voxels per axis."""
    up_x = int(f[0] >= 0.5)
    up_y = int(f[1] >= 0.5)
    up_z = int(f[2] >= 0.5)
    bx = x - 1 + 3 * up_x
    by = y - 1 + 3 * up_y
    bz = z - 1 + 3 * up_z
    c00 = between(c[0], c[1], f[2])  # at each corner x, y
    c01 = between(c[2], c[3], f[2])
    c10 = between(c[4], c[5], f[2])
    c11 = between(c[6], c[7], f[2])
    low_x = between(c00, c01, f[1])
    high_x = between(c10, c11, f[1])
    middle = between(low_x, high_x, f[0])
    far_x = octet(UNSEEN_DISTANCE)
    for k in range(4):
        far_x[k] = side_distance(block, bx, y + (k >> 1), z + (k & 1), seen)
    far_y = octet(UNSEEN_DISTANCE)
    for k in range(4):
        far_y[k] = side_distance(block, x + (k >> 1), by, z + (k & 1), seen)
    far_z = octet(UNSEEN_DISTANCE)
    for k in range(4):
        far_z[k] = side_distance(block, x + (k >> 1), y + (k & 1), bz, seen)
    beyond_x = mean_of_four(far_x[0], far_x[1], far_x[2], far_x[3], f[1], f[2])
    beyond_y = mean_of_four(far_y[0], far_y[1], far_y[2], far_y[3], f[0], f[2])
    beyond_z = mean_of_four(far_z[0], far_z[1], far_z[2], far_z[3], f[0], f[1])
    low_z = between(between(c[0], c[2], f[1]), between(c[4], c[6], f[1]), f[0])
    high_z = between(between(c[1], c[3], f[1]), between(c[5], c[7], f[1]), f[0])
    return vec3(
        slope_along(low_x, high_x, beyond_x, middle, f[0], up_x),
        slope_along(between(c00, c10, f[0]), between(c01, c11, f[0]), beyond_y, middle, f[1], up_y),
        slope_along(low_z, high_z, beyond_z, middle, f[2], up_z),
    )


@func
def brightness_of(voxels: cube, f: vec3, seen: SeenBlocks, fractions: vec3) -> float:
    total = 0.0
    weight = 0.0
    n = int(8)
    for c in range(n):
        voxel = voxels[c]
        if voxel >= 0:
            if float(seen.blocks.weights[voxel]) > seen.threshold:
                fx = abs(float(1 - (c >> 2)) - f[0])
                fy = abs(float(1 - ((c >> 1) & 1)) - f[1])
                fraction = fx * fy * abs(float(1 - (c & 1)) - f[2])
                shade = voxel_color(voxel, seen.blocks)
                total += fraction * (fractions[0] * shade[0] + fractions[1] * shade[1] + fractions[2] * shade[2])
                weight += fraction
    bright = 0.0
    if weight > 0.0:
        bright = total / (weight * (255.0 * COLOR_SCALE))
    return bright


@func
def rotated_back(v: vec3, R: mat33d) -> vec3:
    return vec3(
        float(R[0, 0]) * v[0] + float(R[1, 0]) * v[1] + float(R[2, 0]) * v[2],
        float(R[0, 1]) * v[0] + float(R[1, 1]) * v[1] + float(R[2, 1]) * v[2],
        float(R[0, 2]) * v[0] + float(R[1, 2]) * v[1] + float(R[2, 2]) * v[2],
    )


@kernel(max_registers=128)
def shade_hits_kernel(rays: CameraRays, seen: SeenBlocks, images: RayImages):
    i = tid()
    if images.has_points == 1:
        images.points[i] = vec3(NAN, NAN, NAN)
    if images.has_colors == 1:
        images.colors[i] = vec3(0.0, 0.0, 0.0)
    if images.has_intensities == 1:
        images.intensities[i] = 0.0
    normal = vec3(NAN, NAN, NAN)
    hit = images.depth[i]
    if hit > 0.0:
        p = rays.start + ray_of(i % rays.camera.width, i // rays.camera.width, rays) * hit
        block = images.met[i]
        corner = key_block(seen.blocks.keys[block]) * BLOCK_SIDE - rays.base
        if images.has_points == 1:
            images.points[i] = (p + to_float(rays.base)) * float(seen.blocks.voxel_size)
        cell = floor_cell(p)
        f = p - to_float(cell)
        x = cell[0] - corner[0]
        y = cell[1] - corner[1]
        z = cell[2] - corner[2]
        voxels = cell_voxels(block, x, y, z, seen)
        corners = octet(UNSEEN_DISTANCE)
        if images.has_normals == 1:
            corners = corner_distances(voxels, seen)
        if greatest(corners) < UNSEEN_DISTANCE:
            g = slopes_at(block, x, y, z, f, corners, seen)
            size = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2])
            if size > 0.0:
                normal = g / size
                if images.in_camera == 1:
                    normal = rotated_back(normal, rays.R)
        if images.has_colors == 1:
            voxel = nearest_voxel(p, block, corner, seen)
            if voxel >= 0:
                images.colors[i] = voxel_color(voxel, seen.blocks) / (255.0 * COLOR_SCALE)
        if images.has_intensities == 1:
            images.intensities[i] = brightness_of(voxels, f, seen, images.fractions)
    if images.has_normals == 1:
        images.normals[i] = normal


def shade_hits(rays: CameraRays, seen: SeenBlocks, images: RayImages) -> None:
    """Render the requested images from depth and `met`."""
    if images.has_points or images.has_normals or images.has_colors or images.has_intensities:
        launch(shade_hits_kernel, images.depth.size, [rays, seen, images])
