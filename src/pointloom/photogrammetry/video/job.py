"""The complete reconstruction pipeline from a video or a folder of images to a mesh."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from ...cameras.image_names import ImageNames
from ...core.atomic import atomic_write
from ...core.attribute_hints import nearest_name
from ...core.checks import check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.json_files import read_json_object
from ...core.progress import ReportProgress
from ...core.stages import Chain, StageResult
from ...core.timing import peak_bytes_of_all
from ...core.up_axis import UP, check_up
from ...core.wording import few_of, json_text
from ...core.work_folder import RunFolder
from ...io.images.image_files import read_image_header
from ...io.points.point_cloud import read_point_cloud
from ...meshing.mesh.mesh_files import read_triangle_mesh
from ...registration.trajectories.up_direction import up_of_poses
from ..sfm.image_folder import check_path
from ..sfm.image_positions import read_image_positions
from . import motion, surface
from .chain import KNOWN_STAGES, STAGES, Given, run_to, settings_of_stages
from .ground_control import ControlMark, GroundControl
from .motion import IMAGES, image_names
from .outputs import VideoOutputs
from .result import StageReport, VideoFigures, VideoResult
from .settings import VideoSettings
from .units import NONE, fit_as_given, fit_units


def check_control(control: GroundControl | None, frames: StageResult, source: FilePath) -> None:
    if control is None:
        return
    source_path = Path(source)
    offered = sorted(path.name for path in source_path.iterdir()) if source_path.is_dir() else []
    names = image_names(frames)
    images = ImageNames(names)
    marked = {k for name in {mark.image for mark in control.marks} for k in images.matching(name)}
    headers = {names[k]: read_image_header(frames.folder / IMAGES / names[k]) for k in sorted(marked)}
    sizes = {name: (header.width, header.height) for name, header in headers.items()}
    check_marks(control, names, sizes, offered)


def check_marks(
    control: GroundControl, names: Sequence[str], sizes: Mapping[str, tuple[int, int]], offered: Sequence[str] = ()
) -> None:
    images, others = ImageNames(names), ImageNames(offered)
    for mark in control.marks:
        meant = images.matching(mark.image)
        if not meant and others.matching(mark.image):
            continue
        if len(meant) != 1:
            what = "matches no image" if not meant else f"matches {len(meant)} images"
            near = nearest_name(mark.image, names).removeprefix("; ")
            some = few_of(names, 3)
            raise _error(control, mark, f"{mark.image!r} {what}", f"{near} " * bool(near) + f"The images are {some}")
        width, height = sizes[names[meant[0]]]
        column, row = (mark.pixel + 0.5).tolist()
        if not (0 <= column <= width and 0 <= row <= height):
            reason = f"{mark.point!r} is marked at {column:g}, {row:g}, outside of {mark.image} of {width} x {height}"
            remedy = "Give column, row of the image as it was taken: not rotated, not resized"
            raise _error(control, mark, reason, remedy)


def _error(control: GroundControl, mark: ControlMark, reason: str, remedy: str) -> FileError:
    path, _, line = mark.where.rpartition(" (")
    return FileError(path or control.path, reason, where=line.rstrip(")") if path else "", remedy=remedy)


MARKER, REPORT = "video.json", "report.json"


def reconstruct_video(
    source: FilePath,
    settings: VideoSettings | None = None,
    *,
    outputs: VideoOutputs | None = None,
    work: FilePath | None = None,
    resume: bool = False,
    device: DeviceLike = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> VideoResult:
    """Reconstruct a mesh from a video or a folder of images, as `pointloom video` does.

    Stages: sharp frames (`frames`), `features` and `matches`, poses (`model`), undistorted images (`undistorted`),
    multi-view stereo (`depth`), fused points (`fused`) and surface (`mesh`).

    Args:
        source: A video for ffmpeg, or a folder of images. A folder with `settings.cameras`.
        settings: Number and size of images, unit, camera; None: defaults.
        outputs: Additional output files, checked before the work; None: none.
        work: Folder of stage files and report.json, about 30 MB per image of 960 x 720 pixels. None: `room-video`
            beside the mesh room.ply, or named after the source in the current folder without an output. It is kept,
            and a later call with the same name reuses its valid results.
        resume: Reuse valid results of an earlier run in `work`. Without `work` they are always reused.
        device: Compute device.
        overwrite: Replace existing outputs, and an earlier run in `work`.
        progress: Called with (stage, steps done, steps in all or 0 if unknown).

    Returns:
        Mesh, points and model in one frame, with the figures of all stages. `warnings` gives the reasons if the result
        is unreliable or missing: insufficient images are a result, not an error.

    Raises:
        TypeError, ValueError: An argument out of range, or a missing image in `known`.
        FileError: An invalid source, an output that cannot be written, maps without georeference, or an earlier run in
            the work folder without `resume`. Finished stages are kept.
        DeviceError: No such device.

    Notes:
        Bitwise reproducible, resumed or not. Requires `pip install "pointloom[sfm]"`.

    Example:
        >>> import pointloom as loom
        >>> loom.photogrammetry.reconstruct_video("no such film.mp4", loom.photogrammetry.VideoSettings(max_frames=60))
        Traceback (most recent call last):
        pointloom.core.errors.FileError: no such film.mp4: does not exist. Give a video, or a folder of images
    """
    settings, outputs = _checked(settings, outputs)
    outputs.check(overwrite=overwrite)
    where, report = resolve_device(device), check_progress(progress)
    content = motion.digest_of_source(source)
    settings = _with_image_positions(settings, source)
    outputs.check_units(settings.units)
    resume = resume or work is None
    work = default_work_folder(source, outputs) if work is None else work
    run = RunFolder(check_path("work", work), MARKER, _is_marker)
    run.check(resume=resume, overwrite=overwrite)
    with run.opened() as root:
        _write_json(run.file(MARKER), {"command": "video", "source": os.fspath(source)})
        (root / REPORT).unlink(missing_ok=True)  # from an earlier run, outdated
        chain = Chain(root, tuple(STAGES), resume=resume, progress=report)
        given = settings_of_stages(source, content, settings, where)
        result = _run(chain, given, settings, outputs, source=os.fspath(source), work=work, device=where)
        if result.mesh is not None:
            training = outputs.write_training(result, chain.made["frames"].folder, overwrite=overwrite)
            result = replace(result, files=outputs.write(result, overwrite=overwrite), training=training)
        result = replace(result, peak_bytes=peak_bytes_of_all())
        _write_json(run.file(REPORT), result.to_dict())
    return result


def default_work_folder(source: FilePath, outputs: VideoOutputs) -> Path:
    """Folder of the stages beside the first output: room-video for room.ply. In the current folder without outputs."""
    base = Path(outputs.mesh or outputs.cloud or check_path("source", source).resolve().name or "images")
    return base.with_name(f"{base.stem}-video")


def _checked(settings: Any, outputs: Any) -> tuple[VideoSettings, VideoOutputs]:
    settings = VideoSettings() if settings is None else settings
    if not isinstance(settings, VideoSettings):
        raise TypeError(f"settings: expected VideoSettings, got {type(settings).__name__}")
    outputs = VideoOutputs() if outputs is None else outputs
    if not isinstance(outputs, VideoOutputs):
        raise TypeError(f"outputs: expected VideoOutputs, got {type(outputs).__name__}")
    return settings, outputs


def _with_image_positions(settings: VideoSettings, source: FilePath) -> VideoSettings:
    units, path = settings.units, Path(source)
    if settings.cameras is not None and units.align is None:
        return replace(settings, units=replace(units, align=NONE))
    if units.places is None and path.is_dir() and units.file is None and units.align != NONE:
        return replace(settings, units=replace(units, places=read_image_positions(path)))
    return settings


def _run(
    chain: Chain,
    given: Mapping[str, Given],
    settings: VideoSettings,
    outputs: VideoOutputs,
    *,
    source: str,
    work: FilePath,
    device: DeviceLike,
) -> VideoResult:
    stages = (STAGES if settings.cameras is None else KNOWN_STAGES).values()
    frames = run_to("frames", chain, given, stages)
    settings.units.check_names(motion.image_names(frames))
    check_control(settings.units.ground, frames, source)
    model_stage = run_to("model", chain, given, stages)
    mesh = cloud = model = fit = None
    figures = VideoFigures.of_stages(chain.made)
    reasons = figures.model_warnings()
    if not figures.is_hopeless:
        model = motion.read_model(model_stage)
        fit = fit_units(settings.units, model)  # fail before the long work
        fit = fit if settings.cameras is None else fit_as_given(fit)
        reasons += fit.warnings
        model = model.transform(fit.T_world_model)
        outputs.check_fit(fit, model.points)
        surface_made = run_to("mesh", chain, given, stages)
        figures = VideoFigures.of_stages(chain.made)
        reasons += figures.depth_warnings()
        cloud = read_point_cloud(chain.made["fused"].folder / surface.CLOUD, device=device).transform(fit.T_world_model)
        if figures.triangle_count:
            mesh = read_triangle_mesh(surface_made.folder / surface.MESH, device=device)
            mesh.up = UP if fit.is_upright else up_of_poses(model.T_world_camera)
            mesh.up = mesh.up if outputs.up is None else check_up(outputs.up)
        else:
            reasons.append("the mesh is empty, and nothing was written; take more images")
    return VideoResult(
        source=source,
        device=str(device),
        mesh=mesh,
        cloud=cloud,
        model=model,
        fit=fit,
        figures=figures,
        warnings=tuple(reasons),
        stages={name: _report_of(chain.made.get(name)) for name in STAGES},
        files=(),
        work=os.fspath(work),
        peak_bytes=0,
    )


def _report_of(made: StageResult | None) -> StageReport | None:
    return None if made is None else StageReport(made.is_reused, made.cost, made.report, made.outdated)


def _is_marker(path: Path) -> bool:
    content = read_json_object(path)
    return content.keys() == {"command", "source"} and content["command"] == "video"


def _write_json(path: Path, content: dict[str, Any]) -> None:
    with atomic_write(path) as file:
        file.write(json_text(content).encode() + b"\n")
