"""What rays meet in a scene: the first triangle, whether there is one, how many there are, and all of them in order.

One thread a ray; reads 24 B of it and writes up to 32. Hits of one place at one parameter are one: so many triangles as
may share an edge or a corner that the ray passes through, it is crossed once, and the one with the smallest number is
it. Hits are counted and listed by asking for the next one again and again, so they come in order and want no memory.
A ray that is not finite, or has no direction, meets nothing.
"""

import math

from ..algebra.transform import narrow, widen
from ..array_types import Device, Indices, Integers, Mask, Scalars, Vectors
from ..arrays.prefix_sum import exclusive_scan
from ..lang import (
    INFINITY,
    array,
    cross,
    float32,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    length,
    struct,
    tid,
    uint8,
    vec2,
    vec3,
)
from ..memory import empty
from .ray_hits import next_hit, turn_back
from .scene_trees import NUMBER, ROW, SceneTrees
from .triangle_tree import LEAF, leaf_corner

NO_ID = -1  # as an unsigned number 0xFFFFFFFF
BEFORE = -1.0  # a parameter before all others


@struct
class RayHits:
    """What rays meet, one row a hit.

    Attributes:
        t_hit: float32, the parameter; infinite where nothing is met.
        geometry_ids: int32, the number of the place; NO_ID where nothing is met.
        primitive_ids: int32, the number of the triangle in its mesh; NO_ID likewise.
        primitive_uvs: vec2, the weights of the triangle's second and third corner; 0 likewise.
    """

    t_hit: array(dtype=float32)
    geometry_ids: array(dtype=int32)
    primitive_ids: array(dtype=int32)
    primitive_uvs: array(dtype=vec2)

    def __init__(self, count: int, device: Device) -> None:
        self.t_hit = empty(count, float32, device)
        self.geometry_ids, self.primitive_ids = (empty(count, int32, device) for _ in range(2))
        self.primitive_uvs = empty(count, vec2, device)


@func
def ray_origin(rays: array(dtype=float32), i: int) -> vec3:
    """Where a ray begins."""
    return vec3(rays[6 * i], rays[6 * i + 1], rays[6 * i + 2])


@func
def ray_direction(rays: array(dtype=float32), i: int) -> vec3:
    """Where it goes."""
    return vec3(rays[6 * i + 3], rays[6 * i + 4], rays[6 * i + 5])


