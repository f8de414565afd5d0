"""ISS keypoints: Zhong, "Intrinsic shape signatures: a shape descriptor for 3D object recognition", ICCV Workshops
2009, section 2, with Open3D's unweighted covariances and the smallest eigenvalue as saliency.
"""

from ..algebra.eigen import eigenvalues
from ..algebra.moments import covariance_of, moments
from ..array_types import Indices
from ..arrays.packed_keys import key_index
from ..arrays.select import positions_of
from ..lang import array, float64, func, int32, int64, kernel, launch, reduce, reduction, sqrt, tid, uint8, vec3, vector
from ..memory import download, empty, zeros
from ..search.bucket_walk import points_within
from ..search.distinct_points import without_copies
from ..search.nearest_point import find_nearest
from ..search.neighbor_limits import Neighborhood
from ..search.point_tree import BUCKET, PointTree
from ..search.tree_search import squared_radius
from ..surface.neighbor_moments import sum_neighbor_moments

SALIENT_SPACINGS = 6.0  # Open3D's default radii, in mean nearest neighbor distances
NON_MAX_SPACINGS = 4.0
# Of the squared radius: float32 rounding of an exact plane is a millionth of the radius
MIN_RELATIVE_EIGENVALUE = 1.0e-12
EQUAL_SALIENCY = 1.0e-14  # of the squared radius: closer saliencies are equal up to summation order
END_RADIUS = -1.0  # [m^2] a squared radius that ends a traversal
one = vector(1, float64)


@func
def distance_between(p: vec3, q: vec3) -> float64:
    x = float64(q[0]) - float64(p[0])
    y = float64(q[1]) - float64(p[1])
    z = float64(q[2]) - float64(p[2])
    return sqrt(x * x + y * y + z * z)


@reduction
def sum_spacings(points: array(dtype=vec3), nearest: array(dtype=int64)) -> one:
    i = tid()
    distance = float64(0.0)
    if nearest[i] >= 0:
        distance = distance_between(points[i], points[key_index(nearest[i])])
    return one(distance)


@kernel
def measure_saliency_kernel(
    sums: array(dtype=moments),
    gamma_21: float64,
    gamma_32: float64,
    min_neighbors: int,
    min_eigenvalue: float64,
    saliency: array(dtype=float64),
    salient: array(dtype=uint8),
):
    """Smallest eigenvalue [m^2] if above `min_eigenvalue` and the eigenvalue ratios pass, else zero."""
    i = tid()
    m = sums[i]
    smallest = float64(0.0)
    flag = 0
    if m[0] >= float64(min_neighbors):
        v = eigenvalues(covariance_of(m))
        if v[0] > min_eigenvalue and v[1] < gamma_21 * v[2] and v[0] < gamma_32 * v[1]:
            smallest = v[0]
            flag = 1
    saliency[i] = smallest
    salient[i] = uint8(flag)


@kernel
def keep_maxima_kernel(
    ranks: array(dtype=int32),
    tree: PointTree,
    sqradius: float,
    min_neighbors: int,
    tie: float64,
    saliency: array(dtype=float64),
    mask: array(dtype=uint8),
):
    """Keep salient points with enough neighbors that are local maxima."""
    i = tid()
    rank = ranks[i]
    own = saliency[rank] + tie
    neighbor_count = 0
    bound = sqradius
    for j, sqdist in points_within(rank // BUCKET, tree.points[rank], bound, tree):
        neighbor_count += 1
        if saliency[j] > own:
            bound = float(END_RADIUS)  # ends the traversal
    flag = 0
    if bound == sqradius and neighbor_count >= min_neighbors:
        flag = 1
    mask[tree.order[rank]] = uint8(flag)


def mean_spacing(tree: PointTree) -> float:
    """Mean distance [m] of finite points to the nearest other one, 0 for copies, as in Open3D; of the positions if at
    least half of the points are copies. 0 if there are none (sync)."""
    positions = without_copies(tree)
    if 2 * positions.count <= tree.count:
        tree = positions
    if tree.count == 0:
        return 0.0
    points = tree.source
    total = reduce(sum_spacings, points.size, [points, find_nearest(tree, points, others=True)])
    return float(download(total)[0, 0]) / tree.count  # sync


def find_iss_keypoints(
    tree: PointTree, radii: tuple[float, float] | None, gamma_21: float, gamma_32: float, min_neighbors: int
) -> Indices:
    """Ascending keypoint indices. `radii` [m] of the covariance and of non-maximum suppression, or None."""
    if radii is None:
        spacing = mean_spacing(tree)
        radii = (SALIENT_SPACINGS * spacing, NON_MAX_SPACINGS * spacing)
    salient_radius, non_max_radius = radii
    saliency, salient = empty(tree.count, float64, tree.device), empty(tree.count, uint8, tree.device)
    sums = sum_neighbor_moments(Neighborhood(tree, salient_radius, None))
    square = salient_radius * salient_radius
    shape = [gamma_21, gamma_32, min_neighbors, MIN_RELATIVE_EIGENVALUE * square]
    launch(measure_saliency_kernel, tree.count, [sums, *shape, saliency, salient])
    ranks = positions_of(salient)  # sync
    keypoints = zeros(tree.source.size, uint8, tree.device)
    search = [ranks, tree, squared_radius(non_max_radius), min_neighbors]
    launch(keep_maxima_kernel, ranks.size, [*search, EQUAL_SALIENCY * square, saliency, keypoints])
    return positions_of(keypoints)  # sync
