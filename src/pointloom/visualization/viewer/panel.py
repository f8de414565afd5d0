"""The panel of all pages: colors, sizes, visibility, view.

Names and labels are sent as plain text, never as HTML or Markdown.
"""

from __future__ import annotations

import functools
import logging
import math
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...core.errors import PointloomError
from ...io.images.image_files import encode_png
from ..render.coloring import Coloring, label_color
from ..render.colormaps import colormap_table
from ..render.open3d_views import read_view, write_view
from ..render.ticks import choose_ticks, with_ends
from .coloring_choice import COLORMAPS, Choices, choices_of, has_meaning, shown_coloring
from .items import Item, to_bytes
from .keys import KEYS, STEP, add_key, bind_keys
from .sessions import Session
from .timed_calls import requested_by_page
from .tools.toolbox import Toolbox

if TYPE_CHECKING:
    from .link import Command, Gui, PageClient, Shown
    from .viewer import Viewer


OWN = "own colors"
TICKS = 5  # of a color bar, besides its ends
APART = 0.08  # of the bar's length: nearer ticks would overlap the number at an end

# Order of the sections of the panel, from the top.
LINE, TOOL, TOOLS, COLOR, SCENE, POINTS, VIEW = 0, 0.5, 1, 2, 3, 4, 5


class Panel:
    def __init__(self, viewer: Viewer):
        self._viewer, self.actions = viewer, Actions(viewer)
        gui = self._gui = viewer.server.pages.gui
        self._choices, self._is_current = Choices(), False  # choices; whether choices and legend match the items
        self._legend: Shown | None = None
        self._legend_content: Any = None  # content of the legend
        self._colored: dict[str, Item] = {}  # items with a coloring
        self._add_colors(gui)
        with gui.add_folder("Scene", order=SCENE):
            self._tree = gui.add_tree(lambda client, names, shown: self.actions.set_visible(client, names, shown))
        self._add_sizes(gui)
        self._add_view(gui)
        self._commands = bind_keys(gui, self)

    def bind_key(self, key: str, label: str, callback: Callable[[int], None]) -> Command:
        """Bind a key to a callback of the program only."""
        for command in [command for command in self._commands if command.hotkey == key]:
            self._commands.remove(command)
            command.remove()
        for session in self._viewer.sessions.values():
            session.give_up_key(key)
        self._commands.append(add_key(self._gui, key, label, self.actions.calling(callback)))
        return self._commands[-1]

    def add_line(self, client: PageClient) -> Any:
        """Add the line with the drawn number of points and triangles to a page."""
        return client.gui.add_words("", order=LINE, visible=False)

    def add_tools(self, session: Session) -> Any:
        return Toolbox(session, session.client.gui.add_folder("Tools", order=TOOLS))

    def put_item(self, item: Item) -> None:
        self._is_current = False
        self._choices.put(item)
        if has_meaning(item):
            self._colored[item.name] = item
        else:
            self._colored.pop(item.name, None)
        color = None if item.style.color is None else to_bytes([item.style.color])[0].tolist()
        self._tree.put(item.name, item.name, item.visible, color)

    def drop_item(self, name: str) -> None:
        self._is_current = False
        self._choices.drop(name)
        self._colored.pop(name, None)
        self._tree.drop(name)

    def catch_up(self) -> None:
        """Update the legend if items have changed."""
        if not self._is_current:
            self._update_colors()

    def show_legend(self) -> None:
        self._colored = {item.name: item for item in self._viewer.shown.values() if has_meaning(item)}
        self._update_colors()

    def _update_colors(self) -> None:
        self._is_current = True
        choice, items = self._viewer.coloring, self._colored.values()
        known = (OWN, *self._choices.names())
        if known != tuple(self._by.options):
            self._by.options = known
        coloring = shown_coloring(items)
        self._by.value = choice.by if choice.by in self._by.options else OWN
        is_values = coloring is not None and coloring.limits is not None
        for control in (self._map, self._low, self._high, self._fit):
            control.visible = is_values
        if coloring is not None and coloring.limits is not None:
            self._map.value = coloring.colormap or COLORMAPS[0]
            self._show_limits(*coloring.limits)
        self._put_legend(None if coloring is None else legend_of(coloring, items))

    def _put_legend(self, content: tuple[str, Any] | None) -> None:
        """Show a color bar or a legend at the edge of the image. None removes it."""
        if content == self._legend_content:
            return
        self._legend_content = content
        with self._viewer.server.pages.atomic():
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
        for control, value in ((self._low, low), (self._high, high)):
            control.step, control.precision = 10.0**-digits, max(0, digits)
            control.value = round(value, digits + 1)

    def show_state(self) -> None:
        viewer = self._viewer
        self._size.value = min(20.0, viewer.point_size)
        self._back.value = tuple(int(value) for value in np.rint(viewer.background * 255))
        self._normals.value, self._wireframe.value = viewer.normals, viewer.wireframe

    def _add_colors(self, gui: Gui) -> None:
        with gui.add_folder("Color", order=COLOR):
            self._by = gui.add_dropdown("by", (OWN,))
            self._map = gui.add_dropdown("map", COLORMAPS, visible=False)
            self._low = gui.add_number("low", 0.0, visible=False)
            self._high = gui.add_number("high", 1.0, visible=False)
            self._fit = gui.add_button("Fit range", visible=False)
        self._by.on_update(lambda event: self._color(event.client_id, fit=True))
        self._map.on_update(lambda event: self._color(event.client_id))
        self._low.on_update(lambda event: self._color(event.client_id))
        self._high.on_update(lambda event: self._color(event.client_id))
        self._fit.on_click(lambda event: self._color(event.client_id, fit=True))

    def _color(self, client: int | None, *, fit: bool = False) -> None:
        by = None if self._by.value == OWN else self._by.value
        limits = None if fit or by is None else (self._low.value, self._high.value)
        coloring = shown_coloring(self._colored.values())
        if limits is not None and (coloring is None or coloring.limits is None):
            limits = None
        colormap = self._map.value if self._map.visible or self._viewer.coloring.colormap is not None else None
        self.actions.color(client, by, colormap, limits)

    def _add_sizes(self, gui: Gui) -> None:
        viewer = self._viewer
        with gui.add_folder("Points and surfaces", order=POINTS):
            self._size = gui.add_slider("point size", 0.5, 20.0, 0.1, min(20.0, viewer.point_size))
            self._normals = gui.add_checkbox("normals (N)", False)
            self._wireframe = gui.add_checkbox("wireframe (W)", False)
            self._back = gui.add_rgb("background", np.rint(viewer.background * 255))
        self._size.on_update(lambda event: self.actions.set_point_size(event.client_id, event.value))
        self._normals.on_update(lambda event: self.actions.set_normals(event.client_id, event.value))
        self._wireframe.on_update(lambda event: self.actions.set_wireframe(event.client_id, event.value))
        self._back.on_update(lambda event: self.actions.set_background(event.client_id, event.value))

    def _add_view(self, gui: Gui) -> None:
        with gui.add_folder("View", order=VIEW):
            for key in KEYS:
                if key.is_button:
                    button = gui.add_button(f"{key.label} ({key.shown})")
                    action = getattr(self.actions, key.action)
                    button.on_click(lambda event, act=action: act(event.client_id))
            load = gui.add_upload_button("Load view", accept=".json,application/json")
        load.on_upload(lambda event: self.actions.load_view(event.client_id, event.value.content))


