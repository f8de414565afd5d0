"""Small dense solves of rigid registration in float64: normal equations of six unknowns, and the best fit of pairs.

One thread solves one system, so that a loop never goes back to the host: about 400 operations for LDL^T, 15,000 for
the eigenvectors of a 6x6 matrix (cyclic Jacobi, Golub and Van Loan, section 8.5). The best rotation of weighted pairs
is the eigenvector of a symmetric 4x4 matrix (Horn 1987), which is right for flat and for straight sets of points too.

Unknowns are (rotation about x, y, z, then translation). The upper triangle of a 6x6 matrix is kept row by row.
"""

from ..lang import cos, float64, func, mat44d, sin, sqrt, vec3d, vector

UNKNOWNS = 6
TRIANGLE = 21
SWEEPS = 10  # of Jacobi rotations: 6x6 matrices are diagonal to rounding after 6 to 8
vec6d = vector(6, float64)
triangle = vector(21, float64)
square = vector(36, float64)  # an n x n matrix, n up to 6, row by row in the first n * n
eigensystem = vector(42, float64)  # eigenvectors as the columns of an n x n matrix, then from 36 on the eigenvalues
pair_sums = vector(18, float64)  # of weighted pairs (p, q): w, wp, wq, wp q^T, w|p|^2, w|q|^2


@func
def place_of(row: int, column: int) -> int:
    """Where entry (row, column), row <= column, of a 6x6 matrix stands in its upper triangle."""
    return row * UNKNOWNS - (row * (row - 1)) // 2 + column - row


@func
def full_matrix(h: triangle) -> square:
    """The 6x6 matrix of an upper triangle."""
    a = square(float64(0.0))
    n = int(UNKNOWNS)  # loops over a variable are not unrolled: a hundredth of the code
    for i in range(n):
        for j in range(i, n):
            a[i * UNKNOWNS + j] = h[place_of(i, j)]
            a[j * UNKNOWNS + i] = h[place_of(i, j)]
    return a


@func
def diagonalize(matrix: square, n: int) -> eigensystem:
    """Eigenvectors and eigenvalues of a symmetric n x n matrix, n up to 6, in no particular order."""
    a = matrix + square(float64(0.0))
    system = eigensystem(float64(0.0))
    for i in range(n):
        system[i * n + i] = float64(1.0)
    sweeps = int(SWEEPS)
    for _ in range(sweeps):
        for p in range(n - 1):
            for q in range(p + 1, n):
                apq = a[p * n + q]
                app = a[p * n + p]
                aqq = a[q * n + q]
                if abs(apq) > float64(1.0e-300) and abs(apq) > float64(1.0e-18) * sqrt(abs(app * aqq)):
                    theta = (aqq - app) / (float64(2.0) * apq)
                    t = float64(1.0) / (abs(theta) + sqrt(theta * theta + float64(1.0)))
                    if theta < float64(0.0):
                        t = -t
                    c = float64(1.0) / sqrt(t * t + float64(1.0))
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
def solve_system(h: triangle, b: vec6d) -> vec6d:
    """The x with H x = b for a symmetric positive definite H (LDL^T); unknowns without a pivot stay 0."""
    a = full_matrix(h)
    x = vec6d(float64(0.0))
    n = int(UNKNOWNS)
    largest = float64(0.0)
    for j in range(n):
        largest = max(largest, abs(a[j * UNKNOWNS + j]))
    for j in range(n):  # a[j, j] becomes D, a[i, j] below it L
        d = a[j * UNKNOWNS + j]
        for k in range(j):
            d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]
        inverse = float64(0.0)
        if d > float64(1.0e-15) * largest:
            inverse = float64(1.0) / d
        else:
            d = float64(0.0)
        a[j * UNKNOWNS + j] = d
        for i in range(j + 1, n):
            v = a[i * UNKNOWNS + j]
            for k in range(j):
                v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]
            a[i * UNKNOWNS + j] = v * inverse
    for j in range(n):
        v = b[j]
        for k in range(j):
            v -= a[j * UNKNOWNS + k] * x[k]
        x[j] = v
    for j in range(n):
        if a[j * UNKNOWNS + j] > float64(0.0):
            x[j] = x[j] / a[j * UNKNOWNS + j]
        else:
            x[j] = float64(0.0)
    for step in range(n):
        j = UNKNOWNS - 1 - step
        v = x[j]
        for k in range(j + 1, n):
            v -= a[k * UNKNOWNS + j] * x[k]
        x[j] = v
    return x


@func
def euler_motion(x: vec6d) -> mat44d:
    """The pose with rotation Rz(x2) Ry(x1) Rx(x0) and translation x3..x5, Open3D's update."""
    ca = cos(x[0])
    sa = sin(x[0])
    cb = cos(x[1])
    sb = sin(x[1])
    cc = cos(x[2])
    sc = sin(x[2])
    zero = float64(0.0)
    return mat44d(
        cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa, x[3],
        sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa, x[4],
        -sb, cb * sa, cb * ca, x[5],
        zero, zero, zero, float64(1.0),
    )  # fmt: skip


