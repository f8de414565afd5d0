"""Packing of charts in a square texture."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ...kernels.textures.charts import Cells, Packing

CELL_TEXELS = 6  # texels per side of an unseen triangle: 3 for its legs, the rest padding
SHARED_CELL_TEXELS = 4  # texels per side of the cell shared by all unseen triangles
MAX_CELLS = 0.5  # maximum fraction of the texture for such triangles; beyond, all share one cell
SIZE_STEP = 64  # texels: automatic sizes are multiples of it
SCALE_PRECISION, MAX_SCALES = 0.5**7, 40  # precision of the scale. Maximum number of scales tried


def pack_charts(
    boxes: NDArray[np.int64], blind: int, has_colors: bool, padding: int, size: int | None, largest: int
) -> Packing:
    """Pack charts (c, 4) in rows by decreasing height; `size` None: as needed for full scale, up to `largest`."""
    extents = boxes[:, 2:]
    if size is not None:
        return _largest_scale(extents, blind, has_colors, padding, size)
    area = float(((extents + 2 * padding).prod(axis=1)).sum()) + blind * CELL_TEXELS * CELL_TEXELS * has_colors
    side = math.ceil(max(math.sqrt(area), (extents.max(initial=1) + 2 * padding), SIZE_STEP) / SIZE_STEP) * SIZE_STEP
    while side < largest:
        packing = _pack(extents, blind, has_colors, padding, side, 1.0)
        if packing is not None:
            return packing
        side += max(SIZE_STEP, side // 20 // SIZE_STEP * SIZE_STEP)
    return _largest_scale(extents, blind, has_colors, padding, largest)


def _largest_scale(extents: NDArray[np.int64], blind: int, has_colors: bool, padding: int, size: int) -> Packing:
    best = _pack(extents, blind, has_colors, padding, size, 1.0)
    low, high = 0.0, 1.0
    for _ in range(MAX_SCALES):
        if best is not None and high - low < SCALE_PRECISION * high:
            return best
        scale = (low + high) / 2
        candidate = _pack(extents, blind, has_colors, padding, size, scale)
        if candidate is None:
            high = scale
        else:
            low, best = scale, candidate
    if best is not None:
        return best
    have = f"{len(extents):,} charts with a padding of {padding} texels"
    raise ValueError(f"size: {size} x {size} texels are too few for {have}. Increase size or smoothness")


def _pack(
    extents: NDArray[np.int64], blind: int, has_colors: bool, padding: int, size: int, scale: float
) -> Packing | None:
    """Rows of charts at a scale. None if they do not fit."""
    cells, floor = _cells(blind, has_colors, padding, size)
    sides = np.ceil((extents - 1) * scale).astype(np.int64) + 1 + 2 * padding
    if (sides > size).any() or float(sides.prod(axis=1).sum()) > size * floor:
        return None
    order = np.lexsort((np.arange(len(sides)), -sides[:, 0], -sides[:, 1]))
    corners = [(0, 0)] * len(sides)
    x = y = height = 0
    for k, (width, rows) in zip(order.tolist(), sides[order].tolist(), strict=True):
        if x + width > size:
            x, y, height = 0, y + height, 0
        if not height:
            height = rows
        corners[k] = (x, y)
        x += width
    if y + height > floor:
        return None
    positions = np.array(corners, np.int64).reshape(-1, 2) + padding
    return Packing(size, scale, positions, cells)


def _cells(blind: int, has_colors: bool, padding: int, size: int) -> tuple[Cells, int]:
    """Cells at the bottom of the texture, and the rows above them."""
    if not blind:
        return Cells(0, 1, 0), size
    columns = max(size // CELL_TEXELS, 1)
    rows = -(-blind // columns) * CELL_TEXELS
    if has_colors and rows <= MAX_CELLS * size:
        return Cells(size - rows, columns, CELL_TEXELS), size - rows - padding
    return Cells(size - SHARED_CELL_TEXELS, 1, 0), size - SHARED_CELL_TEXELS - padding
