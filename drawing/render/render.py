"""Pictures of clouds, meshes and lines by our own kernels: no window, no graphics library, the same bits everywhere."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import check_pixels
from ...core.array_libraries import view_as
from ...core.checks import check_color, check_list, check_name, check_shape, shown
from ...core.devices import resolve_device
from ...core.told_arguments import told_arguments
from ...core.units import asked_by_user, warn_of_units
from ...kernels.drawing.placing import make_normal_lines
from ...kernels.lang import vec3, vec3i
from ...kernels.memory import download, empty
from ...kernels.meshes.mesh_measures import vertex_normals
from .canvas import Canvas
from .coloring import Coloring
from .geometries import Named, Style, check_units, named_geometries, parts_of
from .legends import draw_color_bar, draw_labels, draw_legend
from .open3d_views import OPEN3D_KEYS, read_view
from .parts import Lines, Part, Points, Triangles, Triple
from .picture import Picture as Picture
from .scene import Scene
from .view import Frame, View

DIRECTION: Triple = (-0.65, 0.7, -0.75)  # down from the front right, as onto a doll's house
UP: Triple = (0.0, 0.0, 1.0)
NORMAL_SHARE = 0.02  # length of the lines along normals, as a share of the scene's longest side
SHADINGS = ("smooth", "flat", "none")


@overload
def render(
    geometries: Any, camera: Any = None, *args: Any, depth: Literal[False] = False, **options: Any
) -> Picture: ...
@overload
def render(
    geometries: Any, camera: Any = None, *args: Any, depth: Literal[True], **options: Any
) -> tuple[Picture, NDArray[np.float32]]: ...
@told_arguments
def render(
    geometries: Any,
    camera: Any = None,
    size: tuple[int, int] = (1280, 960),
    *,
    point_size: float | None = None,
    point_show_normal: bool = False,
    mesh_show_wireframe: bool = False,
    mesh_show_back_face: bool = True,
    background: Triple = (1.0, 1.0, 1.0),
    shading: str | None = None,
    labels: Iterable[tuple[str, Any]] | None = None,
    legend: Any = None,
    color_bar: Any = None,
    depth: bool = False,
    device: Any = None,
) -> Any:
    """Draw a picture of clouds, meshes, lines, boxes, cameras, trajectories and voxel grids.

    Args:
        geometries: One, a list of them, a mapping from names to them, or dictionaries with keys of style, as Open3D's
            `draw` takes: {"geometry": cloud, "color_by": "height", "point_size": 3}.
        camera: Where from: a View, the path of a JSON file that Open3D's viewer wrote, or a mapping with some of its
            parameters zoom, front, lookat, up and field_of_view. None fits a view.
        size: Columns and rows [px]; a View brings its own.
        point_size: Diameter of points [px]; None takes one that closes most gaps between neighbours.
        point_show_normal: Draw normals as lines.
        mesh_show_wireframe: Draw the edges of triangles over their faces.
        mesh_show_back_face: Draw triangles that look away; without them one sees into a closed room.
        background: Red, green and blue, 0 to 1.
        shading: "smooth" or "flat" lights all that is drawn at an angle, by normals of vertices or of faces; "none"
            shows colours as they are. None takes what suits: meshes are lit, smoothly if they have normals, except
            those with textures, which hold the light of the photographs; points that have normals and no colours of
            their own are lit, others are darker where they lie behind their neighbours.
        labels: Texts and the places [m] that they belong to: [("door", [1, 0, 2])]. One that would lie on an earlier
            one in the picture is left out: give those that matter most first.
        legend: Names and colours, [("before", (1, 0, 0))], or True for the names of the geometries.
        color_bar: True for what the first `color_by` of the geometries means, or a Coloring.
        depth: Return depths, too.
        device: "cpu", "cuda:N"; None where the first geometry lies, to which the others are copied.

    Returns:
        A Picture: an array of shape [h, w, 3], uint8 RGB, that notebooks show and `loom.save_picture(path, picture)`
        writes; each pixel is the mean of 2 x 2 samples.
        With `depth` a pair of it and the depth along the optical axis [m], float32 [h, w], 0 where nothing is seen.

    Raises:
        TypeError: A geometry of another kind, or a camera that is none; says what is accepted.
        ValueError: A size, colour or name out of range.
        FileError: The file of the camera is no view.
        DeviceError: No such device.
        MemoryError: No room for so many pixels.

    Notes:
        The same bits from run to run, with any number of threads, on the CPU and on CUDA. Some 80 B of memory a pixel;
        the arrays of clouds and meshes on the device are shared. Where points crowd, those that lie behind another in
        the same quarter of a pixel are left out before they are drawn as discs. What is not finite is not drawn.

    Example:
        >>> import pointloom as loom
        >>> ball = loom.TriangleMesh.create_sphere(1.0)
        >>> picture = loom.render([ball, loom.AxisAlignedBoundingBox([-1, -1, -1], [1, 1, 1])], size=(320, 240))
        >>> picture.shape
        (240, 320, 3)
        >>> loom.render(ball, {"zoom": 0.5, "front": [1, 0, 0], "up": [0, 0, 1]}, (64, 48)).shape
        (48, 64, 3)
    """
    width, height = check_size(size)
    backdrop = check_color("background", background).tolist()
    if shading is not None and (not isinstance(shading, str) or shading not in SHADINGS):
        raise ValueError(f"shading: expected one of {', '.join(SHADINGS)} or None, got {shown(shading)}")
    named = named_geometries(geometries)
    check_units(geometry for _, geometry, _ in named)
    place = device_of(named, device)
    for_all = Style(point_size=point_size, wireframe=mesh_show_wireframe or None, back_faces=mesh_show_back_face)
    texts = _check_labels(labels)
    entries = _check_legend(legend)
    groups = [parts_of(geometry, style.over(for_all), place) for _, geometry, style in named]
    if shading is not None:
        groups = [
            parts if style.shaded is not None else [_shaded(part, shading) for part in parts]
            for parts, (_, _, style) in zip(groups, named, strict=True)
        ]
    parts = _all_of(groups)
    if point_show_normal:
        parts += _normals_of(parts)
    scene = Scene(parts, place)
    view = resolve_view(camera, scene, width, height)
    drawing = scene.draw(view, background=(backdrop[0], backdrop[1], backdrop[2]))
    camera_size = view.intrinsic.width, view.intrinsic.height
    if entries is True:
        entries = [(name, _color_of(group)) for (name, _, _), group in zip(named, groups, strict=True) if group]
    coloring = _check_bar(color_bar, parts)
    if texts or entries or coloring is not None:
        _write_on(Canvas(drawing.picture, *camera_size), _project(texts, view), entries or [], coloring)
    picture = Picture(download(drawing.picture).reshape(*camera_size[::-1], 3).copy())  # sync
    if not depth:
        return picture
    depths = download(drawing.depth())  # sync
    return picture, depths.reshape(camera_size[::-1]).copy()


def _all_of(groups: list[list[Part]]) -> list[Part]:
    """The parts of all geometries; a user is warned where there is nothing to draw."""
    parts = [part for group in groups for part in group]
    if not any(part.positions.size for part in parts) and asked_by_user():
        has = "a geometry without points or faces" if groups else "an empty list"
        warn_of_units(f"geometries: nothing to draw in {has}, so that the picture is empty", UserWarning)
    return parts


def resolve_view(camera: Any, scene: Scene, width: int, height: int) -> View:
    """The view that `render` and the viewer are asked for.

    Args:
        camera: As of `render`.
        scene: What is drawn.
        width, height: Of a view that brings no size [px].
    """
    if camera is None:
        return scene.fit(Frame(DIRECTION, UP, width, height))
    if isinstance(camera, View):
        return camera
    if isinstance(camera, str | os.PathLike):
        return read_view(camera, width=width, height=height)
    if isinstance(camera, Mapping):
        return View.from_open3d(scene.bounds, width=width, height=height, **open3d_parameters("camera", camera))
    raise TypeError(
        f"camera: expected a View, the path of a view's JSON or a mapping with {', '.join(OPEN3D_KEYS)}, "
        f"got {type(camera).__name__}"
    )


def open3d_parameters(name: str, given: Mapping[str, Any]) -> dict[str, Any]:
    """Open3D's parameters of a view, those that are told; an unknown one is an error."""
    unknown = [key for key in given if key not in OPEN3D_KEYS]
    if unknown:
        raise ValueError(f"{name}: expected the keys {', '.join(OPEN3D_KEYS)}, got {unknown[0]!r}")
    return {key: value for key, value in given.items() if value is not None}


