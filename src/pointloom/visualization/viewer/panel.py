"""The panel of all pages: colors, sizes, visibility, view.

Names and labels are sent as plain text, never as HTML or Markdown.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from ..render.coloring import Coloring, label_color
from ..render.colormaps import colormap_table
from ..render.ticks import choose_ticks, with_ends
from . import panel_sections as sections
from .coloring_choice import COLORMAPS, Choices, has_meaning, shown_coloring
from .items import Item, to_bytes
from .keys import KEYS
from .scene import Scene

if TYPE_CHECKING:
    from .link import PageServer, Shown

OWN = "own colors"
NUM_TICKS = 5  # of a color bar, besides its ends
MIN_TICK_SEPARATION = 0.08  # of the bar's length: nearer ticks would overlap the number at an end
MAX_SLIDER_SIZE = 20.0  # [px] largest point size of the slider


class Panel:
    """The panel's controls, shown equal to the scene. `PageActions` handles their changes by pages."""

    def __init__(self, scene: Scene, pages: PageServer):
        self._scene, self._pages = scene, pages
        gui = self._gui = pages.gui
        self._choices, self._is_current = Choices(), False  # choices; whether choices and legend match the items
        self._legend: Shown | None = None
        self._legend_content: Any = None  # content of the legend
        self._colored: dict[str, Item] = {}  # items with a coloring
        with gui.add_folder("Color", order=sections.COLOR_ORDER):
            self.color_property = gui.add_dropdown("by", (OWN,))
            self.colormap = gui.add_dropdown("map", COLORMAPS, visible=False)
            self.low = gui.add_number("low", 0.0, visible=False)
            self.high = gui.add_number("high", 1.0, visible=False)
            self.fit_range = gui.add_button("Fit range", visible=False)
        with gui.add_folder("Scene", order=sections.SCENE_ORDER):
            self.tree = gui.add_tree()
        with gui.add_folder("Points and surfaces", order=sections.POINTS_ORDER):
            self.point_size = gui.add_slider(
                "point size", 0.5, MAX_SLIDER_SIZE, 0.1, min(MAX_SLIDER_SIZE, scene.point_size)
            )
            self.normals = gui.add_checkbox("normals (N)", False)
            self.wireframe = gui.add_checkbox("wireframe (W)", False)
            self.background = gui.add_rgb("background", np.rint(scene.background * 255))
        with gui.add_folder("View", order=sections.VIEW_ORDER):
            self.buttons = {key.action: gui.add_button(f"{key.label} ({key.shown})") for key in KEYS if key.is_button}
            self.load_view = gui.add_upload_button("Load view", accept=".json,application/json")

    def put_item(self, item: Item) -> None:
        self._is_current = False
        self._choices.put(item)
        if has_meaning(item):
            self._colored[item.name] = item
        else:
            self._colored.pop(item.name, None)
        color = None if item.style.color is None else to_bytes([item.style.color])[0].tolist()
        self.tree.put(item.name, item.name, item.visible, color)

    def drop_item(self, name: str) -> None:
        self._is_current = False
        self._choices.drop(name)
        self._colored.pop(name, None)
        self.tree.drop(name)

    def clear(self) -> None:
        """Release the memory of items."""
        self._colored = {}

    def apply_pending(self) -> None:
        """Update the legend if items have changed."""
        if not self._is_current:
            self._update_colors()

    def show_legend(self) -> None:
        self._colored = {item.name: item for item in self._scene.shown.values() if has_meaning(item)}
        self._update_colors()

    @property
    def limits(self) -> tuple[float, float] | None:
        """Range of the colored values. None if no values are colored."""
        coloring = shown_coloring(self._colored.values())
        return None if coloring is None or coloring.limits is None else (self.low.value, self.high.value)

    def _update_colors(self) -> None:
        self._is_current = True
        choice, items = self._scene.coloring, self._colored.values()
        known = (OWN, *self._choices.names())
        if known != tuple(self.color_property.options):
            self.color_property.options = known
        coloring = shown_coloring(items)
        self.color_property.value = choice.by if choice.by in self.color_property.options else OWN
        is_values = coloring is not None and coloring.limits is not None
        for control in (self.colormap, self.low, self.high, self.fit_range):
            control.visible = is_values
        if coloring is not None and coloring.limits is not None:
            self.colormap.value = coloring.colormap or COLORMAPS[0]
            self._show_limits(*coloring.limits)
        self._put_legend(None if coloring is None else legend_of(coloring, items))

    def _put_legend(self, content: tuple[str, Any] | None) -> None:
        """Show a color bar or a legend at the edge of the image. None removes it."""
        if content == self._legend_content:
            return
        self._legend_content = content
        with self._pages.atomic():
            if self._legend is not None:
                self._legend.remove()
                self._legend = None
            if content is not None and content[0] == "bar":
                title, ticks, colormap = content[1]
                colors = to_bytes(colormap_table(colormap))
                self._legend = self._gui.add_colorbar(title, ticks, colors)
            elif content is not None:
                self._legend = self._gui.add_legend(content[1])

    def _show_limits(self, low: float, high: float) -> None:
        """Show the range with enough digits to distinguish its hundredths."""
        digits = 2 - math.floor(math.log10(high - low)) if high > low else 2
        for control, value in ((self.low, low), (self.high, high)):
            control.step, control.precision = 10.0**-digits, max(0, digits)
            control.value = round(value, digits + 1)

    def show_state(self) -> None:
        scene = self._scene
        self.point_size.value = min(MAX_SLIDER_SIZE, scene.point_size)
        self.background.value = tuple(int(value) for value in np.rint(scene.background * 255))
        self.normals.value, self.wireframe.value = scene.normals, scene.wireframe


def legend_of(coloring: Coloring, items: Iterable[Item]) -> tuple[str, Any]:
    """Content of a legend: ("bar", title, ticks and colormap), or ("labels", rows of name, color and count)."""
    if coloring.limits is not None and coloring.colormap is not None:
        title, ticks = bar_ticks(coloring)
        return "bar", (title, ticks, coloring.colormap)
    counts = counts_of(coloring, items)
    return "labels", tuple(
        (name, tuple(to_bytes([label_color(label)])[0].tolist()), f"{counts[label]:,}" if label in counts else "")
        for label, name in coloring.names.items()
    )


def bar_ticks(coloring: Coloring) -> tuple[str, tuple[tuple[float, str], ...]]:
    """Title with unit of a color bar, and ticks (round numbers and both ends) as fractions of its length."""
    assert coloring.limits is not None
    ticks = with_ends(choose_ticks(*coloring.limits, NUM_TICKS), MIN_TICK_SEPARATION)
    span = ticks.high - ticks.low
    fractions = tuple((value - ticks.low) / span for value in ticks.values)
    return ticks.title(coloring.title), tuple(zip(fractions, ticks.texts, strict=True))


def counts_of(coloring: Coloring, items: Any) -> dict[int, int]:
    counts: dict[int, int] = {}
    for item in items:
        if item.coloring is None or item.coloring.kind != "labels" or not item.visible:
            continue
        for value, number in item.label_counts(coloring.title).items():
            counts[value] = counts.get(value, 0) + number
    return counts
