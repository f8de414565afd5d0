"""M3C2 distances between two surfaces along the normal: sums over cylinders.

Lague, Brodu and Leroux, "Accurate 3D comparison of complex topography with terrestrial laser scanner", ISPRS Journal
82, 2013, section 3. Planarity is (l2 - l1) / l3 of ascending eigenvalues, as in py4dgeo. Sums are integers of quantized
values, so they are bitwise independent of the order of points.
"""

import math

import numpy as np

from ..algebra.eigen import eigenvalues, smallest_eigenvector
from ..algebra.moments import covariance_of
from ..array_types import AnyArray, Doubles, Indices, Points, Scalars, Vectors
from ..lang import (
    NAN,
    array,
    dot,
    float32,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    loop,
    partial,
    sqrt,
    struct,
    tid,
    vec3,
    vec3d,
    vector,
)  # fmt: skip
from ..memory import empty, upload
from ..search.bucket_walk import next_step, start_traversal
from ..search.point_tree import BUCKET, FAN, LEAF, SIDES, PointTree
from ..search.tree_search import find_bucket, order_along_curve, squared_radius
from .neighbor_moments import moments_within

MIN_NEIGHBORS = 3.0  # fewer points define no plane
RADIUS_ENLARGEMENT = 1.0e-5  # of a cylinder: box distances are float32
RELATIVE_ROUNDING = 1.0e-6  # of coordinates: exceeds float32 rounding
STEPS_PER_LENGTH = 68719476736.0  # 2^36 steps per length along the axis, so that 2^26 points fit
MAX_HALVINGS = 900  # of a length: shorter ones do not occur
HALF_BITS = 18
LOW_HALF_MASK = 262143  # the lower 18 of 36 bits
NO_RADIUS = NAN  # in 64 bits
TWO_SIDED = 1.96  # standard deviations of a 95 % interval

# Of points in a cylinder: their count, the sum of coordinates along the axis, and those of the squares of their upper
# halves, of both halves' products, and of the squares of lower halves.
coordinate_sums = vector(5, int64)
lane_numbers = vector(8, float32)


@struct
class Cylinder:
    """Cylinders: `radius` [m] (inclusive), half-length `length` [m], `scale` steps per meter (a power of two)."""

    radius: float64
    length: float64
    scale: float64

    def __init__(self, radius: float, length: float) -> None:
        self.radius, self.length, self.scale = radius, length, STEPS_PER_LENGTH * scale_of(length)


@struct
class Changes:
    """Per core point [m]: `distances` first to second cloud, 95 % detection `limits`. Also per cloud: standard
    deviations, numbers of points."""

    distances: array(dtype=float64)
    limits: array(dtype=float64)
    spreads: array(dtype=float64, ndim=2)
    counts: array(dtype=int32, ndim=2)

    def __init__(self, cores: Points) -> None:
        self.distances, self.limits = (empty(cores.size, float64, cores.device) for _ in range(2))
        self.spreads, self.counts = (empty((cores.size, 2), kind, cores.device) for kind in (float64, int32))


@kernel
def find_flattest_kernel(
    cores: array(dtype=vec3),
    order: array(dtype=int32),
    tree: PointTree,
    max_sqdists: array(dtype=float32),
    radii: array(dtype=float64),
    orientation: vec3,
    directions: array(dtype=vec3),
    scales: array(dtype=float64),
):
    """Oriented normal and radius of the scale with the highest planarity. NaN if no scale has a plane."""
    t = tid()
    i = order[t]
    p = cores[i]
    best = float64(0.0)
    direction = vec3(NAN, NAN, NAN)
    scale = float64(NO_RADIUS)
    if tree.count > 0 and isfinite(p):
        start = find_bucket(p, tree)
        for s in range(max_sqdists.shape[0]):
            total = moments_within(start, p, max_sqdists[s], max_sqdists[s], tree)
            covariance = covariance_of(total)
            values = eigenvalues(covariance)
            planarity = float64(0.0)
            if total[0] >= float64(MIN_NEIGHBORS) and values[2] > 0.0:
                planarity = (values[1] - values[0]) / values[2]
            if planarity > best:
                best = planarity
                v = smallest_eigenvector(covariance)
                direction = vec3(float(v[0]), float(v[1]), float(v[2]))
                scale = radii[s]
        if dot(direction, orientation) < 0.0:
            direction = -direction
    directions[i] = direction
    scales[i] = scale


