"""Points in the order of a Hilbert curve, for memory locality. Skilling, "Programming the Hilbert curve", AIP Conf.
Proc. 707, 2004 (AxesToTranspose). Results depend on the curve only in speed.
"""

import numpy as np

from ..array_types import Device, Indices, Integers, LongIntegers, Points
from ..arrays.bounds import Box, bound_points, find_box
from ..arrays.sort import SortKeys, positions, put_key
from ..lang import array, float32, float64, func, int32, int64, isfinite, kernel, launch, struct, tid, vec3, vector
from ..memory import empty, rows_of

VECTOR_LANES = 8  # points per thread, vectorized
lanes = vector(8, int32)
lane_codes = vector(8, int64)
SMALLEST_EXTENT = 1e-33  # [m] below, the scale overflows float32
MAX_LEVELS = 16  # 65,536 cells per axis: a millimeter in a city block
MAX_FEW_POINTS = (
    2048  # points for one thread and launch of the CPU: their tree takes 0.15 ms, 0.30 ms in parallel (2026-11-28)
)
FEW_BITS = 11  # bits of an index below MAX_FEW_POINTS
MAX_MOVES = 8  # of a key by insertion, on average: more take longer than all digits
FEW_LEVELS = 5  # of the curve for few queries: 32,768 cells, and a code of two digits
DIGIT_BITS = 8  # bits of a digit of the radix sort
DIGIT_VALUES = 1 << DIGIT_BITS


@struct
class HilbertCurve:
    """Curve through 2^levels cells per axis of a box with corner `low`; `scale` cells per meter, 0 for an empty box."""

    low: vec3
    scale: float
    levels: int

    def __init__(self, low: np.ndarray, high: np.ndarray, levels: int, *, is_empty: bool = False) -> None:
        extent = float((high.astype(np.float64) - low).max())
        self.low = vec3(0.0) if is_empty else vec3(*low)
        self.scale = (2**levels - 1) / extent if extent > SMALLEST_EXTENT else 0.0
        self.levels = levels

    @property
    def coarse(self) -> "HilbertCurve":
        """The curve with at most FEW_LEVELS levels."""
        if self.levels <= FEW_LEVELS:
            return self
        curve = object.__new__(HilbertCurve)
        curve.low, curve.levels = self.low, FEW_LEVELS
        curve.scale = self.scale * ((2**FEW_LEVELS - 1) / (2**self.levels - 1))
        return curve

    @property
    def code_bits(self) -> int:
        """Bits of a code, including that of non-finite points."""
        return 3 * self.levels + 1


@func
def spread_bits(v: int) -> int64:
    """Insert two zeros between the lowest 16 bits of v."""
    x = int64(v)
    x = (x | (x << 32)) & 0x1F00000000FFFF
    x = (x | (x << 16)) & 0x1F0000FF0000FF
    x = (x | (x << 8)) & 0x100F00F00F00F00F
    x = (x | (x << 4)) & 0x10C30C30C30C30C3
    return (x | (x << 2)) & 0x1249249249249249


@func
def hilbert_codes(cx: lanes, cy: lanes, cz: lanes, levels: int) -> lane_codes:
    """Hilbert indices of cells in 2^levels cells per axis, eight at a time without branches."""
    x = cx
    y = cy
    z = cz
    for level in range(1, levels):
        shift = levels - level
        low = (1 << shift) - 1
        for j in range(VECTOR_LANES):
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
    for j in range(VECTOR_LANES):
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
    top = float((1 << levels) - 1)
    return int(min(max((coordinate - low) * scale, 0.0), top))


@func
def locate_on_curve(p: vec3, curve: HilbertCurve) -> int64:
    """Code of a point. Points outside the box take the nearest cell."""
    x = lanes(cell_on_axis(p[0], curve.low[0], curve.scale, curve.levels))
    y = lanes(cell_on_axis(p[1], curve.low[1], curve.scale, curve.levels))
    z = lanes(cell_on_axis(p[2], curve.low[2], curve.scale, curve.levels))
    codes = hilbert_codes(x, y, z, curve.levels)
    return codes[0]


