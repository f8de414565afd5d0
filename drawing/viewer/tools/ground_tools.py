"""The tools that measure over the ground: the area of a polygon, a volume above a base, a height profile."""

from __future__ import annotations

from typing import Any

import numpy as np

from ....core.units import LengthUnit
from ....files.pictures.image_files import encode_png
from ....meshing.mesh.mesh import TriangleMesh
from ...render.view import View
from .areas import area_rows, check_length, measure_polygon, quantity_text
from .heaps import HeapVolume, heap_rows, measure_heap, usual_cell
from .path_tool import PathTool
from .picking import Pick
from .profiles import Profile, profile_along, profile_csv, profile_picture, profile_rows
from .seen_points import SeenPoints, gather_points

PANEL, FILE = (340, 260), (1200, 560)  # [px] of a profile's picture in the panel, and of the one that is kept
PLANE, LEVEL = "plane of the corners", "height"
_WIDTH_SHARE = 0.01  # of a line's length: the width of a strip that nobody has said


class AreaTool(PathTool):
    """Measures the area of a polygon of clicks."""

    label = "Area"
    key = "A"
    hint = "Click the corners of a polygon on points or surfaces. Backspace takes one back, Enter begins anew."
    closed = True

    def tell(self, unit: LengthUnit | None) -> None:
        """The area, from the third corner on."""
        if len(self._picks) < 3:
            self.stage.show([("corners", f"{len(self._picks)}")] if self._picks else [])
            return
        rows = area_rows(measure_polygon(self.places), unit)
        self.stage.show(rows)
        self.stage.label(self.places.mean(axis=0), rows[0][1])


class VolumeTool(PathTool):
    """Measures what lies above and below a base within a polygon of clicks; of a closed mesh, its volume."""

    label = "Volume"
    key = "B"
    hint = "Click around a heap or a pit, then Enter. A click on a closed mesh gives its volume."
    closed = True

    def start(self) -> None:
        """What may be chosen."""
        gui, ask = self.stage.client.gui, self.stage.ask
        self._cell = gui.add_number("cell, 0: chosen", 0.0, min=0.0, hint="their side; chosen ones hold six points")
        self._base = gui.add_dropdown("base", (PLANE, LEVEL))
        self._level = gui.add_number("height", 0.0, visible=False)
        self._fill = gui.add_checkbox("fill empty cells", True)
        self._base.on_update(lambda _: ask(self._change_base))
        gui.add_button("Measure (Enter)").on_click(lambda _: ask(self.finish))
        gui.add_button("Begin anew").on_click(lambda _: ask(super(VolumeTool, self).finish))

    def click(self, view: View, x: float, y: float) -> None:
        """A corner, or a closed mesh."""
        found = self.stage.pick(view, x, y)
        if found is not None and found.index is None and not self._picks:
            self._tell_mesh(found)
        else:
            super().click(view, x, y)

    def finish(self) -> None:
        """Measure."""
        stage, places = self.stage, self.places
        if len(places) < 3:
            raise ValueError(f"a polygon has at least three corners, this one has {len(places)}: click on more")
        unit = stage.unit(self.names)
        check_length(unit)
        seen = gather_points(stage.targets(self.names), places[:, :2].min(axis=0), places[:, :2].max(axis=0))
        cell = float(self._cell.value)
        box = float(np.ptp(places[:, 0]) * np.ptp(places[:, 1]))
        self._show(self._picks)
        found = self._measure(seen, cell if cell > 0 else usual_cell(len(seen.points), box))
        rows = heap_rows(found, unit, self._measure(seen, 2 * found.cell))
        stage.show(rows)
        stage.label(places.mean(axis=0), f"{quantity_text(found.net, unit, 3)}")
        stage.say(
            "Each cell has one height, the mean of its points: what lies under overhangs, between cells and under the "
            "points is not known, and plants and machines on a heap count as heap."
        )

    def _measure(self, seen: SeenPoints, cell: float) -> HeapVolume:
        level = None if self._base.value == PLANE else float(self._level.value)
        return measure_heap(seen.points, self.places, cell=cell, base=level, fill_empty=bool(self._fill.value))

    def _change_base(self) -> None:
        self._level.visible = self._base.value == LEVEL
        if self._level.visible and self._picks:
            self._level.value = round(float(self.places[:, 2].min()), 3)

    def _tell_mesh(self, found: Pick) -> None:
        """The volume that a mesh encloses, or why it has none."""
        stage, mesh = self.stage, self.stage.item(found.name).geometry
        unit = stage.unit([found.name])
        check_length(unit)
        stage.clear()
        if not isinstance(mesh, TriangleMesh):
            raise ValueError(f"{found.name} is no triangle mesh, so it has no volume")
        stage.show([("in", found.name), ("area", quantity_text(mesh.get_surface_area(), unit, 2))])
        if not mesh.is_watertight():
            stage.say(
                f"{found.name} is not closed, or crosses itself, so it encloses no volume; mesh.fill_holes() closes "
                "holes. Or click around a heap of points."
            )
            return
        rows = [("in", found.name), ("volume", quantity_text(mesh.get_volume(), unit, 3))]
        stage.show([*rows, ("area", quantity_text(mesh.get_surface_area(), unit, 2))])
        stage.say(self.hint)


