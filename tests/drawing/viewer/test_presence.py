"""How long a viewer waits for pages that have gone, and what it says of it on stderr."""

import math
import threading
import time
import types

import pytest

import pointloom as loom
from pointloom.drawing.viewer.presence import LINGER, Presence

from .pages import get, visitor_of, wait_until


@pytest.fixture
def shown():
    with loom.Viewer(port=0) as viewer:
        yield viewer


class Waiting:
    """A thread that waits for the last page of a viewer."""

    def __init__(self, viewer, linger):
        self.over = threading.Event()
        threading.Thread(target=lambda: (viewer.wait(linger=linger), self.over.set()), daemon=True).start()


def test_wait_ends_a_while_after_the_last_page_has_gone(shown, capfd):
    with pytest.raises(ValueError, match="seconds"):
        shown.wait(-1)
    waiting = Waiting(shown, 0.4)
    assert not waiting.over.wait(0.5)  # nobody was there yet
    with visitor_of(shown.server):
        wait_until(lambda: shown.sessions)
        assert not waiting.over.wait(0.5)
    assert waiting.over.wait(60)
    ending = f"ending in 0.4 s (open {shown.url} again to stay, Ctrl-C ends now)"
    assert capfd.readouterr() == ("", f"the last page has closed; {ending}\n")


def test_a_page_that_is_loaded_again_keeps_the_wait_going_however_slow_the_line(shown, capfd):
    with visitor_of(shown.server):
        wait_until(lambda: shown.sessions)
    wait_until(lambda: not shown.sessions)
    waiting = Waiting(shown, 1.2)
    for _ in range(2):  # the page is asked for, and its websocket does not come for long
        assert not waiting.over.wait(0.7)
        assert get(shown.server)[0] == 200
    with visitor_of(shown.server):
        wait_until(lambda: "a page is open again" in told(capfd))
        assert not waiting.over.wait(1.3)
    assert waiting.over.wait(60)


def test_who_is_turned_away_at_the_door_is_no_page(shown):
    before = shown.server.last_request
    assert get(shown.server, Host="evil.example")[0] == 403
    assert get(shown.server, "/favicon.ico")[0] == 404
    assert shown.server.last_request == before
    get(shown.server)
    assert shown.server.last_request > before and time.monotonic() - shown.server.last_request < 60


def stand_in(seen):
    """A viewer whose last page went so many seconds ago, or where there was none yet."""
    gone = None if seen is None else time.monotonic() - seen
    server = types.SimpleNamespace(last_request=-math.inf)
    return types.SimpleNamespace(url="http://u", sessions={}, _last_seen=gone, server=server, _ended=threading.Event())


@pytest.mark.parametrize(
    ("seen", "linger", "over", "words"),
    [
        (None, 0, False, ""),
        (61, LINGER, True, ""),
        (59, LINGER, False, "ending in 60 s"),
        (1e9, math.inf, False, "waiting for another"),
        (0, 0, True, ""),
    ],
)
def test_polling_says_once_that_the_last_page_has_gone(capfd, seen, linger, over, words):
    presence = Presence(stand_in(seen))
    assert [presence.wait(0, linger) for _ in range(3)] == [over] * 3
    with pytest.raises(ValueError, match="linger"):
        presence.wait(0, -1)
    lines = told(capfd).splitlines()
    assert len(lines) == bool(words) and words in "".join(lines)


def told(capfd):
    out, err = capfd.readouterr()
    assert out == ""
    return err
