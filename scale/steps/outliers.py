"""Points that stand apart."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_positive
from ...kernels.memory import download
from ...kernels.search.neighbor_distances import average_distances
from ...kernels.segmentation.neighbor_counts import mask_crowded
from ...pcd.selection import ROUNDING
from ..exact_sums import ExactSums
from .step import Part, Step


class RadiusOutlier(Step):
    """Points with few neighbours go."""

    name, required = "remove_radius_outlier", ("nb_points", "radius")

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        check_count("nb_points", self.params["nb_points"])
        self.reach = check_positive("radius", self.params["radius"])

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        mask = mask_crowded(part.cloud.search_tree(), self.reach, self.params["nb_points"] + 1)
        return part.select(download(mask) != 0)


class StatisticalOutlier(Step):
    """Points whose neighbours are farther away than is usual in all tiles go."""

    name, required, needs_numbers = "remove_statistical_outlier", ("nb_neighbors", "std_ratio"), True

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        self.neighbors = check_count("nb_neighbors", self.params["nb_neighbors"])
        check_positive("std_ratio", self.params["std_ratio"])

    def measure(self, part: Part) -> NDArray[np.float64]:
        """Mean distances of the nearest."""
        assert self.neighbors is not None
        return download(average_distances(part.cloud.search_tree(), self.neighbors))

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        assert numbers is not None
        mean, deviation = numbers.mean_and_deviation()
        limit = (mean + self.params["std_ratio"] * deviation) * ROUNDING if numbers.count else 0.0
        return part.select(self.measure(part) <= limit)
