"""Depth and colour of a scene of solids as a pinhole camera sees it.

Rays meet the solids exactly (primitives.py), so depth is true to float32. One thread first lists for a tile of 16 x 16
pixels the solids whose bounding spheres its cone touches; then one thread a pixel tries those, some 20 of 200, at about
60 operations each. Colours are diffuse (room_light.py) and belong to the place, not to the view.
"""

import numpy as np

from ..lang import (
    INFINITY,
    acos,
    array,
    asin,
    dot,
    float32,
    float64,
    floor,
    func,
    int32,
    kernel,
    launch,
    length,
    mat33d,
    normalize,
    sqrt,
    tid,
    uint8,
    vec2,
    vec3,
    vec3d,
    vec3i,
    vec4d,
)
from ..memory import empty, upload
from .primitives import meet_solid, scene_normal
from .room_light import LightGrid, light_surface

TILE = 16  # [px] smaller tiles list fewer solids, larger ones cost fewer lists; 8 and 32 were slower
TILE_SIZE = float(TILE)
PLAIN = 0
CHECKER = 1
STRIPES = 2
PLANKS = 3
GLOW = 4  # shines by itself
SEAM = 0.137  # moves the seams of patterns off the faces of the solids, where rounding would choose the side
PLANK_LENGTH = 5.0  # widths of a plank


@func
def pattern_weight(q: vec3, kind: int, size: float) -> float:
    """The share of the second colour at a point in a solid's frame."""
    u = q / size + vec3(SEAM, SEAM, SEAM)
    weight = float(0.0)
    if kind == CHECKER:
        total = floor(u[0]) + floor(u[1]) + floor(u[2])
        weight = total - 2.0 * floor(total * 0.5)
    elif kind == STRIPES:
        weight = floor(u[0]) - 2.0 * floor(u[0] * 0.5)
    elif kind == PLANKS:
        row = floor(u[1])
        place = u[0] / PLANK_LENGTH + row * 0.381966
        plank = floor(place) * 7.13 + row * 3.71
        weight = 0.75 * (plank * 0.618034 - floor(plank * 0.618034))
        if u[1] - row < 0.04 or (place - floor(place)) * PLANK_LENGTH < 0.04:
            weight = 1.0
    return weight


@func
def pixel_ray(column: float64, row: float64, focal: vec4d) -> vec3d:
    """The direction with depth 1 through a pixel, in the camera's frame; focal is (fx, fy, cx, cy)."""
    return vec3d((column - focal[2]) / focal[0], (row - focal[3]) / focal[1], float64(1.0))


