"""Ray-traced depth and color of a scene of solids. Tiles of 16 x 16 pixels list the solids whose bounding spheres their
cones touch, then each pixel tests those. Light is diffuse: ambient light with corner darkening and a lamp with soft
shadows, from a coarse precomputed grid.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..algebra.camera import Camera, CameraLike, pixel_ray
from ..algebra.transform import Transform, narrow
from ..array_types import Bytes, Scalars
from ..drawing.shading import color_byte
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
    normalize,
    sqrt,
    struct,
    tid,
    uint8,
    vec2,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, upload
from .primitives import Solids, meet_solid, point_in_solid, scene_distance, scene_normal

AMBIENT_LIGHT = 0.54
SKY_LIGHT = 0.04  # additional ambient light from above
LAMP_LIGHT = 0.85
LAMP_RANGE = 3.2  # [m] distance at which the lamp's light has halved
LAMP_RADIUS = 0.25  # [m] objects closer to the lamp cast no shadow, such as its own glass
NEAR_CORNER = 0.07  # [m] range of corner darkening
FAR_CORNER = 0.28
SHADOW_STEP = 0.04  # [m] shortest and longest step toward the lamp
SHADOW_STRIDE = 0.12
PENUMBRA_RATIO = 6.0  # distance over width of a penumbra


@struct
class LightGrid:
    """Precomputed light; `nodes`, z fastest: distance [m] to the nearest solid and visible fraction of the lamp."""

    lamp: vec3
    low: vec3
    step: float
    size: vec3i
    nodes: array(dtype=vec2)

    def __init__(
        self, solids: Solids, *, lamp: Sequence[float] | np.ndarray, low: ArrayLike, high: ArrayLike, step: float
    ) -> None:
        low = np.asarray(low, np.float64)
        shape = np.ceil((np.asarray(high) - low) / step).astype(int) + 1
        self.lamp, self.low, self.step = vec3(*lamp), vec3(*low), float(step)
        self.size = vec3i(*shape.tolist())
        count = int(shape.prod())
        distances, self.nodes = empty(count, vec2, solids.device), empty(count, vec2, solids.device)
        launch(sample_distances_kernel, count, [self, vec3d(*low), self.step, solids, distances])
        launch(sample_shadows_kernel, count, [self, distances])


@func
def node_index(i: int, light: LightGrid) -> vec3i:
    return vec3i(i // (light.size[2] * light.size[1]), (i // light.size[2]) % light.size[1], i % light.size[2])


@kernel
def sample_distances_kernel(light: LightGrid, low: vec3d, step: float64, solids: Solids, distances: array(dtype=vec2)):
    """Distance field [m] at the nodes. Light is still unknown."""
    i = tid()
    node = node_index(i, light)
    p = low + vec3d(float64(node[0]), float64(node[1]), float64(node[2])) * step
    distances[i] = vec2(float32(scene_distance(p, solids)), 1.0)


@func
def read_grid(p: vec3, nodes: array(dtype=vec2), light: LightGrid) -> vec2:
    u = (p - light.low) / light.step
    x = min(max(u[0], 0.0), float(light.size[0] - 1) - 0.001)
    y = min(max(u[1], 0.0), float(light.size[1] - 1) - 0.001)
    z = min(max(u[2], 0.0), float(light.size[2] - 1) - 0.001)
    ix = int(x)
    iy = int(y)
    iz = int(z)
    fx = x - float(ix)
    fy = y - float(iy)
    fz = z - float(iz)
    a = (ix * light.size[1] + iy) * light.size[2] + iz
    b = a + light.size[2]
    c = a + light.size[1] * light.size[2]
    d = c + light.size[2]
    near = (nodes[a] * (1.0 - fz) + nodes[a + 1] * fz) * (1.0 - fy) + (nodes[b] * (1.0 - fz) + nodes[b + 1] * fz) * fy
    far = (nodes[c] * (1.0 - fz) + nodes[c + 1] * fz) * (1.0 - fy) + (nodes[d] * (1.0 - fz) + nodes[d + 1] * fz) * fy
    return near * (1.0 - fx) + far * fx


@kernel
def sample_shadows_kernel(light: LightGrid, distances: array(dtype=vec2)):
    """Visible lamp fraction of each node: the narrowest passage by its angle."""
    i = tid()
    node = node_index(i, light)
    p = light.low + vec3(float(node[0]), float(node[1]), float(node[2])) * light.step
    way = light.lamp - p
    distance = length(way)
    clear = 1.0
    t = float(SHADOW_STEP)
    while t < distance - LAMP_RADIUS and clear > 0.0:
        d = read_grid(p + way * (t / distance), distances, light)[0]
        clear = min(clear, 0.5 + 0.5 * PENUMBRA_RATIO * d / t)
        t = t + min(max(0.5 * d, SHADOW_STEP), SHADOW_STRIDE)
    fraction = min(max(clear, 0.0), 1.0)
    light.nodes[i] = vec2(distances[i][0], fraction * fraction * (3.0 - 2.0 * fraction))


@func
def light_surface(p: vec3, normal: vec3, light: LightGrid) -> float:
    """Light of a surface point per unit of its color."""
    near = read_grid(p + normal * NEAR_CORNER, light.nodes, light)
    far = read_grid(p + normal * FAR_CORNER, light.nodes, light)
    open_fraction = 0.4 * near[0] / NEAR_CORNER + 0.6 * far[0] / FAR_CORNER
    openness = 0.35 + 0.65 * min(max(open_fraction, 0.0), 1.0)
    way = light.lamp - p
    distance = length(way)
    lit = max(dot(normal, way) / distance, 0.0) * near[1]
    fall = 1.0 / (1.0 + distance * distance / (LAMP_RANGE * LAMP_RANGE))
    return (AMBIENT_LIGHT + SKY_LIGHT * normal[2]) * openness + LAMP_LIGHT * lit * fall * (0.6 + 0.4 * openness)


TILE_PIXELS = 16  # [px] smaller tiles list fewer solids, larger ones need fewer lists. 8 and 32 were slower
TILE_SIZE = float(TILE_PIXELS)
PLAIN_PATTERN = 0
CHECKER_PATTERN = 1
STRIPES_PATTERN = 2
PLANKS_PATTERN = 3
GLOW_PATTERN = 4  # emissive
SEAM_SHIFT = 0.137  # shifts pattern seams off the faces of solids, where rounding would decide
PLANK_LENGTH = 5.0  # widths of a plank


@func
def pattern_weight(q: vec3, kind: int, size: float) -> float:
    """Fraction of the second color at a point in a solid's frame."""
    u = q / size + vec3(SEAM_SHIFT, SEAM_SHIFT, SEAM_SHIFT)
    weight = 0.0
    if kind == CHECKER_PATTERN:
        total = floor(u[0]) + floor(u[1]) + floor(u[2])
        weight = total - 2.0 * floor(total * 0.5)
    elif kind == STRIPES_PATTERN:
        weight = floor(u[0]) - 2.0 * floor(u[0] * 0.5)
    elif kind == PLANKS_PATTERN:
        row = floor(u[1])
        coordinate = u[0] / PLANK_LENGTH + row * 0.381966
        plank = floor(coordinate) * 7.13 + row * 3.71
        weight = 0.75 * (plank * 0.618034 - floor(plank * 0.618034))
        if u[1] - row < 0.04 or (coordinate - floor(coordinate)) * PLANK_LENGTH < 0.04:
            weight = 1.0
    return weight


