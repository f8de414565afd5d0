"""A viewer's server; garbage collection of the objects of one test."""

import gc
from collections.abc import Iterator

import pytest

from pointloom.visualization.viewer.server import ViewerServer

from .events import announced_events  # noqa: F401  a fixture


@pytest.fixture
def server(capfd) -> Iterator[ViewerServer]:
    """A server; nothing may be printed during the test."""
    with ViewerServer(port=0) as server:
        yield server
    assert capfd.readouterr() == ("", "")


@pytest.fixture
def quick_collection() -> Iterator[None]:
    """`gc.collect()` ignores the objects that existed before the test."""
    gc.freeze()
    yield
    gc.unfreeze()
