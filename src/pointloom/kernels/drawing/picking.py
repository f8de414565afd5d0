"""Picking: the point selected by a click, and the points inside a screen polygon.

The first pass finds the least depth z0 within the click radius, the second the minimum of d^2 + (s / STEEPNESS)^2 with
s = (z - z0) f / z0, where d is the screen distance [px] and s the depth behind the foremost point in pixel widths.
Float64. Atomic minima over (number, index) words, ties to the smaller index.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algebra.camera import Camera, CameraLike
from ..algebra.transform import Transform, transform_point, widen
from ..array_types import Array1, Mask, Points
from ..arrays.packed_keys import NO_KEY, offer_cell
from ..extent.polygons import crossings_below
from ..lang import Kernel, array, float64, func, int64, isfinite, kernel, launch, struct, tid, uint8, vec2d, vec3, vec3d
from ..memory import download, empty, full

MAX_SURFACE_SLOPE = 10.0  # maximum slope relative to the screen (84 degrees) of a continuous surface


@func
def see_point(p: vec3, T_camera_points: Transform, camera: Camera) -> vec3d:
    """Column, row and depth of a point. Depth 0 if it is behind the camera or not finite."""
    q = transform_point(widen(p), T_camera_points)
    projected = vec3d(0.0, 0.0, 0.0)
    if isfinite(q) and q[2] > 0.0:
        u = camera.fx * q[0] / q[2] + camera.cx
        v = camera.fy * q[1] / q[2] + camera.cy
        projected = vec3d(u, v, q[2])
    return projected


@func
def is_displayed(i: int, hidden: array(dtype=uint8)) -> int:
    """1 unless the point is hidden. An empty mask hides none."""
    visible = 1
    if hidden.shape[0] > 0:
        if int(hidden[i]) != 0:
            visible = 0
    return visible


@struct
class Click:
    """Click position `position` [px], squared radius `sqradius` [px^2], and `hidden` uint8 (n), empty for none."""

    position: vec2d
    sqradius: float64
    hidden: array(dtype=uint8)

    def __init__(self, position: Sequence[float] | np.ndarray, radius: float, hidden: Mask) -> None:
        self.position, self.sqradius, self.hidden = vec2d(*position), float(radius) * float(radius), hidden


@func
def sqdist_to_click(i: int, p: vec3d, click: Click) -> float64:
    """Squared distance [px^2] from the click of a visible point, or -1 if it cannot be selected."""
    result = float64(-1.0)
    if p[2] > 0.0:
        x = p[0] - click.position[0]
        y = p[1] - click.position[1]
        sqdist = x * x + y * y
        if sqdist <= click.sqradius:
            if is_displayed(i, click.hidden) == 1:
                result = sqdist
    return result


@kernel
def find_foremost_kernel(
    points: array(dtype=vec3), T_camera_points: Transform, camera: Camera, click: Click, word: array(dtype=int64)
):
    """Least depth within the radius of the click (atomic minimum)."""
    i = tid()
    p = see_point(points[i], T_camera_points, camera)
    if sqdist_to_click(i, p, click) >= 0.0:
        offer_cell(0, float(p[2]), i, word)


@kernel
def find_meant_kernel(
    points: array(dtype=vec3),
    T_camera_points: Transform,
    camera: Camera,
    click: Click,
    foremost: float64,
    word: array(dtype=int64),
):
    """Select the point of the click, given the least depth."""
    i = tid()
    p = see_point(points[i], T_camera_points, camera)
    sqdist = sqdist_to_click(i, p, click)
    if sqdist >= 0.0:
        behind = max(p[2] - foremost, 0.0) * camera.fx / (foremost * float64(MAX_SURFACE_SLOPE))
        offer_cell(0, float(sqdist + behind * behind), i, word)


@kernel
def mask_visible_kernel(
    points: array(dtype=vec3),
    T_camera_points: Transform,
    camera: Camera,
    corners: array(dtype=vec2d),
    mask: array(dtype=uint8),
):
    """1 for points before the camera inside the polygon, by the even-odd rule."""
    i = tid()
    p = see_point(points[i], T_camera_points, camera)
    inside = 0
    if p[2] > 0.0:
        inside = crossings_below(p[0], p[1], corners) & 1
    mask[i] = uint8(inside)


@kernel
def mask_clipped_kernel(
    points: array(dtype=vec3),
    T_world_points: Transform,
    low: vec3d,
    high: vec3d,
    normal: vec3d,
    offset: float64,
    mask: array(dtype=uint8),
):
    """1 for points outside a box, behind a plane, or not finite."""
    i = tid()
    p = transform_point(widen(points[i]), T_world_points)
    outside = 1
    if isfinite(p):
        if p[0] >= low[0] and p[1] >= low[1] and p[2] >= low[2]:
            if p[0] <= high[0] and p[1] <= high[1] and p[2] <= high[2]:
                if normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] >= offset:
                    outside = 0
    mask[i] = uint8(outside)


def _minimum(kernel_of_pass: Kernel, points: Points, arguments: Sequence[Any]) -> tuple[float, int] | None:
    """The least (number, index) of a pass, or None. One sync."""
    word = full(1, NO_KEY, int64, points.device)
    launch(kernel_of_pass, points.size, [points, *arguments, word])
    word_on_host = download(word)  # sync
    if word_on_host[0] == NO_KEY:
        return None
    return float((word_on_host >> 32).astype("int32").view("float32")[0]), int(word_on_host[0] & 0xFFFFFFFF)


def find_foremost(
    points: Points,
    T_camera_points: np.ndarray,
    camera: CameraLike,
    click: Sequence[float] | np.ndarray,
    radius: float,
    hidden: Mask | None = None,
) -> float | None:
    """Least depth [m] of the points within `radius` [px] of a click, or None. Any affine `T_camera_points`."""
    nearest = _minimum(find_foremost_kernel, points, _click(points, T_camera_points, camera, click, radius, hidden))
    return None if nearest is None else nearest[0]


def find_meant(
    points: Points,
    T_camera_points: np.ndarray,
    camera: CameraLike,
    click: Sequence[float] | np.ndarray,
    radius: float,
    foremost: float,
    hidden: Mask | None = None,
) -> tuple[float, int] | None:
    """The selected point (cost [px^2], index), or None; `foremost` is the least `find_foremost` over the clouds."""
    given = _click(points, T_camera_points, camera, click, radius, hidden)
    return _minimum(find_meant_kernel, points, [*given, float(foremost)])


def _click(
    points: Points,
    T_camera_points: np.ndarray,
    camera: CameraLike,
    click: Sequence[float] | np.ndarray,
    radius: float,
    hidden: Mask | None,
) -> list[Any]:
    marks = empty(0, uint8, points.device) if hidden is None else hidden
    return [Transform(T_camera_points), camera, Click(click, radius, marks)]


def mask_visible(points: Points, T_camera_points: np.ndarray, camera: CameraLike, corners: Array1[vec2d]) -> Mask:
    """Mask, uint8 (n), of points inside a screen polygon with `corners` vec2d [px]."""
    mask = empty(points.size, uint8, points.device)
    launch(mask_visible_kernel, points.size, [points, Transform(T_camera_points), camera, corners, mask])
    return mask


def mask_clipped(
    points: Points, T_world_points: np.ndarray, low: np.ndarray, high: np.ndarray, normal: np.ndarray, offset: float
) -> Mask:
    """Mask, uint8 (n), of points hidden by clip planes: outside `low`..`high`, or below `offset` along `normal`."""
    mask = empty(points.size, uint8, points.device)
    ends = [vec3d(*low), vec3d(*high), vec3d(*normal), float(offset)]
    launch(mask_clipped_kernel, points.size, [points, Transform(T_world_points), *ends, mask])
    return mask