@struct
class Room:
    """A scene of solids, two colors each (0 to 1), `patterns`: kind (PLAIN_PATTERN to GLOW_PATTERN) and size
    [m]. `light`: an existing grid, instead of `lamp`, `low`, `high` and `step` [m].
    """

    solids: Solids
    paints: array(dtype=vec3)
    patterns: array(dtype=vec2)
    light: LightGrid

    def __init__(
        self,
        solids: Solids,
        paints: ArrayLike,
        patterns: ArrayLike,
        *,
        lamp: Any = None,
        low: Any = None,
        high: Any = None,
        step: float = 0.05,
        light: LightGrid | None = None,
    ) -> None:
        device = solids.device
        self.solids, self.device = solids, device
        self.paints = upload(np.asarray(paints).reshape(-1, 3), vec3, device)
        self.patterns = upload(np.asarray(patterns), vec2, device)
        self.light = light if light is not None else LightGrid(solids, lamp=lamp, low=low, high=high, step=step)

    def render(self, camera: CameraLike, T_world_camera: np.ndarray) -> tuple[Scalars, Scalars, Bytes]:
        """Render (depth [m] along the optical axis, 0 if empty; cosine between view and normal; 8-bit colors)."""
        device, count, pose = self.device, camera.width * camera.height, Transform(T_world_camera)
        tiles = TileLists(camera, pose, self.solids)
        depth, incidence = empty(count, float32, device), empty(count, float32, device)
        colors = empty(3 * count, uint8, device)
        launch(render_pixels_kernel, count, [camera, pose, tiles, self, depth, incidence, colors])
        return depth, incidence, colors


