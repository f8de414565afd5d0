"""Undistortion: lens images to pinhole images. Positions are computed once per camera in float64, then each image is
sampled bilinearly, after averaging if it shrinks by two or more. Only + - * / and square roots: bitwise identical
everywhere. The lens models are those of cameras/lens_projection.py.
"""

from typing import Any

from ..algebra.angles import angle_of
from ..algebra.camera import Camera, CameraLike
from ..array_types import Array1, Array2, Device, Mask
from ..lang import array, compute, float64, floor, func, kernel, launch, sqrt, struct, tid, uint8, vec2, vec2d
from ..memory import empty

PERSPECTIVE_LENS, EQUIDISTANT_LENS, FIELD_OF_VIEW_LENS, DIVISION_LENS, UNIFIED_LENS = 0, 1, 2, 3, 4
UNSEEN_POSITION = -1.0  # position outside the lens
MAX_FINITE_RADIUS = 1.0e30  # replaces an infinite radius


@struct
class LensOptics:
    """Lens parameters: `kind` of the radial mapping; radial `a1`-`a4` over `b1`-`b3`; tangential `p1`, `p2`; prism
    `s1`, `s2`; `shape`, `second` of some kinds; `max_radius`: maximum mapped radius.
    """

    kind: int
    width: int
    height: int
    fx: float64
    fy: float64
    cx: float64
    cy: float64
    skew: float64
    a1: float64
    a2: float64
    a3: float64
    a4: float64
    b1: float64
    b2: float64
    b3: float64
    p1: float64
    p2: float64
    s1: float64
    s2: float64
    shape: float64
    second: float64
    thin: int
    wide: float64
    max_radius: float64

    def __init__(self, lens: Any, width: int, height: int, max_radius: float, wide: float, thin: int) -> None:
        self.kind, self.width, self.height = lens.kind, width, height
        self.fx, self.fy = lens.focal
        self.cx, self.cy = lens.center
        self.skew = lens.skew
        self.a1, self.a2, self.a3, self.a4 = lens.radial
        self.b1, self.b2, self.b3 = lens.rational
        (self.p1, self.p2), (self.s1, self.s2) = lens.tangential, lens.prism
        self.shape, self.second = lens.shape
        self.thin, self.wide, self.max_radius = thin, wide, min(max_radius, MAX_FINITE_RADIUS)


@func
def shortened(r: float64, lens: LensOptics) -> float64:
    """Factor of the radial mapping at radius r, or -1 if there is no such ray."""
    factor = float64(1.0)
    if lens.kind == EQUIDISTANT_LENS and r > 0.0:
        factor = angle_of(r, 1.0) / r
    if lens.kind == FIELD_OF_VIEW_LENS:
        if lens.thin == 1:
            factor = lens.shape * lens.shape * (r * r / 3.0 - float64(1.0) / float64(12.0)) + 1.0
        elif r > 0.0:
            factor = angle_of(r * lens.wide, 1.0) / (r * lens.shape)
        else:
            factor = lens.wide / lens.shape
    if lens.kind == DIVISION_LENS:
        inside = 1.0 - 4.0 * lens.shape * r * r
        factor = -1.0
        if inside >= 0.0:
            factor = 2.0 / (1.0 + sqrt(inside))
    if lens.kind == UNIFIED_LENS:
        inside = lens.second * r * r + 1.0
        factor = -1.0
        if inside >= 0.0:
            below = lens.shape * sqrt(inside) + (1.0 - lens.shape)
            if below > 0.0:
                factor = 1.0 / below
    return factor


@func
def distorted_position(x: float64, y: float64, lens: LensOptics) -> vec2d:
    """Column and row of a radially mapped position (x, y)."""
    t = x * x + y * y
    above = 1.0 + t * (lens.a1 + t * (lens.a2 + t * (lens.a3 + t * lens.a4)))
    below = 1.0 + t * (lens.b1 + t * (lens.b2 + t * lens.b3))
    factor = above / below
    two = float64(2.0)
    p = x * factor + two * lens.p1 * x * y + lens.p2 * (t + two * x * x) + lens.s1 * t
    q = y * factor + two * lens.p2 * x * y + lens.p1 * (t + two * y * y) + lens.s2 * t
    return vec2d(lens.fx * p + lens.skew * q + lens.cx, lens.fy * q + lens.cy)


