"""Points that pictures with known poses see: features matched along epipolar lines, and triangulated by COLMAP."""

from __future__ import annotations

import dataclasses
import os
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_progress, check_seed
from ...core.devices import resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.reports import Assessed, quality
from ...core.timing import Clock
from ...files.models.sfm_model import SfmModel
from ...files.pictures.image_files import read_color
from .colmap_jobs import MAX_SECONDS, run_job
from .feature_rays import FeatureRays, focal_of, read_feature_rays
from .features import MAX_FEATURES, MAX_SIZE, find_features
from .guided_matches import PairMatches, match_guided, pairs_in_view
from .limited_process import check_limits
from .model_quality import FINDING_SIZE, ModelQuality, assess_model
from .picture_folder import check_place, list_pictures
from .pose_check import NEAR, PoseCheck, check_poses
from .posed_pictures import with_poses

LEAST_DISTANCE = 1.0  # [px] of a picture as features are found in it: those of SIFT are off by a third of that
FEWEST_VIEWS = 3  # of a point where there are so many pictures: any two rays that meet make one of two
DISTANCES = 4.0  # times the median distance of matches from their lines: what is farther is no match
MIN_ANGLE = 1.5  # [degrees] under which a point is seen
FEWEST_MATCHES = 8  # of a pair


@dataclasses.dataclass(frozen=True)
class TriangulationResult(Assessed):
    """What pictures with known poses see.

    Args:
        model: The cameras as they were given, of the pictures that are there, and the points; no points where the
            poses do not fit.
        quality: Its quality.
        without_pose: Pictures of the folder without a pose.
        without_picture: Names of cameras without a picture.
        seconds: Time of each stage [s].
        peak_bytes: The most memory that COLMAP was seen to hold in each [B].
    """

    model: SfmModel
    quality: ModelQuality
    without_pose: tuple[str, ...]
    without_picture: tuple[str, ...]
    seconds: dict[str, float]
    peak_bytes: dict[str, int]

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy; empty if the result is reliable."""
        return self.quality.warnings

    def to_dict(self) -> dict[str, Any]:
        """All but the model in JSON's types."""
        names = {"without_pose": list(self.without_pose), "without_picture": list(self.without_picture)}
        told = {"seconds": self.seconds, "peak_bytes": self.peak_bytes}
        return names | told | {"quality": self.quality.to_dict(), **quality(self)}


