"""Camera trajectories as text: Open3D's .log and .json, TUM, KITTI.

All poses are T_world_camera, camera to world. Open3D's JSON stores the inverse. Rotations are returned as stored:
rounding up to 0.02 from orthonormal is accepted and not corrected.
"""

from __future__ import annotations

import contextlib
import dataclasses
import json
import os
from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import atomic_write, check_writable
from ..core.attribute_hints import HintedNames
from ..core.checks import check_name, check_numeric, check_rigid, check_shape
from ..core.coordinate_systems import CoordinateSystem, check_crs
from ..core.errors import FileError
from ..core.escaped_text import escaped
from ..core.json_files import check_keys, read_json_object
from ..core.paths import path_of, recording_remedy
from ..core.quaternions import nearest_rotations, rotations_to_quaternions
from ..core.time_checks import check_seconds
from ..core.units import warn_of_units
from ..kernels.linear_algebra import inv
from .camera import PinholeCameraIntrinsic, check_camera, intrinsic_to_json, read_json_matrix
from .pose_text import check_pose, euroc_lines, kitti_poses, log_poses, read_lines, timed_poses
from .trajectory_formats import EUROC, FORMATS, TRAJECTORY_FORMATS, extensions_of

_CRS_COMMENT = "# crs "  # before the coordinate system in text files


@dataclasses.dataclass(frozen=True, eq=False)
class Trajectory(HintedNames):
    """The poses of a moving camera; `trajectory[i]` is pose i.

    Args:
        poses: T_world_camera of each frame, shape (n, 4, 4), float64 [m].
        timestamps: Time of each pose, shape (n,) [s], or None.
        ids: The three integers per pose of a .log file, shape (n, 3), or None. The first is the frame number.
        crs: Coordinate reference system of the positions: "EPSG:25832", 25832 or well-known text. None if unknown.

    Raises:
        TypeError: Not numbers, or not a coordinate system.
        ValueError: Shapes that do not match, or times in float32 that are more than 10 ms apart from the next number.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> loom.Trajectory(np.tile(np.eye(4), (3, 1, 1)), timestamps=[0.0, 0.1, 0.2])
        Trajectory(3 poses, timestamps)
    """

    poses: NDArray[np.float64]
    timestamps: NDArray[np.float64] | None = None
    ids: NDArray[np.int64] | None = None
    crs: CoordinateSystem | None = None

    def __post_init__(self):
        object.__setattr__(self, "crs", check_crs("crs", self.crs))
        poses = check_numeric("poses", self.poses)
        if poses.ndim != 3 or poses.shape[1:] != (4, 4):
            raise ValueError(f"poses: expected shape [n, 4, 4], got {list(poses.shape)}")
        object.__setattr__(self, "poses", poses.astype(np.float64, copy=False))
        if self.timestamps is not None:
            check_seconds("timestamps", check_numeric("timestamps", self.timestamps))
            object.__setattr__(self, "timestamps", check_shape("timestamps", self.timestamps, (len(poses),)))
        if self.ids is not None:
            ids = check_numeric("ids", self.ids)
            if ids.ndim != 2 or len(ids) != len(poses) or ids.dtype.kind not in "iu":
                shape = f"{list(ids.shape)} of {ids.dtype}"
                raise ValueError(f"ids: expected integers of shape [{len(poses)}, k], got {shape}")
            object.__setattr__(self, "ids", ids.astype(np.int64, copy=False))

    def __len__(self) -> int:
        return len(self.poses)

    def __getitem__(self, index: int | slice) -> NDArray[np.float64]:
        return self.poses[index]

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        return iter(self.poses)

    def __repr__(self) -> str:
        parts = [f"{len(self)} poses", *(["timestamps"] if self.timestamps is not None else [])]
        parts += [*(["ids"] if self.ids is not None else []), *([] if self.crs is None else [escaped(self.crs.name)])]
        return f"Trajectory({', '.join(parts)})"


def read_trajectory(path: str | os.PathLike[str], *, skip_missing: bool = False) -> Trajectory:
    """Read a trajectory. The extension and the number of columns determine the format.

    - `.log`: three integers and four matrix rows per pose, camera to world (Open3D, Redwood).
    - `.json`: Open3D's PinholeCameraTrajectory, extrinsics world to camera, column by column. Intrinsics are ignored.
    - `.txt` with 8 columns, `.tum`: `timestamp tx ty tz qx qy qz qw`. Quaternions within 1e-2 of unit length are
      normalized.
    - `.txt` with 12 columns, `.kitti`: the upper three matrix rows, camera to world.
    - `.csv` of EuRoC (ASL): `timestamp [ns], tx, ty, tz, qw, qx, qy, qz`. Further columns are ignored.

    Blank lines and lines that start with `#` are skipped in text formats. The line `# crs EPSG:25832` and the JSON key
    `crs` are the coordinate system.

    Args:
        path: The file.
        skip_missing: Skip lost poses (inf or NaN) in text formats. KITTI poses then get their line number as id.

    Returns:
        The poses; n >= 1.

    Raises:
        FileError: Unreadable, another format, empty, or a pose that is not rigid. With the line.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> poses = np.tile(np.eye(4), (3, 1, 1))
        >>> poses[:, 0, 3] = 0, 1, 2
        >>> loom.write_trajectory("path.tum", loom.Trajectory(poses, timestamps=[0.0, 0.1, 0.2]))
        >>> loom.read_trajectory("path.tum")
        Trajectory(3 poses, timestamps)
    """
    trajectory = _read_all(path, gaps=skip_missing)
    is_tracked = np.asarray(~np.isnan(trajectory.poses).any(axis=(1, 2)))
    if is_tracked.all():
        return trajectory
    if not is_tracked.any():
        raise FileError(path, f"all {len(is_tracked)} poses are lost: inf or NaN", remedy="Track the frames again")
    ids = trajectory.ids
    if ids is None and trajectory.timestamps is None:
        order = np.arange(len(is_tracked))
        ids = np.stack([order, order, order + 1], axis=1)
    times = None if trajectory.timestamps is None else trajectory.timestamps[is_tracked]
    return Trajectory(trajectory.poses[is_tracked], times, None if ids is None else ids[is_tracked], trajectory.crs)


