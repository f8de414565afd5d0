"""Small views of a depth camera's two pictures, and how each moved from one frame to the next.

A view has some 80 x 60 cells: the mean brightness of each, and the mean nearness 1 / z of a cell that is measured all
over. How a picture moved is one shift for all of it, by least squares over the slopes of the mean of two views
(Lucas and Kanade 1981): few numbers that noise hardly touches, alike for colour and depth of one camera.

A view: one thread a cell, reads 7 B a pixel of it, writes 8 B. Two views: one thread a cell, reads 80 B, writes
nothing; 13 sums leave through the reduction.

Depth without what is near: one of the two layers of a picture that may move apart. One thread a pixel: reads 4 B,
writes 4 B.
"""

from typing import Any

from ..array_types import Array1, Array2, Device, Scalars
from ..lang import array, float32, float64, kernel, launch, reduce, reduction, struct, tid, uint8, vector
from ..memory import empty, zeros
from .pyramid import NO_COLOR, luma


@kernel
def hide_near_kernel(depth: array(dtype=float32), limit: float, far: array(dtype=float32)):
    """The depth where it is beyond a limit, else 0."""
    i = tid()
    d = depth[i]
    kept = 0.0
    if d > limit:
        kept = d
    far[i] = kept


def hide_near(depth: Scalars, limit: float) -> Scalars:
    """The depth [m], float32 [pixels], without what is no farther than a limit [m]."""
    far = empty(depth.size, float32, depth.device)
    launch(hide_near_kernel, depth.size, [depth, limit, far])
    return far


CELLS = 80  # of a view along its width: a cell of VGA is 8 x 8 pixels, so that a quick turn moves it by few cells
FULL = 0.75  # share of a cell's pixels with depth, from which on it has a nearness
stream_sums = vector(13, float64)
BRIGHT, NEAR = 0, 5  # where the sums of each picture begin: of squared slopes u u, u v, v v, then u d, v d
OTHER, MEASURED, SHADES = (
    10,
    11,
    12,
)  # cells whose nearness differs in any bit; cells that have one; squared differences


@struct
class StreamView:
    """A frame in few cells.

    Args:
        columns, rows: How many cells there are.
        device: Where they lie.

    Attributes:
        brightness: Mean of each cell, 0..1, below 0 without colour.
        nearness: Mean of 1 / z [1/m], 0 where less than three quarters of the cell are measured.
    """

    brightness: array(dtype=float32)
    nearness: array(dtype=float32)

    def __init__(self, columns: int, rows: int, device: Device) -> None:
        self.columns, self.rows = columns, rows
        self.brightness, self.nearness = (empty(columns * rows, float32, device) for _ in range(2))


@kernel
def view_stream_kernel(
    depth: array(dtype=float32),
    pixels: array(dtype=uint8, ndim=2),
    has_color: int,
    width: int,
    side: int,
    columns: int,
    brightness: array(dtype=float32),
    nearness: array(dtype=float32),
):
    """A cell of a StreamView; its pixels are `side` x `side`."""
    i = tid()
    first = i // columns * side * width + i % columns * side
    shade = 0.0
    near = 0.0
    count = 0.0
    for k in range(side * side):
        at = first + k // side * width + k % side
        z = depth[at]
        if z > 0.0:
            near += 1.0 / z
            count += 1.0
        if has_color == 1:
            shade += luma(at, pixels)
    area = float(side * side)
    brightness[i] = float(NO_COLOR)
    if has_color == 1:
        brightness[i] = shade / area
    nearness[i] = 0.0
    if count >= FULL * area:
        nearness[i] = near / count


@reduction
def sum_motion(now: StreamView, before: StreamView, columns: int, rows: int) -> stream_sums:
    """A cell's part of the normal equations of both shifts, and of what differs."""
    i = tid()
    u = i % columns
    v = i // columns
    out = stream_sums(0.0)
    a = now.nearness[i]
    b = before.nearness[i]
    if a != b:
        out[OTHER] = float64(1.0)
    if a > 0.0:
        out[MEASURED] = float64(1.0)
    if now.brightness[i] >= 0.0 and before.brightness[i] >= 0.0:
        d = now.brightness[i] - before.brightness[i]
        out[SHADES] = float64(d * d)
        if u > 0 and v > 0 and u < columns - 1 and v < rows - 1:
            x = now.brightness[i + 1] - now.brightness[i - 1] + before.brightness[i + 1] - before.brightness[i - 1]
            y = now.brightness[i + columns] - now.brightness[i - columns]
            y += before.brightness[i + columns] - before.brightness[i - columns]
            x = 0.25 * x
            y = 0.25 * y
            out[BRIGHT] = float64(x * x)
            out[BRIGHT + 1] = float64(x * y)
            out[BRIGHT + 2] = float64(y * y)
            out[BRIGHT + 3] = float64(x * d)
            out[BRIGHT + 4] = float64(y * d)
    if u > 0 and v > 0 and u < columns - 1 and v < rows - 1 and a > 0.0 and b > 0.0:
        least = min(min(now.nearness[i + 1], now.nearness[i - 1]), min(before.nearness[i + 1], before.nearness[i - 1]))
        least = min(least, min(now.nearness[i + columns], now.nearness[i - columns]))
        least = min(least, min(before.nearness[i + columns], before.nearness[i - columns]))
        if least > 0.0:
            x = now.nearness[i + 1] - now.nearness[i - 1] + before.nearness[i + 1] - before.nearness[i - 1]
            y = now.nearness[i + columns] - now.nearness[i - columns]
            y += before.nearness[i + columns] - before.nearness[i - columns]
            x = 0.25 * x
            y = 0.25 * y
            d = a - b
            out[NEAR] = float64(x * x)
            out[NEAR + 1] = float64(x * y)
            out[NEAR + 2] = float64(y * y)
            out[NEAR + 3] = float64(x * d)
            out[NEAR + 4] = float64(y * d)
    return out


def view_stream(depth: Scalars, pixels: Array2[uint8] | None, width: int, height: int) -> StreamView:
    """The StreamView of a frame.

    Args:
        depth: float32 device array [height * width] [m], 0 where there is none.
        pixels: 8-bit colours [height * width, 3], or None.
        width, height: Of both [px].
    """
    side = max(1, width // CELLS)
    view = StreamView(max(width // side, 1), max(height // side, 1), depth.device)
    shown = zeros((1, 3), uint8, depth.device) if pixels is None else pixels
    arguments = [depth, shown, int(pixels is not None), width, side, view.columns, view.brightness, view.nearness]
    launch(view_stream_kernel, view.columns * view.rows, arguments)
    return view


def compare_views(now: StreamView, before: StreamView) -> Array1[Any]:
    """The sums of `sum_motion` over two views of one size, float64 [1][13] on the device."""
    return reduce(sum_motion, now.columns * now.rows, [now, before, now.columns, now.rows])
