"""Smoothed positions: search, weights and sums in one pass, without neighbor lists.

Moving least squares with planes (Alexa et al., IEEE TVCG 2003), bilateral (Jones et al., SIGGRAPH 2003), Laplacian and
Taubin smoothing (Taubin, SIGGRAPH 1995). Float64 sums of differences to the point itself.
"""

from collections.abc import Sequence

from ..algebra.eigen import smallest_eigenvector
from ..algebra.moments import covariance_of, moments
from ..algebra.transform import narrow, widen
from ..array_types import Points, Vectors
from ..arrays.packed_keys import key_index
from ..lang import INFINITY, array, dot, exp, float64, func, int32, kernel, launch, sqrt, struct, tid, vec3, vec3d
from ..memory import copy, empty
from ..search.bucket_walk import points_within
from ..search.distinct_points import by_distinct_points
from ..search.group_scratch import GroupScratch, LaunchPart, stored_key
from ..search.group_search import launch_over_leaves, nearest_of_leaves
from ..search.neighbor_lists import list_neighbors
from ..search.point_tree import BUCKET, PointTree
from ..search.tree_search import squared_radius

MIN_NEIGHBORS = 3  # fewer points define no plane
LARGEST_FALLOFF = 1.0e300  # [1 / m^2] finite product with a zero distance


@struct
class SmoothingPass:
    """`spatial`, `ranged` [1 / m^2] scale squared distances and heights in the exponent of a weight. `to_plane`:
    project to the plane, else move by `factor` to the mean. `own`: weight of the point. `fit_normals`: 1 to write
    plane normals.
    """

    spatial: float64
    ranged: float64
    to_plane: int
    own: float64
    factor: float64
    fit_normals: int
    normals: array(dtype=vec3)
    moved: array(dtype=vec3)
    fitted: array(dtype=vec3)

    def __init__(
        self,
        points: Points,
        normals: Vectors | None,
        *,
        spatial: float = 0.0,
        ranged: float = 0.0,
        to_plane: bool = False,
        own: float = 0.0,
        factor: float = 1.0,
    ) -> None:
        device, self.fit_normals = points.device, int(to_plane and normals is not None)
        self.spatial, self.ranged, self.to_plane = float(spatial), float(ranged), int(to_plane)
        self.own, self.factor = float(own), float(factor)
        self.moved = empty(points.size, vec3, device)
        self.fitted = empty(points.size if self.fit_normals else 1, vec3, device)
        self.normals = self.fitted if normals is None else normals


@func
def add_weighted(total: moments, p: vec3, q: vec3, n: vec3d, rule: SmoothingPass) -> moments:
    """Add the moments of q - p with the weight exp(-(spatial |q - p|^2 + ranged ((q - p) . n)^2))."""
    x = float64(q[0]) - float64(p[0])
    y = float64(q[1]) - float64(p[1])
    z = float64(q[2]) - float64(p[2])
    w = float64(1.0)
    if rule.spatial > 0.0 or rule.ranged > 0.0:
        height = x * n[0] + y * n[1] + z * n[2]
        falloff = (x * x + y * y + z * z) * rule.spatial + height * height * rule.ranged
        w = float64(exp(float(-falloff)))
    wx = w * x
    wy = w * y
    wz = w * z
    return total + moments(w, wx, wy, wz, wx * x, wx * y, wx * z, wy * y, wy * z, wz * z)


@func
def tangent_of(row: int, rule: SmoothingPass) -> vec3d:
    """Direction of heights: the point's unit normal, or zero if it is zero or NaN."""
    unit = vec3d(0.0, 0.0, 0.0)
    if rule.ranged > 0.0:
        wide = widen(rule.normals[row])
        size = dot(wide, wide)
        if size > 0.0:
            unit = wide / sqrt(size)
    return unit


@func
def store_smoothed(m: moments, size: int, p: vec3, n: vec3d, row: int, rule: SmoothingPass):
    """Write the new position of a point from its neighbors' moments; n from `tangent_of`."""
    mean = vec3d(m[1], m[2], m[3])
    move = vec3d(0.0, 0.0, 0.0)
    if rule.to_plane == 1:
        if size >= MIN_NEIGHBORS:
            normal = smallest_eigenvector(covariance_of(m))
            move = normal * (dot(mean, normal) / m[0])
            if rule.fit_normals == 1:
                if dot(normal, widen(rule.normals[row])) < 0.0:
                    normal = -normal
                rule.fitted[row] = narrow(normal)
    else:
        pull = rule.factor
        if rule.ranged > 0.0:
            pull = rule.factor * dot(n, n)  # without a normal the point stays
        rest = m[0] - rule.own
        if rest > 0.0:
            move = mean * (pull / rest)
    rule.moved[row] = narrow(widen(p) + move)


@kernel(max_registers=80)
def smooth_nearest_kernel(
    part: LaunchPart,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    max_sqdist: float,
    rule: SmoothingPass,
):
    """Smooth by the k nearest points within `max_sqdist`. Keys contain tree positions."""
    i = tid()
    for rank, base, size in nearest_of_leaves(i, part, tree, labels, scratch, max_sqdist, 0):
        p = tree.points[rank]
        row = tree.order[rank]
        n = tangent_of(row, rule)
        total = moments(0.0)
        for j in range(size):
            total = add_weighted(total, p, tree.points[key_index(stored_key(scratch, base, j))], n, rule)
        store_smoothed(total, size, p, n, row, rule)


