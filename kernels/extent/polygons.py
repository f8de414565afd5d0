"""Which points lie in a polygon swept along an axis, in float64 of world coordinates.

The even-odd rule with Open3D's arithmetic (SelectionPolygonVolume.cpp): an edge counts where it starts below v and ends
at v or above, or the other way round, and meets the line of the point at less than u. A thread a point: 12 B read, 1 B
written, 8 operations for each corner.
"""

import numpy as np

from ..algebra.transform import widen
from ..array_types import AnyArray, Array1, Mask
from ..lang import array, float64, func, isfinite, kernel, launch, tid, uint8, vec2d, vec3, vec3d, vec3i
from ..memory import empty


@func
def component(p: vec3d, axis: int) -> float64:
    """A coordinate, chosen by comparisons: a computed index would put the vector into local memory on CUDA."""
    x = p[0]
    if axis == 1:
        x = p[1]
    if axis == 2:
        x = p[2]
    return x


@func
def crossings_below(u: float64, v: float64, corners: array(dtype=vec2d)) -> int:
    """How many edges of the polygon meet the line of constant v at less than u."""
    found = 0
    a = corners[corners.shape[0] - 1]
    for i in range(corners.shape[0]):
        b = corners[i]
        if (a[1] < v and b[1] >= v) or (b[1] < v and a[1] >= v):
            if a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) < u:
                found += 1
        a = b
    return found


@func
def lies_in_volume(p: vec3d, corners: array(dtype=vec2d), axes: vec3i, low: float64, high: float64) -> int:
    """1 inside; points that are not finite are outside."""
    inside = 0
    w = component(p, axes[2])
    if isfinite(p) and w >= low and w <= high:
        inside = crossings_below(component(p, axes[0]), component(p, axes[1]), corners) & 1
    return inside


@kernel
def mask_local_kernel(
    points: array(dtype=vec3),
    origin: vec3d,
    corners: array(dtype=vec2d),
    axes: vec3i,
    low: float64,
    high: float64,
    mask: array(dtype=uint8),
):
    """1 where a point about an origin lies in the volume."""
    i = tid()
    mask[i] = uint8(lies_in_volume(widen(points[i]) + origin, corners, axes, low, high))


@kernel
def mask_world_kernel(
    points: array(dtype=vec3d),
    corners: array(dtype=vec2d),
    axes: vec3i,
    low: float64,
    high: float64,
    mask: array(dtype=uint8),
):
    """1 where a point in float64 lies in the volume."""
    i = tid()
    mask[i] = uint8(lies_in_volume(points[i], corners, axes, low, high))


def mask_polygon(
    points: AnyArray, origin: np.ndarray, corners: Array1[vec2d], axes: tuple[int, int, int], low: float, high: float
) -> Mask:
    """Mark the points in a volume.

    Args:
        points: Device array of vec3 about `origin`, or of vec3d in world coordinates.
        origin: float64 [3]; of no account for vec3d.
        corners: Device array of vec2d, the polygon's corners (u, v).
        axes: Which coordinates are u, v, and the axis of the volume.
        low, high: The volume's ends along its axis [m], both inclusive.

    Returns:
        uint8 device array of shape [n].
    """
    mask = empty(points.size, uint8, points.device)
    volume = [corners, vec3i(*axes), low, high, mask]
    if points.dtype == vec3:
        launch(mask_local_kernel, points.size, [points, vec3d(*origin), *volume])
    else:
        launch(mask_world_kernel, points.size, [points, *volume])
    return mask
