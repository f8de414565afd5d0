"""Whether a change changes a result: a digest of what every operation returns, most of them on several small clouds.

    python benchmarks/digests.py [--compiler taichi|warp] [--device cpu] [--only PREFIX] > before.txt
    python benchmarks/digests.py [the same options] --against before.txt

A change that should change no result changes no bit: run this before it and after it. A line is an operation, the
cloud in brackets, and the first 16 hex digits of the SHA-256 of the result: arrays with element type, shape and all
bytes, objects by their public parts; texts do not count. On clouds of at most five points ([tiny]) an error is a result
too, of which its type counts. With `--against` only lines that differ are shown: before, now. The exit code is 1 where
one differs or an operation fails.

What operations are given is partly made by others: normals, features and matches. Where many lines differ, the first
that does says most.

Only names that users have are called, so the script runs on either side of a change of what lies beneath. Compare runs
of one compiler, device and machine; `POINTLOOM_DATA` adds a real LiDAR scan to both or to neither.
"""

from __future__ import annotations

import argparse
import dataclasses
import hashlib
import os
import pickle
import re
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

import numpy as np  # noqa: E402
import scenes  # noqa: E402
import street  # noqa: E402
from bench_icp_batch import patches  # noqa: E402
from bench_pose_graph import DISTANCE, INFORMATION, ring  # noqa: E402
from numpy.typing import NDArray  # noqa: E402

UTM = np.array([691_000.25, 5_335_000.5, 519.75])  # [m] where float32 resolves half a metre
WIDTH, HEIGHT = 160, 120  # [px]
REAL_COUNT = 16_001  # points of each sampling of the real scan
DIGITS = 16

# Public parts of the results that are neither arrays, nor tuples, nor dataclasses.
PARTS = {
    "AxisAlignedBoundingBox": ("min_bound", "max_bound", "color"),
    "OrientedBoundingBox": ("center", "R", "extent", "color"),
    "PoseGraph": ("nodes", "edges", "report"),
    "RGBDImage": ("color", "depth"),
    "RegistrationResult": (
        "transformation", "fitness", "inlier_rmse", "iterations", "converged", "degenerate_directions",
        "correspondence_set", "score",
    ),
    "TriangleMesh": ("origin", "vertices", "triangles", "vertex_normals", "vertex_colors"),
    "VoxelTrace": ("cloud", "cubic_id", "voxel_of_point", "indices", "offsets"),
}  # fmt: skip


def loom() -> Any:
    import pointloom

    return pointloom


def reg() -> Any:
    return loom().registration


# ------------------------------------------------------------------------------------------------ digests


def digest(result: Any) -> str:
    """The first hex digits of the SHA-256 of a result."""
    total = hashlib.sha256()
    for piece in pieces(result):
        total.update(piece)
    return total.hexdigest()[:DIGITS]


def pieces(value: Any) -> Iterator[bytes]:
    """The bytes that make up a value, with what tells apart values of the same bytes."""
    if isinstance(value, str):
        return
    if value is None:
        yield b"none;"
    elif isinstance(value, (bool, int, float, np.generic, np.ndarray)):
        yield from array_pieces(np.asarray(value))
    elif isinstance(value, Mapping):
        yield from named_pieces({name: value[name] for name in sorted(value)})
    elif isinstance(value, (list, tuple)):
        yield f"{len(value)} items;".encode()
        for item in value:
            yield from pieces(item)
    else:
        yield from named_pieces(parts_of(value))


def array_pieces(array: NDArray[Any]) -> Iterator[bytes]:
    if array.dtype.hasobject:
        raise TypeError(f"an array of {array.dtype} has no bytes of its own")
    yield f"{array.dtype.str} {array.shape};".encode()
    yield np.ascontiguousarray(array).tobytes()


def named_pieces(parts: Mapping[str, Any]) -> Iterator[bytes]:
    for name, part in parts.items():
        yield f"{name}:".encode()
        yield from pieces(part)


def parts_of(value: Any) -> dict[str, Any]:
    """The public parts of an object, by name."""
    if isinstance(value, loom().PointCloud):
        return cloud_parts(value)
    names = PARTS.get(type(value).__name__)
    if names is None and dataclasses.is_dataclass(value):
        names = sorted(field.name for field in dataclasses.fields(value) if not field.name.startswith("_"))
    if names is None:
        raise TypeError(f"digests.py does not know the parts of a {type(value).__name__}")
    return {name: getattr(value, name) for name in names}


def cloud_parts(cloud: Any) -> dict[str, Any]:
    """All that a cloud holds, its positions as the device has them."""
    parts = {"origin": cloud.origin, "points": cloud.array("points").numpy(), "grid": cloud.grid}
    parts |= {name: cloud[name] for name in ("normals", "colors") if name in cloud}
    return parts | {"attributes": cloud.attributes}


# ------------------------------------------------------------------------------------------------ clouds


@dataclass(eq=False)
class Place:
    """A surface that was sampled twice.

    Attributes:
        cloud, other: The samplings.
        spacing: Of the points, roughly [m].
        size: How far they reach, roughly [m].
        middle: Of the points [m].
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
        """T_target_source of the source below: 2 degrees about the middle, and a point's spacing."""
        return about(self.middle, pose_of(2.0, self.spacing * np.array([0.7, -0.5, 0.3])))

    @cached_property
    def source(self) -> Any:
        """The other sampling with normals, moved away."""
        return self.other.estimate_normals(max_nn=12).transform(np.linalg.inv(self.pose))

    @property
    def reach(self) -> float:
        """Distance of correspondences [m]."""
        return 6 * self.spacing

    @property
    def camera(self) -> NDArray[np.float64]:
        """T_camera_world of a camera above the middle that looks down."""
        T = np.diag([1.0, -1.0, -1.0, 1.0])
        T[:3, 3] = -T[:3, :3] @ self.above(0.75)
        return T

    def above(self, share: float) -> NDArray[np.float64]:
        """A point above the middle, by a share of the size."""
        return self.middle + np.array([0, 0, share * self.size])

    @property
    def box(self) -> Any:
        return loom().AxisAlignedBoundingBox(self.middle - self.size / 4, self.middle + self.size / 4)

    @property
    def turned_box(self) -> Any:
        return loom().OrientedBoundingBox(self.middle, pose_of(40.0, np.zeros(3))[:3, :3], [self.size / 2] * 3)

    @property
    def polygon(self) -> Any:
        corners = self.middle + self.size / 4 * np.array([[-1, -1, 0], [1, -1, 0], [0.2, 0, 0], [1, 1, 0], [-1, 1, 0]])
        low, high = self.middle[2] - self.size, self.middle[2] + self.size
        return loom().SelectionPolygonVolume(corners, "Z", low, high)


