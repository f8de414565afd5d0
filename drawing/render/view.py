"""Where a picture is taken from: `View`, and `fit_view`, which frames an object from a direction."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import LARGEST_NUMBER, check_count, check_direction, check_rigid, check_rows
from .open3d_parameters import view_from_open3d, view_to_open3d

Triple = tuple[float, float, float]
Insets = tuple[int, int, int, int]  # [px] at the left, the top, the right and the bottom of a picture

FIELD_OF_VIEW = 40.0  # [degrees] across the wider side: little perspective distortion
MARGIN = 1.06  # the object fills all but 6 % of the picture
LEAST_ROOM = 0.4  # of a picture's width and height that insets leave in any case


@dataclasses.dataclass(frozen=True, eq=False)
class View:
    """Where a picture is taken from.

    Args:
        intrinsic: The camera; its size is the picture's.
        T_world_camera: Camera to world, shape [4, 4] [m]: x right, y down, z forward.
    """

    intrinsic: PinholeCameraIntrinsic
    T_world_camera: NDArray[np.float64]

    def __post_init__(self):
        if not isinstance(self.intrinsic, PinholeCameraIntrinsic):
            raise TypeError(f"intrinsic: expected a PinholeCameraIntrinsic, got {type(self.intrinsic).__name__}")
        object.__setattr__(self, "T_world_camera", check_rigid("T_world_camera", self.T_world_camera))

    def __repr__(self) -> str:
        place, forward = (self.T_world_camera[:3, i].round(6).tolist() for i in (3, 2))
        return f"View({self.intrinsic.width} x {self.intrinsic.height}, from {place}, along {forward})"

    @classmethod
    def from_open3d(
        cls,
        bounds: tuple[Any, Any],
        zoom: float = 0.7,
        front: Sequence[float] = (0.0, 0.0, 1.0),
        lookat: Sequence[float] | None = None,
        up: Sequence[float] = (0.0, 1.0, 0.0),
        field_of_view: float = 60.0,
        width: int = 1280,
        height: int = 960,
    ) -> View:
        """The view that Open3D's viewer has with these parameters, which `draw_geometries` takes.

        Args:
            bounds: The lowest and highest corner [m] of the box around what is drawn, shape [3] each.
            zoom: Half of what is seen at `lookat`, from top to bottom, as a share of the box's longest side.
            front: From `lookat` to the camera.
            lookat: What is in the middle of the picture [m]; None for the middle of the box.
            up: What is up in the picture; its part at a right angle to `front` counts.
            field_of_view: From the upper to the lower edge [degrees].
            width: Columns of the picture [px].
            height: Rows [px].

        Raises:
            ValueError: A direction without length, `up` along `front`, or a value out of range.

        Notes:
            Open3D draws 5 degrees in parallel projection; here they are perspective.

        Example:
            >>> view = View.from_open3d(([0, 0, 0], [1, 1, 2]), zoom=0.5)
            >>> view.T_world_camera[:3, 3].round(6).tolist()
            [0.5, 0.5, 2.732051]
        """

        options: dict[str, Any] = {"zoom": zoom, "front": front, "lookat": lookat, "up": up}
        return cls(*view_from_open3d(bounds, field_of_view=field_of_view, width=width, height=height, **options))

    def to_open3d(self, bounds: tuple[Any, Any]) -> dict[str, Any]:
        """Open3D's parameters of this view: "zoom", "front", "lookat", "up", "field_of_view".

        Args:
            bounds: The lowest and highest corner [m] of the box around what is drawn, shape [3] each.

        Raises:
            ValueError: Pixels that are not square, or a principal point that is not in the middle.

        Example:
            >>> bounds = [0, 0, 0], [1, 1, 2]
            >>> round(View.from_open3d(bounds, zoom=0.5).to_open3d(bounds)["zoom"], 9)
            0.5
        """

        return view_to_open3d(self.intrinsic, self.T_world_camera, bounds)


def fit_view(
    points: Any,
    *,
    direction: Triple = (-0.65, 0.7, -0.75),
    up: Triple = (0.0, 0.0, 1.0),
    width: int = 1280,
    height: int = 960,
) -> View:
    """The closest view along a direction that shows all points.

    Args:
        points: Shape [n, 3] [m]; those that are not finite do not count. None at all gives a view of the origin.
        direction: The way the camera looks: by default down from the front right, as onto a doll's house.
        up: What is up in the picture; not along the direction.
        width: Columns [px].
        height: Rows [px].

    Raises:
        ValueError: Another shape, a size below 1, or a direction along `up`.

    Example:
        >>> view = fit_view([[0, 0, 0], [1, 1, 1]], width=320, height=240)
        >>> view.intrinsic.width, view.T_world_camera.shape
        (320, (4, 4))
    """
    values = check_rows("points", points, 3, dtype=np.float64)
    values = values[np.isfinite(values).all(axis=1)]
    if values.size and np.abs(values).max() > LARGEST_NUMBER:
        raise ValueError(f"points: expected coordinates up to {LARGEST_NUMBER:g}, got {np.abs(values).max():g}")
    frame = Frame(direction, up, width, height)
    if not len(values):
        return frame.view(None, 0.0)
    return frame.view((values @ frame.directions().T).max(axis=0), float(np.ptp(values, axis=0).max()))


class Frame:
    """A direction to look along and the size of a picture, before it is known how far what is seen reaches.

    Args:
        direction, up, width, height: As of `fit_view`.
        insets: Bands at the edges of the picture that what is seen stays out of.

    Raises:
        ValueError: A size below 1, or a direction along `up`.
    """

    def __init__(self, direction: Triple, up: Triple, width: int, height: int, insets: Insets = (0, 0, 0, 0)):
        width, height = check_count("width", width), check_count("height", height)
        forward, upward = check_direction("direction", direction), check_direction("up", up)
        right = np.cross(forward, upward)
        if not np.linalg.norm(right) > 1e-9:
            raise ValueError(f"direction: expected one that is not along up, got {direction!r} and {up!r}")
        right = right / np.linalg.norm(right)
        self.R = np.column_stack([right, np.cross(forward, right), forward])
        focal = max(width, height) / 2 / math.tan(math.radians(FIELD_OF_VIEW / 2))
        self.intrinsic = PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
        left, top, right, bottom = insets
        pairs = _shortened(left, right, width), _shortened(top, bottom, height)
        # of the angles from the optical axis to both ends of what is free along each axis
        sides = zip(pairs, (width, height), strict=True)
        self.tans = [[(length / 2 - band) / focal / MARGIN for band in bands] for bands, length in sides]

    def directions(self) -> NDArray[np.float64]:
        """Directions in the world, shape [5, 3], along which it must be known how far what is seen reaches."""
        x, y, z = self.R.T
        (left, right), (top, bottom) = self.tans
        return np.array([-x - left * z, x - right * z, -y - top * z, y - bottom * z, -z])

    def view(self, reach: NDArray[np.float64] | None, extent: float) -> View:
        """The view from the place nearest to what is seen.

        Args:
            reach: Of what is seen along the directions, shape [5] [m]; None where there is nothing.
            extent: The longest side of its box [m].

        Along each axis two planes through the place bound what is seen; where the planes that touch it meet is the
        place for that axis, and the one farther back serves both.
        """
        T = np.eye(4)
        place, depths = np.array([0.0, 0.0, -3.0]), []
        if reach is not None:
            for axis, tans in enumerate(self.tans):
                low, high = -reach[2 * axis], reach[2 * axis + 1]
                place[axis] = (low + high) / 2
                depths.append((low - high) / sum(tans))
            place[2] = min(*depths, -reach[4] - 0.01 * (extent or 1.0))
            for axis, (before, behind) in enumerate(self.tans):
                place[axis] += (behind - before) * place[2] / 2
        T[:3, :3], T[:3, 3] = self.R, self.R @ place
        return View(self.intrinsic, T)


def _shortened(first: int, last: int, length: int) -> tuple[float, float]:
    """Two bands at the ends of a side, in proportion, such that they leave room between them."""
    most = (1 - LEAST_ROOM) * length
    share = min(1.0, most / (first + last)) if first + last else 1.0
    return first * share, last * share


def check_view(view: Any) -> View:
    """The view, once it is sure that it is one."""
    if not isinstance(view, View):
        raise TypeError(f"view: expected a View, got {type(view).__name__}")
    return view
