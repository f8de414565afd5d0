"""Small dense float64 solvers of rigid registration, one thread per system: LDL^T of six unknowns, cyclic Jacobi
eigenvectors (Golub and Van Loan, section 8.5), and the best fit of pairs (Horn 1987). Unknowns are (rotation,
translation). 6x6 upper triangles are row-major.
"""

from ..lang import cos, float64, func, mat33d, mat44d, sin, sqrt, vec2d, vec3d, vec4d, vector

UNKNOWN_COUNT = 6
TRIANGLE_NUMBERS = 21
JACOBI_SWEEPS = 10  # Jacobi sweeps: 6x6 matrices converge to rounding after 6 to 8
vec6d = vector(6, float64)
triangle = vector(21, float64)
square = vector(36, float64)  # an n x n matrix, n up to 6, row by row in the first n * n
eigensystem = vector(42, float64)  # eigenvectors as the columns of an n x n matrix, eigenvalues from 36 on
four_square = vector(16, float64)  # a 4x4 matrix, row by row
four_system = vector(20, float64)  # as `eigensystem` of a 4x4 matrix: eigenvalues from 16 on
three_system = vector(12, float64)  # of a 3x3 matrix: eigenvalues from 9 on
pair_sums = vector(18, float64)  # of weighted pairs (p, q): w, wp, wq, wp q^T, w|p|^2, w|q|^2


@func
def triangle_index(row: int, column: int) -> int:
    """Index of entry (row, column), row <= column, in the upper triangle of a 6x6 matrix."""
    return row * UNKNOWN_COUNT - (row * (row - 1)) // 2 + column - row


@func
def full_matrix(h: triangle) -> square:
    a = square(0.0)
    for i in range(6):  # unrolled: constant indices
        for j in range(6):
            if j >= i:
                a[i * UNKNOWN_COUNT + j] = h[triangle_index(i, j)]
                a[j * UNKNOWN_COUNT + i] = h[triangle_index(i, j)]
    return a


@func
def diagonalize(matrix: square, n: int) -> eigensystem:
    """Eigenvectors and eigenvalues of a symmetric n x n matrix, n up to 6, unordered."""
    a = matrix
    system = eigensystem(0.0)
    for i in range(n):
        system[i * n + i] = 1.0
    sweeps = int(JACOBI_SWEEPS)
    for _ in range(sweeps):
        for p in range(n - 1):
            for q in range(p + 1, n):
                apq = a[p * n + q]
                app = a[p * n + p]
                aqq = a[q * n + q]
                if abs(apq) > 1.0e-300 and abs(apq) > 1.0e-18 * sqrt(abs(app * aqq)):
                    theta = (aqq - app) / (2.0 * apq)
                    t = 1.0 / (abs(theta) + sqrt(theta * theta + 1.0))
                    if theta < 0.0:
                        t = -t
                    c = 1.0 / sqrt(t * t + 1.0)
                    s = t * c
                    for k in range(n):
                        akp = a[k * n + p]
                        akq = a[k * n + q]
                        a[k * n + p] = c * akp - s * akq
                        a[k * n + q] = s * akp + c * akq
                    for k in range(n):
                        apk = a[p * n + k]
                        aqk = a[q * n + k]
                        a[p * n + k] = c * apk - s * aqk
                        a[q * n + k] = s * apk + c * aqk
                    for k in range(n):
                        vkp = system[k * n + p]
                        vkq = system[k * n + q]
                        system[k * n + p] = c * vkp - s * vkq
                        system[k * n + q] = s * vkp + c * vkq
    for i in range(n):
        system[36 + i] = a[i * n + i]
    return system


@func
def jacobi_rotation(app: float64, aqq: float64, apq: float64) -> vec2d:
    """Cosine and sine of the rotation that zeros entry (p, q) of a symmetric matrix."""
    theta = (aqq - app) / (2.0 * apq)
    t = 1.0 / (abs(theta) + sqrt(theta * theta + 1.0))
    if theta < 0.0:
        t = -t
    c = 1.0 / sqrt(t * t + 1.0)
    return vec2d(c, t * c)


