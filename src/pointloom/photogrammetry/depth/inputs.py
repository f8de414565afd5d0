"""Resizing between images and network inputs: pixel x of n columns maps to (x + 0.5) m / n - 0.5.

Downscaling averages areas (the networks use OpenCV's bicubic samples; the difference is below their noise). Float32 by
Pillow in one thread: bitwise reproducible.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from .presets import Preset, input_size

Map = NDArray[np.float32]
# Times the root of half a side: ZoeDepth's border, without which its maps are wrong near the border.
REFLECTED_BORDER_FACTOR = 3


@dataclasses.dataclass(frozen=True)
class Placement:
    """Position of an image in the network input: first row and column, used size, and reflected border [image px]."""

    height: int
    width: int
    rows: int
    columns: int
    top: int
    left: int
    used: tuple[int, int]
    border: tuple[int, int] = (0, 0)

    @property
    def scale(self) -> tuple[float, float]:
        """Input pixels per image pixel, along x and y."""
        return self.used[1] / (self.width + 2 * self.border[1]), self.used[0] / (self.height + 2 * self.border[0])


def placement_of(preset: Preset, height: int, width: int, fixed: tuple[int | None, int | None]) -> Placement:
    """Placement of an image in an input with these fixed rows and columns (None: dynamic)."""
    border = (0, 0)
    if preset.reflects and not any(fixed):
        border = (
            int(math.sqrt(height / 2) * REFLECTED_BORDER_FACTOR),
            int(math.sqrt(width / 2) * REFLECTED_BORDER_FACTOR),
        )
    chosen = input_size(preset, height + 2 * border[0], width + 2 * border[1])
    rows, columns = (side or wanted for side, wanted in zip(fixed, chosen, strict=True))
    if not (preset.sizing == "pad" or (preset.fixed_pads and any(fixed))):
        return Placement(height, width, rows, columns, 0, 0, (rows, columns), border)
    scale = min(rows / height, columns / width)
    used = max(int(height * scale), 1), max(int(width * scale), 1)
    return Placement(height, width, rows, columns, (rows - used[0]) // 2, (columns - used[1]) // 2, used)


def prepare(preset: Preset, image: NDArray[np.uint8], placement: Placement) -> Map:
    """Network input, float32 [3, rows, columns], padded with ImageNet's mean."""
    mean, std = (np.array(values, np.float32)[:, None, None] for values in (preset.mean, preset.std))
    used, (down, across) = placement.used, placement.border
    if down or across:
        image = np.pad(image, ((down, down), (across, across), (0, 0)), mode="reflect")
    small = np.stack(
        [resize(image[..., channel].astype(np.float32), used, Image.Resampling.BICUBIC) for channel in range(3)]
    )
    small = np.clip(small, 0.0, 255.0)  # bicubic kernels overshoot at edges
    values = (small * np.float32(preset.levels / 255.0) - mean) / std
    if used == (placement.rows, placement.columns):
        return values
    filling = (np.array([0.485, 0.456, 0.406]) * preset.levels - np.array(preset.mean)) / np.array(preset.std)
    padded = np.empty((3, placement.rows, placement.columns), np.float32)
    padded[:] = filling.astype(np.float32)[:, None, None]
    inside = slice(placement.top, placement.top + used[0]), slice(placement.left, placement.left + used[1])
    padded[:, *inside] = values
    return padded


def bring_back(values: Map, placement: Placement) -> Map:
    top, left, used, (down, across) = placement.top, placement.left, placement.used, placement.border
    size = placement.height + 2 * down, placement.width + 2 * across
    resized = resize(values[top : top + used[0], left : left + used[1]], size)
    return resized[down : size[0] - down, across : size[1] - across]


def resize(values: Map, size: tuple[int, int], kind: Image.Resampling = Image.Resampling.BILINEAR) -> Map:
    if values.shape == size:
        return np.array(values, np.float32)
    image = Image.fromarray(np.ascontiguousarray(values, np.float32))
    return np.array(image.resize((size[1], size[0]), kind), np.float32)
