"""Normal distributions of target voxels, and the linear system of source points under a pose.

Magnusson, "The Three-Dimensional Normal-Distributions Transform", Orebro 2009, chapter 6, point to distribution. A
residual is the squared Mahalanobis distance d^T C^-1 d of a point from a mean, cut at a limit and without the mixture
density: Gauss-Newton in place of Newton steps. Eigenvalues of C are raised to a fraction of the largest. Float64.

The determined motions follow from the shapes of the distributions, not from C: the pull of a plane's distributions
along it comes from the borders of voxels. Planes count along their normals, lines across them and scattered points in
all directions, both with little weight, since a few points of a plane may look like either.

A voxel costs three passes over its points and 172 B; grouping costs 16 B per target point. An iteration costs up to
seven lookups and 250 operations each per source point, twice that if degenerate motions are left out.
"""

from collections.abc import Sequence

from ..algebra.rigid_solve import diagonalize_three, move, three_system
from ..algebra.transform import widen
from ..array_types import Integers, Points
from ..arrays.hash_table import HashTable, find_position
from ..arrays.unique import UniqueKeys
from ..lang import (
    INFINITY,
    array,
    atomic_add,
    compute,
    dot,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    loop,
    mat33d,
    mat44d,
    outer,
    segment_reduction,
    struct,
    tid,
    vec3,
    vec3d,
)
from ..memory import download, empty, zeros
from .matches import NO_PAIR
from .rows import COUNT_AT, DISTANCE_AT, SOURCE_AT, TARGET_AT, row_sums, sum_block
from .voxel_gaussians import CellGrid, cell_at, cell_of, enclosing_grid, key_of_cell

RESIDUALS_AT = TARGET_AT  # number of residuals, in place of the sum of target points
FACE_NEIGHBORS = 6  # neighbors of a voxel
# Of the largest eigenvalue: distributions are thin along those below, as in odometry/map_icp.py
MIN_EIGENVALUE_RATIO = 0.1
WEAK_SHAPE_WEIGHT = 0.1  # weight of the shapes of lines and scattered points, beside 1 of planes


@struct
class NormalDistributions:
    """Distributions of the occupied voxels: `means` [m], inverse covariances `information` [1 / m^2]; `shapes`: sums of
    v v^T over the determined directions; the point nearest to the mean, -1 if a voxel is not used. Points are compared
    with `neighbors` face neighbors of their voxel, too. Residuals above `limit` do not count. ValueError above 2^62
    voxels.
    """

    points: array(dtype=vec3)
    grid: CellGrid
    table: HashTable
    means: array(dtype=vec3d)
    information: array(dtype=mat33d)
    shapes: array(dtype=mat33d)
    representatives: array(dtype=int32)
    neighbors: int
    limit: float64

    def __init__(
        self,
        points: Points,
        voxel_size: float,
        corner: Sequence[float],
        *,
        min_points: int,
        regularization: float,
        limit: float,
        with_neighbors: bool,
    ) -> None:
        device = points.device
        self.points, self.neighbors, self.limit = points, FACE_NEIGHBORS if with_neighbors else 0, limit
        self.grid, bits, self.finite_count = enclosing_grid(points, voxel_size, 1, corner)  # sync
        keys, skipped = empty(points.size, int64, device), 1 << bits
        launch(encode_cells_kernel, points.size, [points, self.grid, skipped, keys])
        groups = UniqueKeys(keys, bits + 1)  # sync
        groups.drop_last(skipped)  # sync
        count = groups.count
        self.means = empty(count, vec3d, device)
        self.information, self.shapes = empty(count, mat33d, device), empty(count, mat33d, device)
        self.representatives, used = empty(count, int32, device), zeros(1, int32, device)
        voxels = [groups.order, groups.starts, min_points, regularization]
        launch(fit_distributions_kernel, count, [*voxels, self, used])
        self.count = int(download(used)[0])  # sync
        self.table = HashTable(device)
        self.table.append(groups.keys, count, count)


@func
def center_of(first: int, last: int, order: array(dtype=int32), points: array(dtype=vec3)) -> vec3d:
    total = vec3d(0.0)
    for j in range(first, last):
        total += widen(points[order[j]])
    return total / float64(last - first)


@func
def covariance_about(
    mean: vec3d, first: int, last: int, order: array(dtype=int32), points: array(dtype=vec3)
) -> mat33d:
    """Sample covariance (divided by n - 1) about a mean."""
    total = mat33d(0.0)
    for j in range(first, last):
        d = widen(points[order[j]]) - mean
        total += outer(d, d)
    return total * (1.0 / float64(max(last - first - 1, 1)))


@func
def nearest_member(mean: vec3d, first: int, last: int, order: array(dtype=int32), points: array(dtype=vec3)) -> int:
    """The point of a voxel nearest to a position. Of equally near ones the first."""
    best = -1
    least = float64(INFINITY)
    for j in range(first, last):
        d = widen(points[order[j]]) - mean
        sqdist = dot(d, d)
        if sqdist < least:
            least = sqdist
            best = order[j]
    return best


