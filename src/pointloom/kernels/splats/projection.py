"""Projection of splats to image ellipses and colors.

Affine approximation at the center (Zwicker et al., "EWA splatting", IEEE TVCG 2002) plus 0.3 px^2 variance, as in
training (Kerbl et al. 2023). Ray depth is that of maximum density (Zhang et al., "RaDe-GS", 2024, section 3). Only + -
* /, sqrt and `exp_in_float`, so images are bitwise identical.
"""

import numpy as np

from ..algebra.exponential import exp_in_float
from ..array_types import Array2, Device, Integers, Points, Scalars
from ..drawing.z_buffer import View, project, ray_through, to_camera
from ..lang import (
    array,
    compute,
    cross,
    dot,
    float32,
    floor,
    func,
    int32,
    isfinite,
    kernel,
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

TILE_SIDE = 16  # [px] tile side
TILE_PIXELS = TILE_SIDE * TILE_SIDE
VARIANCE_BLUR = 0.3  # [px^2] added to the image variance
MIN_OPACITY = 1.0 / 255.0  # opacity below which a splat is skipped in a pixel
MAX_OPACITY = 0.99  # per splat and pixel: the background stays visible
CLAMP_MARGIN = 0.15  # of the image size: beyond, the tangent map is clamped
MIN_AXIS_RATIO = 1.0e-4  # of the longest axis: minimum of the shortest axis
MAX_DEVIATIONS = 3.0  # standard deviations along the ray, beyond which a splat is not hit


@struct
class SplatColumns:
    """Splats as in files: logit `opacities`; logarithmic `scales`. Quaternions w, x, y, z; harmonics `first` (n, 3) and
    `rest` (n, 3 (K - 1)), red, green, blue. Their factors `sizes` (K).
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
    """`middles`: column, row [px], depth; `conics`: (a, b, c) of the exponent -(a x^2 + 2 b x y + c y^2) / 2; `limits`:
    negative exponent beyond which nothing is visible; `boxes`: tile columns and rows, reversed if invisible. For
    surfaces: `diagonals`, `others`: A00 A11 A22 and A01 A02 A12 of the inverse covariance A times the squared shortest
    axis; `pulls`: A times the center; `normals`: shortest axis; `depths`: maximum ray depth offset.
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
        surface_count = count if surfaces else 0
        self.diagonals, self.others, self.pulls, self.normals = (empty(surface_count, vec3, device) for _ in range(4))
        self.depths = empty(surface_count, float32, device)


@func
def axes_of(i: int, splats: SplatColumns) -> mat33:
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
    """Axes under a scaled rotation, without the scale."""
    rotated = mat33(0.0)
    for k in range(3):
        axis = rotation @ vec3(axes[0, k], axes[1, k], axes[2, k])
        for row in range(3):
            rotated[row, k] = axis[row] / unit
    return rotated


@func
def color_towards(i: int, direction: vec3, splats: SplatColumns) -> vec3:
    """Color along a unit vector from the camera: 0.5 plus harmonics, by recursion over order and band."""
    rest = (splats.degree + 1) * (splats.degree + 1) - 1
    color = vec3(splats.first[i, 0], splats.first[i, 1], splats.first[i, 2]) * splats.sizes[0]
    cosine = 1.0
    sine = 0.0
    start = 1.0  # Legendre function of a band at its own order
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
        next_cosine = direction[0] * cosine - direction[1] * sine
        sine = direction[0] * sine + direction[1] * cosine
        cosine = next_cosine
        start = start * float(2 * m + 1)
    return vec3(max(color[0] + 0.5, 0.0), max(color[1] + 0.5, 0.0), max(color[2] + 0.5, 0.0))


@func
def scaled_inverse(axes: mat33, scales: vec3) -> mat33:
    """Inverse covariance times the squared shortest axis: entries of at most 1."""
    shortest = max(
        min(min(scales[0], scales[1]), scales[2]), MIN_AXIS_RATIO * max(max(scales[0], scales[1]), scales[2])
    )
    total = mat33(0.0)
    for k in range(3):
        ratio = shortest / max(scales[k], shortest)
        axis = vec3(axes[0, k], axes[1, k], axes[2, k]) * ratio
        for row in range(3):
            for column in range(3):
                total[row, column] = total[row, column] + axis[row] * axis[column]
    return total


@func
def note_surface(i: int, q: vec3, axes: mat33, scales: vec3, projected: ProjectedSplats):
    A = scaled_inverse(axes, scales)
    projected.diagonals[i] = vec3(A[0, 0], A[1, 1], A[2, 2])
    projected.others[i] = vec3(A[0, 1], A[0, 2], A[1, 2])
    projected.pulls[i] = A @ q
    shortest = 0
    for k in range(1, 3):
        if scales[k] < scales[shortest]:
            shortest = k
    normal = vec3(axes[0, shortest], axes[1, shortest], axes[2, shortest])
    if dot(normal, q) > 0.0:
        normal = -normal
    projected.normals[i] = normal
    spread = 0.0
    for k in range(3):
        spread = spread + axes[2, k] * axes[2, k] * scales[k] * scales[k]
    projected.depths[i] = MAX_DEVIATIONS * sqrt(spread)


@func
def ellipse_of(q: vec3, axes: mat33, scales: vec3, view: View) -> vec4:
    """Image covariance a b c of a splat [px^2] and the determinant."""
    fx = float(view.camera.fx)
    fy = float(view.camera.fy)
    left = ray_through(-CLAMP_MARGIN * float(view.camera.width), -CLAMP_MARGIN * float(view.camera.height), view)
    right = ray_through(
        (1.0 + CLAMP_MARGIN) * float(view.camera.width), (1.0 + CLAMP_MARGIN) * float(view.camera.height), view
    )
    x = min(max(q[0] / q[2], left[0]), right[0])
    y = min(max(q[1] / q[2], left[1]), right[1])
    across = vec3(0.0)
    down = vec3(0.0)
    for k in range(3):
        across[k] = (axes[0, k] - x * axes[2, k]) * scales[k] * (fx / q[2])
        down[k] = (axes[1, k] - y * axes[2, k]) * scales[k] * (fy / q[2])
    a = dot(across, across) + VARIANCE_BLUR
    c = dot(down, down) + VARIANCE_BLUR
    area = cross(across, down)  # its square equals a c - b b without cancellation
    return vec4(a, dot(across, down), c, dot(area, area) + VARIANCE_BLUR * (a + c - VARIANCE_BLUR))


@func
def tiles_of(middle: vec3, right: float, below: float, view: View) -> vec4i:
    """Tile box of a rectangle: first and last column, first and last row."""
    columns = (view.camera.width + TILE_SIDE - 1) // TILE_SIDE
    rows = (view.camera.height + TILE_SIDE - 1) // TILE_SIDE
    first_column = int(max(floor((middle[0] - right) / float(TILE_SIDE)), 0.0))
    last_column = int(max(min(floor((middle[0] + right) / float(TILE_SIDE)), float(columns - 1)), -1.0))
    first_row = int(max(floor((middle[1] - below) / float(TILE_SIDE)), 0.0))
    last_row = int(max(min(floor((middle[1] + below) / float(TILE_SIDE)), float(rows - 1)), -1.0))
    return vec4i(first_column, last_column, first_row, last_row)


@kernel
def project_splats_kernel(
    splats: SplatColumns,
    view: View,
    eye: vec3,
    near: float,
    fraction: float,
    projected: ProjectedSplats,
    counts: array(dtype=int32),
):
    i = tid()
    q = to_camera(splats.points[i], view)
    box = vec4i(0, -1, 0, -1)
    logit = splats.opacities[i]
    opacity = fraction / (1.0 + exp_in_float(-logit))
    is_number = 1 if isfinite(logit) or logit > 0.0 else 0
    for k in range(3):
        scale = splats.scales[i, k]
        if not (isfinite(scale) or scale < 0.0):
            is_number = 0
    if isfinite(q) and q[2] > near and opacity >= MIN_OPACITY and is_number == 1:
        unit = length(vec3(view.rotation[0, 0], view.rotation[0, 1], view.rotation[0, 2]))
        axes = axes_before_camera(axes_of(i, splats), view.rotation, unit)
        scales = vec3(0.0)
        for k in range(3):
            scales[k] = exp_in_float(splats.scales[i, k]) * unit
        shape = ellipse_of(q, axes, scales, view)
        if isfinite(shape[0]) and isfinite(shape[2]) and isfinite(shape[3]):
            middle = project(q, view)
            limit = log(opacity / MIN_OPACITY) * 1.001 + 1.0e-4
            radius = sqrt(2.0 * limit)
            box = tiles_of(middle, radius * sqrt(shape[0]) + 0.01, radius * sqrt(shape[2]) + 0.01, view)
            projected.middles[i] = middle
            projected.conics[i] = vec3(shape[2], -shape[1], shape[0]) / shape[3]
            projected.opacities[i] = opacity
            projected.limits[i] = limit
            toward = splats.points[i] - eye
            projected.colors[i] = color_towards(i, toward / length(toward), splats)
            if projected.depths.shape[0] > 0:
                note_surface(i, q, axes, scales, projected)
    tiles = 0
    if box[1] >= box[0] and box[3] >= box[2]:
        tiles = (box[1] - box[0] + 1) * (box[3] - box[2] + 1)
    projected.boxes[i] = box
    counts[i] = tiles


def project_splats(
    splats: SplatColumns, view: View, eye: np.ndarray, near: float, fraction: float, *, surfaces: bool
) -> tuple[ProjectedSplats, Integers]:
    """Project splats: they and their tile counts. `fraction`: opacity factor; `surfaces`: prepare `meet_splat`."""
    count, device = splats.points.size, splats.points.device
    projected = ProjectedSplats(count, device, surfaces=surfaces)
    counts = compute(project_splats_kernel, count, [splats, view, vec3(*eye), near, fraction, projected], int32, device)
    return projected, counts