def pose_of(degrees: float, shift: Any) -> NDArray[np.float64]:
    """A turn about a slanting axis, then a shift [m]."""
    x, y, z = axis = np.array([0.36, 0.48, 0.8])
    K, angle = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]), np.radians(degrees)
    T = np.eye(4)
    T[:3, :3] = np.cos(angle) * np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * np.outer(axis, axis)
    T[:3, 3] = shift
    return T


TURNED = pose_of(75.0, [0.5, -0.2, 0.1])  # of a pair that is registered from no guess


def about(middle: NDArray[np.float64], T: NDArray[np.float64]) -> NDArray[np.float64]:
    """A motion about a point other than the origin."""
    moved = T.copy()
    moved[:3, 3] += middle - T[:3, :3] @ middle
    return moved


def textured(points: NDArray[np.float64], shift: NDArray[np.float64], device: str) -> Any:
    """Points moved somewhere, with the colours of a pattern and two attributes."""
    x, y = np.nan_to_num(points[:, :2], posinf=0.0).T
    colors = 0.5 + 0.4 * np.stack([np.sin(4 * x), np.cos(5 * y), np.sin(3 * x + 2 * y)], axis=1)
    intensity = np.round(1000 * colors[:, 0]).astype(np.float32)  # whole numbers, as files of LAS hold
    label = np.arange(len(points), dtype=np.int32) % 7
    return loom().PointCloud(points + shift, colors=colors, device=device, intensity=intensity, label=label)


