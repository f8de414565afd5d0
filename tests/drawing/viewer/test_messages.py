"""What pages say to the viewer's server, and pages that do not listen."""

from __future__ import annotations

import itertools
import os
import random
import socket
import threading
import time
from contextlib import ExitStack

import numpy as np
import pytest
from viser import _messages
from websockets.exceptions import ConnectionClosed, InvalidStatus

from pointloom.drawing.viewer import hub
from pointloom.drawing.viewer.camera import Camera, set_camera

from .pages import CAMERA, count, hear, hear_until, is_well, page_of, say, silent_line, wait_until

# -- messages ---------------------------------------------------------------------------------------------------------


def test_a_page_gets_the_scene_and_is_heard(server):
    server.viser.scene.add_point_cloud("/cloud", np.zeros((5, 3), np.float32), (255, 0, 0))
    slider = server.viser.gui.add_slider("size", min=0.0, max=10.0, step=0.5, initial_value=5.0)
    with page_of(server) as line:
        assert hear_until(line, "PointCloudMessage")["name"] == "/cloud"
        say(line, {"type": "GuiUpdateMessage", "uuid": slider._impl.uuid, "updates": {"value": 7}})
        wait_until(lambda: slider.value == 7.0)
        (client,) = server.viser.get_clients().values()
        assert client.camera.position.tolist() == [0.0, 0.0, 3.0]


@pytest.mark.parametrize(
    "raw",
    [b"", b"\xc1", os.urandom(1000), b"\xdd\xff\xff\xff\xff", b"\x91" * 100_000, bytes(2_000_000), "text", b"\x80",
    b"\x2a"],
    ids=lambda raw: f"{len(raw)} bytes",
)  # fmt: skip
def test_garbage_ends_who_sends_it_and_nobody_else(server, raw):
    with page_of(server) as good, page_of(server) as evil:
        hear_until(good, "ReplayDoneMessage")
        evil.send(raw)
        with pytest.raises(ConnectionClosed) as ended:
            while True:
                evil.recv(timeout=5)
        assert ended.value.rcvd.code == 1007
        server.viser.scene.add_frame("/frame")
        assert hear_until(good, "FrameMessage")["name"] == "/frame"
        wait_until(lambda: len(server.viser.get_clients()) == 1)


def test_a_message_beyond_the_limit_ends_who_sends_it(server):
    with page_of(server) as evil:
        with pytest.raises(ConnectionClosed) as ended:
            evil.send(bytes(9 << 20))
            while True:
                evil.recv(timeout=5)
        assert ended.value.rcvd.code == 1009
    assert is_well(server)


