"""Messages of pages to the viewer's server, pages that do not read, and batches of messages to pages."""

import json
import os
import socket
import threading
from contextlib import ExitStack

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from pointloom.visualization.viewer.link import hub
from pointloom.visualization.viewer.link.camera import FIRST_STATE
from pointloom.visualization.viewer.link.client import MAX_WAITING, PageClient, Worker
from pointloom.visualization.viewer.link.delivery import Channel, Delivery
from pointloom.visualization.viewer.link.gui import Gui
from pointloom.visualization.viewer.link.packing import MAX_FRAME_BYTES, pack
from pointloom.visualization.viewer.link.scene import Scene

from .events import announce, wait_until
from .hostile_pages import HOSTILE_VALUES, hostile_messages, near_messages
from .pages import CAMERA, client_of, hear, hear_until, is_well, line_of, page_of, send, silent_line, unpack


def move_to(line, fov: float) -> None:
    """A camera identified by its angle."""
    send(line, CAMERA | {"fov": fov})


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


@pytest.mark.slow
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
    wait_until(lambda: server.pages.client_count == 0)
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
        wait_until(lambda: server.pages.client_count == 2)
        assert len(hear_until(good, "node")["positions"]) == 500_000
        wait_until(lambda: server.pages.client_count == 1)
        server.pages.scene.add_group()
        assert hear_until(good, "node")["kind"] == "group"
    line.close()


def test_a_slow_page_stays_connected(server, impatient, monkeypatch):
    looks, unsent = [], hub._unsent_bytes
    monkeypatch.setattr(hub, "_unsent_bytes", lambda line: looks.append(line) or unsent(line))
    announce(monkeypatch, hub, "_unsent_bytes")
    server.pages.scene.add_points(np.zeros((3_000_000, 3), np.float32), plain=(255, 0, 0))
    with silent_line(server, buffer=1 << 20) as line:
        wait_until(lambda: server.pages.client_count == 1)
        read = 0
        for look in range(1, 2 * round(hub.STALL_SECONDS / hub.WATCH_SECONDS)):
            wait_until(lambda look=look: len(looks) > look or server.pages.client_count == 0)
            for _ in range(5):
                read += len(line.recv(100_000))
        assert server.pages.client_count == 1
        assert 500_000 < read < 35_000_000  # the page was never idle


def test_a_page_that_answers_no_ping_is_dropped(server, impatient):
    with silent_line(server):
        wait_until(lambda: server.pages.client_count == 1)
        wait_until(lambda: server.pages.client_count == 0)


def test_the_queue_of_a_page_is_bounded(server, monkeypatch):
    monkeypatch.setattr(hub, "MAX_OWN_BYTES", 20_000_000)
    monkeypatch.setattr(hub, "WATCH_SECONDS", 0.1)
    with page_of(server, max_queue=1):  # it stops reading at the first unread message
        client = client_of(server)
        points = np.zeros((200_000, 3), np.float32)

        def is_dropped_as_more_comes() -> bool:
            client.scene.add_points(points)
            return server.pages.client_count == 0

        wait_until(is_dropped_as_more_comes)
        wait_until(lambda: not client.is_open)


class Page:
    """A page that reads on request."""

    def __init__(self, delivery: Delivery):
        self.channel = Channel(delivery, is_shared=False)
        self.delivery, self.outbox = delivery, delivery.join(self.channel, lambda: None)

    def read(self) -> list[dict]:
        return self.delivery.take(self.outbox)[0]

    def read_all(self) -> list[dict]:
        """All waiting operations without the initial reset."""
        ops: list[dict] = []
        while more := self.read():
            ops += more
        return [op for op in ops if op["op"] != "clear"]


@pytest.fixture
def delivery() -> Delivery:
    return Delivery()


@pytest.fixture
def scene(delivery) -> Scene:
    return Scene(Channel(delivery, is_shared=True))


@pytest.fixture
def gui(delivery) -> Gui:
    return Gui(Channel(delivery, is_shared=True))


