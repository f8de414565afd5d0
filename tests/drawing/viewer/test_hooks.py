"""What a program hangs on the pages: controls, picks and calls with each frame, by a stand-in for the link."""

from __future__ import annotations

import contextlib
import logging
import threading
import time
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import PointloomError
from pointloom.drawing.render.styles import Style
from pointloom.drawing.viewer import calls
from pointloom.drawing.viewer.calls import Calls
from pointloom.drawing.viewer.camera import view_of
from pointloom.drawing.viewer.hooks import Hooks
from pointloom.drawing.viewer.items import Frame, make_item
from pointloom.drawing.viewer.link.camera import CameraState
from pointloom.drawing.viewer.link.scene import ClickEvent
from pointloom.drawing.viewer.picks import with_attributes
from pointloom.drawing.viewer.tools.picking import Pick, project

from .pages import HELLO, hear, line_of, say, wait_until


class Handle:
    """A handle of the link: values, callbacks, whether it was removed."""

    def __init__(self, kind, label, values):
        self.kind, self.label, self.values, self.removed, self.callbacks = kind, label, values, False, []
        self.value = values[-1] if values else None

    def on(self, callback):
        self.callbacks.append(callback)
        return callback

    on_click = on_update = on_trigger = on

    def fire(self, value=None, client=7):
        for callback in self.callbacks:
            callback(SimpleNamespace(client_id=client, value=value, target=self))

    def remove(self):
        self.removed = True

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass


class Gui:
    def __init__(self):
        self.handles = []

    def __getattr__(self, name):
        def add(label, *values, **_):
            self.handles.append(Handle(name[4:], label, values))
            return self.handles[-1]

        return add

    def find(self, label, kind=None):
        return next(h for h in self.handles if h.label == label and kind in (None, h.kind) and not h.removed)


class Page:
    """A page that tells what it was shown and picks what it is told to; both a session and a client."""

    def __init__(self):
        self.told, self.asked, self.listeners, self.stage = [], 0, [], self

    def notify(self, title, text, *, error=False):
        self.told.append((text, error))

    def on_sign(self, callback):
        self.listeners.append(callback)

    def ask_for_sign(self):
        self.asked += 1

    def idle_stage(self):
        return self.stage

    def view_of(self, camera):
        return view_of(camera, Frame(np.zeros(3)), (np.zeros(3), np.ones(3)), camera.size)


class Stand(Hooks):
    """What hooks need of a viewer, with one page of number 7."""

    def __init__(self):
        self.page, self.lock, self.closed = Page(), threading.RLock(), False
        self.sessions, gui = {7: self.page}, Gui()
        self.shown = {}
        scene = SimpleNamespace(clicks=[])
        scene.on_click = scene.clicks.append
        scene.remove_click_callback = scene.clicks.remove
        pages = SimpleNamespace(gui=gui, scene=scene, get_clients=lambda: {7: self.page}, atomic=contextlib.nullcontext)
        self.server, self.panel = SimpleNamespace(pages=pages), SimpleNamespace(bind_key=self.bind_key)
        self.gui, self.clicks, self.keys = gui, scene.clicks, {}

    def bind_key(self, key, label, callback):
        self.keys[key] = callback
        return Handle("command", label, ())

    def _check_open(self):
        if self.closed:
            raise PointloomError("closed")

    def idle(self):
        """All that was asked for is done."""
        done = threading.Event()
        self._calls().call(7, done.set)
        assert done.wait(60)


@pytest.fixture
def stand():
    stand = Stand()
    yield stand
    for thread in stand._end_hooks():
        thread.join()


def test_a_button_calls_with_the_number_of_the_page_in_a_thread_of_its_own(stand):
    heard = []
    stand.add_button("Next", lambda page: heard.append((page, threading.current_thread())))
    stand.gui.find("Next", "button").fire()
    stand.gui.find("Next", "button").fire(client=8)
    stand.idle()
    assert [page for page, _ in heard] == [7, 8]
    assert threading.current_thread() not in [thread for _, thread in heard]