@func
def put_eight(head: int, step: int, points: array(dtype=vec3), low: vec3, scale: float, levels: int, codes: SortKeys):
    """Codes of eight points, `step` positions apart. Non-finite points come last."""
    last = points.shape[0] - 1
    x = lanes(0)
    y = lanes(0)
    z = lanes(0)
    for j in range(VECTOR_LANES):
        p = points[min(head + j * step, last)]
        x[j] = cell_on_axis(p[0], low[0], scale, levels)
        y[j] = cell_on_axis(p[1], low[1], scale, levels)
        z[j] = cell_on_axis(p[2], low[2], scale, levels)
    indices = hilbert_codes(x, y, z, levels)
    for j in range(VECTOR_LANES):
        position = head + j * step
        if position <= last:
            p = points[position]
            code = 1 << int64(3 * levels)
            if isfinite(p):
                code = indices[j]
            put_key(position, code, codes)


@func
def scale_of_box(low: vec3, high: vec3, levels: int) -> float:
    """Cells per meter of the curve through a box."""
    extent = float64(0.0)
    for axis in range(3):
        extent = max(extent, float64(high[axis]) - float64(low[axis]))
    scale = 0.0
    if extent > float64(SMALLEST_EXTENT):
        scale = float(float64((1 << levels) - 1) / extent)
    return scale


@func
def sort_digit(keys: array(dtype=int64), source: int, count: int, shift: int):
    """Move `count` keys from `source`, 0 or `count`, to the other half in the order of a digit. Counts follow them."""
    counts = 2 * count
    for d in range(counts, counts + DIGIT_VALUES):
        keys[d] = int64(0)
    for i in range(source, source + count):
        d = counts + (int(keys[i] >> int64(shift)) & (DIGIT_VALUES - 1))
        keys[d] = keys[d] + 1
    place = int64(count - source)
    for d in range(counts, counts + DIGIT_VALUES):
        size = keys[d]
        keys[d] = place
        place += size
    for i in range(source, source + count):
        key = keys[i]
        d = counts + (int(key >> int64(shift)) & (DIGIT_VALUES - 1))
        to = keys[d]
        keys[d] = to + 1
        keys[int(to)] = key


@func
def sort_few_keys(keys: array(dtype=int64), count: int, bits: int) -> int:
    """Sort by the two highest digits, then by insertion, or by all digits if that takes many moves. Return the start of
    the sorted keys.
    """
    top = max(bits - 2 * DIGIT_BITS, 0)
    sort_digit(keys, 0, count, top)
    sort_digit(keys, count, count, top + DIGIT_BITS)
    moves = 0
    i = 1
    while i < count and moves <= MAX_MOVES * count:
        key = keys[i]
        j = i - 1
        while j >= 0 and keys[j] > key:
            keys[j + 1] = keys[j]
            j -= 1
        keys[j + 1] = key
        moves += i - 1 - j
        i += 1
    source = 0
    if i < count:
        shift = 0
        while shift < bits:
            sort_digit(keys, source, count, shift)
            source = count - source
            shift += DIGIT_BITS
    return source


