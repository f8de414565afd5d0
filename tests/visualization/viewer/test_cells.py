"""Viewers of a notebook's cells: one that runs again closes its last, and the oldest of too many go."""

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
    """The request that a kernel answers."""

    def __init__(self):
        self.count = 0

    def run(self, code, **metadata):
        """From now on this cell runs."""
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
def test_a_cell_that_runs_again_closes_what_it_opened(kernel, metadata):
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


def test_of_too_many_the_oldest_goes_and_says_so(kernel):
    viewers = []
    for number in range(MAX_OPEN + 4):
        kernel.run(f"draw({number})")
        viewers.append(opened())
    assert [viewer.closed for viewer in viewers] == [True] * 4 + [False] * MAX_OPEN
    assert all("oldest" in viewer.words[0] for viewer in viewers[:4])
    kernel.run("draw(15)")
    opened()  # of a cell that is there: nothing else goes
    assert [viewer.closed for viewer in viewers[4:]].count(True) == 1


@pytest.mark.parametrize("request_", [None, {}, {"metadata": None}, {"metadata": {}, "content": {}, "header": {}}])
def test_a_kernel_that_tells_no_cell_closes_none_before_there_are_too_many(kernel, request_):
    kernel.get_parent = lambda: request_
    viewers = [opened() for _ in range(MAX_OPEN + 1)]
    assert [viewer.closed for viewer in viewers] == [True] + [False] * MAX_OPEN


def test_viewers_that_were_closed_or_let_go_are_forgotten(kernel, quick_collection):
    kernel.run("draw(a)")
    let_go = weakref.ref(opened())
    closed = opened()
    closed.close()
    gc.collect()
    assert let_go() is None
    kernel.run("draw(b)")
    opened()
    assert len(cells._opened) == 1


def test_a_cell_s_earlier_cloud_is_let_go_when_it_runs_again(kernel, capfd, quick_collection):
    held, viewers = [], []
    for _ in range(3):
        kernel.run("viewer = loom.draw(cloud)", cellId="a")
        cloud = loom.PointCloud(np.random.default_rng(0).random((50, 3)))
        held.append(weakref.ref(cloud))
        viewers.append(loom.draw(cloud, port=0, inline=False, width=64, height=48))
        del cloud
    gc.collect()
    assert [viewer.closed for viewer in viewers] == [True, True, False]
    assert [cloud() is None for cloud in held] == [True, True, False]
    viewers[-1].close()
    assert capfd.readouterr() == ("", "")


def test_the_visitor_of_the_oldest_is_told(kernel, monkeypatch):
    monkeypatch.setattr(cells, "MAX_OPEN", 1)
    kernel.run("loom.draw(first)")
    first = loom.draw(np.eye(3), port=0, inline=False, width=64, height=48)
    with visitor_of(first.server) as page:
        wait_until(lambda: first.sessions)
        kernel.run("loom.draw(second)")
        loom.draw(np.eye(3), port=0, inline=False, width=64, height=48).close()
        assert first.closed
        assert "the oldest" in hear_until(page, "end")["text"]