class ProfileTool(PathTool):
    """Shows the heights of points along a line of clicks, as a plot and as a table to keep."""

    label = "Height profile"
    key = "E"
    hint = "Click along a line over the points, then Enter."

    def start(self) -> None:
        """What may be chosen, and what can be kept."""
        gui, ask = self.stage.client.gui, self.stage.ask
        self._width = gui.add_number(
            "width, 0: chosen", 0.0, min=0.0, hint="of the strip; chosen: a hundredth of the line"
        )
        gui.add_button("Draw (Enter)").on_click(lambda _: ask(self.finish))
        gui.add_button("Begin anew").on_click(lambda _: ask(super(ProfileTool, self).finish))
        self._results = gui.add_folder(None)
        self._picture: Any = None
        self._save = gui.add_button_group("save", ("table (CSV)", "picture (PNG)"), visible=False)
        self._save.on_click(lambda event: ask(lambda: self._send(event.value)))
        self._found: tuple[Profile, SeenPoints, LengthUnit | None] | None = None

    def finish(self) -> None:
        """Look at the points along the line."""
        stage, places = self.stage, self.places
        if len(places) < 2:
            raise ValueError(f"a line has at least two corners, this one has {len(places)}: click on more")
        unit = stage.unit(self.names)
        check_length(unit)
        length = float(np.linalg.norm(np.diff(places[:, :2], axis=0), axis=1).sum())
        width = float(self._width.value)
        width = width if width > 0 else _WIDTH_SHARE * length
        low, high = places[:, :2].min(axis=0) - width, places[:, :2].max(axis=0) + width
        seen = gather_points(stage.targets(self.names), low, high)
        found = profile_along(seen.points, places, width=width)
        self._found = found, seen, unit
        self._show(self._picks)
        self._draw(self._image(PANEL))
        stage.show(profile_rows(found, unit))
        stage.say(
            "All points of the strip count, whatever they lie on: the median is the ground only where no plants or "
            "buildings stand over it."
        )

    def _image(self, size: tuple[int, int] = FILE) -> Any:
        assert self._found is not None
        found, seen, unit = self._found
        colors = [self.stage.item(name).colors_of(rows) for name, rows in seen.sources]
        every = np.concatenate([np.zeros((0, 3), np.uint8), *colors])
        return profile_picture(found, unit, colors=every[found.rows], size=size)

    def _draw(self, image: Any) -> None:
        if self._picture is not None:
            self._picture.remove()
        with self._results:
            self._picture = self.stage.client.gui.add_image(encode_png(np.asarray(image)))
        self._save.visible = True

    def _send(self, kind: str) -> None:
        """Have the page save what was found."""
        if self._found is None:
            raise ValueError("there is no profile yet: Enter draws one")
        found, seen, _ = self._found
        if kind.startswith("table"):
            self.stage.client.download("profile.csv", profile_csv(found, seen.points, seen.indices), "text/csv")
        else:
            self.stage.client.download("profile.png", encode_png(np.asarray(self._image())), "image/png")