@pytest.mark.parametrize(
    ("add", "first", "then"),
    [
        (lambda s, f: s.add_slider("a", 0, 10, 3, f), 3, 7),
        (lambda s, f: s.add_slider("a", 0, 1.0, 0.5, f), 0.5, 0.25),
        (lambda s, f: s.add_checkbox("a", True, f), True, False),
        (lambda s, f: s.add_dropdown("a", ["x", "y"], f), "x", "y"),
        (lambda s, f: s.add_text("a", "one", f), "one", "two"),
    ],
    ids=["whole", "slider", "checkbox", "dropdown", "text"],
)
def test_what_a_page_sets_is_the_value_and_is_told_to_the_program(stand, add, first, then):
    heard = []
    control = add(stand, heard.append)
    assert control.value == first and control.label == "a"
    stand.gui.find("a").fire(then)
    stand.idle()
    assert heard == [then] and control.value == then and type(control.value) is type(then)
    control.value = first
    stand.idle()
    assert stand.gui.find("a").value == first and heard == [then]  # the program is not told what it did


def test_a_value_that_the_control_does_not_take_is_refused_and_of_a_page_passed_over(stand):
    heard = []
    slider = stand.add_slider("a", 0, 10, 3, heard.append)
    stand.gui.find("a").fire(11)
    for wrong, error in ((11, ValueError), ("3", TypeError), (np.nan, ValueError), (True, TypeError)):
        with pytest.raises(error, match="value"):
            slider.value = wrong
    stand.idle()
    assert slider.value == 3 and heard == []


def test_of_a_slider_that_is_dragged_the_newest_value_waits(stand):
    go, heard = threading.Event(), []
    stand.add_slider("a", 0, 100, 0, lambda value: (heard.append(value), go.wait(10)))
    for value in range(1, 101):
        stand.gui.find("a").fire(value)
    go.set()
    stand.idle()
    assert heard[-1] == 100 and len(heard) <= 3


def test_controls_lie_in_folders_that_go_with_the_last_of_them(stand):
    first, second = stand.add_checkbox("a"), stand.add_checkbox("b", folder="Filter")
    third = stand.add_checkbox("c", folder="Filter")
    assert [h.label for h in stand.gui.handles if h.kind == "folder"] == ["Program", "Filter"]
    heard = []
    fourth = stand.add_checkbox("d", callback=heard.append)
    handle = stand.gui.find("d")
    for control in (second, third, fourth, fourth):
        control.remove()
    handle.fire(True)  # was under way
    stand.idle()
    assert heard == [] and [h.label for h in stand.gui.handles if not h.removed] == ["Program", "a"]
    first.remove()
    assert all(h.removed for h in stand.gui.handles)


def test_what_a_function_raises_is_shown_in_the_page_and_logged_and_the_next_is_called(stand, caplog):
    heard = []

    def fail(page):
        raise SystemExit("no scan is left")

    stand.add_button("bad", fail)
    stand.add_button("good", heard.append)
    with caplog.at_level(logging.ERROR, "pointloom.viewer"):
        stand.gui.find("bad", "button").fire()
        stand.gui.find("good", "button").fire()
        stand.idle()
    assert stand.page.told == [("SystemExit: no scan is left", True)] and heard == [7]
    assert "no scan is left" in caplog.text


def test_more_than_can_wait_is_told_to_the_page(stand):
    go = threading.Event()
    stand.add_button("slow", lambda page: go.wait(10))
    for _ in range(calls.MOST_WAITING + 2):
        stand.gui.find("slow", "button").fire()
    go.set()
    assert {text for text, _ in stand.page.told} == {"The program is busy: this was passed over."}


@pytest.mark.parametrize(
    ("call", "error", "name"),
    [
        (lambda s: s.add_button(3, print), TypeError, "label"),
        (lambda s: s.add_button("a", None), TypeError, "callback"),
        (lambda s: s.add_button("a", print, hotkey="F13"), ValueError, "key"),
        (lambda s: s.add_button("a", print, folder=" "), ValueError, "folder"),
        (lambda s: s.add_slider("a", 1, 1, 1), ValueError, "low"),
        (lambda s: s.add_slider("a", 0, np.inf, 1), ValueError, "high"),
        (lambda s: s.add_slider("a", 0, 1, 2), ValueError, "value"),
        (lambda s: s.add_slider("a", 0, 1, 1, step=0), ValueError, "step"),
        (lambda s: s.add_checkbox("a", 1), TypeError, "value"),
        (lambda s: s.add_checkbox(" "), ValueError, "label"),
        (lambda s: s.add_dropdown("a", []), ValueError, "options"),
        (lambda s: s.add_dropdown("a", ["x", "x"]), ValueError, "options"),
        (lambda s: s.add_dropdown("a", ["x"], value="y"), ValueError, "value"),
        (lambda s: s.add_text("a", 3), TypeError, "value"),
        (lambda s: s.add_text("a", "x" * 20_000), ValueError, "value"),
        (lambda s: s.on_key("K", "f"), TypeError, "callback"),
        (lambda s: s.on_key("F13", print), ValueError, "key"),
        (lambda s: s.on_pick("f"), TypeError, "callback"),
        (lambda s: s.on_frame(None), TypeError, "callback"),
        (lambda s: s.on_frame(print, 0), ValueError, "rate"),
        (lambda s: s.on_frame(print, 1e4), ValueError, "rate"),
    ],
)  # fmt: skip
def test_an_argument_that_makes_no_sense_is_refused_by_name_and_adds_nothing(stand, call, error, name):
    with pytest.raises(error, match=name):
        call(stand)
    assert stand.gui.handles == []


