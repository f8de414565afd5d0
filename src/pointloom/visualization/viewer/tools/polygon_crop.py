"""Polygons drawn on the screen as Open3D's SelectionPolygonVolume (`cropped.json`), or as a selection of points.

A volume is a prism along a coordinate axis, a polygon in a perspective view a pyramid. To match them, `view_along` uses
a distant camera with a narrow field of view (less than one pixel of error over the cloud's depth), and corners are
taken in the plane halfway through the points inside. In a free view the selected points have no equivalent file.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....cameras.camera import PinholeCameraIntrinsic
from ....core.checks import check_finite, check_rows, check_shape, check_transformation
from ....kernels.arrays.select import positions_of
from ....kernels.drawing.picking import mask_visible
from ....kernels.lang import vec2d
from ....kernels.memory import download, upload
from ....pcd.cloud import PointCloud
from ....pcd.point_arrays import check_cloud
from ....pcd.polygon_volume import MIN_CORNERS, SelectionPolygonVolume, mask_volume
from ...render.view import View, check_view
from .picking import T_camera_points, ray_through

AXES = "XYZ"
# distance of the camera in depths of the scene: perspective then moves no point by a pixel
CAMERA_DISTANCE_RATIO = 500.0
MIN_AXIS_COSINE = math.cos(math.radians(0.5))  # limit of `looks_along_axis`
VIEW_MARGIN = 1.1  # margin around the points

Matrix = NDArray[np.float64]


def check_polygon(polygon: ArrayLike) -> NDArray[np.float64]:
    """Corners of a polygon [px], float64 (m, 2). ValueError for fewer than 3, non-finite or collinear corners."""
    corners = check_finite("polygon", check_rows("polygon", polygon, 2, dtype=np.float64))
    if len(corners) < MIN_CORNERS:
        raise ValueError(f"polygon: expected at least three corners, got {len(corners)}; click on more points")
    spread = np.linalg.svd(corners - corners.mean(axis=0), compute_uv=False)
    if not spread[1] > 1e-9 * max(spread[0], 1e-300):
        raise ValueError("polygon: expected corners that are not collinear; click on a point beside the line")
    return corners


def nearest_axis(view: View) -> tuple[str, int]:
    """The coordinate axis closest to the viewing direction, "X", "Y" or "Z", and its sign."""
    forward = check_view(view).T_world_camera[:3, 2]
    axis = int(np.abs(forward).argmax())
    return AXES[axis], 1 if forward[axis] >= 0 else -1


def looks_along_axis(view: View) -> bool:
    """True if a view is along a coordinate axis to within 0.5 degrees."""
    return float(np.abs(view.T_world_camera[:3, 2]).max()) >= MIN_AXIS_COSINE


def view_along(view: View, low: ArrayLike, high: ArrayLike, axis: str | None = None) -> View:
    """Nearly orthographic view of a box along a coordinate axis, from 500 times its depth and height.

    Side, up direction and image size follow `view`; `axis` None takes the nearest axis.
    """
    corners = check_finite("low, high", np.array([check_shape("low", low, (3,)), check_shape("high", high, (3,))]))
    name, sign = nearest_axis(view)
    number = AXES.index(name if axis is None else axis)
    forward = np.zeros(3)
    forward[number] = sign if axis in (None, name) else -1.0  # along another axis: downwards, as in maps
    up_axis = _up_axis(view, number)
    right = np.cross(forward, up_axis)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([right, -up_axis, forward])
    width, height = view.intrinsic.width, view.intrinsic.height
    extent = np.abs(corners[1] - corners[0])
    scale = max(extent @ np.abs(right) / width, extent @ np.abs(up_axis) / height)
    depth = float(extent @ np.abs(forward))
    pixel = VIEW_MARGIN * (float(scale) or depth / height or 1.0 / height)  # [m]. A line along the axis has no width
    distance = CAMERA_DISTANCE_RATIO * max(depth, pixel * height)
    focal = distance / pixel
    T[:3, 3] = corners.mean(axis=0) - distance * forward
    intrinsic = PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
    return View(intrinsic, T)


def _up_axis(view: View, axis: int) -> NDArray[np.float64]:
    """The coordinate direction across an axis that is closest to up in a view."""
    up = -view.T_world_camera[:3, 1].copy()
    up[axis] = 0.0
    if not np.linalg.norm(up) > 0.1:  # parallel to the axis: use the forward direction
        up = view.T_world_camera[:3, 2].copy()
        up[axis] = 0.0
    chosen, up_axis = int(np.abs(up).argmax()), np.zeros(3)
    up_axis[chosen] = 1.0 if up[chosen] >= 0 else -1.0
    return up_axis


def seen_inside(
    cloud: PointCloud, view: View, polygon: ArrayLike, *, pose: ArrayLike | None = None
) -> NDArray[np.int32]:
    """Ascending indices of the points inside a polygon (m, 2) [px] (even-odd rule), including hidden points.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.visualization.render.view import fit_view
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
    mask = mask_visible(cloud.arrays["points"], T, view.intrinsic, on_device)
    return download(positions_of(mask))  # sync


