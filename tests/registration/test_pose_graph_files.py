"""Files of pose graphs: Open3D's JSON both ways, and what is wrong with broken ones."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from pointloom import registration as reg
from pointloom.core.errors import FileError


def graph_of(count=4, seed=0) -> reg.PoseGraph:
    rng = np.random.default_rng(seed)

    def pose():
        T = np.eye(4)
        T[:3, :3] = Rotation.from_rotvec(rng.normal(size=3)).as_matrix()
        T[:3, 3] = rng.normal(0, 1e3, 3)
        return T

    def information():
        root = rng.normal(size=(6, 6))
        return root @ root.T

    pairs = [(i, i + 1) for i in range(count - 1)] + [(count - 1, 0)]
    edges = [reg.PoseGraphEdge(i, j, pose(), information(), bool(i % 2), 0.3 if i % 2 else 1.0) for i, j in pairs]
    return reg.PoseGraph([reg.PoseGraphNode(pose()) for _ in range(count)], edges)


def assert_same(ours, theirs) -> None:
    """The same numbers to the bit."""
    assert len(ours.nodes) == len(theirs.nodes) and len(ours.edges) == len(theirs.edges)
    for a, b in zip(ours.nodes, theirs.nodes, strict=True):
        assert np.array_equal(a.pose, b.pose)
    for a, b in zip(ours.edges, theirs.edges, strict=True):
        for name in ("source_node_id", "target_node_id", "uncertain", "confidence"):
            assert getattr(a, name) == getattr(b, name)
        assert np.array_equal(a.transformation, b.transformation)
        assert np.array_equal(a.information, b.information)


@pytest.fixture
def written(tmp_path) -> tuple[Path, dict]:
    """A good file, and what it holds."""
    path = tmp_path / "graph.json"
    reg.write_pose_graph(path, graph_of())
    return path, json.loads(path.read_text())


@pytest.mark.parametrize("count", [2, 7])
def test_open3d_reads_what_we_write_to_the_bit(count, tmp_path):
    import open3d as o3d

    graph = graph_of(count)
    reg.write_pose_graph(tmp_path / "graph.json", graph)
    assert_same(graph, o3d.io.read_pose_graph(str(tmp_path / "graph.json")))
    assert_same(graph, reg.read_pose_graph(tmp_path / "graph.json"))


@pytest.mark.parametrize("count", [2, 7])
def test_we_read_what_open3d_writes_to_the_bit(count, tmp_path):
    import open3d as o3d
    from open3d.pipelines import registration as theirs

    graph, other = graph_of(count, seed=1), theirs.PoseGraph()
    for node in graph.nodes:
        other.nodes.append(theirs.PoseGraphNode(node.pose))
    for edge in graph.edges:
        ends = edge.source_node_id, edge.target_node_id
        other.edges.append(
            theirs.PoseGraphEdge(*ends, edge.transformation, edge.information, edge.uncertain, edge.confidence)
        )
    assert o3d.io.write_pose_graph(str(tmp_path / "graph.json"), other) is None
    assert_same(reg.read_pose_graph(tmp_path / "graph.json"), graph)


def test_a_graph_without_edges_and_one_without_nodes_survive(tmp_path):
    for graph in (reg.PoseGraph(), reg.PoseGraph([reg.PoseGraphNode()])):
        reg.write_pose_graph(tmp_path / "graph.json", graph)
        assert_same(reg.read_pose_graph(tmp_path / "graph.json"), graph)


def test_what_was_assigned_as_lists_is_written_as_arrays_are(tmp_path):
    graph = graph_of()
    expected = graph_of()
    graph.nodes[0].pose = graph.nodes[0].pose.tolist()
    graph.edges[1].information = graph.edges[1].information.tolist()
    graph.edges[1].uncertain = np.bool_(graph.edges[1].uncertain)
    graph.edges[2].source_node_id = np.int32(graph.edges[2].source_node_id)
    reg.write_pose_graph(tmp_path / "graph.json", graph)
    assert_same(reg.read_pose_graph(tmp_path / "graph.json"), expected)


def test_the_optimised_graph_is_written_and_read(tmp_path):
    graph = reg.PoseGraph([reg.PoseGraphNode(), reg.PoseGraphNode()], [reg.PoseGraphEdge(0, 1)])
    solved = reg.global_optimization(graph)
    reg.write_pose_graph(tmp_path / "graph.json", solved)
    assert_same(reg.read_pose_graph(tmp_path / "graph.json"), solved)


def change(content, place, value) -> None:
    *steps, last = place
    for step in steps:
        content = content[step]
    content[last] = value


IDENTITY = np.eye(4).ravel().tolist()


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        (("class_name",), "PinholeCameraTrajectory", r"key class_name\): expected 'PoseGraph'"),
        (("version_major",), 2, r"key version_major\): expected 1, got '2'"),
        (("version_minor",), True, r"key version_minor\): expected 0"),
        (("nodes",), {}, r"key nodes\): expected a list, got a dict"),
        (("edges",), None, r"key edges\): expected a list"),
        (("extra",), 1, r"key extra\): of unknown meaning"),
        (("nodes", 1), [], r"key nodes\[1\]\): expected an object, got a list"),
        (("nodes", 1, "pose"), IDENTITY[:15], r"key nodes\[1\]\.pose\): expected a list of 16 numbers, got 15"),
        (("nodes", 1, "pose"), [*IDENTITY[:15], "1"], r"key nodes\[1\]\.pose\): expected finite numbers"),
        (("nodes", 1, "pose"), [2.0, *IDENTITY[1:]], r"nodes\[1\]\.pose: expected a rigid motion"),
        (("nodes", 1, "pose"), [*IDENTITY[:3], 5.0, *IDENTITY[4:]], r"nodes\[1\]\.pose: .* column by column"),
        (("nodes", 1, "class_name"), "PoseGraphEdge", r"key nodes\[1\]\.class_name\): expected 'PoseGraphNode'"),
        (("nodes", 1, "name"), "kitchen", r"key nodes\[1\]\.name\): of unknown meaning"),
        (("edges", 2, "source_node_id"), 4, r"edges\[2\]\.source_node_id: expected the index of one of 4 nodes, got 4"),
        (("edges", 2, "source_node_id"), -1, r"key edges\[2\]\.source_node_id\): expected the index of a node, got -1"),
        (("edges", 2, "source_node_id"), 2**31, r"key edges\[2\]\.source_node_id\): expected the index of a node"),
        (("edges", 2, "source_node_id"), 1.0, r"key edges\[2\]\.source_node_id\): expected a whole number, got '1.0'"),
        (("edges", 2, "source_node_id"), True, r"key edges\[2\]\.source_node_id\): expected a whole number"),
        (("edges", 2, "target_node_id"), 2, r"edges\[2\]\.target_node_id: expected another node"),
        (("edges", 2, "uncertain"), 1, r"key edges\[2\]\.uncertain\): expected true or false, got '1'"),
        (("edges", 2, "confidence"), "high", r"key edges\[2\]\.confidence\): expected a number, got 'high'"),
        (("edges", 2, "confidence"), 1.25, r"edges\[2\]\.confidence: expected 0\.\.1, got 1\.25"),
        (
            ("edges", 2, "information"),
            IDENTITY,
            r"key edges\[2\]\.information\): expected a list of 36 numbers, got 16",
        ),
        (("edges", 2, "information"), list(range(36)), r"edges\[2\]\.information: expected a symmetric matrix"),
        (("edges", 2, "information"), (-np.eye(6)).ravel().tolist(), r"edges\[2\]\.information: .*semi-definite"),
        (("edges", 2, "information"), [1e101] * 36, r"key edges\[2\]\.information\): expected finite numbers"),
        (("edges", 2, "transformation"), [0.0] * 16, r"edges\[2\]\.transformation: expected a rigid motion"),
    ],
)
def test_broken_files_are_refused_with_the_place(place, value, message, written):
    path, content = written
    change(content, place, value)
    path.write_text(json.dumps(content))
    with pytest.raises(FileError, match=message):
        reg.read_pose_graph(path)


@pytest.mark.parametrize(
    "key",
    ["source_node_id", "target_node_id", "transformation", "information", "uncertain", "confidence", "class_name"],
)
def test_a_missing_key_of_an_edge_is_named(key, written):
    path, content = written
    del content["edges"][1][key]
    path.write_text(json.dumps(content))
    with pytest.raises(FileError, match=rf"key edges\[1\]\.{key}\): missing"):
        reg.read_pose_graph(path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"", "not JSON"),
        (b"[]", "expected a JSON object, got a list"),
        (b'{"class_name": "PoseGraph", "class_name": "PoseGraph"}', "given twice"),
        (b'{"class_name": NaN}', "NaN is not a number"),
        (b"\xff\xfe\x00", "not valid JSON"),
        (b'{"class_name": "PoseGraph"', "line 1"),
    ],
)
def test_what_is_no_pose_graph_is_refused(text, message, tmp_path):
    path = tmp_path / "graph.json"
    path.write_bytes(text)
    with pytest.raises(FileError, match=message):
        reg.read_pose_graph(path)


def test_a_missing_file_and_a_folder_are_refused(tmp_path):
    with pytest.raises(FileError, match="cannot be read"):
        reg.read_pose_graph(tmp_path / "none.json")
    with pytest.raises(FileError, match="cannot be read"):
        reg.read_pose_graph(tmp_path)


@given(data=st.data())
@settings(max_examples=150, deadline=None)
def test_a_damaged_file_is_read_consistently_or_refused(data):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "graph.json"
        reg.write_pose_graph(path, graph_of(2))
        text = bytearray(path.read_bytes())
        for _ in range(data.draw(st.integers(1, 3))):
            if not text:
                break
            place = data.draw(st.integers(0, len(text) - 1))
            kind = data.draw(st.sampled_from(["set", "cut", "drop"]))
            if kind == "set":
                text[place] = data.draw(st.sampled_from(list(b'0123456789-+.eE,:[]{}" ntf\x00\xff')))
            elif kind == "drop":
                del text[place]
            elif place:
                del text[place:]
        path.write_bytes(text)
        try:
            graph = reg.read_pose_graph(path)
        except FileError:
            return
        reg.write_pose_graph(path, graph)
        assert_same(reg.read_pose_graph(path), graph)


def test_files_appear_whole_or_not_at_all(tmp_path, monkeypatch):
    path = tmp_path / "graph.json"
    reg.write_pose_graph(path, graph_of())
    before = path.read_bytes()
    bad = graph_of()
    bad.edges[0].information = np.full((6, 6), np.nan)
    with pytest.raises(ValueError, match=r"edges\[0\]\.information: expected finite numbers"):
        reg.write_pose_graph(path, bad)
    with pytest.raises(FileError, match="exists already"):
        reg.write_pose_graph(path, graph_of(2), overwrite=False)
    assert path.read_bytes() == before
    assert [file.name for file in tmp_path.iterdir()] == ["graph.json"]


def test_what_cannot_be_written_is_refused(tmp_path):
    with pytest.raises(FileError, match=r"expected a name that ends in \.json"):
        reg.write_pose_graph(tmp_path / "graph.txt", graph_of())
    with pytest.raises(FileError, match="does not exist"):
        reg.write_pose_graph(tmp_path / "none" / "graph.json", graph_of())
    with pytest.raises(TypeError, match="pose_graph"):
        reg.write_pose_graph(tmp_path / "graph.json", np.eye(4))
    assert not list(tmp_path.iterdir())
