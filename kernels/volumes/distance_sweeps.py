"""Exact squared distances to the nearest seed, one axis after the other, along lines of blocks.

Along one line the nearest of all seeds is the lower envelope of the parabolas (p - site)^2 + f(site), where f is what
the axes before have found: a scan forwards keeps the sites that win somewhere, each with the first place that it wins,
on a stack; a scan backwards reads them off. All numbers are whole, so every device and compiler gives the same. A site
wins where it is strictly nearer than the one before it: of equally near ones the first along x is it, of those the
first along y, of those the first along z.

A line passes through blocks that follow each other without a gap, one thread a line. Blocks reach as far around seeds
as distances count, so that no seed behind a gap could matter. Each axis reads and writes 8 B a voxel, and up to 16 B
a voxel of stack, each in constant time on average, however far distances reach.

Source: Meijster, Roerdink and Hesselink, "A general algorithm for computing distance transforms in linear time", 2000;
Felzenszwalb and Huttenlocher, "Distance transforms of sampled functions", Theory of Computing 8, 2012.
"""

import numpy as np

from ..array_types import Array1, Integers, Keys
from ..arrays.block_keys import block_key, key_block
from ..arrays.select import positions_of
from ..arrays.sort import argsort_keys, positions
from ..lang import array, func, int32, int64, kernel, launch, struct, tid, uint8, vec4i
from ..memory import copy, empty, upload
from .tsdf_blocks import BLOCK_VOXELS, ROWS, SIDE

FAR = 2**31 - 1  # the squared distance of a voxel that no seed is known of
LONGEST = 2**15 - 1  # voxels: squares of distances up to it, and sums of two, are int32
FARTHEST = LONGEST // 2  # voxels that distances reach to at most


@kernel
def turn_keys_kernel(keys: array(dtype=int64), axis: int, turned: array(dtype=int64)):
    """Keys in whose order blocks follow each other along an axis."""
    i = tid()
    b = key_block(keys[i])
    key = block_key(b[1], b[2], b[0])
    if axis == 1:
        key = block_key(b[2], b[0], b[1])
    turned[i] = key


@kernel
def mark_gaps_kernel(keys: array(dtype=int64), marks: array(dtype=uint8)):
    """1 where a key does not follow the one before it."""
    i = tid()
    first = 1
    if i > 0:
        if keys[i] == keys[i - 1] + 1:
            first = 0
    marks[i] = uint8(first)


@struct
class BlockLines:
    """Blocks in runs without gaps along one axis.

    Attributes:
        axis: 0, 1 or 2.
        order: int32 [m], the blocks, run by run.
        starts: int32 [runs + 1], where each run begins.
        count: Runs.
    """

    axis: int
    order: array(dtype=int32)
    starts: array(dtype=int32)

    def __init__(self, keys: Keys, axis: int) -> None:
        """Of blocks by their ascending keys, none of them at the border of what keys can tell; one sync."""
        device = keys.device
        self.axis = axis
        if axis == 2:
            self.order, turned = positions(keys.size, device), keys
        else:
            turned = empty(keys.size, int64, device)
            launch(turn_keys_kernel, keys.size, [keys, axis, turned])
            turned, self.order = argsort_keys(turned)
        marks = empty(keys.size, uint8, device)
        launch(mark_gaps_kernel, keys.size, [turned, marks])
        heads = positions_of(marks)  # sync
        self.count = heads.size
        self.starts = empty(self.count + 1, int32, device)
        copy(self.starts, heads, count=self.count)
        copy(self.starts, upload(np.array([keys.size]), int32, device), count=1, offset=self.count)


@func
def first_place_won(a: int, fa: int, b: int, fb: int) -> int:
    """The first place where a site b is strictly nearer than a site a before it."""
    apart = b - a
    place = a + apart // 2  # where neither reaches any more
    if apart <= LONGEST:
        place = a + (apart * apart + fb - fa) // (2 * apart) + 1
    return place


@func
def row_offset(row: int, axis: int) -> int:
    """Where the first of a line's voxels stands in a block."""
    offset = row
    if axis == 1:
        offset = (row // SIDE) * ROWS + row % SIDE
    if axis == 2:
        offset = row * SIDE
    return offset


@func
def row_step(axis: int) -> int:
    """How far apart a line's voxels stand in a block."""
    step = ROWS
    if axis == 1:
        step = SIDE
    if axis == 2:
        step = 1
    return step


@kernel
def sweep_lines_kernel(
    lines: BlockLines,
    reach: int,
    limit: int,
    sqdists: array(dtype=int32),
    nearest: array(dtype=int32),
    stack: array(dtype=vec4i),
):
    """The least of (p - site)^2 + sqdists[site] along each line, and the nearest seed of that site."""
    i = tid()
    begin = lines.starts[i // ROWS]
    end = lines.starts[i // ROWS + 1]
    offset = row_offset(i % ROWS, lines.axis)
    step = row_step(lines.axis)
    size = int(SIDE)
    last = (end - begin) * SIDE - 1
    base = begin * BLOCK_VOXELS + i % ROWS
    depth = 0
    place = 0
    top = vec4i(0, 0, 0, 0)  # of the stack: a site, the first place that it wins, what was found there, its seed
    for b in range(begin, end):
        voxel = lines.order[b] * BLOCK_VOXELS + offset
        for _ in range(size):
            g = sqdists[voxel]
            if g != FAR:
                won = 0
                if depth > 0:
                    won = first_place_won(top[0], top[2], place, g)
                while depth > 0 and won <= top[1]:
                    depth -= 1
                    won = 0
                    if depth > 0:
                        top = stack[base + (depth - 1) * ROWS]
                        won = first_place_won(top[0], top[2], place, g)
                if won <= last:
                    top = vec4i(place, won, g, nearest[voxel])
                    stack[base + depth * ROWS] = top
                    depth += 1
            place += 1
            voxel += step
    if depth > 0:
        for c in range(begin, end):
            voxel = lines.order[begin + end - 1 - c] * BLOCK_VOXELS + offset + (SIDE - 1) * step
            for _ in range(size):
                place -= 1
                while place < top[1]:
                    depth -= 1
                    top = stack[base + (depth - 1) * ROWS]
                apart = abs(place - top[0])
                g = int(FAR)
                if apart <= reach:
                    g = apart * apart + top[2]
                if g > limit:
                    g = int(FAR)
                sqdists[voxel] = g
                nearest[voxel] = top[3]
                voxel -= step


def sweep_blocks(keys: Keys, reach: int, limit: int, sqdists: Integers, nearest: Integers) -> None:
    """Spread seeds over blocks, in place.

    Args:
        keys: int64 [m], ascending: the blocks, up to `reach` voxels around each seed.
        reach: Voxels along an axis that a distance may span, at most LONGEST.
        limit: The largest squared distance [voxels^2] that counts, below FAR.
        sqdists: int32 [m * 512], 0 at seeds and FAR elsewhere; then the squared distance to the nearest seed, FAR
            where it is beyond the limit.
        nearest: int32 [m * 512], the number of each seed at it; then that of the nearest, where there is one.
    """
    if not keys.size:
        return
    stack: Array1[vec4i] = empty(sqdists.size, vec4i, keys.device)
    for axis in (2, 1, 0):
        lines = BlockLines(keys, axis)
        launch(sweep_lines_kernel, lines.count * ROWS, [lines, reach, limit, sqdists, nearest, stack])
