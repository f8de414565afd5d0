"""Copies of frame levels, and one level packed for the host."""

from collections.abc import Sequence

from ..array_types import Array2
from ..lang import array, float32, kernel, launch, tid
from ..memory import empty
from .pyramid import FrameLevels


@kernel
def pack_level_kernel(levels: FrameLevels, first: int, rows: array(dtype=float32, ndim=2)):
    i = tid()
    rows[i, 0] = levels.depth[first + i]
    for k in range(4):
        rows[i, 1 + k] = levels.planes[first + i][k]


def level_rows(levels: FrameLevels, level: int) -> Array2[float32]:
    """Depth and plane of each pixel of a level, float32 (pixels, 5)."""
    rows = empty((int(levels.counts[level]), 5), float32, levels.device)
    launch(pack_level_kernel, rows.shape[0], [levels, int(levels.firsts[level]), rows])
    return rows


@kernel
def copy_levels_kernel(levels: FrameLevels, out: FrameLevels, other: FrameLevels, other_out: FrameLevels):
    """Copy the images of two frames. The lenses are equal, in an array that all frames of a camera share."""
    i = tid()
    if i < levels.depth.shape[0]:
        out.depth[i] = levels.depth[i]
        out.brightness[i] = levels.brightness[i]
        out.planes[i] = levels.planes[i]
    if i < other.depth.shape[0]:
        other_out.depth[i] = other.depth[i]
        other_out.brightness[i] = other.brightness[i]
        other_out.planes[i] = other.planes[i]


def copy_levels(frames: Sequence[FrameLevels], copies: Sequence[FrameLevels]) -> None:
    """Copy the images of frames, two per launch."""
    for first in range(0, len(frames), 2):
        a, b = first, min(first + 1, len(frames) - 1)
        launch(copy_levels_kernel, max(frames[a].total, frames[b].total), [frames[a], copies[a], frames[b], copies[b]])
