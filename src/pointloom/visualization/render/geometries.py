"""Conversion of geometries to drawn parts, with names and bounds."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Callable, Collection, Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.array_libraries import view_as
from ...core.checks import check_name, check_rows, is_on_gpu
from ...core.devices import DeviceLike, resolve_device
from ...core.other_geometry import conversion_of, is_other
from ...core.units import LengthUnit
from ...kernels.array_types import AnyArray
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import int32, vec2, vec3
from ...kernels.memory import empty, move, upload
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.other_objects import from_any, is_scene
from ...meshing.mesh.voxel_grid import VoxelGrid
from ...meshing.volume.tsdf import TSDFVolume
from ...pcd.bounding_box import BoundingBox
from ...pcd.cloud import PointCloud
from ...pcd.convex_hull import ConvexHull
from ...pcd.line_set import LineSet
from ...pcd.polygon_volume import SelectionPolygonVolume
from ...pcd.splat_images import columns_of
from ...pcd.splats import GaussianSplats
from ...pcd.units import InUnit, common_reference
from . import outlines
from .coloring import Coloring, color_cloud
from .frame_views import mesh_of_frames
from .frustum import CameraFrustum
from .outlines import Segments, upload_lines
from .parts import Gaussians, Lines, Part, Points, Triangles, Triple
from .styles import STYLE_KEYS, Style

ACCEPTED = (
    "PointCloud, TriangleMesh, VoxelGrid, AxisAlignedBoundingBox, OrientedBoundingBox, LineSet, Trajectory, "
    "ConvexHull, SelectionPolygonVolume, TSDFVolume, GaussianSplats, CameraFrustum, an array of points [n, 3], a cloud "
    "or mesh that loom.from_any takes, an object with points, or with vertices and triangles; or "
    '{"geometry": ...} with keys of style; read files first with loom.read_point_cloud or loom.read_triangle_mesh'
)

# Colors of several clouds without colors. The first two as in Open3D's registration tutorials.
CLOUD_COLORS: tuple[Triple, ...] = (
    (1.0, 0.706, 0.0),
    (0.0, 0.651, 0.929),
    (0.75, 0.24, 0.35),
    (0.25, 0.62, 0.36),
    (0.55, 0.38, 0.75),
    (0.45, 0.45, 0.45),
)


DEFAULT_COLOR_BY = "height"  # of a single cloud without colors. KITTI's and Autzen's intensities are mostly dark

Named = tuple[str, Any, Style]


def named_geometries(geometries: object, colored: Collection[str] = ()) -> list[Named]:
    """Unique names and styles of geometries, given as one, a list, a mapping, or dictionaries as in Open3D's `draw`.

    A single cloud without colors is colored by height, as in Open3D, and several get different colors. `colored` names
    clouds whose colors are stored elsewhere. Raises TypeError for unsupported types and ValueError for unknown style
    keys or values out of range.
    """
    if isinstance(geometries, Mapping) and "geometry" not in geometries:
        given = [(check_name("geometries: names", name), value) for name, value in geometries.items()]
    elif isinstance(geometries, list | tuple):
        given = [(None, value) for value in geometries]
    else:
        given = [(None, geometries)]
    named: list[Named] = []
    taken: dict[str, int] = {}
    for name, value in given:
        geometry, style = value, Style()
        if isinstance(value, Mapping):
            name, geometry, style = _read_entry(value, name)
        seen = mesh_of_frames(geometry)
        geometry = seen[0] if seen else as_known(geometry)
        kind = kind_of(geometry)
        name = _free_name(name or kind, taken)
        named.append((name, geometry, style))
    return _with_default_colors(named, colored)


def check_units(geometries: Iterable[Any]) -> LengthUnit | None:
    return common_reference("geometries", [each for each in geometries if isinstance(each, InUnit)])[0]


def _read_entry(entry: Mapping[Any, Any], name: str | None) -> tuple[str | None, Any, Style]:
    """Name, geometry and style of a dictionary as in Open3D's `draw`."""
    unknown = [key for key in entry if key not in ("geometry", "name", *STYLE_KEYS)]
    if "geometry" not in entry or unknown:
        wrong = f"key {unknown[0]!r}" if unknown else 'no key "geometry"'
        raise ValueError(f"geometries: expected the keys geometry, name, {', '.join(STYLE_KEYS)}, got {wrong}")
    if name is None and entry.get("name") is not None:
        name = check_name("name", entry["name"])
    return name, entry["geometry"], Style(**{key: entry[key] for key in STYLE_KEYS if key in entry})


