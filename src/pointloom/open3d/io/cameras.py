"""Files of cameras and trajectories. Extrinsics are world to camera, as in Open3D."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ...cameras import camera, trajectory
from ...core.atomic import atomic_write
from ...core.checks import check_rigid
from ...core.errors import FileError, FilePath, values_of_file
from ...core.json_files import check_keys, check_version, read_json_object
from ..argument_types import CameraLike
from ..camera.intrinsic import PinholeCameraIntrinsic
from ..camera.parameters import PinholeCameraParameters, PinholeCameraTrajectory
from ..wrapper import unwrap

FILE_VERSION = {"version_major": 1, "version_minor": 0}


def read_pinhole_camera_intrinsic(filename: FilePath) -> PinholeCameraIntrinsic:
    return PinholeCameraIntrinsic.from_native(camera.read_pinhole_camera_intrinsic(filename))


def write_pinhole_camera_intrinsic(filename: FilePath, intrinsic: CameraLike) -> bool:
    camera.write_pinhole_camera_intrinsic(filename, unwrap(intrinsic, PinholeCameraIntrinsic, "intrinsic"))
    return True


def read_pinhole_camera_parameters(filename: FilePath) -> PinholeCameraParameters:
    content = read_json_object(filename)
    check_keys(filename, content, required={"intrinsic", "extrinsic"}, optional={"class_name", *FILE_VERSION})
    check_version(filename, content, "PinholeCameraParameters")
    made = PinholeCameraParameters()
    made.intrinsic = camera.read_pinhole_camera_intrinsic(filename)
    with values_of_file(filename, where="key extrinsic"):
        extrinsic = camera.read_json_matrix(filename, content["extrinsic"], 4, where="key extrinsic")
        made.extrinsic = check_rigid("extrinsic", extrinsic)
    return made


def write_pinhole_camera_parameters(filename: FilePath, parameters: PinholeCameraParameters) -> bool:
    return _write_json(filename, _parameters_to_json(parameters))


def read_pinhole_camera_trajectory(filename: FilePath) -> PinholeCameraTrajectory:
    """Cameras from .json, or poses from .log and .txt (TUM) with PrimeSense's camera, as in Open3D."""
    poses = trajectory.read_trajectory(filename)
    made = PinholeCameraTrajectory.from_native(poses, camera.PinholeCameraIntrinsic.prime_sense_default())
    if Path(filename).suffix.lower() == ".json":
        for i, (one, content) in enumerate(zip(made.parameters, read_json_object(filename)["parameters"], strict=True)):
            one.intrinsic = _intrinsic_of(filename, content, f"key parameters[{i}].intrinsic")
    return made


def write_pinhole_camera_trajectory(filename: FilePath, trajectory: PinholeCameraTrajectory) -> bool:
    """Write cameras as .json, or poses only as .log or .txt (TUM)."""
    if Path(filename).suffix.lower() == ".json":
        parameters = [_parameters_to_json(one) for one in trajectory.parameters]
        return _write_json(
            filename, {"class_name": "PinholeCameraTrajectory", "parameters": parameters, **FILE_VERSION}
        )
    return _write_poses(filename, trajectory)


def _write_poses(filename: FilePath, cameras: PinholeCameraTrajectory) -> bool:
    format = "tum" if Path(filename).suffix.lower() == ".txt" else None
    trajectory.write_trajectory(filename, cameras.native, format=format)
    return True


def _intrinsic_of(filename: FilePath, content: dict[str, Any], where: str) -> PinholeCameraIntrinsic:
    record = content.get("intrinsic")
    if not isinstance(record, dict) or not {"width", "height", "intrinsic_matrix"} <= record.keys():
        raise FileError(filename, "expected width, height and intrinsic_matrix", where=where)
    K = camera.read_json_matrix(filename, record["intrinsic_matrix"], 3, where=where)
    with values_of_file(filename, where=where):
        return PinholeCameraIntrinsic(record["width"], record["height"], K)


def _parameters_to_json(parameters: PinholeCameraParameters) -> dict[str, Any]:
    return {
        "class_name": "PinholeCameraParameters",
        "extrinsic": parameters.extrinsic.T.ravel().tolist(),
        "intrinsic": camera.intrinsic_to_json(unwrap(parameters.intrinsic)),
        **FILE_VERSION,
    }


def _write_json(filename: FilePath, content: dict[str, Any]) -> bool:
    with atomic_write(filename) as file:
        file.write(json.dumps(content, indent=4).encode() + b"\n")
    return True
