"""One point a cell of a fixed grid, for viewing."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from ...core.checks import check_finite, check_positive, check_shape
from ..exact_sums import ExactSums
from .function import ROW
from .step import Part, Step


class Thin(Step):
    """Of each cell of a grid that is fixed in space the point nearest to its middle stays."""

    name, required, searches = "thin", ("spacing",), False
    defaults: ClassVar[dict[str, Any]] = {"corner": (0.0, 0.0, 0.0)}

    def check(self) -> None:
        """Set the reach by the parameters: whole cells are wanted."""
        self.reach = check_positive("spacing", self.params["spacing"])
        self.params["corner"] = check_finite("corner", check_shape("corner", self.params["corner"], (3,))).tolist()

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        return thinned(part, self.reach, self.params["corner"])


def thinned(part: Part, spacing: float, corner: Any) -> Part:
    """A part with one point a cell."""
    cloud = part.cloud.copy()
    cloud[ROW] = np.arange(len(cloud))
    cloud = cloud.thin(spacing, corner)
    rows = np.asarray(cloud[ROW])
    del cloud.attributes[ROW]
    return part.take(rows, cloud)
