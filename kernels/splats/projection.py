"""Splats before a camera: where each lies in the picture, as which ellipse, and in which colour.

A Gaussian is projected by the affine map that is tangent to the camera at its centre (Zwicker et al., "EWA splatting",
IEEE TVCG 2002), with 0.3 px^2 added to its variance, as training does (Kerbl et al. 2023). The depth at which a ray
meets a splat is where the Gaussian is densest along it (Zhang et al., "RaDe-GS", 2024, section 3): of a flat one, its
plane.

One thread a splat; reads 56 B to 236 B, writes 64 B or 116 B. Only + - * / and sqrt beside `exp_in_float`, so that
pictures have the same bits everywhere; the logarithm of an opacity widens a rectangle alone, and what that adds is not
seen.
"""

import numpy as np

from ..algebra.exponential import exp_in_float
from ..array_types import Array2, Device, Integers, Points, Scalars
from ..drawing.z_buffer import View, project, ray_through, to_camera
from ..lang import (
    array,
    cross,
    dot,
    float32,
    floor,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    length,
    log,
    mat33,
    sqrt,
    struct,
    tid,
    vec3,
    vec4,
    vec4i,
)
from ..memory import empty, upload

TILE = 16  # [px] of a tile's side
TILE_PIXELS = TILE * TILE
BLUR = 0.3  # [px^2] added to the variance in the picture
FAINTEST = 1.0 / 255.0  # opacity below which a splat adds nothing to a pixel
MOST_OPACITY = 0.99  # of a splat in a pixel: what lies behind it stays to be seen
BESIDE = 0.15  # of the picture's width and height: what lies farther out has the tangent map of there
FLATTEST = 1.0e-4  # of the longest axis: the shortest one that a splat is taken to have
REACH = 3.0  # standard deviations along the ray, beyond which no splat is met


@struct
class SplatColumns:
    """Splats as files have them.

    Attributes:
        points: vec3 [n] about an origin.
        opacities: float32 [n], logits.
        scales: float32 [n, 3], logarithms.
        quaternions: float32 [n, 4], w, x, y, z of any length.
        first: float32 [n, 3], harmonics of degree 0.
        rest: float32 [n, 3 (K - 1)], the others: all of red, then green, then blue; of size 0 for degree 0.
        sizes: float32 [K], what each harmonic is multiplied by (`harmonics.sizes_of`).
        degree: Of the harmonics.
    """

    points: array(dtype=vec3)
    opacities: array(dtype=float32)
    scales: array(dtype=float32, ndim=2)
    quaternions: array(dtype=float32, ndim=2)
    first: array(dtype=float32, ndim=2)
    rest: array(dtype=float32, ndim=2)
    sizes: array(dtype=float32)
    degree: int

    def __init__(
        self,
        points: Points,
        opacities: Scalars,
        scales: Array2[float32],
        quaternions: Array2[float32],
        first: Array2[float32],
        rest: Array2[float32] | None,
        sizes: np.ndarray,
        degree: int,
    ) -> None:
        self.points, self.opacities, self.scales, self.quaternions = points, opacities, scales, quaternions
        self.first, self.degree = first, degree
        self.rest = empty((0, 0), float32, points.device) if rest is None else rest
        self.sizes = upload(sizes, float32, points.device)


@struct
class ProjectedSplats:
    """Splats in a picture.

    Attributes:
        middles: vec3 [n]: column, row [px], depth.
        conics: vec3 [n]: (a, b, c) of the exponent -(a x^2 + 2 b x y + c y^2) / 2.
        colors: vec3 [n], not below 0.
        opacities: float32 [n], 0 to 1.
        limits: float32 [n]: a pixel whose exponent is below minus this shows nothing of a splat.
        boxes: vec4i [n], first and last column and row of tiles; the last before the first where it is not seen.
        diagonals, others: vec3 [n], A00 A11 A22 and A01 A02 A12 of the inverse covariance A in the camera's frame times
            the square of the shortest axis; of size 0 where no surface is asked for, as are the next three.
        pulls: vec3 [n], A times the centre.
        normals: vec3 [n], the shortest axis, to the camera.
        depths: float32 [n], how far along the ray from its middle a splat is met at most.
    """

    middles: array(dtype=vec3)
    conics: array(dtype=vec3)
    colors: array(dtype=vec3)
    opacities: array(dtype=float32)
    limits: array(dtype=float32)
    boxes: array(dtype=vec4i)
    diagonals: array(dtype=vec3)
    others: array(dtype=vec3)
    pulls: array(dtype=vec3)
    normals: array(dtype=vec3)
    depths: array(dtype=float32)

    def __init__(self, count: int, device: Device, *, surfaces: bool) -> None:
        self.count, self.device = count, device
        self.middles, self.conics, self.colors = (empty(count, vec3, device) for _ in range(3))
        self.opacities, self.limits = empty(count, float32, device), empty(count, float32, device)
        self.boxes = empty(count, vec4i, device)
        held = count if surfaces else 0
        self.diagonals, self.others, self.pulls, self.normals = (empty(held, vec3, device) for _ in range(4))
        self.depths = empty(held, float32, device)


