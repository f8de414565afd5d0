"""A made-up scan of a furnished room, with its truth: RGB-D frames, poses, and the distance of any point from the room.

The room is furniture.py's. A camera walks four rounds through it: along the furniture, along the ceiling, and twice
across the room from farther out. Everything is a function of the frame number and the seed.
"""

from __future__ import annotations

import dataclasses
import math
import os
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kernels.lang import vec3d
from ..kernels.memory import download, upload
from ..kernels.scenes.depth_noise import measure_depth
from ..kernels.scenes.primitives import distance_to_solids
from ..pcd.camera import PinholeCameraIntrinsic, write_pinhole_camera_intrinsic
from ..pcd.checks import check_count, check_rigid, check_rows
from ..pcd.devices import resolve_device
from ..pcd.errors import FileError
from ..pcd.io.image_files import write_png
from .furniture import SIZE, build_room, furnished_room

ROUNDS = 4
DEPTH_SCALE = 1000.0  # noisy depth is stored in whole millimetres


@dataclasses.dataclass(frozen=True, eq=False)
class RoomFrame:
    """A frame of the room.

    Args:
        depth: Shape [h, w]: uint16 in millimetres, 0 where nothing was measured; without noise float32 in metres.
        color: Shape [h, w, 3], uint8 RGB.
        T_world_camera: Camera to world, shape [4, 4] [m]; the true pose.
        intrinsic: The camera of both pictures.
        name: Name of the frame, as in its file names.
    """

    depth: NDArray[np.uint16] | NDArray[np.float32]
    color: NDArray[np.uint8]
    T_world_camera: NDArray[np.float64]
    intrinsic: PinholeCameraIntrinsic
    name: str


class RoomSequence:
    """Frames of the furnished room, rendered one at a time as they are asked for; see `room_sequence`.

    Attributes:
        intrinsic: The camera of all frames.
        depth_scale: Stored depth of one metre: 1000 with noise, 1 without.
    """

    def __init__(self, frame_count: int, intrinsic: PinholeCameraIntrinsic, seed: int, noise: bool, device: Any):
        self.frame_count, self.intrinsic, self.seed, self.noise = frame_count, intrinsic, seed, noise
        self.depth_scale = DEPTH_SCALE if noise else 1.0
        self._room = build_room(device)

    def __len__(self) -> int:
        return self.frame_count

    def __iter__(self) -> Iterator[RoomFrame]:
        return (self.read(i) for i in range(self.frame_count))

    def read(self, index: int) -> RoomFrame:
        """Frame `index`, counted from 0; the same each time it is asked for.

        Raises:
            IndexError: No such frame.
        """
        if not 0 <= index < self.frame_count:
            raise IndexError(f"index: expected 0 to {self.frame_count - 1}, got {index}")
        camera = self.intrinsic
        width, height = camera.width, camera.height
        T = room_pose(index / self.frame_count)
        depth, incidence, colors = self._room.render(camera, T)
        if self.noise:
            depth = measure_depth(depth, incidence, width, height, seed=self.seed, frame=index)
        values = np.array(download(depth), np.float32).reshape(height, width)  # sync
        measured = np.rint(values * DEPTH_SCALE).astype(np.uint16) if self.noise else values
        color = np.array(download(colors), np.uint8).reshape(height, width, 3)
        return RoomFrame(measured, color, T, camera, f"frame-{index:06d}")


def room_sequence(
    frame_count: int = 120,
    *,
    width: int = 640,
    height: int = 480,
    seed: int = 0,
    noise: bool = True,
    device: Any = "cpu",
) -> RoomSequence:
    """RGB-D frames of the furnished room along a smooth walk.

    Args:
        frame_count: Frames of the whole walk of four rounds; 120 are 12 to 15 degrees and some 15 cm apart.
        width: Columns [px].
        height: Rows [px]; the focal length is 525 px at 640 columns, as of PrimeSense cameras.
        seed: Chooses the noise.
        noise: Depth as of a structured-light camera (Nguyen et al. 2012: 1.2 mm standard deviation near, 14 mm at 3 m;
            nothing at grazing angles, little beside edges, whole millimetres). Without it depth is exact.
        device: Where to render.

    Returns:
        A sequence of `RoomFrame`: iterate, or `read(i)`.

    Raises:
        TypeError: Counts or a seed that are not whole numbers.
        ValueError: Counts below 1.
        DeviceError: No such device.

    Notes:
        Same bits from run to run on one device. Frames are rendered when they are read and not kept.
    """
    frame_count, width, height = (
        check_count(name, value) for name, value in (("frame_count", frame_count), ("width", width), ("height", height))
    )
    seed = check_count("seed", seed, minimum=0)
    focal = 525.0 * width / 640
    intrinsic = PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
    return RoomSequence(frame_count, intrinsic, seed, bool(noise), resolve_device(device))


