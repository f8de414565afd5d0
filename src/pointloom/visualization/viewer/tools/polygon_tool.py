"""Tool that crops a cloud with a polygon drawn on the screen."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ....io.points.point_cloud import write_point_cloud
from ....kernels.memory import download
from ....pcd.cloud import PointCloud
from ...render.view import View
from .picking import project, ray_through
from .polygon_crop import (
    AXES,
    indices_in_volume,
    looks_along_axis,
    nearest_axis,
    polygon_to_volume,
    seen_inside,
    view_along,
)
from .stage import Tool, check_room, style_of

if TYPE_CHECKING:
    from ..link import CameraState

STRAIGHT, FREE = "along an axis", "free view"
FILES = {STRAIGHT: "cropped.json", FREE: "cropped.ply"}


class PolygonTool(Tool):
    """Draws a polygon, downloads it as Open3D's cropped.json and shows only the points inside."""

    label = "Crop by polygon"
    key = "K"
    hint = "Click the corners of a polygon; Enter crops, Backspace takes a corner back, Escape ends."

    def __init__(self, stage: Any):
        super().__init__(stage)
        self._corners: list[NDArray[np.float64]] = []  # along an axis: world positions. In a free view: [px]
        self._drawn_in: View | None = None
        self._before: CameraState | None = None
        self._undo: tuple[str, str] | None = None

    def start(self) -> None:
        """Set the view along the nearest axis and add the controls."""
        names, gui, run = self.stage.clouds(), self.stage.client.gui, self.stage.run
        if not names:
            raise ValueError("there is no cloud to crop in the scene")
        self._cloud = gui.add_dropdown("cloud", names, visible=len(names) > 1)
        self._mode = gui.add_dropdown("view", (STRAIGHT, FREE))
        buttons = (("Look along x", "X"), ("Look along y", "Y"), ("Look along z", "Z"))
        for label, axis in buttons:
            gui.add_button(label).on_click(lambda _, axis=axis: run(lambda: self._align(axis)))
        gui.add_button("Crop (Enter)").on_click(lambda _: run(self.finish))
        self._undo_button = gui.add_button("Undo crop", disabled=True)
        self._undo_button.on_click(lambda _: run(self.undo_crop))
        self._mode.on_update(lambda _: run(self._change_mode))
        self._before = self.stage.camera()
        self._align()

    def stop(self) -> None:
        self._look_back()

    def click(self, view: View, x: float, y: float) -> None:
        check_room(self._corners)
        if self._mode.value == FREE:
            if self._drawn_in is not None and not np.allclose(
                self._drawn_in.T_world_camera, view.T_world_camera, rtol=0, atol=1e-9 + 1e-6 * self._size()
            ):
                self._corners = []
            self._corners.append(np.array([x, y]))
        elif not looks_along_axis(view):
            self._align()
            self.stage.set_status("The view was rotated away from the axis and has been reset. Continue clicking.")
            return
        else:
            if self._drawn_in is not None and nearest_axis(self._drawn_in) != nearest_axis(view):
                self._corners = []
            self._corners.append(self._on_plane(view, x, y))
        self._drawn_in = view
        self._show(view)

    def undo(self) -> None:
        if self._corners:
            self._corners.pop()
            self._show(self.stage.view())

    def finish(self) -> None:
        """Crop: show the points inside, hide the complete cloud, download the file."""
        stage = self.stage
        if len(self._corners) < 3:
            raise ValueError(f"polygon: expected at least three corners, got {len(self._corners)}; click on more")
        item, cloud = stage.cloud(self._cloud.value)
        view = self._drawn_in
        assert view is not None
        pose, polygon = stage.pose_of(item), self._on_screen(view)
        volume, name = None, FILES[self._mode.value]
        if self._mode.value == FREE:
            inside = seen_inside(cloud, view, polygon, pose=pose)
        else:
            volume = polygon_to_volume(view, polygon, cloud, pose=pose)
            inside = indices_in_volume(cloud, volume, pose=pose)
        seen = self._seen_of(item.name, inside)
        if not len(seen):
            raise ValueError("the polygon contains no points; Backspace takes corners back")
        cropped = item.select(seen)
        message = f"{len(seen):,} of {len(cloud):,} points, downloaded as {name}."
        if volume is None:
            stage.download(name, lambda path: write_point_cloud(path, cropped))
        else:
            stage.download(name, volume.to_json)
            message = f"{len(seen):,} of {len(cloud):,} points; the polygon is downloaded as {name}."
            message += _difference(cloud, view, polygon, inside, pose)
        if len(seen) < len(inside):
            message += f" {len(inside) - len(seen):,} more inside are hidden by clip planes, and left out."
        self._swap(item, cropped)
        self._corners, self._drawn_in = [], None
        stage.clear()
        stage.set_status(message)

    def refresh(self) -> None:
        if tuple(self.stage.clouds()) != tuple(self._cloud.options):
            self._list_clouds(self._cloud.value)

    def undo_crop(self) -> None:
        if self._undo is None:
            return
        (complete, part), self._undo, self._undo_button.disabled = self._undo, None, True
        edits, scene = self.stage.edits, self.stage.scene
        with scene.lock:
            if part not in scene.shown and complete not in scene.shown:
                raise ValueError(f"{complete} is no longer in the scene")
            if part in scene.shown:
                edits.remove(part)
            if complete in scene.shown:
                edits.set_visible(complete, True)
        self._list_clouds(complete)
        self.stage.set_status("All points are shown again.")

    def _seen_of(self, name: str, rows: NDArray[np.int32]) -> NDArray[np.int32]:
        """Points of a selection that clip planes do not hide."""
        hidden = next(target.hidden for target in self.stage.targets([name]) if target.cloud is not None)
        return rows if hidden is None else rows[download(hidden)[rows] == 0]  # sync

    def _swap(self, item: Any, cropped: PointCloud) -> None:
        edits, scene = self.stage.edits, self.stage.scene
        with scene.lock:
            if item.name not in scene.shown:
                raise ValueError(f"{item.name} is no longer in the scene")
            name, number = f"{item.name} (cropped)", 2
            while name in scene.shown:
                name, number = f"{item.name} (cropped {number})", number + 1
            edits.add(name, cropped, **style_of(item))
            if item.pose is not None:
                edits.set_pose(name, item.pose)
            edits.set_visible(item.name, False)
        self._undo, self._undo_button.disabled = (item.name, name), False
        self._list_clouds(name)

    def _list_clouds(self, chosen: str) -> None:
        names = self.stage.clouds()
        if names:
            self._cloud.options = tuple(names)
            self._cloud.value = chosen if chosen in names else names[0]
            self._cloud.visible = len(names) > 1

    def _align(self, axis: str | None = None) -> None:
        """Set the view along an axis, by default the nearest."""
        if self._mode.value == FREE:
            self._mode.value = STRAIGHT
        low, high = self.stage.item(self._cloud.value).world_bounds() or self.stage.scene.bounds
        self.stage.look_from(view_along(self.stage.view(), low, high, axis))
        self._corners, self._drawn_in = [], None
        self.stage.clear()
        self.stage.set_status(self.hint)

    def _look_back(self) -> None:
        if self._before is not None:
            self.stage.look_back(self._before)

    def _change_mode(self) -> None:
        if self._mode.value == STRAIGHT:
            self._align()
            return
        self._corners, self._drawn_in = [], None
        self.stage.clear()
        self._look_back()
        self.stage.set_status(
            f"{self.hint} The visible points inside are kept as a cloud; cropped.json cannot describe this crop."
        )

    def _size(self) -> float:
        low, high = self.stage.scene.bounds
        return float(np.linalg.norm(high - low))

    def _on_plane(self, view: View, x: float, y: float) -> NDArray[np.float64]:
        """Intersection of a click's ray with the plane through the scene's center across the axis."""
        axis = AXES.index(nearest_axis(view)[0])
        level = float((self.stage.scene.bounds[0] + self.stage.scene.bounds[1])[axis]) / 2
        eye, ray = ray_through(view, x, y)
        return eye + (level - eye[axis]) / ray[axis] * ray

    def _on_screen(self, view: View) -> NDArray[np.float64]:
        if self._mode.value == FREE:
            return np.array(self._corners).reshape(-1, 2)
        return np.array([project(view, corner)[:2] for corner in self._corners]).reshape(-1, 2)

    def _show(self, view: View) -> None:
        stage = self.stage
        stage.clear()
        drawn = self._drawn_in if self._mode.value == FREE and self._drawn_in is not None else view
        corners = np.array([stage.before_all(drawn, *corner) for corner in self._on_screen(drawn)]).reshape(-1, 3)
        stage.lines(corners, closed=len(corners) > 2)
        for corner in corners:
            stage.mark(drawn, corner)
        stage.set_status(f"{len(corners)} corners. {self.hint}")


def _difference(cloud: PointCloud, view: View, polygon: Any, inside: Any, pose: Any) -> str:
    """Text on the effect of perspective; usually empty."""
    other = len(np.setxor1d(seen_inside(cloud, view, polygon, pose=pose), inside))
    return (
        f" {other:,} points at its edge are on the other side of the drawn line, due to perspective." if other else ""
    )