@func
def children_near_axis(
    boxes: array(dtype=float32), node: int, p: vec3, axis: vec3, radius: float, length: float
) -> int:
    """Bit mask of the child boxes whose bounding spheres may intersect a cylinder, rounded up for float32."""
    first = node * SIDES
    bits = 0
    for j in range(FAN):
        hx = (boxes[first + j + 3 * FAN] - boxes[first + j]) * 0.5
        hy = (boxes[first + j + 4 * FAN] - boxes[first + j + FAN]) * 0.5
        hz = (boxes[first + j + 5 * FAN] - boxes[first + j + 2 * FAN]) * 0.5
        x = boxes[first + j] + hx - p[0]
        y = boxes[first + j + FAN] + hy - p[1]
        z = boxes[first + j + 2 * FAN] + hz - p[2]
        offset = x * axis[0] + y * axis[1] + z * axis[2]
        dx = x - offset * axis[0]
        dy = y - offset * axis[1]
        dz = z - offset * axis[2]
        along = hx * abs(axis[0]) + hy * abs(axis[1]) + hz * abs(axis[2])
        limit = radius + sqrt(hx * hx + hy * hy + hz * hz)
        # False for empty boxes, by NaN.
        if abs(offset) <= length + along and dx * dx + dy * dy + dz * dz <= limit * limit:
            bits = bits | (1 << j)
    return bits


@func
def nodes_near_axis(
    levels: array(dtype=int32),
    boxes: array(dtype=float32),
    p: vec3,
    axis: vec3,
    radius: float,
    length: float,
    level: int,
    node: int,
) -> int:
    """`children_near_axis` for a node given by its level."""
    return children_near_axis(boxes, levels[level] + node, p, axis, radius, length)


@func
def widened(size: float64, p: vec3) -> float:
    """A length enlarged by the float32 rounding at a point."""
    return float(size * (1.0 + float64(RADIUS_ENLARGEMENT))) + (abs(p[0]) + abs(p[1]) + abs(p[2])) * RELATIVE_ROUNDING


@loop
def leaves_near_axis(start: int, p: vec3, axis: vec3, radius: float, length: float, tree: PointTree) -> int:
    """First positions of the leaves that may intersect a cylinder, starting at a bucket."""
    step = start_traversal(start)
    while int(step[0]) <= tree.root:
        bucket = int(step[2])
        leaves = children_near_axis(tree.boxes, bucket, p, axis, radius, length)
        for leaf in range(FAN):
            if (leaves >> leaf) & 1 == 1:
                first = bucket * BUCKET + leaf * LEAF
                yield first
        step = next_step(
            step, tree.root, partial(nodes_near_axis, tree.levels, tree.boxes, p, axis, radius, length)
        )  # fmt: skip


@kernel
def sum_cylinders_kernel(
    cores: array(dtype=vec3),
    order: array(dtype=int32),
    directions: array(dtype=vec3),
    tree: PointTree,
    cylinder: Cylinder,
    sums: array(dtype=coordinate_sums),
):
    """Count, coordinates along the axis and their squares, summed over the points in each cylinder."""
    t = tid()
    i = order[t]
    p = cores[i]
    axis = directions[i]
    count = int64(0)
    total = int64(0)
    highs = int64(0)
    products = int64(0)
    lows = int64(0)
    if tree.count > 0 and isfinite(p) and isfinite(axis):
        middle = vec3d(float64(p[0]), float64(p[1]), float64(p[2]))
        along = vec3d(float64(axis[0]), float64(axis[1]), float64(axis[2]))
        along = along / sqrt(dot(along, along))
        widest = cylinder.radius * cylinder.radius
        unit = vec3(float(along[0]), float(along[1]), float(along[2]))
        wide = widened(cylinder.radius, p) + float(cylinder.length) * RELATIVE_ROUNDING
        long = widened(cylinder.length, p)
        xs = lane_numbers(0.0)
        ys = lane_numbers(0.0)
        zs = lane_numbers(0.0)
        for first in leaves_near_axis(find_bucket(p, tree), p, unit, wide, long, tree):
            for j in range(LEAF):  # missing points are infinite and outside
                q = tree.points[first + j]
                xs[j] = q[0]
                ys[j] = q[1]
                zs[j] = q[2]
            for j in range(LEAF):
                x = float64(xs[j]) - middle[0]
                y = float64(ys[j]) - middle[1]
                z = float64(zs[j]) - middle[2]
                coordinate = x * along[0] + y * along[1] + z * along[2]
                beside = (x * x + y * y + z * z) - coordinate * coordinate
                is_beside = 1 if beside <= widest else 0
                inside = is_beside & (1 if abs(coordinate) <= cylinder.length else 0)
                steps = int64((coordinate if inside == 1 else float64(0.0)) * cylinder.scale)
                high = steps >> int64(HALF_BITS)
                low = steps & int64(LOW_HALF_MASK)
                count += int64(inside)
                total += steps
                highs += high * high
                products += high * low
                lows += low * low
    sums[i] = coordinate_sums(count, total, highs, products, lows)


