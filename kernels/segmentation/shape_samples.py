"""Shapes through random samples of oriented points that lie near each other, one thread a sample.

Schnabel, Wahl and Klein, "Efficient RANSAC for point-cloud shape detection", CGF 2007, section 4.1: a plane through
three points, a sphere and a cylinder through two, a cone through three, a torus through four (its axis meets the four
lines along the normals; Marshall, Lukacs and Martin, PAMI 2001). A shape that one of its own points contradicts is
none. Points near each other are those of an aligned run of the cloud's order along a Hilbert curve; the length of the
run is drawn too, the whole cloud or a power of two less (section 4.3, where cells of an octree do this). 68 B a sample.
"""

from ..arrays.random import random_below, random_bits
from ..lang import array, cross, dot, float64, func, int32, kernel, sqrt, tid, vec3d
from .shape_models import CONE, CYLINDER, NONE, PLANE, SPHERE, TORUS, ShapePoints, eight, measure, normal_at, place_at

LEAST_SINE = 0.05  # between normals: below it their lines meet where noise wants
LEAST_WINDOW = 16  # points of the shortest run
NARROW, WIDE = (
    0.9995,
    0.06,
)  # cosines of a cone's half angle: 1.8 and 86.6 degrees, beyond which it is a line or a plane


@func
def no_shape() -> eight:
    """A shape without a size, which `draw_shapes_kernel` drops."""
    return eight(0.0, 0.0, 0.0, 0.0, 0.0, 1.0, -1.0, -1.0)


@func
def shape_of(p: vec3d, a: vec3d, r: float64, s: float64) -> eight:
    """Its eight numbers."""
    return eight(p[0], p[1], p[2], a[0], a[1], a[2], r, s)


@func
def plane_through(p: vec3d, q: vec3d, o: vec3d) -> eight:
    """The plane through three points."""
    u = q - p
    v = o - p
    n = cross(u, v)
    size = sqrt(dot(n, n))
    shape = no_shape()
    if size > float64(LEAST_SINE) * sqrt(dot(u, u) * dot(v, v)) and size > 0.0:
        shape = shape_of(p, n / size, 1.0, 1.0)
    return shape


@func
def round_through(p: vec3d, m: vec3d, q: vec3d, n: vec3d, kind: int) -> eight:
    """The sphere or the cylinder whose normals at two points are theirs."""
    a = cross(m, n)
    size = sqrt(dot(a, a))
    shape = no_shape()
    if size > float64(LEAST_SINE):
        w = p - q
        b = dot(m, n)
        t = (b * dot(n, w) - dot(m, w)) / (size * size)
        u = (dot(n, w) - b * dot(m, w)) / (size * size)
        middle = (p + m * t + q + n * u) * 0.5
        radius = (abs(t) + abs(u)) * 0.5
        if kind == SPHERE:
            v = p - middle
            o = q - middle
            radius = (sqrt(dot(v, v)) + sqrt(dot(o, o))) * 0.5
        shape = shape_of(middle, a / size, radius, 1.0)
    return shape


@func
def unit(v: vec3d) -> vec3d:
    """A vector of length one, or zero."""
    size = sqrt(dot(v, v))
    u = vec3d(0.0, 0.0, 0.0)
    if size > 0.0:
        u = v / size
    return u


@func
def cone_through(p: vec3d, l: vec3d, q: vec3d, m: vec3d, o: vec3d, n: vec3d) -> eight:  # noqa: E741  the first normal
    """The cone whose apex lies on the tangent planes of three points."""
    volume = dot(l, cross(m, n))
    shape = no_shape()
    if abs(volume) > 0.001:
        apex = p + (cross(n, l) * dot(m, q - p) + cross(l, m) * dot(n, o - p)) / volume
        x = unit(p - apex)
        y = unit(q - apex)
        z = unit(o - apex)
        a = unit(cross(y - x, z - x))
        if dot(a, x) < 0.0:
            a = -a
        c = (dot(a, x) + dot(a, y) + dot(a, z)) / 3.0
        if c < float64(NARROW) and c > float64(WIDE):
            shape = shape_of(apex, a, c, sqrt(1.0 - c * c))
    return shape


