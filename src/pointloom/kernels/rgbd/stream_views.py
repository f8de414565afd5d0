"""Small views (about 80 x 60 cells) of color and depth, and the global shift of color between frames by least squares
(Lucas and Kanade 1981). A cell has mean brightness and mean inverse depth. Near depth can be hidden to separate layers.
"""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..array_types import Array2, Device, Mask, Scalars
from ..arrays.side_by_side import read_together
from ..lang import array, compute, float32, float64, kernel, launch, reduce, reduction, struct, tid, uint8, vector
from ..memory import download, empty, rows_of, zeros
from .pyramid import NO_COLOR, luma


@kernel
def hide_near_kernel(depth: array(dtype=float32), limit: float, far: array(dtype=float32)):
    i = tid()
    d = depth[i]
    value = 0.0
    if d > limit:
        value = d
    far[i] = value


def hide_near(depth: Scalars, limit: float) -> Scalars:
    """Depth [m], float32 (pixels), beyond a limit [m] only."""
    return compute(hide_near_kernel, depth.size, [depth, limit], float32, depth.device)


@kernel
def hide_cells_kernel(
    depth: array(dtype=float32), hidden: array(dtype=uint8), width: int, side: int, columns: int, rows: int,
    shown: array(dtype=float32),
):  # fmt: skip
    i = tid()
    u = i % width // side
    v = i // width // side
    value = depth[i]
    if u < columns and v < rows:
        if hidden[v * columns + u] != uint8(0):
            value = 0.0
    shown[i] = value


CELLS_PER_ROW = 80  # per view width: a cell of VGA is 8 x 8 pixels, so fast rotations move by few cells
MIN_DEPTH_FRACTION = 0.75  # minimum fraction of a cell's pixels with depth
stream_sums = vector(8, float64)
BRIGHTNESS_AT = 0  # offset of the sums of brightness: squared gradients u u, u v, v v, then u d, v d
# Cells whose nearness changed. Cells with nearness. Squared differences
CHANGED_AT, MEASURED_AT, SHADE_SQUARES_AT = 5, 6, 7


@struct
class StreamView:
    """Downsampled frame: mean `brightness`, below 0 without color. Mean `nearness` 1 / z [1/m], 0 if sparse."""

    brightness: array(dtype=float32)
    nearness: array(dtype=float32)

    def __init__(self, columns: int, rows: int, device: Device) -> None:
        self.columns, self.rows, count = columns, rows, columns * rows
        self.cells = empty(2 * count, float32, device)
        self.brightness, self.nearness = rows_of(self.cells, 0, count), rows_of(self.cells, count, 2 * count)

    @cached_property
    def host_cells(self) -> NDArray[np.float32]:
        """`brightness` and `nearness` on the host, float32 (2, rows, columns); one sync for all readers of a frame."""
        return download(self.cells).reshape(2, self.rows, self.columns)

    @property
    def host_brightness(self) -> NDArray[np.float32]:
        return self.host_cells[0]

    @property
    def host_nearness(self) -> NDArray[np.float32]:
        return self.host_cells[1]


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
    """A cell of a StreamView. Its pixels are `side` x `side`."""
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
    if count >= MIN_DEPTH_FRACTION * area:
        nearness[i] = near / count


@reduction
def sum_motion(now: StreamView, before: StreamView, columns: int, rows: int) -> stream_sums:
    """A cell's part of the normal equations of the colors' shift, and of the differences."""
    i = tid()
    u = i % columns
    v = i // columns
    out = stream_sums(0.0)
    a = now.nearness[i]
    b = before.nearness[i]
    if a != b:
        out[CHANGED_AT] = float64(1.0)
    if a > 0.0:
        out[MEASURED_AT] = float64(1.0)
    if now.brightness[i] >= 0.0 and before.brightness[i] >= 0.0:
        d = now.brightness[i] - before.brightness[i]
        out[SHADE_SQUARES_AT] = float64(d * d)
        if u > 0 and v > 0 and u < columns - 1 and v < rows - 1:
            x = now.brightness[i + 1] - now.brightness[i - 1] + before.brightness[i + 1] - before.brightness[i - 1]
            y = now.brightness[i + columns] - now.brightness[i - columns]
            y += before.brightness[i + columns] - before.brightness[i - columns]
            x = 0.25 * x
            y = 0.25 * y
            out[BRIGHTNESS_AT] = float64(x * x)
            out[BRIGHTNESS_AT + 1] = float64(x * y)
            out[BRIGHTNESS_AT + 2] = float64(y * y)
            out[BRIGHTNESS_AT + 3] = float64(x * d)
            out[BRIGHTNESS_AT + 4] = float64(y * d)
    return out


def view_stream(depth: Scalars, pixels: Array2[uint8] | None, width: int, height: int) -> StreamView:
    """StreamView of a frame: depth [m] float32 (height * width), 0 for none. 8-bit colors (pixels, 3) or None."""
    side = max(1, width // CELLS_PER_ROW)
    view = StreamView(max(width // side, 1), max(height // side, 1), depth.device)
    shown = zeros((1, 3), uint8, depth.device) if pixels is None else pixels
    arguments = [depth, shown, int(pixels is not None), width, side, view.columns, view.brightness, view.nearness]
    launch(view_stream_kernel, view.columns * view.rows, arguments)
    return view


def compare_views(now: StreamView, before: StreamView) -> NDArray[np.float64]:
    """Sums of `sum_motion` over two views of one size, float64 (8). The sync also reads the cells of `now`."""
    sums = reduce(sum_motion, now.columns * now.rows, [now, before, now.columns, now.rows])
    if "host_cells" in vars(now):
        return download(sums).reshape(-1)  # sync
    found, cells = read_together([sums, now.cells])  # sync
    now.host_cells = cells.reshape(2, now.rows, now.columns)
    return found.reshape(-1)


def hide_cells(depth: Scalars, hidden: Mask, view: StreamView, width: int) -> Scalars:
    """Depth [m], float32 (pixels), without the cells of a view where `hidden`, uint8 (cells), is not 0."""
    shown = empty(depth.size, float32, depth.device)
    side = max(1, width // CELLS_PER_ROW)
    launch(hide_cells_kernel, depth.size, [depth, hidden, width, side, view.columns, view.rows, shown])
    return shown
