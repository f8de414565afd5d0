"""How many points lie on each of many shapes: within a distance of it, their normals within an angle of its own.

A thread counts for one shape over a run of points, whose coordinates stay in the nearest cache while a batch of shapes
passes. A loop for each kind, 15 to 30 float32 operations a point and shape. Counts are whole numbers, so the order of
the atomics is free. 24 B a point are read.
"""

from ..array_types import Array2, Integers
from ..lang import array, atomic_add, float64, func, int32, kernel, launch, sqrt, tid, vec3
from ..memory import zeros
from .shape_models import CONE, CYLINDER, PLANE, SPHERE, TORUS, ShapePoints

CPU_RUN, CUDA_RUN = 2048, 128  # points a thread


@func
def count_plane(cloud: ShapePoints, first: int, last: int, c: vec3, a: vec3, near: float, cosine: float) -> int:
    """Points of a run on a plane."""
    found = 0
    for j in range(first, last):
        d = a[0] * (cloud.xs[j] - c[0]) + a[1] * (cloud.ys[j] - c[1]) + a[2] * (cloud.zs[j] - c[2])
        if abs(d) < near and abs(a[0] * cloud.us[j] + a[1] * cloud.vs[j] + a[2] * cloud.ws[j]) >= cosine:
            found += 1
    return found


@func
def count_round(
    cloud: ShapePoints, first: int, last: int, c: vec3, a: vec3, r: float, near: float, cosine: float
) -> int:
    """Points of a run on a cylinder, or for a direction of zero on a sphere."""
    found = 0
    for j in range(first, last):
        x = cloud.xs[j] - c[0]
        y = cloud.ys[j] - c[1]
        z = cloud.zs[j] - c[2]
        h = a[0] * x + a[1] * y + a[2] * z
        x = x - h * a[0]
        y = y - h * a[1]
        z = z - h * a[2]
        q = sqrt(x * x + y * y + z * z)
        if abs(q - r) < near and abs(x * cloud.us[j] + y * cloud.vs[j] + z * cloud.ws[j]) >= cosine * q:
            found += 1
    return found


@func
def count_cone(
    cloud: ShapePoints, first: int, last: int, c: vec3, a: vec3, r: float, s: float, near: float, cosine: float
) -> int:
    """Points of a run on a cone."""
    found = 0
    for j in range(first, last):
        x = cloud.xs[j] - c[0]
        y = cloud.ys[j] - c[1]
        z = cloud.zs[j] - c[2]
        h = a[0] * x + a[1] * y + a[2] * z
        x = x - h * a[0]
        y = y - h * a[1]
        z = z - h * a[2]
        q = sqrt(x * x + y * y + z * z)
        n = a[0] * cloud.us[j] + a[1] * cloud.vs[j] + a[2] * cloud.ws[j]
        facing = r * (x * cloud.us[j] + y * cloud.vs[j] + z * cloud.ws[j]) - s * n * q
        if abs(q * r - h * s) < near and q * s + h * r >= 0.0 and abs(facing) >= cosine * q:
            found += 1
    return found


@func
def count_torus(
    cloud: ShapePoints, first: int, last: int, c: vec3, a: vec3, r: float, s: float, near: float, cosine: float
) -> int:
    """Points of a run on a torus."""
    found = 0
    for j in range(first, last):
        x = cloud.xs[j] - c[0]
        y = cloud.ys[j] - c[1]
        z = cloud.zs[j] - c[2]
        h = a[0] * x + a[1] * y + a[2] * z
        x = x - h * a[0]
        y = y - h * a[1]
        z = z - h * a[2]
        q = sqrt(x * x + y * y + z * z)
        m = q - r
        rho = sqrt(m * m + h * h)
        n = a[0] * cloud.us[j] + a[1] * cloud.vs[j] + a[2] * cloud.ws[j]
        facing = m * (x * cloud.us[j] + y * cloud.vs[j] + z * cloud.ws[j]) + h * n * q
        if abs(rho - s) < near and abs(facing) >= cosine * q * rho:
            found += 1
    return found


@kernel
def score_shapes_kernel(
    cloud: ShapePoints,
    run: int,
    shapes: array(dtype=float64, ndim=2),
    kinds: array(dtype=int32),
    near: float,
    cosine: float,
    counts: array(dtype=int32),
):
    """How many points lie on each shape."""
    i = tid()
    k = i % kinds.shape[0]
    first = (i // kinds.shape[0]) * run
    last = min(first + run, cloud.count)
    kind = kinds[k]
    c = vec3(float(shapes[k, 0]), float(shapes[k, 1]), float(shapes[k, 2]))
    a = vec3(float(shapes[k, 3]), float(shapes[k, 4]), float(shapes[k, 5]))
    r = float(shapes[k, 6])
    s = float(shapes[k, 7])
    found = 0
    if kind == PLANE:
        found = count_plane(cloud, first, last, c, a, near, cosine)
    if kind == SPHERE:
        found = count_round(cloud, first, last, c, vec3(0.0, 0.0, 0.0), r, near, cosine)
    if kind == CYLINDER:
        found = count_round(cloud, first, last, c, a, r, near, cosine)
    if kind == CONE:
        found = count_cone(cloud, first, last, c, a, r, s, near, cosine)
    if kind == TORUS:
        found = count_torus(cloud, first, last, c, a, r, s, near, cosine)
    if found > 0:
        atomic_add(counts, k, found)  # a whole sum, the same in any order


def score_shapes(
    cloud: ShapePoints, shapes: Array2[float64], kinds: Integers, threshold: float, least_cosine: float
) -> Integers:
    """The points on each of some shapes."""
    counts = zeros(kinds.size, int32, kinds.device)
    run = CUDA_RUN if kinds.device.is_cuda else CPU_RUN
    arguments = [cloud, run, shapes, kinds, threshold, least_cosine, counts]
    launch(score_shapes_kernel, kinds.size * -(-cloud.count // run), arguments)
    return counts
