"""The input data of digests.py, all seeded: clouds sampled twice, frames, volumes, scans."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import scenes
import street
from bench_icp_batch import patches
from bench_pose_graph import INFORMATION, ring
from numpy.typing import NDArray

UTM = np.array([691_000.25, 5_335_000.5, 519.75])  # [m] coordinates where float32 resolves half a meter
WIDTH, HEIGHT = 160, 120  # [px]
REAL_COUNT = 16_001  # points of each sampling of the real scan


def loom() -> Any:
    import pointloom

    return pointloom


def reg() -> Any:
    return loom().registration


@dataclass(eq=False)
class SampledSurface:
    """A surface sampled twice.

    Attributes:
        cloud, other: The samplings.
        spacing: Approximate point spacing [m].
        size: Approximate extent [m].
        middle: Center of the points [m].
    """

    cloud: Any
    other: Any
    spacing: float
    size: float
    middle: NDArray[np.float64]

    @cached_property
    def facing(self) -> Any:
        """The cloud with normals."""
        return self.cloud.estimate_normals(max_nn=12)

    @cached_property
    def pose(self) -> NDArray[np.float64]:
        """T_target_source of `source`: 2 degrees about the center, and a shift of about one point spacing."""
        return about(self.middle, pose_of(2.0, self.spacing * np.array([0.7, -0.5, 0.3])))

    @cached_property
    def source(self) -> Any:
        """The other sampling with normals, moved by the inverse of `pose`."""
        return self.other.estimate_normals(max_nn=12).transform(scenes.inverse(self.pose))

    @property
    def max_distance(self) -> float:
        """Maximum correspondence distance [m]."""
        return 6 * self.spacing

    @property
    def camera(self) -> NDArray[np.float64]:
        """T_camera_world of a camera above the center that looks down."""
        T = np.diag([1.0, -1.0, -1.0, 1.0])
        T[:3, 3] = -scenes.product(T[:3, :3], self.above(0.75))
        return T

    def above(self, fraction: float) -> NDArray[np.float64]:
        """A point above the center, at a fraction of the size."""
        return self.middle + np.array([0, 0, fraction * self.size])

    @property
    def box(self) -> Any:
        return loom().AxisAlignedBoundingBox(self.middle - self.size / 4, self.middle + self.size / 4)

    @property
    def rotated_box(self) -> Any:
        return loom().OrientedBoundingBox(self.middle, pose_of(40.0, np.zeros(3))[:3, :3], [self.size / 2] * 3)

    @property
    def polygon(self) -> Any:
        corners = self.middle + self.size / 4 * np.array([[-1, -1, 0], [1, -1, 0], [0.2, 0, 0], [1, 1, 0], [-1, 1, 0]])
        low, high = self.middle[2] - self.size, self.middle[2] + self.size
        return loom().SelectionPolygonVolume(corners, "Z", low, high)


def pose_of(degrees: float, shift: Any) -> NDArray[np.float64]:
    """A rotation about a slanted axis, then a translation [m]."""
    x, y, z = axis = np.array([0.36, 0.48, 0.8])
    K, angle = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]), np.radians(degrees)
    T = np.eye(4)
    T[:3, :3] = np.cos(angle) * np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * np.outer(axis, axis)
    T[:3, 3] = shift
    return T


ROTATED = pose_of(75.0, [0.5, -0.2, 0.1])  # pose of a pair that is registered globally


def about(middle: NDArray[np.float64], T: NDArray[np.float64]) -> NDArray[np.float64]:
    """A motion about a point other than the origin."""
    moved = T.copy()
    moved[:3, 3] += middle - scenes.product(T[:3, :3], middle)
    return moved


def textured(points: NDArray[np.float64], shift: NDArray[np.float64], device: str) -> Any:
    """Translated points with a color pattern and two attributes."""
    x, y = np.nan_to_num(points[:, :2], posinf=0.0).T
    colors = 0.5 + 0.4 * np.stack([np.sin(4 * x), np.cos(5 * y), np.sin(3 * x + 2 * y)], axis=1)
    intensity = np.round(1000 * colors[:, 0]).astype(np.float32)  # integers, as stored in LAS files
    label = np.arange(len(points), dtype=np.int32) % 7
    return loom().PointCloud(points + shift, colors=colors, device=device, intensity=intensity, label=label)


def soil(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Add NaN and infinite points, duplicates, and a sixth of all points at one position."""
    points, count = points.copy(), len(points)
    points[::97] = np.nan
    points[5::311, 2] = np.inf
    points[count // 2 : count // 2 + count // 10] = points[: count // 10]
    points[-count // 6 :] = points[1]
    return points


class Scenes:
    """The data of all operations, each created from its seed on first use."""

    def __init__(self, device: str):
        self.device = device

    def cloud(self, points: Any, **attributes: Any) -> Any:
        return loom().PointCloud(points, device=self.device, **attributes)

    def sample(
        self, count: int, seed: int, shift: Any = (0, 0, 0), change: Callable[[Any], Any] = np.asarray
    ) -> SampledSurface:
        """A bumpy surface."""
        spots = np.asarray(shift, np.float64)
        both = [textured(change(scenes.bumpy_surface(count, seed + k)), spots, self.device) for k in (0, 1)]
        return SampledSurface(*both, scenes.SURFACE_EDGE / count**0.5, scenes.SURFACE_EDGE, spots)

    @cached_property
    def surface(self) -> SampledSurface:
        return self.sample(40_009, 10)

    @cached_property
    def far(self) -> SampledSurface:
        return self.sample(8_009, 20, UTM)

    @cached_property
    def dirty(self) -> SampledSurface:
        return self.sample(9_001, 30, change=soil)

    @cached_property
    def tiny(self) -> list[SampledSurface]:
        """Clouds of no point, one, two equal ones, three, and five in a plane."""
        points = np.array([[0.3, 0.1, 0.2], [0.3, 0.1, 0.2], [0.5, 0.1, 0.2], [0.3, 0.4, 0.2], [0.6, 0.5, 0.2]])
        rows = [points[:count].reshape(-1, 3) for count in (0, 1, 2, 3, 5)]
        clouds = [textured(few, np.zeros(3), self.device) for few in rows]
        return [SampledSurface(cloud, cloud, 0.2, 0.5, points[0]) for cloud in clouds]

    @cached_property
    def real(self) -> SampledSurface:
        points = scenes.real_scan()
        drawn = np.random.default_rng(35).permutation(len(points))[: 2 * REAL_COUNT]
        both = [self.cloud(points[np.sort(rows)]) for rows in np.split(drawn, 2)]
        return SampledSurface(*both, 0.1, 20.0, np.zeros(3))

    @cached_property
    def plane(self) -> SampledSurface:
        """A plane, which does not constrain all motions."""
        points = np.random.default_rng(40).uniform(-1, 1, (2, 2000, 3)) * [1, 1, 0.001]
        return SampledSurface(*map(self.cloud, points), 0.045, 2.0, np.zeros(3))

    @cached_property
    def thinned(self) -> list[Any]:
        """Two overlapping parts of the surface, 75 degrees apart, down-sampled, with normals."""
        points = [scenes.bumpy_surface(20_000, 50), scenes.bumpy_surface(20_000, 51)]
        parts = [points[0][points[0][:, 0] < 0.7], points[1][points[1][:, 0] > -1.3]]
        source, target = (self.cloud(part).voxel_down_sample(0.06).estimate_normals(max_nn=20) for part in parts)
        up = [c.orient_normals_to_align_with_direction() for c in (source, target)]
        return [up[0].transform(scenes.inverse(ROTATED)), up[1]]

    @cached_property
    def features(self) -> list[NDArray[np.float32]]:
        return [loom().compute_fpfh_feature(cloud, radius=0.3, max_nn=60) for cloud in self.thinned]

    @cached_property
    def matches(self) -> NDArray[np.int32]:
        return reg().correspondences_from_features(*self.features, mutual_filter=True, device=self.device)

    @cached_property
    def fragments(self) -> list[Any]:
        """Four overlapping parts of the surface, each with its own pose."""
        clouds = []
        for k, low in enumerate((-2.0, -1.5, -1.0, -0.5)):
            points = scenes.bumpy_surface(12_000, 60 + k)
            part = points[(points[:, 0] > low) & (points[:, 0] < low + 2.5)]
            clouds.append(self.cloud(part).transform(pose_of(50.0 * k, [k, 0.2, 0])))
        return clouds

    @cached_property
    def patches(self) -> Any:
        """Sources, and targets with normals, of some small pairs."""
        made = patches(20)()
        targets = [self.cloud(p, normals=n) for p, n in zip(made.targets, made.normals, strict=True)]
        return [self.cloud(p) for p in made.sources], targets

    @cached_property
    def frames(self) -> scenes.Frames:
        return scenes.room_frames(4, WIDTH, HEIGHT)

    @cached_property
    def lens(self) -> Any:
        return loom().PinholeCameraIntrinsic(WIDTH, HEIGHT, *self.frames.intrinsic)

    @cached_property
    def paint(self) -> NDArray[np.uint8]:
        """A color image, uint8 [h, w, 3]."""
        v, u = np.mgrid[:HEIGHT, :WIDTH]
        return np.stack([u + v, 3 * u, 255 - 2 * v], axis=-1).astype(np.uint8)

    @cached_property
    def rgbd(self) -> Any:
        return loom().RGBDImage(self.paint, self.frames.depths[0], depth_trunc=6.0, device=self.device)

    def fuse(self, shift: Any = (0, 0, 0), *, color: bool = True) -> tuple[Any, list[int]]:
        """The frames integrated into a volume, and the blocks that each touched."""
        volume = loom().TSDFVolume(voxel_size=0.04, color=color, device=self.device)
        paint, touched = self.paint if color else None, []
        for depth, T in zip(self.frames.depths, self.extrinsics(shift), strict=True):
            touched.append(int(volume.integrate(depth, self.lens, T, paint, depth_max=6.0)))
        return volume, touched

    def fuse_together(self) -> tuple[Any, list[int]]:
        """`fuse` by one call."""
        volume = loom().TSDFVolume(voxel_size=0.04, device=self.device)
        paint = np.stack([self.paint] * len(self.frames.depths))
        frames = self.frames.depths, self.lens, self.extrinsics(), paint
        return volume, [int(count) for count in volume.integrate_frames(*frames, depth_max=6.0)]

    def extrinsics(self, shift: Any = (0, 0, 0)) -> NDArray[np.float64]:
        """T_camera_world of the frames, with the world shifted [m]."""
        Ts = self.frames.extrinsics.copy()
        Ts[:, :3, 3] -= np.einsum("nij,j->ni", Ts[:, :3, :3], np.asarray(shift, np.float64))
        return Ts

    @cached_property
    def volume(self) -> Any:
        return self.fuse()[0]

    @cached_property
    def far_volume(self) -> Any:
        return self.fuse(UTM, color=False)[0]

    @cached_property
    def ball(self) -> Any:
        return loom().meshing.marching_cubes(scenes.wavy_ball(40), spacing=[0.05] * 3, device=self.device)

    @cached_property
    def drive(self) -> street.Drive:
        return street.drive(6, sway=0.2, azimuths=450)

    @cached_property
    def scans(self) -> list[Any]:
        """Scans of the drive with point times."""
        return [self.cloud(p, time=t) for p, t in zip(self.drive.scans, self.drive.times, strict=True)]

    @cached_property
    def doppler(self) -> tuple[Any, Any]:
        """A scan with Doppler velocities, 10 % of them wrong, and the previous scan with normals."""
        rng, points = np.random.default_rng(70), self.drive.scans[1]
        speeds = -10 * points[:, 0] / np.linalg.norm(points, axis=1) + rng.normal(0, 0.1, len(points))
        speeds[::10] += rng.normal(0, 10, len(speeds[::10]))
        return self.cloud(points, dopplers=speeds), self.scans[0].estimate_normals(max_nn=20)

    @cached_property
    def path(self) -> Any:
        """The drive's odometry trajectory with times."""
        return reg().run_odometry(self.scans, voxel_size=1.0, timestamps=street.SCAN_PERIOD * np.arange(6))

    @cached_property
    def true_path(self) -> Any:
        return dataclasses.replace(self.path, poses=self.drive.poses, timestamps=self.path.timestamps + 0.001)

    @cached_property
    def graph(self) -> Any:
        trajectory = ring(60)()
        edges = [reg().PoseGraphEdge(i, j, T, INFORMATION, uncertain) for i, j, T, uncertain in trajectory.edges]
        return reg().PoseGraph([reg().PoseGraphNode(T) for T in trajectory.poses], edges)
