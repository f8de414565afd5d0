"""Pictures of meshes and point clouds by our own kernels: no window, no graphics library, the same bits each time."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.drawing import z_buffer
from ...kernels.drawing.shading import SAMPLES, Look, shade_points, shade_triangles
from ...kernels.drawing.z_buffer import draw_points, draw_triangles
from ...kernels.lang import int32, vec3
from ...kernels.memory import download, upload
from ...pcd.checks import check_count, check_positive, check_rows, check_shape
from ...pcd.devices import resolve_device
from .view import Triple, View, fit_view

PLAIN: Triple = (0.80, 0.78, 0.74)  # what has no colour


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


def _raster_view(view: View, origin: NDArray[np.float64]) -> z_buffer.View:
    """The view as kernels take it: in cells of the buffer, about an origin [m]."""
    eye = view.T_world_camera[:3, 3] - origin
    return z_buffer.View(view.intrinsic.scaled(SAMPLES), view.T_world_camera[:3, :3].T, eye)


def _to_image(picture: Any, view: View) -> NDArray[np.uint8]:
    return download(picture).reshape(view.intrinsic.height, view.intrinsic.width, 3).copy()  # sync
