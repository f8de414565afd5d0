"""Planes through random samples of distinct points (Fischler and Bolles, CACM 1981), one thread per sample.

Planes (a, b, c, d) with a unit normal are computed in float64 relative to the center; collinear samples give a plane
without inliers.
"""

from ..algebra.eigen import largest_entry, smallest_eigenvector, sorted_eigenvalues
from ..algebra.transform import widen
from ..arrays.random import random_below, random_bits
from ..lang import (
    INFINITY,
    array,
    cross,
    dot,
    float64,
    func,
    int32,
    kernel,
    mat33d,
    sqrt,
    tid,
    vec3,
    vec3d,
    vec4d,
    vector,
)

MIN_SAMPLE_SIZE = 3  # points that define a plane
MIN_EDGE_SINE = 1.0e-6  # sine of the angle between two edges below which rounding dominates
MIN_VARIANCE_RATIO = MIN_EDGE_SINE * MIN_EDGE_SINE  # the same for the ratio of two variances
six_sums = vector(6, float64)


@func
def no_plane() -> vec4d:
    return vec4d(0.0, 0.0, 0.0, float64(INFINITY))


@func
def plane_at(normal: vec3d, p: vec3d) -> vec4d:
    return vec4d(normal[0], normal[1], normal[2], -dot(normal, p))


@func
def triangle_plane(p: vec3d, q: vec3d, r: vec3d) -> vec4d:
    u = q - p
    v = r - p
    normal = cross(u, v)
    size = sqrt(dot(normal, normal))
    plane = no_plane()
    if size > float64(MIN_EDGE_SINE) * sqrt(dot(u, u) * dot(v, v)):
        plane = plane_at(normal / size, p)
    return plane


@func
def fitted_plane(mean: vec3d, covariance: mat33d) -> vec4d:
    plane = no_plane()
    size = largest_entry(covariance)
    if size > 0.0:
        values = sorted_eigenvalues(covariance * (1.0 / size))
        if values[1] > float64(MIN_VARIANCE_RATIO) * values[2]:
            plane = plane_at(smallest_eigenvector(covariance), mean)
    return plane


@func
def sampled_point(points: array(dtype=vec3), row: int, center: vec3d) -> vec3d:
    return widen(points[row]) - center


@func
def products(p: vec3d) -> six_sums:
    return six_sums(p[0] * p[0], p[0] * p[1], p[0] * p[2], p[1] * p[1], p[1] * p[2], p[2] * p[2])


@kernel
def draw_planes_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    seed: int,
    first: int,
    sample_size: int,
    samples: array(dtype=int32),
    planes: array(dtype=vec4d),
):
    """Plane of each sample, independent of the batch. Distinct points by Floyd's algorithm (Bentley and Floyd, "A
    sample of brilliance", CACM 1987): a repetition becomes the last of the first count - sample_size + j + 1."""
    i = tid()
    base = i * sample_size
    for j in range(sample_size):
        last = rows.shape[0] - sample_size + j
        drawn = random_below(random_bits(seed, first + i, j), last + 1)
        for earlier in range(base, base + j):
            if samples[earlier] == drawn:
                drawn = last
        samples[base + j] = drawn
    plane = no_plane()
    if sample_size == MIN_SAMPLE_SIZE:
        p = sampled_point(points, rows[samples[base]], center)
        q = sampled_point(points, rows[samples[base + 1]], center)
        r = sampled_point(points, rows[samples[base + 2]], center)
        plane = triangle_plane(p, q, r)
    else:
        scale = 1.0 / float64(sample_size)
        mean = vec3d(0.0, 0.0, 0.0)
        for j in range(base, base + sample_size):
            mean += sampled_point(points, rows[samples[j]], center)
        mean = mean * scale
        s = six_sums(0.0)
        for j in range(base, base + sample_size):
            s += products(sampled_point(points, rows[samples[j]], center) - mean)
        plane = fitted_plane(mean, mat33d(s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5]) * scale)
    planes[i] = plane
