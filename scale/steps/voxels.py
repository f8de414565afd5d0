"""Voxels of a grid that the plan fixes."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from ...core.checks import check_finite, check_positive, check_shape
from ...kernels.memory import download
from ..exact_sums import ExactSums
from .step import Part, Step


class VoxelDownSample(Step):
    """Means of voxels of a grid that the plan fixes; a voxel is of the tile that its middle is in."""

    name, required = "voxel_down_sample", ("voxel_size",)
    defaults: ClassVar[dict[str, Any]] = {"corner": None}

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        self.size = check_positive("voxel_size", self.params["voxel_size"])
        self.reach = self.size / 2
        if self.params["corner"] is not None:
            corner = check_finite("corner", check_shape("corner", self.params["corner"], (3,)))
            self.params["corner"] = corner.tolist()

    def spread_after(self, spread: float) -> float:
        """Means lie in their voxel, whose middle is their home."""
        return self.size / 2

    def halo_before(self, after: float, spread: float, reach: float) -> float:
        """Whole voxels are wanted."""
        return after + reach + spread

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        corner = np.array(self.params["corner"] or plan.voxel_corner, np.float64)
        trace = part.cloud.voxel_down_sample_and_trace(self.size, min_bound=corner)
        offsets, order = np.asarray(trace.offsets), np.asarray(trace.indices)
        firsts = download(part.cloud.device_array("points"))[order[offsets[:-1]]].astype(np.float64)
        cells = np.floor((firsts - (corner - part.cloud.origin)) / self.size)
        homes = corner[:2] + (cells[:, :2] + 0.5) * self.size
        return Part(trace.cloud, None, homes, self.spread_after(part.spread))
