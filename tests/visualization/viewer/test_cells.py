"""Viewers of notebook cells: a rerun cell closes its last viewer, and the oldest are closed beyond the limit."""

import gc
import sys
import types
import weakref

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.viewer import draw as cells
from pointloom.visualization.viewer.draw import MAX_OPEN, keep, make_room

from .events import wait_until
from .pages import hear_until, visitor_of


class Kernel:
    """The request that a kernel is processing."""

    def __init__(self):
        self.count = 0

    def run(self, code, **metadata):
        self.count += 1
        request = {"header": {"msg_id": str(self.count)}, "metadata": metadata, "content": {"code": code}}
        self.get_parent = lambda: request


class StandIn:
    """A viewer without a server."""

    def __init__(self):
        self.closed, self.words = False, []

    def close(self):
        self.closed = True

    def _close(self, words):
        self.words.append(words)
        self.close()


@pytest.fixture
def kernel(monkeypatch):
    kernel = Kernel()
    kernel.kernel = kernel  # as of Jupyter's shells
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(get_ipython=lambda: kernel))
    monkeypatch.setattr(cells, "_opened", [])
    return kernel


def opened():
    make_room()
    viewer = StandIn()
    keep(viewer)
    return viewer


@pytest.mark.parametrize("metadata", [{}, {"cellId": "a"}, {"cell_id": "a"}])
def test_a_rerun_cell_closes_its_earlier_viewer(kernel, metadata):
    kernel.run("draw(a); draw(b)", **metadata)
    first = [opened(), opened()]
    kernel.run("draw(c)", cellId="another")
    other = opened()
    assert not any(viewer.closed for viewer in first)  # two of one run
    kernel.run("draw(a); draw(b)", **metadata)
    again = opened()
    assert all(viewer.closed and not viewer.words for viewer in first) and not other.closed and not again.closed
    kernel.run("draw(a); draw(b)", cellId="of the same text")
    opened()
    assert not again.closed
    kernel.run("draw(edited)", **metadata)
    opened()
    assert again.closed == bool(metadata)


def test_the_oldest_viewer_is_closed_with_a_message_at_the_limit(kernel):
    viewers = []
    for number in range(MAX_OPEN + 4):
        kernel.run(f"draw({number})")
        viewers.append(opened())
    assert [viewer.closed for viewer in viewers] == [True] * 4 + [False] * MAX_OPEN
    assert all("oldest" in viewer.words[0] for viewer in viewers[:4])
    kernel.run("draw(15)")
    opened()  # of an existing cell: no other viewer is closed
    assert [viewer.closed for viewer in viewers[4:]].count(True) == 1


@pytest.mark.parametrize("request_", [None, {}, {"metadata": None}, {"metadata": {}, "content": {}, "header": {}}])
def test_a_kernel_without_cell_ids_closes_viewers_only_at_the_limit(kernel, request_):
    kernel.get_parent = lambda: request_
    viewers = [opened() for _ in range(MAX_OPEN + 1)]
    assert [viewer.closed for viewer in viewers] == [True] + [False] * MAX_OPEN


def test_closed_or_collected_viewers_are_forgotten(kernel, quick_collection):
    kernel.run("draw(a)")
    let_go = weakref.ref(opened())
    closed = opened()
    closed.close()
    gc.collect()
    assert let_go() is None
    kernel.run("draw(b)")
    opened()
    assert len(cells._opened) == 1


def test_the_earlier_cloud_of_a_rerun_cell_is_freed(kernel, capfd, quick_collection):
    clouds, viewers = [], []
    for _ in range(3):
        kernel.run("viewer = loom.draw(cloud)", cellId="a")
        cloud = loom.PointCloud(np.random.default_rng(0).random((50, 3)))
        clouds.append(weakref.ref(cloud))
        viewers.append(loom.draw(cloud, port=0, inline=False, width=64, height=48))
        del cloud
    gc.collect()
    assert [viewer.closed for viewer in viewers] == [True, True, False]
    assert [cloud() is None for cloud in clouds] == [True, True, False]
    viewers[-1].close()
    assert capfd.readouterr() == ("", "")


def test_visitors_of_the_oldest_viewer_are_notified(kernel, monkeypatch):
    monkeypatch.setattr(cells, "MAX_OPEN", 1)
    kernel.run("loom.draw(first)")
    first = loom.draw(np.eye(3), port=0, inline=False, width=64, height=48)
    with visitor_of(first.server) as page:
        wait_until(lambda: first.sessions)
        kernel.run("loom.draw(second)")
        loom.draw(np.eye(3), port=0, inline=False, width=64, height=48).close()
        assert first.closed
        assert "the oldest" in hear_until(page, "end")["text"]
