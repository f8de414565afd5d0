"""A synthetic scan of the furnished room of furniture.py: RGB-D frames, true poses, distances to the true surface.

All values are functions of frame number and seed. `film_pose` is for sequences without depth.
"""

from __future__ import annotations

import dataclasses
import functools
import math
import shutil
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera, write_pinhole_camera_intrinsic
from ...core.atomic import part_name
from ...core.checks import check_count, check_fraction, check_list, check_number, check_rigid, check_rows
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ...io.frames.datasets import Frame
from ...io.images.image_files import write_png
from ...kernels.lang import current_cpu_compiler, uint8, vec3d
from ...kernels.linear_algebra import norm
from ...kernels.memory import download, upload
from ...kernels.scenes.color_noise import measure_colors
from ...kernels.scenes.depth_noise import measure_depth
from ...kernels.scenes.primitives import distance_to_solids
from ...kernels.scenes.room import Room
from ...kernels.scenes.value_noise import grain_pixels
from .furniture import ROOM_SIZE, build_room, furnished_room

LOOP_ROUNDS = 4


def room_pose(fraction: float) -> NDArray[np.float64]:
    """Camera to world [m] at a fraction 0 to 1 of the walk, 2 to 3 m from most visible surfaces."""
    angle = 2 * math.pi * LOOP_ROUNDS * fraction + 0.35
    behind = _blend(fraction, (0.0, 0.22, 0.34, 0.50, 0.58, 1.0), (-0.45, -0.25, 0.55, 0.65, 1.35, 1.45))
    pitch = math.radians(_blend(fraction, (0.0, 0.22, 0.30, 0.50, 0.57, 1.0), (-20.0, -19.0, 27.0, 27.0, -28.0, -30.0)))
    height = _blend(fraction, (0.0, 0.50, 0.58, 1.0), (1.5, 1.4, 1.65, 1.75))
    x, y = ROOM_SIZE[0] / 2 - behind * math.cos(angle), ROOM_SIZE[1] / 2 - 0.75 * behind * math.sin(angle)
    eye = np.array([x, y, height + 0.05 * math.sin(5 * angle)])
    yaw = angle - math.radians(_blend(fraction, (0.0, 0.74, 0.82, 1.0), (0.0, 0.0, 55.0, 55.0)))
    return look_along(eye, (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch)))


def look_along(
    eye: NDArray[np.float64], direction: tuple[float, float, float], up: tuple[float, float, float] = (0, 0, 1)
) -> NDArray[np.float64]:
    """Camera to world for a camera at `eye` [m] that looks along a direction, with an upright image."""
    forward = np.asarray(direction, np.float64)
    forward = forward / norm(forward)
    right = np.cross(forward, up)
    right /= norm(right)
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = right, np.cross(forward, right), forward, eye
    return T


def _blend(fraction: float, knots: tuple[float, ...], values: tuple[float, ...]) -> float:
    """Interpolate values with curves that have zero slope at the given fractions."""
    for a, b, low, high in zip(knots, knots[1:], values, values[1:], strict=False):
        if fraction <= b:
            t = (fraction - a) / (b - a)
            return low + (high - low) * t * t * (3 - 2 * t)
    return values[-1]


def round_pose(fraction: float) -> NDArray[np.float64]:
    """Camera to world [m] on a circle around the center, looking across it. Up and down three times."""
    a = 2 * math.pi * fraction
    yaw, pitch = a + 0.35, math.radians(-6 + 27 * math.sin(3 * a))
    behind = 0.75 + 0.25 * math.sin(2 * a + 1)
    position = (-behind * math.cos(yaw), -0.8 * behind * math.sin(yaw), 1.5 + 0.15 * math.sin(2 * a))
    return hand_held(fraction, position, yaw, pitch)


def film_pose(fraction: float) -> NDArray[np.float64]:
    """Camera to world [m] on a wide circle along the walls, with wide baselines, for color alone."""
    yaw = 2 * math.pi * fraction + 0.35
    pitch = math.radians(-14 + 6 * math.sin(6 * math.pi * fraction))
    position = (-1.35 * math.cos(yaw), -1.08 * math.sin(yaw), 1.5 + 0.12 * math.sin(4 * math.pi * fraction))
    return hand_held(fraction, position, yaw, pitch)


def hand_held(fraction: float, position: tuple[float, float, float], yaw: float, pitch: float) -> NDArray[np.float64]:
    """A pose from the floor center with hand tremor of 3 mm and 0.2 degrees at about 1 Hz, periodic over the loop."""
    a = 2 * math.pi * fraction
    tremble = 0.003 * np.sin([19 * a + 0.3, 23 * a + 1.1, 17 * a + 2.0])
    yaw += math.radians(0.2) * math.sin(21 * a + 0.7)
    pitch += math.radians(0.2) * math.sin(18 * a + 0.1)
    eye = np.array([ROOM_SIZE[0] / 2, ROOM_SIZE[1] / 2, 0.0]) + position + tremble
    return look_along(eye, (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch)))


