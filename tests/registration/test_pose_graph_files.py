"""Pose graph files: Open3D's JSON in both directions, and errors for broken files."""

import json
import re
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


def assert_same(actual, theirs) -> None:
    assert len(actual.nodes) == len(theirs.nodes) and len(actual.edges) == len(theirs.edges)
    for a, b in zip(actual.nodes, theirs.nodes, strict=True):
        assert np.array_equal(a.pose, b.pose)
    for a, b in zip(actual.edges, theirs.edges, strict=True):
        for name in ("source_node_id", "target_node_id", "uncertain", "confidence"):
            assert getattr(a, name) == getattr(b, name)
        assert np.array_equal(a.transformation, b.transformation)
        assert np.array_equal(a.information, b.information)


@pytest.fixture
def written(tmp_path) -> tuple[Path, dict]:
    """A valid file and its contents."""
    path = tmp_path / "graph.json"
    reg.write_pose_graph(path, graph_of())
    return path, json.loads(path.read_text())


def test_open3d_reads_written_files_exactly(tmp_path, o3d):
    graph = graph_of(7)
    reg.write_pose_graph(tmp_path / "graph.json", graph)
    assert_same(graph, o3d.io.read_pose_graph(str(tmp_path / "graph.json")))


def written_by_open3d(o3d, graph):
    """The text of Open3D's file of a graph."""
    theirs = o3d.pipelines.registration
    other = theirs.PoseGraph()
    for node in graph.nodes:
        other.nodes.append(theirs.PoseGraphNode(node.pose))
    for edge in graph.edges:
        ends = edge.source_node_id, edge.target_node_id
        other.edges.append(
            theirs.PoseGraphEdge(*ends, edge.transformation, edge.information, edge.uncertain, edge.confidence)
        )
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "graph.json"
        o3d.io.write_pose_graph(str(path), other)
        return path.read_text()


def test_files_of_open3d_are_read_exactly(tmp_path, oracle):
    graph = graph_of(5, seed=1)
    (tmp_path / "graph.json").write_text(oracle("registration/pose_graphs/file", written_by_open3d, graph))
    assert_same(reg.read_pose_graph(tmp_path / "graph.json"), graph)


def test_graphs_without_edges_or_nodes_round_trip(tmp_path):
    for graph in (reg.PoseGraph(), reg.PoseGraph([reg.PoseGraphNode()])):
        reg.write_pose_graph(tmp_path / "graph.json", graph)
        assert_same(reg.read_pose_graph(tmp_path / "graph.json"), graph)


def test_assigned_lists_are_written_as_arrays(tmp_path):
    graph = graph_of()
    expected = graph_of()
    graph.nodes[0].pose = graph.nodes[0].pose.tolist()
    graph.edges[1].information = graph.edges[1].information.tolist()
    graph.edges[1].uncertain = np.bool_(graph.edges[1].uncertain)
    graph.edges[2].source_node_id = np.int32(graph.edges[2].source_node_id)
    reg.write_pose_graph(tmp_path / "graph.json", graph)
    assert_same(reg.read_pose_graph(tmp_path / "graph.json"), expected)


IDENTITY = np.eye(4).ravel().tolist()


