"""Streaming of clouds and COPC files to a client that stores the browser's state."""

import contextlib
import itertools
import logging
import threading

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.points.copc import COPC_ENTRY, open_copc
from pointloom.io.points.copc_nodes import declares_copc
from pointloom.io.points.las import read_las
from pointloom.visualization.render.styles import Style
from pointloom.visualization.render.view import View, fit_view
from pointloom.visualization.viewer import streaming
from pointloom.visualization.viewer.coloring_choice import ColoringChoice
from pointloom.visualization.viewer.copc_tree import CopcTree
from pointloom.visualization.viewer.detail_tree import DetailTree
from pointloom.visualization.viewer.items import make_item
from pointloom.visualization.viewer.streaming import CloudStream

from .events import wait_until
from .stand_in import page_in
from .test_detail_tree import UTM, hills

BUDGET = 90_000


class Node:
    """A node of the scene; changes are seen at once."""

    def __init__(self, client, kind, number, parent=None, R=None, t=None, scale=1.0, visible=True, **values):
        self.client, self.kind, self.id, self.parent, self.removed = client, kind, number, parent, False
        self._visible, self.values = visible, values
        self.set_transform(R, t, notify=False)

    def set_transform(self, R=None, t=None, scale=None, *, notify=True):
        self.R = np.eye(3) if R is None else np.asarray(R)
        self.t = np.zeros(3) if t is None else np.asarray(t, np.float64)
        if notify:
            self.client.messages.append(("place", self.id))

    @property
    def visible(self):
        return self._visible

    @visible.setter
    def visible(self, visible):
        self.client.check(self)
        self._visible = visible
        self.client.messages.append(("visible", self.id))

    def set(self, **values):
        self.client.check(self)
        self.values.update(values)
        self.client.messages.append(("set", self.id))

    def remove(self):
        self.client.check(self)
        self.removed = True
        for number in [n for n, node in self.client.nodes.items() if self in (node, node.parent)]:
            del self.client.nodes[number]
        self.client.messages.append(("remove", self.id))

    def __getattr__(self, name):
        return self.__dict__["values"][name]


class Client:
    """Replaces a `PageClient`."""

    def __init__(self):
        self.scene, self.nodes, self.messages, self.swaps = self, {}, [], []
        self.is_open, self.depth, self.on_swap, self.threads = True, 0, None, []
        self.numbers = itertools.count(1)

    def check(self, node):
        assert self.is_open, "nothing is sent to a page that has gone"
        assert not node.removed

    @contextlib.contextmanager
    def atomic(self):
        self.depth += 1
        yield
        self.depth -= 1
        if not self.depth:
            self.swaps.append(sum(len(node.positions) for node in self.seen()))
            self.threads.append(threading.get_ident())
            if self.on_swap:
                self.on_swap()

    def add_group(self, **placing):
        return self.add("group", placing)

    def add_points(self, positions, colors, **values):
        assert self.depth, "nodes are swapped in together"
        assert np.isfinite(positions).all()
        assert colors.shape == positions.shape and colors.dtype == np.uint8
        return self.add("points", {"positions": positions, "colors": np.array(colors), **values})

    def add(self, kind, values):
        node = Node(self, kind, next(self.numbers), **values)
        self.nodes[node.id] = node
        self.messages.append(("add", node.id))
        return node

    def seen(self):
        return [node for node in self.nodes.values() if node.kind == "points" and node.visible]

    @property
    def frame(self):
        (frame,) = [node for node in self.nodes.values() if node.kind == "group"]
        return frame

    def world(self):
        """Visible positions relative to the scene's origin, in float64."""
        parts = [node.positions.astype(np.float64) + node.t for node in self.seen()]
        assert all(node.parent is self.frame for node in self.seen())
        points = np.concatenate(parts) if parts else np.empty((0, 3))
        return points @ self.frame.R.T + self.frame.t

    def count(self, kind):
        return sum(message[0] == kind for message in self.messages)


def numbers_of(stream):
    """The tree index of each node in the page."""
    return {sent.node.id: i for i, sent in stream._sent.items() if sent.node is not None}


POINTS = hills(np.random.default_rng(3), 200_000, UTM)
FAR = fit_view(POINTS, width=1000, height=750)


