"""What a recording shows of parts of clouds: clusters, planes, fragments of one scene."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.memory import download
from ...pcd.cloud import PointCloud
from ..render.coloring import label_color
from ..render.parts import Matrix
from .script import GREY, Data, Script, Stage, look_at
from .shapes import spread_rows

RED = (0.86, 0.1, 0.1)
MOST_TURNS = 100  # frames in which clusters appear


class Clusters(Script):
    """Clusters that take their colours one after another, by their numbers; an algorithm has no such steps."""

    def events(self) -> dict[str, Callable[..., None]]:
        """As of Script."""
        return {"clusters": self.clusters}

    def clusters(self, cloud: PointCloud, labels: Any, **_: Any) -> None:
        """The labels of a cloud."""
        rows = spread_rows(len(cloud), self.stage.max_points)
        chosen, found = cloud.select_by_index(rows), download(labels)[rows]
        self.look = self.look or look_at(chosen)
        count = int(found.max(initial=-1)) + 1
        turn = -(-max(count, 1) // MOST_TURNS)  # clusters that appear in one frame
        groups = [(chosen.select_by_mask(found < 0), {"color": label_color(-1)})]
        painted: list[tuple[Any, Data]] = []
        for first in range(0, count, turn):
            part = chosen.select_by_mask((found >= first) & (found < first + turn))
            groups.append((part, {"color": GREY}))
            kinds, each = np.unique(found[(found >= first) & (found < first + turn)], return_inverse=True)
            shades = np.array([label_color(int(label)) for label in kinds]).reshape(-1, 3)[each]
            painted.append((_painted(part, shades), {}))
        plural = "" if count == 1 else "s"
        self.stage.show_all("cloud", groups, len(cloud))
        self.stage.step("the cloud")
        for k, part in enumerate(painted):
            groups[k + 1] = part
            self.stage.show_all("cloud", groups, len(cloud))
            self.stage.step(f"{min((k + 1) * turn, count)} of {count} cluster{plural}")


class Planes(Script):
    """Planes that take their colours as they are found."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._cloud: Any = None
        self._found: list[NDArray[np.int32]] = []

    def events(self) -> dict[str, Callable[..., None]]:
        """As of Script."""
        return {"plane": self.plane}

    def plane(self, cloud: PointCloud, inliers: Any, model: Any, number: int | None = None, **_: Any) -> None:
        """The points of a plane; without a number it is the only one that is looked for."""
        if cloud is not self._cloud or not number:
            self._cloud, self._found = cloud, []
            self.look = self.look or look_at(cloud)
            self.stage.show("cloud", cloud)
            self.stage.step("the cloud")
        self._found.append(download(inliers))
        rows = spread_rows(len(cloud), self.stage.max_points)
        taken = np.full(len(cloud), -1)
        for k, found in enumerate(self._found):
            taken[found] = k
        taken, chosen = taken[rows], cloud.select_by_index(rows)
        drawn: list[tuple[Any, Data]] = [(chosen.select_by_mask(taken < 0), {"color": GREY})]
        for k in range(len(self._found)):
            color = RED if number is None else label_color(k)
            drawn.append((chosen.select_by_mask(taken == k), {"color": color}))
        self.stage.show_all("cloud", drawn, len(cloud))
        a, b, c, d = model
        self.stage.step(f"{len(self._found[-1]):,} points on {a:.3f} x {b:+.3f} y {c:+.3f} z {d:+.3f} = 0")


class Fragments(Script):
    """Clouds of one scene, brought into one frame."""

    def events(self) -> dict[str, Callable[..., None]]:
        """As of Script."""
        return {"fragments": self.fragments}

    def fragments(self, clouds: Sequence[PointCloud], poses: Matrix, placed: NDArray[np.bool_], **_: Any) -> None:
        """Where they lie; they come one after another."""
        share, count = max(len(clouds), 1), int(placed.sum())
        for k, number in enumerate(np.flatnonzero(placed).tolist()):
            look = look_at(clouds[number])
            self.look = self.look or look
            color = label_color(number)
            self.stage.show(f"cloud {number}", clouds[number], share=share, color=color, pose=poses[number])
            self.stage.step(f"{k + 1} of {count} clouds placed, {len(clouds)} in all")


def _painted(cloud: PointCloud, colors: NDArray[np.float64]) -> PointCloud:
    painted = cloud.copy()
    painted.colors = colors
    return painted
