"""Fraction of near neighbors whose normals point to opposite sides of their common surface.

A pair (point, one of its k nearest) counts if both normals are valid, their lines are within 60 degrees, and the offset
is within 45 degrees of the first tangent plane, which excludes creases and opposite wall sides. It is opposed if the
normals differ by more than 90 degrees. Integer counts.
"""

from ..algebra.transform import widen
from ..array_types import Points, Vectors
from ..arrays.packed_keys import key_index
from ..arrays.prefix_sum import sum_each
from ..arrays.select import gather_rows
from ..lang import INFINITY, array, dot, float64, func, int32, isfinite, kernel, tid, vec3
from ..memory import zeros
from ..search.distinct_points import distinct_points
from ..search.group_scratch import GroupScratch, LaunchPart, stored_key
from ..search.group_search import launch_over_leaves, nearest_of_leaves
from ..search.point_tree import PointTree
from ..search.tree_search import squared_radius

MIN_SQUARED_COSINE = 0.25  # squared cosine of 60 degrees
MAX_SQUARED_SINE = 0.5  # squared sine of 45 degrees


@func
def compare_sides(p: vec3, n: vec3, q: vec3, m: vec3) -> int:
    """1 for a pair with normals to the same side, -1 for opposite sides, 0 if it does not count."""
    side = 0
    a = widen(n)
    b = widen(m)
    along = dot(a, b)
    way = widen(q) - widen(p)
    height = dot(way, a)
    if isfinite(along) and along * along >= float64(MIN_SQUARED_COSINE) * (dot(a, a) * dot(b, b)):
        if height * height <= float64(MAX_SQUARED_SINE) * (dot(way, way) * dot(a, a)):
            if along > 0.0:
                side = 1
            if along < 0.0:
                side = -1
    return side


@kernel(max_registers=80)
def count_sides_kernel(
    part: LaunchPart,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    max_sqdist: float,
    normals: array(dtype=vec3),
    counted: array(dtype=int32),
    opposed: array(dtype=int32),
):
    i = tid()
    for rank, base, size in nearest_of_leaves(i, part, tree, labels, scratch, max_sqdist, 0):
        p = tree.points[rank]
        n = normals[tree.order[rank]]
        pairs = 0
        against = 0
        for slot in range(size):
            j = key_index(stored_key(scratch, base, slot))
            if j != rank:
                side = compare_sides(p, n, tree.points[j], normals[tree.order[j]])
                if side != 0:
                    pairs += 1
                if side < 0:
                    against += 1
        counted[rank] = pairs
        opposed[rank] = against


def fraction_of_opposed_normals(tree: PointTree, points: Points, normals: Vectors, k: int) -> float:
    """Fraction of opposed pairs among the counted ones, 0 if there are none. `k` neighbors without the point itself."""
    distinct = distinct_points(tree, k + 1)
    if distinct is not None:
        tree, points = distinct.tree, distinct.tree.source
        normals = gather_rows(normals, distinct.firsts)
    counted, opposed = (zeros(points.size, int32, points.device) for _ in range(2))
    launch_over_leaves(count_sides_kernel, tree, k + 1, [squared_radius(INFINITY), normals, counted, opposed])
    pairs, against = sum_each(counted, opposed)  # sync
    return against / pairs if pairs else 0.0
