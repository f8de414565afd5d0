"""Messages of pages to the viewer's server, and pages that do not read."""

import json
import os
import socket
import threading
from contextlib import ExitStack

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from pointloom.visualization.viewer.link import hub
from pointloom.visualization.viewer.link.client import MAX_WAITING

from .events import announce, wait_until
from .hostile_pages import HOSTILE_VALUES, hostile_messages, near_messages
from .pages import CAMERA, client_of, count, hear, hear_until, is_well, line_of, page_of, send, silent_line


def move_to(line, fov: float) -> None:
    """A camera identified by its angle."""
    send(line, CAMERA | {"fov": fov})


def test_a_page_gets_the_scene_and_is_heard(server):
    server.pages.scene.add_points(np.zeros((5, 3), np.float32), plain=(255, 0, 0))
    slider = server.pages.gui.add_slider("size", 0.0, 10.0, 0.5, 5.0)
    with page_of(server) as line:
        assert hear_until(line, "node", kind="points")["plain"] == [255, 0, 0]
        send(line, {"say": "value", "id": slider.id, "value": 7})
        wait_until(lambda: slider.value == 7.0)
        camera = client_of(server).camera
        assert camera.position.tolist() == [0.0, 0.0, 3.0]
        assert camera.rotation.tolist() == np.diag([1.0, -1.0, -1.0]).tolist()
        assert (camera.fov, camera.size, camera.orthographic) == (1.0, (800, 600), False)


NO_MESSAGES = [
    b"", os.urandom(1000), "", "text", "{", "[]", "null", "7", '"say"', "{}", '{"say": 7}', '{"say": "sign", "n": NaN}',
    '{"say": "sign", "n": -Infinity}', "[" * 60_000, '{"say":' * 9000, json.dumps({"say": "x", "y": [[]] * 30_000}),
    '{"say": "value", "id": 1, "value": ' + "9" * 5000 + "}", b'{"say": "resume"}', "\0" * 1000,
]  # fmt: skip


def test_an_invalid_message_disconnects_only_its_sender(server):
    with page_of(server) as good:
        hear_until(good, "clear")
        for raw in NO_MESSAGES:
            with page_of(server) as evil:
                evil.send(raw)
                with pytest.raises(ConnectionClosed) as ended:
                    while True:
                        evil.recv(timeout=60)
            assert ended.value.rcvd.code == 1007, raw[:40]
            server.pages.scene.add_group()
            assert hear_until(good, "node")["kind"] == "group"
        wait_until(lambda: len(server.pages.get_clients()) == 1)


def test_a_message_beyond_the_limit_disconnects_its_sender(server):
    with page_of(server) as evil:
        with pytest.raises(ConnectionClosed) as ended:
            evil.send('{"say": "file", "text": "' + "x" * (2 << 20))
            while True:
                evil.recv(timeout=60)
        assert ended.value.rcvd.code == 1009
    assert is_well(server)


@pytest.mark.parametrize("first", [CAMERA, {"say": "sign", "n": 1}, {"say": "hello"}], ids=["camera", "sign", "half"])
def test_a_page_sends_hello_first(server, first):
    with line_of(server) as line:
        send(line, first)
        with pytest.raises(ConnectionClosed):
            line.recv(timeout=60)
    assert server.pages.get_clients() == {}


BAD_CAMERAS = [
    {"size": [70_000, 600]}, {"size": [0, 600]}, {"size": [800.5, 600]}, {"size": [800]}, {"fov": 0}, {"fov": -1},
    {"fov": 5e-324}, {"fov": 3.14159265},
    {"fov": 4}, {"fov": True}, {"position": [1e300, 0, 0]}, {"position": [0, 0]}, {"position": [None, 0, 0]},
    {"rotation": [0] * 9}, {"rotation": [1] * 9}, {"rotation": [1, 0, 0, 0, 1, 0, 0, 0, -1]},
    {"rotation": [1.1, 0, 0, 0, 1, 0, 0, 0, 1]}, {"rotation": [1e308] * 9}, {"rotation": [[1, 0, 0]] * 3},
    {"pivot": "abc"}, {"orthographic": 1}, {"position": [10**400, 0, 0]},
]  # fmt: skip