@struct
class TileLists:
    """Solids that each tile may show: `columns` of tiles; `counts`; `lists` with room for all solids per tile."""

    columns: int
    counts: array(dtype=int32)
    lists: array(dtype=int32)

    def __init__(self, camera: CameraLike, T_world_camera: Transform, solids: Solids) -> None:
        self.columns, rows = -(-camera.width // TILE_PIXELS), -(-camera.height // TILE_PIXELS)
        count, device = self.columns * rows, solids.device
        self.lists, self.counts = empty(count * solids.count, int32, device), empty(count, int32, device)
        launch(list_solids_kernel, count, [camera, T_world_camera, solids, self])


@kernel
def list_solids_kernel(camera: Camera, T_world_camera: Transform, solids: Solids, tiles: TileLists):
    i = tid()
    x0 = float64((i % tiles.columns) * TILE_PIXELS) - 0.5
    y0 = float64((i // tiles.columns) * TILE_PIXELS) - 0.5
    size = float64(TILE_SIZE)
    middle = normalize(pixel_ray(x0 + size * 0.5, y0 + size * 0.5, camera))
    cosine = float64(1.0)
    for corner in range(4):
        x = x0 + size * float64(corner % 2)
        y = y0 + size * float64(corner // 2)
        cosine = min(cosine, dot(middle, normalize(pixel_ray(x, y, camera))))
    half_angle = acos(cosine)
    axis = T_world_camera.R @ middle
    count = 0
    for s in range(solids.centers.shape[0]):
        way = solids.centers[s] - T_world_camera.t
        e = solids.extents[s]
        radius = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) + e[3]
        distance = length(way)
        touched = 1
        if distance > radius:
            angle = acos(min(max(dot(axis, way) / distance, -1.0), 1.0))
            if angle > half_angle + asin(radius / distance) + 1.0e-6:
                touched = 0
        if touched == 1:
            tiles.lists[i * solids.centers.shape[0] + count] = s
            count += 1
    tiles.counts[i] = count


@func
def color_at(p: vec3d, normal: vec3d, solid: int, room: Room) -> vec3:
    q = point_in_solid(p, solid, room.solids)
    light = light_surface(narrow(p), narrow(normal), room.light)
    pattern = room.patterns[solid]
    if int(pattern[0]) == GLOW_PATTERN:
        light = 1.0
    weight = pattern_weight(narrow(q), int(pattern[0]), pattern[1])
    return (room.paints[2 * solid] * (1.0 - weight) + room.paints[2 * solid + 1] * weight) * light


@kernel
def render_pixels_kernel(
    camera: Camera,
    T_world_camera: Transform,
    tiles: TileLists,
    room: Room,
    depth: array(dtype=float32),
    incidence: array(dtype=float32),
    colors: array(dtype=uint8),
):
    """Depth, incidence cosine and color of each pixel, or zeros if empty."""
    i = tid()
    column = i % camera.width
    row = i // camera.width
    tile = (row // TILE_PIXELS) * tiles.columns + column // TILE_PIXELS
    view = pixel_ray(float64(column), float64(row), camera)
    ray = T_world_camera.R @ view
    eye = T_world_camera.t
    t = float64(INFINITY)
    solid = -1
    for j in range(tiles.counts[tile]):
        s = tiles.lists[tile * room.solids.kinds.shape[0] + j]
        origin = point_in_solid(eye, s, room.solids)
        way = room.solids.rotations[s] @ ray
        met = meet_solid(origin, way, room.solids.extents[s], room.solids.kinds[s], t)
        if met < t:
            t = met
            solid = s
    red = 0.0
    green = 0.0
    blue = 0.0
    z = 0.0
    cosine = 0.0
    if solid >= 0:
        p = eye + ray * t
        normal = scene_normal(p, solid, room.solids)
        z = float32(t)
        cosine = float32(-dot(normal, ray) / length(ray))
        color = color_at(p, normal, solid, room)
        red = color[0]
        green = color[1]
        blue = color[2]
    depth[i] = z
    incidence[i] = cosine
    colors[3 * i] = color_byte(red)
    colors[3 * i + 1] = color_byte(green)
    colors[3 * i + 2] = color_byte(blue)
