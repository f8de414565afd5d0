"""A page is sent the next step when it has given its signs, and nothing waits for one that has gone."""

from __future__ import annotations

from pointloom.visualization.viewer import sessions
from pointloom.visualization.viewer.sessions import SIGNS, Pace


def test_a_step_waits_for_so_many_signs():
    asked = []

    def ask():
        asked.append(len(asked))
        pace.answer()

    pace = Pace(ask)
    assert pace.wait() and len(asked) == SIGNS


def test_a_page_that_goes_ends_the_wait_and_is_asked_no_more():
    asked = []

    def ask():
        asked.append(len(asked))
        pace.answer()
        if len(asked) == SIGNS:
            pace.close()

    pace = Pace(ask)
    assert not pace.wait()
    assert not pace.wait() and len(asked) == SIGNS


def test_a_page_that_gives_no_sign_is_asked_once_and_sent_the_next_step(monkeypatch):
    monkeypatch.setattr(sessions, "SIGNAL_TIMEOUT", 0.01)
    asked = []
    assert Pace(lambda: asked.append(1)).wait() and asked == [1]
