"""The complete reconstruction system as one job."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from ...core import observers
from ...core.checks import check_list, check_progress, shown
from ...core.devices import DeviceLike
from ...core.errors import FilePath
from ...core.paths import os_errors, refuse_link
from ...core.progress import ReportProgress
from ...core.timing import Clock, peak_bytes
from ...core.work_folder import RunFolder
from ...io.frames.datasets import open_frames
from ...io.frames.frames import FrameSource, image_warnings, source_warnings
from ...io.frames.recordings import record_frames
from ...io.frames.rgbd_sources import RGBDSource
from .config import ReconstructionConfig
from .fragments import make_fragments
from .job_files import CONFIG_FILE, JobFiles, run_folder
from .nonrigid import refine_with_slac, slac_params
from .placement import register_fragments
from .refinement import refine_registration
from .report import Cost, SystemReport, report_of
from .scene import integrate_scene

RECORDING = "frames"
OPTIONAL_STAGES = ("refine", "slac", "integrate")


def run_reconstruction_system(
    source: FrameSource | RGBDSource,
    config: ReconstructionConfig | None = None,
    folder: FilePath = "reconstruction",
    *,
    resume: bool = False,
    stages: Sequence[str] = ("refine", "integrate"),
    device: DeviceLike = None,
    progress: ReportProgress | None = None,
) -> SystemReport:
    """Reconstruct a mesh and the camera trajectory from RGB-D frames without poses.

    The stages make fragments, register them, optionally refine the registration and the distortion of the camera, and
    integrate the frames into a volume. Each writes its result to the folder.

    Args:
        source: Frames of one camera with random access: `open_frames`, `open_dataset`, `room_sequence`. A stream (any
            other `RGBDSource`) is first recorded to `frames/` in the job's folder.
        config: The configuration; None: the defaults.
        folder: Job folder; created if missing; earlier results are replaced. One run uses it at a time.
        resume: Keep valid results of an earlier run. An interruption loses at most one fragment. A recording is reused.
        stages: Optional stages. "refine": the registration by ICP; "slac": estimate the distortion of the camera, and
            undistort the frames; "integrate": write the mesh and the trajectory. Without the last, the run ends with
            the poses of the fragments.
        device: Compute device; None: the CPU.
        progress: Called with (stage, steps done, steps in all or 0 if unknown).

    Returns:
        A report: frames inside and outside the model with reasons, fragments, files, and warnings if unreliable.
        Without connected frames no model is written.

    Raises:
        TypeError, ValueError: An argument or a field of the configuration has another type or is out of range.
        FileError: The folder contains files of another program or links, or is in use. A file cannot be written, or a
            recording exists without `resume`. Finished stages stay.
        DeviceError: No such device.

    Notes:
        Bitwise reproducible, resumed or not, for any number of threads.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.datasets.scenes.room import room_sequence
        >>> frames = room_sequence(300, width=80, height=60)
        >>> class First:
        ...     intrinsic, depth_scale, read = frames.intrinsic, frames.depth_scale, frames.read
        ...     def __len__(self): return 8
        >>> sizes = {"n_frames_per_fragment": 4, "tsdf_voxel_size": 0.02, "depth_max": 4.0}
        >>> report = loom.rgbd.run_reconstruction_system(First(), loom.rgbd.ReconstructionConfig(**sizes), "job")
        >>> report.used, report.lost, report.trajectory_error["rmse"] < 0.02
        (8, (), True)
    """
    config = ReconstructionConfig() if config is None else config
    if not isinstance(config, ReconstructionConfig):
        raise TypeError(f"config: expected a ReconstructionConfig, got {type(config).__name__}")
    report_progress, selected = check_progress(progress), _check_stages(stages)
    if "slac" in selected:
        slac_params(config)  # fail before the work
    run = run_folder(folder)
    with os_errors(run.path, "created"):
        run.path.parent.mkdir(parents=True, exist_ok=True)
    run.check(resume=True, overwrite=True)
    with run.opened():
        return _run(source, config, run, selected, resume=resume, device=device, progress=report_progress)


def _run(
    source: Any, config: ReconstructionConfig, run: RunFolder, selected: Sequence[str], **options: Any
) -> SystemReport:
    folder, clock = run.path, Clock()
    job = JobFiles.make(folder, config)
    config.write(run.file(CONFIG_FILE))
    frames = _readable(source, job, options["resume"], options["progress"])
    clock.stop("record")
    observers.report("stage", name="fragments")
    fragment_set = make_fragments(frames, config, folder, **options)
    clock.stop("fragments")
    placement, bent, scene = None, None, None
    if fragment_set.fragments:
        observers.report("stage", name="register")
        placement = register_fragments(config, folder, **options)
        clock.stop("register")
        if "refine" in selected:
            placement = refine_registration(config, folder, **options)
            clock.stop("refine")
        if "slac" in selected:
            bent = refine_with_slac(config, folder, **options)
            placement = bent.placement
            clock.stop("slac")
        if "integrate" in selected:
            observers.report("stage", name="integrate")
            scene = integrate_scene(frames, config, folder, slac="slac" in selected, **options)
            clock.stop("integrate")
    figures, cost = None if bent is None else bent.figures, Cost(clock.seconds, peak_bytes())
    parts = fragment_set, placement, scene
    warnings = (*source_warnings(source), *image_warnings(frames))
    return report_of(os.fspath(folder), len(frames), *parts, slac=figures, cost=cost, source_warnings=warnings)


def _check_stages(stages: Any) -> list[str]:
    selected = check_list("stages", stages, "names")
    if unknown := [name for name in selected if not isinstance(name, str) or name not in OPTIONAL_STAGES]:
        raise ValueError(f"stages: expected some of {', '.join(OPTIONAL_STAGES)}, got {shown(unknown[0])}")
    return selected


def _readable(source: Any, job: JobFiles, resume: bool, report_progress: ReportProgress) -> FrameSource:
    if hasattr(source, "read") and hasattr(source, "__len__"):
        return source
    if not isinstance(source, RGBDSource):
        raise TypeError(f"source: expected frames of an RGBDSource, got {type(source).__name__}")
    folder = refuse_link(job.root / RECORDING)
    if not (resume and folder.exists()):
        record_frames(source, folder, progress=report_progress)
    return open_frames(folder)
