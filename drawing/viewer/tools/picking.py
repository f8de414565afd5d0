"""Which point a click means, over all points of a cloud and not only those drawn, and what is known of it.

Screen positions are in the pixels of a View: whole numbers are the middles of pixels.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_number, check_positive, check_transformation
from ....kernels.drawing import picking
from ....meshing.scene.raycasting_scene import RaycastingScene
from ....pcd.cloud import PointCloud
from ....pcd.point_arrays import check_cloud
from ...render.view import View, check_view

RADIUS = 6.0  # [px] as far as a click may miss
Matrix = NDArray[np.float64]
Reach = tuple[Any, Matrix, Any, tuple[float, float], float]  # what the passes over a cloud's points take
Rows = list[tuple[str, str]]  # what is known of a point, as labels and values


@dataclasses.dataclass(frozen=True, eq=False)
class Target:
    """What can be picked.

    Args:
        name: As it is shown.
        cloud: Its points, or None.
        scene: A mesh as a scene for rays, in its own coordinates, or None.
        pose: From its coordinates to the world's, 4x4; None leaves it where it is.
        hidden: uint8 [n] on the cloud's device, 1 for points that are not to be seen; None hides none.
    """

    name: str
    cloud: PointCloud | None = None
    scene: RaycastingScene | None = None
    pose: Matrix | None = None
    hidden: Any = None


@dataclasses.dataclass(frozen=True, eq=False)
class Pick:
    """What a click met.

    Attributes:
        name: Of the target.
        index: The point's index in its cloud, or None on a surface.
        point: Where it is in the world [m], float64 [3].
        triangle: The triangle's number on a surface, else None.
        attributes: What the cloud knows of the point by name, its "color" and "normal" too; for `Viewer.on_pick`.
    """

    name: str
    index: int | None
    point: NDArray[np.float64]
    triangle: int | None = None
    attributes: Mapping[str, Any] = dataclasses.field(default_factory=dict)


def pick_point(
    cloud: PointCloud, view: View, x: float, y: float, *, radius: float = RADIUS, pose: Any = None, hidden: Any = None
) -> int | None:
    """The point of a cloud that a click means: the nearest to it on the screen among those in front.

    A point counts the farther away on the screen, the more it lies behind the foremost point in reach, a pixel for ten
    lengths as wide as a pixel is there. So the point right under the click is it on any surface, however dense and
    however steep (to 84 degrees), and never one seen through the gaps of the surface.

    Args:
        cloud: The cloud; all of its points are looked at, on its device.
        view: Where the screen looks from.
        x, y: The click [px].
        radius: How far from the click a point may be seen [px].
        pose: From the cloud's coordinates to the world's, 4x4; None leaves it where it is.
        hidden: uint8 [n] on the cloud's device, 1 for points that are not to be seen.

    Returns:
        The point's index, or None where no point is in reach. Points that are not finite, or lie behind the camera,
        are never it.

    Raises:
        TypeError: No cloud, no View, or no numbers.
        ValueError: A radius that is not positive, or a pose that cannot be inverted.

    Notes:
        Two passes over the points, 24 B a point; 1 sync each. The same point in every run and on every device; of
        points seen in the same place, the one with the smaller index.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.drawing.render.view import fit_view
        >>> cloud = loom.PointCloud([[0, 0, 0], [0, 1, 0], [0, 1, 1]])
        >>> view = fit_view(cloud.points, width=320, height=240)
        >>> [pick_point(cloud, view, *project(view, point)[:2]) for point in cloud.points]
        [0, 1, 2]
    """
    check_cloud("cloud", cloud)
    found = pick([Target("cloud", cloud, pose=pose, hidden=hidden)], view, x, y, radius=radius)
    return None if found is None else found.index


def pick(targets: Iterable[Target], view: View, x: float, y: float, *, radius: float = RADIUS) -> Pick | None:
    """What a click means among several clouds and meshes; as `pick_point`, where a surface hides what is behind it.

    A mesh is met right under the click, and counts as a point there.
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
            depth = picking.find_foremost(*_reach(target, T, view, click, radius), hidden=target.hidden)
            if depth is not None:
                clouds.append((target, T, depth))
        elif target.scene is not None:
            surfaces += _surface_at(target, T_world, view, *click)
    if not clouds and not surfaces:
        return None
    foremost = min([depth for *_, depth in clouds] + [depth for depth, _ in surfaces])
    best: tuple[float, Pick] | None = None
    for depth, met in surfaces:
        behind = (depth - foremost) * view.intrinsic.fx / (foremost * picking.STEEPNESS)
        if best is None or behind * behind < best[0]:
            best = behind * behind, met
    for target, T, _ in clouds:
        found = picking.find_meant(*_reach(target, T, view, click, radius), foremost, hidden=target.hidden)
        if found is not None and (best is None or found[0] < best[0]):
            best = found[0], Pick(target.name, found[1], world_point(target, found[1]))
    return None if best is None else best[1]


