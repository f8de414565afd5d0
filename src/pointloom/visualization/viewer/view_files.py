"""Read files for the viewer: `read_scene` for `pointloom view`."""

from __future__ import annotations

import contextlib
import os
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...cameras.pose_text import read_lines
from ...cameras.trajectory import read_trajectory
from ...cameras.trajectory_formats import TRAJECTORY_FORMATS
from ...core.atomic import restore_folder
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError
from ...core.json_files import read_json_object
from ...core.paths import input_path, is_recording, path_of
from ...core.progress import ReportProgress
from ...io.ascii_rows import is_number
from ...io.bags.recording import open_recording
from ...io.meshes import tables
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...io.points.copc_nodes import declares_copc
from ...io.points.formats import CLOUD_FORMATS
from ...io.points.in_parts import open_in_parts
from ...io.points.point_cloud import read_point_cloud
from ...kernels.lang import vec3
from ...kernels.memory import upload
from ...meshing.mesh.mesh_files import read_triangle_mesh
from ...meshing.volume.tsdf import TSDFVolume
from ...pcd.cloud import PointCloud
from ...pcd.geotiff import ENDINGS as RASTERS
from ...pcd.polygon_volume import SelectionPolygonVolume
from ..render.geometries import Named, named_geometries
from ..render.styles import Style
from .copc_tree import CopcTree
from .detail_files import sample_file
from .detail_tree import DetailTree

if TYPE_CHECKING:
    from ...pcd.raster import Raster

_NO_INDICES = np.zeros(0, np.int64)
_COORDINATES = ("rgb", "normal", "height", "x", "y", "z", "label")  # properties that need no attribute


def read_scene(
    paths: list[Path],
    style: dict[str, Any],
    *,
    max_points: int,
    color_by: str | None = None,
    progress: ReportProgress | None = None,
    device: DeviceLike = None,
    in_parts: bool = False,
    topic: str | None = None,
    frame: str | None = None,
    columns: Sequence[Sequence[str] | None] | None = None,
) -> tuple[list[Named], dict[str, Any]]:
    """Read files into named geometries and the levels of detail of large clouds. Raises FileError.

    Reads clouds, meshes, trajectories, TSDF volumes, polygon volumes and recordings. Clouds of more than `max_points`
    are read in parts into levels of detail, if the format allows it, and keep the attribute `color_by`. With
    `in_parts`, only the coarse levels of a large COPC file are read and a `CopcTree` is returned. See `read_recording`
    for `topic` and `frame`. Files with given `columns` are read at once.
    """
    entries: dict[str, Any] = {}
    trees: dict[str, Any] = {}
    given = columns or [None] * len(paths)
    for path, name, names in zip(paths, _names(paths), given, strict=True):
        if is_recording(path):
            entries[name] = read_recording(path, topic, frame, device=device)
            continue
        octree = open_octree(path, max_points) if in_parts else None
        if octree is not None:
            entries[name], trees[name] = octree.head, octree
            continue
        tree = _read_large(path, max_points, color_by, progress, device) if names is None else None
        if tree is None:
            entries[name] = read_geometry(path, device=device, columns=names)
        else:
            entries[name], trees[name] = _cloud_of(tree, path), tree
    given = [{"geometry": geometry, "name": name, **style} for name, geometry in entries.items()]
    named = named_geometries(given, {name for name, tree in trees.items() if tree.colors_of(_NO_INDICES) is not None})
    return named, trees


def open_octree(path: Path, max_points: int) -> CopcTree | None:
    """The octree of a COPC file with more points. None for other files."""
    if path.suffix.lower() != ".laz" or not path.is_file() or not declares_copc(path, more_than=max_points):
        return None
    return CopcTree(path)


def first_looks(paths: list[Path], count: int, *, larger_than: int) -> list[Named]:
    """Read an even sample of up to `count` points from each large file, to show while it is being read."""
    samples: list[Named] = []
    for path, name in zip(paths, _names(paths), strict=True):
        if path.suffix.lower() == ".laz" and path.is_file() and declares_copc(path, more_than=larger_than):
            continue  # its coarse levels are available at once
        sample = sample_file(path, count) if _open_large(path, larger_than) is not None else None
        if sample is not None:
            samples.append((f"{name}: a preview", sample, Style()))
    return samples


