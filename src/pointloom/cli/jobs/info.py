"""Descriptions of files and folders: `describe` for clouds, meshes, trajectories, cameras, models, images, data sets.

Clouds and meshes are read as tables, without a runtime and without rounding. Of LAS and LAZ only the header is read and
checked.
"""

from __future__ import annotations

import dataclasses
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ...cameras.camera_models import CameraModel
from ...cameras.pose_text import parse_floats, read_lines, read_pose
from ...cameras.trajectory import read_trajectory
from ...cameras.trajectory_formats import TRAJECTORY_FORMATS
from ...core.atomic import restore_folder
from ...core.coordinates import choose_origin, describe_bounds
from ...core.errors import FileError, FilePath, values_of_file
from ...core.json_files import read_json_object
from ...core.paths import is_recording
from ...core.reports import Assessed, Fields, Report
from ...core.wording import format_triple
from ...io.ascii_rows import is_number
from ...io.bags.recording import read_recording
from ...io.frames.datasets import is_dataset, open_frames
from ...io.images.image_files import read_color, read_depth, read_image_header
from ...io.images.image_formats import IMAGES
from ...io.meshes import tables
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...io.models.colmap import find_colmap_model, is_colmap_model, read_colmap_model
from ...io.models.metashape import read_metashape_cameras
from ...io.models.sfm_model import SfmModel
from ...io.points.copc import is_copc
from ...io.points.e57 import describe_e57
from ...io.points.formats import CLOUD_FORMATS, WITH_SCANS
from ...io.points.las import attribute_types, open_las
from ...io.points.las_crs import crs_name
from ...io.points.las_units import units_of
from ...io.points.ptx import describe_ptx
from ...io.points.scan_files import is_kitti_sequence, list_scans, natural_key, read_scan_times
from ...io.table import MeshTable, PointTable
from ...pcd.geotiff import ENDINGS as RASTERS
from ...pcd.raster import read_raster
from .facts import (
    Camera,
    CameraMatrix,
    CameraPath,
    Cameras,
    Cloud,
    ColmapModel,
    DataSet,
    DepthMap,
    Facts,
    Heights,
    Las,
    Mesh,
    MetashapeCameras,
    Picture,
    Pose,
    Shape,
    Table,
    Trajectory,
)


@dataclass(frozen=True)
class BrokenFile(Report):
    path: str
    error: str

    def fields(self) -> Fields:
        return [("error", self.error)]

    def line(self) -> str:
        return f"{Path(self.path).name}: broken"


@dataclass(frozen=True)
class Description(Report, Assessed):
    """Facts about a path, and the size of a file in bytes."""

    path: str
    facts: Facts
    bytes: int | None = None

    @property
    def kind(self) -> str:
        return self.facts.KIND

    @property
    def broken(self) -> str | None:
        """First error among the files of a folder and the number of further ones, or None."""
        files = self.facts.files if isinstance(self.facts, CloudFolder) else []
        errors = [file.error for file in files if isinstance(file, BrokenFile)]
        if not errors:
            return None
        return errors[0] + (f" (and {len(errors) - 1} more files of {self.path})" if errors[1:] else "")

    @property
    def warnings(self) -> tuple[str, ...]:
        """The damage of a recording. Empty otherwise."""
        damage = self.facts.damage if isinstance(self.facts, RecordedTopics) else None
        return (f"{self.path}: {damage}",) if damage else ()

    def to_dict(self) -> dict[str, Any]:
        size = {} if self.bytes is None else {"bytes": self.bytes}
        return {"path": self.path, "kind": self.kind, **self.facts.to_dict(), **size}

    def fields(self) -> Fields:
        size = [] if self.bytes is None else [("bytes", f"{self.bytes:,}")]
        return [*self.facts.fields(), *size]

    def line(self) -> str:
        text = self.facts.line if isinstance(self.facts, Shape) else self.kind
        return f"{Path(self.path).name}: {text}"


@dataclass(frozen=True)
class CloudFolder(Facts):
    """A folder of clouds and meshes: their number of points and vertices, and their duration if there are times."""

    KIND = "folder of clouds"
    SPARE = ("duration_s",)

    files: list[Description | BrokenFile]
    points: int
    duration_s: float | None = None

    def fields(self) -> Fields:
        duration = [] if self.duration_s is None else [("duration", f"{self.duration_s:.1f} s")]
        files = "\n".join(file.line() for file in self.files)
        return [("files", files), ("points", f"{self.points:,}"), *duration]


