"""Which way is up in a mesh: `Upright`."""

from __future__ import annotations

from typing import Any

from ...core.upward import Direction, check_up
from ...pcd.units import InUnit


class Upright(InUnit):
    """What has a unit of length and says which way is up."""

    _up: Direction | None = None

    @property
    def up(self) -> Direction | None:
        """Which way is up, a direction of length 1, as a file of glTF or you told it; None where it is not known.

        Views that are fitted (`render`, recordings, the viewer) show it upright; where it is not known, z is up. To
        assign an axis ("y") or a direction turns no vertex. It goes along through operations, and turns with the mesh.

        Raises:
            TypeError: What is assigned is no text and no direction.
            ValueError: Another text than x, y and z, or a direction of no length.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh.create_cone()
            >>> mesh.up = "y"
            >>> mesh.rotate(np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]), (0, 0, 0)).up
            (0.0, 0.0, 1.0)
        """
        return self._up

    @up.setter
    def up(self, value: Any) -> None:
        self._up = None if value is None else check_up(value)
