"""Extrema of differences of Gaussians, to a fraction of a pixel and of a level; weak ones and those on edges left out.

A pixel is an extremum where its difference of two levels is beyond those of all 26 neighbours, in its own difference
and in the two beside it. A quadratic through the differences tells how far off its middle the extremum is; where that
is over 0.6 pixels it is asked again from the next pixel, up to five times. Kept are those with a difference of at least
`PEAK`, and less than ten times as curved one way as the other.

`mark_extrema_kernel`: one thread 16 pixels of a row; reads most of the time 8 B a pixel, 144 B where much is going on;
writes 8 B for the 16. `refine_extrema_kernel`: one thread an extremum, some 200 operations a turn, in float64.

Source: Lowe 2004, sections 3.1 and 4; thresholds and order of VLFeat's sift.c, which COLMAP uses.
"""

import numpy as np

from ..algebra.plain_min_max import larger, smaller
from ..array_types import Array1, Indices, Integers, Mask
from ..arrays.prefix_sum import scan_together
from ..arrays.select import positions_and_starts
from ..lang import (
    array,
    bit_count,
    float32,
    float64,
    floor,
    func,
    int32,
    kernel,
    launch,
    tid,
    uint8,
    vec3d,
    vec4,
    vector,
)
from ..memory import empty
from .scale_space import BASE_SIGMA, LANES, SCALES, Octave, lanes

PEAK = 0.02 / 3  # of a difference of two levels, brightness being 0 to 1
EDGE = 10.0  # times as curved across as along
BEFORE = 0.8  # share of PEAK that a pixel wants before its extremum is known
FARTHEST = 0.6  # pixels from the middle of the pixel that is asked; farther, the next one is
TURNS = 5
LOST = 1.5  # pixels or levels off, beyond which there is no extremum here
LN_2_OF_A_LEVEL = 0.23104906018664842  # ln 2 / 3: of the sigmas of two levels that follow each other
LEVEL_FACTOR = 1.2599210498948732

quadratic = vector(10, float64)


@func
def difference(at: int, size: int, levels: array(dtype=float32)) -> float:
    """Of two levels at a pixel; `at` is its place in the finer one."""
    return levels[at + size] - levels[at]


