"""First hits of eight coherent rays on the CPU: adjacent pixels, for example.

Rays with the same main axis and signs of direction traverse the tree of one object together. A node's boxes are loaded
once for all of them, and few branches are mispredicted. Each ray tests only the leaves that it enters, so results are
those of `next_hit`. Wald et al., "Interactive rendering with coherent ray tracing", Eurographics 2001.
"""

from ..algebra.transform import narrow, widen
from ..lang import array, float32, float_bits, func, int32, loop, vec3, vec3i, vector
from ..search.point_tree import FAN
from .ray_hits import (
    NOT_ENTERED,
    child_entries,
    is_ray,
    rates_of,
    ray_axes,
    rotate_into,
    shear_of,
    signed_margins,
    vector_at,
)
from .scene_trees import ROOT_AT, SceneTrees
from .triangle_tree import MAX_LEVEL, level_keys

RAYS_PER_PACKET = 8
NUMBERS_PER_RAY = 16  # origin, shear, near and far side of the origin's margins, rates
SHEAR_AT, NEAR_AT, FAR_AT, RATES_AT = 3, 6, 9, 12
packet = vector(128, float32)
ray_numbers = vector(16, float32)
ray_lanes = vector(8, float32)
ray_indices = vector(8, int32)
child_masks = vector(8, int32)


@func
def ray_origin(rays: array(dtype=float32), i: int) -> vec3:
    return vec3(rays[6 * i], rays[6 * i + 1], rays[6 * i + 2])


@func
def ray_direction(rays: array(dtype=float32), i: int) -> vec3:
    return vec3(rays[6 * i + 3], rays[6 * i + 4], rays[6 * i + 5])


@func
def direction_in(d: vec3, trees: SceneTrees) -> vec3:
    """Direction in the frame of the first object."""
    return narrow(rotate_into(widen(d), trees.motions, 0))


@func
def octant_of(rays: array(dtype=float32), i: int, trees: SceneTrees) -> int:
    """Main axis and signs of a ray in the frame of the first object. -1 if it is not a ray."""
    octant = -1
    d = ray_direction(rays, i)
    if is_ray(ray_origin(rays, i), d) == 1:
        e = direction_in(d, trees)
        octant = ray_axes(e)[2] | (int(e[0] >= 0.0) << 2) | (int(e[1] >= 0.0) << 3) | (int(e[2] >= 0.0) << 4)
    return octant


@func
def is_packet(rays: array(dtype=float32), first: int, trees: SceneTrees) -> int:
    """1 if eight rays from `first` on are coherent, and there is one object."""
    octant = -1
    count = 0
    if trees.object_count == 1 and first + RAYS_PER_PACKET <= rays.shape[0] // 6:
        octant = octant_of(rays, first, trees)
    other = octant + 0
    while other >= 0 and other == octant and count < RAYS_PER_PACKET:
        count += 1
        if count < RAYS_PER_PACKET:
            other = octant_of(rays, first + count, trees)
    return 1 if count == RAYS_PER_PACKET else 0


@func
def numbers_of(o: vec3, d: vec3, trees: SceneTrees) -> ray_numbers:
    """NUMBERS_PER_RAY numbers of a ray in the frame of the first object."""
    q = narrow(rotate_into(widen(o), trees.motions, 0) + vector_at(trees.motions, 9))
    e = direction_in(d, trees)
    axes = ray_axes(e)
    shear = shear_of(e, axes)
    low = narrow(vector_at(trees.motions, 12))
    high = narrow(vector_at(trees.motions, 15))
    margins = signed_margins(q, e, low, high, axes)
    a = q + margins
    b = q - margins
    rates = rates_of(e, axes)
    return ray_numbers(
        q[0], q[1], q[2], shear[0], shear[1], shear[2], a[0], a[1], a[2], b[0], b[1], b[2], rates[0], rates[1],
        rates[2], 0.0,
    )  # fmt: skip


@loop
def leaves_of_packet(trees: SceneTrees, numbers: packet, near: vec3i, ends: ray_lanes, limit: float) -> tuple[int, int]:
    """Leaves that rays of a packet enter by their `ends`, which the body may shrink, and a bit mask of these rays. The
    nearest sibling of any ray is first. `limit` is the largest end. As `leaves_on_ray` otherwise."""
    root = trees.rows[ROOT_AT]
    level = root + 0
    node = 0
    is_new = 1
    pending = level_keys(0)
    masks = child_masks(0)  # of the children of the last node of level 0
    while level <= root:
        at = FAN * (level & MAX_LEVEL)
        nearest = int(NOT_ENTERED)
        if is_new == 1:
            for j in range(FAN):
                pending[at + j] = NOT_ENTERED
                masks[j] = 0
            rays = int(RAYS_PER_PACKET)
            for r in range(rays):
                of = NUMBERS_PER_RAY * r
                a = vec3(numbers[of + NEAR_AT], numbers[of + NEAR_AT + 1], numbers[of + NEAR_AT + 2])
                b = vec3(numbers[of + FAR_AT], numbers[of + FAR_AT + 1], numbers[of + FAR_AT + 2])
                rates = vec3(numbers[of + RATES_AT], numbers[of + RATES_AT + 1], numbers[of + RATES_AT + 2])
                end = ends[r]
                for j, key in child_entries(trees.boxes, trees.rows[level] + node, near, a, b, rates, 0.0, end):
                    pending[at + j] = min(pending[at + j], key)
                    masks[j] = masks[j] | ((1 << r) if key < NOT_ENTERED else 0)
        for j in range(FAN):
            nearest = min(nearest, pending[at + j])
        is_new = 0
        if nearest > (float_bits(limit) | 7):
            node = node // FAN
            level = level + 1
        else:
            pending[at + (nearest & 7)] = NOT_ENTERED
            if level == 0:
                leaf = node * FAN + (nearest & 7)
                mask = masks[nearest & 7]
                yield leaf, mask
            else:
                node = node * FAN + (nearest & 7)
                level = level - 1
                is_new = 1
