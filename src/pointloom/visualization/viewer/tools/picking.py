"""Picking of points and surfaces by clicks. All points of a cloud are searched, also those that are not drawn.

Screen positions are in the pixels of a View. Integers are pixel centers.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.checks import check_number, check_positive, check_transformation
from ....kernels.drawing import picking
from ....meshing.scene.raycasting_scene import RaycastingScene
from ....pcd.cloud import PointCloud
from ...render.view import View, check_view

CLICK_RADIUS = 6.0  # [px] tolerance of a click
Matrix = NDArray[np.float64]
PointQuery = tuple[Any, Matrix, Any, tuple[float, float], float]  # input of the passes over a cloud's points
Rows = list[tuple[str, str]]  # labels and values of a point


@dataclasses.dataclass(frozen=True, eq=False)
class Target:
    """A named object that can be picked: a cloud with a mask of hidden points, or the raycasting scene of a mesh.

    `pose` is object to world, 4x4. None for identity.
    """

    name: str
    cloud: PointCloud | None = None
    scene: RaycastingScene | None = None
    pose: Matrix | None = None
    hidden: Any = None


@dataclasses.dataclass(frozen=True, eq=False)
class Pick:
    """Result of a click.

    Attributes:
        name: Name of the target.
        index: Index of the point in its cloud, or None on a surface.
        point: World position [m], float64 (3,).
        triangle: Index of the triangle on a surface, else None.
        attributes: Attributes of the point by name, including "color" and "normal". For `Viewer.on_pick`.
    """

    name: str
    index: int | None
    point: NDArray[np.float64]
    triangle: int | None = None
    attributes: Mapping[str, Any] = dataclasses.field(default_factory=dict)


def pick(targets: Iterable[Target], view: View, x: float, y: float, *, radius: float = CLICK_RADIUS) -> Pick | None:
    """Pick among several clouds and meshes. Surfaces hide objects behind them.

    Of a cloud, the nearest point on the screen among those in front is picked. Each 10 pixel widths of depth behind the
    foremost point within `radius` [px] count as one pixel of distance. So the point under the click is chosen on any
    surface up to 84 degrees of slope, and no point behind a surface. Of points at the same screen position, the
    smallest index wins. Raises TypeError or ValueError.

    Notes:
        Two passes over the points, 24 B per point, 1 sync each. Deterministic on every device.
    """
    check_view(view)
    click = check_number("x", x), check_number("y", y)
    radius = check_positive("radius", radius)
    clouds: list[tuple[Target, Matrix, float]] = []
    surfaces: list[tuple[float, Pick]] = []
    for target in targets:
        T_world = np.eye(4) if target.pose is None else check_transformation("pose", target.pose)
        if target.cloud is not None and len(target.cloud):
            T = T_camera_points(view, target.cloud, T_world)
            depth = picking.find_foremost(*_point_query(target, T, view, click, radius), hidden=target.hidden)
            if depth is not None:
                clouds.append((target, T, depth))
        elif target.scene is not None:
            surfaces += _surface_at(target, T_world, view, *click)
    if not clouds and not surfaces:
        return None
    foremost = min([depth for *_, depth in clouds] + [depth for depth, _ in surfaces])
    best: tuple[float, Pick] | None = None
    for depth, met in surfaces:
        behind = (depth - foremost) * view.intrinsic.fx / (foremost * picking.MAX_SURFACE_SLOPE)
        if best is None or behind * behind < best[0]:
            best = behind * behind, met
    for target, T, _ in clouds:
        hit = picking.find_meant(*_point_query(target, T, view, click, radius), foremost, hidden=target.hidden)
        if hit is not None and (best is None or hit[0] < best[0]):
            best = hit[0], Pick(target.name, hit[1], world_point(target, hit[1]))
    return None if best is None else best[1]


def _point_query(target: Target, T: Matrix, view: View, click: tuple[float, float], radius: float) -> PointQuery:
    assert target.cloud is not None
    return target.cloud.arrays["points"], T, view.intrinsic, click, radius


def T_camera_points(view: View, cloud: PointCloud, T_world: Matrix) -> Matrix:
    """Transformation from the stored positions of a cloud (relative to its origin) to the camera; float64 (4, 4)."""
    T = T_world.copy()
    T[:3, 3] += T_world[:3, :3] @ cloud.origin - view.T_world_camera[:3, 3]  # large origins cancel here, in float64
    R = view.T_world_camera[:3, :3].T
    T[:3, :3], T[:3, 3] = R @ T[:3, :3], R @ T[:3, 3]
    return T


def world_point(target: Target, index: int) -> NDArray[np.float64]:
    assert target.cloud is not None
    point = target.cloud.select_by_index([index]).points[0]
    return point.copy() if target.pose is None else target.pose[:3, :3] @ point + target.pose[:3, 3]


def _surface_at(target: Target, T_world: Matrix, view: View, x: float, y: float) -> list[tuple[float, Pick]]:
    """Depth and position of the intersection of a click's ray with a mesh, if any."""
    assert target.scene is not None
    eye, ray = ray_through(view, x, y)
    inverse = np.linalg.inv(T_world[:3, :3])  # the pose may be affine
    local = np.concatenate([inverse @ (eye - T_world[:3, 3]), inverse @ ray])
    hits = target.scene.cast_rays(local[None])
    depth = float(hits["t_hit"][0])  # the direction has depth 1 in the camera's frame
    if not math.isfinite(depth) or depth <= 0:
        return []
    return [(depth, Pick(target.name, None, eye + depth * ray, int(hits["primitive_ids"][0])))]


