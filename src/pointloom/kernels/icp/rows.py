"""Linear systems of ICP: Gauss-Newton rows of the correspondences, and their float64 sums (normal equations) per job.

About the target's origin: p is a posed source point, q its target point, d = p - q; x = (rotation, translation) moves p
by x_r x p + x_t. Sums: 21 of J^T J, 6 of J^T r, r^2, |d|^2, pairs, p and q.

- point to point: the sums of Horn 1987 instead of the first 18, then those of p p^T;
- point to plane: Chen and Medioni 1991;
- symmetric: Rusinkiewicz 2019, eqs. 10 and 11, before centering;
- generalized: Segal, Haehnel and Thrun 2009; voxelized: Koide et al. 2021;
- colored: Park, Zhou and Koltun 2017, eqs. 12 to 18;
- Doppler: Hexsel, Vhavle and Chen 2022, as in Open3D.
"""

import numpy as np

from ..algebra.matrices import multiply33
from ..algebra.rigid_solve import diagonalize_three, rotate, sums_of_pair, triangle, vec6d
from ..algebra.transform import widen
from ..lang import (
    array,
    cross,
    dot,
    float32,
    float64,
    func,
    int32,
    mat33d,
    mat44d,
    segment_reduction,
    sqrt,
    struct,
    tid,
    vec3d,
    vector,
)
from ..search.point_tree import LEAF
from .jobs import source_position
from .matches import Matches, PointColumns, pair_of, paired_target, weight_of
from .robust_weights import GEOMETRY_ONLY, L2_LOSS, Loss, robust_weight


@func
def read_covariance(covariances: array(dtype=float32, ndim=2), i: int) -> mat33d:
    C = mat33d(0.0)
    for row in range(3):
        for column in range(3):
            C[row, column] = float64(covariances[i, 3 * row + column])
    return C


@func
def rotate_covariance(pose: mat44d, C: mat33d) -> mat33d:
    R = mat33d(0.0)
    for row in range(3):
        for column in range(3):
            R[row, column] = pose[row, column]
    RC = multiply33(R, C)
    out = mat33d(0.0)
    for row in range(3):
        for column in range(3):
            out[row, column] = RC[row, 0] * R[column, 0] + RC[row, 1] * R[column, 1] + RC[row, 2] * R[column, 2]
    return out


@func
def inverse_root(M: mat33d) -> mat33d:
    """Symmetric root M^(-1/2) of a positive definite matrix. Directions of no variance are skipped."""
    system = diagonalize_three(M)
    W = mat33d(0.0)
    for k in range(3):
        value = system[9 + k]
        if value > 1.0e-30:
            root = 1.0 / sqrt(value)
            for row in range(3):
                for column in range(3):
                    W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]
    return W


@func
def inverse(M: mat33d) -> mat33d:
    """Inverse of a symmetric positive definite matrix by cofactors. Zero if singular."""
    x = M[1, 1] * M[2, 2] - M[1, 2] * M[1, 2]
    y = M[0, 2] * M[1, 2] - M[0, 1] * M[2, 2]
    z = M[0, 1] * M[1, 2] - M[0, 2] * M[1, 1]
    det = M[0, 0] * x + M[0, 1] * y + M[0, 2] * z
    s = float64(0.0)
    if det > 0.0:
        s = 1.0 / det
    a = (M[0, 0] * M[2, 2] - M[0, 2] * M[0, 2]) * s
    b = (M[0, 1] * M[0, 2] - M[0, 0] * M[1, 2]) * s
    c = (M[0, 0] * M[1, 1] - M[0, 1] * M[0, 1]) * s
    return mat33d(x * s, y * s, z * s, y * s, a, b, z * s, b, c)


@func
def trace_of_square(M: mat33d) -> float64:
    total = float64(0.0)
    for row in range(3):
        for column in range(3):
            total += M[row, column] * M[row, column]
    return total


row_sums = vector(36, float64)
SPREAD_AT = 18  # point to point: offset of the sums of p p^T, row by row above the diagonal
RESIDUAL_AT = 27  # offset of the sum of w r^2
DISTANCE_AT = 28  # offset, after that of r^2, of the sums of |d|^2, pairs, p and q
COUNT_AT = 29
SOURCE_AT = 30
TARGET_AT = 33


