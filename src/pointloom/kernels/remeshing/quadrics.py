"""Quadric error metrics: x' A x + 2 b' x + c as ten float64, and their minimum.

Garland and Heckbert, "Surface simplification using quadric error metrics", 1997, section 4. Planes are weighted by
triangle area, as in Open3D. The minimum is regularized instead of testing a determinant, which would depend on units: a
fraction of the trace is added to A, with the edge midpoint as prior.
"""

from ..lang import dot, float64, func, vec3d, vector

quadric = vector(10, float64)  # xx xy xz yy yz zz of A, b, c


@func
def plane_quadric(n: vec3d, p: vec3d, weight: float64) -> quadric:
    d = -dot(n, p)
    w = n * weight
    return quadric(
        w[0] * n[0], w[0] * n[1], w[0] * n[2], w[1] * n[1], w[1] * n[2], w[2] * n[2], w[0] * d, w[1] * d, w[2] * d,
        weight * d * d,
    )  # fmt: skip


@func
def quadric_trace(q: quadric) -> float64:
    return q[0] + q[3] + q[5]


@func
def quadric_slope(q: quadric, x: vec3d) -> vec3d:
    """A x + b: half the gradient."""
    return vec3d(
        q[0] * x[0] + q[1] * x[1] + q[2] * x[2] + q[6],
        q[1] * x[0] + q[3] * x[1] + q[4] * x[2] + q[7],
        q[2] * x[0] + q[4] * x[1] + q[5] * x[2] + q[8],
    )


@func
def quadric_error(q: quadric, x: vec3d) -> float64:
    value = dot(x, quadric_slope(q, x)) + q[6] * x[0] + q[7] * x[1] + q[8] * x[2] + q[9]
    return max(value, 0.0)


@func
def minimum_point(q: quadric, middle: vec3d, fraction: float64) -> vec3d:
    """Regularized minimum near `middle`; `fraction` of the trace is added to A."""
    pull = quadric_trace(q) * fraction
    g = quadric_slope(q, middle)
    xx = q[0] + pull
    yy = q[3] + pull
    zz = q[5] + pull
    # Inverse by cofactors: A is symmetric with a condition number of at most 1 / share.
    c00 = yy * zz - q[4] * q[4]
    c01 = q[2] * q[4] - q[1] * zz
    c02 = q[1] * q[4] - q[2] * yy
    determinant = xx * c00 + q[1] * c01 + q[2] * c02
    x = middle
    if determinant > 0.0:
        c11 = xx * zz - q[2] * q[2]
        c12 = q[1] * q[2] - xx * q[4]
        c22 = xx * yy - q[1] * q[1]
        step = vec3d(
            c00 * g[0] + c01 * g[1] + c02 * g[2],
            c01 * g[0] + c11 * g[1] + c12 * g[2],
            c02 * g[0] + c12 * g[1] + c22 * g[2],
        )
        x = middle - step / determinant
    return x
