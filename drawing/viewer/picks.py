"""Clicks in the pages that a program is told of: `Picks`."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .calls import Calls
from .items import Item
from .tools.picking import Pick

if TYPE_CHECKING:
    from .link import ClickEvent
    from .viewer import Viewer


class Picks:
    """Functions of a program that are told what a click means, where no tool is at work.

    Args:
        viewer: The viewer, whose pages tell of clicks from now on.
        calls: Calls them.
    """

    def __init__(self, viewer: Viewer, calls: Calls):
        self._viewer, self._calls = viewer, calls
        self._callbacks: tuple[Callable[[Pick], Any], ...] = ()
        viewer.server.pages.scene.on_click(self._on_click)

    def add(self, callback: Callable[[Pick], Any]) -> Callable[[], None]:
        """Tell one more, until what is returned is called."""
        entry = lambda pick: callback(pick)  # noqa: E731  # another one each time: a function may be told twice
        with self._viewer.lock:
            self._callbacks = (*self._callbacks, entry)

        def stop() -> None:
            with self._viewer.lock:
                self._callbacks = tuple(other for other in self._callbacks if other is not entry)

        return stop

    def _on_click(self, event: ClickEvent) -> None:
        session = self._viewer.sessions.get(event.client_id)
        if not self._callbacks or session is None or not (0 <= event.x <= 1 and 0 <= event.y <= 1):
            return
        stage = session.idle_stage()
        if stage is None:  # a tool is at work, and has the click
            return
        view = session.view_of(event.camera)
        x, y = event.x * view.intrinsic.width - 0.5, event.y * view.intrinsic.height - 0.5
        found = stage.pick(view, x, y)
        if found is None:
            return
        with self._viewer.lock:
            told = with_attributes(found, self._viewer.shown.get(found.name))
        for callback in self._callbacks:
            self._calls.call(event.client_id, lambda call=callback: call(told))


def with_attributes(pick: Pick, item: Item | None) -> Pick:
    """A pick with what the cloud knows of its point."""
    if item is None or item.cloud is None or pick.index is None or pick.index >= len(item.cloud):
        return pick
    row = item.select([pick.index])
    known: dict[str, Any] = {name: values[0] for name, values in row.attributes.items()}
    if row.has_colors:
        known["color"] = row.colors[0]
    if row.has_normals:
        known["normal"] = row.normals[0]
    return dataclasses.replace(pick, attributes=known)
