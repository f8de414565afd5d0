"""Which of many points a click means, and which of them are seen inside a polygon drawn on the screen.

A click means the point in front that lies nearest to it. Two passes: the first finds the least depth z0 within the
reach of the click; the second the least of

    d^2 + (s / STEEPNESS)^2,    s = (z - z0) f / z0

over the points in reach, d being the distance on the screen [px] and s how far the point lies behind the foremost one,
in lengths that are a pixel wide there. So a point right under the click wins against nearer ones beside it on the same
surface, up to steep ones, and what lies behind the surface does not. Both passes keep the least of 64-bit words, the
number's bits above the point's index: the same point in any order of threads, ties to the smaller index.

A thread a point and pass: 12 B read, some 30 operations in float64, so that a view of a large cloud from nearby is
exact to what the cloud holds. Next to no atomics: only points in reach of the click offer themselves.
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

STEEPNESS = 10.0  # a surface that rises by this many lengths a length on the screen (84 degrees) still counts as one


@func
def see_point(p: vec3, T_camera_points: Transform, camera: Camera) -> vec3d:
    """Column, row and depth of a point; of one that is not before the camera, or not finite, the depth 0."""
    q = transform_point(widen(p), T_camera_points)
    seen = vec3d(0.0, 0.0, 0.0)
    if isfinite(q) and q[2] > 0.0:
        u = camera.fx * q[0] / q[2] + camera.cx
        v = camera.fy * q[1] / q[2] + camera.cy
        seen = vec3d(u, v, q[2])
    return seen


@func
def shown(i: int, hidden: array(dtype=uint8)) -> int:
    """1 unless the point is marked as hidden; no marks at all hide none."""
    visible = 1
    if hidden.shape[0] > 0:
        if int(hidden[i]) != 0:
            visible = 0
    return visible


@struct
class Click:
    """Where the user clicked, and what may be meant.

    Attributes:
        place: Column and row [px].
        sqradius: How far from it a point may be seen, squared [px^2].
        hidden: uint8 [n], not 0 where a point is hidden; empty where none is.
    """

    place: vec2d
    sqradius: float64
    hidden: array(dtype=uint8)

    def __init__(self, place: Sequence[float] | np.ndarray, radius: float, hidden: Mask) -> None:
        self.place, self.sqradius, self.hidden = vec2d(*place), float(radius) * float(radius), hidden


@func
def sqdist_to_click(i: int, p: vec3d, click: Click) -> float64:
    """How far from the click a seen point lies, squared [px^2]; -1 where it cannot be meant."""
    found = float64(-1.0)
    if p[2] > 0.0:
        x = p[0] - click.place[0]
        y = p[1] - click.place[1]
        sqdist = x * x + y * y
        if sqdist <= click.sqradius:
            if shown(i, click.hidden) == 1:
                found = sqdist
    return found


@kernel
def find_foremost_kernel(
    points: array(dtype=vec3), T_camera_points: Transform, camera: Camera, click: Click, word: array(dtype=int64)
):
    """Keep the least depth within the radius of the click; the atomic of offer_cell settles who comes first."""
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
    """Keep the point that the click means, given the least depth."""
    i = tid()
    p = see_point(points[i], T_camera_points, camera)
    sqdist = sqdist_to_click(i, p, click)
    if sqdist >= 0.0:
        behind = max(p[2] - foremost, 0.0) * camera.fx / (foremost * float64(STEEPNESS))
        offer_cell(0, float(sqdist + behind * behind), i, word)


@kernel
def mask_seen_kernel(
    points: array(dtype=vec3),
    T_camera_points: Transform,
    camera: Camera,
    corners: array(dtype=vec2d),
    mask: array(dtype=uint8),
):
    """1 where a point before the camera is seen inside the polygon, by the even-odd rule."""
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
    """1 for a point outside a box, behind a plane, or not finite."""
    i = tid()
    p = transform_point(widen(points[i]), T_world_points)
    outside = 1
    if isfinite(p):
        if p[0] >= low[0] and p[1] >= low[1] and p[2] >= low[2]:
            if p[0] <= high[0] and p[1] <= high[1] and p[2] <= high[2]:
                if normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] >= offset:
                    outside = 0
    mask[i] = uint8(outside)


def _least(kernel_of_pass: Kernel, points: Points, arguments: Sequence[Any]) -> tuple[float, int] | None:
    """The least word that a pass finds, as (number, index), or None; 1 sync."""
    word = full(1, NO_KEY, int64, points.device)
    launch(kernel_of_pass, points.size, [points, *arguments, word])
    found = download(word)  # sync
    if found[0] == NO_KEY:
        return None
    return float((found >> 32).astype("int32").view("float32")[0]), int(found[0] & 0xFFFFFFFF)


def find_foremost(
    points: Points,
    T_camera_points: np.ndarray,
    camera: CameraLike,
    click: Sequence[float] | np.ndarray,
    radius: float,
    hidden: Mask | None = None,
) -> float | None:
    """The least depth [m] of the points seen within a radius of a click.

    Args:
        points: Device array of vec3 [m].
        T_camera_points: float64 [4, 4], any affine map from the points' coordinates to the camera's.
        camera: A Camera, or what has its attributes.
        click: Column and row [px].
        radius: [px].
        hidden: uint8 [n] on the device, not 0 where a point is hidden; None hides none.

    Returns:
        The depth, or None where no point is in reach.
    """
    found = _least(find_foremost_kernel, points, _click(points, T_camera_points, camera, click, radius, hidden))
    return None if found is None else found[0]


def find_meant(
    points: Points,
    T_camera_points: np.ndarray,
    camera: CameraLike,
    click: Sequence[float] | np.ndarray,
    radius: float,
    foremost: float,
    hidden: Mask | None = None,
) -> tuple[float, int] | None:
    """The point that a click means.

    Args:
        points, T_camera_points, camera, click, radius, hidden: As of `find_foremost`.
        foremost: What it found, or the least of what it found for several clouds.

    Returns:
        (cost [px^2], index), the less the better, to compare among clouds; None where no point is in reach.
    """
    given = _click(points, T_camera_points, camera, click, radius, hidden)
    return _least(find_meant_kernel, points, [*given, float(foremost)])


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


def mask_seen(points: Points, T_camera_points: np.ndarray, camera: CameraLike, corners: Array1[vec2d]) -> Mask:
    """Mark the points that are seen inside a polygon on the screen.

    Args:
        points, T_camera_points, camera: As of `find_foremost`.
        corners: Device array of vec2d [px].

    Returns:
        uint8 device array of shape [n].
    """
    mask = empty(points.size, uint8, points.device)
    launch(mask_seen_kernel, points.size, [points, Transform(T_camera_points), camera, corners, mask])
    return mask


def mask_clipped(
    points: Points, T_world_points: np.ndarray, low: np.ndarray, high: np.ndarray, normal: np.ndarray, offset: float
) -> Mask:
    """Mark the points that clip planes hide.

    Args:
        points: Device array of vec3 [m].
        T_world_points: float64 [4, 4], from the points' coordinates to the world's.
        low, high: float64 [3], the ends of the box; may be infinite.
        normal: float64 [3], of the plane; zeros with an offset of -inf hide nothing.
        offset: What lies along the normal at less than this is hidden.

    Returns:
        uint8 device array of shape [n].
    """
    mask = empty(points.size, uint8, points.device)
    ends = [vec3d(*low), vec3d(*high), vec3d(*normal), float(offset)]
    launch(mask_clipped_kernel, points.size, [points, Transform(T_world_points), *ends, mask])
    return mask