@kernel
def find_lens_positions_kernel(lens: LensOptics, camera: Camera, positions: array(dtype=vec2)):
    """Lens image position of a pinhole pixel, clamped to half a pixel within the border."""
    i = tid()
    x = (float64(i % camera.width) - camera.cx) / camera.fx
    y = (float64(i // camera.width) - camera.cy) / camera.fy
    factor = shortened(sqrt(x * x + y * y), lens)
    position = vec2(UNSEEN_POSITION, UNSEEN_POSITION)
    x = x * factor
    y = y * factor
    if factor > 0.0 and x * x + y * y <= lens.max_radius * lens.max_radius:
        p = distorted_position(x, y, lens)
        right = float64(lens.width) - 0.5
        bottom = float64(lens.height) - 0.5
        if p[0] >= -0.5 and p[1] >= -0.5 and p[0] <= right and p[1] <= bottom:
            position = vec2(
                min(max(float(p[0]), 0.0), float(lens.width - 1)), min(max(float(p[1]), 0.0), float(lens.height - 1))
            )
    positions[i] = position


@kernel
def average_squares_kernel(
    pixels: array(dtype=uint8, ndim=2),
    width: int,
    height: int,
    columns: int,
    side: int,
    channels: int,
    averages: array(dtype=uint8, ndim=2),
):
    """Rounded mean of side x side pixels, clipped at the right and lower border."""
    i = tid()
    left = (i % columns) * side
    top = (i // columns) * side
    right = min(left + side, width)
    bottom = min(top + side, height)
    count = (right - left) * (bottom - top)
    for channel in range(channels):
        total = 0
        for v in range(top, bottom):
            for u in range(left, right):
                total += int(pixels[v * width + u, channel])
        averages[i, channel] = uint8((2 * total + count) // (2 * count))


@kernel
def sample_image_kernel(
    pixels: array(dtype=uint8, ndim=2),
    width: int,
    height: int,
    side: float,
    channels: int,
    positions: array(dtype=vec2),
    straight: array(dtype=uint8, ndim=2),
):
    """Bilinear image values at positions. 0 outside the lens. Pixels are squares of `side` of the positions' pixels."""
    i = tid()
    position = positions[i]
    if position[0] < 0.0:
        for channel in range(channels):
            straight[i, channel] = 0
    else:
        x = min(max((position[0] + 0.5) / side - 0.5, 0.0), float(width - 1))
        y = min(max((position[1] + 0.5) / side - 0.5, 0.0), float(height - 1))
        left = int(floor(x))
        top = int(floor(y))
        right = min(left + 1, width - 1)
        bottom = min(top + 1, height - 1)
        across = x - float(left)
        down = y - float(top)
        for channel in range(channels):
            a = float(int(pixels[top * width + left, channel]))
            b = float(int(pixels[top * width + right, channel]))
            c = float(int(pixels[bottom * width + left, channel]))
            d = float(int(pixels[bottom * width + right, channel]))
            upper = a + (b - a) * across
            lower = c + (d - c) * across
            straight[i, channel] = uint8(int(floor(upper + (lower - upper) * down + 0.5)))


@kernel
def mask_visible_kernel(positions: array(dtype=vec2), visible: array(dtype=uint8)):
    i = tid()
    mark = 0
    if positions[i][0] >= 0.0:
        mark = 1
    visible[i] = uint8(mark)


def find_lens_positions(lens: LensOptics, camera: CameraLike, device: Device) -> Array1[vec2]:
    """Lens image position of each pinhole pixel, vec2 (height * width); (-1, -1) if it is not visible."""
    return compute(find_lens_positions_kernel, camera.width * camera.height, [lens, camera], vec2, device)


def sample_image(pixels: Array2[uint8], width: int, height: int, side: int, positions: Array1[vec2]) -> Array2[uint8]:
    """Sample an image, uint8 (height * width, channels), at positions; squares of `side` pixels are averaged before."""
    channels = pixels.shape[1]
    if side > 1:
        columns, rows = -(-width // side), -(-height // side)
        averages = empty((rows * columns, channels), uint8, pixels.device)
        launch(average_squares_kernel, rows * columns, [pixels, width, height, columns, side, channels, averages])
        pixels, width, height = averages, columns, rows
    straight = empty((positions.size, channels), uint8, pixels.device)
    launch(sample_image_kernel, positions.size, [pixels, width, height, float(side), channels, positions, straight])
    return straight


def mask_visible(positions: Array1[vec2]) -> Mask:
    return compute(mask_visible_kernel, positions.size, [positions], uint8, positions.device)
