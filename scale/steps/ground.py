"""The ground of a survey, and heights above it."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np

from ...core.checks import check_count, check_finite, check_positive, check_shape
from ...core.units import UnitWarning, without_warnings
from ...pcd.ground import CELL, SCALING, THRESHOLD, WINDOW, classify_ground
from ...pcd.raster_cells import GROUND, NoGroundError, check_classes
from ...pcd.terrain import ground_reach, height_above_ground
from ..exact_sums import ExactSums
from .step import Part, Step

OTHER = 1  # the class of points that are not ground, and were nothing else before


class ClassifyGround(Step):
    """Ground points get class 2; others that had it, or none, get class 1."""

    name, searches = "classify_ground", False
    defaults: ClassVar[dict[str, Any]] = {
        "cell_size": CELL, "slope": 0.15, "max_window": WINDOW, "elevation_threshold": THRESHOLD, "scaling": SCALING,
        "corner": (0.0, 0.0),
    }  # fmt: skip

    def check(self) -> None:
        """Set the reach by the parameters."""
        for name in ("slope", "elevation_threshold", "scaling"):
            check_positive(name, self.params[name], allow_zero=True)
        self.params["corner"] = _corner_of(self.params["corner"])
        self.reach = ground_reach(self.params["cell_size"], self.params["max_window"])

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        with without_warnings(UnitWarning):  # a plan has all lengths in the unit of the files
            ground = np.asarray(classify_ground(part.cloud, **self.params))
        cloud = part.cloud.copy()
        before = np.asarray(cloud["classification"]) if "classification" in cloud else np.zeros(len(cloud), np.uint8)
        stays = (before != 0) & (before != GROUND[0])
        cloud["classification"] = np.where(ground, GROUND[0], np.where(stays, before, OTHER)).astype(np.uint8)
        return dataclasses.replace(part, cloud=cloud)


class HeightAboveGround(Step):
    """The height of each point above the ground near it, as the attribute `height_above_ground`."""

    name, searches = "height_above_ground", False
    defaults: ClassVar[dict[str, Any]] = {
        "reach": 20.0, "neighbors": 8, "cell": 1.0, "corner": (0.0, 0.0), "classes": GROUND,
    }  # fmt: skip

    def check(self) -> None:
        """Set the reach by the parameters."""
        self.reach = check_positive("reach", self.params["reach"])
        check_count("neighbors", self.params["neighbors"])
        check_positive("cell", self.params["cell"])
        self.params["corner"] = _corner_of(self.params["corner"])
        self.params["classes"] = [*(check_classes(self.params["classes"]) or GROUND)]

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        cloud = part.cloud.copy()
        try:
            cloud[self.name] = np.asarray(height_above_ground(part.cloud, **self.params))
        except NoGroundError:
            cloud[self.name] = np.full(len(cloud), np.nan, np.float32)
        return dataclasses.replace(part, cloud=cloud)


def _corner_of(corner: Any) -> list[float]:
    return check_finite("corner", check_shape("corner", corner, (2,))).tolist()