def describe(path: FilePath, *, layout: str = "auto", columns: Sequence[str] | None = None) -> Description:
    """Describe a file, or the folder of a data set, a COLMAP model, clouds or meshes. Raises FileError.

    `layout` is that of a folder; `columns` names the columns of tables, as in `read_point_cloud`.
    """
    path = Path(path)
    restore_folder(path)
    if not path.exists():
        raise FileError(path, "does not exist")
    if is_recording(path):
        size = None if path.is_dir() else path.stat().st_size
        return Description(str(path), describe_recording(path), size)
    if path.is_dir():
        return Description(str(path), _describe_folder(path, layout))
    if columns is not None:
        return Description(str(path), _describe_table(path, columns), path.stat().st_size)
    return Description(str(path), _describe_file(path), path.stat().st_size)


def _describe_file(path: Path) -> Facts:
    suffix = path.suffix.lower()
    if suffix in tables.LAS:
        return _describe_las(path)
    if suffix in WITH_SCANS:
        scans = describe_e57(path) if suffix == ".e57" else describe_ptx(path)
        return replace(_describe_table(path), scans=[_scan_line(scan) for scan in scans])
    if suffix == ".npy" and not _is_cloud(path):
        return _measure_depth(read_depth(path))
    if suffix != ".txt" and (suffix in CLOUD_FORMATS or suffix in MESH_FORMATS):
        return _describe_table(path)
    if suffix in RASTERS:
        return _describe_raster(path)
    if suffix in IMAGES:
        return _describe_picture(path)
    if suffix == ".json":
        return _describe_json(path)
    if suffix == ".xml":
        return describe_metashape_file(path)
    if suffix in TRAJECTORY_FORMATS:
        return _describe_text(path)
    known = " ".join(dict.fromkeys([*CLOUD_FORMATS, *MESH_FORMATS, *IMAGES, *RASTERS, ".xml", *TRAJECTORY_FORMATS]))
    raise FileError(path, f"unknown file type {suffix!r}", remedy=f"Expected one of {known}, or a folder of frames")


def _is_cloud(path: Path) -> bool:
    """True if a .npy file has points: rows of three numbers, or of named ones. Others are depth maps."""
    try:
        tables.read_table(path)
    except FileError:
        return False
    return True


def _describe_table(path: Path, columns: Sequence[str] | None = None) -> Cloud | Mesh:
    table = tables.read_table(path, columns)
    with values_of_file(path):  # coordinates beyond float32
        return _facts_of(table)


def _facts_of(table: PointTable | MeshTable) -> Cloud | Mesh:
    if isinstance(table, MeshTable):
        named = {"normals": table.vertex_normals, "colors": table.vertex_colors, **table.attributes}
        named["texture_coordinates"] = table.triangle_uvs
        textures = ", ".join(f"{p.shape[1]} x {p.shape[0]}" for p in table.textures) or None
        return Mesh(len(table.vertices), len(table.triangles), textures, table.unit, _table_of(table.vertices, named))
    named = {"normals": table.normals, "colors": table.colors, **table.attributes}
    grid = f"{table.grid[0]} rows of {table.grid[1]}" if table.grid else None
    viewpoint = " ".join(f"{value:g}" for value in table.viewpoint) if table.viewpoint else None
    return Cloud(
        len(table.points),
        grid,
        table.unit,
        _table_of(table.points, named, in_degrees=table.in_degrees),
        viewpoint=viewpoint,
    )


def _table_of(points: NDArray[Any], named: Mapping[str, NDArray[Any] | None], *, in_degrees: bool = False) -> Table:
    return Table(
        coordinates=str(points.dtype),
        attributes={name: _type_name(values) for name, values in named.items() if values is not None},
        not_finite=int(np.count_nonzero(~np.isfinite(points).all(axis=1))),
        bounds=describe_bounds(points),
        origin=choose_origin(points, in_degrees=in_degrees).tolist(),
    )


def _describe_las(path: Path) -> Las:
    """Facts from the checked header."""
    file = open_las(path)
    header, (low, high) = file.header, file.header.bounds
    units = units_of(header)
    kind = ", COPC" if is_copc(file) else ", compressed" if header.is_compressed else ""
    is_box = header.point_count > 0 and bool(np.isfinite([low, high]).all())
    return Las(
        points=header.point_count,
        version=f"LAS {header.version}{kind}",
        point_format=header.point_format,
        coordinates="int32, scaled",
        scale=[*header.scales],
        offset=[offset + 0.0 for offset in header.offsets],  # some writers store minus zero
        coordinate_system=crs_name(header),
        unit=units.plane,
        unit_notes=None if units.warning is None else [units.warning],
        attributes=attribute_types(file),
        bounds={"min": [*low], "max": [*high]} if is_box else None,
        software=header.software or None,
    )


def _scan_line(scan: dict[str, Any]) -> str:
    name = f"{scan['name']}: " if scan["name"] else ""
    return f"{name}{scan['points']:,} points, at {format_triple(scan['position'])}"