@func
def axes_of(i: int, splats: SplatColumns) -> mat33:
    """The rotation of a splat: its axes as columns."""
    w = splats.quaternions[i, 0]
    x = splats.quaternions[i, 1]
    y = splats.quaternions[i, 2]
    z = splats.quaternions[i, 3]
    size = sqrt(w * w + x * x + y * y + z * z)
    w = w / size
    x = x / size
    y = y / size
    z = z / size
    return mat33(
        1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y),
        2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x),
        2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y),
    )  # fmt: skip


@func
def axes_before_camera(axes: mat33, rotation: mat33, unit: float) -> mat33:
    """Axes under a rotation times a scale, without the scale."""
    turned = mat33(0.0)
    for k in range(3):
        axis = rotation @ vec3(axes[0, k], axes[1, k], axes[2, k])
        for row in range(3):
            turned[row, k] = axis[row] / unit
    return turned


@func
def color_towards(i: int, direction: vec3, splats: SplatColumns) -> vec3:
    """The colour seen along a unit vector from the camera: 0.5 and the harmonics, by recursion over order and band."""
    rest = (splats.degree + 1) * (splats.degree + 1) - 1
    color = vec3(splats.first[i, 0], splats.first[i, 1], splats.first[i, 2]) * splats.sizes[0]
    cosine = 1.0
    sine = 0.0
    start = 1.0  # the Legendre function of a band of its own order
    for m in range(splats.degree + 1):
        before = 0.0
        legendre = start + 0.0
        for band in range(m, splats.degree + 1):
            if band > m:
                above = float(2 * band - 1) * direction[2] * legendre - float(band + m - 1) * before
                before = legendre
                legendre = above / float(band - m)
            for side in range(2 if m > 0 else 1):
                k = band * band + band + m * (1 - 2 * side)
                if k > 0:
                    value = splats.sizes[k] * legendre * (cosine if side == 0 else sine)
                    for channel in range(3):
                        color[channel] = color[channel] + splats.rest[i, channel * rest + k - 1] * value
        turned = direction[0] * cosine - direction[1] * sine
        sine = direction[0] * sine + direction[1] * cosine
        cosine = turned
        start = start * float(2 * m + 1)
    return vec3(max(color[0] + 0.5, 0.0), max(color[1] + 0.5, 0.0), max(color[2] + 0.5, 0.0))


@func
def scaled_inverse(turn: mat33, scales: vec3) -> mat33:
    """The inverse of a covariance times the square of its shortest axis: entries of at most 1."""
    shortest = max(min(min(scales[0], scales[1]), scales[2]), FLATTEST * max(max(scales[0], scales[1]), scales[2]))
    total = mat33(0.0)
    for k in range(3):
        ratio = shortest / max(scales[k], shortest)
        axis = vec3(turn[0, k], turn[1, k], turn[2, k]) * ratio
        for row in range(3):
            for column in range(3):
                total[row, column] = total[row, column] + axis[row] * axis[column]
    return total


@func
def note_surface(i: int, q: vec3, turn: mat33, scales: vec3, projected: ProjectedSplats):
    """What a ray needs in order to meet a splat."""
    A = scaled_inverse(turn, scales)
    projected.diagonals[i] = vec3(A[0, 0], A[1, 1], A[2, 2])
    projected.others[i] = vec3(A[0, 1], A[0, 2], A[1, 2])
    projected.pulls[i] = A @ q
    shortest = 0
    for k in range(1, 3):
        if scales[k] < scales[shortest]:
            shortest = k
    normal = vec3(turn[0, shortest], turn[1, shortest], turn[2, shortest])
    if dot(normal, q) > 0.0:
        normal = -normal
    projected.normals[i] = normal
    spread = 0.0
    for k in range(3):
        spread = spread + turn[2, k] * turn[2, k] * scales[k] * scales[k]
    projected.depths[i] = REACH * sqrt(spread)