def check_size(size: Any) -> tuple[int, int]:
    """Columns and rows of a picture."""
    try:
        width, height = size
    except (TypeError, ValueError) as error:
        raise ValueError(f"size: expected columns and rows, got {shown(size)}") from error
    return check_pixels("size", width), check_pixels("size", height)


def _shaded(part: Part, shading: str) -> Part:
    """A part lit as `render` was asked to."""
    if isinstance(part, Points):
        return dataclasses.replace(part, shaded=shading != "none", lit=True)
    if not isinstance(part, Triangles):
        return part
    if shading == "none":
        return dataclasses.replace(part, lit=False)
    normals = part.normals
    if shading == "flat":
        normals = empty(0, vec3, part.positions.device)
    elif not normals.size:
        corners = view_as(part.indices, vec3i, (part.indices.size // 3,))
        normals = vertex_normals(part.positions, corners)
    return dataclasses.replace(part, normals=normals, lit=True)


def device_of(named: Sequence[Named], device: Any) -> Any:
    """The device to draw on: the one given, else that of the first geometry that lies on one."""
    if device is None:
        held = (getattr(geometry, "device", None) for _, geometry, _ in named)
        device = next((each for each in held if hasattr(each, "is_cuda")), None)
    return resolve_device(device)


def _normals_of(parts: Sequence[Part]) -> list[Part]:
    """Lines along the normals of points."""
    clouds = [part for part in parts if isinstance(part, Points) and part.normals.size]
    if not clouds:
        return []
    low, high = Scene(clouds, clouds[0].positions.device).bounds
    size = NORMAL_SHARE * float((high - low).max()) or 1.0
    lines: list[Part] = []
    for part in clouds:
        ends, indices = make_normal_lines(part.positions, part.normals, size)
        none = empty(0, vec3, part.positions.device)
        lines.append(Lines(ends, part.origin, indices, none, width=1.0, plain=(0.1, 0.1, 0.1), pose=part.pose))
    return lines


def _check_labels(labels: Any) -> list[tuple[str, NDArray[np.float64]]]:
    found = []
    for entry in check_list("labels", [] if labels is None else labels, "texts with places"):
        text, place = _pair("labels", entry, "a text and a place")
        found.append((check_name("labels", text), check_shape("labels", place, (3,))))
    return found


def _check_legend(legend: Any) -> Any:
    if legend is None or legend is False or legend is True:
        return legend
    found = []
    for entry in check_list("legend", legend, "names with colours"):
        name, color = _pair("legend", entry, "a name and a colour")
        red, green, blue = check_color("legend", color).tolist()
        found.append((check_name("legend", name), (red, green, blue)))
    return found


def _pair(name: str, entry: Any, of: str) -> tuple[Any, Any]:
    try:
        first, second = entry
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: expected {of} each, got {str(entry)[:60]}") from error
    return first, second


def _project(labels: Sequence[tuple[str, NDArray[np.float64]]], view: View) -> list[tuple[str, float, float]]:
    """Labels with their places in the picture [px], of those before the camera."""
    camera, T, found = view.intrinsic, view.T_world_camera, []
    for text, place in labels:
        x, y, z = ((place - T[:3, 3]) @ T[:3, :3]).tolist()
        if z > 0:
            found.append((text, camera.fx * x / z + camera.cx, camera.fy * y / z + camera.cy))
    return found


def _color_of(parts: Sequence[Part]) -> Triple:
    """The colour by which a legend shows a geometry: its own, or the mean of its points' or vertices'."""
    part = parts[0]
    if not part.colors.size:
        return part.plain
    red, green, blue = np.clip(np.nanmean(download(part.colors)[:: max(1, part.colors.size // 10_000)], axis=0), 0, 1)
    return float(red), float(green), float(blue)


def _write_on(
    canvas: Canvas, labels: list[tuple[str, float, float]], entries: list[Any], coloring: Coloring | None
) -> None:
    """Write the words of a picture over it."""
    draw_labels(canvas, labels)
    draw_legend(canvas, entries)
    if coloring is not None:
        draw_color_bar(canvas, coloring)


def _check_bar(color_bar: Any, parts: Sequence[Part]) -> Coloring | None:
    """What a colour bar shows."""
    if color_bar is None or color_bar is False or isinstance(color_bar, Coloring):
        return color_bar or None
    if color_bar is not True:
        raise TypeError(f"color_bar: expected True or a Coloring, got {type(color_bar).__name__}")
    colorings = [part.coloring for part in parts if not isinstance(part, Lines) and part.coloring is not None]
    if not colorings:
        raise ValueError('color_bar: no cloud or mesh has "color_by"; pass {"geometry": cloud, "color_by": "height"}')
    return colorings[0]
