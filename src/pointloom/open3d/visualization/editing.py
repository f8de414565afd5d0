"""Windows in which a click picks a point: `VisualizerWithEditing` and `VisualizerWithVertexSelection`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ...core.attribute_hints import KnownNames
from ...core.checks import check_callback
from ...core.verbosity import LOGGER
from ...meshing.mesh.mesh import TriangleMesh
from ...pcd import cloud as native
from ...visualization.viewer.viewer import Viewer
from ..geometry import PointCloud
from ..indices import indices_of
from .shown import drawn
from .visualizer import Visualizer

MARKS = "picked points"
MARK_STYLE = {"color": (0.9, 0.24, 0.08), "point_size": 14.0}
CROPPED = "(cropped"  # in the names that the polygon tool gives to its results


@dataclass(eq=False)
class PickedPoint(KnownNames):
    """A point picked in a `VisualizerWithVertexSelection`: its index and its coordinates (3,)."""

    index: int = 0
    coord: Any = field(default_factory=lambda: np.zeros(3))


class PickingWindow(Visualizer):
    """A window that picks points of its first geometry, vertices of a mesh.

    A click adds a point, a click on a picked point removes it. Without a page nothing is picked.
    """

    def __init__(self):
        super().__init__()
        self._picked: dict[int, Any] = {}  # coordinates by index, in the order of the clicks

    def on_opened(self, viewer: Viewer | None) -> None:
        self._picked.clear()
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
        self._toggle(index)

    def _toggle(self, index: int) -> None:
        if index in self._picked:
            del self._picked[index]
            LOGGER.info("point %d is no longer picked", index)
        else:
            self._picked[index] = self._points()[index].copy()
            LOGGER.info("picked point %d at %s", index, np.array2string(self._picked[index], precision=4))
        self.show_marks()

    def show_marks(self) -> None:
        """Show the picked points in the page."""
        viewer = self.viewer
        if viewer is None:
            return
        if self._picked:
            viewer.add(MARKS, native.PointCloud(np.array(list(self._picked.values()))), **MARK_STYLE)
        elif MARKS in viewer.items:
            viewer.remove(MARKS)


class VisualizerWithEditing(PickingWindow):
    """A window that picks points. The page's polygon tool crops. The arguments have no effect."""

    def __init__(self, voxel_size: float = -1.0, use_dialog: bool = True, directory: str = ""):
        super().__init__()
        self._cropped: Any = None

    def on_opened(self, viewer: Viewer | None) -> None:
        super().on_opened(viewer)
        self._cropped = None

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


class VisualizerWithVertexSelection(PickingWindow):
    """A window that selects points or vertices."""

    def __init__(self):
        super().__init__()
        self._changed: Callable[[], Any] | None = None
        self._is_changed = False

    def get_picked_points(self) -> list[PickedPoint]:
        """Selected points in the order of the clicks."""
        return [PickedPoint(index, coord) for index, coord in self._picked.items()]

    def clear_picked_points(self) -> None:
        self.remove_picked_points(list(self._picked))

    def add_picked_points(self, indices: Iterable[int]) -> None:
        points = self._points()
        rows = indices_of("indices", indices, len(points), "the geometry").tolist()
        self._picked |= {row: points[row].copy() for row in rows if row not in self._picked}
        self.show_marks()

    def remove_picked_points(self, indices: Iterable[int]) -> None:
        for index in indices:
            self._picked.pop(int(index), None)
        self.show_marks()

    def register_selection_changed_callback(self, f: Callable[[], Any] | None) -> None:
        """Call a function without arguments after each change, in `run` or `poll_events`."""
        self._changed = check_callback("f", f)

    def show_marks(self) -> None:
        self._is_changed = True
        super().show_marks()

    def call_keys(self) -> None:
        super().call_keys()
        if self._is_changed:
            self._is_changed = False
            if self._changed is not None:
                self._changed()