@func
def diagonalize_four(matrix: four_square) -> four_system:
    """`diagonalize` of a 4x4 matrix, bitwise; unrolled so that CUDA uses registers."""
    a = matrix
    v = four_square(0.0)
    for i in range(4):
        v[i * 5] = 1.0
    rotated = 1
    sweep = 0
    while rotated == 1 and sweep < JACOBI_SWEEPS:  # a sweep without rotations is the last
        rotated = 0
        sweep += 1
        for pair in range(6):
            p = 0 if pair < 3 else (1 if pair < 5 else 2)
            q = pair + 1 - (0 if pair < 3 else (2 if pair < 5 else 3))
            apq = a[p * 4 + q]
            app = a[p * 4 + p]
            aqq = a[q * 4 + q]
            if abs(apq) > 1.0e-300 and abs(apq) > 1.0e-18 * sqrt(abs(app * aqq)):
                rotated = 1
                cs = jacobi_rotation(app, aqq, apq)
                for k in range(4):
                    akp = a[k * 4 + p]
                    akq = a[k * 4 + q]
                    a[k * 4 + p] = cs[0] * akp - cs[1] * akq
                    a[k * 4 + q] = cs[1] * akp + cs[0] * akq
                for k in range(4):
                    apk = a[p * 4 + k]
                    aqk = a[q * 4 + k]
                    a[p * 4 + k] = cs[0] * apk - cs[1] * aqk
                    a[q * 4 + k] = cs[1] * apk + cs[0] * aqk
                for k in range(4):
                    vkp = v[k * 4 + p]
                    vkq = v[k * 4 + q]
                    v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq
                    v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq
    system = four_system(0.0)
    for i in range(16):
        system[i] = v[i]
    for i in range(4):
        system[16 + i] = a[i * 5]
    return system


@func
def largest_of_four(system: four_system) -> vec4d:
    """Eigenvector of the largest eigenvalue, the first of equal ones."""
    largest = system[16]
    eigenvector = vec4d(system[0], system[4], system[8], system[12])
    for k in range(1, 4):
        if system[16 + k] > largest:
            largest = system[16 + k]
            eigenvector = vec4d(system[k], system[4 + k], system[8 + k], system[12 + k])
    return eigenvector


@func
def diagonalize_three(matrix: mat33d) -> three_system:
    """`diagonalize` of a 3x3 matrix, bitwise, in registers."""
    a = matrix * 1.0
    v = mat33d(
        1.0, 0.0, 0.0,
        0.0, 1.0, 0.0,
        0.0, 0.0, 1.0,
    )  # fmt: skip
    rotated = 1
    sweep = 0
    while rotated == 1 and sweep < JACOBI_SWEEPS:
        rotated = 0
        sweep += 1
        for pair in range(3):
            p = 1 if pair == 2 else 0
            q = 1 if pair == 0 else 2
            apq = a[p, q]
            app = a[p, p]
            aqq = a[q, q]
            if abs(apq) > 1.0e-300 and abs(apq) > 1.0e-18 * sqrt(abs(app * aqq)):
                rotated = 1
                cs = jacobi_rotation(app, aqq, apq)
                for k in range(3):
                    akp = a[k, p]
                    akq = a[k, q]
                    a[k, p] = cs[0] * akp - cs[1] * akq
                    a[k, q] = cs[1] * akp + cs[0] * akq
                for k in range(3):
                    apk = a[p, k]
                    aqk = a[q, k]
                    a[p, k] = cs[0] * apk - cs[1] * aqk
                    a[q, k] = cs[1] * apk + cs[0] * aqk
                for k in range(3):
                    vkp = v[k, p]
                    vkq = v[k, q]
                    v[k, p] = cs[0] * vkp - cs[1] * vkq
                    v[k, q] = cs[1] * vkp + cs[0] * vkq
    return three_system(
        v[0, 0], v[0, 1], v[0, 2], v[1, 0], v[1, 1], v[1, 2], v[2, 0], v[2, 1], v[2, 2], a[0, 0], a[1, 1], a[2, 2]
    )


