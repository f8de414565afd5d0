"""A folder of RGB-D frames without poses to a mesh file: `reconstruct_folder`."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

from ...core.devices import resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.reports import Fields
from ...core.timing import Clock
from ...core.wording import plain
from ...core.work_folder import check_work_folder
from ...rgbd.reconstruction.config import ReconstructionConfig
from ...rgbd.reconstruction.fragment_model import FragmentOptions, settings_for
from ...rgbd.reconstruction.frames_to_mesh import ReconstructionResult, reconstruct
from ...rgbd.reconstruction.job import CONFIG_FILE
from ...rgbd.slam.looped_model import SlamAccount
from .frame_folder import FolderOptions, FrameFolder, FramesReport
from .model_outputs import ModelOutputs
from .track import rate_of


@dataclasses.dataclass(frozen=True)
class StageOptions:
    """How the command works by fragments.

    Attributes:
        work: Folder of the stages' files; None for one beside the mesh.
        resume: Keep what an earlier run left there.
        config: A file of settings with the names of Open3D's system; None for the usual ones.
        slac: Find the camera's distortion too, and take it out of the frames.
    """

    work: FilePath | None = None
    resume: bool = False
    config: FilePath | None = None
    slac: bool = False

    def check(
        self, mesh: FilePath, voxel_size: float | None, depth_max: float | None, *, overwrite: bool
    ) -> FragmentOptions:
        """The options of `loom.reconstruct`, once the configuration is read and the folder can be written.

        Raises:
            FileError: A configuration that cannot be read, or a folder that holds other files.
            ValueError: Lengths that do not go together.
        """
        config = None if self.config is None else ReconstructionConfig.read(self.config)
        settings = settings_for(config, voxel_size, depth_max)
        folder = self.work or default_work_folder(mesh)
        folder = check_work_folder(folder, marker=CONFIG_FILE, resume=self.resume, overwrite=overwrite)
        return FragmentOptions(folder, settings, self.resume, self.slac)


def default_work_folder(output: FilePath) -> Path:
    """The folder of the stages beside the mesh: mesh.ply has mesh-fragments."""
    return Path(output).with_name(f"{Path(output).stem}-fragments")


@dataclasses.dataclass(frozen=True, eq=False)
class ReconstructReport(FramesReport):
    """What `pointloom reconstruct` did; `result` is what was made of the frames."""

    result: ReconstructionResult

    @property
    def rate(self) -> float | None:
        """Frames a second of tracking alone, where they were tracked."""
        account = self.result.account
        return rate_of(account.path, self.done.seconds) if isinstance(account, SlamAccount) else None

    def to_dict(self) -> dict[str, Any]:
        """The report, in JSON's types; "errors" holds ATE and RPE where true poses lie beside the frames."""
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
        """The report as labels and values for the terminal."""
        told = self.result.fields(self.rate)
        return [
            *self.folder.among(told, before="path" if self.rate is not None else "fragments"),
            *(self.result.error.fields() if self.result.error else []),
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
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> ReconstructReport:
    """Make a mesh of a folder of frames whose poses nobody knows; outputs are checked before the work.

    Args:
        folder: As `open_frames` takes it; poses that lie there are taken as the truth, and not used.
        outputs: What is written. An empty mesh is not.
        options: Which frames of the folder; None for all, as they lie there.
        stages: Work by fragments; None tracks each frame against the model, and closes loops.
        voxel_size, depth_max, device, progress: As `loom.reconstruct`.
        overwrite: Replace outputs that exist.

    Raises:
        FileError: A file that cannot be read, or an output that cannot be written.
        ValueError: A length out of range.
        DeviceError: No such device.
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
    return ReconstructReport(
        opened.done("reconstruct", clock, files, *result.warnings, *opened.warnings), opened, result
    )