def ray_through(view: View, x: float, y: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """World position of the camera [m] and direction through a pixel, scaled to depth 1."""
    camera = view.intrinsic
    direction = np.array([(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1.0])
    return view.T_world_camera[:3, 3].copy(), view.T_world_camera[:3, :3] @ direction


def project(view: View, point: ArrayLike) -> tuple[float, float, float]:
    """Column and row [px] and depth [m] of a world point. NaN if it is not in front of the camera."""
    q = view.T_world_camera[:3, :3].T @ (np.asarray(point, np.float64) - view.T_world_camera[:3, 3])
    if not q[2] > 0:
        return math.nan, math.nan, float(q[2])
    camera = view.intrinsic
    return float(camera.fx * q[0] / q[2] + camera.cx), float(camera.fy * q[1] / q[2] + camera.cy), float(q[2])


def describe_row(row: PointCloud, index: int, point: NDArray[np.float64] | None = None) -> Rows:
    position = row.points[0]
    # resolution of float32 relative to the origin, or after a pose
    resolution = float(np.spacing(np.abs(position - row.origin).max().astype(np.float32)))
    shown = position if point is None else point
    rows = [("index", f"{index:,}")]
    rows += [(axis, coordinate_text(value, resolution)) for axis, value in zip("xyz", shown, strict=True)]
    if row.has_colors:
        rows.append(("color", " ".join(f"{round(255 * min(max(float(c), 0), 1))}" for c in row.colors[0])))
    if row.has_normals:
        rows.append(("normal", " ".join(f"{float(c):.4f}" for c in row.normals[0])))
    return rows + [(name, _value_text(values[0])) for name, values in row.attributes.items()]


def coordinate_text(value: float, resolution: float = 0.0) -> str:
    """Format a coordinate with the digits above a resolution (0: float64)."""
    if not math.isfinite(value):
        return "nan" if math.isnan(value) else f"{value:g}"
    step = max(resolution, float(np.spacing(abs(value)) if value else 0.0))
    if step <= 0 or value == 0:
        return "0" if value == 0 else f"{value:.9g}"
    decimals = min(max(-math.floor(math.log10(step)) - 1, 0), 12)
    if abs(value) >= 1e15 or (abs(value) < 1e-6 and decimals >= 12):
        return f"{value:.7g}"
    text = f"{value:.{decimals}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def _value_text(value: ArrayLike) -> str:
    values = np.atleast_1d(np.asarray(value))
    return " ".join(f"{v}" if values.dtype.kind in "iub" else f"{float(v):.7g}" for v in values.ravel().tolist())
