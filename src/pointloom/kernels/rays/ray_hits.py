"""Next hit of a ray in a scene, ordered by parameter, object, triangle.

Rays are sheared to their main axis (Woop, Benthin and Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013).
Float32 edge products are compared, and ties are resolved exactly in float64, so no ray passes between adjacent
triangles. Depth and weights are float64. On an edge or corner the depth is bitwise equal for all its triangles. Boxes
are enlarged by more than all rounding, so results are independent of them. Nearest-first traversal.
"""

from ..algebra.plain_min_max import larger, smaller
from ..algebra.transform import narrow, widen
from ..arrays.packed_keys import BYTE_MASK
from ..lang import (
    INFINITY,
    array,
    float32,
    float64,
    float_bits,
    func,
    int32,
    int64,
    isfinite,
    loop,
    vec3,
    vec3d,
    vec3i,
    vector,
)
from ..search.point_tree import FAN, SIDES
from ..search.tree_walk import bits_of
from .scene_trees import FIRST_LEAF_AT, MOTION_NUMBERS, NUMBER_AT, ROOT_AT, ROW_INTEGERS, SceneTrees
from .triangle_tree import LEAF_NUMBERS, LEAF_SIZE, MAX_LEVEL, level_keys

FULL_BYTE = 255
MIN_DIRECTION_RATIO = 1.0e-30
RELATIVE_MARGIN = 1.0e-6  # of the distance to the farthest corner: 16 float32 roundings, twice the actual error
MAX_SLOPE = 1.0e30  # maximum slope to the main axis; steeper ones move by less than the margin
NOT_ENTERED = 0x7FFFFFFF  # above the bits of any number
entry_keys = vector(8, int32)
leaf_traversal = vector(4, int64)
lane_numbers = vector(8, float32)
depth_and_weights = vector(4, float64)
weights_and_depth = vector(3, float64)


@func
def find_main_axis(d: vec3) -> int:
    axis = 0
    if abs(d[1]) > abs(d[0]):
        axis = 1
    if abs(d[2]) > abs(d[axis]):
        axis = 2
    return axis


@func
def ray_axes(d: vec3) -> vec3i:
    """The two other axes, and the main one."""
    axis = find_main_axis(d)
    return vec3i((axis + 1) % 3, (axis + 2) % 3, axis)


@func
def is_ray(o: vec3, d: vec3) -> int:
    """1 if origin and direction are finite and the direction is not zero."""
    valid = 0
    if isfinite(o) and isfinite(d):
        if max(abs(d[0]), max(abs(d[1]), abs(d[2]))) > 0.0:
            valid = 1
    return valid


@func
def shear_of(d: vec3, axes: vec3i) -> vec3:
    """Shear along the other axes per unit of the main one, and the main component."""
    main = d[axes[2]]
    return vec3(d[axes[0]] / main, d[axes[1]] / main, main)


@func
def signed_margins(o: vec3, d: vec3, low: vec3, high: vec3, axes: vec3i) -> vec3:
    """Margins of the boxes' sides per axis, with the sign of the direction."""
    margins = vec3(0.0, 0.0, 0.0)
    for k in range(3):
        margins[k] = larger(abs(low[k] - o[k]), abs(high[k] - o[k]))
    main = margins[axes[2]]
    for k in range(3):
        margin = (margins[k] + main) * RELATIVE_MARGIN
        margins[k] = margin if d[k] >= 0.0 else -margin
    return margins


@func
def rates_of(d: vec3, axes: vec3i) -> vec3:
    """Depth along the main axis per unit of each axis. With the direction's sign."""
    main = abs(d[axes[2]])
    rates = vec3(0.0, 0.0, 0.0)
    for k in range(3):
        rate = smaller(main / larger(abs(d[k]), main * MIN_DIRECTION_RATIO), MAX_SLOPE)
        rates[k] = rate if d[k] >= 0.0 else -rate
    return rates


@func
def near_sides(d: vec3) -> vec3i:
    """Offsets in a record of the sides at which the ray enters boxes, per axis."""
    sides = vec3i(0, 0, 0)
    for k in range(3):
        sides[k] = k * FAN if d[k] >= 0.0 else (k + 3) * FAN
    return sides


