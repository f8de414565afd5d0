"""Points in the order of a Hilbert curve: neighbours in space become neighbours in memory.

Source: Skilling, "Programming the Hilbert curve", AIP Conf. Proc. 707, 2004 (AxesToTranspose). 12 B read and 8 B
written a point, about 20 operations a level. The curve only chooses an order; nothing depends on its resolution but
speed.
"""

import numpy as np

from ..array_types import Integers, LongIntegers, Points
from ..arrays.bounds import bound_points, find_box
from ..arrays.sort import SortKeys, put_key
from ..lang import array, float32, float64, func, int32, int64, isfinite, kernel, launch, struct, tid, vec3, vector

LANES = 8  # points a thread: their codes are computed side by side in vector registers
lanes = vector(8, int32)
lane_codes = vector(8, int64)
SMALLEST_EXTENT = 1e-33  # [m] below it the scale is beyond float32
MAX_LEVELS = 16  # 65,536 cells an axis: a millimetre in a city block


@struct
class HilbertCurve:
    """A curve through 2^levels cells an axis of a box.

    Attributes:
        low: The box's low corner.
        scale: Cells a metre; 0, one cell, where the box is too small or empty.
        levels: Halvings of the box.
    """

    low: vec3
    scale: float
    levels: int

    def __init__(self, low: np.ndarray, high: np.ndarray, levels: int, *, is_empty: bool = False) -> None:
        extent = float((high.astype(np.float64) - low).max())
        self.low = vec3(0.0) if is_empty else vec3(*low)
        self.scale = (2**levels - 1) / extent if extent > SMALLEST_EXTENT else 0.0
        self.levels = levels

    @property
    def code_bits(self) -> int:
        """Bits of a code, that of points that are not finite included."""
        return 3 * self.levels + 1


@func
def spread_bits(v: int) -> int64:
    """Two zeros between the lowest 16 bits of v."""
    x = int64(v)
    x = (x | (x << 32)) & 0x1F00000000FFFF
    x = (x | (x << 16)) & 0x1F0000FF0000FF
    x = (x | (x << 8)) & 0x100F00F00F00F00F
    x = (x | (x << 4)) & 0x10C30C30C30C30C3
    return (x | (x << 2)) & 0x1249249249249249


@func
def hilbert_codes(cx: lanes, cy: lanes, cz: lanes, levels: int) -> lane_codes:
    """The places of cells on the Hilbert curve through 2^levels cells an axis, eight at a time and without branches."""
    x = cx
    y = cy
    z = cz
    for level in range(1, levels):
        shift = levels - level
        low = (1 << shift) - 1
        for j in range(LANES):
            x[j] = x[j] ^ (low & -((x[j] >> shift) & 1))
            set_y = -((y[j] >> shift) & 1)
            swapped = (x[j] ^ y[j]) & low & ~set_y
            x[j] = x[j] ^ ((low & set_y) | swapped)
            y[j] = y[j] ^ swapped
            set_z = -((z[j] >> shift) & 1)
            exchanged = (x[j] ^ z[j]) & low & ~set_z
            x[j] = x[j] ^ ((low & set_z) | exchanged)
            z[j] = z[j] ^ exchanged
    codes = lane_codes(0)
    for j in range(LANES):
        y[j] = y[j] ^ x[j]
        z[j] = z[j] ^ y[j]
        # the parity of the bits above each bit of z
        flip = z[j] ^ (z[j] >> 1)
        flip = flip ^ (flip >> 2)
        flip = flip ^ (flip >> 4)
        flip = (flip ^ (flip >> 8)) >> 1
        x[j] = x[j] ^ flip
        y[j] = y[j] ^ flip
        z[j] = z[j] ^ flip
        codes[j] = (spread_bits(x[j]) << 2) | (spread_bits(y[j]) << 1) | spread_bits(z[j])
    return codes


@func
def cell_on_axis(coordinate: float, low: float, scale: float, levels: int) -> int:
    """The cell of a coordinate; the nearest one of coordinates outside the box."""
    top = float((1 << levels) - 1)
    return int(min(max((coordinate - low) * scale, 0.0), top))


@func
def locate_on_curve(p: vec3, curve: HilbertCurve) -> int64:
    """The code of a point; points outside the box take the nearest cell."""
    x = lanes(cell_on_axis(p[0], curve.low[0], curve.scale, curve.levels))
    y = lanes(cell_on_axis(p[1], curve.low[1], curve.scale, curve.levels))
    z = lanes(cell_on_axis(p[2], curve.low[2], curve.scale, curve.levels))
    codes = hilbert_codes(x, y, z, curve.levels)
    return codes[0]


