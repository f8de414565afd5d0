"""Coherent point drift: soft correspondences between two point sets (Myronenko and Song, "Point set registration:
coherent point drift", PAMI 2010, eqs. 6 and 7).

p_mn = e_mn / (sum_k e_kn + c), e_mn = exp(-|x_n - y_m|^2 / 2 s^2). Two passes give the denominators, sum_n p_mn and
sum_n p_mn x_n without an M x N matrix. Gaussians end at MAX_EXPONENT (2e-19), so small s uses trees. The CPU vectorizes
eight points per thread, each sum in its own order.
"""

import numpy as np

from ..algebra.transform import narrow, narrow_rows, widen
from ..array_types import Doubles, Points, Positions
from ..lang import (
    array,
    bits_float,
    dot,
    float64,
    func,
    kernel,
    launch,
    mat33d,
    reduction,
    tid,
    vec2d,
    vec3,
    vec3d,
    vector,
)
from ..memory import empty
from ..search.bucket_walk import points_within
from ..search.point_tree import PointTree, find_bucket

MAX_EXPONENT = 43.0  # maximum exponent
INVERSE_LOG2 = 1.4426950408889634
LOG2_HIGH = 0.693147180369123816490  # of ln 2: 32 bits, so that integer multiples are exact
LOG2_LOW = 1.90821492927058770002e-10
MAX_HALVINGS = 62.5  # of a Gaussian before it is cut off
EXPONENT_BIAS, EXPONENT_SHIFT = 127, 23  # of a float32
POINTS_PER_THREAD = 8  # points per CPU thread
RADIUS_SLACK = 1.001  # factor of a squared radius in float32, so that a tree omits nothing
octet = vector(8, float64)  # one number per point of a thread
pulls = vector(4, float64)  # sum of p, sum of p x
position_sums = vector(4, float64)
pull_moments = vector(22, float64)


@func
def falloff(x: float64) -> float64:
    """exp(-x) for x >= 0, to 2e-16, bitwise identical everywhere and branch-free. 0 beyond MAX_EXPONENT."""
    halvings = x * float64(INVERSE_LOG2) + 0.5
    n = int(halvings if halvings < float64(MAX_HALVINGS) else float64(MAX_HALVINGS))
    k = float64(n)
    r = (k * float64(LOG2_HIGH) - x) + k * float64(LOG2_LOW)
    s = float64(1.0 / 39916800.0)
    s = s * r + float64(1.0 / 3628800.0)
    s = s * r + float64(1.0 / 362880.0)
    s = s * r + float64(1.0 / 40320.0)
    s = s * r + float64(1.0 / 5040.0)
    s = s * r + float64(1.0 / 720.0)
    s = s * r + float64(1.0 / 120.0)
    s = s * r + float64(1.0 / 24.0)
    s = s * r + float64(1.0 / 6.0)
    s = s * r + 0.5
    s = s * r + 1.0
    s = s * r + 1.0
    value = s * float64(bits_float((EXPONENT_BIAS - n) << EXPONENT_SHIFT))  # s / 2^n, exact
    return value if x <= float64(MAX_EXPONENT) else float64(0.0)


@func
def inverse_of(total: float64, uniform: float64) -> float64:
    inverse = float64(0.0)
    if total + uniform > 0.0:
        inverse = 1.0 / (total + uniform)
    return inverse


@func
def falloff_between(dx: float64, dy: float64, dz: float64, scale: float64) -> float64:
    return falloff(scale * (dx * dx + dy * dy + dz * dz))


@func
def pull_between(y: vec3d, x: vec3d, scale: float64, inverse: float64) -> pulls:
    d = x - y
    p = falloff(scale * dot(d, d)) * inverse
    return pulls(p, p * x[0], p * x[1], p * x[2])


