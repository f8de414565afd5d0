"""`loom.draw`: its messages, when it waits, when a browser opens, and its hooks."""

import logging
import os
import queue
import signal
import socket
import subprocess
import sys
import threading
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import PointloomError
from pointloom.visualization.render.styles import Style
from pointloom.visualization.render.view import View
from pointloom.visualization.viewer import callback_queue
from pointloom.visualization.viewer import draw as drawing
from pointloom.visualization.viewer.callback_queue import Calls
from pointloom.visualization.viewer.client_presence import Presence
from pointloom.visualization.viewer.draw import draw_geometries
from pointloom.visualization.viewer.items import make_item
from pointloom.visualization.viewer.picks import with_attributes
from pointloom.visualization.viewer.tools.picking import Pick, project

from ...sigint import sigint_enabled
from .events import announce, join_threads, wait_until
from .pages import visitor_of
from .stand_in import page_in, toolbox_of

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def cloud(rng):
    return loom.PointCloud(rng.random((50, 3)))


@pytest.fixture(autouse=True)
def bare(monkeypatch):
    """No display, no SSH, no CI job, and a browser that starts where there is a display."""
    for name in ("SSH_CONNECTION", "CI", "POINTLOOM_DRAW", *drawing.DISPLAYS):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(drawing.webbrowser, "get", lambda: None)


def draw(*geometries, **options):
    return loom.draw(*geometries, **{"port": 0, "block": False, "open_browser": False} | options)


def test_draw_prints_the_page_address_on_stderr_only(cloud, capfd):
    with draw([cloud]) as viewer:
        out, err = capfd.readouterr()
    assert out == ""
    assert err == f"viewer: {viewer.url} (Ctrl-C ends it)\n"


def test_unattended_draw_is_an_image_and_does_not_wait(cloud, capfd, monkeypatch):
    monkeypatch.setenv("POINTLOOM_DRAW", "picture")
    monkeypatch.setattr(drawing.webbrowser, "open", lambda url: pytest.fail("a browser was opened"))
    still = draw_geometries([cloud], width=64, height=48, zoom=0.5, front=[0, 0, 1])
    drawn = loom.render(cloud, {"zoom": 0.5, "front": [0, 0, 1]}, (64, 48), mesh_show_back_face=False)
    assert np.array_equal(still, drawn)
    assert capfd.readouterr() == ("", "")
    with loom.draw(cloud, port=0, block=False) as viewer:  # a call that does not wait is a viewer as well
        assert list(viewer.items) == ["cloud"]
    monkeypatch.setenv("POINTLOOM_DRAW", "window")
    with pytest.raises(ValueError, match="POINTLOOM_DRAW:"):
        loom.draw(cloud)


