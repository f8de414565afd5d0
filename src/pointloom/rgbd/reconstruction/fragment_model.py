"""Reconstruction by fragments with files for each stage: `model_by_fragments`."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np

from ...cameras.depth_range import DEPTH_MAX
from ...cameras.trajectory import Trajectory, read_trajectory
from ...core.devices import DeviceLike
from ...core.errors import FilePath
from ...core.paths import path_of
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, quality
from ...core.timing import Clock
from ...io.frames.frames import FrameSource
from ...io.frames.rgbd_sources import RGBDSource
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import read_triangle_mesh
from .config import ReconstructionConfig
from .job import OPTIONAL_STAGES, run_reconstruction_system
from .job_files import JobFiles
from .report import SystemReport

# Entries of the system's report in the account. The rest is about the mesh and the run.
_REPORTED = ("frames", "used", "lost", "fragments", "edges", "loops", "slac", "resumed")


@dataclasses.dataclass(frozen=True)
class FragmentOptions:
    """Options of `loom.rgbd.reconstruct` by fragments, which are registered globally.

    Attributes:
        folder: Folder of the stage files; created if missing; earlier results are replaced.
        config: Settings of the stages; None: the defaults with depth up to 4 m.
        resume: Keep valid results of an earlier run.
        slac: Estimate and remove the camera's depth distortion.

    Raises:
        TypeError: Not a path, or not a configuration.

    Example:
        >>> import pointloom as loom
        >>> options = loom.rgbd.FragmentOptions("stages", resume=True)
        >>> options.config is None, options.slac
        (True, False)
    """

    folder: FilePath
    config: ReconstructionConfig | None = None
    resume: bool = False
    slac: bool = False

    def __post_init__(self):
        path_of(self.folder, "folder")
        if self.config is not None and not isinstance(self.config, ReconstructionConfig):
            raise TypeError(f"config: expected a ReconstructionConfig or None, got {type(self.config).__name__}")


@dataclasses.dataclass(frozen=True, eq=False)
class FragmentsAccount(Assessed):
    """Result of a reconstruction by fragments.

    Attributes:
        trajectory: Poses of the frames in the model. Ids are frame numbers.
        system: The report of `run_reconstruction_system`.
        device: Compute device.
        voxel_size: Voxel edge of the mesh [m].
        depth_max: Maximum depth [m].
        folder: Folder of the stage files.
        uncertain: Always empty, since frames of a fragment overlap.
    """

    trajectory: Trajectory
    system: SystemReport
    device: str
    voxel_size: float
    depth_max: float
    folder: str
    uncertain: tuple[int, ...] = ()

    @property
    def warnings(self) -> tuple[str, ...]:
        return self.system.warnings

    def to_dict(self) -> dict[str, Any]:
        values, sizes = self.system.to_dict(), {"voxel_size": self.voxel_size, "depth_max": self.depth_max}
        return {
            "device": self.device,
            **{name: values[name] for name in _REPORTED},
            **sizes,
            "work": self.folder,
            **quality(self),
        }

    def fields(self) -> Fields:
        return [*self.system.parts(f", on {self.device}"), ("stages", self.folder)]


def settings_for(
    config: ReconstructionConfig | None, voxel_size: float | None, depth_max: float | None
) -> ReconstructionConfig:
    given = {"tsdf_voxel_size": voxel_size, "depth_max": depth_max}
    settings = ReconstructionConfig(depth_max=DEPTH_MAX) if config is None else config
    return dataclasses.replace(settings, **{name: value for name, value in given.items() if value is not None})


def model_by_fragments(
    frames: FrameSource | RGBDSource,
    options: FragmentOptions,
    *,
    device: DeviceLike,
    progress: ReportProgress,
    clock: Clock,
) -> tuple[TriangleMesh, FragmentsAccount]:
    settings, work = settings_for(options.config, None, None), Path(options.folder)
    stages = OPTIONAL_STAGES if options.slac else ("refine", "integrate")
    given: dict[str, Any] = {"resume": options.resume, "stages": stages, "device": device, "progress": progress}
    report = run_reconstruction_system(frames, settings, work, **given)
    clock.seconds |= report.seconds
    clock.restart()
    job = JobFiles.make(work, settings)
    mesh, path = TriangleMesh(device=device), Trajectory(np.empty((0, 4, 4)), ids=np.empty((0, 3), np.int64))
    for file in report.files:
        if Path(file) == job.scene_mesh:
            mesh = read_triangle_mesh(file, device=device)
        elif Path(file) == job.trajectory:
            path = read_trajectory(file)
    clock.stop("read")
    sizes = (settings.volume_voxel_size, settings.depth_max)
    return mesh, FragmentsAccount(path, report, str(device), *sizes, str(work))