def _files_of_points(folder: Path) -> list[Path]:
    """Clouds and meshes of a folder in natural order, without .txt and .npy, which often are something else."""
    known = {*CLOUD_FORMATS, *MESH_FORMATS} - {".txt", ".npy"}
    return sorted((p for p in folder.iterdir() if p.suffix.lower() in known and p.is_file()), key=natural_key)


def _describe_folder(folder: Path, layout: str) -> Facts:
    if layout == "auto" and not is_dataset(folder):
        if is_colmap_model(folder):
            return describe_colmap_model(folder)
        if is_kitti_sequence(folder):
            scans = list_scans(folder)
            times = read_scan_times(folder, scans)
            return replace(_describe_clouds(scans), duration_s=None if times is None else times[-1] - times[0])
        if files := _files_of_points(folder):
            return _describe_clouds(files)
    return _describe_dataset(folder, layout)


def _describe_clouds(paths: list[Path]) -> CloudFolder:
    files: list[Description | BrokenFile] = []
    for path in paths:
        try:
            files.append(describe(path))
        except (ValueError, TypeError, OSError) as error:
            files.append(BrokenFile(str(path), str(error)))
    shapes = [file.facts for file in files if isinstance(file, Description) and isinstance(file.facts, Shape)]
    return CloudFolder(files, sum(shape.point_count for shape in shapes))


def _type_name(values: NDArray[Any]) -> str:
    return f"{values.dtype}" + (f" x {values.shape[1]}" if values.ndim == 2 else "")


def _describe_picture(path: Path) -> Picture | DepthMap:
    header = read_image_header(path)
    if (header.kind, header.channels, header.bits) == ("png", 1, 16):
        return _measure_depth(read_depth(path))
    read_color(path)  # checks that it is complete
    return Picture(header.kind.upper(), f"{header.width} x {header.height}", header.channels)


def _describe_raster(path: Path) -> Heights:
    raster = read_raster(path)
    known = raster.values[np.isfinite(raster.values)]
    ends: dict[str, float] = {}
    if known.size:
        ends = {"lowest": float(known.min()), "median": float(np.median(known)), "highest": float(known.max())}
    x0, y0, x1, y1 = raster.bounds
    return Heights(
        size=f"{raster.values.shape[1]:,} x {raster.values.shape[0]:,}",
        cell=raster.cell,
        values=raster.kind or None,
        coordinate_system=raster.crs,
        unit=raster.unit,
        known_fraction=known.size / raster.values.size,
        filled_fraction=float(raster.filled.mean()),
        heights=ends,
        bounds={"min": [x0, y0, ends["lowest"]], "max": [x1, y1, ends["highest"]]} if ends else None,
    )


def _measure_depth(depth: NDArray[Any]) -> DepthMap:
    """Facts of a depth map in its own unit. 65535 is invalid in 7-Scenes."""
    with np.errstate(invalid="ignore"):
        measured = depth[(depth > 0) & np.isfinite(depth)]
    limits: dict[str, float] = {}
    if measured.size:
        limits = {"lowest": measured.min(), "median": np.median(measured), "highest": measured.max()}
    return DepthMap(
        size=f"{depth.shape[1]} x {depth.shape[0]}",
        type=str(depth.dtype),
        measured_fraction=measured.size / depth.size,
        depth={name: float(value) for name, value in limits.items()},
        unit="meters" if depth.dtype.kind == "f" else "stored numbers (often millimeters)",
    )


def _describe_camera(camera: PinholeCameraIntrinsic) -> Camera:
    focal_length, principal_point = {"fx": camera.fx, "fy": camera.fy}, {"cx": camera.cx, "cy": camera.cy}
    return Camera(f"{camera.width} x {camera.height}", focal_length, principal_point)


def _describe_json(path: Path) -> Facts:
    content = read_json_object(path)
    if "parameters" in content:
        return _describe_trajectory(path)
    if "intrinsic_matrix" in content or "intrinsic" in content:
        return _describe_camera(read_pinhole_camera_intrinsic(path))
    keys = ", ".join(sorted(content)[:8]) or "nothing"
    remedy = 'Expected a camera ("intrinsic_matrix") or a trajectory ("parameters")'
    raise FileError(path, f"is neither a camera nor a trajectory; it contains {keys}", remedy=remedy)


def _describe_text(path: Path) -> Facts:
    """A trajectory. In .txt also one pose, a 3x3 camera matrix, or a table of points."""
    if path.suffix.lower() != ".txt":
        return _describe_trajectory(path)
    lines = read_lines(path)
    shape = (len(lines), len(lines[0][1])) if lines else (0, 0)
    if shape == (4, 4):
        T = read_pose(path)
        return Pose(T.tolist(), T[:3, 3].tolist())
    if shape == (3, 3) and _is_last_row(lines[2][1]):
        return CameraMatrix([parse_floats(path, line, 3) for line in lines])
    is_trajectory = shape[1] in (8, 12) and all(is_number(word.encode()) for word in lines[0][1])
    return _describe_trajectory(path) if is_trajectory else _describe_table(path)


