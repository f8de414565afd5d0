"""What a file or folder holds: `describe` for clouds, meshes, trajectories, cameras, models, pictures, data sets.

Clouds and meshes are read as tables, so no runtime starts and nothing is rounded; of LAS and LAZ files only the header
and the tables are read, and held against the file.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ...cameras.trajectory import parse_floats, read_lines, read_pose, read_trajectory
from ...core.coordinates import describe_bounds, split_origin
from ...core.errors import FileError
from ...core.json_files import read_json_object
from ...core.reports import Fields, Report
from ...core.wording import format_bounds, format_share, format_triple, plain
from ...files.ascii_rows import is_number
from ...files.frames.datasets import is_dataset, open_dataset
from ...files.meshes import tables
from ...files.models.colmap import is_colmap_model
from ...files.pictures.image_files import read_color, read_depth, read_picture_header
from ...files.points.e57 import describe_e57
from ...files.points.las import attribute_types, open_las
from ...files.points.las_crs import crs_name
from ...files.points.scan_files import natural_key
from ...files.table import MeshTable
from .model_info import describe_colmap_model, describe_metashape_file

_PICTURES = (".png", ".jpg", ".jpeg")
_TRAJECTORIES = (".log", ".tum", ".kitti", ".txt")


@dataclass(frozen=True)
class BrokenFile(Report):
    """A file that cannot be read, and why."""

    path: str
    error: str

    def fields(self) -> Fields:
        """What is wrong with it."""
        return [("error", self.error)]


@dataclass(frozen=True)
class Description(Report):
    """What lies at a path.

    Attributes:
        path: The file or folder.
        kind: What it is.
        facts: What this kind has, by name and in JSON's types: counts, attributes, bounds [m], origin, points that are
            not finite, and so on; "bytes" is the size of a file. Of a folder of clouds "files" describes each of them.
    """

    path: str
    kind: str
    facts: dict[str, Any]

    @property
    def broken(self) -> str | None:
        """The first error over a file of a folder, and how many more there are; None where there is none."""
        errors = [file.error for file in self.facts.get("files", ()) if isinstance(file, BrokenFile)]
        if not errors:
            return None
        return errors[0] + (f" (and {len(errors) - 1} more files of {self.path})" if errors[1:] else "")

    @property
    def point_count(self) -> int:
        """How many points, or vertices of a mesh."""
        return self.facts.get("points", self.facts.get("vertices", 0))

    def to_json(self) -> dict[str, Any]:
        """All of it on one level."""
        return plain({"path": self.path, "kind": self.kind} | self.facts)

    def fields(self) -> Fields:
        """The facts that there are."""
        shown = {name: value for name, value in self.facts.items() if value is not None}
        return [(name.replace("_", " "), _format(name, value)) for name, value in shown.items()]

    def line(self) -> str:
        """One line, for a list of the files of a folder."""
        count = f"{self.point_count:,} {'points' if 'points' in self.facts else 'vertices'}"
        count += f", {self.facts['triangles']:,} triangles" if "triangles" in self.facts else ""
        return f"{Path(self.path).name}: {count}, {format_bounds(self.facts['bounds'])}"


def describe(path: str | os.PathLike[str], *, layout: str = "auto") -> Description:
    """Describe what lies at a path.

    Args:
        path: A file, the folder of a data set, of a model of COLMAP, or of clouds and meshes.
        layout: The layout of a folder.

    Raises:
        FileError: Missing, damaged, or of no known kind.
    """
    path = Path(path)
    if not path.exists():
        raise FileError(path, "does not exist")
    facts = _describe_folder(path, layout) if path.is_dir() else _describe_file(path)
    if not path.is_dir():
        facts["bytes"] = path.stat().st_size
    return Description(str(path), facts.pop("kind"), facts)


def _format(name: str, value: Any) -> str:
    if isinstance(value, str):
        return value
    if name.endswith("bounds"):
        return format_bounds(value)
    if name in ("origin", "position", "offset"):
        return format_triple(value)
    if name == "scale":
        return "[" + ", ".join(f"{step:g}" for step in value) + "]"
    if isinstance(value, dict):
        return ", ".join(f"{key} {_format(key, item)}" for key, item in value.items()) or "none"
    if name == "files":
        return "\n".join(_line_of(file) for file in value)
    if isinstance(value, list):
        return "\n".join(" ".join(f"{x:g}" for x in row) if isinstance(row, list) else str(row) for row in value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return format_share(value) if name.endswith("share") else f"{value:.6g}"
    return f"{value:,}" if isinstance(value, int) else str(value)


def _describe_file(path: Path) -> dict[str, Any]:
    suffix = path.suffix.lower()
    if suffix in tables.LAS:
        return _describe_las(path)
    if suffix == ".e57":
        return {**_describe_table(path), "scans": [_scan_line(scan) for scan in describe_e57(path)]}
    if suffix != ".txt" and (suffix in tables.READERS or suffix in tables.MESHES):
        return _describe_table(path)
    if suffix in _PICTURES:
        return _describe_picture(path)
    if suffix == ".npy":
        return {"kind": "depth map", **_measure_depth(read_depth(path))}
    if suffix == ".json":
        return _describe_json(path)
    if suffix == ".xml":
        return describe_metashape_file(path)
    if suffix in _TRAJECTORIES:
        return _describe_text(path)
    known = " ".join(
        [*dict.fromkeys([*tables.READERS, *tables.MESHES]), *_PICTURES, ".npy", ".json", ".xml", *_TRAJECTORIES[:-1]]
    )
    raise FileError(path, f"unknown kind of file {suffix!r}", remedy=f"Known are {known}, and folders of frames")


# ------------------------------------------------------------------------------------------------ points


def _describe_table(path: Path) -> dict[str, Any]:
    table = tables.read_table(path)
    if isinstance(table, MeshTable):
        counts: dict[str, Any] = {"kind": "mesh", "vertices": len(table.vertices), "triangles": len(table.triangles)}
        points, normals, colors = table.vertices, table.vertex_normals, table.vertex_colors
    else:
        counts = {"kind": "point cloud", "points": len(table.points)}
        if table.grid:
            counts["grid"] = f"{table.grid[0]} rows of {table.grid[1]}"
        points, normals, colors = table.points, table.normals, table.colors
    named = {"normals": normals, "colors": colors, **table.attributes}
    if isinstance(table, MeshTable):
        named["texture_coordinates"] = table.triangle_uvs
        if table.textures:
            counts["textures"] = ", ".join(f"{p.shape[1]} x {p.shape[0]}" for p in table.textures)
    attributes = {name: _type_name(values) for name, values in named.items() if values is not None}
    return counts | {
        "coordinates": str(points.dtype),
        "attributes": attributes,
        "not_finite": int(np.count_nonzero(~np.isfinite(points).all(axis=1))),
        "bounds": describe_bounds(points),
        "origin": split_origin(points)[1].tolist(),
    }


def _describe_las(path: Path) -> dict[str, Any]:
    """What the header says, which was held against the file; the points are not read."""
    file = open_las(path)
    header, (low, high) = file.header, file.header.bounds
    is_box = header.point_count > 0 and bool(np.isfinite([low, high]).all())
    return {
        "kind": "point cloud",
        "points": header.point_count,
        "version": f"LAS {header.version}{', compressed' if header.is_compressed else ''}",
        "point_format": header.point_format,
        "coordinates": "int32, scaled",
        "scale": [*header.scales],
        "offset": [offset + 0.0 for offset in header.offsets],  # some writers store minus zero
        "coordinate_system": crs_name(header),
        "attributes": attribute_types(file),
        "bounds": {"min": [*low], "max": [*high]} if is_box else None,
        "software": header.software or None,
    }


def _scan_line(scan: dict[str, Any]) -> str:
    name = f"{scan['name']}: " if scan["name"] else ""
    return f"{name}{scan['points']:,} points, at {format_triple(scan['position'])}"


def _files_of_points(folder: Path) -> list[Path]:
    """The clouds and meshes of a folder in natural order; its .txt are notes."""
    known = {*tables.READERS, *tables.MESHES} - {".txt"}
    return sorted((p for p in folder.iterdir() if p.suffix.lower() in known and p.is_file()), key=natural_key)


def _describe_folder(folder: Path, layout: str) -> dict[str, Any]:
    if layout == "auto" and not is_dataset(folder):
        if is_colmap_model(folder):
            return describe_colmap_model(folder)
        if files := _files_of_points(folder):
            return _describe_clouds(files)
    return _describe_dataset(folder, layout)


def _describe_clouds(paths: list[Path]) -> dict[str, Any]:
    files: list[Description | BrokenFile] = []
    for path in paths:
        try:
            files.append(describe(path))
        except (ValueError, TypeError, OSError) as error:
            files.append(BrokenFile(str(path), str(error)))
    points = sum(file.point_count for file in files if isinstance(file, Description))
    return {"kind": "folder of clouds", "files": files, "points": points}


def _line_of(file: Description | BrokenFile) -> str:
    return file.line() if isinstance(file, Description) else f"{Path(file.path).name}: broken"


def _type_name(values: NDArray[Any]) -> str:
    return f"{values.dtype}" + (f" x {values.shape[1]}" if values.ndim == 2 else "")


# ------------------------------------------------------------------------------------------------ pictures


def _describe_picture(path: Path) -> dict[str, Any]:
    header = read_picture_header(path)
    if (header.kind, header.channels, header.bits) == ("png", 1, 16):
        return {"kind": "depth map", **_measure_depth(read_depth(path))}
    read_color(path)  # holds that it is whole
    size = f"{header.width} x {header.height}"
    return {"kind": "picture", "format": header.kind.upper(), "size": size, "channels": header.channels}


def _measure_depth(depth: NDArray[Any]) -> dict[str, Any]:
    """Size of a depth map, and what its pixels hold in its own unit; 65535 is no measurement in 7-Scenes."""
    with np.errstate(invalid="ignore"):
        measured = depth[(depth > 0) & np.isfinite(depth)]
    limits = {"lowest": None, "median": None, "highest": None}
    if measured.size:
        limits = {"lowest": measured.min(), "median": np.median(measured), "highest": measured.max()}
    unit = "metres" if depth.dtype.kind == "f" else "stored numbers (often millimetres)"
    return {
        "size": f"{depth.shape[1]} x {depth.shape[0]}",
        "type": str(depth.dtype),
        "measured_share": measured.size / depth.size,
        "depth": {name: float(value) for name, value in limits.items() if value is not None},
        "unit": unit,
    }


# ------------------------------------------------------------------------------------------------ cameras


def _describe_camera(camera: PinholeCameraIntrinsic) -> dict[str, Any]:
    return {
        "size": f"{camera.width} x {camera.height}",
        "focal_length": {"fx": camera.fx, "fy": camera.fy},
        "principal_point": {"cx": camera.cx, "cy": camera.cy},
    }


def _describe_json(path: Path) -> dict[str, Any]:
    content = read_json_object(path)
    if "parameters" in content:
        return _describe_trajectory(path)
    if "intrinsic_matrix" in content or "intrinsic" in content:
        return {"kind": "camera", **_describe_camera(read_pinhole_camera_intrinsic(path))}
    keys = ", ".join(sorted(content)[:8]) or "nothing"
    remedy = 'Known are cameras ("intrinsic_matrix") and trajectories ("parameters")'
    raise FileError(path, f"neither a camera nor a trajectory; holds {keys}", remedy=remedy)


def _describe_text(path: Path) -> dict[str, Any]:
    """A trajectory; in a .txt file also one pose, the 3x3 matrix of a camera, or a table of points."""
    if path.suffix.lower() != ".txt":
        return _describe_trajectory(path)
    lines = read_lines(path)
    shape = (len(lines), len(lines[0][1])) if lines else (0, 0)
    if shape == (4, 4):
        T = read_pose(path)
        return {"kind": "pose", "matrix": T.tolist(), "position": T[:3, 3].tolist()}
    if shape == (3, 3) and _is_last_row(lines[2][1]):
        return {"kind": "camera matrix", "matrix": [parse_floats(path, line, 3) for line in lines]}
    is_trajectory = shape[1] in (8, 12) and all(is_number(word.encode()) for word in lines[0][1])
    return _describe_trajectory(path) if is_trajectory else _describe_table(path)


def _is_last_row(words: list[str]) -> bool:
    """Whether this is the last row of a camera's matrix: three points, too, may stand in three rows of three."""
    return all(is_number(word.encode()) for word in words) and [float(word) for word in words] == [0, 0, 1]


