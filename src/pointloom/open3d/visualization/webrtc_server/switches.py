"""Functions without effect: windows are pages of the browser in any case."""

from __future__ import annotations


def enable_webrtc() -> None:
    """No effect: windows are pages of the browser."""


def disable_http_handshake() -> None:
    """No effect: pages need no handshake."""
