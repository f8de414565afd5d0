"""The stages to a model where lenses and poses are known: pictures by their names, matches along lines, points."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ...cameras.camera_models import MODELS, CameraModel
from ...cameras.undistortion import Undistortion
from ...core.errors import DatasetError, FilePath
from ...core.progress import ReportProgress
from ...core.stages import Made
from ...files.models.colmap import read_colmap_model, write_colmap_model
from ...files.models.sfm_model import SfmModel
from ...files.pictures.photo_files import is_photo
from .. import sfm
from ..sfm.colmap_jobs import MAX_SECONDS
from ..sfm.frame_picker import spaced
from ..sfm.guided_matches import read_matches, write_matches
from ..sfm.picture_choice import told_twice
from ..sfm.picture_folder import UPRIGHT, list_photographs, read_header, read_orientation, read_stored
from ..sfm.picture_writing import write_bytes, write_picture
from ..sfm.pose_check import PoseCheck
from ..sfm.posed_pictures import with_poses
from ..sfm.triangulation import match_posed, points_of
from ..sfm.verdict import judge_model
from .motion import DATABASE, MODEL, PICTURES, described, only_turned
from .settings import Settings

CAMERAS, MATCHES = "cameras", "matches.npz"


def take_pictures(
    folder: Path, say: ReportProgress, *, source: FilePath, max_frames: int, posed: Settings
) -> dict[str, Any]:
    """The pictures of a folder that have a pose, as they are stored: lenses belong to that, and not to turned ones."""
    if not Path(source).is_dir():
        raise DatasetError(source, "is no folder", remedy="Cameras with poses are of pictures: give their folder")
    paths, second = list_photographs(source)
    given = posed.read_posed([path.name for path in paths])
    assert given is not None
    found = with_poses(source, paths, given)
    chosen = spaced(list(range(len(found.paths))), max_frames)
    pictures = folder / PICTURES
    pictures.mkdir()
    names, cameras, remarks = [], [], list(found.remarks)
    if len(chosen) < len(found.paths):
        remarks.append(f"{len(chosen)} of {len(found.paths)} pictures are taken, evenly by their names (max_frames)")
    lenses: dict[CameraModel, Undistortion] = {}
    for done, k in enumerate(chosen):
        say("write", done, len(chosen))
        name, camera = _write(pictures, found.paths[k], found.model.cameras[k], lenses)
        names.append(name)
        cameras.append(camera)
    say("write", len(chosen), len(chosen))
    if len({Path(name).stem for name in names}) < len(names):
        raise DatasetError(source, "holds pictures whose names differ by their ending alone", remedy="Rename them")
    model = SfmModel(tuple(names), tuple(cameras), found.model.T_camera_world[chosen])
    write_colmap_model(folder / CAMERAS, model)
    remarks += [f"not used, {line}" for line in given.left_out[:4]] + told_twice(second)
    missing = len(found.without_pose) * len(names) // len(found.paths)
    return {"kept": len(names), "frames": len(paths), "remarks": remarks, "missing": missing}


def _write(
    pictures: Path, path: Path, camera: CameraModel, lenses: dict[CameraModel, Undistortion]
) -> tuple[str, CameraModel]:
    """A picture as COLMAP reads it, and its camera; one whose lens COLMAP does not have is straightened."""
    header = read_header(path)
    if MODELS[camera.model].number is None:
        lens = lenses.setdefault(camera, Undistortion(camera))
        write_picture(pictures / f"{path.stem}.png", lens.apply(read_stored(path)))
        return f"{path.stem}.png", CameraModel.from_intrinsic(lens.intrinsic)
    if header.bits == 8 and header.channels in (1, 3) and not is_photo(path) and read_orientation(path) == UPRIGHT:
        write_bytes(pictures / path.name, path.read_bytes())
        return path.name, camera
    write_picture(pictures / f"{path.stem}.png", read_stored(path))
    return f"{path.stem}.png", camera


def find_features(
    folder: Path, say: ReportProgress, *, frames: Made, finder: str, seed: int, device: Any
) -> dict[str, Any]:
    """What can be recognised in each picture."""
    pictures, database = frames.folder / PICTURES, folder / DATABASE
    options = {"finder": finder, "device": device, "seed": seed, "progress": say}
    return sfm.find_features(pictures, database, **options).to_json()


def match(folder: Path, say: ReportProgress, *, frames: Made, features: Made, device: Any) -> dict[str, Any]:
    """Whether the poses are those of the pictures, and which features of two lie on each other's epipolar lines."""
    model = read_colmap_model(frames.folder / CAMERAS)
    found, check = match_posed(features.folder / DATABASE, model, device=device, progress=say)
    write_matches(folder / MATCHES, found)
    return {"pair_count": len(found.pairs), "match_count": len(found.matches), "poses": check.to_json()}


def triangulate(
    folder: Path, say: ReportProgress, *, frames: Made, features: Made, matches: Made, seed: int
) -> dict[str, Any]:
    """The points of matches, with lenses and poses as they are, and what the model is worth."""
    model = read_colmap_model(frames.folder / CAMERAS)
    check = PoseCheck.from_json(matches.told["poses"])
    found = read_matches(matches.folder / MATCHES)
    where = features.folder / DATABASE, model, found, check, frames.folder / PICTURES
    whole, _ = points_of(*where, seed=seed, max_seconds=MAX_SECONDS, max_memory=None)
    verdict = judge_model(whole, len(model) + frames.told["missing"], fix_intrinsic=True, poses=check)
    write_colmap_model(folder / MODEL, whole)
    cameras = tuple(dict.fromkeys(whole.cameras))
    told = {"missing": [], "cameras": [described(camera) for camera in cameras]}
    return verdict.to_json() | told | {"turned": only_turned(verdict, cameras)}
