"""Callbacks of a program for pages: controls, picks and calls with each frame."""

import logging
import threading

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.render.styles import Style
from pointloom.visualization.viewer import callback_queue
from pointloom.visualization.viewer.callback_queue import Calls
from pointloom.visualization.viewer.hooks import with_attributes
from pointloom.visualization.viewer.items import make_item
from pointloom.visualization.viewer.tools.picking import Pick, project

from .events import wait_until
from .stand_in import page_in


@pytest.fixture
def viewer():
    with loom.Viewer(port=0) as viewer:
        yield viewer


@pytest.fixture
def page(viewer):
    with page_in(viewer) as page:
        yield page


def idle(viewer):
    """Wait until the program's functions have been called."""
    done = threading.Event()
    viewer._calls().call(None, done.set)
    assert done.wait(60)


def toolbox_of(viewer):
    """The idle tools of the only page."""
    (session,) = viewer.sessions.values()
    wait_until(lambda: session._toolbox is not None)
    session._toolbox._worker.submit(lambda: None).result(60)
    return session._toolbox


def test_a_button_calls_with_the_number_of_the_page_in_a_thread_of_its_own(viewer, page):
    events = []
    viewer.add_button("Next", lambda number: events.append((number, threading.current_thread())), hotkey="j")
    with page_in(viewer) as other:
        page.press("Next (J)")
        other.key("J")
        idle(viewer)
        assert [number for number, _ in events] == [page.client.client_id, other.client.client_id]
    assert threading.current_thread() not in [thread for _, thread in events]


@pytest.mark.parametrize(
    ("add", "first", "then"),
    [
        (lambda v, f: v.add_slider("a", 0, 10, 3, f), 3, 7),
        (lambda v, f: v.add_slider("a", 0, 1.0, 0.5, f), 0.5, 0.25),
        (lambda v, f: v.add_checkbox("a", True, f), True, False),
        (lambda v, f: v.add_dropdown("a", ["x", "y"], f), "x", "y"),
        (lambda v, f: v.add_text("a", "one", f), "one", "two"),
    ],
    ids=["whole", "slider", "checkbox", "dropdown", "text"],
)
def test_a_value_set_by_a_page_is_stored_and_reported_to_the_program(viewer, page, add, first, then):
    values = []
    control = add(viewer, values.append)
    assert control.value == first and control.label == "a"
    page.set("a", then)
    idle(viewer)
    assert values == [then] and control.value == then and type(control.value) is type(then)
    control.value = first
    idle(viewer)
    assert page.control("a").value == first and values == [then]  # the program is not notified of its own changes


def test_of_a_slider_that_is_dragged_the_newest_value_waits(viewer, page):
    go, values = threading.Event(), []
    slider = viewer.add_slider("a", 0, 100, 0, lambda value: (values.append(value), go.wait(10)))
    for value in range(1, 101):
        page.set("a", value)
    go.set()
    idle(viewer)
    assert values[-1] == 100 and len(values) <= 3
    for wrong, error in ((101, ValueError), ("3", TypeError), (np.nan, ValueError), (True, TypeError)):
        with pytest.raises(error, match="value"):
            slider.value = wrong
    assert slider.value == 100


def test_folders_are_removed_with_their_last_control(viewer, page):
    before = [folder.label for folder in page.of_kind("folder")]
    first, second = viewer.add_checkbox("a"), viewer.add_checkbox("b", folder="Filter")
    third, fourth = viewer.add_checkbox("c", folder="Filter"), viewer.add_checkbox("d")
    assert [folder.label for folder in page.of_kind("folder")] == [*before, "Program", "Filter"]
    for control in (second, third, fourth, fourth):
        control.remove()
    assert [folder.label for folder in page.of_kind("folder")] == [*before, "Program"]
    first.remove()
    assert [folder.label for folder in page.of_kind("folder")] == before