def polygon_to_volume(
    view: View, polygon: ArrayLike, points: Any, *, pose: ArrayLike | None = None
) -> SelectionPolygonVolume:
    """Convert a polygon (m, 2) [px] in a view along an axis, preferably from `view_along`, to Open3D's volume.

    `points` (a cloud or (n, 3)) define depth and reference plane of the prism, which extends beyond them by their
    extent on both sides, as in Open3D. It is exact in the plane halfway through the points inside the polygon. A point
    at distance d from that plane is off by d / D of its distance from the image center, where D is the distance of the
    plane from the camera. Raises ValueError if the view is more than 0.5 degrees off every axis, the polygon has no
    area, or no point is finite.
    """
    check_view(view)
    corners = check_polygon(polygon)
    if not looks_along_axis(view):
        raise ValueError(
            "view: expected a view along an axis; look along x, y or z, or crop the visible points in a free view"
        )
    cloud = points if isinstance(points, PointCloud) else PointCloud(points)
    axis, _ = nearest_axis(view)
    number = AXES.index(axis)
    low, high = _ends(cloud, pose, number)
    if low > high:
        raise ValueError("points: expected at least one finite point, got none")
    inside = seen_inside(cloud, view, corners, pose=pose)
    first, last = _ends(cloud.select_by_index(inside), pose, number) if len(inside) else (low, high)
    volume_corners = [_meet(view, corner, number, (first + last) / 2) for corner in corners]
    return SelectionPolygonVolume(volume_corners, axis, low - (high - low), high + (high - low))


def _ends(cloud: PointCloud, pose: ArrayLike | None, axis: int) -> tuple[float, float]:
    """Lowest and highest world coordinate of the finite points along an axis; (inf, -inf) if none."""
    moved = cloud if pose is None else cloud.transform(check_transformation("pose", pose))
    finite = moved.remove_non_finite_points()
    if not len(finite):
        return math.inf, -math.inf
    return float(finite.get_min_bound()[axis]), float(finite.get_max_bound()[axis])


def _meet(view: View, corner: NDArray[np.float64], axis: int, level: float) -> NDArray[np.float64]:
    """Intersection of a corner's ray with the plane across an axis at a level, with 0 as coordinate along the axis."""
    eye, ray = ray_through(view, *corner)
    point = eye + (level - eye[axis]) / ray[axis] * ray
    point[axis] = 0.0
    return point


def indices_in_volume(
    cloud: PointCloud, volume: SelectionPolygonVolume, *, pose: ArrayLike | None = None
) -> NDArray[np.int32]:
    moved = cloud if pose is None else cloud.transform(check_transformation("pose", pose))
    return download(positions_of(mask_volume(volume, moved.arrays["points"], moved.origin)))  # sync
