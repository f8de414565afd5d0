"""Pose graphs as lists of nodes and edges, optimized in place."""

from __future__ import annotations

import copy
from collections.abc import Iterable
from dataclasses import field
from typing import Any, ClassVar, SupportsIndex

import numpy as np

from ....registration.pose_graphs import pose_graph, pose_graph_optimization
from ...settings import Settings
from ...wrapper import Wrapper, unwrap


class PoseGraphNode(Settings, of=pose_graph):
    """A node: `pose` is T_world_node, shape (4, 4)."""

    pose: Any = field(default_factory=lambda: np.eye(4))

    def __repr__(self) -> str:
        return "PoseGraphNode, access pose to get its current pose."


class PoseGraphEdge(Settings, of=pose_graph):
    """A measured transformation between two nodes, T_target_source, and its information (6, 6)."""

    source_node_id: Any = -1
    target_node_id: int = -1
    transformation: Any = field(default_factory=lambda: np.eye(4))
    information: Any = field(default_factory=lambda: np.eye(6))
    uncertain: bool = False
    confidence: float = 1.0

    def __repr__(self) -> str:
        between = f"from nodes {self.source_node_id} to {self.target_node_id}"
        return f"PoseGraphEdge {between}, access transformation to get relative transformation"


class _CopyingList(list[Any]):
    """A list that copies its elements, as Open3D's vectors do."""

    _element: ClassVar[type[Settings]]

    def __init__(self, values: Iterable[Any] = ()):
        super().__init__(map(self._taken, values))

    def _taken(self, value: Any) -> Any:
        if not isinstance(value, self._element):
            raise TypeError(f"{type(self).__name__}: expected a {self._element.__name__}, got {type(value).__name__}")
        return copy.copy(value)

    def append(self, x: Any) -> None:
        super().append(self._taken(x))

    def extend(self, L: Iterable[Any]) -> None:
        super().extend(map(self._taken, L))

    def insert(self, i: SupportsIndex, x: Any) -> None:
        super().insert(i, self._taken(x))

    def __setitem__(self, index: Any, value: Any) -> None:
        super().__setitem__(index, list(map(self._taken, value)) if isinstance(index, slice) else self._taken(value))


class PoseGraphNodeVector(_CopyingList):
    _element = PoseGraphNode


class PoseGraphEdgeVector(_CopyingList):
    _element = PoseGraphEdge


class PoseGraph(Wrapper):
    """Nodes and edges: `graph.nodes.append(node)`, `graph.edges.append(edge)`."""

    _kind = pose_graph.PoseGraph
    _nodes: PoseGraphNodeVector
    _edges: PoseGraphEdgeVector

    def __init__(self, other: PoseGraph | pose_graph.PoseGraph | None = None):
        self._take(pose_graph.PoseGraph() if other is None else unwrap(other, PoseGraph, "arg0"))

    @classmethod
    def from_native(cls, native: pose_graph.PoseGraph) -> PoseGraph:
        return cls(native)

    def _take(self, graph: pose_graph.PoseGraph) -> None:
        self._nodes = PoseGraphNodeVector(map(PoseGraphNode.from_native, graph.nodes))
        self._edges = PoseGraphEdgeVector(map(PoseGraphEdge.from_native, graph.edges))

    @property
    def native(self) -> pose_graph.PoseGraph:
        return pose_graph.PoseGraph(unwrap(list(self._nodes)), unwrap(list(self._edges)))

    @property
    def nodes(self) -> PoseGraphNodeVector:
        return self._nodes

    @nodes.setter
    def nodes(self, nodes: Iterable[PoseGraphNode]) -> None:
        self._nodes[:] = list(nodes)

    @property
    def edges(self) -> PoseGraphEdgeVector:
        return self._edges

    @edges.setter
    def edges(self, edges: Iterable[PoseGraphEdge]) -> None:
        self._edges[:] = list(edges)

    def __copy__(self) -> PoseGraph:
        return PoseGraph(self)

    def __getstate__(self) -> dict[str, Any]:
        return {"ours": self.native}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self._take(state["ours"])

    def __repr__(self) -> str:
        return f"PoseGraph with {len(self._nodes)} nodes and {len(self._edges)} edges."


class GlobalOptimizationOption(Settings, of=pose_graph_optimization):
    """Options. As in Open3D, the distance is 0.075 without arguments and 0.03 if any argument is given."""

    max_correspondence_distance: Any = None
    edge_prune_threshold: float | None = None
    preference_loop_closure: float | None = None
    reference_node: int | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        alone = all(value is None for value in self.native_keywords().values())
        defaults = {"max_correspondence_distance": 0.075 if alone else 0.03, "edge_prune_threshold": 0.25}
        for name, value in (defaults | {"preference_loop_closure": 1.0, "reference_node": -1}).items():
            if getattr(self, name) is None:
                setattr(self, name, value)

    def __repr__(self) -> str:
        return _listed(self)


class GlobalOptimizationConvergenceCriteria(Settings, of=pose_graph_optimization):
    max_iteration: Any = 100
    min_relative_increment: float = 1e-6
    min_relative_residual_increment: float = 1e-6
    min_right_term: float = 1e-6
    min_residual: float = 1e-6
    max_iteration_lm: int = 20
    upper_scale_factor: float = 2 / 3
    lower_scale_factor: float = 1 / 3

    def __repr__(self) -> str:
        return _listed(self)


class GlobalOptimizationMethod(Settings):
    """Base class of the two optimizers."""

    _kind = str
    _name = ""

    @property
    def native(self) -> str:
        return self._name

    def OptimizePoseGraph(
        self, pose_graph: PoseGraph, criteria: GlobalOptimizationConvergenceCriteria, option: GlobalOptimizationOption
    ) -> None:
        global_optimization(pose_graph, self, criteria, option)


class GlobalOptimizationGaussNewton(GlobalOptimizationMethod):
    _name = pose_graph_optimization.GAUSS_NEWTON


class GlobalOptimizationLevenbergMarquardt(GlobalOptimizationMethod):
    _name = pose_graph_optimization.LEVENBERG_MARQUARDT


def global_optimization(
    pose_graph: PoseGraph,
    method: GlobalOptimizationMethod,
    criteria: GlobalOptimizationConvergenceCriteria,
    option: GlobalOptimizationOption,
) -> None:
    """Optimize the nodes in place and remove contradicting edges."""
    solved = pose_graph_optimization.global_optimization(
        unwrap(pose_graph, PoseGraph, "pose_graph"),
        unwrap(method, GlobalOptimizationMethod, "method"),
        unwrap(criteria, GlobalOptimizationConvergenceCriteria, "criteria"),
        unwrap(option, GlobalOptimizationOption, "option"),
    )
    for node, moved in zip(pose_graph.nodes, solved.nodes, strict=True):
        node.pose = moved.pose
    pose_graph.edges = map(PoseGraphEdge.from_native, solved.edges)


def _listed(settings: Settings) -> str:
    values = settings.native_keywords().items()
    shown = [f"> {name} : {value if isinstance(value, int) else f'{value:f}'}" for name, value in values]
    return "\n".join([type(settings).__name__, *shown])
