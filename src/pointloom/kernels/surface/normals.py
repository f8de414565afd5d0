"""Normals: search, covariance and eigenvector in one pass, without neighbor lists.

Hoppe et al., "Surface reconstruction from unorganized points", SIGGRAPH 1992, section 3.1. Covariances about the mean
are integer sums of quantized differences to the query, independent of the order of neighbors.
"""

from collections.abc import Sequence

import numpy as np

from ..algebra.eigen import smallest_eigenvector
from ..algebra.moments import add_integer_moments, covariance_of, in_meters, integer_moments, moments, steps_for
from ..array_types import Points, Vectors
from ..arrays.packed_keys import key_index
from ..lang import NAN, array, dot, float64, func, int32, isfinite, kernel, launch, sqrt, tid, vec3
from ..memory import empty
from ..search.distinct_points import by_distinct_points
from ..search.group_scratch import GroupScratch, LaunchPart, stored_key
from ..search.group_search import farthest_key, launch_over_leaves, nearest_of_leaves
from ..search.point_tree import BUCKET, PointTree, widest_square
from ..search.tree_search import squared_radius
from .neighbor_moments import moments_within

MIN_NEIGHBORS = 3.0  # fewer points define no plane


@func
def normal_of(m: moments) -> vec3:
    """Unit normal of the plane through the neighbors; (0, 0, 1) for fewer than three."""
    n = vec3(0.0, 0.0, 1.0)
    if m[0] >= float64(MIN_NEIGHBORS):
        v = smallest_eigenvector(covariance_of(m))
        n = vec3(float(v[0]), float(v[1]), float(v[2]))
    return n


@kernel(max_registers=80)
def fit_normals_nearest_kernel(
    part: LaunchPart,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    max_sqdist: float,
    normals: array(dtype=vec3),
):
    """Normals from the k nearest points within `max_sqdist`. Keys contain tree positions."""
    i = tid()
    for rank, base, size in nearest_of_leaves(i, part, tree, labels, scratch, max_sqdist, 0):
        p = tree.points[rank]
        steps = steps_for(farthest_key(scratch, base, size), size)
        total = integer_moments(0)
        for j in range(size):
            total = add_integer_moments(total, p, tree.points[key_index(stored_key(scratch, base, j))], steps)
        normals[tree.order[rank]] = normal_of(in_meters(total, steps))


@kernel(max_registers=128)
def fit_normals_within_kernel(tree: PointTree, max_sqdist: float, widest: float, normals: array(dtype=vec3)):
    i = tid()
    normals[tree.order[i]] = normal_of(moments_within(i // BUCKET, tree.points[i], max_sqdist, widest, tree))


@kernel
def align_normals_kernel(references: array(dtype=vec3), normals: array(dtype=vec3)):
    """Flip each normal to the side of its reference, in place."""
    i = tid()
    if dot(normals[i], references[i]) < 0.0:
        normals[i] = -normals[i]


@kernel
def orient_normals_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), to_point: int, reference: vec3, oriented: array(dtype=vec3)
):
    """Orient normals to a direction or a point. A zero normal becomes the reference direction."""
    i = tid()
    n = normals[i]
    toward = reference + vec3(0.0, 0.0, 0.0)
    if to_point == 1:
        toward = reference - points[i]
    if dot(n, n) == 0.0:
        size = sqrt(dot(toward, toward))
        if size > 0.0:
            n = toward / size
        else:
            n = vec3(0.0, 0.0, 1.0)
    else:
        if dot(n, toward) < 0.0:
            n = -n
    oriented[i] = n


@kernel
def fill_missing_normals_kernel(points: array(dtype=vec3), normals: array(dtype=vec3)):
    """Write NaN for non-finite points."""
    i = tid()
    p = points[i]
    if not isfinite(p):
        normals[i] = vec3(NAN, NAN, NAN)


def estimate_normals(tree: PointTree, max_nn: int | None, radius: float) -> Vectors:
    """Normals of a tree's points; `max_nn` (None: all) includes the point itself, `radius` [m] is exclusive.

    Copies of a position count once in neighborhoods that they fill (`by_distinct_points`).
    """
    (normals,) = by_distinct_points(tree, max_nn, radius, lambda tree: [_fit_normals(tree, max_nn, radius)])
    return normals


def _fit_normals(tree: PointTree, max_nn: int | None, radius: float) -> Vectors:
    points, device = tree.source, tree.device
    normals = empty(points.size, vec3, device)
    max_sqdist = squared_radius(radius)
    if max_nn is None:
        launch(fit_normals_within_kernel, tree.count, [tree, max_sqdist, widest_square(tree, max_sqdist), normals])
    else:
        launch_over_leaves(fit_normals_nearest_kernel, tree, max_nn, [max_sqdist, normals])
    if tree.count < points.size:
        launch(fill_missing_normals_kernel, points.size, [points, normals])
    return normals


def orient_normals(
    points: Points, normals: Vectors, reference: Sequence[float] | np.ndarray, to_point: bool
) -> Vectors:
    """Orient normals to the direction `reference`, or to the point `reference` if `to_point`."""
    oriented = empty(normals.size, vec3, normals.device)
    launch(orient_normals_kernel, normals.size, [points, normals, int(to_point), vec3(*reference), oriented])
    return oriented


def align_normals(normals: Vectors, references: Vectors) -> None:
    """Flip each normal to the side of its reference, in place."""
    launch(align_normals_kernel, normals.size, [references, normals])
