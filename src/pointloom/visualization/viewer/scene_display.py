"""Scene of a viewer as its pages show it: `SceneDisplay`."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ...pcd.cloud import PointCloud
from ..render.parts import Triangles
from ..render.view import View, ViewLike
from .camera import camera_limits, camera_of
from .deferred_update import DeferredUpdate
from .home_views import AutoFit
from .item_nodes import ItemNodes
from .items import Frame, Item, Matrix
from .level_builder import LevelBuilder
from .panel import Panel
from .scene import Scene, check_color, check_size
from .server import ViewerServer
from .sessions import PageTools, Session
from .tools.clip_planes import Clip

if TYPE_CHECKING:
    from .link import Node, PageClient

HINT = 'Nothing is shown yet. In the program, viewer.add("name", geometry) shows something here.'


class SceneDisplay:
    """Keeps the pages and the panel equal to a scene. Methods that change the scene require its lock.

    Attributes:
        sessions: Connected pages by number.
        last_closed: Time when the last page closed (`time.monotonic`).
    """

    def __init__(self, scene: Scene, server: ViewerServer, panel: Panel):
        self.scene, self.server, self.panel = scene, server, panel
        self.sessions: dict[int, Session] = {}
        self.last_closed: float | None = None
        self.nodes: dict[str, ItemNodes] = {}
        self._levels = LevelBuilder(scene, server.pages, self._show_levels)
        self._deferred = DeferredUpdate(self._apply_pending, scene.take_lock, scene.lock.release)
        self._auto_fit = AutoFit()
        self._paint_background()
        server.pages.set_hint(HINT)
        self._update_first_camera()

    def batch(self) -> contextlib.AbstractContextManager[None]:
        """Context in which changes are applied in all pages at once."""
        return self.server.pages.atomic()

    def connect(self, client: PageClient, make_tools: Callable[[Session], PageTools]) -> None:
        """Show the scene in a new page."""
        with self.scene.lock:
            if self.scene.closed:
                return
            session = Session(self.scene, client)
            self._deferred.now()
            with session.ignore_if_closed():
                session.start(make_tools)
                self.sessions[client.client_id] = session

    def disconnect(self, client: PageClient) -> None:
        with self.scene.lock:
            session = self.sessions.pop(client.client_id, None)
            self.last_closed = time.monotonic()
        if session is not None:
            session.close()

    def shut_down(self) -> list[Any]:
        """Close the pages and clear the scene. Returns the objects to join after the server is closed."""
        sessions, builders = list(self.sessions.values()), self._levels.shut_down()
        for session in sessions:
            session.close()
        self.sessions.clear()
        self.nodes.clear()
        self.scene.clear()
        self.panel.clear()
        self._deferred.close()
        return [*sessions, *builders, self._deferred]

    def in_pages(self, update: Callable[[Session], None]) -> None:
        """Update all open pages. Errors of a page are logged."""
        for session in [session for session in self.sessions.values() if not session.closed]:
            with session.ignore_if_closed():
                update(session)

    def view_of(self, client: int | None) -> View:
        """View of a page. If None: of the oldest page, or the initial view if no page is open."""
        with self.scene.lock:
            if client is None:
                first = next(iter(self.sessions.values()), None)
                return self.scene.home() if first is None else first.camera_view()
            if not isinstance(client, int) or client not in self.sessions:
                raise KeyError(f"client: expected one of the pages {sorted(self.sessions)}, got {client!r}")
            return self.sessions[client].camera_view()

    def clip_of(self, client: int | None) -> Clip | None:
        """Clip planes of a page, or of the oldest one."""
        with self.scene.lock:
            session = next(iter(self.sessions.values()), None) if client is None else self.sessions.get(client)
            return None if session is None else session.clip

    def surface_nodes(self, name: str) -> list[tuple[Triangles, Node]]:
        with self.scene.lock:
            nodes = self.nodes.get(name)
            return [] if nodes is None else nodes.surfaces()

    def add_items(self, items: Iterable[Item]) -> None:
        """Add items with new contents and replace those of the same names."""
        items, was_empty = list(items), self.scene.is_empty
        for item in items:
            self._remove(item.name)
            self._add(item)
        self._show_items(items, was_empty)
        self._auto_fit.on_added()
        self.changed(refit=was_empty)

    def replace_item(self, item: Item) -> None:
        """Replace an item of the same name without flicker."""
        was_empty = self.scene.is_empty
        self._levels.cancel(item.name)
        self.scene.add_item(item)
        self._show_items([item], was_empty)
        self.changed(refit=was_empty)

    def remove_items(self, names: Iterable[str]) -> None:
        for name in list(names):
            self._remove(name)
        self.changed()

    def clear(self) -> None:
        self.remove_items(self.scene.shown)
        self.scene.frame = Frame(np.zeros(3))

    def show_items(self, items: dict[str, Item], unbuilt: set[Item]) -> None:
        """Show exactly these items with their poses. Build the levels of detail of `unbuilt` ones."""
        scene = self.scene
        is_new = scene.is_empty and not scene.frame.origin.any()
        for name in [name for name in scene.shown if name not in items]:
            self._remove(name)
        for name, item in items.items():
            if scene.shown.get(name) is item:
                continue
            self._levels.cancel(name)
            scene.add_item(item)
            if item in unbuilt:
                unbuilt.discard(item)
                self._levels.build(item)
            self._show(item)
            self.panel.put_item(item)
        if is_new:
            self._choose_frame()
        self.changed(refit=is_new)

    def set_pose(self, name: str, pose: Matrix) -> None:
        item = self.scene.find(name)
        item.pose = pose
        self.nodes[name].set_pose()
        self.in_pages(lambda session: session.set_pose(item))
        self.scene.update_bounds(item)
        self.changed()

    def set_visible(self, name: str, visible: bool) -> None:
        item = self.scene.find(name)
        item.visible = visible
        self.nodes[name].set_visible(visible)
        self.in_pages(lambda session: session.set_visible(item))
        self.panel.put_item(item)
        self.changed()

    def set_view(self, view: ViewLike) -> None:
        home = self.scene.set_view(view)
        self._update_first_camera()
        self.in_pages(lambda session: session.look_from(home))

    def set_point_size(self, size: float) -> None:
        with self.scene.lock:
            self.scene.point_size, self.scene.has_own_point_size = check_size(size), True
            self.in_pages(lambda session: session.resize_points())
            self.panel.show_state()

    def set_background(self, color: ArrayLike) -> None:
        with self.scene.lock:
            self.scene.background, self.scene.has_own_background = check_color(color), True
            self._paint_background()
            self.panel.show_state()

    def color_by(self, by: str | None, colormap: str | None = None, limits: ArrayLike | None = None) -> None:
        scene = self.scene
        with scene.lock, self.batch():
            scene.coloring = scene.coloring.checked(by, colormap, limits, scene.shown.values())
            for item in scene.shown.values():
                scene.recolor(item)
                self.in_pages(lambda session, item=item: session.set_colors(item))
            self.panel.show_legend()

    def show_wireframe(self, shown: bool) -> None:
        with self.scene.lock:
            self.scene.wireframe = shown
            with self.batch():
                for nodes in self.nodes.values():
                    nodes.set_wireframe(shown)
            self.panel.show_state()

    def show_normals(self, shown: bool) -> None:
        with self.scene.lock:
            self.scene.normals = shown
            with self.batch():
                for nodes in self.nodes.values():
                    nodes.set_normals(self.scene.normal_length)
            self.panel.show_state()

    def changed(self, *, refit: bool = False) -> None:
        """Schedule one update of the pages for all changes within a frame. `refit`: show the complete scene now."""
        if refit:
            self._update_first_camera()
            self._update_limits()
            self._auto_fit.on_fitted(self.scene.bounds)
            self.in_pages(lambda session: session.go_home())
        self._deferred.request()

    def catch_up(self) -> None:
        """Apply scheduled updates at once."""
        with self.scene.lock:
            self._deferred.now()

    def _apply_pending(self) -> None:
        """Update budgets of large clouds, clipping planes, panel and tools."""
        scene, pages = self.scene, self.server.pages
        budgets_changed = scene.take_budget_change()
        self.panel.apply_pending()
        pages.set_hint("" if scene.shown else HINT)
        pages.set_unit(scene.page_unit)
        self._update_limits()
        if self._auto_fit.apply(None if scene.has_own_view else scene.bounds):
            self.in_pages(lambda session: session.go_home_if_still())

        def update(session: Session) -> None:
            if budgets_changed:
                session.rebalance_budgets()
            session.show_counts()
            session.refresh_tools()

        self.in_pages(update)

    def _add(self, item: Item) -> None:
        self.scene.add_item(item)
        if item.tree is None and isinstance(item.geometry, PointCloud):
            self._levels.build(item)

    def _remove(self, name: str) -> None:
        self._levels.cancel(name)
        self.scene.remove_item(name)
        self.panel.drop_item(name)
        nodes = self.nodes.pop(name, None)
        if nodes is not None:
            nodes.close()
        self.in_pages(lambda session: session.hide(name))

    def _show_items(self, items: list[Item], was_empty: bool) -> None:
        if was_empty:
            self._choose_frame()
        for item in items:
            self._show(item)
            self.panel.put_item(item)

    def _show(self, item: Item) -> None:
        nodes = self.nodes.get(item.name)
        if nodes is None:
            nodes = self._make_nodes(item)
        else:
            nodes.show(item)
        nodes.set_normals(self.scene.normal_length)
        self.in_pages(lambda session: session.show(item))

    def _make_nodes(self, item: Item) -> ItemNodes:
        scene = self.scene
        nodes = ItemNodes(self.server.pages, scene.frame, item, wireframe=scene.wireframe)
        self.nodes[item.name] = nodes
        return nodes

    def _show_levels(self, item: Item) -> None:
        """Show the levels of a cloud after they were built."""

        def update(session: Session) -> None:
            session.show(item)
            session.show_counts()

        self.in_pages(update)

    def _choose_frame(self) -> None:
        """Choose the pages' coordinates at the first geometry. Nodes in old coordinates are replaced."""
        if not self.scene.choose_frame():
            return
        for item in self.scene.shown.values():
            nodes = self.nodes.pop(item.name, None)
            if nodes is not None:
                nodes.close()
                self._make_nodes(item)
            self.in_pages(lambda session, name=item.name: session.hide(name))

    def _update_limits(self) -> None:
        scene = self.scene
        self.server.pages.set_bounds(*map(scene.frame.to_page, scene.bounds))
        self.in_pages(lambda session: session.update_limits())

    def _update_first_camera(self) -> None:
        scene = self.scene
        camera = camera_of(scene.home(), scene.frame, scene.bounds)
        self.server.pages.set_first_camera(**camera.fields(), **camera_limits(camera, scene.frame, scene.bounds))

    def _paint_background(self) -> None:
        self.server.pages.set_background(self.scene.background, own=self.scene.has_own_background)
