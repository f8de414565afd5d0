"""RGB-D frames without poses to a colored mesh: `reconstruct`."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.depth_range import DEPTH_MAX
from ...cameras.trajectory import Trajectory
from ...core.checks import check_count, check_positive, check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, in_columns, quality
from ...core.timing import Clock, check_clock
from ...core.wording import format_bounds
from ...io.frames.frames import READ_AHEAD, FrameSource, can_read, check_frames
from ...io.frames.rgbd_sources import RGBDSource
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_summary import describe_mesh
from ...registration.trajectories.trajectory_error import TrajectoryError
from ...registration.trajectories.up_direction import up_of_poses
from ..slam.camera_check import FocalCheck
from ..slam.focal_check import check_focal
from ..slam.looped_model import SlamAccount, model_by_slam
from ..slam.path_statistics import error_against_truth
from ..slam.tracking import VOXEL_SIZE
from ..slam.volume_sizes import check_sizes
from .fragment_model import FragmentOptions, FragmentsAccount, model_by_fragments, settings_for

EMPTY = "the mesh is empty: no voxel was seen often enough; use more frames"


@dataclasses.dataclass(frozen=True, eq=False)
class ReconstructionResult(Assessed):
    """Result of `reconstruct`.

    Attributes:
        mesh: The surface. Empty if nothing was seen often enough.
        account: A SlamAccount (`path`, `loops`, ...), or a FragmentsAccount.
        error: ATE and RPE after rigid alignment, if true poses are known.
        focal: Check of the camera. None with too little rotation, or if fragments are of a stream.
    """

    mesh: TriangleMesh
    account: SlamAccount | FragmentsAccount
    error: TrajectoryError | None
    focal: FocalCheck | None

    def __str__(self) -> str:
        return in_columns(self.fields())

    @property
    def method(self) -> str:
        """ "slam" or "fragments"."""
        return "slam" if isinstance(self.account, SlamAccount) else "fragments"

    @property
    def trajectory(self) -> Trajectory:
        """The poses as a Trajectory."""
        return self.account.trajectory

    @property
    def warnings(self) -> tuple[str, ...]:
        model = self.account.warnings or (() if len(self.mesh) else (EMPTY,))
        if self.focal is None or isinstance(self.account, SlamAccount):  # the path contains its warnings
            return model
        return (*model, *self.focal.warnings)

    def to_dict(self) -> dict[str, Any]:
        focal = None if self.focal is None else self.focal.to_dict()
        values = {"method": self.method, **self.account.to_dict(), **describe_mesh(self.mesh).to_dict(), "focal": focal}
        return values | quality(self)

    def fields(self, frames_per_second: float | None = None) -> Fields:
        account, size = self.account, describe_mesh(self.mesh).to_dict()
        fields = account.fields(frames_per_second) if isinstance(account, SlamAccount) else account.fields()
        voxels = f"voxels of {account.voxel_size * 1000:.4g} mm"
        return [
            *fields,
            ("mesh", f"{size['vertices']:,} vertices, {size['triangles']:,} triangles, {voxels}"),
            ("bounds", format_bounds(size["bounds"])),
        ]


def reconstruct(
    frames: FrameSource | RGBDSource,
    *,
    voxel_size: float | None = None,
    depth_max: float | None = None,
    fragments: FragmentOptions | None = None,
    device: DeviceLike = None,
    read_ahead: int = READ_AHEAD,
    progress: ReportProgress | None = None,
    clock: Clock | None = None,
) -> ReconstructionResult:
    """Reconstruct a mesh from RGB-D frames without poses, as `pointloom reconstruct` does.

    Frame-to-model tracking with loop closure (`loom.rgbd`); or, with `fragments`, registration of fragments in stages
    with files (`loom.rgbd`).

    Args:
        frames: From `open_frames`, `frames_from`, a camera, or any ordered source with `intrinsic`, `depth_scale` and
            either `len` and `read(i)` or an iterator. Their poses are only used as the truth.
        voxel_size: Voxel edge of the mesh [m]; None: 0.02, or the fragments configuration.
        depth_max: Maximum depth [m]; None: 4, or the fragments configuration.
        fragments: Options of the fragments method; None: tracking.
        device: Compute device; None: the CPU.
        read_ahead: Number of frames read ahead; 0: none.
        progress: Called with (stage, steps done, steps in all or 0 if unknown).
        clock: Measures the stages.

    Raises:
        TypeError, ValueError: Not frames of one camera, wrong options, a length out of range, or no frame.
        FileError: No frame can be read, or a file cannot be written.
        DeviceError: No such device.

    Notes:
        Bitwise reproducible for any number of threads.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> v, u = np.mgrid[:48, :64]
        >>> depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
        >>> result = loom.rgbd.reconstruct(loom.frames_from([(None, depth)] * 2, camera), voxel_size=0.05)
        >>> result.mesh.vertices.shape[1], result.trajectory
        (3, Trajectory(2 poses, ids))
    """
    check_frames("frames", frames)
    where, report_progress, clock = resolve_device(device), check_progress(progress), check_clock(clock)
    ahead = check_count("read_ahead", read_ahead, minimum=0)
    edge = None if voxel_size is None else check_sizes(voxel_size)[0]
    farthest = None if depth_max is None else check_positive("depth_max", depth_max)
    shared: dict[str, Any] = {"device": where, "progress": report_progress, "clock": clock}
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
    if len(account.trajectory):
        mesh.up = up_of_poses(account.trajectory.poses)
    clock.restart()
    focal = account.path.camera if isinstance(account, SlamAccount) else None
    if not isinstance(account, SlamAccount) and hasattr(frames, "__len__"):  # which are there to be read again
        sure: dict[str, Any] = {"uncertain": account.uncertain, "depth_max": account.depth_max}
        focal = check_focal(frames, account.trajectory, **sure, device=where)
    clock.stop("camera")
    return ReconstructionResult(mesh, account, error, focal)


def _true_poses(frames: object, trajectory: Trajectory) -> list[NDArray[np.float64] | None]:
    """The true pose of each trajectory frame, or None, without decoding images of a folder."""
    assert trajectory.ids is not None
    numbers = trajectory.ids[:, 0].tolist()
    if not can_read(frames):
        return [None] * len(numbers)
    files = getattr(frames, "frames", None)
    return [(frames.read(number) if files is None else files[number]).T_world_camera for number in numbers]
