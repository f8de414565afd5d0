"""What a client should see of a streamed cloud, and what it was sent: `Wish`, `Sent`."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..render.view import View

ColorsOf = Callable[[NDArray[np.int64]], NDArray[np.uint8]]
Keep = Callable[[NDArray[np.float64]], NDArray[np.bool_]]


@dataclasses.dataclass
class Wish:
    """What the client should see."""

    view: View | None = None
    colors_of: ColorsOf | None = None
    keep: Keep | None = None
    size: float | None = None
    metric: bool = False  # whether that is in metres
    coloring: int = 0  # which of all colours so far
    keeping: int = 0  # and which rule of what is kept

    @property
    def is_metric(self) -> bool:
        """Whether sizes are in metres; those that close gaps are."""
        return self.size is None or self.metric


@dataclasses.dataclass
class Sent:
    """A node in the page: what it was made with; no node where nothing of it is kept."""

    node: Any
    count: int
    mask: NDArray[np.bool_] | None
    is_exact: bool
    coloring: int
    keeping: int
    size: float
    metric: bool
    visible: bool = True
