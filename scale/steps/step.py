"""The steps of a job: what each does to a part of a cloud, and how far around a tile it must see to do that rightly.

A step is of one of three classes. One of finite reach needs what lies within its reach. One of the k nearest is run
with a guess and certified: each point whose result is used must have k points nearer than what is missing. One with
numbers of the whole first measures all tiles, and is then done with exact sums over them. One whose answer reaches
through any number of tiles has each leave what its neighbours must know, has all of that joined once, and is then done
with what the join gives each. What needs the whole at once is refused.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...core.known_names import nearest_name
from ...pcd.cloud import PointCloud


@dataclass(frozen=True, eq=False)
class Part:
    """What a tile and its halo hold between two steps.

    Attributes:
        cloud: The points about the plan's origin.
        exact: Their positions as the files have them, float64 [n, 3]; None once a step has moved them.
        homes: Where each point counts as lying, x and y, float64 [n, 2]: its position in the file, or its voxel's
            middle. Each home is in one tile, whatever the tiles' size.
        spread: How far a point may lie from its home along x or y.
        other: The other epoch, for a step that compares.
        keys: int64 [n], all different, in the order that the points have in the whole: of the files and of the rows in
            them, or of voxels; None where they cannot be told.
    """

    cloud: PointCloud
    exact: NDArray[np.float64] | None
    homes: NDArray[np.float64]
    spread: float = 0.0
    other: PointCloud | None = None
    keys: NDArray[np.int64] | None = None

    def select(self, keep: NDArray[np.bool_]) -> Part:
        """The points of a mask."""
        if keep.all():
            return self
        return self.take(np.flatnonzero(keep), self.cloud.select_by_mask(keep))

    def beside(self, other: PointCloud | None) -> Part:
        """The same with another epoch at hand, or without."""
        return dataclasses.replace(self, other=other)

    def take(self, rows: NDArray[Any], cloud: PointCloud) -> Part:
        """Some rows, whose cloud is there already."""
        exact = None if self.exact is None else self.exact[rows]
        keys = None if self.keys is None else self.keys[rows]
        return dataclasses.replace(self, cloud=cloud, exact=exact, homes=self.homes[rows], keys=keys)


@dataclass(frozen=True, eq=False)
class Sight:
    """What of a part a tile that leaves something for a join may rely on.

    Attributes:
        owners: The tile that each point is at home in, int64 [n].
        own: Which points are at home in this tile, bool [n].
        shared: Which of these other tiles see, too.
        seen: Around which points all is there within the step's reach.
    """

    owners: NDArray[np.int64]
    own: NDArray[np.bool_]
    shared: NDArray[np.bool_]
    seen: NDArray[np.bool_]


class Step:
    """One step, its parameters checked.

    Attributes:
        name: As users write it.
        params: In JSON's types, defaults filled in.
        reach: How far a result depends on other points; of the k nearest the guess, which the plan makes.
        neighbors: k, of a step of the k nearest.
        needs_numbers: Whether it needs numbers of the whole.
        joins: Whether it needs what all tiles leave, joined.
        hops: How many reaches away a result of a tile may depend on.
        searches: Whether it searches for neighbours, in the cloud's tree.
        writes: Whether it writes something beside the tile, of tiles without points too.
        epoch: Paths of the files of another epoch that it compares with; empty where it does not.
    """

    name = ""
    defaults: ClassVar[dict[str, Any]] = {}
    required: tuple[str, ...] = ()
    reach = 0.0
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
        """Check the parameters and set what follows from them."""

    def settle(self, sources: list[dict[str, Any]]) -> None:
        """Bring parameters to the survey that is planned for, whose files are described."""

    def spread_after(self, spread: float) -> float:
        """How far points may lie from their homes after the step."""
        return spread

    def halo_before(self, after: float, spread: float, reach: float) -> float:
        """The halo that it must be given so that all is right in a halo `after` it."""
        return after + self.hops * (reach + 2 * spread)

    def run(self, part: Part, plan: Any, numbers: Any) -> Part:
        """The step on a part, with the sums that it needs or what a join gives the tile."""
        raise NotImplementedError

    def measure(self, part: Part) -> NDArray[np.float64]:
        """The values whose sums over the whole are needed."""
        raise NotImplementedError

    def gather(self, part: Part, sight: Sight) -> dict[str, NDArray[Any]]:
        """What a tile leaves for the join."""
        raise NotImplementedError

    def join(self, left: Any, folder: Path) -> int:
        """Join what all tiles left; into the folder goes what each gets. How many things there are in the whole."""
        raise NotImplementedError
