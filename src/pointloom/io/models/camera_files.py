"""Read cameras with known poses from any supported file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...cameras.image_names import number_of
from ...cameras.trajectory import Trajectory, read_poses_and_gaps
from ...cameras.trajectory_formats import TRAJECTORY_FORMATS
from ...core.checks import check_list, check_name
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.json_files import read_json_object
from ...core.paths import path_of
from ..points.scan_files import natural_key
from .colmap import is_colmap_model, read_colmap_model
from .frame_cameras import contains_frame_cameras, read_frame_cameras, read_transforms
from .metashape import read_metashape_cameras
from .sfm_model import SfmModel

TIME_TOLERANCE = 0.02  # [s] between image and pose, as in the TUM benchmark's associate.py

_KNOWN = (
    "Give Metashape's .xml, a folder of COLMAP, transforms.json, Polycam's keyframes/cameras, frames of the 3D Scanner "
    f"App, or a trajectory ({', '.join(TRAJECTORY_FORMATS)})"
)


def read_cameras(
    path: FilePath, *, images: Sequence[str] | None = None, intrinsic: PinholeCameraIntrinsic | None = None
) -> SfmModel:
    """Read cameras and poses of images in any supported format.

    - `.xml`: Agisoft Metashape (File > Export > Export Cameras).
    - A folder with COLMAP's cameras, images and points3D.
    - `.json` with `frames`: transforms.json of nerfstudio or instant-ngp.
    - A folder with a JSON file per image: Polycam's keyframes/cameras, or 3D Scanner App.
    - a trajectory, see `read_trajectory`. Requires `images` and
      `intrinsic`.

    Args:
        path: The file or folder.
        images: Image names, for trajectories only. They match poses by the time in the name (TUM, less than 0.02 s
            apart) or the frame number (.log). Else sorted images correspond to poses one by one.
        intrinsic: The camera of all images, for trajectories only.

    Returns:
        The cameras, world to camera (x right, y down, z forward). Images without a pose are listed in `left_out`.

    Raises:
        FileError: An unknown format, damaged, or poses that cannot be assigned.
        TypeError, ValueError: `images` or `intrinsic` is missing, or does not match the file.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> poses = np.tile(np.eye(4), (2, 1, 1))
        >>> poses[1, 0, 3] = 0.5
        >>> loom.write_trajectory("path.tum", loom.Trajectory(poses, timestamps=[10.0, 10.5]))
        >>> lens = loom.PinholeCameraIntrinsic.prime_sense_default()
        >>> model = loom.read_cameras("path.tum", images=["10.00.png", "10.50.png", "11.0.png"], intrinsic=lens)
        >>> model.centers.tolist(), model.left_out
        ([[0.0, 0.0, 0.0], [0.5, 0.0, 0.0]], ('11.0.png: no pose',))
    """
    file = path_of(path)
    kind = _kind_of(file)
    if kind != "trajectory":
        if intrinsic is not None:
            raise ValueError(f"intrinsic: {escaped(file.name)} contains the lenses. Leave it out")
        readers: dict[str, Any] = {"metashape": read_metashape_cameras, "colmap": read_colmap_model}
        readers |= {"transforms": read_transforms, "frames": read_frame_cameras}
        return readers[kind](file)
    if intrinsic is None:
        reason = "contains only poses, and no lens"
        raise FileError(file, reason, remedy="Give the camera as intrinsic (--intrinsic, Open3D's JSON) too")
    if images is None:
        raise ValueError("images: expected the names of the images, which a trajectory does not contain")
    names = [check_name("images", name) for name in check_list("images", images, "names")]
    trajectory = read_poses_and_gaps(file)
    lost = np.asarray(np.isnan(trajectory.poses).any(axis=(1, 2)))
    chosen = [None if row is None or lost[row] else row for row in _poses_of(file, trajectory, names)]
    rows_with_pose = [i for i, row in enumerate(chosen) if row is not None]
    if not rows_with_pose:
        raise FileError(file, "contains the pose of none of the images", remedy=f"The first image is {names[0]}")
    rows = [row for row in chosen if row is not None]
    left_out = tuple(f"{name}: no pose" for name, row in zip(names, chosen, strict=True) if row is None)
    lens = CameraModel.from_intrinsic(intrinsic)
    poses = _inverse(trajectory.poses[rows])
    return SfmModel(tuple(names[i] for i in rows_with_pose), (lens,) * len(rows_with_pose), poses, left_out=left_out)


def _kind_of(path: Path) -> str:
    if path.is_dir():
        if is_colmap_model(path):
            return "colmap"
        if contains_frame_cameras(path):
            return "frames"
        raise FileError(path, "contains no supported cameras", remedy=_KNOWN)
    suffix = path.suffix.lower()
    if suffix == ".xml":
        return "metashape"
    if suffix == ".json" and "frames" in read_json_object(path):
        return "transforms"
    if suffix in TRAJECTORY_FORMATS:
        return "trajectory"
    raise FileError(path, "does not exist" if not path.exists() else "is not a supported camera file", remedy=_KNOWN)


def _poses_of(path: Path, trajectory: Trajectory, names: Sequence[str]) -> list[int | None]:
    """Pose index of each image: by time, by number, or in order."""
    if trajectory.timestamps is not None and (times := _times_of(names)) is not None:
        return _by_time(trajectory.timestamps, times)
    if trajectory.ids is not None:
        rows = {int(number): k for k, number in enumerate(trajectory.ids[:, 0])}
        numbers = [number_of(name) for name in names]
        if None not in numbers and len(set(numbers)) == len(names) and len(rows) == len(trajectory):
            return [rows.get(int(number or 0)) for number in numbers]
    if len(names) != len(trajectory):
        reason = f"contains {len(trajectory)} poses for {len(names)} images, which cannot be matched"
        raise FileError(
            path, reason, remedy="Name the images by the times of the poses, or give as many images as poses"
        )
    order = sorted(range(len(names)), key=lambda i: natural_key(Path(names[i])))
    rows_in_order: list[int | None] = [None] * len(names)
    for row, i in enumerate(order):
        rows_in_order[i] = row
    return rows_in_order


def _times_of(names: Sequence[str]) -> NDArray[np.float64] | None:
    stems = [Path(name).name.rsplit(".", 1)[0] for name in names]
    if all(re.fullmatch(r"\d+\.\d+", stem) for stem in stems):
        return np.array([float(stem) for stem in stems])
    return None


def _by_time(known: NDArray[np.float64], times: NDArray[np.float64]) -> list[int | None]:
    order = np.argsort(known, kind="stable")
    at = np.clip(np.searchsorted(known[order], times), 1, max(len(known) - 1, 1))
    if len(known) > 1:
        at -= np.abs(known[order][at - 1] - times) <= np.abs(known[order][at] - times)
    else:
        at[:] = 0
    rows = order[at]
    return [
        int(row) if abs(known[row] - time) < TIME_TOLERANCE else None for row, time in zip(rows, times, strict=True)
    ]


def _inverse(poses: NDArray[np.float64]) -> NDArray[np.float64]:
    inverse = np.tile(np.eye(4), (len(poses), 1, 1))
    inverse[:, :3, :3] = poses[:, :3, :3].transpose(0, 2, 1)
    inverse[:, :3, 3] = -np.einsum("nji,nj->ni", poses[:, :3, :3], poses[:, :3, 3])
    return inverse