def test_invalid_cameras_are_ignored_and_the_last_valid_one_remains(server):
    slider = server.pages.gui.add_slider("then", 0, len(BAD_CAMERAS), 1, 0)
    with page_of(server) as evil:
        for number, bad in enumerate(BAD_CAMERAS, 1):
            send(evil, CAMERA | {"fov": 0.5} | bad)
            send(evil, {key: value for key, value in CAMERA.items() if key not in bad})
            send(evil, {"say": "value", "id": slider.id, "value": number})
            wait_until(lambda number=number: slider.value == number)
            assert client_of(server).camera.fov == CAMERA["fov"], bad
            assert client_of(server).camera.position.tolist() == CAMERA["position"], bad


def test_a_rotation_that_is_one_up_to_rounding_is_made_exact(server):
    rounded = np.diag([1.0, -1.0, -1.0]) + 3e-4 * np.arange(9).reshape(3, 3) / 9
    with page_of(server) as line:
        send(line, CAMERA | {"fov": 0.5, "rotation": rounded.ravel().tolist()})
        camera = client_of(server).camera
        wait_until(lambda: camera.fov == 0.5)
        assert np.abs(camera.rotation @ camera.rotation.T - np.eye(3)).max() < 1e-14
        assert np.abs(camera.rotation - rounded).max() < 1e-3


def test_hostile_messages_are_not_passed_to_the_program(server):
    """Each field of each message with wrong types, ranges and sizes, while threads of the program use the page."""
    gui, scene, failures, done = server.pages.gui, server.pages.scene, [], threading.Event()
    handles = [
        gui.add_slider("slider", 0, 10, 1, 5), gui.add_range("range", 0, 1, 0.1, (0.2, 0.8)), gui.add_text("text", "x"),
        gui.add_dropdown("dropdown", ("a", "b")), gui.add_rgb("rgb", (1, 2, 3)), gui.add_checkbox("checkbox", True),
        gui.add_number("number", 3), gui.add_button("button"),
        gui.add_upload_button("upload"), gui.add_tree(), gui.add_timeline(0, 9, 1, 0), gui.add_command("command", "R"),
        gui.add_words("words"),
    ]  # fmt: skip
    handles[9].put("a", "A", True)
    scene.on_click(lambda event: None)

    def work() -> None:
        while not done.wait(0.002):
            try:
                node = scene.add_points(np.zeros((10, 3), np.float32))
                for client in server.pages.get_clients().values():
                    state = client.camera.state
                    assert 0 < state.fov < np.pi and abs(np.linalg.det(state.rotation) - 1) < 1e-12
                    client.camera.put(position=state.position, rotation=state.rotation, fov=state.fov)
                    client.notify("a", "b")
                node.remove()
                assert 0 <= handles[0].value <= 10 and handles[1].value[0] <= handles[1].value[1]
            except Exception as error:
                failures.append(error)

    worker = threading.Thread(target=work)
    worker.start()
    try:
        with page_of(server) as evil:
            ids = [handle.id for handle in handles]
            for message in (*hostile_messages(ids), *near_messages(ids, 300)):
                evil.send(message)
            move_to(evil, 0.5)
            wait_until(lambda: client_of(server).camera.fov == 0.5)  # the same connection still works
    finally:
        done.set()
        worker.join()
    assert failures == []
    assert is_well(server)


def test_a_page_sets_the_value_of_a_control_and_nothing_else_of_it(server):
    values = []
    gui = server.pages.gui
    slider, color = gui.add_slider("size", 0.0, 10.0, 0.5, 5.0), gui.add_dropdown("color", ("height", "rgb"), "rgb")
    span, words = gui.add_range("span", 0, 1, 0.1, (0.2, 0.8)), gui.add_words("ours")
    slider.on_update(lambda event: values.append(event.value))
    with page_of(server) as line:

        def set_to(handle, value) -> None:
            send(line, {"say": "value", "id": handle.id, "value": value})

        for value in HOSTILE_VALUES:
            if isinstance(value, bool) or not isinstance(value, int | float):
                set_to(slider, value)
        set_to(color, "__class__")
        set_to(span, [0.9, 0.1])
        set_to(words, "theirs")
        set_to(slider, 1e300)
        wait_until(lambda: values != [])
        assert (values, slider.value, color.value, span.value, words.value) == ([10.0], 10.0, "rgb", (0.2, 0.8), "ours")
        set_to(color, "height")
        set_to(span, [0.1, 2])
        wait_until(lambda: span.value == (0.1, 1.0))
        assert color.value == "height"