@func
def squares_of(sums: coordinate_sums) -> float64:
    return (float64(sums[2]) * 262144.0 + float64(sums[3]) * 2.0) * 262144.0 + float64(sums[4])


@func
def variance_of(sums: coordinate_sums, step: float64) -> float64:
    """Sample variance [m^2]. NaN for fewer than two points."""
    variance = float64(NAN)
    count = float64(sums[0])
    total = float64(sums[1])
    if sums[0] >= 2:
        variance = max((squares_of(sums) - total * total / count) / (count - 1.0), 0.0) * step * step
    return variance


@func
def mean_of(sums: coordinate_sums, step: float64) -> float64:
    return float64(sums[1]) / float64(sums[0]) * step


@kernel
def compare_sums_kernel(
    first: array(dtype=coordinate_sums),
    second: array(dtype=coordinate_sums),
    step: float64,
    registration_error: float64,
    changes: Changes,
):
    """Distance, limit, spreads and counts of each core point. NaN where a cylinder is empty."""
    i = tid()
    a = first[i]
    b = second[i]
    spread_a = variance_of(a, step)
    spread_b = variance_of(b, step)
    distance = float64(NAN)
    if a[0] > 0 and b[0] > 0:
        distance = mean_of(b, step) - mean_of(a, step)
    error = sqrt(spread_a / max(float64(a[0]), 1.0) + spread_b / max(float64(b[0]), 1.0))
    changes.distances[i] = distance
    changes.limits[i] = (error + registration_error) * float64(TWO_SIDED)
    changes.spreads[i, 0] = sqrt(spread_a)
    changes.spreads[i, 1] = sqrt(spread_b)
    changes.counts[i, 0] = int(a[0])
    changes.counts[i, 1] = int(b[0])


def scale_of(length: float) -> float:
    """The power of two that scales a length to at most 1."""
    return 2.0 ** min(-math.ceil(math.log2(length)), MAX_HALVINGS)


def find_flattest(
    tree: PointTree, cores: Points, radii: np.ndarray, orientation: np.ndarray
) -> tuple[Vectors, Doubles]:
    """Oriented directions and radii of highest planarity at core points. NaN without a plane."""
    max_sqdists: Scalars = upload(
        np.array([squared_radius(radius) for radius in radii], np.float32), float32, cores.device
    )
    given: Doubles = upload(radii, float64, cores.device)
    directions, scales = empty(cores.size, vec3, cores.device), empty(cores.size, float64, cores.device)
    around = [cores, order_along_curve(tree, cores), tree, max_sqdists, given, vec3(*orientation.tolist())]
    launch(find_flattest_kernel, cores.size, [*around, directions, scales])
    return directions, scales


def measure_changes(
    first: PointTree,
    second: PointTree,
    cores: Points,
    directions: Vectors,
    cylinder: Cylinder,
    registration_error: float,
) -> Changes:
    """Distances from the first to the second cloud at core points along directions."""
    order: Indices = order_along_curve(first, cores)
    sums: list[AnyArray] = []
    for tree in (first, second):
        cloud_sums = empty(cores.size, coordinate_sums, cores.device)
        launch(sum_cylinders_kernel, cores.size, [cores, order, directions, tree, cylinder, cloud_sums])
        sums.append(cloud_sums)
    changes = Changes(cores)
    launch(compare_sums_kernel, cores.size, [*sums, 1 / cylinder.scale, registration_error, changes])
    return changes
