"""Fewer points that stand for a cloud."""

from __future__ import annotations

from typing import Self

import numpy as np
import warp as wp

from ..kernels.bounds import bound_points
from ..kernels.lang import float64, int32
from ..kernels.memory import cast, upload
from ..kernels.segments import average_vec3, first_rows, sum_columns
from ..kernels.select import gather_rows
from ..kernels.voxel_keys import VoxelGroups
from .checks import check_positive
from .point_arrays import VECTORS
from .selection import Selection


class Sampling(Selection):
    """The part of PointCloud that thins a cloud."""

    def voxel_down_sample(self, voxel_size: float) -> Self:
        """One point for each occupied voxel: the mean of its points and of all their attributes.

        The grid starts half a voxel below the lowest corner, as Open3D's legacy form does. Means are summed in
        float64 in the order of the points, normals are not made unit again, and integer attributes take the value of
        the voxel's first point. Points that are not finite are dropped (Open3D emits a NaN point), and a NaN normal
        does not count in a mean (Open3D counts it in the divisor).

        Args:
            voxel_size: Edge of a voxel [m].

        Returns:
            The means in the order of the voxels, x slowest. O(n) memory, the same bits from run to run.

        Raises:
            ValueError: Not a positive number, or so small that the grid has more than 2^62 cells.
        """
        size = check_positive("voxel_size", voxel_size)
        points = self._arrays["points"]
        low, high, finite = bound_points(points)
        if not finite:
            return self._select(upload(np.zeros(0, np.int32), int32, self.device))
        corner = low.astype(np.float64) - size / 2
        with np.errstate(over="ignore"):
            cells = np.floor((high.astype(np.float64) - corner) / size) + 1
        groups = VoxelGroups(points, corner, size, cells)
        means: dict[str, wp.array] = {}
        rows = None
        for name, values in self._arrays.items():
            if name in VECTORS:
                means[name] = average_vec3(values, groups.order, groups.starts)
            elif np.dtype(wp.dtype_to_numpy(values.dtype)).kind == "f":
                means[name] = self._average(values, groups)
            else:
                rows = first_rows(groups.order, groups.starts) if rows is None else rows
                means[name] = gather_rows(values, rows)
        return self._with(means)

    # ------------------------------------------------------------------------------------------ internals

    def _average(self, values: wp.array, groups: VoxelGroups) -> wp.array:
        shape = values.shape
        columns = cast(values.reshape((shape[0], shape[1] if len(shape) > 1 else 1)), float64)
        means = sum_columns(columns, groups.order, groups.starts, mean=True)
        return cast(means, values.dtype).reshape((groups.count, *shape[1:]))