@func
def put_eight(head: int, step: int, points: array(dtype=vec3), low: vec3, scale: float, levels: int, codes: SortKeys):
    """The codes of eight points, `step` places from one to the next; points that are not finite come last."""
    last = points.shape[0] - 1
    x = lanes(0)
    y = lanes(0)
    z = lanes(0)
    for j in range(LANES):
        p = points[min(head + j * step, last)]
        x[j] = cell_on_axis(p[0], low[0], scale, levels)
        y[j] = cell_on_axis(p[1], low[1], scale, levels)
        z[j] = cell_on_axis(p[2], low[2], scale, levels)
    places = hilbert_codes(x, y, z, levels)
    for j in range(LANES):
        place = head + j * step
        if place <= last:
            p = points[place]
            code = 1 << int64(3 * levels)
            if isfinite(p):
                code = places[j]
            put_key(place, code, codes)


@kernel
def encode_points_kernel(points: array(dtype=vec3), curve: HilbertCurve, apart: int, step: int, codes: SortKeys):
    """The codes of eight points on a curve."""
    i = tid()
    put_eight(i * apart, step, points, curve.low, curve.scale, curve.levels, codes)


@kernel
def encode_in_box_kernel(
    points: array(dtype=vec3), box: array(dtype=float32), levels: int, apart: int, step: int, codes: SortKeys
):
    """The codes of eight points on the curve through a box: its low corner, then its high one."""
    i = tid()
    extent = float64(0.0)
    for axis in range(3):
        extent = max(extent, float64(box[axis + 3]) - float64(box[axis]))
    scale = 0.0
    if extent > float64(SMALLEST_EXTENT):
        scale = float(float64((1 << levels) - 1) / extent)
    put_eight(i * apart, step, points, vec3(box[0], box[1], box[2]), scale, levels, codes)


def _threads_of_eight(points: Points) -> tuple[int, int, int]:
    """Threads of eight points each, and how far a thread's first point is from the next thread's, and its own apart."""
    threads = -(-points.size // LANES)
    # on the CPU the eight stand side by side, on CUDA those of threads side by side do
    return (threads, 1, threads) if points.device.is_cuda else (threads, LANES, 1)


def order_in_box(points: Points, levels: int) -> Integers:
    """The order of points along the curve through their box, int32 [n]; no sync. As of `argsort_along`."""
    codes, (threads, apart, step) = SortKeys(points.size, points.device), _threads_of_eight(points)
    launch(encode_in_box_kernel, threads, [points, find_box(points), levels, apart, step, codes])
    return codes.sort(3 * levels + 1)[1]


def encode_points(points: Points, curve: HilbertCurve) -> SortKeys:
    """The code of each point on a curve, as SortKeys; 8^levels for points that are not finite."""
    codes, (threads, apart, step) = SortKeys(points.size, points.device), _threads_of_eight(points)
    launch(encode_points_kernel, threads, [points, curve, apart, step, codes])
    return codes


def argsort_along(points: Points, curve: HilbertCurve) -> tuple[LongIntegers, Integers]:
    """(sorted codes, order) of points along a curve, int64 [n] and int32 [n]; points that are not finite stand last."""
    return encode_points(points, curve).sort(curve.code_bits)


def levels_for(count: int) -> int:
    """The levels of a curve whose codes and the indices of so many points fit into 62 bits."""
    return min(MAX_LEVELS, (62 - max(1, (count - 1).bit_length() if count else 1)) // 3)


class HilbertOrder:
    """The order of a cloud's finite points along a curve through their box, or along a given one.

    Parts of a cloud along the curve of the whole have the order that their points have in the whole.

    Attributes:
        order: int32 [n], positions in the cloud by rank on the curve; points that are not finite stand last.
        codes: int64 [n], sorted.
        finite_count: Points that are finite.
        low, high: The box of the finite points, float32 [3].
        curve: The HilbertCurve.
    """

    def __init__(self, points: Points, curve: HilbertCurve | None = None) -> None:
        self.low, self.high, self.finite_count = bound_points(points)
        levels = levels_for(points.size)
        self.curve = curve or HilbertCurve(self.low, self.high, levels, is_empty=not self.finite_count)
        self.codes, self.order = argsort_along(points, self.curve)