def soil(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """NaN and infinite points, duplicates, and a sixth of all points at one place."""
    points, count = points.copy(), len(points)
    points[::97] = np.nan
    points[5::311, 2] = np.inf
    points[count // 2 : count // 2 + count // 10] = points[: count // 10]
    points[-count // 6 :] = points[1]
    return points


class Scenes:
    """The data of all operations, each made from its seed when first asked for."""

    def __init__(self, device: str):
        self.device = device

    def cloud(self, points: Any, **attributes: Any) -> Any:
        return loom().PointCloud(points, device=self.device, **attributes)

    def place(self, count: int, seed: int, shift: Any = (0, 0, 0), change: Callable[[Any], Any] = np.asarray) -> Place:
        """A bumpy surface."""
        spots = np.asarray(shift, np.float64)
        both = [textured(change(scenes.bumpy_surface(count, seed + k)), spots, self.device) for k in (0, 1)]
        return Place(*both, scenes.SURFACE_EDGE / count**0.5, scenes.SURFACE_EDGE, spots)

    @cached_property
    def surface(self) -> Place:
        return self.place(40_009, 10)

    @cached_property
    def far(self) -> Place:
        return self.place(8_009, 20, UTM)

    @cached_property
    def dirty(self) -> Place:
        return self.place(9_001, 30, change=soil)

    @cached_property
    def tiny(self) -> list[Place]:
        """No point, one, two at one place, three, five of a plane."""
        points = np.array([[0.3, 0.1, 0.2], [0.3, 0.1, 0.2], [0.5, 0.1, 0.2], [0.3, 0.4, 0.2], [0.6, 0.5, 0.2]])
        rows = [points[:count].reshape(-1, 3) for count in (0, 1, 2, 3, 5)]
        clouds = [textured(few, np.zeros(3), self.device) for few in rows]
        return [Place(cloud, cloud, 0.2, 0.5, points[0]) for cloud in clouds]

    @cached_property
    def real(self) -> Place:
        points = scenes.real_scan()
        drawn = np.random.default_rng(35).permutation(len(points))[: 2 * REAL_COUNT]
        both = [self.cloud(points[np.sort(rows)]) for rows in np.split(drawn, 2)]
        return Place(*both, 0.1, 20.0, np.zeros(3))

    @cached_property
    def plane(self) -> Place:
        """A plane, along which nothing holds a cloud."""
        points = np.random.default_rng(40).uniform(-1, 1, (2, 2000, 3)) * [1, 1, 0.001]
        return Place(*map(self.cloud, points), 0.045, 2.0, np.zeros(3))

    @cached_property
    def thinned(self) -> list[Any]:
        """Two overlapping parts of the surface, 75 degrees apart, thinned, with normals."""
        points = [scenes.bumpy_surface(20_000, 50), scenes.bumpy_surface(20_000, 51)]
        parts = [points[0][points[0][:, 0] < 0.7], points[1][points[1][:, 0] > -1.3]]
        source, target = (self.cloud(part).voxel_down_sample(0.06).estimate_normals(max_nn=20) for part in parts)
        up = [c.orient_normals_to_align_with_direction() for c in (source, target)]
        return [up[0].transform(np.linalg.inv(TURNED)), up[1]]

    @cached_property
    def features(self) -> list[NDArray[np.float32]]:
        return [loom().compute_fpfh_feature(cloud, radius=0.3, max_nn=60) for cloud in self.thinned]

    @cached_property
    def matches(self) -> NDArray[np.int32]:
        return reg().correspondences_from_features(*self.features, mutual_filter=True, device=self.device)

    @cached_property
    def fragments(self) -> list[Any]:
        """Four parts of the surface that overlap along it, each turned its own way."""
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
        """A colour image, uint8 [h, w, 3]."""
        v, u = np.mgrid[:HEIGHT, :WIDTH]
        return np.stack([u + v, 3 * u, 255 - 2 * v], axis=-1).astype(np.uint8)

    @cached_property
    def rgbd(self) -> Any:
        return loom().RGBDImage(self.paint, self.frames.depths[0], depth_trunc=6.0, device=self.device)

    def fuse(self, shift: Any = (0, 0, 0), *, color: bool = True) -> tuple[Any, list[int]]:
        """The frames in a volume, and the blocks that each touched."""
        volume = loom().TSDFVolume(voxel_size=0.04, color=color, device=self.device)
        paint, touched = self.paint if color else None, []
        for depth, T in zip(self.frames.depths, self.extrinsics(shift), strict=True):
            touched.append(volume.integrate(depth, self.lens, T, paint, depth_max=6.0))
        return volume, touched

    def extrinsics(self, shift: Any = (0, 0, 0)) -> NDArray[np.float64]:
        """T_camera_world of the frames, the world moved by a shift [m]."""
        Ts = self.frames.extrinsics.copy()
        Ts[:, :3, 3] -= Ts[:, :3, :3] @ np.asarray(shift, np.float64)
        return Ts

    @cached_property
    def volume(self) -> Any:
        return self.fuse()[0]

    @cached_property
    def far_volume(self) -> Any:
        return self.fuse(UTM, color=False)[0]

    @cached_property
    def ball(self) -> Any:
        return loom().marching_cubes(scenes.wavy_ball(40), spacing=[0.05] * 3, device=self.device)

    @cached_property
    def drive(self) -> street.Drive:
        return street.drive(6, sway=0.2, azimuths=450)

    @cached_property
    def scans(self) -> list[Any]:
        """Scans of the drive, each point with its time."""
        return [self.cloud(p, time=t) for p, t in zip(self.drive.scans, self.drive.times, strict=True)]

    @cached_property
    def doppler(self) -> tuple[Any, Any]:
        """A scan with the speeds at which its points move away, one in ten wrong, and the scan before with normals."""
        rng, points = np.random.default_rng(70), self.drive.scans[1]
        speeds = -10 * points[:, 0] / np.linalg.norm(points, axis=1) + rng.normal(0, 0.1, len(points))
        speeds[::10] += rng.normal(0, 10, len(speeds[::10]))
        return self.cloud(points, dopplers=speeds), self.scans[0].estimate_normals(max_nn=20)

    @cached_property
    def path(self) -> Any:
        """The drive's trajectory as odometry has it, with times."""
        return reg().run_odometry(self.scans, voxel_size=1.0, timestamps=street.TURN * np.arange(6))

    @cached_property
    def true_path(self) -> Any:
        return dataclasses.replace(self.path, poses=self.drive.poses, timestamps=self.path.timestamps + 0.001)

    @cached_property
    def graph(self) -> Any:
        walk = ring(60)()
        edges = [reg().PoseGraphEdge(i, j, T, INFORMATION, uncertain) for i, j, T, uncertain in walk.edges]
        return reg().PoseGraph([reg().PoseGraphNode(T) for T in walk.poses], edges)


# ------------------------------------------------------------------------------------------------ on every cloud


def there_and_back(value: Any, ending: str, write: str, read: str, **options: Any) -> Any:
    """What a file gives back of what was written to it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"file{ending}"
        getattr(loom(), write)(path, value, **options)
        return getattr(loom(), read)(path)


def cloud_file(cloud: Any, ending: str, **options: Any) -> Any:
    return there_and_back(cloud, ending, "write_point_cloud", "read_point_cloud", **options)


def search(p: Place) -> Any:
    return loom().NearestNeighborSearch(p.cloud)


def icp(p: Place, method: str = "PointToPoint", **options: Any) -> Any:
    """ICP by an estimator, whose own options are given by keyword."""
    estimation = getattr(reg(), f"TransformationEstimation{method}")(**options)
    return reg().registration_icp(p.source, p.facing, p.reach, None, estimation)


def from_poses(p: Place) -> list[Any]:
    """ICP from three poses at once."""
    starts = [about(p.middle, pose_of(degrees, np.zeros(3))) for degrees in (-1.0, 0.0, 3.0)]
    plane = reg().TransformationEstimationPointToPlane()
    return reg().registration_icp_batch(p.source, p.facing, p.reach, np.array(starts), plane)


def depth_lens(p: Place) -> Any:
    return loom().PinholeCameraIntrinsic(WIDTH, HEIGHT, 150, 150, WIDTH / 2, HEIGHT / 2)


SIZE = (WIDTH, HEIGHT)
ON_CLOUDS: dict[str, Callable[[Place], Any]] = {
    "voxel_down_sample": lambda p: p.facing.voxel_down_sample(4 * p.spacing),
    "voxel_down_sample, nearest": lambda p: p.cloud.voxel_down_sample(4 * p.spacing, reduction="nearest"),
    "voxel_down_sample_and_trace": lambda p: p.cloud.voxel_down_sample_and_trace(4 * p.spacing),
    "voxel_down_sample_and_trace, box": lambda p: p.cloud.voxel_down_sample_and_trace(
        4 * p.spacing, p.middle - p.size, p.middle + p.size, approximate_class=True
    ),
    "uniform_down_sample": lambda p: p.facing.uniform_down_sample(5),
    "random_down_sample": lambda p: p.facing.random_down_sample(0.3, seed=3),
    "farthest_point_down_sample": lambda p: p.cloud.farthest_point_down_sample(min(150, len(p.cloud)), 1),
    "farthest_point_indices": lambda p: p.cloud.farthest_point_indices(min(50, len(p.cloud)), 2),
    "select_by_index": lambda p: p.facing.select_by_index(np.arange(0, len(p.cloud), 3), invert=True),
    "select_by_mask": lambda p: p.facing.select_by_mask(np.arange(len(p.cloud)) % 3 == 0),
    "crop, box": lambda p: p.cloud.crop(p.box),
    "crop, box inverted": lambda p: p.cloud.crop(p.box, invert=True),
    "crop, turned box": lambda p: p.cloud.crop(p.turned_box),
    "crop, polygon": lambda p: p.cloud.crop(p.polygon),
    "crop_point_cloud inverted": lambda p: p.polygon.crop_point_cloud(p.cloud, invert=True),
    "crop_in_polygon": lambda p: p.polygon.crop_in_polygon(p.cloud),
    "get_point_indices_within_bounding_box": lambda p: [
        box.get_point_indices_within_bounding_box(points)
        for box in (p.box, p.turned_box)
        for points in (p.cloud, p.cloud.points)
    ],
    "remove_non_finite_points": lambda p: [
        p.cloud.remove_non_finite_points(remove_nan=nan, remove_infinite=infinite)
        for nan, infinite in ((True, True), (True, False), (False, True))
    ],
    "remove_duplicated_points": lambda p: p.cloud.remove_duplicated_points(),
    "paint_uniform_color": lambda p: p.cloud.paint_uniform_color([0.1, 0.5, 1]),
    "+": lambda p: p.cloud + p.other,
    "concatenate": lambda p: loom().PointCloud.concatenate([p.facing, p.other, p.cloud]),
    "transform": lambda p: p.facing.estimate_covariances(max_nn=8).transform(p.pose),
    "estimate_normals, knn": lambda p: p.cloud.estimate_normals(max_nn=15),
    "estimate_normals, radius": lambda p: p.cloud.estimate_normals(radius=3 * p.spacing, max_nn=None),
    "estimate_normals, hybrid": lambda p: p.cloud.estimate_normals(radius=3 * p.spacing, max_nn=20),
    "estimate_normals, again": lambda p: p.facing.flip_normals().estimate_normals(max_nn=30),
    "estimate_covariances, knn": lambda p: p.cloud.estimate_covariances(max_nn=15),
    "estimate_covariances, radius": lambda p: p.cloud.estimate_covariances(radius=3 * p.spacing, max_nn=None),
    "estimate_covariances, hybrid": lambda p: p.cloud.estimate_covariances(radius=3 * p.spacing, max_nn=20),
    "flip_normals": lambda p: p.facing.flip_normals(),
    "normalize_normals": lambda p: p.facing.normalize_normals(),
    "orient_normals_to_align_with_direction": lambda p: p.facing.orient_normals_to_align_with_direction([0.1, 0.2, -1]),
    "orient_normals_towards_camera_location": lambda p: p.facing.orient_normals_towards_camera_location(p.middle),
    "orient_normals_consistent_tangent_plane": lambda p: p.facing.orient_normals_consistent_tangent_plane(12),
    "orient_normals_consistent_tangent_plane, penalty": lambda p: p.facing.orient_normals_consistent_tangent_plane(
        8, 0.5, 0.9
    ),
    "compute_point_cloud_distance": lambda p: p.cloud.compute_point_cloud_distance(p.other),
    "compute_nearest_neighbor_distance": lambda p: p.cloud.compute_nearest_neighbor_distance(),
    "compute_mean_and_covariance": lambda p: p.cloud.compute_mean_and_covariance(),
    "compute_mahalanobis_distance": lambda p: p.cloud.compute_mahalanobis_distance(),
    "compute_metrics": lambda p: loom().compute_metrics(p.cloud, p.other, [0.5 * p.spacing, 2 * p.spacing]),
    "knn_search": lambda p: search(p).knn_search(p.other, 8),
    "knn_search, array": lambda p: search(p).knn_search(p.other.points[::3], 40),
    "hybrid_search": lambda p: search(p).hybrid_search(p.other, 2 * p.spacing, 10),
    "radius_search": lambda p: search(p).radius_search(p.other.uniform_down_sample(4), 2 * p.spacing),
    "remove_statistical_outlier": lambda p: p.cloud.remove_statistical_outlier(20, 1.5),
    "remove_radius_outlier": lambda p: p.cloud.remove_radius_outlier(10, 2 * p.spacing),
    "cluster_dbscan": lambda p: p.cloud.cluster_dbscan(1.3 * p.spacing, 8),
    "cluster_dbscan, one point": lambda p: p.cloud.cluster_dbscan(0.8 * p.spacing, 1),
    "cluster_euclidean": lambda p: p.cloud.cluster_euclidean(0.9 * p.spacing),
    "cluster_euclidean, sizes": lambda p: p.cloud.cluster_euclidean(0.9 * p.spacing, 5, 2000),
    "segment_plane": lambda p: p.cloud.segment_plane(p.spacing, 3, 200),
    "segment_plane, 6 points": lambda p: p.cloud.segment_plane(p.spacing, 6, 100, probability=0.999, seed=5),
    "segment_planes": lambda p: p.cloud.segment_planes(p.spacing, max_planes=3),
    "detect_planar_patches": lambda p: p.facing.detect_planar_patches(max_nn=20),
    "hidden_point_removal": lambda p: p.cloud.hidden_point_removal(p.above(1.5), 150 * p.size),
    "compute_convex_hull": lambda p: p.cloud.compute_convex_hull(),
    "compute_convex_hull, joggled": lambda p: p.cloud.compute_convex_hull(joggle_inputs=True),
    "get_axis_aligned_bounding_box": lambda p: p.cloud.get_axis_aligned_bounding_box(),
    "get_oriented_bounding_box": lambda p: p.cloud.get_oriented_bounding_box(),
    "get_oriented_bounding_box, robust": lambda p: p.cloud.get_oriented_bounding_box(robust=True),
    "get_minimal_oriented_bounding_box": lambda p: p.cloud.get_minimal_oriented_bounding_box(),
    "compute_fpfh_feature, hybrid": lambda p: loom().compute_fpfh_feature(p.facing, radius=3 * p.spacing, max_nn=50),
    "compute_fpfh_feature, knn": lambda p: loom().compute_fpfh_feature(p.facing, max_nn=20),
    "compute_fpfh_feature, radius": lambda p: loom().compute_fpfh_feature(
        p.facing, radius=1.5 * p.spacing, max_nn=None
    ),
    "compute_fpfh_feature, some": lambda p: loom().compute_fpfh_feature(
        p.facing, radius=3 * p.spacing, max_nn=50, indices=np.arange(0, len(p.facing), 11)
    ),
    "compute_iss_keypoints": lambda p: loom().compute_iss_keypoints(p.cloud, return_indices=True),
    "compute_iss_keypoints, radii": lambda p: loom().compute_iss_keypoints(p.cloud, 6 * p.spacing, 5 * p.spacing),
    "compute_eigen_features, knn": lambda p: loom().compute_eigen_features(p.cloud, max_nn=20),
    "compute_eigen_features, radius": lambda p: loom().compute_eigen_features(
        p.cloud, radius=2 * p.spacing, max_nn=None
    ),
    "estimate_curvature": lambda p: loom().estimate_curvature(p.cloud, radius=4 * p.spacing, max_nn=20),
    "smooth_mls": lambda p: p.cloud.smooth_mls(radius=3.4 * p.spacing, max_nn=30),
    "smooth_mls, knn": lambda p: p.facing.smooth_mls(radius=None, max_nn=15),
    "smooth_bilateral": lambda p: p.facing.smooth_bilateral(
        radius=3 * p.spacing, max_nn=30, sigma_s=2 * p.spacing, sigma_r=p.spacing
    ),
    "smooth_laplacian": lambda p: p.cloud.smooth_laplacian(2),
    "smooth_laplacian, fixed": lambda p: p.cloud.smooth_laplacian(3, 0.3, 12, use_fixed_neighborhoods=True),
    "smooth_taubin": lambda p: p.cloud.smooth_taubin(2),
    "smooth_taubin, fixed": lambda p: p.cloud.smooth_taubin(3, knn=12, use_fixed_neighborhoods=True),
    "classify_ground": lambda p: loom().classify_ground(p.cloud, 4 * p.spacing, 0.05, 30 * p.spacing, p.spacing),
    "project_to_depth_image": lambda p: p.cloud.project_to_depth_image(
        *SIZE, depth_lens(p), p.camera, depth_max=2 * p.size
    ),
    "project_to_rgbd_image": lambda p: p.cloud.paint_uniform_color([1, 0.5, 0]).project_to_rgbd_image(
        *SIZE, depth_lens(p), p.camera, depth_max=2 * p.size
    ),
    "pickle": lambda p: pickle.loads(pickle.dumps(p.facing)),
    "write and read .npz": lambda p: cloud_file(p.facing, ".npz"),
    "write and read .ply": lambda p: cloud_file(p.facing, ".ply"),
    "icp, point to point": lambda p: icp(p),
    "icp, point to plane": lambda p: icp(p, "PointToPlane"),
    "icp, symmetric": lambda p: icp(p, "Symmetric"),
    "icp, generalised": lambda p: icp(p, "ForGeneralizedICP"),
    "icp, generalised, own covariances": lambda p: reg().registration_generalized_icp(
        p.other.transform(np.linalg.inv(p.pose)), p.cloud, p.reach
    ),
    "icp, generalised, voxels": lambda p: icp(p, "ForGeneralizedICP", voxel_size=4 * p.spacing),
    "registration_icp_batch, three poses": from_poses,
    "evaluate_registration": lambda p: reg().evaluate_registration(p.source, p.cloud, p.reach),
    "get_information_matrix_from_point_clouds": lambda p: reg().get_information_matrix_from_point_clouds(
        p.source, p.cloud, p.reach, p.pose
    ),
    "rate_registration": lambda p: reg().rate_registration(p.source, p.cloud, p.pose, p.reach),
}


# ------------------------------------------------------------------------------------------------ once


def dlpack_cloud(d: Scenes) -> Any:
    points = scenes.bumpy_surface(500, 80).astype(np.float32)
    return loom().PointCloud.from_dlpack(points, normals=points.copy(), origin=UTM, label=np.arange(500))


def moved_boxes(p: Place) -> list[Any]:
    """Boxes of points, moved, turned, grown and joined."""
    aligned, turned, points = loom().AxisAlignedBoundingBox, loom().OrientedBoundingBox, p.cloud.points[:200]
    boxes = [aligned.create_from_points(points), turned.create_from_points(points)]
    boxes += [turned.create_from_points(points, robust=True), turned.create_from_points_minimal(points), p.turned_box]
    moved = [box.translate([1, 2, 3]).scale(1.5, p.middle).rotate(p.pose[:3, :3]) for box in boxes]
    measures = [(box.volume(), box.get_box_points(), box.get_center(), box.get_extent()) for box in boxes + moved]
    return [boxes, moved, measures, boxes[0] + p.box, [box.get_axis_aligned_bounding_box() for box in moved]]


def polygon_file(p: Place) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "polygon.json"
        p.polygon.to_json(path)
        return loom().SelectionPolygonVolume.from_json(path)


def las_chunks(p: Place) -> list[Any]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "cloud.las"
        loom().write_point_cloud(path, p.cloud)
        return list(loom().read_las_chunks(path, 3000))


def mesh_file(mesh: Any, ending: str, **options: Any) -> Any:
    return there_and_back(mesh, ending, "write_triangle_mesh", "read_triangle_mesh", **options)


def written_mesh(mesh: Any, ending: str) -> NDArray[np.uint8]:
    """The bytes of a file that is written only."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"mesh{ending}"
        loom().write_triangle_mesh(path, mesh)
        return np.fromfile(path, np.uint8)


def volume_file(d: Scenes) -> list[Any]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "volume.npz"
        d.volume.save(path)
        again = loom().TSDFVolume.load(path, device=d.device)
    return [again.block_count, again.frame_count, again.extract_triangle_mesh(0), again.extract_point_cloud(1)]


def mesh_measures(mesh: Any) -> list[Any]:
    closed = [mesh.is_edge_manifold(), mesh.is_edge_manifold(allow_boundary_edges=False), mesh.is_watertight()]
    return [mesh.get_surface_area(), *closed, mesh.compute_triangle_normals(), *mesh.get_axis_aligned_bounding_box()]


def some_triangles(d: Scenes) -> Any:
    mesh = loom().TriangleMesh(d.ball.vertices, d.ball.triangles[::5], device=d.device)
    return mesh.remove_unreferenced_vertices()


def robust_kernels(scale: float = 0.02) -> dict[str, Any]:
    kernels = {name: getattr(reg(), f"{name}Loss")(scale) for name in ("Huber", "Cauchy", "GM", "Tukey", "Generalized")}
    general = {f"Generalized {shape}": reg().GeneralizedLoss(scale, shape) for shape in (2.0, 0.0, -2.0, -np.inf)}
    return kernels | general | {"L1": reg().L1Loss(), "L2": reg().L2Loss()}


def icp_with(p: Place, method: str = "PointToPlane", **options: Any) -> Any:
    """ICP with options that are the call's own."""
    estimation = getattr(reg(), f"TransformationEstimation{method}")()
    return reg().registration_icp(p.source, p.facing, p.reach, None, estimation, **options)


def icp_watched(p: Place) -> list[Any]:
    """The states that a callback is told, and the result."""
    states: list[Any] = []
    return [icp_with(p, callback_after_iteration=lambda state: states.append(dict(state))), states]


def multi_scale(p: Place) -> list[Any]:
    """From coarse to fine, with what a callback is told."""
    states: list[Any] = []
    rules = [reg().ICPConvergenceCriteria(1e-4, 1e-4, 10), reg().ICPConvergenceCriteria(max_iteration=20)]
    plane, sizes = reg().TransformationEstimationPointToPlane(), [4 * p.spacing, -1]
    clouds, distances = (p.source, p.facing), [2 * p.reach, p.reach]
    watch: dict[str, Any] = {"callback_after_iteration": lambda state: states.append(dict(state))}
    return [reg().multi_scale_icp(*clouds, sizes, rules, distances, None, plane, **watch), states]


def doppler(d: Scenes, **options: Any) -> Any:
    method = reg().TransformationEstimationForDopplerICP(**options)
    return reg().registration_icp(*d.doppler, 1.5, None, method)


def icp_batch(d: Scenes, method: str) -> list[Any]:
    estimation = getattr(reg(), f"TransformationEstimation{method}")()
    return reg().registration_icp_batch(*d.patches, 0.15, None, estimation, degeneracy=0)


def checkers() -> list[Any]:
    return [
        reg().CorrespondenceCheckerBasedOnEdgeLength(0.9),
        reg().CorrespondenceCheckerBasedOnDistance(0.12),
        reg().CorrespondenceCheckerBasedOnNormal(0.7),
        reg().CorrespondenceCheckerBasedOnSourceRotation([3.2, 3.2, 3.2]),
    ]


def checked(d: Scenes) -> list[bool]:
    """What each checker says of some samples."""
    samples = [d.matches[3 * k : 3 * k + 3] for k in range(20)]
    return [one.Check(*d.thinned, sample, TURNED) for one in checkers() for sample in samples]


def ransac(d: Scenes, **options: Any) -> Any:
    rules = reg().RANSACConvergenceCriteria(20_000, 0.999)
    return reg().registration_ransac_based_on_correspondence(*d.thinned, d.matches, 0.1, criteria=rules, **options)


def ransac_features(d: Scenes, mutual: bool) -> Any:
    rules, clouds = reg().RANSACConvergenceCriteria(20_000, 0.999), (*d.thinned, *d.features)
    call = reg().registration_ransac_based_on_feature_matching
    return call(*clouds, mutual, 0.1, checkers=checkers()[:3], criteria=rules, seed=2)


def fast_global(d: Scenes, **options: Any) -> list[Any]:
    """From features and from given pairs."""
    option = reg().FastGlobalRegistrationOption(maximum_correspondence_distance=0.1, **options)
    of_features = reg().registration_fgr_based_on_feature_matching
    of_pairs = reg().registration_fgr_based_on_correspondence
    return [of_features(*d.thinned, *d.features, option), of_pairs(*d.thinned, d.matches, option, seed=4)]


def robust_global(d: Scenes) -> list[Any]:
    of_features = reg().registration_robust_based_on_feature_matching
    of_pairs = reg().registration_robust_based_on_correspondence
    found = [of_features(*d.thinned, *d.features, 0.06), of_features(*d.thinned, *d.features, 0.06, False)]
    return [*found, of_pairs(*d.thinned, d.matches, 0.08, seed=6)]


def optimized(d: Scenes, method: str, **options: Any) -> Any:
    how = getattr(reg(), f"GlobalOptimization{method}")()
    return reg().global_optimization(d.graph, how, option=reg().GlobalOptimizationOption(DISTANCE, **options))


def graph_file(d: Scenes) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "graph.json"
        reg().write_pose_graph(path, d.graph)
        return reg().read_pose_graph(path)


def odometry(d: Scenes, **options: Any) -> list[Any]:
    run = reg().LidarOdometry(voxel_size=1.0, device=d.device, **options)
    for scan in d.scans:
        run.register(scan)
    return [run.poses, run.map, run.steps, run.summary]


ONCE: dict[str, Callable[[Scenes], Any]] = {
    "from_dlpack": dlpack_cloud,
    "boxes moved": lambda d: moved_boxes(d.surface),
    "boxes moved, far": lambda d: moved_boxes(d.far),
    "polygon to and from JSON": lambda d: polygon_file(d.far),
    "write and read .ply, ascii": lambda d: cloud_file(d.far.facing, ".ply", ascii=True),
    "write and read .pcd": lambda d: cloud_file(d.dirty.facing, ".pcd"),
    "write and read .pcd, ascii": lambda d: cloud_file(d.far.facing, ".pcd", ascii=True),
    "write and read .xyz": lambda d: cloud_file(d.cloud(d.far.cloud.points), ".xyz"),
    "write and read .las": lambda d: cloud_file(d.far.cloud, ".las"),
    "write and read .laz": lambda d: cloud_file(d.far.cloud, ".laz", scale=1e-4),
    "write and read .e57": lambda d: cloud_file(d.cloud(d.far.cloud.points, colors=d.far.cloud.colors), ".e57"),
    "read_las_chunks": lambda d: las_chunks(d.far),
    "from_depth_image": lambda d: loom().PointCloud.from_depth_image(d.frames.depths[0], d.lens, device=d.device),
    "from_depth_image, normals": lambda d: loom().PointCloud.from_depth_image(
        d.frames.depths[1], d.lens, d.extrinsics(UTM)[1], depth_trunc=3.0, with_normals=True, device=d.device
    ),
    "from_depth_image, stride": lambda d: loom().PointCloud.from_depth_image(
        d.frames.depths[2] / 1000, d.lens, stride=3, project_valid_depth_only=False, with_normals=True, device=d.device
    ),
    "from_rgbd_image": lambda d: loom().PointCloud.from_rgbd_image(d.rgbd, d.lens, d.extrinsics()[0]),
    "from_rgbd_image, normals": lambda d: loom().PointCloud.from_rgbd_image(
        d.rgbd, d.lens, project_valid_depth_only=False, stride=2, with_normals=True
    ),
    "RGBDImage": lambda d: d.rgbd,
    "RGBDImage, formats": lambda d: [
        getattr(loom().RGBDImage, name)(d.paint, d.frames.depths[0], device=d.device)
        for name in ("from_color_and_depth", "from_redwood_format", "from_tum_format")
    ],
    "RGBDImage, raw formats": lambda d: [
        getattr(loom().RGBDImage, name)(d.paint, d.frames.depths[0], convert_rgb_to_intensity=False, device=d.device)
        for name in ("from_sun_format", "from_nyu_format")
    ],
    "project_to_rgbd_image": lambda d: d.surface.cloud.project_to_rgbd_image(
        *SIZE, depth_lens(d.surface), d.surface.camera, depth_max=9.0
    ),
    "filter_depth_bilateral": lambda d: loom().filter_depth_bilateral(d.frames.depths[0], 7, device=d.device),
    "erode_depth_edges": lambda d: loom().erode_depth_edges(d.rgbd, 2, 0.05),
    "create_normal_map": lambda d: loom().create_normal_map(d.rgbd, d.lens, -1.0),
    "pyrdown_depth": lambda d: loom().pyrdown_depth(d.frames.depths[3], device=d.device),
    "pyrdown_color": lambda d: loom().pyrdown_color(d.paint, device=d.device),
    "create_depth_pyramid": lambda d: loom().create_depth_pyramid(d.rgbd, 3),
    "tsdf, integrate": lambda d: d.fuse()[1],
    "tsdf, integrate, far": lambda d: d.fuse(UTM, color=False)[1],
    "tsdf, extract_triangle_mesh": lambda d: [d.volume.extract_triangle_mesh(w) for w in (0.0, 2.0)],
    "tsdf, extract_triangle_mesh, far": lambda d: d.far_volume.extract_triangle_mesh(0),
    "tsdf, extract_point_cloud": lambda d: [d.volume.extract_point_cloud(w) for w in (0.0, 2.0)],
    "tsdf, extract_point_cloud, far": lambda d: d.far_volume.extract_point_cloud(0),
    "tsdf, ray_cast": lambda d: d.volume.ray_cast(d.lens, d.extrinsics()[1], depth_max=6.0, weight_threshold=0),
    "tsdf, ray_cast, far": lambda d: d.far_volume.ray_cast(
        d.lens, d.extrinsics(UTM)[2], depth_max=6.0, weight_threshold=1
    ),
    "tsdf, save and load": volume_file,
    "marching_cubes": lambda d: d.ball,
    "marching_cubes, level": lambda d: loom().marching_cubes(
        scenes.wavy_ball(24)[:, :20], 0.1, spacing=[0.1, 0.2, 0.3], origin=UTM, device=d.device
    ),
    "mesh, compute_vertex_normals": lambda d: d.ball.compute_vertex_normals(),
    "mesh, measures": lambda d: [mesh_measures(mesh) for mesh in (d.ball, d.volume.extract_triangle_mesh(0))],
    "mesh, get_volume": lambda d: d.ball.get_volume(),
    "mesh, transform": lambda d: d.ball.compute_vertex_normals().transform(about(UTM, pose_of(30.0, UTM))),
    "mesh, remove_unreferenced_vertices": some_triangles,
    "mesh, write and read .ply": lambda d: mesh_file(d.volume.extract_triangle_mesh(0), ".ply"),
    "mesh, write and read .ply, ascii": lambda d: mesh_file(d.ball.compute_vertex_normals(), ".ply", ascii=True),
    "mesh, write .obj": lambda d: written_mesh(d.ball, ".obj"),
    "mesh, write .stl": lambda d: written_mesh(d.ball, ".stl"),
    "robust kernels": lambda d: {name: k.weight(np.linspace(-1, 1, 41)) for name, k in robust_kernels(0.3).items()},
    "icp, point to plane, robust": lambda d: {
        name: icp(d.surface, "PointToPlane", kernel=kernel) for name, kernel in robust_kernels().items()
    },
    "icp, point to point, scaling": lambda d: icp(d.surface, with_scaling=True),
    "icp, point to point, Huber": lambda d: icp(d.surface, kernel=reg().HuberLoss(0.03)),
    "icp, symmetric, Tukey": lambda d: icp(d.surface, "Symmetric", kernel=reg().TukeyLoss(0.1)),
    "icp, generalised, Cauchy": lambda d: icp(d.surface, "ForGeneralizedICP", kernel=reg().CauchyLoss(1.0)),
    "icp, coloured": lambda d: icp(d.surface, "ForColoredICP"),
    "icp, coloured, Huber": lambda d: icp(d.far, "ForColoredICP", lambda_geometric=0.5, kernel=reg().HuberLoss(0.1)),
    "icp, overlap": lambda d: [icp_with(d.surface, method, overlap=0.7) for method in ("PointToPoint", "PointToPlane")],
    "icp, max_normal_angle": lambda d: icp_with(d.surface, max_normal_angle=0.5),
    "icp, degeneracy": lambda d: [icp_with(d.plane), icp_with(d.plane, degeneracy=0), icp_with(d.plane, "Symmetric")],
    "icp, callback": lambda d: icp_watched(d.surface),
    "icp, criteria": lambda d: [
        icp_with(d.surface, criteria=reg().ICPConvergenceCriteria(1e-3, 1e-3, steps)) for steps in (0, 1, 50)
    ],
    "icp, doppler": doppler,
    "icp, doppler, robust": lambda d: doppler(
        d, reject_dynamic_outliers=True, doppler_kernel=reg().TukeyLoss(0.5), geometric_kernel=reg().HuberLoss(0.2)
    ),
    "registration_colored_icp": lambda d: reg().registration_colored_icp(d.far.source, d.far.facing, d.far.reach),
    "registration_symmetric_icp": lambda d: reg().registration_symmetric_icp(d.far.source, d.far.facing, d.far.reach),
    "registration_icp_batch, point to point": lambda d: icp_batch(d, "PointToPoint"),
    "registration_icp_batch, point to plane": lambda d: icp_batch(d, "PointToPlane"),
    "registration_icp_batch, generalised": lambda d: icp_batch(d, "ForGeneralizedICP"),
    "multi_scale_icp": lambda d: multi_scale(d.surface),
    "multi_scale_icp, far": lambda d: multi_scale(d.far),
    "correspondences_from_features": lambda d: [
        reg().correspondences_from_features(*d.features, mutual, ratio=ratio, device=d.device)
        for mutual, ratio in ((False, None), (True, None), (False, 0.9))
    ],
    "ransac, checkers": checked,
    "ransac, features": lambda d: [ransac_features(d, mutual) for mutual in (False, True)],
    "ransac, pairs": lambda d: [ransac(d), ransac(d, ransac_n=4, checkers=checkers()[:2], seed=1)],
    "ransac, pairs, scaling": lambda d: ransac(
        d, estimation_method=reg().TransformationEstimationPointToPoint(with_scaling=True)
    ),
    "fast global registration": fast_global,
    "fast global registration, absolute": lambda d: fast_global(d, use_absolute_scale=True, tuple_test=False),
    "robust registration": robust_global,
    "register_globally": lambda d: reg().register_globally(*d.thinned, voxel_size=0.08),
    "register_globally, not refined": lambda d: reg().register_globally(*d.thinned, voxel_size=0.08, refine=False),
    "register_fragments": lambda d: reg().register_fragments(d.fragments, voxel_size=0.1),
    "global_optimization": lambda d: optimized(d, "LevenbergMarquardt", reference_node=0),
    "global_optimization, Gauss-Newton": lambda d: optimized(d, "GaussNewton", edge_prune_threshold=0.1),
    "pose graph, write and read": graph_file,
    "odometry": odometry,
    "odometry, as measured": lambda d: odometry(d, deskew=False, max_points_per_voxel=5, min_range=2.0),
    "run_odometry": lambda d: d.path,
    "iterate_odometry": lambda d: list(reg().iterate_odometry(d.scans[:3], device=d.device, voxel_size=2.0)),
    "deskew_point_cloud": lambda d: reg().deskew_point_cloud(d.scans[2], pose_of(3.0, [1, 0.1, 0])),
    "evaluate_trajectory": lambda d: [
        reg().evaluate_trajectory(d.path, d.true_path, align=align, lengths=[2, 3]) for align in (True, "first", None)
    ],
    "evaluate_trajectory, scale": lambda d: reg().evaluate_trajectory(d.path, d.true_path, with_scale=True, delta=2),
}


# ------------------------------------------------------------------------------------------------ the run


def on_each(work: Callable[[Place], Any], places: list[Place]) -> list[Any]:
    """A digest for each place, or the kind of error: some operations need more points than there are."""
    found = []
    for place in places:
        try:
            found.append(np.frombuffer(digest(work(place)).encode(), np.uint8))
        except Exception as error:
            found.append(np.frombuffer(type(error).__name__.encode(), np.uint8))
    return found


def operations(device: str) -> dict[str, Callable[[], Any]]:
    """All operations by name; the clouds of a name stand side by side."""
    data = Scenes(device)
    places = ["surface", "far", "dirty", *(["real"] if scenes.real_scan_path() else [])]
    found: dict[str, Callable[[], Any]] = {}
    for name, on_cloud in ON_CLOUDS.items():
        for place in places:
            found[f"{name} [{place}]"] = lambda on_cloud=on_cloud, place=place: on_cloud(getattr(data, place))
        found[f"{name} [tiny]"] = lambda on_cloud=on_cloud: on_each(on_cloud, data.tiny)
    return found | {name: lambda once=once: once(data) for name, once in ONCE.items()}


def outcome(work: Callable[[], Any]) -> str:
    """The digest of what an operation returns, or what went wrong."""
    try:
        return digest(work())
    except Exception as error:
        lines = str(error).splitlines() or [""]
        return f"ERROR {type(error).__name__}: {lines[0]}"


def read_lines(path: Path) -> dict[str, str]:
    """An earlier output: outcomes by name."""
    rows = [re.split(r"\s{2,}", line, maxsplit=1) for line in path.read_text().splitlines() if line.strip()]
    return {name: what for name, what in rows}


def line(name: str, *columns: str) -> str:
    return "  ".join([f"{name:62s}", *columns])


def main() -> int:
    """The exit code: 1 where an operation failed or a result is not as before."""
    options = parse_options()
    if options.compiler:
        os.environ["POINTLOOM_CPU"] = options.compiler  # before the library is loaded
    wanted = tuple(options.only or [""])
    before = read_lines(options.against) if options.against else None
    outcomes, differing = {}, 0
    for name, work in operations(options.device).items():
        if not name.startswith(wanted):
            continue
        outcomes[name] = outcome(work)
        if before is None:
            print(line(name, outcomes[name]), flush=True)
        elif outcomes[name] != before.get(name):
            differing += 1
            print(line(name, before.get(name, "(not there)"), outcomes[name]), flush=True)
    if not outcomes:
        print(f"No operation begins with {' or '.join(wanted)}.", file=sys.stderr)
        return 2
    failed = sum(what.startswith("ERROR") for what in outcomes.values())
    for name in [name for name in before or {} if name.startswith(wanted) and name not in outcomes]:
        differing += 1
        print(line(name, before[name], "(not there)"))
    told = "" if before is None else f", {differing} not as before"
    print(f"{len(outcomes)} operations, {failed} failed{told}", file=sys.stderr)
    return int(failed > 0 or differing > 0)


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", choices=("taichi", "warp"), help="of the CPU; as the environment has it if none")
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--only", action="append", metavar="PREFIX", help="operations whose names begin so")
    parser.add_argument("--against", type=Path, metavar="FILE", help="an earlier output: show what differs from it")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
