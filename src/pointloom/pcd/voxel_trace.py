"""Result of voxel_down_sample_and_trace."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import pairwise
from typing import Any, Generic, TypeVar

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..kernels.memory import download
from .point_arrays import PointArrays

Cloud = TypeVar("Cloud", bound=PointArrays)


class VoxelTrace(Generic[Cloud]):
    """A down-sampled cloud of m points and the sources of its points.

    Unpacks as Open3D's `cloud, cubic_id, original_indices` (a list); `indices` and `offsets` contain the same.

    Attributes:
        cloud: Mean of each voxel.
        cubic_id: Last point in each octant, int32 (m, 8), -1 if empty. 1 (x) + 2 (y) + 4 (z) for upper halves.
        voxel_of_point: Voxel of each point, int32 (n,), or -1 for points that are not finite.
        indices: Finite points by voxel, ascending in each, int32.
        offsets: Start of each voxel in `indices`, int32 (m + 1,).
    """

    def __init__(
        self,
        cloud: Cloud,
        cubic_id: NDArray[np.int32],
        voxel_of_point: NDArray[np.int32],
        indices: NDArray[np.int32],
        offsets: NDArray[np.int32],
    ):
        self.cloud, self.cubic_id, self.voxel_of_point = cloud, cubic_id, voxel_of_point
        self.indices, self.offsets = indices, offsets

    @cached_property
    def original_indices(self) -> list[NDArray[np.int32]]:
        """Points of each voxel, ascending: views of `indices`."""
        if not len(self.cloud):
            return []
        if isinstance(self.indices, np.ndarray):
            return np.split(self.indices, self.offsets[1:-1])
        ends = (download(self.offsets) if isinstance(self.offsets, wp.array) else self.offsets).tolist()
        return [self.indices[first:end] for first, end in pairwise(ends)]

    def __len__(self) -> int:
        return 3

    def __iter__(self) -> Iterator[Any]:
        return iter((self.cloud, self.cubic_id, self.original_indices))

    def __repr__(self) -> str:
        return f"VoxelTrace({len(self.voxel_of_point):,} points in {len(self.cloud):,} voxels)"
