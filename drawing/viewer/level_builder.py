"""Levels of detail of clouds that a program adds, built while a part of them is shown: `LevelBuilder`."""

from __future__ import annotations

import logging
import threading
from typing import TYPE_CHECKING

from .detail_tree import DetailTree
from .items import Item

if TYPE_CHECKING:
    from .viewer import Viewer

log = logging.getLogger("pointloom.viewer")


class LevelBuilder:
    """Builds levels in threads of its own; pages are told so, and shown them when they are there.

    Args:
        viewer: Whose lock is held by who calls.
    """

    def __init__(self, viewer: Viewer):
        self._viewer = viewer
        self._coming: dict[str, Item] = {}
        self._threads: list[threading.Thread] = []

    def __contains__(self, name: str) -> bool:
        """Whether the levels of an item are being built."""
        return name in self._coming

    def build(self, item: Item) -> None:
        """Build the levels of a cloud, if it is too large to be sent whole."""
        if item.cloud is None or len(item.cloud) <= self._viewer.max_points:
            return
        self._coming[item.name] = item
        self._threads = [thread for thread in self._threads if thread.is_alive()]
        thread = threading.Thread(target=self._build, args=(item,), name="pointloom-levels", daemon=True)
        self._threads.append(thread)
        self._tell()
        thread.start()

    def forget(self, name: str) -> None:
        """An item has gone, or is another one now."""
        if self._coming.pop(name, None) is not None:
            self._tell()

    def let_go(self) -> list[threading.Thread]:
        """Forget all; the threads that are to be waited for."""
        threads, self._threads = self._threads, []
        self._coming.clear()
        return threads

    def _build(self, item: Item) -> None:
        viewer = self._viewer
        try:
            assert item.cloud is not None
            tree = None if viewer.closed else DetailTree.from_cloud(item.cloud)
        except Exception:  # no memory for it: an even share is what can be shown
            log.warning("%s is shown without levels of detail", item.name, exc_info=True)
            tree = None
        if not viewer.take_lock():
            return
        try:
            if self._coming.get(item.name) is item:
                del self._coming[item.name]
                item.tree = tree
                viewer._show_levels(item)
                self._tell()
        finally:
            viewer.lock.release()

    def _tell(self) -> None:
        """Say in the pages which clouds are being prepared."""
        coming = list(self._coming)
        others = f" and {len(coming) - 1} more" if len(coming) > 1 else ""
        text = f"a first look; preparing all points of {coming[0]}{others}" if coming else ""
        self._viewer.server.pages.set_progress(text)
