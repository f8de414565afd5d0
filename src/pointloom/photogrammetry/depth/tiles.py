"""Tiled depth estimation of large images: tiles are aligned to the complete map, and blended smoothly.

Miangoleh et al. 2021, simplified: one level, no merging network. Tiles that do not agree are dropped.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from .alignment import AlignmentError, align_inverse_depth
from .inputs import Map, resize

TILE_OVERLAP = 0.25  # overlap as a fraction of a tile's side
MIN_SIDE = 32  # [px] minimum tile side
CELLS_PER_SIDE = 24  # cells per side for the comparison with the complete map
MAX_TILES = 16  # along the longer side: 256 runs

Inverse = Callable[[NDArray[np.uint8]], Map]


def starts_of(length: int, side: int) -> list[int]:
    if side >= length:
        return [0]
    count = -(-(length - side) // max(int(side * (1 - TILE_OVERLAP)), 1)) + 1
    return [round(k * (length - side) / (count - 1)) for k in range(count)]


def side_of(height: int, width: int, tiles: int) -> int:
    side = -(-max(height, width) // (1 + (tiles - 1) * (1 - TILE_OVERLAP)))
    return max(int(side), MIN_SIDE)


def refine_by_tiles(
    color: NDArray[np.uint8], full: Map, tiles: int, inverse: Inverse, *, seed: int, report: Callable[[int, int], None]
) -> tuple[Map, int, int]:
    """Refine inverse depth `full` [h, w] by tiles. Returns the map, and the numbers of accepted and of all tiles."""
    height, width = full.shape
    side = side_of(height, width, tiles)
    corners = [(top, left) for top in starts_of(height, side) for left in starts_of(width, side)]
    total, weights, used = np.zeros_like(full), np.zeros_like(full), 0
    for done, (top, left) in enumerate(corners):
        part = np.s_[top : top + side, left : left + side]
        aligned = _aligned(inverse(np.ascontiguousarray(color[part])), full[part], seed)
        used += aligned is not None
        values = full[part] if aligned is None else aligned
        window = np.where(np.isfinite(values), _window(values.shape), np.float32(0))
        total[part] += window * np.where(window > 0, values, np.float32(0))
        weights[part] += window
        report(done + 1, len(corners))
    blended = np.where(weights > 0, total / np.where(weights > 0, weights, np.float32(1)), full)
    return blended.astype(np.float32), used, len(corners)


def _aligned(tile: Map, full: Map, seed: int) -> Map | None:
    """The tile aligned to the complete map by cell means, which lack its detail. None if they do not agree."""
    size = min(tile.shape[0], CELLS_PER_SIDE), min(tile.shape[1], CELLS_PER_SIDE)
    small, coarse = (resize(each, size, Image.Resampling.BOX) for each in (tile, full))  # NaN if any pixel is
    seen = np.isfinite(small) & np.isfinite(coarse)
    d, y = small[seen].astype(np.float64), coarse[seen].astype(np.float64)
    if not len(y) or np.ptp(y) == 0:
        return None
    lift = np.ptp(y) / 9 - y.min()
    try:
        alignment = align_inverse_depth(d, y + lift, seed=seed)
    except AlignmentError:
        return None
    return (alignment.scale * tile + (alignment.shift - lift)).astype(np.float32)


def _window(shape: tuple[int, ...]) -> Map:
    """Blending weights: 1 in the center, 3 t^2 - 2 t^3 over the overlap."""
    sides = []
    for length in shape:
        t = np.minimum(np.arange(length) + 0.5, length - 0.5 - np.arange(length)) / max(length * TILE_OVERLAP, 1.0)
        t = np.clip(t, 0.0, 1.0)
        sides.append(t * t * (3 - 2 * t))
    return np.outer(*sides).astype(np.float32)
