"""Actions that a page requests by the panel and keys (`PageActions`)."""

from __future__ import annotations

import functools
import logging
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from ...core.errors import PointloomError
from ...io.images.image_files import encode_png
from ..render.open3d_views import read_view, write_view
from .coloring_choice import choices_of
from .items import Item
from .keys import KEYS, POINT_SIZE_FACTOR
from .panel import OWN, Panel
from .scene_display import SceneDisplay
from .scene_edits import SceneEdits, requested_by_page
from .screenshots import draw_scene
from .sessions import Session

if TYPE_CHECKING:
    from .link import Command, PanelEvent

log = logging.getLogger("pointloom.viewer")


def show_errors_in_page(action: Callable[..., None]) -> Callable[..., None]:
    """Decorator: show errors in the page that caused them."""

    @functools.wraps(action)
    def run(self: Any, client: int | None, *arguments: Any) -> None:
        if client is None or self.scene.closed:  # the program itself has set the value
            return
        try:
            with requested_by_page():
                action(self, client, *arguments)
        except (PointloomError, ValueError, TypeError, OSError, MemoryError) as error:
            self.notify(client, str(error), error=True)
        except Exception:
            log.debug("a request of page %s failed", client, exc_info=True)

    return run


class PageActions:
    """Actions of the panel's controls and of keys. Errors are shown in the page that requested the action."""

    def __init__(self, display: SceneDisplay, edits: SceneEdits):
        self.display, self.scene, self._edits = display, display.scene, edits
        panel, self._gui = display.panel, display.server.pages.gui
        self._connect(panel)
        self._commands: list[Command] = []
        for key in KEYS:
            for hotkey in key.hotkeys:
                self._add_key(hotkey, key.label, getattr(self, key.action), key.group)

    def _connect(self, panel: Panel) -> None:
        def on(control: Any, action: Callable[[int, Any], None]) -> None:
            control.on_update(lambda event: action(event.client_id, event.value))

        panel.tree.on_update(lambda event: self.set_visible(event.client_id, *event.value))
        on(panel.color_property, lambda client, _: self._color(client, fit=True))
        for control in (panel.colormap, panel.low, panel.high):
            on(control, lambda client, _: self._color(client))
        panel.fit_range.on_click(lambda event: self._color(event.client_id, fit=True))
        on(panel.point_size, self.set_point_size)
        on(panel.normals, self.set_normals)
        on(panel.wireframe, self.set_wireframe)
        on(panel.background, self.set_background)
        for name, button in panel.buttons.items():
            button.on_click(functools.partial(self._press, getattr(self, name)))
        panel.load_view.on_upload(lambda event: self.load_view(event.client_id, event.value.content))

    def _press(self, action: Callable[[int], None], event: PanelEvent) -> None:
        action(event.client_id)

    def bind_key(self, key: str, label: str, callback: Callable[[int], None]) -> Command:
        """Bind a key to a callback of the program only."""
        for command in [command for command in self._commands if command.hotkey == key]:
            self._commands.remove(command)
            command.remove()
        for session in self.display.sessions.values():
            session.release_key(key)

        @show_errors_in_page
        def call(_: PageActions, client: int) -> None:
            callback(client)

        return self._add_key(key, label, functools.partial(call, self), "Program")

    def _add_key(self, hotkey: str, label: str, action: Callable[[Any], None], group: str) -> Command:
        command = self._gui.add_command(label, hotkey, group=group)
        command.on_trigger(lambda event: action(event.client_id))
        self._commands.append(command)
        return command

    def notify(self, client: int, text: str, *, error: bool = False) -> None:
        session = self.display.sessions.get(client)
        if session is not None:
            session.client.notify("pointloom", text, error=error)

    @show_errors_in_page
    def reset_view(self, client: int) -> None:
        with self.scene.lock:
            self._session(client).go_home()

    @show_errors_in_page
    def shrink_points(self, client: int) -> None:
        self._scale_points(1 / POINT_SIZE_FACTOR)

    @show_errors_in_page
    def grow_points(self, client: int) -> None:
        self._scale_points(POINT_SIZE_FACTOR)

    @show_errors_in_page
    def set_point_size(self, client: int, size: float) -> None:
        self.display.set_point_size(size)

    @show_errors_in_page
    def toggle_normals(self, client: int) -> None:
        self.set_normals(client, not self.scene.normals)

    @show_errors_in_page
    def set_normals(self, client: int, shown: bool) -> None:
        self.display.show_normals(shown)
        if shown and not any(item.cloud is not None and item.cloud.has_normals for item in self._items()):
            self.notify(client, "No cloud in the scene has normals; call estimate_normals().")

    @show_errors_in_page
    def toggle_wireframe(self, client: int) -> None:
        self.set_wireframe(client, not self.scene.wireframe)

    @show_errors_in_page
    def set_wireframe(self, client: int, shown: bool) -> None:
        self.display.show_wireframe(shown)

    @show_errors_in_page
    def set_background(self, client: int, color: tuple[int, int, int]) -> None:
        self.display.set_background([value / 255 for value in color])

    @show_errors_in_page
    def set_visible(self, client: int, names: Iterable[str], visible: bool) -> None:
        with self.scene.lock, self.display.batch():
            for name in names:
                if name in self.scene.shown:
                    self._edits.set_visible(name, visible)

    @show_errors_in_page
    def color(self, client: int, by: str | None, colormap: str | None, limits: ArrayLike | None) -> None:
        self.display.color_by(by, colormap, limits)

    def _color(self, client: int, *, fit: bool = False) -> None:
        panel = self.display.panel
        by = None if panel.color_property.value == OWN else panel.color_property.value
        limits = None if fit or by is None else panel.limits
        uses_map = panel.colormap.visible or self.scene.coloring.colormap is not None
        self.color(client, by, panel.colormap.value if uses_map else None, limits)

    @show_errors_in_page
    def next_coloring(self, client: int) -> None:
        names: list[str | None] = [None]
        for item in self._items():
            names += [name for name in choices_of(item.cloud) if name not in names] if item.cloud is not None else []
        now = self.scene.coloring.by
        following = names[(names.index(now) + 1) % len(names)] if now in names else None
        self.display.color_by(following, colormap=self.scene.coloring.colormap)

    @show_errors_in_page
    def color_as_given(self, client: int) -> None:
        self.display.color_by(None)

    @show_errors_in_page
    def color_by_rgb(self, client: int) -> None:
        self.display.color_by("rgb")

    @show_errors_in_page
    def color_by_x(self, client: int) -> None:
        self.display.color_by("x", colormap=self.scene.coloring.colormap)

    @show_errors_in_page
    def color_by_y(self, client: int) -> None:
        self.display.color_by("y", colormap=self.scene.coloring.colormap)

    @show_errors_in_page
    def color_by_height(self, client: int) -> None:
        self.display.color_by("height", colormap=self.scene.coloring.colormap)

    @show_errors_in_page
    def color_by_normal(self, client: int) -> None:
        self.display.color_by("normal")

    @show_errors_in_page
    def take_screenshot(self, client: int) -> None:
        """Render the page's view and let the page save it."""
        with self.scene.lock:
            picture = draw_scene(self.scene, self.display.view_of(client), None, self.display.clip_of(client))
        self._send(client, "pointloom.png", encode_png(picture), "image/png")

    @show_errors_in_page
    def save_view(self, client: int) -> None:
        """Let the page save its view as Open3D's JSON."""
        with self.scene.lock:
            view, bounds = self._session(client).camera_view(), self.scene.bounds
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
        with self.scene.lock:
            self._session(client).look_from(view)

    def _items(self) -> list[Item]:
        with self.scene.lock:
            return list(self.scene.shown.values())

    def _session(self, client: int) -> Session:
        session = self.display.sessions.get(client)
        if session is None:
            raise PointloomError("the page was closed")
        return session

    def _scale_points(self, factor: float) -> None:
        with self.scene.lock:
            self.display.set_point_size(self.scene.point_size * factor)

    def _send(self, client: int, name: str, content: bytes, mime: str) -> None:
        self._session(client).client.download(name, content, mime)
