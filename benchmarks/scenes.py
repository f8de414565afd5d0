"""The data of the benchmarks: synthetic data by formula and seed, and real scans if available."""

from __future__ import annotations

import contextlib
import shutil
import tempfile
import weakref
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from real_data import DataMissingError, real_data

SURFACE_EDGE = 4.0  # [m]
SURFACE_NOISE = 0.002  # [m]


def product(A: NDArray[np.float64], B: NDArray[np.float64]) -> NDArray[np.float64]:
    """`A @ B` for poses or points, bitwise identical on every processor, unlike BLAS."""
    return np.einsum("ij,jk->ik", A, B) if B.ndim == 2 else np.einsum("ij,j->i", A, B)


def inverse(T: NDArray[np.float64]) -> NDArray[np.float64]:
    """The inverse of a rigid transformation, bitwise identical on every processor."""
    back = np.eye(4)
    back[:3, :3], back[:3, 3] = T[:3, :3].T, -product(T[:3, :3].T, T[:3, 3])
    return back


def bumpy_surface(count: int, seed: int = 0) -> NDArray[np.float64]:
    """Points of a bumpy 4 x 4 m surface with 2 mm of noise, float64 [n, 3] with values exact in float32.

    All contestants get the same coordinates, independent of their precision.
    """
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(-SURFACE_EDGE / 2, SURFACE_EDGE / 2, (2, count))
    z = 0.15 * np.sin(3 * x) * np.cos(2 * y) + 0.03 * np.sin(11 * x + 5 * y)
    points = np.stack([x, y, z + rng.normal(0, SURFACE_NOISE, count)], axis=1)
    return _float32_exact(points)


def small_patch(count: int = 1000, seed: int = 0) -> NDArray[np.float64]:
    """About `count` points of the bumpy surface on 0.4 x 0.4 m."""
    points = bumpy_surface(100 * count, seed)
    return points[(np.abs(points[:, :2]) < SURFACE_EDGE / 20).all(axis=1)]


def spinning_scan(count: int = 100_000, seed: int = 0) -> NDArray[np.float64]:
    """A spinning LiDAR scan of a street, float64 [n, 3]: the point density varies more than a thousandfold.

    64 beams from +2 to -24.8 degrees, 1.73 m above the road; road, two rows of houses with gaps, tree trunks and
    cars; range
    noise 2 cm; maximum range 120 m.
    """
    rng = np.random.default_rng(seed)
    beams, rays = 64, -(-count * 5 // (64 * 3))
    elevation = np.radians(np.linspace(2.0, -24.8, beams))[:, None]
    azimuth = np.linspace(0, 2 * np.pi, rays, endpoint=False)[None, :]
    directions = np.stack(
        [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation) + 0 * azimuth], -1
    ).reshape(-1, 3)
    with np.errstate(divide="ignore", invalid="ignore"):
        distances = np.where(directions[:, 2] < 0, -1.73 / directions[:, 2], np.inf)
        for side in (-9.0, 11.0):
            along = side / directions[:, 1]
            at = along[:, None] * directions
            is_building = (along > 0) & (at[:, 2] < 7) & (np.abs(np.sin(at[:, 0] / 13)) > 0.25)
            distances = np.where(is_building & (along < distances), along, distances)
        cylinders = [(x, y, 0.25) for x in range(-60, 61, 12) for y in (-6.5, 8.0)]
        cylinders += [(4.0, 2.5, 0.9), (-7.0, -3.0, 0.9), (18.0, 2.6, 0.9), (-25.0, -3.2, 0.9), (2.2, -2.0, 0.15)]
        a = directions[:, 0] ** 2 + directions[:, 1] ** 2
        for x, y, radius in cylinders:
            b = directions[:, 0] * x + directions[:, 1] * y
            discriminant = b * b - a * (x * x + y * y - radius * radius)
            along = (b - np.sqrt(discriminant)) / a
            hit = (discriminant > 0) & (along > 0) & (along < distances) & (along * directions[:, 2] < 1.0)
            distances = np.where(hit, along, distances)
    returned = np.flatnonzero((distances > 1.0) & (distances < 120))
    if len(returned) < count:
        raise RuntimeError(f"{len(returned)} of {count} rays have a return")
    returned = np.sort(rng.choice(returned, count, replace=False))
    ranges = distances[returned] + rng.normal(0, 0.02, count)
    return _float32_exact(ranges[:, None] * directions[returned])