def moved(view, forward, sideways=0.0):
    T = view.T_world_camera.copy()
    T[:3, 3] += T[:3, :3] @ [sideways, 0, forward]
    return View(view.intrinsic, T)


@pytest.fixture(scope="module")
def tree():
    colors = np.random.default_rng(0).integers(0, 256, (len(POINTS), 3)) / 255
    return DetailTree.from_cloud(loom.PointCloud(POINTS, colors=colors))


@pytest.fixture
def client():
    return Client()


@pytest.fixture
def stream(client, tree):
    return CloudStream(client, tree, origin=UTM, budget=BUDGET)


def distances_to(points, among):
    return np.array([np.linalg.norm(among - p, axis=1).min() for p in points])


def test_a_view_is_filled_up_to_the_budget(client, stream):
    stream.look(FAR)
    assert 0.7 * BUDGET < stream.drawn == len(client.world()) <= BUDGET
    assert stream.total == len(POINTS)
    before = len(client.messages)
    stream.look(FAR)  # again, and nothing is sent
    assert len(client.messages) == before


def test_points_are_sent_with_their_positions(client, stream, tree):
    """Within a quarter of a pixel, near and far, half a million meters from zero."""
    precisions = []
    for view in (FAR, moved(FAR, 70.0), moved(FAR, 115.0)):
        stream.look(view)
        precisions.append({str(node.positions.dtype) for node in client.seen()})
        sent = client.world() + UTM
        chosen = np.random.default_rng(1).choice(len(sent), 10, replace=False)
        gaps = distances_to(sent[chosen], POINTS)
        away = np.linalg.norm(sent[chosen] - view.T_world_camera[:3, 3], axis=1)
        assert (gaps / away * view.intrinsic.fx).max() < 0.5  # along all three axes together
    assert "float16" in precisions[0]
    assert "float32" in precisions[2]


def test_the_first_points_come_soon_and_coarse(client, tree, monkeypatch):
    monkeypatch.setattr(streaming, "_BATCH_POINTS", 30_000)
    monkeypatch.setattr(streaming, "_FIRST_POINTS", 20_000)
    stream = CloudStream(client, tree, origin=UTM, budget=10**6)
    stream.look(FAR)
    tree_numbers = numbers_of(stream)
    names = [tree_numbers[number] for kind, number in client.messages if kind == "add" and number in tree_numbers]
    assert len(client.swaps) > 3
    assert 0 < client.swaps[0] < len(POINTS) / 2, "the first swap is a part"
    assert tree.levels[names[0]] == 0
    assert tree.levels[names[-1]] == tree.levels.max()


def test_points_are_sent_in_steps_at_the_pace_of_the_client(client, tree, monkeypatch):
    monkeypatch.setattr(streaming, "_BATCH_POINTS", 30_000)
    drawn_counts = []

    def pause():
        drawn_counts.append(stream.drawn)
        stream.set_visible(True)  # no lock is held, so that other threads can continue
        return True

    stream = CloudStream(client, tree, origin=UTM, budget=10**6, pause=pause)
    stream.look(FAR)
    assert stream.drawn == len(POINTS)
    assert len(drawn_counts) >= 3
    assert all(a < b < len(POINTS) for a, b in itertools.pairwise(drawn_counts))
    assert client.count("remove") == 0


def test_colors_go_with_their_points(client, stream, tree):
    stream.look(FAR)
    sent, colors = client.world() + UTM, np.concatenate([node.colors for node in client.seen()])
    for k in range(0, len(sent), 4999):
        nearest = int(np.argmin(((POINTS - sent[k]) ** 2).sum(axis=1)))
        assert np.array_equal(colors[k], tree.colors_of(np.array([nearest]))[0])


def test_returning_to_a_view_shows_hidden_nodes_again(client, stream):
    near = moved(FAR, 120.0)
    stream.look(near)
    before = np.sort(client.world(), axis=0)
    stream.look(FAR)
    sent = client.count("add")
    stream.look(near)
    assert client.count("add") == sent, "nothing is sent twice"
    assert np.array_equal(np.sort(client.world(), axis=0), before)
    for view in (FAR, near, FAR):
        stream.look(view)
        assert stream.drawn == len(client.world()), "nodes that are displayed again count once"


