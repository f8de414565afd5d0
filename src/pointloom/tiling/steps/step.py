"""Steps of a job: operation on a part of a cloud, and the halo it needs around a tile.

Kinds of steps: finite radius; k nearest, run with an estimated radius and verified (each result point must have k
points nearer than missing data). Global sums, measured over all tiles first; joined, where tiles leave border data that
is joined once. Steps that need the complete cloud are rejected.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...core.attribute_hints import nearest_name
from ...pcd.cloud import PointCloud
from ..plan_check import TilePlan


@dataclass(frozen=True, eq=False)
class Part:
    """A tile with its halo between two steps.

    Attributes:
        cloud: The points about the plan's origin.
        exact: File positions, float64 (n, 3). None once a step moved points.
        homes: x and y that assign each point to a tile, float64 (n, 2): its file position, or its voxel's center.
        spread: Maximum distance of a point from its home along x or y.
        other: The other epoch, for a comparing step.
        keys: int64 (n,), unique, in the global order of files and rows, or of voxels. None if unknown.
    """

    cloud: PointCloud
    exact: NDArray[np.float64] | None
    homes: NDArray[np.float64]
    spread: float = 0.0
    other: PointCloud | None = None
    keys: NDArray[np.int64] | None = None

    def select(self, keep: NDArray[np.bool_]) -> Part:
        if keep.all():
            return self
        return self.take(np.flatnonzero(keep), self.cloud.select_by_mask(keep))

    def with_epoch(self, other: PointCloud | None) -> Part:
        """Same part with or without another epoch."""
        return dataclasses.replace(self, other=other)

    def take(self, rows: NDArray[Any], cloud: PointCloud) -> Part:
        """Select rows whose cloud is already computed."""
        exact = None if self.exact is None else self.exact[rows]
        keys = None if self.keys is None else self.keys[rows]
        return dataclasses.replace(self, cloud=cloud, exact=exact, homes=self.homes[rows], keys=keys)


@dataclass(frozen=True, eq=False)
class Sight:
    """What a tile that leaves border data may rely on. `owners`: home tile of each point, int64 (n,). `own`: points of
    this tile. `shared`: own points that other tiles also see. `seen`: points with a complete neighborhood."""

    owners: NDArray[np.int64]
    own: NDArray[np.bool_]
    shared: NDArray[np.bool_]
    seen: NDArray[np.bool_]


class Step:
    """A step with validated parameters.

    Attributes:
        name, params: Name as written by users; parameters in JSON's types with defaults.
        radius: Dependence radius of a result. For the k nearest an estimate made by the plan.
        neighbors: k, of a step of the k nearest.
        needs_numbers, joins: True if the step needs global sums, or joined border data.
        hops: Number of radii that a result may depend on.
        searches: True if it searches neighbors in the cloud's tree.
        writes: True if it writes other files, also for empty tiles.
        epoch: Files of the compared epoch. Empty if none.
    """

    name = ""
    defaults: ClassVar[dict[str, Any]] = {}
    required: tuple[str, ...] = ()
    radius = 0.0
    neighbors: int | None = None
    needs_numbers = False
    joins = False
    hops = 1
    searches = True
    writes = False
    epoch: list[str] | tuple[()] = ()

    def __init__(self, params: dict[str, Any]):
        known = {*self.defaults, *self.required}
        for name in params:
            if name not in known:
                raise ValueError(f"steps: {self.name} has no parameter {name!r}{nearest_name(name, known)}")
        for name in self.required:
            if name not in params:
                raise ValueError(f"steps: {self.name} needs {name!r}")
        self.params = self.defaults | params
        self.check()

    def check(self) -> None:
        """Validate parameters and derive others."""

    def adapt(self, sources: list[dict[str, Any]]) -> None:
        """Adapt parameters to the described files of the survey."""

    def spread_after(self, spread: float) -> float:
        """Maximum distance of points from their homes after the step."""
        return spread

    def halo_before(self, after: float, spread: float, radius: float) -> float:
        """Halo that the step needs so that a halo of `after` is correct."""
        return after + self.hops * (radius + 2 * spread)

    def run(self, part: Part, plan: TilePlan, numbers: Any) -> Part:
        """Apply the step to a part, with global sums or the tile's join result."""
        raise NotImplementedError

    def measure(self, part: Part) -> NDArray[np.float64]:
        """Values whose global sums are needed."""
        raise NotImplementedError

    def gather(self, part: Part, sight: Sight) -> dict[str, NDArray[Any]]:
        """Border data of a tile for the join."""
        raise NotImplementedError

    def join(self, left: Any, folder: Path) -> int:
        """Join the data of all tiles, write each tile's result, return the global count."""
        raise NotImplementedError