@func
def meeting_terms(d: vec3d, m: vec3d, n: vec3d, e: vec3d, o: vec3d) -> eight:
    """The terms 1, t, u, tu of what is zero where the line from t m to d + u n meets that from e along o."""
    zero = float64(0.0)
    return eight(
        dot(cross(d, e), o), -dot(cross(d, m) + cross(m, e), o), dot(cross(n, e), o), dot(cross(m, n), o),
        zero, zero, zero, zero,
    )  # fmt: skip


@func
def ring_about(c: vec3d, a: vec3d, xs: eight, ys: eight) -> eight:
    """The torus about an axis whose tube's middle is nearest to the lines along four normals, turned into one plane.

    Args:
        xs, ys: Of each point its place and its normal: across the axis, along it, relative to c.
    """
    aa = float64(0.0)
    ab = float64(0.0)
    bb = float64(0.0)
    fa = float64(0.0)
    fb = float64(0.0)
    for k in range(4):
        tx = -ys[2 * k + 1]
        ty = xs[2 * k + 1]
        rest = tx * xs[2 * k] + ty * ys[2 * k]
        aa += tx * tx
        ab += tx * ty
        bb += ty * ty
        fa += tx * rest
        fb += ty * rest
    det = aa * bb - ab * ab
    shape = no_shape()
    if det > 0.001:
        r = (fa * bb - fb * ab) / det
        h = (aa * fb - ab * fa) / det
        s = float64(0.0)
        for k in range(4):
            dx = xs[2 * k] - r
            dy = ys[2 * k] - h
            s += 0.25 * sqrt(dx * dx + dy * dy)
        if r > s:
            shape = shape_of(c + a * h, a, r, s)
    return shape


@func
def worst_of(shape: eight, p: vec3d, q: vec3d, o: vec3d, z: vec3d) -> float64:
    """The largest distance of four points from a torus."""
    c = vec3d(shape[0], shape[1], shape[2])
    a = vec3d(shape[3], shape[4], shape[5])
    far = abs(measure(TORUS, c, a, shape[6], shape[7], p)[0])
    far = max(far, abs(measure(TORUS, c, a, shape[6], shape[7], q)[0]))
    far = max(far, abs(measure(TORUS, c, a, shape[6], shape[7], o)[0]))
    return max(far, abs(measure(TORUS, c, a, shape[6], shape[7], z)[0]))


@func
def torus_about(
    c: vec3d, a: vec3d, p: vec3d, k: vec3d, q: vec3d, j: vec3d, o: vec3d, m: vec3d, z: vec3d, n: vec3d
) -> eight:
    """The torus about an axis through c through four points with normals k, j, m, n."""
    hp = dot(p - c, a)
    hq = dot(q - c, a)
    ho = dot(o - c, a)
    hz = dot(z - c, a)
    ep = p - c - a * hp
    eq = q - c - a * hq
    eo = o - c - a * ho
    ez = z - c - a * hz
    xs = eight(
        sqrt(dot(ep, ep)), dot(unit(ep), k), sqrt(dot(eq, eq)), dot(unit(eq), j),
        sqrt(dot(eo, eo)), dot(unit(eo), m), sqrt(dot(ez, ez)), dot(unit(ez), n),
    )  # fmt: skip
    ys = eight(hp, dot(a, k), hq, dot(a, j), ho, dot(a, m), hz, dot(a, n))
    return ring_about(c, a, xs, ys)