@func
def sort_few(points: array(dtype=vec3), low: vec3, scale: float, levels: int, codes: SortKeys) -> int:
    """Sort the codes of up to MAX_FEW_POINTS points by one thread. Return where in `codes.keys` the sorted keys start:
    codes above FEW_BITS of the index. Room is needed for each key twice, and for DIGIT_VALUES counts.
    """
    count = points.shape[0]
    for group in range((count + VECTOR_LANES - 1) // VECTOR_LANES):
        put_eight(group * VECTOR_LANES, 1, points, low, scale, levels, codes)
    index_bits = int(FEW_BITS)
    for i in range(count):
        codes.keys[i] = (codes.keys[i] << int64(index_bits)) | int64(i)
    return sort_few_keys(codes.keys, count, index_bits + 3 * levels + 1)


@func
def index_of_few(key: int64) -> int:
    return int(key & int64(MAX_FEW_POINTS - 1))


@kernel(for_cpu=True)
def order_few_kernel(points: array(dtype=vec3), curve: HilbertCurve, codes: SortKeys, order: array(dtype=int32)):
    i = tid()
    first = sort_few(points, curve.low, curve.scale, curve.levels, codes)
    for j in range(i, points.shape[0]):
        order[j] = index_of_few(codes.keys[first + j])


def few_keys(points: Points) -> SortKeys:
    """Room for `sort_few`."""
    return SortKeys(2 * points.size + DIGIT_VALUES, points.device)


_positions: list[Indices] = []  # 0 .. MAX_FEW_POINTS - 1


def few_positions(count: int, device: Device) -> Indices:
    """0 .. count - 1 on the CPU, read only, for 1 .. MAX_FEW_POINTS."""
    if not _positions:
        _positions.append(positions(MAX_FEW_POINTS, device))
    return rows_of(_positions[0], 0, count)


def is_few(points: Points) -> bool:
    """True if one thread of the CPU orders the points."""
    return 0 < points.size <= MAX_FEW_POINTS and points.device.is_cpu


@kernel
def encode_points_kernel(points: array(dtype=vec3), curve: HilbertCurve, apart: int, step: int, codes: SortKeys):
    i = tid()
    put_eight(i * apart, step, points, curve.low, curve.scale, curve.levels, codes)


@kernel
def encode_in_box_kernel(
    points: array(dtype=vec3), box: array(dtype=float32), levels: int, apart: int, step: int, codes: SortKeys
):
    """Codes of eight points on the curve through a box (low corner, high corner)."""
    i = tid()
    low = vec3(box[0], box[1], box[2])
    scale = scale_of_box(low, vec3(box[3], box[4], box[5]), levels)
    put_eight(i * apart, step, points, low, scale, levels, codes)


def order_in_box(points: Points, levels: int) -> Integers:
    """Order along the curve through the points' box, int32 (n), as of `argsort_along`. No sync."""
    codes, threads = SortKeys(points.size, points.device), -(-points.size // VECTOR_LANES)
    apart, step = (1, threads) if points.device.is_cuda else (VECTOR_LANES, 1)
    launch(encode_in_box_kernel, threads, [points, find_box(points), levels, apart, step, codes])
    return codes.sort(3 * levels + 1)[1]


def encode_points(points: Points, curve: HilbertCurve) -> SortKeys:
    """Codes of points on a curve, as SortKeys. 8^levels for non-finite points."""
    codes, threads = SortKeys(points.size, points.device), -(-points.size // VECTOR_LANES)
    # eight consecutive points per thread on the CPU, coalesced across threads on CUDA
    apart, step = (1, threads) if points.device.is_cuda else (VECTOR_LANES, 1)
    launch(encode_points_kernel, threads, [points, curve, apart, step, codes])
    return codes


def argsort_along(points: Points, curve: HilbertCurve) -> tuple[LongIntegers, Integers]:
    """Sorted codes int64 (n) and order int32 (n) along a curve. Non-finite points last."""
    return encode_points(points, curve).sort(curve.code_bits)


def order_queries(queries: Points, curve: HilbertCurve) -> Indices:
    """An order of queries in which neighbors are near each other, int32 (n). Non-finite points last."""
    if not is_few(queries):
        return argsort_along(queries, curve)[1]
    if queries.size == 1:
        return few_positions(1, queries.device)
    order = empty(queries.size, int32, queries.device)
    launch(order_few_kernel, 1, [queries, curve.coarse, few_keys(queries), order])
    return order


def levels_for(count: int) -> int:
    """Levels of a curve whose codes and `count` indices fit into 62 bits."""
    return min(MAX_LEVELS, (62 - max(1, (count - 1).bit_length() if count else 1)) // 3)


class HilbertOrder:
    """Order of a cloud's finite points (others last) along the curve through their box, or a given one.

    `box`: the result of `bound_points`, if it is known.
    """

    def __init__(self, points: Points, curve: HilbertCurve | None = None, box: Box | None = None) -> None:
        self.low, self.high, self.finite_count = bound_points(points) if box is None else box
        levels = levels_for(points.size)
        self.curve = curve or HilbertCurve(self.low, self.high, levels, is_empty=not self.finite_count)
        self.codes, self.order = encode_points(points, self.curve).sort(self.curve.code_bits)