@func
def sum_row(u: vec3d, v: vec3d, r: float64, w: float64) -> row_sums:
    a = w * u
    b = w * v
    z = float64(0.0)
    return row_sums(
        a[0] * u[0], a[0] * u[1], a[0] * u[2], a[0] * v[0], a[0] * v[1], a[0] * v[2],
        a[1] * u[1], a[1] * u[2], a[1] * v[0], a[1] * v[1], a[1] * v[2],
        a[2] * u[2], a[2] * v[0], a[2] * v[1], a[2] * v[2],
        b[0] * v[0], b[0] * v[1], b[0] * v[2],
        b[1] * v[1], b[1] * v[2],
        b[2] * v[2],
        a[0] * r, a[1] * r, a[2] * r, b[0] * r, b[1] * r, b[2] * r,
        w * r * r, z, z, z, z, z, z, z, z,
    )  # fmt: skip


@func
def sum_block(p: vec3d, A: mat33d, d: vec3d) -> row_sums:
    """The sum of `sum_row` of (p x v, v, v . d, 1) over vectors v whose sum of v v^T is A."""
    a = vec3d(A[0, 0], A[1, 0], A[2, 0])
    b = vec3d(A[0, 1], A[1, 1], A[2, 1])
    c = vec3d(A[0, 2], A[1, 2], A[2, 2])
    ta = cross(p, a)
    tb = cross(p, b)
    tc = cross(p, c)
    x = cross(p, vec3d(ta[0], tb[0], tc[0]))
    y = cross(p, vec3d(ta[1], tb[1], tc[1]))
    z = cross(p, vec3d(ta[2], tb[2], tc[2]))
    f = a * d[0] + b * d[1] + c * d[2]
    m = cross(p, f)
    o = float64(0.0)
    return row_sums(
        x[0], y[0], z[0], ta[0], tb[0], tc[0],
        y[1], z[1], ta[1], tb[1], tc[1],
        z[2], ta[2], tb[2], tc[2],
        a[0], b[0], c[0],
        b[1], c[1],
        c[2],
        m[0], m[1], m[2], f[0], f[1], f[2],
        dot(d, f), o, o, o, o, o, o, o, o,
    )  # fmt: skip


@func
def row_system(sums: row_sums) -> tuple[triangle, vec6d]:
    h = triangle(0.0)
    for j in range(21):
        h[j] = sums[j]
    return h, vec6d(sums[21], sums[22], sums[23], sums[24], sums[25], sums[26])


@func
def sum_pair(p: vec3d, q: vec3d, w: float64) -> row_sums:
    """Weighted pair: the sums of `fit_pose`, then those of p p^T."""
    s = sums_of_pair(p, q, w)
    z = float64(0.0)
    return row_sums(
        s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[10], s[11], s[12], s[13], s[14], s[15], s[16],
        s[17], w * p[0] * p[0], w * p[0] * p[1], w * p[0] * p[2], w * p[1] * p[1], w * p[1] * p[2], w * p[2] * p[2],
        z, z, z, z, z, z, z, z, z, z, z, z,
    )  # fmt: skip


@func
def count_pair(sums: row_sums, p: vec3d, q: vec3d, paired: float64) -> row_sums:
    """Add a pair's sums to a row's. Without a pair p, q and `paired` are zero."""
    d = p - q
    counted = sums
    counted[DISTANCE_AT] = dot(d, d)
    counted[COUNT_AT] = paired
    for axis in range(3):
        counted[SOURCE_AT + axis] = p[axis]
        counted[TARGET_AT + axis] = q[axis]
    return counted


@func
def mean_source(sums: row_sums) -> vec3d:
    count = sums[COUNT_AT]
    return vec3d(sums[SOURCE_AT] / count, sums[SOURCE_AT + 1] / count, sums[SOURCE_AT + 2] / count)


@func
def mean_target(sums: row_sums) -> vec3d:
    count = sums[COUNT_AT]
    return vec3d(sums[TARGET_AT] / count, sums[TARGET_AT + 1] / count, sums[TARGET_AT + 2] / count)