@func
def factor_system(h: triangle) -> square:
    """LDL^T of a positive definite 6x6 matrix: D on the diagonal, 0 without a pivot; unrolled into registers."""
    a = full_matrix(h)
    largest = float64(0.0)
    for j in range(6):
        largest = max(largest, abs(a[j * UNKNOWN_COUNT + j]))
    for j in range(6):
        d = a[j * UNKNOWN_COUNT + j]
        for k in range(j):
            d -= a[j * UNKNOWN_COUNT + k] * a[j * UNKNOWN_COUNT + k] * a[k * UNKNOWN_COUNT + k]
        inverse = float64(0.0)
        if d > 1.0e-15 * largest:
            inverse = 1.0 / d
        elif d - d == 0.0:
            d = 0.0
        else:
            inverse = d  # a step of zeros would be taken for convergence
        a[j * UNKNOWN_COUNT + j] = d
        for i in range(6):
            if i > j:
                v = a[i * UNKNOWN_COUNT + j]
                for k in range(j):
                    v -= a[i * UNKNOWN_COUNT + k] * a[j * UNKNOWN_COUNT + k] * a[k * UNKNOWN_COUNT + k]
                a[i * UNKNOWN_COUNT + j] = v * inverse
    return a


@func
def solve_factored(a: square, b: vec6d) -> vec6d:
    """Solve L D L^T x = b. Unknowns without a pivot stay 0, all are NaN if a pivot is."""
    x = vec6d(0.0)
    for j in range(6):
        v = b[j]
        for k in range(j):
            v -= a[j * UNKNOWN_COUNT + k] * x[k]
        x[j] = v
    for j in range(6):
        pivot = a[j * UNKNOWN_COUNT + j]
        if pivot > 0.0:
            x[j] = x[j] / pivot
        elif pivot - pivot == 0.0:
            x[j] = 0.0
        else:
            x[j] = pivot
    for step in range(6):
        j = UNKNOWN_COUNT - 1 - step
        v = x[j]
        for k in range(6):
            if k > j:
                v -= a[k * UNKNOWN_COUNT + j] * x[k]
        x[j] = v
    return x


@func
def solve_system(h: triangle, b: vec6d) -> vec6d:
    """Solve H x = b for positive definite H (LDL^T). Unknowns without a pivot stay 0."""
    return solve_factored(factor_system(h), b)


@func
def pose_from_cosines_and_sines(x: vec6d, cosines: vec3d, sines: vec3d) -> mat44d:
    """`euler_motion` from the cosines and sines of its angles."""
    ca = cosines[0]
    sa = sines[0]
    cb = cosines[1]
    sb = sines[1]
    cc = cosines[2]
    sc = sines[2]
    zero = float64(0.0)
    return mat44d(
        cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa, x[3],
        sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa, x[4],
        -sb, cb * sa, cb * ca, x[5],
        zero, zero, zero, 1.0,
    )  # fmt: skip


@func
def euler_motion(x: vec6d) -> mat44d:
    """Pose with rotation Rz(x2) Ry(x1) Rx(x0) and translation x3..x5, as in Open3D."""
    cosines = vec3d(cos(x[0]), cos(x[1]), cos(x[2]))
    sines = vec3d(sin(x[0]), sin(x[1]), sin(x[2]))
    return pose_from_cosines_and_sines(x, cosines, sines)


@func
def rotation_about(rx: float64, ry: float64, rz: float64, rw: float64) -> mat44d:
    """Rotation of an unnormalized quaternion, as a pose."""
    size = rx * rx + ry * ry + rz * rz + rw * rw
    s = 2.0 / size
    one = float64(1.0)
    zero = float64(0.0)
    return mat44d(
        one - s * (ry * ry + rz * rz), s * (rx * ry - rz * rw), s * (rx * rz + ry * rw), zero,
        s * (rx * ry + rz * rw), one - s * (rx * rx + rz * rz), s * (ry * rz - rx * rw), zero,
        s * (rx * rz - ry * rw), s * (ry * rz + rx * rw), one - s * (rx * rx + ry * ry), zero,
        zero, zero, zero, one,
    )  # fmt: skip


@func
def small_motion(x: vec6d) -> mat44d:
    """Pose of a rotation vector x0..x2 (third order) and translation x3..x5, by Cayley's form without sines."""
    half = float64(0.5)
    pose = rotation_about(x[0] * half, x[1] * half, x[2] * half, 1.0)
    for i in range(3):
        pose[i, 3] = x[3 + i]
    return pose


