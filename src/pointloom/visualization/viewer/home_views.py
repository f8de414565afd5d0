"""Refit the view of unmoved cameras when the scene grows beyond it: `Arrivals`, `Homes`."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

import numpy as np

from .camera import diagonal
from .items import Bounds

if TYPE_CHECKING:
    from .scene import Scene

OUTGROWN = 0.1  # of the diagonal of the fitted bounds: larger growth causes a refit
MAX_HOMES = 8  # a page reports its position with a delay


class Arrivals:
    """Detects that a scene has outgrown the fitted view of its pages."""

    def __init__(self, scene: Scene):
        self._scene, self._has_come = scene, False
        self._fitted: Bounds | None = None

    def note(self) -> None:
        """Report an added geometry."""
        self._has_come = True

    def fitted(self) -> None:
        """Report that pages show the complete scene."""
        self._fitted = self._scene.bounds

    def fit(self) -> None:
        """Refit the view of unmoved cameras if the scene has outgrown it; once for several additions."""
        has_come, self._has_come = self._has_come, False
        scene, seen = self._scene, self._fitted
        if not has_come or scene._has_own_view or seen is None:
            return
        (low, high), slack = scene.bounds, OUTGROWN * diagonal(seen)
        if (low < seen[0] - slack).any() or (high > seen[1] + slack).any():
            self.fitted()
            for session in scene._open_sessions():
                with session.as_it_lasts():
                    session.go_home_if_still()


class Homes:
    """The last few fitted camera positions of a page."""

    def __init__(self) -> None:
        self._positions: deque[Any] = deque(maxlen=MAX_HOMES)

    def put(self, position: Any) -> None:
        self._positions.append(position)

    def leave(self) -> None:
        self._positions.clear()

    def are_at(self, position: Any) -> bool:
        """True if the camera is at one of them."""
        return any(np.allclose(position, home, rtol=1e-4, atol=0) for home in self._positions)
