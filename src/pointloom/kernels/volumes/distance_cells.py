"""Voxels that contain points, or are set in a dense box.

Coordinates are rounded down in float64 from one sum and one quotient.
"""

from ..array_types import Cells, Mask, Points
from ..arrays.select import positions_of
from ..lang import array, compute, float64, floor, func, int32, isfinite, kernel, tid, vec3, vec3d, vec3i

NOT_FINITE_CELL = 1 << 30  # coordinate for a point that is not finite
OUT_OF_RANGE_CELL = 1 << 29  # coordinate for a point out of range
MAX_CELL = 2.0**29


@func
def cell_number(x: float64) -> int:
    """Voxel coordinate along an axis. BEYOND if it exceeds int32."""
    number = OUT_OF_RANGE_CELL
    if abs(x) < MAX_CELL:
        number = int(floor(x))
    return number


@kernel
def find_cells_kernel(points: array(dtype=vec3), shift: vec3d, voxel_size: float64, cells: array(dtype=vec3i)):
    """Voxel of each point. NOWHERE if it is not finite."""
    i = tid()
    p = points[i]
    cell = vec3i(NOT_FINITE_CELL, NOT_FINITE_CELL, NOT_FINITE_CELL)
    if isfinite(p):
        x = (float64(p[0]) + shift[0]) / voxel_size
        y = (float64(p[1]) + shift[1]) / voxel_size
        z = (float64(p[2]) + shift[2]) / voxel_size
        cell = vec3i(cell_number(x), cell_number(y), cell_number(z))
    cells[i] = cell


@kernel
def find_set_cells_kernel(rows: array(dtype=int32), size: vec3i, cells: array(dtype=vec3i)):
    i = tid()
    r = rows[i]
    cells[i] = vec3i(r // (size[1] * size[2]), (r // size[2]) % size[1], r % size[2])


def find_cells(points: Points, shift: tuple[float, float, float], voxel_size: float) -> Cells:
    """Voxels that contain points. Coordinates start at -shift."""
    return compute(find_cells_kernel, points.size, [points, vec3d(*shift), voxel_size], vec3i, points.device)


def find_set_cells(occupied: Mask, shape: tuple[int, int, int]) -> Cells:
    """Occupied voxels of a dense box, uint8, z fastest. One sync."""
    rows = positions_of(occupied)  # sync
    return compute(find_set_cells_kernel, rows.size, [rows, vec3i(*shape)], vec3i, rows.device)
