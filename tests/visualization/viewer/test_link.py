"""Delivery of operations to pages: complete batches, the newest state, no repetitions."""

import json
import struct
import threading

import numpy as np
import pytest

from pointloom.visualization.viewer.link.camera import FIRST
from pointloom.visualization.viewer.link.client import MAX_WAITING, PageClient, Worker
from pointloom.visualization.viewer.link.delivery import Channel, Delivery
from pointloom.visualization.viewer.link.gui import Gui
from pointloom.visualization.viewer.link.packing import SLICE, pack
from pointloom.visualization.viewer.link.scene import Scene


class Page:
    """A page that reads on request."""

    def __init__(self, delivery: Delivery):
        self.channel = Channel(delivery, is_shared=False)
        self.delivery, self.woken = delivery, 0
        self.outbox = delivery.join(self.channel, self._wake)

    def _wake(self) -> None:
        self.woken += 1

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


@pytest.mark.parametrize("rows", [0, 1, 5, SLICE // 12 * 3 + 1])
def test_arrays_are_at_their_declared_offsets_without_copies(rows):
    positions, colors = np.full((rows, 3), 0.5, np.float32), np.full((rows, 3), 7, np.uint8)
    pieces = list(pack([{"op": "node", "id": 1, "positions": positions, "label": "ä\ud800"}, {"op": "x", "c": colors}]))
    assert max(map(len, pieces)) <= SLICE
    assert rows < 5 or any(
        np.shares_memory(np.frombuffer(piece, np.uint8), positions) for piece in pieces if len(piece)
    )
    message = b"".join(pieces)
    (length,) = struct.unpack("<I", message[:4])
    content = json.loads(message[4 : 4 + length])
    assert (4 + length) % 8 == 0
    for number, values in enumerate((positions, colors)):
        kind, count, width, offset = content["arrays"][number]
        assert offset % 8 == 0
        assert np.array_equal(np.frombuffer(message, f"<{kind}", count * width, offset).reshape(count, width), values)


def test_only_values_unsupported_by_json_are_omitted(caplog):
    message = b"".join(
        pack([{"op": "a", "x": float("nan")}, {"op": "b", "x": np.float32(0.5)}, {"op": "c", "x": POINTS}])
    )
    assert [op["op"] for op in json.loads(message[4 : 4 + struct.unpack("<I", message[:4])[0]])["do"]] == ["b", "c"]
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
    client = PageClient(page.channel, 0, FIRST, (scene, gui))
    for number in range(1000):
        client.notify("n", str(number))
        client.request_signal()
    ops = page.read_all()
    assert [op["text"] for op in ops if op["op"] == "notify"] == [str(number) for number in range(936, 1000)]
    assert [op["n"] for op in ops if op["op"] == "sign"] == [1000]
    assert page.outbox.own_bytes == 0


def test_a_batch_is_sent_completely_at_its_end(delivery, scene):
    page = Page(delivery)
    with delivery.atomic():
        first = scene.add_group()
        with delivery.atomic():
            scene.add_group()
        assert page.read_all() == []
        woken = page.woken
        first.visible = False
    assert page.woken > woken
    ops = page.read()
    assert [op["op"] for op in ops] == ["node", "node"] and ops[0]["visible"] is False


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


@pytest.mark.parametrize(
    "wrong",
    [
        {"positions": np.zeros((5, 2))}, {"colors": np.zeros((5, 4), np.uint8)}, {"size": -1}, {"size": np.nan},
        {"opacity": 2}, {"plain": (1, 2)}, {"normals": np.zeros(3)},
    ],
    ids=str,
)  # fmt: skip
def test_invalid_properties_raise_in_the_caller(delivery, scene, wrong):
    page = Page(delivery)
    with pytest.raises(ValueError, match=next(iter(wrong))):
        scene.add_points(**{"positions": POINTS, **wrong})
    node = scene.add_group()
    with pytest.raises(TypeError, match=r"^size:"):
        node.set(size=3)
    with pytest.raises(ValueError, match="R"):
        node.set_transform(np.full((3, 3), np.nan), None)
    assert len(page.read_all()) == 1
