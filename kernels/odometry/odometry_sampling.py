"""The points of a scan that odometry works with: those in range, then the first of each voxel.

A point is kept where it was measured, not moved to a mean: Vizzo et al. 2023, "KISS-ICP", section III-B. "First" is
by the points' own order, so the choice does not depend on threads. One sort of 64-bit keys over the scan.
"""

import math

from ..algebra.transform import narrow, widen
from ..arrays.select import gather_rows, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import array, float64, int64, isfinite, kernel, launch, tid, uint8, vec3, vec3d
from ..memory import empty, zeros
from .local_cells import LocalCells, cell_holding, local_key


@kernel
def shift_points_kernel(points: array(dtype=vec3), origin: vec3d, out: array(dtype=vec3)):
    """The points about zero."""
    i = tid()
    out[i] = narrow(widen(points[i]) + origin)


@kernel
def encode_in_range_kernel(
    points: array(dtype=vec3), least: float64, most: float64, cells: LocalCells, keys: array(dtype=int64)
):
    """The voxel of each point whose distance from the sensor lies in least..most, both excluded."""
    i = tid()
    p = points[i]
    key = cells.skipped + int64(0)
    if isfinite(p):
        x = widen(p)
        sqdist = x[0] * x[0] + x[1] * x[1] + x[2] * x[2]
        if sqdist > least * least and sqdist < most * most:
            key = local_key(cell_holding(x, cells.size), cells)
    keys[i] = key


@kernel
def mark_firsts_kernel(groups: UniqueKeys, marks: array(dtype=uint8)):
    """1 at the first point of each voxel."""
    i = tid()
    marks[groups.order[groups.starts[i]]] = uint8(1)


def shift_points(points, origin):
    """The points about zero instead of about an origin [3]; the array itself where that is zero."""
    if not any(origin):
        return points
    out = empty(points.size, vec3, points.device)
    launch(shift_points_kernel, points.size, [points, vec3d(*origin), out])
    return out


def first_in_voxels(points, voxel_size, least, most):
    """The first point of each voxel among those in range, in their own order.

    Args:
        points: Device array of vec3 about the sensor.
        voxel_size: Edge of a voxel [m]; voxels are counted from the sensor.
        least, most: Range [m], both excluded; points at exactly zero are no measurements even if `least` is 0.

    Returns:
        Device array of vec3.

    Raises:
        ValueError: The range has more than 2^20 voxels an axis.
    """
    if points.size == 0:
        return points
    reach = math.ceil(most / voxel_size) + 1
    cells = LocalCells(voxel_size, (0, 0, 0), reach)
    if cells.bits > 20:
        raise ValueError(f"voxel_size: {voxel_size} makes {2 * reach:,} voxels of the range; take larger ones")
    keys = empty(points.size, int64, points.device)
    launch(encode_in_range_kernel, points.size, [points, least, most, cells, keys])
    groups = UniqueKeys(keys, cells.key_bits)  # sync
    groups.drop_last(cells.skipped)  # sync
    marks = zeros(points.size, uint8, points.device)
    launch(mark_firsts_kernel, groups.count, [groups, marks])
    return gather_rows(points, positions_of(marks))  # sync
