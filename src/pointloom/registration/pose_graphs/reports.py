"""Reports of pose graph optimizations."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.reports import AssessedRecord, failed
from ...core.wording import few_of

MAX_LISTED = 6  # fragments named in a warning


@dataclass(frozen=True, eq=False)
class GlobalOptimizationReport(AssessedRecord):
    """Report of `global_optimization`.

    Attributes:
        iterations: Steps of both passes.
        initial_residual: Initial cost with all edges: sum of r over certain and mu r / (mu + r) over uncertain edges.
        residual: Final cost with the edges of the second pass.
        line_process_weight: mu of the second pass.
        converged: True if the second pass met a criterion.
        criterion: The name of that criterion; "no descent" if no step lowered the residual.
        pruned_edges: Indices of the removed edges in the given graph.
        unreached_nodes: Nodes that the remaining edges do not connect to the reference (node 0 for -1).
    """

    iterations: int
    initial_residual: float
    residual: float
    line_process_weight: float
    converged: bool
    criterion: str
    pruned_edges: NDArray[np.int64]
    unreached_nodes: NDArray[np.int64]
    _contradiction: str = ""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable."""
        open_end = f"the optimization did not converge within {self.iterations} iterations ({self.criterion})"
        count = len(self.unreached_nodes)
        apart = f"{count} nodes have no path of edges to the reference" if count else None
        return failed(None if self.converged else open_end, self._contradiction, apart)


class FragmentOverlap(NamedTuple):
    """Statistics of an edge: fraction of consistent pairs (`fitness`), `used`, and final `correspondences`."""

    source: int
    target: int
    fitness: float
    used: bool
    correspondences: int


@dataclasses.dataclass(frozen=True, eq=False)
class RefinementReport(AssessedRecord):
    """Report of a fragment alignment.

    Attributes:
        overlaps: A FragmentOverlap for each edge, in order.
        rmse: Root mean square point-to-plane distance [m] before each step and at the end, float64 [iterations + 1].
        correspondences: Number of point pairs, likewise, int64.
        stretch: The grid's part of the error [m^2], likewise, or zeros if rigid.
        turns: Conjugate gradient iterations of each step, int64 [iterations].
    """

    overlaps: list[FragmentOverlap]
    rmse: NDArray[np.float64]
    correspondences: NDArray[np.int64]
    stretch: NDArray[np.float64]
    turns: NDArray[np.int64]

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable."""
        if self.overlaps and not any(overlap.used for overlap in self.overlaps):
            return ("no two fragments overlap at their poses, so nothing was aligned: check the pose graph",)
        fragments = {end for overlap in self.overlaps for end in overlap[:2]}
        paired = [overlap for overlap in self.overlaps if overlap.used and overlap.correspondences]
        lost = sorted(fragments - {end for overlap in paired for end in overlap[:2]})
        apart = f"{len(lost)} fragments ({few_of([str(number) for number in lost], MAX_LISTED)}) overlap with no other"
        before, after = (float(self.rmse[0]), float(self.rmse[-1])) if len(self.rmse) else (0.0, 0.0)
        worse = f"the fragments are farther apart than before ({before:.3g} to {after:.3g} m): use more iterations"
        return failed(
            f"{apart} at their poses, so they were not aligned: check the pose graph" if lost else None,
            worse if after > before else None,
        )
