"""A viewer, its server, its page; garbage collection of the objects of one test."""

import gc
from collections.abc import Iterator

import pytest

import pointloom as loom
from pointloom.visualization.viewer.server import ViewerServer

from .events import announced_events  # noqa: F401  a fixture
from .stand_in import Page, page_in


@pytest.fixture
def server(capfd) -> Iterator[ViewerServer]:
    """A server; nothing may be printed during the test."""
    with ViewerServer(port=0) as server:
        yield server
    assert capfd.readouterr() == ("", "")


@pytest.fixture
def viewer() -> Iterator[loom.Viewer]:
    with loom.Viewer(port=0) as viewer:
        yield viewer


@pytest.fixture
def page(viewer) -> Iterator[Page]:
    with page_in(viewer) as page:
        yield page


@pytest.fixture
def quick_collection() -> Iterator[None]:
    """`gc.collect()` ignores the objects that existed before the test."""
    gc.freeze()
    yield
    gc.unfreeze()
