"""Conversion between views and cameras of pages."""

from __future__ import annotations

import dataclasses
import math
import os
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ..render.open3d_views import OPEN3D_KEYS, read_view
from ..render.up_axis import level_up
from ..render.view import View, ViewLike
from .items import Bounds, Frame

if TYPE_CHECKING:
    from .link import CameraState, PageCamera

Vector = NDArray[np.float64]


# Depth range and zoom limits in diagonals of the scene. A 24-bit depth buffer then resolves 1e-4 diagonals
# at a distance of one diagonal.
NEAR_DIAGONALS, FAR_DIAGONALS = 1e-3, 100.0
MIN_ZOOM_DIAGONALS, MAX_ZOOM_DIAGONALS = 1e-4, 50.0

# Limits of a page's reported image for rendering.
MIN_FIELD_OF_VIEW, MAX_FIELD_OF_VIEW = 1e-6, math.pi - 1e-3  # [rad]
MIN_PIXELS, MAX_PIXELS = 32, 1 << 25  # per side. In total, as of 8192 x 4096

ORTHOGRAPHIC_DISTANCE = 500.0  # distance of a nearly orthographic camera in extents: no point moves by a pixel


@dataclasses.dataclass(frozen=True, eq=False)
class Camera:
    """A camera in page coordinates that rotates about `pivot` and keeps `up` upright.

    `rotation` (3, 3) is camera (x right, y down, z forward) to page, `fov` the vertical field of view [rad].
    """

    position: Vector
    rotation: Vector
    pivot: Vector
    up: Vector
    fov: float

    def fields(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}


def camera_of(view: View, frame: Frame, bounds: Bounds, aspect: float | None = None) -> Camera:
    """The camera of a view, with a centered principal point, that rotates about a point in the center of the scene.

    For a page narrower than the view (`aspect` is width over height), the angle is widened.
    """
    T, intrinsic = view.T_world_camera, view.intrinsic
    forward, eye = T[:3, 2], T[:3, 3]
    middle = (bounds[0] + bounds[1]) / 2
    size = float(np.linalg.norm(bounds[1] - bounds[0])) or 1.0
    distance = max(float((middle - eye) @ forward), 0.05 * size)
    tangent = intrinsic.height / 2 / intrinsic.fy
    if aspect is not None:
        tangent = max(tangent, intrinsic.width / 2 / intrinsic.fx / aspect)
    up = level_up(T[:3, 0], -T[:3, 1])  # level, so that it stays level when rotated
    position = frame.to_page(eye)
    pivot = position + forward * distance / frame.unit
    return Camera(position, T[:3, :3].copy(), pivot, up.copy(), 2 * math.atan(tangent))


def view_of(camera: CameraState | PageCamera, frame: Frame, bounds: Bounds, size: tuple[int, int]) -> View:
    """The view of a page's camera in world coordinates. A parallel projection becomes a distant perspective view."""
    width, height = picture_size(size)
    position = np.asarray(camera.position, np.float64)
    tangent = math.tan(min(max(camera.fov, MIN_FIELD_OF_VIEW), MAX_FIELD_OF_VIEW) / 2)
    if camera.orthographic:
        forward = np.asarray(camera.rotation, np.float64)[:, 2]
        depth = float((camera.pivot - position) @ forward)
        extent = diagonal(bounds) / frame.unit
        depth = depth if depth > 1e-9 * extent else extent
        back = ORTHOGRAPHIC_DISTANCE * max(depth, extent)
        position, tangent = position - back * forward, tangent * depth / (depth + back)
    focal = height / 2 / tangent
    T = np.eye(4)
    T[:3, :3] = camera.rotation
    T[:3, 3] = frame.to_world(position)
    return View(PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2), T)


def picture_size(size: tuple[int, int]) -> tuple[int, int]:
    """Size of a page's image [px], clipped to the renderer's limits."""
    width, height = (max(MIN_PIXELS, side) for side in size)
    scale = math.sqrt(min(1.0, MAX_PIXELS / (width * height)))
    return max(MIN_PIXELS, int(width * scale)), max(MIN_PIXELS, int(height * scale))


def camera_limits(camera: Camera | PageCamera, frame: Frame, bounds: Bounds) -> dict[str, float]:
    """Depth range and zoom limits of a camera for the scene."""
    size = diagonal(bounds) / frame.unit
    middle = frame.to_page((bounds[0] + bounds[1]) / 2)
    distance = float((middle - camera.position) @ np.asarray(camera.rotation)[:, 2])
    if distance <= MAX_ZOOM_DIAGONALS * size:
        return {
            "near": NEAR_DIAGONALS * size,
            "far": FAR_DIAGONALS * size,
            "closest": MIN_ZOOM_DIAGONALS * size,
            "farthest": MAX_ZOOM_DIAGONALS * size,
        }
    far = distance + 2 * size
    return {"near": distance - 2 * size, "far": far, "closest": MIN_ZOOM_DIAGONALS * size, "farthest": 4 * far}


def diagonal(bounds: Bounds) -> float:
    return float(np.linalg.norm(bounds[1] - bounds[0])) or 1.0


def read_parameters(view: ViewLike) -> View | dict[str, Any] | None:
    if view is None or isinstance(view, View):
        return view
    if isinstance(view, str | os.PathLike):
        return read_view(view)
    if isinstance(view, dict):
        unknown = [key for key in view if key not in OPEN3D_KEYS]
        if unknown:
            raise TypeError(f"view: expected the keys {', '.join(OPEN3D_KEYS)}, got {unknown[0]!r}")
        return {key: value for key, value in view.items() if value is not None} or None
    raise TypeError(f"view: expected a View, a path or Open3D's parameters, got {type(view).__name__}")
