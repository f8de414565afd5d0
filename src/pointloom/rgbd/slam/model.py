"""The TSDF model for frame-to-model tracking, similar to Open3D's `t.pipelines.slam.Model`."""

from __future__ import annotations

import dataclasses
from typing import Any, NoReturn

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...cameras.depth_range import DEPTH_MAX, DEPTH_SCALE
from ...core.checks import check_positive, check_rigid
from ...core.devices import DeviceLike
from ...core.observers import report
from ...core.serialized import Serialized
from ...kernels.array_types import AnyArray
from ...kernels.linear_algebra import inv, matmul
from ...kernels.rgbd.model_maps import colors_of
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.volume.tsdf import RayCast, TSDFVolume
from ...pcd.cloud import PointCloud
from ..odometry.alignment import align_frames
from ..odometry.frames import OdometryFrame
from ..odometry.results import OdometryResult
from .frames import MAX_PIXELS, SensorFrame
from .moving_objects import Movers

Pose = NDArray[np.float64]

SEEN_OFTEN = 3  # minimum weight of rendered voxels, as in Open3D
DEPTH_MIN = 0.1  # [m] start of rays
BLUR_VOXELS = 0.1  # voxels: SDF interpolation error at curved surfaces
MIN_FRAMES = 10  # with fewer frames, planes are fitted, since the border has no gradients
MIN_SHADED_VOXEL = 0.03  # [m] voxels above which SDF gradients are better normals than fitted planes