@struct
class DopplerRule:
    """Weights of Doppler rows. `sensor`: vehicle position in the sensor frame [m]; `period` [s]; `fraction`, 0..1.
    First iterations of robust kernels (`geometric_from`, `doppler_from`) and of rejection above `threshold` [m/s].
    """

    sensor: vec3d
    period: float64
    fraction: float64
    loss: Loss
    geometric_from: int
    doppler_from: int
    reject_from: int
    threshold: float64

    def __init__(
        self,
        sensor: np.ndarray,
        period: float,
        fraction: float,
        loss: Loss,
        *,
        geometric_from: int,
        doppler_from: int,
        reject_from: int,
        threshold: float,
    ) -> None:
        self.sensor, self.period, self.fraction, self.loss = vec3d(*sensor), period, fraction, loss
        self.geometric_from, self.doppler_from = geometric_from, doppler_from
        self.reject_from, self.threshold = reject_from, threshold


@segment_reduction(max_registers=128)  # for two blocks per SM
def sum_point_rows(matches: Matches, loss: Loss, pivots: array(dtype=vec3d)) -> row_sums:
    """Point to point: sums of pairs about each job's pivot, weighted by distance."""
    i = tid()
    p, q, paired = pair_of(i, matches)
    a = vec3d(0.0)
    b = vec3d(0.0)
    w = float64(0.0)
    if paired > 0.0:
        pivot = pivots[matches.jobs.group_jobs[i // LEAF]]
        a = p - pivot
        b = q - pivot
        w = 1.0
        if loss.kind != L2_LOSS:
            d = p - q
            w = robust_weight(loss, sqrt(dot(d, d)))
        w = w * weight_of(i, matches)
    return count_pair(sum_pair(a, b, w), p, q, paired)


@segment_reduction(max_registers=128)  # for two blocks per SM
def sum_plane_rows(matches: Matches, loss: Loss, target: PointColumns) -> row_sums:
    """Point to plane: r = d . n, J = (p x n, n)."""
    i = tid()
    p, q, paired = pair_of(i, matches)
    n = vec3d(0.0)
    r = float64(0.0)
    w = float64(0.0)
    if paired > 0.0:
        n = widen(target.normals[matches.pairs[i]])
        r = dot(p - q, n)
        w = robust_weight(loss, r) * weight_of(i, matches)
    return count_pair(sum_row(cross(p, n), n, r, w), p, q, paired)


@segment_reduction(max_registers=128)  # for two blocks per SM
def sum_symmetric_rows(matches: Matches, loss: Loss, source: PointColumns, target: PointColumns) -> row_sums:
    """Symmetric: r = d . m, J = ((p + q) x m, m), with m the sum of both normals on one side."""
    i = tid()
    p, q, paired = pair_of(i, matches)
    m = vec3d(0.0)
    r = float64(0.0)
    w = float64(0.0)
    if paired > 0.0:
        job = matches.jobs.group_jobs[i // LEAF]
        at = source_position(i, matches.jobs)
        n = rotate(matches.poses[job], widen(source.normals[at]))
        m = widen(target.normals[matches.pairs[i]])
        if dot(n, m) < 0.0:
            m = m - n
        else:
            m = m + n
        r = dot(p - q, m)
        w = robust_weight(loss, r) * weight_of(i, matches)
    return count_pair(sum_row(cross(p + q, m), m, r, w), p, q, paired)


@segment_reduction
def sum_generalized_rows(matches: Matches, loss: Loss, source: PointColumns, target: PointColumns) -> row_sums:
    """Generalized: rows of W d with W^T W = (C_target + R C_source R^T)^-1. A kernel weights those of a symmetric W."""
    i = tid()
    p, q, paired = pair_of(i, matches)
    total = row_sums(0.0)
    if paired > 0.0:
        job = matches.jobs.group_jobs[i // LEAF]
        at = source_position(i, matches.jobs)
        pose = matches.poses[job]
        M = read_covariance(target.covariances, matches.pairs[i]) + rotate_covariance(
            pose, read_covariance(source.covariances, at)
        )
        d = p - q
        if loss.kind <= L2_LOSS:
            A = inverse(M)
            scale = weight_of(i, matches)
            if loss.kind == GEOMETRY_ONLY:
                # in-plane covariance fixes no motion of a smooth surface: remove it, and count pairs equally
                floor = 1.0 / sqrt(trace_of_square(M))  # upper bound of the eigenvalues of M is this root
                for row in range(3):
                    A[row, row] = A[row, row] - floor
                scale = scale / (A[0, 0] + A[1, 1] + A[2, 2])
            total = sum_block(p, A, d) * scale
        else:
            W = inverse_root(M)
            for row in range(3):
                v = vec3d(W[row, 0], W[row, 1], W[row, 2])
                r = dot(v, d)
                total += sum_row(cross(p, v), v, r, robust_weight(loss, r))
            total = total * weight_of(i, matches)
        total = count_pair(total, p, q, paired)
    return total


@segment_reduction
def sum_colored_rows(
    matches: Matches, loss: Loss, source: PointColumns, target: PointColumns, geometric_fraction: float64
) -> row_sums:
    """Colored: a point-to-plane row, and the intensity difference at p projected to the target's plane."""
    i = tid()
    p, q, paired = pair_of(i, matches)
    n = vec3d(0.0)
    h = vec3d(0.0)
    r = float64(0.0)
    s = float64(0.0)
    w = float64(0.0)
    y = float64(0.0)
    geometric = sqrt(geometric_fraction)
    photometric = sqrt(1.0 - geometric_fraction)
    if paired > 0.0:
        at = source_position(i, matches.jobs)
        n = widen(target.normals[matches.pairs[i]])
        g = widen(target.gradients[matches.pairs[i]])
        height = dot(p - q, n)
        r = geometric * height
        w = robust_weight(loss, r) * weight_of(i, matches)
        expected = float64(target.intensities[matches.pairs[i], 0]) + dot(g, p - height * n - q)
        s = photometric * (float64(source.intensities[at, 0]) - expected)
        y = robust_weight(loss, s) * weight_of(i, matches)
        h = -(g - dot(g, n) * n)
    total = sum_row(geometric * cross(p, n), geometric * n, r, w)
    total += sum_row(photometric * cross(p, h), photometric * h, s, y)
    return count_pair(total, p, q, paired)


@segment_reduction
def sum_doppler_rows(
    matches: Matches,
    loss: Loss,
    source: PointColumns,
    target: PointColumns,
    velocities: array(dtype=vec6d),
    iterations: array(dtype=int32),
    rule: DopplerRule,
) -> row_sums:
    """Doppler: a point-to-plane row, and the radial speed against that of the motion since the last scan."""
    i = tid()
    p, q, paired = pair_of(i, matches)
    n = vec3d(0.0)
    u = vec3d(0.0)
    r = float64(0.0)
    s = float64(0.0)
    w = float64(0.0)
    y = float64(0.0)
    fraction = sqrt(1.0 - rule.fraction)
    doppler_fraction = sqrt(rule.fraction)
    if paired > 0.0:
        job = matches.jobs.group_jobs[i // LEAF]
        at = source_position(i, matches.jobs)
        direction = widen(source.directions[at])
        motion = velocities[job]
        turning = vec3d(motion[0], motion[1], motion[2])
        v = vec3d(motion[3], motion[4], motion[5]) + cross(turning, rule.sensor)
        error = float64(source.dopplers[at, 0]) + dot(direction, v)
        if iterations[job] < rule.reject_from or abs(error) <= rule.threshold:
            n = widen(target.normals[matches.pairs[i]])
            u = direction
            r = fraction * dot(p - q, n)
            given = weight_of(i, matches)
            w = given
            if iterations[job] >= rule.geometric_from:
                w = given * robust_weight(loss, r)
            s = doppler_fraction * error
            y = given
            if iterations[job] >= rule.doppler_from:
                y = given * robust_weight(rule.loss, s)
    doppler_fraction = doppler_fraction / rule.period
    total = sum_row(fraction * cross(p, n), fraction * n, r, w)
    total += sum_row(doppler_fraction * cross(u, rule.sensor), -doppler_fraction * u, s, y)
    return count_pair(total, p, q, paired)


@segment_reduction
def sum_information(matches: Matches) -> row_sums:
    """Sums of G^T G with G = (-[q]x, I): the information of the pairs about the target's origin."""
    i = tid()
    total = row_sums(0.0)
    if matches.pairs[i] >= 0:
        q = paired_target(i, matches)
        zero = float64(0.0)
        one = float64(1.0)
        total += sum_row(vec3d(zero, q[2], -q[1]), vec3d(one, zero, zero), zero, one)
        total += sum_row(vec3d(-q[2], zero, q[0]), vec3d(zero, one, zero), zero, one)
        total += sum_row(vec3d(q[1], -q[0], zero), vec3d(zero, zero, one), zero, one)
        total[COUNT_AT] = one
    return total
