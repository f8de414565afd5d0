"""The next triangle that a ray meets in a scene: by parameter, then by the number of the place, then of the triangle.

All queries of rays are this one. It takes each place whose box the ray enters, the nearest first, turns the ray into
the frame of the mesh there, and walks that mesh's tree (ray_walk.py); what is farther than the best so far is left out.
Equal parameters go to the smallest numbers, whatever the trees look like.
"""

from ..algebra.transform import narrow, widen
from ..lang import INFINITY, array, float64, func, int64, isfinite, loop, vec3, vec3d, vec3i, vector
from ..search.tree_walk import bits_of
from .ray_walk import (
    is_ray,
    lanes_met,
    leaf_walk,
    leaves_on_ray,
    meet_triangle,
    near_sides,
    next_leaf,
    rates_of,
    ray_axes,
    shear_of,
    signed_margins,
)
from .scene_trees import FIRST_LEAF, MOTION, NUMBER, ROOT, ROW, SceneTrees
from .triangle_tree import LEAF

WIDER = 1.000001  # of a depth that bounds a walk from above: the roundings of its product
NARROWER = 0.999999  # and from below
NOWHERE = 2**31 - 1  # the number of what is not there
hit = vector(5, float64)  # the parameter, the place's row, where the triangle stands in the order, weights of 2 corners


@func
def no_hit() -> hit:
    """What is found where nothing is met."""
    nothing = float64(0.0)
    return hit(float64(INFINITY), nothing, nothing, nothing, nothing)


@func
def vector_at(motions: array(dtype=float64), at: int) -> vec3d:
    """Three numbers of a place."""
    return vec3d(motions[at], motions[at + 1], motions[at + 2])


@func
def turn_into(d: vec3d, motions: array(dtype=float64), row: int) -> vec3d:
    """A direction of the scene in the frame of the mesh at a place."""
    at = row * MOTION
    x = vector_at(motions, at)
    y = vector_at(motions, at + 3)
    z = vector_at(motions, at + 6)
    return vec3d(
        x[0] * d[0] + x[1] * d[1] + x[2] * d[2],
        y[0] * d[0] + y[1] * d[1] + y[2] * d[2],
        z[0] * d[0] + z[1] * d[1] + z[2] * d[2],
    )


@func
def turn_back(n: vec3d, motions: array(dtype=float64), row: int) -> vec3d:
    """A direction in the frame of the mesh at a place, in the scene's."""
    at = row * MOTION
    return vector_at(motions, at) * n[0] + vector_at(motions, at + 3) * n[1] + vector_at(motions, at + 6) * n[2]


@func
def next_place(
    step: leaf_walk, near: vec3i, a: vec3, b: vec3, rates: vec3, begin: float, reach: float, trees: SceneTrees
) -> leaf_walk:
    """`next_leaf` of the tree over the places, with room for the roundings of depths."""
    low = begin * NARROWER
    high = reach * WIDER
    return next_leaf(step, trees.place_levels, trees.place_root, trees.place_boxes, near, a, b, rates, low, high)


@loop
def places_on_ray(o: vec3, d: vec3, nearest: float, farthest: float, trees: SceneTrees) -> int:
    """The rows of the places whose boxes a ray enters by `farthest`, which the body may shrink; a single one anyway."""
    nothing = vec3(0.0, 0.0, 0.0)
    axes = ray_axes(d)
    main = abs(d[axes[2]])
    near = near_sides(d)
    rates = nothing
    a = nothing
    b = nothing
    step = leaf_walk(int64(trees.place_root), 0, ~int64(0), 0)
    if trees.place_count > 1:
        rates = rates_of(d, axes)
        margins = signed_margins(o, d, trees.low, trees.high, axes)
        a = o + margins
        b = o - margins
        step = next_place(step, near, a, b, rates, nearest * main, farthest * main, trees)
    while int(step[3]) >= 0:
        row = int(step[3])
        yield row
        step = leaf_walk(step[0], step[1], step[2], -1)
        if trees.place_count > 1 and farthest >= 0.0:
            step = next_place(step, near, a, b, rates, nearest * main, farthest * main, trees)


@func
def next_hit(
    o: vec3, d: vec3, nearest: float, farthest: float, after: float64, above: int, any_hit: int, trees: SceneTrees
) -> hit:
    """The first hit of a ray with a parameter from `nearest` to `farthest`.

    Args:
        o, d: The ray in the scene's frame.
        nearest, farthest: Both included; not negative.
        after, above: Only hits of a larger parameter than `after`, or of this one at places numbered above `above`.
        any_hit: 1 where any hit will do.
        trees: The scene.

    Returns:
        no_hit() where there is none, or the ray is none.
    """
    best = no_hit()
    if is_ray(o, d) == 1:
        best_t = farthest
        best_number = int(NOWHERE)
        best_triangle = int(NOWHERE)
        for row in places_on_ray(o, d, nearest, best_t, trees):
            p = turn_into(widen(o), trees.motions, row) + vector_at(trees.motions, row * MOTION + 9)
            q = narrow(p)
            e = narrow(turn_into(widen(d), trees.motions, row))
            low = narrow(vector_at(trees.motions, row * MOTION + 12))
            high = narrow(vector_at(trees.motions, row * MOTION + 15))
            number = trees.rows[row * ROW + NUMBER]
            first_leaf = trees.rows[row * ROW + FIRST_LEAF]
            own_axes = ray_axes(e)
            shear = shear_of(e, own_axes)
            own_main = abs(shear[2])
            own_near = near_sides(e)
            own_rates = rates_of(e, own_axes)
            own_margins = signed_margins(q, e, low, high, own_axes)
            own_a = q + own_margins
            own_b = q - own_margins
            own_begin = nearest * own_main * NARROWER
            own_reach = best_t * own_main * WIDER
            for leaf in leaves_on_ray(
                trees.rows,
                row * ROW,
                trees.rows[row * ROW + ROOT],
                trees.boxes,
                own_near,
                own_a,
                own_b,
                own_rates,
                own_begin,
                own_reach,
            ):
                place = first_leaf + leaf
                for lane in bits_of(lanes_met(trees.corners, place, q, own_axes, shear)):
                    met = meet_triangle(trees.corners, place, lane, q, own_axes, shear)
                    t = float(met[0] / float64(own_main))
                    is_later = float64(t) > after or (float64(t) == after and number > above)
                    if is_later and t >= nearest and t <= best_t and isfinite(t):
                        triangle = trees.order[place * LEAF + lane]
                        is_first = t < best_t or number < best_number
                        if is_first or (number == best_number and triangle < best_triangle):
                            best_t = t
                            best_number = number
                            best_triangle = triangle
                            best = hit(float64(t), float64(row), float64(place * LEAF + lane), met[2], met[3])
                            own_reach = best_t * own_main * WIDER
                            if any_hit == 1:
                                own_reach = -1.0
                                best_t = -1.0
    return best
