"""TSDFVolume: surface fusion from posed depth frames."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_checks import warn_of_scale
from ...cameras.depth_range import OPEN3D_DEPTH_MAX, UNLIMITED_DEPTH
from ...cameras.images import RGBDImage, check_intrinsic, upload_color, upload_raw_depth, upload_taken
from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import NUMPY, library_of
from ...core.attribute_hints import HintedNames
from ...core.checks import check_positive, check_rigid
from ...core.coordinates import origin_of_sensor
from ...core.devices import DeviceLike, check_same_device, resolve_device
from ...core.dropped_results import returns_new
from ...core.errors import values_of_file
from ...core.observers import report
from ...core.pickled_arrays import device_like, unpickling
from ...core.serialized import one_at_a_time
from ...kernels.array_types import AnyArray, Device, Keys
from ...kernels.images import depth as depth_images
from ...kernels.linear_algebra import inv
from ...kernels.memory import download
from ...kernels.volumes.block_rows import SeenBlocks
from ...kernels.volumes.block_surface import BlockSurface
from ...kernels.volumes.device_frames import DeviceFrames
from ...kernels.volumes.frame_record import TouchesOfFrame
from ...kernels.volumes.integrate import Frame, integrate_depth
from ...kernels.volumes.removal import remove_depth
from ...kernels.volumes.tsdf_blocks import BLOCK_VOXELS, touched_blocks
from ...kernels.volumes.voxel_blocks import VoxelBlocks
from ...pcd.cloud import PointCloud
from ..mesh.mesh import TriangleMesh
from .block_count import BlockCount
from .stacked_frames import StackedFrames, stacked_frames
from .tsdf_files import LARGEST_TRUNCATION, VOXEL_ARRAYS, check_volume_arrays, read_volume_arrays, write_volume_arrays
from .tsdf_scans import ScanIntegration
from .tsdf_views import RayCast, RenderedMaps, cast_view, check_view, render_colors, render_maps
from .voxel_boxes import check_voxel_size

MAX_TOGETHER = 4  # frames of one graph: room for all blocks that they may touch is reserved, and stays
OTHER_UNIT = 30.0  # times the maximum depth: more distant content suggests another unit


@dataclass(frozen=True)
class FrameState:
    """Number, origin [m] and colors of the integrated frames."""

    count: int = 0
    origin: NDArray[np.float64] | None = None
    colored: bool = False  # True if the frames had color


class TSDFVolume(ScanIntegration, HintedNames):
    """Surface fusion from posed depth frames or LiDAR scans: truncated signed distances in hashed blocks.

    Blocks of 8^3 voxels are allocated on demand. A voxel stores the running mean of min(1, (d - z) / truncation), its
    weight (frames, at most 65535) and mean color: 12 B, 6 B without color. Voxels are at multiples of `voxel_size`,
    distances along z. Unlike in Open3D the nearest pixel is used, the truncation is in meters, and float depth is in
    meters by default. An interrupted integration is applied completely or not at all. See `frame_count`.

    Args:
        voxel_size: Edge of a voxel [m].
        truncation: Truncation distance [m]. If None: 4 voxels.
        color: Keep colors.
        device: "cpu" (default), "cuda:0" or "auto".

    Raises:
        ValueError: If a size is not positive, or the truncation is below one voxel.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> volume = loom.TSDFVolume(voxel_size=0.02, truncation=0.08)
        >>> touched = volume.integrate(np.full((48, 64), 1000, np.uint16), camera, np.eye(4))
        >>> mesh = volume.extract_triangle_mesh(weight_threshold=0)
        >>> bool(np.allclose(mesh.vertices[:, 2], 1.0, atol=1e-5))
        True
    """

    device: Any
    has_color: bool
    _fixed = ("device", "has_color")
    _internal = (
        "blocks", "downloaded", "from_downloaded", "integrate_device_frame", "remove_device_frame", "render_colors",
        "render_maps", "set_content",
    )  # fmt: skip

    @explain_argument_errors
    def __init__(
        self, voxel_size: float, truncation: float | None = None, *, color: bool = True, device: DeviceLike = None
    ):
        edge = check_voxel_size(voxel_size)
        limit = 4 * edge
        if truncation is not None:
            limit = check_positive("truncation", truncation, maximum=LARGEST_TRUNCATION)
        if limit < edge:
            raise ValueError(f"truncation: {truncation} m is below one voxel ({edge} m). 4 voxels are usual")
        self.device, self.has_color = resolve_device(device), bool(color)
        self._frames, self._library = FrameState(), NUMPY
        self._next: tuple[int, FrameState] | None = None  # block frame count, and the state once the blocks reach it
        self._keep(VoxelBlocks(edge, limit, self.has_color, self.device))

    def __repr__(self) -> str:
        size = f"{self.voxel_size} m voxels, {self.truncation} m truncation"
        return f"TSDFVolume({size}, {self.block_count:,} blocks, {self.frame_count} frames, {self.device})"

    @property
    def voxel_size(self) -> float:
        """Edge of a voxel [m]."""
        return self.blocks.voxel_size

    @property
    def truncation(self) -> float:
        """Truncation distance [m]."""
        return self.blocks.truncation

    @property
    def block_count(self) -> int:
        """Number of blocks of 8^3 voxels."""
        return self.blocks.count

    @property
    def origin(self) -> NDArray[np.float64]:
        """Origin of the volume's coordinates [m]: zero, or near the first camera if that is beyond 128 m."""
        origin = self._current_frames.origin
        return np.zeros(3) if origin is None else origin.copy()

    @property
    def frame_count(self) -> int:
        """Number of integrated frames."""
        return self._current_frames.count

    @property
    def memory_bytes(self) -> int:
        """Device memory of voxels, keys and hash table [B]."""
        return self.blocks.memory_bytes

    @explain_argument_errors
    def integrate(
        self,
        depth: ArrayLike | RGBDImage,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike,
        color: ArrayLike | None = None,
        depth_scale: float | None = None,
        depth_max: float | None = None,
    ) -> int:
        """Integrate a frame: `volume.integrate(depth, camera, T, color)`, or Open3D's `integrate(rgbd, camera, T)`.

        Args:
            depth: Shape (h, w). Integers of 16 bits and more, or floats. 0, NaN and infinite are invalid. Or an
                RGBDImage.
            intrinsic: The camera, of the image's size.
            extrinsic: T_camera_world, shape (4, 4).
            color: uint8 (h, w, 3); required for every frame or none if the volume keeps color.
            depth_scale: Depth units per meter. If None: 1000 for integers, 1 for floats.
            depth_max: Maximum depth used [m]. If None: 3, or the limit of the RGBDImage.

        Returns:
            The number of touched blocks. 0 without depth. On a GPU the value is awaited on first use.

        Raises:
            ValueError: If shapes or sizes disagree, the pose is not rigid, color is missing or unexpected, or the frame
                is beyond 2^20 blocks. The volume stays unchanged.
            TypeError: If an element type is wrong.
        """
        T_camera_world, on_host = check_rigid("extrinsic", extrinsic), self._device_frames is not None
        if isinstance(depth, RGBDImage):
            raw, scale, height, width = depth.depth_array, 1.0, depth.height, depth.width
            farthest = np.inf if depth_max is None else check_positive("depth_max", depth_max, allow_infinite=True)
            pixels, library = self._pixels_of(depth, color), depth.array_library
        else:
            limit = OPEN3D_DEPTH_MAX if depth_max is None else depth_max
            given = depth, depth_scale, limit, self.device
            raw, scale, farthest, height, width = upload_raw_depth(*given, on_host=on_host)
            pixels, library = None, library_of(depth)
            warn_of_scale(depth, scale, farthest, "depth_max", OTHER_UNIT)
        camera = check_intrinsic(intrinsic, width, height)
        self._check_color(pixels is not None or color is not None)
        if color is not None:
            pixels = upload_color(color, height, width, self.device, on_host=on_host)
        T = inv(T_camera_world)
        count = self.integrate_device_frame(raw, camera, T, pixels, scale, farthest)
        self._library = library
        report("integrate", volume=self, intrinsic=camera, T_world_camera=T)
        return count

    @explain_argument_errors
    def integrate_frames(
        self,
        depth: ArrayLike,
        intrinsic: PinholeCameraIntrinsic | Sequence[PinholeCameraIntrinsic],
        extrinsic: ArrayLike,
        color: ArrayLike | None = None,
        depth_scale: float | None = None,
        depth_max: float = OPEN3D_DEPTH_MAX,
    ) -> list[int]:
        """Integrate k frames of one size, such as those of k cameras: bitwise as k calls of `integrate`, in order.

        On a GPU groups of up to 4 frames are one upload and one graph, without a wait between the frames. An
        interrupted call keeps complete groups (see `frame_count`).

        Args:
            depth: Shape (k, h, w). Integers of 16 bits and more, or floats. 0, NaN and infinite are invalid.
            intrinsic: The camera of all frames, or a sequence of k cameras of the images' size.
            extrinsic: T_camera_world of each frame, shape (k, 4, 4).
            color: uint8 (k, h, w, 3); required for every frame or none if the volume keeps color.
            depth_scale: Depth units per meter. If None: 1000 for integers, 1 for floats.
            depth_max: Maximum depth used [m].

        Returns:
            The number of touched blocks of each frame. On a GPU the values are awaited on first use.

        Raises:
            ValueError: If there is no frame, shapes, sizes or counts disagree, a pose is not rigid, or color is missing
                or unexpected. The volume stays unchanged. Also if a frame is beyond 2^20 blocks: frames before it stay.
            TypeError: If an element type is wrong.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
            >>> volume = loom.TSDFVolume(voxel_size=0.02)
            >>> depths, poses = np.full((2, 48, 64), 1000, np.uint16), np.stack([np.eye(4)] * 2)
            >>> touched = volume.integrate_frames(depths, camera, poses)
            >>> len(touched), volume.frame_count
            (2, 2)
        """
        on_host = self._device_frames is not None  # until their group is integrated
        given = depth, intrinsic, extrinsic, color, depth_scale, depth_max, self.device
        frames = stacked_frames(*given, on_host=on_host)
        self._check_color(frames.pixels is not None)
        warn_of_scale(frames.depth, frames.scale, frames.farthest, "depth_max", OTHER_UNIT)
        counts: list[Any] = []
        for first in range(0, len(frames.poses), MAX_TOGETHER):
            counts += self._integrate_group(frames, range(first, min(first + MAX_TOGETHER, len(frames.poses))))
        self._library = library_of(depth)
        for camera, T in zip(frames.cameras, frames.poses, strict=True):
            report("integrate", volume=self, intrinsic=camera, T_world_camera=T)
        return counts

    @one_at_a_time
    def _integrate_group(self, frames: StackedFrames, rows: range) -> list[Any]:
        """Integrate some of the frames, on a GPU together if there is room. Returns the numbers of touched blocks."""
        before, device_frames = self._current_frames, self._device_frames
        origin = origin_of_sensor(frames.poses[rows[0]][:3, 3]) if before.origin is None else before.origin
        if device_frames is not None and len(rows) > 1:
            poses = [frames.poses[k].copy() for k in rows]
            for T in poses:
                T[:3, 3] -= origin
            after = FrameState(before.count + len(rows), origin, frames.pixels is not None)
            self._next = (self.blocks.frame_count + len(rows), after)
            raw, pixels = frames.images(rows)
            cameras = [frames.cameras[k] for k in rows]
            touches = device_frames.integrate_together(raw, frames.scale, frames.farthest, cameras, poses, pixels)
            if touches is not None:
                self._frames, self._next = after, None
                return [BlockCount(TouchesOfFrame(touches, k)) for k in range(len(rows))]
        counts = []
        for k in rows:
            raw, pixels = frames.images(range(k, k + 1))
            given = (pixels, frames.scale, frames.farthest)
            counts.append(self.integrate_device_frame(raw, frames.cameras[k], frames.poses[k], *given))
        return counts

    @one_at_a_time
    def integrate_device_frame(
        self,
        depth: AnyArray,
        intrinsic: PinholeCameraIntrinsic,
        T_world_camera: NDArray[Any],
        pixels: AnyArray | None = None,
        depth_scale: float = 1.0,
        depth_max: float = UNLIMITED_DEPTH,
    ) -> int:
        """`integrate` for a frame on the device, or on the host if there are `_device_frames`. The pose is not checked.
        `depth` is float32 or uint16 (h * w,) in units of 1 / `depth_scale`; `pixels` is uint8 (h * w, 3) or None."""
        frames, T = self._current_frames, np.array(T_world_camera, np.float64)
        origin = frames.origin
        if origin is None:
            origin = origin_of_sensor(T[:3, 3])
        T[:3, 3] -= origin
        after = FrameState(frames.count + 1, origin, pixels is not None)
        self._next = (self.blocks.frame_count + 1, after)
        count = self._fold(depth, depth_scale, depth_max, intrinsic, T, pixels)
        self._frames, self._next = after, None
        return count

    def remove_device_frame(
        self,
        depth: AnyArray,
        intrinsic: PinholeCameraIntrinsic,
        T_world_camera: NDArray[Any],
        pixels: AnyArray | None,
        depth_max: float,
    ) -> None:
        """Undo `integrate_device_frame` of the same frame at the same pose, up to rounding. `depth` is in meters."""
        frames, T = self._current_frames, np.array(T_world_camera, np.float64)
        T[:3, 3] -= self.origin
        after = FrameState(frames.count - 1, frames.origin, frames.colored)
        metric, largest = depth_images.metric_depth(depth, 1.0, depth_max)
        frame = Frame(metric, depth_images.largest_depth(largest), intrinsic, pixels)
        self._next = (self.blocks.frame_count + 1, after)
        if frame.farthest > 0:
            sizes = self.truncation, self.voxel_size
            keys: Any = self._filter_keys(touched_blocks(metric, frame.farthest, intrinsic, T, *sizes))
            if keys.size:
                remove_depth(keys, frame, inv(T), self.blocks)
        self._frames, self._next = after, None

    def _pixels_of(self, image: RGBDImage, color: ArrayLike | None) -> Any:
        """Colors of an image on the device. None if the volume keeps none, or others are given."""
        check_same_device("depth", self.device, image.device)
        if not self.has_color or color is not None:
            return None
        if image.color_array.dtype != wp.uint8:
            raise TypeError(
                "depth: expected an RGBDImage with color, got one with intensity. Create it with "
                "convert_rgb_to_intensity=False, or the volume with color=False"
            )
        return image.color_array

    def _check_color(self, colored: bool) -> None:
        """Raise ValueError if only some frames have color."""
        if colored and not self.has_color:
            raise ValueError("color: expected None, because the volume was created with color=False")
        frames = self._current_frames
        if self.has_color and frames.count and frames.colored != colored:
            have = "with" if frames.colored else "without"
            raise ValueError(f"color: the previous frames came {have} color. Pass color for every frame or for none")

    def _fold(
        self,
        raw: AnyArray,
        scale: float,
        farthest: float,
        camera: PinholeCameraIntrinsic,
        T: NDArray[np.float64],
        pixels: AnyArray | None,
    ) -> Any:
        """Integrate a frame into the blocks. Returns the number of touched blocks, on a GPU still pending."""
        if self._device_frames is not None:
            counts = self._device_frames.integrate(raw, scale, farthest, camera, T, pixels)
            if counts is not None:
                return BlockCount(counts)
            raw, pixels = upload_taken(raw, self.device), upload_taken(pixels, self.device)
        metric, largest = depth_images.metric_depth(raw, scale, farthest)
        frame = Frame(metric, depth_images.largest_depth(largest), camera, pixels)
        if not frame.farthest > 0:
            return 0
        keys: Any = self._filter_keys(
            touched_blocks(metric, frame.farthest, camera, T, self.blocks.truncation, self.blocks.voxel_size)
        )
        if not keys.size:
            return 0
        integrate_depth(keys, frame, inv(T), self.blocks)
        return keys.size

    def _filter_keys(self, keys: Keys) -> Any:
        """Touched blocks, int64 keys, that belong to the volume: here all."""
        return keys

    def extract_triangle_mesh(self, weight_threshold: float = 3.0) -> TriangleMesh:
        """Extract the surface as a mesh by marching cubes, with shared vertices.

        Args:
            weight_threshold: A cell needs more frames than this at all 8 voxels.

        Returns:
            Vertices [m] with colors if frames had them. Empty if nothing was seen often enough. Triangles are
            counterclockwise from outside. Bitwise reproducible.

        Raises:
            ValueError: If the threshold is negative or not finite.
        """
        surface = self._surface(weight_threshold, need_cells=True)
        vertices, shades, _ = surface.vertices(self.has_frame_colors, False)
        arrays = {"vertices": vertices, "triangles": surface.triangles(), "vertex_colors": shades}
        return TriangleMesh.from_device_arrays(arrays, self.origin, self._library)

    def extract_point_cloud(self, weight_threshold: float = 3.0) -> PointCloud:
        """Extract surface points on grid edges, with normals and colors.

        Args:
            weight_threshold: An edge needs more frames than this at both voxels.

        Returns:
            A cloud with normals from the distance gradient, toward the cameras. Bitwise reproducible.

        Raises:
            ValueError: If the threshold is negative or not finite.
        """
        surface = self._surface(weight_threshold, need_cells=False)
        points, shades, normals = surface.vertices(self.has_frame_colors, True)
        arrays: dict[str, wp.array] = {"points": points, "normals": normals}  # type: ignore[dict-item]
        if shades is not None:
            arrays["colors"] = shades
        return PointCloud.from_device_arrays(arrays, self.origin, self._library)

    def ray_cast(
        self,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike,
        *,
        depth_min: float = 0.1,
        depth_max: float = OPEN3D_DEPTH_MAX,
        weight_threshold: float = 3.0,
    ) -> RayCast:
        """Render the surface from a camera. Back faces are transparent.

        Args:
            intrinsic: The camera. Its size is that of the image.
            extrinsic: T_camera_world, shape (4, 4).
            depth_min, depth_max: Range of the rays [m].
            weight_threshold: Ignore voxels with at most this many frames.

        Raises:
            ValueError: If not 0 < depth_min < depth_max, or the extrinsic is not rigid or beyond 2^20 blocks.
            TypeError: If the intrinsic has another type.
        """
        near, far, threshold = check_view(intrinsic, depth_min, depth_max, weight_threshold)
        T = self._pose_about_origin(inv(check_rigid("extrinsic", extrinsic)))
        seen, colored = SeenBlocks(self.blocks, threshold), self.has_frame_colors
        return cast_view(seen, intrinsic, T, (near, far), self.origin, colored, self._library)

    @one_at_a_time
    def render_maps(
        self,
        intrinsic: PinholeCameraIntrinsic,
        T_world_camera: NDArray[Any],
        *,
        depth_min: float = 0.1,
        depth_max: float = OPEN3D_DEPTH_MAX,
        weight_threshold: float = 3.0,
        normals: bool = True,
    ) -> RenderedMaps:
        """`ray_cast` for tracking: depth, brightness and optionally normals in the camera frame, on the device. Faster
        than `ray_cast`: no points, colors or copies. The pose is not checked."""
        near, far, threshold = check_view(intrinsic, depth_min, depth_max, weight_threshold)
        T = self._pose_about_origin(np.array(T_world_camera, np.float64))
        seen, colored = SeenBlocks(self.blocks, threshold), self.has_frame_colors
        return render_maps(seen, intrinsic, T, (near, far), colored, normals)

    @one_at_a_time
    def render_colors(
        self,
        intrinsic: PinholeCameraIntrinsic,
        T_world_camera: NDArray[Any],
        *,
        depth_min: float = 0.1,
        depth_max: float = OPEN3D_DEPTH_MAX,
        weight_threshold: float = 3.0,
    ) -> tuple[wp.array, wp.array]:
        """As `render_maps`: depth, float32 (h * w,), 0 without surface, and colors, vec3 (h * w,) in 0..1."""
        near, far, threshold = check_view(intrinsic, depth_min, depth_max, weight_threshold)
        T = self._pose_about_origin(np.array(T_world_camera, np.float64))
        return render_colors(SeenBlocks(self.blocks, threshold), intrinsic, T, (near, far))

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
        """Write the volume to an .npz file atomically.

        Raises:
            FileError: If the file cannot be written, or exists and `overwrite` is False.
        """
        write_volume_arrays(path, self.downloaded(), overwrite=overwrite)

    def downloaded(self) -> dict[str, Any]:
        """Complete state as NumPy arrays, for files, pickle and copies."""
        used = self.block_count * BLOCK_VOXELS
        arrays = {
            "sizes": np.array([self.voxel_size, self.truncation]),
            "origin": self.origin,
            "frame_count": np.array(self.frame_count),
            "has_color": np.array([self.has_color, self._current_frames.colored]),
            "keys": download(self.blocks.keys)[: self.block_count],
            "distances": download(self.blocks.distances)[:used],
            "weights": download(self.blocks.weights)[:used],
        }
        if self.has_frame_colors:
            arrays["colors"] = download(self.blocks.colors)[:used]
        return arrays

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, device: DeviceLike = None) -> TSDFVolume:
        """Read a volume written by `save`.

        Raises:
            FileError: If the file is missing, damaged or of another kind.
        """
        arrays, where = read_volume_arrays(path), resolve_device(device)
        with values_of_file(path):
            return cls.from_downloaded(arrays, where)

    @classmethod
    def from_downloaded(cls, arrays: dict[str, Any], device: Device) -> TSDFVolume:
        voxel_size, truncation = arrays["sizes"].tolist()
        has_color, colored = arrays["has_color"].tolist()
        volume = cls(voxel_size=voxel_size, truncation=truncation, color=has_color, device=device)
        frame_count = int(arrays["frame_count"])
        vars(volume)["_frames"] = FrameState(frame_count, arrays["origin"] if frame_count else None, colored)
        volume.blocks.fill({name: arrays[name] for name in VOXEL_ARRAYS if name in arrays})
        return volume

    @returns_new
    def copy(self) -> TSDFVolume:
        """Independent copy with the same voxels."""
        sizes = {"voxel_size": self.voxel_size, "truncation": self.truncation}
        volume = TSDFVolume(**sizes, color=self.has_color, device=self.device)
        volume.set_content(self.blocks.clone(), self._current_frames, self._library)
        return volume

    def __copy__(self) -> TSDFVolume:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> TSDFVolume:
        return self.copy()

    def __getstate__(self) -> dict[str, Any]:
        return {"arrays": self.downloaded(), "device": str(self.device)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore on the saved device, or the first GPU if its index does not exist."""
        with unpickling("volume"):
            where = device_like("volume", state["device"])
            made = self.from_downloaded(check_volume_arrays(state["arrays"]), where)
        vars(self).update(vars(made))

    def _keep(self, blocks: VoxelBlocks) -> None:
        self.blocks = blocks
        self._device_frames = DeviceFrames(blocks, depth_images) if self.device.is_cuda else None

    def set_content(self, blocks: VoxelBlocks, frames: FrameState, library: str) -> None:
        self._frames, self._library = frames, library
        self._keep(blocks)

    @property
    def _current_frames(self) -> FrameState:
        """Current state. An interrupted frame counts if the blocks contain it."""
        if self._next is not None:
            number, after = self._next
            if self.blocks.frame_count == number:
                self._frames = after
            self._next = None
        return self._frames

    def _pose_about_origin(self, T_world_camera: NDArray[Any]) -> NDArray[Any]:
        """Convert a pose to the volume's coordinates, in place."""
        T_world_camera[:3, 3] -= self.origin
        return T_world_camera

    @property
    def array_library(self) -> str:
        """Library of the arrays that `ray_cast` and the surface return: that of the frames."""
        return self._library

    @property
    def has_frame_colors(self) -> bool:
        """True if the volume keeps color and its frames had some."""
        return self.has_color and self._current_frames.colored

    def _surface(self, weight_threshold: float, *, need_cells: bool) -> BlockSurface:
        threshold = check_positive("weight_threshold", weight_threshold, allow_zero=True)
        return BlockSurface(SeenBlocks(self.blocks, threshold), need_cells)
