"""Smoothed positions: neighbours are searched, weighted and summed in one pass, with no list of them in memory.

A point moves onto the plane through its neighbours (moving least squares: Alexa et al., "Computing and rendering point
set surfaces", IEEE TVCG 2003, with the plane alone), or towards their weighted mean (bilateral: Jones et al.,
"Non-iterative, feature-preserving mesh smoothing", SIGGRAPH 2003; Laplacian and Taubin: Taubin, "A signal processing
approach to fair surface design", SIGGRAPH 1995, over nearest neighbours). Sums are of differences to the point itself,
in float64, so coordinates of any size do no harm; a position is rounded once. 12 B read and 12 B written a point beside
the search. Where neighbourhoods stay fixed their list takes 4 B a neighbour.
"""

from ..algebra.eigen import smallest_eigenvector
from ..algebra.transform import narrow, widen
from ..arrays.sort import fill_positions_kernel
from ..lang import INFINITY, array, dot, exp, float64, func, int32, int64, kernel, launch, sqrt, tid, vec3, vec3d
from ..memory import copy, empty
from ..search.group_search import GUESS, GroupScratch, farthest_key, gather_around_leaf, grown_reach, search_member
from ..search.point_tree import (
    BUCKET,
    FAN,
    INDEX_MASK,
    LEAF,
    PointTree,
    points_in_reach,
    square_distance,
)
from ..search.tree_search import reach_of
from .normals import covariance_of, moments

MIN_NEIGHBORS = 3  # fewer points span no plane
LARGEST_FALLOFF = 1.0e300  # [1 / m^2] keeps the product with a distance of zero a number


@func
def add_weighted(total: moments, p: vec3, q: vec3, n: vec3d, spatial: float64, ranged: float64) -> moments:
    """Add the moments of q - p with the weight exp(-(spatial |q - p|^2 + ranged ((q - p) . n)^2))."""
    x = float64(q[0]) - float64(p[0])
    y = float64(q[1]) - float64(p[1])
    z = float64(q[2]) - float64(p[2])
    w = float64(1.0)
    if spatial > float64(0.0) or ranged > float64(0.0):
        height = x * n[0] + y * n[1] + z * n[2]
        falloff = (x * x + y * y + z * z) * spatial + height * height * ranged
        w = float64(exp(float(-falloff)))
    wx = w * x
    wy = w * y
    wz = w * z
    return total + moments(w, wx, wy, wz, wx * x, wx * y, wx * z, wy * y, wy * z, wz * z)


@func
def unit_or_zero(n: vec3) -> vec3d:
    """The direction of a normal; zero for one of no length, or NaN."""
    wide = widen(n)
    size = dot(wide, wide)
    unit = vec3d(float64(0.0), float64(0.0), float64(0.0))
    if size > float64(0.0):
        unit = wide / sqrt(size)
    return unit


@func
def store_smoothed(
    m: moments,
    size: int,
    p: vec3,
    row: int,
    to_plane: int,
    own: float64,
    factor: float64,
    moved: array(dtype=vec3),
    turn: int,
    normals: array(dtype=vec3),
    fitted: array(dtype=vec3),
) -> int:
    """Write the place of one point: on the plane of its neighbours' moments, or `factor` of the way to their mean.

    The weight `own` of the point itself does not count in the mean. With `turn` the plane's normal is written too, on
    the side of the normal before. 1, as a function returns something.
    """
    mean = vec3d(m[1], m[2], m[3])
    move = vec3d(float64(0.0), float64(0.0), float64(0.0))
    if to_plane == 1:
        if size >= MIN_NEIGHBORS:
            n = smallest_eigenvector(covariance_of(m))
            move = n * (dot(mean, n) / m[0])
            if turn == 1:
                if dot(n, widen(normals[row])) < float64(0.0):
                    n = -n
                fitted[row] = narrow(n)
    else:
        rest = m[0] - own
        if rest > float64(0.0):
            move = mean * (factor / rest)
    moved[row] = narrow(widen(p) + move)
    return 1