def legend_of(coloring: Coloring, items: Any) -> tuple[str, Any]:
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
    ticks = with_ends(choose_ticks(*coloring.limits, TICKS), APART)
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


log = logging.getLogger("pointloom.viewer")


def show_errors_in_page(action: Callable[..., None]) -> Callable[..., None]:
    """Decorator: show errors in the page that caused them."""

    @functools.wraps(action)
    def run(self: Any, client: int | None, *arguments: Any) -> None:
        if client is None or self.viewer.closed:  # the program itself has set the value
            return
        try:
            with requested_by_page():
                action(self, client, *arguments)
        except (PointloomError, ValueError, TypeError, OSError, MemoryError) as error:
            self.notify(client, str(error), error=True)
        except Exception:
            log.debug("a request of page %s failed", client, exc_info=True)

    return run


class Actions:
    def __init__(self, viewer: Viewer):
        self.viewer = viewer

    def notify(self, client: int, text: str, *, error: bool = False) -> None:
        session = self.viewer.sessions.get(client)
        if session is not None:
            session.client.notify("pointloom", text, error=error)

    def calling(self, callback: Callable[[int], None]) -> Callable[[int | None], None]:
        @show_errors_in_page
        def call(_: Actions, client: int) -> None:
            callback(client)

        return functools.partial(call, self)

    @show_errors_in_page
    def reset_view(self, client: int) -> None:
        with self.viewer.lock:
            self._session(client).go_home()

    @show_errors_in_page
    def shrink_points(self, client: int) -> None:
        self._scale_points(1 / STEP)

    @show_errors_in_page
    def grow_points(self, client: int) -> None:
        self._scale_points(STEP)

    @show_errors_in_page
    def set_point_size(self, client: int, size: float) -> None:
        self.viewer.point_size = size

    @show_errors_in_page
    def toggle_normals(self, client: int) -> None:
        self.set_normals(client, not self.viewer.normals)

    @show_errors_in_page
    def set_normals(self, client: int, shown: bool) -> None:
        self.viewer.show_normals(shown)
        if shown and not any(item.cloud is not None and item.cloud.has_normals for item in self._items()):
            self.notify(client, "No cloud in the scene has normals; call estimate_normals().")

    @show_errors_in_page
    def toggle_wireframe(self, client: int) -> None:
        self.set_wireframe(client, not self.viewer.wireframe)

    @show_errors_in_page
    def set_wireframe(self, client: int, shown: bool) -> None:
        self.viewer.show_wireframe(shown)

    @show_errors_in_page
    def set_background(self, client: int, color: tuple[int, int, int]) -> None:
        self.viewer.background = [value / 255 for value in color]

    @show_errors_in_page
    def set_visible(self, client: int, names: Iterable[str], visible: bool) -> None:
        with self.viewer.lock, self.viewer.batch():
            for name in names:
                if name in self.viewer.shown:
                    self.viewer.set_visible(name, visible)

    @show_errors_in_page
    def color(self, client: int, by: str | None, colormap: str | None, limits: Any) -> None:
        self.viewer.color_by(by, colormap=colormap, limits=limits)

    @show_errors_in_page
    def next_coloring(self, client: int) -> None:
        names: list[str | None] = [None]
        for item in self._items():
            names += [name for name in choices_of(item.cloud) if name not in names] if item.cloud is not None else []
        now = self.viewer.coloring.by
        following = names[(names.index(now) + 1) % len(names)] if now in names else None
        self.viewer.color_by(following, colormap=self.viewer.coloring.colormap)

    @show_errors_in_page
    def color_as_given(self, client: int) -> None:
        self.viewer.color_by(None)

    @show_errors_in_page
    def color_by_rgb(self, client: int) -> None:
        self.viewer.color_by("rgb")

    @show_errors_in_page
    def color_by_x(self, client: int) -> None:
        self.viewer.color_by("x", colormap=self.viewer.coloring.colormap)

    @show_errors_in_page
    def color_by_y(self, client: int) -> None:
        self.viewer.color_by("y", colormap=self.viewer.coloring.colormap)

    @show_errors_in_page
    def color_by_height(self, client: int) -> None:
        self.viewer.color_by("height", colormap=self.viewer.coloring.colormap)

    @show_errors_in_page
    def color_by_normal(self, client: int) -> None:
        self.viewer.color_by("normal")

    @show_errors_in_page
    def take_screenshot(self, client: int) -> None:
        """Render the page's view and let the page save it."""
        picture = self.viewer.screenshot(client=client)
        self._send(client, "pointloom.png", encode_png(picture), "image/png")

    @show_errors_in_page
    def save_view(self, client: int) -> None:
        """Let the page save its view as Open3D's JSON."""
        with self.viewer.lock:
            view, bounds = self._session(client).camera_view(), self.viewer.bounds
        with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:
            path = Path(folder) / "view.json"
            write_view(path, view, bounds)
            self._send(client, "view.json", path.read_bytes(), "application/json")

    @show_errors_in_page
    def load_view(self, client: int, content: bytes) -> None:
        with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:
            path = Path(folder) / "view.json"
            path.write_bytes(content)
            try:
                view = read_view(path)
            except ValueError as error:
                reason = str(error).replace(str(path), "the file")
                raise ValueError(f"{reason}. Expected a view as Open3D copies it with Ctrl+C") from error
        with self.viewer.lock:
            self._session(client).look_from(view)

    def _items(self) -> list[Any]:
        with self.viewer.lock:
            return list(self.viewer.shown.values())

    def _session(self, client: int) -> Session:
        session = self.viewer.sessions.get(client)
        if session is None:
            raise PointloomError("the page was closed")
        return session

    def _scale_points(self, factor: float) -> None:
        with self.viewer.lock:
            self.viewer.point_size = self.viewer.point_size * factor

    def _send(self, client: int, name: str, content: bytes, mime: str) -> None:
        self._session(client).client.download(name, content, mime)
