"""Camera of an image (`View`) and views fitted to an object."""

from __future__ import annotations

import dataclasses
import math
import os
from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...core.checks import LARGEST_NUMBER, check_count, check_direction, check_rigid, check_rows
from ...core.exchange import on_host
from ...kernels.linear_algebra import matmul, norm
from .open3d_parameters import cross_product, view_from_open3d, view_to_open3d

Triple = tuple[float, float, float]
Insets = tuple[int, int, int, int]  # [px] left, top, right, bottom
#: A view, the path of a view's JSON, a mapping of Open3D's parameters, or None to fit the scene.
ViewLike: TypeAlias = "View | str | os.PathLike[str] | Mapping[str, Any] | None"

FIELD_OF_VIEW = 40.0  # [degrees] of the wider side: little perspective distortion
FIT_MARGIN = 1.06  # leaves 6 % of the image free
MIN_ROOM = 0.4  # fraction of width and height that insets always leave


@dataclasses.dataclass(frozen=True, eq=False)
class View:
    """Camera of an image.

    Args:
        intrinsic: Pinhole camera. Its size is the size of the image.
        T_world_camera: Camera to world [m], shape (4, 4): x right, y down, z forward.
    """

    intrinsic: PinholeCameraIntrinsic
    T_world_camera: NDArray[np.float64]

    def __post_init__(self):
        check_camera("intrinsic", self.intrinsic)
        object.__setattr__(self, "T_world_camera", check_rigid("T_world_camera", self.T_world_camera))

    def __repr__(self) -> str:
        position, forward = (self.T_world_camera[:3, i].round(6).tolist() for i in (3, 2))
        return f"View({self.intrinsic.width} x {self.intrinsic.height}, from {position}, along {forward})"

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
        """View with the parameters of Open3D's `draw_geometries`.

        Args:
            bounds: Lowest and highest corner of the scene [m], shape (3,) each.
            zoom: Half of the visible height at `lookat` over the longest side of the box.
            front: Direction from `lookat` to the camera.
            lookat: Point in the center of the image [m]. If None, the center of the box.
            up: Up direction of the image. The component along `front` is ignored.
            field_of_view: Vertical field of view [degrees].
            width, height: Size of the image [px].

        Raises:
            ValueError: A direction of zero length, `up` along `front`, or a value out of range.

        Notes:
            Open3D uses a parallel projection for 5 degrees. Here it is perspective.

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
            bounds: Lowest and highest corner of the scene [m], shape (3,) each.

        Raises:
            ValueError: Pixels are not square, or the principal point is not in the center.

        Example:
            >>> bounds = [0, 0, 0], [1, 1, 2]
            >>> round(View.from_open3d(bounds, zoom=0.5).to_open3d(bounds)["zoom"], 9)
            0.5
        """

        return view_to_open3d(self.intrinsic, self.T_world_camera, bounds)

    @staticmethod
    def fit(
        points: Any,
        *,
        direction: Triple = (-0.65, 0.7, -0.75),
        up: Triple = (0.0, 0.0, 1.0),
        width: int = 1280,
        height: int = 960,
    ) -> View:
        """Closest view along a direction that shows all points.

        Args:
            points: Shape (n, 3) [m]. Non-finite points are ignored. Without any point, the view shows the origin.
            direction: Viewing direction. By default down from the front right.
            up: Up direction of the image. Not along `direction`.
            width, height: Size of the image [px].

        Raises:
            ValueError: Another shape, a size below 1, or a direction along `up`.

        Example:
            >>> view = View.fit([[0, 0, 0], [1, 1, 1]], width=320, height=240)
            >>> view.intrinsic.width, view.T_world_camera.shape
            (320, (4, 4))
        """
        return fit_view(points, direction=direction, up=up, width=width, height=height)


def fit_view(
    points: ArrayLike,
    *,
    direction: Triple = (-0.65, 0.7, -0.75),
    up: Triple = (0.0, 0.0, 1.0),
    width: int = 1280,
    height: int = 960,
) -> View:
    """Closest view along a direction that shows all points, see `View.fit`."""
    values = check_rows("points", on_host("points", points), 3, dtype=np.float64)
    values = values[np.isfinite(values).all(axis=1)]
    if values.size and np.abs(values).max() > LARGEST_NUMBER:
        raise ValueError(f"points: expected coordinates up to {LARGEST_NUMBER:g}, got {np.abs(values).max():g}")
    frame = Frame(direction, up, width, height)
    if not len(values):
        return frame.view(None, 0.0)
    return frame.view(matmul(values, frame.directions().T).max(axis=0), float(np.ptp(values, axis=0).max()))


class Frame:
    """Direction and image size of a view to be fitted; `insets` are bands at the image edges to be left free."""

    def __init__(self, direction: Triple, up: Triple, width: int, height: int, insets: Insets = (0, 0, 0, 0)):
        width, height = check_count("width", width), check_count("height", height)
        forward, up_direction = check_direction("direction", direction), check_direction("up", up)
        right = cross_product(forward, up_direction)
        if not norm(right) > 1e-9:
            raise ValueError(f"direction: expected one that is not along up, got {direction!r} and {up!r}")
        right = right / norm(right)
        self.R = np.column_stack([right, cross_product(forward, right), forward])
        focal = max(width, height) / 2 / math.tan(math.radians(FIELD_OF_VIEW / 2))
        self.intrinsic = PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
        left, top, right, bottom = insets
        pairs = _shortened(left, right, width), _shortened(top, bottom, height)
        # of the angles from the optical axis to both ends of the free range of each axis
        sides = zip(pairs, (width, height), strict=True)
        self.tans = [[(length / 2 - band) / focal / FIT_MARGIN for band in bands] for bands, length in sides]

    def directions(self) -> NDArray[np.float64]:
        """Directions, shape (5, 3), along which the extent of the scene must be known."""
        x, y, z = self.R.T
        (left, right), (top, bottom) = self.tans
        return np.array([-x - left * z, x - right * z, -y - top * z, y - bottom * z, -z])

    def view(self, extents: NDArray[np.float64] | None, extent: float) -> View:
        """The closest view, from the scene's extent along the directions (5,) [m] (or None) and its longest side [m].

        Along each axis, the tangent planes of the scene meet at the camera position. The farther of the two positions
        is used.
        """
        T = np.eye(4)
        position, depths = np.array([0.0, 0.0, -3.0]), []
        if extents is not None:
            for axis, tans in enumerate(self.tans):
                low, high = -extents[2 * axis], extents[2 * axis + 1]
                position[axis] = (low + high) / 2
                depths.append((low - high) / sum(tans))
            position[2] = min(*depths, -extents[4] - 0.01 * (extent or 1.0))
            for axis, (before, behind) in enumerate(self.tans):
                position[axis] += (behind - before) * position[2] / 2
        T[:3, :3], T[:3, 3] = self.R, matmul(self.R, position)
        return View(self.intrinsic, T)


def _shortened(first: int, last: int, length: int) -> tuple[float, float]:
    """Two bands at the ends of a side, scaled to leave space between them."""
    max_total = (1 - MIN_ROOM) * length
    fraction = min(1.0, max_total / (first + last)) if first + last else 1.0
    return first * fraction, last * fraction


def check_view(view: object) -> View:
    if not isinstance(view, View):
        raise TypeError(f"view: expected a View, got {type(view).__name__}")
    return view