def test_a_control_that_is_off_is_not_set(server):
    button, slider = server.pages.gui.add_button("go", disabled=True), server.pages.gui.add_slider("s", 0, 9, 1, 0)
    pressed = []
    button.on_click(pressed.append)
    with page_of(server) as line:
        send(line, {"say": "press", "id": button.id})
        send(line, {"say": "value", "id": slider.id, "value": 3})
        wait_until(lambda: slider.value == 3)
        assert pressed == []


def test_other_pages_see_a_change_and_its_sender_only_corrections(server):
    slider = server.pages.gui.add_slider("size", 0, 10, 1, 5)
    tree = server.pages.gui.add_tree()
    tree.put("a", "A", True)
    with page_of(server) as first, page_of(server) as second:
        for line in (first, second):
            hear_until(line, "rows")
        send(first, {"say": "value", "id": slider.id, "value": 7})
        assert hear_until(second, "setcontrol")["value"] == 7
        send(first, {"say": "value", "id": tree.id, "value": [["a", "gone"], False]})
        assert hear_until(second, "rows")["put"] == [["a", "A", False, None]]
        send(first, {"say": "value", "id": slider.id, "value": 70})
        assert [hear(line)[0]["value"] for line in (first, second)] == [10, 10]


def test_a_sync_is_acknowledged_after_all_earlier_effects(server):
    button, go_on = server.pages.gui.add_button("press"), threading.Event()
    button.on_click(lambda event: go_on.wait(60) and server.pages.scene.add_group())
    with page_of(server) as line:
        send(line, {"say": "press", "id": button.id})
        send(line, {"say": "sync", "n": 7})
        for wrong in ({}, {"n": 0}, {"n": "7"}):
            send(line, {"say": "sync"} | wrong)
        go_on.set()
        operations: list[str] = []
        while "sync" not in operations:
            operations += [f"{op['op']}" for op in hear(line)]
        assert operations.index("node") < operations.index("sync")
        send(line, {"say": "sync", "n": 8})
        assert hear_until(line, "sync")["n"] == 8


def test_a_file_is_received_completely(server):
    button, loaded = server.pages.gui.add_upload_button("Load"), []
    button.on_upload(lambda event: loaded.append((event.value.name, event.value.content)))
    with page_of(server) as line:
        send(line, {"say": "file", "id": button.id, "name": "view.json", "text": "ü" * 100_000})
        wait_until(lambda: loaded == [("view.json", "ü".encode() * 100_000)])


def test_a_click_reports_its_position_and_camera(server):
    clicks = []
    with page_of(server) as line:
        server.pages.scene.on_click(clicks.append)
        assert hear_until(line, "clicks")["on"] is True
        send(line, {"say": "click", "x": 0.25, "y": 0.5})
        move_to(line, 0.5)
        wait_until(lambda: len(clicks) == 1)
        (event,) = clicks
        assert (event.x, event.y, event.camera.fov) == (0.25, 0.5, 1.0)
        server.pages.scene.remove_click_callback(clicks.append)
        server.pages.scene._on_click.clear()


def test_a_callback_that_fails_is_logged_and_not_printed(server, caplog):
    server.pages.on_client_connect(lambda client: 1 / 0)
    with page_of(server):
        wait_until(lambda: "a callback of the viewer failed" in caplog.text)
    assert "ZeroDivisionError" in caplog.text


def test_a_page_that_sends_continuously_does_not_delay_others(server):
    slow = threading.Event()
    presses = []
    button = server.pages.gui.add_button("press")
    button.on_click(lambda event: (presses.append(1), slow.wait(60)))
    with page_of(server) as evil:

        def flood() -> None:
            try:
                for _ in range(20_000):
                    send(evil, {"say": "press", "id": button.id})
            except ConnectionClosed:
                pass

        thread = threading.Thread(target=flood)
        thread.start()
        wait_until(lambda: presses != [])
        assert is_well(server)
        slow.set()
        wait_until(lambda: len(presses) > MAX_WAITING)
        server.close()
        thread.join(60)
        assert not thread.is_alive()


