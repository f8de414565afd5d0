"""Float64 sums over points of clouds with origins: moments, and agreement of two poses."""

from typing import Any

import numpy as np

from ..algebra.transform import widen
from ..array_types import Array1, LongIntegers, Points
from ..arrays.packed_keys import key_index
from ..lang import array, float64, int64, mat33d, reduce, reduction, tid, vec2d, vec3, vec3d, vector
from ..memory import download
from ..search.nearest_point import NO_POINT

position_sums = vector(10, float64)


@reduction
def sum_positions(points: array(dtype=vec3), origin: vec3d) -> position_sums:
    """Count, coordinates and products xx xy xz yy yz zz of points about an origin."""
    i = tid()
    q = widen(points[i]) + origin
    x = q[0]
    y = q[1]
    z = q[2]
    return position_sums(1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)


@reduction
def sum_agreeing(
    source: array(dtype=vec3),
    target: array(dtype=vec3),
    nearest: array(dtype=int64),
    source_origin: vec3d,
    target_origin: vec3d,
    source_rotation: mat33d,
    source_shift: vec3d,
    target_rotation: mat33d,
    target_shift: vec3d,
    limit: float64,
) -> vec2d:
    """Count of points with a nearest one, and of pairs within the root of `limit` [m^2] under two poses."""
    i = tid()
    total = vec2d(0.0, 0.0)
    key = nearest[i]
    if key != int64(NO_POINT):
        p = source_rotation @ (widen(source[i]) + source_origin) + source_shift
        q = target_rotation @ (widen(target[key_index(key)]) + target_origin) + target_shift
        d = p - q
        total[0] = 1.0
        if d[0] * d[0] + d[1] * d[1] + d[2] * d[2] <= limit:
            total[1] = 1.0
    return total


def position_moments(points: Points, origin: np.ndarray) -> np.ndarray:
    """Count, coordinate sums and sums of products, float64 (10) on the host. One sync."""
    return download(reduce(sum_positions, points.size, [points, vec3d(*origin)]))[0].copy()  # sync


def count_agreeing(
    source: Points,
    target: Points,
    nearest: LongIntegers,
    origins: tuple[np.ndarray, np.ndarray],
    poses: tuple[np.ndarray, np.ndarray],
    distance: float,
) -> Array1[Any]:
    """Count of pairs and of those within `distance` [m] (inclusive) under the poses: vec2d (1)."""
    transforms = [part for T in poses for part in (mat33d(*T[:3, :3].ravel()), vec3d(*T[:3, 3]))]
    arguments = [source, target, nearest, *(vec3d(*origin) for origin in origins), *transforms, distance * distance]
    return reduce(sum_agreeing, source.size, arguments)
