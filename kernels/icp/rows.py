"""The rows of the Gauss-Newton systems of the ICP family, and their sums over the correspondences of each job.

Rows are about the target's origin: p is a source point under the current pose, q its target point, d = p - q, and the
unknowns x = (rotation, translation) move p by x_r x p + x_t. One element a source point; reads 60 to 130 B where there
is a pair; sums in float64 leave through the reduction: 21 of J^T J, 6 of J^T r, r^2, |d|^2, the pairs, p and q.

- point to point: the sums of Horn 1987 in the place of the first 18, then those of p p^T;
- point to plane: Chen and Medioni 1991;
- symmetric: Rusinkiewicz 2019, eqs. 10 and 11, before its points are centred;
- generalised: Segal, Haehnel and Thrun 2009; voxelised where the targets are voxels (Koide et al. 2021);
- coloured: Park, Zhou and Koltun 2017, eqs. 12 to 18;
- Doppler: Hexsel, Vhavle and Chen 2022, as Open3D has it.
"""

from ..algebra.rigid_solve import move, sums_of_pair, turn, vec6d
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
    vec3,
    vec3d,
    vector,
)
from ..search.point_tree import LEAF
from .covariance_rows import inverse_factor, inverse_root, read_covariance, trace_of_square, turn_covariance
from .robust_weights import GEOMETRY, L2, robust_weight

row_sums = vector(36, float64)
SPREAD_AT = 18  # point to point: where the sums of p p^T stand, row by row above the diagonal
DISTANCE_AT = 28  # where, after that of r^2, the sums of |d|^2, pairs, p and q stand
COUNT_AT = 29
SOURCE_AT = 30
TARGET_AT = 33
NO_PAIR = -1


@func
def sum_row(u: vec3d, v: vec3d, r: float64, w: float64) -> row_sums:
    """A weighted row with Jacobian (u, v) and residual r."""
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
def sum_pair(p: vec3d, q: vec3d, w: float64) -> row_sums:
    """A weighted pair: the sums that `fit_pose` takes, then those of p p^T."""
    s = sums_of_pair(p, q, w)
    z = float64(0.0)
    return row_sums(
        s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[10], s[11], s[12], s[13], s[14], s[15], s[16],
        s[17], w * p[0] * p[0], w * p[0] * p[1], w * p[0] * p[2], w * p[1] * p[1], w * p[1] * p[2], w * p[2] * p[2],
        z, z, z, z, z, z, z, z, z, z, z, z,
    )  # fmt: skip


@func
def count_pair(sums: row_sums, p: vec3d, q: vec3d) -> row_sums:
    """The sums with one pair more."""
    d = p - q
    z = float64(0.0)
    one = float64(1.0)
    return sums + row_sums(
        z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z,
        dot(d, d), one, p[0], p[1], p[2], q[0], q[1], q[2],
    )  # fmt: skip


@struct
class JobTables:
    """Whose element is whose: the groups of each job, and where its source begins."""

    group_jobs: array(dtype=int32)
    job_groups: array(dtype=int32)
    job_sources: array(dtype=int32)
    source_bases: array(dtype=int32)


@struct
class Matches:
    """The jobs, their poses, and the pairs found under them."""

    jobs: JobTables
    poses: array(dtype=mat44d)
    pairs: array(dtype=int32)
    sources: array(dtype=vec3)
    targets: array(dtype=vec3)


