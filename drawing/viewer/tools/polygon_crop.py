"""A polygon drawn on the screen, and what it cuts out: Open3D's `cropped.json`, or just what is seen inside it.

A SelectionPolygonVolume is a prism along a coordinate axis; what a camera sees inside a polygon is a pyramid. The two
are brought together as far as they can be:

- The camera is put so far away along the axis (`view_along`), and its field of view made so narrow, that both are all
  but the same: over the whole depth of the cloud a point moves by less than a pixel on the screen.
- The corners are taken where their rays meet the plane halfway between the foremost and the last point that is seen
  inside the polygon, so that what remains of the difference is shared by the near and the far points.

In a free view the points that are seen inside are taken as they are; no file of Open3D's can hold that.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....cameras.camera import PinholeCameraIntrinsic
from ....core.checks import check_finite, check_rows, check_shape, check_transformation
from ....kernels.arrays.select import positions_of
from ....kernels.drawing.picking import mask_seen
from ....kernels.lang import vec2d
from ....kernels.memory import download, upload
from ....pcd.cloud import PointCloud
from ....pcd.point_arrays import check_cloud
from ....pcd.polygon_volume import MIN_CORNERS, SelectionPolygonVolume, mask_volume
from ...render.view import View, check_view
from .picking import T_camera_points, ray_through

AXES = "XYZ"
FAR = 500.0  # depths of what is seen that the camera is away: then perspective moves no point by a pixel
STRAIGHT = math.cos(math.radians(0.5))  # a camera turned farther than this does not look along an axis
MARGIN = 1.1  # how much more than the points is seen

Matrix = NDArray[np.float64]


def check_polygon(polygon: Any) -> NDArray[np.float64]:
    """The corners of a polygon [px], float64 [m, 2].

    Raises:
        ValueError: Fewer than three, another shape, numbers that are not finite, or no area: all on one line.
    """
    corners = check_finite("polygon", check_rows("polygon", polygon, 2, dtype=np.float64))
    if len(corners) < MIN_CORNERS:
        raise ValueError(f"polygon: expected at least three corners, got {len(corners)}; click on more places")
    spread = np.linalg.svd(corners - corners.mean(axis=0), compute_uv=False)
    if not spread[1] > 1e-9 * max(spread[0], 1e-300):
        raise ValueError("polygon: its corners lie on one line; click on a place beside it")
    return corners


def nearest_axis(view: View) -> tuple[str, int]:
    """The coordinate axis that a view looks along most nearly, "X", "Y" or "Z", and 1 or -1 for its direction."""
    forward = check_view(view).T_world_camera[:3, 2]
    axis = int(np.abs(forward).argmax())
    return AXES[axis], 1 if forward[axis] >= 0 else -1


def looks_along_axis(view: View) -> bool:
    """Whether a view looks along a coordinate axis, to half a degree."""
    return float(np.abs(view.T_world_camera[:3, 2]).max()) >= STRAIGHT


def view_along(view: View, low: Any, high: Any, axis: str | None = None) -> View:
    """The view along a coordinate axis, from far away, that shows a box whole.

    Args:
        view: Where one looks from now; which side of the axis, what is up and the size of the picture follow it.
        low, high: The box [m], float64 [3].
        axis: "X", "Y" or "Z"; None takes the nearest.

    Returns:
        A view from 500 times as far as the box is deep and high: all but orthographic.
    """
    corners = check_finite("low, high", np.array([check_shape("low", low, (3,)), check_shape("high", high, (3,))]))
    name, sign = nearest_axis(view)
    number = AXES.index(name if axis is None else axis)
    forward = np.zeros(3)
    forward[number] = sign if axis in (None, name) else -1.0  # along another axis: downwards, as maps and plans are
    upward = _upward(view, number)
    right = np.cross(forward, upward)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([right, -upward, forward])
    width, height = view.intrinsic.width, view.intrinsic.height
    extent = np.abs(corners[1] - corners[0])
    reach = max(extent @ np.abs(right) / width, extent @ np.abs(upward) / height)
    depth = float(extent @ np.abs(forward))
    pixel = MARGIN * (float(reach) or depth / height or 1.0 / height)  # [m]; a line along the axis has no width to fit
    distance = FAR * max(depth, pixel * height)
    focal = distance / pixel
    T[:3, 3] = corners.mean(axis=0) - distance * forward
    intrinsic = PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
    return View(intrinsic, T)


def _upward(view: View, axis: int) -> NDArray[np.float64]:
    """The coordinate direction across an axis that is most nearly up in a view."""
    up = -view.T_world_camera[:3, 1].copy()
    up[axis] = 0.0
    if not np.linalg.norm(up) > 0.1:  # turned towards the axis: what was forward is up then
        up = view.T_world_camera[:3, 2].copy()
        up[axis] = 0.0
    chosen, upward = int(np.abs(up).argmax()), np.zeros(3)
    upward[chosen] = 1.0 if up[chosen] >= 0 else -1.0
    return upward


def seen_inside(cloud: PointCloud, view: View, polygon: Any, *, pose: Any = None) -> NDArray[np.int32]:
    """The indices of the points that are seen inside a polygon, those hidden behind others among them; ascending.

    Args:
        cloud: The cloud.
        view: Where the polygon was drawn.
        polygon: Its corners [px], shape [m, 2]; the even-odd rule says what is inside.
        pose: From the cloud's coordinates to the world's, 4x4.

    Raises:
        TypeError: No cloud or no View.
        ValueError: A polygon of fewer than three corners or without an area, or a pose that cannot be inverted.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.drawing.render.view import fit_view
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 1, 1]])
        >>> view = fit_view(cloud.points, width=320, height=240)
        >>> seen_inside(cloud, view, [[0, 0], [319, 0], [319, 239], [0, 239]]).tolist()
        [0, 1]
    """
    check_cloud("cloud", cloud)
    check_view(view)
    corners = check_polygon(polygon)
    if not len(cloud):
        return np.empty(0, np.int32)
    T_world = np.eye(4) if pose is None else check_transformation("pose", pose)
    on_device = upload(corners, vec2d, cloud.device)
    T = T_camera_points(view, cloud, T_world)
    mask = mask_seen(cloud._device_array("points"), T, view.intrinsic, on_device)
    return download(positions_of(mask))  # sync


def polygon_to_volume(view: View, polygon: Any, points: Any, *, pose: Any = None) -> SelectionPolygonVolume:
    """The volume, as Open3D's editor saves it, that holds what is seen inside a polygon in a view along an axis.

    Args:
        view: Where the polygon was drawn; best one of `view_along`.
        polygon: Its corners [px], shape [m, 2].
        points: The cloud, or its points [n, 3]; they decide how deep the prism is and in which plane it is exact.
        pose: From the cloud's coordinates to the world's, 4x4; the volume is in the world.

    Returns:
        The volume along the nearest axis. As Open3D's, it reaches beyond the points by their extent on both sides, and
        its corners' coordinate along the axis is 0.

    Raises:
        ValueError: A view turned by more than half a degree from every axis, a polygon without an area, or points of
            which none is finite.
        TypeError: No View.

    Notes:
        The prism is exact for points in the plane halfway between the first and the last one seen inside the polygon
        (of all points, where none is). A point d in front of or behind that plane, which is D from the camera, is taken
        as if it were seen d / D of its distance from the picture's middle farther out or in: in a view of `view_along`
        less than a pixel.
    """
    check_view(view)
    corners = check_polygon(polygon)
    if not looks_along_axis(view):
        raise ValueError("view: turned away from the axes; look along x, y or z, or crop what is seen in a free view")
    cloud = points if isinstance(points, PointCloud) else PointCloud(points)
    axis, _ = nearest_axis(view)
    number = AXES.index(axis)
    low, high = _ends(cloud, pose, number)
    if low > high:
        raise ValueError("points: none of them is finite, so there is nothing to crop")
    inside = seen_inside(cloud, view, corners, pose=pose)
    first, last = _ends(cloud.select_by_index(inside), pose, number) if len(inside) else (low, high)
    volume_corners = [_meet(view, corner, number, (first + last) / 2) for corner in corners]
    return SelectionPolygonVolume(volume_corners, axis, low - (high - low), high + (high - low))


def _ends(cloud: PointCloud, pose: Any, axis: int) -> tuple[float, float]:
    """The least and the greatest coordinate along an axis of the finite points in the world; (inf, -inf) of none."""
    moved = cloud if pose is None else cloud.transform(check_transformation("pose", pose))
    finite = moved.remove_non_finite_points()
    if not len(finite):
        return math.inf, -math.inf
    return float(finite.get_min_bound()[axis]), float(finite.get_max_bound()[axis])


def _meet(view: View, corner: NDArray[np.float64], axis: int, level: float) -> NDArray[np.float64]:
    """Where the ray of a corner meets the plane across an axis at a level; the coordinate along the axis as 0."""
    eye, ray = ray_through(view, *corner)
    place = eye + (level - eye[axis]) / ray[axis] * ray
    place[axis] = 0.0
    return place


def indices_in_volume(cloud: PointCloud, volume: SelectionPolygonVolume, *, pose: Any = None) -> NDArray[np.int32]:
    """The indices of the points inside a volume of the world, ascending, as NumPy."""
    moved = cloud if pose is None else cloud.transform(check_transformation("pose", pose))
    return download(positions_of(mask_volume(volume, moved._device_array("points"), moved.origin)))  # sync
