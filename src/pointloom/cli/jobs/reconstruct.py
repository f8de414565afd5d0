"""Reconstruction of a mesh from RGB-D frames without poses: `reconstruct_folder`."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.reports import Fields, with_warnings
from ...core.timing import Clock
from ...core.wording import plain
from ...rgbd.reconstruction.config import ReconstructionConfig
from ...rgbd.reconstruction.fragment_model import FragmentOptions, settings_for
from ...rgbd.reconstruction.frames_to_mesh import ReconstructionResult, reconstruct
from ...rgbd.reconstruction.job_files import run_folder
from ...rgbd.slam.looped_model import SlamAccount
from .frame_folder import FolderOptions, FrameFolder, FramesReport
from .model_outputs import ModelOutputs
from .track import rate_of


@dataclasses.dataclass(frozen=True)
class StageOptions:
    """Options of the method with fragments; `work` is the folder of stage files, by default beside the mesh.

    `config` is a settings file with the names of Open3D's system; `slac` corrects the camera's distortion.
    """

    work: FilePath | None = None
    resume: bool = False
    config: FilePath | None = None
    slac: bool = False

    def check(
        self, mesh: FilePath, voxel_size: float | None, depth_max: float | None, *, overwrite: bool
    ) -> FragmentOptions:
        """Checked options of `loom.rgbd.reconstruct`. Raises FileError or ValueError."""
        config = None if self.config is None else ReconstructionConfig.read(self.config)
        settings = settings_for(config, voxel_size, depth_max)
        folder = self.work or default_work_folder(mesh)
        folder = run_folder(folder).check(resume=self.resume, overwrite=overwrite)
        return FragmentOptions(folder, settings, self.resume, self.slac)


def default_work_folder(output: FilePath) -> Path:
    """Folder of the stages beside the mesh: mesh-fragments for mesh.ply."""
    return Path(output).with_name(f"{Path(output).stem}-fragments")


@dataclasses.dataclass(frozen=True, eq=False)
class ReconstructReport(FramesReport):
    result: ReconstructionResult

    @property
    def rate(self) -> float | None:
        """Tracked frames per second, without other work. None if not tracked."""
        account = self.result.account
        return rate_of(account.path, self.done.seconds) if isinstance(account, SlamAccount) else None

    def to_dict(self) -> dict[str, Any]:
        """Report in JSON types; "errors" has ATE and RPE if true poses exist."""
        figures = self.result.to_dict()
        focal = figures.pop("focal")
        report = {"command": self.done.command, "method": figures.pop("method"), **self.folder.to_dict()}
        for name, value in figures.items():
            report[name] = value
            if name == "path_length_m":
                report["frames_per_second"] = self.rate
        report |= {"errors": plain(self.result.error), "focal": focal}
        return report | self.ending_to_dict()

    def fields(self) -> Fields:
        fields = self.result.fields(self.rate)
        return [
            *self.folder.among(fields, before="path" if self.rate is not None else "fragments"),
            *(with_warnings(self.result.error.fields(), self.result.error) if self.result.error else []),
            *self.ending(),
        ]


def reconstruct_folder(
    folder: FilePath,
    outputs: ModelOutputs,
    *,
    options: FolderOptions | None = None,
    stages: StageOptions | None = None,
    voxel_size: float | None = None,
    depth_max: float | None = None,
    device: DeviceLike = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> ReconstructReport:
    """Reconstruct a mesh from a folder of frames. Outputs are checked first, and an empty mesh is not written.

    Poses in the folder are only used as truth. `stages` selects the method with fragments. None tracks each frame
    against the model with loop closure.
    """
    outputs.check(overwrite=overwrite)
    where, clock = resolve_device(device), Clock()
    sizes: dict[str, Any] = {"voxel_size": voxel_size, "depth_max": depth_max}
    fragments = None if stages is None else stages.check(outputs.mesh, **sizes, overwrite=overwrite)
    opened = FrameFolder.open(folder, options or FolderOptions())
    clock.stop("open")
    sizes = sizes if fragments is None else {}  # they are in its configuration
    result = reconstruct(opened.dataset, **sizes, fragments=fragments, device=where, progress=progress, clock=clock)
    files, path = [], result.trajectory
    if len(result.mesh):
        files += outputs.write_mesh(result.mesh, path.poses, overwrite=overwrite)
    if len(path):
        files += outputs.write_trajectory(path, overwrite=overwrite)
    clock.stop("write")
    return ReconstructReport(opened.done("reconstruct", clock, files, *result.warnings), opened, result)