def hostile_messages() -> list[dict]:
    """Well-formed msgpack that no page of ours would send."""
    nowhere = "no-such-uuid"
    kinds = [
        {"type": "NoSuchMessage"}, {"type": "Message"}, {"type": "__class__"}, {"type": ""},
        {"type": "ShareUrlRequest"}, {"type": "ShareUrlDisconnect"}, {"type": "GuiCloseModalMessage", "uuid": nowhere},
        {"type": "ResetSceneMessage"}, {"type": "RunJavascriptMessage", "source": "alert(1)"},
        {"type": "SceneNodeUpdateMessage", "name": "/", "updates": {}},
        {"type": "GuiUpdateMessage", "uuid": nowhere, "updates": {"value": 1}},
        {"type": "GuiUpdateMessage", "uuid": 7, "updates": 7}, {"type": "GuiUpdateMessage"},
        {"type": "GuiFormSubmitMessage", "uuid": nowhere},
        {"type": "GuiButtonHoldMessage", "uuid": nowhere, "frequency": 1e308},
        {"type": "CommandTriggerMessage", "uuid": nowhere},
        {"type": "SceneNodeClickMessage", "name": "/no", "instance_index": -1, "ray_origin": [0, 0, 0],
         "ray_direction": [0, 0, 0],
         "screen_pos": [0, 0], "modifier": None},
        {"type": "ScenePointerMessage", "event_type": "click", "ray_origin": None, "ray_direction": None,
         "screen_pos": [],
         "modifier": None},
        {"type": "TransformControlsUpdateMessage", "name": "/no", "wxyz": [0, 0, 0, 0], "position": [1e308, 0, 0]},
        {"type": "FileTransferStartUpload", "source_component_uuid": nowhere, "transfer_uuid": "t",
         "filename": "../../etc/passwd",
         "mime_type": "", "part_count": 2**40, "size_bytes": 2**60},
        {"type": "FileTransferPart", "source_component_uuid": None, "transfer_uuid": "t", "part_index": -1,
         "content": b"x" * 500_000},
        {"type": "GetRenderResponseMessage", "payload": b"no picture", "render_uuid": nowhere},
        {"type": "GuiModalMessage"},
    ]  # fmt: skip
    cameras = [
        ("wxyz", [1, 0, 0]), ("position", "abc"), ("fov", None), ("fov", float("nan")), ("image_height", -(2**60)),
        ("look_at", [[0]] * 3), ("wxyz", [0, 0, 0, 0]), ("near", []), ("up_direction", {}), ("far", 1e308),
        ("extra", 1),
    ]  # fmt: skip
    return kinds + [CAMERA | {field: value} for field, value in cameras]


def test_messages_that_make_no_sense_are_passed_over(server):
    heard = []
    with page_of(server) as evil:
        (client,) = server.viser.get_clients().values()

        @client.camera.on_update
        async def _(camera) -> None:
            heard.append(camera.position.tolist())

        for message in hostile_messages():
            say(evil, message)
        say(evil, CAMERA | {"position": [7, 7, 7]})
        wait_until(lambda: [7.0, 7.0, 7.0] in heard)  # the same line is still heard
        assert server.viser._share_tunnel is None
        assert client.camera.fov == 1.0
    assert is_well(server)


def test_random_fields_of_every_kind_of_message_are_survived(server):
    import dataclasses

    picker = random.Random(0)
    values = [
        None,
        -1,
        2**63,
        1e308,
        float("nan"),
        "",
        "/",
        b"",
        [],
        [1] * 4,
        {},
        {"value": []},
        True,
        "x" * 1000,
        [[], {}],
    ]
    kinds = _messages.Message._subclass_from_type_string()
    server.viser.gui.add_text("text", "x")
    server.viser.scene.on_click()(lambda _: None)
    with page_of(server) as evil:
        for name, kind in kinds.items():
            fields = [field.name for field in dataclasses.fields(kind)] if dataclasses.is_dataclass(kind) else []
            for _ in range(4):
                say(evil, {"type": name} | {field: picker.choice(values) for field in fields})
        say(evil, CAMERA | {"fov": 0.5})
        (client,) = server.viser.get_clients().values()
        wait_until(lambda: client.camera.fov == 0.5)
    assert is_well(server)


def test_a_page_sets_the_value_of_a_control_and_nothing_else_of_it(server):
    seen = []
    slider = server.viser.gui.add_slider("size", min=0.0, max=10.0, step=0.5, initial_value=5.0)
    color = server.viser.gui.add_dropdown("colour", ("height", "rgb"), initial_value="rgb")
    slider.on_update(lambda _: seen.append(slider.value))
    with page_of(server) as line:

        def set_to(handle, **updates) -> None:
            say(line, {"type": "GuiUpdateMessage", "uuid": handle._impl.uuid, "updates": updates})

        for updates in (
            {"update_cb": []},
            {"removed": True},
            {"value": "9"},
            {"value": None},
            {"value": [9]},
            {},
            {"is_button": 1},
        ):
            set_to(slider, **updates)
        set_to(color, value="__class__")
        set_to(slider, value=float("nan"))
        set_to(slider, value=1e300)
        wait_until(lambda: seen != [])
        assert (seen, slider.value, color.value) == ([10.0], 10.0, "rgb")
        assert len(slider._impl.update_cb) == 1 and not slider._impl.removed
        set_to(color, value="height")
        wait_until(lambda: color.value == "height")


