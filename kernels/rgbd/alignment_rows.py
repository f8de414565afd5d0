"""One pixel's part of the normal equations that bring a frame onto another: surface and brightness.

The source pixel goes to the target by projection (Blais and Levine 1995). There the surface says how far it lies from
the plane of the nearest pixel (point to plane, Chen and Medioni 1991), the brightness how it differs from what is seen
there, bilinear. Both residuals are divided by what their sensors' noise makes of them, so that they are of one kind,
and weighed as of a t distribution (Lange et al. 1989; Kerl et al. 2013), in the matrix as in the right side.

One thread a source pixel: reads some 60 B, takes some 300 operations, writes nothing; 38 sums leave through the
reduction. Rows are float32, sums float64. Unknowns are a rotation and a translation on the target's side.
"""

from ..lang import (
    array,
    float32,
    float64,
    floor,
    func,
    int32,
    mat44d,
    segment_reduction,
    struct,
    tid,
    vec4,
    vector,
)
from .pyramid import FrameLevels

SURFACE_COUNT, SURFACE_ERROR, SURFACE_SQUARES = 27, 28, 29  # behind 21 of the matrix and 6 of the right side
BRIGHTNESS_COUNT, BRIGHTNESS_ERROR = 30, 31
SHADES = 32  # weights, source, target, source^2, target^2, their product
row_sums = vector(38, float64)
row = vector(6, float32)
extra_sums = vector(11, float32)
NU = 5.0  # degrees of freedom of the t distribution (Kerl et al. 2013)
NOISE_FLOOR, NOISE_SLOPE = 0.0012, 0.0019  # deviation of depth [m] and its growth [1/m] (Nguyen et al. 2012, Kinect)
NOISE_NEAR = 0.4  # [m] from where on it grows
NEAREST = 1.0e-3  # [m] before the camera
REACH_SHARE = 0.01  # of the depth, beside its noise: what a pixel's slope does


@struct
class AlignmentState:
    """Where an alignment stands.

    Attributes:
        running: int32 [1], what `loop_while` looks at.
        live: int32 [levels], 1 for the level at work.
        counts: int32 [4]: the level, steps in it, steps in all, whether the last step was short.
        most_steps: int32 [levels], steps at most in each level.
        warps: vec4 [3]: the pose, so that u w0 + v w1 + w2 is the ray of a source pixel in the target's frame; the
            fourth numbers are the translation.
        scales: float32 [4]: inverse variances of surface and brightness, gain and offset of the source's brightness.
        pose: mat44d [1], T_target_source.
    """

    running: array(dtype=int32)
    live: array(dtype=int32)
    counts: array(dtype=int32)
    most_steps: array(dtype=int32)
    warps: array(dtype=vec4)
    scales: array(dtype=float32)
    pose: array(dtype=mat44d)

    def __init__(self, arrays):
        """The device arrays by name."""
        self.running, self.live, self.counts = arrays["running"], arrays["live"], arrays["counts"]
        self.most_steps, self.warps, self.scales = arrays["most_steps"], arrays["warps"], arrays["scales"]
        self.pose = arrays["pose"]


@struct
class AlignmentRules:
    """What counts how much.

    Attributes:
        shift: Level of the target less that of the source which it is compared with.
        surface_share, brightness_share: How much the two terms count, 0 for not at all.
        reach: How far apart in depth two pixels may lie, in deviations of their noise.
        first_level: The finest that is used.
        short_step: A step that moves pixels a metre away by less [px] ends its level.
    """

    shift: int
    surface_share: float
    brightness_share: float
    reach: float
    first_level: int
    short_step: float

    def __init__(self, shift, surface_share, brightness_share, reach, first_level, short_step):
        self.shift, self.reach, self.first_level = int(shift), float(reach), int(first_level)
        self.surface_share, self.brightness_share = float(surface_share), float(brightness_share)
        self.short_step = float(short_step)


@func
def depth_noise(z: float) -> float:
    """The deviation of a depth [m], up to a factor that the frames tell."""
    beyond = max(z - NOISE_NEAR, 0.0)
    return NOISE_FLOOR + NOISE_SLOPE * beyond * beyond


@func
def sum_rows(g: row, j: row, r: float, h: row, k: row, s: float, extra: extra_sums) -> row_sums:
    """The sums of two weighted rows: g = w j with residual r, h = w k with residual s; then what else is summed."""
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


