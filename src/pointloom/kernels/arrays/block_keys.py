"""Packed keys of blocks or grid cells, ordered by x, then y, then z."""

from ..lang import func, int64, vec3i

AXIS_BITS = 21
TWO_AXES = 2 * AXIS_BITS
CELL_BIAS = 1 << 20  # coordinates are in -2^20 .. 2^20 - 1


@func
def block_key(x: int, y: int, z: int) -> int64:
    high = (int64(x + CELL_BIAS) << int64(AXIS_BITS)) | int64(y + CELL_BIAS)
    return (high << int64(AXIS_BITS)) | int64(z + CELL_BIAS)


@func
def key_block(key: int64) -> vec3i:
    low = int64((1 << 21) - 1)
    x = int(key >> int64(TWO_AXES)) - CELL_BIAS
    y = int((key >> int64(AXIS_BITS)) & low) - CELL_BIAS
    z = int(key & low) - CELL_BIAS
    return vec3i(x, y, z)