@loop
def child_entries(
    boxes: array(dtype=float32), record: int, near: vec3i, a: vec3, b: vec3, rates: vec3, begin: float, end: float
) -> tuple[int, int]:
    """Each child, and depth bits of its box on the ray, lowest three bits the child; NOT_ENTERED beyond `end`."""
    at = record * SIDES
    x0 = at + near[0]
    y0 = at + near[1]
    z0 = at + near[2]
    x1 = at + 3 * FAN - near[0]
    y1 = at + 5 * FAN - near[1]
    z1 = at + 7 * FAN - near[2]
    for j in range(FAN):
        x = (boxes[x0 + j] - a[0]) * rates[0]
        y = (boxes[y0 + j] - a[1]) * rates[1]
        z = (boxes[z0 + j] - a[2]) * rates[2]
        first = larger(larger(x, y), larger(z, begin))
        u = (boxes[x1 + j] - b[0]) * rates[0]
        v = (boxes[y1 + j] - b[1]) * rates[1]
        w = (boxes[z1 + j] - b[2]) * rates[2]
        last = smaller(smaller(u, v), smaller(w, end))
        key = ((float_bits(first) & ~7) | j) if first <= last else NOT_ENTERED
        yield j, key


@func
def measure_entries(
    boxes: array(dtype=float32), record: int, near: vec3i, a: vec3, b: vec3, rates: vec3, begin: float, end: float
) -> entry_keys:
    """Keys of a record's children by `child_entries`."""
    keys = entry_keys(0)
    for j, key in child_entries(boxes, record, near, a, b, rates, begin, end):
        keys[j] = key
    return keys


@func
def first_entered(keys: entry_keys, left: int) -> int:
    passed = BYTE_MASK ^ left
    open_keys = keys
    for j in range(FAN):
        open_keys[j] = NOT_ENTERED if ((passed >> j) & 1) == 1 else keys[j]
    a = min(min(open_keys[0], open_keys[1]), min(open_keys[2], open_keys[3]))
    b = min(min(open_keys[4], open_keys[5]), min(open_keys[6], open_keys[7]))
    return min(a, b)


@func
def entered_bits(keys: entry_keys) -> int:
    bits = keys
    for j in range(FAN):
        bits[j] = ((keys[j] - NOT_ENTERED) >> 31) & (1 << j)
    return ((bits[0] | bits[1]) | (bits[2] | bits[3])) | ((bits[4] | bits[5]) | (bits[6] | bits[7]))


@loop
def leaves_on_ray(
    levels: array(dtype=int32),
    first: int,
    root: int,
    boxes: array(dtype=float32),
    near: vec3i,
    a: vec3,
    b: vec3,
    rates: vec3,
    begin: float,
    end: float,
) -> int:
    """Leaves whose boxes a ray enters by `end`, which the body may shrink. Nearest sibling first.

    A node is measured once: `pending` stores the keys of its children, NOT_ENTERED after the visit.
    """
    level = root
    node = 0
    is_new = 1
    pending = level_keys(0)
    while level <= root:
        at = FAN * (level & MAX_LEVEL)  # never negative, which saves a check of each index
        nearest = int(NOT_ENTERED)
        if is_new == 1:
            for j, key in child_entries(boxes, levels[first + level] + node, near, a, b, rates, begin, end):
                pending[at + j] = key
                nearest = min(nearest, key)
        else:
            for j in range(FAN):
                nearest = min(nearest, pending[at + j])
        is_new = 0
        if nearest > (float_bits(end) | 7):
            node = node // FAN
            level = level + 1
        else:
            pending[at + (nearest & 7)] = NOT_ENTERED
            if level == 0:
                leaf = node * FAN + (nearest & 7)
                yield leaf
            else:
                node = node * FAN + (nearest & 7)
                level = level - 1
                is_new = 1


@leaves_on_ray.on_cuda
def leaves_on_ray_by_bits(
    levels: array(dtype=int32),
    first: int,
    root: int,
    boxes: array(dtype=float32),
    near: vec3i,
    a: vec3,
    b: vec3,
    rates: vec3,
    begin: float,
    end: float,
) -> int:
    """CUDA variant with a bit per child instead of its key: a vector with a computed index is slow there."""
    level = root
    node = 0
    pending = ~int64(0)
    while level <= root:
        shift = int64(FAN * max(level - 1, 0))
        left = int(BYTE_MASK)
        if level > 0:
            left = int(pending >> shift) & BYTE_MASK
        key = int(NOT_ENTERED)
        if left != 0:
            keys = measure_entries(boxes, levels[first + level] + node, near, a, b, rates, begin, end)
            key = first_entered(keys, left)
            if level == 0:
                while key < NOT_ENTERED and key <= (float_bits(end) | 7):
                    leaf = node * FAN + (key & 7)
                    yield leaf
                    left = left ^ (1 << (key & 7))
                    key = first_entered(keys, left)
                key = NOT_ENTERED
            else:
                others = entered_bits(keys) & left & ~(1 << (key & 7))
                pending = (pending & ~(int64(FULL_BYTE) << shift)) | (int64(others) << shift)
        if key < NOT_ENTERED:
            node = node * FAN + (key & 7)
            level = level - 1
            if level > 0:
                pending = pending | (int64(FULL_BYTE) << int64(FAN * (level - 1)))
        else:
            node = node // FAN
            level = level + 1


