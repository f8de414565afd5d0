"""The shape of each point's neighbourhood."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, ClassVar

from ...core.checks import check_search, shown
from ...core.known_names import nearest_name
from ...kernels.features.eigen_features import SHAPES
from ...pcd.features import compute_eigen_features
from ..exact_sums import ExactSums
from .step import Part, Step

NAMES = ("eigenvalues", *SHAPES)


class Features(Step):
    """Linearity, planarity and the others of `compute_eigen_features`, those that are named or all."""

    name = "features"
    defaults: ClassVar[dict[str, Any]] = {"radius": None, "max_nn": 30, "names": SHAPES}

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        radius, count = check_search(self.params["radius"], self.params["max_nn"])
        if math.isfinite(radius):
            self.reach = radius
        else:
            self.neighbors = count
        names = self.params["names"]
        names = [names] if isinstance(names, str) else names
        if not isinstance(names, list | tuple) or not names:
            raise ValueError(f"steps: names: expected some of {', '.join(NAMES)}, got {shown(names)}")
        for name in names:
            if name not in NAMES:
                raise ValueError(f"steps: names: there is no feature {shown(name)}{nearest_name(name, NAMES)}")
        self.params["names"] = [*dict.fromkeys(names)]

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        found = compute_eigen_features(part.cloud, radius=self.params["radius"], max_nn=self.params["max_nn"])
        cloud = part.cloud.copy()
        for name in self.params["names"]:
            cloud[name] = found[name]
        return dataclasses.replace(part, cloud=cloud)
