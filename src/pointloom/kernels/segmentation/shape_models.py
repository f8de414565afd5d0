"""Distance and surface normal of planes, spheres, cylinders, cones and tori, in float64.

A shape is a kind and eight numbers: position p, unit direction a, sizes r and s. Plane through p with normal a; sphere
of radius r; cylinder of radius r around p, a; cone from apex p along a, r and s the cosine and sine of its half angle;
torus around p with axis a, ring radius r and tube radius s.
"""

from ..lang import array, dot, float32, float64, func, int32, kernel, sqrt, struct, tid, vec3, vec3d, vec4d, vector

PLANE, SPHERE, CYLINDER, CONE, TORUS = range(5)
NO_SHAPE = -1  # kind of a sample that defines no shape
SHAPE_NUMBERS = 8
eight = vector(8, float64)


@struct
class ShapePoints:
    """Points relative to a position [m] and unit normals, one array per axis."""

    count: int
    xs: array(dtype=float32)
    ys: array(dtype=float32)
    zs: array(dtype=float32)
    us: array(dtype=float32)
    vs: array(dtype=float32)
    ws: array(dtype=float32)


@kernel
def split_points_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3,
    step: int,
    first: int,
    out: ShapePoints,
):
    i = tid()
    row = rows[first + i * step]
    p = points[row] - center
    n = normals[row]
    size = sqrt(dot(n, n))
    if size > 0.0:
        n = n / size
    out.xs[i] = p[0]
    out.ys[i] = p[1]
    out.zs[i] = p[2]
    out.us[i] = n[0]
    out.vs[i] = n[1]
    out.ws[i] = n[2]


@func
def position_at(cloud: ShapePoints, i: int) -> vec3d:
    return vec3d(float64(cloud.xs[i]), float64(cloud.ys[i]), float64(cloud.zs[i]))


@func
def normal_at(cloud: ShapePoints, i: int) -> vec3d:
    return vec3d(float64(cloud.us[i]), float64(cloud.vs[i]), float64(cloud.ws[i]))


@func
def measure(kind: int, p: vec3d, a: vec3d, r: float64, s: float64, x: vec3d) -> vec4d:
    """Signed distance of x from a shape, and the unit normal at the nearest surface point."""
    y = x - p
    h = dot(y, a)
    across = y - a * h
    q = sqrt(dot(across, across))
    e = vec3d(0.0, 0.0, 0.0)
    if q > 0.0:
        e = across / q
    far = sqrt(dot(y, y))
    d = h * 1.0
    g = a * 1.0
    if kind == SPHERE:
        d = far - r
        g = vec3d(0.0, 0.0, 0.0)
        if far > 0.0:
            g = y / far
    if kind == CYLINDER:
        d = q - r
        g = e * 1.0
    if kind == CONE:
        d = q * r - h * s
        g = e * r - a * s
        if q * s + h * r < 0.0:  # behind the apex, which is nearest
            d = far * 1.0
    if kind == TORUS:
        m = q - r
        rho = sqrt(m * m + h * h)
        d = rho - s
        g = vec3d(0.0, 0.0, 0.0)
        if rho > 0.0:
            g = (e * m + a * h) / rho
    return vec4d(d, g[0], g[1], g[2])
