"""What the scripts of all algorithms share: `Stage`, where they show things, `Script`, and where to look from."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...pcd.cloud import PointCloud
from ..render.pair_picture import usual_look
from ..render.parts import Matrix, Triple
from .shapes import spread_rows

if TYPE_CHECKING:
    from .recorder import Recorder

Look = tuple[Triple, Triple]  # the direction of a view, and what is up
Data = dict[str, Any]

GREY = (0.6, 0.6, 0.6)
LOOKED_AT = 20_000  # points that a view is chosen by


class Stage:
    """A recorder as one kind of algorithm sees it: what it shows goes once another kind shows something.

    Attributes:
        recorder: The Recorder.
        prefix: Of the labels.
    """

    def __init__(self, recorder: Recorder):
        self.recorder, self.prefix = recorder, ""

    @property
    def max_points(self) -> int:
        """As of the recorder."""
        return self.recorder.max_points

    def show(self, name: str, geometry: Any, *, share: int = 1, **style: Any) -> None:
        """Show a geometry, of a part of the points that may be drawn."""
        self.recorder._show(name, [(geometry, style)], max(self.max_points // share, 1), self)

    def show_all(self, name: str, drawn: Sequence[tuple[Any, Data]], total: int) -> None:
        """Show several geometries under one name, which are what is left of so many points."""
        self.recorder._show(name, drawn, self.max_points, self, total)

    def set_pose(self, name: str, pose: Matrix) -> None:
        """Move what is shown, unless the user took it away."""
        if name in self.recorder.names:
            self.recorder.set_pose(name, pose)

    def step(self, label: str, values: Data | None = None) -> None:
        """Make a frame."""
        for name, value in (values or {}).items():
            self.recorder.plot(name, value)
        self.recorder.step(f"{self.prefix}: {label}" if self.prefix else label)


class Script:
    """How one kind of algorithm is shown."""

    def __init__(self, stage: Stage):
        self.stage = stage
        self.look: Look | None = None

    def events(self) -> dict[str, Callable[..., None]]:
        """What is called for each event, with its data."""
        raise NotImplementedError

    def begin(self) -> None:
        """Nothing is shown, or nothing any more."""

    def finish(self) -> None:
        """Show what is still to be shown at the end."""


def look_at(cloud: PointCloud) -> Look | None:
    """A direction to look at a cloud along, and what is up; None of one without finite points."""
    some = cloud.select_by_index(spread_rows(len(cloud), LOOKED_AT)).points
    points = some[np.isfinite(some).all(axis=1)]
    return usual_look(points) if len(points) and np.ptp(points, axis=0).any() else None
