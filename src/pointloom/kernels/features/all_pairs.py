"""Nearest rows of two small feature sets by comparing all pairs, on CUDA: no tree, no sort, no wait.

A thread has a query in registers. The threads of a warp read the same row of the other side by 128-bit loads. The other
side is split into segments, so that few queries fill the GPU, too. Distances are summed as in `square_distance` of
feature_matching.py, and ties go to the lower row, so results are bitwise those of the tree. 192 B per row, and 12 B per
query and segment. 147 PTX instructions per pair, 78 registers, no local memory.
"""

from ..algebra.plain_min_max import smaller
from ..array_types import Array2, Mask
from ..arrays.packed_keys import key_index, key_number, pack_key
from ..lang import (
    INFINITY,
    NAN,
    WARP,
    array,
    compute,
    float32,
    func,
    int32,
    int64,
    kernel,
    launch,
    load_eight,
    struct,
    tid,
    uint8,
    vec3,
    vector,
)
from ..memory import empty
from .feature_tree import LARGEST_NUMBER, NUMBERS_PER_STEP

# Rows per side. Predicted for an H100, not yet measured on any GPU: 23,000 squared pairs take 2.6 ms per direction if
# the instructions never wait, and the launches, sorts and waits of two trees take 3.8 ms of the host at any size.
MAX_ROWS = 23_000
MAX_COLUMNS = 40  # numbers of a row that fit into the registers of a thread without spills: FPFH has 33
PART = 24  # numbers of one load
VECTORS_PER_ROW = 16  # two loads of 8 vectors
WARPS_PER_MULTIPROCESSOR = 16  # segments are added up to this number of warps: registers allow 24
NO_ROW = -1  # index without a row
NO_ROW_KEY = 0x7F80_0000_FFFF_FFFF  # above all other keys: infinite distance, no row

part = vector(24, float32)
eight = vector(8, float32)


@struct
class StoredRows:
    """Feature rows, zero-padded to 48 numbers. The first number of an unusable row is NaN, and so are its distances."""

    rows: array(dtype=vec3)
    count: int

    def __init__(self, features: Array2[float32]) -> None:
        self.count, self.device = features.shape[0], features.device
        self.rows = compute(store_rows_kernel, self.count * VECTORS_PER_ROW, [features], vec3, self.device)


