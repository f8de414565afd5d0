"""A large picture in tiles: the network sees each part in full detail, and the whole picture says how they belong.

Each tile's inverse depth is aligned to that of the whole picture by a scale and a shift (`align_inverse_depth`), and
tiles are blended where they overlap, by weights that fall smoothly to their borders (Miangoleh et al. 2021, simplified:
one level, no merging network). A tile that does not agree with the whole is left out there. Three maps of the picture's
size in float32 at once.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from .alignment import AlignmentError, align_inverse_depth
from .inputs import Map, resize

OVERLAP = 0.25  # share of a tile's side that it has in common with the next
LEAST_SIDE = 32  # [px] below which a tile shows nothing
CELLS = 24  # a side, by which a tile is compared with the whole
MOST_TILES = 16  # along the longer side: 256 runs

Inverse = Callable[[NDArray[np.uint8]], Map]


def starts_of(length: int, side: int) -> list[int]:
    """Where tiles of this side begin so that all of the length is covered, evenly, with the overlap at least."""
    if side >= length:
        return [0]
    count = -(-(length - side) // max(int(side * (1 - OVERLAP)), 1)) + 1
    return [round(k * (length - side) / (count - 1)) for k in range(count)]


def side_of(height: int, width: int, tiles: int) -> int:
    """The side of square tiles of which so many, overlapping, cover the longer side."""
    side = -(-max(height, width) // (1 + (tiles - 1) * (1 - OVERLAP)))
    return max(int(side), LEAST_SIDE)


def refine_by_tiles(
    color: NDArray[np.uint8], whole: Map, tiles: int, inverse: Inverse, *, seed: int, say: Callable[[int, int], None]
) -> tuple[Map, int, int]:
    """The inverse depth of a picture with the detail of its tiles, how many agreed with the whole, and of how many.

    Args:
        color: Shape [h, w, 3].
        whole: Inverse depth of the whole picture at once, up to scale and shift, [h, w]; NaN where there is none.
        tiles: Along the longer side.
        inverse: Gives such a map of a part of the picture.
        seed: Of the alignments.
        say: Called with how many tiles are done, and how many there are.
    """
    height, width = whole.shape
    side = side_of(height, width, tiles)
    places = [(top, left) for top in starts_of(height, side) for left in starts_of(width, side)]
    total, weights, used = np.zeros_like(whole), np.zeros_like(whole), 0
    for done, (top, left) in enumerate(places):
        part = np.s_[top : top + side, left : left + side]
        found = _aligned(inverse(np.ascontiguousarray(color[part])), whole[part], seed)
        used += found is not None
        values = whole[part] if found is None else found
        window = np.where(np.isfinite(values), _window(values.shape), np.float32(0))
        total[part] += window * np.where(window > 0, values, np.float32(0))
        weights[part] += window
        say(done + 1, len(places))
    blended = np.where(weights > 0, total / np.where(weights > 0, weights, np.float32(1)), whole)
    return blended.astype(np.float32), used, len(places)


def _aligned(tile: Map, whole: Map, seed: int) -> Map | None:
    """The tile on the whole's scale; None where they do not agree.

    They are compared by means over cells, since the whole lacks the tile's detail, which would pass for noise. As
    residuals of the alignment are relative, the part's farthest cell is put ten times as far as its nearest.
    """
    size = min(tile.shape[0], CELLS), min(tile.shape[1], CELLS)
    small, coarse = (resize(each, size, Image.Resampling.BOX) for each in (tile, whole))  # NaN where any is
    seen = np.isfinite(small) & np.isfinite(coarse)
    d, y = small[seen].astype(np.float64), coarse[seen].astype(np.float64)
    if not len(y) or np.ptp(y) == 0:
        return None
    lift = np.ptp(y) / 9 - y.min()
    try:
        found = align_inverse_depth(d, y + lift, seed=seed)
    except AlignmentError:
        return None
    return (found.scale * tile + (found.shift - lift)).astype(np.float32)


def _window(shape: tuple[int, ...]) -> Map:
    """Weights that are 1 in the middle and fall to 0 beyond the border, by 3 t^2 - 2 t^3 over the overlap."""
    sides = []
    for length in shape:
        t = np.minimum(np.arange(length) + 0.5, length - 0.5 - np.arange(length)) / max(length * OVERLAP, 1.0)
        t = np.clip(t, 0.0, 1.0)
        sides.append(t * t * (3 - 2 * t))
    return np.outer(*sides).astype(np.float32)
