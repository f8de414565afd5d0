"""A page gets the next step after its acknowledgements; a page that has left blocks nothing."""

from pointloom.visualization.viewer import sessions
from pointloom.visualization.viewer.sessions import SIGNS, Pace


def test_a_step_waits_for_a_number_of_acknowledgements():
    requests = []

    def request_sign():
        requests.append(len(requests))
        pace.answer()

    pace = Pace(request_sign)
    assert pace.wait() and len(requests) == SIGNS


def test_a_page_that_leaves_ends_the_wait_and_gets_no_more_requests():
    requests = []

    def request_sign():
        requests.append(len(requests))
        pace.answer()
        if len(requests) == SIGNS:
            pace.close()

    pace = Pace(request_sign)
    assert not pace.wait()
    assert not pace.wait() and len(requests) == SIGNS


def test_an_unresponsive_page_gets_the_next_step_after_one_request(monkeypatch):
    monkeypatch.setattr(sessions, "SIGNAL_TIMEOUT", 0.01)
    requests = []
    assert Pace(lambda: requests.append(1)).wait() and requests == [1]
