"""COPC nodes: few for the first view, others on demand, and damage that affects only its node."""

import logging

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.points.copc import ENTRY, open_copc
from pointloom.io.points.copc_nodes import declares_copc
from pointloom.io.points.las import read_las
from pointloom.visualization.render.styles import Style
from pointloom.visualization.render.view import fit_view
from pointloom.visualization.viewer.coloring_choice import ColoringChoice
from pointloom.visualization.viewer.copc_tree import CopcTree
from pointloom.visualization.viewer.items import make_item
from pointloom.visualization.viewer.streaming import CloudStream

from .test_streaming import Client

UTM = np.array([512_345.0, 5_402_111.0, 240.0])
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


def near(tree, share=0.03):
    """A view of the dense corner from above."""
    corners = np.array([20.0, 15.0, 1.0]) + UTM + 400 * share * np.array([[-1, -1, 0], [1, 1, 0.0]])
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
    assert nodes.nodes_read < len(tree) / 2


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
        assert np.array_equal(node.colors, colors[node_rows]) and np.array_equal(
            tree.colors_of(node.indices), colors[node_rows]
        )
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
    cloud = loom.read_point_cloud(city)
    plain = make_item("city", 0, cloud, Style())
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
    at = city.read_bytes().index(np.array([node], ENTRY).tobytes())
    path = spoil(city, tmp_path, at + ENTRY.fields["begin"][1], b"\x01\x02\0\0\0\0\0\0")
    with pytest.raises(FileError, match=r"/spoiled\.copc\.laz:"):
        open_copc(path)
    tree = CopcTree(path, first=1)
    assert tree.count == COUNT - int(node["count"])


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


def test_a_viewer_shows_a_file_in_parts(city):
    with loom.Viewer(port=0, max_points=5_000) as viewer:
        viewer.add_copc("city", city, color_by="height")
        viewer.color_by("classification")
        item = viewer.shown["city"]
        assert item.point_count == COUNT and item.colors_of(np.arange(COUNT - 5, COUNT)).shape == (5, 3)
        assert viewer._budget_of(item) == 5_000
        viewer.remove("city")
        assert viewer.items == {}