@func
def next_leaf(
    step: leaf_traversal,
    levels: array(dtype=int32),
    root: int,
    boxes: array(dtype=float32),
    near: vec3i,
    a: vec3,
    b: vec3,
    rates: vec3,
    begin: float,
    end: float,
) -> leaf_traversal:
    """Advance to the next leaf of a small tree, in the order of `leaves_on_ray`; -1 at the end."""
    level = int(step[0])
    node = int(step[1])
    pending = step[2]
    leaf = -1
    while leaf < 0 and level <= root:
        shift = int64(FAN * level)
        left = int(pending >> shift) & BYTE_MASK
        key = int(NOT_ENTERED)
        if left != 0:
            keys = measure_entries(boxes, levels[level] + node, near, a, b, rates, begin, end)
            key = first_entered(keys, left)
            others = entered_bits(keys) & left & ~(1 << (key & 7))
            pending = (pending & ~(int64(FULL_BYTE) << shift)) | (int64(others) << shift)
        if key == NOT_ENTERED:
            node = node // FAN
            level = level + 1
        else:
            if level == 0:
                leaf = node * FAN + (key & 7)
            else:
                node = node * FAN + (key & 7)
                level = level - 1
                pending = pending | (int64(FULL_BYTE) << int64(FAN * level))
    return leaf_traversal(int64(level), int64(node), pending, int64(leaf))


@func
def lanes_met(corners: array(dtype=float32), leaf: int, o: vec3, axes: vec3i, shear: vec3) -> int:
    """Bit mask of the leaf triangles that the ray may hit, by float32 products (monotonic; ties are hits)."""
    x = leaf * LEAF_NUMBERS + axes[0] * LEAF_SIZE
    y = leaf * LEAF_NUMBERS + axes[1] * LEAF_SIZE
    z = leaf * LEAF_NUMBERS + axes[2] * LEAF_SIZE
    ox = o[axes[0]]
    oy = o[axes[1]]
    oz = o[axes[2]]
    sides = lane_numbers(0.0)
    for j in range(LEAF_SIZE):
        az = corners[z + j] - oz
        ax = (corners[x + j] - ox) - shear[0] * az
        ay = (corners[y + j] - oy) - shear[1] * az
        bz = corners[z + 3 * LEAF_SIZE + j] - oz
        bx = (corners[x + 3 * LEAF_SIZE + j] - ox) - shear[0] * bz
        by = (corners[y + 3 * LEAF_SIZE + j] - oy) - shear[1] * bz
        cz = corners[z + 6 * LEAF_SIZE + j] - oz
        cx = (corners[x + 6 * LEAF_SIZE + j] - ox) - shear[0] * cz
        cy = (corners[y + 6 * LEAF_SIZE + j] - oy) - shear[1] * cz
        u = cx * by - cy * bx
        v = ax * cy - ay * cx
        w = bx * ay - by * ax
        # non-negative if all three have one sign, or zero
        sides[j] = larger(smaller(u, smaller(v, w)), -larger(u, larger(v, w)))
    mask = 0
    for j in range(LEAF_SIZE):
        mask = mask | ((1 << j) if sides[j] >= 0.0 else 0)
    return mask


@func
def cross_products(ax: float, ay: float, bx: float, by: float) -> float64:
    """ax by - ay bx with exact products, so its sign is exact."""
    return float64(ax) * float64(by) - float64(ay) * float64(bx)


@func
def meet_edge(ax: float, ay: float, az: float, bx: float, by: float, bz: float) -> weights_and_depth:
    """Weights of two points at the zero between them, and the depth, bitwise symmetric. Zeros stay exact."""
    swapped = 1 if bx < ax or (bx == ax and by < ay) else 0
    p = float64(bx if swapped == 1 else ax)
    q = float64(ax if swapped == 1 else bx)
    if abs(float64(by) - float64(ay)) > abs(q - p):
        p = float64(by if swapped == 1 else ay)
        q = float64(ay if swapped == 1 else by)
    near = float64(bz if swapped == 1 else az)
    far = float64(az if swapped == 1 else bz)
    fraction = -p / (q - p)
    rest = 1.0 - fraction
    depth = (near * q - far * p) / (q - p)
    weights = weights_and_depth(rest, fraction, depth)
    if swapped == 1:
        weights = weights_and_depth(fraction, rest, depth)
    return weights


