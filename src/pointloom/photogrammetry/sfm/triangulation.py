"""Triangulation with known poses: matching along epipolar lines, and points by COLMAP."""

from __future__ import annotations

import dataclasses
import os
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.reports import Assessed, quality
from ...core.timing import Clock
from ...io.images.image_files import read_color
from ...io.models.sfm_model import SfmModel
from ...kernels.array_types import Device
from .colmap_jobs import run_job
from .feature_rays import FeatureRays, focal_of, read_feature_rays
from .features import find_features
from .guided_matches import PairMatches, match_guided, pairs_in_view
from .image_folder import check_path, list_images
from .limited_process import check_limits
from .model_quality import FINDING_SIZE, ModelQuality, assess_model
from .pose_check import MAX_EPIPOLAR_DISTANCE, PoseCheck, check_poses
from .posed_images import with_poses
from .settings import SfmSettings, check_settings

MIN_DISTANCE = 1.0  # [px] at extraction size: SIFT errors are a third of that
MIN_VIEWS = 3  # minimum views if there are enough images: any two rays that meet give a point
EPIPOLAR_DISTANCE_FACTOR = 4.0  # times the median epipolar distance
MIN_ANGLE = 1.5  # [degrees] minimum triangulation angle
MIN_MATCHES = 8  # minimum per pair


@dataclasses.dataclass(frozen=True)
class TriangulationResult(Assessed):
    """Result of `triangulate`.

    Args:
        model: The given cameras of the images, and the points. No points if the poses do not fit.
        quality: Quality of the model.
        without_pose: Images without a pose.
        without_image: Names of cameras without an image.
        seconds: Time of each stage [s].
        peak_bytes: Peak memory of COLMAP in each [B].
    """

    model: SfmModel
    quality: ModelQuality
    without_pose: tuple[str, ...]
    without_image: tuple[str, ...]
    seconds: dict[str, float]
    peak_bytes: dict[str, int]

    @property
    def warnings(self) -> tuple[str, ...]:
        return self.quality.warnings

    def to_dict(self) -> dict[str, Any]:
        names = {"without_pose": list(self.without_pose), "without_image": list(self.without_image)}
        stats = {"seconds": self.seconds, "peak_bytes": self.peak_bytes}
        return names | stats | {"quality": self.quality.to_dict(), **quality(self)}


def triangulate(
    images: FilePath,
    cameras: SfmModel,
    settings: SfmSettings | None = None,
    *,
    device: DeviceLike = None,
    progress: ReportProgress | None = None,
) -> TriangulationResult:
    """Triangulate points from images with known poses.

    Images with overlapping frusta are matched near the epipolar lines, and COLMAP triangulates the points. Poses and
    lenses are not changed. First the poses are checked against matches by appearance. Wrong ones give no points.

    Args:
        images: Folder of upright 8-bit PNG or JPEG images.
        cameras: Lenses and poses, such as from `read_cameras`, without
            their points. Images by name, with or without extension.
        settings: Features and limits of COLMAP; None: the defaults.
        device: Matching device; None: the CPU.
        progress: Called with (stage, steps done, steps in all), stages "features" and "matches".

    Returns:
        The model with points, and its quality. Poses that do not fit the images are a result, see `quality.poses`.

    Raises:
        FileError: Missing or damaged images, fewer than two with a camera, or of another size than their camera;
            pycolmap is missing (`pip install "pointloom[sfm]"`). COLMAP failed or passed a limit.
        TypeError, ValueError: An argument is out of range.
        DeviceError: No such device.

    Notes:
        Reproducible for any number of threads. Features beyond 75 degrees off the axis are ignored. Maximum epipolar
        distance: 4 times the median of matches by appearance, between 1 px and 0.6% of the longer side. Points need
        three images if possible. Schoenberger and Frahm, "Structure-from-motion revisited", CVPR 2016, section 4.3.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None])
        >>> loom.photogrammetry.triangulate("no such folder", model)
        Traceback (most recent call last):
        pointloom.core.errors.DatasetError: no such folder: does not exist. Give a folder of images
    """
    clock, report, folder = Clock(), check_progress(progress), check_path("images", images)
    if not isinstance(cameras, SfmModel):
        raise TypeError(f"cameras: expected an SfmModel, got {type(cameras).__name__}")
    settings = check_settings(settings)
    target = resolve_device(device)
    posed = with_poses(folder, list_images(folder), cameras)
    with tempfile.TemporaryDirectory(prefix="pointloom-") as scratch:
        database = Path(scratch) / "features.db"
        features = find_features(folder, database, settings, progress=progress)
        clock.stop("features")
        matches, check = match_posed(database, posed.model, device=target, progress=report)
        clock.stop("matches")
        model, peak = points_of(database, posed.model, matches, check, folder, settings)
    clock.stop("points")
    assessed = assess_model(model, posed.image_count, fix_intrinsic=True, poses=check)
    missing = posed.without_pose, posed.without_image
    return TriangulationResult(
        model, assessed, *missing, clock.seconds, {"features": features.peak_bytes, "points": peak}
    )


