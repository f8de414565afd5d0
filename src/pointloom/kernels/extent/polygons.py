"""Points in a polygon swept along an axis: even-odd rule with Open3D's arithmetic (SelectionPolygonVolume.cpp)."""

import numpy as np

from ..algebra.transform import widen
from ..array_types import AnyArray, Array1, Mask
from ..lang import array, float64, func, isfinite, kernel, launch, tid, uint8, vec2d, vec3, vec3d, vec3i
from ..memory import empty


@func
def component(p: vec3d, axis: int) -> float64:
    """Coordinate by comparisons: a computed index would put the vector into local memory on CUDA."""
    x = p[0]
    if axis == 1:
        x = p[1]
    if axis == 2:
        x = p[2]
    return x


@func
def crossings_below(u: float64, v: float64, corners: array(dtype=vec2d)) -> int:
    """Polygon edges that cross the line of constant v below u."""
    crossings = 0
    a = corners[corners.shape[0] - 1]
    for i in range(corners.shape[0]):
        b = corners[i]
        if (a[1] < v and b[1] >= v) or (b[1] < v and a[1] >= v):
            if a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) < u:
                crossings += 1
        a = b
    return crossings


@func
def is_in_volume(p: vec3d, corners: array(dtype=vec2d), axes: vec3i, low: float64, high: float64) -> int:
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
    i = tid()
    mask[i] = uint8(is_in_volume(widen(points[i]) + origin, corners, axes, low, high))


@kernel
def mask_world_kernel(
    points: array(dtype=vec3d),
    corners: array(dtype=vec2d),
    axes: vec3i,
    low: float64,
    high: float64,
    mask: array(dtype=uint8),
):
    i = tid()
    mask[i] = uint8(is_in_volume(points[i], corners, axes, low, high))


def mask_polygon(
    points: AnyArray, origin: np.ndarray, corners: Array1[vec2d], axes: tuple[int, int, int], low: float, high: float
) -> Mask:
    """Mask of points (about `origin`, or vec3d in world coordinates) in a volume; `axes`: u, v and volume axis."""
    mask = empty(points.size, uint8, points.device)
    volume = [corners, vec3i(*axes), low, high, mask]
    if points.dtype == vec3:
        launch(mask_local_kernel, points.size, [points, vec3d(*origin), *volume])
    else:
        launch(mask_world_kernel, points.size, [points, *volume])
    return mask
