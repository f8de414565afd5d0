"""Normal equations of Open3D 0.20's odometries, for conformance.

LEGACY_FORM truncates u + 0.5, also behind the camera, and uses plain squares. TENSOR_FORM rounds, drops points behind,
and bounds residuals only in the right side (Huber 1964 would bound the matrix too). Float64 sums, where Open3D has
float32.
"""

from collections.abc import Sequence

from ..algebra.rigid_solve import move, vec6d
from ..array_types import Scalars, Vectors
from ..lang import array, float32, float64, floor, func, isfinite, mat44d, reduction, struct, tid, vec3, vec3d, vector

LEGACY_FORM, TENSOR_FORM = 0, 1
COLOR_TERM, HYBRID_TERM, PLANE_TERM, PAIRS_ONLY = 0, 1, 2, 3  # terms. PAIRS_ONLY only counts pairs
# Behind 21 of the matrix and 6 of the right side
SQUARED_SUM_AT, PAIR_COUNT_AT, SOURCE_SHADE_AT, TARGET_SHADE_AT = 27, 28, 29, 30
open3d_sums = vector(31, float64)
SOBEL_SCALE = 0.125


@struct
class Open3DLevel:
    """Frame level with NaN for no depth [m]. The gradients `along`, `down` of brightness are 8 times too large."""

    width: int
    height: int
    fx: float64
    fy: float64
    cx: float64
    cy: float64
    depth: array(dtype=float32)
    brightness: array(dtype=float32)
    along: array(dtype=float32)
    down: array(dtype=float32)
    depth_along: array(dtype=float32)
    depth_down: array(dtype=float32)
    normals: array(dtype=vec3)

    def __init__(
        self,
        size: tuple[int, int],
        lens: Sequence[float],
        depth: Scalars,
        brightness: Scalars,
        slopes: tuple[Scalars, Scalars],
        depth_slopes: tuple[Scalars, Scalars],
        normals: Vectors,
    ) -> None:
        self.width, self.height = size
        self.fx, self.fy, self.cx, self.cy = lens
        self.depth, self.brightness, self.normals = depth, brightness, normals
        self.along, self.down = slopes
        self.depth_along, self.depth_down = depth_slopes


@struct
class Open3DRules:
    """Odometry variant: form, term, `max_distance` [m]. Huber limits; weight roots."""

    form: int
    method: int
    max_distance: float64
    depth_delta: float64
    shade_delta: float64
    depth_root: float64
    shade_root: float64

    def __init__(
        self,
        form: int,
        method: int,
        max_distance: float,
        depth_delta: float = 0.0,
        shade_delta: float = 0.0,
        depth_root: float = 1.0,
        shade_root: float = 1.0,
    ) -> None:
        self.form, self.method, self.max_distance = form, method, max_distance
        self.depth_delta, self.shade_delta = depth_delta, shade_delta
        self.depth_root, self.shade_root = depth_root, shade_root


@func
def away_from_zero(x: float64) -> float64:
    """Nearest integer, halves away from zero."""
    nearest = floor(abs(x) + 0.5)
    if x < 0.0:
        nearest = -nearest
    return nearest


@func
def bounded_loss(r: float64, delta: float64) -> float64:
    size = abs(r)
    loss = 0.5 * r * r
    if size > delta:
        loss = delta * (size - 0.5 * delta)
    return loss


@func
def bounded_slope(r: float64, delta: float64) -> float64:
    """Its derivative as in Open3D: beyond delta the sign is of the truncated residual, so it is 0 up to 1."""
    slope = r
    if abs(r) >= delta:
        slope = 0.0
        if abs(r) >= 1.0:
            slope = min(max(r, -delta), delta)
    return slope


@func
def motion_row(p: vec3d, c: vec3d) -> vec6d:
    return vec6d(
        p[1] * c[2] - p[2] * c[1], p[2] * c[0] - p[0] * c[2], p[0] * c[1] - p[1] * c[0], c[0], c[1], c[2]
    )  # fmt: skip


@func
def slope_in_space(p: vec3d, along: float64, down: float64, fx: float64, fy: float64) -> vec3d:
    """Derivative of an image value by the point [1 / m], from its gradient [1 / px]."""
    a = along * fx / p[2]
    b = down * fy / p[2]
    return vec3d(a, b, -(a * p[0] + b * p[1]) / p[2])


@func
def with_row(total: open3d_sums, j: vec6d, r: float64) -> open3d_sums:
    out = total
    n = int(6)
    at = 0
    for a in range(n):
        for b in range(a, n):
            out[at] = out[at] + j[a] * j[b]
            at += 1
        out[21 + a] = out[21 + a] + j[a] * r
    return out


@func
def rounded_pixel(p: vec3d, form: int, target: Open3DLevel) -> vec3d:
    """Column and row of a target camera point, rounded as in the form, and 1 inside."""
    pu = target.fx * p[0] / p[2] + target.cx
    pv = target.fy * p[1] / p[2] + target.cy
    if form == LEGACY_FORM:
        pu = floor(pu + 0.5)
        pv = floor(pv + 0.5)
    else:
        pu = away_from_zero(pu)
        pv = away_from_zero(pv)
    max_u = float64(target.width) - 0.5
    max_v = float64(target.height) - 0.5
    inside = float64(0.0)
    if pu > -float64(0.5) and pv > -float64(0.5) and pu < max_u and pv < max_v:
        inside = 1.0
    return vec3d(pu, pv, inside)


