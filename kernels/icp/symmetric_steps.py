"""What symmetric ICP does before and after its system is solved (Rusinkiewicz 2019, eqs. 10 and 11).

Its rows are summed about the origin; they are brought about the means of the paired points, and the solution becomes a
motion of which half turns the source and half turns back the target. All in float64, in one thread.
"""

from ..algebra.rigid_solve import UNKNOWNS, full_matrix, move, place_of, rotation_about, square, vec6d
from ..lang import cross, float64, func, mat44d, sqrt, vec3d
from .job_states import free_directions
from .rows import mean_source, mean_target, row_sums, row_system


@func
def center_symmetric(sums: row_sums) -> row_sums:
    """The symmetric system about the means of its points: C H0 C^T and C (g0 - H0 (0, gap)), C = (I, -[s]x; 0, I)."""
    p = mean_source(sums)
    q = mean_target(sums)
    s = p + q
    gap = p - q
    h, _ = row_system(sums)
    a = full_matrix(h)
    g = vec6d(0.0)
    for i in range(6):
        g[i] = sums[21 + i] - a[i * UNKNOWNS + 3] * gap[0] - a[i * UNKNOWNS + 4] * gap[1] - a[i * UNKNOWNS + 5] * gap[2]
    c = square(0.0)
    for j in range(6):  # C A: rotation rows lose s x (translation rows)
        v = vec3d(a[3 * UNKNOWNS + j], a[4 * UNKNOWNS + j], a[5 * UNKNOWNS + j])
        w = cross(s, v)
        for i in range(3):
            c[i * UNKNOWNS + j] = a[i * UNKNOWNS + j] - w[i]
            c[(3 + i) * UNKNOWNS + j] = v[i]
    out = square(0.0)
    for i in range(6):  # (C A) C^T
        v = vec3d(c[i * UNKNOWNS + 3], c[i * UNKNOWNS + 4], c[i * UNKNOWNS + 5])
        w = cross(s, v)
        for j in range(3):
            out[i * UNKNOWNS + j] = c[i * UNKNOWNS + j] - w[j]
            out[i * UNKNOWNS + 3 + j] = v[j]
    centered = sums
    for i in range(6):
        for j in range(6):
            if j >= i:
                centered[place_of(i, j)] = out[i * UNKNOWNS + j]
    v = vec3d(g[3], g[4], g[5])
    w = cross(s, v)
    for i in range(3):
        centered[21 + i] = g[i] - w[i]
        centered[24 + i] = g[3 + i]
    return centered


@func
def hold_free(x: vec6d, count: int, free: free_directions, gap: vec3d, size: float64) -> vec6d:
    """The symmetric step with what takes back, along free directions, that it brings the means together."""
    held = x
    for k in range(6):
        if k < count:
            at = k * UNKNOWNS
            along = free[at + 3] * gap[0] + free[at + 4] * gap[1] + free[at + 5] * gap[2]
            for i in range(3):
                held[i] = held[i] - along * free[at + i] / size
                held[3 + i] = held[3 + i] - along * free[at + 3 + i]
    return held


@func
def symmetric_motion(x: vec6d, p: vec3d, q: vec3d) -> mat44d:
    """The motion of a symmetric step: half of it turns the source, half turns back the target (eq. 11)."""
    size = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
    # a rotation by 2 theta about g: the quaternion (g / |g| sin theta, cos theta), along (g, 1) as tan theta = |g|
    whole = rotation_about(x[0], x[1], x[2], 1.0)
    # a rotation by theta: the quaternion of half the angle, along (g / |g| (1 - cos theta) / sin theta, 1)
    share = float64(0.5)
    if size > 1.0e-9:
        root = sqrt(1.0 + size * size)
        share = (root - 1.0) / (size * size)
    half = rotation_about(share * x[0], share * x[1], share * x[2], 1.0)
    cosine = 1.0 / sqrt(1.0 + size * size)
    shift = move(half, vec3d(x[3] * cosine, x[4] * cosine, x[5] * cosine))
    turned = move(whole, p)
    for i in range(3):
        whole[i, 3] = q[i] + shift[i] - turned[i]
    return whole
