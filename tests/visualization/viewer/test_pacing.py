"""A page gets the next step after its acknowledgements, and updates after many changes run once a frame."""

import threading

import pytest

from pointloom.visualization.viewer import deferred_update, sessions
from pointloom.visualization.viewer.deferred_update import DeferredUpdate
from pointloom.visualization.viewer.sessions import FRAMES_PER_STEP, Pace

from .events import wait_until


@pytest.mark.parametrize("leaves", [False, True], ids=["stays", "leaves"])
def test_a_step_waits_for_a_number_of_acknowledgements_and_not_for_a_page_that_leaves(leaves):
    requests = []

    def request_sign():
        requests.append(len(requests))
        pace.answer()
        if leaves and len(requests) == FRAMES_PER_STEP:
            pace.close()

    pace = Pace(request_sign)
    assert pace.wait() != leaves and len(requests) == FRAMES_PER_STEP
    assert not leaves or (not pace.wait() and len(requests) == FRAMES_PER_STEP)  # it gets no more requests


def test_an_unresponsive_page_gets_the_next_step_after_one_request(monkeypatch):
    monkeypatch.setattr(sessions, "SIGNAL_TIMEOUT", 0.01)
    requests = []
    assert Pace(lambda: requests.append(1)).wait() and requests == [1]


@pytest.fixture
def made(monkeypatch):
    """A job that counts its runs, and its lock."""
    monkeypatch.setattr(deferred_update, "IDLE_TIMEOUT", 0.05)
    lock, done = threading.RLock(), []
    job = DeferredUpdate(lambda: done.append(threading.current_thread().name), lambda: lock.acquire(), lock.release)
    yield job, lock, done
    job.close()
    job.join()


def test_concurrent_requests_are_merged(made):
    job, lock, done = made
    with lock:
        for _ in range(100):
            job.request()
        assert done == []
    wait_until(lambda: done == ["pointloom-later"])
    wait_until(lambda: job._thread is None)  # there was nothing more to do
    with lock:
        job.request()
    wait_until(lambda: len(done) == 2)


def test_what_is_done_at_once_is_not_done_again(made):
    job, lock, done = made
    with lock:
        job.request()
        job.now()
        job.now()
    wait_until(lambda: job._thread is None)  # there was nothing more to do
    assert done == [threading.current_thread().name]


def test_a_fault_of_the_job_is_logged_and_the_next_one_is_done(made, caplog):
    job, lock, done = made
    good, job._job = job._job, lambda: 1 / 0
    with lock:
        job.request()
    wait_until(lambda: "ZeroDivisionError" in caplog.text)
    job._job = good
    with lock:
        job.request()
    wait_until(lambda: len(done) == 1)


def test_nothing_is_done_behind_the_end(made):
    job, lock, done = made
    with lock:
        job.request()
        job.close()
    job.join()
    assert done == []
    with lock:
        job.request()
    assert job._thread is None or not job._thread.is_alive()