@struct
class PairwiseMatch:
    """Nearest other row of each query, as FeatureMatch. `keys` and `seconds`: key of the nearest row and second squared
    distance by segment, `stride` queries each. `length`: rows of a segment.
    """

    nearest: array(dtype=int32)
    sqdists: array(dtype=float32)
    second_sqdists: array(dtype=float32)
    keys: array(dtype=int64)
    seconds: array(dtype=float32)
    stride: int
    length: int
    segments: int

    def __init__(self, queries: StoredRows, others: StoredRows) -> None:
        self.queries, self.others, device = queries, others, queries.device
        self.stride = -(-queries.count // WARP) * WARP  # whole warps, whose threads share their segment
        wanted = device.sm_count * WARPS_PER_MULTIPROCESSOR * WARP
        self.segments = max(1, min(-(-wanted // max(1, self.stride)), -(-others.count // WARP)))
        self.length = -(-others.count // self.segments)
        threads = self.segments * self.stride
        self.keys, self.seconds = empty(threads, int64, device), empty(threads, float32, device)
        self.nearest = empty(queries.count, int32, device)
        self.sqdists, self.second_sqdists = (empty(queries.count, float32, device) for _ in range(2))
        launch(compare_all_kernel, threads, [queries, others, self])
        launch(merge_segments_kernel, queries.count, [self])

    def mutual(self) -> Mask:
        backward = PairwiseMatch(self.others, self.queries)
        search = [self.nearest, backward.nearest]
        return compute(keep_returning_kernel, self.queries.count, search, uint8, self.queries.device)


def is_for_all_pairs(source: Array2[float32], target: Array2[float32]) -> bool:
    is_small = max(source.shape[0], target.shape[0]) <= MAX_ROWS and source.shape[1] <= MAX_COLUMNS
    return source.device.is_cuda and is_small


@kernel
def store_rows_kernel(features: array(dtype=float32, ndim=2), rows: array(dtype=vec3)):
    """One thread per vector of a row."""
    i = tid()
    row = i // VECTORS_PER_ROW
    first = 3 * (i % VECTORS_PER_ROW)
    columns = features.shape[1]
    v = vec3(0.0, 0.0, 0.0)
    for k in range(3):
        if first + k < columns:
            v[k] = features[row, first + k]
    if first == 0:
        for c in range(columns):
            if not (abs(features[row, c]) <= LARGEST_NUMBER):
                v[0] = NAN
    rows[i] = v


@func
def load_part(first: int, rows: array(dtype=vec3)) -> part:
    numbers = part(0.0)
    for j in range(PART):
        numbers[j] = rows[first + j // 3][j % 3]
    return numbers


@load_part.on_cuda
def load_part_at_once(first: int, rows: array(dtype=vec3)) -> part:
    return load_eight(rows, first)


@func
def sqdist_of_parts(p: part, q: part, x: part, y: part) -> float:
    """Squared distance of (p, q) and (x, y), in the order of `square_distance`."""
    sums = eight(0.0)
    for j in range(NUMBERS_PER_STEP):
        for c in range(3):
            gap = p[c * NUMBERS_PER_STEP + j] - x[c * NUMBERS_PER_STEP + j]
            sums[j] += gap * gap
        for c in range(2):
            gap = q[c * NUMBERS_PER_STEP + j] - y[c * NUMBERS_PER_STEP + j]
            sums[j] += gap * gap
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]))


@kernel
def compare_all_kernel(queries: StoredRows, others: StoredRows, match: PairwiseMatch):
    """One thread per query and segment. Comparisons with NaN are false."""
    i = tid()
    segment = i // match.stride
    own = min(i % match.stride, queries.count - 1) * VECTORS_PER_ROW
    p = load_part(own, queries.rows)
    q = load_part(own + PART // 3, queries.rows)
    nearest = float(INFINITY)
    second = float(INFINITY)
    row = int(NO_ROW)
    for j in range(segment * match.length, min((segment + 1) * match.length, others.count)):
        x = load_part(j * VECTORS_PER_ROW, others.rows)
        y = load_part(j * VECTORS_PER_ROW + PART // 3, others.rows)
        sqdist = sqdist_of_parts(p, q, x, y)
        is_nearest = sqdist < nearest
        is_second = sqdist < second
        second = nearest if is_nearest else (sqdist if is_second else second)
        row = j if is_nearest else row
        nearest = sqdist if is_nearest else nearest
    match.keys[i] = pack_key(nearest, row) if row != NO_ROW else int64(NO_ROW_KEY)
    match.seconds[i] = second


@kernel
def merge_segments_kernel(match: PairwiseMatch):
    i = tid()
    best = int64(NO_ROW_KEY)
    second = float(INFINITY)
    for segment in range(match.segments):
        key = match.keys[segment * match.stride + i]
        if key < best:
            second = smaller(key_number(best), match.seconds[segment * match.stride + i])
            best = key
        else:
            second = smaller(second, key_number(key))
    match.nearest[i] = key_index(best)  # NO_ROW of NO_ROW_KEY
    match.sqdists[i] = key_number(best)
    match.second_sqdists[i] = second


@kernel
def keep_returning_kernel(nearest: array(dtype=int32), backward: array(dtype=int32), mask: array(dtype=uint8)):
    """Flag the rows whose nearest row has them as its nearest."""
    i = tid()
    is_mutual = 0
    if nearest[i] != NO_ROW:
        if backward[nearest[i]] == i:
            is_mutual = 1
    mask[i] = uint8(is_mutual)
