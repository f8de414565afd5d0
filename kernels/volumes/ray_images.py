"""The pictures of a volume that rays have met: points, normals, colours and brightness at their hits.

One thread a pixel. A normal is the gradient of the trilinear distance over one voxel; a colour is the nearest voxel's,
as it was seen; brightness is the trilinear mean of the seen voxels around, smooth enough to have slopes.
"""

from ..algebra.camera import pixel_ray
from ..algebra.transform import narrow
from ..arrays.block_keys import key_block
from ..lang import (
    NAN,
    array,
    float32,
    float64,
    func,
    int32,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    vec3,
    vec3i,
)
from ..memory import empty
from .block_rows import SeenBlocks, voxel_near
from .camera_rays import CameraRays
from .tsdf_blocks import SIDE
from .voxel_blocks import COLOR_SCALE, voxel_color
from .voxel_samples import UNSEEN, floor_cell, nearest_voxel, sample_distance, to_float


@struct
class RayImages:
    """What a camera sees, by pixel; pictures that are not asked for have one element.

    Attributes:
        depth: float32 [h * w] along z [m]; 0 where nothing is hit.
        met: int32 [h * w], the block in which the hit was found; any number where there is none.
        points: vec3 [h * w] in the volume's frame [m]; NaN where nothing is hit.
        normals: vec3 [h * w] in the volume's frame, or in the camera's; NaN where nothing is hit.
        colors: vec3 [h * w], 0 to 1; 0 where nothing is hit.
        intensities: float32 [h * w], brightness 0 to 1; 0 where nothing is hit.
        shares: Of red, green and blue in brightness.
        has_points, has_normals, has_colors, has_intensities: Which are made.
        in_camera: Whether normals are in the camera's frame.
    """

    depth: array(dtype=float32)
    met: array(dtype=int32)
    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    colors: array(dtype=vec3)
    intensities: array(dtype=float32)
    shares: vec3
    has_points: int
    has_colors: int
    has_intensities: int
    in_camera: int

    def __init__(self, count, device, *, points=False, colors=False, shares=None, in_camera=False):
        """Room for so many pixels; brightness is made where its `shares` are given."""

        def room(dtype, is_wanted):
            return empty(count if is_wanted else 1, dtype, device)

        self.has_points, self.has_colors, self.has_intensities = int(points), int(colors), int(shares is not None)
        self.in_camera, self.shares = int(in_camera), vec3(*(shares or (0.0, 0.0, 0.0)))
        self.depth, self.met = empty(count, float32, device), empty(count, int32, device)
        self.points, self.normals, self.colors = room(vec3, points), room(vec3, True), room(vec3, colors)
        self.intensities = room(float32, shares is not None)


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
def brightness_at(p: vec3, block: int, corner: vec3i, seen: SeenBlocks, shares: vec3) -> float:
    """The trilinear mean brightness of the seen voxels around a point; 0 where there are none."""
    cell = floor_cell(p)
    fx = p[0] - float(cell[0])
    fy = p[1] - float(cell[1])
    fz = p[2] - float(cell[2])
    total = float(0.0)
    weight = float(0.0)
    n = int(2)
    for dx in range(n):
        for dy in range(n):
            for dz in range(n):
                at = cell - corner + vec3i(dx, dy, dz)
                voxel = voxel_near(block, at[0], at[1], at[2], seen)
                if voxel >= 0:
                    if float(seen.blocks.weights[voxel]) > seen.threshold:
                        share = abs(float(1 - dx) - fx) * abs(float(1 - dy) - fy) * abs(float(1 - dz) - fz)
                        shade = voxel_color(voxel, seen.blocks)
                        total += share * (shares[0] * shade[0] + shares[1] * shade[1] + shares[2] * shade[2])
                        weight += share
    bright = float(0.0)
    if weight > 0.0:
        bright = total / (weight * (255.0 * COLOR_SCALE))
    return bright


@kernel
def shade_hits_kernel(rays: CameraRays, seen: SeenBlocks, images: RayImages):
    """The pictures of one pixel from its depth."""
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
        column = float64(i % rays.camera.width)
        row = float64(i // rays.camera.width)
        ray = narrow(rays.R @ pixel_ray(column, row, rays.camera) / seen.blocks.voxel_size)
        p = rays.start + ray * hit
        block = images.met[i]
        corner = key_block(seen.blocks.keys[block]) * SIDE - rays.base
        if images.has_points == 1:
            images.points[i] = (p + to_float(rays.base)) * float(seen.blocks.voxel_size)
        g = slopes_at(p, block, corner, seen)
        size = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2])
        if max(g[0], max(g[1], g[2])) < UNSEEN and size > 0.0:
            normal = g / size
            if images.in_camera == 1:
                normal = turned_back(normal, rays)
        voxel = nearest_voxel(p, block, corner, seen)
        if images.has_colors == 1 and voxel >= 0:
            images.colors[i] = voxel_color(voxel, seen.blocks) / (255.0 * COLOR_SCALE)
        if images.has_intensities == 1:
            images.intensities[i] = brightness_at(p, block, corner, seen, images.shares)
    images.normals[i] = normal


@func
def turned_back(v: vec3, rays: CameraRays) -> vec3:
    """A direction in the camera's frame, of one in the volume's."""
    R = rays.R
    return vec3(
        float(R[0, 0]) * v[0] + float(R[1, 0]) * v[1] + float(R[2, 0]) * v[2],
        float(R[0, 1]) * v[0] + float(R[1, 1]) * v[1] + float(R[2, 1]) * v[2],
        float(R[0, 2]) * v[0] + float(R[1, 2]) * v[1] + float(R[2, 2]) * v[2],
    )


def shade_hits(rays, seen, images):
    """Make the pictures that are asked for, from depth and `met`."""
    launch(shade_hits_kernel, images.depth.size, [rays, seen, images])
