"""The points of clouds in a part of the ground, those that are hidden left out: `gather_points`."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....kernels.memory import download
from .picking import Target

_BLOCK = 2_000_000  # points looked at together


@dataclasses.dataclass(frozen=True, eq=False)
class SeenPoints:
    """Points of one or more clouds.

    Attributes:
        points: In the world, float64 [k, 3].
        sources: Of each cloud its name and the numbers of its points, in the order of `points`.
    """

    points: NDArray[np.float64]
    sources: list[tuple[str, NDArray[np.int64]]]

    @property
    def indices(self) -> NDArray[np.int64]:
        """The number of each point in its cloud, int64 [k]."""
        return np.concatenate([np.zeros(0, np.int64), *(rows for _, rows in self.sources)])


def gather_points(targets: Iterable[Target], low: Any, high: Any) -> SeenPoints:
    """The points of clouds in a box along x and y that are not hidden.

    Args:
        targets: The clouds; other things are passed over.
        low, high: Ends of the box along x and y, float64 [2].

    Notes:
        Two million points at a time: 100 MB, and 32 B for each point that is found.
    """
    found, sources = [np.zeros((0, 3))], []
    for target in targets:
        if target.cloud is None or not len(target.cloud):
            continue
        rows = download(target.cloud.device_array("points")).reshape(-1, 3)
        hidden = None if target.hidden is None else download(target.hidden)
        T = np.eye(4) if target.pose is None else np.asarray(target.pose, np.float64)
        start = T[:3, :3] @ target.cloud.origin + T[:3, 3]
        numbers = [np.zeros(0, np.int64)]
        for first in range(0, len(rows), _BLOCK):
            places = rows[first : first + _BLOCK].astype(np.float64) @ T[:3, :3].T + start
            with np.errstate(invalid="ignore"):
                inside = ((places[:, :2] >= low) & (places[:, :2] <= high)).all(axis=1)
            if hidden is not None:
                inside &= hidden[first : first + _BLOCK] == 0
            found.append(places[inside])
            numbers.append(np.flatnonzero(inside) + first)
        sources.append((target.name, np.concatenate(numbers)))
    return SeenPoints(np.concatenate(found), sources)