@func
def move(pose: mat44d, p: vec3d) -> vec3d:
    return vec3d(
        pose[0, 0] * p[0] + pose[0, 1] * p[1] + pose[0, 2] * p[2] + pose[0, 3],
        pose[1, 0] * p[0] + pose[1, 1] * p[1] + pose[1, 2] * p[2] + pose[1, 3],
        pose[2, 0] * p[0] + pose[2, 1] * p[1] + pose[2, 2] * p[2] + pose[2, 3],
    )


@func
def rotate(pose: mat44d, v: vec3d) -> vec3d:
    return vec3d(
        pose[0, 0] * v[0] + pose[0, 1] * v[1] + pose[0, 2] * v[2],
        pose[1, 0] * v[0] + pose[1, 1] * v[1] + pose[1, 2] * v[2],
        pose[2, 0] * v[0] + pose[2, 1] * v[1] + pose[2, 2] * v[2],
    )


@func
def sums_of_pair(p: vec3d, q: vec3d, w: float64) -> pair_sums:
    """Sums of one pair for `fit_pose`; p and q relative to a near point."""
    return pair_sums(
        w, w * p[0], w * p[1], w * p[2], w * q[0], w * q[1], w * q[2],
        w * p[0] * q[0], w * p[0] * q[1], w * p[0] * q[2],
        w * p[1] * q[0], w * p[1] * q[1], w * p[1] * q[2],
        w * p[2] * q[0], w * p[2] * q[1], w * p[2] * q[2],
        w * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), w * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]),
    )  # fmt: skip


@func
def fit_pose(sums: pair_sums, with_scaling: int) -> mat44d:
    """Weighted least-squares motion from p to q (Horn 1987; scale: Umeyama 1991). Free rotations are minimal."""
    w = sums[0]
    pose = mat44d(
        1.0, 0.0, 0.0, 0.0,
        0.0, 1.0, 0.0, 0.0,
        0.0, 0.0, 1.0, 0.0,
        0.0, 0.0, 0.0, 1.0,
    )  # fmt: skip
    if w > 0.0:
        px = sums[1] / w
        py = sums[2] / w
        pz = sums[3] / w
        qx = sums[4] / w
        qy = sums[5] / w
        qz = sums[6] / w
        xx = sums[7] - w * px * qx
        xy = sums[8] - w * px * qy
        xz = sums[9] - w * px * qz
        yx = sums[10] - w * py * qx
        yy = sums[11] - w * py * qy
        yz = sums[12] - w * py * qz
        zx = sums[13] - w * pz * qx
        zy = sums[14] - w * pz * qy
        zz = sums[15] - w * pz * qz
        spread = sums[16] - w * (px * px + py * py + pz * pz)
        spread_q = sums[17] - w * (qx * qx + qy * qy + qz * qz)
        # a small weight on no rotation decides between equal fits
        still = xx + yy + zz + 1.0e-12 * max(spread + spread_q, 0.0)
        a = four_square(
            still, yz - zy, zx - xz, xy - yx,
            yz - zy, xx - yy - zz, xy + yx, zx + xz,
            zx - xz, xy + yx, yy - xx - zz, yz + zy,
            xy - yx, zx + xz, yz + zy, zz - xx - yy,
        )  # fmt: skip
        best = largest_of_four(diagonalize_four(a))
        pose = rotation_about(best[1], best[2], best[3], best[0])
        scale = float64(1.0)
        if with_scaling == 1 and spread > 0.0:
            aligned = pose[0, 0] * xx + pose[0, 1] * yx + pose[0, 2] * zx
            aligned += pose[1, 0] * xy + pose[1, 1] * yy + pose[1, 2] * zy
            aligned += pose[2, 0] * xz + pose[2, 1] * yz + pose[2, 2] * zz
            if aligned > 0.0:
                scale = aligned / spread
        for i in range(3):
            for j in range(3):
                pose[i, j] = pose[i, j] * scale
            pose[i, 3] = -(pose[i, 0] * px + pose[i, 1] * py + pose[i, 2] * pz)
        pose[0, 3] = pose[0, 3] + qx
        pose[1, 3] = pose[1, 3] + qy
        pose[2, 3] = pose[2, 3] + qz
    return pose