class SlamModel(Serialized):
    """A TSDF volume for frame-to-model tracking of a depth camera.

    Unlike Open3D's SlamModel, the camera is given once, frames are any objects with `depth` and `color`, the model is
    rendered with color at the tracking resolution, and `track_frame` accepts an initial pose.

    Args:
        intrinsic: The camera of all frames.
        voxel_size: Voxel edge [m].
        truncation: Truncation distance [m]; None: 4 voxels.
        T_init: Initial T_world_camera; None: the identity.
        depth_scale: Integer depth units per meter.
        depth_max: Maximum depth used [m].
        leave_out_moving: Exclude pixels of objects that appeared within the last second.
        device: "cpu", "cuda:0", "auto"; None: the CPU.

    Attributes:
        current_frame_pose: Pose of the last integrated frame; initially T_init.
        volume: The TSDFVolume for tracking.
        surface_volume: The TSDFVolume of the surface: `volume` without frames that were withdrawn.
        movers: The detector of moving objects. Empty if disabled.

    Raises:
        ValueError: A size that is not positive, or a pose that is not rigid.
        TypeError: `intrinsic` has another type.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> v, u = np.mgrid[:48, :64]
        >>> depth = 1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7)
        >>> frame = loom.RGBDImage(np.zeros((48, 64), np.uint8), depth)
        >>> model = loom.rgbd.SlamModel(camera, voxel_size=0.02)
        >>> model.integrate(frame, np.eye(4))
        >>> model.track_frame(frame).reliable
        True
    """

    def __init__(
        self,
        intrinsic: PinholeCameraIntrinsic,
        *,
        voxel_size: float = 0.01,
        truncation: float | None = None,
        T_init: ArrayLike | None = None,
        depth_scale: float = DEPTH_SCALE,
        depth_max: float = DEPTH_MAX,
        leave_out_moving: bool = True,
        device: DeviceLike = None,
    ):
        check_camera("intrinsic", intrinsic)
        self.intrinsic = intrinsic
        self.depth_scale = check_positive("depth_scale", depth_scale)
        self.depth_max = check_positive("depth_max", depth_max)
        if self.depth_max <= DEPTH_MIN:
            raise ValueError(f"depth_max: expected more than the minimum depth, {DEPTH_MIN} m, got {depth_max}")
        self.current_frame_pose = np.eye(4) if T_init is None else check_rigid("T_init", T_init)
        self.volume = TSDFVolume(voxel_size=voxel_size, truncation=truncation, device=device)
        self.device = self.volume.device
        self._without: TSDFVolume | None = None  # the volume without withdrawn frames, if there are any
        self._withdrawn = 0  # number of these
        self.leave_out_moving, self.movers = bool(leave_out_moving), Movers()
        self._view = compared_camera(intrinsic)

    def __repr__(self) -> str:
        return f"SlamModel({self.volume!r})"

    def __reduce__(self) -> NoReturn:
        raise TypeError("SlamModel cannot be copied or pickled: keep its volume (model.volume)")

    @property
    def frame_count(self) -> int:
        """Number of integrated frames, with those that were withdrawn."""
        return self.volume.frame_count

    @property
    def surface_volume(self) -> TSDFVolume:
        """The surface: `volume` without the frames that were withdrawn."""
        return self.volume if self._without is None else self._without

    def _replace_volume(self, volume: TSDFVolume, surface: TSDFVolume | None = None) -> None:
        """Replace the volume, and that of the surface if it is another one."""
        self.volume, self._without, self.movers = volume, surface, Movers()
        self._withdrawn = 0 if surface is None else surface.frame_count + 1  # its frames are not added again

    def _withdraw(self, depth: AnyArray, pixels: AnyArray | None, pose: Pose, is_restored: bool) -> None:
        """Remove what `fuse` returned for a frame from the surface, or add it again. Tracking uses all frames."""
        self._withdrawn += -1 if is_restored else 1
        if not self._withdrawn:
            self._without = None
            return
        if self._without is None:
            self._without = self.volume.copy()
        if is_restored:
            self._without.integrate_device_frame(depth, self.intrinsic, pose, pixels, 1.0, self.depth_max)
        else:
            self._without.remove_device_frame(depth, self.intrinsic, pose, pixels, self.depth_max)

    def begin_anew(self, pose: Pose) -> None:
        """Reset the volume. The next frame is at the given T_world_camera."""
        sizes: dict[str, Any] = {"voxel_size": self.volume.voxel_size, "truncation": self.volume.truncation}
        self._replace_volume(TSDFVolume(**sizes, device=self.device))
        self.current_frame_pose = pose

    def prepare(self, frame: object) -> SensorFrame:
        """Upload a frame for repeated use. A prepared frame is returned unchanged.

        Raises:
            TypeError, ValueError: As `SensorFrame`.
        """
        if isinstance(frame, SensorFrame):
            return frame
        return SensorFrame(frame, self.intrinsic, self.depth_scale, self.depth_max, self.device)

    def track_frame(self, frame: object, T_world_camera: ArrayLike | None = None) -> OdometryResult:
        """Estimate the pose of a frame by alignment with the model rendered at a nearby pose.

        Args:
            frame: The frame.
            T_world_camera: Initial pose; None: `current_frame_pose`.

        Returns:
            An OdometryResult whose transformation is T_world_camera, with information about that camera.

        Raises:
            TypeError, ValueError: As `prepare`; or an initial pose that is not rigid.
        """
        given = self.current_frame_pose if T_world_camera is None else check_rigid("T_world_camera", T_world_camera)
        result = align_frames(self.prepare(frame).pyramid, self.seen_from(given))
        return _moved(result, given)

    def integrate(self, frame: object, T_world_camera: ArrayLike) -> None:
        """Fuse a frame, which becomes the current one.

        Pixels in space that was seen free within the last second are excluded as moving. A frame without color in a
        colored model uses the model's colors, or gray.

        Raises:
            TypeError, ValueError: As `prepare`; or a pose that is not rigid. The model is then unchanged.
        """
        self.fuse(self.prepare(frame), check_rigid("T_world_camera", T_world_camera))

    def fuse(self, prepared: SensorFrame, pose: Pose) -> tuple[Any, Any]:
        """`integrate` for checked input. Returns the used depth and colors on the device."""
        pixels = prepared.pixels
        if self.frame_count and not self.volume.has_frame_colors:
            pixels = None
        elif self.frame_count and pixels is None:
            pixels = self._own_colors(pose)
        depth = prepared.still if prepared.still is not None else self.movers.still_depth(prepared, pose)
        volumes = [self.volume] if self._without is None else [self.volume, self._without]
        for volume in volumes:
            volume.integrate_device_frame(depth, self.intrinsic, pose, pixels, 1.0, self.depth_max)
        if self.leave_out_moving:
            self.movers.add(prepared, pose)
        self.current_frame_pose = pose
        report("integrate", volume=self.volume, intrinsic=self.intrinsic, T_world_camera=pose)
        return depth, pixels

    def render(self, T_world_camera: ArrayLike, *, weight_threshold: float | None = None) -> RayCast:
        """Render depth, points, normals and colors of the model.

        Args:
            T_world_camera: The pose.
            weight_threshold: Minimum weight (exclusive) of voxels; None: 3, or less with fewer frames.

        Raises:
            ValueError: The pose is not rigid.
        """
        pose = check_rigid("T_world_camera", T_world_camera)
        threshold = self.threshold if weight_threshold is None else weight_threshold
        limits = {"depth_min": DEPTH_MIN, "depth_max": self.depth_max}
        return self.volume.ray_cast(self.intrinsic, inv(pose), weight_threshold=threshold, **limits)

    def seen_from(self, T_world_camera: Pose, *, weight_threshold: float | None = None) -> OdometryFrame:
        """Render the model as an odometry frame on the device.

        Normals are fitted to the depth as for frames, or from SDF gradients if voxels exceed the pixel window.
        """
        threshold = self.threshold if weight_threshold is None else weight_threshold
        edge = self.volume.voxel_size
        is_shaded = edge >= MIN_SHADED_VOXEL and self.frame_count >= MIN_FRAMES
        limits: dict[str, Any] = {"depth_min": DEPTH_MIN, "depth_max": self.depth_max, "normals": is_shaded}
        maps: Any = self.volume.render_maps(self._view, T_world_camera, weight_threshold=threshold, **limits)
        surface = {"normals": maps.normals, "is_rendered": True, "blur": BLUR_VOXELS * edge}
        return OdometryFrame._from_device_maps(maps.depth, maps.intensity, self._view, MAX_PIXELS, **surface)

    def extract_triangle_mesh(self, weight_threshold: float = 3.0) -> TriangleMesh:
        """The surface as a mesh. See `TSDFVolume.extract_triangle_mesh`."""
        return self.surface_volume.extract_triangle_mesh(weight_threshold)

    def extract_point_cloud(self, weight_threshold: float = 3.0) -> PointCloud:
        """The surface as points. See `TSDFVolume.extract_point_cloud`."""
        return self.surface_volume.extract_point_cloud(weight_threshold)

    @property
    def threshold(self) -> float:
        """Weight above which a voxel is rendered: 3, or less with fewer frames."""
        return float(max(min(self.frame_count - 1, SEEN_OFTEN), 0))

    def _own_colors(self, pose: Pose) -> Any:
        limits = {"depth_min": DEPTH_MIN, "depth_max": self.depth_max}
        return colors_of(*self.volume.render_colors(self.intrinsic, pose, weight_threshold=0.0, **limits))


def compared_camera(intrinsic: PinholeCameraIntrinsic) -> PinholeCameraIntrinsic:
    camera = intrinsic
    while camera.width * camera.height > MAX_PIXELS and min(camera.width, camera.height) >= 2:
        camera = camera.scaled(0.5)
    return camera


def _moved(result: OdometryResult, pose: Pose) -> OdometryResult:
    return dataclasses.replace(result, transformation=matmul(pose, result.transformation))