@pytest.mark.parametrize(
    ("key_path", "value"),
    [
        ("class_name", "PinholeCameraTrajectory"), ("version_major", 2), ("version_minor", True), ("nodes", {}),
        ("edges", None), ("extra", 1), ("nodes[1]", []), ("nodes[1].pose", IDENTITY[:15]),
        ("nodes[1].pose", [*IDENTITY[:15], "1"]), ("nodes[1].pose", [2.0, *IDENTITY[1:]]),
        ("nodes[1].pose", [*IDENTITY[:3], 5.0, *IDENTITY[4:]]), ("nodes[1].class_name", "PoseGraphEdge"),
        ("nodes[1].name", "kitchen"), ("edges[2].source_node_id", 4), ("edges[2].source_node_id", -1),
        ("edges[2].source_node_id", 2**31), ("edges[2].source_node_id", 1.0), ("edges[2].source_node_id", True),
        ("edges[2].target_node_id", 2), ("edges[2].uncertain", 1), ("edges[2].confidence", "high"),
        ("edges[2].confidence", 1.25), ("edges[2].information", IDENTITY), ("edges[2].information", list(range(36))),
        ("edges[2].information", (-np.eye(6)).ravel().tolist()), ("edges[2].information", [1e101] * 36),
        ("edges[2].transformation", [0.0] * 16), ("edges[2].transformation", None), ("edges[2].class_name", None),
    ],
)  # fmt: skip
def test_broken_files_are_rejected_with_the_key_path(key_path, value, written):
    """None removes an edge's key."""
    path, content = written
    *steps, last = key_path.replace("[", ".").replace("]", "").split(".")
    inner = content
    for step in steps:
        inner = inner[int(step) if step.isdigit() else step]
    if value is None and steps:
        del inner[last]
    elif last.isdigit():
        inner[int(last)] = value
    else:
        inner[last] = value
    path.write_text(json.dumps(content))
    with pytest.raises(FileError, match=rf"\b{re.escape(key_path)}(\b|\)|:)"):
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
def test_invalid_graphs_are_rejected(text, message, tmp_path):
    path = tmp_path / "graph.json"
    path.write_bytes(text)
    with pytest.raises(FileError, match=message):
        reg.read_pose_graph(path)


def test_a_missing_file_and_a_folder_are_rejected(tmp_path):
    with pytest.raises(FileError, match=r"/none\.json:"):
        reg.read_pose_graph(tmp_path / "none.json")
    with pytest.raises(FileError, match="cannot be read"):
        reg.read_pose_graph(tmp_path)


@given(data=st.data())
@settings(max_examples=40, deadline=None)
def test_a_damaged_file_is_read_consistently_or_rejected(data):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "graph.json"
        reg.write_pose_graph(path, graph_of(2))
        text = bytearray(path.read_bytes())
        for _ in range(data.draw(st.integers(1, 3))):
            if not text:
                break
            offset = data.draw(st.integers(0, len(text) - 1))
            kind = data.draw(st.sampled_from(["set", "cut", "drop"]))
            if kind == "set":
                text[offset] = data.draw(st.sampled_from(list(b'0123456789-+.eE,:[]{}" ntf\x00\xff')))
            elif kind == "drop":
                del text[offset]
            elif offset:
                del text[offset:]
        path.write_bytes(text)
        try:
            graph = reg.read_pose_graph(path)
        except FileError:
            return
        reg.write_pose_graph(path, graph)
        assert_same(reg.read_pose_graph(path), graph)


def test_files_are_written_atomically(tmp_path, monkeypatch):
    path = tmp_path / "graph.json"
    reg.write_pose_graph(path, graph_of())
    before = path.read_bytes()
    bad = graph_of()
    bad.edges[0].information = np.full((6, 6), np.nan)
    with pytest.raises(ValueError, match=r"edges\[0\]\.information:"):
        reg.write_pose_graph(path, bad)
    with pytest.raises(FileError, match="exists already"):
        reg.write_pose_graph(path, graph_of(2), overwrite=False)
    assert path.read_bytes() == before
    assert [file.name for file in tmp_path.iterdir()] == ["graph.json"]


def test_unwritable_values_are_rejected(tmp_path):
    with pytest.raises(FileError, match=r"/graph\.txt:"):
        reg.write_pose_graph(tmp_path / "graph.txt", graph_of())
    with pytest.raises(FileError, match=r"/graph\.json:"):
        reg.write_pose_graph(tmp_path / "none" / "graph.json", graph_of())
    with pytest.raises(TypeError, match="pose_graph"):
        reg.write_pose_graph(tmp_path / "graph.json", np.eye(4))
    assert not list(tmp_path.iterdir())
