"""What speaks for a pose between two frames and what against it: counts and sums over the pixels of one level.

A pixel of the source that lies in front of what the target saw there contradicts the pose: the target looked through
it. One that lies behind is hidden, which says nothing. Normals and brightness have to agree where surfaces meet.

One thread a source pixel: reads some 60 B, writes nothing; 28 sums leave through the reduction.
"""

from ..lang import array, float32, float64, floor, func, reduction, tid, vec4, vector
from .alignment_rows import NEAREST, REACH_SHARE, depth_noise, seen_brightness
from .pyramid import FrameLevels

PIXELS, INSIDE, SEEN, INLIERS, IN_FRONT, BEHIND = 0, 1, 2, 3, 4, 5
NORMALS, COSINES, AGREEING = 6, 7, 8
SHADE_COUNT = 9  # then source, target, source^2, target^2, product
SQUARES, SHADE_SQUARES = 15, 16  # of the distance from the planes [m^2], of the difference in brightness
POINTS = 17  # sums of the inliers' target points, then of their products above the diagonal
verdict_sums = vector(28, float64)
verdict_row = vector(28, float32)
INLIER_REACH = 4.0  # deviations of the noise
AGREEMENT = 0.8  # cosine between normals of one surface


@reduction
def sum_verdict(
    source: FrameLevels,
    target: FrameLevels,
    level: int,
    other: int,
    warps: array(dtype=vec4),
    scales: array(dtype=float32),
) -> verdict_sums:
    """A source pixel's part; `level` and `other` are those of source and target."""
    e = tid()
    size = source.layout[level]
    i = size[2] + e
    z = source.depth[i]
    out = verdict_row(0.0)
    if z > 0.0:
        out[PIXELS] = 1.0
        u = float(e % size[0])
        v = float(e // size[0])
        w0 = warps[0]
        w1 = warps[1]
        w2 = warps[2]
        x = z * (u * w0[0] + v * w1[0] + w2[0]) + w0[3]
        y = z * (u * w0[1] + v * w1[1] + w2[1]) + w1[3]
        depth = z * (u * w0[2] + v * w1[2] + w2[2]) + w2[3]
        if depth > NEAREST:
            lens = target.lenses[other]
            seen = target.layout[other]
            pu = lens[0] * x / depth + lens[2]
            pv = lens[1] * y / depth + lens[3]
            if pu >= 0.0 and pv >= 0.0 and pu < float(seen[0] - 1) and pv < float(seen[1] - 1):
                out[INSIDE] = 1.0
                at = seen[2] + int(floor(pv + 0.5)) * seen[0] + int(floor(pu + 0.5))
                there = target.depth[at]
                if there > 0.0:
                    out[SEEN] = 1.0
                    gap = depth - there
                    limit = INLIER_REACH * (depth_noise(depth) + REACH_SHARE * depth)
                    if gap < -limit:
                        out[IN_FRONT] = 1.0
                    elif gap > limit:
                        out[BEHIND] = 1.0
                    else:
                        out[INLIERS] = 1.0
                        out[POINTS] = x
                        out[POINTS + 1] = y
                        out[POINTS + 2] = depth
                        out[POINTS + 3] = x * x
                        out[POINTS + 4] = x * y
                        out[POINTS + 5] = x * depth
                        out[POINTS + 6] = y * y
                        out[POINTS + 7] = y * depth
                        out[POINTS + 8] = depth * depth
                        plane = target.planes[at]
                        own = source.planes[i]
                        if plane[3] < 0.0:
                            r = plane[0] * x + plane[1] * y + plane[2] * depth - plane[3]
                            out[SQUARES] = r * r
                            out[27] = 1.0
                            if own[3] < 0.0:
                                # the plane's normal, turned as the rays are
                                sl = source.lenses[level]
                                r0 = vec4(w0[0] * sl[0], w0[1] * sl[0], w0[2] * sl[0], 0.0)
                                r1 = vec4(w1[0] * sl[1], w1[1] * sl[1], w1[2] * sl[1], 0.0)
                                nx = own[0] * r0[0] + own[1] * r1[0]
                                ny = own[0] * r0[1] + own[1] * r1[1]
                                nz = own[0] * r0[2] + own[1] * r1[2]
                                tx = w2[0] + w0[0] * sl[2] + w1[0] * sl[3]
                                ty = w2[1] + w0[1] * sl[2] + w1[1] * sl[3]
                                tz = w2[2] + w0[2] * sl[2] + w1[2] * sl[3]
                                nx += own[2] * tx
                                ny += own[2] * ty
                                nz += own[2] * tz
                                cosine = nx * plane[0] + ny * plane[1] + nz * plane[2]
                                out[NORMALS] = 1.0
                                out[COSINES] = cosine
                                if cosine > AGREEMENT:
                                    out[AGREEING] = 1.0
                        shade = source.brightness[i]
                        if shade >= 0.0:
                            look = seen_brightness(pu, pv, seen[2], seen[0], target.brightness)
                            if look[3] > 0.0:
                                s = look[0] - shade * scales[2] - scales[3]
                                out[SHADE_COUNT] = 1.0
                                out[SHADE_COUNT + 1] = shade
                                out[SHADE_COUNT + 2] = look[0]
                                out[SHADE_COUNT + 3] = shade * shade
                                out[SHADE_COUNT + 4] = look[0] * look[0]
                                out[SHADE_COUNT + 5] = shade * look[0]
                                out[SHADE_SQUARES] = s * s
    return widened(out)


@func
def widened(sums: verdict_row) -> verdict_sums:
    """The same numbers in float64."""
    out = verdict_sums(float64(0.0))
    for k in range(28):
        out[k] = float64(sums[k])
    return out