@kernel
def list_solids_kernel(
    columns: int,
    focal: vec4d,
    rotation: mat33d,
    eye: vec3d,
    centers: array(dtype=vec3d),
    extents: array(dtype=vec4d),
    lists: array(dtype=int32),
    counts: array(dtype=int32),
):
    """For each tile the solids whose bounding spheres touch the cone about its four corners."""
    i = tid()
    x0 = float64((i % columns) * TILE) - float64(0.5)
    y0 = float64((i // columns) * TILE) - float64(0.5)
    size = float64(TILE_SIZE)
    middle = normalize(pixel_ray(x0 + size * float64(0.5), y0 + size * float64(0.5), focal))
    cosine = float64(1.0)
    for corner in range(4):
        x = x0 + size * float64(corner % 2)
        y = y0 + size * float64(corner // 2)
        cosine = min(cosine, dot(middle, normalize(pixel_ray(x, y, focal))))
    half_angle = acos(cosine)
    axis = rotation @ middle
    count = int(0)
    for s in range(centers.shape[0]):
        way = centers[s] - eye
        e = extents[s]
        radius = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) + e[3]
        distance = length(way)
        touched = int(1)
        if distance > radius:
            angle = acos(min(max(dot(axis, way) / distance, float64(-1.0)), float64(1.0)))
            if angle > half_angle + asin(radius / distance) + float64(1.0e-6):
                touched = 0
        if touched == 1:
            lists[i * centers.shape[0] + count] = s
            count += 1
    counts[i] = count


@func
def color_byte(value: float) -> uint8:
    """A share of 255, rounded."""
    return uint8(int(min(max(value, 0.0), 1.0) * 255.0 + 0.5))


@kernel
def render_pixels_kernel(
    columns: int,
    width: int,
    focal: vec4d,
    rotation: mat33d,
    eye: vec3d,
    lists: array(dtype=int32),
    counts: array(dtype=int32),
    rotations: array(dtype=mat33d),
    centers: array(dtype=vec3d),
    extents: array(dtype=vec4d),
    kinds: array(dtype=int32),
    paints: array(dtype=vec3),
    patterns: array(dtype=vec2),
    lamp: vec3,
    size: vec3i,
    low: vec3,
    step: float,
    grid: array(dtype=vec2),
    depth: array(dtype=float32),
    incidence: array(dtype=float32),
    colors: array(dtype=uint8),
):
    """Depth, the cosine between view and normal, and colour of each pixel; zeros where there is nothing."""
    i = tid()
    column = i % width
    row = i // width
    tile = (row // TILE) * columns + column // TILE
    view = pixel_ray(float64(column), float64(row), focal)
    ray = rotation @ view
    t = float64(INFINITY)
    solid = int(-1)
    for j in range(counts[tile]):
        s = lists[tile * kinds.shape[0] + j]
        met = meet_solid(rotations[s] @ (eye - centers[s]), rotations[s] @ ray, extents[s], kinds[s], t)
        if met < t:
            t = met
            solid = s
    red = float(0.0)
    green = float(0.0)
    blue = float(0.0)
    z = float(0.0)
    cosine = float(0.0)
    if solid >= 0:
        p = eye + ray * t
        normal = scene_normal(p, solid, rotations, centers, extents, kinds)
        q = rotations[solid] @ (p - centers[solid])
        z = float32(t)
        cosine = float32(-dot(normal, ray) / length(ray))
        place = vec3(float32(p[0]), float32(p[1]), float32(p[2]))
        n = vec3(float32(normal[0]), float32(normal[1]), float32(normal[2]))
        light = light_surface(place, n, lamp, size, low, step, grid)
        pattern = patterns[solid]
        if int(pattern[0]) == GLOW:
            light = 1.0
        local = vec3(float32(q[0]), float32(q[1]), float32(q[2]))
        weight = pattern_weight(local, int(pattern[0]), pattern[1])
        color = (paints[2 * solid] * (1.0 - weight) + paints[2 * solid + 1] * weight) * light
        red = color[0]
        green = color[1]
        blue = color[2]
    depth[i] = z
    incidence[i] = cosine
    colors[3 * i] = color_byte(red)
    colors[3 * i + 1] = color_byte(green)
    colors[3 * i + 2] = color_byte(blue)


class Room:
    """A scene of solids with colours and a lamp, ready to be looked at.

    Args:
        solids: The solids.
        paints: Two colours a solid, float32 [n, 2, 3], 0 to 1.
        patterns: Kind (PLAIN, CHECKER, STRIPES, PLANKS, GLOW) and size [m] a solid, float32 [n, 2].
        lamp: Place of the lamp, [3] [m].
        low, high: The box in which corners and shadows are felt, [3] [m].
        step: Spacing of the grid that they are read from [m].
    """

    def __init__(self, solids, paints, patterns, *, lamp, low, high, step=0.05):
        device = solids.device
        self.solids, self.device = solids, device
        self.paints = upload(np.asarray(paints).reshape(-1, 3), vec3, device)
        self.patterns = upload(np.asarray(patterns), vec2, device)
        self.light = LightGrid(solids, lamp=lamp, low=low, high=high, step=step)

    def render(self, width, height, focal, T_world_camera):
        """What a pinhole camera sees.

        Args:
            width, height: Size of the picture [px].
            focal: (fx, fy, cx, cy) [px].
            T_world_camera: Camera to world, float64 [4, 4].

        Returns:
            (depth, incidence, colors): float32 [h * w] along the optical axis [m], 0 where there is nothing; the
            cosine between view and normal, float32 [h * w]; uint8 [3 * h * w]. Device arrays, the same bits each time.
        """
        solids, device = self.solids, self.device
        columns, rows = -(-width // TILE), -(-height // TILE)
        lists, counts = empty(columns * rows * solids.count, int32, device), empty(columns * rows, int32, device)
        rotation, eye = mat33d(*T_world_camera[:3, :3].ravel()), vec3d(*T_world_camera[:3, 3])
        camera = [vec4d(*focal), rotation, eye]
        arguments = [columns, *camera, solids.centers, solids.extents, lists, counts]
        launch(list_solids_kernel, columns * rows, arguments)
        depth, incidence = empty(width * height, float32, device), empty(width * height, float32, device)
        colors = empty(3 * width * height, uint8, device)
        arguments = [columns, width, *camera, lists, counts, *solids.arrays, self.paints, self.patterns]
        launch(render_pixels_kernel, width * height, [*arguments, *self.light.arguments, depth, incidence, colors])
        return depth, incidence, colors
