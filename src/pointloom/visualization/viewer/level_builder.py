"""Levels of detail of large clouds, built in threads: `LevelBuilder`."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

from .detail_tree import DetailTree
from .items import Item

if TYPE_CHECKING:
    from .link import PageServer
    from .scene import Scene

log = logging.getLogger("pointloom.viewer")


class LevelBuilder:
    """Builds levels of detail in threads and passes each finished item to `on_built`. Requires the scene's lock."""

    def __init__(self, scene: Scene, pages: PageServer, on_built: Callable[[Item], None]):
        self._scene, self._pages, self._on_built = scene, pages, on_built
        self._threads: list[threading.Thread] = []

    def build(self, item: Item) -> None:
        """Build the levels of a cloud that is too large to be sent completely."""
        if item.cloud is None or len(item.cloud) <= self._scene.max_points:
            return
        self._scene.previews[item.name] = item
        self._threads = [thread for thread in self._threads if thread.is_alive()]
        thread = threading.Thread(target=self._build, args=(item,), name="pointloom-levels", daemon=True)
        self._threads.append(thread)
        self._show_status()
        thread.start()

    def cancel(self, name: str) -> None:
        if self._scene.previews.pop(name, None) is not None:
            self._show_status()

    def shut_down(self) -> list[threading.Thread]:
        """Cancel all builds. Returns the threads to wait for."""
        threads, self._threads = self._threads, []
        self._scene.previews.clear()
        return threads

    def _build(self, item: Item) -> None:
        scene = self._scene
        try:
            assert item.cloud is not None
            tree = None if scene.closed else DetailTree.from_cloud(item.cloud)
        except Exception:  # out of memory: show an even sample
            log.warning("%s is shown without levels of detail", item.name, exc_info=True)
            tree = None
        if not scene.take_lock():
            return
        try:
            if scene.previews.get(item.name) is item:
                del scene.previews[item.name]
                item.tree = tree
                self._on_built(item)
                self._show_status()
        finally:
            scene.lock.release()

    def _show_status(self) -> None:
        names = list(self._scene.previews)
        others = f" and {len(names) - 1} more" if len(names) > 1 else ""
        text = f"a preview; preparing all points of {names[0]}{others}" if names else ""
        self._pages.set_progress(text)
