"""The tool that paints labels onto the points of a cloud: `PaintTool`."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....files.points.point_cloud import write_point_cloud
from ...render.view import View
from ..history import Change
from ..painted import begin_painting, show_painting, unsaved_labels
from .kept_files import keep_file, place_of_files
from .labels import Painting, Stroke, brush, meant_points
from .stage import Tool, check_room

BRUSH, POLYGON = "round brush", "polygon"
SUFFIXES = (".las", ".laz", ".ply", ".pcd", ".npz")
_LABELS = ("classification", "label", "labels", "class", "segment", "semantic")


class PaintTool(Tool):
    """Paints classes onto points that are seen, by a round brush or a polygon, and saves them with the cloud."""

    label = "Paint labels"
    key = "G"
    hint = "Click on points: the brush gives them the class. Ctrl+Z takes it back."

    def __init__(self, stage: Any, folder: Path | None = None):
        super().__init__(stage)
        self._folder = Path.cwd() if folder is None else folder
        self._corners: list[NDArray[np.float64]] = []  # [px]
        self._drawn_in: View | None = None

    def start(self) -> None:
        """What may be chosen; the scene shows the labels from now on."""
        names, gui, ask = self.stage.clouds(), self.stage.client.gui, self.stage.ask
        if not names:
            raise ValueError("there is no cloud to paint in the scene")
        self._cloud = gui.add_dropdown("cloud", names, visible=len(names) > 1)
        self._attribute = gui.add_text("attribute", self._usual_attribute(names[0]), hint="what the labels are called")
        self._class = gui.add_dropdown("class", ("0",))
        self._color = gui.add_rgb("colour", (128, 128, 128))
        self._name = gui.add_text("new class", "", hint="its name; its number is the next free one")
        gui.add_button("Add class").on_click(lambda _: ask(self._add_class))
        self._shape = gui.add_dropdown("shape", (BRUSH, POLYGON))
        self._radius = gui.add_slider("radius", 2.0, 200.0, 1.0, 20.0, hint="of the brush [px]")
        self._seen = gui.add_checkbox("seen points only", True, hint="else those behind them, too")
        gui.add_button("Paint the polygon (Enter)").on_click(lambda _: ask(self.finish))
        self._file = gui.add_text("file", "labels.ply", hint=place_of_files(self.stage, self._folder))
        gui.add_button("Save the labels").on_click(lambda _: ask(self._save))
        self._cloud.on_update(lambda _: ask(self._begin))
        self._attribute.on_update(lambda _: ask(self._begin))
        self._shape.on_update(lambda _: ask(self._forget_corners))
        self._class.on_update(lambda _: ask(self._show_class))
        self._color.on_update(lambda _: ask(self._change_color))
        self._begin()

    def stop(self) -> None:
        """Labels stay with the cloud; those that no file holds are told."""
        told = unsaved_labels(self.stage.items())
        if told:
            self.stage.client.notify("pointloom", f"Not saved to a file yet: {told}. They stay until the program ends.")

    def click(self, view: View, x: float, y: float) -> None:
        """A dab of the brush, or one corner more."""
        if self._shape.value == BRUSH:
            self._paint(view, brush(x, y, float(self._radius.value)))
            return
        check_room(self._corners)
        if self._drawn_in is not None and not np.allclose(self._drawn_in.T_world_camera, view.T_world_camera):
            self._corners = []  # another view: what was drawn means something else
        self._drawn_in = view
        self._corners.append(np.array([x, y]))
        self._show_corners()

    def undo(self) -> None:
        """One corner less."""
        if self._corners:
            self._corners.pop()
            self._show_corners()

    def finish(self) -> None:
        """Paint what lies inside the polygon."""
        if self._drawn_in is None or len(self._corners) < 3:
            raise ValueError(f"a polygon has at least three corners, this one has {len(self._corners)}: click on more")
        self._paint(self._drawn_in, np.array(self._corners))
        self._forget_corners()

    def refresh(self) -> None:
        """Offer the clouds that there are."""
        names = tuple(self.stage.clouds())
        if names and names != tuple(self._cloud.options):
            chosen = self._cloud.value
            self._cloud.options = names
            self._cloud.value = chosen if chosen in names else names[0]
            self._cloud.visible = len(names) > 1

    # -- within -------------------------------------------------------------------------------------------------------

    def _usual_attribute(self, name: str) -> str:
        item, cloud = self.stage.cloud(name)
        if item.painting is not None:
            return item.painting.attribute
        return next((known for known in _LABELS if known in cloud.attributes), "label")

    def _begin(self) -> None:
        """Take up the labels that are there, and show them."""
        item, _ = self.stage.cloud(self._cloud.value)
        painting = begin_painting(self.stage.viewer, item.name, self._attribute.value.strip())
        options = tuple(f"{label.number} {label.name}" for label in painting.classes.values())
        if tuple(self._class.options) != options:
            self._class.options = options
            self._class.value = options[min(1, len(options) - 1)]
        self.stage.viewer.color_by(painting.attribute)
        self._show_class()
        self._show_changes(painting)

    def _painting(self) -> Painting:
        item, _ = self.stage.cloud(self._cloud.value)
        if item.painting is None:
            raise ValueError(f"{item.name} is another cloud by now; choose it again")
        return item.painting

    def _paint(self, view: View, polygon: NDArray[np.float64]) -> None:
        stage, name = self.stage, self._cloud.value
        item, painting = stage.item(name), self._painting()
        target = next((found for found in stage.targets([name]) if found.cloud is not None), None)
        if target is None:
            raise ValueError(f"{name} is hidden; nothing is painted that cannot be seen")
        others = [found for found in stage.targets() if found.name != name]
        rows = meant_points(target, others, view, polygon, through=not self._seen.value)
        number = self._number()
        stroke = painting.paint(rows, number)
        if not len(stroke.indices):
            stage.say("Nothing new to paint there." if len(rows) else "No point is seen there.")
            return
        self._apply(item, painting)
        label = f"Paint {len(stroke.indices):,} points {painting.classes[number].name}"
        undo, redo = self._goes(item, painting, stroke, back=True), self._goes(item, painting, stroke, back=False)
        stage.history.add(Change(label, undo, redo, nbytes=stroke.nbytes))
        stage.say(f"{len(stroke.indices):,} points are {painting.classes[number].name} now.")

    def _goes(self, item: Any, painting: Painting, stroke: Stroke, *, back: bool) -> Any:
        def go() -> None:
            if item.painting is not painting or self.stage.item(item.name) is not item:
                raise ValueError(f"{item.name} holds other points or other labels by now")
            (painting.take_back if back else painting.redo)(stroke)
            self._apply(item, painting)

        return go

    def _apply(self, item: Any, painting: Painting) -> None:
        show_painting(self.stage.viewer, item.name)
        self._show_changes(painting)

    def _number(self) -> int:
        return int(self._class.value.split(" ", 1)[0])

    def _show_class(self) -> None:
        label = self._painting().classes.get(self._number())
        if label is not None:
            self._color.value = label.color

    def _change_color(self) -> None:
        painting, number = self._painting(), self._number()
        label = painting.classes.get(number)
        if label is not None and tuple(self._color.value) != label.color:
            red, green, blue = (int(c) for c in self._color.value)
            painting.add_class(number, label.name, (red, green, blue))
            self._apply(self.stage.item(self._cloud.value), painting)

    def _add_class(self) -> None:
        painting = self._painting()
        name = " ".join(self._name.value.split())
        if not name:
            raise ValueError("new class: give it a name first")
        number = painting.free_number()
        label = painting.add_class(number, name, painting.usual_color(number))
        self._name.value = ""
        self._class.options = tuple(f"{known.number} {known.name}" for known in painting.classes.values())
        self._class.value = f"{label.number} {label.name}"
        self._show_class()
        self._show_changes(painting)

    def _show_changes(self, painting: Painting) -> None:
        changes = painting.unsaved
        self.stage.show([("not saved yet", f"{changes} change{'s' * (changes != 1)}")] if changes else [])

    def _show_corners(self) -> None:
        stage = self.stage
        stage.clear()
        if self._drawn_in is not None and self._corners:
            places = np.array([stage.before_all(self._drawn_in, *corner) for corner in self._corners])
            stage.lines(places, closed=len(places) > 2)
            for place in places:
                stage.mark(self._drawn_in, place)
        stage.say(f"{len(self._corners)} corners; Enter paints what lies inside.")

    def _forget_corners(self) -> None:
        self._corners, self._drawn_in = [], None
        self.stage.clear()

    def _save(self) -> None:
        """Write the cloud with its labels, to the program's folder or by the page."""
        item, cloud = self.stage.cloud(self._cloud.value)
        painting = self._painting()
        saved = painting.unsaved
        whole = item.select(np.arange(len(cloud))) if item.has_colors_in_tree else cloud
        write = partial(write_point_cloud, cloud=whole, overwrite=False)
        place = keep_file(self.stage, self._folder, self._file.value, SUFFIXES, write)
        painting.unsaved -= saved
        self._show_changes(painting)
        self.stage.say(f"{len(cloud):,} points with {painting.attribute} are {place}.")