@func
def seen_brightness(u: float, v: float, first: int, width: int, brightness: array(dtype=float32)) -> vec4:
    """Brightness at a place between pixel centres, bilinear, its slopes [1 / px], and 1; zero where one has none."""
    left = int(floor(u))
    top = int(floor(v))
    at = first + top * width + left
    a = brightness[at]
    b = brightness[at + 1]
    c = brightness[at + width]
    d = brightness[at + width + 1]
    s = u - float(left)
    t = v - float(top)
    seen = vec4(0.0, 0.0, 0.0, 0.0)
    if min(min(a, b), min(c, d)) >= 0.0:
        upper = a + (b - a) * s
        lower = c + (d - c) * s
        seen = vec4(upper + (lower - upper) * t, (b - a) * (1.0 - t) + (d - c) * t, lower - upper, 1.0)
    return seen


@segment_reduction(most_registers=128)
def sum_alignment_rows(
    source: FrameLevels, target: FrameLevels, rules: AlignmentRules, state: AlignmentState
) -> row_sums:
    """A source pixel's part of the normal equations, and of what tells the noise and the exposure."""
    i = tid()
    g = row(0.0)
    j = row(0.0)
    h = row(0.0)
    k = row(0.0)
    r = float(0.0)
    s = float(0.0)
    extra = extra_sums(0.0)
    z = source.depth[i]
    if z > 0.0:
        level = state.counts[0]
        size = source.layout[level]
        u = float((i - size[2]) % size[0])
        v = float((i - size[2]) // size[0])
        w0 = state.warps[0]
        w1 = state.warps[1]
        w2 = state.warps[2]
        x = z * (u * w0[0] + v * w1[0] + w2[0]) + w0[3]
        y = z * (u * w0[1] + v * w1[1] + w2[1]) + w1[3]
        depth = z * (u * w0[2] + v * w1[2] + w2[2]) + w2[3]
        if depth > NEAREST:
            other = level + rules.shift
            lens = target.lenses[other]
            seen = target.layout[other]
            pu = lens[0] * x / depth + lens[2]
            pv = lens[1] * y / depth + lens[3]
            if pu >= 0.0 and pv >= 0.0 and pu < float(seen[0] - 1) and pv < float(seen[1] - 1):
                at = seen[2] + int(floor(pv + 0.5)) * seen[0] + int(floor(pu + 0.5))
                there = target.depth[at]
                gap = depth - there
                noise = depth_noise(depth)
                if there > 0.0 and abs(gap) < rules.reach * (noise + REACH_SHARE * depth):
                    shade = source.brightness[i]
                    if shade >= 0.0 and rules.brightness_share > 0.0:
                        look = seen_brightness(pu, pv, seen[2], seen[0], target.brightness)
                        if look[3] > 0.0:
                            s = look[0] - shade * state.scales[2] - state.scales[3]
                            a = look[1] * lens[0] / depth
                            b = look[2] * lens[1] / depth
                            c = -(a * x + b * y) / depth
                            k = row(y * c - depth * b, depth * a - x * c, x * b - y * a, a, b, c)
                            t = (NU + 1.0) / (NU + s * s * state.scales[1])
                            h = k * (t * state.scales[1] * rules.brightness_share)
                            extra[3] = 1.0
                            extra[4] = t * s * s
                            extra[5] = t
                            extra[6] = t * shade
                            extra[7] = t * look[0]
                            extra[8] = t * shade * shade
                            extra[9] = t * look[0] * look[0]
                            extra[10] = t * shade * look[0]
                    plane = target.planes[at]
                    if plane[3] < 0.0 and rules.surface_share > 0.0:
                        r = plane[0] * x + plane[1] * y + plane[2] * depth - plane[3]
                        inverse = 1.0 / (noise * noise)
                        square = r * r * inverse
                        t = (NU + 1.0) / (NU + square * state.scales[0])
                        j = row(
                            y * plane[2] - depth * plane[1],
                            depth * plane[0] - x * plane[2],
                            x * plane[1] - y * plane[0],
                            plane[0], plane[1], plane[2],
                        )  # fmt: skip
                        g = j * (t * inverse * state.scales[0] * rules.surface_share)
                        extra[0] = 1.0
                        extra[1] = t * square
                        extra[2] = r * r
    return sum_rows(g, j, r, h, k, s, extra)
