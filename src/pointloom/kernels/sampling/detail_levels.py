"""Points in Morton order with their octree level of detail.

Each voxel at depth d is represented by its point of lowest priority (a bijection of the index). A point represents its
voxel below the longest key prefix shared with a lower-priority point, found by all nearest smaller values (Berkman,
Schieber and Vishkin 1993) with block minima of 64, 4,096 and 262,144 points. Level L nodes have 128 voxels per axis, so
level L is depth L + 7. Integers and float64 products only: identical on all devices.
"""

import numpy as np

from ..array_types import Indices, Integers, LongIntegers, Points, Positions
from ..arrays.sort import SortKeys, put_key
from ..lang import (
    array,
    compute,
    float64,
    floor,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
)
from ..memory import download, empty, host_view, upload
from ..search.hilbert_order import spread_bits

MAX_DEPTH = 21  # subdivisions: 63 key bits
NODE_BITS = 7  # 128 voxels per node axis: some 12,000 surface points, 20 to 200 nodes per view
LEVEL_COUNT = MAX_DEPTH - NODE_BITS + 2  # from 0, the whole cube, to the last one for points that share a finest cell

NON_FINITE_KEY = 0x7FFF_FFFF_FFFF_FFFF  # key of non-finite points, above all: no cell is the last on each axis
LAST_CELL = (1 << MAX_DEPTH) - 2
LOW_BITS = 32  # of a key, sorted first on the CPU. The other 31 also fit above a position
LOW_MASK = 0xFFFF_FFFF
BLOCK_SIZE = 64  # points, or minima, per minimum


@struct
class Cube:
    """Subdivided cube: low `corner` [m], `scale` finest cells per meter."""

    corner: vec3d
    scale: float64

    def __init__(self, corner: np.ndarray, side: float) -> None:
        self.corner, self.scale = vec3d(*np.asarray(corner).tolist()), 2.0**MAX_DEPTH / side


