"""What optimizations of a pose graph say of themselves: its `report`."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class GlobalOptimizationReport:
    """How an optimisation went.

    Attributes:
        iterations: Steps of both passes.
        initial_residual: The sum that is minimised, at the given poses with all edges: of r over certain edges and
            mu r / (mu + r) over uncertain ones.
        residual: The same at the optimised poses, with the edges that the second pass had.
        line_process_weight: mu of the second pass.
        converged: Whether the second pass met a criterion rather than running out of steps or finding none downhill.
        reason: The criterion, by its name; "no descent" where no step lowered the residual.
        pruned_edges: Indices of the edges that were dropped, in the graph as it was given.
        unreached_nodes: Nodes that no path of the edges that are left joins to the reference (node 0 where that is -1):
            where they stand rests on edges that were dropped.
    """

    iterations: int
    initial_residual: float
    residual: float
    line_process_weight: float
    converged: bool
    reason: str
    pruned_edges: NDArray[np.int64]
    unreached_nodes: NDArray[np.int64]


class FragmentOverlap(NamedTuple):
    """What became of an edge.

    Attributes:
        source, target: The fragments.
        fitness: Share of the pairs of points that the edge makes that agree with the nodes' poses; 0 without any.
        used: Whether the edge counted.
        correspondences: Pairs of points in the last step.
    """

    source: int
    target: int
    fitness: float
    used: bool
    correspondences: int


@dataclasses.dataclass(frozen=True, eq=False)
class RefinementReport:
    """How an alignment of fragments went: the `report` of the pose graph that it returns.

    Attributes:
        overlaps: A FragmentOverlap of each edge, in the order of the edges.
        rmse: Root mean square of the distances of points from their partners' planes [m], before each step and at the
            end, float64 [iterations + 1]. Partners are found anew each time.
        correspondences: Pairs of points, likewise, int64.
        stretch: The grid's part of the error [m^2], likewise; zeros where nothing was bent.
        turns: Turns of conjugate gradients in each step, int64 [iterations].
    """

    overlaps: list[FragmentOverlap]
    rmse: NDArray[np.float64]
    correspondences: NDArray[np.int64]
    stretch: NDArray[np.float64]
    turns: NDArray[np.int64]
