"""What is drawn of each kind of geometry: names of what users pass, its parts, and the box around them."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.checks import check_name, check_rows, is_on_gpu
from ...core.devices import resolve_device
from ...core.units import LengthUnit, common_unit
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import vec3
from ...kernels.memory import empty, move, upload
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.voxel_grid import VoxelGrid
from ...meshing.volume.tsdf import TSDFVolume
from ...pcd.bounding_box import BoundingBox
from ...pcd.cloud import PointCloud
from ...pcd.convex_hull import ConvexHull
from ...pcd.line_set import LineSet
from ...pcd.polygon_volume import SelectionPolygonVolume
from ...pcd.splat_pictures import columns_of
from ...pcd.splats import GaussianSplats
from ...pcd.units import InUnit
from . import outlines
from .coloring import color_cloud
from .frustum import CameraFrustum
from .parts import Gaussians, Lines, Part, Points, Triple
from .styles import STYLE_KEYS, Style
from .surfaces import mesh_parts, vertices_of, voxel_parts

ACCEPTED = (
    "PointCloud, TriangleMesh, VoxelGrid, AxisAlignedBoundingBox, OrientedBoundingBox, LineSet, Trajectory, "
    "ConvexHull, SelectionPolygonVolume, TSDFVolume, GaussianSplats, CameraFrustum, an array of points [n, 3], an "
    'object with points, or with vertices and triangles; or {"geometry": ...} with keys of style; files '
    "are read first: loom.read_point_cloud, loom.read_triangle_mesh"
)

# Several clouds without colours: the first two as in Open3D's tutorials of registration.
PALETTE: tuple[Triple, ...] = (
    (1.0, 0.706, 0.0),
    (0.0, 0.651, 0.929),
    (0.75, 0.24, 0.35),
    (0.25, 0.62, 0.36),
    (0.55, 0.38, 0.75),
    (0.45, 0.45, 0.45),
)


Named = tuple[str, Any, Style]


def named_geometries(geometries: Any) -> list[Named]:
    """What is to be drawn, each with a name of its own and a style.

    Args:
        geometries: One geometry, a list or tuple of them, a mapping from names to geometries, or dictionaries as
            Open3D's `draw` takes: {"geometry": g, "name": "floor", "color": (1, 0, 0)}, with the fields of `Style`.

    Raises:
        TypeError: Something else; says what is accepted.
        ValueError: A key that no style has, or a value out of range.
    """
    if isinstance(geometries, Mapping) and "geometry" not in geometries:
        given = [(check_name("geometries: names", name), value) for name, value in geometries.items()]
    elif isinstance(geometries, list | tuple):
        given = [(None, value) for value in geometries]
    else:
        given = [(None, geometries)]
    found: list[Named] = []
    taken: dict[str, int] = {}
    for name, value in given:
        geometry, style = value, Style()
        if isinstance(value, Mapping):
            name, geometry, style = _read_entry(value, name)
        geometry = as_known(geometry)
        kind = kind_of(geometry)
        name = _free_name(name or kind, taken)
        found.append((name, geometry, style))
    return _told_apart(found)


def check_units(geometries: Iterable[Any]) -> LengthUnit | None:
    """The unit of geometries; warns of several: they lie where nothing is to scale."""
    return common_unit("geometries", (geometry.unit for geometry in geometries if isinstance(geometry, InUnit)))


def _read_entry(entry: Mapping[Any, Any], name: str | None) -> tuple[str | None, Any, Style]:
    """The name, geometry and style of a dictionary as Open3D's `draw` takes it."""
    unknown = [key for key in entry if key not in ("geometry", "name", *STYLE_KEYS)]
    if "geometry" not in entry or unknown:
        wrong = f"key {unknown[0]!r}" if unknown else 'no key "geometry"'
        raise ValueError(f"geometries: expected the keys geometry, name, {', '.join(STYLE_KEYS)}, got {wrong}")
    if name is None and entry.get("name") is not None:
        name = check_name("name", entry["name"])
    return name, entry["geometry"], Style(**{key: entry[key] for key in STYLE_KEYS if key in entry})


