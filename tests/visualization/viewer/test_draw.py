"""`loom.draw`: its messages, when it waits, and when a browser opens."""

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
from pointloom.visualization.render.view import View
from pointloom.visualization.viewer import draw as drawing
from pointloom.visualization.viewer.client_presence import Presence
from pointloom.visualization.viewer.draw import draw_geometries

from .events import announce, join_threads, wait_until
from .pages import visitor_of

ROOT = Path(__file__).resolve().parents[3]
UTM = np.array([500_000.0, 5_600_000.0, 300.0])


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
    ("environment", "mode"),
    [
        ({}, "file"),
        ({"DISPLAY": ":0"}, "page"),
        ({"BROWSER": "open-there"}, "page"),
        ({"SSH_CONNECTION": "1 2 3 4"}, "page"),
        ({"DISPLAY": ":0", "CI": "true"}, "file"),
        ({"POINTLOOM_DRAW": "page"}, "page"),
        ({"DISPLAY": ":0", "POINTLOOM_DRAW": "picture"}, "picture"),
    ],
)
def test_a_page_is_served_where_a_browser_can_show_it(monkeypatch, environment, mode):
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(drawing, "sys", SimpleNamespace(platform="linux"))
    assert drawing.draw_mode() == mode


def test_a_display_without_a_browser_is_none(monkeypatch):
    def refuse():
        raise drawing.webbrowser.Error

    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(drawing, "sys", SimpleNamespace(platform="linux"))
    monkeypatch.setattr(drawing.webbrowser, "get", refuse)
    assert drawing.draw_mode() == "file"


def test_draw_explains_ssh_forwarding(cloud, capfd, monkeypatch):
    monkeypatch.setenv("SSH_CONNECTION", "10.0.0.1 50000 10.0.0.2 22")
    with draw([cloud]) as viewer:
        lines = capfd.readouterr().err.splitlines()
    assert len(lines) == 2
    assert f"ssh -L {viewer.server.port}:127.0.0.1:{viewer.server.port} " in lines[1]
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
        assert viewer.normals
        assert viewer.wireframe
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
        "import signal, sys, numpy as np, pointloom as loom\n"
        "from pointloom.visualization.viewer.client_presence import Presence\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # a background job of a script ignores it
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
    process = subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment
    )
    assert process.stderr is not None
    assert process.stderr.readline().startswith("viewer: http://127.0.0.1:")
    assert process.stderr.readline() == "waits\n"
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=300)
    assert (process.returncode, out, err) == (0, "", "went on True\n")


@pytest.mark.parametrize(
    ("environment", "opens"),
    [({}, False), ({"DISPLAY": ":0"}, True), ({"DISPLAY": ":0", "SSH_CONNECTION": "1 2 3 4"}, False)],
)
def test_a_browser_opens_where_there_is_a_display(cloud, monkeypatch, environment, opens):
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    opened = []
    monkeypatch.setattr(drawing.webbrowser, "open", opened.append)
    with draw([cloud], open_browser=True) as viewer:
        assert opened == [viewer.url] * opens
    with draw([cloud], open_browser=False):
        assert len(opened) == opens


@pytest.mark.parametrize(
    ("system", "environment", "is_opened"),
    [
        ("linux", {}, False),
        ("linux", {"DISPLAY": ":0"}, True),
        ("linux", {"WAYLAND_DISPLAY": "wayland-0"}, True),
        ("linux", {"DISPLAY": ":0", "SSH_CONNECTION": "x"}, False),
        ("darwin", {}, True),
        ("darwin", {"SSH_CONNECTION": "x"}, False),
        ("win32", {}, True),
    ],
)
def test_a_browser_is_started_where_there_is_a_screen(system, environment, is_opened, monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SSH_CONNECTION"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(drawing, "sys", SimpleNamespace(platform=system))
    monkeypatch.setattr(drawing.webbrowser, "open", lambda url: url == "http://page")
    assert drawing.open_page(SimpleNamespace(url="http://page")) is is_opened
