"""Refit the view of unmoved cameras when the scene grows beyond it: `AutoFit`, `Homes`."""

from __future__ import annotations

from collections import deque
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .camera import diagonal
from .items import Bounds

MAX_GROWTH = 0.1  # of the diagonal of the fitted bounds: larger growth causes a refit
MAX_HOMES = 8  # a page reports its position with a delay


class AutoFit:
    """Detects that a scene has outgrown the fitted view of its pages."""

    def __init__(self) -> None:
        self._was_added_to = False
        self._fitted: Bounds | None = None

    def on_added(self) -> None:
        self._was_added_to = True

    def on_fitted(self, bounds: Bounds) -> None:
        """Store the bounds of the complete scene that pages show."""
        self._fitted = bounds

    def apply(self, bounds: Bounds | None) -> bool:
        """True if unmoved cameras need a new fit to these bounds, once for several additions. None: never."""
        was_added_to, self._was_added_to = self._was_added_to, False
        fitted = self._fitted
        if not was_added_to or bounds is None or fitted is None:
            return False
        (low, high), slack = bounds, MAX_GROWTH * diagonal(fitted)
        has_grown = bool((low < fitted[0] - slack).any() or (high > fitted[1] + slack).any())
        if has_grown:
            self._fitted = bounds
        return has_grown


class Homes:
    """The last few fitted camera positions of a page."""

    def __init__(self) -> None:
        self._positions: deque[Any] = deque(maxlen=MAX_HOMES)

    def put(self, position: ArrayLike) -> None:
        self._positions.append(position)

    def leave(self) -> None:
        self._positions.clear()

    def are_at(self, position: Any) -> bool:
        """True if the camera is at one of them."""
        return any(np.allclose(position, home, rtol=1e-4, atol=0) for home in self._positions)
