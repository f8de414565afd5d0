"""The map of a running LiDAR SLAM in a viewer: `LiveMap`."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import PointloomError
from ...core.observers import watch
from ...kernels.linear_algebra import matmul
from ...pcd.cloud import PointCloud
from ...pcd.line_set import LineSet
from ...registration.lidar.lidar_slam import LidarSLAM
from ..recording.shapes import spread_rows
from ..render.coloring import LIMIT_QUANTILES
from ..render.parts import Triple
from .scene_edits import SceneEdits

MAX_SUBMAP_POINTS = 20_000  # displayed points of a submap: 100 submaps, 3 km of a street, are the default `max_points`
MAX_CORNERS = 2_000  # of the path
PATH_COLOR, LOOP_COLOR = (0.84, 0.1, 0.1), (0.94, 0.2, 0.9)  # unlike the colors of heights
LINE_WIDTH = 3.0  # [px]
HEIGHT = "height above the scanner [m]"  # comparable between submaps on a slope, and not changed by loops


class LiveMap:
    """Displayed submaps of `slam` in a scene, the path and the loops. Each event of a finished submap updates them."""

    def __init__(self, edits: SceneEdits, slam: LidarSLAM):
        self._edits, self._slam = edits, slam
        self._poses: list[NDArray[np.float64]] = []  # displayed pose of each submap
        self._limits: tuple[float, float] | None = None

    def take(self, event: str, data: dict[str, Any]) -> None:
        """Show a finished submap and corrected poses. Nothing is done after the viewer was closed."""
        if event != "submap" or data["slam"] is not self._slam or self._edits.scene.closed:
            return
        try:
            self.update()
        except PointloomError:
            if not self._edits.scene.closed:
                raise

    def update(self) -> None:
        submaps, edits = self._slam.submaps, self._edits
        with edits.display.batch():
            for submap in submaps:
                name, T = f"map/{submap.index}", submap.T_world_submap
                if submap.index == len(self._poses):
                    cloud = self._colored(submap.cloud, T)
                    style: dict[str, Any] = {"color_by": HEIGHT, "limits": self._limits}
                    edits.add(name, cloud, **style)
                    self._poses.append(np.eye(4))
                if not np.array_equal(T, self._poses[submap.index]) and name in edits.items:
                    edits.set_pose(name, T)
                self._poses[submap.index] = T
            self._show_lines("path", *self._path(), PATH_COLOR)
            ends = [submap.T_world_submap[:3, 3] for submap in submaps]
            pairs = [(loop.source, loop.target) for loop in self._slam.loops if loop.reliable]
            lines = np.array(pairs, np.int32).reshape(-1, 2)
            self._show_lines("loops", np.array(ends).reshape(-1, 3), lines, LOOP_COLOR)

    def _colored(self, cloud: PointCloud, T: NDArray[np.float64]) -> PointCloud:
        points = cloud.points[spread_rows(len(cloud), MAX_SUBMAP_POINTS)]
        heights = matmul(points, T[2, :3, None])[:, 0]
        if self._limits is None:
            low, high = np.quantile(heights, LIMIT_QUANTILES).tolist() if len(heights) else (0.0, 0.0)
            self._limits = low, max(high, low + 1e-3)
        colored = PointCloud(points)
        colored[HEIGHT] = heights.astype(np.float32)
        return colored

    def _path(self) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        positions = self._slam.poses[:, :3, 3]
        if len(positions) < 2:
            return positions, np.zeros((0, 2), np.int32)
        corners = positions[[*spread_rows(len(positions) - 1, MAX_CORNERS), len(positions) - 1]]
        first = np.arange(len(corners) - 1, dtype=np.int32)
        return corners, np.column_stack([first, first + 1])

    def _show_lines(self, name: str, points: NDArray[np.float64], lines: NDArray[np.int32], color: Triple) -> None:
        if not len(lines):
            return
        shown = LineSet(points, lines)
        if name in self._edits.items:
            self._edits.update(name, shown)
        else:
            self._edits.add(name, shown, color=color, line_width=LINE_WIDTH)


def following(edits: SceneEdits, slam: LidarSLAM) -> contextlib.AbstractContextManager[None]:
    """Show a SLAM inside the block, with the submaps that exist already."""
    if not isinstance(slam, LidarSLAM):
        raise TypeError(f"slam: expected a LidarSLAM, got {type(slam).__name__}")
    return _following(LiveMap(edits, slam))


@contextlib.contextmanager
def _following(live: LiveMap) -> Iterator[None]:
    live.update()
    with watch(live.take):
        yield
