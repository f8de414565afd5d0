"""Levels of frames elsewhere: in others of the same sizes, and one level's pixels side by side for the host.

One thread a pixel, 24 B read and as many written.
"""

from ..array_types import Array2
from ..lang import array, float32, kernel, launch, tid
from ..memory import empty
from .pyramid import FrameLevels


@kernel
def pack_level_kernel(levels: FrameLevels, first: int, rows: array(dtype=float32, ndim=2)):
    """Depth and plane of each pixel of a level, from its first one on."""
    i = tid()
    rows[i, 0] = levels.depth[first + i]
    for k in range(4):
        rows[i, 1 + k] = levels.planes[first + i][k]


def level_rows(levels: FrameLevels, level: int) -> Array2[float32]:
    """Depth and plane of each pixel of a level side by side, float32 [pixels, 5]."""
    rows = empty((int(levels.counts[level]), 5), float32, levels.device)
    launch(pack_level_kernel, rows.shape[0], [levels, int(levels.firsts[level]), rows])
    return rows


@kernel
def copy_levels_kernel(levels: FrameLevels, out: FrameLevels):
    """The levels of a frame, in those of the same sizes."""
    i = tid()
    out.depth[i] = levels.depth[i]
    out.brightness[i] = levels.brightness[i]
    out.planes[i] = levels.planes[i]
    if i < levels.lenses.shape[0]:
        out.lenses[i] = levels.lenses[i]