def triangulate(
    pictures: FilePath,
    cameras: SfmModel,
    *,
    max_size: int = MAX_SIZE,
    max_features: int = MAX_FEATURES,
    seed: int = 0,
    device: Any = None,
    max_seconds: float | None = MAX_SECONDS,
    max_memory: int | None = None,
    progress: ReportProgress | None = None,
) -> TriangulationResult:
    """Find the points that pictures with known poses see.

    Pictures whose frusta overlap are matched: features that lie within a few pixels of each other's epipolar lines and
    look alike. COLMAP makes points of them; poses and lenses stay as they were given. Before, the poses are held
    against matches by looks alone, so that wrong ones are told and make no points.

    Args:
        pictures: A folder of upright 8-bit PNG or JPEG pictures.
        cameras: Lenses and poses, such as of `read_metashape_cameras`, `read_colmap_model`, `read_cameras`; its points
            are not looked at. Pictures are those of its names, with or without their ending.
        max_size: The longer side is scaled down to this to find features [px].
        max_features: Of a picture.
        seed: Of random numbers.
        device: Where features are matched; None for the CPU.
        max_seconds: Each stage of COLMAP's is given up after this time [s]; None for no limit.
        max_memory: Of COLMAP's process [B]; None for nine tenths of what is free.
        progress: Called with the stage ("features", "matches"), how many of its steps are done, and how many there are.

    Returns:
        The model with points, and its quality. That the poses do not fit the pictures is a result, not an error:
        `quality.poses` has the figures.

    Raises:
        FileError: No such pictures, fewer than two with a camera, one that is damaged or of another size than its
            camera; pycolmap is missing (`pip install "pointloom[sfm]"`); COLMAP failed or passed a limit.
        TypeError, ValueError: An argument out of range.
        DeviceError: No such device.

    Notes:
        The same points from run to run, for any number of threads. Features beyond 75 degrees off the axis are left
        out. The distance from lines that is admitted is 4 times the median of matches by looks, 1 px at least and 0.6 %
        of the picture's longer side at most; a point is seen by three pictures, where there are so many.
        Triangulation: Schoenberger and Frahm 2016, section 4.3.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None])
        >>> loom.sfm.triangulate("no such folder", model)
        Traceback (most recent call last):
        pointloom.core.errors.DatasetError: no such folder: does not exist. Give a folder of pictures
    """
    clock, say, folder = Clock(), check_progress(progress), check_place("pictures", pictures)
    if not isinstance(cameras, SfmModel):
        raise TypeError(f"cameras: expected an SfmModel, got {type(cameras).__name__}")
    check_seed(seed)
    limits: dict[str, Any] = {"max_seconds": max_seconds, "max_memory": max_memory}
    check_limits(**limits)
    target = resolve_device(device)
    posed = with_poses(folder, list_pictures(folder), cameras)
    with tempfile.TemporaryDirectory(prefix="pointloom-") as scratch:
        database = Path(scratch) / "features.db"
        options = {"max_size": max_size, "max_features": max_features, "seed": seed, "progress": progress}
        found = find_features(folder, database, **options, **limits)
        clock.stop("features")
        matches, check = match_posed(database, posed.model, device=target, progress=say)
        clock.stop("matches")
        model, peak = points_of(database, posed.model, matches, check, folder, seed=seed, **limits)
    clock.stop("points")
    assessed = assess_model(model, posed.picture_count, fix_intrinsic=True, poses=check)
    missing = posed.without_pose, posed.without_picture
    return TriangulationResult(model, assessed, *missing, clock.seconds, {"features": found.peak_bytes, "points": peak})


def match_posed(
    database: Path, model: SfmModel, *, device: Any, progress: ReportProgress
) -> tuple[PairMatches, PoseCheck]:
    """Hold poses against the pictures, and match their features along epipolar lines where they fit."""
    features = read_feature_rays(database, model.names, model.cameras)
    pairs = pairs_in_view(model.cameras, model.T_camera_world)
    check = check_poses(features, model, pairs)
    if check.are_wrong:
        return PairMatches.of_lists(pairs[:0], []), check
    distance = admitted_distance(model, check)
    return match_guided(features, model, pairs, distance=distance, device=device, progress=progress), check


def admitted_distance(model: SfmModel, check: PoseCheck) -> float:
    """How far from its epipolar line a match may be [px]: as rough as poses and cameras are."""
    longer = max(max(camera.width, camera.height) for camera in model.cameras)
    least = LEAST_DISTANCE * max(1.0, longer / FINDING_SIZE)
    return float(min(max(least, DISTANCES * check.distance), max(least, 1.5 * NEAR * longer)))