@kernel
def weigh_targets_kernel(
    targets: array(dtype=vec3d),
    moved: array(dtype=vec3d),
    count: int,
    scale: float64,
    uniform: float64,
    inverses: array(dtype=float64),
    fractions: array(dtype=float64),
):
    """Inverse denominator and inlier probability of each target. The last target of a thread may repeat."""
    i = tid()
    last = targets.shape[0] - 1
    x = octet(0.0)
    y = octet(0.0)
    z = octet(0.0)
    total = octet(0.0)
    for lane in range(POINTS_PER_THREAD):
        p = targets[min(POINTS_PER_THREAD * i + lane, last)]
        x[lane] = p[0]
        y[lane] = p[1]
        z[lane] = p[2]
    for j in range(count):
        q = moved[j]
        for lane in range(POINTS_PER_THREAD):
            total[lane] += falloff_between(x[lane] - q[0], y[lane] - q[1], z[lane] - q[2], scale)
    for lane in range(POINTS_PER_THREAD):
        index = POINTS_PER_THREAD * i + lane
        if index <= last:
            inverse = inverse_of(total[lane], uniform)
            inverses[index] = inverse
            fractions[index] = total[lane] * inverse


@weigh_targets_kernel.on_cuda
def weigh_target_kernel(
    targets: array(dtype=vec3d),
    moved: array(dtype=vec3d),
    count: int,
    scale: float64,
    uniform: float64,
    inverses: array(dtype=float64),
    fractions: array(dtype=float64),
):
    i = tid()
    x = targets[i]
    total = float64(0.0)
    for j in range(count):
        d = x - moved[j]
        total += falloff(scale * dot(d, d))
    inverse = inverse_of(total, uniform)
    inverses[i] = inverse
    fractions[i] = total * inverse


@kernel
def pull_sources_kernel(
    moved: array(dtype=vec3d),
    targets: array(dtype=vec3d),
    count: int,
    scale: float64,
    inverses: array(dtype=float64),
    sums: array(dtype=pulls),
):
    """Weighted sums at each source, POINTS_PER_THREAD per thread."""
    i = tid()
    last = moved.shape[0] - 1
    x = octet(0.0)
    y = octet(0.0)
    z = octet(0.0)
    total = octet(0.0)
    along_x = octet(0.0)
    along_y = octet(0.0)
    along_z = octet(0.0)
    for lane in range(POINTS_PER_THREAD):
        p = moved[min(POINTS_PER_THREAD * i + lane, last)]
        x[lane] = p[0]
        y[lane] = p[1]
        z[lane] = p[2]
    for j in range(count):
        q = targets[j]
        inverse = inverses[j]
        for lane in range(POINTS_PER_THREAD):
            fraction = falloff_between(q[0] - x[lane], q[1] - y[lane], q[2] - z[lane], scale) * inverse
            total[lane] += fraction
            along_x[lane] += fraction * q[0]
            along_y[lane] += fraction * q[1]
            along_z[lane] += fraction * q[2]
    for lane in range(POINTS_PER_THREAD):
        index = POINTS_PER_THREAD * i + lane
        if index <= last:
            sums[index] = pulls(total[lane], along_x[lane], along_y[lane], along_z[lane])


@pull_sources_kernel.on_cuda
def pull_source_kernel(
    moved: array(dtype=vec3d),
    targets: array(dtype=vec3d),
    count: int,
    scale: float64,
    inverses: array(dtype=float64),
    sums: array(dtype=pulls),
):
    i = tid()
    y = moved[i]
    total = pulls(0.0)
    for j in range(count):
        total += pull_between(y, targets[j], scale, inverses[j])
    sums[i] = total


@kernel
def weigh_near_targets_kernel(
    targets: array(dtype=vec3d),
    moved: array(dtype=vec3d),
    tree: PointTree,
    sqradius: float,
    scale: float64,
    uniform: float64,
    inverses: array(dtype=float64),
    fractions: array(dtype=float64),
):
    i = tid()
    x = targets[i]
    p = narrow(x)
    total = float64(0.0)
    for j, sqdist in points_within(find_bucket(p, tree), p, sqradius, tree):
        d = x - moved[tree.order[j]]
        total += falloff(scale * dot(d, d))
    inverse = inverse_of(total, uniform)
    inverses[i] = inverse
    fractions[i] = total * inverse