@kernel
def smooth_nearest_kernel(
    first: int,
    last: int,
    run: int,
    tree: PointTree,
    places: array(dtype=int32),
    scratch: GroupScratch,
    order: array(dtype=int32),
    reach: float,
    spatial: float64,
    ranged: float64,
    to_plane: int,
    own: float64,
    factor: float64,
    moved: array(dtype=vec3),
    turn: int,
    normals: array(dtype=vec3),
    fitted: array(dtype=vec3),
):
    """Smooth by the k nearest points within reach; keys hold places on the curve, so neighbours lie close by."""
    i = tid()
    base = i * (scratch.room + scratch.k)
    listing = i * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    widest = float(INFINITY)
    for leaf in range(first + i * run, min(first + (i + 1) * run, last)):
        covered = min(reach, widest * GUESS)
        gathered = gather_around_leaf(leaf, covered, tree, places, scratch, listing)
        widest = float(0.0)
        for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, tree.count)):
            p = tree.points[rank]
            near = min(reach, grown_reach(bound, square_distance(before, p)))
            size = search_member(
                p, leaf // FAN, gathered, covered, tree, places, scratch, listing, base, near, 0,
            )  # fmt: skip
            row = order[rank]
            n = vec3d(float64(0.0), float64(0.0), float64(0.0))
            pull = factor + float64(0.0)
            if ranged > float64(0.0):
                n = unit_or_zero(normals[row])
                pull = factor * dot(n, n)  # no side to measure heights from, no move
            total = moments(float64(0.0))
            for j in range(base, base + size):
                q = tree.points[int(scratch.keys[j] & int64(INDEX_MASK))]
                total = add_weighted(total, p, q, n, spatial, ranged)
            store_smoothed(total, size, p, row, to_plane, own, pull, moved, turn, normals, fitted)
            before = p
            bound = float(INFINITY)
            if size == scratch.k:
                bound = farthest_key(scratch.keys, base, size)
            widest = max(widest, bound)


@kernel
def smooth_within_kernel(
    tree: PointTree,
    order: array(dtype=int32),
    reach: float,
    spatial: float64,
    ranged: float64,
    to_plane: int,
    own: float64,
    factor: float64,
    moved: array(dtype=vec3),
    turn: int,
    normals: array(dtype=vec3),
    fitted: array(dtype=vec3),
):
    """Smooth by all points within reach, whose moments are summed as they are found."""
    i = tid()
    p = tree.points[i]
    row = order[i]
    n = vec3d(float64(0.0), float64(0.0), float64(0.0))
    pull = factor + float64(0.0)
    if ranged > float64(0.0):
        n = unit_or_zero(normals[row])
        pull = factor * dot(n, n)  # no side to measure heights from, no move
    total = moments(float64(0.0))
    size = int(0)
    for j in points_in_reach(i // BUCKET, p, reach, tree):
        if square_distance(p, tree.points[j]) <= reach:
            total = add_weighted(total, p, tree.points[j], n, spatial, ranged)
            size += 1
    store_smoothed(total, size, p, row, to_plane, own, pull, moved, turn, normals, fitted)


@kernel
def list_nearest_kernel(
    first: int,
    last: int,
    run: int,
    tree: PointTree,
    places: array(dtype=int32),
    scratch: GroupScratch,
    neighbors: array(dtype=int32),
):
    """The places on the curve of the k nearest points of each point of some leaves.

    There are k points in the tree, so no row is short. A point is in its own row, unless more than k others lie at its
    place: then all in the row do, so do those in their rows, and none of them ever moves.
    """
    i = tid()
    base = i * (scratch.room + scratch.k)
    listing = i * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    widest = float(INFINITY)
    for leaf in range(first + i * run, min(first + (i + 1) * run, last)):
        covered = widest * GUESS
        gathered = gather_around_leaf(leaf, covered, tree, places, scratch, listing)
        widest = float(0.0)
        for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, tree.count)):
            p = tree.points[rank]
            near = grown_reach(bound, square_distance(before, p))
            size = search_member(
                p, leaf // FAN, gathered, covered, tree, places, scratch, listing, base, near, 0,
            )  # fmt: skip
            out = (rank - first * LEAF) * scratch.k
            for j in range(size):
                neighbors[out + j] = int(scratch.keys[base + j] & int64(INDEX_MASK))
            before = p
            bound = farthest_key(scratch.keys, base, size)
            widest = max(widest, bound)


@kernel
def average_listed_kernel(
    neighbors: array(dtype=int32),
    first: int,
    k: int,
    factor: float64,
    points: array(dtype=vec3),
    moved: array(dtype=vec3),
):
    """Move points `factor` of the way to the mean of the k listed ones without themselves, who add nothing."""
    i = tid()
    p = points[first + i]
    here = widen(p)
    total = vec3d(float64(0.0), float64(0.0), float64(0.0))
    for j in range(i * k, (i + 1) * k):
        total = total + (widen(points[neighbors[j]]) - here)
    moved[first + i] = narrow(here + total * (factor / float64(k - 1)))


