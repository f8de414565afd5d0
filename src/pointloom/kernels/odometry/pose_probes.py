"""Change of a scan's plane distances at other poses, which shows the motions it constrains.

Only points with planes at both poses count: scan rings differ between scans, so point distances would favor no motion.
Related to Tuna et al. 2023, "X-ICP". Here the curvature of the error is measured with new pairs at each pose.
"""

from typing import Any

import numpy as np

from ..algebra.rigid_solve import rotate
from ..algebra.transform import widen
from ..array_types import Array1, Points
from ..arrays.block_keys import key_block
from ..lang import array, float32, float64, func, kernel, launch, mat44d, struct, tid, uint8, vec3, vec3d
from ..memory import download, empty, rows_of, upload
from ..poses.cost_differences import compare_costs, run_length
from .map_icp import plane, plane_around
from .voxel_map import VoxelMap
from .voxel_map_search import find_nearest_in_map


@kernel
def find_map_planes_kernel(voxel_map: VoxelMap, radius: float, planes: array(dtype=plane)):
    """Planes around all points of a voxel."""
    i = tid()
    cell = key_block(voxel_map.keys[i])
    corner = vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2])) * voxel_map.voxel_size
    first = i * voxel_map.room
    for slot in range(first, first + voxel_map.counts[i]):
        planes[slot] = plane_around(corner + widen(voxel_map.offsets[slot]), radius, voxel_map)


def find_map_planes(voxel_map: VoxelMap, radius: float, planes: Array1[Any] | None = None) -> Array1[Any]:
    """Planes around all points of a map by their position, within `radius` [m]. `planes`: an array to fill."""
    if planes is None:
        planes = empty(voxel_map.count * voxel_map.room, plane, voxel_map.device)
    launch(find_map_planes_kernel, voxel_map.count, [voxel_map, radius, planes])
    return planes


@struct
class ScanProbes:
    """Every `step`-th point of a scan at several poses, in runs. Map points within sqrt(`limit`) [m], with
    neighborhoods of `radius` [m]. `squares`: squared distances per pose and point, or -1. They have `room` for more
    poses. `map_planes`: by map position, or none.
    """

    points: array(dtype=vec3)
    poses: array(dtype=mat44d)
    voxel_map: VoxelMap
    squares: array(dtype=float32, ndim=2)
    step: int
    run: int
    limit: float
    radius: float
    map_planes: array(dtype=plane)

    def __init__(
        self, points: Points, max_points: int, voxel_map: VoxelMap, poses: np.ndarray, radius: float, room: int = 0
    ) -> None:
        self.points, self.voxel_map, self.radius, self.device = points, voxel_map, radius, points.device
        self.step = max(1, points.size // max(max_points, 1))
        self.count = -(-points.size // self.step)
        self.squares = empty((max(room, len(poses)), self.count), float32, self.device)
        self.run = 1 if self.device.is_cuda else run_length(self.squares)  # a point takes long, and there are few
        self.runs = -(-self.count // self.run)
        self.limit = float(np.float32(2 * radius) ** 2)
        self.map_planes = empty(0, plane, self.device)
        self.move_to(poses)

    def move_to(self, poses: np.ndarray) -> None:
        """Set the poses, as many as there is room for."""
        self.poses = upload(poses, mat44d, self.device)

    def cost_changes(self) -> np.ndarray:
        return compare_costs(rows_of(self.squares, 0, self.poses.size), self.voxel_map.voxel_size)


@func
def limit_at(k: int, j: int, probes: ScanProbes) -> float:
    """Squared search distance [m^2] of point j at pose k: 0 if it has no plane at pose 0, so that it does not count."""
    limit = probes.limit
    if k > 0:
        if probes.squares[0, j] < 0.0:
            limit = 0.0
    return limit


@func
def plane_square(x: vec3d, limit: float, probes: ScanProbes) -> float:
    """Squared distance [m^2] from the plane around the nearest map point, or -1 without a plane."""
    square = -1.0
    nearest_point = find_nearest_in_map(x, limit, probes.voxel_map)
    if nearest_point[4] >= 0.0:
        r = vec3d(nearest_point[0], nearest_point[1], nearest_point[2])
        at = plane(0.0, 0.0, 0.0, 0.0, 0.0)
        if probes.map_planes.shape[0] > 0:
            at = probes.map_planes[int(nearest_point[4])]
        else:
            at = plane_around(x - r, probes.radius, probes.voxel_map)
        if at[3] > 0.0:
            along = float64(at[0]) * r[0] + float64(at[1]) * r[1] + float64(at[2]) * r[2]
            square = float(along * along)
    return square


@kernel
def find_squares_kernel(first_pose: int, probes: ScanProbes):
    """Squared plane distances of one run of points at one pose, from `first_pose` on."""
    i = tid()
    count = probes.squares.shape[1]
    runs = (count + probes.run - 1) // probes.run
    k = first_pose + i // runs
    first = (i % runs) * probes.run
    pose = probes.poses[k]
    t = vec3d(pose[0, 3], pose[1, 3], pose[2, 3])
    for j in range(first, first + min(probes.run, count - first)):
        x = rotate(pose, widen(probes.points[j * probes.step])) + t
        probes.squares[k, j] = plane_square(x, limit_at(k, j, probes), probes)


def compare_poses(
    points: Points,
    max_points: int,
    voxel_map: VoxelMap,
    poses: np.ndarray,
    radius: float,
    map_planes: Array1[Any] | None = None,
) -> np.ndarray:
    """Cost changes of a scan from its pose (the first) to others, (k, 4) as of `compare_costs`. One sync.
    `max_points`: approximate points used; `radius` [m] of plane neighborhoods, planes are searched twice as far.
    `map_planes`: planes around all map points, if they are known.
    """
    probes = ScanProbes(points, max_points, voxel_map, poses, radius)
    if map_planes is not None:
        probes.map_planes = map_planes
    launch(find_squares_kernel, probes.runs, [0, probes])
    launch(find_squares_kernel, (len(poses) - 1) * probes.runs, [1, probes])
    return probes.cost_changes()


@kernel
def mark_unmatched_kernel(
    points: array(dtype=vec3), pose: mat44d, limit: float, voxel_map: VoxelMap, marks: array(dtype=uint8)
):
    i = tid()
    x = rotate(pose, widen(points[i])) + vec3d(pose[0, 3], pose[1, 3], pose[2, 3])
    nearest_point = find_nearest_in_map(x, limit, voxel_map)
    marks[i] = uint8(1)
    if nearest_point[4] >= 0.0:
        marks[i] = uint8(0)


def unmatched_by_range(
    points: Points, voxel_map: VoxelMap, pose: np.ndarray, distance: float
) -> tuple[float, float, float]:
    """Fractions of the nearer and of the farther half of a scan without a map point within `distance` [m], and the
    mean squared range [m^2] of the farther half. One sync.
    """
    marks = empty(points.size, uint8, points.device)
    limit = np.float32(distance) ** 2
    launch(mark_unmatched_kernel, points.size, [points, mat44d(*pose.ravel().tolist()), limit, voxel_map, marks])
    is_unmatched, positions = download(marks).astype(bool), download(points).astype(np.float64)
    squares = (positions * positions).sum(axis=1)
    near, far = np.array_split(np.argsort(squares, kind="stable"), 2)
    nearer, farther = (float(is_unmatched[half].mean()) if half.size else 0.0 for half in (near, far))
    return nearer, farther, float(squares[far].mean()) if far.size else 0.0