def _free_name(name: str, taken: dict[str, int]) -> str:
    """A name that is not taken; takes it. Of each name, the last number that was tried behind it."""
    number, free = taken.get(name, 1), name
    while free in taken:
        number += 1
        free = f"{name} {number}"
    taken[name], taken[free] = number, taken.get(free, 1) if free != name else number
    return free


def _told_apart(named: list[Named]) -> list[Named]:
    """Several clouds that have no colour get different ones."""
    plain = [
        name
        for name, geometry, style in named
        if kind_of(geometry) in ("cloud", "points")
        and style.color is None
        and style.color_by is None
        and not _has_colors(geometry)
    ]
    if len(plain) < 2:
        return named
    colors = {name: PALETTE[i % len(PALETTE)] for i, name in enumerate(plain)}
    return [(n, g, dataclasses.replace(s, color=colors[n]) if n in colors else s) for n, g, s in named]


def _has_colors(cloud: Any) -> bool:
    if isinstance(cloud, PointCloud):
        return bool(cloud.has_colors)
    colors = getattr(cloud, "colors", None)
    return colors is not None and len(colors) > 0


def kind_of(geometry: Any) -> str:
    """What a geometry is called when it has no name.

    Raises:
        TypeError: It is nothing that can be drawn; says what is.
    """
    return _entry_of(as_known(geometry))[0]


def as_known(geometry: Any) -> Any:
    """Open3D's tensor geometries as its others, its tensors as arrays; anything else as it is."""
    if isinstance(geometry, (type, *(kind for kind, _ in _KINDS))):
        return geometry
    if callable(getattr(geometry, "to_legacy", None)):
        return geometry.to_legacy()
    has_memory = hasattr(geometry, "__dlpack__") and hasattr(geometry, "__dlpack_device__")
    is_read_by_numpy = hasattr(geometry, "__array__") or hasattr(geometry, "__array_interface__")
    if not has_memory or is_read_by_numpy or is_on_gpu(geometry):
        return geometry
    return np.from_dlpack(geometry)


def parts_of(geometry: Any, style: Style | None = None, device: Any = None) -> list[Part]:
    """What is drawn of a geometry.

    Args:
        geometry: One of those accepted.
        style: How.
        device: Where; None where the geometry lies, else the CPU.

    Returns:
        Parts; what a cloud or a mesh holds on that device is shared, not copied.

    Raises:
        TypeError: Nothing that can be drawn.
        ValueError: Arrays that do not belong together.
    """
    style, geometry = style or Style(), as_known(geometry)
    place = resolve_device(getattr(geometry, "device", None) if device is None else device)
    parts = _entry_of(geometry)[1](geometry, style, place)
    return [part if style.pose is None else dataclasses.replace(part, pose=style.pose) for part in parts]