@func
def meet_triangle(
    corners: array(dtype=float32), leaf: int, lane: int, o: vec3, axes: vec3i, shear: vec3
) -> depth_and_weights:
    """Depth along the main axis of a triangle hit, and corner weights; infinite depth for no hit or a coplanar line."""
    at = leaf * LEAF_NUMBERS + lane
    x = at + axes[0] * LEAF_SIZE
    y = at + axes[1] * LEAF_SIZE
    z = at + axes[2] * LEAF_SIZE
    oz = o[axes[2]]
    az = corners[z] - oz
    ax = (corners[x] - o[axes[0]]) - shear[0] * az
    ay = (corners[y] - o[axes[1]]) - shear[1] * az
    bz = corners[z + 3 * LEAF_SIZE] - oz
    bx = (corners[x + 3 * LEAF_SIZE] - o[axes[0]]) - shear[0] * bz
    by = (corners[y + 3 * LEAF_SIZE] - o[axes[1]]) - shear[1] * bz
    cz = corners[z + 6 * LEAF_SIZE] - oz
    cx = (corners[x + 6 * LEAF_SIZE] - o[axes[0]]) - shear[0] * cz
    cy = (corners[y + 6 * LEAF_SIZE] - o[axes[1]]) - shear[1] * cz
    zero = float64(0.0)
    one = float64(1.0)
    u = cross_products(cx, cy, bx, by)
    v = cross_products(ax, ay, cx, cy)
    w = cross_products(bx, by, ax, ay)
    total = u + v + w
    met = depth_and_weights(float64(INFINITY), zero, zero, zero)
    if total != zero and (min(u, min(v, w)) >= zero or max(u, max(v, w)) <= zero):
        depth = (u * float64(az) + v * float64(bz) + w * float64(cz)) / total
        u = u / total + zero  # avoids minus zero
        v = v / total + zero
        w = w / total + zero
        if u == zero and v != zero and w != zero:
            edge = meet_edge(bx, by, bz, cx, cy, cz)
            v = edge[0]
            w = edge[1]
            depth = edge[2]
        if v == zero and w != zero and u != zero:
            edge = meet_edge(cx, cy, cz, ax, ay, az)
            w = edge[0]
            u = edge[1]
            depth = edge[2]
        if w == zero and u != zero and v != zero:
            edge = meet_edge(ax, ay, az, bx, by, bz)
            u = edge[0]
            v = edge[1]
            depth = edge[2]
        if u == one or v == one or w == one:
            depth = u * float64(az) + v * float64(bz) + w * float64(cz)  # exact at a corner
        if shear[2] < 0.0:
            depth = zero - depth  # avoids minus zero
        met = depth_and_weights(depth, u, v, w)
    return met


UPPER_DEPTH_FACTOR = 1.000001  # upper bound of a depth, including rounding
LOWER_DEPTH_FACTOR = 0.999999  # lower bound
NO_OBJECT = 2**31 - 1  # number of missing objects
hit = vector(5, float64)  # parameter, object row, triangle position, weights of 2 corners


@func
def no_hit() -> hit:
    zero = float64(0.0)
    return hit(float64(INFINITY), zero, zero, zero, zero)


@func
def vector_at(motions: array(dtype=float64), at: int) -> vec3d:
    return vec3d(motions[at], motions[at + 1], motions[at + 2])


@func
def rotate_into(d: vec3d, motions: array(dtype=float64), row: int) -> vec3d:
    """Rotate a direction from the scene to an object's mesh frame."""
    at = row * MOTION_NUMBERS
    x = vector_at(motions, at)
    y = vector_at(motions, at + 3)
    z = vector_at(motions, at + 6)
    return vec3d(
        x[0] * d[0] + x[1] * d[1] + x[2] * d[2],
        y[0] * d[0] + y[1] * d[1] + y[2] * d[2],
        z[0] * d[0] + z[1] * d[1] + z[2] * d[2],
    )


@func
def rotate_back(n: vec3d, motions: array(dtype=float64), row: int) -> vec3d:
    """Rotate a direction from an object's mesh frame to the scene."""
    at = row * MOTION_NUMBERS
    return vector_at(motions, at) * n[0] + vector_at(motions, at + 3) * n[1] + vector_at(motions, at + 6) * n[2]


