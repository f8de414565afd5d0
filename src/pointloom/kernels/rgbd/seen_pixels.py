"""Projection of points to a frame, with rows of the surface residual (nearest pixel, Blais and Levine 1995) and the
brightness residual (bilinear). Float32. Unknowns are rotation and translation on the frame's side.
"""

from ..lang import array, cross, float32, floor, func, vec3, vec4, vector
from .pyramid import FrameLevels

row = vector(6, float32)
NOISE_FLOOR, NOISE_SLOPE = 0.0012, 0.0019  # depth deviation [m] and its growth [1/m] (Nguyen et al. 2012, Kinect)
NOISE_NEAR = 0.4  # [m] start of the growth
MIN_DEPTH = 1.0e-3  # [m] minimum depth
SLOPE_MARGIN = 0.01  # of the depth, in addition to noise: slope within a pixel


@func
def depth_noise(z: float) -> float:
    """Relative depth noise deviation [m]."""
    beyond = max(z - NOISE_NEAR, 0.0)
    return NOISE_FLOOR + NOISE_SLOPE * beyond * beyond


@func
def axis(w: vec4) -> vec3:
    return vec3(w[0], w[1], w[2])


@func
def moved_point(u: float, v: float, z: float, warps: array(dtype=vec4)) -> vec3:
    a = warps[0]
    b = warps[1]
    c = warps[2]
    return (axis(a) * u + axis(b) * v + axis(c)) * z + vec3(a[3], b[3], c[3])


@func
def seen_at(p: vec3, level: int, frame: FrameLevels) -> tuple[float, float, int]:
    """Image position [px] of a frame point [m], and the nearest pixel, or -1."""
    u = 0.0
    v = 0.0
    at = -1
    if p[2] > MIN_DEPTH:
        lens = frame.lenses[level]
        size = frame.layout[level]
        u = lens[0] * p[0] / p[2] + lens[2]
        v = lens[1] * p[1] / p[2] + lens[3]
        if u >= 0.0 and v >= 0.0 and u < float(size[0] - 1) and v < float(size[1] - 1):
            at = size[2] + int(floor(v + 0.5)) * size[0] + int(floor(u + 0.5))
    return u, v, at


@func
def seen_brightness(u: float, v: float, level: int, frame: FrameLevels) -> vec4:
    """Bilinear brightness, its gradient [1 / px], and 1. Zero if a pixel has none."""
    size = frame.layout[level]
    left = int(floor(u))
    top = int(floor(v))
    at = size[2] + top * size[0] + left
    a = frame.brightness[at]
    b = frame.brightness[at + 1]
    c = frame.brightness[at + size[0]]
    d = frame.brightness[at + size[0] + 1]
    s = u - float(left)
    t = v - float(top)
    sample = vec4(0.0, 0.0, 0.0, 0.0)
    if min(min(a, b), min(c, d)) >= 0.0:
        upper = a + (b - a) * s
        lower = c + (d - c) * s
        sample = vec4(upper + (lower - upper) * t, (b - a) * (1.0 - t) + (d - c) * t, lower - upper, 1.0)
    return sample


@func
def surface_row(p: vec3, plane: vec4) -> row:
    n = axis(plane)
    moment = cross(p, n)
    return row(moment[0], moment[1], moment[2], n[0], n[1], n[2])


@func
def brightness_row(p: vec3, sample: vec4, level: int, frame: FrameLevels) -> row:
    lens = frame.lenses[level]
    a = sample[1] * lens[0] / p[2]
    b = sample[2] * lens[1] / p[2]
    c = -(a * p[0] + b * p[1]) / p[2]
    return row(p[1] * c - p[2] * b, p[2] * a - p[0] * c, p[0] * b - p[1] * a, a, b, c)
