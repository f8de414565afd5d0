"""Exact squared Euclidean distance transform, axis by axis along lines of blocks.

Meijster, Roerdink and Hesselink, "A general algorithm for computing distance transforms in linear time", 2000.
Felzenszwalb and Huttenlocher, Theory of Computing 8, 2012: a forward scan builds the lower envelope of parabolas on a
stack, a backward scan reads it. Integers. Ties go to the first site along x, then y, then z. 8 B per voxel and axis, up
to 16 B of stack.
"""

import numpy as np

from ..array_types import Array1, Integers, Keys
from ..arrays.block_keys import block_key, key_block
from ..arrays.select import positions_of
from ..arrays.sort import argsort_keys, positions
from ..lang import array, compute, func, int32, int64, kernel, launch, struct, tid, uint8, vec4i
from ..memory import copy, empty, upload
from .tsdf_blocks import BLOCK_ROWS, BLOCK_SIDE, BLOCK_VOXELS

NO_SEED = 2**31 - 1  # squared distance of a voxel without a known seed
MAX_SQUARED_VOXELS = 2**15 - 1  # voxels: squares of distances up to it, and sums of two, are int32
MAX_RANGE_VOXELS = MAX_SQUARED_VOXELS // 2  # maximum range of distances in voxels


@kernel
def permute_keys_kernel(keys: array(dtype=int64), axis: int, permuted: array(dtype=int64)):
    i = tid()
    b = key_block(keys[i])
    key = block_key(b[1], b[2], b[0])
    if axis == 1:
        key = block_key(b[2], b[0], b[1])
    permuted[i] = key


@kernel
def mark_gaps_kernel(keys: array(dtype=int64), marks: array(dtype=uint8)):
    i = tid()
    first = 1
    if i > 0:
        if keys[i] == keys[i - 1] + 1:
            first = 0
    marks[i] = uint8(first)


@struct
class BlockLines:
    """Runs of adjacent blocks along an axis: sorted `order` int32 [m], and `starts` of runs."""

    axis: int
    order: array(dtype=int32)
    starts: array(dtype=int32)

    def __init__(self, keys: Keys, axis: int) -> None:
        """From ascending keys, none at the limit of the key range. One sync."""
        device = keys.device
        self.axis = axis
        if axis == 2:
            self.order, permuted = positions(keys.size, device), keys
        else:
            permuted = compute(permute_keys_kernel, keys.size, [keys, axis], int64, device)
            permuted, self.order = argsort_keys(permuted)
        marks = compute(mark_gaps_kernel, keys.size, [permuted], uint8, device)
        heads = positions_of(marks)  # sync
        self.count = heads.size
        self.starts = empty(self.count + 1, int32, device)
        copy(self.starts, heads, count=self.count)
        copy(self.starts, upload(np.array([keys.size]), int32, device), count=1, offset=self.count)


@func
def first_position_won(a: int, fa: int, b: int, fb: int) -> int:
    """First position at which site b is strictly nearer than a site a before it."""
    apart = b - a
    position = a + apart // 2  # beyond the range of both
    if apart <= MAX_SQUARED_VOXELS:
        position = a + (apart * apart + fb - fa) // (2 * apart) + 1
    return position


@func
def row_offset(row: int, axis: int) -> int:
    offset = row
    if axis == 1:
        offset = (row // BLOCK_SIDE) * BLOCK_ROWS + row % BLOCK_SIDE
    if axis == 2:
        offset = row * BLOCK_SIDE
    return offset


@func
def row_step(axis: int) -> int:
    step = BLOCK_ROWS
    if axis == 1:
        step = BLOCK_SIDE
    if axis == 2:
        step = 1
    return step


@kernel
def sweep_lines_kernel(
    lines: BlockLines,
    max_distance: int,
    limit: int,
    sqdists: array(dtype=int32),
    nearest: array(dtype=int32),
    stack: array(dtype=vec4i),
):
    """Minimum of (p - site)^2 + sqdists[site] along each line, and the nearest seed of that site."""
    i = tid()
    begin = lines.starts[i // BLOCK_ROWS]
    end = lines.starts[i // BLOCK_ROWS + 1]
    offset = row_offset(i % BLOCK_ROWS, lines.axis)
    step = row_step(lines.axis)
    size = int(BLOCK_SIDE)
    last = (end - begin) * BLOCK_SIDE - 1
    base = begin * BLOCK_VOXELS + i % BLOCK_ROWS
    depth = 0
    position = 0
    top = vec4i(0, 0, 0, 0)  # of the stack: a site, the first position that it wins, its squared distance, its seed
    for b in range(begin, end):
        voxel = lines.order[b] * BLOCK_VOXELS + offset
        for _ in range(size):
            g = sqdists[voxel]
            if g != NO_SEED:
                won = 0
                if depth > 0:
                    won = first_position_won(top[0], top[2], position, g)
                while depth > 0 and won <= top[1]:
                    depth -= 1
                    won = 0
                    if depth > 0:
                        top = stack[base + (depth - 1) * BLOCK_ROWS]
                        won = first_position_won(top[0], top[2], position, g)
                if won <= last:
                    top = vec4i(position, won, g, nearest[voxel])
                    stack[base + depth * BLOCK_ROWS] = top
                    depth += 1
            position += 1
            voxel += step
    if depth > 0:
        for c in range(begin, end):
            voxel = lines.order[begin + end - 1 - c] * BLOCK_VOXELS + offset + (BLOCK_SIDE - 1) * step
            for _ in range(size):
                position -= 1
                while position < top[1]:
                    depth -= 1
                    top = stack[base + (depth - 1) * BLOCK_ROWS]
                apart = abs(position - top[0])
                g = int(NO_SEED)
                if apart <= max_distance:
                    g = apart * apart + top[2]
                if g > limit:
                    g = int(NO_SEED)
                sqdists[voxel] = g
                nearest[voxel] = top[3]
                voxel -= step


def sweep_blocks(keys: Keys, max_distance: int, limit: int, sqdists: Integers, nearest: Integers) -> None:
    """Propagate distances and seeds in place. `keys` are ascending blocks up to `max_distance` voxels (at most LONGEST)
    around each seed. Squared distances beyond `limit` (below FAR) become FAR. `sqdists` starts as 0 at seeds and FAR
    elsewhere, `nearest` as the seed indices."""
    if not keys.size:
        return
    stack: Array1[vec4i] = empty(sqdists.size, vec4i, keys.device)
    for axis in (2, 1, 0):
        lines = BlockLines(keys, axis)
        launch(sweep_lines_kernel, lines.count * BLOCK_ROWS, [lines, max_distance, limit, sqdists, nearest, stack])