def read_geometry(
    path: str | os.PathLike[str], *, device: DeviceLike = None, columns: Sequence[str] | None = None
) -> Any:
    """Read a file by its name and content. A cloud if `columns` is given. Raises FileError."""
    path, suffix = path_of(path), Path(path).suffix.lower()
    restore_folder(path)
    if path.is_dir():
        raise FileError(path, "is a folder", remedy="Give its files, as in pointloom view folder/*.ply")
    if not path.exists():
        raise FileError(path, "does not exist")
    if suffix == ".json":
        return _read_json(path)
    if columns is not None:
        return read_point_cloud(path, device=device, columns=columns)
    if suffix in TRAJECTORY_FORMATS and (suffix not in CLOUD_FORMATS or _is_trajectory(path)):
        return read_trajectory(path)
    if suffix == ".npz" and _is_volume(path):
        return TSDFVolume.load(path, device=device)
    if tables.is_mesh_file(path):
        return read_triangle_mesh(path, device=device)
    if suffix in CLOUD_FORMATS:
        return read_point_cloud(path, device=device)
    if suffix in RASTERS:
        from ...pcd.raster import read_raster  # on use: it imports scipy's matrices

        return cells_of_raster(read_raster(path), device)
    known = " ".join(dict.fromkeys([*CLOUD_FORMATS, *MESH_FORMATS, *TRAJECTORY_FORMATS, *RASTERS]))
    raise FileError(path, f"unknown kind of file {suffix!r}", remedy=f"Supported: {known}")


def cells_of_raster(raster: Raster, device: DeviceLike = None) -> PointCloud:
    """The centers of the cells with a value, at their heights."""
    rows, columns = np.nonzero(np.isfinite(raster.values))
    x = raster.corner[0] + raster.cell * (columns + 0.5)
    y = raster.corner[1] + raster.cell * (len(raster.values) - 0.5 - rows)
    return PointCloud(np.column_stack([x, y, raster.values[rows, columns]]), unit=raster.unit, device=device)


def read_recording(path: Path, topic: str | None, frame: str | None, *, device: DeviceLike = None) -> PointCloud:
    scans = open_recording(path).scans(topic, frame=frame, device=device)
    return next(scans) if frame is None else PointCloud.concatenate(list(scans))


def _names(paths: list[Path]) -> list[str]:
    """Unique names of files: file name, then with folder, then with a number."""
    names: list[str] = []
    for path in paths:
        name = path.name if path.name not in names else str(path)
        number, free = 1, name
        while free in names:
            number += 1
            free = f"{name} {number}"
        names.append(free)
    return names


def _open_large(path: Path, max_points: int) -> Any:
    """Open a cloud file with more points for reading in parts. None for other files."""
    if path.suffix.lower() not in CLOUD_FORMATS or not path.is_file():
        return None
    if tables.is_mesh_file(path):
        return None
    file = open_in_parts(path)
    return file if file is not None and file.count > max_points else None


def _read_large(
    path: Path, max_points: int, color_by: str | None, progress: ReportProgress | None, device: DeviceLike
) -> DetailTree | None:
    """Levels of detail of a cloud with more points. None for other files."""
    if _open_large(path, max_points) is None:
        return None
    attributes = [color_by] if color_by is not None and color_by not in _COORDINATES else []
    return DetailTree.from_file(path, attributes=attributes, progress=progress, device=device)


def _cloud_of(tree: DetailTree, path: Path) -> PointCloud:
    """The cloud of a file's levels, shared. Its colors stay in the tree."""
    device = resolve_device("cpu")
    arrays = {"points": upload(tree.positions, vec3, device, copied=False)}
    cloud = PointCloud.from_device_arrays(arrays, tree.origin)
    for name, values in tree.attributes.items():
        cloud[name] = values
    file = open_in_parts(path)
    cloud.unit = None if file is None else file.unit
    return cloud


def _is_volume(path: Path) -> bool:
    with contextlib.suppress(OSError, zipfile.BadZipFile), zipfile.ZipFile(input_path(path)) as archive:
        return {"keys.npy", "distances.npy", "sizes.npy"} <= set(archive.namelist())
    return False


def _is_trajectory(path: Path) -> bool:
    """True if a text file contains poses: rows of 8 (TUM) or 12 numbers (KITTI), unlike clouds."""
    lines = read_lines(path)
    return bool(lines) and len(lines[0][1]) in (8, 12) and all(is_number(word.encode()) for word in lines[0][1])


def _read_json(path: Path) -> Any:
    content = read_json_object(path)
    if content.get("class_name") == "SelectionPolygonVolume":
        return SelectionPolygonVolume.from_json(path)
    if "parameters" in content:
        return read_trajectory(path)
    kind = str(content.get("class_name", "an unknown kind"))[:40]
    remedy = "Supported are trajectories and polygon volumes; pass a view of Open3D with --view"
    raise FileError(path, f"contains {kind}, which is not a geometry", remedy=remedy)
