"""The panel beside the scene: colours, sizes, what is shown, the view; the same for all pages: `Panel`.

Names and labels reach the page as plain text of its controls, never as HTML or Markdown.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..render.canvas import Canvas
from ..render.coloring import Coloring, label_color
from ..render.colormaps import colormap_table
from ..render.legends import cut_text, draw_legend
from ..render.ticks import choose_ticks
from .actions import Actions
from .coloring_choice import COLORMAPS, Choices, shown_coloring
from .items import Item
from .keys import KEYS, add_key, bind_keys
from .tools.toolbox import Toolbox

if TYPE_CHECKING:
    import viser

    from .sessions import Session
    from .viewer import Viewer

OWN = "own colours"
_LEGEND = (300, 54)  # [px]
_MOST_NAME = 40  # characters of a name


class Panel:
    """The controls of a viewer.

    Args:
        viewer: The viewer, whose server is there already.
    """

    def __init__(self, viewer: Viewer):
        self._viewer, self.actions = viewer, Actions(viewer)
        gui = self._gui = viewer.server.viser.gui
        self._boxes: dict[str, Any] = {}
        self._choices, self._is_told = Choices(), False  # whether choices and legend are those of the items
        gui.main_panel.dock_right()  # beside the scene, not over it
        self._top = gui.add_folder(None, order=0)
        self._add_colors(gui)
        self._add_sizes(gui)
        self._add_view(gui)
        self._scene = gui.add_folder("Scene", order=4)
        self._tools = gui.add_folder("Tools", order=5, expand_by_default=False)
        self._commands = bind_keys(viewer.server.viser, self)

    def bind_key(self, key: str, label: str, callback: Callable[[int], None]) -> None:
        """Have a key call a program, and nothing else."""
        for command in [command for command in self._commands if command.hotkey == key]:
            self._commands.remove(command)
            command.remove()
        self._commands.append(add_key(self._viewer.server.viser, key, label, self.actions.calling(callback)))

    # -- pages --------------------------------------------------------------------------------------------------------

    def add_line(self, client: viser.ClientHandle) -> Any:
        """The line of a page that says how many points it draws."""
        with self._top:
            return client.gui.add_markdown("0 points")

    def add_tools(self, session: Session) -> Any:
        """The tools of a page."""
        return Toolbox(session, self._tools)

    # -- what the panel says ------------------------------------------------------------------------------------------

    def put_item(self, item: Item) -> None:
        """A box to tick for a geometry, as it is now; what it can be coloured by."""
        self._is_told = False
        self._choices.put(item)
        box = self._boxes.get(item.name)
        if box is not None:
            box.value = item.visible
            return
        name = item.name
        label = name if len(name) <= _MOST_NAME else f"{name[: _MOST_NAME - 1]}…"
        with self._scene:
            box = self._gui.add_checkbox(label, item.visible)
        box.on_update(lambda event, name=name: self.actions.set_visible(event.client_id, name, event.target.value))
        self._boxes[name] = box

    def drop_item(self, name: str) -> None:
        """A geometry has gone."""
        self._is_told = False
        self._choices.drop(name)
        if name in self._boxes:
            self._boxes.pop(name).remove()

    def catch_up(self) -> None:
        """Tell what the colours mean, where items have come, changed or gone since."""
        if not self._is_told:
            self.show_legend()

    def show_legend(self) -> None:
        """What the colours mean."""
        self._is_told = True
        choice, items = self._viewer.coloring, self._viewer.items.values()
        known = (OWN, *self._choices.names())
        if known != tuple(self._by.options):
            self._by.options = known
        coloring = shown_coloring(items)
        self._by.value = choice.by if choice.by in self._by.options else OWN
        self._legend.visible = coloring is not None
        is_values = coloring is not None and coloring.limits is not None
        for control in (self._map, self._low, self._high, self._fit):
            control.visible = is_values
        if coloring is None:
            return
        if coloring.limits is not None:
            self._map.value = coloring.colormap or COLORMAPS[0]
            self._show_limits(*coloring.limits)
        self._legend.image = draw_legend_image(coloring, counts_of(coloring, items))

    def _show_limits(self, low: float, high: float) -> None:
        """The range to as many digits as it takes to tell its hundredths apart."""
        digits = 2 - math.floor(math.log10(high - low)) if high > low else 2
        for control, value in ((self._low, low), (self._high, high)):
            control.step, control.precision = 10.0**-digits, max(0, digits)
            control.value = round(value, digits + 1)

    def show_state(self) -> None:
        """The sizes and switches that keys have changed."""
        viewer = self._viewer
        self._size.value = min(20.0, viewer.point_size)
        self._back.value = tuple(int(value) for value in np.rint(viewer.background * 255))
        self._normals.value, self._wireframe.value = viewer.normals, viewer.wireframe

    # -- controls -----------------------------------------------------------------------------------------------------

    def _add_colors(self, gui: Any) -> None:
        with gui.add_folder("Colour", order=1):
            self._by = gui.add_dropdown("by", (OWN,))
            self._map = gui.add_dropdown("map", COLORMAPS, visible=False)
            self._low = gui.add_number("low", 0.0, visible=False)
            self._high = gui.add_number("high", 1.0, visible=False)
            self._fit = gui.add_button("Fit range", visible=False)
            self._legend = gui.add_image(np.full((2, 2, 3), 255, np.uint8), format="png", visible=False)
        self._by.on_update(lambda event: self._color(event.client_id, fit=True))
        self._map.on_update(lambda event: self._color(event.client_id))
        self._low.on_update(lambda event: self._color(event.client_id))
        self._high.on_update(lambda event: self._color(event.client_id))
        self._fit.on_click(lambda event: self._color(event.client_id, fit=True))

    def _color(self, client: int | None, *, fit: bool = False) -> None:
        by = None if self._by.value == OWN else self._by.value
        limits = None if fit or by is None else (self._low.value, self._high.value)
        coloring = shown_coloring(self._viewer.items.values())
        if limits is not None and (coloring is None or coloring.limits is None):
            limits = None
        colormap = self._map.value if self._map.visible or self._viewer.coloring.colormap is not None else None
        self.actions.color(client, by, colormap, limits)

    def _add_sizes(self, gui: Any) -> None:
        viewer = self._viewer
        with gui.add_folder("Points and surfaces", order=2):
            self._size = gui.add_slider("point size", 0.5, 20.0, 0.1, min(20.0, viewer.point_size))
            smaller_larger = gui.add_button_group("", ("smaller (-)", "larger (+)"))
            self._normals = gui.add_checkbox("normals (N)", False)
            self._wireframe = gui.add_checkbox("wireframe (W)", False)
            rgb = tuple(int(value) for value in np.rint(viewer.background * 255))
            self._back = gui.add_rgb("background", rgb)
        self._size.on_update(lambda event: self.actions.set_point_size(event.client_id, event.target.value))
        smaller_larger.on_click(lambda event: self._step_size(event.client_id, event.target.value))
        self._normals.on_update(lambda event: self.actions.set_normals(event.client_id, event.target.value))
        self._wireframe.on_update(lambda event: self.actions.set_wireframe(event.client_id, event.target.value))
        self._back.on_update(lambda event: self.actions.set_background(event.client_id, event.target.value))

    def _step_size(self, client: int | None, which: str) -> None:
        (self.actions.grow_points if which.startswith("larger") else self.actions.shrink_points)(client)

    def _add_view(self, gui: Any) -> None:
        with gui.add_folder("View", order=3):
            for key in KEYS:
                if key.is_button:
                    button = gui.add_button(f"{key.label} ({key.shown})")
                    action = getattr(self.actions, key.action)
                    button.on_click(lambda event, act=action: act(event.client_id))
            load = gui.add_upload_button("Load view", mime_type="application/json")
        load.on_upload(lambda event: self.actions.load_view(event.client_id, event.target.value.content))


def counts_of(coloring: Coloring, items: Any) -> dict[int, int]:
    """How many points of the clouds that are seen have each label."""
    counts: dict[int, int] = {}
    for item in items:
        if item.coloring is None or item.coloring.kind != "labels" or not item.visible:
            continue
        if coloring.title not in item.cloud.attributes:
            continue
        values, numbers = np.unique(np.asarray(item.cloud[coloring.title]), return_counts=True)
        for value, number in zip(values.tolist(), numbers.tolist(), strict=True):
            counts[int(value)] = counts.get(int(value), 0) + number
    return counts


def draw_legend_image(coloring: Coloring, counts: dict[int, int]) -> NDArray[np.uint8]:
    """A bar with numbers, or labels with how many points have them."""
    if coloring.limits is not None and coloring.colormap is not None:
        return _draw_bar(coloring.colormap, coloring.limits, coloring.title)
    entries = [
        (f"{name} ({counts[label]:,})" if label in counts else name, label_color(label))
        for label, name in coloring.names.items()
    ]
    canvas = Canvas.blank(_LEGEND[0], min(600, 30 + 18 * len(entries)))
    draw_legend(canvas, entries)
    return canvas.to_numpy()


def _draw_bar(colormap: str, limits: tuple[float, float], title: str) -> NDArray[np.uint8]:
    """A level bar with ticks below it, as wide as the panel."""
    canvas, (width, _), edge = Canvas.blank(*_LEGEND), _LEGEND, 22
    ticks = choose_ticks(*limits, 5)
    across = width - 2 * edge
    places = np.arange(across) * 255 // (across - 1)
    colors = np.rint(colormap_table(colormap)[places] * 255).astype(np.uint8)
    canvas.text(cut_text(ticks.title(title), 13, across), edge, 9, size=13)
    canvas.image(np.repeat(colors[None], 14, axis=0), edge, 20)
    for value, text in zip(ticks.values, ticks.texts, strict=True):
        x = round(edge + (across - 1) * (value - ticks.low) / (ticks.high - ticks.low))
        canvas.line(x, 34, x, 38)
        canvas.text(text, x, 46, size=12, anchor="center")
    return canvas.to_numpy()
