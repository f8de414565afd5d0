"""Pose graph files: Open3D's JSON, strictly read, written with all digits."""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...cameras.camera import read_json_matrix
from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError
from ...core.json_files import check_keys, read_json_object
from .pose_graph import PoseGraph, PoseGraphEdge, PoseGraphNode, check_pose_graph

FORMAT_VERSION = {"version_major": 1, "version_minor": 0}
_FRAME_KEYS = frozenset(("class_name", *FORMAT_VERSION))
_GRAPH_KEYS = _FRAME_KEYS | {"nodes", "edges"}
_NODE_KEYS = _FRAME_KEYS | {"pose"}
_EDGE_KEYS = _FRAME_KEYS | {
    "source_node_id", "target_node_id", "transformation", "information", "uncertain", "confidence",
}  # fmt: skip
LARGEST_ID = 2**31 - 1  # Open3D's ids are 32-bit


def read_pose_graph(path: str | os.PathLike[str]) -> PoseGraph:
    """Read a pose graph written by `write_pose_graph` or Open3D.

    Returns:
        The graph, checked as in `global_optimization` except for connectivity.

    Raises:
        FileError: Unreadable, not JSON, not a PoseGraph of version 1.0, a missing, unknown or duplicate key, or an
            invalid pose, node id, information or confidence. The message names it.

    Example:
        >>> import pointloom as loom
        >>> reg = loom.registration
        >>> graph = reg.PoseGraph([reg.PoseGraphNode(), reg.PoseGraphNode()], [reg.PoseGraphEdge(0, 1)])
        >>> reg.write_pose_graph("graph.json", graph)
        >>> reg.read_pose_graph("graph.json")
        PoseGraph(2 nodes, 1 edges, 0 of them uncertain)
    """
    content = read_json_object(path)
    _check_frame(path, content, "PoseGraph", _GRAPH_KEYS, "")
    graph = PoseGraph()
    for key in ("nodes", "edges"):
        if not isinstance(content[key], list):
            raise FileError(path, f"expected a list, got a {type(content[key]).__name__}", where=f"key {key}")
    for i, node in enumerate(content["nodes"]):
        location = f"nodes[{i}]"
        _check_frame(path, node, "PoseGraphNode", _NODE_KEYS, location)
        graph.nodes.append(PoseGraphNode(read_json_matrix(path, node["pose"], 4, where=f"key {location}.pose")))
    graph.edges = [_read_edge(path, edge, f"edges[{i}]") for i, edge in enumerate(content["edges"])]
    try:
        check_pose_graph(graph)
    except ValueError as error:
        raise FileError(path, str(error), remedy="Matrices are stored column by column") from error
    return graph


def write_pose_graph(path: str | os.PathLike[str], pose_graph: PoseGraph, *, overwrite: bool = True) -> None:
    """Write a pose graph as Open3D's JSON, losslessly and atomically.

    Args:
        path: The file, `*.json`.
        pose_graph: The graph. Its `report` is not written.
        overwrite: Replace an existing file.

    Raises:
        FileError: Another extension, or the file cannot be written.
        TypeError, ValueError: Not a pose graph, or an invalid node or edge.
    """
    path = check_writable(path, overwrite=overwrite)
    if path.suffix.lower() != ".json":
        raise FileError(
            path, f"expected a name that ends in .json, got {path.suffix!r}", remedy="Open3D reads only .json"
        )
    arrays = check_pose_graph(pose_graph)
    content = {
        "class_name": "PoseGraph",
        "edges": [
            {
                "class_name": "PoseGraphEdge",
                "confidence": float(edge.confidence),
                "information": _columns(edge.information),
                "source_node_id": source,
                "target_node_id": target,
                "transformation": _columns(edge.transformation),
                "uncertain": bool(edge.uncertain),
                **FORMAT_VERSION,
            }
            for edge, source, target in zip(
                pose_graph.edges, arrays.source.tolist(), arrays.target.tolist(), strict=True
            )
        ],
        "nodes": [{"class_name": "PoseGraphNode", "pose": _columns(T), **FORMAT_VERSION} for T in arrays.poses],
        **FORMAT_VERSION,
    }
    text = json.dumps(content, indent=1) + "\n"
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(text.encode("ascii"))


def _columns(matrix: ArrayLike) -> list[float]:
    return np.asarray(matrix, np.float64).T.ravel().tolist()


def _check_frame(path: str | os.PathLike[str], content: object, name: str, keys: frozenset[str], location: str) -> None:
    where = f"{location}." if location else ""
    if not isinstance(content, dict):
        raise FileError(path, f"expected an object, got a {type(content).__name__}", where=f"key {location}")
    check_keys(path, content, required=keys, where=where)
    for key, expected in (("class_name", name), *FORMAT_VERSION.items()):
        if content[key] != expected or isinstance(content[key], bool):
            raise FileError(path, f"expected {expected!r}, got {str(content[key])[:40]!r}", where=f"key {where}{key}")


def _read_edge(path: str | os.PathLike[str], content: dict[str, Any], location: str) -> PoseGraphEdge:
    _check_frame(path, content, "PoseGraphEdge", _EDGE_KEYS, location)
    for key, kinds, expected in (
        ("source_node_id", int, "an integer"),
        ("target_node_id", int, "an integer"),
        ("confidence", (int, float), "a number"),
        ("uncertain", bool, "true or false"),
    ):
        value = content[key]
        if not isinstance(value, kinds) or (isinstance(value, bool) and kinds is not bool):
            raise FileError(path, f"expected {expected}, got {str(value)[:40]!r}", where=f"key {location}.{key}")
    for key in ("source_node_id", "target_node_id"):
        if not 0 <= content[key] <= LARGEST_ID:
            raise FileError(path, f"expected the index of a node, got {content[key]}", where=f"key {location}.{key}")
    return PoseGraphEdge(
        content["source_node_id"],
        content["target_node_id"],
        read_json_matrix(path, content["transformation"], 4, where=f"key {location}.transformation"),
        read_json_matrix(path, content["information"], 6, where=f"key {location}.information"),
        content["uncertain"],
        content["confidence"],
    )
