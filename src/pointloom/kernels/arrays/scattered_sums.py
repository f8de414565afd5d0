"""Sums of rows by index, without float atomics: bitwise identical in each run.

The CPU divides the rows of the result among threads, each of which reads all indices: 1 ns per index and thread. CUDA
sorts the indices, and one or more lanes add up the rows of an index. Sums are float64, in order. 24 B per index.
"""

from ..array_types import AnyArray, Array2, LongIntegers
from ..lang import array, float32, float64, int32, int64, kernel, launch, tid
from ..memory import cast, empty, fill
from .key_starts import find_key_starts
from .sort import SortKeys, put_key

CPU_PARTS = 8  # threads of the CPU. More would only read the indices more often
MIN_PARTED_INDICES = 1 << 13  # fewer are summed by one thread in about 10 us
ROWS_OF_LANE = 64  # rows that a lane of CUDA adds up on average, one after another
MAX_LANES = 256  # of one index: partial sums are 8 B per lane and column


@kernel(for_cpu=True)
def add_rows_kernel(
    values: array(dtype=float64, ndim=2), index: array(dtype=int64), parts: int, sums: array(dtype=float64, ndim=2)
):
    """Add up the rows of a part of the indices, in order."""
    i = tid()
    first = int64(i) * int64(sums.shape[0]) // int64(parts)
    last = int64(i + 1) * int64(sums.shape[0]) // int64(parts)
    for row in range(int(first), int(last)):
        for column in range(sums.shape[1]):
            sums[row, column] = 0.0
    for j in range(index.shape[0]):
        to = index[j]
        if to >= first and to < last:
            for column in range(sums.shape[1]):
                sums[int(to), column] = sums[int(to), column] + values[j, column]


@kernel(for_cpu=True)
def add_narrow_rows_kernel(
    values: array(dtype=float32, ndim=2), index: array(dtype=int64), parts: int, sums: array(dtype=float64, ndim=2)
):
    """As `add_rows_kernel`, of float32."""
    i = tid()
    first = int64(i) * int64(sums.shape[0]) // int64(parts)
    last = int64(i + 1) * int64(sums.shape[0]) // int64(parts)
    for row in range(int(first), int(last)):
        for column in range(sums.shape[1]):
            sums[row, column] = 0.0
    for j in range(index.shape[0]):
        to = index[j]
        if to >= first and to < last:
            for column in range(sums.shape[1]):
                sums[int(to), column] = sums[int(to), column] + float64(values[j, column])


@kernel
def key_of_index_kernel(index: array(dtype=int64), rows: int, keys: SortKeys):
    """Indices as sort keys. Those outside the result are last."""
    i = tid()
    key = index[i]
    if key < 0 or key > int64(rows):
        key = int64(rows)
    put_key(i, key, keys)


@kernel
def add_sorted_rows_kernel(
    values: array(dtype=float64, ndim=2),
    order: array(dtype=int32),
    starts: array(dtype=int32),
    lanes: int,
    sums: array(dtype=float64, ndim=2),
):
    """Sum of every `lanes`-th row of an index, by one thread per index, lane and column."""
    i = tid()
    columns = values.shape[1]
    column = i % columns
    row = i // columns
    total = float64(0.0)
    j = starts[row // lanes] + row % lanes
    while j < starts[row // lanes + 1]:
        total += values[order[j], column]
        j += lanes
    sums[row, column] = total


@kernel
def add_sorted_narrow_rows_kernel(
    values: array(dtype=float32, ndim=2),
    order: array(dtype=int32),
    starts: array(dtype=int32),
    lanes: int,
    sums: array(dtype=float64, ndim=2),
):
    """As `add_sorted_rows_kernel`, of float32."""
    i = tid()
    columns = values.shape[1]
    column = i % columns
    row = i // columns
    total = float64(0.0)
    j = starts[row // lanes] + row % lanes
    while j < starts[row // lanes + 1]:
        total += float64(values[order[j], column])
        j += lanes
    sums[row, column] = total


@kernel
def add_lanes_kernel(partials: array(dtype=float64, ndim=2), lanes: int, sums: array(dtype=float64, ndim=2)):
    i = tid()
    columns = sums.shape[1]
    row = i // columns
    column = i % columns
    total = float64(0.0)
    for j in range(row * lanes, (row + 1) * lanes):
        total += partials[j, column]
    sums[row, column] = total


def sum_by_index(values: AnyArray, index: LongIntegers, rows: int) -> AnyArray:
    """Sums (rows, c), in the type of `values`, float32 or float64 (n, c), of the rows with each index. Rows with an
    index outside 0 .. rows - 1 are skipped. No wait for the device.
    """
    device, columns, is_narrow = values.device, int(values.shape[1]), values.dtype == float32
    sums = empty((rows, columns), float64, device)
    if not sums.size:
        return empty((rows, columns), values.dtype, device)
    if not index.size:
        fill(sums, 0.0)
    elif device.is_cuda:
        _sum_sorted(values, index, sums)
    else:
        parts = CPU_PARTS if index.size >= MIN_PARTED_INDICES and rows >= CPU_PARTS else 1
        launch(add_narrow_rows_kernel if is_narrow else add_rows_kernel, parts, [values, index, parts, sums])
    return cast(sums, float32) if is_narrow else sums


def _sum_sorted(values: AnyArray, index: LongIntegers, sums: Array2[float64]) -> None:
    device, (rows, columns) = values.device, sums.shape
    keys = SortKeys(index.size, device)
    launch(key_of_index_kernel, index.size, [index, rows, keys])
    sorted_keys, order = keys.sort(rows.bit_length())
    starts = empty(rows + 1, int32, device)
    find_key_starts(sorted_keys, starts)
    lanes = min(MAX_LANES, max(1, index.size // (rows * ROWS_OF_LANE)))
    kernel_of_type = add_sorted_narrow_rows_kernel if values.dtype == float32 else add_sorted_rows_kernel
    partials = sums if lanes == 1 else empty((rows * lanes, columns), float64, device)
    launch(kernel_of_type, rows * lanes * columns, [values, order, starts, lanes, partials])
    if lanes > 1:
        launch(add_lanes_kernel, rows * columns, [partials, lanes, sums])
