"""Ray queries against a scene: first hit, occlusion, hit count, and all hits in order.

One thread per ray. Hits of one object at the same parameter count once, with the smallest triangle number. Further hits
are found by repeated queries, in order and without memory. Non-finite and zero-direction rays hit nothing.
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
from .ray_hits import next_hit, rotate_back
from .scene_trees import NUMBER, ROW, SceneTrees
from .triangle_tree import LEAF, leaf_corner

NO_ID = -1  # 0xFFFFFFFF as unsigned
BEFORE = -1.0  # a parameter before all others


@struct
class RayHits:
    """Hits of rays: `t_hit`, infinite if none; ids or NO_ID; `primitive_uvs`, weights of corners 2 and 3."""

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
    return vec3(rays[6 * i], rays[6 * i + 1], rays[6 * i + 2])


@func
def ray_direction(rays: array(dtype=float32), i: int) -> vec3:
    return vec3(rays[6 * i + 3], rays[6 * i + 4], rays[6 * i + 5])


@func
def normal_of(index: int, row: int, trees: SceneTrees) -> vec3:
    """Unit normal of a triangle by the right-hand rule, in the scene's frame."""
    a = leaf_corner(trees.corners, index // LEAF, index % LEAF, 0)
    b = leaf_corner(trees.corners, index // LEAF, index % LEAF, 1)
    c = leaf_corner(trees.corners, index // LEAF, index % LEAF, 2)
    n = rotate_back(cross(widen(b) - widen(a), widen(c) - widen(a)), trees.motions, row)
    return narrow(n / length(n))


@kernel
def cast_rays_kernel(rays: array(dtype=float32), trees: SceneTrees, hits: RayHits, normals: array(dtype=vec3)):
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
        index = int(met[2])
        hits.geometry_ids[i] = trees.rows[row * ROW + NUMBER]
        hits.primitive_ids[i] = trees.order[index]
        normal = normal_of(index, row, trees)
    normals[i] = normal


@kernel
def test_occlusions_kernel(
    rays: array(dtype=float32), nearest: float, farthest: float, trees: SceneTrees, occluded: array(dtype=uint8)
):
    i = tid()
    o = ray_origin(rays, i)
    d = ray_direction(rays, i)
    met = next_hit(o, d, nearest, farthest, float64(BEFORE), NO_ID, 1, trees)
    occluded[i] = uint8(1 if isfinite(met[0]) else 0)


@kernel
def count_hits_kernel(rays: array(dtype=float32), trees: SceneTrees, counts: array(dtype=int32)):
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
    """First hits of rays, float32 (6 n): (RayHits, unit normals vec3 (n), 0 without a hit)."""
    count = rays.size // 6
    hits, normals = RayHits(count, rays.device), empty(count, vec3, rays.device)
    launch(cast_rays_kernel, count, [rays, trees, hits, normals])
    return hits, normals


def test_occlusions(trees: SceneTrees, rays: Scalars, nearest: float = 0.0, farthest: float = math.inf) -> Mask:
    """True if a ray hits anything with a parameter from `nearest` to `farthest`: uint8 (n)."""
    occluded = empty(rays.size // 6, uint8, rays.device)
    launch(test_occlusions_kernel, occluded.size, [rays, nearest, farthest, trees, occluded])
    return occluded


def count_hits(trees: SceneTrees, rays: Scalars) -> Integers:
    counts = empty(rays.size // 6, int32, rays.device)
    launch(count_hits_kernel, counts.size, [rays, trees, counts])
    return counts


def list_hits(trees: SceneTrees, rays: Scalars) -> tuple[RayHits, Indices, Integers]:
    """All hits by ray, parameter, object: (RayHits, ray of each hit int32, start of each ray int32 (n + 1))."""
    offsets, total = exclusive_scan(count_hits(trees, rays))  # sync
    hits, ray_ids = RayHits(total, rays.device), empty(total, int32, rays.device)
    launch(list_hits_kernel, rays.size // 6, [rays, offsets, trees, hits, ray_ids])
    return hits, ray_ids, offsets
