"""RGB-D frames without poses to a coloured mesh: `reconstruct`."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.checks import check_count, check_positive, check_progress
from ...core.devices import resolve_device
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, in_columns
from ...core.timing import Clock, check_clock
from ...core.wording import format_bounds
from ...files.frames.frames import DEPTH_MAX, READ_AHEAD, FrameSource, can_read, check_frames
from ...files.frames.rgbd_sources import RGBDSource
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_summary import describe_mesh
from ...registration.trajectories.trajectory_error import TrajectoryError
from ..slam.focal_check import FocalCheck, check_focal
from ..slam.looped_model import SlamAccount, model_by_slam
from ..slam.paths import error_against_truth
from ..slam.sizes import check_sizes
from ..slam.tracking import VOXEL_SIZE
from .fragment_model import FragmentOptions, FragmentsAccount, model_by_fragments, settings_for

EMPTY = "the mesh is empty: no voxel was seen often enough; use more frames"


@dataclasses.dataclass(frozen=True, eq=False)
class ReconstructionResult(Assessed):
    """A mesh of frames whose poses nobody knew, and how it came about.

    `print(result)` shows its figures, `result.reliable` whether its checks passed.

    Attributes:
        mesh: The surface; empty where nothing was seen often enough.
        account: What became of the frames: a SlamAccount (`path`, `loops`, ...), or by fragments a FragmentsAccount.
        error: ATE and RPE of the path, aligned by a rigid motion, where the frames came with true poses.
        focal: Whether another focal length fits the frames better; None where the camera turned too little to tell, or
            the frames came one after another and are gone.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> v, u = np.mgrid[:48, :64]
        >>> depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
        >>> result = loom.reconstruct(loom.frames_from([(None, depth)] * 2, camera), voxel_size=0.05)
        >>> result.method, len(result.trajectory), result.account.loops, result.reliable
        ('slam', 2, (), True)
    """

    mesh: TriangleMesh
    account: SlamAccount | FragmentsAccount
    error: TrajectoryError | None
    focal: FocalCheck | None

    def __str__(self) -> str:
        return in_columns(self.fields())

    @property
    def method(self) -> str:
        """How it was made: "slam" or "fragments"."""
        return "slam" if isinstance(self.account, SlamAccount) else "fragments"

    @property
    def trajectory(self) -> Trajectory:
        """The poses of the frames that have one, T_world_camera, in the frame of the mesh; ids hold their numbers."""
        return self.account.trajectory

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy; empty if the result is reliable."""
        model = self.account.warnings or (() if len(self.mesh) else (EMPTY,))
        return (*model, *(() if self.focal is None else self.focal.warnings))

    def to_dict(self) -> dict[str, Any]:
        """The figures, in JSON's types; not those of `error`."""
        focal = None if self.focal is None else self.focal.to_dict()
        return {"method": self.method, **self.account.to_dict(), **describe_mesh(self.mesh).to_dict(), "focal": focal}

    def fields(self, frames_per_second: float | None = None) -> Fields:
        """The frames, the path or the fragments, and the mesh as labels and values."""
        account, size = self.account, describe_mesh(self.mesh).to_dict()
        told = account.fields(frames_per_second) if isinstance(account, SlamAccount) else account.fields()
        voxels = f"voxels of {account.voxel_size * 1000:.4g} mm"
        return [
            *told,
            ("mesh", f"{size['vertices']:,} vertices, {size['triangles']:,} triangles, {voxels}"),
            ("bounds", format_bounds(size["bounds"])),
        ]


def reconstruct(
    frames: FrameSource | RGBDSource,
    *,
    voxel_size: float | None = None,
    depth_max: float | None = None,
    fragments: FragmentOptions | None = None,
    device: Any = None,
    read_ahead: int = READ_AHEAD,
    progress: ReportProgress | None = None,
    clock: Clock | None = None,
) -> ReconstructionResult:
    """Make a mesh of the frames of a moving depth camera whose poses nobody knows, as `pointloom reconstruct` does.

    Each frame is held against the model of those before it, and where the camera comes back to a place the loop is
    closed (`loom.slam`); or, with `fragments`, runs of frames become fragments that are registered with each other
    from any pose, in stages whose files stay (`loom.reconstruction`).

    Args:
        frames: Of `open_frames`, `frames_from`, a camera, or anything with `intrinsic`, `depth_scale` and either `len`
            and `read(i)` or an iterator; in their order. Poses of theirs are kept as the truth, and not used.
        voxel_size: Edge of a voxel of the mesh [m]; None takes 0.02, by fragments what their configuration says.
        depth_max: Farther depth is left out [m]; None takes 4, by fragments what their configuration says.
        fragments: Work by fragments; None tracks.
        device: Where to compute; None for the CPU.
        read_ahead: Frames that are read while others are tracked; 0 reads each when its turn comes.
        progress: Called with the stage, how many of its steps are done, and how many there are (0: nobody knows).
        clock: Counts the seconds of the stages.

    Raises:
        TypeError: No frames of one camera, no options.
        ValueError: A length out of range, or no frame.
        FileError: No frame can be read, or a file of a stage cannot be written.
        DeviceError: No such device.

    Notes:
        The same bits from run to run, for any number of threads.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> v, u = np.mgrid[:48, :64]
        >>> depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
        >>> result = loom.reconstruct(loom.frames_from([(None, depth)] * 2, camera), voxel_size=0.05)
        >>> result.mesh.vertices.shape[1], result.trajectory
        (3, Trajectory(2 poses, ids))
    """
    check_frames("frames", frames)
    where, say, clock = resolve_device(device), check_progress(progress), check_clock(clock)
    ahead = check_count("read_ahead", read_ahead, minimum=0)
    edge = None if voxel_size is None else check_sizes(voxel_size)[0]
    farthest = None if depth_max is None else check_positive("depth_max", depth_max)
    shared: dict[str, Any] = {"device": where, "progress": say, "clock": clock}
    if fragments is None:
        sizes: dict[str, Any] = {"voxel_size": edge or VOXEL_SIZE, "depth_max": farthest or DEPTH_MAX}
        mesh, account = model_by_slam(frames, **sizes, read_ahead=ahead, **shared)
        error = account.path.error
    elif isinstance(fragments, FragmentOptions):
        settings = settings_for(fragments.config, edge, farthest)
        mesh, account = model_by_fragments(frames, dataclasses.replace(fragments, config=settings), **shared)
        error = error_against_truth(account.trajectory.poses, _true_poses(frames, account.trajectory))
    else:
        raise TypeError(f"fragments: expected FragmentOptions or None, got {type(fragments).__name__}")
    clock.restart()
    focal = None
    if hasattr(frames, "__len__"):  # which are there to be read again
        sure: dict[str, Any] = {"uncertain": account.uncertain, "depth_max": account.depth_max}
        focal = check_focal(frames, account.trajectory, **sure, device=where)
    clock.stop("camera")
    return ReconstructionResult(mesh, account, error, focal)


def _true_poses(frames: Any, trajectory: Trajectory) -> list[NDArray[np.float64] | None]:
    """The true pose of each frame of a trajectory, or None: those of a folder without decoding a picture."""
    assert trajectory.ids is not None
    numbers = trajectory.ids[:, 0].tolist()
    if not can_read(frames):
        return [None] * len(numbers)
    files = getattr(frames, "frames", None)
    return [(frames.read(number) if files is None else files[number]).T_world_camera for number in numbers]