POINTS = np.arange(15, dtype=np.float32).reshape(5, 3)


@pytest.mark.parametrize("rows", [0, 1, 5, MAX_FRAME_BYTES // 12 * 3 + 1])
def test_arrays_are_at_their_declared_offsets_without_copies(rows):
    positions, colors = np.full((rows, 3), 0.5, np.float32), np.full((rows, 3), 7, np.uint8)
    operations = [{"op": "node", "id": 1, "positions": positions, "label": "ä\ud800"}, {"op": "x", "colors": colors}]
    pieces = list(pack(operations))
    assert max(map(len, pieces)) <= MAX_FRAME_BYTES
    assert rows < 5 or any(np.shares_memory(np.frombuffer(part, np.uint8), positions) for part in pieces if len(part))
    node, other = unpack(b"".join(pieces))
    for sent, values in ((node["positions"], positions), (other["colors"], colors)):
        assert sent.dtype == values.dtype and np.array_equal(sent, values)


def test_only_values_unsupported_by_json_are_omitted(caplog):
    pieces = pack([{"op": "a", "x": float("nan")}, {"op": "b", "x": np.float32(0.5)}, {"op": "c", "x": POINTS}])
    assert [op["op"] for op in unpack(b"".join(pieces))] == ["b", "c"]
    assert "could not be sent" in caplog.text


def test_an_array_that_its_owner_may_change_is_copied_and_a_read_only_one_is_not(delivery, scene):
    page, changing, still = Page(delivery), POINTS.copy(), POINTS.copy()
    still.flags.writeable = False
    scene.add_points(changing)
    scene.add_points(still)
    changing[:] = 0
    first, second = [op["positions"] for op in page.read_all()]
    assert np.array_equal(first, POINTS)
    assert second is still


def test_a_new_page_gets_the_newest_state_without_removed_nodes(delivery, scene, gui):
    group = scene.add_group()
    child = scene.add_points(POINTS, parent=group)
    removed = scene.add_points(POINTS, parent=scene.add_group(parent=group))
    child.set(size=7)
    child.set_transform(None, (1, 2, 3), 2.0)
    with gui.add_folder("folder") as folder:
        gui.add_button("in it")
    removed._channel.drop("drop", 3)
    folder.remove()
    text = gui.add_text("text", "old")
    text.value = "new"
    ops = Page(delivery).read_all()
    assert [(op["op"], op["id"]) for op in ops] == [("node", group.id), ("node", child.id), ("control", text.id)]
    assert (ops[1]["size"], ops[1]["pose"]) == (7, [2, 0, 0, 1, 0, 2, 0, 2, 0, 0, 2, 3])
    assert ops[2]["value"] == "new"


def test_unsent_changes_are_replaced_in_order(delivery, scene):
    page = Page(delivery)
    node = scene.add_points(POINTS)
    page.read_all()
    for size in range(1, 100):
        node.set(size=size)
        node.visible = size % 2 == 0
    late_group = scene.add_group()
    node.set(size=100)
    change, added = page.read_all()
    assert change == {"op": "set", "id": node.id, "size": 100.0, "visible": False}
    assert (added["op"], added["id"]) == ("node", late_group.id)


def test_what_comes_and_goes_unsent_is_never_sent(delivery, scene):
    page = Page(delivery)
    group = scene.add_group()
    scene.add_points(POINTS, parent=group)
    group.remove()
    assert page.read_all() == []
    node = scene.add_group()
    page.read_all()
    node.visible = False
    node.remove()
    node.visible = True
    node.remove()
    assert page.read_all() == [{"op": "drop", "id": node.id}]


def test_equal_values_are_not_sent(delivery, gui):
    page = Page(delivery)
    slider, words = gui.add_slider("s", 0, 9, 1, 3), gui.add_words("a")
    bar = gui.add_colorbar("height", [(0, "low")], np.zeros((256, 3), np.uint8))
    page.read_all()
    slider.value, words.value, slider.label = 3, "a", "s"
    bar.colors = np.zeros((256, 3), np.uint8)
    assert page.read_all() == []
    slider.value = 4
    assert page.read_all() == [{"op": "setcontrol", "id": slider.id, "value": 4.0}]
    with pytest.raises(AttributeError, match="a slider has no valve"):
        slider.valve = 3


def test_rows_of_a_tree_wait_as_what_they_are_last(delivery, gui):
    page = Page(delivery)
    tree = gui.add_tree()
    for visible in (True, False):
        for number in range(1000):
            tree.put(str(number), f"g/{number}", visible)
    tree.drop("7")
    tree.put("x", "x", True, (1, 2, 3))
    control, rows = page.read_all()
    assert control["kind"] == "tree"
    assert len(rows["put"]) == 1000 and rows["put"][0] == ["0", "g/0", False, None]
    assert rows["put"][-1] == ["x", "x", True, [1, 2, 3]] and rows["drop"] == ["7"]
    assert len(Page(delivery).read_all()[1]["put"]) == 1000


def test_unread_notices_do_not_accumulate(delivery, scene, gui):
    page = Page(delivery)
    client = PageClient(page.channel, 0, FIRST_STATE, (scene, gui))
    for number in range(1000):
        client.notify("n", str(number))
        client.request_signal()
    ops = page.read_all()
    assert [op["text"] for op in ops if op["op"] == "notify"] == [str(number) for number in range(936, 1000)]
    assert [op["n"] for op in ops if op["op"] == "sign"] == [1000]
    assert page.outbox.own_bytes == 0


def test_batches_of_two_threads_are_neither_torn_nor_mixed_up(delivery, scene):
    page, inside, done = Page(delivery), threading.Event(), threading.Event()

    def other() -> None:
        with delivery.atomic():
            node.set(size=5)
            inside.set()
            done.wait(60)
            node.set(opacity=0.5)

    node = scene.add_points(POINTS)
    page.read_all()
    thread = threading.Thread(target=other)
    thread.start()
    assert inside.wait(60)
    node.set(size=6)  # newer than that of the incomplete batch
    assert page.read_all() == []
    done.set()
    thread.join()
    assert page.read_all() == [{"op": "set", "id": node.id, "size": 6.0, "opacity": 0.5}]


def test_large_batches_that_wait_go_one_by_one_and_joined_ones_together(delivery, scene):
    page, large = Page(delivery), np.zeros((800_000, 3), np.float32)
    large.flags.writeable = False
    nodes = [scene.add_points(large) for _ in range(3)]
    assert [len(page.read()) for _ in range(4)] == [2, 1, 1, 0]
    nodes[0].set(positions=large)
    nodes[1].set(positions=large)
    nodes[0].set(size=2)  # of the first message, by a batch after the second: then both or none
    assert len(page.read()) == 2


def test_callbacks_run_in_order_in_one_thread_and_no_more_wait_than_may():
    worker, started, gate, values = Worker("test-worker"), threading.Event(), threading.Event(), []
    worker.run(lambda: (started.set(), gate.wait(60)))
    assert started.wait(60)  # a running callback is not replaced
    accepted = [worker.run(values.append, number) for number in range(MAX_WAITING + 10)]
    assert worker.run(values.append, "end", always=True)
    worker.end()
    assert not worker.run(values.append, "late")
    gate.set()
    worker._thread.join(60)
    assert sum(accepted) in (MAX_WAITING - 1, MAX_WAITING)
    assert values == [*range(sum(accepted)), "end"]


def test_of_several_queued_moves_only_the_last_is_reported():
    worker, gate, values = Worker("test-worker"), threading.Event(), []
    hear = values.append
    worker.run(gate.wait, 60)
    for number in range(1000):
        worker.run(hear, number, about="camera")
    worker.end()
    gate.set()
    worker._thread.join(60)
    assert values == [999]
