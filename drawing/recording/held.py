"""What a recorder shows under a name: `Held`; and the style that it was given."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..render.parts import Matrix
from ..render.styles import STYLE_KEYS, Style
from .shapes import pose_about
from .timeline import Placed


@dataclasses.dataclass(frozen=True, eq=False)
class Held:
    """What is shown under a name: the numbers of its shapes, where they count from, and how it is drawn and lies."""

    shapes: tuple[int, ...]
    origin: NDArray[np.float64]
    style: Style
    pose: Matrix | None

    def placed(self, origin: NDArray[np.float64]) -> Placed:
        """Where it lies, about another origin."""
        return Placed(self.shapes, pose_about(self.pose, self.origin, origin))


def style_of(style: dict[str, Any]) -> Style:
    """A style by its keys.

    Raises:
        ValueError: A key that there is not, or a value out of range.
    """
    return Style(**fields_of(style))


def fields_of(style: dict[str, Any]) -> dict[str, Any]:
    """The keys of a style, all known.

    Raises:
        ValueError: One is not.
    """
    unknown = [key for key in style if key not in STYLE_KEYS]
    if unknown:
        raise ValueError(f"style: expected {', '.join(STYLE_KEYS)}, got {unknown[0]!r}")
    return style
