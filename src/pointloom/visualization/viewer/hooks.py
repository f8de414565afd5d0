"""Callbacks and controls that a program adds to a viewer's pages: `Hooks`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .callback_queue import Calls, HookPages
from .controls import Controls
from .page_actions import PageActions
from .picks import Picks
from .scene_display import SceneDisplay
from .tools.picking import Pick


class Hooks:
    """Callbacks and controls of a viewer, created on first use. See the methods of `Viewer`.

    Callbacks run one after the other in a thread of the viewer and may call every method of it, including `close`. An
    exception of a callback is displayed in the page that caused the call and logged to `pointloom.viewer`.
    """

    def __init__(self, display: SceneDisplay, actions: PageActions):
        self._display, self._scene, self._actions = display, display.scene, actions
        self._calls: Calls | None = None
        self._controls: Controls | None = None
        self._picks: Picks | None = None

    @property
    def calls(self) -> Calls:
        with self._scene.lock:
            self._scene.check_open()
            if self._calls is None:
                self._calls = Calls(HookPages(self._display.server, self._display.sessions))
            return self._calls

    @property
    def controls(self) -> Controls:
        with self._scene.lock:
            calls = self.calls
            if self._controls is None:
                self._controls = Controls(self._display.server.pages.gui, calls, self._actions.bind_key)
            return self._controls

    def on_key(self, key: str, callback: Callable[[int], None], label: str) -> None:
        with self._scene.lock:
            calls = self.calls
            self._actions.bind_key(key, label, lambda client: calls.call(client, lambda: callback(client)))

    def on_pick(self, callback: Callable[[Pick], Any]) -> Callable[[], None]:
        with self._scene.lock:
            calls = self.calls
            if self._picks is None:
                self._picks = Picks(self._display, calls)
        return self._picks.add(callback)

    def close(self) -> list[Calls]:
        """End all callbacks. Returns the objects to join without the lock."""
        if self._calls is None:
            return []
        self._calls.close()
        return [self._calls]


def check_function(callback: object) -> None:
    if not callable(callback):
        raise TypeError(f"callback: expected a function, got {type(callback).__name__}")
