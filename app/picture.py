"""Pictures of meshes and point clouds by our own kernels: no window, no graphics library, the same bits each time.

A view is a camera: a pinhole and where it stands. `fit_view` finds one that frames an object from a direction.
"""

from __future__ import annotations

import dataclasses
import math
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kernels.images import raster
from ..kernels.images.raster import draw_points, draw_triangles
from ..kernels.lang import int32, vec3
from ..kernels.memory import download, upload
from ..kernels.scenes.raster_shading import SAMPLES, Look, shade_points, shade_triangles
from ..pcd.camera import PinholeCameraIntrinsic
from ..pcd.checks import check_count, check_positive, check_rigid, check_rows, check_shape
from ..pcd.devices import resolve_device
from ..pcd.errors import FileError
from ..pcd.io.atomic import check_writable
from ..pcd.io.image_files import write_png

Triple = tuple[float, float, float]

FIELD_OF_VIEW = 40.0  # [degrees] across the wider side: little perspective distortion
MARGIN = 1.06  # the object fills all but 6 % of the picture
PLAIN: Triple = (0.80, 0.78, 0.74)  # what has no colour


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
        object.__setattr__(self, "T_world_camera", check_rigid("T_world_camera", self.T_world_camera))


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
    width, height = check_count("width", width), check_count("height", height)
    forward, upward = check_shape("direction", direction, (3,)), check_shape("up", up, (3,))
    right = np.cross(forward, upward)
    if not np.linalg.norm(right) > 1e-9 * np.linalg.norm(forward) * np.linalg.norm(upward):
        raise ValueError(f"direction: expected one that is not along up, got {direction!r} and {up!r}")
    forward, right = forward / np.linalg.norm(forward), right / np.linalg.norm(right)
    R = np.column_stack([right, np.cross(forward, right), forward])
    focal = max(width, height) / 2 / math.tan(math.radians(FIELD_OF_VIEW / 2))
    intrinsic = PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, R @ _nearest_place(values @ R, width / 2 / focal / MARGIN, height / 2 / focal / MARGIN)
    return View(intrinsic, T)


def _nearest_place(points: NDArray[np.float64], tan_x: float, tan_y: float) -> NDArray[np.float64]:
    """The place nearest to points, along z, from which all lie within the two half angles; in the camera's axes.

    Along each axis two planes through the place bound what is seen; where the planes that touch the points meet is the
    place for that axis, and the one farther back serves both.
    """
    if len(points) == 0:
        return np.array([0.0, 0.0, -3.0])
    z, place, depths = points[:, 2], np.zeros(3), []
    for axis, tan in ((0, tan_x), (1, tan_y)):
        low, high = (points[:, axis] + tan * z).min(), (points[:, axis] - tan * z).max()
        place[axis] = (low + high) / 2
        depths.append((low - high) / (2 * tan))
    extent = float(np.ptp(points, axis=0).max()) or 1.0
    place[2] = min(*depths, z.min() - 0.01 * extent)
    return place


def render_mesh(
    mesh: Any,
    *,
    width: int = 1280,
    height: int = 960,
    view: View | None = None,
    background: Triple = (1.0, 1.0, 1.0),
    color: Triple = PLAIN,
    shaded: bool | None = None,
    cull: bool = True,
    device: Any = None,
) -> NDArray[np.uint8]:
    """Draw a triangle mesh.

    Args:
        mesh: Anything with `vertices` [m, 3] [m] and `triangles` [t, 3], and perhaps `vertex_colors` [m, 3] (0 to 1)
            and `vertex_normals` [m, 3]; without normals faces are flat.
        width: Columns [px]; a view brings its own.
        height: Rows [px].
        view: Where from; None fits one.
        background: Red, green and blue, 0 to 1.
        color: The colour of a mesh that has none.
        shaded: Darken faces that look aside; None does so where there are no colours, which are shown as they are.
        cull: Leave out faces that look away, so that one sees into a closed room through its near walls.
        device: Where to draw.

    Returns:
        Shape [h, w, 3], uint8 RGB; each pixel the mean of 2 x 2 samples.

    Raises:
        ValueError: A size below 1, arrays of other shapes, or triangles of vertices that do not exist.
        DeviceError: No such device.

    Notes:
        Same bits from run to run on one device. 32 B of memory a pixel and 36 B a vertex. Triangles that reach behind
        the camera are left out whole.
    """
    vertices = check_rows("vertices", mesh.vertices, 3, dtype=np.float64)
    triangles = _check_triangles(mesh.triangles, len(vertices))
    view = _check_view(view, vertices, width, height)
    place, origin = resolve_device(device), _middle(vertices)
    seen = _raster_view(view, origin)
    points = upload(vertices - origin, vec3, place)
    indices = upload(triangles.ravel(), int32, place)
    normals = upload(_rows_or_none("vertex_normals", mesh, len(vertices)), vec3, place)
    colors = upload(_rows_or_none("vertex_colors", mesh, len(vertices)), vec3, place)
    buffer = draw_triangles(points, indices, seen, cull=cull)
    lit = colors.size == 0 if shaded is None else shaded
    look = Look(normals, colors, plain=vec3(*color), background=_check_background(background), lit=lit)
    picture = shade_triangles(buffer, seen, points, indices, look)
    return _to_image(picture, view)