def _reach(target: Target, T: Matrix, view: View, click: tuple[float, float], radius: float) -> Reach:
    assert target.cloud is not None
    return target.cloud._device_array("points"), T, view.intrinsic, click, radius


def T_camera_points(view: View, cloud: PointCloud, T_world: Matrix) -> Matrix:
    """From the positions that a cloud holds, about its origin, to the camera of a view; float64 [4, 4]."""
    T = T_world.copy()
    T[:3, 3] += T_world[:3, :3] @ cloud.origin - view.T_world_camera[:3, 3]  # far origins cancel here, in float64
    R = view.T_world_camera[:3, :3].T
    T[:3, :3], T[:3, 3] = R @ T[:3, :3], R @ T[:3, 3]
    return T


def world_point(target: Target, index: int) -> NDArray[np.float64]:
    """Where a point of a target is in the world [m]."""
    assert target.cloud is not None
    point = target.cloud.select_by_index([index]).points[0]
    return point.copy() if target.pose is None else target.pose[:3, :3] @ point + target.pose[:3, 3]


def _surface_at(target: Target, T_world: Matrix, view: View, x: float, y: float) -> list[tuple[float, Pick]]:
    """The depth and place where the ray of a click meets a mesh, or nothing."""
    assert target.scene is not None
    eye, ray = ray_through(view, x, y)
    inverse = np.linalg.inv(T_world[:3, :3])  # the pose may be affine
    local = np.concatenate([inverse @ (eye - T_world[:3, 3]), inverse @ ray])
    hits = target.scene.cast_rays(local[None])
    depth = float(hits["t_hit"][0])  # the ray's third coordinate in the camera's frame is 1
    if not math.isfinite(depth) or depth <= 0:
        return []
    return [(depth, Pick(target.name, None, eye + depth * ray, int(hits["primitive_ids"][0])))]


def ray_through(view: View, x: float, y: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The camera's place [m] and the direction through a pixel, of depth 1, both in the world."""
    camera = view.intrinsic
    direction = np.array([(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1.0])
    return view.T_world_camera[:3, 3].copy(), view.T_world_camera[:3, :3] @ direction


def project(view: View, point: Any) -> tuple[float, float, float]:
    """Column and row [px], and depth [m], of a point in the world; NaN of what is not before the camera."""
    q = view.T_world_camera[:3, :3].T @ (np.asarray(point, np.float64) - view.T_world_camera[:3, 3])
    if not q[2] > 0:
        return math.nan, math.nan, float(q[2])
    camera = view.intrinsic
    return float(camera.fx * q[0] / q[2] + camera.cx), float(camera.fy * q[1] / q[2] + camera.cy), float(q[2])


# ------------------------------------------------------------------------------------------------ what is shown of it


def describe_point(cloud: PointCloud, index: int, point: NDArray[np.float64] | None = None) -> Rows:
    """What a cloud knows of a point, as labels and values for people; plain text.

    Args:
        cloud: The cloud.
        index: The point's index.
        point: Where it is shown [m], where that is not where the cloud has it.

    Raises:
        IndexError: No such point.
    """
    return describe_row(cloud.select_by_index([index]), index, point)


def describe_row(row: PointCloud, index: int, point: NDArray[np.float64] | None = None) -> Rows:
    """`describe_point` of a cloud that holds this point alone."""
    place = row.points[0]
    # what float32 about the origin can tell apart there, or after a pose
    resolution = float(np.spacing(np.abs(place - row.origin).max().astype(np.float32)))
    shown = place if point is None else point
    rows = [("index", f"{index:,}")]
    rows += [(axis, coordinate_text(value, resolution)) for axis, value in zip("xyz", shown, strict=True)]
    if row.has_colors:
        rows.append(("colour", " ".join(f"{round(255 * min(max(float(c), 0), 1))}" for c in row.colors[0])))
    if row.has_normals:
        rows.append(("normal", " ".join(f"{float(c):.4f}" for c in row.normals[0])))
    return rows + [(name, _value_text(values[0])) for name, values in row.attributes.items()]


def coordinate_text(value: float, resolution: float = 0.0) -> str:
    """A coordinate to the digits that it has: those above a resolution, of which 0 is float64's own."""
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


def _value_text(value: Any) -> str:
    """One value of an attribute, or the components of one."""
    values = np.atleast_1d(np.asarray(value))
    return " ".join(f"{v}" if values.dtype.kind in "iub" else f"{float(v):.7g}" for v in values.ravel().tolist())
