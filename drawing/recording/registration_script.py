"""What a recording shows of registration."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ...core.units import symbol_of
from ...pcd.cloud import PointCloud
from ..render.pair_picture import BLUE, ORANGE
from ..render.parts import Matrix
from .script import Data, Script, Stage, look_at


class Registration(Script):
    """Two clouds: the target blue, the source orange under each pose."""

    def __init__(self, stage: Stage):
        super().__init__(stage)
        self._pair: tuple[Any, Any] | None = None
        self._pose: Matrix | None = None

    def begin(self) -> None:
        """As of Script."""
        self._pair = self._pose = None

    def events(self) -> dict[str, Callable[..., None]]:
        """As of Script."""
        return {"icp": self.icp, "registration": self.registration}

    def icp(self, source: PointCloud, target: PointCloud, iteration_index: int, **data: Any) -> None:
        """A turn of ICP."""
        if iteration_index == 0 or self._pair is None or self._pair[0] is not source or self._pair[1] is not target:
            self._take(source, target)
        m = symbol_of(source.unit)
        voxels = f", voxels of {data['voxel_size']:g} {m}" if data.get("voxel_size") else ""
        fit = {"fitness": data["fitness"], f"inlier rmse [{m}]": data["inlier_rmse"]}
        self._at(data["transformation"], f"ICP{voxels}, iteration {iteration_index}", fit)

    def registration(self, source: PointCloud, target: PointCloud, result: Any, **data: Any) -> None:
        """The result of any registration; that of ICP was its last turn's already."""
        if self._pose is not None and np.array_equal(self._pose, result.transformation):
            return
        if self._pair is None or self._pair[0] is not source or self._pair[1] is not target:
            self._take(source, target)
            self._at(np.eye(4), "as the clouds lie", {})
        fit = {"fitness": result.fitness, f"inlier rmse [{symbol_of(source.unit)}]": result.inlier_rmse}
        self._at(result.transformation, f"registered: {result.reason}", fit)

    def _take(self, source: PointCloud, target: PointCloud) -> None:
        self._pair = source, target
        self.look = self.look or look_at(target)
        self.stage.show("target", target, color=BLUE)
        self.stage.show("source", source, color=ORANGE)

    def _at(self, pose: Matrix, label: str, values: Data) -> None:
        self._pose = np.array(pose)
        self.stage.set_pose("source", pose)
        self.stage.step(label, values)