@func
def ellipse_of(q: vec3, turn: mat33, scales: vec3, view: View) -> vec4:
    """The variances and the covariance of a splat in the picture [px^2], a b c, and their determinant."""
    fx = float(view.camera.fx)
    fy = float(view.camera.fy)
    left = ray_through(-BESIDE * float(view.camera.width), -BESIDE * float(view.camera.height), view)
    right = ray_through((1.0 + BESIDE) * float(view.camera.width), (1.0 + BESIDE) * float(view.camera.height), view)
    x = min(max(q[0] / q[2], left[0]), right[0])
    y = min(max(q[1] / q[2], left[1]), right[1])
    across = vec3(0.0)
    down = vec3(0.0)
    for k in range(3):
        across[k] = (turn[0, k] - x * turn[2, k]) * scales[k] * (fx / q[2])
        down[k] = (turn[1, k] - y * turn[2, k]) * scales[k] * (fy / q[2])
    a = dot(across, across) + BLUR
    c = dot(down, down) + BLUR
    area = cross(across, down)  # its square is what a c - b b leaves of two large numbers
    return vec4(a, dot(across, down), c, dot(area, area) + BLUR * (a + c - BLUR))


@func
def tiles_of(middle: vec3, right: float, below: float, view: View) -> vec4i:
    """The tiles that a rectangle about a place lies in: first and last column, first and last row."""
    columns = (view.camera.width + TILE - 1) // TILE
    rows = (view.camera.height + TILE - 1) // TILE
    first_column = int(max(floor((middle[0] - right) / float(TILE)), 0.0))
    last_column = int(max(min(floor((middle[0] + right) / float(TILE)), float(columns - 1)), -1.0))
    first_row = int(max(floor((middle[1] - below) / float(TILE)), 0.0))
    last_row = int(max(min(floor((middle[1] + below) / float(TILE)), float(rows - 1)), -1.0))
    return vec4i(first_column, last_column, first_row, last_row)


@kernel
def project_splats_kernel(
    splats: SplatColumns,
    view: View,
    eye: vec3,
    near: float,
    share: float,
    projected: ProjectedSplats,
    counts: array(dtype=int32),
):
    """Where each splat lies in the picture, and in how many tiles."""
    i = tid()
    q = to_camera(splats.points[i], view)
    box = vec4i(0, -1, 0, -1)
    logit = splats.opacities[i]
    opacity = share / (1.0 + exp_in_float(-logit))
    is_number = 1 if isfinite(logit) or logit > 0.0 else 0
    for k in range(3):
        scale = splats.scales[i, k]
        if not (isfinite(scale) or scale < 0.0):
            is_number = 0
    if isfinite(q) and q[2] > near and opacity >= FAINTEST and is_number == 1:
        unit = length(vec3(view.rotation[0, 0], view.rotation[0, 1], view.rotation[0, 2]))
        turn = axes_before_camera(axes_of(i, splats), view.rotation, unit)
        scales = vec3(0.0)
        for k in range(3):
            scales[k] = exp_in_float(splats.scales[i, k]) * unit
        shape = ellipse_of(q, turn, scales, view)
        if isfinite(shape[0]) and isfinite(shape[2]) and isfinite(shape[3]):
            middle = project(q, view)
            limit = log(opacity / FAINTEST) * 1.001 + 1.0e-4
            reach = sqrt(2.0 * limit)
            box = tiles_of(middle, reach * sqrt(shape[0]) + 0.01, reach * sqrt(shape[2]) + 0.01, view)
            projected.middles[i] = middle
            projected.conics[i] = vec3(shape[2], -shape[1], shape[0]) / shape[3]
            projected.opacities[i] = opacity
            projected.limits[i] = limit
            towards = splats.points[i] - eye
            projected.colors[i] = color_towards(i, towards / length(towards), splats)
            if projected.depths.shape[0] > 0:
                note_surface(i, q, turn, scales, projected)
    tiles = 0
    if box[1] >= box[0] and box[3] >= box[2]:
        tiles = (box[1] - box[0] + 1) * (box[3] - box[2] + 1)
    projected.boxes[i] = box
    counts[i] = tiles


def project_splats(
    splats: SplatColumns, view: View, eye: np.ndarray, near: float, share: float, *, surfaces: bool
) -> tuple[ProjectedSplats, Integers]:
    """Splats before a camera, and in how many tiles each lies.

    Args:
        splats: The splats.
        view: The camera in pixels, and the frame of the points in it.
        eye: Where the camera is in the frame of the points [3].
        near: Least depth, in the view's unit.
        share: What opacities are multiplied by.
        surfaces: Whether `meet_splat` is to be asked.
    """
    count, device = splats.points.size, splats.points.device
    projected = ProjectedSplats(count, device, surfaces=surfaces)
    counts = empty(count, int32, device)
    launch(project_splats_kernel, count, [splats, view, vec3(*eye), near, share, projected, counts])
    return projected, counts