def _is_last_row(words: list[str]) -> bool:
    """True for the last row of a camera matrix; distinguishes it from three points."""
    return all(is_number(word.encode()) for word in words) and [float(word) for word in words] == [0, 0, 1]


def _describe_trajectory(path: Path) -> Trajectory:
    trajectory = read_trajectory(path)
    duration = None if trajectory.timestamps is None else float(np.ptp(trajectory.timestamps))
    return Trajectory(len(trajectory), _measure_path(trajectory.poses), duration)


def _measure_path(poses: NDArray[np.float64]) -> CameraPath:
    positions = poses[:, :3, 3]
    steps = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    return CameraPath(describe_bounds(positions), float(steps.sum()))


def _describe_dataset(folder: Path, layout: str) -> DataSet:
    dataset = open_frames(folder, layout=layout, resize_color=True)
    first = dataset.read(0)
    depth = _measure_depth(first.depth)
    poses = [frame.T_world_camera for frame in dataset.frames if frame.T_world_camera is not None]
    return DataSet(
        layout=dataset.layout,
        frames=len(dataset),
        poses=len(poses),
        has_color=first.color is not None,
        left_out=len(dataset.left_out),
        camera=_describe_camera(dataset.intrinsic),
        camera_from=dataset.intrinsic_source,
        camera_notes=[*dataset.warnings] or None,
        depth_scale=dataset.depth_scale,
        first_frame_measured_fraction=depth.measured_fraction,
        first_frame_depth_m={name: value / dataset.depth_scale for name, value in depth.depth.items()},
        camera_path=_measure_path(np.array(poses, np.float64)) if poses else None,
    )


MAX_LISTED_LINES = 20  # listed cameras and images without a pose


def describe_colmap_model(folder: Path) -> ColmapModel:
    """A COLMAP model in a folder or below it. Raises FileError if damaged or not unique."""
    model_folder, form = find_colmap_model(folder)
    model = read_colmap_model(model_folder)
    below = str(model_folder.relative_to(folder))
    return ColmapModel(
        folder=None if below == "." else below,
        form={"bin": "binary", "txt": "text"}[form],
        views=_describe_cameras(model),
        points=len(model.points),
        observations=len(model.observations),
        mean_views=float(model.view_counts.mean()) if len(model.points) else None,
        mean_error_px=_mean(model.errors),
        bounds=describe_bounds(model.points),
    )


def describe_metashape_file(path: Path) -> MetashapeCameras:
    model = read_metashape_cameras(path)
    return MetashapeCameras(_describe_cameras(model), _cut(list(model.left_out)) or None)


def _describe_cameras(model: SfmModel) -> Cameras:
    lines = [_camera_line(camera, count) for camera, count in Counter(model.cameras).items()]
    return Cameras(len(model), _cut(lines), describe_bounds(model.centers))


def _camera_line(camera: CameraModel, images: int) -> str:
    numbers = ", ".join(f"{value:g}" for value in camera.params)
    many = "" if images == 1 else "s"
    return f"{camera.model} {camera.width} x {camera.height}, {numbers}; {images} image{many}"


def _cut(lines: list[str]) -> list[str]:
    rest = len(lines) - MAX_LISTED_LINES
    return lines if rest <= 0 else [*lines[:MAX_LISTED_LINES], f"and {rest} more"]


def _mean(errors: NDArray[np.float64]) -> float | None:
    known = errors[np.isfinite(errors)]
    return float(known.mean()) if len(known) else None


@dataclass(frozen=True)
class RecordedTopics(Facts):
    """A robot recording: number of messages, topics, and damage or None."""

    KIND = "recording"
    SPARE = ("damage",)

    messages: int
    topics: list[dict[str, Any]]
    damage: str | None

    def fields(self) -> Fields:
        lines = []
        for topic in self.topics:
            frame = f", frame {topic['frame_id']}" if topic["frame_id"] else ""
            span = "" if topic["first"] is None else f", {topic['last'] - topic['first']:.3f} s"
            lines.append(f"{topic['name']}: {topic['type']}, {topic['count']}{span}{frame}")
        damage = [("damage", self.damage)] if self.damage else []
        return [("messages", f"{self.messages:,}"), ("topics", "\n".join(lines)), *damage]


def describe_recording(path: Path) -> RecordedTopics:
    """Topics and damage of a recording."""
    recording = read_recording(path)
    return RecordedTopics(len(recording), [dataclasses.asdict(topic) for topic in recording.topics], recording.damage)