@func
def image_part(
    p: vec3d, at: int, gap: float64, source_shade: float64, rules: Open3DRules, target: Open3DLevel
) -> open3d_sums:
    """Rows of brightness and, for HYBRID_TERM, depth, at target pixel `at`."""
    total = open3d_sums(0.0)
    total[PAIR_COUNT_AT] = 1.0
    target_shade = float64(target.brightness[at])
    total[SOURCE_SHADE_AT] = source_shade
    total[TARGET_SHADE_AT] = target_shade
    d_along = float64(0.0)
    d_down = float64(0.0)
    if rules.method == HYBRID_TERM:
        d_along = float64(SOBEL_SCALE) * float64(target.depth_along[at])
        d_down = float64(SOBEL_SCALE) * float64(target.depth_down[at])
    missing = 0
    if not isfinite(d_along):
        missing = 1
        d_along = 0.0
    if not isfinite(d_down):
        missing = 1
        d_down = 0.0
    if rules.form == TENSOR_FORM and missing == 1:
        total[PAIR_COUNT_AT] = 0.0
    elif rules.method != PAIRS_ONLY:
        along = float64(SOBEL_SCALE) * float64(target.along[at])
        down = float64(SOBEL_SCALE) * float64(target.down[at])
        j = motion_row(p, slope_in_space(p, along, down, target.fx, target.fy)) * rules.shade_root
        r = rules.shade_root * (target_shade - source_shade)
        if rules.form == TENSOR_FORM:
            total[SQUARED_SUM_AT] = total[SQUARED_SUM_AT] + bounded_loss(r, rules.shade_delta)
            r = bounded_slope(r, rules.shade_delta)
        total = with_row(total, j, r)
        if rules.method == HYBRID_TERM:
            c = slope_in_space(p, d_along, d_down, target.fx, target.fy)
            c = vec3d(c[0], c[1], c[2] - 1.0)
            r = rules.depth_root * gap
            if rules.form == TENSOR_FORM:
                total[SQUARED_SUM_AT] = total[SQUARED_SUM_AT] + bounded_loss(r, rules.depth_delta)
                r = bounded_slope(r, rules.depth_delta)
            total = with_row(total, motion_row(p, c) * rules.depth_root, r)
    return total


@reduction
def sum_open3d_rows(
    source_depth: array(dtype=float32),
    source_brightness: array(dtype=float32),
    target: Open3DLevel,
    pose: mat44d,
    rules: Open3DRules,
) -> open3d_sums:
    """Source pixel's part. The source has the target's size and camera."""
    i = tid()
    total = open3d_sums(0.0)
    z = float64(source_depth[i])
    if isfinite(z):
        u = float64(i % target.width)
        v = float64(i // target.width)
        p = move(pose, vec3d((u - target.cx) * z / target.fx, (v - target.cy) * z / target.fy, z))
        if p[2] != 0.0 and (rules.form == LEGACY_FORM or p[2] > 0.0):
            pixel = rounded_pixel(p, rules.form, target)
            pu = pixel[0]
            pv = pixel[1]
            if pixel[2] > 0.0:
                at = int(pv) * target.width + int(pu)
                there = float64(target.depth[at])
                gap = there - p[2]
                if rules.method == PLANE_TERM:
                    n = target.normals[at]
                    if isfinite(there) and isfinite(n[0]):
                        normal = vec3d(float64(n[0]), float64(n[1]), float64(n[2]))
                        qx = (pu - target.cx) * there / target.fx
                        qy = (pv - target.cy) * there / target.fy
                        r = (p[0] - qx) * normal[0] + (p[1] - qy) * normal[1] + (p[2] - there) * normal[2]
                        if abs(r) <= rules.max_distance:
                            total = with_row(total, motion_row(p, normal), bounded_slope(r, rules.depth_delta))
                            total[SQUARED_SUM_AT] = bounded_loss(r, rules.depth_delta)
                            total[PAIR_COUNT_AT] = 1.0
                elif abs(gap) <= rules.max_distance:
                    total = image_part(p, at, gap, float64(source_brightness[i]), rules, target)
    return total


information_sums = vector(11, float64)  # pairs, sums of q and of its products above the diagonal. Pixels with depth


@reduction
def sum_open3d_information(
    source_depth: array(dtype=float32), target: Open3DLevel, pose: mat44d, form: int, max_distance: float64
) -> information_sums:
    """Target points of pairs whose depths (LEGACY_FORM) or points (TENSOR_FORM) are within `max_distance`."""
    i = tid()
    total = information_sums(0.0)
    z = float64(source_depth[i])
    if isfinite(z):
        total[10] = 1.0
        u = float64(i % target.width)
        v = float64(i // target.width)
        p = move(pose, vec3d((u - target.cx) * z / target.fx, (v - target.cy) * z / target.fy, z))
        if p[2] != 0.0 and (form == LEGACY_FORM or p[2] > 0.0):
            pixel = rounded_pixel(p, form, target)
            pu = pixel[0]
            pv = pixel[1]
            if pixel[2] > 0.0:
                there = float64(target.depth[int(pv) * target.width + int(pu)])
                x = (pu - target.cx) * there / target.fx
                y = (pv - target.cy) * there / target.fy
                gap = abs(p[2] - there)
                if form == TENSOR_FORM:
                    square = (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y) + gap * gap
                    gap = 2.0 * max_distance
                    if square <= max_distance * max_distance:
                        gap = 0.0
                if gap <= max_distance:
                    one = float64(1.0)
                    total = information_sums(
                        one, x, y, there, x * x, x * y, x * there, y * y, y * there, there * there, one
                    )  # fmt: skip
    return total