@func
def normal_of(place: int, row: int, trees: SceneTrees) -> vec3:
    """The unit normal of a triangle by the right-hand rule, in the scene's frame."""
    a = leaf_corner(trees.corners, place // LEAF, place % LEAF, 0)
    b = leaf_corner(trees.corners, place // LEAF, place % LEAF, 1)
    c = leaf_corner(trees.corners, place // LEAF, place % LEAF, 2)
    n = turn_back(cross(widen(b) - widen(a), widen(c) - widen(a)), trees.motions, row)
    return narrow(n / length(n))


@kernel
def cast_rays_kernel(rays: array(dtype=float32), trees: SceneTrees, hits: RayHits, normals: array(dtype=vec3)):
    """The first triangle that each ray meets."""
    i = tid()
    o = ray_origin(rays, i)
    d = ray_direction(rays, i)
    met = next_hit(o, d, 0.0, INFINITY, float64(BEFORE), NO_ID, 0, trees)
    hits.t_hit[i] = float(met[0])
    hits.geometry_ids[i] = NO_ID
    hits.primitive_ids[i] = NO_ID
    hits.primitive_uvs[i] = vec2(float(met[3]), float(met[4]))
    normal = vec3(0.0, 0.0, 0.0)
    if isfinite(met[0]):
        row = int(met[1])
        place = int(met[2])
        hits.geometry_ids[i] = trees.rows[row * ROW + NUMBER]
        hits.primitive_ids[i] = trees.order[place]
        normal = normal_of(place, row, trees)
    normals[i] = normal


@kernel
def test_occlusions_kernel(
    rays: array(dtype=float32), nearest: float, farthest: float, trees: SceneTrees, occluded: array(dtype=uint8)
):
    """1 where a ray meets anything."""
    i = tid()
    o = ray_origin(rays, i)
    d = ray_direction(rays, i)
    met = next_hit(o, d, nearest, farthest, float64(BEFORE), NO_ID, 1, trees)
    occluded[i] = uint8(1 if isfinite(met[0]) else 0)


@kernel
def count_hits_kernel(rays: array(dtype=float32), trees: SceneTrees, counts: array(dtype=int32)):
    """How often each ray meets a place."""
    i = tid()
    o = ray_origin(rays, i)
    d = ray_direction(rays, i)
    count = -1
    after = float64(BEFORE)
    above = int(NO_ID)
    while isfinite(after):
        met = next_hit(o, d, max(float(after), 0.0), INFINITY, after, above, 0, trees)
        after = met[0]
        if isfinite(after):
            above = trees.rows[int(met[1]) * ROW + NUMBER]
        count += 1
    counts[i] = count


@kernel
def list_hits_kernel(
    rays: array(dtype=float32),
    offsets: array(dtype=int32),
    trees: SceneTrees,
    hits: RayHits,
    ray_ids: array(dtype=int32),
):
    """All that each ray meets, in order."""
    i = tid()
    o = ray_origin(rays, i)
    d = ray_direction(rays, i)
    after = float64(BEFORE)
    above = int(NO_ID)
    for j in range(offsets[i], offsets[i + 1]):
        met = next_hit(o, d, max(float(after), 0.0), INFINITY, after, above, 0, trees)
        after = met[0]
        above = trees.rows[int(met[1]) * ROW + NUMBER]
        hits.t_hit[j] = float(after)
        hits.geometry_ids[j] = above
        hits.primitive_ids[j] = trees.order[int(met[2])]
        hits.primitive_uvs[j] = vec2(float(met[3]), float(met[4]))
        ray_ids[j] = i


def cast_rays(trees: SceneTrees, rays: Scalars) -> tuple[RayHits, Vectors]:
    """The first triangle that each ray meets.

    Args:
        trees: SceneTrees.
        rays: float32 device array [6 n], origin and direction in the scene's frame.

    Returns:
        (RayHits, vec3 [n] of unit normals, 0 where nothing is met).
    """
    count = rays.size // 6
    hits, normals = RayHits(count, rays.device), empty(count, vec3, rays.device)
    launch(cast_rays_kernel, count, [rays, trees, hits, normals])
    return hits, normals


def test_occlusions(trees: SceneTrees, rays: Scalars, nearest: float = 0.0, farthest: float = math.inf) -> Mask:
    """Whether each ray meets anything with a parameter from `nearest` to `farthest`: uint8 [n]."""
    occluded = empty(rays.size // 6, uint8, rays.device)
    launch(test_occlusions_kernel, occluded.size, [rays, nearest, farthest, trees, occluded])
    return occluded


def count_hits(trees: SceneTrees, rays: Scalars) -> Integers:
    """How often each ray meets a place, int32 [n]."""
    counts = empty(rays.size // 6, int32, rays.device)
    launch(count_hits_kernel, counts.size, [rays, trees, counts])
    return counts


def list_hits(trees: SceneTrees, rays: Scalars) -> tuple[RayHits, Indices, Integers]:
    """All that rays meet, by ray, then parameter, then number of the place.

    Returns:
        (RayHits, int32 [hits]: the ray of each, int32 [n + 1]: where those of each ray begin, and end).
    """
    offsets, total = exclusive_scan(count_hits(trees, rays))  # sync
    hits, ray_ids = RayHits(total, rays.device), empty(total, int32, rays.device)
    launch(list_hits_kernel, rays.size // 6, [rays, offsets, trees, hits, ray_ids])
    return hits, ray_ids, offsets
