"""How firmly two frames hold each other at a pose: the normal equations of what noise does not imitate.

Noise tilts the normals of a plane and gives a blank wall slopes of brightness, and both look like information. At a
coarser level than the alignment's there is sixteen times less of it a level; slopes that a camera's noise reaches are
left out, and brightness counts no finer than a model of constant brightness holds.

One thread a source pixel: reads some 60 B, writes nothing; 22 sums leave through the reduction.
"""

from ..lang import array, dot, float32, float64, func, reduction, tid, vec3, vec4, vector
from .pyramid import FrameLevels
from .seen_pixels import (
    REACH_SHARE,
    axis,
    brightness_row,
    depth_noise,
    moved_point,
    row,
    seen_at,
    seen_brightness,
    surface_row,
)
from .verdict_rows import INLIER_REACH

certainty_sums = vector(22, float64)  # the upper triangle, then the pixels
LEAST_SLOPE = 0.015  # of brightness [1 / px]: three grey values in 8 bits, which noise seldom makes of means of 16 px
EDGE_STEP = 0.03  # share of the depth that a surface may leave its plane by beside an edge's step
ALIKE = 0.1  # share of the brightness that counts by the noise found: its errors are alike from pixel to pixel
SHADE_NOISE = 0.04  # deviation of brightness between frames of real cameras


@func
def squares_of(g: row, j: row, h: row, k: row, count: float) -> certainty_sums:
    """The sums of two weighted rows: g = w j, h = w k."""
    return certainty_sums(
        float64(g[0] * j[0] + h[0] * k[0]), float64(g[0] * j[1] + h[0] * k[1]), float64(g[0] * j[2] + h[0] * k[2]),
        float64(g[0] * j[3] + h[0] * k[3]), float64(g[0] * j[4] + h[0] * k[4]), float64(g[0] * j[5] + h[0] * k[5]),
        float64(g[1] * j[1] + h[1] * k[1]), float64(g[1] * j[2] + h[1] * k[2]), float64(g[1] * j[3] + h[1] * k[3]),
        float64(g[1] * j[4] + h[1] * k[4]), float64(g[1] * j[5] + h[1] * k[5]), float64(g[2] * j[2] + h[2] * k[2]),
        float64(g[2] * j[3] + h[2] * k[3]), float64(g[2] * j[4] + h[2] * k[4]), float64(g[2] * j[5] + h[2] * k[5]),
        float64(g[3] * j[3] + h[3] * k[3]), float64(g[3] * j[4] + h[3] * k[4]), float64(g[3] * j[5] + h[3] * k[5]),
        float64(g[4] * j[4] + h[4] * k[4]), float64(g[4] * j[5] + h[4] * k[5]), float64(g[5] * j[5] + h[5] * k[5]),
        float64(count),
    )  # fmt: skip


@func
def leaves_plane(at: int, u: int, v: int, plane: vec4, lens: vec4, frame: FrameLevels) -> float:
    """How far the surface at a pixel lies from a plane [m]; as far as the camera where there is none."""
    z = frame.depth[at]
    p = vec3((float(u) - lens[2]) / lens[0], (float(v) - lens[3]) / lens[1], 1.0) * z
    return abs(dot(axis(plane), p) - plane[3])


@func
def is_inside(at: int, margin: int, level: int, frame: FrameLevels) -> int:
    """1 where a surface goes on in its plane, about, for so many pixels to all four sides."""
    size = frame.layout[level]
    lens = frame.lenses[level]
    e = at - size[2]
    u = e % size[0]
    v = e // size[0]
    inside = 0
    if margin == 0:
        inside = 1
    elif u >= margin and v >= margin and u < size[0] - margin and v < size[1] - margin:
        plane = frame.planes[at]
        if plane[3] < 0.0:
            left = leaves_plane(at - margin, u - margin, v, plane, lens, frame)
            right = leaves_plane(at + margin, u + margin, v, plane, lens, frame)
            above = leaves_plane(at - margin * size[0], u, v - margin, plane, lens, frame)
            below = leaves_plane(at + margin * size[0], u, v + margin, plane, lens, frame)
            if max(max(left, right), max(above, below)) < EDGE_STEP * frame.depth[at]:
                inside = 1
    return inside


@reduction
def sum_certainty(
    source: FrameLevels,
    target: FrameLevels,
    level: int,
    other: int,
    surface_share: float,
    brightness_share: float,
    margin: int,
    warps: array(dtype=vec4),
    scales: array(dtype=float32),
) -> certainty_sums:
    """A source pixel's part; `level` and `other` are those of source and target.

    What lies within a margin [px] of an edge of its surface does not count: a rendered model is rounded there, and what
    hides something moves along with a camera. Where there is a margin, brightness counts by the noise found, `scales`.
    """
    e = tid()
    size = source.layout[level]
    i = size[2] + e
    z = source.depth[i]
    g = row(0.0)
    j = row(0.0)
    h = row(0.0)
    k = row(0.0)
    count = 0.0
    if z > 0.0:
        p = moved_point(float(e % size[0]), float(e // size[0]), z, warps)
        u, v, at = seen_at(p, other, target)
        there = 0.0
        if at >= 0:
            there = target.depth[at]
        noise = depth_noise(p[2])
        if there > 0.0 and abs(p[2] - there) < INLIER_REACH * (noise + REACH_SHARE * p[2]):
            count = 1.0
            plane = target.planes[at]
            inside = is_inside(at, margin, other, target)
            if plane[3] < 0.0 and inside == 1:
                j = surface_row(p, plane)
                g = j * (surface_share / (noise * noise))
            if source.brightness[i] >= 0.0 and brightness_share > 0.0 and inside == 1:
                look = seen_brightness(u, v, other, target)
                if look[1] * look[1] + look[2] * look[2] > LEAST_SLOPE * LEAST_SLOPE:
                    k = brightness_row(p, look, other, target)
                    weight = 1.0 / (SHADE_NOISE * SHADE_NOISE)
                    if margin > 0:
                        weight = scales[1] * ALIKE
                    h = k * (brightness_share * weight)
    return squares_of(g, j, h, k, count)