def test_hidden_points_are_bounded(client, tree, monkeypatch):
    monkeypatch.setattr(streaming, "_HIDDEN_BUDGETS", 1)
    stream = CloudStream(client, tree, origin=UTM, budget=40_000)
    for sideways in np.linspace(-45, 45, 9):
        stream.look(moved(FAR, 115.0, sideways))
        n_points = sum(len(node.positions) for node in client.nodes.values() if node.kind == "points")
        assert n_points <= 2 * 40_000
    assert client.count("remove") > 0


def test_no_swap_leaves_a_hole_or_doubles_the_points(client, stream):
    stream.look(FAR)
    del client.swaps[:]
    stream.look(moved(FAR, 120.0, 20.0))
    assert 0.3 * BUDGET < min(client.swaps) <= max(client.swaps) <= BUDGET


def test_an_overtaken_look_stops(client, stream, monkeypatch):
    """Another thread looks elsewhere during the first batch of a look."""
    monkeypatch.setattr(streaming, "_BATCH_NODES", 1)
    other = moved(FAR, 90.0, 15.0)
    thread = threading.Thread(target=stream.look, args=(other,))

    def overtake():
        client.on_swap = None
        thread.start()
        while stream._version < 2:
            pass

    client.on_swap = overtake
    del client.threads[:]
    stream.look(FAR)
    thread.join()
    expected = Client()
    CloudStream(expected, stream._tree, origin=UTM, budget=BUDGET).look(other)
    assert np.array_equal(np.sort(client.world(), axis=0), np.sort(expected.world(), axis=0))
    assert client.threads.count(threading.get_ident()) == 1, "no batch behind the first"


def test_new_colors_apply_to_all_shown_points_and_are_restored(client, stream):
    near = moved(FAR, 120.0)
    stream.look(near)
    stream.look(FAR)
    assert client.count("visible") > 1
    sent = client.count("add")
    stream.set_colors(lambda indices: np.stack([indices % 251, indices % 7, indices % 3], axis=1).astype(np.uint8))
    assert client.count("add") == sent, "positions are not sent again"
    assert all(node.colors[:, 2].max() < 3 for node in client.seen())
    stream.look(near)
    assert all(node.colors[:, 2].max() < 3 for node in client.seen())
    stream.set_colors(None)
    assert np.concatenate([node.colors for node in client.seen()])[:, 2].max() > 200


def test_hidden_points_are_not_drawn_and_are_replaced_by_others(client, stream):
    stream.look(FAR)
    middle = POINTS[:, 0].mean()
    stream.set_keep(lambda points: points[:, 0] > middle)
    world = client.world()
    assert (world[:, 0] + UTM[0] > middle - 0.05).all()
    assert 0.6 * BUDGET < stream.drawn == len(world) <= BUDGET, "the budget is used for what is left"
    stream.set_colors(lambda indices: np.repeat((POINTS[indices, :1] <= middle), 3, axis=1).astype(np.uint8))
    assert {int(c) for node in client.seen() for c in np.unique(node.colors)} == {0}
    stream.set_keep(lambda points: np.zeros(len(points), bool))
    assert stream.drawn == 0 == len(client.world())
    stream.set_keep(None)
    assert stream.drawn > 0.7 * BUDGET


def test_points_grow_with_the_gaps_between_them(client, stream):
    stream.look(FAR)
    far = stream.point_size
    assert min(node.size for node in client.seen()) == far and all(node.metric for node in client.seen())
    stream.look(moved(FAR, 115.0))
    assert stream.point_size < 0.7 * far
    for metric in (True, False):
        stream.set_point_size(0.5, metric)
        assert {(node.size, node.metric) for node in client.seen()} == {(0.5, metric)}
        stream.look(FAR)
        assert {(node.size, node.metric) for node in client.seen()} == {(0.5, metric)}, "those that were hidden too"


def test_coarse_ends_of_what_is_drawn_have_larger_points(client, stream, tree):
    """They would be visible within a node that is drawn finer."""
    stream.look(moved(FAR, 120.0))
    tree_numbers = numbers_of(stream)
    sizes = {tree_numbers[node.id]: node.size for node in client.seen()}
    nodes = sorted(sizes)
    refined = dict(zip(nodes, tree.are_refined(nodes), strict=True))
    assert any(refined.values())
    for i in nodes:
        assert sizes[i] == (stream.point_size if refined[i] else max(stream.point_size, 1.5 * tree.spacings[i]))
    assert max(sizes.values()) > stream.point_size