def real_scan(*, zeros: bool = True) -> NDArray[np.float64]:
    """A real LiDAR scan from the folder `POINTLOOM_DATA`, float64 [n, 3].

    In some files rays without a return are at (0, 0, 0): thousands of equal points. `zeros` keeps them.
    """
    path = real_scan_path()
    if path.suffix == ".ply":
        from pointloom import read_point_cloud

        points = _float32_exact(read_point_cloud(path).points)
    else:
        points = _float32_exact(np.fromfile(path, np.float32).reshape(-1, 4)[:, :3])
    return points if zeros else points[points.any(axis=1)]


def real_scan_path() -> Path:
    """The file of a real LiDAR scan; raises DataMissingError if there is none."""
    try:
        return real_data("reg-small-gicp/target.ply")
    except DataMissingError:
        with contextlib.suppress(DataMissingError, StopIteration):
            return next(iter(sorted(real_data("lidar-kitti-frame").rglob("*.bin"))))
        raise


# ------------------------------------------------------------------------------------------------ depth frames


@dataclass(frozen=True)
class Frames:
    """Posed depth frames of one camera.

    Attributes:
        depths: uint16 [n, h, w], millimeters.
        extrinsics: T_camera_world, float64 [n, 4, 4].
        intrinsic: fx, fy, cx, cy [pixel].
    """

    depths: NDArray[np.uint16]
    extrinsics: NDArray[np.float64]
    intrinsic: tuple[float, float, float, float]

    def __len__(self) -> int:
        return len(self.depths)

    @property
    def matrix(self) -> NDArray[np.float64]:
        """The intrinsic as a matrix, shape [3, 3]."""
        fx, fy, cx, cy = self.intrinsic
        return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1.0]])


# Walls are offset by half a voxel of 1 cm from the grid: on a sample plane noise alone would determine the triangles.
ROOM = np.array([[-3.005, -2.405, -1.405], [3.005, 2.405, 1.405]])  # [m]
SPHERES = ((1.8, 0.5, -0.7, 0.6), (1.0, 1.4, -0.4, 0.4), (2.2, 1.6, 0.5, 0.4), (0.2, 1.9, 0.3, 0.3))  # x y z r [m]
DEPTH_NOISE = 0.002  # of the depth


def room_frames(count: int = 30, width: int = 640, height: int = 480, seed: int = 0) -> Frames:
    """Ray cast depth frames of a room with spheres; the camera rotates by 3 degrees per frame."""
    rng = np.random.default_rng(seed)
    focal = 525.0 * width / 640
    intrinsic = (focal, focal, (width - 1) / 2, (height - 1) / 2)
    v, u = np.mgrid[:height, :width].astype(np.float32)
    rays = np.stack([(u - intrinsic[2]) / focal, (v - intrinsic[3]) / focal, np.ones_like(u)], -1).reshape(-1, 3)
    depths = np.empty((count, height, width), np.uint16)
    extrinsics = np.empty((count, 4, 4))
    for k in range(count):
        angle = 2 * np.pi * k / 120
        pose = _look(np.array([0.3 * np.cos(angle), 0.3 * np.sin(angle), 0.1]), angle, tilt=0.2 * np.sin(3 * angle))
        rotation = pose[:3, :3].astype(np.float32)
        depth = _cast_room(
            pose[:3, 3], np.einsum("ij,kj->ik", rays, rotation)
        )  # rays have z = 1: their parameter is the depth
        depth *= 1 + DEPTH_NOISE * rng.standard_normal(depth.shape, np.float32)
        depths[k] = np.round(1000 * depth).reshape(height, width)
        extrinsics[k] = inverse(pose)
    return Frames(depths, extrinsics, intrinsic)


