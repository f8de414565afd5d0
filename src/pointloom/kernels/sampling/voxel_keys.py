"""64-bit voxel keys (only required bits per axis, 62 together), and the points of each voxel."""

from collections.abc import Sequence

import numpy as np

from ..array_types import Points
from ..arrays.few_keys import MAX_FEW, FewKeys, few_keys, group_few, sort_few
from ..arrays.sort import SortKeys, put_key
from ..arrays.unique import UniqueKeys
from ..lang import array, float64, floor, func, int64, isfinite, kernel, launch, tid, vec3, vec3d, vec3i, vector

cell = vector(3, int64)


@func
def cell_of(p: vec3, corner: vec3d, size: float64, axis: int) -> int64:
    return int64(floor((float64(p[axis]) - corner[axis]) / size))


@func
def voxel_key(p: vec3, corner: vec3d, size: float64, first: cell, bits: vec3i, skipped: int64) -> int64:
    key = skipped
    if isfinite(p):
        x = cell_of(p, corner, size, 0) - first[0]
        y = cell_of(p, corner, size, 1) - first[1]
        z = cell_of(p, corner, size, 2) - first[2]
        key = (((x << int64(bits[1])) | y) << int64(bits[2])) | z
    return key


@kernel
def encode_voxels_kernel(
    points: array(dtype=vec3), corner: vec3d, size: float64, first: cell, bits: vec3i, skipped: int64, keys: SortKeys
):
    """Keys with x in the high bits, then y, then z, from cell `first` on; `skipped` for non-finite points."""
    i = tid()
    put_key(i, voxel_key(points[i], corner, size, first, bits, skipped), keys)


@kernel(for_cpu=True)
def group_few_points_kernel(
    points: array(dtype=vec3), corner: vec3d, size: float64, first: cell, bits: vec3i, few: FewKeys
):
    """Keys as `encode_voxels_kernel`, and their groups without the non-finite points."""
    thread = tid()
    n = points.shape[0]
    skipped = int64(1) << int64(bits[0] + bits[1] + bits[2])
    for i in range(thread, n):
        few.keys[i] = voxel_key(points[i], corner, size, first, bits, skipped)
    sort_few(n, bits[0] + bits[1] + bits[2] + 1, few)
    group_few(n, skipped, few)


class VoxelGroups:
    """Points of each occupied voxel in key order: `order` int32 (n), stable; `starts` int32 (m + 1); `count` m."""

    def __init__(
        self,
        points: Points,
        corner: np.ndarray,
        size: float,
        cells: Sequence[float] | np.ndarray,
        first: Sequence[int] | np.ndarray = (0, 0, 0),
        name: str = "voxel_size",
    ) -> None:
        """Group finite points by cells of edge `size` [m] from `corner` [m]. Raises ValueError above 62 key bits."""
        bits = [63 if c > 2.0**62 else max(1, (int(c) - 1).bit_length()) for c in cells]
        if sum(bits) > 62:
            need = " x ".join(f"{c:,.0f}" if c < 1e15 else f"{c:.3g}" for c in cells)
            raise ValueError(f"{name}: {size} makes a grid of {need} cells, more than 2^62; take larger voxels")
        if points.device.is_cpu and 0 < points.size <= MAX_FEW:
            few = few_keys(points.size, points.device)
            launch(group_few_points_kernel, 1, [points, corner, size, first, bits, few])
            self.order, self.starts, self.count = few.taken()
            return
        keys = SortKeys(points.size, points.device)
        skipped = 1 << sum(bits)
        arguments = [points, corner, size, first, bits, skipped, keys]
        launch(encode_voxels_kernel, points.size, arguments)
        in_order = keys.sort(sum(bits) + 1)
        unique = UniqueKeys(in_order[0], in_order=in_order)
        unique.drop_last(skipped)
        self.order, self.starts, self.count = unique.order, unique.starts, unique.count