def test_a_file_is_taken_whole_and_none_beyond_the_bounds(server):
    button = server.viser.gui.add_upload_button("Load")
    loaded = []
    button.on_upload(lambda event: loaded.append(event.target.value.content))
    start = {"type": "FileTransferStartUpload", "source_component_uuid": button._impl.uuid, "filename": "view.json"}
    start |= {"mime_type": "application/json", "part_count": 1}
    part = {"type": "FileTransferPart", "source_component_uuid": button._impl.uuid, "part_index": 0}
    uploads = server.viser.gui._current_file_upload_states
    with page_of(server) as line:
        say(line, start | {"transfer_uuid": "huge", "size_bytes": 1 << 40})
        say(line, start | {"transfer_uuid": "liar", "size_bytes": 10})
        say(line, part | {"transfer_uuid": "liar", "content": bytes(11)})
        for k in range(100):
            say(line, start | {"transfer_uuid": f"{k}", "size_bytes": 600_000})
        say(line, part | {"transfer_uuid": "0", "content": bytes(600_000)})
        wait_until(lambda: loaded == [bytes(600_000)])
        assert set(uploads) == {"liar", "1", "2"}
        assert uploads["liar"]["transferred_bytes"] == 0
    wait_until(lambda: not uploads)


def test_a_callback_that_fails_is_logged_and_not_printed(server, caplog):
    server.viser.on_client_connect(lambda client: 1 / 0)
    with page_of(server):
        wait_until(lambda: "a callback of the viewer failed" in caplog.text)
    assert "ZeroDivisionError" in caplog.text


def test_no_tunnel_can_be_opened(server):
    with pytest.raises(RuntimeError, match="ssh -L"):
        server.viser.request_share_url()
    heard = []
    for kind in (_messages.ShareUrlRequest, _messages.ShareUrlDisconnect):  # even if somebody listened
        server.viser._websock_server.register_handler(kind, lambda *_: heard.append(1))
    with page_of(server) as line:
        assert hear_until(line, "ThemeConfigurationMessage")["show_share_button"] is False
        say(line, {"type": "ShareUrlRequest"})
        say(line, {"type": "ShareUrlDisconnect"})
        say(line, CAMERA | {"fov": 0.5})
        (client,) = server.viser.get_clients().values()
        wait_until(lambda: client.camera.fov == 0.5)
    assert heard == []


def test_a_page_that_talks_without_end_waits_and_others_do_not(server):
    server.viser.on_client_connect(lambda client: client.camera.on_update(lambda _: time.sleep(0.01)) and None)
    with page_of(server) as evil:
        wait_until(lambda: all(client.camera._state.camera_cb for client in server.viser.get_clients().values()))

        def flood() -> None:
            try:
                for k in range(20_000):
                    say(evil, CAMERA | {"fov": 0.5 + k * 1e-6})
            except ConnectionClosed:
                pass

        thread = threading.Thread(target=flood)
        thread.start()
        assert is_well(server)
        queue = server.viser._thread_executor._work_queue
        assert queue.qsize() <= hub.MOST_CALLBACKS + hub.MOST_IN_WORK
        server.close()
        thread.join(5)
        assert not thread.is_alive()


# -- many pages, and pages that do not read ---------------------------------------------------------------------------


def test_two_hundred_at_once_are_too_many_for_nobody_but_themselves(server):
    refused = 0
    with page_of(server) as first, ExitStack() as stack:
        hear_until(first, "ReplayDoneMessage")
        for _ in range(200):
            try:
                stack.enter_context(page_of(server, camera=False))
            except InvalidStatus as error:
                assert error.response.status_code == 503
                refused += 1
        assert refused == 200 - (hub.MOST_CLIENTS - 1)
        server.viser.scene.add_frame("/frame")
        assert hear_until(first, "FrameMessage")["name"] == "/frame"
    wait_until(lambda: server.viser._websock_server._client_count == 0)  # type: ignore[attr-defined]
    assert is_well(server)