def room_pose(share: float) -> NDArray[np.float64]:
    """Camera to world [m] after a share of the walk, 0 to 1: x right, y down, z forward in the camera.

    The camera walks about the middle, first before and then behind it, 2 to 3 m from most of what it sees; in the last
    round it looks aside, which shows what stood behind the furniture.
    """
    angle = 2 * math.pi * ROUNDS * share + 0.35
    behind = _blend(share, (0.0, 0.22, 0.34, 0.50, 0.58, 1.0), (-0.45, -0.25, 0.55, 0.65, 1.35, 1.45))
    pitch = math.radians(_blend(share, (0.0, 0.22, 0.30, 0.50, 0.57, 1.0), (-20.0, -19.0, 27.0, 27.0, -28.0, -30.0)))
    height = _blend(share, (0.0, 0.50, 0.58, 1.0), (1.5, 1.4, 1.65, 1.75))
    x, y = SIZE[0] / 2 - behind * math.cos(angle), SIZE[1] / 2 - 0.75 * behind * math.sin(angle)
    eye = np.array([x, y, height + 0.05 * math.sin(5 * angle)])
    yaw = angle - math.radians(_blend(share, (0.0, 0.74, 0.82, 1.0), (0.0, 0.0, 55.0, 55.0)))
    return look_along(eye, (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch)))


def look_along(
    eye: NDArray[np.float64], direction: tuple[float, float, float], up: tuple[float, float, float] = (0, 0, 1)
) -> NDArray[np.float64]:
    """Camera to world for a camera at `eye` [m] that looks along a direction, its picture upright."""
    forward = np.asarray(direction, np.float64)
    forward = forward / np.linalg.norm(forward)
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = right, np.cross(forward, right), forward, eye
    return T


def _blend(share: float, places: tuple[float, ...], values: tuple[float, ...]) -> float:
    """Values at some places, joined by curves that are level at each."""
    for a, b, low, high in zip(places, places[1:], values, values[1:], strict=False):
        if share <= b:
            t = (share - a) / (b - a)
            return low + (high - low) * t * t * (3 - 2 * t)
    return values[-1]


def surface_errors(points: Any, *, device: Any = "cpu") -> NDArray[np.float64]:
    """Distance of points from the room's true surface.

    Args:
        points: Shape [n, 3] [m], in the frame of the room.
        device: Where to measure.

    Returns:
        Shape [n], float64 [m], not negative; NaN for points that are not finite. Exact in the room's air; behind a
        surface by more than the solid is thick, a lower bound.

    Raises:
        ValueError: Another shape.

    Example:
        >>> surface_errors([[2.5, 3.0, 1.9], [1.0, 3.5, 2.59]]).round(3).tolist()
        [0.7, 0.01]
    """
    values = check_rows("points", points, 3, dtype=np.float64)
    solids = furnished_room().solids(resolve_device(device))
    distances = distance_to_solids(upload(values, vec3d, solids.device), solids)
    return np.abs(download(distances))  # sync


def write_room_sequence(
    folder: str | os.PathLike[str],
    *,
    frame_count: int = 120,
    width: int = 640,
    height: int = 480,
    seed: int = 0,
    device: Any = "cpu",
) -> None:
    """Write the noisy frames of the room as a folder in the layout of 7-Scenes.

    The folder takes its name when all is written: frame-NNNNNN.depth.png (millimetres), .color.png, .pose.txt, and
    camera-intrinsics.json.

    Raises:
        FileError: The folder exists already, or cannot be made.
        TypeError, ValueError: As `room_sequence`.
    """
    folder = Path(folder)
    if folder.exists():
        raise FileError(folder, "exists already", remedy="Give the name of a new folder")
    if not folder.absolute().parent.is_dir():
        raise FileError(folder, f"the folder {folder.absolute().parent} does not exist", remedy="Make it first")
    sequence = room_sequence(frame_count, width=width, height=height, seed=seed, device=device)
    try:
        part = Path(tempfile.mkdtemp(prefix=f".{folder.name}.", suffix=".part", dir=folder.absolute().parent))
    except OSError as error:
        raise FileError(folder, f"cannot be made: {error.strerror or error}") from error
    try:
        write_pinhole_camera_intrinsic(part / "camera-intrinsics.json", sequence.intrinsic)
        for frame in sequence:
            depth = np.asarray(frame.depth, np.uint16)
            write_png(part / f"{frame.name}.depth.png", depth)
            write_png(part / f"{frame.name}.color.png", frame.color)
            pose = check_rigid("T_world_camera", frame.T_world_camera)
            rows = ("\t".join(f"{value:.17g}" for value in row) for row in pose)
            (part / f"{frame.name}.pose.txt").write_text("\n".join(rows) + "\n")
        part.chmod(0o755)
        part.rename(folder)
    except OSError as error:
        raise FileError(folder, f"cannot be written: {error.strerror or error}") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)
