"""Base classes for recording algorithms (`Stage`, `Script`) and the default view."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

import numpy as np

from ...pcd.cloud import PointCloud
from ..render.pair_picture import usual_look
from ..render.parts import Matrix, Triple
from .shapes import spread_rows

Look = tuple[Triple, Triple]  # view direction and up
Data = dict[str, Any]

PLAIN_COLOR = (0.6, 0.6, 0.6)
LOOKED_AT = 20_000  # points for choosing the view


class FrameTarget(Protocol):
    """The part of a recorder that algorithms use."""

    max_points: int

    @property
    def names(self) -> list[str]: ...

    def set_pose(self, name: str, pose: Matrix) -> None: ...

    def plot(self, name: str, value: float) -> None: ...

    def step(self, label: str) -> None: ...


class Stage:
    """A recorder for one type of algorithm. Its geometries are removed when another type starts."""

    def __init__(self, recorder: FrameTarget, show: Callable[..., None]):
        self.recorder, self._show, self.prefix = recorder, show, ""

    @property
    def max_points(self) -> int:
        return self.recorder.max_points

    def show(self, name: str, geometry: object, *, fraction: int = 1, **style: Any) -> None:
        """Show a geometry with a fraction 1 / `fraction` of the points."""
        self._show(name, [(geometry, style)], max(self.max_points // fraction, 1), self)

    def show_all(self, name: str, drawn: Sequence[tuple[Any, Data]], total: int) -> None:
        """Show several geometries under one name, sampled from `total` points."""
        self._show(name, drawn, self.max_points, self, total)

    def set_pose(self, name: str, pose: Matrix) -> None:
        """Move a geometry, unless the user removed it."""
        if name in self.recorder.names:
            self.recorder.set_pose(name, pose)

    def step(self, label: str, values: Data | None = None) -> None:
        for name, value in (values or {}).items():
            self.recorder.plot(name, value)
        self.recorder.step(f"{self.prefix}: {label}" if self.prefix else label)


class Script:
    """Recording of one type of algorithm."""

    def __init__(self, stage: Stage):
        self.stage = stage
        self.look: Look | None = None

    def events(self) -> dict[str, Callable[..., None]]:
        raise NotImplementedError

    def begin(self) -> None:
        """Reset: nothing is displayed."""

    def finish(self) -> None:
        """Show the final state."""


def look_at(cloud: PointCloud) -> Look | None:
    """View direction and up for a cloud. None without finite points."""
    some = cloud.select_by_index(spread_rows(len(cloud), LOOKED_AT)).points
    points = some[np.isfinite(some).all(axis=1)]
    return usual_look(points) if len(points) and np.ptp(points, axis=0).any() else None