def _look(position: NDArray[np.float64], angle: float, tilt: float) -> NDArray[np.float64]:
    """T_world_camera of a camera (x right, y down, z forward) that looks in a direction of the xy plane."""
    ahead = np.array([np.cos(angle) * np.cos(tilt), np.sin(angle) * np.cos(tilt), np.sin(tilt)])
    right = np.cross(ahead, [0, 0, 1.0])
    right /= np.sqrt((right * right).sum())
    pose = np.eye(4)
    pose[:3, :3] = np.stack([right, np.cross(ahead, right), ahead], axis=1)
    pose[:3, 3] = position
    return pose


def _cast_room(origin: NDArray[np.float64], rays: NDArray[np.float32]) -> NDArray[np.float32]:
    depth = np.full(len(rays), np.inf, np.float32)
    with np.errstate(divide="ignore", invalid="ignore"):
        for axis in range(3):
            ray = np.ascontiguousarray(rays[:, axis])
            wall = np.where(ray > 0, np.float32(ROOM[1, axis] - origin[axis]), np.float32(ROOM[0, axis] - origin[axis]))
            np.fmin(depth, wall / ray, out=depth)
        a = np.einsum("ij,ij->i", rays, rays)
        for x, y, z, radius in SPHERES:
            to_center = (np.array([x, y, z]) - origin).astype(np.float32)
            b = np.einsum("ij,j->i", rays, to_center)
            discriminant = b * b - a * ((to_center * to_center).sum() - np.float32(radius * radius))
            hits = np.flatnonzero((discriminant > 0) & (b > 0))
            along = (b[hits] - np.sqrt(discriminant[hits])) / a[hits]
            depth[hits] = np.fmin(depth[hits], along)
    return depth


# ------------------------------------------------------------------------------------------------ fields, files


def wavy_ball(count: int) -> NDArray[np.float32]:
    """The sampled distance function of a wavy sphere, float32 [count, count, count] over [-1, 1]^3."""
    x = np.linspace(-1, 1, count, dtype=np.float32)
    x, y, z = np.meshgrid(x, x, x, indexing="ij", sparse=True)
    sines = [np.sin(k * side.astype(np.float64)).astype(np.float32) for k, side in ((9, x), (8, y), (7, z))]
    waves = np.float32(0.05) * sines[0] * sines[1] * sines[2]
    return (np.sqrt(x * x + y * y + z * z) - np.float32(0.7) + waves).astype(np.float32)


@dataclass
class ColoredPoints:
    """Points and colors in memory and in a binary PLY file (float x y z, uchar red green blue).

    Attributes:
        points: float32 [n, 3].
        colors: uint8 [n, 3].
    """

    points: NDArray[np.float32]
    colors: NDArray[np.uint8]
    folder: str = field(default_factory=lambda: tempfile.mkdtemp(prefix="bench-ply-"))

    def __post_init__(self):
        weakref.finalize(self, shutil.rmtree, self.folder, ignore_errors=True)

    def path(self, name: str) -> str:
        """A file in the scene's own folder, removed with the scene."""
        return str(Path(self.folder) / f"{name}.ply")

    @property
    def source(self) -> str:
        """The file of these points, written with NumPy on first use."""
        path = Path(self.path("source"))
        if not path.exists():
            row = np.dtype([("points", "<f4", 3), ("colors", "u1", 3)])
            rows = np.empty(len(self.points), row)
            rows["points"], rows["colors"] = self.points, self.colors
            lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(rows)}"]
            lines += [f"property float {n}" for n in "xyz"] + [f"property uchar {n}" for n in ("red", "green", "blue")]
            with path.open("wb") as file:
                file.write("\n".join([*lines, "end_header", ""]).encode())
                rows.tofile(file)
        return str(path)


def colored_points(count: int, seed: int = 0) -> ColoredPoints:
    """Points of the bumpy surface with random colors."""
    colors = np.random.default_rng(seed + 1).integers(0, 256, (count, 3), np.uint8)
    return ColoredPoints(bumpy_surface(count, seed).astype(np.float32), colors)


def _float32_exact(points: NDArray[np.float64] | NDArray[np.float32]) -> NDArray[np.float64]:
    return np.ascontiguousarray(points, dtype=np.float32).astype(np.float64)