@kernel(max_registers=128)
def smooth_within_kernel(tree: PointTree, max_sqdist: float, rule: SmoothingPass):
    i = tid()
    p = tree.points[i]
    row = tree.order[i]
    n = tangent_of(row, rule)
    total = moments(0.0)
    size = 0
    for j, sqdist in points_within(i // BUCKET, p, max_sqdist, tree):
        total = add_weighted(total, p, tree.points[j], n, rule)
        size += 1
    store_smoothed(total, size, p, n, row, rule)


@kernel
def average_listed_kernel(
    neighbors: array(dtype=int32),
    first: int,
    k: int,
    factor: float64,
    points: array(dtype=vec3),
    moved: array(dtype=vec3),
):
    """Move points by `factor` to the mean of the k listed ones without themselves."""
    i = tid()
    p = points[first + i]
    here = widen(p)
    total = vec3d(0.0, 0.0, 0.0)
    for j in range(i * k, (i + 1) * k):
        total = total + (widen(points[neighbors[j]]) - here)
    moved[first + i] = narrow(here + total * (factor / float64(k - 1)))


@kernel
def scatter_points_kernel(points: array(dtype=vec3), order: array(dtype=int32), scattered: array(dtype=vec3)):
    i = tid()
    scattered[order[i]] = points[i]


def falloff_of(sigma: float) -> float:
    """Factor [1 / m^2] of a squared distance in the exponent of a Gaussian with deviation `sigma` [m]."""
    return min(0.5 / max(sigma * sigma, 1.0 / LARGEST_FALLOFF), LARGEST_FALLOFF)


def _smooth(tree: PointTree, max_nn: int | None, radius: float, rule: SmoothingPass) -> SmoothingPass:
    points = tree.source
    if tree.count < points.size:
        copy(rule.moved, points, count=points.size)
    if rule.fit_normals:
        copy(rule.fitted, rule.normals, count=points.size)
    max_sqdist = squared_radius(radius)
    if max_nn is None:
        launch(smooth_within_kernel, tree.count, [tree, max_sqdist, rule])
        return rule
    launch_over_leaves(smooth_nearest_kernel, tree, max_nn, [max_sqdist, rule])
    return rule


def project_to_planes(
    tree: PointTree, max_nn: int | None, radius: float, normals: Vectors | None = None
) -> tuple[Points, Vectors]:
    """Project points to planes of neighbors, weighted by exp(-d^2 / radius^2): (moved, fitted). Points with fewer than
    three neighbors and non-finite points stay. `fitted` is undefined without `normals`.
    """
    spatial = 0.0 if radius == INFINITY else 2.0 * falloff_of(radius)

    def project(tree: PointTree, *normals: Vectors) -> list[Points | Vectors]:
        given = normals[0] if normals else None
        rule = _smooth(tree, max_nn, radius, SmoothingPass(tree.source, given, spatial=spatial, to_plane=True))
        return [rule.moved, rule.fitted][: 1 + len(normals)]

    known = [] if normals is None else [normals]
    moved, *fitted = by_distinct_points(tree, max_nn, radius, project, *known)
    return moved, fitted[0] if fitted else moved


def average_by_sides(
    tree: PointTree, normals: Vectors, max_nn: int | None, radius: float, sigma_s: float, sigma_r: float
) -> Points:
    """Bilateral mean of the neighbors, deviations [m] in distance and height. Points without a normal stay."""

    def average(tree: PointTree, normals: Vectors) -> list[Points]:
        rule = SmoothingPass(tree.source, normals, spatial=falloff_of(sigma_s), ranged=falloff_of(sigma_r))
        return [_smooth(tree, max_nn, radius, rule).moved]

    (moved,) = by_distinct_points(tree, max_nn, radius, average, normals)
    return moved


def average_passes(tree: PointTree, factors: Sequence[float], neighbor_count: int) -> Points:
    """One pass per factor, with a new search of the nearest neighbors in each."""
    points, k = tree.source, neighbor_count + 1
    for number, factor in enumerate(factors):
        now = tree if number == 0 else PointTree(points)

        def average(tree: PointTree, factor: float = factor) -> list[Points]:
            return [_smooth(tree, k, INFINITY, SmoothingPass(tree.source, None, own=1.0, factor=factor)).moved]

        (points,) = by_distinct_points(now, k, INFINITY, average)
    return points


def average_passes_fixed(tree: PointTree, factors: Sequence[float], neighbor_count: int) -> Vectors:
    """As `average_passes` with the neighbors of the first pass, 4 B per neighbor."""
    (moved,) = by_distinct_points(
        tree, neighbor_count + 1, INFINITY, lambda tree: [_average_fixed(tree, factors, neighbor_count)]
    )
    return moved


def _average_fixed(tree: PointTree, factors: Sequence[float], neighbor_count: int) -> Vectors:
    device, points = tree.device, tree.source
    moved = empty(points.size, vec3, device)
    copy(moved, points, count=points.size)
    k = min(neighbor_count + 1, tree.count)
    if k < 2:
        return moved
    # There are k points, so a list is short only by the point itself. If more than k duplicates hide a point from its
    # own list, the whole list is duplicates and none of them moves.
    lists = list(list_neighbors(tree, k, sort=False, own=True))
    here, there = empty(tree.count, vec3, device), empty(tree.count, vec3, device)
    copy(here, tree.points, count=tree.count)
    for factor in factors:
        for first, neighbors in lists:
            launch(average_listed_kernel, neighbors.size // k, [neighbors, first, k, float(factor), here, there])
        here, there = there, here
    launch(scatter_points_kernel, tree.count, [here, tree.order, moved])
    return moved