def test_errors_of_a_callback_are_shown_and_logged_and_the_next_is_called(viewer, page, caplog):
    events = []

    def fail(number):
        raise SystemExit("no scan is left")

    viewer.add_button("bad", fail)
    viewer.add_button("good", events.append)
    with caplog.at_level(logging.ERROR, "pointloom.viewer"):
        page.press("bad")
        page.press("good")
        idle(viewer)
    (notice,) = page.others("notify")
    assert (notice.text, notice.kind) == ("SystemExit: no scan is left", "error") and events == [page.client.client_id]
    assert "no scan is left" in caplog.text


def test_a_full_request_queue_is_reported_to_the_page(viewer, page):
    go = threading.Event()
    viewer.add_button("slow", lambda number: go.wait(10))
    for _ in range(callback_queue.MAX_WAITING + 2):
        page.press("slow")
    go.set()
    assert {notice.text for notice in page.others("notify")} == {"The program is busy: this request was skipped."}


REFUSED = [
    (lambda v: v.add_button(3, print), TypeError, "label"),
    (lambda v: v.add_button("a", None), TypeError, "callback"),
    (lambda v: v.add_button("a", print, hotkey="F13"), ValueError, "key"),
    (lambda v: v.add_button("a", print, folder=" "), ValueError, "folder"),
    (lambda v: v.add_slider("a", 1, 1, 1), ValueError, "low"),
    (lambda v: v.add_slider("a", 0, np.inf, 1), ValueError, "high"),
    (lambda v: v.add_slider("a", 0, 1, 2), ValueError, "value"),
    (lambda v: v.add_slider("a", 0, 1, 1, step=0), ValueError, "step"),
    (lambda v: v.add_checkbox("a", 1), TypeError, "value"),
    (lambda v: v.add_checkbox(" "), ValueError, "label"),
    (lambda v: v.add_dropdown("a", []), ValueError, "options"),
    (lambda v: v.add_dropdown("a", ["x", "x"]), ValueError, "options"),
    (lambda v: v.add_dropdown("a", ["x"], value="y"), ValueError, "value"),
    (lambda v: v.add_text("a", 3), TypeError, "value"),
    (lambda v: v.add_text("a", "x" * 20_000), ValueError, "value"),
    (lambda v: v.on_key("K", "f"), TypeError, "callback"),
    (lambda v: v.on_key("F13", print), ValueError, "key"),
    (lambda v: v.on_pick("f"), TypeError, "callback"),
    (lambda v: v.on_frame(None), TypeError, "callback"),
    (lambda v: v.on_frame(print, 0), ValueError, "rate"),
    (lambda v: v.on_frame(print, 1e4), ValueError, "rate"),
]  # fmt: skip


def test_an_invalid_argument_is_rejected_by_name_and_adds_nothing(viewer, page):
    before = len(page.controls)
    for call, error, name in REFUSED:
        with pytest.raises(error, match=name):
            call(viewer)
    assert len(page.controls) == before


def test_clicks_are_reported_while_a_callback_is_registered(viewer, page):
    points = np.array([[0.0, 0, 0], [2, 0, 0], [0, 2, 0], [1, 1, 0]])
    viewer.add("scan", loom.PointCloud(points))
    picks, other = [], []
    stop, stop_other = viewer.on_pick(picks.append), viewer.on_pick(other.append)

    def click(x, y):
        page.send("click", x=(x + 0.5) / 800, y=(y + 0.5) / 600)
        idle(viewer)

    click(*project(viewer.get_view(), points[1])[:2])
    click(2, 2)  # there is no point
    stop()
    click(*project(viewer.get_view(), points[3])[:2])
    page.key("M")
    assert toolbox_of(viewer).tool.label == "Measure"  # a tool is active
    click(*project(viewer.get_view(), points[1])[:2])
    stop_other()
    stop_other()
    assert [(pick.name, pick.index) for pick in picks] == [("scan", 1)] and [pick.index for pick in other] == [1, 3]
    assert np.allclose(picks[0].point, points[1])