@func
def next_object(
    step: leaf_traversal, near: vec3i, a: vec3, b: vec3, rates: vec3, begin: float, end: float, trees: SceneTrees
) -> leaf_traversal:
    """`next_leaf` of the object tree, with a margin for rounding of depths."""
    low = begin * LOWER_DEPTH_FACTOR
    high = end * UPPER_DEPTH_FACTOR
    return next_leaf(step, trees.object_levels, trees.object_root, trees.object_boxes, near, a, b, rates, low, high)


@loop
def objects_on_ray(o: vec3, d: vec3, nearest: float, farthest: float, trees: SceneTrees) -> int:
    """Rows of objects whose boxes a ray enters by `farthest`, which may shrink. Always includes a single one."""
    zero = vec3(0.0, 0.0, 0.0)
    axes = ray_axes(d)
    main = abs(d[axes[2]])
    near = near_sides(d)
    rates = zero
    a = zero
    b = zero
    step = leaf_traversal(int64(trees.object_root), 0, ~int64(0), 0)
    if trees.object_count > 1:
        rates = rates_of(d, axes)
        margins = signed_margins(o, d, trees.low, trees.high, axes)
        a = o + margins
        b = o - margins
        step = next_object(step, near, a, b, rates, nearest * main, farthest * main, trees)
    while int(step[3]) >= 0:
        row = int(step[3])
        yield row
        step = leaf_traversal(step[0], step[1], step[2], -1)
        if trees.object_count > 1 and farthest >= 0.0:
            step = next_object(step, near, a, b, rates, nearest * main, farthest * main, trees)


@func
def next_hit(
    o: vec3, d: vec3, nearest: float, farthest: float, after: float64, above: int, any_hit: int, trees: SceneTrees
) -> hit:
    """First hit in `nearest`..`farthest` after (`after`, object `above`), or any hit with `any_hit`, or no_hit()."""
    best = no_hit()
    if is_ray(o, d) == 1:
        best_t = farthest
        best_number = int(NO_OBJECT)
        best_triangle = int(NO_OBJECT)
        for row in objects_on_ray(o, d, nearest, best_t, trees):
            p = rotate_into(widen(o), trees.motions, row) + vector_at(trees.motions, row * MOTION_NUMBERS + 9)
            q = narrow(p)
            e = narrow(rotate_into(widen(d), trees.motions, row))
            low = narrow(vector_at(trees.motions, row * MOTION_NUMBERS + 12))
            high = narrow(vector_at(trees.motions, row * MOTION_NUMBERS + 15))
            number = trees.rows[row * ROW_INTEGERS + NUMBER_AT]
            first_leaf = trees.rows[row * ROW_INTEGERS + FIRST_LEAF_AT]
            own_axes = ray_axes(e)
            shear = shear_of(e, own_axes)
            own_main = abs(shear[2])
            own_near = near_sides(e)
            own_rates = rates_of(e, own_axes)
            own_margins = signed_margins(q, e, low, high, own_axes)
            own_a = q + own_margins
            own_b = q - own_margins
            own_begin = nearest * own_main * LOWER_DEPTH_FACTOR
            own_end = best_t * own_main * UPPER_DEPTH_FACTOR
            for leaf in leaves_on_ray(
                trees.rows,
                row * ROW_INTEGERS,
                trees.rows[row * ROW_INTEGERS + ROOT_AT],
                trees.boxes,
                own_near,
                own_a,
                own_b,
                own_rates,
                own_begin,
                own_end,
            ):
                leaf_index = first_leaf + leaf
                for lane in bits_of(lanes_met(trees.corners, leaf_index, q, own_axes, shear)):
                    met = meet_triangle(trees.corners, leaf_index, lane, q, own_axes, shear)
                    t = float(met[0] / float64(own_main))
                    is_after = float64(t) > after or (float64(t) == after and number > above)
                    if is_after and t >= nearest and t <= best_t and isfinite(t):
                        triangle = trees.order[leaf_index * LEAF_SIZE + lane]
                        is_first = t < best_t or number < best_number
                        if is_first or (number == best_number and triangle < best_triangle):
                            best_t = t
                            best_number = number
                            best_triangle = triangle
                            best = hit(float64(t), float64(row), float64(leaf_index * LEAF_SIZE + lane), met[2], met[3])
                            own_end = best_t * own_main * UPPER_DEPTH_FACTOR
                            if any_hit == 1:
                                own_end = -1.0
                                best_t = -1.0
    return best