def test_a_pose_moves_sent_and_selected_points(client, stream):
    stream.look(FAR)
    before = client.world() + UTM
    T = np.eye(4)
    T[:2, :2], T[:3, 3] = [[0.8, -0.6], [0.6, 0.8]], [5.0, -2.0, 1.0]
    T[:3, 3] += UTM - T[:3, :3] @ UTM
    stream.set_pose(T)
    stream.look(View(FAR.intrinsic, T @ FAR.T_world_camera))
    after = client.world() + UTM
    assert np.abs(np.sort(after, axis=0) - np.sort(before @ T[:3, :3].T + T[:3, 3], axis=0)).max() < 1e-6


def test_a_pose_that_hardly_differs_is_sent_too(client, stream):
    """A frame 10 km away follows steps of a centimeter."""
    stream.look(FAR)
    T = np.eye(4)
    T[0, 3] = 10_000.0
    stream.set_pose(T)
    T[0, 3] += 0.01
    stream.set_pose(T)
    del client.messages[:]
    stream.set_visible(False)
    assert client.messages == [("visible", client.frame.id)] and not client.frame.visible
    assert client.frame.t[0] - (stream._tree.origin - UTM)[0] == pytest.approx(10_000.01, abs=1e-6)


def test_a_closed_stream_leaves_nothing_and_does_nothing(client, stream):
    stream.look(FAR)
    stream.close()
    stream.close()
    assert client.nodes == {}
    stream.look(FAR)
    stream.set_visible(True)
    stream.set_pose(np.eye(4))
    stream.set_colors(None)
    assert (client.nodes, stream.drawn) == ({}, 0)


@pytest.mark.parametrize("act", ["look", "set_point_size", "set_colors", "set_keep"])
def test_a_client_that_has_gone_is_sent_nothing_more(client, stream, act):
    stream.look(FAR)
    client.is_open = False
    arguments = {"look": [moved(FAR, 80.0)], "set_point_size": [0.1], "set_keep": [lambda points: points[:, 0] > 9],
                 "set_colors": [lambda indices: np.zeros((len(indices), 3), np.uint8)]}  # fmt: skip
    before = len(client.messages)
    getattr(stream, act)(*arguments[act])
    assert len(client.messages) == before


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.full((2, 3), np.nan), [[1.0, 2.0, 3.0]]], ids=str)
def test_clouds_of_hardly_any_points(client, points):
    stream = CloudStream(client, DetailTree.from_cloud(loom.PointCloud(points)), origin=np.zeros(3), budget=10)
    stream.look(fit_view([[0, 0, 0], [1, 2, 3]]))
    assert stream.drawn == stream.total == np.isfinite(np.asarray(points)).all(axis=1).sum()


COUNT = 60_000


@pytest.fixture(scope="module")
def city(tmp_path_factory):
    """A slope that is dense in one corner, so that the octree is deep there."""
    rng = np.random.default_rng(5)
    xy = rng.random((COUNT, 2)) ** 2 * (400, 300)
    points = np.column_stack([xy, xy[:, 0] / 20 + rng.random(COUNT)]) + UTM
    colors = rng.integers(0, 256, (COUNT, 3), dtype=np.uint8)
    labels = np.where(xy[:, 0] > 60, 6, 2).astype(np.uint8)
    cloud = loom.PointCloud(points, colors=colors, classification=labels, intensity=rng.integers(0, 999, COUNT))
    path = tmp_path_factory.mktemp("copc") / "city.copc.laz"
    loom.write_point_cloud(path, cloud)
    return path


def home(tree):
    return fit_view(tree.head.points, width=320, height=240)


def near(tree, fraction=0.03):
    """A view of the dense corner from above."""
    corners = np.array([20.0, 15.0, 1.0]) + UTM + 400 * fraction * np.array([[-1, -1, 0], [1, 1, 0.0]])
    return fit_view(corners, direction=(0, 0, -1), up=(0, 1, 0), width=320, height=240)


