"""Result of closing loops between submaps."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.reports import Assessed, failed, quality
from ...core.wording import plain
from ...registration.pose_graphs.pose_graph import PoseGraph
from ...registration.pose_graphs.reports import GlobalOptimizationReport
from .loop_pairs import Loop

Matrix = NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False)
class LoopClosure(Assessed):
    """Submap poses after loop closure.

    Attributes:
        T_world_submap: Pose of each submap in the given order, float64 [n, 4, 4].
        groups: Connected component of each submap, int64 [n]. Each keeps the pose of its first submap.
        loops: Accepted pairs by (target, source).
        refused: Rejected pairs, each with the reason.
        pose_graph: The optimized graph, its nodes ordered by first frame.
        reports: Report of the optimization of each group. Empty without loops.
    """

    T_world_submap: Matrix
    groups: NDArray[np.int64]
    loops: list[Loop]
    refused: list[Loop]
    pose_graph: PoseGraph
    reports: tuple[GlobalOptimizationReport, ...] = ()

    @property
    def graph_warnings(self) -> tuple[str, ...]:
        """Failed quality checks of the pose graph of each group."""
        return tuple(dict.fromkeys(warning for report in self.reports for warning in report.warnings))

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable."""
        sizes = np.unique(self.groups, return_counts=True)[1].tolist()
        apart = (
            f"the submaps form {len(sizes)} groups ({', '.join(map(str, sizes))}) that neither tracking nor a loop "
            "connects, so the poses of the groups relative to each other are those given: record frames that connect "
            "them"
        )
        return failed(*self.graph_warnings, apart if len(sizes) > 1 else None)

    def to_dict(self) -> dict[str, Any]:
        """Poses, groups and pairs (target, source) in JSON types, with `reliable` and `warnings`."""
        loops, refused = ([(loop.target, loop.source) for loop in pairs] for pairs in (self.loops, self.refused))
        values = {"T_world_submap": self.T_world_submap, "groups": self.groups, "loops": loops, "refused": refused}
        return {name: plain(value) for name, value in values.items()} | quality(self)