def test_a_pick_has_the_attributes_of_its_point():
    cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]], colors=[[0, 0, 0], [1, 0, 0]])
    cloud["intensity"] = np.array([5, 9], np.uint16)
    item = make_item("cloud", 0, cloud, Style())
    pick = with_attributes(Pick("cloud", 1, cloud.points[1]), item)
    assert pick.attributes["intensity"] == 9 and pick.attributes["color"].tolist() == [1, 0, 0]
    assert {*pick.attributes} == {"intensity", "color"}
    surface = Pick("mesh", None, np.zeros(3), 4)
    assert with_attributes(surface, None) is surface


class Clock:
    """Pages and a clock for calls with each frame, both advanced by the test."""

    def __init__(self, monkeypatch):
        self.now, self.open, self.answers, self.reported = 100.0, True, [], []
        monkeypatch.setattr(callback_queue.time, "monotonic", lambda: self.now)
        monkeypatch.setattr(Calls, "_begin", lambda self: None)  # no thread: the test runs each iteration
        self.calls = Calls(self)

    def show_error(self, client, text):
        self.reported.append((client, text))

    def are_open(self):
        return self.open

    def request_signals(self, callback):
        self.answers.append(callback)

    def advance(self, seconds):
        """Run an iteration after some seconds; the number of calls."""
        self.now += seconds
        for beat in (beats := self.calls._due()):
            self.calls._call_beat(beat)
        if beats:
            self.calls._request_signals()
        return len(beats)


@pytest.fixture
def clock(monkeypatch):
    return Clock(monkeypatch)


def test_frames_are_rate_limited_and_report_the_elapsed_time(clock):
    times = []
    stop = clock.calls.every(0.1, times.append)
    for _ in range(100):
        clock.advance(0.01)
        if clock.answers:
            clock.answers.pop()()
    assert 9 <= len(times) <= 11 and times[0] == 0 and np.allclose(times[1:], 0.1, atol=0.021)
    stop()
    assert clock.advance(1.0) == 0


def test_the_wait_for_a_slow_page_is_limited(clock):
    clock.calls.every(0.1, lambda seconds: None)
    assert clock.advance(0.2) == 1
    assert clock.advance(1.0) == 0  # it has not drawn the last one
    clock.answers.pop()()
    assert clock.advance(0.0) == 1
    assert clock.advance(callback_queue.SIGNAL_TIMEOUT + 0.1) == 1  # it may be in the background


def test_without_a_page_nothing_is_called_and_the_time_begins_anew(clock):
    times = []
    clock.calls.every(0.1, times.append)
    clock.advance(0.2)
    clock.open = False
    assert clock.advance(1.0) == 0
    clock.open = True
    clock.advance(1.0)
    assert times == [0.0, 0.0]


def test_a_frame_that_raises_is_the_last_and_all_pages_are_notified(clock, caplog):
    clock.calls.every(0.1, lambda seconds: 1 / 0)
    assert clock.advance(0.2) == 1 and clock.advance(10.0) == 0
    assert clock.reported[0] == (None, "ZeroDivisionError: division by zero") and len(clock.reported) == 2
    assert "division by zero" in caplog.text


def test_frames_come_as_a_page_takes_them_in_a_thread_and_end_with_the_viewer(viewer, page):
    threads = []
    viewer.on_frame(lambda seconds: threads.append(threading.current_thread()), rate=100)
    wait_until(lambda: page.answer() and len(threads) >= 3)
    viewer.add_button("End", lambda number: viewer.close())
    page.press("End")
    wait_until(lambda: viewer.closed)
    threads[0].join(60)
    assert not threads[0].is_alive() and threading.current_thread() not in threads


def test_a_key_of_the_program_does_nothing_else_any_more(viewer, page):
    events = []
    for key in ("m", "w", "arrowup"):
        viewer.on_key(key, events.append)
        page.key(key if key == "arrowup" else key.upper())
    idle(viewer)
    assert events == [page.client.client_id] * 3
    assert toolbox_of(viewer).tool is None and not viewer.wireframe
    viewer.on_key("W", lambda number: events.clear())
    page.key("W")
    idle(viewer)
    assert events == []