DEPTH_SCALE = 1000.0  # noisy depth is stored in integer millimeters
COLOR_NOISE = 2.0  # [of 255] standard deviation of color noise with texture, as of a phone camera indoors


@dataclasses.dataclass(frozen=True, eq=False, kw_only=True)
class RoomFrame(Frame):
    """A frame of the room, with `intrinsic`. Depth is uint16 [mm] with noise and float32 [m] without."""

    T_world_camera: NDArray[np.float64]
    intrinsic: PinholeCameraIntrinsic


class RoomSequence:
    """Frames of the room, rendered when read, with `intrinsic` and `depth_scale` (1000 with noise, else 1)."""

    def __init__(
        self,
        frame_count: int,
        intrinsic: PinholeCameraIntrinsic,
        seed: int,
        noise: bool,
        device: DeviceLike,
        path: Callable[[float], NDArray[np.float64]] = room_pose,
        texture: float = 0.0,
        color_noise: float = 0.0,
    ):
        self.frame_count, self.intrinsic, self.seed, self.noise = frame_count, intrinsic, seed, noise
        self._texture, self._color_noise = texture, color_noise
        self.depth_scale = DEPTH_SCALE if noise else 1.0
        self.room, self.path = _cached_room(str(device), current_cpu_compiler()), path

    def __len__(self) -> int:
        return self.frame_count

    def __iter__(self) -> Iterator[RoomFrame]:
        return (self.read(i) for i in range(self.frame_count))

    @property
    def poses(self) -> NDArray[np.float64]:
        """The true poses of all frames, camera to world, shape (n, 4, 4) [m], without rendering."""
        return np.array([self.path(i / self.frame_count) for i in range(self.frame_count)])

    def read(self, index: int) -> RoomFrame:
        """Render a frame. The same index always gives the same frame."""
        if not 0 <= index < self.frame_count:
            raise IndexError(f"index: expected 0 to {self.frame_count - 1}, got {index}")
        T = self.path(index / self.frame_count)
        depth, color = self.images(self.room, T, index)
        return self.frame(index, T, depth, color)

    def images(
        self, room: Room, T_world_camera: NDArray[np.float64], index: int
    ) -> tuple[NDArray[Any], NDArray[np.uint8]]:
        """Measured depth and color of a room at a pose, without color noise."""
        width, height = self.intrinsic.width, self.intrinsic.height
        depth, incidence, colors = self._look(room, T_world_camera)
        if self.noise:
            depth = measure_depth(depth, incidence, width, height, seed=self.seed, frame=index)
        values = np.array(download(depth), np.float32).reshape(height, width)  # sync
        measured = np.rint(values * DEPTH_SCALE).astype(np.uint16) if self.noise else values
        return measured, np.array(download(colors), np.uint8).reshape(height, width, 3)

    def frame(
        self, index: int, T: NDArray[np.float64], depth: NDArray[Any], color: NDArray[np.uint8] | None, **time: float
    ) -> RoomFrame:
        """A frame of images, with color noise added."""
        if self._color_noise and color is not None:
            color = self._with_noise(index, color)
        name = f"frame-{index:06d}"
        return RoomFrame(depth=depth, color=color, T_world_camera=T, intrinsic=self.intrinsic, name=name, **time)

    def _look(self, room: Room, T_world_camera: NDArray[np.float64]) -> tuple[Any, Any, Any]:
        """Depth, incidence and colors of a view, as `Room.render`, with surface texture if requested."""
        depth, incidence, colors = room.render(self.intrinsic, T_world_camera)
        if self._texture:
            plain, colors = colors, grain_pixels(self.intrinsic, T_world_camera, depth, colors)
            if self._texture < 1:
                mixed = self._texture * np.array(download(colors), np.float32)  # sync
                mixed += (1 - self._texture) * np.array(download(plain), np.float32)
                colors = upload(np.rint(mixed).astype(np.uint8), uint8, self.room.device)
        return depth, incidence, colors

    def _with_noise(self, index: int, color: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Add sensor noise, after all other effects."""
        light = upload(np.ascontiguousarray(color).reshape(-1), uint8, self.room.device)
        noisy = measure_colors(light, sigma=self._color_noise, seed=self.seed, frame=index)
        return np.array(download(noisy), np.uint8).reshape(color.shape)  # sync


@functools.lru_cache(maxsize=2)
def _cached_room(device: str, compiler: str) -> Room:
    """The cached room of a device. Its lighting takes seconds to compute."""
    return build_room(resolve_device(device))


def room_sequence(
    frame_count: int = 120,
    *,
    width: int = 640,
    height: int = 480,
    seed: int = 0,
    noise: bool = True,
    texture: bool | float = False,
    color_noise: float | None = None,
    device: DeviceLike = "cpu",
) -> RoomSequence:
    """RGB-D frames of the furnished room along a smooth walk.

    Args:
        frame_count: Frames of the whole walk of four rounds. 120 are 12 to 15 degrees and about 15 cm apart.
        width: Columns [px].
        height: Rows [px]. The focal length is 525 px at 640 columns, as of PrimeSense cameras.
        seed: Seed of the noise.
        noise: Depth noise of a structured-light camera (Nguyen et al. 2012: 1.2 mm standard deviation near, 14 mm at 3
            m; holes at grazing angles and edges, whole millimeters). Without noise, depth is exact.
        texture: Add texture of 12 cm to 15 mm for feature matching. A number in 0..1 scales its contrast.
        color_noise: Standard deviation of the color noise [of 255]. None: 2 with texture, else 0.
        device: Device that renders.

    Returns:
        A lazy sequence of `RoomFrame`, bitwise reproducible on one device.
    """
    frame_count, seed = check_count("frame_count", frame_count), check_count("seed", seed, minimum=0)
    camera, where = prime_sense_camera(width, height), resolve_device(device)
    return RoomSequence(frame_count, camera, seed, bool(noise), where, **grain_options(texture, color_noise))


def room_views(
    poses: Any,
    intrinsic: PinholeCameraIntrinsic,
    *,
    seed: int = 0,
    noise: bool = False,
    texture: bool | float = True,
    color_noise: float | None = None,
    device: DeviceLike = "cpu",
) -> RoomSequence:
    """RGB-D frames of the furnished room (5 x 4 x 2.6 m, corner at the origin) from given poses.

    Args:
        poses: Camera to world, shape (n, 4, 4) [m], n >= 1.
        intrinsic: The camera of all frames.
        seed, noise, texture, color_noise, device: As `room_sequence`.
    """
    matrices = [check_rigid(f"poses[{i}]", T) for i, T in enumerate(check_list("poses", poses, "poses"))]
    if not matrices:
        raise ValueError("poses: expected at least one, got none")
    frame_count = len(matrices)
    seed, where = check_count("seed", seed, minimum=0), resolve_device(device)

    def path(fraction: float) -> NDArray[np.float64]:
        return matrices[min(round(fraction * frame_count), frame_count - 1)]

    camera = check_camera("intrinsic", intrinsic)
    return RoomSequence(frame_count, camera, seed, bool(noise), where, path, **grain_options(texture, color_noise))


def grain_options(texture: Any, color_noise: Any) -> dict[str, Any]:
    fraction = check_fraction("texture", float(texture) if isinstance(texture, bool) else texture)
    return {"texture": fraction, "color_noise": _checked_noise(color_noise, texture)}


def _checked_noise(color_noise: Any, texture: Any) -> float:
    if color_noise is None:
        return COLOR_NOISE if texture else 0.0
    value = check_number("color_noise", color_noise)
    if not 0 <= value <= 255:
        raise ValueError(f"color_noise: expected 0 to 255, got {value}")
    return value


def prime_sense_camera(width: int, height: int) -> PinholeCameraIntrinsic:
    width, height = check_count("width", width), check_count("height", height)
    focal = 525.0 * width / 640
    return PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)


def surface_errors(points: Any, *, device: DeviceLike = "cpu") -> NDArray[np.float64]:
    """Distance of points from the room's true surface, shape (n,) float64 [m]. NaN for non-finite points.

    Exact in the air; inside solids deeper than their thickness, a lower bound.

    Example:
        >>> surface_errors([[2.5, 3.0, 1.9], [1.0, 3.5, 2.59]]).round(3).tolist()
        [0.7, 0.01]
    """
    values = check_rows("points", points, 3, dtype=np.float64)
    solids = furnished_room().solids(resolve_device(device))
    distances = distance_to_solids(upload(values, vec3d, solids.device), solids)
    return np.abs(download(distances))  # sync


def write_room_sequence(
    folder: FilePath,
    *,
    frame_count: int = 120,
    width: int = 640,
    height: int = 480,
    seed: int = 0,
    device: DeviceLike = "cpu",
) -> None:
    """Write the noisy frames of the room atomically as a folder in the 7-Scenes layout with camera-intrinsics.json."""
    folder = path_of(folder, "folder")
    if folder.exists():
        raise FileError(folder, "exists already", remedy="Give the name of a new folder")
    if not folder.absolute().parent.is_dir():
        raise FileError(folder, f"the folder {folder.absolute().parent} does not exist", remedy="Make it first")
    sequence = room_sequence(frame_count, width=width, height=height, seed=seed, device=device)
    try:
        part = part_name(folder)
        part.mkdir()
    except OSError as error:
        raise FileError(folder, f"cannot be created: {error.strerror or error}") from error
    try:
        write_pinhole_camera_intrinsic(part / "camera-intrinsics.json", sequence.intrinsic)
        for frame in sequence:
            depth = np.asarray(frame.depth, np.uint16)
            write_png(part / f"{frame.name}.depth.png", depth)
            assert frame.color is not None
            write_png(part / f"{frame.name}.color.png", frame.color)
            pose = check_rigid("T_world_camera", frame.T_world_camera)
            rows = ("\t".join(f"{value:.17g}" for value in row) for row in pose)
            (part / f"{frame.name}.pose.txt").write_text("\n".join(rows) + "\n", encoding="utf-8")
        part.rename(folder)
    except OSError as error:
        raise FileError(folder, f"cannot be written: {error.strerror or error}") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)