@kernel
def scatter_points_kernel(points: array(dtype=vec3), order: array(dtype=int32), scattered: array(dtype=vec3)):
    """scattered[order[i]] = points[i]."""
    i = tid()
    scattered[order[i]] = points[i]


def falloff_of(sigma):
    """The factor [1 / m^2] of a squared distance in the exponent of a Gaussian with this deviation [m]."""
    return min(0.5 / max(sigma * sigma, 1.0 / LARGEST_FALLOFF), LARGEST_FALLOFF)


def _smooth(points, max_nn, radius, spatial, ranged, to_plane, own, factor, normals):
    """One pass; (moved, fitted): fitted normals where it goes to a plane and there are normals, else a dummy."""
    device, tree = points.device, PointTree(points)
    turn = int(to_plane and normals is not None)
    moved, fitted = empty(points.size, vec3, device), empty(points.size if turn else 1, vec3, device)
    if tree.count < points.size:
        copy(moved, points, count=points.size)
    if turn:
        copy(fitted, normals, count=points.size)
    before = fitted if normals is None else normals
    rule = [float(spatial), float(ranged), int(to_plane), float(own), float(factor), moved, turn, before, fitted]
    reach = reach_of(radius)
    if max_nn is None:
        launch(smooth_within_kernel, tree.count, [tree, tree.order, reach, *rule])
        return moved, fitted
    places = empty(tree.count, int32, device)
    launch(fill_positions_kernel, tree.count, [places])
    scratch = GroupScratch(device, tree.count, min(max_nn, max(1, tree.count)), reach)
    common = [tree, places, scratch, tree.order, reach, *rule]
    for first, last, threads, run in scratch.parts():
        launch(smooth_nearest_kernel, threads, [first, last, run, *common])
    return moved, fitted


def project_to_planes(points, max_nn, radius, normals=None):
    """Each point on the plane through its neighbours, which weigh exp(-d^2 / radius^2).

    Args:
        points: Device array of vec3, shape [n].
        max_nn: Neighbours a plane, the point itself included; None takes all within the radius.
        radius: Upper limit of the distance [m], excluded; infinity for none, and equal weights.
        normals: Normals whose sides the planes' normals take, or None.

    Returns:
        (moved, fitted): vec3 [n] each. Where fewer than three neighbours are found the point and its normal stay, as
        do points that are not finite. `fitted` means nothing without normals.
    """
    spatial = 0.0 if radius == INFINITY else 2.0 * falloff_of(radius)
    return _smooth(points, max_nn, radius, spatial, 0.0, True, 0.0, 1.0, normals)


def average_by_sides(points, normals, max_nn, radius, sigma_s, sigma_r):
    """Each point at the mean of its neighbours, weighted by distance and by height over its tangent plane.

    Arguments as for `project_to_planes`; the deviations in metres. A point whose normal is zero or NaN stays.
    """
    return _smooth(points, max_nn, radius, falloff_of(sigma_s), falloff_of(sigma_r), False, 0.0, 1.0, normals)[0]


def average_passes(points, factors, neighbor_count):
    """One pass a factor: each point that far towards the mean of its nearest others, found anew in each pass."""
    for factor in factors:
        points = _smooth(points, neighbor_count + 1, INFINITY, 0.0, 0.0, False, 1.0, factor, None)[0]
    return points


def average_passes_fixed(points, factors, neighbor_count):
    """As `average_passes`, with the neighbours of the first pass in all of them: 4 B a neighbour."""
    device, tree = points.device, PointTree(points)
    moved = empty(points.size, vec3, device)
    copy(moved, points, count=points.size)
    k = min(neighbor_count + 1, tree.count)
    if k < 2:
        return moved
    places = empty(tree.count, int32, device)
    launch(fill_positions_kernel, tree.count, [places])
    scratch = GroupScratch(device, tree.count, k, INFINITY)
    lists = []  # one a part, so that none has 2^31 elements
    for first, last, threads, run in scratch.parts():
        rows = min(last * LEAF, tree.count) - first * LEAF
        neighbors = empty(rows * k, int32, device)
        arguments = [first, last, run, tree, places, scratch, neighbors]
        launch(list_nearest_kernel, threads, arguments)
        lists.append((first * LEAF, rows, neighbors))
    here, there = tree.points, empty(tree.count, vec3, device)
    for factor in factors:
        for first, rows, neighbors in lists:
            launch(average_listed_kernel, rows, [neighbors, first, k, float(factor), here, there])
        here, there = there, here
    launch(scatter_points_kernel, tree.count, [here, tree.order, moved])
    return moved