@struct
class Minima:
    """Minimum priorities of blocks of 64 (`few`), 4,096 (`some`) and 262,144 (`many`) points."""

    few: array(dtype=int32)
    some: array(dtype=int32)
    many: array(dtype=int32)

    def __init__(self, order: Indices) -> None:
        count, device = order.size, order.device
        layers = []
        for _ in range(3):
            count = -(-count // BLOCK_SIZE)
            layers.append(empty(count, int32, device))
        self.few, self.some, self.many = layers
        launch(find_min_priorities_kernel, self.few.size, [order, self.few])
        launch(find_minima_kernel, self.some.size, [self.few, self.some])
        launch(find_minima_kernel, self.many.size, [self.some, self.many])


@func
def cell_along(coordinate: float64, cube: Cube, axis: int) -> int:
    return min(int(floor((coordinate - cube.corner[axis]) * cube.scale)), LAST_CELL)


@func
def key_of_cell(x: int, y: int, z: int) -> int64:
    """Bits of a finest cell, x above y above z."""
    return (spread_bits(x) << 2) | (spread_bits(y) << 1) | spread_bits(z)


@func
def morton_key(p: vec3, cube: Cube) -> int64:
    """Bits of a point's finest cell. NON_FINITE_KEY if it is not finite."""
    key = int64(NON_FINITE_KEY)
    if isfinite(p):
        x = cell_along(float64(p[0]), cube, 0)
        y = cell_along(float64(p[1]), cube, 1)
        z = cell_along(float64(p[2]), cube, 2)
        key = key_of_cell(x, y, z)
    return key


@func
def priority(index: int) -> int:
    """Bijective hash of 32-bit integers (Wellons' "lowbias32")."""
    x = index ^ ((index >> 16) & 0xFFFF)
    x = x * 0x7FEB352D
    x = x ^ ((x >> 15) & 0x1FFFF)
    x = x * -0x7B935975
    return x ^ ((x >> 16) & 0xFFFF)


@kernel
def encode_points_kernel(points: array(dtype=vec3), cube: Cube, keys: SortKeys):
    i = tid()
    put_key(i, morton_key(points[i], cube), keys)


@kernel
def encode_world_points_kernel(points: array(dtype=vec3d), cube: Cube, keys: SortKeys):
    i = tid()
    p = points[i]
    put_key(i, key_of_cell(cell_along(p[0], cube, 0), cell_along(p[1], cube, 1), cell_along(p[2], cube, 2)), keys)


@kernel(for_cpu=True)
def halve_keys_kernel(
    points: array(dtype=vec3), cube: Cube, shift: int64, words: array(dtype=int64), highs: array(dtype=int32)
):
    """Lower half of each key above the point's index, and the upper half."""
    i = tid()
    key = morton_key(points[i], cube)
    words[i] = ((key & int64(LOW_MASK)) << shift) | int64(i)
    highs[i] = int(key >> int64(LOW_BITS))


@kernel(for_cpu=True)
def pack_highs_kernel(words: array(dtype=int64), highs: array(dtype=int32), shift: int64, packed: array(dtype=int64)):
    """Upper half of the key of each word's point, above the word's position."""
    i = tid()
    index = int(words[i] & ((1 << shift) - 1))
    packed[i] = (int64(highs[index]) << shift) | int64(i)


@kernel(for_cpu=True)
def join_keys_kernel(words: array(dtype=int64), shift: int64, packed: array(dtype=int64), order: array(dtype=int32)):
    """Full key in place of the packed upper half; and the word's point."""
    i = tid()
    mask = (1 << shift) - 1
    packed_value = packed[i]
    word = words[int(packed_value & mask)]
    order[i] = int(word & mask)
    packed[i] = ((packed_value >> shift) << int64(LOW_BITS)) | (word >> shift)


@kernel
def find_min_priorities_kernel(order: array(dtype=int32), minima: array(dtype=int32)):
    i = tid()
    minimum = 0x7FFFFFFF
    for j in range(i * BLOCK_SIZE, min((i + 1) * BLOCK_SIZE, order.shape[0])):
        minimum = min(minimum, priority(order[j]))
    minima[i] = minimum


@kernel
def find_minima_kernel(values: array(dtype=int32), minima: array(dtype=int32)):
    i = tid()
    minimum = 0x7FFFFFFF
    for j in range(i * BLOCK_SIZE, min((i + 1) * BLOCK_SIZE, values.shape[0])):
        minimum = min(minimum, values[j])
    minima[i] = minimum


@func
def shared_depth(differing: int64) -> int:
    left = differing
    depth = int(MAX_DEPTH)
    while left != 0:
        left = left >> 3
        depth = depth - 1
    return depth


@func
def count_skippable(j: int, own: int, before: int, minima: Minima) -> int:
    """Points before j (`before` 1) or from j on (0) that can be skipped because all have higher priorities, else 1."""
    size = 1
    if j % BLOCK_SIZE == 0:
        if minima.few[j // BLOCK_SIZE - before] > own:
            size = int(BLOCK_SIZE)
            if j % (BLOCK_SIZE * BLOCK_SIZE) == 0:
                if minima.some[j // (BLOCK_SIZE * BLOCK_SIZE) - before] > own:
                    size = int(BLOCK_SIZE * BLOCK_SIZE)
                    if j % (BLOCK_SIZE * BLOCK_SIZE * BLOCK_SIZE) == 0:
                        if minima.many[j // (BLOCK_SIZE * BLOCK_SIZE * BLOCK_SIZE) - before] > own:
                            size = int(BLOCK_SIZE * BLOCK_SIZE * BLOCK_SIZE)
    return size


@kernel
def find_levels_kernel(order: array(dtype=int32), keys: array(dtype=int64), minima: Minima, levels: array(dtype=uint8)):
    """Level of each point, by the depth shared with lower-priority points on either side."""
    i = tid()
    count = int(order.shape[0])
    key = keys[i]
    own = priority(order[i])
    depth = int(NODE_BITS - 1)  # a shorter prefix makes no difference
    shift = int64(3 * (MAX_DEPTH - NODE_BITS))
    j = int(i)
    while j > 0:
        size = count_skippable(j, own, 1, minima)
        j = j - size
        differing = key ^ keys[j]
        if (differing >> shift) != 0:
            j = 0
        elif size == 1:
            if priority(order[j]) < own:
                depth = shared_depth(differing)
                j = 0
    shift = int64(3 * max(MAX_DEPTH - 1 - depth, 0))
    j = i + 1
    if depth == MAX_DEPTH:
        j = count
    while j < count:
        size = count_skippable(j, own, 0, minima)
        j = min(j + size, count)
        differing = key ^ keys[j - 1]
        if (differing >> shift) != 0:
            j = count
        elif size == 1:
            if priority(order[j - 1]) < own:
                depth = shared_depth(differing)
                j = count
    levels[i] = uint8(depth - (NODE_BITS - 1))


def sort_by_cell(points: Points | Positions, cube: Cube) -> tuple[LongIntegers, Integers]:
    """(keys, order) in Morton order, int64 and int32 (n) on the device; equal keys by index."""
    count, device, is_world = points.size, points.device, points.dtype is vec3d
    if device.is_cuda or count == 0 or is_world:
        keys = SortKeys(count, device)
        launch(encode_world_points_kernel if is_world else encode_points_kernel, count, [points, cube, keys])
        return keys.sort()
    shift = max(1, (count - 1).bit_length())
    words, highs = empty(count, int64, device), empty(count, int32, device)
    launch(halve_keys_kernel, count, [points, cube, shift, words, highs])
    host_view(words).sort()
    packed = compute(pack_highs_kernel, count, [words, highs, shift], int64, device)
    del highs  # frees memory for `order`
    host_view(packed).sort()
    order = compute(join_keys_kernel, count, [words, shift, packed], int32, device)
    return packed, order


def find_levels(
    points: Points | Positions, corner: np.ndarray, side: float, numbers: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(keys, order, levels) of the finite points in a cube [m], in Morton order on the host. Use vec3d if float32 would
    move points across cells. `numbers`: indices in a larger cloud. Complete cells no smaller than a first-level voxel
    then get the levels of the whole.
    """
    keys, order = sort_by_cell(points, Cube(corner, side))
    sorted_keys = download(keys)
    count = int(np.searchsorted(sorted_keys, NON_FINITE_KEY))
    if not count:
        return np.empty(0, np.int64), np.empty(0, np.int32), np.empty(0, np.uint8)
    keys, order = keys[:count], order[:count]
    levels = empty(count, uint8, points.device)
    ranked = order if numbers is None else upload(numbers[download(order)].astype(np.int32), int32, points.device)
    launch(find_levels_kernel, count, [ranked, keys, Minima(ranked), levels])
    return sorted_keys[:count], download(order), download(levels)
