"""ViewControl: camera of a window by Open3D's parameters."""

from __future__ import annotations

import logging
import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.attribute_hints import HintedNames
from ...core.checks import check_direction, check_number, check_shape
from ...visualization.render.open3d_parameters import DEFAULT_ZOOM, FIELD_OF_VIEW, MAX_ZOOM, MIN_ZOOM
from ...visualization.render.view import View
from ..camera import PinholeCameraIntrinsic, PinholeCameraParameters
from ..wrapper import unwrap

RADIANS_PER_PIXEL = 0.003  # [rad] per pixel, as in Open3D
ZOOM_STEP = 0.02  # per wheel click
ANGLE_STEP, MIN_ANGLE, MAX_ANGLE = 5.0, 5.0, 90.0  # [degrees]
EMPTY_SCENE_BOUNDS = (np.full(3, -1.0), np.full(3, 1.0))
log = logging.getLogger("pointloom.viewer")


def _no_view() -> View | None:
    return None


class ViewControl(HintedNames):
    """Camera of a window.

    Mouse motion in the page affects captures and `convert_to_pinhole_camera_parameters`; `rotate` and the other methods
    continue from the view last set by the program.
    """

    _internal = ("show_box", "view", "configured_view", "look_from")

    def __init__(self):
        self.size, self.page_view = (1920, 1080), _no_view
        self.show_box(EMPTY_SCENE_BOUNDS)

    def show_box(self, bounds: tuple[Any, Any]) -> None:
        """Show a box along -z, Open3D's initial view."""
        self.bounds, self.angle, self._zoom = bounds, FIELD_OF_VIEW, DEFAULT_ZOOM
        self._lookat = (np.asarray(bounds[0]) + np.asarray(bounds[1])) / 2
        self._front, self._up, self._given = np.array([0.0, 0.0, 1.0]), np.array([0.0, 1.0, 0.0]), None
        self.is_moved = True  # since the window was last updated

    def view(self) -> View:
        return self.page_view() or self.configured_view()

    def configured_view(self) -> View:
        if self._given is not None:
            return self._given
        options: dict[str, Any] = {"zoom": self._zoom, "front": self._front, "lookat": self._lookat, "up": self._up}
        width, height = self.size
        return View.from_open3d(self.bounds, **options, field_of_view=self.angle, width=width, height=height)

    def _changed(self) -> None:
        self.is_moved, self._given = True, None

    def _axes(self) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """Right, up and front, orthonormal."""
        front = check_direction("front", self._front)
        right = check_direction("up", np.cross(check_direction("up", self._up), front))
        return right, np.cross(front, right), front

    def rotate(self, x: float, y: float, xo: float = 0.0, yo: float = 0.0) -> None:
        """Rotate about `lookat` like a mouse drag [px]."""
        right, up, front = self._axes()
        a, b = RADIANS_PER_PIXEL * x, RADIANS_PER_PIXEL * y
        front = check_direction("front", front * math.cos(a) - right * math.sin(a))
        right = check_direction("up", np.cross(up, front))
        self._front = check_direction("front", front * math.cos(b) + up * math.sin(b))
        self._up = np.cross(self._front, right)
        self._changed()

    def translate(self, x: float, y: float, xo: float = 0.0, yo: float = 0.0) -> None:
        """Translate like a mouse drag [px]."""
        right, up, _ = self._axes()
        extent = 2 * self._zoom * (float(np.max(self.bounds[1] - self.bounds[0])) or 1.0)
        self._lookat = self._lookat + extent * (up * y - right * x) / self.size[1]
        self._changed()

    def scale(self, scale: float) -> None:
        """Zoom out by wheel clicks; negative zooms in."""
        self.set_zoom(min(max(self._zoom + check_number("scale", scale) * ZOOM_STEP, MIN_ZOOM), MAX_ZOOM))

    def change_field_of_view(self, step: float = 0.45) -> None:
        """Widen by steps of 5 degrees, within 5 to 90 degrees."""
        angle = self.angle + check_number("step", step) * ANGLE_STEP
        self.angle = min(max(angle, MIN_ANGLE), MAX_ANGLE)
        self._changed()

    def get_field_of_view(self) -> float:
        """Vertical field of view [degrees]."""
        return self.angle

    def set_zoom(self, zoom: float) -> None:
        """Set half of the visible height at `lookat` over the longest side of the scene."""
        self._zoom = check_number("zoom", zoom)
        self._changed()

    def set_front(self, front: ArrayLike) -> None:
        """Set the direction from `lookat` to the camera."""
        self._front = check_direction("front", check_shape("front", front, (3,)).tolist())
        self._changed()

    def set_up(self, up: ArrayLike) -> None:
        self._up = check_direction("up", check_shape("up", up, (3,)).tolist())
        self._changed()

    def set_lookat(self, lookat: ArrayLike) -> None:
        """Set the point in the center."""
        self._lookat = check_shape("lookat", lookat, (3,)).copy()
        self._changed()

    def set_constant_z_near(self, z_near: float) -> None:
        """No effect: there is no near clipping."""

    def set_constant_z_far(self, z_far: float) -> None:
        """No effect: there is no far clipping."""

    unset_constant_z_near = unset_constant_z_far = lambda self: None

    def convert_to_pinhole_camera_parameters(self) -> PinholeCameraParameters:
        """Camera and extrinsic (world to camera)."""
        view, parameters = self.view(), PinholeCameraParameters()
        parameters.intrinsic = PinholeCameraIntrinsic.from_native(view.intrinsic)
        parameters.extrinsic = np.linalg.inv(view.T_world_camera)
        return parameters

    def convert_from_pinhole_camera_parameters(self, parameter: Any, allow_arbitrary: bool = False) -> bool:
        """Set the camera. False if unsupported: other size, pixels not square, principal point not centered.

        `allow_arbitrary` accepts all cameras.
        """
        view = View(unwrap(parameter.intrinsic), np.linalg.inv(parameter.extrinsic))
        if not allow_arbitrary and (view.intrinsic.width, view.intrinsic.height) != self.size:
            have = f"{view.intrinsic.width} x {view.intrinsic.height}"
            log.warning(
                "parameter: expected a camera of the size of the window, got %s pixels instead of %d x %d",
                have,
                *self.size,
            )
            return False
        try:
            self.look_from(view)
        except ValueError as error:
            if not allow_arbitrary:
                log.warning("parameter: %s", error)
                return False
            self.is_moved, self._given = True, view
        return True

    def look_from(self, view: View) -> None:
        """Set a view. Raises ValueError unless pixels are square and the principal point is centered."""
        fields = view.to_open3d(self.bounds)
        self._zoom, self.angle = fields["zoom"], fields["field_of_view"]
        self._front, self._lookat, self._up = (np.array(fields[name]) for name in ("front", "lookat", "up"))
        self._changed()

    def __repr__(self) -> str:
        return "ViewControl"
