"""A viewer's server."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from pointloom.drawing.viewer.server import ViewerServer

from .events import announced_events  # noqa: F401  a fixture


@pytest.fixture
def server(capfd) -> Iterator[ViewerServer]:
    """A server; whatever was done to it, nothing was printed."""
    with ViewerServer(port=0) as server:
        yield server
    assert capfd.readouterr() == ("", "")