def bounds_of(parts: Iterable[Part]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The box around the finite positions of parts as they are drawn, (low, high) [m]; zeros if there are none."""
    corners = []
    for part in parts:
        low, high, count = bound_points(part.positions)
        if not count:
            continue
        ends = np.stack([low, high]).astype(np.float64) + part.origin
        if part.pose is not None:
            box = np.array([[ends[i, 0], ends[j, 1], ends[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
            ends = box @ part.pose[:3, :3].T + part.pose[:3, 3]
        corners += [ends.min(axis=0), ends.max(axis=0)]
    if not corners:
        return np.zeros(3), np.zeros(3)
    return np.min(corners, axis=0), np.max(corners, axis=0)


# ------------------------------------------------------------------------------------------------ kinds


def _of_cloud(cloud: PointCloud, style: Style, device: Any) -> list[Part]:
    held = {name: move(cloud._device_array(name), device) for name in ("points", "normals", "colors") if name in cloud}
    colors = held.get("colors", empty(0, vec3, device))
    coloring = None
    has_own = "colors" in held and style.color is None and style.color_by in (None, "rgb")
    if style.color_by is not None:
        coloring = color_cloud(cloud, style.color_by, colormap=style.colormap, limits=style.limits)
        colors = move(coloring.colors, device)
    elif style.color is not None:
        colors = empty(0, vec3, device)
    normals = held.get("normals", empty(0, vec3, device))
    part = _points(held["points"], cloud.origin, colors, normals, style, has_own)
    return [dataclasses.replace(part, coloring=coloring)]


def _points(
    positions: Any, origin: NDArray[np.float64], colors: Any, normals: Any, style: Style, has_own: bool
) -> Points:
    """Points whose own colours stay as they are, but where a style wants light at an angle."""
    part = Points(positions, origin, colors, normals, size=style.point_size, metric=style.metric)
    shaded, lit = style.shaded is not False, style.shaded is True or not has_own
    opacity = 1.0 if style.opacity is None else style.opacity
    return dataclasses.replace(part, plain=style.color or part.plain, shaded=shaded, lit=lit, opacity=opacity)


def _of_splats(splats: GaussianSplats, style: Style, device: Any) -> list[Part]:
    """Splats as what they are; in one colour or by values as points."""
    splats = splats.to(device)
    (points,) = _of_cloud(splats.to_point_cloud(), style, device)
    if not isinstance(points, Points) or style.color is not None or style.color_by is not None or not len(splats):
        return [points]
    fields = {field.name: getattr(points, field.name) for field in dataclasses.fields(points)}
    if points.size is None:
        fields |= {"size": 2 * float(np.median(splats.scales)), "metric": True}
    return [Gaussians(**{**fields, "normals": empty(0, vec3, device)}, columns=columns_of(splats))]


def _of_points(geometry: Any, style: Style, device: Any) -> list[Part]:
    """An array of points, or a plain object that has them."""
    has_attributes = hasattr(geometry, "points")
    cloud = PointCloud(geometry.points if has_attributes else geometry, device=device)
    if style.color_by is not None and has_attributes:
        for name in ("normals", "colors"):
            rows = optional_rows(geometry, name, len(cloud))
            if len(rows):
                setattr(cloud, name, rows)
        return _of_cloud(cloud, style, device)
    normals, colors = (optional_rows(geometry, name, len(cloud)) for name in ("normals", "colors"))
    if style.color is not None:
        colors = colors[:0]
    arrays = upload(colors, vec3, device), upload(normals, vec3, device)
    return [_points(cloud._device_array("points"), cloud.origin, *arrays, style, len(colors) > 0)]


def optional_rows(holder: Any, name: str, rows: int) -> NDArray[np.float32]:
    """An attribute of a plain object with one row an element, or no rows where it has none; colours 0 to 1."""
    values = getattr(holder, name, None)
    if values is None or len(values) == 0:
        return np.empty((0, 3), np.float32)
    array = check_rows(name, values, 3, rows=rows)
    if array.dtype == np.uint8:
        return array.astype(np.float32) / np.float32(255)
    return check_rows(name, array, 3, dtype=np.float32)


def _of_mesh(mesh: Any, style: Style, device: Any) -> list[Part]:
    if not isinstance(mesh, TriangleMesh):
        made = TriangleMesh(mesh.vertices, mesh.triangles, device=device)
        rows = {
            n: optional_rows(mesh, n, made._device_arrays["vertices"].size) for n in ("vertex_normals", "vertex_colors")
        }
        held: dict[str, Any] = {n: upload(values, vec3, device) for n, values in rows.items() if len(values)}
        mesh = made._with_arrays(**held)
    mesh, chosen = mesh.to(device), _surface_style(style)
    if style.color_by is not None:
        coloring = color_cloud(vertices_of(mesh), style.color_by, colormap=style.colormap, limits=style.limits)
        chosen |= {"colors": coloring.colors, "coloring": coloring}
    return mesh_parts(mesh, chosen)


def _surface_style(style: Style) -> dict[str, Any]:
    """The fields of `Triangles` that a style decides; without a key where it leaves it to the part."""
    chosen: dict[str, Any] = {"wireframe": bool(style.wireframe), "cull": style.back_faces is False}
    decided = {"lit": style.shaded, "plain": style.color, "opacity": style.opacity}
    return chosen | {name: value for name, value in decided.items() if value is not None}


def _of_voxels(grid: VoxelGrid, style: Style, device: Any) -> list[Part]:
    parts: list[Part] = voxel_parts(grid, _surface_style(style), device)
    return parts


def _of_hull(hull: ConvexHull, style: Style, device: Any) -> list[Part]:
    if style.wireframe is False:
        return _of_mesh(hull, style, device)
    return [_lines(outlines.of_triangles(hull.vertices, hull.triangles), style, device)]


def _of_tsdf(volume: TSDFVolume, style: Style, device: Any) -> list[Part]:
    return _of_mesh(volume.extract_triangle_mesh(), style, device)


def _lines(drawn: outlines.Segments, style: Style, device: Any) -> Lines:
    if style.opacity is not None and style.opacity < 1:
        raise ValueError(f"opacity: lines are drawn whole; it is for points and faces, got {style.opacity}")
    part = outlines.upload_lines(drawn, device)
    if style.color is not None:
        part = dataclasses.replace(part, colors=empty(0, vec3, device), plain=style.color)
    return part if style.line_width is None else dataclasses.replace(part, width=style.line_width)


def _outlined(outline: Callable[[Any], outlines.Segments]) -> Callable[[Any, Style, Any], list[Part]]:
    """Parts of what is drawn as lines alone."""
    return lambda geometry, style, device: [_lines(outline(geometry), style, device)]


Entry = tuple[str, Callable[[Any, Style, Any], list[Part]]]

_KINDS: list[tuple[type, Entry]] = [
    (PointCloud, ("cloud", _of_cloud)),
    (TriangleMesh, ("mesh", _of_mesh)),
    (VoxelGrid, ("voxels", _of_voxels)),
    (BoundingBox, ("box", _outlined(outlines.of_box))),
    (LineSet, ("lines", _outlined(outlines.of_line_set))),
    (Trajectory, ("trajectory", _outlined(outlines.of_trajectory))),
    (ConvexHull, ("hull", _of_hull)),
    (SelectionPolygonVolume, ("volume", _outlined(outlines.of_volume))),
    (TSDFVolume, ("surface", _of_tsdf)),
    (GaussianSplats, ("splats", _of_splats)),
    (CameraFrustum, ("camera", _outlined(outlines.of_frustum))),
]


def _entry_of(geometry: Any) -> Entry:
    if isinstance(geometry, type):
        raise TypeError(f"geometries: expected a geometry, got the class {geometry.__name__}")
    if isinstance(geometry, str | os.PathLike):
        raise TypeError(f"geometries: expected {ACCEPTED}; got {os.fspath(geometry)!r}")
    for kind, entry in _KINDS:
        if isinstance(geometry, kind):
            return entry
    if isinstance(geometry, np.ndarray) or is_on_gpu(geometry) or hasattr(geometry, "__dlpack__"):
        return "points", _of_points
    if hasattr(geometry, "get_box_points"):
        return "box", _outlined(outlines.of_box)
    if hasattr(geometry, "points") and hasattr(geometry, "lines"):
        return "lines", _outlined(outlines.of_line_set)
    if hasattr(geometry, "vertices") and hasattr(geometry, "triangles"):
        return "mesh", _of_mesh
    if hasattr(geometry, "points"):
        return "cloud", _of_points
    kind = type(geometry)  # with where it is from: others have a VoxelGrid as well
    found = kind.__name__ if kind.__module__ == "builtins" else f"{kind.__module__}.{kind.__name__}"
    raise TypeError(f"geometries: expected {ACCEPTED}; got {found}")