def test_two_hundred_connections_are_limited_without_affecting_others(server):
    refused, silent = 0, [socket.create_connection(("127.0.0.1", server.port)) for _ in range(100)]
    with page_of(server) as first, ExitStack() as stack:
        hear_until(first, "clear")
        for _ in range(200):
            try:
                stack.enter_context(line_of(server))
            except InvalidStatus as error:
                assert error.response.status_code == 503
                refused += 1
        assert refused == 200 - (hub.MAX_CLIENTS - 1)
        server.pages.scene.add_group()
        assert hear_until(first, "node")["kind"] == "group"
    wait_until(lambda: count(server) == 0)
    assert is_well(server)
    for line in silent:
        line.close()


@pytest.fixture
def impatient(monkeypatch):
    monkeypatch.setattr(hub, "STALL_SECONDS", 1.0)
    monkeypatch.setattr(hub, "WATCH_SECONDS", 0.1)
    monkeypatch.setattr(hub, "PING_SECONDS", 0.2)


def test_a_page_that_does_not_read_is_dropped_and_others_are_served(server, impatient):
    server.pages.scene.add_points(np.zeros((500_000, 3), np.float32), plain=(255, 0, 0))
    line = silent_line(server)
    with page_of(server) as good:
        wait_until(lambda: count(server) == 2)
        assert len(hear_until(good, "node")["positions"]) == 500_000
        wait_until(lambda: count(server) == 1)
        server.pages.scene.add_group()
        assert hear_until(good, "node")["kind"] == "group"
    line.close()


def test_a_slow_page_stays_connected(server, impatient, monkeypatch):
    looks, unsent = [], hub._unsent_bytes
    monkeypatch.setattr(hub, "_unsent_bytes", lambda line: looks.append(line) or unsent(line))
    announce(monkeypatch, hub, "_unsent_bytes")
    server.pages.scene.add_points(np.zeros((3_000_000, 3), np.float32), plain=(255, 0, 0))
    with silent_line(server, buffer=1 << 20) as line:
        wait_until(lambda: count(server) == 1)
        read = 0
        for look in range(1, 2 * round(hub.STALL_SECONDS / hub.WATCH_SECONDS)):
            wait_until(lambda look=look: len(looks) > look or count(server) == 0)
            for _ in range(5):
                read += len(line.recv(100_000))
        assert count(server) == 1
        assert 500_000 < read < 35_000_000  # the page was never idle


def test_a_page_that_answers_no_ping_is_dropped(server, impatient):
    with silent_line(server):
        wait_until(lambda: count(server) == 1)
        wait_until(lambda: count(server) == 0)


def test_the_queue_of_a_page_is_bounded(server, monkeypatch):
    monkeypatch.setattr(hub, "MAX_OWN_BYTES", 20_000_000)
    monkeypatch.setattr(hub, "WATCH_SECONDS", 0.1)
    with page_of(server, max_queue=1):  # it stops reading at the first unread message
        client = client_of(server)
        points = np.zeros((200_000, 3), np.float32)

        def is_dropped_as_more_comes() -> bool:
            client.scene.add_points(points)
            return count(server) == 0

        wait_until(is_dropped_as_more_comes)
        wait_until(lambda: not client.is_open)


def test_updates_of_a_page_that_reads_nothing_take_no_more_than_one(server):
    points = np.zeros((200_000, 3), np.float32)
    points.flags.writeable = False
    with page_of(server, max_queue=1) as line:
        client = client_of(server)
        node = client.scene.add_points(points)
        for step in range(100):
            node.set(positions=points, size=1 + step)
            node.set_transform(None, (step, 0, 0))
        assert client._channel.delivery._outboxes[client._channel][0].own_bytes <= 2 * points.nbytes
        message = hear_until(line, "node", kind="points")
        while message.get("size") != 100:
            message = hear(line)[0]
        assert message["pose"][3] == 99


def test_a_page_that_leaves_during_a_transfer_causes_no_warning(server):
    with page_of(server):
        client = client_of(server)
    wait_until(lambda: count(server) == 0)
    node = client.scene.add_points(np.zeros((5, 3), np.float32))  # a warning fails the test
    node.visible = False
    node.remove()
    client.gui.add_button("late").remove()
    client.camera.put(fov=1.0)
    client.notify("late", "late")
    assert not client.is_open