def _free_name(name: str, taken: dict[str, int]) -> str:
    """An unused name, which is then marked as used; `taken` has the last suffix of each name."""
    number, free = taken.get(name, 1), name
    while free in taken:
        number += 1
        free = f"{name} {number}"
    taken[name], taken[free] = number, taken.get(free, 1) if free != name else number
    return free


def _with_default_colors(named: list[Named], colored: Collection[str]) -> list[Named]:
    plain = [
        name
        for name, geometry, style in named
        if kind_of(geometry) in ("cloud", "points")
        and style.color is None
        and style.color_by is None
        and name not in colored
        and not _has_colors(geometry)
    ]
    if len(plain) == 1:
        style = {"color_by": DEFAULT_COLOR_BY}
        return [(n, g, dataclasses.replace(s, **style) if n in plain and _has_heights(g) else s) for n, g, s in named]
    colors = {name: CLOUD_COLORS[i % len(CLOUD_COLORS)] for i, name in enumerate(plain)}
    return [(n, g, dataclasses.replace(s, color=colors[n]) if n in colors else s) for n, g, s in named]


def _has_heights(cloud: object) -> bool:
    """True if the points have different heights, which a color shows."""
    if not isinstance(cloud, PointCloud):
        points: Any = getattr(cloud, "points", cloud)
        cloud = PointCloud(points)
    low, high, count = bound_points(cloud.arrays["points"])
    return bool(count) and float(high[2]) > float(low[2])


def _has_colors(cloud: object) -> bool:
    if isinstance(cloud, PointCloud):
        return bool(cloud.has_colors)
    colors = getattr(cloud, "colors", None)
    return colors is not None and len(colors) > 0


def kind_of(geometry: object) -> str:
    """Default name of a geometry. Raises TypeError if it cannot be drawn."""
    return _entry_of(as_known(geometry))[0]


def as_known(geometry: Any) -> Any:
    """Convert clouds and meshes of other libraries, and tensors. Other objects are returned unchanged."""
    if isinstance(geometry, (type, *(kind for kind, _ in _KINDS))):
        return geometry
    if is_other(geometry) or is_scene(geometry):
        return from_any(geometry)
    if callable(getattr(geometry, "to_legacy", None)):
        return geometry.to_legacy()
    has_memory = hasattr(geometry, "__dlpack__") and hasattr(geometry, "__dlpack_device__")
    is_read_by_numpy = hasattr(geometry, "__array__") or hasattr(geometry, "__array_interface__")
    if not has_memory or is_read_by_numpy or is_on_gpu(geometry):
        return geometry
    return np.from_dlpack(geometry)


def parts_of(geometry: object, style: Style | None = None, device: DeviceLike = None) -> list[Part]:
    """Drawn parts of a geometry on a device (None: that of the geometry, else the CPU). Arrays on it are shared.

    Raises TypeError if it cannot be drawn and ValueError for inconsistent arrays.
    """
    style, geometry = style or Style(), as_known(geometry)
    target_device = resolve_device(getattr(geometry, "device", None) if device is None else device)
    parts = _entry_of(geometry)[1](geometry, style, target_device)
    return [part if style.pose is None else dataclasses.replace(part, pose=style.pose) for part in parts]


