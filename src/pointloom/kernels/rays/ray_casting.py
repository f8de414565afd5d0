"""Ray queries against a scene: first hit, occlusion, hit count, and all hits in order.

One thread per ray; for first hits on the CPU, one per eight rays (ray_packets.py). Hits of one object at the same
parameter count once, with the smallest triangle number. Further hits are found by repeated queries, in order and
without memory. Non-finite and zero-direction rays hit nothing.
"""

import math

from ..algebra.plain_min_max import larger
from ..algebra.transform import narrow, widen
from ..array_types import Device, Indices, Integers, Mask, Scalars, Vectors
from ..arrays.prefix_sum import exclusive_scan
from ..lang import (
    INFINITY,
    array,
    compute,
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
from ..search.tree_walk import bits_of
from .ray_hits import UPPER_DEPTH_FACTOR, lanes_met, meet_triangle, near_sides, next_hit, ray_axes, rotate_back
from .ray_packets import (
    NUMBERS_PER_RAY,
    RAYS_PER_PACKET,
    SHEAR_AT,
    direction_in,
    is_packet,
    leaves_of_packet,
    numbers_of,
    packet,
    ray_direction,
    ray_indices,
    ray_lanes,
    ray_origin,
)
from .scene_trees import FIRST_LEAF_AT, NUMBER_AT, ROW_INTEGERS, SceneTrees
from .triangle_tree import LEAF_SIZE, leaf_corner

NO_ID = -1  # 0xFFFFFFFF as unsigned
BEFORE_ALL = -1.0  # a parameter before all others


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
def normal_of(index: int, row: int, trees: SceneTrees) -> vec3:
    """Unit normal of a triangle by the right-hand rule, in the scene's frame."""
    a = leaf_corner(trees.corners, index // LEAF_SIZE, index % LEAF_SIZE, 0)
    b = leaf_corner(trees.corners, index // LEAF_SIZE, index % LEAF_SIZE, 1)
    c = leaf_corner(trees.corners, index // LEAF_SIZE, index % LEAF_SIZE, 2)
    n = rotate_back(cross(widen(b) - widen(a), widen(c) - widen(a)), trees.motions, row)
    return narrow(n / length(n))


@func
def store_hit(i: int, row: int, index: int, trees: SceneTrees, hits: RayHits, normals: array(dtype=vec3)):
    """Numbers and normal of the triangle at a position in the tree; none for position -1."""
    hits.geometry_ids[i] = NO_ID
    hits.primitive_ids[i] = NO_ID
    normal = vec3(0.0, 0.0, 0.0)
    if index >= 0:
        hits.geometry_ids[i] = trees.rows[row * ROW_INTEGERS + NUMBER_AT]
        hits.primitive_ids[i] = trees.order[index]
        normal = normal_of(index, row, trees)
    normals[i] = normal


@func
def cast_ray(i: int, rays: array(dtype=float32), trees: SceneTrees, hits: RayHits, normals: array(dtype=vec3)):
    met = next_hit(ray_origin(rays, i), ray_direction(rays, i), 0.0, INFINITY, float64(BEFORE_ALL), NO_ID, 0, trees)
    hits.t_hit[i] = float(met[0])
    hits.primitive_uvs[i] = vec2(float(met[3]), float(met[4]))
    store_hit(i, int(met[1]), int(met[2]) if isfinite(met[0]) else -1, trees, hits, normals)


@func
def cast_packet(first: int, rays: array(dtype=float32), trees: SceneTrees, hits: RayHits, normals: array(dtype=vec3)):
    """First hits of eight coherent rays."""
    numbers = packet(0.0)
    count = int(RAYS_PER_PACKET)
    for r in range(count):
        own = numbers_of(ray_origin(rays, first + r), ray_direction(rays, first + r), trees)
        for k in range(NUMBERS_PER_RAY):
            numbers[NUMBERS_PER_RAY * r + k] = own[k]
    e = direction_in(ray_direction(rays, first), trees)
    axes = ray_axes(e)
    near = near_sides(e)
    first_leaf = trees.rows[FIRST_LEAF_AT]
    ends = ray_lanes(INFINITY)
    limit = float(INFINITY)
    depths = ray_lanes(INFINITY)
    indices = ray_indices(-1)
    u = ray_lanes(0.0)
    v = ray_lanes(0.0)
    for leaf, mask in leaves_of_packet(trees, numbers, near, ends, limit):
        leaf_index = first_leaf + leaf
        closer = 0
        for r in bits_of(mask):
            of = NUMBERS_PER_RAY * r
            q = vec3(numbers[of], numbers[of + 1], numbers[of + 2])
            shear = vec3(numbers[of + SHEAR_AT], numbers[of + SHEAR_AT + 1], numbers[of + SHEAR_AT + 2])
            for lane in bits_of(lanes_met(trees.corners, leaf_index, q, axes, shear)):
                met = meet_triangle(trees.corners, leaf_index, lane, q, axes, shear)
                main = abs(shear[2])
                t = float(met[0] / float64(main))
                if t >= 0.0 and t <= depths[r] and isfinite(t):
                    index = leaf_index * LEAF_SIZE + lane
                    is_first = t < depths[r]
                    if is_first or trees.order[index] < trees.order[max(indices[r], 0)]:
                        depths[r] = t
                        indices[r] = index
                        u[r] = float(met[2])
                        v[r] = float(met[3])
                        ends[r] = t * main * UPPER_DEPTH_FACTOR
                        closer = 1
        if closer == 1:
            limit = ends[0]
            for r in range(1, RAYS_PER_PACKET):
                limit = larger(limit, ends[r])
    for r in range(count):
        hits.t_hit[first + r] = depths[r]
        hits.primitive_uvs[first + r] = vec2(u[r], v[r])
        store_hit(first + r, 0, indices[r], trees, hits, normals)


@kernel
def cast_rays_kernel(
    rays: array(dtype=float32), run: int, trees: SceneTrees, hits: RayHits, normals: array(dtype=vec3)
):
    i = tid()
    first = i * run
    if is_packet(rays, first, trees) == 1:
        cast_packet(first, rays, trees, hits, normals)
    else:
        for j in range(first, min(first + run, normals.shape[0])):
            cast_ray(j, rays, trees, hits, normals)


@cast_rays_kernel.on_cuda
def cast_single_rays_kernel(
    rays: array(dtype=float32), run: int, trees: SceneTrees, hits: RayHits, normals: array(dtype=vec3)
):
    i = tid()
    cast_ray(i, rays, trees, hits, normals)


@kernel
def test_occlusions_kernel(
    rays: array(dtype=float32), nearest: float, farthest: float, trees: SceneTrees, occluded: array(dtype=uint8)
):
    i = tid()
    o = ray_origin(rays, i)
    d = ray_direction(rays, i)
    met = next_hit(o, d, nearest, farthest, float64(BEFORE_ALL), NO_ID, 1, trees)
    occluded[i] = uint8(1 if isfinite(met[0]) else 0)


@kernel
def count_hits_kernel(rays: array(dtype=float32), trees: SceneTrees, counts: array(dtype=int32)):
    i = tid()
    o = ray_origin(rays, i)
    d = ray_direction(rays, i)
    count = -1
    after = float64(BEFORE_ALL)
    above = int(NO_ID)
    while isfinite(after):
        met = next_hit(o, d, max(float(after), 0.0), INFINITY, after, above, 0, trees)
        after = met[0]
        if isfinite(after):
            above = trees.rows[int(met[1]) * ROW_INTEGERS + NUMBER_AT]
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
    after = float64(BEFORE_ALL)
    above = int(NO_ID)
    for j in range(offsets[i], offsets[i + 1]):
        met = next_hit(o, d, max(float(after), 0.0), INFINITY, after, above, 0, trees)
        after = met[0]
        above = trees.rows[int(met[1]) * ROW_INTEGERS + NUMBER_AT]
        hits.t_hit[j] = float(after)
        hits.geometry_ids[j] = above
        hits.primitive_ids[j] = trees.order[int(met[2])]
        hits.primitive_uvs[j] = vec2(float(met[3]), float(met[4]))
        ray_ids[j] = i


def cast_rays(trees: SceneTrees, rays: Scalars) -> tuple[RayHits, Vectors]:
    """First hits of rays, float32 (6 n): (RayHits, unit normals vec3 (n), 0 without a hit)."""
    count = rays.size // 6
    hits, normals = RayHits(count, rays.device), empty(count, vec3, rays.device)
    run = 1 if rays.device.is_cuda else RAYS_PER_PACKET
    launch(cast_rays_kernel, -(-count // run), [rays, run, trees, hits, normals])
    return hits, normals


def test_occlusions(trees: SceneTrees, rays: Scalars, nearest: float = 0.0, farthest: float = math.inf) -> Mask:
    """True if a ray hits anything with a parameter from `nearest` to `farthest`: uint8 (n)."""
    return compute(test_occlusions_kernel, rays.size // 6, [rays, nearest, farthest, trees], uint8, rays.device)


def count_hits(trees: SceneTrees, rays: Scalars) -> Integers:
    return compute(count_hits_kernel, rays.size // 6, [rays, trees], int32, rays.device)


def list_hits(trees: SceneTrees, rays: Scalars) -> tuple[RayHits, Indices, Integers]:
    """All hits by ray, parameter, object: (RayHits, ray of each hit int32, start of each ray int32 (n + 1))."""
    largest = trees.object_count * trees.order.size  # objects may share a tree, hit once per triangle
    offsets, total = exclusive_scan(count_hits(trees, rays), largest)  # sync
    hits, ray_ids = RayHits(total, rays.device), empty(total, int32, rays.device)
    launch(list_hits_kernel, rays.size // 6, [rays, offsets, trees, hits, ray_ids])
    return hits, ray_ids, offsets