@func
def source_place(
    i: int,
    jobs: JobTables,
) -> int:
    """Where the source point of element i stands."""
    job = jobs.group_jobs[i // LEAF]
    return jobs.source_bases[jobs.job_sources[job]] + i - jobs.job_groups[job] * LEAF


@segment_reduction
def sum_point_rows(
    loop: Matches,
    kind: int,
    k: float64,
    shape: float64,
    pivots: array(dtype=vec3d),
) -> row_sums:
    """Point to point: sums of pairs about each job's pivot; the weight is that of the distance."""
    i = tid()
    total = row_sums(float64(0.0))
    if loop.pairs[i] >= 0:
        job = loop.jobs.group_jobs[i // LEAF]
        at = source_place(i, loop.jobs)
        p = move(loop.poses[job], widen(loop.sources[at]))
        q = widen(loop.targets[loop.pairs[i]])
        w = float64(1.0)
        if kind != L2:
            d = p - q
            w = robust_weight(kind, k, shape, sqrt(dot(d, d)))
        total = count_pair(sum_pair(p - pivots[job], q - pivots[job], w), p, q)
    return total


@segment_reduction
def sum_plane_rows(
    loop: Matches,
    kind: int,
    k: float64,
    shape: float64,
    target_normals: array(dtype=vec3),
) -> row_sums:
    """Point to plane: r = d . n, J = (p x n, n)."""
    i = tid()
    total = row_sums(float64(0.0))
    if loop.pairs[i] >= 0:
        job = loop.jobs.group_jobs[i // LEAF]
        at = source_place(i, loop.jobs)
        p = move(loop.poses[job], widen(loop.sources[at]))
        q = widen(loop.targets[loop.pairs[i]])
        n = widen(target_normals[loop.pairs[i]])
        r = dot(p - q, n)
        total = count_pair(sum_row(cross(p, n), n, r, robust_weight(kind, k, shape, r)), p, q)
    return total


@segment_reduction
def sum_symmetric_rows(
    loop: Matches,
    kind: int,
    k: float64,
    shape: float64,
    source_normals: array(dtype=vec3),
    target_normals: array(dtype=vec3),
) -> row_sums:
    """Symmetric: r = d . m, J = ((p + q) x m, m), with m the sum of both normals, turned to one side."""
    i = tid()
    total = row_sums(float64(0.0))
    if loop.pairs[i] >= 0:
        job = loop.jobs.group_jobs[i // LEAF]
        at = source_place(i, loop.jobs)
        p = move(loop.poses[job], widen(loop.sources[at]))
        q = widen(loop.targets[loop.pairs[i]])
        n = turn(loop.poses[job], widen(source_normals[at]))
        m = widen(target_normals[loop.pairs[i]])
        if dot(n, m) < float64(0.0):
            m = m - n
        else:
            m = m + n
        r = dot(p - q, m)
        total = count_pair(sum_row(cross(p + q, m), m, r, robust_weight(kind, k, shape, r)), p, q)
    return total


@segment_reduction
def sum_generalized_rows(
    loop: Matches,
    kind: int,
    k: float64,
    shape: float64,
    source_covariances: array(dtype=float32, ndim=2),
    target_covariances: array(dtype=float32, ndim=2),
) -> row_sums:
    """Generalised: the rows of W d with W^T W = (C_target + R C_source R^T)^-1; a kernel weights each row."""
    i = tid()
    total = row_sums(float64(0.0))
    if loop.pairs[i] >= 0:
        job = loop.jobs.group_jobs[i // LEAF]
        at = source_place(i, loop.jobs)
        pose = loop.poses[job]
        p = move(pose, widen(loop.sources[at]))
        q = widen(loop.targets[loop.pairs[i]])
        M = read_covariance(target_covariances, loop.pairs[i]) + turn_covariance(
            pose, read_covariance(source_covariances, at)
        )
        W = mat33d(float64(0.0))
        if kind <= L2:
            W = inverse_factor(M)
        else:
            W = inverse_root(M)
        d = p - q
        for row in range(3):
            v = vec3d(W[row, 0], W[row, 1], W[row, 2])
            r = dot(v, d)
            total += sum_row(cross(p, v), v, r, robust_weight(kind, k, shape, r))
        if kind == GEOMETRY:
            # what covariances hold along planes fixes no motion of a smooth surface: take it off, and count pairs alike
            floor = float64(1.0) / sqrt(trace_of_square(M))  # no eigenvalue of M is larger than this root
            trace = float64(0.0)
            for row in range(3):
                e = vec3d(float64(0.0), float64(0.0), float64(0.0))
                e[row] = float64(1.0)
                total += sum_row(cross(p, e), e, float64(0.0), -floor)
                trace += W[row, 0] * W[row, 0] + W[row, 1] * W[row, 1] + W[row, 2] * W[row, 2] - floor
            total = total * (float64(1.0) / trace)
        total = count_pair(total, p, q)
    return total


@segment_reduction
def sum_colored_rows(
    loop: Matches,
    kind: int,
    k: float64,
    shape: float64,
    target_normals: array(dtype=vec3),
    source_intensities: array(dtype=float32, ndim=2),
    target_intensities: array(dtype=float32, ndim=2),
    target_gradients: array(dtype=vec3),
    geometric_share: float64,
) -> row_sums:
    """Coloured: a point-to-plane row, and the difference of intensities at p projected onto the target's plane."""
    i = tid()
    total = row_sums(float64(0.0))
    if loop.pairs[i] >= 0:
        job = loop.jobs.group_jobs[i // LEAF]
        at = source_place(i, loop.jobs)
        p = move(loop.poses[job], widen(loop.sources[at]))
        q = widen(loop.targets[loop.pairs[i]])
        n = widen(target_normals[loop.pairs[i]])
        g = widen(target_gradients[loop.pairs[i]])
        geometric = sqrt(geometric_share)
        photometric = sqrt(float64(1.0) - geometric_share)
        height = dot(p - q, n)
        r = geometric * height
        total += sum_row(geometric * cross(p, n), geometric * n, r, robust_weight(kind, k, shape, r))
        expected = float64(target_intensities[loop.pairs[i], 0]) + dot(g, p - height * n - q)
        r = photometric * (float64(source_intensities[at, 0]) - expected)
        h = -(g - dot(g, n) * n)
        total += sum_row(photometric * cross(p, h), photometric * h, r, robust_weight(kind, k, shape, r))
        total = count_pair(total, p, q)
    return total


@segment_reduction
def sum_doppler_rows(
    loop: Matches,
    kind: int,
    k: float64,
    shape: float64,
    target_normals: array(dtype=vec3),
    dopplers: array(dtype=float32, ndim=2),
    directions: array(dtype=vec3),
    velocities: array(dtype=vec6d),
    iterations: array(dtype=int32),
    sensor: vec3d,
    period: float64,
    doppler_share: float64,
    doppler_kind: int,
    doppler_k: float64,
    doppler_shape: float64,
    geometric_from: int,
    doppler_from: int,
    reject_from: int,
    threshold: float64,
) -> row_sums:
    """Doppler: a point-to-plane row, and the radial speed against that of the motion since the last scan."""
    i = tid()
    total = row_sums(float64(0.0))
    if loop.pairs[i] >= 0:
        job = loop.jobs.group_jobs[i // LEAF]
        at = source_place(i, loop.jobs)
        p = move(loop.poses[job], widen(loop.sources[at]))
        q = widen(loop.targets[loop.pairs[i]])
        n = widen(target_normals[loop.pairs[i]])
        u = widen(directions[at])
        motion = velocities[job]
        turning = vec3d(motion[0], motion[1], motion[2])
        v = vec3d(motion[3], motion[4], motion[5]) + cross(turning, sensor)
        error = float64(dopplers[at, 0]) + dot(u, v)
        if iterations[job] < reject_from or abs(error) <= threshold:
            share = sqrt(float64(1.0) - doppler_share)
            r = share * dot(p - q, n)
            w = float64(1.0)
            if iterations[job] >= geometric_from:
                w = robust_weight(kind, k, shape, r)
            total += sum_row(share * cross(p, n), share * n, r, w)
            share = sqrt(doppler_share)
            r = share * error
            w = float64(1.0)
            if iterations[job] >= doppler_from:
                w = robust_weight(doppler_kind, doppler_k, doppler_shape, r)
            share = share / period
            total += sum_row(share * cross(u, sensor), -share * u, r, w)
        total = count_pair(total, p, q)
    return total


@segment_reduction
def sum_information(
    group_jobs: array(dtype=int32),
    pairs: array(dtype=int32),
    targets: array(dtype=vec3),
) -> row_sums:
    """Sums of G^T G with G = (-[q]x, I): the information of the pairs about the target's origin."""
    i = tid()
    total = row_sums(float64(0.0))
    if pairs[i] >= 0:
        q = widen(targets[pairs[i]])
        zero = float64(0.0)
        one = float64(1.0)
        total += sum_row(vec3d(zero, q[2], -q[1]), vec3d(one, zero, zero), zero, one)
        total += sum_row(vec3d(-q[2], zero, q[0]), vec3d(zero, one, zero), zero, one)
        total += sum_row(vec3d(q[1], -q[0], zero), vec3d(zero, zero, one), zero, one)
        total[COUNT_AT] = one
    return total
