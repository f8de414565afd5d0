"""What is added beyond the view is seen by pages whose camera nobody has moved: `Arrivals`, `Homes`."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

import numpy as np

from .camera import diagonal
from .items import Bounds

if TYPE_CHECKING:
    from .scene import Scene

OUTGROWN = 0.1  # of the diagonal of what pages see, by which something that is added lies beyond it
MOST_HOMES = 8  # a page says where it is a little later than it is put there


class Arrivals:
    """Whether a scene has outgrown what its pages were made to see.

    Args:
        scene: The scene.
    """

    def __init__(self, scene: Scene):
        self._scene, self._has_come = scene, False
        self._fitted: Bounds | None = None

    def note(self) -> None:
        """Something was added."""
        self._has_come = True

    def fitted(self) -> None:
        """Pages see all of the scene now."""
        self._fitted = self._scene.bounds

    def fit(self) -> None:
        """Show what was added beyond the view where nobody has moved the camera; once for many additions."""
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
    """Where the camera of a page was put to see all of the scene, the last few times."""

    def __init__(self) -> None:
        self._positions: deque[Any] = deque(maxlen=MOST_HOMES)

    def put(self, position: Any) -> None:
        """It was put there."""
        self._positions.append(position)

    def leave(self) -> None:
        """It was put somewhere else."""
        self._positions.clear()

    def are_at(self, position: Any) -> bool:
        """Whether it is at one of them."""
        return any(np.allclose(position, home, rtol=1e-4, atol=0) for home in self._positions)
