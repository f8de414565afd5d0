"""VisualizerWithEditing: a window in which a click picks a point."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...core.verbosity import LOGGER
from ...meshing.mesh.mesh import TriangleMesh
from ...pcd import cloud as native
from ...visualization.viewer.viewer import Viewer
from ..geometry import PointCloud
from .shown import drawn
from .visualizer import Visualizer

MARKS = "picked points"
MARK_STYLE = {"color": (0.9, 0.24, 0.08), "point_size": 14.0}
CROPPED = "(cropped"  # in the names that the polygon tool gives to its results


class VisualizerWithEditing(Visualizer):
    """A window that picks points of its first geometry, vertices of a mesh. The page's polygon tool crops.

    A click adds a point, a click on a picked point removes it. Without a page nothing is picked. The arguments have no
    effect.
    """

    def __init__(self, voxel_size: float = -1.0, use_dialog: bool = True, directory: str = ""):
        super().__init__()
        self._picked: dict[int, Any] = {}  # coordinates by index, in the order of the clicks
        self._cropped: Any = None

    def on_opened(self, viewer: Viewer | None) -> None:
        self._picked.clear()
        self._cropped = None
        if viewer is not None:
            viewer.on_pick(self._take)

    def _points(self) -> Any:
        """Points of the first geometry, or vertices of a mesh, shape (n, 3)."""
        if not self.geometries:
            return np.zeros((0, 3))
        shape = drawn(next(iter(self.geometries.values())))
        return shape.vertices if isinstance(shape, TriangleMesh) else shape.points

    def _take(self, pick: Any) -> None:
        """Add or remove the picked point. Called in a thread of the page."""
        if pick.name == MARKS:
            index = list(self._picked)[pick.index]
        elif pick.name == next(iter(self.geometries), None):
            distances = np.linalg.norm(self._points() - pick.point, axis=1)
            index = int(distances.argmin()) if pick.index is None else int(pick.index)
        else:
            return
        if index in self._picked:
            del self._picked[index]
            LOGGER.info("point %d is no longer picked", index)
        else:
            self._picked[index] = self._points()[index].copy()
            LOGGER.info("picked point %d at %s", index, np.array2string(self._picked[index], precision=4))
        self._mark()

    def _mark(self) -> None:
        """Show the picked points in the page."""
        viewer = self.viewer
        if viewer is not None and self._picked:
            viewer.add(MARKS, native.PointCloud(np.array(list(self._picked.values()))), **MARK_STYLE)
        elif viewer is not None and MARKS in viewer.items:
            viewer.remove(MARKS)

    def destroy_window(self) -> None:
        self._cropped = self.get_cropped_geometry() if self.geometries else self._cropped
        super().destroy_window()

    def get_picked_points(self) -> list[int]:
        """Indices of the picked points in the order of the clicks."""
        return list(self._picked)

    def get_cropped_geometry(self) -> Any:
        """The last result of the polygon tool, or the complete geometry. Valid after `destroy_window`, too."""
        if not self.geometries:
            return self._cropped
        items = {} if self.viewer is None else self.viewer.items
        parts = [item.cloud for name, item in items.items() if CROPPED in name and item.visible and item.cloud]
        return PointCloud.from_native(parts[-1]) if parts else next(iter(self.geometries.values()))
