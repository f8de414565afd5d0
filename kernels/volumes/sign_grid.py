"""A sampled field, and on which side of a level its samples lie: words of 32 signs along the rows of the grid.

A thread a word: reads the field once, 4 B a sample, and writes 8 B a word, 4 more where cells are looked at for samples
that are not finite. On CUDA the lanes of a warp read neighbouring samples and pack a word together.
"""

import numpy as np

from ..array_types import Array2
from ..lang import (
    array,
    atomic_max,
    ballot,
    bit_count,
    float32,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    struct,
    tid,
    vec3,
)
from ..memory import empty, host_view, zeros
from .bit_rows import WORD, above, has_next


@struct
class SampledField:
    """A field on a grid of samples.

    Attributes:
        values: float32 [nx * ny, nz].
        nx, ny, nz: Samples along each axis.
        level: The value on the surface.
        origin, spacing: Place [m] of sample (0, 0, 0), and the distance [m] between neighbours along each axis.
    """

    values: array(dtype=float32, ndim=2)
    ny: int
    nz: int
    level: float
    origin: vec3
    spacing: vec3

    def __init__(
        self,
        values: Array2[float32],
        shape: tuple[int, int, int],
        level: float,
        origin: np.ndarray,
        spacing: np.ndarray,
    ) -> None:
        self.values, (self.nx, self.ny, self.nz), self.level = values, shape, level
        self.origin, self.spacing = vec3(*origin), vec3(*spacing)


@struct
class SignGrid:
    """On which side of the level the samples of a field lie, a bit each.

    Attributes:
        width: Words a row.
        rows: Rows, one for each (x, y).
        ny, nz: Rows with one x, and samples a row.
        signs: int32 [rows * width], set below the level.
        finite: Likewise, set for finite samples.
        whole: Likewise, set for cells whose eight corners are finite; undefined where all samples are.
        has_gaps: int32 [1], 1 where a sample is not finite.
    """

    width: int
    rows: int
    ny: int
    nz: int
    signs: array(dtype=int32)
    finite: array(dtype=int32)
    whole: array(dtype=int32)
    has_gaps: array(dtype=int32)

    def __init__(self, field: SampledField) -> None:
        device, self.ny, self.nz = field.values.device, field.ny, field.nz
        self.width, self.rows = -(-field.nz // WORD), field.nx * field.ny
        self.signs, self.finite, self.whole = (empty(self.rows * self.width, int32, device) for _ in range(3))
        self.has_gaps = zeros(1, int32, device)
        words = self.rows * self.width
        launch(pack_signs_kernel, -(-words // WORD) * WORD if device.is_cuda else words, [field, self])  # whole warps
        if device.is_cuda or host_view(self.has_gaps)[0]:
            launch(find_whole_cells_kernel, self.rows, [self])


@kernel
def pack_signs_kernel(field: SampledField, grid: SignGrid):
    """One thread a word; bits beyond the end of the row are zero."""
    i = tid()
    row = i // grid.width
    first = (i - row * grid.width) * WORD
    size = min(field.nz - first, WORD)
    below = 0
    known = 0
    if size == WORD:  # a count that compilers know: vector code
        for j in range(WORD):
            value = field.values[row, first + j]
            below = below | (int(value < field.level) << j)
            known = known | (int(isfinite(value)) << j)
    else:
        for j in range(size):
            value = field.values[row, first + j]
            below = below | (int(value < field.level) << j)
            known = known | (int(isfinite(value)) << j)
    grid.signs[i] = below
    grid.finite[i] = known
    if bit_count(known) < size:
        atomic_max(grid.has_gaps, 0, 1)  # set by any thread


@pack_signs_kernel.on_cuda
def pack_lanes_kernel(field: SampledField, grid: SignGrid):
    """A warp packs the words of its threads in turn, a sample a lane: neighbouring lanes read neighbouring samples."""
    i = tid()
    lane = i % WORD
    below = 0
    known = 0
    n = int(WORD)
    for turn in range(n):
        word = i - lane + turn
        row = word // grid.width
        k = (word - row * grid.width) * WORD + lane
        is_below = 0
        is_known = 0
        if row < grid.rows and k < field.nz:
            value = field.values[row, k]
            is_below = int(value < field.level)
            is_known = int(isfinite(value))
        signs = ballot(is_below)
        finite = ballot(is_known)
        if lane == turn:
            below = signs
            known = finite
    if i < grid.rows * grid.width:
        grid.signs[i] = below
        grid.finite[i] = known
        if bit_count(known) < min(field.nz - i % grid.width * WORD, WORD):
            atomic_max(grid.has_gaps, 0, 1)  # set by any thread


@func
def finite_pairs(row: int, w: int, grid: SignGrid) -> int:
    """The samples of a word that are finite, as is the one above them."""
    return grid.finite[row * grid.width + w] & above(grid.finite, row, w, grid.width)


@kernel
def find_whole_cells_kernel(grid: SignGrid):
    """The cells whose eight corners are finite; one thread a row. Does nothing where the whole field is finite."""
    i = tid()
    if grid.has_gaps[0] == 0:
        return
    y = i % grid.ny
    for w in range(grid.width):
        cells = 0
        if y + 1 < grid.ny and i + grid.ny < grid.rows:
            cells = has_next(w, grid.nz) & finite_pairs(i, w, grid) & finite_pairs(i + 1, w, grid)
            cells = cells & finite_pairs(i + grid.ny, w, grid) & finite_pairs(i + grid.ny + 1, w, grid)
        grid.whole[i * grid.width + w] = cells