def _describe_trajectory(path: Path) -> dict[str, Any]:
    trajectory = read_trajectory(path)
    report = {"kind": "trajectory", "poses": len(trajectory), **_measure_walk(trajectory.poses)}
    if trajectory.timestamps is not None:
        report["duration_s"] = float(np.ptp(trajectory.timestamps))
    return report


def _measure_walk(poses: NDArray[np.float64]) -> dict[str, Any]:
    places = poses[:, :3, 3]
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    return {"camera_bounds": describe_bounds(places), "path_length_m": float(steps.sum())}


def _describe_dataset(folder: Path, layout: str) -> dict[str, Any]:
    dataset = open_dataset(folder, layout=layout)
    first = dataset.read(0)
    depth = _measure_depth(first.depth)
    in_metres = {name: value / dataset.depth_scale for name, value in depth["depth"].items()}
    return {
        "kind": "RGB-D data set",
        "layout": dataset.layout,
        "frames": len(dataset),
        "has_color": first.color is not None,
        "left_out": len(dataset.left_out),
        **_describe_camera(dataset.intrinsic),
        "camera_from": dataset.intrinsic_source,
        "camera_doubt": dataset.intrinsic_doubt or None,
        "depth_scale": dataset.depth_scale,
        "first_frame_measured_share": depth["measured_share"],
        "first_frame_depth_m": in_metres,
        **_measure_walk(np.array([frame.T_world_camera for frame in dataset.frames], np.float64)),
    }