def click_at(x, client=7):
    camera = CameraState(position=np.zeros(3), rotation=np.eye(3), fov=1.0, size=(200, 100), pivot=np.zeros(3))
    return ClickEvent(client, x, 0.5, False, False, camera)


def test_a_click_is_told_while_somebody_asks_for_it(stand):
    met, heard, other, places = Pick("cloud", 3, np.zeros(3)), [], [], []
    stand.page.pick = lambda view, x, y: places.append((x, y)) or (met if x < 100 else None)
    stop, stop_other = stand.on_pick(heard.append), stand.on_pick(other.append)
    click = stand.clicks[0]
    for event in (click_at(0.2), click_at(0.7), click_at(0.2, client=99)):
        click(event)
    stop()
    click(click_at(0.2))
    stand.page.stage = None  # a tool is at work
    click(click_at(0.2))
    stand.idle()
    stop_other()
    stop_other()
    stand.page.stage = stand.page
    click(click_at(0.2))
    assert heard == [met] and other == [met, met] and len(stand.clicks) == 1
    assert places == [(39.5, 49.5), (139.5, 49.5), (39.5, 49.5)]


def test_a_pick_has_what_the_cloud_knows_of_its_point():
    cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]], colors=[[0, 0, 0], [1, 0, 0]])
    cloud["intensity"] = np.array([5, 9], np.uint16)
    item = make_item("cloud", 0, cloud, Style())
    found = with_attributes(Pick("cloud", 1, cloud.points[1]), item)
    assert found.attributes["intensity"] == 9 and found.attributes["color"].tolist() == [1, 0, 0]
    assert {*found.attributes} == {"intensity", "color"}
    surface = Pick("mesh", None, np.zeros(3), 4)
    assert with_attributes(surface, None) is surface


class Clock:
    """Pages and a clock for calls with each frame, both moved by hand."""

    def __init__(self, monkeypatch):
        self.now, self.open, self.answers, self.told = 100.0, True, [], []
        monkeypatch.setattr(calls.time, "monotonic", lambda: self.now)
        monkeypatch.setattr(Calls, "_begin", lambda self: None)  # no thread: a turn is made by hand
        self.calls = Calls(self)

    def tell(self, client, text):
        self.told.append((client, text))

    def are_open(self):
        return self.open

    def ask_for_signs(self, answer):
        self.answers.append(answer)

    def turn(self, seconds):
        """What is done after so long."""
        self.now += seconds
        for beat in (beats := self.calls._due()):
            self.calls._call_beat(beat)
        if beats:
            self.calls._ask_for_signs()
        return len(beats)


@pytest.fixture
def clock(monkeypatch):
    return Clock(monkeypatch)


def test_a_frame_comes_at_most_so_often_and_tells_the_time_since_the_last(clock):
    heard = []
    stop = clock.calls.every(0.1, heard.append)
    for _ in range(100):
        clock.turn(0.01)
        if clock.answers:
            clock.answers.pop()()
    assert 9 <= len(heard) <= 11 and heard[0] == 0 and np.allclose(heard[1:], 0.1, atol=0.021)
    stop()
    assert clock.turn(1.0) == 0


def test_a_slow_page_is_waited_for_but_not_for_ever(clock):
    clock.calls.every(0.1, lambda seconds: None)
    assert clock.turn(0.2) == 1
    assert clock.turn(1.0) == 0  # it has not drawn the last one
    clock.answers.pop()()
    assert clock.turn(0.0) == 1
    assert clock.turn(calls.PATIENCE + 0.1) == 1  # it may be hidden behind another


def test_without_a_page_nothing_is_called_and_the_time_begins_anew(clock):
    heard = []
    clock.calls.every(0.1, heard.append)
    clock.turn(0.2)
    clock.open = False
    assert clock.turn(1.0) == 0
    clock.open = True
    clock.turn(1.0)
    assert heard == [0.0, 0.0]