@func
def is_beyond(at: int, size: int, stride: int, levels: array(dtype=float32)) -> bool:
    """Whether a difference is above all nine beside it in both neighbouring levels, or, negative, below them."""
    here = difference(at, size, levels)
    highest = float(-1.0e30)
    lowest = float(1.0e30)
    for k in range(9):
        beside = at + (k // 3 - 1) * stride + k % 3 - 1
        finer = difference(beside - size, size, levels)
        coarser = difference(beside + size, size, levels)
        highest = larger(highest, larger(finer, coarser))
        lowest = smaller(lowest, smaller(finer, coarser))
    return here > highest if here > 0.0 else here < lowest


@kernel
def mark_extrema_kernel(octave: Octave, least: float, counts: array(dtype=int32), marks: array(dtype=int32)):
    """How many of 16 pixels are extrema of a difference, and which, as bits."""
    i = tid()
    blocks = octave.stride // LANES
    row = (i // blocks) % octave.height
    size = octave.height * octave.stride
    level = 1 + i // (blocks * octave.height)
    found = 0
    if row >= 1 and row <= octave.height - 2:
        at = level * size + row * octave.stride + (i % blocks) * LANES
        here = lanes(0.0)
        peak = float(0.0)
        for j in range(LANES):
            here[j] = difference(at + j, size, octave.levels)
            peak = larger(peak, abs(here[j]))
        if peak >= least:
            highest = lanes(-1.0e30)
            lowest = lanes(1.0e30)
            for k in range(9):
                if k != 4:
                    beside = at + (k // 3 - 1) * octave.stride + k % 3 - 1
                    for j in range(LANES):
                        d = difference(beside + j, size, octave.levels)
                        highest[j] = larger(highest[j], d)
                        lowest[j] = smaller(lowest[j], d)
            for j in range(LANES):
                x = (i % blocks) * LANES + j
                beyond = (here[j] >= least and here[j] > highest[j]) or (here[j] <= -least and here[j] < lowest[j])
                if beyond and x >= 1 and x <= octave.width - 2:
                    found = found | (1 << j)
            for j in range(LANES):
                if (found & (1 << j)) != 0:
                    if not is_beyond(at + j, size, octave.stride, octave.levels):
                        found = found & ~(1 << j)
    marks[i] = found
    counts[i] = bit_count(found)


@kernel
def list_extrema_kernel(octave: Octave, marks: array(dtype=int32), offsets: array(dtype=int32), at: array(dtype=int32)):
    """The places of marked pixels in the levels, in ascending order."""
    i = tid()
    to = offsets[i]
    if marks[i] != 0:
        for j in range(LANES):
            if (marks[i] & (1 << j)) != 0:
                at[to] = octave.height * octave.stride + i * LANES + j
                to += 1


@func
def exponential(x: float64) -> float64:
    """e^x for x within -0.5 .. 0.5, to 1e-9."""
    total = float64(1.0)
    terms = int(9)
    for k in range(terms):
        total = 1.0 + x * total / float64(terms - k)
    return total


@func
def wide(at: int, size: int, levels: array(dtype=float32)) -> float64:
    """A difference of two levels, in float64."""
    return float64(levels[at + size]) - float64(levels[at])


@func
def quadratic_at(at: int, size: int, stride: int, levels: array(dtype=float32)) -> quadratic:
    """The difference at a pixel, its slopes along x, y and the levels, and its Hessian: xx, yy, ss, xy, xs, ys."""
    here = wide(at, size, levels)
    left = wide(at - 1, size, levels)
    right = wide(at + 1, size, levels)
    above = wide(at - stride, size, levels)
    below = wide(at + stride, size, levels)
    finer = wide(at - size, size, levels)
    coarser = wide(at + size, size, levels)
    xy = wide(at + 1 + stride, size, levels) + wide(at - 1 - stride, size, levels)
    xy = xy - wide(at - 1 + stride, size, levels) - wide(at + 1 - stride, size, levels)
    xs = wide(at + 1 + size, size, levels) + wide(at - 1 - size, size, levels)
    xs = xs - wide(at - 1 + size, size, levels) - wide(at + 1 - size, size, levels)
    ys = wide(at + stride + size, size, levels) + wide(at - stride - size, size, levels)
    ys = ys - wide(at - stride + size, size, levels) - wide(at + stride - size, size, levels)
    found = quadratic(float64(0.0))
    found[0] = here
    found[1] = (right - left) * 0.5
    found[2] = (below - above) * 0.5
    found[3] = (coarser - finer) * 0.5
    found[4] = right + left - 2.0 * here
    found[5] = below + above - 2.0 * here
    found[6] = coarser + finer - 2.0 * here
    found[7] = 0.25 * xy
    found[8] = 0.25 * xs
    found[9] = 0.25 * ys
    return found


@func
def solved(q: quadratic) -> vec3d:
    """The step to where a quadratic is flat; zero where it is flat along a whole line."""
    a = q[5] * q[6] - q[9] * q[9]
    b = q[8] * q[9] - q[7] * q[6]
    c = q[7] * q[9] - q[8] * q[5]
    d = q[7] * q[8] - q[4] * q[9]
    determinant = q[4] * a + q[7] * b + q[8] * c
    step = vec3d(0.0, 0.0, 0.0)
    if determinant != 0.0:
        x = a * q[1] + b * q[2] + c * q[3]
        y = b * q[1] + (q[4] * q[6] - q[8] * q[8]) * q[2] + d * q[3]
        s = c * q[1] + d * q[2] + (q[4] * q[5] - q[7] * q[7]) * q[3]
        step = vec3d(-x / determinant, -y / determinant, -s / determinant)
    return step


@func
def way(step: float64, at: int, side: int) -> int:
    """To which neighbouring pixel an extremum is off, along one side of the picture: -1, 0 or 1."""
    found = 0
    if step > FARTHEST and at < side - 2:
        found = 1
    if step < -FARTHEST and at > 1:
        found = -1
    return found


@func
def is_seen(x: float64, y: float64, mask: array(dtype=uint8), width: int) -> bool:
    """Whether the pixel of the picture that a place lies in is not masked; an empty mask leaves out nothing."""
    seen = int(1)
    if mask.shape[0] > 0:
        column = min(int(floor(x + 0.5)), width - 1)
        row = min(int(floor(y + 0.5)), mask.shape[0] // width - 1)
        seen = int(mask[row * width + column])
    return seen != 0


@kernel
def refine_extrema_kernel(
    octave: Octave,
    at: array(dtype=int32),
    peak: float64,
    edge: float64,
    mask: array(dtype=uint8),
    mask_width: int,
    places: array(dtype=vec4),
    kept: array(dtype=uint8),
):
    """Where an extremum is (x, y, sigma, all in pixels of the octave; level), and whether it is kept."""
    i = tid()
    stride = octave.stride
    size = octave.height * stride
    level = at[i] // size
    y = (at[i] % size) // stride
    x = at[i] % stride
    q = quadratic_at(at[i], size, stride, octave.levels)
    step = solved(q)
    turns = int(TURNS)
    for _ in range(turns - 1):
        right = way(step[0], x, octave.width)
        down = way(step[1], y, octave.height)
        if right != 0 or down != 0:
            x += right
            y += down
            q = quadratic_at(level * size + y * stride + x, size, stride, octave.levels)
            step = solved(q)
    value = q[0] + 0.5 * (q[1] * step[0] + q[2] * step[1] + q[3] * step[2])
    bend = q[4] * q[5] - q[7] * q[7]
    both = q[4] + q[5]
    round = bend > 0.0 and both * both * edge < (edge + 1.0) * (edge + 1.0) * bend
    px = float64(x) + step[0]
    py = float64(y) + step[1]
    near = abs(step[0]) < LOST and abs(step[1]) < LOST and abs(step[2]) < LOST
    near = near and px >= 0.0 and px <= float64(octave.width - 1) and py >= 0.0 and py <= float64(octave.height - 1)
    good = 0
    if near and round and abs(value) > peak:
        sigma = float64(BASE_SIGMA) * exponential(float64(LN_2_OF_A_LEVEL) * step[2])
        for _ in range(level):
            sigma = sigma * float64(LEVEL_FACTOR)
        places[i] = vec4(float(px), float(py), float(sigma), float(level))
        if is_seen(px * float64(octave.step), py * float64(octave.step), mask, mask_width):
            good = 1
    kept[i] = uint8(good)


class Extrema:
    """The kept extrema of an octave.

    Args:
        octave: Its levels.
        mask: uint8 [height * width] of the picture: those where it is 0 are left out; empty for all.
        mask_width: Of the picture [px].

    Attributes:
        places: x, y, sigma [px of the octave] and level of each extremum, kept or not.
        rows: Those that are kept, by level, row and column.
        counts: How many of these each of the three levels has.
    """

    places: Array1[vec4]
    rows: Indices
    counts: list[int]

    def __init__(self, octave: Octave, mask: Mask, mask_width: int) -> None:
        threads, device = octave.height * octave.blocks, octave.device
        counts: Integers = empty(SCALES * threads, int32, device)
        marks: Integers = empty(SCALES * threads, int32, device)
        launch(mark_extrema_kernel, counts.size, [octave, BEFORE * PEAK, counts, marks])
        [(offsets, ends)] = scan_together([(counts, [threads, 2 * threads, 3 * threads])])  # sync
        at: Indices = empty(ends[-1], int32, device)
        launch(list_extrema_kernel, counts.size, [octave, marks, offsets, at])
        self.places, kept = empty(at.size, vec4, device), empty(at.size, uint8, device)
        launch(refine_extrema_kernel, at.size, [octave, at, PEAK, EDGE, mask, mask_width, self.places, kept])
        self.rows, starts = positions_and_starts(kept, np.array([0, *ends]))  # sync
        self.counts = (starts[1:] - starts[:-1]).tolist()