def read_poses_and_gaps(path: str | os.PathLike[str]) -> Trajectory:
    """`read_trajectory` with NaN for lost poses."""
    return _read_all(path, gaps=True)


def _read_all(path: str | os.PathLike[str], *, gaps: bool) -> Trajectory:
    suffix = path_of(path).suffix.lower()
    if suffix == ".json":
        return _read_json(path)
    if suffix not in (*TRAJECTORY_FORMATS, EUROC):
        known = ", ".join([*TRAJECTORY_FORMATS, EUROC])
        remedy = recording_remedy(path, "trajectory()") or f"Known extensions are {known}"
        raise FileError(path, f"unknown trajectory format {suffix!r}", remedy=remedy)
    comments: list[str] = []
    lines, crs = read_lines(path, comments), None
    for comment in comments:
        if comment.startswith(_CRS_COMMENT):
            with contextlib.suppress(ValueError):
                crs = crs or check_crs("crs", comment.removeprefix(_CRS_COMMENT))
    if not lines:
        raise FileError(path, "contains no pose")
    if suffix == EUROC:
        return Trajectory(*timed_poses(path, euroc_lines(path, lines, comments), gaps=gaps), crs=crs)
    if suffix == ".log":
        poses, ids = log_poses(path, lines, gaps=gaps)
        return Trajectory(poses, ids=ids, crs=crs)
    columns = len(lines[0][1])
    if columns == 8 and suffix != ".kitti":
        return Trajectory(*timed_poses(path, lines, gaps=gaps), crs=crs)
    if columns == 12 and suffix != ".tum":
        return Trajectory(kitti_poses(path, lines, gaps=gaps), crs=crs)
    expected = {".tum": "8 columns", ".kitti": "12 columns"}.get(suffix, "8 columns (TUM) or 12 (KITTI)")
    raise FileError(
        path,
        f"expected {expected}, got {columns}",
        where=f"line {lines[0][0]}",
        remedy="Name it .log if it is Open3D's format",
    )


def write_trajectory(
    path: str | os.PathLike[str],
    trajectory: Trajectory,
    *,
    format: str | None = None,
    intrinsic: PinholeCameraIntrinsic | None = None,
    overwrite: bool = True,
) -> None:
    """Write a trajectory with all digits. Reading it returns the same poses.

    Only TUM stores timestamps and only .log stores ids. As in Open3D, missing TUM times are the first id or the index,
    and missing .log ids are `i i i+1`. TUM stores the rotation nearest to the matrix. TUM and JSON store `crs`.

    Args:
        path: The file.
        trajectory: At least one pose.
        format: "log", "tum", "kitti" or "json". None uses the extension (ambiguous for .txt).
        intrinsic: The camera, for JSON only.
        overwrite: Replace an existing file.

    Raises:
        ValueError: No pose, a pose that is not rigid, an unknown format, or JSON without intrinsic.
        FileError: The extension and the format disagree, or the file cannot be written.

    Warns:
        UserWarning: If the format cannot store the coordinate system.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> poses = np.tile(np.eye(4), (3, 1, 1))
        >>> poses[:, 0, 3] = 0, 1, 2
        >>> loom.write_trajectory("path.tum", loom.Trajectory(poses, timestamps=[0.0, 0.1, 0.2], crs=25832))
        >>> loom.read_trajectory("path.tum")
        Trajectory(3 poses, timestamps, EPSG:25832)
    """
    format = _output_format(path, format)
    if not isinstance(trajectory, Trajectory):
        raise TypeError(f"trajectory: expected a Trajectory, got {type(trajectory).__name__}")
    if intrinsic is not None:
        check_camera("intrinsic", intrinsic)
    check_writable(path, overwrite=overwrite)
    if not len(trajectory):
        raise ValueError("trajectory: expected at least one pose, got none")
    for i, T_world_camera in enumerate(trajectory.poses):
        check_rigid(f"trajectory.poses[{i}]", T_world_camera)
    if format == "json":
        if intrinsic is None:
            raise ValueError("intrinsic: the JSON format stores the camera with each pose, got None")
        text = _format_json(trajectory, intrinsic)
    elif format == "tum":
        text = _format_tum(trajectory)
    elif format == "kitti":
        text = "".join(_format_row(T[:3].ravel()) for T in trajectory.poses)
    else:
        text = _format_log(trajectory)
    if trajectory.crs is not None and format in ("log", "kitti"):
        name = trajectory.crs.name
        warn_of_units(
            f"{path}: {format} files cannot store the coordinate system {name}; .tum and .json do", UserWarning
        )
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(text.encode())


