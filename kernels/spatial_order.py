"""Points in the order of a Hilbert curve: neighbours in space become neighbours in memory.

Source: Skilling, "Programming the Hilbert curve", AIP Conf. Proc. 707, 2004 (AxesToTranspose). 12 B read and 8 B
written a point, about 12 operations a level. The curve only chooses an order; nothing depends on its resolution but
speed.
"""

import numpy as np

from .bounds import bound_points
from .lang import array, func, int64, isfinite, kernel, launch, tid, vec3
from .memory import empty
from .sort import argsort_keys

MAX_LEVELS = 16  # 65,536 cells an axis: a millimetre in a city block


@func
def spread_bits(v: int) -> int64:
    """Two zeros between the lowest 16 bits of v."""
    x = int64(v)
    x = (x | (x << int64(32))) & int64(0x1F00000000FFFF)
    x = (x | (x << int64(16))) & int64(0x1F0000FF0000FF)
    x = (x | (x << int64(8))) & int64(0x100F00F00F00F00F)
    x = (x | (x << int64(4))) & int64(0x10C30C30C30C30C3)
    return (x | (x << int64(2))) & int64(0x1249249249249249)


@func
def hilbert_code(cx: int, cy: int, cz: int, levels: int) -> int64:
    """The place of a cell on the Hilbert curve through 2^levels cells an axis."""
    x = cx + 0
    y = cy + 0
    z = cz + 0
    q = 1 << (levels - 1)
    while q > 1:
        p = q - 1
        if (x & q) != 0:
            x = x ^ p
        if (y & q) != 0:
            x = x ^ p
        else:
            t = (x ^ y) & p
            x = x ^ t
            y = y ^ t
        if (z & q) != 0:
            x = x ^ p
        else:
            s = (x ^ z) & p
            x = x ^ s
            z = z ^ s
        q = q >> 1
    y = y ^ x
    z = z ^ y
    flip = int(0)
    q = 1 << (levels - 1)
    while q > 1:
        if (z & q) != 0:
            flip = flip ^ (q - 1)
        q = q >> 1
    x = x ^ flip
    y = y ^ flip
    z = z ^ flip
    return (spread_bits(x) << int64(2)) | (spread_bits(y) << int64(1)) | spread_bits(z)


@func
def locate_on_curve(p: vec3, low: vec3, scale: float, levels: int) -> int64:
    """The code of a point; points outside the box take the nearest cell."""
    top = float((1 << levels) - 1)
    x = int(min(max((p[0] - low[0]) * scale, 0.0), top))
    y = int(min(max((p[1] - low[1]) * scale, 0.0), top))
    z = int(min(max((p[2] - low[2]) * scale, 0.0), top))
    return hilbert_code(x, y, z, levels)


@kernel
def encode_points_kernel(points: array(dtype=vec3), low: vec3, scale: float, levels: int, codes: array(dtype=int64)):
    """The code of each point; points that are not finite come last."""
    i = tid()
    p = points[i]
    code = int64(1) << int64(3 * levels)
    if isfinite(p):
        code = locate_on_curve(p, low, scale, levels)
    codes[i] = code


class SpatialOrder:
    """The order of a cloud's finite points along the curve.

    Attributes:
        order: int32 [n], positions in the cloud by rank on the curve; points that are not finite stand last.
        codes: int64 [n], sorted.
        finite_count: Points that are finite.
        low, high: The box of the finite points, float32 [3].
        scale, levels: Cells a metre and levels of the curve.
    """

    def __init__(self, points):
        self.low, self.high, self.finite_count = bound_points(points)
        index_bits = max(1, (points.size - 1).bit_length()) if points.size else 1
        self.levels = min(MAX_LEVELS, (62 - index_bits) // 3)
        extent = float((self.high.astype(np.float64) - self.low).max()) if self.finite_count else 0.0
        # a box too small for a scale in float32 is one cell
        self.scale = (2**self.levels - 1) / extent if extent > 1e-33 else 0.0
        codes = empty(points.size, int64, points.device)
        low = vec3(*self.low) if self.finite_count else vec3(0.0)
        launch(encode_points_kernel, points.size, [points, low, self.scale, self.levels, codes])
        self.codes, self.order = argsort_keys(codes, 3 * self.levels + 1)
