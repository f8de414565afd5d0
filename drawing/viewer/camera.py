"""Views and the cameras of viser: to the page and back."""

from __future__ import annotations

import dataclasses
import math
import os
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ..render.open3d_views import OPEN3D_KEYS, read_view
from ..render.upward import level_up
from ..render.view import View
from .items import Bounds, Frame, rotation

if TYPE_CHECKING:
    import viser

Vector = NDArray[np.float64]


# Nearest and farthest that is drawn, and the reach of the mouse wheel, in diagonals of the scene. A depth buffer of 24
# bits then tells apart what lies 1e-4 diagonals apart at a distance of one diagonal.
NEAR, FAR = 1e-3, 100.0
CLOSEST, FARTHEST = 1e-4, 50.0


@dataclasses.dataclass(frozen=True, eq=False)
class Camera:
    """A camera of the page, in its coordinates.

    Args:
        position, look_at, up: Shape [3].
        fov: Of the height [rad].
    """

    position: Vector
    look_at: Vector
    up: Vector
    fov: float


def camera_of(view: View, frame: Frame, bounds: Bounds, aspect: float | None = None) -> Camera:
    """The camera that sees what a view shows.

    Args:
        view: The view; its principal point counts as the middle.
        frame: The page's coordinates.
        bounds: Of the scene: the camera turns about the place in its middle that it looks at.
        aspect: Width by height of the page; a narrower one than the view's is given a wider angle.
    """
    T, intrinsic = view.T_world_camera, view.intrinsic
    forward, eye = T[:3, 2], T[:3, 3]
    middle = (bounds[0] + bounds[1]) / 2
    size = float(np.linalg.norm(bounds[1] - bounds[0])) or 1.0
    reach = max(float((middle - eye) @ forward), 0.05 * size)
    tangent = intrinsic.height / 2 / intrinsic.fy
    if aspect is not None:
        tangent = max(tangent, intrinsic.width / 2 / intrinsic.fx / aspect)
    up = level_up(T[:3, 0], -T[:3, 1])  # level: then it stays level as it is turned
    position = (eye - frame.origin) / frame.unit
    return Camera(position, position + forward * reach / frame.unit, up, 2 * math.atan(tangent))


def view_of(camera: viser.CameraHandle, frame: Frame, size: tuple[int, int]) -> View:
    """The view of a page's camera, in the world's coordinates."""
    width, height = size
    focal = height / 2 / math.tan(camera.fov / 2)
    T = np.eye(4)
    T[:3, :3] = rotation(camera.wxyz)
    T[:3, 3] = np.asarray(camera.position, np.float64) * frame.unit + frame.origin
    return View(PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2), T)


def set_camera(client: viser.ClientHandle, camera: Camera) -> None:
    """Put a page's camera there."""
    from .hub import send_camera

    with client.atomic():
        client.camera.up_direction = camera.up
        client.camera.position = camera.position
        client.camera.look_at = camera.look_at
        client.camera.fov = camera.fov
        send_camera(client, camera.position, camera.look_at, camera.up, camera.fov)


def set_reach(client: viser.ClientHandle, frame: Frame, bounds: Bounds) -> None:
    """Have a page draw all of the scene, and let its wheel go as near and as far as makes sense."""
    size = diagonal(bounds) / frame.unit
    with client.atomic():
        client.camera.near, client.camera.far = NEAR * size, FAR * size
        client.camera.min_orbit_distance, client.camera.max_orbit_distance = CLOSEST * size, FARTHEST * size


def set_first_camera(server: viser.ViserServer, camera: Camera, frame: Frame, bounds: Bounds) -> None:
    """Where pages that come later begin."""
    first, size = server.initial_camera, diagonal(bounds) / frame.unit
    first.near, first.far = NEAR * size, FAR * size
    first.up = camera.up
    first.position, first.look_at, first.fov = camera.position, camera.look_at, camera.fov


def diagonal(bounds: Bounds) -> float:
    """Of a box [m]; 1 of one without extent."""
    return float(np.linalg.norm(bounds[1] - bounds[0])) or 1.0


def point_radius(pixels: float, points: Vector, view: View, frame: Frame, default: float) -> float:
    """viser's size of points (a radius, in units of the page) at which they are some pixels wide.

    Args:
        pixels: Diameter on the screen.
        points: Some of the cloud's points, shape [k, 3] [m].
        view: From where.
        frame: The page's coordinates.
        default: Their distance [m] where none is seen.
    """
    local = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    depth = local[:, 2]
    camera = view.intrinsic
    with np.errstate(divide="ignore", invalid="ignore"):
        x, y = np.abs(local[:, 0] / depth * camera.fx), np.abs(local[:, 1] / depth * camera.fy)
    seen = depth[(depth > 0) & (x < camera.width / 2) & (y < camera.height / 2)]
    distance = float(np.median(seen)) if len(seen) else default
    return pixels * distance / camera.fy / 2 / frame.unit


def read_parameters(view: Any) -> View | dict[str, Any] | None:
    """What `set_view` is given, read."""
    if view is None or isinstance(view, View):
        return view
    if isinstance(view, str | os.PathLike):
        return read_view(view)
    if isinstance(view, dict):
        unknown = [key for key in view if key not in OPEN3D_KEYS]
        if unknown:
            raise TypeError(f"view: unknown key {unknown[0]!r}; there are {', '.join(OPEN3D_KEYS)}")
        return {key: value for key, value in view.items() if value is not None} or None
    raise TypeError(f"view: expected a View, a path or Open3D's parameters, got {type(view).__name__}")