def spoil(path, tmp_path, at, by):
    content = bytearray(path.read_bytes())
    content[at : at + len(by)] = by
    other = tmp_path / "spoiled.copc.laz"
    other.write_bytes(content)
    return other


def test_a_first_look_reads_the_coarse_levels_alone(city):
    tree = CopcTree(city, first=15_000)
    nodes = tree.nodes
    assert tree.count == COUNT and len(tree.head) <= max(15_000, tree.counts[0])
    assert nodes.nodes_read == np.count_nonzero(np.cumsum(tree.counts) <= len(tree.head)) < len(tree) / 2
    assert nodes.bytes_read < city.stat().st_size / 2
    for i in range(nodes.nodes_read):  # the root's points come first
        assert np.abs(tree.points_of(i) - tree.head.points[tree.indices_of(i)]).max() < 1e-4


def rows_of(points):
    """The row of each point by its coordinates, the float64 values of the file."""
    return {tuple(point): row for row, point in enumerate(points.tolist())}


def test_all_nodes_are_the_file_to_its_own_precision(city):
    tree, file_cloud = CopcTree(city, first=1), read_las(city)
    rows, colors = rows_of(file_cloud.points), np.rint(file_cloud.colors * 255)
    all_rows = []
    for i in range(len(tree)):
        node, node_rows = tree.node(i), [rows[tuple(point)] for point in tree.points_of(i).tolist()]
        assert np.abs(node.positions + node.middle - file_cloud.points[node_rows]).max() < 1e-4
        for sent in (node.colors, tree.colors_of(node.indices)):
            assert np.array_equal(sent, colors[node_rows])
        all_rows += node_rows
    assert sorted(all_rows) == list(range(COUNT))


def test_a_near_view_reads_only_near_nodes(city):
    tree = CopcTree(city, first=1)
    client = Client()
    stream = CloudStream(client, tree, origin=UTM, budget=24_000)
    stream.look(home(tree))
    first, read = client.world(), tree.nodes.nodes_read
    assert 0 < len(first) <= max(24_000, tree.counts[0])
    stream.look(near(tree))
    middle = np.array([20.0, 15.0])
    inside = [np.count_nonzero(np.abs(rows[:, :2] - middle).max(axis=1) < 4) for rows in (first, client.world())]
    assert inside[1] > 2 * inside[0]
    assert read < tree.nodes.nodes_read < len(tree)
    assert stream.total == COUNT
    before = tree.nodes.nodes_read
    stream.look(home(tree))
    assert tree.nodes.nodes_read == before  # the loaded nodes are available


def test_the_node_cache_is_bounded(city):
    memory = 300_000
    tree = CopcTree(city, memory=memory, first=1)
    for i in [*range(len(tree)), *range(len(tree))]:
        tree.node(i)
        assert tree.nodes.memory_used <= max(memory, int(tree.counts.max()) * tree.nodes.row.itemsize)
    assert tree.nodes.nodes_read > len(tree)  # some twice


@pytest.mark.parametrize("by", ["height", "classification"])
def test_nodes_have_the_colors_of_the_complete_cloud(city, by):
    tree = CopcTree(city, first=1)
    item = make_item("city", 0, tree.head, Style(), tree)
    limits = (245.0, 255.0) if by == "height" else None
    choice = ColoringChoice(by, None, limits)
    item.recolor(choice.of(item))
    plain = make_item("city", 0, loom.read_point_cloud(city), Style())
    plain.recolor(choice.of(plain))
    rows = rows_of(read_las(city).points)
    for i in (0, len(tree) - 1):
        node_rows = [rows[tuple(point)] for point in tree.points_of(i).tolist()]
        colors = item.colors_of(tree.indices_of(i)).astype(int)
        assert len(colors) and np.abs(colors - plain.colors_of(np.array(node_rows))).max() <= 1


