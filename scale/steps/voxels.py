"""Voxels of a grid that the plan fixes."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

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
        firsts = download(part.cloud._device_array("points"))[order[offsets[:-1]]].astype(np.float64)
        cells = np.floor((firsts - (corner - part.cloud.origin)) / self.size)
        homes = corner[:2] + (cells[:, :2] + 0.5) * self.size
        keys = self._keys(cells, corner, plan, part)
        return Part(trace.cloud, None, homes, self.spread_after(part.spread), keys=keys)

    def _keys(
        self, cells: NDArray[np.float64], corner: NDArray[np.float64], plan: Any, part: Part
    ) -> NDArray[np.int64] | None:
        """Numbers of voxels, x slowest as in the cloud; None where 64 bits are too few."""
        ends = (np.array([plan.told["low"], plan.told["high"]]) - corner) / self.size
        beyond = 2 + np.ceil((plan.slack + part.spread) / self.size)  # voxels, for what is rounded and what has moved
        low, high = np.floor(ends[0]) - beyond, np.floor(ends[1]) + beyond
        shape = [int(n) for n in high - low + 1]
        if math.prod(shape) >= 2**63:
            return None
        x, y, z = np.clip(cells - low, 0, high - low).astype(np.int64).T
        return (x * shape[1] + y) * shape[2] + z