@func
def rotation_about(rx: float64, ry: float64, rz: float64, rw: float64) -> mat44d:
    """The rotation of a quaternion of any length above zero, as a pose."""
    size = rx * rx + ry * ry + rz * rz + rw * rw
    s = float64(2.0) / size
    one = float64(1.0)
    zero = float64(0.0)
    return mat44d(
        one - s * (ry * ry + rz * rz), s * (rx * ry - rz * rw), s * (rx * rz + ry * rw), zero,
        s * (rx * ry + rz * rw), one - s * (rx * rx + rz * rz), s * (ry * rz - rx * rw), zero,
        s * (rx * rz - ry * rw), s * (ry * rz + rx * rw), one - s * (rx * rx + ry * ry), zero,
        zero, zero, zero, one,
    )  # fmt: skip


@func
def move(pose: mat44d, p: vec3d) -> vec3d:
    """The point p under a pose."""
    return vec3d(
        pose[0, 0] * p[0] + pose[0, 1] * p[1] + pose[0, 2] * p[2] + pose[0, 3],
        pose[1, 0] * p[0] + pose[1, 1] * p[1] + pose[1, 2] * p[2] + pose[1, 3],
        pose[2, 0] * p[0] + pose[2, 1] * p[1] + pose[2, 2] * p[2] + pose[2, 3],
    )


@func
def turn(pose: mat44d, v: vec3d) -> vec3d:
    """The direction v under a pose's 3x3 part."""
    return vec3d(
        pose[0, 0] * v[0] + pose[0, 1] * v[1] + pose[0, 2] * v[2],
        pose[1, 0] * v[0] + pose[1, 1] * v[1] + pose[1, 2] * v[2],
        pose[2, 0] * v[0] + pose[2, 1] * v[1] + pose[2, 2] * v[2],
    )


@func
def sums_of_pair(p: vec3d, q: vec3d, w: float64) -> pair_sums:
    """One pair's part of the sums that `fit_pose` takes; p and q should be taken about a place near both."""
    return pair_sums(
        w, w * p[0], w * p[1], w * p[2], w * q[0], w * q[1], w * q[2],
        w * p[0] * q[0], w * p[0] * q[1], w * p[0] * q[2],
        w * p[1] * q[0], w * p[1] * q[1], w * p[1] * q[2],
        w * p[2] * q[0], w * p[2] * q[1], w * p[2] * q[2],
        w * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), w * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]),
    )  # fmt: skip


@func
def fit_pose(sums: pair_sums, with_scaling: int) -> mat44d:
    """The motion that takes the p nearest to the q in weighted least squares (Horn 1987); with scale as Umeyama 1991.

    Where the pairs leave a rotation open (all on one line or at one place) the smallest is taken; the identity where
    there is no weight.
    """
    w = sums[0]
    pose = mat44d(
        float64(1.0), float64(0.0), float64(0.0), float64(0.0),
        float64(0.0), float64(1.0), float64(0.0), float64(0.0),
        float64(0.0), float64(0.0), float64(1.0), float64(0.0),
        float64(0.0), float64(0.0), float64(0.0), float64(1.0),
    )  # fmt: skip
    if w > float64(0.0):
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
        a = square(float64(0.0))
        # a little weight on no rotation decides between rotations that fit alike
        a[0] = xx + yy + zz + float64(1.0e-12) * max(spread + spread_q, float64(0.0))
        a[1] = yz - zy
        a[2] = zx - xz
        a[3] = xy - yx
        a[5] = xx - yy - zz
        a[6] = xy + yx
        a[7] = zx + xz
        a[10] = yy - xx - zz
        a[11] = yz + zy
        a[15] = zz - xx - yy
        for i in range(4):
            for j in range(i):
                a[i * 4 + j] = a[j * 4 + i]
        system = diagonalize(a, 4)
        best = int(0)
        for k in range(1, 4):
            if system[36 + k] > system[36 + best]:
                best = k
        pose = rotation_about(system[4 + best], system[8 + best], system[12 + best], system[best])
        scale = float64(1.0)
        if with_scaling == 1 and spread > float64(0.0):
            aligned = pose[0, 0] * xx + pose[0, 1] * yx + pose[0, 2] * zx
            aligned += pose[1, 0] * xy + pose[1, 1] * yy + pose[1, 2] * zy
            aligned += pose[2, 0] * xz + pose[2, 1] * yz + pose[2, 2] * zz
            if aligned > float64(0.0):
                scale = aligned / spread
        for i in range(3):
            for j in range(3):
                pose[i, j] = pose[i, j] * scale
            pose[i, 3] = -(pose[i, 0] * px + pose[i, 1] * py + pose[i, 2] * pz)
        pose[0, 3] = pose[0, 3] + qx
        pose[1, 3] = pose[1, 3] + qy
        pose[2, 3] = pose[2, 3] + qz
    return pose
