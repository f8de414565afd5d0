"""Callbacks for clicks on the scene: `Picks`."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .callback_queue import Calls
from .items import Item
from .scene_display import SceneDisplay
from .tools.picking import Pick

if TYPE_CHECKING:
    from .link import ClickEvent


class Picks:
    """Callbacks for clicks on the scene while no tool is active."""

    def __init__(self, display: SceneDisplay, calls: Calls):
        self._display, self._lock, self._calls = display, display.scene.lock, calls
        self._callbacks: tuple[Callable[[Pick], Any], ...] = ()
        display.server.pages.scene.on_click(self._on_click)

    def add(self, callback: Callable[[Pick], Any]) -> Callable[[], None]:
        entry = lambda pick: callback(pick)  # noqa: E731  # unique, so that a function can be added twice
        with self._lock:
            self._callbacks = (*self._callbacks, entry)

        def stop() -> None:
            with self._lock:
                self._callbacks = tuple(other for other in self._callbacks if other is not entry)

        return stop

    def _on_click(self, event: ClickEvent) -> None:
        session = self._display.sessions.get(event.client_id)
        if not self._callbacks or session is None or not (0 <= event.x <= 1 and 0 <= event.y <= 1):
            return
        tools = session.tools
        if tools is None or not tools.is_idle:  # otherwise the active tool handles the click
            return
        view = session.view_of(event.camera)
        x, y = event.x * view.intrinsic.width - 0.5, event.y * view.intrinsic.height - 0.5
        picked = tools.pick(view, x, y)
        if picked is None:
            return
        with self._lock:
            pick = with_attributes(picked, self._display.scene.shown.get(picked.name))
        for callback in self._callbacks:
            self._calls.call(event.client_id, lambda call=callback: call(pick))


def with_attributes(pick: Pick, item: Item | None) -> Pick:
    if item is None or item.cloud is None or pick.index is None or pick.index >= len(item.cloud):
        return pick
    row = item.select([pick.index])
    known: dict[str, Any] = {name: values[0] for name, values in row.attributes.items()}
    if row.has_colors:
        known["color"] = row.colors[0]
    if row.has_normals:
        known["normal"] = row.normals[0]
    return dataclasses.replace(pick, attributes=known)
