"""A small program for the tests of the live page: a link, the events of its page, and its controls."""

from __future__ import annotations

import socket
from collections.abc import Callable
from typing import Any

import numpy as np
from playwright.sync_api import Page

from pointloom.visualization.viewer.guard import RequestGuard
from pointloom.visualization.viewer.link.server import PageServer

from .pixels import wait_until

RAMP = np.stack([np.arange(256), np.zeros(256), 255 - np.arange(256)], 1).astype(np.uint8)


class Program:
    """A link whose first camera looks down on a square of the plane z = 0, x to the right.

    Attributes:
        pages: The link.
        events: Events of pages, in order: the kind of a control or "command", and the value.
    """

    def __init__(self, port: int = 0, title: str = "a title"):
        bound = socket.socket()
        bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        bound.bind(("127.0.0.1", port))
        bound.listen()
        self.port = bound.getsockname()[1]
        self.pages = PageServer(bound, RequestGuard(), title)
        self.url = f"http://127.0.0.1:{self.port}/?token={self.pages.token}"
        self.events: list[tuple[str, Any]] = []
        down = np.array([[1.0, 0, 0], [0, -1, 0], [0, 0, -1]])
        self.pages.set_first_camera(position=(0, 0, 3), rotation=down, fov=0.9, pivot=(0, 0, 0), up=(0, 1, 0))
        self.pages.set_bounds((-1, -1, 0), (1, 1, 0))

    def add_square(self, color: tuple[int, int, int] = (255, 0, 0)) -> Any:
        """A cloud that fills the square."""
        positions = np.stack(np.meshgrid(*[np.linspace(-1, 1, 60)] * 2, [0.0]), -1).reshape(-1, 3).astype(np.float32)
        return self.pages.scene.add_points(positions, plain=color, size=6.0, relief=False)

    def hear(self, handle: Any) -> Any:
        """Record the events of a control."""
        note: Callable[[Any], None] = lambda event: self.events.append((handle.kind, event.value))  # noqa: E731
        for name in ("on_update", "on_click", "on_upload", "on_trigger"):
            if getattr(handle, name, None) is not None:
                getattr(handle, name)(note)
        return handle

    def last(self, kind: str) -> Any:
        """The last value of a control of this kind."""
        return next((value for name, value in reversed(self.events) if name == kind), None)

    def wait_for(self, page: Page, kind: str, value: Any) -> None:
        """Wait until the last event of a page is this one."""
        describe = lambda: f"{kind} {value!r} among {self.events}"  # noqa: E731
        wait_until(page, lambda: (kind, value) in self.events[-1:], describe)


def control(page: Page, handle: Any) -> Any:
    """The elements of a control."""
    return page.locator(f'[data-control="{handle.id}"]')
