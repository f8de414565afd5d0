"""The definition of an operation timed on a GPU, and clouds shared by several of them."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import scenes

DEVICE = "cuda:0"
PATCH, COLUMNS = 1_000_000, 8  # points of a patch of a large surface, and patches in a row


SIZES = {640 * 480: (640, 480), 1920 * 1080: (1920, 1080), 3840 * 2160: (3840, 2160)}
VGA, FULL_HD, UHD = SIZES  # pixels


@dataclass(frozen=True)
class Operation:
    """An operation at some sizes.

    Attributes:
        prepare: (size) -> the timed call, without arguments.
        sizes: Sizes of the data.
        small: Size in a dry run on the emulated device.
        large: Sizes of the step `large`, which also measures the memory.
        in_new_state: True if each call needs a new preparation, because its result is cached.
    """

    name: str
    prepare: Callable[[int], Callable[[], Any]]
    sizes: tuple[int, ...] = (200_000, 1_000_000)
    small: int = 3000
    large: tuple[int, ...] = ()
    in_new_state: bool = False


@functools.lru_cache(maxsize=2)
def surface_of(size: int, seed: int = 0) -> np.ndarray:
    """The bumpy surface. Above a million points: patches of a million beside each other."""
    if size <= PATCH:
        return scenes.bumpy_surface(size, seed)
    count = -(-size // PATCH)
    points = np.tile(scenes.bumpy_surface(PATCH, seed).astype(np.float32), (count, 1, 1))
    points[:, :, 0] += (scenes.SURFACE_EDGE * (np.arange(count) % COLUMNS))[:, None]
    points[:, :, 1] += (scenes.SURFACE_EDGE * (np.arange(count) // COLUMNS))[:, None]
    return points.reshape(-1, 3)[:size]


def cloud_of(size: int, seed: int = 0, arrays: str = "numpy") -> Any:
    """The surface on the device, whose results are arrays of a library."""
    import pointloom as loom

    return loom.PointCloud(surface_of(size, seed), device=DEVICE).to(DEVICE, arrays=arrays)


def spacing_of(size: int) -> float:
    """A length [m] that contains the same number of points at each size: 1 at 200,000."""
    return (200_000 / min(size, PATCH)) ** 0.5


def image_size(pixels: int) -> tuple[int, int]:
    """Width and height of an image with a number of pixels; 4:3 except for the usual sizes."""
    width = round((pixels * 4 / 3) ** 0.5)
    return SIZES.get(pixels, (width, width * 3 // 4))