def bounds_of(parts: Iterable[Part]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Bounds (low, high) of the finite positions of parts with their poses [m]; zeros if there are none."""
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


def _of_cloud(cloud: PointCloud, style: Style, device: Any) -> list[Part]:
    arrays = {name: move(cloud.arrays[name], device) for name in ("points", "normals", "colors") if name in cloud}
    none, coloring = empty(0, vec3, device), None
    colors = arrays.get("colors", none)
    has_own = "colors" in arrays and style.color is None and style.color_by in (None, "rgb")
    if style.color_by is not None:
        coloring = color_cloud(cloud, style.color_by, colormap=style.colormap, limits=style.limits)
        colors = move(coloring.colors, device)
    elif style.color is not None:
        colors = none
    return [_points(arrays["points"], cloud.origin, colors, arrays.get("normals", none), style, has_own, coloring)]


def _points(
    positions: AnyArray,
    origin: NDArray[np.float64],
    colors: AnyArray,
    normals: AnyArray,
    style: Style,
    has_own: bool,
    coloring: Coloring | None = None,
) -> Points:
    """Points. Their own colors are unlit unless the style requires lighting."""
    return Points(
        positions,
        origin,
        colors,
        normals,
        size=style.point_size,
        metric=style.metric,
        shaded=style.shaded is not False,
        lit=style.shaded is True or not has_own,
        plain=style.color or Points.plain,
        coloring=coloring,
        opacity=1.0 if style.opacity is None else style.opacity,
    )


def _of_splats(splats: GaussianSplats, style: Style, device: Any) -> list[Part]:
    """Gaussian splats. In one color or colored by values, points."""
    splats = splats.to(device)
    (points,) = _of_cloud(splats.to_point_cloud(), style, device)
    if not isinstance(points, Points) or style.color is not None or style.color_by is not None or not len(splats):
        return [points]
    fields = {field.name: getattr(points, field.name) for field in dataclasses.fields(points)}
    if points.size is None:
        fields |= {"size": 2 * float(np.median(splats.scales)), "metric": True}
    return [Gaussians(**{**fields, "normals": empty(0, vec3, device)}, columns=columns_of(splats))]


def _of_points(geometry: Any, style: Style, device: Any) -> list[Part]:
    """An array of points, or a plain object with points."""
    has_attributes = hasattr(geometry, "points")
    cloud = PointCloud(geometry.points if has_attributes else geometry, device=device)
    if style.color_by is not None:
        for name in ("normals", "colors") if has_attributes else ():
            rows = optional_rows(geometry, name, len(cloud))
            if len(rows):
                setattr(cloud, name, rows)
        return _of_cloud(cloud, style, device)
    normals, colors = (optional_rows(geometry, name, len(cloud)) for name in ("normals", "colors"))
    if style.color is not None:
        colors = colors[:0]
    arrays = upload(colors, vec3, device), upload(normals, vec3, device)
    return [_points(cloud.arrays["points"], cloud.origin, *arrays, style, len(colors) > 0)]


def optional_rows(holder: object, name: str, rows: int) -> NDArray[np.float32]:
    """An attribute with one row per element, or no rows if missing. Colors 0 to 1."""
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
        rows = {n: optional_rows(mesh, n, made.arrays["vertices"].size) for n in ("vertex_normals", "vertex_colors")}
        arrays: dict[str, Any] = {n: upload(values, vec3, device) for n, values in rows.items() if len(values)}
        mesh = made.with_arrays(**arrays)
    mesh, chosen = mesh.to(device), _surface_style(style)
    if style.color_by is not None:
        coloring = color_cloud(vertices_of(mesh), style.color_by, colormap=style.colormap, limits=style.limits)
        chosen |= {"colors": coloring.colors, "coloring": coloring}
    return mesh_parts(mesh, chosen)


def _surface_style(style: Style) -> dict[str, Any]:
    """The fields of `Triangles` that a style defines."""
    chosen: dict[str, Any] = {"wireframe": bool(style.wireframe), "cull": style.back_faces is False}
    decided = {"lit": style.shaded, "plain": style.color, "opacity": style.opacity}
    return chosen | {name: value for name, value in decided.items() if value is not None}


def _of_voxels(grid: VoxelGrid, style: Style, device: DeviceLike) -> list[Part]:
    parts: list[Part] = voxel_parts(grid, _surface_style(style), device)
    return parts


def _of_hull(hull: ConvexHull, style: Style, device: DeviceLike) -> list[Part]:
    if style.wireframe is False:
        return _of_mesh(hull, style, device)
    return [_lines(outlines.of_triangles(hull.vertices, hull.triangles), style, device)]


def _of_tsdf(volume: TSDFVolume, style: Style, device: DeviceLike) -> list[Part]:
    return _of_mesh(volume.extract_triangle_mesh(), style, device)


def _lines(drawn: outlines.Segments, style: Style, device: Any) -> Lines:
    if style.opacity is not None and style.opacity < 1:
        raise ValueError(f"opacity: only points and faces can be transparent, not lines; got {style.opacity}")
    part = outlines.upload_lines(drawn, device)
    if style.color is not None:
        part = dataclasses.replace(part, colors=empty(0, vec3, device), plain=style.color)
    return part if style.line_width is None else dataclasses.replace(part, width=style.line_width)


def _outlined(outline: Callable[[Any], outlines.Segments]) -> Callable[[Any, Style, Any], list[Part]]:
    """Make a function for the parts of a geometry drawn as lines."""
    return lambda geometry, style, device: [_lines(outline(geometry), style, device)]


def _of_trajectory(path: Trajectory, style: Style, device: DeviceLike) -> list[Part]:
    return [dataclasses.replace(_lines(outlines.of_trajectory(path), style, device), in_front=True)]


Entry = tuple[str, Callable[[Any, Style, Any], list[Part]]]

_KINDS: list[tuple[type, Entry]] = [
    (PointCloud, ("cloud", _of_cloud)),
    (TriangleMesh, ("mesh", _of_mesh)),
    (VoxelGrid, ("voxels", _of_voxels)),
    (BoundingBox, ("box", _outlined(outlines.of_box))),
    (LineSet, ("lines", _outlined(outlines.of_line_set))),
    (Trajectory, ("trajectory", _of_trajectory)),
    (ConvexHull, ("hull", _of_hull)),
    (SelectionPolygonVolume, ("volume", _outlined(outlines.of_volume))),
    (TSDFVolume, ("surface", _of_tsdf)),
    (GaussianSplats, ("splats", _of_splats)),
    (CameraFrustum, ("camera", _outlined(outlines.of_frustum))),
]


def _entry_of(geometry: object) -> Entry:
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
    kind = type(geometry)  # with its module: other libraries have a VoxelGrid as well
    type_name = kind.__name__ if kind.__module__ == "builtins" else f"{kind.__module__}.{kind.__name__}"
    raise TypeError(f"geometries: expected {ACCEPTED}; got {type_name}{conversion_of(geometry)}")


# Faces of a cube: axis, side and corners, counterclockwise seen from outside.
_CUBE_FACES = (
    ((-1, 0, 0), ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0))),
    ((1, 0, 0), ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1))),
    ((0, -1, 0), ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1))),
    ((0, 1, 0), ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0))),
    ((0, 0, -1), ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0))),
    ((0, 0, 1), ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))),
)


def mesh_parts(mesh: TriangleMesh, chosen: dict[str, Any]) -> list[Part]:
    """Drawn parts of a mesh, with shared arrays; `plain` and `coloring` in `chosen` replace its colors and textures."""
    arrays, none = mesh.arrays, empty(0, vec3, mesh.device)
    fields: dict[str, Any] = {
        "positions": arrays["vertices"],
        "origin": mesh.origin,
        "normals": arrays.get("vertex_normals", none),
        "colors": none if "plain" in chosen else arrays.get("vertex_colors", none),
        **chosen,
    }
    if "triangle_uvs" not in arrays or not mesh.textures or chosen.keys() & {"plain", "coloring"}:
        return [Triangles(indices=_flat(arrays["triangles"]), **fields)]
    if "triangle_material_ids" not in arrays:
        uvs, texture = arrays["triangle_uvs"], mesh.textures[0]
        return [Triangles(indices=_flat(arrays["triangles"]), uvs=uvs, texture=texture, **fields)]
    ids = np.asarray(mesh.triangle_material_ids)
    parts: list[Part] = []
    for number in np.unique(ids).tolist():
        taken = mesh.arrays.triangles_at(upload(np.flatnonzero(ids == number).astype(np.int32), int32, mesh.device))
        surface = (
            {"uvs": taken["triangle_uvs"], "texture": mesh.textures[number]} if number < len(mesh.textures) else {}
        )
        parts.append(Triangles(indices=_flat(taken["triangles"]), **surface, **fields))
    return parts


def vertices_of(mesh: TriangleMesh) -> PointCloud:
    """The vertices of a mesh as a cloud with normals, colors and attributes."""
    arrays = mesh.arrays
    renamed = {"vertices": "points", "vertex_normals": "normals", "vertex_colors": "colors"}
    columns = {new: arrays[old] for old, new in renamed.items() if old in arrays}
    cloud = PointCloud.from_device_arrays(columns, mesh.origin)
    for name, values in mesh.vertex_attributes.items():
        cloud[name] = values
    cloud.unit, cloud.crs = mesh.unit, mesh.crs
    return cloud


def _flat(triangles: Any) -> Any:
    return view_as(triangles, int32, (3 * triangles.size,))


def voxel_parts(grid: VoxelGrid, chosen: dict[str, Any], device: Any) -> list[Part]:
    """The outer faces of a voxel grid as shaded squares, with edges if `wireframe`."""
    corners = outer_faces(grid)
    count, origin = len(corners), np.asarray(grid.origin, np.float64)
    first = 4 * np.arange(count)[:, None]
    indices = (first + np.array([0, 1, 2, 0, 2, 3])).ravel()
    local = corners.reshape(-1, 3) * grid.voxel_size
    none, wireframe = empty(0, vec3, device), chosen.pop("wireframe", False)
    fields: dict[str, Any] = {"colors": none, "normals": none, "uvs": empty(0, vec2, device), "lit": True, **chosen}
    positions = upload(local, vec3, device)
    parts: list[Part] = [Triangles(positions, origin, upload(indices, int32, device), **fields)]
    if wireframe and count:
        vertices, rows = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
        sides = rows.reshape(-1)[first + np.array([0, 1, 1, 2, 2, 3, 3, 0])].reshape(-1, 2)
        lines = np.unique(np.sort(sides, axis=1), axis=0)
        parts.append(upload_lines(Segments(vertices * grid.voxel_size + origin, lines), device))
    return parts


def outer_faces(grid: VoxelGrid) -> NDArray[np.int64]:
    """Faces between occupied and free voxels. Corners in voxel units, shape (k, 4, 3)."""
    cells = np.asarray(grid.coordinates, np.int64)
    sizes = np.asarray(grid.counts, np.int64) + 2
    occupied = _keys(cells, sizes)  # ascending, as the coordinates are
    faces = []
    for side, corners in _CUBE_FACES:
        neighbor_keys = _keys(cells + side, sizes)
        index = np.searchsorted(occupied, neighbor_keys).clip(max=max(len(cells) - 1, 0))
        open_cells = cells[occupied[index] != neighbor_keys] if len(cells) else cells
        faces.append(open_cells[:, None] + np.array(corners))
    return np.concatenate(faces)


def _keys(cells: NDArray[np.int64], sizes: NDArray[np.int64]) -> NDArray[np.int64]:
    """A unique number for each cell of a grid padded by one cell."""
    x, y, z = (cells + 1).T
    return (x * sizes[1] + y) * sizes[2] + z