def render_point_cloud(
    cloud: Any,
    *,
    point_size: float | None = None,
    width: int = 1280,
    height: int = 960,
    view: View | None = None,
    background: Triple = (1.0, 1.0, 1.0),
    color: Triple = (0.35, 0.50, 0.62),
    shaded: bool = True,
    device: Any = None,
) -> NDArray[np.uint8]:
    """Draw a point cloud as discs.

    Args:
        cloud: Anything with `points` [n, 3] [m], and perhaps `colors` [n, 3] (0 to 1) and `normals` [n, 3].
        point_size: Diameter of the discs [px]; None takes one that closes most gaps between neighbours.
        width: Columns [px]; a view brings its own.
        height: Rows [px].
        view: Where from; None fits one.
        background: Red, green and blue, 0 to 1.
        color: The colour of points that have none.
        shaded: Show relief: darken points behind their neighbours and those whose normals look aside.
        device: Where to draw.

    Returns:
        Shape [h, w, 3], uint8 RGB; each pixel the mean of 2 x 2 samples. Points that are not finite are left out.

    Raises:
        ValueError: A size not above 0, or arrays of other shapes.
        DeviceError: No such device.

    Notes:
        Same bits from run to run on one device. 32 B of memory a pixel and 36 B a point.
    """
    points = check_rows("points", cloud.points, 3, dtype=np.float64)
    view = _check_view(view, points, width, height)
    diameter = _closing_size(points, view) if point_size is None else check_positive("point_size", point_size)
    radius = diameter * SAMPLES / 2
    place, origin = resolve_device(device), _middle(points)
    seen = _raster_view(view, origin)
    normals = upload(_rows_or_none("normals", cloud, len(points)), vec3, place)
    colors = upload(_rows_or_none("colors", cloud, len(points)), vec3, place)
    buffer = draw_points(upload(points - origin, vec3, place), seen, radius=radius)
    light: dict[str, Any] = {"background": _check_background(background), "lit": shaded, "relief": shaded}
    picture = shade_points(buffer, seen, Look(normals, colors, plain=vec3(*color), **light))
    return _to_image(picture, view)


def check_picture(path: Any, *, overwrite: bool) -> None:
    """Hold that a picture can be written, before any work.

    Raises:
        FileError: Another extension than .png, or a place that cannot be written.
    """
    if Path(path).suffix.lower() != ".png":
        raise FileError(path, "pictures are written as .png", remedy="Give a name that ends in .png")
    check_writable(path, overwrite=overwrite)


def save_picture(path: str | os.PathLike[str], image: NDArray[Any], *, overwrite: bool = True) -> None:
    """Write a picture as PNG.

    Args:
        path: Place of the file; ends in .png.
        image: Shape [h, w, 3] or [h, w], uint8.
        overwrite: Replace a file that exists.

    Raises:
        FileError: The file exists and may not be replaced, another extension, or the place cannot be written.
        TypeError, ValueError: Not such an image.
    """
    check_writable(path, overwrite=overwrite)
    write_png(path, image)


def _check_view(view: View | None, points: NDArray[np.float64], width: int, height: int) -> View:
    width, height = check_count("width", width), check_count("height", height)
    if view is None:
        return fit_view(points, width=width, height=height)
    if not isinstance(view, View):
        raise TypeError(f"view: expected a View, got {type(view).__name__}")
    return view


def _closing_size(points: NDArray[np.float64], view: View) -> float:
    """A diameter [px] for discs to touch: from the number of points in the squares of the picture that hold any."""
    T, camera, square = view.T_world_camera, view.intrinsic, 16
    local = (points - T[:3, 3]) @ T[:3, :3]
    local = local[local[:, 2] > 0]
    columns = (camera.fx * local[:, 0] / local[:, 2] + camera.cx) // square
    rows = (camera.fy * local[:, 1] / local[:, 2] + camera.cy) // square
    wide, high = -(-camera.width // square), -(-camera.height // square)
    inside = (columns >= 0) & (columns < wide) & (rows >= 0) & (rows < high)
    if not inside.any():
        return 2.0
    counts = np.bincount((rows[inside] * wide + columns[inside]).astype(np.int64))
    typical = float(np.quantile(counts[counts > 0], 0.4))
    return min(max(1.6 * square / math.sqrt(typical), 1.5), 12.0)


def _check_background(background: Triple) -> Any:
    return vec3(*check_shape("background", background, (3,)))


def _check_triangles(triangles: Any, vertex_count: int) -> NDArray[np.int32]:
    values = check_rows("triangles", triangles, 3)
    if values.size and (values.min() < 0 or values.max() >= vertex_count):
        raise ValueError(
            f"triangles: expected indices of {vertex_count} vertices, got {values.min()} to {values.max()}"
        )
    return values.astype(np.int32)


def _rows_or_none(name: str, holder: Any, rows: int) -> NDArray[np.float64]:
    """An optional attribute with one row a point, or no rows."""
    if not getattr(holder, f"has_{name}", True):  # a PointCloud raises where it has none
        return np.empty((0, 3))
    values = getattr(holder, name, None)
    if values is None or len(values) == 0:
        return np.empty((0, 3))
    return check_rows(name, values, 3, rows=rows, dtype=np.float64)


def _middle(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """The middle of the finite points' box: the kernels' float32 numbers count from there."""
    finite = points[np.isfinite(points).all(axis=1)]
    return (finite.min(axis=0) + finite.max(axis=0)) / 2 if len(finite) else np.zeros(3)


def _raster_view(view: View, origin: NDArray[np.float64]) -> raster.View:
    """The view as kernels take it: in cells of the buffer, about an origin [m]."""
    eye = view.T_world_camera[:3, 3] - origin
    return raster.View(view.intrinsic.scaled(SAMPLES), view.T_world_camera[:3, :3].T, eye)


def _to_image(picture: Any, view: View) -> NDArray[np.uint8]:
    return download(picture).reshape(view.intrinsic.height, view.intrinsic.width, 3).copy()  # sync
