"""Normal equations of frame alignment: point-to-plane (Chen and Medioni 1991) by projective association (Blais and
Levine 1995) and bilinear brightness. Residuals are normalized by noise and weighted by a t distribution (Lange et al.
1989; Kerl et al. 2013). Float32 rows, float64 sums. Unknowns are rotation and translation on the target side.
"""

from typing import Any

from ..array_types import Array1, Integers, Poses, Scalars
from ..lang import array, dot, float32, float64, func, int32, mat44d, segment_reduction, struct, tid, vec4, vector
from .pyramid import FrameLevels
from .seen_pixels import (
    SLOPE_MARGIN,
    axis,
    brightness_row,
    depth_noise,
    moved_point,
    row,
    seen_at,
    seen_brightness,
    surface_row,
)

SURFACE_COUNT, SURFACE_ERROR = 27, 28  # behind 21 of the matrix and 6 of the right side
BRIGHTNESS_COUNT, BRIGHTNESS_ERROR = 30, 31
SHADE_SUMS_AT = 32  # weights, source, target, source^2, target^2, their product
row_sums = vector(38, float64)
extra_sums = vector(11, float32)
T_FREEDOM = 5.0  # degrees of freedom of the t distribution (Kerl et al. 2013)


@struct
class AlignmentState:
    """Alignment state: `live`: 1 for the current level; `counts`: level, its steps, all steps, short-step flag;
    `warps`: u w0 + v w1 + w2 is a pixel's ray in the target frame, fourth numbers the translation; `scales`: inverse
    variances of surface and brightness, gain, offset; `pose` T_target_source.
    """

    running: array(dtype=int32)
    live: array(dtype=int32)
    counts: array(dtype=int32)
    max_steps: array(dtype=int32)
    warps: array(dtype=vec4)
    scales: array(dtype=float32)
    pose: array(dtype=mat44d)

    def __init__(self, arrays: dict[str, Scalars | Integers | Poses | Array1[vec4] | Array1[Any]]) -> None:
        self.running, self.live, self.counts = arrays["running"], arrays["live"], arrays["counts"]
        self.max_steps, self.warps, self.scales = arrays["max_steps"], arrays["warps"], arrays["scales"]
        self.pose = arrays["pose"]


@struct
class AlignmentRules:
    """Weights: `shift`: target level minus source level; fractions of the two terms; `max_deviation` in noise
    deviations; finest `first_level`. A `short_step` [px at 1 m] ends a level.
    """

    shift: int
    surface_fraction: float
    brightness_fraction: float
    max_deviation: float
    first_level: int
    short_step: float

    def __init__(
        self,
        shift: int,
        surface_fraction: float,
        brightness_fraction: float,
        max_deviation: float,
        first_level: int,
        short_step: float,
    ) -> None:
        self.shift, self.max_deviation, self.first_level = int(shift), float(max_deviation), int(first_level)
        self.surface_fraction, self.brightness_fraction = float(surface_fraction), float(brightness_fraction)
        self.short_step = float(short_step)


@func
def sum_rows(g: row, j: row, r: float, h: row, k: row, s: float, extra: extra_sums) -> row_sums:
    """Sums of two weighted rows: g = w j with residual r, h = w k with residual s. Then extras."""
    return row_sums(
        float64(g[0] * j[0] + h[0] * k[0]), float64(g[0] * j[1] + h[0] * k[1]),
        float64(g[0] * j[2] + h[0] * k[2]), float64(g[0] * j[3] + h[0] * k[3]),
        float64(g[0] * j[4] + h[0] * k[4]), float64(g[0] * j[5] + h[0] * k[5]),
        float64(g[1] * j[1] + h[1] * k[1]), float64(g[1] * j[2] + h[1] * k[2]),
        float64(g[1] * j[3] + h[1] * k[3]), float64(g[1] * j[4] + h[1] * k[4]),
        float64(g[1] * j[5] + h[1] * k[5]),
        float64(g[2] * j[2] + h[2] * k[2]), float64(g[2] * j[3] + h[2] * k[3]),
        float64(g[2] * j[4] + h[2] * k[4]), float64(g[2] * j[5] + h[2] * k[5]),
        float64(g[3] * j[3] + h[3] * k[3]), float64(g[3] * j[4] + h[3] * k[4]),
        float64(g[3] * j[5] + h[3] * k[5]),
        float64(g[4] * j[4] + h[4] * k[4]), float64(g[4] * j[5] + h[4] * k[5]),
        float64(g[5] * j[5] + h[5] * k[5]),
        float64(g[0] * r + h[0] * s), float64(g[1] * r + h[1] * s), float64(g[2] * r + h[2] * s),
        float64(g[3] * r + h[3] * s), float64(g[4] * r + h[4] * s), float64(g[5] * r + h[5] * s),
        float64(extra[0]), float64(extra[1]), float64(extra[2]), float64(extra[3]), float64(extra[4]),
        float64(extra[5]), float64(extra[6]), float64(extra[7]), float64(extra[8]), float64(extra[9]),
        float64(extra[10]),
    )  # fmt: skip


@segment_reduction(max_registers=128)
def sum_alignment_rows(
    source: FrameLevels, target: FrameLevels, rules: AlignmentRules, state: AlignmentState
) -> row_sums:
    """Source pixel's part of the normal equations, noise and exposure."""
    i = tid()
    g = row(0.0)
    j = row(0.0)
    h = row(0.0)
    k = row(0.0)
    r = 0.0
    s = 0.0
    extra = extra_sums(0.0)
    z = source.depth[i]
    if z > 0.0:
        level = state.counts[0]
        other = level + rules.shift
        size = source.layout[level]
        p = moved_point(float((i - size[2]) % size[0]), float((i - size[2]) // size[0]), z, state.warps)
        u, v, at = seen_at(p, other, target)
        there = 0.0
        if at >= 0:
            there = target.depth[at]
        noise = depth_noise(p[2])
        if there > 0.0 and abs(p[2] - there) < rules.max_deviation * (noise + SLOPE_MARGIN * p[2]):
            shade = source.brightness[i]
            if shade >= 0.0 and rules.brightness_fraction > 0.0:
                sample = seen_brightness(u, v, other, target)
                if sample[3] > 0.0:
                    s = sample[0] - shade * state.scales[2] - state.scales[3]
                    k = brightness_row(p, sample, other, target)
                    t = (T_FREEDOM + 1.0) / (T_FREEDOM + s * s * state.scales[1])
                    h = k * (t * state.scales[1] * rules.brightness_fraction)
                    extra[3] = 1.0
                    extra[4] = t * s * s
                    extra[5] = t
                    extra[6] = t * shade
                    extra[7] = t * sample[0]
                    extra[8] = t * shade * shade
                    extra[9] = t * sample[0] * sample[0]
                    extra[10] = t * shade * sample[0]
            plane = target.planes[at]
            if plane[3] < 0.0 and rules.surface_fraction > 0.0:
                r = dot(axis(plane), p) - plane[3]
                inverse = 1.0 / (noise * noise)
                square = r * r * inverse
                t = (T_FREEDOM + 1.0) / (T_FREEDOM + square * state.scales[0])
                j = surface_row(p, plane)
                g = j * (t * inverse * state.scales[0] * rules.surface_fraction)
                extra[0] = 1.0
                extra[1] = t * square
                extra[2] = r * r
    return sum_rows(g, j, r, h, k, s, extra)