def points_of(
    database: Path,
    model: SfmModel,
    matches: PairMatches,
    check: PoseCheck,
    pictures: Path,
    *,
    seed: int,
    max_seconds: float | None,
    max_memory: int | None,
) -> tuple[SfmModel, int]:
    """The model with the points of matches, and the most memory that COLMAP took [B]."""
    bare = SfmModel(model.names, model.cameras, model.T_camera_world, left_out=model.left_out)
    if not len(matches.matches):
        return bare, 0
    features = read_feature_rays(database, model.names, model.cameras)
    focals = np.array([focal_of(camera) for camera in model.cameras])
    error = admitted_distance(model, check)
    with tempfile.TemporaryDirectory(prefix="pointloom-") as scratch:
        place = Path(scratch)
        arrays, found = place / "arrays.npz", place / "found.npz"
        np.savez(arrays, **_arrays_of(model, features, matches, focals))
        job = {"stage": "points", "seed": int(seed), "fewest": FEWEST_MATCHES, "error": error, "angle": MIN_ANGLE}
        job |= {"angle_error": float(np.degrees(2 * error / np.median(focals))), "scratch": scratch}
        job |= {"database": os.fspath(place / "points.db"), "arrays": os.fspath(arrays), "found": os.fspath(found)}
        _, peak = run_job(job, database, **check_limits(max_seconds, max_memory))
        with np.load(found) as read:
            points, seen = _often_seen(read["points"], read["seen"], min(FEWEST_VIEWS, len(model)))
    rows = features.firsts[seen[:, 0]] + seen[:, 1]
    errors, colors = (
        _errors(model, points, seen, features.pixels[rows]),
        _colors(pictures, model, seen, features, len(points)),
    )
    whole = dataclasses.replace(
        bare, points=points, colors=colors, errors=errors, observations=seen[:, [0, 2]], pixels=features.pixels[rows]
    )
    return whole, peak


def _often_seen(
    points: NDArray[np.float64], seen: NDArray[np.int64], fewest: int
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    pairs = np.unique(seen[:, [2, 0]], axis=0)
    kept = np.bincount(pairs[:, 0], minlength=len(points)) >= fewest
    place, seen = np.cumsum(kept) - 1, seen[kept[seen[:, 2]]]
    return points[kept], np.column_stack([seen[:, :2], place[seen[:, 2]]])


def _arrays_of(
    model: SfmModel, features: FeatureRays, matches: PairMatches, focals: NDArray[np.float64]
) -> dict[str, Any]:
    """What COLMAP's process is told: pictures without distortion, their poses, features and matches."""
    owner = np.repeat(np.arange(len(model)), np.diff(features.firsts))
    return {
        "sizes": np.array([(camera.width, camera.height) for camera in model.cameras]),
        "focals": focals,
        "poses": model.T_camera_world[:, :3],
        "firsts": features.firsts,
        "places": np.nan_to_num(features.rays * focals[owner][:, None]),
        "pairs": matches.pairs,
        "starts": matches.firsts,
        "matches": matches.matches,
    }


def _errors(
    model: SfmModel, points: NDArray[np.float64], seen: NDArray[np.int64], pixels: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The mean distance between where points are seen and where they should be [px]."""
    off = np.zeros(len(seen))
    for i, (camera, T) in enumerate(zip(model.cameras, model.T_camera_world, strict=True)):
        mine = seen[:, 0] == i
        at = points[seen[mine, 2]] @ T[:3, :3].T + T[:3, 3]
        off[mine] = np.linalg.norm(camera.project(at) - pixels[mine], axis=1)
    off = np.nan_to_num(off, nan=0.0)  # beyond what a fitted lens has an inverse for
    return np.bincount(seen[:, 2], off, len(points)) / np.maximum(np.bincount(seen[:, 2], minlength=len(points)), 1)


def _colors(
    pictures: Path, model: SfmModel, seen: NDArray[np.int64], features: FeatureRays, count: int
) -> NDArray[np.uint8]:
    """The mean colour of points where they are seen."""
    sums = np.zeros((count, 3))
    for i, name in enumerate(model.names):
        mine = seen[seen[:, 0] == i]
        color = read_color(pictures / name)
        column, row = np.rint(features.pixels[features.firsts[i] + mine[:, 1]]).astype(int).T
        inside = np.clip(row, 0, color.shape[0] - 1), np.clip(column, 0, color.shape[1] - 1)
        np.add.at(sums, mine[:, 2], color[inside].astype(float))
    views = np.maximum(np.bincount(seen[:, 2], minlength=count), 1)
    return np.rint(sums / views[:, None]).astype(np.uint8)
