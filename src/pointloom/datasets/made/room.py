"""The furnished room (scenes/room.py) as RGB-D frames, as a cloud and as a mesh."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.images import RGBDImage
from ...core.checks import check_count, check_positive, check_seed
from ...core.devices import resolve_device
from ...kernels.lang import vec3d
from ...kernels.linear_algebra import inv
from ...kernels.memory import download, upload
from ...kernels.scenes.primitives import distance_to_solids
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.volume.tsdf import TSDFVolume
from ...pcd.cloud import PointCloud
from ..array_cache import Arrays, cached
from ..scenes.furniture import ROOM_SIZE, furnished_room
from ..scenes.room import COLOR_NOISE, DEPTH_SCALE, RoomFrame, film_pose, look_along, room_pose, room_views, round_pose

FRAMES_OF_A_ROUND = 120  # frames per circle of `room_frames`: 3 degrees and about 7 cm apart
FIRST_FRAME = 44  # on the circle: looks at the sofa
TEXTURE_CONTRAST = 0.25  # fraction of the full texture contrast: enough for matching, and walls still look painted
VIEW_COUNT = 100  # number of views for the cloud and the mesh
CORNER_POSITIONS = ((4.5, 3.6), (4.6, 0.5), (0.4, 0.7), (0.4, 3.6))  # [m] x and y of views down from near the corners
VIEW_SIZE = (320, 240)  # [px]
MAX_DEPTH = 6.0  # [m] larger than any distance of walls
SCAN_NOISE = 0.0015  # [m] standard deviation of the cloud's points before downsampling
NORMAL_STEP = 1e-3  # [m] finite difference step of normals
MESH_VOXEL = 0.02  # [m]
MESH_TRIANGLES = 250_000


def room_frames(
    count: int = 24, *, width: int = 320, height: int = 240, noise: bool = True, seed: int = 0
) -> list[RoomFrame]:
    """Synthetic RGB-D frames of a camera that moves through a furnished room, with true poses.

    The room is 5 x 4 x 2.6 m: x along the long wall, y into the room, z up, its corner at the origin. Frames are 3
    degrees and about 5 cm apart. 120 are a full circle.

    Args:
        count: Number of frames. The first ones do not depend on it.
        width: Columns [px].
        height: Rows [px]. The focal length is 525 px at 640 columns.
        noise: Simulate a structured-light camera: depth noise of 1.2 mm near and 14 mm at 3 m, holes at grazing angles,
            whole millimeters. Color noise of 2 of 255. Without it both are exact.
        seed: Seed of the noise.

    Returns:
        Frozen records with `color` uint8 (h, w, 3), `depth` float32 (h, w) [m] along the optical axis, 0 without
        measurement, `intrinsic`, and the true `T_world_camera` float64 (4, 4) [m], camera to world (x right, y down, z
        forward).

    Raises:
        TypeError: Counts that are not integers.
        ValueError: Counts below 1.

    Notes:
        Bitwise reproducible. Cached in the user's cache folder if it took long.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> frame = loom.datasets.room_frames(2, width=64, height=48)[1]
        >>> image = loom.RGBDImage(frame.color, frame.depth)
        >>> cloud = loom.PointCloud.create_from_rgbd_image(image, frame.intrinsic, np.linalg.inv(frame.T_world_camera))
        >>> bool((cloud.points[:, 2] < 2.7).all())
        True
    """
    count, width, height = check_count("count", count), check_count("width", width), check_count("height", height)
    noise, seed = bool(noise), check_seed(seed)
    parameters = {"count": count, "width": width, "height": height, "noise": noise, "seed": seed}
    camera = _camera(width, height)
    poses = [film_pose((FIRST_FRAME + i) % FRAMES_OF_A_ROUND / FRAMES_OF_A_ROUND) for i in range(count)]

    def make() -> Arrays:
        sigma = COLOR_NOISE if noise else 0.0
        frames = list(room_views(poses, camera, seed=seed, noise=noise, texture=TEXTURE_CONTRAST, color_noise=sigma))
        return {"depth": np.array([f.depth for f in frames]), "color": np.array([f.color for f in frames])}

    arrays = cached("room_frames", parameters, make)
    return [
        RoomFrame(depth=_metres(depth), color=color, T_world_camera=pose, intrinsic=camera, name=f"frame-{index:06d}")
        for index, (depth, color, pose) in enumerate(zip(arrays["depth"], arrays["color"], poses, strict=True))
    ]


def room_cloud(*, voxel_size: float = 0.02, seed: int = 0) -> PointCloud:
    """The furnished room as a colored cloud with normals, without surfaces hidden from the middle of the room.

    Args:
        voxel_size: Voxel size of the downsampling [m].
        seed: Seed of the noise: 1.5 mm per measurement, before averaging in voxels.

    Returns:
        Points [m] in the frame of `room_frames`, `colors`, and true unit `normals` that point into the room.

    Raises:
        TypeError, ValueError: No positive size.

    Notes:
        Bitwise reproducible. Cached in the user's cache folder if it took long.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.datasets.room_cloud(voxel_size=0.1)
        >>> cloud.points.max(axis=0).round(0).tolist(), cloud.has_normals()
        ([5.0, 4.0, 3.0], True)
    """
    voxel_size, seed = check_positive("voxel_size", voxel_size), check_seed(seed)

    def make() -> Arrays:
        parts = [_seen_points(frame) for frame in _views()]
        points = np.concatenate([part.points for part in parts])
        points += np.random.default_rng(seed).normal(0.0, SCAN_NOISE, points.shape)
        complete = PointCloud(points, colors=np.concatenate([part.colors for part in parts]))
        thin = complete.voxel_down_sample(voxel_size)
        return {"points": thin.points, "colors": thin.colors, "normals": _true_normals(thin.points)}

    return PointCloud(**cached("room_cloud", {"voxel_size": voxel_size, "seed": seed}, make))


def room_mesh() -> TriangleMesh:
    """The furnished room as a colored mesh, fused from exact views at 2 cm.

    Returns:
        Vertices [m] in the frame of `room_frames`, with colors and normals. Open where no camera saw.

    Notes:
        Bitwise reproducible. Cached in the user's cache folder if it took long.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.datasets.room_mesh()
        >>> mesh.has_vertex_colors(), len(mesh) > 100_000
        (True, True)
    """

    def make() -> Arrays:
        volume = TSDFVolume(voxel_size=MESH_VOXEL, truncation=3 * MESH_VOXEL)
        for frame in _views():
            T = inv(frame.T_world_camera)
            volume.integrate(frame.depth, frame.intrinsic, T, frame.color, depth_scale=1.0, depth_max=MAX_DEPTH)
        mesh = volume.extract_triangle_mesh(weight_threshold=0.0)
        mesh = mesh.simplify_quadric_decimation(MESH_TRIANGLES).compute_vertex_normals()
        names = ("vertices", "triangles", "vertex_colors", "vertex_normals")
        return {name: getattr(mesh, name) for name in names}

    return TriangleMesh(**cached("room_mesh", {}, make))


def _camera(width: int, height: int) -> PinholeCameraIntrinsic:
    focal = 525.0 * width / 640
    return PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)


def _metres(depth: NDArray[Any]) -> NDArray[np.float32]:
    scale = DEPTH_SCALE if depth.dtype == np.uint16 else 1.0
    return (depth / np.float32(scale)).astype(np.float32)


def _views() -> Iterator[RoomFrame]:
    """Exact frames from all sides: around the middle, along the walls and down from the ceiling."""
    poses = [_survey_pose(i) for i in range(VIEW_COUNT)]
    return iter(room_views(poses, _camera(*VIEW_SIZE), texture=TEXTURE_CONTRAST, color_noise=0.0))


def _survey_pose(index: int) -> NDArray[np.float64]:
    """Five interleaved paths: two walks, near the ceiling, near the floor, and down from the corners."""
    fraction, kind = index / VIEW_COUNT, index % 5
    if kind < 2:
        return (room_pose, round_pose)[kind](fraction)
    if kind == 4:
        x, y = CORNER_POSITIONS[index // 5 % 4]
        offset = (index // 20 % 5 - 2) * 0.3
        yaw, height, pitch = math.atan2(ROOM_SIZE[1] / 2 - y, ROOM_SIZE[0] / 2 - x) + offset, 2.25, -0.75
    else:
        wide, deep, height, pitch = ((1.6, 1.2, 2.35, -0.75), (0.9, 0.8, 0.6, 0.05))[kind - 2]
        yaw = 4 * math.pi * fraction
        x, y = ROOM_SIZE[0] / 2 - wide * math.cos(yaw), ROOM_SIZE[1] / 2 - deep * math.sin(yaw)
    direction = (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch))
    return look_along(np.array([x, y, height]), direction)


def _seen_points(frame: RoomFrame) -> PointCloud:
    """The points of an exact frame in room coordinates."""
    assert frame.color is not None
    image = RGBDImage(frame.color, frame.depth, depth_scale=1.0, depth_trunc=MAX_DEPTH)
    return PointCloud.create_from_rgbd_image(image, frame.intrinsic, inv(frame.T_world_camera))


def _true_normals(points: NDArray[np.float64]) -> NDArray[np.float32]:
    """Gradient of the distance to the room's surface, outward, (n, 3)."""
    solids, slopes = furnished_room().solids(resolve_device("cpu")), []
    for step in NORMAL_STEP * np.eye(3):
        ahead, behind = (
            download(distance_to_solids(upload(points + side, vec3d, "cpu"), solids)) for side in (step, -step)
        )
        slopes.append(ahead - behind)
    normals = np.stack(slopes, axis=1)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    return (normals / np.where(lengths > 0, lengths, 1)).astype(np.float32)
