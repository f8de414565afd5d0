"""Normals, turned to a direction."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, ClassVar

from ...core.checks import check_direction, check_search, shown
from ..exact_sums import ExactSums
from .step import Part, Step


class EstimateNormals(Step):
    """Normals of the neighbours within a radius, of the nearest, or both; turned to a direction or left."""

    name = "estimate_normals"
    defaults: ClassVar[dict[str, Any]] = {"radius": None, "max_nn": 30, "orient": (0.0, 0.0, 1.0)}

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        radius, count = check_search(self.params["radius"], self.params["max_nn"])
        if math.isfinite(radius):
            self.reach = radius
        else:
            self.neighbors = count
        orient = self.params["orient"]
        if isinstance(orient, str) and orient != "up":
            raise ValueError(f"steps: orient: expected 'up', a direction or None, got {shown(orient)}")
        orient = (0.0, 0.0, 1.0) if isinstance(orient, str) else orient
        self.params["orient"] = None if orient is None else check_direction("orient", orient).tolist()

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        cloud = part.cloud.estimate_normals(radius=self.params["radius"], max_nn=self.params["max_nn"])
        if self.params["orient"] is not None:
            cloud = cloud.orient_normals_to_align_with_direction(self.params["orient"])
        return dataclasses.replace(part, cloud=cloud)