@func
def shape_of(system: three_system, largest: float64) -> mat33d:
    """Sum of v v^T over the directions that a distribution determines, from its eigenvectors."""
    shape = mat33d(0.0)
    thin = 0
    for k in range(3):
        v = vec3d(system[k], system[3 + k], system[6 + k])
        if system[9 + k] < float64(MIN_EIGENVALUE_RATIO) * largest:
            thin += 1
        if system[9 + k] < largest:
            shape += outer(v, v) * float64(WEAK_SHAPE_WEIGHT)
    if thin == 1:
        shape = mat33d(0.0)
        for k in range(3):
            v = vec3d(system[k], system[3 + k], system[6 + k])
            if system[9 + k] < float64(MIN_EIGENVALUE_RATIO) * largest:
                shape = outer(v, v)
    return shape


@kernel
def encode_cells_kernel(points: array(dtype=vec3), grid: CellGrid, skipped: int64, keys: array(dtype=int64)):
    """Key of each point's voxel; `skipped` for non-finite points."""
    i = tid()
    key = key_of_cell(cell_of(points[i], grid), 0, grid)
    if key < 0:
        key = skipped
    keys[i] = key


@kernel
def fit_distributions_kernel(
    order: array(dtype=int32),
    starts: array(dtype=int32),
    min_points: int,
    regularization: float64,
    target: NormalDistributions,
    used: array(dtype=int32),
):
    """Distribution of each voxel, and the number of those that are used."""
    i = tid()
    first = starts[i]
    last = starts[i + 1]
    mean = center_of(first, last, order, target.points)
    information = mat33d(0.0)
    shape = mat33d(0.0)
    representative = -1
    if last - first >= min_points:
        system = diagonalize_three(covariance_about(mean, first, last, order, target.points))
        largest = max(max(system[9], system[10]), system[11])
        if largest > 0.0:
            for k in range(3):
                v = vec3d(system[k], system[3 + k], system[6 + k])
                information += outer(v, v) * (1.0 / max(system[9 + k], regularization * largest))
            shape = shape_of(system, largest)
            representative = nearest_member(mean, first, last, order, target.points)
            atomic_add(used, 0, 1)  # integer sum: order-independent
    target.means[i] = mean
    target.information[i] = information
    target.shapes[i] = shape
    target.representatives[i] = representative


@func
def find_distribution(at: vec3d, j: int, target: NormalDistributions) -> int:
    """Row of the distribution of a voxel (j = 0) or of its neighbor j at -x, x, -y, y, -z or z. -1 if none is used."""
    axis = (j + 1) // 2 - 1
    zero = float64(0.0)
    step = float64(1.0)
    if j % 2 == 1:
        step = -1.0
    x = step if axis == 0 else zero
    y = step if axis == 1 else zero
    z = step if axis == 2 else zero
    key = key_of_cell(at + vec3d(x, y, z), 0, target.grid)
    row = -1
    if key >= 0:
        row = find_position(key, target.table)
    if row >= 0:
        if target.representatives[row] < 0:
            row = -1
    return row


@loop
def distributions_near(p: vec3d, target: NormalDistributions) -> tuple[int, vec3d, float64]:
    """Distributions around a position within the limit: row, position about the mean, squared Mahalanobis distance."""
    at = cell_at(p, target.grid)
    for j in range(target.neighbors + 1):
        row = find_distribution(at, j, target)
        if row >= 0:
            d = p - target.means[row]
            square = dot(d, target.information[row] @ d)
            if square <= target.limit:
                yield row, d, square


@segment_reduction
def sum_distribution_rows(
    source: array(dtype=vec3), poses: array(dtype=mat44d), target: NormalDistributions, weights: array(dtype=mat33d)
) -> row_sums:
    """Rows of a point and all distributions near it, weighted by matrices: their information, or their shapes. The pair
    is the representative of the nearest distribution.
    """
    i = tid()
    total = row_sums(0.0)
    if isfinite(source[i]):
        p = move(poses[0], widen(source[i]))
        least = target.limit
        nearest = -1
        for row, d, square in distributions_near(p, target):
            total += sum_block(p, weights[row], d)
            total[RESIDUALS_AT] = total[RESIDUALS_AT] + 1.0
            if square <= least:
                least = square
                nearest = row
        if nearest >= 0:
            gap = p - widen(target.points[target.representatives[nearest]])
            total[DISTANCE_AT] = dot(gap, gap)
            total[COUNT_AT] = 1.0
            for axis in range(3):
                total[SOURCE_AT + axis] = p[axis]
    return total


@kernel
def match_distributions_kernel(
    source: array(dtype=vec3), poses: array(dtype=mat44d), target: NormalDistributions, pairs: array(dtype=int32)
):
    """Target point of each source point's pair, or NO_PAIR."""
    i = tid()
    pair = int(NO_PAIR)
    if isfinite(source[i]):
        p = move(poses[0], widen(source[i]))
        least = target.limit
        for row, _, square in distributions_near(p, target):
            if square <= least:
                least = square
                pair = target.representatives[row]
    pairs[i] = pair


def match_distributions(source: Points, poses: Integers, target: NormalDistributions) -> Integers:
    """Target points paired with the source points under a pose, int32 (n), or NO_PAIR."""
    return compute(match_distributions_kernel, source.size, [source, poses, target], int32, source.device)
