"""The light of a room: a hemisphere of ambient light dimmed in corners, and a lamp with soft shadows.

Both come from a grid laid through the room once, distance to the nearest solid and share of the lamp seen, so a
surface point costs two reads between 8 nodes each. The grid is coarse; that blurs shadows and changes no geometry.
Light is diffuse and belongs to the room: a surface has one colour from wherever it is seen.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ..lang import array, dot, float32, float64, func, kernel, launch, length, struct, tid, vec2, vec3, vec3d, vec3i
from ..memory import empty
from .primitives import Solids, scene_distance

AMBIENT = 0.54
SKY = 0.04  # more ambient light from above than from below
LAMP = 0.85
LAMP_REACH = 3.2  # [m] where the lamp's light has halved
LAMP_RADIUS = 0.25  # [m] nothing this close to the lamp throws a shadow: its own glass does not
NEAR_CORNER = 0.07  # [m] how far from a surface its corners are felt
FAR_CORNER = 0.28
SHADOW_STEP = 0.04  # [m] shortest and longest step toward the lamp
SHADOW_STRIDE = 0.12
PENUMBRA = 6.0  # distance over width of a shadow's edge


@struct
class LightGrid:
    """The light of a scene, sampled once.

    Args:
        solids: The solids.
        lamp: Place of the lamp, [3] [m].
        low, high: The box that the grid fills, [3] [m].
        step: Spacing of its nodes [m]; 8 B of memory and one pass over all solids a node.

    Attributes:
        size: Nodes along each axis.
        nodes: vec2, z fastest: distance [m] to the nearest solid, and share of the lamp that is seen.
    """

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
def node_place(i: int, light: LightGrid) -> vec3i:
    """Where the i-th node of the grid stands, in steps."""
    return vec3i(i // (light.size[2] * light.size[1]), (i // light.size[2]) % light.size[1], i % light.size[2])


@kernel
def sample_distances_kernel(light: LightGrid, low: vec3d, step: float64, solids: Solids, distances: array(dtype=vec2)):
    """The distance field [m] at the nodes of a grid, beside a share of light that is still unknown."""
    i = tid()
    node = node_place(i, light)
    p = low + vec3d(float64(node[0]), float64(node[1]), float64(node[2])) * step
    distances[i] = vec2(float32(scene_distance(p, solids)), 1.0)


@func
def read_grid(p: vec3, nodes: array(dtype=vec2), light: LightGrid) -> vec2:
    """Distance and share of the lamp between the nodes of the grid."""
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
    """The share of the lamp seen from each node: the narrowest passage on the way there, by its angle."""
    i = tid()
    node = node_place(i, light)
    p = light.low + vec3(float(node[0]), float(node[1]), float(node[2])) * light.step
    way = light.lamp - p
    reach = length(way)
    clear = 1.0
    t = float(SHADOW_STEP)
    while t < reach - LAMP_RADIUS and clear > 0.0:
        d = read_grid(p + way * (t / reach), distances, light)[0]
        clear = min(clear, 0.5 + 0.5 * PENUMBRA * d / t)
        t = t + min(max(0.5 * d, SHADOW_STEP), SHADOW_STRIDE)
    share = min(max(clear, 0.0), 1.0)
    light.nodes[i] = vec2(distances[i][0], share * share * (3.0 - 2.0 * share))


@func
def light_surface(p: vec3, normal: vec3, light: LightGrid) -> float:
    """The light that a point of a surface gives off for each unit of its colour."""
    near = read_grid(p + normal * NEAR_CORNER, light.nodes, light)
    far = read_grid(p + normal * FAR_CORNER, light.nodes, light)
    open_share = 0.4 * near[0] / NEAR_CORNER + 0.6 * far[0] / FAR_CORNER
    openness = 0.35 + 0.65 * min(max(open_share, 0.0), 1.0)
    way = light.lamp - p
    reach = length(way)
    lit = max(dot(normal, way) / reach, 0.0) * near[1]
    fall = 1.0 / (1.0 + reach * reach / (LAMP_REACH * LAMP_REACH))
    return (AMBIENT + SKY * normal[2]) * openness + LAMP * lit * fall * (0.6 + 0.4 * openness)