def test_without_a_display_a_numbered_image_is_written(cloud, capfd, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    Path("pointloom-1.png").write_text("of the user")
    drawn = [loom.draw([cloud], 64, 48) for _ in range(2)]
    assert [path.name for path in sorted(tmp_path.iterdir())] == [f"pointloom-{k}.png" for k in (1, 2, 3)]
    assert Path("pointloom-1.png").read_text() == "of the user"
    assert all(np.array_equal(loom.read_color(f"pointloom-{k + 2}.png"), drawn[k]) for k in range(2))
    out, err = capfd.readouterr()
    assert out == "" and [str(tmp_path / f"pointloom-{k}.png") in err for k in (1, 2, 3)] == [False, True, True]


@pytest.mark.parametrize(
    ("system", "environment", "mode", "is_opened"),
    [
        ("linux", {}, "file", False),
        ("linux", {"DISPLAY": ":0"}, "page", True),
        ("linux", {"WAYLAND_DISPLAY": "wayland-0"}, "page", True),
        ("linux", {"BROWSER": "open-there"}, "page", True),
        ("linux", {"SSH_CONNECTION": "1 2 3 4"}, "page", False),
        ("linux", {"DISPLAY": ":0", "SSH_CONNECTION": "x"}, "page", False),
        ("linux", {"DISPLAY": ":0", "CI": "true"}, "file", False),
        ("linux", {"POINTLOOM_DRAW": "page"}, "page", False),
        ("linux", {"DISPLAY": ":0", "POINTLOOM_DRAW": "picture"}, "picture", True),
        ("darwin", {}, "page", True),
        ("darwin", {"SSH_CONNECTION": "x"}, "page", False),
        ("win32", {}, "page", True),
    ],
)
def test_a_page_is_served_and_opened_where_a_browser_can_show_it(monkeypatch, system, environment, mode, is_opened):
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(drawing, "sys", SimpleNamespace(platform=system))
    monkeypatch.setattr(drawing.webbrowser, "open", lambda url: url == "http://page")
    assert drawing.draw_mode() == mode
    assert drawing.open_page(SimpleNamespace(url="http://page")) is is_opened


def test_a_display_without_a_browser_is_none(monkeypatch):
    def refuse():
        raise drawing.webbrowser.Error

    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(drawing, "sys", SimpleNamespace(platform="linux"))
    monkeypatch.setattr(drawing.webbrowser, "get", refuse)
    assert drawing.draw_mode() == "file"


@pytest.mark.parametrize(("port", "option"), [(22, ""), (2222, "-p 2222 ")])
def test_draw_explains_ssh_forwarding(cloud, capfd, monkeypatch, port, option):
    monkeypatch.setenv("SSH_CONNECTION", f"10.0.0.1 50000 10.0.0.2 {port}")
    with draw([cloud]) as viewer:
        lines = capfd.readouterr().err.splitlines()
    assert len(lines) == 2
    assert f"ssh {option}-L {viewer.server.port}:127.0.0.1:{viewer.server.port} " in lines[1]
    assert lines[1].endswith("@10.0.0.2")


def test_a_port_in_use_is_reported_with_the_next_one(cloud, capfd):
    with socket.create_server(("127.0.0.1", 0)) as blocker:
        port = blocker.getsockname()[1]
        with draw([cloud], port=port) as viewer:
            first = capfd.readouterr().err.splitlines()[0]
    assert first == f"port {port} is in use; using the next free one, {viewer.server.port}"


def test_a_server_open_to_the_network_is_reported(cloud, capfd):
    with draw([cloud], host="0.0.0.0"):
        assert "anyone with this address and its token can see the scene" in capfd.readouterr().err


def test_open3d_s_parameters_count(cloud):
    mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    look = {"zoom": 0.5, "front": [0, 0, -1], "lookat": [0.5, 0.5, 0.5], "up": [0, -1, 0]}
    with draw([cloud, mesh], 640, 480, True, True, False, **look) as viewer:
        assert list(viewer.items) == ["cloud", "mesh"]
        assert viewer.scene.normals
        assert viewer.scene.wireframe
        assert viewer.items["mesh"].parts[0].cull
        expected = View.from_open3d(viewer.bounds, **look, width=640, height=480)
        assert np.allclose(viewer.home().T_world_camera, expected.T_world_camera)
        assert viewer.screenshot().shape == (480, 640, 3)
    with draw({"floor": mesh}, mesh_show_back_face=True) as viewer:
        assert not viewer.items["floor"].parts[0].cull
    with draw({"geometry": mesh, "name": "wall", "color": (1, 0, 0)}) as viewer:
        assert viewer.items["wall"].parts[0].plain == (1, 0, 0)


def test_nothing_to_draw_is_an_empty_page():
    with draw([]) as viewer:
        assert not viewer.items
        assert viewer.screenshot().min() == 255


@pytest.mark.parametrize(
    ("geometries", "options", "error"),
    [
        ([np.zeros((1, 3)), "scan.ply"], {}, TypeError),
        (np.zeros((1, 3)), {"width": 0}, ValueError),
        (np.zeros((1, 3)), {"zoom": -1}, ValueError),
        (np.zeros((1, 3)), {"port": 70_000}, ValueError),
        (np.zeros((1, 3)), {"keep_alive": -1}, ValueError),
        (np.zeros((1, 3)), {"host": "no.such.host.invalid"}, PointloomError),
    ],
)
def test_hostile_arguments_leave_no_server(geometries, options, error):
    before = set(threading.enumerate())
    with pytest.raises(error):
        draw(geometries, **options)
    join_threads(lambda thread: thread not in before)


def test_draw_waits_until_the_last_page_has_gone(cloud, monkeypatch):
    made, looks = queue.Queue(), []
    original_announce, is_over = drawing.announce, Presence._is_over
    monkeypatch.setattr(drawing, "announce", lambda viewer: (made.put(viewer), original_announce(viewer)))
    monkeypatch.setattr(Presence, "_is_over", lambda *args: looks.append(is_over(*args)) or looks[-1])
    announce(monkeypatch, Presence, "_is_over")
    thread = threading.Thread(target=lambda: draw([cloud], block=None, keep_alive=0), daemon=True)
    thread.start()
    viewer = made.get(timeout=60)
    with visitor_of(viewer.server):
        wait_until(lambda: viewer.sessions)
        looks.clear()
        wait_until(lambda: len(looks) > 1)
        assert thread.is_alive() and not any(looks)
    thread.join(60)
    assert viewer.closed


@pytest.mark.slow
def test_ctrl_c_ends_a_script_s_wait_and_the_script_goes_on(tmp_path):
    script = (
        "import sys, numpy as np, pointloom as loom\n"
        "from pointloom.visualization.viewer.client_presence import Presence\n"
        "look = Presence._is_over\n"
        "def first_look(*args):\n"
        "    Presence._is_over = look\n"
        "    print('waits', file=sys.stderr, flush=True)\n"
        "    return look(*args)\n"
        "Presence._is_over = first_look\n"
        "viewer = loom.draw(np.eye(3), port=0, open_browser=False)\n"
        "print('went on', viewer.closed, file=sys.stderr)\n"
    )
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src")}
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with sigint_enabled():
        process = subprocess.Popen([sys.executable, "-c", script], env=environment, **pipes)
    assert process.stderr is not None
    assert process.stderr.readline().startswith("viewer: http://127.0.0.1:")
    assert process.stderr.readline() == "waits\n"
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=300)
    assert (process.returncode, out, err) == (0, "", "went on True\n")


def test_a_browser_opens_where_there_is_a_display(cloud, monkeypatch):
    monkeypatch.setenv("DISPLAY", ":0")
    opened = []
    monkeypatch.setattr(drawing.webbrowser, "open", opened.append)
    with draw([cloud], open_browser=True) as viewer:
        assert opened == [viewer.url]
    with draw([cloud], open_browser=False):
        assert len(opened) == 1


def idle(viewer):
    """Wait until the program's functions have been called."""
    done = threading.Event()
    viewer.hooks.calls.call(None, done.set)
    assert done.wait(60)


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
    pick = with_attributes(Pick("cloud", 1, cloud.points[1]), make_item("cloud", 0, cloud, Style()))
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
    assert toolbox_of(viewer).tool is None and not viewer.scene.wireframe
    viewer.on_key("W", lambda number: events.clear())
    page.key("W")
    idle(viewer)
    assert events == []
