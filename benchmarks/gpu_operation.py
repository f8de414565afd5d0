"""What an operation of the GPU model is, and what several of them are made of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import scenes
from gpu_chips import H200

DEVICE = "cuda:0"
SIZES = (200_000, 1_000_000)
POINT, NORMAL, INDEX, BOXES = 12, 12, 4, 3  # bytes a point; boxes of the tree: a 64th of 24 B by level and half


@dataclass(frozen=True)
class Operation:
    """An operation of some sizes.

    Attributes:
        prepare: (size) -> the call that is counted, without arguments.
        limit: (size) -> seconds that no such GPU goes below.
        why: What that limit is made of.
        bar: Milliseconds on the device that are asked for at `bar_size`.
        sizes: What it is run at, and what they count.
        needs: What has to be there, as a file of real data; raises DataMissingError where it is not.
        last: Kernels (a regular expression) whose results nothing in the call reads; with --fast only blocks of them
            that are counted run.
    """

    name: str
    prepare: Callable[[int], Callable[[], Any]]
    limit: Callable[[int], float]
    why: str
    bar: float | None = None
    bar_size: int = 1_000_000
    sizes: tuple[int, ...] = SIZES
    last: str = ""
    needs: Callable[[], Any] | None = None


def moved(size: float) -> float:
    """Seconds to move bytes between memory and chip, once."""
    return size / H200.memory_bandwidth


def computed(operations: float) -> float:
    """Seconds of float32 arithmetic, nothing else given out."""
    return operations / H200.float_rate


def cloud_of(size: int, seed: int = 0) -> Any:
    """The bumpy surface, on the device."""
    import pointloom as loom

    return loom.PointCloud(scenes.bumpy_surface(size, seed), device=DEVICE)


def spacing_of(size: int) -> float:
    """A length [m] that holds the same number of points at each size: 1 at 200,000."""
    return (200_000 / size) ** 0.5
