"""Monocular depth of one image or a folder to point clouds: `depth_of_images`."""

from __future__ import annotations

import math
import os
from collections import Counter
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.atomic import atomic_write, check_writable
from ...core.checks import check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.outputs import check_output
from ...core.progress import ReportProgress
from ...core.timing import Clock, peak_bytes
from ...io.images.image_formats import IMAGES
from ...io.models.colmap import read_colmap_model
from ...io.points.formats import WRITTEN
from ...io.points.ply import write_ply
from ...io.points.point_cloud import table_of, write_point_cloud
from ...pcd.cloud import PointCloud
from ...visualization.render.picture_files import check_picture, write_image
from ...visualization.render.render import render
from ...visualization.render.view import View
from ..sfm.image_folder import check_path
from .alignment import AlignmentError
from .estimation import ARBITRARY, DepthEstimate, estimate_depth
from .network import DepthModel
from .presets import NETWORK_PRESETS
from .report import DepthFailure, DepthReport, ImageDepth
from .settings import DepthSettings

REFERENCES = (".npy", ".png", ".txt", ".csv")  # with the image's name
SHOWN_SIDE = 1280  # [px] longer side of the rendered cloud
VIEW_ANGLES = math.radians(14), math.radians(9)  # viewpoint right of and above the camera


@dataclass(frozen=True)
class DepthOutputs:
    """Output files of `depth_of_images`.

    Attributes:
        cloud: The cloud. For a folder of images, a folder for clouds NAME.ply.
        depth_map: .npy file for the depth, float32 [h, w]. Not for a folder.
        picture: .png file with an image of the cloud. Not for a folder.
    """

    cloud: FilePath
    depth_map: FilePath | None = None
    picture: FilePath | None = None

    def __post_init__(self):
        for field in fields(self):
            if getattr(self, field.name) is not None or field.name == "cloud":
                check_path(field.name, getattr(self, field.name))

    def check(self, folder: Path | None, *, overwrite: bool) -> None:
        """Raise FileError for outputs of a single image if there is a folder, or that cannot be written."""
        for name, path in (("--depth-map", self.depth_map), ("--picture", self.picture)):
            if folder is not None and path is not None:
                raise FileError(path, f"{name} requires a single image", remedy="Give one image instead of the folder")
        if self.picture is not None:
            check_picture(self.picture, overwrite=overwrite)
        if self.depth_map is not None:
            if Path(self.depth_map).suffix.lower() != ".npy":
                reason = "depth maps are written as .npy"
                raise FileError(self.depth_map, reason, remedy="Give a name that ends in .npy")
            check_writable(self.depth_map, overwrite=overwrite)


