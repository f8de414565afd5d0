"""8-bit colors of a rendered model."""

from ..array_types import Array2, Scalars, Vectors
from ..lang import array, float32, floor, func, kernel, launch, tid, uint8, vec3
from ..memory import empty

EMPTY_COLOR = 0.5  # color of empty pixels


@func
def round_half_even(x: float) -> int:
    """Nearest integer of a non-negative number, halves to even."""
    up = floor(x + 0.5)
    nearest = int(up)
    if up - x == 0.5 and nearest % 2 == 1:
        nearest = nearest - 1
    return nearest


@kernel
def write_colors_kernel(depth: array(dtype=float32), colors: array(dtype=vec3), pixels: array(dtype=uint8, ndim=2)):
    i = tid()
    color = vec3(EMPTY_COLOR, EMPTY_COLOR, EMPTY_COLOR)
    if depth[i] > 0.0:
        color = colors[i]
    for k in range(3):
        pixels[i, k] = uint8(round_half_even(255.0 * color[k]))


def colors_of(depth: Scalars, colors: Vectors) -> Array2[uint8]:
    """8-bit colors (pixels, 3) of a rendered model, gray where its depth is 0."""
    pixels = empty((depth.size, 3), uint8, depth.device)
    launch(write_colors_kernel, depth.size, [depth, colors, pixels])
    return pixels
