"""Voxels of positions, and short keys of voxels near a scanner, fast to sort."""

from collections.abc import Sequence

from ..algebra.transform import narrow
from ..lang import float64, floor, func, int64, struct, vec3, vec3d, vec3i


@func
def cell_holding(x: vec3d, size: float64) -> vec3i:
    return vec3i(int(floor(x[0] / size)), int(floor(x[1] / size)), int(floor(x[2] / size)))


@func
def offset_in_cell(x: vec3d, cell: vec3i, size: float64) -> vec3:
    """A position [m] relative to its voxel's low corner."""
    y = vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2])) * size
    return narrow(x - y)


@struct
class LocalCells:
    """A cube of voxels with short keys: `size` [m]; `first` voxel; `bits` per axis; `skipped`: key of no voxel."""

    size: float64
    first: vec3i
    bits: int
    skipped: int64

    def __init__(self, size: float, middle: Sequence[int], radius: int) -> None:
        """Voxels up to `radius` from the voxel `middle` along each axis."""
        self.size, self.first, self.bits = size, vec3i(*(c - radius for c in middle)), (2 * radius).bit_length()
        self.skipped, self.key_bits = 1 << (3 * self.bits), 3 * self.bits + 1


@func
def local_key(cell: vec3i, cells: LocalCells) -> int64:
    x = int64(cell[0] - cells.first[0])
    y = int64(cell[1] - cells.first[1])
    z = int64(cell[2] - cells.first[2])
    return (((x << int64(cells.bits)) | y) << int64(cells.bits)) | z


@func
def key_cell(key: int64, cells: LocalCells) -> vec3i:
    low = (1 << int64(cells.bits)) - 1
    x = int(key >> int64(2 * cells.bits)) + cells.first[0]
    y = int((key >> int64(cells.bits)) & low) + cells.first[1]
    z = int(key & low) + cells.first[2]
    return vec3i(x, y, z)
