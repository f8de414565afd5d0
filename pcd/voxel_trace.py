"""What voxel_down_sample_and_trace returns: the means, and which points fell where."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..kernels.memory import download

if TYPE_CHECKING:
    from .cloud import PointCloud


class VoxelTrace:
    """A down-sampled cloud of m points and where its points came from; unpacks like Open3D's tuple of three.

    `cloud, cubic_id, original_indices = trace` takes a list of m arrays, which is slow to make for millions of
    voxels; `indices` and `offsets` hold the same without one.

    Attributes:
        cloud: The mean of each voxel.
        cubic_id: The last point in each octant of each voxel, int32 [m, 8], -1 where an octant is empty. The octant is
            1 for the upper half of the voxel along x, plus 2 along y, plus 4 along z.
        voxel_of_point: The voxel of each point, int32 [n]; -1 for points that are not finite.
        indices: The points by voxel, int32 [points that are finite]; those of one voxel in ascending order.
        offsets: Where the points of each voxel begin in `indices`, int32 [m + 1].

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0.1, 0.1, 0.1], [5.0, 5.1, 5.2], [0.7, 0.1, 0.1]])
        >>> trace = cloud.voxel_down_sample_and_trace(1.0, min_bound=[0, 0, 0])
        >>> trace.voxel_of_point.tolist(), [rows.tolist() for rows in trace.original_indices]
        ([0, 1, 0], [[0, 2], [1]])
        >>> cloud, cubic_id, original_indices = trace
        >>> cubic_id[0].tolist()
        [0, 2, -1, -1, -1, -1, -1, -1]
    """

    def __init__(
        self,
        cloud: PointCloud,
        cubic_id: NDArray[np.int32],
        voxel_of_point: NDArray[np.int32],
        indices: NDArray[np.int32],
        offsets: NDArray[np.int32],
    ):
        self.cloud, self.cubic_id, self.voxel_of_point = cloud, cubic_id, voxel_of_point
        self.indices, self.offsets = indices, offsets

    @cached_property
    def original_indices(self) -> list[NDArray[np.int32]]:
        """The points of each voxel, ascending: views of `indices`, made when first asked for."""
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
