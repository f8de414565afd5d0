"""Software rendering of clouds, meshes and lines by kernels: no window, no graphics library, bitwise reproducible."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import check_pixels
from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import view_as
from ...core.checks import check_color, shown
from ...core.devices import DeviceLike, resolve_device
from ...core.units import called_by_user, warn_of_units
from ...core.up_axis import check_up
from ...kernels.drawing.layers import join_mattes
from ...kernels.drawing.placing import make_normal_lines
from ...kernels.lang import vec3, vec3i
from ...kernels.memory import download, empty
from ...kernels.meshes.mesh_measures import vertex_normals
from .canvas import Canvas
from .coloring import Coloring
from .frame_views import mesh_of_frames, view_scene
from .geometries import Named, check_units, named_geometries, parts_of
from .open3d_views import OPEN3D_KEYS, read_view
from .overlays import Overlays, check_bar, check_labels, check_legend, color_of
from .parts import PLAIN_LINE, Lines, Part, Points, Triangles, Triple
from .picture import Picture as Picture
from .scene import Drawing, Scene
from .styles import Style
from .up_axis import DEFAULT_LOOK, Look, look_of
from .view import Frame, Insets, View, ViewLike

BLACK_COLOR, WHITE_COLOR = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
PLAIN_BEFORE_DARK: Triple = (0.85, 0.85, 0.85)  # of lines without a color
NORMAL_COLOR: Triple = (0.1, 0.1, 0.1)
NORMAL_FRACTION = 0.02  # length of normals over the longest side of the scene
SHADINGS = ("smooth", "flat", "none")


@overload
def render(
    geometries: object, camera: ViewLike = None, *args: Any, depth: Literal[False] = False, **options: Any
) -> Picture: ...
@overload
def render(
    geometries: object, camera: ViewLike = None, *args: Any, depth: Literal[True], **options: Any
) -> tuple[Picture, NDArray[np.float32]]: ...
@explain_argument_errors
def render(
    geometries: object,
    camera: ViewLike = None,
    size: tuple[int, int] = (1280, 960),
    *,
    point_size: float | None = None,
    point_show_normal: bool = False,
    mesh_show_wireframe: bool = False,
    mesh_show_back_face: bool = True,
    background: Triple | str = (1.0, 1.0, 1.0),
    shading: str | None = None,
    labels: Iterable[tuple[str, Any]] | None = None,
    legend: bool | Iterable[tuple[str, ArrayLike]] | None = None,
    color_bar: bool | Coloring | None = None,
    scale_bar: bool = False,
    up: str | Triple | None = None,
    depth: bool = False,
    device: DeviceLike = None,
) -> Any:
    """Render an image of clouds, meshes, lines, boxes, cameras, trajectories and voxel grids.

    Args:
        geometries: One, a list, a mapping from names to geometries, or dictionaries with style keys as in Open3D's
            `draw`: {"geometry": cloud, "color_by": "height", "point_size": 3}. A result of `fuse` or `reconstruct` is
            its mesh, seen from the side of its cameras.
        camera: A View, the path of a JSON file of Open3D's viewer, or a mapping with some of its parameters zoom,
            front, lookat, up and field_of_view. If None, a view is fitted.
        size: Width and height [px]. Ignored if the camera is a View.
        point_size: Diameter of points [px]. If None, large enough to close most gaps between neighbors.
        point_show_normal: Draw normals as lines.
        mesh_show_wireframe: Draw the edges of triangles over their faces.
        mesh_show_back_face: Draw back faces. Without them one looks into a closed room from outside.
        background: Red, green and blue, 0 to 1, or "white", "black", "gray", or "transparent" for an RGBA image.
        shading: "smooth" or "flat" lights everything by vertex or face normals; "none" shows unlit colors. If None:
            meshes are lit, smoothly if they have normals, except textured ones. Points with normals and without colors
            are lit, other points get eye-dome lighting.
        labels: Texts and their positions [m]: [("door", [1, 0, 2])]. Labels that would overlap an earlier one are
            omitted.
        legend: Names and colors, [("before", (1, 0, 0))], or True for the names of the geometries.
        color_bar: True for the first `color_by` of the geometries, or a Coloring. A fitted view keeps the scene clear
            of it and of the legend.
        scale_bar: Draw a bar of a round length at the lower left, in the unit of the geometries, correct at the depth
            of the scene's center. Omitted if that is not in front of the camera.
        up: Up axis of a fitted view: "z", "y", "x" or a direction. If None, that of the first mesh that defines one
            (.glb, .gltf), else z.
        depth: Return depths, too.
        device: "cpu" or "cuda:N". If None, the device of the first geometry. Geometries on other devices are copied.

    Returns:
        A Picture: uint8 RGB array of shape (h, w, 3), displayed by notebooks and written by `loom.write_image`. Each
        pixel is the mean of 2 x 2 samples. With a transparent background RGBA, not premultiplied, shape (h, w, 4).
        With `depth`, also the depth along the optical axis [m], float32 (h, w), 0 for the background. Geometries with
        an opacity below 1 are ignored.

    Raises:
        TypeError, ValueError: Unsupported geometry or camera, or a size, color or name out of range.
        FileError: The camera file is not a view.
        DeviceError, MemoryError: Unknown device, or not enough memory for the pixels.

    Notes:
        Bitwise reproducible from run to run, for any number of threads, on the CPU and on CUDA. Takes about 80 B of
        memory per pixel, 190 B with transparent geometries. Non-finite points are not drawn. Transparency uses up to 16
        layers (depth peeling, Everitt, "Interactive order-independent transparency", NVIDIA 2001). A transparent cloud
        shows its foremost points only.

    Example:
        >>> import pointloom as loom
        >>> ball = loom.TriangleMesh.create_sphere(1.0)
        >>> picture = loom.render([ball, loom.AxisAlignedBoundingBox([-1, -1, -1], [1, 1, 1])], size=(320, 240))
        >>> picture.shape
        (240, 320, 3)
        >>> loom.render(ball, {"zoom": 0.5, "front": [1, 0, 0], "up": [0, 0, 1]}, (64, 48)).shape
        (48, 64, 3)
        >>> loom.render({"geometry": ball, "opacity": 0.4}, size=(64, 48), background="transparent").shape
        (48, 64, 4)
    """
    width, height = check_size(size)
    backdrop = check_background(background)
    if shading is not None and (not isinstance(shading, str) or shading not in SHADINGS):
        raise ValueError(f"shading: expected one of {', '.join(SHADINGS)} or None, got {shown(shading)}")
    if not isinstance(scale_bar, bool | np.bool_):
        raise TypeError(f"scale_bar: expected True or False, got {shown(scale_bar)}")
    explicit_up = None if up is None else check_up(up)
    if seen := mesh_of_frames(geometries):
        geometries = {"geometry": seen[0], "shaded": False if "vertex_colors" in seen[0].arrays else None}
        camera = view_scene(*seen, width=width, height=height) if camera is None else camera
    named = named_geometries(geometries)
    placed = [(geometry, style.pose) for _, geometry, style in named]
    unit = check_units(geometry for _, geometry, _ in named)
    target_device = device_of(named, device)
    for_all = Style(point_size=point_size, wireframe=mesh_show_wireframe or None, back_faces=mesh_show_back_face)
    texts, entries = check_labels(labels), check_legend(legend)
    groups = _groups_of(named, for_all, shading, target_device, on_dark=is_dark(backdrop))
    parts = _all_of(groups)
    if point_show_normal:
        parts += _normals_of(parts, PLAIN_BEFORE_DARK if is_dark(backdrop) else NORMAL_COLOR)
    scene = Scene(parts, target_device)
    if entries is True:
        entries = [(name, color_of(group)) for (name, _, _), group in zip(named, groups, strict=True) if group]
    overlays = Overlays(texts, entries or [], check_bar(color_bar, parts), bool(scale_bar), unit, is_dark(backdrop))
    insets = overlays.inset_choices(width, height)
    look = look_of(placed, explicit_up) if camera is None else DEFAULT_LOOK
    view = resolve_view(camera, scene, width, height, inset_choices=insets, look=look)
    drawing = scene.draw(view, paths_in_front=not depth)
    picture = _written(drawing, backdrop, overlays)
    if not depth:
        return picture
    depths = download(drawing.depth())  # sync
    return picture, depths.reshape(view.intrinsic.height, view.intrinsic.width).copy()


def _groups_of(
    named: Sequence[Named], for_all: Style, shading: str | None, device: DeviceLike, *, on_dark: bool
) -> list[list[Part]]:
    groups = [parts_of(geometry, style.over(for_all), device) for _, geometry, style in named]
    if shading is not None:
        groups = [
            parts if style.shaded is not None else [_shaded(part, shading) for part in parts]
            for parts, (_, _, style) in zip(groups, named, strict=True)
        ]
    return [[_before_dark(part) for part in parts] for parts in groups] if on_dark else groups


def _written(drawing: Drawing, background: Triple | None, overlays: Overlays) -> Picture:
    camera = drawing.view.intrinsic
    grounds = [drawing.before(color) for color in ((BLACK_COLOR, WHITE_COLOR) if background is None else (background,))]
    for ground in grounds:
        if overlays:
            overlays.write(Canvas(ground, camera.width, camera.height), drawing.view, drawing.scene.middle)
    pixels = download(join_mattes(*grounds) if background is None else grounds[0])  # sync
    return Picture(pixels.reshape(camera.height, camera.width, -1).copy())


def _before_dark(part: Part) -> Part:
    """A part whose lines without a color are light."""
    is_plain = isinstance(part, Lines) and part.plain == PLAIN_LINE
    return dataclasses.replace(part, plain=PLAIN_BEFORE_DARK) if is_plain else part


def _all_of(groups: list[list[Part]]) -> list[Part]:
    """The parts of all geometries. Warns if there are none."""
    parts = [part for group in groups for part in group]
    if not any(part.positions.size for part in parts) and called_by_user():
        has = "a geometry without points or faces" if groups else "an empty list"
        warn_of_units(f"geometries: expected points or faces, got {has}; the image is empty", UserWarning)
    return parts


def resolve_view(
    camera: ViewLike,
    scene: Scene,
    width: int,
    height: int,
    *,
    inset_choices: Sequence[Insets] = (),
    look: Look = DEFAULT_LOOK,
) -> View:
    """View for the `camera` of `render`. A fitted view uses those of `inset_choices` that allow the closest view."""
    if camera is None:
        direction, up = look
        views = [scene.fit(Frame(direction, up, width, height, room)) for room in inset_choices or [(0, 0, 0, 0)]]
        return max(views, key=lambda view: float(view.T_world_camera[:3, 3] @ view.T_world_camera[:3, 2]))
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
    """Open3D view parameters that are given. Unknown names are an error."""
    unknown = [key for key in given if key not in OPEN3D_KEYS]
    if unknown:
        raise ValueError(f"{name}: expected the keys {', '.join(OPEN3D_KEYS)}, got {unknown[0]!r}")
    return {key: value for key, value in given.items() if value is not None}


def check_size(size: Any) -> tuple[int, int]:
    try:
        width, height = size
    except (TypeError, ValueError) as error:
        raise ValueError(f"size: expected columns and rows, got {shown(size)}") from error
    return check_pixels("size", width), check_pixels("size", height)


def _shaded(part: Part, shading: str) -> Part:
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


def device_of(named: Sequence[Named], device: DeviceLike) -> Any:
    """The given device, else that of the first geometry that has one."""
    if device is None:
        devices = (getattr(geometry, "device", None) for _, geometry, _ in named)
        device = next((each for each in devices if hasattr(each, "is_cuda")), None)
    return resolve_device(device)


def _normals_of(parts: Sequence[Part], color: Triple) -> list[Part]:
    clouds = [part for part in parts if isinstance(part, Points) and part.normals.size]
    if not clouds:
        return []
    low, high = Scene(clouds, clouds[0].positions.device).bounds
    size = NORMAL_FRACTION * float((high - low).max()) or 1.0
    lines: list[Part] = []
    for part in clouds:
        ends, indices = make_normal_lines(part.positions, part.normals, size)
        none = empty(0, vec3, part.positions.device)
        lines.append(Lines(ends, part.origin, indices, none, width=1.0, plain=color, pose=part.pose))
    return lines


TRANSPARENT = "transparent"
NAMED_COLORS: dict[str, Triple] = {
    "white": (1.0, 1.0, 1.0),
    "black": (0.0, 0.0, 0.0),
    "gray": (0.5, 0.5, 0.5),
    "grey": (0.5, 0.5, 0.5),
}
MAX_DARK_LUMINANCE = 0.25  # luminance of a background below which lines without a color are light


def check_background(background: object) -> Triple | None:
    """Background color, None if transparent. Raises TypeError or ValueError."""
    if isinstance(background, str):
        if background != TRANSPARENT and background not in NAMED_COLORS:
            names = ", ".join((*NAMED_COLORS, TRANSPARENT))
            raise ValueError(f"background: expected one of {names}, or red, green and blue, got {shown(background)}")
        return NAMED_COLORS.get(background)
    red, green, blue = check_color("background", background).tolist()
    return red, green, blue


def is_dark(background: Triple | None) -> bool:
    """True if dark lines have too little contrast to a background (luminance of ITU-R BT.709)."""
    if background is None:
        return False
    red, green, blue = background
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue < MAX_DARK_LUMINANCE
