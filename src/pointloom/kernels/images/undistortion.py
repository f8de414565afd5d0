"""Undistortion: lens images to pinhole images. Positions are computed once per camera in float64, then each image is
sampled bilinearly, after averaging if it shrinks by two or more. Only + - * / and square roots: bitwise identical
everywhere. The lens models are those of cameras/lens_projection.py, whose `Lens` the kernels read.
"""

from typing import Any

from ..algebra.angles import angle_of
from ..algebra.camera import Camera, CameraLike
from ..array_types import Array1, Array2, Device, Mask
from ..lang import array, compute, float64, func, kernel, launch, sqrt, struct, tid, uint8, vec2, vec2d, vec3d, vec4d
from ..memory import empty

PERSPECTIVE, EQUIDISTANT, FIELD_OF_VIEW, DIVISION, UNIFIED = 0, 1, 2, 3, 4  # kinds of radial mapping
UNSEEN_POSITION = -1.0  # position outside the lens


@struct
class LensOptics:
    """A lens for kernels: the fields of a `Lens` of cameras/lens_projection.py."""

    kind: int
    focal: vec2d
    center: vec2d
    skew: float64
    radial: vec4d
    rational: vec3d
    tangential: vec2d
    prism: vec2d
    shape: vec2d
    chord: float64
    max_radius: float64


@func
def shortened(r: float64, lens: LensOptics) -> float64:
    """Factor of the radial mapping at radius r, or -1 if there is no such ray."""
    factor = float64(1.0)
    if lens.kind == EQUIDISTANT and r > 0.0:
        factor = angle_of(r, 1.0) / r
    if lens.kind == FIELD_OF_VIEW:
        if lens.chord == 0.0:
            factor = lens.shape[0] * lens.shape[0] * (r * r / 3.0 - float64(1.0) / float64(12.0)) + 1.0
        elif r > 0.0:
            factor = angle_of(r * lens.chord, 1.0) / (r * lens.shape[0])
        else:
            factor = lens.chord / lens.shape[0]
    if lens.kind == DIVISION:
        inside = 1.0 - 4.0 * lens.shape[0] * r * r
        factor = -1.0
        if inside >= 0.0:
            factor = 2.0 / (1.0 + sqrt(inside))
    if lens.kind == UNIFIED:
        inside = lens.shape[1] * r * r + 1.0
        factor = -1.0
        if inside >= 0.0:
            below = lens.shape[0] * sqrt(inside) + (1.0 - lens.shape[0])
            if below > 0.0:
                factor = 1.0 / below
    return factor


@func
def distorted_position(x: float64, y: float64, lens: LensOptics) -> vec2d:
    """Column and row of a radially mapped position (x, y)."""
    t = x * x + y * y
    above = 1.0 + t * (lens.radial[0] + t * (lens.radial[1] + t * (lens.radial[2] + t * lens.radial[3])))
    below = 1.0 + t * (lens.rational[0] + t * (lens.rational[1] + t * lens.rational[2]))
    factor = above / below
    two = float64(2.0)
    p = x * factor + two * lens.tangential[0] * x * y + lens.tangential[1] * (t + two * x * x) + lens.prism[0] * t
    q = y * factor + two * lens.tangential[1] * x * y + lens.tangential[0] * (t + two * y * y) + lens.prism[1] * t
    return vec2d(lens.focal[0] * p + lens.skew * q + lens.center[0], lens.focal[1] * q + lens.center[1])


@kernel
def find_lens_positions_kernel(lens: LensOptics, width: int, height: int, camera: Camera, positions: array(dtype=vec2)):
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
        right = float64(width) - 0.5
        bottom = float64(height) - 0.5
        if p[0] >= -0.5 and p[1] >= -0.5 and p[0] <= right and p[1] <= bottom:
            position = vec2(min(max(float(p[0]), 0.0), float(width - 1)), min(max(float(p[1]), 0.0), float(height - 1)))
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
        left = int(x)
        top = int(y)
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
            straight[i, channel] = uint8(int(upper + (lower - upper) * down + 0.5))


@kernel
def mask_visible_kernel(positions: array(dtype=vec2), visible: array(dtype=uint8)):
    i = tid()
    mark = 0
    if positions[i][0] >= 0.0:
        mark = 1
    visible[i] = uint8(mark)


def find_lens_positions(lens: Any, width: int, height: int, camera: CameraLike, device: Device) -> Array1[vec2]:
    """Position of each pinhole pixel in the image of a lens, vec2 (height * width); (-1, -1) if it is not visible."""
    count = camera.width * camera.height
    return compute(find_lens_positions_kernel, count, [lens, width, height, camera], vec2, device)


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