def match_posed(
    database: Path, model: SfmModel, *, device: Device, progress: ReportProgress
) -> tuple[PairMatches, PoseCheck]:
    features = read_feature_rays(database, model.names, model.cameras)
    pairs = pairs_in_view(model.cameras, model.T_camera_world)
    check = check_poses(features, model, pairs)
    if check.are_wrong:
        return PairMatches.of_lists(pairs[:0], []), check
    distance = admitted_distance(model, check)
    return match_guided(features, model, pairs, distance=distance, device=device, progress=progress), check


def admitted_distance(model: SfmModel, check: PoseCheck) -> float:
    """Maximum epipolar distance of a match [px], by the accuracy of the poses."""
    longer = max(max(camera.width, camera.height) for camera in model.cameras)
    minimum = MIN_DISTANCE * max(1.0, longer / FINDING_SIZE)
    return float(
        min(max(minimum, EPIPOLAR_DISTANCE_FACTOR * check.distance), max(minimum, 1.5 * MAX_EPIPOLAR_DISTANCE * longer))
    )


def points_of(
    database: Path, model: SfmModel, matches: PairMatches, check: PoseCheck, images: Path, settings: SfmSettings
) -> tuple[SfmModel, int]:
    bare = SfmModel(model.names, model.cameras, model.T_camera_world, left_out=model.left_out)
    if not len(matches.matches):
        return bare, 0
    features = read_feature_rays(database, model.names, model.cameras)
    focals = np.array([focal_of(camera) for camera in model.cameras])
    error = admitted_distance(model, check)
    with tempfile.TemporaryDirectory(prefix="pointloom-") as scratch:
        folder = Path(scratch)
        arrays, output = folder / "arrays.npz", folder / "found.npz"
        np.savez(arrays, **_arrays_of(model, features, matches, focals))
        job = {"stage": "points", "seed": int(settings.seed), "fewest": MIN_MATCHES, "error": error, "angle": MIN_ANGLE}
        job |= {"angle_error": float(np.degrees(2 * error / np.median(focals))), "scratch": scratch}
        job |= {"database": os.fspath(folder / "points.db"), "arrays": os.fspath(arrays), "found": os.fspath(output)}
        _, peak = run_job(job, database, **check_limits(settings.max_seconds, settings.max_memory))
        with np.load(output) as read:
            points, seen = _often_seen(read["points"], read["seen"], min(MIN_VIEWS, len(model)))
    rows = features.firsts[seen[:, 0]] + seen[:, 1]
    errors, colors = (
        _errors(model, points, seen, features.pixels[rows]),
        _colors(images, model, seen, features, len(points)),
    )
    complete = dataclasses.replace(
        bare, points=points, colors=colors, errors=errors, observations=seen[:, [0, 2]], pixels=features.pixels[rows]
    )
    return complete, peak


def _often_seen(
    points: NDArray[np.float64], seen: NDArray[np.int64], min_count: int
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    pairs = np.unique(seen[:, [2, 0]], axis=0)
    selected = np.bincount(pairs[:, 0], minlength=len(points)) >= min_count
    new_index, seen = np.cumsum(selected) - 1, seen[selected[seen[:, 2]]]
    return points[selected], np.column_stack([seen[:, :2], new_index[seen[:, 2]]])


def _arrays_of(
    model: SfmModel, features: FeatureRays, matches: PairMatches, focals: NDArray[np.float64]
) -> dict[str, Any]:
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
    off = np.zeros(len(seen))
    for i, (camera, T) in enumerate(zip(model.cameras, model.T_camera_world, strict=True)):
        mine = seen[:, 0] == i
        at = points[seen[mine, 2]] @ T[:3, :3].T + T[:3, 3]
        off[mine] = np.linalg.norm(camera.project(at) - pixels[mine], axis=1)
    off = np.nan_to_num(off, nan=0.0)  # outside the invertible area of a fitted lens
    return np.bincount(seen[:, 2], off, len(points)) / np.maximum(np.bincount(seen[:, 2], minlength=len(points)), 1)


def _colors(
    images: Path, model: SfmModel, seen: NDArray[np.int64], features: FeatureRays, count: int
) -> NDArray[np.uint8]:
    sums = np.zeros((count, 3))
    for i, name in enumerate(model.names):
        mine = seen[seen[:, 0] == i]
        color = read_color(images / name)
        column, row = np.rint(features.pixels[features.firsts[i] + mine[:, 1]]).astype(int).T
        inside = np.clip(row, 0, color.shape[0] - 1), np.clip(column, 0, color.shape[1] - 1)
        np.add.at(sums, mine[:, 2], color[inside].astype(float))
    views = np.maximum(np.bincount(seen[:, 2], minlength=count), 1)
    return np.rint(sums / views[:, None]).astype(np.uint8)
