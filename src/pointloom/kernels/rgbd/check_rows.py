"""Consistency statistics of a pose between two frames. A source pixel in front of the target's surface contradicts the
pose. One behind it is occluded. Normals and brightness must agree where surfaces match.
"""

from ..lang import array, dot, float32, float64, func, segment_reduction, tid, vec3, vec4, vector
from .pyramid import FrameLevels
from .seen_pixels import SLOPE_MARGIN, axis, depth_noise, moved_point, seen_at, seen_brightness

PIXEL_COUNT, INSIDE_COUNT, SEEN_COUNT, INLIER_COUNT, IN_FRONT_COUNT, BEHIND_COUNT = 0, 1, 2, 3, 4, 5
NORMAL_COUNT, COSINE_SUM, AGREEING_COUNT = 6, 7, 8
SHADE_COUNT = 9  # then source, target, source^2, target^2, product
DISTANCE_SQUARES, SHADE_SQUARES = 15, 16  # of plane distances [m^2], of brightness differences
POINT_MOMENTS = 17  # sums of the inliers' target points, then of products above the diagonal
PLANE_COUNT, EXCESS_SUM = 26, 27  # pixels with a plane, and bounded sum of squares in noise variances
consistency_sums = vector(28, float64)
consistency_row = vector(28, float32)
INLIER_LIMIT = 4.0  # deviations of the noise
MAX_EXCESS = 16.0  # per pixel, the squared limit: pixels of thin objects must not dominate
MIN_AGREEING_COSINE = 0.8  # cosine between normals of one surface


@segment_reduction
def sum_consistency(
    source: FrameLevels,
    target: FrameLevels,
    level: int,
    other: int,
    warps: array(dtype=vec4),
    scales: array(dtype=float32),
) -> consistency_sums:
    """Source pixel's part; `level` and `other` are of source and target."""
    e = tid()
    size = source.layout[level]
    i = size[2] + e
    z = source.depth[i]
    out = consistency_row(0.0)
    inlier = vec3(0.0)
    if z > 0.0:
        out[PIXEL_COUNT] = 1.0
        p = moved_point(float(e % size[0]), float(e // size[0]), z, warps)
        u, v, at = seen_at(p, other, target)
        there = 0.0
        if at >= 0:
            out[INSIDE_COUNT] = 1.0
            there = target.depth[at]
        if there > 0.0:
            out[SEEN_COUNT] = 1.0
            gap = p[2] - there
            noise = depth_noise(p[2])
            limit = INLIER_LIMIT * (noise + SLOPE_MARGIN * p[2])
            if gap < -limit:
                out[IN_FRONT_COUNT] = 1.0
            elif gap > limit:
                out[BEHIND_COUNT] = 1.0
            else:
                out[INLIER_COUNT] = 1.0
                inlier = p
                plane = target.planes[at]
                if plane[3] < 0.0:
                    r = dot(axis(plane), p) - plane[3]
                    out[DISTANCE_SQUARES] = r * r
                    out[PLANE_COUNT] = 1.0
                    out[EXCESS_SUM] = min(r * r / (noise * noise), MAX_EXCESS)
                    if source.planes[i][3] < 0.0:
                        cosine = dot(rotated_normal(source.planes[i], source.lenses[level], warps), axis(plane))
                        out[NORMAL_COUNT] = 1.0
                        out[COSINE_SUM] = cosine
                        if cosine > MIN_AGREEING_COSINE:
                            out[AGREEING_COUNT] = 1.0
                shade = source.brightness[i]
                if shade >= 0.0:
                    sample = seen_brightness(u, v, other, target)
                    if sample[3] > 0.0:
                        s = sample[0] - shade * scales[2] - scales[3]
                        out[SHADE_COUNT] = 1.0
                        out[SHADE_COUNT + 1] = shade
                        out[SHADE_COUNT + 2] = sample[0]
                        out[SHADE_COUNT + 3] = shade * shade
                        out[SHADE_COUNT + 4] = sample[0] * sample[0]
                        out[SHADE_COUNT + 5] = shade * sample[0]
                        out[SHADE_SQUARES] = s * s
    return summed(out, inlier)


@func
def rotated_normal(plane: vec4, lens: vec4, warps: array(dtype=vec4)) -> vec3:
    """Source plane's normal in the target frame, rotated like its lens's rays."""
    a = axis(warps[0])
    b = axis(warps[1])
    c = axis(warps[2]) + a * lens[2] + b * lens[3]
    return a * lens[0] * plane[0] + b * lens[1] * plane[1] + c * plane[2]


@func
def summed(sums: consistency_row, p: vec3) -> consistency_sums:
    """The sums in float64, with an inlier's point and its products."""
    out = consistency_sums(0.0)
    for k in range(28):
        out[k] = float64(sums[k])
    for a in range(3):
        out[POINT_MOMENTS + a] = float64(p[a])
    out[POINT_MOMENTS + 3] = float64(p[0] * p[0])
    out[POINT_MOMENTS + 4] = float64(p[0] * p[1])
    out[POINT_MOMENTS + 5] = float64(p[0] * p[2])
    out[POINT_MOMENTS + 6] = float64(p[1] * p[1])
    out[POINT_MOMENTS + 7] = float64(p[1] * p[2])
    out[POINT_MOMENTS + 8] = float64(p[2] * p[2])
    return out
