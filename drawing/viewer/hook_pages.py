"""The pages of a viewer, as calls of the program's functions need them: `HookPages`."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from typing import TYPE_CHECKING

from ...core.errors import PointloomError

if TYPE_CHECKING:
    from .viewer import Viewer


class HookPages:
    """Where words are shown, and what tells that a page has drawn; a viewer that was closed has no pages.

    Args:
        viewer: The viewer.
    """

    def __init__(self, viewer: Viewer):
        self._viewer = viewer
        self._answer: Callable[[], None] = lambda: None
        self._asked: frozenset[int] = frozenset()  # pages that are listened to

    def tell(self, client: int | None, text: str) -> None:
        """Show what went wrong in a page, or in all of them where none asked."""
        with contextlib.suppress(PointloomError):  # the viewer was closed meanwhile
            clients = self._viewer.server.pages.get_clients()
            for number in clients if client is None else {client} & {*clients}:
                clients[number].notify("pointloom", text, error=True)

    def are_open(self) -> bool:
        """Whether a page is open."""
        return bool(self._viewer.sessions)

    def ask_for_signs(self, answer: Callable[[], None]) -> None:
        """Have each page call back when it has drawn what it was sent."""
        self._answer = answer
        with contextlib.suppress(PointloomError):  # the viewer was closed meanwhile
            clients = self._viewer.server.pages.get_clients()
            for client in [client for number, client in clients.items() if number not in self._asked]:
                client.on_sign(lambda _: self._answer())
            self._asked = frozenset(clients)
            for client in clients.values():
                client.ask_for_sign()