def test_a_frame_that_raises_is_the_last_and_all_pages_are_told(clock, caplog):
    clock.calls.every(0.1, lambda seconds: 1 / 0)
    assert clock.turn(0.2) == 1 and clock.turn(10.0) == 0
    assert clock.told[0] == (None, "ZeroDivisionError: division by zero") and len(clock.told) == 2
    assert "division by zero" in caplog.text


def test_frames_run_in_the_thread_of_the_pages_until_the_end(stand):
    heard, enough = [], threading.Event()

    def count(seconds):
        heard.append(threading.current_thread())
        if len(heard) == 3:
            enough.set()

    stand.on_frame(count, 200)
    while not enough.wait(0.002):
        for listener in stand.page.listeners:
            listener(stand.page)
    assert len(stand.page.listeners) == 1 and stand.page.asked >= 2
    for thread in stand._end_hooks():
        thread.join()
    assert {*heard} - {threading.current_thread()} == {*heard} and not heard[0].is_alive()


class Told:
    """What a page is told, kept until it is looked for."""

    def __init__(self, line):
        self.line, self.ops = line, []

    def find(self, name, **fields):
        """The next operation of this name with these fields."""
        end = time.monotonic() + 30.0
        while time.monotonic() < end:
            for op in self.ops:
                if op["op"] == name and all(op.get(field) == value for field, value in fields.items()):
                    self.ops.remove(op)
                    return op
            self.ops += hear(self.line, 30.0)
        raise AssertionError(f"no {name} with {fields}")


def test_a_page_presses_slides_picks_and_is_told_what_went_wrong():
    points = np.array([[0.0, 0, 0], [2, 0, 0], [0, 2, 0], [1, 1, 0]])
    pressed, picks = [], []

    def press(page):
        pressed.append((page, slider.value))
        raise ValueError("that is the last scan")

    with loom.Viewer(port=0) as viewer:
        viewer.add("scan", loom.PointCloud(points))
        slider = viewer.add_slider("neighbours", 1, 9, 5)
        viewer.add_button("Next", press, hotkey="J")
        viewer.on_pick(picks.append)
        with line_of(viewer.server) as line:
            say(line, HELLO)
            told = Told(line)
            track = told.find("control", label="neighbours")
            key = told.find("command", hotkey="J")
            wait_until(lambda: viewer.sessions)
            (number,) = viewer.sessions
            say(line, {"say": "value", "id": track["id"], "value": 7})
            say(line, {"say": "value", "id": track["id"], "value": "many"})
            say(line, {"say": "command", "id": key["id"]})
            assert told.find("notify")["text"] == "ValueError: that is the last scan"
            assert pressed == [(number, 7)]
            for point in points[[1, 3]]:
                x, y, _ = project(viewer.get_view(number), point)
                say(line, {"say": "click", "x": (x + 0.5) / 800, "y": (y + 0.5) / 600, "shift": False, "ctrl": False})
            wait_until(lambda: len(picks) == 2)
    assert [(pick.name, pick.index) for pick in picks] == [("scan", 1), ("scan", 3)]
    assert np.allclose(picks[0].point, points[1])


def test_frames_come_as_a_page_takes_them_and_end_with_the_viewer():
    calls_of_frame = []
    with loom.Viewer(port=0) as viewer:
        viewer.on_frame(calls_of_frame.append, rate=100)
        with line_of(viewer.server) as line:
            say(line, HELLO)
            told = Told(line)
            for count in (1, 2, 3):
                sign = told.find("sign")
                assert len(calls_of_frame) <= count
                say(line, {"say": "sign", "n": sign["n"]})
            wait_until(lambda: len(calls_of_frame) >= 3)
            viewer.add_button("End", lambda page: viewer.close())
            button = told.find("control", label="End")
            say(line, {"say": "press", "id": button["id"]})
            wait_until(lambda: viewer.closed)


def test_a_key_of_the_program_begins_no_tool_any_more():
    heard = []
    with loom.Viewer(port=0) as viewer, line_of(viewer.server) as line:
        say(line, HELLO)
        told = Told(line)
        tool = told.find("command", hotkey="M")
        wait_until(lambda: viewer.sessions)
        viewer.on_key("m", heard.append)
        assert told.find("dropcommand")["id"] == tool["id"]
        say(line, {"say": "command", "id": told.find("command", hotkey="M")["id"]})
        wait_until(lambda: heard == [*viewer.sessions])
