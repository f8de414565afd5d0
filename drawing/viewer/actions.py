"""What keys and buttons of the page do: `Actions`; each takes the number of the page that asks."""

from __future__ import annotations

import functools
import logging
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...core.errors import PointloomError
from ...files.pictures.image_files import encode_png
from ..render.open3d_views import read_view, write_view
from .coloring_choice import choices_of
from .keys import STEP
from .logged import asked_by_page
from .sessions import Session

if TYPE_CHECKING:
    from .viewer import Viewer

log = logging.getLogger("pointloom.viewer")


def told_to_page(action: Callable[..., None]) -> Callable[..., None]:
    """Show what goes wrong in the page that asked for it; the viewer goes on."""

    @functools.wraps(action)
    def run(self: Any, client: int | None, *arguments: Any) -> None:
        if client is None or self.viewer.closed:  # the program itself has set what the page shows
            return
        try:
            with asked_by_page():
                action(self, client, *arguments)
        except (PointloomError, ValueError, TypeError, OSError, MemoryError) as error:
            self.tell(client, str(error), error=True)
        except Exception:
            log.debug("what page %s asked for", client, exc_info=True)

    return run


class Actions:
    """The actions of a viewer's panel.

    Args:
        viewer: The viewer.
    """

    def __init__(self, viewer: Viewer):
        self.viewer = viewer

    def tell(self, client: int, text: str, *, error: bool = False) -> None:
        """Show a message in a page."""
        session = self.viewer.sessions.get(client)
        if session is not None:
            session.client.notify("pointloom", text, error=error)

    def calling(self, callback: Callable[[int], None]) -> Callable[[int | None], None]:
        """A program's function as an action."""

        @told_to_page
        def call(_: Actions, client: int) -> None:
            callback(client)

        return functools.partial(call, self)

    @told_to_page
    def reset_view(self, client: int) -> None:
        """Look from where the page began."""
        with self.viewer.lock:
            self._session(client).go_home()

    @told_to_page
    def shrink_points(self, client: int) -> None:
        """Smaller points."""
        self._scale_points(1 / STEP)

    @told_to_page
    def grow_points(self, client: int) -> None:
        """Larger points."""
        self._scale_points(STEP)

    @told_to_page
    def set_point_size(self, client: int, size: float) -> None:
        """Points of a size [px]."""
        self.viewer.point_size = size

    @told_to_page
    def toggle_normals(self, client: int) -> None:
        """Show or hide normals."""
        self.set_normals(client, not self.viewer.normals)

    @told_to_page
    def set_normals(self, client: int, shown: bool) -> None:
        """Show or hide normals."""
        self.viewer.show_normals(shown)
        if shown and not any(item.cloud is not None and item.cloud.has_normals for item in self._items()):
            self.tell(client, "No cloud here has normals; estimate_normals() makes them.")

    @told_to_page
    def toggle_wireframe(self, client: int) -> None:
        """Show or hide edges."""
        self.set_wireframe(client, not self.viewer.wireframe)

    @told_to_page
    def set_wireframe(self, client: int, shown: bool) -> None:
        """Show or hide edges."""
        self.viewer.show_wireframe(shown)

    @told_to_page
    def set_background(self, client: int, color: tuple[int, int, int]) -> None:
        """Another colour behind it all, 0 to 255."""
        self.viewer.background = [value / 255 for value in color]

    @told_to_page
    def set_visible(self, client: int, names: Iterable[str], visible: bool) -> None:
        """Show or hide geometries."""
        with self.viewer.lock, self.viewer.batch():
            for name in names:
                if name in self.viewer.shown:
                    self.viewer.set_visible(name, visible)

    @told_to_page
    def color(self, client: int, by: str | None, colormap: str | None, limits: Any) -> None:
        """Colour the clouds by what is known of their points."""
        self.viewer.color_by(by, colormap=colormap, limits=limits)

    @told_to_page
    def next_coloring(self, client: int) -> None:
        """The next thing that clouds can be coloured by."""
        names: list[str | None] = [None]
        for item in self._items():
            names += [name for name in choices_of(item.cloud) if name not in names] if item.cloud is not None else []
        now = self.viewer.coloring.by
        following = names[(names.index(now) + 1) % len(names)] if now in names else None
        self.viewer.color_by(following, colormap=self.viewer.coloring.colormap)

    @told_to_page
    def color_as_given(self, client: int) -> None:
        """The clouds' own colours."""
        self.viewer.color_by(None)

    @told_to_page
    def color_by_rgb(self, client: int) -> None:
        """The clouds' colours."""
        self.viewer.color_by("rgb")

    @told_to_page
    def color_by_x(self, client: int) -> None:
        """Colours by x."""
        self.viewer.color_by("x", colormap=self.viewer.coloring.colormap)

    @told_to_page
    def color_by_y(self, client: int) -> None:
        """Colours by y."""
        self.viewer.color_by("y", colormap=self.viewer.coloring.colormap)

    @told_to_page
    def color_by_height(self, client: int) -> None:
        """Colours by z."""
        self.viewer.color_by("height", colormap=self.viewer.coloring.colormap)

    @told_to_page
    def color_by_normal(self, client: int) -> None:
        """Colours by direction."""
        self.viewer.color_by("normal")

    @told_to_page
    def take_screenshot(self, client: int) -> None:
        """Have the page save a picture of what it shows, drawn here."""
        picture = self.viewer.screenshot(client=client)
        self._send(client, "pointloom.png", encode_png(picture), "image/png")

    @told_to_page
    def save_view(self, client: int) -> None:
        """Have the page save its view as Open3D's JSON."""
        with self.viewer.lock:
            view, bounds = self._session(client).camera_view(), self.viewer.bounds
        with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:
            path = Path(folder) / "view.json"
            write_view(path, view, bounds)
            self._send(client, "view.json", path.read_bytes(), "application/json")

    @told_to_page
    def load_view(self, client: int, content: bytes) -> None:
        """Look from where a file of Open3D's view JSON says."""
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
            raise PointloomError("the page has gone")
        return session

    def _scale_points(self, factor: float) -> None:
        with self.viewer.lock:
            self.viewer.point_size = self.viewer.point_size * factor

    def _send(self, client: int, name: str, content: bytes, mime: str) -> None:
        self._session(client).client.download(name, content, mime)
