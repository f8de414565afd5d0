"""Waiting for pages that have gone, and the messages on stderr."""

import math
import threading
import time
import types

import pytest

import pointloom as loom
from pointloom.visualization.viewer import client_presence, scene
from pointloom.visualization.viewer.client_presence import KEEP_ALIVE, Presence
from pointloom.visualization.viewer.link import hub

from . import events
from .events import wait_until
from .pages import get, visitor_of


@pytest.fixture
def shown():
    with loom.Viewer(port=0) as viewer:
        yield viewer


class Waiting:
    """A thread that waits for the last page of a viewer, by a clock that the test sets forward.

    Attributes:
        clock_offset: Offset of the clock [s].
        polls: Number of checks for the end of the wait.
    """

    def __init__(self, viewer, keep_alive, monkeypatch):
        self.clock_offset, self.polls, self.over = 0.0, 0, threading.Event()
        clock = types.SimpleNamespace(monotonic=lambda: time.monotonic() + self.clock_offset)
        for module in (client_presence, scene, hub):
            monkeypatch.setattr(module, "time", clock)
        monkeypatch.setattr(client_presence, "LOOK", 0.001)
        is_over = Presence._is_over

        def look(*args):
            over = is_over(*args)
            self.polls += 1
            return over

        monkeypatch.setattr(Presence, "_is_over", look)
        events.announce(monkeypatch, Presence, "_is_over")
        threading.Thread(target=lambda: (viewer.wait(keep_alive=keep_alive), self.over.set()), daemon=True).start()

    def goes_on(self):
        """True if it still waits after another poll."""
        looks = self.polls
        wait_until(lambda: self.polls > looks + 1 or self.over.is_set())
        return not self.over.is_set()


def test_wait_ends_a_while_after_the_last_page_has_gone(shown, capfd, monkeypatch):
    with pytest.raises(ValueError, match="seconds"):
        shown.wait(-1)
    waiting = Waiting(shown, 100, monkeypatch)
    waiting.clock_offset = 1000.0
    assert waiting.goes_on()  # there was no page yet
    with visitor_of(shown.server):
        wait_until(lambda: shown.sessions)
        waiting.clock_offset = 2000.0
        assert waiting.goes_on()
    wait_until(lambda: not shown.sessions)
    assert waiting.goes_on()
    waiting.clock_offset += 101
    assert waiting.over.wait(60)
    ending = f"ending in 100 s (open {shown.url} again to stay, Ctrl-C ends now)"
    assert capfd.readouterr() == ("", f"the last page has closed; {ending}\n")


def test_a_reloaded_page_extends_the_wait_on_slow_connections(shown, capfd, monkeypatch):
    with visitor_of(shown.server):
        wait_until(lambda: shown.sessions)
    wait_until(lambda: not shown.sessions)
    waiting = Waiting(shown, 100, monkeypatch)
    for _ in range(2):  # the page is requested, but its websocket is late
        waiting.clock_offset += 70
        assert waiting.goes_on()
        assert get(shown.server)[0] == 200
    with visitor_of(shown.server):
        wait_until(lambda: "a page is open again" in stderr_of(capfd))
        waiting.clock_offset += 130
        assert waiting.goes_on()
    wait_until(lambda: not shown.sessions)
    waiting.clock_offset += 101
    assert waiting.over.wait(60)


def test_rejected_requests_count_as_no_page(shown):
    before = shown.server.last_request
    assert get(shown.server, Host="evil.example")[0] == 403
    assert get(shown.server, "/favicon.ico")[0] == 404
    assert shown.server.last_request == before
    get(shown.server)
    assert shown.server.last_request > before and time.monotonic() - shown.server.last_request < 60


NOW = 1e10  # [s]


def viewer_stub(seconds):
    """A viewer whose last page left `seconds` ago, or that had no page yet."""
    last_seen = None if seconds is None else NOW - seconds
    server = types.SimpleNamespace(last_request=-math.inf)
    return types.SimpleNamespace(
        url="http://u", sessions={}, _last_seen=last_seen, server=server, _ended=threading.Event()
    )


@pytest.mark.parametrize(
    ("seconds", "keep_alive", "over", "words"),
    [
        (None, 0, False, ""),
        (61, KEEP_ALIVE, True, ""),
        (59, KEEP_ALIVE, False, "ending in 60 s"),
        (1e9, math.inf, False, "waiting for another"),
        (0, 0, True, ""),
    ],
)
def test_polling_reports_once_that_the_last_page_has_gone(capfd, monkeypatch, seconds, keep_alive, over, words):
    monkeypatch.setattr(client_presence, "time", types.SimpleNamespace(monotonic=lambda: NOW))
    one = Presence(viewer_stub(seconds))
    assert [one.wait(0, keep_alive) for _ in range(3)] == [over] * 3
    with pytest.raises(ValueError, match="keep_alive"):
        one.wait(0, -1)
    lines = stderr_of(capfd).splitlines()
    assert len(lines) == bool(words) and words in "".join(lines)


def stderr_of(capfd):
    out, err = capfd.readouterr()
    assert out == ""
    return err
