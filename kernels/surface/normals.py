"""Normals: search, covariance and eigenvector in one pass, with no list of neighbours in memory.

Hoppe et al., "Surface reconstruction from unorganized points", SIGGRAPH 1992, section 3.1. The covariance is taken
about the mean of the neighbours, from differences to the query (exact in float32 for points this near each other),
and summed in float64: coordinates of any size do no harm. 12 B read and 12 B written a point beside the search.
"""

from ..algebra.eigen import smallest_eigenvector
from ..arrays.sort import fill_positions_kernel
from ..lang import (
    INFINITY,
    NAN,
    array,
    dot,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    mat33d,
    sqrt,
    tid,
    vec3,
    vector,
)
from ..memory import empty
from ..search.group_search import (
    GUESS,
    GroupScratch,
    farthest_key,
    gather_around_leaf,
    grown_reach,
    search_member,
)
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

MIN_NEIGHBORS = 3.0  # fewer points span no plane
moments = vector(10, float64)


@func
def add_moments(total: moments, p: vec3, q: vec3) -> moments:
    """Count, sums and products of the difference q - p."""
    x = float64(q[0] - p[0])
    y = float64(q[1] - p[1])
    z = float64(q[2] - p[2])
    return total + moments(float64(1.0), x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)


@func
def covariance_of(m: moments) -> mat33d:
    """The covariance [m^2] about the mean, divided by the count."""
    s = float64(1.0) / max(m[0], float64(1.0))
    x = m[1] * s
    y = m[2] * s
    z = m[3] * s
    xy = m[5] * s - x * y
    xz = m[6] * s - x * z
    yz = m[8] * s - y * z
    return mat33d(m[4] * s - x * x, xy, xz, xy, m[7] * s - y * y, yz, xz, yz, m[9] * s - z * z)


@func
def normal_of(m: moments) -> vec3:
    """The unit normal of the plane through the neighbours; (0, 0, 1) where they are fewer than three."""
    n = vec3(0.0, 0.0, 1.0)
    if m[0] >= float64(MIN_NEIGHBORS):
        v = smallest_eigenvector(covariance_of(m))
        n = vec3(float(v[0]), float(v[1]), float(v[2]))
    return n


@kernel
def fit_normals_nearest_kernel(
    first: int,
    last: int,
    run: int,
    tree: PointTree,
    order: array(dtype=int32),
    places: array(dtype=int32),
    scratch: GroupScratch,
    reach: float,
    normals: array(dtype=vec3),
):
    """Normals from the k nearest points within reach; keys hold places on the curve, so neighbours lie close by."""
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
            total = moments(float64(0.0))
            for j in range(base, base + size):
                total = add_moments(total, p, tree.points[int(scratch.keys[j] & int64(INDEX_MASK))])
            normals[order[rank]] = normal_of(total)
            before = p
            bound = float(INFINITY)
            if size == scratch.k:
                bound = farthest_key(scratch.keys, base, size)
            widest = max(widest, bound)


@kernel
def fit_normals_within_kernel(
    tree: PointTree,
    order: array(dtype=int32),
    reach: float,
    normals: array(dtype=vec3),
):
    """Normals from all points within reach, whose moments are summed as they are found."""
    i = tid()
    p = tree.points[i]
    total = moments(float64(0.0))
    for j in points_in_reach(i // BUCKET, p, reach, tree):
        if square_distance(p, tree.points[j]) <= reach:
            total = add_moments(total, p, tree.points[j])
    normals[order[i]] = normal_of(total)


@kernel
def align_normals_kernel(references: array(dtype=vec3), normals: array(dtype=vec3)):
    """Turn each normal to the side of its reference, in place."""
    i = tid()
    if dot(normals[i], references[i]) < 0.0:
        normals[i] = -normals[i]


@kernel
def orient_normals_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), to_point: int, reference: vec3, oriented: array(dtype=vec3)
):
    """Normals turned to a direction, or to the side of a point; a zero normal becomes the reference direction."""
    i = tid()
    n = normals[i]
    towards = reference + vec3(0.0, 0.0, 0.0)
    if to_point == 1:
        towards = reference - points[i]
    if dot(n, n) == 0.0:
        size = sqrt(dot(towards, towards))
        if size > 0.0:
            n = towards / size
        else:
            n = vec3(0.0, 0.0, 1.0)
    else:
        if dot(n, towards) < 0.0:
            n = -n
    oriented[i] = n


@kernel
def fill_missing_normals_kernel(points: array(dtype=vec3), normals: array(dtype=vec3)):
    """NaN normals for points that are not finite."""
    i = tid()
    p = points[i]
    if not isfinite(p):
        normals[i] = vec3(NAN, NAN, NAN)


def estimate_normals(tree, points, max_nn, radius):
    """Normals of the points that the tree was built from.

    Args:
        tree: A PointTree over `points`.
        points: Device array of vec3, shape [n].
        max_nn: Neighbours a fit, the point itself included; None takes all within the radius.
        radius: Upper limit of the distance [m], excluded; infinity for none.

    Returns:
        Device array of vec3, shape [n].
    """
    device = points.device
    normals = empty(points.size, vec3, device)
    reach = reach_of(radius)
    if max_nn is None:
        launch(fit_normals_within_kernel, tree.count, [tree, tree.order, reach, normals])
    else:
        k = min(max_nn, max(1, tree.count))
        places = empty(tree.count, int32, device)
        launch(fill_positions_kernel, tree.count, [places])
        scratch = GroupScratch(device, tree.count, k, reach)
        common = [tree, tree.order, places, scratch, reach, normals]
        for first, last, threads, run in scratch.parts():
            launch(fit_normals_nearest_kernel, threads, [first, last, run, *common])
    if tree.count < points.size:
        launch(fill_missing_normals_kernel, points.size, [points, normals])
    return normals


def orient_normals(points, normals, reference, to_point):
    """Normals turned to the direction `reference`, or to the side of the point `reference` where `to_point`."""
    oriented = empty(normals.size, vec3, normals.device)
    launch(orient_normals_kernel, normals.size, [points, normals, int(to_point), vec3(*reference), oriented])
    return oriented


def align_normals(normals, references):
    """Turn each normal to the side of its reference, in place."""
    launch(align_normals_kernel, normals.size, [references, normals])