@kernel
def pull_near_sources_kernel(
    moved: array(dtype=vec3d),
    targets: array(dtype=vec3d),
    tree: PointTree,
    sqradius: float,
    scale: float64,
    inverses: array(dtype=float64),
    sums: array(dtype=pulls),
):
    i = tid()
    y = moved[i]
    q = narrow(y)
    total = pulls(0.0)
    for j, sqdist in points_within(find_bucket(q, tree), q, sqradius, tree):
        k = tree.order[j]
        total += pull_between(y, targets[k], scale, inverses[k])
    sums[i] = total


@kernel
def transform_to_positions_kernel(points: array(dtype=vec3), A: mat33d, t: vec3d, transformed: array(dtype=vec3d)):
    i = tid()
    transformed[i] = A @ widen(points[i]) + t


@kernel
def map_positions_kernel(positions: array(dtype=vec3d), A: mat33d, t: vec3d, moved: array(dtype=vec3d)):
    i = tid()
    moved[i] = A @ positions[i] + t


@reduction
def sum_positions(positions: array(dtype=vec3d)) -> position_sums:
    i = tid()
    p = positions[i]
    return position_sums(p[0], p[1], p[2], dot(p, p))


@reduction
def sum_targets(positions: array(dtype=vec3d), fractions: array(dtype=float64)) -> vec2d:
    """Inlier weight of the targets, weighted positions and squares."""
    i = tid()
    return vec2d(fractions[i], fractions[i] * dot(positions[i], positions[i]))


@reduction
def sum_pulls(positions: array(dtype=vec3d), sums: array(dtype=pulls)) -> pull_moments:
    """Sums over sources of p; p y; p x; (p x) y^T by rows; p y y^T, upper triangle."""
    i = tid()
    y = positions[i]
    s = sums[i]
    p = s[0]
    return pull_moments(
        p, p * y[0], p * y[1], p * y[2], s[1], s[2], s[3],
        s[1] * y[0], s[1] * y[1], s[1] * y[2], s[2] * y[0], s[2] * y[1], s[2] * y[2],
        s[3] * y[0], s[3] * y[1], s[3] * y[2],
        p * y[0] * y[0], p * y[0] * y[1], p * y[0] * y[2], p * y[1] * y[1], p * y[1] * y[2], p * y[2] * y[2],
    )  # fmt: skip


def transform_to_positions(points: Points, A: np.ndarray, t: np.ndarray) -> Positions:
    transformed = empty(points.size, vec3d, points.device)
    launch(transform_to_positions_kernel, points.size, [points, mat33d(*A.ravel()), vec3d(*t), transformed])
    return transformed


def tree_over(positions: Positions) -> PointTree:
    return PointTree(narrow_rows(positions))


class Drift:
    """Soft correspondences: inverse denominators and inlier `fractions` of targets (n); `sums` of p and p x (m)."""

    def __init__(self, targets: Positions, source_count: int) -> None:
        device = targets.device
        self.targets, self.tree = targets, tree_over(targets)
        self.inverses, self.fractions = empty(targets.size, float64, device), empty(targets.size, float64, device)
        self.sums = empty(source_count, pulls, device)

    def weigh(self, moved: Positions, variance: float, uniform: float, *, near: float) -> None:
        """Correspondences at a variance. By trees if the Gaussian's range is below `near`."""
        targets, scale = self.targets, 0.5 / variance
        sqradius = MAX_EXPONENT / scale * RADIUS_SLACK
        outputs: list[Doubles] = [self.inverses, self.fractions]
        if sqradius > near * near:
            each = 1 if targets.device.is_cuda else POINTS_PER_THREAD
            given = [targets, moved, moved.size, scale, uniform]
            launch(weigh_targets_kernel, -(-targets.size // each), [*given, *outputs])
            given = [moved, targets, targets.size, scale]
            launch(pull_sources_kernel, -(-moved.size // each), [*given, self.inverses, self.sums])
            return
        within = float(np.float32(sqradius + 1e-6))
        given = [targets, moved, tree_over(moved), within, scale, uniform]
        launch(weigh_near_targets_kernel, targets.size, [*given, *outputs])
        launch(
            pull_near_sources_kernel, moved.size, [moved, targets, self.tree, within, scale, self.inverses, self.sums]
        )
