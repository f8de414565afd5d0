"""The definition of an operation timed on a GPU, and clouds shared by several of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import scenes

DEVICE = "cuda:0"


@dataclass(frozen=True)
class Operation:
    """An operation at some sizes.

    Attributes:
        prepare: (size) -> the timed call, without arguments.
        sizes: Sizes of the data.
    """

    name: str
    prepare: Callable[[int], Callable[[], Any]]
    sizes: tuple[int, ...] = (200_000, 1_000_000)


def cloud_of(size: int, seed: int = 0) -> Any:
    """The bumpy surface on the device."""
    import pointloom as loom

    return loom.PointCloud(scenes.bumpy_surface(size, seed), device=DEVICE)


def spacing_of(size: int) -> float:
    """A length [m] that contains the same number of points at each size: 1 at 200,000."""
    return (200_000 / size) ** 0.5