def test_two_hundred_open_lines_that_say_nothing_do_not_keep_a_page_out(server):
    lines = [socket.create_connection(("127.0.0.1", server.port)) for _ in range(200)]
    assert is_well(server)
    for line in lines:
        line.close()


@pytest.fixture
def impatient(monkeypatch):
    monkeypatch.setattr(hub, "STALL_SECONDS", 1.0)
    monkeypatch.setattr(hub, "WATCH_SECONDS", 0.1)
    monkeypatch.setattr(hub, "PING_SECONDS", 0.2)


def test_a_page_that_does_not_read_is_dropped_and_others_are_served(server, impatient):
    server.viser.scene.add_point_cloud("/large", np.zeros((500_000, 3), np.float32), (255, 0, 0))
    line = silent_line(server)
    with page_of(server) as good:
        wait_until(lambda: count(server) == 2)
        assert hear_until(good, "PointCloudMessage")["name"] == "/large"
        wait_until(lambda: count(server) == 1, 8)
        server.viser.scene.add_frame("/frame")
        assert hear_until(good, "FrameMessage")
    line.close()


def test_a_page_that_reads_slowly_but_reads_is_kept(server, impatient):
    server.viser.scene.add_point_cloud("/large", np.zeros((3_000_000, 3), np.float32), (255, 0, 0))
    with silent_line(server, buffer=1 << 20) as line:
        wait_until(lambda: count(server) == 1)
        read, end = 0, time.monotonic() + 2
        while time.monotonic() < end:
            read += len(line.recv(100_000))
            time.sleep(0.05)
        assert count(server) == 1
        assert 500_000 < read < 15_000_000  # there was more to come all the time


def test_a_page_that_answers_no_ping_is_dropped(server, impatient):
    with silent_line(server):
        wait_until(lambda: count(server) == 1)
        wait_until(lambda: count(server) == 0, 8)


def test_what_waits_for_one_page_is_bounded(server, monkeypatch):
    monkeypatch.setattr(hub, "MOST_UNREAD_BYTES", 20_000_000)
    with page_of(server, max_queue=1):  # it stops reading with the first message that nobody takes
        (client,) = server.viser.get_clients().values()
        points = np.random.default_rng(0).random((200_000, 3), np.float32)  # zeros would be sent as a few bytes
        names = itertools.count()

        def is_dropped_as_more_comes() -> bool:
            client.scene.add_point_cloud(f"/{next(names)}", points, (1, 2, 3), precision="float32")
            return count(server) == 0

        wait_until(is_dropped_as_more_comes, 20)


def test_a_page_that_goes_while_something_is_sent_to_it_warns_nobody(server):
    with page_of(server):
        (client,) = server.viser.get_clients().values()
    wait_until(lambda: count(server) == 0)
    client.scene.add_point_cloud("/late", np.zeros((5, 3), np.float32), (255, 0, 0))  # a warning fails the test


def test_a_camera_is_sent_whole_whatever_the_page_is_believed_to_show(server):
    """A page's last word may be older than what was sent to it: what equals it is not to be left out."""
    with page_of(server) as line:
        (client,) = server.viser.get_clients().values()
        found = client.camera  # where the page said that it is
        camera = Camera(found.position, found.look_at, found.up_direction, found.fov)
        set_camera(client, camera)
        heard: set[str] = set()
        while len(heard) < 4:
            heard |= {message["type"] for message in hear(line) if message["type"].startswith("SetCamera")}
        parts = ("Position", "LookAt", "UpDirection", "Fov")
        assert heard == {f"SetCamera{part}Message" for part in parts}