def test_a_damaged_node_is_named_and_the_others_are_shown(city, tmp_path, caplog):
    node = open_copc(city).nodes[-1]
    at = int(node["begin"]) + open_copc(city).file.header.record_length + 4
    path = spoil(city, tmp_path, at, b"\xff" * 36)  # the sizes of its layers
    with pytest.raises(FileError):
        loom.read_point_cloud(path)
    tree = CopcTree(path, first=1)
    client = Client()
    with caplog.at_level(logging.WARNING, "pointloom.viewer"):
        CloudStream(client, tree, origin=UTM, budget=COUNT).look(home(tree))
        assert len(tree.node(len(tree) - 1).positions) == 0
    (message,) = [record.getMessage() for record in caplog.records]
    assert "spoiled.copc.laz" in message and f"node {node['level']}-" in message
    assert "its layers do not fit" in message and "the other points are shown" in message
    assert len(client.world()) == COUNT - int(node["count"])


def test_a_node_that_is_no_chunk_is_left_out(city, tmp_path):
    node = open_copc(city).nodes[-1]
    at = city.read_bytes().index(np.array([node], COPC_ENTRY).tobytes())
    path = spoil(city, tmp_path, at + COPC_ENTRY.fields["begin"][1], b"\x01\x02\0\0\0\0\0\0")
    with pytest.raises(FileError, match=r"/spoiled\.copc\.laz:"):
        open_copc(path)
    assert CopcTree(path, first=1).count == COUNT - int(node["count"])


def test_a_coarse_node_that_is_damaged_leaves_those_below(city, tmp_path, caplog):
    node = open_copc(city).nodes[0]
    at = int(node["begin"]) + open_copc(city).file.header.record_length + 4
    tree = CopcTree(spoil(city, tmp_path, at, b"\xff" * 36), first=1)
    assert tree.count == COUNT - int(node["count"]) and tree.levels[0] == 1 and len(tree.head)
    assert len(tree.lost) == 1 and "node 0-0-0-0" in caplog.text


def test_a_changed_or_deleted_file_does_not_break_a_page(city, tmp_path, caplog):
    path = tmp_path / "gone.copc.laz"
    path.write_bytes(city.read_bytes())
    tree = CopcTree(path, first=1)
    path.write_bytes(city.read_bytes()[:-100])
    assert len(tree.node(len(tree) - 1).positions) == 0 and "has changed since it was opened" in caplog.text
    path.unlink()
    assert len(tree.node(len(tree) - 2).positions) == 0 and "cannot be read" in caplog.text


def test_files_other_than_copc_are_rejected(city, tmp_path):
    cut = tmp_path / "cut.copc.laz"
    cut.write_bytes(city.read_bytes()[:20_000])
    plain = tmp_path / "plain.laz"
    loom.write_point_cloud(plain, loom.PointCloud(np.eye(3)))
    for path, reason in ((cut, "cut.copc.laz"), (plain, "is not a COPC file"), (tmp_path / "none.laz", "none.laz")):
        with pytest.raises(FileError, match=reason):
            CopcTree(path)
    assert declares_copc(city, more_than=COUNT - 1)
    assert not declares_copc(city, more_than=COUNT) and not declares_copc(plain)


def placed(node, positions):
    """Positions in the coordinates of the parent of a node."""
    pose = np.reshape(node.pose, (3, 4))
    return positions @ pose[:, :3].T + pose[:, 3]


def test_a_viewer_shows_a_file_in_parts(city):
    """Buildings are the points with x > 60 m."""
    with loom.Viewer(port=0, max_points=20_000) as viewer, page_in(viewer) as page:
        viewer.add_copc("city", city, color_by="height")
        viewer.color_by("classification")
        wait_until(lambda: (nodes := shown_in(page)) and len(np.unique(nodes[0].colors, axis=0)) == 2)
        nodes, origin = shown_in(page), viewer.scene.frame.origin
        parts = [placed(page.nodes[node.parent], placed(node, node.positions.astype(float))) for node in nodes]
        points, colors = np.concatenate(parts) + origin - UTM, np.concatenate([node.colors for node in nodes])
        assert 10_000 < len(points) <= 20_000
        assert np.abs(points[:, 2] - points[:, 0] / 20 - 0.5).max() < 1.0
        far, near = (np.unique(colors[mask], axis=0) for mask in (points[:, 0] > 60.5, points[:, 0] < 59.5))
        assert len(far) == len(near) == 1 and (far != near).any()
        viewer.remove("city")
        wait_until(lambda: not shown_in(page))


def shown_in(page):
    return [node for node in page.nodes.values() if node.kind == "points" and node.visible]
