"""The voxels in which points lie, and those that are set in a dense box: 12 B a voxel, one thread each.

A coordinate is rounded down in float64 from a float32 position, the shift of the origins and the voxel's size, by one
sum and one quotient: exact at any coordinates.
"""

from ..array_types import Cells, Mask, Points
from ..arrays.select import positions_of
from ..lang import array, float64, floor, func, int32, isfinite, kernel, launch, tid, vec3, vec3d, vec3i
from ..memory import empty

NOWHERE = 1 << 30  # the coordinate of a point that is not finite
BEYOND = 1 << 29  # of one that is too far away
WIDEST = 2.0**29


@func
def cell_number(x: float64) -> int:
    """The coordinate of a voxel along one axis; BEYOND where 32 bits would not hold it."""
    number = BEYOND
    if abs(x) < WIDEST:
        number = int(floor(x))
    return number


@kernel
def find_cells_kernel(points: array(dtype=vec3), shift: vec3d, voxel_size: float64, cells: array(dtype=vec3i)):
    """The voxel of each point; NOWHERE where it is not finite."""
    i = tid()
    p = points[i]
    cell = vec3i(NOWHERE, NOWHERE, NOWHERE)
    if isfinite(p):
        x = (float64(p[0]) + shift[0]) / voxel_size
        y = (float64(p[1]) + shift[1]) / voxel_size
        z = (float64(p[2]) + shift[2]) / voxel_size
        cell = vec3i(cell_number(x), cell_number(y), cell_number(z))
    cells[i] = cell


@kernel
def find_set_cells_kernel(rows: array(dtype=int32), size: vec3i, cells: array(dtype=vec3i)):
    """The voxels of a dense box that stand at some places of it, z fastest."""
    i = tid()
    r = rows[i]
    cells[i] = vec3i(r // (size[1] * size[2]), (r // size[2]) % size[1], r % size[2])


def find_cells(points: Points, shift: tuple[float, float, float], voxel_size: float) -> Cells:
    """The voxels in which points lie, whose coordinates count from -shift."""
    cells = empty(points.size, vec3i, points.device)
    launch(find_cells_kernel, points.size, [points, vec3d(*shift), voxel_size, cells])
    return cells


def find_set_cells(occupied: Mask, shape: tuple[int, int, int]) -> Cells:
    """The occupied voxels of a dense box, uint8, z fastest; one sync."""
    rows = positions_of(occupied)  # sync
    cells = empty(rows.size, vec3i, rows.device)
    launch(find_set_cells_kernel, rows.size, [rows, vec3i(*shape), cells])
    return cells
