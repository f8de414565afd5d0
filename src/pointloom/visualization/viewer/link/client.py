"""A connected page (`PageClient`) and the thread of its callbacks (`Worker`)."""

from __future__ import annotations

import contextlib
import itertools
import logging
import threading
from collections.abc import Callable, Hashable
from typing import Any

import numpy as np

from .camera import CameraState, PageCamera
from .delivery import Channel
from .gui import Gui
from .scene import ClickEvent, Scene
from .wire import camera_of

MAX_WAITING = 64  # callbacks per page. More are dropped

log = logging.getLogger("pointloom.viewer")


class Worker:
    """Runs callbacks in order in its own thread, started by the first one. Exceptions are logged."""

    def __init__(self, name: str):
        self._name = name
        self._lock = threading.Lock()
        self._wake = threading.Condition(self._lock)
        self._waiting: dict[Hashable, tuple[Callable[..., Any], tuple[Any, ...]]] = {}
        self._thread: threading.Thread | None = None
        self._ended = False

    def run(self, callback: Callable[..., Any], *arguments: Any, about: Hashable = None, always: bool = False) -> bool:
        """Queue a callback. False if it was dropped because too many wait, unless `always`.

        A waiting callback of the same key `about` is replaced.
        """
        with self._lock:
            key: Hashable = object() if about is None else (id(callback), about)
            if self._ended or (len(self._waiting) >= MAX_WAITING and key not in self._waiting and not always):
                return False
            self._waiting[key] = (callback, arguments)
            if self._thread is None:
                self._thread = threading.Thread(target=self._work, name=self._name, daemon=True)
                self._thread.start()
            self._wake.notify()
            return True

    def end(self) -> None:
        """Accept no more callbacks. The thread ends after the waiting ones."""
        with self._lock:
            self._ended = True
            self._wake.notify()

    def _work(self) -> None:
        while True:
            with self._lock:
                while not self._waiting and not self._ended:
                    self._wake.wait()
                if not self._waiting:
                    return
                key = next(iter(self._waiting))
                callback, arguments = self._waiting.pop(key)
            self._call(callback, arguments)
            del callback, arguments, key

    def _call(self, callback: Callable[..., Any], arguments: tuple[Any, ...]) -> None:
        try:
            callback(*arguments)
        except Exception:
            log.exception("a callback of the viewer failed")


class PageClient:
    """A page while it is connected. A reconnected page is a new client. No method raises because the page has gone.

    It has its own scene, panel (`gui`) and camera.
    """

    def __init__(self, channel: Channel, client_id: int, first: CameraState, shared: tuple[Scene, Gui]):
        self._channel, self.client_id, self.is_open = channel, client_id, True
        self._shared_scene, self._shared_gui = shared
        self.scene, self.gui = Scene(channel, self._shared_scene), Gui(channel)
        self.camera = PageCamera(channel, first)
        self.worker = Worker(f"pointloom-page-{client_id}")
        self._on_sign: list[Callable[[PageClient], Any]] = []
        self._signs = itertools.count(1)

    def atomic(self) -> contextlib.AbstractContextManager[None]:
        """Context in which this thread's changes are applied together; may be nested."""
        return self._channel.delivery.atomic()

    def notify(self, title: str, text: str, seconds: float = 8.0, error: bool = False) -> None:
        kind = "error" if error else "note"
        op = {"op": "notify", "title": str(title), "text": str(text), "seconds": float(seconds), "kind": kind}
        self._channel.send(op)

    def download(self, name: str, content: bytes, mime: str = "application/octet-stream") -> None:
        data = np.frombuffer(bytes(content), np.uint8)[:, None]
        self._channel.send({"op": "download", "name": str(name), "mime": str(mime), "data": data})

    def request_signal(self) -> None:
        """Request a signal from the page after it has drawn everything sent before. The last request counts."""
        self._channel.send({"op": "sign", "n": next(self._signs)})

    def on_sign(self, callback: Callable[[PageClient], Any]) -> Callable[[PageClient], Any]:
        self._on_sign.append(callback)
        return callback

    def take(self, message: dict[str, Any]) -> None:
        """Handle a checked message. Never blocks or runs a callback."""
        handler = getattr(self, f"_take_{message['say']}", None)
        if handler is None:
            return
        try:
            handler(message)
        except ValueError as error:
            log.debug("page %d: %s", self.client_id, error)

    def _take_camera(self, message: dict[str, Any]) -> None:
        state = camera_of(message)
        if state is None:
            return
        self.camera.state = state
        for callback in self.camera.update_callbacks():
            self.worker.run(callback, self.camera, about="camera")

    def _take_sign(self, message: dict[str, Any]) -> None:
        for callback in tuple(self._on_sign):
            self.worker.run(callback, self, about="sign")

    def _take_sync(self, message: dict[str, Any]) -> None:
        self.worker.run(self._channel.send, {"op": "sync", "n": int(message["n"])})

    def _take_value(self, message: dict[str, Any]) -> None:
        handle = self._find(message["id"])
        if handle is None or not hasattr(handle, "apply_value") or handle.disabled:
            return
        for callback, event in handle.apply_value(self._channel, self.client_id, message["value"]):
            self.worker.run(callback, event, about=None if handle.kind == "tree" else handle.id)

    def _take_press(self, message: dict[str, Any]) -> None:
        handle = self._find(message["id"])
        if hasattr(handle, "pressed"):
            self._call(handle.pressed(self.client_id))

    def _take_command(self, message: dict[str, Any]) -> None:
        command = self._find(message["id"])
        if hasattr(command, "triggered"):
            self._call(command.triggered(self.client_id))

    def _take_click(self, message: dict[str, Any]) -> None:
        event = ClickEvent(self.client_id, float(message["x"]), float(message["y"]), self.camera.state)
        for scene in (self.scene, self._shared_scene):
            self._call([(callback, event) for callback in scene.click_callbacks()])

    def _take_file(self, message: dict[str, Any]) -> None:
        handle = self._find(message["id"])
        if hasattr(handle, "brought"):
            self._call(handle.brought(self.client_id, message["name"], message["text"]))

    def _find(self, number: int) -> Any:
        return self.gui.find(int(number)) or self._shared_gui.find(int(number))

    def _call(self, calls: list[tuple[Callable[..., Any], Any]]) -> None:
        for callback, event in calls:
            self.worker.run(callback, event)