@func
def torus_through(p: vec3d, k: vec3d, q: vec3d, j: vec3d, o: vec3d, m: vec3d, z: vec3d, n: vec3d) -> eight:
    """The torus through four points whose axis meets their normals; of the two axes the one that fits better."""
    f = meeting_terms(q - p, k, j, o - p, m)
    g = meeting_terms(q - p, k, j, z - p, n)
    a2 = g[1] * f[3] - f[1] * g[3]
    a1 = g[0] * f[3] + g[1] * f[2] - f[0] * g[3] - f[1] * g[2]
    a0 = g[0] * f[2] - f[0] * g[2]
    inside = a1 * a1 - 4.0 * a2 * a0
    best = no_shape()
    if inside >= 0.0 and abs(a2) > 0.0:
        least = float64(1.0e300)
        turns = int(2)
        for side in range(turns):
            root = sqrt(inside)
            if side == 1:
                root = -root
            t = (root - a1) / (2.0 * a2)
            below = f[2] + f[3] * t
            if abs(below) > 0.0:
                u = -(f[0] + f[1] * t) / below
                c = p + k * t
                a = unit(q + j * u - c)
                if dot(a, a) > 0.5:
                    shape = torus_about(c, a, p, k, q, j, o, m, z, n)
                    if shape[6] > 0.0:
                        worst = worst_of(shape, p, q, o, z)
                        if worst < least:
                            least = worst
                            best = shape * 1.0
    return best


@func
def row_near(rows: int, seed: int, number: int, stream: int, levels: int, anchor: int) -> int:
    """A random place of the run of the anchor whose length the sample drew."""
    level = random_below(random_bits(seed, number, 0), levels)
    width = max(rows >> level, min(rows, LEAST_WINDOW))
    start = min((anchor // width) * width, rows - width)
    return start + random_below(random_bits(seed, number, stream), width)


@func
def contradicts(kind: int, shape: eight, p: vec3d, n: vec3d, threshold: float64, least_cosine: float64) -> int:
    """1 where a point is not of a shape, by its distance or its normal."""
    c = vec3d(shape[0], shape[1], shape[2])
    a = vec3d(shape[3], shape[4], shape[5])
    m = measure(kind, c, a, shape[6], shape[7], p)
    wrong = 0
    if abs(m[0]) > threshold or abs(m[1] * n[0] + m[2] * n[1] + m[3] * n[2]) < least_cosine:
        wrong = 1
    return wrong


@kernel
def draw_shapes_kernel(
    cloud: ShapePoints,
    kind: int,
    seed: int,
    first: int,
    levels: int,
    threshold: float64,
    least_cosine: float64,
    smallest: float64,
    largest: float64,
    shapes: array(dtype=float64, ndim=2),
    kinds: array(dtype=int32),
):
    """The shape of each sample, or none; sample `first + i` is the same in whatever batch it is drawn."""
    i = tid()
    number = first + i
    at = random_below(random_bits(seed, number, 1), cloud.count)
    bt = row_near(cloud.count, seed, number, 2, levels, at)
    ct = row_near(cloud.count, seed, number, 3, levels, at)
    dt = row_near(cloud.count, seed, number, 4, levels, at)
    p = place_at(cloud, at)
    q = place_at(cloud, bt)
    o = place_at(cloud, ct)
    z = place_at(cloud, dt)
    k = normal_at(cloud, at)
    m = normal_at(cloud, bt)
    n = normal_at(cloud, ct)
    e = normal_at(cloud, dt)
    shape = no_shape()
    wrong = 0
    if kind == PLANE:
        shape = plane_through(p, q, o)
    if kind == SPHERE or kind == CYLINDER:
        shape = round_through(p, k, q, m, kind)
    if kind == CONE:
        shape = cone_through(p, k, q, m, o, n)
    if kind == TORUS:
        shape = torus_through(p, k, q, m, o, n, z, e)
        wrong = contradicts(kind, shape, z, e, threshold, least_cosine)
    if kind == PLANE or kind == CONE or kind == TORUS:
        wrong += contradicts(kind, shape, o, n, threshold, least_cosine)
    wrong += contradicts(kind, shape, p, k, threshold, least_cosine)
    wrong += contradicts(kind, shape, q, m, threshold, least_cosine)
    size = shape[6]
    if kind == TORUS:
        size = shape[7]
    if shape[6] <= 0.0 or wrong > 0:
        kinds[i] = NONE
    elif kind == SPHERE or kind == CYLINDER or kind == TORUS:
        kinds[i] = kind if size >= smallest and shape[6] <= largest else NONE
    else:
        kinds[i] = kind
    for entry in range(8):
        shapes[i, entry] = shape[entry]