def _read_json(path: str | os.PathLike[str]) -> Trajectory:
    content = read_json_object(path)
    versions = {"version_major", "version_minor"}
    check_keys(path, content, required={"class_name", "parameters"}, optional={"crs", *versions})
    if content["class_name"] != "PinholeCameraTrajectory":
        reason = f"expected PinholeCameraTrajectory, got {str(content['class_name'])[:60]!r}"
        raise FileError(path, reason, where="key class_name")
    parameters = content["parameters"]
    if not isinstance(parameters, list) or not parameters:
        raise FileError(path, "expected a list of at least one camera", where="key parameters")
    poses = []
    for i, camera in enumerate(parameters):
        location = f"parameters[{i}]"
        if not isinstance(camera, dict):
            raise FileError(path, "expected an object", where=f"key {location}")
        optional = {"class_name", "intrinsic", *versions}
        check_keys(path, camera, required={"extrinsic"}, optional=optional, where=f"{location}.")
        T_camera_world = read_json_matrix(path, camera["extrinsic"], 4, where=f"key {location}.extrinsic")
        poses.append(inv(check_pose(path, T_camera_world, f"key {location}.extrinsic")))
    try:
        return Trajectory(np.array(poses), crs=content.get("crs"))
    except (TypeError, ValueError) as error:
        raise FileError(path, str(error), where="key crs") from error


def _output_format(path: str | os.PathLike[str], format: str | None) -> str:
    suffix = path_of(path).suffix.lower()
    implied = suffix[1:] if suffix[1:] in FORMATS else None
    if format is None and implied is None:
        remedy = f"Give format= one of {', '.join(FORMATS)}"
        raise FileError(path, f"the extension {suffix!r} does not determine the format", remedy=remedy)
    if format is not None and check_name("format", format) not in FORMATS:
        raise ValueError(f"format: expected one of {FORMATS}, got {format!r}")
    if format is not None and suffix not in extensions_of(format):
        raise FileError(path, f"{format} files end in {' or '.join(extensions_of(format))}, got {suffix!r}")
    return format or str(implied)


def _format_row(values: Iterable[float]) -> str:
    return " ".join(repr(float(value)) for value in values) + "\n"


def _format_log(trajectory: Trajectory) -> str:
    ids = trajectory.ids
    if ids is None:
        order = np.arange(len(trajectory))
        ids = np.stack([order, order, order + 1], axis=1)
    elif ids.shape[1] != 3:
        raise ValueError(f"trajectory.ids: the .log format expects 3 numbers per pose, got {ids.shape[1]}")
    parts = []
    for numbers, T_world_camera in zip(ids.tolist(), trajectory.poses, strict=True):
        parts.append(" ".join(map(str, numbers)) + "\n")
        parts.extend(_format_row(row) for row in T_world_camera)
    return "".join(parts)


def _format_tum(trajectory: Trajectory) -> str:
    times: Sequence[float] = range(len(trajectory))
    if trajectory.timestamps is not None:
        if not np.isfinite(trajectory.timestamps).all():
            raise ValueError("trajectory.timestamps: expected finite times, got NaN or infinite ones")
        times = trajectory.timestamps.tolist()
    elif trajectory.ids is not None and trajectory.ids.shape[1]:
        times = trajectory.ids[:, 0].tolist()
    quaternions = rotations_to_quaternions(nearest_rotations(trajectory.poses[:, :3, :3]))
    rows = np.concatenate([trajectory.poses[:, :3, 3], quaternions], axis=1)
    lines = (_format_row((time, *row)) for time, row in zip(times, rows.tolist(), strict=True))
    text = "" if trajectory.crs is None else f"{_CRS_COMMENT}{' '.join(trajectory.crs.text.split())}\n"
    return text + "# timestamp tx ty tz qx qy qz qw\n" + "".join(lines)


def _format_json(trajectory: Trajectory, intrinsic: PinholeCameraIntrinsic) -> str:
    version = {"version_major": 1, "version_minor": 0}
    parameters = [
        {
            "class_name": "PinholeCameraParameters",
            "extrinsic": T_camera_world.T.ravel().tolist(),
            "intrinsic": intrinsic_to_json(intrinsic),
            **version,
        }
        for T_camera_world in inv(trajectory.poses)
    ]
    crs = {} if trajectory.crs is None else {"crs": trajectory.crs.text}
    content = {"class_name": "PinholeCameraTrajectory", **crs, "parameters": parameters, **version}
    return json.dumps(content, indent=1) + "\n"