def depth_of_images(
    source: FilePath,
    model: FilePath,
    outputs: DepthOutputs,
    settings: DepthSettings | None = None,
    *,
    device: DeviceLike = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> DepthReport:
    """Estimate the depth of an image, or of all in a folder, and write clouds, as `pointloom depth` does.

    Args:
        source: A PNG or JPEG file, or a folder of such.
        model: The .onnx file.
        outputs: Output files.
        settings: Network preset, camera, known depth; None: defaults.
        device: As of `estimate_depth`. Also for the clouds.
        overwrite: Replace existing outputs.
        progress: Called with (stage, steps done, steps in all).

    Returns:
        A report with `warnings`. Nothing is written for images whose references do not fit the map.

    Raises:
        TypeError, ValueError: An argument out of range. As `estimate_depth`.
        FileError: An unreadable input or model, or an output that cannot be written. For a folder, if all fail.
        DeviceError: As `estimate_depth`.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.depth.job import DepthOutputs, depth_of_images
        >>> depth_of_images("photo.jpg", "net.onnx", DepthOutputs("cloud.mp3"))
        Traceback (most recent call last):
        pointloom.core.errors.FileError: cloud.mp3: clouds are not written to .mp3. Give a name that ends in one of ...
    """
    settings = _checked(settings)
    report, clock = check_progress(progress), Clock()
    source_path = check_path("source", source)
    folder = source_path if source_path.is_dir() else None
    jobs = _jobs(source_path, Path(outputs.cloud), folder, overwrite)
    outputs.check(folder, overwrite=overwrite)
    where = resolve_device(device)
    options = settings.of_each_image()
    network = DepthModel(check_path("model", model), settings.preset, device=device)
    clock.stop("open")
    references = _AlignTo(settings.align, jobs, is_folder=folder is not None)
    images, failures = [], []
    first: Exception | None = None
    for done, (path, target) in enumerate(jobs):
        if folder is not None:
            report("images", done, len(jobs))
        try:
            estimate = estimate_depth(path, network, align=references(path), progress=report, **options)
            clock.stop("depth")
            cloud = estimate.to_point_cloud(keep_edges=settings.keep_edges, device=where)
            clock.stop("cloud")
            files = _write(outputs, target, estimate, cloud, clock, overwrite=overwrite)
            images.append(ImageDepth.of(estimate, os.fspath(path), len(cloud), files))
        except AlignmentError as error:
            clock.stop("depth")
            failures.append(DepthFailure(os.fspath(path), str(error), refused=True))
        except (FileError, ValueError) as error:
            if folder is None:
                raise
            failures.append(DepthFailure(os.fspath(path), str(error), refused=False))
            first = first or error
    if first is not None and len(images) == 0 and not any(failure.refused for failure in failures):
        raise first
    if folder is not None:
        report("images", len(jobs), len(jobs))
    license, provider = NETWORK_PRESETS[network.preset].license, network.provider
    run = network.path, network.preset, license, provider, str(where), tuple(images), tuple(failures)
    return DepthReport(os.fspath(source), folder is not None, *run, clock.seconds, peak_bytes(), network.notes)


def _checked(settings: Any) -> DepthSettings:
    settings = DepthSettings() if settings is None else settings
    if not isinstance(settings, DepthSettings):
        raise TypeError(f"settings: expected DepthSettings, got {type(settings).__name__}")
    return settings


def _jobs(source: Path, output: Path, folder: Path | None, overwrite: bool) -> list[tuple[Path, Path]]:
    if folder is None:
        check_output(output, WRITTEN, what="clouds", overwrite=overwrite)
        return [(source, output)]
    images = sorted(path for path in folder.iterdir() if path.suffix.lower() in IMAGES and path.is_file())
    if not images:
        raise FileError(folder, f"contains no images ({' '.join(IMAGES)})", remedy="Give another folder")
    if output.suffix.lower() in WRITTEN:
        raise FileError(
            output, "is a single cloud, but the source is a folder of images", remedy="Give the name of a folder"
        )
    jobs = [(path, output / f"{path.stem}.ply") for path in images]
    counts = Counter(target.name for _, target in jobs)
    for path, target in jobs:
        if counts[target.name] > 1:
            raise FileError(
                path, f"another image would also be written to {target.name}", remedy="Rename one of the images"
            )
    try:
        output.mkdir(exist_ok=True)
    except OSError as error:
        raise FileError(
            output, f"cannot be created: {error.strerror or error}", remedy="Create its parent folder first"
        ) from error
    for _, target in jobs:
        check_writable(target, overwrite=overwrite)
    return jobs


class _AlignTo:
    """References of each image: the given ones, or for a folder files by image name, or a COLMAP model, read once."""

    def __init__(self, align: FilePath | None, jobs: list[tuple[Path, Path]], *, is_folder: bool):
        self._same: Any = align
        self._folder = Path(align) if align is not None and is_folder and Path(align).is_dir() else None
        if self._folder is not None and not any(self._own(picture) for picture, _ in jobs):
            self._same, self._folder = read_colmap_model(self._folder), None

    def __call__(self, picture: Path) -> Any:
        if self._folder is None:
            return self._same
        if own := self._own(picture):
            return own
        names = " or ".join(picture.stem + suffix for suffix in REFERENCES)
        raise FileError(self._folder, f"contains no {names}", remedy="Each image needs its own file")

    def _own(self, picture: Path) -> Path | None:
        assert self._folder is not None
        paths = (self._folder / f"{picture.stem}{suffix}" for suffix in REFERENCES)
        return next((path for path in paths if path.exists()), None)


def _write(
    outputs: DepthOutputs, target: Path, estimate: DepthEstimate, cloud: PointCloud, clock: Clock, *, overwrite: bool
) -> tuple[str, ...]:
    """Write the cloud, and for a single image its depth and an image of the cloud. Returns the written files."""
    files = []
    if len(cloud):
        if target.suffix.lower() == ".ply":
            write_ply(target, table_of(cloud), overwrite=overwrite, comments=[_unit_comment(estimate)])
        else:
            write_point_cloud(target, cloud, overwrite=overwrite)
        files.append(os.fspath(target))
    if outputs.depth_map is not None:
        with atomic_write(outputs.depth_map, overwrite=overwrite) as file:
            np.save(file, estimate.depth)
        files.append(os.fspath(outputs.depth_map))
    clock.stop("write")
    if outputs.picture is not None and len(cloud):
        distance = float(np.median(estimate.depth[estimate.depth > 0]))
        write_image(outputs.picture, render(cloud, oblique_view(estimate.intrinsic, distance)), overwrite=overwrite)
        files.append(os.fspath(outputs.picture))
        clock.stop("picture")
    return tuple(files)


def _unit_comment(estimate: DepthEstimate) -> str:
    if estimate.unit == ARBITRARY:
        return "pointloom depth: units arbitrary, the nearest point at depth 1; align to get meters"
    if estimate.unit == "m":
        return "pointloom depth: meters"
    return "pointloom depth: in the unit of the sparse model"


def oblique_view(intrinsic: PinholeCameraIntrinsic, distance: float) -> View:
    """The camera's view from slightly right and above, rotated about a point at this distance."""
    camera = intrinsic.scaled(min(1.0, SHOWN_SIDE / max(intrinsic.width, intrinsic.height)))
    yaw, pitch = VIEW_ANGLES
    back = _rotation(1, -yaw) @ _rotation(0, -pitch)
    T_world_camera = np.eye(4)
    T_world_camera[:3, :3] = back
    T_world_camera[:3, 3] = np.array([0, 0, distance]) - back @ np.array([0, 0, 1.1 * distance])
    return View(camera, T_world_camera)


def _rotation(axis: int, angle: float) -> NDArray[np.float64]:
    """Rotation about x (0) or y (1)."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]] if axis == 0 else [[c, 0, s], [0, 1, 0], [-s, 0, c]])
