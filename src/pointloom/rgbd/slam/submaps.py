"""Submaps: sequences of frames fused into separate volumes that can be moved rigidly."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...cameras.depth_range import DEPTH_MAX, DEPTH_SCALE
from ...cameras.images import integer_scale
from ...core.checks import check_count, check_fraction, check_list, check_numeric, check_positive, check_rigid
from ...core.devices import DeviceLike
from ...core.serialized import Serialized
from ...kernels.array_types import AnyArray
from ...kernels.linear_algebra import inv, matmul, norm
from ...meshing.volume.surface_weights import min_weight
from ...meshing.volume.tsdf import TSDFVolume
from ...pcd.cloud import PointCloud
from ...registration.rigid import invert_pose, make_pose, nearest_rotation, rotation_vector

Matrix = NDArray[np.float64]

SUBMAP_FRAMES = 100  # 3 s at 30 Hz, in which tracking drifts by millimeters
SHARED_FRACTION = 0.2  # fraction shared with the previous submap, which determines their relative pose
ROTATION_RADIUS = 1.0  # [m] radius at which rotations count as path


@dataclasses.dataclass(frozen=True, eq=False)
class Submap:
    """A volume of consecutive frames in the coordinates of its first camera, and its pose.

    Args:
        volume: A TSDFVolume in submap coordinates.
        T_world_submap: Pose from tracking, float64 [4, 4].
        frames: Frame numbers, ascending, int64 [n].
        T_submap_camera: Camera poses, float64 [n, 4, 4].
        follows: True if tracking was not lost since the previous submap.

    Raises:
        TypeError: Not a TSDFVolume, or not numbers.
        ValueError: Frames not ascending, a wrong number of poses, or a pose that is not rigid.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.slam.submaps import Submap
        >>> camera, pose = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5), np.eye(4)
        >>> volume = loom.TSDFVolume(voxel_size=0.1, color=False)
        >>> touched = volume.integrate(np.full((48, 64), 1000, np.uint16), camera, pose)
        >>> submap = Submap(volume, pose, [7], [pose])
        >>> submap.T_world_camera.shape, len(submap.cloud(0.2)) > 10
        ((1, 4, 4), True)
    """

    volume: TSDFVolume
    T_world_submap: Matrix
    frames: NDArray[np.int64]
    T_submap_camera: Matrix
    follows: bool = True

    def __post_init__(self):
        if not isinstance(self.volume, TSDFVolume):
            raise TypeError(f"volume: expected a TSDFVolume, got {type(self.volume).__name__}")
        frames = check_numeric("frames", self.frames)
        if frames.ndim != 1 or not len(frames) or frames.dtype.kind not in "iu" or (np.diff(frames) <= 0).any():
            raise ValueError("frames: expected at least one integer, in ascending order")
        given = check_list("T_submap_camera", self.T_submap_camera, "poses")
        if len(given) != len(frames):
            raise ValueError(f"T_submap_camera: expected {len(frames)} poses, got {len(given)}")
        poses = [_rigid(f"T_submap_camera[{i}]", T) for i, T in enumerate(given)]
        object.__setattr__(self, "T_world_submap", _rigid("T_world_submap", self.T_world_submap))
        object.__setattr__(self, "frames", frames.astype(np.int64))
        object.__setattr__(self, "T_submap_camera", np.array(poses))

    def __repr__(self) -> str:
        first, last = int(self.frames[0]), int(self.frames[-1])
        return f"Submap({len(self.frames)} frames {first}..{last}, {self.volume.block_count:,} blocks)"

    @property
    def T_world_camera(self) -> Matrix:
        """Camera poses from tracking, float64 [n, 4, 4]."""
        return matmul(self.T_world_submap, self.T_submap_camera)

    @property
    def weight_threshold(self) -> float:
        """Weight above which voxels count as surface."""
        return min_weight(self.volume.frame_count)

    def cloud(self, voxel_size: float) -> PointCloud:
        """The surface as points in submap coordinates, one per voxel, with normals and colors.

        Args:
            voxel_size: Voxel edge [m].

        Raises:
            TypeError, ValueError: Not a positive number.
        """
        check_positive("voxel_size", voxel_size)
        cloud = self.volume.extract_point_cloud(self.weight_threshold)
        return cloud.voxel_down_sample(voxel_size) if len(cloud) else cloud


def _rigid(name: str, pose: ArrayLike) -> Matrix:
    """A rigid pose with an exact rotation: files round to a few digits, and inverses use the transpose."""
    T = check_rigid(name, pose)
    return make_pose(nearest_rotation(T[:3, :3]), T[:3, 3])


def way_between(first: Matrix, second: Matrix) -> float:
    """Path length between two poses [m]. Rotations count at 1 m radius."""
    motion = matmul(invert_pose(first), second)
    return float(norm(motion[:3, 3]) + ROTATION_RADIUS * norm(rotation_vector(motion[:3, :3])))


class _Recording:
    def __init__(self, volume: TSDFVolume, T_world_submap: Matrix, follows: bool):
        self.volume, self.T_world_submap, self.follows = volume, T_world_submap, follows
        self.numbers: list[int] = []
        self.poses: list[Matrix] = []
        self.way = 0.0
        self.latest = T_world_submap

    def done(self) -> Submap:
        poses = matmul(invert_pose(self.T_world_submap), np.array(self.poses))
        return Submap(self.volume, self.T_world_submap, np.array(self.numbers), poses, self.follows)


class SubmapRecorder(Serialized):
    """Fuse posed frames into submaps. Each shares its last frames with the next.

    Submaps use the coordinates of their first camera, so volumes stay near the origin. At most two are open at a time.

    Args:
        intrinsic: The camera.
        voxel_size: Voxel edge of the volumes [m].
        truncation: As of TSDFVolume.
        depth_scale: Integer depth units per meter.
        depth_max: Maximum depth [m].
        frames: Frames per submap.
        max_length: Maximum camera path per submap [m], rotations at 1 m radius; None: unlimited.
        shared: Fraction of a submap shared with the next, 0 to 0.5.
        color: Fuse colors.
        device: As of TSDFVolume.

    Attributes:
        submaps: The completed submaps.

    Raises:
        TypeError, ValueError: Not a PinholeCameraIntrinsic, not numbers, or out of range.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> recorder = loom.rgbd.SubmapRecorder(camera, voxel_size=0.05, frames=4, shared=0.25, color=False)
        >>> for step in range(10):
        ...     pose = np.eye(4)
        ...     pose[0, 3] = 0.01 * step
        ...     recorder.add(np.full((48, 64), 1000, np.uint16), pose)
        >>> [submap.frames.tolist() for submap in recorder.finish()]
        [[0, 1, 2, 3], [3, 4, 5, 6], [6, 7, 8, 9]]
    """

    def __init__(
        self,
        intrinsic: PinholeCameraIntrinsic,
        *,
        voxel_size: float,
        truncation: float | None = None,
        depth_scale: float = DEPTH_SCALE,
        depth_max: float = DEPTH_MAX,
        frames: int = SUBMAP_FRAMES,
        max_length: float | None = None,
        shared: float = SHARED_FRACTION,
        color: bool = True,
        device: DeviceLike = None,
    ):
        check_camera("intrinsic", intrinsic)
        self._intrinsic, self._scale = intrinsic, check_positive("depth_scale", depth_scale)
        self._depth_max = check_positive("depth_max", depth_max)
        self._sizes = {"voxel_size": voxel_size, "truncation": truncation, "color": color, "device": device}
        TSDFVolume(**self._sizes)  # validates them
        self._max_frames = check_count("frames", frames)
        self._max_way = math.inf if max_length is None else check_positive("max_length", max_length)
        self._shared = check_fraction("shared", shared)
        if self._shared > 0.5:
            raise ValueError(f"shared: expected at most 0.5, got {shared}")
        self.submaps: list[Submap] = []
        self._open: list[_Recording] = []
        self._follows, self._count = False, 0

    @property
    def current(self) -> Submap | None:
        """The open submap with most frames. None before the first frame."""
        return self._open[0].done() if self._open and self._open[0].numbers else None

    def add(
        self,
        depth: ArrayLike,
        T_world_camera: ArrayLike | None,
        color: ArrayLike | None = None,
        number: int | None = None,
    ) -> None:
        """Add a frame with its pose.

        Args:
            depth: As of `TSDFVolume.integrate`, of the camera's size.
            T_world_camera: Shape [4, 4]. None if tracking was lost: the next submap then has `follows` False.
            color: Likewise; required if colors are fused.
            number: Frame number, ascending. None counts.

        Raises:
            ValueError, TypeError: As of `TSDFVolume.integrate`, or a number that is not ascending.
        """
        number = self._count if number is None else check_count("number", number, minimum=0)
        if number < self._count:
            raise ValueError(f"number: expected {self._count} or more, got {number}")
        self._count = number + 1
        if T_world_camera is None:
            self.finish()
            self._follows = False
            return
        pose = _rigid("T_world_camera", T_world_camera)
        if not self._open or (len(self._open) == 1 and self._fullness(self._open[0]) >= 1 - self._shared):
            self._open.append(_Recording(TSDFVolume(**self._sizes), pose, bool(self._open) or self._follows))
        for recording in self._open:
            self._record(recording, number, depth, pose, color)
        self._follows = True
        if len(self._open) == 2 and self._fullness(self._open[0]) >= 1:
            self.submaps.append(self._open.pop(0).done())

    def _record(
        self, recording: _Recording, number: int, depth: ArrayLike, pose: Matrix, color: ArrayLike | None
    ) -> None:
        extrinsic = matmul(invert_pose(pose), recording.T_world_submap)
        scale = integer_scale(depth, self._scale)
        recording.volume.integrate(depth, self._intrinsic, extrinsic, color, scale, self._depth_max)
        recording.way += way_between(recording.latest, pose)
        recording.latest = pose
        recording.numbers.append(number)
        recording.poses.append(pose)

    def _withdraw(self, number: int, depth: AnyArray, pose: Matrix, pixels: AnyArray | None, is_restored: bool) -> None:
        """Remove a frame from the volumes that contain it, or add it again. Its pose remains, to connect the submaps.

        `depth` [m] and `pixels` are those of `add`, on the device. The submaps have the poses that they had then.
        """
        known = [(recording.volume, recording.T_world_submap, recording.numbers) for recording in self._open]
        known += [(submap.volume, submap.T_world_submap, submap.frames.tolist()) for submap in self.submaps]
        for volume, T_world_submap, numbers in known:
            if number in numbers:
                T = inv(matmul(invert_pose(pose), T_world_submap))
                if is_restored:
                    volume.integrate_device_frame(depth, self._intrinsic, T, pixels, 1.0, self._depth_max)
                else:
                    volume.remove_device_frame(depth, self._intrinsic, T, pixels, self._depth_max)

    def _fullness(self, recording: _Recording) -> float:
        return max(len(recording.numbers) / self._max_frames, recording.way / self._max_way)

    def finish(self) -> list[Submap]:
        """Complete and return all submaps without those that have no own frames. Later frames begin a new one."""
        last = self.submaps[-1].frames[-1] if self.submaps else -1
        for recording in self._open:
            if recording.numbers and recording.numbers[-1] > last:
                self.submaps.append(recording.done())
                last = recording.numbers[-1]
        self._open = []
        return list(self.submaps)

    def take_over(self, submaps: Sequence[Submap]) -> None:
        """Add the completed submaps of another recorder in the same coordinates."""
        self.finish()
        self.submaps += submaps
        self._count = max([self._count, *(int(submap.frames[-1]) + 1 for submap in submaps)])


def tracked_run(submaps: Sequence[Submap]) -> tuple[NDArray[np.int64], Matrix]:
    poses: dict[int, Matrix] = {}
    for submap in submaps:
        for number, pose in zip(submap.frames.tolist(), submap.T_world_camera, strict=True):
            poses.setdefault(number, pose)
    numbers = sorted(poses)
    return np.array(numbers, np.int64), np.array([poses[n] for n in numbers]).reshape(-1, 4, 4)


def check_submaps(submaps: Sequence[Submap]) -> list[Submap]:
    items = check_list("submaps", submaps, "Submaps")
    if not items:
        raise ValueError("submaps: expected at least one, got none")
    for i, submap in enumerate(items):
        if not isinstance(submap, Submap):
            raise TypeError(f"submaps[{i}]: expected a Submap, got {type(submap).__name__}")
    return items


def check_poses(submaps: Sequence[Submap], poses: ArrayLike) -> Matrix:
    stack = check_numeric("T_world_submap", poses)
    if stack.shape != (len(submaps), 4, 4):
        raise ValueError(f"T_world_submap: expected shape [{len(submaps)}, 4, 4], got {list(stack.shape)}")
    return np.array([check_rigid(f"T_world_submap[{i}]", T) for i, T in enumerate(stack)])
